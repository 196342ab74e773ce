"""Time of the gradient of a motion over all parameters, in units of the simulation's own."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import Harmonic, Parameter, RigidStop, oscillator

__all__ = ["GradientTime", "gradient_times"]

_TURNS = 30


@dataclass(frozen=True)
class GradientTime:
    """Seconds of one motion, and of its derivatives behind it."""

    masses: int
    transitions: int
    parameters: int
    simulation: float
    forward: float
    reverse: float


def gradient_times() -> list[GradientTime]:
    """Chains of 2 to 5 masses with a stop, through 5, 50 and 200 transitions.

    Returns
    -------
    list of GradientTime
        Medians of runs that alternate in one process.
    """
    return [_time(masses, count) for masses in (2, 3, 5) for count in (5, 50, 200)]


def _chain(masses: int) -> tuple[ns.derive.System, dict[str, float]]:
    """A forced chain with a rigid stop at its end, and its parameters."""
    data = {f"m{i}": 1 + 0.1 * i for i in range(1, masses + 1)}
    data |= {f"k{i}": 2 + 0.3 * i for i in range(1, masses + 1)}
    data |= {"d": 0.02, "gap": 0.3, "r": 0.8, "F": 1.0, "w": 1.1}
    found = [Parameter(name, name) for name in data]
    symbols = {p.name: p.symbol for p in found}
    stiffness = sp.zeros(masses)
    for i in range(masses):
        spring = symbols[f"k{i + 1}"]
        stiffness[i, i] += spring
        if i:
            stiffness[i - 1, i - 1] += spring
            stiffness[i, i - 1] -= spring
            stiffness[i - 1, i] -= spring
    names = [f"x{i}" for i in range(1, masses + 1)]
    system = oscillator(
        f"chain-{masses}",
        names,
        sp.diag(*[symbols[f"m{i}"] for i in range(1, masses + 1)]),
        stiffness,
        damping=symbols["d"] * stiffness,
        forcing=[Harmonic(symbols["w"], cosine={"x1": symbols["F"]})],
        elements=[RigidStop(names[-1], symbols["gap"], symbols["r"])],
        parameters=found,
    )
    return system, data


def _time(masses: int, transitions: int) -> GradientTime:
    system, data = _chain(masses)
    state = {name: 0.0 for name in (f"{a}{i}" for a in "xv" for i in range(1, masses + 1))}
    parameters = list(data)

    def simulate() -> ns.Trajectory:
        return ns.simulate(system, data, state, transitions=transitions)

    motion = simulate()
    factors = np.ones((transitions + 1, len(motion.names)))

    def forward() -> None:
        assert motion.derivatives(parameters).behind.size

    def reverse() -> None:
        motion.derivatives(parameters).vjp(behind=factors)

    taken = np.array([[_seconds(work) for work in (simulate, forward, reverse)]
                      for _ in range(_TURNS)])  # fmt: skip
    return GradientTime(masses, transitions, len(parameters), *np.median(taken, axis=0).tolist())


def _seconds(work: Callable[[], object]) -> float:
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin


if __name__ == "__main__":
    for found in gradient_times():
        print(
            f"{found.masses} masses, {found.transitions:>3} transitions,"
            f" {found.parameters} parameters: simulation {found.simulation * 1e3:.2f} ms,"
            f" forward {found.forward / found.simulation:.2f},"
            f" reverse {found.reverse / found.simulation:.2f} of it"
        )
