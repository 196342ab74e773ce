"""Branches of orbits proved, tile by tile, their events, and what is beyond a flip."""
