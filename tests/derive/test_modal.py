"""Flows: laws, matrix exponentials in three arithmetics, and eigenvalues of every kind."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import Any

import flint
import mpmath
import numpy as np
import pytest
import scipy.linalg
import sympy as sp

from nonsmooth.derive import Configuration, Parameter, SecondOrder, System
from nonsmooth.derive.codegen.any_arithmetic import python_kernel
from nonsmooth.derive.codegen.kernels import flow_kernels, spectrum_kernel
from nonsmooth.derive.codegen.simulation_form import SimulationForm
from nonsmooth.derive.equations.program import Argument, Kernel, Output, Stage, differentiate
from nonsmooth.derive.flows.modal import TIME, Flow, Spectrum, derive_flows
from nonsmooth.derive.systems import dry_friction
from nonsmooth.runtime.core.arithmetic import FLOATS, Balls, Mpmath

DIGITS = 50
BITS = 200
SMALL = Fraction(1, 10**9)


def executed(kernel: Kernel) -> Callable[..., Any]:
    """The function that the emitted source of a kernel defines."""
    namespace: dict[str, Any] = {}
    exec(python_kernel(kernel, None), namespace)
    return namespace[kernel.name.replace("-", "_")]


def mp_number(mp: Any, value: Fraction) -> Any:
    return mp.mpf(value.numerator) / value.denominator


def arb_number(value: Fraction) -> Any:
    return flint.arb(value.numerator) / value.denominator


@dataclass(frozen=True)
class Case:
    """A configuration and the numbers of its parameters."""

    mass: Any
    stiffness: Any
    load: tuple[Any, ...] = ()
    held: dict[int, Any] | None = None
    parameters: tuple[Parameter, ...] = ()
    values: tuple[Fraction, ...] = ()

    @property
    def size(self) -> int:
        return len(self.mass)

    def system(self) -> System:
        n = self.size
        states = sp.symbols(f"x1:{n + 1} v1:{n + 1}", real=True)
        held = {states[i]: v for i, v in (self.held or {}).items()}
        dynamics = SecondOrder(self.mass, self.stiffness, self.load, held=held)
        only = Configuration("only", dynamics, ())
        return System("case", "", states, self.parameters, (only,))


def anywhere(name: str) -> Parameter:
    return Parameter(name, "", -sp.oo, sp.oo)


A, B, C, D, K, G = (anywhere(n) for n in ("a", "b", "c", "d", "k", "g"))
POSITIVE, PULL = Parameter("s", ""), Parameter("q", "")
FREE = [[A.symbol, B.symbol], [C.symbol, D.symbol]]
ONE, TWO, THREE = sp.eye(1).tolist(), sp.eye(2).tolist(), sp.eye(3).tolist()
F = Fraction


def free(*values: Any) -> Case:
    """Two coordinates, every entry of the stiffness a parameter of any sign."""
    loads = (G.symbol, 1)
    numbers = tuple(F(v) for v in (*values, "0.7"))
    return Case(TWO, FREE, loads, None, (A, B, C, D, G), numbers)


CASES = {
    "spring": Case(ONE, [[POSITIVE.symbol]], (1,), None, (POSITIVE,), (F(7, 3),)),
    "spring-of-a-mass": Case(
        [[PULL.symbol]], [[POSITIVE.symbol]], (1,), None, (POSITIVE, PULL), (F(2), F(3, 5))
    ),
    "no-spring": Case(ONE, [[0]], (G.symbol,), None, (G,), (F(-3, 2),)),
    "spring-of-any-sign-0": Case(ONE, [[K.symbol]], (G.symbol,), None, (K, G), (F(0), F(2))),
    "spring-of-any-sign-minus": Case(ONE, [[K.symbol]], (G.symbol,), None, (K, G), (F(-2), F(2))),
    "spring-of-any-sign-small": Case(ONE, [[K.symbol]], (G.symbol,), None, (K, G), (SMALL, F(2))),
    "all-held": Case(ONE, [[3]], (1,), {0: 2}),
    "equal": Case(TWO, [[2, 0], [0, 2]], (1, -1)),
    "equal-defective": Case(TWO, [[2, 1], [0, 2]], (1, -1)),
    "nearly-equal": Case(TWO, [[2, 0], [0, 2 + sp.Rational(1, 10**9)]], (1, -1)),
    "nearly-defective": Case(TWO, [[2, 1], [sp.Rational(1, 10**18), 2]], (1, -1)),
    "negative": Case(TWO, [[-1, "0.3"], ["0.2", -2]], (1, 2)),
    "complex": Case(TWO, [[1, 2], [-3, 1]], (1, 2)),
    "one-of-each-sign": Case(TWO, [[1, 2], [3, 1]], (1, 2)),
    "nonsymmetric": Case(TWO, [[3, 1], ["0.5", 2]], (1, 2)),
    "singular": Case(TWO, [[1, -1], [-1, 1]], (1, 2)),
    "nilpotent": Case(TWO, [[0, 1], [0, 0]], (1, 2)),
    "nothing-but-load": Case(TWO, [[0, 0], [0, 0]], (1, 2)),
    "coupled-masses": Case([[2, 1], [1, 3]], [[5, -1], [-1, 2]], (1, 2)),
    "free-equal": free(2, 0, 0, 2),
    "free-defective": free(2, 1, 0, 2),
    "free-nearly-defective": free(2, 1, Fraction(1, 10**18), 2),
    "free-complex": free(1, 2, -3, 1),
    "free-positive": free(3, 1, "0.5", 2),
    "free-zero": free(0, 0, 0, 0),
    "held-without-stiffness": Case(TWO, [[0, 1], [2, 3]], (1, 2), {1: "0.5"}),
    "held-first": Case(
        [[2, 1], [1, 3]], [[5, -1], [-2, 2]], (1, 2), {0: PULL.symbol}, (PULL,), (F(3, 4),)
    ),
    "held-singular": Case(
        THREE, [[1, -1, "0.5"], [-1, 1, 2], [0, 0, 1]], (1, 2, 3), {2: "0.5"}
    ),
    "held-defective": Case(THREE, [[1, 1, "0.5"], [0, 1, 2], [0, 0, 1]], (1, 2, 3), {2: -1}),
    "three": Case(
        THREE, [[3, -1, 0], [-1, 2, -1], [0, -1, POSITIVE.symbol]], (1, 0, 2), None,
        (POSITIVE,), (F(5, 2),),
    ),
    "three-zero": Case(THREE, [[1, -1, 0], [-1, 2, -1], [0, -1, 1]], (1, 0, 2)),
    "three-equal": Case(THREE, [[2, 0, 0], [0, 2, 0], [0, 0, 2]], (1, 0, 2)),
    "three-defective": Case(THREE, [[2, 1, 0], [0, 2, 1], [0, 0, 2]], (1, 0, 2)),
    "three-negative": Case(THREE, [[-1, 1, 0], [0, 2, 1], [0, 0, -3]], (1, 0, 2)),
    "three-complex": Case(THREE, [[1, 2, 0], [-3, 1, 1], [0, 0, 2]], (1, 0, 2)),
}  # fmt: skip


@cache
def derived(name: str) -> tuple[System, Spectrum, Flow, Callable[..., Any]]:
    system = CASES[name].system()
    spectrum, flows = derive_flows(system)
    (kernel,) = flow_kernels(system, spectrum, flows)
    return system, spectrum, flows["only"], executed(kernel)


def substitution(system: System, values: Sequence[Fraction]) -> dict[sp.Symbol, sp.Expr]:
    return {
        p.symbol: sp.Rational(v.numerator, v.denominator)
        for p, v in zip(system.parameters, values, strict=True)
    }


@cache
def spectral_numbers(name: str) -> list[Any]:
    """Spectrum at the case's parameters, from the declaration alone, at many digits."""
    system, spectrum, _, _ = derived(name)
    values: dict[sp.Symbol, Any] = dict(substitution(system, CASES[name].values))
    for symbol, expression in spectrum.entries:
        values[symbol] = expression.subs(values)
    numbers = {s: sp.N(values[s], 2 * DIGITS) for s, _ in spectrum.entries}
    return [numbers[s] for s in spectrum.symbols]


