"""The usual oscillators declared in a few lines."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import chain, combinations
from math import prod
from typing import Any, Literal

import sympy as sp

from nonsmooth.derive.building.assembly import Assembly
from nonsmooth.derive.building.element_parts import constraints_of, part_of, states_of
from nonsmooth.derive.building.elements import Element, Harmonic
from nonsmooth.derive.building.frame import Frame, inferred_parameters
from nonsmooth.derive.building.growing import GrowingSystem, is_large, whole
from nonsmooth.derive.building.matrices import square
from nonsmooth.derive.declaration.algebra import frozen
from nonsmooth.derive.declaration.fields import made, shown
from nonsmooth.derive.declaration.parameter import Parameter
from nonsmooth.derive.declaration.soundness import check_unique, fault_of_mass
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.errors import DeclarationError


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
    >>> from nonsmooth.derive import RigidStop, chain_matrices, oscillator
    >>> mass, stiffness, _ = chain_matrices([1, 2], [5, 1])
    >>> system = oscillator("two", ["x1", "x2"], mass, stiffness,
    ...                     elements=[RigidStop("x2", at=1, restitution=0.8, name="stop")])
    >>> [c.name for c in system.configurations]
    ['free', 'contact']
    """
    name, description = made(str, name, "name"), made(str, description, "description")
    coordinates = made(tuple[str, ...], coordinates, "coordinates")
    if simultaneous_impacts is not None:
        made(Literal["sequence", "moreau"], simultaneous_impacts, "simultaneous_impacts")
    _check_list("forcing", forcing, (Harmonic,), 'F cos(w t) is Harmonic(w, cosine={"x": F})')
    kinds = tuple(kind for kind in part_of.registry if kind is not object)
    _check_list("elements", elements, kinds, ", ".join(kind.__name__ for kind in kinds))
    _check_list("parameters", parameters, (Parameter,), 'Parameter("k", "stiffness")')
    if len(coordinates) == 0:
        raise DeclarationError("an oscillator needs a coordinate")
    check_unique(coordinates, "coordinate")
    check_unique([element.name for element in elements], "element")
    phases = tuple((_state(f"c{k}"), _state(f"s{k}")) for k in range(1, len(forcing) + 1))
    positions, velocities = (
        tuple(map(_state, names)) for names in (coordinates, map(_velocity, coordinates))
    )
    others = (*chain.from_iterable(phases), *chain.from_iterable(map(states_of, elements)))
    states = map(str, (*positions, *velocities, *others))
    matrix = square(mass, "mass", len(positions))
    declared = inferred_parameters(
        parameters, states, elements, matrix, stiffness, damping, load, list(forcing)
    )
    frame = Frame(positions, velocities, others, declared, matrix)
    frame = replace(frame, mass=frozen(frame.matrix(matrix, "mass")))
    if fault := fault_of_mass(frame.mass, declared):
        raise DeclarationError(f"mass {fault}")
    if stiffness is None:
        raise DeclarationError("stiffness is missing")
    forces = (
        frame.column(load, "load")
        - frame.matrix(stiffness, "stiffness") * sp.Matrix(positions)
        - frame.matrix(damping, "damping") * sp.Matrix(velocities)
    )
    rates: list[tuple[sp.Symbol, sp.Expr]] = []
    for harmonic, (c, s) in zip(forcing, phases, strict=True):
        frequency, phase = map(frame.expression, (harmonic.frequency, harmonic.phase))
        cosine = frame.column(harmonic.cosine, "cosine amplitudes")
        sine = frame.column(harmonic.sine, "sine amplitudes")
        forces += cosine * (sp.cos(phase) * c - sp.sin(phase) * s)
        forces += sine * (sp.cos(phase) * s + sp.sin(phase) * c)
        rates += [(c, -frequency * s), (s, frequency * c)]
    parts = tuple(part_of(element, frame, elements) for element in elements)
    assembly = Assembly(
        frame, parts, sp.ImmutableMatrix(forces), phases, tuple(rates), simultaneous_impacts
    )
    _check_independence(assembly)
    plural = "" if len(coordinates) == 1 else "s"
    described = f"oscillator with {len(coordinates)} coordinate{plural}"
    constraints = constraints_of(frame, parts)
    if is_large(assembly):
        most = prod(len(part.regimes) for part in parts)
        described += f", its configurations (up to {most:,}) made when they are visited"
        return GrowingSystem(name, description or described, assembly, constraints)
    return whole(name, description or described, assembly, constraints)


def _state(name: str) -> sp.Symbol:
    return sp.Symbol(name, real=True)


def _velocity(coordinate: str) -> str:
    """Name of a coordinate's velocity: x1 has v1, phi has v_phi."""
    return f"v{coordinate[1:]}" if coordinate.startswith("x") else f"v_{coordinate}"


def _check_list(argument: str, given: Any, kinds: tuple[type, ...], written: str) -> None:
    """Refuse an argument that is no list of the given kinds; `written` shows an entry's form."""
    if isinstance(given, kinds):
        name = type(given).__name__
        raise DeclarationError(f"{argument} is a {name}, not a list: {argument}=[{name}(...)]")
    if not isinstance(given, list | tuple):
        raise DeclarationError(f"{argument} is {shown(given)}, not a list: {written}")
    for entry in given:
        if not isinstance(entry, kinds):
            raise DeclarationError(f"{argument} cannot hold {shown(entry)}: {written}")


def _check_independence(assembly: Assembly) -> None:
    """Refuse two friction contacts that move alike: how they share their force is indefinite."""
    for first, second in combinations(assembly.frictions.values(), 2):
        rows = first.direction.col_join(second.direction)
        if rows.rank() < 2:
            place = min(place for _, place in first.direction.todok())
            ratio = second.direction[place] / first.direction[place]
            if sp.cancel(second.speed - ratio * first.speed) == 0:
                raise DeclarationError(
                    f"elements {first.name!r} and {second.name!r} rub in one direction at one"
                    " velocity: join them into one"
                )
