"""Where a motion has one-sided derivatives alone, and those that it has on each side.

At a grazing, at a start on a boundary and at a time that is that of a transition the motion goes
on smoothly on one side: where the touched boundary function falls, or the transition comes
earlier. What a number does not move has a derivative all the same.

Boundaries that a motion reaches together come apart when it is moved by e d: at times that are
linear in e. Which of them comes first, and what follows then, is what the engine does from a
start shortly in front of them, moved by a small e. The derivative in the direction d is that of
this sequence at e = 0, with no time between its transitions: the product of their saltation
matrices (S. A. Burden, S. S. Sastry, D. E. Koditschek and S. Revzen, SIAM J. Appl. Dyn. Syst. 15,
2016). It holds if the sequence comes to where the motion itself goes on.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.engine_run import Status
from nonsmooth.runtime.model.flows import extended, flow_states
from nonsmooth.runtime.model.piecewise import PiecewiseLinear, piecewise
from nonsmooth.runtime.shooting.shooting_map import relative_rates
from nonsmooth.runtime.simulation.motion_linearisation import (
    MotionChanges,
    MotionLinearisation,
    field_at,
    fitting_resets,
    nearest_start,
)
from nonsmooth.runtime.simulation.simulate import simulate_one
from nonsmooth.runtime.simulation.trajectory import Trajectory

_TOGETHER = 1e-9  # by which linearised boundary functions may differ that vanish together
_NEAR = 1e-8  # relative: within which a sequence comes to where the motion is
_STEPS = (1e-5, 1e-7)  # of the time to the neighbouring transitions: how far events come apart
_FRONT, _BEHIND, _MOST = 20.0, 1e3, 64  # where to look, in these steps; how many transitions


@dataclass(frozen=True, eq=False)
class DirectedMotion(MotionLinearisation):
    """A motion with an entry for each transition that it makes when moved in some directions."""

    columns: np.ndarray  # (k,) indices of these directions among all
    settled: float  # time up to which no boundaries come apart any more
    # (n - 1,) for each transition of the original motion the first that replaces it
    first: np.ndarray
    last: np.ndarray  # (n - 1,) and the last
    # (n - 1,) bool: transitions of the original motion whose times have no derivative
    open: np.ndarray

    def only(self, members: list[int]) -> DirectedMotion:
        """The same motion for some of its directions."""
        directions, columns = self.directions[:, members], self.columns[members]
        return replace(self, directions=directions, columns=columns)


def directed_motions(
    trajectory: Trajectory,
    by: tuple[str, ...],
    directions: np.ndarray,
    times: np.ndarray,
    side: str | None,
) -> tuple[DirectedMotion, ...]:
    """The motions that replace one whose coincident boundaries come apart when it is moved.

    The columns of `directions` (numbers, q) are changes of the numbers `by`, and `times` (m,) are
    held fixed. The motion moves along the directions for the side "+", against them for "-"; for
    None both ways have to agree. The motions returned have each direction once. An `InputError`
    names the boundaries, the time and the direction if a moved motion goes on elsewhere, if both
    sides differ, or if one touches a boundary without the derivatives that are asked for.
    """
    count = len(trajectory.times) - 1
    same, none = np.arange(count), np.zeros(count, dtype=bool)
    columns = np.arange(directions.shape[1])
    known = trajectory, by, directions, times
    todo = [DirectedMotion(*known, none, columns, -1.0, same, same, none)]
    done = []
    while todo:
        motion = todo.pop()
        moment = _next_moment(motion)
        if moment is None:
            _check_sides(motion, side)
            done.append(motion)
        else:
            todo.extend(_split(motion, moment, side))
    return tuple(done)


def gathered(parts: Sequence[DirectedMotion], directions: int) -> MotionChanges:
    """Derivatives of the original motion along all directions, from its parts.

    They are NaN where a transition of the original motion has
    no derivative, but for the beginnings of phases.
    """
    part, count = parts[0], len(parts[0].first)
    if len(parts) == 1 and len(part.apart) == count and not part.open.any():
        return part.changes
    pieces = [_kept(part) for part in parts]
    every = MotionChanges(*(np.empty((*piece.shape[:-1], directions)) for piece in pieces[0]))
    for part, own in zip(parts, pieces, strict=True):
        for whole, piece in zip(every, own, strict=True):
            whole[..., part.columns] = piece
    return every


def _kept(part: DirectedMotion) -> MotionChanges:
    """The derivatives of a part at the original motion's transitions, NaN where it has none."""
    first, last = (np.concatenate([[0], places + 1]) for places in (part.first, part.last))
    states, events, before, behind, beginnings = part.changes
    kept = MotionChanges(states, events[part.first], before[first], behind[last], beginnings[last])
    for whole, skipped in zip(kept[1:4], (0, 1, 1), strict=True):
        whole[np.flatnonzero(part.open) + skipped] = np.nan
    return kept


