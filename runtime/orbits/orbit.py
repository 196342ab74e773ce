"""The record of a periodic orbit and everything that can be asked of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.arithmetic import Mpmath
from nonsmooth.runtime.core.errors import unknown_name
from nonsmooth.runtime.core.registry import registered
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.kernels import OrbitKernels, load_orbit
from nonsmooth.runtime.shooting.newton import (
    CONVERGED,
    INVALID,
    NEGATIVE,
    OUTSIDE,
    SINGULAR,
    STALLED,
)

if TYPE_CHECKING:
    import os

    from nonsmooth.runtime.orbits.admissible import Admissibility
    from nonsmooth.runtime.orbits.motion import Motion
    from nonsmooth.runtime.orbits.stability import Stability

__all__ = ["STATUS", "Orbit", "Sensitivity"]

DOUBLE = 15  # decimal digits up to which doubles serve
GUARD = 15  # decimal digits carried beyond those asked for

STATUS = {
    CONVERGED: "converged",
    STALLED: "not converged: give a guess nearer to the orbit, or none and let it be searched",
    INVALID: "not finite: a parameter is outside its domain or the guess is far from any orbit",
    NEGATIVE: "a dwell time is not positive: no motion has this itinerary here;"
    " change the parameters or search without a guess",
    OUTSIDE: "a parameter that was solved for is outside its domain: no such system exists;"
    " change what is given",
    SINGULAR: "singular: at these parameters (a resonance) the equations do not determine an"
    " orbit; there is none, or a whole family: change a parameter",
}


@dataclass(frozen=True)
class Sensitivity:
    """Derivatives by one parameter, the others kept: nondimensional.

    Attributes
    ----------
    unknowns : dict of str to number
    period, trace : number
    """

    unknowns: dict[str, Any]
    period: Any
    trace: Any


@dataclass(frozen=True)
class Orbit:
    """A periodic orbit, or what a solver reached when it found none.

    Attributes
    ----------
    name : str
        ``system/orbit``.
    given : dict of str to Value
        What was given, exactly: parameters, and unknowns that were exchanged for them.
    unknowns : dict of str to number
        What was solved for; floats, or mpmath numbers after `refine`. Nondimensional.
    opened : dict of str to Value
        Parameters that only admissibility depends on, as far as they are given.
    residual : number
        Largest absolute value of the equations' left-hand sides.
    digits : int
        Error of each unknown x is at most 10^-digits max(1, |x|).
    iterations : int
    status : int
        Key of `STATUS`, whose text says what to do next.
    """

    name: str
    given: Mapping[str, Value]
    unknowns: Mapping[str, Any]
    opened: Mapping[str, Value]
    residual: Any
    digits: int
    iterations: int
    status: int

    @property
    def kernels(self) -> OrbitKernels:
        """Kernels of this orbit."""
        return load_orbit(self.name)

    @property
    def converged(self) -> bool:
        """Whether this is an orbit at all."""
        return self.status == CONVERGED

    @property
    def message(self) -> str:
        """What the status means and suggests."""
        return STATUS[self.status]

    @property
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
    def parameters(self) -> dict[str, Any]:
        """All parameters of the equations, in the kernels' order."""
        return {name: self.values[name] for name in self.kernels.parameter_names}

    @property
    def dwell_times(self) -> dict[str, Any]:
        """Duration of each phase; nondimensional."""
        return self.kernels.durations(self.values)

    @property
    def period(self) -> Any:
        """Sum of the dwell times; nondimensional."""
        return sum(self.dwell_times.values())

    @cached_property
    def states(self) -> Any:
        """State at the start and behind each transition.

        Array (phases + 1, N) of floats, or rows of mpmath numbers; in the coordinates of the
        equations, nondimensional.
        """
        return self.evaluate("states")

    @cached_property
    def stability(self) -> Stability:
        """Multipliers, trace and verdict."""
        from nonsmooth.runtime.orbits.stability import assess_stability

        return assess_stability(self)

    @cached_property
    def admissibility(self) -> Admissibility:
        """Whether the orbit is a motion of the real system."""
        from nonsmooth.runtime.orbits.admissible import assess_admissibility

        return assess_admissibility(self)

    @cached_property
    def saltations(self) -> Any:
        """Saltation matrix of each transition (Sec. 4).

        A perturbation in front of the transition, times the matrix, is that behind it, to
        first order at the same time. Array (phases, N, N) of floats, or a list of nested
        lists of mpmath numbers.
        """
        rows = self.evaluate("saltations")
        size = len(self.kernels.table["states"])
        if not self.precise:
            return rows.reshape(-1, size, size)
        return [rows[k : k + size] for k in range(0, len(rows), size)]

    @cached_property
    def monodromy(self) -> Any:
        """Monodromy matrix (N, N): the product of flows and saltation matrices over a period.

        It maps the vector field at the start to itself; its other eigenvalues are the
        multipliers.
        """
        return self.evaluate("monodromy")

    @property
    def trace(self) -> Any:
        """Trace of the Poincare map's Jacobian."""
        return self.stability.trace

    def evaluate(self, kernel: str, *, moved: bool = False) -> Any:
        """A kernel of this orbit at its own parameters and unknowns.

        With `moved` the kernel takes the spectrum's derivatives too. Floats give arrays,
        mpmath numbers nested lists.
        """
        kernels = self.kernels
        parameters = [self.values[name] for name in kernels.parameter_names]
        unknowns = [self.values[name] for name in kernels.unknowns]
        if self.precise:
            lib = self.arithmetic
            spectrum, derivatives = kernels.spectrum(parameters, lib)
            arrays = (parameters, spectrum, *([derivatives] if moved else []), unknowns)
            return kernels.source(kernel)(*arrays, lib=lib)
        spectrum, derivatives = kernels.spectrum(parameters)
        arrays = (parameters, spectrum, *([derivatives] if moved else []), unknowns)
        return kernels.evaluate(kernel, *arrays)

    def sensitivity(self, parameter: str) -> Sensitivity:
        """Derivatives of unknowns, period and trace by one given parameter.

        By the implicit function theorem on the full equations, J du = -dF/dp, for the
        choice of unknowns of this orbit.

        Raises
        ------
        InputError
            If the parameter is not among those given.
        """
        if parameter not in self.given:
            raise unknown_name("given parameter", parameter, self.given)
        kernels = self.kernels
        names = [*kernels.unknowns, *kernels.parameter_names]
        rows = [
            [*by_unknowns, *by_parameters]
            for by_unknowns, by_parameters in zip(
                self.evaluate("jacobian"),
                self.evaluate("parameter_jacobian", moved=True),
                strict=True,
            )
        ]
        places = [names.index(name) for name in self.unknowns]
        column = names.index(parameter)
        matrix = [[row[i] for i in places] for row in rows]
        right = [-row[column] for row in rows]
        solution = (
            self.arithmetic.solve(matrix, right)
            if self.precise
            else [float(x) for x in np.linalg.solve(np.array(matrix), np.array(right))]
        )
        rates = dict(zip(self.unknowns, solution, strict=True)) | {parameter: 1}
        gradient = self.evaluate("trace_gradient", moved=True)
        slopes = dict(zip(names, gradient if self.precise else gradient.tolist(), strict=True))
        return Sensitivity(
            dict(zip(self.unknowns, solution, strict=True)),
            sum(kernels.durations({**dict.fromkeys(names, 0), **rates}).values()),
            sum(slopes[name] * rate for name, rate in rates.items()),
        )

    def to_json(self) -> dict[str, Any]:
        """The orbit as JSON: numbers as decimal strings with all their digits."""
        told: dict[str, Any] = registered("orbit_json")(self)
        return told

    def motion(self) -> Motion:
        """The motion along the orbit: its state at any time, in double precision."""
        from nonsmooth.runtime.orbits.motion import orbit_motion

        return orbit_motion(self)

    def plot(self, kind: str = "time", axes: Any = None, **options: Any) -> Any:
        """Draw the orbit; see `nonsmooth.runtime.present.pictures.plot.plot_orbit`."""
        return registered("plot_orbit")(self, kind, axes, **options)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the orbit to a file with every digit; `nonsmooth.load` reads it."""
        registered("save_orbit")(self, path)

    def _repr_html_(self) -> str:
        text: str = registered("orbit_html")(self)
        return text

    def _repr_latex_(self) -> str:
        text: str = registered("orbit_latex")(self)
        return text
