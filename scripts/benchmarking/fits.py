"""A fit to measured series and event times: exact derivatives beside finite differences."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from benchmarking.measuring import Row, interleaved
from development.stressing_fits import WALL, impacting
from scipy.integrate import solve_ivp
from scipy.optimize import least_squares

import nonsmooth as ns
from nonsmooth.runtime.explore.fitting.fit import Fit

TRUTH = {"c": 0.05, "k": 2.5, "r": 0.8, "w": 2.1}
GUESS = {"k": 2.53, "r": 0.79}
START = {"x": -0.6, "v": 0.1}
NOISE = {"x": 0.01, WALL: 2e-3}
TIMES = np.linspace(0.1, 10, 80)
COUNT = 8  # impacts


def measurements() -> dict[str, np.ndarray]:
    """Positions and impact times with noise."""
    motion, rng = ns.simulate(impacting(), TRUTH, START, until=25), np.random.default_rng(3)
    impacts = motion.times[[WALL in names for names in motion.boundaries]][:COUNT]
    events = np.full(len(TIMES), np.nan)
    events[:COUNT] = impacts + NOISE[WALL] * rng.normal(size=COUNT)
    return {"t": TIMES, "x": motion(TIMES)[:, 0] + NOISE["x"] * rng.normal(size=80), WALL: events}


def integrated(point: np.ndarray, until: float) -> tuple[np.ndarray, np.ndarray]:
    """Positions at the times, and times of impacts, by DOP853 with event location."""
    k, r, v = point

    def field(t: float, y: np.ndarray) -> list[float]:
        return [y[1], np.cos(TRUTH["w"] * t) - TRUTH["c"] * y[1] - k * y[0]]

    def wall(t: float, y: np.ndarray) -> float:
        return float(y[0] - 0.2)

    wall.terminal, wall.direction = True, 1  # type: ignore[attr-defined]  # SciPy reads them
    begin, state, values, impacts = 0.0, [START["x"], v], np.full(len(TIMES), np.nan), []
    while begin < until and len(impacts) < 4 * COUNT:
        part = solve_ivp(
            field, (begin, until), state, "DOP853", dense_output=True, events=wall,
            rtol=1e-10, atol=1e-12,
        )  # fmt: skip
        end = float(part.t[-1])
        here = (begin <= TIMES) & (end >= TIMES)
        if here.any():
            values[here] = part.sol(TIMES[here])[0]
        if part.status != 1:
            break
        impacts.append(end)
        begin, state = end, [0.2 - 1e-12, -r * float(part.y[1, -1])]
    return values, np.array(impacts)


def by_differences(data: dict[str, np.ndarray]) -> Any:
    """The same fit by `least_squares` with its own differences over `solve_ivp`."""
    events, until = data[WALL][:COUNT], float(np.nanmax(data[WALL])) + 1.0

    def residuals(point: np.ndarray) -> np.ndarray:
        values, impacts = integrated(point, max(until, TIMES[-1]))
        if len(impacts) < COUNT:
            return np.full(len(TIMES) + COUNT, np.nan)
        return np.concatenate(
            [(values - data["x"]) / NOISE["x"], (impacts[:COUNT] - events) / NOISE[WALL]]
        )

    return least_squares(residuals, [GUESS["k"], GUESS["r"], START["v"]], x_scale="jac")


def by_derivatives(system: Any, data: dict[str, np.ndarray]) -> Fit:
    """The fit of this package."""
    return ns.fit(
        system, data, parameters=TRUTH | GUESS, free=["k", "r", "v0"], start=START, sigma=NOISE
    )


def fits(quick: bool) -> Iterator[Row]:
    """Seconds of one fit of three unknowns to 80 positions and 8 impact times."""
    system, data = impacting(), measurements()
    ours, theirs = by_derivatives(system, data), by_differences(data)
    apart = float(np.max(abs(ours.estimates - theirs.x) / ours.standard_errors))
    found = f"{ours.evaluations} evaluations"
    label, peer = "exact derivatives", "least_squares, differences over solve_ivp"
    seconds = interleaved(
        {
            label: (lambda: by_derivatives(system, data), 1),
            peer: (lambda: by_differences(data), 1),
        },
        3 if quick else 7,
    )
    yield Row(label, seconds[label], found=found)
    yield Row(
        peer,
        seconds[peer],
        against=label,
        found=f"{theirs.nfev} evaluations, {apart:.1g} standard errors apart",
    )
