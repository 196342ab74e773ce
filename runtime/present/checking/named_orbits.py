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
from nonsmooth.runtime.orbits.declared_solve import whole_names
from nonsmooth.runtime.orbits.routes import with_routes
from nonsmooth.runtime.proof.contact_statement import kernels_with
from nonsmooth.runtime.proof.parametric_declaration import PERIOD
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape, itinerary_shape

__all__ = ["NamedOrbit", "named_in", "phases_called"]


class NamedOrbit(NamedTuple):
    """What a file names.

    Attributes
    ----------
    kernels : SystemKernels
    orbit : OrbitKernels or None
        None where the orbit is composed of phases that no declaration names.
    cycle : ItineraryShape
    start, dwell : tuple of str
        Names of the unknowns.
    called : bool
        Whether the orbit's name is one that the system knows.
    """

    kernels: SystemKernels
    orbit: OrbitKernels | None
    cycle: ItineraryShape
    start: tuple[str, ...]
    dwell: tuple[str, ...]
    called: bool = True

    @property
    def derived(self) -> OrbitKernels | None:
        """The orbit, if its equations are derived."""
        return self.orbit if self.orbit is not None and self.orbit.derived else None

    @property
    def period(self) -> str:
        """Name of the period among the parameters that were given."""
        return PERIOD if self.derived is None else self.derived.period_name or PERIOD

    def check_chosen(self, chosen: list[str]) -> None:
        """Refuse names of parameters that the orbit does not leave open.

        Parameters
        ----------
        chosen : list of str
            Names that the file gives.

        Raises
        ------
        Failure
            If a name is another parameter's, or they are in another order.
        """
        left = () if self.derived is None else left_open(self.derived)
        if chosen != [name for name in left if name in chosen]:
            raise Failure("the parameters that were chosen are none that the orbit leaves open")


def named_in(content: Mapping[str, Any]) -> NamedOrbit:
    """The system and the orbit that a file names: built in, or held by the file as data.

    Parameters
    ----------
    content : dict
        The file, read as JSON.

    Returns
    -------
    NamedOrbit
        With the cycle and the names of its unknowns.

    Raises
    ------
    Failure
        If the system has no such orbit.
    InputError
        If it has no such phases, or its data are not in order.
    """
    system, label = content["system"], content["orbit"]
    tables = content["tables"]
    kernels = system_in(system, None if tables is None else decode(SavedSystem, tables))
    orbits = {f"{system}{'/' if tables is None else ':'}{own}" for own in kernels.module.ORBITS}
    itinerary = [(c, b) for c, b in content["itinerary"]]
    if "declaration" in content:
        kernels = kernels_with(kernels, content["declaration"])
    else:  # of a census each orbit has its own
        kernels = with_routes(kernels, itinerary)
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
    """The phases, all of which last, of an orbit that a file names and its built-in system knows.

    Parameters
    ----------
    kernels : SystemKernels
        Of the system.
    content : dict
        The file, read as JSON.

    Returns
    -------
    list of (configuration, boundary), or None
        None where the system is a user's, or no declaration names the orbit.

    Raises
    ------
    Failure
        If a built-in system has no such orbit, or one of its phases lasts no time.
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
    """An orbit that was one of a file: unknowns are called as they are here.

    Their names are no other ones of the system, which the checker sees to.
    """
    declared = content.get("declaration")
    if not declared or not is_saved(content["orbit"]):
        raise Failure(f"{content['orbit']} is no orbit of {content['system']}")
    dwell = tuple(phase["dwell_time"] for phase in declared["phases"])
    return NamedOrbit(kernels, None, cycle, tuple(declared["start"]), dwell, called=False)
