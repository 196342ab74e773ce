"""The orbits of a branch as a curve: unknowns of the equations and the parameter, on one footing.

Any of its coordinates may tell the points of a piece of the curve from each other. Where that is
the parameter the equations are those of the orbit; near a fold it is one of the orbit's own
unknowns, and the parameter is an unknown among the others.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, reduce
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.jets import Jet, jet, part_of
from nonsmooth.runtime.core.taylor_models import matrix, middle_of, range_of
from nonsmooth.runtime.proof.boxes.orbit_over_box import Region
from nonsmooth.runtime.proof.orbit_equations import Equations, Linearised
from nonsmooth.runtime.proof.orbit_to_prove import unknown_names

if TYPE_CHECKING:
    from flint import arb

__all__ = [
    "AlongUnknown",
    "OrbitCurve",
    "directions",
    "largest_of",
    "linearised_by_parameter",
    "linearised_in_jets",
    "solution",
]


@dataclass(frozen=True, eq=False)
class OrbitCurve:
    """Points (u, p) of the equations F(u, p) = 0 of a cycle over one parameter."""

    region: Region
    axis: int = 0  # number of the parameter
    beside: tuple[Any, ...] = ()  # values of the region's other parameters: arb or TaylorModel

    @cached_property
    def names(self) -> tuple[str, ...]:
        """The unknowns of the orbit's equations, and last the parameter."""
        region = self.region
        return (*unknown_names(region.subject, region.closing), region.names[self.axis])

    @property
    def parameter(self) -> int:
        """The number of the coordinate that is the parameter: the last one."""
        return len(self.names) - 1

    @cached_property
    def first_time(self) -> int:
        """The number of the coordinate that is the first dwell time."""
        return self.parameter - len(self.region.cycle.configurations)

    def equations(self, coordinate: int, value: Any) -> Equations | AlongUnknown:
        """Equations of the other coordinates where one has a value: an arb or a Taylor model."""
        if coordinate == self.parameter:
            return self.region.equations(self.region.tables.number_at(self.parameters(value)))
        return AlongUnknown(self, coordinate, value)

    def parameters(self, value: Any) -> list[Any]:
        """All parameters of the region where the curve's own one has a value."""
        return [*self.beside[: self.axis], value, *self.beside[self.axis :]]

    def mapped(self, change: Callable[[Any], Any]) -> OrbitCurve:
        """The same curve with the other parameters changed by a function of a number."""
        return replace(self, beside=tuple(map(change, self.beside)))

    def point(self, coordinate: int, value: Any, others: Sequence[Any]) -> list[Any]:
        """All coordinates of a point, in the order of `names`, from one of them and the others."""
        return [*others[:coordinate], value, *others[coordinate:]]

    def others(self, coordinate: int, point: Sequence[Any]) -> list[Any]:
        """All coordinates of a point but one."""
        return [*point[:coordinate], *point[coordinate + 1 :]]


class AlongUnknown:
    """Equations of a cycle where one of its unknowns is given and the parameter is unknown.

    Their unknowns are the other ones of the orbit's equations, and last the parameter.
    `coordinate` is the number of the given unknown, `value` an arb or a Taylor model.
    """

    def __init__(self, curve: OrbitCurve, coordinate: int, value: Any) -> None:
        self.curve, self.coordinate, self.value = curve, coordinate, value

    def mapped(self, change: Callable[[Any], Any]) -> AlongUnknown:
        """The same equations with every number changed by a function."""
        return AlongUnknown(self.curve.mapped(change), self.coordinate, change(self.value))

    def near(self, point: Sequence[Any]) -> None:
        """None: nothing is reused at nearby points, since the fields depend on the parameter."""

    def linearised(self, unknowns: Sequence[Any], flows: None = None) -> Linearised:
        """One passage through the cycle, with derivatives by the unknowns.

        It has the residual (n, 1), the Jacobian (n, n), and the passage in jets by the parameter.
        `flows` is what `near` gives.
        """
        *others, parameter = unknowns
        place = self.coordinate
        own = [*others[:place], self.value, *others[place:]]
        now = linearised_by_parameter(self.curve, own, parameter)
        along = part_of(now.residual, 1)
        slopes, size = part_of(now.jacobian, 0), len(own)
        rows = [
            [*(slopes[i, j] for j in range(size) if j != place), along[i, 0]] for i in range(size)
        ]
        return Linearised(part_of(now.residual, 0), matrix(rows), now.shooting)


