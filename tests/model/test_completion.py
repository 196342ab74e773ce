"""Laws of completion: relations hold exactly, in any order of giving and any arithmetic."""

from fractions import Fraction
from itertools import permutations

import numpy as np
import pytest

from nonsmooth import InputError
from nonsmooth.runtime.model.completion import complete, complete_arrays, complete_system
from nonsmooth.runtime.model.kernels import load_orbit, load_system
from nonsmooth.runtime.model.parameters import constrained

FRICTION = ["dry-friction/global-stick", "dry-friction/symmetric"]
E, US, UR = "e1", "us1", "ur1"


def forces(random):
    """Random e1 = ur1 - us1 and e2 = ur2 - us2, all inside their domains."""
    found = {}
    for k in "12":
        us, e = (Fraction(int(n), int(d)) for n, d in random.integers(1, 60, (2, 2)))
        us += Fraction(int(random.integers(9)), 10**300)  # digits that no double holds
        found |= {f"e{k}": e, f"us{k}": us, f"ur{k}": us + e}
    return found


def test_relations_hold_exactly_whatever_is_given_and_in_any_order():
    random = np.random.default_rng(31)
    for name in FRICTION:
        kernels = load_orbit(name)
        for _ in range(20):
            every = forces(random)
            names = [
                n
                for k in "12"
                for n in random.permutation([f"{x}{k}" for x in ("e", "us", "ur")])[:2]
            ]
            points = [
                complete(kernels, {n: str(every[n]) for n in order})
                for order in list(permutations(names))[::5]
            ]
            assert all(point == points[0] for point in points)
            system = complete_system(kernels, {**points[0].values, **points[0].opened})
            assert system.chosen == ()
            for n in ("us1", "ur1", "us2", "ur2"):
                assert system.values[n].exact == every[n]


def test_arrays_complete_to_the_same():
    random = np.random.default_rng(32)
    kernels = load_orbit(FRICTION[0])
    for pair in (("us1", "ur1"), ("e1", "us1"), ("e1", "ur1")):
        several = [forces(random) for _ in range(8)]
        arrays = complete_arrays(
            kernels, {n: np.array([float(x[n]) for x in several]) for n in pair}
        )
        for k, every in enumerate(several):
            point = complete(kernels, {n: every[n] for n in pair})
            for name, value in {**point.values, **point.opened}.items():
                column = np.broadcast_to(arrays[name], 8)
                assert column[k] == pytest.approx(float(value), abs=1e-12)


def test_arrays_of_objects_hold_the_doubles_that_arrays_of_doubles_hold():
    kernels, several = load_orbit(FRICTION[0]), np.random.default_rng(35).normal(size=(40, 2))
    for array in (*several, np.array([0.1, np.nan]), np.array([np.inf, -np.inf])):
        found = complete_arrays(kernels, {"V": array.astype(object)})
        np.testing.assert_array_equal(found["V"], array)


@pytest.mark.parametrize("name", FRICTION)
def test_a_contradiction_is_refused_on_one_line_that_names_both(name):
    kernels = load_orbit(name)
    for order in permutations({"e2": 1, "us2": 1, "ur2": 3}.items()):
        with pytest.raises(InputError, match="e2 = 1 contradicts ur2 - us2 = 2") as caught:
            complete(kernels, dict(order))
        assert "\n" not in str(caught.value)


def test_what_is_chosen_exceeds_its_bound_and_is_a_short_decimal():
    kernels = load_orbit("dry-friction/symmetric")
    point = complete(kernels, {})
    bounds = [0.0, 0.5, 0.89, 0.9, 1.0, 3.7, *np.random.default_rng(33).uniform(0, 50, 200)]
    for bound in (*bounds, float("nan")):
        found = complete_system(kernels, {**point.values, **point.opened}, {"us2": bound})
        value = found.values["us2"]
        if bound != bound:
            assert value.exact == 1
            continue
        assert float(value) > 1.02 * bound
        assert (10 * value.exact).denominator == 1
        assert float(value) <= max(1.0, 1.1 * bound + 0.1)


def test_a_sum_that_is_open_too_takes_its_least_value():
    kernels = load_orbit("dry-friction/symmetric")
    for given, us1, ur1 in (({}, 1, 1), ({US: 2}, 2, 2), ({UR: 3}, 3, 3), ({E: 3}, 1, 4)):
        point = complete(kernels, given)
        found = complete_system(kernels, {**point.values, **point.opened}, {"us2": 3.0})
        assert (found.values[US].exact, found.values[UR].exact) == (us1, ur1)
        assert found.values["us2"].exact == Fraction(33, 10)
        assert set(found.chosen) == {US, UR, "us2"} - set(given) - ({UR} if E in given else set())


def test_constraints_of_points_that_share_some_parameters():
    """One friction force at rest is that of all points, the other one of each."""
    forces = {"ur1": [0.5], "us1": [0.3], "ur2": [0.5], "us2": [0.3, 0.7]}
    columns = {name: np.array(values) for name, values in forces.items()}
    assert constrained(load_system("dry-friction"), columns).tolist() == [True, False]
