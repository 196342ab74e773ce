"""Friction whose normal load vanishes or whose force is exhausted: laws, and other integrators."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp

import nonsmooth as ns
from nonsmooth.derive import Friction, Harmonic, RigidStop, SoftStop, System, oscillator
from nonsmooth.runtime.model.piecewise import piecewise

pytestmark = pytest.mark.compiled  # much slower, or nothing to compare, without it

MASS = np.array([[2, 0.5], [0.5, 1]])
STIFFNESS = np.array([[2, -0.4], [-0.4, 3]])
DAMPING = np.array([[0.2, 0], [0, 0.1]])
ROW = np.array([1, -0.25])  # of the direction along which friction acts
NAMES = ("mu", "excess", "V", "phi", "N0", "a", "b", "A", "w")


@cache
def pad(*, load: bool, falling: bool, side: int = 1, image: int = 1) -> System:
    """A pad on a belt that is pressed by N0 - a y - b y'.

    `side` -1 declares the direction and its belt the other way round, `image` -1 the mirror
    image of the whole.
    """
    mu, excess, V, phi, N0, a, b, A, w = sp.symbols(" ".join(NAMES))
    y, v = sp.symbols("y v_y")
    friction = Friction(
        dict(zip("xy", (side * ROW).tolist(), strict=True)), mu, mu + excess,
        velocity=side * image * V, falling=phi if falling else 0,
        normal=N0 - image * (a * y + b * v) if load else N0, name="pad",
    )  # fmt: skip
    forcing = Harmonic(w, {"y": image * A})
    return oscillator(
        "pad", ["x", "y"], MASS, STIFFNESS, DAMPING, forcing=[forcing], elements=[friction]
    )


def drawn(rng: np.random.Generator, *, load: bool, falling: bool) -> dict[str, float]:
    low, high = (0.2, 0, 0.1, 0.1, 0.4, 0.5, 0, 1, 0.5), (0.8, 0.3, 1, 0.5, 1.5, 3, 0.3, 5, 2)
    values = dict(zip(NAMES, np.round(rng.uniform(low, high), 3).tolist(), strict=True))
    unused = [*(() if load else ("a", "b")), *(() if falling else ("phi",))]
    return {name: value for name, value in values.items() if name not in unused}


class ByHand:
    """The law once more, with an integrator's events: one state without force, not three."""

    def __init__(self, values: dict[str, float]) -> None:
        self.p = {name: values.get(name, 0.0) for name in NAMES}

    def load(self, state: np.ndarray) -> float:
        return float(self.p["N0"] - self.p["a"] * state[1] - self.p["b"] * state[3])

    def relative(self, state: np.ndarray) -> float:
        return float(ROW @ state[2:4] - self.p["V"])

    def short(self, state: np.ndarray) -> float:
        """What the kinetic force lacks: none of it is left where this is positive."""
        slope = self.p["phi"] * abs(self.relative(state))
        return slope - (self.p["mu"] if self.p["phi"] else 1.0) * self.load(state)

    def needed(self, time: float, state: np.ndarray) -> float:
        """The force that holds the pad on its belt."""
        spread = np.linalg.solve(MASS, ROW)
        return float(-(spread @ self.forces(time, state)) / (ROW @ spread))

    def excess(self, time: float, state: np.ndarray) -> float:
        limit = (self.p["mu"] + self.p["excess"]) * self.load(state)
        return abs(self.needed(time, state)) - limit

    def forces(self, time: float, state: np.ndarray) -> np.ndarray:
        drive = np.array([0, self.p["A"] * math.cos(self.p["w"] * time)])
        return np.asarray(drive - STIFFNESS @ state[:2] - DAMPING @ state[2:4])

    def rates(self, time: float, state: np.ndarray, mode: str) -> np.ndarray:
        friction = 0.0
        if mode == "stick":
            friction = self.needed(time, state)
        elif mode != "none":
            sign = 1 if mode == "slip" else -1
            friction = sign * self.p["mu"] * self.load(state)
            friction += self.p["phi"] * self.relative(state)
        forces = self.forces(time, state) + friction * ROW
        return np.concatenate([state[2:4], np.linalg.solve(MASS, forces)])

    def next(self, time: float, state: np.ndarray, mode: str, event: int) -> str:
        if mode == "none":
            return "slip" if self.relative(state) < 0 else "overshoot"
        if mode == "stick":
            return "slip" if self.needed(time, state) > 0 else "overshoot"
        if event == 0:
            return "none"
        if self.excess(time, state) < 0:
            return "stick"
        return "slip" if self.needed(time, state) > 0 else "overshoot"

    def run(self, start: np.ndarray, mode: str, times: np.ndarray) -> tuple[np.ndarray, list[str]]:
        """States at times, and the modes on the way."""
        found, modes, time, state = [], [mode], 0.0, start
        while True:
            lost = {"none": -1, "stick": 0}.get(mode, 1)

            def ends(t: float, y: np.ndarray, lost: int = lost) -> float:
                return self.excess(t, y) if lost == 0 else lost * self.short(y)

            def meets(_: float, y: np.ndarray, sign: int = 1 if mode == "slip" else -1) -> float:
                return sign * self.relative(y)

            events: list[Any] = [ends] if mode in ("none", "stick") else [ends, meets]
            for event in events:
                event.terminal, event.direction = True, 1
            answer = solve_ivp(
                self.rates, (time, times[-1]), state, "DOP853", args=(mode,), rtol=1e-12,
                atol=1e-13, events=[self._with(e) for e in events], dense_output=True,
            )  # fmt: skip
            end = answer.t[-1]
            found += [answer.sol(t) for t in times if time <= t < end]
            if answer.status != 1:
                found.append(answer.y[:, -1])
                return np.array(found), modes
            which = next(k for k, hit in enumerate(answer.t_events) if hit.size)
            time, state = end, answer.y[:, -1]
            mode = self.next(time, state, mode, which)
            modes.append(mode)

    @staticmethod
    def _with(event: Any) -> Any:
        def wrapped(t: float, y: np.ndarray, _: str) -> float:
            return float(event(t, y))

        wrapped.terminal, wrapped.direction = True, 1  # SciPy reads them
        return wrapped


