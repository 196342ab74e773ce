"""Local extremes of affine functions along an orbit, with derivatives."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from nonsmooth.runtime.core.complex_steps import real_parts
from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.simulation.phase_functions import panels, values_at

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

_ANGLE = 0.3  # radians of the fastest oscillation between two looks at the slope
_SAME = 1e-9  # of a value: the guaranteed extreme is among those that were seen


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
    extremes. That one is found by the guaranteed search, the others where the slope
    changes its sign between looks at it. They come by phases, maxima first, each in the
    order of time. `InputError` is raised for another name, and for an orbit with many
    digits.
    """
    kind, _, of = name.partition(":")
    if kind not in KINDS or not of:
        raise unknown_name("quantity with extremes", name, motion.names)
    if motion.lib is not None:
        raise InputError("local extremes are found in double precision only")
    row = motion.row_of(kind, of)
    places = _turns(motion, row)
    found = []
    for sign in KINDS[kind]:
        mine = [_extreme(motion, row, *turn[:2], sign) for turn in places if turn[2] == sign]
        top = motion.largest(row, sign)
        value = sign * float(top.value)
        if not any(each.value >= value - _SAME * abs(value) for each in mine):
            phase = int(np.searchsorted(motion.begins.astype(float), top.time, side="right")) - 1
            phase = min(max(phase, 0), len(motion.dwell) - 1)
            mine.append(LocalExtreme(phase, sign, value, sign * top.rates, float(top.time)))
        found.extend(mine)
    return tuple(sorted(found, key=lambda each: (each.phase, -each.sign, each.time)))


def _extreme(
    motion: OrbitMotionDerivatives, row: Row, phase: int, since: float, sign: int
) -> LocalExtreme:
    there = motion.differentiated(row, phase, since)
    return LocalExtreme(
        phase, sign, sign * float(there.value), sign * there.rates, float(there.time)
    )


def _turns(motion: OrbitMotionDerivatives, row: Row) -> list[tuple[int, float, int]]:
    """Return phases, times since their start, and 1 where the slope turns negative, -1 positive."""
    system, phases = motion._system, motion._phases
    fields = real_parts(motion.numbers.fields[0]).astype(float)
    own = np.array([real_parts(row(c))[0].astype(float) for c in range(len(fields))])
    slopes = np.einsum("cn,cnm->cm", own[:, :-1], fields)
    found: list[tuple[int, float, int]] = []
    for piece in panels(system, phases, slopes[:, None], _ANGLE):
        ends = values_at(system, piece, np.stack([piece.left, piece.right], axis=1))[..., 0]
        for phase, left, right, (before, after), last in zip(
            piece.phases.tolist(),
            piece.left.tolist(),
            piece.right.tolist(),
            ends.tolist(),
            piece.last.tolist(),
            strict=True,
        ):
            if left == 0:
                found.append((phase, left, -1 if before > 0 else 1))
            if before * after < 0:
                part = before / (before - after)
                found.append((phase, left + part * (right - left), 1 if before > 0 else -1))
            elif before == 0 != after and left > 0:
                found.append((phase, left, -1 if after > 0 else 1))
            if last:
                found.append((phase, right, 1 if after > 0 else -1))
    return found
