"""Time of gradients over all parameters: of a motion, and of batches of orbits."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy as sp
from benchmarking.measuring import Row

import nonsmooth as ns
from nonsmooth.derive import Harmonic, Parameter, RigidStop, oscillator
from nonsmooth.runtime.orbits.directions import derivatives_of_many
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.simulation.trajectory import Trajectory

_TURNS = 30
_BATCHES = 9


@dataclass(frozen=True)
class GradientTime:
    """Seconds of one motion, and of its derivatives after it."""

    masses: int
    transitions: int
    parameters: int
    simulation: float
    forward: float
    reverse: float


def gradient_times() -> list[GradientTime]:
    """Times for chains of 2 to 5 masses with a stop, through 5, 50 and 200 transitions.

    They are medians of runs that alternate in one process.
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

    def simulate() -> Trajectory:
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


@dataclass(frozen=True)
class BatchTime:
    """Seconds of a batch of orbits without admissibility, and of its derivatives after it."""

    name: str
    points: int
    parameters: int
    solve: float
    derivatives: float


def batch_times(points: int) -> list[BatchTime]:
    """Times for batches by kernels, by tables of the same systems, and of a forced chain.

    Each batch has so many points near its reference point, on one thread; a time is the
    best of several runs.
    """
    return [_batch(name, points, *given) for name, given in _batches()]


def _batches() -> Iterator[tuple[str, tuple[Any, dict[str, float], Any]]]:
    """Name of each batch, what is solved with which parameters, and options of the solve."""
    names = (
        "rigid-stop/one-impact",
        "elastic-stop/one-contact",
        "dry-friction/symmetric",
        "dry-friction/global-stick",
    )
    for name in names:
        orbit = ns.solve(name)
        yield name, (name, {key: float(value) for key, value in orbit.given.items()}, {})
    for name in (names[1], names[3]):
        orbit = ns.solve(name)
        tables = orbit.problem.by_tables(orbit)
        evaluation: Any = tables.evaluation
        given = {"period": float(tables.period)} if evaluation.family else None
        data = {key: float(value) for key, value in tables.parameters.items()}
        yield f"{name} by tables", (orbit.system.name, data, _along(tables, given))
    for masses in (1, 2, 3):
        system, data = _chain(masses)
        found = ns.find_orbits(system, data, 40, rng=1).orbits
        orbit = min(found, key=lambda one: len(one.itinerary)).orbit
        yield f"forced chain of {masses}", (system, data, _along(orbit, None))


def _along(orbit: Orbit, given: dict[str, float] | None) -> dict[str, Any]:
    guess = [*orbit.dwell_times, *orbit.states[0]]
    return {"guess": guess, "itinerary": orbit.itinerary, "given": given}


def _batch(name: str, points: int, system: Any, data: dict[str, float], told: Any) -> BatchTime:
    random = np.random.default_rng(0)
    values = {key: x * (1 - 1e-4 * random.uniform(0, 1, points)) for key, x in data.items()}
    options = {**told, "admissibility": False, "threads": 1}
    found = ns.solve(system, values, **options)
    assert found.converged.mean() > 0.9, name

    def solve() -> None:
        ns.solve(system, values, **options)

    def differentiate() -> None:
        derivatives_of_many(found, list(data), 1)

    taken = [[_seconds(work) for work in (solve, differentiate)] for _ in range(_BATCHES)]
    return BatchTime(name, points, len(data), *np.min(taken, axis=0).tolist())


def _seconds(work: Callable[[], object]) -> float:
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin


def derivatives(quick: bool) -> Iterator[Row]:
    """Gradients over all parameters, in seconds: at most five simulations, or five solves."""
    for found in gradient_times()[:: 4 if quick else 1]:
        label = f"{found.masses} masses, {found.transitions} transitions"
        yield Row(f"{label}: simulation", [found.simulation])
        told = f"{found.parameters} parameters"
        yield Row(f"{label}: forward", [found.forward], 5 * found.simulation, found=told)
        yield Row(f"{label}: reverse", [found.reverse], 5 * found.simulation, found=told)
    for batch in batch_times(2000 if quick else 10_000):
        label, told = f"{batch.points:,} orbits, {batch.name}", f"{batch.parameters} parameters"
        yield Row(f"{label}: solve", [batch.solve])
        yield Row(f"{label}: derivatives", [batch.derivatives], 5 * batch.solve, found=told)
