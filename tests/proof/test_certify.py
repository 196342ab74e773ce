"""Certificates: what is proved is true, and what is not true is never proved."""

import math
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.runtime.core.arithmetic import exact_ball
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.proof.certificate import Stated
from tests.certified import FORCED, forced, loop
from tests.explore import test_continuation_forced as impacts
from tests.friction_sets import DATA

STICK = "dry-friction/global-stick"
CLAIMS = {
    STICK: ("proved", "proved", "stable"),
    "dry-friction/symmetric": ("proved", "refuted", "stable"),
    "rigid-stop/one-impact": ("proved", "proved", "neutral"),
    "elastic-stop/one-contact": ("proved", "proved", "neutral"),
}


def holds(enclosure, number):
    """Whether an mpmath number lies in an enclosure."""
    return bool(enclosure.ball.contains(exact_ball(number)))


def certified(orbit, bits=128):
    """What is proved of an orbit."""
    return ns.certify(orbit, bits)


@pytest.mark.parametrize("name", CLAIMS)
@pytest.mark.parametrize("bits", [64, 128, 1000])
def test_orbits_of_the_paper_are_certified(name, bits):
    orbit = ns.solve(name)
    certificate = certified(orbit, bits)
    admissible, stable, claim = CLAIMS[name]
    assert certificate.claims == {
        "existence": "proved",
        "admissibility": admissible,
        "stability": stable,
    }
    assert certificate.stability == claim
    # the kernels' equations, in another arithmetic, to more digits than the enclosures have
    sharp = ns.refine(orbit, int(bits * 0.302) + 30)
    assert holds(certificate.trace, sharp.trace)
    assert holds(certificate.enclosures["period"], sharp.period)
    for label, time in zip(sharp.dwell_time_names, sharp.dwell_times, strict=True):
        assert holds(certificate.enclosures[label], time)
    nontrivial = [
        m for m in sharp.stability.multipliers if not m.trivial and (m.real or m.imaginary)
    ]
    assert len(certificate.multipliers) == len(nontrivial)
    for m in nontrivial:
        assert any(
            holds(re, m.real) and holds(im, m.imaginary) for re, im in certificate.multipliers
        )
    for enclosure in certificate.enclosures.values():
        assert float(enclosure.ball.rad()) < 1e6 * 2.0**-bits


@pytest.mark.parametrize("text", ["nan", "0 +/- inf", "+inf"])
def test_a_ball_that_is_not_finite_has_no_decimals(text):
    with pytest.raises(ValueError, match="is not finite"):
        Stated.around(arb(text), 64)


@settings(max_examples=30)
@given(st.fractions(-9, 9), st.fractions(0, 1), st.integers(-99, 99), st.integers(1, 4))
def test_decimals_contain_their_ball(middle, radius, power, digits):
    ball = arb(*(fmpq(x.numerator, x.denominator) for x in (middle, radius))) * arb(2) ** power
    found = Stated.around(ball, 64, digits)
    with flint_precision(2000):
        middle, radius = (arb(fmpq(*Fraction(x).as_integer_ratio())) for x in found.texts)
        assert abs(ball.mid() - middle) + ball.rad() <= radius


def test_digits_beyond_those_of_pythons_integers(tmp_path):
    file = tmp_path / "many.json"
    found = certified(ns.solve("elastic-stop/one-contact"), 20_000)
    found.save(file)
    assert set(ns.certify.check(file).claims.values()) == {"proved"} == {*found.claims.values()}


def test_the_physical_start_is_the_presented_one_moved():
    orbit = ns.refine(ns.solve(STICK, {"us1": "6/5", "us2": "1.1"}), 60)
    certificate = certified(orbit)
    assert certificate.chosen == ()
    mp = orbit.arithmetic.mp
    us1, us2, chi = mp.mpf(6) / 5, mp.mpf(11) / 10, mp.mpf(1) / 2
    assert holds(certificate.enclosures["x10"], orbit.unknowns["z10"] + (us1 + us2) / (1 - chi))
    away = (chi * us1 + us2) / (chi * (1 - chi))
    assert holds(certificate.enclosures["x20"], orbit.unknowns["z20"] + away)
    assert certificate.enclosures["v10"].contains(1)


