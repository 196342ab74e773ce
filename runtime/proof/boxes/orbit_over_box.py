"""An orbit over a box of parameters: the system's numbers are rational functions of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import product
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.rational_functions import RationalFunction
from nonsmooth.runtime.core.taylor_models import middle_of
from nonsmooth.runtime.core.values import Value, as_value, flint_precision
from nonsmooth.runtime.model.piecewise import system_parameters
from nonsmooth.runtime.orbits.composed_orbit import ComposedOrbit
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.solve import solve
from nonsmooth.runtime.proof.admissibility_conditions import Plan, plan_of
from nonsmooth.runtime.proof.boxes.dependence import PERIOD, entries_over
from nonsmooth.runtime.proof.boxes.tile_places import Interval
from nonsmooth.runtime.proof.closure import Closing
from nonsmooth.runtime.proof.exact_tables import Tables, rational_of, tables_over
from nonsmooth.runtime.proof.invariants import CycleInvariants, invariants_of
from nonsmooth.runtime.proof.orbit_cycle import (
    NotCovered,
    Subject,
    check_converged,
    chosen_of,
    chosen_values,
    closing_of,
    guess_of,
    period_name,
    physical_values,
    subject_near,
    translations_in,
)
from nonsmooth.runtime.proof.parametric_declaration import PERIOD as PERIOD_NAME
from nonsmooth.runtime.proof.parametric_declaration import orbit_declaration
from nonsmooth.runtime.proof.statement import closing_json
from nonsmooth.runtime.shooting.shooting_map import Cycle

if TYPE_CHECKING:
    from flint import arb

__all__ = ["BITS", "Region", "checked_box", "given_of", "region_of", "with_open_ones"]

BITS = 64  # working precision on tiles: their size is what makes the balls wide


@dataclass(frozen=True, eq=False)
class Region:
    """What is to be proved of an orbit for all parameters of a box.

    Attributes
    ----------
    subject : Subject
        The orbit at one point of the box.
    names : tuple of str
        Of the box's parameters.
    box : tuple of (Fraction, Fraction)
    constants : tuple of Value
        Irrational parameters; they follow the box's in the rational functions.
    tables : Tables
    closing : Closing
        Its period is a fmpq or a RationalFunction.
    invariants : CycleInvariants
    plans : tuple of Plan
    at : tuple of Fraction
        The subject's point.
    guess : list of arb
        Unknowns of the equations there, about.
    """

    subject: Subject
    names: tuple[str, ...]
    box: tuple[Interval, ...]
    constants: tuple[Value, ...]
    tables: Tables
    closing: Closing
    invariants: CycleInvariants
    plans: tuple[Plan, ...]
    at: tuple[Fraction, ...]
    guess: Sequence[arb]

    @property
    def cycle(self) -> Cycle:
        """The orbit's cycle."""
        return self.subject.cycle

    def number(self, values: Sequence[Any]) -> Callable[[Any], Any]:
        """The map from exact entries to numbers, at values of the box's parameters."""
        from flint import arb, ctx

        point = [*values, *(value.ball(ctx.prec) for value in self.constants)]
        found: dict[RationalFunction, Any] = {}

        def number(entry: Any) -> Any:
            if not isinstance(entry, RationalFunction):
                return arb(entry)
            if entry not in found:
                found[entry] = entry(point)
            return found[entry]

        return number

    def near(self, point: Sequence[Fraction]) -> Callable[[Any], float]:
        """The map from exact entries to floats, at a point of the box."""
        from flint import arb

        def near(entry: Any) -> float:
            with flint_precision(BITS):
                return float(middle_of(self.number([arb(rational_of(x)) for x in point])(entry)))

        return near

    def statement(self, orbit: Orbit | ComposedOrbit) -> tuple[dict[str, Any], dict[str, Any]]:
        """Declaration and closing as a file states them.

        Over the box's parameters and those that were given for the orbit.
        """
        subject, given = self.subject, given_of(orbit)
        names = (*self.names, *(name for name in given if name not in self.names))
        kernels = orbit.kernels if isinstance(orbit, Orbit) else None
        declared = orbit_declaration(
            subject.kernels, kernels, self.cycle, names, subject.start_names, subject.dwell_names
        )
        own = {value: name for name, value in reversed(given.items())}
        variables = [*self.names, *(own.get(value, "") for value in self.constants)]
        period = PERIOD_NAME if kernels is None else period_name(kernels) or ""
        return declared, closing_json(self.closing, self.cycle, names, variables, period)


def given_of(orbit: Orbit | ComposedOrbit) -> dict[str, Value]:
    """All that was given for an orbit."""
    return {**orbit.given, **orbit.opened}


