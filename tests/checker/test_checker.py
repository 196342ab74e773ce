"""The checker: what is true passes, and no change that makes a claim false does."""

from __future__ import annotations

import copy
import json
import re
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import nullcontext
from dataclasses import replace
from fractions import Fraction
from functools import cache
from importlib.resources import files
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import sympy as sp
from flint import arb, arb_mat, ctx
from typer.testing import CliRunner

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.derive.systems import declaration
from nonsmooth.runtime.checker import Failure
from nonsmooth.runtime.checker.__main__ import judged
from nonsmooth.runtime.checker.orbits.orbit import CheckedOrbit, lower
from nonsmooth.runtime.checker.orbits.points import JudgedOrbit
from nonsmooth.runtime.checker.orbits.stability import (
    _inside,
    _neutral,
    characteristic,
    multipliers,
    others_below,
)
from nonsmooth.runtime.cli.program import app
from nonsmooth.runtime.core.taylor_models import TaylorModel, space_of
from nonsmooth.runtime.present.tell import tell
from nonsmooth.runtime.proof.certificate import Certificate
from tests.certified import believed, forced, loop, moved, of_files, refused, saved, signed

STICK = "dry-friction/global-stick"
SUBJECTS: dict[str, Callable[[], Any]] = {
    "global-stick": lambda: ns.solve(STICK),
    "symmetric": lambda: ns.solve("dry-friction/symmetric"),
    "rigid": lambda: ns.solve("rigid-stop/one-impact"),
    "elastic": lambda: ns.solve("elastic-stop/one-contact"),
    "unstable": lambda: ns.solve("rigid-stop/one-impact", {"k2": "1.456", "T": "6.1"}),
    "kicked": loop,
    "crossed": lambda: loop(a="1"),
    "tangent": lambda: loop(a="2"),
    "perturbed": lambda: replace(loop(), starts=loop().states + 0.01),
    "faint": lambda: loop(r="1e-30"),
    "forgetful": lambda: loop(r="0"),
    "irrational": lambda: loop(k="sqrt(2)"),
    "soft": lambda: forced("soft"),
    "twice": lambda: forced("twice"),
    "slider": lambda: forced("slider"),
}


@cache
def certificate(name: str) -> Certificate:
    return ns.certify(SUBJECTS[name]())


@pytest.fixture
def content(request: pytest.FixtureRequest, tmp_path: Path) -> dict[str, Any]:
    """The file of the certificate that a test is about."""
    path = tmp_path / "certificate.json"
    certificate(request.param).save(path)
    found: dict[str, Any] = json.loads(path.read_text())
    return found


@of_files(*SUBJECTS)
def test_true_certificates_pass(content: dict[str, Any]) -> None:
    believed(content)


@of_files("global-stick", "symmetric", "rigid", "elastic", "kicked", "soft", "twice")
def test_centres_outside_their_enclosures_are_refused(content: dict[str, Any]) -> None:
    for name in content["enclosures"]:
        for by in (3, -3):
            changed = copy.deepcopy(content)
            moved(changed["enclosures"][name], by)
            refused(changed, "not in its enclosure")
    for place in range(len(content["multipliers"])):
        changed = copy.deepcopy(content)
        moved(changed["multipliers"][place]["re"])
        refused(changed, "multiplier")


@of_files("global-stick", "symmetric", "rigid", "elastic", "kicked", "soft", "twice")
def test_multipliers_that_are_not_stated_are_no_larger_than_is_stated(
    content: dict[str, Any],
) -> None:
    assert content["multipliers"]
    known = [complex(*(float(m[k]["mid"]) for k in ("re", "im"))) for m in content["multipliers"]]
    zero = {"mid": "0", "rad": "1e-12"}
    for place, number in enumerate(known):
        assert abs(number) > 1e-3
        for other in ([], [{"re": zero, "im": zero}]):
            told = content["multipliers"][:place] + other + content["multipliers"][place + 1 :]
            refused({**content, "multipliers": told}, "not stated|stated multiplier is none")
    refused({**content, "multipliers": []}, "not stated")
    largest = max(map(abs, known))
    refused({**content, "multipliers": [], "other_multipliers": f"{0.999 * largest}"}, "not stated")
    bound = f"{4 * len(known) * max(1, largest)}"
    for told in ({"other_multipliers": ""}, {"multipliers": [], "other_multipliers": bound}):
        weaker = {**content, **told}
        believed(signed(weaker))


