"""Certifying what is beyond flips, from the command line."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from nonsmooth.runtime.cli.application import ANSWERED, UNANSWERED, check_drawing
from nonsmooth.runtime.cli.certifying_boxes import box_and_values, solved_in
from nonsmooth.runtime.cli.keeping import check_new, kept_of, worked
from nonsmooth.runtime.cli.written import Written

__all__ = ["certify_flips"]


def certify_flips(
    name: str,
    parameters: Sequence[str],
    near: Mapping[str, float] | None,
    doublings: int,
    tiles: int,
    seconds: float | None,
    resume: Path | None,
    save: Path | None,
    plot: Path | None,
    *,
    overwrite: bool,
    as_json: bool,
) -> tuple[dict[str, str], int]:
    """Follow the orbit over a range, go beyond its first flip, show it and keep it.

    Gives what is claimed, and the exit code.

    Parameters
    ----------
    name : str
        ``SYSTEM/ORBIT`` or ``FILE.py:ORBIT``.
    parameters : sequence of str
        ``NAME=VALUE`` and ``NAME=A:B``.
    near : dict of str to float or None
        A guess of the unknowns, in the system's units.
    doublings : int
        How many flips are gone beyond.
    tiles : int
        The most tiles of each doubled branch.
    seconds : float or None
        The time after which nothing more is begun.
    resume : Path or None
        The file to go on from.
    save : Path or None
        The file to keep the answer in.
    plot : Path or None
        The picture's file.
    overwrite : bool
        Whether a file that is there may be replaced.
    as_json : bool
        Whether the answer is JSON.

    Returns
    -------
    tuple of (dict, int)
        Verdict on "doublings", and the exit code.

    Raises
    ------
    InputError
        If there is not exactly one range.
    """
    from nonsmooth.runtime.cli.display import shared, steps
    from nonsmooth.runtime.cli.display_certificates import show_cascade
    from nonsmooth.runtime.core.errors import InputError
    from nonsmooth.runtime.explore.continuation.continue_orbit import continue_orbit
    from nonsmooth.runtime.present.files.certified_cascades import load_certified_cascade
    from nonsmooth.runtime.proof.doubling.certified_cascade import told_cascade_json
    from nonsmooth.runtime.proof.doubling.certify_cascade import certify_cascade

    check_drawing(plot)
    save = resume if save is None else save
    check_new(save, overwrite, resume, resumes=True)
    known = None if resume is None else load_certified_cascade(resume)
    box, fixed = box_and_values(parameters)
    if len(box) != 1:
        raise InputError("--doublings takes one range, as in V=1:1.2")
    ((parameter, interval),) = box.items()
    with steps(f"solving {name}") as begin:
        orbit = solved_in(name, fixed, box, near)
        begin(f"following {name}")
        lower, upper = (float(end) for end in interval)
        branch = continue_orbit(orbit, parameter, (lower, upper))
    with shared(f"proving {name}", f"of {doublings} doublings") as progress:
        found, stopped = worked(
            lambda: certify_cascade(
                branch,
                doublings=doublings,
                interval=interval,
                tiles=tiles,
                seconds=math.inf if seconds is None else seconds,
                resume=known,
                progress=progress,
                keep=None if save is None else lambda state: Written().save(state.save, save),
            )
        )
    written = Written()
    written.save(found.save, save)
    if plot is not None:
        from nonsmooth.runtime.present.pictures.certified_cascades import certified_cascade_figure

        written.draw(lambda: certified_cascade_figure(found), plot)

    def told() -> dict[str, Any]:
        return {**found.to_json(), **told_cascade_json(found)}

    code = written.show(told, lambda: show_cascade(found), as_json=as_json)
    if not stopped:
        whole = found.claims["doublings"] == "proved"
        return found.claims, code or (ANSWERED if whole else UNANSWERED)
    return found.claims, kept_of(f"{len(found.doublings)} doublings are proved", written.kept(save))
