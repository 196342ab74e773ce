"""What is proved of the trace of an orbit, and what is not: each verdict and its reason."""

from decimal import Decimal

import pytest

from nonsmooth import InputError
from tests.cli.test_cli import told
from tests.places import GALLERY

STICK, RIGID = "dry-friction/global-stick", "rigid-stop/one-impact"
IMPACTS = f"{GALLERY / 'impact_oscillator.py'}:one-period"
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


CASES = {
    "rank one, stable": (STICK, "|trace| < 1", "proved", ""),
    "rank one, unstable": (f"{STICK} chi=0.9", "|trace| < 1", "refuted", ""),
    "conservative": (RIGID, "|trace - 1| < 2", "proved", ""),
    "rank two": ("dry-friction/symmetric", None, None, ""),
    "grazing": (
        f"{RIGID} m1=1 m2=2 k1=2 k2=4 T=pi",  # frequencies 1 and 2
        "|trace - 1| < 2",
        "undecided",
        "a boundary may be reached tangentially",
    ),
    "a border collision": ("dry-friction/solution-ii", "|trace| < 1", "proved", ""),
    "tables, a multiplier of 1e-10": (
        f"{IMPACTS} r=1e-5", "every nontrivial multiplier is inside the unit circle", "proved", ""
    ),
}  # fmt: skip


@pytest.mark.parametrize("kind", CASES)
def test_each_verdict_has_its_enclosure_or_its_reason(kind):
    words, statement, verdict, reason = CASES[kind]
    code = int(verdict == "undecided")
    found = told("verify", *words.split(), "--digits", "20", code=code)
    proof = found["proof"]
    assert (proof["statement"], proof["verdict"]) == (statement, verdict)
    assert proof["one_sided"] == (kind == "a border collision")
    assert (proof["trace"] is None) == bool(reason) == ("reason" in proof)
    assert reason in proof.get("reason", "")
    if not reason:
        middle, radius = (Decimal(proof["trace"][part]) for part in ("mid", "rad"))
        assert abs(Decimal(found["trace"]) - middle) < radius + Decimal("1e-18")


def test_a_system_that_is_not_stated_exactly_says_so(monkeypatch):
    reason = "the declaration holds no steps of a contact law"

    def refused(*_):
        raise InputError(reason)

    monkeypatch.setattr("nonsmooth.runtime.proof.certify_orbit.certify", refused)
    proof = told("verify", IMPACTS, "--digits", "20")["proof"]
    assert proof.pop("reason") == reason
    assert not any(proof.values())


def test_a_multiplier_one_that_energy_enforces_is_no_verdict(tmp_path):
    """One mass before an elastic stop: the map has rank one, and it is 1 in each orbit."""
    file = tmp_path / "one.py"
    file.write_text(BUMP)
    found = told("verify", f"{file}:one", "--digits", "20")
    assert [m["trivial"] for m in found["multipliers"]] == [True]
    assert (found["stability"], float(found["margin"])) == ("neutral", 0)
    assert found["proof"]["statement"] is found["proof"]["verdict"] is None
    assert found["proof"]["trace"]["mid"].startswith("1.0000000000")
