"""Designs of the worst along a branch, against scans of a grid and closed conditions."""

import os
import signal
from functools import cache

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.runtime.explore.design.worst_over import _least
from tests.places import GALLERY

pytestmark = pytest.mark.usefixtures("fewer_looks")

DAMPER = f"{GALLERY / 'impact_damper.py'}:struck-twice"
WINDOW, WIDE = {"w": (0.96, 1.01)}, {"w": (0.95, 1.05)}
CUT_OFF = {"minimise": "peak:x", "over": {"d": (7, 8.5)}, "worst_over": {"w": (0.98, 1.02)}}


def solved(near=None, **changed):
    """The orbit at other parameters, from one nearby."""
    given = {"r": "0.3", "zeta": "0.05"} if near is None else near.given
    guess = {} if near is None else {"guess": {n: float(x) for n, x in near.unknowns.items()}}
    return ns.solve(DAMPER, {**given, **changed}, **guess)


@cache
def damper():
    return solved(d=8)


@cache
def tuned():
    return ns.design(damper(), minimise="peak:x", over={"d": (7, 10)}, worst_over=WINDOW)


@cache
def cut_off():
    return ns.design(damper(), **CUT_OFF)


def response(gap, values):
    """Peaks of the orbit over the frequency, by solving anew at each."""
    found, orbit = [], damper()
    for value in values.tolist():
        orbit = solved(orbit, d=gap, w=value)
        assert orbit.admissibility.verdict is True
        found.append(abs(orbit.motion().sample(2001).states[:, 0]).max())
    return np.array(found)


@pytest.mark.slow
def test_the_smallest_resonance_peak_is_that_of_a_grid():
    """Peaks on a grid of gaps and frequencies, sampled, none of them by the design's route."""
    found = tuned()
    assert found.converged
    assert found.corner == ""
    assert not found.active
    # some all along the window, and closer ones where they are highest
    values = np.sort(np.concatenate([np.linspace(*WINDOW["w"], 9), np.linspace(0.97, 0.985, 7)]))
    before, best, behind = (response(found.after["d"] + by, values) for by in (-0.03, 0, 0.03))
    assert best.max() < min(before.max(), behind.max())
    assert found.after["peak:x"] == pytest.approx(best.max(), rel=1e-5)
    (worst,) = found.worst_at
    assert values[best.argmax()] == pytest.approx(worst, abs=3e-3)


@pytest.mark.slow
def test_at_the_worst_frequency_the_peak_changes_with_nothing():
    """A saddle: the derivatives by the frequency and by the gap are zero, by both."""
    value, slopes = tuned().orbit.derivatives(["w", "d"]).quantity("maximum:x")
    assert value == pytest.approx(tuned().after["peak:x"], rel=1e-12)
    assert abs(slopes[0]) < 1e-5
    assert abs(slopes[1]) < 1e-7


@pytest.mark.slow
def test_the_worst_at_the_end_of_the_interval_is_active_there():
    """Toward a resonance that is cut off the end is worst, and the bound of the gap acts."""
    found = cut_off()
    assert found.worst_at == (0.98,)
    assert [limit.text for limit in found.active] == ["d<=8.5"]
    slope = found.orbit.derivatives(["d"]).quantity("maximum:x")[1][0]
    assert found.active[0].multiplier == pytest.approx(-slope, rel=1e-6)


@pytest.mark.slow
def test_conditions_hold_all_along_the_branch():
    found = ns.design(
        damper(),
        minimise="peak:x",
        over={"d": (7, 10), "r": (0.2, 0.5)},
        worst_over=WIDE,
        subject_to=["spectral_radius<=0.75"],
    )
    assert found.converged
    assert any(limit.text.startswith("spectral_radius<=0.75 at w = ") for limit in found.active)
    branch = ns.continue_orbit(found.orbit, "w", WIDE["w"])
    radius = abs(branch.multipliers).max(axis=1)
    assert radius.max() == pytest.approx(0.75, abs=1e-7)
    assert branch.admissible.all()
    assert found.after["peak:x"] < found.before["peak:x"]


@pytest.mark.slow
def test_two_frequencies_are_as_bad_at_the_optimum():
    """A kink in one parameter: on either side of it another of the two is worse."""
    light, window = solved(d=7, mu="0.15"), {"w": (0.98, 1.05)}
    found = ns.design(light, minimise="peak:x", over={"mu": (0.145, 0.16)}, worst_over=window)
    assert found.converged
    assert found.corner == "as bad at 2 places of the branch"
    assert not found.active
    inside, end = found.worst_at
    assert end == 1.05
    slopes = []
    for place in (inside, end):
        orbit = solved(light, mu=found.after["mu"], w=place)
        value, slope = orbit.derivatives(["mu", "w"]).quantity("maximum:x")
        assert value == pytest.approx(found.after["peak:x"], rel=1e-9)
        slopes.append(slope)
    assert slopes[0][0] < 0 < slopes[1][0]
    assert abs(slopes[0][1]) < 1e-6


