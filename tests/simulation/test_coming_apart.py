"""Boundaries that are reached together and come apart: one-sided derivatives by the moved order."""

import numpy as np
import pytest
import sympy as sp
from numpy.testing import assert_allclose, assert_array_equal

import nonsmooth as ns
from nonsmooth.derive import (
    Boundary,
    Configuration,
    FirstOrder,
    Friction,
    Parameter,
    RigidStop,
    System,
    Transition,
    oscillator,
)
from tests.moved_motions import MovedMotion, check_reverse

BY = ("p", "q", "s", "a0", "b0", "c0")


def corner(
    seed,
    velocities,
    linear=True,
    length=sp.S.One,
):
    """Four fields that meet at a = p, b = q; the one in front moves to there by (1, 1, ...).

    States are in some unit of length; p, q and s are numbers.
    """
    draw = np.random.default_rng(seed)
    states = sp.symbols("a b c", real=True)
    a, b = states[:2]
    p, q, s = found = [Parameter(name, name) for name in "pqs"]
    configurations, transitions = [], []
    for name, velocity in {"low": (1, 1), **velocities}.items():
        matrix = sp.Matrix(3, 3, lambda *_: sp.Rational(int(draw.integers(-8, 9)), 16))
        matrix = matrix if linear and name != "low" else sp.zeros(3)
        rates = [*velocity, 1 + s.symbol * int(draw.integers(1, 4))]
        load = [rate * length for rate in rates]
        boundaries = []
        if name in ("low", "other"):
            boundaries.append(Boundary("first", a - p.symbol * length))
        if name in ("low", "one"):
            boundaries.append(Boundary("second", b - q.symbol * length))
        configurations.append(Configuration(name, FirstOrder(matrix, load), tuple(boundaries)))
    transitions = [
        Transition("low", {"first"}, "one"),
        Transition("low", {"second"}, "other"),
        Transition("low", {"first", "second"}, "high"),
        Transition("one", {"second"}, "high"),
        Transition("other", {"first"}, "high"),
    ]
    system = System(
        f"corner-{seed}", "four fields", states, tuple(found), tuple(configurations), transitions
    )
    return system, {"p": 1.0, "q": 1.0, "s": 0.5}


APART = {"one": (2, 3), "other": (1, 2), "high": (1, 1)}


def one_sided_digits(system, part, name, sign, times):
    """States' one-sided derivatives by differences in fifty digits along the part's sequence.

    The sequence is that of the moved motion: no phase takes a negative time.
    """
    motion = part.trajectory
    moved = np.array([float(f"{state}0" == name) for state in motion.names])
    parameters = {key: float(key == name) for key in motion.parameters}
    follower = MovedMotion(system, motion, part.apart)
    return follower.one_sided(parameters, moved, times, sign)


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("side", ["+", "-"])
def test_the_order_is_that_of_the_moved_motion(seed, side):
    system, data = corner(seed, APART)
    motion = ns.simulate(system, data, [0, 0, 0.25], "low", until=1.5)
    assert motion.boundaries[1:] == (("first", "second"),)
    times = np.array([0.5, 1.25, 1.5])
    found = motion.derivatives(BY, times=times, one_sided=side)
    assert len(found.parts) >= 2
    sign = 1 if side == "+" else -1
    for part in found.parts:
        for column in part.columns.tolist():
            expected = one_sided_digits(system, part, BY[column], sign, times)
            assert_allclose(found.states[..., column], expected, atol=1e-12)


@pytest.mark.parametrize("side", ["+", "-"])
def test_moved_motions_differ_by_the_one_sided_derivative(side):
    """By the simulation itself, of moved numbers: what comes first is not handed over.

    Along a direction it is no sum; observables follow the sequence as well.
    """
    system, data = corner(7, APART)
    start, step = np.array([0, 0, 0.25]), 1e-6 if side == "+" else -1e-6
    motion = ns.simulate(system, data, start, "low", until=1.5)
    here, found = ns.observe(motion), motion.derivatives(BY, times=[1.5], one_sided=side)
    several = np.array([0, 0, 0, 1.0, 2.0, 0])
    for along in (*np.eye(6), several):
        moves = dict(zip("pqs", along * step, strict=False))
        moved = {name: data[name] + moves[name] for name in data}
        other = ns.simulate(system, moved, start + along[3:] * step, "low", until=1.5)
        assert other.transitions == (1 if np.flatnonzero(along)[0] in (2, 5) else 2)
        forward = found.jvp(along)
        for rates, now, before in (
            (forward["states"][0], other(1.5), motion(1.5)),
            (forward["event_times"][0], other.times[1], motion.times[1]),
            (forward["before"][1], other.before[1], motion.before[1]),
            (forward["behind"][1], other.states[-1], motion.states[-1]),
        ):
            assert_allclose(rates, (now - before) / step, atol=2e-5)
    summed = found.states[0] @ several
    assert np.abs(summed - found.jvp(several)["states"][0]).max() > 1e-3
    told = motion.derivatives(["a0", "b0"], one_sided=side).observables()
    for place in (0, 1):
        own = start + step * np.eye(3)[place]
        moved_ = ns.observe(ns.simulate(system, data, own, "low", until=1.5))
        for kind, names in (("fractions", motion.structure.configurations),
                            ("means", motion.names), ("maxima", motion.names)):  # fmt: skip
            for name in names:
                now, before = (getattr(each, kind)[name] for each in (moved_, here))
                difference = getattr(now, "value", now) - getattr(before, "value", before)
                rate = getattr(told, kind)[name][place]
                assert rate == pytest.approx(difference / step, abs=2e-5)


