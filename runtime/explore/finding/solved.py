"""What is solved for: equilibria, responses to a forcing, and periodic orbits, each once.

Equilibria and responses stay in one configuration. A candidate of an orbit is solved over its
primitive period.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.engine_run import Status
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.model.structure import FORCING_PHASE, structure_of
from nonsmooth.runtime.orbits.admissible import NEITHER, limits_at
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.table_many import solve_itineraries
from nonsmooth.runtime.orbits.table_solve import solve_itinerary
from nonsmooth.runtime.shooting.newton import CONVERGED, SINGULAR
from nonsmooth.runtime.shooting.shooting_map import itinerary_shape
from nonsmooth.runtime.shooting.symmetry import Symmetry
from nonsmooth.runtime.shooting.translations import up_to_shift
from nonsmooth.runtime.simulation.recurrence import (
    Candidate,
    Itinerary,
    canonical,
    itinerary_of,
    variation,
)
from nonsmooth.runtime.simulation.simulate import simulate_one
from nonsmooth.runtime.simulation.starting import configurations_of, on_circles

_DEPENDENT = 1e-10  # relative singular value below which equations are dependent
_ROUNDING = 4 * np.finfo(float).eps  # of a root: what is smaller than its error is zero
_ONE_STATE = 1e-9  # of each number of a state: how near two roots of it are
_NEUTRAL = 1e-9  # real part, in units of the largest eigenvalue
_MOST_TURNS = 24  # of the first forcing, until all meet again
_WHOLE = 1e-9  # of a turn
_SAME = 1e-7  # difference of two orbits, in units of the period and of the states' scales
_TRANSITIONS = 600  # after which a motion has settled
_TURNS, _MOST = 1e-9, 1e-4  # of the turns of one orbit: at least, or what its digits leave


@dataclass(frozen=True, eq=False)
class Equilibrium:
    """A state in which a system without forcing stays, isolated from other equilibria."""

    system: str
    parameters: dict[str, Value]
    configuration: str
    names: tuple[str, ...]  # of the states
    state: np.ndarray  # (N,)
    # (k,), of the motions nearby in its configuration, the slowest decay first
    eigenvalues: np.ndarray

    @property
    def verdict(self) -> str:
        """Stable, unstable, or neutral where motions next to it neither decay nor grow."""
        if not self.eigenvalues.size:
            return "stable"
        error = _NEUTRAL * float(np.abs(self.eigenvalues).max())
        largest = float(self.eigenvalues.real.max())
        if abs(largest) <= error:
            return "neutral"
        return "stable" if largest < 0 else "unstable"


def equilibria(system: PiecewiseLinear) -> list[Equilibrium]:
    """Isolated equilibria that are motions of a system, each once; none for a system with forcing.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> data = {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "r": 1}
    >>> motion = ns.simulate("rigid-stop", data, [0, 0, 1.5, 0], until=1)
    >>> [found.configuration for found in equilibria(motion.system)]
    ['free']
    """
    structure = system.structure
    if structure.forcing:
        return []
    found: list[Equilibrium] = []
    for configuration in structure.visited:
        name = structure.configurations[configuration]
        field = system.fields[configuration]
        constraints = system.rows[list(structure.constraints[configuration])]
        state = _root(np.concatenate([field, constraints]))
        if state is None or any(same_state(state, known.state) for known in found):
            continue
        (where,) = configurations_of(
            structure, system.fields[None], system.rows[None], state[None], name
        )
        if where != configuration:
            continue
        values = _eigenvalues(field[:, :-1], constraints[:, :-1])
        found.append(
            Equilibrium(structure.name, system.parameters, name, structure.states, state, values)
        )
    return found


def same_state(state: np.ndarray, other: np.ndarray) -> bool:
    """Whether two equilibria (N,) are one; zeros of one have to be zeros of the other."""
    return bool((np.abs(state - other) <= _ONE_STATE * np.abs(state)).all())


def forcing_turns(system: PiecewiseLinear) -> tuple[int, ...] | None:
    """Number of turns of each forcing in their common period, or None if there is none.

    It is empty without a forcing.
    """
    speeds = np.abs(system.forcing_speeds)
    if not speeds.size:
        return ()
    for first in range(1, _MOST_TURNS + 1):
        turns = first * speeds / speeds[0]
        if (np.abs(turns - np.round(turns)) <= _WHOLE).all() and (turns > _WHOLE).all():
            return tuple(int(turn) for turn in np.round(turns))
    return None


def forcing_period(system: PiecewiseLinear) -> float | None:
    """Common period of all forcings, or None without one."""
    turns = forcing_turns(system)
    if not turns:
        return None
    return 2 * np.pi * turns[0] / abs(float(system.forcing_speeds[0]))


def responses(system: PiecewiseLinear) -> list[Orbit | None]:
    """Response of each configuration to the forcing, as an orbit that may not be admissible.

    None stands for a configuration that was not visited; all are None without a forcing, or
    where the forcings have no common period.
    """
    structure, period = system.structure, forcing_period(system)
    if period is None:
        return [None] * len(structure.configurations)
    start = on_circles(system, np.zeros((1, len(structure.states))), np.zeros(1))[0]
    return [
        None
        if place in structure.unvisited
        else solve_itinerary(
            system.kernels, system.parameters, [(name, FORCING_PHASE)], [period], start.tolist()
        )
        for place, name in enumerate(structure.configurations)
    ]


def _root(affine: np.ndarray) -> np.ndarray | None:
    """The common zero (N,) of affine functions (m, N + 1); None if there is none, or several."""
    rows = np.abs(affine).max(axis=1)
    affine = affine[rows > 0] / rows[rows > 0, None]
    columns = np.abs(affine[:, :-1]).max(axis=0, initial=0.0)
    if not columns.all() or len(affine) < len(columns):
        return None
    matrix = affine[:, :-1] / columns
    left, values, right = np.linalg.svd(matrix, full_matrices=False)
    if values[-1] <= _DEPENDENT * values[0]:
        return None
    state = right.T @ (left.T @ -affine[:, -1] / values)
    missed = np.abs(matrix @ state + affine[:, -1])
    size = (np.abs(matrix) @ np.abs(state) + np.abs(affine[:, -1])).max()
    if not (missed <= _DEPENDENT * size).all():
        return None
    rounding = _ROUNDING * len(state) * np.linalg.norm(affine[:, -1]) / values[-1]
    return np.where(np.abs(state) <= rounding, 0.0, state / columns)


def _eigenvalues(matrix: np.ndarray, normals: np.ndarray) -> Any:
    """Eigenvalues of a field on the subspace that the constraints leave."""
    _, values, rest = np.linalg.svd(np.concatenate([normals, np.zeros_like(matrix)]))
    free = rest[values <= _DEPENDENT * max(values[0], np.finfo(float).tiny)].T
    found = np.linalg.eigvals(free.T @ matrix @ free).astype(complex)
    return found[np.lexsort((found.imag, -found.real.round(12)))]


def primitive_orbit(point: PiecewiseLinear, candidate: Candidate) -> Orbit | None:
    """The admissible orbit near a candidate, over its primitive period, or None."""
    orbit = _composed(point, candidate)
    if orbit is None or not orbit.converged or not (orbit.dwell_times > 0).all():
        return None
    part = repeated_part(orbit)
    if part is not None:
        return primitive_orbit(point, part)
    return orbit if admissible(orbit) else None


def settled_orbit(
    kernels: SystemKernels,
    parameters: Mapping[str, Any],
    start: Sequence[float],
    configuration: str | None = None,
) -> Orbit | None:
    """The periodic orbit on which a motion from a state (N,) settles, or None.

    Raises `InputError` if there is no such motion, or it does not come back.
    """
    motion = simulate_one(kernels, parameters, start, configuration, transitions=_TRANSITIONS)
    if motion.status == Status.QUIET:
        return responses(motion.system)[int(motion.run.configurations[-1])]
    if motion.status != Status.TRANSITIONS:
        return None
    cycle = itinerary_of(motion, since=motion.end / 2)
    guess = Candidate(cycle.itinerary, cycle.dwell_times, cycle.start, 0.0)
    return primitive_orbit(motion.system, guess)


def in_a_family(point: PiecewiseLinear, candidate: Candidate) -> bool:
    """Whether the orbit near a candidate is one of a family, as exists where energy is kept."""
    orbit = _composed(point, candidate)
    return orbit is not None and orbit.status == SINGULAR and bool((orbit.dwell_times > 0).all())


def admissible(orbit: Orbit) -> bool:
    """Whether an orbit (by tables) is known to be a motion of the system."""
    if orbit.status != CONVERGED:
        return False
    system = orbit.system
    point = [float(orbit.parameters[p.name]) for p in system.parameters]
    cycle = itinerary_shape(structure_of(system), orbit.itinerary)
    dwell, starts = orbit.dwell_times.astype(float), orbit.states.astype(float)
    limits = limits_at(system, cycle, np.array([point]), dwell[None], starts[None])
    return bool(limits[0] == NEITHER)


def orbit_scale(orbit: Orbit) -> np.ndarray:
    """Scale (N,) of each state along an orbit (by tables), in the units of the states."""
    now = orbit.tables.shooting
    states = up_to_shift(np.concatenate([now.starts, now.ends]), orbit.tables.translations)
    before = [
        np.append(start, 1.0) @ orbit.tables.piecewise.fields[c].T
        for start, c in zip(now.starts, orbit.tables.cycle.configurations, strict=False)
    ]
    waits = orbit.dwell_times[:, None]
    return variation(
        orbit.tables.cycle.structure,
        states,
        np.concatenate([now.velocities * waits, before * waits]),
    )


def same_orbit(orbit: Orbit, other: Candidate | Orbit) -> bool:
    """Whether two cycles are one orbit; a doubled one may begin in either of its halves."""
    first = other.state if isinstance(other, Candidate) else other.states[0]
    start = up_to_shift(first, orbit.tables.translations)
    if orbit.tables.cycle.uninterrupted:  # one in each configuration, at whatever phase it begins
        return orbit.itinerary == other.itinerary
    if sorted(orbit.itinerary) != sorted(other.itinerary):
        return False
    near, scale = _SAME * orbit.period, 10 * _SAME * orbit_scale(orbit)
    return any(
        orbit.itinerary == other.itinerary[turn:] + other.itinerary[:turn]
        and (np.abs(orbit.dwell_times - np.roll(other.dwell_times, -turn)) <= near).all()
        and (np.abs(orbit.tables.states_up_to_shift[-turn] - start) <= scale).all()
        for turn in range(len(other.itinerary))
    )


def add_orbit(orbits: list[Orbit], orbit: Orbit) -> None:
    """Append an orbit to a list unless it is there already."""
    if not any(same_orbit(known, orbit) for known in orbits):
        orbits.append(orbit)


def converging(point: PiecewiseLinear, candidates: Iterable[Candidate]) -> Iterator[Candidate]:
    """Candidates from which Newton's method converges, moved to its limits, each once."""
    groups: dict[Itinerary, list[Candidate]] = defaultdict(list)
    for candidate in candidates:
        if (candidate.dwell_times > 0).all():
            groups[candidate.itinerary].append(candidate)
    for itinerary, group in groups.items():
        values = {name: np.full(len(group), float(v)) for name, v in point.parameters.items()}
        found = solve_itineraries(
            point.kernels,
            itinerary,
            values,
            np.array([c.dwell_times for c in group]),
            np.array([c.state for c in group]),
            threads=1,
        )
        good = found.converged & (found.dwell_times > 0).all(axis=1)
        assert found.starts is not None
        states = found.starts[good]
        if not len(states):
            continue
        entries = states.reshape(-1, states.shape[-1])
        scale = variation(point.structure, entries, np.zeros((1, entries.shape[1])))
        kept: list[np.ndarray] = []
        for dwell, state in zip(found.dwell_times[good], states[:, 0], strict=True):
            cycle = np.concatenate([dwell / dwell.sum(), state / scale])
            if not any((np.abs(cycle - known) <= _SAME).all() for known in kept):
                kept.append(cycle)
                yield Candidate(itinerary, dwell, state, 0.0)


