"""The proof on one tile of a box of parameters, in Taylor models of them.

The orbit is followed over the tile by polynomials of the parameters, Krawczyk's test shows
that there is exactly one next to them, and everything else is computed along these.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

from nonsmooth.runtime.core.taylor_models import (
    Model,
    Space,
    matrix,
    middle_of,
    range_of,
    space_of,
)
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.proof.admissibility import judge
from nonsmooth.runtime.proof.boxes.orbit_over_box import BITS, Region
from nonsmooth.runtime.proof.boxes.tile_places import Interval, Place
from nonsmooth.runtime.proof.cycle_equations import (
    Equations,
    equations_in,
    phases_of,
)
from nonsmooth.runtime.proof.exact_tables import Number, numbers, rational_of
from nonsmooth.runtime.proof.krawczyk import Contraction, Krawczyk, krawczyk, newton
from nonsmooth.runtime.proof.multipliers import (
    CORNER,
    inside_circle,
    neutral_pairs,
    product_of,
    reduced_map,
    trace_of,
)
from nonsmooth.runtime.shooting.variational import Phase, Shooting

if TYPE_CHECKING:
    from flint import arb

__all__ = ["Anchor", "Proof", "Tube", "conserved", "equations_over", "prove"]

_ORDERS = {1: 5, 2: 3}  # by the number of parameters: what costs least, measured
_LOWEST = 2
_CLOSE = 50  # bits of the orbit in the middle of a tile
_TRIES = 4  # sizes of Krawczyk's box
_ALIKE = 30  # bits to which numbers of one orbit agree, at least
_STABILITY = {
    True: "",
    False: "a multiplier lies outside the unit circle",
    None: "a multiplier may lie on the unit circle",
}


class Anchor(NamedTuple):
    """A point of the box, and about the orbit there: whatever is found has to be that."""

    point: tuple[Fraction, ...]
    numbers: Sequence[arb]


@dataclass(frozen=True, eq=False)
class Tube:
    """The orbit over a tile, between polynomials of the parameters.

    Attributes
    ----------
    place : Place
    box : tuple of (Fraction, Fraction)
        Of all tiles.
    unknowns : sequence of Model
    """

    place: Place
    box: tuple[Interval, ...]
    unknowns: Sequence[Model]

    def at(self, point: Sequence[Fraction]) -> list[arb]:
        """Balls around the unknowns at a point of the tile."""
        from flint import arb

        with flint_precision(BITS):
            inside = []
            for axis, x in enumerate(point):
                low, high = self.place.interval(axis, self.box)
                inside.append(arb(rational_of((2 * x - low - high) / (high - low))))
            return [x.at(inside) for x in self.unknowns]


@dataclass(frozen=True, eq=False)
class Proof:
    """What is proved on a tile.

    Attributes
    ----------
    existence, admissibility, stability : {"proved", "refuted", "undecided"}
    reasons : dict of str to str
        Why a claim is not proved.
    enclosures : dict of str to arb
        Trace, period, dwell times and start, for all parameters of the tile.
    tube : Tube or None
        Where existence is proved.
    """

    existence: str
    admissibility: str
    stability: str
    reasons: dict[str, str]
    enclosures: dict[str, arb]
    tube: Tube | None


def prove(region: Region, place: Place, anchor: Anchor, *, rough: bool) -> Proof:
    """Prove what can be proved on a tile.

    Parameters
    ----------
    region : Region
    place : Place
    anchor : Anchor
        In the tile.
    rough : bool
        Whether a low order will do, since only admissibility is left to be decided.
    """
    count = len(region.names)
    space = space_of(count, _LOWEST if rough else _ORDERS.get(count, _LOWEST))
    with flint_precision(BITS):
        return _prove(region, place, anchor, space)


def equations_over(region: Region, number: Number) -> Equations:
    """The equations of a region's orbit in numbers."""
    closing = region.closing
    period = None if closing.period is None else number(closing.period)
    phases = phases_of(region.tables, region.cycle, number, closing.translations)
    return equations_in(phases, closing, number, period)


