"""An orbit by its system's tables to any number of digits: Newton's method, ever more precise."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.arithmetic import Mpmath
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.piecewise import PiecewiseLinear, piecewise_in
from nonsmooth.runtime.orbits.orbit import GUARD
from nonsmooth.runtime.shooting.closure_conditions import linearised_closure, with_forcing
from nonsmooth.runtime.shooting.newton import climb
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape, numbers_in, shoot
from nonsmooth.runtime.shooting.symmetric_orbit import closing
from nonsmooth.runtime.shooting.symmetry import Symmetry, symmetry_of
from nonsmooth.runtime.shooting.table_newton import sizes
from nonsmooth.runtime.shooting.translations import translations_of, up_to_shift
from nonsmooth.runtime.shooting.variational import Shooting

__all__ = ["Precise", "refine_shape"]

_START_DIGITS = 14


class Precise(NamedTuple):
    """Dwell times (p) and states (p, N) as mpmath numbers, the residual, and the steps taken."""

    dwell: np.ndarray
    states: np.ndarray
    residual: Any
    iterations: int


def refine_shape(
    kernels: SystemKernels,
    cycle: ItineraryShape,
    parameters: dict[str, Value],
    dwell: np.ndarray,
    start: np.ndarray,
    period: Value | None,
    digits: int,
    symmetry: Symmetry | None = None,
) -> Precise:
    """Return dwell times and states refined until their error is at most 10^-digits max(1, |x|).

    The last step, at twice the digits, has to correct nothing that counts. `cycle` is the
    whole one; `dwell` (p) and `period`, where it was given, are those of the part that a
    symmetry closes, where there is one; `start` (N) is in double precision, of a
    converged orbit. `InputError` is raised if the symmetry holds in double precision
    only, `NoConvergence` if Newton's method leaves the orbit, as it does where the
    equations are singular.
    """
    lib = Mpmath(_START_DIGITS)
    size, wanted = len(start), digits + GUARD

    def step_at(x: np.ndarray, last: bool) -> tuple[Any, tuple[PiecewiseLinear, Shooting]]:
        state, times = x[:size], x[size:]
        system = piecewise_in(kernels, parameters, lib)
        if symmetry is not None and last:
            symmetry_of(system, symmetry.matrix, lib.mp.mpf(10) ** -wanted)
        system, part = closing(system, cycle.at(system.structure), symmetry)
        numbers = numbers_in(system)
        now = shoot(part, numbers, times, state, lib.mp)
        size_of = sizes(now, times)
        total = None if period is None else lib.number(period)
        matrix, right = linearised_closure(now, times, size_of, total)
        matrix, right = with_forcing(part, numbers, now, size_of, matrix, right, lib)
        # more equations than unknowns are solved in the sense of least squares
        step = np.array(lib.solve(matrix.tolist(), right.tolist()), dtype=object) * size_of
        change = now.rates[:, :-1] @ step + now.rates[:, -1]
        return [*step, *change], (system, now)

    known = np.array([lib.mp.mpf(v) for v in (*start.tolist(), *dwell.tolist())], dtype=object)
    name = cycle.structure.name
    x, (system, now), count = climb(lib, known, step_at, wanted, _START_DIGITS, name)
    last = Mpmath(wanted)  # a context rounds to its own precision when it computes
    left = [*now.residual, *(now.starts[-1] - now.starts[0])]
    residual = last.mp.mpf(max(map(abs, left)))
    rounded = np.vectorize(last.mp.mpf, otypes=[object])
    states = rounded(now.starts[:-1])
    states[0] = up_to_shift(states[0], translations_of(system))
    return Precise(rounded(x[size:]), states, residual, count)
