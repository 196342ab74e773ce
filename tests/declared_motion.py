"""Motions of declared systems at sixty digits: matrix exponentials, dense samples and roots."""

from fractions import Fraction
from functools import cache

import sympy as sp
from mpmath import MPContext

mp = MPContext()
mp.dps = 60
STEP = mp.mpf(1) / 32
OWN_ERROR = mp.mpf(10) ** -45


def number(value):
    fraction = Fraction(str(value))
    return mp.mpf(fraction.numerator) / fraction.denominator


class DeclaredMotion:
    """Fields, rows and resets as a declaration has them; states carry a last entry 1."""

    def __init__(self, system, values):
        at = {p.symbol: sp.Rational(str(Fraction(values[p.name]))) for p in system.parameters}
        states, last = system.states, [0] * len(system.states)
        zero = dict.fromkeys(states, 0)

        @cache  # many transitions have one condition
        def row(function):
            slopes = [sp.diff(function, state) for state in states]
            return [number(e.subs(at)) for e in (*slopes, sp.sympify(function).subs(zero))]

        def field(dynamics):
            matrix, offset = dynamics.field(states)
            rates = matrix * sp.Matrix(states) + offset
            return mp.matrix([*map(row, rates), [*last, 0]])

        self.fields = {c.name: field(c.dynamics) for c in system.configurations}
        self.strides = {name: mp.expm(field * STEP) for name, field in self.fields.items()}
        self.rows = {
            c.name: {b.name: mp.matrix([row(b.function)]) for b in c.boundaries}
            for c in system.configurations
        }
        self.transitions = [
            (t.source, t.boundaries, t.target,
             [(mp.matrix([row(c.function)]), c.along, c.holds) for c in t.conditions],
             mp.matrix([*(row(sp.sympify(t.reset.get(s, s))) for s in states), [*last, 1]]))
            for t in system.transitions
        ]  # fmt: skip

    def run(self, configuration, start, transitions):
        """Configurations, boundaries, instants and states behind so many transitions."""
        state, now = mp.matrix([*map(number, start), 1]), mp.mpf(0)
        names, sets, instants, states = [configuration], [], [now], [state]
        while len(sets) < transitions:
            rows, following = self.rows[configuration], self.strides[configuration] * state
            passed = [name for name, row in rows.items() if (row * following)[0] > 0]
            if not passed:
                now, state = now + STEP, following
                continue
            roots = {name: self.root(configuration, rows[name], state) for name in passed}
            boundary = min(roots, key=lambda name: roots[name])
            now += roots[boundary]
            state = self.flow(configuration, state, roots[boundary])
            configuration, state = self.after(configuration, boundary, state)
            names.append(configuration)
            sets.append((boundary,))
            instants.append(now)
            states.append(state)
        return tuple(names), tuple(sets), instants, states

    def flow(self, configuration, state, duration):
        """The state after a time no longer than a step, by the series of the exponential."""
        field, term, total = self.fields[configuration] * duration, state, state
        for k in range(1, 80):
            term = field * term / k
            total += term
            if mp.norm(term) < mp.mpf(10) ** -65:
                break
        return total

    def after(self, configuration, boundary, state):
        """By the first transition whose conditions hold."""
        for source, boundaries, target, conditions, reset in self.transitions:
            if (source, boundaries) == (configuration, {boundary}) and all(
                (self.leading(row, along, state) > 0) == holds for row, along, holds in conditions
            ):
                return target, reset * state
        raise AssertionError(f"no transition from {configuration} at {boundary}")

    def leading(self, row, along, state):
        """The first of a function and its derivatives along a motion that is not zero."""
        values = []
        for _ in range(len(state)):
            values.append((row * state)[0])
            row *= self.fields[along]
        return next((value for value in values if abs(value) > OWN_ERROR), 0)

    def root(self, configuration, row, state):
        """Where a boundary is crossed within a step, by Newton's method between its ends."""
        low, high = mp.mpf(0), STEP
        field, at = self.fields[configuration], high
        for _ in range(60):
            there = self.flow(configuration, state, at)
            value, slope = (row * there)[0], (row * field * there)[0]
            low, high = (at, high) if value < 0 else (low, at)
            better = at - value / slope if slope > 0 else mp.mpf(-1)
            better = better if low <= better <= high else (low + high) / 2
            if abs(better - at) < mp.mpf(10) ** -56:
                return better
            at = better
        return at

    def agrees(self, proof, start, narrow):
        """Assert that the proved sequence is the motion's, and that narrow enclosures hold it."""

        def holds(enclosure, value):
            return bool(abs(mp.mpf(enclosure.mid) - value) <= mp.mpf(enclosure.rad) + OWN_ERROR)

        names, sets, instants, states = self.run(proof.configurations[0], start, proof.transitions)
        assert proof.decided
        assert proof.reason is None
        assert (proof.configurations, proof.sets) == (names, sets)
        for enclosure, instant in zip(proof.times, instants, strict=True):
            assert holds(enclosure, instant)
            assert float(enclosure.rad) < narrow
        for balls, state in zip(proof.states, states, strict=True):
            assert all(holds(ball, x) for ball, x in zip(balls, [*state][:-1], strict=True))
            assert all(float(ball.rad) < narrow for ball in balls)