@of_files("global-stick")
def test_numbers_that_are_fractions_are_shown(content: dict[str, Any], tmp_path: Path) -> None:
    content["other_multipliers"] = "1/64"
    content["margins"][0]["least"] = content["box"][0]["rad"] = f"1/{10**20}"
    path = saved(content, tmp_path / "certificate.json")
    for result in (ns.certify.check(path), ns.load(path)):
        assert "at most 0.015625 in absolute value" in str(tell(result))
    assert str(tell(result)).count("1e-20") == 2


@of_files("rigid", "elastic", "symmetric")
def test_each_disc_holds_one_multiplier_of_its_own(content: dict[str, Any]) -> None:
    first, second = content["multipliers"]
    refused({**content, "multipliers": [first, first]}, "stated multiplier is none")
    wide = {"mid": "0", "rad": "9"}
    both = {"re": wide, "im": wide}
    for told in ([both], [first, both]):
        refused({**content, "multipliers": told}, "stated multiplier is none")
    believed(signed({**content, "multipliers": [second, first]}))


def test_derivatives_are_those_of_the_multiplier_that_is_stated(tmp_path: Path) -> None:
    ns.certify(SUBJECTS["symmetric"](), derivatives="V").save(tmp_path / "proof.json")
    content = json.loads((tmp_path / "proof.json").read_text())
    turned = {**content, "multipliers": content["multipliers"][::-1]}
    refused(turned, "the derivative of multiplier")
    rates = {**content["derivatives"]}
    names = "multiplier 1 re", "multiplier 2 re"
    rates |= {name: rates[other] for name, other in zip(names, names[::-1], strict=True)}
    believed(signed({**turned, "derivatives": rates}))
    refused({**content, "derivatives": rates}, "the derivative of multiplier")


def test_derivatives_by_one_parameter_are_not_those_by_another(tmp_path: Path) -> None:
    ns.certify(SUBJECTS["symmetric"](), derivatives=["V", "eta"]).save(tmp_path / "proof.json")
    content = json.loads((tmp_path / "proof.json").read_text())
    content["directions"]["V"] = content["directions"]["eta"]
    for rates in content["derivatives"].values():
        rates["V"] = rates["eta"]
    refused(content, "V moves something else")


PROPOSAL = ("parameters", "given_period", "itinerary", "declaration", "closing", "box", "bits")


@of_files("global-stick", "rigid", "irrational", "soft")
def test_the_judge_reads_the_proposal_alone_and_is_the_same_at_any_precision(
    content: dict[str, Any],
) -> None:
    proposal = {name: content[name] for name in PROPOSAL}
    found = []
    for precision in (30, 1000):
        with ctx.workprec(precision):
            judged = JudgedOrbit(proposal)
            verdicts = judged.existence, judged.admissibility, judged.stability
            assert {verdict.claim for verdict in verdicts} == {"proved"}
            balls = [*judged.enclosures.values(), judged.others_below]
            balls += [part for m in judged.multipliers for part in (m.real, m.imag)]
            balls += [margin.least for margin in judged.admissibility.found]
        found.append([(ball.mid().man_exp(), ball.rad().man_exp()) for ball in balls])
    assert found[0] == found[1]


@of_files("global-stick", "rigid", "elastic", "kicked", "soft", "twice")
def test_boxes_without_the_orbit_are_refused(content: dict[str, Any]) -> None:
    for place in range(len(content["box"])):
        changed = copy.deepcopy(content)
        moved(changed["box"][place])
        refused(changed)
    for radius in ("0", "-1e-20", "1e3"):
        changed = copy.deepcopy(content)
        changed["box"][-1]["rad"] = radius
        refused(changed)


def numbers(entry: Any) -> Iterator[tuple[list[Any], int]]:
    """Places of all numbers in a nest of lists."""
    for place, inner in enumerate(entry):
        if isinstance(inner, list):
            yield from numbers(inner)
        else:
            yield entry, place


def larger(entry: Any) -> Any:
    """A number, or a function, that is larger by a thousandth."""
    if isinstance(entry, str):
        return str(Fraction(entry) * Fraction(1001, 1000))
    return {**entry, "above": [[larger(c), powers] for c, powers in entry["above"]]}


