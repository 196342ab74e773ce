"""Cone conditions on a section of two coordinates: proved, checked, true of simulated motions."""

import json
import math
from fractions import Fraction

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.runtime.model.kernels import load_system
from tests.certified import accepted
from tests.horseshoes import INVERTED, INVERTED_DATA, inverted_horseshoe

pytestmark = pytest.mark.slow  # on a section of one coordinate they are looked at in test_chaos
PERIOD = 2 * math.pi / float(INVERTED_DATA["w"])
STEP = 1e-6


@pytest.fixture(scope="module")
def chaos():
    return inverted_horseshoe(exponents=True)


@pytest.fixture(scope="module")
def mapped():
    """The map over one period, of points (n, 2), by simulation."""
    system = load_system(str(INVERTED))
    values = {name: float(text) for name, text in INVERTED_DATA.items()}

    def map_of(points):
        forcing = np.tile([-1.0, 0.0], (len(points), 1))  # the section's phase
        starts = np.hstack([points, forcing])
        places = np.zeros(len(points), dtype=np.int32)
        return ns.simulate(system, values, starts, places, until=PERIOD).states[:, :2]

    return map_of


def derivatives(mapping, points):
    sides = [mapping(points + STEP * e) - mapping(points - STEP * e) for e in np.eye(2)]
    return np.stack(sides, axis=-1) / (2 * STEP)


def test_what_is_proved_is_proved_again(chaos, tmp_path):
    assert chaos.cones is not None, chaos.tried
    assert float(chaos.exponent) > 1.5
    rate = math.log(float(Fraction(chaos.cones.expansion))) / 2
    assert rate - 1e-5 < float(chaos.exponent) <= rate
    accepted(chaos, tmp_path)
    stated = json.loads((tmp_path / "found.json").read_text())["cones"]
    assert ns.load(tmp_path / "found.json").to_json()["cones"] == stated


def test_differences_of_motions_are_as_the_cones_say(chaos, mapped):
    random = np.random.default_rng(3)
    sets = {h_set.name: h_set.near for h_set in chaos.h_sets}
    expansion, contraction = (
        float(Fraction(x)) for x in (chaos.cones.expansion, chaos.cones.contraction)
    )
    forms = {
        name: np.array([1, -1]) * [float(Fraction(x)) for x in form]
        for name, form in chaos.cones.forms.items()
    }
    assert len(chaos.cones.strips) == len(chaos.coverings) == 3
    for source, target, entries in chaos.cones.strips:
        (centre, sides), (other, across) = sets[source], sets[target]

        def seen(shares, centre=centre, sides=sides, other=other, across=across):
            return np.linalg.solve(across, (mapped(centre + shares @ sides.T) - other).T).T

        low, high = np.array([[float(Fraction(x)) for x in ends] for ends in entries]).T
        first, second = (low + random.random((2000, 2)) * (high - low) for _ in range(2))
        before = (first - second) ** 2 @ forms[source]
        behind = (seen(first) - seen(second)) ** 2 @ forms[target]
        assert (behind > expansion * before).all()
        assert (behind > contraction * before).all()
        assert (before > 0).any()
        assert (behind < 0).any()
        # what lies in the target comes from the strip
        shares = random.uniform(-1, 1, (4000, 2))
        inside = (np.abs(seen(shares)) <= 1).all(axis=1)
        assert inside.any()
        assert ((shares >= low) & (shares <= high))[inside].all()


def test_periodic_motions_have_at_least_the_exponent(chaos, mapped):
    sets = {h_set.name: h_set.near for h_set in chaos.h_sets}
    for word in [word for steps in (1, 2, 3, 4) for word in chaos.words(steps)]:
        points, count = np.array([sets[name][0] for name in word]), len(word)
        for _ in range(40):  # Newton's method for all points of the cycle, in short steps at first
            missed = mapped(points) - np.roll(points, -1, axis=0)
            slopes = derivatives(mapped, points)
            matrix = np.zeros((count, 2, count, 2))
            for k in range(count):
                matrix[k, :, k] += slopes[k]
                matrix[k, :, (k + 1) % count] -= np.eye(2)
            change = np.linalg.solve(matrix.reshape(2 * count, -1), missed.ravel())
            points = points - change.reshape(-1, 2) * min(1, 0.05 / np.abs(change).max())
        assert np.abs(mapped(points) - np.roll(points, -1, axis=0)).max() < 1e-11
        for name, point in zip(word, points, strict=True):
            centre, sides = sets[name]
            assert (np.abs(np.linalg.solve(sides, point - centre)) <= 1).all()
        around = np.linalg.multi_dot([np.eye(2), *slopes[::-1], np.eye(2)])
        largest = np.log(np.abs(np.linalg.eigvals(around)).max()) / count
        assert largest >= float(chaos.exponent)
        assert largest < 2 * float(chaos.exponent)
