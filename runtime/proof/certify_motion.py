"""A simulation that is a proof: the sequence of configurations of one motion, in balls.

From an exact start, with exact parameters, every transition is proved to be the next one. Which
boundary is next, and about when, is looked for along the middles of balls; the checker judges it.
Where that cannot tell, at any precision that is allowed, the proof says when and why and stops.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import count
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.checker.state_sets.one_motion import OneMotion
from nonsmooth.runtime.checker.state_sets.one_way import Unlisted
from nonsmooth.runtime.checker.state_sets.sets import TooWide, row_of
from nonsmooth.runtime.checker.stated.exact import Elimination, Failure, fixed, reduced
from nonsmooth.runtime.core.errors import InputError, check_integer, unknown_name
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.events.transition_choice import Decider
from nonsmooth.runtime.model.contacts.unfolding import Route, unfolded
from nonsmooth.runtime.model.kernels import SystemKernels, kernels_of
from nonsmooth.runtime.model.loading.declared import DeclaredSystem
from nonsmooth.runtime.model.structure import Structure
from nonsmooth.runtime.proof.certificate import Enclosure, Proof, exactly
from nonsmooth.runtime.proof.sets.sections import whole_system
from nonsmooth.runtime.proof.statement import ExactSystem, exact_system, floats_of
from nonsmooth.runtime.simulation.starting import forcing_start

if TYPE_CHECKING:
    from flint import arb

__all__ = ["Enclosure", "Proof", "certify_motion"]

_FEWEST_BITS = 64
_MOST_IMMEDIATE = 64  # transitions without any time between them
_STEP = 0.2  # radians of the fastest motion
_LONGEST = 100_000  # steps in one phase
_LOOKS = frozenset(64 * 2**k for k in range(12))  # steps after which for ever is judged
_ERROR = 2.0**-40  # of a state, where what a law says is guessed
_QUIET = "no boundary is reached any more"


def certify_motion(
    system: str | SystemKernels | DeclaredSystem,
    parameters: Mapping[str, object],
    state: Mapping[str, object] | Sequence[object],
    configuration: str,
    transitions: int,
    bits: int = 128,
    *,
    most_bits: int = 2048,
) -> Proof:
    """Prove the sequence of configurations of the motion from an exact start.

    Two boundaries reached at exactly one instant, and one touched exactly tangentially,
    cannot be told from nearly so by balls of any precision, unless the equations make the
    one function a multiple of the other: such a motion is proved up to there.

    Parameters
    ----------
    system : str or SystemKernels
    parameters : mapping of str to str, number or Value
        All of them, rational; a float means its shortest decimal, as elsewhere.
    state : mapping by name, or sequence in the order of the system
        Positions, then velocities: decimal or rational texts, fractions, or floats, which
        are taken exactly as they are in binary. By name, a forcing c, s that is left out starts at
        c = 1, s = 0.
    configuration : str
    transitions : int
        How many to prove.
    bits : int
        Precision to begin with; doubled up to `most_bits` where it does not do.
    most_bits : int

    Returns
    -------
    Proof
        What is proved of the motion, and why it ends where it does.

    Raises
    ------
    InputError
        For a wrong name or number, a parameter that is not rational, or a state that does
        not belong to the configuration.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> data = dict(chi="0.5", eta="1", V="1", us1="1", us2="1", ur1="4.0195", ur2="1.4831")
    >>> proof = ns.certify.motion("dry-friction", data, ["5", "4", "0.5", "0.25"], "slip-slip", 2)
    >>> proof.decided, proof.configurations
    (True, ('slip-slip', 'slip-stick', 'slip-slip'))
    """
    for name, number, least in (
        ("transitions", transitions, 0),
        ("bits", bits, _FEWEST_BITS),
        ("most_bits", most_bits, _FEWEST_BITS),
    ):
        check_integer(name, number, least)
    kernels = kernels_of(system)
    exact = exact_system(kernels, parameters)
    start = _start(exact.structure, state)
    index = exact.structure.configuration(configuration)
    _check_belongs(exact, index, start)
    for cosine, sine in exact.structure.forcing:
        if start[cosine] ** 2 + start[sine] ** 2 != 1:
            c, s = exact.structure.states[cosine], exact.structure.states[sine]
            raise InputError(
                f"the forcing starts at {c} = {start[cosine]}, {s} = {start[sine]}:"
                f" {c}^2 + {s}^2 is not 1"
            )
    routes: list[Route] = []  # of a contact law, as far as the motion is known to take them
    stated = whole_system(exact)
    while True:
        with flint_precision(bits):
            try:
                proved = OneMotion(stated, configuration, start)
            except Failure as problem:
                raise InputError(f"the state is not in {configuration}: {problem}") from None
            motion = _Motion(exact, proved)
            motion.run(transitions)
            route = motion.unlisted
            if route is not None and route not in routes:
                routes.append(route)
                exact = exact_system(unfolded(kernels, routes), parameters)
                stated = whole_system(exact)
                continue
            if motion.digits and 2 * bits <= most_bits:
                bits *= 2
                continue
            return motion.proof(bits)


class _Motion:
    """The motion as far as it is proved, at one precision."""

    def __init__(self, system: ExactSystem, proved: OneMotion) -> None:
        self.system, self.proved = system, proved
        self.configurations, self.times = [proved.entry.here], [proved.time]
        self.states, self.sets = [proved.state], list[tuple[str, ...]]()
        self.reason: str | None = None  # why it ends, and when
        self.instant: arb | None = None
        self.digits = False  # whether more digits may help
        self.unlisted: Route | None = None  # what a contact law seems to say at its end

    def run(self, transitions: int) -> None:
        """Prove so many transitions, or set the reason why there are fewer."""
        immediate = 0
        while len(self.sets) < transitions and self.reason is None:
            try:
                immediate = 0 if self._transition() else immediate + 1
            except TooWide as trouble:
                self.digits = True
                self._stop(trouble.reason, trouble.at)
            except Failure as failure:
                self._stop(str(failure))
            if immediate > _MOST_IMMEDIATE:
                self._stop("transitions follow each other without any time between them")

    def _stop(self, reason: str, at: arb | None = None) -> None:
        self.reason, self.instant = reason, self.proved.arrival if at is None else at

    def _transition(self) -> bool:
        """Prove the next transition; return whether time passes before it."""
        motion = self.proved
        reached = motion.passed()
        if reached:
            self._take(reached, None)
            return False
        phase = motion.phase
        short = 2 * phase.step
        length = _STEP / phase.fastest if phase.fastest else short
        try:
            self._arrive(length)
        except TooWide as trouble:
            if not short < length:
                raise
            try:  # what grows by no eigenvalue may come and go within a step
                self._arrive(short)
            except Unlisted:
                raise
            except Failure:  # so many short steps decide nothing; more digits may
                raise trouble from None
        return True

    def _arrive(self, length: float) -> None:
        """Prove what is reached next, as a search by steps of that length finds it."""
        about = self._next(length)
        if about is None:
            self.reason = _QUIET
        else:
            self._take(*about)

    def _take(self, reached: frozenset[str], dwell: arb | None) -> None:
        """Prove that boundaries are reached after a dwell time, or passed at once."""
        motion, here = self.proved, self.proved.entry.here
        try:
            if dwell is None:
                motion.pass_on(reached)
            else:
                motion.arrive(reached, dwell)
        except Unlisted:
            self.unlisted = self._route(here, reached, dwell)
            raise
        self.configurations.append(motion.entry.here)
        self.sets.append(
            tuple(name for name in self.proved.system.boundaries[here] if name in reached)
        )
        self.times.append(self.times[-1] if dwell is None else motion.time)
        self.states.append(motion.state)

    def _next(self, length: float) -> tuple[frozenset[str], arb] | None:
        """Return what seems to be reached next, and when; None if proved that nothing is.

        It is looked for by steps of that length. What comes so close to zero that digits may be
        missing counts as reached: the checker tells.
        """
        from flint import arb, arb_mat, ctx

        motion, phase = self.proved, self.proved.phase
        sets = motion.moving()
        if not sets:
            return None
        rows = arb_mat([row_of(phase.rows[min(names)]).entries() for names in sets])
        step = arb(length)
        flow, rates = phase.flow(step).mid(), (rows * phase.matrix).mid()
        state, since = motion.states.centre, arb(0)
        slopes, orders = (rates * state).entries(), motion.entry.watched(motion.states)
        for k, names in enumerate(sets):
            if orders[min(names)] > 1:  # exactly zero at first, and negative behind
                slopes[k] = arb(0)
        sizes = [sum(map(abs, row), arb(0)) * arb(2) ** -(ctx.prec // 2) for row in rows.tolist()]
        for number in count(1):
            ahead = (flow * state).mid()
            values, after = (rows * ahead).entries(), (rates * ahead).entries()
            found, largest = [], max(abs(x).upper() for x in ahead.entries())
            for k, names in enumerate(sets):
                close, end = (-sizes[k] * largest).mid(), step
                height = values[k]
                if height <= close and slopes[k] > 0 > after[k]:
                    end = _zero(phase, [-x for x in rates.tolist()[k]], state, step)
                    height = (rows * (phase.flow(end).mid() * state)).entries()[k].mid()
                if height > 0:
                    end = _zero(phase, rows.tolist()[k], state, end)
                if height > close:
                    found.append((since + end, names))
            if found:
                time, names = min(found, key=lambda each: each[0])
                return names, time.mid()
            state, since, slopes = ahead, since + step, after
            if number in _LOOKS and motion.never(since.mid()):
                return None
            if number == _LONGEST:
                told = " or ".join(sorted(name for names in sets for name in names))
                motion.clear(since.mid())
                raise Failure(f"no boundary is reached, and {told} still could be")
        raise AssertionError

    def _route(self, source: str, reached: frozenset[str], dwell: arb | None) -> Route | None:
        """Return what the contact law seems to say of boundaries; None if it says nothing."""
        structure, motion = self.system.structure, self.proved
        place, names = structure.configuration(source), tuple(sorted(reached))
        event = None if structure.law is None else structure.law.event(place, names)
        if event is None:
            return None
        column = motion.states.centre
        if dwell is not None:
            column = motion.phase.flow(dwell) * column
        states = [float(x.mid()) for x in column.entries()[: motion.system.size]]
        exact = self.system.exact
        fields, rows, resets = map(floats_of, (exact.fields, exact.rows, exact.resets))
        decider = Decider(structure, fields[:, :-1], rows, resets[:, :-1])
        known = np.array([*states, 1.0])
        guess = decider.outcome(event, decider.located(place, known, _ERROR))
        if len(guess.targets) != 1:
            return None
        return Route(source, names, structure.configurations[guess.targets[0]], guess.paths[0])

    def proof(self, bits: int) -> Proof:
        """Return what is proved of the motion."""

        def enclosed(ball: Any) -> Enclosure:
            return Enclosure(ball, bits)

        quiet, reason, instant = self.reason == _QUIET, self.reason, None
        if self.reason is not None and not quiet:
            assert self.instant is not None
            instant = enclosed(self.instant)
            told = f" ({bits} bits)" if self.digits else ""
            reason = (
                f"phase {len(self.sets) + 1}, {self.configurations[-1]}, at t = "
                f"{self.instant.str(20)}: {self.reason}{told}"
            )
        return Proof(
            self.system.structure.name,
            self.system.values,
            tuple(self.configurations),
            tuple(self.sets),
            tuple(map(enclosed, self.times)),
            tuple(tuple(map(enclosed, state)) for state in self.states),
            quiet or self.reason is None,
            reason,
            instant,
            bits,
        )


def _zero(phase: Any, row: Sequence[arb], state: Any, end: arb) -> arb:
    """Return about where a function is zero that is positive at the end of a time.

    It is Newton's method, or a bisection where a step leaves the bracket or does not get shorter.
    """
    from flint import arb, arb_mat, ctx

    both = arb_mat([list(row)])
    both = arb_mat([both.entries(), (both * phase.matrix).entries()])
    low, high, time, last = arb(0), end, (end / 2).mid(), end
    for _ in range(2 * ctx.prec):
        value, slope = (x.mid() for x in (both * (phase.flow(time).mid() * state)).entries())
        low, high = (time, high) if value < 0 else (low, time)
        step = (value / slope).mid() if slope > 0 else last
        moved = (time - step).mid()
        if not (low < moved < high and 2 * abs(step) < last):
            moved = ((low + high) / 2).mid()
            step = time - moved
        last = abs(step).mid()
        time = moved
        if last <= time * arb(2) ** (-16 - ctx.prec // 2):
            break
    return time


def _start(structure: Structure, state: Mapping[str, object] | Sequence[object]) -> list[Any]:
    """Return the start as rationals, in the system's order of the states."""
    names = structure.states
    if isinstance(state, Mapping):
        for name in state:
            if name not in names:
                raise unknown_name("state", str(name), names)
        state = {**forcing_start(structure), **state}
        missing = [name for name in names if name not in state]
        if missing:
            raise InputError(f"the state needs a value for: {', '.join(missing)}")
        state = [state[name] for name in names]
    if isinstance(state, str) or len(state) != len(names):
        raise InputError(f"the state is not {len(names)} numbers: {', '.join(names)}")
    return [exactly(x, name) for name, x in zip(names, state, strict=True)]


