"""The sections of benchmark.py that simulate: one motion, many motions, wrong sequences."""

from __future__ import annotations

import multiprocessing
import time
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from benchmarking.measuring import Row, interleaved

from nonsmooth.runtime.model.engine_layout import numbers_of
from nonsmooth.runtime.model.engine_run import Run
from nonsmooth.runtime.model.kernels import compiled_engine, kernels_of, load_system
from nonsmooth.runtime.model.parameters import parameter_points
from nonsmooth.runtime.model.piecewise import PiecewiseLinear, numbers_at, piecewise
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.table_many import solve_itineraries
from nonsmooth.runtime.shooting.shooting_map import itinerary_shape
from nonsmooth.runtime.shooting.table_newton import solve_shape
from nonsmooth.runtime.simulation.engines import run_motions
from nonsmooth.runtime.simulation.simulate import follow, simulate_many
from nonsmooth.runtime.simulation.starting import configuration_of

DATA = {
    "A": dict(chi="0.5", eta=1, V=1, us1=1, us2=1, ur1="4.0195", ur2="1.4831"),
    "B": dict(chi="0.4", eta=4, V="0.6773", us1="0.0127", ur1="0.0255", us2="0.5", ur2=1),
}
START = np.array([0.1, 0.2, 0.3, -0.1])


def simulation(quick: bool) -> Iterator[Row]:
    """One motion, per transition."""
    engine = compiled_engine()
    few = 20 if quick else 60
    count = 100_000 if quick else 1_000_000
    for name, must in (("A", 1 / 1.5e6), ("B", 1 / 1e6)):
        system = piecewise("dry-friction", DATA[name])

        def ours(system: PiecewiseLinear = system) -> object:
            numbers, zero = numbers_of(system)[None], np.zeros(1, dtype=int)
            until = np.array([np.inf])
            return run_motions(
                engine, system.structure, numbers, zero, START[None], zero, until, count
            )

        works = {f"{name}: engine": (ours, float(count))}
        works[f"{name}: DOP853, rtol 1e-10"] = (lambda s=system: dop853(s, START, few), few)
        taylor = heyoka_motion(system)
        if taylor is not None:
            works[f"{name}: heyoka, nudged"] = (lambda t=taylor: t(START, 2000), 2000.0)
        for label, seconds in interleaved(works, 3 if quick else 7).items():
            same = label == f"{name}: engine"
            yield Row(label, seconds, must if same else None, None if same else f"{name}: engine")


def composed(quick: bool) -> Iterator[Row]:
    """Four phases without kernels of their own, per solve, parameters varying."""
    phases = [
        ("stick-stick", "first-breaks-forward"),
        ("slip-stick", "second-breaks-forward"),
        ("slip-slip", "first-reaches-belt"),
        ("stick-slip", "second-reaches-belt"),
    ]
    count = 5_000 if quick else 20_000
    rng = np.random.default_rng(3)
    varied = {name: rng.uniform(0.98, 1.02, count) for name in ("eta", "V")}
    values = {name: float(value) for name, value in DATA["A"].items()} | varied
    guess = np.array([1.02, 2.0, 1.57, 3.28])
    kernels = load_system("dry-friction")
    points, _ = parameter_points(kernels, values)
    cycle = itinerary_shape(structure_of(kernels), phases)
    (group,) = numbers_at(kernels, points[:256])
    dwell, free = np.tile(guess, (256, 1)), np.full(256, np.nan)

    def engine() -> None:
        for _ in range(20):
            solve_shape(cycle, group.flat, dwell, None, free)

    def whole() -> object:
        return solve_itineraries(kernels_of("dry-friction"), phases, values, guess, threads=1)

    works = {"engine": (engine, 20 * 256.0), "compose_many": (whole, float(count))}
    for label, seconds in interleaved(works, 5 if quick else 15).items():
        yield Row(label, seconds, 5e-6 if label == "engine" else None)


def many(quick: bool) -> Iterator[Row]:
    """Ten thousand starts, per start: two threads against two processes."""
    count, transitions = (2_000 if quick else 10_000), 100
    starts = np.random.default_rng(5).normal(size=(count, 4)) * 2

    def threads() -> object:
        return simulate_many("dry-friction", DATA["A"], starts, transitions=transitions, threads=2)

    halves = [(half, transitions) for half in np.array_split(starts, 2)]
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        works = {
            "two threads": (threads, float(count)),
            "two processes": (lambda: pool.map(_half, halves, 1), float(count)),
        }
        for label, seconds in interleaved(works, 5 if quick else 15).items():
            yield Row(label, seconds, against=None if label == "two threads" else "two threads")


def _half(task: tuple[np.ndarray, int]) -> float:
    starts, transitions = task
    ends = simulate_many("dry-friction", DATA["A"], starts, transitions=transitions, threads=1)
    return float(ends.times.sum())


