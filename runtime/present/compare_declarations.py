"""Whether what a file proves is of the system and the orbit that it names.

Names, values and the declaration in the file are compared with those of the system: the built-in
one, or the one that the file holds. Each function tells whether the system knows the orbit's name,
and raises `Failure` or `InputError` if they differ.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import partial
from itertools import product
from typing import Any, NamedTuple

from nonsmooth.runtime.checker import Failure
from nonsmooth.runtime.checker.stated.exact import exact
from nonsmooth.runtime.core.errors import NoConvergence
from nonsmooth.runtime.core.json_codec import decode, given_value
from nonsmooth.runtime.core.values import Value, as_value, flint_precision
from nonsmooth.runtime.model.completion import complete, left_open
from nonsmooth.runtime.model.kernels import (
    OrbitKernels,
    SystemKernels,
    is_saved,
    load_orbit,
    load_system,
)
from nonsmooth.runtime.model.naming import cycle_label, dwell_names, start_names
from nonsmooth.runtime.model.parameters import system_parameters, value_of
from nonsmooth.runtime.model.saved_system import SavedSystem, system_in
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.table_solve import whole_names
from nonsmooth.runtime.proof.certificate import GUARD
from nonsmooth.runtime.proof.sets.sections import (
    Way,
    listed_declaration,
    visited_declaration,
)
from nonsmooth.runtime.proof.statement import (
    PERIOD,
    ExactSystem,
    declaration_json,
    exact_system,
    exact_tables,
    kernels_with,
    system_declaration,
    tables_over,
)
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape, itinerary_shape

Content = Mapping[str, Any]


def compare(content: Content) -> bool:
    """Compare the declarations of a file (read as JSON) with those of the systems it names.

    The result is true if each orbit of the file has a declaration, and a name that its
    system knows. A different declaration raises `Failure`.
    """
    return _COMPARISONS[content["format"]](content)


def check_domains(content: Content) -> None:
    """Raise `InputError` for a parameter's value outside of its domain.

    `content` is a part of a file that names a system; the message has the value and the
    domain.
    """
    kernels, given = _named_system(content), _given_values(content["parameters"])
    for table in kernels.parameters:
        if table.name in given:
            value_of(table, given[table.name])


def _certificate(content: Content) -> bool:
    """Compare a certificate with its system, and the directions of its derivatives.

    Those of a census have its declaration.
    """
    compared = _compare(content, _declared_at_point, "at its parameters")
    directions = content.get("directions", {})
    for name, direction in directions.items():
        _check_direction(_named_in(content), name, {n: Fraction(x) for n, x in direction.items()})
    return compared


def _box(content: Content) -> bool:
    """Compare a proven map with its system."""
    return _compare(content, _declared_over_box, "over the box")


def _events(content: Content) -> bool:
    """Compare each proved event with its system, as a box of one parameter."""
    compared = []
    for number, event in enumerate(content["events"], 1):
        if event["claim"] != "proved":
            continue
        name = event["parameter"]
        # a dwell time may have the same name: the parameter follows it
        *_, side = (side for side in event["box"] if side["name"] == name)
        middle, radius = exact(side["mid"]), exact(side["rad"])
        box = {name: [str(middle - radius), str(middle + radius)]}
        try:
            compared.append(_box({**event, "box": box}))
        except Failure as problem:
            raise Failure(f"event {number}, {event['kind']}: {problem}") from None
    return all(compared)


def _branch(content: Content) -> bool:
    """Compare a certified branch, as a box of one parameter, and those that begin at its events."""
    events = [tile["event"] for tile in content["tiles"] if tile["event"] is not None]
    beyond = [each["branch"] for event in events for each in event.get("beyond", [])]
    own = {**content, "box": {content["parameter"]: content["interval"]}}
    return all([_box(own), *map(_branch, beyond)])


def _doubling(content: Content) -> bool:
    """Compare both branches of a certified doubling."""
    first, doubled = content["branch"], content["doubled"]
    compared = all([_branch(first), doubled is None or _branch(doubled["branch"])])
    if content["orbit"] == first["orbit"]:
        return compared
    if first["tables"] is not None:
        return False
    _named_in({**first, "orbit": content["orbit"]})
    return compared


def _named_system(content: Content) -> SystemKernels:
    """The built-in system that a file names, or the one that the file itself holds."""
    tables = content["tables"]
    return system_in(content["system"], None if tables is None else decode(SavedSystem, tables))


def _sets(
    content: Content,
    declare: Callable[[SystemKernels, ExactSystem], Mapping[str, Any]] = listed_declaration,
    undecided: bool = False,
) -> bool:
    """Compare the system of a file of sets, with its declaration.

    The result is false if nothing is claimed, unless what is `undecided` is stated as well.
    """
    kernels = _named_system(content)
    given = system_parameters(kernels, _given_values(content["parameters"]))
    if content["claim"] != "proved" and not undecided:
        return False
    with flint_precision(content["bits"]):
        if declare(kernels, exact_system(kernels, given)) != content["declaration"]:
            raise Failure(f"the declaration is not that of {content['system']}")
    return True


def _basin(content: Content) -> bool:
    """Compare the system of a basin certificate, and the itinerary of its core with the orbit's.

    The core's orbit has to go through the phases of the declared orbit, if the system knows
    its name.
    """
    if not _sets(content):
        return False
    phases = _phases_called(content)
    if phases is None:
        return False
    way = [(source, boundary) for source, boundary, _ in content["itinerary"]]
    turns, count = len(way) // len(phases), len(phases)
    if not any(way == (phases[k:] + phases[:k]) * turns for k in range(count)):
        raise Failure(f"the orbit through the core is not {content['orbit']}")
    return True


def _chaos(content: Content) -> bool:
    """Compare the system of a certificate of chaos with the file's declaration."""

    def declare(kernels: SystemKernels, system: ExactSystem) -> Mapping[str, Any]:
        structure = system.structure

        def passed(source: str, boundary: str, target: str) -> Way:
            here = structure.configuration(source)
            reached = frozenset(structure.boundary(here, name) for name in boundary.split("+"))
            return here, reached, structure.configuration(target)

        ways = [
            passed(*each) for h in content["h_sets"] for each in content["itineraries"][h["name"]]
        ]
        if not structure.forcing:
            ways.append(passed(content["source"], content["boundary"], content["configuration"]))
        return visited_declaration(kernels, system, ways)

    return _sets(content, declare)


