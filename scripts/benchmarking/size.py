"""The section of benchmark.py that measures chains of 2 to 200 masses."""

from __future__ import annotations

import math
import multiprocessing
from collections.abc import Iterator
from functools import partial
from pathlib import Path

import numpy as np
from benchmarking.measuring import Row, interleaved, timed
from benchmarking.simulation import dop853

from nonsmooth.runtime.model.engine_layout import numbers_of
from nonsmooth.runtime.model.kernels import compiled_engine
from nonsmooth.runtime.model.modes.numeric_modes import numeric_modes
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.model.structure import BoundaryShape, Structure, TransitionShape
from nonsmooth.runtime.shooting.newton import CONVERGED
from nonsmooth.runtime.shooting.shooting_map import itinerary_shape
from nonsmooth.runtime.shooting.table_newton import solve_shape
from nonsmooth.runtime.simulation.engines import run_motions
from nonsmooth.runtime.simulation.simulate import follow

SIZES = (2, 5, 10, 20, 50, 100, 200)
LIMIT = 100  # coordinates at which a transition has to take less than MUST
MUST = 100e-6
GAP, RESTITUTION, OMEGA, AMPLITUDE = 0.3, 0.8, 0.7, 1.0
STEP = 1 / 32  # of the exponential integrator
FEW = 3  # transitions of peers
SETTLING = 2000  # transitions after which the motion is nearly periodic
LONGEST = 12  # impacts of its period
CLOSE = 1e-6
_PEAK = Path("/proc/self/status")  # of Linux


def impact_chain(count: int) -> PiecewiseLinear:
    """A chain of at least two masses between walls; the first is forced and hits a rigid stop.

    x'' + C x' + K x = A e_1 cos(Omega t), C = 0.02 K + 0.02.
    """
    size = 2 * count + 2
    stiffness = 2 * np.eye(count) - np.eye(count, k=1) - np.eye(count, k=-1)
    field, unit = np.zeros((size, size + 1)), np.eye(size, size + 1)
    field[:count, count:-3] = np.eye(count)
    field[count:-2, :count] = -stiffness
    field[count:-2, count:-3] = -0.02 * (stiffness + np.eye(count))
    field[count, -3] = AMPLITUDE
    field[-2, -2], field[-1, -3] = -OMEGA, OMEGA
    row, bounce = np.zeros((1, size + 1)), unit.copy()
    row[0, 0], row[0, -1] = 1.0, -GAP
    bounce[count, count] = -RESTITUTION
    modes = numeric_modes(field)
    structure = Structure(
        f"impact-chain-{count}",
        tuple(f"y{i}" for i in range(size)),
        ("free",),
        (modes.shapes,),
        ((),),
        ((),),
        ((BoundaryShape("stop", 0, True),),),
        ((TransitionShape(frozenset({0}), (), 1, 0),),),
        (),
        1,
        2,
        ((size - 2, size - 1),),
    )
    resets = np.stack([unit, bounce])
    exponents, flows = (modes.exponents,), (modes.flows,)
    return PiecewiseLinear(structure, {}, field[None], row, resets, exponents, flows)


def _start(count: int) -> np.ndarray:
    rng = np.random.default_rng(count)
    moving = [*rng.uniform(-0.2, 0.2, count), *rng.normal(size=count)]
    return np.array([*moving, 1.0, 0.0])


def size(quick: bool) -> Iterator[Row]:
    """Chains of n masses: a transition, its peers, modes, and a Newton solve; memory beside n."""
    for count in SIZES[:5] if quick else SIZES:
        system, start = impact_chain(count), _start(count)
        many = 200 if quick else 1000
        label = f"n = {count} ({_memory(count):.1f} MB)"
        works = {f"{label}: transition": (partial(_followed, system, start, many), float(many))}
        peers = {"exponential steps, Newton": stepping, "DOP853, rtol 1e-10": dop853}
        for name, peer in peers.items():
            works[f"n = {count}: {name}"] = partial(peer, system, start, FEW), float(FEW)
        for what, seconds in interleaved(works, 3 if quick else 7).items():
            same = what == f"{label}: transition"
            must = MUST if same and count == LIMIT else None
            yield Row(what, seconds, must, None if same else f"{label}: transition")
        yield from _rest(count, system, start, 3 if quick else 5)


