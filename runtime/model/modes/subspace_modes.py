"""Modes in double precision: eigenvectors where eigenvalues are apart, else invariant subspaces.

Eigenvalues that are equal, or nearly, have a basis of their invariant subspace, by inverse
iteration on a block of vectors, and the matrices of their powers. From `LARGE` states on a simple
eigenvalue, or a pair of them, keeps its eigenvectors as factors: so memory goes with the square of
the number of states, and time with its cube.

That the modes add up to the motion is seen from their sum and its derivative at the start, and
from the first power of each subspace that is left out.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.model.engine_run import LONGEST_WAIT
from nonsmooth.runtime.model.factored_flows import FactoredFlows
from nonsmooth.runtime.model.modes.simple_modes import NumericModes, snapped
from nonsmooth.runtime.model.structure import mode_shapes

LARGE = 20  # states from which on factors are faster than matrices
_EPSILON = float(np.finfo(float).eps)
_NEARNESS = (1e-9, 1e-7, 3e-6, 1e-4)  # of the largest modulus: what is taken together
_ASIDE = 0.1  # shift of an inverse iteration, in units of the distance to what is not meant
_ITERATIONS = 20
_SETTLED = 4 * _EPSILON  # change of a basis in an iteration
_LONGEST_CHAIN = 24  # powers of time with one exponent
_NORM, _LARGEST = 2.0, 1e5  # of a projector: by states; and at most
# error of the sum and of its derivative over a radian, relative to these; for many states
_CLOSE, _CLOSE_OF_MANY = 1e-13, 1e-11


class _Subspace(NamedTuple):
    """A group of eigenvalues, with a basis of their invariant subspace."""

    values: list[complex]
    basis: np.ndarray  # (N + 1, m)


class _ModeParts(NamedTuple):
    """The powers of time with one exponent: as columns and rows of factors, or as matrices."""

    centre: complex
    left: np.ndarray  # (k, N)
    right: np.ndarray  # (k, N + 1)
    matrices: list[np.ndarray]


def subspace_modes(matrix: np.ndarray, depends: np.ndarray) -> tuple[NumericModes, bool] | None:
    """Modes of a matrix whose eigenvalues are apart, or fall into few groups.

    `matrix` (N + 1, N + 1) is the field above a row of zeros, and `depends` its `dependence`. The
    bool says whether all eigenvalues that are taken together are zero, and not only nearly equal.
    The result is None if the modes do not add up to the motion.
    """
    values, vectors = np.linalg.eig(matrix)
    scale = float(np.abs(values).max())
    if not scale < math.inf:
        return None
    tiny = 8 * len(matrix) * _EPSILON * scale
    snug = [complex(v) if abs(v) > tiny else 0j for v in values.tolist()]
    # modes that nearly cancel each other are taken only where no grouping leaves none of them
    for norm in (_NORM * len(matrix), _LARGEST):
        for groups in groupings(snug, _NEARNESS, scale):
            try:
                bases = [
                    _Subspace(group, _basis(matrix, snug, vectors, group))
                    for group in groups
                    if leads(group)
                ]
                modes = _modes_of(matrix, depends, bases, scale, norm)
            except np.linalg.LinAlgError:  # vectors that do not span the space
                continue
            if modes is not None:
                sure = all(len(group) == 1 or not any(group) for group in groups)
                return _record(modes, len(matrix) - 1), sure
    return None


def _basis(
    matrix: np.ndarray, values: list[complex], vectors: np.ndarray, group: list[complex]
) -> np.ndarray:
    """The eigenvector of one eigenvalue, or an orthonormal basis for several."""
    if len(group) == 1:
        return vectors[:, [values.index(group[0])]]
    if len(group) == len(values):
        return np.eye(len(values))
    middle = sum(group) / len(group)
    outside = min((abs(v - middle) for v in values if v not in group), default=1.0)
    turns = abs(middle.imag) > _EPSILON * abs(middle)
    shifted = matrix - (middle if turns else middle.real) * np.eye(len(matrix))
    aside = _ASIDE * outside * (1j if turns else 1)
    inverse = np.linalg.inv(shifted - aside * np.eye(len(matrix)))
    # nearly the subspace that a power of B - mu makes smallest; its unit keeps it finite
    unit = math.ldexp(1.0, min(-math.frexp(np.abs(shifted).max())[1], 1000))
    power = np.linalg.matrix_power(shifted * unit, len(group))
    basis = np.linalg.svd(power)[2][-len(group) :].conj().T
    for _ in range(_ITERATIONS):
        before, basis = basis, np.linalg.qr(inverse @ basis)[0]
        if np.abs(basis - before @ (before.conj().T @ basis)).max() <= _SETTLED:
            break
    return basis


def _modes_of(
    matrix: np.ndarray,
    depends: np.ndarray,
    groups: Sequence[_Subspace],
    scale: float,
    norm: float,
) -> list[_ModeParts] | None:
    """Modes of all groups; None if a projector's norm is too large or they miss the motion."""
    size = len(matrix)
    parts = [
        part
        for values, basis in groups
        for part in ((basis,) if _is_real(values) else (basis, basis.conj()))
    ]
    right = np.hstack(parts)
    if right.shape[1] != size:
        return None
    left = np.linalg.inv(right)
    left = left @ (2 * np.eye(size) - right @ left)
    moved = left @ matrix @ right
    modes, place, blocks = [], 0, np.zeros((size, size), dtype=complex)
    largest, unit, dropped = _NORM * size, scale or 1.0, np.zeros((size, size))
    for values, basis in groups:
        count, twice = basis.shape[1], 1 if _is_real(values) else 2
        for first in range(place, place + twice * count, count):
            inside = slice(first, first + count), slice(first, first + count)
            blocks[inside] = moved[inside]
        here = slice(place, place + count)
        rows, block = left[here], blocks[here, here]
        place += twice * count
        centre = complex(np.trace(block)) / count if min(map(abs, values)) else 0j
        centre = complex(centre.real) if twice == 1 else centre
        centre = complex(snapped(np.array(centre), 8 * size * _EPSILON * scale))
        largest = max(largest, float(np.linalg.norm(rows, 2) * np.linalg.norm(basis, 2)))
        if count == 1:
            modes.append(_factors(centre, basis[:, 0], rows[0], depends))
            continue
        error = 64 * _EPSILON * float(np.linalg.norm(matrix, 2))
        longest = LONGEST_WAIT / scale if scale else math.inf
        terms = _cluster_terms(block, basis, rows, centre, error, longest)
        if terms is None:
            return None
        modes.append(_powers(centre, terms, depends))
        rest = np.linalg.matrix_power((block - centre * np.eye(count)) / unit, len(terms))
        dropped += np.abs(basis @ rest @ rows)
    close = _CLOSE_OF_MANY if size > LARGE else _CLOSE
    sums = right @ left - np.eye(size), (right @ blocks @ left - matrix) / unit, dropped
    missed = max(float(np.abs(part).max()) for part in sums)
    lost = largest / (_NORM * size)  # digits that a large projector costs
    sound = largest <= norm and missed <= close * lost
    return modes if sound else None


