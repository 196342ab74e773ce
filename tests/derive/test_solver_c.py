"""The emitted solver has the same bits in every instruction set and however points are grouped."""

import ctypes
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from nonsmooth.derive import DerivationError, derive_equations
from nonsmooth.derive.codegen.solver import solve_source
from nonsmooth.derive.systems import rigid_stop
from nonsmooth.runtime.model.kernels import load_orbit
from tests.declared import random_points
from tests.places import CHECKOUT

ORBIT, FUNCTION = "dry-friction/global-stick", "dry_friction_global_stick_solve"
FOLDER = CHECKOUT / "generated"
FLAGS = [
    "-std=c99",
    "-ffp-contract=off",
    "-fno-math-errno",
    "-fno-trapping-math",
    "-shared",
    "-fPIC",
    "-lm",
]
VECTORS = ["-O3", "-fopenmp-simd", "-DNONSMOOTH_OPENMP_SIMD"]
BUILDS = {
    "plain": ["-O1", "-fno-tree-vectorize"],
    "baseline": VECTORS,
    "avx2": [*VECTORS, "-mavx2"],
    "avx512f": [*VECTORS, "-mavx512f"],
}
COUNT = 203  # no multiple of any number of lanes
compiler = shutil.which("gcc")
pytestmark = pytest.mark.skipif(compiler is None, reason="there is no GCC")


def flags_of_processor():
    try:
        return Path("/proc/cpuinfo").read_text(encoding="utf-8").split()
    except OSError:
        return []


@pytest.fixture(scope="module")
def source(tmp_path_factory):
    """The solver alone, without what chooses an instruction set at run time."""
    text = (FOLDER / "dry_friction.c").read_text(encoding="utf-8")
    parts = text.split("NONSMOOTH_MULTIVERSION\n")
    definition = next(part for part in parts if part.startswith(f"void {FUNCTION}("))
    file = tmp_path_factory.mktemp("solver") / "solver.c"
    names = ("dry_friction", "nonsmooth_compiler", "nonsmooth_trigonometry")
    includes = "#include <math.h>\n" + "".join(f'#include "{name}.h"\n' for name in names)
    file.write_text(includes + definition[: definition.index("\n}\n") + 3], encoding="utf-8")
    return file


def solver(source, build):
    if build.startswith("avx") and build not in flags_of_processor():
        pytest.skip(f"no {build} here")
    library = source.with_name(f"{build}.so")
    if not library.exists():
        command = [compiler, *BUILDS[build], "-I", FOLDER, source, "-o", library, *FLAGS]
        subprocess.run(command, check=True)
    return ctypes.CDLL(str(library))[FUNCTION]


def solve(function, parameters, guess):
    """Unknowns, trace and residual (8, count), iterations and statuses (2, count)."""
    count = parameters.shape[1]
    numbers, codes = np.empty((8, count)), np.empty((2, count), dtype=np.int32)
    given = [np.ascontiguousarray(a) for a in (parameters, guess)]
    arrays = [*given, numbers[:6], numbers[6], numbers[7], *codes]
    function(ctypes.c_ssize_t(count), *(ctypes.c_void_p(a.ctypes.data) for a in arrays))
    return numbers, codes


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
    return solve(solver(source, "plain"), *data)


@pytest.mark.slow
@pytest.mark.parametrize("build", BUILDS)
def test_every_instruction_set_gives_the_same_bits(source, data, expected, build):
    for found, wanted in zip(solve(solver(source, build), *data), expected, strict=True):
        assert_array_equal(found, wanted)


def test_every_status_is_met(expected):
    assert set(expected[1][1]) >= {0, 1, 2, 3}
    assert np.mean(expected[1][1] == 0) > 0.3


@pytest.mark.parametrize("size", [1, 3, 8, 16, 17, 64])
@pytest.mark.parametrize("build", ["baseline", "avx2", "avx512f"])
def test_a_point_has_the_same_bits_in_every_group(source, data, expected, build, size):
    function = solver(source, build)
    order = np.random.default_rng(size).permutation(COUNT)
    parts = [order[begin : begin + size] for begin in range(0, COUNT, size)]
    found = [solve(function, *(a[:, part] for a in data)) for part in parts]
    for arrays, wanted in zip(zip(*found, strict=True), expected, strict=True):
        assert_array_equal(np.concatenate(arrays, axis=1), wanted[:, order])


def test_a_symbol_that_the_solver_would_hide_is_refused(monkeypatch):
    orbit = derive_equations(rigid_stop.one_impact)
    assert "void rigid_stop_one_impact_solve(" in solve_source(orbit)
    monkeypatch.setattr("nonsmooth.derive.codegen.solver._OWN", "lane m1")
    with pytest.raises(DerivationError, match="'m1' of its own: rename it"):
        solve_source(orbit)
