"""Numerics: everything that runs on the generated kernels, without any symbolic algebra.

The map of the house:

================  ==============================================================
`kernels`         the one door to the generated kernels: compiled or NumPy
`kernel_records`  their tables, of a system and of an orbit
`vectorised`      kernels on NumPy arrays
`values`          exact parameter values and decimal printing
`arithmetic`      one set of functions for floats, mpmath and balls
`parameters`      from what a user gives to a parameter point
`newton`          Newton's method: reduced and batched, or full and exchanged
`orbit`           the record of a periodic orbit, with its sensitivities
`solve`           one orbit at one parameter point
`batch`           many parameter points at once, in threads
`refine`          an orbit to any number of digits
`stability`       Poincaré map, multipliers, the trace criterion
`admissible`      whether an orbit is a motion of the real system
`crossing`        maxima and first crossings of trigonometric sums, guaranteed
`intervals`       along one parameter: where an orbit is admissible, or singular
`motion`          an orbit's states at any time
`saved`           orbits in files
`form`            what other files of results have in common
`report`          orbits as JSON
`notebook`        tables and formulas
`files`           files that are written whole or not at all
`errors`          the exceptions, under one root
`cli`             the command line
================  ==============================================================

and the rooms, each with a map of its own:

================  ==============================================================
`loading`         systems that users declare: files, folders, Python
`simulation`      exact motions from event to event; the engine in C is `engine/`
`observing`       peaks, averages, contact forces, Lyapunov exponents
`composition`     periodic orbits of itineraries that have no kernels
`continuation`    branches of orbits over a parameter, and what happens along them
`finding`         the periodic orbits that live in a system, and their basins
`charting`        charts of the parameter plane: chunked, resumed, on a cluster
`validation`      the sequence of configurations of a motion, proved in balls
`certification`   certificates of periodic orbits, and the sceptic's checker
`pictures`        pictures of orbits, motions, basins
`reproduce`       the source paper again: every number and figure
`commands`        what the command line takes and shows
================  ==============================================================
"""
