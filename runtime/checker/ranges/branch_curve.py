"""The equations along a branch: unknowns and parameter on one footing, roots and derivatives."""

from collections.abc import Callable, Sequence
from copy import copy
from typing import Any, NamedTuple

from flint import arb, ctx

from nonsmooth.runtime.checker.orbits.orbit import CheckedOrbit, krawczyk, near_inverse, newton
from nonsmooth.runtime.checker.orbits.short import Short, short_phase
from nonsmooth.runtime.checker.stated.declared import StatedSystem
from nonsmooth.runtime.checker.stated.exact import Entries, Failure, Numbers, demand
from nonsmooth.runtime.checker.stated.parameters import independent, number_at, stated_system
from nonsmooth.runtime.core.jets import Jet, jet, part_of
from nonsmooth.runtime.core.taylor_models import matrix, range_of, unit_matrix

KRAWCZYK = "existence is not proved: Krawczyk's test fails"
_CLOSE = 0.6  # of the bits: half of the box around a root


class Family(NamedTuple):
    """The orbits of a declaration over some parameters."""

    declared: StatedSystem
    energies: Any  # those of `StatedSystem.closes`
    constants: Any  # irrational numbers of the declaration
    names: Sequence[str]  # of the parameters

    @staticmethod
    def stated(content: Entries, names: Sequence[str]) -> "Family":
        """Return what a file states of orbits over some parameters.

        `Failure` is raised if the declaration is not exact, or of another stability.
        """
        declared, constants = stated_system(content, content["parameters"], names)
        demand(declared.bound and declared.rational, "the declaration is not exact")
        demand(content["stability"] == declared.stability, "stability of another kind")
        return Family(declared, declared.closes(), constants, names)

    def along(self, axis: int, beside: Numbers) -> "CheckedCurve":
        """Return the orbits along the parameter of a number, at values of the others."""
        return CheckedCurve(*self[:3], self.names[axis], (), axis, beside)


