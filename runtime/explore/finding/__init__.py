"""The periodic orbits that live in a system, and their basins.

============  ==============================================================
`recurrence`  motions that come back, or nearly
`neighbours`  short cycles of the transitions that were seen
`primitive`   candidates solved as orbits, over their primitive period, each once
`steady`      equilibria, and what a forcing makes of one configuration
`stretching`  how fast neighbouring motions part
`escape`      motions followed on, and whether they grow without bound
`stroboscope` motions that come back with the forcing
`mirrors`     symmetries of a system, found from its tables
`outcomes`    where motions lead, each by its name
`find`        `find_orbits`: attractors by simulation, others by Newton
`settled`     the same for one motion at each of many parameter points
`sweep`       attractors over a parameter, or over a plane of starts
`saved`       found orbits as JSON and in files
`saved_sweep` sweeps in files
============  ==============================================================
"""
