"""The check of chaos in files: what is stated is proved again, and what is not so is refused."""

import json
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import pytest
from typer.testing import CliRunner

import nonsmooth as ns
from nonsmooth.runtime.cli.program import app
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.result_files import checksum_of
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.model.kernels import load_system
from nonsmooth.runtime.proof.chaos.certify_chaos import _ChaosQuestion
from nonsmooth.runtime.proof.chaos.h_sets import HSet
from nonsmooth.runtime.proof.chaos.search import Horseshoe
from nonsmooth.runtime.proof.motion.enclosures import enclosed_system
from nonsmooth.runtime.proof.sets.sections import forcing_section
from tests.places import GALLERY

DATA = {
    "chi": "0.34",
    "eta": "2.88",
    "V": "1.23",
    "us1": "0.75",
    "us2": "1.19",
    "ur1": "2.04",
    "ur2": "1.83",
}
START = (1.93, 7.18, 1.18, 1.18)


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    path = tmp_path_factory.mktemp("chaos") / "chaos.json"
    found = ns.certify_chaos("dry-friction", DATA, START, iterates=3, exponents=True)
    assert found.proved
    found.save(path)
    return path


def changed(written, tmp_path, change):
    """What the check says of a file with a change, its checksum made right."""
    content = json.loads(written.read_text())
    change(content)
    content["sha256"] = checksum_of(content)
    path = tmp_path / "changed.json"
    path.write_text(json.dumps(content))
    return ns.check_certificate(path)


def test_a_file_is_proved_again(written):
    found = ns.check_certificate(written)
    assert found.difference is None
    assert found.claims == {"chaos": "proved"}
    loaded = ns.load(written)
    assert loaded.to_json() == found.certificate.to_json()
    assert loaded.periodic_points(5) == found.certificate.periodic_points(5) > 0


def test_the_checker_alone_proves_it(written):
    command = [sys.executable, "-m", "nonsmooth.runtime.checker", str(written)]
    told = subprocess.run(command, capture_output=True, text=True, check=True)
    assert told.stdout == "every claim is proved\n"


def test_an_edge_that_is_added_is_refused(written, tmp_path):
    def add(content):
        pairs = {tuple(pair) for pair in content["coverings"]}
        names = [entry["name"] for entry in content["h_sets"]]
        missing = [[a, b] for a in names for b in names if (a, b) not in pairs]
        content["coverings"].append(missing[0])

    assert "does not cover" in str(changed(written, tmp_path, add).difference)


def test_a_set_that_is_moved_is_refused(written, tmp_path):
    def move(content):
        own = content["h_sets"][0]
        shift = 3 * Fraction(own["sides"][0][0])
        own["centre"][0] = str(float(Fraction(own["centre"][0]) + abs(shift)))

    assert changed(written, tmp_path, move).difference


def test_a_set_out_of_the_range_of_doubles_is_refused(written, tmp_path):
    def far(content):
        content["h_sets"][0]["centre"][0] = "1e5000"

    assert "not proved" in changed(written, tmp_path, far).difference


def test_fractions_are_as_good_as_decimals(written, tmp_path):
    def rewrite(content):
        for own in content["h_sets"]:
            own["centre"] = [str(Fraction(x)) for x in own["centre"]]
            own["sides"] = [[str(Fraction(x)) for x in side] for side in own["sides"]]

    found = changed(written, tmp_path, rewrite)
    assert found.difference is None
    for own, other in zip(ns.load(written).h_sets, found.certificate.h_sets, strict=True):
        assert "/" in other.centre[0]
        assert own.corners.tolist() == other.corners.tolist()


def test_sets_that_meet_are_refused(written, tmp_path):
    def meet(content):
        first, second = content["h_sets"]
        second["centre"] = first["centre"]

    assert "in common" in changed(written, tmp_path, meet).difference


@pytest.mark.parametrize(("name", "text"), [("entropy", "0.241"), ("growth", "1619/1000")])
def test_an_entropy_that_is_raised_is_refused(written, tmp_path, name, text):
    assert changed(written, tmp_path, lambda content: content.update({name: text})).difference


def test_a_growth_of_too_many_digits_and_a_boundary_that_is_gone_are_refused(written, tmp_path):
    def gone(content):
        source, boundary, _ = next(iter(content["itineraries"].values()))[0]
        content["declaration"]["configurations"][source]["boundaries"].pop(boundary)

    with pytest.raises(InputError, match="'growth' of the file"):
        changed(written, tmp_path, lambda content: content.update(growth="1" * 5000))
    assert "has no boundary" in changed(written, tmp_path, gone).difference


