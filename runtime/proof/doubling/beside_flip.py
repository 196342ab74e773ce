"""The doubled orbits next to one flip: from its direction to their side and verdict."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.jets import part_of
from nonsmooth.runtime.core.taylor_models import space_of
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.proof.boxes.orbit_over_box import BITS, Region
from nonsmooth.runtime.proof.branch.certified_branch import UNDECIDED
from nonsmooth.runtime.proof.branch.curve import OrbitCurve, linearised_by_parameter
from nonsmooth.runtime.proof.branch.passage import CyclePassage, others_at_circle
from nonsmooth.runtime.proof.branch.tube import BranchTube, orbit_near
from nonsmooth.runtime.proof.doubling.doubled_equations import DoubledEquations
from nonsmooth.runtime.proof.doubling.doubling_tube import FLIP, ORDER, ProvedTube, flip_near
from nonsmooth.runtime.proof.exact_tables import rational_of

if TYPE_CHECKING:
    from flint import arb

    from nonsmooth.runtime.proof.branch.certified_branch import BranchTile, CertifiedBranch

__all__ = [
    "begin_of_branch",
    "begins_with",
    "covered",
    "doubled_guess",
    "flip_with_direction",
    "in_tile",
    "in_tube",
    "start_of",
    "verdict_of",
]

_WIDER = 15  # times the radii: what the check has to tell them from
_DEEPEST = 3  # halvings of a tube whose orbits are judged
_SHARE = 0.75  # of the largest amplitude: where the doubled branch begins


def covered(region: Region) -> str:
    """Return why the method does not go beyond flips of a cycle, or an empty text if it does."""
    closing = region.closing
    if closing.form is not None or closing.kind == "period":
        return "the orbits of a conservative system, or of a given period, are not covered"
    if closing.translations:
        return "orbits that close up to a shift are not covered"
    if region.cycle.one_sided:
        return "boundaries are reached together: the Poincare map has a corner"
    return ""


def flip_with_direction(region: Region, point: Sequence[arb]) -> tuple[int, list[arb]] | None:
    """Return a flip near a point, with the direction in which its orbit doubles, or None.

    The region is over one parameter, and the point is about the cycle's unknowns and the parameter.
    The largest entry of the direction becomes 1. Its number is returned, and enclosures of the
    orbit's unknowns, of the direction without that entry, and of the parameter. None is returned
    if no flip is proved to be there.
    """
    from flint import arb

    with flint_precision(FLIP):
        middles = [x.mid() for x in point]
        now = linearised_by_parameter(OrbitCurve(region), middles[:-1], middles[-1])
        slopes = part_of(now.jacobian, 0)
        turned = slopes + 2 * DoubledEquations(region, 0, arb(0)).closure(middles[-1])
        size = len(middles) - 1
        rows = np.array([[float(turned[i, j].mid()) for j in range(size)] for i in range(size)])
        away = np.linalg.svd(rows)[2][-1]
        scaled = int(np.argmax(abs(away)))
        others = [arb(float(x / away[scaled])) for k, x in enumerate(away) if k != scaled]
        found = flip_near(region, scaled, [*middles[:-1], *others, middles[-1]])
    return None if found is None else (scaled, found)


def begin_of_branch(proved: ProvedTube) -> Fraction:
    """Return a short decimal: the parameter, inside a tube, at which the doubled branch begins."""
    value = float(proved.flip[-1].mid())
    away = float(proved.rate.mid()) * (_SHARE * float(proved.tube.amplitude)) ** 2
    digits = max(0, 2 - math.floor(math.log10(abs(away))))
    return Fraction(round(Fraction(value + away) * 10**digits), 10**digits)


def doubled_guess(proved: ProvedTube, value: Fraction) -> list[arb]:
    """Return the unknowns of the doubled orbit, about, at a value of the parameter in a tube."""
    from flint import arb

    with flint_precision(FLIP):
        square = (arb(rational_of(value)) - proved.flip[-1]) / proved.rate
        amplitude = square.mid().max(arb(0)).sqrt()
        place = amplitude / arb(rational_of(proved.tube.amplitude))
        return [x.at([place]).mid() for x in proved.point[:-1]]


def start_of(region: Region, guess: Sequence[arb], value: Fraction) -> list[float]:
    """Return the state at which an orbit begins, about, at a value of the parameter.

    `guess` holds unknowns of the equations of the cycle, or of the doubled cycle, whose half the
    region then is.
    """
    from flint import arb

    with flint_precision(BITS):
        equations = region.equations(region.tables.number_at([arb(rational_of(value))]))
        state, _ = equations.start(guess[: equations.count])
        return [float(x) for x in state.entries()[:-1]]


def in_tile(curve: OrbitCurve, tile: BranchTile, flip: Sequence[arb]) -> bool:
    """Whether a flip with its direction is proved to be the one of a branch's tile.

    `flip` encloses the unknowns, the direction without its entry 1, and the parameter. Of tiles
    whose equations are divided by a dwell time it is never proved.
    """
    from flint import arb

    names = curve.names
    place = len(names) - 1 if tile.coordinate == names[-1] else names.index(tile.coordinate)
    point = [*flip[: len(names) - 1], flip[-1]]
    with flint_precision(FLIP):
        low, high = (arb(rational_of(end)) for end in (tile.lower, tile.upper))
        inside = bool(point[place] > low and point[place] < high)
        return tile.divided is None and inside and _holds(tile, place, point)


def begins_with(branch: CertifiedBranch, value: Fraction, orbit: Sequence[arb]) -> bool:
    """Whether a branch is proved to begin with an orbit at a value of the parameter.

    `orbit` encloses its unknowns and the parameter. Where the tile's equations are divided by a
    dwell time, the orbit solves them too, for that time is not zero.
    """
    tile = branch.tiles[0 if branch.start == 0 else -1]
    names = (*branch.unknown_names, branch.parameter)
    if tile.coordinate != names[-1] or value not in (tile.lower, tile.upper):
        return False
    if tile.divided is not None and not orbit[tile.divided - len(branch.itinerary) - 1] > 0:
        return False
    with flint_precision(FLIP):
        return _holds(tile, len(names) - 1, orbit)


def _holds(tile: BranchTile, place: int, point: Sequence[arb]) -> bool:
    """Whether a point between the ends of a tile is in its tube, at the working precision."""
    tube = BranchTube(place, tile.lower, tile.upper, tile.centre, tile.radii)
    return tube.holds(point[place], [*point[:place], *point[place + 1 :]])


def in_tube(proved: ProvedTube, doubled: Region, orbit: Sequence[arb]) -> bool:
    """Whether an orbit of the doubled cycle is proved to be one of a tube.

    `doubled` is the region of the doubled cycle, over the same parameter, and `orbit` encloses the
    unknowns of its equations and the parameter.
    """
    passage = CyclePassage(doubled, orbit)
    equations, half = passage.equations, len(passage.equations.phases) // 2
    dwell = list(passage.dwell)
    behind = passage.shooting.starts[half]
    first = [*orbit[: equations.first], *dwell[:half]]
    second = [behind[k, 0] for k in equations.free]
    if equations.closing.pairs:
        second.append(orbit[equations.first - 1] + sum(dwell[:half], -equations.period / 2))
    second += dwell[half:]
    middle = [(x + y) / 2 for x, y in zip(first, second, strict=True)]
    apart = [(x - y) / 2 for x, y in zip(first, second, strict=True)]
    scaled = proved.tube.scaled
    amplitude = apart[scaled]
    if not (amplitude > 0 or amplitude < 0):
        return False
    away = [x / amplitude for k, x in enumerate(apart) if k != scaled]
    return proved.tube.holds(amplitude, [*middle, *away, orbit[-1]])


def verdict_of(
    proved: ProvedTube, doubled: Region, value: Fraction
) -> tuple[str, str, list[arb] | None]:
    """Return the verdict on all orbits of a tube whose amplitude is not zero.

    None of their multipliers is 1, for the parameter changes all along the tube. Where none is -1
    and no two have the product 1, as many are inside the unit circle as at one orbit. The verdict
    "stable", "unstable" or "undecided" comes with the reason, and with the enclosed orbit at
    `value` of the parameter if it is proved to be in the tube.
    """
    from flint import arb

    curve = OrbitCurve(doubled)
    with flint_precision(FLIP):
        at = arb(rational_of(value))
        guess = doubled_guess(proved, value)
        orbit = orbit_near(curve, curve.parameter, at, guess, FLIP)
        if orbit is None or not in_tube(proved, doubled, orbit):
            return UNDECIDED, "no doubled orbit is proved to be in the tube", None
        there = CyclePassage(doubled, orbit).stability.verdict
    with flint_precision(doubled.bits):
        # wider, for the check multiplies the phases' maps in another order
        wide = [x + arb(0, _WIDER * x.rad()) for x in proved.point]
        reason = _undecided_on(doubled, wide)
    if reason:
        return UNDECIDED, reason, orbit
    words = {"proved": "stable", "refuted": "unstable"}
    if there not in words:
        return UNDECIDED, "the multipliers at one orbit are not told from the unit circle", orbit
    return words[there], "", orbit


def _undecided_on(doubled: Region, point: Sequence[Any], depth: int = 0) -> str:
    """Return why a part of a tube is not decided, or an empty text if it is.

    Its orbits have to be motions of the system, and their multipliers apart from the unit circle.
    """
    from flint import arb

    passage = CyclePassage(doubled, point)
    judgement = passage.judged()
    if judgement.verdict == "refuted":
        return judgement.reason or "a doubled orbit is no motion of the system"
    reason = judgement.reason
    if judgement.verdict == "proved":
        if passage.section is None:
            return "the Poincare map is not known"
        if not others_at_circle(passage, "fold"):
            return ""
        reason = "multipliers may pass the unit circle next to the flip"
    if depth == _DEEPEST:
        return reason
    for side in (-1, 1):
        e = space_of(1, ORDER).variable(0, arb(side) / 2, arb(1) / 2)
        if reason := _undecided_on(doubled, [x.at([e]) for x in point], depth + 1):
            return reason
    return ""
