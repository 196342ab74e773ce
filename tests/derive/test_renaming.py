"""Kernels do not depend on how states, parameters and unknowns are called."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Iterator, Mapping
from itertools import zip_longest
from types import ModuleType

import pytest

from nonsmooth.derive import (
    Harmonic,
    Itinerary,
    Parameter,
    Reference,
    SoftStop,
    System,
    oscillator,
)
from nonsmooth.derive.codegen.emit import emit_library
from nonsmooth.derive.systems import dry_friction

# a word's case, and its place in the alphabet, are not those of the word that it replaces
FRICTION = {
    "chi": "wide", "eta": "Ball", "V": "quick", "us1": "zz", "us2": "Below", "ur1": "Aa",
    "ur2": "yy", "e1": "dd", "e2": "cc", "x1": "qq", "x2": "Pp", "v1": "Ww", "v2": "Bb",
    "z1": "xx", "z2": "bb", "z10": "xx0", "z20": "bb0", "v10": "Ww0", "v20": "Bb0",
    "ta": "span", "tau": "Rest", "tau1": "hold", "tau2": "Gg",
}  # fmt: skip
STRUCK = {
    "mm": "wide", "cc": "Ball", "kk": "angle", "at": "Yy", "bb": "Zz", "FF": "uu", "ww": "early",
    "x1": "qq", "v1": "v_qq", "x10": "qq0", "v10": "v_qq0", "ta": "later", "tb": "Cc",
}  # fmt: skip


def renamed(text: str, names: Mapping[str, str]) -> str:
    """The text with other words, also where underscores join them."""
    ordered = sorted(names, key=len, reverse=True)
    pattern = rf"(?<![A-Za-z0-9.])(?:{'|'.join(ordered)})(?![A-Za-z0-9])"
    return re.sub(pattern, lambda found: names[found[0]], text) if names else text


def friction(names: Mapping[str, str], orbits: tuple[str, ...]) -> tuple[System, list[Itinerary]]:
    """The built-in system, declared by its own source with other names."""
    module = ModuleType("renamed")
    exec(renamed(inspect.getsource(dry_friction), names), vars(module))
    return module.system, [orbit for orbit in module.orbits if orbit.name in orbits]


def struck(names: Mapping[str, str]) -> tuple[System, list[Itinerary]]:
    """A mass that is shaken, damped, and meets a damped spring."""

    def named(old: str) -> str:
        return names.get(old, old)

    parameters = [Parameter(named(p), "") for p in ("mm", "cc", "kk", "at", "bb", "FF", "ww")]
    m, c, k, at, b, force, w = (p.symbol for p in parameters)
    system = oscillator(
        "struck", [named("x1")], [[m]], [[k]], damping=[[c]], parameters=parameters,
        forcing=[Harmonic(w, cosine=[force])],
        elements=[SoftStop(named("x1"), at=at, stiffness=8, damping=b, name="stop")],
    )  # fmt: skip
    phases = [("free", "stop-reaches-stop", "ta"), ("contact", "stop-leaves-stop", "tb")]
    known = {"mm": 1, "cc": "0.1", "kk": 1, "at": "0.2", "bb": 2, "FF": 1, "ww": 1}
    guess = {"ta": 4, "tb": 2, "x10": "0.2", "v10": 1, "c10": "0.5", "s10": "0.8"}
    reference = Reference(*({named(n): x for n, x in each.items()} for each in (known, guess)))
    phases = [(*phase, named(dwell)) for *phase, dwell in phases]
    return system, [Itinerary("once", system, phases, reference=reference)]


def statements(text: str) -> Iterator[list[str]]:
    """The words of each statement, in an order of their own: printers sort terms by name."""
    for line in re.sub(r",\n +", ", ", text).splitlines():  # long names break lines elsewhere
        if re.search("=|return|Operations", line) and not re.search(r"Takes|^ *#|/\*", line):
            words = re.findall(r"[\w.]+", line)
            yield sorted("_".join(sorted(word.split("_"))) for word in words)


@pytest.mark.parametrize(
    ("declare", "names", "kernel"),
    [
        (struck, STRUCK, "once_equations"),
        pytest.param(
            lambda names: friction(names, ("global-stick", "solution-ii")),
            FRICTION, "solution_ii_reduced", marks=pytest.mark.slow,
        ),
    ],
)  # fmt: skip
def test_names_do_not_change_the_code(
    declare: Callable[[Mapping[str, str]], tuple[System, list[Itinerary]]],
    names: Mapping[str, str],
    kernel: str,
) -> None:
    one, other = (emit_library(*declare(each), "tests") for each in ({}, names))
    stem = declare({})[0].name.replace("-", "_")
    before = {new: old for old, new in names.items()}
    for suffix, begin in ((".py", "def "), (".c", "void ")):
        texts = one[stem + suffix], renamed(other[stem + suffix], before)
        assert kernel in texts[0]
        found = (statements(text[text.index(begin) :]) for text in texts)
        for expected, statement in zip_longest(*found):
            assert statement == expected
