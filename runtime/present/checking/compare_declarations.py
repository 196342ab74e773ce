"""Whether what a file proves is of the system and the orbit that it names.

Names, values and the declaration in the file are compared with those of the system, where that
is there. Each function tells whether that could be done, and raises `Failure` or `InputError` if
they differ.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from itertools import product
from pathlib import Path
from typing import Any

from nonsmooth.runtime.checker import Failure
from nonsmooth.runtime.core.errors import NoConvergence
from nonsmooth.runtime.core.json_codec import given_value
from nonsmooth.runtime.core.values import Value, as_value, flint_precision
from nonsmooth.runtime.model.completion import complete, system_parameters
from nonsmooth.runtime.present.checking.named_orbits import NamedOrbit, named_in
from nonsmooth.runtime.proof.certificate import GUARD
from nonsmooth.runtime.proof.exact_tables import exact_tables
from nonsmooth.runtime.proof.orbit_cycle import NotCovered, physical_values
from nonsmooth.runtime.proof.parametric_declaration import orbit_declaration, system_declaration
from nonsmooth.runtime.proof.statement import rational

__all__ = ["compare_box", "compare_census", "compare_certificate", "compare_events"]

Content = Mapping[str, Any]


def compare_certificate(content: Content, folder: Path) -> bool:
    """Compare a certificate."""
    return _compare(content, folder, _declared_at_point, "at its parameters")


def compare_box(content: Content, folder: Path) -> bool:
    """Compare a map."""
    return _compare(content, folder, _declared_over_box, "over the box")


def compare_events(content: Content, folder: Path) -> bool:
    """Compare each event that is proved: a box of one parameter."""
    compared = []
    for number, event in enumerate(content["events"], 1):
        if event["claim"] != "proved":
            continue
        name = event["parameter"]
        # a dwell time may have the same name: the parameter follows it
        *_, side = (side for side in event["box"] if side["name"] == name)
        middle, radius = rational(side["mid"]), rational(side["rad"])
        box = {name: [str(middle - radius), str(middle + radius)]}
        try:
            compared.append(compare_box({**event, "box": box}, folder))
        except Failure as problem:
            raise Failure(f"event {number}, {event['kind']}: {problem}") from None
    return all(compared)


def compare_census(content: Content, folder: Path) -> bool:
    """Compare all orbits of a census, and its parameters with theirs."""
    named = named_in(content, folder)
    if named is None:
        return False
    given = _given_values(content["parameters"])
    for found in (orbit["certificate"] for orbit in content["orbits"]):
        if found is None:
            continue
        compare_certificate(found, folder)
        own = _given_values(found["parameters"])
        values = given
        if named.derived is not None:
            chosen = {name: own[name] for name in found["chosen"]}
            try:
                values = physical_values(named.derived, {**given, **chosen})
            except (NotCovered, KeyError) as problem:
                raise Failure(f"the parameters of the census: {problem}") from None
        if values != own:
            raise Failure("an orbit is not at the parameters of the census")
        period = None if named.derived is None else given.get(named.period)
        if period is not None and period.text != found["given_period"]:
            raise Failure("an orbit has not the period of the census")
    return True


def _compare(
    content: Content,
    folder: Path,
    declare: Callable[[NamedOrbit, Content], Mapping[str, Any]],
    where: str,
) -> bool:
    """Compare what is stated of one orbit with what its system declares."""
    if not content["declaration"]:
        return False
    named = named_in(content, folder)
    if named is None:
        return False
    named.check_chosen(content["chosen"])
    if declare(named, content) != content["declaration"]:
        raise Failure(f"the declaration is not that of {content['system']} {where}")
    return True


def _declared_at_point(named: NamedOrbit, content: Content) -> Mapping[str, Any]:
    """The system and the cycle at the parameters of a certificate."""
    values = system_parameters(named.kernels, _given_values(content["parameters"]))
    work = content["bits"] + GUARD
    with flint_precision(work):
        return system_declaration(
            named.kernels,
            named.cycle,
            exact_tables(named.kernels, tuple(values.values()), work),
            named.start,
            named.dwell,
            timed=content["closing"]["kind"] == "period",
        )


def _declared_over_box(named: NamedOrbit, content: Content) -> Mapping[str, Any]:
    """The system and the cycle over a box, whose corners are in the domain."""
    box = {name: tuple(map(Fraction, ends)) for name, ends in content["box"].items()}
    given = _given_values(content["parameters"])
    for corner in product(*box.values()):
        _check_values(named, given | dict(zip(box, map(as_value, corner), strict=True)))
    closing = content["closing"]
    if closing["kind"] == "period" and closing["period"] != named.period:
        raise Failure("the period is not the one that is given")
    names = content["declaration"]["parameters"]
    return orbit_declaration(
        named.kernels, named.derived, named.cycle, names, named.start, named.dwell
    )


def _check_values(named: NamedOrbit, values: dict[str, Value]) -> None:
    """Refuse names that were not to be given, and values that are in no domain."""
    if named.derived is None:
        own = {name: value for name, value in values.items() if name != named.period}
        system_parameters(named.kernels, own)
        return
    try:
        complete(named.derived, values)
    except NoConvergence as problem:
        raise Failure(str(problem)) from None


def _given_values(parameters: Mapping[str, str]) -> dict[str, Value]:
    """Values as they were written."""
    return {name: given_value(name, text) for name, text in parameters.items()}
