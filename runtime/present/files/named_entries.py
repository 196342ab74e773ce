"""Orbits in files of results, found or saved, as orbits that every command takes by name.

``FILE.json:N`` is the N-th orbit of a file, counted from 1; ``FILE.json`` the only one, or the
one that a design ends at. Its parameters are the defaults, and it is where the solver starts.
"""

from __future__ import annotations

import os
from functools import lru_cache
from pathlib import Path
from typing import Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.result_files import format_in
from nonsmooth.runtime.model.kernel_records import OrbitKernels, SavedTable, SystemKernels
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.orbit_file import load_orbit_file, orbit_content, orbit_in
from nonsmooth.runtime.orbits.problem import labelled
from nonsmooth.runtime.present.files import found as finding
from nonsmooth.runtime.present.files.loading import load
from nonsmooth.runtime.shooting.symmetry import images_of

_DESIGN = "nonsmooth design"
_PERIOD = {
    "name": "period",
    "description": "period",
    "lower": "0",
    "upper": None,
    "closed": False,
    "upper_closed": False,
}


def saved_orbit(name: str) -> Orbit:
    """The orbit that ``FILE.json`` or ``FILE.json:N`` names, with the numbers of the file.

    `InputError` is raised if the file holds no such orbit, or as by `load_orbit_file` and
    `found_orbit`.
    """
    path, number = _place(name)
    return _orbit(path, number)


def saved_kernels(name: str) -> OrbitKernels:
    """Tables and kernels of the orbit that ``FILE.json`` or ``FILE.json:N`` names.

    As long as the file does not change, the object is the same one. Errors are those of
    `saved_orbit`.
    """
    return _known(*_place(name))[1]


def orbit_to_hold(name: str) -> dict[str, Any]:
    """Content of the file of the orbit that ``FILE.json`` or ``FILE.json:N`` names.

    It is ready for JSON. An orbit without a name takes that of its kernels in this file.
    """
    orbit, kernels = _known(*_place(name))
    if not orbit.problem.derived:
        orbit = labelled(orbit, kernels.name, orbit.problem.names)
    return orbit_content(orbit)


def held_kernels(content: Any, name: str) -> OrbitKernels:
    """Tables and kernels of an orbit that `orbit_to_hold` gave, read as JSON.

    `name` is the one that loads the orbit again. `InputError` is raised as by
    `load_orbit_file`, but without the name of a file.
    """
    return _kernels(orbit_in(content), name)


def saved_listing(name: str) -> tuple[SystemKernels, dict[str, OrbitKernels | str]]:
    """The system and all orbits that ``FILE.json`` or ``FILE.json:N`` names.

    The keys are the names that `load_orbit` takes. If the file has several orbits, one that
    fails is replaced by the reason. `InputError` is raised if the file holds no orbit, if
    the only one named fails, or as by `load_found`.
    """
    path, number = _place(name)
    if number is not None or format_in(path) != finding.FOUND.name:
        orbit = saved_kernels(name)
        return orbit.system, {name: orbit}
    system, count = finding.found_system(path)
    if not count:
        raise InputError(f"{name} holds no orbit that has an itinerary")
    orbits: dict[str, OrbitKernels | str] = {}
    for each in (f"{path}:{number}" for number in range(1, count + 1)):
        try:
            orbits[each] = saved_kernels(each)
        except InputError as problem:
            orbits[each] = str(problem)
    return system, orbits


def declared_table(orbit: Orbit) -> dict[str, Any]:
    """The table of a converged orbit, as generated modules hold it.

    It has the phases, the names of the unknowns, what closes the orbit, and the orbit as
    reference.
    """
    part = len(orbit.itinerary)
    symmetry = orbit.symmetry
    if symmetry is not None:
        part //= symmetry.order
    names = list(orbit.unknowns)
    count = len(orbit.itinerary)
    dwell, start = names[:part], names[count:]
    numbers = [*orbit.dwell_times[:part].tolist(), *orbit.states[0].tolist()]
    return {
        "derived": False,
        "reason": "it is known by its phases",
        "phases": [(*phase, name) for phase, name in zip(orbit.itinerary, dwell, strict=False)],
        "start": dict(zip(orbit.state_names, start, strict=True)),
        "period": None if orbit.given_period is None else dict(_PERIOD),
        "symmetry": {} if symmetry is None else images_of(symmetry.matrix, orbit.state_names),
        "reference": {
            "parameters": {name: value.text for name, value in orbit.given.items()},
            "guess": {n: repr(float(x)) for n, x in zip([*dwell, *start], numbers, strict=True)},
        },
    }


def _place(name: str) -> tuple[Path, int | None]:
    """Absolute path of the file, and the number N if the name has one."""
    file, text = (name, "") if name.endswith(".json") else name.rsplit(":", 1)
    path = Path(file)
    if not path.is_file():
        raise InputError(f"there is no file {file}")
    if text and not text.isdecimal():
        raise InputError(f"{name}: {text!r} is no number of an orbit, such as {file}:1")
    return Path(os.path.abspath(path)), int(text) if text else None


def _known(path: Path, number: int | None) -> tuple[Orbit, OrbitKernels]:
    stamp = path.stat()
    return _read(path, number, (stamp.st_mtime_ns, stamp.st_size, stamp.st_ino))


@lru_cache(maxsize=256)
def _read(path: Path, number: int | None, stamp: tuple[int, ...]) -> tuple[Orbit, OrbitKernels]:
    orbit = _orbit(path, number)
    return orbit, _kernels(orbit, str(path) if number is None else f"{path}:{number}")


def _kernels(orbit: Orbit, address: str) -> OrbitKernels:
    if not orbit.problem.derived:
        saved = SavedTable(orbit.problem.label or address, address, declared_table(orbit))
        return OrbitKernels(orbit.system, "", saved)
    kernels = orbit.kernels
    saved = SavedTable(kernels.name, address, {**kernels.table, "reference": _reference(orbit)})
    return OrbitKernels(kernels.system, kernels.orbit, saved)


def _reference(orbit: Orbit) -> dict[str, dict[str, str]]:
    """The reference of a derived orbit: its exact given values, and a guess of its unknowns."""
    given = {name: value.text for name, value in orbit.given.items()}
    found = {**{name: repr(float(x)) for name, x in orbit.unknowns.items()}, **given}
    names = orbit.kernels.unknowns
    parameters = {n: text for n, text in found.items() if n not in names}
    opened = {name: value.text for name, value in orbit.opened.items()}
    return {
        "parameters": {**parameters, **opened},
        "guess": {name: repr(float(orbit.values[name])) for name in names},
    }


def _orbit(path: Path, number: int | None) -> Orbit:
    if format_in(path) != finding.FOUND.name:
        if number not in (None, 1):
            raise InputError(f"{path.name} holds one orbit: there is no {path.name}:{number}")
        ends = load(path).orbit if format_in(path) == _DESIGN else None
        return load_orbit_file(path) if ends is None else ends
    return finding.found_orbit(path, number)
