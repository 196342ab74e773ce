"""The declaration of a system as far as some motions visit it, as a file states it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from nonsmooth.runtime.checker.state_sets.switching import SwitchingSystem
from nonsmooth.runtime.checker.stated.exact import Failure
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.proof.exact_tables import ExactSystem
from nonsmooth.runtime.proof.sets.sections import Way, listed_transition
from nonsmooth.runtime.proof.statement import declaration_json, system_declaration
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape

__all__ = [
    "listed_declaration",
    "refused_as_input",
    "visited_declaration",
    "whole_system",
]


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
) -> dict[str, Any]:
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


def listed_declaration(kernels: SystemKernels, system: ExactSystem) -> dict[str, Any]:
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