@pytest.mark.parametrize("side", ["+", "-"])
def test_reverse_is_forward_where_orders_differ(side):
    system, data = corner(2, APART)
    motion = ns.simulate(system, data, [0, 0, 0.25], "low", until=1.5)
    found = motion.derivatives(BY, times=[0.5, 1.5], one_sided=side)
    check_reverse(found, np.random.default_rng(1))
    assert found.condition >= 1


@pytest.mark.parametrize("length", [1, sp.Rational(1, 10**12)], ids=str)
def test_orders_that_do_not_agree_have_no_derivative_but_on_a_side(length):
    """In any unit of length."""
    system, data = corner(0, APART, length=length)
    motion = ns.simulate(system, data, [0, 0, float(length) / 4], "low", until=1.5)
    with pytest.raises(ns.InputError, match=r"first and second are reached together .* by p"):
        motion.derivatives(["s", "p"])
    # both are reached sooner or later together
    assert np.isfinite(motion.derivatives(["s", "c0"], times=[1.5]).states).all()


def test_an_order_that_leads_elsewhere_is_refused_with_its_name():
    system, data = corner(1, APART | {"one": (2, -1)}, linear=False)
    motion = ns.simulate(system, data, [0, 0, 0.25], "low", until=1.5)
    with pytest.raises(ns.InputError, match=r"first leads to one; .* on the side \+ by a0"):
        motion.derivatives(["a0"], one_sided="+")
    assert motion.derivatives(["a0"], times=[1.5], one_sided="-").states.shape == (1, 3, 1)


def twins():
    """Two masses that a spring and a damper couple, each in front of a stop of its own."""
    names = ("h1", "h2", "r1", "r2", "k", "d")
    p = [Parameter(name, name, lower=-1 if name == "d" else 0) for name in names]
    h1, h2, r1, r2, k, d = (parameter.symbol for parameter in p)
    pair = sp.Matrix([[1, -1], [-1, 1]])
    stops = [RigidStop("x1", h1, r1, name="one"), RigidStop("x2", h2, r2, name="two")]
    return oscillator(
        "twins", ["x1", "x2"], [[1, 0], [0, 2]], k * pair, d * pair, elements=stops, parameters=p
    )


TWINS = {"h1": 0.5, "h2": 0.5, "r1": 0.5, "r2": 0.75, "k": 1.25, "d": 0.0}


def test_orders_that_agree_have_a_derivative():
    """Impacts of two masses: in whichever order, as springs have no time to act in between."""
    system, data = twins(), TWINS
    motion = ns.simulate(system, data, [0, 0, 1, 1], until=0.75)
    assert motion.boundaries[1:] == (("one-reaches-stop", "two-reaches-stop"),)
    found = motion.derivatives(times=[0.25, 0.625])
    for place, name in enumerate(found.by):
        for sign in (1, -1):
            expected = one_sided_digits(system, _part(motion, name, sign), name, sign, found.times)
            assert_allclose(found.states[..., place], expected, atol=1e-12)
    apart = [name[0] in "hxv" for name in found.by]
    assert_array_equal(np.isnan(found.event_times[0]), apart)
    assert_array_equal(np.isnan(found.behind[1, 0]), apart)
    direction = np.linspace(1, 2, len(found.by))
    assert_allclose(found.jvp(direction)["states"], found.states @ direction, rtol=1e-13)
    factors = np.ones(found.states.shape[:2])
    assert_allclose(found.vjp(states=factors), found.states.sum(axis=(0, 1)), rtol=1e-12)
    assert np.isnan(found.vjp(event_times=[1.0])).tolist() == apart


@pytest.mark.slow
def test_configurations_that_were_not_visited_are_made():
    """Eight masses in equal pairs, each with a stop, four with friction as well."""
    h, r = found = [Parameter(name, name) for name in ("h", "r")]
    names = [f"x{i}" for i in range(1, 9)]
    stops = [RigidStop(name, h.symbol, r.symbol, name=f"s{name}") for name in names]
    rubs = [Friction(name, "1/10", "1/5", name=f"f{name}") for name in names[:4]]
    stiffness = sp.diag(1, 1, 2, 2, 3, 3, 4, 4) / 4
    system = oscillator(
        "pairs", names, sp.eye(8), stiffness, elements=[*stops, *rubs], parameters=found
    )
    start = np.array([0.0] * 8 + [1.0, 1.0, 1.25, 1.25, 1.5, 1.5, 1.75, 1.75])
    data, step = {"h": 0.5, "r": 0.5}, 1e-6
    motion = ns.simulate(system, data, start, until=1.2)
    assert motion.structure.unvisited
    assert [len(reached) for reached in motion.boundaries] == [0, 2, 2, 2, 2]
    found_rates = motion.derivatives(["v20", "v80"], times=[1.1])
    for place, mass in enumerate((9, 15)):
        moved = start.copy()
        moved[mass] += step
        other = ns.simulate(system, data, moved, until=1.2)
        difference = (other(1.1) - motion(1.1)) / step
        assert_allclose(found_rates.states[0, :, place], difference, atol=2e-5)


def _part(motion, name, sign):
    (part,) = motion.derivatives([name], one_sided="+" if sign > 0 else "-").parts
    return part
