"""A simulation that is a proof: the sequence of configurations of one motion, in balls.

From an exact start, with exact parameters, every transition is proved to be the next one:
no boundary is reached before it, and its conditions hold. Where balls cannot tell, at any
precision that is allowed, the proof says when and why and stops.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.errors import InputError, check_integer, unknown_name
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.events.leading_derivative import Undecided
from nonsmooth.runtime.events.transition_choice import choose
from nonsmooth.runtime.model.contacts.law import ContactEvent
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.loading.declared import DeclaredSystem
from nonsmooth.runtime.model.structure import Structure
from nonsmooth.runtime.proof.motion.enclosures import EnclosedSystem, enclosed_system
from nonsmooth.runtime.proof.motion.exact_rows import Invariants, evaluate
from nonsmooth.runtime.proof.motion.first_crossing import first_crossing
from nonsmooth.runtime.proof.motion.lawful import lawful
from nonsmooth.runtime.proof.motion.motion_proof import Enclosure, Proof, exactly

if TYPE_CHECKING:
    from flint import arb

__all__ = ["BallJudge", "Enclosure", "Proof", "validate"]

_FEWEST_BITS = 64
_MOST_IMMEDIATE = 64  # transitions without any time between them


def validate(
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
        are taken exactly as they are in binary.
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
    at = enclosed_system(system, parameters)
    structure = at(bits).structure
    start = _start(structure, state)
    index = structure.configuration(configuration)
    while True:
        with flint_precision(bits):
            motion = _Motion(at(bits), index, start)
            motion.run(transitions)
            trouble = motion.trouble
            if trouble is None or not trouble.digits or 2 * bits > most_bits:
                return motion.proof()
        bits *= 2


class _Motion:
    """The motion as far as it is proved, at one precision."""

    def __init__(self, system: EnclosedSystem, configuration: int, start: list[Any]) -> None:
        from flint import arb, fmpq

        self.system, self.configuration = system, configuration
        size = len(start)
        self.invariants = Invariants.of(
            [[*(fmpq(int(i == j)) for j in range(size)), -x] for i, x in enumerate(start)]
        )
        self.state = [arb(x) for x in start]
        self._belongs()
        self.time = arb(0)
        self.configurations, self.times, self.states = [configuration], [self.time], [self.state]
        self.sets: list[tuple[int, ...]] = []
        self.trouble: Undecided | None = None
        self.instant: arb | None = None
        self.quiet = False

    def _belongs(self) -> None:
        """Refuse a start beyond a boundary, or off what the configuration holds."""
        structure, exact = self.system.structure, self.system.exact
        name = structure.configurations[self.configuration]
        for boundary in structure.boundaries[self.configuration]:
            if self.system.value(exact.rows[boundary.row], self.invariants, self.state) > 0:
                raise InputError(f"the state is not in {name}: it is beyond {boundary.name}")
        for row in _held(self.system, self.configuration).rows:
            if any(self.invariants.reduce(row)):
                raise InputError(f"the state is not in {name}, where {_equation(structure, row)}")

    def run(self, transitions: int) -> None:
        """Prove so many transitions, or set `quiet` (no further one follows) or `trouble`."""
        immediate = 0
        try:
            while len(self.sets) < transitions and not self.quiet:
                before = self.time
                self._transition()
                immediate = immediate + 1 if self.time is before else 0
                if immediate > _MOST_IMMEDIATE:
                    raise Undecided(
                        "transitions follow each other without any time between them", digits=False
                    )
        except Undecided as trouble:
            self.trouble = trouble
            self.instant = self.time if trouble.at is None else self.time + trouble.at

    def _transition(self) -> None:
        system, here = self.system, self.configuration
        exact, structure = system.exact, system.structure
        lasting = self.invariants.lasting(exact.fields[here])
        found = first_crossing(system, here, self.invariants, lasting, self.state)
        if found is None:
            self.quiet = True
            return
        dwell, reached, state = found
        if dwell.is_zero():
            time, invariants = self.time, self.invariants
        else:
            time = self.time + dwell
            rows = [exact.rows[structure.boundaries[here][b].row] for b in reached]
            invariants = Invariants.of([*lasting.rows, *rows])
            state = invariants.tighten(state)
        judge = BallJudge(system, here, invariants, state)
        try:
            target, reset = _transition_behind(system, here, reached, judge)
        except Undecided as trouble:
            raise Undecided(trouble.reason, dwell, digits=trouble.digits) from None
        matrix = exact.resets[reset]
        self.invariants = invariants.reset(matrix)
        self.state = self.invariants.tighten([evaluate(row, state) for row in matrix[:-1]])
        self.time, self.configuration = time, target
        self.configurations.append(target)
        self.sets.append(reached)
        self.times.append(time)
        self.states.append(self.state)

    def proof(self) -> Proof:
        """Return what is proved of the motion, by name."""
        system = self.system
        structure, bits = system.structure, system.bits

        def enclosed(ball: Any) -> Enclosure:
            return Enclosure(ball, bits)

        names = structure.configurations
        instant = None if self.instant is None else enclosed(self.instant)
        reason = "no boundary is reached any more" if self.quiet else None
        if self.trouble is not None and self.instant is not None:
            phase = len(self.sets)
            told = f" ({bits} bits)" if self.trouble.digits else ""
            reason = (
                f"phase {phase + 1}, {names[self.configuration]}, at t = "
                f"{self.instant.str(20)}: {self.trouble.reason}{told}"
            )
        return Proof(
            structure.name,
            system.values,
            tuple(names[c] for c in self.configurations),
            tuple(
                tuple(structure.boundaries[c][b].name for b in reached)
                for c, reached in zip(self.configurations, self.sets, strict=False)
            ),
            tuple(map(enclosed, self.times)),
            tuple(tuple(map(enclosed, state)) for state in self.states),
            self.trouble is None,
            reason,
            instant,
            bits,
        )


def _transition_behind(
    system: EnclosedSystem, source: int, reached: tuple[int, ...], judge: BallJudge
) -> tuple[int, int]:
    """Return target and reset of the transition behind a set of boundaries reached in `source`.

    Where stops may act in several orders all orders have to agree. `Undecided` is raised if it is
    not proved what follows.
    """
    structure = system.structure
    choice = choose(structure, source, frozenset(reached), judge)
    transition = choice.transition

    def names(between: str = " with ") -> str:
        return between.join(structure.boundaries[source][b].name for b in reached)

    if choice.verdict == "undeclared":
        raise Undecided(f"no transition is declared for {names()}", digits=False)
    if choice.verdict == "ambiguous":
        both = names(" and ")
        raise Undecided(f"the orders in which {both} act need not agree", digits=False)
    if transition is None:
        raise Undecided(f"what the contact law says at {names()}")
    if choice.verdict == "undecided":
        target = structure.configurations[transition.target]
        raise Undecided(f"at {names()}, whether {target} follows: {choice.open}")
    return transition.target, transition.reset


@dataclass(frozen=True)
class BallJudge:
    """A `Judge` in balls, with what is exactly known of the state."""

    system: EnclosedSystem
    source: int  # configuration in which boundaries are reached
    facts: Invariants  # what is exactly true of the state: a boundary that was reached is zero
    state: Sequence[arb]

    def sign(self, row: int, along: int) -> int:
        """Return the proved sign of a row's leading derivative along a configuration's field.

        It is 0 if all derivatives are exactly zero.
        """
        exact = self.system.exact
        found = self.system.leading(exact.rows[row], along, self.facts, self.state)
        return 0 if found is None else found.sign

    def agree(self, resets: Sequence[int]) -> bool:
        """Whether resets lead to one state by what is exactly known."""
        first, *others = (self.system.exact.resets[reset] for reset in resets)
        return all(self.facts.agree(other, first) for other in others)

    def targets(self, event: ContactEvent) -> tuple[int, ...]:
        """Return the one configuration that is proved to follow by the contact law.

        `Undecided` is raised if that is not proved.
        """
        target = lawful(self.system, self.source, event, self.facts, self.state)
        if target is None:
            raise Undecided("what the contact law says")
        return (target,)


def _start(structure: Structure, state: Mapping[str, object] | Sequence[object]) -> list[Any]:
    """Return the start as rationals, in the system's order of the states."""
    names = structure.states
    if isinstance(state, Mapping):
        for name in state:
            if name not in names:
                raise unknown_name("state", str(name), names)
        missing = [name for name in names if name not in state]
        if missing:
            raise InputError(f"the state needs a value for: {', '.join(missing)}")
        state = [state[name] for name in names]
    if isinstance(state, str) or len(state) != len(names):
        raise InputError(f"the state is not {len(names)} numbers: {', '.join(names)}")
    return [exactly(x, name) for name, x in zip(names, state, strict=True)]


def _held(system: EnclosedSystem, configuration: int) -> Invariants:
    """Return what is true in a configuration by every reset into it, and stays true in it.

    There are no such invariants if the resets contradict each other.
    """
    exact, none = system.exact, Invariants(())
    resets = {
        transition.reset
        for found in system.structure.transitions
        for transition in found
        if transition.target == configuration
    }
    rows = [row for reset in resets for row in none.reset(exact.resets[reset]).rows]
    invariants = Invariants.of(rows)
    return invariants.lasting(exact.fields[configuration]) if invariants.consistent else none


def _equation(structure: Structure, row: Sequence[Any]) -> str:
    """Return an invariant as text, such as v1 = 1."""
    terms = [
        f"{'' if x == 1 else f'{x} '}{name}"
        for x, name in zip(row, structure.states, strict=False)
        if x
    ]
    return f"{' + '.join(terms)} = {-row[-1]}"
