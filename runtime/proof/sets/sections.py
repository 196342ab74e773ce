"""Sections of motions: where states are taken, what is exactly true there, how files state them.

With a forcing states are taken once in each period, at one phase of the forcing, in one
configuration. Else they are taken behind a transition: what its source holds and the boundary
that is reached are facts, carried by the reset. The coordinates that facts leave free are those
of the section: a mass that sticks takes away one. The declaration that a file states is that of the
system as far as some motions visit it.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cached_property
from math import gcd
from typing import Any

from flint import arb, fmpq
from numpy.typing import NDArray

from nonsmooth.runtime.checker.state_sets.switching import SwitchingSystem
from nonsmooth.runtime.checker.stated.exact import (
    Elimination,
    Entries,
    Failure,
    fixed,
    free_places,
    spanned,
)
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import Exact
from nonsmooth.runtime.core.registry import Certified
from nonsmooth.runtime.core.result_files import check_same_question
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.boundary_sets import members_of
from nonsmooth.runtime.model.kernels import SystemKernels, known_system
from nonsmooth.runtime.model.saved_system import KeptSystemName, check_same_system
from nonsmooth.runtime.model.structure import TransitionShape
from nonsmooth.runtime.proof.certificate import Declaration
from nonsmooth.runtime.proof.statement import ExactSystem, Row, declaration_json, system_declaration
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape

Way = tuple[int, frozenset[int], int]  # configuration, boundaries, configuration


@dataclass(frozen=True)
class MapSection:
    """A section: the configuration of its states, and what is exactly true of them."""

    configuration: int
    facts: tuple[Row, ...]  # reduced rows that are zero
    # cosine and sine of the forcing; None for a section behind a transition
    phase: tuple[Any, Any] | None
    source: int = -1  # configuration that the transition leaves; -1 for a forcing
    # those that the transition follows; empty for a forcing
    boundaries: frozenset[int] = frozenset()

    @cached_property
    def free(self) -> tuple[int, ...]:
        """The states that are the section's coordinates."""
        return tuple(free_places(self.facts, len(self.facts[0]) - 1))

    @property
    def lift(self) -> tuple[Row, ...]:
        """Rows (N, d + 1) that give each state as an affine function of the d coordinates."""
        return tuple(spanned(self.facts, len(self.facts[0]) - 1))

    def period(self, system: ExactSystem) -> arb:
        """Return the period of the forcing, at the working precision."""
        return 2 * arb.pi() / abs(arb(_speed(system)))


def forcing_section(system: ExactSystem, configuration: int, phase: Sequence[Any]) -> MapSection:
    """Return the section at one phase of the forcing, in one configuration.

    The phase is cosine and sine, a rational point of the unit circle. Any other point, and a system
    without exactly one forcing, is refused.
    """
    cosine, sine = phase
    if cosine**2 + sine**2 != 1:
        raise InputError("the phase is no point of the unit circle")
    _speed(system)
    (c, s), size = system.structure.forcing[0], len(system.structure.states)
    rows = fixed(size, ((c, cosine), (s, sine)))
    held = [system.exact.rows[row] for row in system.structure.constraints[configuration]]
    facts = Elimination().echelon([*rows, *held])
    return MapSection(configuration, tuple(facts), (cosine, sine))


def transition_section(
    system: ExactSystem, source: int, boundaries: frozenset[int], target: int
) -> MapSection:
    """Return the section behind a transition by `boundaries` from a configuration to another.

    A transition that is not listed, and a system with a forcing, are refused.
    """
    exact, transition = system.exact, listed_transition(system, (source, boundaries, target))
    structure = system.structure
    if structure.forcing:
        raise InputError("with a forcing states are taken at one of its phases")
    held = [exact.rows[row] for row in structure.constraints[source]]
    reached = [exact.rows[structure.boundaries[source][b].row] for b in sorted(boundaries)]
    exactly = Elimination()
    before = exactly.echelon([*held, *reached])
    if transition is None:
        name = structure.configurations
        raise InputError(f"no listed transition leads from {name[source]} to {name[target]}")
    facts = exactly.behind(before, exact.resets[transition.reset])
    return MapSection(target, tuple(facts), None, source, boundaries)


