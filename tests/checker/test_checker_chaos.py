"""The check of chaos in files: what is stated is proved again, and what is not so is refused."""

import json
from contextlib import nullcontext
from cProfile import Profile
from dataclasses import replace
from fractions import Fraction

import pytest
from flint import arb, arb_mat
from typer.testing import CliRunner

import nonsmooth as ns
from nonsmooth import Interrupted
from nonsmooth.runtime.checker import Failure
from nonsmooth.runtime.checker.state_sets.chaos import Covered, StretchedSets, _placed, check_cones
from nonsmooth.runtime.checker.state_sets.sets import StateSet
from nonsmooth.runtime.cli.program import app
from nonsmooth.runtime.proof.chaos.cone_conditions import ConeCondition
from tests.certified import (
    believed,
    content_of,
    edited,
    placing,
    refused,
    refused_file,
    saved,
    signed,
    stating,
)
from tests.horseshoes import (
    FOLDED,
    FOLDED_DATA,
    FRICTION_DATA,
    folded_horseshoe,
    inverted_horseshoe,
)
from tests.shared import shared_file
from tests.tables import slow


@pytest.fixture(scope="module")
def written():
    """Chaos on a section of one coordinate, without cones."""
    return shared_file("nonsmooth chaos certificate", folded_horseshoe)


@pytest.fixture(scope="module")
def rated(tmp_path_factory):
    """The same with cones."""
    path = tmp_path_factory.mktemp("chaos") / "rated.json"
    folded_horseshoe(exponents=True).save(path)
    return path


@pytest.fixture(scope="module")
def coned(tmp_path_factory):
    """Chaos of a forced oscillator between stops, with cones whose rates are proved at once."""
    path = tmp_path_factory.mktemp("chaos") / "cones.json"
    strips = (
        ("A", "A", (("-1/4", "1/4"), ("-1", "1"))),
        ("A", "B", (("-15/16", "-5/8"), ("-1", "1"))),
        ("B", "A", (("-1", "-1/2"), ("-1", "1"))),
    )
    forms = {"A": ("1", "1"), "B": ("3/4", "3/4")}
    cones = ConeCondition(forms, strips, expansion="10", contraction="2/3", exponent="1.15")
    replace(inverted_horseshoe(exponents=False), cones=cones, parts=2000).save(path)
    return path


def changed(written, tmp_path, change):
    """What the check says of a file with a change, its checksum made right."""
    return ns.certify.check(saved(edited(written, change), tmp_path / "changed.json"))


def test_a_file_is_proved_again(rated):
    found = ns.certify.check(rated)
    assert found.difference is None
    assert found.claims == {"chaos": "proved"}
    loaded = ns.load(rated)
    assert loaded.to_json() == found.certificate.to_json()
    assert loaded.periodic_points(5) == found.certificate.periodic_points(5) > 0


def test_fractions_are_as_good_as_decimals(written, tmp_path):
    def rewrite(content):
        for own in content["h_sets"]:
            own["centre"] = [str(Fraction(x)) for x in own["centre"]]
            own["sides"] = [[str(Fraction(x)) for x in side] for side in own["sides"]]

    found = changed(written, tmp_path, rewrite)
    assert found.difference is None
    for own, other in zip(ns.load(written).h_sets, found.certificate.h_sets, strict=True):
        assert own.corners.tolist() == other.corners.tolist()


def more_edges(content):
    names = [entry["name"] for entry in content["h_sets"]]
    content["coverings"].append(
        next([a, b] for a in names for b in names if [a, b] not in content["coverings"])
    )


def moved_set(content):
    own = content["h_sets"][0]
    shift = abs(3 * Fraction(own["sides"][0][0]))
    own["centre"][0] = str(float(Fraction(own["centre"][0]) + shift))


def sets_that_meet(content, share=None):
    first, second = content["h_sets"]
    second["centre"] = first["centre"]
    if share:
        second["sides"] = [[str(Fraction(x) * share) for x in side] for side in first["sides"]]


def no_boundary(content):
    source, boundary, _ = next(iter(content["itineraries"].values()))[0]
    content["declaration"]["configurations"][source]["boundaries"].pop(boundary)


