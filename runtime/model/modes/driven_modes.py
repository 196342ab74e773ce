"""Modes of a structure that is driven by states which move by themselves.

A forcing, a coordinate that is held, constants: these states z move without the others,
z' = F z, and the rest is x' = A x + G z. Each function t^k e^(nu t) of z, with the matrix T_k,
has a response of the same form,

    Y_k = (nu - A)^-1 (G T_k - (k + 1) Y_(k+1)),        x(t) = e^(A t) (x_0 - Y_0 z_0) + Y(t) z_0,

so that equal eigenvalues of F, as of held coordinates and constants, are no matter of A, whose
eigenvalues are found once for all frequencies of a forcing.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from nonsmooth.runtime.model.modes.natural_units import dependence
from nonsmooth.runtime.model.modes.simple_modes import ModeGroup, is_moderate, simple_modes
from nonsmooth.runtime.model.structure import mode_shapes

_RESONANCE = 1e-6  # of the largest eigenvalue: nearer to it a response is not told well


def driven_modes(
    fields: np.ndarray, modes_of: Callable[[np.ndarray], list[ModeGroup]]
) -> list[ModeGroup]:
    """Modes of motions y' = A y + b from those of their driving states and of what these drive.

    `fields` (n, N, N + 1) are A, then b, and finite; `modes_of` gives the modes of the driving
    states' own fields. Motions are left out in which no state drives others, if the driving
    states' modes are chains, and if double precision does not determine the modes of the rest or
    their response.
    """
    count, _, columns = fields.shape
    whole = np.concatenate([fields, np.zeros((count, 1, columns))], axis=1)
    depends = dependence(whole).reshape(count, -1)
    alike = (depends == depends[:1]).all()
    groups = []
    for pattern in depends[:1] if alike else np.unique(depends, axis=0):
        places = np.flatnonzero((depends == pattern).all(axis=1))
        for group in _alike(whole[places], pattern.reshape(columns, columns), modes_of):
            small = np.flatnonzero(is_moderate(group.flows[0], fields[places[group.places]]))
            if len(small):
                found = (group.exponents[small], (group.flows[0][small],))
                groups.append(ModeGroup(places[group.places[small]], group.shapes, *found))
    return groups


def _alike(
    whole: np.ndarray, depends: np.ndarray, modes_of: Callable[[np.ndarray], list[ModeGroup]]
) -> Iterator[ModeGroup]:
    """Modes of motions with one `dependence` (N + 1, N + 1), of matrices (n, N + 1, N + 1)."""
    together = depends & depends.T
    drives = (depends & ~together).any(axis=0)
    # states that depend on each other, and on which no others depend
    driven = ~drives & (together.sum(axis=1) > 1)
    rest, drivers = np.flatnonzero(driven), np.flatnonzero(~driven)  # the last one is the 1
    if not len(rest) or len(drivers) < 2:
        return
    matrices, loads, forcing = (
        np.ascontiguousarray(whole[:, rows[:, None], columns])
        for rows, columns in ((rest, rest), (rest, drivers), (drivers[:-1], drivers))
    )
    unloaded = np.zeros((len(whole), len(rest), 1))
    for free in simple_modes(np.concatenate([matrices, unloaded], axis=-1)):
        for own in modes_of(forcing[free.places]):
            if any(shape.joined or shape.paired for shape in own.shapes):
                continue
            poles, ends = own.exponents @ (1, 1j), free.exponents[own.places, 1:]
            distances = np.abs(poles[:, :, None] - (ends @ (1, 1j))[:, None]).min(axis=(1, 2))
            far = np.flatnonzero(distances > _RESONANCE * np.abs(ends).max(axis=(1, 2)))
            if not len(far):
                continue
            at = own.places[far]
            places = free.places[at]
            parts = (own.flows[0][far], free.flows[0][at, 1:], poles[far])
            try:
                terms = _terms(matrices[places], loads[places], *parts, own, rest, drivers)
            except np.linalg.LinAlgError:  # of one of them; each is tried by itself
                continue
            shapes = mode_shapes((s.length, s.oscillates) for s in (*own.shapes, *free.shapes[1:]))
            exponents = np.concatenate([own.exponents[far], ends[far]], axis=1)
            found = np.where(depends, terms, 0.0)[:, :, :-1]
            yield ModeGroup(places, shapes, exponents, (found,))


def _terms(
    matrices: np.ndarray,
    loads: np.ndarray,
    driving: np.ndarray,
    flows: np.ndarray,
    poles: np.ndarray,
    own: ModeGroup,
    rest: np.ndarray,
    drivers: np.ndarray,
) -> np.ndarray:
    """Matrices (n, functions, N + 1, N + 1) of motions x' = A x + G z, from those of z and of A.

    `matrices` (n, r, r) are A, `loads` (n, r, d) are G; `driving` (n, f, d - 1, d) and `poles`
    (n, modes) are those of z, whose shapes are those of `own`; `flows` (n, g, r, r + 1) are those
    of A. `rest` and `drivers` are the places of x and of z.
    """
    count, size, whole = len(rest), len(drivers), len(rest) + len(drivers)
    terms = np.zeros((len(loads), driving.shape[1] + flows.shape[1], whole, whole))
    moved = np.zeros((*driving.shape[:2], size, size))
    moved[:, :, :-1], moved[:, 0, -1, -1] = driving, 1.0
    start = np.zeros((len(loads), count, size))
    for pole, shape in zip(poles.T[..., None, None], own.shapes, strict=True):
        following = np.zeros_like(loads, dtype=complex)
        for k in reversed(range(shape.length)):
            turns = 1 + shape.oscillates
            places = shape.places[turns * k : turns * (k + 1)]
            term = moved[:, places[0]] - (1j * moved[:, places[1]] if shape.oscillates else 0.0)
            following = np.linalg.solve(
                pole * np.eye(count) - matrices, loads @ term - (k + 1) * following
            )
            for place, part in zip(places, (following.real, -following.imag), strict=False):
                terms[:, place, rest[:, None], drivers] = part
                terms[:, place, drivers[:, None], drivers] = moved[:, place]
        start += following.real
    for place in range(flows.shape[1]):
        flow, there = flows[:, place, :, :-1], driving.shape[1] + place
        terms[:, there, rest[:, None], rest] = flow
        terms[:, there, rest[:, None], drivers] = -flow @ start
    return terms
