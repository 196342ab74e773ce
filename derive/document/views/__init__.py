"""Orbits and itineraries as documents see them, before they are written.

================  ==============================================================
`view`            an orbit: its equations, how they are written, their numbers
`cycle`           an itinerary: the section at its start, transitions once each
`centres`         centres of configurations, with letters of their own
`motions`         closed forms of motions: displacements, modes, steady parts
`monodromy`       saltation matrices, and the trace of their product
`explicit_start`  the start in functions of the dwell times
================  ==============================================================
"""
