"""Tiles of a branch: a tube and an event are proposed in floating point, the checker judges them.

The polynomials of a tube come from Newton's method in Taylor models, its radii from what is left of
the equations at them. Of a tile on which no verdict holds for all orbits one event is proposed: the
inequalities that are open, or the one way in which multipliers may pass the unit circle, and where
along the tile that happens.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import Any, NamedTuple

from flint import arb

from nonsmooth.runtime.checker.orbits.motion import Border, admissibility
from nonsmooth.runtime.checker.orbits.orbit import CheckedOrbit, Cut, followed
from nonsmooth.runtime.checker.orbits.stability import demand_alone
from nonsmooth.runtime.checker.ranges.branch import BITS, ORDER, SHARP, CheckedTile, curve_of
from nonsmooth.runtime.checker.ranges.branch_curve import CheckedCurve, with_entry
from nonsmooth.runtime.checker.stated.exact import Entries, Failure, Verdict, demand
from nonsmooth.runtime.core.json_codec import encode
from nonsmooth.runtime.core.taylor_models import TaylorModel, range_of, space_of
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.proof.asking import REFUSED, as_read, asking, holds
from nonsmooth.runtime.proof.boxes.tile import Interval
from nonsmooth.runtime.proof.boxes.tile_search import touching_window, window_balls
from nonsmooth.runtime.proof.branch.certified_branch import (
    STATED,
    UNDECIDED,
    BranchEvent,
    BranchTile,
    CertifiedBranch,
)
from nonsmooth.runtime.proof.certificate import Stated, file_json
from nonsmooth.runtime.proof.orbit_to_prove import Region, stated_orbits
from nonsmooth.runtime.proof.statement import rational_of

_LONG = 6  # phases of a cycle beyond which rounding errors grow too much for few bits
_NARROW = Fraction(1, 2**24)  # size of a tile, in that of its coordinate, that takes more, too
_ORDERS = (1, 3)  # of the steps to the polynomials of a tube, before the last one
_LEAST = 2.0**-50  # radius of a tube
_CLOSE, _STEPS = 120, 16  # bits of a tile to which an event is found, in so many steps
_DIGITS = 33  # of the bounds of an event, in the size of its tile
_DEEPEST = 0  # halvings of a tile for its claims: smaller tiles cost less


class JudgedTile(NamedTuple):
    """A tile as it is stated, and as the checker knows it."""

    stated: BranchTile
    checked: CheckedTile

    @property
    def decided(self) -> bool:
        """Whether every point of it has a verdict, but for its event."""
        return self.stated.before != UNDECIDED


def precision_of(curve: CheckedCurve, lower: Fraction, upper: Fraction) -> int:
    """Return the working precision, in bits, on a tile of a branch between two values."""
    narrow = upper - lower < _NARROW * max(abs(lower), abs(upper))
    return 2 * BITS if narrow or len(curve.declared.steps) > _LONG else BITS


def proposed_tile(
    curve: CheckedCurve,
    place: int,
    ends: tuple[Fraction, Fraction],
    guess: Sequence[arb],
    *,
    forwards: bool,
    divided: int | None,
) -> JudgedTile:
    """Return a tile in which the checker finds one orbit for each value of a coordinate.

    `place` is the number of the coordinate, `ends` are its lower and upper end, `guess` has the
    other coordinates in the middle. The coordinate increases along the branch if it runs
    `forwards`; `divided` is the phase that may vanish, counted from 0. `Failure` is raised if the
    orbits are not proved to exist.
    """
    with flint_precision(precision_of(curve, *ends)):
        equations = curve.divided(None if divided is None else divided + 1)
        centre, radii = _tube(equations, place, ends, guess)
        stated = BranchTile(
            coordinate=curve.names[place],
            lower=ends[0],
            upper=ends[1],
            forwards=forwards,
            before=UNDECIDED,
            after=UNDECIDED,
            reason="nothing is proved but that the orbits exist",
            centre=centre,
            radii=radii,
            event=None,
            divided=divided,
        )
        checked = CheckedTile(curve, as_read(encode(stated)))
        checked.deepest = _DEEPEST
        checked.locate()
    return JudgedTile(stated, checked)


def _tube(
    curve: CheckedCurve, place: int, ends: tuple[Fraction, Fraction], guess: Sequence[arb]
) -> tuple[tuple[tuple[float, ...], ...], tuple[float, ...]]:
    """Return coefficients of the polynomials of a tube, and radii for them."""
    lower, upper = ends
    middle, half = (arb(rational_of(x)) for x in ((lower + upper) / 2, (upper - lower) / 2))
    value = space_of(1, ORDER).variable(0, middle, half)

    def cut_to(order: int) -> Cut:
        space = space_of(1, order)
        return lambda x: x.cast(space) if isinstance(x, TaylorModel) else space.constant(x)

    def at(cut: Cut, others: Sequence[Any], slopes: bool) -> tuple[Any, Any]:
        point = with_entry(place, cut(value), others)
        return curve.square(place, point) if slopes else (curve.orbit(point).now.values, None)

    near = curve.near(place, middle.mid(), guess)
    found, inverse = followed(at, near, [cut_to(order) for order in (*_ORDERS, ORDER)])
    values = curve.orbit(with_entry(place, value, found)).now.values
    radii = [float((2 * abs(range_of(d)) + _LEAST).upper()) for d in (inverse * values).entries()]
    demand(all(map(math.isfinite, radii)), "Newton's method finds no orbits")
    rows = tuple(tuple(0.0 if p is None else float(p) for p in x.parts) for x in found)
    return rows, tuple(radii)


def judged_tile(tile: JudgedTile) -> JudgedTile:
    """Return a tile with what the checker proves of its orbits.

    It is a verdict, or one event with the verdicts beside it, or the reason why it is undecided.
    """
    stated, checked = tile
    with flint_precision(precision_of(checked.curve, stated.lower, stated.upper)):
        try:
            found = checked.claims()
            return _claimed(tile, found.before, found.after)
        except REFUSED as refused:
            reason = str(refused)
        try:
            event = _proposed_event(checked)
            with_event = checked.stating(event=as_read(encode(event)))
            found = with_event.claims()
        except REFUSED as refused:
            return tile._replace(stated=replace(stated, reason=reason or str(refused)))
        return _claimed(tile, found.before, found.after, _stated(event, found.enclosures))


def _claimed(
    tile: JudgedTile, before: str, after: str, event: BranchEvent | None = None
) -> JudgedTile:
    stated = replace(tile.stated, before=before, after=after, reason="", event=event)
    told = None if event is None else as_read(encode(event))
    checked = tile.checked.stating(before=before, after=after, reason="", event=told)
    return JudgedTile(stated, checked)


def _stated(event: BranchEvent, enclosures: dict[str, arb]) -> BranchEvent:
    """Return an event with stated enclosures, somewhat wider than those that are found."""
    with flint_precision(SHARP):
        least = arb(2) ** -STATED
        told = {name: Stated.around(x + arb(0, x.rad() + least), STATED)
                for name, x in enclosures.items()}  # fmt: skip
    return replace(event, enclosures=told)


def _proposed_event(tile: CheckedTile) -> BranchEvent:
    """Return an event that may be the one of a tile; `Failure` says why there is none."""
    orbit = tile.curve.orbit(tile.point)
    told = admissibility(orbit)
    turns = not holds(lambda: tile.goes_on(tile.point))
    if told.claim == "undecided":
        return _border(tile, orbit, told, turns=turns)
    alone = [k for k in ("flip", "neimark-sacker") if holds(partial(demand_alone, orbit, k))]
    kinds = ["fold"] if turns else alone
    demand(len(kinds) == 1, "multipliers may pass the unit circle in several ways")
    return _event(tile, kinds[0])


def _border(tile: CheckedTile, orbit: CheckedOrbit, told: Verdict, *, turns: bool) -> BranchEvent:
    """Return the event at which all inequalities that are open cease to hold.

    Beside a phase that vanishes, or a boundary that is reached slowly, more may be open. Where a
    phase vanishes that begins and ends on one boundary the branch turns too.
    """
    opened: list[Border] = []
    window: tuple[Fraction, ...] = ()
    while told.claim == "undecided":
        more = [border for border in told.found if border not in opened]
        demand(more and None not in more, told.reason)
        opened += more
        grazing = [border for border in opened if border.kind == "grazing"]
        demand(len(grazing) <= 1, "several maxima touch a boundary at once")
        window = touching_window(orbit, grazing[0]) if grazing else ()
        told = admissibility(orbit, opened, window_balls(window))
    demand(told.claim == "proved", told.reason)
    # a phase that vanishes ends where the one before it does; of a boundary that is reached
    # without speed all else follows
    opened.sort(key=lambda b: (b.kind != "vanishing-phase", (b.kind, b.instant) != _SLOW))
    if turns:
        short = tile.curve.short
        vanishes = short is not None and opened[0].kind == "vanishing-phase"
        demand(vanishes, "the branch may turn")
        return _event(tile, opened[0], (*opened[1:], Border("fold", opened[0].phase, "", "")))
    return _event(tile, opened[0], opened[1:], window)


_SLOW = ("tangent", "end")


def _event(
    tile: CheckedTile,
    which: Border | str,
    also: Sequence[Border] = (),
    window: tuple[Fraction, ...] = (),
) -> BranchEvent:
    """Return an event of a tile without enclosures, between two decimals near its zero."""
    lower, upper = _bounds(tile, which, window_balls(window))
    kind, phase, boundary, instant = (which, None, "", "") if isinstance(which, str) else which
    return BranchEvent(
        kind=kind,
        phase=phase,
        configuration="" if phase is None else tile.curve.declared.steps[phase].name,
        boundary=boundary,
        instant=instant,
        lower=lower,
        upper=upper,
        window=window,
        also=tuple(border[:] for border in also),
        enclosures={},
    )


def _bounds(tile: CheckedTile, which: Border | str, window: Any) -> tuple[Fraction, Fraction]:
    """Return two decimals near each other, between which an event's number is zero."""
    with flint_precision(SHARP):
        low, high = arb(tile.low), arb(tile.high)

        def at(value: arb) -> Any:
            others = tile.curve.near(tile.place, value, tile.centre(value))
            found = tile.number(which, with_entry(tile.place, value, others), 0, window)[0]
            return found.mid()

        zero = _zero(at, low.mid(), high.mid())
        width, digits = float(tile.high - tile.low), _DIGITS
        while width * 10.0 ** (digits - _DIGITS) < 1:
            digits += 1
        middle = Fraction(round(middle_fraction(zero) * 10**digits), 10**digits)
    half = Fraction(1, 10 ** (digits - 1))
    return middle - half, middle + half


