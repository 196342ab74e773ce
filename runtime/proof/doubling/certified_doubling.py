"""What is proved of a flip and the orbits of twice the period beyond it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, Literal

from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.proof.branch.certified_branch import (
    UNDECIDED,
    BranchEvent,
    CertifiedBranch,
    DrawnOverParameter,
)
from nonsmooth.runtime.proof.certificate import Stated

__all__ = ["CertifiedDoubling", "DoubledOrbits", "Ended", "doubled_json", "told_doubling_json"]

Ended = Literal["complete", "unfinished", "no flip", "not covered", "not proved"]


@dataclass(frozen=True, eq=False, kw_only=True)
class DoubledOrbits:
    """The orbits of twice the period next to a flip of a branch.

    The unknowns of the orbit's two halves are m + a w and m - a w. For each amplitude a up to the
    largest there is exactly one such orbit in a tube around polynomials of a; where a is zero it
    is the flip. The parameter changes in one direction all along it.
    """

    tile: int  # number of the tile of the flip's branch that holds the flip, from 0
    scaled: str  # the unknown whose entry of w is 1: its halves are 2 a apart
    amplitude: Fraction  # the largest a
    side: str  # "above" or "below": of the flip's parameter, where the doubled orbits are
    # "stable", "unstable" or "undecided": all doubled orbits in the tube whose amplitude is not
    # zero
    verdict: str
    reason: str  # why it is undecided
    rate: Stated  # derivative of the parameter by the square of a, at the flip
    # coefficients by e = a / amplitude of m, of w without its entry 1, and of the parameter
    centre: tuple[tuple[float, ...], ...] = field(repr=False)
    radii: tuple[float, ...] = field(repr=False)
    branch: CertifiedBranch = field(repr=False)  # from inside the tube on


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

    _kept_by, _drawn_by = "save_doubling", "draw_doubling"

    orbit: str
    ended: Ended
    branch: CertifiedBranch = field(repr=False)
    doubled: DoubledOrbits | None
    end: str

    @property
    def system(self) -> str:
        """Its system."""
        return self.branch.system

    @property
    def parameters(self) -> Mapping[str, Value]:
        """All that is given beside the branch's parameter."""
        return self.branch.parameters

    @property
    def parameter(self) -> str:
        """The parameter along which the branches go."""
        return self.branch.parameter

    @property
    def flip(self) -> BranchEvent | None:
        """The flip, where the doubled orbits beside it are proved."""
        return None if self.doubled is None else self.branch.tiles[self.doubled.tile].event

    @property
    def claims(self) -> dict[str, str]:
        """Of the doubling: "proved" where it is there, with a verdict."""
        decided = self.doubled is not None and self.doubled.verdict != UNDECIDED
        return {"doubling": "proved" if decided else UNDECIDED}

    @property
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

    @property
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
        """Give the doubling as JSON: numbers as decimal strings or fractions.

        Returns
        -------
        dict
            What is proved, ready for `json.dumps`.
        """
        doubled = self.doubled
        return {
            "orbit": self.orbit,
            "system": self.system,
            "parameter": self.parameter,
            "claims": self.claims,
            "ended": self.ended,
            "end": self.end,
            "branch": self.branch.to_json(),
            "doubled": None
            if doubled is None
            else {**doubled_json(doubled), "branch": doubled.branch.to_json()},
        }


def told_doubling_json(found: CertifiedDoubling) -> dict[str, Any]:
    """Return what follows from the doubling as JSON: statement, flip and its kind."""
    value = None if found.flip is None else found.flip.enclosures[found.parameter].to_json()
    return {"statement": found.statement, "flip": value, "kind": found.kind}


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


def doubled_json(doubled: DoubledOrbits) -> dict[str, Any]:
    """Return doubled orbits as JSON, without their branch; their tile is counted from 1."""
    return {
        "tile": doubled.tile + 1,
        "scaled": doubled.scaled,
        "amplitude": str(doubled.amplitude),
        "side": doubled.side,
        "verdict": doubled.verdict,
        "reason": doubled.reason,
        "rate": doubled.rate.to_json(),
        "centre": [list(row) for row in doubled.centre],
        "radii": list(doubled.radii),
    }
