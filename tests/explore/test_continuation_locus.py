"""Curves of events: closed forms, other solutions, files, pictures, and the command."""

import math
from functools import cache

import numpy as np
import pytest

import nonsmooth
from tests.cli.test_cli import run, told
from tests.core.test_result_files import composed
from tests.explore.test_continuation_forced import branch as impacts
from tests.explore.test_continuation_forced import closed_forms, orbit

SYMMETRIC = "dry-friction/symmetric"


@cache
def branch():
    return nonsmooth.continue_orbit(nonsmooth.solve(SYMMETRIC), "V", (0.6, 1.3))


@cache
def flips():
    (flip,) = (event for event in branch().events if event.kind == "flip")
    return nonsmooth.continue_orbit(branch(), "eta", (3.9, 4.1), event=flip)


@cache
def composed_folds():
    (fold,) = (event for event in impacts().events if event.kind == "fold")
    return nonsmooth.continue_orbit(impacts(), "w", (2.7, 2.9), event=fold, step=0.1)


@pytest.mark.slow
def test_orbits_of_a_curve_have_its_event():
    for place in (0, flips().start, -1):
        at = flips().orbit_at(place)
        assert min(abs(at.stability.multipliers[k].real + 1) for k in (0, 1)) < 1e-9
        given = {name: float(at.given[name]) for name in flips().parameters}
        assert list(given.values()) == flips().values[place].tolist()
        again = nonsmooth.solve(SYMMETRIC, given, list(at.unknowns.values()))
        assert again.trace == pytest.approx(at.trace, abs=1e-8)
    assert flips().values[flips().start].tolist() == [branch().events[-1].value, 4.0]
    fold = composed_folds().orbit_at(0)
    assert min(abs(fold.multipliers - 1)) < 1e-6
    with pytest.raises(nonsmooth.InputError, match="no point 1000"):
        flips().orbit_at(1000)


@pytest.mark.parametrize(
    ("of", "plane", "options", "message"),
    [
        (lambda: branch().orbit, ("eta", (3.9, 4.1)), {}, "an event is followed on its branch"),
        (
            branch,
            ("eta", (3.9, 4.1)),
            {"admissible": True},
            "admissible and resume: of orbits only",
        ),
        (branch, ("eta", (3.9, 4.1)), {"event": None}, "orbit is a Branch"),
        (branch, ("eta", (3.9, 4.1)), {"step": 0}, "step = 0"),
        (impacts, ("sigma", (-1, 1)), {}, "unknown second parameter 'sigma'"),
        (impacts, ("w", (3, 4)), {}, "is not in 3 to 4"),
        (
            lambda: nonsmooth.continue_orbit(composed(), "period", (5.1, 6.5)),
            *(("k2", (4, 6)), {}, "one of a family"),
        ),
    ],
)
def test_wrong_input(of, plane, options, message):
    given = of()
    events = getattr(given, "events", branch().events)
    with pytest.raises(nonsmooth.InputError, match=message):
        nonsmooth.continue_orbit(given, *plane, **{"event": events[0], **options})


def test_steps_are_told():
    told = []
    event = branch().events[-1]
    nonsmooth.continue_orbit(
        branch(), "eta", (3.9, 4.1), event=event, step=0.1, progress=told.append
    )
    assert told == list(range(1, len(told) + 1))


def test_picture():
    pytest.importorskip("matplotlib")
    (axes,) = flips().plot().axes
    curve, mark = axes.lines
    np.testing.assert_array_equal(curve.get_xydata(), flips().values)
    assert mark.get_xydata().tolist() == [flips().values[flips().start].tolist()]
    assert (curve.get_label(), axes.get_xlabel()[:3]) == ("flip", "$V$")
    assert flips().plot(axes) is axes
    assert axes.lines[2].get_color() != curve.get_color()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("words", "parts"),
    [
        ("", ["--switch flip follows the other branch there", "with a second range NAME=A:B"]),
        ("eta=3.9:4.1 --follow flip", [f"flip: {SYMMETRIC}", "ends: end of the interval"]),
        ("us1=0.0127 ur1=0.0255 --switch flip:1", ["4 phases", "\nperiod: "]),
    ],
)
def test_commands(words, parts):
    code, out, _ = run("continue", SYMMETRIC, "V=0.6:1.3", *words.split())
    assert code == 0
    for part in parts:
        assert part in out


