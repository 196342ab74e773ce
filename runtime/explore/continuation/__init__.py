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
`composed_family`   orbits of a branch by the tables of their system, at all of its parameters
`energy`            the energy of an undamped orbit, from the numbers of its system alone
`locating`          events between two points of a branch, to full precision
`next_itineraries`  the itineraries on the other side of a border collision
`orbit_family`      `OrbitFamily`: orbits over one parameter, and its interval
`response`          frequency responses and backbones: what a branch is drawn as
`stepping`          pseudo-arclength steps: predictor, corrector, step length
`switching`         the other branch at a flip, a lost symmetry, a crossing
==================  =====================================================================
"""
