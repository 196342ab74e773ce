"""Multipliers: the eigenvalues of a Poincare map's Jacobian, and their derivatives."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.arithmetic import Mpmath
from nonsmooth.runtime.core.complex_steps import real_parts
from nonsmooth.runtime.core.exponentials.matrices import inverses, sorted_by_size
from nonsmooth.runtime.shooting.newton import LEAST

_ROUNDING = 1e-12  # of multipliers: nearer to the unit circle nothing is told
_RANK = 1e-9  # relative length below which a direction is none, in double precision
_LOST = 10  # decimal digits that its length may lose beyond that
_COLLISION = 1e-6  # of the largest multiplier: distance below which two are not told apart


@dataclass(frozen=True)
class Multiplier:
    """Eigenvalue of the Poincare map's Jacobian.

    `trivial` marks a 1 that a first integral enforces.
    """

    real: Any
    imaginary: Any
    trivial: bool = False


@dataclass(frozen=True)
class Stability:
    """Multipliers and verdict.

    Attributes
    ----------
    multipliers : tuple of Multiplier
        Of the map on the section where the orbit starts, by decreasing absolute value; those
        that are zero because the orbit passes a smaller section are exact.
    trace : number
        Of the same Jacobian.
    rank : int
        No more multipliers differ from zero, because the map passes through a section of
        that dimension; with rank one ``|trace| < 1`` decides.
    margin : number
        1 less the largest absolute value of a nontrivial multiplier, ``1 - |trace|`` for rank
        one; 0 where the verdict is "neutral".
    verdict : {"stable", "neutral", "unstable", "undecided"}
        "stable" is the paper's "conditionally stable": with respect to perturbations that
        keep the sequence of switches; of a family of orbits, that keep the first integral too.
        "neutral": the nontrivial multipliers lie on the unit circle, or there are none.
        Undecided if the margin is within its own error,
        or if a phase reaches the boundary that ends it with no speed beyond its error.
    one_sided : str
        On which side derivatives are taken, as "ta > 0", where the orbit is a border
        collision; else empty.
    """

    multipliers: tuple[Multiplier, ...]
    trace: Any
    rank: int
    margin: Any
    verdict: str
    one_sided: str = ""

    @property
    def rank_one(self) -> bool:
        """Whether the trace alone decides."""
        return self.rank == 1


def stability_of(
    trace: Any,
    rank: int,
    dimension: int,
    eigenvalues: Callable[[], list[Multiplier]],
    *,
    family: bool,
    pair: bool,
    area: bool = False,
    errors: tuple[Any, Any],
    defective: Any,
    grazes: bool,
    lib: Any,
    shifts: int = 0,
    one_sided: str = "",
) -> Stability:
    """Multipliers and verdict of a section map with a trace, of which `rank` may not be zero.

    There are as many multipliers as the section has dimensions. Where 1, mu and 1/mu are a `pair`
    the trace tells them, else `eigenvalues` gives those that may not be zero. Where a map keeps
    `area` the others are reciprocal. `errors` are those of the trace and of a multiplier,
    `defective` that of one of a `family` near the unit circle. `shifts` more are 1, along
    translations. `lib` is `numpy` or a context of mpmath.
    """
    precise = lib is not np
    zero = lib.zero if precise else 0.0
    if pair:  # from the trace, whose digits it keeps
        found = _reciprocal_pair(trace, lib.sqrt if precise else math.sqrt)
    else:
        found = eigenvalues()
        if family and found and not any(m.trivial for m in found):
            found = _with_trivial(found)
    found += [Multiplier(zero, zero)] * (dimension - len(found))
    found += [Multiplier(zero + 1, zero, trivial=True)] * shifts
    # a rounding leaves the pair on the unit circle in front of the trivial 1
    found.sort(key=lambda m: -round(float(modulus(m, lib)), 12))
    # beside a trivial one there are others as large, or larger: a rounding may make it the first
    largest = max((modulus(m, lib) for m in found if not m.trivial), default=zero)
    margin = 1 - largest if precise else float(1 - largest)
    of_trace, of_multiplier = errors
    if pair or area:  # it is s = mu + 1/mu, not |mu|, that is known to this error
        verdict = _verdict_of(2 - abs(trace - int(pair)), of_trace, paired=True)
    elif family:
        verdict = _family_verdict(found, margin, defective)
    else:
        verdict = _verdict_of(margin, of_multiplier)
    verdict = "undecided" if grazes else verdict
    margin = zero if verdict == "neutral" else margin
    return Stability(tuple(found), trace + shifts, rank + shifts, margin, verdict, one_sided)


def eigenvalues_of(matrix: np.ndarray, lib: Any) -> list[Multiplier]:
    """Eigenvalues of a map (k, k); `lib` is `numpy` or a context of mpmath."""
    if matrix.dtype != object:
        return [Multiplier(float(v.real), float(v.imag)) for v in np.linalg.eigvals(matrix)]
    if len(matrix) < 2:
        return [Multiplier(x, 0 * x) for x in matrix.ravel()]
    values = lib.eig(lib.matrix(matrix.tolist()), left=False, right=False)
    return [Multiplier(lib.re(v), lib.im(v)) for v in values]


def modulus(multiplier: Multiplier, lib: Any) -> Any:
    """Absolute value of a multiplier."""
    return lib.sqrt(multiplier.real**2 + multiplier.imaginary**2)


def _reciprocal_pair(trace: Any, root: Callable[[Any], Any]) -> list[Multiplier]:
    """Multipliers mu, 1/mu and a trivial 1, from their sum, whose digits they have.

    `root` is the square root of the trace's arithmetic.
    """
    one, zero = 0 * trace + 1, 0 * abs(trace)
    half = (trace - 1) / 2
    if abs(half) <= 1:
        height = root((1 - half) * (1 + half))
        pair = [Multiplier(half, height), Multiplier(half, -height)]
    else:
        # the larger one first: the smaller is its reciprocal, without cancellation
        larger = half + (1 if half > 0 else -1) * root((half - 1) * (half + 1))
        pair = [Multiplier(larger, zero), Multiplier(1 / larger, zero)]
    return [*pair, Multiplier(one, zero, trivial=True)]


def _with_trivial(found: list[Multiplier]) -> list[Multiplier]:
    """The multipliers with the one nearest to 1 made the trivial 1 of a family, at the end."""
    nearest = min(found, key=lambda m: abs(m.real - 1) + abs(m.imaginary))
    rest = [m for m in found if m is not nearest]
    zero = 0 * abs(nearest.real)
    return [*rest, Multiplier(zero + 1, zero, trivial=True)]


def _verdict_of(distance: Any, error: float, paired: bool = False) -> str:
    """Verdict from the distance to the boundary of stability, which is known to an error.

    `paired` multipliers are reciprocal: inside that boundary they lie on the unit circle.
    """
    if abs(distance) <= error:
        return "undecided"
    if distance < 0:
        return "unstable"
    return "neutral" if paired else "stable"


def _family_verdict(multipliers: Sequence[Multiplier], margin: Any, least: Any) -> str:
    """Verdict on a family whose multipliers are no reciprocal pair, from their margin.

    The others than the trivial 1 may be defective on the unit circle, where half the digits
    are lost: what is nearer to it than `least` is taken to be on it.
    """
    if all(m.trivial for m in multipliers) or abs(margin) <= least:
        return "neutral"
    return "stable" if margin > 0 else "unstable"


def pair_margins(trace: np.ndarray) -> np.ndarray:
    """1 - |mu| (n,) of the larger one of each reciprocal pair beside a 1; 0 on the unit circle."""
    half = np.abs(trace - 1) / 2
    root = np.sqrt(np.maximum((half - 1) * (half + 1), 0))
    return np.where(half <= 1, 0.0, 1 - (half + root))


def nontrivial(values: np.ndarray, rank: int, *, family: bool) -> np.ndarray:
    """Return the multipliers (n, r) that may differ from zero, without the 1 of a family's orbits.

    `values` (n, k) are all multipliers by decreasing size; `rank` of them may differ from zero.
    """
    if family:
        values[np.arange(len(values)), np.argmin(abs(values - 1), axis=-1)] = 0
        values = sorted_by_size(values)
    return np.asarray(values[:, : rank - family])


def margins(maps: np.ndarray, trace: np.ndarray, rank: int, *, family: bool) -> np.ndarray:
    """Return 1 less the largest nontrivial |multiplier| (n,) of orbits with section maps (n, k, k).

    One multiplier of each orbit of a family is 1; there the margin is 0 where the others lie on
    the unit circle. No more than `rank` multipliers differ from zero. The margin is NaN where
    a map is not finite.
    """
    found = np.full(len(maps), np.nan)
    sound = np.isfinite(maps).all(axis=(-2, -1))
    if family:
        found[sound] = family_margins(np.linalg.eigvals(maps[sound]), trace[sound], rank)
    else:
        found[sound] = 1 - _largest_sizes(maps[sound])
    return np.where(np.abs(found) <= _ROUNDING, 0.0, found)


def _largest_sizes(matrices: np.ndarray) -> np.ndarray:
    """Return the largest absolute eigenvalue of each of the matrices (n, k, k)."""
    if matrices.shape[-1] != 2:
        return np.asarray(np.abs(np.linalg.eigvals(matrices)).max(axis=-1, initial=0.0))
    # in closed form, far quicker: no difference of large numbers but in the discriminant
    (a, b), (c, d) = np.moveaxis(matrices, 0, -1)
    mean, discriminant = (a + d) / 2, ((a - d) / 2) ** 2 + b * c
    real = np.abs(mean) + np.sqrt(np.maximum(discriminant, 0))
    turning = np.sqrt(mean**2 + np.abs(discriminant))
    return np.asarray(np.where(discriminant < 0, turning, real))


def family_margins(values: np.ndarray, trace: np.ndarray, rank: int) -> np.ndarray:
    """Return margins of orbits one of whose multipliers (n, k) is 1; 0 where neutral."""
    if rank == 1:  # the trivial one is alone
        return np.zeros(len(values))
    values = sorted_by_size(values)
    # of a reciprocal pair beside the 1 the sum keeps the digits
    pair = (rank == 3) & (np.abs(values[:, :3].prod(axis=-1) - 1) < np.sqrt(LEAST))
    rest = nontrivial(values, values.shape[1], family=True)
    margin = 1 - np.abs(rest).max(axis=-1, initial=0.0)
    margin[np.abs(margin) <= np.sqrt(LEAST)] = 0  # a neutral one may be a defective one
    return np.where(pair, pair_margins(trace), margin)


class MapDerivatives(NamedTuple):
    """A section map and its derivatives by q numbers."""

    matrix: np.ndarray  # (k, k)
    rates: np.ndarray  # (q, k, k)
    rank: int  # number of multipliers that may differ from zero
    trivial: int  # 1 where one of these is 1 because a first integral is kept; else 0


class MultiplierDerivatives(NamedTuple):
    """What a section map's multipliers are, and their derivatives by q numbers.

    Attributes
    ----------
    trace, determinant : number
        Sum and product of the r multipliers that may differ from zero.
    trace_rates, determinant_rates : array (q,)
    multipliers : array (s,)
        Complex: those of the r that are not trivial, by decreasing absolute value.
    multiplier_rates : array (s, q)
        NaN for those that collide.
    spectral_radius : number
    spectral_radius_rates : array (q,)
        NaN where the largest multiplier collides with another.
    """

    trace: Any
    trace_rates: np.ndarray
    determinant: Any
    determinant_rates: np.ndarray
    multipliers: np.ndarray
    multiplier_rates: np.ndarray
    spectral_radius: Any
    spectral_radius_rates: np.ndarray


def multiplier_derivatives(found: MapDerivatives, lib: Mpmath | None) -> MultiplierDerivatives:
    """Derivatives of multipliers, from their left and right eigenvectors, if they are distinct.

    See P. Lancaster, Numer. Math. 6, 1964. Where two multipliers collide, trace and determinant
    still have derivatives. `lib` is None in double precision.
    """
    one = found._replace(matrix=found.matrix[None], rates=found.rates[None])
    parts = _derivatives(one, lib)
    return MultiplierDerivatives(*(p.tolist()[0] if p.ndim == 1 else p[0] for p in parts))


def many_multiplier_derivatives(found: MapDerivatives) -> tuple[np.ndarray, np.ndarray]:
    """Derivatives (k, q) of determinant and of spectral radius of k maps, in double precision.

    The matrices are (k, m, m), the rates (k, q, m, m). The results are those of
    `multiplier_derivatives`, and NaN where a map is not finite.
    """
    determinant, radius = (np.full(found.rates.shape[:2], np.nan) for _ in range(2))
    sound = np.isfinite(found.matrix).all(axis=(1, 2))
    places = np.flatnonzero(sound & np.isfinite(found.rates).all(axis=(1, 2, 3)))
    if len(places):
        own = found._replace(matrix=found.matrix[places], rates=found.rates[places])
        with np.errstate(all="ignore"):
            told = _derivatives(own, None, together=True)
        determinant[places] = told.determinant_rates
        radius[places] = told.spectral_radius_rates
    return determinant, radius


def _derivatives(
    found: MapDerivatives, lib: Mpmath | None, together: bool = False
) -> MultiplierDerivatives:
    """Derivatives of the multipliers of k maps (k, m, m) with rates (k, q, m, m)."""
    matrix, rates, rank, trivial = found
    number, kind, complex_kind = (
        (float, float, complex) if lib is None else (lib.mp.mpf, object, object)
    )
    count = len(matrix)
    trace, trace_rates = (np.trace(part, axis1=-2, axis2=-1) for part in (matrix, rates))
    radius = np.full(count, number(0), dtype=kind)
    radius_rates = np.full(trace_rates.shape, number(0), dtype=kind)
    if not rank:
        none = np.empty((count, 0, rates.shape[1]), dtype=complex_kind)
        one = np.full(count, number(1), dtype=kind)
        return MultiplierDerivatives(
            trace, trace_rates, one, radius_rates, none.sum(axis=2), none, radius, radius_rates
        )
    reduced, moved = _reduced(matrix, rates, rank, lib)
    values, right, left = _eigen(reduced, lib, together)
    slopes = np.einsum("kij,kqjl,kli->kqi", left, moved, right)
    sizes, every = abs(values).astype(float), np.arange(count)
    most = _COLLISION * sizes.max(axis=1, keepdims=True)
    distances = abs(values[:, :, None] - values[:, None]).astype(float)
    apart = (distances > most[:, None]).sum(axis=2) == rank - 1
    if trivial:
        sizes[every, np.argmin(abs(values - 1).astype(float), axis=1)] = -1.0
    order = np.argsort(-sizes, axis=1, kind="stable")[:, : rank - trivial]
    multipliers, apart, sizes = (
        np.take_along_axis(part, order, axis=1) for part in (values, apart, sizes)
    )
    turned = np.take_along_axis(np.swapaxes(slopes, 1, 2), order[..., None], axis=1)
    nan = complex("nan") if lib is None else lib.mp.nan
    turned = np.where(apart[..., None], turned, nan)
    if order.shape[1]:
        first = multipliers[:, 0].conj()[:, None]
        radius = abs(multipliers[:, 0])
        radius_rates = real_parts(first * turned[:, 0]) / radius[:, None]
        tied = (abs(sizes - sizes[:, :1]) <= _COLLISION * sizes[:, :1]) & (
            abs(multipliers - first).astype(float) > most
        )
        tied[:, 0] = False
        radius_rates = np.where(tied.any(axis=1)[:, None], number("nan"), radius_rates)
    return MultiplierDerivatives(
        trace,
        trace_rates,
        _determinants(reduced, lib),
        # row by row: the terms of a sum have the same order in every batch
        (_adjugates(reduced, lib)[:, None] * np.swapaxes(moved, 2, 3))
        .reshape(*trace_rates.shape, -1)
        .sum(axis=2),
        multipliers,
        turned,
        radius,
        radius_rates,
    )


def _reduced(
    matrix: np.ndarray, rates: np.ndarray, rank: int, lib: Mpmath | None
) -> tuple[np.ndarray, np.ndarray]:
    """The maps on their ranges, whose rank is taken to be constant, and derivatives there.

    In a basis of the range and its complement a map is [[A, B], [0, 0]], its change
    [[a, b], [c, d]]; the range turns by c A^-1, and what is left changes by a + B c A^-1.
    """
    if rank == matrix.shape[1]:
        return matrix, rates
    if lib is None:
        basis = np.linalg.svd(matrix)[0]
    else:
        inside = [orthonormal(each, lib.mp) for each in matrix]
        across = [orthonormal(np.eye(len(q), dtype=int) - q @ q.T, lib.mp) for q in inside]
        basis = np.array([np.hstack(both) for both in zip(inside, across, strict=True)])
    back = np.swapaxes(basis, 1, 2)
    turned = back @ matrix @ basis
    inside, beside = turned[:, :rank, :rank], turned[:, :rank, rank:]
    changed = back[:, None] @ rates @ basis[:, None]
    if lib is None:
        inverse = inverses(inside)
    else:
        inverse = np.array([(lib.mp.matrix(m.tolist()) ** -1).tolist() for m in inside])
    across = changed[:, :, rank:, :rank] @ inverse[:, None]
    return inside, changed[:, :, :rank, :rank] + beside[:, None] @ across


def orthonormal(columns: Any, lib: Any) -> Any:
    """Orthonormal basis of the span of the columns, by Gram-Schmidt with pivoting.

    `lib` is `numpy` or a context of mpmath.
    """
    none = _RANK if lib is np else lib.mpf(10) ** (_LOST - lib.dps)
    left = [columns[:, k] for k in range(columns.shape[1])]
    basis: list[Any] = []
    largest = max((lib.sqrt(v @ v) for v in left), default=0)
    while left:
        lengths = [lib.sqrt(v @ v) for v in left]
        best = max(range(len(left)), key=lambda k: lengths[k])
        if not lengths[best] > none * largest:
            break
        unit = left.pop(best) / lengths[best]
        for _ in range(2):  # once more for what the first pass has lost
            unit = unit - sum((b * (b @ unit) for b in basis), 0 * unit)
            unit = unit / lib.sqrt(unit @ unit)
        basis.append(unit)
        left = [v - unit * (unit @ v) for v in left]
    if not basis:
        return columns[:, :0]
    return np.stack(basis, axis=-1)


def _eigen(
    matrix: np.ndarray, lib: Mpmath | None, together: bool
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Eigenvalues (k, r), right eigenvectors as columns, left ones as rows; products are 1.

    Maps that are taken `together` have the left ones by an inverse, however many there are.
    """
    if together:
        values, right = np.linalg.eig(matrix)
        return values.astype(complex), right, inverses(right)
    found = []
    for each in matrix:  # where vectors are nearly parallel their inverse would lose digits
        if lib is None:
            import scipy.linalg

            values, left, right = scipy.linalg.eig(each, left=True, right=True)
            found.append((values, right, left.conj().T))
        else:
            values, left, right = lib.mp.eig(lib.mp.matrix(each.tolist()), left=True, right=True)
            found.append(([lib.mp.mpc(v) for v in values], right.tolist(), left.tolist()))
    kind = complex if lib is None else object
    values, right, left = (np.array(part, dtype=kind) for part in zip(*found, strict=True))
    return values, right, left / np.diagonal(left @ right, axis1=1, axis2=2)[..., None]


def _determinants(matrix: np.ndarray, lib: Mpmath | None) -> np.ndarray:
    if lib is None:
        return np.asarray(np.linalg.det(matrix))
    return np.array([lib.mp.det(lib.mp.matrix(m.tolist())) for m in matrix], dtype=object)


def _adjugates(matrix: np.ndarray, lib: Mpmath | None) -> np.ndarray:
    """The adjugates: derivatives of the determinants, also where these are zero."""
    size = matrix.shape[1]
    found = np.ones_like(matrix)
    for i, j in np.ndindex(size, size) if size > 1 else ():
        minor = np.delete(np.delete(matrix, i, axis=1), j, axis=2)
        found[:, j, i] = (-1) ** (i + j) * _determinants(minor, lib)
    return found
