"""Random chains of five to twelve masses: the compiled engine against a run in fifty digits.

The run in fifty digits shares nothing with the engine but the numbers of the fields, rows and
resets: samples of the boundary functions by the matrix exponential, and where one may be reached
the Taylor series of the state, in balls. It tells how near the motion comes to grazing and to
coincidences, and how far rounding may have moved it by then.
"""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np

from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.model.kernels import compiled_engine
from nonsmooth.runtime.model.modes.numeric_modes import numeric_modes
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.model.structure import BoundaryShape, Structure, TransitionShape
from nonsmooth.runtime.simulation.engines import run_compiled

TRANSITIONS = 40
BITS = 200  # sixty digits
STEP = 2.0**-6
SAMPLES = 256
WINDOWS = 100  # without a transition: the motion counts as quiet
TERMS = 24  # of a series over one step
NEAR = 1e-5  # of a boundary function: it is looked at exactly
ZERO = 1e-40  # what fifty digits take for zero
ROUNDING = 32 * float(np.finfo(float).eps)  # of one stay, in units of the largest state
DEVIATIONS = 8.0  # standard ones of the rounding that has gathered


def random_chain(rng: np.random.Generator) -> tuple[PiecewiseLinear, np.ndarray]:
    """A random forced chain with rigid stops, a soft one and perhaps friction; and a start.

    The start is (N,). Its configurations are sliding forwards, sticking and backwards, then
    the same with the soft stop touched; or, without friction, two.
    """
    count = int(rng.integers(5, 13))
    masses, springs = rng.uniform(0.5, 2, count), rng.uniform(0.5, 2, count + 1)
    stiffness = np.diag(springs[:-1] + springs[1:])
    stiffness -= np.diag(springs[1:-1], 1) + np.diag(springs[1:-1], -1)
    damping = rng.uniform(0, 0.05) * stiffness + np.diag(rng.uniform(0, 0.05, count))
    soft, rubbing, *hard = rng.permutation(count).tolist()
    hard, rubs = hard[: int(rng.integers(1, 4))], rng.random() < 0.7
    size = 2 * count + 2
    free = np.zeros((size, size + 1))
    free[:count, count : 2 * count] = np.eye(count)
    free[count:-2, :count] = -stiffness / masses[:, None]
    free[count:-2, count:-3] = -damping / masses[:, None]
    pushed = count + int(rng.integers(count))
    free[pushed, -3] = rng.uniform(0.5, 2)
    free[-2, -2], free[-1, -3] = -1.0, 1.0
    free[-2:] *= rng.uniform(0.3, 1.5)
    touched = free.copy()
    gap, stiff = rng.uniform(0.2, 0.6), rng.uniform(1, 10) / masses[soft]
    touched[count + soft, soft] -= stiff
    touched[count + soft, -1] += stiff * gap
    rows, resets = (
        [_row(size, soft, 1.0, -gap), _row(size, soft, -1.0, gap)],
        [np.eye(size, size + 1)],
    )
    stops = []
    for mass in hard:
        bounce = np.eye(size, size + 1)
        bounce[count + mass, count + mass] = -rng.uniform(
            0.85, 1
        )  # no flights that rounding decides
        stops.append((len(rows), len(resets)))
        rows.append(_row(size, mass, float(rng.choice([-1, 1])), -rng.uniform(0.1, 0.5)))
        resets.append(bounce)
    fields = [free, touched]
    if rubs:
        fields, rows, resets = _rubbing(fields, rows, resets, rubbing, rng.uniform(0.05, 0.5))
    system = _system(np.stack(fields), np.stack(rows), np.stack(resets), stops, bool(rubs))
    start = np.array([*rng.uniform(-0.05, 0.05, count), *rng.normal(size=count), 1.0, 0.0])
    start[count + rubbing] = abs(start[count + rubbing])
    return system, start