def test_parameters_may_be_irrational():
    certificate = certified(loop(k="sqrt(2)"))
    assert certificate.proved
    assert certificate.parameters["k"].text == "sqrt(2)"
    with flint_precision(400):
        period = arb.pi() / arb(2).sqrt().sqrt() + arb.pi() / 2
        assert certificate.enclosures["period"].ball.contains(period)
    belt = certified(ns.solve(STICK, {"V": "pi/3", "eta": "1"}))
    rational = certified(ns.solve(STICK, {"V": "1.04719755", "eta": "1"}))
    assert belt.proved
    assert float(belt.trace) == pytest.approx(float(rational.trace), abs=1e-7)


@pytest.mark.parametrize("name", FORCED)
def test_forced_and_damped_systems_of_users(name):
    orbit = forced(name)
    certificate = certified(orbit)
    assert certificate.proved, certificate.reasons
    assert float(certificate.trace) == pytest.approx(orbit.trace, abs=1e-9)
    for label, value in orbit.unknowns.items():
        assert float(certificate.enclosures[label]) == pytest.approx(value, abs=1e-9)
    found = sorted((complex(float(re), float(im)) for re, im in certificate.multipliers), key=abs)
    wanted = sorted(orbit.multipliers, key=abs)[-len(found) :]
    assert np.allclose(np.sort_complex(found), np.sort_complex(wanted), atol=1e-8)


def times(orbit, count):
    """The same orbit, passed so many times."""
    guess = [*orbit.dwell_times.tolist() * count, *orbit.states[0]]
    return ns.solve(orbit.system, orbit.parameters, guess, itinerary=orbit.itinerary * count)


def test_a_long_itinerary_is_enclosed_as_sharply_as_its_part():
    """Products of 48 plain balls are hundreds of times wider than what they enclose."""
    orbit = forced("slider")
    part, whole = certified(orbit), certified(times(orbit, 12))
    assert whole.proved
    assert float(whole.trace) == pytest.approx(sum(orbit.multipliers**12).real, rel=1e-9)
    widths = [max(e.ball.rad() for e in c.enclosures.values()) for c in (part, whole)]
    assert widths[1] < 50 * widths[0]
    with flint_precision(200):
        period = part.enclosures["period"].ball * 12
        assert whole.enclosures["period"].ball.overlaps(period)


def test_a_long_itinerary_is_proved_over_a_box():
    found = ns.certify.box(times(loop(r="-9/10"), 5), {"r": ("-0.905", "-0.895")})
    assert found.proved
    ends = [-(0.905**5), -(0.895**5)]
    trace = found.enclosures["trace"]
    assert trace.lower <= ends[0] < ends[1] <= trace.upper
    assert trace.upper - trace.lower < 1.5 * (ends[1] - ends[0])
    assert found.enclosures["v0"].contains(1 / Fraction("1.9"))


@settings(max_examples=40)
@given(
    left=st.integers(-19_999, 19_999), root=st.fractions("1/9", 9, max_denominator=50),
    bits=st.sampled_from([64, 100, 300]),
)  # fmt: skip
def test_enclosures_contain_closed_forms(left, root, bits):
    # near r = 1 the equations are nearly singular, near -1 a multiplier is
    r = Fraction(left, 10_000)
    if r == 1:
        return
    orbit = loop(r=str(r), k=str(root**2), a="100000")
    if not orbit.converged or r > 1:
        return
    certificate = certified(orbit, bits)
    if certificate.claims["existence"] != "proved":
        return
    start = certificate.enclosures["v0"]
    assert start.contains(1 / (1 - r))
    assert certificate.trace.contains(r)
    assert all(re.contains(r) and im.contains(0) for re, im in certificate.multipliers)
    assert certificate.enclosures["x0"].contains(0)
    with flint_precision(2 * bits):
        half = arb.pi() / arb(fmpq(root.numerator, root.denominator))
        assert certificate.enclosures["tau1"].ball.contains(half)
        assert certificate.enclosures["tau2"].ball.contains(arb.pi() / 2)
    wanted = "proved" if abs(r) < 1 else "undecided" if abs(r) == 1 else "refuted"
    assert certificate.claims["stability"] == wanted


