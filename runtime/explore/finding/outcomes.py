"""Where motions lead: to an orbit or an equilibrium, or how else they end.

`attractors_of` compares many motions of one system with what was found, `settled` looks at one
motion at each of many parameter points.

Motions escape that grow far out, in units of the size that boundaries, loads and forcing give a
system: there only its homogeneous part counts, and what escapes grows in proportion to time, or
exponentially. A motion that leaves an unstable orbit or equilibrium grows to that size and no
further, and one that builds up to a response grows less and less.

A motion may come back with the forcing, as a stroboscope sees it, by however many transitions:
where impacts follow each other ever faster, until a mass rests at its stop, no cycle of transitions
is short, nor the same in every period.

Else it counts how fast neighbours part. Two motions that begin next to each other are followed
transition by transition; what parts them is scaled back again and again (Benettin et al., Meccanica
15, 1980). States behind the same transition lie on one section, so that the direction of the motion
does not count. `nonsmooth.runtime.simulation.lyapunov` carries derivatives along a single motion
instead: exact, with the whole spectrum, thirty times slower, and only where there are derivatives.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from enum import IntEnum
from itertools import compress
from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.explore.finding.solved import (
    Equilibrium,
    admissible,
    equilibria,
    forcing_period,
    forcing_turns,
    orbit_scale,
    responses,
)
from nonsmooth.runtime.model.boundary_sets import mask_of
from nonsmooth.runtime.model.engine_run import LARGEST_STATE, Status
from nonsmooth.runtime.model.flows import parts_of
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.parameters import parameter_points
from nonsmooth.runtime.model.piecewise import (
    PiecewiseLinear,
    piecewise_at,
)
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.shooting.newton import SINGULAR
from nonsmooth.runtime.shooting.translations import translations_of, up_to_shift
from nonsmooth.runtime.simulation.engines import Trajectories
from nonsmooth.runtime.simulation.recurrence import recurrent_lengths, scales_of, sizes_of
from nonsmooth.runtime.simulation.simulate import simulate_many

_ENDURING = 4096  # transitions for which every motion is followed on, at least
_FOLLOWED = 5  # in which a motion that grows is followed on, each as long as all before
_STEADY = 3  # of them, one after the other, in which what escapes grows steadily
_PROPORTIONAL = 0.975  # growth by that in proportion to time
_FAR = 100.0  # natural sizes
_GROWTH = 1.05  # by the largest size so far: no more is none
_SINGULAR = 1e-10  # relative singular value of a field that has no equilibrium
_APART = 1e-10  # in units of the scales
_BLOCK, _BLOCKS = 16, 52  # transitions from one scaling to the next, and how many there are
_TURNING = _BLOCKS // 4  # blocks in which what parts the motions turns to its direction
_LOST = 1e-15  # of the scales: below, nothing is left that parts them
_PARTS = 8  # of a motion that settles, from each to the next
_ROUNDING = 1e-9
_FLASHES = 12  # the longest motion that comes back, in common periods of the forcings
_MOST = 2048  # transitions from one flash to the next
_ASIDE = 0.3819660112501051  # of a period, from the last transition to the first flash
_ARRIVED = 1e-3  # how near to an attractor a motion has to end, relative to its size
_NOTHING = 1e-9  # of a state's size: a part of a motion that is none
_SLOW = 1e-12  # rate of a motion that neither decays nor grows, in units of the fastest
_ROUNDED = 1e-7  # exponent that rounding makes of zero, beside a drift, in the same units
_EQUAL = 1e-9  # relative difference of a frequency from the forcing's
_CERTAIN = 3.0  # standard errors of an exponent
PERIODIC, UNINTERRUPTED, EQUILIBRIUM = 0, 1, 2  # beside the numbers of an Outcome
_RETURN = 1e-6  # in units of the largest size of a state on the cycle


class Pursued(NamedTuple):
    """Motions (n,) after a longer simulation, with masks (n,) of escaping and undecided ones.

    A motion is undecided if it still grows, but not as one that escapes.
    """

    motions: Trajectories
    escapes: np.ndarray
    undecided: np.ndarray
    lengths: np.ndarray  # (n,) transitions in a period; 0 where a motion does not come back
    periods: np.ndarray  # (n,) its time; NaN where a motion does not come back


def pursue(
    systems: Sequence[PiecewiseLinear],
    motions: Trajectories,
    threads: int | None,
) -> Pursued:
    """Motions (n,) of as many systems, followed for at least as many transitions again.

    They are followed further as long as they grow. They have to have ended after a number of
    transitions that is the same for all. `threads` None takes all processors.
    """
    count, kept = motions.last_times.shape
    values = numbers_of(systems)
    far = _FAR * np.array([natural_size(each) for each in systems])
    largest, steady = _sizes(systems, motions), np.zeros(count, dtype=int)
    escapes, going = np.zeros(count, dtype=bool), np.arange(count)
    total, length = int(motions.transitions.max(initial=0)), _ENDURING
    for _ in range(_FOLLOWED):
        length = max(length, total)
        later = simulate_many(
            systems[0].kernels,
            _numbers_at(values, going),
            motions.last_states[going, -1],
            motions.last_configurations[going, -1],
            transitions=length,
            keep=kept,
            threads=threads,
        )
        arrays = [array.copy() for array in motions.arrays]
        for array, other in zip(arrays, later.arrays, strict=True):
            array[going] = other
        motions = Trajectories(motions.structure, *arrays)
        sizes = _sizes([systems[place] for place in going.tolist()], later)
        goes_on = later.status == Status.TRANSITIONS
        ratios = sizes / np.where(largest[going] > 0, largest[going], 1.0)
        in_proportion = ratios * total >= _PROPORTIONAL * (total + length)
        steady[going] = np.where(in_proportion, steady[going] + 1, 0)
        escapes[going] = goes_on & (steady[going] >= _STEADY) & (sizes >= far[going])
        largest[going] = np.maximum(largest[going], sizes)
        going = going[goes_on & (ratios > _GROWTH) & ~escapes[going]]
        total += length
        if not going.size:
            break
    undecided = np.isin(np.arange(count), going)
    return Pursued(motions, escapes, undecided, *_stroboscopic_returns(systems, motions, threads))


def numbers_of(systems: Sequence[PiecewiseLinear]) -> dict[str, float | np.ndarray]:
    """Parameters of systems (n,) as arrays (n,), or as numbers where all are the same system."""
    first = systems[0]
    if all(system is first for system in systems):
        return {name: float(value) for name, value in first.parameters.items()}
    return {
        name: np.array([float(system.parameters[name]) for system in systems])
        for name in first.parameters
    }


def _numbers_at(values: Mapping[str, Any], places: np.ndarray) -> dict[str, Any]:
    """Parameters, numbers or arrays (n,), of the systems at some places."""
    return {name: value[places] if np.ndim(value) else value for name, value in values.items()}


def natural_size(system: PiecewiseLinear) -> float:
    """Distance that a system's boundaries, its equilibria and its responses to the forcing reach.

    All configurations count, admissible or not; a homogeneous system has the distance zero.
    It is in the unit of velocities; positions count times the fastest exponent.
    """
    structure, weights = system.structure, _weights(system)
    own = np.flatnonzero(weights)
    rows = np.abs(system.rows[list(structure.watched)])
    across = (rows[:, own] / weights[own]).sum(axis=1)
    other = np.delete(rows, own, axis=1).sum(axis=1)
    found = float((other[across > 0] / across[across > 0]).max(initial=0.0))
    for field in system.fields:
        matrix, size = field[np.ix_(own, own)], np.zeros(len(own))
        loads = [(0.0, field[own, -1])]
        for cosine, sine in structure.forcing:
            loads.append((float(field[sine, cosine]), field[own, cosine] - 1j * field[own, sine]))
        for speed, load in loads:
            dynamic = 1j * speed * np.eye(len(own)) - matrix
            size += np.abs(np.linalg.lstsq(dynamic, load, rcond=_SINGULAR)[0])
        found = max(found, float((weights[own] * size).max(initial=0.0)))
    return found


def _weights(system: PiecewiseLinear) -> np.ndarray:
    """Weights (N,) that make states comparable.

    They are the fastest exponent for positions, 0 for the states of a forcing, and 1 for others.
    """
    structure = system.structure
    rates = [np.hypot(*exponents.T) for exponents in system.exponents]
    fastest = float(np.concatenate(rates).max(initial=0.0))
    found = np.ones(len(structure.states))
    found[[position for position, _ in structure.coordinates]] = fastest or 1.0
    found[list(structure.forced)] = 0.0
    return found


def _sizes(systems: Sequence[PiecewiseLinear], motions: Trajectories) -> np.ndarray:
    """Largest sizes (n,) of motions over the entries that are kept, up to translations."""
    ends = np.concatenate([motions.last_states, motions.states[:, None]], axis=1)
    states = _up_to_shift(systems, np.where(np.isnan(ends), 0.0, ends))
    weights = np.array([_weights(system) for system in systems])
    return np.asarray((np.abs(states) * weights[:, None]).max(axis=(1, 2)))


def _up_to_shift(systems: Sequence[PiecewiseLinear], states: np.ndarray) -> np.ndarray:
    """States (n, ..., N) of as many systems, up to translations."""
    found = states.copy()
    for place, system in enumerate(systems):
        found[place] = up_to_shift(states[place], translations_of(system))
    return found


class Stretching(NamedTuple):
    """Largest exponents (n,) of motions, and their standard errors, in units of one over time.

    The exponent is NaN where a motion ends or still settles, or its neighbour goes another way.
    An error is at least that of a single stretching by e.
    """

    exponents: np.ndarray
    errors: np.ndarray


def stretching(
    kernels: SystemKernels,
    parameters: Mapping[str, Any],
    motions: Trajectories,
    scales: np.ndarray,
    threads: int | None = None,
) -> Stretching:
    """Largest exponents of motions (n,), each of which is followed beside a neighbour.

    At least the last three entries of the motions have to be kept. `parameters` are numbers or
    arrays (n,), `scales` (n, N) are those of the states; `threads` None takes all processors.
    """
    count = len(motions.times)
    growths, lengths = np.full((_BLOCKS, count), np.nan), np.zeros((_BLOCKS, count))
    highest, lowest = np.zeros((2, _BLOCKS, *scales.shape))

    def follow(states: np.ndarray, configurations: np.ndarray, **ends: Any) -> Trajectories:
        here = _numbers_at(parameters, going)
        return simulate_many(kernels, here, states, configurations, threads=threads, **ends)

    # inside the last phase but one, where any small change that its constraints allow is one
    configurations = motions.last_configurations[:, -2]
    halves = np.diff(motions.last_times[:, -2:], axis=1)[:, 0] / 2
    change = _changes(motions, scales)
    usable = (motions.status == Status.TRANSITIONS) & (halves > 0)
    going = np.flatnonzero(usable & np.isfinite(change).all(axis=1))
    entries = motions.last_states[going, -2]
    middle = follow(entries, configurations[going], until=halves[going]).states
    now = np.stack([middle, middle + _APART * change[going]])
    where = np.stack([configurations[going]] * 2)
    for block in range(_BLOCKS):
        ends = follow(now, where, transitions=_BLOCK, keep=_BLOCK)
        apart = (ends.states[1] - ends.states[0]) / scales[going]
        distance = np.abs(apart).max(axis=1)
        together = (ends.status == Status.TRANSITIONS).all(axis=0) & np.isfinite(distance)
        together &= ends.configurations[0] == ends.configurations[1]
        together &= ends.last_sets[0, :, -1] == ends.last_sets[1, :, -1]
        growths[block, going] = np.log(np.maximum(distance, _LOST) / _APART)
        lengths[block, going] = ends.times[0]
        highest[block, going] = ends.last_states[0].max(axis=1)
        lowest[block, going] = ends.last_states[0].min(axis=1)
        growths[block:, going[~together]] = np.nan
        back = np.where(distance > _LOST, _APART / np.maximum(distance, _LOST), 1.0)
        nearer = ends.states[0] + apart * back[:, None] * scales[going]
        # a rounding error of a forcing would neither grow nor decay, and outlast what decays
        for pair in map(list, motions.structure.forcing):
            strengths = (np.hypot(*each[:, pair].T) for each in (ends.states[0], nearer))
            nearer[:, pair] *= np.divide(*strengths)[:, None]
        now = np.stack([ends.states[0], nearer])[:, together]
        going, where = going[together], ends.configurations[:, together]
        if not going.size:
            break
    return _measured(growths[_TURNING:], lengths[_TURNING:], (highest - lowest) / scales)


def _measured(growths: np.ndarray, lengths: np.ndarray, ranges: np.ndarray) -> Stretching:
    """Exponents from growths and lengths (blocks, n); NaN where ranges (blocks, n, N) shrink.

    Ranges are in units of the scales; below the distance of neighbours they are rounding.
    """
    whole, blocks = lengths.sum(axis=0), len(growths)
    whole = np.where(whole > 0, whole, np.nan)
    spread = growths.std(axis=0, ddof=1) * np.sqrt(blocks)
    parts = np.stack([part.max(axis=0) for part in np.array_split(ranges, _PARTS)])
    shrinks = (np.diff(parts, axis=0) < 0).all(axis=0)
    shrinks &= (parts[-1] < (1 - _ROUNDING) * parts[0]) & (parts[0] > _APART)
    exponents = np.where(shrinks.any(axis=1), np.nan, growths.sum(axis=0) / whole)
    return Stretching(exponents, np.maximum(spread, 1.0) / whole)


def _changes(motions: Trajectories, scales: np.ndarray) -> np.ndarray:
    """Directions (n, N) of length 1 that the constraints of the last phase but one allow.

    They lead from one state to another at which the same configuration is entered; the forcing
    stays. They are NaN without another such state.
    """
    configurations, states = motions.last_configurations, motions.last_states
    other = np.argmax(configurations[:, :-2] == configurations[:, [-2]], axis=1)
    found = states[np.arange(len(states)), other] - states[:, -2]
    found[:, list(motions.structure.forced)] = 0.0
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.asarray(found / np.abs(found / scales).max(axis=1, keepdims=True))


def _stroboscopic_returns(
    systems: Sequence[PiecewiseLinear],
    motions: Trajectories,
    threads: int | None,
) -> tuple[np.ndarray, np.ndarray]:
    """Transitions (n,) and times until motions of as many systems come back with the forcing.

    The last entries of the motions have to be kept. `threads` None takes all processors.
    """
    values = numbers_of(systems)
    periods = np.array([forcing_period(system) or np.nan for system in systems])
    directions = [translations_of(system) for system in systems]
    sizes = sizes_of(motions.structure, motions.last_states, motions.last_times)
    lengths, times = np.zeros(len(systems), dtype=int), np.full(len(systems), np.nan)
    going = np.flatnonzero((motions.status == Status.TRANSITIONS) & np.isfinite(periods))
    states = motions.last_states[going, -1]
    configurations = motions.last_configurations[going, -1]
    passed = np.zeros(len(systems), dtype=int)
    first: Trajectories | None = None
    for flash in range(_FLASHES + 1):
        if not going.size:
            break
        now = simulate_many(
            systems[0].kernels,
            _numbers_at(values, going),
            states,
            configurations,
            until=periods[going] * (1.0 if flash else _ASIDE),
            transitions=_MOST,
            threads=threads,
        )
        stays = now.status == Status.UNTIL
        if first is None:
            first = now
        else:
            passed[going] += now.transitions
            moved = now.states - first.states
            moved = np.array([up_to_shift(moved[k], directions[p]) for k, p in enumerate(going)])
            back = (np.abs(moved) <= _RETURN * sizes[going]).all(axis=1)
            back &= stays & (now.configurations == first.configurations)
            times[going[back]] = flash * periods[going[back]]
            lengths[going[back]] = passed[going[back]]
            stays &= ~back
        going, first = going[stays], first.at(stays)
        states, configurations = now.states[stays], now.configurations[stays]
    return lengths, times


class Outcome(IntEnum):
    """How a motion ends that leads to no orbit or equilibrium that is listed."""

    UNCLASSIFIED = -1
    RESTING = -2
    ILLEGAL = -3
    FAMILY = -4
    INCOMMENSURATE = -5
    QUASIPERIODIC = -6
    CHAOTIC = -7
    DIVERGENT = -8
    DRIFTING = -9

    @property
    def text(self) -> str:
        """The outcome in words."""
        return _TEXTS[self]


_TEXTS = {
    Outcome.UNCLASSIFIED: "not classified",
    Outcome.RESTING: "came to rest",
    Outcome.ILLEGAL: "in no configuration",
    Outcome.FAMILY: "one of a family of motions",
    Outcome.INCOMMENSURATE: "quasi-periodic, as the forcings have no common period",
    Outcome.QUASIPERIODIC: "quasi-periodic",
    Outcome.CHAOTIC: "chaotic",
    Outcome.DIVERGENT: "divergent",
    Outcome.DRIFTING: "moves on steadily",
}


@dataclass(frozen=True, eq=False)
class Attractors:
    """The orbits and equilibria that motions of a system may lead to."""

    system: PiecewiseLinear
    orbits: tuple[Orbit, ...]  # including the responses to the forcing within one configuration
    equilibria: tuple[Equilibrium, ...]
    # response of each configuration to the forcing, a motion of the system or not
    responses: tuple[Orbit | None, ...]

    def labels(self, motions: Trajectories) -> np.ndarray:
        """Labels (n,) of motions: the place of an orbit, then of an equilibrium, or an `Outcome`.

        Motions that go on from boundary to boundary without an orbit are UNCLASSIFIED. The last
        two entries of the motions have to be kept.
        """
        labels = _arrivals(motions, self.orbits)
        staying: dict[str, int] = {}  # the first that never leaves a configuration
        for place, orbit in enumerate(self.orbits):
            if orbit.tables.cycle.uninterrupted:
                staying.setdefault(orbit.itinerary[0][0], place)
        for place, equilibrium in enumerate(self.equilibria, len(self.orbits)):
            staying.setdefault(equilibrium.configuration, place)
        # one that was visited since stays unclassified
        quiet = (motions.status == Status.QUIET) & (motions.configurations < len(self.responses))
        for configuration in np.unique(motions.configurations[quiet]).tolist():
            here = quiet & (motions.configurations == configuration)
            labels[here] = _quiet_outcomes(
                self.system,
                configuration,
                motions.states[here],
                self.responses[configuration],
                staying.get(self.system.structure.configurations[configuration]),
            )
        return labels

    def measured(
        self, motions: Trajectories, labels: np.ndarray, threads: int | None = None
    ) -> np.ndarray:
        """The labels (n,) of `labels`, after unclassified motions were followed further.

        `threads` None takes all processors.
        """
        places = np.flatnonzero(
            (labels == Outcome.UNCLASSIFIED) & (motions.status == Status.TRANSITIONS)
        )
        found = labels.copy()
        if places.size:
            systems = [self.system] * len(places)
            pursued = pursue(systems, motions.at(places), threads)
            later = self.labels(pursued.motions)
            found[places] = pursued_outcomes(systems, pursued, later, threads)
        return found


def attractors_of(system: PiecewiseLinear, orbits: Sequence[Orbit]) -> Attractors:
    """Given orbits, converged and admissible, with the attractors within one configuration."""
    forced = responses(system)
    staying = [orbit for orbit in forced if orbit is not None and orbit.converged]
    known = [orbit for orbit in orbits if not orbit.tables.cycle.uninterrupted]
    return Attractors(
        system,
        (*known, *(orbit for orbit in staying if admissible(orbit))),
        tuple(equilibria(system)),
        tuple(forced),
    )


def pursued_outcomes(
    systems: Sequence[PiecewiseLinear],
    pursued: Pursued,
    labels: np.ndarray,
    threads: int | None,
) -> np.ndarray:
    """Labels (n,) of motions of as many systems that were followed further.

    `labels` (n,) are those of the motions after that. Motions that these leave unclassified
    escape, or are classified by their largest exponents unless they come back, on an orbit that
    was not solved. `threads` None takes all processors.
    """
    found, motions = labels.copy(), pursued.motions
    found[pursued.escapes] = Outcome.DIVERGENT
    goes_on = (found == Outcome.UNCLASSIFIED) & (motions.status == Status.TRANSITIONS)
    places = np.flatnonzero(goes_on & ~pursued.undecided & (pursued.lengths == 0))
    if places.size:
        here, part = [systems[place] for place in places.tolist()], motions.at(places)
        scales = [scales_of(system, part.at([k]))[0] for k, system in enumerate(here)]
        measured = stretching(here[0].kernels, numbers_of(here), part, np.array(scales), threads)
        common = np.array([forcing_turns(system) is not None for system in here])
        value, error = measured.exponents, _CERTAIN * measured.errors
        found[places] = np.select(
            [np.isnan(value), value > error, ~common, value < -error],
            [Outcome.UNCLASSIFIED, Outcome.CHAOTIC, Outcome.INCOMMENSURATE, Outcome.UNCLASSIFIED],
            Outcome.QUASIPERIODIC,
        )
    return found


def labels_of_ends(motions: Trajectories) -> np.ndarray:
    """Outcomes (n,) of motions that could not be followed; UNCLASSIFIED for all others.

    They are ILLEGAL where nothing was simulated, and DIVERGENT where they grew until nothing can
    be computed. The last entry of the motions has to be kept.
    """
    labels = np.where(motions.status < 0, int(Outcome.ILLEGAL), int(Outcome.UNCLASSIFIED))
    ends = motions.states, motions.last_states[:, -1]
    small, before = ((np.abs(states) < LARGEST_STATE).all(axis=1) for states in ends)
    labels[(motions.status == Status.OVERFLOW) & ~small & before] = Outcome.DIVERGENT
    return labels


def _arrivals(motions: Trajectories, orbits: Sequence[Orbit]) -> np.ndarray:
    """Labels of motions by the stable orbits that they end on.

    A label is the index of a stable orbit, ILLEGAL, DIVERGENT, or UNCLASSIFIED. The last two
    entries of the motions have to be kept.
    """
    structure = motions.structure
    labels = labels_of_ends(motions)
    nearest = np.full(len(labels), _ARRIVED)
    for index, orbit in enumerate(orbits):
        if (
            orbit.stability.verdict not in ("stable", "undecided")
            or orbit.tables.cycle.uninterrupted
        ):
            continue
        scale, states = orbit_scale(orbit), orbit.tables.states_up_to_shift
        ends = up_to_shift(motions.last_states[:, -1], orbit.tables.translations)
        for phase, (name, _) in enumerate(orbit.itinerary):
            where = structure.configuration(name)
            before = orbit.tables.cycle.configurations[phase - 1]
            mask = mask_of(orbit.tables.cycle.transitions[phase - 1].boundaries)
            here = (
                (motions.last_configurations[:, -1] == where)
                & (motions.last_configurations[:, -2] == before)
                & (motions.last_sets[:, -1] == mask)
                & (motions.status == Status.TRANSITIONS)
            )
            with np.errstate(invalid="ignore"):
                distance = np.abs(ends - states[phase])
                miss = (distance / scale).max(axis=1)
            better = here & (miss < nearest)
            labels[better], nearest[better] = index, miss[better]
    return labels


def _quiet_outcomes(
    system: PiecewiseLinear,
    configuration: int,
    states: np.ndarray,
    response: Orbit | None,
    steady: int | None,
) -> np.ndarray:
    """Labels (n,) of motions that never leave a configuration, by the modes of its flow.

    They entered it in `states` (n, N). `response` is the response of the configuration to the
    forcing, and `steady` the label of the equilibrium or orbit in it, or None. A motion along a
    translation of the system alone does not grow: it drifts.
    """
    structure = system.structure
    forced = list(structure.forced)
    own = [state for state in range(states.shape[1]) if state not in forced]
    parts = parts_of(system, configuration, states)
    within = np.abs(up_to_shift(parts, translations_of(system))[:, :, own])
    parts = np.abs(parts[:, :, own])
    sizes = np.maximum(parts.max(axis=1), _NOTHING * parts.max(axis=(0, 1)))
    shifted, present = ((part > _NOTHING * sizes[:, None]).any(axis=2) for part in (parts, within))
    exponents = system.exponents[configuration]
    fastest = float(np.abs(exponents).max(initial=0.0))
    slow = _SLOW * fastest
    speeds = np.abs(system.forcing_speeds)
    moving, free, grows, drifts = np.zeros((4, len(states)), dtype=bool)
    for mode, (rate, frequency) in zip(structure.shapes[configuration], exponents, strict=True):
        if mode.joined and abs(rate) + frequency <= _ROUNDED * fastest:
            drifts |= shifted[:, list(mode.places)].any(axis=1)
            continue
        if rate < -slow:
            continue
        lowest = 2 if mode.oscillates else 1  # functions without a power of time
        places = list(mode.places)
        grows |= present[:, places if rate > slow else places[lowest:]].any(axis=1)
        drifts |= shifted[:, places[lowest:]].any(axis=1)
        if mode.oscillates:
            here = present[:, places[:lowest]].any(axis=1)
            moving |= here
            if not (np.abs(frequency - speeds) <= _EQUAL * speeds).any():
                free |= here
    staying = Outcome.UNCLASSIFIED
    if forcing_turns(system) is None:
        staying = Outcome.INCOMMENSURATE
    elif response is not None and not response.converged:
        normals = system.rows[list(structure.constraints[configuration])]
        rows = np.concatenate([system.fields[configuration][own], normals])[:, own]
        # singular where a part can rest at any position, as a mass that sticks
        if response.status == SINGULAR or np.linalg.cond(rows) >= 1 / _NOTHING:
            staying = Outcome.FAMILY
    labels = np.where(drifts, int(Outcome.DRIFTING), int(Outcome.RESTING))
    labels[moving] = staying
    if steady is not None:
        labels[:] = steady
    labels[free] = Outcome.FAMILY
    labels[grows] = Outcome.DIVERGENT
    return labels


class Settled(NamedTuple):
    """What motions (...) settle on."""

    # PERIODIC, UNINTERRUPTED (periodic without a transition), EQUILIBRIUM, or an `Outcome`
    outcomes: np.ndarray
    lengths: np.ndarray  # transitions in a period, 0 where there are none
    periods: np.ndarray  # NaN where the motion is not periodic


def settled(
    kernels: SystemKernels,
    parameters: Mapping[str, Any],
    motions: Trajectories,
    threads: int | None = None,
) -> Settled:
    """What motions (...) settle on, at parameters that broadcast to their shape.

    The result at a point depends on the motion there alone. Cycles of up to half of the entries
    that are kept are recognised. `threads` None takes all processors.
    """
    shape, count = motions.status.shape, motions.status.size
    points, given = parameter_points(kernels, parameters)
    places = np.broadcast_to(np.arange(len(points)).reshape(given), shape).ravel()
    flat = motions.reshaped(count)
    found = _returned(flat, flat.last_states)
    rest = np.flatnonzero(
        (found.outcomes == Outcome.UNCLASSIFIED)
        & ((flat.status == Status.TRANSITIONS) | (flat.status == Status.QUIET))
    )
    systems = [piecewise_at(kernels, points[place]) for place in places[rest]]
    first = _arrived(systems, flat.at(rest))
    _put(found, rest, first)
    goes_on = (first.outcomes == Outcome.UNCLASSIFIED) & (flat.status[rest] == Status.TRANSITIONS)
    going = rest[goes_on]
    if going.size:
        here = list(compress(systems, goes_on))
        pursued = pursue(here, flat.at(going), threads)
        later = _arrived(here, pursued.motions)
        back = (later.outcomes == Outcome.UNCLASSIFIED) & (pursued.lengths > 0)
        later.outcomes[back] = PERIODIC
        later.lengths[back], later.periods[back] = pursued.lengths[back], pursued.periods[back]
        told = pursued_outcomes(here, pursued, later.outcomes, threads)
        _put(found, going, later._replace(outcomes=told))
    return Settled(*(array.reshape(shape) for array in found))


def settled_texts() -> dict[int, str]:
    """The outcomes in words, by their numbers."""
    return {
        PERIODIC: "periodic",
        UNINTERRUPTED: "periodic without a transition",
        EQUILIBRIUM: "at an equilibrium",
        **{int(outcome): outcome.text for outcome in Outcome},
    }


def _put(found: Settled, places: np.ndarray, others: Settled) -> None:
    for array, other in zip(found, others, strict=True):
        array[places] = other


def _arrived(systems: Sequence[PiecewiseLinear], motions: Trajectories) -> Settled:
    """What motions (n,) of as many systems have settled on, up to translations."""
    found = _returned(motions, _up_to_shift(systems, motions.last_states))
    for place in np.flatnonzero(motions.status == Status.QUIET).tolist():
        attractors = attractors_of(systems[place], ())
        label = int(attractors.labels(motions.at([place]))[0])
        if label >= len(attractors.orbits):
            found.outcomes[place] = EQUILIBRIUM
        elif label >= 0:
            found.outcomes[place] = UNINTERRUPTED
            found.periods[place] = attractors.orbits[label].period
        else:
            found.outcomes[place] = label
    return found


def _returned(motions: Trajectories, states: np.ndarray) -> Settled:
    """The motions (n,) that came back, according to their states (n, k, N) at the entries."""
    seen = replace(motions, last_states=states)
    lengths = recurrent_lengths(
        seen, sizes_of(motions.structure, states, motions.last_times), _RETURN
    )
    lengths[motions.status != Status.TRANSITIONS] = 0
    times = motions.last_times
    before = np.take_along_axis(times, (times.shape[-1] - 1 - lengths)[:, None], axis=1)[:, 0]
    outcomes = labels_of_ends(motions)
    outcomes[lengths > 0] = PERIODIC
    return Settled(outcomes, lengths, np.where(lengths > 0, times[:, -1] - before, np.nan))
