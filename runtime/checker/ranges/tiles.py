"""The check of a map: claims for all parameters of each tile of a box, in Taylor models.

What is claimed of a tile holds for each of its parameters: there is exactly one orbit next to
polynomials of the parameters, which are found here anew from the numbers that the tile states.
"""

from collections.abc import Mapping, Sequence
from typing import Any

from flint import arb, ctx, fmpq

from nonsmooth.runtime.checker.orbits.motion import admissibility
from nonsmooth.runtime.checker.orbits.orbit import CheckedOrbit, Cut, orbit_at
from nonsmooth.runtime.checker.orbits.stability import judged_stability, stability
from nonsmooth.runtime.checker.ranges.branch_curve import Family, middle_and_half
from nonsmooth.runtime.checker.ranges.divided import VERDICTS, Band, DividingCurve, Division
from nonsmooth.runtime.checker.ranges.folded import (
    BEYOND,
    SMALLEST,
    FoldedTile,
    Sheets,
    beyond_folds,
    common_part,
    neighbours,
)
from nonsmooth.runtime.checker.stated.exact import (
    Entries,
    Failure,
    Numbers,
    ToNumber,
    Verdict,
    agreed_claims,
    demand,
    exact,
    inside,
    naming,
)
from nonsmooth.runtime.checker.stated.parameters import independent, number_at
from nonsmooth.runtime.checker.stated.shape import check_file
from nonsmooth.runtime.core.taylor_models import Space, TaylorModel, middle_of, range_of, space_of

_BITS = 64
_ORDERS = {1: 5, 2: 3}  # of the models, by the number of parameters; 2 for more
_SHARP, _PLANE = 6, 2  # order where a curve divides a tile, or the low one tells too little
_DEEPEST = 4  # halvings of a tile whose claims take smaller ones
_NEAR = 0.0625  # how far from the stated numbers the orbit may be in the middle of a tile
SHARES = tuple(fmpq(k, 32) for k in (16, 8, 24, 4, 28, 1, 31, 0, 32))  # of an edge
_NEWTON = 3  # steps to the orbit in the middle of a tile

Interval = tuple[Any, Any]


class _Contradicted(Failure):
    """The contrary of a claim is proved, so that smaller tiles do not help."""


def check_tiles(content: Entries) -> None:
    """Prove every claim of a map again; `Failure` names a claim that is not proved.

    `Malformed` is raised if the file, read as JSON, has another shape.
    """
    check_file(content, "nonsmooth box certificate")
    tiles = content["tiles"]
    check_whole(content)
    if not content["declaration"]:
        told = any(tile["claims"]["existence"] != "undecided" for tile in tiles)
        demand(not (told or content["closing"]), "claims about no declaration")
        demand(not any(tile["enclosures"] for tile in tiles), "enclosures of no orbit")
        demand(content["stability"] == "stable", "stability of another kind")
        return
    box = CheckedBox(content)
    beside = _neighbours(tiles)
    seen: dict[int, MapTile] = {}
    for number, tile in enumerate(tiles):
        checked = box.proved(tile)
        if _verdict(tile) == "undecided":
            continue
        demand(tile["looked_at"], "a tile that was not looked at has a verdict")
        for other in beside[number]:
            if other in seen:
                box.check_joint(checked, seen[other])
        seen[number] = checked
    box.check_divisors()


def _neighbours(tiles: Sequence[Entries]) -> Sequence[Sequence[int]]:
    """Return for each tile those with which it shares an edge; none but for two parameters."""
    if len(tiles[0]["place"]) != _PLANE:
        return [()] * len(tiles)
    return neighbours([[(step, level) for step, level in tile["place"]] for tile in tiles])


def check_whole(content: Entries) -> None:
    """Demand that tiles fill their box, and that what is said of the box follows from them.

    `content` holds the entries of a map, in their shape.
    """
    box = _ends_of(content)
    demand(box and all(low < high for low, high in box), "the box is empty")
    places = [[(step, level) for step, level in tile["place"]] for tile in content["tiles"]]
    demand(all(0 <= level <= SMALLEST for place in places for _, level in place), "tiny tiles")
    demand(all(len(place) == len(box) for place in places), "a tile has no place in the box")
    demand(_fill(places), "the tiles do not fill the box")
    _total(content)


