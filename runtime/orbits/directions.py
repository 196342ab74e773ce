"""How an orbit moves with what was given: the implicit function theorem, in any arithmetic."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from nonsmooth.runtime.core.arithmetic import Mpmath
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.matrices import inverses
from nonsmooth.runtime.shooting.multiplier_derivatives import MapDerivatives
from nonsmooth.runtime.shooting.newton import LEAST

__all__ = ["SINGULAR", "SOUND", "Directions", "check_reasons", "solve_linear"]

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


# why there are no changes, by number; a sentence that `check_reasons` completes
SOUND, TANGENTIAL, SINGULAR, LOST = range(4)
_SENTENCES = {
    TANGENTIAL: "a boundary is reached tangentially (grazing): there no derivative exists",
    SINGULAR: "its equations are singular (a fold, a branch point or one of a family of orbits):"
    " there no derivative exists",
    LOST: "no such orbit is left where {} changes alone (forcings out of tune with each other or"
    " with the period): there is no derivative",
}


def check_reasons(reasons: np.ndarray, by: Sequence[str], name: str) -> None:
    """Raise an `InputError` for the first of the reasons (q,) that is not `SOUND`.

    Its message names the orbit and what changes.
    """
    for reason, parameter in zip(reasons.tolist(), by, strict=True):
        if reason != SOUND:
            raise InputError(f"{name}: {_SENTENCES[reason].format(parameter)}")


def solve_linear(
    matrix: np.ndarray, right: np.ndarray, usual: np.ndarray, lib: Mpmath | None = None
) -> tuple[np.ndarray, np.ndarray]:
    """Return the changes (k, n, q) that linearised, scaled equations ask for, and the reasons.

    The matrices are (k, m, n), with m > n for equations that follow from others; `right`
    is (k, m, q). `usual` (k, q) is the relative change of what the equations are made of:
    a change that is tiny beside it is rounding. Changes are NaN where the reason (k, q) is
    not `SOUND`. `lib` is None in double precision.
    """
    floats, sides = matrix.astype(float, copy=False), right.astype(float, copy=False)
    with np.errstate(all="ignore"):
        square, turned = floats, sides
        if matrix.shape[1] != matrix.shape[2]:
            orthogonal, square = np.linalg.qr(floats)
            turned = np.swapaxes(orthogonal, 1, 2) @ sides
        inverse = inverses(square)
        size = np.linalg.norm(square, axis=(1, 2))
        regular = size * np.linalg.norm(inverse, axis=(1, 2)) * LEAST < 1
        changes = inverse @ turned
        missed = abs(floats @ changes - sides).max(axis=1)
        terms = (abs(floats) @ abs(changes) + abs(sides)).max(axis=1)
    reasons = np.where(missed > CONSISTENT * np.maximum(terms, usual), LOST, SOUND)
    reasons[~regular] = SINGULAR
    finite = np.isfinite(size) & np.isfinite(sides).all(axis=(1, 2))
    reasons[~finite] = TANGENTIAL
    if lib is not None:
        changes = np.full(changes.shape, np.nan, dtype=object)
        for place in np.flatnonzero(regular & finite):
            rows = matrix[place].tolist()
            solved = [lib.solve(rows, side) for side in right[place].T.tolist()]
            changes[place] = np.array(solved, dtype=object).reshape(len(solved), -1).T
    np.swapaxes(changes, 1, 2)[reasons != SOUND] = np.nan
    return changes, reasons
