"""The cycle of enclosed orbits, and the numbers whose zeros are its events, in any arithmetic."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any

from nonsmooth.runtime.core.taylor_models import matrix, middle_of, range_of
from nonsmooth.runtime.proof.admissibility import Judgement, OpenInequality
from nonsmooth.runtime.proof.admissibility_conditions import Plan
from nonsmooth.runtime.proof.boxes.orbit_over_box import Region
from nonsmooth.runtime.proof.motion.exact_rows import evaluate
from nonsmooth.runtime.proof.multipliers import determinant, pair_products, reduced_map, trace_of
from nonsmooth.runtime.proof.orbit_claims import (
    MapClaim,
    claim_of_map,
    conserved,
    judged,
    unstable_if_reached,
)

__all__ = [
    "MULTIPLIERS",
    "CyclePassage",
    "border",
    "multiplier",
    "others_at_circle",
    "passed_by",
    "time_of_touch",
]

_PAIR = 4  # size of a conservative map with one pair of multipliers
MULTIPLIERS = ("flip", "fold", "neimark-sacker")


class CyclePassage:
    """The cycle of an orbit whose unknowns and parameters are enclosed.

    `point` has the unknowns of the orbit's equations and the region's parameters: balls, Taylor
    models or jets.
    """

    def __init__(self, region: Region, point: Sequence[Any]) -> None:
        count = len(point) - len(region.names)
        self.region, self.own = region, list(point[:count])
        self.number = region.tables.number_at(list(point[count:]))
        self.equations = region.equations(self.number)

    @cached_property
    def shooting(self) -> Any:
        """One passage through the cycle."""
        fields = [phase.field for phase in self.equations.phases]
        return self.equations.linearised(
            self.own, lambda place, time: (fields[place] * time).exp()
        ).shooting

    @property
    def dwell(self) -> Sequence[Any]:
        """The dwell times."""
        return self.equations.dwell(self.own)

    @cached_property
    def section(self) -> Any:
        """The derivative of the Poincare map on the smallest section that is known."""
        region = self.region
        maps = self.equations.maps(self.shooting)
        return reduced_map(maps, region.invariants, region.closing, self.number)

    @property
    def conserved(self) -> bool:
        """Whether the energy returns the coordinate whose closure was dropped, if one was."""
        return conserved(self.region, self.number, self.shooting)

    @cached_property
    def stability(self) -> MapClaim:
        """The claim that is proved of the multipliers."""
        return claim_of_map(self.region, self.number, self.equations, self.shooting)

    def unstable_if_reached(self, place: int) -> bool:
        """Whether the orbit is proved unstable if it ends a phase with a nonzero speed.

        It is unstable however low the speed is with which the boundary is reached that ends the
        phase, counted from 0.
        """
        return unstable_if_reached(self.region, self.number, self.equations, self.shooting, place)

    def judged(self, assumed: Sequence[OpenInequality] = ()) -> Judgement:
        """The judgement whether it is a motion of the system, if the assumed inequalities hold."""
        return judged(
            self.region, self.number, self.equations.phases, self.shooting, self.dwell, assumed
        )


def multiplier(passage: CyclePassage, kind: str) -> Any:
    """A number that is zero where multipliers are at the unit circle.

    The kind is "flip" (a multiplier is -1), "fold" (1) or "neimark-sacker" (two have product 1).
    """
    found = passage.section
    if kind == "neimark-sacker":
        return pair_products(found)
    sign = 1 if kind == "flip" else -1
    size = found.nrows()
    return determinant([[found[i, j] + sign * (i == j) for j in range(size)] for i in range(size)])


def passed_by(passage: CyclePassage) -> str:
    """The one kind of passing the unit circle that is not excluded, "flip" or "neimark-sacker".

    It is asked for orbits whose multipliers cannot be separated from the unit circle. It is
    empty where several kinds are possible, or a fold, or where the map has a corner.
    """
    region = passage.region
    if passage.section is None or region.cycle.one_sided:
        return ""
    if region.closing.form is not None:
        # where m + 1/m is 2 it leaves the circle too, and is no fold if the period is given
        total = range_of(trace_of(passage.section)) - 1
        pair = passage.equations.size == _PAIR and (total > 2 or total < 2)
        return "flip" if pair else ""
    kinds = others_at_circle(passage, "")
    return kinds[0] if len(kinds) == 1 and kinds != ["fold"] else ""


def others_at_circle(passage: CyclePassage, but: str) -> list[str]:
    """The kinds of passing the unit circle that are not excluded, except one."""
    size = passage.section.nrows()
    kinds = [kind for kind in ("flip", "fold", "neimark-sacker") if kind != but]
    if size < 2:
        kinds = [kind for kind in kinds if kind != "neimark-sacker"]
    found = []
    for kind in kinds if size else ():
        value = range_of(multiplier(passage, kind))
        if not (value > 0 or value < 0):
            found.append(kind)
    return found


def border(passage: CyclePassage, which: OpenInequality, time: Any = None) -> Any:
    """A number that is negative where an inequality holds, and positive where it does not.

    A grazing needs its time in the phase, from `time_of_touch`.
    """
    place = which.phase
    if which.kind == "vanishing-phase":
        return -passage.dwell[place]
    plan = passage.region.plans[place].at(passage.number)
    if which.kind == "condition":
        return _condition(plan, which, passage.shooting.ends[place].entries()[:-1])
    watched = next(w for w in plan.watched if w.name == which.boundary)
    start, end = (column[place] for column in (passage.shooting.starts, passage.shooting.ends))
    if which.kind == "grazing":
        field = passage.equations.phases[place].field
        return (matrix([watched.row]) * ((field * time).exp() * start))[0, 0]
    if which.instant == "start":
        assert watched.begins is not None  # it is open
        return evaluate(watched.begins.row, start.entries()[:-1])
    if which.kind == "simultaneous":
        return evaluate(watched.ends, end.entries()[:-1])
    return -evaluate(watched.speed, end.entries()[:-1])


def _condition(plan: Plan, which: OpenInequality, state: Sequence[Any]) -> Any:
    """A number that is negative where a condition is as the itinerary asks."""
    number, k = (int(part) - 1 for part in which.boundary.split("."))
    follower = plan.orders[0][number]
    behind, expected = follower.conditions[k]
    assert behind is not None  # it is open
    value = evaluate(behind.row, state)
    return -value if expected == follower.wanted else value


def time_of_touch(
    passage: CyclePassage, which: OpenInequality, window: tuple[Any, Any]
) -> Any | None:
    """The time at which a boundary function has its maximum in a window in which it is concave.

    It has to lie inside the phase too, whose end the window may pass where that moves. It is
    enclosed by an interval Newton step around an approximation, for balls or Taylor models.
    None where the step fails.
    """
    from flint import arb, ctx

    place = which.phase
    plan = passage.region.plans[place].at(passage.number)
    watched = next(w for w in plan.watched if w.name == which.boundary)
    field, start = passage.equations.phases[place].field, passage.shooting.starts[place]
    slope = matrix([watched.row]) * field

    def rates(time: Any) -> tuple[Any, Any]:
        state = (field * time).exp() * start
        return (slope * state)[0, 0], (slope * (field * state))[0, 0]

    time: Any = ((window[0] + window[1]) / 2).mid()
    for _ in range(8):
        rate, bend = rates(time)
        time = (time - rate / bend).mid()
    rate, _ = rates(time)
    _, bend = rates(middle_of(time))
    width = range_of(rate / bend)
    radius = (2 * abs(width) + arb(2) ** (10 - ctx.prec)).upper()
    if not radius.is_finite():
        return None
    box = time + arb(0, radius)
    _, bend = rates(box)
    if not bend < 0:
        return None
    moved = -rate / bend
    if not abs(moved) <= radius:
        return None
    found = time + moved
    behind = range_of(passage.dwell[place] - found)
    inside = bool(found > window[0] and found < window[1] and found > 0 and behind > 0)
    return found if inside else None
