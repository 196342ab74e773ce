"""Orbits in files: JSON with every digit, refused when it is cut, edited or foreign.

Numbers are decimal strings that give back the very same double or mpmath number; given
values are kept as they were written. A checksum covers the content, and an orbit that is
read has to solve the equations of the kernels or tables that are there.
"""

from __future__ import annotations

import os
from typing import Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.files import read_file
from nonsmooth.runtime.core.result_files import FileFormat, naming, parsed
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.present.files.kernel_orbits import (
    KERNEL_ORBIT,
    kernel_entries,
    kernel_orbit,
)
from nonsmooth.runtime.present.files.table_orbits import TABLE_ORBIT, table_entries, table_orbit

__all__ = ["load_orbit_file", "orbit_content", "orbit_in", "save_orbit"]


def save_orbit(orbit: Orbit, path: str | os.PathLike[str]) -> None:
    """Write a converged orbit to a JSON file, and make the folders above it.

    Floats and mpmath numbers keep every digit. The file is replaced only when the new one
    is complete. `InputError` is raised if the orbit has not converged or the file cannot be
    written.
    """
    file_format, entries = _entries(orbit)
    file_format.write(path, entries)


def orbit_content(orbit: Orbit) -> dict[str, Any]:
    """Content of an orbit's file, ready for JSON; `InputError` if the orbit has not converged."""
    file_format, entries = _entries(orbit)
    return file_format.content(entries)


def _entries(orbit: Orbit) -> tuple[FileFormat[Any], Any]:
    """Format and entries of an orbit's file."""
    if not orbit.converged:
        raise InputError(f"{orbit.name} is not saved: {orbit.message}")
    if orbit.problem.derived:
        return KERNEL_ORBIT, kernel_entries(orbit)
    return TABLE_ORBIT, table_entries(orbit)


def load_orbit_file(path: str | os.PathLike[str]) -> Orbit:
    """Read an orbit that `Orbit.save` wrote, with every digit.

    Kernels of another derivation are accepted if they have the same unknowns and parameters
    and the orbit solves their equations. An `InputError` with the file's name is raised if
    the file cannot be read, is cut, edited or foreign, or holds what is no orbit of the
    installed kernels.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> ns.solve("dry-friction/global-stick").save("orbit.json")
    >>> ns.load("orbit.json").converged
    True
    """
    with naming(path) as file:
        return orbit_in(parsed(read_file(file, KERNEL_ORBIT.most, KERNEL_ORBIT.what)))


def orbit_in(content: Any) -> Orbit:
    """The orbit that the content of a file (read as JSON) describes, with the same numbers.

    `InputError` is raised as by `load_orbit_file`, but without the name of a file.
    """
    by_tables = isinstance(content, dict) and content.get("format") == TABLE_ORBIT.name
    if by_tables:
        return table_orbit(TABLE_ORBIT.check(content))
    return kernel_orbit(KERNEL_ORBIT.check(content))
