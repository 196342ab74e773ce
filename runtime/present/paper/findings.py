"""What the paper says, decided by computation: a function for each table, claim and misprint.

Each takes the orbits at the paper's data by their names; paper.toml has what is said.
"""

from __future__ import annotations

import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from importlib.resources import files
from typing import Any

import numpy as np

from nonsmooth.runtime.core.values import decimal_string
from nonsmooth.runtime.explore.intervals import admissible_intervals, singular_values
from nonsmooth.runtime.model.naming import symbol
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.solve import solve

DIGITS = 30
PAPER: dict[str, Any] = tomllib.loads(
    files("nonsmooth.runtime.present.paper").joinpath("paper.toml").read_text(encoding="utf-8")
)
RIGID, ELASTIC, SYMMETRIC, STICK, _ = PAPER["orbits"]

Orbits = Mapping[str, Orbit]

_LONGEST_PERIOD = 8 * np.pi
_STIFFEST = 10  # decades of k3
_CLEAR = 1e-4  # beyond it a difference is no rounding, of the paper's digits or ours
_GRID = 4000  # durations of contact, between which solutions are looked for
_SAMPLES = 4001  # instants of a phase at which the stop is looked at
_ROUNDING = 1e-9


@dataclass(frozen=True)
class Answer:
    """What a computation says: cells of the table behind the labels, verdict, values by name."""

    rows: Sequence[Sequence[Any]]
    verdict: str = ""
    values: Mapping[str, Any] = field(default_factory=dict)


# --- tables


def singular_periods(orbits: Orbits) -> Answer:
    """Periods at which the half-period conditions leave the rigid orbit undetermined."""
    found = singular_values(RIGID, "T", 0, _LONGEST_PERIOD)
    return Answer([(value, value / (2 * np.pi)) for value in found])


def admissible_periods(orbits: Orbits) -> Answer:
    """Intervals of the period in which the rigid orbit is a motion of the system."""
    boundary = "first-reaches-stop"
    rows = []
    for found in admissible_intervals(RIGID, "T", 0, _LONGEST_PERIOD):
        reasons = [end.replace(boundary, f"*{boundary}*") for end in (found.below, found.above)]
        rows.append((found.lower, found.upper, *reasons))
    return Answer(rows)


def appendix_conditions(orbits: Orbits) -> Answer:
    """The Appendix's conditions at the orbit of the six equations, from its dwell times."""
    stick = orbits[STICK]
    turn, residual = stick.evaluate("period_map", "compatibility")
    first, second, third, fourth = (
        stick.arithmetic.mp.matrix([row[columns] for row in turn[rows]])
        for rows in (slice(2), slice(2, 4))
        for columns in (slice(2), slice(2, 4))
    )
    one = stick.arithmetic.mp.eye(2)
    of_times = (first - one) ** -1 * second - third**-1 * (fourth - one)  # the matrix of (A.2)
    sums = [of_times[row, 0] + of_times[row, 1] for row in range(2)]
    return Answer([(float(side),) for side in (*residual, *sums)])


def appendix_start(orbits: Orbits) -> Answer:
    """The start of the orbit with global stick by (A.3), beside that of the six equations."""
    theirs = [orbits[STICK].unknowns[name] for name in ("z10", "z20")]
    return Answer(
        [
            (decimal_string(ours, DIGITS), decimal_string(their, DIGITS), float(ours - their))
            for ours, their in zip(orbits[STICK].evaluate("linear_start"), theirs, strict=True)
        ]
    )


def multipliers(orbits: Orbits) -> Answer:
    """Multipliers of each of the paper's orbits, with and without saltation matrices."""
    rows = []
    for orbit in (orbits[name] for name in PAPER["orbits"]):
        known = [complex(m.real, m.imaginary) for m in orbit.stability.multipliers]
        full = np.linalg.eigvals(np.array(orbit.monodromy, dtype=float))
        without = np.linalg.eigvals(_without_saltation(orbit))
        rows.append((orbit.name, _listed(known), _listed(full), _listed(without)))
    return Answer(rows)


def _without_saltation(orbit: Orbit) -> np.ndarray:
    """The product of flows and resets: saltation matrices without their rank-one part."""
    kernels, at = orbit.kernels, _at(orbit)
    product = np.eye(len(kernels.table["states"]))
    for (configuration, _, _), time, reset in zip(
        kernels.table["phases"], orbit.dwell_times, kernels.table["resets"], strict=True
    ):
        origin, moved = (
            np.asarray(kernels.flow(configuration, *at, float(time), states))
            for states in (np.zeros(len(product)), product.T)
        )
        product = np.array(reset, dtype=float) @ (moved - origin).T
    return product