def linearised_by_parameter(curve: OrbitCurve, own: Sequence[Any], parameter: Any) -> Linearised:
    """The orbit's equations in jets of first order: values, and derivatives by the parameter.

    `own` are the unknowns of the orbit's equations.
    """
    from flint import arb

    return linearised_in_jets(curve.region, own, curve.parameters(jet(parameter, arb(1))))


def linearised_in_jets(region: Region, own: Sequence[Any], parameters: Sequence[Any]) -> Linearised:
    """The orbit's equations in jets, where a parameter, and perhaps the unknowns, are jets.

    `own` are the unknowns of the orbit's equations. The result has the parameter's order.
    """
    equations = region.equations(region.tables.number_at(list(parameters)))
    fields = [phase.field for phase in equations.phases]
    return equations.linearised(own, lambda place, time: (fields[place] * time).exp())


def directions(
    curve: OrbitCurve, coordinate: int, point: Sequence[Any], order: int
) -> list[Jet] | None:
    """The coordinates of the curve as jets by one of them, at enclosed points of it.

    Implicit differentiation: the derivatives solve linear systems with the matrix that
    Krawczyk's test shows to be regular. The k-th derivative, up to the order, is divided by k!.
    None where the matrix may be singular.
    """
    from flint import arb

    zero = (None,) * (order - 1)
    jets: list[Any] = [jet(x, None, *zero) for x in point]
    jets[coordinate] = jet(point[coordinate], arb(1), *zero)
    inverse: Any = None
    slopes: Any = None
    for k in range(1, order + 1):
        now = linearised_in_jets(curve.region, jets[:-1], curve.parameters(jets[-1]))
        if slopes is None:
            by_parameter = linearised_by_parameter(curve, point[:-1], point[-1])
            own, along = part_of(now.jacobian, 0), part_of(by_parameter.residual, 1)
            size = len(point) - 1
            rows = [[*(own[i, j] for j in range(size)), along[i, 0]] for i in range(size)]
            slopes = matrix([curve.others(coordinate, row) for row in rows])
            try:
                inverse = slopes.mid().inv().mid()
            except ZeroDivisionError:
                return None
        step = solution(slopes, inverse, -part_of(now.residual, k))
        if step is None:
            return None
        others = curve.others(coordinate, jets)
        moved = [
            jet(*(d if i == k else part for i, part in enumerate(x.parts)))
            for x, d in zip(others, step, strict=True)
        ]
        jets = curve.point(coordinate, jets[coordinate], moved)
    return jets


def largest_of(numbers: Sequence[arb]) -> arb:
    """An exact upper bound of all numbers, by exact comparisons; it is nan if one of them is."""
    return reduce(lambda left, right: left.max(right), numbers).upper()


def solution(slopes: Any, inverse: Any, right: Any) -> list[Any] | None:
    """Enclosures of the solution of a linear system, for all values of the variables.

    `slopes` (n, n) and `right` (n, 1) are of balls or Taylor models, `inverse` (n, n) is an exact
    approximation of the inverse. None where the matrix may be singular.
    """
    from flint import arb, arb_mat

    size = slopes.nrows()
    guess = (inverse * right).mid()
    missed = inverse * (right - slopes * guess)
    unit = arb_mat([[int(i == j) for j in range(size)] for i in range(size)])
    rest = range_of(unit - inverse * slopes)
    # in a norm in which the guess has entries of about one size
    about = [abs(middle_of(x)) for x in guess.entries()]
    least = max(about, key=float) / 64 + arb(2) ** -40
    sizes = [(x + least).mid() for x in about]
    shares = [
        sum((abs(rest[i, j]) * sizes[j] for j in range(size)), arb(0)) / sizes[i]
        for i in range(size)
    ]
    largest = largest_of(shares)
    if not largest < 1:
        return None
    errors = [abs(range_of(x)).upper() for x in missed.entries()]
    worst = largest_of([e / s for e, s in zip(errors, sizes, strict=True)]) / (1 - largest)
    return [
        x + arb(0, (e + share * s * worst).upper())
        for x, e, share, s in zip(guess.entries(), errors, shares, sizes, strict=True)
    ]
