"""Modes of a configuration from its numbers, where its flow has no closed form.

With Y = (y, 1) the motion y' = A y + b is Y' = B Y, and

    exp(B t) = sum_c e^(mu_c t) sum_k t^k/k! (B - mu_c)^k P_c,

a sum over clusters of eigenvalues with centres mu_c and spectral projectors P_c. A cluster is a
single eigenvalue wherever its projector is small enough to be known well; eigenvalues that are
equal, or so near each other that their projectors cancel, are taken together. The powers of a
cluster end at its size where its eigenvalues are equal, and a little later where they are not.

The sum is compared with the exponential. Where it misses more than rounding (clusters of very
different sizes, eigenvalues neither equal nor apart) the clusters are found in many digits, and
rounded once. A cluster of few eigenvalues is then Newton's interpolation of the exponential,

    sum_k e[p_0, ..., p_k] (B - p_0) ... (B - p_(k-1)) P,

a chain of modes that is exact at all times; one of more is the series.

The first of these ways that succeeds is taken: `simple_modes`, for a whole stack of fields at once;
`driven_modes`, where only what drives the structure has equal eigenvalues; from `LARGE` states on
`large_modes` in place of both; `eigenvalue_clusters` in doubles, and last in the many digits of
`projectors`.
"""

from __future__ import annotations

import math
from functools import cache, lru_cache

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.driven_modes import driven_modes
from nonsmooth.runtime.model.eigenvalue_clusters import (
    Cluster,
    eigenvectors_apart,
    precise_candidates,
    real_parts_of,
    smallest_projectors,
)
from nonsmooth.runtime.model.factored_flows import Flows, arrays_of, matrices_of
from nonsmooth.runtime.model.large_modes import LARGE, large_modes
from nonsmooth.runtime.model.natural_units import balanced, dependence, fall_rates, natural_units
from nonsmooth.runtime.model.projectors import exponentials_at
from nonsmooth.runtime.model.simple_modes import ModeGroup, NumericModes, simple_modes
from nonsmooth.runtime.model.structure import ModeShape, mode_shapes
from nonsmooth.runtime.model.time_functions import functions_at

__all__ = ["NumericModes", "grouped_modes", "no_modes", "numeric_modes", "standing_modes"]

_ONE = mode_shapes([(1, False)])
_FEW = 4  # for fewer fields it pays to remember their modes
_CLOSE = 2e-14  # error of a sum, relative to the flow, that is rounding
_LARGEST = 1e-7
_MODERATE = 1e3  # term of the flow beside which no digits are lost that count
_ANGLES = (1 / 64, 1.0, 16.0)  # radians of the fastest at which sums are compared
_LONG = 1024.0  # the same where eigenvalues were taken for equal that turn
_TURNED = 32.0  # radians in which an exponent's rounding grows to that of the sum
_GROWTH = 100.0  # exponent beyond which nothing is compared


def numeric_modes(field: np.ndarray, rows: np.ndarray | None = None) -> NumericModes:
    """Modes of y' = A y + b; `field` (N, N + 1) is A, then b, and finite.

    `rows` (r, N + 1) are the boundaries in front of which the motion takes place; they set the
    unit of time. Raises `InputError` if eigenvalues are so close, without being equal, that
    double precision does not determine the motion.
    """
    array = np.ascontiguousarray(field, dtype=float)
    rate = 0.0 if rows is None else float(fall_rates(array[None], rows[None])[0])
    try:
        with np.errstate(over="ignore", invalid="ignore"):
            return _numeric_modes(array.tobytes(), len(array), rate)
    except np.linalg.LinAlgError:
        raise InputError(
            "entries of a vector field are too far apart: double precision does not tell its modes"
        ) from None


def grouped_modes(fields: np.ndarray, rows: np.ndarray) -> list[ModeGroup]:
    """Modes of n motions y' = A y + b, grouped by their shapes.

    `fields` (n, N, N + 1) are A, then b; `rows` (n, r, N + 1) as for `numeric_modes`. Motions
    whose numbers are not finite, or that double precision does not determine, get NaN.
    """
    count = len(fields)
    if count > 1 and (fields == fields[:1]).all() and (rows == rows[:1]).all():
        (only,) = grouped_modes(fields[:1], rows[:1])
        exponents, *flows = (
            np.broadcast_to(part, (count, *part.shape[1:]))
            for part in (only.exponents, *only.flows)
        )
        return [ModeGroup(np.arange(count), only.shapes, exponents, tuple(flows))]
    finite = np.flatnonzero(np.isfinite(fields).all(axis=(-2, -1)))
    groups = []
    if len(finite) > _FEW and fields.shape[1] < LARGE:
        for group in _simple_modes(fields[finite], rows[finite]):
            groups.append(group._replace(places=finite[group.places]))
    members: dict[tuple[ModeShape, ...], list[tuple[int, NumericModes]]] = {}
    for place in sorted({*range(count)}.difference(*(g.places.tolist() for g in groups))):
        try:
            found = numeric_modes(fields[place], rows[place])
        except InputError:
            found = no_modes(fields.shape[1])
        members.setdefault(found.shapes, []).append((place, found))
    for shapes, each in members.items():
        exponents = np.stack([modes.exponents for _, modes in each])
        arrays = zip(*(arrays_of(modes.flows) for _, modes in each), strict=True)
        places = np.array([place for place, _ in each])
        groups.append(ModeGroup(places, shapes, exponents, tuple(map(np.stack, arrays))))
    return groups


