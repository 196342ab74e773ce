"""One event on a tile of two parameters: a curve that divides the tile into two sides.

The search says which number is zero at the event, and where it is zero about: a polynomial of one
of the parameters. The checker proves that there is one event, in a band, and what is beside it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields
from fractions import Fraction
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
from flint import arb

from nonsmooth.runtime.checker.orbits.motion import Border, time_of_touch
from nonsmooth.runtime.checker.orbits.orbit import CheckedOrbit
from nonsmooth.runtime.checker.orbits.stability import MULTIPLIERS, characteristic, passing
from nonsmooth.runtime.checker.ranges.divided import Band, DividingCurve
from nonsmooth.runtime.checker.ranges.folded import BEYOND
from nonsmooth.runtime.checker.stated.exact import Failure, demand
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.float_sets import Floats
from nonsmooth.runtime.core.json_codec import FromOne, Ordinal, Several, one_of
from nonsmooth.runtime.core.taylor_models import TaylorModel, middle_of, range_of
from nonsmooth.runtime.proof.exact_tables import rational_of
from nonsmooth.runtime.proof.orbit_to_prove import NotCovered
from nonsmooth.runtime.proof.refusals import asking

if TYPE_CHECKING:
    from nonsmooth.runtime.checker.ranges.tiles import MapTile
    from nonsmooth.runtime.proof.boxes.certify_box import BoxRefusals

__all__ = [
    "BEYOND",
    "Events",
    "Fold",
    "Instant",
    "Side",
    "TileEvent",
    "WhatHappens",
    "chebyshev_nodes",
    "event_on",
    "through_nodes",
    "touching_window",
    "window_balls",
]

_PLANE = 2  # parameters of a box with curves, and the fewest coefficients of one
_FARTHEST = 3.0  # of a curve from the middle of its tile; half of the tile is 1
_STEPS = 12
_TIMES = 256  # of a phase, at which a function is looked at


_OTHERS = ("proved", "unstable", "not admissible")
Side = Annotated[str, one_of(("below", "above"))]
Instant = Annotated[str, one_of(("", "start", "inside", "end"))]
# kinds, phases, boundaries and instants of events
Events = tuple[tuple[str, Ordinal, str, Instant], ...]


@dataclass(frozen=True, kw_only=True)
class BandEntries:
    """Entries for a band about a curve: the parameter across by its number, from 1."""

    axis: Ordinal
    centre: tuple[float, ...]
    radius: float


def _band(found: BandEntries) -> Band:
    if found.axis not in (0, 1) or len(found.centre) < _PLANE:
        raise InputError("a curve crosses no parameter of the box")
    return Band(found.axis, found.centre, found.radius)


KeptBand = Annotated[Band, Several(BandEntries, lambda band: BandEntries(**band._asdict()), _band)]


@dataclass(frozen=True)
class Fold:
    """Two sheets of orbits that meet along a curve: a tube around both.

    In the tube one unknown is within `half` of a polynomial of the parameter along the curve.
    The other unknowns, and the parameter across, are near functions of these two.
    """

    coordinate: str  # the unknown of the orbit's equations that distinguishes the orbits
    # coefficients of the polynomial: where the orbits meet, approximately
    centre: tuple[float, ...]
    half: float  # half of the tube's width in that unknown
    sheet: Side  # the map's own sheet, by that unknown
    other: Annotated[str, one_of(_OTHERS)]  # verdict on the other sheet


@dataclass(frozen=True, eq=False)
class WhatHappens:
    """An event of an orbit, and where in its cycle it happens."""

    # "flip", "neimark-sacker", "fold", or a border: "grazing", "tangent", "entry", "simultaneous",
    # "vanishing-phase"
    kind: str
    phase: FromOne
    configuration: str
    boundary: str
    instant: Instant

    @staticmethod
    def of(event: WhatHappens) -> WhatHappens:
        """Only that, of an event of which more is known."""
        return WhatHappens(**{own.name: getattr(event, own.name) for own in fields(WhatHappens)})


@dataclass(frozen=True)
class TileEvent(WhatHappens):
    """A curve of one event that divides a tile.

    Verdicts are "proved", "unstable", "not admissible" or "beyond a fold". They hold for all
    parameters below the band and above it, along its axis.
    """

    # times in the phase of a grazing (perhaps in `also`) between which the boundary function is
    # concave
    window: tuple[Fraction, ...]
    # kind, phase, boundary and instant of further events in the same band
    also: Events
    band: KeptBand
    below: Annotated[str, one_of((*_OTHERS, BEYOND))]  # verdict below the band
    above: Annotated[str, one_of((*_OTHERS, BEYOND))]  # verdict above the band
    # the orbits that meet; on the side beyond the fold none is in their tube
    fold: Fold | None

    @property
    def name(self) -> tuple[str, int | None, str, str]:
        """Kind, phase, boundary and instant, which distinguish the orbit's events."""
        return self.kind, self.phase, self.boundary, self.instant


def event_on(judge: BoxRefusals, tile: MapTile, orbit: CheckedOrbit) -> TileEvent | None:
    """The event that divides a judged tile of two parameters; None where the checker proves none.

    `orbit` is the tile's, in Taylor models.
    """
    try:
        proposed = _proposed(tile, orbit)
        if proposed is None:
            return None
        curve, window = proposed
        with asking():
            found = tile.divide(orbit, curve)
            judge.box.check_divisors()
    except (Failure, NotCovered):
        return None
    assert found.band is not None
    first = curve.borders[0] if curve.borders else None
    return TileEvent(
        kind=curve.kind,
        phase=first.phase if first else None,
        configuration=found.phases(orbit),
        boundary=first.boundary if first else "",
        instant=first.instant if first else "",
        window=window,
        also=tuple((b.kind, b.phase, b.boundary, b.instant) for b in curve.borders[1:]),
        band=found.band,
        below=found.beside[0],
        above=found.beside[1],
        fold=None,
    )


