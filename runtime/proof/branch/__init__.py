"""Proofs of whole branches: tiles that follow each other, and every event between them."""
