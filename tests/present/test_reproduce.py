"""The reproduction of the source paper: files, numbers by other routes, bad input."""

from __future__ import annotations

import json
import re
import sys
from decimal import Decimal
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mpmath import mp
from scipy.linalg import expm

from nonsmooth import MissingExtra, solve
from nonsmooth.runtime.present.paper import writing
from nonsmooth.runtime.present.paper.chapters import ORBITS, paper_orbits, paper_report
from nonsmooth.runtime.present.paper.comparing import AGREES, compared
from nonsmooth.runtime.present.paper.contact import contact_orbits
from nonsmooth.runtime.present.paper.figures import drawings
from nonsmooth.runtime.present.paper.misprints import misprints
from nonsmooth.runtime.present.paper.writers import to_json
from tests.browser import inspect_page
from tests.cli.test_cli import run, told

DATA = {"m1": 1.0, "m2": 2.0, "k1": 1.0, "k2": 5.0, "k3": 1.0, "T": 2 * np.pi}


@pytest.fixture(scope="module")
def orbits() -> dict[str, Any]:
    return paper_orbits(lambda step: None)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What the command writes."""
    found = tmp_path_factory.mktemp("paper") / "new" / "folder"
    answer = told("reproduce", "--out", str(found))
    assert {Path(path) for path in answer["files"]} == set(found.iterdir())
    return found


@pytest.fixture(scope="module")
def results(folder: Path) -> dict[str, Any]:
    return json.loads((folder / "results.json").read_text(encoding="utf-8"))


def test_every_figure_of_the_paper_is_drawn(folder: Path) -> None:
    for number in range(1, 12):
        for ending in ("svg", "png"):
            assert (folder / f"figure-{number:02}.{ending}").stat().st_size > 5000
    for name in ORBITS:
        for kind in ("strip", "multipliers"):
            assert (folder / f"{name.replace('/', '-')}-{kind}.svg").is_file()


def test_figures_show_the_spans_of_the_paper(orbits: dict[str, Any]) -> None:
    drawn = drawings({name: orbits[name] for name in ORBITS})
    for number, name, mass, periods in (
        *((2, ORBITS[0], "x_{1}", 2), (3, ORBITS[0], "x_{2}", 2)),
        *((4, ORBITS[1], "x_{1}", 1), (5, ORBITS[1], "x_{2}", 1)),
    ):
        (axes,) = drawn[f"figure-{number:02}"].draw().axes
        period = float(orbits[name].period)
        np.testing.assert_allclose(axes.get_xlim(), (0, periods * period), rtol=1e-12)
        assert mass in axes.get_ylabel()
        assert axes.get_xlabel() == "time $t$"  # the paper has units there


def test_every_printed_number_stands_beside_ours(results: dict[str, Any]) -> None:
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
            assert entry["verdict"] == AGREES
            places = len(entry["printed"].partition(".")[2])
            assert abs(difference) <= Decimal(5).scaleb(-places - 1)


def test_numbers_of_the_report_solve_the_equations_at_50_digits(results: dict[str, Any]) -> None:
    """The rigid orbit by mpmath's matrix exponential."""
    found = results["orbits"]["rigid-stop/one-impact"]["unknowns"]
    with mp.workdps(50):
        matrix = mp.matrix(4, 4)
        matrix[0, 2] = matrix[1, 3] = 1
        matrix[2, 0], matrix[2, 1], matrix[3, 0], matrix[3, 1] = -1, 1, mp.mpf(1) / 2, -3
        start = mp.matrix([1, mp.mpf(found["y"]), mp.mpf(found["u"]), 0])
        end = mp.expm(matrix * 2 * mp.pi, method="taylor") * start
        end[2] = -end[2]
        assert max(abs(a - b) for a, b in zip(start, end, strict=True)) < mp.mpf(10) ** -29


