"""Designs: optima against scans, closed forms and differences, along a branch and at its limits."""

from functools import cache

import numpy as np
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import Parameter
from nonsmooth.runtime.explore.design.quantities import multiplier_rows, radius_rows
from tests.certified import ticking
from tests.differences import in_digits
from tests.explore.test_continuation_forced import branch as struck
from tests.explore.test_continuation_forced import bump_grazing, bumped, closed_forms
from tests.places import GALLERY
from tests.tables import slow

IMPACTS = f"{GALLERY / 'impact_oscillator.py'}:one-period"
DAMPER = f"{GALLERY / 'impact_damper.py'}:struck-twice"
DATA = {"us1": 1, "ur1": 1, "us2": 1}
ROWS = radius_rows, multiplier_rows


@cache
def symmetric():
    return ns.solve("dry-friction/symmetric")


@cache
def whole():
    """With all that admissibility depends on."""
    return ns.solve("dry-friction/symmetric", DATA)


@cache
def stablest():
    return ns.design(symmetric(), minimise="spectral_radius", over={"V": (0.3, 3)})


def test_an_interrupted_design_counts_the_orbit_that_was_told_last():
    told = iter([False, False, True])

    def stop(*_):
        if next(told):
            raise KeyboardInterrupt

    with pytest.raises(ns.Interrupted) as stopped:
        ns.design(symmetric(), minimise="spectral_radius", over={"V": (0.3, 3)}, progress=stop)
    assert stopped.value.partial.after["spectral_radius"] < 0.85


@cache
def impacts():
    return ns.solve(IMPACTS)


@pytest.mark.slow
def test_the_stablest_orbit_is_that_of_a_scan():
    found, values = stablest(), np.linspace(2.6, 2.9, 301)
    scan = [ns.solve("dry-friction/symmetric", {"V": value}).multipliers for value in values]
    radius = np.abs(scan).max(axis=-1)
    assert found.converged
    assert not found.active
    assert not found.corner
    assert found.residual < 1e-6
    assert abs(found.after["V"] - values[radius.argmin()]) < 1e-3
    assert found.after["spectral_radius"] <= radius.min() + 1e-12
    assert found.orbit.stability.verdict == "stable"


def test_gradients_are_those_of_fifty_digits():
    found = ns.design(whole(), minimise="period", over={"V": (0.5, 1.5), "eta": (3.9, 4.1)})
    for name in found.parameters:
        (slope,) = in_digits(found.orbit, name, lambda orbit: [orbit.period])
        assert found.gradient["period"][name] == pytest.approx(float(slope), rel=1e-9)


def test_to_maximise_is_to_minimise_the_negative():
    """The velocity of the impact is negative: its largest is its smallest speed's."""
    over = {"sigma": (-0.5, 0.1)}
    lowest = ns.design(impacts(), minimise="v0", over=over)
    highest = ns.design(impacts(), maximise="v0", over=over)
    assert [d.active[0].text for d in (lowest, highest)] == ["sigma>=-0.5", "sigma<=0.1"]
    for design, sign in ((lowest, 1), (highest, 1)):
        slope = abs(design.gradient["v0"]["sigma"])
        assert sign * design.active[0].multiplier == pytest.approx(slope, rel=1e-12)
    assert lowest.after["v0"] < lowest.before["v0"] < highest.after["v0"]


@pytest.mark.parametrize(
    ("quantity", "limit", "value", "sign", "over"),
    [
        slow(*("peak:x1", "spectral_radius<=", 0.9, -1, {"V": (0.6, 3)})),
        ("period", "multiplier=", -1, 1, {"V": (0.6, 1.5), "eta": (3.5, 4.5)}),
    ],
)
def test_the_multiplier_of_a_limit_is_what_relaxing_it_gains(quantity, limit, value, sign, over):
    begin = whole()
    found = []
    for wanted in (value, value - 1e-4, value + 1e-4):
        condition = [f"{limit}{wanted!r}"]
        found.append(ns.design(begin, minimise=quantity, over=over, subject_to=condition))
        begin = found[0].orbit
    middle, low, high = found
    (active,) = [each for each in middle.active if each.text == f"{limit}{value}"]
    cost = (high.after[quantity] - low.after[quantity]) / 2e-4
    assert active.multiplier == pytest.approx(sign * cost, rel=1e-5)


def test_the_order_of_parameters_is_no_matter():
    over = {"V": (0.3, 3.0), "eta": (3.0, 5.0)}
    first = ns.design(symmetric(), minimise="spectral_radius", over=over)
    other = ns.design(symmetric(), minimise="spectral_radius", over=dict(reversed(over.items())))
    for name in over:
        assert first.after[name] == pytest.approx(other.after[name], rel=1e-9)
    assert first.corner == other.corner == "two multipliers meet"
    assert [limit.text for limit in first.active] == ["V<=3.0"]
    section = first.orbit.derivatives().section  # a double root at the optimum
    assert section.trace**2 == pytest.approx(4 * section.determinant, rel=1e-8)


