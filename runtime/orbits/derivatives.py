"""Derivatives of an orbit by its parameters, exact up to rounding, and the way to other parameters.

An orbit is followed to them, and its quantities are functions of them.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.arguments import checked_methods
from nonsmooth.runtime.core.differentiable import DifferentiableFunction
from nonsmooth.runtime.core.errors import InputError, NoConvergence, chosen_names, unknown_name
from nonsmooth.runtime.core.values import Value, as_value
from nonsmooth.runtime.orbits.kernel_solve import solve_kernels
from nonsmooth.runtime.orbits.orbit import PERIOD, Orbit, check_converged
from nonsmooth.runtime.orbits.problem import labelled_as
from nonsmooth.runtime.orbits.table_solve import solve_itinerary
from nonsmooth.runtime.shooting.multipliers import (
    MultiplierDerivatives,
    multiplier_derivatives,
)
from nonsmooth.runtime.shooting.newton import CONVERGED

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.directions import Directions
    from nonsmooth.runtime.orbits.motion_derivatives import (
        BoundaryMargin,
        LocalExtreme,
        OrbitMotionDerivatives,
    )

_ALONG = ("dissipation", "margin")
_GIVEN = ("period", "trace", "determinant", "spectral_radius")
_KEPT = 64  # points whose orbits are remembered
_SHORTEST = 1.0 / 1024  # of the way
_FAR = 0.2  # difference from the prediction, in units of the unknowns, of another orbit


@checked_methods
@dataclass(frozen=True, eq=False)
class OrbitDerivatives:
    """Derivatives of an orbit by q numbers that were given, the others kept.

    Arrays of floats, or of mpmath numbers for an orbit from `refine`. Nondimensional, or in
    the units of the declaration.

    Attributes
    ----------
    orbit : Orbit
    by : tuple of str
        The q numbers.
    one_sided : str
        On which side derivatives are taken, as "ta > 0", of a border collision; else empty.
    """

    orbit: Orbit = field(repr=False)
    by: tuple[str, ...]
    one_sided: str = ""

    @cached_property
    def directions(self) -> Directions:
        """How the orbit moves, phase by phase."""
        return self.orbit.evaluation.directions(self.by)

    @property
    def unknowns(self) -> Mapping[str, np.ndarray]:
        """Of each unknown (q,)."""
        return self.directions.unknowns

    @cached_property
    def period(self) -> np.ndarray:
        """Of the period (q,)."""
        return np.asarray(self.directions.dwell.sum(axis=1))

    @property
    def dwell_times(self) -> np.ndarray:
        """Of each dwell time (p, q)."""
        return self.directions.dwell.T

    @property
    def starts(self) -> np.ndarray:
        """Of the state (p, N, q) at the start of each phase, which moves in time too."""
        return np.moveaxis(self.directions.starts, 0, -1)

    @cached_property
    def section(self) -> MultiplierDerivatives:
        """Of multipliers, trace and determinant of the map whose eigenvalues they are."""
        lib = self.orbit.arithmetic if self.orbit.precise else None
        return multiplier_derivatives(self.directions.section, lib)

    @property
    def trace(self) -> np.ndarray:
        """Of the trace (q,) of the Poincare map's Jacobian."""
        own = self.directions.trace
        return self.section.trace_rates if own is None else own

    @property
    def determinant(self) -> np.ndarray:
        """Of the product (q,) of the multipliers that may differ from zero."""
        return self.section.determinant_rates

    @property
    def multipliers(self) -> np.ndarray:
        """Of the multipliers (s, q) that may differ from zero and are not trivial.

        In the order of `section.multipliers`; NaN for those that collide, of which trace and
        determinant have derivatives alone.
        """
        return self.section.multiplier_rates

    @property
    def spectral_radius(self) -> np.ndarray:
        """Of the largest absolute value (q,) of a nontrivial multiplier; NaN at a collision."""
        return self.section.spectral_radius_rates

    @cached_property
    def along(self) -> OrbitMotionDerivatives:
        """The orbit by the tables of its system, as it moves."""
        return self.orbit.evaluation.along(self)

    def states(self, times: Sequence[Any]) -> np.ndarray:
        """Of the states (m, N, q) at times since the start that stay what they are.

        In the system's coordinates, as all that is seen along the motion.

        Parameters
        ----------
        times : sequence (m,) of number
            Within the period.

        Returns
        -------
        array (m, N, q)

        Raises
        ------
        InputError
            For a time outside of the period.
        """
        return self.along.states(times)[1]

    @property
    def margins(self) -> tuple[BoundaryMargin, ...]:
        """How far each boundary stays away along each phase, with derivatives (q,)."""
        return self.along.margins

    def local_extremes(self, name: str) -> tuple[LocalExtreme, ...]:
        """Local extremes of which a quantity is the largest, with derivatives (q,).

        Where several are equally large the quantity has no derivative, and each of them has.

        Parameters
        ----------
        name : str
            ``maximum:STATE``, ``minimum:STATE``, ``peak:STATE``, ``peak_acceleration:STATE`` or
            ``peak_force:CONTACT``.

        Returns
        -------
        tuple of LocalExtreme
            By phases, maxima first, each in the order of time.

        Raises
        ------
        InputError
            For another name, and with many digits.
        """
        if name not in self._extremes:
            self._extremes[name] = self.along.local_extremes(name)
        return self._extremes[name]

    @cached_property
    def _extremes(self) -> dict[str, tuple[LocalExtreme, ...]]:
        return {}

    @property
    def names(self) -> tuple[str, ...]:
        """Quantities that `quantity` knows."""
        return (*self.unknowns, *_GIVEN, *self.along.names)

    def quantity(self, name: str) -> tuple[Any, np.ndarray]:
        """Value of a quantity, and its derivatives.

        Parameters
        ----------
        name : str
            An unknown, ``period``, ``trace``, ``determinant`` or ``spectral_radius``. Along the
            motion ``maximum:STATE``, ``minimum:STATE`` and ``peak:STATE`` (of the absolute
            value) over the period; ``peak_acceleration:STATE``; ``peak_force:CONTACT``;
            ``dissipation`` through all contacts or ``dissipation:CONTACT``, what impacts take
            included; and ``margin``, the least distance from a boundary that stays away.

        Returns
        -------
        value : number
        derivatives : array (q,)

        Raises
        ------
        InputError
            For an unknown name.
        """
        if not isinstance(name, str):
            raise unknown_name("quantity", name, self.names)
        if name in self.unknowns:
            return self.orbit.unknowns[name], self.unknowns[name]
        if name in ("period", "trace"):
            return getattr(self.orbit, name), getattr(self, name)
        if name in _GIVEN:
            return getattr(self.section, name), getattr(self, name)
        found = self.along.quantity(name) if ":" in name or name in _ALONG else None
        if found is None:
            raise unknown_name("quantity", name, self.names)
        return found.value, found.rates


