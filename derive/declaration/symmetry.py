"""Symmetries: directions along which nothing changes, and orbits declared by a part of them."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from nonsmooth.derive.declaration.configuration import Configuration
from nonsmooth.derive.declaration.itinerary import Itinerary, Phase
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.errors import DeclarationError
from nonsmooth.derive.symbols import Values

_LARGEST_ORDER = 64


def unfolded(itinerary: Itinerary) -> Itinerary:
    """The same orbit declared by all of its phases, without a symmetry.

    The dwell times of the k-th image end in ``_k``. DeclarationError says that the states'
    permutation maps a configuration of the orbit to none, or that none of its powers is the
    identity.
    """
    if not itinerary.symmetry:
        return itinerary
    system = itinerary.system
    images = {s: sp.sympify(itinerary.symmetry.get(s, s)) for s in system.states}
    phases, part = list(itinerary.phases), itinerary.phases
    for number in range(2, _order(images) + 1):
        part = tuple(_image(system, images, phase) for phase in part)
        phases += [
            replace(phase, dwell_time=f"{original.dwell_time}_{number}")
            for phase, original in zip(part, itinerary.phases, strict=True)
        ]
    return replace(itinerary, phases=tuple(phases), symmetry={}, start={}, reference=None)


def _order(images: Values) -> int:
    current = dict(images)
    for order in range(1, _LARGEST_ORDER + 1):
        if all(image == state for state, image in current.items()):
            return order
        current = {state: image.xreplace(dict(images)) for state, image in current.items()}
    raise DeclarationError("a symmetry whose powers are never the identity")


def _image(system: System, images: Values, phase: Phase) -> Phase:
    """The image of a phase, with the configuration and the boundary of the symmetric motion."""
    source = system.configuration(phase.configuration)
    wanted = _moved(source, system, images)
    for target in system.configurations:
        if _moved(target, system, {s: s for s in system.states}) == wanted:
            function = _through(source.boundary(phase.boundary).function, images)
            for boundary in target.boundaries:
                if sp.expand(boundary.function - function) == 0:
                    return replace(phase, configuration=target.name, boundary=boundary.name)
    raise DeclarationError(
        f"the symmetry maps configuration {source.name!r}, left by {phase.boundary!r}, to none"
    )


def _moved(
    configuration: Configuration, system: System, images: Values
) -> tuple[sp.Matrix, frozenset[sp.Expr]]:
    """Vector field and boundary functions of the image of a configuration."""
    states = sp.Matrix(system.states)
    matrix, offset = configuration.dynamics.field(system.states)
    # with z = P y: z' = P (A P^-1 z + b)
    permutation = sp.Matrix([images[s] for s in system.states]).jacobian(states)
    field = permutation * (matrix * permutation.T * states + offset)
    functions = (_through(b.function, images) for b in configuration.boundaries)
    return sp.ImmutableMatrix(field.applyfunc(sp.expand)), frozenset(map(sp.expand, functions))


def _through(function: sp.Expr, images: Values) -> sp.Expr:
    """A function of the state as a function of the state's image."""
    inverse = {}
    for state, image in images.items():
        (source,) = image.free_symbols
        inverse[source] = state if image == source else -state
    return sp.expand(function.subs(inverse, simultaneous=True))


def translations(system: System) -> sp.Matrix:
    """Directions of the state along which nothing changes, as columns (N x k).

    Most systems have none. See `moves_freely`.
    """
    size = len(system.states)
    columns = _dependences(system).nullspace(simplify=True) if moves_freely(system) else []
    return sp.ImmutableMatrix.hstack(sp.zeros(size, 0), *columns)


def moves_freely(system: System) -> bool:
    """Whether y + s d is a motion when y is, for some direction d and all parameters.

    No field, boundary, constraint or condition depends on s, and resets carry it along. It
    is decided at one point of the parameters, with numbers that fulfil no relation by
    accident.
    """
    matrix = _dependences(system)
    symbols = sorted(matrix.free_symbols, key=str)
    values = {s: sp.Rational(sp.prime(40 + 3 * k), 97 + k) for k, s in enumerate(symbols)}
    numbers = DomainMatrix.from_Matrix(matrix.xreplace(values)).to_field()
    return bool(numbers.rank() < len(system.states))


def _dependences(system: System) -> sp.Matrix:
    """Rows (k, N) orthogonal to every direction along which nothing depends on the state."""
    functions = [b.function for c in system.configurations for b in c.boundaries]
    functions += [row for c in system.configurations for row in c.constraints]
    functions += [c.function for t in system.transitions for c in t.conditions]
    functions += [image - state for t in system.transitions for state, image in t.reset.items()]
    gradients = [system.gradient(function)[0] for function in dict.fromkeys(functions)]
    fields = [c.dynamics.field(system.states)[0] for c in system.configurations]
    rows = [tuple(row) for matrix in (*fields, *gradients) for row in matrix.tolist()]
    return sp.Matrix(list(dict.fromkeys(rows)))