def checked_box(
    orbit: Orbit | ComposedOrbit, box: Mapping[str, tuple[object, object]]
) -> dict[str, Interval]:
    """The box with exact ends.

    Raises
    ------
    InputError
        For an orbit that has not converged, names that were not given for it, ends that are
        not rational or in the wrong order, or a box without the orbit's own parameters.
    """
    if not isinstance(orbit, Orbit | ComposedOrbit):
        raise InputError(f"{orbit!r} is no orbit, such as solve gives")
    check_converged(orbit)
    given = given_of(orbit)
    found: dict[str, Interval] = {}
    if not isinstance(box, Mapping) or not box:
        raise InputError("the box has no parameter: give one, as in V=0.99:1.01")
    for name, ends in box.items():
        if name not in given:
            raise unknown_name("given parameter", str(name), given)
        if not isinstance(ends, tuple | list) or len(ends) != 2:
            raise InputError(f"{name}: a box has a lower and an upper end, not {ends!r}")
        exact = [as_value(end).exact for end in ends]
        lower, upper = exact
        if lower is None or upper is None:
            raise InputError(f"the ends of {name} have to be rational numbers")
        if not lower < upper:
            raise InputError(f"{name}={ends[0]}:{ends[1]}: the lower end has to be below the upper")
        own = given[name].exact
        if own is None:
            raise InputError(f"{name} = {given[name]} of the orbit is irrational")
        if not lower <= own <= upper:
            raise InputError(f"{name} = {given[name]} of the orbit is not in {ends[0]}:{ends[1]}")
        found[name] = (lower, upper)
    return found


def with_open_ones(
    orbit: Orbit | ComposedOrbit, box: Mapping[str, Interval]
) -> tuple[Orbit | ComposedOrbit, tuple[str, ...]]:
    """The orbit with values of parameters that it leaves open, large enough for all of a box.

    Bounds are those at the orbit and, where it is found there, in the corners: nothing is
    proved of that. All values are checked in all corners.

    Raises
    ------
    InputError
        If values in a corner are not in their domains.
    NotCovered
        As for `subject_near`.
    """
    corners = [dict(zip(box, point, strict=True)) for point in product(*box.values())]
    chosen: dict[str, Value] = {}
    if isinstance(orbit, Orbit):
        bounds: dict[str, float] = {}
        points: list[Orbit | ComposedOrbit] = [orbit]
        if chosen_of(orbit):
            given = given_of(orbit)
            points += [
                solve(orbit.name, {**given, **corner}, orbit.unknowns, throw=False)
                for corner in corners
            ]
        for point in points:
            if point.converged and orbit.kernels.open_parameters:
                for need in point.admissibility.requires:
                    bounds[need.parameter] = max(need.greater_than, bounds.get(need.parameter, 0.0))
        chosen = chosen_values(orbit.kernels, given_of(orbit), bounds)
        orbit = replace(orbit, opened={**orbit.opened, **chosen})
    numbers, _ = _numbers(orbit, subject_near(orbit), tuple(box))
    try:
        for corner in corners:
            numbers({name: as_value(x) for name, x in corner.items()})
    except NotCovered as problem:
        raise InputError(str(problem)) from None
    return orbit, tuple(chosen)


def region_of(orbit: Orbit | ComposedOrbit, box: Mapping[str, Interval]) -> Region:
    """The region of an orbit and a box that holds its parameters.

    Raises
    ------
    NotCovered
        If a declaration takes roots, or what `subject_near` and `closing_of` say.
    """
    subject = subject_near(orbit)
    try:
        return _region(orbit, subject, box)
    except AttributeError:
        raise NotCovered("the declaration takes a root or a sine of its parameters") from None
    except ZeroDivisionError as problem:
        raise NotCovered(str(problem)) from None


def _region(orbit: Orbit | ComposedOrbit, subject: Subject, box: Mapping[str, Interval]) -> Region:
    numbers, at = _numbers(orbit, subject, tuple(box))
    constants, entries = entries_over(box, numbers)
    period = entries.pop(PERIOD, None)
    tables = tables_over(subject.kernels, list(entries.values()))
    invariants = invariants_of(tables, subject.cycle, translations_in(subject, tables))
    region = Region(
        subject, tuple(box), tuple(box.values()), constants, tables, Closing("state"), invariants,
        plan_of(tables, subject.cycle, invariants), tuple(at), (),
    )  # fmt: skip
    near = region.near(at)
    closing = closing_of(subject, tables, [float(x) for x in subject.start], near)
    guess = guess_of(subject, closing, near)
    if closing.kind == "period":
        closing = replace(closing, period=period)
    return replace(region, closing=closing, guess=guess)


def _numbers(
    orbit: Orbit | ComposedOrbit, subject: Subject, names: Sequence[str]
) -> tuple[Callable[[Mapping[str, Value]], dict[str, Value]], list[Fraction]]:
    """Parameters of the system and the period at a point, and the orbit's own point."""
    given = given_of(orbit)
    derived = orbit if isinstance(orbit, Orbit) else None
    fixed = given if derived is None else {**given, **chosen_of(derived)}
    own = PERIOD_NAME if derived is None else period_name(derived.kernels)

    def numbers(point: Mapping[str, Value]) -> dict[str, Value]:
        told = {**fixed, **point}
        if derived is not None:
            values = physical_values(derived.kernels, told)
        else:
            values = system_parameters(
                subject.kernels, {name: told[name] for name in subject.values}
            )
        return values if subject.period is None else {**values, PERIOD: told[str(own)]}

    at = [given[name].exact for name in names]
    if None in at:
        raise NotCovered("the orbit's own point of the box is irrational")
    return numbers, [x for x in at if x is not None]
