"""Wrong declarations are refused, each in one line that names what is wrong."""

import math
from dataclasses import replace

import numpy as np
import pytest
import sympy as sp

from nonsmooth.derive import (
    Boundary,
    Condition,
    Configuration,
    DeclarationError,
    FirstOrder,
    Friction,
    Harmonic,
    Itinerary,
    Parameter,
    Presentation,
    Reference,
    Regions,
    RigidStop,
    SecondOrder,
    Slider,
    SoftStop,
    Source,
    System,
    Terms,
    Transition,
    chain_matrices,
    oscillator,
)
from nonsmooth.derive.codegen.emit import emit_system
from nonsmooth.derive.systems import declaration

X, V = STATES = sp.symbols("x v", real=True)
X1, X2, V1, _ = PAIR = sp.symbols("x1 x2 v1 v2", real=True)
K, G = Parameter("k", "stiffness"), Parameter("g", "gap")
M, N = Parameter("m", "mass"), Parameter("n", "coupling", -1, 1)
KS, GS, MS, NS = (p.symbol for p in (K, G, M, N))
MAY_VANISH = Parameter("c", "damping", closed=True)
STRANGER, A, T = sp.symbols("stranger a t")

FREE = Configuration("free", SecondOrder([[1]], [[KS]]), (Boundary("hits", X - GS),))
REST = Configuration("rest", SecondOrder([[1]], [[KS]], held={X: 0}), (Boundary("goes", -X),), ())
STOP = replace(REST, boundaries=(Boundary("goes", X - 2 * GS),), constraints=(X - GS,))


def system(configurations, transitions, **parts):
    """One mass on a spring in front of a stop at x = g."""
    known = {"name": "one", "description": "", "states": STATES}
    known |= {"parameters": (K, G)} | parts
    return System(configurations=configurations, transitions=transitions, **known)


def alone(*transitions, **parts):
    return lambda: system((FREE,), transitions, **parts)


def leading(*arguments):
    """A transition between the free mass and the one at rest."""
    return lambda: system((FREE, REST), (Transition(*arguments),))


def moving(dynamics, states=STATES, boundaries=(), **parts):
    """A system of one configuration."""
    return lambda: system(
        (Configuration("free", dynamics(), boundaries),), (), states=states, **parts
    )


def sprung(boundaries=(), **changes):
    """One mass on a spring; keywords replace parts of its motion."""
    given = {"mass": [[1]], "stiffness": [[KS]], "load": (GS,)} | changes
    return moving(lambda: SecondOrder(**given), boundaries=boundaries)


def landing(target, image, **more):
    """To a target from the free mass, and back."""
    return lambda: system(
        (FREE, target),
        (
            replace(BOUNCE, target="rest", reset=image | {V: 0}),
            Transition("rest", {"goes"}, "free", **more),
        ),
    )


def turned(*speeds, of=STATES, reset=None):
    """States that turn, in each configuration with two speeds; a reset behind a boundary."""
    boundaries = () if reset is None else (Boundary("hits", X - GS),)
    configurations = [
        Configuration(f"turning-{number}", FirstOrder([[0, -one], [other, 0]]), boundaries)
        for number, (one, other) in enumerate(speeds, 1)
    ]
    back = [] if reset is None else [Transition("turning-1", {"hits"}, "turning-1", (), reset)]
    return lambda: system(configurations, back, forcing=[of])


def presented(states, origin):
    return lambda: Presentation(states, origin).present(alone(BOUNCE)())


def of_one(stiffness=1, **others):
    """An oscillator of one coordinate x, and what is said of it."""
    return lambda: oscillator("given", ["x"], [[1]], [[stiffness]], **others)


def of_two(*elements, **changes):
    """An oscillator of two coordinates."""
    parts = {"coordinates": ["x1", "x2"], "mass": sp.eye(2), "stiffness": sp.eye(2)}
    return lambda: oscillator("wrong", elements=elements, **(parts | changes))