def scattered(
    part: DirectedMotion,
    states: np.ndarray,
    event_times: np.ndarray,
    before: np.ndarray,
    behind: np.ndarray,
) -> tuple[np.ndarray, ...]:
    """Factors of the original motion's results, at the transitions that replace its own in a part.

    The shapes are (m, N) of `states`, (n - 1,) of `event_times`, (n, N) of `before` and
    `behind`. A factor that is not zero becomes NaN where the result has no derivative.
    """
    count, size = part.trajectory.states.shape
    times, front, back = np.zeros(count - 1), np.zeros((count, size)), np.zeros((count, size))
    first, last = (np.concatenate([[0], places + 1]) for places in (part.first, part.last))
    for whole, places, given, skipped in (
        (times, part.first, event_times, 0),
        (front, first, before, 1),
        (back, last, behind, 1),
    ):
        entries = np.flatnonzero(part.open) + skipped
        taken = given.copy()
        taken[entries] = np.where(taken[entries] == 0, 0.0, np.nan)
        np.add.at(whole, places, taken)
    return states, times, front, back


class _Meeting(NamedTuple):
    """Transitions at one instant that become several in some moved motions."""

    begin: int  # entry of the first transition
    end: int  # entry of the last one
    apart: np.ndarray  # (k,) bool: directions in which the boundaries come apart
    change: np.ndarray  # (N, k) of the state before the transitions, at their fixed time
    size: np.ndarray  # (N, k) of the terms that the change is a sum of
    shift: np.ndarray  # (k,) largest change of the time at which a boundary is reached
    told: str  # text for a message


def _next_moment(motion: DirectedMotion) -> _Meeting | None:
    """The first instant after `settled` at which boundaries come apart; None if there is none."""
    trajectory = motion.trajectory
    system, run = trajectory.system, trajectory.run
    several = np.flatnonzero(((run.sets & (run.sets - 1)) != 0) & (run.times > motion.settled))
    if not several.size:
        return None
    events, before = motion.changes.event_times, motion.changes.before
    (tables, _), found = motion.moves, motion.transitions
    for entry in several.tolist():
        source = int(run.configurations[entry - 1])
        state, velocity = extended(run.before[entry]), found.velocities[entry - 1]
        change = before[entry] - velocity[:, None] * events[entry - 1]
        apart, shift = np.zeros((2, len(motion.columns)))
        for place, shape in enumerate(system.structure.boundaries[source]):
            if not int(run.sets[entry]) >> place & 1:
                continue
            row = system.rows[shape.row]
            own = tables.rows[:, shape.row].T * state[:, None]
            parts = row[:-1, None] * before[entry], own
            size = sum(np.abs(part).sum(axis=0) for part in parts)
            size = size + np.abs(row[:-1]) @ np.abs(velocity) * np.nanmax(np.abs(events))
            left = np.abs(sum(part.sum(axis=0) for part in parts))
            apart = apart + ~(left <= _TOGETHER * size)
            with np.errstate(divide="ignore", invalid="ignore"):
                later = np.abs((row[:-1] @ change + own.sum(axis=0)) / (row[:-1] @ velocity))
            shift = np.fmax(shift, later)
        if apart.any():
            names, at = " and ".join(trajectory.boundaries[entry]), float(run.times[entry])
            begin = max(1, int(np.searchsorted(run.times, at)))
            end = int(np.searchsorted(run.times, at, side="right")) - 1
            told = f"{names} are reached together at t = {at!r}"
            late = found.velocities[begin - 1][:, None] * events[begin - 1]
            usual = np.abs(run.states[[begin - 1, end]]).max(axis=0)
            size = np.abs(before[begin]) + np.abs(late) + usual[:, None] * shift / run.end
            return _Meeting(begin, end, apart > 0, before[begin] - late, size, shift, told)
    return None