@of_files("global-stick", "kicked", "rigid", "elastic", "soft")
def test_another_system_has_another_orbit(content: dict[str, Any]) -> None:
    # fields and rows of what ends a phase, each nonzero number by a thousandth
    declared = content["declaration"]
    tried = 0
    for phase in declared["phases"]:
        entry = declared["configurations"][phase["configuration"]]
        for rows in (entry["field"], [entry["boundaries"][phase["boundaries"][0]]]):
            for row, place in numbers(rows):
                if row[place] == "0":
                    continue
                kept = row[place]
                row[place] = larger(kept)
                # a row that is multiplied as a whole is the same boundary
                if len([x for x in row if x != "0"]) > 1 or rows is entry["field"]:
                    refused(content)
                    tried += 1
                row[place] = kept
    assert tried >= 4


@of_files("global-stick")
def test_swapped_boundaries_and_phases_are_refused(content: dict[str, Any]) -> None:
    declared = content["declaration"]
    changed = copy.deepcopy(content)
    rows = changed["declaration"]["configurations"]["slip-slip"]["boundaries"]
    rows["first-reaches-belt"], rows["second-reaches-belt"] = (
        rows["second-reaches-belt"], rows["first-reaches-belt"],
    )  # fmt: skip
    refused(changed)
    changed = copy.deepcopy(content)
    changed["itinerary"] = changed["itinerary"][1:] + changed["itinerary"][:1]
    refused(changed, "itinerary")
    phases = declared["phases"]
    changed["declaration"]["phases"] = phases[1:] + phases[:1]
    refused(changed)
    changed = copy.deepcopy(content)
    phase = changed["declaration"]["phases"][2]
    phase["boundaries"] = ["second-reaches-belt"]
    changed["itinerary"][2][1] = "second-reaches-belt"
    refused(changed, "transition")


@of_files("kicked", "global-stick")
def test_boundaries_in_the_way_are_seen(content: dict[str, Any]) -> None:
    phases, configurations = (content["declaration"][k] for k in ("phases", "configurations"))
    row = configurations[phases[0]["configuration"]]["boundaries"]
    size = len(content["declaration"]["states"])
    row["new"] = [*["0"] * size, "1"]  # positive everywhere
    refused(content, "admissibility is refuted")
    row["new"] = [*["0"] * size, "-1"]
    believed(signed(content))


@of_files("kicked")
def test_a_boundary_just_reached_inside_is_seen(content: dict[str, Any]) -> None:
    wall = content["declaration"]["configurations"]["right"]["boundaries"]["wall"]
    wall[-1] = "-1999999999999/1000000000000"  # the orbit goes to 2
    content["margins"] = []
    refused(content, "admissibility is refuted")
    wall[-1] = "-2"
    refused(content, "admissibility is undecided")
    wall[-1] = "-2000000000001/1000000000000"
    believed(signed(content))


@of_files("global-stick", "kicked", "soft")
def test_margins_that_are_not_positive_are_refused(content: dict[str, Any]) -> None:
    assert content["margins"]
    for place in range(len(content["margins"])):
        for least in ("0", "-1e-9", "-1"):
            changed = copy.deepcopy(content)
            changed["margins"][place]["least"] = least
            refused(changed, "a margin is not positive")


@of_files("global-stick", "rigid", "elastic", "kicked", "soft")
def test_margins_that_are_too_large_are_refused(content: dict[str, Any]) -> None:
    for place in range(len(content["margins"])):
        changed = copy.deepcopy(content)
        margin = changed["margins"][place]
        margin["least"] = str(Fraction(margin["least"]) * 3)
        refused(changed, "a margin is larger than what is proved")
    content["margins"].append({**content["margins"][0], "boundary": "none"})
    refused(content, "a margin is stated of nothing")


@of_files("global-stick", "symmetric", "crossed", "tangent", "kicked")
def test_claims_of_another_verdict_are_refused(content: dict[str, Any]) -> None:
    for name in ("existence", "admissibility", "stability"):
        for verdict in {"proved", "refuted"} - {content["claims"][name]}:
            changed = copy.deepcopy(content)
            claims = changed["claims"]
            claims[name] = verdict
            if name == "existence":
                claims |= {"admissibility": "undecided", "stability": "undecided"}
                changed |= {"enclosures": {}, "multipliers": [], "other_multipliers": ""}
            if claims["admissibility"] != "proved":
                changed["margins"] = []
            changed["reasons"] = {n: "so" for n, told in claims.items() if told != "proved"}
            refused(changed, name)


