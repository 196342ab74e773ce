"""Transitions: what happens where a configuration is left, and on which conditions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import sympy as sp

from nonsmooth.derive.declaration.parameter import exact

__all__ = ["Condition", "Transition"]


@dataclass(frozen=True)
class Condition:
    """Demand that the first nonzero among g and its derivatives is positive, along one flow.

    Parameters
    ----------
    function : expression
        The function g, affine in the state.
    along : str
        Configuration whose flow gives the derivatives that decide where g vanishes.
    holds : bool
        False demands the contrary.
    """

    function: sp.Expr
    along: str
    holds: bool = True

    def __post_init__(self) -> None:
        object.__setattr__(self, "function", exact(self.function))


@dataclass(frozen=True)
class Transition:
    """What happens when `source` is left through a set of boundaries at one instant.

    Parameters
    ----------
    source, target : str
        Configurations before and after.
    boundaries : set of str
        Boundaries of `source` reached together; one alone in the ordinary case.
    conditions : tuple of Condition
        All must hold. Of several transitions for one set the first that applies is taken.
    reset : mapping of state symbol to expression
        Affine reset of the state; states that are not named stay.
    order : int
        Stops that are reached together may act in several orders. Transitions of each have a
        number of its own; the first that apply have to lead to one state, or what follows is
        ambiguous. Those of number 0 belong to all.
    """

    source: str
    boundaries: frozenset[str]
    target: str
    conditions: tuple[Condition, ...] = ()
    reset: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    order: int = 0

    def __post_init__(self) -> None:
        object.__setattr__(self, "boundaries", frozenset(self.boundaries))
        object.__setattr__(self, "conditions", tuple(self.conditions))
        object.__setattr__(self, "reset", sp.Dict({s: exact(e) for s, e in self.reset.items()}))

    def reset_of(self, state: sp.Matrix, states: Sequence[sp.Symbol]) -> sp.Matrix:
        """Apply the reset to a state.

        Parameters
        ----------
        state : column (N,)
            Expressions of the state before the transition.
        states : sequence of symbols (N,)
            States of the system, in order.

        Returns
        -------
        column (N,)
            State behind it.
        """
        before = dict(zip(states, state, strict=True))
        rules = dict(self.reset.items())
        return sp.Matrix([rules.get(s, s).subs(before, simultaneous=True) for s in states])
