"""The commands that simulate: answers, JSON, files, and one clear line for wrong input."""

import sys

import numpy as np
import pytest

import nonsmooth
from nonsmooth import find_orbits, simulate
from tests.cli.test_cli import answered, refused_alike, run, told

A = "chi=0.5 eta=1 V=1 us1=1 us2=1 ur1=4.0195 ur2=1.4831"
B = "chi=0.4 eta=4 V=0.6773 us1=0.0127 ur1=0.0255 us2=0.5 ur2=1"
STOP = "m1=1 m2=2 k1=1 k2=5 r=0.8"
ZERO = "--from x1=0,x2=0,v1=0,v2=0"
SIMULATE = f"simulate rigid-stop {STOP} --from x1=0,x2=0.5,v1=1,v2=0 --transitions 6"
FRICTION = f"simulate dry-friction {A} {ZERO} --transitions 12"
FIND = f"find dry-friction {B} --starts 12 --transitions 400"
SWEPT = "sweep dry-friction chi=0.5 eta=1 us1=1 us2=1 ur1=4.0195 ur2=1.4831"
SWEEP = f"{SWEPT} V=0.95:1.05:3 --quantity x1 --at slip-stick {ZERO} --transient 50 --samples 12"


def values(text):
    return dict(part.split("=") for part in text.split())


# --- simulate


def test_json_of_simulate_is_the_motion(backend):
    found = told(*FRICTION.split())
    motion = simulate("dry-friction", values(A), [0, 0, 0, 0], transitions=12)
    # one entry for the start and one behind each transition, every digit in a decimal string
    assert [float(t) for t in found["times"]] == motion.times.tolist()
    assert [[float(x) for x in row] for row in found["states"]] == motion.states.tolist()
    assert tuple(found["configurations"]) == motion.configurations
    assert tuple(map(tuple, found["boundaries"])) == motion.boundaries
    assert (found["names"], found["parameters"]) == (["x1", "x2", "v1", "v2"], values(A))
    assert float(found["end"]) == motion.end


def test_what_people_are_shown():
    out = answered(*SIMULATE.split())
    assert "rigid-stop, 6 transitions" in out
    assert out.count("first-reaches-stop") == 6
    assert "as many transitions as were asked for" in out
    many = run(*SIMULATE.replace("--transitions 6", "--transitions 100").split())[1]
    assert "61 more" in many
    assert max(map(len, many.splitlines())) <= 118


def test_a_time_may_be_an_expression():
    found = told(*SIMULATE.replace("--transitions 6", "--until 2*pi").split())
    assert float(found["end"]) == 2 * np.pi
    assert found["status"] == "until"


def test_observe():
    found = told(*FRICTION.split(), "--observe")["observables"]
    assert sum(float(share) for share in found["fractions"].values()) == pytest.approx(1)
    later = told(*FRICTION.split(), "--observe", "--since", "10/3")["observables"]
    assert float(later["since"]) == 10 / 3
    assert float(later["duration"]) == pytest.approx(float(found["duration"]) - 10 / 3)
    out = answered(*FRICTION.split(), "--observe")
    assert "no Lyapunov exponent: from t = 0 to" in out
    assert found["lyapunov"] is None


def test_observe_tells_the_largest_exponent_with_its_error():
    motion = "simulate docs/gallery/impact_oscillator.py sigma=0.2 w=3.7 r=0.8 --from x=0,v=1"
    options = (*motion.split(), "--transitions", "500", "--observe", "--since", "100")
    found = told(*options)["observables"]
    assert float(found["lyapunov"]) == pytest.approx(-0.0657016, abs=1e-7)
    assert 0 < float(found["lyapunov_error"]) < 1e-3
    assert "largest Lyapunov exponent: -0.0657016, error " in run(*options)[1]


def test_unwritable_files(tmp_path, monkeypatch):
    monkeypatch.setattr("os.access", lambda path, mode: False)
    for command in (f"{SIMULATE} --save m.npz", f"{FIND} --save f.json", f"{SWEEP} --plot s.png"):
        assert "permission denied" in refused_alike(*command.split())


@pytest.mark.parametrize(
    "command", [SIMULATE + " --plot", SWEEP + " --plot", "plot orbit.json --out"]
)
def test_without_matplotlib_the_extra_is_named(command, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    nonsmooth.solve("dry-friction/symmetric").save("orbit.json")
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    error = refused_alike(*command.split(), f"{tmp_path}/picture.png")
    assert 'pip install "nonsmooth[plot]"' in error


# --- find


@pytest.fixture(scope="module")
def found():
    return find_orbits("dry-friction", values(B), 12, transitions=400)


@pytest.mark.slow
@pytest.mark.compiled
def test_find_shows_and_saves_and_chart_maps(found, tmp_path):
    pytest.importorskip("zarr")
    kept, store = tmp_path / "found.json", tmp_path / "basins.zarr"
    code, out, err = run(*FIND.split(), "--save", str(kept))
    assert code == 0
    assert f"{kept} written\n" in out
    assert f"take {kept}:1 and so on" in out
    assert f"{len(found.orbits)} periodic orbits and 1 equilibrium from 12 starts" in out
    assert "unstable" in out
    assert "Traceback" not in err
    np.testing.assert_array_equal(nonsmooth.load(kept).labels, found.labels)
    words = ("x1=-2:2:6", "v2=-1:0.5:4", "--from", "x2=1/2", "--out", str(store))
    assert told("chart", str(kept), *words)["dimensions"] == {"x1": 6, "v2": 4}


@pytest.mark.slow
@pytest.mark.compiled
def test_seed_and_box_reach_the_search(found):
    document = told(*f"{FIND} --seed 3 x1=0:1/2 v2=-1:0".split())
    assert document["box"]["x1"] == ["0.0", "0.5"]
    assert document["box"]["v2"] == ["-1.0", "0.0"]
    assert [float(x) for x in document["box"]["x2"]] == pytest.approx(found.box[1])


# --- sweep


def test_a_diagram(tmp_path):
    pytest.importorskip("matplotlib")
    target = tmp_path / "diagram.PDF"
    code, out, _ = run(*SWEEP.split(), "--plot", str(target))
    assert code == 0
    assert "x1 of dry-friction at each entry of slip-stick, over V" in out
    assert "V: 0.95 ... 1.05, 3 of 3 values done; 9 points" in out
    assert out.endswith(f"{target} written\n")
    assert target.read_bytes().startswith(b"%PDF")


def test_a_diagram_may_go_downward():
    downward = told(*SWEEP.replace("0.95:1.05", "1.05:0.95").split(), "--restart")
    assert [float(v) for v in downward["values"]] == pytest.approx([1.05, 1.0, 0.95])
