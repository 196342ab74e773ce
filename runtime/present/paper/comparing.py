"""The paper's printed digits beside ours, and the verdict on the difference."""

from __future__ import annotations

from decimal import Decimal
from typing import Any

from nonsmooth.runtime.core.values import decimal_string
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.present.paper.records import Comparison

__all__ = ["AGREES", "DIGITS", "compared", "digits_of"]

DIGITS = 30
AGREES = "agrees within the printed digits"


def compared(
    orbit: Orbit, where: str, printed: dict[str, str], labels: dict[str, str]
) -> tuple[Comparison, ...]:
    """Comparisons of the printed numbers of one orbit with ours, one for each.

    The orbit is refined to more than `DIGITS` digits. `printed` has the printed digits and
    `labels` the LaTeX, by the names of unknowns; `where` is the place in the paper.
    """
    return tuple(
        _compared(labels[name], where, text, orbit.unknowns[name]) for name, text in printed.items()
    )


def digits_of(number: Any) -> str:
    """Decimal text of a number to 30 decimals, or to 30 digits if it is larger than one."""
    return decimal_string(number, DIGITS)


def _compared(quantity: str, where: str, printed: str, number: Any) -> Comparison:
    ours = digits_of(number)
    difference = Decimal(ours) - Decimal(printed)
    # what is printed without decimals is meant exactly
    places = len(printed.partition(".")[2])
    verdict = AGREES
    if not places or abs(difference) > Decimal(1).scaleb(-places) / 2:
        relative = abs(difference / Decimal(ours))
        verdict = f"agrees within {_rounded_up(100 * relative)} %"
    return Comparison(quantity, where, printed, ours, f"{difference:.2e}", verdict)


def _rounded_up(number: Decimal) -> str:
    """The next larger number that has one digit."""
    step = Decimal(1).scaleb(number.adjusted())
    text = f"{(number / step).to_integral_value('ROUND_CEILING') * step:f}"
    return text.rstrip("0").rstrip(".") if "." in text else text