def rubbing(element):
    """An oscillator with an element and a rigid stop."""
    return of_one(elements=[element, RigidStop("x", 1, 0.5, name="wall")])


def of_arrays(**changes):
    """An oscillator whose matrices are arrays."""
    given = {"mass": np.diag([2.0, 1, 3]), "stiffness": np.eye(3)}
    return lambda: oscillator("s", ["x1", "x2", "x3"], **(given | changes))


def sourced(**changes):
    """The global stick orbit with another source."""
    orbit = declaration("dry-friction").global_stick
    return lambda: replace(orbit, source=replace(orbit.source, misprints={}, **changes))


def referred(parameters, guess):
    """An orbit of a mass that the stop kicks, with a reference."""

    def derive():
        kicked = alone(replace(BOUNCE, reset={V: -V / 2 - 1}))()
        phases, reference = (("free", "hits", "T"),), Reference(parameters, guess)
        return emit_system(
            kicked, [Itinerary("loop", kicked, phases, reference=reference)], "tests"
        )

    return derive


def looping(*phases, presentation=None):
    """An itinerary of the mass that comes to rest on the stop, and leaves it."""
    two = landing(STOP, {X: GS}, reset={X: 0})
    return lambda: Itinerary("loop", two(), phases, presentation)


BOUNCE = Transition("free", {"hits"}, "free", (), {V: -V})
REACHED = Condition(V, "free")
EYE, WIDE = sp.eye(2), sp.eye(3)
HITS, GOES = ("free", "hits", "ta"), ("rest", "goes", "tb")

