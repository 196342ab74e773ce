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

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.derive.equations.chain import Chain, Link, name_functions
from nonsmooth.derive.equations.elimination import solve_linear
from nonsmooth.derive.equations.program import Equation, Stage, Stages, assign_matrix, prune
from nonsmooth.derive.equations.section import coordinates_of, is_zero, multiple_of
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.symbols import Symbol, Values, derivative


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

    map_stages: Stages
    start_stages: Stages
    matrix: sp.Matrix
    offset: sp.Matrix
    sought: tuple[int, ...]
    known: tuple[int, ...]
    start: sp.Matrix
    unknowns: tuple[sp.Symbol, ...]
    compatibility: tuple[Equation, ...]
    switching: tuple[Equation, ...]
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


def derive_period_map(
    itinerary: Itinerary,
    chain: Chain,
    unknowns: Sequence[sp.Symbol],
    equations: Sequence[Equation],
    choose: Values,
) -> PeriodMap:
    """The map of a turn and its equations; see the module's description.

    `equations` for the `unknowns` are the switching conditions of all phases, then the closures;
    `choose` has numbers of a known point, which tell the order of elimination where many entries
    are sought.
    DerivationError refuses an orbit that is given by half phases, by its period or by a forcing,
    one with nothing to seek at its start alone, and one whose section knows an entry otherwise
    than by a switching condition.
    """
    where, section, links = f"itinerary {itinerary.name!r}", chain.section, chain.links
    states = links[0].states
    if itinerary.reversor or itinerary.period is not None or chain.forcing is not None:
        raise DerivationError(f"{where}: its equations are not those of a free turn")
    if not section.dimension or chain.start != section:
        raise DerivationError(f"{where}: its section leaves nothing else to be sought")
    resets = [k for k, link in enumerate(links) if not _only_states_its_exit(link)]
    known = tuple(i for i in range(len(states)) if i not in section.places)
    relations = sp.eye(len(states) + 1)[:-1, :]
    for column, place in enumerate(section.places):
        relations[:, place] -= section.embedding[:, column]
    relations[:, -1] -= section.constant
    tested = {i: _tested(links, resets, relations[i, :], where) for i in known}
    stages, matrix, offset = _turn(itinerary, links, resets)
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
    compatibility = [
        (f"{states[place]} returns", closures[place])
        for place, phase in tested.items()
        if phase is not None
    ]
    contained = sorted(k for k in tested.values() if k is not None)
    return PeriodMap(
        stages,
        solution.stages,
        matrix,
        offset,
        section.places,
        known,
        section.state,
        tuple(u for u in unknowns if u not in section.coordinates),
        tuple(compatibility),
        tuple(equations[k] for k in range(len(links)) if k not in contained),
        tuple(contained),
        tuple(resets),
    )


def _only_states_its_exit(link: Link) -> bool:
    """Whether a transition changes the state by multiples of its boundary's function alone."""
    changes = link.landing - sp.eye(link.landing.rows)
    return all(multiple_of(changes[i, :], link.row) is not None for i in range(changes.rows))


def _tested(
    links: Sequence[Link], resets: Sequence[int], relation: sp.Matrix, where: str
) -> int | None:
    """The last phase that ends where a function vanishes, if nothing behind it changes that.

    None if nothing in the whole turn does, or a reset makes the function zero. DerivationError
    says that a phase or a transition changes it and none behind ends on it.
    """
    for index, link in reversed(list(enumerate(links))):
        carried = relation * link.landing if index in resets else relation
        if is_zero(carried):
            return None
        if multiple_of(carried, link.row) is not None:
            return index
        if any(multiple_of(f, relation) is None for f in (carried, relation * link.field)):
            raise DerivationError(
                f"{where}: phase {index + 1} changes what the section knows, and no"
                " switching condition behind it does"
            )
    return None


def _turn(
    itinerary: Itinerary, links: Sequence[Link], resets: Sequence[int]
) -> tuple[Stages, sp.Matrix, sp.Matrix]:
    """Stages, matrix and offset of the map of all phases, with names for its entries."""
    states, size = links[0].states, len(links[0].states)
    entries = coordinates_of(itinerary.start, states)
    stages: list[Stage] = []
    matrix, offset = sp.eye(size), sp.zeros(size, 1)
    for number, link in enumerate(links, start=1):
        stages.append(name_functions(link.flow, link.dwell, link.dwell)[0])
        maps = [("state", (link.transfer, link.flow.offset(link.functions)))]
        if number - 1 in resets:
            maps.append(("reset", (link.reset, link.jump)))
        for meaning, (product, shift) in maps:
            behind = [Symbol(meaning, s, number) for s in states]
            what = meaning if meaning == "reset" else link.flow.configuration
            title = f"{what} after {link.dwell}, by the start"
            names = [derivative(s, q) for s in behind for q in entries]
            step, matrix = assign_matrix(title, names, product * matrix)
            # the bars of other affine states mean other starts
            mark = "_reset" if meaning == "reset" else ""
            names = [Symbol("offset", i, number, mark) for i in range(1, size + 1)]
            constants, offset = assign_matrix(title, names, product * offset + shift)
            stages += [step, constants]
    return prune(stages, [*matrix, *offset]), matrix, offset