def _row(size: int, place: int, factor: float, constant: float) -> np.ndarray:
    row = np.zeros(size + 1)
    row[place], row[-1] = factor, constant
    return row


def _rubbing(
    fields: list[np.ndarray],
    rows: list[np.ndarray],
    resets: list[np.ndarray],
    mass: int,
    limit: float,
) -> tuple[list[np.ndarray], list[np.ndarray], list[np.ndarray]]:
    """Fields, rows and resets with three regimes for each field.

    Rows of velocities and forces, and a reset to rest, are added at the end.
    """
    size = len(fields[0])
    velocity = (size - 2) // 2 + mass
    found, forces = [], []
    for field in fields:
        forwards, held, backwards = field.copy(), field.copy(), field.copy()
        forwards[velocity, -1] -= limit
        backwards[velocity, -1] += limit
        held[[mass, velocity]] = 0.0
        found += [forwards, held, backwards]
        for sign in (1, -1):
            force = sign * field[velocity]
            force[-1] -= limit
            forces.append(force)
    rest = np.eye(size, size + 1)
    rest[velocity, velocity] = 0.0
    slow = [_row(size, velocity, sign, 0.0) for sign in (-1.0, 1.0)]
    return found, [*rows, *slow, *forces], [*resets, rest]


def _system(
    fields: np.ndarray,
    rows: np.ndarray,
    resets: np.ndarray,
    stops: list[tuple[int, int]],
    rubs: bool,
) -> PiecewiseLinear:
    """The system with the boundaries and transitions of the soft stop, rigid ones and friction."""
    size, regimes, rest = fields.shape[1], 3 if rubs else 1, len(resets) - 1
    boundaries, transitions = [], []
    slow = 2 + len(stops)
    for touched in range(2):
        for regime in range(regimes):
            here = regimes * touched + regime
            names = [BoundaryShape("soft", touched, False)]
            names += [BoundaryShape(f"stop{k}", row, True) for k, (row, _) in enumerate(stops)]
            there = regimes * (1 - touched) + regime
            found = [TransitionShape(frozenset({0}), (), 0, there)]
            found += [
                TransitionShape(frozenset({k + 1}), (), reset, here)
                for k, (_, reset) in enumerate(stops)
            ]
            force, last = slow + 2 + 2 * touched, frozenset({len(names)})
            held = regimes * touched + 1
            if rubs and regime == 1:
                names += [BoundaryShape(f"pushed{k}", force + k, False) for k in range(2)]
                found += [
                    TransitionShape(frozenset({len(names) - 2 + k}), (), 0, held - 1 + 2 * k)
                    for k in range(2)
                ]
            elif rubs:
                names.append(BoundaryShape("slow", slow + regime // 2, True))
                found += [
                    TransitionShape(last, ((force, held, True),), rest, held - 1),
                    TransitionShape(last, ((force + 1, held, True),), rest, held + 1),
                    TransitionShape(last, (), rest, held),
                ]
            boundaries.append(tuple(names))
            transitions.append(tuple(found))
    modes = [numeric_modes(field) for field in fields]
    count = len(fields)
    structure = Structure(
        "chain",
        tuple(f"y{i}" for i in range(size)),
        tuple(f"c{i}" for i in range(count)),
        tuple(m.shapes for m in modes),
        ((),) * count,
        ((),) * count,
        tuple(boundaries),
        tuple(transitions),
        (),
        len(rows),
        len(resets),
        ((size - 2, size - 1),),
    )
    exponents, flows = tuple(m.exponents for m in modes), tuple(m.flows for m in modes)
    return PiecewiseLinear(structure, {}, fields, rows, resets, exponents, flows)


@dataclass(frozen=True)
class _Event:
    time: float
    entry: tuple[int, int]  # configuration, set that led to it


class _DigitsPhase:
    """One configuration in fifty digits."""

    def __init__(self, system: PiecewiseLinear, index: int) -> None:
        from flint import arb_mat

        self.boundaries = system.structure.boundaries[index]
        self.whole = np.vstack([system.fields[index], np.zeros(len(system.fields[index]) + 1)])
        self.rows = system.rows[[b.row for b in self.boundaries]]
        self.exact = arb_mat(self.whole.tolist())
        self.exact_rows = arb_mat(self.rows.tolist())
        self._powers = [(self.exact * STEP).exp().mid()]

    def power(self, k: int) -> Any:
        """The flow over 2^k steps."""
        while len(self._powers) <= k:
            self._powers.append((self._powers[-1] * self._powers[-1]).mid())
        return self._powers[k]

    def steps(self, state: Any, count: int) -> Any:
        """The state after so many steps."""
        for k in range(count.bit_length()):
            if count >> k & 1:
                state = (self.power(k) * state).mid()
        return state

    def flow(self, steps: float) -> np.ndarray:
        """The flow over a time given in steps, in doubles."""
        whole, part = divmod(steps, 1.0)
        found = term = np.eye(len(self.whole))
        for k in range(1, TERMS):
            term = term @ self.whole * (part * STEP / k)
            found = found + term
        for k in range(int(whole).bit_length()):
            if int(whole) >> k & 1:
                found = found @ _doubles(self.power(k))
        return found

    @cached_property
    def samples(self) -> tuple[np.ndarray, np.ndarray]:
        """Matrices for values and slopes at the ends of steps: (samples + 1, boundaries, N + 1)."""
        step = _doubles(self.power(0))
        found = [self.rows]
        for _ in range(SAMPLES):
            found.append(found[-1] @ step)
        values = np.array(found)
        return values, values @ self.whole

    def series(self, state: Any, rows: Any) -> np.ndarray:
        """Taylor coefficients (rows, terms) over one step, as balls."""
        found = []
        for k in range(TERMS):
            found.append((rows * state).entries())
            state = (self.exact * state * STEP / (k + 1)).mid()
        return np.array(found, dtype=object).T


def _doubles(matrix: Any) -> np.ndarray:
    return np.array([float(x) for x in matrix.entries()]).reshape(matrix.nrows(), matrix.ncols())


def _value(series: np.ndarray, u: Any) -> Any:
    total = series[-1]
    for coefficient in series[-2::-1]:
        total = total * u + coefficient
    return total


class _DigitsRun:
    """A motion in fifty digits, with the rounding that a run in doubles may have gathered."""

    def __init__(self, system: PiecewiseLinear, state: np.ndarray) -> None:
        from flint import arb, arb_mat

        self.system = system
        self.phases: dict[int, _DigitsPhase] = {}
        self.state = arb_mat([[x] for x in [*state.tolist(), 1.0]])
        self.here, self.time = 0, arb(0)
        self.spread = np.zeros((len(state) + 1,) * 2)
        self.aside = ""

    def phase(self) -> _DigitsPhase:
        if self.here not in self.phases:
            self.phases[self.here] = _DigitsPhase(self.system, self.here)
        return self.phases[self.here]

    def advance(self) -> _Event | None:
        """The next transition, behind which the motion then is; None if there is none."""
        phase = self.phase()
        values, slopes = phase.samples
        for window in range(WINDOWS):
            state = _doubles(self.state)[:, 0]
            g, rate = values @ state, STEP * (slopes @ state)
            # the control points of a cubic are above it
            inner = np.maximum(g[:-1] + rate[:-1] / 3, g[1:] - rate[1:] / 3)
            highest = np.maximum(inner, np.maximum(g[:-1], g[1:]))
            for step in np.flatnonzero((highest > -NEAR).any(axis=1)).tolist():
                found = self._first(phase, step, highest[step], window == step == 0)
                if found is not None:
                    return self._cross(phase, step, *found)
            self._move(phase, SAMPLES)
        return None

    def _move(self, phase: _DigitsPhase, steps: int) -> None:
        self.state = phase.steps(self.state, steps)
        self.time += steps * STEP
        flow = phase.flow(steps)
        self.spread = flow @ self.spread @ flow.T

    def _first(
        self, phase: _DigitsPhase, step: int, highest: np.ndarray, begins: bool
    ) -> tuple[int, Any] | None:
        """The boundary that is crossed first in a step, and the time; None if none is."""
        start = phase.steps(self.state, step)
        series = phase.series(start, phase.exact_rows)
        first: tuple[int, Any] | None = None
        for b in np.flatnonzero(highest > -NEAR).tolist():
            where = self._crossing(phase, step, series[b], begins, b)
            if where is not None and (first is None or where < first[1]):
                first = b, where
        return first

    def _crossing(
        self, phase: _DigitsPhase, step: int, series: np.ndarray, begins: bool, b: int
    ) -> Any | None:
        from flint import arb

        doubles = np.array([float(c) for c in series])
        slope = doubles[1:] * np.arange(1, TERMS)
        scale = np.abs(slope).max()
        order = int(np.argmax(np.abs(slope) > 1e-18 * scale)) if scale else 0
        roots = np.roots(np.trim_zeros(slope[order:], "b")[::-1])
        inside = roots[(np.abs(roots.imag) < 1e-3) & (roots.real > 0) & (roots.real < 1)].real
        ends = [arb(0), *(arb(float(u)) for u in np.sort(inside)), arb(1)]
        heights = [_value(series, u) for u in ends]
        for u, height in zip(ends[1:-1], heights[1:-1], strict=True):
            if abs(float(height)) < NEAR:
                self._near(phase, step, float(u), b, float(height), "grazing")
        if begins and heights[0] > ZERO:  # a bound that an impact elsewhere has moved past
            self._near(phase, step, 0.0, b, float(heights[0]), "a beginning")
            return ends[0]
        for (low, high), (before, after) in zip(pairwise(ends), pairwise(heights), strict=True):
            if after > 0 and not before > ZERO:
                return _root(series, low, high)
        return None

    def _near(
        self, phase: _DigitsPhase, step: int, u: float, b: int, height: float, what: str
    ) -> None:
        """Set the motion aside if a value is so small that rounding may have decided."""
        flow = phase.flow(step + u)
        row = phase.rows[b] @ flow
        size = np.abs(row) @ np.abs(_doubles(self.state)[:, 0])
        bound = DEVIATIONS * math.sqrt(max(row @ self.spread @ row, 0.0)) + ROUNDING * size
        if abs(height) <= bound:
            self.aside = f"{what} within {bound:.1e}"

    def _cross(self, phase: _DigitsPhase, step: int, b: int, u: Any) -> _Event:
        from flint import arb_mat

        self._move(phase, step)
        largest = np.abs(_doubles(self.state)).max()
        series = phase.series(self.state, arb_mat(np.eye(len(phase.whole)).tolist()))
        heights = phase.series(self.state, phase.exact_rows)
        for other, row in enumerate(heights):
            # one at which the phase began, and that is left, is no coincidence
            value = float(_value(row, u))
            if other != b and abs(value) < NEAR and abs(value) > ZERO:
                self._near(phase, 0, float(u), other, value, "coincidence")
        before = arb_mat([[_value(row, u)] for row in series])
        self.time += u * STEP
        taken = self._taken(b, before)
        self._spread_over(phase, float(u), b, before, taken, step == 0 and u == 0)
        after = arb_mat(self.system.resets[taken.reset].tolist()) * before
        self.state = arb_mat([*([x] for x in after.entries()), [1]]).mid()
        largest = max(largest, np.abs(_doubles(self.state)).max())
        self.spread[:-1, :-1] += (ROUNDING * largest) ** 2 * np.eye(len(self.spread) - 1)
        self.here = taken.target
        return _Event(float(self.time), (self.here, 1 << b))

    def _taken(self, b: int, before: Any) -> TransitionShape:
        """The transition whose conditions all hold."""
        from flint import arb_mat

        for transition in self.system.structure.transitions[self.here]:
            if transition.boundaries != {b}:
                continue
            for row, _, holds in transition.conditions:
                value = float((arb_mat([self.system.rows[row].tolist()]) * before).entries()[0])
                bound = math.sqrt(np.trace(self.spread)) * DEVIATIONS + ROUNDING
                if abs(value) < bound:
                    self.aside = f"a condition within {bound:.1e}"
                if (value > 0) != holds:
                    break
            else:
                return transition
        raise RuntimeError("no transition applies")

    def _spread_over(
        self,
        phase: _DigitsPhase,
        u: float,
        b: int,
        before: Any,
        taken: TransitionShape,
        at_once: bool,
    ) -> None:
        """Carry the rounding behind the transition by the saltation matrix."""
        flow, state = phase.flow(u), _doubles(before)[:, 0]
        velocity, size = phase.whole @ state, len(phase.whole)
        reset = np.vstack([self.system.resets[taken.reset], np.eye(1, size, size - 1)])
        field = np.vstack([self.system.fields[taken.target], np.zeros(size)])
        row = phase.rows[b].copy()
        row[-1] = 0.0
        late = (
            np.zeros(size)
            if at_once
            else (field @ reset @ state - reset @ velocity) / (row @ velocity)
        )
        jump = (reset + np.outer(late, row)) @ flow
        self.spread = jump @ self.spread @ jump.T


def _root(series: np.ndarray, low: Any, high: Any) -> Any:
    """The only zero between two places, by Newton's method with bisection as safeguard."""
    slope = series[1:] * np.arange(1, TERMS)
    middle = (low + high) / 2
    for _ in range(300):
        value = _value(series, middle).mid()
        low, high = (middle, high) if value < 0 else (low, middle)
        newton = (middle - value / _value(slope, middle)).mid()
        following = newton if low < newton < high else ((low + high) / 2).mid()
        if abs(following - middle) < 1e-55:
            return following
        middle = following
    return middle


def against_digits(
    system: PiecewiseLinear, state: np.ndarray, transitions: int = TRANSITIONS
) -> tuple[str, str]:
    """Verdict on the compiled engine against the run in fifty digits, and a detail.

    The system's transitions follow single boundaries and have values as conditions.
    Verdicts on wrong motions begin with "wrong", on those that rounding decides with "set
    aside".
    """
    engine = compiled_engine()
    if engine is None:
        raise RuntimeError("the compiled engine is not there")
    found = run_compiled(engine, system, state, 0, transitions=transitions)
    with flint_precision(BITS):
        exact = _DigitsRun(system, state)
        for k in range(1, transitions + 1):
            event = exact.advance()
            if exact.aside:
                return f"set aside: {exact.aside.split(' within')[0]}", f"entry {k}, {exact.aside}"
            if event is None:
                ended = k == len(found.times)
                return ("agree, quiet", "") if ended else ("wrong: not quiet", f"entry {k}")
            if k == len(found.times):
                return "wrong: ended", f"entry {k}, {found.status.name}"
            if event.entry != (int(found.configurations[k]), int(found.sets[k])):
                return "wrong: sequence", f"entry {k}, {event} {found.times[k]!r}"
            missed = abs(float(found.times[k]) - event.time)
            if missed > 1e-7:
                return "wrong: times", f"entry {k}, off by {missed:.1e}"
    return "agree", ""


def chains_chunk(seed: int, count: int) -> tuple[Counter[str], list[str]]:
    """Counts of verdicts on random chains, and details of those that do not agree."""
    verdicts: Counter[str] = Counter()
    told = []
    for place in range(count):
        system, state = random_chain(np.random.default_rng([seed, place]))
        verdict, detail = against_digits(system, state)
        verdicts[verdict] += 1
        if detail:
            told.append(
                f"{verdict}: seed [{seed}, {place}], {len(state) // 2 - 1} masses, {detail}"
            )
    return verdicts, told
