"""The section of benchmark.py that compares with other programs, time and error.

Every work runs in a process of its own, with one thread.
"""

from __future__ import annotations

import json
import subprocess
import sys
import time
from collections.abc import Iterator
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
from benchmarking.measuring import Row, apart, told
from benchmarking.responses import responses
from benchmarking.simulation import simulation

import nonsmooth as ns
from nonsmooth.derive import RigidStop, oscillator, reduce_structure

# Siconos' example ImpactingBar: steel, in kg, m, s
YOUNG, DENSITY, SECTION, LENGTH = 210e9, 7800.0, 3.14e-4, 1.0
DISTANCE, SPEED, END = 5e-5, 0.1, 1.5e-3
SOUND = (YOUNG / DENSITY) ** 0.5
CONTACT = 2 * LENGTH / SOUND  # of the continuum
# and its example BouncingBall
HEIGHT, GRAVITY, BOUNCE, WATCHED = 1.0, 9.81, 0.9, 10.0


def peers(quick: bool) -> Iterator[Row]:
    """Siconos, harmonic balance, shooting, heyoka, DOP853: time, and error against exact values."""
    yield from _bar(quick)
    yield from _ball(quick)
    yield from responses(quick)
    if find_spec("heyoka") is None:
        told("heyoka is not installed (pip install heyoka): left out")
    told("friction oscillator: engine, DOP853, heyoka")
    for row in simulation(quick):
        against = row.against and f"friction {row.against}"
        yield Row(f"friction {row.what}", row.seconds, against=against)


# The bar -------------------------------------------------------------------------------------


def bar(elements: int) -> tuple[np.ndarray, np.ndarray]:
    """Mass and stiffness of a free bar of linear elements; the first coordinate is its tip."""
    length = LENGTH / elements
    mass, stiffness = np.zeros((2, elements + 1, elements + 1))
    for first in range(elements):
        here = slice(first, first + 2)
        stiffness[here, here] += YOUNG * SECTION / length * np.array([[1, -1], [-1, 1]])
        mass[here, here] += DENSITY * SECTION * length / 6 * np.array([[2, 1], [1, 2]])
    return mass, stiffness


def contact_of_elements(elements: int) -> float:
    """Duration of the tip's contact, when its reaction in SciPy's modes vanishes.

    These are the modes with the tip held.
    """
    from scipy.linalg import eigh
    from scipy.optimize import brentq

    mass, stiffness = bar(elements)
    impulse = np.linalg.solve(mass, np.eye(len(mass))[0])
    velocity = SPEED * (impulse / impulse[0] - 1)[1:]
    squares, modes = eigh(stiffness[1:, 1:], mass[1:, 1:])
    frequencies = np.sqrt(squares)
    parts = modes.T @ mass[1:, 1:] @ velocity
    parts *= (stiffness[0, 1:] @ modes) / frequencies - (mass[0, 1:] @ modes) * frequencies

    def reaction(when: float) -> float:
        return float(np.sin(frequencies * when) @ parts)

    grid = np.linspace(0, 1.1 * CONTACT, 20_000)[1:]
    negative = next(k for k, when in enumerate(grid) if reaction(when) < 0)
    return float(brentq(reaction, grid[negative - 1], grid[negative], xtol=1e-20))


def our_bar(elements: int, modes: int | None) -> tuple[float, list[float], list[float], float]:
    """Seconds of the first and of further answers, times of events, and share of energy kept."""
    from scipy.sparse import csc_array

    mass, stiffness = map(csc_array, bar(elements))
    begin = time.perf_counter()
    names, still = [f"u{node}" for node in range(elements + 1)], np.ones(elements + 1)
    if modes is not None:
        reduced = reduce_structure(mass, stiffness, keep=[0], modes=modes)
        names, mass, stiffness = reduced.coordinates, reduced.mass, reduced.stiffness
        # the static shape of the tip is the bar as it is, moved
        still = np.eye(len(names))[0]
    stop = RigidStop(names[0], at=-DISTANCE, restitution=0, side="lower", name="wall")
    system = oscillator("bar", names, mass, stiffness, elements=[stop])
    states = [str(state) for state in system.states]
    start = dict(zip(states, [*(0 * still), *(-SPEED * still)], strict=True))
    motion = ns.simulate(system, {}, start, until=END)
    first = time.perf_counter() - begin
    again = []
    for _ in range(5):
        begin = time.perf_counter()
        ns.simulate(system, {}, start, until=END)
        again.append(time.perf_counter() - begin)
    velocities = motion.states[:, len(still) :]
    energies = [float(v @ (mass @ v)) / 2 for v in velocities[[0, min(2, len(velocities) - 1)]]]
    return first, again, motion.times.tolist(), energies[1] / energies[0]


