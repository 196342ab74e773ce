"""From an itinerary to the equations of its orbit, and all that is derived from them.

==================  =============================================================
`program`           stages of assignments and their derivatives
`section`           how phases are left, and the affine set on which an orbit starts
`chain`             the states of an orbit: start, phases, transitions
`linearisation`     how a perturbation passes along the chain, by phases and transitions
`energy`            the first integral of a conservative orbit
`symmetry`          orbits that a reversor maps to themselves
`forcing`           the harmonic forcings of an orbit, their common period and phase
`explicit`          dwell times in closed form
`reduction`         elimination of what is linear or explicit; the map in one variable
`elimination`       equations that are affine in the start, solved for it
`reference`         a known orbit in numbers, from a guess that may leave out its start
`period_map`        the map of a whole turn, and the start that follows from the dwell times
`shown_conditions`  whether the phases show where the transitions lead
`equation_system`   EquationSystem, the frozen record handed to every emitter
`derivation`        the pipeline: all of these in order
==================  =============================================================
"""