def test_cones_that_say_too_much_are_refused(written, tmp_path, monkeypatch):
    def faster(content):
        content["cones"]["expansion"] = "7"

    def larger(content):
        content["cones"]["exponent"] = "0.3"

    def narrower(content):
        entries = content["cones"]["strips"][0][2][0]
        entries[0] = str(Fraction(entries[1]) - Fraction(1, 8))

    def fewer(content):
        content["cones"]["strips"].pop()

    def shrinking(content):
        content["cones"]["contraction"] = "1/2"

    with monkeypatch.context() as patch:  # fewer rounds before it gives up
        patch.setattr("nonsmooth.runtime.checker.cones._SPREADS", (1.0, 0.4))
        assert "cone condition" in changed(written, tmp_path, faster).difference
    assert "exponent" in changed(written, tmp_path, larger).difference
    assert "stretched by" in changed(written, tmp_path, narrower).difference
    assert "strips of other" in changed(written, tmp_path, fewer).difference
    assert "shrink" in changed(written, tmp_path, shrinking).difference


def test_a_file_without_cones_is_proved(written, tmp_path):
    found = changed(written, tmp_path, lambda content: content.pop("cones"))
    assert found.difference is None
    assert found.certificate.exponent == "0"


def test_another_way_is_refused(written, tmp_path):
    def shorten(content):
        name = content["h_sets"][0]["name"]
        content["itineraries"][name] = content["itineraries"][name][:-1]

    def fewer(content):
        content["iterates"] = 1
        content["entropy"] = "0.48"

    assert changed(written, tmp_path, shorten).difference
    assert "back to the section" in changed(written, tmp_path, fewer).difference


def test_parameters_without_chaos_are_refused(written, tmp_path):
    def stable(content):
        content["parameters"]["V"] = "0.3"

    assert changed(written, tmp_path, stable).difference


def test_a_forced_oscillator_with_given_sets(tmp_path):
    system = load_system(str(GALLERY / "impact_oscillator.py"))
    sets = (
        HSet("A", ("-0.42770417", "-0.43881741"),
             (("0.01740887", "0.01040848"), ("0.03548872", "0.00121854"))),
        HSet("B", ("-0.16885321", "-0.26165579"),
             (("0.00894038", "0.01421056"), ("-0.02533881", "0.01613918"))),
    )  # fmt: skip
    values = {"r": "0.65", "sigma": "0", "w": "2.8"}
    with flint_precision(80):
        from flint import fmpq

        enclosed = enclosed_system(system, values)(80)
        section = forcing_section(enclosed, 0, (fmpq(160, 281), fmpq(-231, 281)))
        question = _ChaosQuestion(system, enclosed, 3, 3000, False, lambda done: None)
        guess = Horseshoe(3, sets, ((0, 0), (0, 1), (1, 0)), 0.0)
        found = question.prove(section, guess)
        assert found is not None, question.tried
        too_much = Horseshoe(3, sets, ((0, 0), (1, 1)), 0.0)
        assert question.prove(section, too_much) is None
    path = tmp_path / "forced.json"
    found.save(path)
    assert ns.check_certificate(path).difference is None
    content = json.loads(path.read_text())
    content["phase"] = ["1", "0"]
    content["sha256"] = checksum_of(content)
    path.write_text(json.dumps(content))
    assert ns.check_certificate(path).difference


def test_the_command(written, tmp_path):
    runner = CliRunner()
    arguments = [f"{name}={text}" for name, text in DATA.items()]
    begin = "x1=1.93,x2=7.18,v1=1.18,v2=1.18"
    target = Path(tmp_path / "command.json")
    told = runner.invoke(
        app,
        [
            *("chaos", "dry-friction", *arguments, "--from", begin),
            *("--exponents", "--save", str(target), "--json"),
        ],
    )
    assert told.exit_code == 0, told.output
    answer = json.loads(told.stdout)
    assert answer["claim"] == "proved"
    assert answer["entropy"] == json.loads(written.read_text())["entropy"]
    told = runner.invoke(app, ["certify", "--check", str(target), "--require", "proved"])
    assert told.exit_code == 0
    assert f"entropy of P at least {answer['entropy']}" in told.stdout
    assert f"exponents of these motions at least {answer['cones']['exponent']}" in told.stdout
    calm = {**DATA, "V": "0.3", "ur1": "1.5", "ur2": "1.5", "eta": "1"}
    stable = [*(f"{name}={text}" for name, text in calm.items()), "--iterates", "1"]
    stable += ["--from", "x1=1,x2=1.2,v1=0.1,v2=0.1"]
    told = runner.invoke(app, ["chaos", "dry-friction", *stable, "--require", "proved"])
    assert told.exit_code == 3
    assert "tried:" in told.stdout
    told = runner.invoke(app, ["chaos", "dry-friction", *arguments])
    assert told.exit_code == 2
    assert "start is missing" in told.output
