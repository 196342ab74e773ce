"""Systems of more than 16 states and 31 boundaries, against expm, the other engine and by hand."""

import math
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from nonsmooth.runtime.model.engine_layout import layout_of, numbers_of
from nonsmooth.runtime.model.engine_run import Status
from nonsmooth.runtime.model.kernels import compiled_engine
from nonsmooth.runtime.simulation.engines import run_motions
from nonsmooth.runtime.simulation.simulate import follow
from tests.engines import ENGINES, with_both, with_engine
from tests.large_systems import RESTITUTION, chain, integrated, masses_apart
from tests.tables import slow

pytestmark = pytest.mark.compiled


def start_of(count, seed):
    rng = np.random.default_rng(seed)
    place = rng.uniform(-0.2, 0.2, count)
    phase = rng.uniform(0, 2 * np.pi)
    return np.array([*place, *rng.normal(size=count), np.cos(phase), np.sin(phase)])


@pytest.mark.parametrize("factored", [False, True])
@pytest.mark.parametrize(
    ("count", "rubbing", "transitions"),
    [
        (10, None, 20),
        (12, None, 20),
        (30, None, 12),
        (10, 4, 40),
        (30, 12, 40),
        slow(70, None, 12),
        slow(70, 40, 30),
    ],
)
def test_chains_follow_matrix_exponentials(count, rubbing, transitions, factored):
    system, state = chain(count, rubbing, factored), start_of(count, 3)
    if rubbing is not None:
        state[count + rubbing] = abs(state[count + rubbing])
    times, places, states = integrated(system, state, 0, transitions)
    assert rubbing is None or set(places) == {0, 1, 2}
    for engine in ENGINES[: 2 if count <= 12 else 1]:
        found = with_engine(engine, follow, system, state, 0, transitions=transitions)
        assert found.configurations.tolist() == places
        assert_allclose(found.times, times, rtol=0, atol=1e-11)
        assert_allclose(found.states, states, rtol=0, atol=1e-11)


@pytest.mark.parametrize("count", [15, 16, 17, 40])
def test_stops_reached_one_by_one(count):
    """30 to 80 boundaries: each mass by itself meets its next stop after half a swing."""
    rng = np.random.default_rng(count)
    gaps = rng.uniform(0.3, 0.6, 2 * count)
    state = np.array([*np.zeros(count), *rng.uniform(0.9, 1.1, count)])
    system = masses_apart(count, gaps)
    found, known = with_both(follow, system, state, 0, transitions=count + 5)
    assert found.sets.dtype == (np.int32 if 2 * count < 32 else object)
    assert found.sets.tolist() == known.sets.tolist()
    assert_allclose(found.times, known.times, rtol=0, atol=1e-12)
    for mass in range(count):
        place = next(k for k, mask in enumerate(found.sets) if mask >> mass & 1)
        assert found.times[place] == pytest.approx(math.asin(gaps[mass] / state[count + mass]))


def test_many_stops_reached_together():
    """Forty masses go as one: sets of forty boundaries, in words that differ."""
    count, gap = 40, 0.5
    system = masses_apart(count, np.full(2 * count, gap))
    state = np.array([*np.zeros(count), *np.ones(count)])
    found, known = with_both(follow, system, state, 0, transitions=8)
    right = (1 << count) - 1
    left = right << count
    assert found.sets.tolist() == known.sets.tolist() == [0, *[right, left] * 4]
    speed, time = 1.0, 0.0
    for k in range(8):
        amplitude = math.hypot(speed, gap if k else 0.0)
        time += math.asin(gap / amplitude) * (2 if k else 1)
        speed = RESTITUTION * math.sqrt(amplitude**2 - gap**2)
        assert found.times[k + 1] == pytest.approx(time, abs=1e-12)


def test_what_is_kept_of_many_motions():
    count, kept = 20, 5
    rng = np.random.default_rng(1)
    system = masses_apart(count, rng.uniform(0.3, 0.6, 2 * count))
    states = np.hstack([np.zeros((3, count)), rng.uniform(0.9, 1.1, (3, count))])
    zeros, until = np.zeros(3, dtype=int), np.full(3, np.inf)
    engine = compiled_engine()
    numbers = numbers_of(system)[None]
    ends = run_motions(engine, system.structure, numbers, zeros, states, zeros, until, 44, kept)
    for state, sets in zip(states, ends.last_sets, strict=True):
        known = with_engine("numpy", follow, system, state, 0, transitions=44)
        assert [sets[k % kept] for k in range(40, 45)] == known.sets[40:].tolist()


