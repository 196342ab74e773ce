"""The reproduction of the source paper: files, numbers by other routes, bad input."""

import json
import re
import sys
from decimal import Decimal
from pathlib import Path

import numpy as np
import pytest
from mpmath import mp

from nonsmooth import MissingExtra, refine, solve
from nonsmooth.runtime.present.paper import writing
from tests.cli.test_cli import refused, told
from tests.present.conftest import written

ORBITS = (
    *("rigid-stop/one-impact", "elastic-stop/one-contact", "dry-friction/symmetric"),
    *("dry-friction/global-stick", "dry-friction/solution-ii"),
)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """What the command writes; drawn are the paper's figures as SVG, and the first as PNG."""
    figure = pytest.importorskip("matplotlib.figure")
    folder = tmp_path_factory.mktemp("paper") / "new" / "folder"
    save, drawn = figure.Figure.savefig, []

    def saved(own, target, **options):
        if len(drawn) < (22 if options["format"] == "svg" else 2):
            save(own, target, **options)
        drawn.append(options["format"])

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(figure.Figure, "savefig", saved)
        answer = told("reproduce", "--out", str(folder))
    assert {Path(path) for path in answer["files"]} == set(folder.iterdir())
    return folder


@pytest.fixture(scope="module")
def results(paper):
    return paper.results


@pytest.mark.slow
def test_figures_show_the_spans_of_the_paper(results, paper):
    assert {f"figure-{number:02}" for number in range(1, 12)} <= set(paper.figures)
    for number, name, mass, periods in (
        *((2, ORBITS[0], "x_{1}", 2), (3, ORBITS[0], "x_{2}", 2)),
        *((4, ORBITS[1], "x_{1}", 1), (5, ORBITS[1], "x_{2}", 1)),
    ):
        (axes,) = paper.figures[f"figure-{number:02}"].axes
        period = float(results["orbits"][name]["period"])
        np.testing.assert_allclose(axes.get_xlim(), (0, periods * period), rtol=1e-12)
        assert mass in axes.get_ylabel()
        assert axes.get_xlabel() == "time $t$"  # the paper has units there


def test_every_printed_number_stands_beside_ours(results):
    printed = [entry["printed"] for entry in results["comparisons"]]
    assert sorted(set(printed)) == sorted(
        ["2.65", "2.2407", "1", "2", "1.568", "3.28", "1.1838", "-2.6715", "3.0195", "0.4831"]
    )
    for entry in results["comparisons"]:
        assert len(entry["ours"].lstrip("-").replace(".", "")) >= 30
        difference = Decimal(entry["ours"]) - Decimal(entry["printed"])
        assert float(difference) == pytest.approx(float(entry["difference"]), rel=1e-2)
        agrees = re.fullmatch(r"agrees within ([\d.]+) %", entry["verdict"])
        if agrees:
            assert abs(difference / Decimal(entry["ours"])) <= Decimal(agrees[1]) / 100
        else:
            assert entry["verdict"] == "agrees within the printed digits"
            places = len(entry["printed"].partition(".")[2])
            assert abs(difference) <= Decimal(5).scaleb(-places - 1)
            assert places  # integers are meant exactly


def test_verdicts_are_those_of_the_numbers_and_not_written_down(
    results, orbits, tmp_path,
    monkeypatch,
):  # fmt: skip
    """Of other data the printed digits are others, and a number agrees if it does in all rows."""
    for name, data in ((ORBITS[2], {"V": "0.68", "e2": "0.501"}), (ORBITS[3], {"V": "1.05"})):
        orbits = {**orbits, name: refine(solve(name, data), 35)}
    orbits["a | b"] = orbits[ORBITS[3]]  # a name that no cell of a table holds as it is
    monkeypatch.setattr(writing, "paper_orbits", lambda begin: orbits)
    moved = written(tmp_path, lambda orbit, section: (), certified=True)
    verdicts = {}
    for entry in moved.results["comparisons"]:
        verdicts.setdefault((entry["where"], entry["quantity"]), set()).add(entry["verdict"])
    exact = "agrees within the printed digits"
    told = re.search(r"Of 10 printed numbers (\d+) agree", moved.read("report.md"))
    assert told is not None
    assert int(told[1]) == sum(found == {exact} for found in verdicts.values())
    assert any(exact in found and len(found) > 1 for found in verdicts.values())
    assert "\n| a \\| b | proved | " in moved.read("report.md")
    known, other = (found["misprints"] for found in (results, moved.results))
    for place, same in ((-1, False), (-2, False), (1, True)):
        assert (other[place]["table"]["rows"] == known[place]["table"]["rows"]) == same


