"""The usual oscillators declared in a few lines."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain, combinations
from math import prod
from reprlib import repr
from typing import Any

import sympy as sp

from nonsmooth.derive.building.assembly import Assembly
from nonsmooth.derive.building.constraints import constraints_of
from nonsmooth.derive.building.coupling import contact_law
from nonsmooth.derive.building.element_parts import part_of, states_of
from nonsmooth.derive.building.elements import Element, Harmonic
from nonsmooth.derive.building.frame import Frame, inferred_parameters, square, velocity_name
from nonsmooth.derive.building.growing import GrowingSystem, is_large
from nonsmooth.derive.building.parts import FrictionPart
from nonsmooth.derive.building.transitions import transitions_from
from nonsmooth.derive.declaration.algebra import frozen, is_surely_positive_definite
from nonsmooth.derive.declaration.names import check_unique
from nonsmooth.derive.declaration.parameter import Parameter
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.errors import DeclarationError

__all__ = ["oscillator"]


def oscillator(
    name: str,
    coordinates: Sequence[str],
    mass: Any,
    stiffness: Any,
    damping: Any = None,
    load: Any = None,
    forcing: Sequence[Harmonic] = (),
    elements: Sequence[Element] = (),
    parameters: Sequence[Parameter] = (),
    description: str = "",
    simultaneous_impacts: str | None = None,
) -> System:
    """Declare ``mass x'' + damping x' + stiffness x = load + forcing + elements``.

    Each element multiplies the configurations by its regimes: a configuration bears their
    names in the order of the elements, ``slip-free``; without elements it is ``free``. All
    boundaries that different elements can reach at one instant have transitions. Where these are
    too many to list, as those of ten contacts, they are made when a motion or an itinerary visits
    them. What the laws of the elements need of the parameters (static friction not below kinetic,
    a load that is not negative), and their domains leave open, becomes a constraint of the system.

    Parameters
    ----------
    name : str
    coordinates : n names
        Positions; the velocity of x1 is v1, that of phi is v_phi.
    mass, stiffness, damping : n x n matrices
        Numbers or expressions; mass symmetric and positive definite. No damping when omitted.
        NumPy arrays and SciPy sparse matrices are taken as the binary fractions that they hold,
        numbers in lists as their shortest decimals.
    load : n values, or mapping of coordinate to value
        Constant forces.
    forcing : sequence of Harmonic
        Each adds the states c1, s1, c2, s2, ... behind the velocities.
    elements : sequence of Element
        RigidStop, SoftStop, Friction, Slider, Regions.
    parameters : sequence of Parameter
        Domains. A symbol that is not named here gets a domain by its assumptions (positive,
        nonnegative, negative, real); one without assumptions is positive, and a coefficient
        of restitution lies in [0, 1]. Symbols are told apart by their names alone.
    description : str
    simultaneous_impacts : {"sequence", "moreau"}, optional
        How rigid stops act that are reached at one instant where an impact on one changes the
        velocity at another: one after another as they are listed in `elements`, or at once by
        Moreau's law, whose impulses push and leave no stop slower than by its restitution.
        When omitted all orders are compared: if they lead to one state, that follows; if not,
        what follows is ambiguous.

    Returns
    -------
    System

    Raises
    ------
    DeclarationError
        For a wrong shape, an unknown coordinate, a repeated name, a function that is not
        affine in the state, a mass that is not symmetric and positive definite, or contacts
        that depend on each other.

    Examples
    --------
    >>> from nonsmooth.derive.building import RigidStop, chain_matrices, oscillator
    >>> mass, stiffness, _ = chain_matrices([1, 2], [5, 1])
    >>> system = oscillator("two", ["x1", "x2"], mass, stiffness,
    ...                     elements=[RigidStop("x2", at=1, restitution=0.8, name="stop")])
    >>> [c.name for c in system.configurations]
    ['free', 'contact']
    """
    assembly = _assembled(
        coordinates, mass, stiffness, damping, load, forcing, elements, parameters,
        simultaneous_impacts,
    )  # fmt: skip
    plural = "" if len(coordinates) == 1 else "s"
    described = f"oscillator with {len(coordinates)} coordinate{plural}"
    constraints = constraints_of(assembly.frame, elements, assembly.parts)
    if is_large(assembly):
        most = prod(len(part.regimes) for part in assembly.parts)
        described += f", its configurations (up to {most:,}) made when they are visited"
        return GrowingSystem(name, description or described, assembly, constraints)
    products = assembly.products
    return System(
        name=name,
        description=description or described,
        states=assembly.frame.states,
        parameters=assembly.frame.parameters,
        configurations=tuple(assembly.configuration(regimes) for regimes in products),
        transitions=tuple(t for regimes in products for t in transitions_from(assembly, regimes)),
        constraints=constraints,
        contacts=assembly.contacts(products),
        forcing=assembly.phases,
        law=contact_law(assembly, products),
    )


def _assembled(
    coordinates: Sequence[str],
    mass: Any,
    stiffness: Any,
    damping: Any,
    load: Any,
    forcing: Sequence[Harmonic],
    elements: Sequence[Element],
    parameters: Sequence[Parameter],
    simultaneous_impacts: str | None,
) -> Assembly:
    if simultaneous_impacts not in (None, "sequence", "moreau"):
        raise DeclarationError(
            f"simultaneous_impacts is {simultaneous_impacts!r}, not 'sequence' or 'moreau'"
        )
    _check_list("forcing", forcing, (Harmonic,), 'F cos(w t) is Harmonic(w, cosine={"x": F})')
    kinds = tuple(kind for kind in part_of.registry if kind is not object)
    _check_list("elements", elements, kinds, ", ".join(kind.__name__ for kind in kinds))
    _check_list("parameters", parameters, (Parameter,), 'Parameter("k", "stiffness")')
    coordinates, size = list(coordinates), len(coordinates)
    if size == 0:
        raise DeclarationError("an oscillator needs a coordinate")
    check_unique(coordinates, "coordinate")
    check_unique([element.name for element in elements], "element")
    positions = tuple(sp.Symbol(n, real=True) for n in coordinates)
    velocities = tuple(sp.Symbol(velocity_name(n), real=True) for n in coordinates)
    phases = tuple(
        (sp.Symbol(f"c{k}", real=True), sp.Symbol(f"s{k}", real=True))
        for k in range(1, len(forcing) + 1)
    )
    others = (*chain.from_iterable(phases), *chain.from_iterable(map(states_of, elements)))
    states = [str(s) for s in (*positions, *velocities, *others)]
    matrix = square(mass, "mass", size)
    declared = inferred_parameters(
        parameters, states, matrix, stiffness, damping, load, list(forcing), list(elements)
    )
    bare = Frame(positions, velocities, others, declared, matrix)
    frame = Frame(positions, velocities, others, declared, _mass(bare.matrix(matrix, "mass")))
    forces = (
        frame.column(load, "load")
        - frame.matrix(_given(stiffness, "stiffness"), "stiffness") * sp.Matrix(positions)
        - frame.matrix(damping, "damping") * sp.Matrix(velocities)
    )
    rates: list[tuple[sp.Symbol, sp.Expr]] = []
    for harmonic, (cosine, sine) in zip(forcing, phases, strict=True):
        frequency = frame.expression(harmonic.frequency)
        phase = frame.expression(harmonic.phase)
        turned = sp.cos(phase) * cosine - sp.sin(phase) * sine
        forces += frame.column(harmonic.cosine, "cosine amplitudes") * turned
        turned = sp.cos(phase) * sine + sp.sin(phase) * cosine
        forces += frame.column(harmonic.sine, "sine amplitudes") * turned
        rates += [(cosine, -frequency * sine), (sine, frequency * cosine)]
    parts = tuple(part_of(element, frame, elements) for element in elements)
    assembly = Assembly(
        frame, parts, sp.ImmutableMatrix(forces), phases, tuple(rates), simultaneous_impacts
    )
    _check_independence(assembly)
    return assembly


def _check_list(argument: str, given: Any, kinds: tuple[type, ...], written: str) -> None:
    """Refuse an argument that is no list of the given kinds; `written` shows an entry's form."""
    if isinstance(given, kinds):
        name = type(given).__name__
        raise DeclarationError(f"{argument} is a {name}, not a list: {argument}=[{name}(...)]")
    if not isinstance(given, list | tuple):
        raise DeclarationError(f"{argument} is {repr(given)}, not a list: {written}")
    for entry in given:
        if not isinstance(entry, kinds):
            raise DeclarationError(f"{argument} cannot hold {repr(entry)}: {written}")


def _mass(matrix: sp.Matrix) -> sp.Matrix:
    if matrix != matrix.T:
        raise DeclarationError("mass is not symmetric")
    matrix = frozen(matrix)
    if (
        not is_surely_positive_definite(matrix)
        and not matrix.free_symbols
        and not matrix.is_positive_definite
    ):
        raise DeclarationError("mass is not positive definite")
    return matrix


def _given(stiffness: Any, what: str) -> Any:
    if stiffness is None:
        raise DeclarationError(f"{what} is missing")
    return stiffness


def _check_independence(assembly: Assembly) -> None:
    """Refuse two friction contacts that move alike: how they share their force is indefinite."""
    for i, j in combinations(assembly.holders, 2):
        first, second = assembly.parts[i], assembly.parts[j]
        if isinstance(first, FrictionPart) and isinstance(second, FrictionPart):
            rows = assembly.rows((i, j))
            if rows.rank() < 2:
                place = next(k for k, weight in enumerate(first.direction) if weight != 0)
                ratio = second.direction[place] / first.direction[place]
                if sp.cancel(second.speed - ratio * first.speed) == 0:
                    raise DeclarationError(
                        f"elements {first.name!r} and {second.name!r} rub in one direction at one"
                        " velocity: join them into one"
                    )
