"""Flows as exponentials of vector fields, in mpmath numbers to all their digits.

They serve orbits that are refined to many digits where no flow has a closed form.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from nonsmooth.runtime.core.arithmetic import exact_ball, middle
from nonsmooth.runtime.core.errors import NoConvergence
from nonsmooth.runtime.core.values import flint_precision

__all__ = ["exponential"]

_GUARD = 32  # bits


def exponential(field: np.ndarray, time: Any, mp: Any) -> np.ndarray:
    """Flow (N, N + 1) of y' = A y + b over a time: its matrix, then its constant.

    It is the exponential of the time times the field (N, N + 1), A and then b, computed in ball
    arithmetic and good to the precision of `mp`; entries are mpmath numbers, integers or complex
    ones, whose errors are relative to the largest entry. Raises `NoConvergence` if no precision is
    enough, as where the motion overflows.
    """
    from flint import acb, acb_mat, arb, arb_mat

    size = len(field)
    entries = [mp.convert(x) for x in field.ravel().tolist()]
    turning = any(isinstance(x, mp.mpc) for x in (*entries, time))
    matrix = acb_mat if turning else arb_mat

    def ball(number: Any) -> Any:
        whole = mp.convert(number)
        return acb(*map(exact_ball, (whole.real, whole.imag))) if turning else exact_ball(whole)

    def number(entry: Any) -> Any:
        if turning:
            return mp.mpc(middle(mp, entry.real), middle(mp, entry.imag))
        return middle(mp, entry)

    def sure(entry: Any, least: Any) -> bool:
        if turning:
            return bool(entry.real.rad() < least and entry.imag.rad() < least)
        return entry.rel_accuracy_bits() >= mp.prec or bool(entry.rad() < least)

    balls, span, bits = list(map(ball, entries)), ball(time), mp.prec + _GUARD
    for _ in range(12):
        with flint_precision(bits):
            scaled = [x * span for x in balls]
            whole = matrix(size + 1, size + 1, [*scaled, *[0] * (size + 1)])
            found = whole.exp().entries()[: size * (size + 1)]
            largest = max((abs(entry).upper() for entry in found), default=arb(1))
            least = largest * arb((1, -mp.prec))
            done = all(sure(entry, least) for entry in found)
        if done:
            return np.array([number(x) for x in found], dtype=object).reshape(size, size + 1)
        bits *= 2
    raise NoConvergence(f"the flow over the time {mp.nstr(time.real, 6)} cannot be computed")
