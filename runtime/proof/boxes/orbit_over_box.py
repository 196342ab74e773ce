"""An orbit over a box of parameters: the system's numbers are rational functions of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial
from itertools import product
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.values import Value, as_value
from nonsmooth.runtime.orbits.kernel_problem import chosen_parameters
from nonsmooth.runtime.orbits.orbit import Orbit, check_converged
from nonsmooth.runtime.orbits.solve import solve
from nonsmooth.runtime.proof.boxes.dependence import PERIOD, entries_over
from nonsmooth.runtime.proof.boxes.tile_places import Interval
from nonsmooth.runtime.proof.exact_closure import ClosureConditions
from nonsmooth.runtime.proof.exact_tables import (
    NotRational,
    Number,
    Tables,
    exact_tables,
    irrational_texts,
    rational_of,
    tables_over,
)
from nonsmooth.runtime.proof.orbit_equations import (
    Equations,
    equations_in,
    phases_of,
)
from nonsmooth.runtime.proof.orbit_to_prove import (
    NotCovered,
    Subject,
    closing_of,
    guess_of,
    subject_near,
)
from nonsmooth.runtime.proof.parametric_declaration import orbit_declaration
from nonsmooth.runtime.proof.statement import closing_json
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape
from nonsmooth.runtime.shooting.variational import Phase

if TYPE_CHECKING:
    from flint import arb

__all__ = ["Region", "checked_box", "given_of", "region_at", "region_of", "with_open_ones"]

_LONG = 6  # phases of a cycle beyond which rounding errors grow too much for that


@dataclass(frozen=True, eq=False)
class Region:
    """What is to be proved of an orbit for all parameters of a box; a point is a box of none."""

    subject: Subject  # the orbit at one point of the box
    names: tuple[str, ...]  # of the box's parameters
    box: tuple[Interval, ...]  # lower and upper end of each parameter
    tables: Tables  # irrational parameters follow the box's in the rational functions
    closing: ClosureConditions  # its period is a Value, a fmpq or a RationalFunction
    at: tuple[Fraction, ...]  # the subject's point in the box
    guess: Sequence[arb]  # approximate unknowns of the equations there

    @property
    def cycle(self) -> ItineraryShape:
        """The orbit's cycle."""
        return self.subject.cycle

    def phases(self, number: Number) -> tuple[Phase, ...]:
        """The cycle's phases in numbers: matrices (N + 1, N + 1) and rows (1, N + 1).

        `number` maps exact entries to balls or Taylor models.
        """
        return phases_of(self.tables, self.cycle, number, self.closing.translations)

    def equations(self, number: Number) -> Equations:
        """The orbit's equations in its unknowns: start, forcing time and dwell times.

        `number` maps exact entries to balls or Taylor models.
        """
        period = None if self.closing.period is None else number(self.closing.period)
        return equations_in(self.phases(number), self.closing, number, period)

    def statement(self, orbit: Orbit) -> tuple[dict[str, Any], dict[str, Any]]:
        """Declaration and closing of an orbit as a file states them, each ready for JSON.

        Both are over the box's parameters and those that were given for the orbit.
        """
        subject, given = self.subject, given_of(orbit)
        names = (*self.names, *(name for name in given if name not in self.names))
        declared = orbit_declaration(
            subject.kernels,
            orbit.problem.kernels,
            self.cycle,
            names,
            subject.start_names,
            subject.dwell_names,
            irrational_texts(subject.kernels, given.values() if self.closing.form else ()),
        )
        variables = [*self.names, *(value.text for value in self.tables.constants)]
        period = orbit.problem.period_name or ""
        over = [*names, *declared.get("constants", ())]
        return declared, closing_json(self.closing, self.cycle, over, variables, period)


def given_of(orbit: Orbit) -> dict[str, Value]:
    """All parameters given for an orbit, and those that it leaves open."""
    return {**orbit.given, **orbit.opened}