def sequences(quick: bool) -> Iterator[Row]:
    """Random motions of 40 transitions, per motion; the last column counts wrong sequences."""
    rng = np.random.default_rng(11)
    count = 30 if quick else 1000
    wrong = {"engine": 0, "DOP853": 0}
    seconds: dict[str, list[float]] = {name: [] for name in wrong}
    from nonsmooth.runtime.simulation.stepping import run as reference

    tried = 0
    for i in range(count):
        system, state = random_motion(rng)
        start = configuration_of(system, state)
        truth = reference(system, state, start, transitions=40)
        begin = time.perf_counter()
        found = follow(system, state, start, transitions=40)
        seconds["engine"].append(time.perf_counter() - begin)
        wrong["engine"] += not same(found, truth)
        if i % 10 == 0:
            tried += 1
            begin = time.perf_counter()
            sequence = dop853(system, state, 40, start)
            seconds["DOP853"].append(time.perf_counter() - begin)
            wrong["DOP853"] += sequence != truth.configurations.tolist()
    for name, total in (("engine", count), ("DOP853", tried)):
        yield Row(f"{name}: {wrong[name]} of {total} wrong", seconds[name])


def random_motion(rng: np.random.Generator) -> tuple[PiecewiseLinear, np.ndarray]:
    """A friction oscillator with seven random parameters, and a start."""
    us1, us2 = rng.uniform(0.05, 2, 2)
    parameters = {
        "chi": rng.uniform(0.1, 0.9),
        "eta": rng.uniform(0.2, 4),
        "V": rng.uniform(0.2, 2),
        "us1": us1,
        "ur1": us1 * rng.uniform(1, 3),
        "us2": us2,
        "ur2": us2 * rng.uniform(1, 3),
    }
    return piecewise("dry-friction", parameters), rng.normal(size=4) * 2


def same(one: Run, other: Run) -> bool:
    """Whether two motions have one sequence of configurations and boundaries."""
    return bool(
        np.array_equal(one.configurations, other.configurations)
        and np.array_equal(one.sets, other.sets)
    )


def _next(system: PiecewiseLinear, c: int, reached: int, y: np.ndarray) -> tuple[int, np.ndarray]:
    """Next configuration and state behind one boundary, as a user of an integrator writes it."""
    for transition in system.structure.transitions[c]:
        if transition.boundaries != {reached}:
            continue
        met = True
        for row, along, holds in transition.conditions:
            value = system.rows[row] @ np.append(y, 1.0)
            if abs(value) < 1e-7:
                field = system.fields[along]
                value = system.rows[row][:-1] @ (field @ np.append(y, 1.0))
            met = met and (value > 0) == holds
        if met:
            matrix = system.resets[transition.reset]
            return transition.target, matrix[:, :-1] @ y + matrix[:, -1]
    raise RuntimeError("no transition applies")


def dop853(
    system: PiecewiseLinear, state: np.ndarray, transitions: int, configuration: int = 0
) -> list[int]:
    """Configurations of a motion by solve_ivp with event detection."""
    from scipy.integrate import solve_ivp

    y, c, found = np.array(state), configuration, [configuration]
    for _ in range(transitions):
        field = system.fields[c]
        matrix, offset = field[:, :-1], field[:, -1]
        events = []
        for boundary in system.structure.boundaries[c]:
            row = system.rows[boundary.row]

            def height(_: float, y: np.ndarray, row: np.ndarray = row) -> float:
                return float(row[:-1] @ y + row[-1])

            event: Any = height  # solve_ivp reads attributes of the function
            event.terminal, event.direction = True, 1.0
            events.append(event)
        solution = solve_ivp(
            lambda _, y, a=matrix, b=offset: a @ y + b,
            (0.0, 1e3),
            y,
            method="DOP853",
            rtol=1e-10,
            atol=1e-12,
            events=events,
        )
        reached = [i for i, times in enumerate(solution.t_events) if len(times)]
        if not reached:
            break
        c, y = _next(system, c, reached[0], solution.y[:, -1])
        found.append(c)
    return found


def heyoka_motion(system: PiecewiseLinear) -> Callable[[np.ndarray, int], object] | None:
    """A Taylor integrator with an event function per boundary; None without heyoka."""
    try:
        import heyoka
    except ImportError:
        return None
    names = system.structure.states
    symbols = heyoka.make_vars(*names)

    def affine(row: np.ndarray) -> object:
        factors = zip(row.tolist()[:-1], symbols, strict=True)
        return heyoka.expression(float(row[-1])) + heyoka.sum([a * x for a, x in factors])

    integrators = []
    for c, field in enumerate(system.fields):
        rows = [system.rows[b.row] for b in system.structure.boundaries[c]]
        rising = heyoka.event_direction.positive
        events = [heyoka.t_event(affine(row), direction=rising) for row in rows]
        equations = [(s, affine(row)) for s, row in zip(symbols, field, strict=True)]
        integrators.append(heyoka.taylor_adaptive(equations, [0.0] * len(names), t_events=events))

    def follow_motion(state: np.ndarray, transitions: int) -> object:
        y, c = np.array(state), 0
        for _ in range(transitions):
            integrator = integrators[c]
            integrator.time = 0.0
            integrator.reset_cooldowns()
            integrator.state[:] = y
            integrator.propagate_for(1e-15)  # the nudge: a root at the start hides the next
            outcome = integrator.propagate_until(1e3)[0]
            reached = -int(outcome.value) - 1
            if not 0 <= reached < len(system.structure.boundaries[c]):
                raise RuntimeError(f"heyoka ended with {outcome}")
            c, y = _next(system, c, reached, np.array(integrator.state))
        return y

    return follow_motion
