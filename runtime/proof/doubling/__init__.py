"""Proofs beyond a flip: the orbits of twice the period."""
