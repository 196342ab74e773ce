"""The spectrum where eigenvalues have no closed form: three coordinates and more."""

import numpy as np
import pytest
import sympy as sp
from scipy.linalg import expm

from nonsmooth.derive import Boundary, Configuration, Parameter, SecondOrder, System
from nonsmooth.derive.codegen.any_arithmetic import python_kernel
from nonsmooth.derive.codegen.kernels import flow_kernels, spectrum_kernel
from nonsmooth.derive.flows.modal import derive_flows
from nonsmooth.runtime.core.arithmetic import FLOATS, Balls, Mpmath

K, M = Parameter("k", "a stiffness"), Parameter("m", "a mass")


@pytest.fixture(scope="module")
def chain():
    """Three masses in a chain, the first tied to the ground: kernels by name."""
    k, m = K.symbol, M.symbol
    stiffness = sp.Matrix([[1 + k, -k, 0], [-k, k + 2, -2], [0, -2, 2]])
    states = sp.symbols("x1:4 v1:4", real=True)
    configuration = Configuration(
        "free",
        SecondOrder(sp.diag(1, m, 2), stiffness, (1, 0, m)),
        (Boundary("stop", states[0] - 1),),
    )
    system = System("chain", "three masses", states, (K, M), (configuration,))
    spectrum, flows = derive_flows(system)
    kernels = (spectrum_kernel(spectrum), *flow_kernels(system, spectrum, flows))
    namespace: dict = {}
    for kernel in kernels:
        exec(python_kernel(kernel, None), namespace)
    return namespace, flows["free"]


def test_the_flow_with_a_numeric_spectrum_is_a_matrix_exponential(chain):
    namespace, flow = chain
    values = {K.symbol: 1.7, M.symbol: 0.6}
    spectrum, _ = namespace["spectrum"]([1.7, 0.6], lib=FLOATS)
    assert len(spectrum) == 3
    start = np.array([0.3, -0.2, 0.5, 1.0, -1.0, 0.2])
    end = namespace["flow_free"]([1.7, 0.6], spectrum, 2.3, start, lib=FLOATS)
    augmented = np.zeros((7, 7))
    augmented[:6, :6] = np.array(flow.field[0].subs(values), dtype=float)
    augmented[:6, 6] = np.array(flow.field[1].subs(values), dtype=float)[:, 0]
    expected = (expm(2.3 * augmented) @ np.append(start, 1))[:6]
    np.testing.assert_allclose(np.array(end, dtype=float), expected, atol=1e-12)


def test_eigenvalues_agree_in_all_arithmetics_and_broadcast(chain):
    namespace, _ = chain
    lib, balls = Mpmath(40), Balls()
    k = np.array([0.5, 1.7, 4.0])
    doubles, _ = namespace["spectrum"]([k, 0.625], lib=FLOATS)
    for column, value in enumerate(k):
        precise, _ = namespace["spectrum"]([lib.mp.mpf(value), lib.mp.mpf(0.625)], lib=lib)
        with balls.working(160):
            point = [balls.flint.arb(value), balls.flint.arb(0.625)]
            enclosed, _ = namespace["spectrum"](point, lib=balls)
        for float_row, digits, ball in zip(doubles, precise, enclosed, strict=True):
            assert float_row[column] == pytest.approx(float(digits), rel=1e-13)
            assert ball.overlaps(balls.flint.arb(lib.mp.nstr(digits, 38), "1e-35"))
            assert float(ball.rad()) < 1e-30


def test_derivatives_by_the_parameters_are_those_of_finite_differences(chain):
    namespace, _ = chain
    lib = Mpmath(60)
    point, step = [lib.mp.mpf("1.7"), lib.mp.mpf("0.6")], lib.mp.mpf(10) ** -20
    _, derivatives = namespace["spectrum"](point, lib=lib)
    for column in range(2):
        ends = []
        for sign in (-1, 1):
            moved = list(point)
            moved[column] += sign * step
            ends.append(namespace["spectrum"](moved, lib=lib)[0])
        for i, row in enumerate(derivatives):
            difference = (ends[1][i] - ends[0][i]) / (2 * step)
            assert abs(difference - row[column]) < lib.mp.mpf(10) ** -35


def test_complex_eigenvalues_come_in_pairs():
    matrix = [[0.0, -2.0, 0.0], [2.0, 0.0, 0.0], [0.0, 0.0, 5.0]]
    values = [FLOATS.eigenvalue(i, matrix) for i in range(3)]
    np.testing.assert_allclose(values, [-2j, 2j, 5])
    assert abs(Mpmath(30).eigenvalue(0, matrix) + 2j) < 1e-28