def listed_transition(system: ExactSystem, way: Way) -> TransitionShape | None:
    """Return the transition that is listed for a way, or None if a contact law decides."""
    source, boundaries, target = way
    listed = system.structure.listed(source, boundaries)
    return next((t for t in listed if t.target == target), None)


def sections_behind(system: ExactSystem, ways: Sequence[Way]) -> dict[Way, MapSection]:
    """Return the sections behind transitions (source, boundaries, target) that have coordinates.

    Transitions that a contact law decides are left out: the checker knows listed ones alone.
    """
    listed = [way for way in dict.fromkeys(ways) if listed_transition(system, way)]
    found = {way: transition_section(system, *way) for way in listed}
    return {way: section for way, section in found.items() if section.free}


def ways_of(configurations: NDArray[Any], masks: NDArray[Any]) -> list[Way]:
    """Return the transitions of a motion: source, boundaries and target of each.

    `configurations` has that of the start, and the one behind each transition, and `masks` what
    they follow.
    """
    behind = zip(configurations, masks[1:], configurations[1:], strict=False)
    return [(int(a), frozenset(members_of(int(mask))), int(b)) for a, mask, b in behind]


def angle_of(phase: Sequence[Any]) -> float:
    """Return the angle of a phase, about."""
    cosine, sine = (float(x.p) / float(x.q) for x in phase)
    return math.atan2(sine, cosine)


def phases(count: int) -> list[tuple[Any, Any]]:
    """Return rational points of the unit circle, cosines and sines, about evenly spread.

    Their number is a multiple of 4.
    """
    part = count // 4
    quarter = []
    for k in range(part):
        # m/n is near the tangent of half the angle, which the quarter shares out
        m, n = round(16 * k / (2 * part - k * k / part)), 16
        shared = gcd(m, n)
        m, n = m // shared, n // shared
        below = m * m + n * n
        quarter.append((fmpq(n * n - m * m, below), fmpq(2 * m * n, below)))
    found = list(quarter)
    for _ in range(3):
        quarter = [(-s, c) for c, s in quarter]
        found += quarter
    return found


def _speed(system: ExactSystem) -> Any:
    """Return the angular frequency of the one forcing, which is the same in every configuration."""
    forcing = system.structure.forcing
    if len(forcing) != 1:
        raise InputError(f"{system.structure.name} has {len(forcing)} forcings, not one")
    c, s = forcing[0]
    return system.exact.fields[0][s][c]


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class SectionRecord(Certified):
    """A record of a section's map, at one parameter point.

    Attributes
    ----------
    system : str
    parameters : dict of str to Value
        All of the system, exactly.
    configuration : str
        In which states on the section are; empty where nothing is claimed.
    phase : tuple of str
        Cosine and sine of the forcing on the section; empty without a forcing.
    source, boundary : str
        What the transition of the section leaves and by what; empty with a forcing.
    coordinates : tuple of str
        States that are the coordinates of the section.
    declaration : dict
        The system, as functions of its parameters, as in the file; empty where nothing is
        claimed.
    """

    system: KeptSystemName
    parameters: Mapping[str, Value]
    configuration: str
    phase: tuple[Exact, ...]
    source: str
    boundary: str
    coordinates: tuple[str, ...]
    declaration: Declaration = field(repr=False)


def check_same_section(
    kernels: SystemKernels,
    asked: SectionRecord,
    known: SectionRecord,
    what: str,
    **more: tuple[object, object],
) -> None:
    """Refuse a state of another question: of another system or section, or where `more` differs.

    `what` says in words what was kept. `more` has by its name what is asked for and what was kept.
    """
    # a file calls the system by its data, and holds it
    check_same_system(what, kernels, known_system(known.system))
    names = ("parameters", "configuration", "phase", "source", "boundary")
    pairs = {name: (getattr(asked, name), getattr(known, name)) for name in names} | more
    wanted, found = ({name: pair[k] for name, pair in pairs.items()} for k in (0, 1))
    check_same_question(what, wanted, found)


