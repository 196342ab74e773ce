"""Prove where motions go from the boxes of a region, and read trapping regions from the graph."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from nonsmooth.runtime.core.box_grid import BoxGrid
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.float_sets import Floats
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.model.kernels import SystemKernels, kernels_of
from nonsmooth.runtime.model.loading.declared import DeclaredSystem
from nonsmooth.runtime.proof.chaos.section_choice import Sampled, sampled_sections
from nonsmooth.runtime.proof.graphs.box_graphs import BoxGraph
from nonsmooth.runtime.proof.graphs.graph_certificate import Component, GraphCertificate
from nonsmooth.runtime.proof.motion.enclosures import EnclosedSystem, enclosed_system
from nonsmooth.runtime.proof.sets.branching import BranchingMap, Leaves
from nonsmooth.runtime.simulation.simulate import follow, simulate
from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["certify_graph"]

_BITS = 64
_FEWEST_BITS, _MOST_BITS = 64, 4096
_WIDER = 0.25  # of the sampled extent, at each side
_LEAST = 1e-3  # of a coordinate's size: a sampled extent is widened as if it were no less
_WIDEST = 0.2  # of the extent of states: wider sets are divided on the way
_FOLLOWED = 200  # transitions, to see how large states become
_AT_ONCE = 2048  # boxes
_MOST_BOXES = 4_000_000
_DEFAULT_BOXES = {1: 1024, 2: 96}  # by the number of coordinates
_FEW_BOXES = 16  # with more coordinates


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
    progress: Callable[[int, int], object] = lambda done, count: None,
) -> GraphCertificate:
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
    progress : callable
        Told how many boxes of how many were mapped.

    Returns
    -------
    GraphCertificate

    Raises
    ------
    InputError
        For wrong names or numbers, a parameter that is not rational, several forcings, or a
        motion that comes to no section often enough.

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
    >>> found = ns.certify_graph(
    ...     "dry-friction", data, [5, 4, 0.5, 0.25], region={"x2": (2, 13)}, boxes=64
    ... )
    >>> found.proved, [own.attracting for own in found.components]
    (True, [True])
    """
    for name, number, least, most in (
        ("boxes", 1 if boxes is None else boxes, 1, 1_000_000),
        ("parts", parts, 1, 1_000_000),
        ("transitions", transitions, 1, 10_000),
        ("bits", bits, _FEWEST_BITS, _MOST_BITS),
    ):
        if isinstance(number, bool) or not isinstance(number, int) or not least <= number <= most:
            raise InputError(f"{name} = {number!r} is not an integer from {least} to {most}")
    kernels = kernels_of(system)
    at = enclosed_system(kernels, parameters)
    motion = simulate(kernels, parameters, start, configuration, transitions=1)
    with flint_precision(bits):
        enclosed = at(bits)
        if len(enclosed.structure.forcing) > 1:
            raise InputError(f"{enclosed.structure.name} has several forcings: a map needs one")
        sampled = next(iter(sampled_sections(enclosed, motion)), None)
        if sampled is None:
            raise InputError("the motion comes to no section often enough")
        grid = _grid(enclosed, sampled, boxes, region or {})
        mapped = BranchingMap(
            enclosed, sampled.section, _extents(motion), _WIDEST, most=parts, longest=transitions
        )
        graph = BoxGraph.of_leaves(grid, _leaves(mapped, grid, progress))
    return _certificate(enclosed, sampled, graph)


def _extents(motion: Trajectory) -> Floats:
    """About how large the states of a motion become, 1 for those that are constant."""
    first = int(motion.run.configurations[0])
    run = follow(motion.system, motion.states[0], first, transitions=_FOLLOWED)
    extent = np.ptp(run.states, axis=0)
    return np.where(extent > 0, extent, 1.0)


def _grid(
    system: EnclosedSystem,
    sampled: Sampled,
    boxes: int | None,
    region: Mapping[str, tuple[float, float]],
) -> BoxGrid:
    """The grid of a region: what is given of it, else about the sampled points."""
    names = [system.structure.states[k] for k in sampled.section.free]
    if not names:
        raise InputError("the section is one point: there is nothing to map")
    if other := sorted(region.keys() - {*names}):
        raise InputError(f"{other[0]} is no coordinate of the section, which has {names}")
    low, high = sampled.points.min(axis=0), sampled.points.max(axis=0)
    size = np.maximum(high - low, _LEAST * np.maximum(np.abs(low), np.abs(high)) + _LEAST)
    low, high = low - _WIDER * size, high + _WIDER * size
    for name, ends in region.items():
        place = names.index(name)
        low[place], high[place] = (float(x) for x in ends)
    for name, a, b in zip(names, low, high, strict=True):
        if not (np.isfinite([a, b]).all() and a < b):
            raise InputError(f"{name} has no interval from {a:g} to {b:g}")
    count = boxes or _DEFAULT_BOXES.get(len(names), _FEW_BOXES)
    grid = BoxGrid.around(low, high, (high - low) / count)
    if len(grid) > _MOST_BOXES:
        raise InputError(f"{len(grid)} boxes are more than {_MOST_BOXES}")
    return grid


def _leaves(
    mapped: BranchingMap, grid: BoxGrid, progress: Callable[[int, int], object]
) -> Iterator[tuple[int, Leaves]]:
    for first in range(0, len(grid), _AT_ONCE):
        numbers = np.arange(first, min(first + _AT_ONCE, len(grid)))
        yield first, mapped.leaves(grid.sets(numbers))
        progress(int(numbers[-1]) + 1, len(grid))


def _certificate(system: EnclosedSystem, sampled: Sampled, graph: BoxGraph) -> GraphCertificate:
    section, structure = sampled.section, system.structure
    names = structure.configurations
    _, visited, _ = graph.grid.numbers_met(sampled.points, sampled.points)
    visited = np.unique(visited)
    found = _components(graph, visited)
    # the attracting ones first
    order = sorted(range(len(found)), key=lambda k: not found[k].attracting)
    place = {k: number for number, k in enumerate(order)}
    shapes = structure.boundaries[section.source] if section.phase is None else ()
    return GraphCertificate(
        system=structure.name,
        parameters=system.values,
        configuration=names[section.configuration],
        phase=() if section.phase is None else tuple(map(str, section.phase)),
        source=names[section.source] if section.phase is None else "",
        boundary="+".join(sorted(shapes[b].name for b in section.boundaries)),
        coordinates=tuple(structure.states[k] for k in section.free),
        graph=graph,
        components=tuple(found[k] for k in order),
        arrows=tuple(sorted((place[i], place[j]) for i, j in graph.arrows())),
        visited=visited,
        bits=system.bits,
    )


def _components(graph: BoxGraph, visited: Any) -> list[Component]:
    found = []
    for own in graph.components:
        ahead = graph.ahead(own)
        escapes = bool((ahead & (graph.outside | graph.unknown)).any())
        low, high = graph.grid.bounds(own)
        found.append(
            Component(
                boxes=own,
                low=tuple(low.min(axis=0).tolist()),
                high=tuple(high.max(axis=0).tolist()),
                attracting=not escapes and int(ahead.sum()) == len(own),
                leaves=escapes,
                visited=bool(np.isin(visited, own).any()),
            )
        )
    return found
