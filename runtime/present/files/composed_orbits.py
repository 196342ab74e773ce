"""Composed orbits in files, as the others: every digit, a checksum, and equations that hold.

A phase's start, its dwell time and the next phase's start are compared one phase at a time:
an orbit that is read has to be one of the system that is there.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.result_files import Form
from nonsmooth.runtime.model.kernels import SystemKernels, load_system
from nonsmooth.runtime.model.piecewise import piecewise, system_parameters
from nonsmooth.runtime.orbits.composed_orbit import ComposedOrbit
from nonsmooth.runtime.orbits.orbit import DOUBLE
from nonsmooth.runtime.orbits.routes import with_routes_at
from nonsmooth.runtime.shooting.shooting_map import numbers_in
from nonsmooth.runtime.shooting.symmetry import symmetry_of
from nonsmooth.runtime.shooting.translations import projection_along

__all__ = ["COMPOSED", "composed_content", "composed_orbit", "save_composed"]

COMPOSED = Form(
    "nonsmooth composed orbit",
    "saved orbit",
    {
        "system": str,
        "label": str,
        "derivation": str,
        "parameters": dict,
        "period": str,
        "symmetry": list,
        "phases": list,
        "names": list,
        "arithmetic": str,
        "bits": int,
        "residual": str,
        "digits": int,
        "iterations": int,
        "status": int,
    },
    most=50_000_000,
)
_PHASE = ("configuration", "boundary", "dwell_time", "start")
_SLACK = 100  # times the error that the stated digits allow
_MOST_MISSED = 1e-9  # the solver's residual, in units of the data


def save_composed(orbit: ComposedOrbit, path: str | os.PathLike[str]) -> None:
    """Write an orbit to a file; what was there stays until the new content is complete.

    Parameters
    ----------
    orbit : ComposedOrbit
        A converged one; floats and mpmath numbers come back as they are.
    path : str or path
        A JSON file; its folder has to exist.

    Raises
    ------
    InputError
        If the orbit has not converged or the file cannot be written.
    """
    COMPOSED.write(path, _entries(orbit))


def composed_content(orbit: ComposedOrbit) -> dict[str, Any]:
    """What is in an orbit's file; InputError if it has not converged."""
    return COMPOSED.content(_entries(orbit))


def _entries(orbit: ComposedOrbit) -> dict[str, Any]:
    from nonsmooth.runtime.present.files.orbits import bits_of, number_text

    if not orbit.converged:
        raise InputError(f"{orbit.name} is not saved: {orbit.message}")
    dwell, states = orbit.dwell_times.tolist(), orbit.states.tolist()
    bits = max(map(bits_of, (*dwell, *(x for row in states for x in row), orbit.residual)))
    phases = [
        {
            "configuration": configuration,
            "boundary": boundary,
            "dwell_time": number_text(time, bits),
            "start": [number_text(x, bits) for x in row],
        }
        for (configuration, boundary), time, row in zip(orbit.itinerary, dwell, states, strict=True)
    ]
    return {
        "system": orbit.system,
        "label": orbit.label or "",
        "derivation": _derivation(orbit.kernels),
        "parameters": {name: value.text for name, value in orbit.parameters.items()},
        "period": "" if orbit.given_period is None else orbit.given_period.text,
        "symmetry": [] if orbit.symmetry is None else orbit.symmetry.matrix.tolist(),
        "phases": phases,
        "names": list(orbit.names),
        "arithmetic": "mpmath" if orbit.precise else "double",
        "bits": bits,
        "residual": number_text(orbit.residual, bits),
        "digits": orbit.digits,
        "iterations": orbit.iterations,
        "status": orbit.status,
    }