def _compare(
    content: Content,
    declare: Callable[[_NamedOrbit, Content], Mapping[str, Any]],
    where: str,
) -> bool:
    """Compare the file's declaration of one orbit with that of its system.

    The result is false if there is no declaration, or if the system does not know the name.
    """
    if not content["declaration"]:
        return False
    named = _named_in(content)
    named.check_chosen(content["chosen"])
    if declare(named, content) != content["declaration"]:
        raise Failure(f"the declaration is not that of {content['system']} {where}")
    return named.called


def _check_direction(named: _NamedOrbit, name: str, rates: Mapping[str, Fraction]) -> None:
    """Refuse a direction along which more than one of the numbers given for the orbit changes.

    Parameters that its equations do not contain may change: if they contain only e1 = ur1 -
    us1, either of the two may.
    """
    kernels = named.derived
    known = {table.name for table in named.kernels.parameters}
    fixed, sums = (known, {}) if kernels is None else (kernels.parameter_names, kernels.combined)
    if name == named.period:
        known, wanted = {PERIOD}, {PERIOD: 1}
    else:
        wanted = {other: int(other == name) for other in fixed if other != named.period}
    required = () if kernels is None else kernels.required
    wanted |= dict.fromkeys(required, 0)
    moves = {
        other: sum(factor * rates.get(term, 0) for term, factor in sums[other].items())
        if other in sums
        else rates.get(other, 0)
        for other in wanted
    }
    if moves != wanted or 1 not in wanted.values() or not rates.keys() <= known:
        raise Failure(f"the derivatives by {name} are along another direction")


def _declared_at_point(named: _NamedOrbit, content: Content) -> Mapping[str, Any]:
    """The declaration of system and cycle at the parameters of a certificate."""
    values = system_parameters(named.kernels, _given_values(content["parameters"]))
    work = content["bits"] + GUARD
    with flint_precision(work):
        return system_declaration(
            named.kernels,
            named.cycle,
            exact_tables(named.kernels, values, work),
            named.start,
            named.dwell,
            timed=bool(content["given_period"]),
        )


def _declared_over_box(named: _NamedOrbit, content: Content) -> Mapping[str, Any]:
    """The declaration of system and cycle over a box; its corners have to be in the domain."""
    box = {name: tuple(map(Fraction, ends)) for name, ends in content["box"].items()}
    given = _given_values(content["parameters"])
    for corner in product(*box.values()):
        _check_values(named, given | dict(zip(box, map(as_value, corner), strict=True)))
    closing = content["closing"]
    if closing["kind"] == "period" and closing["period"] != named.period:
        raise Failure("the period is not the one that is given")
    names = content["declaration"]["parameters"]
    beside = given.values() if closing["kind"] == "period" else ()
    tables = tables_over(named.kernels, names, beside=beside, orbit=named.derived)
    return declaration_json(tables, named.cycle, names, named.start, named.dwell)


