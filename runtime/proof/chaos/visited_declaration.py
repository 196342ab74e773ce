"""The declaration of a system as far as some motions visit it, as a file states it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.structure import TransitionShape
from nonsmooth.runtime.proof.chaos.images import PassedTransition
from nonsmooth.runtime.proof.chaos.sections import MapSection
from nonsmooth.runtime.proof.motion.enclosures import EnclosedSystem
from nonsmooth.runtime.proof.parametric_declaration import system_declaration
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape

__all__ = ["visited_declaration"]


def visited_declaration(
    kernels: SystemKernels,
    system: EnclosedSystem,
    passages: Sequence[PassedTransition],
    section: MapSection,
) -> dict[str, Any]:
    """Configurations and transitions of some passages, with all their numbers.

    Parameters
    ----------
    kernels : SystemKernels
    system : EnclosedSystem
    passages : sequence of PassedTransition
    section : MapSection

    Returns
    -------
    dict
        As `declaration_json` gives it: its phases are the passages, each once.
    """
    structure = system.structure
    own = list(passages)
    if section.phase is None:
        own.append(
            PassedTransition(
                section.source, tuple(sorted(section.boundaries)), section.configuration
            )
        )
    found = list(dict.fromkeys(p._replace(boundaries=tuple(sorted(p.boundaries))) for p in own))
    taken = [_transition(system, passage) for passage in found]
    itinerary = tuple(
        (
            structure.configurations[p.source],
            "+".join(structure.boundaries[p.source][b].name for b in p.boundaries),
        )
        for p in found
    )
    cycle = ItineraryShape(
        structure,
        itinerary,
        tuple(p.source for p in found),
        tuple(p.boundaries[0] for p in found),
        tuple(taken),
    )
    dwell = [f"phase {number}" for number in range(1, len(found) + 1)]
    start = structure.states
    return system_declaration(kernels, cycle, system.exact, start, dwell, timed=False)


def _transition(system: EnclosedSystem, passage: PassedTransition) -> TransitionShape:
    """The transition of a passage, one of those that lead there."""
    found = system.structure.transitions_to(
        passage.source, frozenset(passage.boundaries), passage.target
    )
    return found[0]
