"""The shooting map and its variational, a derivative: of free dwell times and of sections."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import pytest
from mpmath import MPContext

from nonsmooth.runtime.shooting.section_map import section_map
from nonsmooth.runtime.shooting.shooting_map import Phase, applied, shooting_map

COUNT, SIZE = 3, 3  # phases, states


class Data(NamedTuple):
    """A random chain of phases, in doubles."""

    fields: np.ndarray
    rows: np.ndarray
    resets: np.ndarray
    dwell: np.ndarray
    start: np.ndarray


def data_of(seed: int) -> Data:
    """Fields that are not small, boundaries that are not met, resets of full rank."""
    random = np.random.default_rng(seed)
    return Data(
        random.normal(size=(COUNT, SIZE, SIZE + 1)),
        random.normal(size=(COUNT, 1, SIZE + 1)),
        np.eye(SIZE, SIZE + 1) + 0.3 * random.normal(size=(COUNT, SIZE, SIZE + 1)),
        random.uniform(0.3, 1.5, COUNT),
        random.normal(size=SIZE),
    )


def precise(mp: Any, array: np.ndarray) -> np.ndarray:
    """The same doubles as mpmath numbers."""
    return np.vectorize(mp.mpf, otypes=[object])(array)


class Shot(NamedTuple):
    """One chain through one arithmetic: eliminated dwell times, and free ones; maps."""

    following: Any
    free: Any
    maps: list[Any]
    timed: list[Any]


def shot(data: Data, flows: Any, mp: Any) -> Shot:
    unit, start = np.eye(COUNT + SIZE, dtype=int), precise(mp, data.start)[:, None]
    parts = (precise(mp, part) for part in (data.fields, data.rows, data.resets))
    phases = [Phase(*each) for each in zip(*parts, strict=True)]
    following = shooting_map(phases, flows, start, np.eye(SIZE, SIZE + 1, dtype=int))
    free = shooting_map(phases, flows, start, unit[COUNT:], list(unit[:COUNT, None]))
    fields = [phase.field for phase in (*phases[1:], phases[0])]
    behind = map(applied, fields, free.starts[1:])
    passed = list(zip(phases, flows, free.velocities, strict=True))
    maps = [section_map(*part) for part in passed]
    timed = [section_map(*p, b) for p, b in zip(passed, behind, strict=True)]
    return Shot(following, free, maps, timed)


def flow_of(field: np.ndarray, time: Any, mp: Any) -> np.ndarray:
    """The exponential of a field (N, N + 1) over a time, as it acts on (y, 1)."""
    whole = mp.matrix([*field.tolist(), [0] * (SIZE + 1)]) * time
    found = mp.expm(whole, method="taylor").tolist()
    return np.array(found, dtype=object)[:-1]


def in_mpmath(data: Data, mp: Any) -> Shot:
    pairs = zip(precise(mp, data.fields), precise(mp, data.dwell), strict=True)
    flows = [flow_of(field, time, mp) for field, time in pairs]
    return shot(data, flows, mp)


def test_the_variational_is_the_derivative() -> None:
    data, mp = data_of(11), MPContext()
    mp.dps = 50
    found, step = in_mpmath(data, mp).free, mp.mpf(10) ** -20

    def moved(unknown: int, sign: int) -> np.ndarray:
        dwell, start = precise(mp, data.dwell), precise(mp, data.start)
        which = dwell if unknown < COUNT else start
        which[unknown % COUNT] += sign * step
        now = in_mpmath(data._replace(dwell=dwell, start=start), mp).free
        return np.concatenate([*now.residual, now.starts[-1]])[:, 0]

    jacobian = np.concatenate([*found.slopes, found.variational])
    for unknown in range(COUNT + SIZE):
        slope = (moved(unknown, 1) - moved(unknown, -1)) / (2 * step)
        assert max(abs(slope - jacobian[:, unknown])) < mp.mpf(10) ** -25


@pytest.mark.parametrize("seed", [21, 22, 23])
def test_section_maps_are_those_of_motions(seed: int) -> None:
    data, mp = data_of(seed), MPContext()
    mp.dps = 50
    # boundaries that are reached exactly, then motions that are followed to them
    first = in_mpmath(data, mp)
    rows = precise(mp, data.rows)
    for row, value, end in zip(rows, first.free.residual, first.free.ends, strict=True):
        assert abs(value) > 0
        row[0, -1] = -(row[0, :-1] @ end[:, 0])
    data = data._replace(rows=rows)
    found = in_mpmath(data, mp)
    fields, resets = precise(mp, data.fields), precise(mp, data.resets)
    step, limit = mp.mpf(10) ** -20, mp.mpf(10) ** -17
    first_map, second, third = found.maps
    missed = found.following.variational[:, :-1] - third @ second @ first_map
    assert abs(missed).max() < mp.mpf(10) ** -45

    for place in range(COUNT):
        begin = found.free.starts[place][:, 0]
        after = fields[(place + 1) % COUNT]

        def motion(
            start: np.ndarray, place: int = place, after: np.ndarray = after
        ) -> tuple[np.ndarray, np.ndarray]:
            """State behind the boundary, and at the time at which the motion itself is there."""
            time = mp.mpf(data.dwell[place])
            for _ in range(4):
                flow = flow_of(fields[place], time, mp)
                end = flow[:, :-1] @ start + flow[:, -1]
                row, rate = rows[place, 0], fields[place][:, :-1] @ end + fields[place][:, -1]
                time -= (row[:-1] @ end + row[-1]) / (row[:-1] @ rate)
            behind = resets[place][:, :-1] @ end + resets[place][:, -1]
            early = mp.mpf(data.dwell[place]) - time
            speed = after[:, :-1] @ behind + after[:, -1]
            return behind, behind + early * speed  # to the second order of the step

        for k, unit in enumerate(np.eye(SIZE, dtype=int)):
            ahead, back = motion(begin + step * unit), motion(begin - step * unit)
            for one, other, matrix in zip(
                ahead, back, (found.maps[place], found.timed[place]), strict=True
            ):
                assert max(abs((one - other) / (2 * step) - matrix[:, k])) < limit