def stated_section(system: ExactSystem, section: MapSection) -> dict[str, Any]:
    """Return the attributes of `SectionRecord` for a section, but for the declaration."""
    structure, forced = system.structure, section.phase is not None
    names = structure.configurations
    return {
        "system": structure.name,
        "parameters": system.values,
        "configuration": names[section.configuration],
        "phase": tuple(map(str, section.phase or ())),
        "source": "" if forced else names[section.source],
        "boundary": reached_text(system, section.source, section.boundaries),
        "coordinates": tuple(structure.states[k] for k in section.free),
    }


def reached_text(system: ExactSystem, source: int, boundaries: Iterable[int]) -> str:
    """Return boundaries of a configuration by names, in order and joined by +."""
    shapes = system.structure.boundaries[source]
    return "+".join(sorted(shapes[b].name for b in boundaries))


def named_way(system: ExactSystem, way: Iterable[Way]) -> tuple[tuple[str, str, str], ...]:
    """Return transitions by names: source, boundaries and target of each."""
    names = system.structure.configurations
    return tuple(
        (
            names[source],
            reached_text(system, source, boundaries),
            names[target],
        )
        for source, boundaries, target in way
    )


@contextmanager
def refused_as_input() -> Iterator[None]:
    """Raise what the checker refuses of a question as `InputError`."""
    try:
        yield
    except Failure as failure:
        raise InputError(str(failure)) from None


def visited_declaration(
    kernels: SystemKernels,
    system: ExactSystem,
    passages: Sequence[Way],
) -> Entries:
    """Return the configurations and transitions of some passages, with all their numbers.

    It is as `declaration_json` gives it, and its phases are the passages, each once. It is empty
    where a contact law decides what follows.
    """
    cycle = _cycle(system, passages)
    if cycle is None:
        return {}
    dwell = [f"phase {number}" for number in range(1, len(cycle) + 1)]
    start = system.structure.states
    return system_declaration(kernels, cycle, system.exact, start, dwell, timed=False)


def _cycle(system: ExactSystem, passages: Sequence[Way]) -> ItineraryShape | None:
    """Return some passages, each once, as phases; None where a contact law decides what follows."""
    structure, found = system.structure, list(dict.fromkeys(passages))
    taken = [listed_transition(system, way) for way in found]
    if any(transition is None for transition in taken):
        return None
    itinerary = tuple(
        (
            structure.configurations[source],
            "+".join(structure.boundaries[source][b].name for b in sorted(boundaries)),
        )
        for source, boundaries, _ in found
    )
    return ItineraryShape(
        structure,
        itinerary,
        tuple(source for source, _, _ in found),
        tuple(min(boundaries) for _, boundaries, _ in found),
        tuple(t for t in taken if t is not None),
    )


def listed_declaration(kernels: SystemKernels, system: ExactSystem) -> Entries:
    """Return the declaration of a system with all transitions that it lists.

    It is as `visited_declaration` gives it.
    """
    return visited_declaration(kernels, system, _listed(system, lawful=False))


def whole_system(system: ExactSystem) -> SwitchingSystem:
    """Return a system at its parameters as the checker knows it.

    It has all transitions that are listed, those that were written out of a contact law too.
    """
    cycle = _cycle(system, _listed(system, lawful=True))
    assert cycle is not None
    told = declaration_json(system.exact, cycle, (), (), [""] * len(cycle), whole=True)
    return SwitchingSystem(told, {}, lawful=True)


def _listed(system: ExactSystem, *, lawful: bool) -> list[Way]:
    """Return all transitions of a system that are listed, or written out of a contact law too."""
    return [
        (source, frozenset(t.boundaries), t.target)
        for source, transitions in enumerate(system.structure.transitions)
        for t in transitions
        if lawful or t.path is None
    ]
