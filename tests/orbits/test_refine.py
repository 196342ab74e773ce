"""Digits that are true: at twice the precision, by another arithmetic, by another route."""

import threading
from dataclasses import replace
from pkgutil import resolve_name

import flint
import mpmath
import pytest

from nonsmooth import InputError, NoConvergence, refine, solve
from nonsmooth.runtime.core.arithmetic import Balls, exact_ball
from nonsmooth.runtime.core.values import as_value, parse
from nonsmooth.runtime.model.kernels import orbit_names
from nonsmooth.runtime.orbits.refine import enclosed_trace

ORBIT = "dry-friction/global-stick"
UNKNOWNS = ("z10", "z20", "ta", "tau", "tau1", "tau2")
ARITHMETICS = ("flint", "mpmath")


@pytest.fixture(scope="module")
def orbit():
    return solve(ORBIT)


@pytest.fixture(scope="module")
def orbits():
    """Ordinary and exchanged problems with rational and irrational data."""
    return [
        solve(ORBIT),
        solve(ORBIT, {"chi": "2*pi/13", "eta": "1/3 + 1/2", "V": "sqrt(2)/1.3"}),
        solve(ORBIT, unknown=("e1", "e2"), given={"ta": 1, "tau": 2}),
        solve(ORBIT, unknown=("chi", "eta"), given={"tau1": "pi/2", "z20": "-27/10"}),
    ]


@pytest.fixture(scope="module")
def every(orbits):
    """Those, the other orbits, and an exchange in a border collision."""
    others = [solve(name) for name in orbit_names() if name != ORBIT]
    exchange = {"unknown": ["V"], "given": {"e1": "5/2"}}
    return [*orbits, *others, solve("dry-friction/solution-ii", **exchange)]


def error(first, second):
    """Largest error in units of max(1, |x|), in the arithmetic of the second."""
    mp = second.arithmetic.mp
    return max(
        abs(mp.mpf(x) - second.unknowns[name]) / max(1, abs(second.unknowns[name]))
        for name, x in first.unknowns.items()
    )


# --- true digits


@pytest.mark.parametrize("arithmetic", ARITHMETICS)
@pytest.mark.parametrize("digits", [1, 16, 50, 200])
def test_digits_are_true(every, digits, arithmetic):
    for orbit in every:
        check = refine(orbit, 2 * digits + 30, arithmetic=arithmetic)
        assert 10 <= orbit.digits <= 15
        assert error(orbit, check) <= mpmath.mpf(10) ** -orbit.digits
        # on from doubles, and back from more digits
        assert error(refine(check, digits), check) <= mpmath.mpf(10) ** -digits
        found = refine(orbit, digits, arithmetic=arithmetic)
        assert found.digits == digits
        assert list(found.unknowns) == list(orbit.unknowns)
        assert error(found, check) <= mpmath.mpf(10) ** -digits
        assert abs(found.period - check.period) <= mpmath.mpf(10) ** -digits * check.period
        assert found.residual < mpmath.mpf(10) ** -digits
        assert found.given == orbit.given
        assert found.converged
        for number in (*found.unknowns.values(), found.period, found.trace):
            assert abs(number / 3 * 3 - number) <= mpmath.mpf(10) ** -digits * abs(number)
            assert len(str(number)) > digits or not number


def test_both_are_compared_with_each_other(every, monkeypatch):
    for orbit in every:
        both, balls = refine(orbit, 40, arithmetic="both"), refine(orbit, 40)
        assert both.unknowns == balls.unknowns
    moved, name = refine(every[0], 40), every[0].problem.unknown_names[0]  # it is 1.16
    value = moved.unknowns[name] + moved.arithmetic.mp.mpf("1e-39")
    moved = replace(moved, unknowns=moved.unknowns | {name: value})
    kept = type(every[0].problem).refined
    monkeypatch.setattr(
        type(every[0].problem),
        "refined",
        lambda self, o, digits, a: moved if a == "mpmath" else kept(self, o, digits, a),
    )
    with pytest.raises(NoConvergence, match=r"flint and mpmath differ by 8\.6e-40 at 40 digits"):
        refine(every[0], 40, arithmetic="both")


