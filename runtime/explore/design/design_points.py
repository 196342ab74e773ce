"""Orbits that a design has visited, each reached along a straight line on the same branch."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.explore.continuation.stepping import FAR, correct, scaled_rows
from nonsmooth.runtime.explore.design.quantities import QuantityValues, measure
from nonsmooth.runtime.orbits.equations import OrbitEquations, equations_of
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.shooting.newton import CONVERGED

_REFUSED = "the orbit is no motion of the real system beyond"
_UNDETERMINED = "the equations determine no orbit beyond (a grazing or a fold)"
_LEAST = 2.0**-10  # of a way: the shortest step
_ROUNDING = 1e-9  # of an unknown: a corrector this short is no leap
_SHORT = 0.1  # of a period: a dwell time that falls from less goes to zero where a branch is steep
_STEEP = 5.0  # change of the unknowns over that of the parameters where a fold is near


class Beyond(Exception):
    """Raised for a trial without an orbit of the branch; a shorter step is tried then.

    It has the places (q,) `near`, from which the trial was approached, and `target`, of the
    trial; `distance`, how far the branch goes that way in units of the bounds; and `reason`.
    """

    def __init__(self, near: np.ndarray, target: np.ndarray, distance: float, reason: str) -> None:
        super().__init__(reason)
        self.near, self.target = near, target
        self.distance, self.reason = distance, reason


@dataclass(frozen=True, eq=False)
class DesignPoint:
    """One orbit that was visited."""

    place: np.ndarray  # (q,), of its parameters in their bounds: 0 is the lower one, 1 the upper
    z: np.ndarray  # (n + q,), its unknowns and parameters
    orbit: Orbit
    quantities: QuantityValues  # with derivatives by the parameters themselves


class WorstPlace(NamedTuple):
    """A place along a branch where something is worst."""

    part: float  # position in the branch's interval, from 0 to 1
    row: int  # number of the alarm that has a minimum there
    bend: float  # its second derivative inside the interval, 0 where the place is fixed


@dataclass(frozen=True, eq=False)
class Trial:
    """Parameters that were tried, and the orbit there, or several orbits of its branch."""

    place: np.ndarray  # (q,), of the parameters in their bounds: 0 is the lower one, 1 the upper
    members: tuple[DesignPoint, ...]
    watches: tuple[WorstPlace, ...] = ()  # places that are followed along a branch


class DesignPoints:
    """The orbits of a branch at trial parameters, each reached from the nearest known one.

    The design begins at `orbit`; `names` with `bounds` (q, 2) are the parameters, `quantities`
    is what is measured, and `rough` are those that need no derivative. With `admissible` each
    orbit has to be a motion of the real system. `watching` is True where the optimiser has margins
    as conditions: it may then try orbits that are no motions. Raises `InputError` if the orbit
    cannot be followed, or is no motion where it has to be.
    """

    def __init__(
        self,
        orbit: Orbit,
        names: Sequence[str],
        bounds: np.ndarray,
        quantities: Sequence[str],
        *,
        rough: Sequence[str] = (),
        admissible: bool = True,
        progress: Callable[[int], object] | None = None,
    ) -> None:
        self.names, self.bounds = tuple(names), bounds
        self._rough, self._progress = frozenset(rough), progress
        self.watching = False
        self._quantities, self._admissible = tuple(quantities), admissible
        self._curve = equations_of(orbit, *names, lengths=self.lengths)
        z = self._curve.first
        if not self.allowed(z):
            raise InputError(
                f"{orbit.name} is no motion of the real system where the design begins"
            )
        measured = measure(orbit, self.names, self._quantities)
        place = (z[len(self._curve.unknowns) :] - bounds[:, 0]) / self.lengths
        begin = DesignPoint(place + 0.0, z, orbit, measured)
        self._known = {begin.place.tobytes(): begin}

    @property
    def lengths(self) -> np.ndarray:
        """Lengths (q,) of the intervals of the parameters."""
        return np.asarray(self.bounds[:, 1] - self.bounds[:, 0])

    @property
    def visited(self) -> list[DesignPoint]:
        """The orbits in the order in which they were reached."""
        return [*self._known.values()]

    def at(self, place: np.ndarray) -> DesignPoint:
        """The orbit at a place (q,) in units of the bounds.

        It is continued along a straight line; steps are shortened where they fail. Raises `Beyond`
        if the branch does not lead there.
        """
        place = place + 0.0  # one zero
        known = self._known.get(place.tobytes())
        if known is not None:
            return known
        places = np.frombuffer(b"".join(self._known)).reshape(-1, len(place))
        gaps = np.abs(places - place).max(axis=1)
        near, gap = self.visited[int(np.argmin(gaps))], float(gaps.min())
        inside = self.bounds[:, 0] + place * self.lengths
        target = np.where(place == 1, self.bounds[:, 1], inside)
        z, count = near.z, len(self._curve.unknowns)
        way, part, step = target - z[count:], 0.0, 1.0
        while part < 1:
            length = min(step, 1 - part)
            found = _stepped(self._curve, z, length * way)
            if not isinstance(found, str):
                z, part, step = found, part + length, 2 * step
                continue
            step /= 2
            if step < _LEAST:
                raise Beyond(near.place, place, part * gap, found)
        z[count:] = target
        try:
            reached = DesignPoint(place.copy(), z, *self._measured(z))
        except InputError as problem:
            raise Beyond(near.place, place, gap / 2, str(problem)) from None
        self._known[place.tobytes()] = reached
        if self._progress is not None:
            self._progress(len(self._known))
        return reached

    def _measured(self, z: np.ndarray) -> tuple[Orbit, QuantityValues]:
        """The orbit at a point (n + q,) and its quantities; `InputError` says what it lacks."""
        if not self.watching and not self.allowed(z):  # else margins are conditions
            raise InputError(_REFUSED)
        orbit = self._curve.at(z)
        if orbit.status != CONVERGED:
            raise InputError(_UNDETERMINED)
        measured = measure(orbit, self.names, self._quantities)
        for name, slope in measured.slopes.items():
            if name not in self._rough and not np.isfinite(slope).all():
                raise InputError(f"{name} has no derivative at a corner")
        return orbit, measured

    def allowed(self, z: np.ndarray) -> bool:
        """Whether an orbit (n + q,) is a motion, or need not be one."""
        return not self._admissible or bool(self._curve.admissible(z[None])[0])


def _stepped(curve: OrbitEquations, here: np.ndarray, way: np.ndarray) -> np.ndarray | str:
    """The orbit (n + q,) one step further, or the reason why there is none."""
    count = len(curve.unknowns)
    with np.errstate(all="ignore"):
        rows = scaled_rows(curve.equations(here)[1] * curve.sizes)[0]
        shift = way / curve.sizes[count:]
        chord = np.linalg.lstsq(rows[:, :count], -rows[:, count:] @ shift, rcond=None)[0]
        guess = here + np.append(chord, shift) * curve.sizes
        found = correct(curve, guess, np.eye(len(here))[count:])
    if found is None:
        return _lost(curve, here, chord, shift)
    z, _ = found
    for name, wait in zip(curve.dwell_names, curve.dwell(z[None])[0], strict=True):
        if not wait > 0:
            return f"{name} goes to zero"
    if np.linalg.norm((z - guess) / curve.sizes) > FAR * np.linalg.norm(chord) + _ROUNDING:
        return _lost(curve, here, chord, shift)
    return z


def _lost(curve: OrbitEquations, here: np.ndarray, chord: np.ndarray, shift: np.ndarray) -> str:
    """Why there is no orbit a step further: both causes of a steep branch change it alike at first.

    At a fold the unknowns change as the root of what is left of the way, and so does a dwell
    time that vanishes at a grazing, but this one is small there.
    """
    if np.linalg.norm(chord) <= _STEEP * np.linalg.norm(shift):
        return "the orbit is lost"
    ahead = here + np.append(chord, shift) * curve.sizes
    before, after = curve.dwell(np.stack([here, ahead]))
    vanishing = (after < before) & (before < _SHORT * before.sum())
    if vanishing.any():
        return f"{curve.dwell_names[int(np.argmax(vanishing))]} goes to zero"
    return "the branch turns back (a fold)"
