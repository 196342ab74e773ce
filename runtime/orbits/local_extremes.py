"""Local extremes of affine functions along an orbit, with derivatives."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from nonsmooth.runtime.core.complex_steps import real_parts
from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.simulation.extremes import local_maxima

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.motion_derivatives import OrbitMotionDerivatives, Row

__all__ = ["KINDS", "LocalExtreme", "local_extremes"]

# what has extremes, and the signs of those that count: 1 of maxima, -1 of minima
KINDS = {
    "maximum": (1,),
    "minimum": (-1,),
    "peak": (1, -1),
    "peak_acceleration": (1, -1),
    "peak_force": (1, -1),
}


class LocalExtreme(NamedTuple):
    """A local maximum of a function within a phase, or of minus the function."""

    phase: int  # counted from 0
    sign: int  # 1 for a maximum, -1 for a minimum
    value: float  # of the function times the sign
    rates: np.ndarray  # (q,), of that value
    time: float  # since the start of the orbit


def local_extremes(motion: OrbitMotionDerivatives, name: str) -> tuple[LocalExtreme, ...]:
    """Return the local extremes of a quantity along each phase and at its ends.

    The quantity is ``maximum:STATE``, ``minimum:STATE``, ``peak:STATE``,
    ``peak_acceleration:STATE`` or ``peak_force:CONTACT``; it is the largest of these
    extremes, of which the search misses none. They come by phases, maxima first, each in
    the order of time. `InputError` is raised for another name, and for an orbit with many
    digits.
    """
    kind, _, of = name.partition(":")
    if kind not in KINDS or not of:
        raise unknown_name("quantity with extremes", name, motion.names)
    if motion.lib is not None:
        raise InputError("local extremes are found in double precision only")
    row = motion.row_of(kind, of)
    found = []
    for phase, since, sign in _turns(motion, row):
        if sign in KINDS[kind]:
            at = motion.differentiated(row, phase, since)
            found.append(
                LocalExtreme(phase, sign, sign * float(at.value), sign * at.rates, float(at.time))
            )
    return tuple(sorted(found, key=lambda each: (each.phase, -each.sign, each.time)))


def _turns(motion: OrbitMotionDerivatives, row: Row) -> Iterator[tuple[int, float, int]]:
    """Yield phases, times since their start, and 1 for a local maximum there, -1 for a minimum."""
    phases, fields = motion._phases, real_parts(motion.numbers.fields[0]).astype(float)
    own = np.array([real_parts(row(c))[0].astype(float) for c in range(len(fields))])
    for found in local_maxima(motion._system, phases, np.stack([own, -own], axis=1)):
        yield found.phase, found.since, -1 if found.function else 1
    for phase, place in enumerate(phases.configurations.tolist()):
        slope = own[place, :-1] @ fields[place]
        starting, ending = (
            float(slope[:-1] @ state[phase] + slope[-1]) for state in (phases.starts, phases.ends)
        )
        yield phase, 0.0, -1 if starting > 0 else 1
        yield phase, float(phases.durations[phase]), 1 if ending > 0 else -1
