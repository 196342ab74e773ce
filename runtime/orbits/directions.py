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
    """Derivatives of an orbit by q numbers.

    Attributes
    ----------
    unknowns : mapping of str to array (q,)
        What was solved for.
    dwell : array (q, p)
        Of each phase.
    moved, mapped : callable
        Give `starts` and `section`, once they are asked for.
    trace : array (q,) or None
        Of the map's trace, where a formula gives it sharper than the map.
    """

    unknowns: Mapping[str, np.ndarray]
    dwell: np.ndarray
    moved: Callable[[], np.ndarray]
    mapped: Callable[[], MapDerivatives]
    trace: np.ndarray | None = None

    @cached_property
    def starts(self) -> np.ndarray:
        """Of the state (q, p, N) at the start of each phase, which moves in time too."""
        return self.moved()

    @cached_property
    def section(self) -> MapDerivatives:
        """Of the map whose eigenvalues the multipliers are."""
        return self.mapped()


def solve_linear(
    matrix: Any,
    right: Any,
    usual: np.ndarray,
    by: Sequence[str],
    name: str,
    lib: Mpmath | None,
) -> np.ndarray:
    """Changes of unknowns that equations, linearised and scaled, ask for.

    Parameters
    ----------
    matrix : array (m, n)
        m is n, or more for equations that follow from others.
    right : array (q, m)
    usual : array (q,)
        Relative change of what the equations are made of, beside which one of them is rounding.
    by : sequence of str
        What changes.
    name : str
        Of the orbit.
    lib : Mpmath or None
        None in double precision.

    Returns
    -------
    array (q, n)

    Raises
    ------
    InputError
        Where the equations are singular, or contradict each other.
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
