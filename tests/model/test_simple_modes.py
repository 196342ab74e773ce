"""Modes of many configurations at once, against the exponential in balls."""

import numpy as np
import pytest

from nonsmooth.runtime.model.balancing import balanced
from nonsmooth.runtime.model.modes import grouped_modes
from nonsmooth.runtime.model.projectors import exponentials_at
from nonsmooth.runtime.model.simple_modes import simple_modes
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


def fields(seed: int, count: int) -> list[np.ndarray]:
    random = np.random.default_rng(seed)
    size = int(random.integers(2, 12))
    damping = random.choice([0.0, 0.02, 0.3])
    return [
        chain(size, damping, random.uniform(0.3, 2), random.choice([1.0, 1e-4]))
        if k % 2
        else random.normal(size=(2 * size + 2, 2 * size + 3))
        for k in range(count)
    ]


def without_rows(stack: np.ndarray) -> np.ndarray:
    return np.zeros((len(stack), 0, stack.shape[2]))


@pytest.mark.parametrize("seed", range(6))
def test_they_sum_up_to_the_exponential(seed: int) -> None:
    stack = np.array(fields(seed, 6))
    groups = simple_modes(stack)
    assert sum(len(group.places) for group in groups) >= 2
    for group in groups:
        for place, exponents, flows in zip(
            group.places, group.exponents, group.flows[0], strict=True
        ):
            whole = np.vstack([stack[place], np.zeros(stack.shape[2])])
            fastest = np.abs(np.linalg.eigvals(whole)).max()
            growth = max(exponents[:, 0].max(), 0.0)
            for angle in (1 / 64, 1.0, 16.0, 128.0):
                time = 2.0 ** round(np.log2(angle / fastest))
                if growth * time > 50:
                    continue
                wanted = exponentials_at(whole, {time})[time][:-1]
                functions = np.array(functions_at(group.shapes, exponents, time))
                error = np.abs(np.tensordot(functions, flows, axes=1) - wanted).max()
                assert error <= 1e-15 * (10 + angle) * len(whole) * max(1, np.abs(wanted).max())


@pytest.mark.parametrize("seed", range(4))
def test_no_digit_depends_on_what_else_is_in_the_stack(seed: int) -> None:
    stack = np.array(fields(seed, 9))
    for group in grouped_modes(stack, without_rows(stack)):
        for row, place in enumerate(group.places.tolist()):
            one = stack[place : place + 1]
            (alone,) = grouped_modes(one, without_rows(one))
            assert alone.shapes == group.shapes
            np.testing.assert_array_equal(alone.exponents[0], group.exponents[row])
            np.testing.assert_array_equal(alone.flows[0][0], group.flows[0][row])


def test_equal_and_nearly_equal_eigenvalues_are_left_to_clusters() -> None:
    resonance, near = chain(1, 0.0, np.sqrt(2.0)), chain(1, 0.0, np.sqrt(2.0) + 1e-6)
    simple = chain(1, 0.0, 1.2)
    groups = simple_modes(np.array([resonance, simple, near]))
    assert [group.places.tolist() for group in groups] == [[1]]


def test_a_configuration_without_numbers_spoils_no_other() -> None:
    stack = np.array([chain(2, 0.1, 0.5 + 0.1 * k) for k in range(6)])
    stack[3, 0, 0] = np.inf
    groups = grouped_modes(stack, without_rows(stack))
    found = {place: group for group in groups for place in group.places.tolist()}
    assert sorted(found) == list(range(6))
    for place, group in found.items():
        row = group.places.tolist().index(place)
        assert np.isfinite(group.flows[0][row]).all() == (place != 3)


def test_balanced_matrices_are_similar_and_their_rows_like_their_columns() -> None:
    random = np.random.default_rng(3)
    matrices = random.normal(size=(5, 7, 7)) * 10.0 ** random.integers(-9, 9, size=(5, 7, 7))
    scaled, units = balanced(matrices)
    np.testing.assert_array_equal(scaled, matrices * units[:, None] / units[:, :, None])
    np.testing.assert_array_equal(np.log2(units) % 1, 0)
    rows, columns = np.abs(scaled).max(axis=2), np.abs(scaled).max(axis=1)
    assert (np.abs(np.log2(rows / columns)) < 4).all()
