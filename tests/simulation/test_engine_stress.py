"""Motions that are hard on an engine: random ones, special starts, and long ones at 40 digits."""

import math
import sys
from dataclasses import replace

import numpy as np
import pytest

from tests.places import CHECKOUT

sys.path.append(str(CHECKOUT / "scripts" / "development"))

from stressing_chains import against_digits, random_chain
from stressing_motions import (
    ELASTIC,
    FRICTION,
    RIGID,
    Motion,
    against_proof,
    against_reference,
    random_motion,
)
from stressing_steps import broken_step

import nonsmooth as ns
from nonsmooth.runtime.core.arithmetic import Mpmath
from nonsmooth.runtime.model.engine_run import LONGEST_WAIT, Status
from nonsmooth.runtime.model.kernels import compiled_engine
from nonsmooth.runtime.model.piecewise import piecewise, piecewise_in
from nonsmooth.runtime.simulation.simulate import follow
from nonsmooth.runtime.simulation.stepping import run

DATA = {
    "A": dict(chi="0.5", eta=1, V=1, us1=1, us2=1, ur1="4.0195", ur2="1.4831"),
    "B": dict(chi="0.4", eta=4, V="0.6773", us1="0.0127", ur1="0.0255", us2="0.5", ur2=1),
}
LIMITS = dict(chi="0.5", eta=1, V=1, us1=1, us2=1, ur1=2, ur2=2)
SLOW = dict(chi="0.5", eta=1, V=10, us1=1, us2=1, ur1=2, ur2=2)
compiled = pytest.mark.skipif(compiled_engine() is None, reason="no compiled engine")


