"""Shooting maps with their derivatives, against the exponential in many digits."""

from typing import Any

import mpmath
import numpy as np
import pytest

from nonsmooth.runtime.model.kernels import compiled_engine, load_system
from nonsmooth.runtime.model.piecewise import piecewise, tables_at
from nonsmooth.runtime.shooting.shooting_map import (
    Numbers,
    dependent,
    itinerary_shape,
    shooting_derivatives,
)
from tests.declared_documents import chain
from tests.engines import with_both

PHASES = [("free", "left-reaches"), ("left", "left-leaves")]
POINT = np.array([1.1, 25.0])
PLACE = 1  # the parameter that changes
DWELL = np.array([0.83, 0.41])


def cycle() -> Any:
    system = piecewise(chain(), {"k": POINT[0], "kappa": POINT[1]})
    return itinerary_shape(system.structure, PHASES)


def tables(points: np.ndarray) -> Numbers:
    return Numbers(*tables_at(load_system(chain()), points))


def changes(point: np.ndarray, tiny: float = 1e-30) -> Numbers:
    moved = point.astype(complex)
    moved[PLACE] += 1j * tiny
    return Numbers(*(part.imag / tiny for part in tables(moved[None])[:3]))


def start_of(shape: Any) -> np.ndarray:
    return np.random.default_rng(4).normal(size=len(shape.structure.states))


def exact(shape: Any, dwell: list, start: list, point: list) -> tuple[list, list]:
    """Boundary functions at the ends of the phases and the last state, at many digits."""
    kernels, mp = load_system(chain()), mpmath.mp
    size = len(start)
    fields, rows, resets = (
        kernels.source(name)(point, lib=Lib) for name in ("fields", "rows", "resets")
    )
    state, values = mp.matrix([*start, 1]), []
    for place, configuration in enumerate(shape.configurations):
        matrix = mp.zeros(size + 1)
        for i in range(size):
            for j in range(size + 1):
                matrix[i, j] = fields[configuration * size + i][j]
        end = mp.expm(matrix * dwell[place]) * state
        row = rows[shape.rows[place]]
        values.append(sum(row[j] * end[j] for j in range(size + 1)))
        reset = resets[shape.transitions[place].reset * size :][:size]
        behind = [sum(reset[i][j] * end[j] for j in range(size + 1)) for i in range(size)]
        state = mp.matrix([*behind, 1])
    return values, [state[i] for i in range(size)]


class Lib:
    """What the tables of the chain ask of an arithmetic."""

    @staticmethod
    def rational(p: int, q: int) -> mpmath.mpf:
        return mpmath.mpf(p) / q


@pytest.mark.slow
def test_they_are_the_derivatives_of_the_exponential() -> None:
    shape = cycle()
    start, size = start_of(shape), len(shape.structure.states)
    found = shooting_derivatives(
        shape, tables(POINT[None]), DWELL[None], start[None], changes(POINT)
    )
    with mpmath.workdps(50):
        step = mpmath.mpf(10) ** -20
        unknowns = [mpmath.mpf(float(x)) for x in (*DWELL, *start, POINT[PLACE])]

        def shot(values: list) -> np.ndarray:
            point = [mpmath.mpf(float(x)) for x in POINT]
            point[PLACE] = values[-1]
            residual, state = exact(shape, values[:2], values[2:-1], point)
            return np.array([*residual, *state])

        here = shot(unknowns)
        for column in range(len(unknowns)):
            ahead = shot([x + step * (k == column) for k, x in enumerate(unknowns)])
            behind = shot([x - step * (k == column) for k, x in enumerate(unknowns)])
            wanted = ((ahead - behind) / (2 * step)).astype(float)
            mine = np.concatenate([found.slopes[0, :, column], found.variational[0, :, column]])
            np.testing.assert_allclose(mine, wanted, rtol=1e-12, atol=1e-12)
    mine = np.concatenate([found.residual[0], found.starts[0, -1]])
    np.testing.assert_allclose(mine, here.astype(float), rtol=1e-13, atol=1e-13)
    assert found.ends.shape == (1, 2, size)


