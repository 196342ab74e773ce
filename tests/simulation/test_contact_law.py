"""Contacts that the mass matrix couples: order, mirror images, the minimum, proofs."""

import copy
from dataclasses import replace

import numpy as np
import pytest
import sympy as sp
from numpy.testing import assert_allclose, assert_array_equal
from scipy.optimize import minimize

import nonsmooth as ns
from nonsmooth import InputError, itinerary_of
from nonsmooth.derive import DeclarationError, Friction, Harmonic, RigidStop, oscillator
from nonsmooth.runtime.checker import Failure
from nonsmooth.runtime.events.transition_choice import Decider
from nonsmooth.runtime.model.piecewise import piecewise
from tests.certified import accepted, believed, content_of, refused, signed
from tests.engines import with_both
from tests.newton import Newton

pytestmark = pytest.mark.compiled  # much slower, or nothing to compare, without it

SIGN = sp.Symbol("sign", real=True)


def both(system, data, start, until):
    """A motion by the compiled engine, and by the one in Python."""
    motion, other = with_both(ns.simulate, system, data, start, until=until)
    return motion, other.run


def parts(seed, count, order, sign, stop=False):
    """A random chain with coupled contacts in an order, which `sign` mirrors; exact numbers.

    With a stop, that alone holds the direction of one of two contacts.
    """
    rng = np.random.default_rng(seed)

    def number(low, high):
        return sp.Rational(round(rng.uniform(low, high) * 64), 64)

    names = [f"x{i + 1}" for i in range(count)]
    spread = sp.Matrix(count, count, lambda i, j: number(-0.5, 0.5))
    full = spread * spread.T if rng.random() < 0.5 else sp.zeros(count, count)
    mass = sp.diag(*[number(0.5, 2) for _ in names]) + full
    elements = []
    for i, name in enumerate(names):
        direction = {name: 1} if i == 0 else {name: 1, names[i - 1]: -1}
        kinetic = number(0.1, 0.5)
        static = kinetic * (1 if rng.random() < 0.3 else number(1.1, 2.5))
        belt = number(-0.5, 0.5) if rng.random() < 0.4 and not stop else 0
        elements.append(Friction(direction, kinetic, static, sign * belt, name="abcd"[i]))
    loads = [number(-1.5, 1.5) * sign for _ in range(2 * count)]
    if stop:
        place, restitution = number(0.05, 0.4), number(0.1, 0.8)
        struck = elements[int(rng.integers(2))].coordinate
        side = "upper" if sign > 0 else "lower"
        elements.append(RigidStop(struck, sign * place, restitution, side=side, name="stop"))
    waves = [(1 + 2 * stop) * load for load in loads[count:]]
    return [names, mass, 3 * mass], {  # of one frequency: its flows are short
        "load": loads[:count], "forcing": [Harmonic("7/8", sine=waves)],
        "elements": [elements[i] for i in order],
    }  # fmt: skip


def drawn(*of):
    matrices, more = parts(*of)
    return oscillator("drawn", *matrices, **more)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("seed", "count", "stop"), [(2, 1, False), (3, 2, False), (4, 3, False), (17, 2, True)]
)
def test_neither_order_nor_direction_of_a_declaration_matters(seed, count, stop):
    """To motions that obey Newton's law and those of the contacts."""
    start = np.random.default_rng(seed).normal(size=2 * count) * (0 if stop else 0.4)
    if seed % 2:
        start[count:] = [0] * (count - 1) + [0.5 * stop]
    ends, touched, whole = [], not stop, range(count + stop)
    for order, sign in ((whole, 1), (whole[::-1], -1)):
        matrices, more = parts(seed, count, order, sign, stop)
        system = oscillator("drawn", *matrices, **more)
        assert (system.law is None) == (count == 1)
        motion, run = both(system, {}, [*(sign * start), 1, 0], 12.0)
        assert motion.status.name == run.status.name == "UNTIL"
        if not stop:  # where bounces accumulate, rounding tells how many there are
            assert_array_equal(motion.run.configurations, run.configurations)
            assert_allclose(motion.states, run.states, atol=1e-11)
            Newton(*matrices, **more).obeyed_by(motion)
        assert_allclose(motion(run.times[-1])[:count], run.states[-1][:count], atol=1e-7)
        touched |= any("contact" in name for name in motion.configurations)
        ends.append((motion.transitions, sign * motion(12.0)[: 2 * count]))
    assert touched
    (transitions, end), (others, other) = ends
    assert transitions == others > 1
    assert_allclose(end, other, atol=1e-7 if stop else 1e-9)