def _check_values(named: _NamedOrbit, values: dict[str, Value]) -> None:
    """Refuse parameters that must not be given, and values outside of their domains."""
    if named.derived is None:
        own = {name: value for name, value in values.items() if name != named.period}
        system_parameters(named.kernels, own)
        return
    try:
        complete(named.derived, values)
    except NoConvergence as problem:
        raise Failure(str(problem)) from None


def _given_values(parameters: Mapping[str, str]) -> dict[str, Value]:
    """Values of parameters, from the texts of a file."""
    return {name: given_value(name, text) for name, text in parameters.items()}


# --- the orbit that a file names


class _NamedOrbit(NamedTuple):
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


def _named_in(content: Content) -> _NamedOrbit:
    """The system and the orbit that a file (read as JSON) names: built in, or held as data.

    A system without such an orbit raises `Failure`. Phases that it does not have, or data
    that are not in order, raise `InputError`.
    """
    system, label, tables = content["system"], content["orbit"], content["tables"]
    kernels = _named_system(content)
    orbits = {f"{system}{'/' if tables is None else ':'}{own}" for own in kernels.module.ORBITS}
    itinerary = [(c, b) for c, b in content["itinerary"]]
    kernels = kernels_with(kernels, content["declaration"])
    cycle = itinerary_shape(structure_of(kernels), itinerary)
    states, own = kernels.table["states"], {table.name for table in kernels.parameters}
    if label == cycle_label(system, len(itinerary)):
        dwell = dwell_names(len(itinerary), {*states, *own})
        return _NamedOrbit(kernels, None, cycle, start_names(states, {*dwell, *own}), dwell)
    if label not in orbits:
        return _of_file(kernels, cycle, content)
    orbit = load_orbit(label)
    phases = [(c, b) for c, b, _ in orbit.table["phases"]]
    known = orbit.system.name == kernels.name and itinerary[: len(phases)] == phases
    if not known or len(itinerary) % len(phases):
        raise Failure(f"{label} is not that orbit of {system}")
    if orbit.derived:
        dwell = orbit.dwell_times
        return _NamedOrbit(kernels, orbit, cycle, start_names(states, {*dwell, *own}), dwell)
    names = whole_names(orbit, len(itinerary))
    return _NamedOrbit(kernels, orbit, cycle, names[len(itinerary) :], names[: len(itinerary)])


def _phases_called(content: Content) -> list[tuple[str, str]] | None:
    """The pairs (configuration, boundary) of a named orbit that its built-in system declares.

    `content` is the file, read as JSON. The result is None if the system is a user's, or if
    no declaration names the orbit. `Failure` is raised if a built-in system has no such
    orbit, or if one of the orbit's phases lasts no time.
    """
    system, label = content["system"], content["orbit"]
    if content["tables"] is not None or is_saved(label):
        return None
    if label in {f"{system}/{own}" for own in load_system(system).module.ORBITS}:
        table = load_orbit(label).table
        if table.get("vanishing"):
            raise Failure(f"a phase of {label} lasts no time")
        return [(c, b) for c, b, _ in table["phases"]]
    if re.fullmatch(rf"{re.escape(system)}, \d+ phases?", label):
        return None
    raise Failure(f"{label} is no orbit of {system}")


def _of_file(kernels: SystemKernels, cycle: ItineraryShape, content: Content) -> _NamedOrbit:
    """An orbit that was taken from a file, with the names of unknowns that this file gives.

    The checker sees to it that none of them is another name of the system.
    """
    declared = content["declaration"]
    if not declared or not is_saved(content["orbit"]):
        raise Failure(f"{content['orbit']} is no orbit of {content['system']}")
    dwell = tuple(phase["dwell_time"] for phase in declared["phases"])
    return _NamedOrbit(kernels, None, cycle, tuple(declared["start"]), dwell, called=False)


_COMPARISONS: Mapping[str, Callable[[Content], bool]] = {
    "nonsmooth certificate": _certificate,
    "nonsmooth box certificate": _box,
    "nonsmooth event certificate": _events,
    "nonsmooth certified branch": _branch,
    "nonsmooth certified doubling": _doubling,
    "nonsmooth census": _certificate,
    "nonsmooth basin certificate": _basin,
    "nonsmooth chaos certificate": _chaos,
    "nonsmooth region certificate": partial(_sets, undecided=True),
}
