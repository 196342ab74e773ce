"""The door to the kernels, the flows behind it, and the parameters before it."""

import functools
import os
import subprocess
import sys
from fractions import Fraction
from itertools import product

import numpy as np
import pytest
from numpy.testing import assert_allclose

from nonsmooth import InputError, NoConvergence, solve
from nonsmooth.runtime.model import kernels
from nonsmooth.runtime.model.completion import complete, complete_arrays
from nonsmooth.runtime.model.kernels import load_orbit, load_system
from tests.declared import RANGES

SYSTEM, ORBIT = "dry-friction", "dry-friction/global-stick"
MOTIONS = ("slip", "stick", "overshoot")
CONFIGURATIONS = tuple("-".join(pair) for pair in product(MOTIONS, MOTIONS))


# --- the backend


@functools.cache
def run(code, chosen):
    environment = {n: v for n, v in os.environ.items() if n != "NONSMOOTH_BACKEND"}
    if chosen is not None:
        environment["NONSMOOTH_BACKEND"] = chosen
    return subprocess.run(
        [sys.executable, "-W", "error", "-c", code],
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )


SHOW = """
from nonsmooth.runtime.model.kernels import backend, load_orbit, orbit_names
from nonsmooth.runtime.orbits.solve import solve
for name in orbit_names():
    orbit = solve(name)
    print(backend(), load_orbit(orbit.name).solver is not None, orbit.status,
          orbit.admissibility.verdict, orbit.stability.verdict, repr(orbit.trace),
          *(repr(x) for x in orbit.unknowns.values()),
          *(repr(x) for x in orbit.derivatives(one_sided=True).trace.tolist()),
          *(repr(float(x)) for x in orbit.saltations.flat),
          *(repr(float(x)) for x in orbit.motion()(1)))
"""


@pytest.mark.compiled
@pytest.mark.parametrize("chosen", [None, "c"])
def test_c_is_the_backend_when_it_is_built(chosen):
    done = run(SHOW, chosen)
    assert done.returncode == 0
    lines = [line.split() for line in done.stdout.splitlines()]
    assert [line[:2] for line in lines] == [["c", "True"]] * len(RANGES)


@pytest.mark.slow
def test_numpy_can_be_asked_for_and_does_all_that_c_does():
    plain, best = run(SHOW, "numpy"), run(SHOW, None)
    assert plain.returncode == best.returncode == 0, plain.stderr
    assert len(plain.stdout.splitlines()) == len(RANGES)
    for line, other in zip(plain.stdout.splitlines(), best.stdout.splitlines(), strict=True):
        found, expected = line.split(), other.split()
        assert found[:2] == ["numpy", "False"]
        assert found[2:5] == expected[2:5]
        numbers, others = (np.array(list(map(float, words[5:]))) for words in (found, expected))
        assert_allclose(numbers, others, rtol=1e-11, atol=1e-11)


@pytest.mark.parametrize("chosen", ["nonsense", " numpy"])
def test_another_backend_is_an_input_error(chosen):
    done = run("from nonsmooth.runtime.model.kernels import backend; backend()", chosen)
    assert done.returncode != 0
    last = done.stderr.strip().splitlines()[-1]
    assert "InputError" in last
    assert repr(chosen) in last
    assert "numpy" in last


def test_asking_for_c_that_is_not_there_names_the_remedy():
    code = (
        "import sys; sys.modules['nonsmooth.generated._kernels'] = None\n"
        "from nonsmooth.runtime.model.kernels import backend; print(backend())"
    )
    absent, asked = run(code, None), run(code, "c")
    assert absent.stdout.strip() == "numpy"
    assert "InputError" in asked.stderr
    assert "not built" in asked.stderr.strip().splitlines()[-1]
    assert "install" in asked.stderr.strip().splitlines()[-1]


# --- names


def test_names_are_listed_and_loaded():
    for name in RANGES:
        assert load_orbit(name).name == name
        assert load_orbit(name) is load_orbit(name)
    assert load_system(SYSTEM).configurations == tuple(load_system(SYSTEM).table["configurations"])
    assert set(load_system(SYSTEM).configurations) == set(CONFIGURATIONS)


@pytest.mark.parametrize("name", ["dry-frction", "Dry-Friction", "dry friction", "dry-friction/"])
def test_an_unknown_system_is_answered_with_the_nearest(name):
    with pytest.raises(InputError, match=f"unknown system '{name}'; did you mean '{SYSTEM}'"):
        load_system(name)


