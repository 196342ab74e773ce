"""`nonsmooth fit`: its answer, its files, and one line for what is wrong."""

import shlex
import shutil
from pathlib import Path

import numpy as np
import pytest

import nonsmooth as ns
from tests.cli import test_cli
from tests.places import GALLERY

KNOWN = "c=0.05 h=0.2 w=2.1"
FIT = f"fit identification.py impacts.csv {KNOWN} k=2.3:2.7 r=0.7:1 --from x=-0.6,v=0.1"
TRUTH = {"c": 0.05, "h": 0.2, "w": 2.1, "k": 2.5, "r": 0.8}


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    for name in ("identification.py", "impacts.csv"):
        shutil.copy(GALLERY / name, tmp_path)
    monkeypatch.setenv("NONSMOOTH_CACHE", str(tmp_path / "cache"))
    monkeypatch.chdir(tmp_path)


def told(command):
    return test_cli.told(*shlex.split(command))


def test_an_error_that_is_not_known_is_null():
    """A parameter that ends at its bound has no standard error."""
    found = told(f"fit identification.py impacts.csv {KNOWN} k=2.6:2.7 r=0.7:1"
                 " --from x=-0.6,v=0.1 --save fit.json")  # fmt: skip
    assert found["standard_errors"][0] is None
    assert float(found["standard_errors"][1]) > 0
    # the file keeps what the record holds, and gives the same answer
    kept = ns.load("fit.json")
    assert {*found["estimates"]} <= {*map(repr, kept.estimates.tolist())}
    assert np.isnan(kept.standard_errors[0])
    assert kept.to_json()["standard_errors"] == found["standard_errors"]


@pytest.mark.slow
def test_the_answer_holds_the_truth_and_is_kept():
    pytest.importorskip("matplotlib")
    found = told(f"{FIT} --starts 3 --seed 1 --save fit.json --plot fit.png")
    assert found["files"] == ["fit.json", "fit.png"]
    for name, low, high in zip(found["names"], found["lower"], found["upper"], strict=True):
        assert float(low) < TRUTH[name] < float(high)
    assert found["same_sequence"] is True
    kept = ns.load("fit.json")
    assert [repr(x) for x in kept.estimates.tolist()] == found["estimates"]
    again = kept.to_json()
    assert {n: x for n, x in again.items() if n != "system"} == {
        n: x for n, x in found.items() if n not in ("system", "files")
    }
    assert kept.motion().boundaries[1] == ("wall-reaches-stop",)
    shown = test_cli.answered(*shlex.split(FIT))
    assert "events in the order of the data" in shown
    assert "standard errors away" in shown


def test_a_fit_is_loaded_without_its_declaration():
    told(f"{FIT} --save fit.json")
    Path("identification.py").unlink()
    kept = ns.load("fit.json")
    fitted = kept.experiments[0].series[0].fitted
    np.testing.assert_allclose(kept.motion().times[1:13], fitted, rtol=1e-12)


def test_several_files_know_parameters_of_their_own():
    for number, w in enumerate((2.1, 2.6)):
        times = np.linspace(0.1, 9, 50)
        motion = ns.simulate("identification.py", TRUTH | {"w": w}, {"x": -0.6, "v": 0.1}, until=9)
        rows = [
            f"{t!r},{2 * x!r}"
            for t, x in zip(times.tolist(), motion(times)[:, 0].tolist(), strict=True)
        ]
        Path(f"{number}.csv").write_text("\n".join(["t,double", *rows]))
    found = told(
        "fit identification.py 0.csv:w=2.1 1.csv:w=2.6 c=0.05 h=0.2 k=2.3:2.45:2.7 r=0.5:0.78:1"
        " --outputs double=2*x --sigma double=0.001 --prior k=2.6+-10 --from x=-0.6,v=0.1"
    )
    assert [float(x) for x in found["estimates"]] == pytest.approx([2.5, 0.8], abs=1e-7)
    assert [each["parameters"]["w"] for each in found["experiments"]] == ["2.1", "2.6"]
    assert found["priors"] == {"k": ["2.6", "10.0"]}


@pytest.mark.parametrize(
    "change",
    [
        ("wall-reaches-stop", "t", "--events wall"),
        ("wall-reaches-stop", "wall", "--events wall"),
        ("wall-reaches-stop", "hits", "--events hits=wall-reaches-stop"),
    ],
)
def test_columns_of_events_by_other_names(change):
    old, new, option = change
    text = Path("impacts.csv").read_text()
    expected = told(FIT)["estimates"]
    Path("impacts.csv").write_text(text.replace(old, new))
    assert told(f"{FIT} {option}")["estimates"] == expected


@pytest.mark.slow
def test_steady_responses_from_a_file():
    """Without an impact the amplitude is 1 / |k - w^2 + i c w|."""
    pytest.importorskip("matplotlib")
    amplitude = [1 / abs(2.5 - w**2 + 0.05j * w) for w in (3.0, 4.0)]
    rows = [f"{w},{a!r}" for w, a in zip((3.0, 4.0), amplitude, strict=True)]
    Path("sweep.csv").write_text("\n".join(["w,A", *rows]))
    command = "fit identification.py sweep.csv c=0.05 h=0.2 r=0.8 k=2.4:2.49:2.6 --sigma 0.001"
    command += " --responses A=amplitude:x"
    found = told(f"{command} --save fit.json --plot fit.png")
    assert float(found["estimates"][0]) == pytest.approx(2.5, abs=1e-8)
    responses = found["experiments"][0]["responses"]
    assert [each["parameters"]["w"] for each in responses] == ["3.0", "4.0"]
    kept = ns.load("fit.json")
    assert float(kept.response(1).parameters["w"]) == 4.0
    assert "2 steady responses" in test_cli.answered(*shlex.split(command))
