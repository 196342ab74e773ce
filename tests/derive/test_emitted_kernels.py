"""Every emitted kernel of every system: the same numbers in every arithmetic, and in C."""

from __future__ import annotations

import random
import re
import shutil
import subprocess
from collections.abc import Callable
from fractions import Fraction
from functools import cache
from importlib import import_module
from itertools import product
from math import prod
from pathlib import Path
from types import ModuleType
from typing import Any

import flint
import numpy as np
import pytest
from numpy.testing import assert_array_equal

from nonsmooth.derive import Itinerary
from nonsmooth.derive.codegen.naming import python_function
from nonsmooth.derive.systems import SYSTEMS, declaration
from nonsmooth.runtime.core.arithmetic import FLOATS, Balls, Mpmath
from nonsmooth.runtime.core.values import parse
from nonsmooth.runtime.model.kernels import SystemKernels
from tests.places import CHECKOUT

GENERATED = CHECKOUT / "generated"
compiler = shutil.which("gcc") or shutil.which("cc")
needs_compiler = pytest.mark.skipif(compiler is None, reason="there is no C compiler")
FLAGS = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-fopenmp-simd", "-ffp-contract=off"]

MODULES = {name: import_module(f"nonsmooth.generated.{stem}") for name, stem in SYSTEMS.items()}
ORBITS = {f"{name}/{o.name}": o for name in SYSTEMS for o in declaration(name).orbits}
EVERY = [(system, kernel) for system, module in MODULES.items() for kernel in module.KERNELS]
every_kernel = pytest.mark.parametrize(
    ("system", "kernel"), EVERY, ids=[f"{s}-{k}" for s, k in EVERY]
)
PHYSICAL = {
    "rigid-stop": ("1", "2", "1", "5", "0.9"),
    "elastic-stop": ("1", "2", "1", "5", "1"),
    "dry-friction": ("0.5", "1", "1", "0.4", "3.4", "0.3", "0.8"),
}


def orbit_of(system: str, kernel: str) -> Itinerary | None:
    """The orbit that a kernel is of; None for one of the system."""
    for orbit in declaration(system).orbits:
        if kernel.startswith(python_function("", orbit.name)):
            return orbit
    return None


def is_flow(system: str, kernel: str) -> bool:
    """Of a configuration, in physical coordinates or in those of the orbit."""
    orbit = orbit_of(system, kernel)
    return kernel.startswith("flow_" if orbit is None else python_function("flow_", orbit.name))


def spectral(system: str, kernel: str) -> list[int]:
    """Places of the spectrum's parameters among those of a kernel."""
    table, orbit = MODULES[system].SYSTEM, orbit_of(system, kernel)
    tables = table["parameters"]
    if orbit is not None:
        tables = MODULES[system].ORBITS[orbit.name]["parameters"]
    names = [p["name"] for p in tables]
    return [names.index(n) for n in table["spectrum_parameters"]]


def point(system: str, kernel: str, seed: int) -> list[list[Fraction]]:
    """Arguments of a kernel at a random parameter point, each a flat list of decimals."""
    source = random.Random(f"{kernel}{seed}")

    def near(value: str) -> Fraction:
        return Fraction(value) * Fraction(source.randint(950, 1050), 1000)

    module, orbit = MODULES[system], orbit_of(system, kernel)
    physical = [near(v) for v in PHYSICAL[system]]
    if kernel == "spectrum":
        names = [p["name"] for p in module.SYSTEM["parameters"]]
        return [[physical[names.index(n)] for n in module.SYSTEM["spectrum_parameters"]]]
    parameters, known = physical, {}
    if orbit is not None:
        texts = {**orbit.reference.parameters, **orbit.reference.guess}
        known = {n: near(repr(float(parse(text)))) for n, text in texts.items()}
        table = module.ORBITS[orbit.name]
        parameters = [known[p["name"]] for p in table["parameters"]]
    if kernel in ("fields", "rows", "resets"):
        return [parameters]
    if kernel == "modes":
        return [parameters, []]
    if is_flow(system, kernel):
        state = [Fraction(source.randint(-30, 30), 10) for _ in range(4)]
        return [parameters, [], [Fraction(source.randint(1, 60), 10)], state]
    names = table["reduced" if kernel.endswith("_reduced") else "unknowns"]
    moved = [[]] if len(module.KERNELS[kernel][0]) == 4 else []
    unknowns = [[known[n] for n in names]] if names else []
    return [parameters, [], *unknowns, *moved]


