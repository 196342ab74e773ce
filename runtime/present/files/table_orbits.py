"""Orbits by the tables of their system in files: dwell time and start of each phase.

A phase's start, its dwell time and the next phase's start are compared one phase at a time:
an orbit that is read has to be one of the system that is there.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import BlankText, BlankValue
from nonsmooth.runtime.core.result_files import FileFormat
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.completion import system_parameters
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.model.saved_system import SAVED_VERSION, SavedSystem, named, system_in
from nonsmooth.runtime.orbits.orbit import DOUBLE, Orbit
from nonsmooth.runtime.orbits.problem import OrbitProblem, orbit_of
from nonsmooth.runtime.orbits.routes import with_routes_at
from nonsmooth.runtime.present.files.orbit_numbers import (
    bits_of,
    check_counts,
    number_text,
    read_number,
)
from nonsmooth.runtime.shooting.shooting_map import numbers_in
from nonsmooth.runtime.shooting.symmetry import symmetry_of
from nonsmooth.runtime.shooting.translations import projection_along

__all__ = ["TABLE_ORBIT", "TableOrbitEntries", "check_solves", "table_entries", "table_orbit"]


@dataclass(frozen=True, kw_only=True)
class PhaseEntries:
    """Entries for a phase of an orbit: its boundary, its dwell time, and where it starts."""

    configuration: str
    boundary: str
    dwell_time: str
    start: tuple[str, ...]


@dataclass(frozen=True, kw_only=True)
class TableOrbitEntries:
    """Entries of the file of an orbit; numbers have as many digits as `bits` need."""

    system: str
    tables: SavedSystem | None
    label: BlankText
    derivation: str
    parameters: Mapping[str, Value]
    period: BlankValue
    symmetry: tuple[tuple[float, ...], ...]
    phases: tuple[PhaseEntries, ...]
    names: tuple[str, ...]
    arithmetic: Literal["double", "mpmath"]
    bits: int
    residual: str
    digits: int
    iterations: int
    status: int


TABLE_ORBIT = FileFormat(
    name="nonsmooth composed orbit",
    what="saved orbit",
    entries=TableOrbitEntries,
    version=2 + SAVED_VERSION,
    most=50_000_000,
)
_SLACK = 100  # times the error that the stated digits allow
_MOST_MISSED = 1e-9  # the solver's residual, in units of the data


def table_entries(orbit: Orbit) -> TableOrbitEntries:
    """Entries of the file of a converged orbit that was solved with its system's tables."""
    problem = orbit.problem
    dwell, states = orbit.dwell_times.tolist(), orbit.states.tolist()
    bits = max(map(bits_of, (*dwell, *(x for row in states for x in row), orbit.residual)))
    system, label, saved = named(orbit.system, problem.label or "")
    phases = tuple(
        PhaseEntries(
            configuration=configuration,
            boundary=boundary,
            dwell_time=number_text(time, bits),
            start=tuple(number_text(x, bits) for x in row),
        )
        for (configuration, boundary), time, row in zip(orbit.itinerary, dwell, states, strict=True)
    )
    return TableOrbitEntries(
        system=system,
        tables=saved,
        label=label or None,
        derivation=_derivation(orbit.system),
        parameters=orbit.parameters,
        period=orbit.given_period,
        symmetry=() if orbit.symmetry is None else orbit.symmetry.matrix.tolist(),
        phases=phases,
        names=problem.names,
        arithmetic="mpmath" if orbit.precise else "double",
        bits=bits,
        residual=number_text(orbit.residual, bits),
        digits=orbit.digits,
        iterations=orbit.iterations,
        status=orbit.status,
    )


