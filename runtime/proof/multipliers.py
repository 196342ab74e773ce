"""On which side of the unit circle the multipliers of an orbit are proved to be."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.matrix_chains import along_chain
from nonsmooth.runtime.core.taylor_models import matrix, middle_of, range_of
from nonsmooth.runtime.proof.exact_closure import ClosureConditions
from nonsmooth.runtime.proof.exact_tables import Number, numbers
from nonsmooth.runtime.proof.invariants import CycleInvariants
from nonsmooth.runtime.proof.motion.exact_rows import Invariants
from nonsmooth.runtime.proof.orbit_to_prove import NotCovered
from nonsmooth.runtime.shooting.translations import gauges_of

if TYPE_CHECKING:
    from flint import arb, arb_mat, arb_poly

__all__ = [
    "check_pair",
    "determinant",
    "inside_circle",
    "on_circle",
    "pair_products",
    "product_of",
    "reduced_map",
    "trace_of",
]

_MOST_SQUARINGS = 48


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


def pair_products(square: Any) -> Any:
    """Return the product of m n - 1 over all pairs of multipliers m, n of a square matrix.

    It is the determinant of the bialternate product minus 1; the matrix is at least 2 by 2.
    """
    pairs = list(combinations(range(square.nrows()), 2))

    def entry(p: int, q: int, r: int, s: int) -> Any:
        product = square[p, r] * square[q, s] - square[p, s] * square[q, r]
        return product - int((p, q) == (r, s))

    return determinant([[entry(*left, *right) for right in pairs] for left in pairs])


def check_pair(found: arb_mat) -> None:
    """Raise `NotCovered` unless no two real eigenvalues of a matrix can have the product 1.

    Such a pair would be a neutral saddle.
    """
    from flint import acb_mat

    try:
        # S. Rump's discs bear wide entries: those of all orbits over a tile
        multipliers = acb_mat(found).eig(algorithm="rump")
    except ValueError:
        raise NotCovered("neimark-sacker: the multipliers cannot be told apart") from None
    for first, second in combinations(multipliers, 2):
        real = first.imag.contains(0) or second.imag.contains(0)
        if real and (first * second).contains(1):
            raise NotCovered("neimark-sacker: the pair may be real")


def determinant(rows: Sequence[Sequence[Any]]) -> Any:
    """Return the determinant by elimination with the largest pivot first.

    So at an event only the last pivot is zero.
    """
    left = [list(row) for row in rows]
    found: Any = None
    while left:
        sizes = {
            (i, j): abs(float(middle_of(x)))
            for i, row in enumerate(left)
            for j, x in enumerate(row)
        }
        i, j = max(sizes, key=lambda place: sizes[place])
        taken = left.pop(i)
        pivot = taken.pop(j) * (-1) ** (i + j)
        found = pivot if found is None else found * pivot
        for row in left:
            factor = row.pop(j) / (pivot * (-1) ** (i + j))
            row[:] = [x - factor * y for x, y in zip(row, taken, strict=True)]
    return found


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


def on_circle(section: arb_mat, trace: arb) -> bool | None:
    """Decide whether the pairs of a symplectic map lie on the unit circle, apart from each other.

    The section map (N, N) has one multiplier 1, one that is 0, and pairs m, 1/m. It is neutral
    where every m + 1/m is proved to be real and inside (-2, 2); with one pair m + 1/m is its trace
    minus 1. None is undecided.
    """
    from flint import acb, acb_poly, arb_poly

    size = section.nrows()
    if size == 2:
        return True
    if size == 4:
        sums = [acb(trace - 1)]
    else:
        coefficients = section.charpoly().coeffs()
        quotient = arb_poly(_divided(coefficients[1:]))
        try:
            sums = acb_poly(_of_sums(quotient)).roots()
        except ValueError:
            return None
    verdict = True
    for place, total in enumerate(sums):
        others = (*sums[:place], *sums[place + 1 :])
        if total.imag.contains(0):
            # the conjugate is a root too: where it is in no other ball it is this one, and real
            if any(total.conjugate().overlaps(x) for x in others):
                return None
            if abs(total.real) < 2:
                continue
            if not abs(total.real) > 2:
                return None
        verdict = False
    return verdict


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