def _split(motion: DirectedMotion, moment: _Meeting, side: str | None) -> Iterator[DirectedMotion]:
    """Yield the motions that replace one at a moment: one for each sequence of transitions.

    Each of them has the directions that pass the moment in its sequence.
    """
    settled = float(motion.trajectory.times[moment.begin])
    groups: dict[object, tuple[DirectedMotion, list[int]]] = {}
    for k in range(len(motion.columns)):
        if not moment.apart[k]:
            groups.setdefault(None, (replace(motion, settled=settled), []))[1].append(k)
            continue
        signs = {"+": (1.0,), "-": (-1.0,), None: (1.0, -1.0)}[side]
        ways = [_MovedPassage(motion.only([k]), moment, k, sign).passed() for sign in signs]
        if side is None:
            one, other = (behind for _, behind in ways)
            sizes = np.maximum(np.abs(one), moment.size[:, k])
            if not (np.abs(one - other) <= _TOGETHER * sizes).all():
                label = _told_direction(motion.by, motion.directions[:, k])
                raise InputError(f"{moment.told}: the motion has no derivative by {label} there")
            inside = (motion.first >= moment.begin - 1) & (motion.last < moment.end)
            ways = [(replace(way, open=way.open | inside), behind) for way, behind in ways]
        found = replace(ways[0][0], settled=settled)
        run = found.trajectory.run
        key = run.configurations.tobytes(), tuple(run.sets.tolist())
        groups.setdefault(key, (found, []))[1].append(k)
    for found, members in groups.values():
        own = motion.only(members)
        yield replace(found, directions=own.directions, columns=own.columns)


