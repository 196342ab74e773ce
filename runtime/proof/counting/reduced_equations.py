"""The reduced equations of an orbit that is derived, over boxes of its reduced unknowns."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.arithmetic import Balls
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.kernels import OrbitKernels
from nonsmooth.runtime.proof.counting.contraction import (
    Linear,
    Sides,
    balls_of,
    middles_of,
)

if TYPE_CHECKING:
    from flint import arb

__all__ = ["ReducedProblem", "reducible"]


class _NotReal(Exception):
    """A root was taken of negative numbers only."""


class _RealBalls(Balls):
    """Balls around real numbers: roots are taken of what is not negative."""

    @staticmethod
    def sqrt(x: Any) -> Any:
        """Enclosure of the roots of the numbers that have a real one; `_NotReal` if none has."""
        from flint import arb

        if x >= 0:
            return x.sqrt()
        if x < 0:
            raise _NotReal
        return arb(0).union(x.upper().sqrt()) if x.is_finite() else x.sqrt()


def reducible(kernels: OrbitKernels) -> bool:
    """Whether the reduced equations have every orbit of the itinerary as root, and fewer unknowns.

    Those of conservative and of symmetric orbits are of orbits with a symmetry only. Of an
    itinerary that repeats itself, orbits would count once for each of its parts. False too where
    the orbit has no reduced equations.
    """
    table = kernels.table
    phases = [(configuration, boundary) for configuration, boundary, _ in table["phases"]]
    repeated = any(phases == phases[k:] + phases[:k] for k in range(1, len(phases)))
    plain = all(" ends " in text or text.endswith(" returns") for text in table["equations"])
    return (
        plain
        and not repeated
        and not table["conservative"]
        and not table["vanishing"]
        and set(kernels.reduced) <= set(kernels.dwell_times)
        and 0 < len(kernels.reduced) < len(kernels.dwell_times)
    )


class ReducedProblem:
    """Reduced equations at one parameter point, at the working precision.

    `given` has the values in the order of the kernels' parameters, `domain` the range of the
    reduced unknowns.
    """

    def __init__(
        self,
        kernels: OrbitKernels,
        given: Sequence[Value],
        domain: Sequence[tuple[float, float]],
    ) -> None:
        self.kernels, self.domain = kernels, tuple(domain)
        self._lib = _RealBalls()
        self._parameters = [self._lib.number(value) for value in given]
        self._spectrum, _ = kernels.spectrum(self._parameters, self._lib)

    def linear(self, sides: Sides) -> Linear | None:
        """The residual as one column over a box; None if one of its equations has no root there."""
        from flint import arb_mat

        try:
            values, jacobian = self._at(balls_of(sides))
            if any(value > 0 or value < 0 for value in values):
                return None
            centre, _ = self._at(middles_of(sides))
        except _NotReal:
            return None
        slopes = [arb_mat([[row[j]] for row in jacobian]) for j in range(len(sides))]
        return Linear.of(arb_mat([[value] for value in centre]), slopes, sides)

    def unknowns(self, sides: Sides) -> dict[str, arb]:
        """All unknowns of the full equations, by name, over a box of the reduced ones."""
        at = (self._parameters, self._spectrum, balls_of(sides))
        values = self.kernels.evaluate("unknowns", at=at, lib=self._lib)
        return dict(zip(self.kernels.unknowns, values, strict=True))

    def _at(self, point: Sequence[arb]) -> tuple[list[Any], list[list[Any]]]:
        at = (self._parameters, self._spectrum, point)
        values, jacobian = self.kernels.evaluate(
            "reduced_residual", "reduced_jacobian", at=at, lib=self._lib
        )
        return values, jacobian
