"""The emitted solver and derivatives of many points have the same bits in every instruction set.

So they have however points are grouped.
"""

import ctypes
import re
import shutil
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from nonsmooth.derive.codegen.emit import emit_library
from nonsmooth.runtime.model.kernels import load_orbit
from tests.compiled_c import library_of, needs_compiler, pointer
from tests.declared import random_points, rigid_stop
from tests.places import CHECKOUT
from tests.tables import slow

ORBIT = "dry-friction/global-stick"
SOLVE, DIRECTIONS = (f"dry_friction_global_stick_{kind}" for kind in ("solve", "directions"))
FOLDER = CHECKOUT / "generated"
VECTORS = ["-O3", "-fopenmp-simd", "-DNONSMOOTH_OPENMP_SIMD"]
BUILDS = {
    "plain": ["-O1", "-fno-tree-vectorize"],
    "baseline": VECTORS,
    "avx2": [*VECTORS, "-mavx2"],
    "avx512f": [*VECTORS, "-mavx512f"],
}
COUNT = 203  # no multiple of any number of lanes
pytestmark = needs_compiler


def flags_of_processor():
    try:
        return Path("/proc/cpuinfo").read_text(encoding="utf-8").split()
    except OSError:
        return []


@pytest.fixture(scope="module")
def source(tmp_path_factory):
    """The solver and the derivatives alone, without what chooses an instruction set at run time."""
    text = (FOLDER / "dry_friction.c").read_text(encoding="utf-8")
    head, *definitions = re.split(r"\n\n(?=/\* )", text.replace("NONSMOOTH_MULTIVERSION\n", ""))
    called = re.compile(rf"void ({SOLVE}|{DIRECTIONS}|\w+_in_lane)\(")
    file = tmp_path_factory.mktemp("solver") / "solver.c"
    file.write_text("\n\n".join([head, *filter(called.search, definitions), ""]), encoding="utf-8")
    return file


@cache
def compiled(source, build):
    if build.startswith("avx") and build not in flags_of_processor():
        pytest.skip(f"no {build} here")
    file = source.with_name(f"{build}.c")
    shutil.copy(source, file)
    flags = ("-fno-math-errno", "-fno-trapping-math", "-Wno-unused-function")
    return library_of(file, *BUILDS[build], *flags, include=FOLDER)


def solve(library, parameters, guess):
    """Unknowns, trace and residual (8, count), iterations and statuses (2, count)."""
    count = parameters.shape[1]
    numbers, codes = np.empty((8, count)), np.empty((2, count), dtype=np.int32)
    given = [np.ascontiguousarray(a) for a in (parameters, guess)]
    arrays = [*given, numbers[:6], numbers[6], numbers[7], *codes]
    call(library[SOLVE], count, arrays)
    return numbers, codes


def directions(library, parameters, unknowns):
    """Derivatives of unknowns and trace, (7, 5, count)."""
    found = np.empty((7, 5, parameters.shape[1]))
    arrays = [np.ascontiguousarray(a) for a in (parameters, unknowns)]
    call(library[DIRECTIONS], parameters.shape[1], [*arrays, found])
    return found


def call(function, count, arrays):
    function(ctypes.c_ssize_t(count), *map(pointer, arrays))


@pytest.fixture(scope="module")
def data():
    """Points near and far, some of them hopeless, and starts that are good, poor and wrong."""
    generator = np.random.default_rng(11)
    points = random_points(ORBIT, 3, COUNT)
    parameters = np.array([points[name] for name in load_orbit(ORBIT).parameter_names])
    parameters[:, :60] = parameters[:, 60:61]
    parameters[1, 5::17] = np.nan
    guess = np.array([[2.0], [1.57]]) * generator.uniform(0.1, 3, (2, COUNT))
    guess[:, ::2] = [[2.0], [1.57]]
    guess[0, 7::29] = 1e6
    return parameters, guess


@pytest.fixture(scope="module")
def expected(source, data):
    return solve(compiled(source, "plain"), *data)


@pytest.fixture(scope="module")
def expected_directions(source, data, expected):
    return directions(compiled(source, "plain"), data[0], expected[0][:6])


def test_every_status_is_met(expected, expected_directions):
    assert set(expected[1][1]) >= {0, 1, 2, 3}
    solved = expected[1][1] == 0
    assert np.mean(solved) > 0.3
    assert np.all(np.isfinite(expected_directions[..., solved]))


@pytest.mark.parametrize("size", [1, 3, 8, 16, 17, 64])
@pytest.mark.parametrize("build", ["baseline", *(slow(b) for b in ("avx2", "avx512f"))])
def test_a_point_has_the_same_bits_in_every_group(
    source, data, expected, expected_directions, build, size
):
    library = compiled(source, build)
    order = np.random.default_rng(size).permutation(COUNT)
    parts = [order[begin : begin + size] for begin in range(0, COUNT, size)]
    found = [solve(library, *(a[:, part] for a in data)) for part in parts]
    for arrays, wanted in zip(zip(*found, strict=True), expected, strict=True):
        assert_array_equal(np.concatenate(arrays, axis=1), wanted[:, order])
    given = data[0], expected[0][:6]
    moved = [directions(library, *(a[:, part] for a in given)) for part in parts]
    assert_array_equal(np.concatenate(moved, axis=2), expected_directions[..., order])


def test_derivatives_of_too_many_numbers_are_refused(monkeypatch):
    monkeypatch.setattr("nonsmooth.derive.codegen.solver.MOST_NUMBERS", 60)
    header = emit_library(rigid_stop.system, rigid_stop.orbits, "tests")["rigid_stop.h"]
    said = r"no rigid_stop_one_impact_directions: .* 'one-impact' take \d+ numbers for each point"
    assert re.search(said, re.sub(r"\s+(\* )?", " ", header))
