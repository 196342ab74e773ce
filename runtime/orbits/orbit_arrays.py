"""The record of the orbits of one itinerary at many parameter points."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.registry import Shown
from nonsmooth.runtime.orbits.admissible import NEITHER
from nonsmooth.runtime.shooting.newton import CONVERGED

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.problem import OrbitProblem

__all__ = ["TOO_SMALL", "Orbits", "changed", "reshaped", "restricted"]

TOO_SMALL = "{} is too small"  # a limit of admissibility, of an open parameter
_BY_POINT = (
    "unknowns", "trace", "period", "residual", "iterations", "status", "limit", "bounds",
    "multipliers", "margin", "starts",
)  # fmt: skip


@dataclass(frozen=True, eq=False, repr=False)
class Orbits(Shown):
    """Orbits at many parameter points; leading axes have the broadcast shape.

    Attributes
    ----------
    problem : OrbitProblem
        The itinerary and the kernels or tables that they were solved with.
    parameters : dict of str to array
        Those of the equations, not broadcast.
    unknowns : dict of str to array
        NaN, as all that follows, where no orbit was found. Nondimensional.
    trace, period, residual : array of float
    iterations, status : array of int
        `message` says what a status means: 0 converged.
    limit : array of int, or None
        Which of the `limits` of admissibility fails first, by its number from 0; -1 where none
        does, -2 where there is no orbit, -3 where it cannot be told. None when switched off.
    limits : tuple of str
        What each number of `limit` means.
    bounds : dict of str to array, or None
        What each open parameter has to exceed; NaN where no orbit is admissible.
    multipliers : array (..., k) of complex, or None
        Of the map on the section where the orbits start; None where not asked for.
    margin : array of float, or None
        1 less the largest absolute value of a nontrivial multiplier, 0 where neutral; NaN also
        where boundaries are reached together. None where multipliers are not asked for.
    starts : array (..., p, N) or None
        State at the start of each phase, where the solver has found them all.
    timed : bool
        Whether the period was given.
    derivatives : dict of str to dict of str to array (...), or None
        Of each unknown, the ``period`` and the ``trace``, by each parameter that was asked for;
        where multipliers are, also of ``determinant`` and ``spectral_radius``. NaN where there
        is none. None where not asked for.
    """

    problem: OrbitProblem
    parameters: dict[str, np.ndarray]
    unknowns: dict[str, np.ndarray]
    trace: np.ndarray
    period: np.ndarray
    residual: np.ndarray
    iterations: np.ndarray
    status: np.ndarray
    limit: np.ndarray | None = None
    limits: tuple[str, ...] = ()
    bounds: dict[str, np.ndarray] | None = None
    multipliers: np.ndarray | None = None
    margin: np.ndarray | None = None
    starts: np.ndarray | None = None
    timed: bool = False
    derivatives: dict[str, dict[str, np.ndarray]] | None = None

    @property
    def name(self) -> str:
        """Name of the orbit, or of its system and how many phases it has."""
        return self.problem.name

    @property
    def itinerary(self) -> tuple[tuple[str, str], ...]:
        """Configuration and boundary of each phase."""
        return self.problem.itinerary

    @property
    def converged(self) -> np.ndarray:
        """Where an orbit was found."""
        return np.asarray(self.status == CONVERGED)

    @property
    def admissible(self) -> np.ndarray | None:
        """Where the orbit is a motion of the real system; None when switched off.

        It is one for large enough open parameters where these are not given.
        """
        return None if self.limit is None else np.asarray(self.limit == NEITHER)

    @property
    def dwell_times(self) -> np.ndarray:
        """Duration (..., p) of each phase."""
        times = self.problem.dwell_times({**self.parameters, **self.unknowns})
        return np.stack(np.broadcast_arrays(*times, self.status)[:-1], axis=-1)

    def message(self, status: int) -> str:
        """Say what a status means and suggests.

        Parameters
        ----------
        status : int
            An entry of `status`.

        Returns
        -------
        str

        Raises
        ------
        InputError
            If no status is such a number.
        """
        try:
            return self.problem.message(status, timed=self.timed)
        except (KeyError, TypeError):
            raise InputError(f"{status!r} is no status") from None


def changed(change: Callable[..., np.ndarray], found: Orbits, *others: Orbits) -> Orbits:
    """Return orbits with all arrays by point changed, each together with those of other orbits."""

    def of(name: str) -> Any:
        parts = [getattr(each, name) for each in (found, *others)]
        if any(part is None for part in parts):
            return parts[0]
        if isinstance(parts[0], dict):
            return {key: change(*(part[key] for part in parts)) for key in parts[0]}
        return change(*parts)

    return replace(found, **{name: of(name) for name in _BY_POINT})


def reshaped(found: Orbits, shape: tuple[int, ...]) -> Orbits:
    """Return orbits whose arrays by point get a shape (...)."""
    lead = found.status.ndim
    return changed(lambda array: array.reshape((*shape, *array.shape[lead:])), found)


def restricted(found: Orbits, opened: Mapping[str, np.ndarray]) -> Orbits:
    """Return orbits where open parameters have values (...): admissible above their bounds."""
    limit, limits = found.limit, found.limits
    if limit is None or found.bounds is None:
        return found
    for name, values in opened.items():
        small = (limit == NEITHER) & ~(values > found.bounds[name])
        limit = np.where(small, len(limits), limit)
        limits = (*limits, TOO_SMALL.format(name))
    return replace(found, limit=limit, limits=limits)
