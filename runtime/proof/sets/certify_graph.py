"""Prove where motions go from the boxes of a region, and read trapping regions from the graph."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass, replace

import numpy as np

from nonsmooth.runtime.checker.state_sets.graph import map_of_boxes, stays
from nonsmooth.runtime.checker.state_sets.many_sets import Arrivals, in_batches
from nonsmooth.runtime.checker.stated.exact import Entries
from nonsmooth.runtime.core.box_grid import BoxGrid, DividedGrid
from nonsmooth.runtime.core.errors import InputError, check_integer
from nonsmooth.runtime.core.float_sets import Floats, ManySets
from nonsmooth.runtime.core.parallel import check_workers, in_processes
from nonsmooth.runtime.core.values import by_name, flint_precision
from nonsmooth.runtime.model.kernels import SystemKernels, kernels_of
from nonsmooth.runtime.model.loading.declared import DeclaredSystem
from nonsmooth.runtime.proof.asking import Steps, proved_by_steps
from nonsmooth.runtime.proof.sets.graph_certificate import BoxGraph, Numbers, RegionCertificate
from nonsmooth.runtime.proof.sets.section_choice import Sampled, check_one_forcing, sampled_sections
from nonsmooth.runtime.proof.sets.sections import (
    check_same_section,
    listed_declaration,
    refused_as_input,
    stated_section,
)
from nonsmooth.runtime.proof.statement import ExactSystem, exact_system
from nonsmooth.runtime.simulation.simulate import follow, simulate_one
from nonsmooth.runtime.simulation.trajectory import Trajectory

_BITS = 64
_FEWEST_BITS, _MOST_BITS = 64, 4096
_WIDER = 0.25  # of the sampled extent, at each side
_LEAST = 1e-3  # of a coordinate's range along the motion: what is taken for its extent at least
_WIDEST = 0.2  # of the extent of states: wider sets are divided on the way
_FOLLOWED = 200  # transitions, to see how large states become
_AT_ONCE = 2048  # boxes
_MOST_BOXES = 4_000_000
_DEFAULT_BOXES = {1: 1024, 2: 96}  # by the number of coordinates
_FEW_BOXES = 16  # with more coordinates
_MOST_LEVELS = 24
# what the checker and other processes take, as in a file but for the parameters
_ASKED = (
    *("configuration", "phase", "source", "boundary", "declaration"),
    *("widest", "most", "longest", "bits"),
)


def certify_graph(
    system: str | SystemKernels | DeclaredSystem,
    parameters: Mapping[str, object],
    start: Mapping[str, object] | Sequence[object],
    configuration: str | None = None,
    *,
    boxes: int | None = None,
    region: Mapping[str, tuple[float, float]] | None = None,
    parts: int = 400,
    transitions: int = 40,
    bits: int = _BITS,
    levels: int = 0,
    workers: int = 1,
    resume: RegionCertificate | None = None,
    progress: Callable[[int, int], object] = lambda done, count: None,
    keep: Callable[[RegionCertificate], object] | None = None,
) -> RegionCertificate:
    """Enclose the images of all boxes of a region of a section; find what motions do not leave.

    The section is chosen along the motion from the start: a phase of the forcing, else a
    transition. A grid of boxes covers the region; the image of each box under the map to the
    next return is enclosed, whatever ways its states go, and each box that it may meet becomes
    the target of an edge. Strong components of the graph contain all recurrence; sets of boxes
    that no edge leaves are trapping regions.

    Parameters
    ----------
    system : str, System or SystemKernels
        With one harmonic forcing, or without any.
    parameters : mapping of str to str, number or Value
        All of them, rational.
    start : mapping of state to number, or sequence (N,)
        Of a motion that is followed to choose the section and the region.
    configuration : str, optional
        Where it starts; found by the system's own conditions when omitted.
    boxes : int, optional
        Along each coordinate, at least: sides are powers of 2. By default 1024 of one
        coordinate, 96 of each of two, 16 of each of more.
    region : mapping of str to (low, high), optional
        Coordinates of the section; those that are left out, and all by default, are where the
        motion comes to, and a quarter more at both sides.
    parts : int
        Parts into which one box divides on its ways, at most; else its image is unknown.
    transitions : int
        Of one motion until it returns, at most; else the image of its box is unknown.
    bits : int
        Working precision of the flow's coefficients, 64 to 4096; sets are carried in doubles,
        with bounds of all roundings.
    levels : int
        How often boxes are divided at most, each time into halves along all coordinates: those
        on cycles, those that leave the region in part, and those of unknown image to which an
        edge leads.
    workers : int
        Processes that enclose images.
    resume : RegionCertificate, optional
        What was proved before on the same region: images that are unknown are enclosed again,
        and boxes are divided up to `levels`.
    progress : callable
        Told how many boxes of how many were mapped: none before the first, at each level.
    keep : function of a RegionCertificate, optional
        Is given the state every ten seconds.

    Returns
    -------
    RegionCertificate

    Raises
    ------
    InputError
        For wrong names or numbers, a parameter that is not rational, several forcings, a
        motion that comes to no section often enough, or a state of another question.
    Interrupted
        By Ctrl-C; its `partial` is what is proved until then.
    NoConvergence
        If a process of `workers` ends, for want of memory perhaps.

    References
    ----------
    M. Dellnitz and A. Hohmann, A subdivision algorithm for the computation of unstable manifolds
    and global attractors, Numer. Math. 75 (1997) 293-317. Z. Arai, W. Kalies, H. Kokubu, K.
    Mischaikow, H. Oka and P. Pilarczyk, A database schema for the analysis of global dynamics of
    multiparameter systems, SIAM J. Appl. Dyn. Syst. 8 (2009) 757-789.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> data = {"chi": "0.5", "eta": "1", "V": "1", "us1": "1", "us2": "1",
    ...         "ur1": "4.0195", "ur2": "1.4831"}
    >>> found = ns.certify.region(
    ...     "dry-friction", data, [5, 4, 0.5, 0.25], region={"x2": (2, 13)}, boxes=64
    ... )
    >>> found.proved, [own.attracting for own in found.components]
    (True, [True, False, False])
    """
    for name, number, least, most in (
        ("boxes", 1 if boxes is None else boxes, 1, 1_000_000),
        ("parts", parts, 1, 1_000_000),
        ("transitions", transitions, 1, 10_000),
        ("bits", bits, _FEWEST_BITS, _MOST_BITS),
        ("levels", levels, 0, _MOST_LEVELS),
    ):
        check_integer(name, number, least, most)
    check_workers(workers)
    kernels = kernels_of(system)
    exact = exact_system(kernels, parameters)
    motion = simulate_one(kernels, parameters, start, configuration, transitions=1)
    with flint_precision(bits):
        check_one_forcing(exact, "a map")
        sampled = next(iter(sampled_sections(exact, motion)), None)
        if sampled is None:
            raise InputError("the motion comes to no section often enough")
        widest = _WIDEST * _extents(motion)
        grid = _grid(exact, sampled, boxes, by_name("region", region))
        grid.check_levels(levels)
        empty = _certificate(kernels, exact, sampled, grid, widest, bits)
        known = replace(empty, most=parts, longest=transitions)
        if resume is not None:
            boxes_of = known.graph.grid.grid, resume.graph.grid.grid
            regions = known.region, resume.region
            check_same_section(kernels, known, resume, "graph", region=regions, boxes=boxes_of)
            known = replace(
                known,
                graph=resume.graph,
                most=max(parts, resume.most),
                longest=max(transitions, resume.longest),
            )
    question = {name: getattr(known, name) for name in _ASKED}
    question["parameters"] = {name: value.text for name, value in known.parameters.items()}
    work = _BoxImages(question, known, workers)
    with refused_as_input():
        return proved_by_steps(work.steps(levels), lambda: work.known, progress, keep)


def _begin_images(question: Entries) -> Callable[[ManySets], Arrivals]:
    """A function that encloses the images of sets."""
    motions = map_of_boxes(question)

    def images(starts: ManySets) -> Arrivals:
        with flint_precision(question["bits"]):
            return motions.arrivals(starts)

    return images


@dataclass
class _BoxImages:
    """The certificate as far as it is known, and how further images are enclosed."""

    question: Entries
    known: RegionCertificate
    workers: int

    @property
    def graph(self) -> BoxGraph:
        """The graph as far as it is known."""
        return self.known.graph

    def steps(self, levels: int) -> Steps:
        """Enclose all unknown images, then divide boxes, and enclose theirs, so many times.

        How many boxes of how many were mapped is yielded, at each level.
        """
        yield from self._seen(np.flatnonzero(self.graph.unknown))
        while len(self.graph.grid.divided) <= levels:
            coarse, grid = self.graph.coarse, self.graph.grid
            more = int(coarse.sum()) * (2 ** len(grid.grid.counts) - 1)
            if not more or len(grid) + more > _MOST_BOXES:
                break
            graph, left = self.graph.halved(coarse)
            self.known = replace(self.known, graph=graph)
            yield from self._seen(left)
        graph = self.graph
        assert self.known.proved == stays(graph.found, graph.trapping, graph.labels, graph.ranks)

    def _seen(self, left: Numbers) -> Steps:
        """Enclose the images of some boxes."""
        size = max(1, min(_AT_ONCE, -(-len(left) // self.workers)))
        batches = [*in_batches(left, size)]
        sets, done = map(self.graph.grid.sets, batches), 0
        yield done, len(left)
        with closing(in_processes(_begin_images, self.question, sets, self.workers)) as found:
            for numbers, (_, leaves) in zip(batches, found, strict=True):
                self.known = replace(self.known, graph=self.graph.seen(numbers, leaves))
                done += len(numbers)
                yield done, len(left)


def _extents(motion: Trajectory) -> Floats:
    """The approximate extent of each state along a motion, 1 for those that are constant."""
    first = int(motion.run.configurations[0])
    run = follow(motion.system, motion.states[0], first, transitions=_FOLLOWED)
    extent = np.ptp(run.states, axis=0)
    return np.where(extent > 0, extent, 1.0)


def _grid(
    system: ExactSystem,
    sampled: Sampled,
    boxes: int | None,
    region: Mapping[str, tuple[float, float]],
) -> BoxGrid:
    """The grid of a region: within the given bounds, and about the sampled points elsewhere."""
    names = [system.structure.states[k] for k in sampled.section.free]
    if not names:
        raise InputError("the section is one point: there is nothing to map")
    if other := sorted(region.keys() - {*names}):
        raise InputError(f"{other[0]} is no coordinate of the section, which has {names}")
    low, high = sampled.points.min(axis=0), sampled.points.max(axis=0)
    size = np.maximum(high - low, _LEAST * sampled.ranges)
    low, high = low - _WIDER * size, high + _WIDER * size
    for name, ends in region.items():
        place = names.index(name)
        low[place], high[place] = (float(x) for x in ends)
    for name, a, b in zip(names, low, high, strict=True):
        if not (np.isfinite([a, b]).all() and a < b):
            raise InputError(f"{name} has no interval from {a:g} to {b:g}")
    count = boxes or _DEFAULT_BOXES.get(len(names), _FEW_BOXES)
    return BoxGrid.around(low, high, high / count - low / count, _MOST_BOXES)


def _certificate(
    kernels: SystemKernels,
    system: ExactSystem,
    sampled: Sampled,
    grid: BoxGrid,
    widest: Floats,
    bits: int,
) -> RegionCertificate:
    """The certificate of the question, with no image known yet."""
    return RegionCertificate(
        **stated_section(system, sampled.section),
        graph=BoxGraph.unseen(DividedGrid.of(grid)),
        widest=tuple(widest.tolist()),
        most=0,
        longest=0,
        bits=bits,
        declaration=listed_declaration(kernels, system),
    )
