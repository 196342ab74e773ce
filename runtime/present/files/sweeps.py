"""Bifurcation diagrams in files: all that was asked, and what was found until an interruption."""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.result_files import Form, naming
from nonsmooth.runtime.explore.finding.sweep import Sweep
from nonsmooth.runtime.present.files.orbit_numbers import given_value

__all__ = ["load_sweep", "save_sweep"]

_FORM = Form(
    "nonsmooth sweep",
    "saved sweep",
    {
        "system": str,
        "parameters": dict,
        "parameter": str,
        "state": str,
        "configuration": str,
        "phase": str,
        "values": list,
        "samples": list,
        "outcomes": list,
        "start": list,
        "transient": int,
        "follow": bool,
        "done": int,
        "next_start": list,
    },
)


def save_sweep(diagram: Sweep, path: str | os.PathLike[str]) -> None:
    """Write a diagram, complete or not; what was there stays until the new content is complete.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    _FORM.write(
        path,
        {
            "system": diagram.system,
            "parameters": {name: value.text for name, value in diagram.parameters.items()},
            "parameter": diagram.parameter,
            "state": diagram.state,
            "configuration": diagram.configuration or "",
            "phase": "" if diagram.phase is None else repr(diagram.phase),
            "values": _texts(diagram.values),
            "samples": [_texts(row) for row in diagram.samples],
            "outcomes": diagram.outcomes.tolist(),
            "start": _texts(diagram.start),
            "transient": diagram.transient,
            "follow": diagram.follow,
            "done": diagram.done,
            "next_start": _texts(diagram.next_start),
        },
    )


def load_sweep(path: str | os.PathLike[str]) -> Sweep:
    """Read a diagram that `Sweep.save` wrote.

    Raises
    ------
    InputError
        If the file cannot be read, or is cut, edited or foreign. The message names it.
    """
    with naming(path) as file:
        return _sweep(_FORM.read(file))


def _sweep(content: dict[str, Any]) -> Sweep:
    parameters = {name: given_value(name, text) for name, text in content["parameters"].items()}
    values, samples = _numbers(content["values"]), _numbers(content["samples"])
    outcomes = np.array(content["outcomes"], dtype=int)
    if (
        samples.ndim != 2
        or not len(samples) == len(values) == len(outcomes)
        or not 0 <= content["done"] <= len(values)
    ):
        raise InputError("its values and samples do not belong together")
    return Sweep(
        system=content["system"],
        parameters=parameters,
        parameter=content["parameter"],
        state=content["state"],
        configuration=content["configuration"] or None,
        phase=float(content["phase"]) if content["phase"] else None,
        values=values,
        samples=samples,
        outcomes=outcomes,
        start=_numbers(content["start"]),
        transient=content["transient"],
        follow=content["follow"],
        done=content["done"],
        next_start=_numbers(content["next_start"]),
    )


def _texts(numbers: np.ndarray) -> list[str]:
    return [repr(number) for number in numbers.tolist()]


def _numbers(texts: Any) -> np.ndarray:
    return np.array(texts, dtype=str).astype(float)