def _bar(quick: bool) -> Iterator[Row]:
    """Rows for one impact and contact of a bar of 100 finite elements."""
    elements, runs = 100, 1 if quick else 3
    exact = contact_of_elements(elements)
    ours = f"bar: ours, {elements} elements reduced to 1 + 10 coordinates"
    wanted: list[tuple[str, int, int | None, float]] = [(ours, elements, 10, 120.0)]
    if not quick:
        wanted.append((f"bar: ours, {elements + 1} coordinates", elements, None, 60.0))
    for name, count, modes, limit in wanted:
        told(name)
        found = [apart(our_bar, count, modes, limit=limit)]
        if found[0] is None:
            told(f"stopped after {limit:.0f} s: the row is left out")
            continue
        found += [apart(our_bar, count, modes, limit=limit) for _ in range(runs - 1)]
        _, again, times, kept = found[0]
        answer = f"wrong: {len(times) - 1} transitions, not 3"
        if len(times) == 4:
            answer = _contact(times[1], times[3] - times[1], kept, exact)
        yield Row(name, [first for first, *_ in found], against=_other(ours, name), found=answer)
        yield Row(f"{name}, again", again, against=ours)
    if (python := python_with_siconos()) is None:
        return
    mass, stiffness = bar(elements)
    asked = {
        "masses": mass.tolist(),
        "stiffness": stiffness.tolist(),
        "position": [DISTANCE] * len(mass),
        "velocity": [-SPEED] * len(mass),
        "weight": [0.0] * len(mass),
        "restitution": 0.0,
        "until": END,
    }
    for theta, step in ((1.0, 2e-7), (0.5, 2e-7), *([] if quick else [(0.5, 5e-8)])):
        name = f"bar: Siconos, theta = {theta:g}, step {step:g} s"
        told(name)
        answers = [siconos(python, asked | {"theta": theta, "step": step}) for _ in range(runs)]
        rows = np.array(answers[0]["rows"])
        touching = rows[rows[:, 3] > 0, 0]
        kept = answers[0]["energy"] / (mass.sum() * SPEED**2 / 2)
        answer = _contact(touching[0], touching[-1] - touching[0] + step, kept, exact)
        yield Row(name, [a["seconds"] for a in answers], against=ours, found=answer)


def _other(one: str, name: str) -> str | None:
    return None if name == one else one


def _contact(impact: float, contact: float, kept: float, exact: float) -> str:
    return (
        f"impact off by {abs(impact - DISTANCE / SPEED):.0e} s; contact {contact:.4e} s,"
        f" {contact / CONTACT - 1:+.2%} of 2L/c, {contact / exact - 1:+.0e} of the elements';"
        f" energy kept {kept:.4f}"
    )


@cache
def python_with_siconos() -> str | None:
    """Path of an interpreter that has Siconos, this one or the system's; None without one."""
    for python in (sys.executable, "/usr/bin/python3"):
        tried = [python, "-c", "import siconos.kernel"]
        if Path(python).exists() and subprocess.run(tried, capture_output=True).returncode == 0:
            return python
    told("Siconos is not installed (Debian: python3-siconos, python3-scipy): left out")
    return None


def siconos(python: str, asked: dict[str, Any]) -> Any:
    """Answer of scripts/benchmarking/peer_siconos.py to a question."""
    program = str(Path(__file__).with_name("peer_siconos.py"))
    answer = subprocess.run(
        [python, program], input=json.dumps(asked), capture_output=True, text=True, check=True
    )
    # the library writes lines of its own before
    return json.loads(answer.stdout[answer.stdout.index('{"seconds"') :])