@dataclass(frozen=True, eq=False)
class _MovedPassage:
    """How a motion that is moved along one direction, or against it, passes a moment."""

    motion: DirectedMotion  # for that direction
    moment: _Meeting
    column: int  # of the direction in the moment
    sign: float

    def passed(self) -> tuple[DirectedMotion, np.ndarray]:
        """The motion with the moved one's transitions, and its change (N,) behind the moment."""
        trajectory, moment = self.motion.trajectory, self.moment
        run, begin, end = trajectory.run, moment.begin, moment.end
        if not np.isfinite([*moment.change[:, self.column], moment.shift[self.column]]).all():
            raise self._refused("one of them is touched, and the order is open")
        if run.times[begin] == run.times[begin - 1]:
            raise self._refused("no time passes in front of them")
        moved = [self._moved(step) for step in _STEPS]
        found, other = ((m.run.configurations.tolist(), m.run.sets.tolist()) for m in moved)
        if found != other:
            raise self._refused("the order is open to first order")
        local = moved[0]
        kernels = local.structure.kernels
        assert kernels is not None
        system = piecewise(kernels, trajectory.parameters)
        before, states = [], [run.before[begin]]
        for entry in range(1, len(local.times)):
            source, target = local.run.configurations[entry - 1 : entry + 1].tolist()
            reached = int(local.run.sets[entry])
            sides = local.before[entry : entry + 1], local.states[entry : entry + 1]
            (reset,) = fitting_resets(local.system, source, target, reached, *sides).tolist()
            before.append(states[-1])
            states.append(system.resets[reset] @ extended(states[-1]))
            for place, shape in enumerate(system.structure.boundaries[source]):
                terms = system.rows[shape.row] * extended(before[-1])
                missed = abs(terms.sum()) > _NEAR * np.abs(terms).sum()
                if missed and reached >> place & 1 and local.times[entry] > local.times[entry - 1]:
                    raise self._refused(f"{shape.name} follows")
        name = local.configurations[-1]
        order = ", then ".join(" and ".join(names) for names in local.boundaries[1:])
        behind = run.states[end]
        if name != trajectory.configurations[end] or not len(before):
            raise self._refused(f"{order} leads to {name}")
        if np.abs(states[-1] - behind).max() > _NEAR * np.abs(behind).max():
            raise self._refused(f"{order} leads to another state")
        found_run = replace(
            run,
            times=_put(run.times, begin, end, np.full(len(before), run.times[begin])),
            configurations=_put(run.configurations, begin, end, local.run.configurations[1:]),
            before=_put(run.before, begin, end, np.array(before)),
            states=_put(run.states, begin, end, np.array([*states[1:-1], behind])),
            sets=_put(run.sets, begin, end, local.run.sets[1:]),
        )
        way = self._inserted(Trajectory(system, found_run), np.diff(local.times) > 0)
        return way, self._checked(way, len(before))

    def _moved(self, step: float) -> Trajectory:
        """The moved motion near the moment, simulated with a small change of the numbers.

        The boundaries come apart by at most `step` times the time to the neighbouring
        transitions.
        """
        trajectory, moment = self.motion.trajectory, self.moment
        run, begin, end = trajectory.run, moment.begin, moment.end
        now, shift = float(run.times[begin]), float(moment.shift[self.column])
        waits = [now - float(run.times[begin - 1])]
        later = float(run.times[end + 1]) if end + 1 < len(run.times) else run.end
        waits += [later - now] * (later > now)
        width = step * min(waits)
        given = {name: float(value) for name, value in trajectory.parameters.items()}
        changes = zip(self.motion.by, self.motion.directions[:, 0].tolist(), strict=True)
        rates = {name: rate for name, rate in changes if name in given}
        size = self.sign * min(width / shift, step / self._rate if self._rate else np.inf)
        width = abs(size) * shift
        parameters = trajectory.parameters | {n: given[n] + size * r for n, r in rates.items() if r}
        source = int(run.configurations[begin - 1])
        front = _FRONT * width
        start = flow_states(
            trajectory.system, source, np.array([waits[0] - front]), run.states[begin - 1 : begin]
        )[0]
        start = start + size * moment.change[:, self.column]
        kernels = trajectory.structure.kernels
        assert kernels is not None
        start = nearest_start(piecewise(kernels, parameters), source, start)
        name = trajectory.structure.configurations[source]
        try:
            found = simulate_one(
                kernels, parameters, start.tolist(), name,
                until=front + _BEHIND * width, transitions=_MOST,
            )  # fmt: skip
        except InputError as error:
            raise self._refused(str(error)) from None
        if found.status != Status.UNTIL:
            raise self._refused(found.message)
        return found

    @cached_property
    def _rate(self) -> float:
        """Largest relative change of the system's numbers along the direction."""
        moved, _ = self.motion.moves
        system, motion = self.motion.trajectory.system, self.motion.trajectory
        ways = self.motion.transitions.velocities * np.diff(motion.times)[:, None]
        sizes = np.abs(np.concatenate([motion.before, ways])).max(axis=0)
        (found,) = relative_rates((system.fields, system.rows), (moved.fields, moved.rows), sizes)
        return float(found)

    def _inserted(self, trajectory: Trajectory, later: np.ndarray) -> DirectedMotion:
        """The motion with the transitions of `trajectory` in the moment.

        `later` marks those of them that come later than the one before (bool).
        """
        motion, begin, end = self.motion, self.moment.begin, self.moment.end
        first, last, opened = motion.first.copy(), motion.last.copy(), motion.open.copy()
        inside = (first >= begin - 1) & (last < end)
        more = len(later) - (end - begin + 1)
        behind = first >= end
        first[behind] += more
        last[behind] += more
        first[inside], last[inside] = begin - 1, begin + len(later) - 2
        opened[inside] |= inside.sum() > 1
        apart = np.concatenate([motion.apart[: begin - 1], [False], later[1:], motion.apart[end:]])
        return replace(
            motion, trajectory=trajectory, apart=apart, first=first, last=last, open=opened
        )

    def _checked(self, way: DirectedMotion, count: int) -> np.ndarray:
        """The change (N,) behind the moment at a fixed time.

        An order of transitions that is not decided to first order is refused.
        """
        try:
            found, changes = way.transitions, way.changes
        except InputError as error:
            raise self._refused(str(error)) from None
        events, behind = changes.event_times, changes.behind
        begin = self.moment.begin
        places = np.arange(begin - 1, begin - 1 + count)
        times = self.sign * events[places, 0]
        size = np.abs(times).max()
        sudden = ~found.smooth[places] & ~way.instants[places]
        units = np.append(np.abs(way.trajectory.states).max(axis=0), way.trajectory.times[-1])
        units = np.where(units > 0, units, 1.0)
        passages = way.saltations[0][places] * units / units[:, None]
        steep = np.abs(passages).max(axis=(1, 2)) > 1 / _NEAR
        if not (np.diff(times) >= -_NEAR * size).all() or (sudden & steep).any():
            raise self._refused("the order is open to first order")
        last = places[-1]
        return np.asarray(behind[last + 1, :, 0] - found.behind[last] * events[last, 0])

    def _refused(self, why: str) -> InputError:
        side = "+" if self.sign > 0 else "-"
        label = _told_direction(self.motion.by, self.motion.directions[:, 0])
        return InputError(
            f"{self.moment.told}: {why}; the motion has no derivative on the side {side}"
            f" by {label} there"
        )


def _put(array: np.ndarray, begin: int, end: int, new: np.ndarray) -> np.ndarray:
    """The array with the entries from `begin` to `end`, both included, replaced by others."""
    return np.concatenate([array[:begin], new.astype(array.dtype), array[end + 1 :]])


def _told_direction(by: tuple[str, ...], direction: np.ndarray) -> str:
    """The name of a direction for a message: that of its number if it changes only one."""
    moving = np.flatnonzero(direction)
    return by[moving[0]] if len(moving) == 1 else "the direction"


