"""Modes of structures that are driven, against the exponential in balls."""

import numpy as np
import pytest

from nonsmooth.runtime.model.driven_modes import driven_modes
from nonsmooth.runtime.model.modes import numeric_modes
from nonsmooth.runtime.model.projectors import exponentials_at
from nonsmooth.runtime.model.simple_modes import NumericModes
from nonsmooth.runtime.model.time_functions import functions_at
from tests.model.test_simple_modes import chain


def held(count: int, which: int, damping: float = 0.02, frequency: float = 0.7) -> np.ndarray:
    """A forced chain of which one mass is held; it may drift at a constant velocity."""
    field = chain(count, damping, frequency)
    field[count + which] = 0.0
    field[: 2 * count, -1] += np.where(np.arange(2 * count) < count, 0.0, 0.3)
    field[count + which, -1] = 0.0
    return field


def missed(field: np.ndarray, modes: NumericModes) -> float:
    """Largest error of the modes' sum at several times, in units of what rounding may do."""
    whole, worst = np.vstack([field, np.zeros(field.shape[1])]), 0.0
    fastest = np.abs(np.linalg.eigvals(whole)).max()
    for angle in (1 / 64, 1.0, 16.0, 128.0):
        time = 2.0 ** round(np.log2(angle / fastest))
        wanted = exponentials_at(whole, {time})[time][:-1]
        functions = np.array(functions_at(modes.shapes, modes.exponents, time))
        error = np.abs(np.tensordot(functions, modes.flows, axes=1) - wanted).max()
        allowed = (10 + angle) * len(whole) * max(1, np.abs(wanted).max())
        worst = max(worst, float(error / allowed))
    return worst


@pytest.mark.parametrize(("count", "which"), [(3, 2), (4, 1), (6, 0), (12, 11)])
def test_a_held_mass_and_a_forcing_drive_the_rest(count: int, which: int) -> None:
    field = held(count, which)
    found = driven_modes(field, numeric_modes)
    assert found is not None
    assert found.shapes[0].length == 2  # the held mass keeps its velocity
    assert found.exponents[0].tolist() == [0, 0]
    assert missed(field, found) < 1e-15


def test_what_is_asked_for_takes_this_way(monkeypatch: pytest.MonkeyPatch) -> None:
    """A held mass is no reason to search for clusters in many digits."""
    numeric_modes(held(3, 2))  # whose held mass and forcing are those of the next
    monkeypatch.setattr("nonsmooth.runtime.model.modes._decomposed", None)
    field = held(8, 7)
    assert missed(field, numeric_modes(field)) < 1e-15


def test_resonance_and_what_does_not_drive_are_left_to_clusters() -> None:
    natural = np.sqrt(2 - 2 * np.cos(np.pi / 4))  # of three masses between walls
    assert driven_modes(held(4, 3, damping=0.0, frequency=natural), numeric_modes) is None
    assert driven_modes(held(4, 3, damping=0.0, frequency=natural + 1e-9), numeric_modes) is None
    alone = chain(4, 0.1, 0.7)[:8, [*range(8), 10]]
    assert driven_modes(alone, numeric_modes) is None
