"""Pictures of certified cascades: branches in colours, doubled orbits beside their flips."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.errors import unknown_name
from nonsmooth.runtime.model.naming import shown_name
from nonsmooth.runtime.model.units import units_of
from nonsmooth.runtime.present.pictures.certified_branches import draw_tiles, mark_events
from nonsmooth.runtime.present.pictures.drawing import drawn_alone, finish
from nonsmooth.runtime.present.pictures.proven_maps import COLORS
from nonsmooth.runtime.proof.doubling.certified_cascade import CertifiedCascade

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["draw_cascade"]

_POINTS = 60  # of the orbits beside a flip


def draw_cascade(found: CertifiedCascade, quantity: str | None = None, axes: Any = None) -> Any:
    """Draw an unknown of all branches over the parameter, by the polynomials of the tubes.

    It is a coordinate of the start: by default the one in which the first doubled orbits
    differ, or else the first one. The result is the Axes that are given, or else a new
    figure. An unknown name raises `InputError`.
    """
    return drawn_alone("cascade", (7.2, 5.0), lambda own: _draw(found, quantity, own), axes)


def _draw(found: CertifiedCascade, quantity: str | None, axes: Axes) -> None:
    import numpy as np

    first = found.branches[0].unknown_names
    common = [name for name in first if all(name in b.unknown_names for b in found.branches)]
    name = quantity
    if name is None:
        told = [doubling.scaled for doubling in found.doublings if doubling.scaled in common]
        name = (told or common)[0]
    if name not in common:
        raise unknown_name("unknown", name, common)
    shown: set[str] = set()
    for branch in found.branches:
        draw_tiles(branch, name, axes, shown)
    e = np.linspace(0, 1, _POINTS)
    for branch, doubling in zip(found.branches, found.doublings, strict=False):
        size = len(branch.unknown_names)
        rows = [np.polynomial.polynomial.polyval(e, row) for row in doubling.centre]
        scaled = branch.unknown_names.index(doubling.scaled)
        away = [*rows[size:-1]]
        away.insert(scaled, np.ones(_POINTS))
        place = branch.unknown_names.index(name)
        up = rows[place] + float(doubling.amplitude) * e * away[place]
        undecided = doubling.verdict == "undecided"
        color = "#CC3311" if undecided else COLORS[doubling.verdict]
        axes.plot(rows[-1], up, color=color, linewidth=2, linestyle=":")
    axes.plot([], [], color="black", linestyle=":", label="twice the period, beside a flip")
    mark_events(found.branches, name, axes)
    units = units_of(found.system)
    axes.set_xlabel(units.label(found.parameter))
    axes.set_ylabel(units.label(name))
    finish(axes, shown_name(found.orbit))
