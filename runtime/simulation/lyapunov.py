"""Lyapunov exponents of a motion, with their errors.

They are the exponents of what can be perturbed: on a periodic orbit log|multiplier| / period of
its nontrivial multipliers. Without forcing that is the quotient by the motion's own direction
f, which flows and transitions carry along: its norm is the distance from the span of f. A
forcing gives its phase and amplitude, so that perturbations of positions and velocities at
fixed times are all; they stay such, and the motion's own direction is none of them.

A transition that sets a velocity (a mass that begins to stick) annihilates a direction. It
is gone for ever, and its exponent is minus infinity.

Perturbations are made orthonormal again and again (G. Benettin et al., Meccanica 15, 1980).
Their rates of growth are averaged over time with the weight exp(-1/(u (1 - u))) on 0 < u < 1: over
a periodic or quasi-periodic motion that converges faster than any power of the time (S. Das, Y.
Saiki, E. Sander, J. Yorke, Quantitative quasiperiodicity, Nonlinearity 30, 2017). The standard
error is the scatter of such averages over shorter windows that overlap (P. Welch, IEEE Trans.
Audio Electroacoust. 15, 1967). Perturbations of a neutral motion may grow like the time itself:
their rate, 1/age, is no exponent, and as much of it as the windows do not exclude is part of the
error.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.simulation.motion_linearisation import field_at, transitions_behind
from nonsmooth.runtime.simulation.moved_phases import flow_matrices
from nonsmooth.runtime.simulation.phase_functions import phases_of
from nonsmooth.runtime.simulation.trajectory import Trajectory

_REST = 64 * np.finfo(float).eps  # of a vector field's terms: their sum is zero
_LOST = 1e-13  # of the norm of a frame: a direction that a transition annihilates
_DEPENDENT = 1e-8  # of the norm of a frame: a column that the others span
_SEED = 1
_WINDOWS = 15  # each an eighth of the time, and half over the next
_SHARE = 2 / (_WINDOWS + 1)
_PIECES = 256  # at least, of the time that counts
_DECAY = 8.0  # largest |real exponent| times the length of a piece
_MOST_PIECES = 1_000_000
_LEAST_TURNS = 30.0  # transitions, and oscillations of the slowest exponent
_SIGNIFICANT = 3.0  # standard errors
_SMALL = 0.1  # growth in a turn below which an exponent may be zero


class Exponent(NamedTuple):
    """A Lyapunov exponent and its standard error.

    Minus infinity, without error, for a direction that transitions annihilate, or that the
    constraints of the configuration do not leave in which counting begins.
    """

    value: float
    error: float

    @property
    def positive(self) -> bool:
        """Whether it lies above zero by more than three standard errors: chaos."""
        return self.value > _SIGNIFICANT * self.error


class _Growth(NamedTuple):
    """Growth of perturbations in m pieces of the time from `since` on."""

    begin: float  # time from which on the perturbations are carried
    middles: np.ndarray  # (m,) times
    lengths: np.ndarray  # (m,)
    logs: np.ndarray  # (m, directions) of the directions that are not annihilated


def lyapunov(trajectory: Trajectory, since: float = 0.0) -> Exponent:
    """Estimate the largest Lyapunov exponent of a motion, with its standard error.

    On a stable periodic orbit it is log|largest nontrivial multiplier| / period.

    Parameters
    ----------
    trajectory : Trajectory
    since : float
        Where to begin to count, behind a transient; the perturbations are carried from the
        start of the motion on, so that they have turned to their directions by then.

    Returns
    -------
    Exponent
        In units of one over time.

    Raises
    ------
    InputError
        If `since` is not between the start and the end of the motion; if the motion from there
        on is too short to tell the exponent, or at rest; or if it has no derivative: two
        boundaries are reached at once, or one tangentially.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> data = dict(chi="0.5", eta=1, V=1, us1=1, us2=1, ur1="4.0195", ur2="1.4831")
    >>> motion = ns.simulate("dry-friction", data, [0, 0, 0, 0], transitions=400)
    >>> ns.lyapunov(motion, since=50).value < 0
    True
    """
    return lyapunov_spectrum(trajectory, since)[0]


def lyapunov_spectrum(trajectory: Trajectory, since: float = 0.0) -> tuple[Exponent, ...]:
    """Estimate all Lyapunov exponents of a motion, the largest first, per unit of time.

    There is one for each position and velocity, and one less without forcing: the motion's
    own direction is left out. Only the time from `since` on counts, but the perturbations
    are carried from the start on. Directions that are annihilated have the exponent
    -infinity. The motion is refused as by `lyapunov`.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> data = dict(chi="0.5", eta=1, V=1, us1=1, us2=1, ur1="4.0195", ur2="1.4831")
    >>> motion = ns.simulate("dry-friction", data, [0, 0, 0, 0], transitions=400)
    >>> [exponent.value for exponent in lyapunov_spectrum(motion, since=50)[1:]]
    [-inf, -inf]
    """
    phases_of(trajectory, since)
    since = float(since)
    growth = _growth(trajectory, since)
    turns = _turns(trajectory, since)
    if turns < _LEAST_TURNS:
        raise _too_short(trajectory, since)
    length = trajectory.end - since
    begins = since + length * _SHARE / 2 * np.arange(_WINDOWS)
    windows = np.array([_average(growth, begin, length * _SHARE) for begin in begins])
    values = _average(growth, since, length)
    scatter = windows.std(axis=0, ddof=1) * math.sqrt(_SHARE)
    errors = np.hypot(scatter, _algebraic(windows, begins + length * _SHARE / 2 - growth.begin))
    found = [Exponent(*pair) for pair in zip(values.tolist(), errors.tolist(), strict=True)]
    found.sort(reverse=True)
    for value, error in found[:1]:
        if _SIGNIFICANT * error > max(abs(value), _SMALL * turns / length):
            raise _too_short(trajectory, since, f": it is {value:.2g} with an error of {error:.2g}")
    lost = len(_perturbed(trajectory)) - (not trajectory.structure.forcing) - len(found)
    return (*found, *[Exponent(-math.inf, 0.0)] * lost)


def _turns(trajectory: Trajectory, since: float) -> float:
    """Number of transitions, plus that of oscillations with the slowest exponents."""
    phases, system = phases_of(trajectory, since), trajectory.system
    turns = float(len(phases.begins) - 1)
    for configuration in np.unique(phases.configurations).tolist():
        speeds = np.hypot(*system.exponents[configuration].T)
        if speeds.any():
            spent = float(phases.durations[phases.configurations == configuration].sum())
            turns += spent * float(speeds[speeds > 0].min()) / (2 * math.pi)
    return turns


def _too_short(trajectory: Trajectory, since: float, told: str = "") -> InputError:
    return InputError(
        f"from t = {since:.6g} to {trajectory.end:.6g} the motion is too short to tell its largest"
        f" Lyapunov exponent{told}; follow it longer, or count from later on"
    )


def _perturbed(trajectory: Trajectory) -> list[int]:
    """Indices of the states that can be perturbed: all but those of the forcing."""
    forced = trajectory.structure.forced
    return [k for k in range(len(trajectory.names)) if k not in forced]


def _growth(trajectory: Trajectory, since: float) -> _Growth:
    """Growth of a frame of perturbations along a motion.

    Up to `since` the frame is filled up with all directions that the constraints allow.
    """
    system = trajectory.system
    own = np.ix_(kept := _perturbed(trajectory), kept)
    forced = bool(trajectory.structure.forcing)
    first, saltations = _saltations(trajectory, since)
    run = trajectory.run
    begins, configurations = run.times[first:].tolist(), run.configurations[first:].tolist()
    ends = [*begins[1:], trajectory.end]
    longest = _pieces(system, configurations, np.subtract(ends, begins), trajectory.end - since)
    count = len(kept) - (not forced)
    generator = np.random.default_rng(_SEED)
    frame, alive = np.empty((len(kept), 0)), np.empty(0, dtype=int)
    middles, lengths, logs = [], [], []
    for place, (phase, configuration) in enumerate(zip(begins, configurations, strict=True)):
        field = None if forced else _direction(trajectory, first + place)
        if phase <= since and len(alive) < count:
            others = generator.normal(size=(len(kept), count))
            every = np.hstack([frame, _allowed(system, configuration, kept) @ others])
            frame, _, _ = _orthonormal(every, np.arange(every.shape[1]), field, _DEPENDENT)
            alive = np.arange(frame.shape[1])
        for begin, length, number in _cut(phase, ends[place], longest[place], since):
            flow = flow_matrices(system, configuration, np.array([length]))[0][own]
            for piece in range(number):
                field = None if field is None else flow @ field
                frame, alive, grown = _orthonormal(flow @ frame, alive, field, lost=0.0)
                if begin >= since:
                    middles.append(begin + (piece + 0.5) * length)
                    lengths.append(length)
                    logs.append(_placed(count, alive, grown))
        if place < len(saltations):
            field = None if forced else _direction(trajectory, first + place + 1)
            frame, alive, grown = _orthonormal(saltations[place][own] @ frame, alive, field)
            if ends[place] > since:
                logs[-1] += _placed(count, alive, grown)
    kept_logs = np.array(logs)[:, alive]
    return _Growth(begins[0], np.array(middles), np.array(lengths), kept_logs)


def _saltations(trajectory: Trajectory, since: float) -> tuple[int, np.ndarray]:
    """The earliest entry from which a motion has a derivative, and the saltations (m, N, N) behind.

    An `InputError` is raised if it has none from the time `since` on: two boundaries are reached
    at once, or one is touched.
    """
    run = trajectory.run
    touched = [grazing.time for grazing in run.grazings]
    for time in touched:
        if time > since:
            raise InputError(f"a boundary is reached tangentially at t = {time!r}")
    together = run.times[(run.sets & (run.sets - 1)) != 0].tolist()
    last = max(time for time in (0.0, *touched, *together) if time <= since)
    latest = int(np.searchsorted(run.times, since, side="right")) - 1
    first = min(int(np.searchsorted(run.times, last)), latest)
    found = transitions_behind(trajectory, first)
    normals = trajectory.system.rows[found.rows][:, None, :-1]
    linear = trajectory.system.resets[found.resets][..., :-1]
    return first, linear + found.late()[:, :-1, None] * normals


def _placed(count: int, places: np.ndarray, values: np.ndarray) -> np.ndarray:
    found = np.zeros(count)
    found[places] = values
    return found


def _pieces(
    system: PiecewiseLinear, configurations: list[int], durations: np.ndarray, counted: float
) -> np.ndarray:
    """The longest piece allowed in each phase, so short that no direction underflows.

    The time that counts has `_PIECES` at least.
    """
    rates = [np.abs(system.exponents[c][:, 0]).max(initial=0.0) for c in configurations]
    with np.errstate(divide="ignore"):
        longest = np.minimum(_DECAY / np.array(rates), counted / _PIECES)
    total = float((durations / longest).sum())
    if total > _MOST_PIECES:
        raise InputError(
            f"the motion decays too fast for its length: perturbations would be carried in"
            f" {total:.0f} steps, at most {_MOST_PIECES}"
        )
    return np.asarray(longest)


def _cut(
    begin: float, end: float, longest: float, since: float
) -> Iterator[tuple[float, float, int]]:
    """Yield begin, length and number of the equal pieces of a phase, which is cut at `since`."""
    parts = [(begin, since), (since, end)] if begin < since < end else [(begin, end)]
    for low, high in parts:
        number = max(1, math.ceil((high - low) / longest))
        yield low, (high - low) / number, number


def _allowed(system: PiecewiseLinear, configuration: int, kept: list[int]) -> np.ndarray:
    """Projection onto the perturbations that the constraints of a configuration allow."""
    normals = system.rows[list(system.structure.constraints[configuration])][:, kept]
    return np.asarray(np.eye(len(kept)) - np.linalg.pinv(normals) @ normals)


def _direction(trajectory: Trajectory, entry: int) -> np.ndarray:
    """The motion's own direction behind an entry."""
    run, system = trajectory.run, trajectory.system
    configuration, start = int(run.configurations[entry]), run.states[entry]
    field = field_at(system, configuration, start)
    terms = np.abs(system.fields[configuration]) @ np.append(np.abs(start), 1.0)
    if (np.abs(field) <= _REST * terms).all():
        raise InputError(
            f"the motion is at rest at t = {run.times[entry]:.6g}: it has no direction"
        )
    return field


