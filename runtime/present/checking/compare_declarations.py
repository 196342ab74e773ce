"""Whether what a file proves is of the system and the orbit that it names.

Names, values and the declaration in the file are compared with those of the system: the built-in
one, or the one that the file holds. Each function tells whether the system knows the orbit's name,
and raises `Failure` or `InputError` if they differ.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from itertools import product
from typing import Any

from nonsmooth.runtime.checker import Failure
from nonsmooth.runtime.checker.stated.exact import exact
from nonsmooth.runtime.core.errors import NoConvergence
from nonsmooth.runtime.core.json_codec import decode, given_value
from nonsmooth.runtime.core.values import Value, as_value, flint_precision
from nonsmooth.runtime.model.completion import complete
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.parameters import system_parameters, value_of
from nonsmooth.runtime.model.saved_system import SavedSystem, system_in
from nonsmooth.runtime.present.checking.named_orbits import NamedOrbit, named_in, phases_called
from nonsmooth.runtime.proof.certificate import GUARD
from nonsmooth.runtime.proof.exact_tables import (
    ExactSystem,
    exact_system,
    exact_tables,
    irrational_texts,
)
from nonsmooth.runtime.proof.parametric_declaration import (
    PERIOD,
    orbit_declaration,
    system_declaration,
)
from nonsmooth.runtime.proof.sets.visited_declaration import (
    PassedTransition,
    listed_declaration,
    visited_declaration,
)

__all__ = ["check_domains", "compare"]

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
    """Compare a certificate with its system, and the directions of its derivatives."""
    compared = _compare(content, _declared_at_point, "at its parameters")
    directions = content.get("directions", {})
    for name, direction in directions.items():
        _check_direction(named_in(content), name, {n: Fraction(x) for n, x in direction.items()})
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
    named_in({**first, "orbit": content["orbit"]})
    return compared


def _census(content: Content) -> bool:
    """Compare a census with its system; the certificates have the same declaration."""
    return _compare(content, _declared_at_point, "at its parameters")


def _named_system(content: Content) -> SystemKernels:
    """The built-in system that a file names, or the one that the file itself holds."""
    tables = content["tables"]
    return system_in(content["system"], None if tables is None else decode(SavedSystem, tables))


def _system_of(content: Content) -> tuple[SystemKernels, ExactSystem]:
    """The system that a file of sets names, at the file's parameters."""
    kernels = _named_system(content)
    given = system_parameters(kernels, _given_values(content["parameters"]))
    return kernels, exact_system(kernels, given)


def _basin(content: Content) -> bool:
    """Compare the system of a basin certificate, and the itinerary of its core with the orbit's.

    The core's orbit has to go through the phases of the declared orbit, if the system knows
    its name.
    """
    with flint_precision(content["bits"]):
        kernels, system = _system_of(content)
        if content["claim"] != "proved":
            return False
        if listed_declaration(kernels, system) != content["declaration"]:
            raise Failure(f"the declaration is not that of {content['system']}")
    phases = phases_called(kernels, content)
    if phases is None:
        return False
    way = [(source, boundary) for source, boundary, _ in content["itinerary"]]
    turns, count = len(way) // len(phases), len(phases)
    if not any(way == (phases[k:] + phases[:k]) * turns for k in range(count)):
        raise Failure(f"the orbit through the core is not {content['orbit']}")
    return True


def _graph(content: Content) -> bool:
    """Compare the system of a graph of boxes with the file's declaration."""
    with flint_precision(content["bits"]):
        kernels, system = _system_of(content)
        if listed_declaration(kernels, system) != content["declaration"]:
            raise Failure(f"the declaration is not that of {content['system']}")
    return True


def _chaos(content: Content) -> bool:
    """Compare the system of a certificate of chaos with the file's declaration."""
    with flint_precision(content["bits"]):
        kernels, system = _system_of(content)
        if content["claim"] != "proved":
            return False
        structure = system.structure

        def passed(source: str, boundary: str, target: str) -> PassedTransition:
            here = structure.configuration(source)
            reached = tuple(structure.boundary(here, name) for name in boundary.split("+"))
            return PassedTransition(here, reached, structure.configuration(target))

        ways = [
            passed(*each) for h in content["h_sets"] for each in content["itineraries"][h["name"]]
        ]
        if not structure.forcing:
            ways.append(passed(content["source"], content["boundary"], content["configuration"]))
        if visited_declaration(kernels, system, ways) != content["declaration"]:
            raise Failure(f"the declaration is not that of {content['system']}")
    return True


def _compare(
    content: Content,
    declare: Callable[[NamedOrbit, Content], Mapping[str, Any]],
    where: str,
) -> bool:
    """Compare the file's declaration of one orbit with that of its system.

    The result is false if there is no declaration, or if the system does not know the name.
    """
    if not content["declaration"]:
        return False
    named = named_in(content)
    named.check_chosen(content["chosen"])
    if declare(named, content) != content["declaration"]:
        raise Failure(f"the declaration is not that of {content['system']} {where}")
    return named.called


def _check_direction(named: NamedOrbit, name: str, rates: Mapping[str, Fraction]) -> None:
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


def _declared_at_point(named: NamedOrbit, content: Content) -> Mapping[str, Any]:
    """The declaration of system and cycle at the parameters of a certificate."""
    values = system_parameters(named.kernels, _given_values(content["parameters"]))
    work = content["bits"] + GUARD
    with flint_precision(work):
        return system_declaration(
            named.kernels,
            named.cycle,
            exact_tables(named.kernels, tuple(values.values()), work),
            named.start,
            named.dwell,
            timed=bool(content["given_period"]),
        )


def _declared_over_box(named: NamedOrbit, content: Content) -> Mapping[str, Any]:
    """The declaration of system and cycle over a box; its corners have to be in the domain."""
    box = {name: tuple(map(Fraction, ends)) for name, ends in content["box"].items()}
    given = _given_values(content["parameters"])
    for corner in product(*box.values()):
        _check_values(named, given | dict(zip(box, map(as_value, corner), strict=True)))
    closing = content["closing"]
    if closing["kind"] == "period" and closing["period"] != named.period:
        raise Failure("the period is not the one that is given")
    names = content["declaration"]["parameters"]
    texts = irrational_texts(named.kernels, given.values() if closing["kind"] == "period" else ())
    return orbit_declaration(
        named.kernels, named.derived, named.cycle, names, named.start, named.dwell, texts
    )


def _check_values(named: NamedOrbit, values: dict[str, Value]) -> None:
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


_COMPARISONS: Mapping[str, Callable[[Content], bool]] = {
    "nonsmooth certificate": _certificate,
    "nonsmooth box certificate": _box,
    "nonsmooth event certificate": _events,
    "nonsmooth certified branch": _branch,
    "nonsmooth certified doubling": _doubling,
    "nonsmooth census": _census,
    "nonsmooth basin certificate": _basin,
    "nonsmooth chaos certificate": _chaos,
    "nonsmooth region certificate": _graph,
}