@cache
def no_modes(size: int) -> NumericModes:
    """A placeholder for unknown modes of a configuration: one mode, and NaN."""
    return _unchanging(np.full((1, 2), np.nan), np.full((1, size, size + 1), np.nan))


@cache
def standing_modes(size: int) -> NumericModes:
    """A placeholder for a configuration in which motions end at once.

    It has one mode, with which the state stays constant.
    """
    return _unchanging(np.zeros((1, 2)), np.eye(size, size + 1)[None])


def _unchanging(
    exponents: np.ndarray, flows: Flows, shapes: tuple[ModeShape, ...] = _ONE
) -> NumericModes:
    """Modes that are shared, by default one: nobody may write into their arrays."""
    for array in (exponents, *arrays_of(flows)):
        array.flags.writeable = False
    return NumericModes(shapes, exponents, flows)


@lru_cache(maxsize=4096)  # configurations share fields, and so do points of a sweep
def _numeric_modes(content: bytes, size: int, rate: float) -> NumericModes:
    found = _found(np.frombuffer(content).reshape(size, size + 1), rate)
    return _unchanging(found.exponents, found.flows, found.shapes)


def _simple_modes(fields: np.ndarray, rows: np.ndarray) -> list[ModeGroup]:
    """Modes of the motions of a stack with distinct eigenvalues, computed in natural units."""
    units = natural_units(fields, fall_rates(fields, rows))
    groups = []
    for group in simple_modes(units.fields(fields)):
        own = units.at(group.places)
        exponents, flows = own.exponents(group.exponents), own.flows(group.shapes, group.flows)
        groups.append(group._replace(exponents=exponents, flows=flows))
    return groups


def _found(field: np.ndarray, rate: float) -> NumericModes:
    """Modes of one motion, computed in its natural units."""
    units = natural_units(field[None], np.array([rate]))
    shapes, exponents, flows = _found_in_natural_units(units.fields(field[None])[0])
    return NumericModes(
        shapes, units.exponents(exponents[None])[0], units.flows_of_one(shapes, flows)
    )


def _found_in_natural_units(field: np.ndarray) -> NumericModes:
    """Modes of one motion by the fast methods if they succeed, else by clusters of eigenvalues."""
    size = len(field)
    if size < LARGE:
        for group in simple_modes(field[None]):
            return NumericModes(group.shapes, group.exponents[0], group.flows[0][0])
        if (driven := driven_modes(field, numeric_modes)) is not None:
            return driven
    whole = np.vstack([field, np.zeros(size + 1)])
    # a change of units keeps powers of two exact
    scaled, units = (part[0] for part in balanced(whole[None]))
    if size >= LARGE and (large := large_modes(scaled, units, dependence(whole[None])[0])):
        return large
    shapes, exponents, terms = _modes_of(_decomposed(scaled, units))
    flows = np.where(dependence(whole[None])[0], units[:, None] * terms / units, 0.0)[:, :size]
    return NumericModes(shapes, exponents, flows)


def _modes_of(clusters: list[Cluster]) -> NumericModes:
    """Modes of clusters, with a square matrix for each function of time."""
    shapes: list[tuple[int, bool, bool, bool]] = []
    exponents, terms = [], []
    for cluster in clusters:
        assert cluster.terms is not None
        if cluster.poles:
            modes, factors = _chained(cluster.poles, cluster.terms)
            shapes += [shape for shape, _ in modes]
            exponents += [pole for _, pole in modes]
            terms += factors
            continue
        oscillates = cluster.centre.imag > 0
        terms += real_parts_of(cluster.terms, oscillates=oscillates)
        exponents.append(cluster.centre)
        shapes.append((len(cluster.terms), oscillates, False, False))
    pairs = np.array([(pole.real, pole.imag) for pole in exponents])
    return NumericModes(mode_shapes(shapes), pairs, np.array(terms))


