"""Where motions lead: to an orbit or an equilibrium, or how else they end.

`attractors_of` compares many motions of one system with what was found, `settled` looks at one
motion at each of many parameter points.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from enum import IntEnum
from itertools import compress
from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.explore.finding.primitive import admissible, orbit_scale
from nonsmooth.runtime.explore.finding.steady import (
    Equilibrium,
    equilibria,
    forcing_turns,
    responses,
)
from nonsmooth.runtime.explore.finding.unsettled import (
    Pursued,
    Stretching,
    numbers_of,
    pursue,
    stretching,
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

_ARRIVED = 1e-3  # how near to an attractor a motion has to end, relative to its size
_NOTHING = 1e-9  # of a state's size: a part of a motion that is none
_SLOW = 1e-12  # rate of a motion that neither decays nor grows, in units of the fastest
_ROUNDED = 1e-7  # exponent that rounding makes of zero, beside a drift, in the same units
_EQUAL = 1e-9  # relative difference of a frequency from the forcing's
_CERTAIN = 3.0  # standard errors of an exponent
PERIODIC, UNINTERRUPTED, EQUILIBRIUM = 0, 1, 2  # beside the numbers of an Outcome
_RETURN = 1e-6  # in units of the largest size of a state on the cycle


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

    kernels: SystemKernels
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
        quiet = motions.status == Status.QUIET
        known = len(self.responses)  # one that was visited since stays unclassified
        quiet &= motions.configurations < known
        for configuration in np.unique(motions.configurations[quiet]).tolist():
            here = quiet & (motions.configurations == configuration)
            labels[here] = _quiet_outcomes(
                self.system,
                configuration,
                motions.states[here],
                self.responses[configuration],
                self._steady(configuration),
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
            pursued = pursue(self.kernels, systems, motions.at(places), threads)
            later = self.labels(pursued.motions)
            found[places] = pursued_outcomes(self.kernels, systems, pursued, later, threads)
        return found

    def _steady(self, configuration: int) -> int | None:
        """Label of the orbit or equilibrium that never leaves a configuration, or None."""
        name = self.system.structure.configurations[configuration]
        for place, orbit in enumerate(self.orbits):
            if orbit.tables.cycle.uninterrupted and orbit.itinerary[0][0] == name:
                return place
        for place, equilibrium in enumerate(self.equilibria):
            if equilibrium.configuration == name:
                return len(self.orbits) + place
        return None


def attractors_of(
    kernels: SystemKernels, system: PiecewiseLinear, orbits: Sequence[Orbit]
) -> Attractors:
    """Given orbits, converged and admissible, with the attractors within one configuration."""
    forced = responses(kernels, system)
    staying = [orbit for orbit in forced if orbit is not None and orbit.converged]
    known = [orbit for orbit in orbits if not orbit.tables.cycle.uninterrupted]
    return Attractors(
        kernels,
        system,
        (*known, *(orbit for orbit in staying if admissible(orbit))),
        tuple(equilibria(system)),
        tuple(forced),
    )


def pursued_outcomes(
    kernels: SystemKernels,
    systems: Sequence[PiecewiseLinear],
    pursued: Pursued,
    labels: np.ndarray,
    threads: int | None = None,
) -> np.ndarray:
    """Labels (n,) of motions of as many systems that were followed further.

    `labels` (n,) are those of the motions after that. Motions that these leave unclassified
    escape, or are classified by their largest exponents unless they come back, on an orbit that
    was not solved. `threads` None takes all processors.
    """
    found, motions = labels.copy(), pursued.motions
    found[pursued.escapes] = Outcome.DIVERGENT
    goes_on = (found == Outcome.UNCLASSIFIED) & (motions.status == Status.TRANSITIONS)
    places = np.flatnonzero(goes_on & ~pursued.undecided & (pursued.returns.lengths == 0))
    if places.size:
        here, part = [systems[place] for place in places.tolist()], motions.at(places)
        scales = [scales_of(system, part.at([k]))[0] for k, system in enumerate(here)]
        measured = stretching(kernels, numbers_of(here), part, np.array(scales), threads)
        common = np.array([forcing_turns(system) is not None for system in here])
        found[places] = _stretched_outcomes(measured, common)
    return found


def _stretched_outcomes(measured: Stretching, common: np.ndarray) -> np.ndarray:
    """Outcomes (n,) of motions that go on without a return, by their largest exponents.

    `common` (n,) marks those whose forcings have a common period.
    """
    value, error = measured.exponents, _CERTAIN * measured.errors
    regular = np.where(common, int(Outcome.QUASIPERIODIC), int(Outcome.INCOMMENSURATE))
    settling = np.where(common, int(Outcome.UNCLASSIFIED), int(Outcome.INCOMMENSURATE))
    found = np.where(value > error, int(Outcome.CHAOTIC), regular)
    found = np.where(value < -error, settling, found)
    found[np.isnan(value)] = Outcome.UNCLASSIFIED
    return found


def labels_of_ends(motions: Trajectories) -> np.ndarray:
    """Outcomes (n,) of motions that could not be followed; UNCLASSIFIED for all others.

    They are ILLEGAL where nothing was simulated, and DIVERGENT where they grew until nothing can
    be computed. The last entry of the motions has to be kept.
    """
    labels = np.where(motions.status < 0, int(Outcome.ILLEGAL), int(Outcome.UNCLASSIFIED))
    now, before = motions.states, motions.last_states[:, -1]
    small = [(np.abs(states) < LARGEST_STATE).all(axis=1) for states in (now, before)]
    labels[(motions.status == Status.OVERFLOW) & ~small[0] & small[1]] = Outcome.DIVERGENT
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
    elif response is not None and (
        response.status == SINGULAR
        or (not response.converged and _rests_anywhere(system, configuration, own))
    ):
        staying = Outcome.FAMILY
    labels = np.where(drifts, int(Outcome.DRIFTING), int(Outcome.RESTING))
    labels[moving] = staying
    if steady is not None:
        labels[:] = steady
    labels[free] = Outcome.FAMILY
    labels[grows] = Outcome.DIVERGENT
    return labels


def _rests_anywhere(system: PiecewiseLinear, configuration: int, own: list[int]) -> bool:
    """Whether a part can rest at any position in a configuration, as a mass that sticks."""
    normals = system.rows[list(system.structure.constraints[configuration])]
    rows = np.concatenate([system.fields[configuration][own], normals])[:, own]
    values = np.linalg.svd(rows, compute_uv=False)
    return bool(values[-1] <= _NOTHING * values[0])


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
    first = _arrived(kernels, systems, flat.at(rest))
    _put(found, rest, first)
    goes_on = (first.outcomes == Outcome.UNCLASSIFIED) & (flat.status[rest] == Status.TRANSITIONS)
    going = rest[goes_on]
    if going.size:
        here = list(compress(systems, goes_on))
        pursued = pursue(kernels, here, flat.at(going), threads)
        later = _arrived(kernels, here, pursued.motions)
        returns = pursued.returns
        back = (later.outcomes == Outcome.UNCLASSIFIED) & (returns.lengths > 0)
        later.outcomes[back] = PERIODIC
        later.lengths[back], later.periods[back] = returns.lengths[back], returns.periods[back]
        told = pursued_outcomes(kernels, here, pursued, later.outcomes, threads)
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


def _arrived(
    kernels: SystemKernels, systems: Sequence[PiecewiseLinear], motions: Trajectories
) -> Settled:
    """What motions (n,) of as many systems have settled on, up to translations."""
    states = motions.last_states.copy()
    for place, system in enumerate(systems):
        states[place] = up_to_shift(states[place], translations_of(system))
    found = _returned(motions, states)
    for place in np.flatnonzero(motions.status == Status.QUIET).tolist():
        attractors = attractors_of(kernels, systems[place], ())
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