KINDS = [
    *(pytest.param(*kind, marks=pytest.mark.slow) for kind in ((True, False), (False, True))),
    (True, True),
]


@pytest.mark.slow
@pytest.mark.parametrize(("load", "falling"), KINDS)
def test_pads_move_as_an_integrator_with_events_says(load: bool, falling: bool) -> None:
    rng, seen = np.random.default_rng(7), set[str]()
    times = np.linspace(0, 15, 61)
    for _ in range(3):
        values = drawn(rng, load=load, falling=falling)
        hand = ByHand(values)
        start = rng.uniform(-0.3, 0.3, 4)
        motion = ns.simulate(
            pad(load=load, falling=falling), values, [*start, 1, 0], until=times[-1]
        )
        assert motion.end == times[-1]
        seen |= set(motion.configurations)
        first = motion.configurations[0]
        mode = "none" if first.startswith(("lifted", "exhausted")) else first
        states, modes = hand.run(start, mode, times)
        assert np.abs(motion(times)[:, :4] - states).max() < 1e-8
        told = ["none" if c.startswith(("l", "e")) else c for c in motion.configurations]
        assert [m for m, before in zip(told, ["", *told], strict=False) if m != before] == modes
    wanted = {"slip", "stick"} | ({"lifted"} if load else set())
    assert seen >= wanted | ({"exhausted-slip"} if falling else set())


@cache
def rubbing(what: str) -> Any:
    """Contacts that lift and are exhausted, alone and beside others, with random numbers."""
    rng = np.random.default_rng(len(what))
    x, y, v, w = sp.symbols("x y v v_y")

    def between(low: float, high: float) -> float:
        return round(float(rng.uniform(low, high)), 3)

    def pad(**options: Any) -> Friction:
        mu, speed = between(0.3, 0.6), between(-0.5, 0.5)
        return Friction("x", mu, round(1.2 * mu, 3), velocity=speed, name="pad", **options)

    load = between(0.3, 0.6) - between(0.5, 2) * y + between(-0.3, 0.3) * w
    wall = RigidStop({"x": 1, "y": 0.5}, at=between(0.1, 0.4), restitution=0.6, name="wall")
    stop = {"at": between(0.1, 0.2), "stiffness": between(5, 15), "name": "soft"}
    gap, force = (SoftStop("y", damping=0.8, released=r, **stop) for r in ("gap", "force"))
    elements = {
        "exhausted pad and wall": [pad(normal=load, falling=0.3), wall],
        "soft stop": [SoftStop("y", **stop), pad(normal="soft", falling=0.2)],
        "damped soft stop": [pad(normal=gap), gap],
        "released soft stop": [force, pad(normal=force)],
        "two": [pad(normal=load), Friction("y", 0.1, normal=0.3 + 2 * x - 0.2 * v, name="guide")],
    }
    forcing = Harmonic(1.3, {"x": between(-1, 1), "y": between(1.5, 2)})
    return oscillator(
        "rubbing", ["x", "y"], np.eye(2), STIFFNESS, DAMPING,
        forcing=[forcing], elements=elements[what],
    )  # fmt: skip


