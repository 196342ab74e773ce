"""The check of cone conditions along coverings.

For a covering of M by N the file states a box S in N. Of each part of N outside of S it is shown
that its image does not meet M, and of the parts in S the derivative is enclosed, in the
coordinates of N and M. For all matrices V between the least and the largest entries

    V^T Q_M V - m Q_N is positive definite

at the two rates m that are stated (Zgliczynski 2009): the form is diagonalised as far as V_uu
tells, and the rest is positive by Sylvester's minors.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple, Protocol

from flint import arb, arb_mat, fmpq

from nonsmooth.runtime.checker.state_sets.section_maps import Box, divided
from nonsmooth.runtime.checker.state_sets.sets import StateSet, TooWide
from nonsmooth.runtime.checker.stated.exact import demand, exact

_FINEST = fmpq(1, 2**22)
SPREADS = (1.0, 0.4, 0.2, 0.1, 0.05)  # of a derivative, against what stretches

Matrix = list[list[Any]]


class MappedSet(Protocol):
    """A set that is mapped part by part, and seen in the coordinates of those that it covers."""

    def image(self, box: Box) -> StateSet:
        """Return (coordinates, 1) of a part's image, with derivatives, or raise `TooWide`."""

    def seen(self, target: str, image: StateSet) -> StateSet:
        """Return an image in the coordinates of a target."""

    def lengths(self, box: Box) -> list[float]:
        """Return approximate lengths of the sides of a part."""


class _MappedPart(NamedTuple):
    box: Box
    image: Any
    slopes: dict[str, Matrix]


def check_cones(
    cones: dict[str, Any],
    targets: Mapping[str, Sequence[str]],
    mapped: Callable[[str], MappedSet],
    size: int,
    iterates: int,
) -> None:
    """Prove again the cone condition that a file states for its coverings.

    `targets` says which sets each set covers, `mapped` gives the sets by name, `size` is the
    dimension of the section, and `iterates` the number k of the map's iterates.
    """
    forms = {name: [*map(exact, form)] for name, form in cones["forms"].items()}
    demand(forms.keys() == targets.keys(), "cones of other sets")
    fits = all(len(form) == size and all(x > 0 for x in form) for form in forms.values())
    demand(fits, "a form has a positive number for each coordinate")
    strips: dict[tuple[str, str], Box] = {}
    for source, target, entries in cones["strips"]:
        demand((source, target) not in strips, "a strip is there twice")
        box = tuple((exact(a), exact(b)) for a, b in entries)
        inside = len(box) == size and all(-1 <= a < b <= 1 for a, b in box)
        demand(inside, "a strip is no box in its set")
        strips[source, target] = box
    pairs = {(name, other) for name, others in targets.items() for other in others}
    demand(strips.keys() == pairs, "strips of other coverings")
    rates = check_rates(cones, size, iterates)
    for name, others in targets.items():
        own = Derivatives(name, mapped(name), {other: strips[name, other] for other in others})
        for spread in SPREADS:
            proved = all(
                positive(hull, forms[other], forms[name], rate)
                for other, hull in own.hulls(spread).items()
                for rate in rates
            )
            if proved:
                break
        demand(proved, f"the cone condition of {name} is not proved")


def check_rates(cones: Mapping[str, Any], size: int, iterates: int) -> list[Any]:
    """Return the rates that are stated; `Failure` unless the exponent follows from them."""
    expansion, contraction = exact(cones["expansion"]), exact(cones["contraction"])
    demand(expansion > 1, "cones that do not grow")
    demand(0 <= contraction < 1 and bool(contraction) == (size > 1), "cones that do not shrink")
    exponent = exact(cones["exponent"])
    demand(exponent > 0, "no positive exponent")
    least = arb(expansion).log() / (2 * iterates)
    demand(least >= arb(exponent), "the exponent is larger than what follows")
    return [expansion, *([contraction] if size > 1 else [])]


class Derivatives:
    """The derivatives of a map over strips of one set, part by part.

    `strips` has for each target a box of the set. `Failure` is raised where it is not shown that
    all states that are mapped into the target lie in it.
    """

    def __init__(self, name: str, mapped: MappedSet, strips: Mapping[str, Box]) -> None:
        self._name, self._mapped, self._strips = name, mapped, strips
        self._parts: list[_MappedPart] = []
        first = next(iter(strips.values()))
        self._waiting: list[Box] = [((fmpq(-1), fmpq(1)),) * len(first)]

    def hulls(self, spread: float) -> dict[str, Matrix]:
        """Return for each target balls that contain the derivative at every state of the strip.

        Parts are divided until the derivative varies by no more than a spread over each.
        """
        parts, waiting, mapped, strips = self._parts, self._waiting, self._mapped, self._strips
        for part in parts:
            if _spread(part) > spread:
                waiting += divided(part.box, _longest(mapped, part))
        parts = [part for part in parts if _spread(part) <= spread]
        while waiting:
            box = waiting.pop()
            border = _border(box, strips.values())
            if border is not None:
                waiting += divided(box, *border)
                continue
            found, part = _looked_at(mapped, box, strips)
            if found and _spread(part) <= spread:
                parts.append(part)
                continue
            wide = max(b - a for a, b in box)
            demand(wide > _FINEST, f"what {self._name} is stretched by is not proved")
            waiting += divided(box, _longest(mapped, part))
        self._parts = parts
        return {
            other: _hull([part.slopes[other] for part in parts if other in part.slopes])
            for other in strips
        }


