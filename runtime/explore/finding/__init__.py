"""The periodic orbits that live in a system, and their basins."""