def _listed(numbers: Sequence[complex] | np.ndarray) -> str:
    """Complex numbers as text, the largest first."""
    ordered = sorted(
        np.asarray(numbers, dtype=complex).tolist(),
        key=lambda number: (-round(abs(number), 5), -round(number.real, 5), -number.imag),
    )
    return ", ".join(
        f"{z.real:.5f}" + (f"{z.imag:+.5f} i" if abs(z.imag) > 1e-6 else "") for z in ordered
    ).replace("-0.00000", "0.00000")


# --- claims without a number


def rigid_limit(orbits: Orbits) -> Answer:
    """Whether elastic orbits tend to the rigid one as the stop stiffens, and how fast."""
    rigid = {name: float(orbits[RIGID].unknowns[name]) for name in ("y", "u")}
    rows, errors = [], []
    for decade in range(_STIFFEST + 1):
        stiffness = 10.0**decade
        soft, scale = solve(ELASTIC, {"k3": stiffness}).unknowns, np.sqrt(stiffness)
        errors.append((soft["u"] + rigid["u"], soft["y"] - rigid["y"]))
        scaled = [scale * x for x in (*errors[-1], soft["tau"], soft["w"])]
        rows.append((decade, soft["u"], *scaled))
    # exponents of k3 over the last two decades
    of_u, of_y = np.log10(np.abs(np.divide(errors[-1], errors[-3]))) / 2
    holds = max(abs(of_u + 0.5), abs(of_y + 0.5)) < 0.01
    return Answer(rows, "holds" if holds else "undecided", {"of_u": of_u, "of_y": of_y})


def symmetric_portraits(orbits: Orbits) -> Answer:
    """Whether both phase portraits of the symmetric orbit are symmetric."""
    orbit = orbits[SYMMETRIC]
    motion, tau = orbit.motion(), float(orbit.values["tau"])
    times = np.linspace(0, motion.period, 2001)
    defects = np.abs(motion(times) + [1, 1, -1, -1] * motion(tau - times)).max(axis=0)
    largest = max((float(m.real) for m in orbit.stability.multipliers), key=abs)
    return Answer(
        [(defect,) for defect in defects],
        "holds" if defects.max() < 1e-12 else "does not hold",
        {"multiplier": largest, "stability": orbit.stability.verdict},
    )


def trace_criterion(orbits: Orbits) -> Answer:
    """Whether the Jacobian of the orbit with global stick is singular, and its trace."""
    orbit = orbits[STICK]
    (a, b), (c, d) = orbit.evaluate("poincare_jacobian")
    determinant, stability, digits = float(a * d - b * c), orbit.stability, orbit.arithmetic.mp.dps
    zero = abs(determinant) < 10.0**-digits
    values = {"trace": float(stability.trace), "margin": float(stability.margin)}
    return Answer(
        [],
        "holds" if abs(determinant) < 1e-25 else "does not hold",
        {
            "determinant": f"vanishes to {digits} digits" if zero else f"is {determinant:.0e}",
            **values,
            "stability": stability.verdict,
        },
    )


# --- misprints


def impact_law(orbits: Orbits) -> Answer:
    """The energy in front of the impact and behind it, by the law as printed and corrected."""
    m1, k1, k2, y, u = (float(orbits[RIGID].values[name]) for name in ("m1", "k1", "k2", "y", "u"))
    rows = [
        (x1, v1, (m1 * v1**2 + k1 * (x1 - y) ** 2 + k2 * y**2) / 2)
        for x1, v1 in ((1.0, -u), (-1.0, -u), (1.0, u))
    ]
    before, printed, corrected = (energy for _, _, energy in rows)
    return Answer(rows, _verdict(printed - before, corrected - before))


def contact_stiffness(orbits: Orbits) -> Answer:
    """All one-contact solutions with the matrix as printed and corrected, and what they are."""
    data = {name: float(x) for name, x in orbits[ELASTIC].values.items()}
    rows, counts = [], []
    for entry, stiffness in (("k_1 + k_3", data["k3"]), ("k_1 + k_2", data["k2"])):
        found = _contact_orbits(data, data["k1"] + stiffness)
        counts.append(sum(not failure for *_, failure in found))
        rows += [(entry, tau, u, f"no: {why}" if why else "yes") for tau, u, why in found]
    words = [("none", "one", "two", "three")[n] if n < 4 else str(n) for n in counts]
    verdict = "misprint" if counts[0] == 0 < counts[1] else "undecided"
    return Answer(rows, verdict, {"of_printed": words[0], "of_corrected": words[1]})


