"""The equations of a periodic orbit: a cycle of phases, its linearisation, Newton's method.

====================  ============================================================================
`shooting_map`        itineraries of a system, and their shooting map in arrays
`variational`         the shooting map of a chain of phases and its variational, in any arithmetic
`newton`              Newton's method on derived equations: reduced and batched, or full
`cycle_newton`        Newton's method on the start and the dwell times of a cycle, in batches
`section_map`         the Poincare map of an orbit: sections, multipliers, what they mean
`multipliers`         the eigenvalues of a Poincare map's Jacobian
`closure_conditions`  that a cycle returns, and what its forcings ask
`symmetry`            signed permutations of the states that map motions to motions
`translations`        directions of the state that nothing depends on
====================  ============================================================================
"""
