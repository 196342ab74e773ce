"""Centres of configurations, with letters of their own in the formulas of an orbit.

Inside a configuration with the centre d, the state is d + Phi(t) (X(0) - d). The kernels
compute with the parameters in place of d; a document writes d.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

import sympy as sp

from nonsmooth.derive.declaration.algebra import cancel, factor
from nonsmooth.derive.document.notation.letters import free, is_response
from nonsmooth.derive.flows.modal import Flow
from nonsmooth.derive.symbols import Symbol

__all__ = ["Centres", "centre_of", "name_centres"]


@dataclass(frozen=True)
class Centres:
    """Centres that differ from the origin, by configuration."""

    # by configuration, N x 1: symbols of the coordinates that are not zero
    columns: Mapping[str, sp.Matrix]
    values: Mapping[sp.Symbol, sp.Expr]  # expression of each symbol

    def written(self, flow: Flow) -> Flow:
        """The flow with the symbols of its centre in place of the parameters."""
        column = self.columns.get(flow.configuration)
        if column is None:
            return flow
        offsets = [
            (column if function == 1 else 0 * column) - matrix * column
            for function, matrix in zip(flow.basis, flow.matrices, strict=True)
        ]
        return replace(flow, offsets=tuple(sp.ImmutableMatrix(o) for o in offsets))


def name_centres(flows: Iterable[Flow], taken: Iterable[str]) -> Centres:
    """Centres of an orbit's configurations, with a letter that no other symbol has.

    `taken` is the LaTeX of all other symbols.
    """
    shown = list(flows)
    if any(map(is_response, shown)):
        shown = []  # motions are written coordinate by coordinate, about no centre
    found = {f.configuration: c for f in shown if (c := centre_of(f)) and not c.is_zero_matrix}
    columns: dict[str, sp.Matrix] = {}
    values: dict[sp.Symbol, sp.Expr] = {}
    letter = free(("d", "c", r"\bar{x}"), {u.partition("_")[0] for u in taken if "_" in u})
    for configuration, centre in found.items():
        which = "" if len(found) == 1 else rf"\text{{{configuration}}},"
        column = sp.zeros(*centre.shape)
        for place, value in enumerate(centre):
            if value == 0:
                continue
            latex = f"{letter}_{{{which}{place + 1}}}"
            symbol = Symbol("written", f"centre_of_{configuration}_{place}", latex)
            column[place], values[symbol] = symbol, value
        columns[configuration] = sp.ImmutableMatrix(column)
    return Centres(columns, values)


def centre_of(flow: Flow) -> sp.Matrix | None:
    """Point c with y(t) - c = Phi(t) (y(0) - c), as N x 1; None if there is none.

    Components that are free are zero.
    """
    matrix, offset = flow.field
    size = matrix.rows
    # states that drift come last, so that they are the free ones
    drifting = (matrix * matrix).applyfunc(cancel)
    order = sorted(range(size), key=lambda i: (not any(drifting[i, :]), i))
    unknowns = sp.symbols(f"centre0:{size}")
    solutions = sp.linsolve((matrix[:, order], -offset), *unknowns)
    if not solutions:
        return None
    (solution,) = solutions
    values = sp.Matrix(solution).subs(dict.fromkeys(unknowns, 0)).applyfunc(factor)
    return sp.Matrix([values[order.index(i)] for i in range(size)])
