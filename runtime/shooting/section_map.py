"""The Poincare map of a composed orbit: sections, multipliers and what they mean.

Behind a transition a motion lies on a section that may have fewer dimensions than the states
less one: a velocity that a reset has set stays what it is. The map from the smallest of the
sections to itself has no multiplier that is zero for this reason; the others are exactly zero.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from itertools import accumulate
from typing import Any

import numpy as np

from nonsmooth.runtime.shooting.multipliers import (
    Stability,
    eigenvalues_of,
    orthonormal,
    stability_of,
)
from nonsmooth.runtime.shooting.newton import LEAST
from nonsmooth.runtime.shooting.shooting_map import (
    ItineraryShape,
    Numbers,
    Phase,
    Shooting,
    applied,
    phases_in,
)
from nonsmooth.runtime.shooting.table_newton import sizes
from nonsmooth.runtime.shooting.translations import projection_along


def section_map(phase: Phase, flow: Any, velocity: Any, behind: Any = None) -> Any:
    """Derivative (..., N, N) of the state behind a phase's reset by that at its start.

    With the flow's matrix Phi, the reset's R, the gradient n of the boundary, and the
    velocities f- in front and f+ behind it is R (Phi - f- n Phi / n f-) between sections, and
    R Phi + (f+ - R f-) n Phi / n f- at fixed times: the saltation matrix times Phi (M. Aizerman
    and F. Gantmakher, 1958). `velocity` is f-, and `behind` is f+; without it the map is that
    between sections.
    """
    linear, normal, reset = (part[..., :-1] for part in (flow, phase.row, phase.reset))
    later = normal @ linear / (normal @ velocity)
    if behind is None:
        return reset @ (linear - velocity * later)
    return reset @ linear + (behind - reset @ velocity) * later


def local_maps(cycle: ItineraryShape, numbers: Numbers, now: Shooting) -> list[Any]:
    """Derivative (N, N) of the state behind each phase's reset by that at the phase's start.

    Both are on sections, where phases start; `now` is of the orbit as it closes.
    """
    parts = zip(phases_in(cycle, numbers), now.flows, now.velocities[..., None], strict=True)
    return [section_map(*part) for part in parts]


@np.errstate(all="ignore")
def saltations(cycle: ItineraryShape, numbers: Numbers, now: Shooting) -> Any:
    """Saltation matrix of each transition (p, N, N): R + (f_after - R f_before) n / (n f_before).

    It maps a perturbation in front of the transition to the one behind it, to first order and at
    the same time; `now` is of the orbit as it closes. The correction at a switch is that of
    Aizerman and Gantmakher (1958); Müller (1995) takes it to Lyapunov exponents.
    """
    size = now.starts.shape[-1]
    unit = np.eye(size, size + 1, dtype=int)
    return np.array(_timed(cycle, numbers, now, [unit] * len(cycle)))


def _timed(
    cycle: ItineraryShape, numbers: Numbers, now: Shooting, flows: Sequence[Any]
) -> list[Any]:
    """Derivatives, at fixed times, of states behind transitions by those before the flows."""
    phases = phases_in(cycle, numbers)
    fields = [phase.field for phase in (*phases[1:], phases[0])]
    behind = map(applied, fields, now.starts[1:, ..., None])
    parts = zip(phases, flows, now.velocities[..., None], behind, strict=True)
    return [section_map(*part) for part in parts]


def mechanical_states(cycle: ItineraryShape) -> list[int] | None:
    """Indices of the states that belong to no forcing; None without a forcing.

    A forced motion is periodic in time: its Poincare map is the stroboscopic one, at a fixed
    phase of the forcing.
    """
    forced = cycle.structure.forced
    if not forced:
        return None
    return [k for k in range(len(cycle.structure.states)) if k not in forced]


def timed_maps(
    cycle: ItineraryShape, numbers: Numbers, now: Shooting, states: list[int]
) -> list[Any]:
    """Derivatives (..., k, k), at fixed times, of the state behind each phase by that at its start.

    Only the k given states count.
    """
    found = _timed(cycle, numbers, now, now.flows)
    return [matrix[..., states, :][..., states] for matrix in found]


def stroboscopic_maps(
    cycle: ItineraryShape,
    fields: np.ndarray,
    starts: np.ndarray,
    maps: np.ndarray,
    states: list[int],
) -> np.ndarray:
    """Stroboscopic maps (n, k, k) of forced motions from their maps on the section (n, N, N).

    The time of a perturbed motion is changed so that the forcing keeps its phase. `fields`
    (n, N, N + 1) are those of the first configuration, `starts` (n, N) are in the system's units,
    the section is the one where the first phase starts, and `states` are the k states that
    belong to no forcing.
    """
    (cosine, sine), *_ = cycle.structure.forcing
    velocity = np.einsum("nij,nj->ni", fields[..., :-1], starts) + fields[..., -1]
    turn = velocity[:, [cosine, sine]]
    turned = np.einsum("ni,nij->nj", turn, maps[:, [cosine, sine]])
    with np.errstate(all="ignore"):  # of points without an orbit
        rate = -turned / (turn * turn).sum(axis=-1, keepdims=True)
        whole = maps + velocity[:, :, None] * rate[:, None, :]
    return np.asarray(whole[:, states][:, :, states])


def _carried(maps: Iterable[Any], basis: Any, size_of: Any, lib: Any) -> list[Any]:
    """A basis (N, k) of directions, and those (N, ...) of what remains behind each of the maps.

    The bases are orthonormal in units of the states' sizes.
    """
    return [
        *accumulate(maps, lambda b, m: orthonormal(_scaled(m, size_of) @ b, lib), initial=basis)
    ]


def _remaining(maps: Sequence[Any], size_of: Any, lib: Any) -> list[Any]:
    """Bases (N, k) of the directions that remain at the start of each phase.

    They remain after passages under the local maps, repeated until no passage loses a dimension.
    """
    basis = np.eye(len(size_of), dtype=maps[0].dtype)
    while True:
        *bases, basis = _carried(maps, basis, size_of, lib)
        if bases[0].shape[1] == basis.shape[1]:
            return bases


def smallest_section(maps: Sequence[Any], size_of: Any) -> tuple[int, int]:
    """The phase from which one passage leaves the fewest directions, and their number.

    The map from there has that many multipliers other than zero, and zero is not a defective
    one. `maps` are those of `local_maps`, and `size_of` (N,) is as `sizes` gives it.
    """
    turned = ((*maps[first:], *maps[:first]) for first in range(len(maps)))
    bases = (_carried(each, np.eye(len(size_of)), size_of, np)[-1] for each in turned)
    ranks = [basis.shape[1] for basis in bases]
    return ranks.index(min(ranks)), min(ranks)


def section_dimension(cycle: ItineraryShape, numbers: Numbers, size_of: Any, lib: Any) -> int:
    """Dimension of the section where the first phase starts.

    It is that of the reset's image of the states that reach the last phase's boundary and keep its
    constraints. `size_of` (N,) is as `sizes` gives it, and `lib` is `numpy` or a context of mpmath.
    """
    size = len(size_of)
    kept = [*cycle.structure.constraints[cycle.configurations[-1]], cycle.rows[-1]]
    normals = (numbers.rows[kept, :size] * size_of).T
    across = orthonormal(normals, lib)
    reached = np.eye(size, dtype=normals.dtype)
    reached = orthonormal(reached - across @ across.T, lib)
    reset = numbers.resets[cycle.transitions[-1].reset, :, :size]
    return int(orthonormal(_scaled(reset, size_of) @ reached, lib).shape[1])


def _scaled(matrix: Any, size_of: Any) -> Any:
    return matrix * size_of[None, :] / size_of[:, None]


def assess(
    cycle: ItineraryShape,
    numbers: Numbers,
    now: Shooting,
    dwell: Any,
    translations: np.ndarray,
    family: bool,
    lib: Any,
    error: Any,
) -> Stability:
    """Multipliers and stability verdict of an orbit, from the data of the orbit as it closes.

    `translations` (m, N) are directions along which the system does not change: each has a
    multiplier 1. An orbit of a family has one more. `lib` is `numpy` or a context of mpmath.
    `error` is the relative error of an orbit and of the derivative of a phase, if all is well
    conditioned.
    """
    size_of = sizes(now, dwell)
    driven = mechanical_states(cycle)
    if driven is None:
        maps = local_maps(cycle, numbers, now)
        dimension = section_dimension(cycle, numbers, size_of, lib)
    else:
        maps, size_of = timed_maps(cycle, numbers, now, driven), size_of[driven]
        dimension = len(driven) - len(translations)
        translations = translations[:, driven]
    if len(translations):
        maps[-1] = projection_along(translations) @ maps[-1]
    bases = _remaining(maps, size_of, lib)
    rank = bases[0].shape[1]
    dimension = max(rank, dimension)
    parts = [
        after.T @ _scaled(local, size_of) @ before
        for local, before, after in zip(maps, bases, [*bases[1:], bases[0]], strict=True)
    ]
    matrix = np.eye(rank, dtype=maps[0].dtype)
    for local in parts:
        matrix = local @ matrix
    precise = maps[0].dtype == object
    trace = sum((matrix[k, k] for k in range(rank)), lib.zero if precise else 0.0)
    pair = family and reciprocal(matrix, rank, lib)
    slowness = _slowness(cycle, numbers, now)
    multiplied = _errors(parts, matrix, slowness, error)
    return stability_of(
        trace if precise else float(trace),
        rank,
        dimension,
        lambda: eigenvalues_of(matrix, lib),
        family=family,
        pair=pair,
        area=not (family or len(translations)) and dimension == 2 and _keeps_area(cycle, numbers),
        errors=multiplied,
        defective=multiplied[1] if precise else math.sqrt(LEAST),
        grazes=bool(slowness * error >= 1),
        lib=lib,
        shifts=len(translations),
    )


def _errors(maps: Sequence[Any], matrix: Any, slowness: float, error: Any) -> tuple[Any, Any]:
    """Errors of the entries of a product of maps, and of its eigenvalues.

    The error of the orbit is that of a phase times the norm of (I - J)^-1, and each map has it
    too, times the factor of a slow crossing. Eigenvalues: F. Bauer and C. Fike, Numer. Math. 2,
    1960, and, near defective ones, L. Elsner, Linear Algebra Appl. 71, 1985.
    """
    count = len(matrix)
    if not count:
        return error, error
    before, behind = [np.eye(count)], [np.eye(count)]
    floats = [local.astype(float) for local in maps]
    for local in floats[:-1]:
        before.append(local @ before[-1])
    for local in reversed(floats[1:]):
        behind.append(behind[-1] @ local)
    norms = (
        np.linalg.norm(a, 2) * np.linalg.norm(m, 2) * np.linalg.norm(b, 2)
        for a, m, b in zip(reversed(behind), floats, before, strict=True)
    )
    whole = matrix.astype(float)
    least = np.linalg.svd(np.eye(count) - whole, compute_uv=False)[-1]
    entries = error * float(sum(norms) * slowness * (1 + 1 / max(least, LEAST)))
    condition = float(np.linalg.cond(np.linalg.eig(whole)[1]))
    size = 2 * float(np.linalg.norm(whole, 2)) + float(entries)
    defective = size * (entries / size) ** (1 / count) if entries else entries
    return entries, min(condition * entries, defective)


def _slowness(cycle: ItineraryShape, numbers: Numbers, now: Shooting) -> float:
    """Largest ratio of the sum of absolute terms of a boundary's speed to the speed itself.

    The error of the speed is that of the orbit times this ratio: beyond the speed itself the
    boundary may be reached tangentially, and the map has no derivative.
    """
    size = now.starts.shape[-1]
    terms = [
        (float(sum(abs(numbers.rows[row, :size] * field))), abs(float(speed)))
        for row, field, speed in zip(cycle.rows, now.velocities, now.speeds, strict=True)
    ]
    return max((total / speed if speed else math.inf for total, speed in terms), default=1.0)


def _keeps_area(cycle: ItineraryShape, numbers: Numbers) -> bool:
    """Whether phases and transitions keep the volume of the states, judged by their numbers.

    A field without divergence keeps it. For a reset R that is its own inverse, the determinant of
    the saltation matrix is that of R times n R f_after / (n f_before): 1 up to the sign where
    both are the same function of the state.
    """
    size, count = numbers.fields.shape[-1] - 1, len(cycle)
    for place, transition in enumerate(cycle.transitions):
        field = numbers.fields[cycle.configurations[place]]
        after = numbers.fields[cycle.configurations[(place + 1) % count]]
        reset = numbers.resets[transition.reset]
        turned, normal = reset[:, :size], numbers.rows[cycle.rows[place], :size]
        if sum(field[k, k] for k in range(size)) or (turned @ turned != np.eye(size)).any():
            return False
        rate, behind = normal @ field, normal @ turned @ after
        behind = np.append(behind[:size] @ turned, behind[:size] @ reset[:, size] + behind[size])
        if (behind != rate).any() and (behind != -rate).any():
            return False
    return True


def reciprocal(matrix: Any, rank: int, lib: Any) -> bool:
    """Whether a map with three multipliers, one of them 1, keeps the area of the two others."""
    if rank != 3:
        return False
    values = matrix.tolist()
    determinant = lib.det(lib.matrix(values)) if matrix.dtype == object else np.linalg.det(matrix)
    return bool(abs(determinant - 1) < math.sqrt(LEAST))
