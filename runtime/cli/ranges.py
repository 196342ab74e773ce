"""Ranges of parameters: what is written of them, and the orbit or the branch that is in them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from nonsmooth.runtime.cli.application import assignments
from nonsmooth.runtime.core.errors import InputError, NoConvergence
from nonsmooth.runtime.core.values import Value, as_value, parse

if TYPE_CHECKING:
    from nonsmooth.runtime.explore.continuation.branch import Branch
    from nonsmooth.runtime.orbits.orbit import Orbit

__all__ = ["Range", "box_and_values", "followed_over", "is_box", "solved_in"]

Range = tuple[Value, Value]


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
