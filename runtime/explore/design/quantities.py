"""Values of quantities at an orbit, their derivatives, and conditions on the largest of several.

Conditions that none of several numbers exceeds a level are smooth where these meet: of
multipliers, whose largest is the spectral radius, and of the local extremes of a motion, whose
largest is a peak.

All roots of λ² - Tλ + D are in the disc of radius t where t² + D ≥ |T| t and t² ≥ D (E. I. Jury,
Theory and Application of the z-Transform Method, 1964). Trace and determinant have derivatives
also where the two roots meet, so that an optimum may be a corner. Several multipliers are taken
in pairs, each by the map on its invariant plane: with bases V and U of it and of that of the
transposed map this is (UᵀV)⁻¹UᵀAV, and its eigenvalues change as those of (UᵀV)⁻¹Uᵀ(dA)V are added
to it (G. W. Stewart and J. Sun, Matrix Perturbation Theory, 1990, chapter V). It has derivatives as
long as the two are apart from all other multipliers, however near they are to each other.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from operator import attrgetter
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from nonsmooth.runtime.core.complex_steps import imaginary_parts, stepped
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.orbits.motion_derivatives import KINDS

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.derivatives import OrbitDerivatives
    from nonsmooth.runtime.orbits.motion_derivatives import LocalExtreme
    from nonsmooth.runtime.orbits.orbit import Orbit
    from nonsmooth.runtime.shooting.multipliers import MultiplierDerivatives

RADIUS, MULTIPLIER = "spectral_radius", "multiplier"
PURE = (RADIUS, MULTIPLIER, "trace", "determinant")  # quantities without a dimension
_LEAST_UNIT = 1e-3  # of what the bounds change: the unit of a quantity that begins near zero
_REAL = 1e-12  # of the largest: imaginary part of a real eigenvalue
_ZERO = "the multiplier passes through zero"
_MEET = "two multipliers meet"
_OPPOSITE = "two multipliers of opposite sign are equally large"
_TIED = "the largest and the smallest value are equally far from zero"
_EXTREMES = "several extremes are equally large"
_SEVERAL = "several multipliers are equally large"
_SAME_SLOPE = 1e-6  # of extremes that tie by a symmetry, or are one at the end of a phase


class QuantityValues(NamedTuple):
    """Quantities at one orbit, and their derivatives by q parameters."""

    values: Mapping[str, float]
    slopes: Mapping[str, np.ndarray]  # (q,) each, NaN where there is no derivative
    derivatives: OrbitDerivatives  # of all other quantities of the orbit

    def quantity(self, name: str, wanted: float | None = None) -> float:
        """Value of a quantity; for a multiplier that which is nearest to `wanted`."""
        if name != MULTIPLIER:
            return self.values[name]
        found = np.asarray(self.derivatives.section.multipliers).astype(complex)
        return float(found[np.abs(found - wanted).argmin()].real)


def measure(orbit: Orbit, by: Sequence[str], of: Sequence[str]) -> QuantityValues:
    """The quantities named in `of` at an orbit, with derivatives by the given parameters `by`.

    The names are those of `OrbitDerivatives.quantity`. A quantity that is unknown or does not
    exist is refused, and so is an orbit without derivatives.
    """
    found = orbit.derivatives(list(by))
    values, slopes = {}, {}
    for name in of:
        if is_extreme(name):  # also where several extremes tie
            largest = max(found.local_extremes(name), key=attrgetter("value"))
            sign = -1.0 if name.startswith("minimum") else 1.0
            values[name] = sign * largest.value
            slopes[name] = sign * np.asarray(largest.rates, dtype=float)
            continue
        value, slope = found.quantity(name)
        values[name], slopes[name] = float(value), np.asarray(slope, dtype=float)
    return QuantityValues(values, slopes, found)


def is_extreme(quantity: str) -> bool:
    """Whether a quantity is the largest of several local extremes of the motion."""
    kind, _, of = quantity.partition(":")
    return kind in KINDS and bool(of)


def unit_of(value: float, changes: np.ndarray) -> float:
    """Positive unit of a quantity: its size, or a share of its change over the bounds.

    `value` is taken where the design begins, and `changes` (q,) are its derivatives by the
    places of the parameters, NaN where there is none. The unit of zero without change is 1.
    """
    size = max(abs(value), _LEAST_UNIT * float(np.nan_to_num(np.abs(changes)).max(initial=0.0)))
    return size or 1.0


class LevelRows(NamedTuple):
    """Conditions of a level, each not negative where the largest number is at most the level."""

    values: np.ndarray  # (m,)
    by_parameters: np.ndarray  # derivatives (m, q)
    by_level: np.ndarray  # derivatives (m,)
    powers: np.ndarray  # (m,), power of the quantity's unit in which each is measured


def multiplier_rows(derivatives: OrbitDerivatives, wanted: float) -> LevelRows:
    """The equation that an orbit has a wanted multiplier: its characteristic polynomial there.

    That is the product of the differences between the wanted multiplier and each multiplier,
    which has derivatives also where multipliers collide. Refused are the multiplier zero, and a
    family of orbits, which has the multiplier 1 everywhere.
    """
    matrix, rates, rank, trivial = derivatives.directions.section
    if trivial or not wanted:
        told = "1 belongs to a whole family" if trivial else "0 belongs to no orbit"
        raise InputError(f"no multiplier can be wanted here: {told}")
    matrix, rates = matrix.astype(float), rates.astype(float)
    beside, unit = len(matrix) - rank, np.eye(len(matrix))
    scale, shifted = wanted**beside, wanted * unit - matrix
    value = float(np.linalg.det(shifted)) / scale
    moving = np.concatenate([-rates, unit[None]])
    *moved, by_wanted = imaginary_parts(np.linalg.det(stepped(shifted, moving, None)), None) / scale
    by_level = float(by_wanted) - beside * value / wanted
    return LevelRows(np.array([value]), np.array([moved]), np.array([by_level]), np.ones(1))


class _MultiplierGroup(NamedTuple):
    """A multiplier alone, or two of them."""

    size: int  # 1 or 2
    trace: float  # sum
    trace_rates: np.ndarray  # (q,)
    determinant: float  # product
    determinant_rates: np.ndarray  # (q,)


def _multiplier_groups(derivatives: OrbitDerivatives) -> tuple[_MultiplierGroup, ...]:
    """Nontrivial multipliers in pairs, and one alone where their number is odd.

    Conjugate ones are a pair, and real ones next to each other, so that a pair remains the
    same where two multipliers meet and leave the real axis.
    """
    found, section = derivatives.section, derivatives.directions.section
    count = section.rank - section.trivial
    if count > 2:
        return _split(section.matrix.astype(float), section.rates.astype(float), count, found)
    if not count:
        return ()
    # a trivial multiplier is 1: it adds to the trace and not to the product
    return (
        _MultiplierGroup(
            count,
            float(found.trace) - section.trivial,
            np.asarray(found.trace_rates, dtype=float),
            float(found.determinant),
            np.asarray(found.determinant_rates, dtype=float),
        ),
    )


def _split(
    matrix: np.ndarray, rates: np.ndarray, count: int, found: MultiplierDerivatives
) -> tuple[_MultiplierGroup, ...]:
    wanted = np.asarray(found.multipliers).astype(complex)
    largest = float(np.abs(wanted).max())
    real = np.sort(wanted[np.abs(wanted.imag) <= _REAL * largest].real)
    pairs = [np.array([z, z.conjugate()]) for z in wanted if z.imag > _REAL * largest]
    alone = None
    if len(real) % 2:
        pairs_without = [np.delete(real, k).reshape(-1, 2) for k in range(0, len(real), 2)]
        alone = 2 * int(np.argmin([np.diff(each).sum() for each in pairs_without]))
        real, alone = np.delete(real, alone), real[alone]
    pairs += [real[k : k + 2].astype(complex) for k in range(0, len(real), 2)]
    pairs.sort(key=lambda pair: -float(np.abs(pair).max()))
    groups = pairs + ([] if alone is None else [np.array([alone], dtype=complex)])
    return tuple(_group(matrix, rates, values) for values in groups)


def _group(matrix: np.ndarray, rates: np.ndarray, values: np.ndarray) -> _MultiplierGroup:
    right, left = _plane(matrix, values), _plane(matrix.T, values)
    onto = np.linalg.solve(left.T @ right, left.T)
    own, moved = onto @ matrix @ right, onto @ rates @ right
    return _MultiplierGroup(
        len(own),
        float(np.trace(own)),
        np.trace(moved, axis1=-2, axis2=-1),
        float(np.linalg.det(own)),
        imaginary_parts(np.linalg.det(stepped(own, moved, None)), None),
    )


def _plane(matrix: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Orthonormal basis of the invariant subspace of some eigenvalues, by an ordered Schur form."""
    from scipy.linalg import schur

    every = np.linalg.eigvals(matrix)
    chosen = {int(np.abs(every - value).argmin()) for value in values}
    if len(chosen) < len(values):  # equal ones: the next nearest too
        chosen = set(np.argsort(np.abs(every - values.mean()))[: len(values)].tolist())
    others = [k for k in range(len(every)) if k not in chosen]
    inside, outside = every[sorted(chosen)], every[others]

    def ours(re: float, im: float = 0.0) -> bool:
        z = complex(re, im)
        return bool(np.abs(inside - z).min() < np.abs(outside - z).min(initial=np.inf))

    _, basis, size = schur(matrix, output="real", sort=ours)
    if size != len(values):
        raise np.linalg.LinAlgError("multipliers are not told apart")
    return np.asarray(basis[:, : len(values)])


