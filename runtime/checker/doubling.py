"""The check of a doubling: orbits of twice the period that begin at a flip of a branch.

Both halves of such an orbit satisfy the equations F of the orbit of which the flip is, but for
the closure: each ends where the other begins. Half of their sum is m, half of their difference
is a w, where one entry of w is 1. Between them lie the points m + f w with f from -a to a, and

    the average of F at both ends is zero, the mean of F' w, and twice the start's part of w, too.

For every a, zero included, Krawczyk's test shows one solution (m, w, parameter) in a tube. That
at zero is the flip. By implicit differentiation in the square of a the parameter changes in one
direction only, so that no multiplier is 1 beside the flip.
"""

from collections.abc import Callable, Sequence
from typing import Any

from flint import arb, arb_mat, ctx

from nonsmooth.runtime.checker.branch import checked_tiles
from nonsmooth.runtime.checker.branch_curve import CheckedCurve, solution
from nonsmooth.runtime.checker.branch_tile import CheckedTile
from nonsmooth.runtime.checker.exact import Failure, check_sum, demand, exact, inside
from nonsmooth.runtime.checker.motion import admissibility
from nonsmooth.runtime.checker.orbit import CheckedOrbit, flows_over
from nonsmooth.runtime.checker.parameters import number_at
from nonsmooth.runtime.checker.shape import DOUBLING, check_shape
from nonsmooth.runtime.checker.stability import characteristic, passing, stability
from nonsmooth.runtime.core.jets import jet, part_of
from nonsmooth.runtime.core.taylor_models import (
    AT_BOTH_ENDS,
    BENT_MEAN,
    MEAN,
    TaylorModel,
    averaged,
    lifted,
    matrix,
    range_of,
    space_of,
)

__all__ = ["check_doubled", "check_doubling"]

_BITS, _SHARP = 64, 192
_ORDER = 5  # of the models: that of the polynomials
_STEPS = 8  # of Newton's method
_DEEPEST = 5  # halvings of a tube whose claims take smaller ones
_ALIKE = ("parameters", "parameter", "stability")


def check_doubling(content: dict[str, Any]) -> None:
    """Prove every claim of a doubling again; `Failure` names a claim that is not proved.

    `Malformed` is raised if the file, read as JSON, has another shape.
    """
    check_shape(content, DOUBLING)
    check_sum(content)
    doubled = content["doubled"]
    decided = doubled is not None and doubled["verdict"] != "undecided"
    demand((content["claims"]["doubling"] == "proved") == decided, "the claim is another one")
    if content["ended"] == "complete":
        demand(doubled is not None, "it is called complete without doubled orbits")
        demand(not content["end"], "a reason why it goes no further, though it is whole")
    branches, tiles = [content["branch"]], []
    if doubled is not None:
        branches.append(doubled["branch"])
    for name, branch in zip(("the branch", "the doubled branch"), branches, strict=False):
        try:
            tiles.append(checked_tiles(branch))
        except Failure as failure:
            raise Failure(f"{name}: {failure}") from None
    if doubled is not None:
        check_doubled(doubled, branches, tiles)


def check_doubled(
    doubled: dict[str, Any],
    branches: Sequence[dict[str, Any]],
    tiles: Sequence[Sequence[CheckedTile]],
) -> None:
    """Prove the doubled orbits between two branches that are already proved.

    `branches` and `tiles` are those of the branch with the flip and of the one that begins there.
    """
    _same_system(*branches)
    with ctx.workprec(_BITS):
        _CheckedDoubling(doubled, branches[1], *tiles).check()


def _same_system(branch: dict[str, Any], beyond: dict[str, Any]) -> None:
    """Demand that the second branch's cycle is the first one's, passed twice, in one system."""
    demand(all(branch[name] == beyond[name] for name in _ALIKE), "another system's branch")
    declared, other = branch["declaration"], beyond["declaration"]
    demand(declared and other, "claims about no declaration")
    parts = declared.keys() | other.keys()
    alike = all(declared.get(name) == other.get(name) for name in parts - {"phases"})
    demand(alike, "the declarations differ")
    phases, twice = (
        [[phase[name] for name in ("configuration", "boundaries", "transition")] for phase in each]
        for each in (declared["phases"], other["phases"])
    )
    demand(twice == phases * 2, "the itinerary is not passed twice")
    closing, twofold = branch["closing"], beyond["closing"]
    demand(closing["kind"] in ("state", "forcing"), "cycles of another closing")
    turns = {name: 2 * value if name == "turns" else value for name, value in closing.items()}
    demand(turns == twofold and "translations" not in closing, "it closes in another way")


