"""Certifying an orbit for all parameters of a box, from the command line."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.cli.keeping import worked
from nonsmooth.runtime.cli.long_proofs import LongProof
from nonsmooth.runtime.cli.ranges import box_and_values, solved_in

if TYPE_CHECKING:
    from nonsmooth.runtime.proof.boxes.box_certificate import BoxCertificate

__all__ = ["certify_over"]

_ENOUGH = Fraction(99, 100)  # share of a box that has to be decided for an answer


def certify_over(proof: LongProof, tiles: int) -> tuple[Mapping[str, str], int]:
    """Prove, keep and show the map of a box of parameters; its claims and the exit code.

    At most `tiles` tiles are tried. The answer counts as complete once 99 % of the box is
    decided.
    """
    from nonsmooth.runtime.cli.display import shared, steps
    from nonsmooth.runtime.cli.display_certificates import show_box
    from nonsmooth.runtime.present.files.box_certificates import load_box_certificate
    from nonsmooth.runtime.proof.boxes.certify_box import certify_box

    known = proof.known(load_box_certificate)
    box, fixed = box_and_values(proof.parameters)
    with steps(f"solving {proof.name}"):
        orbit = solved_in(proof.name, fixed, box, proof.near)
    with shared(f"proving {proof.name}") as progress:
        found, stopped = worked(
            lambda: certify_box(
                orbit, box, tiles=tiles, resume=known, progress=progress, keep=proof.keep
            )
        )

    done = f"{len(found.tiles)} tiles, {float(100 * found.decided):.3g} % of the box decided"
    return proof.answer(found, stopped, _told, show_box, enough=found.decided >= _ENOUGH, done=done)


def _told(found: BoxCertificate) -> dict[str, Any]:
    from nonsmooth.runtime.proof.boxes.regions import map_json

    undecided = [
        {name: [str(low), str(high)] for name, (low, high) in where.items()}
        for where in found.undecided
    ]
    return {**map_json(found), "undecided": undecided}
