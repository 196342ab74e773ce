"""Flows as exponentials of vector fields, in mpmath numbers to all their digits."""

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
    ones. Raises `NoConvergence` if no precision is enough, as where the motion overflows.
    """
    from flint import arb, arb_mat

    size = len(field)
    entries = [mp.convert(x) for x in field.ravel().tolist()]
    if any(isinstance(x, mp.mpc) for x in (*entries, time)):
        return _complex_exponential(size, entries, mp.mpc(time), mp)
    bits = mp.prec + _GUARD
    for _ in range(12):
        with flint_precision(bits):
            scaled = [exact_ball(x) * exact_ball(time) for x in entries]
            whole = arb_mat(size + 1, size + 1, [*scaled, *[arb(0)] * (size + 1)])
            found = whole.exp().entries()[: size * (size + 1)]
            sure = all(
                ball.rel_accuracy_bits() >= mp.prec or ball.rad() < _least(arb, found, mp.prec)
                for ball in found
            )
        if sure:
            numbers = np.array([middle(mp, ball) for ball in found], dtype=object)
            return numbers.reshape(size, size + 1)
        bits *= 2
    raise NoConvergence(f"the flow over the time {mp.nstr(time, 6)} cannot be computed")


def _complex_exponential(size: int, entries: list[Any], time: Any, mp: Any) -> np.ndarray:
    """Flow of a complex field, with errors relative to the largest entry."""
    from flint import acb, acb_mat, arb

    def ball(number: Any) -> Any:
        whole = mp.mpc(number)
        return acb(exact_ball(whole.real), exact_ball(whole.imag))

    bits = mp.prec + _GUARD
    for _ in range(12):
        with flint_precision(bits):
            scaled = [ball(x) * ball(time) for x in entries]
            whole = acb_mat(size + 1, size + 1, [*scaled, *[acb(0)] * (size + 1)])
            found = whole.exp().entries()[: size * (size + 1)]
            least = _least(arb, [abs(entry) for entry in found], mp.prec)
            sure = all(e.real.rad() < least and e.imag.rad() < least for e in found)
        if sure:
            numbers = [mp.mpc(middle(mp, e.real), middle(mp, e.imag)) for e in found]
            return np.array(numbers, dtype=object).reshape(size, size + 1)
        bits *= 2
    raise NoConvergence(f"the flow over the time {mp.nstr(time.real, 6)} cannot be computed")


def _least(arb: Any, found: list[Any], bits: int) -> Any:
    """The error that is negligible beside the largest entry, at a precision in bits."""
    largest = max((abs(ball).upper() for ball in found), default=arb(1))
    return largest * arb((1, -bits))
