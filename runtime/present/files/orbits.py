"""Orbits in files: JSON with every digit, refused when it is cut, edited or foreign.

Numbers are decimal strings that give back the very same double or mpmath number; given
values are kept as they were written. A checksum covers the content, and an orbit that is
read has to solve the equations of the kernels that are there.
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import dataclass, replace
from decimal import Decimal, InvalidOperation
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.files import read_file
from nonsmooth.runtime.core.result_files import FileFormat, naming, parsed
from nonsmooth.runtime.core.values import Value, decimal_string
from nonsmooth.runtime.model.completion import check_relations, follow
from nonsmooth.runtime.model.kernels import OrbitKernels, load_orbit
from nonsmooth.runtime.model.parameters import in_domain
from nonsmooth.runtime.orbits.orbit import DOUBLE, Orbit
from nonsmooth.runtime.orbits.refine import MOST_DIGITS
from nonsmooth.runtime.shooting.newton import CONVERGED

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.composed_orbit import ComposedOrbit
    from nonsmooth.runtime.present.files.composed_orbits import ComposedEntries

__all__ = [
    "ORBIT",
    "OrbitEntries",
    "bits_of",
    "check_counts",
    "load_orbit_file",
    "number_text",
    "orbit_content",
    "orbit_of",
    "read_number",
    "save_orbit",
]


@dataclass(frozen=True, kw_only=True)
class OrbitEntries:
    """What an orbit's file holds; numbers have as many digits as `bits` need."""

    orbit: str
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


ORBIT = FileFormat(
    name="nonsmooth orbit", what="saved orbit", entries=OrbitEntries, most=50_000_000
)
_DOUBLE_BITS = 53
_MOST_BITS = 8 * MOST_DIGITS
_LARGEST_EXPONENT, _LEAST_EXPONENT = 308, -10 * MOST_DIGITS  # decimal
_SLACK = 100  # times the residual that the stated digits allow


def save_orbit(orbit: Orbit, path: str | os.PathLike[str]) -> None:
    """Write an orbit to a file; what was there stays until the new content is complete.

    Parameters
    ----------
    orbit : Orbit
        A converged one; floats and mpmath numbers come back as they are.
    path : str or path
        A JSON file; its folder has to exist.

    Raises
    ------
    InputError
        If the orbit has not converged or the file cannot be written.
    """
    ORBIT.write(path, _entries(orbit))


def orbit_content(orbit: Orbit) -> dict[str, Any]:
    """What is in an orbit's file; InputError if it has not converged."""
    return ORBIT.content(_entries(orbit))