def run(
    system: str,
    kernel: str,
    arguments: list[list[Fraction]],
    number: Callable[[Fraction], Any],
    lib: Any,
    count: int | None = None,
) -> list[Any]:
    """The first results of an emitted kernel in one arithmetic, flat; the spectrum is its own."""
    module = MODULES[system]
    given_shapes = [shape for shape, _ in module.KERNELS[kernel][0]]
    shapes = [shape for _, shape in module.KERNELS[kernel][1]][:count]
    numbers = [[number(v) for v in a] for a in arguments]
    if len(given_shapes) > 1:
        chosen = [numbers[0][i] for i in spectral(system, kernel)]
        numbers[1], derivatives = module.spectrum(chosen, lib=lib)
        if len(given_shapes) == 4 and not is_flow(system, kernel):
            numbers[3] = derivatives
    passed = [n if shape else n[0] for n, shape in zip(numbers, given_shapes, strict=True)]
    wanted = {} if count is None else {"outputs": count}
    found = getattr(module, kernel)(*passed, lib=lib, **wanted)
    flat = []
    for value, shape in zip(found if len(shapes) > 1 else (found,), shapes, strict=True):
        rows = [value] if not shape else value
        flat += [e for row in rows for e in row] if len(shape) == 2 else list(rows)
    return flat


def in_mpmath(lib: Mpmath) -> Callable[[Fraction], Any]:
    return lambda v: lib.mp.mpf(v.numerator) / v.denominator


@every_kernel
def test_floats_mpmath_and_balls_agree(system: str, kernel: str) -> None:
    lib, precise, balls = Mpmath(50), Mpmath(80), Balls()
    for seed in range(2):
        arguments = point(system, kernel, seed)
        exact = run(system, kernel, arguments, in_mpmath(precise), precise)
        middle = run(system, kernel, arguments, in_mpmath(lib), lib)
        double = run(system, kernel, arguments, float, FLOATS)
        scale = max(1, *(abs(e) for e in exact))
        for a, b, c in zip(exact, middle, double, strict=True):
            assert abs(a - b) <= scale * precise.mp.mpf(10) ** -45
            assert abs(a - float(c)) <= float(scale) * 1e-12
        with balls.working(200):
            enclosed = run(
                system, kernel, arguments, lambda v: flint.arb(v.numerator) / v.denominator, balls
            )
            for a, ball in zip(exact, enclosed, strict=True):
                ball = flint.arb(ball)
                assert ball.overlaps(flint.arb(precise.mp.nstr(precise.mp.mpf(a), 78), "1e-70"))
                assert ball.rad() < 1e-40


@every_kernel
def test_the_first_results_are_those_of_the_whole(system: str, kernel: str) -> None:
    shapes = [shape for _, shape in MODULES[system].KERNELS[kernel][1]]
    arguments = point(system, kernel, 3)
    whole = run(system, kernel, arguments, float, FLOATS)
    for count in range(1, len(shapes)):
        first = run(system, kernel, arguments, float, FLOATS, count)
        assert first == whole[: len(first)]
        assert len(first) == sum(prod(shape) for shape in shapes[:count])


# --- C ----------------------------------------------------------------------------------


def extension() -> ModuleType:
    return pytest.importorskip(
        "nonsmooth.generated._kernels", reason="the compiled kernels are not built"
    )


