"""Which transitions keep the volume of states: derived, and by saltation matrices in numbers."""

import random

import numpy as np
import pytest
import sympy as sp

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

X, Y, V, W = STATES = sp.symbols("x y v w", real=True)
ORIGIN = dict.fromkeys(STATES, 0)
TURN = sp.Matrix([[3, 4], [-4, 3]]) / 5
KINDS = "none", "elastic", "turned", "mirrored", "lossy", "sheared", "pressed", "carried"
KINDS += "none of velocities", "pressed of velocities"


def random_itinerary(kind, draw):
    """Return a phase between two masses that ends at a random line, with a reset of one kind."""

    def number():
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


def in_numbers(matrix):
    return np.array(sp.Matrix(matrix).tolist(), dtype=float)


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("kind", KINDS)
def test_a_transition_is_said_to_keep_volume_if_it_does(kind, seed):
    draw = random.Random(f"{kind} {seed}")
    itinerary = random_itinerary(kind, draw)
    before, after = itinerary.system.configurations
    (matrix, offset), (other, behind) = (
        [in_numbers(part) for part in c.dynamics.field(STATES)] for c in (before, after)
    )
    images = [itinerary.system.transitions[0].reset.get(s, s) for s in STATES]
    reset = in_numbers(sp.Matrix(images).jacobian(STATES))
    line = before.boundary("forth").function
    slopes, level = in_numbers([[line.diff(x) for x in STATES]]), float(line.subs(ORIGIN))
    factors = []
    while len(factors) < 3:
        state = in_numbers([draw.uniform(-3, 3) for _ in STATES])
        state -= slopes.T @ (slopes @ state + level) / (slopes @ slopes.T)
        arriving = matrix @ state + offset
        rate = (slopes @ arriving).item()
        if rate > np.linalg.norm(slopes):  # it goes over the line at some speed
            leaving = other @ reset @ state + behind
            factors.append(np.linalg.det(reset + (leaving - reset @ arriving) @ slopes / rate))
    kept = np.abs(np.array(factors) - 1)
    assert (kept < 1e-9).all() if keeps_volume(itinerary) else kept.max() > 1e-3
