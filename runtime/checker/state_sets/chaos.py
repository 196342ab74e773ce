"""Chaos: covering relations of sets on a section, and the symbolic dynamics that follows.

N covers M if the map is continuous on N, its image meets no stable side of M, and the images of the
unstable sides of N lie beyond opposite unstable sides of M (Zgliczynski and Gidea 2004, theorem 16,
for one unstable direction). The transitions on the way are stated; each set is divided until its
parts are shown to take them.

For a cone condition the file states, for a covering of M by N, a box S in N. Of each part of N
outside of S it is shown that its image does not meet M, and of the parts in S the derivative is
enclosed, in the coordinates of N and M. For all matrices V between the least and the largest
entries

    V^T Q_M V - m Q_N is positive definite

at the two rates m that are stated (Zgliczynski 2009): the form is diagonalised as far as V_uu
tells, and the rest is positive by Sylvester's minors.
"""

from collections.abc import Callable, Hashable, Mapping, Sequence
from fractions import Fraction
from functools import partial
from typing import Any, NamedTuple, Protocol, TypeVar

from flint import arb, arb_mat, ctx, fmpq

from nonsmooth.runtime.checker.state_sets.one_way import (
    Box,
    Parallelepiped,
    SectionMap,
    divided,
)
from nonsmooth.runtime.checker.state_sets.sets import StateSet, TooWide
from nonsmooth.runtime.checker.stated.exact import Entries, Numbers, demand, exact
from nonsmooth.runtime.checker.stated.shape import check_bits, check_file

_FINEST = fmpq(1, 2**22)  # of a set: narrower parts are not tried
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
    cones: Entries,
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


def check_rates(cones: Entries, size: int, iterates: int) -> list[Any]:
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
        both = zip(lengths, part.image.lengths, strict=False)
        lengths = [own + moved for own, moved in both]
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


def positive(matrix: Matrix, behind: Numbers, before: Numbers, rate: Any) -> bool:
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


_Vertex = TypeVar("_Vertex", bound=Hashable)

_BITS = 80
_MORE = 8  # times the parts that the file states
_PARTS, _SETS, _ITERATES = 10**5, 32, 64  # that a file may state at most
_ROUNDS = 300  # of the powers of a matrix


class Covered(NamedTuple):
    """The sets that are shown to be covered by the image of one."""

    targets: tuple[str, ...]
    parts: tuple[StateSet, ...]  # what contains the image of each part
    reasons: dict[str, str]  # why other sets are not shown to be covered


class StretchedSets:
    """Sets on a section, each with the way from it to its image.

    `content` has the entries of a file that state the system, the section, `h_sets` and
    `itineraries`. At most `most` images of parts are enclosed, of all sets together; `progress` is
    called for each.
    """

    def __init__(
        self, content: Entries, most: int, progress: Callable[[], object] = lambda: None
    ) -> None:
        self.map, self.left, self._progress = SectionMap(content), most, progress
        entries, size = content["h_sets"], len(self.map.free)
        demand(len({entry["name"] for entry in entries}) == len(entries), "two sets of one name")
        self.sets = {entry["name"]: Parallelepiped(entry, size) for entry in entries}
        self.ways = content["itineraries"]
        demand(self.ways.keys() == self.sets.keys(), "the ways of other sets")
        for way in self.ways.values():
            self.map.check_way(way)

    def image(self, name: str, box: Box, *, sloped: bool = False) -> StateSet:
        """Return (coordinates, 1) of the image of a part of a set; see `SectionMap.image`."""
        self.left -= 1
        demand(self.left >= 0, f"{name} has too many parts")
        self._progress()
        return self.map.image(self.sets[name], box, self.ways[name], sloped=sloped)

    def check_apart(self) -> None:
        """Demand that no two sets have a point in common."""
        names = [*self.sets]
        for k, one in enumerate(names):
            for other in names[:k]:
                found = self.sets[one].apart(self.sets[other])
                found = found or self.sets[other].apart(self.sets[one])
                demand(found, f"{one} and {other} may have a point in common")

    def covered(self, name: str, targets: Sequence[str]) -> Covered:
        """Return which of these sets a set covers; `Failure` if its image is not enclosed."""
        own, reasons = self.sets[name], dict[str, str]()
        beyond: dict[str, set[int]] = {target: set() for target in targets}
        for end in own.whole[0]:
            signs: dict[str, set[int]] = {target: set() for target in targets}
            parts = self._images(name, ((end, end), *own.whole[1:]), targets, reasons, side=True)
            for target in targets:
                for image in parts:
                    signs[target].add(1 if self.sets[target].seen(image)[0] > 1 else -1)
                if target not in reasons and len(signs[target]) != 1:
                    reasons[target] = "one of its ends is mapped to both sides of it"
                beyond[target] |= signs[target]
        for target in targets:
            if target not in reasons and len(beyond[target]) != 2:
                reasons[target] = "its ends are mapped to one side of it"
        images = self._images(name, own.whole, targets, reasons, side=False)
        found = tuple(target for target in targets if target not in reasons)
        return Covered(found, tuple(images), reasons)

    def _images(
        self, name: str, whole: Box, targets: Sequence[str], reasons: dict[str, str], *, side: bool
    ) -> list[StateSet]:
        """Return images of parts of a set that are beyond its targets, or between stable sides.

        Of targets of which that is not shown the reason is added.
        """
        boxes, found = [whole], []
        while boxes and len(reasons) < len(targets):
            box, image = boxes.pop(), None
            lengths = [b - a for a, b in box]
            final = max(lengths) <= _FINEST
            try:
                image = self.image(name, box)
            except TooWide:
                demand(not final, f"what {name} covers is not proved")
            wrong = [
                target
                for target in targets
                if target not in reasons
                and (image is None or not _placed(self.sets[target].seen(image), side))
            ]
            if final:
                where = (
                    "a side of it is not mapped beyond it" if side else "it comes to a stable side"
                )
                reasons |= dict.fromkeys(wrong, where)
            elif wrong:
                weights = self.sets[name].lengths(box)
                if image is not None:
                    weights = image.lengths
                usable = [k for k, length in enumerate(lengths) if length > _FINEST]
                boxes += divided(box, max(usable, key=weights.__getitem__))
                continue
            if image is not None:
                found.append(image)
        return found