class CheckedCurve:
    """The equations of a branch's orbits, with the parameter as the last coordinate.

    The n equations have n + 1 coordinates: the unknowns and the parameter. Parameters
    beside the varying one have fixed values.
    """

    def __init__(
        self, declared: StatedSystem, energies: Any, constants: Any, parameter: str,
        interval: Numbers, axis: int = 0, beside: Numbers = (),
    ) -> None:  # fmt: skip
        self.declared, self.energies, self.constants = declared, energies, constants
        self.names = [*declared.unknowns, parameter]
        self.last = len(self.names) - 1
        self.interval = tuple(interval)
        self.axis, self.beside = axis, list(beside)
        self.short: Short | None = None
        self._divided: dict[int, CheckedCurve] = {}

    def divided(self, place: int | None) -> "CheckedCurve":
        """Return the same curve with one phase's switching condition divided by its dwell time.

        Phases are counted from 1; None divides nothing.
        """
        if place is None:
            return self
        if place not in self._divided:
            found = copy(self)
            found.short = short_phase(self.declared, place - 1)
            self._divided[place] = found
        return self._divided[place]

    def check_divisors(self) -> None:
        """Prove that the exact arithmetic divided by nothing that is zero all over the interval."""
        independent(self.declared, self.constants, [self.interval])

    def place(self, name: str) -> int:
        """Return the index of a coordinate; an unknown named as the parameter is passed over."""
        demand(name in self.names, "there is no such coordinate")
        return self.last if name == self.names[self.last] else self.names.index(name)

    def _with(self, parameter: Any) -> CheckedOrbit:
        """Return the orbit's equations at a value of the parameter, with no unknowns set."""
        values = [*self.beside[: self.axis], parameter, *self.beside[self.axis :]]
        return CheckedOrbit(self.declared, number_at([*values, *self.constants]), self.short)

    def orbit(self, point: Numbers) -> CheckedOrbit:
        """Return one passage of the cycle at these coordinates, root of the equations or not."""
        orbit = self._with(point[-1])
        orbit.along(point[:-1])
        return orbit

    def closed(self, point: Numbers) -> CheckedOrbit:
        """Return the orbit at a root, whose energy has to give back what the closure leaves out."""
        orbit = self.orbit(point)
        orbit.returns(self.energies)
        return orbit

    def slopes(
        self, point: Numbers, middle: Numbers | None = None, *, moves: bool = True
    ) -> tuple[list[Any], list[list[Any]]]:
        """Return values (n) of the equations, and derivatives (n, n + 1) by all coordinates.

        If `middle` is given, flows over a box are those of its middle times flows over short
        times. The last derivative, by the parameter, is left out unless that `moves`.
        """
        parameter = jet(point[-1], arb(1)) if moves else point[-1]
        orbit = self._with(parameter)
        times = point[orbit.first : -1]
        known = times if middle is None else middle[orbit.first : -1]
        flows = [(b * t).exp() for b, t in zip(orbit.chain.fields, known, strict=True)]
        if middle is not None:
            away = [t - c for t, c in zip(times, known, strict=True)]
            short = zip(orbit.chain.fields, away, flows, strict=True)
            flows = [(b * d).exp() * flow for b, d, flow in short]
        now = orbit.passage(orbit.chain, point[:-1], flows)
        own = part_of(now.slopes, 0)
        rows = [[own[i, j] for j in range(self.last)] for i in range(self.last)]
        if moves:
            along = part_of(now.values, 1).entries()
            rows = [[*row, rate] for row, rate in zip(rows, along, strict=True)]
        return part_of(now.values, 0).entries(), rows

    def square(self, place: int, point: Numbers, middle: Numbers | None = None) -> tuple[Any, Any]:
        """Return values (n, 1) of the equations, and derivatives (n, n) by all coordinates but one.

        `middle` is as for `slopes`.
        """
        moves = place != self.last
        values, slopes = self.slopes(point, middle, moves=moves)
        rows = [without_entry(place, row) if moves else row for row in slopes]
        return matrix([[v] for v in values]), matrix(rows)

    def near(self, place: int, value: Any, guess: Numbers) -> list[Any]:
        """Return the other coordinates of a point near a root, by Newton's method from a guess.

        The coordinate at `place` has an exact value. Nothing is proved; `Failure` is raised where
        none is found.
        """
        return newton(lambda point: self.square(place, with_entry(place, value, point)), guess)

    def located(self, place: int, value: Any, guess: Numbers) -> list[Any]:
        """Return sharp enclosures of all coordinates of the one root near a guess.

        The coordinate at `place` has a value, which may be a ball. `Failure` is raised if no root
        is proved to be there.
        """
        point = self.near(place, value.mid(), guess)
        unit = arb(2) ** -int(_CLOSE * ctx.prec) + 64 * value.rad()
        radii = [(unit * (1 + abs(x))).upper() for x in point]
        told = "the orbit at a point of it is not proved"
        return with_entry(place, value, self.krawczyk(place, value, point, radii, told))

    def krawczyk(
        self, place: int, value: Any, centre: Numbers, radii: Numbers,
        otherwise: str = KRAWCZYK,
    ) -> list[Any]:  # fmt: skip
        """Return Krawczyk's image of a box of the other coordinates; `Failure` if it is not inside.

        If it lies inside the box, there is exactly one root in it for each value of the
        coordinate at `place` (Krawczyk 1969).
        """
        return inside_box(self.image(place, value, centre, radii), otherwise)

    def image(
        self, place: int, value: Any, centre: Numbers, radii: Numbers
    ) -> tuple[list[Any] | None, bool]:
        """Return enclosures of all roots in a box of the other coordinates, and if that holds them.

        They are None where the slopes are singular.
        """
        middle = with_entry(place, value, centre)

        def at(point: Numbers) -> tuple[Any, Any]:
            known = None if point is centre else middle
            return self.square(place, with_entry(place, value, point), known)

        return krawczyk(at, centre, radii)

    def jets(self, place: int, point: Numbers, order: int) -> list[Any]:
        """Return all coordinates as jets: their derivatives by one of them, at enclosed roots."""
        none = [None] * (order - 1)
        found: list[Any] = [jet(x, None, *none) for x in point]
        found[place] = jet(point[place], arb(1), *none)
        _, square = self.square(place, point)
        y = near_inverse(square, "the derivative along the branch is not known")
        for k in range(1, order + 1):
            orbit = self._with(found[-1])
            missed = part_of(matrix([[v] for v in orbit.along(found[:-1])]), k)
            step = solution(square, y, -missed)
            others = without_entry(place, found)
            moved = [
                Jet(x.space, tuple(d if i == k else part for i, part in enumerate(x.parts)))
                for x, d in zip(others, step, strict=True)
            ]
            found = with_entry(place, found[place], moved)
        return found


