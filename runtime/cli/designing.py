"""The command that designs: parameters at which an orbit is best, or has wanted values."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

from nonsmooth.runtime.cli.application import UNANSWERED
from nonsmooth.runtime.cli.command import command
from nonsmooth.runtime.cli.keeping import say, worked
from nonsmooth.runtime.cli.options import (
    OrbitName,
    Require,
    Save,
    option,
    parameters_as,
    solved_within,
)
from nonsmooth.runtime.cli.parsing import assignments, ends, ranges, values_and_ranges
from nonsmooth.runtime.cli.reply import Reply, met
from nonsmooth.runtime.core.errors import InputError

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.orbit import Orbit


@command(
    "design",
    "design dry-friction/symmetric V=0.3:3 --minimise spectral_radius",
    "design dry-friction/symmetric V=0.6:3 eta=3:5 --minimise spectral_radius"
    ' --subject "period<=4.6" --plot design.png --save design.json',
    "design dry-friction/symmetric V=0.6:1.3 --solve multiplier=-1",
    "design impact_damper.py:struck-twice r=0.3 zeta=0.05 d=7:9.5"
    " --minimise peak:x --worst-over w=0.95:1.05",
    save=Save,
    plot=True,
    long=True,
    question="orbit parameters minimise maximise solve worst_over subject",
    kept="design",
)
def design(
    orbit: OrbitName,
    parameters: Annotated[
        list[str] | None,
        parameters_as(
            "NAME=A:B|VALUE",
            "The parameters that vary, with their bounds: V=0.6:1.3; others in NAME=VALUE"
            " form. It begins at the reference point's values, or in the middle.",
        ),
    ] = None,
    minimise: Annotated[
        str | None,
        option(
            "--minimise",
            "What is made as small as it can be: spectral_radius, period, trace,"
            " determinant, an unknown, maximum:x, minimum:x, peak:x or peak_acceleration:x of a"
            " state x, dissipation, or margin.",
            "QUANTITY",
        ),
    ] = None,
    maximise: Annotated[
        str | None,
        option("--maximise", "What is made as large as it can be.", "QUANTITY"),
    ] = None,
    solve: Annotated[
        list[str] | None,
        option(
            "--solve",
            "A wanted value, such as period=6.3, or multiplier=-1, a flip; as many as"
            " parameters that vary.",
            "QUANTITY=VALUE",
        ),
    ] = None,
    worst_over: Annotated[
        str | None,
        option(
            "--worst-over",
            "The worst along a branch counts, as the peak over a resonance: another"
            " parameter, and its interval. All conditions hold all along it.",
            "NAME=A:B",
        ),
    ] = None,
    subject: Annotated[
        list[str] | None,
        option(
            "--subject",
            'A condition: "period<=6.5", "trace>=0" or "multiplier=-1"; may be repeated.',
            "CONDITION",
        ),
    ] = None,
    require: Require = None,
    *,
    reply: Reply,
) -> int:
    """Find parameters at which an orbit is best, or has wanted values: stability, period, ...."""
    from nonsmooth.runtime.cli.display import counted
    from nonsmooth.runtime.explore.design.design import design as find_design

    known = reply.known
    fixed, ranged = values_and_ranges(parameters)
    if not ranged:
        raise InputError("no parameter varies: give its bounds, such as V=0.6:1.3")
    over = ends(ranged)
    wanted = assignments("quantity", solve or []) or None
    along = ranges("parameter", [worst_over] if worst_over else [])
    begin = solved_within(orbit, fixed, {**along, **over})
    with counted("designing, iterates") as show:
        found, stopped = worked(
            lambda: find_design(
                begin,
                minimise=minimise,
                maximise=maximise,
                solve=wanted,
                over=over,
                worst_over=along or None,
                subject_to=subject or (),
                resume=known,
                progress=lambda iterates, _: show(iterates),
            )
        )
    done = f"{len(found.history)} iterates are done"
    code = reply.give(found, stopped, done=done)
    if code or found.converged:
        return code or met(_verdicts(found.orbit), require)
    say(found.message)
    return UNANSWERED


def _verdicts(orbit: Orbit) -> dict[str, object]:
    return {"stable": orbit.stability.verdict, "admissible": orbit.admissibility.verdict}
