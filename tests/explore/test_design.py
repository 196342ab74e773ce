"""Designs: optima against scans, closed forms and differences, along a branch and at its limits."""

import warnings
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

import nonsmooth as ns
from nonsmooth.runtime.explore.design.condition import condition_in
from nonsmooth.runtime.explore.design.following import BranchFollower
from nonsmooth.runtime.explore.design.largest import radius_rows
from nonsmooth.runtime.explore.design.quantities import multiplier_gap
from tests.places import GALLERY

IMPACTS = f"{GALLERY / 'impact_oscillator.py'}:one-period"
METHODS = ("SLSQP", "trust-constr")
DATA = {"us1": 1, "ur1": 1, "us2": 1}


@cache
def symmetric() -> ns.Orbit:
    return ns.solve("dry-friction/symmetric")


@cache
def whole() -> ns.Orbit:
    """With all that admissibility depends on."""
    return ns.solve("dry-friction/symmetric", DATA)


@cache
def stablest() -> ns.Design:
    return ns.design(symmetric(), minimise="spectral_radius", over={"V": (0.3, 3)})


@cache
def impacts() -> ns.Orbit:
    return ns.solve(IMPACTS)


@pytest.mark.parametrize("method", METHODS)
def test_the_stablest_orbit_is_that_of_a_scan(method: Any) -> None:
    found = ns.design(symmetric(), minimise="spectral_radius", over={"V": (0.3, 3)}, method=method)
    values = np.linspace(2.6, 2.9, 301)
    scan = [ns.solve("dry-friction/symmetric", {"V": value}).multipliers for value in values]
    radius = np.abs(scan).max(axis=-1)
    assert found.converged
    assert not found.active
    assert not found.corner
    assert found.residual < 1e-6
    assert abs(found.after["V"] - values[radius.argmin()]) < 1e-3
    assert found.after["spectral_radius"] <= radius.min() + 1e-12
    assert found.orbit.stability.verdict == "stable"


def test_gradients_are_those_of_fifty_digits() -> None:
    found = ns.design(whole(), minimise="period", over={"V": (0.5, 1.5), "eta": (3.9, 4.1)})
    step = 1e-12
    for name in found.parameters:
        ends = []
        for sign in (-1, 1):
            moved = {**{n: v.text for n, v in found.orbit.given.items()}}
            moved[name] = repr(found.after[name] + sign * step)
            ends.append(ns.solve("dry-friction/symmetric", {**moved}, digits=50))
        width = ends[1].arithmetic.number(ends[1].given[name]) - ends[1].arithmetic.number(
            ends[0].given[name]
        )
        slope = float((ends[1].period - ends[0].period) / width)
        assert found.gradient["period"][name] == pytest.approx(slope, rel=1e-9)


def test_to_maximise_is_to_minimise_the_negative() -> None:
    """The velocity of the impact is negative: its largest is its smallest speed's."""
    over = {"sigma": (-0.5, 0.1)}
    lowest = ns.design(impacts(), minimise="v0", over=over)
    highest = ns.design(impacts(), maximise="v0", over=over)
    assert [d.active[0].text for d in (lowest, highest)] == ["sigma>=-0.5", "sigma<=0.1"]
    for design, sign in ((lowest, 1), (highest, 1)):
        slope = abs(design.gradient["v0"]["sigma"])
        assert sign * design.active[0].multiplier == pytest.approx(slope, rel=1e-12)
    assert lowest.after["v0"] < lowest.before["v0"] < highest.after["v0"]


def test_multipliers_of_limits_are_what_relaxing_them_gains() -> None:
    def at(most: str) -> ns.Design:
        return ns.design(
            whole(),
            minimise="peak:x1",
            over={"V": (0.6, 3)},
            subject_to=[f"spectral_radius<={most}"],
        )

    low, middle, high = at("0.8999"), at("0.9"), at("0.9001")
    (limit,) = middle.active
    assert limit.text == "spectral_radius<=0.9"
    gained = (low.after["peak:x1"] - high.after["peak:x1"]) / 2e-4
    assert limit.multiplier == pytest.approx(gained, rel=1e-5)


