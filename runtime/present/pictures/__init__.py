"""Pictures of orbits, motions, branches, charts and proven maps, by matplotlib.

====================  =================================================================
`drawing`             what all pictures share: colours, dashes, legends, axes
`plot`                orbits: figures, Axes, files
`panels`              what is drawn of an orbit into one Axes
`scenes`              simulated motions
`motion_panels`       what is drawn of a motion into one Axes
`branches`            branches, and curves of events in the plane
`certified_basins`    basins that are proved
`certified_branches`  certified branches: intervals in colours, events marked
`certified_cascades`  certified cascades: each doubled branch beside its flip
`charts`              charts of the parameter plane
`designs`             designs: iterates, and quantities along each parameter
`fits`                measurements over a fitted motion, and what is left
`found`               orbits that were found, a row for each
`maps`                basins of attraction and bifurcation diagrams
`horseshoes`          sets that cover each other, and their graph
`box_graphs`          boxes where motions recur, trapping regions, Morse graphs
`proven_maps`         proven maps: tiles of a plane or of a line
`saved_files`         whatever is in a file
`kinds`               kinds of pictures of an orbit or a motion: a new one is one entry
`layout`              Axes that are given, or of a new figure
`view`                points, labels and times that every picture of a motion needs
====================  =================================================================
"""
