"""Proofs of the sequence of transitions, against integration at 60 digits by other means."""

from __future__ import annotations

import math
import random
import time
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest
from flint import arb
from mpmath import MPContext

from nonsmooth import InputError, certify
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.model.structure import BoundaryShape
from nonsmooth.runtime.proof.certificate import Stated
from nonsmooth.runtime.proof.motion.ball_flow import AffineFlow
from nonsmooth.runtime.proof.motion.enclosures import enclosed_system
from nonsmooth.runtime.proof.motion.exact_rows import Invariants
from nonsmooth.runtime.proof.motion.first_crossing import first_crossing
from nonsmooth.runtime.proof.motion.motion_proof import Proof

mp = MPContext()
mp.dps = 60

FIRST = dict(chi="0.5", eta="1", V="1", us1="1", us2="1", ur1="4.0195", ur2="1.4831")
SECOND = dict(chi="0.4", eta="4", V="0.6773", us1="0.0127", ur1="0.0255", us2="0.5", ur2="1")
CHAIN = dict(m1="1", m2="2", k1="1", k2="5")
# half a period of both modes of slip-slip is 2 pi: they turn by pi and by 3 pi
COMMENSURATE = dict(chi="5/8", eta="12/5", V="1", us1="1", us2="1", ur1="100", ur2="100")
CENTRE = (Fraction(16, 3), Fraction(104, 15))
Vector = list[Any]


class Oscillator:
    """Motion by matrix exponentials and dense samples; states carry a last entry 1."""

    step = mp.mpf(1) / 32

    def __init__(self, parameters: dict[str, str]) -> None:
        self.p = {n: mp.mpf(Fraction(v).numerator) / Fraction(v).denominator
                  for n, v in parameters.items()}  # fmt: skip
        self.steps: dict[str, list[Vector]] = {}

    def field(self, configuration: str) -> list[Vector]:
        raise NotImplementedError

    def boundaries(self, configuration: str) -> dict[str, Vector]:
        raise NotImplementedError

    def after(self, configuration: str, boundary: str, state: Vector) -> tuple[str, Vector]:
        raise NotImplementedError

    def flow(self, configuration: str, state: Vector, duration: Any) -> Vector:
        field, term, total, k = self.field(configuration), state, state, 0
        while k < 20 or max(map(abs, term)) > mp.mpf(10) ** -65:
            k += 1
            term = [duration / k * x for x in times(field, term)]
            total = [a + b for a, b in zip(total, term, strict=True)]
        return total

    def advance(self, configuration: str, state: Vector) -> Vector:
        if configuration not in self.steps:
            units = [[mp.mpf(i == j) for i in range(5)] for j in range(5)]
            columns = [self.flow(configuration, unit, self.step) for unit in units]
            self.steps[configuration] = [list(row) for row in zip(*columns, strict=True)]
        return times(self.steps[configuration], state)

    def run(self, configuration: str, start: list[str], transitions: int) -> tuple[Any, ...]:
        state = [mp.mpf(Fraction(x).numerator) / Fraction(x).denominator for x in start]
        state.append(mp.mpf(1))
        now, sets = mp.mpf(0), []
        names, instants, states = [configuration], [now], [state]
        while len(sets) < transitions:
            rows = self.boundaries(configuration)
            following = self.advance(configuration, state)
            passed = [b for b, row in rows.items() if dot(row, following) > 0]
            if not passed:
                now, state = now + self.step, following
                continue
            roots = {b: self.root(configuration, rows[b], state) for b in passed}
            boundary = min(roots, key=lambda b: roots[b])
            now += roots[boundary]
            state = self.flow(configuration, state, roots[boundary])
            configuration, state = self.after(configuration, boundary, state)
            names.append(configuration)
            sets.append((boundary,))
            instants.append(now)
            states.append(state)
        return tuple(names), tuple(sets), instants, states

    def root(self, configuration: str, row: Vector, state: Vector) -> Any:
        low, high = mp.mpf(0), self.step
        field, at = self.field(configuration), high
        for _ in range(60):
            there = self.flow(configuration, state, at)
            value = dot(row, there)
            low, high = (at, high) if value < 0 else (low, at)
            slope = dot(row, times(field, there))
            better = at - value / slope if slope > 0 else mp.mpf(-1)
            better = better if low <= better <= high else (low + high) / 2
            if abs(better - at) < mp.mpf(10) ** -58:
                return better
            at = better
        return at