def _factors(
    centre: complex, column: np.ndarray, row: np.ndarray, depends: np.ndarray
) -> _ModeParts:
    """Factors of a simple mode, exactly zero in states that its mode does not concern."""
    own = int(np.abs(column * row).argmax())
    column, row = np.where(depends[:, own], column, 0)[:-1], np.where(depends[own], row, 0)
    if not centre.imag:
        return _ModeParts(centre, column.real[None], row.real[None], [])
    left, right = np.stack([2 * column.real, -2 * column.imag]), np.stack([row.real, row.imag])
    return _ModeParts(centre, left, right, [])


def _powers(centre: complex, terms: list[np.ndarray], depends: np.ndarray) -> _ModeParts:
    """Matrices of the powers of time of a group of eigenvalues."""
    size = len(depends) - 1
    found = _real_parts_of(terms, oscillates=centre.imag != 0)
    matrices = [np.where(depends, array, 0.0)[:size] for array in found]
    return _ModeParts(centre, np.empty((0, size)), np.empty((0, size + 1)), matrices)


def _record(modes: list[_ModeParts], size: int) -> NumericModes:
    modes = sorted(modes, key=lambda m: (m.centre != 0, m.centre.imag, m.centre.real))
    parts = []
    for mode in modes:
        oscillates, factored = mode.centre.imag > 0, not mode.matrices
        length = len(mode.matrices) // (2 if oscillates else 1) or 1
        parts.append((length, oscillates, False, False, factored))
    shapes = mode_shapes(parts)
    matrices = [matrix for mode in modes for matrix in mode.matrices]
    exponents = np.array([(mode.centre.real, mode.centre.imag) for mode in modes])
    flows = FactoredFlows(
        shapes,
        np.array(matrices).reshape(-1, size, size + 1),
        np.vstack([mode.left for mode in modes]),
        np.vstack([mode.right for mode in modes]),
    )
    if size < LARGE:
        dense = mode_shapes((s.length, s.oscillates) for s in shapes)
        return NumericModes(dense, exponents, flows.all())
    return NumericModes(shapes, exponents, flows)


