"""Random motions that are hard on an engine, and the references that judge their sequences."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from stressing_steps import broken_step

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.engine_run import Run
from nonsmooth.runtime.model.kernels import compiled_engine
from nonsmooth.runtime.model.piecewise import PiecewiseLinear, piecewise
from nonsmooth.runtime.proof.certify_motion import Proof, certify_motion
from nonsmooth.runtime.simulation.engines import run_compiled
from nonsmooth.runtime.simulation.starting import configuration_of
from nonsmooth.runtime.simulation.stepping import run as reference

FRICTION = ("plain", "equal-limits", "near-limits", "scales", "on-belt", "at-limit", "both-on-belt")
RIGID = ("rigid", "rigid-touching")
ELASTIC = ("elastic", "elastic-touching")

_ACCUMULATES = 1e-3  # dwell time below which impacts with r < 1 count as accumulating

Sequence_ = list[tuple[int, int]]  # (configuration, set that led to it)


@dataclass(frozen=True)
class Motion:
    """A system at a parameter point and a start, all in doubles."""

    kind: str
    system: str
    parameters: dict[str, float]
    state: tuple[float, ...]
    until: float = 500.0  # longest time; waiting for rare events takes the reference a second

    def __str__(self) -> str:
        values = ", ".join(f"{n}={v!r}" for n, v in self.parameters.items())
        return f"[{self.kind}] {self.system}({values}) from {self.state} until {self.until}"


def random_motion(rng: np.random.Generator, kind: str) -> Motion:
    """A motion of a kind."""
    if kind in FRICTION:
        return _friction(rng, kind)
    return _stop(rng, kind)


def _friction(rng: np.random.Generator, kind: str) -> Motion:
    us1, us2, *factors = (*rng.uniform(0.05, 2, 2), *rng.uniform(1, 3, 2))
    p = {
        "chi": rng.uniform(0.1, 0.9),
        "eta": rng.uniform(0.2, 4),
        "V": rng.uniform(0.2, 2),
        "us1": us1,
        "ur1": us1 * factors[0],
        "us2": us2,
        "ur2": us2 * factors[1],
    }
    state = rng.normal(size=4) * 2
    if kind == "equal-limits":
        p["ur1"] = p["us1"]
        if rng.random() < 0.7:
            p["ur2"] = p["us2"]
        if rng.random() < 0.3:
            p["us2"] = p["ur2"] = p["us1"]
    elif kind == "near-limits":
        near = 1 + 10.0 ** rng.uniform(-15, -3, 3)
        p["ur1"], p["ur2"] = p["us1"] * near[0], p["us2"] * near[1]
        if rng.random() < 0.5:
            p["us2"] = p["us1"]
            p["ur2"] = p["ur1"] * near[2]
    elif kind == "scales":
        p["V"] = 10.0 ** rng.uniform(-6, 3)
        p["eta"] = 10.0 ** rng.uniform(-4, 4)
        p["chi"] = rng.choice([10.0 ** rng.uniform(-4, -1), 1 - 10.0 ** rng.uniform(-4, -1)])
        state *= 10.0 ** rng.uniform(-3, 2)
    if kind in ("on-belt", "both-on-belt", "at-limit", "equal-limits") and (
        kind != "equal-limits" or rng.random() < 0.5
    ):
        which = (2, 3) if kind == "both-on-belt" else (int(rng.integers(2, 4)),)
        for i in which:
            state[i] = p["V"]
        if kind != "on-belt":
            state = _at_limit(rng, p, state, which)
    until = math.inf if rng.random() < 0.05 else 500.0
    return Motion(kind, "dry-friction", _plain(p), tuple(map(float, state)), until)


def _at_limit(
    rng: np.random.Generator, p: dict[str, float], state: np.ndarray, on_belt: Sequence[int]
) -> np.ndarray:
    """A start whose forces equal limits up to rounding; sometimes in exact binary numbers."""
    state = state.copy()
    if rng.random() < 0.5:  # few bits, so that sums and products are exact
        for name in p:
            p[name] = max(round(p[name] * 8) / 8, 0.125)
        p["chi"] = float(rng.choice([0.25, 0.5, 0.75]))
        p["ur1"], p["ur2"] = max(p["ur1"], p["us1"]), max(p["ur2"], p["us2"])
        state = np.round(state * 8) / 8
        for i in on_belt:
            state[i] = p["V"]
    one = rng.choice([-1, 1]) * p[rng.choice(["us1", "ur1"])]
    two = rng.choice([-1, 1]) * p[rng.choice(["us2", "ur2"])]
    chi = p["chi"]
    if rng.random() < 0.5 and len(on_belt) == 2:  # both: x2 - x1 = f2/chi, x1 - chi x2 = f1
        gap = two / chi
        state[0] = (one + chi * gap) / (1 - chi)
        state[1] = state[0] + gap
    elif 2 in on_belt:
        state[0] = one + chi * state[1]
    else:
        state[1] = state[0] + two / chi
    return state


def _stop(rng: np.random.Generator, kind: str) -> Motion:
    p = {name: 10.0 ** rng.uniform(-0.7, 0.7) for name in ("m1", "m2", "k1", "k2")}
    state = rng.normal(size=4) * 1.5
    state[0] = min(state[0], rng.uniform(0, 1))
    system = "rigid-stop" if kind.startswith("rigid") else "elastic-stop"
    if system == "rigid-stop":
        p["r"] = float(rng.choice([0, 0.3, 0.5, 0.9, 1]))
    else:
        p["k3"] = 10.0 ** rng.uniform(-1, 3)
    if kind.endswith("touching"):
        state[0] = 1.0
        choice = rng.random()
        if choice < 0.6:
            state[2] = 0.0
        if choice < 0.2:
            state[1] = 1.0
        elif system == "rigid-stop" and choice > 0.6:
            state[2] = -abs(state[2])
    return Motion(kind, system, _plain(p), tuple(map(float, state)))


def _plain(parameters: dict[str, float]) -> dict[str, float]:
    return {name: float(value) for name, value in parameters.items()}


def _prepared(motion: Motion) -> tuple[PiecewiseLinear, np.ndarray, int] | None:
    """The system, the start and its configuration; None if the start belongs to none."""
    system, state = piecewise(motion.system, motion.parameters), np.array(motion.state)
    try:
        return system, state, configuration_of(system, state)
    except InputError:
        return None


def _compiled(
    system: PiecewiseLinear,
    state: np.ndarray,
    start: int,
    transitions: int,
    until: float = math.inf,
) -> Run:
    engine = compiled_engine()
    if engine is None:
        raise RuntimeError("the compiled engine is not there")
    return run_compiled(engine, system, state, start, until, transitions)


def _sequence(run: Run) -> Sequence_:
    return list(zip(run.configurations.tolist(), run.sets.tolist(), strict=True))


def _differ(one: Sequence_, other: Sequence_) -> int | None:
    """Index of the first entry that differs or is missing; None if there is none."""
    for k in range(max(len(one), len(other))):
        if k >= len(one) or k >= len(other) or one[k] != other[k]:
            return k
    return None


def _proved(
    motion: Motion, system: PiecewiseLinear, start: int, transitions: int
) -> tuple[Sequence_, Proof]:
    """The proved part of the exact motion's sequence, and the proof."""
    structure = system.structure
    proof = certify_motion(
        motion.system,
        {name: str(Fraction(value)) for name, value in motion.parameters.items()},
        list(motion.state),
        structure.configurations[start],
        transitions,
    )
    found = [(start, 0)]
    for before, reached, after in zip(
        proof.configurations, proof.sets, proof.configurations[1:], strict=False
    ):
        source = structure.configuration(before)
        mask = sum(1 << structure.boundary(source, name) for name in reached)
        found.append((structure.configuration(after), mask))
    return found, proof


