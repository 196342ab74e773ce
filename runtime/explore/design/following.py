"""The orbit at other parameters, reached along a straight line, on the same branch."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.values import as_value
from nonsmooth.runtime.explore.continuation.stepping import FAR, MOST_ITERATIONS, scaled_rows
from nonsmooth.runtime.orbits.equations import OrbitEquations, equations_of
from nonsmooth.runtime.orbits.orbit import Orbit

__all__ = ["BranchFollower", "Reached"]

_LEAST = 2.0**-10  # of a way: the shortest step
_TOLERANCE = 1e-9  # of the last step, which Newton's method squares
_ROUNDING = 1e-9  # of an unknown: a corrector this short is no leap
_SINGULAR = 0.05  # by which the smallest singular value has shrunk where a fold is near


class Reached(NamedTuple):
    """How far a straight line in the parameters was followed."""

    numbers: np.ndarray  # (n,), of the equations at the last orbit
    part: float  # of the line, 1 at its end
    reason: str  # why it ended early, empty at its end


class BranchFollower:
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

    def reach(self, begin: np.ndarray, target: np.ndarray) -> Reached:
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
                    return Reached(here, part, reason)
                continue
            here, part, step = found, part + length, 2 * step
        here = here.copy()
        here[self._places] = target
        return Reached(here, 1.0, "")

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
