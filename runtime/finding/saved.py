"""Periodic orbits that were found, as JSON, in files, and read again."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np

from nonsmooth.runtime.composition.composed import compose
from nonsmooth.runtime.errors import InputError
from nonsmooth.runtime.finding.find import Found, FoundOrbit
from nonsmooth.runtime.form import Form, naming
from nonsmooth.runtime.kernels import load_system
from nonsmooth.runtime.simulation.piecewise import system_parameters
from nonsmooth.runtime.stability import Multiplier

__all__ = ["FOUND", "found_json", "load_found", "save_found"]

FOUND = Form(
    "nonsmooth found orbits",
    "file of found orbits",
    {
        "system": str,
        "parameters": dict,
        "starts": int,
        "transitions": int,
        "complete": bool,
        "box": dict,
        "orbits": list,
        "resting": str,
        "unclassified": str,
        "start_states": list,
        "labels": list,
    },
    version=2,
    most=200_000_000,
)
_DIGITS_KEPT = 1e-9  # relative change of a dwell time that solving again may make


def found_json(found: Found) -> dict[str, Any]:
    """Orbits, basins and shares; numbers are decimal strings that give back the same doubles."""
    return {
        "system": found.system,
        "parameters": {name: value.text for name, value in found.parameters.items()},
        "starts": len(found.starts),
        "transitions": found.transitions,
        "complete": found.complete,
        "box": {
            name: [repr(low), repr(high)]
            for name, (low, high) in zip(found.names, found.box.tolist(), strict=True)
        },
        "orbits": [_orbit_json(found, orbit) for orbit in found.orbits],
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
    FOUND.write(
        path,
        {
            **found_json(found),
            "start_states": [[repr(x) for x in row] for row in found.starts.tolist()],
            "labels": found.labels.tolist(),
        },
    )


def load_found(path: str | os.PathLike[str]) -> Found:
    """Read what `save_found` wrote; each orbit is solved again and has to be the same.

    Raises
    ------
    InputError
        For a file that cannot be read, is cut, edited or foreign, or holds what is no orbit
        of the system that is installed. The message names the file.
    """
    with naming(path) as file:
        return _found(FOUND.read(file), file.parent)


def _orbit_json(found: Found, entry: FoundOrbit) -> dict[str, Any]:
    orbit = entry.orbit
    return {
        "period": repr(entry.period),
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
    }


def _multiplier_json(multiplier: Multiplier) -> dict[str, Any]:
    return {
        "re": repr(float(multiplier.real)),
        "im": repr(float(multiplier.imaginary)),
        "trivial": multiplier.trivial,
    }


def _found(content: dict[str, Any], folder: Path) -> Found:
    kernels = load_system(content["system"], folder)
    parameters = system_parameters(kernels, content["parameters"])
    orbits = []
    for entry in content["orbits"]:
        phases = [(p["configuration"], p["boundary"]) for p in entry["itinerary"]]
        dwell = [float(p["dwell_time"]) for p in entry["itinerary"]]
        start = [float(x) for x in entry["start"].values()]
        orbit = compose(kernels, parameters, phases, dwell, start)
        if not orbit.converged or not np.allclose(orbit.dwell_times, dwell, rtol=_DIGITS_KEPT):
            raise InputError(
                f"the orbit of period {entry['period']} is none of the {kernels.name} that is"
                " installed"
            )
        orbits.append(FoundOrbit(orbit, entry["starts"], float(entry["share"])))
    names = tuple(kernels.table["states"])
    starts = np.array([[float(x) for x in row] for row in content["start_states"]])
    labels = np.array(content["labels"], dtype=int)
    if starts.shape != (len(labels), len(names)) or (labels >= len(orbits)).any():
        raise InputError("its starts and labels do not belong together")
    return Found(
        kernels.name,
        parameters,
        names,
        tuple(orbits),
        starts,
        labels,
        np.array([[float(x) for x in content["box"][name]] for name in names]),
        content["transitions"],
        content["complete"],
    )
