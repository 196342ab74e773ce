"""Every emitted kernel of every system: the same numbers in every arithmetic, and in C."""

import random
import re
from fractions import Fraction
from importlib import import_module
from itertools import product
from math import prod

import flint
import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from nonsmooth.derive.systems import SYSTEMS
from nonsmooth.runtime.core.arithmetic import FLOATS, Balls, Mpmath
from nonsmooth.runtime.model.kernels import SystemKernels

MODULES = {name: import_module(f"nonsmooth.generated.{stem}") for name, stem in SYSTEMS.items()}
EVERY = [(system, kernel) for system, module in MODULES.items() for kernel in module.KERNELS]
every_kernel = pytest.mark.parametrize(
    ("system", "kernel"), EVERY, ids=[f"{s}-{k}" for s, k in EVERY]
)


def spectral(system, kernel):
    """Places of the spectrum's parameters among those of a kernel, of the system or an orbit."""
    table, orbits = MODULES[system].SYSTEM, MODULES[system].ORBITS
    owner = [t for o, t in orbits.items() if kernel.startswith(f"{o.replace('-', '_')}_")]
    names = [parameter["name"] for parameter in [*owner, table][0]["parameters"]]
    return [names.index(name) for name in table["spectrum_parameters"]]


def arguments_of(system, kernel, seed, number, lib):
    """Random arguments of a kernel in one arithmetic, which computes the spectrum itself."""
    module, (taken, _) = MODULES[system], MODULES[system].KERNELS[kernel]
    draw = random.Random(f"{kernel}{seed}")
    numbers = [
        [number(Fraction(draw.randint(300, 700), 1000)) for _ in range(prod(shape))]
        for shape, _ in taken
    ]
    if len(taken) > 1:
        chosen = [numbers[0][i] for i in spectral(system, kernel)]
        numbers[1], derivatives = module.spectrum(chosen, lib=lib)
        if any(since for _, since in taken):
            numbers[3] = derivatives
    return [n if shape else n[0] for n, (shape, _) in zip(numbers, taken, strict=True)]


def run(system, kernel, seed, number, lib, **wanted):
    """The first results of an emitted kernel in one arithmetic, flat."""
    given = arguments_of(system, kernel, seed, number, lib)
    found = getattr(MODULES[system], kernel)(*given, lib=lib, **wanted)
    return [e for value in outputs(found) for e in np.array(value, dtype=object).ravel()]


def outputs(found):
    return found if isinstance(found, tuple) else (found,)


def in_mpmath(lib):
    return lambda v: lib.mp.mpf(v.numerator) / v.denominator


@every_kernel
def test_floats_mpmath_and_balls_agree(system, kernel):
    lib, precise, balls = Mpmath(50), Mpmath(80), Balls()
    for seed in range(2):
        exact = run(system, kernel, seed, in_mpmath(precise), precise)
        middle = run(system, kernel, seed, in_mpmath(lib), lib)
        double = run(system, kernel, seed, float, FLOATS)
        scale = max(1, *(abs(e) for e in exact))
        for a, b, c in zip(exact, middle, double, strict=True):
            assert abs(a - b) <= scale * precise.mp.mpf(10) ** -45
            assert abs(a - float(c)) <= float(scale) * 1e-12
        with balls.working(200):
            enclosed = run(
                system, kernel, seed, lambda v: flint.arb(v.numerator) / v.denominator, balls
            )
            for a, ball in zip(exact, map(flint.arb, enclosed), strict=True):
                assert ball.overlaps(flint.arb(precise.mp.nstr(precise.mp.mpf(a), 78), "1e-70"))
                assert ball.rad() < 1e-40
    shapes = [shape for _, shape in MODULES[system].KERNELS[kernel][1]]
    for count in range(1, len(shapes)):
        first = run(system, kernel, 1, float, FLOATS, outputs=count)
        assert first == double[: sum(prod(shape) for shape in shapes[:count])]


# --- C ----------------------------------------------------------------------------------


def extension():
    return pytest.importorskip(
        "nonsmooth.generated._kernels", reason="the compiled kernels are not built"
    )


def built(system, kernel, count=None):
    """The compiled kernel that gives the first results, or all."""
    count = count or len(MODULES[system].KERNELS[kernel][1])
    return getattr(extension(), f"{SYSTEMS[system]}_{kernel}_{count}")


def arrays_for(system, kernel, count):
    """Arguments of a kernel for several points, stacked along the first axis."""
    points = (arguments_of(system, kernel, seed, float, FLOATS) for seed in range(count))
    return [np.array(column, dtype=float) for column in zip(*points, strict=True)]