@pytest.mark.parametrize("size", [1e-4, 1e-3, 1e-2, 0.3])
def test_perturbed_orbits_are_not_proved(size):
    orbit = loop()
    dwell = orbit.dwell_time_names
    for moved in (
        replace(
            orbit,
            unknowns={n: x * (1 + size * (n in dwell)) for n, x in orbit.unknowns.items()},
        ),
        replace(orbit, starts=orbit.states + size),
    ):
        certificate = certified(moved)
        assert certificate.claims["existence"] in ("refuted", "undecided")
        assert set(certificate.claims.values()) - {certificate.claims["existence"]} <= {"undecided"}
        assert certificate.reasons["existence"]
    assert certified(moved).claims["existence"] == "refuted"


@pytest.mark.parametrize(
    ("wall", "verdict"),
    [("2001/1000", "proved"), ("2", "undecided"), ("1999/1000", "refuted"),
     ("2.000000000000000001", "proved"), ("1.999999999999999999", "refuted")],
)  # fmt: skip
def test_tangent_orbits_are_undecided(wall, verdict):
    # the orbit goes as far as 2: a wall there is touched without speed
    certificate = certified(loop(a=wall))
    assert certificate.claims["existence"] == "proved"
    assert certificate.claims["admissibility"] == verdict
    if verdict == "refuted":
        assert "phase 1, right: wall is crossed" in certificate.reasons["admissibility"]
    elif verdict == "undecided":
        assert "wall" in certificate.reasons["admissibility"]


def back_in_time():
    """Half a turn backwards leads where half a turn forwards does."""
    orbit = loop()
    return replace(orbit, unknowns={**orbit.unknowns, "tau1": -math.pi})


OUTSIDE = "outside the unit circle"
# of orbits that exist: a claim, its verdict, and a part of the reason
VERDICTS = {
    "at a flip": (lambda: loop(r="-1"), "stability", "undecided", ""),
    "before a flip": (lambda: loop(r="-0.99999999"), "stability", "proved", ""),
    "behind a flip": (lambda: loop(r="-1.00000001"), "stability", "refuted", OUTSIDE),
    "far behind a flip": (lambda: loop(r="-2"), "stability", "refuted", OUTSIDE),
    "of the paper, behind a flip": (
        lambda: ns.solve("dry-friction/symmetric", {"V": "0.9"}), "stability", "refuted", OUTSIDE
    ),
    "a pair off the circle": (
        lambda: ns.solve("rigid-stop/one-impact", {"k2": "1.456", "T": "6.1"}),
        "stability", "refuted", OUTSIDE,
    ),
    "a pair and a flip": (lambda: impacts.orbit(-0.05), "stability", "refuted", OUTSIDE),
    # multiplied by 2 the speed returns negative: the mass begins behind the boundary that it
    # then comes to from outside
    "beyond a boundary": (
        lambda: loop(r="2"), "admissibility", "refuted", "falls is passed where it begins"
    ),
    "back in time": (back_in_time, "admissibility", "refuted", "its dwell time is negative"),
}  # fmt: skip


@pytest.mark.parametrize("name", VERDICTS)
def test_verdicts_on_orbits_that_exist(name):
    orbit, claim, verdict, told = VERDICTS[name]
    certificate = certified(orbit())
    assert certificate.claims["existence"] == "proved"
    assert certificate.claims[claim] == verdict
    assert told in certificate.reasons.get(claim, "")
    assert certificate.decided == (verdict != "undecided")
    if claim == "stability":
        assert certificate.claims["admissibility"] == "proved"