def dot(row: Vector, state: Vector) -> Any:
    return sum((a * b for a, b in zip(row, state, strict=True)), mp.mpf(0))


def times(matrix: list[Vector], state: Vector) -> Vector:
    return [dot(row, state) for row in matrix]


class Friction(Oscillator):
    """Equations (6) to (9) of the paper and the rule of the belt, written down once more."""

    def forces(self) -> tuple[Vector, Vector]:
        chi = self.p["chi"]
        return [1, -chi, 0, 0, 0], [-chi, chi, 0, 0, 0]

    def field(self, configuration: str) -> list[Vector]:
        rows: list[Vector] = [[0, 0, 1, 0, 0], [0, 0, 0, 1, 0]]
        inertia, slipping = (1, self.p["eta"]), (self.p["us1"], self.p["us2"])
        for mass, regime in enumerate(configuration.split("-")):
            row = [-inertia[mass] * x for x in self.forces()[mass]]
            row[4] = inertia[mass] * slipping[mass] * (1 if regime == "slip" else -1)
            rows.append([0] * 5 if regime == "stick" else row)
        return [*rows, [0] * 5]

    def boundaries(self, configuration: str) -> dict[str, Vector]:
        found = {}
        for mass, regime in enumerate(configuration.split("-")):
            name, limit = ("first", "second")[mass], self.p[("ur1", "ur2")[mass]]
            force = self.forces()[mass]
            if regime == "stick":
                found[f"{name}-breaks-forward"] = [*force[:4], -limit]
                found[f"{name}-breaks-backward"] = [*(-x for x in force[:4]), -limit]
            else:
                sign = 1 if regime == "slip" else -1
                relative = [0, 0, 1 - mass, mass, -self.p["V"]]
                found[f"{name}-reaches-belt"] = [sign * x for x in relative]
        return found

    def after(self, configuration: str, boundary: str, state: Vector) -> tuple[str, Vector]:
        mass = 0 if boundary.startswith("first") else 1
        regimes, state = configuration.split("-"), list(state)
        force, limit = dot(self.forces()[mass], state), self.p[("ur1", "ur2")[mass]]
        state[2 + mass] = self.p["V"]
        if boundary.endswith("belt"):
            regimes[mass] = "stick"
            if abs(force) > limit:
                regimes[mass] = "slip" if force > 0 else "overshoot"
        else:
            regimes[mass] = "slip" if boundary.endswith("forward") else "overshoot"
        return "-".join(regimes), state


class Stop(Oscillator):
    """Equations (1) to (4): a chain in front of a stop, rigid if there is an r."""

    def field(self, configuration: str) -> list[Vector]:
        m1, m2, k1, k2 = (self.p[n] for n in ("m1", "m2", "k1", "k2"))
        k3 = self.p["k3"] if configuration == "contact" else 0
        return [
            [0, 0, 1, 0, 0],
            [0, 0, 0, 1, 0],
            [-(k1 + k3) / m1, k1 / m1, 0, 0, k3 / m1],
            [k1 / m2, -(k1 + k2) / m2, 0, 0, 0],
            [0] * 5,
        ]

    def boundaries(self, configuration: str) -> dict[str, Vector]:
        if configuration == "contact":
            return {"first-leaves-stop": [-1, 0, 0, 0, 1]}
        return {"first-reaches-stop": [1, 0, 0, 0, -1]}

    def after(self, configuration: str, boundary: str, state: Vector) -> tuple[str, Vector]:
        state = [mp.mpf(1), *state[1:]]
        if "r" in self.p:
            return "free", [*state[:2], -self.p["r"] * state[2], *state[3:]]
        return ("free" if configuration == "contact" else "contact"), state


