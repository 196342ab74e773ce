"""What is proved of the trace of an orbit, and what is not: each verdict and its reason."""

from __future__ import annotations

from dataclasses import replace
from decimal import Decimal
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from nonsmooth import InputError, refine, solve
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.present.report import trace_proof_json
from nonsmooth.runtime.proof import certify_orbit
from tests.places import CHECKOUT

STICK, RIGID = "dry-friction/global-stick", "rigid-stop/one-impact"
RATIONAL = {"m1": 1, "m2": 2, "k1": 2, "k2": 4}  # frequencies 1 and 2
BUMP = """
import sympy as sp
from nonsmooth.derive import Itinerary, Parameter, Reference, SoftStop, oscillator

k, v = sp.Symbol("k"), sp.Symbol("v", real=True)
system = oscillator(
    "bump", ["x"], mass=[[1]], stiffness=[[1]],
    elements=[SoftStop("x", at=1, stiffness=k, name="stop")],
    parameters=[Parameter("k", "stop")], description="a mass before an elastic stop",
)
contact, free = ("contact", "stop-leaves-stop"), ("free", "stop-reaches-stop")
orbits = [Itinerary(
    "one", system, ((*contact, "on"), (*free, "off")), start={"v": "u"}, reversor={v: -v},
    period=Parameter("T", "period"),
    reference=Reference({"k": "3", "T": "5"}, {"u": "5.13", "on": "1.47"}),
)]
"""


@cache
def sharp(name: str, **given: Any) -> Orbit:
    return refine(solve(name, given), 20)


def elsewhere() -> Orbit:
    """Numbers around which no box holds an orbit."""
    orbit = sharp(STICK)
    return replace(orbit, unknowns={n: x + 1 for n, x in orbit.unknowns.items()})


def gallery(name: str, **given: Any) -> Orbit:
    return sharp(f"{CHECKOUT / 'docs/gallery'}/{name}", **given)


CASES = {
    "rank one, stable": (lambda: sharp(STICK), "|trace| < 1", "proved", None),
    "rank one, unstable": (lambda: sharp(STICK, chi="0.9"), "|trace| < 1", "refuted", None),
    "conservative": (lambda: sharp(RIGID), "|trace - 1| < 2", "proved", None),
    "rank two": (lambda: sharp("dry-friction/symmetric"), None, None, None),
    "grazing": (
        lambda: sharp(RIGID, **RATIONAL, T="pi"),
        "|trace - 1| < 2",
        "undecided",
        "a boundary may be reached tangentially",
    ),
    "no box": (elsewhere, "|trace| < 1", "undecided", "no box around it"),
    "tables, a multiplier of 1e-10": (
        lambda: gallery("impact_oscillator.py:one-period", r="1e-5"),
        "every nontrivial multiplier is inside the unit circle",
        "proved",
        None,
    ),
}


@pytest.mark.parametrize("kind", CASES)
def test_each_verdict_has_its_enclosure_or_its_reason(kind: str) -> None:
    solved, statement, verdict, reason = CASES[kind]
    orbit = solved()
    proof = trace_proof_json(orbit)
    assert (proof["statement"], proof["verdict"]) == (statement, verdict)
    assert not proof["one_sided"]
    assert (proof["trace"] is None) == (reason is not None) == ("reason" in proof)
    if reason is not None:
        assert reason in proof["reason"]
        return
    middle, radius = (Decimal(proof["trace"][part]) for part in ("mid", "rad"))
    assert abs(Decimal(str(orbit.trace)) - middle) < radius + Decimal("1e-18")


def test_a_system_that_is_not_stated_exactly_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    told = "the declaration holds no steps of a contact law"

    def refused(*_: object) -> None:
        raise InputError(told)

    monkeypatch.setattr(certify_orbit, "certify", refused)
    proof = trace_proof_json(gallery("impact_oscillator.py:one-period", r="1e-5"))
    assert proof.pop("reason") == told
    assert not any(proof.values())


def test_a_multiplier_one_that_energy_enforces_is_no_verdict(tmp_path: Path) -> None:
    """One mass before an elastic stop: the map has rank one, and it is 1 in each orbit."""
    file = tmp_path / "one.py"
    file.write_text(BUMP)
    orbit = refine(solve(f"{file}:one"), 20)
    assert [m.trivial for m in orbit.stability.multipliers] == [True]
    assert (orbit.stability.verdict, orbit.stability.margin) == ("neutral", 0)
    proof = trace_proof_json(orbit)
    assert proof["statement"] is proof["verdict"] is None
    assert proof["trace"]["mid"].startswith("1.0000000000")


def test_at_a_border_collision_all_is_about_one_side() -> None:
    proof = trace_proof_json(sharp("dry-friction/solution-ii"))
    assert proof["one_sided"]
    assert (proof["statement"], proof["verdict"]) == ("|trace| < 1", "proved")
