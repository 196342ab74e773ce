"""Trace and multipliers of an orbit, and on which side of the unit circle they are proved to be."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.matrix_chains import along_chain
from nonsmooth.runtime.core.taylor_models import matrix, range_of
from nonsmooth.runtime.proof.exact_closure import ClosureConditions
from nonsmooth.runtime.proof.exact_tables import Number, numbers
from nonsmooth.runtime.proof.invariants import CycleInvariants
from nonsmooth.runtime.proof.motion.exact_rows import Invariants
from nonsmooth.runtime.shooting.translations import gauges_of

if TYPE_CHECKING:
    from flint import acb, arb, arb_mat, arb_poly

__all__ = [
    "CORNER",
    "apart",
    "eigenvalues_of",
    "inside_circle",
    "neutral_pairs",
    "others_below",
    "product_of",
    "reduced_map",
    "trace_of",
]

CORNER = "boundaries are reached together: the Poincare map has a corner"
_MOST_SQUARINGS = 48
_LEAST_SLOPE = 2.0**-72


def reduced_map(
    maps: Sequence[Any],
    invariants: CycleInvariants | None,
    closing: ClosureConditions,
    number: Number,
) -> Any:
    """Return the product of the phases' maps (N, N) on the smallest section that is known: (n, n).

    The multipliers that it leaves out are exactly zero. Where the maps are at fixed times, only the
    lasting invariants hold for changes, and the states of forcings do not change from period to
    period. `number` maps the invariants' exact entries to the maps' numbers.
    """
    size = maps[0].nrows()
    places: Sequence[Invariants] = [Invariants((), ())] * len(maps)
    if invariants is not None:
        places = invariants.lasting if closing.timed else invariants.starts
    # where the cycle closes the first coordinates of translations are zero
    fixed = [
        (*closing.forced, *gauges_of(closing.translations)),
        *(closing.forced for _ in places),
    ]
    tangents = [_tangent(f, still, size) for f, still in zip(places, fixed, strict=False)]
    first = min(range(len(maps)), key=lambda k: len(tangents[k][0]))
    free, basis = tangents[first]
    ordered = [*maps[first:], *maps[:first]]
    found = along_chain([mapping.__mul__ for mapping in ordered], numbers(basis, number))
    return matrix([[found[i, j] for j in range(len(free))] for i in free])


def inside_circle(mapping: Any) -> bool | None:
    """Whether all eigenvalues of a matrix (n, n) lie strictly inside the unit circle, or None.

    None is undecided. For two eigenvalues trace and determinant decide. Else the answer is True if
    some power has a norm below 1, and False if the trace of one exceeds n in absolute value.
    """
    from flint import arb

    size, power = mapping.nrows(), mapping
    if size == 2:
        trace = trace_of(mapping)
        product = mapping[0, 0] * mapping[1, 1] - mapping[0, 1] * mapping[1, 0]
        ahead, behind = 1 - trace + product, 1 + trace + product
        if ahead > 0 and behind > 0 and product < 1:
            return True
        if ahead < 0 or behind < 0 or abs(product) > 1:
            return False
    for _ in range(_MOST_SQUARINGS):
        entries = range_of(power).entries()
        if not all(x.is_finite() for x in entries):
            return None
        rows = [
            sum((abs(x) for x in entries[i * size : (i + 1) * size]), arb(0)) for i in range(size)
        ]
        if all(row < 1 for row in rows):
            return True
        if abs(trace_of(power)) > size:
            return False
        power = power * power
    return None


def neutral_pairs(section: arb_mat, trace: arb) -> tuple[bool | None, tuple[acb, ...] | None]:
    """Decide whether the pairs of a symplectic map lie on the unit circle, apart from each other.

    The section map (N, N) has one multiplier 1, one that is 0, and pairs m, 1/m. It is neutral
    where every m + 1/m is proved to be real and inside (-2, 2); with one pair m + 1/m is its trace
    minus 1. The verdict, None if undecided, comes with both multipliers of each pair where these
    are known.
    """
    from flint import acb, acb_poly, arb_poly

    size = section.nrows()
    if size == 2:
        return True, ()
    if size == 4:
        sums = [acb(trace - 1)]
    else:
        coefficients = section.charpoly().coeffs()
        quotient = arb_poly(_divided(coefficients[1:]))
        try:
            sums = acb_poly(_of_sums(quotient)).roots()
        except ValueError:
            return None, None
    found: list[acb] = []
    verdict: bool | None = True
    for place, total in enumerate(sums):
        root = (total * total / 4 - 1).sqrt()
        others = (*sums[:place], *sums[place + 1 :])
        # the conjugate is a root too: where it is in no other ball it is this one, and real
        if total.imag.contains(0) and not any(total.conjugate().overlaps(x) for x in others):
            half = total.real / 2
            if abs(half) < 1:
                height = (1 - half * half).sqrt()
                found += [acb(half, height), acb(half, -height)]
                continue
            if not abs(half) > 1:
                return None, None
            root = acb((half * half - 1).sqrt())
        verdict = False
        larger = total / 2 + (root if (total / 2).real * root.real > 0 else -root)
        found += [larger, 1 / larger]
    return verdict, tuple(found)


def apart(multipliers: Sequence[acb], size: int, *, trivial: bool) -> tuple[acb, ...]:
    """Return the multipliers that are clearly simple roots of the map's characteristic polynomial.

    The polynomial's slope at a root is the product of the distances to the other roots: to a
    `trivial` multiplier 1, where there is one, and to zero, which all the rest are. The checker
    cannot tell apart roots that are too near. `size` is the dimension of the map.
    """
    from flint import acb

    known = [*multipliers, *([acb(1)] if trivial else [])]
    known += [acb(0)] * (size - len(known))
    found = []
    for place, multiplier in enumerate(multipliers):
        slope = acb(1)
        for other in (*known[:place], *known[place + 1 :]):
            slope *= multiplier - other
        if abs(slope) > _LEAST_SLOPE:
            found.append(multiplier)
    return tuple(found)


def others_below(section: arb_mat, known: Sequence[acb]) -> float:
    """Return an approximate bound on the absolute values of all eigenvalues but the known ones.

    The characteristic polynomial of the section map (n, n), divided by the known simple roots, has
    roots no larger than twice the largest k-th root of its k-th coefficient (M. Fujiwara, Tohoku
    Math. J. 10, 1916). The bound is zero where all are known.
    """
    from flint import acb

    quotient = [acb(x) for x in reversed(section.charpoly().coeffs())]
    for root in known:
        carried, kept = acb(0), quotient[:-1]
        quotient = []
        for coefficient in kept:
            carried = coefficient + root * carried
            quotient.append(carried)
    sizes = (float(abs(x).abs_upper()) ** (1 / k) for k, x in enumerate(quotient[1:], 1))
    return 2 * max(sizes, default=0.0)


def _divided(coefficients: Sequence[arb]) -> list[arb]:
    """Return the coefficients of a polynomial with the root 1 divided by x - 1."""
    found: list[Any] = []
    carried = 0 * coefficients[-1]
    for coefficient in reversed(coefficients[1:]):
        carried = carried + coefficient
        found.append(carried)
    return found[::-1]


def _of_sums(polynomial: arb_poly) -> arb_poly:
    """Return a reciprocal polynomial of degree 2m as one of degree m in x + 1/x."""
    from flint import arb_poly

    coefficients = polynomial.coeffs()
    half = len(coefficients) // 2
    before, power = arb_poly([2]), arb_poly([0, 1])
    total = arb_poly([coefficients[half]])
    for k in range(1, half + 1):
        total = total + power * coefficients[half + k]
        before, power = power, arb_poly([0, 1]) * power - before
    return total


def _tangent(
    invariants: Invariants, forced: Sequence[int], size: int
) -> tuple[list[int], list[list[Any]]]:
    """Return the free coordinates of a section and the basis (N, free) of its tangent space.

    The column of a free coordinate is the change of all coordinates with it.
    """
    from flint import fmpq

    rows = [(*row[:-1], fmpq(0)) for row in invariants.rows]
    rows += [tuple(fmpq(int(j == k)) for j in range(size + 1)) for k in forced]
    kept = Invariants.of(rows)
    free = [k for k in range(size) if k not in kept.pivots]
    basis = [[fmpq(int(i == k)) for k in free] for i in range(size)]
    for row, pivot in zip(kept.rows, kept.pivots, strict=True):
        basis[pivot] = [-row[k] for k in free]
    return free, basis


def product_of(maps: Sequence[Any]) -> Any:
    """Return the product of maps (N, N) that act one after the other: the last one stands first."""
    product = maps[0]
    for behind in maps[1:]:
        product = behind * product
    return product


def trace_of(square: Any) -> Any:
    """Return the sum of the diagonal of a square matrix."""
    from flint import arb

    return sum((square[k, k] for k in range(square.nrows())), arb(0))


def eigenvalues_of(square: arb_mat) -> tuple[acb, ...] | None:
    """Return all eigenvalues of a matrix (n, n), or None if the balls do not tell them apart."""
    from flint import acb, acb_mat

    if square.nrows() == 1:
        return (acb(square[0, 0]),)
    if square.nrows() == 2:
        half, product = trace_of(square) / 2, square.det()
        apart = half * half - product
        if apart > 0:
            return acb(half + apart.sqrt()), acb(half - apart.sqrt())
        if apart < 0:
            height = (-apart).sqrt()
            return acb(half, height), acb(half, -height)
        return None
    try:
        return tuple(acb_mat(square).eig())
    except ValueError:
        return None