def test_factors_that_no_mode_has_are_refused():
    """A layout that says of a mode that it has factors, and does not count them, or of a chain."""
    engine = compiled_engine()
    system = chain(10)
    structure = system.structure
    (shapes,) = structure.shapes
    longer = replace(shapes[0], length=2, places=(0, 1), factored=True)
    joined = replace(shapes[1], joined=True, factored=True)
    layouts = [
        layout_of(replace(structure, modes=(modes,)))
        for modes in ((longer, *shapes[1:]), (shapes[0], joined, *shapes[2:]))
    ]
    uncounted = layout_of(structure).copy()
    flags = 11 + 2 + 4 * len(shapes)  # behind the header, starts, and four numbers of each mode
    assert not uncounted[flags : flags + len(shapes)].any()
    uncounted[flags + 1] = 1
    none, real = np.zeros(0, dtype=np.int32), [np.zeros(0)]
    for layout in (*layouts, uncounted):
        with pytest.raises(ValueError, match="cut or foreign"):
            engine.compose(layout, np.zeros(3, dtype=np.int32), *real * 6, none, none, 0)


@pytest.mark.parametrize(("count", "growing"), [(12, False), (20, False), (12, True)])
def test_rounding_by_factors_is_bounded_as_by_matrices(count, growing):
    """What a decider is told of an event: never less than by matrices, and not much more."""
    engine, told = compiled_engine(), []

    def decide(*what):
        told.append([np.frombuffer(what[4]), what[5]])  # bytes
        return Status.UNDECLARED, 0, 0

    for factored in (False, True):
        system = chain(count, factored=factored)
        if growing:
            (exponents,) = system.exponents
            system = replace(system, exponents=(np.abs(exponents),))
        structure = replace(system.structure, transitions=((),))
        none, whole = np.zeros(0), np.zeros(1, dtype=np.int32)
        counts = np.zeros(3, dtype=np.int64)
        engine.simulate(
            layout_of(structure), numbers_of(system), whole, start_of(count, 3), whole.copy(),
            np.array([np.inf]), 5, none, none.astype(np.int32), none, none,
            none.astype(np.int32), none, counts, decide,
        )  # fmt: skip
    (sizes, late), (bounds, later) = told
    assert (bounds >= sizes * (1 - 1e-12)).all()
    assert (bounds <= 3 * sizes).all()
    assert late * (1 - 1e-12) <= later <= 3 * late


MEMORY = """
import resource
import numpy as np
from nonsmooth.runtime import _engine

def layout(states, length):
    header = [states, 1, 1, 1, 1, length, 0, 0, 0, 0, 0]
    rest = [0, 1, length, 0, 0, 0, 0, 0, length, 0, 0, 0, 0, 0, 0, 0]
    return np.array([*header, *rest], dtype=np.int32)

resource.setrlimit(resource.RLIMIT_AS, (2 << 30, 2 << 30))
real, whole, long = (lambda *s: np.zeros(s), lambda *s: np.zeros(s, dtype=np.int32),
                     lambda *s: np.zeros(s, dtype=np.int64))
for states, length in ((30000, 1), (1 << 28, 1), (1 << 28, 1 << 28)):
    shape = layout(states, length)
    for call in (
        lambda: _engine.simulate(shape, real(0), whole(0), real(0), whole(0), real(0), 5, real(0),
                                 whole(0), real(0), real(0), whole(0), real(0), long(0), None),
        lambda: _engine.compose(shape, np.repeat(whole(1), 12), *[real(0)] * 6, *[whole(0)] * 2, 0),
    ):
        try:
            call()
        except MemoryError:
            continue
        raise SystemExit(f"{states}: no MemoryError")
"""


@pytest.mark.skipif(sys.platform != "linux", reason="limits of address space are Linux's")
def test_too_little_memory_is_an_error_and_no_crash():
    told = subprocess.run([sys.executable, "-c", MEMORY], capture_output=True, text=True)
    assert (told.returncode, told.stderr) == (0, "")
