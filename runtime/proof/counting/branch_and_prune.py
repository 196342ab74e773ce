"""Branch and prune: every root of a system of equations in a box, each proved unique.

A problem gives, over a box of its unknowns u, a matrix G(u): u is a root if G(u) (q, 1) = 0
for some coordinates q (none, where G has one column). The linear equations for q are not
divided by, so that there are no poles: where G(u) has full rank over a box there is no root
in it, whatever q would be.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, NamedTuple, Protocol

import numpy as np

from nonsmooth.runtime.proof.counting.contraction import (
    Linear,
    Sides,
    contract,
    enclosed,
    excluding,
    smears,
)

if TYPE_CHECKING:
    from flint import arb

__all__ = ["Problem", "Root", "Searched", "inside", "search", "touching", "untouched"]

_SMALLEST = 1e-9  # of the searched box: sides that are not cut any more
_SHRUNK = 0.75  # of its size: a box that was made so small is not cut, but looked at again
_CLOSE = 0.4  # of a box's radius: its image, from which on a root is looked for around it
_FAR = 3.0  # of a box's radius: an image so large does not help before the box is cut twice
_POLISHES = 6
_WIDER = (2.0, 8.0)  # of an image: boxes around it in which a root may be unique
_LEAST = 1e-13  # of an unknown's domain or size: what a box is widened by at least
_MOST_LEFT = 2000  # undecided boxes that are told apart
_TOLD = 64  # boxes between two reports


class Problem(Protocol):
    """Equations over boxes of unknowns."""

    @property
    def domain(self) -> Sequence[tuple[float, float]]:
        """The box that is searched; it may be larger than the box that is asked about."""
        ...

    def linear(self, sides: Sides) -> Linear | None:
        """The equations over a box in the system's units; None if they have no root there."""
        ...


class Root(NamedTuple):
    """A root, and a box in which it is the only one."""

    sides: Sides  # contains the root
    unique: Sides  # contains no other root
    coordinates: tuple[arb, ...]  # those in which the matrix is affine, at the root


class Searched(NamedTuple):
    """All roots of a box, and the boxes of which nothing is known, joined where they touch.

    After an interruption the boxes that were not looked at are among the undecided ones.
    """

    roots: tuple[Root, ...]
    undecided: tuple[Sides, ...]
    looked: int  # number of boxes that were looked at
    interrupted: bool = False


def search(
    problem: Problem, limit: int, progress: Callable[[float], object] = lambda share: None
) -> Searched:
    """Every root of a problem in its domain, by branch and prune.

    The method is that of Van Hentenryck, McAllester & Kapur (1997). At most `limit` boxes are
    looked at; those left over are undecided. `progress` is given the share of the domain that is
    done. Ctrl-C ends the search with what it has.
    """
    domain = tuple(problem.domain)
    sizes = [high - low for low, high in domain]
    stack: list[tuple[Sides, int]] = [(domain, 0)]
    roots: list[Root] = []
    left: list[Sides] = []
    done, looked, stopped = 0.0, 0, False
    try:
        while stack and looked < limit:
            sides, patience = stack[-1]
            rest, root, patience = _examined(problem, sides, sizes, patience)
            if root is not None and not any(_same(root, other) for other in roots):
                touched = [other.sides for other in roots if touching(root.sides, other.sides)]
                if touched:  # neither the same root nor another one, by what is known
                    left.append(enclosed([root.sides, *touched]))
                else:
                    roots.append(root)
            if len(rest) == 1 and rest[0] == sides:
                left.append(sides)
                rest = []
            # only now: whenever Ctrl-C comes, every box is found, left or waits
            stack[-1:] = [(part, patience) for part in rest]
            done += _share(sides, sizes) - sum(_share(part, sizes) for part in rest)
            looked += 1
            if looked % _TOLD == 0:
                progress(done)
    except KeyboardInterrupt:
        stopped = True
    left += [sides for sides, _ in stack]
    # a box around a root may reach into boxes that could not be decided
    left = [sides for sides in left if not any(inside(sides, r.unique) for r in roots)]
    return Searched(tuple(roots), _joined(left), looked, stopped)


def untouched(problem: Problem) -> Searched:
    """The result of a search that was interrupted before it began: all is undecided."""
    return Searched((), (tuple(problem.domain),), 0, interrupted=True)


