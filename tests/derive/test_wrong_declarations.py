"""Whatever a declaration is given, it is made, or refused in one line."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from dataclasses import fields
from typing import Any

import numpy as np
import pytest
import sympy as sp

import nonsmooth.derive as nd
from nonsmooth.derive import dry_friction

ORBIT = dry_friction.orbits[0]
SYSTEM = ORBIT.system
REFUSALS = (nd.DeclarationError, nd.DerivationError)
NEVER = object()  # what nothing takes
WRONG = (
    NEVER, None, True, 5, 2.5, "x y!", "", b"x", [], {}, (), [5], ["x", 5], [(sp.Symbol("z"),)],
    [None], b"2", {"x", "y"}, "open(5)", "x.y", np.ma.array([[3.0]], mask=True),
    {"x": 1}, {5: 1}, float("nan"), sp.Symbol("z"), sp.ones(2, 3), np.zeros(3),
)  # fmt: skip
# with which each public name makes something; records of the paper's orbit give their own fields
RIGHT: dict[str, Any] = {
    "Boundary": SYSTEM.configurations[0].boundaries[0],
    "Condition": next(c for t in SYSTEM.transitions for c in t.conditions),
    "Configuration": SYSTEM.configurations[0],
    "Contact": SYSTEM.contacts[0],
    "FirstOrder": {"matrix": sp.eye(2), "offset": [0, 1]},
    "Friction": {"coordinate": "x", "kinetic": 1, "static": 2},
    "Harmonic": {"frequency": 2, "cosine": [1], "sine": [0]},
    "Itinerary": ORBIT,
    "Parameter": {"name": "a", "description": "", "lower": 0, "upper": 1},
    "Phase": ORBIT.phases[0],
    "Presentation": ORBIT.presentation,
    "Reference": ORBIT.reference,
    "Regions": {"function": "x"},
    "RigidStop": {"coordinate": "x", "at": 1, "restitution": 0.5},
    "SecondOrder": {"mass": [[1]], "stiffness": [[1]], "load": [1], "damping": [[0]]},
    "Slider": {"coordinate": "x", "stiffness": 1, "limit": 2},
    "SoftStop": {"coordinate": "x", "at": 1, "stiffness": 3},
    "Source": ORBIT.source,
    "System": SYSTEM,
    "Terms": {"stiffness": [[1]], "damping": [[1]], "load": [1]},
    "Transition": SYSTEM.transitions[0],
    "chain_matrices": {"masses": [1, 1], "springs": [1, 1], "dampers": [0, 0]},
    "derive_equations": {"itinerary": nd.Itinerary("o", SYSTEM, ORBIT.phases[:1])},
    "oscillator": {
        "name": "o", "coordinates": ["x"], "mass": [[1]], "stiffness": [[1]],
    },
    "read_matrices": {"path": "no-such-file.npz"},
    "reduce_structure": {
        "mass": np.eye(3), "stiffness": np.eye(3), "keep": [0], "modes": 1,
    },
}  # fmt: skip
MADE_ALONE = ("EquationSystem", "ReducedStructure")  # which other functions return
FORCES = ("Harmonic",)
ELEMENTS = ("Friction", "Regions", "RigidStop", "Slider", "SoftStop")


def right(name: str) -> dict[str, Any]:
    """All arguments with which a public name makes something."""
    given = RIGHT[name]
    if not isinstance(given, dict):
        given = {f.name: getattr(given, f.name) for f in fields(given) if f.init}
    parameters = inspect.signature(getattr(nd, name)).parameters.values()
    return {p.name: p.default for p in parameters if p.default is not p.empty} | given


def make(name: str, given: dict[str, Any]) -> object:
    """What a public name makes; elements and forces are put into an oscillator."""
    made = getattr(nd, name)(**given)
    if name in (*ELEMENTS, *FORCES, "Terms"):
        terms = nd.Regions("x", below=made) if name == "Terms" else made
        part = {"forcing": [made]} if name in FORCES else {"elements": [terms]}
        nd.oscillator("o", ["x"], [[1]], [[1]], **part)
    return made


@pytest.mark.parametrize(
    "text", ["__import__('os')", "open(5)", "x.free_symbols", "x[0]", "exec(x)", "x := 2", "'x'"]
)
def test_texts_of_formulas_are_no_programs(text: str) -> None:
    for name, argument, given in (
        ("oscillator", "damping", [[text]]),
        ("RigidStop", "at", text),
        ("Parameter", "upper", text),
        ("chain_matrices", "masses", [text, 1]),
    ):
        assert refusal(name, right(name) | {argument: given}), name


@pytest.mark.parametrize("text", ["x", "2*pi/sqrt(3)", "1e-3*a**2", ".5", "sin(x) - (a + 1)/2"])
def test_texts_of_formulas_are_what_they_say(text: str) -> None:
    assert nd.Boundary("b", text).function == nd.Boundary("b", sp.nsimplify(text)).function


def test_what_has_no_order_is_refused_where_it_counts() -> None:
    for name, argument, given in (
        ("oscillator", "coordinates", {"x"}),
        ("chain_matrices", "masses", {1, 2}),
        ("System", "states", {*SYSTEM.states}),
    ):
        assert "no order" in refusal(name, right(name) | {argument: given})


def test_what_a_mask_leaves_out_is_refused() -> None:
    masked = np.ma.array([[3.0]], mask=True)
    for name in ("mass", "stiffness", "damping"):
        assert "masked" in refusal("oscillator", right("oscillator") | {name: masked})
    assert "masked" in refusal("oscillator", right("oscillator") | {"load": masked[0]})
    whole = np.ma.array(np.eye(3), mask=np.eye(3) > 0)
    for name in ("mass", "stiffness", "damping"):
        assert "masked" in refusal("reduce_structure", right("reduce_structure") | {name: whole})


def refusal(name: str, given: dict[str, Any]) -> str:
    """What is said to wrong arguments; nothing if something is made of them."""
    try:
        repr(make(name, given))
    except REFUSALS as problem:
        return str(problem)
    return ""


def public() -> dict[str, Callable[..., Any]]:
    """The public functions and classes, but for errors."""
    found = {name: getattr(nd, name) for name in nd.__all__ if name not in MADE_ALONE}
    return {
        name: each
        for name, each in found.items()
        if callable(each) and not (inspect.isclass(each) and issubclass(each, Exception))
    }


@pytest.mark.parametrize("name", public())
@pytest.mark.filterwarnings("ignore::sympy.utilities.exceptions.SymPyDeprecationWarning")
def test_wrong_values_are_refused_in_one_line(name: str) -> None:
    arguments = {} if name not in RIGHT else right(name)
    assert arguments
    if name not in ("derive_equations", "read_matrices"):  # of which the right ones are wrong too
        make(name, arguments)
    for argument in arguments:
        for wrong in WRONG:
            said = refusal(name, arguments | {argument: wrong})
            assert "\n" not in said
            assert said or wrong is not NEVER, argument
