"""Documents of declared systems without closed forms: what they say is true of the motion."""

import re

import numpy as np
import pytest
import sympy as sp
from scipy.linalg import expm

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
from nonsmooth.derive.document.blocks import Document, Line, Paragraph, Table
from nonsmooth.derive.document.cycle import Cycle
from nonsmooth.derive.document.describe import describe_itinerary, describe_system
from nonsmooth.derive.document.hypertext import to_markdown
from nonsmooth.derive.document.printer import Notation
from nonsmooth.derive.document.wording import Naming, letters_of
from nonsmooth.derive.flows.modal import derive_flows
from nonsmooth.derive.systems import SYSTEMS, declaration
from tests.declared_documents import (
    forced_stop,
    impacts,
    one_mass,
    rattle,
    switched,
    switching,
)
from tests.documents import declarations

Field = tuple[np.ndarray, np.ndarray]


def cycle_of(itinerary: Itinerary) -> Cycle:
    """An itinerary as its document sees it."""
    system = itinerary.presented_system
    symbols = (*system.states, *(p.symbol for p in system.parameters))
    naming = Naming(Notation(system.states, symbols), system)
    return Cycle(itinerary, naming, {}, {}, letters_of(naming, symbols))


def flow(field: Field, time: float) -> Field:
    """Phi and phi by the exponential of the augmented matrix."""
    matrix, offset = field
    size = len(offset)
    augmented = np.zeros((size + 1, size + 1))
    augmented[:size, :size], augmented[:size, size] = matrix, offset
    found = expm(augmented * time)
    return found[:size, :size], found[:size, size]


def lines_of(document: Document) -> list[Line]:
    return [line for formula in document.formulas for line in formula.lines]


def test_the_regimes_of_damping_are_named_where_they_are_open() -> None:
    zeta, omega = sp.symbols("zeta omega", positive=True)
    text = to_markdown(describe_system(one_mass(zeta * omega, omega**2)))
    for regime in ("underdamped", "critically damped", "overdamped"):
        assert text.count(rf"\text{{ ({regime})}}") == 1
    assert r"\lambda^{2} + 2 \omega \zeta \lambda + \omega^{2}" in text
    assert r"\text{if }" not in to_markdown(describe_system(switched()))


def test_a_word_of_a_description_is_no_dwell_time() -> None:
    itinerary = declarations()["piecewise_stiffness/one-contact"]
    assert {p.dwell_time for p in itinerary.phases} == {"on", "off"}
    (table,) = (
        b for b in describe_itinerary(itinerary).section("The system") if isinstance(b, Table)
    )
    assert "stiffness on the stop, against 1 before it" in {row[1] for row in table.rows}


def test_the_forcing_is_found_where_it_is() -> None:
    c, s = forced_stop().states[2:]
    (found,) = cycle_of(impacts(2)).harmonics
    assert (found.first, found.second, found.invariant) == (c, s, c**2 + s**2)
    assert found.frequency == forced_stop().parameters[1].symbol
    assert "1 and trivial" in to_markdown(describe_itinerary(impacts(1)))
    assert not cycle_of(switching()).harmonics
    assert not cycle_of(rattle(0)).harmonics


def test_equal_transitions_are_described_once() -> None:
    document = describe_itinerary(switching(6))
    text = to_markdown(document)
    assert len(re.findall(r"^Transition \d", text, re.MULTILINE)) == 2
    assert "(behind phases 1, 3, 5, 7, 9 and 11)" in text
    (phases,) = (b for b in document.section("The itinerary") if isinstance(b, Table))
    assert [row[-1] for row in phases.rows] == [f"${1 + k % 2}$" for k in range(12)]
    short = to_markdown(describe_itinerary(switching()))
    assert len(text) < 1.15 * len(short) + 12 * 90


@pytest.mark.slow
@pytest.mark.parametrize("name", SYSTEMS)
def test_any_itinerary_can_be_described(name: str) -> None:
    """Held coordinates, presentations, a given period and a border collision too."""
    for itinerary in declaration(name).orbits:
        document = describe_itinerary(itinerary)
        (table,) = (b for b in document.section("The itinerary") if isinstance(b, Table))
        assert len(table.rows) == len(itinerary.phases)
        for swapped in itinerary.solved_for:
            text = " ".join(b.text for b in document.blocks if isinstance(b, Paragraph))
            given = re.findall(r"Given are the parameters (.*?)\.", text)[0]
            assert f"{swapped[0]}_{{{swapped[1:]}}}" not in given


