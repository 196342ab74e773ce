"""The paper's figures, and for each orbit its timing strip and its multipliers."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.present.paper import schematics
from nonsmooth.runtime.present.paper.records import ReportFigure
from nonsmooth.runtime.present.pictures.plot import orbit_figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["Drawing", "drawings"]


@dataclass(frozen=True)
class Drawing:
    """A figure of the report, and the function that draws it."""

    picture: ReportFigure
    draw: Callable[[], Figure]


@dataclass(frozen=True)
class _View:
    """A figure of the paper that shows an orbit."""

    number: int
    caption: str
    orbit: str
    kind: str  # of picture
    masses: tuple[int, ...] | None = None  # that are drawn, all if None
    periods: int = 1

    def of(self, orbits: Mapping[str, Orbit]) -> Drawing:
        """The figure with the function that draws it from the orbits."""
        picture = ReportFigure(f"figure-{self.number:02}", f"Fig. {self.number}. {self.caption}.")
        draw = partial(
            orbit_figure, orbits[self.orbit], self.kind, periods=self.periods, masses=self.masses
        )
        return Drawing(picture, draw)


_RIGID, _ELASTIC = "rigid-stop/one-impact", "elastic-stop/one-contact"
_SYMMETRIC, _STICK = "dry-friction/symmetric", "dry-friction/global-stick"
_VIEWS = (
    _View(2, "Time history of the first mass, rigid stop", _RIGID, "time", (0,), 2),
    _View(3, "Time history of the second mass, rigid stop", _RIGID, "time", (1,), 2),
    _View(4, "Time history of the first mass, elastic stop", _ELASTIC, "time", (0,)),
    _View(5, "Time history of the second mass, elastic stop", _ELASTIC, "time", (1,)),
    _View(7, "Phase portrait of the first mass, symmetric orbit", _SYMMETRIC, "phase", (0,)),
    _View(8, "Phase portrait of the second mass, symmetric orbit", _SYMMETRIC, "phase", (1,)),
    _View(9, "Time history of the system, global stick orbit", _STICK, "time"),
    _View(10, "Phase plot of the system, global stick orbit", _STICK, "phase"),
)
_SCHEMATICS = (
    (1, "Coupled oscillators with a stop.", schematics.stop_schematic),
    (6, "Two degrees of freedom oscillator with dry friction.", schematics.belt_schematic),
    (11, "The Poincaré map as a composition of local maps.", schematics.poincare_schematic),
)


def drawings(orbits: Mapping[str, Orbit]) -> dict[str, Drawing]:
    """All drawings by their stems, in the order of the report.

    First come those of the paper by number, then two of each orbit of `paper_orbits`.
    """
    numbered = {view.number: view.of(orbits) for view in _VIEWS}
    for number, caption, draw in _SCHEMATICS:
        picture = ReportFigure(f"figure-{number:02}", f"Fig. {number}. {caption}")
        numbered[number] = Drawing(picture, draw)
    found = [numbered[number] for number in sorted(numbered)]
    for name, orbit in orbits.items():
        found += _of_orbit(name, orbit)
    return {drawing.picture.stem: drawing for drawing in found}


def _of_orbit(name: str, orbit: Orbit) -> Iterator[Drawing]:
    stem = name.replace("/", "-")
    for kind, caption in (
        ("strip", "Configurations of *{}* over a period, with their dwell times."),
        ("multipliers", "Multipliers of *{}* in the unit circle."),
    ):
        picture = ReportFigure(f"{stem}-{kind}", caption.format(name))
        yield Drawing(picture, partial(orbit_figure, orbit, kind))