def _proposed(
    tile: MapTile, orbit: CheckedOrbit
) -> tuple[DividingCurve, tuple[Fraction, ...]] | None:
    """The event that its verdicts leave open, its curve, about, and the window of a grazing.

    None if there is no such one.
    `Failure` as from what the checker knows of the orbit.
    """
    admissible, stable = (tile.verdicts[name] for name in ("admissibility", "stability"))
    borders: tuple[Border, ...] = ()
    window: tuple[Fraction, ...] = ()
    times: Any = None
    if (admissible.claim, stable.claim) == ("proved", "undecided"):
        kind = _open_kind(orbit)
        number = passing(characteristic(orbit.section), kind) if kind else None
    elif admissible.claim == "undecided" != stable.claim and None not in admissible.found:
        # a phase that vanishes ends where the one before it does
        borders = tuple(sorted(admissible.found, key=lambda b: b.kind != "vanishing-phase"))
        for border in borders:
            if border.kind == "grazing":
                window = touching_window(orbit, border)
        kind = borders[0].kind
        times = window_balls(window)
        time = time_of_touch(orbit, borders[0], times) if kind == "grazing" else None
        number = borders[0].number(orbit, time)
    else:
        return None
    if not isinstance(number, TaylorModel):
        return None
    rates = [abs(_coefficient(number, axis)) for axis in (0, 1)]
    axis = int(rates[1] > rates[0])
    centre = _curve(number, axis)
    if centre is None:
        return None
    return DividingCurve(kind, borders, times, axis, centre), window


def _open_kind(orbit: CheckedOrbit) -> str:
    """The one way to pass the unit circle that is not excluded; "" where it is none, or a fold."""
    if orbit.declared.stability == "neutral":
        return "flip"
    polynomial = characteristic(orbit.section)
    kinds = [kind for kind in MULTIPLIERS if kind != "neimark-sacker" or len(polynomial) > 2]
    signs = [range_of(passing(polynomial, kind)) for kind in kinds]
    left = [kind for kind, x in zip(kinds, signs, strict=True) if not (x > 0 or x < 0)]
    return left[0] if len(left) == 1 and left != ["fold"] else ""


def touching_window(orbit: CheckedOrbit, border: Border) -> tuple[Fraction, Fraction]:
    """Return times about the highest maximum of a boundary function inside its phase.

    Each is half as far from it as the times at which the function ceases to be concave, in the
    middle of the parameters. `Failure` is raised if there is no maximum.
    """
    field, state = (middle_of(x[border.phase]) for x in (orbit.chain.fields, orbit.now.starts))
    time = middle_of(orbit.dwell[border.phase]) / _TIMES
    row = middle_of(orbit.numbers([border.watched(orbit).row]))
    step, rates = (field * time).exp().mid(), (row * field * field).mid()
    values, bends = [], []
    for _ in range(_TIMES + 1):
        values.append(float((row * state)[0, 0].mid()))
        bends.append(float((rates * state)[0, 0].mid()))
        state = (step * state).mid()
    inside = range(1, _TIMES)
    tops = [k for k in inside if bends[k] < 0 and values[k] == max(values[k - 1 : k + 2])]
    demand(tops, "no maximum inside of the phase is found")
    top = first = last = max(tops, key=lambda k: values[k])
    while first > 0 and bends[first] < 0:
        first -= 1
    while last < _TIMES and bends[last] < 0:
        last += 1
    begin, end = (Fraction(f"{float(time) * (top + k) / 2:.6g}") for k in (first, last))
    return begin, end


def window_balls(window: Sequence[Fraction]) -> Any:
    """Return the window of a grazing as balls, None without one."""
    return tuple(arb(rational_of(time)) for time in window) or None


def _coefficient(number: TaylorModel, axis: int) -> float:
    place = number.space.exponents.index(tuple(int(k == axis) for k in range(2)))
    part = number.parts[place]
    return 0.0 if part is None else float(part.mid())


def _curve(number: TaylorModel, axis: int) -> tuple[float, ...] | None:
    """Approximate zeros of a number, as a polynomial of the other parameter; None if far away."""
    order = number.space.order
    table = np.zeros((order + 1, order + 1))  # by powers along the axis, and of the other
    for part, exponents in zip(number.parts, number.space.exponents, strict=True):
        if part is not None:
            table[exponents[axis], exponents[1 - axis]] = float(part.mid())
    slopes = np.arange(1, order + 1)[:, None] * table[1:]
    nodes = chebyshev_nodes(order + 1)
    found = np.zeros_like(nodes)
    for _ in range(_STEPS):
        with np.errstate(all="ignore"):
            value = np.polynomial.polynomial.polyval2d(found, nodes, table)
            found = found - value / np.polynomial.polynomial.polyval2d(found, nodes, slopes)
        if not (np.isfinite(found).all() and abs(found).max() < _FARTHEST):
            return None
    return through_nodes(found)


def chebyshev_nodes(count: int) -> Floats:
    """Return so many Chebyshev nodes between -1 and 1."""
    return np.cos(np.pi * (np.arange(count) + 0.5) / count)


def through_nodes(values: Sequence[float] | Floats) -> tuple[float, ...]:
    """Return coefficients of the polynomial through values at as many Chebyshev nodes."""
    powers = np.vander(chebyshev_nodes(len(values)), increasing=True)
    return tuple(np.linalg.solve(powers, values).tolist())
