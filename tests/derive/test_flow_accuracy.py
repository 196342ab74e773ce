"""Derived flows in doubles, in Python and compiled: the digits of a 50-digit exponential.

The error is measured in units of 1e-13 + 8 u max|lambda| t, relative to the largest state up to t.
Where the flow is ill-conditioned the unit is larger by its condition: how far the state moves when
the parameters and the spectrum, on which the kernel depends, are each wrong by one relative unit,
compared to the 1 + max|lambda| t of a single mode. No method that takes these numbers in doubles
can do better. Two undamped coordinates of nearly equal frequencies that are not known to have
modes are such a case: their characteristic polynomial, rounded, moves the state by u (omega t)^2/8.
"""

import ctypes
import math
from dataclasses import dataclass
from functools import cache

import mpmath
import numpy as np
import pytest
import sympy as sp
from hypothesis import Phase, given, settings
from hypothesis import strategies as st

from nonsmooth.derive import (
    Configuration,
    FirstOrder,
    Harmonic,
    Parameter,
    Slider,
    System,
    oscillator,
)
from nonsmooth.derive.codegen.c import c_kernel
from nonsmooth.derive.codegen.kernels import flow_kernels, spectrum_kernel
from nonsmooth.derive.flows.modal import derive_flows
from nonsmooth.runtime.core.arithmetic import FLOATS, Mpmath
from tests.compiled_c import COMPILER, executed, library_of, pointer
from tests.tables import slow

UNIT, DIGITS = 2.0**-53, 50
property_test = settings(max_examples=8, phases=[Phase.generate])

BESIDE = st.sampled_from([0.0, 1e-12, -1e-9, 1e-9, 1e-7, -1e-5, 1e-4, -1e-4, 1e-2])
NEARLY_ONE = BESIDE.map(lambda x: 1 + x)
RATIO = NEARLY_ONE | st.sampled_from([0.0, 0.05, 2.5]) | st.floats(0, 3)
FREQUENCY = NEARLY_ONE | st.floats(0.3, 5.0)
STIFFNESS = st.sampled_from([1.0, 0.0, -0.1, 10.0]) | FREQUENCY
DAMPING = st.sampled_from([0.0, 0.0, 0.05, 2.0]) | st.floats(0.1, 1.0)
PERIODS = st.floats(0.0, 1.0) | st.floats(1.0, 100.0) | st.just(100.0)
STATES = st.lists(st.floats(0.1, 1) | st.floats(-1, -0.1), min_size=8, max_size=8)


def real(names):
    return [Parameter(name, "", -sp.oo).symbol for name in names.split()]


k, z, w0, Omega = real("k z w0 Omega")
k11, k12, k21, k22, d1, d2 = real("k11 k12 k21 k22 d1 d2")
k1, k2 = real("k1 k2")
entries = real("a11 a12 a13 a21 a22 a23 a31 a32 a33")


def masses(stiffness, damping, forced=False, **more):
    """Unit masses, a constant load, and a harmonic force on the first one."""
    size = sp.Matrix(stiffness).rows
    free = sp.Matrix(stiffness).free_symbols | sp.Matrix(damping).free_symbols
    free |= {Omega} if forced else set()
    return oscillator(
        "case",
        [f"x{i + 1}" for i in range(size)],
        sp.eye(size).tolist(),
        sp.Matrix(stiffness).tolist(),
        sp.Matrix(damping).tolist(),
        load=[1, -1, 2][:size],
        forcing=[Harmonic(Omega, cosine=[1, 0, 0][:size])] if forced else [],
        parameters=[Parameter(str(s), "", -sp.oo) for s in sorted(free, key=str)],
        **more,
    )


def field():
    dynamics = FirstOrder(sp.Matrix(3, 3, entries).tolist(), [0, 1, 2])
    parameters = tuple(Parameter(str(s), "", -sp.oo) for s in entries)
    only = Configuration("only", dynamics, ())
    return System("field", "", sp.symbols("a b c", real=True), parameters, (only,))


