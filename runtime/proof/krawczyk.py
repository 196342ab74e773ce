"""Newton's method towards a root, and Krawczyk's test that a box has exactly one."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol

from nonsmooth.runtime.core.taylor_models import (
    Space,
    TaylorModel,
    matrix,
    middle_of,
    range_of,
    space_of,
)
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.proof.orbit_equations import Linearised

if TYPE_CHECKING:
    from flint import arb

__all__ = [
    "Contraction",
    "Krawczyk",
    "Solvable",
    "contracted",
    "followed",
    "joined",
    "krawczyk",
    "newton",
]

_DOUBLE = 40  # bits that a root in double precision has at least, as a rule
_MOST_STEPS = 6  # at the last precision
_CLOSE = 50  # bits of the orbit in the middle of a tile
_TRIES = 4  # sizes of Krawczyk's box
_ALIKE = 30  # bits to which numbers of one orbit agree, at least


class Solvable(Protocol):
    """Equations, as many as unknowns: those of a cycle, or others that have their form."""

    def near(self, point: Sequence[Any]) -> Any:
        """What `linearised` takes near a point.

        Parameters
        ----------
        point : sequence of arb or TaylorModel

        Returns
        -------
        object
        """

    def mapped(self, change: Callable[[Any], Any]) -> Solvable:
        """The same equations in other numbers.

        Parameters
        ----------
        change : callable
        """

    def linearised(self, unknowns: Sequence[Any], flows: Any) -> Linearised:
        """Left-hand sides and their Jacobian.

        Parameters
        ----------
        unknowns : sequence of arb or TaylorModel
        flows : object
            As `near` gives it.
        """


class Contraction(NamedTuple):
    """Krawczyk's test on a box.

    Attributes
    ----------
    box, image : list of arb or TaylorModel
        The image contains every root of the box.
    radii : sequence of arb
        Half of each side of the box, around its middle.
    unique : bool
        The image lies inside: the box contains exactly one root, and that is regular.
    empty : bool
        Image and box are apart: the box contains no root.
    flows : object
        As the equations give it near the box's middle.
    """

    box: list[Any]
    image: list[Any]
    unique: bool
    empty: bool
    flows: Any
    radii: Sequence[arb] = ()


def newton(
    equations_at: Callable[[], Solvable], guess: Sequence[arb], bits: int
) -> list[arb] | None:
    """Find a point near a root, by Newton's method with growing precision; nothing is proved.

    Parameters
    ----------
    equations_at : function
        Gives the equations at the working precision.
    guess : sequence of arb
    bits : int
        To which the point is found.

    Returns
    -------
    list of arb or None
        None where the method does not converge.
    """
    point, steps = list(guess), [bits]
    while steps[-1] > 2 * _DOUBLE:
        steps.append(steps[-1] // 2 + 8)
    steps = [*steps[::-1], *(bits,) * _MOST_STEPS]
    before: Any = None
    for count, precision in enumerate(steps):
        with flint_precision(precision + 16):
            equations = equations_at()
            point = [x.mid() for x in point]
            change = _step(equations.linearised(point, equations.near(point)))
            if change is None:
                return None
            point = [(x - d).mid() for x, d in zip(point, change, strict=True)]
            size = max((abs(d).upper() for d in change), key=float)
            if not size < 1e6:
                return None
            last = len(steps) - _MOST_STEPS - 1
            if count >= last and (
                size < _unit(bits, point) or (before is not None and size >= before)
            ):
                return point
            before = size if count >= last else None
    return point


def krawczyk(equations: Solvable, centre: Sequence[arb], radii: Sequence[arb]) -> Contraction:
    """Test a box, and make the image of one that has a root as small as rounding lets it be.

    The test is that of Krawczyk (1969).

    Parameters
    ----------
    equations : Solvable
        As many as unknowns.
    centre : sequence of arb
        Middle of the box, as for `Krawczyk`; in the system's units.
    radii : sequence of arb
        Half of each side of the box, in the system's units.

    Returns
    -------
    Contraction
        The image, and whether the box has one root or none.
    """
    test = Krawczyk(equations, centre)
    found = test(radii)
    return test.sharpened(found) if found.unique else found


class Krawczyk:
    """K(X) = x - Y F(x) + (I - Y F'(X)) (X - x), with boxes X around x (Krawczyk, 1969).

    Y is an approximate inverse of F'(x), its rounding errors are forgotten: K contains all
    roots of X whatever Y is, and if K is inside X then Y and all of F'(X) are regular.

    Parameters
    ----------
    equations : Solvable
    centre : sequence of arb or TaylorModel
        Balls around the exact numbers that they stand for, or polynomials of parameters:
        then all is shown for each of their values, with boxes around those of the polynomials.
    """

    def __init__(self, equations: Solvable, centre: Sequence[Any]) -> None:
        self.equations, self.centre = equations, centre
        self.flows = equations.near(centre)
        self.at = equations.linearised(centre, self.flows)
        self.inverse: Any = None
        with suppress(ZeroDivisionError):
            self.inverse = self.at.jacobian.mid().inv().mid()

    @property
    def missed(self) -> list[Any]:
        """How far the middles are from the root, about: -Y F(x)."""
        return [] if self.inverse is None else list((-(self.inverse * self.at.residual)).entries())

    def __call__(self, radii: Sequence[arb]) -> Contraction:
        """Test the box with these radii."""
        from flint import arb

        centre = self.centre
        box = [x + arb(0, r) for x, r in zip(centre, radii, strict=True)]
        if self.inverse is None:
            return Contraction(box, box, False, False, self.flows, radii)
        moved = self._moved(self.at, box, [arb(0, r) for r in radii])
        image = [x + d for x, d in zip(centre, moved, strict=True)]
        unique = all(abs(d) < r for d, r in zip(moved, radii, strict=True))
        empty = any(abs(d) > r for d, r in zip(moved, radii, strict=True))
        return Contraction(box, image, unique, empty, self.flows, radii)

    def sharpened(self, found: Contraction) -> Contraction:
        """The same with a smaller image: once more, from the middle of it.

        Parameters
        ----------
        found : Contraction
            With one root.

        Returns
        -------
        Contraction
            With an image of the same root.
        """
        points = [x.mid() for x in found.image]
        offsets = [x - point for x, point in zip(found.image, points, strict=True)]
        at = self.equations.linearised(points, self.flows)
        moved = self._moved(at, found.image, offsets)
        return found._replace(image=[x + d for x, d in zip(points, moved, strict=True)])

    def _moved(self, at: Linearised, box: list[Any], offsets: list[Any]) -> list[Any]:
        """K(X) - x; X is x and offsets around 0, so that F'(X) is known between x and all of X."""
        from flint import arb_mat

        over = self.equations.linearised(box, self.flows)
        unit = arb_mat([[int(i == j) for j in range(len(box))] for i in range(len(box))])
        column = matrix([[d] for d in offsets])
        inside = (unit - self.inverse * over.jacobian) * column
        entries: list[Any] = (inside - self.inverse * at.residual).entries()
        return entries


def joined(equations: Solvable, found: Sequence[arb], numbers: Sequence[arb]) -> bool:
    """Whether one box holds both of two points, and one root.

    Parameters
    ----------
    equations : Solvable
        Of the unknowns.
    found, numbers : sequence of arb
        Two enclosures of all unknowns.

    Returns
    -------
    bool
        True if that is proved: if both contain roots they are one.
    """
    from flint import arb

    both = [x.union(y) for x, y in zip(found, numbers, strict=True)]
    centre = [x.mid() for x in both]
    radii = [2 * x.rad() + (1 + abs(x)) * arb(2) ** -_ALIKE for x in both]
    if not all(r.is_finite() for r in radii):
        return False
    return krawczyk(equations, centre, [r.upper() for r in radii]).unique


def followed(
    equations: Solvable, guess: Sequence[arb], space: Space, orders: Sequence[int] = (1,)
) -> list[Any] | None:
    """Polynomials near the orbit, by Newton's method; nothing is proved of them.

    Parameters
    ----------
    equations : Solvable
        Of the unknowns; in Taylor models of the space.
    guess : sequence of arb
        The unknowns about, in the middle.
    space : Space
    orders : sequence of int, optional
        Of the steps before the last: each step doubles the order that is right, and more.

    Returns
    -------
    list of TaylorModel or None
        None where Newton's method fails.
    """
    middle = equations.mapped(middle_of)
    found = newton(lambda: middle, guess, _CLOSE)
    if found is None:
        return None
    for order in (*orders, space.order):
        rough = space_of(space.variables, order)

        def cut(number: Any, rough: Space = rough) -> TaylorModel:
            middle = number.mid()
            return middle.cast(rough) if isinstance(number, TaylorModel) else rough.constant(middle)

        centre = list(map(cut, found))
        missed = Krawczyk(equations.mapped(cut), centre).missed
        if not missed or not all(range_of(d).is_finite() for d in missed):
            return None
        found = [(x + d).mid() for x, d in zip(centre, missed, strict=True)]
    return found


def contracted(test: Krawczyk) -> Contraction | None:
    """A box around the polynomials that Krawczyk's map takes into itself, if there is one.

    Parameters
    ----------
    test : Krawczyk
        About the polynomials.
    """
    from flint import arb

    unit = arb(2) ** -_CLOSE
    moved = [abs(range_of(d)) for d in test.missed]
    for _ in range(_TRIES if moved else 0):
        if not all(d.is_finite() for d in moved):
            return None
        found = test([(2 * d + unit).upper() for d in moved])
        if found.unique:
            return found
        moved = [abs(range_of(x - c)) for x, c in zip(found.image, test.centre, strict=True)]
    return None


def _step(now: Linearised) -> list[arb] | None:
    try:
        # in floating point, which the midpoints are: the next step corrects it
        change = now.jacobian.mid().solve(now.residual.mid()).entries()
    except ZeroDivisionError:
        return None
    return list(change) if all(x.is_finite() for x in change) else None


def _unit(bits: int, point: Sequence[arb]) -> arb:
    """What a last digit of the largest unknown is worth."""
    from flint import arb

    largest = max((abs(x) for x in point), key=float, default=arb(1))
    return largest * arb(2) ** (8 - bits)