def _prove(region: Region, place: Place, anchor: Anchor, space: Space) -> Proof:
    number = region.number(_variables(region, place, space))
    equations = equations_over(region, number)
    closing = equations.closing
    start = _followed(equations, anchor.numbers, space)
    if start is None:
        return _undecided("Newton's method finds no orbit in the middle")
    found = _contracted(Krawczyk(equations, start))
    if found is None:
        return _undecided("Krawczyk's test fails")
    tube = Tube(place, region.box, found.image)
    if not _joined(region, anchor, tube.at(anchor.point)):
        return _undecided("another orbit may have been found")
    now = equations.linearised(found.image, found.flows).shooting
    dwell = equations.dwell(found.image)
    if closing.form is not None and not conserved(region, number, now):
        return _undecided("the energy does not give the coordinate that is left out")
    maps = equations.maps(now)
    square = reduced_map(maps, region.known, closing, number)
    total = trace_of(square)
    trace = range_of(total)
    inside: bool | None = None
    told = _STABILITY[None]
    if region.cycle.one_sided:
        told = CORNER
    elif trace.is_finite():
        if closing.form is not None:
            inside, _ = neutral_pairs(range_of(product_of(maps)), trace)
        else:
            inside = inside_circle(square)
        told = _STABILITY[inside]
    stability = {True: "proved", False: "refuted", None: "undecided"}[inside]
    judgement = judge([plan.at(number) for plan in region.plans], equations.phases, now, dwell)
    subject = region.subject
    shown = total + len(closing.translations)
    named = {"trace": shown, "period": sum(dwell[1:], dwell[0])}
    named |= dict(zip(subject.dwell_names, dwell, strict=True))
    named |= dict(zip(subject.start_names, now.starts[0].entries()[:-1], strict=True))
    enclosures = {name: _wider(number) for name, number in named.items()}
    reasons = {"admissibility": judgement.reason, "stability": told}
    reasons = {name: reason for name, reason in reasons.items() if reason}
    return Proof("proved", judgement.verdict, stability, reasons, enclosures, tube)


def _joined(region: Region, anchor: Anchor, found: Sequence[arb]) -> bool:
    """Whether what was found is the anchor's orbit: one box there holds both, and one root."""
    from flint import arb

    number = region.number([arb(rational_of(x)) for x in anchor.point])
    both = [x.union(y) for x, y in zip(found, anchor.numbers, strict=True)]
    centre = [x.mid() for x in both]
    radii = [2 * x.rad() + (1 + abs(x)) * arb(2) ** -_ALIKE for x in both]
    if not all(r.is_finite() for r in radii):
        return False
    return krawczyk(equations_over(region, number), centre, [r.upper() for r in radii]).unique


def _wider(number: Any) -> arb:
    """All values, with twice what is not known of the polynomial: the check finds its own."""
    from flint import arb

    ball = range_of(number)
    found: arb = ball + arb(0, number.rad() + (1 + abs(ball)) * arb(2) ** (16 - BITS))
    return found


def _undecided(reason: str) -> Proof:
    return Proof("undecided", "undecided", "undecided", {"existence": reason}, {}, None)


def _variables(region: Region, place: Place, space: Space) -> list[Model]:
    """The parameters on a tile."""
    from flint import arb

    found = []
    for axis in range(len(region.names)):
        lower, upper = (rational_of(end) for end in place.interval(axis, region.box))
        found.append(space.variable(axis, arb((lower + upper) / 2), arb((upper - lower) / 2)))
    return found


def _followed(equations: Equations, guess: Sequence[arb], space: Space) -> list[Any] | None:
    """Polynomials near the orbit, by Newton's method; nothing is proved of them."""
    middle = _mapped(equations, middle_of)
    found = newton(lambda precision: middle, guess, _CLOSE)
    if found is None:
        return None
    for order in (1, space.order):  # each step doubles the order that is right, and more
        rough = space_of(space.variables, order)

        def cut(number: Any, rough: Space = rough) -> Model:
            middle = number.mid()
            return middle.cast(rough) if isinstance(number, Model) else rough.constant(middle)

        centre = list(map(cut, found))
        missed = Krawczyk(_mapped(equations, cut), centre).missed
        if not missed or not all(range_of(d).is_finite() for d in missed):
            return None
        found = [(x + d).mid() for x, d in zip(centre, missed, strict=True)]
    return found


def _mapped(equations: Equations, change: Callable[[Any], Any]) -> Equations:
    """The same equations in other numbers."""
    period = equations.period
    return Equations(
        [Phase(*map(change, phase)) for phase in equations.phases],
        equations.closing,
        None if period is None else change(period),
        list(map(change, equations.speeds)),
    )


def _contracted(test: Krawczyk) -> Contraction | None:
    """A box around the polynomials that Krawczyk's map takes into itself, if there is one."""
    from flint import arb

    unit = arb(2) ** -_CLOSE
    moved = [abs(range_of(d)) for d in test.missed]
    for _ in range(_TRIES if moved else 0):
        if not all(d.is_finite() for d in moved):
            return None
        found = test([(2 * d + unit).upper() for d in moved])
        if found.unique:
            return found
        moved = [abs(range_of(x - c)) for x, c in zip(found.image, test.centre, strict=True)]
    return None


def conserved(region: Region, number: Number, now: Shooting) -> bool:
    """Whether the energy returns the coordinate whose closure was dropped."""
    closing, first, last = region.closing, now.starts[0], now.starts[-1]
    assert closing.form is not None
    omega = range_of(numbers(closing.form.omega, number))
    if omega.det().contains(0):
        return False
    k = closing.dropped
    between = range_of(first).entries()
    between[k] = between[k].union(range_of(last)[k, 0])
    energy = range_of(numbers([closing.form.energies[region.cycle.configurations[0]][k]], number))
    slope = (energy * matrix([[x] for x in between]))[0, 0]
    return bool(slope > 0 or slope < 0)
