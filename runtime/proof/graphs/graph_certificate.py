"""What is proved by a graph of boxes: where motions return to, and what they do not leave."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.registry import registered
from nonsmooth.runtime.core.showing import Shown
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.proof.graphs.box_graphs import BoxGraph

__all__ = ["Component", "GraphCertificate"]


@dataclass(frozen=True, eq=False)
class Component:
    """A strong component of the graph that has a cycle: a vertex of the Morse graph.

    Attributes
    ----------
    boxes : array of int
        Numbers of its boxes.
    low, high : tuple of float
        Bounds of its coordinates.
    attracting : bool
        Whether it is a trapping region by itself: every image of its boxes lies in it.
    leaves : bool
        Whether a walk from it leads outside of the region or to a box of unknown image.
    visited : bool
        Whether the sampled motion comes to it.
    """

    boxes: NDArray[np.int_] = field(repr=False)
    low: tuple[float, ...]
    high: tuple[float, ...]
    attracting: bool
    leaves: bool
    visited: bool


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class GraphCertificate(Shown):
    """A rigorous outer approximation of a section's map on a region, at one parameter point.

    P is the map from a section to its next return: over periods of the forcing, or from one
    passage of a transition to the next. The region is a grid of boxes. For each box of known
    image the edges lead to boxes that contain P of all of its states, but for what leaves the
    region, which is said. A trapping region is a union of boxes of which all images stay in it:
    every motion that starts there has all its later returns there.

    Attributes
    ----------
    system : str
    parameters : dict of str to Value
        All of the system, exactly.
    configuration : str
        In which states on the section are.
    phase : tuple of str
        Cosine and sine of the forcing on the section; empty without a forcing.
    source, boundary : str
        What the transition of the section leaves and by what; empty with a forcing.
    coordinates : tuple of str
        States that are the coordinates of the section.
    graph : BoxGraph
        Boxes and edges.
    components : tuple of Component
        Where motions that stay in the region accumulate, the attracting ones first.
    arrows : tuple of (int, int)
        The Morse graph: from which component motions may come to which, without those that
        follow from others.
    visited : array of int
        Boxes that the sampled motion visits.
    bits : int
        Precision of the exact part of the proof.
    """

    system: str
    parameters: Mapping[str, Value]
    configuration: str
    phase: tuple[str, ...]
    source: str
    boundary: str
    coordinates: tuple[str, ...]
    graph: BoxGraph = field(repr=False)
    components: tuple[Component, ...]
    arrows: tuple[tuple[int, int], ...]
    visited: NDArray[np.int_] = field(repr=False)
    bits: int

    @property
    def proved(self) -> bool:
        """Whether a trapping region with a cycle is proved: there is an attracting component."""
        return any(own.attracting for own in self.components)

    @property
    def region(self) -> dict[str, tuple[float, float]]:
        """Bounds of the coordinates in the region, exactly."""
        low, high = self.graph.grid.bounds(np.array([0, len(self.graph.grid) - 1]))
        ends = zip(low[0].tolist(), high[1].tolist(), strict=True)
        return dict(zip(self.coordinates, ends, strict=True))

    @property
    def trapping(self) -> NDArray[np.int_]:
        """Boxes of the largest trapping region."""
        return np.flatnonzero(self.graph.trapping)

    @property
    def unknown(self) -> NDArray[np.int_]:
        """Boxes whose image is not known."""
        return np.flatnonzero(self.graph.unknown)

    @property
    def outside(self) -> NDArray[np.int_]:
        """Boxes of which a part of the image may be outside of the region."""
        return np.flatnonzero(self.graph.outside)

    def box_of(self, point: Sequence[float]) -> int:
        """The number of the box that contains a point of the section.

        Parameters
        ----------
        point : sequence (d,)
            The coordinates.

        Returns
        -------
        int

        Raises
        ------
        InputError
            If it is not in the region.
        """
        place = np.array([[float(x) for x in point]])
        if place.shape[1] != len(self.coordinates) or not np.isfinite(place).all():
            raise InputError(f"{point!r} is no point of ({', '.join(self.coordinates)})")
        _, number, inside = self.graph.grid.numbers_met(place, place)
        if not inside[0]:
            raise InputError(f"{point!r} is not in the region")
        return int(number[0])

    def targets(self, box: int) -> NDArray[np.int_]:
        """Boxes of the region that the image of a box may meet.

        Parameters
        ----------
        box : int

        Returns
        -------
        array of int
        """
        found: NDArray[np.int_] = self.graph.targets[self.graph.sources == box]
        return found

    def closure(self, boxes: NDArray[np.int_]) -> NDArray[np.int_]:
        """Boxes to which walks from some lead, with these.

        It is a trapping region if it contains no box that is `outside` or `unknown`.

        Parameters
        ----------
        boxes : array of int

        Returns
        -------
        array of int
        """
        return np.flatnonzero(self.graph.ahead(boxes))

    def to_json(self) -> dict[str, Any]:
        """Give what is proved as JSON, without the edges.

        Returns
        -------
        dict
            Ready for `json.dumps`.
        """
        graph = self.graph
        return {
            "system": self.system,
            "parameters": {name: value.text for name, value in self.parameters.items()},
            "configuration": self.configuration,
            "phase": list(self.phase),
            "source": self.source,
            "boundary": self.boundary,
            "coordinates": list(self.coordinates),
            "region": {name: list(ends) for name, ends in self.region.items()},
            "counts": list(graph.grid.counts),
            "edges": len(graph.sources),
            "outside": len(self.outside),
            "unknown": self.unknown.tolist(),
            "trapping": self.trapping.tolist(),
            "components": [
                {
                    "boxes": own.boxes.tolist(),
                    "low": list(own.low),
                    "high": list(own.high),
                    "attracting": own.attracting,
                    "leaves": own.leaves,
                    "visited": own.visited,
                }
                for own in self.components
            ],
            "arrows": [list(pair) for pair in self.arrows],
            "bits": self.bits,
        }

    def plot(self, axes: Any = None) -> Any:
        """Draw the boxes of the components, the trapping region, and the Morse graph.

        Parameters
        ----------
        axes : matplotlib Axes, optional
            Where to draw the boxes, without the Morse graph; a figure of its own by default.

        Returns
        -------
        matplotlib Figure or Axes
            The figure, or the Axes that were given.

        Raises
        ------
        InputError
            If the section has more than two coordinates.
        MissingExtra
            Without matplotlib: ``pip install "nonsmooth[plot]"``.
        """
        return registered("draw_graph")(self, axes)
