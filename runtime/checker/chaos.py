"""The check of chaos: covering relations of sets on a section, each proved again.

N covers M if the map is continuous on N, its image meets no stable side of M, and the images of
the unstable sides of N lie beyond opposite unstable sides of M (Zgliczynski and Gidea 2004). Here
the transitions on the way are those that the file states; each set is divided until its parts
are shown to take them.
"""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import partial
from typing import Any, NamedTuple

from flint import arb, arb_mat, ctx, fmpq, fmpq_mat

from nonsmooth.runtime.checker.cones import check_cones
from nonsmooth.runtime.checker.exact import (
    Elimination,
    Failure,
    check_sum,
    demand,
    exact,
    leading,
    number_of,
    reduced,
)
from nonsmooth.runtime.checker.parameters import values_of
from nonsmooth.runtime.checker.sets import CarryingPhase, StateSet, TooWide, matrix_of
from nonsmooth.runtime.checker.shape import CHAOS, check_bits, check_shape

__all__ = ["Box", "SectionMotions", "SectionPart", "check_chaos"]

_BITS = 80
_FINEST = fmpq(1, 2**22)  # of a set: narrower parts are not tried
_MORE = 8  # times the parts that the file states
_PARTS, _SETS, _ITERATES = 10**5, 32, 64  # that a file may state at most
_ROUNDS = 300  # of the powers of a matrix

Box = tuple[tuple[Any, Any], ...]


def check_chaos(content: dict[str, Any]) -> None:
    """Prove the symbolic dynamics of a file again; `Failure` names a claim that is not proved.

    `Malformed` is raised if the file, read as JSON, has another shape.
    """
    check_shape(content, CHAOS)
    check_sum(content)
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
        motions = SectionMotions(content, _MORE * content["parts"])
        _check_entropy(content, motions.targets)
        _check_apart(motions.sets)
        for name in motions.sets:
            _check_coverings(motions, name)
        if content.get("cones") is not None:
            size = len(motions.free)
            own = partial(SectionPart, motions)
            check_cones(content["cones"], motions.targets, own, size, motions.iterates)


class _Set(NamedTuple):
    """An h-set: a parallelepiped in the section's coordinates, with exact centre and sides.

    The matrix `inward` leads from (coordinates, 1) to the set's coordinates, from -1 to 1.
    """

    centre: list[Any]
    sides: list[list[Any]]
    inward: Any

    def seen(self, image: StateSet) -> list[Any]:
        """Return balls around the set's coordinates of an image, a set of (coordinates, 1)."""
        found: list[Any] = image.through(self.inward).hull.entries()
        return found

    def lengths(self, box: Box) -> list[float]:
        """Return approximate lengths of the sides of a part of the set."""
        return [
            float(b - a) / 2 * sum(abs(float(x.p) / float(x.q)) for x in own)
            for (a, b), own in zip(box, self.sides, strict=True)
        ]