def test_a_flip_is_solved_for_where_the_branch_has_it():
    found = ns.design(symmetric(), solve={"multiplier": -1}, over={"V": (0.6, 1.3)})
    branch = ns.continue_orbit(symmetric(), "V", (0.6, 1.3))
    (flip,) = [event for event in branch.events if event.kind == "flip"]
    assert found.after["V"] == pytest.approx(flip.value, rel=1e-12)
    assert found.after["multiplier"] == pytest.approx(-1, abs=1e-12)
    assert found.message == "the wanted values are met"


def test_two_values_are_solved_for_in_two_parameters():
    aimed = ns.solve("dry-friction/symmetric", {"V": 0.9, "eta": 3.9})
    wanted = {"period": aimed.period, "trace": aimed.trace}
    found = ns.design(symmetric(), solve=wanted, over={"V": (0.6, 1.5), "eta": (3.5, 4.5)})
    assert found.converged
    assert found.values == pytest.approx({"V": 0.9, "eta": 3.9}, rel=1e-10)


@pytest.mark.parametrize("beyond", [0, 2e-10, 1e-6])
def test_a_value_at_the_end_of_a_range_is_met(beyond):
    aimed = ns.solve("dry-friction/symmetric", {"V": 0.9})
    found = ns.design(symmetric(), solve={"period": aimed.period}, over={"V": (0.6, 0.9 + beyond)})
    assert found.converged
    assert found.values["V"] == pytest.approx(0.9, rel=1e-12)


def test_a_closed_form_is_met():
    """Grazing of the impact oscillator at |sigma| = 1/(w^2 - 1); peaks there are its stop."""
    found = ns.design(impacts(), maximise="v0", over={"sigma": (-0.5, 0.5)})
    assert not found.converged
    assert "a grazing or a fold" in found.message
    assert found.after["sigma"] == pytest.approx(1 / (2.4**2 - 1), rel=1e-6)
    assert abs(found.after["v0"]) < 1e-6


@pytest.mark.slow
def test_margins_are_limits():
    """Two designs to the border of admissibility: the optimiser's, and the branch's own."""
    branch = ns.continue_orbit(whole(), "V", (0.2, 3))
    found = ns.design(whole(), maximise="period", over={"V": (0.2, 3)})
    assert found.converged
    assert found.orbit.admissibility.verdict is True
    assert min(abs(found.after["V"] - event.value) for event in branch.events) < 1e-8
    (limit,) = found.active
    assert limit.text == "first-reaches-belt stays away in phase 1"
    assert found.after["period"] < branch.period.max()


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"minimise": "perod"}, "did you mean 'period'"),
        ({"minimise": "period", "maximise": "trace"}, "one of minimise, maximise and solve"),
        ({"solve": {"period": 5, "trace": 1}}, "2 wanted values for 1 parameters"),
        ({"minimise": "multiplier"}, "no quantity to minimise: ask for spectral_radius"),
        ({"minimise": "period", "over": {"us1": (0, 2)}}, "depends on us1"),
        ({"minimise": "period", "over": {"V": (1, 2)}}, "V = 0.6773 of the orbit is not in 1 to 2"),
        *(
            ({"minimise": "period", "subject_to": [text]}, text)
            for text in ("trace", "period<6", "<=3", "period<=", "period<=3<=4")
        ),
        ({"minimise": "period", "subject_to": ["multiplier<=1"]}, "a multiplier is wanted by ="),
        ({"solve": {"multiplier": 0}}, "no multiplier can be wanted here"),
        ({"minimise": "period", "iterations": 0}, "is not an integer from 1"),
    ],
)
def test_what_is_wrong_is_named(options, message):
    with pytest.raises(ns.InputError) as told:
        ns.design(symmetric(), **{"over": {"V": (0.6, 1.3)}, **options})
    assert message in str(told.value)
    assert "\n" not in str(told.value)


def test_a_parameter_that_nothing_depends_on_is_named():
    with pytest.raises(ns.InputError, match="nothing that is asked for depends on r"):
        ns.design(impacts(), solve={"period": 2.7, "T": 2.7}, over={"w": (2, 3), "r": (0.5, 0.9)})


def test_a_design_is_drawn():
    figure = stablest().plot()
    assert len(figure.axes) == 2
    curve = figure.axes[1].lines[0].get_ydata()
    assert np.nanmin(curve) >= stablest().after["spectral_radius"] - 1e-12
    stablest().plot(figure.axes[0])


