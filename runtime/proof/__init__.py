"""Theorems about periodic orbits and motions, proved in ball arithmetic."""
