"""The declaration that a file states, as functions of the parameters that the file names.

So every name and value that is printed is bound to the tables that are proved about: who reads
the file evaluates them at its values.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.rational_functions import symbols
from nonsmooth.runtime.core.values import parse
from nonsmooth.runtime.model.completion import follow
from nonsmooth.runtime.model.kernels import OrbitKernels, SystemKernels
from nonsmooth.runtime.proof.exact_tables import NotRational, Tables, rational_of, tables_over
from nonsmooth.runtime.proof.orbit_cycle import NotCovered
from nonsmooth.runtime.proof.statement import declaration_json
from nonsmooth.runtime.shooting.shooting_map import Cycle

__all__ = ["PERIOD", "orbit_declaration", "system_declaration"]

PERIOD = "period"  # its name among the parameters at one point


def system_declaration(
    kernels: SystemKernels,
    cycle: Cycle,
    tables: Tables,
    start: Sequence[str],
    dwell: Sequence[str],
    *,
    timed: bool,
) -> dict[str, Any]:
    """The declaration over all parameters of the system, and the period where that is given.

    Where it takes a root or a sine there are no such functions: it is that of the tables.
    """
    names = tuple(table.name for table in kernels.parameters) + (PERIOD,) * timed
    try:
        return declaration_json(_tables(kernels, None, names), cycle, names, start, dwell)
    except NotRational:
        return declaration_json(tables, cycle, (), start, dwell)


def orbit_declaration(
    kernels: SystemKernels,
    orbit: OrbitKernels | None,
    cycle: Cycle,
    names: Sequence[str],
    start: Sequence[str],
    dwell: Sequence[str],
) -> dict[str, Any]:
    """The declaration over parameters of an orbit, from which the system's follow.

    Raises
    ------
    NotRational
    """
    return declaration_json(_tables(kernels, orbit, tuple(names)), cycle, names, start, dwell)


@lru_cache(maxsize=64)
def _tables(kernels: SystemKernels, orbit: OrbitKernels | None, names: tuple[str, ...]) -> Tables:
    found = dict(zip(names, symbols(names), strict=True))
    if orbit is not None:
        found = _required(orbit) | found
        found |= follow(orbit, found, rational_of)
        if missing := [table.name for table in kernels.parameters if table.name not in found]:
            raise InputError(f"{orbit.name}: {', '.join(missing)} left open")
    return tables_over(kernels, [found[table.name] for table in kernels.parameters])


def _required(orbit: OrbitKernels) -> dict[str, Any]:
    exact = {name: parse(text).exact for name, text in orbit.required.items()}
    if None in exact.values():
        raise NotCovered(f"{orbit.name} takes irrational values of {', '.join(exact)}")
    return {name: rational_of(value) for name, value in exact.items() if value is not None}