def _check_belongs(system: ExactSystem, configuration: int, start: Sequence[Any]) -> None:
    """Refuse a start beyond a boundary, or off what the configuration holds.

    It holds what is true behind every reset into it, and stays true in it.
    """
    structure, exact, exactly = system.structure, system.exact, Elimination()
    name = structure.configurations[configuration]
    facts = fixed(len(start), enumerate(start))
    for boundary in structure.boundaries[configuration]:
        if reduced(exact.rows[boundary.row], facts)[-1] > 0:
            raise InputError(f"the state is not in {name}: it is beyond {boundary.name}")
    resets = {
        t.reset for found in structure.transitions for t in found if t.target == configuration
    }
    rows = [row for reset in resets for row in exactly.left_kernel(exact.resets[reset])]
    held = exactly.echelon(rows)
    if all(any(row[:-1]) for row in held):
        for row in exactly.lasting(held, exact.fields[configuration]):
            if any(reduced(row, facts)):
                raise InputError(f"the state is not in {name}, where {_equation(structure, row)}")


def _equation(structure: Structure, row: Sequence[Any]) -> str:
    """Return an invariant as text, such as v1 = 1."""
    terms = [
        f"{'' if x == 1 else f'{x} '}{name}"
        for x, name in zip(row, structure.states, strict=False)
        if x
    ]
    return f"{' + '.join(terms)} = {-row[-1]}"
