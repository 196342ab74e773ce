"""Many orbits: branches and charts over parameters, and all that live in a system.

==============  =================================================================================
`continuation`  branches of periodic orbits over one parameter, and what happens along them
`charting`      charts of the parameter plane: computed chunk by chunk, kept in a store, resumed
`design`        parameters at which an orbit is best, or has wanted values
`fitting`       parameters of a system from what was measured of its motions
`finding`       the periodic orbits that live in a system, and their basins
`intervals`     along one parameter: where an orbit is admissible, and where it is not determined
==============  =================================================================================
"""
