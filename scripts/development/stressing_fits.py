"""Fits to synthetic measurements: how often the 95 % intervals hold the truth."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from typing import Any

import numpy as np

import nonsmooth as ns
from nonsmooth.derive import Harmonic, Parameter, RigidStop, SoftStop, oscillator

WALL = "wall-reaches-stop"
FEWEST, MOST = 0.90, 0.99  # of the intervals
FREE = ("k", "r", "v0")
EVENTS = 12
AMPLITUDE_NOISE = 2e-3


def impacting() -> Any:
    """A forced and damped mass in front of a rigid stop."""
    c, k = Parameter("c", "damping"), Parameter("k", "stiffness")
    r, w = Parameter("r", "restitution", upper=1, upper_closed=True), Parameter("w", "frequency")
    return oscillator(
        "impacting",
        ["x"],
        mass=[[1]],
        damping=[[c.symbol]],
        stiffness=[[k.symbol]],
        forcing=[Harmonic(w.symbol, cosine=[1])],
        elements=[RigidStop("x", at="1/5", restitution=r.symbol, name="wall")],
        parameters=[c, k, r, w],
    )


def truth_of(rng: np.random.Generator) -> tuple[dict[str, float], dict[str, float]]:
    """Parameters and start of a motion."""
    point = {"c": 0.05, "w": 2.1, "k": rng.uniform(2, 4), "r": rng.uniform(0.6, 0.9)}
    return point, {"x": -0.6, "v": rng.uniform(-0.4, 0.4)}


def by_series(motion: Any, rng: np.random.Generator) -> tuple[dict[str, np.ndarray], Any]:
    """Positions at 80 times, some of them missing, and None for the size of their noise."""
    times = np.linspace(0.1, 14, 80)
    values = motion(times)[:, 0] + 0.01 * rng.normal(size=80)
    values[rng.random(80) < 0.1] = np.nan
    return {"t": times, "x": values}, None


def by_events(motion: Any, rng: np.random.Generator) -> tuple[dict[str, np.ndarray], Any]:
    """Times of impacts, and the size of their noise."""
    where = [WALL in names for names in motion.boundaries]
    times = motion.times[where][:EVENTS]
    return {WALL: times + 2e-3 * rng.normal(size=len(times))}, 2e-3


def touching() -> Any:
    """A forced and damped mass in front of an elastic stop."""
    c, k = Parameter("c", "damping"), Parameter("k", "stiffness")
    s, w = Parameter("s", "stiffness of the stop"), Parameter("w", "frequency")
    return oscillator(
        "touching",
        ["x"],
        mass=[[1]],
        damping=[[c.symbol]],
        stiffness=[[k.symbol]],
        forcing=[Harmonic(w.symbol, cosine=["3/10"])],
        elements=[SoftStop("x", at=1, stiffness=s.symbol, name="stop")],
        parameters=[c, k, s, w],
    )


def swept(point: dict[str, float], rng: np.random.Generator) -> dict[str, np.ndarray] | None:
    """Amplitudes at frequencies up through the resonance; None where a response is not steady."""
    system, frequencies = touching(), np.linspace(0.6, 1.8, 13)
    start: dict[str, float] = {"x": 0.0, "v": 0.0}
    found = []
    for w in frequencies.tolist():
        turn = 2 * np.pi / w
        motion = ns.simulate(system, point | {"w": w}, start, until=200 * turn)
        last, before = (motion(np.linspace(n, n + 1, 50) * turn) for n in (199, 198))
        if abs(last - before).max() > 1e-6:
            return None
        seen = ns.observe(motion, since=199 * turn)
        found.append((seen.maxima["x"].value - seen.minima["x"].value) / 2)
        start = dict(zip(("x", "v"), motion(motion.end)[:2].tolist(), strict=True))
    if max(found) < 1.2:
        return None
    values = np.array(found) + AMPLITUDE_NOISE * rng.normal(size=len(found))
    return {"w": frequencies, "amplitude:x": values}


KINDS: dict[str, Callable[..., tuple[dict[str, np.ndarray], Any]]] = {
    "series": by_series,
    "event times": by_events,
}


def fits_chunk(seed: int, count: int) -> tuple[Counter[str], list[str]]:
    """Fit `count` motions of each kind, and judge the share of intervals that hold the truth."""
    system, rng = impacting(), np.random.default_rng(seed)
    found: Counter[str] = Counter()
    told = []
    for kind, measure in KINDS.items():
        held, runs = Counter[str](), 0
        while runs < count:
            point, start = truth_of(rng)
            motion = ns.simulate(system, point, start, until=40)
            if sum(WALL in names for names in motion.boundaries) < EVENTS:
                continue
            data, sigma = measure(motion, rng)
            guess = {name: point[name] * (1 + 0.02 * rng.normal()) for name in ("k", "r")}
            guess["r"] = min(guess["r"], 0.99)
            begin = {**start, "v": start["v"] + 0.02 * rng.normal()}
            truth = np.array([point["k"], point["r"], start["v"]])
            runs += 1
            fit = ns.fit(
                system,
                data,
                parameters={**point, **guess},
                bounds={"k": (1, 6), "r": (0.2, 1), "v0": (-2, 2)},
                start=begin,
                sigma=sigma,
            )
            good = (fit.lower <= truth) & (truth <= fit.upper)
            held.update(dict(zip(FREE, good.tolist(), strict=True)))
            if fit.status != "converged" or not good.any():
                told.append(f"{kind}: {fit.status}, {fit.estimates} for {truth}")
        judge(found, kind, FREE, held, count)
    held, runs = Counter[str](), 0
    while runs < count:
        point = {"c": rng.uniform(0.08, 0.15), "k": rng.uniform(0.9, 1.1), "s": rng.uniform(1, 4)}
        data = swept(point, rng)
        if data is None:
            continue
        runs += 1
        guess = {name: value * (1 + 0.02 * rng.normal()) for name, value in point.items()}
        fit = ns.fit(touching(), data, parameters=guess, free=[*point], sigma=AMPLITUDE_NOISE)
        truth = np.array([*point.values()])
        good = (fit.lower <= truth) & (truth <= fit.upper)
        held.update(dict(zip(point, good.tolist(), strict=True)))
        if fit.status != "converged" or not good.any():
            told.append(f"responses: {fit.status}, {fit.estimates} for {truth}")
    judge(found, "responses", ("c", "k", "s"), held, count)
    return found, told


def judge(
    found: Counter[str], kind: str, names: tuple[str, ...], held: Counter[str], count: int
) -> None:
    """Count, for each parameter, whether as many intervals hold the truth as should."""
    for name in names:
        share = held[name] / count
        verdict = "right" if FEWEST <= share <= MOST or count < 50 else "wrong"
        found[f"{verdict} ({kind}, {name} in {100 * share:.0f} % of its intervals)"] += 1