def _examined(
    problem: Problem, sides: Sides, sizes: Sequence[float], patience: int
) -> tuple[list[Sides], Root | None, int]:
    """The boxes left of a box, a root proved in it or beside it, and the new `patience`.

    A box that cannot be decided is left as it is. `patience` is how often a box is cut before
    it is worth while to contract it.
    """
    linear = problem.linear(sides)
    if linear is None or excluding(linear):
        return [], None, 0
    image = None if patience else contract(linear, sides)
    if image is not None:
        kept = image.within(sides)
        if image.empty or any(low > high for low, high in kept):
            return [], None, 0
        if image.unique:
            return [], _polished(problem, Root(kept, sides, image.coordinates)), 0
        if image.ratio < _CLOSE:
            root = _around(problem, image.sides)
            # all roots of the box are in its image
            if root is not None and inside(kept, root.unique):
                return [], root, 0
        if _volume(kept, sides) < _SHRUNK:
            return [kept], None, 0
    if patience == 0:
        patience = 1 if image is not None and image.ratio < _FAR else 1 + len(sides)
    scores = smears(linear, sides)
    for place in np.argsort(-scores, kind="stable"):
        low, high = sides[place]
        middle = low + (high - low) / 2
        if high - low > _SMALLEST * sizes[place] and low < middle < high:
            halves = ((low, middle), (middle, high))
            parts = [(*sides[:place], half, *sides[place + 1 :]) for half in halves]
            return parts, None, patience - 1
    return [sides], None, 0


def _around(problem: Problem, image: Sides) -> Root | None:
    """A root that is the only one of a box around an image; None if that is not proved."""
    for factor in _WIDER:
        wide = []
        for (low, high), (first, last) in zip(image, problem.domain, strict=True):
            middle, radius = low + (high - low) / 2, (high - low) / 2
            radius = factor * radius + _LEAST * max(last - first, abs(middle))
            wide.append((middle - radius, middle + radius))
        sides = tuple(wide)
        linear = problem.linear(sides)
        if linear is None:
            return None
        found = contract(linear, sides)
        if found is None or found.empty:
            return None
        if found.unique:
            root = Root(found.within(sides), sides, found.coordinates)
            return _polished(problem, root)
    return None


def _polished(problem: Problem, root: Root) -> Root:
    """The same root in a box as small as the arithmetic allows."""
    for _ in range(_POLISHES):
        linear = problem.linear(root.sides)
        found = None if linear is None else contract(linear, root.sides)
        if found is None or found.empty:
            return root
        sides = found.within(root.sides)
        if any(low > high for low, high in sides):
            return root
        better = _volume(sides, root.sides)
        root = Root(sides, root.unique, found.coordinates)
        if not better < _SHRUNK:
            return root
    return root


def _same(one: Root, other: Root) -> bool:
    """Whether two boxes have one root in common: it lies where one of them has no other."""
    return inside(one.sides, other.unique) or inside(other.sides, one.unique)


def inside(sides: Sides, other: Sides) -> bool:
    """Whether a box is part of another one, or equal to it."""
    return all(a <= c and d <= b for (c, d), (a, b) in zip(sides, other, strict=True))


def _volume(part: Sides, whole: Sides) -> float:
    """The least share of a side that is kept; it only steers the search."""
    shares = [(d - c) / (b - a) for (c, d), (a, b) in zip(part, whole, strict=True) if b > a]
    return min(shares, default=1.0)


def _share(sides: Sides, sizes: Sequence[float]) -> float:
    return float(
        np.prod([(high - low) / size for (low, high), size in zip(sides, sizes, strict=True)])
    )


def _joined(left: Sequence[Sides]) -> tuple[Sides, ...]:
    """Boxes in which all boxes that touch are joined, until none touch; very many become one."""
    if len(left) > _MOST_LEFT:
        return (enclosed(left),)
    rest, found = list(left), []
    while rest:
        one = rest.pop()
        beside = [s for s in rest if touching(one, s)]
        if beside:
            rest = [s for s in rest if not touching(one, s)]
            rest.append(enclosed([one, *beside]))
        else:
            found.append(one)
    return tuple(sorted(found))


def touching(one: Sides, other: Sides) -> bool:
    """Whether two boxes have a point in common, edges included."""
    return all(a <= d and c <= b for (a, b), (c, d) in zip(one, other, strict=True))
