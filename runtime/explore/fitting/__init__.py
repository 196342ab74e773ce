"""Parameters of a system from what was measured of its motions."""
