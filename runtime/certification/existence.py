"""Newton's method towards a root, and Krawczyk's test that a box has exactly one."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from nonsmooth.runtime.certification.chain import Equations, Flows, Passage
from nonsmooth.runtime.certification.models import matrix
from nonsmooth.runtime.values import flint_precision

if TYPE_CHECKING:
    from flint import arb

__all__ = ["Contraction", "krawczyk", "newton"]

_DOUBLE = 40  # bits that a root in double precision has at least, as a rule
_MOST_STEPS = 6  # at the last precision


class Contraction(NamedTuple):
    """Krawczyk's test on a box.

    Attributes
    ----------
    box, image : list of arb or Model
        The image contains every root of the box.
    unique : bool
        The image lies inside: the box contains exactly one root, and that is regular.
    empty : bool
        Image and box are apart: the box contains no root.
    flows : Flows
        Near the box's middle.
    """

    box: list[Any]
    image: list[Any]
    unique: bool
    empty: bool
    flows: Flows


def newton(
    equations_at: Callable[[int], Equations], guess: Sequence[arb], bits: int
) -> list[arb] | None:
    """A point near a root, by Newton's method with growing precision; nothing is proved.

    None where the method does not converge.
    """
    point, steps = list(guess), [bits]
    while steps[-1] > 2 * _DOUBLE:
        steps.append(steps[-1] // 2 + 8)
    steps = [*steps[::-1], *(bits,) * _MOST_STEPS]
    before: Any = None
    for count, precision in enumerate(steps):
        with flint_precision(precision + 16):
            equations = equations_at(precision + 16)
            point = [x.mid() for x in point]
            change = _step(equations, equations.passage(point, _flows(equations, point)))
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


def krawczyk(equations: Equations, centre: Sequence[Any], radii: Sequence[arb]) -> Contraction:
    """K(X) = x - Y F(x) + (I - Y F'(X)) (X - x), with the box X around x.

    Y is an approximate inverse of F'(x), its rounding errors are forgotten: K contains all
    roots of X whatever Y is, and if K is inside X then Y and all of F'(X) are regular.

    Parameters
    ----------
    centre : sequence of arb or Model
        Balls around the exact numbers that they stand for, or polynomials of parameters:
        then all is shown for each of their values, with boxes around those of the polynomials.
    radii : sequence of arb
    """
    from flint import arb

    flows = _flows(equations, centre)
    at = equations.passage(centre, flows)
    box = [x + arb(0, r) for x, r in zip(centre, radii, strict=True)]
    try:
        inverse = at.jacobian.mid().inv().mid()
    except ZeroDivisionError:
        return Contraction(box, box, False, False, flows)
    moved = _moved(equations, inverse, at, box, [arb(0, r) for r in radii], flows)
    image = [x + d for x, d in zip(centre, moved, strict=True)]
    unique = all(abs(d) < r for d, r in zip(moved, radii, strict=True))
    empty = any(abs(d) > r for d, r in zip(moved, radii, strict=True))
    if unique:  # once more, from the middle of the image: its radii shrink to rounding
        points = [x.mid() for x in image]
        offsets = [x - point for x, point in zip(image, points, strict=True)]
        again = equations.passage(points, flows)
        moved = _moved(equations, inverse, again, image, offsets, flows)
        image = [x + d for x, d in zip(points, moved, strict=True)]
    return Contraction(box, image, unique, empty, flows)


def _moved(
    equations: Equations,
    inverse: Any,
    at: Passage,
    box: list[Any],
    offsets: list[Any],
    flows: Flows,
) -> list[Any]:
    """K(X) - x; X is x and offsets around 0, so that F'(X) is known between x and all of X."""
    from flint import arb_mat

    over = equations.passage(box, flows)
    unit = arb_mat([[int(i == j) for j in range(len(box))] for i in range(len(box))])
    column = matrix([[d] for d in offsets])
    entries: list[Any] = ((unit - inverse * over.jacobian) * column - inverse * at.values).entries()
    return entries


def _flows(equations: Equations, point: Sequence[Any]) -> Flows:
    return Flows(equations.chain, equations.dwell(point))


def _step(equations: Equations, now: Passage) -> list[arb] | None:
    try:
        # in floating point, which the midpoints are: the next step corrects it
        change = now.jacobian.mid().solve(now.values.mid()).entries()
    except ZeroDivisionError:
        return None
    return list(change) if all(x.is_finite() for x in change) else None


def _unit(bits: int, point: Sequence[arb]) -> arb:
    """What a last digit of the largest unknown is worth."""
    from flint import arb

    largest = max((abs(x) for x in point), key=float, default=arb(1))
    return largest * arb(2) ** (8 - bits)
