"""Frequency responses of two masses with a unilateral spring: ours and its peers'."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import sympy as sp
from benchmarking.measuring import Row, apart, told
from benchmarking.peer_responses import (
    DAMPING,
    FORCE,
    GAP,
    SPRING,
    STIFFNESS,
    HarmonicBalance,
    Shooting,
    follow_both_ways,
)

import nonsmooth as ns
from nonsmooth.derive import Harmonic, SoftStop, oscillator
from nonsmooth.runtime.orbits.orbit import Orbit

INTERVAL = (0.5, 0.8)  # of Omega in example 03 of NLvib
PHASES = 2 * np.pi * np.arange(512) / 512


@dataclass(frozen=True)
class Response:
    """A branch with one contact a period: seconds, Omega, motions (points, 2, phases)."""

    seconds: list[float]
    omega: np.ndarray
    motions: np.ndarray


def two_masses() -> Any:
    """Example 03 of NLvib, declared."""
    spring = SoftStop("x1", at=int(GAP), stiffness=int(SPRING), name="spring")
    damping = [[str(round(entry, 12)) for entry in row] for row in DAMPING]
    force = Harmonic(sp.Symbol("Omega"), cosine={"x2": str(FORCE)})
    return oscillator(
        "two-masses",
        ["x1", "x2"],
        [[1, 0], [0, 1]],
        STIFFNESS.astype(int).tolist(),
        damping,
        forcing=[force],
        elements=[spring],
    )


def our_motion(orbit: Orbit, phases: np.ndarray) -> np.ndarray:
    """States (4, phases) of an orbit over the phases of the force."""
    trajectory, omega = orbit.trajectory(), 2 * np.pi / orbit.period
    begin = trajectory(np.zeros(1))[0]
    times = (phases - np.arctan2(begin[5], begin[4])) % (2 * np.pi) / omega
    return np.asarray(trajectory(times)[:, :4].T)


def settled() -> Orbit:
    """The orbit with one contact from which all branches begin."""
    system = two_masses()
    rest = dict.fromkeys(("x1", "x2", "v1", "v2"), 0)
    motion = ns.simulate(system, {"Omega": "0.635"}, rest, until=3000)
    return ns.solve(system, {"Omega": "0.635"}, itinerary=ns.itinerary_of(motion))


def our_response(file: Path, runs: int) -> tuple[list[float], int]:
    """Seconds of each run and points of our branch, which has all its events.

    A branch in smaller steps is saved to the file.
    """
    orbit, seconds = settled(), []
    for _ in range(runs):
        begin = time.perf_counter()
        branch = ns.continue_orbit(orbit, "Omega", INTERVAL, step=0.1)
        seconds.append(time.perf_counter() - begin)
    ns.continue_orbit(orbit, "Omega", INTERVAL, step=0.005).save(file)
    return seconds, len(branch)


def peer_response(problem: HarmonicBalance | Shooting, runs: int) -> Response:
    """A peer's branch from the same orbit, with about as many points, timed several times."""
    orbit = settled()
    if isinstance(problem, HarmonicBalance):
        instants = 2 * np.pi * np.arange(problem.samples) / problem.samples
        start = problem.start(our_motion(orbit, instants)[:2], 0.635)
    else:
        states = our_motion(orbit, np.zeros(1))[:, 0]
        start = np.array([*states[:2], *(states[2:] / 0.635), 0.635])

    def touches(unknowns: np.ndarray) -> bool:
        return bool(problem.motion(unknowns, PHASES)[0].max() > GAP)

    seconds = []
    for _ in range(runs):
        begin = time.perf_counter()
        found = follow_both_ways(problem, start, INTERVAL, 0.1, touches)
        seconds.append(time.perf_counter() - begin)
    motions = np.array([problem.motion(unknowns, PHASES) for unknowns in found])
    return Response(seconds, found[:, -1], motions)


def responses(quick: bool) -> Iterator[Row]:
    """The frequency response of two masses with a unilateral spring."""
    told("response: ours")
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "branch.json"
        seconds, points = apart(our_response, file, 1 if quick else 5)
        branch = ns.load(file)
    ours = f"response: ours, {points} points with stability and all events"
    fold = max(event.value for event in branch.events if event.kind == "fold")
    yield Row(ours, [s / points for s in seconds], found=f"motion off by {_own(branch):.0e}")
    problems: dict[str, HarmonicBalance | Shooting] = {
        f"harmonic balance, H = {h}": HarmonicBalance(h, n)
        for h, n in ((7, 1024), (21, 1024), *([] if quick else [(101, 4096)]))
    }
    problems |= {f"shooting, rtol {t:g}": Shooting(t) for t in ((1e-8,) if quick else (1e-6, 1e-9))}
    for name, problem in problems.items():
        told(f"response: {name}")
        runs = 1 if quick or isinstance(problem, Shooting) else 3
        found = apart(peer_response, problem, runs)
        if found is None:
            told("stopped after 600 s: the row is left out")
            continue
        errors = np.array(
            [_missed(branch, *point) for point in zip(found.omega, found.motions, strict=True)]
        )
        answer = (
            f"motion off by {np.median(errors):.0e}, at most {errors.max():.0e};"
            f" fold by {abs(_top(found.omega, found.motions) - fold):.0e}"
        )
        label = f"response: {name}, {len(errors)} points"
        yield Row(label, [s / len(errors) for s in found.seconds], against=ours, found=answer)


def _top(omega: np.ndarray, motions: np.ndarray) -> float:
    """Largest Omega on a parabola through the three largest values of a branch."""
    place = min(max(int(omega.argmax()), 1), len(omega) - 2)
    near = slice(place - 1, place + 2)
    swings = motions[near, 0].max(axis=1)
    a, b, c = np.polyfit(swings - swings[1], omega[near], 2)
    return float(c - b**2 / (4 * a))


@cache
def _known(branch: Any) -> tuple[list[Orbit], np.ndarray]:
    """The orbits of a branch and their motions, without its ends, where the contact vanishes."""
    orbits = [branch.orbit_at(place) for place in range(len(branch))]
    orbits = [orbit for orbit in orbits if orbit.converged]
    return orbits, np.array([our_motion(orbit, PHASES)[:2] for orbit in orbits])


def _missed(branch: Any, omega: float, motion: np.ndarray) -> float:
    """Largest difference from our nearest motion at this Omega, in units of the motion's size."""
    orbits, known = _known(branch)
    nearest = np.abs(known - motion).max(axis=(1, 2)).argsort()[:2]
    errors = []
    for place in nearest.tolist():
        near = orbits[place]
        guess = [*near.dwell_times, *near.states[0]]  # two orbits have like dwell times
        orbit = ns.solve(
            two_masses(), {"Omega": omega}, guess, itinerary=near.itinerary, throw=False
        )
        if orbit.converged:
            difference = np.abs(our_motion(orbit, PHASES)[:2] - motion).max()
            errors.append(float(difference / np.abs(motion).max()))
    return min(errors, default=np.inf)


def _own(branch: Any) -> float:
    """Error of our motions against orbits of 30 digits."""
    errors = []
    for place in range(50, len(branch), 100):  # at its ends the contact vanishes
        orbit = branch.orbit_at(place)
        better = ns.refine(orbit, 30)
        change = our_motion(orbit, PHASES[::8]) - our_motion(better, PHASES[::8])
        errors.append(float(np.abs(change).max()))
    return max(errors)
