"""Periodic orbits that were found, as JSON, in files, and read again."""

from __future__ import annotations

import hashlib
import json
import os
from pathlib import Path
from typing import Any

import numpy as np

from nonsmooth.runtime.composition.composed import compose
from nonsmooth.runtime.errors import InputError
from nonsmooth.runtime.files import read_file, write_file
from nonsmooth.runtime.finding.find import Found, FoundEquilibrium, FoundOrbit
from nonsmooth.runtime.finding.outcomes import Outcome
from nonsmooth.runtime.finding.steady import equilibria
from nonsmooth.runtime.kernels import load_system
from nonsmooth.runtime.simulation.piecewise import (
    PiecewiseLinear,
    piecewise,
    system_parameters,
)
from nonsmooth.runtime.stability import Multiplier

__all__ = ["FORMAT", "found_json", "load_found", "save_found"]

FORMAT, VERSION = "nonsmooth found orbits", 2
_LARGEST_FILE = 200_000_000  # bytes
_DIGITS_KEPT = 1e-9  # relative change of a dwell time that solving again may make


def found_json(found: Found) -> dict[str, Any]:
    """Orbits, basins and shares; numbers are decimal strings that give back the same doubles."""
    return {
        "system": found.system,
        "parameters": {name: value.text for name, value in found.parameters.items()},
        "starts": len(found.starts),
        "transitions": found.transitions,
        "box": {
            name: [repr(low), repr(high)]
            for name, (low, high) in zip(found.names, found.box.tolist(), strict=True)
        },
        "orbits": [_orbit_json(found, place) for place in range(len(found.orbits))],
        "equilibria": [_equilibrium_json(found, place) for place in range(len(found.equilibria))],
        "outcomes": {
            outcome.name.lower(): repr(found.share(outcome)) for outcome in found.outcomes
        },
        "resting": repr(found.resting),
        "unclassified": repr(found.unclassified),
    }


