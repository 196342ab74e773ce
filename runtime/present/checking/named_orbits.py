"""The system and the orbit that a file of a proof names."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

from nonsmooth.runtime.checker import Failure
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.completion import left_open
from nonsmooth.runtime.model.kernels import OrbitKernels, SystemKernels, load_orbit, load_system
from nonsmooth.runtime.model.naming import cycle_label, dwell_names, start_names
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.declared_solve import whole_names
from nonsmooth.runtime.orbits.routes import with_routes
from nonsmooth.runtime.proof.contact_statement import kernels_with
from nonsmooth.runtime.proof.orbit_cycle import period_name
from nonsmooth.runtime.proof.parametric_declaration import PERIOD
from nonsmooth.runtime.shooting.shooting_map import Cycle, cycle_of

__all__ = ["NamedOrbit", "named_in"]


class NamedOrbit(NamedTuple):
    """What a file names.

    Attributes
    ----------
    kernels : SystemKernels
    orbit : OrbitKernels or None
        None where the orbit is composed of phases that no declaration names.
    cycle : Cycle
    start, dwell : tuple of str
        Names of the unknowns.
    """

    kernels: SystemKernels
    orbit: OrbitKernels | None
    cycle: Cycle
    start: tuple[str, ...]
    dwell: tuple[str, ...]

    @property
    def derived(self) -> OrbitKernels | None:
        """The orbit, if its equations are derived."""
        return self.orbit if self.orbit is not None and self.orbit.derived else None

    @property
    def period(self) -> str:
        """Name of the period among the parameters that were given."""
        return PERIOD if self.derived is None else period_name(self.derived) or PERIOD

    def check_chosen(self, chosen: list[str]) -> None:
        """Refuse names of parameters that the orbit does not leave open."""
        left = () if self.derived is None else left_open(self.derived)
        if chosen != [name for name in left if name in chosen]:
            raise Failure("the parameters that were chosen are none that the orbit leaves open")


def named_in(content: Mapping[str, Any], folder: Path) -> NamedOrbit | None:
    """The system and the orbit that a file names; None if the system is not there.

    Raises
    ------
    Failure
        If the system has no such orbit.
    InputError
        If it has no such phases.
    """
    system, label = content["system"], content["orbit"]
    try:
        kernels = load_system(system, folder)
    except InputError:
        return None
    itinerary = [(c, b) for c, b in content["itinerary"]]
    if "declaration" in content:
        kernels = kernels_with(kernels, content["declaration"])
    else:  # of a census each orbit has its own
        kernels = with_routes(kernels, itinerary)
    cycle = cycle_of(structure_of(kernels), itinerary)
    states, own = kernels.table["states"], {table.name for table in kernels.parameters}
    if label == cycle_label(system, len(itinerary)):
        dwell = dwell_names(len(itinerary), {*states, *own})
        return NamedOrbit(kernels, None, cycle, start_names(states, {*dwell, *own}), dwell)
    try:
        orbit = load_orbit(label, folder)
    except InputError as problem:
        raise Failure(str(problem)) from None
    phases = [(c, b) for c, b, _ in orbit.table["phases"]]
    known = orbit.system.name == kernels.name and itinerary[: len(phases)] == phases
    if not known or len(itinerary) % len(phases):
        raise Failure(f"{label} is not that orbit of {system}")
    if orbit.derived:
        dwell = orbit.dwell_times
        return NamedOrbit(kernels, orbit, cycle, start_names(states, {*dwell, *own}), dwell)
    names = whole_names(orbit, len(itinerary))
    return NamedOrbit(kernels, orbit, cycle, names[len(itinerary) :], names[: len(itinerary)])
