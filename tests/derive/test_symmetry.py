"""Reversors and border collisions as declared: what is derived from them, what is refused."""

from dataclasses import replace
from functools import cache

import pytest
import sympy as sp

from nonsmooth import refine, solve
from nonsmooth.derive import (
    Boundary,
    Configuration,
    DeclarationError,
    DerivationError,
    Itinerary,
    Parameter,
    Phase,
    Presentation,
    Reference,
    SecondOrder,
    System,
    Transition,
    derive_equations,
    dry_friction,
)
from tests.declared import elastic_stop, rigid_stop
from tests.derive.test_equations import MP, Derived
from tests.latex_reader import ORBITS as WHOLE
from tests.latex_reader import written_of

X, V = sp.symbols("x v", real=True)
z1, z2, v1, v2 = dry_friction.shifted.states
x1, x2, w1, w2 = rigid_stop.states


ORBITS = {
    "one-impact": rigid_stop.one_impact,
    "one-contact": elastic_stop.one_contact,
    "symmetric": dry_friction.symmetric,
    "solution-ii": dry_friction.solution_ii,
}


@cache
def derived(name, rotation=0):
    if rotation == 0:
        (whole,) = (n for n in WHOLE if n.endswith(f"/{name}"))
        return written_of(whole).equations
    return derive_equations(ORBITS[name].rotated(rotation))


# --- what is derived --------------------------------------------------------------------


def bouncer(**options):
    """One mass on a spring in front of a wall at x = 1, with restitution r."""
    r = Parameter("r", "restitution", upper=1, closed=True, upper_closed=True)
    free = Configuration("free", SecondOrder([[1]], [[1]]), (Boundary("wall", X - 1),))
    system = System(
        "bouncer", "a spring and a wall", (X, V), (r,), (free,),
        (Transition("free", {"wall"}, "free", (), {V: -r.symbol * V}),),
    )  # fmt: skip
    chosen = {"start": {"v": "u"}, "reversor": {V: -V}, "period": Parameter("T", "period")}
    return Itinerary("loop", system, (Phase("free", "wall", "T"),), **(chosen | options))


def test_half_of_a_period_in_closed_form():
    """v(T/2) = u cos(T/2) - sin(T/2) = 0: the explicit solution is u = tan(T/2)."""
    equations = derive_equations(bouncer())
    assert [str(u) for u in equations.unknowns] == ["u"]
    assert {str(s): value for s, value in equations.required.items()} == {"r": 1}
    ((meaning, _),) = equations.equations
    assert meaning == "v vanishes halfway through free"
    (condition,) = equations.expand("residual")
    u, period = equations.unknowns[0], sp.Symbol("T", positive=True)
    assert sp.simplify(condition - (u * sp.cos(period / 2) - sp.sin(period / 2))) == 0
    assert sp.simplify(sp.solve(condition, u)[0] - sp.tan(period / 2)) == 0


def test_a_reversor_is_written_out_where_a_state_is_named_after_it():
    """Adding the named start's condition: chi (z2 - z1) = e2 at the symmetric orbit's start."""
    equations = derived("symmetric")
    assert [str(u) for u in equations.unknowns] == ["z10", "z20", "v10", "tau", "tau1"]
    (end,) = (e for m, e in equations.equations if m == "second-breaks-forward ends slip-stick")
    chi, excess = dry_friction.chi, sp.Symbol("e2", nonnegative=True)
    z10, z20 = sp.symbols("z10 z20", real=True)
    ratio = sp.cancel(end / (chi * (z20 - z10) - excess))
    assert ratio.is_number
    assert ratio != 0


@pytest.mark.slow
def test_a_reference_for_another_start_does_not_mislead():
    """Guesses of other unknowns leave the choice of equations to their order."""
    turned = elastic_stop.one_contact.rotated(1)
    bare = replace(turned, reference=None)
    first, second = derived("one-contact", 1).reduction, derive_equations(bare).reduction
    assert first.unknowns == second.unknowns
    assert len(first.equations) == len(second.equations) == 1


# --- orbits that are refused ------------------------------------------------------------


def damped():
    loop = bouncer()
    drag = SecondOrder([[1]], [[1]], damping=[[sp.Rational(1, 5)]])
    free = Configuration("free", drag, (Boundary("wall", X - 1),))
    return replace(loop, system=replace(loop.system, configurations=(free,)))


NO_INVOLUTION = "'one-impact': its reversor is no involution"
NOT_REVERSED = "'one-impact': configuration 'free' is not reversed by the map"
REVERSORS = [
    ({w1: 2 * w1}, NO_INVOLUTION),
    ({w1: -w1 + 1, w2: -w2, x1: x1 + w1}, NO_INVOLUTION),
    ({x1: x1 + 1}, NO_INVOLUTION),
    ({x1: x2, x2: x1}, NOT_REVERSED),
    ({w1: -w1}, NOT_REVERSED),
    ({x1: -x1}, NOT_REVERSED),
    ({w1: 1 - w1, w2: -w2}, NOT_REVERSED),
]


