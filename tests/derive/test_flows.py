"""Flows: matrix exponentials in three arithmetics, with eigenvalues of every kind."""

from dataclasses import dataclass
from fractions import Fraction
from functools import cache

import flint
import mpmath
import numpy as np
import pytest
import sympy as sp

from nonsmooth.derive import (
    Configuration,
    DerivationError,
    FirstOrder,
    Harmonic,
    Parameter,
    SecondOrder,
    Slider,
    System,
    oscillator,
)
from nonsmooth.derive.codegen.kernels import flow_kernels, spectrum_kernel
from nonsmooth.derive.flows.modal import derive_flows
from nonsmooth.runtime.core.arithmetic import FLOATS, Balls, Mpmath
from nonsmooth.runtime.model.flows import flow_states
from nonsmooth.runtime.model.piecewise import piecewise
from tests.compiled_c import executed
from tests.one_mass import one_mass

DIGITS = 50
F = Fraction
TIMES = F(11, 4), F(-7, 5)


@dataclass(frozen=True)
class Case:
    """A system, whose first configuration is looked at, and the numbers of its parameters."""

    system: System
    values: tuple = ()


def moving(dynamics, states, *parameters):
    only = Configuration("only", dynamics, ())
    return System("case", "", sp.symbols(states, real=True), parameters, (only,))


def anywhere(names):
    return [Parameter(name, "", -sp.oo) for name in names.split()]


def masses(
    stiffness, load = (), mass = None, held = None, damping = None,
    numbers = None
):  # fmt: skip
    """Masses on springs, some of which are `held` at velocities."""
    size = len(stiffness)
    numbers = numbers or {}
    states = f"x1:{size + 1} v1:{size + 1}"
    kept = {sp.symbols(f"x{i + 1}", real=True): v for i, v in (held or {}).items()}
    dynamics = SecondOrder(mass or sp.eye(size), stiffness, load, damping, kept)
    return Case(moving(dynamics, states, *numbers), tuple(map(F, numbers.values())))


A, B, C, D, K, G = anywhere("a b c d k g")
POSITIVE, PULL = Parameter("s", ""), Parameter("q", "")
s, q, g = POSITIVE.symbol, PULL.symbol, G.symbol
SMALL = F(1, 10**9)


def of_any_sign(stiffness):
    return masses([[K.symbol]], [g], numbers={K: stiffness, G: 2})


def free(*values):
    """Two coordinates, every entry of the stiffness a parameter of any sign."""
    entries = [[A.symbol, B.symbol], [C.symbol, D.symbol]]
    return masses(
        entries, [g, 1], numbers=dict(zip((A, B, C, D, G), (*values, "0.7"), strict=True))
    )


CASES = {
    "spring": masses([[s]], [1], numbers={POSITIVE: F(7, 3)}),
    "spring of a mass": masses([[s]], [1], [[q]], numbers={POSITIVE: 2, PULL: "0.6"}),
    "no spring": masses([[0]], [g], numbers={G: "-1.5"}),
    **{f"spring {k}": of_any_sign(k) for k in (0, -2, SMALL)},
    "all held": masses([[3]], [1], held={0: 2}),
    "equal": masses([[2, 0], [0, 2]], [1, -1]),
    "equal and defective": masses([[2, 1], [0, 2]], [1, -1]),
    "nearly equal": masses([[2, 0], [0, 2 + sp.Rational(1, 10**9)]], [1, -1]),
    "nearly defective": masses([[2, 1], [sp.Rational(1, 10**18), 2]], [1, -1]),
    "negative": masses([[-1, "0.3"], ["0.2", -2]], [1, 2]),
    "complex": masses([[1, 2], [-3, 1]], [1, 2]),
    "one of each sign": masses([[1, 2], [3, 1]], [1, 2]),
    "nonsymmetric": masses([[3, 1], ["0.5", 2]], [1, 2]),
    "singular": masses([[1, -1], [-1, 1]], [1, 2]),
    "nilpotent": masses([[0, 1], [0, 0]], [1, 2]),
    "nothing but load": masses([[0, 0], [0, 0]], [1, 2]),
    "coupled masses": masses([[5, -1], [-1, 2]], [1, 2], [[2, 1], [1, 3]]),
    "free and equal": free(2, 0, 0, 2),
    "free and defective": free(2, 1, 0, 2),
    "free and nearly defective": free(2, 1, F(1, 10**18), 2),
    "free and complex": free(1, 2, -3, 1),
    "free and positive": free(3, 1, "0.5", 2),
    "free and zero": free(0, 0, 0, 0),
    "held without stiffness": masses([[0, 1], [2, 3]], [1, 2], held={1: "0.5"}),
    "first held": masses(
        [[5, -1], [-2, 2]], [1, 2], [[2, 1], [1, 3]], {0: q}, numbers={PULL: "0.75"}
    ),
    "held and singular": masses(
        [[1, -1, "0.5"], [-1, 1, 2], [0, 0, 1]], [1, 2, 3], held={2: "0.5"}
    ),
    "held and defective": masses([[1, 1, "0.5"], [0, 1, 2], [0, 0, 1]], [1, 2, 3], held={2: -1}),
    "three": masses([[3, -1, 0], [-1, 2, -1], [0, -1, s]], [1, 0, 2], numbers={POSITIVE: "2.5"}),
    "three and zero": masses([[1, -1, 0], [-1, 2, -1], [0, -1, 1]], [1, 0, 2]),
    "three equal": masses([[2, 0, 0], [0, 2, 0], [0, 0, 2]], [1, 0, 2]),
    "three and defective": masses([[2, 1, 0], [0, 2, 1], [0, 0, 2]], [1, 0, 2]),
    "three and negative": masses([[-1, 1, 0], [0, 2, 1], [0, 0, -3]], [1, 0, 2]),
    "three and complex": masses([[1, 2, 0], [-3, 1, 1], [0, 0, 2]], [1, 0, 2]),
}