def _ends_of(content: Entries) -> list[Interval]:
    return [(exact(low), exact(high)) for low, high in content["box"].values()]


class CheckedBox:
    """A box of parameters, the tiles of which are proved one by one.

    `content` holds the entries of a map, in their shape. `Failure` is raised if its
    declaration is not exact, or states a stability of another kind.
    """

    def __init__(self, content: Entries) -> None:
        names, self.ends = [*content["box"]], _ends_of(content)
        with ctx.workprec(_BITS):
            self.family = Family.stated(content, names)

    def proved(self, tile: Entries) -> "MapTile":
        """Prove all claims of a tile and return it."""
        where = self.where(tile["place"])
        with ctx.workprec(_BITS):
            found = MapTile(self.family, tile)
            with naming(_in_tile(where)):
                found.check(where)
            self.check_divisors()
        return found

    def near(self, point: Numbers, guess: Numbers) -> list[Any]:
        """Return unknowns near an orbit at values of the parameters; nothing is proved of them.

        `Failure` is raised where Newton's method finds none near the guess.
        """
        with ctx.workprec(_BITS):
            number = number_at([*map(arb, point), *self.family.constants])
            return CheckedOrbit(self.family.declared, number).near(guess)

    def judged(
        self, place: Sequence[Any], guess: Sequence[float], order: int = 0
    ) -> tuple["MapTile", CheckedOrbit]:
        """Return a tile with what is proved of the orbit near a guess in its middle, and the orbit.

        `order` is that of the Taylor models, by default what costs least. `Failure` is raised if
        the orbit is not proved to exist.
        """
        with ctx.workprec(_BITS):
            found = self._tile(place, guess)
            orbit = found.judge(self.where(place), order or _ORDERS.get(len(place), 2))
            self.check_divisors()
        return found, orbit

    def folded(self, place: Sequence[Any], sheets: Sheets) -> "MapTile":
        """Return a tile with a fold, as it is proposed; `Failure` is raised if it is not proved."""
        with ctx.workprec(_BITS):
            found = self._tile(place, sheets.guess)
            found.bend(self.where(place), sheets)
            self.check_divisors()
        return found

    def _tile(self, place: Sequence[Any], guess: Sequence[float]) -> "MapTile":
        """Return a tile of which nothing is claimed."""
        undecided = dict.fromkeys(("existence", "admissibility", "stability"), "undecided")
        empty = {"place": place, "guess": guess, "claims": undecided, "event": None,
                 "reasons": dict.fromkeys(undecided, ""), "enclosures": {}}  # fmt: skip
        return MapTile(self.family, empty)

    def where(self, place: Sequence[Any]) -> list[Interval]:
        """Return the ends of each parameter over a tile."""
        pairs = zip(place, self.ends, strict=True)
        return [_interval(step, level, *ends) for (step, level), ends in pairs]

    def check_joint(self, tile: "MapTile", other: "MapTile") -> None:
        """Prove that two proved tiles of two parameters have the same orbits where they meet."""
        with ctx.workprec(_BITS), naming(_in_tile(tile.where)):
            tile.meets(other)

    def check_divisors(self) -> None:
        """Prove that the exact arithmetic divided by nothing that is zero throughout the box."""
        with ctx.workprec(_BITS):
            independent(self.family.declared, self.family.constants, self.ends)


def _in_tile(where: Sequence[Interval]) -> str:
    shown = ", ".join(f"{float(low):.6g}:{float(high):.6g}" for low, high in where)
    return f"in the tile {shown}"


