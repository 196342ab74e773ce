"""Certifying a whole branch, from the command line."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from nonsmooth.runtime.cli.application import ANSWERED, UNANSWERED, check_drawing
from nonsmooth.runtime.cli.certifying_boxes import box_and_values, solved_in
from nonsmooth.runtime.cli.keeping import check_new, kept_of, worked
from nonsmooth.runtime.cli.written import Written

__all__ = ["certify_whole_branch"]


def certify_whole_branch(
    name: str,
    parameters: Sequence[str],
    near: Mapping[str, float] | None,
    tiles: int,
    resume: Path | None,
    save: Path | None,
    plot: Path | None,
    *,
    beyond: bool,
    overwrite: bool,
    as_json: bool,
) -> tuple[dict[str, str], int]:
    """Follow the orbit over a range, prove all of it, show it and keep it.

    Gives what is claimed, and the exit code.

    Parameters
    ----------
    name : str
        ``SYSTEM/ORBIT`` or ``FILE.py:ORBIT``.
    parameters : sequence of str
        ``NAME=VALUE`` and ``NAME=A:B``.
    near : dict of str to float or None
        A guess of the unknowns, in the system's units.
    tiles : int
        The most tiles that are proved.
    resume : Path or None
        The file to go on from.
    save : Path or None
        The file to keep the answer in.
    plot : Path or None
        The picture's file.
    beyond : bool
        Whether to prove what begins where it meets a border.
    overwrite : bool
        Whether a file that is there may be replaced.
    as_json : bool
        Whether the answer is JSON.

    Returns
    -------
    tuple of (dict, int)
        Verdict on "branch", and the exit code.

    Raises
    ------
    InputError
        If there is not exactly one range.
    """
    from nonsmooth.runtime.cli.display import shared, steps
    from nonsmooth.runtime.cli.display_certificates import show_branch
    from nonsmooth.runtime.core.errors import InputError
    from nonsmooth.runtime.explore.continuation.continue_orbit import continue_orbit
    from nonsmooth.runtime.present.files.certified_branches import load_certified_branch
    from nonsmooth.runtime.proof.branch.certified_branch import told_json
    from nonsmooth.runtime.proof.branch.certify_branch import certify_branch

    check_drawing(plot)
    save = resume if save is None else save
    check_new(save, overwrite, resume, resumes=True)
    known = None if resume is None else load_certified_branch(resume)
    box, fixed = box_and_values(parameters)
    if len(box) != 1:
        raise InputError("--branch takes one range, as in V=0.6:1.3")
    ((parameter, interval),) = box.items()
    with steps(f"solving {name}") as begin:
        orbit = solved_in(name, fixed, box, near)
        begin(f"following {name}")
        lower, upper = (float(end) for end in interval)
        branch = continue_orbit(orbit, parameter, (lower, upper))
    with shared(f"proving {name}") as progress:
        found, stopped = worked(
            lambda: certify_branch(
                branch,
                interval=interval,
                tiles=tiles,
                beyond=beyond,
                resume=known,
                progress=progress,
                keep=None if save is None else lambda state: Written().save(state.save, save),
            )
        )
    written = Written()
    written.save(found.save, save)
    if plot is not None:
        from nonsmooth.runtime.present.pictures.certified_branches import certified_branch_figure

        written.draw(lambda: certified_branch_figure(found), plot)

    def told() -> dict[str, Any]:
        return {**found.to_json(), **told_json(found)}

    code = written.show(told, lambda: show_branch(found), as_json=as_json)
    if not stopped:
        return found.claims, code or (ANSWERED if found.complete else UNANSWERED)
    done = f"{len(found.tiles)} tiles, {len(found.events)} events are proved"
    return found.claims, kept_of(done, written.kept(save))
