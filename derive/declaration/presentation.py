"""Coordinates and parameters in which an orbit's equations are written."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, replace
from functools import cache, cached_property
from typing import Any

import sympy as sp

from nonsmooth.derive.declaration.algebra import cancel
from nonsmooth.derive.declaration.configuration import Boundary, Configuration, Contact
from nonsmooth.derive.declaration.dynamics import FirstOrder, SecondOrder
from nonsmooth.derive.declaration.fields import declared
from nonsmooth.derive.declaration.parameter import Parameter
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.declaration.transition import Condition, Transition
from nonsmooth.derive.errors import DeclarationError
from nonsmooth.derive.symbols import Values


@declared
class Presentation:
    """Coordinates and parameters in which an orbit's equations are written.

    Parameters
    ----------
    states : tuple of symbols
        Names of the shifted states, in the order of the system's.
    origin : tuple of expressions
        Physical state at which all of them vanish: physical = shifted + origin.
    parameters : tuple of Parameter
        New parameters that the substitution brings in.
    substitution : mapping of symbol to expression
        System parameters in terms of the new ones, e.g. u_r = u_s + e.
    """

    states: tuple[sp.Symbol, ...]
    origin: tuple[sp.Expr, ...]
    parameters: tuple[Parameter, ...] = ()
    substitution: Values = field(default_factory=dict)

    def __post_init__(self) -> None:
        if len(self.origin) != len(self.states):
            raise DeclarationError(
                f"presentation has {len(self.states)} states but {len(self.origin)} origins"
            )

    def present(self, system: System) -> System:
        """Write a system in these coordinates and parameters.

        Parameters
        ----------
        system : System
            In physical coordinates and parameters.

        Returns
        -------
        System

        Raises
        ------
        DeclarationError
            If the system has another number of states, or a velocity of a second-order motion is
            shifted.
        """
        for known, presented in self._presented:
            if known is system:
                return presented
        presented = self._present(system)
        self._presented.append((system, presented))
        return presented

    @cached_property
    def _presented(self) -> list[tuple[System, System]]:
        """Systems with their presentations: orbits of one system often share theirs."""
        return []

    def _present(self, system: System) -> System:
        if len(self.states) != len(system.states):
            raise DeclarationError(
                f"presentation has {len(self.states)} states, system has {len(system.states)}"
            )
        values = dict(self.substitution.items())
        origin = sp.Matrix(self.origin).subs(values)
        names = dict(zip(system.states, self.states, strict=True))
        shifts = {s: names[s] + o for s, o in zip(system.states, origin, strict=True)}

        @cache
        def affine(expression: sp.Expr) -> sp.Expr:
            moved = sp.expand(expression.subs(values).subs(shifts, simultaneous=True))
            linear = sum(sp.diff(moved, s) * s for s in self.states)
            return linear + cancel(sp.expand(moved - linear))

        def dynamics(old: SecondOrder | FirstOrder) -> SecondOrder | FirstOrder:
            if isinstance(old, SecondOrder):
                if any(origin[old.mass.rows :, :]):
                    raise DeclarationError(
                        "presentation shifts a velocity, which a second-order motion cannot carry"
                    )
                return old.substituted(values | names, origin[: old.mass.rows, :])
            matrix, offset = old.matrix.subs(values), old.offset.subs(values)
            return FirstOrder(matrix, (offset + matrix * origin).applyfunc(cancel))

        def moved(value: Any) -> Any:
            """A part of the declaration in these coordinates."""
            if isinstance(value, sp.Expr):
                return affine(value)
            if isinstance(value, SecondOrder | FirstOrder):
                return dynamics(value)
            if isinstance(value, tuple):
                return tuple(map(moved, value))
            if isinstance(value, Mapping):
                return {name: moved(part) for name, part in value.items()}
            if isinstance(value, Configuration | Boundary | Condition | Contact):
                return replace(value, **{n: moved(part) for n, part in vars(value).items()})
            return value

        def transition(old: Transition) -> Transition:
            shifted = dict(zip(system.states, origin, strict=True))
            reset = {names[s]: affine(e) - shifted[s] for s, e in old.reset.items()}
            return replace(old, conditions=moved(old.conditions), reset=reset)

        return replace(
            system,
            states=self.states,
            parameters=(
                *(p for p in system.parameters if p.symbol not in values),
                *self.parameters,
            ),
            configurations=moved(system.configurations),
            transitions=tuple(map(transition, system.transitions)),
            constraints=tuple(sp.expand(c.subs(values)) for c in system.constraints),
            contacts=moved(system.contacts),
            forcing=tuple((names[c], names[s]) for c, s in system.forcing),
        )
