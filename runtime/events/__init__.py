"""When a phase reaches a boundary, and what follows there.

====================  =================================================================
`boundary_functions`  values, ends and interior maxima along the phases of many points
`first_crossing`      first crossings of zero that no step can jump over
`transition_choice`   what follows an event for which no transition is listed
`phase_numbers`       the numbers of one phase, and the clock, for the engine in Python
`trigonometric_sums`  guaranteed maxima and first crossings of trigonometric sums
====================  =================================================================
"""
