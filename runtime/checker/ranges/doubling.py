"""The judge of a doubling: orbits of twice the period that begin at a flip of a branch.

Both halves of such an orbit satisfy the equations F of the orbit of which the flip is, but for
the closure: each ends where the other begins. Half of their sum is m, half of their difference
is a w, where one entry of w is 1. Between them lie the points m + f w with f from -a to a, and

    the average of F at both ends is zero, the mean of F' w, and twice the start's part of w, too.

For every a, zero included, Krawczyk's test shows one solution (m, w, parameter) in a tube. That
at zero is the flip. By implicit differentiation in the square of a the parameter changes in one
direction only, so that no multiplier is 1 beside the flip.
"""

from collections.abc import Sequence
from typing import Any

from flint import arb, arb_mat, ctx

from nonsmooth.runtime.checker.orbits.motion import admissibility
from nonsmooth.runtime.checker.orbits.orbit import (
    CheckedOrbit,
    flows_over,
    krawczyk,
    near_inverse,
    newton,
)
from nonsmooth.runtime.checker.orbits.stability import CORNER, characteristic, passing, stability
from nonsmooth.runtime.checker.ranges.branch import (
    ORDER,
    CheckedTile,
    checked_tiles,
    curve_of,
    stated_tube,
)
from nonsmooth.runtime.checker.ranges.branch_curve import (
    CheckedCurve,
    inside_box,
    prove_on_parts,
    solution,
    without_entry,
)
from nonsmooth.runtime.checker.stated.exact import (
    Entries,
    Numbers,
    demand,
    demand_sign,
    exact,
    inside,
    naming,
)
from nonsmooth.runtime.checker.stated.parameters import number_at
from nonsmooth.runtime.checker.stated.shape import check_file
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

_BITS, _SHARP = 64, 192
_DEEPEST = 5  # halvings of a tube whose claims take smaller ones
_ALIKE = ("parameters", "parameter", "stability")


def check_doubling(content: Entries) -> None:
    """Prove every claim of a doubling again; `Failure` names a claim that is not proved.

    `Malformed` is raised if the file, read as JSON, has another shape.
    """
    check_file(content, "nonsmooth certified doubling")
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
        with naming(name):
            tiles.append(checked_tiles(branch))
    if doubled is not None:
        check_doubled(doubled, branches, tiles)


def check_doubled(
    doubled: Entries,
    branches: Sequence[Entries],
    tiles: Sequence[Sequence[CheckedTile]],
) -> None:
    """Judge the doubled orbits between two branches that are already proved.

    `branches` and `tiles` are those of the branch with the flip and of the one that begins there.
    """
    branch, beyond = branches
    own, others = tiles
    demand(own and others, "a branch without tiles")
    demand(1 <= doubled["tile"] <= len(own), "there is no such tile")
    found = JudgedDoubling(doubled, branch, own[doubled["tile"] - 1])
    found.locate()
    demand(doubled["side"] == found.side, f"they are not {doubled['side']} the flip")
    with ctx.workprec(_SHARP):
        demand(inside(found.rate, doubled["rate"]), "the rate is not in its enclosure")
    demand(beyond["start"] in (0, len(others)), "the doubled branch begins amid its tiles")
    orbit = found.first_of(beyond, others[0 if beyond["start"] == 0 else -1])
    undecided = doubled["verdict"] == "undecided"
    demand(undecided == bool(doubled["reason"]), "a reason of another verdict")
    if not undecided:
        found.decide()
        told = found.verdict(orbit)
        demand(told == doubled["verdict"], f"at one of them it is {told}")


def twofold(content: Entries) -> CheckedCurve:
    """Return the equations of a branch's cycle passed twice; `Failure` where it is not covered."""
    demand(content["declaration"], "claims about no declaration")
    declared, closing = content["declaration"], content["closing"]
    covered = closing["kind"] in ("state", "forcing") and "translations" not in closing
    demand(covered, "cycles of another closing")
    again = [{**p, "dwell_time": f"{p['dwell_time']} again"} for p in declared["phases"]]
    found = curve_of(
        {
            **content,
            "declaration": {**declared, "phases": [*declared["phases"], *again]},
            "itinerary": content["itinerary"] * 2,
            "unknown_names": [*content["unknown_names"], *(p["dwell_time"] for p in again)],
            "closing": _turned_twice(closing),
        }
    )
    demand(found.declared.alone, CORNER)
    return found


def _turned_twice(closing: Entries) -> dict[str, Any]:
    return {name: 2 * value if name == "turns" else value for name, value in closing.items()}


def _same_system(branch: Entries, beyond: Entries) -> None:
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
    demand(_turned_twice(branch["closing"]) == beyond["closing"], "it closes in another way")


