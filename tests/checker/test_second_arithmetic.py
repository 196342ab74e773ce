"""What a certificate says, shown again in mpmath's intervals: nothing of it by FLINT's balls."""

from fractions import Fraction

import pytest
from mpmath import iv, mp, workdps

import nonsmooth as ns
from tests.certified import content_of, loop
from tests.tables import slow

DIGITS = 50
ORBITS = {
    "global-stick": lambda: ns.solve("dry-friction/global-stick"),
    "symmetric": lambda: ns.solve("dry-friction/symmetric", {"V": "1.1"}),
    "kicked": loop,
}


@pytest.fixture(
    scope="module",
    params=[slow("global-stick"), "symmetric", "kicked"],
)
def content(request):
    return content_of(ns.certify(ORBITS[request.param]()))


@pytest.fixture(autouse=True)
def digits():
    before, iv.dps = iv.dps, DIGITS
    with workdps(DIGITS):
        yield
    iv.dps = before


def interval(value):
    exact = Fraction(value)
    return iv.mpf(exact.numerator) / exact.denominator


def around(ball):
    middle, radius = Fraction(ball["mid"]), Fraction(ball["rad"])
    return iv.mpf([interval(middle - radius).a, interval(middle + radius).b])


def middle_of(x):
    return mp.mpf(x.mid.a)


def inside(inner, outer):
    return bool(outer.a < inner.a and inner.b < outer.b)


def meet(one, other):
    return bool(one.a <= other.b and other.a <= one.b)


class StatedOrbit:
    """A cycle as a file states it, in intervals: its equations, their Jacobian, its return map."""

    def __init__(self, content):
        declared = content["declaration"]
        given = [Fraction(content["parameters"][name]) for name in declared["parameters"]]

        def number(entry):
            if isinstance(entry, str):
                return interval(entry)
            above, below = (
                sum(_term(coefficient, powers, given) for coefficient, powers in entry[part])
                for part in ("above", "below")
            )
            return interval(Fraction(above) / below)

        def numbers(rows):
            return [[number(entry) for entry in row] for row in rows]

        self.size = len(declared["states"])
        self.phases = []
        for phase in declared["phases"]:
            configuration = declared["configurations"][phase["configuration"]]
            (name,) = phase["boundaries"]
            (exit_row,) = numbers([configuration["boundaries"][name]])
            reset = numbers(declared["transitions"][phase["transition"]]["reset"])
            field, last = numbers(configuration["field"]), [0] * self.size
            whole = ([*rows, [*last, k]] for k, rows in enumerate((field, reset)))
            self.phases.append((*map(iv.matrix, whole), exit_row))

    def passed(self, unknowns):
        """Of each phase: its flow, the state where it ends, and the velocity there."""
        state = iv.matrix([*unknowns[: self.size], 1])
        found = []
        for (field, reset, _), time in zip(self.phases, unknowns[self.size :], strict=True):
            flow = exponential(field * time)
            end = flow * state
            found.append((flow, end, field * end))
            state = reset * end
        return found

    def residual(self, unknowns):
        passed = self.passed(unknowns)
        last = self.phases[-1][1] * passed[-1][1]
        returned = [last[i] - unknowns[i] for i in range(self.size)]
        exits = zip(self.phases, passed, strict=True)
        return returned + [_along(row, end) for (_, _, row), (_, end, _) in exits]

    def jacobian(self, unknowns):
        """The residual's derivatives: by the start through all flows, by each time from its end."""
        count, size = len(unknowns), self.size
        moved = iv.matrix(size + 1, count)
        for i in range(size):
            moved[i, i] = 1
        found = iv.matrix(count)
        phases = zip(self.phases, self.passed(unknowns), strict=True)
        for place, ((_, reset, row), (flow, _, velocity)) in enumerate(phases):
            moved = flow * moved
            for i in range(size):
                moved[i, size + place] += velocity[i]
            for j in range(count):
                found[size + place, j] = _along([*row[:-1], 0], moved[:, j])
            moved = reset * moved
        for i in range(size):
            for j in range(count):
                found[i, j] = moved[i, j] - int(i == j)
        return found

    def trace(self, unknowns):
        """Trace of the return map: each phase ends where its boundary is reached, not at a time."""
        moved = iv.eye(self.size + 1)
        phases = zip(self.phases, self.passed(unknowns), strict=True)
        for (_, reset, row), (flow, _, velocity) in phases:
            normal = iv.matrix([[*row[:-1], 0]])
            speed = (normal * velocity)[0]
            moved = reset * (flow * moved - velocity * (normal * flow * moved) / speed)
        return sum(moved[i, i] for i in range(self.size))


def _term(coefficient, powers, given):
    found = Fraction(coefficient)
    for value, power in zip(given, powers, strict=True):
        found *= value**power
    return found


def _along(row, state):
    return sum(a * state[i] for i, a in enumerate(row))


def exponential(matrix):
    """Taylor's sum of the exponential; the rest is below a geometric series of its next term."""
    size, order = matrix.rows, 200
    total, term = iv.eye(size), iv.eye(size)
    for k in range(1, order):
        term = term * matrix / k
        total = total + term
    norm = max(sum(abs(matrix[i, j]) for j in range(size)).b for i in range(size))
    assert 2 * norm < order
    rest = 2 * iv.mpf(norm) ** order / iv.factorial(order)
    return total + iv.matrix([[iv.mpf([-rest.b, rest.b])] * size] * size)


def has_one_root(orbit, box):
    """Krawczyk's test of a box, as in R. Krawczyk, Computing 4 (1969)."""
    count = len(box)
    middle = [iv.mpf(middle_of(x)) for x in box]
    jacobian = orbit.jacobian(middle)
    near = mp.matrix(count)
    for i in range(count):
        for j in range(count):
            near[i, j] = middle_of(jacobian[i, j])
    inverse = iv.matrix(near**-1)
    step = inverse * iv.matrix(orbit.residual(middle))
    spread = iv.eye(count) - inverse * orbit.jacobian(box)
    away = iv.matrix([x - m for x, m in zip(box, middle, strict=True)])
    moved = spread * away
    return all(inside(middle[i] - step[i] + moved[i], x) for i, x in enumerate(box))


def test_its_box_has_one_orbit(content):
    assert has_one_root(StatedOrbit(content), [around(x) for x in content["box"]])


def test_its_enclosures_hold_what_intervals_give(content):
    orbit, box = StatedOrbit(content), [around(x) for x in content["box"]]
    enclosures = {name: around(ball) for name, ball in content["enclosures"].items()}
    names = [x["name"] for x in content["box"]]
    assert all(meet(enclosures[name], x) for name, x in zip(names, box, strict=True))
    # the narrow enclosures are of the orbit itself: its equations vanish there
    narrow = [enclosures[name] for name in names]
    assert all(meet(x, iv.mpf(0)) and x.delta < 1e-30 for x in orbit.residual(narrow))
    trace = orbit.trace(narrow)
    assert trace.delta < 1e-30
    assert meet(trace, enclosures["trace"])
    assert meet(sum(narrow[orbit.size :]), enclosures["period"])