def mapped(matrix, rates, p):
    """A state that rests, and at each tick of a clock becomes (M + p R) x + 1."""
    part = Parameter("p", "part", lower=-sp.oo)
    system = ticking(exact(matrix) + part.symbol * exact(rates), 1, part)
    fixed = np.linalg.solve(np.eye(len(matrix)) - matrix - p * rates, np.ones(len(matrix)))
    return ns.solve(system, {"p": p}, [1, *fixed, 0], itinerary=[("rest", "tick")])


def exact(matrix):
    return sp.Matrix([[sp.Rational(repr(number)) for number in row] for row in matrix.tolist()])


@pytest.mark.parametrize(
    ("size", "seed"),
    [
        *((size, 0) for size in (1, 2, 3, 4)),
        *(slow(size, 1) for size in (1, 2, 3, 4)),
    ],
)
def test_the_least_spectral_radius_is_that_of_the_eigenvalues(size, seed):
    """Of maps with one multiplier to four; of seed 1 two may meet where it is smallest."""
    rng = np.random.default_rng([size, seed])
    matrix = (rng.normal(size=(size, size)) * 0.6 / size**0.5).round(2)
    check_least(matrix, rng.normal(size=matrix.shape).round(2))


def test_two_multipliers_meet_where_the_spectral_radius_is_least():
    rates = np.zeros((3, 3))
    rates[1, 0] = 1
    found = check_least(np.array([[0.7, 1, 0], [0, 0.7, 0], [0, 0, -0.2]]), rates)
    assert found.corner == "two multipliers meet"
    assert found.after["p"] == pytest.approx(0, abs=1e-7)


def check_least(matrix, rates):
    """The design of the map over p, against a scan of eigenvalues and their change at a bound."""

    def radius(p):
        return float(abs(np.linalg.eigvals(matrix + p * rates)).max())

    orbit = mapped(matrix, rates, 0.05)
    found = ns.design(orbit, minimise="spectral_radius", over={"p": (-0.1, 0.1)})
    best = found.after["p"]
    assert found.converged, found.message
    assert found.after["spectral_radius"] == pytest.approx(radius(best), abs=1e-7)
    assert radius(best) < min(map(radius, np.linspace(-0.1, 0.1, 401))) + 1e-7
    for limit in found.active:  # a bound, with what is lost for each unit of it
        inside = best - np.copysign(1e-6, best)
        cost = (radius(inside) - radius(best)) / 1e-6
        assert limit.multiplier == pytest.approx(cost, rel=1e-5)
    return found


def test_conditions_are_read_as_written():
    options = {"maximise": "spectral_radius", "over": {"V": (0.6, 1.3)}}
    found = ns.design(symmetric(), subject_to=[" period <= 24/5 "], **options)
    (limit,) = found.active
    assert limit.text == "period<=24/5"
    assert found.after["period"] == pytest.approx(4.8, rel=1e-9)


@pytest.mark.slow
def test_conditions_that_are_missed_are_approached_first():
    """Where linear forms of missed conditions contradict each other SLSQP alone ends at once."""
    orbit = ns.solve(DAMPER)
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


@pytest.mark.slow
@pytest.mark.parametrize("quantity", ["maximum:v", "peak:v"])
def test_extremes_in_several_places_tie_at_an_optimum(quantity):
    """The velocity in front of a stop and that between: one falls with the gap, one rises."""
    orbit = ns.solve(DAMPER, {"r": "0.3", "zeta": "0.05", "d": 8})
    found = ns.design(orbit, minimise=quantity, over={"d": (5, 10)})
    assert found.converged
    assert found.corner == "several extremes are equally large"
    assert not found.active
    best = found.after["d"]
    gaps = best + np.array([-0.02, -1e-3, 0, 1e-3, 0.02])
    peaks = []
    for gap in gaps:
        given = {**{n: v.text for n, v in found.orbit.given.items()}, "d": gap}
        peaks.append(ns.solve(DAMPER, given).motion().sample(20001).states[:, 2].max())
    assert np.argmin(peaks) == 2
    assert found.after[quantity] == pytest.approx(min(peaks), rel=1e-3)


def test_local_extremes_have_the_derivatives_of_differences():

    def found(gap):
        orbit = ns.solve(DAMPER, {"r": "0.3", "zeta": "0.05", "d": gap})
        return orbit.derivatives(["d"]).local_extremes("peak_acceleration:x")

    low, middle, high = (found(gap) for gap in (8 - 1e-5, 8, 8 + 1e-5))
    assert len(middle) == 6
    for before, here, after in zip(low, middle, high, strict=True):
        assert (before.phase, before.sign) == (here.phase, here.sign)
        slope = (after.value - before.value) / 2e-5
        assert float(here.rates[0]) == pytest.approx(slope, rel=1e-6)
    with pytest.raises(ns.InputError, match="period"):
        ns.solve(DAMPER).derivatives().local_extremes("period")