def test_the_order_of_parameters_is_no_matter() -> None:
    over = {"V": (0.3, 3.0), "eta": (3.0, 5.0)}
    first = ns.design(symmetric(), minimise="spectral_radius", over=over)
    other = ns.design(symmetric(), minimise="spectral_radius", over=dict(reversed(over.items())))
    for name in over:
        assert first.after[name] == pytest.approx(other.after[name], rel=1e-9)
    assert first.corner == other.corner == "two multipliers meet"
    assert [limit.text for limit in first.active] == ["V<=3.0"]
    section = first.orbit.derivatives().section  # a double root at the optimum
    assert section.trace**2 == pytest.approx(4 * section.determinant, rel=1e-8)


def test_a_flip_is_solved_for_where_the_branch_has_it() -> None:
    found = ns.design(symmetric(), solve={"multiplier": -1}, over={"V": (0.6, 1.3)})
    branch = ns.continue_orbit(symmetric(), "V", (0.6, 1.3))
    (flip,) = [event for event in branch.events if event.kind == "flip"]
    assert found.after["V"] == pytest.approx(flip.value, rel=1e-12)
    assert found.after["multiplier"] == pytest.approx(-1, abs=1e-12)
    assert found.message == "the wanted values are met"


def test_two_values_are_solved_for_in_two_parameters() -> None:
    aimed = ns.solve("dry-friction/symmetric", {"V": 0.9, "eta": 3.9})
    wanted = {"period": aimed.period, "trace": aimed.trace}
    found = ns.design(symmetric(), solve=wanted, over={"V": (0.6, 1.5), "eta": (3.5, 4.5)})
    assert found.converged
    assert found.values == pytest.approx({"V": 0.9, "eta": 3.9}, rel=1e-10)


def test_a_closed_form_is_met() -> None:
    """Grazing of the impact oscillator at |sigma| = 1/(w^2 - 1); peaks there are its stop."""
    found = ns.design(impacts(), maximise="v0", over={"sigma": (-0.5, 0.5)})
    assert not found.converged
    assert "a grazing or a fold" in found.message
    assert found.after["sigma"] == pytest.approx(1 / (2.4**2 - 1), rel=1e-6)
    assert abs(found.after["v0"]) < 1e-6


def test_margins_are_limits() -> None:
    """Two designs to the border of admissibility: the optimiser's, and the branch's own."""
    branch = ns.continue_orbit(whole(), "V", (0.2, 3))
    found = ns.design(whole(), maximise="period", over={"V": (0.2, 3)})
    assert found.converged
    assert found.orbit.admissibility.verdict is True
    assert min(abs(found.after["V"] - event.value) for event in branch.events) < 1e-8
    (limit,) = found.active
    assert limit.text == "first-reaches-belt stays away in phase 1"
    assert found.after["period"] < branch.period.max()


