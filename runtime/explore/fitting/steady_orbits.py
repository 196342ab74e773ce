"""Steady periodic responses: what motions settle on, and the same at other parameters.

A response is followed from where it was known last. Where it is a motion no more, because a
boundary collision or a fold was passed, a motion from it shows what takes its place. At first, and
when it is asked for again, the responses are looked for as in a test: swept up and down through
the points, and from a few starts at random.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import NonsmoothError
from nonsmooth.runtime.explore.finding.find import find_orbits
from nonsmooth.runtime.explore.finding.primitive import add_orbit, primitive_orbit
from nonsmooth.runtime.explore.finding.start_box import start_box
from nonsmooth.runtime.explore.finding.steady import responses
from nonsmooth.runtime.model.engine_run import Status
from nonsmooth.runtime.model.kernels import SystemKernels, grown
from nonsmooth.runtime.model.piecewise import PiecewiseLinear, piecewise
from nonsmooth.runtime.orbits.admissible import Admissibility
from nonsmooth.runtime.orbits.derivatives import OrbitDerivatives, followed
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.simulation.last_cycle import itinerary_of
from nonsmooth.runtime.simulation.recurrence import Candidate, Itinerary, canonical
from nonsmooth.runtime.simulation.simulate import simulate_one
from nonsmooth.runtime.simulation.starting import on_circles

__all__ = ["KnownResponses", "responses_at", "survey", "survey_of"]

_TRANSITIONS = 600  # after which a motion has settled
_STARTS = 6  # at random, at each point
_SEARCHED = 60  # starts of a search for an orbit that is told
_SHORTEST = 0.25  # step of the way to other parameters: then a response is lost
_MOST = 6  # responses that are remembered at a point

Point = Mapping[str, Any]
"""All parameters of one steady state."""


class KnownResponses:
    """Responses that are known at each of several points, from which others are followed."""

    def __init__(self) -> None:
        self._orbits: dict[tuple[int, int], list[OrbitDerivatives]] = {}

    def at(self, experiment: int, place: int) -> list[OrbitDerivatives]:
        """Known responses at a point of an experiment."""
        return self._orbits.get((experiment, place), [])

    def keep(self, experiment: int, place: int, orbits: Sequence[OrbitDerivatives]) -> None:
        """Replace the known responses at a point of an experiment; the latest ones come first."""
        self._orbits[experiment, place] = list(orbits[:_MOST])

    def known(self, experiment: int) -> bool:
        """Whether the responses of an experiment have been searched for."""
        return any(known == experiment for known, _ in self._orbits)


def responses_at(
    kernels: SystemKernels,
    parameters: Point,
    by: Sequence[str],
    known: Sequence[OrbitDerivatives],
    *,
    unstable: bool,
) -> tuple[list[OrbitDerivatives], list[OrbitDerivatives]]:
    """The responses at other parameters, each once, and the known ones that were lost on the way.

    Where the first known one is lost, a motion from it shows what takes its place. `by` lists
    the parameters of the derivatives; `known` are responses at parameters nearby, the chosen
    one first. With `unstable`, unstable responses count too, for a given itinerary.
    """
    found: list[OrbitDerivatives] = []
    lost: list[OrbitDerivatives] = []
    orbits: list[Orbit] = []

    def add(derivatives: OrbitDerivatives) -> None:
        count = len(orbits)
        add_orbit(orbits, derivatives.orbit)
        if len(orbits) > count:
            found.append(derivatives)

    for reference in known:
        try:
            there = _followed(reference, parameters, by)
            if _counts(there.orbit, unstable=unstable):
                add(there)
                continue
        except (NonsmoothError, ArithmeticError, np.linalg.LinAlgError):
            pass
        lost.append(reference)
    for reference in lost[:1] if not unstable and lost and lost[0] is known[0] else []:
        orbit = reference.orbit
        start, configuration = orbit.states[0].astype(float).tolist(), orbit.itinerary[0][0]
        for other in _settled_from(kernels, parameters, start, configuration):
            try:
                add(other.derivatives(list(by)))
            except NonsmoothError:
                continue
    return found, lost


def _settled_from(
    kernels: SystemKernels,
    parameters: Point,
    start: Sequence[float],
    configuration: str | None = None,
) -> list[Orbit]:
    """The periodic response on which a motion from a state (N,) settles, in a list.

    The list is empty where the motion does not settle on a periodic one.
    """
    try:
        motion = simulate_one(kernels, parameters, start, configuration, transitions=_TRANSITIONS)
        current = motion.structure.kernels or kernels
        point = motion.system
        if motion.status == Status.QUIET:
            orbit = responses(current, point)[int(motion.run.configurations[-1])]
        elif motion.status == Status.TRANSITIONS:
            cycle = itinerary_of(motion, since=motion.end / 2)
            guess = Candidate(cycle.itinerary, cycle.dwell_times, cycle.start, 0.0)
            orbit = primitive_orbit(current, point, guess)
        else:
            return []
        return [orbit] if orbit is not None and _counts(orbit, unstable=False) else []
    except (NonsmoothError, ArithmeticError, np.linalg.LinAlgError):
        return []


def survey(kernels: SystemKernels, points: Sequence[Point]) -> list[list[Orbit]]:
    """The stable responses at each of several points, which are in the order of a sweep."""
    found: list[list[Orbit]] = [[] for _ in points]
    for place, parameters in enumerate(points):
        for start in _starts(piecewise(grown(kernels), parameters)):
            for orbit in _settled_from(kernels, parameters, start):
                add_orbit(found[place], orbit)
    up = range(1, len(points))
    for places, back in ((up, -1), (range(len(points) - 2, -1, -1), 1)):
        for place in places:
            for neighbour in found[place + back]:
                start = neighbour.states[0].astype(float).tolist()
                for orbit in _settled_from(
                    kernels, points[place], start, neighbour.itinerary[0][0]
                ):
                    add_orbit(found[place], orbit)
    return found


def survey_of(
    kernels: SystemKernels, points: Sequence[Point], itinerary: Itinerary
) -> list[list[Orbit]]:
    """The responses of an itinerary at each of several points, unstable ones too.

    The points are in the order of a sweep. Responses are followed from point to point, from
    where one is stable or lies near a motion.
    """
    turn = canonical(itinerary)
    wanted = itinerary[turn:] + itinerary[:turn]

    def is_wanted(orbit: Orbit) -> bool:
        phases = orbit.itinerary
        first = canonical(phases)
        return phases[first:] + phases[:first] == wanted

    found = [[*filter(is_wanted, orbits)] for orbits in survey(kernels, points)]
    if not any(found):
        for place, parameters in enumerate(points):
            orbits = (each.orbit for each in find_orbits(kernels, parameters, _SEARCHED).orbits)
            found[place] = [*filter(is_wanted, orbits)]
            if found[place]:
                break
    up, down = range(1, len(points)), range(len(points) - 2, -1, -1)
    for places, back in ((up, -1), (down, 1)):
        for place in places:
            for neighbour in found[place + back]:
                try:
                    by = [next(iter(points[place]))]
                    orbit = _followed(neighbour.derivatives(by), points[place], by).orbit
                    if _counts(orbit, unstable=True):
                        add_orbit(found[place], orbit)
                except (NonsmoothError, ArithmeticError, np.linalg.LinAlgError):
                    continue
    return found


def _starts(system: PiecewiseLinear) -> list[list[float]]:
    """The state of rest, and a few random states."""
    limits = start_box(system)
    generator = np.random.default_rng(0)
    drawn = generator.uniform(limits[:, 0], limits[:, 1], (_STARTS, len(limits)))
    states = np.concatenate([np.zeros((1, len(limits))), drawn])
    angles = np.concatenate([[0.0], generator.uniform(0, 2 * np.pi, _STARTS)])
    return [state.tolist() for state in on_circles(system, states, angles)]


def _followed(
    reference: OrbitDerivatives, parameters: Point, by: Sequence[str]
) -> OrbitDerivatives:
    """The same response at other parameters, differentiated."""
    given = reference.orbit.given
    target = {name: float(value) for name, value in parameters.items()}
    moved = [name for name, value in given.items() if float(value) != target[name]]
    changing = tuple(dict.fromkeys([*by, *moved]))
    if reference.by != changing:
        reference = reference.orbit.derivatives(changing)
    there = followed(reference, np.array([target[name] for name in changing]), _SHORTEST)
    return there if tuple(by) == changing else there.orbit.derivatives(list(by))


def _counts(orbit: Orbit, *, unstable: bool) -> bool:
    """Whether an orbit is a motion that a test can show, or any motion if `unstable`."""
    if not orbit.converged or not (orbit.dwell_times > 0).all():
        return False
    judged: Admissibility = orbit.admissibility
    if judged.verdict is not True:
        return False
    return unstable or orbit.stability.verdict != "unstable"
