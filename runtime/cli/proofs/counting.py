"""How many orbits an itinerary has in a box: what `certify --all` takes."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer

from nonsmooth.runtime.cli.application import (
    NOT_MET,
    UNANSWERED,
    assignments,
)
from nonsmooth.runtime.cli.keeping import kept_of, worked
from nonsmooth.runtime.cli.written import Written
from nonsmooth.runtime.core.errors import InputError

__all__ = ["Every", "count_orbits", "split_bounds"]

Every = Annotated[
    bool,
    typer.Option(
        "--all",
        help="Prove how many orbits there are with dwell times in a box: tau=0:6.3 for each"
        " among the arguments. tau=:6.3 begins at 1e-6; 0 does not belong to the box.",
    ),
]


def split_bounds(
    arguments: list[str] | None,
) -> tuple[list[str], dict[str, str | tuple[str, str]]]:
    """Arguments ``NAME=VALUE``, and bounds by name from those ``NAME=A:B`` or ``NAME=:B``.

    Bounds are a pair of texts, or the upper one alone. InputError refuses a name that is
    given twice and more than two bounds.
    """
    values: list[str] = []
    bounds: dict[str, str | tuple[str, str]] = {}
    for text in arguments or []:
        name, _, right = text.partition("=")
        if ":" not in right:
            values.append(text)
            continue
        name, parts = name.strip(), [part.strip() for part in right.split(":")]
        if len(parts) != 2 or not name or not parts[1]:
            raise InputError(f"{text!r} is not NAME=A:B, such as tau=0:12.6")
        if name in bounds:
            raise InputError(f"bounds of {name} are given twice")
        bounds[name] = (parts[0], parts[1]) if parts[0] else parts[1]
    return values, bounds


def count_orbits(
    orbit: str,
    arguments: list[str] | None,
    guess: list[str] | None,
    bits: int,
    require: object,
    save: Path | None,
    *,
    as_json: bool,
) -> int:
    """Prove how many orbits there are in a box, keep and show the census; gives the exit code.

    Arguments are parameters ``NAME=VALUE`` and bounds of dwell times ``NAME=A:B``; `guess`
    has to be empty, which InputError demands, and `require` is not None if the count has to
    be proved. InputErrors of `certify_all` pass through.
    """
    from nonsmooth.runtime.cli.display import steps
    from nonsmooth.runtime.cli.proofs.display_certificates import show_census
    from nonsmooth.runtime.proof.counting.certify_all import certify_all

    if guess:
        raise InputError("--all takes no guess: it searches the whole box")
    texts, bounds = split_bounds(arguments)
    values = assignments("parameter", texts)
    with steps() as begin:
        census, stopped = worked(lambda: certify_all(orbit, values, bounds, bits=bits, begin=begin))
    written = Written()
    written.save(census.save, save)
    code = written.show_one(census.to_json, lambda: show_census(census), save, as_json=as_json)
    if stopped:
        boxes = f"{census.looked} boxes are looked at, {census.count} orbits found"
        return kept_of(boxes, written.kept(save), resumes=False)
    if code or census.decided:
        return code
    if require is not None:
        print(
            f"nonsmooth: required: proved; found: {len(census.undecided)} boxes undecided",
            file=sys.stderr,
        )
        return NOT_MET
    return UNANSWERED
