"""Numerics: everything that runs on the generated kernels, without any symbolic algebra.

The map of the house:

==================  ================================================================
`kernels`           the one door to the generated kernels: compiled or NumPy
`values`            exact parameter values and decimal printing
`arithmetic`        one set of functions for floats, mpmath and balls
`parameters`        from what a user gives to a parameter point
`newton`            Newton's method: reduced and batched, or full and exchanged
`orbit`             the record of a periodic orbit, with its sensitivities
`solve`             one orbit at one parameter point
`batch`             many parameter points at once, in threads
`refine`            an orbit to any number of digits
`stability`         Poincaré map, multipliers, the trace criterion
`admissible`        whether an orbit is a motion of the real system
`crossing`          maxima and first crossings of boundary functions, guaranteed
`intervals`         along one parameter: where an orbit is admissible, or singular
`motion`            an orbit's states at any time
`piecewise`         a system at a parameter point: rows, fields, flows, resets
`starting`          the configuration that a state belongs to
`simulate`          motions from event to event: `simulate`, `simulate_many`
`trajectory`        the record of a simulated motion
`run`, `engines`    what an engine gives; the compiled one (`engine/`, in C) and its arrays
`engine_layout`     a system packed for the compiled engine
`stepping`          the same rules in Python: the fallback, and the compiled engine's judge
`stepping_tables`   its numbers of a configuration, and its clock
`quasi`             quasi-polynomials with error bounds; `quasi_crossing`: their first crossing
`flows`             states inside a configuration, many at once
`validated`         the sequence of configurations, proved in balls (`proof`, `enclosures`,
                    `first_crossing`)
`composed`          periodic orbits of any itinerary, without kernels of its own (`composition`,
                    `composed_newton`, `composed_stability`, `composed_admissible`,
                    `composed_batch`, `composed_precise`)
`find`              the periodic orbits that live in a system (`recurrence`, `neighbours`)
`returns`           the Poincaré map by simulation
`sweep`             attractors over a parameter, or over a plane of starts
`plot`              pictures of orbits: figures, Axes, files
`panels`            what is drawn of an orbit into one Axes
`scenes`            pictures of simulated motions
`motion_panels`     what is drawn of a motion into one Axes
`maps`              pictures of many motions: basins, bifurcations
`drawing`           what all pictures share
`phases`            a simulated motion, phase by phase, in closed form
`extremes`          guaranteed peaks along a simulated motion
`observables`       peaks, averages, times in configurations, contact forces
`lyapunov`          derivatives of a motion by its start, Lyapunov exponents
`reproduce`         the source paper again: every number and figure
`notebook`          tables and formulas
`saved`             orbits in files
`saved_trajectory`  simulated motions in files
`report`            results as JSON; `report_motion`, `report_found`
`display`           results for people; `display_motion`
`files`             files that are written whole or not at all
`deriving`          the commands' way into the derivation
`options`           arguments and options that commands share
`cli`, `cli_motions`  the commands; `command`: what they share
`errors`            the exceptions, under one root
==================  ================================================================
"""
