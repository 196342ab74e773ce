"""What was proved of pieces of a branch, in the records that are shown and kept."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.proof.admissibility import OpenInequality
from nonsmooth.runtime.proof.boxes.orbit_over_box import given_of
from nonsmooth.runtime.proof.branch.certified_branch import (
    BranchEvent,
    BranchTile,
    CertifiedBranch,
)
from nonsmooth.runtime.proof.branch.crossing import SHARP, EventCrossing
from nonsmooth.runtime.proof.branch.curve import OrbitCurve
from nonsmooth.runtime.proof.branch.look import Look
from nonsmooth.runtime.proof.branch.tube import BranchTube
from nonsmooth.runtime.proof.certificate import Stated
from nonsmooth.runtime.proof.orbit_to_prove import system_of

if TYPE_CHECKING:
    from flint import arb

__all__ = ["STATED", "stated_branch", "stated_tile"]

STATED = 112  # bits of the numbers at an event


def stated_tile(
    curve: OrbitCurve, tube: BranchTube, found: Look, divided: int | None, *, forwards: bool
) -> BranchTile:
    """The tile that states what is proved of orbits in a tube.

    `divided` is the phase that may vanish, counted from 0, or None. `forwards` is True if the
    coordinate increases along the branch.
    """
    before, after = (found.below, found.above) if forwards else (found.above, found.below)
    return BranchTile(
        coordinate=curve.names[tube.coordinate],
        lower=tube.lower,
        upper=tube.upper,
        forwards=forwards,
        before=before,
        after=after,
        reason=found.reason,
        centre=tube.centre,
        radii=tube.radii,
        event=None if found.event is None else _event(curve, found.event),
        divided=divided,
    )


def _event(curve: OrbitCurve, found: EventCrossing) -> BranchEvent:
    from flint import arb

    which = found.which
    cycle = curve.region.cycle
    place = which.phase if isinstance(which, OpenInequality) else None
    with flint_precision(SHARP):
        # twice as wide, and what is exactly zero too has a radius: the check, whose equations are
        # others, finds its own
        least = arb(2) ** -STATED
        enclosures = {
            name: Stated.around(x + arb(0, x.rad() + least), STATED)
            for name, x in zip(curve.names, found.enclosures, strict=True)
        }
    return BranchEvent(
        kind=which.kind if isinstance(which, OpenInequality) else which,
        phase=place,
        configuration="" if place is None else cycle.itinerary[place][0],
        boundary=which.boundary if isinstance(which, OpenInequality) else "",
        instant=which.instant if isinstance(which, OpenInequality) else "",
        lower=found.lower,
        upper=found.upper,
        window=() if found.window is None else tuple(map(_fraction, found.window)),
        also=tuple((o.kind, o.phase, o.boundary, o.instant) for o in found.also),
        enclosures=enclosures,
    )


def _fraction(number: arb) -> Fraction:
    mantissa, exponent = (int(x) for x in number.mid().man_exp())
    return Fraction(mantissa) * Fraction(2) ** exponent


def stated_branch(
    orbit: Orbit, box: Any, chosen: tuple[str, ...], curve: OrbitCurve | None
) -> CertifiedBranch:
    """A branch of which nothing is proved yet.

    `box` has the ends of its one parameter, `chosen` the parameters that were chosen because the
    orbit leaves them open. `curve` is None where the branch's orbits are not covered.
    """
    ((parameter, interval),) = box.items()
    region = None if curve is None else curve.region
    declaration, closing = ({}, {}) if region is None else region.statement(orbit)
    return CertifiedBranch(
        orbit=orbit.name,
        system=system_of(orbit),
        parameters={n: value for n, value in given_of(orbit).items() if n != parameter},
        chosen=chosen,
        itinerary=() if region is None else region.cycle.itinerary,
        parameter=parameter,
        interval=interval,
        stability="stable" if region is None else region.closing.stability,
        unknown_names=() if curve is None else curve.names[:-1],
        tiles=(),
        start=0,
        ends=("", ""),
        declaration=declaration,
        closing=closing,
    )