def shorter_way(content):
    content["itineraries"][content["h_sets"][0]["name"]].pop()


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (more_edges, "does not cover"),
        (moved_set, ""),
        (placing("h_sets", 0, "centre", 0, "1e5000"), "not proved"),
        (sets_that_meet, "in common"),
        (lambda content: sets_that_meet(content, Fraction(1, 4)), "in common"),
        (stating(entropy="0.241"), ""),
        (stating(growth="1619/1000"), ""),
        (stating(growth="1" * 5000), "grows less"),
        (stating(growth="1e999999"), "grows less"),
        (no_boundary, "has no boundary"),
        (shorter_way, ""),
        (stating(iterates=1, entropy="0.48"), "back to the section"),
        (stating("parameters", r="0.3"), ""),  # where is no chaos
    ],
)
def test_what_is_false_is_refused(written, tmp_path, change, told):
    refused_file(edited(written, change), tmp_path, told)


def test_parameters_that_the_declaration_does_not_name_are_refused(written, tmp_path):
    content = edited(written, stating("parameters", unheard="1"))
    refused_file(content, tmp_path, "")
    refused(content, "not over the parameters that are named")


class Stretched:
    """The set [-1, 1], mapped by x -> 3 x + bend x^2."""

    def __init__(self, bend=0.0):
        self.bend = bend

    def image(self, box):
        ((low, high),) = box
        x = arb((low + high) / 2, float(high - low) / 2)
        none = arb_mat(2, 0), arb_mat(2, 1)
        slope = StateSet.of(arb_mat([[3 + 2 * self.bend * x], [0]]), *none)
        image = StateSet.of(arb_mat([[3 * x + self.bend * x * x], [1]]), *none)
        return image._replace(sides=arb_mat(2, 1), tangents=(slope,))

    def seen(self, target, image):
        return image.through(arb_mat([[1, 0]]))

    def lengths(self, box):
        return [float(b - a) for a, b in box]


@pytest.mark.parametrize(
    ("change", "bend", "told"),
    [
        ({}, 0.0, None),
        ({"expansion": "91/10"}, 0.0, "cone condition"),
        ({"exponent": "1.04"}, 0.0, "larger"),
        ({"contraction": "1/2"}, 0.0, "do not shrink"),
        ({"strips": [["A", "A", [["-1/4", "1/2"]]]]}, 0.0, "stretched by"),
        # the derivative over the strip is from 2.7 to 3.4, or from 2.6 to 3.3
        *(({"expansion": "13/2", "exponent": "0.9"}, bend, None) for bend in (0.4, -0.4)),
        *(({"exponent": "0.9"}, bend, "cone condition") for bend in (0.4, -0.4)),
    ],
)
def test_cones_on_a_section_of_one_coordinate(change, bend, told):
    # what comes to the set is within -1/3 and 1/3; log(8) / 2 = 1.0397...
    stated = {"forms": {"A": ["1"]}, "strips": [["A", "A", [["-3/8", "1/2"]]]]}
    stated |= {"expansion": "8", "contraction": "0", "exponent": "1.0397", **change}
    with pytest.raises(Failure, match=told) if told else nullcontext():
        check_cones(stated, {"A": ["A"]}, lambda name: Stretched(bend), 1, 1)


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (stating("forms", A=["1", "-1"]), "positive number"),
        (stating("forms", A=["1"]), "positive number"),
        (stating("forms", C=["1", "1"]), "cones of other sets"),
        (lambda cones: cones["strips"].pop(), "strips of other"),
        (lambda cones: cones["strips"].append(cones["strips"][0]), "twice"),
        (lambda cones: cones["strips"][0][2][0].reverse(), "no box"),
        (placing("strips", 0, 2, 1, 1, "9/8"), "no box"),
        (stating(expansion="1"), "do not grow"),
        (stating(contraction="0"), "do not shrink"),
        (stating(contraction="1"), "do not shrink"),
        (stating(exponent="1.152"), "larger"),  # log(10) / 2 = 1.15129...
        (stating(exponent="0"), "no positive"),
    ],
)
def test_cones_that_cannot_be_are_refused_before_sets_are_mapped(coned, change, told):
    content = content_of(coned)
    change(content["cones"])
    targets = {"A": ["A", "B"], "B": ["A"]}
    with pytest.raises(Failure, match=told):
        check_cones(content["cones"], targets, pytest.fail, 2, content["iterates"])


