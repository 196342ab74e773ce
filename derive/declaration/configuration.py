"""Configurations: the linear regimes of a system, their boundaries, and contacts seen in them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Literal

import sympy as sp

from nonsmooth.derive.declaration.dynamics import Dynamics, SecondOrder
from nonsmooth.derive.declaration.fields import declared
from nonsmooth.derive.declaration.soundness import check_unique, named


@declared
class Boundary:
    """A switching surface at which a configuration is left.

    Parameters
    ----------
    name : str
        Name by which itineraries refer to it.
    function : sympy expression
        Affine function g of the state, negative inside the configuration. The boundary is
        crossed when g rises through zero.
    acts_when : {"reached", "exceeded"}
        A velocity boundary acts when reached, tangentially too; a force limit only when
        exceeded.
    """

    name: str
    function: sp.Expr
    acts_when: Literal["reached", "exceeded"] = "exceeded"


@declared
class Configuration:
    """One linear regime of a system and the boundaries at which it is left.

    Parameters
    ----------
    name : str
    dynamics : SecondOrder or FirstOrder
    boundaries : tuple of Boundary
    constraints : tuple of expressions
        Affine functions of the state that vanish throughout, beside those that say that a
        held coordinate has its velocity: the place at which a mass rests.
    """

    name: str
    dynamics: Dynamics
    boundaries: tuple[Boundary, ...]
    constraints: tuple[sp.Expr, ...] = ()

    def __post_init__(self) -> None:
        check_unique([b.name for b in self.boundaries], f"boundary of configuration {self.name!r}")

    def boundary(self, name: str) -> Boundary:
        """Give the boundary of a name.

        Parameters
        ----------
        name : str

        Returns
        -------
        Boundary

        Raises
        ------
        DeclarationError
            If this configuration has no boundary of that name.
        """
        return named(self.boundaries, name, f"configuration {self.name!r} has no boundary")

    def held(self, states: Sequence[sp.Symbol]) -> dict[int, sp.Expr]:
        """Find which positions are held, in order.

        Parameters
        ----------
        states : sequence of symbols (N,)
            States of the system.

        Returns
        -------
        dict of int to expression
            Index of each held position, and its velocity.
        """
        dynamics = self.dynamics
        held = dynamics.held_at(states) if isinstance(dynamics, SecondOrder) else {}
        return dict(sorted(held.items()))

    def vanishing(self, states: Sequence[sp.Symbol]) -> list[sp.Expr]:
        """List the functions that are zero throughout: velocity minus held velocity, constraints.

        Parameters
        ----------
        states : sequence of symbols (N,)
            States of the system.

        Returns
        -------
        list of expressions
        """
        velocities = states[len(states) // 2 :]
        held = self.held(states).items()
        return [*(velocities[i] - value for i, value in held), *self.constraints]


@declared
class Contact:
    """Where the surroundings act on the oscillator: a stop, a belt.

    Parameters
    ----------
    name : str
    velocity : sympy expression
        Velocity of the point of the oscillator, affine in the state.
    forces : mapping of configuration to expression
        Force on the oscillator in the direction of `velocity`, affine in the state; zero in
        the configurations that are not named.
    surface : sympy expression
        Velocity of the surroundings there: of a belt, or zero. Their difference times the
        force is the power that is dissipated.
    """

    name: str
    velocity: sp.Expr
    forces: Mapping[str, sp.Expr]
    surface: sp.Expr = sp.S.Zero
