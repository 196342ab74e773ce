"""A branch of which nothing is proved yet, and branches and tiles as the checker knows them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from nonsmooth.runtime.checker.branch import curve_of
from nonsmooth.runtime.checker.branch_curve import CheckedCurve
from nonsmooth.runtime.checker.branch_tile import CheckedTile
from nonsmooth.runtime.core.json_codec import encode
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.proof.boxes.orbit_over_box import Region, given_of
from nonsmooth.runtime.proof.boxes.tile_places import Interval
from nonsmooth.runtime.proof.branch.certified_branch import BranchTile, CertifiedBranch
from nonsmooth.runtime.proof.certificate import file_json
from nonsmooth.runtime.proof.orbit_to_prove import NotCovered, system_of, unknown_names
from nonsmooth.runtime.proof.refusals import as_read, refusal

__all__ = ["checked_curve", "checked_tile", "stated_branch"]


def stated_branch(
    orbit: Orbit, box: Mapping[str, Interval], chosen: tuple[str, ...], region: Region | None
) -> CertifiedBranch:
    """Return a branch of which nothing is proved yet.

    `box` has the ends of its one parameter, `chosen` the parameters that were chosen because the
    orbit leaves them open. `region` is None where the branch's orbits are not covered.
    """
    ((parameter, interval),) = box.items()
    declaration, closing = ({}, {}) if region is None else region.statement(orbit)
    names = () if region is None else unknown_names(region.subject, region.closing)
    return CertifiedBranch(
        orbit=orbit.name,
        system=system_of(orbit),
        parameters={n: value for n, value in given_of(orbit).items() if n != parameter},
        chosen=chosen,
        itinerary=() if region is None else region.cycle.itinerary,
        parameter=parameter,
        interval=interval,
        stability="stable" if region is None else region.closing.stability,
        unknown_names=tuple(names),
        tiles=(),
        start=0,
        ends=("", ""),
        declaration=declaration,
        closing=closing,
    )


def checked_curve(branch: CertifiedBranch) -> tuple[dict[str, Any], CheckedCurve]:
    """Return a branch's entries without its tiles, as the checker reads them, and its equations.

    `NotCovered` if the checker refuses them.
    """
    content = as_read(file_json(replace(branch, tiles=())))
    found: list[CheckedCurve] = []
    if reason := refusal(lambda: found.append(curve_of(content))):
        raise NotCovered(reason)
    return content, found[0]


def checked_tile(curve: CheckedCurve, tile: BranchTile) -> CheckedTile:
    """Return a tile that is stated as the checker knows it."""
    return CheckedTile(curve, as_read(encode(tile)))