def narrower(cones, place, side):
    """Half of a strip."""
    entries = cones["strips"][place][2][side]
    entries[0] = str(sum(map(Fraction, entries)) / 2)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("change", "told"),
    [
        (lambda cones: None, None),
        (stating(expansion="50"), "cone condition"),
        slow(stating(contraction="1/50"), "cone condition"),
        slow(stating("forms", A=["1/100", "1"]), "cone condition"),
        # what is mapped into the target from the rest is noticed
        (lambda cones: narrower(cones, 0, 0), "stretched by is not proved"),
        (lambda cones: narrower(cones, 1, 1), "stretched by is not proved"),
    ],
)
def test_cones_that_say_too_much_are_refused(coned, tmp_path, monkeypatch, change, told):
    # fewer rounds before it gives up, and what is not of cones is proved elsewhere
    monkeypatch.setattr("nonsmooth.runtime.checker.state_sets.chaos.SPREADS", (1.0, 0.4))
    monkeypatch.setattr(StretchedSets, "covered", lambda *_: Covered((), (), {}))
    found = changed(coned, tmp_path, lambda content: change(content["cones"]))
    assert found.difference is None if told is None else told in found.difference


def test_strips_may_end_anywhere(rated, tmp_path):
    def wider(content):
        for *_, (along,) in content["cones"]["strips"]:
            low, high = map(Fraction, along)
            along[:] = [str(max(low - Fraction(1, 7), -1)), str(min(high + Fraction(1, 7), 1))]
        content["cones"] |= {"expansion": "2", "exponent": "0.17"}

    assert changed(rated, tmp_path, wider).difference is None


def many(content):
    """A horseshoe of very many sets, of which each covers all."""
    own = content["h_sets"][0]
    content["h_sets"] = [
        {**own, "name": f"{k}", "centre": [str(9 * k), own["centre"][1]]} for k in range(120)
    ]
    names = [entry["name"] for entry in content["h_sets"]]
    content["coverings"] = [[a, b] for a in names for b in names]
    way = content["itineraries"]["A"]
    content["itineraries"] = dict.fromkeys(names, way)


def again(content):
    """More iterates, and the way as often."""
    content["iterates"] *= 3
    content["itineraries"] = {n: 3 * way for n, way in content["itineraries"].items()}
    content["entropy"] = "0.01"


def first_entry(content, text):
    """Another number in the first field."""
    content["declaration"]["configurations"]["free-free"]["field"][0][0] = text


def raised(content):
    """High powers of all parameters."""
    for entry in content["declaration"]["configurations"].values():
        for term in (x for row in entry["field"] for x in row if isinstance(x, dict)):
            term["above"][0][1] = [10_000] * 3


def longer(content, share):
    """Longer sets."""
    for own in content["h_sets"]:
        own["sides"] = [[str(Fraction(x) * share) for x in side] for side in own["sides"]]


def calls_of(content):
    """How many functions of Python a check of a file calls, and whether it proves all."""
    whole, proved = signed(content), True
    with Profile(builtins=False) as profile:
        try:
            believed(whole)
        except Failure:
            proved = False
    return sum(entry.callcount for entry in profile.getstats()), proved


@pytest.fixture(scope="module")
def few(coned):
    """A file without cones, and the calls of its check."""
    content = {**content_of(coned), "cones": None, "parts": 400}
    calls, proved = calls_of(content)
    assert proved
    return content, calls


@pytest.mark.slow
@pytest.mark.parametrize(
    "change",
    [
        many,
        again,
        raised,
        lambda content: first_entry(content, "100"),
        lambda content: first_entry(content, "1e9999"),
        stating(iterates=64, entropy="0.001"),
        stating(iterates=10**6, entropy="1e-9"),
        stating(parts=10**9),
        lambda content: longer(content, 2),
        slow(stating("parameters", w="1e9")),
        stating("parameters", a="1e300"),
    ],
)
def test_a_false_file_takes_no_more_than_several_times_the_work_of_the_true_one(few, change):
    content, most = json.loads(json.dumps(few[0])), 10 * few[1]
    change(content)
    calls, proved = calls_of(content)
    assert not proved
    assert calls < most, calls / most


