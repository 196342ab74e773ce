"""Modes found numerically, against the exponential of the field at 60 digits."""

import math
from typing import Any

import mpmath
import numpy as np
import pytest

from nonsmooth import InputError
from nonsmooth.runtime.model.modes.numeric_modes import numeric_modes
from nonsmooth.runtime.model.modes.precise_modes import precise_candidates
from nonsmooth.runtime.model.modes.subspace_modes import subspace_modes
from nonsmooth.runtime.model.time_functions import functions_at

pytestmark = pytest.mark.compiled  # much slower, or nothing to compare, without it


def summed(modes: Any, t: float) -> np.ndarray:
    """Flow (N, N + 1) after a time."""
    functions = functions_at(modes.shapes, modes.exponents, t)
    return np.tensordot(np.array(functions), modes.flows, axes=1)


def exact(field: np.ndarray, t: float) -> np.ndarray:
    mp = mpmath.MPContext()
    mp.dps = 60
    size = len(field)
    whole = mp.zeros(size + 1)
    for i in range(size):
        for j in range(size + 1):
            whole[i, j] = mp.mpf(float(field[i, j]))
    found = mp.expm(whole * mp.mpf(t))
    return np.array([[float(found[i, j]) for j in range(size + 1)] for i in range(size)])


def oscillator(mass, damping, stiffness, load) -> np.ndarray:
    """Field (2n, 2n + 1) of M x'' + C x' + K x = f."""
    mass, damping, stiffness = (np.atleast_2d(m) for m in (mass, damping, stiffness))
    size = len(mass)
    field = np.zeros((2 * size, 2 * size + 1))
    field[:size, size : 2 * size] = np.eye(size)
    parts = (-stiffness, -damping, np.reshape(load, (-1, 1)))
    field[size:] = np.linalg.solve(mass, np.hstack(parts).astype(float))
    return field


def forced(frequency: float, damping: float = 0.0) -> np.ndarray:
    """x'' + damping x' + x = c, with c and s turning."""
    field = np.zeros((4, 5))
    field[0, 1], field[1, :3] = 1, (-1, -damping, 1)
    field[2, 3], field[3, 2] = -frequency, frequency
    return field


def turned(field: np.ndarray) -> np.ndarray:
    """The same motion in other coordinates: no entry is zero any more."""
    basis = np.linalg.qr(np.random.default_rng(5).normal(size=(len(field), len(field))))[0]
    return np.hstack([basis @ field[:, :-1] @ basis.T, basis @ field[:, -1:]])


CHAIN = np.array([[2.0, -1, 0], [-1, 2, -1], [0, -1, 2]])
FREE = np.array([[1.0, -1, 0], [-1, 2, -1], [0, -1, 1]])
JORDAN = np.array([[-1, 1, 0, 0.0], [0, -1, 1, 0], [0, 0, -1, 1]])
NEAR = np.array([[-1, 1, 0, 0.0], [0, -1.00001, 1, 0], [0, 0, -0.99999, 1]])

FIELDS = {
    "underdamped": oscillator(1, 0.2, 1, 0.3),
    "overdamped": oscillator(1, 3, 1, 0.3),
    "critical": oscillator(1, 2.6, 1.69, 0.3),
    "negative damping": oscillator(1, -0.1, 1, 0.3),
    "bouncing ball": np.array([[0, 1, 0], [0, 0, -9.81]]),
    "drag without spring": oscillator(1, 0.5, 0, 2),
    "at rest": np.zeros((2, 3)),
    "chain": oscillator(np.eye(3), 0.1 * CHAIN, CHAIN, [1, 0, 0]),
    "free chain": oscillator(np.diag([1, 2, 3]), 0 * FREE, FREE, [1, 0, 0]),
    "twice the same": oscillator(np.eye(2), 0.1 * np.eye(2), np.eye(2), [1, 2]),
    "light and stiff": oscillator(1e-3, 0, 100, -9.81e-3),
    "two speeds": oscillator(np.eye(2), np.diag([1e4, 0.1]), [[2e3, -1], [-1, 2]], [1, 1]),
    "forced": forced(0.7, 0.1),
    "resonance": forced(1.0),
    "three equal": JORDAN,
    "three equal, turned": turned(JORDAN),
    "three nearly equal": turned(NEAR),
}


@pytest.mark.parametrize("name", FIELDS)
def test_the_modes_sum_up_to_the_exponential(name: str) -> None:
    field = FIELDS[name]
    modes = numeric_modes(field)
    speed = np.abs(np.linalg.eigvals(field[:, :-1])).max() or 1.0
    for angle in (0.0, 0.01, 1.0, 12.0, 100.0):
        wanted = exact(field, angle / speed)
        error = np.abs(summed(modes, angle / speed) - wanted).max()
        assert error <= 4e-15 * (10 + angle) * max(1, np.abs(wanted).max())


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("distance", 10.0 ** -np.arange(1, 14))
def test_near_critical_damping_loses_no_digits(distance: float, sign: int) -> None:
    field = oscillator(1, 2 * (1 + sign * distance), 1, 0.7)
    modes = numeric_modes(field)
    for t in (0.1, 1.0, 10.0, 100.0):
        assert np.abs(summed(modes, t) - exact(field, t)).max() < 3e-13