def _zero(at: Callable[[arb], Any], low: arb, high: arb) -> Any:
    """Return a point near a zero of a function between two points, by the secant method."""
    places: list[Any] = [low, high]
    values = [at(low), at(high)]
    demand(not values[0] * values[1] > 0, "no event is found")
    least = (high - low) * arb(2) ** -_CLOSE
    for _ in range(_STEPS):
        rise = values[-1] - values[-2]
        demand(rise != 0, "no event is found")
        moved = (places[-1] - values[-1] * (places[-1] - places[-2]) / rise).mid()
        demand(low < moved < high, "no event is found")
        if abs(moved - places[-1]) < least:
            return moved
        places.append(moved)
        values.append(at(moved))
    raise Failure("no event is found")


def middle_fraction(ball: arb) -> Fraction:
    """Return the middle of a ball, exactly."""
    middle = ball.mid().fmpq()
    return Fraction(int(middle.p), int(middle.q))


def stated_branch(
    orbit: Orbit, box: Mapping[str, Interval], chosen: tuple[str, ...], region: Region | None
) -> CertifiedBranch:
    """Return a branch of which nothing is proved yet.

    `box` has the ends of its one parameter, `chosen` the parameters that were chosen because the
    orbit leaves them open. `region` is None where the branch's orbits are not covered.
    """
    ((parameter, interval),) = box.items()
    return CertifiedBranch(
        **stated_orbits(orbit, box, chosen, region),
        parameter=parameter,
        interval=interval,
        stability="stable" if region is None else region.closing.stability,
        unknown_names=() if region is None else region.subject.unknown_names,
        tiles=(),
        start=0,
        ends=("", ""),
    )


def checked_curve(branch: CertifiedBranch) -> tuple[Entries, CheckedCurve]:
    """Return a branch's entries without its tiles, as the checker reads them, and its equations.

    `NotCovered` if the checker refuses them.
    """
    content = as_read(file_json(replace(branch, tiles=())))
    with asking():
        return content, curve_of(content)


def checked_tile(curve: CheckedCurve, tile: BranchTile) -> CheckedTile:
    """Return a tile that is stated as the checker knows it."""
    return CheckedTile(curve, as_read(encode(tile)))