@pytest.mark.slow
@pytest.mark.parametrize(("order", "sign"), [(range(2), 1), (range(2)[::-1], -1)])
def test_motions_of_coupled_contacts_are_proved(order, sign):
    system = drawn(3, 2, order, sign)
    motion = ns.simulate(system, {}, [sign * 0.5, sign * -0.25, 0, 0, 1, 0], transitions=8)
    begin = [str(x) for x in motion.states[0]]
    proof = ns.certify.motion(system, {}, begin, motion.configurations[0], 8)
    assert proof.decided
    assert proof.configurations == tuple(motion.configurations)
    states = [[float(x) for x in state] for state in proof.states]
    assert_allclose(motion.states, states, atol=1e-9)


def test_a_step_with_a_force_exactly_at_its_limit_is_not_proved():
    """The upper block turns back: its static limit is all that the lower one holds."""
    contacts = [
        Friction("x1", kinetic=1, static=2, name="ground"),
        Friction({"x2": 1, "x1": -1}, kinetic=1, static=2, name="between"),
    ]
    system = oscillator(
        "limits", ["x1", "x2"], sp.eye(2), sp.zeros(2, 2),
        forcing=[Harmonic(1, sine=[0, 3])], elements=contacts,
    )  # fmt: skip
    proof = ns.certify.motion(system, {}, [0, 0, 0, 0, 1, 0], "stick-stick", 3)
    assert not proof.decided
    assert proof.transitions == 1
    assert "what the contact law says at between-reaches-belt" in str(proof.reason)


def least(point, state, reached):
    """What each contact of a system at rest does, by minima of the primal problem."""
    law = point.structure.law
    count = len(law.contacts)
    known = np.append(state, 1.0)
    coupling = np.array([[point.rows[row, -1] for row in each] for each in law.coupling])
    free = np.array([point.rows[row] @ known for row in law.free[""]])
    limits = [{k: point.rows[getattr(c, k)] @ known for k in ("static", "kinetic")}
              for c in law.contacts]  # fmt: skip
    inverse = np.linalg.inv(coupling)
    while True:
        bound = np.array([limits[i]["kinetic" if i in reached else "static"] for i in range(count)])

        def cost(z, bound=bound):
            change = z[:count] - free
            return float(change @ inverse @ change / 2 + bound @ z[count:])

        above = [{"type": "ineq", "fun": lambda z, s=s: z[count:] - s * z[:count]} for s in (1, -1)]
        begin = np.append(free, abs(free) + 0.1)
        found = minimize(cost, begin, method="SLSQP", constraints=above,
                         options={"ftol": 1e-15, "maxiter": 500}).x[:count]  # fmt: skip
        moves = np.where(abs(found) < 1e-5, 0, np.sign(found))
        slipping = set(np.flatnonzero(moves).tolist())
        if slipping <= reached:
            return [{0: "stick", 1: "overshoot", -1: "slip"}[int(m)] for m in moves]
        reached = reached | slipping


@pytest.mark.slow
@pytest.mark.parametrize(("seed", "count", "sign"), [(5, 2, SIGN), (4, 3, 1)])
def test_the_choice_is_the_minimum(seed, count, sign, monkeypatch):
    """And what minimises is tried first: nothing else has to be, where nothing is tied."""
    monkeypatch.setattr("nonsmooth.runtime.events.transition_choice.product", None)
    system = drawn(seed, count, range(count), sign)
    point = piecewise(system, {str(p.symbol): 1 for p in system.parameters})
    law = point.structure.law
    decider = Decider(point.structure, point.fields, point.rows, point.resets)
    rng, seen = np.random.default_rng(seed), set()
    speeds = np.array([-point.rows[c.relative][-1] for c in law.contacts])
    directions = np.array([point.rows[c.relative][count : 2 * count] for c in law.contacts])
    velocities = np.linalg.solve(directions, speeds)
    source = point.structure.configuration("-".join(["stick"] * count))
    for _ in range(25):
        state = np.array([*rng.normal(size=count) * 0.6, *velocities, 1.0, 0.0])
        place = int(rng.integers(count))
        known = np.append(state, 1.0)
        shape = next(
            b for b, s in enumerate(point.structure.boundaries[source])
            if law.limits.get(s.name) == place
        )  # fmt: skip
        found = decider.choice(
            source, frozenset({shape}), decider.located(source, known, 0.0)
        ).transition
        expected = "-".join(least(point, state, {place}))
        assert point.structure.configurations[found.target] == expected
        seen.add(expected)
    assert len(seen) > 3


