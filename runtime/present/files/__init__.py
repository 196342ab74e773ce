"""Results in files: written with every digit, refused when they are cut, edited or foreign.

====================  ========================================================================
`orbits`              orbits, as JSON with every digit
`motions`             simulated motions, as .npz or .csv
`box_certificates`    proven maps
`branches`            branches
`censuses`            censuses
`certificates`        certificates of one orbit
`certified_branches`  certified branches
`certified_cascades`  certified cascades of doublings
`basin_certificates`  certificates of basins
`graph_certificates`  certificates of graphs of boxes
`grid_entries`        grids of boxes, and what is said of each box
`chaos_certificates`  certificates of chaos
`claim_entries`       entries that the files of all proofs share
`declared_table`      the table of an orbit without kernels, as a declaration would have it
`declaring`           found orbits as named itineraries in the file that declares their system
`designs`             designs, with the orbits where they begin and end
`event_certificates`  certificates of events
`fits`                fits of parameters to measurements
`found`               orbits that were found
`kernel_orbits`       orbits with kernels: what was given and solved for
`loading`             any of them, by what a file says it holds
`loci`                curves of events
`named_entries`       orbits in files as orbits that every command takes by name
`orbit_numbers`       numbers of orbits as texts
`sweeps`              bifurcation diagrams and basins
`table_orbits`        orbits without kernels, as the others
====================  ========================================================================
"""
