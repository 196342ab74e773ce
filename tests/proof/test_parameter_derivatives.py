"""Proved derivatives by parameters: against refined orbits, differences and closed forms."""

from fractions import Fraction

import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.derive import (
    Parameter,
    SecondOrder,
    Transition,
)
from nonsmooth.runtime.core.arithmetic import exact_ball
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.model.kernels import load_system
from tests.certified import (
    LOOP,
    SPRING_OF_FOUR,
    accepted,
    between_springs,
    content_of,
    loop,
    rooted,
    struck_together,
)
from tests.places import GALLERY
from tests.tables import slow

STICK = "dry-friction/global-stick"
BUILT_IN = (STICK, "dry-friction/symmetric", "rigid-stop/one-impact", "elastic-stop/one-contact")
DIGITS = 45


def about(enclosure, number):
    """Whether it contains a number of so many digits, with the error that this has."""
    with flint_precision(400):
        error = exact_ball(10.0 ** (5 - DIGITS)) * (1 + abs(exact_ball(number)))
        return bool(abs(enclosure.ball - exact_ball(number)).lower() <= error)


def agrees(found, orbit):
    """Every derivative that is enclosed is that of the orbit in many digits."""
    sharp = ns.refine(orbit, DIGITS).derivatives(tuple(found.directions))
    rates = {"period": sharp.period, "trace": sharp.trace}
    rates |= dict(zip(orbit.dwell_time_names, sharp.dwell_times, strict=True))
    rates |= {n: x for n, x in sharp.unknowns.items() if n in found.enclosures}
    assert rates.keys() <= found.derivatives.keys()
    for quantity, by in rates.items():
        for name, rate in zip(sharp.by, by, strict=True):
            enclosure = found.derivatives[quantity][name]
            assert about(enclosure, rate), (quantity, name, str(enclosure), rate)
            size = max(abs(float(enclosure)), 1.0)
            assert float(enclosure.ball.rad()) < size * 2.0 ** (5 - found.bits)
    for of, by in zip(sharp.section.multipliers, sharp.multipliers, strict=True):
        for place, parts in enumerate(found.multipliers, 1):
            re, im = map(float, parts)
            if abs(complex(re, im) - complex(of)) > 1e-9:
                continue
            for name, rate in zip(sharp.by, by, strict=True):
                assert about(found.derivatives[f"multiplier {place} re"][name], rate.real)
                imaginary = found.derivatives.get(f"multiplier {place} im")
                assert about(imaginary[name], rate.imag) if imaginary else abs(im) < 1e-9


@pytest.mark.slow
@pytest.mark.parametrize("bits", [53, 64, 300, 1000])
def test_every_precision_is_proved_again(bits, tmp_path):
    for name in BUILT_IN:
        found = ns.certify(ns.solve(name), bits, derivatives=True)
        accepted(found, tmp_path)
        widest = max(
            enclosure.ball.rad()
            for rates in found.derivatives.values()
            for enclosure in rates.values()
        )
        with flint_precision(64):
            assert widest * exact_ball(2) ** bits < 1000


@pytest.mark.slow
@pytest.mark.parametrize("name", BUILT_IN)
def test_differences_of_refined_orbits(name):
    """Starts too: they are in the system's coordinates, at parameters that were chosen."""
    orbit = ns.solve(name)
    found = ns.certify(orbit, derivatives=True)
    step = Fraction(1, 10**18)
    chosen = {n: found.parameters[n] for n in found.chosen}
    for parameter in found.directions:
        value = orbit.given[parameter].exact
        if value is None:
            continue
        sides = []
        for sign in (1, -1):
            near = ns.solve(name, {**orbit.given, **chosen, parameter: value + sign * step})
            sides.append(ns.certify(near, 256).enclosures)
        for quantity in found.enclosures:
            up, down = (side[quantity].ball for side in sides)
            with flint_precision(300):
                slope = (up - down) / (2 * exact_ball(1e-18))
            missed = abs(slope - found.derivatives[quantity][parameter].ball)
            assert missed.upper() < 1e-14 * (1 + abs(slope)), (parameter, quantity)


IRRATIONAL = {
    "three roots": lambda: loop(k="sqrt(2)", r="sqrt(2)/3", a="pi"),
    "a period": lambda: ns.solve("rigid-stop/one-impact", {"T": "2*pi", "k1": "sqrt(2)"}),
}


@pytest.mark.parametrize(
    "name",
    [
        *BUILT_IN,
        *IRRATIONAL,
        slow("backlash_gear.py:rattle"),
        "brake_pad.py:pressed",
        "den_hartog.py:without-rest",
        "impact_damper.py:struck-twice",
        "impact_oscillator.py:one-period",
        "beam.py:one-contact",
    ],
)
def test_derivatives_are_those_of_many_digits(name, tmp_path):
    if name in IRRATIONAL:
        orbit = IRRATIONAL[name]()
    else:
        orbit = ns.solve(name if name in BUILT_IN else f"{GALLERY}/{name}")
    found = ns.certify(orbit, derivatives=True)
    assert found.directions.keys() == orbit.given.keys()
    assert not found.no_derivatives
    assert found.derivatives.keys() >= found.enclosures.keys()
    agrees(found, orbit)
    accepted(found, tmp_path)
    again = ns.load(tmp_path / "found.json")
    assert again.to_json()["derivatives"] == found.to_json()["derivatives"]


