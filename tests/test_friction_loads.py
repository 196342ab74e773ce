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
from nonsmooth.derive import Friction, Harmonic, System, oscillator
from nonsmooth.runtime.kernels import kernels_of

MASS = np.array([[2, 0.5], [0.5, 1]])
STIFFNESS = np.array([[2, -0.4], [-0.4, 3]])
DAMPING = np.array([[0.2, 0], [0, 0.1]])
ROW = np.array([1, -0.25])  # of the direction along which friction acts
NAMES = ("mu", "excess", "V", "phi", "N0", "a", "b", "A", "w")


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


@cache
def kernels(**kind: Any) -> Any:
    return kernels_of(pad(**kind))


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

        wrapped.terminal, wrapped.direction = True, 1  # type: ignore[attr-defined]
        return wrapped


KINDS = [(True, False), (False, True), (True, True)]


@pytest.mark.parametrize(("load", "falling"), KINDS)
def test_pads_move_as_an_integrator_with_events_says(load: bool, falling: bool) -> None:
    rng, seen = np.random.default_rng(7), set[str]()
    times = np.linspace(0, 15, 61)
    for _ in range(5):
        values = drawn(rng, load=load, falling=falling)
        hand = ByHand(values)
        start = rng.uniform(-0.3, 0.3, 4)
        motion = ns.simulate(
            kernels(load=load, falling=falling), values, [*start, 1, 0], until=times[-1]
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
