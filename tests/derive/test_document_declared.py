"""Documents of declared systems without closed forms: what they say is true of the motion."""

import re
from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np
import pytest
import sympy as sp
from scipy.linalg import expm
from scipy.optimize import brentq, fsolve

from nonsmooth.derive import (
    Boundary,
    Configuration,
    DerivationError,
    FirstOrder,
    Harmonic,
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
from tests.documents import declarations, document_of, labels_by_section
from tests.latex_reader import Reader, text_of, value_of

Field = tuple[np.ndarray, np.ndarray]


def cycle_of(itinerary: Itinerary) -> Cycle:
    """An itinerary as its document sees it."""
    system = itinerary.presented_system
    symbols = (*system.states, *(p.symbol for p in system.parameters))
    naming = Naming(Notation(system.states, symbols), system)
    return Cycle(itinerary, naming, {}, {}, letters_of(naming, symbols))


def field_of(system: System, name: str, values: Mapping[sp.Symbol, float]) -> Field:
    matrix, offset = system.configuration(name).dynamics.field(system.states)
    return numbers(matrix, values), numbers(offset, values)[:, 0]


def numbers(matrix: sp.Matrix, values: Mapping[sp.Symbol, float]) -> np.ndarray:
    return np.array(sp.Matrix(matrix).subs(values).tolist(), dtype=float)


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


def constant(value: float, time: float) -> float:
    """A function of time that is known at one time."""
    return value


@cache
def impact_document() -> Document:
    return describe_itinerary(impacts(1))


DOCUMENTS = {
    "forced": lambda: document_of("forced")[0],
    "impact": impact_document,
    "rattle": lambda: document_of("rattle")[0],
    "switching": lambda: document_of("switching")[0],
}


@pytest.mark.slow
@pytest.mark.parametrize("name", DOCUMENTS)
def test_the_lines_say_what_they_show(name: str) -> None:
    """LaTeX, read back at random numbers, is the expression beside it."""
    document, draw = DOCUMENTS[name](), np.random.default_rng(5)
    shown = [line for line in lines_of(document) if line.shows is not None]
    assert shown
    symbols = sorted(set().union(*(line.shows.free_symbols for line in shown)), key=str)
    values = {
        s: float(v) for s, v in zip(symbols, draw.uniform(0.2, 0.9, len(symbols)), strict=True)
    }
    notation = Notation(tuple(symbols), ())
    read = Reader({notation.symbol(s): v for s, v in values.items()})
    for line in shown:
        text = re.sub(r"^.* = (?=\\left\(\\begin)", "", text_of(line))
        if "D" in line.left:
            continue
        if text == "I":
            assert line.shows == sp.eye(line.shows.rows)
            continue
        found = read.matrix(text) if line.shows.is_Matrix else read(text)
        assert np.allclose(found, value_of(line, values), rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize(
    ("zeta", "square", "word"),
    [
        ("3/10", 1, r"\sin"),
        (1, 1, r"\,t"),
        (2, 1, r"\sinh"),
        ("-1/10", 4, r"\sin"),
        (1, -1, r"\sinh"),
    ],
)
def test_one_damped_coordinate_in_closed_form(zeta: Any, square: int, word: str) -> None:
    system = one_mass(sp.sympify(zeta), square)
    lines = {line.left: line for line in lines_of(describe_system(system))}
    response = lines[r"h_{1}\left(t\right)"].latex.partition("=")[2]
    assert word in response
    time = 0.7
    phi, _ = flow(field_of(system, "swing", {}), time)
    names = {"t": time, r"\mathrm{e}": float(np.e)}
    assert Reader(names)(response) == pytest.approx(phi[0, 1], rel=1e-13)


def test_the_regimes_of_damping_are_named_where_they_are_open() -> None:
    zeta, omega = sp.symbols("zeta omega", positive=True)
    text = to_markdown(describe_system(one_mass(zeta * omega, omega**2)))
    for regime in ("underdamped", "critically damped", "overdamped"):
        assert text.count(rf"\text{{ ({regime})}}") == 1
    assert r"\lambda^{2} + 2 \omega \zeta \lambda + \omega^{2}" in text
    assert r"\text{if }" not in to_markdown(describe_system(switched()))


def formulas_of(system: System) -> dict[str, list[str]]:
    """Right-hand sides by left-hand sides."""
    found: dict[str, list[str]] = {}
    for line in lines_of(describe_system(system)):
        found.setdefault(line.left, []).append(" ".join(line.pieces))
    return found


def driven(damping: Any) -> System:
    """A mass between two walls under harmonic forcing."""
    w, force = sp.symbols("w F", positive=True)
    return oscillator(
        "driven", ["x1"], [[1]], [[2]], [[2 * damping]],
        forcing=[Harmonic(w, {"x1": force})],
        elements=[RigidStop("x1", at=1, restitution=sp.Symbol("r"), name="wall")],
    )  # fmt: skip


def test_the_steady_response_has_amplitude_and_lag() -> None:
    names = {r"\zeta": 0.3, "w": 1.7, r"\mathrm{i}": 1j}
    for damping, answer in (
        (sp.Symbol("zeta", positive=True), 1 / (2 - 1.7**2 + 2 * 0.3 * 1.7j)),
        (sp.Integer(0), 1 / (2 - 1.7**2)),
    ):
        shown = formulas_of(driven(damping))
        assert shown["x_{1,p}(t)"] == [r"F H_{1} \cos\left(\theta(t) - \phi_{1}\right)"]
        assert Reader(names)(shown["H_{1}"][0]) == pytest.approx(abs(answer), rel=1e-13)
        lag = Reader(names)(shown[r"\phi_{1}"][0])
        assert np.exp(-1j * lag) == pytest.approx(answer / abs(answer), rel=1e-13)


def test_a_word_of_a_description_is_no_dwell_time() -> None:
    itinerary = declarations()["piecewise_stiffness/one-contact"]
    assert {p.dwell_time for p in itinerary.phases} == {"on", "off"}
    (table,) = (
        b for b in describe_itinerary(itinerary).section("The system") if isinstance(b, Table)
    )
    assert "stiffness on the stop, against 1 before it" in {row[1] for row in table.rows}


def test_the_cycle_of_switched_damping() -> None:
    """Elimination (4), switching (2) and Jacobian (6) give the known orbit."""
    itinerary = switching()
    cycle, system = cycle_of(itinerary), itinerary.system
    fields = [field_of(system, p.configuration, {}) for p in itinerary.phases]
    embedding = numbers(cycle.start.embedding, {})
    base = numbers(cycle.start.constant, {})[:, 0]
    inverse = np.eye(2)[list(cycle.start.places)]

    def passage(dwell: np.ndarray) -> tuple[np.ndarray, list[np.ndarray]]:
        matrix, remainder = np.eye(2), np.zeros(2)
        flows = [flow(f, t) for f, t in zip(fields, dwell, strict=True)]
        for phi, forcing in flows:
            matrix, remainder = phi @ matrix, phi @ remainder + forcing
        start = np.linalg.solve(
            np.eye(1) - inverse @ matrix @ embedding, inverse @ (matrix @ base + remainder)
        )
        states = [embedding @ start + base]
        for phi, forcing in flows:
            states.append(phi @ states[-1] + forcing)
        return start, states

    def switchings(dwell: np.ndarray) -> list[float]:
        _, states = passage(dwell)
        return [
            float((numbers(p.normal, {}) @ state)[0] + float(p.constant))
            for p, state in zip(cycle.passings, states[1:], strict=True)
        ]

    dwell = fsolve(switchings, [1.5, 4.8], xtol=1e-13)
    assert dwell.sum() == pytest.approx(6.367077, abs=5e-7)
    _, states = passage(dwell)
    values = dict(zip(system.states, states[1], strict=True))
    jacobian = np.eye(2)
    monodromy = np.eye(2)
    for passing, state, field, time in zip(cycle.passings, states[1:], fields, dwell, strict=True):
        values = dict(zip(system.states, state, strict=True))
        normal, before = numbers(passing.normal, {}), numbers(passing.before, values)
        phi, _ = flow(field, time)
        jacobian = (np.eye(2) - before @ normal / float(passing.rate.subs(values))) @ phi @ jacobian
        monodromy = numbers(passing.saltation, values) @ phi @ monodromy
    (multiplier,) = (inverse @ jacobian @ embedding).ravel()
    assert multiplier == pytest.approx(0.538924872, abs=5e-9)
    assert monodromy.trace() == pytest.approx(1 + multiplier, rel=1e-11)


def test_an_impact_orbit_under_forcing() -> None:
    """The saltation matrix and the trivial multiplier, against the map by event location."""
    itinerary = impacts(1)
    cycle, system = cycle_of(itinerary), itinerary.system
    zeta, omega, r = (p.symbol for p in system.parameters)
    known = {zeta: 0.1, omega: 1.5, r: 0.6}
    period, field = 2 * np.pi / 1.5, field_of(system, "free", known)
    reset, amplitude = np.diag([1, -0.6, 1, 1]), 1.5

    def start_of(unknowns: np.ndarray) -> np.ndarray:
        speed, phase = unknowns
        return np.array([1, speed, amplitude * np.cos(phase), amplitude * np.sin(phase)])

    def misses(unknowns: np.ndarray) -> list[float]:
        end = flow(field, period)[0] @ start_of(unknowns)
        return [end[0] - 1, -0.6 * end[1] - unknowns[0]]

    found = [fsolve(misses, [-1.0, phase], xtol=1e-13) for phase in (0, 1, 2, 3, 4, 5)]
    start = next(start_of(u) for u in found if u[0] < 0 and max(map(abs, misses(u))) < 1e-10)
    end = flow(field, period)[0] @ start
    assert np.allclose(reset @ end, start, atol=1e-10)

    def returned(coordinates: np.ndarray) -> np.ndarray:
        begin = np.array([1, *coordinates])
        near = (period - 0.05, period + 0.05)
        time = brentq(lambda t: (flow(field, t)[0] @ begin)[0] - 1, *near, xtol=1e-14)
        return np.asarray((reset @ flow(field, time)[0] @ begin)[1:])

    step = 1e-5
    columns = [returned(start[1:] + step * e) - returned(start[1:] - step * e) for e in np.eye(3)]
    jacobian = np.array(columns).T / (2 * step)
    (line,) = (x for x in lines_of(impact_document()) if x.left == "S_{1}")
    values = known | dict(zip(system.states, end, strict=True))
    monodromy = value_of(line, values) @ flow(field, period)[0]
    wanted = sorted(np.linalg.eigvals(monodromy), key=lambda m: (abs(m - 1), m.real, m.imag))
    given = sorted(np.linalg.eigvals(jacobian), key=lambda m: (abs(m - 1), m.real, m.imag))
    assert abs(wanted[0] - 1) < 1e-6
    assert abs(wanted[1] - 1) < 1e-6
    assert abs(given[0] - 1) < 1e-6
    assert np.allclose(wanted[2:], given[1:], atol=1e-7)
    assert np.prod(given[1:]).real == pytest.approx(0.36 * np.exp(-0.2 * period), rel=1e-6)
    velocity = field[0] @ start
    assert np.allclose(monodromy @ velocity, velocity, atol=1e-9)
    (harmonic,) = cycle.harmonics
    assert harmonic.frequency == omega
    assert "1 and trivial" in to_markdown(impact_document())


def test_the_forcing_is_found_where_it_is() -> None:
    c, s = forced_stop().states[2:]
    (found,) = cycle_of(impacts(2)).harmonics
    assert (found.first, found.second, found.invariant) == (c, s, c**2 + s**2)
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
        labels = [f.label for f in document.formulas if f.label]
        assert labels == labels_by_section(document)
        (table,) = (b for b in document.section("The itinerary") if isinstance(b, Table))
        assert len(table.rows) == len(itinerary.phases)
        for swapped in itinerary.solved_for:
            text = " ".join(b.text for b in document.blocks if isinstance(b, Paragraph))
            given = re.findall(r"Given are the parameters (.*?)\.", text)[0]
            assert f"{swapped[0]}_{{{swapped[1:]}}}" not in given


def test_saltation_matrices_of_a_derived_orbit_agree() -> None:
    """Of the global-stick orbit, with those that its own document derives."""
    (itinerary,) = (o for o in declaration("dry-friction").orbits if o.name == "global-stick")
    shown = {
        line.left: line.shows
        for line in lines_of(describe_itinerary(itinerary))
        if re.fullmatch(r"S_\{\d\}", line.left)
    }
    system = itinerary.presented_system
    draw = np.random.default_rng(1)
    for index, passing in enumerate(cycle_of(itinerary).passings, start=1):
        symbols = sorted({*system.states, *(p.symbol for p in system.parameters)}, key=str)
        values = dict(zip(symbols, draw.uniform(0.2, 0.9, len(symbols)), strict=True))
        state = [values[s] for s in system.states]
        normal = numbers(passing.normal, values)[0]
        gap = normal @ state + float(passing.constant.subs(values))
        state = np.array(state) - normal * gap / (normal @ normal)
        values |= dict(zip(system.states, state, strict=True))
        source, target = passing.transition.source, passing.transition.target
        a, b = field_of(system, source, values)
        before = a @ state + b
        reset, jump = numbers(passing.reset, values), numbers(passing.jump, values)[:, 0]
        a, b = field_of(system, target, values)
        behind = a @ (reset @ state + jump) + b
        expected = reset + np.outer(behind - reset @ before, normal) / (normal @ before)
        assert np.allclose(numbers(shown[f"S_{{{index}}}"], values), expected, atol=1e-12)


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
