"""Motions that come back with the forcing, as a stroboscope sees them.

No matter by how many transitions: where impacts follow each other ever faster, until a mass
rests at its stop, no cycle of transitions is short, nor the same in every period.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.explore.finding.escape import numbers_of
from nonsmooth.runtime.explore.finding.steady import forcing_turns
from nonsmooth.runtime.model.engine_run import Status
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.shooting.translations import translations_of, up_to_shift
from nonsmooth.runtime.simulation.engines import Trajectories
from nonsmooth.runtime.simulation.recurrence import sizes_of
from nonsmooth.runtime.simulation.simulate import simulate_many

__all__ = ["Returns", "stroboscopic_returns"]

_FLASHES = 12  # the longest motion that comes back, in common periods of the forcings
_MOST = 2048  # transitions from one flash to the next
_ASIDE = 0.3819660112501051  # of a period, from the last transition to the first flash
_RETURN = 1e-6  # in units of the largest size of a state


class Returns(NamedTuple):
    """Transitions (n,) in a period, and periods; 0 and NaN where a motion does not come back."""

    lengths: np.ndarray
    periods: np.ndarray


def stroboscopic_returns(
    kernels: SystemKernels,
    systems: Sequence[PiecewiseLinear],
    motions: Trajectories,
    threads: int | None = None,
) -> Returns:
    """Returns of motions (n,) of as many systems after some periods of the forcing.

    The last entries of the motions have to be kept. `threads` None takes all processors.
    """
    values, periods = numbers_of(systems).items(), np.array([_period(each) for each in systems])
    directions = [translations_of(system) for system in systems]
    sizes = sizes_of(motions.structure, motions.last_states, motions.last_times)
    found = Returns(np.zeros(len(systems), dtype=int), np.full(len(systems), np.nan))
    going = np.flatnonzero((motions.status == Status.TRANSITIONS) & np.isfinite(periods))
    states = motions.last_states[going, -1]
    configurations = motions.last_configurations[going, -1]
    passed = np.zeros(len(systems), dtype=int)
    first: Trajectories | None = None
    for flash in range(_FLASHES + 1):
        if not going.size:
            break
        now = simulate_many(
            kernels,
            {n: np.asarray(value)[going] if np.ndim(value) else value for n, value in values},
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
            found.periods[going[back]] = flash * periods[going[back]]
            found.lengths[going[back]] = passed[going[back]]
            stays &= ~back
        going, first = going[stays], first.at(stays)
        states, configurations = now.states[stays], now.configurations[stays]
    return found


def _period(system: PiecewiseLinear) -> float:
    """Common period of all forcings; NaN without one."""
    turns = forcing_turns(system)
    if not turns:
        return float("nan")
    cosine, sine = system.structure.forcing[0]
    return 2 * np.pi * turns[0] / abs(float(system.fields[0, sine, cosine]))
