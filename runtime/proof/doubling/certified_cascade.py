"""What is proved of flips and the orbits of twice the period beyond them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import pairwise
from typing import Any, Literal

from nonsmooth.runtime.core.values import Value, flint_precision
from nonsmooth.runtime.proof.branch.certified_branch import (
    BranchEvent,
    CertifiedBranch,
    DrawnOverParameter,
)
from nonsmooth.runtime.proof.branch.look import UNDECIDED
from nonsmooth.runtime.proof.certificate import Stated

__all__ = ["CertifiedCascade", "CertifiedDoubling", "doubling_json", "told_cascade_json"]

_RATIO_BITS = 80

Ended = Literal["complete", "unfinished", "no flip", "not covered", "not proved"]


@dataclass(frozen=True, eq=False, kw_only=True)
class CertifiedDoubling:
    """The orbits of twice the period next to one flip of a branch.

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


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class CertifiedCascade(DrawnOverParameter):
    """What ball arithmetic proves beyond flips: orbits of twice the period, again and again.

    Attributes
    ----------
    orbit : str
        The orbit whose branch has the first flip.
    asked : int
        How many doublings were asked for.
    ended : {"complete", "unfinished", "no flip", "not covered", "not proved"}
        Why it goes no further: there is all that was asked for; time or Ctrl-C ended the work,
        and `resume` goes on; the doubled branch has no flip that is proved; such orbits are not
        covered; or a step is not proved.
    doublings : tuple of CertifiedDoubling
        Each next to a flip of the branch with its number.
    branches : tuple of CertifiedBranch
        The branch with the first flip, and behind each doubling the branch of twice the period,
        from inside the doubling's tube on.
    end : str
        The same in a sentence; empty where it is complete.
    """

    _kept_by, _drawn_by = "save_cascade", "draw_cascade"

    orbit: str
    asked: int
    ended: Ended
    doublings: tuple[CertifiedDoubling, ...]
    branches: tuple[CertifiedBranch, ...] = field(repr=False)
    end: str

    @property
    def system(self) -> str:
        """Its system."""
        return self.branches[0].system

    @property
    def parameters(self) -> Mapping[str, Value]:
        """All that is given beside the branch's parameter."""
        return self.branches[0].parameters

    @property
    def parameter(self) -> str:
        """The parameter along which the branches go."""
        return self.branches[0].parameter

    @property
    def flips(self) -> tuple[BranchEvent, ...]:
        """The flips whose doubled orbits are proved."""
        found = []
        for branch, doubling in zip(self.branches, self.doublings, strict=False):
            event = branch.tiles[doubling.tile].event
            assert event is not None
            found.append(event)
        return tuple(found)

    @property
    def ratios(self) -> tuple[Stated, ...]:
        """Enclosures of the distances of neighbouring flips, each by the next one."""
        values = [event.enclosures[self.parameter].ball for event in self.flips]
        with flint_precision(_RATIO_BITS + 64):
            steps = [after - before for before, after in pairwise(values)]
            return tuple(
                Stated.around(long / short, _RATIO_BITS) for long, short in pairwise(steps)
            )

    @property
    def claims(self) -> dict[str, str]:
        """Of the doublings: "proved" where all that were asked for are there, with a verdict."""
        decided = all(doubling.verdict != UNDECIDED for doubling in self.doublings)
        whole = len(self.doublings) == self.asked and decided
        return {"doublings": "proved" if whole else UNDECIDED}

    def kind(self, number: int) -> str:
        """Whether a flip is supercritical or subcritical.

        Parameters
        ----------
        number : int
            Of the doubling, from 0.

        Returns
        -------
        {"supercritical", "subcritical", ""}
            Supercritical where the doubled orbits are stable; subcritical where they are
            unstable and the orbit is stable on one side; else neither is told.
        """
        doubling, tile = self.doublings[number], self.branches[number].tiles
        if doubling.verdict == "stable":
            return "supercritical"
        beside = (tile[doubling.tile].before, tile[doubling.tile].after)
        return "subcritical" if doubling.verdict == "unstable" and "stable" in beside else ""

    @property
    def statement(self) -> str:
        """What is proved, in one sentence for each flip."""
        told = []
        for number, (event, doubling) in enumerate(zip(self.flips, self.doublings, strict=True)):
            kind = self.kind(number)
            value = event.enclosures[self.parameter]
            beyond = self.branches[number + 1]
            begin, end = _reach(beyond)
            words = f" is {kind}:" if kind else ":"
            verdict = (
                f"orbits of twice the period ({doubling.reason})"
                if doubling.verdict == UNDECIDED
                else f"{doubling.verdict} orbits of twice the period"
            )
            told.append(
                f"the flip at {self.parameter} = {value}{words} {doubling.side} it there are"
                f" {verdict}, one for each value up to {begin:.10g}, and they are followed to"
                f" {end:.10g}"
            )
        if self.end:
            told.append(self.end)
        return "; ".join(told)

    def to_json(self) -> dict[str, Any]:
        """Give the cascade as JSON: numbers as decimal strings or fractions.

        Returns
        -------
        dict
            What is proved, ready for `json.dumps`.
        """
        return {
            "orbit": self.orbit,
            "system": self.system,
            "parameter": self.parameter,
            "claims": self.claims,
            "asked": self.asked,
            "ended": self.ended,
            "end": self.end,
            "doublings": [doubling_json(doubling) for doubling in self.doublings],
            "branches": [branch.to_json() for branch in self.branches],
        }


def told_cascade_json(found: CertifiedCascade) -> dict[str, Any]:
    """Return what follows from the doublings as JSON: statement, flips with kinds, and ratios."""
    return {
        "statement": found.statement,
        "flips": [
            {
                "value": event.enclosures[found.parameter].to_json(),
                "kind": found.kind(number),
            }
            for number, event in enumerate(found.flips)
        ],
        "ratios": [ratio.to_json() for ratio in found.ratios],
    }


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


def doubling_json(doubling: CertifiedDoubling) -> dict[str, Any]:
    """Return a doubling as JSON, with its tile counted from 1."""
    return {
        "tile": doubling.tile + 1,
        "scaled": doubling.scaled,
        "amplitude": str(doubling.amplitude),
        "side": doubling.side,
        "verdict": doubling.verdict,
        "reason": doubling.reason,
        "rate": doubling.rate.to_json(),
        "centre": [list(row) for row in doubling.centre],
        "radii": list(doubling.radii),
    }
