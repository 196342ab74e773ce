"""Orbits from their declarations alone: matrix exponentials, root finding and resets.

No kernel takes part, so what agrees with this agrees with a second computation. States carry
a last entry 1, which makes every field, boundary and reset linear.
"""

from functools import cache

import mpmath
import numpy as np
import sympy as sp
from scipy.linalg import expm, null_space

from nonsmooth import solve
from nonsmooth.derive import SecondOrder
from nonsmooth.derive.systems import declaration

elastic_stop, rigid_stop = map(declaration, ("elastic-stop", "rigid-stop"))


@cache
def itinerary_of(name):
    """The declared itinerary of ``system/orbit``."""
    system, _, orbit = name.partition("/")
    (found,) = (i for i in declaration(system).orbits if i.name == orbit)
    return found


@cache
def _tables(name, modules):
    """Names of parameters, states and boundaries, and a function that gives each phase.

    It takes the parameters; a phase is its field, its reset, its boundaries' rows and those
    of the velocities it holds.
    """
    itinerary = itinerary_of(name)
    system = itinerary.presented_system
    states = system.states
    size, zero = len(states), dict.fromkeys(states, 0)

    def row(function):
        return [*(sp.diff(function, s) for s in states), function.subs(zero)]

    last = [*[sp.Integer(0)] * size, sp.Integer(1)]
    phases, names = [], []
    for index, phase in enumerate(itinerary.phases):
        configuration = system.configuration(phase.configuration)
        matrix, offset = configuration.dynamics.field(states)
        field = [[*matrix.row(i), offset[i]] for i in range(size)] + [[sp.Integer(0)] * (size + 1)]
        rules = dict(itinerary.transition_after(system, index).reset.items())
        jump = [row(sp.sympify(rules.get(s, s))) for s in states] + [last]
        held = []
        if isinstance(configuration.dynamics, SecondOrder):
            for place, velocity in configuration.dynamics.held_at(states).items():
                held.append(row(states[size // 2 + place] - velocity))
        names.append([b.name for b in configuration.boundaries])
        phases.append([field, jump, [row(b.function) for b in configuration.boundaries], held])
    symbols = [p.symbol for p in system.parameters]
    numbers = sp.lambdify(symbols, phases, modules)
    return [str(s) for s in symbols], [str(s) for s in states], names, numbers


class Piece:
    """One phase in numbers: field, exit boundary, reset, and all boundaries by name."""

    def __init__(self, phase, names, tables, dwell, precise):
        field, jump, boundaries, held = tables

        def matrix(rows):
            return mpmath.matrix(rows) if precise else np.array(rows, dtype=float)

        self.configuration, self.boundary, self.dwell = phase.configuration, phase.boundary, dwell
        self.field, self.jump = matrix(field), matrix(jump)
        self.boundaries = {n: matrix([row]) for n, row in zip(names, boundaries, strict=True)}
        self.normal = self.boundaries[phase.boundary]
        self.held = [matrix([row]) for row in held]
        self.precise = precise

    def flow(self, time):
        """Matrix exponential."""
        if self.precise:
            return mpmath.expm(self.field * time, method="taylor")
        return expm(self.field * time)

    def saltation(self, end, following):
        """R + (f+ - R f-) n/(n f-) at the state in front of the transition."""
        before = self.field @ end
        behind = following.field @ (self.jump @ end)
        rate = (self.normal @ before)[0, 0]
        return self.jump + (behind - self.jump @ before) @ self.normal / rate

    def exit_time(self, start, near):
        """When the exit boundary is reached, by Newton's method from a time nearby."""
        time = near
        for _ in range(50):
            end = self.flow(time) @ start
            step = ((self.normal @ end) / (self.normal @ (self.field @ end))).item()
            time -= step
            if abs(step) < 1e-15:
                break
        assert abs(step) < 1e-13
        return time


class Declared:
    """An orbit's phases in numbers: floats, or mpmath's global context at its precision."""

    def __init__(self, orbit, *, precise=False):
        self.orbit, self.itinerary = orbit, itinerary_of(orbit.name)
        number, modules = (mpmath.mpf, "mpmath") if precise else (float, "math")
        names, self.states, boundaries, numbers = _tables(orbit.name, modules)
        values = {**orbit.values, **orbit.kernels.required}
        values |= {n: float(v) for n, v in orbit.opened.items()}
        # an open parameter that has no value must not count
        tables = numbers(*(number(values.get(n, "nan")) for n in names))
        self.size = len(self.states)
        self.pieces = [
            Piece(phase, row, table, number(dwell), precise)
            for phase, row, table, dwell in zip(
                self.itinerary.phases, boundaries, tables, orbit.dwell_times, strict=True
            )
        ]
        start = [*(number(x) for x in orbit.states[0]), number(1)]
        self.start = mpmath.matrix(start) if precise else np.array(start)[:, None]

    @property
    def steps(self):
        """Each phase with the states at its start and at its end, in front of the reset."""
        found, state = [], self.start
        for piece in self.pieces:
            end = piece.flow(piece.dwell) @ state
            found.append((piece, state, end))
            state = piece.jump @ end
        return found

    @property
    def end(self):
        """State after one turn."""
        piece, _, end = self.steps[-1]
        return piece.jump @ end

    @property
    def missed(self):
        """By how much a phase misses its boundary, or a turn its start, at most."""
        ends = [abs((piece.normal @ end).item()) for piece, _, end in self.steps]
        return max(*ends, abs(self.end - self.start).max())

    def saltations(self):
        """Saltation matrix of each transition, without the last row and column."""
        following = [*self.pieces[1:], self.pieces[0]]
        found = [p.saltation(e, f) for (p, _, e), f in zip(self.steps, following, strict=True)]
        return [s[: self.size, : self.size] for s in found]

    def monodromy(self, *, saltations=True):
        """Product over a period of the flows and saltation matrices, or of flows and resets."""
        product = mpmath.eye(self.size) if self.pieces[0].precise else np.eye(self.size)
        jumps = self.saltations()
        if not saltations:
            jumps = [p.jump[: self.size, : self.size] for p in self.pieces]
        for piece, jump in zip(self.pieces, jumps, strict=True):
            product = jump @ (piece.flow(piece.dwell)[: self.size, : self.size] @ product)
        return product

    def image(self, start):
        """State after one turn from anywhere nearby, and the dwell times."""
        state, times = start, []
        for piece in self.pieces:
            times.append(piece.exit_time(state, piece.dwell))
            state = piece.jump @ (piece.flow(times[-1]) @ state)
        return state, times

    def embedding(self):
        """Directions in which the section extends, one for each of its coordinates.

        The end of the last phase lies on its exit boundary, at the velocities that were held;
        the reset follows.
        """
        last = self.pieces[-1]
        constraints = np.vstack([last.normal, *last.held])[:, : self.size]
        tangent = last.jump[: self.size, : self.size] @ null_space(constraints)
        names = [self.itinerary.start.get(s, f"{s}0") for s in self.states]
        places = [names.index(n) for n in self.orbit.kernels.table["section"]]
        return tangent @ np.linalg.pinv(tangent[places]), places


# parameters near each orbit's reference point, with and without an orbit of this itinerary
_STOP = {"m1": (0.7, 1.4), "m2": (1.4, 2.8), "k1": (0.7, 1.4), "k2": (3.5, 7.0)}
_FRICTION = {"chi": (0.3, 0.7), "eta": (0.6, 1.6), "V": (0.7, 1.3)}
RANGES = {
    "rigid-stop/one-impact": {**_STOP, "T": (3.0, 8.0)},
    "elastic-stop/one-contact": {**_STOP, "k3": (0.5, 3.0), "T": (5.5, 7.5)},
    "dry-friction/symmetric": {
        "chi": (0.3, 0.5), "eta": (2.5, 6.0), "V": (0.5, 0.9), "e2": (0.35, 0.7)
    },
    "dry-friction/global-stick": {**_FRICTION, "e1": (2.3, 3.8), "e2": (0.3, 0.9)},
    "dry-friction/solution-ii": {**_FRICTION, "e2": (0.3, 0.9)},
}  # fmt: skip


def random_points(name, seed, count):
    """Random values of the equations' parameters of an orbit."""
    lower, upper = np.array(list(RANGES[name].values())).T
    points = lower + (upper - lower) * np.random.default_rng(seed).random((count, len(lower)))
    return dict(zip(RANGES[name], points.T, strict=True))


def single(many, place):
    """The orbit at one point of a batch, solved from what the batch has found there."""
    point, guess = (
        {name: float(np.broadcast_to(array, many.status.shape)[place]) for name, array in each}
        for each in (many.parameters.items(), many.unknowns.items())
    )
    return solve(many.name, point, guess)