def _followed(system: PiecewiseLinear, start: np.ndarray, transitions: int) -> object:
    engine, zero = compiled_engine(), np.zeros(1, dtype=int)
    if engine is None:
        raise RuntimeError("the compiled engine is not there")
    numbers, endless = numbers_of(system)[None], np.array([np.inf])
    return run_motions(
        engine, system.structure, numbers, zero, start[None], zero, endless, transitions
    )


def _rest(count: int, system: PiecewiseLinear, start: np.ndarray, runs: int) -> Iterator[Row]:
    """Rows for the modes, and for the solve of the periodic orbit on which the motion settles."""
    field = system.fields[0].copy()

    def modes() -> None:
        field[0, -1] += 1e-9  # another one, which is not remembered
        numeric_modes(field)

    yield Row(f"n = {count}: modes", timed(modes, 1, runs))
    motion = follow(system, start, 0, transitions=SETTLING)
    dwell = np.diff(motion.times)
    impacts = next(
        k for k in range(1, LONGEST + 1) if np.ptp(dwell[-4 * k :].reshape(4, k), 0).max() < CLOSE
    )
    cycle = itinerary_shape(system.structure, [("free", "stop")] * impacts)
    numbers, guess = numbers_of(system)[None], 1.001 * dwell[None, -impacts:]
    near = motion.states[-1 - impacts][None] + 1e-3
    forcing = 2 * math.pi / OMEGA
    period = np.array([forcing * round(float(dwell[-impacts:].sum()) / forcing)])

    def solve() -> None:
        found = solve_shape(cycle, numbers, guess, near, period)
        if found.status[0] != CONVERGED:
            raise RuntimeError("no orbit")

    what = f"n = {count}: Newton solve, {impacts} impact{'s' if impacts > 1 else ''}"
    yield Row(what, timed(solve, 1, runs))


def _memory(count: int) -> float:
    """Peak memory in MB of a process that simulates, beyond that of its imports."""
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        return pool.apply(_grown, (count,))


def _grown(count: int) -> float:
    """Most memory in MB by which the process grows from a field's numbers to ten transitions."""
    follow(impact_chain(2), _start(2), 0, transitions=10)  # all that is imported late
    if not _PEAK.exists():
        return math.nan
    _PEAK.with_name("clear_refs").write_text("5")  # the peak begins anew
    before = _memory_of("VmRSS")
    follow(impact_chain(count), _start(count), 0, transitions=10)
    return (_memory_of("VmHWM") - before) / 1e3


def _memory_of(name: str) -> float:
    """A figure of this process's memory in kB."""
    lines = _PEAK.read_text().splitlines()
    return next(float(line.split()[1]) for line in lines if line.startswith(name))


def stepping(system: PiecewiseLinear, state: np.ndarray, transitions: int) -> list[float]:
    """Times of impacts by steps of the matrix exponential, and by Newton's method inside one.

    The system has one boundary; the state is (N,).
    """
    from scipy.linalg import expm

    whole = np.vstack([system.fields[0], np.zeros(len(state) + 1)])
    step, row, reset = expm(STEP * whole), system.rows[0], system.resets[1]
    now, time, found = np.append(state, 1.0), 0.0, []
    while len(found) < transitions:
        after = step @ now
        if row @ after <= 0:
            now, time = after, time + STEP
            continue
        inside = STEP * (row @ now) / (row @ now - row @ after)
        for _ in range(20):
            there = expm(inside * whole) @ now
            change = (row @ there) / (row @ (whole @ there))
            inside -= change
            if abs(change) < 1e-14:
                break
        there = expm(inside * whole) @ now
        time += inside
        found.append(time)
        now = np.append(reset @ there, 1.0)
    return found
