"""Numerics: everything that runs on the generated kernels, without any symbolic algebra.

The map of the house:

=============  ================================================================
`kernels`      the one door to the generated kernels: compiled or NumPy
`values`       exact parameter values and decimal printing
`arithmetic`   one set of functions for floats, mpmath and balls
`orbit`        the record of a periodic orbit, with its sensitivities
`solve`        one orbit at one parameter point
`batch`        many parameter points at once, in threads
`refine`       an orbit to any number of digits
`verify`       the trace criterion at any number of digits
`stability`    Poincaré map, multipliers and trace
`admissible`   whether an orbit is a motion of the real system
`crossing`     the first crossing of a boundary, guaranteed
`errors`       the exceptions, under one root
`report`       results as text and JSON
`cli`          the command line
=============  ================================================================
"""
