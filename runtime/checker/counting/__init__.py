"""How many orbits there are in a box of dwell times."""
