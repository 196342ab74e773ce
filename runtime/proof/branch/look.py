"""What is proved of one tile of a branch: its verdict, or one event and the verdicts beside it."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from nonsmooth.runtime.core.jets import part_of
from nonsmooth.runtime.core.taylor_models import range_of
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.proof.admissibility import Judgement, OpenInequality
from nonsmooth.runtime.proof.branch.crossing import SHARP, EventCrossing, Which, crossing_of
from nonsmooth.runtime.proof.branch.curve import OrbitCurve, directions
from nonsmooth.runtime.proof.branch.passage import CyclePassage, others_at_circle, passed_by
from nonsmooth.runtime.proof.branch.tube import Piece, orbit_at
from nonsmooth.runtime.proof.exact_tables import rational_of
from nonsmooth.runtime.proof.multipliers import check_pair
from nonsmooth.runtime.proof.orbit_claims import NOT_CONSERVED
from nonsmooth.runtime.proof.orbit_to_prove import NotCovered

if TYPE_CHECKING:
    from collections.abc import Sequence

__all__ = ["NOT_ADMISSIBLE", "UNDECIDED", "Look", "look"]

NOT_ADMISSIBLE, UNDECIDED = "not admissible", "undecided"
_TURNS = "the branch may turn"


class Look(NamedTuple):
    """What is proved on a tile."""

    below: str  # verdict at its lower end
    above: str  # verdict at its upper end; the same as below without an event
    reason: str  # why it is undecided
    # the one place in it where the verdict changes, or the branch turns
    event: EventCrossing | None = None

    @property
    def ends(self) -> bool:
        """Whether the branch turns where a phase vanishes: no orbits lie beyond."""
        return self.event is not None and any(w.kind == "fold" for w in self.event.also)

    @property
    def decided(self) -> bool:
        """Whether every point of the tile has a verdict, but for the event itself."""
        return UNDECIDED not in (self.below, self.above)


def look(curve: OrbitCurve, piece: Piece) -> Look:
    """Judge a tile whose orbits are proved."""
    with flint_precision(curve.region.bits):
        passage = CyclePassage(curve.region, piece.point)
        if not passage.conserved:
            return _undecided(NOT_CONSERVED)
        judgement = passage.judged()
        turns = _turns(curve, piece)
        vanishes = curve.region.short is not None and judgement.verdict == "undecided"
        if turns is None and not vanishes:
            return _turned(curve, piece, passage, judgement)
        if turns is False:
            return _undecided("the derivative along the branch is not known")
        if judgement.verdict == "refuted":
            return Look(NOT_ADMISSIBLE, NOT_ADMISSIBLE, "")
        verdict = _told(curve, passage.stability.verdict)
        if judgement.verdict == "proved":
            if verdict != UNDECIDED:
                return Look(verdict, verdict, "")
            return _multipliers(curve, piece, passage)
        return _border(curve, piece, passage, judgement, verdict, turns=turns is None)


def _undecided(reason: str) -> Look:
    return Look(UNDECIDED, UNDECIDED, reason)


def _told(curve: OrbitCurve, verdict: str) -> str:
    """The verdict of a claim on multipliers, in the words of a branch."""
    words = {"proved": curve.region.closing.stability, "refuted": "unstable"}
    return words.get(verdict, UNDECIDED)


def _turns(curve: OrbitCurve, piece: Piece) -> bool | None:
    """True if the parameter changes all along a tile, None if it may turn, False if unknown."""
    coordinate = piece.tube.coordinate
    if coordinate == curve.parameter:
        return True
    found = directions(curve, coordinate, piece.point, 1)
    if found is None:
        return False
    slope = range_of(part_of(found[-1], 1))
    return True if slope > 0 or slope < 0 else None


def _turned(curve: OrbitCurve, piece: Piece, passage: CyclePassage, judgement: Judgement) -> Look:
    """Judge a tile in which the branch may turn."""
    ends = [NOT_ADMISSIBLE] * 2
    if judgement.verdict == "undecided":
        return _undecided(judgement.reason)
    if judgement.verdict == "proved":
        if curve.region.closing.form is not None or others_at_circle(passage, "fold"):
            return _undecided(_TURNS)
        ends = _at_ends(curve, piece)
    return _event(curve, piece, "fold", ends, _TURNS)


def _multipliers(curve: OrbitCurve, piece: Piece, passage: CyclePassage) -> Look:
    """Judge a tile in which a multiplier may pass the unit circle."""
    reason = passage.stability.reason
    kind = passed_by(passage)
    if not kind:
        return _undecided(reason)
    return _event(curve, piece, kind, _at_ends(curve, piece), reason)


def _at_ends(curve: OrbitCurve, piece: Piece) -> list[str]:
    """Verdicts on the multipliers at both ends of a tile."""
    from flint import arb

    found = []
    for end in (piece.tube.lower, piece.tube.upper):
        with flint_precision(SHARP):
            orbit = orbit_at(curve, piece.tube, arb(rational_of(end)), SHARP)
            if orbit is None:
                return [UNDECIDED] * 2
            found.append(_told(curve, CyclePassage(curve.region, orbit).stability.verdict))
    return found


def _event(
    curve: OrbitCurve,
    piece: Piece,
    which: Which,
    ends: Sequence[str],
    reason: str,
) -> Look:
    """Judge a tile with one event, from the verdicts below and above it."""
    if UNDECIDED in ends:
        return _undecided(reason)
    found = crossing_of(curve, piece, which)
    if found is None:
        return _undecided(reason)
    if which == "neimark-sacker":
        with flint_precision(SHARP):
            try:
                check_pair(range_of(CyclePassage(curve.region, found.enclosures).section))
            except NotCovered:
                return _undecided(reason)
    return Look(ends[0], ends[1], "", found)


def _border(
    curve: OrbitCurve,
    piece: Piece,
    passage: CyclePassage,
    judgement: Judgement,
    verdict: str,
    *,
    turns: bool,
) -> Look:
    """Judge a tile in which the orbit may meet a border beyond which it is no motion.

    Where a phase vanishes that begins and ends on one boundary the branch turns too, if the
    condition is divided: to leading order the parameter is even in the dwell time.
    """
    opens = [which for which in judgement.open if which is not None]
    slows = any(which.kind == "tangent" for which in opens)
    if len(opens) < len(judgement.open) or (verdict == UNDECIDED and not slows):
        return _undecided(judgement.reason)
    told = passage.judged(opens)
    while told.verdict == "undecided":
        # beside a phase that vanishes, or a boundary that is reached slowly, more may be open
        more = [which for which in told.open if which is not None]
        if not more or len(more) < len(told.open) or {*more} & {*opens}:
            return _undecided(told.reason)
        opens += more
        told = passage.judged(opens)
    if told.verdict != "proved":
        return _undecided(told.reason or judgement.reason)
    if verdict == UNDECIDED:
        verdict = _beside(passage, opens)
    if verdict == UNDECIDED:
        return _undecided(judgement.reason)
    # a phase that vanishes ends where the one before it does; of a boundary that is reached
    # without speed all else follows
    opens.sort(key=lambda which: (which.kind != "vanishing-phase", not which.slow))
    found: list[EventCrossing] = []
    for which in opens:
        crossing = crossing_of(curve, piece, which, told.touching.get(which))
        if crossing is None or crossing.rises != (found or [crossing])[0].rises:
            return _undecided(judgement.reason)
        found.append(crossing)
    if turns:
        fold = crossing_of(curve, piece, "fold")
        if fold is None or opens[0].kind != "vanishing-phase":
            return _undecided(_TURNS)
        found.append(fold)
        opens.append(OpenInequality("fold", opens[0].phase, "", ""))
    lower, upper = min(x.lower for x in found), max(x.upper for x in found)
    if max(x.lower for x in found) > min(x.upper for x in found):
        return _undecided("several borders are met, one after the other")
    windows = [crossing.window for crossing in found if crossing.window is not None]
    if len(windows) > 1:
        return _undecided("several maxima touch a boundary at once")
    event = found[0]._replace(
        lower=lower, upper=upper, also=tuple(opens[1:]), window=windows[0] if windows else None
    )
    ends = [verdict, NOT_ADMISSIBLE] if event.rises else [NOT_ADMISSIBLE, verdict]
    return Look(ends[0], ends[1], "", event)


def _beside(passage: CyclePassage, opens: Sequence[OpenInequality]) -> str:
    """The verdict beside a border at which the map is singular: a boundary is reached slowly."""
    slow = [which.phase for which in opens if which.slow]
    unstable = len(slow) == 1 and passage.unstable_if_reached(slow[0])
    return "unstable" if unstable else UNDECIDED