def test_random_fields() -> None:
    random = np.random.default_rng(11)
    for size in range(1, 9):
        field = random.normal(size=(size, size + 1))
        modes = numeric_modes(field)
        assert sum(len(shape.places) for shape in modes.shapes) == size + 1
        for t in (0.1, 2.0):
            wanted = exact(field, t)
            assert np.abs(summed(modes, t) - wanted).max() < 1e-13 * max(1, np.abs(wanted).max())


@pytest.mark.parametrize(
    ("name", "shapes"),
    [
        ("underdamped", [(1, False), (1, True)]),
        ("critical", [(1, False), (2, False)]),
        ("bouncing ball", [(3, False)]),
        ("free chain", [(3, False), (1, True), (1, True)]),
        ("twice the same", [(1, False), (1, True)]),
        ("resonance", [(1, False), (2, True)]),
        ("three equal, turned", [(1, False), (3, False)]),
    ],
)
def test_equal_eigenvalues_are_one_mode(name: str, shapes: list) -> None:
    modes = numeric_modes(FIELDS[name])
    assert [(shape.length, shape.oscillates) for shape in modes.shapes] == shapes


@pytest.mark.parametrize("name", FIELDS)
def test_the_first_mode_is_constant_and_none_drifts_by_rounding(name: str) -> None:
    modes = numeric_modes(FIELDS[name])
    assert tuple(modes.exponents[0]) == (0, 0)
    assert not modes.shapes[0].oscillates
    if name in ("forced", "resonance", "free chain", "light and stiff"):
        turning = modes.exponents[modes.exponents[:, 1] != 0]
        assert (turning[:, 0] == 0).any()


def test_eigenvalues_that_cannot_be_told_apart() -> None:
    """A Jordan block of eleven, moved by 1e-13: eigenvalues 0.07 from each other."""
    field = np.diag(np.full(11, 1.0), 1)[:11]
    field[-1, 0] = 1e-13
    field = turned(field)
    with pytest.raises(InputError, match="neither equal nor apart"):
        numeric_modes(field)


def soft(stiffness: float, damping: float = 0.0, load: float = 0.0, frequency: float = 1.7):
    """x'' + c x' + k x = 5 cos(w t) + load, with cosine and sine turning."""
    field = np.zeros((4, 5))
    field[0, 1], field[1] = 1, (-stiffness, -damping, 5, 0, load)
    field[2, 3], field[3, 2] = -frequency, frequency
    return field


@pytest.mark.parametrize("stiffness", [0.0, *10.0 ** -np.arange(20, -1, -2.5)])
def test_no_stiffness_is_too_soft(stiffness: float) -> None:
    """The cluster {i root k, -i root k, 0} is taken apart, or together, as it has to be."""
    for damping in (0.0, stiffness, 2 * math.sqrt(stiffness)):
        modes = numeric_modes(soft(stiffness, damping))
        for t in (0.1, 1.0, 10.0):
            wanted = exact(soft(stiffness, damping), t)
            assert np.abs(summed(modes, t) - wanted).max() < 1e-13 * np.abs(wanted).max()


@pytest.mark.parametrize("seed", [*range(6), 175, 192])
def test_free_chains_are_never_refused(seed: int) -> None:
    """Full mass matrices, rigid-body modes, proportional damping, forcing or load.

    An eigenvalue is known to the rounding of the field, and is wrong for all of the time. Of
    seeds 175 and 192 rounding takes the rigid body's eigenvalues apart, to a pair of 1e-8.
    """
    random = np.random.default_rng(seed)
    size = int(random.integers(2, 5))
    factor = random.normal(size=(size, size)) / 4
    mass = np.eye(size) + factor @ factor.T
    links = np.diff(np.eye(size), axis=0)
    stiffness = links.T @ np.diag(random.uniform(0.1, 30, size - 1)) @ links
    a, b = random.choice([0.0, 1 / 16, 0.3]), random.choice([0.0, 0.1])
    field = oscillator(mass, a * stiffness + b * mass, stiffness, random.normal(size=size))
    modes = numeric_modes(field)
    terms = np.abs(modes.flows).sum(axis=0).max()
    for t in (0.1, 1.0, 5.0):
        angle = t * np.abs(field).sum(axis=1).max()
        rounding = np.finfo(float).eps * (1 + angle) * terms  # at most 6 of them were measured
        assert np.abs(summed(modes, t) - exact(field, t)).max() < 20 * rounding


@pytest.mark.parametrize("rate", [1e-10, 1e-11, 1e-12, 1e-13])
def test_what_decays_slowly_is_not_taken_for_a_constant(rate):
    """Over the longest search its motion changes by more than rounding."""
    matrix = np.array([[-rate, 1.0, 0.0], [0.0, -rate, 0.0], [0.0, 0.0, -1.0]])
    quick = subspace_modes(matrix, np.ones((3, 3), dtype=bool))
    found = [quick[0].exponents[:, 0].tolist()]
    for clusters in precise_candidates(matrix, 1.0):
        found.append([cluster.poles[0].real for cluster in clusters])
    for centres in found:
        assert min(centres, key=abs) == pytest.approx(-rate, rel=1e-2)
    assert len(found) > 2
