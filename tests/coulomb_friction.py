"""Motions of the paper's masses on the belt by Coulomb's law and exponentials alone."""

import numpy as np
from scipy.linalg import expm
from scipy.optimize import brentq


class Friction:
    """Two masses on the belt (Sec. 3), from one event to the next by matrix exponentials.

    The next phase follows from Coulomb's law alone: at the belt's velocity a mass sticks if
    the force on it is at most ur, and a force beyond ur lets it slip.
    """

    step = 0.02

    def __init__(self, values, us1, us2):
        self.chi, self.eta, self.speed = values["chi"], values["eta"], values["V"]
        self.sliding = np.array([us1, us2])
        self.sticking = np.array([us1 + values["e1"], us2 + values["e2"]])

    def centre(self):
        """The paper's shift d = x - z."""
        us1, us2 = self.sliding
        first = (us1 + us2) / (1 - self.chi)
        return np.array([first, first + us2 / self.chi])

    def generator(self, slips):
        matrix = np.zeros((5, 5))  # the last coordinate is 1
        matrix[:2, 2:4] = np.eye(2)
        if slips[0]:
            matrix[2, [0, 1, 4]] = -1, self.chi, self.sliding[0]
        if slips[1]:
            coupling = self.chi * self.eta
            matrix[3, [0, 1, 4]] = coupling, -coupling, self.eta * self.sliding[1]
        return matrix

    def forces(self, y):
        return np.array([y[0] - self.chi * y[1], self.chi * (y[1] - y[0])])

    def excess(self, y, slips):
        """What is positive where a phase has ended: r of a slipping mass, |f| - ur of another."""
        return np.where(slips, y[2:4] - self.speed, np.abs(self.forces(y)) - self.sticking)

    def advance(self, y, slips, times):
        """State and which masses slip after the next event; its time is appended to times."""
        matrix = self.generator(slips)
        stride, elapsed = expm(matrix * self.step), 0.0
        while not (self.excess(following := stride @ y, slips) > 0).any():
            y, elapsed = following, elapsed + self.step
            assert elapsed < 100
        events = []
        for mass in np.flatnonzero(self.excess(following, slips) > 0):

            def crossing(t, y=y, mass=mass):
                return self.excess(expm(matrix * t) @ y, slips)[mass]

            begin = 0.0 if crossing(0.0) < 0 else 1e-9  # a phase may begin on its boundary
            events.append((brentq(crossing, begin, self.step, xtol=1e-15, rtol=1e-15), mass))
        time, mass = min(events)
        y, slips = expm(matrix * time) @ y, slips.copy()
        if slips[mass]:
            y[2 + mass] = self.speed
            slips[mass] = abs(self.forces(y)[mass]) > self.sticking[mass]
        else:
            assert self.forces(y)[mass] > 0, "pulled forward"
            slips[mass] = True
        times.append(elapsed + time)
        return y, slips