def test_forces_that_are_not_unique_are_ambiguous():
    contacts = [
        Friction("x1", 1, 2, name="first"),
        Friction("x2", 1, 2, name="second"),
        Friction({"x2": 1, "x1": -1}, 1, 2, name="between"),
    ]
    system = oscillator("three", ["x1", "x2"], sp.eye(2), sp.eye(2), elements=contacts)
    with pytest.raises(InputError, match="the laws of contact leave open to which of"):
        ns.simulate(system, {}, [0.1, 0, 0, 0], until=1.0)


def stops(law, reverse=False):
    pair = [RigidStop("x1", 1, 0.5, name="a"), RigidStop({"x2": 1, "x1": -1}, 1, 0.5, name="b")]
    return oscillator(
        "two", ["x1", "x2"], sp.eye(2), sp.zeros(2, 2),
        elements=pair[::-1] if reverse else pair, simultaneous_impacts=law,
    )  # fmt: skip


@pytest.mark.parametrize("reverse", [False, True])
def test_stops_at_one_instant_are_ambiguous_without_a_law(reverse):
    motion, second = both(stops(None, reverse), {}, [0, 0, 1, 2], 1.5)
    assert motion.status.name == second.status.name == "AMBIGUOUS"
    assert motion.end == pytest.approx(1.0)
    assert motion.options == ("free-free",)
    assert motion.run.options == second.options
    assert motion.open_at == ("a-reaches-stop", "b-reaches-stop")[:: -1 if reverse else 1]
    assert motion.run.open_at == second.open_at
    assert motion.message.endswith(
        f"orders in which {' and '.join(motion.open_at)} act do not agree"
    )


STRUCK = """
import sympy as sp
from nonsmooth.derive import RigidStop, oscillator
pair = [RigidStop("x1", 1, "1/2"), RigidStop({"x2": 1, "x1": -1}, 1, "1/2")]
system = oscillator("struck", ["x1", "x2"], sp.eye(2), sp.zeros(2, 2), elements=pair)
"""


@pytest.mark.parametrize("ending", ["csv", "npz"])
def test_the_options_of_an_ambiguous_motion_are_kept(ending, tmp_path):
    (tmp_path / "struck.py").write_text(STRUCK)
    motion = ns.simulate(str(tmp_path / "struck.py"), {}, [0, 0, 1, 2], until=1.5)
    motion.save(tmp_path / f"motion.{ending}")
    again = ns.load(tmp_path / f"motion.{ending}")
    assert again.status.name == "AMBIGUOUS"
    assert again.options == motion.options == ("free-free",)
    assert again.message == motion.message
    ended = ns.simulate(str(tmp_path / "struck.py"), {}, [0, 0, 1, 2], until=0.5).status
    other = replace(motion.run, status=ended)
    replace(motion, run=other).save(tmp_path / f"other.{ending}")
    with pytest.raises(InputError, match="it holds options, though it ended as 'until'"):
        ns.load(tmp_path / f"other.{ending}")


@pytest.mark.parametrize(
    ("law", "reverse", "expected"),
    [
        ("sequence", False, [0.9609375, 1.7578125]),
        ("sequence", True, [0.826171875, 1.822265625]),
        ("moreau", False, [0.75, 1.5]),
        ("moreau", True, [0.75, 1.5]),
    ],
)
def test_stops_at_one_instant_by_a_law(law, reverse, expected):
    motion, second = both(stops(law, reverse), {}, [0, 0, 1, 2], 1.5)
    assert_allclose(motion(1.5)[:2], expected, atol=1e-12)
    assert_allclose(second.states, motion.states, atol=1e-13)


def test_stops_that_do_not_interact_need_no_law():
    pair = [RigidStop("x1", 1, 0.5), RigidStop("x2", 1, 0.25)]
    system = oscillator("two", ["x1", "x2"], sp.eye(2), sp.eye(2), elements=pair)
    motion, _ = both(system, {}, [0, 0, 2, 2], 1.0)
    assert_allclose(motion.states[1], [1, 1, -np.sqrt(0.75), -np.sqrt(3) / 4])
    with pytest.raises(DeclarationError, match="simultaneous_impacts is 'together'"):
        stops("together")


