"""Simulation in ball arithmetic: the sequence of configurations of a motion, proved."""