def built(system: str, kernel: str, count: int | None = None) -> Callable[..., Any]:
    """The compiled kernel that gives the first results, or all."""
    count = count or len(MODULES[system].KERNELS[kernel][1])
    return getattr(extension(), f"{SYSTEMS[system]}_{kernel}_{count}")


def arrays_for(system: str, kernel: str, count: int) -> list[np.ndarray]:
    """Arguments of a kernel for several points, stacked along the first axis."""
    module, stacked = MODULES[system], []
    for seed in range(count):
        arguments: list[Any] = [[float(v) for v in a] for a in point(system, kernel, seed)]
        if len(arguments) > 1:
            chosen = [arguments[0][i] for i in spectral(system, kernel)]
            spectrum, derivatives = module.spectrum(chosen, lib=FLOATS)
            arguments[1] = [float(s) for s in spectrum]
            if len(arguments) == 4 and not is_flow(system, kernel):
                arguments[3] = np.array(derivatives, dtype=float)
        shapes = [shape for shape, _ in module.KERNELS[kernel][0]]
        stacked.append([np.reshape(a, shape) for a, shape in zip(arguments, shapes, strict=True)])
    return [np.stack(column) for column in zip(*stacked, strict=True)]


def outputs(found: Any) -> list[np.ndarray]:
    return list(found) if isinstance(found, tuple) else [np.asarray(found)]


def close_in_ulps(plain: np.ndarray, compiled: np.ndarray) -> None:
    """Equal within 300 ulps of the largest entry: sine and cosine differ in the last bit."""
    assert plain.shape == compiled.shape
    scale = max(1.0, float(np.max(np.abs(plain), initial=0.0)))
    error = float(np.max(np.abs(plain - compiled), initial=0.0))
    assert error <= 300 * np.finfo(float).eps * scale


@pytest.mark.compiled
@every_kernel
def test_compiled_kernels_are_the_numpy_ones(system: str, kernel: str) -> None:
    arrays = arrays_for(system, kernel, 7)
    module = MODULES[system]
    shapes = [shape for _, shape in module.KERNELS[kernel][1]]
    plain = SystemKernels(system, module, None).function(kernel)(*arrays)
    compiled = outputs(built(system, kernel)(*arrays))
    for a, b in zip(outputs(plain), compiled, strict=True):
        close_in_ulps(a, b)
    for count in range(1, len(shapes)):
        taken = [since < count for _, since in module.KERNELS[kernel][0]]
        first = built(system, kernel, count)(*(a for a, t in zip(arrays, taken, strict=True) if t))
        for a, b in zip(outputs(first), compiled, strict=False):
            assert_array_equal(a, b)


@pytest.mark.compiled
@every_kernel
def test_compiled_kernels_broadcast_over_any_strides(system: str, kernel: str) -> None:
    function = built(system, kernel)
    shapes = [[s for s, _ in arrays] for arrays in MODULES[system].KERNELS[kernel][:1]]
    shapes += [[s for _, s in MODULES[system].KERNELS[kernel][1]]]
    arrays = arrays_for(system, kernel, 6)
    plain = function(*arrays)
    # every second of a longer array, backwards in memory, in Fortran order, and read-only
    strided, reversed_, fortran = [], [], []
    for array in arrays:
        wide = np.full((2 * len(array), *array.shape[1:]), np.nan)
        wide[::2] = array
        strided.append(wide[::2])
        reversed_.append(np.ascontiguousarray(array[::-1])[::-1])
        copy = np.asfortranarray(array)
        copy.setflags(write=False)
        fortran.append(copy)
    for other in (strided, reversed_, fortran):
        for a, b in zip(outputs(plain), outputs(function(*other)), strict=True):
            assert_array_equal(a, b)
    # a 3 x 2 grid, with the last argument the same along one axis
    grid = [a.reshape(3, 2, *a.shape[1:]) for a in arrays]
    if len(grid) > 1:
        grid[-1] = grid[-1][:, :1]
    wanted = np.broadcast_shapes(
        *(a.shape[: a.ndim - len(s)] for a, s in zip(grid, shapes[0], strict=True))
    )
    full = [
        np.broadcast_to(a, (*wanted, *s)).reshape(-1, *s)
        for a, s in zip(grid, shapes[0], strict=True)
    ]
    for a, b in zip(outputs(function(*grid)), outputs(function(*full)), strict=True):
        assert_array_equal(a.reshape(b.shape), b)
    # no points at all
    empty = outputs(function(*(a[:0] for a in arrays)))
    for array, shape in zip(empty, shapes[1], strict=True):
        assert array.shape == (0, *shape)


