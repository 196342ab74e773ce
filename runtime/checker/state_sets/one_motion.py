"""One motion from an exact start: that the boundaries that are told are the next ones.

Nothing else is reached before, for all times; the transition that follows is the first whose
conditions hold. What is exactly known of the state is kept beside its enclosure: balls alone could
never tell a velocity that was set to the belt's from nearly so.

Along a flow an affine function is a sum of terms c t^k e^(st) / k!. The exponents s are the roots
of its minimal polynomial, which is found exactly: so are their multiplicities, and which of them
lie on the imaginary axis. By their sizes it may be seen to stay negative for ever.
"""

from collections.abc import Sequence
from math import comb, factorial
from typing import Any

from flint import acb, acb_mat, arb, arb_mat, ctx, fmpq, fmpq_poly

from nonsmooth.runtime.checker.state_sets.one_way import CarryingSystem, Entry
from nonsmooth.runtime.checker.state_sets.portions import direction
from nonsmooth.runtime.checker.state_sets.sets import CarryingPhase, StateSet, TooWide, row_of
from nonsmooth.runtime.checker.state_sets.switching import SwitchingSystem
from nonsmooth.runtime.checker.stated.exact import (
    Elimination,
    Numbers,
    column,
    demand,
    fixed,
    product,
    reduced,
)
from nonsmooth.runtime.core.rational_functions import pivot

Row = Any  # exact, over (y, 1)


def stays_negative(
    row: Row, field: Sequence[Row], lasting: Sequence[Row], state: Sequence[arb], time: arb
) -> bool:
    """Whether an affine function is proved to be negative from a time on, for ever.

    `row` and `field` are exact and act on (y, 1). `lasting` holds along the motion, `state`
    encloses it at time 0, and `time` is exact and not negative.
    """
    rows, minimal = _sequence(row, field, lasting)
    found = _coefficients(rows, _exponents(minimal), state)
    if found is None:
        return False
    total = arb(0)
    for exponent, coefficients in found:
        bound = (
            _drift([c.real for c in coefficients], time)
            if exponent == 0
            else _size(exponent.real, coefficients, time)
        )
        if bound is None:
            return False
        total += bound
    return bool(total < 0)


def _sequence(row: Row, field: Sequence[Row], lasting: Sequence[Row]) -> tuple[list[Row], Row]:
    """Return the rows of the independent derivatives, and the coefficients of the next one by them.

    These are the coefficients of the function's minimal polynomial.
    """
    rows = [reduced(row, lasting)]
    while not (kernel := Elimination().left_kernel(rows)):
        rows.append(reduced(product(rows[-1], field), lasting))
    return rows[:-1], kernel[0]


def _exponents(minimal: Row) -> list[tuple[acb, int]]:
    """Return a rational polynomial's roots with their multiplicities; real parts 0 are exact."""

    def roots(coefficients: Sequence[Any]) -> list[acb]:
        pairs: Any = fmpq_poly(list(coefficients)).complex_roots()
        return [acb(root) for root, _ in pairs]

    found = []
    for factor, multiplicity in fmpq_poly(list(minimal)).factor()[1]:
        coefficients = factor.coeffs()
        if len(coefficients) > 2 and not any(coefficients[1::2]):
            for square in roots(coefficients[::2]):
                below = square.imag.is_zero() and square.real < 0
                root = acb(0, (-square.real).sqrt()) if below else square.sqrt()
                found += [(root, multiplicity), (-root, multiplicity)]
        else:
            found += [(root, multiplicity) for root in roots(coefficients)]
    return found


def _coefficients(
    rows: Sequence[Row], exponents: Sequence[tuple[acb, int]], state: Sequence[arb]
) -> list[tuple[acb, list[acb]]] | None:
    """Return each exponent with the coefficients c of its terms, by the power of t.

    None is returned if the digits do not tell the exponents apart.
    """
    size = len(rows)
    columns = [
        [comb(j, k) * exponent ** (j - k) if j >= k else acb(0) for j in range(size)]
        for exponent, multiplicity in exponents
        for k in range(multiplicity)
    ]
    wronskian = acb_mat(size, size, [columns[i][j] for j in range(size) for i in range(size)])
    try:
        weights = wronskian.solve(acb_mat([[acb(entry) for entry in row] for row in rows]))
    except ZeroDivisionError:
        return None
    values = (weights * acb_mat([[acb(x)] for x in (*state, arb(1))])).entries()
    found, first = [], 0
    for exponent, multiplicity in exponents:
        found.append((exponent, values[first : first + multiplicity]))
        first += multiplicity
    return found


