"""The equations of a periodic orbit: a cycle of phases, its linearisation, Newton's method.

========================  ==========================================================================
`shooting_map`            itineraries of a system, and their shooting map in arrays
`variational`             the shooting map of a chain and its variational, in any arithmetic
`derivatives`             that map with its derivatives by dwell times, start and a parameter
`newton`                  Newton's method over a batch of points, or towards any number of digits
`kernel_newton`           that on derived equations: reduced and batched, or full
`table_newton`            that on the start and the dwell times of an itinerary, in batches
`fitting_start`           the start that fits given dwell times best
`section_map`             the Poincare map of an orbit: sections, multipliers, what they mean
`multipliers`             the eigenvalues of a Poincare map's Jacobian
`multiplier_derivatives`  how they change with parameters
`closure_conditions`      that a cycle returns, and what its forcings ask
`symmetry`                signed permutations of the states that map motions to motions
`symmetric_orbit`         orbits that a symmetry maps to themselves: a part and the whole
`translations`            directions of the state that nothing depends on
========================  ==========================================================================
"""
