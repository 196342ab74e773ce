"""The commands that certify over ranges of parameters: boxes, branches, events, doublings."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, Annotated, Any

from nonsmooth.runtime.cli.command import command
from nonsmooth.runtime.cli.keeping import worked
from nonsmooth.runtime.cli.options import (
    Beyond,
    Guess,
    OrbitName,
    RequireProof,
    Save,
    Tiles,
    Yes,
    option,
    parameters_as,
)
from nonsmooth.runtime.cli.parsing import Range, ends, guessed, values_and_ranges
from nonsmooth.runtime.cli.proofs.certifying import EnclosedDigits, bits_of, certifying
from nonsmooth.runtime.cli.reply import Reply
from nonsmooth.runtime.cli.resuming import hold
from nonsmooth.runtime.core.errors import InputError, NoConvergence, check_integer
from nonsmooth.runtime.core.values import Value, as_value
from nonsmooth.runtime.core.workload import SECONDS, check_hours

if TYPE_CHECKING:
    from nonsmooth.runtime.explore.continuation.branch import Branch
    from nonsmooth.runtime.orbits.orbit import Orbit

_ENOUGH = Fraction(99, 100)  # share of a box that has to be decided for an answer

OneRange = Annotated[
    list[str] | None,
    parameters_as(
        "NAME=VALUE|A:B",
        "One parameter as a range, V=0.6:1.3; others in NAME=VALUE form, or by default"
        " (docs/parameters.md).",
    ),
]
Seconds = Annotated[
    float | None,
    option("--seconds", "After so long nothing more is begun; --resume goes on.", "S"),
]


@command(
    "box",
    "certify box dry-friction/global-stick V=0.9:1.1 eta=0.9:1.1 --save map.json --plot map.png",
    group=certifying,
    save=Save,
    plot=True,
    long=True,
    question="orbit parameters guess",
    anew="tiles",
    kept="box certificate",
)
def certify_box(
    orbit: OrbitName,
    parameters: Annotated[
        list[str] | None,
        parameters_as(
            "NAME=VALUE|A:B",
            "Parameters as ranges, V=0.99:1.01 eta=0.9:1, span the box; others in NAME=VALUE"
            " form, or by default (docs/parameters.md).",
        ),
    ] = None,
    guess: Guess = None,
    tiles: Tiles = 4000,
    require: RequireProof = None,
    yes: Yes = False,
    *,
    reply: Reply,
) -> int:
    """Prove all that `certify orbit` proves, at each point of a box of parameters.

    Of two parameters regions, curves of events between them, and what is left open are told.

    The exit code is 1 while more than 1 % of the box is undecided.
    """
    from nonsmooth.runtime.cli.display import shared, steps
    from nonsmooth.runtime.proof.boxes.certify_box import certify_box as prove

    check_hours(f"{tiles} tiles", tiles * SECONDS["tile"], yes=yes)
    known = reply.known
    fixed, box = values_and_ranges(parameters)
    if not box:
        raise InputError("no parameter has a range, such as V=0.99:1.01")
    with steps(f"solving {orbit}"):
        middle = _solved_in(orbit, fixed, box, guessed(guess))
    with shared(f"proving {orbit}") as progress:
        found, stopped = worked(
            lambda: prove(
                middle, box, tiles=tiles, resume=known, progress=progress, keep=reply.keep
            )
        )
    return reply.give(
        found,
        stopped,
        enough=found.decided >= _ENOUGH,
        done=f"{len(found.tiles)} tiles, {float(100 * found.decided):.3g} % of the box decided",
        require=require,
    )


@command(
    "branch",
    "certify branch dry-friction/symmetric V=0.6:1.3 --save branch.json --plot branch.png",
    group=certifying,
    save=Save,
    plot=True,
    long=True,
    question="orbit parameters guess",
    anew="tiles beyond",
    kept="certified branch",
)
def certify_branch(
    orbit: OrbitName,
    parameters: OneRange = None,
    guess: Guess = None,
    tiles: Tiles = 2000,
    seconds: Seconds = None,
    beyond: Beyond = False,
    require: RequireProof = None,
    yes: Yes = False,
    *,
    reply: Reply,
) -> int:
    """Prove all of a branch over one parameter: these intervals and events, and no other.

    With --beyond also which itineraries begin at its borders, on which side, stable or not.
    """
    from nonsmooth.runtime.proof.branch.certify_branch import certify_branch as prove

    found, stopped = _along(
        prove, orbit, parameters, guess, tiles, seconds, yes, reply, beyond=beyond
    )
    return reply.give(
        found,
        stopped,
        enough=found.complete,
        done=f"{len(found.tiles)} tiles, {len(found.events)} events are proved",
        require=require,
    )


@command(
    "doubling",
    "certify doubling dry-friction/symmetric V=1:1.2 --save doubling.json --plot doubling.png",
    group=certifying,
    save=Save,
    plot=True,
    long=True,
    question="orbit parameters guess",
    anew="tiles",
    kept="certified doubling",
)
def certify_doubling(
    orbit: OrbitName,
    parameters: OneRange = None,
    guess: Guess = None,
    tiles: Tiles = 2000,
    seconds: Seconds = None,
    require: RequireProof = None,
    yes: Yes = False,
    *,
    reply: Reply,
) -> int:
    """Prove the orbits of twice the period beside the first flip of a branch.

    Their side and stability are told, and how they go on.
    """
    from nonsmooth.runtime.proof.branch.certify_doubling import certify_doubling as prove

    found, stopped = _along(prove, orbit, parameters, guess, tiles, seconds, yes, reply)
    branch_tiles = 0 if found.doubled is None else len(found.doubled.branch.tiles)
    return reply.give(
        found,
        stopped,
        enough=found.claims["doubling"] == "proved",
        done=f"{branch_tiles} tiles of the doubled branch are proved",
        require=require,
    )


@command(
    "event",
    "certify event dry-friction/symmetric V=0.6:1.3 --digits 50 --save events.json",
    group=certifying,
    save=Save,
    long=True,
    question="orbit parameters guess digits",
    kept="event certificate",
)
def certify_event(
    orbit: OrbitName,
    parameters: OneRange = None,
    guess: Guess = None,
    digits: EnclosedDigits = 36,
    require: RequireProof = None,
    *,
    reply: Reply,
) -> int:
    """Enclose what happens on a branch over one parameter: bifurcations and collisions."""
    from nonsmooth.runtime.cli.display import counted
    from nonsmooth.runtime.present.files.kept import save_result
    from nonsmooth.runtime.proof.branch.certified_branch import events_claim
    from nonsmooth.runtime.proof.branch.certify_event import certify_events as enclose

    known = reply.known.events if reply.resume else ()
    branch, (lower, upper) = _followed(orbit, parameters, guess)
    with counted("enclosing events", len(branch.events)) as progress:
        found, stopped = worked(lambda: enclose(branch, bits_of(digits), known, progress))
    if not found:
        hold(branch.orbit)
    claims = events_claim(found)
    return reply.give(
        found,
        stopped,
        told=lambda: {
            "orbit": branch.name,
            "parameter": branch.parameter,
            "interval": [str(lower), str(upper)],
            "ends": list(branch.ends),
            "events": [certificate.to_json() for certificate in found],
        },
        save=lambda path: save_result(found, path),
        enough="undecided" not in claims.values(),
        done=f"{len(found)} of {len(branch.events)} events are done",
        require=require,
        claims=claims,
    )


def _along(
    prove: Callable[..., Any],
    orbit: str,
    parameters: list[str] | None,
    guess: list[str] | None,
    tiles: int,
    seconds: float | None,
    yes: bool,
    reply: Reply,
    **options: Any,
) -> tuple[Any, bool]:
    """What is proved along a branch, and whether Ctrl-C ended it early."""
    from nonsmooth.runtime.cli.display import shared

    check_integer("tiles", tiles, 1)
    check_hours(f"{tiles} tiles", tiles * SECONDS["tile"], yes=yes)
    known = reply.known
    branch, interval = _followed(orbit, parameters, guess)
    with shared(f"proving {orbit}") as progress:
        return worked(
            lambda: prove(
                branch,
                interval=interval,
                tiles=tiles,
                seconds=math.inf if seconds is None else seconds,
                resume=known,
                progress=progress,
                keep=reply.keep,
                **options,
            )
        )


def _followed(
    name: str, parameters: list[str] | None, guess: list[str] | None
) -> tuple[Branch, Range]:
    """The branch of an orbit over the one range among the parameters, and the range's ends."""
    from nonsmooth.runtime.cli.display import counted, steps
    from nonsmooth.runtime.explore.continuation.continue_orbit import continue_orbit

    fixed, box = values_and_ranges(parameters)
    if len(box) != 1:
        raise InputError(f"one parameter has to be a range, as in V=0.6:1.3, not {len(box)}")
    ((parameter, (low, high)),) = ends(box).items()
    with steps(f"solving {name}"):
        orbit = _solved_in(name, fixed, box, guessed(guess))
    with counted(f"following {name}: points") as progress:
        branch = continue_orbit(orbit, parameter, (low, high), progress=progress)
    return branch, box[parameter]


def _solved_in(
    name: str,
    fixed: Mapping[str, Value],
    box: Mapping[str, Range],
    near: Mapping[str, float] | None,
) -> Orbit:
    """The orbit at the middle of a box of parameters, or at another of its points.

    A quarter and three quarters along all ranges are tried if there is no orbit at the
    middle; NoConvergence says that all fail. `fixed` are the other parameters, `near` is a
    guess of the unknowns, in the system's units.
    """
    from nonsmooth.runtime.orbits.solve import solve

    problem: NoConvergence | None = None
    for point in _points(box):
        try:
            return solve(name, {**fixed, **point}, near)
        except NoConvergence as found:
            problem = problem or found
    assert problem is not None
    raise problem


def _points(box: Mapping[str, Range]) -> Iterator[dict[str, Value]]:
    for share in (Fraction(1, 2), Fraction(1, 4), Fraction(3, 4)):
        point = {}
        for name, (lower, upper) in box.items():
            if lower.exact is None or upper.exact is None:
                raise InputError(f"the ends of {name} have to be rational numbers")
            point[name] = as_value(lower.exact + share * (upper.exact - lower.exact))
        yield point
