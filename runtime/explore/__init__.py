"""Many orbits: branches and charts over parameters, and all that live in a system."""
