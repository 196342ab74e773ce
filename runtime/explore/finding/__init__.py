"""The periodic orbits that live in a system, and their basins.

=============  ===================================================================================
`find`         `find_orbits`: attractors by simulation, others by Newton's method
`sweep`        `sweep`: attractors over a parameter
`basins`       `basins`: attractors over a plane of starts
`found`        `Found`: what was found to live in a system
`settled`      what motions settle on, one at each of many parameter points, for charts and sweeps
`outcomes`     where motions lead, each by its name
`escape`       motions followed on until it is decided whether they escape
`mirrors`      symmetries of a system, found from its tables
`neighbours`   short cycles of the transitions that were seen, as guesses
`primitive`    candidates solved as periodic orbits, over their primitive period and each once
`steady`       equilibria, and what a forcing makes of one configuration
`stretching`   how fast neighbouring motions part
`stroboscope`  motions that come back with the forcing, as a stroboscope sees them
=============  ===================================================================================
"""
