"""A set around a periodic point that the map of a section may contract.

Where P^k maps C = {c + A x, |x_i| <= 1} into its interior, and the row sums of |A^-1 DP^k A| are
below 1 all over C, P^k has one fixed point in C and all of C tends to it (S. Banach, 1922): the
orbit through it attracts the motion from every state of C. Sets are looked for in double precision;
the checker proves which of them is contracted.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.float_sets import Floats
from nonsmooth.runtime.proof.chaos.float_sections import FloatSection
from nonsmooth.runtime.proof.chaos.h_sets import HSet, decimal_set, grid_in_cube
from nonsmooth.runtime.proof.refusals import REFUSED
from nonsmooth.runtime.proof.sets.sections import Way

_LARGEST, _SMALLEST = 2, 24  # powers of 1/2: sizes of sets that are tried, of the scale
_POWERS = (1, 2, 4, 8)
_UP = 2**20
_NEAR = 1e-6  # of the scale: fixed points that are farther apart are those of two orbits
_SKEW = 1e6  # condition of a frame, at most
_STEPS = 4  # of Newton's method for the fixed point
_SAMPLES = 441  # of a set


class AttractingCore(NamedTuple):
    """A set that a power of the section's map is proved to contract."""

    h_set: HSet
    iterates: int  # the power of the map
    way: tuple[Way, ...]
    contraction: Fraction  # factor of the contraction, below 1


class Undecided(Exception):
    """No set is proved, for a reason."""


def attracting_core(
    floats: FloatSection,
    iterates: int,
    point: Floats,
    scale: float,
    judge: Callable[[AttractingCore], Any],
) -> AttractingCore:
    """The largest set tried around a periodic point that is proved to be contracted.

    `iterates` is the number of returns in one period of the orbit, `point` (d,) the approximate
    place where it meets the section. Sets much larger than `scale`, a length in the section's
    coordinates, are not tried. `judge` gives a ball above the factor by which a set is contracted,
    or raises `Failure`. `Undecided` with the reason if no set is proved.
    """
    trouble = Undecided("no set around the orbit was tried")
    for power in (iterates * n for n in _POWERS):
        try:
            centre, slope = _about(floats, power, point, scale)
        except Undecided as reason:
            trouble = reason
            continue
        if np.abs(centre - point).max() > _NEAR * scale:
            raise Undecided("another orbit is there, and not this one")
        frame = _frame(slope)
        turned = np.linalg.inv(frame) @ slope @ frame
        if np.abs(turned).sum(axis=1).max() >= 1:
            trouble = Undecided("the map does not contract about the orbit")
            continue
        way = tuple(floats.way(centre, power))
        for size in range(_LARGEST, _SMALLEST):
            h_set = decimal_set("core", centre.tolist(), frame * scale * 2.0**-size)
            if not _promising(floats, power, h_set):
                trouble = Undecided("a set around the orbit is not contracted")
                continue
            core = AttractingCore(h_set, power, way, Fraction(1))
            try:
                found = _above(judge(core))
            except REFUSED as reason:
                trouble = Undecided(str(reason))
                continue
            if found < 1:
                return core._replace(contraction=found)
    raise trouble


def _promising(floats: FloatSection, power: int, h_set: HSet) -> bool:
    """Whether samples of a set are mapped into it by derivatives with row sums below 1."""
    centre, sides = h_set.near
    size = len(centre)
    count = round(_SAMPLES ** (1 / size))
    points = centre + grid_in_cube(size, count, count) @ sides.T
    images, slopes = _images(floats, power, points, np.abs(sides).sum(axis=1))
    inward = np.linalg.inv(sides)
    seen = np.abs((images - centre) @ inward.T)
    sums = np.abs(inward @ slopes @ sides).sum(axis=2)
    return bool((seen < 1).all() and (sums < 1).all())  # not of what is not finite


def _images(
    floats: FloatSection, power: int, points: Floats, sizes: Floats
) -> tuple[Floats, Floats]:
    """Images (n, d) and derivatives (n, d, d) under a power of the map."""
    slopes = np.broadcast_to(np.eye(len(sizes)), (len(points), len(sizes), len(sizes)))
    for _ in range(power):
        mapped, own = floats.jacobians(points, sizes)
        points, slopes = mapped.points, own @ slopes
    return points, slopes


def _about(floats: FloatSection, power: int, point: Floats, scale: float) -> tuple[Floats, Floats]:
    """The fixed point (d,) and the derivative (d, d) there."""
    size = len(point)
    for _ in range(_STEPS):
        images, slopes = _images(floats, power, point[None], np.full(size, scale))
        if not (np.isfinite(images).all() and np.isfinite(slopes).all()):
            raise Undecided("states around the orbit do not go one way")
        point = point + np.linalg.solve(np.eye(size) - slopes[0], images[0] - point)
    return point, np.asarray(slopes[0])


def _frame(slope: Floats) -> Floats:
    """Eigenvectors as columns; of two that are conjugate the real and the imaginary part.

    So a rotation looks like one. Nearly dependent eigenvectors give the identity.
    """
    values, vectors = np.linalg.eig(slope)
    columns = []
    for value, vector in zip(values, vectors.T, strict=True):
        if value.imag >= 0:
            columns.append(vector.real)
        if value.imag > 0:
            columns.append(vector.imag)
    frame = np.array(columns).T
    return frame if np.linalg.cond(frame) < _SKEW else np.eye(len(slope))


def _above(ball: Any) -> Fraction:
    """A fraction that is larger than a ball."""
    top = float(ball.upper())
    return Fraction(int(np.ceil(top * _UP)) + 1, _UP) if np.isfinite(top) else Fraction(2)
