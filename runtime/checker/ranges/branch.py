"""The check of a branch: tiles that follow each other, each with one verdict or one event.

Where two tiles meet one orbit lies in both tubes.
"""

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

from flint import arb, ctx

from nonsmooth.runtime.checker.ranges.branch_curve import CheckedCurve, without_entry
from nonsmooth.runtime.checker.ranges.branch_tile import BITS, NO_MOTION, OPEN, SHARP, CheckedTile
from nonsmooth.runtime.checker.stated.exact import Failure, demand, exact
from nonsmooth.runtime.checker.stated.parameters import independent, stated_system
from nonsmooth.runtime.core.jets import part_of

FINISHED, VANISHED = "end of the interval", "a phase vanishes"


def checked_tiles(content: dict[str, Any]) -> list[CheckedTile]:
    """Prove every claim of a branch whose entries have their shape; return its tiles."""
    tiles = content["tiles"]
    _claimed(content)
    if not tiles:
        return []
    curve = curve_of(content)
    with ctx.workprec(BITS):
        found = [CheckedTile(curve, tile) for tile in tiles]
        reached = ending(found[0], last=False), ending(found[-1], last=True)
        for why, proved in zip(content["ends"], reached, strict=True):
            demand(why == proved or why not in (FINISHED, VANISHED), f"it goes on: not {why!r}")
        for number, tile in enumerate(found, 1):
            try:
                tile.check_sharply()
            except Failure as failure:
                raise Failure(f"in tile {number} of the branch: {failure}") from None
        for number, (tile, other) in enumerate(pairwise(found), 1):
            try:
                check_joint(tile, other)
            except Failure as failure:
                raise Failure(f"tiles {number} and {number + 1}: {failure}") from None
        independent(curve.declared, curve.constants, [curve.interval])
    return found


def curve_of(content: dict[str, Any]) -> CheckedCurve:
    """Return the equations of a branch, of which nothing is proved yet.

    `Failure` is raised if the declaration is not exact, or if the unknowns or the kind of
    stability are not those of the declaration.
    """
    demand(content["declaration"], "claims about no declaration")
    with ctx.workprec(BITS):
        name = content["parameter"]
        declared, constants = stated_system(content, content["parameters"], [name])
        demand(declared.bound and declared.rational, "the declaration is not exact")
        demand(content["stability"] == declared.stability, "stability of another kind")
        demand(content["unknown_names"] == declared.unknowns, "other unknowns")
        interval = [exact(end) for end in content["interval"]]
        return CheckedCurve(declared, declared.closes(), constants, name, interval)


def _claimed(content: dict[str, Any]) -> None:
    """Demand that the claim about the whole branch follows from its tiles."""
    tiles = content["tiles"]
    demand(0 <= content["start"] <= len(tiles), "it starts in none of its tiles")
    low, high = map(exact, content["interval"])
    demand(low < high, "the interval is empty")
    every = all(OPEN not in (tile["before"], tile["after"]) for tile in tiles)
    whole = bool(tiles) and every and {*content["ends"]} <= {FINISHED, VANISHED}
    demand((content["claims"]["branch"] == "proved") == whole, "the claim is not that of the tiles")
    for tile in tiles:
        left = tile["before"] == OPEN
        demand(left == bool(tile["reason"]), "reasons of other tiles")
        demand(left == (tile["after"] == OPEN), "a tile that is half decided")
        demand(tile["event"] is None or not left, "an event of an undecided tile")
        same = tile["before"] == tile["after"]
        demand(same or tile["event"], "the verdict changes without an event")


def check_joint(tile: CheckedTile, other: CheckedTile) -> None:
    """Prove that one tile ends with the orbit with which the next begins, and leads its way.

    The two tiles are in the order of the branch.
    """
    curve = tile.curve
    with ctx.workprec(SHARP):
        _same_equations(tile, other)
        if tile.place == other.place:
            demand(tile.end == other.begin and tile.forwards == other.forwards, "they are apart")
            point = tile.at_end(tile.end)
            demand(other.holds(arb(tile.end), without_entry(other.place, point)), "two orbits")
            return
        try:
            point = tile.at_end(tile.end)
            _meets(other, point, entering=True)
        except Failure:
            point = other.at_end(other.begin)
            _meets(tile, point, entering=False)
        slope = part_of(curve.jets(tile.place, point, 1)[other.place], 1)
        same = tile.forwards == other.forwards
        demand(slope > 0 if same else slope < 0, "they do not lead the same way")


def _same_equations(tile: CheckedTile, other: CheckedTile) -> None:
    """Demand that no dwell time divided by is zero at a joint of tiles with other divisions."""
    if tile.tile["divided"] == other.tile["divided"]:
        return
    names = tile.curve.declared.dwell
    first = tile.curve.last - len(names)
    for own, point in ((tile, tile.at_end(tile.end)), (other, other.at_end(other.begin))):
        for divided in (tile.curve.short, other.curve.short):
            if divided is not None:
                time = point[first + divided.place]
                demand(time > 0 or time < 0, f"{own.tile['coordinate']}: a phase vanishes there")


def _meets(tile: CheckedTile, point: Sequence[Any], *, entering: bool) -> None:
    """Demand that an orbit lies in a tile: before its event if `entering`, else behind it."""
    value = point[tile.place]
    demand(value > tile.low and value < tile.high, "they are apart")
    demand(tile.holds(value, without_entry(tile.place, point)), "two orbits")
    if tile.event is not None:
        low, high = exact(tile.event["lower"]), exact(tile.event["upper"])
        below = entering == tile.forwards
        demand(value < low if below else value > high, "an event is left out")


def ending(tile: CheckedTile, *, last: bool) -> str:
    """Return how a branch is proved to end with its last tile, or to begin with its first one.

    It is at an end of the interval, or turns where a phase vanishes and no motions are beyond;
    "" is returned where it goes on. What the tile states is proved elsewhere.
    """
    reached, beyond = (tile.end, "after") if last else (tile.begin, "before")
    if tile.place == tile.curve.last and reached in tile.curve.interval:
        return FINISHED
    vanishes = tile.turns and tile.event["kind"] == "vanishing-phase"
    return VANISHED if vanishes and tile.tile[beyond] == NO_MOTION else ""
