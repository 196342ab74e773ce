"""Mistakes in declarations: what does not fit together, and what cannot move as it is declared.

Each is refused where it can be proved. What depends on the parameters is refused only if it is
wrong on their whole domain.
"""

from __future__ import annotations

from collections.abc import Sequence, Set
from functools import lru_cache
from keyword import iskeyword
from typing import TYPE_CHECKING, TypeVar

import sympy as sp

from nonsmooth.derive.declaration.algebra import (
    along,
    cancel,
    is_affine,
    is_surely_positive_definite,
)
from nonsmooth.derive.declaration.dynamics import SecondOrder
from nonsmooth.derive.declaration.parameter import (
    Parameter,
    check_finite,
    is_positive,
    is_rational,
    sign_of,
)
from nonsmooth.derive.errors import DeclarationError

if TYPE_CHECKING:
    from nonsmooth.derive.declaration.configuration import Boundary, Configuration
    from nonsmooth.derive.declaration.system import System
    from nonsmooth.derive.declaration.transition import Transition

_Named = TypeVar("_Named", "Boundary", "Configuration")


def check_name(name: str, what: str) -> None:
    """Refuse a name that cannot be that of a file and a function.

    A name has letters, digits, hyphens and underscores, and begins with a letter;
    DeclarationError refuses another one.
    """
    plain = isinstance(name, str) and name.replace("-", "_")
    if not plain or not plain.isidentifier() or iskeyword(plain) or plain.startswith("_"):
        raise DeclarationError(
            f"{what} {name!r} is no name: letters, digits and hyphens, a letter first"
        )


def check_unique(names: Sequence[str], what: str) -> None:
    """Refuse, by DeclarationError, a name that occurs twice."""
    for name in names:
        if names.count(name) > 1:
            raise DeclarationError(f"{what} {name!r} is declared twice")


def named(records: Sequence[_Named], name: str, without: str) -> _Named:
    """The record of a name; DeclarationError says what is without it, and which names there are."""
    for record in records:
        if record.name == name:
            return record
    known = ", ".join(record.name for record in records)
    raise DeclarationError(f"{without} {name!r} (it has: {known})")


def check_system(system: System) -> None:
    """Refuse a system whose parts do not fit, or that cannot move as it is declared.

    DeclarationError refuses a wrong size, an unknown or unusable name, a function that is not
    affine, a mass that is not symmetric and positive definite, a boundary without a transition,
    a transition that never applies, and a reset that lands where its target is left already.
    """
    check_unique([c.name for c in system.configurations], "configuration")
    for constraint in system.constraints:
        where = f"constraint {constraint} >= 0"
        check_finite(constraint, where)
        _check_symbols(system, constraint.free_symbols, where, states_allowed=False)
        if not is_rational(constraint):
            raise DeclarationError(
                f"{where} is no rational function of parameters with rational coefficients"
            )
    for configuration in system.configurations:
        _check_configuration(system, configuration)
    for transition in system.transitions:
        _check_transition(system, transition)
    check_unique([c.name for c in system.contacts], "contact")
    for contact in system.contacts:
        for name in contact.forces:
            system.configuration(name)
        for function in (*contact.forces.values(), contact.velocity, contact.surface):
            _check_affine(system, function, f"contact {contact.name!r}")
    for cosine, sine in system.forcing:
        _check_forcing(system, cosine, sine)
    _check_names(system)
    for configuration in system.configurations:
        _check_mass(configuration, system.parameters)
    if system.transitions or system.law is not None:
        _check_exits(system)
        _check_order(system.transitions)
        for transition in system.transitions:
            _check_landing(system, transition)


def _check_configuration(system: System, configuration: Configuration) -> None:
    where = f"configuration {configuration.name!r}"
    dynamics, size = configuration.dynamics, len(system.states)
    if isinstance(dynamics, SecondOrder):
        coordinates = dynamics.mass.rows
        if 2 * coordinates != size:
            raise DeclarationError(
                f"{where}: mass is {coordinates} x {coordinates},"
                f" but the system has {size} states ({size // 2} positions)"
            )
        for symbol in dynamics.held:
            if symbol not in system.states[:coordinates]:
                raise DeclarationError(f"{where}: held coordinate {symbol} is not a position")
        held = dynamics.held_at(system.states)
        free = [i for i in range(coordinates) if i not in held]
        surely = is_surely_positive_definite(dynamics.mass)
        if free and not surely and dynamics.mass.extract(free, free).det() == 0:
            raise DeclarationError(f"{where}: mass of the free coordinates is singular")
    elif dynamics.matrix.rows != size:
        raise DeclarationError(
            f"{where}: matrix is {dynamics.matrix.rows} x {dynamics.matrix.rows},"
            f" but the system has {size} states"
        )
    _check_symbols(system, dynamics.free_symbols(), where, states_allowed=False)
    for boundary in configuration.boundaries:
        _check_affine(system, boundary.function, f"{where}, boundary {boundary.name!r}")
    for function in configuration.constraints:
        _check_affine(system, function, f"{where}, constraint {function}")


def _check_transition(system: System, transition: Transition) -> None:
    where = f"transition {transition.source!r} -> {transition.target!r}"
    source = system.configuration(transition.source)
    system.configuration(transition.target)
    if not transition.boundaries:
        raise DeclarationError(f"{where}: no boundary is named")
    for name in sorted(transition.boundaries):
        source.boundary(name)
    for condition in transition.conditions:
        system.configuration(condition.along)
        _check_affine(system, condition.function, where)
    for symbol, expression in transition.reset.items():
        if symbol not in system.states:
            raise DeclarationError(f"{where}: reset of {symbol}, which is not a state")
        _check_affine(system, expression, f"{where}, reset of {symbol}")


