"""Whatever is passed to a public function or method, the answer is a result or one clear line."""

import inspect
import json
import pickle
import tempfile
from decimal import Decimal
from fractions import Fraction
from functools import cache
from pathlib import Path

import mpmath
import numpy as np
import pytest
import sympy as sp
from numpy.testing import assert_array_equal

import nonsmooth as ns
from nonsmooth.runtime.core.values import parse
from tests.places import records
from tests.tables import slow
from tests.two_masses import STICKING

STICK = "dry-friction/global-stick"
DATA = {name: str(value) for name, value in STICKING.items()}
START = [5, 4, 0.5, 0.25]
TIMES = [0.1, 0.2, 0.3]
LONGEST = 300
SLOW = ("certify.all", "certify.branch", "branch", "design", "find_orbits", "fit")
LONG = ("certify.basin", "certify.doubling", "certify.region")  # tried with what never fits alone
POSSIBLE = (None, True, 5, 2.5, "x", [], {}, float("nan"), {"x": 1})
# what is given where an argument has to be, or would take long by default
RIGHT = {
    "attempts": lambda: 1,
    "branch": lambda: result("branch"),
    "branch.orbit_at.place": lambda: 0,
    "branch.quantity.name": lambda: "period",
    "branch.next_itineraries.event": lambda: result("branch").events[0],
    "by": lambda: ["V"],
    "certify.all.box": lambda: {"tau": 1, "tau1": 1},
    "certify.all.orbit": lambda: STICK,
    "certify.box.box": lambda: {"V": (0.999, 1.001)},
    "certify.chaos.parameters": lambda: {**DATA, "ur1": 1, "ur2": 1},
    "certify.check.path": lambda: saved("certificate"),
    "certify.motion.configuration": lambda: "slip-slip",
    "certify.region.boxes": lambda: 64,
    "certify.region.region": lambda: {"x2": (2, 13)},
    "certify.doubling.tiles": lambda: 1,
    "chart.start": None,
    "chart.transitions": None,
    "chart.V": lambda: [1, 1.01],
    "chart.orbit": lambda: STICK,
    "changes.direction": lambda: {"V": 1},
    "changes.since": lambda: 0.0,
    "cotangent": lambda: [1.0],
    "data": lambda: {"t": TIMES, "x1": result("motion")(TIMES)[:, 0]},
    "derivatives.local_extremes.name": lambda: "maximum:x1",
    "derivatives.quantity.name": lambda: "period",
    "design.over": lambda: {"V": (0.999, 1.001)},
    "differentiate": lambda: result("function").differentiate,
    "refine.digits": lambda: 20,
    "direction": lambda: [1.0],
    "evaluate": lambda: result("function").evaluate,
    "continue_orbit.event": None,
    "event": lambda: next(e for e in result("branch").events if e.kind == "flip"),
    "fit.bounds": lambda: {"eta": (0.5, 1.5)},
    "fit.parameters": lambda: {name: value for name, value in DATA.items() if name != "eta"},
    "lyapunov.trajectory": lambda: ns.simulate("dry-friction", DATA, START, until=1000),
    "fit.start": lambda: dict(zip(("x1", "x2", "v1", "v2"), START, strict=True)),
    "Experiment.start": None,
    "certify.branch.branch": lambda: ns.continue_orbit(ns.solve(STICK), "V", (0.99, 1.01)),
    "certify.doubling.interval": None,
    "inputs": lambda: ("V",),
    "interval": lambda: (0.999, 1.001),
    "iterations": lambda: 1,
    "minimise": lambda: "spectral_radius",
    "motion.save.path": lambda: saved("orbit").replace(".json", ".npz"),
    "motions.at.places": lambda: 0,
    "n": lambda: 1,
    "observables.name": lambda: next(iter(result("observables").contacts)),
    "of": lambda: "period",
    "orbit": lambda: result("orbit"),
    "outcome": lambda: next(iter(result("found").outcomes)),
    "DifferentiableFunction.outputs": lambda: ("period",),
    "parameter": lambda: "V",
    "parameters": lambda: DATA,
    "path": lambda: saved("orbit"),
    "point": lambda: {"V": 1},
    "points": lambda: 3,
    "reference": lambda: result("function").reference,
    "samples": lambda: 1,
    "function.check_shape.shape": lambda: (1,),
    "motions.reshaped.shape": lambda: (1, 2),
    "orbit.evaluate.quantities": lambda: ("trace",),
    "section": lambda: ("slip-slip", "first-reaches-belt", "stick-slip"),
    "start": lambda: START,
    "state": lambda: START,
    "status": lambda: 0,
    "solve.orbit": lambda: STICK,
    "solve.parameters": None,
    "sweep.name": lambda: "V",
    "sweep.parameters": lambda: {name: value for name, value in DATA.items() if name != "V"},
    "sweep.start": lambda: dict.fromkeys(("x1", "x2", "v1", "v2"), 0),
    "sweep.state": lambda: "x1",
    "sweep.configuration": lambda: "stick-stick",
    "system": lambda: "dry-friction",
    "tile": lambda: result("box").tiles[0],
    "tiles": lambda: 2,
    "times": lambda: TIMES,
    "trajectory": lambda: result("motion"),
    "transient": lambda: 1,
    "transitions": lambda: 20,
    "values": lambda: [1, 1.01],
    "x": lambda: [1.0],
}
RESULTS = {
    "orbit": lambda: ns.solve(STICK, DATA),
    "orbits": lambda: ns.solve(STICK, {"eta": [1, 1.01]}),
    "derivatives": lambda: result("orbit").derivatives(["V"]),
    "cycle": lambda: result("orbit").motion(),
    "motion": lambda: ns.simulate("dry-friction", DATA, START, transitions=60),
    "motions": lambda: ns.simulate("dry-friction", DATA, [START, START], transitions=3),
    "changes": lambda: result("motion").derivatives(["V"], times=TIMES),
    "observables": lambda: ns.observe(result("motion")),
    "function": lambda: ns.orbit_function(result("orbit"), by="V", of="period"),
    "map": lambda: ns.poincare_map("dry-friction", DATA, RIGHT["section"]()),
    "branch": lambda: ns.continue_orbit(ns.solve("dry-friction/symmetric"), "V", (0.6, 1.3)),
    "found": lambda: ns.find_orbits("dry-friction", DATA, 1, transitions=20),
    "certificate": lambda: ns.certify(result("orbit")),
    "box": lambda: ns.certify.box(result("orbit"), {"V": ("0.999", "1.001")}, tiles=1),
}