@pytest.mark.parametrize("fault", ["1e-45", "1e-39"])
def test_the_trace_of_mpmath_has_to_lie_in_the_enclosure_by_balls(orbit, fault, monkeypatch):
    right = type(orbit).evaluate

    def wrong(self, *quantities):
        value = right(self, *quantities)
        return value * (1 + self.arithmetic.mp.mpf(fault)) if quantities == ("trace",) else value

    monkeypatch.setattr(type(orbit), "evaluate", wrong)
    if fault == "1e-39":
        with pytest.raises(NoConvergence, match=r"flint and mpmath differ by 9\.8e-40 at 40"):
            refine(orbit, 40, arithmetic="both")
    else:
        assert refine(orbit, 40, arithmetic="both").converged


def test_the_trace_is_enclosed_of_the_one_orbit_in_a_box(every):
    for orbit in every:
        truth = refine(orbit, 80, arithmetic="mpmath").trace
        ball = enclosed_trace(refine(orbit, 30))
        assert ball.contains(exact_ball(truth))
        assert 0 < ball.rad() < 1e-30
        # elsewhere there is no such box, or the same orbit is in it
        for change in ("1e-35", "1e-20", "1e-3"):
            name = orbit.problem.unknown_names[0]
            sharp = refine(orbit, 30)
            value = sharp.unknowns[name] + sharp.arithmetic.mp.mpf(change)
            ball = enclosed_trace(replace(sharp, unknowns=sharp.unknowns | {name: value}))
            assert ball is None or ball.contains(exact_ball(truth))


def test_a_float_means_its_shortest_decimal():
    as_float, as_text = solve(ORBIT, {"e2": 0.1 + 0.4}), solve(ORBIT, {"e2": "0.5"})
    one, other = solve(ORBIT, {"chi": 0.45}), solve(ORBIT, {"chi": "0.45"})
    exact = solve(ORBIT, {"chi": "9/20"})
    for first, second in ((as_float, as_text), (one, other), (other, exact)):
        assert refine(first, 60).unknowns == refine(second, 60).unknowns
    third = refine(solve(ORBIT, {"chi": "1/3"}), 60)
    rounded = refine(solve(ORBIT, {"chi": 1 / 3}), 60)
    assert 1e-18 < error(rounded, third) < 1e-14


# --- the derivatives and the stability of a refined orbit


def test_one_multiplier_is_exactly_zero_and_the_other_is_the_trace(orbits):
    for orbit in (*orbits, *(refine(o, 50) for o in orbits)):
        stability = orbit.stability
        large, zero = stability.multipliers
        assert stability.rank_one
        assert (zero.real, zero.imaginary, large.imaginary) == (0, 0, 0)
        assert large.real == stability.trace == orbit.trace
        assert stability.margin == 1 - abs(stability.trace)
        assert stability.verdict == ("stable" if stability.margin > 0 else "unstable")


def test_printed_digits_are_true(every):
    for orbit in every:
        short, long = refine(orbit, 30).to_json(), refine(orbit, 90).to_json()
        tolerance = mpmath.mpf(10) ** -30
        with mpmath.workdps(120):
            pairs = [(short[k], long[k]) for k in ("period", "trace", "margin")]
            pairs += [(short["unknowns"][k], long["unknowns"][k]) for k in orbit.unknowns]
            pairs += [(short["parameters"][k], long["parameters"][k]) for k in orbit.given]
            for text, longer in pairs:
                size = max(1, abs(mpmath.mpf(longer)))
                assert abs(mpmath.mpf(text) - mpmath.mpf(longer)) <= tolerance * size


# --- refusals


