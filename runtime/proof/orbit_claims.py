"""What follows for an orbit that is proved to exist: stability, admissibility, enclosures.

All is for every parameter of a tile, in Taylor models of them. A point is a tile of no
parameters, and its Taylor models are balls.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import Any, NamedTuple

from nonsmooth.runtime.checker.stability import CORNER, TANGENTIAL
from nonsmooth.runtime.core.taylor_models import matrix, range_of
from nonsmooth.runtime.proof.admissibility import Judgement, OpenInequality, judge
from nonsmooth.runtime.proof.boxes.orbit_over_box import Region
from nonsmooth.runtime.proof.exact_tables import Number, numbers
from nonsmooth.runtime.proof.multipliers import (
    inside_circle,
    on_circle,
    product_of,
    reduced_map,
    trace_of,
)
from nonsmooth.runtime.proof.orbit_equations import Equations
from nonsmooth.runtime.shooting.variational import Phase, Shooting

__all__ = [
    "NOT_CONSERVED",
    "MapClaim",
    "claim_of_map",
    "conserved",
    "judged",
    "unstable_if_reached",
]

NOT_CONSERVED = "the energy does not give the coordinate that is left out"


class MapClaim(NamedTuple):
    """What is proved of an orbit's multipliers."""

    verdict: str  # "proved", "refuted" or "undecided"
    reason: str  # why it is not proved
    trace: Any = None  # None where a boundary may be reached tangentially
    section: Any = None  # derivative of the Poincare map on the smallest section that is known


def claim_of_map(region: Region, number: Number, equations: Equations, now: Shooting) -> MapClaim:
    """Enclose the trace of the Poincare map and decide on which side of the circle multipliers are.

    `now` is the passage through the cycle over the enclosures. The claim is that all multipliers
    are inside the circle, or, for a conservative cycle, that all nontrivial ones are on it.
    """
    closing = region.closing
    maps = equations.maps(now)
    if not all(x.is_finite() for found in maps for x in range_of(found).entries()):
        return MapClaim("undecided", TANGENTIAL)
    section = reduced_map(maps, region.invariants, closing, number)
    trace = trace_of(section) + len(closing.translations)
    if closing.form is not None:
        inside = on_circle(range_of(product_of(maps)), range_of(trace))
        unknown = "a nontrivial pair of multipliers cannot be told from a double one"
    else:
        inside = inside_circle(section)
        unknown = "a multiplier cannot be told from the unit circle"
    verdict, reason = {
        True: ("proved", ""),
        False: ("refuted", "a multiplier lies outside the unit circle"),
        None: ("undecided", unknown),
    }[inside]
    if region.cycle.one_sided:
        verdict, reason = "undecided", CORNER
    return MapClaim(verdict, reason, trace, section)


def unstable_if_reached(
    region: Region, number: Number, equations: Equations, now: Shooting, place: int
) -> bool:
    """Whether orbits that reach a boundary with any positive speed are proved to be unstable.

    The map has that speed in its denominator. Multiplied by it the map is regular, and has rank
    one where the speed is zero. If the absolute value of its trace is above n times the speed, a
    multiplier lies outside the unit circle: next to the grazing of a rigid stop it grows beyond all
    bounds (A. Nordmark, Non-periodic motion caused by grazing incidence in an impact oscillator,
    J. Sound Vib. 145, 1991). `place` is the phase, counted from 0, that the boundary ends.
    """
    if region.closing.form is not None or region.cycle.one_sided:
        return False
    maps, speed = equations.maps(now, place), equations.speed(now, place)
    if not all(x.is_finite() for found in maps for x in range_of(found).entries()):
        return False
    section = reduced_map(maps, region.invariants, region.closing, number)
    trace, bound = trace_of(section), speed * section.nrows()
    above, below = trace - bound, trace + bound
    return bool((above > 0 and below > 0) or (above < 0 and below < 0))


def judged(
    region: Region,
    number: Number,
    phases: Sequence[Phase],
    now: Shooting,
    dwell: Sequence[Any],
    assumed: Collection[OpenInequality] = (),
) -> Judgement:
    """Judge whether an orbit is a motion of the system, in the numbers of its phases.

    It is "undecided" where the cycle's invariants are not known. Inequalities in `assumed` are
    taken to hold.
    """
    if region.invariants is None:
        reason = "the declaration takes a root or a sine: what is exactly zero is not known"
        return Judgement("undecided", reason, ())
    return judge([plan.at(number) for plan in region.plans], phases, now, dwell, assumed)


def conserved(region: Region, number: Number, now: Shooting) -> bool:
    """Whether energy conservation is proved to give the coordinate whose closure was dropped.

    It is True for a cycle that keeps no energy: then nothing was dropped.
    """
    closing, first, last = region.closing, now.starts[0], now.starts[-1]
    if closing.form is None:
        return True
    omega = range_of(numbers(closing.form.omega, number))
    if omega.det().contains(0):
        return False
    k = closing.dropped
    between = range_of(first).entries()
    between[k] = between[k].union(range_of(last)[k, 0])
    energy = range_of(numbers([closing.form.energies[region.cycle.configurations[0]][k]], number))
    slope = (energy * matrix([[x] for x in between]))[0, 0]
    return bool(slope > 0 or slope < 0)
