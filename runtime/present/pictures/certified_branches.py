"""Pictures of certified branches and doublings: proved intervals in colours, events marked."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import unknown_name
from nonsmooth.runtime.model.naming import shown_name, units_of
from nonsmooth.runtime.present.pictures.drawing import drawn_alone, finish
from nonsmooth.runtime.present.pictures.proven_maps import COLORS
from nonsmooth.runtime.proof.branch.certified_branch import BranchTile, CertifiedBranch
from nonsmooth.runtime.proof.branch.certified_doubling import CertifiedDoubling

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["draw_certified_branch", "draw_doubling"]

_POINTS = 40  # of a tile
_AWAY = 60  # points of the orbits beside a flip
_MARKS = "osD^vP*X"


def draw_certified_branch(
    found: CertifiedBranch, quantity: str | None = None, axes: Any = None
) -> Any:
    """Draw an unknown over the parameter, by the polynomials of the tubes.

    The default is the last dwell time. The result is the Axes that are given, or else a new
    figure. An unknown name raises `InputError`.
    """
    return drawn_alone("branch", (7.2, 5.0), lambda own: _draw(found, quantity, own), axes)


def _draw(found: CertifiedBranch, quantity: str | None, axes: Axes) -> None:
    name = found.unknown_names[-1] if quantity is None and found.unknown_names else quantity or ""
    _draw_tiles(found, name, axes, set())
    _finish(found, [found], name, axes)


def draw_doubling(found: CertifiedDoubling, quantity: str | None = None, axes: Any = None) -> Any:
    """Draw an unknown of both branches over the parameter, by the polynomials of the tubes.

    By default it is the one by which the halves of the doubled orbits are told apart, or else
    the first one. The result is the Axes that are given, or else a new
    figure. An unknown name raises `InputError`.
    """
    return drawn_alone(
        "doubling", (7.2, 5.0), lambda own: _draw_doubling(found, quantity, own), axes
    )


def _draw_doubling(found: CertifiedDoubling, quantity: str | None, axes: Axes) -> None:
    doubled, branches = found.doubled, [found.branch]
    if doubled is not None:
        branches.append(doubled.branch)
    names = found.branch.unknown_names
    common = [name for name in names if all(name in b.unknown_names for b in branches)]
    name = quantity
    if name is None:
        apart = "" if doubled is None else doubled.scaled
        name = apart if apart in common else common[0]
    if name not in common:
        raise unknown_name("unknown", name, common)
    shown: set[str] = set()
    for branch in branches:
        _draw_tiles(branch, name, axes, shown)
    if doubled is not None:
        e = np.linspace(0, 1, _AWAY)
        size = len(names)
        rows = [np.polynomial.polynomial.polyval(e, row) for row in doubled.centre]
        away = [*rows[size:-1]]
        away.insert(names.index(doubled.scaled), np.ones(_AWAY))
        place = names.index(name)
        up = rows[place] + float(doubled.amplitude) * e * away[place]
        color = "#CC3311" if doubled.verdict == "undecided" else COLORS[doubled.verdict]
        axes.plot(rows[-1], up, color=color, linewidth=2, linestyle=":")
        axes.plot([], [], color="black", linestyle=":", label="twice the period, beside the flip")
    _finish(found, branches, name, axes)


def _draw_tiles(found: CertifiedBranch, name: str, axes: Axes, shown: set[str]) -> None:
    """Draw the unknown `name` along the tiles of a branch, in the colours of their verdicts.

    Verdicts in `shown` have a label already; those that get one are added. `InputError` is
    raised if the branch has no such unknown.
    """
    if name not in found.unknown_names:
        raise unknown_name("unknown", name, found.unknown_names)
    for tile in found.tiles:
        across, up = _points(found, tile, name)
        parts = [(tile.before, slice(None))]
        if tile.event is not None:
            low = float(tile.lower)
            share = (float(tile.event.lower) - low) / (float(tile.upper) - low)
            cut = int(share * (_POINTS - 1)) + 1
            first, second = slice(None, cut), slice(cut - 1, None)
            halves = (first, second) if tile.forwards else (second, first)
            parts = [(tile.before, halves[0]), (tile.after, halves[1])]
        for verdict, part in parts:
            told = "undecided" if verdict == "undecided" else f"{verdict}, proved"
            color = COLORS[verdict] if verdict != "undecided" else "#CC3311"
            label = "" if verdict in shown else told
            shown.add(verdict)
            axes.plot(across[part], up[part], color=color, linewidth=2, label=label or None)


def _finish(
    found: CertifiedBranch | CertifiedDoubling,
    branches: Sequence[CertifiedBranch],
    name: str,
    axes: Axes,
) -> None:
    """Mark the events of branches on the curves of the unknown `name`, and label the Axes."""
    events = [event for branch in branches for event in branch.events]
    kinds = list(dict.fromkeys(event.kind for event in events))
    for place, kind in enumerate(kinds):
        there = [event.enclosures for event in events if event.kind == kind]
        axes.plot(
            [float(x[branches[0].parameter]) for x in there],
            [float(x[name]) for x in there],
            linestyle="none",
            marker=_MARKS[place % len(_MARKS)],
            color="black",
            label=f"{kind}, enclosed",
        )
    units = units_of(found.system)
    finish(axes, shown_name(found.orbit), units.label(found.parameter), units.label(name))


def _points(found: CertifiedBranch, tile: BranchTile, name: str) -> tuple[np.ndarray, np.ndarray]:
    """Values of the parameter and of the unknown along a tile."""
    e = np.linspace(-1, 1, _POINTS)
    low, high = float(tile.lower), float(tile.upper)
    own = (low + high) / 2 + (high - low) / 2 * e
    names = [*found.unknown_names, None]
    place = len(names) - 1
    if tile.coordinate != found.parameter:
        place = names.index(tile.coordinate)
    others = [np.polynomial.polynomial.polyval(e, row) for row in tile.centre]
    every = [*others[:place], own, *others[place:]]
    return every[-1], every[names.index(name)]
