"""Orbits and itineraries as documents see them, before they are written.

===========  ==============================================================
`view`       an orbit: its equations, how they are written, their numbers
`cycle`      an itinerary: the section at its start, transitions once each
`monodromy`  saltation matrices, and the trace of their product
===========  ==============================================================
"""
