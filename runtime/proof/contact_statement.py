"""The contact law in a certificate: what it is told, and the routes of an itinerary through it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.contacts.law import Law
from nonsmooth.runtime.model.contacts.stages import Path, Stage
from nonsmooth.runtime.model.contacts.unfolding import Route, unfolded
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape

__all__ = ["kernels_with", "law_json", "steps_json"]


def steps_json(law: Law, path: Path) -> list[dict[str, Any]]:
    """Return for each stage of a path the contacts at their "kinetic" limit and all "regimes"."""
    return [
        {
            "kinetic": [law.contacts[i].name for i in sorted(stage.reached)],
            "regimes": list(stage.regimes),
        }
        for stage in path
    ]


def law_json(law: Law, cycle: ItineraryShape, row: Callable[[int], list[Any]]) -> dict[str, Any]:
    """Return the contact law as JSON, as far as an itinerary concerns it.

    It holds contacts, coupling, arrivals, limits, configurations and the rows of free contacts;
    `row` writes the row of a number as a list.
    """
    places = sorted(set(cycle.configurations))
    others = dict.fromkeys(law.others[c] for c in places)
    return {
        "contacts": [
            {
                "name": contact.name,
                "friction": contact.friction,
                "static": row(contact.static),
                "kinetic": row(contact.kinetic),
                "slipping": row(contact.slipping),
                "overshooting": row(contact.overshooting),
            }
            for contact in law.contacts
        ],
        "coupling": [[row(entry)[-1] for entry in each] for each in law.coupling],
        "arrivals": dict(law.arrivals),
        "limits": dict(law.limits),
        "configurations": {
            law.configurations[c]: {
                "regimes": list(law.regimes[c]),
                "others": law.others[c],
                "idle": list(law.idle[c]),
            }
            for c in places
        },
        "free": {name: [row(each) for each in law.free[name]] for name in others},
    }


def kernels_with(kernels: SystemKernels, declaration: Mapping[str, Any]) -> SystemKernels:
    """Return kernels that list the routes in a certificate's declaration.

    Without a law of contacts the kernels are returned unchanged. A declaration without steps of a
    contact law is refused.
    """
    law = structure_of(kernels).law
    if law is None:
        return kernels
    try:
        routes = [
            Route(
                entry["source"],
                tuple(entry["boundaries"]),
                entry["target"],
                tuple(_stage(law, step) for step in entry["steps"]),
            )
            for entry in declaration["transitions"]
            if "steps" in entry
        ]
        return unfolded(kernels, routes)
    except (KeyError, TypeError, ValueError):
        raise InputError("the declaration holds no steps of a contact law") from None


def _stage(law: Law, step: Mapping[str, Sequence[str]]) -> Stage:
    names = [contact.name for contact in law.contacts]
    reached = frozenset(names.index(name) for name in step["kinetic"])
    regimes = tuple(step["regimes"])
    if not all(map(set.__contains__, map(set, zip(*law.regimes, strict=True)), regimes)):
        raise ValueError(regimes)
    return Stage(reached, regimes)
