"""When a phase reaches a boundary, and what follows there.

====================  =================================================================
`boundary_functions`  values, ends and interior maxima along the phases of many points
`first_crossing`      first crossings of zero that no step can jump over
`leading_derivative`  the first derivative that is not zero, and its sign
`transition_choice`   what follows an event for which no transition is listed
`contact_choice`      the choice of the contact law at a state
`phase_numbers`       the numbers of one phase, and the clock, for the engine in Python
`guaranteed_maxima`   the search for maxima that leaves none out
`linear_motions`      guaranteed maxima along damped and forced motions
`trigonometric_sums`  guaranteed maxima and first crossings of trigonometric sums
====================  =================================================================
"""