class MapTile:
    """The claims about one tile of a map."""

    def __init__(self, family: Family, tile: Entries) -> None:
        self.family, self.tile = family, tile
        self.declared, self.energies, self.constants, names = family
        self.claims = agreed_claims(tile["claims"], tile["reasons"])
        event = tile["event"]
        self.division: Division | None = None
        self.fold: FoldedTile | None = None
        if event is not None and event["kind"] != "fold":
            self.division = Division.stated(event, self.claims, names, tile["place"])
        self.where: Sequence[Interval] = ()
        self.deepest = 0  # halvings, at most

    def check(self, where: Sequence[Interval]) -> None:
        """Prove the claims, on smaller tiles or in higher orders if need be."""
        self.where = where
        if self.tile["event"] is not None and self.division is None:
            self.fold = FoldedTile.stated(self.family, where, self.tile)
            return
        if self.claims[0] == "undecided":
            demand(not self.tile["enclosures"], "enclosures of no orbit")
            return
        demand(self.claims[0] == "proved", "existence is not refuted")
        low = _ORDERS.get(len(where), 2)
        orders = [low] if len(where) != _PLANE else [_SHARP] if self.division else [low, _SHARP]
        for order in orders:
            # smaller tiles cost more than a high order
            self.deepest = _DEEPEST if order == orders[-1] else 0
            try:
                self.space = space_of(len(where), order)
                self._all(where)
                return
            except Failure as failure:
                if order == orders[-1] or isinstance(failure, _Contradicted):
                    raise

    def judge(self, where: Sequence[Interval], order: int) -> CheckedOrbit:
        """Find what is true of the tile's orbit on the whole tile, in models of one order.

        `verdicts` and `enclosures` hold it, and the orbit is returned. `Failure` is raised if there
        may be none.
        """
        self.where, self.space = where, space_of(len(where), order)
        orbit = self._whole(where)
        self.verdicts = {"existence": Verdict("proved")}
        for name, judge in (("admissibility", admissibility), ("stability", judged_stability)):
            try:
                self.verdicts[name] = judge(orbit)
            except Failure as failure:
                self.verdicts[name] = Verdict("undecided", str(failure))
        self.enclosures = {name: range_of(x) for name, x in orbit.enclosures().items()}
        return orbit

    def divide(self, orbit: CheckedOrbit, curve: DividingCurve) -> Division:
        """Return what is proved of a judged tile and its orbit if one event happens on a curve.

        `Failure` is raised if that is not proved.
        """
        found = Division(curve, [verdict.claim for verdict in self.verdicts.values()])
        parameters, place = _values(self.where, self.space), self.tile["place"]
        found.judge(orbit, self.family, parameters, self._orbit_at, place)
        return found

    def bend(self, where: Sequence[Interval], sheets: Sheets) -> None:
        """Prove that two orbits meet in the tile or near it, and find in which band.

        `Failure` is raised if that is not proved.
        """
        self.where = where
        self.fold = found = FoldedTile(self.family, where, sheets)
        found.band = Band.about(sheets.axis, sheets.centre, found.far, self.tile["place"])

    def _whole(self, where: Sequence[Interval]) -> CheckedOrbit:
        """Return the orbit near the tile's guess, which becomes the tile's."""
        guess = [arb(float(x)) for x in self.tile["guess"]]
        whole = self._orbit(where, guess)
        found = [_at(x, [arb(0)] * len(where)) for x in whole.root]
        near = all(abs(x - g) < _NEAR * (1 + abs(g)) for x, g in zip(found, guess, strict=True))
        demand(near, "the orbit is not near the numbers that are stated")
        self.centre, self.radii, self.root = whole.centre, whole.radii, whole.root
        return whole

    def _all(self, where: Sequence[Interval]) -> None:
        """Prove the claims in Taylor models of one order."""
        whole = self._whole(where)
        if self.division is not None:
            named = self.tile["event"]["configuration"] == self.division.phases(whole)
            demand(named, "another configuration")
        self._judge(whole, whole, where, [(fmpq(-1), fmpq(1))] * len(where), 0)
        if self.division is not None:
            below, above = self.division.verdicts(self._orbit_at)
            demand(self.division.beside == (below, above), "other verdicts beside the event")

    def _orbit_at(self, point: Numbers) -> CheckedOrbit:
        """Return the tile's orbit at a point, from -1 to 1 over it."""
        sides = zip(point, (middle_and_half(*ends) for ends in self.where), strict=True)
        number = number_at([*(m + x * half for x, (m, half) in sides), *self.constants])
        orbit = orbit_at(self.declared, number, [_at(x, point) for x in self.centre])
        demand(self._holds(point, orbit.root), "another orbit is found at a point of it")
        return orbit

    def _holds(self, point: Numbers, found: Numbers) -> bool:
        """Return whether an orbit at a point lies in the tile's box of unknowns."""
        sides = zip(found, self.centre, self.radii, strict=True)
        return all(abs(x - _at(c, point)) < r for x, c, r in sides)

    def meets(self, other: "MapTile") -> None:
        """Demand that two tiles have the same orbit at a point of the edge that they share.

        Nothing is demanded if no tried point of the edge clearly has orbits of both.
        """
        both = common_part(self.where, other.where)
        for share in SHARES:
            point = [low + share * (high - low) for low, high in both]
            own, its = self.inside(point), other.inside(point)
            if self.claims_at(own) and other.claims_at(its):
                break
        else:
            return  # none are claimed
        if not self.holds(own, other.at(its)):
            found = self._sharply(own)
            demand(other.holds(its, found), "its orbit is not that of a tile beside it")

    def inside(self, values: Numbers) -> list[Any]:
        """Return the point of the tile, from -1 to 1 over it, at values of the parameters."""
        ends = zip(values, self.where, strict=True)
        return [(2 * x - low - high) / (high - low) for x, (low, high) in ends]

    def claims_at(self, point: Numbers) -> bool:
        """Return whether there is clearly an orbit of the tile at a point."""
        return self.fold is None or self.fold.claims_at(point)

    def at(self, point: Numbers) -> list[Any]:
        """Return the tile's orbit at a point, from -1 to 1 over it, as enclosed unknowns."""
        if self.fold is not None:
            return self.fold.at(point)
        return [_at(x, [arb(e) for e in point]) for x in self.root]

    def _sharply(self, point: Numbers) -> list[Any]:
        if self.fold is not None:
            return self.fold.at(point)
        return list(self._orbit_at([arb(e) for e in point]).root)

    def holds(self, point: Numbers, found: Numbers) -> bool:
        """Return whether an orbit at a point is the tile's."""
        if self.fold is not None:
            return self.fold.holds(point, found)
        return self._holds([arb(e) for e in point], found)

    def _orbit(self, where: Sequence[Interval], guess: Numbers) -> CheckedOrbit:
        """Return the orbit for all parameters of a tile, from a guess in its middle."""
        space = self.space
        orbit = CheckedOrbit(self.declared, _numbers(where, self.constants, space))
        demand(len(guess) == orbit.count, "the guess is of another size")
        orders = (_cut(space_of(len(where), k)) for k in (1, 2))
        centre, inverse = orbit.follow(guess, [*(middle_of,) * _NEWTON, *orders, _cut(space)])
        unique, _ = orbit.locate(centre, inverse=inverse)
        demand(unique, "existence is not proved: Krawczyk's test fails")
        orbit.returns(self.energies)
        return orbit

    def _judge(
        self,
        whole: CheckedOrbit,
        orbit: CheckedOrbit,
        where: Sequence[Interval],
        part: Any,
        depth: int,
    ) -> None:
        """Prove enclosures and claims of an orbit on a part of the tile, or on its halves.

        `part` holds the ends of the part, where the whole tile is from -1 to 1.
        """
        try:
            self._claims(orbit)
            if self.division is not None:
                values = _values(where, orbit.root[0].space)
                self.division.prove(orbit, self.family, values, part)
            return
        except Failure as failure:
            if depth == self.deepest or isinstance(failure, _Contradicted):
                raise
        axis = depth % len(where)
        for half in (0, 1):
            there, within = (
                [_interval(half, 1, *ends) if k == axis else ends for k, ends in enumerate(box)]
                for box in (where, part)
            )
            point = [arb((low + high) / 2) for low, high in within]
            near = [_at(x, point) for x in whole.centre]
            smaller = self._orbit(there, [x.mid() for x in near])
            found = [_at(x, [arb(0)] * len(where)) for x in smaller.root]
            ways = zip(found, near, whole.radii, strict=True)
            same = all(abs(x - y) < r for x, y, r in ways)
            demand(same, "another orbit is found on a part of it")
            self._judge(whole, smaller, there, within, depth + 1)

    def _claims(self, orbit: CheckedOrbit) -> None:
        _, admissible, stable = self.claims
        found, told = orbit.enclosures(), self.tile["enclosures"]
        without = {"trace"} if stable == "undecided" else set()
        all_told = found.keys() - without <= told.keys() <= found.keys()
        _agree(all_told, not all_told, "the enclosures are not those of the unknowns")
        for name, stated in told.items():
            value = range_of(found[name])
            miss = abs(value - arb(exact(stated["mid"]))) > arb(exact(stated["rad"]))
            _agree(inside(value, stated), miss, f"{name} is not in its enclosure")
        if stable != "undecided":
            verdict = stability(orbit)
            _agree(verdict == stable, verdict != "undecided", f"stability is {verdict}")
        if admissible != "undecided":
            verdict = admissibility(orbit).claim
            told = f"admissibility is {verdict}"
            _agree(verdict == admissible, verdict != "undecided", told)