def mp_spectrum(name: str, mp: Any) -> list[Any]:
    return [
        mp.mpf(str(s)) if isinstance(s, sp.Expr) else mp.mpmathify(s)
        for s in spectral_numbers(name)
    ]


@cache
def reference(name: str, time: Fraction, dps: int = 110) -> Any:
    """The flow as the exponential of the augmented matrix (A b; 0 0), at many digits."""
    system, _, flow, _ = derived(name)
    size = len(system.states)
    values = substitution(system, CASES[name].values)
    matrix, offset = (m.subs(values) for m in flow.field)
    with mpmath.workdps(dps):
        augmented = mpmath.zeros(size + 1)
        for i in range(size):
            for j in range(size):
                augmented[i, j] = mpmath.mpf(matrix[i, j].p) / matrix[i, j].q
            augmented[i, size] = mpmath.mpf(offset[i].p) / offset[i].q
        return mpmath.expm(augmented * mp_number(mpmath, time))


def columns(
    name: str, number: Callable[[Fraction], Any], spectrum: list[Any], t: Fraction, lib: Any
) -> list[list[Any]]:
    """Columns of Phi(t) and the offset, by the emitted source at unit states and at zero."""
    system, _, _, function = derived(name)
    parameters = [number(v) for v in CASES[name].values]
    size = len(system.states)
    ends = []
    for column in range(size + 1):
        state = [number(F(int(i == column))) for i in range(size)]
        ends.append(list(function(parameters, spectrum, number(t), state, lib=lib)))
    offset = ends[size]
    return [[e - o for e, o in zip(end, offset, strict=True)] for end in ends[:size]] + [offset]


