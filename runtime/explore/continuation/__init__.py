"""Branches of periodic orbits over one parameter, and what happens along them."""