def composed_orbit(content: Mapping[str, Any], folder: Path) -> ComposedOrbit:
    """The orbit that the entries of a file in a folder, of the right types, describe.

    Raises
    ------
    InputError
        If the system is not there, or what the file holds is no orbit of it.
    """
    from nonsmooth.runtime.present.files.orbits import (
        check_counts,
        check_texts,
        given_value,
        read_number,
    )

    check_texts(content, "parameters")
    kernels = load_system(content["system"], folder)
    check_counts(content)
    bits = None if content["arithmetic"] == "double" else content["bits"]
    given = {name: given_value(name, text) for name, text in content["parameters"].items()}
    parameters = system_parameters(kernels, given)
    phases, size = _phases(content["phases"]), len(kernels.table["states"])
    if any(len(phase["start"]) != size for phase in phases):
        raise InputError(f"{kernels.name} has {size} states, and the file another number")
    names = content["names"]
    if len(names) not in (0, len(phases) + size) or not all(isinstance(n, str) for n in names):
        raise InputError(f"'names' does not hold {len(phases) + size} names, or none")
    dwell = [read_number("dwell_time", phase["dwell_time"], bits) for phase in phases]
    states = [[read_number("start", text, bits) for text in phase["start"]] for phase in phases]
    kind = float if bits is None else object
    symmetry = None
    if content["symmetry"]:
        symmetry = symmetry_of(piecewise(kernels, parameters), content["symmetry"])
    itinerary = tuple((str(phase["configuration"]), str(phase["boundary"])) for phase in phases)
    point = piecewise(kernels, parameters)
    kernels = with_routes_at(kernels, point, itinerary, np.array(dwell), np.array(states))
    orbit = ComposedOrbit(
        kernels.name,
        itinerary,
        parameters,
        np.array(dwell, dtype=kind),
        np.array(states, dtype=kind),
        given_value("period", content["period"]) if content["period"] else None,
        read_number("residual", content["residual"], bits),
        content["digits"],
        content["iterations"],
        content["status"],
        kernels,
        symmetry,
        content["label"] or None,
        tuple(names),
    )
    if symmetry is not None and len(phases) % symmetry.order:
        raise InputError("its phases are no multiple of those that the symmetry closes")
    if not (orbit.dwell_times > 0).all():
        raise InputError("a dwell time is not positive")
    if not _solves(orbit):
        raise InputError(
            f"not a solution of {kernels.name} to {orbit.digits} digits with the kernels that are"
            f" installed (its derivation {content['derivation']}, here {_derivation(kernels)})"
        )
    return orbit


def _derivation(kernels: SystemKernels) -> str:
    return str(kernels.module.DERIVATION)


def _phases(entries: list[Any]) -> list[dict[str, Any]]:
    """Phases of a file, each with its entries."""
    if not entries:
        raise InputError("'phases' is empty")
    for entry in entries:
        if not isinstance(entry, dict) or tuple(entry) != _PHASE:
            raise InputError(f"'phases' holds something else than {', '.join(_PHASE)}")
        texts = entry["start"] if isinstance(entry["start"], list) else [None]
        if not all(isinstance(text, str) for text in (*list(entry.values())[:3], *texts)):
            raise InputError("'phases' holds something else than texts")
    return entries


def _solves(orbit: ComposedOrbit) -> bool:
    """Whether each phase ends on its boundary, and the next begins where its reset leads.

    An error of 10^-digits max(1, |x|) in each number x moves these by at most the sum of
    these errors times the absolute values of the derivatives.
    """
    numbers, cycle, lib = numbers_in(orbit.piecewise), orbit.cycle, orbit.arithmetic.mp
    unit = lib.mpf(10) ** -orbit.digits if orbit.precise else 10.0**-DOUBLE
    missed = 2 * abs(orbit.residual)
    size = orbit.states.shape[1]
    flows = orbit.shooting.flows
    following = np.roll(orbit.states, -1, axis=0)
    projection = projection_along(orbit.translations)
    for place, (start, end_start) in enumerate(zip(orbit.states, following, strict=True)):
        flow, row = flows[place], numbers.rows[cycle.rows[place]]
        reset = numbers.resets[cycle.transitions[place].reset]
        field = numbers.fields[cycle.configurations[place]]
        end = flow[:, :size] @ start + flow[:, size]
        speed = field[:, :size] @ end + field[:, size]
        scale = np.maximum(1, abs(start))
        reach = abs(flow[:, :size]) @ scale + abs(flow[:, size])
        moved = reach + abs(speed) * max(1, abs(orbit.dwell_times[place]))
        gap, terms = row[:size] @ end + row[size], abs(row[:size]) @ moved + abs(row[size])
        jump = reset[:, :size] @ end + reset[:, size] - end_start
        if place == len(cycle) - 1:
            jump = projection @ jump
        sizes = abs(reset[:, :size]) @ moved + abs(reset[:, size]) + np.maximum(1, abs(end_start))
        if not missed <= _MOST_MISSED * max(terms, max(sizes)):
            return False
        if not abs(gap) <= _SLACK * unit * terms + missed:
            return False
        if not (abs(jump) <= _SLACK * unit * sizes + missed).all():
            return False
    return True
