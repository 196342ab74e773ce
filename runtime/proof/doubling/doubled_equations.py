"""The equations of orbits of twice the period near a flip, without the singularity there.

Two copies u1, u2 of a cycle's unknowns close into each other: F(u1) + B (u1 - u2) = 0 and
F(u2) + B (u2 - u1) = 0, where F are the cycle's equations and B picks its start. With
u1 = m + a w and u2 = m - a w their sum and their difference over 2 a are

    (F(m + a w) + F(m - a w)) / 2 = 0,    mean over s in [-1, 1] of F'(m + s a w) w + 2 B w = 0,

which nothing is divided by a. At a = 0 they say that m is an orbit and that w is turned into its
opposite along it: a flip. One entry of w is 1, so that a is half the distance of the copies in
that unknown; for each a the others are m, the rest of w, and the parameter. At a flip that is
not degenerate this is a regular system (M. Golubitsky and D. Schaeffer, Singularities and Groups
in Bifurcation Theory, 1985, of the symmetry that exchanges the copies).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from nonsmooth.runtime.core.jets import jet, part_of
from nonsmooth.runtime.core.taylor_models import (
    AT_BOTH_ENDS,
    BENT_MEAN,
    MEAN,
    TaylorModel,
    averaged,
    lifted,
    matrix,
    middle_of,
    space_of,
)
from nonsmooth.runtime.proof.boxes.orbit_over_box import Region
from nonsmooth.runtime.proof.branch.curve import (
    OrbitCurve,
    linearised_by_parameter,
    linearised_in_jets,
    solution,
)
from nonsmooth.runtime.proof.orbit_equations import Linearised

__all__ = ["DoubledEquations"]


class _Parts(NamedTuple):
    """The unknowns of the doubled equations: middle m, direction w with its entry 1, parameter."""

    middle: list[Any]
    away: list[Any]
    parameter: Any


class DoubledEquations:
    """The equations of the middle of two copies of a cycle, their direction, and the parameter.

    The region is that of the cycle, over one parameter, and the copies are 2 a apart in the unknown
    with the number `scaled`. The amplitude a is a multiple of the one variable, or zero.
    """

    def __init__(self, region: Region, scaled: int, amplitude: Any) -> None:
        self.region, self.scaled, self.amplitude = region, scaled, amplitude

    def mapped(self, change: Callable[[Any], Any]) -> DoubledEquations:
        """Return the same equations with the amplitude changed."""
        return DoubledEquations(self.region, self.scaled, change(self.amplitude))

    def near(self, point: Sequence[Any]) -> None:
        """Return None: nothing can be kept for points nearby, because the fields depend on them."""

    def doubled(self, unknowns: Sequence[Any]) -> list[Any]:
        """Return the unknowns of the doubled cycle's own equations, and the parameter.

        These are start and dwell times of the first copy, and the dwell times of the second one.
        """
        here, a = self._parts(unknowns), self.amplitude
        first = [m + a * w for m, w in zip(here.middle, here.away, strict=True)]
        second = [m - a * w for m, w in zip(here.middle, here.away, strict=True)]
        dwell = len(first) - len(self.region.cycle)
        return [*first, *second[dwell:], here.parameter]

    def linearised(self, unknowns: Sequence[Any], flows: None = None) -> Linearised:
        """Return residual (2 n, 1) and Jacobian (2 n, 2 n), with the passage between the copies.

        The unknowns are the middle (n), the direction without its entry 1 (n - 1), and the
        parameter. The passage is in jets.
        """
        here = self._parts(unknowns)
        point, away, parameter = self._between(here)
        by_parameter = linearised_by_parameter(OrbitCurve(self.region), point, parameter)
        along = linearised_in_jets(
            self.region, [jet(u, w) for u, w in zip(point, away, strict=True)], [parameter]
        )
        slopes = part_of(by_parameter.jacobian, 0)
        column = matrix([[w] for w in here.away])
        lifted_column = matrix([[w] for w in away])
        turned = self.closure(middle_of(here.parameter))
        both = averaged(slopes, AT_BOTH_ENDS)
        bend = averaged(part_of(along.jacobian, 1), MEAN)
        even = averaged(part_of(by_parameter.residual, 0), AT_BOTH_ENDS)
        odd = averaged(slopes * lifted_column, MEAN) + 2 * turned * column
        even_by = averaged(part_of(by_parameter.residual, 1), AT_BOTH_ENDS)
        odd_by = averaged(part_of(by_parameter.jacobian, 1) * lifted_column, MEAN)
        square = self.amplitude * self.amplitude
        size = len(point)
        others = [k for k in range(size) if k != self.scaled]
        outer = both + 2 * turned
        rows = [
            [
                *(both[i, j] for j in range(size)),
                *(square * bend[i, j] for j in others),
                even_by[i, 0],
            ]
            for i in range(size)
        ]
        rows += [
            [*(bend[i, j] for j in range(size)), *(outer[i, j] for j in others), odd_by[i, 0]]
            for i in range(size)
        ]
        values = [[part[i, 0]] for part in (even, odd) for i in range(size)]
        return Linearised(matrix(values), matrix(rows), by_parameter.shooting)

    def rates(self, unknowns: Sequence[Any]) -> list[Any] | None:
        """Return derivatives of the unknowns by the square of a, at enclosed solutions, or None.

        Those of the equations by a are a times even functions: the mean over s of F'' w w, and that
        of (1 - s^2) / 2 F''' w w w, from an integration by parts.
        """
        here = self._parts(unknowns)
        point, away, parameter = self._between(here)
        along = linearised_in_jets(
            self.region, [jet(u, w, None) for u, w in zip(point, away, strict=True)], [parameter]
        )
        column = matrix([[w] for w in away])
        second = averaged(part_of(along.jacobian, 1) * column, MEAN)
        third = averaged(2 * part_of(along.jacobian, 2) * column, BENT_MEAN)
        slopes = self.linearised(unknowns).jacobian
        try:
            inverse = slopes.mid().inv().mid()
        except ZeroDivisionError:
            return None
        right = [[-x / 2] for x in (*second.entries(), *third.entries())]
        return solution(slopes, inverse, matrix(right))

    def _parts(self, unknowns: Sequence[Any]) -> _Parts:
        from flint import arb

        size = len(unknowns) // 2
        away = list(unknowns[size:-1])
        away.insert(self.scaled, arb(1))
        return _Parts(list(unknowns[:size]), away, unknowns[-1])

    def _between(self, here: _Parts) -> tuple[list[Any], list[Any], Any]:
        """Return points between the copies, their direction and the parameter.

        The place between the copies is one more variable.
        """
        a = self.amplitude
        if not isinstance(a, TaylorModel):
            assert a.is_zero()
            return here.middle, here.away, here.parameter
        from flint import arb

        space = space_of(2, a.space.order)
        middle, away = ([lifted(x, space) for x in part] for part in here[:2])
        step = space.variable(1, arb(0), a.parts[1])
        point = [m + step * w for m, w in zip(middle, away, strict=True)]
        return point, away, lifted(here.parameter, space)

    def closure(self, parameter: Any) -> Any:
        """Return the matrix B (n, n) that picks the start, at any parameter with finite numbers."""
        from flint import arb_mat

        equations = self.region.equations(self.region.tables.number_at([parameter]))
        found = arb_mat(equations.count, equations.count)
        for row, place in equations.closure_rows:
            found[row, place] = 1
        return found
