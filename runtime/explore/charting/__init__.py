"""Charts of the parameter plane: computed chunk by chunk, kept in a store, resumed.

===============  ===============================================================================
`chart`          `chart`: what is missing is computed, then the chart is opened
`grid`           a grid of parameter points, how it is cut into chunks, and its anchors
`problem`        what the kinds of chart share, and what tells two charts apart
`orbits`         what is charted of an orbit: existence, admissibility and its limits, stability
`attractors`     what is charted by brute force: where the motions from one start settle
`basins`         to which of the orbits that were found the starts of a plane lead
`store`          a chart in files: a Zarr group whose chunks carry a CRC
`bounded_store`  reading its objects: none that claims to be larger than a chunk is read
`anchors`        orbits from those near by: anchors first, then the points between
`classes`        the parts of a chart for people: stable, unstable, what fails, basins
`cluster`        chunks on a Dask cluster
`lock`           one process at a time
`threads`        chunks in threads of this machine, or one after the other into memory
===============  ===============================================================================
"""
