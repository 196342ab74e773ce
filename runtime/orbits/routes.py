"""Itineraries whose transitions are not all listed yet.

Of a system whose configurations are made when they are visited, those of the itinerary are made.

Through coupled contacts the routes of the law between the phases of an itinerary are listed.

Which steps the law takes from one phase to the next depends on the state there. Before an orbit
is known the shortest route stands for them: all have the same reset. Behind it comes the route
that the law takes at the orbit, whose conditions admissibility and proofs ask for.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from nonsmooth.runtime.events.transition_choice import Decider
from nonsmooth.runtime.model.contacts.law import HOLDING, ContactEvent, Law
from nonsmooth.runtime.model.contacts.stages import Path, Stage
from nonsmooth.runtime.model.contacts.unfolding import Route, unfolded
from nonsmooth.runtime.model.flows import flow_states
from nonsmooth.runtime.model.kernel_records import SystemKernels
from nonsmooth.runtime.model.kernels import grown
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.model.structure import FORCING_PHASE, Structure, structure_of

__all__ = ["with_routes", "with_routes_at"]

Itinerary = Sequence[tuple[str, str | Sequence[str]]]


def with_routes(kernels: SystemKernels, itinerary: Itinerary) -> SystemKernels:
    """Return kernels in which every transition of an itinerary is listed, also those of the law.

    They are the same kernels where nothing is missing.
    """
    structure = structure_of(kernels)
    if structure.unvisited:
        return _visited(kernels, structure, itinerary)
    if structure.law is None or not _missing(structure, itinerary):
        return kernels
    law = structure.law
    return _listed(kernels, itinerary, lambda place, event, target: _shortest(law, event, target))


def _visited(kernels: SystemKernels, structure: Structure, itinerary: Itinerary) -> SystemKernels:
    """Return kernels with the configurations of an itinerary, as far as it is one."""
    known = {structure.configurations[c] for c in structure.visited}
    wanted = [
        (source, names)
        for source, names, _ in _steps(itinerary)
        if source not in known or (len(names) > 1 and not _is_listed(structure, source, names))
    ]
    return grown(kernels, wanted) if wanted else kernels


def _is_listed(structure: Structure, source: str, names: tuple[str, ...]) -> bool:
    here = structure.configuration(source)
    return bool(structure.listed(here, frozenset(structure.boundary(here, n) for n in names)))


def with_routes_at(
    kernels: SystemKernels,
    point: PiecewiseLinear,
    itinerary: Itinerary,
    dwell_times: np.ndarray,
    starts: np.ndarray,
) -> SystemKernels:
    """Return kernels with the routes that the law takes at the ends of an orbit's phases.

    `starts` (p, N) are the states where the phases begin. The kernels are the same where
    the system has no law of contact.
    """
    structure = point.structure
    if structure.law is None:
        return kernels
    law = structure.law
    decider = Decider(structure, point.fields, point.rows, point.resets)

    def taken(place: int, event: ContactEvent, target: int) -> Path:
        source = structure.configuration(itinerary[place][0])
        times = np.asarray(dwell_times[place : place + 1], dtype=float)
        end = flow_states(point, source, times, np.asarray(starts[place], dtype=float))[0]
        error = 64 * np.finfo(float).eps * float(times[0])
        found = decider.outcome(event, decider.located(source, np.append(end, 1.0), error))
        paths = dict(zip(found.targets, found.paths, strict=True))
        alone = len(found.targets) == 1 and target in paths
        return paths[target] if alone else _shortest(law, event, target)

    return _listed(kernels, itinerary, taken)


def _shortest(law: Law, event: ContactEvent, target: int) -> Path:
    """Return the path on which all that slips behind the event slips from its first step on."""
    regimes = law.regimes[target]
    slipping = {i for i in event.resting
                if law.contacts[i].friction and regimes[i] not in HOLDING}  # fmt: skip
    first = Stage(event.reached, regimes)
    return (first,) if slipping <= event.reached else (
        first, Stage(event.reached | slipping, regimes)
    )  # fmt: skip


def _missing(structure: Structure, itinerary: Itinerary) -> bool:
    """Return whether a transition of the itinerary is not listed."""
    for source, names, target in _steps(itinerary):
        here, there = structure.configuration(source), structure.configuration(target)
        reached = frozenset(structure.boundary(here, name) for name in names)
        if all(t.target != there for t in structure.listed(here, reached)):
            return True
    return False


def _steps(itinerary: Itinerary) -> list[tuple[str, tuple[str, ...], str]]:
    """Return source, boundaries and target of each transition that reaches a boundary."""
    if [boundary for _, boundary in itinerary] == [FORCING_PHASE]:
        return []
    names = [tuple(b.split("+")) if isinstance(b, str) else tuple(b) for _, b in itinerary]
    sources = [str(c) for c, _ in itinerary]
    return list(zip(sources, names, [*sources[1:], *sources[:1]], strict=True))


def _listed(
    kernels: SystemKernels, itinerary: Itinerary, path: Callable[[int, ContactEvent, int], Path]
) -> SystemKernels:
    """Return kernels with routes for unlisted transitions that the law allows."""
    structure = structure_of(unfolded(kernels, ()))
    law, routes = structure.law, []
    assert law is not None
    for place, (source, names, target) in enumerate(_steps(itinerary)):
        here, there = structure.configuration(source), structure.configuration(target)
        reached = frozenset(structure.boundary(here, name) for name in names)
        event = law.event(here, names)
        if event is None or not law.leads(event, there):
            continue
        if all(t.target != there for t in structure.listed(here, reached)):
            routes.append(Route(source, names, target, path(place, event, there)))
    return unfolded(kernels, routes)
