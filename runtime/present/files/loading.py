"""Any saved result, read by what its file says it holds."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping
from importlib import import_module
from pathlib import Path
from types import MappingProxyType
from typing import Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.files import path_of, read_file
from nonsmooth.runtime.core.result_files import FileFormat, format_in, naming, parsed
from nonsmooth.runtime.present.files.kept import KINDS, format_named
from nonsmooth.runtime.present.files.motions import ENDINGS, load_trajectory

# by the format that a file names: what reads other kinds, imported when there is one to read
_READERS: Mapping[str, str] = MappingProxyType(
    {
        "nonsmooth orbit": "orbits.orbit_file:load_orbit_file",
        "nonsmooth found orbits": "present.files.found:load_found",
        "nonsmooth event certificate": "present.files.kept:load_events",
    }
)
_MOST = 500_000_000  # bytes


def load(path: str | os.PathLike[str]) -> Any:
    """Read any saved result: what `save` or a command wrote, with every digit.

    A file tells what it holds. Nothing is proved again, and no declaration is run: a file holds
    its system as data.

    Parameters
    ----------
    path : str or path
        JSON of an orbit, found orbits, a branch, a curve of events, a design, a sweep, a fit, a
        certificate of an orbit, a box, a basin, chaos or a region, a certified branch or
        doubling, certificates of events, or a census; .npz or .csv of a motion;
        the folder of a chart; ``FILE.json:N``, the N-th of found orbits.

    Returns
    -------
    Orbit, Found, Branch, Locus, Design, Sweep, Fit, Certificate, BoxCertificate, \
BasinCertificate, CertifiedBranch, CertifiedDoubling, ChaosCertificate, RegionCertificate, Census, \
Trajectory, tuple of EventCertificate or xarray.Dataset
        The result that was saved. A chart may be incomplete, `status` being -128 where nothing
        is computed yet, and its numbers are read when they are used.

    Raises
    ------
    InputError
        If the file cannot be read, is cut, edited or foreign, or holds what is none of the
        systems that are installed. The message names the file.
    MissingExtra
        For a chart, if Zarr or xarray are not installed.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> orbit = ns.solve("dry-friction/symmetric")
    >>> orbit.save("orbit.json")
    >>> ns.load("orbit.json") == orbit
    True
    >>> ns.design(orbit, solve={"multiplier": -1}, over={"V": (0.6, 1.3)}).save("design.json")
    >>> ns.load("design.json").message
    'the wanted values are met'
    """
    one = re.fullmatch(r"(.+\.json):(\d+)", str(os.fspath(path)))
    if one:
        from nonsmooth.runtime.present.files.found import found_orbit

        return found_orbit(one[1], int(one[2]))
    place = path_of(path)
    if place.is_dir():
        from nonsmooth.runtime.explore.charting.chart import load_chart

        return load_chart(place)
    if place.suffix.lower() in ENDINGS:
        return load_trajectory(place)
    held = format_of(place)
    if held not in _READERS:
        return format_named(held).load(path)
    module, _, name = _READERS[held].partition(":")
    return getattr(import_module(f"nonsmooth.runtime.{module}"), name)(path)


def file_schemas() -> dict[str, dict[str, Any]]:
    """JSON Schema (2020-12) of each kind of JSON file that `load` reads, by its format.

    Examples
    --------
    >>> schema = file_schemas()["nonsmooth certificate"]
    >>> schema["properties"]["claims"]["properties"]["existence"]
    {'enum': ['proved', 'refuted', 'undecided']}
    """
    from nonsmooth.runtime.orbits.orbit_file import ORBIT
    from nonsmooth.runtime.present.files.found import FOUND

    formats: list[FileFormat[Any]] = [ORBIT, FOUND, *map(format_named, KINDS)]
    return {each.name: each.schema for each in formats}


def format_of(path: Path) -> str:
    """The format of a result's JSON file.

    `InputError` is raised if the file cannot be read, is no JSON, or names an unknown
    format.
    """
    named = format_in(path)
    if named is not None and (named in KINDS or named in _READERS):
        return named
    with naming(path):
        if named is None:
            parsed(read_file(path, _MOST, "saved result"))  # which may say why
        told = "" if named is None else f": its format is {named[:60]!r}"
        raise InputError(f"not a saved result, such as --save or save() writes{told}")
