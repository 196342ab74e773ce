"""The periodic orbits that live in a system, and their basins.

============  ==============================================================
`recurrence`  motions that come back, or nearly
`neighbours`  short cycles of the transitions that were seen
`find`        `find_orbits`: attractors by simulation, others by Newton
`sweep`       attractors over a parameter, or over a plane of starts
`saved`       found orbits as JSON and in files
`saved_sweep` sweeps in files
============  ==============================================================
"""
