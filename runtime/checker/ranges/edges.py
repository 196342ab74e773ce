"""Which tiles of a box of two parameters have an edge in common."""

from collections import defaultdict
from collections.abc import Sequence

__all__ = ["SMALLEST", "neighbours"]

SMALLEST = 60  # halvings of the box along an axis

_Side = list[tuple[int, int, int]]


def neighbours(places: Sequence[Sequence[tuple[int, int]]]) -> list[list[int]]:
    """Return for each tile the numbers of those with which it shares more than a point.

    A place is a (step, level) along each of two axes: part `step` of 2^level. Tiles do not overlap.
    """
    ends = [
        [(step << SMALLEST - level, step + 1 << SMALLEST - level) for step, level in place]
        for place in places
    ]
    found: list[list[int]] = [[] for _ in places]
    for axis in (0, 1):
        sides: dict[int, tuple[_Side, _Side]] = defaultdict(lambda: ([], []))
        for number, place in enumerate(ends):
            (low, high), across = place[axis], place[1 - axis]
            sides[high][0].append((*across, number))
            sides[low][1].append((*across, number))
        for before, behind in sides.values():
            first, second = sorted(before), sorted(behind)
            while first and second:
                (low, high, one), (least, most, other) = first[-1], second[-1]
                if max(low, least) < min(high, most):
                    found[one].append(other)
                    found[other].append(one)
                if low >= least:
                    first.pop()
                if least >= low:
                    second.pop()
    return found
