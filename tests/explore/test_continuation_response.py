"""Frequency responses and backbones: amplitudes along branches, against closed forms."""

import numpy as np
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth import InputError, observe
from nonsmooth.derive import SoftStop
from tests.one_mass import one_mass
from tests.places import GALLERY
from tests.two_masses import STICKING

PAGE = GALLERY / "den_hartog.py"


@pytest.mark.slow
def test_den_hartogs_response():
    orbit = ns.solve(f"{PAGE}:without-rest")
    branch = ns.continue_orbit(orbit, "W", (0.56, 0.64), points=40)
    W = branch.parameter_values
    R, U = 1 / (1 - W**2), np.tan(np.pi / (2 * W)) / W
    wanted = np.sqrt(R**2 - 0.04 * U**2)
    np.testing.assert_allclose(branch.quantity("amplitude_x"), wanted, rtol=1e-10)
    np.testing.assert_allclose(branch.quantity("frequency"), W, rtol=1e-10)
    with pytest.raises(InputError, match="unknown state 'y'"):
        branch.quantity("amplitude_y")


def test_the_backbone_of_a_conservative_family():
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


def test_a_branch_stays_inside_its_interval_where_the_end_is_singular():
    """At W = 1/2 the orbit is one of a family: the equations do not determine it there."""
    orbit = ns.solve(f"{PAGE}:without-rest")
    branch = ns.continue_orbit(orbit, "W", (0.5, 0.61))
    assert branch.ends[0] == "end of the interval"
    assert branch.parameter_values.min() == pytest.approx(0.5, abs=5e-5)
    assert branch.parameter_values.min() >= 0.5


def soft_stop():
    """A mass 2 on a spring 2 that meets a stop of stiffness 6 at x = 1, over its period."""
    stop = SoftStop("x", at=1, stiffness=sp.Symbol("k"), name="stop")
    system = one_mass("soft-stop", stop, mass=2, stiffness=2)
    motion = ns.simulate(system, {"k": 6}, [0, 1.5], transitions=20)
    phases, dwell, start = ns.itinerary_of(motion)
    orbit = ns.solve(
        system,
        {"k": 6},
        [*dwell, *start],
        itinerary=phases,
        given={"period": repr(float(dwell.sum()))},
    )
    return ns.continue_orbit(orbit, "period", (4.2, 6.2), step=0.05)


def test_frequency_and_energy_in_closed_form():
    branch = soft_stop()
    energy = branch.quantity("energy")  # for the mass 1
    rate, centre = 2.0, 0.75
    speed = np.sqrt(2 * energy - 1)
    free = np.pi + 2 * np.arcsin(1 / np.sqrt(2 * energy))
    contact = 2 / rate * np.arctan2(speed / rate, 1 - centre)
    assert np.ptp(energy) > 1
    np.testing.assert_allclose(branch.period, free + contact, rtol=1e-9)


@pytest.mark.parametrize("name", ["rigid-stop/one-impact", "elastic-stop/one-contact"])
def test_energies_of_two_masses(name):
    branch = ns.continue_orbit(ns.solve(name), "T", (6.2, 6.35), step=0.2)
    for found, place in zip(branch.quantity("energy"), range(len(branch)), strict=True):
        orbit = branch.orbit_at(place)
        m1, m2, k1, k2 = (orbit.values[p] for p in ("m1", "m2", "k1", "k2"))
        k3 = orbit.values.get("k3", 0.0)
        x1, x2, v1, v2 = orbit.motion()(0.3 * orbit.period)
        pressed = k3 * max(x1 - 1, 0) ** 2
        doubled = m1 * v1**2 + m2 * v2**2 + k1 * (x1 - x2) ** 2 + k2 * x2**2 + pressed
        assert found == pytest.approx(doubled / (2 * m1), rel=1e-8)


def test_no_energy_is_kept():
    for orbit, name, interval in (
        (ns.solve("dry-friction/global-stick", {"us1": 1, "us2": 1}), "V", (0.99, 1.01)),
        (ns.solve(f"{PAGE}:without-rest"), "W", (0.59, 0.61)),
    ):
        branch = ns.continue_orbit(orbit, name, interval, points=8)
        with pytest.raises(InputError, match="no energy is kept along"):
            branch.quantity("energy")


@pytest.mark.slow
def test_picture_of_frequency_over_energy():
    pytest.importorskip("matplotlib")
    branch = soft_stop()
    (axes,) = branch.plot("frequency", over="energy").axes
    assert (axes.get_xlabel()[:6], axes.get_ylabel()[:9]) == ("energy", "frequency")
    assert axes.get_xscale() == "log"
    drawn = np.concatenate([line.get_xydata() for line in axes.lines])
    wanted = np.column_stack([branch.quantity("energy"), branch.quantity("frequency")])
    assert {*map(tuple, wanted)} <= {*map(tuple, drawn)}
    with pytest.raises(InputError, match="unknown quantity 'speed'"):
        branch.plot("frequency", over="speed")


def test_a_picture_changes_its_style_at_the_event():
    """Up to a border collision orbits are motions: no part of the picture says otherwise."""
    pytest.importorskip("matplotlib")
    branch = ns.continue_orbit(ns.solve("dry-friction/symmetric"), "V", (0.6, 1.2), step=0.2)
    (axes,) = branch.plot("tau").axes
    ends = {line.get_label(): line.get_xdata() for line in axes.lines}
    grazing, flip = (event.value for event in branch.events)
    assert (ends["not admissible"].max(), ends["unstable"].min()) == (grazing, grazing)
    assert (ends["unstable"].max(), ends["stable"].min()) == (flip, flip)


def test_an_amplitude_where_a_phase_vanishes():
    """The last orbit of the branch has a phase that takes no time; its neighbours tell the rest."""
    motion = ns.simulate("dry-friction", STICKING, [0, 0, 0, 0], transitions=400)
    orbit = ns.solve("dry-friction", STICKING, itinerary=ns.itinerary_of(motion))
    branch = ns.continue_orbit(orbit, "ur1", (2.5, 4.1), points=40)
    assert abs(branch.unknowns[:, :4]).min() < 1e-12
    found = branch.quantity("amplitude_x1")
    assert np.isfinite(found).all()
    place = len(branch) // 2
    wanted = observe(branch.orbit_at(place).trajectory())
    swing = wanted.maxima["x1"].value - wanted.minima["x1"].value
    assert found[place] == pytest.approx(swing / 2, rel=1e-9)
    assert np.abs(np.diff(found)).max() < 0.1