ZETA, OMEGA = Parameter("zeta", "", closed=True), Parameter("Omega", "")
COUPLING = Parameter("kc", "")
z, w, k, kc = ZETA.symbol, OMEGA.symbol, K.symbol, COUPLING.symbol
CHAIN = [[2, -1, 0], [-1, 2, -1], [0, -1, 2]]
FIFTH = sp.CRootOf(sp.Symbol("q") ** 5 + sp.Symbol("q") - 1, 0)
DAMPED = {
    "forced": one_mass(
        "forced", stiffness=k, damping=2 * z, forces={w: 1}, load=[sp.sqrt(2)],
        parameters=[ZETA, OMEGA, K],
    ),
    "two frequencies": oscillator(
        "two", ["x"], [[sp.sqrt(3)]], [[sp.sqrt(sp.pi) + FIFTH]], [[z]],
        forcing=[Harmonic(w, cosine=[1]), Harmonic(sp.pi, sine=[1])],
    ),
    "slider": one_mass(
        "slider", Slider("x", 2, 1, name="jenkins"), damping=2 * z, forces={w: 1}
    ),
    "proportional": masses(
        [[1 + kc, -kc], [-kc, 1 + kc]], damping=[[2 * z, 0], [0, 2 * z]],
        numbers={ZETA: 0, COUPLING: 0},
    ).system,
    "not proportional": masses(
        [[2, -1], [-1, k]], [1, 2], damping=[[z, 0], [0, 0]], numbers={ZETA: 0, K: 0}
    ).system,
    "follower": masses(
        [[2, k], [-k, 2]], damping=[[z, 0], [0, z]], numbers={ZETA: 0, K: 0}
    ).system,
    "three": masses(CHAIN, damping=z * sp.Matrix(CHAIN), numbers={ZETA: 0}).system,
    "first order": moving(FirstOrder([[k, 1], [-1, 2]], [0, 1]), "a b", K),
}  # fmt: skip
POINTS = {
    "resonance": {"zeta": 0, "Omega": 1, "k": 1},
    "near resonance": {"zeta": 0, "Omega": 1 + SMALL, "k": 1},
    "critical": {"zeta": 1, "Omega": 2, "k": 1},
    "nearly critical": {"zeta": 1 + SMALL, "Omega": 2, "k": 1},
    "overdamped": {"zeta": 3, "Omega": F(1, 3), "k": 1},
    "no stiffness": {"zeta": F(1, 20), "Omega": 2, "k": 0},
    "repelling": {"zeta": F(1, 20), "Omega": 2, "k": -1},
}
MANY_DIGITS = CASES | {
    f"{name}, {point}": Case(
        system, tuple(F(POINTS[point].get(p.name, F(3, 7))) for p in system.parameters)
    )
    for name, system in DAMPED.items()
    for point in POINTS
    if name != "three" or point in ("critical", "resonance")
}