def _drift(coefficients: Sequence[arb], time: arb) -> arb | None:
    """Return the value of a polynomial at a time from which it does not rise, else None."""
    derivatives = [
        sum((c * time**j / factorial(j) for j, c in enumerate(coefficients[k:])), 0 * time)
        for k in range(len(coefficients))
    ]
    return derivatives[0] if all(d <= 0 for d in derivatives[1:]) else None


def _size(rate: arb, coefficients: Sequence[acb], time: arb) -> arb | None:
    """Return a bound, from a time on, of the terms with one exponent that is not zero, or None."""
    total = 0 * time
    for k, coefficient in enumerate(coefficients):
        if coefficient == 0:
            continue
        if rate.is_zero() and not k:
            total += abs(coefficient)
            continue
        if not rate < 0:
            return None
        # t^k e^(rate t) falls from its maximum on
        latest = time.max(-k / rate)
        total += abs(coefficient) * latest**k / factorial(k) * (rate * latest).exp()
    return total


_DEEPEST = 500  # halvings of a phase, at most: its windows are doubles
_SLOW = "{} is reached tangentially, or comes closer than the digits tell"
_AT_ONCE = "{} and {} are reached at one instant, or closer together than the digits tell"


class OneMotion(CarryingSystem):
    """The motion from a start, as far as it is proved at the working precision.

    `Failure` is raised if the start is beyond a boundary of its configuration, or off what that
    holds.
    """

    def __init__(self, system: SwitchingSystem, configuration: str, start: Sequence[fmpq]) -> None:
        super().__init__(system)
        demand(configuration in system.fields, "there is no such configuration")
        demand(len(start) == system.size, "a state of another size")
        facts = fixed(system.size, enumerate(start))
        held, rows = system.held[configuration], system.boundaries[configuration]
        demand(not any(any(reduced(row, facts)) for row in held), "the start is off what is held")
        inside = all(reduced(row, facts)[-1] <= 0 for row in rows.values())
        demand(inside, "the start is beyond a boundary")
        self.entry = Entry(self, configuration, facts)
        self.states = _about([*map(arb, start), arb(0)])
        self.arrival = self.time  # up to which the motion is proved, in a ball

    @property
    def phase(self) -> CarryingPhase:
        """The phase that the motion is in."""
        return self.phases[self.entry.here]

    @property
    def time(self) -> Any:
        """The time since the start, in a ball."""
        return self.states.hull[self.system.size, 0]

    @property
    def state(self) -> list[Any]:
        """Balls (N) around the state."""
        found: list[Any] = self.states.hull.entries()[: self.system.size]
        return found

    def passed(self) -> frozenset[str]:
        """Return the boundaries that the phase begins beyond, or is about to pass; mostly none."""
        return self.entry.passed(self.states)

    def moving(self) -> list[frozenset[str]]:
        """Return the boundaries that may be reached along the phase; those reached together in one.

        These are functions of which one is a multiple of the other, by what lasts in the phase.
        """
        field, lasting = self.system.fields[self.entry.here], self.entry.lasting
        alike: dict[Any, set[str]] = {}
        for name in self.entry.watched(self.states):
            row = self.phase.rows[name]
            if any(reduced(product(row, field), lasting)):
                alike.setdefault(direction(reduced(row, lasting)), set()).add(name)
        return [*map(frozenset, alike.values())]

    def pass_on(self, reached: frozenset[str]) -> None:
        """Take the transition behind the boundaries that the phase begins beyond, in no time."""
        demand(reached and reached == self.passed(), "other boundaries are passed at once")
        self._go_on(reached, self.states, at_once=True)

    def arrive(self, reached: frozenset[str], about: Any) -> None:
        """Show that boundaries are the next ones, `about` when, and take the transition behind.

        `TooWide` is raised with the reason if that is not known, and nothing is reached before the
        times that it tells. `Failure` is raised if no transition follows, or stops may act in
        several orders that do not agree: then `arrival` is when the boundaries are reached.
        """
        demand(reached in self.moving(), "other boundaries are reached together")
        phase, watched, first = self.phase, self.entry.watched(self.states), min(reached)
        own, others = ({name: order for name, order in watched.items() if (name in reached) == mine}
                       for mine in (True, False))  # fmt: skip
        row = row_of(phase.rows[first])
        least = 2.0 ** -min(ctx.prec // 2, _DEEPEST)
        try:
            arrived, before, after = phase.arrive(self.states, row, about, least)
        except TooWide:
            late = about * (1 + arb(2) ** -(ctx.prec // 4))
            self._clear(late.mid(), watched)
            raise TooWide(_SLOW.format(first), first, self._since(about.union(late))) from None
        self._clear(before, {first: own[first]}, first)
        try:
            self._clear(after, others)
        except TooWide as trouble:
            together = self._since(before).union(self._since(after))
            if trouble.at < together:
                raise
            told = _AT_ONCE.format(*sorted((first, trouble.name)))
            raise TooWide(told, trouble.name, together.union(trouble.at)) from None
        self._go_on(reached, arrived)

    def never(self, since: Any) -> bool:
        """Return whether no boundary is reached, if that follows from how it goes on for ever.

        Up to the time `since`, an exact one, all times are looked at.
        """
        field, state = self.system.fields[self.entry.here], self.state
        rows = [self.phase.rows[min(names)] for names in self.moving()]
        if not all(stays_negative(row, field, self.entry.lasting, state, since) for row in rows):
            return False
        self.clear(since)
        return True

    def clear(self, until: Any) -> None:
        """Show that no boundary is reached up to a time since the phase's start, an exact one."""
        self._clear(until, self.entry.watched(self.states))
        self.arrival = self._since(until)

    def _clear(self, until: Any, watched: dict[str, int], ends: str | None = None) -> None:
        """Show that no boundary is reached up to a time.

        If that is not known it is shown up to the times that are told, and if the one that `ends`
        is watched alone, of all others too.
        """
        deepest = min(ctx.prec // 2, _DEEPEST)
        try:
            self.phase.clear(self.states, until, watched, ends, deepest)
        except TooWide as trouble:
            before, told = trouble.at.lower(), _SLOW.format(trouble.name)
            if ends and before > 0:
                others = self.entry.watched(self.states)
                del others[ends]
                self._clear(before, others)
            raise TooWide(told, trouble.name, self._since(trouble.at)) from None

    def _since(self, time: Any) -> Any:
        """Return the time since the start, for one since the phase's start."""
        return self.time + time

    def _go_on(self, reached: frozenset[str], states: StateSet, *, at_once: bool = False) -> None:
        """Take the transition behind boundaries that are reached."""
        self.arrival = states.hull[self.system.size, 0]
        behind, entry = self.entry.behind(reached, states, at_once=at_once)
        demand(all(any(row[:-1]) for row in entry.facts), "what is known contradicts itself")
        found = behind.hull.entries()[:-1]
        for row in entry.facts:  # what gives a state exactly, or better
            place = pivot(row)
            pairs = zip(row[:-1], found, strict=False)
            given = -sum(
                (x * y for k, (x, y) in enumerate(pairs) if x and k != place), arb(row[-1])
            )
            found[place] = given if given.rad() <= found[place].rad() else found[place]
        self.states, self.entry = _about(found), entry


def _about(numbers: Numbers) -> StateSet:
    """Return the set of (states, time, 1) in some balls of states and time."""
    return StateSet.of(
        column((*numbers, arb(1))),
        arb_mat(len(numbers) + 1, 0),
        arb_mat(len(numbers) + 1, 1),
    )
