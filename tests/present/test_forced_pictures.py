"""Forced systems as they are drawn: strobed sweeps, and frequency responses by default."""

from functools import cache

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth import InputError, sweep
from tests.core.test_result_files import file_of
from tests.places import GALLERY

PAGE = str(GALLERY / "impact_oscillator.py")


@pytest.mark.parametrize("phase", [0.0, 1.0, 4.0])
def test_without_contact_a_strobe_shows_the_closed_form(phase, tmp_path):
    """x'' + x = cos(w t) from x = g, v = 0 is x = g cos(w t), far from the stop."""
    values = np.array([1.7, 2.4])
    for place, w in enumerate(values):
        gain = 1 / (1 - w**2)
        diagram = sweep(
            PAGE, {"r": "0.8", "sigma": 50}, "w", values[place : place + 1],
            {"x": gain, "v": 0}, state="x", phase=phase, transient=7, samples=5,
        )  # fmt: skip
        np.testing.assert_allclose(diagram.samples, gain * np.cos(phase), rtol=0, atol=1e-11)
        diagram.save(tmp_path / "sweep.json")
        read = ns.load(tmp_path / "sweep.json")
        np.testing.assert_array_equal(read.samples, diagram.samples)
        assert (read.phase, read.configuration, read.done) == (phase, None, 1)


@pytest.mark.parametrize(
    ("changes", "match"),
    [
        ({"phase": None}, "give one of them"),
        ({"configuration": "free"}, "give one of them"),
        ({"name": "W"}, "unknown parameter 'W'"),
        ({"parameters": {"r": "0.8"}}, "needs a value for: sigma"),
        ({"threads": 0}, "threads = 0"),
        ({"values": [-2.0]}, "for no value of w"),
        ({"system": "rigid-stop", "parameters": {}, "start": {}}, "has no forcing"),
    ],
)
def test_wrong_strobes(changes, match):
    arguments = {
        "system": PAGE,
        "parameters": {"r": "0.8", "sigma": 50},
        "name": "w",
        "values": [2.0],
        "start": {"x": 0, "v": 0},
        "state": "x" if "system" not in changes else "x1",
        "phase": 0.0,
    }
    with pytest.raises(InputError, match=match):
        sweep(**(arguments | changes))


@cache
def branch(name):
    orbit = ns.solve(f"{PAGE}:one-period", {"w": "2.4"})
    interval = {"w": (2.38, 2.42), "sigma": (-0.01, 0.01)}[name]
    return ns.continue_orbit(orbit, name, interval, step=0.5)


def test_a_frequency_response_is_drawn_by_default():
    pytest.importorskip("matplotlib")
    response, other = branch("w"), branch("sigma")
    (angular,) = response.plot().axes
    (cycles,) = response.plot(frequency="cycles").axes
    assert "angular" in angular.get_xlabel()
    assert "cycles" in cycles.get_xlabel()
    assert "amplitude" in angular.get_ylabel()
    lines = [axes.lines[0].get_xydata() for axes in (angular, cycles)]
    np.testing.assert_array_equal(lines[0][:, 0], response.parameter_values)
    np.testing.assert_allclose(lines[0][:, 0], 2 * np.pi * lines[1][:, 0])
    np.testing.assert_allclose(lines[0][:, 1], response.quantity("amplitude_x"))
    with pytest.raises(InputError, match="unknown frequency 'hertz'"):
        response.plot(frequency="hertz")
    (axes,) = other.plot().axes
    assert "amplitude" in axes.get_ylabel()
    assert "frequency" not in axes.get_xlabel()
    assert axes.get_xlabel() == other.plot(frequency="cycles").axes[0].get_xlabel()
    (free,) = ns.load(file_of("nonsmooth branch")).plot().axes
    assert free.get_ylabel().startswith("period")


def test_a_slider_is_drawn_with_the_velocity_of_its_mass():
    figures = pytest.importorskip("matplotlib.figure")
    orbit = ns.solve(f"{GALLERY / 'jenkins.py'}:yielding-both-ways")
    axes = orbit.plot("velocity", axes=figures.Figure().add_subplot())
    labels = [line.get_label() for line in axes.lines if not line.get_label().startswith("_")]
    assert labels == ["$x'$", r"$\mathrm{s\_joint}'$"]
