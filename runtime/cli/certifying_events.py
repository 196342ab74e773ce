"""Enclosing the events of a branch, from the command line."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from nonsmooth.runtime.cli.application import ANSWERED, UNANSWERED
from nonsmooth.runtime.cli.keeping import kept_of, worked
from nonsmooth.runtime.cli.ranges import followed_over
from nonsmooth.runtime.cli.resuming import hold
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
    """Enclose, keep and show the events of an orbit's branch over one range.

    It gives the verdict on "events" and the exit code. Parameters are texts ``NAME=VALUE``
    and one ``NAME=A:B``, which InputError demands; `near` is a guess of the unknowns in the
    system's units, `bits` the precision of the enclosures, and `resume` a file whose events
    are taken over.
    """
    from nonsmooth.runtime.cli.display import counted
    from nonsmooth.runtime.cli.display_certificates import show_events
    from nonsmooth.runtime.model.naming import shown_name
    from nonsmooth.runtime.present.files.event_certificates import (
        load_event_certificates,
        save_events,
    )
    from nonsmooth.runtime.proof.events.certify_event import certify_events as enclose
    from nonsmooth.runtime.proof.events.event_certificate import events_claim

    known = () if resume is None else load_event_certificates(resume)
    branch, (lower, upper) = followed_over(name, parameters, near, "--events V=0.6:1.3")
    with counted("enclosing events", len(branch.events)) as progress:
        found, stopped = worked(lambda: enclose(branch, bits, known, progress))
    if not found:
        hold(branch.orbit)
    written = Written()
    written.save(lambda path: save_events(found, path), save)

    def told() -> dict[str, Any]:
        return {
            "orbit": branch.name,
            "parameter": branch.parameter,
            "interval": [str(lower), str(upper)],
            "ends": list(branch.ends),
            "events": [certificate.to_json() for certificate in found],
        }

    def show() -> None:
        values = branch.parameter_values
        span = f"{branch.parameter} = {values.min():.6g} ... {values.max():.6g}"
        show_events(f"{shown_name(branch.name)}, {span}", found)

    code = written.show_one(told, show, save, as_json=as_json)
    claims = events_claim(found)
    if not stopped:
        decided = "undecided" not in claims.values()
        return claims, code or (ANSWERED if decided else UNANSWERED)
    done = f"{len(found)} of {len(branch.events)} events are done"
    return claims, kept_of(done, written.kept(save))
