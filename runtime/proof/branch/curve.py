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
from nonsmooth.runtime.proof.branch.short_phases import divided_regions
from nonsmooth.runtime.proof.enclosure import unknown_names
from nonsmooth.runtime.proof.orbit_equations import Equations, Linearised

if TYPE_CHECKING:
    from flint import arb

__all__ = [
    "AlongUnknown",
    "OrbitCurve",
    "along_parameter",
    "directions",
    "largest_of",
    "linearised_by_parameter",
    "linearised_in_jets",
    "solution",
]


@dataclass(frozen=True, eq=False)
class OrbitCurve:
    """Points (u, p) of the equations F(u, p) = 0 of a cycle over one parameter.

    Attributes
    ----------
    region : Region
    axis : int
        Number of the parameter.
    beside : tuple of arb or TaylorModel
        Values of the region's other parameters.
    """

    region: Region
    axis: int = 0
    beside: tuple[Any, ...] = ()

    @cached_property
    def names(self) -> tuple[str, ...]:
        """The unknowns of the orbit's equations, and last the parameter."""
        region = self.region
        return (*unknown_names(region.subject, region.closing), region.names[self.axis])

    @cached_property
    def divided(self) -> dict[int, OrbitCurve]:
        """The same curve where the condition of a phase that may vanish is divided by its time."""
        return {place: OrbitCurve(found) for place, found in divided_regions(self.region).items()}

    @property
    def parameter(self) -> int:
        """The coordinate that is the parameter: the last one."""
        return len(self.names) - 1

    @cached_property
    def first_time(self) -> int:
        """The coordinate that is the first dwell time."""
        return self.parameter - len(self.region.cycle.configurations)

    def equations(self, coordinate: int, value: Any) -> Equations | AlongUnknown:
        """Equations of the other coordinates where one has a value.

        Parameters
        ----------
        coordinate : int
        value : arb or TaylorModel
        """
        if coordinate == self.parameter:
            return self.region.equations(self.region.tables.number_at(self.parameters(value)))
        return AlongUnknown(self, coordinate, value)

    def parameters(self, value: Any) -> list[Any]:
        """All parameters of the region where its own has a value.

        Parameters
        ----------
        value : arb, TaylorModel or Jet

        Returns
        -------
        list of numbers
        """
        return [*self.beside[: self.axis], value, *self.beside[self.axis :]]

    def mapped(self, change: Callable[[Any], Any]) -> OrbitCurve:
        """The same curve, where the other parameters are other numbers.

        Parameters
        ----------
        change : callable
            From a number to the other numbers.
        """
        return replace(self, beside=tuple(map(change, self.beside)))

    def point(self, coordinate: int, value: Any, others: Sequence[Any]) -> list[Any]:
        """All coordinates of a point.

        Parameters
        ----------
        coordinate : int
        value : arb, TaylorModel or Jet
            Of that coordinate.
        others : sequence of numbers
            The other ones.

        Returns
        -------
        list of numbers
            One for each of `names`.
        """
        return [*others[:coordinate], value, *others[coordinate:]]

    def others(self, coordinate: int, point: Sequence[Any]) -> list[Any]:
        """All coordinates of a point but one.

        Parameters
        ----------
        coordinate : int
        point : sequence of numbers

        Returns
        -------
        list of numbers
        """
        return [*point[:coordinate], *point[coordinate + 1 :]]


