"""Modes of a structure that is driven by states which move by themselves.

A forcing, a coordinate that is held, constants: these states z move without the others,
z' = F z, and the rest is x' = A x + G z. Each function t^k e^(nu t) of z, with the matrix T_k,
has a response of the same form,

    Y_k = (nu - A)^-1 (G T_k - (k + 1) Y_(k+1)),        x(t) = e^(A t) (x_0 - Y_0 z_0) + Y(t) z_0,

so that equal eigenvalues of F, as of held coordinates and constants, are no matter of A, whose
eigenvalues are found once for all frequencies of a forcing.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from nonsmooth.runtime.model.factored_flows import matrices_of
from nonsmooth.runtime.model.modes.natural_units import dependence
from nonsmooth.runtime.model.modes.simple_modes import NumericModes, is_moderate, simple_modes
from nonsmooth.runtime.model.structure import mode_shapes

_RESONANCE = 1e-6  # of the largest eigenvalue: nearer to it a response is not told well


def driven_modes(
    field: np.ndarray, modes_of: Callable[[np.ndarray], NumericModes]
) -> NumericModes | None:
    """Modes of y' = A y + b from those of its driving states and of the states they drive.

    `field` (N, N + 1) is A, then b, and finite; `modes_of` gives the modes of the driving
    states' own field. None if no state drives others, if the driving states' modes are chains, or
    if double precision does not determine the modes of the rest or their response.
    """
    size = len(field)
    whole = np.vstack([field, np.zeros(size + 1)])
    depends = dependence(whole[None])[0]
    together = depends & depends.T
    drives = (depends & ~together).any(axis=0)
    # states that depend on each other, and on which no others depend
    driven = ~drives & (together.sum(axis=1) > 1)
    rest, drivers = np.flatnonzero(driven), np.flatnonzero(~driven)  # the last one is the 1
    if not len(rest) or len(drivers) < 2:
        return None
    matrix, load = whole[np.ix_(rest, rest)], whole[np.ix_(rest, drivers)]
    structure = simple_modes(np.hstack([matrix, np.zeros((len(rest), 1))])[None])
    if not structure:
        return None
    free, own = structure[0], modes_of(whole[np.ix_(drivers[:-1], drivers)])
    if any(shape.joined or shape.paired for shape in own.shapes):
        return None
    poles = own.exponents @ (1, 1j)
    distances = np.abs(poles[:, None] - free.exponents[0][1:] @ (1, 1j))
    if distances.min() <= _RESONANCE * np.abs(free.exponents).max():
        return None
    driving, flows = matrices_of(own.flows), free.flows[0][0, 1:]
    terms = np.zeros((len(driving) + len(flows), size + 1, size + 1))
    moved = np.zeros((len(driving), len(drivers), len(drivers)))
    moved[:, :-1], moved[0, -1, -1] = driving, 1.0
    start = np.zeros((len(rest), len(drivers)))
    for pole, shape in zip(poles.tolist(), own.shapes, strict=True):
        following = np.zeros_like(load, dtype=complex)
        for k in reversed(range(shape.length)):
            turns = 1 + shape.oscillates
            places = shape.places[turns * k : turns * (k + 1)]
            term = moved[places[0]] - (1j * moved[places[1]] if shape.oscillates else 0.0)
            following = np.linalg.solve(
                pole * np.eye(len(rest)) - matrix, load @ term - (k + 1) * following
            )
            parts = (following.real, -following.imag)
            for place, part in zip(places, parts, strict=False):
                terms[place][np.ix_(rest, drivers)] = part
                terms[place][np.ix_(drivers, drivers)] = moved[place]
        start += following.real
    for place, flow in enumerate(flows[:, :, :-1], len(moved)):
        terms[place][np.ix_(rest, rest)] = flow
        terms[place][np.ix_(rest, drivers)] = -flow @ start
    found = np.where(depends, terms, 0.0)[:, :size]
    if not is_moderate(found, field):
        return None
    shapes = mode_shapes((s.length, s.oscillates) for s in (*own.shapes, *free.shapes[1:]))
    exponents = np.concatenate([own.exponents, free.exponents[0][1:]])
    return NumericModes(shapes, exponents, found)
