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
    """Equations, as many as unknowns, that the tests below can be applied to."""

    def near(self, point: Sequence[Any]) -> Any:
        """Return what `linearised` needs near a point."""

    def mapped(self, change: Callable[[Any], Any]) -> Solvable:
        """Return the same equations with all numbers changed."""

    def linearised(self, unknowns: Sequence[Any], flows: Any) -> Linearised:
        """Return left-hand sides and Jacobian at the unknowns; `flows` is as `near` gives it."""


class Contraction(NamedTuple):
    """The result of Krawczyk's test on a box."""

    box: list[Any]
    image: list[Any]  # contains every root of the box
    unique: bool  # image inside the box: it contains exactly one root, and that is regular
    empty: bool  # image and box are apart: the box contains no root
    flows: Any  # what `near` gives at the box's middle
    radii: Sequence[arb] = ()  # half of each side of the box


def newton(
    equations_at: Callable[[], Solvable], guess: Sequence[arb], bits: int
) -> list[arb] | None:
    """Return a point near a root, by Newton's method with growing precision up to `bits`.

    Nothing is proved. None is returned where the method does not converge. `equations_at` gives
    the equations at the working precision.
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
    """Test a box for a root (Krawczyk, 1969), and shrink the image of one that has one root.

    The image becomes about as small as rounding allows. `centre` and `radii`, half of each side,
    are in the system's units.
    """
    test = Krawczyk(equations, centre)
    found = test(radii)
    return test.sharpened(found) if found.unique else found


class Krawczyk:
    """The map K(X) = x - Y F(x) + (I - Y F'(X)) (X - x) for boxes X around x (Krawczyk, 1969).

    Y is an approximate inverse of F'(x), whose rounding errors do not matter: K contains all
    roots of X whatever Y is, and if K is inside X then Y and all of F'(X) are regular.

    The centre holds balls around the exact numbers that they stand for, or polynomials of
    parameters (Taylor models): then all is shown for each of the parameters' values, with boxes
    around the values of the polynomials.
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
        """The Newton step -Y F(x): about how far the middles are from the root."""
        return [] if self.inverse is None else list((-(self.inverse * self.at.residual)).entries())

    def __call__(self, radii: Sequence[arb]) -> Contraction:
        """Test the box around the centre with these radii."""
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
        """Return the result with a smaller image of the same root.

        The map is applied once more, around the image's middle.
        """
        points = [x.mid() for x in found.image]
        offsets = [x - point for x, point in zip(found.image, points, strict=True)]
        at = self.equations.linearised(points, self.flows)
        moved = self._moved(at, found.image, offsets)
        return found._replace(image=[x + d for x, d in zip(points, moved, strict=True)])

    def _moved(self, at: Linearised, box: list[Any], offsets: list[Any]) -> list[Any]:
        """Return K(X) - x, where X is x plus offsets that contain 0.

        So F'(X) holds the derivatives on all segments from x to points of X.
        """
        from flint import arb_mat

        over = self.equations.linearised(box, self.flows)
        unit = arb_mat([[int(i == j) for j in range(len(box))] for i in range(len(box))])
        column = matrix([[d] for d in offsets])
        inside = (unit - self.inverse * over.jacobian) * column
        entries: list[Any] = (inside - self.inverse * at.residual).entries()
        return entries


def joined(equations: Solvable, found: Sequence[arb], numbers: Sequence[arb]) -> bool:
    """Whether two enclosures of all unknowns are proved to lie in one box with exactly one root.

    Then roots in both of them are the same.
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
    """Return polynomials of the parameters near the orbit, by Newton's method, or None if it fails.

    Nothing is proved of them. The equations are in Taylor models of `space`, `guess` is near the
    orbit in the middle of it, and `orders` are those of the steps before the last one: a step at
    least doubles the order up to which the polynomials are right.
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
    """Return a box around the polynomials that Krawczyk's map takes into itself, or None."""
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
    """Return the size of a unit in the last place of the largest unknown."""
    from flint import arb

    largest = max((abs(x) for x in point), key=float, default=arb(1))
    return largest * arb(2) ** (8 - bits)