def mirrored_state(orbits: Orbits) -> Answer:
    """The velocities at the end of the contact, beside both rules for them."""
    start, end = (np.array([float(x) for x in row]) for row in orbits[ELASTIC].states[:2])
    rows = [
        (velocity, -x, abs(velocity + x))
        for velocity, x in zip((*end[2:], *end[2:]), start, strict=True)
    ]
    defects = [defect for *_, defect in rows]
    return Answer(rows, _verdict(min(defects[:2]), max(defects[2:])))


def time_scale(orbits: Orbits) -> Answer:
    """The frequency of the first mass alone, which has to be 1 in the scaled time."""
    k1, k2, m1 = 3.0, 5.0, 2.0
    omega = np.sqrt((k1 + k2) / m1)  # x = cos(omega t) solves m1 x'' + (k1 + k2) x = 0
    printed, corrected = omega * omega, omega / omega
    return Answer([(printed,), (corrected,)], _verdict(printed - 1, corrected - 1))


def global_stick_flow(orbits: Orbits) -> Answer:
    """Whether the orbit closes with the flow of global stick, as printed and corrected."""
    defects = []
    for velocity in ("1", "1.1"):
        orbit = solve(STICK, {"V": velocity})
        for factor in (float(velocity), 1.0):
            # N D for the D of the factor: a turn, with the time of D's own block taken back
            block = np.eye(4)
            block[:2, 2:] = (factor - 1) * float(orbit.unknowns["ta"]) * np.eye(2)
            defects.append(_defect(_period_map(orbit) @ block, orbit))
    return Answer([(defect,) for defect in defects], _verdict(*defects[2:]))


def appendix_block(orbits: Orbits) -> Answer:
    """The second periodicity condition at the orbit, with either block."""
    around = _period_map(orbits[STICK])
    start = np.array([float(x) for x in orbits[STICK].states[0]])
    moved = (around[2:, 2:] - np.eye(2)) @ start[2:]
    residuals = [
        float(np.abs(block @ start[:2] + moved).max()) for block in (around[:2, 2:], around[2:, :2])
    ]
    return Answer([(residual,) for residual in residuals], _verdict(*residuals))


def appendix_time(orbits: Orbits) -> Answer:
    """Whether the orbit closes with the period, and with the last dwell time, in place of T."""
    stick = orbits[STICK]
    printed = _defect(_period_map(stick, tau2=float(stick.period)), stick)
    corrected = _defect(_period_map(stick), stick)
    return Answer([(printed,), (corrected,)], _verdict(printed, corrected))


def digits_of_global_stick(orbits: Orbits) -> Answer:
    """The six equations at the printed digits."""
    kernels, printed = orbits[STICK].kernels, PAPER["numbers"]["dwell_times"]["printed"]
    unknowns = [float(printed[name]) for name in kernels.unknowns]
    residual = kernels.evaluate("residual", at=(*_at(orbits[STICK]), unknowns))
    switching, closing = np.abs(residual[:4]).max(), np.abs(residual[4:]).max()
    rows = list(zip(kernels.table["equations"], residual, strict=True))
    return Answer(rows, "misprint" if closing > 100 * switching else "undecided")


def digits_of_symmetric(orbits: Orbits) -> Answer:
    """The printed dwell times of the symmetric orbit beside ours."""
    rows, missed = [], False
    for name, printed in PAPER["numbers"]["symmetric"]["printed"].items():
        ours = float(orbits[SYMMETRIC].unknowns[name])
        difference = ours - float(printed)
        missed |= abs(difference) > 10.0 ** -len(printed.partition(".")[2])
        rows.append((symbol(name), printed, ours, 100 * difference / ours))
    return Answer(rows, "misprint" if missed else "holds")


def _at(orbit: Orbit) -> tuple[list[float], Any]:
    """Parameters and spectrum of an orbit's kernels, in double precision."""
    parameters = [float(orbit.values[name]) for name in orbit.kernels.parameter_names]
    return parameters, orbit.kernels.spectrum(parameters)[0]