@pytest.mark.slow
def test_beyond_the_flip_of_a_given_period_twice_that_period_is_followed():
    doubled = told("continue", "rigid-stop/one-impact", "T=5:6.5", "--switch", "flip:1")
    assert doubled["parameter"] == "period"
    assert 10 < min(doubled["values"]) < max(doubled["values"]) < 13


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("eta=3.9:4.1 --follow fold", "no fold on this branch; there is gra"),
        ("eta=3.9:4.1 --follow flop", "did you mean 'flip'"),
        ("eta=3.9:4.1 --follow flip:2", "no flip:2 on this branch"),
        ("eta=3.9:4.1 --follow flip:x", "no flip:x on this branch"),
        ("--follow flip", "two parameters have to be a range"),
        ("W=4:5 --follow flip", "unknown given parameter 'W'"),
        ("eta=4:5 --follow flip --beyond", "--beyond is of a branch"),
        ("--switch fold", "no fold on this branch; there is gra"),
    ],
)
def test_wrong_commands(words, message):
    code, _, err = run("continue", SYMMETRIC, "V=0.6:1.3", *words.split())
    assert code == 2
    assert message in err


def test_one_of_several_events():
    rigid = ("continue", "rigid-stop/one-impact", "T=5:6.5", "k2=4.9:5.1", "--follow")
    code, _, err = run(*rigid, "flip")
    assert code == 2
    assert "which flip, flip:1 ... flip:2? There is flip (T = " in err


# --- against closed forms and other solutions


@pytest.mark.slow
def test_fold_and_flip_curves_in_closed_form():
    for place, kind in enumerate(("fold", "flip")):
        event = [e for e in impacts().events if e.kind == kind][-1]
        locus = nonsmooth.continue_orbit(impacts(), "w", (2.6, 3.0), event=event, step=0.1)
        assert locus.parameters == ("sigma", "w")
        assert locus.ends == ("end of the interval", "end of the interval")
        sigma, w = locus.values.T
        assert len(w) > 5
        np.testing.assert_allclose(sigma, closed_forms(w)[place], rtol=0, atol=1e-9)


def test_torus_curve_in_closed_form():
    damped = nonsmooth.continue_orbit(orbit(-0.5), "c", (-0.4, 0.4), step=0.05)
    (event,) = [e for e in damped.events if e.kind == "neimark-sacker"]
    locus = nonsmooth.continue_orbit(damped, "r", (0.75, 0.85), event=event, step=0.1)
    c, restitution = locus.values.T
    np.testing.assert_allclose(c, np.log(restitution) * 2.8 / math.pi, atol=1e-9)


@pytest.mark.slow
def test_grazing_and_flip_of_an_orbit_with_kernels():
    found = nonsmooth.continue_orbit(nonsmooth.solve(SYMMETRIC), "V", (0.5, 1.3))
    for event in found.events:
        locus = nonsmooth.continue_orbit(found, "eta", (3.8, 4.2), event=event, step=0.1)
        for (speed, eta), unknowns in list(zip(locus.values, locus.unknowns, strict=True))[::4]:
            near = nonsmooth.solve(SYMMETRIC, {"V": speed, "eta": eta}, unknowns.tolist())
            again = nonsmooth.continue_orbit(near, "V", (speed - 0.01, speed + 0.01), step=0.2)
            same = [e.value for e in again.events if e.kind == event.kind]
            assert same == [pytest.approx(speed, abs=1e-9)]


def test_border_collision_is_solution_ii():
    found = nonsmooth.continue_orbit(nonsmooth.solve("dry-friction/global-stick"), "V", (0.8, 1.3))
    locus = nonsmooth.continue_orbit(found, "e1", (2.8, 3.2), event=found.events[-1], step=0.1)
    speed, e1 = locus.values.T
    for place in (0, len(e1) // 2, -1):
        # the orbit without the first phase, of which e1 is an unknown
        limit = nonsmooth.solve("dry-friction/solution-ii", {"V": speed[place]})
        assert limit.unknowns["e1"] == pytest.approx(e1[place], abs=1e-9)