def orbit_derivatives(
    orbit: Orbit, by: Sequence[str] | str | None = None, one_sided: bool | None = None
) -> OrbitDerivatives:
    """Return the derivatives of an orbit by what was given, or all of it; see `Orbit.derivatives`.

    Where the orbit has another sequence of phases on one side, `one_sided` asks for the
    derivatives of its present sequence. `InputError` is raised for what was not given,
    and where there is no derivative.
    """
    known = tuple(orbit.given)
    names = known if by is None else chosen_names("given parameter", by, known)
    if orbit.status != CONVERGED:
        raise InputError(f"there is no orbit to differentiate: {orbit.message}")
    side, event = orbit.evaluation.border
    if side and not one_sided:
        raise InputError(
            f"{orbit.name}: {event}: derivatives exist on one side ({side}); ask for them by"
            " one_sided=True"
        )
    found = OrbitDerivatives(orbit, names, side)
    found.directions  # noqa: B018 - what cannot be is refused here
    return found


def orbit_function(
    orbit: Orbit, *, by: Sequence[str] | str, of: Sequence[str] | str
) -> DifferentiableFunction:
    """Quantities of an orbit as a function of some of what was given.

    At other points the orbit is followed from the reference along a straight line, by steps
    that a first-order prediction bears out, so that another orbit is not taken for it. Where
    it cannot be followed, values and derivatives are NaN.

    Parameters
    ----------
    orbit : Orbit
        Where the function is made.
    by : sequence of str, or str
        Names of what was given; the others are kept.
    of : sequence of str, or str
        Quantities, as `OrbitDerivatives.quantity` knows them.

    Returns
    -------
    DifferentiableFunction

    Raises
    ------
    InputError
        For unknown names, and where the orbit has no derivatives.

    Examples
    --------
    >>> from nonsmooth.runtime.orbits.solve import solve
    >>> found = orbit_function(solve("dry-friction/global-stick"), by="eta", of=["period"])
    >>> found([1.01]).shape, found.jacobian([1.01]).shape
    ((1,), (1, 1))
    """
    check_converged(orbit, "made a function of parameters")
    inputs = chosen_names("given parameter", by, orbit.given)
    outputs = tuple(of) if isinstance(of, Iterable) and not isinstance(of, str) else (of,)
    if not outputs:
        raise InputError("a function gives at least one number")
    first = orbit.derivatives(inputs)
    for name in outputs:
        if not isinstance(name, str):
            raise InputError(f"{name!r} is no name of a quantity")
        first.quantity(name)
    reference = _floats(orbit.given, inputs)
    known: OrderedDict[bytes, OrbitDerivatives | None] = OrderedDict()
    known[reference.tobytes()] = first

    def at(point: np.ndarray) -> OrbitDerivatives | None:
        key = point.tobytes()
        if key not in known:
            try:
                found = followed(first, point)
            except (InputError, NoConvergence, ArithmeticError):
                found = None
            known[key] = found
            if len(known) > _KEPT:
                known.pop(next(k for k in known if k != reference.tobytes()))
        return known[key]

    def differentiate(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        values = np.full((len(points), len(outputs)), np.nan)
        jacobians = np.full((len(points), len(outputs), len(inputs)), np.nan)
        for place, point in enumerate(points):
            if (found := at(np.ascontiguousarray(point))) is not None:
                with suppress(InputError, NoConvergence):
                    entries = [found.quantity(name) for name in outputs]
                    values[place] = [float(value) for value, _ in entries]
                    jacobians[place] = [rates.astype(float) for _, rates in entries]
        return values, jacobians

    def evaluate(points: np.ndarray) -> np.ndarray:
        return differentiate(points)[0]

    return DifferentiableFunction(inputs, outputs, reference, evaluate, differentiate)


def followed(
    reference: OrbitDerivatives, point: np.ndarray, shortest: float = _SHORTEST
) -> OrbitDerivatives:
    """Return the derivatives of the same orbit at another point, to which it is followed.

    The way is a straight line in the q numbers by which the reference is differentiated;
    it ends at the values `point` (q,). Steps shorter than the share `shortest` of the way
    are not tried. `NoConvergence` is raised where the orbit cannot be followed,
    `InputError` where there is no such system or no derivative.
    """
    if not np.isfinite(point).all():
        raise InputError("a point that is not finite")
    here, by = reference, reference.by
    begin = _floats(reference.orbit.given, by)
    done, step = 0.0, 1.0
    while done < 1:
        ahead = min(1.0, done + step)
        aim = point if ahead == 1 else begin + ahead * (point - begin)
        try:
            here = _stepped(here, aim)
        except (InputError, NoConvergence):
            step /= 2
            if step < shortest:
                raise
            continue
        done, step = ahead, 2 * step
    return here


def _stepped(here: OrbitDerivatives, aim: np.ndarray) -> OrbitDerivatives:
    """Return the derivatives one step ahead; `NoConvergence` if the orbit is not as predicted."""
    orbit, by = here.orbit, here.by
    names = tuple(orbit.unknowns)
    now, values = _floats(orbit.given, by), _floats(orbit.unknowns, names)
    rates = np.array([here.unknowns[name].astype(float) for name in names])
    guess = values + rates @ (aim - now)
    given = {**orbit.given, **{n: as_value(float(x)) for n, x in zip(by, aim, strict=True)}}
    found = _solved(orbit, given, dict(zip(names, guess.tolist(), strict=True)))
    if not found.converged:
        raise NoConvergence(f"{orbit.name}: {found.message}")
    if (found.dwell_times < 0).any():
        raise NoConvergence(f"{orbit.name}: a dwell time is negative")
    solved = _floats(found.unknowns, names)
    size = np.maximum(abs(values), abs(values).max(initial=0.0) * _FAR)
    if (abs(solved - guess) > _FAR * np.where(size > 0, size, 1.0)).any():
        raise NoConvergence(f"{orbit.name}: Newton's method leaves the orbit that was predicted")
    return found.derivatives(by, one_sided=bool(here.one_sided) or None)


def _floats(values: Mapping[str, Any], names: Iterable[str]) -> np.ndarray:
    return np.array([float(values[name]) for name in names])


def _solved(orbit: Orbit, given: Mapping[str, Value], guess: Mapping[str, float]) -> Orbit:
    """Return an orbit of the same itinerary and the same unknowns, from a guess of them.

    An orbit that was solved for by a part is solved for as a whole: a parameter may break
    the symmetry.
    """
    kernels = orbit.problem.kernels
    if kernels is None:
        period = given[PERIOD] if PERIOD in given and orbit.tables.family else None
        parameters = {name: value for name, value in given.items() if name != PERIOD}
        values, count = list(guess.values()), len(orbit.itinerary)
        found = solve_itinerary(
            orbit.system, parameters, orbit.itinerary, values[:count], values[count:], period=period
        )
        return labelled_as(found, orbit)
    swapped = tuple(name for name in orbit.unknowns if name not in kernels.unknowns)
    fixed = {name: value for name, value in given.items() if name in kernels.unknowns}
    taken = {name: value for name, value in given.items() if name not in fixed}
    start = {name: float(value) for name, value in fixed.items()}
    start |= {name: value for name, value in guess.items() if name in kernels.unknowns}
    return solve_kernels(
        kernels, {**taken, **orbit.opened}, start, unknown=swapped, given=fixed, throw=False
    )