def _period_map(orbit: Orbit, **changed: float) -> np.ndarray:
    """The matrix of the Appendix at an orbit, some of whose unknowns are changed."""
    values = {**orbit.values, **changed}
    unknowns = [float(values[name]) for name in orbit.kernels.unknowns]
    table = orbit.kernels.evaluate("period_map", at=(*_at(orbit), unknowns))
    return np.asarray(table)[:, :-1]


def _defect(around: np.ndarray, orbit: Orbit) -> float:
    """By how much a matrix misses to carry the start of an orbit to itself."""
    start = np.array([float(x) for x in orbit.states[0]])
    return float(np.abs(around @ start - start).max())


def _verdict(printed: float, corrected: float) -> str:
    """Whether what is printed clearly fails where the correction holds."""
    return "misprint" if abs(printed) > _CLEAR > 1e6 * abs(corrected) else "undecided"


# --- one-contact solutions, by a route that takes nothing from the derivation or the kernels


def _contact_orbits(data: Mapping[str, float], last_entry: float) -> list[tuple[float, float, str]]:
    """All one-contact solutions for an entry K1[2, 2] of the contact stiffness.

    Each has the duration of contact, the velocity u, and why it is no motion, or nothing. A
    velocity that vanishes halfway through a phase is linear in the start (1, y, u, w). The four
    conditions of both phases have a solution where their determinant with the right-hand side
    vanishes: its zeros in 0 < tau < T are found on a grid and refined.
    """
    from scipy.linalg import expm
    from scipy.optimize import brentq

    k1, period, mass = data["k1"], data["T"], np.array([data["m1"], data["m2"]])
    free = _field(mass, [[k1, -k1], [-k1, k1 + data["k2"]]], 0.0)
    contact = _field(mass, [[k1 + data["k3"], -k1], [-k1, last_entry]], data["k3"])
    reflected = np.array([1.0, 1.0, -1.0, -1.0, 1.0])

    def conditions(during: np.ndarray, outside: np.ndarray) -> np.ndarray:
        """Matrix (..., 4, 4) on (y, u, w, 1) of the velocities that have to vanish."""
        rows = [during[..., 2:4, :], outside[..., 2:4, :] * reflected]
        joined = np.concatenate(rows, axis=-2)
        return np.concatenate([joined[..., 1:4], joined[..., :1] + joined[..., 4:]], axis=-1)

    def conditions_at(tau: float) -> np.ndarray:
        """Matrix (4, 4) for a duration of contact."""
        return conditions(expm(tau / 2 * contact), expm((period - tau) / 2 * free))

    halves = (_flows(field, period / 2, _GRID + 2) for field in (contact, free))
    during, outside = (flows[1:-1] for flows in halves)
    grid = np.linspace(0, period, _GRID + 2)[1:-1]
    signs = np.sign(np.linalg.det(conditions(during, outside[::-1])))
    found = []
    for k in np.flatnonzero(signs[1:] * signs[:-1] < 0):
        tau = float(
            brentq(lambda tau: np.linalg.det(conditions_at(tau)), *grid[k : k + 2], xtol=1e-14)
        )
        rows = conditions_at(tau)
        start = np.array([1.0, *np.linalg.lstsq(rows[:, :3], -rows[:, 3])[0], 1.0])
        lowest = (_flows(contact, tau, _SAMPLES)[:, 0] @ start).min()
        back = _flows(free, period - tau, _SAMPLES)[:, 0]
        highest = (back @ (reflected * start)).max()
        failure = ""
        if lowest < 1 - _ROUNDING:
            failure = f"$x_1$ falls to {lowest:.4g} in contact"
        elif highest > 1 + _ROUNDING:
            failure = f"$x_1$ rises to {highest:.4g} in free motion"
        found.append((tau, float(start[2]), failure))
    return found


def _field(mass: np.ndarray, stiffness: Sequence[Sequence[float]], force: float) -> np.ndarray:
    """Matrix (5, 5) of the linear motion of (x, x', 1), with a constant force on the first mass."""
    field = np.zeros((5, 5))
    field[:2, 2:4] = np.eye(2)
    field[2:4, :2] = -np.array(stiffness) / mass[:, None]
    field[2, 4] = force / mass[0]
    return field


def _flows(field: np.ndarray, end: float, count: int) -> np.ndarray:
    """Matrices (count, 5, 5) that carry (x, x', 1) over evenly spaced times from 0 to `end`."""
    from scipy.linalg import expm

    flows, further = np.eye(5)[None], expm(end / (count - 1) * field)
    while len(flows) < count:
        flows, further = np.concatenate([flows, flows @ further]), further @ further
    return flows[:count]
