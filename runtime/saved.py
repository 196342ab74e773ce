"""Orbits in files: JSON with every digit, refused when it is cut, edited or foreign.

Numbers are decimal strings that give back the very same double or mpmath number; given
values are kept as they were written. A checksum covers the content, and an orbit that is
read has to solve the equations of the kernels that are there.
"""

from __future__ import annotations

import hashlib
import json
import math
import os
from collections.abc import Mapping
from dataclasses import replace
from decimal import Decimal, InvalidOperation
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.errors import InputError, unknown_name
from nonsmooth.runtime.files import read_file, write_file
from nonsmooth.runtime.kernels import OrbitKernels, load_orbit
from nonsmooth.runtime.newton import CONVERGED
from nonsmooth.runtime.orbit import DOUBLE, Orbit
from nonsmooth.runtime.parameters import in_domain
from nonsmooth.runtime.refine import MOST_DIGITS
from nonsmooth.runtime.values import LONGEST_TEXT, Value, as_value, decimal_string, parse

if TYPE_CHECKING:
    from nonsmooth.runtime.composition.record import ComposedOrbit

__all__ = [
    "FORMAT",
    "VERSION",
    "bits_of",
    "check_counts",
    "check_entries",
    "check_fields",
    "checksum_of",
    "given_value",
    "load_orbit_file",
    "number_text",
    "orbit_content",
    "orbit_of",
    "parsed",
    "read_number",
    "save_orbit",
    "write_content",
]

FORMAT = "nonsmooth orbit"
VERSION = 1

_FIELDS: dict[str, type] = {
    "format": str,
    "version": int,
    "package": str,
    "orbit": str,
    "derivation": str,
    "given": dict,
    "opened": dict,
    "unknowns": dict,
    "arithmetic": str,
    "bits": int,
    "residual": str,
    "digits": int,
    "iterations": int,
    "status": int,
    "sha256": str,
}
_LARGEST_FILE = 50_000_000  # bytes
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
    write_content(Path(path), orbit_content(orbit))


def orbit_content(orbit: Orbit) -> dict[str, Any]:
    """Entries of an orbit's file; InputError if it has not converged."""
    from importlib.metadata import version

    if not orbit.converged:
        raise InputError(f"{orbit.name} is not saved: {orbit.message}")
    bits = max(map(bits_of, (*orbit.unknowns.values(), orbit.residual)))
    content: dict[str, Any] = {
        "format": FORMAT,
        "version": VERSION,
        "package": version("nonsmooth"),
        "orbit": orbit.name,
        "derivation": _derivation(orbit.kernels),
        "given": {name: value.text for name, value in orbit.given.items()},
        "opened": {name: value.text for name, value in orbit.opened.items()},
        "unknowns": {name: number_text(number, bits) for name, number in orbit.unknowns.items()},
        "arithmetic": "mpmath" if orbit.precise else "double",
        "bits": bits,
        "residual": number_text(orbit.residual, bits),
        "digits": orbit.digits,
        "iterations": orbit.iterations,
        "status": orbit.status,
    }
    return {**content, "sha256": checksum_of(content)}


def write_content(path: Path, content: Mapping[str, Any]) -> None:
    """Write entries as JSON; what was there stays until the new content is complete."""
    text = json.dumps(content, indent=2, allow_nan=False) + "\n"
    write_file(path, text.encode())


def load_orbit_file(path: str | os.PathLike[str]) -> Orbit | ComposedOrbit:
    """Read an orbit that `Orbit.save` or `ComposedOrbit.save` wrote.

    Kernels of another derivation are accepted if they have the same unknowns and parameters
    and the orbit solves their equations.

    Parameters
    ----------
    path : str or path

    Raises
    ------
    InputError
        If the file cannot be read, is cut, edited or foreign, or holds what is no orbit of
        the kernels that are installed. The message names the file.
    """
    try:
        content = parsed(read_file(Path(path), _LARGEST_FILE, "saved orbit"))
        return orbit_of(content, Path(path).parent)
    except InputError as problem:
        raise InputError(f"{os.fspath(path)}: {problem}") from None


def parsed(found: bytes) -> Any:
    """What JSON text holds; InputError if it is none."""
    try:
        return json.loads(found.decode("utf-8"), object_pairs_hook=_once)
    except (ValueError, RecursionError) as problem:
        told = str(problem) if isinstance(problem, InputError) else "cut, or not JSON"
        raise InputError(told) from None


def _once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """Entries by name; InputError where a name is there twice."""
    found = dict(pairs)
    if len(found) < len(pairs):
        names = [name for name, _ in pairs]
        twice = next(name for name in names if names.count(name) > 1)
        raise InputError(f"{twice!r} is there twice")
    return found


def orbit_of(content: Any, folder: Path) -> Orbit | ComposedOrbit:
    """The orbit that the entries of a file in a folder describe, of one of the two formats.

    Raises
    ------
    InputError
        As for `load_orbit_file`, without the name of a file.
    """
    checked = _content(content)
    if checked["format"] == FORMAT:
        return _orbit(checked, folder)
    from nonsmooth.runtime.composition.saved import composed_orbit

    return composed_orbit(checked, folder)


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