@pytest.mark.parametrize(
    ("itinerary", "message"),
    [
        *((replace(rigid_stop.one_impact, reversor=r), message) for r, message in REVERSORS),
        (damped(), "configuration 'free'"),
        # a given period fixes one time too many where energy is lost
        (replace(rigid_stop.one_impact, reversor={}), "4 equations for 3 unknowns"),
        (
            replace(dry_friction.solution_ii, solved_for=("chi",)),
            "chi changes the flows, so it cannot be solved",
        ),
    ],
)
def test_what_has_no_equations_is_refused(itinerary, message):
    with pytest.raises(DerivationError, match=message) as caught:
        derive_equations(itinerary)
    assert "\n" not in str(caught.value)


# --- declarations that are refused ------------------------------------------------------


@pytest.mark.parametrize(
    ("itinerary", "changes", "message"),
    [
        (rigid_stop.one_impact, {"start": {"x3": "y"}}, "start of 'x3', which is not declared"),
        (
            dry_friction.symmetric,
            {"start": {"x1": "a"}},
            "start of 'x1', which is not declared",  # the presentation calls it z1
        ),
        (rigid_stop.one_impact, {"reversor": {V: -V}}, "reversor of 'v', which is not declared"),
        (rigid_stop.one_impact, {"reversor": {sp.Symbol("x1"): V}}, "x1 has other assumptions"),
        (
            dry_friction.solution_ii,
            {"vanishing": ("tb",)},
            "vanishing dwell time 'tb', which is not declared",
        ),
        (
            dry_friction.solution_ii,
            {"solved_for": ("e3",)},
            "parameter to solve for 'e3', which is not declared",
        ),
        (
            dry_friction.solution_ii,
            {"vanishing": ()},
            "0 vanishing dwell times, but 1 parameters to solve for",
        ),
        (
            dry_friction.solution_ii,
            {"solved_for": ("e1", "e2")},
            "1 vanishing dwell times, but 2 parameters to solve for",
        ),
        (
            rigid_stop.one_impact,
            {"start": {"x2": "y", "v1": "y"}},
            "unknown 'y' is named twice",
        ),
        (rigid_stop.one_impact, {"start": {"x2": "T"}}, "'T' has the name of something else"),
        (rigid_stop.one_impact, {"start": {"x2": "m1"}}, "'m1' has the name of something else"),
        (rigid_stop.one_impact, {"start": {"x2": "v1"}}, "'v1' has the name of something else"),
        (rigid_stop.one_impact, {"start": {"x2": "lambda"}}, "'lambda' is not an identifier"),
        (
            elastic_stop.one_contact,
            {"period": Parameter("k3", "period")},
            "period 'k3' has the name of something else",
        ),
        (
            elastic_stop.one_contact,
            {"period": Parameter("tau", "period")},
            "period 'tau' has the name of something else",
        ),
        (
            dry_friction.solution_ii,
            {"vanishing": ("ta", "ta"), "solved_for": ("e1", "e2")},
            "named twice",
        ),
        (
            dry_friction.solution_ii,
            {"vanishing": ("ta", "tau"), "solved_for": ("e1", "e1")},
            "named twice",
        ),
    ],
    ids=lambda value: str(value)[:50] if isinstance(value, str) else "",
)
def test_wrong_names_are_refused_by_name(itinerary, changes, message):
    with pytest.raises(DeclarationError, match=message) as caught:
        replace(itinerary, **changes)
    assert str(caught.value).startswith(f"itinerary '{itinerary.name}': ")
    assert "\n" not in str(caught.value)


@pytest.mark.slow
def test_any_other_parameter_may_be_solved_for():
    """The same border collision, found for another parameter at the e1 that belongs to it."""
    found_for = Derived(replace(dry_friction.solution_ii, solved_for=("e2",)))
    assert str(found_for.orbit.unknowns[-1]) == "e2"
    orbit = refine(solve("dry-friction/solution-ii"), 40)
    known = {n: MP.mpf(x) for n, x in orbit.values.items()}
    guess = [known[str(u)] * (1 + MP.mpf(k) / 1000) for k, u in enumerate(found_for.orbit.unknowns)]
    found = found_for.solved([known[n] for n in found_for.names], guess)
    for symbol, value in zip(found_for.orbit.unknowns, found, strict=True):
        assert abs(value - known[str(symbol)]) < MP.mpf(10) ** -37


def test_specialised_values_join_the_presentation():
    shown = Presentation(rigid_stop.states, (0, 0, 0, 0), (), {rigid_stop.k2: 5 * rigid_stop.k1})
    itinerary = replace(rigid_stop.one_impact, presentation=shown)
    fixed = itinerary.specialised({rigid_stop.m2: sp.Integer(2)})
    assert dict(fixed.presentation.substitution) == {
        rigid_stop.k2: 5 * rigid_stop.k1,
        rigid_stop.m2: 2,
    }
    equations = derive_equations(fixed)
    assert [str(p) for p in equations.parameters] == ["m1", "k1", "T"]


def test_a_reference_is_not_needed():
    bare = derive_equations(replace(ORBITS["one-impact"], reference=None))
    full = derived("one-impact")
    assert bare.unknowns == full.unknowns
    assert [e for _, e in bare.equations] == [e for _, e in full.equations]


@pytest.mark.slow
def test_a_reference_need_not_be_whole():
    cut = replace(elastic_stop.one_contact, reference=Reference({"m1": "1"}, {"tau": "2"}))
    assert derive_equations(cut).reduction.unknowns == (sp.Symbol("tau", positive=True),)