def starts(seed: int, count: int, fastest: Fraction, spread: int) -> list[list[str]]:
    """Exact starts of slip-slip, slower than the belt."""
    draw = random.Random(seed).randint
    return [
        [str(Fraction(draw(-spread, spread), 10)) for _ in range(2)]
        + [str(fastest - Fraction(draw(1, 20), 10)) for _ in range(2)]
        for _ in range(count)
    ]


def agrees(proof: Proof, found: tuple[Any, ...], narrow: float) -> None:
    names, sets, instants, states = found
    assert proof.decided
    assert proof.reason is None
    assert proof.configurations == names
    assert proof.sets == sets
    assert len(proof.times) == len(instants)
    for enclosure, instant in zip(proof.times, instants, strict=True):
        assert enclosure.contains(instant)
        assert float(enclosure.rad) < narrow
    for balls, state in zip(proof.states, states, strict=True):
        assert all(ball.contains(x) for ball, x in zip(balls, state[:4], strict=True))
        assert all(float(ball.rad) < narrow for ball in balls)


@pytest.mark.parametrize(
    ("data", "start"),
    [(FIRST, s) for s in starts(1, 4, Fraction(1), 60)]
    + [(SECOND, s) for s in starts(2, 4, Fraction("0.6773"), 20)],
)
def test_friction_agrees_with_60_digits(data: dict[str, str], start: list[str]) -> None:
    proof = certify.motion("dry-friction", data, start, "slip-slip", 16)
    agrees(proof, Friction(data).run("slip-slip", start, 16), 1e-20)


def test_the_starts_reach_most_configurations() -> None:
    """The comparison above says little if the motions are all alike."""
    seen = {
        name
        for data, fastest, seed, spread in ((FIRST, "1", 1, 60), (SECOND, "0.6773", 2, 20))
        for start in starts(seed, 4, Fraction(fastest), spread)
        for name in certify.motion("dry-friction", data, start, "slip-slip", 16).configurations
    }
    assert len(seen) >= 6


@pytest.mark.parametrize(
    ("system", "more"),
    [("rigid-stop", {"r": "1"}), ("rigid-stop", {"r": "0.8"}), ("elastic-stop", {"k3": "10"})],
)
def test_stops_agree_with_60_digits(system: str, more: dict[str, str]) -> None:
    data, start = CHAIN | more, ["0.5", "0.2", "1", "-0.25"]
    proof = certify.motion(system, data, start, "free", 10)
    agrees(proof, Stop(data).run("free", start, 10), 1e-20)


def test_more_bits_where_the_first_do_not_do() -> None:
    """Each transition costs digits; the sequence is the same at any precision."""
    given = "dry-friction", FIRST, START, "slip-slip", 100
    few = certify.motion(*given, 64)
    many = certify.motion(*given, 512)
    assert 64 < few.bits < 512 == many.bits
    assert (few.configurations, few.sets) == (many.configurations, many.sets)
    for wide, narrow in zip(few.times, many.times, strict=True):
        assert wide.contains(narrow.ball)
        assert narrow.ball.rad() <= wide.ball.rad()
    stopped = certify.motion(*given, 64, most_bits=64)
    assert not stopped.decided
    assert 0 < stopped.transitions < 100
    assert stopped.sets == many.sets[: stopped.transitions]


def at_multiple_of_pi(proof: Proof, factor: Fraction, narrow: float) -> bool:
    """Whether the undecided instant is that multiple of pi, and the enclosure is narrow."""
    from flint import arb, fmpq

    assert proof.instant is not None
    with flint_precision(2 * proof.bits):
        exact = arb.pi() * fmpq(factor.numerator, factor.denominator)
        return proof.instant.contains(exact) and float(proof.instant.rad) < narrow


def tangent(excess: Fraction) -> list[Fraction]:
    """Slip-stick with x1 = 1.5 + x2/2 - 1 + a cos t: v1 - V = a - 1/2 at most, at 3 pi/2."""
    return [1 + Fraction(3, 2) + Fraction(1, 2) + excess, Fraction(3), Fraction(1, 2), Fraction(1)]


TANGENT = FIRST | {"ur1": "2", "ur2": "100"}


