"""The system and the orbit that a file of a proof names."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any, NamedTuple

from nonsmooth.runtime.checker import Failure
from nonsmooth.runtime.core.json_codec import decode
from nonsmooth.runtime.model.completion import left_open
from nonsmooth.runtime.model.kernels import OrbitKernels, SystemKernels, is_saved, load_orbit
from nonsmooth.runtime.model.naming import cycle_label, dwell_names, start_names
from nonsmooth.runtime.model.saved_system import SavedSystem, system_in
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.table_solve import whole_names
from nonsmooth.runtime.proof.parametric_declaration import PERIOD
from nonsmooth.runtime.proof.statement import kernels_with
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape, itinerary_shape

__all__ = ["NamedOrbit", "named_in", "phases_called"]


class NamedOrbit(NamedTuple):
    """The system and the orbit that a file names."""

    kernels: SystemKernels
    orbit: OrbitKernels | None  # None if the orbit is composed of phases that no declaration names
    cycle: ItineraryShape
    start: tuple[str, ...]  # names of the unknown coordinates of the start
    dwell: tuple[str, ...]  # names of the dwell times
    called: bool = True  # whether the system knows the orbit's name

    @property
    def derived(self) -> OrbitKernels | None:
        """The orbit if its equations are derived, else None."""
        return self.orbit if self.orbit is not None and self.orbit.derived else None

    @property
    def period(self) -> str:
        """Name of the period among the given parameters."""
        return PERIOD if self.derived is None else self.derived.period_name or PERIOD

    def check_chosen(self, chosen: list[str]) -> None:
        """Raise `Failure` for chosen parameters that the orbit does not leave open.

        They have to stand in the order of those that it leaves open.
        """
        left = () if self.derived is None else left_open(self.derived)
        if chosen != [name for name in left if name in chosen]:
            raise Failure("the parameters that were chosen are none that the orbit leaves open")


def named_in(content: Mapping[str, Any]) -> NamedOrbit:
    """The system and the orbit that a file (read as JSON) names: built in, or held as data.

    A system without such an orbit raises `Failure`. Phases that it does not have, or data
    that are not in order, raise `InputError`.
    """
    system, label = content["system"], content["orbit"]
    tables = content["tables"]
    kernels = system_in(system, None if tables is None else decode(SavedSystem, tables))
    orbits = {f"{system}{'/' if tables is None else ':'}{own}" for own in kernels.module.ORBITS}
    itinerary = [(c, b) for c, b in content["itinerary"]]
    kernels = kernels_with(kernels, content["declaration"])
    cycle = itinerary_shape(structure_of(kernels), itinerary)
    states, own = kernels.table["states"], {table.name for table in kernels.parameters}
    if label == cycle_label(system, len(itinerary)):
        dwell = dwell_names(len(itinerary), {*states, *own})
        return NamedOrbit(kernels, None, cycle, start_names(states, {*dwell, *own}), dwell)
    if label not in orbits:
        return _of_file(kernels, cycle, content)
    orbit = load_orbit(label)
    phases = [(c, b) for c, b, _ in orbit.table["phases"]]
    known = orbit.system.name == kernels.name and itinerary[: len(phases)] == phases
    if not known or len(itinerary) % len(phases):
        raise Failure(f"{label} is not that orbit of {system}")
    if orbit.derived:
        dwell = orbit.dwell_times
        return NamedOrbit(kernels, orbit, cycle, start_names(states, {*dwell, *own}), dwell)
    names = whole_names(orbit, len(itinerary))
    return NamedOrbit(kernels, orbit, cycle, names[len(itinerary) :], names[: len(itinerary)])


def phases_called(
    kernels: SystemKernels, content: Mapping[str, Any]
) -> list[tuple[str, str]] | None:
    """The pairs (configuration, boundary) of a named orbit that its built-in system declares.

    `content` is the file, read as JSON. The result is None if the system is a user's, or if
    no declaration names the orbit. `Failure` is raised if a built-in system has no such
    orbit, or if one of the orbit's phases lasts no time.
    """
    system, label = content["system"], content["orbit"]
    if content["tables"] is not None or is_saved(label):
        return None
    if label in {f"{system}/{own}" for own in kernels.module.ORBITS}:
        table = load_orbit(label).table
        if table.get("vanishing"):
            raise Failure(f"a phase of {label} lasts no time")
        return [(c, b) for c, b, _ in table["phases"]]
    if re.fullmatch(rf"{re.escape(system)}, \d+ phases?", label):
        return None
    raise Failure(f"{label} is no orbit of {system}")


def _of_file(
    kernels: SystemKernels, cycle: ItineraryShape, content: Mapping[str, Any]
) -> NamedOrbit:
    """An orbit that was taken from a file, with the names of unknowns that this file gives.

    The checker sees to it that none of them is another name of the system.
    """
    declared = content["declaration"]
    if not declared or not is_saved(content["orbit"]):
        raise Failure(f"{content['orbit']} is no orbit of {content['system']}")
    dwell = tuple(phase["dwell_time"] for phase in declared["phases"])
    return NamedOrbit(kernels, None, cycle, tuple(declared["start"]), dwell, called=False)
