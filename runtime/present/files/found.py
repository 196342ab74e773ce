"""Periodic orbits that were found, as JSON, in files, and read again."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.result_files import Form, naming
from nonsmooth.runtime.explore.finding.find import Found, FoundEquilibrium, FoundOrbit
from nonsmooth.runtime.explore.finding.outcomes import Outcome
from nonsmooth.runtime.explore.finding.steady import equilibria
from nonsmooth.runtime.model.kernels import load_system
from nonsmooth.runtime.model.piecewise import (
    PiecewiseLinear,
    piecewise,
    system_parameters,
)
from nonsmooth.runtime.orbits.table_solve import solve_itinerary
from nonsmooth.runtime.shooting.multipliers import Multiplier

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
        "equilibria": list,
        "outcomes": dict,
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


def _found(content: dict[str, Any], folder: Path) -> Found:
    kernels = load_system(content["system"], folder)
    parameters = system_parameters(kernels, content["parameters"])
    orbits: list[FoundOrbit] = []
    for entry in content["orbits"]:
        phases = [(p["configuration"], p["boundary"]) for p in entry["itinerary"]]
        dwell = [float(p["dwell_time"]) for p in entry["itinerary"]]
        start = [float(x) for x in entry["start"].values()]
        orbit = solve_itinerary(kernels, parameters, phases, dwell, start)
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
        content["complete"],
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