class JudgedDoubling:
    """What is proved of the doubled orbits next to a flip, of which a proposal tells.

    A proposal has the entries of a file that state the unknown in which the halves are apart, the
    largest amplitude, and polynomials and radii of the tube. `content` holds the entries of the
    branch with the flip, and `tile` is the flip's, already proved.
    """

    def __init__(self, proposal: Entries, content: Entries, tile: CheckedTile) -> None:
        self.content, self.tile, self.curve = content, tile, tile.curve
        self.twice = twofold(content)
        event = tile.event
        demand(event is not None and event["kind"] == "flip", "there is no flip")
        demand(self.curve.short is None, "its equations are divided by a dwell time")
        demand(proposal["scaled"] in self.curve.declared.unknowns, "there is no such unknown")
        self.scaled = self.curve.declared.unknowns.index(proposal["scaled"])
        self.equations = DoubledEquations(self.curve, self.scaled)
        with ctx.workprec(_BITS):
            self.amplitude = arb(exact(proposal["amplitude"]))
            self.centre, self.radii = stated_tube(proposal, 2 * self.equations.size)
            demand(exact(proposal["amplitude"]) > 0, "the largest amplitude is not positive")

    def locate(self) -> None:
        """Prove that these orbits begin at the flip, and find their side and rate there."""
        with ctx.workprec(_BITS):
            self.a = a = space_of(1, ORDER).variable(0, arb(0), self.amplitude)
            self.found = found = inside_box(self.equations.image(a, self.centre, self.radii))
            low, high = self.curve.interval
            over = range_of(found[-1])
            demand(over > low and over < high, "it is outside of the interval")
            rate = range_of(self.equations.rate(a, found))
            demand_sign(rate, "on which side of the flip they are is not known")
        self.side = "above" if rate > 0 else "below"
        with ctx.workprec(_SHARP):
            flip = self.equations.flip_near([x.at([arb(0)]) for x in self.centre])
            demand(self._holds(arb(0), flip), "the tube holds another flip")
            tile = self.tile
            whole = [*flip[: self.equations.size], flip[-1]]
            value = whole[tile.place]
            demand(value > tile.low and value < tile.high, "the flip is outside of its tile")
            others = without_entry(tile.place, whole)
            demand(tile.holds(value, others), "the flip is not that of the branch")
            self.rate = self.equations.rate(arb(0), flip)
            same = self.rate > 0 if self.side == "above" else self.rate < 0
            demand(same, f"they are not {self.side} the flip")

    def first_of(self, beyond: Entries, first: CheckedTile) -> list[Any]:
        """Demand that a doubled branch begins with an orbit of the tube; return this orbit.

        `first` is the tile of it where it begins. Solutions of equations that are divided by a
        dwell time solve the undivided ones, too.
        """
        _same_system(self.content, beyond)
        twice = self.twice
        with ctx.workprec(_SHARP):
            demand(first.place == twice.last, "the doubled branch begins by another coordinate")
            orbit = first.at(arb(first.begin if beyond["start"] == 0 else first.end))
            passed = twice.orbit(orbit)
            half, count = len(passed.chain.fields) // 2, passed.first
            behind = passed.now.starts[half]
            one = [*orbit[:count], *passed.dwell[:half]]
            other = [behind[k, 0] for k in twice.declared.free]
            if twice.declared.forcing:
                time = sum(passed.dwell[:half], -passed.chain.period / 2)
                other.append(orbit[count - 1] + time)
            other += passed.dwell[half:]
            apart = [(x - y) / 2 for x, y in zip(one, other, strict=True)]
            a = apart[self.scaled]
            demand_sign(a, "the halves of the doubled orbit may be the same")
            middle = [(x + y) / 2 for x, y in zip(one, other, strict=True)]
            away = [x / a for x in without_entry(self.scaled, apart)]
            inside_it = self._holds(a, [*middle, *away, orbit[-1]])
            demand(inside_it, "the doubled branch begins elsewhere")
        return orbit

    def decide(self) -> None:
        """Demand that all these orbits are motions, and none has another multiplier 1 or -1.

        No two of their multipliers have the product 1.
        """
        with ctx.workprec(_BITS):
            first, second = self.equations.halves(self.a, self.found)
            dwell = second[self.equations.size - len(self.curve.declared.steps) :]
            prove_on_parts(self._decided, [*first, *dwell, self.found[-1]], _DEEPEST)

    def verdict(self, orbit: Numbers) -> str:
        """Return "stable" or "unstable", as one orbit of the tube is, or "undecided"."""
        with ctx.workprec(_SHARP):
            words = {"proved": "stable", "refuted": "unstable"}
            return words.get(stability(self.twice.orbit(orbit)), "undecided")

    def _holds(self, a: Any, found: Numbers) -> bool:
        """Return whether a solution of amplitude a lies in the tube."""
        place = a / self.amplitude
        sides = zip(found, self.centre, self.radii, strict=True)
        return bool(abs(place) < 1) and all(abs(x - c.at([place])) < r for x, c, r in sides)

    def _decided(self, point: Numbers) -> None:
        """Demand that orbits are motions, with no multiplier on the circle but 1 at the flip."""
        orbit = self.twice.orbit(point)
        told = admissibility(orbit).claim
        demand(told == "proved", f"admissibility is {told}")
        polynomial = characteristic(orbit.section)
        kinds = ["flip"] + ["neimark-sacker"] * (len(polynomial) > 2)
        for kind in kinds:
            value = range_of(passing(polynomial, kind))
            demand_sign(value, f"there may be another event: {kind}")