def checked_box(orbit: Orbit, box: Mapping[str, tuple[object, object]]) -> dict[str, Interval]:
    """The box with exact lower and upper ends.

    `InputError` for an orbit that has not converged, names that were not given for it, ends that
    are not rational or in the wrong order, or a box without the orbit's own parameters.
    """
    check_converged(orbit, "certified")
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


def with_open_ones(orbit: Orbit, box: Mapping[str, Interval]) -> tuple[Orbit, tuple[str, ...]]:
    """The orbit with open parameters chosen large enough for a whole box, and their names.

    The bounds come from the orbit and from the corners of the box where it converges; nothing is
    proved of them. All values are checked in all corners: `InputError` if one is outside its
    domain there. `NotCovered` as from `subject_near`.
    """
    corners = [dict(zip(box, point, strict=True)) for point in product(*box.values())]
    chosen = chosen_parameters(orbit)
    if chosen:
        given = given_of(orbit)
        found = [
            solve(orbit.kernels, {**given, **corner}, orbit.unknowns, throw=False)
            for corner in corners
        ]
        near = [point for point in found if point.converged]
        chosen = chosen_parameters(orbit, near=near)
        orbit = replace(orbit, opened={**orbit.opened, **chosen})
    numbers, _ = _numbers(orbit, subject_near(orbit), tuple(box))
    try:
        for corner in corners:
            numbers({name: as_value(x) for name, x in corner.items()})
    except NotCovered as problem:
        raise InputError(str(problem)) from None
    return orbit, tuple(chosen)


def region_of(orbit: Orbit, box: Mapping[str, Interval]) -> Region:
    """The region of an orbit over a box that holds its parameters.

    `NotCovered` if a declaration takes roots or sines of the parameters, or as from
    `subject_near` and `closing_of`.
    """
    subject = subject_near(orbit)
    numbers, at = _numbers(orbit, subject, tuple(box))
    try:
        known, entries = entries_over(
            box, numbers, irrational_texts(subject.kernels, given_of(orbit).values())
        )
        period = entries.pop(PERIOD, None)
        tables = tables_over(subject.kernels, list(entries.values()), known)
        region = _region(subject, box, tables, at)
        if region.closing.kind == "period":
            region = replace(region, closing=replace(region.closing, period=period))
    except NotRational:
        raise NotCovered("the declaration takes a root or a sine of its parameters") from None
    except ArithmeticError as problem:
        raise NotCovered(str(problem)) from None
    return region


def region_at(subject: Subject, bits: int) -> Region:
    """The region of an orbit at its own parameter point: a box of no parameters.

    `bits` is the precision of the tables where the declaration takes a root or a sine.
    `NotCovered` as from `closing_of`.
    """
    tables = exact_tables(subject.kernels, tuple(subject.values.values()), bits)
    return _region(subject, {}, tables, ())


def _region(
    subject: Subject, box: Mapping[str, Interval], tables: Tables, at: Sequence[Fraction]
) -> Region:
    from flint import arb

    point = [arb(rational_of(x)) for x in at]
    closing = closing_of(subject, tables, [float(x) for x in subject.start], point)
    guess = guess_of(subject, closing, partial(tables.near, values=point))
    return Region(subject, tuple(box), tuple(box.values()), tables, closing, tuple(at), guess)


def _numbers(
    orbit: Orbit, subject: Subject, names: Sequence[str]
) -> tuple[Callable[[Mapping[str, Value]], dict[str, Value]], list[Fraction]]:
    """A function from a point to the system's parameters and period, and the orbit's own point."""
    given, problem = given_of(orbit), orbit.problem
    fixed = {**given, **chosen_parameters(orbit)}

    def numbers(point: Mapping[str, Value]) -> dict[str, Value]:
        told = {**fixed, **point}
        try:
            values = problem.system_values(told)
        except InputError as reason:
            raise NotCovered(str(reason)) from None
        if subject.period is None:
            return values
        return {**values, PERIOD: told[str(problem.period_name)]}

    at = [given[name].exact for name in names]
    if None in at:
        raise NotCovered("the orbit's own point of the box is irrational")
    return numbers, [x for x in at if x is not None]