RUBBING = ("exhausted pad and wall", "soft stop", "damped soft stop", "released soft stop", "two")


@pytest.mark.parametrize(
    "what",
    [
        *(pytest.param(what, marks=pytest.mark.slow) for what in (RUBBING[0], RUBBING[-1])),
        *RUBBING[1:-1],
    ],
)
def test_friction_stays_within_the_cone_of_its_load_and_brakes(what: str) -> None:
    rng = np.random.default_rng(len(what))
    system = piecewise(rubbing(what), {})
    seen = set[str]()
    for _ in range(4):
        start = rng.uniform([-0.3, -0.3, -1, -1], [0, 0, 1, 1])
        motion = ns.simulate(rubbing(what), {}, [*start, 1, 0], until=12.0)
        assert motion.end == 12.0
        seen |= set(motion.configurations)
        times = np.sort(rng.uniform(0, 12, 100))
        states = np.column_stack([motion(times), np.ones_like(times)])
        places = np.searchsorted(motion.times, times, side="right") - 1
        for contact in system.structure.contacts:
            if not contact.name.endswith("-friction"):
                continue
            part = contact.name.removesuffix("-friction")
            for place, state in zip(places, states, strict=True):
                name = motion.configurations[place]
                c = system.structure.configurations.index(name)
                relative = (system.rows[contact.velocity] - system.rows[contact.surface]) @ state
                row = contact.forces.get(c)
                force = 0.0 if row is None else float(system.rows[row] @ state)
                assert force * relative < 1e-9
                names = {b.name: b.row for b in system.structure.boundaries[c]}
                if f"{part}-lifts" in names:
                    assert system.rows[names[f"{part}-lifts"]] @ state < 1e-9
                if row is None and f"{part}-lands" in names:
                    assert system.rows[names[f"{part}-lands"]] @ state < 1e-9
    assert any("lifted" in name for name in seen)


class OnSoftStop(ByHand):
    """The same on a soft stop, without a damper: its push is the load."""

    STIFFNESS, AT = 8.0, 0.1

    def load(self, state: np.ndarray) -> float:
        return float(self.STIFFNESS * (state[1] - self.AT))

    def forces(self, time: float, state: np.ndarray) -> np.ndarray:
        return super().forces(time, state) - np.array([0, max(self.load(state), 0)])


@pytest.mark.slow
@pytest.mark.parametrize("falling", [pytest.param(False, marks=pytest.mark.slow), True])
def test_a_soft_stop_bears_the_load(falling: bool) -> None:
    stop = SoftStop("y", at=OnSoftStop.AT, stiffness=OnSoftStop.STIFFNESS, name="stop")
    mu, excess, V, phi, A, w = sp.symbols("mu excess V phi A w")
    friction = Friction(
        dict(zip("xy", ROW.tolist(), strict=True)), mu, mu + excess,
        velocity=V, falling=phi if falling else 0, normal=stop, name="pad",
    )  # fmt: skip
    system = oscillator(
        "borne", ["x", "y"], MASS, STIFFNESS, DAMPING,
        forcing=[Harmonic(w, {"y": A})], elements=[stop, friction],
    )  # fmt: skip
    rng, times, seen = np.random.default_rng(3), np.linspace(0, 15, 61), set[str]()
    for _ in range(4):
        drawn_ = drawn(rng, load=False, falling=falling)
        values = {name: value for name, value in drawn_.items() if name != "N0"}
        start = np.array([0.2, -0.2, 0, 0.1])
        motion = ns.simulate(system, values, [*start, 1, 0], until=times[-1])
        assert motion.configurations[0] == "free-lifted"
        seen |= set(motion.configurations)
        states, _ = OnSoftStop(values).run(start, "none", times)
        assert np.abs(motion(times)[:, :4] - states).max() < 1e-8
    assert seen >= {"contact-slip", "contact-stick", "contact-overshoot"}


