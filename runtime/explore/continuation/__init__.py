"""Branches of periodic orbits over one parameter, and what happens along them.

=============  =============================================================
`branch`       `continue_orbit`: points, events and ends of a branch
`record`       `Branch`: the points, and what is asked of them
`event`        what happens at one point of a branch
`curve`        what a family of orbits has to tell to be followed
`family`       the family of an orbit, and the interval over which it is followed
`derived`      orbits whose equations have kernels as such a family
`composed`     composed orbits as such a family
`physical`     the former as the latter, at all parameters of their system
`waves`        boundary functions along the phases of many points at once
`phases`       those of a composed orbit, and conditions of transitions
`monitors`     numbers whose sign changes where something happens
`matrices`     exponentials and eigenvalues of many small matrices
`stepping`     pseudo-arclength steps: predictor, corrector, step length
`track`        a branch between its points, interpolated and exact
`locating`     events between two points of a branch, to full precision
`beyond`       itineraries on the other side of a border collision
`switching`    the other branch at a flip, a lost symmetry, a crossing
`plane`        `continue_event`: a point of a kind, followed in two parameters
`locus`        `Locus`: the curve of such points
`amplitudes`   how far a state swings: frequency responses and backbones
`energy`       the energy of conservative orbits
`saved`        branches in files
`saved_locus`  curves of events in files
`drawing`      pictures of both
=============  =============================================================
"""
