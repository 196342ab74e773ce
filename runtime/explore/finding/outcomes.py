"""Where motions lead: to an orbit or an equilibrium that was found, or how else they end."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum

import numpy as np

from nonsmooth.runtime.explore.finding.primitive import admissible, orbit_scale
from nonsmooth.runtime.explore.finding.steady import (
    Equilibrium,
    equilibria,
    forcing_turns,
    responses,
)
from nonsmooth.runtime.explore.finding.stretching import Stretching, stretching
from nonsmooth.runtime.model.engine_run import Status
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.shooting.newton import SINGULAR
from nonsmooth.runtime.shooting.translations import translations_of, up_to_shift
from nonsmooth.runtime.simulation.recurrence import scales_of
from nonsmooth.runtime.simulation.simulate import Trajectories, simulate_many

__all__ = ["Attractors", "Outcome", "attractors_of", "quiet_outcomes", "stretched_outcomes"]

_ARRIVED = 1e-3  # how near to an attractor a motion has to end, relative to its size
_NOTHING = 1e-9  # of a state's size: a part of a motion that is none
_SLOW = 1e-12  # rate of a motion that neither decays nor grows, in units of the fastest
_EQUAL = 1e-9  # relative difference of a frequency from the forcing's
_ENDURING = 4096  # transitions for which chaos has to go on
_CERTAIN = 3.0  # standard errors of an exponent


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
    Outcome.FAMILY: "one of an undamped family",
    Outcome.INCOMMENSURATE: "quasi-periodic, as the forcings have no common period",
    Outcome.QUASIPERIODIC: "quasi-periodic",
    Outcome.CHAOTIC: "chaotic",
    Outcome.DIVERGENT: "divergent",
    Outcome.DRIFTING: "moves on steadily",
}


@dataclass(frozen=True, eq=False)
class Attractors:
    """What motions of a system may lead to.

    Attributes
    ----------
    kernels : SystemKernels
    system : PiecewiseLinear
    orbits : tuple of Orbit
        What the forcing makes of a configuration that is not left is among them.
    equilibria : tuple of Equilibrium
    responses : for each configuration a Orbit or None
        What the forcing makes of it, be it a motion of the system or not.
    """

    kernels: SystemKernels
    system: PiecewiseLinear
    orbits: tuple[Orbit, ...]
    equilibria: tuple[Equilibrium, ...]
    responses: tuple[Orbit | None, ...]

    def labels(self, motions: Trajectories) -> np.ndarray:
        """Where motions (n,) lead: the place of an orbit, then of an equilibrium, or an Outcome.

        Motions that go on from boundary to boundary without an orbit are UNCLASSIFIED. The last
        two entries of the motions have to be kept.
        """
        labels = _arrivals(motions, self.orbits)
        quiet = motions.status == Status.QUIET
        for configuration in np.unique(motions.configurations[quiet]).tolist():
            here = quiet & (motions.configurations == configuration)
            labels[here] = quiet_outcomes(
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
        """The same labels, where those that are not classified are told by their exponents.

        Chaos goes on: a motion that ends within many more transitions is labelled by its end.
        """
        places = np.flatnonzero(
            (labels == Outcome.UNCLASSIFIED) & (motions.status == Status.TRANSITIONS)
        )
        found = labels.copy()
        values = {name: float(value) for name, value in self.system.parameters.items()}
        if places.size:
            part = motions.at(places)
            scales = scales_of(self.system, part)
            common = forcing_turns(self.system) is not None
            found[places] = stretched_outcomes(
                stretching(self.kernels, values, part, scales, threads),
                np.full(len(places), common),
            )
        chaotic = np.flatnonzero(found == Outcome.CHAOTIC)
        if chaotic.size:
            longer = simulate_many(
                self.kernels,
                values,
                motions.last_states[chaotic, -1],
                motions.last_configurations[chaotic, -1],
                transitions=_ENDURING,
                keep=2,
                threads=threads,
            )
            ended = longer.status != Status.TRANSITIONS
            found[chaotic[ended]] = self.labels(longer)[ended]
        return found

    def _steady(self, configuration: int) -> int | None:
        """Label of what stays in a configuration for ever."""
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
    """Orbits that were found, with what stays in one configuration."""
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


def stretched_outcomes(measured: Stretching, common: np.ndarray) -> np.ndarray:
    """Outcomes (n,) of motions that go on and do not come back, by their largest exponents.

    Parameters
    ----------
    common : array (n,) of bool
        Whether the forcings have a common period.
    """
    value, error = measured.exponents, _CERTAIN * measured.errors
    regular = np.where(common, int(Outcome.QUASIPERIODIC), int(Outcome.INCOMMENSURATE))
    settling = np.where(common, int(Outcome.UNCLASSIFIED), int(Outcome.INCOMMENSURATE))
    found = np.where(value > error, int(Outcome.CHAOTIC), regular)
    found = np.where(value < -error, settling, found)
    found[np.isnan(value)] = Outcome.UNCLASSIFIED
    found[measured.grows] = Outcome.DIVERGENT
    return found


def _arrivals(motions: Trajectories, orbits: Sequence[Orbit]) -> np.ndarray:
    """Where each motion ended that goes on from boundary to boundary, or was not simulated.

    An index of a stable orbit, ILLEGAL, DIVERGENT, or UNCLASSIFIED. The last two entries of the
    motions have to be kept.
    """
    structure = motions.structure
    labels = np.full(len(motions.times), int(Outcome.UNCLASSIFIED))
    labels[motions.status < 0] = Outcome.ILLEGAL
    labels[motions.status == Status.OVERFLOW] = Outcome.DIVERGENT
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
            mask = sum(1 << b for b in orbit.tables.cycle.transitions[phase - 1].boundaries)
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


def quiet_outcomes(
    system: PiecewiseLinear,
    configuration: int,
    states: np.ndarray,
    response: Orbit | None,
    steady: int | None,
) -> np.ndarray:
    """How motions go on that do not leave a configuration any more, by the modes of its flow.

    What moves along a translation of the system alone does not grow: it drifts.

    Parameters
    ----------
    states : array (n, N)
        In which they entered it.
    response : Orbit or None
        What the forcing makes of the configuration.
    steady : int or None
        Label of the equilibrium or orbit in it, where one is listed.
    """
    structure = system.structure
    forced = [state for pair in structure.forcing for state in pair]
    own = [state for state in range(states.shape[1]) if state not in forced]
    extended = np.concatenate([states, np.ones((len(states), 1))], axis=1)
    parts = np.einsum("fij,nj->nfi", system.flows[configuration], extended)
    within = np.abs(up_to_shift(parts, translations_of(system))[:, :, own])
    parts = np.abs(parts[:, :, own])
    sizes = np.maximum(parts.max(axis=1), _NOTHING * parts.max(axis=(0, 1)))
    shifted, present = ((part > _NOTHING * sizes[:, None]).any(axis=2) for part in (parts, within))
    exponents = system.exponents[configuration]
    slow = _SLOW * float(np.abs(exponents).max(initial=0.0))
    speeds = np.abs([system.fields[0, s, c] for c, s in structure.forcing])
    moving, free, grows, drifts = np.zeros((4, len(states)), dtype=bool)
    for mode, (rate, frequency) in zip(structure.shapes[configuration], exponents, strict=True):
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
    elif response is not None and response.status == SINGULAR:
        staying = Outcome.FAMILY
    labels = np.where(drifts, int(Outcome.DRIFTING), int(Outcome.RESTING))
    labels[moving] = staying
    if steady is not None:
        labels[:] = steady
    labels[free] = Outcome.FAMILY
    labels[grows] = Outcome.DIVERGENT
    return labels