def _check_forcing(system: System, cosine: sp.Symbol, sine: sp.Symbol) -> None:
    """Refuse a pair that turns differently in some configuration, or that a reset changes."""
    where = f"forcing {cosine}, {sine}"
    for symbol in (cosine, sine):
        if symbol not in system.states:
            raise DeclarationError(f"{where}: {symbol} is not a state")
    first, second = map(system.states.index, (cosine, sine))
    speeds = set()
    for configuration in system.configurations:
        matrix, offset = configuration.dynamics.field(system.states)
        speed = matrix[second, first]
        for place, wanted in ((first, -speed * sine), (second, speed * cosine)):
            rate = along(matrix.row(place), system.states) + offset[place]
            if sp.expand(rate - wanted) != 0:
                raise DeclarationError(
                    f"{where}: in {configuration.name!r} it does not turn, c' = -w s, s' = w c"
                )
        speeds.add(cancel(speed))
    if len(speeds) > 1 and len({sp.simplify(speed) for speed in speeds}) > 1:
        raise DeclarationError(f"{where}: it turns at different speeds: {speeds}")
    for transition in system.transitions:
        if {cosine, sine} & set(transition.reset):
            raise DeclarationError(
                f"transition {transition.source!r} -> {transition.target!r} resets the {where}"
            )


def _check_affine(system: System, function: sp.Expr, where: str) -> None:
    check_finite(function, where)
    _check_symbols(system, function.free_symbols, where)
    if not is_affine(function, frozenset(system.states)):
        raise DeclarationError(f"{where}: {function} is not affine in the state")


def _check_symbols(
    system: System, symbols: Set[sp.Symbol], where: str, *, states_allowed: bool = True
) -> None:
    known = {p.symbol for p in system.parameters}.union(system.states if states_allowed else ())
    unknown = sorted(str(s) for s in symbols - known)
    if unknown and unknown[0] in map(str, known):
        raise DeclarationError(
            f"{where}: symbol {unknown[0]} has other assumptions than the declared"
            f" {unknown[0]}: use the symbol of the states, or Parameter.symbol"
        )
    if unknown:
        kind = "neither a state nor a parameter" if states_allowed else "not a parameter"
        raise DeclarationError(f"{where}: symbol {unknown[0]} is {kind}")


def _check_names(system: System) -> None:
    """Refuse a name that the files and functions of a system cannot bear."""
    check_name(system.name, "system")
    seen: dict[str, str] = {}
    for configuration in system.configurations:
        check_name(configuration.name, "configuration")
        other = seen.setdefault(configuration.name.replace("-", "_"), configuration.name)
        if other != configuration.name:
            raise DeclarationError(
                f"configurations {other!r} and {configuration.name!r} differ by hyphens only"
            )
    for state in map(str, system.states):
        if not state.isidentifier() or iskeyword(state):
            raise DeclarationError(f"state {state!r} is not an identifier")


def _check_mass(configuration: Configuration, parameters: tuple[Parameter, ...]) -> None:
    if isinstance(configuration.dynamics, SecondOrder):
        fault = fault_of_mass(configuration.dynamics.mass, parameters)
        if fault:
            raise DeclarationError(f"configuration {configuration.name!r}: mass {fault}")


@lru_cache(maxsize=256)
def fault_of_mass(mass: sp.ImmutableMatrix, parameters: tuple[Parameter, ...]) -> str:
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
            told = sp.N(minor, 6) if minor.is_number and len(str(minor)) > 20 else minor
            return f"is not positive definite: its leading minor of order {size} is {told}"
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
    held = source.constraints or source.held(system.states)  # by a stop or friction, to a plane
    if transition.conditions or len(transition.boundaries) > 1 or held:
        return
    (name,) = transition.boundaries
    surface = source.boundary(name).function
    rules = dict(transition.reset.items())
    where = f"transition {transition.source!r} -> {transition.target!r}"
    watched = {boundary.function for boundary in source.boundaries}
    for boundary in target.boundaries:
        if boundary.function in watched and not boundary.function.free_symbols & set(rules):
            continue
        value = _value_on(system, boundary.function.xreplace(rules), surface)
        if value is not None and is_positive(value, system.parameters):
            raise DeclarationError(
                f"{where}: behind it boundary {boundary.name!r} is passed already"
                f" (its function is {value}, not negative)"
            )
    for constraint in target.constraints:
        value = _value_on(system, constraint.xreplace(rules), surface)
        if value is not None and sign_of(value, system.parameters):
            raise DeclarationError(
                f"{where}: behind it {constraint} is {value}, where the target keeps it zero"
            )


def _value_on(system: System, function: sp.Expr, surface: sp.Expr) -> sp.Expr | None:
    """Value of an affine function on a surface; None if it is not constant there."""
    row, constant = system.gradient(function)
    places = _support(row)
    if not places:
        return constant
    normal, offset = system.gradient(surface)
    if _support(normal) != places:
        return None
    ratio = row[places[0]] / normal[places[0]]
    if any(sp.cancel(row[i] - ratio * normal[i]) != 0 for i in places[1:]):
        return None
    return sp.cancel(constant - ratio * offset)


def _support(row: sp.Matrix) -> list[int]:
    """Indices of the nonzero entries of a row."""
    return sorted(place for _, place in row.todok())