CUT = (Status.UNDECLARED, Status.IMMEDIATE, Status.OVERFLOW, Status.AMBIGUOUS)
_ERROR = 64 * np.finfo(float).eps


class _Touch(NamedTuple):
    """A boundary that is touched, and when: with its row, or with the transition's index."""

    told: str
    time: float
    row: int | None
    transition: int = 0


def check_times(trajectory: Trajectory, times: np.ndarray, one_sided: str | None) -> None:
    """Raise `InputError` for an unknown side, or for a time at which the motion breaks off.

    The times (m,) are held fixed.
    """
    if one_sided not in (None, "+", "-"):
        raise InputError(f"one_sided is {one_sided!r}, neither '+' nor '-'")
    last = np.abs(times - trajectory.end) <= 8 * np.spacing(times)
    if trajectory.status in CUT and last.any():
        raise InputError(
            f"the motion ends at t = {trajectory.end!r}: {trajectory.message};"
            " it has no derivative there"
        )


def _check_sides(motion: DirectedMotion, one_sided: str | None) -> None:
    """Raise `InputError` unless a motion has the derivatives that are asked for.

    The message names what is touched, when, and by which number it is passed.
    """
    trajectory, times = motion.trajectory, motion.times
    touches = [*_grazings(trajectory), *_beginnings(trajectory), *_coincidences(trajectory, times)]
    if not touches:
        return
    at = np.array([touch.time for touch in touches])
    (tables, _), changes = motion.moves, replace(motion, times=at).changes
    sign = {None: 0.0, "+": 1.0, "-": -1.0}[one_sided]
    smooth = motion.transitions.smooth
    for touch, change, state in zip(touches, changes.states, trajectory(at), strict=True):
        if touch.row is None:
            rises = changes.event_times[touch.transition]
            rises = np.where(smooth[touch.transition], 0.0, rises)
        else:
            row = trajectory.system.rows[touch.row]
            rises = row[:-1] @ change + tables.rows[:, touch.row] @ extended(state)
        wrong = np.flatnonzero(rises if one_sided is None else sign * rises > 0)
        if wrong.size:
            direction = motion.directions[:, wrong[0]]
            label, what = _told_direction(motion.by, direction), "derivative"
            if one_sided is not None:
                what = f"derivative on the side {one_sided}"
            raise InputError(
                f"{touch.told} at t = {touch.time!r}: the motion has no {what} by {label} there"
            )


def _grazings(trajectory: Trajectory) -> Iterator[_Touch]:
    for grazing in trajectory.grazings:
        state = trajectory(grazing.time)
        if not _smooth(trajectory.system, grazing.configuration, grazing.boundary, state):
            shape = trajectory.structure.boundaries[grazing.configuration][grazing.boundary]
            yield _Touch(f"{shape.name} is reached tangentially", grazing.time, shape.row)


def _beginnings(trajectory: Trajectory) -> Iterator[_Touch]:
    configuration, state = int(trajectory.run.configurations[0]), trajectory.states[0]
    for place, shape in enumerate(trajectory.structure.boundaries[configuration]):
        row = trajectory.system.rows[shape.row]
        error = _ERROR * (np.abs(row) @ extended(np.abs(state)))
        here = abs(row @ extended(state)) <= error
        if here and not _smooth(trajectory.system, configuration, place, state):
            yield _Touch(f"the start lies on {shape.name}", 0.0, shape.row)


def _coincidences(trajectory: Trajectory, times: np.ndarray) -> Iterator[_Touch]:
    events, near = trajectory.times[1:], 8 * np.spacing(times)
    first = np.searchsorted(events, times - near)
    behind = np.searchsorted(events, times + near, side="right")
    for which in np.flatnonzero(first < behind).tolist():
        for place in range(int(first[which]), int(behind[which])):
            told = f"{' and '.join(trajectory.boundaries[place + 1])} is reached"
            yield _Touch(told, float(times[which]), None, place)


def _smooth(system: PiecewiseLinear, configuration: int, boundary: int, state: np.ndarray) -> bool:
    """Whether the field is continuous across a boundary, and no reset moves the state."""
    found = system.structure.listed(configuration, frozenset({boundary}))
    velocity = field_at(system, configuration, state)
    size = np.abs(system.fields[configuration]) @ extended(np.abs(state))
    for transition in found:
        after = system.resets[transition.reset] @ extended(state)
        jump = field_at(system, transition.target, after) - velocity
        bound = size + np.abs(system.fields[transition.target]) @ extended(np.abs(after))
        if (np.abs(jump) > _ERROR * bound).any():
            return False
        if (np.abs(after - state) > _ERROR * np.abs(state)).any():
            return False
    return bool(found)
