"""Diagrams and maps by brute force, against orbits and against single motions."""

import numpy as np
import pytest
import sympy as sp

from nonsmooth import InputError, simulate, solve, sweep
from nonsmooth.derive import Parameter, RigidStop
from tests.one_mass import one_mass
from tests.tables import slow
from tests.two_masses import CHAIN, PHASES, STICKING

STICK = {name: value for name, value in STICKING.items() if name != "V"}
REST = dict.fromkeys(("x1", "x2", "v1", "v2"), 0)


def swept(**changes):
    arguments = {
        "system": "dry-friction",
        "parameters": STICK,
        "name": "V",
        "values": np.linspace(0.95, 1.05, 5),
        "start": REST,
        "state": "x1",
        "configuration": "slip-stick",
        "transient": 4000,
        "samples": 40,
    }
    return sweep(**(arguments | changes))


@pytest.mark.compiled
@pytest.mark.parametrize("place", range(4))
def test_along_the_branch_a_sweep_gives_the_orbit(place):
    diagram = swept(configuration=PHASES[place][0])
    branch = solve(
        "dry-friction",
        STICK | {"V": diagram.values},
        [1.02, 2.0, 1.57, 3.28],
        itinerary=PHASES,
        multipliers=True,
    )
    assert branch.converged.all()
    sizes = np.abs(branch.multipliers).max(axis=-1)
    assert (sizes < 0.999).any()
    for row, states, size in zip(diagram.samples, branch.starts, sizes, strict=True):
        taken = row[np.isfinite(row)]
        assert taken.size == 10  # one in four transitions
        if size < 0.99:
            np.testing.assert_allclose(taken, states[place, 0], rtol=0, atol=1e-8)


def taken(value, start, transient):
    """Nine samples of a single motion, and where it ends."""
    given = STICK | {"V": value}
    motion = simulate("dry-friction", given, start, transitions=transient + 9)
    inside = np.array(motion.configurations[-9:]) == "slip-stick"
    assert inside.any()
    return np.where(inside, motion.states[-9:, 0], np.nan), motion.states[-1]


@pytest.mark.parametrize(
    "backend",
    [
        pytest.param("c", marks=pytest.mark.compiled),
        slow("numpy"),
    ],
)
def test_a_sweep_is_its_single_motions(backend, monkeypatch):
    monkeypatch.setenv("NONSMOOTH_BACKEND", backend)
    diagram = swept(values=[0.95, 1.05], transient=2, samples=9, follow=False)
    wanted = [taken(value, REST, 2)[0] for value in diagram.values]
    np.testing.assert_allclose(diagram.samples, wanted, rtol=0, atol=1e-10)


def test_following_continues_from_chunk_to_chunk():
    values, told = np.linspace(0.9, 1.1, 66), []
    diagram = swept(values=values, transient=5, samples=9, progress=told.append)
    assert told == [64, 66]
    _, last = taken(values[63], REST, 5)
    wanted = [taken(value, last, 5)[0] for value in values[64:]]
    np.testing.assert_allclose(diagram.samples[64:], wanted, rtol=0, atol=1e-11)
    anew = swept(values=values, transient=5, samples=9, follow=False)
    np.testing.assert_array_equal(anew.samples[:64], diagram.samples[:64])
    assert not np.array_equal(anew.samples[64:], diagram.samples[64:], equal_nan=True)


@pytest.mark.compiled
def test_what_comes_to_rest_leaves_no_points_behind():
    # the stop takes all the energy: after a few impacts no boundary is reached
    start = {"x1": 0, "x2": 0, "v1": 2, "v2": 0}
    data = {"m1": 1, "m2": 2, "k2": 5, "r": "1/20"}
    asked = ("rigid-stop", data, "k1", [1.0], start)
    given = {"state": "v1", "configuration": "free"}
    ended = len(simulate(*asked[:1], data | {"k1": 1}, start, transitions=900).times) - 1
    for transient, left in ((ended, 0), (ended - 1, 1), (0, 3)):
        diagram = sweep(*asked, **given, transient=transient, samples=3)
        assert np.isfinite(diagram.samples).sum() == left


def test_a_value_outside_the_domain_is_a_gap():
    diagram = swept(values=[-1.0, 1.0], transient=100)
    assert np.isnan(diagram.samples[0]).all()
    assert np.isfinite(diagram.samples[1]).any()


@pytest.mark.parametrize(
    ("changes", "match"),
    [
        ({"state": "z1"}, "unknown state 'z1'"),
        ({"configuration": "stick"}, "unknown configuration 'stick'"),
        ({"name": "W"}, "unknown parameter 'W'"),
        ({"name": "eta"}, "eta is both given and swept"),
        ({"values": []}, "values of V"),
        ({"values": [1, np.nan]}, "values of V"),
        ({"values": [[1, 2]]}, "values of V"),
        ({"values": "many"}, "values of V"),
        ({"values": [-2, -1]}, "for no value of V"),
        ({"transient": -1}, "transient = -1"),
        ({"samples": 0}, "samples = 0"),
        ({"start": {"x1": 0}}, "needs a value for"),
        ({"parameters": {"chi": "0.5"}}, "needs a value for"),
        ({"threads": 0}, "threads = 0"),
    ],
)
def test_bad_sweeps(changes, match):
    with pytest.raises(InputError, match=match):
        swept(**({"transient": 10} | changes))


def test_a_start_inside_the_stop_is_told():
    with pytest.raises(InputError, match="for no value of r"):
        sweep(
            "rigid-stop", CHAIN, "r", [0.5, 0.6], REST | {"x1": 2}, state="x2",
            configuration="free", transient=10,
        )  # fmt: skip


def test_a_stroboscope_waits_for_its_phase_in_either_sense():
    w = Parameter("w", "speed of the forcing", lower=-sp.oo)
    system = one_mass("turned", damping="1/10", forces={w.symbol: 1}, parameters=[w])
    diagram = sweep(system, {}, "w", [1, -1], {"x": 0, "v": 0}, state="s1", phase=2.0,
                    transient=3, samples=5)  # fmt: skip
    np.testing.assert_allclose(diagram.samples, np.sin(2), atol=1e-12)


@pytest.mark.parametrize("phase", [0.0, 2.0, 4.0])
def test_a_stroboscope_goes_on_from_a_mass_that_rests_on_a_stop(phase):
    """Impacts accumulate; the stop that is swept reaches the resting mass or leaves it behind."""
    gap = Parameter("gap", "place", lower=-sp.oo)
    stop, forces = RigidStop("x", at=gap.symbol, restitution="1/5"), {"1/2": 1}
    system = one_mass("resting", stop, damping="1/10", forces=forces, parameters=[gap])
    places, start = np.linspace(0, -0.4, 3), {"x": -1, "v": 0}
    given = {"state": "x", "phase": phase, "transient": 30, "samples": 4}
    diagram = sweep(system, {}, "gap", places, start, **given)
    assert (diagram.outcomes >= 0).all()
    alone = sweep(system, {}, "gap", places, start, follow=False, **given)
    np.testing.assert_allclose(diagram.samples, alone.samples, rtol=0, atol=1e-9)
