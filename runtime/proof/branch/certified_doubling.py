"""What is proved of a flip and the orbits of twice the period beyond it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Annotated, Any, Literal

from nonsmooth.runtime.core.json_codec import Follows, Ordinal, Several, Told, named_as, one_of
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.kernels import known_system
from nonsmooth.runtime.model.saved_system import named
from nonsmooth.runtime.proof.boxes.tile_event import Side
from nonsmooth.runtime.proof.branch.certified_branch import (
    UNDECIDED,
    BranchEvent,
    CertifiedBranch,
    DrawnOverParameter,
    KeptBall,
)
from nonsmooth.runtime.proof.certificate import Decided

Ended = Literal["complete", "unfinished", "no flip", "not covered", "not proved"]


@dataclass(frozen=True, eq=False, kw_only=True)
class DoubledOrbits:
    """The orbits of twice the period next to a flip of a branch.

    The unknowns of the orbit's two halves are m + a w and m - a w. For each amplitude a up to the
    largest there is exactly one such orbit in a tube around polynomials of a; where a is zero it
    is the flip. The parameter changes in one direction all along it.
    """

    tile: Ordinal  # number of the tile of the flip's branch that holds the flip, from 0
    scaled: str  # the unknown whose entry of w is 1: its halves are 2 a apart
    amplitude: Fraction  # the largest a
    side: Side  # of the flip's parameter, where the doubled orbits are
    # "stable", "unstable" or "undecided": all doubled orbits in the tube whose amplitude is not
    # zero
    verdict: Annotated[str, one_of(("stable", "unstable", UNDECIDED))]
    reason: str  # why it is undecided
    rate: KeptBall  # derivative of the parameter by the square of a, at the flip
    # coefficients by e = a / amplitude of m, of w without its entry 1, and of the parameter
    centre: tuple[tuple[float, ...], ...] = field(repr=False)
    radii: tuple[float, ...] = field(repr=False)
    branch: CertifiedBranch = field(repr=False)  # from inside the tube on


@dataclass(frozen=True, kw_only=True)
class DoublingEntries:
    """Entries for the branch with the flip, and what its orbit is called."""

    orbit: str
    branch: CertifiedBranch


def _entries(orbit: str, branch: CertifiedBranch) -> DoublingEntries:
    """The entries, where the orbit's system is called as the file calls that of the branch."""
    own = orbit.removeprefix(branch.system)
    label = branch.orbit.removeprefix(f"{branch.system}:")
    known = known_system(branch.system, None if label == branch.orbit else label)
    return DoublingEntries(
        orbit=orbit if own == orbit else named(known, branch.orbit)[0] + own, branch=branch
    )


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class CertifiedDoubling(DrawnOverParameter):
    """What ball arithmetic proves beyond a flip: orbits of twice the period.

    Attributes
    ----------
    orbit : str
        The orbit whose branch has the flip.
    ended : {"complete", "unfinished", "no flip", "not covered", "not proved"}
        Whether it is all there, or why not: time or Ctrl-C ended the work, and `resume` goes
        on; the branch has no flip that is proved; such orbits are not covered; or a step is not
        proved.
    branch : CertifiedBranch
        The branch with the flip.
    doubled : DoubledOrbits or None
        The orbits beside the flip and, as its `branch`, how they go on.
    end : str
        Why it is not complete, in a sentence; empty where it is.
    """

    _drawn_by = "draw_doubling"

    orbit: Annotated[
        str,
        Several(
            DoublingEntries, _entries, lambda own: (own.orbit, own.branch), ("orbit", "branch")
        ),
    ]
    ended: Ended
    branch: CertifiedBranch = field(repr=False)
    doubled: DoubledOrbits | None
    end: str

    @Told
    def system(self) -> str:
        """Its system."""
        return self.branch.system

    @property
    def parameters(self) -> Mapping[str, Value]:
        """All that is given beside the branch's parameter."""
        return self.branch.parameters

    @Told
    def parameter(self) -> str:
        """The parameter along which the branches go."""
        return self.branch.parameter

    @property
    def flip(self) -> BranchEvent | None:
        """The flip, where the doubled orbits beside it are proved."""
        return None if self.doubled is None else self.branch.tiles[self.doubled.tile].event

    @Follows
    def claims(self) -> Annotated[dict[str, str], named_as(("doubling",), Decided)]:
        """Of the doubling: "proved" where it is there, with a verdict."""
        decided = self.doubled is not None and self.doubled.verdict != UNDECIDED
        return {"doubling": "proved" if decided else UNDECIDED}

    @Told
    def kind(self) -> str:
        """Whether the flip is "supercritical" or "subcritical"; empty where neither is told.

        It is supercritical where the doubled orbits are stable; subcritical where they are
        unstable and the orbit is stable on one side.
        """
        if self.doubled is None:
            return ""
        if self.doubled.verdict == "stable":
            return "supercritical"
        tile = self.branch.tiles[self.doubled.tile]
        beside = (tile.before, tile.after)
        return "subcritical" if self.doubled.verdict == "unstable" and "stable" in beside else ""

    @Told
    def statement(self) -> str:
        """What is proved, in one sentence, and why it is not complete."""
        doubled, flip = self.doubled, self.flip
        if doubled is None or flip is None:
            return self.end
        begin, end = _reach(doubled.branch)
        words = f" is {self.kind}:" if self.kind else ":"
        verdict = (
            f"orbits of twice the period ({doubled.reason})"
            if doubled.verdict == UNDECIDED
            else f"{doubled.verdict} orbits of twice the period"
        )
        told = (
            f"the flip at {self.parameter} = {flip.enclosures[self.parameter]}{words}"
            f" {doubled.side} it there are {verdict}, one for each value up to {begin:.10g}, and"
            f" they are followed to {end:.10g}"
        )
        return f"{told}; {self.end}" if self.end else told

    def to_json(self) -> dict[str, Any]:
        """Give the doubling as JSON, with the parameter at the flip.

        Returns
        -------
        dict
            Ready for `json.dumps`.
        """
        value = None if self.flip is None else self.flip.enclosures[self.parameter].to_json()
        return {**super().to_json(), "flip": value}


def _reach(branch: CertifiedBranch) -> tuple[float, float]:
    """Return the parameters, about, from which and up to which a doubled branch is proved."""
    if not branch.tiles:
        ends = [float(end) for end in branch.interval]
        return ends[0], ends[0]
    forwards = branch.start == 0
    first, last = branch.tiles[0], branch.tiles[-1]
    if forwards:
        return branch.parameter_at(first)[0], branch.parameter_at(last)[1]
    return branch.parameter_at(last)[1], branch.parameter_at(first)[0]