class SectionMotions:
    """The system, section, h-sets and itineraries of a file, in exact numbers.

    `content` holds the entries of a certificate of chaos that state these. At most `most` images of
    parts may be computed, of all sets together.
    """

    def __init__(self, content: dict[str, Any], most: int) -> None:
        self.left = most
        declared = content["declaration"]
        demand("law" not in declared, "coverings with a contact law are not checked")
        values, stated, constants = values_of(
            content["parameters"], (), declared.get("constants", [])
        )
        demand(not constants, "a parameter is not rational")
        names = declared["parameters"]
        bound = sorted(names) == sorted(values)
        demand(bound, "the declaration is not over the parameters that are named")
        self.variables = [*(values[name] for name in names), *stated]
        self.size, self.exactly = len(declared["states"]), Elimination()
        self.states, self.forcing = declared["states"], declared["forcing"]
        demand(len({*self.states}) == self.size, "two states have one name")
        zero = (fmpq(0),) * self.size
        self.fields: dict[str, Any] = {}
        self.phases: dict[str, CarryingPhase] = {}
        self.held: dict[str, Any] = {}
        for name, entry in declared["configurations"].items():
            self.fields[name] = [*self._rows(entry["field"]), (*zero, fmpq(0))]
            rows = {boundary: self._row(row) for boundary, row in entry["boundaries"].items()}
            self.phases[name] = CarryingPhase(self.fields[name], rows)
            self.held[name] = [*map(self._row, entry["held"])]
        self.transitions: dict[tuple[str, str], list[Any]] = {}
        for entry in declared["transitions"]:
            demand("order" not in entry and "steps" not in entry, "a transition of another kind")
            demand(len(entry["boundaries"]) == 1, "boundaries that are reached together")
            reset = [*self._rows(entry["reset"]), (*zero, fmpq(1))]
            conditions = [(self._row(r), along, holds) for r, along, holds in entry["conditions"]]
            demand(all(a in self.fields for _, a, _ in conditions), "a configuration is missing")
            key = entry["source"], entry["boundaries"][0]
            found = conditions, reset, matrix_of(reset, runs=False), entry["target"]
            self.transitions.setdefault(key, []).append(found)
        self.here, self.iterates = content["configuration"], content["iterates"]
        demand(self.here in self.fields, "the section's configuration is not declared")
        demand(self.iterates > 0, "no iterate of the map")
        self.section = content["source"], content["boundary"], self.here
        self.facts = self._facts(content)
        pivots = {next(k for k, x in enumerate(row) if x) for row in self.facts}
        demand(self.size not in pivots, "the section is empty")
        self.free = [k for k in range(self.size) if k not in pivots]
        named = [self.states[k] for k in self.free]
        demand(content["coordinates"] == named, "the coordinates are not those of the section")
        self.sets = dict(self._sets(content["h_sets"]))
        self.ways = content["itineraries"]
        demand(self.ways.keys() == self.sets.keys(), "the ways of other sets")
        pairs = [tuple(pair) for pair in content["coverings"]]
        demand(len({*pairs}) == len(pairs), "a covering is there twice")
        demand(all({*pair} <= self.sets.keys() for pair in pairs), "a covering of no set")
        self.targets = {name: [m for n, m in pairs if n == name] for name in self.sets}
        for way in self.ways.values():
            self._check_way(way)

    def _check_way(self, way: list[list[str]]) -> None:
        """Demand that an itinerary leads from the section to itself, by declared transitions."""
        here, passed = self.here, 0
        for source, boundary, target in way:
            demand(source == here, "a way does not lead from configuration to configuration")
            demand((source, boundary) in self.transitions, "no such transition")
            known = boundary in self.phases[source].rows
            demand(known, f"{source} has no boundary {boundary}")
            demand(target in self.fields, "a configuration is not declared")
            here = target
            passed += (source, boundary, target) == self.section
        if not self.forcing:
            last = tuple(way[-1]) if way else ()
            back = passed == self.iterates and last == self.section
            demand(back, "a way does not lead back to the section")
        demand(here == self.here, "a way does not lead back to the section")

    def _row(self, entries: list[Any]) -> tuple[Any, ...]:
        demand(len(entries) == self.size + 1, "a row of another size")
        found = tuple(number_of(entry, self.variables) for entry in entries)
        demand(all(isinstance(x, fmpq) for x in found), "the declaration is not rational")
        return found

    def _rows(self, entries: list[Any]) -> list[Any]:
        demand(len(entries) == self.size, "a matrix of another size")
        return [*map(self._row, entries)]

    def _facts(self, content: dict[str, Any]) -> Any:
        """Return reduced rows that are zero on the section; check that a forcing returns."""
        if not self.forcing:
            source, boundary, target = self.section
            demand(not content["phase"], "a phase of no forcing")
            demand((source, boundary) in self.transitions, "no such transition")
            ways = [way for way in self.transitions[source, boundary] if way[3] == target]
            demand(ways, "no such transition")
            reached = self.phases[source].rows
            demand(boundary in reached, "no such boundary")
            before = self.exactly.echelon([*self.held[source], reached[boundary]])
            return self._behind(before, ways[0][1])
        demand(not content["source"] and not content["boundary"], "a section of two kinds")
        demand(len(self.forcing) == 1 and len(content["phase"]) == 2, "not one forcing")
        ((c, s),), phase = self.forcing, [*map(exact, content["phase"])]
        demand(c != s and {c, s} <= {*range(self.size)}, "no such forcing")
        demand(phase[0] ** 2 + phase[1] ** 2 == 1, "the phase is no point of the circle")
        unit = [[fmpq(int(j == k)) for j in range(self.size)] for k in range(self.size)]
        speed = self.fields[self.here][s][c]
        demand(speed, "the forcing stands still")
        for field in self.fields.values():
            turned = [[speed * x for x in unit[c]], [-speed * x for x in unit[s]]]
            even = [*map(list, (field[s], field[c]))] == [[*row, fmpq(0)] for row in turned]
            demand(even, "an uneven forcing")
        for _, reset, _, _ in (way for ways in self.transitions.values() for way in ways):
            kept = all(list(reset[k]) == [*unit[k], fmpq(0)] for k in (c, s))
            demand(kept, "a reset forcing")
        self.speed = abs(speed)
        self.forced = [(*unit[k], -x) for k, x in zip((c, s), phase, strict=True)]
        return self.exactly.echelon([*self.forced, *self.held[self.here]])

    def _behind(self, facts: Any, reset: Any) -> Any:
        """Return reduced rows that are zero behind a reset where the facts hold before it."""
        return self.exactly.echelon(
            self.exactly.left_kernel([reduced(row, facts) for row in reset])
        )

    def _sets(self, entries: list[Any]) -> Iterator[tuple[str, _Set]]:
        size = len(self.free)
        demand(size, "the section is one point")
        demand(len({entry["name"] for entry in entries}) == len(entries), "two sets of one name")
        for entry in entries:
            centre, sides = [*map(exact, entry["centre"])], entry["sides"]
            fits = len(centre) == len(sides) == size and all(len(x) == size for x in sides)
            demand(fits, "a set has a centre and as many sides as coordinates")
            rows = [[*map(exact, side)] for side in sides]
            matrix = fmpq_mat(rows).transpose()
            demand(matrix.det() != 0, "the sides of a set are not independent")
            inverse = matrix.inv()
            shift = (inverse * fmpq_mat([[-x] for x in centre])).tolist()
            inward = [[*own, *last] for own, last in zip(inverse.tolist(), shift, strict=True)]
            yield entry["name"], _Set(centre, rows, arb_mat(fmpq_mat(inward)))

    def part(self, name: str, box: Box, sloped: bool) -> StateSet:
        """Return the set of (states, time 0, 1) of a part of an h-set.

        If `sloped`, the set carries tangents along the sides of the h-set.
        """
        own, d = self.sets[name], len(self.free)
        middles = [(a + b) / 2 for a, b in box]
        points = [
            [x + sum((m * side[k] for m, side in zip(middles, own.sides, strict=True)), fmpq(0))]
            + [(b - a) / 2 * side[k] for (a, b), side in zip(box, own.sides, strict=True)]
            for k, x in enumerate(own.centre)
        ]
        states = self._lifted([[*row] for row in zip(*points, strict=True)])
        none = arb_mat(self.size + 2, 1)
        centre, sides = ([row[:1] for row in states], [row[1:] for row in states])
        tangents = []
        for side in own.sides if sloped else ():
            along = self._lifted([[fmpq(0)] * d, side])  # what it changes by from nothing
            change = [[row[1]] for row in along]
            tangents.append(StateSet.of(arb_mat(change), arb_mat(self.size + 2, 0), none))
        return StateSet.of(arb_mat(centre), arb_mat(sides), none, tuple(tangents))

    def _lifted(self, columns: list[list[Any]]) -> list[list[Any]]:
        """Return columns of (states, time 0, 1): the first of a point, the others of directions."""
        given = {next(k for k, x in enumerate(row) if x): row for row in self.facts}
        rows = []
        for k in range(self.size):
            row = []
            for place, column in enumerate(columns):
                if k in given:
                    shares = zip((-given[k][j] for j in self.free), column, strict=True)
                    last = -given[k][-1] if place == 0 else fmpq(0)
                    row.append(sum((x * y for x, y in shares), last))
                else:
                    row.append(column[self.free.index(k)])
            rows.append(row)
        rows.append([fmpq(0) for _ in columns])
        rows.append([fmpq(int(place == 0)) for place in range(len(columns))])
        found: list[list[Any]] = arb_mat(fmpq_mat(rows)).tolist()
        return found

    def image(self, name: str, box: Box, sloped: bool = False) -> StateSet:
        """Return (coordinates, 1) of the image of a part of an h-set; `TooWide` if it is not shown.

        `sloped` asks for derivatives along the sides of the h-set.
        """
        self.left -= 1
        demand(self.left >= 0, f"{name} has too many parts")
        here, facts, states = self.here, self.facts, self.part(name, box, sloped)
        for source, boundary, target in self.ways[name]:
            phase = self.phases[source]
            row = phase.timed(phase.rows[boundary])
            about = phase.guess(states.centre, row)
            arrived, before, after = phase.arrive(states, row, about)
            watched = self._watched(source, facts, states)
            if boundary not in watched:
                raise Failure(f"{boundary} is zero all along {source}")
            phase.clear(states, before, {boundary: watched.pop(boundary)}, boundary)
            phase.clear(states, after, watched)
            lasting = self.exactly.lasting(facts, self.fields[source])
            facts = self.exactly.echelon([*lasting, phase.rows[boundary]])
            reset, matrix = self._taken(source, boundary, target, facts, arrived)
            states, facts, here = arrived.through(matrix), self._behind(facts, reset), target
        if self.forcing:
            states, facts = self._to_phase(here, facts, states)
        demand(all(not any(reduced(row, facts)) for row in self.facts), "off the section")
        return self._coordinates(states)

    def _coordinates(self, states: StateSet) -> StateSet:
        places = [*self.free, self.size + 1]
        parts = (states.centre, states.sides, states.box)
        centre, sides, box = (arb_mat([part.tolist()[k] for k in places]) for part in parts)
        return StateSet(centre, sides, box, tuple(map(self._coordinates, states.tangents)))

    def _to_phase(self, here: str, facts: Any, states: StateSet) -> tuple[StateSet, Any]:
        """Carry states on to where the forcing returns; no boundary may be reached on the way."""
        phase = self.phases[here]
        whole = self.iterates * 2 * arb.pi() / arb(self.speed)
        clock = arb_mat([[*(arb(0) for _ in range(self.size)), arb(1), -whole]])
        left = whole - states.centre[self.size, 0]
        if not left > 0:
            raise TooWide
        arrived, _, after = phase.arrive(states, clock, float(left.mid()))
        phase.clear(states, after, self._watched(here, facts, states))
        lasting = self.exactly.lasting(facts, self.fields[here])
        return arrived, self.exactly.echelon([*lasting, *self.forced])

    def _watched(self, here: str, facts: Any, states: StateSet) -> dict[str, int]:
        """Return the boundaries that are not zero all along, with the order of a derivative.

        It is that of the first derivative at the start that is not exactly zero, which has to be
        negative.
        """
        found = {}
        hull = states.hull.tolist()
        hull.pop(self.size)
        for name, row in self.phases[here].rows.items():
            order, begins = leading(row, self.fields[here], facts, 0)
            if begins is None:
                continue
            if not (arb_mat([[*map(arb, begins)]]) * arb_mat(hull))[0, 0] < 0:
                raise TooWide
            found[name] = order
        return found

    def _taken(
        self, source: str, boundary: str, target: str, facts: Any, states: StateSet
    ) -> tuple[Any, Any]:
        """Return the reset that all states take, exactly and in balls; it leads to the target."""
        hull = states.hull.tolist()
        hull.pop(self.size)
        own = self.phases[source].rows[boundary]
        for conditions, reset, matrix, leads in self.transitions[source, boundary]:
            held = True
            for row, along, holds in conditions:
                order = int(row == own)
                _, begins = leading(row, self.fields[along], facts, order)
                if begins is None:
                    positive = False
                else:
                    value = (arb_mat([[*map(arb, begins)]]) * arb_mat(hull))[0, 0]
                    if not (value > 0 or value < 0):
                        raise TooWide
                    positive = bool(value > 0)
                if positive != holds:
                    held = False
                    break
            if held:
                demand(leads == target, "another transition follows than the file states")
                return reset, matrix
        raise Failure("no transition follows")