def _accumulates(motion: Motion, run: Run, k: int) -> bool:
    """Whether entry k follows impacts in quick succession."""
    if motion.parameters.get("r", 1.0) == 1.0 or k < 1:
        return False
    dwell = np.diff(run.times)[max(0, k - 2) : k + 1]
    return bool(dwell.size and dwell.min() < _ACCUMULATES)


def against_reference(motion: Motion, transitions: int) -> tuple[str, str]:
    """Verdict on the compiled engine against the engine in Python."""
    prepared = _prepared(motion)
    if prepared is None:
        return "no configuration", ""
    system, state, start = prepared
    ours = _compiled(system, state, start, transitions, motion.until)
    theirs = reference(system, state, start, motion.until, transitions)
    one, other = _sequence(ours), _sequence(theirs)
    k = _differ(one, other)
    if k is None and ours.status == theirs.status:
        late = np.abs(ours.times - theirs.times) > 1e-6 * (1 + theirs.times)
        if not late.any() or _accumulates(motion, ours, int(late.argmax())):
            return "agree", ""
    elif k is not None and _accumulates(motion, ours, k) and _accumulates(motion, theirs, k):
        return "agree up to an accumulation of impacts", ""
    if k is None and ours.status != theirs.status:
        return "wrong: status", f"{ours.status.name} {ours.end}, {theirs.status.name} {theirs.end}"
    where = f"entry {k}, {ours.status.name}, {theirs.status.name}"
    fault = broken_step(system, ours, 1.0)
    if fault:
        return "wrong: engine", f"{where}, {fault}"
    fault = broken_step(system, theirs, 2.0)
    if fault:
        return "wrong: reference", f"{where}, {fault}"
    return ("times sensitive" if k is None else "undecidable within rounding"), ""