CHAIN = [[k1 + k2, -k2, 0], [-k2, k2 + 1, -1], [0, -1, 1]]
SYSTEMS = {
    "forced": lambda: masses([[w0**2 * k]], [[2 * z * w0]], forced=True),
    "slider": lambda: masses([[k]], [[2 * z]], True, elements=[Slider("x1", 2, 1, name="jenkins")]),
    "undamped": lambda: masses([[k11, k12], [k21, k22]], sp.zeros(2)),
    "two": lambda: masses([[k11, k12], [k21, k22]], [[d1, 0], [0, d2]], forced=True),
    "three undamped": lambda: masses(CHAIN, sp.zeros(3)),
    "three proportional": lambda: masses(CHAIN, z * sp.Matrix(CHAIN)),
    "three": lambda: masses(CHAIN, [[d1, -d1, 0], [-d1, d1, 0], [0, 0, 0]]),
    "field": field,
}


@dataclass(frozen=True)
class Case:
    """Kernels of one configuration, and its field."""

    parameters: tuple
    spectrum: tuple  # parameters that it depends on
    kernels: tuple
    run: tuple
    field: object

    def after(self, values, t, state, lib):
        numbers = [values[n] for n in self.parameters]
        spectrum, _ = self.run[0]([values[n] for n in self.spectrum], lib=lib)
        return self.run[1](numbers, spectrum, t, state, lib=lib)


@cache
def case(name):
    system = SYSTEMS[name]()
    spectrum, flows = derive_flows(system)
    first, flow = next(iter(flows.items()))
    kernels = (spectrum_kernel(spectrum), *flow_kernels(system, spectrum, {first: flow}))
    symbols = [p.symbol for p in system.parameters]
    return Case(
        tuple(map(str, symbols)),
        tuple(map(str, spectrum.parameters)),
        kernels,
        tuple(map(executed, kernels)),
        sp.lambdify(symbols, sp.Matrix.hstack(*flow.field).tolist(), "mpmath"),
    )


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    """The kernels of a system, compiled; None without a compiler."""

    @cache
    def compiled_kernels(name):
        if COMPILER is None:
            return None
        sources = [c_kernel(each, name.replace(" ", "_"), None) for each in case(name).kernels]
        file = tmp_path_factory.mktemp("flows") / "flows.c"
        file.write_text("\n".join(['#include "nonsmooth_differences.h"', *sources]))
        return library_of(file, "-O2")

    return compiled_kernels


def compiled(library, name, values, t, state):
    def function(kernel):
        return library[f"{name} {kernel.name}".replace(" ", "_").replace("-", "_")]

    known = case(name)
    first, second = known.kernels
    spectrum, derivatives = (np.zeros(len(o.entries)) for o in first.outputs)
    own, parameters = (
        np.array([values[n] for n in names]) for names in (known.spectrum, known.parameters)
    )
    function(first)(*map(pointer, (own, spectrum, derivatives)))
    begin, found = np.array(state), np.zeros(len(state))
    given = pointer(parameters), pointer(spectrum), ctypes.c_double(t), pointer(begin)
    function(second)(*given, pointer(found))
    return list(found)


def exact(augmented, t, state):
    """State after t, and the largest up to then."""
    steps = 8
    step = mpmath.expm(augmented * (mpmath.mpf(t) / steps))
    y = mpmath.matrix([*map(mpmath.mpf, state), 1])
    size = max(map(abs, y[: len(state)]))
    for _ in range(steps):
        y = step * y
        size = max(size, *map(abs, y[: len(state)]))
    return y[: len(state)], size


def condition(known, values, t, state):
    """How far the state moves when all numbers of the kernel are wrong by one relative unit."""
    lib = Mpmath(DIGITS)
    step = lib.mp.mpf(10) ** -20
    numbers = [lib.mp.mpf(values[n]) for n in known.parameters]
    spectrum, _ = known.run[0]([lib.mp.mpf(values[n]) for n in known.spectrum], lib=lib)
    inputs = [*numbers, *spectrum]

    def after(inputs):
        parameters, spectrum = inputs[: len(numbers)], inputs[len(numbers) :]
        return known.run[1](parameters, spectrum, lib.mp.mpf(t), [*map(lib.mp.mpf, state)], lib=lib)

    begin, total = after(inputs), [lib.mp.mpf(0)] * len(state)
    for place, number in enumerate(inputs):
        moved = after([*inputs[:place], number * (1 + step), *inputs[place + 1 :]])
        total = [s + abs(a - b) / step for s, a, b in zip(total, moved, begin, strict=True)]
    return mpmath.mpf(max(total))


