"""Orbits that a design has visited, each reached along a straight line on the same branch."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.values import as_value
from nonsmooth.runtime.explore.continuation.stepping import FAR, MOST_ITERATIONS, scaled_rows
from nonsmooth.runtime.explore.design.quantities import QuantityValues, measure
from nonsmooth.runtime.orbits.equations import OrbitEquations, equations_of
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.shooting.newton import CONVERGED

__all__ = [
    "Beyond",
    "DesignPoint",
    "DesignPoints",
]

_REFUSED = "the orbit is no motion of the real system beyond"
_UNDETERMINED = "the equations determine no orbit beyond (a grazing or a fold)"
_LEAST = 2.0**-10  # of a way: the shortest step
_TOLERANCE = 1e-9  # of the last step, which Newton's method squares
_ROUNDING = 1e-9  # of an unknown: a corrector this short is no leap
_SINGULAR = 0.05  # by which the smallest singular value has shrunk where a fold is near


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
    numbers: np.ndarray  # (n,), of its equations
    orbit: Orbit
    quantities: QuantityValues  # with derivatives by the parameters themselves

    @property
    def members(self) -> tuple[DesignPoint, ...]:
        """The orbit alone, as the orbits of a trial."""
        return (self,)


class DesignPoints:
    """The orbits of a branch at trial parameters, each reached from the nearest known one.

    The design begins at `orbit`; `names` with `bounds` (q, 2) are the parameters, `quantities`
    is what is measured, and `rough` are those that need no derivative. With `admissible` each
    orbit has to be a motion of the real system. The attribute `visited` lists the orbits in the
    order in which they were reached, the first one being `orbit`. `watching` is True where the
    optimiser has margins as conditions: it may then try orbits that are no motions. Raises
    `InputError` if the orbit cannot be followed, or is no motion where it has to be.
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
        self._follower = _BranchFollower(orbit, names)
        numbers = self._follower.first
        self.visited: list[DesignPoint] = []
        if admissible and not self._follower.admissible(numbers):
            raise InputError(
                f"{orbit.name} is no motion of the real system where the design begins"
            )
        measured = measure(orbit, self.names, self._quantities)
        place = self._place_of(self._follower.parameters(numbers))
        self._known: dict[bytes, DesignPoint] = {}
        self._places = np.empty((64, len(place)))
        self._keep(DesignPoint(place + 0.0, numbers, orbit, measured))

    @property
    def lengths(self) -> np.ndarray:
        """Lengths (q,) of the intervals of the parameters."""
        return np.asarray(self.bounds[:, 1] - self.bounds[:, 0])

    def at(self, place: np.ndarray) -> DesignPoint:
        """The orbit at a place (q,) in units of the bounds.

        Raises `Beyond` if the branch does not lead there.
        """
        place = place + 0.0  # one zero
        known = self._known.get(place.tobytes())
        if known is not None:
            return known
        gaps = np.abs(self._places[: len(self.visited)] - place).max(axis=1)
        near = self.visited[int(np.argmin(gaps))]
        inside = self.bounds[:, 0] + place * self.lengths
        target = np.where(place == 1, self.bounds[:, 1], inside)
        reached = self._follower.reach(near.numbers, target)
        if reached.reason:
            raise Beyond(near.place, place, reached.part * float(gaps.min()), reached.reason)
        judged = self._admissible and not self.watching  # else margins are conditions
        if judged and not self._follower.admissible(reached.numbers):
            raise Beyond(near.place, place, float(gaps.min()) / 2, _REFUSED)
        orbit = self._follower.orbit(reached.numbers)
        if orbit.status != CONVERGED:
            raise Beyond(near.place, place, float(gaps.min()) / 2, _UNDETERMINED)
        try:
            measured = measure(orbit, self.names, self._quantities)
        except InputError as problem:
            raise Beyond(near.place, place, float(gaps.min()) / 2, str(problem)) from None
        for name, slope in measured.slopes.items():
            if name not in self._rough and not np.isfinite(slope).all():
                raise Beyond(
                    near.place,
                    place,
                    float(gaps.min()) / 2,
                    f"{name} has no derivative at a corner",
                )
        found = DesignPoint(place.copy(), reached.numbers, orbit, measured)
        self._keep(found)
        if self._progress is not None:
            self._progress(len(self.visited))
        return found

    def _keep(self, found: DesignPoint) -> None:
        count = len(self.visited)
        if count == len(self._places):
            self._places = np.concatenate([self._places, np.empty_like(self._places)])
        self._places[count] = found.place
        self._known[found.place.tobytes()] = found
        self.visited.append(found)

    def is_motion(self, member: DesignPoint) -> bool:
        """Whether an orbit that was visited is a motion, or need not be one."""
        return not self._admissible or self._follower.admissible(member.numbers)

    def _place_of(self, values: np.ndarray) -> np.ndarray:
        return np.asarray((values - self.bounds[:, 0]) / self.lengths)