def test_the_appendix_gives_the_orbit_of_the_six_equations(results):
    conditions, starts = results["tables"][2:4]
    assert len(conditions["rows"]) == 6
    assert all(abs(float(side)) < 1e-30 for _, side in conditions["rows"])
    unknowns = results["orbits"]["dry-friction/global-stick"]["unknowns"]
    for (_, ours, theirs, difference), name in zip(starts["rows"], ("z10", "z20"), strict=True):
        assert theirs == unknowns[name]
        assert abs(Decimal(ours) - Decimal(theirs)) <= Decimal("1e-29")
        assert abs(float(difference)) < 1e-30


def test_contact_orbits_are_there_with_the_corrected_stiffness_alone(
    results,
):
    unknowns = solve("elastic-stop/one-contact").unknowns
    rows = results["misprints"][1]["table"]["rows"]
    printed, corrected = ([row for row in rows if k in row[0]] for k in ("k_3", "k_2"))
    assert printed
    assert all(row[3].startswith("no: ") for row in printed)
    ((_, tau, u, admissible),) = corrected
    assert admissible == "yes"
    assert float(tau) == pytest.approx(unknowns["tau"], rel=1e-6)
    assert float(u) == pytest.approx(unknowns["u"], rel=1e-6)


def test_claims_hold(results):
    assert [finding["verdict"] for finding in results["misprints"]] == ["misprint"] * 9
    limit, portraits, criterion = results["claims"]
    assert [claim["verdict"] for claim in results["claims"]] == ["holds"] * 3
    scaled = [float(row[2]) for row in limit["table"]["rows"]]
    assert abs(scaled[-1] / scaled[-2] - 1) < 1e-3
    assert "unstable" in portraits["evidence"]
    assert "stable" in criterion["evidence"]
    assert "vanishes to 50 digits" in criterion["evidence"]


@pytest.mark.slow
def test_results_are_the_same_again(paper, folder):
    """Also a picture, byte by byte, and with all pictures; the command proves nothing unasked."""
    for number in range(1, 12):
        assert (folder / f"figure-{number:02}.svg").stat().st_size > 5000
        assert (folder / f"figure-{number:02}.png").is_file()
    assert (folder / "figure-01.png").stat().st_size > 5000
    for name in ORBITS:
        for kind in ("strip", "multipliers"):
            assert (folder / f"{name.replace('/', '-')}-{kind}.svg").is_file()
    again = json.loads((folder / "results.json").read_text(encoding="utf-8"))
    proofs = {"certificates", "collisions"}
    assert again == {name: x for name, x in paper.results.items() if name not in proofs}
    for name in ("figure-01.svg", "figure-06.svg"):
        assert paper.again[name] == (folder / name).read_bytes()


def test_markdown_and_html_have_every_number(paper, results):
    for name in ("report.md", "report.html"):
        text = paper.read(name).replace("\N{NO-BREAK SPACE}", " ")
        for entry in results["comparisons"]:
            for part in ("where", "printed", "ours", "difference", "verdict"):
                assert entry[part] in text
        for finding in results["misprints"]:
            assert finding["title"].partition("$")[0] in text


def test_proofs_stand_before_the_last_chapter(paper, results, orbits):
    chapters = re.findall(r"^## (.*)$", paper.read("report.md"), re.MULTILINE)
    assert chapters[-2] == "Proofs"
    certificates = results["certificates"]
    assert certificates.keys() == orbits.keys()
    assert {f"proof of {name}" for name in certificates} <= {*paper.steps}
    proved, limit = (certificates[name] for name in ORBITS[3:])
    assert set(proved["claims"].values()) == {"proved"}
    middle = proved["trace"].partition(" +/- ")[0]
    assert abs(float(middle) - float(orbits[ORBITS[3]].trace)) < 1e-14
    assert set(limit["claims"].values()) == {"undecided"}
    assert "border collision" in limit["reasons"]["existence"]
    (collision,) = results["collisions"].values()
    assert collision["claim"] == "proved"
    with mp.workdps(60):
        middle, radius = (mp.mpf(collision["enclosures"]["e1"][k]) for k in ("mid", "rad"))
        assert abs(orbits[ORBITS[4]].unknowns["e1"] - middle) < radius + mp.mpf(10) ** -29
    assert "shrinks to zero" in paper.read("report.md")


def test_a_file_in_the_way_and_a_folder_that_cannot_be_made(tmp_path):
    file = tmp_path / "taken"
    file.write_text("mine", encoding="utf-8")
    for target in (file, file / "below"):
        assert "error: cannot write" in refused("reproduce", "--out", str(target))
    assert file.read_text(encoding="utf-8") == "mine"


@pytest.mark.parametrize("module", ["matplotlib", "jinja2", "latex2mathml", "mdit_py_plugins"])
def test_missing_extras_are_asked_for_first(module, monkeypatch, tmp_path):
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(MissingExtra, match=module):
        writing.reproduce(tmp_path / "paper", lambda orbit, section: ())
    assert list(tmp_path.iterdir()) == []
