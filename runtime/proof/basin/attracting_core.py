"""A set around a periodic point that the map of a section contracts.

Where P^k maps C = {c + A x, |x_i| <= 1} into its interior, and the row sums of |A^-1 DP^k A| are
below 1 all over C, P^k has one fixed point in C and all of C tends to it (S. Banach, 1922): the
orbit through it attracts the motion from every state of C.
"""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from nonsmooth.runtime.core.float_sets import Floats
from nonsmooth.runtime.events.leading_derivative import Undecided
from nonsmooth.runtime.proof.chaos.h_sets import Box, HSet, decimal_set, piece
from nonsmooth.runtime.proof.chaos.parts import coordinates, slices
from nonsmooth.runtime.proof.motion.enclosures import EnclosedSystem
from nonsmooth.runtime.proof.sets.affine_sets import AffineSet
from nonsmooth.runtime.proof.sets.images import PassedTransition, SectionMap
from nonsmooth.runtime.proof.sets.sections import MapSection

if TYPE_CHECKING:
    from flint import arb

__all__ = ["AttractingCore", "attracting_core"]

_TINY = 1e-7  # of the scale: a set over which a derivative is taken at one point
_LARGEST, _SMALLEST = 2, 24  # powers of 1/2: sizes of sets that are tried, of the scale
_POWERS = (1, 2, 4, 8)
_FINEST, _MOST = 2.0**-7, 2000  # of a set: narrower parts are not divided; parts
_UP = 2**20
_NEAR = 1e-6  # of the scale: fixed points that are farther apart are those of two orbits
_SKEW = 1e6  # condition of a frame, at most


class AttractingCore(NamedTuple):
    """A set that a power of the section's map is proved to contract."""

    h_set: HSet
    iterates: int  # the power of the map
    contraction: Fraction  # factor of the contraction, below 1
    passages: tuple[PassedTransition, ...]  # the transitions on the way, the same for the whole set


def attracting_core(
    system: EnclosedSystem, section: MapSection, iterates: int, point: Floats, scale: float
) -> AttractingCore:
    """The largest set tried around a periodic point that is proved to be contracted.

    `iterates` is the number of returns in one period of the orbit, `point` (d,) the approximate
    place where it meets the section. Sets much larger than `scale`, a length in the section's
    coordinates, are not tried. `Undecided` with the reason if no set is proved.
    """
    trouble = Undecided("no set around the orbit was tried")
    for power in _POWERS:
        mapped = SectionMap(system, section, iterates * power)
        try:
            centre, slope = _about(mapped, point, scale)
        except Undecided as reason:
            trouble = reason
            continue
        if np.abs(centre - point).max() > _NEAR * scale:
            raise Undecided("another orbit is there, and not this one", digits=False)
        frame = _frame(slope)
        turned = np.linalg.inv(frame) @ slope @ frame
        if np.abs(turned).sum(axis=1).max() >= 1:
            trouble = Undecided("the map does not contract about the orbit", digits=False)
            continue
        for size in range(_LARGEST, _SMALLEST):
            h_set = decimal_set("core", centre.tolist(), frame * scale * 2.0**-size)
            try:
                contraction, passages = _contraction(mapped, h_set)
            except Undecided as reason:
                trouble = reason
                continue
            return AttractingCore(h_set, iterates * power, contraction, passages)
    raise trouble


def _about(mapped: SectionMap, point: Floats, scale: float) -> tuple[Floats, Floats]:
    """The fixed point (d,) and the derivative (d, d) there, in doubles."""
    size = len(point)
    for _ in range(3):
        tiny = decimal_set("point", point.tolist(), np.eye(size) * scale * _TINY, 12)
        image, slope = _image(mapped, tiny)
        found = np.array([float(x.mid()) for x in image.ranges[:-1]])
        slope = slope / (scale * _TINY)
        point = point + np.linalg.solve(np.eye(size) - slope, found - point)
    return point, slope


def _image(mapped: SectionMap, h_set: HSet) -> tuple[AffineSet, Floats]:
    whole = ((-1.0, 1.0),) * len(h_set.centre)
    states = mapped.image(piece(h_set, mapped.section, whole, sloped=True)).states
    image = coordinates(states, mapped.section.free)
    slope = [[float(x.mid()) for x in t.ranges[:-1]] for t in image.tangents]
    return image, np.array(slope).T


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


def _contraction(mapped: SectionMap, h_set: HSet) -> tuple[Fraction, tuple[PassedTransition, ...]]:
    """The factor by which the map contracts a set into itself, and its transitions on the way.

    The set is convex: bounds of the derivative over parts of it bound how far two states part.
    `Undecided` if no contraction is proved.
    """
    boxes: list[Box] = [((-1.0, 1.0),) * len(h_set.centre)]
    largest, looked = Fraction(0), 0
    ways: set[tuple[PassedTransition, ...]] = set()
    while boxes:
        box = boxes.pop()
        looked += 1
        try:
            found, passages = _over(mapped, h_set, box)
            largest = max(largest, found)
            ways.add(passages)
        except Undecided:
            longest = max(range(len(box)), key=lambda k: box[k][1] - box[k][0])
            if box[longest][1] - box[longest][0] < _FINEST or looked > _MOST:
                raise
            boxes += slices(box, longest)
    if len(ways) > 1:
        raise Undecided("states around the orbit do not go one way", digits=False)
    return largest, ways.pop()


def _over(
    mapped: SectionMap, h_set: HSet, box: Box
) -> tuple[Fraction, tuple[PassedTransition, ...]]:
    """A bound of the derivative over a part that is mapped into the set, and its transitions."""
    states, passages = mapped.image(piece(h_set, mapped.section, box, sloped=True))
    seen = coordinates(states, mapped.section.free).mapped(h_set.inward)
    if not all(abs(x) < 1 for x in seen.ranges):
        raise Undecided("a set around the orbit is not mapped into itself", digits=False)
    columns = [tangent.ranges for tangent in seen.tangents]
    sums = [sum((abs(x) for x in row[1:]), abs(row[0])) for row in zip(*columns, strict=True)]
    found = max(_above(x) for x in sums)
    if found >= 1:
        raise Undecided("a set around the orbit is not contracted", digits=False)
    return found, passages


def _above(ball: arb) -> Fraction:
    """A fraction that is no less than a ball."""
    top = float(ball.upper())
    return Fraction(int(np.ceil(top * _UP)) + 1, _UP) if np.isfinite(top) else Fraction(2)