@pytest.mark.parametrize(
    "name", ["dry-friction/globalstick", "dry-friction", "dry-friction/global-stick/", "dry/stick"]
)
def test_an_unknown_orbit_is_answered_with_those_that_exist(name):
    with pytest.raises(InputError, match=f"unknown orbit '{name}'.*{ORBIT}") as caught:
        load_orbit(name)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("count", [6, 8])
def test_arrays_of_a_wrong_length_are_refused(count):
    with pytest.raises(ValueError, match="7"):
        load_system(SYSTEM).evaluate("fields", np.ones(count) / 2)


# --- generated files that are not what was generated


@pytest.fixture
def generated(tmp_path, monkeypatch):
    """A copy of the generated files that the door reads instead."""
    for name in ("PROVENANCE.json", "dry_friction.py"):
        source = kernels.files("nonsmooth.generated").joinpath(name)
        (tmp_path / name).write_bytes(source.read_bytes())
    monkeypatch.setattr(kernels, "files", lambda package: tmp_path)
    caches = (kernels._provenance, kernels._system, kernels._orbit)
    for cache in caches:
        cache.cache_clear()
    yield tmp_path
    for cache in caches:
        cache.cache_clear()


@pytest.mark.parametrize("text", ["", "{", "[]", "{}", '{"systems": 3, "files": {}}', None])
def test_a_cut_or_foreign_provenance_is_named_with_the_remedy(generated, text):
    path = generated / "PROVENANCE.json"
    path.unlink() if text is None else path.write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=r"PROVENANCE\.json is missing, cut or foreign: .*install"):
        load_orbit(ORBIT)


def test_an_edited_or_cut_kernel_file_is_named_with_the_remedy(generated):
    path = generated / "dry_friction.py"
    whole = path.read_bytes()
    for content in (whole + b"\n", whole[:-100], b""):
        path.write_bytes(content)
        with pytest.raises(InputError, match=r"dry_friction\.py is not the file .* regenerate"):
            load_orbit(ORBIT)


# --- flows


# --- parameters


@pytest.mark.parametrize(
    ("given", "without", "named"),
    [
        ({"e1": 3, "us1": 1, "ur1": 4.5}, (), r"e1 = 3 contradicts ur1 - us1 = 3\.5"),
        ({"e2": "0.3", "us2": 0.1, "ur2": 0.3}, (), "e2 = 0.3 contradicts"),
        ({"us1": 1, "ur1": 0.5}, (), r"e1 = ur1 - us1 is -0\.5"),
        ({"ur1": 1}, (), "us1 = -4039/2000 is outside its domain"),
        ({"us1": 0}, (), r"us1 = 0 is outside its domain \(0, oo\)"),
        ({"ur2": -1}, (), "ur2|us2"),
        ({"chi": 0}, (), r"chi = 0 is outside its domain \(0, 1\)"),
        ({"chi": 1}, (), "chi = 1 is outside"),
        ({"chi": "1 - 1e-300"}, (), "chi"),
        ({"eta": -1}, (), r"eta = -1 is outside its domain \(0, oo\)"),
        ({"eta": 0.0}, (), "eta = 0.0 is outside"),
        ({"V": "0"}, (), "V = 0 is outside"),
        ({"e1": -1e-300}, (), r"e1 = -1e-300 is outside its domain \[0, oo\)"),
        ({"V": float("nan")}, (), "parameter V: .*not finite"),
        ({"V": float("-inf")}, (), "parameter V: .*not finite"),
        ({"V": "1/0"}, (), "parameter V: '1/0'.*zero"),
        ({"V": "__import__('os')"}, (), "parameter V"),
        ({"V": True}, (), "parameter V: True"),
        ({"V": None}, (), "parameter V: None"),
        ({"V": 1j}, (), "parameter V"),
        ({"V": [1.0]}, (), "parameter V"),
        ({"v": 1}, (), "unknown parameter 'v'; did you mean 'V'"),
        ({"u1": 1}, (), "did you mean 'u[rs]1'"),
        ({"ta": 1}, (), "unknown parameter 'ta'.*known: chi, eta, V, e1, e2, us1, us2, ur1, ur2"),
        ({3: 1}, (), "unknown parameter '3'"),
        ({"e1": 3}, ("e1",), "e1 is both given and to be solved for"),
        ({"us1": 1, "ur1": 4}, ("e1",), "e1 is to be solved for, but ur1, us1 fix it"),
        ({"ur1": 4}, ("e1",), "ur1 decides nothing while e1 is to be solved for: give us1"),
    ],
    ids=lambda value: str(value)[:40],
)
def test_wrong_parameters_are_named_on_one_line(given, without, named):
    with pytest.raises(InputError, match=named) as caught:
        complete(load_orbit(ORBIT), given, without)
    assert "\n" not in str(caught.value)