def test_a_value_out_of_reach_is_told_in_one_line() -> None:
    found = ns.design(symmetric(), solve={"period": 2}, over={"V": (0.6, 1.3)})
    assert not found.converged
    assert found.message == "period=2 not reached: within V<=1.3"
    stick = ns.solve("dry-friction/global-stick")
    ended = ns.design(stick, solve={"period": 6.5}, over={"V": (0.8, 1.3)})
    assert ended.message == "period=6.5 not reached: ta goes to zero"
    end = ns.continue_orbit(stick, "V", (0.8, 1.3)).parameter_values[-1]
    assert ended.after["V"] == pytest.approx(end, abs=1e-6)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"minimise": "perod"}, "did you mean 'period'"),
        ({"minimise": "period", "maximise": "trace"}, "one of minimise, maximise and solve"),
        ({"solve": {"period": 5, "trace": 1}}, "2 wanted values for 1 parameters"),
        ({"minimise": "multiplier"}, "no quantity to minimise: ask for spectral_radius"),
        ({"minimise": "period", "over": {"us1": (0, 2)}}, "depends on us1"),
        ({"minimise": "period", "over": {"V": (1, 2)}}, "V = 0.6773 of the orbit is not in 1 to 2"),
        ({"minimise": "period", "method": "BFGS"}, "unknown method 'BFGS'"),
        ({"minimise": "period", "subject_to": ["trace"]}, "'trace' is no condition"),
        ({"minimise": "period", "subject_to": ["multiplier<=1"]}, "a multiplier is wanted by ="),
        ({"solve": {"multiplier": 0}}, "no multiplier can be wanted here"),
        ({"minimise": "period", "iterations": 0}, "not a positive integer"),
    ],
)
def test_what_is_wrong_is_named(options: dict[str, Any], message: str) -> None:
    with pytest.raises(ns.InputError) as told:
        ns.design(symmetric(), **{"over": {"V": (0.6, 1.3)}, **options})
    assert message in str(told.value)
    assert "\n" not in str(told.value)


def test_a_parameter_that_nothing_depends_on_is_named() -> None:
    with pytest.raises(ns.InputError, match="nothing that is asked for depends on r"):
        ns.design(impacts(), solve={"period": 2.7, "T": 2.7}, over={"w": (2, 3), "r": (0.5, 0.9)})


def test_a_design_is_saved_with_every_digit(tmp_path: Path) -> None:
    path = tmp_path / "design.json"
    found = ns.design(
        whole(), minimise="peak:x1", over={"V": (0.6, 3)}, subject_to=["spectral_radius<=0.9"]
    )
    found.save(path)
    read = ns.load(path)
    for name in found.__dataclass_fields__:
        one, other = getattr(found, name), getattr(read, name)
        same = np.array_equal(one, other) if isinstance(one, np.ndarray) else one == other
        assert same, name
    assert read.to_json() == found.to_json()


def test_a_design_is_drawn() -> None:
    figure = stablest().plot()
    assert len(figure.axes) == 2
    curve = figure.axes[1].lines[0].get_ydata()
    assert np.nanmin(curve) >= stablest().after["spectral_radius"] - 1e-12
    stablest().plot(figure.axes[0])


def test_the_optimum_is_proved() -> None:
    proof = ns.certify(stablest().orbit)
    assert proof.stability == "stable"
    assert set(proof.claims.values()) == {"proved"}


@pytest.mark.parametrize("matrix", [[[0.3]], [[0.5, 0.2], [-0.1, -0.7]], [[0.5, -0.4], [0.4, 0.5]]])
def test_the_level_above_multipliers_is_the_spectral_radius(matrix: Any) -> None:
    """The least level at which all conditions hold, by bisection, is the eigenvalues'."""
    from types import SimpleNamespace

    found = np.array(matrix)
    section = SimpleNamespace(
        trace=np.trace(found),
        determinant=np.linalg.det(found),
        trace_rates=np.zeros(1),
        determinant_rates=np.zeros(1),
    )
    directions = SimpleNamespace(section=SimpleNamespace(rank=len(found), trivial=0))
    derivatives: Any = SimpleNamespace(section=section, directions=directions)
    largest = abs(np.linalg.eigvals(found)).max()
    level = brentq(lambda t: radius_rows(derivatives, t).values.min(), largest / 2, 5, xtol=1e-14)
    assert level == pytest.approx(largest, rel=1e-12)
    assert (radius_rows(derivatives, 1.01 * largest).values > 0).all()