def image_of(orbit: Orbit, symmetry: Symmetry) -> Candidate:
    """The image of an orbit (by tables) under a symmetry of its system."""
    structure = orbit.tables.cycle.structure
    phases = []
    for configuration, transition in zip(
        orbit.tables.cycle.configurations, orbit.tables.cycle.transitions, strict=True
    ):
        image = symmetry.configurations[configuration]
        places = symmetry.boundaries[configuration]
        reached = sorted(places[b] for b in transition.boundaries)
        names = [structure.boundaries[image][b].name for b in reached]
        phases.append((structure.configurations[image], "+".join(names) or FORCING_PHASE))
    turn = canonical(tuple(phases))
    return Candidate(
        tuple(phases[turn:] + phases[:turn]),
        np.roll(orbit.dwell_times, -turn),
        symmetry.matrix @ orbit.states[turn],
        0.0,
    )


def _composed(point: PiecewiseLinear, candidate: Candidate) -> Orbit | None:
    """The result of Newton's method from a candidate, or None.

    It is None if a dwell time of the candidate is not positive.
    """
    if not (candidate.dwell_times > 0).all():
        return None
    return solve_itinerary(
        point.kernels,
        point.parameters,
        candidate.itinerary,
        candidate.dwell_times.tolist(),
        candidate.state.tolist(),
    )


def canonical_itinerary(itinerary: Itinerary) -> Itinerary:
    """The rotation of an itinerary that comes first by names: the same for all rotations.

    An itinerary and its repetition stay different: a mass that strikes once in a period and
    one that strikes twice have two itineraries.
    """
    turn = canonical(itinerary)
    return itinerary[turn:] + itinerary[:turn]


def repeated_part(orbit: Orbit) -> Candidate | None:
    """The shortest part that an orbit repeats in phases, dwell times and states, or None.

    The orbit is one by tables.
    """
    count = len(orbit.itinerary)
    near = min(max(_TURNS, 100 * 10.0**-orbit.digits), _MOST)
    scale = orbit_scale(orbit)
    for length in range(1, count // 2 + 1):
        turns, rest = divmod(count, length)
        if rest or orbit.itinerary != orbit.itinerary[:length] * turns:
            continue
        dwell = orbit.dwell_times.reshape(turns, length)
        states = orbit.tables.states_up_to_shift.reshape(turns, length, -1)
        if (np.abs(dwell - dwell[0]) <= near * orbit.period).all() and (
            np.abs(states - states[0]) <= near * scale
        ).all():
            return Candidate(orbit.itinerary[:length], dwell[0], orbit.states[0], 0.0)
    return None
