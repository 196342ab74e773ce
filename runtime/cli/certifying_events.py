"""Enclosing the events of a branch, from the command line."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from nonsmooth.runtime.cli.application import ANSWERED, UNANSWERED
from nonsmooth.runtime.cli.certifying_boxes import box_and_values, solved_in
from nonsmooth.runtime.cli.keeping import kept_of, worked
from nonsmooth.runtime.cli.written import Written

__all__ = ["certify_events"]


def certify_events(
    name: str,
    parameters: Sequence[str],
    near: Mapping[str, float] | None,
    bits: int,
    resume: Path | None,
    save: Path | None,
    *,
    as_json: bool,
) -> tuple[dict[str, str], int]:
    """Follow the orbit over a range, enclose what happens and keep it.

    Gives what is claimed, and the exit code.

    Parameters
    ----------
    name : str
        ``SYSTEM/ORBIT`` or ``FILE.py:ORBIT``.
    parameters : sequence of str
        ``NAME=VALUE`` and ``NAME=A:B``.
    near : dict of str to float or None
        A guess of the unknowns, in the system's units.
    bits : int
        Precision of the enclosures.
    resume : Path or None
        The file to go on from.
    save : Path or None
        The file to keep the answer in.
    as_json : bool
        Whether the answer is JSON.

    Returns
    -------
    tuple of (dict, int)
        Verdict on "events", and the exit code.

    Raises
    ------
    InputError
        If there is not exactly one range.
    """
    from nonsmooth.runtime.cli.display import counted, steps
    from nonsmooth.runtime.cli.display_certificates import show_events
    from nonsmooth.runtime.core.errors import InputError
    from nonsmooth.runtime.explore.continuation.continue_orbit import continue_orbit
    from nonsmooth.runtime.model.naming import shown_name
    from nonsmooth.runtime.present.files.event_certificates import (
        load_event_certificates,
        save_events,
    )
    from nonsmooth.runtime.proof.events.certify_event import certify_events as enclose
    from nonsmooth.runtime.proof.events.event_certificate import events_claim

    known = () if resume is None else load_event_certificates(resume)
    box, fixed = box_and_values(parameters)
    if len(box) != 1:
        raise InputError("--events takes one range, as in V=0.6:1.3")
    ((parameter, (lower, upper)),) = box.items()
    with steps(f"solving {name}") as begin:
        orbit = solved_in(name, fixed, box, near)
        begin(f"following {name}")
        branch = continue_orbit(orbit, parameter, (float(lower), float(upper)))
    with counted("enclosing events", len(branch.events)) as progress:
        found, stopped = worked(lambda: enclose(branch, bits, known, progress))
    written = Written()
    written.save(lambda path: save_events(found, path), save)

    def told() -> dict[str, Any]:
        return {
            "orbit": branch.name,
            "parameter": parameter,
            "interval": [str(lower), str(upper)],
            "ends": list(branch.ends),
            "events": [certificate.to_json() for certificate in found],
        }

    def show() -> None:
        values = branch.parameter_values
        span = f"{parameter} = {values.min():.6g} ... {values.max():.6g}"
        show_events(f"{shown_name(branch.name)}, {span}", found)

    code = written.show_one(told, show, save, as_json=as_json)
    claims = events_claim(found)
    if not stopped:
        decided = "undecided" not in claims.values()
        return claims, code or (ANSWERED if decided else UNANSWERED)
    done = f"{len(found)} of {len(branch.events)} events are done"
    return claims, kept_of(done, written.kept(save))