def test_margins_are_true():
    orbit = ns.solve(STICK, {"us1": 1, "us2": 1})
    first = certified(orbit)
    values = {name: value.text for name, value in first.parameters.items()}
    dwell = orbit.dwell_times.tolist()
    composed = ns.solve("dry-friction", values, dwell, itinerary=first.itinerary)
    certificate = certified(composed)
    motion = composed.trajectory()
    system = composed.tables.piecewise
    begins = np.concatenate([[0], np.cumsum(composed.dwell_times)])
    shapes = system.structure.boundaries
    declared = [
        (place + 1, boundary.name)
        for place, (name, _) in enumerate(composed.itinerary)
        for boundary in shapes[system.structure.configuration(name)]
    ]
    order = [declared.index((m["phase"], m["boundary"])) for m in certificate.margins]
    assert order == sorted(order)
    assert {*order} == {*range(len(declared))}
    for margin in certificate.margins:
        place = margin["phase"] - 1
        index = system.structure.configuration(margin["configuration"])
        boundary = system.structure.boundary(index, margin["boundary"])
        row = system.rows[system.structure.boundaries[index][boundary].row]
        times = np.linspace(begins[place], begins[place + 1], 400)[1:-1]
        values_along = motion(times) @ row[:-1] + row[-1]
        least = float(margin["least"])
        assert least > 0
        if margin["quantity"] == "distance":
            assert values_along.max() < -least
            assert least > 0.74 * -values_along.max()
        elif margin["quantity"] == "speed":
            end = composed.tables.shooting.ends[place]
            rate = row[:-1] @ (system.fields[index][:, :-1] @ end + system.fields[index][:, -1])
            assert rate > least
            assert rate < 1.1 * least
        assert values_along.max() < 0


def test_border_collisions_and_exchanged_unknowns_are_undecided():
    collision = certified(ns.solve("dry-friction/solution-ii"))
    assert set(collision.claims.values()) == {"undecided"}
    assert "border collision" in collision.reasons["existence"]
    exchanged = ns.solve(STICK, unknown=["e1", "e2"], given={"ta": 1, "tau": 2})
    certificate = certified(exchanged)
    assert set(certificate.claims.values()) == {"undecided"}
    assert "e1, e2" in certificate.reasons["existence"]


def test_wrong_input():
    orbit = loop()
    for bits in (0, 52, 400_001, True, "128"):
        with pytest.raises(InputError, match="bits"):
            ns.certify(orbit, bits)  # type: ignore[arg-type]  # that is what is refused
    with pytest.raises(InputError, match="cannot be certified"):
        ns.certify(replace(orbit, status=1))


def test_what_is_no_orbit_is_refused_by_where_orbits_are():
    found = ns.find_orbits("dry-friction", DATA, n=2, transitions=60)
    ask = (
        ns.certify,
        lambda orbit: ns.refine(orbit, 20),
        lambda orbit: ns.continue_orbit(orbit, "V", (0.9, 1.1)),
    )
    for question in ask:
        with pytest.raises(InputError, match=r"not a Found; it has \.orbits"):
            question(found)
        with pytest.raises(InputError, match="orbit takes an orbit, as solve returns"):
            question("dry-friction/global-stick")


def test_an_orbit_is_the_same_by_either_route_and_undecided_from_no_numbers():
    derived = certified(ns.solve("elastic-stop/one-contact"))
    values = {name: value.text for name, value in derived.parameters.items()}
    dwell = [float(derived.enclosures[name]) for name in derived.dwell_names]
    composed = ns.solve(
        "elastic-stop", values, dwell, itinerary=derived.itinerary, given={"period": "2*pi"}
    )
    certificate = certified(composed)
    assert certificate.claims == derived.claims
    assert certificate.trace.ball.overlaps(derived.trace.ball)
    lost = certified(replace(composed, starts=np.full_like(composed.states, np.nan)))
    assert set(lost.claims.values()) == {"undecided"}
    assert "slopes of its energy are not finite" in lost.reasons["existence"]
