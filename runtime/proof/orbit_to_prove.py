"""What is to be proved: an orbit as a cycle in physical coordinates, and how it closes.

An autonomous dissipative cycle closes by its state. Of a conservative one the period is
given, and one coordinate's closure is dropped: it follows from the energy. A forced one is a
function of time: the forcing's states are cos(w t) and sin(w t) at an unknown time, and a
whole number of the forcing's periods passes.

Of a conservative cycle there is a nondegenerate skew form Omega and an energy E_c of each
configuration with Omega f_c = grad E_c, each transition keeps the energy on its boundary and Omega
on the tangents of its boundary. Hence the monodromy matrix is symplectic: the saltation maps the
field in front to that behind. Both are found by exact arithmetic, for the checker to verify.

Where nothing depends on some direction, a rotor's angle, a cycle closes up to a shift along it.

Over a box of parameters the system's numbers are rational functions of them.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial
from typing import Any

from flint import arb, fmpq

from nonsmooth.runtime.checker.stated.exact import Elimination, Entries, form_between, products
from nonsmooth.runtime.core.arithmetic import exact_ball
from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.values import Value, as_value, axes
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.kernel_problem import chosen_parameters
from nonsmooth.runtime.orbits.orbit import Orbit, check_converged
from nonsmooth.runtime.orbits.solve import solve
from nonsmooth.runtime.proof.boxes.tile import Interval
from nonsmooth.runtime.proof.statement import (
    Matrix,
    NotRational,
    Row,
    Tables,
    closing_json,
    declaration_json,
    exact_tables,
    rational_of,
    tables_over,
)
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape, itinerary_shape
from nonsmooth.runtime.shooting.translations import translations_of

_MOST_TURNS = 1000


class NotCovered(Exception):
    """The method cannot be applied; the message is the reason."""


@dataclass(frozen=True, eq=False)
class Subject:
    """An orbit that is to be proved: its system, parameters and cycle, and about where it is."""

    label: str
    kernels: SystemKernels
    values: dict[str, Value]  # all parameters of the system
    chosen: tuple[str, ...]  # parameters that the orbit leaves open and that were chosen
    cycle: ItineraryShape
    period: Value | None  # where it was given
    start: list[arb]  # exact numbers of which nothing is proved
    dwell: list[arb]  # exact numbers of which nothing is proved
    start_names: tuple[str, ...]
    dwell_names: tuple[str, ...]

    @property
    def unknown_names(self) -> tuple[str, ...]:
        """Names of the equations' unknowns: free states, the forcing's time, dwell times."""
        forced = self.cycle.structure.forced
        free = [name for k, name in enumerate(self.start_names) if k not in forced]
        return (*free, *(["forcing time"] if forced else []), *self.dwell_names)


def subject_near(orbit: Orbit) -> Subject:
    """Return the subject of a proof about an orbit.

    `NotCovered` is raised if a parameter is an unknown of the orbit, or if the system's parameters
    do not follow from it.
    """
    problem = orbit.problem
    solved_for = ", ".join(name for name in orbit.unknowns if name in problem.all_parameters)
    if solved_for and not orbit.dwell_times.all():
        raise NotCovered(
            f"{orbit.name} is a border collision: {solved_for} has no exact value at it"
        )
    if solved_for:
        raise NotCovered(f"{solved_for} was solved for and has no exact value")
    try:
        point = problem.physical(orbit)
    except InputError as reason:
        raise NotCovered(str(reason)) from None
    return Subject(
        orbit.name,
        orbit.system,
        point.values,
        point.chosen,
        itinerary_shape(structure_of(orbit.system), orbit.itinerary),
        problem.period(orbit),
        [exact_ball(x) for x in problem.system_start(orbit, point.values)],
        [exact_ball(x) for x in orbit.dwell_times.tolist()],
        problem.start_names,
        problem.dwell_time_names,
    )


def guess_of(subject: Subject, tables: Tables, at: Sequence[Any] = ()) -> list[arb]:
    """Return the unknowns of the equations, about: free states, the forcing's time, dwell times.

    `at` holds the values at the orbit of what the tables are functions of.
    """
    structure = subject.cycle.structure
    pairs = structure.forcing
    if not pairs:
        return [*subject.start, *subject.dwell]
    start = [float(x) for x in subject.start]
    field = tables.fields[subject.cycle.configurations[0]]
    speeds = [tables.near(field[s][c], at) for c, s in pairs]
    angles = [math.atan2(start[s], start[c]) for c, s in pairs]

    def missed(time: float) -> float:
        return sum(
            1 - math.cos(speed * time - angle) for speed, angle in zip(speeds, angles, strict=True)
        )

    times = [(angles[0] + 2 * math.pi * k) / speeds[0] for k in range(_MOST_TURNS)]
    time = times[0] if len(speeds) == 1 else min(times, key=missed)
    free = [x for k, x in enumerate(subject.start) if k not in structure.forced]
    return [*free, arb(time), *subject.dwell]


@dataclass(frozen=True, eq=False)
class SymplecticForm:
    """A skew form Omega (N, N) and the energies E_c = (y, 1) H_c (y, 1) / 2 of configurations."""

    omega: Matrix
    constants: dict[int, Any]  # last diagonal entry of H_c, by visited configuration
    energies: dict[int, Matrix]  # H_c, by configuration


def symplectic_form(tables: Tables, cycle: ItineraryShape) -> SymplecticForm | None:
    """Return a nondegenerate form and energies that a cycle keeps exactly, or None."""
    size = len(tables.fields[0]) - 1
    visited = sorted(set(cycle.configurations))
    pairs = [(i, j) for i in range(size) for j in range(i)]
    count = len(pairs) + len(visited)
    columns = []
    for place in range(count):
        values = [fmpq(int(k == place)) for k in range(count)]
        columns.append(_missed(tables, cycle, _form(tables, visited, pairs, values)))
    kernel = Elimination().left_kernel(columns)
    values = [
        sum((fmpq(k + 1) * row[j] for k, row in enumerate(kernel)), fmpq(0)) for j in range(count)
    ]
    form = _form(tables, visited, pairs, values)
    return None if Elimination().left_kernel(form.omega) else form


def _form(
    tables: Tables, visited: Sequence[int], pairs: Sequence[tuple[int, int]], values: Sequence[Any]
) -> SymplecticForm:
    """Return the form of given entries, with the matrices of the energies that follow from it."""
    size = len(tables.fields[0]) - 1
    entries: list[list[Any]] = [[fmpq(0)] * size for _ in range(size)]
    for (i, j), value in zip(pairs, values, strict=False):
        entries[i][j], entries[j][i] = value, -value
    omega: Matrix = tuple(map(tuple, entries))
    constants = dict(zip(visited, values[len(pairs) :], strict=True))
    energies: dict[int, Matrix] = {}
    for configuration in visited:
        upper = products(omega, tables.fields[configuration][:-1])
        below = (*(row[-1] for row in upper), constants[configuration])
        energies[configuration] = (*upper, below)
    return SymplecticForm(omega, constants, energies)


def _missed(tables: Tables, cycle: ItineraryShape, form: SymplecticForm) -> list[Any]:
    """Return what a form misses of being kept, linear in its entries: zero if it is kept."""
    missed: list[Any] = []
    for energy in form.energies.values():
        missed += _difference(energy, _transposed(energy))
    count = len(cycle)
    for place, transition in enumerate(cycle.transitions):
        before = cycle.configurations[place]
        after = cycle.configurations[(place + 1) % count]
        row = tables.rows[cycle.rows[place]]
        reset = tables.resets[transition.reset]
        on = Elimination().left_kernel([[entry] for entry in row])
        missed += _difference(
            form_between(form_between(form.energies[after], _transposed(reset)), on),
            form_between(form.energies[before], on),
        )
        linear = tuple(r[:-1] for r in reset[:-1])
        along = Elimination().left_kernel([[entry] for entry in row[:-1]])
        missed += _difference(
            form_between(form_between(form.omega, _transposed(linear)), along),
            form_between(form.omega, along),
        )
    return missed


def _transposed(rows: Sequence[Row]) -> Matrix:
    return tuple(zip(*rows, strict=True))


def _difference(left: Sequence[Row], right: Sequence[Row]) -> list[Any]:
    return [x - y for a, b in zip(left, right, strict=True) for x, y in zip(a, b, strict=True)]


_LARGEST_DENOMINATOR = 10**6  # of a direction
_NEARLY = 1 - 1e-9  # of the largest: as large


@dataclass(frozen=True)
class ClosureConditions:
    """How a cycle closes: by its state, by a given period and the energy, or by the forcing."""

    kind: str  # "state", "period" or "forcing"
    dropped: int = -1  # coordinate whose closure follows from the energy; -1 for none
    form: SymplecticForm | None = None
    turns: int = 0  # turns of the first forcing in one period
    # directions along which nothing changes, in echelon form; the cycle closes up to these
    translations: tuple[Row, ...] = ()

    @property
    def stability(self) -> str:
        """The stability that is claimed: "stable", or "neutral" for a conservative orbit."""
        return "stable" if self.form is None else "neutral"


def closing_of(subject: Subject, tables: Tables, at: Sequence[Any] = ()) -> ClosureConditions:
    """Return how the subject's cycle closes: by the forcing, by the state, or by period and energy.

    `at` holds the values at the orbit of what the tables are functions of. `NotCovered` is raised
    if the cycle closes in another way, or if its numbers are not rational where they have to be.
    """
    cycle, near = subject.cycle, partial(tables.near, values=at)
    shifts = tuple(
        tuple(rational_of(Fraction(x).limit_denominator(_LARGEST_DENOMINATOR)) for x in direction)
        for direction in translations_of(piecewise(subject.kernels, subject.values)).tolist()
    )
    if cycle.structure.forcing:
        cosine, sine = cycle.structure.forcing[0]
        speed = near(tables.fields[cycle.configurations[0]][sine][cosine])
        total = float(sum(float(t) for t in subject.dwell))
        turns = max(1, round(speed * total / (2 * math.pi)))
        return ClosureConditions("forcing", turns=turns, translations=shifts)
    if shifts and subject.period is not None:
        raise NotCovered("it is periodic up to a shift, and of a family that a period singles out")
    if subject.period is None:
        return ClosureConditions("state", translations=shifts)
    if not tables.exact:
        raise NotCovered("the parameters of a conservative system have to be rational")
    form = symplectic_form(tables, cycle)
    if form is None:
        raise NotCovered("no energy was found that the cycle keeps, so its period cannot be given")
    energy = form.energies[cycle.configurations[0]]
    start = [float(x) for x in subject.start]
    slopes = [
        sum(near(x) * y for x, y in zip(row[:-1], start, strict=True)) + near(row[-1])
        for row in energy[:-1]
    ]
    if not all(map(math.isfinite, slopes)):
        raise NotCovered("the slopes of its energy are not finite where it starts")
    # the first of those that are as large but for rounding, in whatever arithmetic it is
    least = _NEARLY * max(abs(slope) for slope in slopes)
    largest = next(i for i, slope in enumerate(slopes) if abs(slope) >= least)
    return ClosureConditions("period", dropped=largest, form=form)


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

    def statement(self, orbit: Orbit) -> tuple[Entries, Entries]:
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
) -> Entries:
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
    corners = [dict(zip(box, point, strict=True)) for point in itertools.product(*box.values())]
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
