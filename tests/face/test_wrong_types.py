"""Methods of results refuse arguments of a wrong type in one line, by an InputError."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator
from contextlib import suppress
from functools import cache
from typing import Any

import pytest

import nonsmooth as ns

STICK = "dry-friction/global-stick"
WRONG = (object(), ["a"], {"a": "b"}, None)


@cache
def motion() -> Any:
    data = {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "r": "0.5"}
    return ns.simulate("rigid-stop", data, [0, 0, 1.5, 0], transitions=3)


RECORDS: dict[str, Callable[[], Any]] = {
    "orbit": lambda: ns.solve(STICK),
    "orbits": lambda: ns.solve(STICK, {"eta": [1, 1.01]}),
    "derivatives of an orbit": lambda: ns.solve("rigid-stop/one-impact").derivatives(["T"]),
    "motion of an orbit": lambda: ns.solve(STICK).motion(),
    "motion": motion,
    "derivatives of a motion": lambda: motion().derivatives(["k1"], times=[0.1]),
    "function": lambda: ns.orbit_function(ns.solve(STICK), by="eta", of="period"),
    "branch": lambda: ns.continue_orbit(ns.solve(STICK), "V", (0.98, 1.02)),
    "certificate": lambda: ns.certify(ns.solve(STICK)),
}


def calls(record: object) -> Iterator[tuple[str, Callable[..., object], dict[str, object]]]:
    """Methods of a record, each with one argument of a wrong type."""
    for name in (n for n in dir(type(record)) if not n.startswith("_") or n == "__call__"):
        if not inspect.isfunction(inspect.getattr_static(type(record), name)):
            continue
        method = getattr(record, name)
        taken = inspect.signature(method).parameters.values()
        for parameter in (p.name for p in taken if p.kind is not p.VAR_KEYWORD):
            for wrong in WRONG:
                with suppress(TypeError):  # others have to be given, too
                    inspect.signature(method).bind(**{parameter: wrong})
                    yield name, method, {parameter: wrong}


@pytest.mark.parametrize("kind", RECORDS)
def test_arguments_of_a_wrong_type_are_refused(kind: str) -> None:
    count = 0
    for name, method, given in calls(RECORDS[kind]()):
        try:
            method(**given)
        except ns.InputError as refusal:
            assert "\n" not in str(refusal)  # noqa: PT017 - some of these calls are right
            count += 1
        except ns.MissingExtra:
            continue
        except Exception as problem:
            raise AssertionError(f"{name} of {given}: {problem!r}") from problem
    assert count


@pytest.mark.parametrize("wrong", [[1, 2], "a", 3])
def test_values_by_names_are_refused_where_they_are_none(wrong: Any) -> None:
    orbit = ns.solve(STICK)
    data = {name: value.text for name, value in ns.certify(orbit).parameters.items()}
    for asked in (
        lambda: ns.solve(STICK, wrong),
        lambda: ns.solve(STICK, given=wrong),
        lambda: ns.solve(STICK, parameters=wrong),
        lambda: ns.find_orbits("dry-friction", data, n=2, transitions=60, box=wrong),
        lambda: ns.design(orbit, solve=wrong, over={"V": (0.9, 1.1)}),
    ):
        with pytest.raises(ns.InputError, match="by names"):
            asked()


def test_what_is_of_another_kind_is_refused() -> None:
    data = {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "r": "0.5"}
    tiles = ns.certify.box(ns.solve(STICK), {"V": ("0.999", "1.001")}, tiles=1)
    found: Any = ns.find_orbits("rigid-stop", data, 1, transitions=3)
    calls: list[tuple[Callable[[], object], str]] = [
        (lambda: ns.poincare_map("rigid-stop", data, 3), "a section is"),
        (lambda: ns.observe(3), "3 is no motion"),
        (lambda: ns.itinerary_of(3), "3 is no motion"),
        (lambda: ns.certify.all(STICK, box=3), "3 does not give values by names"),
        (lambda: tiles.where(3), "3 is no tile"),
        (lambda: tiles.tile_at(3), "3 does not give values by names"),
        (lambda: found.share([1, 2, 3.5]), "is no outcome of one start"),
    ]
    for refused, told in calls:
        with pytest.raises(ns.InputError, match=told):
            refused()