def save_found(found: Found, path: str | os.PathLike[str]) -> None:
    """Write what was found as JSON, with every start and its label.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    content = {
        "format": FORMAT,
        "version": VERSION,
        **found_json(found),
        "start_states": [[repr(x) for x in row] for row in found.starts.tolist()],
        "labels": found.labels.tolist(),
    }
    content["sha256"] = _checksum(content)
    write_file(Path(path), (json.dumps(content, indent=1, allow_nan=False) + "\n").encode())


def load_found(path: str | os.PathLike[str]) -> Found:
    """Read what `save_found` wrote; each orbit is solved again and has to be the same.

    Raises
    ------
    InputError
        For a file that cannot be read, is cut, edited or foreign, or holds what is no orbit
        of the system that is installed. The message names the file.
    """
    try:
        content = _content(read_file(Path(path), _LARGEST_FILE, "file of found orbits"))
        return _found(content, Path(path).parent)
    except InputError as problem:
        raise InputError(f"{os.fspath(path)}: {problem}") from None
    except (AttributeError, KeyError, TypeError, ValueError):
        raise InputError(f"{os.fspath(path)}: not what find --save writes") from None


def _orbit_json(found: Found, place: int) -> dict[str, Any]:
    entry = found.orbits[place]
    orbit = entry.orbit
    return {
        "period": repr(entry.period),
        "forcing_periods": list(entry.forcing_periods),
        "stability": entry.verdict,
        "starts": entry.starts,
        "share": repr(entry.share),
        "itinerary": [
            {"configuration": configuration, "boundary": boundary, "dwell_time": repr(duration)}
            for (configuration, boundary), duration in zip(
                entry.itinerary, orbit.dwell_times.tolist(), strict=True
            )
        ],
        "start": dict(zip(found.names, map(repr, orbit.states[0].tolist()), strict=True)),
        "multipliers": [_multiplier_json(m) for m in orbit.stability.multipliers],
        "trace": repr(float(orbit.stability.trace)),
        "residual": repr(float(orbit.residual)),
        "admissible": orbit.admissibility.verdict,
        **_mirror_json(entry.mirror, place, 0),
    }


def _equilibrium_json(found: Found, place: int) -> dict[str, Any]:
    entry = found.equilibria[place]
    equilibrium = entry.equilibrium
    return {
        "configuration": equilibrium.configuration,
        "stability": equilibrium.verdict,
        "starts": entry.starts,
        "share": repr(entry.share),
        "state": dict(zip(found.names, map(repr, equilibrium.state.tolist()), strict=True)),
        "eigenvalues": [
            {"re": repr(value.real), "im": repr(value.imag)}
            for value in equilibrium.eigenvalues.tolist()
        ],
        **_mirror_json(entry.mirror, place, len(found.orbits)),
    }


def _mirror_json(mirror: int | None, place: int, before: int) -> dict[str, Any]:
    """Number, from 1, of the entry whose mirror image this one is; whether it is its own."""
    other = mirror is not None and mirror != place
    return {
        "mirror_of": mirror + before + 1 if other and mirror is not None else None,
        "symmetric": mirror == place,
    }


def _multiplier_json(multiplier: Multiplier) -> dict[str, Any]:
    return {
        "re": repr(float(multiplier.real)),
        "im": repr(float(multiplier.imaginary)),
        "trivial": multiplier.trivial,
    }


def _checksum(content: dict[str, Any]) -> str:
    covered = {name: entry for name, entry in content.items() if name != "sha256"}
    return hashlib.sha256(json.dumps(covered, sort_keys=True).encode()).hexdigest()


def _content(data: bytes) -> dict[str, Any]:
    try:
        content = json.loads(data.decode("utf-8"))
    except (ValueError, RecursionError):
        raise InputError("cut, or not JSON") from None
    if not isinstance(content, dict) or content.get("format") != FORMAT:
        raise InputError("no file of found orbits, such as find --save writes")
    if content.get("version") != VERSION:
        raise InputError(f"version {content.get('version')!r} of the format, {VERSION} is known")
    if content.get("sha256") != _checksum(content):
        raise InputError("edited or damaged: the checksum differs")
    return content


def _found(content: dict[str, Any], folder: Path) -> Found:
    kernels = load_system(content["system"], folder)
    parameters = system_parameters(kernels, content["parameters"])
    orbits: list[FoundOrbit] = []
    for entry in content["orbits"]:
        phases = [(p["configuration"], p["boundary"]) for p in entry["itinerary"]]
        dwell = [float(p["dwell_time"]) for p in entry["itinerary"]]
        start = [float(x) for x in entry["start"].values()]
        orbit = compose(kernels, parameters, phases, dwell, start)
        same = np.allclose(orbit.dwell_times, dwell, rtol=_DIGITS_KEPT, atol=0)
        if not orbit.converged or not same:
            raise InputError(
                f"the orbit of period {entry['period']} is none of the {kernels.name} that is"
                " installed"
            )
        mirror = _mirror(entry, len(orbits), 0)
        orbits.append(FoundOrbit(orbit, entry["starts"], float(entry["share"]), mirror))
    steady = _equilibria(content, piecewise(kernels, parameters), len(orbits))
    names = tuple(kernels.table["states"])
    starts = np.array([[float(x) for x in row] for row in content["start_states"]])
    labels = np.array(content["labels"], dtype=int)
    if (
        starts.shape != (len(labels), len(names))
        or (labels >= len(orbits) + len(steady)).any()
        or (labels < min(Outcome)).any()
    ):
        raise InputError("its starts and labels do not belong together")
    return Found(
        kernels.name,
        parameters,
        names,
        tuple(orbits),
        tuple(steady),
        starts,
        labels,
        np.array([[float(x) for x in content["box"][name]] for name in names]),
        content["transitions"],
    )


def _mirror(entry: dict[str, Any], place: int, before: int) -> int | None:
    """Place of the entry before this one whose mirror image it is, or its own."""
    if entry["symmetric"]:
        return place
    if entry["mirror_of"] is None:
        return None
    mirror = int(entry["mirror_of"]) - before - 1
    if not 0 <= mirror < place:
        raise InputError("a mirror image is of no entry before it")
    return mirror


def _equilibria(
    content: dict[str, Any], system: PiecewiseLinear, before: int
) -> list[FoundEquilibrium]:
    """Equilibria of a file, each found again."""
    known = {equilibrium.configuration: equilibrium for equilibrium in equilibria(system)}
    found: list[FoundEquilibrium] = []
    for entry in content["equilibria"]:
        state = [float(x) for x in entry["state"].values()]
        equilibrium = known.get(entry["configuration"])
        if equilibrium is None or not np.allclose(equilibrium.state, state, rtol=_DIGITS_KEPT):
            raise InputError(f"there is no such equilibrium in {entry['configuration']}")
        mirror = _mirror(entry, len(found), before)
        found.append(FoundEquilibrium(equilibrium, entry["starts"], float(entry["share"]), mirror))
    return found