@pytest.fixture(params=[pytest.param("c", marks=pytest.mark.compiled), "numpy"])
def backend(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> str:
    monkeypatch.setenv("NONSMOOTH_BACKEND", request.param)
    return request.param


def friction(kind: str, *values: float) -> Motion:
    names = ("chi", "eta", "V", "us1", "ur1", "us2", "ur2")
    parameters = dict(zip(names, values[:7], strict=True))
    return Motion(kind, "dry-friction", parameters, values[7:], math.inf)


# each once led an engine astray
FOUND = {
    # a shallow contact after 50,000 radians, where the angle's rounding counts
    "late": friction(
        "near-limits", 0.8759403305729061, 2.161060625081939, 0.40855810244738655,
        1.4633403845083905, 1.4633403845083948, 1.4633403845083905, 1.4633403849841415,
        -2.2240415253845627, -0.7552100142539961, 4.085543214984661, 1.2934059924036938,
    ),
    # a matrix whose small eigenvalue is known to 1e-11 only
    "stiff": friction(
        "scales", 0.9985104878731099, 278.68615652817994, 52.863080849612814,
        0.3077414504522229, 0.45863538964812484, 0.5455105114625323, 1.1105518089752444,
        21.311927551306162, -0.16594064346173634, -5.651125531402822, 4.124776540519032,
    ),
    "stiff, from the belt": friction(
        "scales", 0.9997823340104258, 4.8443322716529265, 50.53506374099653,
        1.2536469074953056, 3.4091017456221113, 0.6983391201354566, 0.7110392837111954,
        -11.275808603341723, 6.176898964443552, 2.922340650099309, 1.2239641074560192,
    ),
    # a stick of 4e9 time units: only what grew with it is uncertain
    "after a long wait": friction(
        "scales", 0.999782964415259, 22.66770970508609, 3.5393166389963904e-06,
        1.8703760710850004, 4.255768208690674, 1.5318788443525257, 1.8527756184272404,
        -4.575080914336252, 19.23815724366968, 18.99199137090134, -6.481974501903928,
    ),
}  # fmt: skip


@compiled
@pytest.mark.parametrize("kind", [*FRICTION, *RIGID, *ELASTIC])
def test_random_motions_follow_the_reference(kind: str) -> None:
    rng = np.random.default_rng([*kind.encode()])
    for _ in range(12):
        verdict, told = against_reference(random_motion(rng, kind), 40)
        assert not verdict.startswith("wrong"), told


@compiled
@pytest.mark.parametrize("kind", ["plain", "on-belt", "elastic", "rigid"])
def test_random_motions_follow_the_proof(kind: str) -> None:
    rng = np.random.default_rng([*kind.encode(), 1])
    for _ in range(3):
        verdict, told = against_proof(random_motion(rng, kind), 20)
        assert not verdict.startswith("wrong"), told


@compiled
@pytest.mark.parametrize("seed", [1, 5, 6])
def test_random_chains_follow_fifty_digits(seed: int) -> None:
    system, state = random_chain(np.random.default_rng(seed))
    assert against_digits(system, state, 20) == ("agree", "")
    # one that is a little stiffer is another one
    stiffer = system.exponents[0].copy()
    stiffer[:, 1] *= 1 + 1e-6
    wrong = replace(system, exponents=(stiffer, *system.exponents[1:]))
    assert against_digits(wrong, state, 20)[0].startswith("wrong")


@compiled
@pytest.mark.parametrize("name", FOUND)
def test_what_led_an_engine_astray(name: str) -> None:
    assert against_reference(FOUND[name], 40) == ("agree", "")


def test_a_step_that_does_not_follow_is_seen() -> None:
    system = piecewise("dry-friction", DATA["A"])
    found = run(system, np.array([0.1, 0.2, 0.3, -0.1]), 0, transitions=6)
    assert broken_step(system, found, 1.0) == ""
    for field, entry, change in (("times", 3, 1e-6), ("configurations", 4, 1), ("states", 2, 1e-6)):
        array = getattr(found, field).copy()
        array[entry] = array[entry] + change
        changed = type(found)(**{**vars(found), field: array})
        assert f"step {entry}" in broken_step(system, changed, 1.0)


@compiled
def test_a_wait_up_to_the_last_radian_ends_quietly() -> None:
    """The longest angle must not round up beyond the domain of the sine."""
    rng = np.random.default_rng(8)
    for chi, eta in zip(rng.uniform(0.1, 0.9, 40), rng.uniform(0.2, 4, 40), strict=True):
        system = piecewise("dry-friction", {**SLOW, "V": "1.2", "chi": chi, "eta": eta})
        centre = np.linalg.solve(system.fields[0][2:, :2], -system.fields[0][2:, -1])
        state = np.array([centre[0] + 0.5, centre[1] + 0.4, 0.3, 0.2])
        found = follow(system, state, 0)
        if len(found.times) == 1:
            assert found.status == Status.QUIET
        wait = 1.5 * LONGEST_WAIT / np.hypot(*system.exponents[0].T).max()
        later = follow(system, state, 0, wait)
        assert later.status == Status.UNTIL or len(later.times) > 1


@compiled
@pytest.mark.slow
@pytest.mark.parametrize("name", DATA)
def test_event_times_at_forty_digits(name: str) -> None:
    """A thousand transitions by exact flows and Newton's method, from the same doubles."""
    system, start = piecewise("dry-friction", DATA[name]), np.array([0.1, 0.2, 0.3, -0.1])
    found = follow(system, start, 0, transitions=1000)
    assert len(found.times) == 1001
    lib = Mpmath(40)
    mp, exact = lib.mp, piecewise_in("dry-friction", DATA[name], lib)
    state, now = [*map(mp.mpf, start.tolist()), mp.mpf(1)], mp.mpf(0)
    for k in range(1, 1001):
        c = int(found.configurations[k - 1])
        boundary = int(found.sets[k]).bit_length() - 1
        row = exact.rows[exact.structure.boundaries[c][boundary].row]
        parts = [
            [sum(a * x for a, x in zip(r, state, strict=True)) for r in flow]
            for flow in exact.flows[c]
        ]

        def after(t: object, c: int = c, parts: list = parts) -> list:
            values = []
            for (_, frequency), mode in zip(
                exact.exponents[c], exact.structure.modes[c], strict=True
            ):
                angle = frequency * t
                for power in range(mode.length):
                    values.append(t**power * mp.cos(angle))
                    if mode.oscillates:
                        values.append(t**power * mp.sin(angle))
            return [
                *(sum(f * p[i] for f, p in zip(values, parts, strict=True)) for i in range(4)),
                mp.mpf(1),
            ]

        dwell = mp.mpf(float(found.times[k] - found.times[k - 1]))
        for _ in range(4):
            there = after(dwell)
            value = sum(a * x for a, x in zip(row, there, strict=True))
            rate = [sum(a * x for a, x in zip(r, there, strict=True)) for r in exact.fields[c]]
            slope = sum(a * x for a, x in zip(row[:-1], rate, strict=True))
            dwell -= value / slope
        now += dwell
        assert abs(found.times[k] / now - 1) < 1e-12
        there = after(dwell)
        resets = {
            t.reset
            for t in exact.structure.transitions[c]
            if sum(1 << b for b in t.boundaries) == found.sets[k]
            and t.target == found.configurations[k]
        }
        matrix = exact.resets[resets.pop()]
        state = [
            *(sum(a * x for a, x in zip(r, there, strict=True)) for r in matrix),
            mp.mpf(1),
        ]


@pytest.mark.parametrize(
    ("state", "expected"),
    [
        # f1 = f2 = ur: f1' > 0 decides the first mass, then f2'' > 0 the second
        ([8, 12, 1, 1], ("slip-slip", "slip-stick")),
        # f1 = ur alone, and f1' > 0
        ([7, 10, 1, 1], ("slip-stick", "slip-slip")),
        # f1 = -ur, and f1' > 0 leads inside
        ([-7, -10, 1, 1], ("stick-stick", "slip-stick")),
        # f1 > ur: it cannot stick
        ([8, 9, 1, 1], ("slip-stick", "slip-slip")),
        # at the belt and leaving it
        ([7, 3, 1, 0], ("slip-slip", "slip-stick")),
        # reaches the belt with f1 < -ur: passes through
        ([-9, -9, "0.9", 0], ("slip-slip", "overshoot-slip")),
    ],
)
def test_starts_on_boundaries(backend: str, state: list, expected: tuple[str, ...]) -> None:
    motion = ns.simulate("dry-friction", LIMITS, state, transitions=1)
    assert motion.configurations == expected
    assert motion.times[1] > 0


@pytest.mark.parametrize("r", ["0", "0.5", "0.9"])
def test_impacts_end_in_a_contact_that_is_released(backend: str, r: str) -> None:
    """The second mass pulls the first against the stop until it has swung back to x2 = 1."""
    data = dict(m1=1, m2=1, k1=1, k2="0.05", r=r)
    motion = ns.simulate("rigid-stop", data, ["0.999", 3, 0, 0], until=2)
    contact = motion.configurations.index("contact")
    assert motion.configurations[contact + 1] == "free"
    state, before = motion.states[contact], motion.before[contact + 1]
    assert state[0] == 1
    assert state[2] == 0
    assert state[1] > 1
    assert before[1] == pytest.approx(1, abs=1e-12)
    assert motion.times[contact] < 1 < motion.times[contact + 1]
    dwell = np.diff(motion.times[1 : contact + 1])
    assert (dwell >= 0).all()
    assert dwell.size == 1 or dwell[-1] < 1e-12


@pytest.mark.parametrize("system", ["elastic-stop", "rigid-stop"])
@pytest.mark.parametrize("miss", [0.0, 1e-9, -1e-9])
def test_grazing_within_rounding_and_a_miss(backend: str, system: str, miss: float) -> None:
    """Both masses in the slow mode, x1 = (1 - miss) cos wt."""
    data = dict(m1=1, m2=1, k1=2, k2=3) | ({"r": 1} if system == "rigid-stop" else {"k3": 1})
    ratio = 0.5  # of the slow mode, w^2 = 1
    amplitude = 1 - miss
    start = [-amplitude, -amplitude * ratio, 0, 0]
    motion = ns.simulate(system, data, start, until=5.0)
    touched = [(g.time, g.depth) for g in motion.grazings]
    if miss == 0:
        assert motion.transitions == 0
        ((time, depth),) = touched
        assert time == pytest.approx(math.pi, abs=1e-6)
        assert abs(depth) < 1e-14
    else:
        assert not touched
        assert (motion.transitions > 0) == (miss < 0)


def test_each_maximum_may_graze(backend: str) -> None:
    data = dict(m1=1, m2=1, k1=2, k2=3, k3=1)
    motion = ns.simulate("elastic-stop", data, [-1, "-0.5", 0, 0], until=600)
    times = [g.time for g in motion.grazings]
    np.testing.assert_allclose(times, math.pi * np.arange(1, 191, 2), rtol=0, atol=1e-5)


def test_what_never_comes(backend: str) -> None:
    """At the centre of slip-slip it rests; around it no boundary is reached."""
    rest = ns.simulate("dry-friction", SLOW, [4, 6, 0, 0], until=1e9)
    assert (rest.status, rest.end, rest.transitions) == (Status.UNTIL, 1e9, 0)
    for state in ([4, 6, 0, 0], ["4.1", 6, 0, 0]):
        assert ns.simulate("dry-friction", SLOW, state, transitions=9).status == Status.QUIET


@compiled
def test_the_energy_of_elastic_impacts() -> None:
    """Each impact errs by a few roundings, and they add up no faster than their number."""
    data = dict(m1=1, m2=2, k1=1, k2=5, r=1)
    system = piecewise("rigid-stop", data)
    found = follow(system, np.array([0.2, -0.3, 1.5, 0.7]), 0, transitions=100_000)
    x1, x2, v1, v2 = found.states.T
    energy = (v1**2 + 2 * v2**2 + (x2 - x1) ** 2 + 5 * x2**2) / 2
    drift = np.abs(energy / energy[0] - 1)
    count = np.arange(1, len(energy))
    assert len(energy) == 100_001
    assert (drift[1:] <= 1e-15 + 5e-16 * count).all()
    y1, y2, w1, w2 = found.before.T
    before = (w1**2 + 2 * w2**2 + (y2 - y1) ** 2 + 5 * y2**2) / 2
    assert np.abs(energy / before - 1).max() <= 5e-16