def mp_flow(name: str, t: Fraction, lib: Mpmath) -> Any:
    spectrum = mp_spectrum(name, lib.mp)
    found = columns(name, lambda v: mp_number(lib.mp, v), spectrum, t, lib)
    return lib.mp.matrix(found).T


@pytest.mark.parametrize("name", CASES)
def test_the_flow_is_a_matrix_exponential_in_fifty_digits(name: str) -> None:
    lib = Mpmath(DIGITS + 10)
    for t in (F(11, 4), F(-7, 5)):
        found, expected = mp_flow(name, t, lib), reference(name, t)
        size = expected.rows - 1
        for i in range(size):
            for j in range(size + 1):
                difference = abs(found[i, j] - expected[i, j])
                assert difference < mpmath.mpf(10) ** -DIGITS * (1 + abs(expected[i, j]))


@pytest.mark.parametrize("name", CASES)
def test_the_flow_is_a_matrix_exponential_in_doubles(name: str) -> None:
    spectrum = [float(mpmath.re(mpmath.mpmathify(s))) for s in spectral_numbers(name)]
    system, _, flow, _ = derived(name)
    values = substitution(system, CASES[name].values)
    matrix, offset = (np.array(m.subs(values), dtype=float) for m in flow.field)
    size = len(system.states)
    augmented = np.zeros((size + 1, size + 1))
    augmented[:size, :size], augmented[:size, size:] = matrix, offset
    for t in (F(11, 4), F(-7, 5)):
        found = np.array(columns(name, float, spectrum, t, FLOATS), dtype=float).T
        expected = np.array(reference(name, t).tolist(), dtype=float)[:size]
        scale = np.max(np.abs(expected))
        np.testing.assert_allclose(found, expected, rtol=0, atol=2e-14 * scale)
        np.testing.assert_allclose(
            scipy.linalg.expm(float(t) * augmented)[:size], expected, rtol=0, atol=1e-12 * scale
        )


@pytest.mark.parametrize("name", CASES)
def test_balls_enclose_the_matrix_exponential(name: str) -> None:
    system, spectrum, _, _ = derived(name)
    lib = Balls()
    with lib.working(BITS):
        parameters = [arb_number(v) for v in CASES[name].values]
        # only the parameters of the spectrum, in its order
        names = [p.name for p in system.parameters]
        needed = [parameters[names.index(str(s))] for s in spectrum.parameters]
        numbers = list(executed(spectrum_kernel(spectrum))(needed, lib=lib)[0])
        for t in (F(0), F(11, 4)):
            found, expected = columns(name, arb_number, numbers, t, lib), reference(name, t)
            for j, column in enumerate(found):
                for i, entry in enumerate(column):
                    ball = flint.arb(entry)
                    exact = flint.arb(mpmath.nstr(expected[i, j], 100), "1e-90")
                    assert ball.overlaps(exact)
                    assert ball.rad() < 1e-35


@pytest.mark.parametrize(
    "name", ["spring", "no-spring", "all-held", "coupled-masses", "held-first", "nothing-but-load"]
)
def test_the_modes_that_the_runtime_reads_are_the_flow(name: str) -> None:
    system, spectrum, flow, _ = derived(name)
    form = SimulationForm(system, spectrum, {"only": flow})
    (kernel,) = (k for k in form.kernels() if k.name == "modes")
    numbers = [float(mpmath.mpmathify(s)) for s in spectral_numbers(name)]
    given = [float(v) for v in CASES[name].values]
    exponents, coefficients = executed(kernel)(given, numbers, lib=FLOATS)
    for t in (F(11, 4), F(-7, 5)):
        functions = []
        modes = form.table()["modes"]["only"]
        for (_, frequency), mode in zip(exponents, modes, strict=True):
            waves = (np.cos, np.sin) if mode["oscillates"] else (np.cos,)
            for k in range(mode["length"]):
                functions += [float(t) ** k * wave(frequency * float(t)) for wave in waves]
        found = np.tensordot(
            functions, np.reshape(coefficients, (len(functions), len(flow.field[1]), -1)), 1
        )
        expected = np.array(reference(name, t).tolist(), dtype=float)[:-1]
        np.testing.assert_allclose(found, expected, rtol=0, atol=2e-14 * np.abs(expected).max())


