"""Pictures, by matplotlib.

===============  ==============================================================
`drawing`        what all pictures share
`plot`           of orbits: figures, Axes, files
`panels`         what is drawn of an orbit into one Axes
`scenes`         of simulated motions
`motion_panels`  what is drawn of a motion into one Axes
`charts`         of the parameter plane
`maps`           of many motions: basins, bifurcation diagrams
===============  ==============================================================
"""