class ExtremeKey(NamedTuple):
    """A number of local extremes in a phase (from 0): maxima, or minima if the sign is -1."""

    phase: int
    sign: int
    number: int


def is_largest_of_several(quantity: str, sign: int) -> bool:
    """Whether the objective is the largest of several numbers that have derivatives.

    `sign` is -1 where the quantity is maximised.
    """
    if quantity.startswith("minimum:"):
        return sign < 0
    return sign > 0 and (quantity == RADIUS or is_extreme(quantity))


def radius_rows(derivatives: OrbitDerivatives, level: float) -> LevelRows:
    """The conditions that all nontrivial multipliers are in a disc of radius `level`.

    There are two for a multiplier alone and three for a pair.
    """
    rows: list[tuple[float, np.ndarray, float, int]] = []
    for group in _multiplier_groups(derivatives):
        trace, rates = group.trace, group.trace_rates
        product, by_product = group.determinant, group.determinant_rates
        for sign in (1, -1):
            if group.size == 1:
                rows.append((level - sign * trace, -sign * rates, 1.0, 1))
                continue
            value = level**2 + product - sign * trace * level
            rows.append((value, by_product - sign * level * rates, 2 * level - sign * trace, 2))
        if group.size == 2:
            rows.append((level**2 - product, -by_product, 2 * level, 2))
    if not rows:  # all of them are zero
        return LevelRows(np.zeros(0), np.zeros((0, len(derivatives.by))), np.zeros(0), np.zeros(0))
    return LevelRows(*map(np.array, zip(*rows, strict=True)))


