"""Symbols carry their meaning: no name of a declaration is taken for one of the derivation."""

import ctypes
import pickle
from itertools import permutations
from random import Random

import numpy as np
import pytest
import sympy as sp

from nonsmooth.derive import (
    Boundary,
    Configuration,
    Itinerary,
    Parameter,
    Phase,
    SecondOrder,
    System,
    Transition,
    derive_equations,
)
from nonsmooth.derive.codegen.emit import emit_library
from nonsmooth.derive.codegen.kernels import orbit_kernels
from nonsmooth.derive.document.describe import describe_orbit
from nonsmooth.derive.document.hypertext import to_markdown
from nonsmooth.derive.document.view import notation_of
from nonsmooth.derive.equations.explicit import Angle
from nonsmooth.derive.equations.program import evaluate
from nonsmooth.derive.symbols import Symbol, derivative
from nonsmooth.runtime.core.arithmetic import FLOATS
from tests.compiled_c import library_of, needs_compiler, pointer


def hopping(names):
    """A ball on a spring that falls onto a place and is thrown back, faster by some pushes."""
    position, velocity, place, push, dwell, spring, *more = names.split()
    x, v = sp.symbols([position, velocity], real=True)
    parameters = tuple(Parameter(name, "", lower=-sp.oo) for name in (place, push, *more))
    ground, *pushes = (p.symbol for p in parameters)
    parameters += (Parameter(spring, ""),)
    stiffness = parameters[-1].symbol
    motion = SecondOrder(sp.Matrix([[1]]), sp.Matrix([[stiffness]]), load=(-1,))
    air = Configuration("air", motion, (Boundary("lands", ground - x),))
    back = Transition("air", frozenset({"lands"}), "air", (), {v: -v / 2 + sum(pushes)})
    ball = System("ball", "", (x, v), parameters, (air,), (back,))
    hop = Itinerary("hop", ball, (Phase("air", "lands", dwell),), start={velocity: f"{velocity}0"})
    return derive_equations(hop)


# by how many names it has
PLAIN = {
    len(names.split()): hopping(names)
    for names in ("x v a b tau k", "x v a b tau k c d e f g h i j l m n o p q")
}
NAMES = {
    "parameters as what a derivation makes": (
        "x v x_1 v_1_reset tau k cos_tau half_tau omega1 omega1_by_k x_1_by_tau v_1_by_v0 omega2"
        " determinant coefficient11 rate_tau amplitude_tau x_times_v v0_slope delay_tau"
    ),
    "a state behind a phase": "x_1 x a b tau k",
    "a state behind a transition": "x_1_reset x a b tau k",
    "a derivative": "x_by_tau x a b tau k",
    "what a flow carries": "carried_x x a b tau k",
    "what is on a boundary": "x_1_on_boundary x a b tau k",
    "a dwell time": "x v a b half_x_1 k",
    "names in another order": "z A y Cc B D",
}


@pytest.mark.parametrize("names", NAMES.values(), ids=NAMES)
def test_equations_do_not_depend_on_what_the_user_calls_things(names):
    equations = hopping(names)
    plain = PLAIN[len(names.split())]
    mine, theirs = (
        (*e.system.states, *(p.symbol for p in e.system.parameters), *e.unknowns)
        for e in (plain, equations)
    )
    renamed = dict(zip(theirs, mine, strict=True))
    for quantity in ("residual", "jacobian", "map"):
        found = sp.Matrix(equations.expand(quantity)).xreplace(renamed)
        difference = (found - sp.Matrix(plain.expand(quantity))).applyfunc(sp.expand)
        assert difference.is_zero_matrix, quantity


@pytest.mark.parametrize("names", NAMES.values(), ids=NAMES)
def test_different_symbols_are_written_differently(names):
    equations = hopping(names)
    notation = notation_of(equations)
    declared = (*equations.system.states, *(p.symbol for p in equations.system.parameters))
    stages = (*equations.stages_of("jacobian"), *equations.stages_of("map"))
    made = {s for stage in stages for s, _ in stage.assignments} - {*notation.functions}
    symbols = {*declared, *equations.unknowns, *made}
    assert len({notation.symbol(s) for s in symbols}) == len(symbols)
    assert to_markdown(describe_orbit(equations)).count(notation.symbol(declared[2])) > 1


