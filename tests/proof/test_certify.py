"""Certificates: what is proved is true, and what is not true is never proved."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from flint import acb, arb, arb_mat, fmpq
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.runtime.core.arithmetic import exact_ball
from nonsmooth.runtime.core.values import flint_precision, parse
from nonsmooth.runtime.events.leading_derivative import Undecided
from nonsmooth.runtime.proof.admissibility import OpenInequality, _Phase, _Refuted
from nonsmooth.runtime.proof.admissibility_conditions import (
    Condition,
    Derivative,
    Follower,
    Watched,
)
from nonsmooth.runtime.proof.boxes.orbit_over_box import region_at
from nonsmooth.runtime.proof.boxes.tile import Anchor, _joined
from nonsmooth.runtime.proof.certify_orbit import MOST_BITS
from nonsmooth.runtime.proof.exact_tables import tables_of
from nonsmooth.runtime.proof.krawczyk import krawczyk, newton
from nonsmooth.runtime.proof.motion.motion_proof import Enclosure
from nonsmooth.runtime.proof.multipliers import apart, inside_circle, neutral_pairs
from nonsmooth.runtime.proof.orbit_equations import Equations
from nonsmooth.runtime.proof.orbit_to_prove import (
    Subject,
    subject_of,
)
from nonsmooth.runtime.proof.symplectic_form import symplectic_form
from tests.certified import FORCED, forced, loop

STICK = "dry-friction/global-stick"
CLAIMS = {
    STICK: ("proved", "proved", "stable"),
    "dry-friction/symmetric": ("proved", "refuted", "stable"),
    "rigid-stop/one-impact": ("proved", "proved", "neutral"),
    "elastic-stop/one-contact": ("proved", "proved", "neutral"),
}


def holds(enclosure: Enclosure, number: Any) -> bool:
    """Whether an mpmath number lies in an enclosure."""
    return bool(enclosure.ball.contains(exact_ball(number)))


@pytest.mark.parametrize("name", CLAIMS)
@pytest.mark.parametrize("bits", [64, 128, 1000])
def test_orbits_of_the_paper_are_certified(name: str, bits: int) -> None:
    orbit = ns.solve(name)
    certificate = ns.certify(orbit, bits)
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


def test_digits_beyond_those_of_pythons_integers(tmp_path: Path) -> None:
    file = tmp_path / "many.json"
    found = ns.certify(ns.solve("elastic-stop/one-contact"), 20_000)
    found.save(file)
    assert set(ns.check_certificate(file).claims.values()) == {"proved"} == {*found.claims.values()}


def test_the_physical_start_is_the_presented_one_moved() -> None:
    orbit = ns.refine(ns.solve(STICK, {"us1": "6/5", "us2": "1.1"}), 60)
    certificate = ns.certify(orbit)
    assert certificate.chosen == ()
    mp = orbit.arithmetic.mp
    us1, us2, chi = mp.mpf(6) / 5, mp.mpf(11) / 10, mp.mpf(1) / 2
    assert holds(certificate.enclosures["x10"], orbit.unknowns["z10"] + (us1 + us2) / (1 - chi))
    away = (chi * us1 + us2) / (chi * (1 - chi))
    assert holds(certificate.enclosures["x20"], orbit.unknowns["z20"] + away)
    assert certificate.enclosures["v10"].contains(1)


def test_open_parameters_are_chosen_and_named() -> None:
    certificate = ns.certify(ns.solve(STICK))
    assert certificate.chosen == ("us1", "us2")
    values = {name: value.exact for name, value in certificate.parameters.items()}
    assert values["ur1"] - values["us1"] == ns.solve(STICK).given["e1"].exact


def test_closed_forms_lie_in_the_enclosures() -> None:
    certificate = ns.certify(loop(), 200)
    assert certificate.proved
    with flint_precision(400):
        assert certificate.enclosures["period"].ball.contains(3 * arb.pi() / 2)
    assert certificate.trace.contains("1/2")
    assert certificate.enclosures["v0"].contains(2)
    (multiplier,) = certificate.multipliers
    assert multiplier[0].contains("1/2")
    assert multiplier[1].contains(0)


def test_parameters_may_be_irrational() -> None:
    certificate = ns.certify(loop(k="sqrt(2)"))
    assert certificate.proved
    assert certificate.parameters["k"].text == "sqrt(2)"
    with flint_precision(400):
        period = arb.pi() / arb(2).sqrt().sqrt() + arb.pi() / 2
        assert certificate.enclosures["period"].ball.contains(period)
    belt = ns.certify(ns.solve(STICK, {"V": "pi/3", "eta": "1"}))
    rational = ns.certify(ns.solve(STICK, {"V": "1.04719755", "eta": "1"}))
    assert belt.proved
    assert float(belt.trace) == pytest.approx(float(rational.trace), abs=1e-7)


@pytest.mark.parametrize("name", FORCED)
def test_forced_and_damped_systems_of_users(name: str) -> None:
    orbit = forced(name)
    certificate = ns.certify(orbit)
    assert certificate.proved, certificate.reasons
    assert float(certificate.trace) == pytest.approx(orbit.trace, abs=1e-9)
    for label, value in orbit.unknowns.items():
        assert float(certificate.enclosures[label]) == pytest.approx(value, abs=1e-9)
    found = sorted((complex(float(re), float(im)) for re, im in certificate.multipliers), key=abs)
    wanted = sorted(orbit.multipliers, key=abs)[-len(found) :]
    assert np.allclose(np.sort_complex(found), np.sort_complex(wanted), atol=1e-8)


def test_damping_and_restitution_give_the_product_of_the_multipliers() -> None:
    orbit = forced("rigid")
    certificate = ns.certify(orbit)
    product = np.prod([complex(float(re), float(im)) for re, im in certificate.multipliers])
    # Liouville: the damping 1/10 shrinks areas, and each impact by the square of 4/5
    impacts = len(orbit.itinerary)
    wanted = 0.64**impacts * math.exp(-0.1 * float(certificate.enclosures["period"]))
    assert product == pytest.approx(wanted, rel=1e-10)


@settings(max_examples=15, deadline=None, derandomize=True,
          suppress_health_check=[HealthCheck.too_slow])  # fmt: skip
@given(eta=st.integers(940, 1060), speed=st.integers(950, 1050))
def test_enclosures_contain_the_refined_values(eta: int, speed: int) -> None:
    orbit = ns.solve(STICK, {"eta": f"{eta}/1000", "V": f"{speed}/1000"}, throw=False)
    if not orbit.converged:
        return
    certificate = ns.certify(orbit, 100)
    sharp = ns.refine(orbit, 100)
    assert certificate.claims["existence"] == "proved"
    assert holds(certificate.trace, sharp.trace)
    for label, time in zip(sharp.dwell_time_names, sharp.dwell_times, strict=True):
        assert holds(certificate.enclosures[label], time)
    verdicts = {"stable": "proved", "unstable": "refuted"}
    assert certificate.claims["stability"] in (verdicts[orbit.stability.verdict], "undecided")
    seen = {True: "proved", "conditional": "proved", False: "refuted"}
    assert certificate.claims["admissibility"] in (seen[orbit.admissibility.verdict], "undecided")


@settings(max_examples=40, deadline=None, derandomize=True)
@given(
    left=st.integers(-19_999, 19_999), root=st.fractions("1/9", 9, max_denominator=50),
    bits=st.sampled_from([64, 100, 300]),
)  # fmt: skip
def test_enclosures_contain_closed_forms(left: int, root: Fraction, bits: int) -> None:
    # near r = 1 the equations are nearly singular, near -1 a multiplier is
    r = Fraction(left, 10_000)
    if r == 1:
        return
    orbit = loop(r=str(r), k=str(root**2), a="100000")
    if not orbit.converged or r > 1:
        return
    certificate = ns.certify(orbit, bits)
    if certificate.claims["existence"] != "proved":
        return
    start = certificate.enclosures["v0"]
    assert start.contains(1 / (1 - r))
    assert certificate.trace.contains(r)
    assert certificate.enclosures["x0"].contains(0)
    with flint_precision(2 * bits):
        half = arb.pi() / arb(fmpq(root.numerator, root.denominator))
        assert certificate.enclosures["tau1"].ball.contains(half)
        assert certificate.enclosures["tau2"].ball.contains(arb.pi() / 2)
    wanted = "proved" if abs(r) < 1 else "undecided" if abs(r) == 1 else "refuted"
    assert certificate.claims["stability"] == wanted


@pytest.mark.parametrize("size", [1e-4, 1e-3, 1e-2, 0.3])
def test_perturbed_orbits_are_not_proved(size: float) -> None:
    orbit = loop()
    dwell = orbit.dwell_time_names
    for moved in (
        replace(
            orbit,
            unknowns={n: x * (1 + size * (n in dwell)) for n, x in orbit.unknowns.items()},
        ),
        replace(orbit, starts=orbit.states + size),
    ):
        certificate = ns.certify(moved)
        assert certificate.claims["existence"] in ("refuted", "undecided")
        assert set(certificate.claims.values()) - {certificate.claims["existence"]} <= {"undecided"}
        assert certificate.reasons["existence"]
    assert ns.certify(moved).claims["existence"] == "refuted"


def problem(subject: Subject, bits: int) -> tuple[Equations, list[arb]]:
    """Equations of a subject, and a point near their root."""
    region = region_at(subject, bits)

    def equations() -> Equations:
        return region.equations(region.tables.number_at())

    point = newton(equations, region.guess, bits)
    assert point is not None
    return equations(), point


def test_boxes_with_no_orbit_with_one_and_with_two() -> None:
    with flint_precision(128):
        equations, root = problem(subject_of(forced("rigid")), 128)
        radii = [arb(2) ** -30] * len(root)
        one = krawczyk(equations, root, radii)
        assert one.unique
        assert not one.empty
        shifted = [x + arb(2) ** -20 for x in root]
        none = krawczyk(equations, shifted, radii)
        assert none.empty
        assert not none.unique
        # a period of the forcing later the same orbit is another root of the equations
        later = arb.pi() / arb(equations.speeds[0])
        place = equations.first - 1
        middle = [*root[:place], root[place] + later, *root[place + 1 :]]
        wide = [*radii[:place], 1.01 * later, *radii[place + 1 :]]
        both = krawczyk(equations, middle, wide)
        assert not both.unique
        assert not both.empty


def test_another_root_of_the_equations_is_not_the_orbit_that_was_found() -> None:
    """Half turns more make another one: no box that holds both has one root alone."""
    subject = subject_of(loop())
    with flint_precision(128):
        region, (_, root) = region_at(subject, 128), problem(subject, 128)
        anchor = Anchor((), root)
        assert _joined(region, anchor, root)
        assert _joined(region, anchor, [x + arb(2) ** -30 for x in root])
        for place, turn in ((2, 2 * arb.pi()), (3, arb.pi())):
            other = [*root[:place], root[place] + turn, *root[place + 1 :]]
            assert not _joined(region, anchor, other)


@pytest.mark.parametrize(
    ("wall", "verdict"),
    [("2001/1000", "proved"), ("2", "undecided"), ("1999/1000", "refuted"),
     ("2.000000000000000001", "proved"), ("1.999999999999999999", "refuted")],
)  # fmt: skip
def test_tangent_orbits_are_undecided(wall: str, verdict: str) -> None:
    # the orbit goes as far as 2: a wall there is touched without speed
    certificate = ns.certify(loop(a=wall))
    assert certificate.claims["existence"] == "proved"
    assert certificate.claims["admissibility"] == verdict
    if verdict != "proved":
        assert "wall" in certificate.reasons["admissibility"]


@pytest.mark.parametrize(
    ("r", "verdict"),
    [("-1", "undecided"), ("-2", "refuted"), ("-0.99999999", "proved"), ("-1.00000001", "refuted")],
)
def test_at_a_flip_stability_is_undecided(r: str, verdict: str) -> None:
    certificate = ns.certify(loop(r=r))
    assert certificate.claims["existence"] == "proved"
    assert certificate.claims["stability"] == verdict
    assert certificate.decided == (verdict != "undecided")


def test_near_a_fold_either_the_orbit_is_proved_or_nothing() -> None:
    # at r = 1 the orbit has gone to infinity: v0 = 1/(1 - r)
    certificate = ns.certify(loop(r="0.999999"))
    assert certificate.claims["existence"] == "proved"
    assert certificate.enclosures["v0"].contains(1_000_000)


def test_an_orbit_that_crosses_a_boundary_is_refuted_with_its_place() -> None:
    certificate = ns.certify(loop(a="1"))
    assert certificate.claims["admissibility"] == "refuted"
    assert "phase 1, right: wall is crossed" in certificate.reasons["admissibility"]


def test_margins_are_true() -> None:
    orbit = ns.solve(STICK, {"us1": 1, "us2": 1})
    first = ns.certify(orbit)
    values = {name: value.text for name, value in first.parameters.items()}
    dwell = orbit.dwell_times.tolist()
    composed = ns.solve("dry-friction", values, dwell, itinerary=first.itinerary)
    certificate = ns.certify(composed)
    motion = composed.trajectory()
    system = composed.tables.piecewise
    begins = np.concatenate([[0], np.cumsum(composed.dwell_times)])
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
        elif margin["quantity"] == "speed":
            end = composed.tables.shooting.ends[place]
            rate = row[:-1] @ (system.fields[index][:, :-1] @ end + system.fields[index][:, -1])
            assert rate > least
            assert rate < 1.1 * least
        assert values_along.max() < 0


def test_conservative_cycles_are_recognised_exactly() -> None:
    subject = subject_of(ns.solve("rigid-stop/one-impact"))
    values = dict(subject.values)
    elastic = tables_of(subject.kernels, tuple(values.values()), 128)
    form = symplectic_form(elastic, subject.cycle)
    assert form is not None
    (energy,) = form.energies.values()
    # m x'' = -K x: the stiffness matrix, and the masses, in the units of the form
    unit = energy[2][2]
    assert [energy[i][j] / unit for i, j in ((0, 0), (0, 1), (1, 1), (3, 3))] == [1, -1, 6, 2]
    values["r"] = parse("0.9")
    assert symplectic_form(tables_of(subject.kernels, tuple(values.values()), 128),
                           subject.cycle) is None  # fmt: skip


def section(first: float, second: float) -> arb_mat:
    """A matrix with the eigenvalues 0, 1 and two pairs with m + 1/m as given."""
    blocks = np.zeros((6, 6))
    blocks[1, 1] = 1
    for place, total in ((2, first), (4, second)):
        blocks[place : place + 2, place : place + 2] = [[0, -1], [1, total]]
    turn = np.eye(6) + np.diag(np.arange(1.0, 6), 1)  # integers, and so is its inverse
    inverse = np.round(np.linalg.inv(turn))
    return arb_mat((turn @ blocks @ inverse).tolist())


@pytest.mark.parametrize(
    ("sums", "verdict"),
    [((0.5, -1.25), True), ((0.5, 2.25), False), ((-2.25, 1), False), ((0.5, 0.5), None),
     ((2.0, 0.5), None)],
)  # fmt: skip
def test_pairs_on_the_unit_circle(sums: tuple[float, float], verdict: bool | None) -> None:
    with flint_precision(128):
        matrix = section(*sums)
        trace = sum((matrix[i, i] for i in range(6)), arb(0))
        found, multipliers = neutral_pairs(matrix, trace)
    assert found is verdict
    if multipliers is not None:
        assert len(multipliers) == 4
        for total in sums:
            assert sum(bool((m + 1 / m).overlaps(acb(total))) for m in multipliers) == 2


@pytest.mark.parametrize(
    ("matrix", "verdict"),
    [([[0.5, 1e6], [0, 0.5]], True), ([[0, 1], [-1, 0]], None), ([[1, 0], [0, 0]], None),
     ([[0.5, 1], [0, -1.001]], False), ([[0, 1e9], [0, 0]], True)],
)  # fmt: skip
def test_eigenvalues_inside_the_unit_circle(matrix: Any, verdict: bool | None) -> None:
    with flint_precision(128):
        assert inside_circle(arb_mat(matrix)) is verdict


def test_border_collisions_and_exchanged_unknowns_are_undecided() -> None:
    collision = ns.certify(ns.solve("dry-friction/solution-ii"))
    assert set(collision.claims.values()) == {"undecided"}
    assert "border collision" in collision.reasons["existence"]
    exchanged = ns.solve(STICK, unknown=["e1", "e2"], given={"ta": 1, "tau": 2})
    certificate = ns.certify(exchanged)
    assert set(certificate.claims.values()) == {"undecided"}
    assert "e1, e2" in certificate.reasons["existence"]


def test_wrong_input() -> None:
    orbit = loop()
    for bits in (0, 52, MOST_BITS + 1, True, "128"):
        with pytest.raises(InputError, match="bits"):
            ns.certify(orbit, bits)  # type: ignore[arg-type]  # that is what is refused
    with pytest.raises(InputError, match="cannot be certified"):
        ns.certify(replace(orbit, status=1))


def test_what_is_no_orbit_is_refused_by_where_orbits_are() -> None:
    data = {"chi": "0.5", "eta": 1, "V": 1, "us1": 1, "us2": 1, "ur1": "4.0195", "ur2": "1.4831"}
    found: Any = ns.find_orbits("dry-friction", data, n=2, transitions=60)
    ask: tuple[Callable[[Any], object], ...] = (
        ns.certify,
        lambda orbit: ns.refine(orbit, 20),
        lambda orbit: ns.continue_orbit(orbit, "V", (0.9, 1.1)),
    )
    for question in ask:
        with pytest.raises(InputError, match=r"a Found cannot be .*\.orbits of a Found"):
            question(found)
        with pytest.raises(InputError, match=r"a str cannot be .*what solve gives"):
            question("dry-friction/global-stick")


def test_an_orbit_is_the_same_by_either_route() -> None:
    derived = ns.certify(ns.solve("elastic-stop/one-contact"))
    values = {name: value.text for name, value in derived.parameters.items()}
    dwell = [float(derived.enclosures[name]) for name in derived.dwell_names]
    composed = ns.solve(
        "elastic-stop", values, dwell, itinerary=derived.itinerary, given={"period": "2*pi"}
    )
    certificate = ns.certify(composed)
    assert certificate.claims == derived.claims
    assert certificate.trace.ball.overlaps(derived.trace.ball)


# --- what a proof rests on, piece by piece ----------------------------------------------


def phase_at(*behind: int) -> Any:
    """A phase that ends at a state; the rest is not asked for."""
    phase = object.__new__(_Phase)
    phase.behind = [arb(x) for x in behind]
    phase.ending, phase.assumed, phase.open = (
        OpenInequality("vanishing-phase", 0, "stop", ""),
        (),
        [],
    )
    return phase


def test_a_dwell_time_is_positive_refuted_or_undecided() -> None:
    phase = phase_at()
    phase.dwell = arb(-1)
    with pytest.raises(_Refuted, match="dwell time"):
        phase.judged()
    phase.dwell = arb(0, 1)
    assert phase.judged() == []
    assert phase.open == [(phase.ending, "its dwell time cannot be told from 0")]


def test_a_boundary_is_reached_from_inside_refuted_or_undecided() -> None:
    def watched(ends: tuple[int, int], speed: tuple[int, int]) -> Watched:
        rows = (tuple(map(fmpq, ends)), tuple(map(fmpq, speed)))
        return Watched("wall", (), None, 1, False, True, *rows)

    phase, zero = phase_at(3), (0, 0)
    assert phase._speed(watched(zero, (2, 1))) == 7
    for ends, speed, error in (
        (zero, (-2, 1), _Refuted),
        (zero, (1, -3), Undecided),
        ((1, 0), (2, 1), _Refuted),
        ((1, -3), (2, 1), Undecided),
    ):
        with pytest.raises(error, match="reached"):
            phase._speed(watched(ends, speed))


def test_what_follows_is_the_wanted_transition_refuted_or_undecided() -> None:
    def follower(target: str, wanted: bool, sign: int, doubt: str = "") -> Follower:
        """It follows if 3 sign > 0, for a sign that may be zero."""
        derivative = Derivative(0, (fmpq(sign), fmpq(0)))
        return Follower(target, wanted, (Condition(derivative, True),), doubt)

    phase = phase_at(3)
    phase._first([follower("a", False, -1), follower("b", True, 1), follower("c", False, 1)])
    for followers, error, said in (
        ([follower("a", False, 1), follower("b", True, 1)], _Refuted, "a follows"),
        ([follower("a", False, 1, "by a law"), follower("b", True, 1)], Undecided, "by a law"),
        ([follower("b", True, -1)], _Refuted, "b does not follow"),
        ([follower("a", False, 0), follower("b", True, 1)], Undecided, "whether"),
    ):
        with pytest.raises(error, match=said):
            phase._first(followers)


def test_multipliers_that_lie_too_near_are_not_stated() -> None:
    """To each other, to the trivial 1, or to zero, of which there are as many as are left."""
    half = acb("0.5")
    with flint_precision(192):
        near = acb(arb(0.5) + arb(2) ** -80)
        one = acb(1 - arb(2) ** -80)
        tiny = acb(arb(2) ** -80)
        assert len(apart([half, acb("-0.5")], 4, trivial=True)) == 2
        assert apart([half, near, acb("-0.5")], 3, trivial=False) == (acb("-0.5"),)
        assert apart([half, one], 3, trivial=True) == (half,)
        assert apart([one], 1, trivial=False) == (one,)
        assert apart([tiny], 2, trivial=False) == ()
        assert apart([tiny], 1, trivial=False) == (tiny,)
