"""Chaos, proved: covering relations of sets on a section, and symbolic dynamics from them."""