def views(array: np.ndarray) -> dict[str, tuple[np.ndarray, np.ndarray]]:
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


def cores(function: np.ufunc) -> list[list[tuple[int, ...]]]:
    """Shapes of one point's arguments and results."""
    return [
        [tuple(int(size) for size in core.split(",") if size) for core in found]
        for found in (re.findall(r"\((.*?)\)", side) for side in function.signature.split("->"))
    ]


@pytest.mark.compiled
@pytest.mark.parametrize("system", SYSTEMS)
def test_results_may_lie_in_the_memory_of_arguments(system: str) -> None:
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


@pytest.mark.compiled
@pytest.mark.parametrize("system", SYSTEMS)
def test_the_extension_is_of_this_derivation_and_holds_every_kernel(system: str) -> None:
    names, stem = dir(extension()), SYSTEMS[system]
    assert getattr(extension(), f"derivation_{stem}") == MODULES[system].DERIVATION
    assert {f"{stem}_{k}_1" for k in MODULES[system].KERNELS} <= set(names)
    for orbit in MODULES[system].ORBITS:
        for kernel in ("solve", "admissible"):
            assert f"{stem}_{python_function(kernel, orbit)}" in names


@cache
def _library(system: str, folder: Path) -> Path:
    stem = SYSTEMS[system]
    target = folder / f"{stem}.o"
    # the compiler warns of more where it optimises, which takes long where much is emitted
    level = "-O1" if system == "rigid-stop" else "-O0"
    command = [compiler, *FLAGS, level, "-c", str(GENERATED / f"{stem}.c"), "-o", str(target)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return target


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Path]:
    """The emitted C of a system, compiled as strict C99 without one warning."""
    folder = tmp_path_factory.mktemp("c")
    return lambda system: _library(system, folder)


@needs_compiler
@pytest.mark.skipif(shutil.which("nm") is None, reason="there is no nm")
@pytest.mark.parametrize("system", ["rigid-stop", "dry-friction"])
def test_public_c_symbols_have_the_name_of_their_system(
    system: str, library: Callable[[str], Path]
) -> None:
    stem = SYSTEMS[system]
    listing = subprocess.run(
        ["nm", "-g", "--defined-only", str(library(system))],
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    # clones for several processors carry a suffix; a resolver has the name itself
    symbols = {line.split()[-1] for line in listing.splitlines() if line}
    assert {s for s in symbols if not s.startswith((f"{stem}_", "nonsmooth_"))} == set()
    header = (GENERATED / f"{stem}.h").read_text(encoding="utf-8")
    declared = set(re.findall(r"^void (\w+)\(", header, re.MULTILINE))
    assert declared == {s.partition(".")[0] for s in symbols}
    assert {f"{stem}_{k}" for k in MODULES[system].KERNELS} <= declared


@pytest.mark.skipif(shutil.which("g++") is None, reason="there is no g++")
def test_the_headers_are_cplusplus_too_and_go_together() -> None:
    names = 2 * [f"{stem}.h" for stem in SYSTEMS.values()]
    text = "".join(f'#include "{name}"\n' for name in names) + "int main() { return 0; }\n"
    done = subprocess.run(
        ["g++", "-x", "c++", "-std=c++11", "-Wall", "-Wextra", "-Werror", "-pedantic",
         "-fsyntax-only", f"-I{GENERATED}", "-"],
        input=text, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