@of_files("rigid", "elastic")
def test_what_is_kept_is_not_taken_for_granted(content: dict[str, Any]) -> None:
    for closing in ({**content["closing"], "kind": "state"}, {"kind": "state"}):
        for period in (content["given_period"], ""):
            refused({**content, "closing": closing, "given_period": period})
    changed = copy.deepcopy(content)
    changed["closing"]["form"][0][1] = "1"
    refused(changed, "no symplectic form")
    changed = copy.deepcopy(content)
    changed["closing"]["form"] = [["0"] * 4] * 4
    refused(changed, "no symplectic form|neither energy nor form")
    changed = copy.deepcopy(content)
    form = changed["closing"]["form"]
    form[0][1], form[1][0] = "1", "-1"
    refused(changed)
    period = f"{content['given_period']}+1/1000000"
    refused({**content, "given_period": period})
    closing = {**content["closing"], "period": "m1"}
    parameters = {**content["parameters"], "m1": content["given_period"]}
    refused({**content, "closing": closing, "parameters": parameters, "given_period": "1"})
    closing = {**content["closing"], "period": "k1"}
    refused({**content, "closing": closing}, "another period is given")
    closing = {**content["closing"], "vanishing": [["1", "0", "0", "0", "0"]]}
    refused({**content, "closing": closing}, "functions that vanish though")


@of_files("soft", "twice")
def test_a_phase_of_the_forcing_is_the_only_one(content: dict[str, Any]) -> None:
    changed = copy.deepcopy(content)
    changed["declaration"]["phases"][0]["boundaries"] = ["forcing-phase"]
    changed["itinerary"][0][1] = "forcing-phase"
    refused(changed, "a forcing's phase beside others")


def ending_at(content: dict[str, Any], boundaries: list[str]) -> dict[str, Any]:
    """A file whose first phase and its transition name other boundaries."""
    changed = copy.deepcopy(content)
    declared = changed["declaration"]
    phase = declared["phases"][0]
    phase["boundaries"] = declared["transitions"][phase["transition"]]["boundaries"] = boundaries
    changed["itinerary"][0][1] = "+".join(boundaries)
    return changed


@of_files("soft", "kicked")
def test_what_the_itinerary_names_is_declared(content: dict[str, Any]) -> None:
    declared = content["declaration"]
    phase = declared["phases"][0]
    ending = phase["boundaries"]
    for told in ([*ending, "forcing-phase"], ["forcing-phase", *ending], ["another"], []):
        refused(ending_at(content, told), "none of its boundaries")
    refused(ending_at(content, ending * 2), "a phase ends twice at a boundary")
    changed = copy.deepcopy(content)
    del changed["declaration"]["configurations"][phase["configuration"]]
    refused(changed, "a configuration of the itinerary is not declared")
    changed = copy.deepcopy(content)
    row = ["1"] * (len(declared["states"]) + 1)
    changed["declaration"]["transitions"][0]["conditions"] = [[row, "elsewhere", True]]
    refused(changed, "along no declared configuration")


@of_files("rigid")
def test_an_impact_that_loses_energy_is_no_conservative_one(content: dict[str, Any]) -> None:
    reset = content["declaration"]["transitions"][0]["reset"]
    assert isinstance(reset[2][2], dict)  # the coefficient of restitution, with a sign
    reset[2][2] = "-9/10"
    refused(content)


@of_files("soft", "twice")
def test_forcings_have_to_return(content: dict[str, Any]) -> None:
    changed = copy.deepcopy(content)
    changed["closing"]["turns"] += 1
    refused(changed)
    changed = copy.deepcopy(content)
    changed["declaration"]["forcing"] = []
    refused(changed)
    changed = copy.deepcopy(content)
    changed["closing"]["kind"] = "state"
    refused(changed)


@of_files("perturbed", "soft")
def test_a_box_with_a_root_is_not_empty(content: dict[str, Any]) -> None:
    changed = copy.deepcopy(content)
    changed["claims"] = {
        "existence": "refuted", "admissibility": "undecided", "stability": "undecided",
    }  # fmt: skip
    changed |= {"enclosures": {}, "multipliers": [], "other_multipliers": "", "margins": []}
    changed["reasons"] = dict.fromkeys(changed["claims"], "so")
    if content["claims"]["existence"] == "proved":
        refused(changed, "existence is proved")
        changed["box"][-1]["mid"] = "1"  # it is empty, but the forcing might turn otherwise
        refused(changed, "existence is undecided")
        return
    believed(content)
    for side in changed["box"]:
        side["rad"] = "1"
    refused(changed, "existence is undecided")


