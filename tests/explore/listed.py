"""What a list of orbits promises: each is a motion that goes around once, and is there once."""

import numpy as np
import pytest

import nonsmooth as ns


def same_motion(one, other):
    """Whether two orbits pass through the same states where their phases begin."""
    if not np.isclose(one.period, other.period, rtol=1e-6):
        return False
    first, second = (
        orbit.states[np.roll(orbit.dwell_times > 1e-9 * orbit.period, 1)] for orbit in (one, other)
    )
    size = np.abs(np.concatenate([first, second])).max(axis=0)
    near = (np.abs(first[:, None] - second) <= 1e-6 * size).all(axis=-1)
    return bool(near.any(axis=0).all() and near.any(axis=1).all())


def check_orbit(system, entry):
    """It is its motion, told from its first phase on, and goes around once."""
    orbit, period = entry.orbit, float(entry.period)
    assert orbit.converged
    assert orbit.residual < 1e-11
    assert orbit.admissibility.verdict is True
    count, moves = len(entry.itinerary), orbit.trajectory(2)
    turned = (entry.itinerary[k:] + entry.itinerary[:k] for k in range(count))
    assert entry.itinerary == min(turned), "it is told from elsewhere, and may be listed twice"
    times = np.linspace(0, period, 50, endpoint=False)
    states = moves(times)
    scale = np.abs(states).max(axis=0)
    scale[scale == 0] = 1
    for turns in range(2, 1 + max(count, *entry.forcing_periods, 1)):
        moved = np.abs(moves(times + period / turns) - states) / scale
        assert moved.max() > 1e-6, "it goes around more than once"
    end = (1 - 1e-9) * period
    first, grown = entry.itinerary[0][0], max(1, np.abs(orbit.multipliers).max())
    motion = ns.simulate(system, orbit.parameters, orbit.states[0], first, until=end)
    missed = np.abs(motion(end) - moves(end)) / scale
    assert missed.max() < 1e-9 * grown
    if orbit.dwell_times.min() > 1e-9 * period:
        assert list(motion.configurations) == [c for c, _ in entry.itinerary]
        assert list(motion.boundaries[1:]) == [(b,) for _, b in entry.itinerary[:-1]]
        np.testing.assert_allclose(
            np.diff(motion.times), orbit.dwell_times[:-1], rtol=0, atol=1e-9 * grown * period
        )


def check_listed(system, found):
    """Each orbit alone, in their order, and what becomes of all starts."""
    assert found.orbits
    orbits = [entry.orbit for entry in found.orbits]
    for place, entry in enumerate(found.orbits):
        check_orbit(system, entry)
        assert not any(same_motion(entry.orbit, other) for other in orbits[:place])
    counts = [entry.starts for entry in found.orbits]
    assert counts == sorted(counts, reverse=True)
    assert counts == [(found.labels == place).sum() for place in range(len(counts))]
    every = len(counts) + len(found.equilibria)
    assert set(found.labels.tolist()) <= {*range(every), *found.outcomes}
    shares = [entry.share for entry in (*found.orbits, *found.equilibria)]
    assert sum(shares) + sum(found.outcomes.values()) == pytest.approx(1, abs=1e-12)