def test_an_exact_tangency_is_not_decided() -> None:
    proof = certify.motion("dry-friction", TANGENT, tangent(Fraction(0)), "slip-stick", 1)
    assert not proof.decided
    assert proof.transitions == 0
    assert proof.bits == 2048
    assert proof.reason is not None
    assert "phase 1, slip-stick" in proof.reason
    assert "first-reaches-belt is reached tangentially" in proof.reason
    assert at_multiple_of_pi(proof, Fraction(3, 2), 1e-15)


@pytest.mark.parametrize("size", [Fraction(1, 10**20), Fraction(1, 10**60)])
def test_a_tangency_missed_by_little_is_decided(size: Fraction) -> None:
    above = certify.motion("dry-friction", TANGENT, tangent(size), "slip-stick", 1)
    below = certify.motion("dry-friction", TANGENT, tangent(-size), "slip-stick", 1)
    assert above.sets == (("first-reaches-belt",),)
    early = 3 * mp.pi / 2 - mp.acos(mp.mpf(1) / (1 + 2 * mp.mpf(size.numerator) / size.denominator))
    assert abs(float(above.times[1].ball.mid()) - float(early)) < 1e-14
    assert above.times[1].upper > float(early) > above.times[1].lower
    assert below.sets == (("second-breaks-forward",),)
    assert above.bits == below.bits == (128 if size > Fraction(1, 10**40) else 256)


def test_two_boundaries_at_one_instant_are_not_decided() -> None:
    start = [CENTRE[0] + 4, CENTRE[1] + Fraction(11, 2), -1, -1]
    proof = certify.motion("dry-friction", COMMENSURATE, start, "slip-slip", 3, most_bits=512)
    assert not proof.decided
    assert proof.transitions == 0
    assert proof.bits == 512
    assert at_multiple_of_pi(proof, Fraction(2), 1e-50)
    assert proof.reason is not None
    assert "first-reaches-belt and second-reaches-belt are reached at one instant" in proof.reason
    for velocity, first in (("-1.000001", "second"), ("-0.999999", "first")):
        apart = certify.motion("dry-friction", COMMENSURATE, [*start[:3], velocity], "slip-slip", 1)
        assert apart.decided
        assert apart.sets == ((f"{first}-reaches-belt",),)


@pytest.mark.parametrize(
    ("difference", "follows"), [("0", None), ("1e-30", "stick-slip"), ("-1e-30", "overshoot-slip")]
)
def test_a_force_exactly_at_its_limit_is_not_decided(difference: str, follows: str | None) -> None:
    """At 2 pi the first mass is at the belt's velocity and its distance is reversed."""
    start = [CENTRE[0] + 6, CENTRE[1] + Fraction(11, 2), Fraction(-1), Fraction(-1, 4)]
    limit = Fraction(25, 16) + Fraction(difference)
    data = COMMENSURATE | {"ur1": str(limit)}
    proof = certify.motion("dry-friction", data, start, "slip-slip", 1, most_bits=512)
    if follows is None:
        assert not proof.decided
        assert proof.reason is not None
        assert "at first-reaches-belt, whether overshoot-slip follows" in proof.reason
        assert at_multiple_of_pi(proof, Fraction(2), 1e-50)
    else:
        assert proof.configurations == ("slip-slip", follows)
        assert proof.sets == (("first-reaches-belt",),)
        assert proof.times[1].contains(2 * mp.pi)


def test_rest_is_proved_to_last() -> None:
    """In the middle of slip-slip, and near it, nothing is ever reached."""
    for start in (["4", "6", "0", "0"], ["4.1", "5.9", "0.2", "-0.1"]):
        proof = certify.motion("dry-friction", FIRST, start, "slip-slip", 3)
        assert proof.decided
        assert proof.transitions == 0
        assert proof.reason == "no boundary is reached any more"
    moving = certify.motion("dry-friction", FIRST, ["4", "9", "0", "0"], "slip-slip", 3)
    assert moving.transitions == 3