def against_proof(motion: Motion, transitions: int) -> tuple[str, str]:
    """Verdict on the compiled engine against a proof of the exact motion."""
    prepared = _prepared(motion)
    if prepared is None:
        return "no configuration", ""
    system, state, start = prepared
    run = _compiled(system, state, start, transitions)
    found = _sequence(run)
    try:
        truth, proof = _proved(motion, system, start, transitions)
    except InputError:  # of the exact doubles, the start is beyond a boundary by a rounding
        return "start undecidable within rounding", ""
    k = _differ(found, truth)
    if k is None:
        if proof.decided:
            return "proved", ""
        return "undecided by balls", ""
    if not proof.decided and k >= len(truth):
        return "proved up to where balls cannot tell", ""
    if _accumulates(motion, run, k):
        return "proved up to an accumulation of impacts", ""
    fault = broken_step(system, run, 1.0)
    if fault:
        return "wrong: engine", f"entry {k}, {fault}"
    return "undecidable within rounding", ""


def against_integrator(motion: Motion, transitions: int) -> tuple[str, str]:
    """Verdict on the compiled engine against DOP853 with event detection."""
    prepared = _prepared(motion)
    if prepared is None:
        return "no configuration", ""
    system, state, start = prepared
    run = _compiled(system, state, start, transitions)
    found, times = run.configurations.tolist(), run.times
    sequence, instants = _integrated(system, state, start, len(found) - 1)
    if found != sequence:
        k = next(i for i, (a, b) in enumerate(zip(found, sequence, strict=False)) if a != b)
        fault = broken_step(system, run, 1.0)
        return ("wrong: engine" if fault else "integrator differs"), f"entry {k}, {fault}"
    worst = float(np.abs(times - instants).max())
    return ("agree", "") if worst < 1e-6 else ("wrong: times", f"{worst:.1e}")


def _integrated(
    system: PiecewiseLinear, state: np.ndarray, c: int, transitions: int
) -> tuple[list[int], np.ndarray]:
    """Configurations and times by solve_ivp."""
    from scipy.integrate import solve_ivp

    y, now, found, times = np.array(state), 0.0, [c], [0.0]
    for _ in range(transitions):
        field, boundaries = system.fields[c], system.structure.boundaries[c]
        events = []
        for boundary in boundaries:
            row = system.rows[boundary.row]

            def height(_: float, y: np.ndarray, row: np.ndarray = row) -> float:
                return float(row[:-1] @ y + row[-1])

            event: Any = height  # solve_ivp reads attributes of the function
            event.terminal, event.direction = True, 1.0
            events.append(event)
        solution = solve_ivp(
            lambda _, y, a=field[:, :-1], b=field[:, -1]: a @ y + b,
            (0.0, 300.0),
            y,
            method="DOP853",
            rtol=1e-12,
            atol=1e-13,
            max_step=0.02,
            events=events,
        )
        reached = [i for i, instants in enumerate(solution.t_events) if len(instants)]
        if not reached:
            break
        c, y = _next(system, c, reached[0], solution.y[:, -1])
        now += float(solution.t[-1])
        found.append(c)
        times.append(now)
    return found, np.array(times)


def _next(system: PiecewiseLinear, c: int, reached: int, y: np.ndarray) -> tuple[int, np.ndarray]:
    """Next configuration and state behind one boundary; small values count as zero."""
    for transition in system.structure.transitions[c]:
        if transition.boundaries != {reached}:
            continue
        for row, along, holds in transition.conditions:
            matrix = np.vstack([system.fields[along], np.zeros(len(y) + 1)])
            function, value = system.rows[row], 0.0
            for _ in range(len(y) + 1):
                value = float(function @ np.append(y, 1.0))
                if abs(value) > 1e-8:
                    break
                function = function @ matrix
            if (value > 1e-8) != holds:
                break
        else:
            matrix = system.resets[transition.reset]
            return transition.target, matrix[:, :-1] @ y + matrix[:, -1]
    raise RuntimeError("no transition applies")
