"""What is proved of chaos: sets, which of them cover which, and the entropy that follows."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Annotated, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, check_integer
from nonsmooth.runtime.core.json_codec import UNSTATED, Exact
from nonsmooth.runtime.core.registry import registered
from nonsmooth.runtime.proof.certificate import Decided
from nonsmooth.runtime.proof.chaos.cone_conditions import ConeCondition
from nonsmooth.runtime.proof.chaos.h_sets import HSet
from nonsmooth.runtime.proof.sets.sections import SectionRecord

_MOST_STEPS = 512  # of a word


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class ChaosCertificate(SectionRecord):
    """Symbolic dynamics of a system at one parameter point, proved by covering relations.

    P is the map from a section to itself: over one period of the forcing, or from one passage
    of a transition to the next. Where N and M are h-sets and N covers M by P^k, each walk
    through the graph is the itinerary of a motion, and each closed one that of a periodic
    motion, unstable or not. On the set of these motions P has at least the topological entropy
    that is stated.

    Attributes
    ----------
    system : str
    parameters : dict of str to Value
        All of the system, exactly.
    claim : {"proved", "undecided"}
        Whether the entropy is proved to be positive.
    reason : str
        Why it is undecided.
    configuration : str
        In which states on the section are; empty where nothing is claimed.
    phase : tuple of str
        Cosine and sine of the forcing on the section; empty without a forcing.
    source, boundary : str
        What the transition of the section leaves and by what; empty with a forcing.
    coordinates : tuple of str
        States that are the coordinates of the section.
    iterates : int
        k.
    h_sets : tuple of HSet
        They have no point in common.
    coverings : tuple of (str, str)
        Which one covers which, by name.
    itineraries : dict of str to tuple of (configuration, boundary, configuration)
        The transitions from each h-set to its image.
    growth : str
        The spectral radius of the graph is no less: a fraction.
    entropy : str
        The topological entropy of P is no less: log(growth) / k, rounded down.
    cones : ConeCondition or None
        What shows that neighbours part; None where no cone condition is proved.
    images : dict of str to tuple of tuple of tuple of float
        For pictures, of the image of each h-set the corners of the parts that contain it; empty
        for what was loaded, and on sections of more than two coordinates.
    parts : int
        How many images of parts of h-sets the proof enclosed; a check encloses at most eight
        times as many.
    tried : tuple of str
        What was looked for, line by line.
    bits : int
        Precision of the proof.
    declaration : dict
        The system, as functions of its parameters, as in the file; empty where nothing is
        claimed.
    """

    claim: Decided
    reason: str
    iterates: int
    h_sets: tuple[HSet, ...]
    coverings: tuple[tuple[str, str], ...]
    itineraries: Mapping[str, tuple[tuple[str, str, str], ...]]
    growth: Exact
    entropy: Exact
    cones: ConeCondition | None
    images: Annotated[Mapping[str, Any], UNSTATED] = field(default_factory=dict, repr=False)
    parts: int = field(repr=False)
    tried: tuple[str, ...] = field(repr=False)
    bits: int

    @property
    def proved(self) -> bool:
        """Whether there is chaos: the entropy is proved to be positive."""
        return self.claim == "proved"

    @property
    def claims(self) -> dict[str, str]:
        """Verdict on "chaos"."""
        return {"chaos": self.claim}

    @property
    def exponent(self) -> str:
        """Largest Lyapunov exponents of the motions are no less, by iterate; "0" if unproved."""
        return "0" if self.cones is None else self.cones.exponent

    @property
    def matrix(self) -> np.ndarray:
        """Whether each h-set covers each other one: (n, n) of 0 and 1."""
        names = [h_set.name for h_set in self.h_sets]
        found = np.zeros((len(names), len(names)), dtype=int)
        for one, other in self.coverings:
            found[names.index(one), names.index(other)] = 1
        return found

    def periodic_points(self, steps: int) -> int:
        """How many points that come back after some steps of P^k are proved, at least.

        Parameters
        ----------
        steps : int
            From 1 to 512.

        Returns
        -------
        int
            The trace of the power of the matrix: closed walks of so many steps.

        Raises
        ------
        InputError
            For another number of steps.
        """
        check_integer("steps", steps, 1, _MOST_STEPS)
        matrix = self.matrix.astype(object)
        power = matrix
        for _ in range(steps - 1):
            power = power @ matrix
        return int(sum(power[k, k] for k in range(len(matrix))))

    def words(self, steps: int) -> list[tuple[str, ...]]:
        """Periodic motions by the h-sets that they visit: closed walks, each from one start.

        Parameters
        ----------
        steps : int
            Of P^k, until the motion comes back.

        Returns
        -------
        list of tuple of str
            Words that repeat no shorter one, the first of their rotations in order.

        Raises
        ------
        InputError
            For another number of steps than 1 to 512, or more than 100000 walks.
        """
        check_integer("steps", steps, 1, _MOST_STEPS)
        if self.matrix.any() and self.periodic_points(steps) > 100_000:
            raise InputError(f"there are more than 100000 words of {steps} steps")
        ahead: dict[str, list[str]] = {}
        for one, other in self.coverings:
            ahead.setdefault(one, []).append(other)
        walks: list[tuple[str, ...]] = [(h_set.name,) for h_set in self.h_sets]
        for _ in range(steps - 1):
            walks = [(*w, other) for w in walks for other in ahead.get(w[-1], ())]
        closed = [w for w in walks if (w[-1], w[0]) in self.coverings]
        return [w for w in closed if _first(w)]

    def plot(self, axes: Any = None) -> Any:
        """Draw the h-sets, what contains their images, and the graph of the coverings.

        Parameters
        ----------
        axes : matplotlib Axes, optional
            Where to draw the sets, without the graph; a figure of its own by default.

        Returns
        -------
        matplotlib Figure or Axes
            The figure, or the Axes that were given.

        Raises
        ------
        InputError
            If nothing is proved, or the section has more than two coordinates.
        MissingExtra
            Without matplotlib: ``pip install "nonsmooth[plot]"``.
        """
        return registered("draw_chaos")(self, axes)


def _first(word: Sequence[str]) -> bool:
    """Whether a word is the first of its rotations, and no power of a shorter one."""
    own = tuple(word)
    turned = [own[k:] + own[:k] for k in range(1, len(own))]
    return all(own < other for other in turned)