class _Reached(NamedTuple):
    """How far a straight line in the parameters was followed."""

    numbers: np.ndarray  # (n,), of the equations at the last orbit
    part: float  # of the line, 1 at its end
    reason: str  # why it ended early, empty at its end


class _BranchFollower:
    """Orbits of one itinerary over several parameters.

    The attribute `first` (n,) has all numbers of the equations at `orbit`. Refused is a
    parameter that was not given, or that the equations do not have.
    """

    def __init__(self, orbit: Orbit, names: Sequence[str]) -> None:
        equations: OrbitEquations = equations_of(orbit)
        parameters = {table.name for table in orbit.system.parameters}
        for name in names:
            if name not in equations.names and name in parameters:
                raise InputError(
                    f"no equation of {orbit.name} depends on {name}: only whether it is a motion"
                )
            if name not in orbit.given or name not in equations.names:
                known = [each for each in orbit.given if each in equations.names]
                raise unknown_name("given parameter", name, known)
        self._equations, self._given = equations, orbit.given
        self.names = tuple(names)
        self.first = equations.values.copy()
        self._places = [equations.names.index(name) for name in names]
        self._free = [equations.names.index(name) for name in equations.unknowns]
        self._sizes = np.asarray(equations.sizes, dtype=float)

    def parameters(self, numbers: np.ndarray) -> np.ndarray:
        """Values (q,) of the parameters that vary, from the numbers (n,) of an orbit."""
        return numbers[self._places]

    def reach(self, begin: np.ndarray, target: np.ndarray) -> _Reached:
        """The orbit continued from `begin` (n,) along a line to the parameters `target` (q,).

        Steps are shortened where they fail.
        """
        way = target - self.parameters(begin)
        here, part, step = begin, 0.0, 1.0
        reason = ""
        while part < 1:
            length = min(step, 1 - part)
            found = self._stepped(here, length * way)
            if isinstance(found, str):
                reason, step = found, step / 2
                if step < _LEAST:
                    return _Reached(here, part, reason)
                continue
            here, part, step = found, part + length, 2 * step
        here = here.copy()
        here[self._places] = target
        return _Reached(here, 1.0, "")

    def admissible(self, numbers: np.ndarray) -> bool:
        """Whether an orbit with the numbers (n,) is a motion of the real system."""
        return bool(self._equations.admissible(numbers[None])[0])

    def orbit(self, numbers: np.ndarray) -> Orbit:
        """The orbit with the numbers (n,), as a record."""
        values = zip(self.names, self.parameters(numbers).tolist(), strict=True)
        given = {name: as_value(value) for name, value in values}
        return self._equations.orbit_at(numbers, {**self._given, **given})

    def _linearised(self, numbers: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Left-hand sides, and derivatives by unknowns and by parameters, with scaled rows."""
        columns = []
        for place in self._places:
            residual, jacobian = self._equations.linearised(numbers, place)
            columns.append(jacobian[:, -1])
        free = jacobian[:, :-1] * self._sizes
        rows, units = scaled_rows(free)
        return residual / units, rows, np.stack(columns, axis=1) / units[:, None]

    def _stepped(self, here: np.ndarray, way: np.ndarray) -> np.ndarray | str:
        """The numbers of the orbit one step further, or the reason why there is none."""
        with np.errstate(all="ignore"):
            _, rows, columns = self._linearised(here)
            smallest = np.linalg.svd(rows, compute_uv=False)[-1]
            chord = np.linalg.lstsq(rows, -columns @ way, rcond=None)[0]
            guess = here.copy()
            guess[self._places] += way
            guess[self._free] += chord * self._sizes
            found, moved = guess, np.zeros(len(chord))
            for _ in range(MOST_ITERATIONS):
                residual, rows, _ = self._linearised(found)
                if not (np.isfinite(residual).all() and np.isfinite(rows).all()):
                    return "the orbit is lost"
                step = np.linalg.lstsq(rows, -residual, rcond=None)[0]
                found = found.copy()
                found[self._free] += step * self._sizes
                moved += step
                if float(np.abs(step).max()) <= _TOLERANCE:
                    break
            else:
                return self._lost(rows, smallest)
        for name, wait in zip(
            self._equations.dwell_names, self._equations.dwell(found[None])[0], strict=True
        ):
            if not wait > 0:
                return f"{name} goes to zero"
        if np.linalg.norm(moved) > FAR * np.linalg.norm(chord) + _ROUNDING:
            return self._lost(rows, smallest)
        return found

    def _lost(self, rows: np.ndarray, before: float) -> str:
        now = np.linalg.svd(rows, compute_uv=False)[-1]
        near = now < _SINGULAR * before or before < _SINGULAR * now or before < _SINGULAR**2
        return "the branch turns back (a fold)" if near else "the orbit is lost"
