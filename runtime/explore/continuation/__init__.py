"""Branches of periodic orbits over one parameter, and what happens along them.

==================  =====================================================================
`continue_orbit`    `continue_orbit`: the branch of an orbit, its events and ends
`branch`            `Branch`: the points, and what is asked of them
`event_kinds`       the kinds of events, with their test functions
`event`             what happens at one point of a branch
`monitors`          numbers along a branch whose sign changes where something happens
`continue_event`    `continue_event`: an event followed in two parameters
`locus`             `Locus`: the curve of an event in two parameters
`amplitudes`        how far a state swings along a periodic orbit
`between_points`    a branch between its points: interpolated, or exact
`composed_family`   orbits with kernels at all physical parameters of their system
`energy`            the energy of an undamped orbit, from the numbers of its system alone
`family_of_orbit`   the family of an orbit, and the interval over which it is followed
`kernel_family`     orbits with kernels as a family
`locating`          events between two points of a branch, to full precision
`next_itineraries`  the itineraries on the other side of a border collision
`orbit_family`      what a family of orbits has to tell to be followed over one parameter
`phase_functions`   boundary functions and conditions along orbits without kernels
`response`          frequency responses and backbones: what a branch is drawn as
`stepping`          pseudo-arclength steps: predictor, corrector, step length
`switching`         the other branch at a flip, a lost symmetry, a crossing
`table_family`      orbits without kernels as a family
==================  =====================================================================
"""