class _CheckedDoubling:
    """The doubled orbits next to a flip, over the amplitude a; n unknowns become 2 n.

    They are the middle m, the direction w without its entry 1, and the parameter.
    """

    def __init__(
        self,
        doubling: dict[str, Any],
        beyond: dict[str, Any],
        tiles: Sequence[CheckedTile],
        others: Sequence[CheckedTile],
    ) -> None:
        self.doubling = doubling
        demand(tiles and others, "a branch without tiles")
        demand(1 <= doubling["tile"] <= len(tiles), "there is no such tile")
        self.tile = tiles[doubling["tile"] - 1]
        self.first = others[0] if beyond["start"] == 0 else others[-1]
        self.begin = self.first.begin if beyond["start"] == 0 else self.first.end
        self.curve, self.twice = self.tile.curve, self.first.curve.undivided()
        event = self.tile.event
        demand(event is not None and event["kind"] == "flip", "there is no flip")
        demand(self.curve.short is None, "its equations are divided by a dwell time")
        demand(doubling["scaled"] in self.curve.declared.unknowns, "there is no such unknown")
        self.scaled = self.curve.declared.unknowns.index(doubling["scaled"])
        self.size = self.curve.last
        self.amplitude = arb(exact(doubling["amplitude"]))
        self.radii = [arb(r) for r in doubling["radii"]]
        centre = doubling["centre"]
        demand(len(self.radii) == len(centre) == 2 * self.size, "a tube of another size")
        demand(all(r > 0 and r.is_finite() for r in self.radii), "the tube is empty")
        demand(all(len(row) == _ORDER + 1 for row in centre), "polynomials of another order")
        demand(exact(doubling["amplitude"]) > 0, "the largest amplitude is not positive")
        self.space = space_of(1, _ORDER)
        self.centre = [TaylorModel(self.space, tuple(map(arb, row))) for row in centre]

    def check(self) -> None:
        """Prove that these orbits begin at the flip, and their side and verdict."""
        a = self.space.variable(0, arb(0), self.amplitude)
        found = self.krawczyk(a, self.centre, self.radii)
        demand(found is not None, "existence is not proved: Krawczyk's test fails")
        assert found is not None
        low, high = self.curve.interval
        over = range_of(found[-1])
        demand(over > low and over < high, "it is outside of the interval")
        rate = range_of(self.rate(a, found))
        side = self.doubling["side"]
        demand(rate > 0 if side == "above" else rate < 0, f"they may not be {side} the flip")
        with ctx.workprec(_SHARP):
            self._begins_at_the_flip(side)
            orbit = self._goes_on()
        demand((self.doubling["verdict"] == "undecided") == bool(self.doubling["reason"]),
               "a reason of another verdict")  # fmt: skip
        if self.doubling["verdict"] == "undecided":
            return
        first, second = self._copies(a, found)
        point = [*first, *second[self.size - len(self.curve.declared.steps) :], found[-1]]
        self._parts(self._decided, point)
        with ctx.workprec(_SHARP):
            words = {"proved": "stable", "refuted": "unstable"}
            told = words.get(stability(self.twice.orbit(orbit)))
        demand(told == self.doubling["verdict"], f"at one of them it is {told}")

    def holds(self, a: Any, found: Sequence[Any]) -> bool:
        """Return whether a solution of amplitude a lies in the tube."""
        place = a / self.amplitude
        sides = zip(found, self.centre, self.radii, strict=True)
        return bool(abs(place) < 1) and all(abs(x - c.at([place])) < r for x, c, r in sides)

    def _begins_at_the_flip(self, side: str) -> None:
        """Demand that the solution at amplitude zero is the branch's flip, with the stated rate."""
        zero = arb(0)
        point = [x.at([zero]).mid() for x in self.centre]
        for _ in range(_STEPS):
            values, slopes = self.equations(zero, point)
            try:
                step = slopes.mid().solve(values.mid())
            except ZeroDivisionError:
                raise Failure("the equations are singular at the flip") from None
            point = [(x - d).mid() for x, d in zip(point, step.entries(), strict=True)]
        unit = arb(2) ** -int(0.6 * ctx.prec)
        flip = self.krawczyk(zero, point, [(unit * (1 + abs(x))).upper() for x in point])
        demand(flip is not None, "there is no flip at the amplitude zero")
        assert flip is not None
        demand(self.holds(zero, flip), "the tube holds another flip")
        tile = self.tile
        whole = [*flip[: self.size], flip[-1]]
        value = whole[tile.place]
        demand(value > tile.low and value < tile.high, "the flip is outside of its tile")
        others = [x for k, x in enumerate(whole) if k != tile.place]
        demand(tile.holds(value, others), "the flip is not that of the branch")
        rate = self.rate(zero, flip)
        demand(rate > 0 if side == "above" else rate < 0, f"they are not {side} the flip")
        demand(inside(rate, self.doubling["rate"]), "the rate is not in its enclosure")

    def _goes_on(self) -> list[Any]:
        """Demand that the doubled branch begins with an orbit of the tube; return this orbit.

        Solutions of equations that are divided by a dwell time solve the undivided ones, too.
        """
        twice = self.twice
        demand(self.first.place == twice.last, "the doubled branch begins by another coordinate")
        orbit = self.first.at(arb(self.begin))
        passed = twice.orbit(orbit)
        half, count = len(passed.chain.fields) // 2, passed.first
        behind = passed.now.starts[half]
        first = [*orbit[:count], *passed.dwell[:half]]
        second = [behind[k, 0] for k in twice.declared.free]
        if twice.declared.forcing:
            second.append(orbit[count - 1] + sum(passed.dwell[:half], -passed.chain.period / 2))
        second += passed.dwell[half:]
        apart = [(x - y) / 2 for x, y in zip(first, second, strict=True)]
        a = apart[self.scaled]
        demand(a > 0 or a < 0, "the halves of the doubled orbit may be the same")
        middle = [(x + y) / 2 for x, y in zip(first, second, strict=True)]
        away = [x / a for k, x in enumerate(apart) if k != self.scaled]
        demand(self.holds(a, [*middle, *away, orbit[-1]]), "the doubled branch begins elsewhere")
        return orbit

    def _decided(self, point: Sequence[Any]) -> None:
        """Demand that orbits are motions, with no multiplier on the circle but 1 at the flip."""
        orbit = self.twice.orbit(point)
        demand(orbit.declared.alone, "one-sided maps")
        told = admissibility(orbit).claim
        demand(told == "proved", f"admissibility is {told}")
        polynomial = characteristic(orbit.section)
        kinds = ["flip"] + ["neimark-sacker"] * (len(polynomial) > 2)
        for kind in kinds:
            value = range_of(passing(polynomial, kind))
            demand(value > 0 or value < 0, f"there may be another event: {kind}")

    def _parts(
        self, prove: Callable[[Sequence[Any]], None], point: Sequence[Any], depth: int = 0
    ) -> None:
        """Call `prove` on all orbits or, where that fails, on halves of them again and again."""
        try:
            prove(point)
            return
        except Failure:
            if depth == _DEEPEST:
                raise
        for side in (-1, 1):
            e = self.space.variable(0, arb(side) / 2, arb(1) / 2)
            self._parts(prove, [x.at([e]) for x in point], depth + 1)

    def krawczyk(self, a: Any, centre: Sequence[Any], radii: Sequence[Any]) -> list[Any] | None:
        """Return Krawczyk's image of a box (2 n) of solutions, or None if it is not inside the box.

        If it is inside, there is exactly one solution in the box for each amplitude.
        """
        values, slopes = self.equations(a, centre)
        try:
            y = slopes.mid().inv().mid()
        except ZeroDivisionError:
            return None
        box = [x + arb(0, r) for x, r in zip(centre, radii, strict=True)]
        _, over = self.equations(a, box)
        count = len(radii)
        unit = arb_mat([[int(i == j) for j in range(count)] for i in range(count)])
        moved = (unit - y * over) * arb_mat([[arb(0, r)] for r in radii]) - y * values
        found = moved.entries()
        if not all(abs(d) < r for d, r in zip(found, radii, strict=True)):
            return None
        return [x + d for x, d in zip(centre, found, strict=True)]

    def equations(self, a: Any, unknowns: Sequence[Any]) -> tuple[Any, Any]:
        """Return values (2 n, 1) of the equations and their derivatives (2 n, 2 n)."""
        middle, away = self._split(unknowns)
        point, direction, value = self._between(a, middle, away, unknowns[-1])
        moving = jet(value, arb(1))
        first = self._passage(point, moving)
        bend = self._passage([jet(u, w) for u, w in zip(point, direction, strict=True)], value)
        column, wide = matrix([[w] for w in away]), matrix([[w] for w in direction])
        slopes, along = part_of(first.slopes, 0), part_of(first.slopes, 1)
        start = self._start_rows()
        ends, second = averaged(slopes, AT_BOTH_ENDS), averaged(part_of(bend.slopes, 1), MEAN)
        values = (
            averaged(part_of(first.values, 0), AT_BOTH_ENDS),
            averaged(slopes * wide, MEAN) + 2 * start * column,
        )
        by_value = (
            averaged(part_of(first.values, 1), AT_BOTH_ENDS),
            averaged(along * wide, MEAN),
        )
        closed = ends + 2 * start
        n = self.size
        others = [k for k in range(n) if k != self.scaled]
        upper = [
            [*(ends[i, j] for j in range(n)), *(a * a * second[i, j] for j in others),
             by_value[0][i, 0]]
            for i in range(n)
        ]  # fmt: skip
        lower = [
            [*(second[i, j] for j in range(n)), *(closed[i, j] for j in others),
             by_value[1][i, 0]]
            for i in range(n)
        ]  # fmt: skip
        told = [[part[i, 0]] for part in values for i in range(n)]
        return matrix(told), matrix([*upper, *lower])

    def rate(self, a: Any, unknowns: Sequence[Any]) -> Any:
        """Return the derivative of the parameter by the square of the amplitude."""
        middle, away = self._split(unknowns)
        point, direction, value = self._between(a, middle, away, unknowns[-1])
        pairs = zip(point, direction, strict=True)
        bend = self._passage([jet(u, w, None) for u, w in pairs], value)
        wide = matrix([[w] for w in direction])
        second = averaged(part_of(bend.slopes, 1) * wide, MEAN)
        third = averaged(2 * part_of(bend.slopes, 2) * wide, BENT_MEAN)
        _, slopes = self.equations(a, unknowns)
        try:
            y = slopes.mid().inv().mid()
        except ZeroDivisionError:
            raise Failure("the derivative by the amplitude is not known") from None
        right = matrix([[-x / 2] for x in (*second.entries(), *third.entries())])
        return solution(slopes, y, right)[-1]

    def _split(self, unknowns: Sequence[Any]) -> tuple[list[Any], list[Any]]:
        """Return the middle (n) and the direction (n), with its entry 1, of the unknowns (2 n)."""
        away = list(unknowns[self.size : -1])
        return list(unknowns[: self.size]), [*away[: self.scaled], arb(1), *away[self.scaled :]]

    def _copies(self, a: Any, unknowns: Sequence[Any]) -> tuple[list[Any], list[Any]]:
        middle, away = self._split(unknowns)
        pairs = list(zip(middle, away, strict=True))
        return [m + a * w for m, w in pairs], [m - a * w for m, w in pairs]

    def _between(
        self, a: Any, middle: Sequence[Any], away: Sequence[Any], value: Any
    ) -> tuple[list[Any], list[Any], Any]:
        """Return points between the halves, direction and parameter as models of e and f."""
        if not isinstance(a, TaylorModel):
            demand(a.is_zero(), "an amplitude that is not zero")
            return list(middle), list(away), value
        space = space_of(2, a.space.order)
        step = space.variable(1, arb(0), self.amplitude)
        wide = [lifted(w, space) for w in away]
        pairs = zip(middle, wide, strict=True)
        return [lifted(m, space) + step * w for m, w in pairs], wide, lifted(value, space)

    def _passage(self, point: Sequence[Any], value: Any) -> Any:
        """Return the passage of the cycle from a point, root of the equations or not."""
        curve: CheckedCurve = self.curve
        orbit = CheckedOrbit(curve.declared, number_at([value, *curve.constants]))
        flows = flows_over(orbit.chain.fields, point[orbit.first :])
        return orbit.passage(orbit.chain, point, flows)

    def _start_rows(self) -> Any:
        """Return the matrix (n, n) that picks the start's part in the closure equations."""
        declared = self.curve.declared
        found = arb_mat(self.size, self.size)
        phases, free = len(declared.steps), declared.free
        demand(declared.dropped not in free, "a closure is left out")
        for place in range(len(free)):
            found[phases + place, place] = 1
        if declared.forcing:
            found[phases + len(free), len(free)] = 1
        return found
