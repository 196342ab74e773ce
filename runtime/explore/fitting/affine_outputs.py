"""Affine functions of the state that are measured, read from expressions such as ``x1 - x2``."""

from __future__ import annotations

import re
from collections.abc import Sequence
from fractions import Fraction

import numpy as np

from nonsmooth.runtime.core.arithmetic import FLOATS
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.expressions import Function

__all__ = ["affine_row"]

# the grammar of expressions has integers: a decimal is a quotient of two
_DECIMAL = re.compile(r"(?<![\w.])(\d+\.\d*|\.\d+|\d+(?=[eE]))([eE][+-]?\d+)?(?![\w.])")
_TOLERANCE = 1e-9
_LONGEST = 40  # characters of a number


def affine_row(text: str, states: Sequence[str]) -> np.ndarray:
    """Read an affine function of the state.

    Parameters
    ----------
    text : str
        Such as ``x1 - x2`` or ``9.81*v1 + 1/2``.
    states : sequence of str
        Names of the N states.

    Returns
    -------
    array (N + 1,)
        Coefficients of the states, then the constant.

    Raises
    ------
    InputError
        If the text is no expression of the states, or not affine in them.

    Examples
    --------
    >>> affine_row("2*(x1 - x2) + 0.5", ["x1", "x2"]).tolist()
    [2.0, -2.0, 0.5]
    """
    size = len(states)
    function = Function(
        takes=(" ".join(states),),
        inputs=((size,),),
        outputs=((),),
        terms=(),
        gives=(_DECIMAL.sub(_fraction, text),),
    )

    def value(state: np.ndarray) -> float:
        with np.errstate(all="ignore"):
            return float(function(list(state), lib=FLOATS))

    try:
        constant = value(np.zeros(size))
        row = np.array([*(value(unit) - constant for unit in np.eye(size)), constant])
        probes = np.random.default_rng(1).uniform(-3, 3, (3, size))
        found = np.array([value(probe) for probe in probes])
    except (InputError, ZeroDivisionError, ValueError, OverflowError) as problem:
        known = ", ".join(states)
        raise InputError(f"output {text!r} is no expression of {known}: {problem}") from None
    expected = probes @ row[:-1] + constant
    if not np.allclose(found, expected, rtol=_TOLERANCE, atol=_TOLERANCE):
        raise InputError(f"output {text!r} is not affine in the states")
    if not row[:-1].any():
        raise InputError(f"output {text!r} depends on no state")
    return row


def _fraction(found: re.Match[str]) -> str:
    if len(found[0]) > _LONGEST:
        raise InputError(f"output {found[0][:40]!r}... is too long a number")
    exact = Fraction(found[0])
    return f"({exact.numerator}/{exact.denominator})"