@of_files("irrational")
def test_constants_are_checked_and_balls_may_not_be_wider(content: dict[str, Any]) -> None:
    assert content["claims"]["admissibility"] == "proved"
    other = {**content, "parameters": {**content["parameters"], "k": "sqrt(3)"}}
    refused(other)
    field = content["declaration"]["configurations"]["right"]["field"]
    assert "above" in field[1][0]
    # a ball around the same number proves no exact zeros, and a wide one nothing
    field[1][0] = {"mid": "-1.41421356", "rad": "1e-3"}
    refused(content)


@of_files("soft")
def test_names_are_not_taken_for_numbers(content: dict[str, Any]) -> None:
    name = content["itinerary"][0][0]
    renamed = json.loads(json.dumps(content).replace(f'"{name}"', '"mid"'))
    assert renamed["itinerary"][0][0] == "mid"
    believed(signed(renamed))


def test_the_declaration_is_the_declared_one() -> None:
    """Matrices of the file, functions of the parameters, against those of the paper's section."""
    found = certificate("global-stick")
    system = declaration("dry-friction").system
    names = found.declaration["parameters"]
    own = {p.name: p.symbol for p in system.parameters}

    def polynomial(terms: Any) -> Any:
        powers = ((c, zip(names, exponents, strict=True)) for c, exponents in terms)
        return sum(sp.Rational(c) * sp.prod(own[n] ** k for n, k in pairs) for c, pairs in powers)

    def formula(entry: Any) -> Any:
        if isinstance(entry, str):
            return sp.Rational(entry)
        return polynomial(entry["above"]) / polynomial(entry["below"])

    def same(rows: Any, wanted: Any) -> bool:
        found = sp.Matrix([[formula(x) for x in row] for row in rows])
        return bool((found - wanted).applyfunc(sp.simplify).is_zero_matrix)

    for name, entry in found.declaration["configurations"].items():
        configuration = system.configuration(name)
        matrix, offset = configuration.dynamics.field(system.states)
        assert same(entry["field"], matrix.row_join(offset))
        for boundary in configuration.boundaries:
            gradient = [sp.diff(boundary.function, x) for x in system.states]
            rest = boundary.function.subs(dict.fromkeys(system.states, 0))
            row = sp.Matrix([[*gradient, rest]])
            assert same([entry["boundaries"][boundary.name]], row)


def similar(eigenvalues: Any, rng: np.random.Generator) -> Any:
    """Balls of a real matrix with these eigenvalues: real ones, and one of each complex pair."""
    size = sum(1 + bool(np.iscomplex(m)) for m in eigenvalues)
    block, place = np.zeros((size, size)), 0
    for m in eigenvalues:
        if np.iscomplex(m):
            block[place : place + 2, place : place + 2] = [[m.real, m.imag], [-m.imag, m.real]]
        else:
            block[place, place] = m.real
        place += 1 + bool(np.iscomplex(m))
    change = rng.normal(size=(size, size)) + 3 * np.eye(size)
    with ctx.workprec(200):
        basis = arb_mat(change.tolist())
        return basis * arb_mat(block.tolist()) * basis.inv()


@pytest.mark.parametrize("size", [1, 2, 3, 5])
def test_roots_inside_the_unit_circle_are_told_from_others(size: int) -> None:
    rng = np.random.default_rng(size)
    seen = set()
    with ctx.workprec(200):
        for _ in range(40):
            matrix = rng.normal(size=(size, size)) / np.sqrt(size)
            largest = max(abs(np.linalg.eigvals(matrix)))
            found = _inside(characteristic(arb_mat(matrix.tolist())))
            assert found == ("proved" if largest < 1 else "refuted")
            seen.add(found)
        assert _inside(characteristic(arb_mat([[1]]))) == "undecided"
    assert seen == {"proved", "refuted"}