class SectionPart:
    """One h-set whose parts are mapped with derivatives; `name` is the set's."""

    def __init__(self, motions: SectionMotions, name: str) -> None:
        self.motions, self.name = motions, name

    def image(self, box: Box) -> StateSet:
        """Return (coordinates, 1) of the image of a part; see `MappedSet`."""
        return self.motions.image(self.name, box, sloped=True)

    def seen(self, target: str, image: StateSet) -> StateSet:
        """Return an image in the coordinates of a target set."""
        return image.through(self.motions.sets[target].inward)

    def lengths(self, box: Box) -> list[float]:
        """Return approximate lengths of the sides of a part."""
        return self.motions.sets[self.name].lengths(box)


def _check_apart(sets: dict[str, _Set]) -> None:
    """Demand that no two h-sets have a point in common."""
    names = [*sets]
    for k, one in enumerate(names):
        for other in names[:k]:
            found = False
            for a, b in ((sets[one], sets[other]), (sets[other], sets[one])):
                size = len(b.centre)
                rows = [[*b.centre, fmpq(1)], *([*side, fmpq(0)] for side in b.sides)]
                columns = arb_mat(fmpq_mat(rows).transpose()).tolist()
                centre, sides = ([r[:1] for r in columns], [r[1:] for r in columns])
                seen = StateSet.of(arb_mat(centre), arb_mat(sides), arb_mat(size + 1, 1))
                found = found or any(x > 1 or x < -1 for x in a.seen(seen))
            demand(found, f"{one} and {other} may have a point in common")