def inside_box(image: tuple[list[Any] | None, bool], otherwise: str = KRAWCZYK) -> list[Any]:
    """Return Krawczyk's image of a box, as `krawczyk` tells of it, if it is inside the box."""
    found, inside = image
    if found is None or not inside:
        raise Failure(otherwise)
    return found


def prove_on_parts(
    prove: Callable[[Numbers], None],
    point: Numbers,
    deepest: int,
    sharper: Callable[[list[Any]], Sequence[Any]] = list,
) -> None:
    """Call `prove` on models of one variable or, where that fails, on halves again and again.

    They are halved `deepest` times at most; `sharper` gives narrower enclosures on a part.
    """
    try:
        prove(point)
        return
    except Failure:
        if not deepest:
            raise
    space = point[-1].space
    for side in (-1, 1):
        e = space.variable(0, arb(side) / 2, arb(1) / 2)
        prove_on_parts(prove, sharper([x.at([e]) for x in point]), deepest - 1, sharper)


def solution(square: Any, y: Any, right: Any) -> list[Any]:
    """Return enclosures of the solution (n) of a linear system with an approximate inverse.

    `square` (n, n) and `right` (n, 1) hold balls or Taylor models, the approximate
    inverse `y` is exact. Enclosures hold for all values of the variables. `Failure` is
    raised if the matrix may be singular.
    """
    size = square.nrows()
    unit = unit_matrix(size)
    guess = (y * right).mid()
    missed, rest = range_of(y * (right - square * guess)), range_of(unit - y * square)
    scales = [abs(range_of(x)).upper() for x in guess.entries()]
    least = max(scales, key=float) / 64 + arb(2) ** -40
    scales = [(s + least).upper() for s in scales]
    sums = [
        sum((abs(rest[i, j]) * scales[j] for j in range(size)), arb(0)) / scales[i]
        for i in range(size)
    ]
    norm = _largest(sums)
    demand(norm < 1, "the derivative along the branch is not known")
    errors = [abs(missed[i, 0]) / scales[i] for i in range(size)]
    worst = _largest(errors) / (1 - norm)
    pairs = zip(guess.entries(), scales, strict=True)
    return [x + arb(0, (s * worst).upper()) for x, s in pairs]


def _largest(numbers: Numbers) -> Any:
    """Return an upper bound of all numbers; NaN if one of them is NaN."""
    found = numbers[0]
    for number in numbers[1:]:
        found = found.max(number)
    return found.upper()


def middle_and_half(low: Any, high: Any) -> tuple[Any, Any]:
    """Return balls of the middle of an interval with exact ends, and of half its length."""
    return arb((low + high) / 2), arb((high - low) / 2)


def with_entry(place: int, value: Any, others: Numbers) -> list[Any]:
    """Return all coordinates: the others in their order, with one value put in at its place."""
    return [*others[:place], value, *others[place:]]


def without_entry(place: int, point: Numbers) -> list[Any]:
    """Return the coordinates without the one at a place."""
    return [*point[:place], *point[place + 1 :]]
