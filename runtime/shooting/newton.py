"""Newton's method: over a batch of points in doubles, or towards any number of digits.

What is solved stands elsewhere: the equations of derived kernels in `kernel_newton`, those of an
itinerary by its system's tables in `table_newton`.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from nonsmooth.runtime.core.arithmetic import Mpmath
from nonsmooth.runtime.core.errors import NoConvergence

__all__ = [
    "BEYOND",
    "CONVERGED",
    "GOING",
    "INVALID",
    "LEAST",
    "MARGIN",
    "NEGATIVE",
    "OUTSIDE",
    "SHORTEST",
    "SINGULAR",
    "STALLED",
    "TOLERANCE",
    "UNSURE",
    "climb",
    "damping",
    "iterate",
    "judged",
    "lost",
    "precisions",
]

# the compiled solvers' numbers
CONVERGED, STALLED, INVALID, NEGATIVE = 0, 1, 2, 3
OUTSIDE = 4  # only of exchanged equations
SINGULAR = 5
GOING = -1  # only while iterating
UNSURE = 6  # of what has converged: rounding leaves too few digits
BEYOND = (
    "beyond double precision: the parameters are so far apart that rounding leaves no"
    " sure digits; change their ratios"
)
TOLERANCE = 1e-9  # of the last step, which Newton's method squares
SHORTEST = 1e-6  # in units of the period: a dwell time on its way to zero
LEAST = 1e-10  # relative singular value below which equations are dependent
MARGIN = 10  # decimals that the linear algebra of a step may lose
_MOST_ITERATIONS = 32
_MOST_LOST = 0.75  # of a dwell time in one step


def iterate(count: int, advance: Callable[[np.ndarray], Any]) -> tuple[np.ndarray, np.ndarray]:
    """Take steps at many points until each has converged or is given up.

    Parameters
    ----------
    count : int
    advance : function
        Takes a step at the points of these places (k,) and gives a status (k,) for each: `GOING`,
        or why it ends there.

    Returns
    -------
    taken, status : arrays (count,) of int32
        Steps; `STALLED` where they were not enough.
    """
    taken = np.full(count, _MOST_ITERATIONS, dtype=np.int32)
    status = np.full(count, STALLED, dtype=np.int32)
    running = np.arange(count)
    for number in range(1, _MOST_ITERATIONS + 1):
        if not len(running):
            break
        found = np.asarray(advance(running))
        going = found == GOING
        if np.count_nonzero(going) == len(running):
            continue
        ended = running[~going]
        taken[ended], status[ended] = number, found[~going]
        running = running[going]
    return taken, status


def damping(dwell: np.ndarray, change: np.ndarray, growth: float = math.inf) -> Any:
    """Largest part (...) of a step that changes dwell times (..., p) within bounds, at most 1.

    None loses more than three quarters of itself, or grows by more than `growth` times itself.

    Parameters
    ----------
    dwell : array (..., p)
        Positive. In the system's unit of time.
    change : array (..., p)
        What a whole step would change them by.
    growth : float

    Returns
    -------
    array (...)
    """
    bound = np.where(change < 0, _MOST_LOST, growth) * dwell / np.abs(change)
    return np.minimum(1.0, bound.min(axis=-1, initial=math.inf))


def judged(dwell: np.ndarray, of_dwell: np.ndarray, errors: Any, most: float) -> np.ndarray:
    """Status (...) of orbits that have converged, by bounds on their errors.

    Parameters
    ----------
    dwell : array (..., p)
        Of the phases that take time, in any unit.
    of_dwell : array (..., p)
        Bounds on their errors, in the same unit.
    errors : array (...)
        Of all that was solved for, in units of max(1, |x|).
    most : float
        Errors from which on nothing is sure.

    Returns
    -------
    array (...) of int
        `UNSURE` where an error is too large; `NEGATIVE` where a dwell time is not larger than
        its own error.
    """
    lost = ~(dwell > of_dwell)
    vanishes = lost & (dwell <= SHORTEST * dwell.sum(axis=-1, keepdims=True))
    status = np.where(errors < most, np.where(lost.any(axis=-1), NEGATIVE, CONVERGED), UNSURE)
    return np.where(vanishes.any(axis=-1), NEGATIVE, status)


def precisions(digits: int, start: int) -> list[int]:
    """Decimals of the steps: doubling up to the last, from what doubles give.

    Parameters
    ----------
    digits : int
        Decimals that are wanted.
    start : int
        Decimals that the start has.

    Examples
    --------
    >>> precisions(50, 15)
    [10, 16, 27, 50]
    """
    steps = [digits]
    while steps[-1] > start:
        steps.append(math.ceil(steps[-1] / 2) + 2)
    return steps[::-1]


def climb(
    lib: Mpmath,
    x: np.ndarray,
    step_at: Callable[[np.ndarray, bool], tuple[Any, Any]],
    digits: int,
    start: int,
    name: str,
) -> tuple[np.ndarray, Any, int]:
    """Refine a solution with growing precision; the last step corrects nothing that counts.

    Parameters
    ----------
    lib : Mpmath
    x : array (n,) of mpmath numbers
    step_at : function
        From x, and whether this step is the last, at twice the digits, to the step (n,) and what
        was seen at x; it raises ZeroDivisionError where the equations are singular.
    digits, start : int
        Decimals that are wanted, and that x has.
    name : str
        What is refined, for the message.

    Returns
    -------
    x : array (n,)
    seen : object
        By the last step, at x.
    count : int
        Of steps.

    Raises
    ------
    NoConvergence
        If the method leaves the solution, as it does where the equations are singular.
    """
    steps = [*precisions(digits, start), 2 * digits]
    correction, seen = lib.mp.inf, None
    for precision in steps:
        last = precision == steps[-1]
        with lib.working(precision + MARGIN):
            try:
                step, seen = step_at(x, last)
            except ZeroDivisionError:
                raise lost(name, precision) from None
            correction = max(abs(s) / max(abs(v), 1) for s, v in zip(step, x, strict=True))
            if not correction < 1e-3:
                raise lost(name, precision)
            if not last:
                x = x + np.array(step, dtype=object)
    if not correction <= lib.mp.mpf(10) ** -(digits - MARGIN):
        raise lost(name, digits)
    return x, seen, len(steps)


def lost(name: str, digits: int) -> NoConvergence:
    """What is raised where steps lead away from the solution.

    Parameters
    ----------
    name : str
        What is refined.
    digits : int
        Decimals of the step that failed.

    Returns
    -------
    NoConvergence
        To be raised by the caller.
    """
    return NoConvergence(
        f"{name}: Newton's method with {digits} digits leaves the orbit: the equations are"
        " singular here, or the start is too coarse"
    )
