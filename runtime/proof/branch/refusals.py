"""What the checker refuses of a branch: it is asked before anything is stated."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any

from nonsmooth.runtime.checker.beyond import check_beyond
from nonsmooth.runtime.checker.branch import check_joint, curve_of
from nonsmooth.runtime.checker.branch_tile import BITS, CheckedTile
from nonsmooth.runtime.checker.exact import Failure
from nonsmooth.runtime.checker.parameters import independent
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.proof.branch.certified_branch import (
    BranchTile,
    CertifiedBranch,
    OrbitBeyond,
    tile_json,
)
from nonsmooth.runtime.proof.orbit_to_prove import NotCovered

__all__ = ["Refusals"]


class Refusals:
    """Why the checker does not prove what is stated of a branch; "" where it does."""

    def __init__(self, branch: CertifiedBranch) -> None:
        self.branch = branch
        self.content = _content(replace(branch, tiles=()))
        try:
            with flint_precision(BITS):
                self.curve = curve_of(self.content)
        except Failure as failure:
            raise NotCovered(f"the checker refuses it: {failure}") from None

    def of_tile(self, tile: BranchTile, before: BranchTile | None, after: BranchTile | None) -> str:
        """Of a tile between its neighbours, of which there may be none."""
        try:
            with flint_precision(BITS):
                found = self._checked(tile)
                found.check_sharply()
                if before is not None:
                    check_joint(self._checked(before), found)
                if after is not None:
                    check_joint(found, self._checked(after))
                independent(self.curve.declared, self.curve.constants, [self.curve.interval])
        except Failure as failure:
            return f"the checker refuses it: {failure}"
        return ""

    def without_refused(self, tile: BranchTile) -> BranchTile:
        """The tile with what begins at its event, as far as the checker proves that."""
        if tile.event is None or not tile.event.beyond:
            return tile
        with flint_precision(BITS):
            found = self._checked(tile)
            found.check_sharply()
            kept = [each for each in tile.event.beyond if self._begins(found, each)]
        return replace(tile, event=replace(tile.event, beyond=tuple(kept)))

    def _begins(self, tile: CheckedTile, beyond: OrbitBeyond) -> bool:
        told = {"side": beyond.side, "own": beyond.own, "verdict": beyond.verdict}
        try:
            check_beyond(self.content, tile, {**told, "branch": _content(beyond.branch)})
        except Failure:
            return False
        return True

    def _checked(self, tile: BranchTile) -> CheckedTile:
        return CheckedTile(self.curve, _as_read(tile_json(tile)))


def _content(branch: CertifiedBranch) -> dict[str, Any]:
    """What the checker reads of a branch in its file."""
    own = {"declaration": dict(branch.declaration), "closing": dict(branch.closing)}
    return _as_read({**branch.to_json(), **own})


def _as_read(told: dict[str, Any]) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(json.dumps(told))
    return found
