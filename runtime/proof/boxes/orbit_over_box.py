"""An orbit over a box of parameters: the system's numbers are rational functions of them."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import product
from typing import Any

from flint import arb

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.values import Value, as_value, axes
from nonsmooth.runtime.orbits.kernel_problem import chosen_parameters
from nonsmooth.runtime.orbits.orbit import Orbit, check_converged
from nonsmooth.runtime.orbits.solve import solve
from nonsmooth.runtime.proof.boxes.tile_places import Interval
from nonsmooth.runtime.proof.exact_tables import (
    NotRational,
    Tables,
    exact_tables,
    rational_of,
    tables_over,
)
from nonsmooth.runtime.proof.orbit_to_prove import (
    ClosureConditions,
    NotCovered,
    Subject,
    closing_of,
    guess_of,
    subject_near,
)
from nonsmooth.runtime.proof.statement import closing_json, declaration_json


@dataclass(frozen=True, eq=False)
class Region:
    """What is to be proved of an orbit for all parameters of a box; a point is a box of none."""

    subject: Subject  # the orbit at one point of the box
    names: tuple[str, ...]  # of the box's parameters
    box: tuple[Interval, ...]  # lower and upper end of each parameter
    tables: Tables  # irrational parameters follow the box's in the rational functions
    closing: ClosureConditions
    at: tuple[Fraction, ...]  # the subject's point in the box
    guess: Sequence[arb]  # approximate unknowns of the equations there

    def statement(self, orbit: Orbit) -> tuple[dict[str, Any], dict[str, Any]]:
        """Declaration and closing of an orbit as a file states them, each ready for JSON.

        Both are over the box's parameters and those that were given for the orbit.
        """
        subject, given = self.subject, given_of(orbit)
        names = (*self.names, *(name for name in given if name not in self.names))
        beside, orbit_kernels = given.values() if self.closing.form else (), orbit.problem.kernels
        tables = tables_over(subject.kernels, names, beside=beside, orbit=orbit_kernels)
        declared = declaration_json(
            tables, subject.cycle, names, subject.start_names, subject.dwell_names
        )
        variables = [*self.names, *(value.text for value in self.tables.constants)]
        period = orbit.problem.period_name or ""
        over = [*names, *declared.get("constants", ())]
        return declared, closing_json(self.closing, subject.cycle, over, variables, period)


def given_of(orbit: Orbit) -> dict[str, Value]:
    """All parameters given for an orbit, and those that it leaves open."""
    return {**orbit.given, **orbit.opened}


def stated_orbits(
    orbit: Orbit, names: Collection[str], chosen: tuple[str, ...], region: Region | None
) -> dict[str, Any]:
    """The entries of `StatedOrbits` for orbits like one, over parameters that have no one value.

    `region` is None where these orbits are not covered.
    """
    declaration, closing = ({}, {}) if region is None else region.statement(orbit)
    return {
        "orbit": orbit.name,
        "system": orbit.system.name,
        "parameters": {n: value for n, value in given_of(orbit).items() if n not in names},
        "chosen": chosen,
        "itinerary": () if region is None else region.subject.cycle.itinerary,
        "declaration": declaration,
        "closing": closing,
    }


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
        if axes(ends) != 1 or len(ends) != 2:
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
    subject_near(orbit)
    for corner in corners:
        values = {name: as_value(x) for name, x in corner.items()}
        orbit.problem.system_values({**given_of(orbit), **chosen_parameters(orbit), **values})
    return orbit, tuple(chosen)


def region_of(orbit: Orbit, box: Mapping[str, Interval]) -> Region:
    """The region of an orbit over a box that holds its parameters.

    `NotCovered` if a declaration takes roots or sines of the parameters, or as from
    `subject_near` and `closing_of`.
    """
    subject = subject_near(orbit)
    given = {**given_of(orbit), **chosen_parameters(orbit)}
    at = [given[name].exact for name in box]
    if None in at:
        raise NotCovered("the orbit's own point of the box is irrational")
    try:
        fixed = {name: value for name, value in given.items() if name not in box}
        tables = tables_over(subject.kernels, box, fixed, orbit=orbit.problem.kernels)
    except NotRational:
        raise NotCovered("the declaration takes a root or a sine of its parameters") from None
    except ArithmeticError as problem:
        raise NotCovered(str(problem)) from None
    return _region(subject, box, tables, [x for x in at if x is not None])


def region_at(subject: Subject, bits: int) -> Region:
    """The region of an orbit at its own parameter point: a box of no parameters.

    `bits` is the precision of the tables where the declaration takes a root or a sine.
    `NotCovered` as from `closing_of`.
    """
    tables = exact_tables(subject.kernels, subject.values, bits)
    return _region(subject, {}, tables, ())


def _region(
    subject: Subject, box: Mapping[str, Interval], tables: Tables, at: Sequence[Fraction]
) -> Region:
    point = [arb(rational_of(x)) for x in at]
    closing, guess = closing_of(subject, tables, point), guess_of(subject, tables, point)
    return Region(subject, tuple(box), tuple(box.values()), tables, closing, tuple(at), guess)
