"""Chaos that is proved: images of sets hold what moves, and nothing is called chaos that is not."""

import math
from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth import certify
from nonsmooth.runtime.model.kernels import load_system
from nonsmooth.runtime.proof.chaos.h_sets import decimal_set
from tests.horseshoes import (
    FOLDED,
    FOLDED_DATA,
    FRICTION_DATA,
    folded_horseshoe,
)
from tests.places import GALLERY

START = (1.93, 7.18, 1.18, 1.18)


@pytest.fixture(scope="module")
def chaos():
    return folded_horseshoe(exponents=True)


@pytest.fixture(scope="module")
def kernels():
    return load_system(str(FOLDED))


@pytest.fixture(scope="module")
def returned(kernels):
    """The section's coordinate after so many passages, by exact simulation."""

    def after(v, passages):
        start, most = [0.0, v], 3 * passages
        motion = ns.simulate(kernels, FOLDED_DATA, start, "out", transitions=most)
        places = [k for k, (name,) in enumerate(motion.boundaries[1:], 1) if name == "rises"]
        return motion.states[places[passages - 1]][1]

    return after


@pytest.mark.slow
def test_two_masses_on_a_belt_are_chaotic():
    check_entropy(certify.chaos("dry-friction", FRICTION_DATA, START, iterates=3))


def test_a_folded_motion_is_chaotic(chaos):
    check_entropy(chaos)


def check_entropy(chaos):
    """It is about the logarithm of the largest eigenvalue, and below it."""
    assert chaos.proved
    assert float(chaos.entropy) > 0
    rate = max(abs(np.linalg.eigvals(chaos.matrix.astype(float))))
    assert float(chaos.entropy) <= math.log(rate) / chaos.iterates + 1e-15
    assert float(chaos.entropy) > math.log(rate) / chaos.iterates - 1e-5


def test_states_of_the_sets_go_where_their_images_are_said_to_be(chaos, returned):
    random = np.random.default_rng(7)
    for h_set in chaos.h_sets:
        centre, sides = h_set.near
        for share in random.uniform(-1, 1, 12):
            image = returned(float(centre[0] + share * sides[0, 0]), chaos.iterates)
            parts = chaos.images[h_set.name]
            assert any(low - 1e-9 <= image <= high + 1e-9 for (low,), (high,) in parts)


def test_words_are_the_periodic_points_once_for_each_motion(chaos):
    assert [chaos.periodic_points(steps) for steps in range(1, 7)] == [1, 3, 4, 7, 11, 18]  # Lucas
    for steps in range(1, 7):
        words = [word for d in range(1, steps + 1) if steps % d == 0 for word in chaos.words(d)]
        assert sum(map(len, words)) == chaos.periodic_points(steps)
        walked = {step for word in words for step in pairwise((*word, word[0]))}
        assert walked <= set(chaos.coverings)
        turned = [word[k:] + word[:k] for word in words for k in range(len(word))]
        assert len(set(turned)) == len(turned)


def test_a_stable_motion_is_not_called_chaos():
    stable = {**FRICTION_DATA, "V": "0.3", "ur1": "1.5", "ur2": "1.5", "eta": "1"}
    found = certify.chaos("dry-friction", stable, [1.0, 1.2, 0.1, 0.1], iterates=2, attempts=2)
    assert found.claim == "undecided"
    assert found.tried
    assert found.entropy == "0"


@pytest.mark.slow
def test_a_mass_that_rests_at_its_stop_when_the_forcing_has_a_phase_is_not_called_chaos():
    system = load_system(str(GALLERY / "impact_oscillator.py"))
    found = certify.chaos(system, {"r": "0.2", "sigma": "0", "w": "0.7"}, {"x": -0.5, "v": 0.1})
    assert found.claim == "undecided"
    assert all("free" in told for told in found.tried)


@pytest.mark.parametrize("units", [(1, 1), (1e-9, 1e-4), (1e6, 1e-6)], ids=str)
def test_decimals_of_sets_are_short_and_near_in_all_units(units):
    rng = np.random.default_rng(5)
    for _ in range(20):
        scale = np.array(units)
        centre, sides = rng.normal(size=2), rng.normal(size=(2, 2)) * [0.1, 0.01]
        h_set = decimal_set("N", (centre * scale).tolist(), sides * scale[:, None])
        middle, columns = h_set.near
        assert np.abs(middle / scale - centre).max() < 1e-7
        assert np.abs(columns / scale[:, None] - sides).max() < 1e-7
        digits = [text.lstrip("-0.").rstrip("0") for text in (*h_set.centre, *h_set.sides[0])]
        assert max(map(len, digits)) <= 12


def test_wrong_input_is_told():
    with pytest.raises(ns.InputError, match="iterates"):
        certify.chaos("dry-friction", FRICTION_DATA, START, iterates=0)
    with pytest.raises(ns.InputError, match="rational"):
        certify.chaos("dry-friction", {**FRICTION_DATA, "V": "sqrt(2)"}, START)


def test_neighbours_part_as_the_cones_say(chaos, returned):
    assert float(chaos.exponent) > 0.1
    rate, sets = float(Fraction(chaos.cones.expansion)), {s.name: s for s in chaos.h_sets}
    scales = {name: float(Fraction(a)) for name, (a,) in chaos.cones.forms.items()}
    for one, other, ((low, high),) in chaos.cones.strips:
        (c, s), (_, t) = ([float(x.ravel()[0]) for x in sets[k].near] for k in (one, other))
        shares = np.linspace(float(Fraction(low)), float(Fraction(high)), 7)
        images = [returned(c + share * s, chaos.iterates) / t for share in shares]
        stretched = (np.diff(images) / np.diff(shares)) ** 2 * scales[other]
        assert (stretched > rate * scales[one]).all()
        # what lies in the other set comes from the strip
        for share in np.linspace(-1, 1, 41):
            (d,) = sets[other].near[0]
            if abs(returned(c + share * s, chaos.iterates) - d) < abs(t):
                assert float(Fraction(low)) <= share <= float(Fraction(high))