def test_misprints_are_shown_and_not_asserted(orbits: dict[str, Any]) -> None:
    wrong = misprints(*(orbits[name] for name in ORBITS[:4]))
    assert [finding.verdict for finding in wrong] == ["misprint"] * 9
    # of another orbit's data the printed digits are none: nothing is written down beforehand
    other = solve("dry-friction/symmetric", {"V": "0.68", "e2": "0.501"})
    moved = misprints(orbits[ORBITS[0]], orbits[ORBITS[1]], other, orbits[ORBITS[3]])
    assert moved[-1].table.rows != wrong[-1].table.rows


def test_contact_orbits_agree_with_the_kernels_and_with_expm() -> None:
    (found,) = contact_orbits(DATA, DATA["k1"] + DATA["k2"])
    unknowns = solve("elastic-stop/one-contact").unknowns
    for name, value in unknowns.items():
        assert getattr(found, name) == pytest.approx(value, abs=1e-9)
    stiffness = np.array([[2.0, -1.0], [-1.0, 6.0]])
    matrix = np.block([[np.zeros((2, 2)), np.eye(2)], [-stiffness / [[1], [2]], np.zeros((2, 2))]])
    centre = np.append(np.linalg.solve(stiffness, [1.0, 0.0]), [0.0, 0.0])
    middle = expm(matrix * found.tau / 2) @ ([1, found.y, found.u, found.w] - centre)
    np.testing.assert_allclose(middle[2:], 0, atol=1e-8)
    printed = contact_orbits(DATA, DATA["k1"] + DATA["k3"])
    assert printed
    assert not any(orbit.admissible for orbit in printed)


def test_claims_hold(results: dict[str, Any]) -> None:
    limit, portraits, criterion = results["claims"]
    assert [claim["verdict"] for claim in results["claims"]] == ["holds"] * 3
    scaled = [float(row[2]) for row in limit["table"]["rows"]]
    assert abs(scaled[-1] / scaled[-2] - 1) < 1e-3
    assert "unstable" in portraits["evidence"]
    assert "stable" in criterion["evidence"]


def test_results_are_the_same_bytes_again(orbits: dict[str, Any], folder: Path) -> None:
    drawn = drawings({name: orbits[name] for name in ORBITS})
    pictures = {stem: drawing.picture for stem, drawing in drawn.items()}
    again = paper_report(paper_orbits(lambda step: None), pictures, lambda name, section: ())
    assert to_json(again) == (folder / "results.json").read_text(encoding="utf-8")


@pytest.mark.browser
@pytest.mark.parametrize("width", [1280, 390])
def test_report_in_a_browser(folder: Path, width: int) -> None:
    facts = inspect_page(folder / "report.html", width)
    assert facts.messages == ()
    assert facts.requests == ()
    assert facts.scroll_width <= facts.width == width
    assert facts.wide == ()
    assert facts.chapters == (
        *("rigid-stop", "elastic-stop", "symmetric", "global-stick", "solution-ii"),
        *("poincare-map", "misprints"),
    )


def test_markdown_and_html_have_every_number(folder: Path, results: dict[str, Any]) -> None:
    for name in ("report.md", "report.html"):
        text = (folder / name).read_text(encoding="utf-8")
        for entry in results["comparisons"]:
            assert entry["ours"] in text
        for finding in results["misprints"]:
            assert finding["title"].partition("$")[0] in text


def test_a_file_in_the_way_and_a_folder_that_cannot_be_made(tmp_path: Path) -> None:
    file = tmp_path / "taken"
    file.write_text("mine", encoding="utf-8")
    for target in (file, file / "below"):
        code, out, err = run("reproduce", "--out", str(target))
        assert (code, out) == (2, "")
        assert err.startswith("nonsmooth: error: cannot write")
    assert file.read_text(encoding="utf-8") == "mine"


@pytest.mark.parametrize("module", ["matplotlib", "jinja2", "latex2mathml"])
def test_missing_extras_are_asked_for_first(
    module: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(MissingExtra, match=module):
        writing.reproduce(tmp_path / "paper", lambda orbit, section: ())
    assert list(tmp_path.iterdir()) == []


def test_integers_are_meant_exactly(orbits: dict[str, Any]) -> None:
    (found,) = compared(orbits[ORBITS[3]], "Sec. 3.3", {"tau": "2"}, {"tau": r"\tau"})
    assert found.verdict == "agrees within 0.04 %"