def _agree(proved: bool, refuted: bool, otherwise: str) -> None:
    if not proved:
        raise _Contradicted(otherwise) if refuted else Failure(otherwise)


def _numbers(where: Sequence[Interval], constants: Any, space: Space) -> ToNumber:
    """Return a function from exact entries to numbers for all parameters of a tile."""
    return number_at([*_values(where, space), *constants])


def _values(where: Sequence[Interval], space: Space) -> list[Any]:
    """Return all parameters of a tile, as Taylor models."""
    return [space.variable(axis, *middle_and_half(*ends)) for axis, ends in enumerate(where)]


def _verdict(tile: Entries) -> str:
    """Return the verdict that the claims of a tile amount to; "divided" for one with an event."""
    agreed_claims(tile["claims"], tile["reasons"])
    return "divided" if tile["event"] is not None else verdict_of(tile["claims"])


def verdict_of(claims: Mapping[str, str]) -> str:
    """Return the verdict on all of a tile that claims amount to."""
    if claims["existence"] != "proved":
        return "undecided"
    verdict = VERDICTS.get(claims["stability"], "undecided")
    ways = {"proved": verdict, "refuted": "not admissible"}
    return ways.get(claims["admissibility"], "undecided")


def _cut(space: Space) -> Cut:
    return lambda x: x.mid().cast(space) if isinstance(x, TaylorModel) else x.mid()


