"""Pictures of certified branches: proved intervals in colours, events marked."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.errors import unknown_name
from nonsmooth.runtime.model.naming import shown_name, units_of
from nonsmooth.runtime.present.pictures.drawing import drawn_alone, finish
from nonsmooth.runtime.present.pictures.proven_maps import COLORS
from nonsmooth.runtime.proof.branch.certified_branch import BranchTile, CertifiedBranch

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.axes import Axes

__all__ = [
    "draw_certified_branch",
    "draw_tiles",
    "mark_events",
]

_POINTS = 40  # of a tile
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
    draw_tiles(found, name, axes, set())
    mark_events([found], name, axes)
    units = units_of(found.system)
    axes.set_xlabel(units.label(found.parameter))
    axes.set_ylabel(units.label(name))
    finish(axes, shown_name(found.orbit))


def draw_tiles(found: CertifiedBranch, name: str, axes: Axes, shown: set[str]) -> None:
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


def mark_events(branches: Sequence[CertifiedBranch], name: str, axes: Axes) -> None:
    """Mark the events of branches along one parameter on the curves of the unknown `name`."""
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


def _points(found: CertifiedBranch, tile: BranchTile, name: str) -> tuple[np.ndarray, np.ndarray]:
    """Values of the parameter and of the unknown along a tile."""
    import numpy as np

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
