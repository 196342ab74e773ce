"""Chaos: covering relations of sets on a section, and the symbolic dynamics that follows.

N covers M if the map is continuous on N, its image meets no stable side of M, and the images of
the unstable sides of N lie beyond opposite unstable sides of M (Zgliczynski and Gidea 2004, theorem
16, for one unstable direction). The transitions on the way are stated; each set is divided until
its parts are shown to take them.
"""

from collections.abc import Callable, Hashable, Mapping, Sequence
from fractions import Fraction
from functools import partial
from typing import Any, NamedTuple, TypeVar

from flint import arb, ctx, fmpq

from nonsmooth.runtime.checker.state_sets.cones import check_cones
from nonsmooth.runtime.checker.state_sets.section_maps import (
    Box,
    Parallelepiped,
    SectionMap,
    divided,
)
from nonsmooth.runtime.checker.state_sets.sets import StateSet, TooWide
from nonsmooth.runtime.checker.stated.exact import demand, exact
from nonsmooth.runtime.checker.stated.shape import check_bits, check_file

_Vertex = TypeVar("_Vertex", bound=Hashable)

_BITS = 80
_FINEST = fmpq(1, 2**22)  # of a set: narrower parts are not tried
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
        self, content: Mapping[str, Any], most: int, progress: Callable[[], object] = lambda: None
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
                    moved = image.sides.tolist()
                    weights = [
                        sum(abs(float(row[k].mid())) for row in moved) for k in range(len(box))
                    ]
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


def check_chaos(content: dict[str, Any]) -> None:
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


def check_entropy(content: Mapping[str, Any], sets: StretchedSets) -> dict[str, list[str]]:
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