WRONG = [
    # shapes
    (lambda: Boundary("far", X - 1, "touched"), "'far'.*'touched'"),
    (lambda: SecondOrder([[1, 0]], [[1]]), "mass is 1 x 2, not square"),
    (lambda: SecondOrder([[1]], EYE), "stiffness is 2 x 2, not 1 x 1"),
    (lambda: SecondOrder([[1]], [[1]], damping=EYE), "damping is 2 x 2, not 1 x 1"),
    (lambda: SecondOrder([[1]], [[1]], (1, 2)), "load has 2 values"),
    (lambda: SecondOrder([[KS, KS], [KS, KS]], EYE), "mass is singular"),
    (lambda: FirstOrder([[1, 0]]), "matrix is 1 x 2, not square"),
    (lambda: FirstOrder(EYE, (1,)), "offset has 1 values"),
    (
        moving(lambda: SecondOrder([[1]], [[KS]]), PAIR),
        "mass is 1 x 1, but the system has 4 states",
    ),
    (moving(lambda: FirstOrder([[1]])), "'free': matrix is 1 x 1, but the system has 2 states"),
    (lambda: Presentation((X, V), (0,)), "presentation has 2 states but 1 origins"),
    (presented(PAIR, (0,) * 4), "presentation has 4 states, system has 2"),
    (presented((X1, V1), (0, 1)), "presentation shifts a velocity"),
    # names that are declared twice, kept, unknown, or no names
    (
        sprung([Boundary("far", X - 1), Boundary("far", X - 2)]),
        "boundary of configuration 'free' 'far' is declared twice",
    ),
    (alone(BOUNCE, states=(X, X)), "state 'x' is declared twice"),
    (alone(BOUNCE, parameters=(K, K, G)), "parameter 'k' is declared twice"),
    (alone(BOUNCE, parameters=(K, G, Parameter("v", ""))), "name 'v' is declared twice"),
    (alone(BOUNCE, parameters=(K, G, Parameter("t", ""))), "name 't' is kept for the time"),
    (lambda: system((FREE, FREE), ()), "configuration 'free' is declared twice"),
    (sprung(held={V: 1}), "'free': held coordinate v is not a position"),
    (leading("jump", {"hits"}, "rest"), "no configuration 'jump'"),
    (leading("free", {"hits"}, "jump"), "no configuration 'jump'"),
    (leading("free", {"hits"}, "rest", (Condition(X, "jump"),)), "no configuration 'jump'"),
    (leading("free", set(), "rest"), "transition 'free' -> 'rest': no boundary is named"),
    (
        leading("free", {"goes"}, "rest"),
        r"configuration 'free' has no boundary 'goes' \(it has: hits\)",
    ),
    (leading("free", {"hits"}, "rest", (), {X1: 0}), "'rest': reset of x1, which is not a state"),
    (lambda: Parameter("k 1", ""), "'k 1' is not an identifier"),
    (lambda: Parameter("lambda", ""), "'lambda' is not an identifier"),
    (alone(BOUNCE, name="../one"), "is no name: letters, digits and hyphens"),
    (lambda: system((replace(FREE, name="free 1"),), ()), "configuration 'free 1' is no name"),
    (
        lambda: system((replace(FREE, name="a-b"), replace(FREE, name="a_b")), ()),
        "configurations 'a-b' and 'a_b' differ by hyphens only",
    ),
    (
        moving(lambda: SecondOrder([[1]], [[1]]), (sp.Symbol("x'", real=True), V)),
        'state "x\'" is not an identifier',
    ),
    (
        lambda: Itinerary("a loop", alone(BOUNCE)(), (("free", "hits", "T"),)),
        "itinerary 'a loop' is no name",
    ),
    # symbols that are not declared, or otherwise; functions of another kind
    (sprung(held={X: STRANGER}), "configuration 'free': symbol stranger is not a parameter"),
    (sprung(load=(STRANGER,)), "configuration 'free': symbol stranger is not a parameter"),
    (sprung(stiffness=[[X]]), "'free': symbol x is not a parameter"),
    (
        sprung([Boundary("far", X - STRANGER)]),
        "'free', boundary 'far': symbol stranger is neither a state nor a parameter",
    ),
    (
        alone(BOUNCE, constraints=(KS - STRANGER,)),
        "constraint k - stranger >= 0: symbol stranger is not a parameter",
    ),
    (
        sprung(stiffness=[[sp.Symbol("k")]]),
        "symbol k has other assumptions than the declared k: use .* Parameter.symbol",
    ),
    (sprung([Boundary("far", X * V - 1)]), r"'free', boundary 'far': v\*x - 1 is not affine"),
    (
        leading("free", {"hits"}, "rest", (Condition(V**2, "rest"),)),
        r"'free' -> 'rest': v\*\*2 is not affine",
    ),
    (leading("free", {"hits"}, "rest", (), {V: V**2}), "reset of v: .* is not affine"),
    # numbers and domains
    (lambda: Parameter("k", "", 1, 1), "k: the domain is empty"),
    (lambda: Parameter("k", "", math.nan), "k: the end nan .* not a real number"),
    (lambda: Parameter("k", "", sp.I), "lower of Parameter 'k': I is no real"),
    (lambda: Parameter("k", "", GS), "k: the end g .* not a real number"),
    (lambda: SecondOrder([[math.nan]], [[1]]), "mass holds nan, which is no finite"),
    (lambda: SecondOrder([[1]], [[1]], (-math.inf,)), "load holds -oo"),
    (lambda: SecondOrder([[1]], [[1]], damping=[[1j]]), "damping: I is no real number"),
    (lambda: SecondOrder([[1]], [[1]], held={X: math.nan}), "velocity of x holds nan"),
    (lambda: FirstOrder([[math.nan]]), "matrix holds nan"),
    (lambda: SecondOrder([[1, 0], [1]], EYE), "mass is no matrix"),
    (sprung([Boundary("far", X - math.nan)]), "'free', boundary 'far' holds nan"),
    (
        alone(replace(BOUNCE, reset={V: math.inf})),
        "reset of v holds oo, which is no finite real number",
    ),
    # masses
    (
        moving(lambda: SecondOrder([[1, 2], [2, 1]], EYE), PAIR),
        "'free': mass is not positive definite: its leading minor of order 2 is -3",
    ),
    (
        moving(lambda: SecondOrder([[NS - 1]], [[1]]), parameters=(N,)),
        "mass is not positive definite: its leading minor of order 1 is n - 1",
    ),
    (
        moving(lambda: SecondOrder([[2, 1], [0, 2]], EYE), PAIR),
        "'free': mass is not symmetric: 1 and 0",
    ),
    (
        moving(lambda: SecondOrder([[0, 1], [1, 0]], EYE, held={X2: 1}), PAIR),
        "'free': mass of the free coordinates is singular",
    ),
    # forcings
    (turned([1, 1], of=(X, T)), "forcing x, t: t is not a state"),
    (turned([1, 2]), "forcing x, v: in 'turning-1' it does not turn, c' = -w s, s' = w c"),
    (turned([1, 1], [2, 2]), "forcing x, v: it turns at different speeds: {.*}"),
    (
        turned([1, 1], reset={V: 0}),
        "transition 'turning-1' -> 'turning-1' resets the forcing x, v",
    ),
    # transitions: none, two that both apply, to the wrong side
    (
        lambda: system((FREE, REST), (BOUNCE,)),
        "configuration 'rest': no transition leads on from boundary 'goes'",
    ),
    (
        alone(BOUNCE, BOUNCE),
        "'free' -> 'free' by hits never applies: the one to 'free' before it applies whenever",
    ),
    (
        alone(
            replace(BOUNCE, conditions=(REACHED,)),
            replace(BOUNCE, conditions=(Condition(X, "free"), REACHED)),
            BOUNCE,
        ),
        "never applies",
    ),
    (
        alone(replace(BOUNCE, reset={X: X + 1})),
        r"'free' -> 'free': behind it boundary 'hits' is passed already \(its function is 1, not",
    ),
    (
        landing(REST, {X: -GS}),
        "'free' -> 'rest': behind it boundary 'goes' is passed already .its function is g,",
    ),
    (
        landing(STOP, {X: GS / 2}, reset={X: 0}),
        "'free' -> 'rest': behind it -g . x is -g/2, where the target keeps it zero",
    ),
    # orbits and their sources
    (looping(), "itinerary 'loop' has no phases"),
    (looping(HITS, (*GOES[:2], "ta")), "'ta' is named twice"),
    (looping(("jump", "hits", "ta")), "no configuration 'jump'"),
    (looping(HITS), "no transition leads from 'free' by 'hits' to 'free'"),
    (looping((*HITS[:2], "x"), GOES), "'x' has the name"),
    (looping((*HITS[:2], "k"), GOES), "'k' has the name"),
    (looping((*HITS[:2], "t a"), GOES), "not an identifier"),
    (
        looping(
            HITS,
            GOES,
            presentation=Presentation(PAIR[::2], (GS / KS, 0), (Parameter("ta", ""),), {GS: 1}),
        ),
        "dwell time 'ta' has the name",
    ),
    (referred({"k": "1"}, {"ta": "3"}), "'loop': the reference guesses no "),
    (
        referred({"kk": "1"}, {"v0": "2", "ta": "3", "T": "1"}),
        "'loop': the reference has kk, which is no parameter",
    ),
    (
        sourced(equations={"phase 5": "(1)"}),
        r"place of 'phase 5', which is unknown \(known: .*end",
    ),
    (sourced(flows={"free": "H"}), "letter for the flow of 'free', which is unknown"),
    (
        sourced(states=tuple("abcdef")),
        "letters for 6 states, but the start and 4 phases have 5",
    ),
    (
        lambda: Source("Pascal (2011)", {"start": "(2)"}, misprints={"(3)": "which is nothing"}),
        r"a misprint at '\(3\)', which no equation names",
    ),
    # elements
    (of_two(Friction("x3", 1)), "unknown coordinate 'x3' .known: x1, x2"),
    (of_two(Friction({"x1": 0}, 1)), "'x1': its direction is zero"),
    (lambda: RigidStop("x1", 1, 1.5), r"'x1-upper' is not in \[0, 1\]: 1.5"),
    (lambda: Friction("x1", 2, 1), "'x1': kinetic friction 2 is above static 1"),
    (lambda: Friction("x1", -1), "kinetic friction of 'x1' is negative: -1"),
    (lambda: SoftStop("x1", 1, -2), "stiffness of 'x1-upper' is negative: -2"),
    (lambda: Slider("x1", 1, 0), "limit of 'x1' is not positive: 0"),
    (lambda: Harmonic(0, (1,)), "frequency is not positive: 0"),
    (lambda: Slider("x1", sp.oo, 1), "stiffness of 'x1' is not a real number: oo"),
    (lambda: RigidStop("x1", 1, 1, "above"), "side of RigidStop .*is 'above'"),
    (lambda: SoftStop("x1", 1, 1, released="late"), "released of SoftStop .*is 'late'"),
    (
        of_one(elements=[SoftStop("x", 1, 9, "c", released="force")], parameters=[MAY_VANISH]),
        "may be zero.*leaves out 0.*released='gap'",
    ),
    (of_two(Friction("x1", 1), Friction("x1", 2, velocity=1)), "'x1' is declared twice"),
    (of_two(Friction("x1", 1, normal=sp.Symbol("x2") ** 2)), "'x1'.*not affine"),
    (of_two(Friction("x1", 1, velocity=sp.Symbol("v2"))), "'x1': the velocity of the belt"),
    (of_two(Regions(A, name="side")), "'side': a does not depend"),
    (of_two(Regions(sp.Symbol("x1"), Terms([[1]]))), "below: stiffness is 1 x 1, not 2 x 2"),
    (of_two(Friction("x1", 1), Friction("x1", 1, name="b")), "'x1' and 'b' rub in one"),
    (rubbing(Friction("x", 1, normal=-A)), "'x': its normal load -a is not positive"),
    (rubbing(Friction("x", 1, normal=0)), "'x': its normal load 0 is not positive"),
    (rubbing(Friction("x", 1, normal="wall")), "the rigid stop 'wall' is no normal load"),
    (rubbing(Friction("x", 1, normal="wal")), r"'wal' is no soft stop .*known: none"),
    (rubbing(Friction("x", 1 + sp.Symbol("x"))), "kinetic friction depends on the state"),
    (rubbing(Friction("x", 1, falling=sp.Symbol("x"))), "slope of falling friction depends on the"),
    (rubbing(Friction("x", 0, 1, falling=1)), "kinetic friction is zero, it cannot"),
    (rubbing(Friction("x", 1, normal=sp.cos(A))), r"cos\(a\), of unknown sign"),
    (rubbing(Slider("x", 1, 1 - sp.Symbol("x"))), "'x': limit depends on the state"),
    (rubbing(SoftStop("x", 1, -A, name="soft")), "'soft': stiffness is negative: -a"),
    (
        lambda: SoftStop(np.ones(3), at=1, stiffness=1),
        "whose direction is a vector needs a name",
    ),
    (
        lambda: SoftStop(np.array([1, np.nan]), at=1, stiffness=1, name="stop"),
        "element 'stop' holds an entry that is not finite",
    ),
    # oscillators
    (of_two(stiffness=WIDE), "stiffness is 3 x 3, not 2 x 2"),
    (of_two(damping=[[1]]), "damping is 1 x 1, not 2 x 2"),
    (of_two(load=[1]), "load has 1 values for 2 coordinates"),
    (of_two(forcing=[Harmonic(1, (1,))]), "cosine amplitudes has 1 values"),
    (of_two(mass=[[1, 0.5], [0, 1]]), "mass is not symmetric"),
    (of_two(coordinates=["x1", "x1"]), "coordinate 'x1' is declared twice"),
    (lambda: chain_matrices([1, 1], [1]), "has 2 springs, not 1"),
    (lambda: chain_matrices([1, 1], [1, 1], []), "has 2 dampers, not 0"),
    (lambda: chain_matrices([1], [1], fixed="top"), "fixed is 'top'"),
    (of_one(forcing=Harmonic(2, [1])), r"forcing is a Harmonic, not.*=\[Harmonic"),
    (of_one(elements=Friction("x", 1)), r"elements is a Friction.*=\[Friction"),
    (of_one(forcing=[sp.cos(T)]), r"forcing cannot hold cos.*Harmonic\("),
    (of_one(forcing=sp.cos(2)), r"forcing is cos\(2\), not a list.*Harmonic\("),
    (of_one(elements=[Harmonic(2)]), "elements cannot hold Harmonic.*: RigidStop"),
    (of_one(parameters=sp.Symbol("k")), r"parameters is k, not a list: Parameter\("),
    (of_one(1 + sp.cos(T)), "stiffness depends on the time.*not supp.*Harm"),
    (of_one(load=[sp.sin(T)]), "load depends on the time.*not supp.*Harmon"),
    (of_one(1 + sp.Symbol("x") ** 2), "stiffness depends on the state x.*not.*SoftStop"),
    (lambda: oscillator("s", ["t"], [[1]], [[1]]), "'t' is kept for the time: choose"),
    # arrays
    (of_arrays(mass=np.eye(3)[:2]), "^mass is 2 x 3, not 3 x 3 as there are coordinates$"),
    (of_arrays(mass=np.ones(3)), r"^mass is no matrix: its shape is \(3,\)$"),
    (of_arrays(mass=1j * np.eye(3)), "^mass holds what is no real number$"),
    (of_arrays(mass=np.ones((3, 3))), "^mass is not positive definite: its"),
    (
        of_arrays(stiffness=np.diag([1, np.inf, 1])),
        "^stiffness holds an entry that is not finite$",
    ),
    (of_arrays(load=np.ones((3, 1))), r"^load is no row of numbers: its shape is \(3, 1\)$"),
    (of_arrays(load=np.array([1, 0, np.nan])), "^load holds an entry that is not finite$"),
    (
        lambda: oscillator(
            "s", [f"x{i}" for i in range(200)], np.eye(200), np.eye(200), load={"tip": 1}
        ),
        r"x10, x11, \.\.\.\)$",
    ),
]


