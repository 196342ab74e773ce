"""Charts of the parameter plane: computed chunk by chunk, kept in a store, resumed.

================  ==============================================================
`grid`            axes, how a grid is cut into chunks, and its anchors
`anchors`         orbits from those near by: anchor to anchor, then the points between
`derived`         orbits whose equations are derived, at many points
`composed`        orbits that are composed from their phases, at many points
`phases`          which limit of admissibility such an orbit fails first
`orbits`          what is charted of an orbit: existence, admissibility, stability
`attractors`      what is charted by brute force: where motions settle
`problem`         what both kinds of chart have in common
`store`           the chunks in files: checked, purged, written
`lock`            one process at a time
`threads`         chunks in threads of this machine
`cluster`         chunks on a Dask cluster
`chart`           the whole: what is missing is computed, the chart is opened
`classes`         the parts of a chart for people: stable, unstable, none
================  ==============================================================
"""
