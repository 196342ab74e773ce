"""The walk through a tree of boxes that covers all that is searched: every root, and what is left.

A tree is a text with a letter for each box, first those before it, then those in it: "-" if there
is no root in it, "*" if all of its roots are one that is unique in a box, "=" if it is made smaller
by what its equations tell, "?" if it is left open, and a, b, c, ... if it is cut in the middle of
the first, second, third, ... unknown. What the letters say is proved here, box by box, so a tree
saves nothing but the search for it.
"""

import math
from collections.abc import Callable
from functools import cached_property
from typing import Any

from nonsmooth.runtime.checker.counting.contraction import (
    Image,
    Linear,
    Sides,
    contract,
    enclosed,
    excluding,
    inside,
    regular,
    share_of,
    touching,
)
from nonsmooth.runtime.checker.counting.dwell_equations import DwellEquations
from nonsmooth.runtime.checker.stated.exact import Numbers, demand

CUTS = "abcdefghijklmnopqrstuvwxyz"
_SHRUNK = 0.75  # of its size: a box that was made so small may become smaller still
_CLOSE = 0.4  # of a box's radius: its image, from which on a root is looked for around it
_POLISHES = 6
_WIDER = (2.0, 8.0)  # of an image: boxes around it in which a root may be unique
_LEAST = 1e-13  # of an unknown's domain or size: what a box is widened by at least
_MOST_LEFT = 2000  # undecided boxes that are told apart


class Root:
    """A root, and a box in which it is the only one."""

    def __init__(self, sides: Sides, unique: Sides, coordinates: Numbers) -> None:
        self.sides = sides  # contains the root
        self.unique = unique  # contains no other root
        self.coordinates = coordinates  # those in which the equations are affine, at the root


class CoveringBox:
    """A box of a covering, with what is proved of it when it is asked for."""

    def __init__(self, equations: DwellEquations, sides: Sides) -> None:
        self.equations, self.sides = equations, sides

    @cached_property
    def linear(self) -> Linear | None:
        """The equations over the box; None where it is out of the range of all that is searched."""
        return self.equations.linear(self.sides)

    @cached_property
    def excluded(self) -> bool:
        """Whether one of the linear equations has no solution anywhere in it."""
        return self.linear is None or excluding(self.linear)

    @cached_property
    def image(self) -> Image | None:
        """Krawczyk's image of the box; None where that is not known."""
        if self.linear is None:
            return None
        return contract(self.linear, self.linear.coordinates, self.sides)

    @cached_property
    def unique(self) -> bool:
        """Whether it has exactly one root whose coordinates are not too large, or little larger.

        Only slopes between any two of its points tell that there are not two.
        """
        if self.linear is None or self.image is None or not self.image.unique:
            return False
        between = self.equations.linear(self.sides, between=True)
        assert between is not None
        image = contract(between, self.linear.coordinates, self.sides)
        return image is not None and image.unique

    @cached_property
    def kept(self) -> Sides:
        """What the box has in common with its image: all of its roots are there."""
        return self.sides if self.image is None else self.image.within(self.sides)

    @cached_property
    def empty(self) -> bool:
        """Whether no root is in the box, by its image, or since its equations have full rank."""
        apart = self.image is not None and self.image.empty
        apart = apart or any(low > high for low, high in self.kept)
        return apart or (self.linear is not None and regular(self.linear))

    @cached_property
    def root(self) -> Root | None:
        """The root that all roots in the box are, unique in the box or around its image."""
        if self.image is None or self.empty:
            return None
        if self.unique:
            return self._polished(Root(self.kept, self.sides, self.image.coordinates))
        found = self._around(self.image.sides) if self.image.ratio < _CLOSE else None
        return found if found is not None and inside(self.kept, found.unique) else None

    def _around(self, image: Sides) -> Root | None:
        """Return a root that is the only one of a box around an image, if that is proved."""
        for factor in _WIDER:
            wide = []
            for (low, high), (first, last) in zip(image, self.equations.domain, strict=True):
                middle, radius = low + (high - low) / 2, (high - low) / 2
                radius = factor * radius + _LEAST * max(last - first, abs(middle))
                wide.append((middle - radius, middle + radius))
            around = CoveringBox(self.equations, tuple(wide))
            if around.image is None or around.empty:
                return None
            if around.unique:
                root = Root(around.kept, around.sides, around.image.coordinates)
                return self._polished(root)
        return None

    def _polished(self, root: Root) -> Root:
        """Return the same root in a box as small as the arithmetic allows.

        Its coordinates are those that are known of it, even if they are too large.
        """
        for _ in range(_POLISHES):
            linear = self.equations.linear(root.sides)
            image = None if linear is None else contract(linear, root.coordinates, root.sides)
            if image is None or image.empty:
                return root
            kept = image.within(root.sides)
            if any(low > high for low, high in kept):  # of more equations than unknowns: no root
                return root
            better = share_of(kept, root.sides)
            root = Root(kept, root.unique, image.coordinates)
            if not better < _SHRUNK:
                return root
        return root