def test_closed_forms():
    # tau1 = pi/sqrt(k), v0 = 1/(1 - r), and r is the multiplier and the trace
    found = ns.certify(loop(k="9/4", r="1/3"), derivatives=("k", "r")).derivatives
    assert found["trace"]["r"].contains("1")
    assert found["multiplier 1 re"]["r"].contains("1")
    assert found["trace"]["k"].contains("0")
    assert found["v0"]["r"].contains("9/4")
    with flint_precision(200):
        pi = sp.pi.evalf(50) / sp.Rational(27, 4)
        assert found["tau1"]["k"].contains(f"-{pi}") or abs(float(found["tau1"]["k"]) + pi) < 1e-15
        assert float(found["period"]["k"]) == pytest.approx(float(found["tau1"]["k"]), rel=1e-15)


def _damped():
    """Conservative at c = 0 alone; its period changes with the energy."""
    c = Parameter("c", "damping", lower="-1/2", upper="1/2")
    springs = SecondOrder([[1]], [[1]], damping=[[c.symbol]]), SPRING_OF_FOUR
    rises = Transition("left", {"rises"}, "right")
    return load_system(between_springs("damped", springs, [rises], [c], place=sp.Rational(1, 10)))


def damped_at_zero():
    """One of its family of orbits."""
    motion = ns.simulate(_damped(), {"c": "0"}, [0.0, 2.0], transitions=6)
    itinerary = ns.itinerary_of(motion)
    return ns.solve(_damped(), {"c": "0"}, itinerary=itinerary, given={"period": "4.8"})


def test_what_is_conservative_at_one_point_alone_has_no_derivative():
    found = ns.certify(damped_at_zero(), derivatives=True)
    assert found.no_derivatives.keys() == {"c"}
    assert "no energy was found" in found.no_derivatives["c"]
    assert {*found.derivatives["period"]} == {"period"}
    assert found.derivatives["period"]["period"].contains("1")


@pytest.mark.parametrize(
    ("orbit", "by", "told"),
    [
        (lambda: ns.solve("dry-friction/solution-ii"), "V", "no orbit is proved"),
        (struck_together, "c", "corner"),
        (
            lambda: ns.solve(
                rooted(), {"a": "9", "r": "1/2"}, [*[3.1, 1.5], *[0.0, 2.0]], itinerary=LOOP
            ),
            "r",
            "the declaration takes a root or a sine of its parameters",
        ),
    ],
)
def test_why_there_is_no_derivative(orbit, by, told, tmp_path):
    found = ns.certify(orbit(), derivatives=by)
    assert not found.derivatives
    assert not found.directions
    assert told in found.no_derivatives[by]
    assert told in found._repr_html_()
    accepted(found, tmp_path)
    assert ns.load(tmp_path / "found.json").no_derivatives == found.no_derivatives


def test_what_was_not_asked_for_is_not_there():
    found = ns.certify(loop())
    assert not {"derivatives", "directions", "no_derivatives"} & found.to_json().keys()
    assert "derivatives" not in content_of(found)
    with pytest.raises(InputError, match="unknown given parameter 'rr'"):
        ns.certify(loop(), derivatives=["rr"])
    with pytest.raises(InputError, match="no given parameter is named"):
        ns.certify(loop(), derivatives=[])


def test_sums_move_what_was_left_open():
    assert ns.certify(ns.solve(STICK), derivatives="e1").directions == {"e1": {"ur1": 1}}
    given = ns.solve(STICK, {"us1": "1", "ur1": "4"})
    assert ns.certify(given, derivatives="e1").directions == {"e1": {"ur1": 1}}


def test_slopes_of_energy_that_are_equal_are_told_alike_in_every_arithmetic():
    # x'' = -q sign(x), of the period T: v0 = q T/4, where both slopes of the energy are q
    load = Parameter("q", "load")
    sides = [SecondOrder([[1]], [[0]], load=[sign * load.symbol]) for sign in (-1, 1)]
    rises = Transition("left", {"rises"}, "right")
    system = between_springs("vee", (sides[0], sides[1]), [rises], [load])
    guess, given = [2, 2, 0, 1.4142], {"period": "4"}
    orbit = ns.solve(system, {"q": "sqrt(2)"}, guess, itinerary=LOOP, given=given)
    found = ns.certify(orbit, 64, derivatives=True)
    assert not found.no_derivatives
    assert found.derivatives["v0"]["q"].contains("1")
    assert found.derivatives["v0"]["period"].contains("0.35355339059327376220")