class AlongUnknown:
    """Equations of a cycle where one of its unknowns is given and the parameter is unknown.

    Unknowns are the other ones of the orbit's equations, and last the parameter.

    Parameters
    ----------
    curve : OrbitCurve
    coordinate : int
        The unknown that is given.
    value : arb or TaylorModel
    """

    def __init__(self, curve: OrbitCurve, coordinate: int, value: Any) -> None:
        self.curve, self.coordinate, self.value = curve, coordinate, value

    def mapped(self, change: Callable[[Any], Any]) -> AlongUnknown:
        """The same equations in other numbers.

        Parameters
        ----------
        change : callable
            From a number to the other numbers.
        """
        return AlongUnknown(self.curve.mapped(change), self.coordinate, change(self.value))

    def near(self, point: Sequence[Any]) -> None:
        """Nothing is kept for points near others: the fields depend on them.

        Parameters
        ----------
        point : sequence of arb or TaylorModel
        """

    def linearised(self, unknowns: Sequence[Any], flows: None = None) -> Linearised:
        """Pass once through the cycle, with derivatives by the unknowns.

        Parameters
        ----------
        unknowns : sequence of arb or TaylorModel
        flows : None
            As `near` gives it.

        Returns
        -------
        Linearised
            Residual (n, 1), Jacobian (n, n), and the passage in jets by the parameter.
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
    """The orbit's equations in jets: values, and derivatives by the parameter.

    Parameters
    ----------
    curve : OrbitCurve
    own : sequence of arb or TaylorModel
        Unknowns of the orbit's equations.
    parameter : arb or TaylorModel

    Returns
    -------
    Linearised
        In jets of the first order.
    """
    from flint import arb

    return linearised_in_jets(curve.region, own, curve.parameters(jet(parameter, arb(1))))


def linearised_in_jets(region: Region, own: Sequence[Any], parameters: Sequence[Any]) -> Linearised:
    """The orbit's equations where a parameter, and perhaps the unknowns, are jets.

    Parameters
    ----------
    region : Region
    own : sequence of arb, TaylorModel or Jet
        Unknowns of the orbit's equations.
    parameters : sequence of arb, TaylorModel or Jet
        The region's parameters.

    Returns
    -------
    Linearised
        In jets of the parameter's order.
    """
    equations = region.equations(region.tables.number_at(list(parameters)))
    fields = [phase.field for phase in equations.phases]
    return equations.linearised(own, lambda place, time: (fields[place] * time).exp())


def directions(
    curve: OrbitCurve, coordinate: int, point: Sequence[Any], order: int
) -> list[Jet] | None:
    """The coordinates of the curve as jets by one of them, at enclosed points of it.

    Implicit differentiation: the derivatives solve linear systems with the matrix that
    Krawczyk's test shows to be regular.

    Parameters
    ----------
    curve : OrbitCurve
    coordinate : int
        By which they are differentiated.
    point : sequence of arb or TaylorModel
        Enclosures of all coordinates.
    order : int
        1, or 2 for second derivatives, which are halved in a jet.

    Returns
    -------
    list of Jet or None
        One for each coordinate; None where the matrix may be singular.
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


def along_parameter(region: Region, point: Sequence[Any], axis: int) -> list[Any] | None:
    """An orbit's unknowns and parameters as jets by one of the parameters; the others stay.

    Parameters
    ----------
    region : Region
    point : sequence of arb or TaylorModel
        Enclosures of the unknowns of the orbit's equations, and the region's parameters.
    axis : int
        Number of the parameter.

    Returns
    -------
    list of Jet, arb or TaylorModel or None
        One for each of them; None where the equations may be singular.
    """
    from flint import arb

    count = len(point) - len(region.names)
    own, parameters = list(point[:count]), list(point[count:])
    parameters[axis] = jet(parameters[axis], arb(1))
    now = linearised_in_jets(region, own, parameters)
    slopes = part_of(now.jacobian, 0)
    try:
        inverse = slopes.mid().inv().mid()
    except ZeroDivisionError:
        return None
    step = solution(slopes, inverse, -part_of(now.residual, 1))
    if step is None:
        return None
    return [*(jet(x, d) for x, d in zip(own, step, strict=True)), *parameters]


def largest_of(numbers: Sequence[arb]) -> arb:
    """A bound of all numbers, by exact comparisons; no number if one of them is none.

    Parameters
    ----------
    numbers : sequence of arb

    Returns
    -------
    arb
        Exact, not below any of their values.
    """
    return reduce(lambda left, right: left.max(right), numbers).upper()


def solution(slopes: Any, inverse: Any, right: Any) -> list[Any] | None:
    """Enclosures of the solution of a linear system, for all values of the variables.

    Parameters
    ----------
    slopes : matrix (n, n)
        Of balls or Taylor models.
    inverse : matrix (n, n)
        About its inverse, exact.
    right : matrix (n, 1)

    Returns
    -------
    list of arb or TaylorModel, or None
        None where the matrix may be singular.
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