# --- derivatives ----------------------------------------------------------------------------


def slope_of(mp: Any, function: Callable[[Any], Any], at: Any) -> Any:
    """Central difference of fourth order; its error is some 1e-36 for a smooth function."""
    h = mp.mpf(10) ** -9
    near, far = function(at + h) - function(at - h), function(at + 2 * h) - function(at - 2 * h)
    return (8 * near - far) / (12 * h)


@pytest.mark.parametrize(
    "name", ["free-equal", "free-defective", "free-complex", "free-positive", "free-zero"]
)
def test_total_derivatives_by_parameters_where_eigenvalues_meet(name: str) -> None:
    system, spectrum, flow, _ = derived(name)
    lib = Mpmath(60)
    mp = lib.mp
    end = flow.matrix() * sp.Matrix(system.states) + flow.offset()
    names = [sp.Symbol(f"{s}_end", real=True) for s in system.states]
    stages = [
        Stage("spectrum", spectrum.entries),
        Stage("end", tuple(zip(names, end, strict=True))),
    ]
    seeds = {p.symbol: {p.symbol: sp.Integer(1)} for p in system.parameters}
    more, moving = differentiate(stages, seeds)
    state = [mp.mpf(i * i - 2) / 3 for i in range(4)]
    time = mp.mpf("1.3")
    numbers = [mp_number(mp, v) for v in CASES[name].values]
    symbols = tuple(p.symbol for p in system.parameters)
    kernel = Kernel(
        "sensitivity", "",
        (Argument("inputs", (len(symbols) + 5,), (*symbols, TIME, *system.states)),),
        tuple(
            Output(f"by_{p}", (4,), tuple(sp.sympify(moving[p].get(n, 0)) for n in names))
            for p in symbols
        ),
        (*stages, *more),
    )  # fmt: skip
    found = executed(kernel)([*numbers, time, *state], lib=lib)

    def shot(values: list[Any]) -> Any:
        a, b, c, d, g = values
        matrix = mp.zeros(5)
        matrix[0, 2] = matrix[1, 3] = 1
        matrix[2, 0], matrix[2, 1], matrix[3, 0], matrix[3, 1] = -a, -b, -c, -d
        matrix[2, 4], matrix[3, 4] = g, 1
        return mp.expm(matrix * time) * mp.matrix([*state, 1])

    for place, column in enumerate(found):

        def along(x: Any, place: int = place) -> Any:
            return shot([x if j == place else v for j, v in enumerate(numbers)])[:4]

        slope = slope_of(mp, along, numbers[place])
        assert mp.mnorm(mp.matrix(column) - slope) < mp.mpf(10) ** -30


# --- names and refusals -----------------------------------------------------------------


@pytest.mark.parametrize(
    "names",
    [("omega1", "gap1"), ("p1", "omega2"), ("t1", "t0"), ("h0", "mean1"), ("x0", "lambda1")],
)
def test_parameters_may_have_the_names_of_the_spectrum(names: tuple[str, str]) -> None:
    first, second = Parameter(names[0], ""), Parameter(names[1], "")
    k, g = first.symbol, second.symbol
    states = sp.symbols("x y v w", real=True)
    dynamics = SecondOrder(sp.eye(2), [[2 * k, -k], [-k, 3 * k]], (g, 0))
    system = System("case", "", states, (first, second), (Configuration("only", dynamics, ()),))
    spectrum, flows = derive_flows(system)
    (kernel,) = flow_kernels(system, spectrum, flows)
    numbers, _ = executed(spectrum_kernel(spectrum))([1.7], lib=FLOATS)
    found = executed(kernel)([1.7, 0.6], numbers, 0.9, [1.0, 2.0, -1.0, 0.5], lib=FLOATS)
    matrix = np.zeros((5, 5))
    matrix[:2, 2:4] = np.eye(2)
    matrix[2:4, :2] = -1.7 * np.array([[2, -1], [-1, 3]])
    matrix[2, 4] = 0.6
    expected = scipy.linalg.expm(0.9 * matrix) @ [1.0, 2.0, -1.0, 0.5, 1.0]
    np.testing.assert_allclose(found, expected[:4], rtol=1e-13)


def test_equal_frequencies_of_two_configurations_share_a_symbol() -> None:
    spectrum, flows = derive_flows(dry_friction.system)
    assert len({e for _, e in spectrum.entries}) == len(spectrum.entries)
    assert flows["stick-slip"].matrices == flows["stick-overshoot"].matrices