@pytest.mark.slow
def test_mirrored_declarations_have_mirrored_motions() -> None:
    """The direction taken the other way round renames slip and overshoot; so does a mirror."""
    rng = np.random.default_rng(9)
    exchanged = {"slip": "overshoot", "overshoot": "slip"}
    for _ in range(2):
        values = drawn(rng, load=True, falling=True)
        start = rng.uniform(-0.5, 0.5, 4)
        given = ns.simulate(pad(load=True, falling=True), values, [*start, 1, 0], until=15.0)
        names = ["-".join(exchanged.get(w, w) for w in n.split("-")) for n in given.configurations]
        for side, image in ((-1, 1), (1, -1)):
            other = ns.simulate(
                pad(load=True, falling=True, side=side, image=image),
                values, [*(image * start), 1, 0], until=15.0,
            )  # fmt: skip
            assert list(other.configurations) == names
            assert np.allclose(other.times, given.times, rtol=1e-12, atol=1e-12)
            assert np.allclose(other.states[:, :4], image * given.states[:, :4], atol=1e-10)


def test_a_block_without_a_force_along_its_belt_lifts_and_lands_at_rest() -> None:
    """Both limits vanish at one instant, and it lands at the velocity of the belt."""
    c = sp.Symbol("c1")
    pads = [Friction(x, 0.3, 0.4, velocity=1, normal=1 + 2 * c, name=f"{x}-pad") for x in "xy"]
    zero = np.zeros((2, 2))
    system = oscillator("blocks", ["x", "y"], MASS, zero, forcing=[Harmonic(1)], elements=pads)
    motion = ns.simulate(system, {}, [0, 0, 1, 1, 1, 0], until=10.0)
    assert motion.configurations == tuple(["stick-stick", "lifted-lifted"] * 2)
    assert np.allclose(motion.times[1:], np.array([2, 4, 8]) * math.pi / 3, atol=1e-12)
    assert np.allclose(motion(10.0)[:4], [10, 10, 1, 1], atol=1e-12)


def test_behind_an_impact_the_load_tells_the_regime() -> None:
    """The load depends on the velocity of the mass that strikes; the pad rubs on another."""
    rate, eye = sp.Symbol("v_y"), np.eye(2)
    pad = Friction("x", 0.3, velocity=1, normal=0.5 + 0.4 * rate, name="pad")
    stop = RigidStop("y", at=0, restitution=1, name="stop")
    system = oscillator("struck", ["x", "y"], eye, eye, elements=[pad, stop])
    motion = ns.simulate(system, {}, [0, -0.5, 0, 2], transitions=2)
    assert motion.configurations == ("slip-free", "lifted-free", "slip-free")
    assert motion.boundaries[1:] == (("stop-reaches-stop",), ("pad-lands",))
    # it strikes with sqrt(4.25), and the load 0.5 + 0.4 y' jumps from 1.32 to -0.32
    times = np.cumsum([0, math.atan(0.25), math.acos(1.25 / math.sqrt(4.25))])
    assert np.allclose(motion.times, times, atol=1e-13)


def test_a_plastic_impact_leaves_a_contact_at_rest() -> None:
    """On the ground, against a stop without rebound: the pad is at rest, then held."""
    pad = Friction("x", 0.3, 0.4, normal=1 + sp.Symbol("x"), falling=0.1, name="pad")
    stop = RigidStop("x", at=0.2, restitution=0, name="stop")
    system = oscillator("held", ["x"], [[1]], [[1]], load=[2], elements=[pad, stop])
    motion = ns.simulate(system, {}, [0, 0], until=5.0)
    assert motion.configurations[-1].endswith("contact")
    assert np.allclose(motion(5.0), [0.2, 0], atol=1e-14)


def test_an_orbit_with_exhausted_friction_is_certified() -> None:
    """Self-excited: the slope is above the damping, until no friction is left."""
    belt = Friction("x", 1, 1.2, velocity=1, falling=0.6, name="belt")
    system = oscillator("falling", ["x"], [[1]], [[1]], [[0.05]], elements=[belt])
    found = ns.itinerary_of(ns.simulate(system, {}, [0, 1], until=60.0))
    assert found.itinerary[:3] == (
        ("slip", "belt-exhausts"),
        ("exhausted-slip", "belt-recovers"),
        ("slip", "belt-reaches-belt"),
    )
    orbit = ns.solve(system, {}, [*found.dwell_times, *found.start], itinerary=found.itinerary)
    certificate = ns.certify(orbit)
    assert set(certificate.claims.values()) == {"proved"}
    # without friction: x'' + x'/20 + x = 0 from r = -5/3 to r = -5/3
    state, time = orbit.states[1], orbit.dwell_times[1]
    w = math.sqrt(1 - 0.025**2)
    turned = np.exp(-0.025 * time) * (
        np.cos(w * time) * state[1] - np.sin(w * time) / w * (state[0] + 0.025 * state[1])
    )
    assert state[1] == pytest.approx(1 - 5 / 3, abs=1e-12)
    assert turned == pytest.approx(1 - 5 / 3, abs=1e-12)
