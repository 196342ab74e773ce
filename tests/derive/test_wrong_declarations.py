"""Whatever a declaration is given, it is made, or refused in one line."""

import inspect
from dataclasses import fields

import numpy as np
import pytest
import sympy as sp
from scipy.sparse import csc_array

import nonsmooth.derive as nd
from nonsmooth.derive import dry_friction
from tests.tables import slow

X, A = sp.symbols("x a")
ORBIT = dry_friction.orbits[0]
SYSTEM = ORBIT.system
REFUSALS = (nd.DeclarationError, nd.DerivationError)
NEVER = object()  # what nothing takes
RUN = "__import__('pathlib').Path('executed').touch()"
NESTED = []
NESTED.append(NESTED)


class Told:
    """What is told by a text that can be run."""

    def __str__(self):
        """Give the text."""
        return RUN


def deep():
    """An expression that is nested more deeply than functions may call each other."""
    found = sp.Symbol("z")
    for _ in range(2000):
        found = sp.sin(found, evaluate=False)
    return found


# each is refused as a text of a formula, wherever one is taken
PROGRAMS = (
    RUN, "open(5)", "x.free_symbols", "x[0]", "exec(x)", "x := 2", "'x'", "(chr)(65)", "sqrt(2)(3)",
    "lambda: x", "x if x else 2", "__x__", "x or 2", "2j", "2 x", "sqrt(x, y)", "sqrt", "True",
    "x(2)", "", "(1, 2)", "9**9**9", "1e400", "1e-400", "root(5, 1, 0, -2)", "µ + μ",
    "sqrt(2)**10**10", "exp(10**6*log(2))", "(2*x)**10**6", "(1 + sqrt(2))**-100000", "exp(10**7)",
    "exp(1)**(10**9*log(2))", "root(2, 1/10**9)", "10**4000", "10**5000",
    "(" * 5000, "-" * 9000 + "1", "x" * 50_000 + "!",
)  # fmt: skip
WRONG = (
    NEVER, None, True, 5, 2.5, "x y!", b"x", [], {}, (), [5], ["x", 5], [(sp.Symbol("z"),)],
    [None], b"2", {"x", "y"}, RUN, [[RUN]], np.ma.array([[3.0]], mask=True), np.ma.masked,
    {"x": 1}, {5: 1}, {"x": 1}.keys(), float("nan"), float("inf"), sp.Float("1e400"), 1j,
    sp.Symbol("z"), deep(), NESTED, [[NESTED]], Told(), [[Told()]], sp.ones(2, 3), np.zeros(3),
    np.array(2.5), np.array([[RUN]]), np.matrix([[1.0]]), np.True_, np.int64(5),
    sp.MatrixSymbol("z", 1, 1), sp.Identity(sp.Symbol("z")), sp.BlockMatrix([[sp.eye(1)]]),
)  # fmt: skip
# with which each public name makes something; records of the paper's orbit give their own fields
RIGHT = {
    "Boundary": SYSTEM.configurations[0].boundaries[0],
    "Condition": next(c for t in SYSTEM.transitions for c in t.conditions),
    "Configuration": SYSTEM.configurations[0],
    "Contact": SYSTEM.contacts[0],
    "FirstOrder": {"matrix": sp.eye(2), "offset": [0, 1]},
    "Friction": {"coordinate": "x", "kinetic": 1, "static": 2},
    "Harmonic": {"frequency": 2, "cosine": [1], "sine": [0]},
    "Itinerary": ORBIT,
    "Parameter": {"name": "a", "description": "", "lower": 0, "upper": 1},
    "Phase": ORBIT.phases[0],
    "Presentation": ORBIT.presentation,
    "Reference": ORBIT.reference,
    "Regions": {"function": "x"},
    "RigidStop": {"coordinate": "x", "at": 1, "restitution": 0.5},
    "SecondOrder": {"mass": [[1]], "stiffness": [[1]], "load": [1], "damping": [[0]]},
    "Slider": {"coordinate": "x", "stiffness": 1, "limit": 2},
    "SoftStop": {"coordinate": "x", "at": 1, "stiffness": 3},
    "Source": ORBIT.source,
    "System": SYSTEM,
    "Terms": {"stiffness": [[1]], "damping": [[1]], "load": [1]},
    "Transition": SYSTEM.transitions[0],
    "chain_matrices": {"masses": [1, 1], "springs": [1, 1], "dampers": [0, 0]},
    "derive_equations": {"itinerary": nd.Itinerary("o", SYSTEM, ORBIT.phases[:1])},
    "oscillator": {
        "name": "o", "coordinates": ["x"], "mass": [[1]], "stiffness": [[1]],
    },
    "read_matrices": {"path": "no-such-file.npz"},
    "reduce_structure": {
        "mass": np.eye(3), "stiffness": np.eye(3), "keep": [0], "modes": 1,
    },
}  # fmt: skip
MADE_ALONE = ("EquationSystem", "ReducedStructure")  # which other functions return
FORCES = ("Harmonic",)
ELEMENTS = ("Friction", "Regions", "RigidStop", "Slider", "SoftStop")