@pytest.mark.parametrize(
    ("digits", "arithmetic", "told"),
    [
        (0, "flint", "digits = 0"),
        (-1, "mpmath", "digits = -1"),
        (10**9, "both", "digits = 1000000000"),
        (20, "float", "'float'"),
        (30, "flint", "cannot be refined"),
    ],
)
def test_what_cannot_be_refined_is_refused_in_one_line(orbit, digits, arithmetic, told):
    lost = solve(ORBIT, {"e2": 1e4}, throw=False)
    with pytest.raises(InputError, match=told) as caught:
        refine(lost if "refined" in told else orbit, digits, arithmetic=arithmetic)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("arithmetic", ARITHMETICS)
def test_singular_equations_do_not_converge(orbit, arithmetic):
    # the dwell times fix V, e1, e2 only up to a factor
    known = {name: as_value(orbit.values[name]) for name in ("chi", "eta", "ta", "tau", "tau1")}
    unknowns = {n: orbit.values[n] for n in ("z10", "z20", "tau2", "V", "e1", "e2")}
    with pytest.raises(NoConvergence, match="singular"):
        refine(replace(orbit, given=known, unknowns=unknowns), 30, arithmetic=arithmetic)


@pytest.mark.parametrize("arithmetic", ARITHMETICS)
def test_a_start_that_is_no_orbit_never_gives_digits(orbit, arithmetic):
    for factor in (0.5, 0.9, 0.99, 1.5, 1e6):
        far = replace(orbit, unknowns={n: x * factor for n, x in orbit.unknowns.items()})
        try:
            found = refine(far, 30, arithmetic=arithmetic)
        except NoConvergence:
            continue
        assert error(found, refine(orbit, 40)) < mpmath.mpf(10) ** -30


# --- nobody else's precision


@pytest.mark.parametrize("arithmetic", ARITHMETICS)
@pytest.mark.parametrize("bits", [24, 53, 2000])
def test_precision_elsewhere_is_neither_used_nor_changed(orbit, arithmetic, bits):
    expected = refine(orbit, 70, arithmetic=arithmetic)
    before = flint.ctx.prec, mpmath.mp.prec
    try:
        flint.ctx.prec = mpmath.mp.prec = bits
        found = refine(orbit, 70, arithmetic=arithmetic)
        assert (flint.ctx.prec, mpmath.mp.prec) == (bits, bits)
        for name, x in found.unknowns.items():
            assert x._mpf_ == expected.unknowns[name]._mpf_
        assert found.trace._mpf_ == expected.trace._mpf_
        with pytest.raises(NoConvergence):
            refine(replace(orbit, unknowns=dict.fromkeys(UNKNOWNS, 1.0)), 30)
        assert (flint.ctx.prec, mpmath.mp.prec) == (bits, bits)
    finally:
        flint.ctx.prec, mpmath.mp.prec = before


def test_threads_may_refine_to_different_digits(orbits):
    irrational = orbits[1]
    expected = {d: refine(irrational, d + 20) for d in (20, 90, 400)}
    wrong = []

    def work(digits):
        for _ in range(15):
            found = refine(irrational, digits)
            if not error(found, expected[digits]) <= mpmath.mpf(10) ** -digits:
                wrong.append(digits)

    threads = [threading.Thread(target=work, args=(digits,)) for digits in expected]
    before = flint.ctx.prec
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong
    assert flint.ctx.prec == before


def test_evaluating_a_value_leaves_balls_of_other_threads_alone(monkeypatch):
    step = "nonsmooth.runtime.core.values._evaluate"
    inside, leave = threading.Event(), threading.Event()
    evaluate = resolve_name(step)

    def slow(*arguments):
        inside.set()
        leave.wait(0.1)
        return evaluate(*arguments)

    number = parse("2*pi/13")
    monkeypatch.setattr(step, slow)
    other = threading.Thread(target=number.ball, args=(64,))
    before = flint.ctx.prec
    other.start()
    try:
        assert inside.wait(60)
        with Balls().working(300):
            leave.set()
            other.join()
            assert flint.ctx.prec == 300
    finally:
        leave.set()
        other.join()
        flint.ctx.prec = before
