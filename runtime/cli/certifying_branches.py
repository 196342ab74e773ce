"""Certifying a whole branch, and what is beyond its flip, from the command line."""

from __future__ import annotations

import math
from collections.abc import Mapping

from nonsmooth.runtime.cli.keeping import worked
from nonsmooth.runtime.cli.long_proofs import LongProof
from nonsmooth.runtime.cli.ranges import followed_over

__all__ = ["certify_flip", "certify_whole_branch"]


def certify_whole_branch(
    proof: LongProof, tiles: int, seconds: float | None, *, beyond: bool
) -> tuple[Mapping[str, str], int]:
    """Prove, keep and show the branch of an orbit over one range.

    It gives the verdict on "branch" and the exit code. At most `tiles` tiles are proved,
    and after so many seconds nothing more is begun (None for no limit). With `beyond` the
    itineraries that begin where the branch meets a border are proved too. InputError
    refuses anything but exactly one range.
    """
    from nonsmooth.runtime.cli.display import shared
    from nonsmooth.runtime.cli.display_certificates import show_branch
    from nonsmooth.runtime.present.files.certified_branches import load_certified_branch
    from nonsmooth.runtime.proof.branch.certified_branch import told_json
    from nonsmooth.runtime.proof.branch.certify_branch import certify_branch

    known = proof.known(load_certified_branch)
    branch, interval = followed_over(proof.name, proof.parameters, proof.near, "--branch V=0.6:1.3")
    with shared(f"proving {proof.name}") as progress:
        found, stopped = worked(
            lambda: certify_branch(
                branch,
                interval=interval,
                tiles=tiles,
                beyond=beyond,
                seconds=math.inf if seconds is None else seconds,
                resume=known,
                progress=progress,
                keep=proof.keep,
            )
        )
    done = f"{len(found.tiles)} tiles, {len(found.events)} events are proved"
    return proof.answer(found, stopped, told_json, show_branch, enough=found.complete, done=done)


def certify_flip(
    proof: LongProof, tiles: int, seconds: float | None
) -> tuple[Mapping[str, str], int]:
    """Prove, keep and show the doubled orbits beyond the first flip of an orbit's branch.

    It gives the verdict on "doubling" and the exit code. `tiles` bounds the tiles of the
    doubled branch, and after so many seconds nothing more is begun (None for no limit).
    InputError refuses anything but exactly one range.
    """
    from nonsmooth.runtime.cli.display import shared
    from nonsmooth.runtime.cli.display_certificates import show_doubling
    from nonsmooth.runtime.present.files.certified_doublings import load_certified_doubling
    from nonsmooth.runtime.proof.doubling.certified_doubling import told_doubling_json
    from nonsmooth.runtime.proof.doubling.certify_doubling import certify_doubling

    known = proof.known(load_certified_doubling)
    example = "--doubling V=1:1.2"
    branch, interval = followed_over(proof.name, proof.parameters, proof.near, example)
    with shared(f"proving {proof.name}") as progress:
        found, stopped = worked(
            lambda: certify_doubling(
                branch,
                interval=interval,
                tiles=tiles,
                seconds=math.inf if seconds is None else seconds,
                resume=known,
                progress=progress,
                keep=proof.keep,
            )
        )
    branch_tiles = 0 if found.doubled is None else len(found.doubled.branch.tiles)
    done = f"{branch_tiles} tiles of the doubled branch are proved"
    whole = found.claims["doubling"] == "proved"
    return proof.answer(found, stopped, told_doubling_json, show_doubling, enough=whole, done=done)
