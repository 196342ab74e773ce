"""Emitted C of divided differences of the exponential: the exact values, each set computed once."""

import ctypes
from functools import cache

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from nonsmooth.derive.codegen.c import c_kernel
from nonsmooth.derive.equations.program import Array, Kernel
from nonsmooth.derive.flows.entire import ExponentialDifference
from nonsmooth.runtime.core.arithmetic import FLOATS
from tests.compiled_c import executed, library_of, needs_compiler
from tests.exponentials import UNIT, error, exact, forced, largest_root, periods, repeated
from tests.tables import slow

FLAGS = [
    *("-Wconversion", "-Wshadow", "-pedantic"),
    *("-fno-math-errno", "-fno-trapping-math", "-fopenmp-simd"),
]
# degrees of the factors; a zero is s, a w is s^2 + c
SHAPES = ["2", "20", "200", "2w", "w2", "1", "10", "000", "21", "22", "22w", "2ww", "202",
          "2002", "212", "211", "3", "4w", "6222", "66w2"]  # fmt: skip


def numbers_of(shape):
    symbols = []
    factors = []
    for place, kind in enumerate(shape):
        degree = {"0": 0, "w": 1}.get(kind) if kind in "0w" else int(kind)
        own = [sp.Symbol(f"c{place}_{j}", real=True) for j in range(degree or 0)]
        symbols += own
        factors.append(sp.Tuple(*own, *([0] if kind in "0w" else [])))
    return symbols, factors


@cache
def kernel_of(shape):
    symbols, factors = numbers_of(shape)
    t = sp.Symbol("T", real=True)
    degree = sum(len(f) for f in factors)
    results = [ExponentialDifference(k, t, *factors) for k in range(min(degree, 6))]
    given, found = Array.of("a", (t, *symbols)), Array.of("found", results)
    return Kernel(f"shape_{shape}", "Derivatives.", (given,), (found,), ())


def shape_of(factors):
    kinds = ["0" if f == (0.0,) else "w" if f[1:] == (0.0,) else str(len(f)) for f in factors]
    given = [
        c for f, kind in zip(factors, kinds, strict=True) for c in f[: len(f) - (kind in "0w")]
    ]
    return "".join(kinds), given


@pytest.fixture(scope="module")
def compiled(tmp_path_factory):
    folder = tmp_path_factory.mktemp("exponentials")
    sources = [c_kernel(kernel_of(shape), "probe", None) for shape in SHAPES]
    (folder / "probe.c").write_text("\n".join(['#include "nonsmooth_differences.h"', *sources]))
    library = library_of(folder / "probe.c", *FLAGS)

    def call(shape, t, coefficients):
        arguments = (ctypes.c_double * (1 + len(coefficients)))(t, *coefficients)
        (output,) = kernel_of(shape).outputs
        found = (ctypes.c_double * len(output.entries))()
        library[f"probe_shape_{shape}"](arguments, found)
        return list(found)

    return call


def worst(compiled, factors, t, k):
    shape, coefficients = shape_of(factors)
    if shape not in SHAPES:
        return 0.0
    found = compiled(shape, t, coefficients)
    k = min(k, len(found) - 1)
    return error(found[k], k, t, factors)


@needs_compiler
@settings(max_examples=60)
@given(
    st.one_of(st.tuples(forced(), st.just(1)), st.tuples(repeated(), st.just(3))),
    periods,
    st.integers(0, 3),
)
def test_any_set(compiled, drawn, count, k):
    """Within the bound of common sets, or three times that where factors nearly repeat."""
    factors, bound = drawn
    assert worst(compiled, factors, count * 6.283 / largest_root(factors), k) <= bound


@needs_compiler
def test_resonance_has_no_pole_and_the_slow_root_keeps_its_digits(compiled):
    for beside in (0.0, 1e-12, 1e-9, 1e-6, 1e-3, 0.05, -0.3):
        for damping in (0.0, 1e-6, 0.05):
            factors = [(1.0, 2 * damping), ((1 + beside) ** 2, 0.0)]
            for t in (0.0, 1e-9, 0.1, 1.1, 3.0, 40.0, 628.0):
                assert all(worst(compiled, factors, t, k) <= 1 for k in range(4))
    for damping in (1e3, 1e6):
        for t in (1e-6, 1.0, damping):
            for loads in range(3):
                wanted = float(exact(0, t, [(1.0, damping), *[(0.0,)] * loads]))
                found = compiled("2" + "0" * loads, t, [1.0, damping])
                assert found[0] == pytest.approx(wanted, rel=1e-13)


@needs_compiler
@pytest.mark.parametrize("shape", [*SHAPES[:-1], slow("66w2")])
def test_every_shape_is_numpy(compiled, shape):
    symbols, factors = numbers_of(shape)
    values = {symbol: 0.7 + 0.9 * place % 1.3 for place, symbol in enumerate(symbols)}
    chosen = [tuple(float(c.xreplace(values)) for c in f) for f in factors]
    degree = sum(map(len, chosen))
    for t in (0.0, 0.2, 1.7, 9.0):
        found = compiled(shape, t, [*values.values()])
        wanted = [
            float(FLOATS.exponential_difference(k, t, *chosen)) for k in range(min(degree, 6))
        ]
        scale = max(1e-300, max(map(abs, wanted)))
        bound = 1e-12 if max(map(len, chosen)) > 2 else 1e-13 + 8 * UNIT * t * 3
        assert max(abs(a - b) for a, b in zip(found, wanted, strict=True)) <= 10 * bound * scale


@needs_compiler
def test_hostile_numbers_end(compiled):
    for bad in (float("nan"), float("inf"), 1e300, -1e300, 5e-324, -1.0):
        for shape in SHAPES:
            count = len(numbers_of(shape)[0])
            compiled(shape, 1.0, [bad] * count)
            compiled(shape, bad, [1.0] * count)


def test_a_block_computes_each_set_once():
    source = c_kernel(kernel_of("2w"), "probe", None)
    assert source.count("nonsmooth_pair_wave(") == 1
    assert [f"derivatives_0.d{k}" in source for k in range(4)] == [True] * 4
    assert c_kernel(kernel_of("6222"), "probe", None).count("nonsmooth_any(") == 3  # k <= 3, 4, 5


def test_python_keeps_plain_integers():
    found = executed(kernel_of("20w"))([1.2, 2.0, 0.3, 5.0], lib=FLOATS)
    assert found[1] == FLOATS.exponential_difference(1, 1.2, (2.0, 0.3), (0,), (5.0, 0))
