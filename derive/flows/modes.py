"""Modes of a flow: its functions of time, those of one exponent together."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from nonsmooth.derive.flows.modal import TIME, Flow

__all__ = ["Mode", "modes_of"]


@dataclass(frozen=True)
class Mode:
    """Functions of time that share one exponent."""

    rate: sp.Expr  # real part of the exponent
    frequency: sp.Expr  # imaginary part of the exponent; zero if the mode does not oscillate
    terms: tuple[sp.Expr, ...]  # basis functions of the flow: powers of time, or cosine and sine

    @property
    def oscillates(self) -> bool:
        """Whether the exponent has an imaginary part."""
        return bool(self.frequency != 0)

    @property
    def length(self) -> int:
        """Number of powers of time."""
        return len(self.terms) // (2 if self.oscillates else 1)


def modes_of(flow: Flow) -> tuple[Mode, ...] | None:
    """Modes of a flow; None if one of its functions is no power of time, cosine or sine."""
    powers: list[int] = []
    angles: list[sp.Expr] = []
    for function in flow.basis:
        if function.is_polynomial(TIME):
            powers.append(int(sp.degree(function, TIME)) if function != 1 else 0)
        elif isinstance(function, sp.cos | sp.sin):
            if function.args[0] not in angles:
                angles.append(function.args[0])
        else:
            return None
    polynomial = tuple(TIME**k for k in range(max(powers) + 1)) if powers else ()
    found = [Mode(sp.Integer(0), sp.Integer(0), polynomial)] if polynomial else []
    for angle in angles:
        frequency = sp.cancel(angle / TIME)
        found.append(Mode(sp.Integer(0), frequency, (sp.cos(angle), sp.sin(angle))))
    return tuple(found)
