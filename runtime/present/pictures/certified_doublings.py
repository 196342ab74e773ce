"""Pictures of certified doublings: both branches in colours, doubled orbits beside the flip."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.errors import unknown_name
from nonsmooth.runtime.model.naming import shown_name, units_of
from nonsmooth.runtime.present.pictures.certified_branches import draw_tiles, mark_events
from nonsmooth.runtime.present.pictures.drawing import drawn_alone, finish
from nonsmooth.runtime.present.pictures.proven_maps import COLORS
from nonsmooth.runtime.proof.doubling.certified_doubling import CertifiedDoubling

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["draw_doubling"]

_POINTS = 60  # of the orbits beside a flip


def draw_doubling(found: CertifiedDoubling, quantity: str | None = None, axes: Any = None) -> Any:
    """Draw an unknown of both branches over the parameter, by the polynomials of the tubes.

    By default it is the one by which the halves of the doubled orbits are told apart, or else
    the first one. The result is the Axes that are given, or else a new
    figure. An unknown name raises `InputError`.
    """
    return drawn_alone("doubling", (7.2, 5.0), lambda own: _draw(found, quantity, own), axes)


def _draw(found: CertifiedDoubling, quantity: str | None, axes: Axes) -> None:
    import numpy as np

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
        draw_tiles(branch, name, axes, shown)
    if doubled is not None:
        e = np.linspace(0, 1, _POINTS)
        size = len(names)
        rows = [np.polynomial.polynomial.polyval(e, row) for row in doubled.centre]
        away = [*rows[size:-1]]
        away.insert(names.index(doubled.scaled), np.ones(_POINTS))
        place = names.index(name)
        up = rows[place] + float(doubled.amplitude) * e * away[place]
        color = "#CC3311" if doubled.verdict == "undecided" else COLORS[doubled.verdict]
        axes.plot(rows[-1], up, color=color, linewidth=2, linestyle=":")
        axes.plot([], [], color="black", linestyle=":", label="twice the period, beside the flip")
    mark_events(branches, name, axes)
    units = units_of(found.system)
    axes.set_xlabel(units.label(found.parameter))
    axes.set_ylabel(units.label(name))
    finish(axes, shown_name(found.orbit))