def test_what_resets_set_is_known_exactly() -> None:
    """A plastic impact leaves the mass on the stop at rest: balls alone could not go on."""
    data = CHAIN | {"r": "0"}
    proof = certify.motion("rigid-stop", data, ["0.5", "1.5", "1", "1"], "free", 5)
    assert proof.configurations == ("free", "free", "contact", "free", "free", "free")
    assert proof.times[2].ball.overlaps(proof.times[1].ball)
    assert proof.times[2].ball is proof.times[1].ball  # no time passes
    assert proof.states[2][0].ball == 1
    assert proof.states[2][2].ball == 0
    # off the stop once the second mass has come back to x2 = 1
    assert proof.states[3][1].contains(1)


def test_a_start_on_a_boundary() -> None:
    """It is left, or passed at once; the first derivative that is not zero says which."""
    inwards = certify.motion("rigid-stop", CHAIN | {"r": "1"}, ["1", "0", "-1", "0"], "free", 1)
    assert float(inwards.times[1]) > 1
    outwards = certify.motion("rigid-stop", CHAIN | {"r": "1"}, ["1", "0", "1", "0"], "free", 1)
    assert outwards.times[1].ball.is_zero()
    assert outwards.states[1][2].ball == -1
    # at rest on it: the spring decides, in the second derivative
    pulled = certify.motion("rigid-stop", CHAIN | {"r": "1"}, ["1", "0", "0", "-2"], "free", 1)
    assert float(pulled.times[1]) > 1
    pushed = certify.motion("rigid-stop", CHAIN | {"r": "1"}, ["1", "2", "0", "0"], "free", 1)
    assert pushed.configurations == ("free", "contact")
    assert pushed.times[1].ball.is_zero()


def test_facts_stay_as_long_as_the_field_keeps_them() -> None:
    from flint import fmpq

    at = enclosed_system("dry-friction", FIRST)(64)
    velocity = [0, 0, 1, 0, fmpq(-1)]
    position = [1, 0, 0, 0, fmpq(-2)]
    invariants = Invariants.of([velocity, position])
    stuck, slipping = (at.structure.configuration(c) for c in ("stick-slip", "slip-slip"))
    assert invariants.lasting(at.exact.fields[stuck]) == Invariants.of([velocity])
    assert invariants.lasting(at.exact.fields[slipping]) == Invariants.of([])
    # one mode of slip-slip alone: x1 + x2/2 and its velocity keep their values
    both = Invariants.of([[2, 1, 0, 0, fmpq(-88, 5)], [0, 0, 2, 1, fmpq(0)]])
    commensurate = enclosed_system("dry-friction", COMMENSURATE)(64)
    assert both.lasting(commensurate.exact.fields[slipping]) == both
    # a velocity set by a reset is known whatever came before
    assert Invariants.of([]).reset(at.exact.resets[2]) == Invariants.of([velocity])


def test_boundaries_that_are_multiples_are_reached_together() -> None:
    """No digits tell that x1 - 1 and 2 x1 - 2 vanish at one instant, their rows do."""
    from flint import arb, fmpq

    at = enclosed_system("rigid-stop", CHAIN | {"r": "1"})(128)
    twice = BoundaryShape("twice", len(at.exact.rows), False)
    rows = (*at.exact.rows, tuple(2 * x for x in at.exact.rows[0]))
    free, contact = at.structure.boundaries
    more = replace(
        at,
        structure=replace(at.structure, boundaries=((*free, twice), contact)),
        exact=replace(at.exact, rows=rows),
        flows=tuple(AffineFlow(field, rows, 128) for field in at.exact.fields),
    )
    with flint_precision(128):
        state = [arb("0.5"), arb("0.2"), arb(1), arb(0)]
        invariants = Invariants.of([[0, 0, 0, 1, fmpq(0)]])
        found = first_crossing(more, 0, invariants, invariants.lasting(at.exact.fields[0]), state)
        alone = first_crossing(at, 0, invariants, invariants.lasting(at.exact.fields[0]), state)
    assert found is not None
    assert alone is not None
    assert found[1] == (0, 1)
    assert alone[1] == (0,)
    assert found[0].overlaps(alone[0])