@pytest.fixture(autouse=True)
def own_folder(tmp_path, monkeypatch):
    """Some calls are right, and write files."""
    monkeypatch.chdir(tmp_path)


@cache
def result(kind):
    return RESULTS[kind]()


@cache
def saved(kind):
    path = Path(tempfile.mkdtemp()) / f"{kind}.json"
    result(kind).save(path)
    return str(path)


def functions():
    """Public functions, and `certify` with its methods."""
    named = {name: getattr(ns, name) for name in ns.__all__}
    own = {name: getattr(ns.certify, name) for name in dir(ns.certify) if name[0] != "_"}
    found = named | {f"certify.{name}": method for name, method in own.items()}
    return {name: f for name, f in found.items() if callable(f) and not is_error(f)}


def is_error(given):
    return isinstance(given, type) and issubclass(given, BaseException)


FUNCTIONS = functions()


def right(label, function):
    """Arguments with which a function answers, by the most special entry for each of them."""
    found = {}
    for name, parameter in inspect.signature(function).parameters.items():
        name = "V" if parameter.kind is parameter.VAR_KEYWORD else name
        keys = [f"{label}.{name}", f"{label.partition('.')[0]}.{name}", name]
        place = next((RIGHT[key] for key in keys if key in RIGHT), None)
        if place is not None:
            found[name] = place()
    return found


def call(function, given):
    """Call a function; what it takes as ``*name`` is given as one argument, or as a tuple."""
    several = ()
    for name, parameter in inspect.signature(function).parameters.items():
        if parameter.kind is parameter.VAR_POSITIONAL:
            several = given.pop(name)
    function(*(several if isinstance(several, tuple) else (several,)), **given)


def refusal(function, given):
    """What a function says to its arguments; nothing if it answers, or as its docstring tells."""
    try:
        call(function, given)
    except ns.NonsmoothError as problem:
        return str(problem)
    except Exception as problem:
        if type(problem).__name__ not in (inspect.getdoc(function) or ""):
            raise
    return ""


def check(label, function):
    """Call a function with each argument wrong: each call is answered or refused in one line.

    A value that can be no answer to what is asked is told by the name of the argument.
    """
    usual = right(label, function)
    possible = () if label in LONG else POSSIBLE
    if possible:
        call(function, {**usual})
    for name, parameter in inspect.signature(function).parameters.items():
        for wrong in () if parameter.kind is parameter.VAR_KEYWORD else (*possible, *never_right()):
            if wrong is usual.get(name, usual):
                continue  # right, and a proof of seconds
            told = refusal(function, {**usual, name: wrong})
            case = f"{label}({name}={type(wrong).__name__}): {told}"
            assert not told or told.isprintable(), case
            assert len(told) <= LONGEST, case
            if told and not any(wrong is other for other in POSSIBLE):
                assert name in told or name.rstrip("s") in told, case


def never_right():
    """Values that no argument takes, but those whose names say so."""
    return [object(), ns.InputError("x"), [[]], result("orbit"), result("certificate")]


def marked(names):
    return [slow(n) if n in SLOW else n for n in names]


