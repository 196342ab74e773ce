"""What the benchmark compares with is right: its closed forms and its peers' own equations."""

import numpy as np
import pytest
from benchmarking import peers
from benchmarking.peer_responses import HarmonicBalance, Shooting, follow_both_ways
from benchmarking.responses import our_motion, settled

from tests.tables import slow


@pytest.fixture(scope="module")
def orbit():
    return settled()


def test_the_ball_of_the_closed_form_is_the_one_that_is_simulated():
    _, error = peers.our_ball()
    assert error < 1e-13


# a free bar in SI units: its motion as a whole beside vibrations of 1e6 radians a second
@pytest.mark.parametrize("elements", [2, slow(4), slow(12)])
def test_elements_touch_as_long_as_the_first_zero_of_their_reaction_says(elements):
    _, _, times, kept = peers.our_bar(elements, None)
    expected = peers.contact_of_elements(elements)
    assert len(times) == 4
    assert times[1] == pytest.approx(peers.DISTANCE / peers.SPEED, rel=1e-9)
    assert times[3] - times[1] == pytest.approx(expected, rel=1e-8)
    assert kept < 1


def test_a_motion_shoots_onto_itself_and_has_the_orbits_multipliers(orbit):
    states = our_motion(orbit, np.zeros(1))[:, 0]
    shooting, omega = Shooting(1e-9), 0.635
    unknowns = np.array([*states[:2], *(states[2:] / omega), omega])
    residual, jacobian = shooting.residual(unknowns)
    assert np.abs(residual).max() < 1e-9
    found = np.sort_complex(shooting.multipliers(jacobian))
    np.testing.assert_allclose(found, np.sort_complex(orbit.multipliers), atol=1e-7)
    ahead, behind = (shooting.residual(unknowns + h * np.eye(5)[4])[0] for h in (1e-6, -1e-6))
    np.testing.assert_allclose(jacobian[:, 4], (ahead - behind) / 2e-6, atol=1e-5)


def test_harmonics_tend_to_the_orbit_and_follow_it_through_its_fold(orbit):
    phases = 2 * np.pi * np.arange(512) / 512
    motion = our_motion(orbit, phases)[:2]
    errors = []
    for harmonics in (7, 21, 63):
        balance = HarmonicBalance(harmonics, 512)
        start = balance.start(motion, 0.635)
        found = follow_both_ways(balance, start, (0.6349, 0.6351), 1.0, lambda _: True)
        (at,) = found[np.abs(found[:, -1] - 0.635) < 1e-12]
        errors.append(np.abs(balance.motion(at, phases) - motion).max())
    assert errors[0] > 5 * errors[1] > 25 * errors[2]
    balance = HarmonicBalance(7, 512)
    start = balance.start(motion, 0.635)
    branch = follow_both_ways(
        balance, start, (0.5, 0.8), 0.1, lambda x: balance.motion(x, phases)[0].max() > 1
    )
    top = int(branch[:, -1].argmax())
    assert 0 < top < len(branch) - 1
    # where our branch turns
    assert branch[top, -1] == pytest.approx(0.755627, abs=1e-3)