def test_of_wide_coefficients_a_root_outside_is_seen_and_none_is_made_up() -> None:
    """As next to a grazing, where a trace is large and the product of the roots is not known."""
    assert _inside([arb(1), arb(3e9, 4e8), arb(0, 1e13)]) == "refuted"
    wide = [(1.64, 2e-3), (2.509, 4e-4), (1.66, 2e-3), (0.706343, 1e-7)]
    assert _inside([arb(1), *(arb(*x) for x in wide)]) == "refuted"
    rng = np.random.default_rng(4)
    for _ in range(60):
        size = int(rng.integers(1, 6))
        roots = np.exp(2j * np.pi * rng.random(size // 2)) * rng.random(size // 2) ** 0.1
        real = rng.uniform(-1, 1, size % 2)
        middles = np.poly([*roots, *roots.conj(), *real]).real[1:]
        away = 10.0 ** rng.uniform(-6, 2, size)
        # not around its own polynomial, but around others that are as near
        others = middles + rng.uniform(-0.99, 0.99, size) * away
        told = [arb(float(x), float(r)) for x, r in zip(others, away, strict=True)]
        assert _inside([arb(1), *told]) != "refuted"


@pytest.mark.parametrize(
    ("pairs", "verdict"),
    [
        ((), "proved"),
        ((np.exp(1j),), "proved"),
        ((np.exp(1j), np.exp(2.5j)), "proved"),
        ((np.exp(1j), np.exp(1.0001j), np.exp(3j)), "proved"),
        ((np.exp(1j), np.exp(1j)), "undecided"),
        ((2.0, 0.5), "refuted"),
        ((-2.0, -0.5, np.exp(1j)), "refuted"),
        ((-2.0, -0.5, 3.0, 1 / 3), "refuted"),
        ((1.1 * np.exp(1j), np.exp(1j) / 1.1), "refuted"),
    ],
)
@pytest.mark.parametrize("rest", [(1.0, 0.0), (1.0,)])
def test_pairs_on_the_unit_circle_are_told_from_others(
    pairs: tuple[complex, ...], verdict: str, rest: tuple[float, ...]
) -> None:
    square = similar((*rest, *pairs), np.random.default_rng(3))
    size = 2 + sum(1 + bool(np.iscomplex(m)) for m in pairs)
    with ctx.workprec(200):
        # the numbers are doubles: the balls have to contain the exact ones
        wide = arb_mat([[x + arb(0, 1e-12) for x in row] for row in square.tolist()])
        assert _neutral(wide, size) == verdict


def map_of(square: Any, size: int, stability: str) -> Any:
    """An orbit whose Poincare map, of so many coordinates, has a derivative on a section."""
    return SimpleNamespace(
        section=square, declared=SimpleNamespace(free=range(size), stability=stability)
    )


@pytest.mark.parametrize("seed", range(5))
def test_multipliers_are_enclosed_and_all_others_are_below_their_bound(seed: int) -> None:
    rng = np.random.default_rng(seed)
    pair = 0.7 * np.exp(1j * rng.uniform(0.3, 2.8))
    wanted = [*rng.uniform(-1.4, 1.4, 2), pair, pair.conjugate(), 1e-30]
    with ctx.workprec(200):
        square = similar((*wanted[:3], 1e-30), rng)
        found = multipliers(map_of(square, 6, "stable"))
        assert len(found) == 4
        for m in wanted[:4]:
            assert sum(abs(complex(x) - m) < 1e-12 for x in found) == 1
        assert [abs(complex(x)) for x in found] == sorted(abs(complex(x)) for x in found)[::-1]
        assert sum(x.imag.is_zero() for x in found) == 2
        for left in range(4):
            known = found[:left] + found[left + 1 :]
            bound = others_below(map_of(square, 6, "stable"), known)
            assert abs(found[left]) < bound
        assert others_below(map_of(square, 6, "stable"), found) < 1e-25


def test_multipliers_that_lie_too_near_are_not_stated() -> None:
    """To each other, to the trivial 1, or to zero, of which there are as many as are left."""

    def told(*diagonal: Any, more: int = 0, trivial: bool = False) -> list[complex]:
        square = arb_mat(
            [[x if i == j else 0 for j in range(len(diagonal))] for i, x in enumerate(diagonal)]
        )
        kind = "neutral" if trivial else "stable"
        return [complex(m) for m in multipliers(map_of(square, len(diagonal) + more, kind))]

    with ctx.workprec(192):
        tiny = arb(2) ** -80
        assert told(arb("0.5"), arb("-0.25"), 1, more=1, trivial=True) == [0.5, -0.25]
        near, half = arb(2) ** -40, arb("0.5")
        assert told(half, half + near, half - near, -half) == [-0.5]
        assert told(half, half + tiny, -half) == []  # nor any beside them
        assert told(half, 1 - near, 1 + near, 1, trivial=True) == [0.5]
        assert told(arb("0.5"), 1, 1, trivial=True) == []
        assert told(1 - tiny) == [1]
        assert told(tiny, more=1) == []
        assert told(tiny) == [float(tiny)]


RUNTIME = files("nonsmooth.runtime")
# of `core`, with tests of their own
ARITHMETIC = {
    "taylor_models", "jets", "rational_functions", "irrational_numbers",
    "float_sets", "exponentials.float_flows", "box_grid",
    "parallel", "errors", "values",  # no arithmetic: who does which part, and what is no number
}  # fmt: skip


def sources() -> dict[str, str]:
    """The checker's files."""
    folder = Path(str(RUNTIME / "checker"))
    return {str(file.relative_to(folder)): file.read_text() for file in folder.rglob("*.py")}


@pytest.fixture(scope="module")
def alone(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The checker and its arithmetic, with nothing else of the package."""
    root = tmp_path_factory.mktemp("alone")
    home = root / "nonsmooth" / "runtime"
    for folder in (home / "core", home / "checker"):
        folder.mkdir(parents=True)
    for folder in (home / "core", home, home.parent):
        (folder / "__init__.py").touch()
    for name in ARITHMETIC:
        file = f"core/{name.replace('.', '/')}.py"
        (home / file).parent.mkdir(exist_ok=True)
        (home / file).write_text(RUNTIME.joinpath(file).read_text())
    for file, source in sources().items():
        (home / "checker" / file).parent.mkdir(exist_ok=True)
        (home / "checker" / file).write_text(source)
    for shapes in RUNTIME.glob("checker/stated/*.json"):
        (home / "checker" / "stated" / shapes.name).write_text(shapes.read_text())
    return root


@pytest.mark.parametrize("name", ["elastic", "map", "events"])
def test_the_checker_runs_alone(name: str, alone: Path, tmp_path: Path) -> None:
    path = tmp_path / "certificate.json"
    if name == "map":
        ns.certify.box(loop(), {"r": ("2/5", "3/5")}).save(path)
    elif name == "events":
        branch = ns.continue_orbit(loop(), "a", (1.5, 3.5))
        ns.certify.event(branch, branch.events[-1]).save(path)
    else:
        certificate(name).save(path)
    run = "import sys, runpy; sys.path.insert(0, sys.argv.pop(1));"
    run += "runpy.run_module('nonsmooth.runtime.checker', run_name='__main__')"
    done = subprocess.run(
        [sys.executable, "-I", "-c", run, str(alone), str(path)],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert (done.returncode, done.stdout) == (0, f"{path}: every claim holds\n"), done.stderr


def with_parameter(text: str, value: str) -> str:
    content = json.loads(text)
    content["parameters"][next(iter(content["parameters"]))] = value
    return json.dumps(signed(content))


@pytest.mark.parametrize(
    ("change", "code", "told"),
    [
        (lambda text: text, 0, "every claim holds"),
        (lambda text: with_parameter(text, "1/0"), 2, "division by zero"),
        (lambda text: with_parameter(text, "sum"), 2, "unknown name 'sum'"),
        (lambda text: with_parameter(text, "5/7"), 1, "not proved"),
        (lambda text: text[:-20], 2, "it cannot be read"),
        (lambda text: "[" * 10**5, 2, "it cannot be read"),
        (lambda text: "[]", 2, "it is no certificate"),
        (lambda text: text.replace('"margins"', '"margin"', 1), 2, "it is malformed"),
        (lambda text: text.replace('"bits": 128', '"bits": 129', 1), 1, "not proved: edited"),
    ],
)
def test_the_checker_says_what_is_wrong_in_one_line(
    change: Callable[[str], str], code: int, told: str, tmp_path: Path
) -> None:
    path = tmp_path / "certificate.json"
    certificate("kicked").save(path)
    path.write_text(change(path.read_text()))
    found, said = judged(str(path))
    assert found == code == CliRunner().invoke(app, ["certify", "check", str(path)]).exit_code
    assert told in said
    assert "\n" not in said
    assert judged(str(tmp_path / "none.json"))[0] == 2


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (lambda text: text[:-20], "cut, or not JSON"),
        (lambda text: "[]", "not a (certificate|saved result)"),
        (lambda text: re.sub(r'"version": \d+', '"version": 9', text, count=1), "version 9"),
        (lambda text: text.replace('"margins"', '"margin"', 1), "missing|unknown"),
        (
            lambda text: text.replace('"bits": 128', '"bits": "128"', 1),
            "'bits' is of the wrong type",
        ),
    ],
)
def test_files_that_are_no_certificates(
    change: Callable[[str], str], told: str, tmp_path: Path
) -> None:
    path = tmp_path / "certificate.json"
    certificate("kicked").save(path)
    text = change(path.read_text())
    if "missing" in told or "type" in told:
        text = json.dumps(signed(json.loads(text)))
    path.write_text(text)
    for work in (ns.load, ns.certify.check):
        with pytest.raises(InputError, match=told):
            work(path)


@pytest.mark.parametrize(
    ("first", "last", "given_back"), [(2, 1, True), (-2, -1, True), (2, -1, False), (0, 1, False)]
)
def test_the_energy_gives_back_the_coordinate_left_out(
    first: int, last: int, given_back: bool
) -> None:
    """Where it changes with it all the way between the ends of the cycle, as x^2/2 does with x."""
    orbit: Any = SimpleNamespace(
        numbers=arb_mat,
        now=SimpleNamespace(starts=[arb_mat([[x], [1]]) for x in (first, 5, last)]),
        declared=SimpleNamespace(
            omega=[[0, 1], [-1, 0]], dropped=0, steps=[SimpleNamespace(name="free")]
        ),
        value=lambda row, state: sum(x * y for x, y in zip(row, state, strict=True)),
    )  # fmt: skip
    told = "the energy does not give the coordinate left out"
    with nullcontext() if given_back else pytest.raises(Failure, match=told):
        CheckedOrbit.returns(orbit, {"free": [[1, 0]]})


@pytest.mark.parametrize("part", ["above", "below"])
@pytest.mark.parametrize("exponents", [[0, 10_001, 0], [-1, 0, 0], [0, -1, 1], [10_001, 1, 0]])
@of_files("irrational")
def test_no_power_of_any_parameter_is_too_high(
    content: dict[str, Any], part: str, exponents: list[int]
) -> None:
    wall = content["declaration"]["configurations"]["right"]["boundaries"]["wall"]
    wall[-1] = {"above": [["-1", [0, 1, 2]]], "below": [["1", [0, 1, 1]]]}  # -a, in other words
    believed(signed(content))
    wall[-1][part] = [["1", exponents]]
    refused(content, "a power too high")


@pytest.mark.parametrize(
    ("radius", "told"),
    [
        ("1e3000", "1e+3000"),
        (f"1{'0' * 3000}", "1e+3000"),
        (f"1/1{'0' * 21}", "1e-21"),
    ],
)
def test_radii_that_no_double_is_are_shown(radius: str, told: str, tmp_path: Path) -> None:
    path = tmp_path / "proof.json"
    certificate("elastic").save(path)
    content = json.loads(path.read_text())
    content["enclosures"]["period"]["rad"] = radius
    saved(content, path)
    assert f" +- {told}" in str(ns.certify.check(path)).lower()


@pytest.mark.parametrize("text", ["1/0", "1.5/2", "1e999999999", "٣"])
def test_entries_that_are_no_numbers_are_refused_in_one_line(text: str, tmp_path: Path) -> None:
    path = tmp_path / "proof.json"
    ns.certify(ns.solve("rigid-stop/one-impact")).save(path)
    content = json.loads(path.read_text())
    content["enclosures"]["period"]["mid"] = text
    saved(content, path)
    with pytest.raises(ns.InputError, match=r"proof\.json: .") as caught:
        ns.certify.check(path)
    assert "\n" not in str(caught.value)


def test_a_model_of_a_lower_order_holds_what_it_leaves_out() -> None:
    space = space_of(2, 5)
    whole = TaylorModel(space, tuple(arb(1) for _ in space.exponents))
    part = lower(whole)
    assert part.space.order < space.order
    for place in ((1, 1), (-1, 1), (0.5, -1), (0, 0)):
        assert part.at([*map(arb, place)]).contains(whole.at([*map(arb, place)]))