def table_orbit(entries: TableOrbitEntries) -> Orbit:
    """The orbit that a file's entries describe, with the same numbers.

    `InputError` is raised if the system is not installed, or if this is no orbit of it.
    """
    kernels = system_in(entries.system, entries.tables)
    check_counts(entries)
    bits = None if entries.arithmetic == "double" else entries.bits
    parameters = system_parameters(kernels, entries.parameters)
    phases, size = entries.phases, len(kernels.table["states"])
    if not phases:
        raise InputError("'phases' is empty")
    if any(len(phase.start) != size for phase in phases):
        raise InputError(f"{kernels.name} has {size} states, and the file another number")
    names = entries.names
    if len(names) not in (0, len(phases) + size):
        raise InputError(f"'names' does not hold {len(phases) + size} names, or none")
    dwell = [read_number("dwell_time", phase.dwell_time, bits) for phase in phases]
    states = [[read_number("start", text, bits) for text in phase.start] for phase in phases]
    kind = float if bits is None else object
    symmetry = None
    if entries.symmetry:
        symmetry = symmetry_of(piecewise(kernels, parameters), entries.symmetry)
    itinerary = tuple((phase.configuration, phase.boundary) for phase in phases)
    point = piecewise(kernels, parameters)
    kernels = with_routes_at(kernels, point, itinerary, np.array(dwell), np.array(states))
    orbit = orbit_of(
        OrbitProblem(kernels, itinerary, symmetry, entries.label, names),
        parameters,
        entries.period,
        np.array(dwell, dtype=kind),
        np.array(states, dtype=kind),
        read_number("residual", entries.residual, bits),
        entries.digits,
        entries.iterations,
        entries.status,
    )
    if symmetry is not None and len(phases) % symmetry.order:
        raise InputError("its phases are no multiple of those that the symmetry closes")
    check_solves(orbit, f" (its derivation {entries.derivation}, here {_derivation(kernels)})")
    return orbit


def check_solves(orbit: Orbit, which: str = "") -> None:
    """Raise `InputError` unless an orbit of a file is one of the installed system.

    The orbit is one by tables. It is refused if a dwell time is not positive, or if the
    equations are not solved; `which` says something about the kernels in the message.
    """
    if not (orbit.dwell_times > 0).all():
        raise InputError("a dwell time is not positive")
    if not _solves(orbit):
        raise InputError(
            f"not a solution of {orbit.system.name} to {orbit.digits} digits with the kernels that"
            f" are installed{which}"
        )


def _derivation(kernels: SystemKernels) -> str:
    return str(kernels.module.DERIVATION)


def _solves(orbit: Orbit) -> bool:
    """Whether each phase ends on its boundary, and the next begins where its reset leads.

    An error of 10^-digits max(1, |x|) in each number x moves these by at most the sum of
    these errors times the absolute values of the derivatives.
    """
    tables, lib = orbit.tables, orbit.arithmetic.mp
    numbers, cycle = numbers_in(tables.piecewise), tables.cycle
    unit = lib.mpf(10) ** -orbit.digits if orbit.precise else 10.0**-DOUBLE
    missed = 2 * abs(orbit.residual)
    size = orbit.states.shape[1]
    flows = tables.shooting.flows
    following = np.roll(orbit.states, -1, axis=0)
    projection = projection_along(tables.translations)
    for place, (start, end_start) in enumerate(zip(orbit.states, following, strict=True)):
        flow, row = flows[place], numbers.rows[cycle.rows[place]]
        reset = numbers.resets[cycle.transitions[place].reset]
        field = numbers.fields[cycle.configurations[place]]
        end = flow[:, :size] @ start + flow[:, size]
        speed = field[:, :size] @ end + field[:, size]
        scale = np.maximum(1, abs(start))
        reach = abs(flow[:, :size]) @ scale + abs(flow[:, size])
        moved = reach + abs(speed) * max(1, abs(orbit.dwell_times[place]))
        gap, terms = row[:size] @ end + row[size], abs(row[:size]) @ moved + abs(row[size])
        jump = reset[:, :size] @ end + reset[:, size] - end_start
        if place == len(cycle) - 1:
            jump = projection @ jump
        sizes = abs(reset[:, :size]) @ moved + abs(reset[:, size]) + np.maximum(1, abs(end_start))
        if not missed <= _MOST_MISSED * max(terms, max(sizes)):
            return False
        if not abs(gap) <= _SLACK * unit * terms + missed:
            return False
        if not (abs(jump) <= _SLACK * unit * sizes + missed).all():
            return False
    return True
