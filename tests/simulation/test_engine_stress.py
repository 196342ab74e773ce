"""Motions that are hard on an engine: random ones, special starts, and long ones at 40 digits."""

import math
from dataclasses import replace

import numpy as np
import pytest
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
from nonsmooth.runtime.model import engine_run
from nonsmooth.runtime.model.kernels import compiled_engine
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.simulation.simulate import follow
from tests.two_masses import STICKING

LIMITS = STICKING | {"ur1": 2, "ur2": 2}
SLOW = LIMITS | {"V": 10}
compiled = pytest.mark.skipif(compiled_engine() is None, reason="no compiled engine")


def friction(kind, *values):
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
def test_random_motions_follow_the_reference(kind):
    rng = np.random.default_rng([*kind.encode()])
    for _ in range(12):
        verdict, told = against_reference(random_motion(rng, kind), 40)
        assert not verdict.startswith("wrong"), told


@compiled
@pytest.mark.parametrize("kind", ["plain", "on-belt", "elastic", "rigid"])
def test_random_motions_follow_the_proof(kind):
    rng = np.random.default_rng([*kind.encode(), 1])
    for _ in range(3):
        verdict, told = against_proof(random_motion(rng, kind), 20)
        assert not verdict.startswith("wrong"), told


@compiled
@pytest.mark.parametrize("seed", [1, 5, 6])
def test_random_chains_follow_fifty_digits(seed):
    system, state = random_chain(np.random.default_rng(seed))
    assert against_digits(system, state, 20) == ("agree", "")
    # one that is a little stiffer is another one
    stiffer = system.exponents[0].copy()
    stiffer[:, 1] *= 1 + 1e-6
    wrong = replace(system, exponents=(stiffer, *system.exponents[1:]))
    assert against_digits(wrong, state, 20)[0].startswith("wrong")


@compiled
@pytest.mark.parametrize("name", FOUND)
def test_what_led_an_engine_astray(name):
    assert against_reference(FOUND[name], 40) == ("agree", "")


def test_a_step_that_does_not_follow_is_seen():
    system = piecewise("dry-friction", STICKING)
    found = follow(system, np.array([0.1, 0.2, 0.3, -0.1]), 0, transitions=6)
    assert broken_step(system, found, 1.0) == ""
    for field, entry, change in (("times", 3, 1e-6), ("configurations", 4, 1), ("states", 2, 1e-6)):
        array = getattr(found, field).copy()
        array[entry] = array[entry] + change
        changed = type(found)(**{**vars(found), field: array})
        assert f"step {entry}" in broken_step(system, changed, 1.0)


@compiled
def test_a_wait_up_to_the_last_radian_ends_quietly():
    """The longest angle must not round up beyond the domain of the sine."""
    rng = np.random.default_rng(8)
    for chi, eta in zip(rng.uniform(0.1, 0.9, 40), rng.uniform(0.2, 4, 40), strict=True):
        system = piecewise("dry-friction", {**SLOW, "V": "1.2", "chi": chi, "eta": eta})
        centre = np.linalg.solve(system.fields[0][2:, :2], -system.fields[0][2:, -1])
        state = np.array([centre[0] + 0.5, centre[1] + 0.4, 0.3, 0.2])
        found = follow(system, state, 0)
        if len(found.times) == 1:
            assert found.status.name == "QUIET"
        wait = 1.5 * engine_run.LONGEST_WAIT / np.hypot(*system.exponents[0].T).max()
        later = follow(system, state, 0, wait)
        assert later.status.name == "UNTIL" or len(later.times) > 1


@pytest.mark.parametrize("system", ["elastic-stop", "rigid-stop"])
@pytest.mark.parametrize("miss", [0.0, 1e-9, -1e-9])
@pytest.mark.usefixtures("backend")
def test_each_maximum_may_graze_within_rounding_or_miss(system, miss):
    """Both masses in the slow mode, x1 = (1 - miss) cos wt with w = 1."""
    data = dict(m1=1, m2=1, k1=2, k2=3) | ({"r": 1} if system == "rigid-stop" else {"k3": 1})
    start = [miss - 1, (miss - 1) / 2, 0, 0]
    motion = ns.simulate(system, data, start, until=600.0 if miss == 0 else 5.0)
    times, depths = ([getattr(g, name) for g in motion.grazings] for name in ("time", "depth"))
    assert (motion.transitions > 0) == (miss < 0)
    if miss == 0:
        np.testing.assert_allclose(times, math.pi * np.arange(1, 191, 2), rtol=0, atol=1e-5)
        assert abs(depths[0]) < 1e-14
    else:
        assert not times