@pytest.mark.slow
def test_a_check_encloses_few_times_as_many_images_as_the_file_states(coned, tmp_path):
    for parts, told in ((1, "too many parts"), (400, None)):
        found = changed(
            coned, tmp_path, lambda content, n=parts: content.update(parts=n, cones=None)
        )
        assert found.difference is None if told is None else told in found.difference


@pytest.mark.parametrize("phase", [["1", "0"], ["-4/5", "3/5"], ["-1", "1"]])
def test_another_phase_is_refused(coned, tmp_path, phase):
    refused_file(edited(coned, stating(phase=phase)), tmp_path, "")


@pytest.mark.slow
def test_the_command(tmp_path, monkeypatch):
    monkeypatch.setattr("nonsmooth.runtime.proof.chaos.certify_chaos._BASES", 100)
    target = tmp_path / "command.json"
    words = ["certify", "chaos", str(FOLDED), "r=2.9", "c=0.8", "--from", "x=0,v=0.4637"]
    words += ["--iterates", "1", "--save", str(target), "--json"]
    told = CliRunner().invoke(app, words)
    assert told.exit_code == 0, told.output
    answer = json.loads(told.stdout)
    assert (answer["claim"], answer["cones"]) == ("proved", None)
    assert ns.load(target).entropy == answer["entropy"]


def test_the_command_where_there_is_no_chaos(tmp_path):
    calm = {**FRICTION_DATA, "V": "0.3", "ur1": "1.5", "ur2": "1.5", "eta": "1"}
    words = ["certify", "chaos", "dry-friction", *(f"{name}={text}" for name, text in calm.items())]
    words += ["--iterates", "1", "--from", "x1=1,x2=1.2,v1=0.1,v2=0.1"]
    picture = tmp_path / "no.png"
    words += ["--exponents", "--plot", str(picture)]
    told = CliRunner().invoke(app, words)
    assert told.exit_code == 1
    assert "tried:" in told.stdout
    assert "no picture: nothing is proved" in told.stderr
    assert not picture.exists()
    assert CliRunner().invoke(app, [*words, "--require", "proved"]).exit_code == 3


def test_what_is_proved_when_exponents_are_interrupted_is_kept(tmp_path, monkeypatch):
    def stopped(*arguments):
        raise KeyboardInterrupt

    monkeypatch.setattr("nonsmooth.runtime.proof.chaos.certify_chaos.cone_condition", stopped)
    with pytest.raises(Interrupted) as caught:
        folded_horseshoe(exponents=True)
    partial = caught.value.partial
    assert partial.proved
    assert partial.tried[-1] == "no cone condition: interrupted"

    def ended(*arguments, **options):
        raise Interrupted(partial)

    monkeypatch.setattr("nonsmooth.runtime.proof.chaos.certify_chaos.certify_chaos", ended)
    target = tmp_path / "part.json"
    words = [
        "certify",
        "chaos",
        str(FOLDED),
        *(f"{name}={text}" for name, text in FOLDED_DATA.items()),
    ]
    words += ["--from", "x=0,v=0.4637", "--exponents", "--save", str(target)]
    told = CliRunner().invoke(app, words)
    assert told.exit_code == 130
    assert f"chaos is proved, no exponents, kept in {target}" in told.stderr
    assert ns.certify.check(target).difference is None


@pytest.mark.parametrize("stable", ["0.999", "-0.999", "1.001", "-1.001", "1.4", "2", "1 +/- 1e-9"])
@pytest.mark.parametrize("unstable", ["0", "1.001", "-1.001", "1 +/- 1e-9"])
def test_an_image_lies_beyond_a_set_or_strictly_between_its_stable_sides(unstable, stable):
    beyond, between = unstable.endswith("1.001"), stable.endswith("0.999")
    assert _placed([arb(unstable), arb("0.5"), arb(stable)], False) == (beyond or between)
    assert _placed([arb(unstable), arb(stable)], True) == beyond
