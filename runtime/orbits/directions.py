"""How an orbit moves with what was given: the implicit function theorem, in any arithmetic."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from nonsmooth.runtime.core.arithmetic import Mpmath
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.shooting.multiplier_derivatives import MapDerivatives
from nonsmooth.runtime.shooting.newton import LEAST

__all__ = ["CONSISTENT", "Directions", "solve_linear"]

CONSISTENT = 1e-7  # of the terms of an equation: what no orbit can follow


@dataclass(frozen=True, eq=False)
class Directions:
    """Derivatives of an orbit by q numbers."""

    unknowns: Mapping[str, np.ndarray]  # (q,) each, of what was solved for
    dwell: np.ndarray  # (q, p), of each phase
    moved: Callable[[], np.ndarray]  # gives `starts` when asked
    mapped: Callable[[], MapDerivatives]  # gives `section` when asked
    trace: np.ndarray | None = None  # (q,), where a formula gives it sharper than the map

    @cached_property
    def starts(self) -> np.ndarray:
        """Derivatives (q, p, N) of the state at each phase's start, which moves in time too."""
        return self.moved()

    @cached_property
    def section(self) -> MapDerivatives:
        """The map whose eigenvalues are the multipliers, and its derivatives."""
        return self.mapped()


def solve_linear(
    matrix: Any,
    right: Any,
    usual: np.ndarray,
    by: Sequence[str],
    name: str,
    lib: Mpmath | None,
) -> np.ndarray:
    """Return the changes (q, n) of unknowns that linearised, scaled equations ask for.

    The matrix is (m, n), with m > n for equations that follow from others; `right` is (q,
    m). `usual` (q,) is the relative change of what the equations are made of: a change
    that is tiny beside it is rounding. `lib` is None in double precision. `InputError` is
    raised where the equations are singular or contradict each other; its message names
    the orbit and what changes.
    """
    floats, sides = matrix.astype(float), right.astype(float)
    if not (np.isfinite(floats).all() and np.isfinite(sides).all()):
        raise InputError(
            f"{name}: a boundary is reached tangentially (grazing): there no derivative exists"
        )
    values = np.linalg.svd(floats, compute_uv=False)
    if not values[-1] > LEAST * values[0]:
        raise InputError(
            f"{name}: its equations are singular (a fold, a branch point or one of a family of"
            " orbits): there no derivative exists"
        )
    if lib is None:
        found = np.linalg.lstsq(floats, sides.T, rcond=None)[0].T
    else:
        rows = matrix.tolist()
        found = np.array([lib.solve(rows, side.tolist()) for side in right], dtype=object)
    missed = abs(found.astype(float) @ floats.T - sides).max(axis=1, initial=0)
    terms = (abs(found.astype(float)) @ abs(floats.T) + abs(sides)).max(axis=1, initial=0)
    for place, parameter in enumerate(by):
        if missed[place] > CONSISTENT * max(terms[place], usual[place]):
            raise InputError(
                f"{name}: no such orbit is left where {parameter} changes alone (forcings out of"
                " tune with each other or with the period): there is no derivative"
            )
    return np.asarray(found).reshape(len(by), floats.shape[1])
