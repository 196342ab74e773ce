"""Frequency responses and backbones: amplitudes along branches, against closed forms."""

from pathlib import Path

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.runtime.errors import InputError

PAGE = Path(__file__).parents[1] / "docs" / "gallery" / "den_hartog.py"


def test_den_hartogs_response() -> None:
    orbit = ns.solve(f"{PAGE}:without-rest")
    branch = ns.continue_orbit(orbit, "W", (0.56, 0.64), points=40)
    W = branch.parameter_values
    R, U = 1 / (1 - W**2), np.tan(np.pi / (2 * W)) / W
    wanted = np.sqrt(R**2 - 0.04 * U**2)
    np.testing.assert_allclose(branch.quantity("amplitude_x"), wanted, rtol=1e-10)
    np.testing.assert_allclose(branch.quantity("frequency"), W, rtol=1e-10)
    with pytest.raises(InputError, match="unknown state 'y'"):
        branch.quantity("amplitude_y")


def test_the_backbone_of_a_conservative_family() -> None:
    """The rigid stop's orbits over their period: amplitudes of both masses are positive."""
    orbit = ns.solve("rigid-stop/one-impact")
    period = float(orbit.period)
    branch = ns.continue_orbit(orbit, "T", (0.98 * period, 1.02 * period), points=12)
    frequency = branch.quantity("frequency")
    np.testing.assert_allclose(frequency * branch.parameter_values, 2 * np.pi, rtol=1e-12)
    found = branch.quantity("amplitude_x1")
    motion = branch.orbit_at(0).motion()
    states = motion(np.linspace(0, motion.period, 20_001))
    place = motion.names.index("x1")
    assert found[0] == pytest.approx(np.ptp(states[:, place]) / 2, rel=1e-6)


def test_a_branch_stays_inside_its_interval_where_the_end_is_singular() -> None:
    """At W = 1/2 the orbit is one of a family: the equations do not determine it there."""
    orbit = ns.solve(f"{PAGE}:without-rest")
    branch = ns.continue_orbit(orbit, "W", (0.5, 0.61))
    assert branch.ends[0] == "end of the interval"
    assert branch.parameter_values.min() == pytest.approx(0.5, abs=1e-3)
    assert branch.parameter_values.min() >= 0.5