class Walk:
    """The walk through a covering of all that equations are searched in.

    An interruption of `follow` leaves it such that it can go on.
    """

    def __init__(self, equations: DwellEquations) -> None:
        self.equations = equations
        self.roots: list[Root] = []
        self.left: list[Sides] = []
        # boxes that wait, the next one first, and the letters, the last one first, as linked lists:
        # one assignment changes both
        self._state: tuple[tuple[Any, ...], tuple[Any, ...]] = (
            (CoveringBox(equations, equations.domain), ()),
            (),
        )

    def follow(self, advice: Callable[[CoveringBox], str], most: float = math.inf) -> None:
        """Go on through at most so many boxes, by the letters that `advice` gives for each.

        `Failure` is raised if a letter says what is not proved.
        """
        while self._state[0] and most > 0:
            most -= 1
            (part, waiting), letters = self._state
            letter = advice(part)
            for sides in reversed(self._inner(part, letter)):
                waiting = CoveringBox(self.equations, sides), waiting
            self._state = waiting, (letter, letters)

    @property
    def waits(self) -> bool:
        """Whether there are boxes left to look at."""
        return bool(self._state[0])

    @property
    def tree(self) -> str:
        """The letters up to here."""
        letters, found = self._state[1], []
        while letters:
            letter, letters = letters
            found.append(letter)
        return "".join(reversed(found))

    @property
    def undecided(self) -> list[Sides]:
        """Boxes of which nothing is known, joined where they touch; very many become one."""
        # a box around a root may reach into boxes that could not be decided
        left = [s for s in self.left if not any(inside(s, root.unique) for root in self.roots)]
        if len(left) > _MOST_LEFT:
            return [enclosed(left)]
        found: list[Sides] = []
        while left:
            one = left.pop()
            beside = [other for other in left if touching(one, other)]
            if beside:
                left = [other for other in left if not touching(one, other)]
                left.append(enclosed([one, *beside]))
            else:
                found.append(one)
        return sorted(found)

    def _inner(self, part: CoveringBox, letter: str) -> list[Sides]:
        """Return the boxes that are left of a box, if what its letter says is proved."""
        match letter:
            case "-":
                demand(part.excluded or part.empty, "a box may hold an orbit that is not counted")
                return []
            case "*":
                root = part.root
                demand(root is not None, "a box holds other orbits than one")
                assert root is not None
                self._add(root)
                return []
            case "=":
                demand(not part.empty, "a box that is empty is made smaller")
                return [part.kept]
            case "?":
                self.left.append(part.sides)
                return []
        place = CUTS.find(letter)
        demand(len(letter) == 1 and 0 <= place < len(part.sides), "the tree covers not all boxes")
        low, high = part.sides[place]
        middle = low + (high - low) / 2
        demand(low < middle < high, "a box is too small to be cut")
        halves = (low, middle), (middle, high)
        return [(*part.sides[:place], half, *part.sides[place + 1 :]) for half in halves]

    def _add(self, root: Root) -> None:
        """Take up a root, unless it is one that is known.

        Of more equations than unknowns a root need not exist. The one that is kept is the one in
        whose box the other lies: if this one exists, it is that one.
        """
        if any(inside(root.sides, other.unique) for other in self.roots):
            return
        self.roots = [other for other in self.roots if not inside(other.sides, root.unique)]
        touched = [other.sides for other in self.roots if touching(root.sides, other.sides)]
        if touched:  # neither the same root nor another one, by what is known
            self.left.append(enclosed([root.sides, *touched]))
        else:
            self.roots.append(root)