def test_letters_are_those_that_nothing_else_has() -> None:
    names = "A R n c f m mu J p_1 s"
    symbols = sp.symbols(names)
    system = forced_stop()
    letters = letters_of(Naming(Notation(system.states, symbols), system), symbols)
    chosen = list(vars(letters).values())
    assert len(set(chosen)) == len(chosen)
    assert not {"A", "R", "n", "c", "f", "m", r"\mu", "J", "p", "s"} & set(chosen)


def test_contacts_and_constraints_are_told() -> None:
    document = describe_system(forced_stop())
    text = to_markdown(document)
    assert "Throughout, $x - 1 = 0$ and $v = 0$ in *contact*." in text
    (table,) = (b for b in document.section("Contacts") if isinstance(b, Table))
    assert table.rows == (("*stop*", "$v$", "$0$", "*contact*", "$x - c$"),)


def test_wide_motions_are_written_row_by_row() -> None:
    size = 7
    states = sp.symbols(f"x1:{size + 1} v1:{size + 1}", real=True)
    stiffness = sp.Matrix(size, size, lambda i, j: sp.Rational(1000 + i + j, 10**9 + 7))
    motion = SecondOrder(sp.eye(size), stiffness, damping=stiffness)
    configuration = Configuration("all", motion, (Boundary("stops", states[0]),))
    reached = Transition("all", frozenset({"stops"}), "all")
    document = describe_system(System("wide", "", states, (), (configuration,), (reached,)))
    lefts = [line.left for line in lines_of(document)]
    assert [f"x_{{{i}}}''" for i in range(1, size + 1)] == [x for x in lefts if "''" in x]


def test_closed_and_open_flows_stand_side_by_side() -> None:
    size = 7
    states = sp.symbols(f"y1:{size + 1}", real=True)
    ring = sp.Matrix(size, size, lambda i, j: sp.Integer(j == (i + 1) % size) - (i == j))
    motions = [FirstOrder(-sp.eye(size)), FirstOrder(ring - sp.eye(size) / 3)]
    boundary = Boundary("stops", states[0] - 1)
    configurations = [
        Configuration(name, motion, (boundary,))
        for name, motion in zip(("closed", "open"), motions, strict=True)
    ]
    transitions = [
        Transition("closed", frozenset({"stops"}), "open"),
        Transition("open", frozenset({"stops"}), "closed"),
    ]
    system = System("both", "", states, (), configurations, transitions)
    with pytest.raises(DerivationError):
        derive_flows(system)
    text = to_markdown(describe_system(system))
    assert r"$\Phi_{1}$, of *closed*:" in text
    assert r"$\Phi_{2}$, of *open*: the 7 eigenvalues are found" in text
    assert "The flow of *open* is not written out" in text


def test_a_start_that_nothing_satisfies_is_refused() -> None:
    """The held velocity is 1 throughout, the boundary asks for 2."""
    x, v = sp.symbols("x v", real=True)
    held = Configuration("held", SecondOrder([[1]], [[1]], held={x: 1}), (Boundary("fast", v - 2),))
    system = System(
        "contradiction", "", (x, v), (), (held,), (Transition("held", frozenset({"fast"}), "held"),)
    )
    with pytest.raises(DerivationError, match=r"'never'.*no state"):
        describe_itinerary(Itinerary("never", system, (Phase("held", "fast", "tau"),)))


def test_letters_of_the_derivation_give_way_to_those_of_the_user() -> None:
    omega, entry, mass = sp.symbols("omega_1 p_1 M", positive=True)
    stiffness = [[omega, -omega], [-omega, omega + entry]]
    stop = RigidStop("x", at=1, restitution=1, name="stop")
    system = oscillator("two", ["x", "y"], [[mass, 0], [0, 1]], stiffness, elements=[stop])
    text = to_markdown(describe_system(system))
    assert r"\hat{\omega}_{1} &=" in text
    assert r"\hat{p}_{1} &=" in text
    assert r"\omega_{1} &=" not in text.replace(r"\hat{\omega}_{1}", "")
    assert r"\mathsf{M} &= \operatorname{diag}\left(M, 1\right)" in text
    assert r"K &= " in text
    assert r"$\mathsf{M}^{-1} K$" in text
