"""Modes of driven structures and of many configurations at once, against exponentials in balls."""

import numpy as np
import pytest

from nonsmooth.runtime.model.modes.numeric_modes import grouped_modes, numeric_modes
from nonsmooth.runtime.model.modes.precise_modes import exponentials_at
from nonsmooth.runtime.model.time_functions import functions_at


def chain(count: int, damping: float, frequency: float, unit: float = 1.0) -> np.ndarray:
    """Field of a chain of masses, the first one forced; times are in a unit."""
    field = np.zeros((2 * count + 2, 2 * count + 3))
    stiffness = 2 * np.eye(count) - np.eye(count, k=1) - np.eye(count, k=-1)
    moved = slice(count, 2 * count)
    field[:count, moved] = np.eye(count)
    field[moved, :count] = -stiffness / unit**2
    field[moved, moved] = -damping * (stiffness + np.eye(count)) / unit
    field[count, -3] = 1.0 / unit**2
    field[-2, -2], field[-1, -3] = -frequency / unit, frequency / unit
    return field


def held(count: int, which: int, damping: float = 0.02, frequency: float = 0.7) -> np.ndarray:
    """A forced chain of which one mass is held; it may drift at a constant velocity."""
    field = chain(count, damping, frequency)
    field[count + which] = 0.0
    field[: 2 * count, -1] += np.where(np.arange(2 * count) < count, 0.0, 0.3)
    field[count + which, -1] = 0.0
    return field


def fields(seed: int, count: int) -> np.ndarray:
    random = np.random.default_rng(seed)
    size = int(random.integers(2, 8))
    damping = random.choice([0.0, 0.02, 0.3])
    found = [
        chain(size, damping, random.uniform(0.3, 2), random.choice([1.0, 1e-4]))
        if k % 2
        else random.normal(size=(2 * size + 2, 2 * size + 3))
        for k in range(count)
    ]
    return np.array(found)


def missed(field: np.ndarray, shapes: tuple, exponents: np.ndarray, flows: np.ndarray) -> float:
    """Largest error of the modes' sum at several times, in units of what rounding may do."""
    whole, worst = np.vstack([field, np.zeros(field.shape[1])]), 0.0
    fastest = np.abs(np.linalg.eigvals(whole)).max()
    for angle in (1 / 64, 1.0, 16.0, 128.0):
        time = 2.0 ** round(np.log2(angle / fastest))
        if exponents[:, 0].max() * time > 50:
            continue
        wanted = exponentials_at(whole, {time})[time][:-1]
        functions = np.array(functions_at(shapes, exponents, time))
        error = np.abs(np.tensordot(functions, flows, axes=1) - wanted).max()
        allowed = (10 + angle) * len(whole) * max(1, np.abs(wanted).max())
        worst = max(worst, float(error / allowed))
    return worst


@pytest.mark.parametrize(("count", "which"), [(3, 2), (4, 1), (6, 0), (8, 7)])
def test_a_held_mass_and_a_forcing_drive_the_rest(
    count: int, which: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """They are no reason to search for clusters in many digits."""
    numeric_modes(held(2, 1))  # whose held mass and forcing are those of the others
    monkeypatch.setattr("nonsmooth.runtime.model.modes.numeric_modes.best_modes", None)
    field = held(count, which)
    modes = numeric_modes(field)
    assert modes.shapes[0].length == 2  # the held mass keeps its velocity
    assert modes.exponents[0].tolist() == [0, 0]
    assert missed(field, *modes) < 1e-15


NATURAL = np.sqrt(2 - 2 * np.cos(np.pi / 4))  # of three masses between walls


@pytest.mark.parametrize("beside", [0.0, 1e-9])
def test_resonance_is_left_to_clusters(beside: float) -> None:
    field = held(4, 3, damping=0.0, frequency=NATURAL + beside)
    assert missed(field, *numeric_modes(field)) < 1e-14


def grouped(stack: np.ndarray) -> list:
    return grouped_modes(stack, np.zeros((len(stack), 0, stack.shape[2])))


@pytest.mark.parametrize("seed", range(6))
def test_they_sum_up_to_the_exponential_whatever_else_is_in_the_stack(seed: int) -> None:
    stack = fields(seed, 7)
    for group in grouped(stack):
        for row, place in enumerate(group.places.tolist()):
            exponents, flows = group.exponents[row], group.flows[0][row]
            assert missed(stack[place], group.shapes, exponents, flows) < 1e-15
            (alone,) = grouped(stack[place : place + 1])
            assert alone.shapes == group.shapes
            np.testing.assert_array_equal(alone.exponents[0], exponents)
            np.testing.assert_array_equal(alone.flows[0][0], flows)


def test_neither_equal_eigenvalues_nor_none_spoil_others() -> None:
    stack = np.array([chain(2, 0.1, 0.5 + 0.1 * k) for k in range(8)])
    stack[3, 0, 0] = np.inf
    stack[5], stack[6] = (chain(2, 0.0, 1.0 + beside) for beside in (0.0, 1e-6))  # resonance
    found = {place: (group, row) for group in grouped(stack)
             for row, place in enumerate(group.places.tolist())}  # fmt: skip
    assert sorted(found) == list(range(8))
    for place, (group, row) in found.items():
        flows = group.flows[0][row]
        assert np.isfinite(flows).all() == (place != 3)
        if place != 3:
            assert missed(stack[place], group.shapes, group.exponents[row], flows) < 1e-14