@pytest.mark.slow
def test_to_maximise_the_least_is_to_minimise_the_largest_of_the_negative():
    found = ns.design(damper(), maximise="minimum:x", over={"d": (7, 10)}, worst_over=WINDOW)
    assert found.after["d"] == pytest.approx(tuned().after["d"], abs=1e-5)
    assert found.after["minimum:x"] == pytest.approx(-tuned().after["peak:x"], rel=1e-9)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"worst_over": {"w": (0.8, 1.05)}}, "is not there for all w = 0.8 to 1.05"),
        ({"worst_over": {"d": (7, 9)}}, "d varies: it cannot be the parameter of the branch too"),
        ({"worst_over": {}}, "worst_over gives the interval of one parameter"),
        ({"worst_over": {"w": (1.02, 1.05)}}, "w = 1 of the orbit is not in 1.02 to 1.05"),
        ({"subject_to": ["peak:x=3"]}, "peak:x=3: an equation cannot hold all along worst_over"),
        ({"minimise": None, "solve": {"peak:x": 3}}, "are of one orbit: leave out worst_over"),
    ],
)
def test_what_is_wrong_is_named(options, message):
    asked = {"minimise": "peak:x", "over": {"d": (7, 10)}, "worst_over": WINDOW, **options}
    with pytest.raises(ns.InputError, match=message):
        ns.design(damper(), **asked)


@pytest.mark.slow
def test_the_optimum_is_kept_and_drawn(tmp_path):
    tuned().save(tmp_path / "design.json")
    kept = ns.load(tmp_path / "design.json")
    assert (kept.worst_over, kept.worst_at) == (WINDOW, tuned().worst_at)
    curve = kept.plot().axes[1].lines[1].get_ydata()
    assert np.nanmax(curve) == pytest.approx(tuned().after["peak:x"], rel=1e-4)
    assert np.nanmax(curve) <= tuned().after["peak:x"] + 1e-9


@pytest.mark.slow
def test_an_interrupted_design_goes_on_to_the_same_end():
    def stop(iterates, _):
        if iterates >= 2:
            os.kill(os.getpid(), signal.SIGINT)

    with pytest.raises(ns.Interrupted) as stopped:
        ns.design(damper(), **CUT_OFF, progress=stop)
    part = stopped.value.partial
    assert part.message == "interrupted"
    assert not part.converged
    whole = ns.design(damper(), **CUT_OFF, resume=part)
    assert whole.converged
    assert whole.after["d"] == pytest.approx(cut_off().after["d"], abs=1e-6)
    assert whole.after["peak:x"] == pytest.approx(cut_off().after["peak:x"], rel=1e-9)
    assert whole.before == part.before
    assert len(whole.history) > len(part.history)
    np.testing.assert_array_equal(whole.history[: len(part.history)], part.history)
    with pytest.raises(ns.InputError, match="the design to resume has another bounds"):
        ns.design(damper(), **{**CUT_OFF, "over": {"d": (7, 11)}}, resume=part)


@pytest.mark.parametrize("corner", [False, True])
@pytest.mark.parametrize("seed", range(4))
def test_the_places_of_all_minima_are_found(seed, corner):
    """Of waves, or of the larger of two lines, without a derivative near where they meet."""
    rng = np.random.default_rng(seed)
    height, rate, phase = rng.uniform([0.5, 4, 0], [2, 9, 6])
    kink, left, right = rng.uniform([0.1, 0.5, 0.5], [0.9, 2, 2])

    def at(x):
        if corner:
            slope = np.nan if abs(x - kink) < 0.05 else right if x > kink else -left
            return max(-left * (x - kink), right * (x - kink)), slope
        angle = rate * x + phase
        return height * np.cos(angle), -height * rate * np.sin(angle)

    parts, fine = np.linspace(0, 1, 33), np.linspace(0, 1, 20001)
    values, slopes = np.array([at(x) for x in parts]).T
    heights = np.array([at(x)[0] for x in fine])
    around = np.concatenate([[np.inf], heights, [np.inf]])
    minima = fine[(heights < around[:-2]) & (heights <= around[2:])]
    found = sorted(_least(parts, values, slopes, at, every=True))
    np.testing.assert_allclose([x for x, _ in found], minima, atol=1e-4)
    for x, bend in found:
        wanted = 0 if corner or x in (0, 1) else -(rate**2) * at(x)[0]
        assert bend == pytest.approx(wanted, rel=1e-2)
    least = _least(parts, values, slopes, at, every=False)
    assert min(at(x)[0] for x, _ in least) <= min(heights) + 1e-9
    assert {*least} <= {*found}
    bowl = (parts - 0.5) ** 2, 2 * (parts - 0.5)  # its minimum is one of the places
    assert _least(parts, *bowl, at, every=True) == [(0.5, 0.0)]