def _at(number: Any, point: Numbers) -> Any:
    return number.at(point) if isinstance(number, TaylorModel) else number


def _interval(step: int, level: int, low: Any, high: Any) -> Interval:
    """Return one of 2^level equal parts of an interval."""
    demand(0 <= step < 2**level, "a tile is outside of the box")
    width = (high - low) / 2**level
    return low + step * width, low + (step + 1) * width


def _fill(places: list[list[tuple[int, int]]]) -> bool:
    """Return whether tiles fill their box without overlap: as one tile, or as two filled halves."""
    if len(places) < 2:
        return all(step == level == 0 for place in places for step, level in place) and bool(places)
    for axis in range(len(places[0])):
        if all(place[axis][1] > 0 for place in places):
            halves: list[list[Any]] = [[], []]
            for place in places:
                step, level = place[axis]
                side, rest = divmod(step, 2 ** (level - 1))
                if side not in (0, 1):
                    return False
                halves[side].append([*place[:axis], (rest, level - 1), *place[axis + 1 :]])
            return all(map(_fill, halves))
    return False


def _total(content: Entries) -> None:
    """Demand that what is said of the whole box follows from its tiles."""
    tiles, shares = content["tiles"], dict.fromkeys(content["shares"], fmpq(0))
    verdicts = [_verdict(tile) for tile in tiles]
    beyond = [False] * len(tiles)
    if len(content["box"]) == _PLANE:
        beyond = beyond_folds(tiles, verdicts, _neighbours(tiles))
    for tile, verdict, behind in zip(tiles, verdicts, beyond, strict=True):
        shares[BEYOND if behind else verdict] += fmpq(
            1, 2 ** sum(level for _, level in tile["place"])
        )
    stated = {name: int(share.p) / int(share.q) for name, share in shares.items()}
    demand(content["shares"] == stated, "the shares are not those of the tiles")
    for name, verdict in content["claims"].items():
        told = {tile["claims"][name] for tile in tiles}
        worst = next(v for v in ("refuted", "undecided", "proved") if v in told)
        demand(verdict == worst, f"{name} of the box is not that of the tiles")
    proved = [tile["enclosures"] for tile in tiles if tile["claims"]["existence"] == "proved"]
    common = {*proved[0]}.intersection(*proved) if proved else set()
    demand(content["enclosures"].keys() == common, "enclosures of the box are not those of tiles")
    for name, whole in content["enclosures"].items():
        middle, radius = exact(whole["mid"]), exact(whole["rad"])
        for own in proved:
            away = exact(own[name]["mid"]) - middle
            holds = max(away, -away) + exact(own[name]["rad"]) <= radius
            demand(holds, f"{name} of the box does not contain that of a tile")
