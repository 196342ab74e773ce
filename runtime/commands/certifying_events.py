"""Enclosing the events of a branch, from the command line."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from nonsmooth.runtime.commands.application import print_json
from nonsmooth.runtime.commands.certifying_boxes import box_and_values, solved_in

__all__ = ["certify_events"]


def certify_events(
    name: str,
    parameters: Sequence[str],
    near: Mapping[str, float] | None,
    bits: int,
    *,
    as_json: bool,
) -> bool:
    """Follow the orbit over a range and enclose what happens; tells whether all is proved."""
    from nonsmooth.runtime.certification.events.certify import certify_event
    from nonsmooth.runtime.commands.display import counted, steps
    from nonsmooth.runtime.commands.display_certificates import show_events
    from nonsmooth.runtime.continuation.branch import continue_orbit
    from nonsmooth.runtime.errors import InputError

    box, fixed = box_and_values(parameters)
    if len(box) != 1:
        raise InputError("--events takes one range, as in V=0.6:1.3")
    ((parameter, (lower, upper)),) = box.items()
    with steps(f"solving {name}") as begin:
        orbit = solved_in(name, fixed, box, near)
        begin(f"following {name}")
        branch = continue_orbit(orbit, parameter, (float(lower), float(upper)))
    found = []
    with counted("enclosing events", len(branch.events)) as progress:
        for event in branch.events:
            found.append(certify_event(branch, event, bits))
            progress(len(found))
    if as_json:
        print_json(
            {
                "orbit": branch.name,
                "parameter": parameter,
                "interval": [str(lower), str(upper)],
                "ends": list(branch.ends),
                "events": [certificate.to_json() for certificate in found],
            }
        )
    else:
        show_events(branch, found)
    return all(certificate.proved for certificate in found)
