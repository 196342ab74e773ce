"""Where doubled orbits next to a flip may be, for the checker to judge; nothing is proved here."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import Any

import numpy as np
from flint import arb

from nonsmooth.runtime.checker.ranges.branch_curve import CheckedCurve
from nonsmooth.runtime.checker.ranges.doubling import ORDER, DoubledEquations, JudgedDoubling
from nonsmooth.runtime.core.taylor_models import TaylorModel, matrix, range_of, space_of
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.proof.boxes.box_certificate import BITS
from nonsmooth.runtime.proof.exact_tables import rational_of

__all__ = ["begin_of_branch", "doubled_guess", "flip_with_direction", "start_of", "tubes"]

_FLIP = 192  # bits of the numbers at the flip
_STEPS = 3  # of Newton's method: each doubles the powers of the amplitude that are right
_WIDER = (2, 8, 32)  # times what is missed: radii that are tried
_LEAST = 2.0**-50  # of a radius
_SHARE = 0.75  # of the largest amplitude: where the doubled branch begins


def flip_with_direction(curve: CheckedCurve, point: Sequence[arb]) -> tuple[int, list[arb]]:
    """Return the number of the entry of the direction that is 1, and a flip with its direction.

    `point` is about the cycle's unknowns and the parameter at the flip. The second result is the
    solution of the doubled equations at the amplitude zero. `Failure` if there is none.
    """
    with flint_precision(_FLIP):
        middles = [x.mid() for x in point]
        _, rows = curve.slopes(middles)
        slopes = matrix([row[:-1] for row in rows])
        turned = (slopes + 2 * DoubledEquations(curve, 0).start_rows()).mid()
        away = np.linalg.svd(np.array(turned.tolist(), dtype=float))[2][-1]
        scaled = int(np.argmax(abs(away)))
        others = [arb(float(x / away[scaled])) for k, x in enumerate(away) if k != scaled]
        guess = [*middles[:-1], *others, middles[-1]]
        return scaled, DoubledEquations(curve, scaled).flip_near(guess)


def tubes(
    curve: CheckedCurve, scaled: int, amplitude: Fraction, flip: Sequence[arb]
) -> Iterator[dict[str, Any]]:
    """Yield tubes of doubled orbits up to an amplitude, narrow ones first, as a file states them.

    There is none where Newton's method fails.
    """
    equations, space = DoubledEquations(curve, scaled), space_of(1, ORDER)
    with flint_precision(BITS):
        a = space.variable(0, arb(0), arb(rational_of(amplitude)))
        centre = [space.constant(x.mid()) for x in flip]
        for step in range(_STEPS + 1):
            values, slopes = equations.at(a, centre)
            try:
                missed = (slopes.mid().inv().mid() * values).entries()
            except ZeroDivisionError:
                return
            if not all(range_of(d).is_finite() for d in missed):
                return
            if step < _STEPS:
                rows = [_floats(x - d) for x, d in zip(centre, missed, strict=True)]
                centre = [TaylorModel(space, tuple(map(arb, row))) for row in rows]
        sizes = [float(abs(range_of(d)).upper()) for d in missed]
    for factor in _WIDER:
        yield {
            "scaled": curve.declared.unknowns[scaled],
            "amplitude": str(amplitude),
            "centre": rows,
            "radii": [factor * size + _LEAST for size in sizes],
        }


def _floats(model: TaylorModel) -> list[float]:
    return [0.0 if part is None else float(part.mid()) for part in model.parts]


def begin_of_branch(found: JudgedDoubling) -> Fraction:
    """Return a short decimal: the parameter, inside a tube, at which the doubled branch begins."""
    value, rate = float(found.centre[-1].parts[0]), float(found.rate.mid())
    away = rate * (_SHARE * float(found.amplitude)) ** 2
    digits = max(0, 2 - math.floor(math.log10(abs(away))))
    return Fraction(round(Fraction(value + away) * 10**digits), 10**digits)


def doubled_guess(found: JudgedDoubling, value: Fraction) -> list[float]:
    """Return the unknowns of the doubled orbit, about, at a value of the parameter in a tube."""
    square = (float(value) - float(found.centre[-1].parts[0])) / float(found.rate.mid())
    amplitude = arb(math.sqrt(max(square, 0.0)))
    with flint_precision(BITS):
        point = [x.at([amplitude / found.amplitude]) for x in found.centre]
        first, second = found.equations.halves(amplitude, point)
        dwell = second[found.equations.size - len(found.curve.declared.dwell) :]
        return [float(x) for x in (*first, *dwell)]


def start_of(twice: CheckedCurve, near: Sequence[float], value: Fraction) -> list[float]:
    """Return the state at which a doubled orbit begins, about, from about its unknowns."""
    with flint_precision(BITS):
        orbit = twice.orbit([*map(arb, near), arb(rational_of(value))])
        return [float(x.mid()) for x in orbit.now.starts[0].entries()[:-1]]
