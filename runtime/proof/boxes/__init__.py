"""Proofs for all parameters of a box."""
