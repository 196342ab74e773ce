"""Which transitions keep the volume of states: derived, and by differences of the flow across."""

import random

import numpy as np
import pytest
import sympy as sp
from scipy.linalg import expm
from scipy.optimize import brentq

from nonsmooth.derive import (
    Boundary,
    Configuration,
    Itinerary,
    Phase,
    SecondOrder,
    System,
    Transition,
)
from nonsmooth.derive.equations.energy import keeps_volume
from tests.differences import in_doubles

X, Y, V, W = STATES = sp.symbols("x y v w", real=True)
TURN = sp.Matrix([[3, 4], [-4, 3]]) / 5
KINDS = "none", "elastic", "turned", "mirrored", "lossy", "sheared", "pressed", "carried"
KINDS += "none of velocities", "pressed of velocities"


def random_itinerary(kind: str, draw: random.Random) -> Itinerary:
    """Return a phase between two masses that ends at a random line, with a reset of one kind."""

    def number() -> sp.Rational:
        return sp.Rational(draw.choice([n for n in range(-6, 7) if n]), 4)

    kind, _, crossed = kind.partition(" of ")
    stop = sp.Rational(draw.randint(0, 3)) if kind == "none" and not crossed else sp.Integer(0)
    a, b, level = number(), number(), number()
    function = a * X + b * Y - level if not crossed else a * V + b * W - level
    load = [number(), number()]
    k, h = 5 + number(), number()
    spring = stop * sp.Matrix([[a * a, a * b], [a * b, b * b]])
    off = spring * sp.Matrix([0, level / b])  # the spring's force begins at the line
    free = SecondOrder(sp.eye(2), [[k, h], [h, k]], load)
    pressed = number() if kind == "pressed" else 0
    behind = sp.Matrix(load) + off + sp.Matrix([pressed, 0])
    stiffness = sp.Matrix([[k, h], [h, k]]) + spring
    if kind == "carried":  # into axes that are turned
        stiffness, behind = TURN * stiffness * TURN.T, TURN * behind
    other = SecondOrder(sp.eye(2), stiffness, behind)
    velocity, normal = sp.Matrix([V, W]), sp.Matrix([a, b])
    matrix = {
        "elastic": sp.eye(2) - 2 * normal * normal.T / (a * a + b * b),
        "lossy": sp.eye(2) - sp.Rational(3, 2) * normal * normal.T / (a * a + b * b),
        "turned": TURN,
        "carried": TURN,
        "mirrored": sp.Matrix([[-3, 4], [4, 3]]) / 5,
        "sheared": sp.Matrix([[1, 0], [sp.Rational(1, 2), 1]]),
    }.get(kind, sp.eye(2))
    reset = dict(zip((V, W), matrix * velocity, strict=True))
    if kind == "carried":
        reset |= dict(zip((X, Y), matrix * sp.Matrix([X, Y]), strict=True))
    before = Configuration("before", free, (Boundary("forth", function),))
    after = Configuration("after", other, (Boundary("back", -function),))
    forth = Transition("before", {"forth"}, "after", (), reset)
    back = Transition("after", {"back"}, "before")
    system = System("volumes", "", STATES, (), (before, after), (forth, back))
    return Itinerary(
        "there", system, (Phase("before", "forth", "ta"), Phase("after", "back", "tb"))
    )


def volume_across(itinerary: Itinerary, state: np.ndarray) -> float:
    """Return by what a volume is multiplied from just before to just after the first transition."""
    forth = itinerary.system.transitions[0]
    line = itinerary.system.configuration("before").boundary("forth").function
    fields = []
    for configuration in itinerary.system.configurations:
        matrix, offset = configuration.dynamics.field(STATES)
        fields.append(np.array(sp.Matrix([[matrix, offset], [sp.zeros(1, 5)]]), dtype=float))
    images = [forth.reset.get(s, s) for s in STATES]
    reset = np.array(sp.Matrix(images).jacobian(STATES), dtype=float)
    level, row = sp.lambdify([STATES], line), 0.05

    def moved(field: np.ndarray, time: float, start: np.ndarray) -> np.ndarray:
        return np.asarray(expm(time * field) @ np.append(start, 1))[:-1]

    def across(start: np.ndarray) -> np.ndarray:
        time = brentq(lambda t: level(moved(fields[0], t, start)), 0, 2 * row, xtol=1e-15)
        return moved(fields[1], 2 * row - time, reset @ moved(fields[0], time, start))

    return float(np.linalg.det(in_doubles(across, moved(fields[0], -row, state), 1e-5)))


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("kind", KINDS)
def test_a_transition_is_said_to_keep_volume_if_it_does(kind: str, seed: int) -> None:
    draw = random.Random(f"{kind} {seed}")
    itinerary = random_itinerary(kind, draw)
    before = itinerary.system.configuration("before")
    line = before.boundary("forth").function
    matrix, offset = (np.array(part, dtype=float) for part in before.dynamics.field(STATES))
    slopes = np.array([float(line.diff(x)) for x in STATES])
    level = float(line.subs(dict.fromkeys(STATES, 0)))
    factors: list[float] = []
    while len(factors) < 3:
        state = np.array([draw.uniform(-3, 3) for _ in STATES])
        state -= slopes * (slopes @ state + level) / (slopes @ slopes)
        if slopes @ (matrix @ state + offset[:, 0]) > np.linalg.norm(
            slopes
        ):  # it goes over the line at some speed
            factors.append(volume_across(itinerary, state))
    kept = np.abs(np.array(factors) - 1)
    assert (kept < 1e-6).all() if keeps_volume(itinerary) else kept.max() > 1e-3