@pytest.mark.compiled
def test_c_and_numpy_agree() -> None:
    shape = cycle()
    random = np.random.default_rng(8)
    points = POINT + 0.1 * random.normal(size=(5, 2))
    dwell = random.uniform(0.01, 9.0, size=(5, 2))
    start = random.normal(size=(5, len(shape.structure.states)))
    varied = Numbers(*(np.concatenate([changes(p)[k] for p in points]) for k in range(3)))
    for given in (None, varied):
        compiled, plain = with_both(
            shooting_derivatives, shape, tables(points), dwell, start, given
        )
        for mine, other in zip(compiled, plain, strict=True):
            assert mine.shape == other.shape
            np.testing.assert_allclose(mine, other, rtol=1e-11, atol=1e-11 * np.abs(other).max())


def test_dwell_times_that_follow_the_start_keep_the_boundaries_reached() -> None:
    shape = cycle()
    start = start_of(shape)[None]
    found = shooting_derivatives(shape, tables(POINT[None]), DWELL[None], start)
    change = 1e-6 * np.random.default_rng(1).normal(size=start.shape)
    slopes, by_start = found.slopes[0, :, :2], found.slopes[0, :, 2:]
    times = DWELL - np.linalg.solve(slopes, by_start @ change[0])
    moved = shooting_derivatives(shape, tables(POINT[None]), times[None], start + change)
    np.testing.assert_allclose(moved.residual, found.residual, atol=1e-9)
    expected = dependent(found).variational[0, :, :-1] @ change[0]
    np.testing.assert_allclose((moved.starts - found.starts)[0, -1], expected, atol=1e-9)


def test_a_boundary_that_is_touched_has_no_derivatives() -> None:
    """An infinite change of a dwell time that moves nothing is no number, without a warning."""
    shape = cycle()
    found = shooting_derivatives(shape, tables(POINT[None]), DWELL[None], start_of(shape)[None])
    slopes, variational = found.slopes.copy(), found.variational.copy()
    slopes[0, :, 0] = variational[0, :, 0] = 0.0
    touched = found._replace(slopes=slopes, variational=variational)
    assert not np.isfinite(dependent(touched).variational).any()


def test_units_change_no_digit() -> None:
    """Powers of two as units of the states: the exponential is balanced."""
    shape = cycle()
    start, numbers = start_of(shape), tables(POINT[None])
    units = 2.0 ** np.array([30, -30, 3, 40, 0, -7])[: len(start)]
    scale = np.append(units, 1.0)
    scaled = Numbers(
        units[:, None] * numbers.fields / scale, numbers.rows / scale,
        units[:, None] * numbers.resets / scale,
    )  # fmt: skip
    own = shooting_derivatives(shape, numbers, DWELL[None], start[None])
    other = shooting_derivatives(shape, scaled, DWELL[None], (units * start)[None])
    np.testing.assert_allclose(other.starts / units, own.starts, rtol=1e-13, atol=1e-13)


def test_what_is_not_finite_or_too_long_is_nan() -> None:
    shape = cycle()
    start = start_of(shape)[None]
    for dwell in ([[np.nan, 0.4]], [[0.8, np.inf]], [[1e12, 0.4]]):
        found = shooting_derivatives(shape, tables(POINT[None]), np.array(dwell), start)
        assert np.isnan(found.variational).any()
        assert np.isnan(found.starts[0, -1]).any()


@pytest.mark.compiled
def test_arrays_of_wrong_sizes_are_refused() -> None:
    engine = compiled_engine()
    assert engine is not None
    sizes = [2, 12, 6, 12, 0, 0, 0, 6, 4, 4, 2, 8, 8]  # two phases of two states
    arrays = [np.zeros(size) for size in sizes]
    engine.shoot(1, 2, 2, *arrays)
    for place, size in enumerate(sizes):
        wrong = [np.zeros(size + 1) if k == place else a for k, a in enumerate(arrays)]
        with pytest.raises(ValueError, match="wrong size"):
            engine.shoot(1, 2, 2, *wrong)
    for counts in ((-1, 2, 2), (1, 0, 2), (1, 2, 0)):
        with pytest.raises(ValueError, match="wrong numbers"):
            engine.shoot(*counts, *arrays)
