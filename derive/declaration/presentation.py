"""Coordinates and parameters in which an orbit's equations are written."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cache, cached_property

import sympy as sp

from nonsmooth.derive.declaration.algebra import cancel
from nonsmooth.derive.declaration.configuration import Boundary, Configuration, Contact
from nonsmooth.derive.declaration.dynamics import FirstOrder, SecondOrder
from nonsmooth.derive.declaration.parameter import Parameter, exact
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.declaration.transition import Condition, Transition
from nonsmooth.derive.errors import DeclarationError

__all__ = ["Presentation"]


@dataclass(frozen=True)
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
    substitution: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)

    def __post_init__(self) -> None:
        object.__setattr__(self, "states", tuple(self.states))
        object.__setattr__(self, "origin", tuple(map(exact, self.origin)))
        substitution = {s: exact(e) for s, e in self.substitution.items()}
        object.__setattr__(self, "substitution", sp.Dict(substitution))
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
                return old.substituted(values | names).shifted(origin[: old.mass.rows, :])
            matrix, offset = old.matrix.subs(values), old.offset.subs(values)
            return FirstOrder(matrix, (offset + matrix * origin).applyfunc(cancel))

        replaced = set(values)
        kept = tuple(p for p in system.parameters if p.symbol not in replaced)
        return replace(
            system,
            states=self.states,
            parameters=kept + self.parameters,
            configurations=tuple(
                Configuration(
                    c.name,
                    dynamics(c.dynamics),
                    tuple(Boundary(b.name, affine(b.function), b.acts_when) for b in c.boundaries),
                    tuple(map(affine, c.constraints)),
                )
                for c in system.configurations
            ),
            transitions=tuple(
                Transition(
                    t.source,
                    t.boundaries,
                    t.target,
                    tuple(Condition(affine(c.function), c.along, c.holds) for c in t.conditions),
                    {
                        names[s]: affine(e) - o
                        for (s, e), o in (
                            (item, origin[system.states.index(item[0])]) for item in t.reset.items()
                        )
                    },
                    t.order,
                )
                for t in system.transitions
            ),
            constraints=tuple(sp.expand(c.subs(values)) for c in system.constraints),
            contacts=tuple(
                Contact(
                    c.name,
                    affine(c.velocity),
                    {name: affine(force) for name, force in c.forces.items()},
                    affine(c.surface),
                )
                for c in system.contacts
            ),
            forcing=tuple((names[c], names[s]) for c, s in system.forcing),
        )