class DoubledEquations:
    """The equations of doubled orbits over the amplitude a; n unknowns become 2 n.

    They are the middle m, the direction w without its entry 1, whose number is `scaled`, and the
    parameter. The amplitude is zero, or a multiple of the one variable.
    """

    def __init__(self, curve: CheckedCurve, scaled: int) -> None:
        self.curve, self.scaled, self.size = curve, scaled, curve.last

    def flip_near(self, guess: Numbers) -> list[Any]:
        """Return the enclosed solution at amplitude zero near a guess, by Newton's method."""
        zero = arb(0)
        point = newton(lambda point: self.at(zero, point), guess)
        unit = arb(2) ** -int(0.6 * ctx.prec)
        found = self.image(zero, point, [(unit * (1 + abs(x))).upper() for x in point])
        return inside_box(found, "there is no flip at the amplitude zero")

    def image(self, a: Any, centre: Numbers, radii: Numbers) -> tuple[list[Any] | None, bool]:
        """Return Krawczyk's image of a box (2 n) of solutions, and whether it is inside the box.

        If it is inside, there is exactly one solution in the box for each amplitude.
        """
        return krawczyk(lambda point: self.at(a, point), centre, radii)

    def at(self, a: Any, unknowns: Numbers) -> tuple[Any, Any]:
        """Return values (2 n, 1) of the equations and their derivatives (2 n, 2 n)."""
        _, away = self._split(unknowns)
        point, direction, value = self._between(a, unknowns)
        moving = jet(value, arb(1))
        first = self._passage(point, moving)
        bend = self._passage([jet(u, w) for u, w in zip(point, direction, strict=True)], value)
        column, wide = matrix([[w] for w in away]), matrix([[w] for w in direction])
        slopes, along = part_of(first.slopes, 0), part_of(first.slopes, 1)
        start = self.start_rows()
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

    def rate(self, a: Any, unknowns: Numbers) -> Any:
        """Return the derivative of the parameter by the square of the amplitude."""
        point, direction, value = self._between(a, unknowns)
        pairs = zip(point, direction, strict=True)
        bend = self._passage([jet(u, w, None) for u, w in pairs], value)
        wide = matrix([[w] for w in direction])
        second = averaged(part_of(bend.slopes, 1) * wide, MEAN)
        third = averaged(2 * part_of(bend.slopes, 2) * wide, BENT_MEAN)
        _, slopes = self.at(a, unknowns)
        y = near_inverse(slopes, "the derivative by the amplitude is not known")
        right = matrix([[-x / 2] for x in (*second.entries(), *third.entries())])
        return solution(slopes, y, right)[-1]

    def _split(self, unknowns: Numbers) -> tuple[list[Any], list[Any]]:
        """Return the middle (n) and the direction (n), with its entry 1, of the unknowns (2 n)."""
        away = list(unknowns[self.size : -1])
        return list(unknowns[: self.size]), [*away[: self.scaled], arb(1), *away[self.scaled :]]

    def halves(self, a: Any, unknowns: Numbers) -> tuple[list[Any], list[Any]]:
        """Return the orbit's unknowns (n) along each half of a doubled orbit."""
        middle, away = self._split(unknowns)
        pairs = list(zip(middle, away, strict=True))
        return [m + a * w for m, w in pairs], [m - a * w for m, w in pairs]

    def _between(self, a: Any, unknowns: Numbers) -> tuple[list[Any], list[Any], Any]:
        """Return points between the halves, direction and parameter as models of e and f."""
        (middle, away), value = self._split(unknowns), unknowns[-1]
        if not isinstance(a, TaylorModel):
            demand(a.is_zero(), "an amplitude that is not zero")
            return middle, away, value
        space = space_of(2, a.space.order)
        step = space.variable(1, arb(0), a.parts[1])
        wide = [lifted(w, space) for w in away]
        pairs = zip(middle, wide, strict=True)
        return [lifted(m, space) + step * w for m, w in pairs], wide, lifted(value, space)

    def _passage(self, point: Numbers, value: Any) -> Any:
        """Return the passage of the cycle from a point, root of the equations or not."""
        curve = self.curve
        orbit = CheckedOrbit(curve.declared, number_at([value, *curve.constants]))
        flows = flows_over(orbit.chain.fields, point[orbit.first :])
        return orbit.passage(orbit.chain, point, flows)

    def start_rows(self) -> Any:
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
