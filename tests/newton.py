"""Newton's law and the laws of contact, of which a motion is asked by its declaration alone.

Between transitions a motion has an acceleration, by differences of its velocities; what the
springs, dampers and loads leave over is the force of the contacts. At transitions nothing jumps
but velocities, as restitution says. There is one motion from a start that obeys all that.
"""

from itertools import pairwise

import numpy as np
import sympy as sp

from nonsmooth.derive import Friction, RigidStop, Slider

_STEP = 5e-4  # of differences of fourth order
_FORCE, _PLACE = 2e-8, 1e-9  # what may be missing of a force, of a place or velocity


class Newton:
    """An oscillator as it is declared: what `oscillator` takes but for the name."""

    def __init__(
        self, coordinates, mass, stiffness,
        damping = None, *, load = (), forcing = (), elements = (),
    ):  # fmt: skip
        self.names, size = coordinates, len(coordinates)
        self.mass, self.stiffness, self.damping = (
            np.zeros((size, size)) if part is None else np.array(part, dtype=float)
            for part in (mass, stiffness, damping)
        )
        self.load, self.forcing = self._row(load), forcing
        self.elements = list(elements)
        self.rows = np.array([self._row(element.coordinate) for element in elements])
        both = zip(self.elements, self.rows, strict=True)  # a stop may be the load of friction
        self._loads_first = sorted(both, key=lambda each: isinstance(each[0], Friction))

    def _row(self, entries):
        """Numbers by coordinates, of a name, of numbers in their order, or of those by name."""
        if isinstance(entries, str):
            entries = {entries: 1}
        if not isinstance(entries, dict):
            entries = dict(zip(self.names, entries, strict=False))
        return np.array([self._number(entries.get(name, 0)) for name in self.names])

    def _number(self, text, state=None):
        if isinstance(text, int | float):
            return float(text)
        found = sp.sympify(text)
        known = {symbol: (state or {})[symbol.name] for symbol in found.free_symbols}
        return float(found.subs(known) if known else found)

    def obeyed_by(self, motion):
        """Check all phases that are long enough to take differences, and all transitions."""
        for begin, end in pairwise([*motion.times.tolist(), motion.end]):
            if end > begin + 0.01:
                for time in np.linspace(begin + 3 * _STEP, end - 3 * _STEP, 5):
                    self._between(motion, time)
        size = len(self.names)
        just = np.nextafter(motion.times[1:], 0)
        np.testing.assert_allclose(motion(just), motion.before[1:], rtol=0, atol=1e-10)
        for k, (before, behind) in enumerate(
            zip(motion.before[1:], motion.states[1:], strict=True)
        ):
            assert abs(np.delete(behind - before, np.s_[size : 2 * size])).max() < _PLACE
            self._struck(before[:size], before[size : 2 * size], behind[size : 2 * size])
            self._begun(motion, k + 1)

    def _between(self, motion, time):
        size = len(self.names)
        near = motion(time + _STEP * np.array([-2, -1, 1, 2]))
        changes = np.array([1, -8, 8, -1]) @ near / (12 * _STEP)
        rates = changes[size : 2 * size]
        missing = self.mass @ rates - self._outer(time, motion(time))
        state, open_ = dict(zip(motion.names, motion(time).tolist(), strict=True)), []
        state |= {f"{n}'": x for n, x in zip(motion.names, changes.tolist(), strict=True)}
        pushes = {}
        for element, row in self._loads_first:
            force = self._told(element, row, state, pushes)
            pushes[element.name] = -(force or 0.0)  # of an upper stop
            open_ += [(element, row)] if force is None else []
            missing -= row * (force or 0.0)
        rows = np.array([row for _, row in open_]).reshape(-1, size)
        forces, _, rank, _ = np.linalg.lstsq(rows.T, missing, rcond=None)
        assert abs(missing - forces @ rows).max() < _FORCE * (1 + abs(rates).max()), (time, missing)
        for (element, _), force in zip(open_, forces, strict=True):
            if rank == len(rows):
                low, high = self._limits(element, state, pushes)
                assert low - _FORCE < force < high + _FORCE, (time, element, force)

    def _outer(self, time, state):
        """Forces of springs, dampers, loads and harmonics."""
        size = len(self.names)
        found = self.load - self.stiffness @ state[:size] - self.damping @ state[size : 2 * size]
        for wave in self.forcing:
            angle = self._number(wave.frequency) * time + self._number(wave.phase)
            found = (
                found
                + self._row(wave.cosine) * np.cos(angle)
                + self._row(wave.sine) * np.sin(angle)
            )
        return found

    def _moved(self, row, state):
        """Place and velocity along a direction."""
        size, values = len(self.names), [*state.values()]
        return float(row @ values[:size]), float(row @ values[size : 2 * size])

    def _told(self, element, row, state, pushes):
        """The force of an element by its law; None where it is what holds it at rest."""
        place, rate = self._moved(row, state)
        if isinstance(element, Slider):
            force = -self._number(element.stiffness) * (place - state[f"s_{element.name}"])
            slack = self._number(element.limit) - abs(force)
            creeps = force * state[f"s_{element.name}'"]
            gives_way = abs(slack) < _FORCE and creeps < _FORCE  # to the spring, at its limit
            assert gives_way or (slack > -_FORCE and abs(creeps) < _FORCE)
            return force
        if isinstance(element, Friction):
            load, relative = (
                self._load(element, state, pushes),
                rate - self._number(element.velocity),
            )
            if load > 0 and abs(relative) < _PLACE:
                return None
            slope = self._number(element.falling) * abs(relative)
            return -np.sign(relative) * max(self._number(element.kinetic) * load - slope, 0.0)
        side = 1 if element.side == "upper" else -1
        depth = side * (place - self._number(element.at))
        if isinstance(element, RigidStop):
            assert depth < _PLACE
            return 0.0 if depth < -_PLACE or abs(rate) > _PLACE else None
        push = self._number(element.stiffness) * depth + self._number(element.damping) * side * rate
        return -side * (max(push, 0.0) if element.released == "force" else push) * (depth > 0)

    def _load(self, element, state, pushes):
        normal = getattr(element.normal, "name", element.normal)
        return pushes[normal] if isinstance(normal, str) and normal in pushes else (
            self._number(normal, state))  # fmt: skip

    def _limits(self, element, state, pushes):
        if isinstance(element, Friction):
            static = element.kinetic if element.static is None else element.static
            limit = self._number(static) * self._load(element, state, pushes)
            return -limit, limit
        return (-np.inf, 0.0) if element.side == "upper" else (0.0, np.inf)

    def _struck(self, place, before, behind):
        """Velocities jump along the stops that are struck, as their restitution says."""
        rows = []
        for element, row in zip(self.elements, self.rows, strict=True):
            side = 1 if getattr(element, "side", "") == "upper" else -1
            if (
                isinstance(element, RigidStop)
                and abs(row @ place - self._number(element.at)) < _PLACE
                and side * (row @ before) > _PLACE
            ):
                rows.append(row)
                rebound = -self._number(element.restitution) * (row @ before)
                assert abs(row @ behind - rebound) < _PLACE
        jump, rows_ = self.mass @ (behind - before), np.array(rows).reshape(-1, len(place))
        along = np.linalg.lstsq(rows_.T, jump, rcond=None)[0]
        assert abs(jump - along @ rows_).max() < 4 * _PLACE * self.mass.max()

    def _begun(self, motion, k):
        """The only contact with friction slips from rest where its static limit is exceeded."""
        rubs = [(e, row) for e, row in zip(self.elements, self.rows, strict=True)
                if isinstance(e, Friction)]  # fmt: skip
        later = motion.times[k] + 1e-3
        if len(rubs) != 1 or len(self.elements) != 1 or later > [*motion.times, motion.end][k + 1]:
            return
        (element, row), state = (
            rubs[0],
            dict(zip(motion.names, motion.states[k].tolist(), strict=True)),
        )
        after = dict(zip(motion.names, motion(later).tolist(), strict=True))
        load = self._load(element, state, {})
        if self._told(element, row, state, {}) is None and load > 1e-6 and (
            self._told(element, row, after, {}) is not None
        ):  # fmt: skip
            inverse = np.linalg.solve(self.mass, row)
            held = -(inverse @ self._outer(motion.times[k], motion.states[k])) / (row @ inverse)
            assert abs(held) > self._limits(element, state, {})[1] - _FORCE