# The ball ------------------------------------------------------------------------------------


def height(times: np.ndarray) -> np.ndarray:
    """Heights of the ball at the given times, in closed form."""
    fall = (2 * HEIGHT / GRAVITY) ** 0.5
    flights = 2 * fall * BOUNCE ** np.arange(1, 500)
    begins = np.concatenate([[-fall], fall + np.concatenate([[0], flights.cumsum()])])
    place = np.searchsorted(begins, times, side="right") - 1
    speeds = GRAVITY * fall * BOUNCE ** np.arange(len(begins))
    passed = times - begins[place]
    return np.maximum(speeds[place] * passed - GRAVITY / 2 * passed**2, 0.0)


def our_ball() -> tuple[list[float], float]:
    """Seconds of several motions, and the largest error of the height."""
    ground = RigidStop("q", at=0, restitution="0.9", side="lower", name="ground")
    begin = time.perf_counter()
    system = oscillator("ball", ["q"], [[1]], [[0]], load=["-9.81"], elements=[ground])
    seconds = []
    for _ in range(6):
        motion = ns.simulate(system, {}, {"q": HEIGHT, "v_q": 0}, until=WATCHED)
        seconds.append(time.perf_counter() - begin)
        begin = time.perf_counter()
    times = np.linspace(0, WATCHED, 5001)
    return seconds, float(np.abs(motion(times)[:, 0] - height(times)).max())


def dop853_ball() -> tuple[list[float], float]:
    """The same quantities by solve_ivp, restarted at each impact that it finds."""
    from scipy.integrate import solve_ivp

    def ground(_: float, state: np.ndarray) -> float:
        return float(state[0])

    ground.terminal, ground.direction = True, -1.0  # type: ignore[attr-defined]  # SciPy reads them
    begin, when, state = time.perf_counter(), 0.0, np.array([HEIGHT, 0.0])
    solutions = []
    while when < WATCHED and abs(state[1]) + state[0] > 1e-6:
        solution = solve_ivp(
            lambda _, y: [y[1], -GRAVITY],
            (when, WATCHED),
            state,
            method="DOP853",
            rtol=1e-10,
            atol=1e-12,
            events=ground,
            dense_output=True,
        )
        solutions.append(solution)
        when, state = solution.t[-1], np.array([0.0, -BOUNCE * solution.y[1, -1]])
    seconds = time.perf_counter() - begin
    times = np.linspace(0, WATCHED, 5001)
    heights = np.zeros(len(times))
    for solution in solutions:
        here = (times >= solution.t[0]) & (times <= solution.t[-1])
        if here.any():
            heights[here] = solution.sol(times[here])[0]
    return [seconds], float(np.abs(heights - height(times)).max())


def _ball(quick: bool) -> Iterator[Row]:
    """Rows for a ball that comes to rest, watched for 10 s."""
    ours = "ball: ours"
    told(ours)
    seconds, error = apart(our_ball)
    yield Row(ours, seconds[:1], found=f"height off by {error:.0e} m")
    yield Row(f"{ours}, again", seconds[1:], against=ours)
    told("ball: DOP853")
    seconds, error = apart(dop853_ball)
    yield Row("ball: DOP853", seconds, against=ours, found=f"height off by {error:.0e} m")
    if (python := python_with_siconos()) is None:
        return
    asked = {
        "masses": [[1.0]],
        "stiffness": [[0.0]],
        "position": [HEIGHT],
        "velocity": [0.0],
        "weight": [-GRAVITY],
        "restitution": BOUNCE,
        "until": WATCHED,
        "theta": 0.5,
    }
    for step in (5e-3, *([] if quick else [1e-4])):
        name = f"ball: Siconos, step {step:g} s"
        told(name)
        answer = siconos(python, asked | {"step": step})
        rows = np.array(answer["rows"])
        error = float(np.abs(rows[:, 1] - height(rows[:, 0])).max())
        found = f"height off by {error:.0e} m"
        yield Row(name, [answer["seconds"]], against=ours, found=found)