def checksum_of(content: Mapping[str, Any]) -> str:
    """Hash of a file's other entries."""
    covered = {name: entry for name, entry in content.items() if name != "sha256"}
    return hashlib.sha256(json.dumps(covered, sort_keys=True).encode()).hexdigest()


def _content(content: Any) -> dict[str, Any]:
    """Entries of a file of one of the two formats."""
    from nonsmooth.runtime.composition import saved as composed

    known = {FORMAT: (VERSION, _FIELDS), composed.FORMAT: (composed.VERSION, composed.FIELDS)}
    if not isinstance(content, dict) or content.get("format") not in (FORMAT, composed.FORMAT):
        raise InputError("not a saved orbit, such as Orbit.save or --save writes")
    check_fields(content, *known[content["format"]])
    return content


def check_fields(content: Mapping[str, Any], version: int, fields: Mapping[str, type]) -> None:
    """As `check_entries`, for content in which every mapping is one to decimal strings."""
    check_entries(content, version, fields)
    for name, kind in fields.items():
        if kind is dict and not all(isinstance(text, str) for text in content[name].values()):
            raise InputError(f"{name!r} holds something else than decimal strings")


def check_entries(content: Mapping[str, Any], version: int, fields: Mapping[str, type]) -> None:
    """Refuse content of another version, with other entries, or with another checksum."""
    if content.get("version") != version:
        raise InputError(
            f"version {content.get('version')!r} of the format, where {version} is known:"
            " use the release that wrote it"
        )
    for name in fields.keys() ^ content.keys():
        raise InputError(f"{name!r} is {'missing' if name in fields else 'unknown'}")
    for name, kind in fields.items():
        if type(content[name]) is not kind:
            raise InputError(f"{name!r} is of the wrong type")
    if content["sha256"] != checksum_of(content):
        raise InputError("edited or damaged: the checksum differs")


def _orbit(content: Mapping[str, Any], folder: Path) -> Orbit:
    """The orbit that a file's entries describe, checked against the kernels."""
    kernels = load_orbit(content["orbit"], folder)
    _check_names(kernels, content)
    check_counts(content)
    bits = None if content["arithmetic"] == "double" else content["bits"]
    orbit = Orbit(
        kernels.name,
        {name: given_value(name, text) for name, text in content["given"].items()},
        {name: read_number(name, text, bits) for name, text in content["unknowns"].items()},
        {name: given_value(name, text) for name, text in content["opened"].items()},
        read_number("residual", content["residual"], bits),
        *(content[name] for name in ("digits", "iterations", "status")),
    )
    _check_domains(orbit)
    if not _solves(orbit):
        raise InputError(
            f"not a solution of {kernels.name} to {orbit.digits} digits with the kernels that are"
            f" installed (its derivation {content['derivation']}, here {_derivation(kernels)})"
        )
    return orbit


def _derivation(kernels: OrbitKernels) -> str:
    return str(kernels.system.module.DERIVATION)


def _check_names(kernels: OrbitKernels, content: Mapping[str, Any]) -> None:
    known = sorted([*kernels.parameter_names, *kernels.unknowns])
    found = sorted([*content["given"], *content["unknowns"]])
    opened = [p.name for p in kernels.open_parameters]
    if found != known or len(content["unknowns"]) != len(kernels.unknowns):
        raise InputError(
            f"{kernels.name} has {', '.join(known)}, the file has {', '.join(found) or 'nothing'}"
        )
    for name in content["opened"]:
        if name not in opened:
            raise unknown_name("open parameter", name, opened)


def check_counts(content: Mapping[str, Any]) -> None:
    """Refuse an arithmetic, or counts of bits, digits and iterations, that no orbit has."""
    double = content["arithmetic"] == "double"
    allowed = {
        "bits": (_DOUBLE_BITS, _DOUBLE_BITS if double else _MOST_BITS),
        "digits": (0, DOUBLE if double else MOST_DIGITS),
        "iterations": (0, math.inf),
        "status": (CONVERGED, CONVERGED),
    }
    if content["arithmetic"] not in ("double", "mpmath"):
        raise InputError(f"arithmetic is {content['arithmetic']!r}, neither 'double' nor 'mpmath'")
    for name, (least, most) in allowed.items():
        if not least <= content[name] <= most:
            raise InputError(f"{name} is {content[name]}, which no saved orbit has")


def given_value(name: str, text: str) -> Value:
    """A given value as it was written."""
    try:
        return parse(text) if len(text) <= LONGEST_TEXT else as_value(Fraction(text))
    except (ValueError, ZeroDivisionError) as problem:
        raise InputError(f"{name}: {problem}") from None


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
    values = {**orbit.values, **orbit.opened}
    for table in (*kernels.parameters, *kernels.open_parameters, *kernels.other_parameters):
        if table.name in values and not in_domain(table, float(values[table.name])):
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