def _check_coverings(motions: SectionMotions, name: str) -> None:
    """Demand that an h-set covers those that the file states."""
    targets, size = motions.targets[name], len(motions.free)
    whole: Box = ((fmpq(-1), fmpq(1)),) * size
    beyond: dict[str, list[int]] = {target: [] for target in targets}
    for end in (fmpq(-1), fmpq(1)):
        signs: dict[str, set[int]] = {target: set() for target in targets}
        for image in _images(motions, name, ((end, end), *whole[1:]), targets, True):
            for target in targets:
                signs[target].add(1 if motions.sets[target].seen(image)[0] > 1 else -1)
        for target in targets:
            demand(len(signs[target]) == 1, f"{name} does not cover {target}")
            beyond[target] += signs[target]
    for target in targets:
        opposite = sum(beyond[target]) == 0
        demand(opposite, f"{name} does not cover {target}: its ends are mapped to one side of it")
    for _ in _images(motions, name, whole, targets, False):
        pass


def _images(
    motions: SectionMotions, name: str, whole: Box, targets: Sequence[str], side: bool
) -> Iterator[StateSet]:
    """Yield images of parts of a set: beyond its targets, or between their stable sides."""
    boxes = [whole]
    while boxes:
        box, image = boxes.pop(), None
        try:
            image = motions.image(name, box)
            good = all(_placed(motions.sets[m].seen(image), side) for m in targets)
        except TooWide:
            good = False
        if good and image is not None:
            yield image
            continue
        lengths = [b - a for a, b in box]
        wide = max(lengths)
        demand(wide > _FINEST, f"what {name} covers is not proved")
        weights = motions.sets[name].lengths(box)
        if image is not None:
            moved = image.sides.tolist()
            weights = [sum(abs(float(row[k].mid())) for row in moved) for k in range(len(box))]
        usable = [k for k, length in enumerate(lengths) if length > _FINEST]
        k = max(usable, key=weights.__getitem__)
        middle = (box[k][0] + box[k][1]) / 2
        for half in ((middle, box[k][1]), (box[k][0], middle)):
            boxes.append((*box[:k], half, *box[k + 1 :]))


