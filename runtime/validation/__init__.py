"""Simulation in ball arithmetic: the sequence of configurations, proved.

================  ============================================================
`enclosures`      a system in balls, and what is known exactly of a state
`first_crossing`  the first crossing of one phase, proved
`validate`        the motion: `validate`
`proof`           what is proved of it
================  ============================================================
"""
