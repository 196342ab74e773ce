"""The kinds of pictures of an orbit, or of a motion: a new one is one entry here."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Kind:
    """A kind of picture, and the function that draws it.

    The function is named with its module in this package, which is imported when it is first
    drawn.
    """

    size: tuple[float, float]  # in inches, of a new figure or of each of its phase portraits
    draw: str  # function of a View and a list of Axes
    of_motions: bool = True  # whether a motion that is no orbit has this kind too


KINDS = {
    "time": Kind((6.4, 3.6), "panels.draw_positions"),
    "velocity": Kind((6.4, 3.6), "panels.draw_velocities"),
    "phase": Kind((4.9, 4.4), "panels.draw_portraits"),
    "strip": Kind((6.4, 2.4), "panels.draw_strip"),
    "multipliers": Kind((4.8, 5.0), "panels.draw_multipliers", of_motions=False),
    "all": Kind((11.0, 8.0), "plot.draw_all"),
}
