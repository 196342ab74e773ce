"""The Appendix's equations at the orbit of the six equations, and its start beside theirs."""

from __future__ import annotations

from typing import Any

from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.present.paper.comparing import digits_of
from nonsmooth.runtime.present.paper.records import Table

__all__ = ["appendix_tables"]

_CONDITIONS = (
    "(A.1), second line, first entry",
    "(A.1), second line, second entry",
    "(12)",
    "(14)",
    r"(A.2), $\tilde M_{11} + \tilde M_{12}$",
    r"(A.2), $\tilde M_{21} + \tilde M_{22}$",
)
_LABELS = {"z10": "$z_{10}$", "z20": "$z_{20}$"}


def appendix_tables(stick: Orbit) -> tuple[Table, Table]:
    """Tables of the Appendix's conditions at an orbit, and of both its starts.

    `stick` is the orbit with global stick, refined. In the conditions the start is that of (A.3),
    from the dwell times.
    """
    turn, start, residual = stick.evaluate("period_map", "linear_start", "compatibility")
    sides = [*residual, *_row_sums([row[:-1] for row in turn], stick.arithmetic.mp)]
    starts = [
        (label, ours, stick.unknowns[name])
        for (name, label), ours in zip(_LABELS.items(), start, strict=True)
    ]
    return (
        Table(
            "The Appendix's conditions at the orbit of the six equations",
            ("Equation", "Left-hand side"),
            tuple(
                (label, f"{float(side):.0e}")
                for label, side in zip(_CONDITIONS, sides, strict=True)
            ),
        ),
        Table(
            "The start by (A.3), and by the six equations",
            ("Quantity", "By (A.3)", "By the six equations", "Difference"),
            tuple(
                (label, digits_of(ours), digits_of(theirs), f"{float(ours - theirs):.0e}")
                for label, ours, theirs in starts
            ),
        ),
    )


def _row_sums(matrix: list[list[Any]], mp: Any) -> list[Any]:
    """Sums of the rows of the matrix M of (A.2), from the blocks of N."""
    first, second, third, fourth = (
        mp.matrix([row[columns] for row in matrix[rows]])
        for rows in (slice(2), slice(2, 4))
        for columns in (slice(2), slice(2, 4))
    )
    one = mp.eye(2)
    found = (first - one) ** -1 * second - third**-1 * (fourth - one)
    return [found[i, 0] + found[i, 1] for i in range(2)]
