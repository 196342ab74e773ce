"""From an itinerary to the equations of its orbit, and all that is derived from them.

=================  ==============================================================
`program`          stages of assignments and their derivatives
`section`          the affine set on which an orbit starts
`chain`            start, phases, transitions; sensitivities and Poincare map along them
`saltation`        how a perturbation passes a transition
`energy`           the first integral of a conservative orbit
`symmetry`         orbits that a reversor maps to themselves
`explicit`         dwell times in closed form
`reduction`        elimination of what is linear or explicit; the map in one variable
`elimination`      equations that are affine in the start, solved for it
`affine`           switching and closure, affine in the start given the dwell times
`forcing`          the harmonic forcings of an orbit, their common period and phase
`forced`           the reduction of a forced orbit
`guess`            the start that a reference leaves out, from its dwell times
`equation_system`  EquationSystem, the frozen record handed to every emitter
`derivation`       the pipeline: all of these in order
=================  ==============================================================
"""