def _entries(orbit: Orbit) -> OrbitEntries:
    if not orbit.converged:
        raise InputError(f"{orbit.name} is not saved: {orbit.message}")
    bits = max(map(bits_of, (*orbit.unknowns.values(), orbit.residual)))
    return OrbitEntries(
        orbit=orbit.name,
        derivation=_derivation(orbit.kernels),
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


def load_orbit_file(path: str | os.PathLike[str]) -> Orbit | ComposedOrbit:
    """Read an orbit that `Orbit.save` or `ComposedOrbit.save` wrote.

    Kernels of another derivation are accepted if they have the same unknowns and parameters
    and the orbit solves their equations.

    Parameters
    ----------
    path : str or path

    Returns
    -------
    Orbit or ComposedOrbit
        With every digit that was saved.

    Raises
    ------
    InputError
        If the file cannot be read, is cut, edited or foreign, or holds what is no orbit of
        the kernels that are installed. The message names the file.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> ns.solve("dry-friction/global-stick").save("orbit.json")
    >>> ns.load("orbit.json").converged
    True
    """
    with naming(path) as file:
        return orbit_of(parsed(read_file(file, ORBIT.most, ORBIT.what)), file.parent)


def orbit_of(content: Any, folder: Path) -> Orbit | ComposedOrbit:
    """The orbit that the entries of a file in a folder describe, of one of the two formats.

    Raises
    ------
    InputError
        As for `load_orbit_file`, without the name of a file.
    """
    from nonsmooth.runtime.present.files.composed_orbits import COMPOSED, composed_orbit

    if isinstance(content, dict) and content.get("format") == COMPOSED.name:
        return composed_orbit(COMPOSED.check(content), folder)
    return _orbit(ORBIT.check(content), folder)


def bits_of(number: Any) -> int:
    """Precision of a number: of a double, or of the mpmath context that made it."""
    if isinstance(number, float):
        return _DOUBLE_BITS
    return max(int(number.man_exp[0]).bit_length(), int(number.context.prec))


def number_text(number: Any, bits: int) -> str:
    """Decimal text that determines a number of so many bits."""
    if isinstance(number, float):
        return float.__repr__(number)
    return decimal_string(number, math.ceil(bits * math.log10(2)))


def _orbit(entries: OrbitEntries, folder: Path) -> Orbit:
    """The orbit that a file's entries describe, checked against the kernels."""
    kernels = load_orbit(entries.orbit, folder)
    _check_names(kernels, entries)
    check_counts(entries)
    bits = None if entries.arithmetic == "double" else entries.bits
    orbit = Orbit(
        kernels.name,
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


def _check_names(kernels: OrbitKernels, entries: OrbitEntries) -> None:
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


def check_counts(entries: OrbitEntries | ComposedEntries) -> None:
    """Refuse counts of bits, digits and iterations, that no orbit has."""
    double = entries.arithmetic == "double"
    allowed = {
        "bits": (_DOUBLE_BITS, _DOUBLE_BITS if double else _MOST_BITS),
        "digits": (0, DOUBLE if double else MOST_DIGITS),
        "iterations": (0, math.inf),
        "status": (CONVERGED, CONVERGED),
    }
    for name, (least, most) in allowed.items():
        count = getattr(entries, name)
        if not least <= count <= most:
            raise InputError(f"{name} is {count}, which no saved orbit has")


def read_number(name: str, text: str, bits: int | None) -> Any:
    """The double, or the mpmath number of so many bits, nearest to a decimal text."""
    try:
        decimal = Decimal(text)
    except InvalidOperation:
        raise InputError(f"{name} is not a decimal number") from None
    if not decimal.is_finite():
        raise InputError(f"{name} is {text}, not a finite number")
    if decimal and not _LEAST_EXPONENT <= decimal.adjusted() < _LARGEST_EXPONENT:
        raise InputError(f"{name} is too large or too small")
    if bits is None:
        return float(text)
    from mpmath import MPContext, libmp

    context = MPContext()
    context.prec = bits
    return context.make_mpf(libmp.from_rational(*decimal.as_integer_ratio(), bits, "n"))


def _check_domains(orbit: Orbit) -> None:
    kernels = orbit.kernels
    check_relations(kernels, {**orbit.given, **orbit.opened})
    values = {name: float(x) for name, x in {**orbit.values, **orbit.opened}.items()}
    values |= follow(kernels, values)
    for table in kernels.tables.values():
        if table.name in values and not in_domain(table, values[table.name]):
            raise InputError(f"{table.name} is outside its domain")
    for name, duration in orbit.dwell_times.items():
        if not duration >= 0:
            raise InputError(f"dwell time {name} is negative")


def _solves(orbit: Orbit) -> bool:
    """Whether the equations hold as well as the digits of the unknowns allow.

    An error of 10^-digits max(1, |x|) in each number x moves an equation by at most the sum
    of these, times the absolute values of its derivatives.
    """
    rough = replace(orbit, unknowns={n: float(x) for n, x in orbit.unknowns.items()})
    names = (*orbit.kernels.unknowns, *orbit.kernels.parameter_names)
    scale = np.array([max(1.0, abs(rough.values[name])) for name in names])
    unit = 10**orbit.digits
    try:
        with np.errstate(all="ignore"):
            derivatives = np.hstack(
                [rough.evaluate("jacobian"), rough.evaluate("parameter_jacobian", moved=True)]
            )
            bounds = [float(bound) for bound in _SLACK * np.abs(derivatives) @ scale]
            sizes = [abs(r) * unit for r in orbit.evaluate("residual")]
    except ArithmeticError:
        return False
    return all(math.isfinite(b) and s <= b for s, b in zip(sizes, bounds, strict=True))