@pytest.mark.parametrize("name", marked(FUNCTIONS))
def test_functions_answer_or_refuse_in_one_line(name):
    check(name, FUNCTIONS[name])


@pytest.mark.parametrize("kind", marked(RESULTS))
def test_methods_answer_or_refuse_in_one_line(kind):
    found = result(kind)
    for name in (n for n in dir(type(found)) if not n.startswith("_") or n == "__call__"):
        if inspect.isfunction(inspect.getattr_static(type(found), name)):
            check(f"{kind}.{name}", getattr(found, name))


@pytest.mark.parametrize("record", records().values(), ids=records())
def test_methods_of_every_result_are_checked(record):
    for name, method in vars(record).items():
        if inspect.isfunction(method) and not name.startswith("_"):
            told = {kind for place, kind in method.__annotations__.items() if place != "return"}
            assert told <= {"Any", "object"} or hasattr(method, "__wrapped__"), name


@pytest.mark.parametrize("name", [name for name in FUNCTIONS if name != "certify"])
def test_functions_travel_between_processes(name):
    assert pickle.loads(pickle.dumps(FUNCTIONS[name])) is FUNCTIONS[name]


@pytest.mark.parametrize("kind", [Fraction, Decimal, sp.Rational, mpmath.mpf, np.float32, np.array])
def test_any_kind_of_number_is_the_number(kind):
    orbit, step = ns.solve(STICK), kind(0.125)
    ends = ns.continue_orbit(orbit, "V", (0.9, 1.1), step=step).parameter_values
    assert_array_equal(ends, ns.continue_orbit(orbit, "V", (0.9, 1.1), step=0.125).parameter_values)


@pytest.mark.parametrize("kind", [str, Fraction, Decimal, sp.Rational, mpmath.mpf])
def test_arrays_of_any_kind_of_number_are_these_numbers(kind):
    values = [kind("1.25"), kind("1")]
    for given in (values, np.array(values), np.ma.array(values, mask=False)):
        found = ns.solve(STICK, DATA | {"eta": given})
        assert_array_equal(found.period, ns.solve(STICK, DATA | {"eta": [1.25, 1]}).period)
    motion = ns.simulate("dry-friction", DATA, [kind("5"), 4, 0.5, 0.25], until=[kind("1.5")])
    assert_array_equal(motion.last_times, 1.5)


@pytest.mark.parametrize("number", [sp.pi / 3, "pi/3"])
def test_irrational_numbers_may_stand_alone_or_in_arrays(number):
    orbit = ns.solve(STICK, DATA | {"eta": number})
    assert orbit.parameters["eta"] == parse("pi/3")
    found = ns.solve(STICK, DATA | {"eta": [1, number]})
    assert found.period[1] == pytest.approx(orbit.period, rel=1e-13)


def test_what_is_masked_or_missing_is_no_number():
    masked = np.ma.array([1, 1.01], mask=[False, True])
    with pytest.raises(ns.InputError, match="eta: masked values"):
        ns.solve(STICK, DATA | {"eta": masked})
    with pytest.raises(ns.InputError, match="v1: masked values"):
        ns.simulate("dry-friction", DATA, np.ma.array(START, mask=[0, 0, 1, 0]), until=1)
    for missing in (None, [1, None]):
        with pytest.raises(ns.InputError, match="until: None"):
            ns.simulate("dry-friction", DATA, START, until=missing)


def test_numbers_in_an_order_are_not_taken_by_names():
    function = ns.orbit_function(result("orbit"), by=["V", "eta"], of="period")
    for call in (function, function.jacobian, lambda x: function.jvp([1, 1], x)):
        with pytest.raises(ns.InputError, match="in the order V, eta, not by names"):
            call({"eta": 1, "V": 1.01})


def test_names_may_come_one_by_one():
    orbit = ns.solve(STICK)
    given = {"tau": orbit.unknowns["tau"]}
    assert ns.solve(STICK, unknown=iter(["eta"]), given=given).converged


def test_what_has_names_that_its_order_would_not_heed_is_refused():
    class Series(list):  # as that of pandas: its entries have names
        def items(self):
            return [*zip(("v2", "x1", "x2", "v1"), self, strict=True)]

    with pytest.raises(ns.InputError, match=r"^state takes several values"):
        ns.simulate("dry-friction", DATA, Series(START), transitions=3)


def test_an_array_without_axes_is_a_number():
    found = ns.solve(STICK, {"V": np.array(0.98)})
    assert found.values == ns.solve(STICK, {"V": 0.98}).values


@pytest.mark.parametrize("record", [kind for kind in records().values() if hasattr(kind, "save")])
def test_what_is_kept_is_told_as_json(record):
    assert hasattr(record, "to_json")
    found = [kind for kind in RESULTS if type(result(kind)) is record]
    for kind in found:
        assert json.loads(json.dumps(result(kind).to_json(), allow_nan=False))
