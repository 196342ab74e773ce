"""Kernels do not depend on how states, parameters and unknowns are called."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator, Mapping
from itertools import zip_longest
from types import ModuleType

import pytest

from nonsmooth.derive import Itinerary, System
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
    "mm": "wide", "cc": "Ball", "kk": "angle", "xs": "Yy", "bb": "Zz", "FF": "uu", "ww": "early",
    "x1": "qq", "v1": "v_qq", "x10": "qq0", "v10": "v_qq0", "ta": "later", "tb": "Cc",
}  # fmt: skip


# a mass that is shaken, damped, and meets a damped spring
SHAKEN = """
from nonsmooth.derive import Harmonic, Itinerary, Parameter, Reference, SoftStop, oscillator
parameters = [Parameter(name, "") for name in ("mm", "cc", "kk", "xs", "bb", "FF", "ww")]
symbols = [parameter.symbol for parameter in parameters]
system = oscillator(
    "struck", ["x1"], [symbols[:1]], [[symbols[2]]], damping=[[symbols[1]]],
    forcing=[Harmonic(symbols[6], cosine=[symbols[5]])],
    elements=[SoftStop("x1", at=symbols[3], stiffness=8, damping=symbols[4], name="stop")],
    parameters=parameters,
)
orbits = [
    Itinerary(
        "once", system,
        [("free", "stop-reaches-stop", "ta"), ("contact", "stop-leaves-stop", "tb")],
        reference=Reference(
            {"mm": 1, "cc": "0.1", "kk": 1, "xs": "0.2", "bb": 2, "FF": 1, "ww": 1},
            {"ta": 4, "tb": 2, "x10": "0.2", "v10": 1, "c10": "0.5", "s10": "0.8"},
        ),
    )
]
"""


def renamed(text: str, names: Mapping[str, str]) -> str:
    """The text with other words, also where underscores join them."""
    ordered = sorted(names, key=len, reverse=True)
    pattern = rf"(?<![A-Za-z0-9.])(?:{'|'.join(ordered)})(?![A-Za-z0-9])"
    return re.sub(pattern, lambda found: names[found[0]], text) if names else text


def declared(
    text: str, orbits: tuple[str, ...], names: Mapping[str, str]
) -> tuple[System, list[Itinerary]]:
    """What a source declares with other names."""
    module = ModuleType("renamed")
    exec(renamed(text, names), vars(module))
    return module.system, [orbit for orbit in module.orbits if orbit.name in orbits]


def statements(text: str) -> Iterator[list[str]]:
    """The words of each statement, in an order of their own: printers sort terms by name."""
    for line in re.sub(r",\n +", ", ", text).splitlines():  # long names break lines elsewhere
        if re.search("=|return|Operations", line) and not re.search(r"Takes|^ *#|/\*", line):
            words = re.findall(r"[\w.]+", line)
            yield sorted("_".join(sorted(word.split("_"))) for word in words)


@pytest.mark.parametrize(
    ("source", "orbits", "names", "kernel"),
    [
        (SHAKEN, ("once",), STRUCK, "once_equations"),
        pytest.param(
            inspect.getsource(dry_friction), ("global-stick", "solution-ii"),
            FRICTION, "solution_ii_reduced", marks=pytest.mark.slow,
        ),
    ],
    ids=["shaken", "friction"],
)  # fmt: skip
def test_names_do_not_change_the_code(
    source: str, orbits: tuple[str, ...], names: Mapping[str, str], kernel: str
) -> None:
    system, itineraries = declared(source, orbits, {})
    one = emit_library(system, itineraries, "tests")
    other = emit_library(*declared(source, orbits, names), "tests")
    stem = system.name.replace("-", "_")
    before = {new: old for old, new in names.items()}
    for suffix, begin in ((".py", "def "), (".c", "void ")):
        texts = one[stem + suffix], renamed(other[stem + suffix], before)
        assert kernel in texts[0]
        found = (statements(text[text.index(begin) :]) for text in texts)
        for expected, statement in zip_longest(*found):
            assert statement == expected
