"""The map of a whole turn in blocks, and the start that follows from the dwell times.

Given the dwell times a turn takes the start Z0 to N Z0 + c. Of the start the section leaves some
entries to be sought, z0, and knows the others, z0' (the velocities of what sticks, say); with
both groups N has four blocks, and periodicity reads

    (N1 - I) z0 + N2 z0' + c1 = 0,    N3 z0 + (N4 - I) z0' + c2 = 0.

The first line is square in z0 and gives it; the second then holds for certain dwell times only:
these are the compatibility conditions. It is another order of the equations of the full system: a
reset that only states the condition of its boundary is left out of N, so that the second line
contains the switching conditions by which the section knows z0', and takes their place.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from nonsmooth.derive.declaration.algebra import cancel
from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.equations.chain import Chain, name_functions
from nonsmooth.derive.equations.elimination import solve_linear
from nonsmooth.derive.equations.program import Stage, assign, prune
from nonsmooth.derive.equations.section import coordinates_of, reset_matrix
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.symbols import Symbol, derivative

__all__ = ["PeriodMap", "derive_period_map"]

_Equation = tuple[str, sp.Expr]


@dataclass(frozen=True)
class PeriodMap:
    """The affine map of a whole turn, Z(T) = N Z0 + c, and the equations that it leaves.

    Attributes
    ----------
    map_stages, start_stages : tuple of Stage
        What N and c are written in, and the symbols of z0 after these. The equations take the
        stages of the orbit's chain of states besides.
    matrix : sympy.Matrix, (n, n)
        N, over the dwell times.
    offset : sympy.Matrix, (n, 1)
        c, zero if no flow and no reset has a constant part.
    sought, known : tuple of int
        Places of the entries of z0, and of z0', among the states.
    start : sympy.Matrix, (n, 1)
        Z0: the symbols of z0, and what the section says of z0'.
    unknowns : tuple of symbols
        Dwell times, then parameters that are solved for.
    compatibility, switching : tuple of (meaning, expression)
        Together as many as the unknowns; they vanish at the orbit.
    contained : tuple of int
        Phases whose switching conditions the compatibility conditions contain.
    resets : tuple of int
        Phases with a reset behind them that does more than state that the phase is over: N
        contains it.
    """

    map_stages: tuple[Stage, ...]
    start_stages: tuple[Stage, ...]
    matrix: sp.Matrix
    offset: sp.Matrix
    sought: tuple[int, ...]
    known: tuple[int, ...]
    start: sp.Matrix
    unknowns: tuple[sp.Symbol, ...]
    compatibility: tuple[_Equation, ...]
    switching: tuple[_Equation, ...]
    contained: tuple[int, ...]
    resets: tuple[int, ...]

    @property
    def blocks(self) -> tuple[sp.Matrix, sp.Matrix, sp.Matrix, sp.Matrix]:
        """The blocks N1, N2, N3 and N4."""
        first, second, third, fourth = (
            self.matrix.extract(list(rows), list(columns))
            for rows in (self.sought, self.known)
            for columns in (self.sought, self.known)
        )
        return first, second, third, fourth

    @property
    def compatibility_matrix(self) -> sp.Matrix:
        """The matrix M = (N1 - I)^-1 N2 - N3^-1 (N4 - I), with which compatibility is M z0' = 0.

        Raises
        ------
        DerivationError
            If N3 is not square, or the map has an offset.
        """
        first, second, third, fourth = self.blocks
        if len(self.known) != len(self.sought) or not self.offset.is_zero_matrix:
            raise DerivationError("compatibility has no such matrix: N3 is not square, or c not 0")
        one = sp.eye(len(self.sought))
        return (first - one).inv("ADJ") * second - third.inv("ADJ") * (fourth - one)


@dataclass(frozen=True)
class _Row:
    """An affine function of the state, ``row y + constant``."""

    row: sp.Matrix  # 1 x N
    constant: sp.Expr

    def through(self, matrix: sp.Matrix, offset: sp.Matrix) -> _Row:
        """The function in front of an affine map."""
        return _Row(self.row * matrix, self.constant + (self.row * offset)[0])

    @property
    def is_zero(self) -> bool:
        """Whether the function is zero everywhere."""
        return all(cancel(sp.expand(e)) == 0 for e in (*self.row, self.constant))

    def vanishes_with(self, other: _Row) -> bool:
        """Whether the function is a multiple of another one."""
        mine, theirs = [*self.row, self.constant], [*other.row, other.constant]
        pivot = next(i for i, entry in enumerate(theirs) if entry != 0)
        return all(
            cancel(sp.expand(a * theirs[pivot] - b * mine[pivot])) == 0
            for a, b in zip(mine, theirs, strict=True)
        )


@dataclass(frozen=True)
class _Passage:
    """One phase and its transition, for a given dwell time."""

    naming: Stage
    flow: tuple[sp.Matrix, sp.Matrix]  # affine map of the phase
    field: tuple[sp.Matrix, sp.Matrix]
    exit: _Row
    reset: tuple[sp.Matrix, sp.Matrix] | None  # None if it only states that the exit is reached


def derive_period_map(
    itinerary: Itinerary,
    system: System,
    chain: Chain,
    equations: Sequence[_Equation],
    choose: Mapping[sp.Symbol, sp.Expr],
) -> PeriodMap:
    """The map of a turn and its equations; see the module's description.

    `equations` are the switching conditions of all phases, then the closures; `choose` has numbers
    of a known point, which tell the order of elimination where many entries are sought.
    DerivationError refuses an orbit that is given by half phases, by its period or by a forcing,
    one with nothing to seek at its start alone, and one whose section knows an entry otherwise
    than by a switching condition.
    """
    name, section, states = itinerary.name, chain.section, system.states
    if itinerary.reversor or itinerary.period is not None or chain.forcing is not None:
        raise DerivationError(f"itinerary {name!r}: its equations are not those of a free turn")
    if not section.dimension or chain.start != section:
        raise DerivationError(f"itinerary {name!r}: its section leaves nothing else to be sought")
    passages = [_passage(itinerary, system, chain, k) for k in range(len(chain.links))]
    known = tuple(i for i in range(len(states)) if i not in section.places)
    tested = {place: _tested(passages, _relation(chain, place), name) for place in known}
    stages, matrix, offset = _turn(itinerary, system, chain, passages)
    closures = matrix * section.state + offset - section.state
    solution = solve_linear(
        [
            (f"{coordinate} returns", sp.expand(closures[place]))
            for coordinate, place in zip(section.coordinates, section.places, strict=True)
        ],
        section.coordinates,
        (),
        stages,
        choose,
    )
    compatibility = tuple(
        (f"{states[place]} returns", closures[place])
        for place, phase in tested.items()
        if phase is not None
    )
    contained = tuple(sorted(k for k in tested.values() if k is not None))
    switching = tuple(equations[k] for k in range(len(passages)) if k not in contained)
    swapped = [p.symbol for p in system.parameters if p.name in itinerary.solved_for]
    return PeriodMap(
        stages,
        solution.stages,
        matrix,
        offset,
        section.places,
        known,
        section.state,
        (*(link.dwell for link in chain.links if link.duration != 0), *swapped),
        compatibility,
        switching,
        contained,
        tuple(k for k, passage in enumerate(passages) if passage.reset is not None),
    )


def _passage(itinerary: Itinerary, system: System, chain: Chain, index: int) -> _Passage:
    """The passage of one phase of an itinerary."""
    phase, link = itinerary.phases[index], chain.links[index]
    boundary = system.configuration(phase.configuration).boundary(phase.boundary)
    leaving = _Row(*system.gradient(boundary.function))
    naming, _ = name_functions(link.flow, link.dwell)
    transition = itinerary.transition_after(system, index)
    jump, shift = reset_matrix(transition.reset.items(), system.states)
    changes = jump - sp.eye(jump.rows)
    stated = all(_Row(changes[i, :], shift[i]).vanishes_with(leaving) for i in range(changes.rows))
    return _Passage(
        naming,
        (link.transfer, link.flow.offset(link.functions)),
        link.flow.field,
        leaving,
        None if stated else (jump, shift),
    )


def _relation(chain: Chain, place: int) -> _Row:
    """What the section knows of one entry: a function that vanishes on it."""
    section = chain.section
    row = sp.zeros(1, section.embedding.rows)
    row[place] = 1
    for column, other in enumerate(section.places):
        row[other] -= section.embedding[place, column]
    return _Row(row, -section.constant[place])


def _tested(passages: Sequence[_Passage], relation: _Row, name: str) -> int | None:
    """The last phase that ends where a function vanishes, if nothing behind it changes that.

    None if nothing in the whole turn does, or a reset makes the function zero. DerivationError
    says that a phase or a transition changes it and none behind ends on it.
    """
    for index, passage in reversed(list(enumerate(passages))):
        carried = relation if passage.reset is None else relation.through(*passage.reset)
        if carried.is_zero:
            return None
        if carried.vanishes_with(passage.exit):
            return index
        matrix, offset = passage.field
        rate = _Row(relation.row * matrix, (relation.row * offset)[0])
        if not (carried.vanishes_with(relation) and rate.vanishes_with(relation)):
            raise DerivationError(
                f"itinerary {name!r}: phase {index + 1} changes what the section knows, and no"
                " switching condition behind it does"
            )
    return None


def _turn(
    itinerary: Itinerary, system: System, chain: Chain, passages: Sequence[_Passage]
) -> tuple[tuple[Stage, ...], sp.Matrix, sp.Matrix]:
    """Stages, matrix and offset of the map of all passages, with names for its entries."""
    states, size = system.states, len(system.states)
    entries = coordinates_of(itinerary, states)
    stages: list[Stage] = []
    matrix, offset = sp.eye(size), sp.zeros(size, 1)
    for number, (link, passage) in enumerate(zip(chain.links, passages, strict=True), start=1):
        stages.append(passage.naming)
        maps = [("state", passage.flow), ("reset", passage.reset)]
        for meaning, (product, shift) in ((m, step) for m, step in maps if step is not None):
            behind = [Symbol(meaning, s, number) for s in states]
            what = meaning if meaning == "reset" else link.flow.configuration
            title = f"{what} after {link.dwell}, by the start"
            names = [derivative(s, q) for s in behind for q in entries]
            step, values = assign(title, names, product * matrix)
            matrix = sp.Matrix(size, size, values)
            # the bars of other affine states mean other starts
            mark = "_reset" if meaning == "reset" else ""
            names = [Symbol("offset", i, number, mark) for i in range(1, size + 1)]
            constants, values = assign(title, names, product * offset + shift)
            offset = sp.Matrix(values)
            stages += [step, constants]
    return prune(stages, [*matrix, *offset]), matrix, offset