@pytest.mark.parametrize(("make", "message"), WRONG, ids=[message for _, message in WRONG])
def test_a_wrong_declaration_is_refused_by_name(make, message):
    with pytest.raises(DeclarationError, match=message) as caught:
        make()
    assert isinstance(caught.value, ValueError)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    "make",
    [
        alone(BOUNCE),
        # a condition, then all else; a condition and its negation
        alone(replace(BOUNCE, conditions=(REACHED,)), BOUNCE),
        alone(
            replace(BOUNCE, conditions=(REACHED,)),
            replace(BOUNCE, conditions=(replace(REACHED, holds=False),)),
        ),
        alone(replace(BOUNCE, reset={X: X - 1})),
        # on either side, as the state or the parameters are
        alone(replace(BOUNCE, reset={X: V})),
        alone(replace(BOUNCE, reset={X: GS - NS}), parameters=(K, G, N)),
        # a mass that may be positive
        moving(lambda: SecondOrder([[MS, NS], [NS, MS]], EYE), PAIR, parameters=(M, N)),
        lambda: system((FREE, REST), ()),
        landing(STOP, {X: GS}, reset={X: 0}),
        # where a contact is left forces decide
        landing(STOP, {X: GS}),
    ],
)
def test_what_may_be_right_is_accepted(make):
    assert isinstance(make(), System)