def right(name):
    """All arguments with which a public name makes something."""
    given = RIGHT[name]
    if not isinstance(given, dict):
        given = {f.name: getattr(given, f.name) for f in fields(given) if f.init}
    parameters = inspect.signature(getattr(nd, name)).parameters.values()
    return {p.name: p.default for p in parameters if p.default is not p.empty} | given


def make(name, given):
    """What a public name makes; elements and forces are put into an oscillator."""
    made = getattr(nd, name)(**given)
    if name in (*ELEMENTS, *FORCES, "Terms"):
        terms = nd.Regions("x", below=made) if name == "Terms" else made
        part = {"forcing": [made]} if name in FORCES else {"elements": [terms]}
        nd.oscillator("o", ["x"], [[1]], [[1]], **part)
    return made


@pytest.mark.parametrize("text", PROGRAMS, ids=lambda text: repr(text[:12]))
def test_texts_of_formulas_are_no_programs(text):
    dampers = [[text]]
    for name, argument, given in (
        ("oscillator", "damping", dampers),
        ("oscillator", "damping", np.array(dampers)),
        ("oscillator", "load", [text]),
        ("FirstOrder", "matrix", [[text, 0], [0, 1]]),
        ("FirstOrder", "offset", [0, text]),
        ("SecondOrder", "damping", dampers),
        ("SecondOrder", "damping", np.array(dampers, dtype=object)),
        ("Terms", "stiffness", dampers),
        ("RigidStop", "at", text),
        ("Parameter", "upper", text),
        ("Boundary", "function", text),
        ("Transition", "reset", {SYSTEM.states[0]: text}),
        ("chain_matrices", "masses", [text, 1]),
    ):
        said = refusal(name, right(name) | {argument: given})
        assert said, name
        assert "\n" not in said


@pytest.mark.parametrize(
    ("text", "expression"),
    [
        ("x", X), ("2*pi/sqrt(3)", 2 * sp.pi / sp.sqrt(3)), ("1e-3*a**2", A**2 / 1000),
        (".5", sp.S.Half), ("sin(x) - (a + 1)/2", sp.sin(X) - (A + 1) / 2), ("-x^2", -(X**2)),
        ("S(1)/3", sp.Rational(1, 3)), ("Max(x, 2) - Abs(a)", sp.Max(X, 2) - sp.Abs(A)),
        ("asinh(1)", sp.log(1 + sp.sqrt(2))), ("gamma*x", sp.Symbol("gamma") * X),
        ("root(1, 1, 0, -2)", sp.sqrt(2)), ("root(8, 3)", sp.Integer(2)),
        ("+".join("x" * 900), 900 * X), ("E*x - S", sp.Symbol("E") * X - sp.Symbol("S")),
        ("µ - ϕ", sp.Symbol("µ") - sp.Symbol("ϕ")), ("0.0e-400 + x", X),
        ("1**300000 + 0**300000 + (-1)**300001", sp.S.Zero), ("exp(x + 3*log(2))", 8 * sp.exp(X)),
    ],
)  # fmt: skip
def test_texts_of_formulas_are_what_they_say(text, expression):
    assert sp.simplify(nd.Boundary("b", text).function - expression) == 0


