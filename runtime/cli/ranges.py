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
    """Whether some parameter is a range.

    Parameters
    ----------
    parameters : sequence of str or None
        ``NAME=VALUE`` and ``NAME=A:B``.

    Returns
    -------
    bool
        False for none.
    """
    return any(":" in text for text in parameters or ())


def box_and_values(
    parameters: Sequence[str],
) -> tuple[dict[str, Range], dict[str, Value]]:
    """Ranges and values by name, each given once.

    Parameters
    ----------
    parameters : sequence of str
        ``NAME=VALUE`` and ``NAME=A:B``.

    Returns
    -------
    tuple of (dict, dict)
        Two Values by name for each range, one for each other parameter.

    Raises
    ------
    InputError
        If a name is given twice, or a text is no range and no assignment.
    """
    box = dict(map(_range, (text for text in parameters if ":" in text)))
    if len(box) < sum(":" in text for text in parameters):
        raise InputError("a parameter of the box is given twice")
    fixed = assignments("parameter", [text for text in parameters if ":" not in text])
    for repeated in fixed.keys() & box.keys():
        raise InputError(f"parameter {repeated} is given twice")
    return box, fixed


def _range(text: str) -> tuple[str, Range]:
    """A range NAME=A:B of a parameter."""
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
    """The orbit in the middle of the box, or elsewhere in it if there is none.

    Parameters
    ----------
    name : str
        ``SYSTEM/ORBIT`` or ``FILE.py:ORBIT``.
    fixed : dict of str to Value
        Parameters that are no ranges.
    box : dict of str to (Value, Value)
        Lower and upper end of the ranges.
    near : dict of str to float or None
        A guess of the unknowns, in the system's units.

    Returns
    -------
    Orbit
        Converged.

    Raises
    ------
    NoConvergence
        If no orbit is found at any point that is tried.
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
    """The branch of an orbit over the one range that is given, and the range's ends.

    Parameters
    ----------
    name : str
        ``SYSTEM/ORBIT`` or ``FILE.py:ORBIT``.
    parameters : sequence of str
        ``NAME=VALUE`` and ``NAME=A:B``.
    near : dict of str to float or None
        A guess of the unknowns, in the system's units.
    example : str
        An option, and a range as it takes one.

    Returns
    -------
    tuple of (Branch, (Value, Value))

    Raises
    ------
    InputError
        If there is not exactly one range.
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
