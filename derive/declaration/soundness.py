"""Mistakes in declarations that are well formed: each is refused where it can be proved.

What depends on the parameters is refused only if it is wrong on their whole domain.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import lru_cache
from keyword import iskeyword
from typing import TYPE_CHECKING

import sympy as sp

from nonsmooth.derive.declaration.algebra import is_surely_positive_definite
from nonsmooth.derive.declaration.dynamics import SecondOrder
from nonsmooth.derive.declaration.names import check_name
from nonsmooth.derive.declaration.parameter import Parameter, is_positive
from nonsmooth.derive.errors import DeclarationError

if TYPE_CHECKING:
    from nonsmooth.derive.declaration.configuration import Configuration
    from nonsmooth.derive.declaration.system import System
    from nonsmooth.derive.declaration.transition import Transition

__all__ = ["check_soundness"]


def check_soundness(system: System) -> None:
    """Refuse a system that cannot move as it is declared.

    DeclarationError refuses an unusable name, a mass that is not symmetric and positive
    definite, a boundary without a transition, a transition that never applies, and a reset
    that lands where its target is left already.
    """
    check_name(system.name, "system")
    seen: dict[str, str] = {}
    for configuration in system.configurations:
        check_name(configuration.name, "configuration")
        other = seen.setdefault(configuration.name.replace("-", "_"), configuration.name)
        if other != configuration.name:
            raise DeclarationError(
                f"configurations {other!r} and {configuration.name!r} differ by hyphens only"
            )
    for state in system.states:
        if not str(state).isidentifier() or iskeyword(str(state)):
            raise DeclarationError(f"state {str(state)!r} is not an identifier")
    for configuration in system.configurations:
        _check_mass(configuration, system.parameters)
    if system.transitions or system.law is not None:
        _check_exits(system)
        _check_order(system.transitions)
        for transition in system.transitions:
            _check_landing(system, transition)


def _check_mass(configuration: Configuration, parameters: tuple[Parameter, ...]) -> None:
    if isinstance(configuration.dynamics, SecondOrder):
        fault = _fault(configuration.dynamics.mass, parameters)
        if fault:
            raise DeclarationError(f"configuration {configuration.name!r}: mass {fault}")


@lru_cache(maxsize=256)
def _fault(mass: sp.ImmutableMatrix, parameters: tuple[Parameter, ...]) -> str:
    """Why a mass matrix is not symmetric and positive definite; empty if that is not shown."""
    if is_surely_positive_definite(mass):
        return ""
    for i in range(mass.rows):
        for j in range(i):
            if sp.cancel(mass[i, j] - mass[j, i]) != 0:
                return f"is not symmetric: {mass[j, i]} and {mass[i, j]}"
    for size in range(1, mass.rows + 1):
        minor = sp.expand(mass[:size, :size].det())
        if minor == 0 or is_positive(-minor, parameters):
            return f"is not positive definite: its leading minor of order {size} is {minor}"
    return ""


def _check_exits(system: System) -> None:
    """Refuse a boundary without a transition, at which a motion would end."""
    left = {(t.source, name) for t in system.transitions for name in t.boundaries}
    for configuration in system.configurations:
        for boundary in configuration.boundaries:
            decided = system.law is not None and system.law.decides(frozenset({boundary.name}))
            if not decided and (configuration.name, boundary.name) not in left:
                raise DeclarationError(
                    f"configuration {configuration.name!r}: no transition leads on from"
                    f" boundary {boundary.name!r}"
                )


def _check_order(transitions: Sequence[Transition]) -> None:
    """Refuse a transition that an earlier one for the same boundaries always precedes."""
    before: dict[tuple[str, frozenset[str]], list[Transition]] = {}
    for transition in transitions:
        group = before.setdefault((transition.source, transition.boundaries), [])
        for earlier in group:
            other = earlier.order and transition.order not in (0, earlier.order)
            if not other and set(earlier.conditions) <= set(transition.conditions):
                names = " and ".join(sorted(transition.boundaries))
                raise DeclarationError(
                    f"transition {transition.source!r} -> {transition.target!r} by {names} never"
                    f" applies: the one to {earlier.target!r} before it applies whenever it does"
                )
        group.append(transition)


def _check_landing(system: System, transition: Transition) -> None:
    """Refuse a reset behind which the target is left already, or its constraints are broken.

    What depends on forces is not judged: a transition with conditions, or out of a contact,
    may be one that these numbers never take, and a contact may be left as soon as it is
    entered.
    """
    source, target = map(system.configuration, (transition.source, transition.target))
    if transition.conditions or len(transition.boundaries) > 1 or _held(source):
        return
    surfaces = [
        system.configuration(transition.source).boundary(name).function
        for name in sorted(transition.boundaries)
    ]
    rules = dict(transition.reset.items())
    where = f"transition {transition.source!r} -> {transition.target!r}"
    watched = {boundary.function for boundary in source.boundaries}
    for boundary in target.boundaries:
        if boundary.function in watched and not boundary.function.free_symbols & set(rules):
            continue
        value = _value_on(system, boundary.function.xreplace(rules), surfaces)
        if value is not None and _positive(value, system.parameters):
            raise DeclarationError(
                f"{where}: behind it boundary {boundary.name!r} is passed already"
                f" (its function is {value}, not negative)"
            )
    for constraint in target.constraints:
        value = _value_on(system, constraint.xreplace(rules), surfaces)
        if value is not None and any(_positive(s * value, system.parameters) for s in (1, -1)):
            raise DeclarationError(
                f"{where}: behind it {constraint} is {value}, where the target keeps it zero"
            )


def _held(configuration: Configuration) -> bool:
    """Whether a stop or friction holds the motion to a plane."""
    dynamics = configuration.dynamics
    return bool(configuration.constraints or (isinstance(dynamics, SecondOrder) and dynamics.held))


_positive = lru_cache(maxsize=1024)(is_positive)


def _value_on(system: System, function: sp.Expr, surfaces: Iterable[sp.Expr]) -> sp.Expr | None:
    """Value of an affine function on a surface on which it is constant.

    The first such surface counts; None if there is none.
    """
    row, constant = system.gradient(function)
    places = _support(row)
    if not places:
        return constant
    for surface in surfaces:
        normal, offset = system.gradient(surface)
        if _support(normal) != places:
            continue
        ratio = row[places[0]] / normal[places[0]]
        if all(sp.cancel(row[i] - ratio * normal[i]) == 0 for i in places[1:]):
            return sp.cancel(constant - ratio * offset)
    return None


def _support(row: sp.Matrix) -> list[int]:
    """Indices of the nonzero entries of a row."""
    return sorted(place for _, place in row.reshape(1, len(row)).todok())
