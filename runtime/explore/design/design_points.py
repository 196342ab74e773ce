"""Orbits that a design has visited, each reached along a straight line on the same branch."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from nonsmooth.runtime.core.errors import InputError, NoConvergence, unknown_name
from nonsmooth.runtime.explore.design.quantities import QuantityValues, measure
from nonsmooth.runtime.orbits.equations import OrbitEquations, equations_of
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.orbit_function import steps_to

__all__ = [
    "Beyond",
    "DesignPoint",
    "DesignPoints",
]

_REFUSED = "the orbit is no motion of the real system beyond"


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
        self.visited: list[DesignPoint] = []
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
        if admissible and not _is_motion(equations):
            raise InputError(
                f"{orbit.name} is no motion of the real system where the design begins"
            )
        measured = measure(equations.orbit.derivatives(self.names), self._quantities)
        given = np.array([float(orbit.given[name]) for name in names])
        place = (given - self.bounds[:, 0]) / self.lengths
        self._known: dict[bytes, DesignPoint] = {}
        self._places = np.empty((64, len(place)))
        self._keep(DesignPoint(place + 0.0, orbit, measured))

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
        part = 0.0
        try:
            for reached in steps_to(near.quantities.derivatives, target):
                part, derivatives = reached
        except (InputError, NoConvergence, ArithmeticError) as problem:
            raise Beyond(near.place, place, part * float(gaps.min()), str(problem)) from None
        judged = self._admissible and not self.watching  # else margins are conditions
        if judged and not _is_motion(equations_of(derivatives.orbit)):
            raise Beyond(near.place, place, float(gaps.min()) / 2, _REFUSED)
        try:
            measured = measure(derivatives, self._quantities)
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
        found = DesignPoint(place.copy(), derivatives.orbit, measured)
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
        return not self._admissible or _is_motion(equations_of(member.orbit))


def _is_motion(equations: OrbitEquations) -> bool:
    """Whether an orbit with its equations is a motion of the real system."""
    return bool(equations.admissible(equations.values[None])[0])