def cores(function):
    """Shapes of one point's arguments and results."""
    return [
        [tuple(int(size) for size in core.split(",") if size) for core in found]
        for found in (re.findall(r"\((.*?)\)", side) for side in function.signature.split("->"))
    ]


@pytest.mark.compiled
@every_kernel
def test_compiled_kernels_are_the_numpy_ones(system, kernel):
    """Within 300 ulps of the largest entry: sine and cosine differ in the last bit."""
    arrays = arrays_for(system, kernel, 7)
    module = MODULES[system]
    taken, given = module.KERNELS[kernel]
    plain = outputs(SystemKernels(system, module, None).function(kernel)(*arrays))
    compiled = outputs(built(system, kernel)(*arrays))
    for a, b in zip(plain, compiled, strict=True):
        scale = max(1.0, float(np.max(np.abs(a), initial=0.0)))
        assert np.shape(a) == np.shape(b)
        assert_allclose(b, a, rtol=0, atol=300 * np.finfo(float).eps * scale)
    for count in range(1, len(given)):
        some = [array for array, (_, since) in zip(arrays, taken, strict=True) if since < count]
        first = built(system, kernel, count)(*some)
        for a, b in zip(outputs(first), compiled, strict=False):
            assert_array_equal(a, b)


@pytest.mark.compiled
@every_kernel
def test_compiled_kernels_broadcast_over_any_strides(system, kernel):
    function = built(system, kernel)
    taken, given = cores(function)
    arrays = arrays_for(system, kernel, 6)
    plain = outputs(function(*arrays))

    def strided(array):
        wide = np.full((2 * len(array), *array.shape[1:]), np.nan)
        wide[::2] = array
        return wide[::2]

    def backwards(array):
        return np.ascontiguousarray(array[::-1])[::-1]

    def columns(array):
        copy = np.asfortranarray(array)
        copy.setflags(write=False)
        return copy

    for placed in (strided, backwards, columns):
        for a, b in zip(plain, outputs(function(*map(placed, arrays))), strict=True):
            assert_array_equal(a, b)
    # a 3 x 2 grid, with the last argument the same along one axis
    grid = [a.reshape(3, 2, *core) for a, core in zip(arrays, taken, strict=True)]
    if len(grid) > 1:
        grid[-1] = grid[-1][:, :1]
    full = [
        np.broadcast_to(a, (3, 2, *core)).reshape(-1, *core)
        for a, core in zip(grid, taken, strict=True)
    ]
    for a, b in zip(outputs(function(*grid)), outputs(function(*full)), strict=True):
        assert_array_equal(a.reshape(b.shape), b)
    # no points at all
    for array, core in zip(outputs(function(*(a[:0] for a in arrays))), given, strict=True):
        assert array.shape == (0, *core)


def views(array):
    """Copies of an array, and arrays of its shape for results in the memory of each."""
    size = len(array)
    wide = np.zeros((4, 2 * size, *array.shape[1:]))
    same, strided, backwards, moved = wide[0, :size], wide[1, ::2], wide[2, :size], wide[3, :size]
    for copy in (same, strided, backwards, moved):
        copy[...] = array
    return {
        "itself": (same, same),
        "strided": (strided, strided),
        "backwards": (backwards, backwards[::-1]),
        "from the second on": (moved, wide[3, 1 : size + 1]),
    }


@pytest.mark.compiled
@pytest.mark.parametrize("system", SYSTEMS)
def test_results_may_lie_in_the_memory_of_arguments(system):
    drawn, seen = np.random.default_rng(1), set()
    for name, function in vars(extension()).items():
        if not name.startswith(f"{SYSTEMS[system]}_"):
            continue
        taken, given = cores(function)
        for argument, result in product(range(function.nin), range(function.nout)):
            core = taken[argument]
            one_for_all = core != () and core[1:] == given[result]
            if function.types[0].split("->")[1][result] != "d":
                continue
            if core != given[result] and not one_for_all:
                continue
            # where all points read one argument its rows are the results of the points
            points = core[0] if one_for_all else 150
            arrays = [drawn.uniform(0.5, 1.5, (points, *shape)) for shape in taken]
            memory = arrays[argument]
            if one_for_all:
                memory = memory[0]
                arrays[argument] = np.broadcast_to(memory, (points, *core))
            with np.errstate(all="ignore"):
                wanted = outputs(function(*arrays))[result]
                for label, (array, out) in views(memory).items():
                    arrays[argument] = array
                    where = [out if k == result else None for k in range(function.nout)]
                    function(*arrays, out=tuple(where))
                    assert_array_equal(out, wanted, f"{name} {label}")
                    seen.add(one_for_all)
    assert seen == {True, False}
