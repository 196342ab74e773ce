"""Orbits with kernels in files: what was given and solved for, by name.

An orbit that is read has to solve the equations of the kernels that are there.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.result_files import FileFormat
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.completion import check_relations, follow
from nonsmooth.runtime.model.kernels import OrbitKernels
from nonsmooth.runtime.model.parameters import in_domain
from nonsmooth.runtime.model.saved_system import SAVED_VERSION, SavedSystem, named, orbit_in
from nonsmooth.runtime.orbits.kernel_problem import kernel_problem
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.present.files.orbit_numbers import (
    bits_of,
    check_counts,
    number_text,
    read_number,
)

__all__ = ["KERNEL_ORBIT", "KernelOrbitEntries", "kernel_entries", "kernel_orbit"]


@dataclass(frozen=True, kw_only=True)
class KernelOrbitEntries:
    """Entries of the file of an orbit with kernels."""

    orbit: str
    tables: SavedSystem | None
    derivation: str
    given: Mapping[str, Value]
    opened: Mapping[str, Value]
    unknowns: Mapping[str, str]
    arithmetic: Literal["double", "mpmath"]
    bits: int
    residual: str
    digits: int
    iterations: int
    status: int


KERNEL_ORBIT = FileFormat(
    name="nonsmooth orbit",
    what="saved orbit",
    entries=KernelOrbitEntries,
    version=2 + SAVED_VERSION,
    most=50_000_000,
)
_SLACK = 100  # times the residual that the stated digits allow


def kernel_entries(orbit: Orbit) -> KernelOrbitEntries:
    """Entries of the file of a converged orbit that has kernels."""
    bits = max(map(bits_of, (*orbit.unknowns.values(), orbit.residual)))
    kernels = orbit.kernels
    _, name, saved = named(kernels.system, f"{kernels.system.name}:{kernels.orbit}")
    return KernelOrbitEntries(
        orbit=name if saved is not None else f"{kernels.system.name}/{kernels.orbit}",
        tables=saved,
        derivation=_derivation(kernels),
        given=orbit.given,
        opened=orbit.opened,
        unknowns={name: number_text(number, bits) for name, number in orbit.unknowns.items()},
        arithmetic="mpmath" if orbit.precise else "double",
        bits=bits,
        residual=number_text(orbit.residual, bits),
        digits=orbit.digits,
        iterations=orbit.iterations,
        status=orbit.status,
    )


def kernel_orbit(entries: KernelOrbitEntries) -> Orbit:
    """The orbit that a file's entries describe, with the same numbers.

    `InputError` is raised if these are no orbit, or not this one with the installed
    kernels.
    """
    kernels = orbit_in(entries.orbit, entries.tables)
    _check_names(kernels, entries)
    check_counts(entries)
    bits = None if entries.arithmetic == "double" else entries.bits
    orbit = Orbit(
        kernel_problem(kernels),
        entries.given,
        {name: read_number(name, text, bits) for name, text in entries.unknowns.items()},
        entries.opened,
        read_number("residual", entries.residual, bits),
        entries.digits,
        entries.iterations,
        entries.status,
    )
    _check_domains(orbit)
    if not _solves(orbit):
        raise InputError(
            f"not a solution of {kernels.name} to {orbit.digits} digits with the kernels that are"
            f" installed (its derivation {entries.derivation}, here {_derivation(kernels)})"
        )
    return orbit


def _derivation(kernels: OrbitKernels) -> str:
    return str(kernels.system.module.DERIVATION)


def _check_names(kernels: OrbitKernels, entries: KernelOrbitEntries) -> None:
    known = sorted([*kernels.parameter_names, *kernels.unknowns])
    found = sorted([*entries.given, *entries.unknowns])
    fixed = {*kernels.parameter_names, *kernels.required, *kernels.solved_for}
    opened = [name for name in kernels.tables if name not in fixed]
    if found != known or len(entries.unknowns) != len(kernels.unknowns):
        raise InputError(
            f"{kernels.name} has {', '.join(known)}, the file has {', '.join(found) or 'nothing'}"
        )
    for name in entries.opened:
        if name not in opened:
            raise unknown_name("open parameter", name, opened)


def _check_domains(orbit: Orbit) -> None:
    kernels = orbit.kernels
    check_relations(kernels, {**orbit.given, **orbit.opened})
    values = {name: float(x) for name, x in {**orbit.values, **orbit.opened}.items()}
    values |= follow(kernels, values)
    for table in kernels.tables.values():
        if table.name in values and not in_domain(table, values[table.name]):
            raise InputError(f"{table.name} is outside its domain")
    for name, duration in zip(orbit.dwell_time_names, orbit.dwell_times, strict=True):
        if not duration >= 0:
            raise InputError(f"dwell time {name} is negative")


def _solves(orbit: Orbit) -> bool:
    """Whether the equations hold as well as the digits of the unknowns allow.

    An error of 10^-digits max(1, |x|) in each number x moves an equation by at most the sum
    of these errors, times the absolute values of its derivatives.
    """
    rough = replace(orbit, unknowns={n: float(x) for n, x in orbit.unknowns.items()})
    names = (*orbit.kernels.unknowns, *orbit.kernels.parameter_names)
    scale = np.array([max(1.0, abs(rough.values[name])) for name in names])
    unit = 10**orbit.digits
    try:
        with np.errstate(all="ignore"):
            derivatives = np.hstack(rough.evaluate("jacobian", "parameter_jacobian"))
            bounds = [float(bound) for bound in _SLACK * np.abs(derivatives) @ scale]
            sizes = [abs(r) * unit for r in orbit.evaluate("residual")]
    except ArithmeticError:
        return False
    return all(math.isfinite(b) and s <= b for s, b in zip(sizes, bounds, strict=True))
