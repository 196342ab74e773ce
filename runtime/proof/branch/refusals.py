"""What the checker refuses of a branch: it is asked before anything is stated."""

from __future__ import annotations

from dataclasses import replace

from nonsmooth.runtime.checker.beyond import check_beyond
from nonsmooth.runtime.checker.branch import check_ends, check_joint, curve_of
from nonsmooth.runtime.checker.branch_curve import CheckedCurve
from nonsmooth.runtime.checker.branch_tile import BITS, CheckedTile
from nonsmooth.runtime.checker.parameters import independent
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.proof.branch.certified_branch import (
    BranchTile,
    CertifiedBranch,
    OrbitBeyond,
    tile_json,
)
from nonsmooth.runtime.proof.certificate import file_json
from nonsmooth.runtime.proof.orbit_to_prove import NotCovered
from nonsmooth.runtime.proof.refusals import as_read, refusal

__all__ = ["Refusals"]


class Refusals:
    """The reasons why the checker does not prove what is stated of a branch; "" where it does."""

    curve: CheckedCurve

    def __init__(self, branch: CertifiedBranch) -> None:
        self.branch = branch
        self.content = as_read(file_json(replace(branch, tiles=())))

        def begin() -> None:
            with flint_precision(BITS):
                self.curve = curve_of(self.content)

        reason = refusal(begin)
        if reason:
            raise NotCovered(reason)

    def of_tile(self, tile: BranchTile, before: BranchTile | None, after: BranchTile | None) -> str:
        """Why a tile between its neighbours is refused; None stands for a missing neighbour."""

        def check() -> None:
            with flint_precision(BITS):
                found = self._checked(tile)
                found.check_sharply()
                if before is not None:
                    check_joint(self._checked(before), found)
                if after is not None:
                    check_joint(found, self._checked(after))
                independent(self.curve.declared, self.curve.constants, [self.curve.interval])

        return refusal(check)

    def of_ends(self, branch: CertifiedBranch) -> str:
        """Why the ends of a branch that has tiles are refused."""

        def check() -> None:
            with flint_precision(BITS):
                outer = (branch.tiles[0], branch.tiles[-1])
                check_ends([*map(self._checked, outer)], list(branch.ends))

        return refusal(check)

    def without_refused(self, tile: BranchTile) -> BranchTile:
        """The tile with those orbits beyond its event that the checker proves."""
        if tile.event is None or not tile.event.beyond:
            return tile
        found: list[CheckedTile] = []

        def check() -> None:
            with flint_precision(BITS):
                found.append(self._checked(tile))
                found[0].check_sharply()

        kept: list[OrbitBeyond] = []
        if not refusal(check):
            kept = [each for each in tile.event.beyond if not self._of_beyond(found[0], each)]
        return replace(tile, event=replace(tile.event, beyond=tuple(kept)))

    def _of_beyond(self, tile: CheckedTile, beyond: OrbitBeyond) -> str:
        told = {"side": beyond.side, "own": beyond.own, "verdict": beyond.verdict}
        branch = as_read(file_json(beyond.branch))
        return refusal(lambda: check_beyond(self.content, tile, {**told, "branch": branch}))

    def _checked(self, tile: BranchTile) -> CheckedTile:
        return CheckedTile(self.curve, as_read(tile_json(tile)))