@cache
def derived(name):
    """Places of the spectrum's parameters; the emitted spectrum and first flow."""
    system = MANY_DIGITS[name].system
    spectrum, flows = derive_flows(system)
    names = [p.symbol for p in system.parameters]
    kernels = spectrum_kernel(spectrum), flow_kernels(system, spectrum, flows)[0]
    return [names.index(p) for p in spectrum.parameters], *map(executed, kernels)


@cache
def reference(name, time):
    """The flow as the exponential of the augmented matrix (A b; 0 0), at many digits."""
    case = MANY_DIGITS[name]
    system = case.system
    values = {
        p.symbol: sp.Rational(v.numerator, v.denominator)
        for p, v in zip(system.parameters, case.values, strict=True)
    }
    field = sp.Matrix.hstack(*system.configurations[0].dynamics.field(system.states))
    rows = field.col_join(sp.zeros(1, field.cols)).xreplace(values).tolist()
    with mpmath.workdps(110):
        numbers = [[mpmath.mpf(str(sp.N(e, 110))) for e in row] for row in rows]
        return mpmath.expm(mpmath.matrix(numbers) * time.numerator / time.denominator)


def numbers_of(name, number, lib):
    """Parameters of a case, and its spectrum."""
    own, spectrum, _ = derived(name)
    parameters = [number(v) for v in MANY_DIGITS[name].values]
    return parameters, spectrum([parameters[i] for i in own], lib=lib)[0]


def columns(name, number, t, lib):
    """Columns of Phi(t) and the offset, by the emitted source at unit states and at zero."""
    flow, point = derived(name)[-1], numbers_of(name, number, lib)
    size = len(MANY_DIGITS[name].system.states)
    *ends, offset = (
        flow(*point, number(t), [number(F(i == j)) for i in range(size)], lib=lib)
        for j in range(size + 1)
    )
    return [[a - b for a, b in zip(end, offset, strict=True)] for end in ends] + [offset]


@pytest.mark.parametrize("name", MANY_DIGITS)
def test_the_flow_is_a_matrix_exponential_in_fifty_digits(name):
    lib = Mpmath(DIGITS + 20)
    for t in TIMES:
        found = columns(name, lambda v: lib.mp.mpf(v.numerator) / v.denominator, t, lib)
        expected = reference(name, t)
        for j, column in enumerate(found):
            for i, entry in enumerate(column):
                difference = abs(entry - expected[i, j])
                assert difference < mpmath.mpf(10) ** -DIGITS * (1 + abs(expected[i, j]))


@pytest.mark.parametrize("name", CASES)
def test_the_flow_is_a_matrix_exponential_in_doubles(name):
    for t in TIMES:
        found = np.array(columns(name, float, t, FLOATS), dtype=float).T
        expected = np.array(reference(name, t).tolist(), dtype=float)[:-1]
        np.testing.assert_allclose(found, expected, rtol=0, atol=2e-14 * np.abs(expected).max())


@pytest.mark.parametrize("name", CASES)
def test_balls_enclose_the_matrix_exponential(name):
    lib = Balls()
    with lib.working(200):
        for t in (F(0), TIMES[0]):
            found = columns(name, lambda v: flint.arb(v.numerator) / v.denominator, t, lib)
            for j, column in enumerate(found):
                for i, entry in enumerate(map(flint.arb, column)):
                    exact = mpmath.nstr(reference(name, t)[i, j], 100)
                    assert entry.overlaps(flint.arb(exact, "1e-90"))
                    assert entry.rad() < 1e-35


@pytest.mark.parametrize(
    "name", ["spring", "no spring", "all held", "coupled masses", "first held", "nothing but load"]
)
def test_the_runtime_has_the_same_flow(name):
    system, values = CASES[name].system, map(float, CASES[name].values)
    point = piecewise(system, {p.name: v for p, v in zip(system.parameters, values, strict=True)})
    start = np.random.default_rng(2).normal(size=len(system.states))
    (found,) = flow_states(point, 0, np.array([float(TIMES[0])]), start)
    wanted = np.array(reference(name, TIMES[0]).tolist(), dtype=float)[:-1] @ [*start, 1]
    np.testing.assert_allclose(found, wanted, rtol=0, atol=2e-14 * np.abs(wanted).max())


def test_too_long_a_closed_form_is_refused_by_name():
    stiffness = sp.Matrix(4, 4, lambda i, j: 1 / sp.Integer(i + j + 1)) + sp.eye(4)
    case = masses(stiffness.tolist(), damping=sp.diag(1, 2, 3, 4).tolist())
    with pytest.raises(
        DerivationError, match=r"configuration 'only': its characteristic .* 8 roots"
    ):
        derive_flows(case.system)