RIGID, ELASTIC = "rigid-stop/one-impact", "elastic-stop/one-contact"
POSITIVE = {  # what is not, by parameters of both orbits, or of one
    "m1 m2 k1 k2 T": ((RIGID, ELASTIC), ["0", -1, float("nan"), "1e400", True]),
    "k3": ((ELASTIC,), ["0", 0, -3, "1/0", "-1e-300"]),
    "r": ((RIGID,), ["-1e-300", "1 + 1e-15", "1.2", -1, "inf"]),
}


@pytest.mark.parametrize(
    ("name", "parameter", "value"),
    [
        (name, parameter, value)
        for parameters, (names, values) in POSITIVE.items()
        for name, parameter, value in product(names, parameters.split(), values)
    ],
)
def test_a_stop_takes_positive_numbers_and_a_restitution_up_to_one(name, parameter, value):
    with pytest.raises(InputError, match=parameter) as caught:
        complete(load_orbit(name), {parameter: value})
    assert "\n" not in str(caught.value)


def test_restitution_that_loses_energy_has_no_orbit():
    for value in ("0", 0, 0.5, "1 - 1e-15", "1/3"):
        with pytest.raises(NoConvergence, match="exists only for r = 1: with r = ") as caught:
            complete(load_orbit(RIGID), {"r": value})
        assert "\n" not in str(caught.value)
    for value in (1, "1", 1.0, "3/3", Fraction(1)):  # it may be said
        assert list(complete(load_orbit(RIGID), {"r": value}).values) == [
            "m1",
            "m2",
            "k1",
            "k2",
            "T",
        ]


def test_forces_without_influence_are_checked_and_kept():
    door = load_orbit("dry-friction/symmetric")
    plain = complete(door, {})
    for given in ({"us1": 1}, {"ur1": 2}, {"e1": 3}, {"us1": 1, "ur1": 2, "e1": 1}):
        point = complete(door, given)
        assert point.values == plain.values
        kept = {name: float(value) for name, value in point.opened.items()}
        assert kept == {
            name: value for name, value in given.items() if len(given) < 3 or name != "e1"
        }
    for given, part in (
        ({"us1": 0}, "us1 = 0 is outside its domain"),
        ({"ur1": -1}, "ur1 = -1 is outside its domain"),
        ({"e1": -1}, "e1 = -1 is outside its domain"),
        ({"us1": 2, "ur1": 1}, "e1 = ur1 - us1 is -1.0"),
        ({"us1": 1, "ur1": 2, "e1": 3}, "e1 = 3 contradicts ur1 - us1"),
        ({"us3": 1}, "unknown parameter 'us3'"),
    ):
        with pytest.raises(InputError, match=part):
            complete(door, given)


@pytest.mark.parametrize(
    ("given", "named"),
    [
        ({"e1": 3}, r"e1 is an unknown of dry-friction/solution-ii: .*--given e1=3\)"),
        ({"us1": 1, "ur1": 3}, "e1 is to be solved for, but ur1, us1 fix it"),
        ({"ur1": 3}, "ur1 decides nothing while e1 is to be solved for: give us1 instead"),
        ({"ta": 0}, "unknown parameter 'ta'"),
    ],
)
def test_what_a_border_collision_solves_for_is_not_given(given, named):
    with pytest.raises(InputError, match=named):
        complete(load_orbit("dry-friction/solution-ii"), given)


def test_a_force_given_beside_an_exchange_decides():
    for us2, verdict in ((0.5, False), (2, True)):
        orbit = solve(
            ORBIT,
            {"us1": 1, "us2": us2},
            unknown=("e1", "e2"),
            given={"ta": 1, "tau": 2},
        )
        assert orbit.admissibility.verdict is verdict


@pytest.mark.parametrize("name", RANGES)
def test_every_orbit_has_defaults_and_a_guess(name):
    door = load_orbit(name)
    point = complete(door, {})
    assert tuple(point.values) == door.parameter_names
    assert {n: v.text for n, v in point.values.items()} == door.table["reference"]["parameters"]
    assert set(door.table["reference"]["guess"]) == set(door.unknowns)
    assert tuple(complete_arrays(door, {})) == door.parameter_names
    tables = (*door.parameters, *door.open_parameters, *door.other_parameters)
    assert len({p.name for p in tables}) == len(tables)
    assert {p.name for p in door.system.parameters} <= {p.name for p in tables}
