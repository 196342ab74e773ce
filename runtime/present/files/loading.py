"""Any saved result, read by what its file says it holds."""

from __future__ import annotations

import os
from collections.abc import Mapping
from importlib import import_module
from operator import attrgetter
from pathlib import Path
from types import MappingProxyType
from typing import Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.files import path_of, read_file
from nonsmooth.runtime.core.result_files import format_in, naming, parsed
from nonsmooth.runtime.present.files.motions import ENDINGS, load_trajectory

__all__ = ["READERS", "format_of", "load"]

_OWN = "present.files"
# by the format that a file names: what reads it, imported when there is one to read
READERS: Mapping[str, str] = MappingProxyType(
    {
        "nonsmooth orbit": "orbits.orbit_file:load_orbit_file",
        "nonsmooth found orbits": f"{_OWN}.found:load_found",
        "nonsmooth branch": f"{_OWN}.kept:BRANCH.load",
        "nonsmooth locus": f"{_OWN}.kept:LOCUS.load",
        "nonsmooth design": f"{_OWN}.kept:DESIGN.load",
        "nonsmooth sweep": f"{_OWN}.kept:SWEEP.load",
        "nonsmooth fit": f"{_OWN}.kept:FIT.load",
        "nonsmooth certificate": f"{_OWN}.certificates:load_certificate",
        "nonsmooth box certificate": f"{_OWN}.box_certificates:load_box_certificate",
        "nonsmooth event certificate": f"{_OWN}.event_certificates:load_event_certificates",
        "nonsmooth certified branch": f"{_OWN}.certified_branches:load_certified_branch",
        "nonsmooth certified doubling": f"{_OWN}.certified_doublings:load_certified_doubling",
        "nonsmooth census": f"{_OWN}.censuses:load_census",
        "nonsmooth basin certificate": f"{_OWN}.basin_certificates:load_basin_certificate",
        "nonsmooth chaos certificate": f"{_OWN}.chaos_certificates:load_chaos_certificate",
        "nonsmooth graph certificate": f"{_OWN}.graph_certificates:load_graph_certificate",
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
        certificate, a proven map, a proven branch or doubling, certificates of events, a
        certificate of chaos, a basin or a graph of boxes, or a census; .npz or .csv of a motion;
        the folder of a chart.

    Returns
    -------
    Orbit, Found, Branch, Locus, Design, Sweep, Fit, Certificate, BoxCertificate, \
BasinCertificate, CertifiedBranch, CertifiedDoubling, ChaosCertificate, GraphCertificate, Census, \
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
    place = path_of(path)
    if place.is_dir():
        from nonsmooth.runtime.explore.charting.chart import load_chart

        return load_chart(place)
    if place.suffix.lower() in ENDINGS:
        return load_trajectory(place)
    module, _, name = READERS[format_of(place)].partition(":")
    return attrgetter(name)(import_module(f"nonsmooth.runtime.{module}"))(path)


def format_of(path: Path) -> str:
    """The format of a result's JSON file: one of `READERS`.

    `InputError` is raised if the file cannot be read, is no JSON, or names an unknown
    format.
    """
    named = format_in(path)
    if named is not None and named in READERS:
        return named
    with naming(path):
        if named is None:
            parsed(read_file(path, _MOST, "saved result"))  # which may say why
        told = "" if named is None else f": its format is {named[:60]!r}"
        raise InputError(f"not a saved result, such as --save or save() writes{told}")
