"""Parameters at which an orbit is best, or has wanted values.

==================  ========================================================================
`design`            `design`: minimise, maximise or solve over parameters in bounds
`question`          `DesignQuestion`: what is asked for, read and checked
`optimum`           `Design`: what was found, which limits act there, and how it was reached
`condition`         `DesignCondition`: a quantity and what it has to be
`quantities`        values of quantities at an orbit, and their exact derivatives
`following`         the orbit at other parameters, on the same branch
`design_points`     orbits that a design has visited, in units of its bounds
`multiplier_pairs`  multipliers in pairs, which have derivatives where two meet
`aim`               what is made small, and the conditions, in an optimiser's variables
`largest`           quantities that are the largest of several, from above
`worst_over`        the worst along a branch made as small as it can be
`branch_points`     orbits of a branch where something is worst, at each trial
`scanning`          where along a branch what is asked for is worst
`alarms`            what can be worst: the quantity, the conditions, the margins
`optimising`        SciPy's constrained optimisers, along the branch
`around`            quantities along one parameter around the end
`solving`           as many parameters as conditions, by SciPy's least squares
`telling`           values, gradients, iterates and the message
`limits`            which conditions and bounds act at an optimum, and how strongly
==================  ========================================================================
"""
