"""The declaration that a file states, as functions of the parameters that the file names.

So every name and value that is printed is bound to the tables that are proved about: who reads
the file evaluates them at its values.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache
from typing import Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import Value, parse
from nonsmooth.runtime.model.completion import follow
from nonsmooth.runtime.model.kernels import OrbitKernels, SystemKernels
from nonsmooth.runtime.proof.exact_tables import (
    NotRational,
    Tables,
    constants_over,
    irrational_texts,
    rational_of,
    tables_over,
)
from nonsmooth.runtime.proof.statement import declaration_json
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape

__all__ = ["PERIOD", "orbit_declaration", "system_declaration", "tables_of_orbit"]

PERIOD = "period"  # its name among the parameters at one point


def system_declaration(
    kernels: SystemKernels,
    cycle: ItineraryShape,
    tables: Tables,
    start: Sequence[str],
    dwell: Sequence[str],
    *,
    timed: bool,
) -> dict[str, Any]:
    """Return the declaration over all parameters of the system, as `declaration_json` gives it.

    If `timed`, the given period is one more parameter. Where the declaration takes a root or a sine
    of its parameters there are no such functions: then it is that of the tables, which hold the
    numbers at the orbit's parameters. `start` and `dwell` are names of states and dwell times.
    """
    names = tuple(table.name for table in kernels.parameters) + (PERIOD,) * timed
    texts = tuple(irrational_texts(kernels, tables.constants if timed else ()))
    try:
        return declaration_json(_tables(kernels, None, names, texts), cycle, names, start, dwell)
    except NotRational:
        return declaration_json(tables, cycle, (), start, dwell)


def orbit_declaration(
    kernels: SystemKernels,
    orbit: OrbitKernels | None,
    cycle: ItineraryShape,
    names: Sequence[str],
    start: Sequence[str],
    dwell: Sequence[str],
    texts: Iterable[str],
) -> dict[str, Any]:
    """Return the declaration over parameters of an orbit, as `declaration_json` gives it.

    `orbit`, `names` and `texts` are as for `tables_of_orbit`.
    """
    tables = tables_of_orbit(kernels, orbit, names, texts)
    return declaration_json(tables, cycle, names, start, dwell)


def tables_of_orbit(
    kernels: SystemKernels,
    orbit: OrbitKernels | None,
    names: Iterable[str],
    texts: Iterable[str],
    fixed: Mapping[str, Value] | None = None,
) -> Tables:
    """Return exact tables of a system as functions of parameters of an orbit.

    `orbit` holds the orbit's functions where its parameters are not the system's, which follow from
    them. `names` are the parameters that the entries are functions of, `fixed` has the values of
    others, and `texts` are the irrational numbers of the declaration and of all parameters.
    `NotRational` is raised if the declaration takes a root or a sine of its parameters.
    """
    return _tables(kernels, orbit, tuple(names), tuple(texts), tuple((fixed or {}).items()))


@lru_cache(maxsize=64)
def _tables(
    kernels: SystemKernels,
    orbit: OrbitKernels | None,
    names: tuple[str, ...],
    texts: tuple[str, ...],
    fixed: tuple[tuple[str, Value], ...] = (),
) -> Tables:
    required = {} if orbit is None else {n: parse(text) for n, text in orbit.required.items()}
    own = [value.text for value in required.values() if value.exact is None]
    known = constants_over(names, [*texts, *own])
    found: dict[str, Any] = {
        name: known.numbers[v.text] if v.exact is None else rational_of(v.exact)
        for name, v in (*required.items(), *fixed)
    }
    found |= zip(names, known.variables, strict=True)
    if orbit is not None:
        found |= follow(orbit, found, rational_of)
        if missing := [table.name for table in kernels.parameters if table.name not in found]:
            raise InputError(f"{orbit.name}: {', '.join(missing)} left open")
    return tables_over(kernels, [found[table.name] for table in kernels.parameters], known)
