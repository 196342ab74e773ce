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

# the compiled solvers' numbers
CONVERGED, STALLED, INVALID, NEGATIVE = 0, 1, 2, 3
OUTSIDE = 4  # only of exchanged equations
SINGULAR = 5
GOING = -1  # only while iterating
UNSURE = 6  # of what has converged: rounding leaves too few digits
DOUBLE = 15  # decimal digits up to which doubles serve
DETERMINED = 0.1  # error of an unknown x, in units of max(1, |x|), beyond which nothing is known
TOLERANCE = 1e-9  # of the last step, which Newton's method squares
SHORTEST = 1e-6  # in units of the period: a dwell time on its way to zero
LEAST = 1e-10  # relative singular value below which equations are dependent
MARGIN = 10  # decimals that the linear algebra of a step may lose
STATUS = {
    CONVERGED: "converged",
    STALLED: "not converged: give a guess nearer to the orbit, or none and let it be searched",
    INVALID: "not finite: a parameter is outside its domain or the guess is far from any orbit",
    NEGATIVE: "a dwell time is not positive, or is zero within its error: no motion has this"
    " itinerary here; change the parameters or search without a guess",
    OUTSIDE: "a parameter that was solved for is outside its domain: no such system exists;"
    " change what is given",
    SINGULAR: "singular: at these parameters (a resonance) the equations do not determine an"
    " orbit; there is none, or a whole family: change a parameter",
    UNSURE: "beyond double precision: the parameters are so far apart that rounding leaves no"
    " sure digits; change their ratios",
}
_COMPOSED = {
    STALLED: "not converged: give a guess nearer to the orbit",
    NEGATIVE: "a dwell time goes to zero, or is zero within its error: near the guess no motion"
    " has this itinerary; leave that phase out, or change the parameters",
    SINGULAR: "singular: one of a family of orbits, as there is where a first integral is kept;"
    " give its period",
}
_TIMED = {
    **_COMPOSED,
    STALLED: "not converged: near the guess there may be no orbit of this period; give none, or"
    " a guess nearer to the orbit",
    SINGULAR: "singular: the period does not single an orbit out here; change a parameter",
}
_MOST_ITERATIONS = 32
_MOST_LOST = 0.75  # of a dwell time in one step


def message_of(status: int, *, derived: bool, timed: bool) -> str:
    """What a status means, and a suggestion.

    Other words are for orbits whose equations are `derived`, and where the period was given
    (`timed`).
    """
    return STATUS[status] if derived else (STATUS | (_TIMED if timed else _COMPOSED))[status]


def iterate(count: int, advance: Callable[[np.ndarray], Any]) -> tuple[np.ndarray, np.ndarray]:
    """Take steps at many points until each has converged or is given up.

    `advance` takes a step at the points with the given places (k,) and returns a status (k,) for
    each: `GOING`, or why the iteration ends there. The results are the numbers of steps and the
    final status, both (count,) of int32; it is `STALLED` where the steps were not enough.
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
    """Largest fraction (...), at most 1, of a step that changes dwell times within bounds.

    `dwell` (..., p) are positive, and `change` (..., p) is that of a whole step. No dwell time
    loses more than three quarters of itself or grows by more than `growth` times itself.
    """
    bound = np.where(change < 0, _MOST_LOST, growth) * dwell / np.abs(change)
    return np.minimum(1.0, bound.min(axis=-1, initial=math.inf))


def judged(dwell: np.ndarray, of_dwell: np.ndarray, errors: Any, most: float) -> np.ndarray:
    """Status (...) of orbits that have converged, from bounds on their errors.

    `of_dwell` bounds the errors of `dwell` (..., p), the dwell times of phases that take time;
    `errors` (...) are those of everything, in units of max(1, |x|). The status is `UNSURE` where
    these reach `most`, and `NEGATIVE` where a dwell time is not larger than its own error.
    """
    lost = ~(dwell > of_dwell)
    vanishes = lost & (dwell <= SHORTEST * dwell.sum(axis=-1, keepdims=True))
    status = np.where(errors < most, np.where(lost.any(axis=-1), NEGATIVE, CONVERGED), UNSURE)
    return np.where(vanishes.any(axis=-1), NEGATIVE, status)


def sure_digits(error: float) -> int:
    """Decimal digits, `DOUBLE` at most, of numbers with an error in units of max(1, |x|)."""
    if not math.isfinite(error):
        return 0
    return max(0, min(DOUBLE, math.floor(-math.log10(max(error, 1e-300)))))


def precisions(digits: int, start: int) -> list[int]:
    """Decimals of the steps: doubling up to `digits`, from the decimals `start` that a guess has.

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
    """Refine a solution x (n,) by Newton steps of growing precision, and check it by a last one.

    The last step is taken at twice the digits and not added to x; it has to be negligible.
    `step_at` takes x and whether this step is the last; it gives the step (n,) and an object seen
    at x, and raises `ZeroDivisionError` where the equations are singular. `start` and `digits` are
    the decimals that x has and that are wanted. The results are x, the object that the last step
    saw, and the number of steps. Raises `NoConvergence`, naming `name`, if the steps lead away
    from the solution, as they do where the equations are singular.
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
    """The error to raise where steps of so many digits lead away from the solution `name`."""
    return NoConvergence(
        f"{name}: Newton's method with {digits} digits leaves the orbit: the equations are"
        " singular here, or the start is too coarse"
    )
