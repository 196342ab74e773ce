"""Whether a saved certificate is of the system that it names."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from nonsmooth.runtime.certification.certificate import GUARD
from nonsmooth.runtime.certification.checker import Failure
from nonsmooth.runtime.certification.contacts import kernels_with
from nonsmooth.runtime.certification.statement import declaration_json, value_json
from nonsmooth.runtime.certification.tables import exact_tables
from nonsmooth.runtime.composition.passage import cycle_of
from nonsmooth.runtime.errors import InputError
from nonsmooth.runtime.kernels import SystemKernels, load_system
from nonsmooth.runtime.saved import given_value
from nonsmooth.runtime.simulation.piecewise import system_parameters
from nonsmooth.runtime.simulation.structure import structure_of
from nonsmooth.runtime.values import flint_precision

__all__ = ["NOT_HERE", "compare_certificate", "named_system"]


NOT_HERE = "{} is not here: its declaration is as the file says"


def named_system(content: Mapping[str, Any], folder: Path) -> SystemKernels | None:
    """The system that a file names, if it is there."""
    try:
        return load_system(content["system"], folder)
    except InputError:
        return None


def compare_certificate(content: Mapping[str, Any], folder: Path) -> str | None:
    """Compare the declaration with that of the system at the parameters that are named.

    Returns
    -------
    str or None
        What could not be compared: the system is not there.

    Raises
    ------
    Failure
        If they differ.
    """
    if not content["declaration"]:
        return None
    kernels = named_system(content, folder)
    if kernels is None:
        return NOT_HERE.format(content["system"])
    kernels = kernels_with(kernels, content["declaration"])
    given = {name: given_value(name, text) for name, text in content["parameters"].items()}
    values = system_parameters(kernels, given)
    cycle = cycle_of(structure_of(kernels), [(c, b) for c, b in content["itinerary"]])
    work = content["bits"] + GUARD
    with flint_precision(work):
        tables = exact_tables(kernels, tuple(values.values()), work)
        if [value.text for value in tables.constants] != content["constants"]:
            raise Failure("the constants are not the irrational parameters")
        if declaration_json(tables, cycle) != content["declaration"]:
            raise Failure(f"the declaration is not that of {content['system']} at its parameters")
        if content["closing"]["kind"] == "period":
            period = value_json(given_value("period", content["given_period"]), work)
            if period != content["closing"]["period"]:
                raise Failure("the period is not the one that is given")
    return None