def _orthonormal(
    frame: np.ndarray, alive: np.ndarray, field: np.ndarray | None, lost: float = _LOST
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Orthonormal frame transverse to the field, its column numbers, and logarithms of growth.

    Columns shorter than `lost` times the frame are annihilated and left out.
    """
    least = lost * float(np.abs(frame).max(initial=0.0))
    if field is not None:
        unit = field / np.linalg.norm(field)
        frame = frame - np.outer(unit, unit @ frame)
    while frame.shape[1]:
        turned, upper = np.linalg.qr(frame)
        growth = np.abs(np.diag(upper))
        dead = np.flatnonzero(growth <= least)
        if not dead.size:
            return turned, alive, np.log(growth)
        # those behind it were made orthogonal to rounding errors
        frame, alive = np.delete(frame, dead[0], axis=1), np.delete(alive, dead[0])
    return frame, alive, np.empty(0)


def _average(growth: _Growth, begin: float, length: float) -> np.ndarray:
    """Smoothly weighted rates of growth (directions,) over a window."""
    part = (growth.middles - begin) / length
    inside = (part > 0) & (part < 1)
    part = part[inside]
    weights = np.exp(-1 / (part * (1 - part)))
    return np.asarray(weights @ growth.logs[inside] / (weights @ growth.lengths[inside]))


def _algebraic(windows: np.ndarray, ages: np.ndarray) -> np.ndarray:
    """Largest rates of exponents that may come from growth by a power of time.

    In each direction, the rates in the windows are fitted by a + b / age with least
    squares. The result has |b| and twice its error, at most 1, times the mean of 1 / age.
    """
    shape = 1 / ages - (1 / ages).mean()
    factors = shape @ windows / (shape @ shape)
    rest = windows - windows.mean(axis=0) - np.outer(shape, factors)
    # half the windows are independent
    errors = np.sqrt((rest**2).sum(axis=0) / (len(ages) / 2 - 2) / (shape @ shape) * 2)
    return np.asarray(np.minimum(np.abs(factors) + 2 * errors, 1.0) * (1 / ages).mean())