def _chained(
    poles: tuple[complex, ...], products: list[np.ndarray]
) -> tuple[list[tuple[tuple[int, bool, bool, bool], complex]], list[np.ndarray]]:
    """Modes of a chain of poles with their exponents, and a matrix for each function of time.

    Newton's products go on pole by pole; a pair of conjugate poles is one mode.
    """
    real = any(pole.imag <= 0 for pole in poles)
    head = 1 if poles[0].imag else sum(pole == poles[0] for pole in poles)
    modes: list[tuple[tuple[int, bool, bool, bool], complex]] = []
    terms: list[np.ndarray] = []
    if head > 1 or not poles[0].imag:
        modes.append(((head, False, False, False), poles[0]))
        terms += [products[k].real / math.factorial(k) for k in range(head)]
    place = len(terms)
    while place < len(poles):
        pole, term = poles[place], products[place]
        paired = real and pole.imag > 0
        modes.append(((1, pole.imag > 0, bool(modes), paired), pole))
        if paired:  # (B - p) = (B - s) - iw, and the second pole leaves the real part
            terms += [term.real, products[place + 1].real]
            place += 2
            continue
        terms += [2 * term.real, -2 * term.imag] if pole.imag else [term.real]
        place += 1
    return modes, terms


def _decomposed(matrix: np.ndarray, units: np.ndarray) -> list[Cluster]:
    """Clusters whose sum is the exponential of a matrix, given in units of its coordinates.

    They are in double precision if their sum is then right to rounding, else the best of those
    in more digits.
    """
    values, right = np.linalg.eig(matrix)
    scale = float(np.abs(values).max())
    found = eigenvectors_apart(values, right, scale)
    largest = _largest_term(found, units) if found is not None else 0.0
    # where terms are large they cancel most while the motion is still small
    small = np.geomspace(1 / max(largest, _MODERATE), _ANGLES[0], 8).tolist()
    angles = (*_ANGLES, *small) if largest > _MODERATE else _ANGLES
    found = found or smallest_projectors(matrix, values, scale)
    if not scale and found is not None:
        return _sorted(found)
    # eigenvalues taken for zero that are not have grown too little to be told from a rounding
    if any(cluster.centre != 0 and len(cluster.terms or ()) > 1 for cluster in found or ()):
        angles = (*angles, _LONG)
    if found is not None and _missed(matrix, units, found, scale, angles) <= _CLOSE:
        return _sorted(found)
    best, least = found, math.inf
    for candidate in (found, *precise_candidates(matrix, values.tolist(), scale)):
        if candidate is not None:
            missed = _missed(matrix, units, candidate, scale, angles)
            if missed < least:
                best, least = candidate, missed
            if least <= _CLOSE:
                break
    if best is None or not least <= _LARGEST:
        raise InputError(
            "eigenvalues of a vector field are neither equal nor apart: double precision does not"
            f" tell them from each other ({', '.join(f'{v:.6g}' for v in values)})"
        )
    return _sorted(best)


def _largest_term(clusters: list[Cluster], units: np.ndarray) -> float:
    """Largest entry of the clusters' matrices in the coordinates' own units."""
    return max(
        float(np.abs(units[:, None] * term / units).max())
        for cluster in clusters
        for term in cluster.terms or ()
    )


def _missed(
    matrix: np.ndarray,
    units: np.ndarray,
    clusters: list[Cluster],
    scale: float,
    angles: tuple[float, ...],
) -> float:
    """Largest error of the clusters' sum in the coordinates' own units, relative to the flow."""
    shapes, exponents, flows = _modes_of(_sorted(clusters))
    terms = matrices_of(flows)
    worst, growth = 0.0, max(exponents[:, 0].max(), 0.0)
    # products with powers of two are exact
    times = [(angle, 2.0 ** round(math.log2(angle / scale))) for angle in angles]
    times = [(angle, t) for angle, t in times if growth * t <= _GROWTH]
    exact = exponentials_at(matrix, {t for _, t in times}) if times else {}
    for angle, t in times:
        wanted = units[:, None] * exact[t] / units
        with np.errstate(over="ignore", invalid="ignore"):  # of candidates that are far off
            total = np.tensordot(np.array(functions_at(shapes, exponents, t)), terms, axes=1)
            missed = float(np.abs(units[:, None] * total / units - wanted).max())
        if not math.isfinite(missed):
            return math.inf
        allowed = max(1.0, np.abs(wanted).max()) * max(1.0, angle / _TURNED)
        worst = max(worst, float(missed / allowed))
    return worst


def _sorted(clusters: list[Cluster]) -> list[Cluster]:
    return sorted(clusters, key=lambda c: (c.centre != 0, c.centre.imag, c.centre.real))