def extreme_keys(every: Iterable[OrbitDerivatives], quantity: str) -> tuple[ExtremeKey, ...]:
    """Number of the local extremes of which a quantity is the largest, for each phase and sign.

    Of several orbits of one itinerary the largest number counts.
    """
    counts: dict[tuple[int, int], int] = {}
    for derivatives in every:
        own: dict[tuple[int, int], int] = {}
        for extreme in derivatives.local_extremes(quantity):
            place = extreme.phase, extreme.sign
            own[place] = own.get(place, 0) + 1
        counts = {key: max(counts.get(key, 0), own.get(key, 0)) for key in {**counts, **own}}
    return tuple(ExtremeKey(*place, count) for place, count in sorted(counts.items()))


def extreme_rows(
    derivatives: OrbitDerivatives,
    quantity: str,
    keys: Iterable[ExtremeKey],
    level: float,
    unit: float,
) -> LevelRows:
    """The conditions that no local extreme of a quantity exceeds a level.

    For each key they are those of the largest extremes; where an orbit has fewer of them, the
    remaining conditions hold by far. `unit` is that of the quantity.
    """
    found = derivatives.local_extremes(quantity)
    rows: list[LocalExtreme | None] = []
    for phase, sign, count in keys:
        own = [each for each in found if (each.phase, each.sign) == (phase, sign)]
        largest = sorted(sorted(own, key=attrgetter("value"))[-count:], key=attrgetter("time"))
        rows += [*largest]
        rows += [None] * (count - len(largest))
    far, nothing = max(unit, abs(level)), np.zeros(len(derivatives.by))
    return LevelRows(
        np.array([far if each is None else level - each.value for each in rows]),
        np.array([nothing if each is None else -each.rates for each in rows], dtype=float),
        np.array([each is not None for each in rows], dtype=float),
        np.ones(len(rows)),
    )


def corner_of(
    derivatives: OrbitDerivatives,
    quantity: str,
    active: np.ndarray,
    slopes: np.ndarray,
    units: np.ndarray,
) -> str:
    """What happens where several conditions of one orbit act; empty where the quantity is smooth.

    `active` (m,) marks the conditions that hold with equality, `slopes` (m, n) are their
    derivatives, and `units` (q,) are those of the quantity's derivatives.
    """
    acting = slopes[active]
    size = max(1.0, float(np.abs(acting).max(initial=0.0)))
    if len(acting) < 2 or float(np.ptp(acting, axis=0).max()) <= _SAME_SLOPE * size:
        return ""
    if quantity != RADIUS:
        found = derivatives.local_extremes(quantity)
        top = max(each.value for each in found)
        ties = [each for each in found if each.value >= top - _SAME_SLOPE * abs(top)]
        for sign in {each.sign for each in ties}:
            rates = np.array([each.rates for each in ties if each.sign == sign], dtype=float)
            rates /= units
            if float(np.ptp(rates, axis=0).max()) > _SAME_SLOPE * size:
                return _EXTREMES
        return _TIED
    groups = list(_multiplier_groups(derivatives))
    ends = np.cumsum([2 if group.size == 1 else 3 for group in groups])
    acting_in = {int(k) for k in np.searchsorted(ends, np.flatnonzero(active), side="right")}
    if len(acting_in) > 1:
        return _SEVERAL
    (place,) = acting_in
    if groups[place].size == 1:
        return _ZERO
    first = int(ends[place]) - 3
    return _OPPOSITE if active[first : first + 2].all() else _MEET
