"""Derivatives of an orbit by its parameters, exact up to rounding."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, chosen_names, unknown_name
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
        Transversality,
    )
    from nonsmooth.runtime.orbits.orbit import Orbit

__all__ = ["OrbitDerivatives", "orbit_derivatives"]

_ALONG = ("dissipation", "margin", "transversality")
_GIVEN = ("period", "trace", "determinant", "spectral_radius")


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
        found, shares = self.orbit.evaluation.along(self)
        return found if shares is None else found.turned(self.by, shares)

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

    @property
    def transversalities(self) -> tuple[Transversality, ...]:
        """With which speed each phase reaches the boundary that ends it, and derivatives (q,)."""
        return self.along.transversalities

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
        key = str(name)  # what is no name is refused
        if key not in self._extremes:
            self._extremes[key] = self.along.local_extremes(name)
        return self._extremes[key]

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
            included; ``margin``, the least distance from a boundary that stays away; and
            ``transversality``, the least speed with which one is reached.

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
