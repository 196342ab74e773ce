"""The engine outside Python, under AddressSanitizer and UndefinedBehaviorSanitizer."""

import shutil
import subprocess

import numpy as np
import pytest

from nonsmooth.runtime.model.engine_layout import layout_of, numbers_of
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.simulation.simulate import follow
from nonsmooth.runtime.simulation.starting import configuration_of
from tests.engines import with_engine
from tests.large_systems import chain, masses_apart
from tests.places import CHECKOUT
from tests.two_masses import SYSTEMS

compiler = shutil.which("cc")
absent = pytest.mark.skipif(compiler is None, reason="no C compiler")
pytestmark = [absent, pytest.mark.compiled, pytest.mark.slow]


@pytest.fixture(scope="module")
def harness(tmp_path_factory):
    program = tmp_path_factory.mktemp("engine") / "harness"
    sources = [
        CHECKOUT / "runtime" / "engine" / f"{name}.c"
        for name in ("cell", "chain", "engine", "phase", "search", "tables", "factored")
    ]
    flags = ["-std=c11", "-O1", "-g", "-Wall", "-Wextra", "-Werror"]
    flags += [
        "-Dcalloc=failing_calloc",
        "-ffp-contract=off",
        "-fsanitize=address,undefined",
        "-fno-sanitize-recover=all",
    ]
    folders = [f"-I{CHECKOUT / 'runtime' / 'engine'}", f"-I{CHECKOUT / 'derive/codegen/support'}"]
    files = [str(CHECKOUT / "tests" / "c" / "engine.c"), *map(str, sources)]
    command = [str(compiler), *flags, *folders, *files, "-o", str(program), "-lm"]
    subprocess.run(command, check=True)
    if (
        "ReserveShadowMemoryRange"
        in subprocess.run([program], capture_output=True, text=True).stderr
    ):
        pytest.skip("AddressSanitizer is not given the addresses that it needs")
    return program


def large(name):
    """A chain of 12 masses with a stop and friction, also with factors, or 40 stops: and starts."""
    rng = np.random.default_rng(4)
    if name != "stops":
        rest = np.tile([1.0, 0.0], (6, 1))
        return chain(12, 5, name == "factors"), np.hstack(
            [rng.uniform(-0.2, 0.2, (6, 12)), rng.normal(size=(6, 12)), rest]
        )
    states = np.hstack([np.zeros((3, 20)), rng.uniform(0.9, 1.1, (3, 20))])
    states[0, 20:] = 1.0
    return masses_apart(20, np.repeat([0.5, 0.4], 20)), states


def written(path, system, states, transitions):
    layout, numbers = layout_of(system.structure), numbers_of(system)
    sizes = [layout.size, numbers.size, states.shape[1], len(states), transitions]
    with path.open("wb") as file:
        file.write(np.array(sizes, dtype=np.int64).tobytes())
        file.write(layout.tobytes() + numbers.tobytes())
        for state in states:
            where = configuration_of(system, state)
            file.write(np.array([where], dtype=np.int64).tobytes() + state.tobytes())
    return path


def answered(harness, file, *arguments):
    command = [harness, file, *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=False, timeout=600)


@pytest.mark.parametrize("name", [*SYSTEMS, "chain", "factors", "stops"])
def test_the_engine_is_clean_and_follows_the_reference(harness, name, tmp_path):
    small = name in SYSTEMS
    if small:
        system, states = (
            piecewise(name, SYSTEMS[name]),
            np.random.default_rng(3).normal(size=(40, 4)),
        )
        states[:, 0] = np.minimum(states[:, 0], 0.9) if "stop" in name else states[:, 0]
    else:
        system, states = large(name)
    transitions, error = (12, 1e-6) if small else (30, 1e-9)
    told = answered(harness, written(tmp_path / "motions", system, states, transitions))
    assert told.returncode == 0, told.stderr
    for state, line in zip(states, told.stdout.splitlines(), strict=True):
        status, count, configuration, _, *end = line.split()
        begin = configuration_of(system, state)
        known = with_engine("numpy", follow, system, state, begin, transitions=transitions)
        assert (int(status), int(count)) == (known.status, len(known.times) - 1)
        assert int(configuration) == known.configurations[-1]
        np.testing.assert_allclose(np.array(end, dtype=float), known.states[-1], atol=error)


def test_where_there_is_no_memory_nothing_is_lost(harness, tmp_path):
    """Each of the engine's allocations fails once: it says so, and keeps none of the others."""
    system, states = large("chain")
    file = written(tmp_path / "motions", system, states[:1], 3)
    failed = 0
    while (told := answered(harness, file, str(failed))).returncode:
        assert (told.returncode, told.stderr) == (3, "no memory\n")
        failed += 1
    assert failed == 11


def test_numbers_that_no_system_has_are_clean_too(harness, tmp_path):
    """Infinities, no numbers, the largest and the least, anywhere: an end, and no report."""
    rng = np.random.default_rng(11)
    hostile = np.array([np.inf, -np.inf, np.nan, 1e308, -1e308, 5e-324, 1e150, 1e-150, 0.0])
    for name in (*SYSTEMS, "factors"):
        system = chain(10, 4, True) if name == "factors" else piecewise(name, SYSTEMS[name])
        size = len(system.structure.states)
        states = rng.normal(size=(4, size)) * 0.5
        layout, numbers = layout_of(system.structure), numbers_of(system)
        head = np.array([layout.size, numbers.size, size, len(states), 5], dtype=np.int64)
        # flows and resets alone: what the exponents make of them ends late, if it ends at all
        safe = sum(part.size for part in system.exponents)
        before = system.fields.size + system.rows.size + system.resets.size
        places = np.delete(np.arange(numbers.size), np.s_[before : before + safe])
        for _ in range(8):
            changed = numbers.copy()
            changed[rng.choice(places, 3)] = rng.choice(hostile, 3)
            starts = states.copy()
            starts[rng.integers(4), rng.integers(size)] = rng.choice(hostile)
            rows = b"".join(np.array([0]).tobytes() + state.tobytes() for state in starts)
            file = tmp_path / "hostile"
            file.write_bytes(head.tobytes() + layout.tobytes() + changed.tobytes() + rows)
            told = answered(harness, file)
            assert told.returncode == 0, told.stderr
            assert len(told.stdout.splitlines()) == len(states)


def test_a_cut_or_foreign_layout_is_refused(harness, tmp_path):
    system = piecewise("rigid-stop", SYSTEMS["rigid-stop"])
    whole = written(tmp_path / "whole", system, np.zeros((1, 4)), 3).read_bytes()
    cut, foreign = tmp_path / "cut", tmp_path / "foreign"
    cut.write_bytes(whole[:-8])
    damaged = bytearray(whole)
    damaged[40 + 4 * 3 : 40 + 4 * 3 + 4] = (1000).to_bytes(4, "little")
    foreign.write_bytes(bytes(damaged))
    for path, told in ((cut, "cut"), (foreign, "foreign")):
        found = subprocess.run(
            [harness, path],
            capture_output=True,
            text=True,
            check=False,
            env={"ASAN_OPTIONS": "detect_leaks=0"},
        )
        assert (found.returncode, found.stderr.strip()) == (2, told)