SLIDING = """
import sympy as sp
from nonsmooth.derive import Friction, Harmonic, oscillator
contacts = [
    Friction("x1", "1/5", "2/5", name="ground"),
    Friction({"x2": 1, "x1": -1}, "3/10", "9/20", name="between"),
]
system = oscillator(
    "sliding", ["x1", "x2"], sp.eye(2), [[1, 0], [0, "1/2"]], [["1/10", 0], [0, "1/10"]],
    forcing=[Harmonic("4/5", {"x1": 1, "x2": "3/10"})], elements=contacts,
)
"""


def settled(folder, text):
    """The orbit of a file's system to which its motion comes, and a guess of it."""
    file = folder / "declared.py"
    file.write_text(text)
    motion = ns.simulate(str(file), {}, [0, 0.1, 0.1, 0, 1, 0], transitions=300)
    itinerary, dwell, start = itinerary_of(motion)
    guess = [*dwell, *start]
    return ns.solve(str(file), {}, guess, itinerary=itinerary), guess


def saved(proof, folder):
    """What the file of a proof holds."""
    check = accepted(proof, folder)
    assert {*check.claims.values()} == {"proved"}
    assert check.compared
    return content_of(proof)


def test_an_orbit_through_coupled_contacts_is_proved_and_checked(tmp_path):
    orbit, _ = settled(tmp_path, SLIDING)
    assert orbit.admissibility.verdict is True
    content = saved(ns.certify(orbit), tmp_path)
    taken = content["declaration"]["transitions"][0]
    assert len(taken["steps"]) == 2

    def wrong(change):
        other = copy.deepcopy(content)
        change(other["declaration"])
        refused(other)

    wrong(lambda d: d["transitions"][0].update(target="stick-stick"))
    wrong(lambda d: d["transitions"][0]["steps"].pop(0))
    wrong(lambda d: d["transitions"][0]["steps"][1].update(kinetic=[]))
    wrong(lambda d: d["transitions"][0]["conditions"].pop())
    wrong(lambda d: d["law"]["contacts"][0].update(static=d["law"]["contacts"][1]["static"]))
    wrong(lambda d: d["law"].update(limits=d["law"]["arrivals"]))
    wrong(lambda d: d["law"].pop("free"))


def test_half_of_an_orbit_through_coupled_contacts_and_its_mirror_image(tmp_path):
    whole, guess = settled(tmp_path, SLIDING)
    itinerary, phases = whole.itinerary, len(whole.itinerary)
    count = phases // 2
    turned = {name: f"-{name}" for name in ("x1", "x2", "v1", "v2", "c1", "s1")}
    guess = [*guess[:count], *guess[phases:]]
    file = str(tmp_path / "declared.py")
    half = ns.solve(file, {}, guess, itinerary=itinerary[:count], symmetry=turned)
    assert half.itinerary == whole.itinerary
    assert half.admissibility.verdict is True
    assert_allclose(half.states, whole.states, atol=1e-12)
    assert set(ns.certify(half).claims.values()) == {"proved"}


CRAWLING = (
    SLIDING.replace('[[1, 0], [0, "1/2"]]', "sp.Matrix([[1, -1], [-1, 1]]) / 2")
    .replace('[["1/10", 0], [0, "1/10"]]', "sp.Matrix([[1, -1], [-1, 1]]) / 10")
    .replace('{"x1": 1, "x2": "3/10"}', '{"x1": 2, "x2": -1}')
)


def test_a_shift_changes_nothing_that_the_law_is_told(tmp_path):
    orbit, _ = settled(tmp_path, CRAWLING)
    content = saved(ns.certify(orbit), tmp_path)
    assert content["closing"]["translations"] == [["1", "1", "0", "0", "0", "0"]]
    law = content["declaration"]["law"]
    rows = [c[name] for c in law["contacts"] for name in ("static", "kinetic", "slipping")]
    reasons = []
    for row in (*rows, *(row for free in law["free"].values() for row in free)):
        kept, row[0] = row[0], "1/100"  # it depends on where the lower block is
        with pytest.raises(Failure) as caught:
            believed(signed(content))
        reasons.append(str(caught.value))
        row[0] = kept
    # of a limit that no condition has
    assert any(reason.endswith("no translation of the system") for reason in reasons)