def test_the_start_is_taken_exactly() -> None:
    proof = certify.motion("dry-friction", FIRST, [0.1, "0.1", Fraction(1, 3), 0], "slip-slip", 0)
    binary, decimal, third, _ = proof.states[0]
    assert binary.contains(0.1)
    assert not binary.contains("0.1")
    assert decimal.contains("0.1")
    assert not decimal.contains(0.1)
    assert third.contains(Fraction(1, 3))
    named = certify.motion(
        "dry-friction", FIRST, {"v2": 0, "v1": "1/3", "x2": "0.1", "x1": 0.1}, "slip-slip", 0
    )
    assert [s.mid for s in named.states[0]] == [s.mid for s in proof.states[0]]


def test_decimals_enclose() -> None:
    proof = certify.motion("dry-friction", FIRST, ["5", "4", "0.5", "0.25"], "slip-slip", 5)
    for enclosure in proof.times[1:]:
        middle, radius = Fraction(enclosure.mid), Fraction(enclosure.rad)
        assert 0 < radius < Fraction(1, 10**25)
        with flint_precision(4 * proof.bits):
            ends = enclosure.ball.lower(), enclosure.ball.upper()
        for end in ends:
            mantissa, exponent = end.mid().man_exp()
            exact = int(mantissa) * Fraction(2) ** int(exponent)
            assert abs(exact - middle) <= radius
        assert enclosure.lower < float(enclosure) < enclosure.upper


@pytest.mark.parametrize("text", ["nan", "0 +/- inf", "+inf"])
def test_a_ball_that_is_not_finite_has_no_decimals(text: str) -> None:
    with pytest.raises(ValueError, match="is not finite"):
        Stated.around(arb(text), 64)


START = ["5", "4", "0.5", "0.25"]


@pytest.mark.parametrize(
    ("call", "told"),
    [
        (
            lambda: certify.motion("dry-friction", FIRST, START, "slip-slop", 1),
            "did you mean 'slip-slip'",
        ),
        (
            lambda: certify.motion("dry-friction", FIRST, ["5", "4", "1.5", "0"], "slip-slip", 1),
            "beyond first-reaches-belt",
        ),
        (
            lambda: certify.motion("dry-friction", FIRST, ["1", "1", "0.5", "0"], "stick-slip", 1),
            "v1 = 1",
        ),
        (
            lambda: certify.motion("dry-friction", FIRST, ["1", "1", "1", "0.9"], "stick-stick", 1),
            "v2 = 1",
        ),
        (
            lambda: certify.motion("dry-friction", FIRST, ["9", "1", "1", "0"], "stick-slip", 1),
            "beyond first-breaks-forward",
        ),
        (
            lambda: certify.motion(
                "rigid-stop", CHAIN | {"r": "0"}, ["0.5", "2", "0", "0"], "contact", 1
            ),
            "x1 = 1",
        ),
        (lambda: certify.motion("dry-friction", FIRST, START[:3], "slip-slip", 1), "not 4 numbers"),
        (lambda: certify.motion("dry-friction", FIRST, {"x1": "5"}, "slip-slip", 1), "x2, v1, v2"),
        (
            lambda: certify.motion("dry-friction", FIRST, ["sqrt(2)", *START[1:]], "slip-slip", 1),
            "not rational",
        ),
        (
            lambda: certify.motion(
                "dry-friction", FIRST | {"us1": "sqrt(1/2)"}, START, "slip-slip", 1
            ),
            r"us1 = sqrt\(1/2\) is not",
        ),
        (lambda: certify.motion("dry-friction", FIRST, START, "slip-slip", -1), "transitions = -1"),
        (lambda: certify.motion("dry-friction", FIRST, START, "slip-slip", 1, 8), "bits = 8"),
        (
            lambda: certify.motion("dry-friction", FIRST, [math.nan, *START[1:]], "slip-slip", 1),
            "not finite",
        ),
    ],
)
def test_wrong_input_is_named(call: Callable[[], Proof], told: str) -> None:
    with pytest.raises(InputError, match=told):
        call()


def test_fast_enough_for_thousands() -> None:
    """40 transitions: about 20 ms where this was written."""
    certify.motion("dry-friction", FIRST, START, "slip-slip", 1)
    before = time.process_time()
    proof = certify.motion("dry-friction", FIRST, START, "slip-slip", 40)
    assert time.process_time() - before < 1
    assert proof.decided
    assert proof.transitions == 40
    assert proof.bits == 128