def test_the_gap_to_a_multiplier_has_exact_derivatives() -> None:
    def gap(V: str) -> tuple[float, float]:
        orbit = ns.solve("dry-friction/symmetric", {"V": V})
        found = multiplier_gap(orbit.derivatives(["V"]), -1)
        return found.value, float(found.slope[0])

    value, slope = gap("1")
    rough = (gap("1.00001")[0] - gap("0.99999")[0]) / 2e-5
    assert slope == pytest.approx(rough, rel=1e-7)
    multipliers = ns.solve("dry-friction/symmetric", {"V": "1"}).multipliers
    assert value == pytest.approx(np.prod(-1 - multipliers).real, rel=1e-12)


def test_conditions_are_read_as_written() -> None:
    found = condition_in(" period <= 13/2 ")
    assert (found.quantity, found.relation, found.value.text) == ("period", "<=", "13/2")
    assert [found.excess(x) for x in (6.0, 7.0)] == [0.0, 0.5]
    for text in ("period<6", "<=3", "period<=", "a<=b<=c"):
        with pytest.raises((ns.InputError, ValueError)):
            condition_in(text)


def test_nothing_warns() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        ns.design(
            symmetric(), minimise="spectral_radius", over={"V": (0.3, 3)}, method="trust-constr"
        )


def test_the_multiplier_of_a_wanted_multiplier_is_what_it_costs() -> None:
    def at(wanted: str) -> ns.Design:
        over = {"V": (0.6, 1.5), "eta": (3.5, 4.5)}
        return ns.design(
            symmetric(), minimise="period", over=over, subject_to=[f"multiplier={wanted}"]
        )

    low, middle, high = at("-1.001"), at("-1"), at("-0.999")
    (limit,) = [each for each in middle.active if each.text == "multiplier=-1"]
    cost = (high.after["period"] - low.after["period"]) / 2e-3
    assert limit.multiplier == pytest.approx(cost, rel=1e-4)


def test_conditions_that_are_missed_are_approached_first() -> None:
    """Where linear forms of missed conditions contradict each other SLSQP alone ends at once."""
    orbit = ns.solve(f"{GALLERY / 'impact_damper.py'}:struck-twice")
    assert abs(orbit.multipliers).max() > 0.8
    found = ns.design(
        orbit, minimise="peak:x", over={"d": (6, 30)}, subject_to=["spectral_radius<=0.7"]
    )
    assert found.converged
    assert abs(found.orbit.multipliers).max() == pytest.approx(0.7, rel=1e-9)
    free = ns.design(orbit, minimise="peak:x", over={"d": (6, 30)})
    assert free.after["peak:x"] < found.after["peak:x"]
    slope = free.gradient["peak:x"]["d"]
    assert abs(slope) < 1e-7
    motion = ns.simulate(
        f"{GALLERY / 'impact_damper.py'}",
        {name: value.text for name, value in free.orbit.given.items()},
        {"x": 0, "y": 0, "v": 0, "v_y": 0},
        until=900,
    )  # from rest it settles on that orbit
    states = motion(np.linspace(motion.end - 2 * np.pi, motion.end, 4001))
    assert abs(states[:, 0]).max() == pytest.approx(free.after["peak:x"], rel=1e-5)


def test_one_multiplier_is_followed_to_its_bound() -> None:
    stick = ns.solve("dry-friction/global-stick")
    found = ns.design(stick, minimise="spectral_radius", over={"V": (0.9, 1.1)})
    (limit,) = found.active
    assert found.converged
    assert limit.text == "V>=0.9"
    assert limit.multiplier == pytest.approx(found.gradient["spectral_radius"]["V"], rel=1e-9)


def test_a_way_is_followed_up_to_the_end_of_the_branch() -> None:
    stick = ns.solve("dry-friction/global-stick")
    end = ns.continue_orbit(stick, "V", (0.8, 1.3)).parameter_values[-1]
    follower = BranchFollower(stick, ["V"])
    reached = follower.reach(follower.first, np.array([1.3]))
    assert reached.reason == "ta goes to zero"
    assert end - 2e-3 < follower.parameters(reached.numbers)[0] < end
