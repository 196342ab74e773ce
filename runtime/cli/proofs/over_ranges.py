"""Proofs over ranges of parameters: what is written of them, then boxes, branches, events."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.cli.application import ANSWERED, UNANSWERED, assignments
from nonsmooth.runtime.cli.keeping import kept_of, worked
from nonsmooth.runtime.cli.proofs.long_proofs import LongProof
from nonsmooth.runtime.cli.resuming import hold
from nonsmooth.runtime.cli.written import Written
from nonsmooth.runtime.core.errors import InputError, NoConvergence
from nonsmooth.runtime.core.values import Value, as_value, parse

if TYPE_CHECKING:
    from nonsmooth.runtime.explore.continuation.branch import Branch
    from nonsmooth.runtime.orbits.orbit import Orbit

__all__ = [
    "Range",
    "box_and_values",
    "certify_events",
    "certify_flip",
    "certify_over",
    "certify_whole_branch",
    "followed_over",
    "is_box",
    "solved_in",
]

Range = tuple[Value, Value]
_ENOUGH = Fraction(99, 100)  # share of a box that has to be decided for an answer


def is_box(parameters: Sequence[str] | None) -> bool:
    """Whether some parameter is a range ``NAME=A:B``; False for None."""
    return any(":" in text for text in parameters or ())


def box_and_values(
    parameters: Sequence[str],
) -> tuple[dict[str, Range], dict[str, Value]]:
    """Ranges (lower, upper) by name and values by name, from ``NAME=A:B`` and ``NAME=VALUE``.

    InputError refuses a name that is given twice, and a text that is neither.
    """
    box = dict(map(_range, (text for text in parameters if ":" in text)))
    if len(box) < sum(":" in text for text in parameters):
        raise InputError("a parameter of the box is given twice")
    fixed = assignments("parameter", [text for text in parameters if ":" not in text])
    for repeated in fixed.keys() & box.keys():
        raise InputError(f"parameter {repeated} is given twice")
    return box, fixed


def _range(text: str) -> tuple[str, Range]:
    """Name and range (lower, upper) of a parameter, parsed from ``NAME=A:B``."""
    name, _, bounds = text.partition("=")
    ends = bounds.split(":")
    if not name.strip() or len(ends) != 2:
        raise InputError(f"{text}: a parameter of a box is written NAME=A:B")
    return name.strip(), (parse(ends[0]), parse(ends[1]))


def solved_in(
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


def followed_over(
    name: str, parameters: Sequence[str], near: Mapping[str, float] | None, example: str
) -> tuple[Branch, Range]:
    """The branch of an orbit over the one range among the parameters, and the range's ends.

    `near` is a guess of the unknowns, in the system's units. InputError refuses anything
    but exactly one range; its message contains `example`, an option and its argument.
    """
    from nonsmooth.runtime.cli.display import counted, steps
    from nonsmooth.runtime.explore.continuation.continue_orbit import continue_orbit

    box, fixed = box_and_values(parameters)
    if len(box) != 1:
        option, written = example.split()
        raise InputError(f"{option} takes one range, as in {written}")
    ((parameter, interval),) = box.items()
    with steps(f"solving {name}"):
        orbit = solved_in(name, fixed, box, near)
    ends = float(interval[0]), float(interval[1])
    with counted(f"following {name}: points") as progress:
        return continue_orbit(orbit, parameter, ends, progress=progress), interval


def certify_over(proof: LongProof, tiles: int) -> tuple[Mapping[str, str], int]:
    """Prove, keep and show the map of a box of parameters; its claims and the exit code.

    At most `tiles` tiles are tried. The answer counts as complete once 99 % of the box is
    decided.
    """
    from nonsmooth.runtime.cli.display import shared, steps
    from nonsmooth.runtime.cli.tables import show_result
    from nonsmooth.runtime.present.files.kept import format_named
    from nonsmooth.runtime.proof.boxes.certify_box import certify_box

    known = proof.known(format_named("nonsmooth box certificate").load)
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
    return proof.answer(found, stopped, show_result, enough=found.decided >= _ENOUGH, done=done)


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
    from nonsmooth.runtime.cli.tables import show_result
    from nonsmooth.runtime.present.files.kept import format_named
    from nonsmooth.runtime.proof.branch.certify_branch import certify_branch

    known = proof.known(format_named("nonsmooth certified branch").load)
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
    return proof.answer(found, stopped, show_result, enough=found.complete, done=done)


def certify_flip(
    proof: LongProof, tiles: int, seconds: float | None
) -> tuple[Mapping[str, str], int]:
    """Prove, keep and show the doubled orbits beyond the first flip of an orbit's branch.

    It gives the verdict on "doubling" and the exit code. `tiles` bounds the tiles of the
    doubled branch, and after so many seconds nothing more is begun (None for no limit).
    InputError refuses anything but exactly one range.
    """
    from nonsmooth.runtime.cli.display import shared
    from nonsmooth.runtime.cli.tables import show_result
    from nonsmooth.runtime.present.files.kept import format_named
    from nonsmooth.runtime.proof.doubling.certify_doubling import certify_doubling

    known = proof.known(format_named("nonsmooth certified doubling").load)
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
    return proof.answer(found, stopped, show_result, enough=whole, done=done)


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
    from nonsmooth.runtime.cli.tables import show_result
    from nonsmooth.runtime.present.files.kept import load_events, save_result
    from nonsmooth.runtime.proof.events.certify_event import certify_events as enclose
    from nonsmooth.runtime.proof.events.event_certificate import events_claim

    known = () if resume is None else load_events(resume)
    branch, (lower, upper) = followed_over(name, parameters, near, "--events V=0.6:1.3")
    with counted("enclosing events", len(branch.events)) as progress:
        found, stopped = worked(lambda: enclose(branch, bits, known, progress))
    if not found:
        hold(branch.orbit)
    written = Written()
    written.save(lambda path: save_result(found, path), save)

    def told() -> dict[str, Any]:
        return {
            "orbit": branch.name,
            "parameter": branch.parameter,
            "interval": [str(lower), str(upper)],
            "ends": list(branch.ends),
            "events": [certificate.to_json() for certificate in found],
        }

    code = written.show_one(told, lambda: show_result(found), save, as_json=as_json)
    claims = events_claim(found)
    if not stopped:
        decided = "undecided" not in claims.values()
        return claims, code or (ANSWERED if decided else UNANSWERED)
    done = f"{len(found)} of {len(branch.events)} events are done"
    return claims, kept_of(done, written.kept(save))
