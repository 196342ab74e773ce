"""Symbols carry their meaning: no name of a declaration is taken for one of the derivation."""

import copy
import pickle
from itertools import combinations

import pytest
import sympy as sp

from nonsmooth.derive import (
    Boundary,
    Configuration,
    DerivationError,
    EquationSystem,
    FirstOrder,
    Itinerary,
    Parameter,
    Phase,
    System,
    Transition,
    derive_equations,
)
from nonsmooth.derive.codegen.any_arithmetic import python_kernel
from nonsmooth.derive.codegen.kernels import orbit_kernels
from nonsmooth.derive.document.describe import describe_orbit
from nonsmooth.derive.document.hypertext import to_markdown
from nonsmooth.derive.document.views.view import naming_of
from nonsmooth.derive.symbols import Symbol, derivative

X = sp.Symbol("x", real=True)


def hopping(position: str, velocity: str, place: str, push: str, dwell: str) -> EquationSystem:
    """A ball that falls onto a place and is thrown back, faster by a push."""
    x, v = sp.symbols([position, velocity], real=True)
    parameters = tuple(Parameter(name, "", lower=-sp.oo) for name in (place, push))
    ground, faster = (p.symbol for p in parameters)
    field = FirstOrder(sp.Matrix([[0, 1], [-1, 0]]), sp.Matrix([0, -1]))
    air = Configuration("air", field, (Boundary("lands", ground - x),))
    back = Transition("air", frozenset({"lands"}), "air", (), {v: -v / 2 + faster})
    ball = System("ball", "", (x, v), parameters, (air,), (back,))
    hop = Itinerary("hop", ball, (Phase("air", "lands", dwell),), start={velocity: f"{velocity}0"})
    return derive_equations(hop)


PLAIN = hopping("x", "v", "a", "b", "tau")
NAMES = {
    "a parameter as a state behind a phase": ("x", "v", "x_1", "v_1_reset", "tau"),
    "a parameter as a function of time": ("x", "v", "cos_tau", "half_tau", "tau"),
    "a parameter as a spectral one": ("x", "v", "omega1", "factor1", "tau"),
    "a parameter as a derivative": ("x", "v", "x_1_by_tau", "v_1_by_v0", "tau"),
    "a parameter of linear equations": ("x", "v", "determinant", "coefficient11", "tau"),
    "a parameter of the first return": ("x", "v", "rate_tau", "amplitude_tau", "tau"),
    "a parameter with a coefficient": ("x", "v", "x_times_v", "v0_slope", "tau"),
    "a state behind a phase": ("x_1", "x", "a", "b", "tau"),
    "a state behind a transition": ("x_1_reset", "x", "a", "b", "tau"),
    "a derivative": ("x_by_tau", "x", "a", "b", "tau"),
    "what a flow carries": ("carried_x", "x", "a", "b", "tau"),
    "what is on a boundary": ("x_1_on_boundary", "x", "a", "b", "tau"),
    "a time of delay": ("x", "v", "delay_tau", "b", "tau"),
    "a dwell time": ("x", "v", "a", "b", "half_x_1"),
}


@pytest.mark.parametrize("names", NAMES.values(), ids=NAMES)
def test_equations_do_not_depend_on_what_the_user_calls_things(names: tuple[str, ...]) -> None:
    equations = hopping(*names)
    mine, theirs = (
        (*e.system.states, *(p.symbol for p in e.system.parameters), *e.unknowns)
        for e in (PLAIN, equations)
    )
    renamed = dict(zip(theirs, mine, strict=True))
    for quantity in ("residual", "jacobian", "map"):
        found = sp.Matrix(equations.expand(quantity)).xreplace(renamed)
        difference = (found - sp.Matrix(PLAIN.expand(quantity))).applyfunc(sp.expand)
        assert difference.is_zero_matrix, quantity


@pytest.mark.parametrize("names", NAMES.values(), ids=NAMES)
def test_different_symbols_are_written_differently(names: tuple[str, ...]) -> None:
    equations = hopping(*names)
    notation = naming_of(equations).notation
    declared = (*equations.system.states, *(p.symbol for p in equations.system.parameters))
    stages = (*equations.stages_of("jacobian"), *equations.stages_of("map"))
    made = {s for stage in stages for s, _ in stage.assignments} - {*notation.functions}
    symbols = {*declared, *equations.unknowns, *made}
    assert len({notation.symbol(s) for s in symbols}) == len(symbols)
    assert to_markdown(describe_orbit(equations)).count(notation.symbol(declared[2])) > 1


def test_a_kernel_refuses_two_symbols_with_one_name() -> None:
    kernel, *_ = orbit_kernels(hopping(*NAMES["a parameter as a state behind a phase"]))
    with pytest.raises(DerivationError, match="the name 'v_1_reset' is taken; rename it"):
        python_kernel(kernel, "hop")


def test_a_symbol_is_what_it_means() -> None:
    """With one name a state, its derivative and a symbol of a declaration are three."""
    meant = (
        Symbol("state", sp.Symbol("x_1_by_y", real=True), 2),
        derivative(Symbol("state", X, 1), sp.Symbol("y_2", real=True)),
        sp.Symbol("x_1_by_y_2", real=True),
    )
    assert len({s.name for s in meant}) == 1
    assert len({*meant}) == 3
    assert all(a != b and b != a and sp.expand(a - b) != 0 for a, b in combinations(meant, 2))
    for symbol in meant:
        for same in (copy.deepcopy(symbol), pickle.loads(pickle.dumps(symbol))):
            assert same == symbol
            assert hash(same) == hash(symbol)
            assert (same - symbol) == 0


def test_symbols_of_one_name_add_and_multiply_as_others_do() -> None:
    state, declared = Symbol("state", sp.Symbol("x", real=True), 1), sp.Symbol("x_1", real=True)
    pairs = (
        (state, declared),
        (state, Symbol("written", "x_1", "y")),
        (derivative(state, X), derivative(declared, X)),
        (derivative(X, state), derivative(X, declared)),
    )
    for made, other in pairs:
        assert made.compare(other) == -other.compare(made) != 0
        assert made + other == other + made
        assert made * other - other * made == 0
        square = made**2 + 2 * made * other + other**2
        assert sp.expand((made + other) ** 2 - square) == 0


def test_terms_have_the_order_that_names_give_them() -> None:
    made, declared = Symbol("state", X, 1), sp.Symbol("x_1", real=True)
    y = sp.Symbol("w", real=True)
    for symbol in (made, declared):
        assert str(2 + symbol * y + symbol) == "w*x_1 + x_1 + 2"
        assert (y + symbol).args == (y, symbol)
