"""Numerics: everything that runs on the generated kernels, without any symbolic algebra.

The map of the house:

=============  ================================================================
`kernels`      the one door to the generated kernels: compiled or NumPy
`values`       exact parameter values and decimal printing
`arithmetic`   one set of functions for floats, mpmath and balls
`parameters`   from what a user gives to a parameter point
`newton`       Newton's method: reduced and batched, or full and exchanged
`orbit`        the record of a periodic orbit, with its sensitivities
`solve`        one orbit at one parameter point
`batch`        many parameter points at once, in threads
`refine`       an orbit to any number of digits
`stability`    Poincaré map, multipliers, the trace criterion
`admissible`   whether an orbit is a motion of the real system
`crossing`     maxima and first crossings of boundary functions, guaranteed
`intervals`    along one parameter: where an orbit is admissible, or singular
`motion`       an orbit's states at any time
`plot`         pictures: figures, Axes, files
`panels`       what is drawn into one Axes
`reproduce`    the source paper again: every number and figure
`notebook`     tables and formulas
`saved`        orbits in files
`report`       results as JSON
`display`      results for people
`deriving`     the commands' way into the derivation
`options`      arguments and options that commands share
`cli`          the command line
`errors`       the exceptions, under one root
=============  ================================================================
"""