def groupings(
    values: list[complex], nearness: Iterable[float], scale: float
) -> Iterator[list[list[complex]]]:
    """Distinct ways to take eigenvalues together that are linked by steps of some nearness.

    Steps are in units of `scale`, the largest modulus of an eigenvalue; where that is 0, all of
    them are together.
    """
    known: list[list[list[complex]]] = []
    for step in nearness:
        groups = _linked_groups(values, step * scale if scale else math.inf)
        if groups not in known:
            known.append(groups)
            yield groups


def _linked_groups(values: list[complex], distance: float) -> list[list[complex]]:
    """Groups of eigenvalues that are linked by steps of at most `distance`.

    Conjugate eigenvalues are in one group, or in two groups that are conjugate to each other.
    """
    groups: list[list[complex]] = []
    for value in values:
        near = [g for g in groups if any(abs(value - other) <= distance for other in g)]
        groups = [g for g in groups if g not in near]
        groups.append([value, *(v for group in near for v in group)])
    return [sorted(g, key=lambda v: (v.real, v.imag)) for g in groups]


def leads(group: list[complex]) -> bool:
    """Whether a group is real or is, of two conjugate groups, the one that is kept."""
    return _is_real(group) or sum(group).imag > 0


def _is_real(group: list[complex]) -> bool:
    """Whether a group has the conjugate of each of its eigenvalues."""
    return {v.conjugate() for v in group} == set(group)


def _cluster_terms(
    block: np.ndarray,
    right: np.ndarray,
    left: np.ndarray,
    centre: complex,
    error: float,
    longest: float,
) -> list[np.ndarray] | None:
    """Matrices (B - mu)^k P (N, N) for k = 0, 1, ..., until the rest is negligible.

    `block` (m, m) is B in an invariant subspace with the bases `right` (N, m) and `left` (m, N),
    whose product is the projector P; `centre` is mu. A power within `error`, the error of the
    block, counts as zero, and a term is negligible if it does not count over the time
    `longest`. None if the powers do not end.
    """
    shifted = block - centre * np.eye(len(block))
    before = 1.0
    power, silent = np.eye(len(block), dtype=complex), 0
    terms: list[np.ndarray] = []
    for k in range(_LONGEST_CHAIN):
        size = float(np.linalg.norm(power, 2))
        if k and size <= error * before:
            return terms
        before = size
        silent = silent + 1 if size * _largest_term(k, centre.real, longest) <= _EPSILON else 0
        if silent == 2 and k >= len(block):
            return terms[:-1]
        terms.append(right @ power @ left)
        power = power @ shifted
    return None


def _largest_term(k: int, rate: float, longest: float) -> float:
    """Largest value of t^k/k! e^(rate t) over t < longest; relative to e^(rate t) if that grows."""
    peak = min(longest, k / -rate) if rate < 0 and k else longest
    if k == 0 or peak == 0:
        return 1.0
    if peak == math.inf:
        return math.inf
    try:
        return math.exp(k * math.log(peak) - math.lgamma(k + 1) + min(rate, 0.0) * peak)
    except OverflowError:
        return math.inf


def _real_parts_of(terms: list[np.ndarray], *, oscillates: bool) -> list[np.ndarray]:
    """The real matrices of the functions t^k e^(st) of a cluster, or of their cosines and sines."""
    found = []
    for k, term in enumerate(terms):
        part = term / math.factorial(k)
        found += [2 * part.real, -2 * part.imag] if oscillates else [part.real]
    return found
