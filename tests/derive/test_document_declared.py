"""Documents of declared systems without closed forms: what they tell, and how they are laid out."""

import re

import pytest
import sympy as sp

from nonsmooth.derive import (
    Boundary,
    Configuration,
    DerivationError,
    FirstOrder,
    Itinerary,
    Phase,
    RigidStop,
    SecondOrder,
    System,
    Transition,
    oscillator,
)
from nonsmooth.derive.document.blocks import Table
from nonsmooth.derive.document.describe import describe_orbit, describe_system
from nonsmooth.derive.document.hypertext import to_markdown
from nonsmooth.derive.systems import SYSTEMS, declaration
from tests.declared_documents import forced_stop, impacts, one_mass, rattle, switched, switching
from tests.documents import declarations, document_of


def text_of(described):
    describe = describe_system if isinstance(described, System) else describe_orbit
    return to_markdown(describe(described))


def test_the_regimes_of_damping_are_named_where_they_are_open():
    text = to_markdown(document_of("any-mass"))
    for regime in ("underdamped", "critically damped", "overdamped"):
        assert text.count(rf"\text{{ ({regime})}}") == 1
    assert r"\text{if }" not in text_of(switched())


def test_a_word_of_a_description_is_no_dwell_time():
    itinerary = declarations()["piecewise_stiffness/one-contact"]
    assert {p.dwell_time for p in itinerary.phases} == {"on", "off"}
    assert "| stiffness on the stop, against 1 before it |" in text_of(itinerary)


@pytest.mark.slow
def test_a_multiplier_is_trivial_where_a_forcing_is_found():
    struck = Itinerary("struck", one_mass(0), (Phase("free", "stop-reaches-stop", "tau"),))
    described = map(describe_orbit, (impacts(1), switching(), rattle(0), struck))
    assert [len(document.shown.harmonics) for document in described] == [1, 0, 0, 0]
    assert "1 and trivial" in text_of(impacts(1))


def test_equal_transitions_are_described_once():
    document, short = (describe_orbit(switching(turns)) for turns in (6, 1))
    text = to_markdown(document)
    assert len(re.findall(r"^Transition \d", text, re.MULTILINE)) == 2
    assert "(behind phases 1, 3, 5, 7, 9 and 11)" in text
    (phases,) = (b for b in document.section("The itinerary") if isinstance(b, Table))
    assert [row[-1] for row in phases.rows] == [f"${1 + k % 2}$" for k in range(12)]
    assert len(text) < 1.15 * len(to_markdown(short)) + 12 * 90


@pytest.mark.slow
@pytest.mark.parametrize("name", SYSTEMS)
def test_any_itinerary_can_be_described(name):
    """Held coordinates, presentations, a given period and a border collision too."""
    for itinerary in declaration(name).orbits:
        given = re.findall(r"Given are the parameters (.*?)\.", text_of(itinerary))
        for swapped in itinerary.solved_for:
            assert f"{swapped[0]}_{{{swapped[1:]}}}" not in given[0]


def test_letters_are_those_that_nothing_else_has():
    symbols = sp.symbols("A R n c f m mu J p_1 s", positive=True)
    system = one_mass(0, sp.Add(*symbols))
    itinerary = Itinerary("one", system, (Phase("free", "stop-reaches-stop", "tau"),))
    chosen = [*vars(describe_orbit(itinerary).shown.notation.letters).values()]
    assert len({*chosen}) == len(chosen)
    assert not {"A", "R", "n", "c", "f", "m", r"\mu", "J", "p", "s"} & {*chosen}


def test_contacts_and_constraints_are_told():
    document = describe_system(forced_stop())
    assert "Throughout, $x - 1 = 0$ and $v = 0$ in *contact*." in to_markdown(document)
    assert any(isinstance(block, Table) for block in document.section("Contacts"))


def test_wide_motions_are_written_row_by_row():
    size = 7
    stiffness = sp.Matrix(size, size, lambda i, j: sp.Rational(1000 + i + j, 10**9 + 7))
    names = [f"x{i}" for i in range(1, size + 1)]
    text = text_of(oscillator("wide", names, sp.eye(size), stiffness, stiffness))
    lefts = re.findall(r"^(x_\{\d\}''|M x'')", text, re.MULTILINE)
    assert lefts == [f"x_{{{i}}}''" for i in range(1, size + 1)]


def test_closed_and_open_flows_stand_side_by_side():
    size = 7
    states = sp.symbols(f"y1:{size + 1}", real=True)
    ring = sp.Matrix(size, size, lambda i, j: sp.Integer(j == (i + 1) % size) - (i == j))
    motions = {"closed": -sp.eye(size), "open": ring - sp.eye(size) / 3}
    boundary = Boundary("stops", states[0] - 1)
    configurations = [Configuration(n, FirstOrder(m), (boundary,)) for n, m in motions.items()]
    ends = [
        Transition(*way) for way in (("closed", {"stops"}, "open"), ("open", {"stops"}, "closed"))
    ]
    text = text_of(System("both", "", states, (), configurations, ends))
    assert r"$\Phi_{1}$, of *closed*:" in text
    assert r"$\Phi_{2}$, of *open*: the 7 eigenvalues are found" in text
    assert "The flow of *open* is not written out" in text


def test_a_start_that_nothing_satisfies_is_refused():
    """The held velocity is 1 throughout, the boundary asks for 2."""
    x, v = sp.symbols("x v", real=True)
    held = Configuration("held", SecondOrder([[1]], [[1]], held={x: 1}), (Boundary("fast", v - 2),))
    system = System(
        "contradiction", "", (x, v), (), (held,), (Transition("held", {"fast"}, "held"),)
    )
    with pytest.raises(DerivationError, match=r"'never'.*no state"):
        describe_orbit(Itinerary("never", system, (Phase("held", "fast", "tau"),)))


def test_letters_of_the_derivation_give_way_to_those_of_the_user():
    omega, entry, mass = sp.symbols("omega_1 p_1 M", positive=True)
    stiffness = [[omega, -omega], [-omega, omega + entry]]
    stop = RigidStop("x", at=1, restitution=1, name="stop")
    text = text_of(oscillator("two", ["x", "y"], [[mass, 0], [0, 1]], stiffness, elements=[stop]))
    assert r"\hat{\omega}_{1} &=" in text
    assert r"\hat{p}_{1} &=" in text
    assert r"\omega_{1} &=" not in text.replace(r"\hat{\omega}_{1}", "")
    assert r"\mathsf{M} &= \operatorname{diag}\left(M, 1\right)" in text
    assert r"$\mathsf{M}^{-1} K$" in text