class SetMap:
    """One set that is mapped with derivatives, and seen in those that it covers."""

    def __init__(self, owner: StretchedSets, name: str) -> None:
        self._owner, self._name = owner, name
        self.lengths = owner.sets[name].lengths

    def image(self, box: Box) -> StateSet:
        """Return (coordinates, 1) of a part's image, with derivatives; see `SectionMap.image`."""
        return self._owner.image(self._name, box, sloped=True)

    def seen(self, target: str, image: StateSet) -> StateSet:
        """Return an image in the coordinates of a target."""
        return image.through(self._owner.sets[target].inward)


def check_chaos(content: Entries) -> None:
    """Prove the symbolic dynamics of a file again; `Failure` names a claim that is not proved.

    `Malformed` is raised if the file, read as JSON, has another shape.
    """
    check_file(content, "nonsmooth chaos certificate")
    check_bits(content)
    if content["claim"] != "proved":
        told = ("configuration", "phase", "source", "boundary", "coordinates", "h_sets")
        more = ("coverings", "itineraries", "declaration", "iterates")
        demand(not any(content[name] for name in (*told, *more)), "numbers of no claim")
        demand(content["growth"] == content["entropy"] == "0", "an entropy of no claim")
        demand(not content["parts"], "parts of no claim")
        demand(content.get("cones") is None, "cones of no claim")
        return
    demand(not content["reason"], "a reason why it is not proved")
    demand(0 < content["parts"] <= _PARTS, "no such number of parts")
    demand(len(content["h_sets"]) <= _SETS, "more sets than a horseshoe has")
    demand(content["iterates"] <= _ITERATES, "too many iterates of the map")
    with ctx.workprec(_BITS):
        sets = StretchedSets(content, _MORE * content["parts"])
        targets = check_entropy(content, sets)
        sets.check_apart()
        for name, others in targets.items():
            found = sets.covered(name, others)
            for target, reason in found.reasons.items():
                demand(False, f"{name} does not cover {target}: {reason}")
        if content.get("cones") is not None:
            size = len(sets.map.free)
            check_cones(content["cones"], targets, partial(SetMap, sets), size, sets.map.iterates)


def _placed(seen: list[Any], side: bool) -> bool:
    """Return whether an image lies beyond a set or, unless of a side, between its stable sides."""
    unstable, *stable = seen
    beyond = bool(unstable > 1 or unstable < -1)
    return beyond or (not side and all(abs(x) < 1 for x in stable))


def check_entropy(content: Entries, sets: StretchedSets) -> dict[str, list[str]]:
    """Demand that the graph of the coverings has no less growth and entropy than is stated.

    The result says which sets each one is stated to cover.
    """
    pairs = [tuple(pair) for pair in content["coverings"]]
    demand(len({*pairs}) == len(pairs), "a covering is there twice")
    demand(all({*pair} <= sets.sets.keys() for pair in pairs), "a covering of no set")
    targets = {name: [m for n, m in pairs if n == name] for name in sets.sets}
    told = exact(content["growth"])
    demand(told > 1, "a graph that does not grow")
    radius = fmpq(*radius_above(targets).as_integer_ratio())
    demand(told <= radius, "the graph grows less than stated")
    entropy = exact(content["entropy"])
    demand(entropy > 0, "no positive entropy")
    growth = arb(told).log() / content["iterates"]
    demand(growth >= arb(entropy), "the entropy is larger than what follows")
    return targets


def radius_above(targets: Mapping[_Vertex, list[_Vertex]]) -> Fraction:
    """Return a lower bound of the spectral radius of a strongly connected graph, by its edges.

    For a matrix A of integers that are not negative, irreducible, and positive v it is the least
    (A v)_i / v_i (L. Collatz, 1942; H. Wielandt, 1950). Here v is a power of 1 + A times 1.
    """
    sources = {name: [n for n, others in targets.items() if name in others] for name in targets}
    for ahead in (targets, sources):
        reached, left = set[_Vertex](), [*targets][:1]
        while left:
            reached.add(name := left.pop())
            left += {*ahead[name]} - reached
        demand(reached == targets.keys(), "a set is on no way from each of the others to each")
    weights = dict.fromkeys(targets, 1)
    for _ in range(_ROUNDS):
        weights = {n: w + sum(weights[m] for m in targets[n]) for n, w in weights.items()}
    return min(Fraction(sum(weights[m] for m in targets[n]), w) for n, w in weights.items())
