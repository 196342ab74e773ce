"""The table of an orbit without kernels, as a declaration of it would have it."""

from __future__ import annotations

from typing import Any

from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.shooting.symmetry import images_of

__all__ = ["declared_table"]

_PERIOD = {
    "name": "period",
    "description": "period",
    "lower": "0",
    "upper": None,
    "closed": False,
    "upper_closed": False,
}


def declared_table(orbit: Orbit) -> dict[str, Any]:
    """The table of a converged orbit, as generated modules hold it.

    It has the phases, the names of the unknowns, what closes the orbit, and the orbit as
    reference.
    """
    part = len(orbit.itinerary)
    symmetry = orbit.symmetry
    if symmetry is not None:
        part //= symmetry.order
    names = list(orbit.unknowns)
    count = len(orbit.itinerary)
    dwell, start = names[:part], names[count:]
    numbers = [*orbit.dwell_times[:part].tolist(), *orbit.states[0].tolist()]
    return {
        "derived": False,
        "reason": "it is known by its phases",
        "phases": [(*phase, name) for phase, name in zip(orbit.itinerary, dwell, strict=False)],
        "start": dict(zip(orbit.state_names, start, strict=True)),
        "period": None if orbit.given_period is None else dict(_PERIOD),
        "symmetry": {} if symmetry is None else images_of(symmetry.matrix, orbit.state_names),
        "reference": {
            "parameters": {name: value.text for name, value in orbit.given.items()},
            "guess": {n: repr(float(x)) for n, x in zip([*dwell, *start], numbers, strict=True)},
        },
    }
