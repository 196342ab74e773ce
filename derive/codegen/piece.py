"""A piece of a large system as Python: tables as JSON, of numbers those that are not zero.

Numbers are data. What depends on parameters is computed by one function for fields, for rows and
for resets, over any arithmetic; each result has its place in a matrix.
The names of rows and resets tell which of several pieces are the same. STARTS has the rows of
every regime of every part that are not positive in it, and those that vanish; ONE the row that
is 1.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence

import sympy as sp

from nonsmooth.derive.codegen.any_arithmetic import python_kernel
from nonsmooth.derive.codegen.python_file import system_table
from nonsmooth.derive.codegen.simulation_form import SimulationForm
from nonsmooth.derive.declaration.dynamics import Dynamics
from nonsmooth.derive.declaration.system import System, text_hash
from nonsmooth.derive.equations.program import Array, Kernel

_Conditions = Mapping[str, tuple[Sequence[sp.Expr], Sequence[sp.Expr]]]


def emit_piece(
    system: System,
    others: Mapping[str, Dynamics],
    led: Sequence[str],
    conditions: Sequence[_Conditions],
) -> str:
    """Source of the Python file of one configuration of a large system.

    `system` has only the configuration that is visited. `others` are the dynamics of those
    configurations along which conditions are judged, and `led` names further ones that
    transitions lead to. For each part and regime `conditions` has the functions that are
    not positive in the regime, and those that vanish in it.
    """
    told = [f for part in conditions for both in part.values() for group in both for f in group]
    form = SimulationForm(system, beside=(*told, sp.S.One), along=tuple(others.values()))
    starts = [
        {
            regime: tuple([form.row(f) for f in group] for group in both)
            for regime, both in part.items()
        }
        for part in conditions
    ]
    (visited,) = system.configurations
    shapes = {}
    numbers: dict[str, list[tuple[int, int, int, int]]] = {}
    places: dict[str, list[tuple[int, int]]] = {}
    functions = []
    for name, (count, entries) in form.matrices.items():
        shapes[name] = (count, len(system.states) + 1)
        numbers[name] = [
            (i, j, int(e.p), int(e.q)) for (i, j), e in entries.items() if e.is_Rational
        ]
        symbolic = {place: e for place, e in entries.items() if not e.is_Rational}
        places[name] = list(symbolic)
        functions.append(_function(name, system, tuple(symbolic.values())))
    tables = json.dumps(
        {
            "SYSTEM": system_table(form),
            "FIELDS": [visited.name, *others],
            "LED": list(led),
            "ONE": form.row(sp.S.One),
            "STARTS": starts,
            "SHAPES": shapes,
            "NUMBERS": numbers,
            "PLACES": places,
            "ROWS": [text_hash(str(row)) for row in form.rows],
            "RESETS": [text_hash(*map(str, column)) for column in form.resets],
        }
    )
    body = "\n\n\n".join(functions)
    derivation = text_hash(tables, body)
    return (
        "import json\n\n"
        f'DERIVATION = "{derivation}"\n\n'
        f"globals().update(json.loads({tables!r}))\n\n\n{body}\n"
    )


def _function(name: str, system: System, entries: tuple[sp.Expr, ...]) -> str:
    kernel = Kernel.of(
        f"{name}_entries",
        "What depends on parameters, in the order of its places.",
        [Array.of("parameters", (p.symbol for p in system.parameters))],
        {"entries": entries},
    )
    return python_kernel(kernel, None)