# beside those above: names that Python, C, the kernels or their printers have for something else
WORDS = {
    "arrays and common terms of kernels, and what SymPy has": (
        "unknowns trace parameters spectrum time residual t0 t1 t2 t3 t4 t5 E S N pi zoo Q"
    ),
    "what kernels and Python call, and C names itself": (
        "abs fabs sin cos sqrt M_PI np lib outputs lambda_ print json lane lanes fixed wave_0 main"
        " count"
    ),
    "words and macros of C, and of the header": (
        "int double const static bool default I NULL NAN DBL_EPSILON SIZE_MAX NONSMOOTH_SIMD"
        " BALL_H NONSMOOTH_BALL_H BALL_CONVERGED"
    ),
    "words of C and what takes their place": "int int_ x_1 x_1_ int__ int___",
    "derivatives": "x dx dx_1 dx_1_by_tau tau x_1_by_dx_1",
    "time": "s x time_ s0 tau t_",
    "letters that Python reads as one": "\u00b5 x \u03bc \u03bc_ tau k",
    "what begins another name": "x v x_ v_ tau_ _k",
}

QUICK = "parameters as what a derivation makes", "words of C and what takes their place"


@needs_compiler
@pytest.mark.parametrize(
    "names",
    [
        pytest.param(names, id=case, marks=() if case in QUICK else pytest.mark.slow)
        for case, names in {**NAMES, **WORDS}.items()
    ],
)
def test_kernels_are_right_whatever_the_user_calls_things(names, tmp_path):
    """Each kernel in Python and in C gives what its symbolic stages say, at random numbers."""
    equations = hopping(names)
    kernels = orbit_kernels(equations)
    system = equations.itinerary.system
    for name, text in emit_library(system, [equations.itinerary], "tests").items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    library, python = library_of(tmp_path / "ball.c", include=tmp_path), {}
    exec((tmp_path / "ball.py").read_text(encoding="utf-8"), python)
    random = Random(names)
    for kernel in kernels:
        symbols = [s for a in kernel.arguments for s in a.entries]
        values = {s: sp.Rational(random.randint(500, 1500), 1000) for s in symbols}
        wanted = [e for o in kernel.outputs for e in o.entries]
        expected = [
            float(e.replace(Angle, lambda sine, cosine: sp.atan2(sine, cosine) % (2 * sp.pi)))
            for e in evaluate(kernel.stages, wanted, values, digits=30)
        ]
        given = [
            np.array([float(values[s]) for s in a.entries]).reshape(a.shape)
            for a in kernel.arguments
        ]
        found = python[f"hop_{kernel.name}"](*(a.tolist() for a in given), lib=FLOATS)
        arrays = [np.empty(o.shape) for o in kernel.outputs]
        library[f"ball_hop_{kernel.name}"](
            *(pointer(a) if a.shape else ctypes.c_double(a) for a in given), *map(pointer, arrays)
        )
        for results in (found if len(arrays) > 1 else [found], arrays):
            flat = np.concatenate([np.ravel(each) for each in results])
            np.testing.assert_allclose(flat, expected, rtol=1e-12, atol=1e-12, err_msg=kernel.name)


def test_symbols_of_one_name_are_told_apart_by_what_they_mean():
    x, by = sp.Symbol("x", real=True), sp.Symbol("y_2", real=True)
    meant = (
        Symbol("state", sp.Symbol("x_1_by_y", real=True), 2),
        derivative(Symbol("state", x, 1), by),
        derivative(sp.Symbol("x_1", real=True), by),
        sp.Symbol("x_1_by_y_2", real=True),
    )
    for a, b in permutations(meant, 2):
        assert a.name == b.name
        assert a != b
        assert a + b == b + a
        assert a.compare(b) == -b.compare(a) != 0
        assert sp.expand((a + b) ** 2) == a**2 + 2 * a * b + b**2
    for symbol in meant:
        assert pickle.loads(pickle.dumps(symbol)) - symbol == 0
