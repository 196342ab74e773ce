"""An orbit's equations joined by what holds at an event; the parameter is an unknown too."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import combinations
from typing import TYPE_CHECKING, Any, NamedTuple

from nonsmooth.runtime.checker.stability import CORNER
from nonsmooth.runtime.core.taylor_models import matrix, middle_of, range_of, space_of
from nonsmooth.runtime.explore.continuation.event import Event
from nonsmooth.runtime.proof.admissibility_conditions import Plan, Watched
from nonsmooth.runtime.proof.boxes.orbit_over_box import Region
from nonsmooth.runtime.proof.exact_tables import Number
from nonsmooth.runtime.proof.motion.exact_rows import evaluate
from nonsmooth.runtime.proof.multipliers import reduced_map
from nonsmooth.runtime.proof.orbit_claims import conserved
from nonsmooth.runtime.proof.orbit_equations import Equations, Flows, Linearised
from nonsmooth.runtime.proof.orbit_to_prove import NotCovered

if TYPE_CHECKING:
    from flint import arb, arb_mat

__all__ = ["Augmented", "augmented", "check_pair", "determinant", "instant_of", "pair_products"]

_LARGEST_MAP = 6  # multipliers


class _Here(NamedTuple):
    """The orbit near the event, with the further unknowns."""

    region: Region
    number: Number
    equations: Equations
    now: Linearised
    unknowns: Sequence[Any]
    more: Sequence[Any]


class Augmented(NamedTuple):
    """The equations of an event: those of the orbit, and what vanishes at the event."""

    region: Region  # over one parameter
    own: int  # number of unknowns of the orbit's equations
    names: tuple[str, ...]  # of these unknowns, the parameter, and any further unknown
    values: Callable[[_Here], list[Any]]  # what vanishes at the event, of an orbit near it

    def __call__(self, middles: Sequence[arb], halves: Sequence[arb]) -> list[Any]:
        """Return the left-hand sides over a box as Taylor models of first order in its place."""
        here = self._here(middles, halves)
        return [*here.now.residual.entries(), *self.values(here)]

    def closes(self, middles: Sequence[arb], halves: Sequence[arb]) -> bool:
        """Whether energy conservation is proved to give the coordinate without closure equation.

        It is True where nothing was left out. The box is given by the middle and half the width of
        each unknown.
        """
        if self.region.closing.form is None:
            return True
        here = self._here(middles, halves)
        return conserved(here.region, here.number, here.now.shooting)

    def _here(self, middles: Sequence[arb], halves: Sequence[arb]) -> _Here:
        region = self.region
        space = space_of(len(middles), 1)
        box = [
            space.variable(k, x, r) for k, (x, r) in enumerate(zip(middles, halves, strict=True))
        ]
        count = self.own
        number = region.tables.number_at([box[count]])
        equations = region.equations(number)
        flows = Flows(equations.phases, equations.dwell(box[:count]))
        now = equations.linearised(box[:count], flows)
        return _Here(region, number, equations, now, box[:count], box[count + 1 :])


def augmented(region: Region, event: Event, names: Sequence[str]) -> Augmented:
    """Return the equations of an event, as many as unknowns.

    The region is over the event's parameter, and `names` are the unknowns of the orbit's equations.
    `NotCovered` is raised for events that are no regular roots of such equations.
    """
    more: tuple[str, ...] = ()
    conservative = region.closing.form is not None
    if event.kind == "flip" or (event.kind == "fold" and not conservative):
        sign = 1 if event.kind == "flip" else -1
        values = _multiplier(sign)
    elif event.kind == "neimark-sacker":
        values = _pair
    elif event.kind == "vanishing-phase":
        values = _vanishing(event)
    elif event.kind == "grazing":
        values, more = _grazing(event), ("time",)
    elif event.kind in ("entry", "tangent", "simultaneous"):
        values = _ending(event)
    elif event.kind == "condition":
        values = _condition(event)
    else:
        raise NotCovered(f"{event.kind}: it is no regular root of the equations of the whole orbit")
    return Augmented(region, len(names), (*names, *region.names, *more), values)


def _map(here: _Here, fewest: int) -> Any:
    """Return the map on its section, where at least `fewest` multipliers may differ from zero."""
    region = here.region
    if region.cycle.one_sided:
        raise NotCovered(CORNER)
    maps = here.equations.maps(here.now.shooting)
    found = reduced_map(maps, region.invariants, region.closing, here.number)
    if found.nrows() > _LARGEST_MAP:
        raise NotCovered(f"more than {_LARGEST_MAP} multipliers")
    if found.nrows() < fewest:
        raise NotCovered("too few multipliers differ from zero: the branch meets a border there")
    return found


def _multiplier(sign: int) -> Callable[[_Here], list[Any]]:
    """Return the function det(M + sign) of the map M: zero if a multiplier is minus the sign."""

    def values(here: _Here) -> list[Any]:
        found = _map(here, 1)
        size = found.nrows()
        return [determinant([[found[i, j] + sign * (i == j) for j in range(size)]
                              for i in range(size)])]  # fmt: skip

    return values


def _pair(here: _Here) -> list[Any]:
    """Return what vanishes where two multipliers that are not real have the product 1.

    It is `pair_products` of the map.
    """
    found = _map(here, 2)
    check_pair(range_of(found))
    return [pair_products(found)]


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


def instant_of(event: Event) -> str:
    """Return when in its phase an event happens: at the "start", "inside", or at the "end".

    The text is empty for events that have no such instant.
    """
    if event.kind == "grazing":
        return "inside"
    if event.kind in ("simultaneous", "condition") or (event.kind == "tangent" and event.time):
        return "end"
    return "start" if event.kind in ("entry", "tangent") else ""


def _place(event: Event) -> int:
    if event.phase is None:
        raise NotCovered(f"{event.kind}: no phase is named")
    return event.phase


def _watched(here: _Here, event: Event) -> tuple[Plan, Watched]:
    plan = here.region.plans[_place(event)].at(here.number)
    for watched in plan.watched:
        if watched.name == event.boundary:
            return plan, watched
    raise NotCovered(f"{event.boundary} is no boundary of phase {(event.phase or 0) + 1}")


def _vanishing(event: Event) -> Callable[[_Here], list[Any]]:
    return lambda here: [here.equations.dwell(here.unknowns)[_place(event)]]


def _grazing(event: Event) -> Callable[[_Here], list[Any]]:
    """Return the equations of a time inside the phase at which a boundary is touched from inside.

    There the boundary function and its rate are zero.
    """

    def values(here: _Here) -> list[Any]:
        plan, watched = _watched(here, event)
        (time,) = here.more
        field = here.equations.phases[plan.place].field
        state = (field * time).exp() * here.now.shooting.starts[plan.place]
        row, speed = matrix([watched.row]), field * state
        if not (time > 0 and here.equations.dwell(here.unknowns)[plan.place] - time > 0):
            raise NotCovered("the boundary is not touched inside the phase")
        if not (row * (field * speed))[0, 0] < 0:
            raise NotCovered("the boundary is not surely touched from inside")
        return [(row * state)[0, 0], (row * speed)[0, 0]]

    return values


def _ending(event: Event) -> Callable[[_Here], list[Any]]:
    """Return the equation of what is zero at an event where a phase begins or ends."""

    def values(here: _Here) -> list[Any]:
        plan, watched = _watched(here, event)
        if instant_of(event) == "end":
            row = watched.ends if event.kind == "simultaneous" else watched.speed
            return [evaluate(row, here.now.shooting.ends[plan.place].entries()[:-1])]
        if watched.begins is None:
            raise NotCovered(f"{event.boundary} stays reached")
        return [evaluate(watched.begins.row, here.now.shooting.starts[plan.place].entries()[:-1])]

    return values


def _condition(event: Event) -> Callable[[_Here], list[Any]]:
    """Return the equation of that condition of a phase's transitions which is nearest to zero."""

    def values(here: _Here) -> list[Any]:
        plan = here.region.plans[_place(event)].at(here.number)
        state = here.now.shooting.ends[plan.place].entries()[:-1]
        found = [
            evaluate(behind.row, state)
            for followers in plan.orders
            for follower in followers
            for behind, _ in follower.conditions
            if behind is not None
        ]
        if not found:
            raise NotCovered("no condition of the transition depends on the state")
        return [min(found, key=lambda value: abs(float(range_of(value).mid())))]

    return values