def worst(
    library,
    name,
    values,
    periods,
    state,
):
    """Larger error of both flows, in its unit."""
    known = case(name)
    with mpmath.workdps(DIGITS + 10):
        rows = known.field(*(mpmath.mpf(values[n]) for n in known.parameters))
        state = state[: len(rows)]
        augmented = mpmath.matrix([*rows, [0] * (len(rows) + 1)])
        plain = np.array(augmented.tolist(), dtype=float)
        fastest = float(np.abs(np.linalg.eigvals(plain)).max()) or 1.0
        t = periods * 2 * math.pi / fastest
        wanted, size = exact(augmented, t, state)
        if size > mpmath.mpf(10) ** 200:
            return 0.0
        found = [known.after(values, t, state, FLOATS)]
        if library is not None:
            found.append(compiled(library, name, values, t, state))
        missed = max(
            abs(mpmath.mpf(float(a)) - b)
            for ends in found
            for a, b in zip(ends, wanted, strict=True)
        )
        unit = (1e-13 + 8 * UNIT * fastest * t) * size
        if missed > unit:
            unit *= max(1, condition(known, values, t, state) / size / (1 + fastest * t))
        return float(missed / unit)


# damping of every regime, forcing in and beside resonance; no stiffness, and negative
ONE = st.tuples(st.sampled_from([1.0, 1.0, 0.0, -1.0]), RATIO, FREQUENCY, FREQUENCY)
# frequencies that nearly meet, symmetric and circulatory coupling, any two dampers
COUPLING = st.sampled_from([0.0, 1e-9, 1e-5, 0.3, 1.0])
TWO = st.tuples(NEARLY_ONE, COUPLING, st.sampled_from([1, -1]), DAMPING, DAMPING, FREQUENCY).map(
    lambda x: dict(k11=1.0, k22=x[0], k12=x[1], k21=x[2] * x[1], d1=x[3], d2=x[4], Omega=x[5])
)
# no springs, repelling and equal ones; a chain that is free at one end, or both
THREE = st.fixed_dictionaries({"k1": STIFFNESS, "k2": STIFFNESS, "d1": DAMPING, "z": DAMPING})
# any matrix; equal and nearly equal rates, with and without a Jordan block
FIELD = st.lists(st.floats(-2, 2), min_size=9, max_size=9) | st.tuples(
    BESIDE, BESIDE, st.sampled_from([0.0, 1.0])
).map(lambda x: [-1.0, x[2], 0.0, 0.0, -1 - x[0], x[2], 0.0, 0.0, -1 - x[1]])
# how the numbers of a system are drawn; above the units that the worst of thousands missed
DRAWN = {
    "forced": (ONE.map(lambda x: dict(k=x[0], z=x[1], w0=x[2], Omega=x[2] * x[3])), 1),
    "slider": (ONE.map(lambda x: dict(k=x[0] * x[2] ** 2, z=x[1] * x[2], Omega=x[2] * x[3])), 1),
    **dict.fromkeys(("undamped", "two"), (TWO, 3)),
    **dict.fromkeys(("three undamped", "three proportional", "three"), (THREE, 5)),
    "field": (FIELD.map(lambda x: dict(zip(map(str, entries), x, strict=True))), 3),
}


@property_test
@given(st.data(), PERIODS, STATES)
@pytest.mark.parametrize("name", [n if n == "field" else slow(n) for n in SYSTEMS])
def test_the_error_of_a_flow_is_bounded(library, name, data, periods, state):
    numbers, most = DRAWN[name]
    assert worst(library(name), name, data.draw(numbers), periods, state) <= most