@pytest.mark.parametrize(
    "given",
    [
        np.matrix([[2.0, 1], [1, 3]]), np.array([[2, 1], [1, 3]], dtype=object),
        [["2", 1], (1, "3")],
        np.array([["2", "1"], ["1", "3"]]),
        np.array([["2", "1"], ["1", "3"]]).astype(np.dtypes.StringDType()),
        sp.Matrix([[2, 1], [1, 3]]), sp.Array([[2, 1], [1, 3]]),
        sp.Identity(2) + sp.Matrix([[1, 1], [1, 2]]), csc_array(np.array([[2.0, 1], [1, 3]])),
        sp.BlockMatrix([[sp.Matrix([[2, 1]])], [sp.Matrix([[1, 3]])]]),
        [sp.Matrix([[2, 1]]), np.array([1.0, 3.0])], [sp.Matrix([[2, 1], [1, 3]])],
        {(2, 1): 0, (1, 3): 0}.keys(),
        [[np.array(2.0), np.int64(1)], [np.float64(1), 3]],
    ],
    ids=lambda given: type(given).__name__,
)  # fmt: skip
def test_matrices_of_any_kind_are_read_alike(given):
    wanted = sp.Matrix([[2, 1], [1, 3]])
    assert nd.FirstOrder(given).matrix == wanted
    assert nd.SecondOrder(sp.eye(2), given, damping=given).damping == wanted
    system = nd.oscillator("o", ["x", "y"], given, given)
    assert system.configurations[0].dynamics.mass == wanted


def test_numbers_of_numpy_are_numbers():
    parameter = nd.Parameter("a", "", np.array(0.5), np.float64(0.75), np.True_, np.bool_(False))
    assert (parameter.lower, parameter.upper) == (sp.S.Half, sp.Rational(3, 4))
    assert (parameter.closed, parameter.upper_closed) == (True, False)
    assert nd.Transition("a", {"b"}, "c", order=np.int64(2)).order == 2
    values = {"a": np.float64(0.1), "b": np.array(2), "c": sp.pi / 3, "d": "1/3"}
    texts = {"a": "0.1", "b": "2", "c": "pi/3", "d": "1/3"}
    assert nd.Reference(values, {}).parameters == texts
    for wrong in (object(), 1j, True, X, sp.I, print, np.ma.masked, [1], b"2", Told()):
        assert refusal("Reference", {"parameters": {"a": wrong}, "guess": {}})


def test_what_has_no_order_is_refused_where_it_counts():
    for name, argument, given in (
        ("oscillator", "coordinates", {"x"}),
        ("chain_matrices", "masses", {1, 2}),
        ("System", "states", {*SYSTEM.states}),
    ):
        assert "no order" in refusal(name, right(name) | {argument: given})


def test_what_a_mask_leaves_out_is_refused():
    masked = np.ma.array([[3.0]], mask=True)
    for name in ("mass", "stiffness", "damping"):
        assert "masked" in refusal("oscillator", right("oscillator") | {name: masked})
    assert "masked" in refusal("oscillator", right("oscillator") | {"load": masked[0]})
    whole = np.ma.array(np.eye(3), mask=np.eye(3) > 0)
    for name in ("mass", "stiffness", "damping"):
        assert "masked" in refusal("reduce_structure", right("reduce_structure") | {name: whole})
    one = refusal("RigidStop", right("RigidStop") | {"at": np.ma.masked})
    assert one.startswith("at of RigidStop")
    assert "masked" in one


def refusal(name, given):
    """What is said to wrong arguments; nothing if something is made of them."""
    try:
        repr(make(name, given))
    except REFUSALS as problem:
        return str(problem)
    return ""


LONG = "System", "Itinerary"


def public():
    """The public functions and classes, but for errors."""
    found = {name: getattr(nd, name) for name in nd.__all__ if name not in MADE_ALONE}
    return {
        name: each
        for name, each in found.items()
        if callable(each) and not (inspect.isclass(each) and issubclass(each, Exception))
    }


@pytest.mark.parametrize("name", [slow(n, when=n in LONG) for n in public()])
@pytest.mark.filterwarnings("ignore::sympy.utilities.exceptions.SymPyDeprecationWarning")
def test_wrong_values_are_refused_in_one_line(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    arguments = {} if name not in RIGHT else right(name)
    assert arguments
    if name not in ("derive_equations", "read_matrices"):  # of which the right ones are wrong too
        make(name, arguments)
    for argument in arguments:
        for wrong in WRONG:
            said = refusal(name, arguments | {argument: wrong})
            assert "\n" not in said
            assert said or wrong is not NEVER, argument
    assert not [*tmp_path.iterdir()], "no text is executed"
