"""The records of a periodic orbit, and of the orbits of one itinerary at many points."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.arithmetic import Mpmath
from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.registry import Kept, Shown, registered
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.kernels import OrbitKernels, SystemKernels
from nonsmooth.runtime.orbits.admissible import NEITHER, Admissibility
from nonsmooth.runtime.orbits.motion import Motion, orbit_motion
from nonsmooth.runtime.shooting.multipliers import Stability
from nonsmooth.runtime.shooting.newton import CONVERGED, DOUBLE
from nonsmooth.runtime.shooting.symmetry import Symmetry
from nonsmooth.runtime.simulation.simulate import checked_count
from nonsmooth.runtime.simulation.trajectory import Trajectory

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.derivatives import OrbitDerivatives
    from nonsmooth.runtime.orbits.problem import Evaluation, OrbitProblem

__all__ = [
    "DOUBLE",
    "GUARD",
    "PERIOD",
    "TOO_SMALL",
    "Orbit",
    "Orbits",
    "changed",
    "check_converged",
    "kernel_arguments",
    "reshaped",
    "restricted",
]

GUARD = 15  # decimal digits carried beyond those asked for
PERIOD = "period"  # under which name it is given
TOO_SMALL = "{} is too small"  # a limit of admissibility, of an open parameter
_BY_POINT = (
    "unknowns", "trace", "period", "residual", "iterations", "status", "limit", "bounds",
    "multipliers", "margin", "starts",
)  # fmt: skip


@dataclass(frozen=True, repr=False)
class Orbit(Kept):
    """A periodic orbit of an itinerary, or what a solver reached when it found none.

    Attributes
    ----------
    problem : OrbitProblem
        The itinerary and the kernels or tables that it was solved with.
    given : dict of str to Value
        What was given, exactly: parameters, unknowns that were exchanged for them, and the
        ``period`` where it singles out one of a family.
    unknowns : dict of str to number
        What was solved for; floats, or mpmath numbers after `refine`. Nondimensional, or in
        the units of the declaration.
    opened : dict of str to Value
        Parameters that only admissibility depends on, as far as they are given.
    residual : number
        Largest absolute value of the equations' left-hand sides.
    digits : int
        Error of each unknown x is at most ``10^-digits max(1, |x|)``.
    iterations : int
    status : int
        A number of `nonsmooth.runtime.shooting.newton`: 0 converged; `message` says what to
        do next.
    starts : array (p, N) or None
        State at the start of each phase, where the solver has found them all.
    """

    _kept_by = "save_orbit"

    problem: OrbitProblem
    given: Mapping[str, Value]
    unknowns: Mapping[str, Any]
    opened: Mapping[str, Value]
    residual: Any
    digits: int
    iterations: int
    status: int
    starts: np.ndarray | None = field(default=None, repr=False, compare=False)

    @property
    def name(self) -> str:
        """Name of the orbit, or of its system and how many phases it has."""
        return self.problem.name

    @property
    def system(self) -> SystemKernels:
        """Tables and kernels of the system."""
        return self.problem.system

    @property
    def kernels(self) -> OrbitKernels:
        """Kernels of the orbit's own equations.

        Raises
        ------
        InputError
            If there are none: it was solved with the tables of its system.
        """
        kernels = self.problem.kernels
        if kernels is None:
            raise InputError(f"{self.name} has no kernels: it is composed from its phases")
        return kernels

    @property
    def itinerary(self) -> tuple[tuple[str, str], ...]:
        """Configuration and boundary of each phase; boundaries reached together are ``a+b``."""
        return self.problem.itinerary

    @property
    def symmetry(self) -> Symmetry | None:
        """What closes the first part of the orbit, where it was solved for by that part."""
        return self.problem.symmetry

    @property
    def state_names(self) -> tuple[str, ...]:
        """Names of the states, in the coordinates of the equations."""
        return self.problem.state_names

    @property
    def dwell_time_names(self) -> tuple[str, ...]:
        """Name of each phase's dwell time."""
        return self.problem.dwell_time_names

    @property
    def converged(self) -> bool:
        """Whether this is an orbit, and determined by its equations."""
        return self.status == CONVERGED

    @property
    def message(self) -> str:
        """What the status means and suggests."""
        return self.problem.message(self.status, timed=PERIOD in self.given)

    @cached_property
    def precise(self) -> bool:
        """Whether the numbers are mpmath's, as after `refine`."""
        return not all(isinstance(x, float) for x in self.unknowns.values())

    @cached_property
    def arithmetic(self) -> Mpmath:
        """Mpmath at the orbit's digits and some guard digits."""
        return Mpmath(max(self.digits, DOUBLE) + GUARD)

    @cached_property
    def values(self) -> dict[str, Any]:
        """Numbers of all parameters of the equations and of all unknowns."""
        given = {
            name: self.arithmetic.number(value) if self.precise else float(value)
            for name, value in self.given.items()
        }
        return {**given, **self.unknowns}

    @property
    def kernel_point(self) -> tuple[np.ndarray, np.ndarray]:
        """Parameters (1, p) and unknowns (1, n) as the kernels take them, in double precision."""
        kernels, values = self.kernels, self.values
        parameters, unknowns = (
            np.array([[float(values[name]) for name in names]])
            for names in (kernels.parameter_names, kernels.unknowns)
        )
        return parameters, unknowns

    @property
    def parameters(self) -> dict[str, Any]:
        """All parameters of the equations: exactly as given, or the number solved for."""
        known = {**self.unknowns, **self.given}
        return {table.name: known[table.name] for table in self.problem.parameters}

    @property
    def given_period(self) -> Value | None:
        """What the dwell times had to sum up to, where that was given."""
        return self.given.get(PERIOD)

    @cached_property
    def dwell_times(self) -> np.ndarray:
        """Duration (p,) of each phase: floats, or mpmath numbers."""
        unknown = all(name in self.unknowns for name in self.dwell_time_names)
        times = self.problem.dwell_times(self.unknowns if unknown else self.values)
        return np.array(times, dtype=object if self.precise else float)

    @property
    def period(self) -> Any:
        """Sum of the dwell times."""
        total = self.dwell_times.sum()
        return total if self.precise else float(total)

    @cached_property
    def evaluation(self) -> Evaluation:
        """What the equations tell at this orbit."""
        return self.problem.evaluation(self)

    @property
    def tables(self) -> Evaluation:
        """What the tables of the system tell at this orbit: passage, cycle, translations, ....

        Raises
        ------
        InputError
            If it was solved with kernels of its own.
        """
        return self.evaluation.tables

    @property
    def states(self) -> np.ndarray:
        """State (p, N) at the start of each phase, behind the transition before it.

        Floats or mpmath numbers; in the coordinates of the equations.
        """
        return self.evaluation.states

    @property
    def stability(self) -> Stability:
        """Multipliers, trace and verdict.

        Where boundaries are reached together the multipliers are those of motions that go on
        doing so, and the verdict is "undecided".

        Raises
        ------
        InputError
            If there is no orbit.
        """
        return self.evaluation.stability

    @property
    def part_stability(self) -> Stability:
        """Multipliers of the map over one part, followed by the symmetry that closes it.

        The orbit's are their powers, squares where the symmetry is of order two; at -1 a pair
        of orbits without the symmetry branches off.

        Raises
        ------
        InputError
            If there is no orbit, or it was not solved for by a part.
        """
        return self.evaluation.part_stability

    @property
    def admissibility(self) -> Admissibility:
        """Whether the orbit is a motion of the real system; in double precision.

        Raises
        ------
        InputError
            If there is no orbit, or a phase lasts too long for a guarantee.
        """
        return self.evaluation.admissibility

    @property
    def multipliers(self) -> np.ndarray:
        """Multipliers of the map on the section where the orbit starts (complex, or mpmath's)."""
        found = self.stability.multipliers
        number = self.arithmetic.mp.mpc if self.precise else complex
        kind = object if self.precise else complex
        return np.array([number(m.real, m.imaginary) for m in found], dtype=kind)

    @property
    def trace(self) -> Any:
        """Trace of the Poincare map's Jacobian."""
        return self.stability.trace

    @property
    def poincare_jacobian(self) -> np.ndarray:
        """Derivative of the Poincare map by the start.

        With kernels in the section's own coordinates. With tables (N, N) in all of them: both
        times are those of the transition, it maps onto the tangent space of the section and has
        a multiplier zero for each dimension that the section lacks.
        """
        return self.evaluation.poincare_jacobian

    @property
    def saltations(self) -> np.ndarray:
        """Saltation matrix (p, N, N) of each transition (Sec. 4).

        A perturbation in front of the transition, times the matrix, is that behind it, to
        first order at the same time.
        """
        return self.evaluation.saltations

    @property
    def monodromy(self) -> np.ndarray:
        """Monodromy matrix (N, N): the product of flows and saltation matrices over a period.

        It maps the vector field at the start to itself; its other eigenvalues are the
        multipliers.
        """
        return self.evaluation.monodromy

    @property
    def shift(self) -> dict[str, Any]:
        """By how much each state is moved behind one period: zero but along translations."""
        return self.evaluation.shift

    def evaluate(self, *quantities: str) -> Any:
        """Evaluate quantities of the kernels at the orbit's own parameters and unknowns.

        Parameters
        ----------
        quantities : str
            One, as "residual" or "jacobian", or several of one kernel; `OrbitKernels.evaluate`
            lists them. Those of the reduced equations take other unknowns, and are refused.

        Returns
        -------
        array, or nested lists of mpmath numbers; a tuple of several
            Nondimensional, or in the units of the declaration.

        Raises
        ------
        InputError
            If the orbit has no kernels, or they give no such quantities together; the message
            lists those that there are.
        """
        kernels, values = self.kernels, self.values
        for quantity in quantities:
            if not isinstance(quantity, str):
                raise unknown_name("quantity", quantity, kernels.of_equations)
            if quantity not in kernels.of_equations and kernels.has(quantity):
                raise InputError(
                    f"{quantity!r} is of the reduced equations, which `kernels.evaluate` takes at"
                    f" {', '.join(kernels.reduced) or 'no unknowns'}; at all unknowns there are:"
                    f" {', '.join(kernels.of_equations)}"
                )
        lib = self.arithmetic if self.precise else None
        return kernels.evaluate(*quantities, at=kernel_arguments(kernels, values, lib), lib=lib)

    def derivatives(
        self, by: Sequence[str] | str | None = None, *, one_sided: bool | None = None
    ) -> OrbitDerivatives:
        """Differentiate the orbit by what was given, exactly up to rounding.

        By the implicit function theorem on its equations; an orbit from `refine` is
        differentiated to its own digits.

        Parameters
        ----------
        by : sequence of str, or str, optional
            Names of what was given, parameters and what was exchanged for them: all when
            omitted.
        one_sided : bool, optional
            Where the orbit is a border collision, as where boundaries are reached together,
            other sequences of phases live on the other side. Derivatives of the orbit's own
            are then given on request only.

        Returns
        -------
        OrbitDerivatives

        Raises
        ------
        InputError
            For what was not given, and where there is no derivative: at a border collision, a
            grazing, a fold, or one of a family of orbits without its period.

        Examples
        --------
        >>> from nonsmooth.runtime.orbits.solve import solve
        >>> found = solve("dry-friction/global-stick").derivatives(["eta", "V"])
        >>> found.unknowns["tau"].shape, found.trace.shape
        ((2,), (2,))
        """
        found: OrbitDerivatives = registered("orbit_derivatives")(self, by, one_sided)
        return found

    def trajectory(self, periods: int = 1) -> Trajectory:
        """Give the motion along the orbit, phase by phase as it was solved for.

        An unstable orbit is not left, as it would be by a simulation from its start.

        Parameters
        ----------
        periods : int
            How many of them.

        Returns
        -------
        Trajectory

        Raises
        ------
        InputError
            If there is no orbit, for a count that is no positive integer, or an orbit that
            leaves physical parameters open: see `motion`.
        """
        return self.evaluation.trajectory(checked_count("periods", periods, 1))

    def motion(self) -> Motion:
        """Give the motion along the orbit: its state at any time, in double precision.

        Returns
        -------
        Motion
        """
        return orbit_motion(self)

    def plot(self, kind: str = "time", axes: Any = None, **options: Any) -> Any:
        """Draw the orbit by matplotlib.

        Parameters
        ----------
        kind : {"time", "velocity", "phase", "strip", "multipliers", "all"}
            Histories of positions or of velocities, phase portraits, the strip of
            configurations, the multipliers in the unit circle, or all of them.
        axes : matplotlib Axes, optional
            Where to draw; a figure of its own when omitted.
        **options
            As `nonsmooth.runtime.present.pictures.view.orbit_view` takes them.

        Returns
        -------
        matplotlib Axes, or array of them
            What was drawn on.
        """
        return registered("plot_motion")(self, kind, axes, **options)

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle the orbit as its file keeps it; `InputError` if it has not converged."""
        return registered("orbit_in"), (registered("orbit_content")(self),)

    def _repr_latex_(self) -> str:
        text: str = registered("orbit_latex")(self)
        return text


def kernel_arguments(kernels: OrbitKernels, values: Mapping[str, Any], lib: Any) -> Any:
    """Return what kernels of equations take, at values of all parameters and unknowns."""
    parameters = [values[name] for name in kernels.parameter_names]
    spectrum, derivatives = kernels.spectrum(parameters, lib)
    return parameters, spectrum, [values[name] for name in kernels.unknowns], derivatives


def check_converged(orbit: Orbit, doing: str) -> None:
    """Refuse an orbit that has not converged; `doing` says what was to be done with it."""
    if not orbit.converged:
        raise InputError(f"{orbit.name} cannot be {doing}: {orbit.message}")


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
