"""The checker: what is true passes, and no change that makes a claim false does."""

import copy
import json
import runpy
import subprocess
import sys
from contextlib import nullcontext
from dataclasses import replace
from fractions import Fraction
from functools import cache
from types import SimpleNamespace

import pytest
from flint import arb, arb_mat, ctx
from typer.testing import CliRunner

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.runtime.checker import Failure
from nonsmooth.runtime.checker.orbits.orbit import CheckedOrbit, lower
from nonsmooth.runtime.checker.orbits.points import JudgedOrbit
from nonsmooth.runtime.cli.program import app
from nonsmooth.runtime.core.taylor_models import TaylorModel, space_of
from tests.certified import (
    believed,
    content_of,
    edited,
    forced,
    loop,
    moved,
    of_files,
    placing,
    refused,
    saved,
    signed,
    stating,
)

STICK = "dry-friction/global-stick"
SUBJECTS = {
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
def certificate(name):
    return ns.certify(SUBJECTS[name]())


@pytest.fixture
def content(request):
    """The file of the certificate that a test is about."""
    return content_of(certificate(request.param))


@of_files(*SUBJECTS)
def test_true_certificates_pass(content):
    believed(content)


@of_files("global-stick", "symmetric", "rigid", "elastic", "kicked", "soft", "twice")
def test_centres_outside_their_enclosures_are_refused(content):
    for name in content["enclosures"]:
        for by in (3, -3):
            changed = copy.deepcopy(content)
            moved(changed["enclosures"][name], by)
            refused(changed, "not in its enclosure")
    for place in range(len(content["multipliers"])):
        changed = edited(content, lambda c, k=place: moved(c["multipliers"][k]["re"]))
        refused(changed, "multiplier")


@of_files("global-stick", "symmetric", "rigid", "elastic", "kicked", "soft", "twice")
def test_multipliers_that_are_not_stated_are_no_larger_than_is_stated(content):
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


@of_files("rigid", "elastic", "symmetric")
def test_each_disc_holds_one_multiplier_of_its_own(content):
    first, second = content["multipliers"]
    refused({**content, "multipliers": [first, first]}, "stated multiplier is none")
    wide = {"mid": "0", "rad": "9"}
    both = {"re": wide, "im": wide}
    for told in ([both], [first, both]):
        refused({**content, "multipliers": told}, "stated multiplier is none")
    believed(signed({**content, "multipliers": [second, first]}))


@pytest.fixture(scope="module")
def by_two():
    """The file of an orbit with its derivatives by two parameters."""
    return content_of(ns.certify(SUBJECTS["symmetric"](), derivatives=["V", "eta"]))


def test_derivatives_are_those_of_the_multiplier_that_is_stated(by_two):
    turned = {**by_two, "multipliers": by_two["multipliers"][::-1]}
    refused(turned, "the derivative of multiplier")
    rates = {**by_two["derivatives"]}
    names = "multiplier 1 re", "multiplier 2 re"
    rates |= {name: rates[other] for name, other in zip(names, names[::-1], strict=True)}
    believed(signed({**turned, "derivatives": rates}))
    refused({**by_two, "derivatives": rates}, "the derivative of multiplier")


def test_derivatives_by_one_parameter_are_not_those_by_another(by_two):
    content = copy.deepcopy(by_two)
    for rates in (content["directions"], *content["derivatives"].values()):
        rates["V"] = rates["eta"]
    refused(content, "V moves something else")


PROPOSAL = ("parameters", "given_period", "itinerary", "declaration", "closing", "box", "bits")


@of_files("global-stick", "rigid", "irrational", "soft")
def test_the_judge_reads_the_proposal_alone_and_is_the_same_at_any_precision(content):
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
def test_boxes_without_the_orbit_are_refused(content):
    for place in range(len(content["box"])):
        changed = copy.deepcopy(content)
        moved(changed["box"][place])
        refused(changed)
    for radius in ("0", "-1e-20", "1e3"):
        refused(edited(content, stating("box", -1, rad=radius)))


def other_systems(declared, by, most, fixed=False):
    """Make numbers of visited fields, and of what ends a phase, larger: one at a time.

    If `fixed`, only those of fields that are no functions of parameters, which may be zero.
    """
    places = []
    for phase in declared["phases"]:
        entry = declared["configurations"][phase["configuration"]]
        ending = entry["boundaries"][phase["boundaries"][0]]
        # a row that is multiplied as a whole is the same boundary
        rows = [*entry["field"], *[ending] * (not fixed and len(ending) > ending.count("0") + 1)]
        places += [(row, k) for row in rows for k, number in enumerate(row)
                   if number != "0" and (isinstance(number, str) or not fixed)]  # fmt: skip
    for row, place in places[:: -(-len(places) // most)]:
        kept = row[place]
        if isinstance(kept, str):
            row[place] = str(Fraction(kept) * Fraction(by))
        else:
            above = [[str(Fraction(c) * Fraction(by)), powers] for c, powers in kept["above"]]
            row[place] = {**kept, "above": above}
        if row[place] != kept:  # a zero may have no terms
            yield
        row[place] = kept


@of_files("global-stick", "kicked", "rigid", "elastic", "soft")
def test_another_system_has_another_orbit(content):
    for _ in other_systems(content["declaration"], "1001/1000", 100):
        refused(content)


@of_files("kicked", "global-stick")
def test_boundaries_in_the_way_are_seen(content):
    phases, configurations = (content["declaration"][k] for k in ("phases", "configurations"))
    row = configurations[phases[0]["configuration"]]["boundaries"]
    size = len(content["declaration"]["states"])
    row["new"] = [*["0"] * size, "1"]  # positive everywhere
    refused(content, "admissibility is refuted")
    row["new"] = [*["0"] * size, "-1"]
    believed(signed(content))


@of_files("kicked")
def test_a_boundary_just_reached_inside_is_seen(content):
    wall = content["declaration"]["configurations"]["right"]["boundaries"]["wall"]
    wall[-1] = "-1999999999999/1000000000000"  # the orbit goes to 2
    content["margins"] = []
    refused(content, "admissibility is refuted")
    wall[-1] = "-2"
    refused(content, "admissibility is undecided")
    wall[-1] = "-2000000000001/1000000000000"
    believed(signed(content))


@of_files("global-stick", "rigid", "elastic", "kicked", "soft")
def test_margins_that_are_too_large_or_not_positive_are_refused(content):
    for place, margin in enumerate(content["margins"]):
        changed = copy.deepcopy(content)
        larger = str(Fraction(margin["least"]) * 3)
        for least in (larger, "0", "-1e-9", "-1"):
            changed["margins"][place]["least"] = least
            told = "is larger than what is proved" if least is larger else "is not positive"
            refused(changed, f"a margin {told}")
    content["margins"].append({**content["margins"][0], "boundary": "none"})
    refused(content, "a margin is stated of nothing")


@of_files("global-stick", "symmetric", "crossed", "tangent", "kicked")
def test_claims_of_another_verdict_are_refused(content):
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
def test_what_is_kept_is_not_taken_for_granted(content):
    for closing in ({**content["closing"], "kind": "state"}, {"kind": "state"}):
        for period in (content["given_period"], ""):
            refused({**content, "closing": closing, "given_period": period})
    refused(edited(content, placing("closing", "form", 0, 1, "1")), "no symplectic form")
    none = stating("closing", form=[["0"] * 4] * 4)
    refused(edited(content, none), "no symplectic form|neither energy nor form")
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


def exchange_boundaries(content):
    rows = content["declaration"]["configurations"]["slip-slip"]["boundaries"]
    names = "first-reaches-belt", "second-reaches-belt"
    rows |= {name: rows[other] for name, other in zip(names, names[::-1], strict=True)}


def begin_later(content, *parts):
    for holder, name in ((content, "itinerary"), (content["declaration"], "phases")):
        if name in parts:
            holder[name] = holder[name][1:] + holder[name][:1]


def end_at(content, place, boundary):
    content["declaration"]["phases"][place]["boundaries"] = [boundary]
    content["itinerary"][place][1] = boundary


@pytest.mark.parametrize(
    ("content", "change", "told"),
    [
        ("global-stick", exchange_boundaries, None),
        ("global-stick", lambda c: begin_later(c, "itinerary"), "itinerary"),
        ("global-stick", lambda c: begin_later(c, "itinerary", "phases"), None),
        ("global-stick", lambda c: end_at(c, 2, "second-reaches-belt"), "transition"),
        ("soft", lambda c: end_at(c, 0, "forcing-phase"), "a forcing's phase beside others"),
        ("twice", lambda c: end_at(c, 0, "forcing-phase"), "a forcing's phase beside others"),
    ],
    indirect=["content"],
)
def test_phases_end_where_the_itinerary_says(content, change, told):
    change(content)
    refused(content, told)


def ending_at(content, boundaries):
    """A file whose first phase and its transition name other boundaries."""
    changed = copy.deepcopy(content)
    declared = changed["declaration"]
    phase = declared["phases"][0]
    phase["boundaries"] = declared["transitions"][phase["transition"]]["boundaries"] = boundaries
    changed["itinerary"][0][1] = "+".join(boundaries)
    return changed


@of_files("soft", "kicked")
def test_what_the_itinerary_names_is_declared(content):
    declared = content["declaration"]
    phase = declared["phases"][0]
    ending = phase["boundaries"]
    for told in ([*ending, "forcing-phase"], ["forcing-phase", *ending], ["another"], []):
        refused(ending_at(content, told), "none of its boundaries")
    refused(ending_at(content, ending * 2), "a phase ends twice at a boundary")
    changed = copy.deepcopy(content)
    del changed["declaration"]["configurations"][phase["configuration"]]
    refused(changed, "a configuration of the itinerary is not declared")
    row = ["1"] * (len(declared["states"]) + 1)
    change = stating("declaration", "transitions", 0, conditions=[[row, "elsewhere", True]])
    refused(edited(content, change), "along no declared configuration")


@of_files("soft", "twice")
def test_forcings_have_to_return(content):
    for change in (
        stating("closing", turns=content["closing"]["turns"] + 1),
        stating("declaration", forcing=[]),
        stating("closing", kind="state"),
    ):
        refused(edited(content, change))


@of_files("perturbed", "soft")
def test_a_box_with_a_root_is_not_empty(content):
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
def test_constants_are_checked_and_balls_may_not_be_wider(content):
    assert content["claims"]["admissibility"] == "proved"
    other = {**content, "parameters": {**content["parameters"], "k": "sqrt(3)"}}
    refused(other)
    field = content["declaration"]["configurations"]["right"]["field"]
    assert "above" in field[1][0]
    # a ball around the same number proves no exact zeros, and a wide one nothing
    field[1][0] = {"mid": "-1.41421356", "rad": "1e-3"}
    refused(content)


@of_files("soft")
def test_names_are_not_taken_for_numbers(content):
    name = content["itinerary"][0][0]
    renamed = json.loads(json.dumps(content).replace(f'"{name}"', '"mid"'))
    assert renamed["itinerary"][0][0] == "mid"
    believed(signed(renamed))


# of `core`, with tests of their own


# of `core`, with tests of their own
ARITHMETIC = {
    "taylor_models", "jets", "rational_functions", "irrational_numbers",
    "float_sets", "exponentials", "exponentials.float_flows", "box_grid",
    # no arithmetic: who does which part, what is no number, and what is public
    "parallel", "errors", "values", "registry", "arguments",
}  # fmt: skip
ALONE = """
import atexit, runpy, sys
atexit.register(lambda: print(*sys.modules))
runpy.run_module("nonsmooth.runtime.checker", run_name="__main__")
"""


def grazing():
    branch = ns.continue_orbit(loop(), "a", (1.5, 3.5))
    return ns.certify.event(branch, branch.events[-1])


@pytest.mark.parametrize(
    "prove",
    [
        lambda: certificate("elastic"),
        lambda: ns.certify.box(loop(), {"r": ("2/5", "3/5")}),
        grazing,
    ],
)
def test_the_checker_takes_nothing_but_its_arithmetic(prove, tmp_path):
    path = tmp_path / "certificate.json"
    prove().save(path)
    done = subprocess.run(
        [sys.executable, "-c", ALONE, str(path)], capture_output=True, text=True, check=False
    )
    told, loaded = done.stdout.splitlines()
    assert (done.returncode, told) == (0, f"{path}: every claim holds"), done.stderr
    room = "nonsmooth.runtime."
    own = {name.removeprefix(room) for name in loaded.split() if name.startswith(room)}
    others = {name for name in own if name.partition(".")[0] != "checker"}
    assert others == {"core", *(f"core.{name}" for name in ARITHMETIC)}


def with_entry(change):
    """A change of the text of a file to that with an entry changed, its checksum made right."""
    return lambda text: json.dumps(edited(json.loads(text), change))


WRONG = [
    (lambda text: text, 0, "every claim holds", ""),
    *(
        (with_entry(stating("parameters", k=k)), code, told, "")
        for k, code, told in (
            ("1/0", 2, "division by zero"),
            ("sum", 2, "unknown name 'sum'"),
            ("5/7", 1, "not proved"),
        )
    ),
    (lambda text: text[:-20], 2, "it cannot be read", "cut, or not JSON"),
    (lambda text: "[" * 10**5, 2, "it cannot be read", ""),
    (lambda text: "", 2, "it cannot be read", ""),
    (lambda text: "[]", 2, "it is no certificate", "not a (certificate|saved result)"),
    (
        with_entry(lambda c: c.update(margin=c.pop("margins"))),
        2, "it is malformed", "missing|unknown",
    ),
    (
        with_entry(stating(bits="128")),
        2, "it is malformed", "'bits' is of the wrong type",
    ),
    (with_entry(stating(version=9)), 2, "malformed", "version 9"),
    (lambda text: text.replace('"bits": 128', '"bits": 129', 1), 1, "not proved: edited", ""),
]  # fmt: skip


@pytest.mark.parametrize(("change", "code", "told", "refusal"), WRONG)
def test_what_is_wrong_is_said_in_one_line(
    change, code, told, refusal, tmp_path, monkeypatch, capsys
):
    path = tmp_path / "certificate.json"
    certificate("kicked").save(path)
    path.write_text(change(path.read_text()))
    assert CliRunner().invoke(app, ["certify", "check", str(path)]).exit_code == code
    for file, exit_code, words in ((path, code, told), (tmp_path / "none.json", 2, "be read")):
        monkeypatch.setattr(sys, "argv", ["checker", str(file)])
        with pytest.raises(SystemExit) as ended:
            runpy.run_module("nonsmooth.runtime.checker", run_name="__main__")
        said = "".join(capsys.readouterr())
        assert ended.value.code == exit_code
        assert words in said
        assert said.count("\n") == 1
    for work in (ns.load, ns.certify.check) if refusal else ():
        with pytest.raises(InputError, match=refusal):
            work(path)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("1e3000", "1e+3000"),
        (f"1{'0' * 3000}", "1e+3000"),
        (f"1/1{'0' * 21}", "1e-21"),
        *((text, None) for text in ("1/0", "1.5/2", "1e999999999", "٣")),
    ],
)
def test_numbers_that_no_double_is_are_shown_and_others_refused_in_one_line(text, told, tmp_path):
    content = content_of(certificate("global-stick"))
    content["enclosures"]["period"]["rad"] = text
    path = saved(content, tmp_path / "proof.json")
    if told:
        assert f" +- {told}" in str(ns.certify.check(path)).lower()
        return
    with pytest.raises(InputError, match=r"proof\.json: .") as caught:
        ns.certify.check(path)
    assert "\n" not in str(caught.value)


def test_bounds_that_are_fractions_are_shown(tmp_path):
    content = content_of(certificate("global-stick"))
    content["other_multipliers"] = "1/64"
    content["margins"][0]["least"] = content["box"][0]["rad"] = f"1/{10**20}"
    told = ns.load(saved(content, tmp_path / "certificate.json"))._repr_html_()
    assert "at most 0.015625 in absolute value" in told
    assert told.count("1e-20") == 2


@pytest.mark.parametrize(
    ("first", "last", "given_back"), [(2, 1, True), (-2, -1, True), (2, -1, False), (0, 1, False)]
)
def test_the_energy_gives_back_the_coordinate_left_out(first, last, given_back):
    """Where it changes with it all the way between the ends of the cycle, as x^2/2 does with x."""
    orbit = SimpleNamespace(
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
def test_no_power_of_any_parameter_is_too_high(content, part, exponents):
    wall = content["declaration"]["configurations"]["right"]["boundaries"]["wall"]
    wall[-1] = {"above": [["-1", [0, 1, 2]]], "below": [["1", [0, 1, 1]]]}  # -a, in other words
    believed(signed(content))
    wall[-1][part] = [["1", exponents]]
    refused(content, "a power too high")


def test_a_model_of_a_lower_order_holds_what_it_leaves_out():
    space = space_of(2, 5)
    whole = TaylorModel(space, tuple(arb(1) for _ in space.exponents))
    part = lower(whole)
    assert part.space.order < space.order
    for place in ((1, 1), (-1, 1), (0.5, -1), (0, 0)):
        assert part.at([*map(arb, place)]).contains(whole.at([*map(arb, place)]))
