"""Exact simulation from event to event.

===============  ==============================================================
`structure`      a system apart from its parameters
`piecewise`      a system at a parameter point: rows, fields, flows, resets
`modes`          flows that have no closed form, from eigenvalues and their clusters
`exponential`    the same to any number of digits
`flows`          states inside a configuration, many at once
`starting`       a start by names, and the configuration that it belongs to
`run`            what an engine gives, and why it ended
`engines`        the compiled engine (`runtime/engine/`, in C) and its arrays
`engine_layout`  a system packed for it
`stepping`       the same rules in Python: the fallback, and the engine's judge
`tables`         its numbers of a configuration, and its clock
`functions`      functions of time of modes, and of chains of modes that nearly meet
`quasi`          quasi-polynomials with error bounds
`crossing`       their first crossing, guaranteed
`simulate`       one motion, or many in threads
`trajectory`     the record of a motion: its state at any time
`saved`          motions in files
`returns`        the Poincaré map by simulation
===============  ==============================================================
"""
