"""Orbits over ranges of parameters: tiles of boxes and of branches, what begins and ends there."""
