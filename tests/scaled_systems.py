"""Random oscillators whose units of length, time and mass are parameters, with a start."""

from fractions import Fraction

import numpy as np
import sympy as sp

from nonsmooth.derive import (
    Friction,
    Harmonic,
    Parameter,
    RigidStop,
    Slider,
    SoftStop,
    oscillator,
)

LENGTH, RATE, MASS = sp.symbols("length rate mass_unit", positive=True)
FORCE = MASS * LENGTH * RATE**2
STIFFNESS, DAMPING = MASS * RATE**2, MASS * RATE


class Scaled:
    """An oscillator in any units: `rate` is the inverse of the unit of time."""

    def __init__(self, system, start):
        self.system, self._start = system, start

    def parameters(self, length, rate, mass=1):
        return {"length": length, "rate": rate, "mass_unit": mass}

    def start(self, length, rate):
        sizes = {"1": Fraction(1), "x": Fraction(length), "v": Fraction(length) * Fraction(rate)}
        return {
            name: float(Fraction(value) * sizes[kind])
            for name, (value, kind) in self._start.items()
        }


def _number(rng, low, high, over=8):
    return sp.Rational(int(rng.integers(low, high + 1)), over)


def _stiffness(rng, count):
    springs = [_number(rng, 2, 30) for _ in range(count + 1)]
    matrix = sp.zeros(count)
    for k, spring in enumerate(springs):
        ends = [place for place in (k - 1, k) if 0 <= place < count]
        for one in ends:
            for other in ends:
                matrix[one, other] += spring if one == other else -spring
    return matrix


def _matrices(rng, count):
    """Stiffness and damping: plain, gyroscopic, with a follower force, defective or nearly so."""
    kind = rng.choice(["undamped", "plain", "gyroscopic", "follower", "defective", "near"])
    stiffness = _stiffness(rng, count)
    if kind == "undamped":
        return stiffness, sp.zeros(count)
    if kind in ("defective", "near") and count > 1:
        column = sp.Matrix([_number(rng, -4, 4) for _ in range(count)])
        row = sp.Matrix([[_number(rng, -4, 4) for _ in range(count)]])
        nilpotent = column * row - sp.eye(count) * (row * column)[0] / count
        near = sp.Rational(1, 10**7) if kind == "near" else 0
        return sp.eye(count), (2 + near) * sp.eye(count) + nilpotent / 8
    damping = stiffness * _number(rng, 0, 4, 64) + sp.eye(count) * _number(rng, 0, 4, 32)
    if count > 1:
        turn = sp.zeros(count)
        turn[0, 1], turn[1, 0] = 1, -1
        if kind == "gyroscopic":
            damping += turn * _number(rng, 1, 4)
        if kind == "follower":
            stiffness += turn * _number(rng, 1, 4)
    return stiffness, damping


def _direction(rng, names):
    if len(names) == 1 or rng.random() < 0.5:
        return names[int(rng.integers(len(names)))]
    one, two = rng.permutation(len(names))[:2].tolist()
    return {names[one]: int(rng.integers(1, 3)), names[two]: -1}


def _elements(rng, names):
    kinds = ["soft", "rigid", "friction", "slider", "pressed", "soft-friction"]
    kind = str(rng.choice(kinds))
    found = []
    if kind in ("soft", "pressed", "soft-friction"):
        found.append(
            SoftStop(
                _direction(rng, names), at=_number(rng, 0, 4) * LENGTH,
                stiffness=_number(rng, 8, 80) * STIFFNESS,
                damping=_number(rng, 1, 4, 16) * DAMPING, name="stop",
            )
        )  # fmt: skip
    if kind == "rigid":
        found.append(
            RigidStop(
                _direction(rng, names), at=_number(rng, 0, 4) * LENGTH,
                restitution=_number(rng, 2, 8), name="stop",
            )
        )  # fmt: skip
    if kind in ("friction", "soft-friction"):
        kinetic = _number(rng, 1, 6)
        found.append(
            Friction(
                _direction(rng, names), kinetic=kinetic * FORCE,
                static=(kinetic + _number(rng, 0, 4)) * FORCE,
                velocity=_number(rng, -4, 4) * LENGTH * RATE, name="belt",
            )
        )  # fmt: skip
    if kind == "pressed":
        kinetic = _number(rng, 2, 6)
        found.append(
            Friction(
                _direction(rng, names), kinetic=kinetic, static=kinetic + _number(rng, 0, 6),
                velocity=_number(rng, -2, 2) * LENGTH * RATE, normal="stop", name="pad",
            )
        )  # fmt: skip
    if kind == "slider":
        found.append(
            Slider(
                _direction(rng, names), stiffness=_number(rng, 4, 30) * STIFFNESS,
                limit=_number(rng, 1, 8) * FORCE, name="joint",
            )
        )  # fmt: skip
    return found


def random_scaled(seed):
    """An oscillator of one to three masses with a contact, some of them forced or loaded."""
    rng = np.random.default_rng(seed)
    count = int(rng.integers(1, 4))
    names = [f"x{k + 1}" for k in range(count)]
    stiffness, damping = _matrices(rng, count)
    forced = rng.random() < 0.6
    forcing = [
        Harmonic(
            _number(rng, 4, 24) * RATE,
            cosine=[_number(rng, -12, 12) * FORCE for _ in names],
        )
    ] if forced else []  # fmt: skip
    load = [_number(rng, -8, 8) * FORCE for _ in names] if rng.random() < 0.4 else None
    elements = _elements(rng, names)
    system = oscillator(
        f"scaled-{seed}", names,
        mass=(sp.eye(count) * MASS).tolist(),
        stiffness=(stiffness * STIFFNESS).tolist(),
        damping=(damping * DAMPING).tolist(),
        forcing=forcing, elements=elements,
        parameters=[
            Parameter("length", "unit of length"), Parameter("rate", "inverse of the unit of time"),
            Parameter("mass_unit", "unit of mass"),
        ],
        **({} if load is None else {"load": load}),
    )  # fmt: skip
    start = {}
    for k in range(count):
        start[names[k]] = (float(rng.integers(-8, 1)) / 16, "x")
        start[f"v{k + 1}"] = (float(rng.integers(-8, 9)) / 16, "v")
    if forced:
        start |= {"c1": (1.0, "1"), "s1": (0.0, "1")}
    if any(isinstance(element, Slider) for element in elements):
        start["s_joint"] = (0.0, "x")
    return Scaled(system, start)
