"""Branches of periodic orbits over one parameter, and what happens along them.

============  ==============================================================
`branch`      `continue_orbit`, and `Branch`: the points, and what is asked of them
`event`       what happens at one point of a branch
`curve`       what a family of orbits has to tell to be followed
`derived`     orbits whose equations have kernels as such a family
`composed`    composed orbits as such a family
`waves`       boundary functions along the phases of many points at once
`phases`      those of a composed orbit, and conditions of transitions
`monitors`    numbers whose sign changes where something happens
`matrices`    exponentials and eigenvalues of many small matrices
`stepping`    pseudo-arclength steps: predictor, corrector, step length
`locating`    events between two points of a branch, to full precision
`beyond`      itineraries on the other side of a border collision
`plane`       a point of a kind, followed in two parameters
`amplitudes`  how far a state swings: frequency responses and backbones
`saved`       branches in files
`drawing`     pictures of branches
============  ==============================================================
"""
