"""An orbit by its system's tables to any number of digits: Newton's method, ever more precise."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.arithmetic import Mpmath
from nonsmooth.runtime.core.errors import NoConvergence
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.piecewise import piecewise_in
from nonsmooth.runtime.orbits.orbit import GUARD
from nonsmooth.runtime.orbits.refine import precisions
from nonsmooth.runtime.shooting.closure_conditions import linearised_closure, with_forcing
from nonsmooth.runtime.shooting.cycle_newton import sizes
from nonsmooth.runtime.shooting.shooting_map import Cycle, numbers_in, shoot
from nonsmooth.runtime.shooting.symmetry import Symmetry, closing, symmetry_of
from nonsmooth.runtime.shooting.translations import translations_of, up_to_shift

__all__ = ["Precise", "refine_cycle"]

_START_DIGITS = 14
_MARGIN = 10  # decimals that the linear algebra of a step may lose


class Precise(NamedTuple):
    """Dwell times (p), states (p, N) of mpmath numbers, the residual, and the steps taken."""

    dwell: np.ndarray
    states: np.ndarray
    residual: Any
    iterations: int


def refine_cycle(
    kernels: SystemKernels,
    cycle: Cycle,
    parameters: dict[str, Value],
    dwell: np.ndarray,
    start: np.ndarray,
    period: Value | None,
    digits: int,
    symmetry: Symmetry | None = None,
) -> Precise:
    """Refine dwell times and states until their error is at most 10^-digits max(1, |x|).

    The last step, at twice the digits, has to correct nothing that counts.

    Parameters
    ----------
    cycle : Cycle
        The whole one.
    dwell : array (p)
        Of the part that the symmetry closes, where there is one.
    start : array (N)
        In double precision, of a converged orbit.
    period : Value, optional
        Sum of these dwell times, where it was given.
    symmetry : Symmetry, optional
        It has to be one to so many digits.

    Raises
    ------
    InputError
        If the symmetry holds in double precision only.
    NoConvergence
        If Newton's method leaves the orbit, as it does where the equations are singular.
    """
    lib = Mpmath(_START_DIGITS)
    times = np.array([lib.mp.mpf(t) for t in dwell.tolist()], dtype=object)
    state = np.array([lib.mp.mpf(y) for y in start.tolist()], dtype=object)
    wanted = digits + GUARD
    steps = [*precisions(wanted, _START_DIGITS), 2 * wanted]
    for count, precision in enumerate(steps, 1):
        with lib.working(precision + _MARGIN):
            system = piecewise_in(kernels, parameters, lib)
            if symmetry is not None and count == len(steps):
                symmetry_of(system, symmetry.matrix, lib.mp.mpf(10) ** -wanted)
            system, part = closing(system, cycle.at(system.structure), symmetry)
            numbers = numbers_in(system)
            now = shoot(part, numbers, times, state, lib.mp)
            size_of = sizes(now, times)
            total = None if period is None else lib.number(period)
            matrix, right = linearised_closure(now, times, size_of, total)
            matrix, right = with_forcing(part, numbers, now, size_of, matrix, right, lib)
            try:
                # more equations than unknowns are solved in the sense of least squares
                found = lib.mp.lu_solve(
                    lib.mp.matrix(matrix.tolist()), lib.mp.matrix(right.tolist())
                )
            except (ZeroDivisionError, ValueError):
                raise _lost(precision) from None
            step = np.array(list(found), dtype=object) * size_of
            change = now.rates[:, :-1] @ step + now.rates[:, -1]
            pairs = zip([*step, *change], [*state, *times], strict=True)
            correction = max(abs(s) / max(abs(x), 1) for s, x in pairs)
            if not correction < 1e-3:
                raise _lost(precision)
            if count == len(steps):
                break
            state, times = state + step, times + change
    if not correction <= lib.mp.mpf(10) ** -(wanted - _MARGIN):
        raise _lost(digits)
    last = Mpmath(wanted)  # a context rounds to its own precision when it computes
    gaps = [*now.residual, *(now.starts[-1] - now.starts[0])]
    residual = last.mp.mpf(max(abs(gap) for gap in gaps))
    rounded = np.vectorize(last.mp.mpf, otypes=[object])
    states = rounded(now.starts[:-1])
    states[0] = up_to_shift(states[0], translations_of(system))
    return Precise(rounded(times), states, residual, len(steps))


def _lost(digits: int) -> NoConvergence:
    return NoConvergence(
        f"Newton's method with {digits} digits leaves the orbit: the equations are singular"
        " here, or the start is too coarse"
    )
