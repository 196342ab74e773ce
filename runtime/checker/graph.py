"""The check of a graph of boxes: images lie where edges lead, and what follows from the edges.

Of each box whose image is not stated to be unknown, every state that returns to the section comes
to one of the boxes to which edges lead from it, or leaves the region where that is stated. Then
no edge leaves the boxes that are stated to be trapping, and an edge that leads to no box of the
same component leads to a smaller rank: so returns that stay among boxes of known image are in
the boxes of one component from some return on.
"""

from typing import Any

import numpy as np
from flint import ctx

from nonsmooth.runtime.checker.exact import check_sum, demand
from nonsmooth.runtime.checker.grids import listed, stated_divided_grid
from nonsmooth.runtime.checker.many_sets import ManyMotions
from nonsmooth.runtime.checker.shape import GRAPH, check_bits, check_shape
from nonsmooth.runtime.checker.switching import StatedSection
from nonsmooth.runtime.core.box_grid import DividedGrid

__all__ = ["check_graph"]

_BITS = 80
_BATCH = 1024
_MORE = 8  # times the parts of one set that the file states
_FINEST = 0.125  # parts of windows of time: boxes have to come to narrow places
_MOST = 10**8  # edges
_FAR = 4.0  # boxes beyond the region: further is not looked at


def check_graph(content: dict[str, Any]) -> None:
    """Prove a graph of boxes again; `Failure` names a claim that is not proved.

    `Malformed` is raised if the file, read as JSON, has another shape.
    """
    check_shape(content, GRAPH)
    check_sum(content)
    check_bits(content)
    widest, most, longest = content["widest"], content["most"], content["longest"]
    limits = all(0 < x < float("inf") for x in widest) and 0 < most <= 10**6
    demand(limits and 0 < longest <= 10**4, "no limits of sets")
    declared = content["declaration"]
    demand(len(widest) == len(declared["states"]), "no limits of sets")
    with ctx.workprec(_BITS):
        section = StatedSection(
            content["configuration"], tuple(content["phase"]), content["source"],
            content["boundary"],
        )  # fmt: skip
        motions = ManyMotions(
            declared, content["parameters"], section, widest, 1.0, _MORE * most, longest, _FINEST
        )
        named = [motions.system.states[k] for k in motions.free]
        demand(content["coordinates"] == named, "the coordinates are not those of the section")
        graph = _StatedGraph(content, len(named))
        graph.check_order(content)
        graph.check_images(motions)


class _StatedGraph:
    """The boxes and edges of a file."""

    def __init__(self, content: dict[str, Any], size: int) -> None:
        self.grid: DividedGrid = stated_divided_grid(content["grid"], content["divided"], size)
        self.outside, self.unknown = (self._flags(content[name]) for name in ("outside", "unknown"))
        edges = np.array(content["edges"] or np.zeros((0, 3), dtype=int))
        source, first, count = edges.T
        fits = (source >= 0) & (source < len(self.grid)) & (first >= 0) & (count > 0)
        fits &= (first < len(self.grid)) & (count <= len(self.grid) - first)
        demand(fits.all() and count.sum() <= _MOST, "an edge leads to no box")
        self.source = np.repeat(source, count)
        begins = np.repeat(np.cumsum(count) - count, count)
        self.target = np.repeat(first, count) + np.arange(len(self.source)) - begins
        lost = self.unknown[self.source].any() or (self.unknown & self.outside).any()
        demand(not lost, "an edge of an unknown image")
        keys = self.source * len(self.grid) + self.target
        demand((np.diff(keys) > 0).all(), "edges are not in order")
        self.keys = np.append(keys, len(self.grid) ** 2)  # of no edge: larger than all

    def _flags(self, runs: Any) -> Any:
        told = listed(runs, len(self.grid))
        demand(np.isin(told, (0, 1)).all(), "a box is so or not")
        return told == 1

    def check_order(self, content: dict[str, Any]) -> None:
        """Demand what is stated of the edges: none leaves the trap, and ranks fall along them.

        Ranks need not fall along edges within a component. The verdict has to follow from these.
        """
        trapping = self._flags(content["trapping"])
        leaves = self.outside | self.unknown
        closed = trapping[self.target[trapping[self.source]]].all()
        demand(closed and not (trapping & leaves).any(), "a trapping region is left")
        component = listed(content["components"], len(self.grid))
        ranks = listed(content["ranks"], len(self.grid))
        own, other = component[self.source], component[self.target]
        within = (own == other) & (own >= 0)
        demand((within | (ranks[self.target] < ranks[self.source])).all(), "an edge ascends")
        members = component >= 0
        for side in (self.source, self.target):
            met = np.zeros(len(self.grid), dtype=bool)
            met[side[within]] = True
            demand((met | ~members).all(), "a box is not of its component")
        left = np.unique(np.concatenate([own[~within], component[leaves]]))
        stays = np.setdiff1d(component[members], left)
        demand((content["claim"] == "proved") == (len(stays) > 0), "the verdict is another one")

    def check_images(self, motions: ManyMotions) -> None:
        """Demand that the images of all boxes not stated as unknown lie where the edges lead."""
        left, whole = np.flatnonzero(~self.unknown), self.grid.grid
        first, counts = np.array(whole.first), np.array(whole.counts)
        least, most = (first - _FAR) * whole.sides, (first + counts + _FAR) * whole.sides
        for begin in range(0, len(left), _BATCH):
            numbers = left[begin : begin + _BATCH]

            def known(origin: Any, low: Any, high: Any, numbers: Any = numbers) -> Any:
                low, high = np.clip(low, least, most), np.clip(high, least, most)
                box, (place, target, inside) = numbers[origin], self.grid.numbers_met(low, high)
                keys = box[place] * len(self.grid) + target
                missing = self.keys[np.searchsorted(self.keys, keys)] != keys
                good = (inside | self.outside[box]) & ~np.isnan(low + high).any(axis=1)
                good[place[missing]] = False
                return good

            starts = self.grid.sets(numbers)
            lifted = starts.mapped(motions.lift(motions.facts, timed=False))
            here = motions.section.configuration
            led = motions.lead(lifted, here, motions.facts, known)
            demand(led, "the image of a box is not shown to lie where its edges lead")