def _looked_at(mapped: MappedSet, box: Box, strips: Mapping[str, Box]) -> tuple[bool, _MappedPart]:
    """Return whether a part's image avoids those targets in whose strips the part does not lie.

    The part is returned with its derivatives to the targets in whose strips it lies. A part whose
    image is not shown counts as not avoiding.
    """
    try:
        image = mapped.image(box)
    except TooWide:
        return False, _MappedPart(box, None, {})
    away, slopes = True, {}
    for other, strip in strips.items():
        seen = mapped.seen(other, image)
        if all(c <= a and b <= d for (a, b), (c, d) in zip(box, strip, strict=True)):
            columns = [tangent.hull.entries() for tangent in seen.tangents]
            slopes[other] = [[*row] for row in zip(*columns, strict=True)]
        else:
            away &= any(x > 1 or x < -1 for x in seen.hull.entries())
    return away, _MappedPart(box, image, slopes)


def _border(box: Box, strips: Any) -> tuple[int, Any] | None:
    """Return a coordinate and the strip's border there that cuts a box; None if none does."""
    for strip in strips:
        if any(b <= c or d <= a for (a, b), (c, d) in zip(box, strip, strict=True)):
            continue
        for k, ((a, b), ends) in enumerate(zip(box, strip, strict=True)):
            for end in ends:
                if a < end < b:
                    return k, end
    return None


def _longest(mapped: MappedSet, part: _MappedPart) -> int:
    """Return the coordinate along which the part and its image together are longest."""
    lengths = mapped.lengths(part.box)
    if part.image is not None:
        moved = part.image.sides.tolist()
        lengths = [
            own + sum(abs(float(row[k].mid())) for row in moved) for k, own in enumerate(lengths)
        ]
    return max(range(len(lengths)), key=lengths.__getitem__)


def _spread(part: _MappedPart) -> float:
    """Return the largest sum of a derivative's radii, relative to its unstable entry."""
    largest = 0.0
    for matrix in part.slopes.values():
        size = abs(float(matrix[0][0].mid()))
        radii = sum(float(x.rad()) for row in matrix for x in row)
        largest = max(largest, radii / size if radii < 1e9 * size else float("inf"))
    return largest


def _hull(matrices: list[Matrix]) -> Matrix:
    """Return balls that contain the entries of all these matrices."""
    demand(matrices, "a strip has no part")
    first, *others = matrices
    found = [[*row] for row in first]
    for matrix in others:
        found = [
            [x.union(y) for x, y in zip(a, b, strict=True)]
            for a, b in zip(found, matrix, strict=True)
        ]
    return found


def positive(matrix: Matrix, behind: Sequence[Any], before: Sequence[Any], rate: Any) -> bool:
    """Return whether V^T Q_M V - m Q_N is positive definite for all V in balls.

    Sylvester's minors are taken in the basis of the columns of C = ((1/V_uu, -V_us/V_uu), (0, 1)),
    where V C has the first row (1, 0).
    """
    first, size = matrix[0], len(matrix)
    if not (first[0] > 0 or first[0] < 0):
        return False
    turned = [[arb(int(i == j)) for j in range(size)] for i in range(size)]
    turned[0] = [1 / first[0], *(-x / first[0] for x in first[1:])]
    moved = [[arb(int(j == 0)) for j in range(size)]]
    for row in matrix[1:]:
        share = row[0] / first[0]
        rest = [x - share * y for x, y in zip(row[1:], first[1:], strict=True)]
        moved.append([share, *rest])
    one = [arb(x if k == 0 else -x) for k, x in enumerate(behind)]
    other = [arb(rate * (x if k == 0 else -x)) for k, x in enumerate(before)]

    def entry(i: int, j: int) -> Any:
        found = arb(0)
        for k in range(size):
            found += one[k] * moved[k][i] * moved[k][j] - other[k] * turned[k][i] * turned[k][j]
        return found

    whole = [[entry(i, j) for j in range(size)] for i in range(size)]
    minors = (arb_mat([row[:k] for row in whole[:k]]).det() for k in range(1, size + 1))
    return all(minor > 0 for minor in minors)