def _placed(seen: list[Any], side: bool) -> bool:
    """Return whether an image lies beyond a set or, unless of a side, between its stable sides."""
    unstable, *stable = seen
    beyond = bool(unstable > 1 or unstable < -1)
    return beyond or (not side and all(abs(x) < 1 for x in stable))


def _check_entropy(content: dict[str, Any], targets: dict[str, list[str]]) -> None:
    """Demand that the graph's spectral radius and the entropy are no less than stated."""
    told = Fraction(content["growth"])
    demand(told > 1, "a graph that does not grow")
    demand(told <= _radius(targets), "the graph grows less than stated")
    entropy = exact(content["entropy"])
    demand(entropy > 0, "no positive entropy")
    growth = arb(fmpq(told.numerator, told.denominator)).log() / content["iterates"]
    demand(growth >= arb(entropy), "the entropy is larger than what follows")


def _radius(targets: dict[str, list[str]]) -> Fraction:
    """Return a lower bound of the spectral radius of a strongly connected graph.

    It comes from a power of 1 + A, with A the adjacency matrix.
    """
    sources = {name: [n for n, others in targets.items() if name in others] for name in targets}
    for ahead in (targets, sources):
        reached, left = set[str](), [*targets][:1]
        while left:
            reached.add(name := left.pop())
            left += {*ahead[name]} - reached
        demand(reached == targets.keys(), "a set is on no way from each of the others to each")
    weights = dict.fromkeys(targets, 1)
    for _ in range(_ROUNDS):
        weights = {n: w + sum(weights[m] for m in targets[n]) for n, w in weights.items()}
    return min(Fraction(sum(weights[m] for m in targets[n]), w) for n, w in weights.items())
