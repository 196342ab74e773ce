"""Pictures of orbits, motions, branches, charts and proven maps, by matplotlib.

===============  =======================================================
`drawing`        what all pictures share: colours, dashes, legends, axes
`plot`           orbits: figures, Axes, files
`panels`         what is drawn of an orbit into one Axes
`scenes`         simulated motions
`motion_panels`  what is drawn of a motion into one Axes
`branches`       branches, and curves of events in the plane
`charts`         charts of the parameter plane
`found`          orbits that were found, a row for each
`maps`           basins of attraction and bifurcation diagrams
`proven_maps`    proven maps: tiles of a plane or of a line
`saved_files`    whatever is in a file
===============  =======================================================
"""