@pytest.mark.slow
@pytest.mark.parametrize("name", ["impact_damper.py:struck-twice", "two_belts.py:both-stick"])
def test_no_local_maximum_is_missed(name):
    """Against a dense grid, which comes as near to the end of a phase as its points are apart."""
    orbit = ns.solve(f"{GALLERY / name}")
    motion, derivatives = orbit.trajectory(), orbit.derivatives()
    states = motion(np.linspace(0, motion.end, 200_001))
    for state, values in zip(orbit.state_names, states.T, strict=True):
        inner = (values[1:-1] > values[:-2]) & (values[1:-1] >= values[2:])
        listed = np.array([e.value for e in derivatives.local_extremes(f"maximum:{state}")])
        for top in values[1:-1][inner]:
            assert abs(listed - top).min() < 2e-4 * np.ptp(values)


def test_one_multiplier_is_followed_to_its_bound():
    stick = ns.solve("dry-friction/global-stick")
    found = ns.design(stick, minimise="spectral_radius", over={"V": (0.9, 1.1)})
    (limit,) = found.active
    assert found.converged
    assert limit.text == "V>=0.9"
    assert limit.multiplier == pytest.approx(found.gradient["spectral_radius"]["V"], rel=1e-9)


@pytest.mark.slow
def test_the_optimum_does_not_depend_on_where_it_begins():
    """Nor on the last digits: from some starts the optimiser stops early, and begins again."""
    drawn = np.random.default_rng(7).uniform([0.66, 3], [1.5, 5], size=[12, 2]).tolist()
    begins = [ns.solve("dry-friction/symmetric", {"V": V, "eta": eta}) for V, eta in drawn]
    for orbit in begins:
        design = ns.design(
            orbit,
            minimise="spectral_radius",
            over={"V": (0.6, 3), "eta": (3, 5)},
            subject_to=["period<=4.6"],
        )
        assert design.converged, orbit
        assert design.after["V"] == pytest.approx(3)
        assert design.after["eta"] == pytest.approx(4.23229159609, abs=1e-7)


@pytest.mark.slow
def test_a_design_ends_where_its_branch_does():
    """A contact's time goes to zero as steeply as a branch turns: the reason tells them apart."""
    values, stick = struck().parameter_values, ns.solve("dry-friction/global-stick")
    begin = struck().orbit_at(int(np.argmax(values[: values.argmin()] < -1)))
    end = ns.continue_orbit(stick, "V", (0.8, 1.3)).parameter_values[-1]
    for orbit, options, name, interval, message, place in (
        (begin, {"solve": {"v0": -4}}, "sigma", (-2, 0.14),
         "v0=-4 not reached: the branch turns back (a fold)", closed_forms()[0]),
        (bumped(), {"maximise": "period"}, "Omega", (10, 27),
         "no optimum: tau1 goes to zero", bump_grazing()),
        (stick, {"solve": {"period": 6.5}}, "V", (0.8, 1.3),
         "period=6.5 not reached: ta goes to zero", end),
        (symmetric(), {"solve": {"period": 2}}, "V", (0.6, 1.3),
         "period=2 not reached: within V<=1.3", 1.3),
    ):  # fmt: skip
        found = ns.design(orbit, over={name: interval}, admissible=orbit is not begin, **options)
        assert not found.converged
        assert found.message == message
        assert found.after[name] == pytest.approx(place, rel=1e-8)


@pytest.mark.parametrize("size", [1, 2, 3, 4])
def test_conditions_of_multipliers_have_the_derivatives_of_differences(size):
    """And none is negative where the largest multiplier is at most the level."""
    rng = np.random.default_rng(size)
    matrix, rates = (rng.normal(size=(size, size)).round(2) * k for k in (0.6, 0.4))

    def rows_at(p, level):
        return [kind(mapped(matrix, rates, p).derivatives(["p"]), level) for kind in ROWS]

    step, level = 1e-6, 0.83
    radius = float(abs(np.linalg.eigvals(matrix)).max())
    sides = rows_at(step, level), rows_at(-step, level)
    levels = rows_at(0, level + step), rows_at(0, level - step)
    for found, more, less, up, down in zip(rows_at(0, level), *sides, *levels, strict=True):
        by_level = (up.values - down.values) / (2 * step)
        by_parameter = (more.values - less.values) / (2 * step)
        np.testing.assert_allclose(found.by_level, by_level, atol=1e-7)
        np.testing.assert_allclose(found.by_parameters[:, 0], by_parameter, atol=1e-7)
    for share in (0.9, 0.99, 1.01, 1.1):
        within, equal = rows_at(0, share * radius)
        assert (within.values.min() >= 0) == (share > 1)
        wanted = np.poly(matrix)[None] @ (share * radius) ** np.arange(size, -1, -1.0)
        assert equal.values == pytest.approx(wanted, rel=1e-9)
