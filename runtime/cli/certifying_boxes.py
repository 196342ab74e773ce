"""Certifying an orbit for all parameters of a box, from the command line."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.cli.application import (
    ANSWERED,
    UNANSWERED,
    assignments,
    check_drawing,
)
from nonsmooth.runtime.cli.keeping import check_new, kept_of, worked
from nonsmooth.runtime.cli.written import Written
from nonsmooth.runtime.core.errors import InputError, NoConvergence
from nonsmooth.runtime.core.values import Value, as_value, parse

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.orbit import Orbit
    from nonsmooth.runtime.proof.boxes.box_certificate import BoxCertificate

__all__ = ["box_and_values", "certify_over", "is_box", "solved_in"]

_ENOUGH = Fraction(99, 100)  # share of a box that has to be decided for an answer


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


def certify_over(
    name: str,
    parameters: Sequence[str],
    near: Mapping[str, float] | None,
    tiles: int,
    resume: Path | None,
    save: Path | None,
    plot: Path | None,
    *,
    overwrite: bool,
    as_json: bool,
) -> tuple[BoxCertificate, int]:
    """Prove the map, show it, and keep it; gives it, and the exit code.

    Parameters
    ----------
    name : str
        ``SYSTEM/ORBIT`` or ``FILE.py:ORBIT``.
    parameters : sequence of str
        ``NAME=VALUE`` and ``NAME=A:B``.
    near : dict of str to float or None
        A guess of the unknowns, in the system's units.
    tiles : int
        The most tiles that are tried.
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
    tuple of (BoxCertificate, int)
        The map and the exit code.
    """
    from nonsmooth.runtime.cli.display import shared, steps
    from nonsmooth.runtime.cli.display_certificates import show_box
    from nonsmooth.runtime.present.files.box_certificates import load_box_certificate
    from nonsmooth.runtime.proof.boxes.certify_box import certify_box

    check_drawing(plot)
    save = resume if save is None else save
    check_new(save, overwrite, resume, resumes=True)
    known = None if resume is None else load_box_certificate(resume)
    box, fixed = box_and_values(parameters)
    with steps(f"solving {name}"):
        orbit = solved_in(name, fixed, box, near)
    with shared(f"proving {name}") as progress:
        found, stopped = worked(
            lambda: certify_box(
                orbit,
                box,
                tiles=tiles,
                resume=known,
                progress=progress,
                keep=None if save is None else lambda state: Written().save(state.save, save),
            )
        )
    written = Written()
    written.save(found.save, save)
    if plot is not None:
        from nonsmooth.runtime.present.pictures.proven_maps import box_figure

        written.draw(lambda: box_figure(found), plot)
    code = written.show(lambda: _box_json(found), lambda: show_box(found), as_json=as_json)
    if not stopped:
        return found, code or (ANSWERED if found.decided >= _ENOUGH else UNANSWERED)
    done = f"{len(found.tiles)} tiles, {float(100 * found.decided):.3g} % of the box decided"
    return found, kept_of(done, written.kept(save))


def _box_json(found: BoxCertificate) -> dict[str, Any]:
    from nonsmooth.runtime.proof.boxes.regions import map_json

    undecided = [
        {name: [str(low), str(high)] for name, (low, high) in where.items()}
        for where in found.undecided
    ]
    return {**found.to_json(), **map_json(found), "undecided": undecided}


def box_and_values(
    parameters: Sequence[str],
) -> tuple[dict[str, tuple[Value, Value]], dict[str, Value]]:
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


def _range(text: str) -> tuple[str, tuple[Value, Value]]:
    """A range NAME=A:B of a parameter."""
    name, _, bounds = text.partition("=")
    ends = bounds.split(":")
    if not name.strip() or len(ends) != 2:
        raise InputError(f"{text}: a parameter of a box is written NAME=A:B")
    return name.strip(), (parse(ends[0]), parse(ends[1]))


def solved_in(
    name: str,
    fixed: Mapping[str, Value],
    box: Mapping[str, tuple[Value, Value]],
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


def _points(box: Mapping[str, tuple[Value, Value]]) -> Iterator[dict[str, Value]]:
    for share in (Fraction(1, 2), Fraction(1, 4), Fraction(3, 4)):
        point = {}
        for name, (lower, upper) in box.items():
            if lower.exact is None or upper.exact is None:
                raise InputError(f"the ends of {name} have to be rational numbers")
            point[name] = as_value(lower.exact + share * (upper.exact - lower.exact))
        yield point
