"""Functions of the state that vanish along an orbit because it closes.

Phases and resets map the values u of such functions linearly into each other: over one period
u = Q u. Where 1 is no eigenvalue of Q they are zero.
"""

from typing import Any

from flint import arb_mat

from nonsmooth.runtime.checker.orbits.orbit import CheckedOrbit
from nonsmooth.runtime.checker.stated.exact import demand, exact, product, reduced
from nonsmooth.runtime.core.rational_functions import pivot


def vanishing(orbit: CheckedOrbit) -> list[Any]:
    """Return the rows that the file states to be zero where the orbit begins, and prove them.

    The rows are exact, (N + 1); there are none if the file states none. `Failure` is
    raised if they need not vanish.
    """
    declared = orbit.declared
    if "vanishing" not in declared.closing:
        return []
    first = [tuple(map(exact, row)) for row in declared.closing["vanishing"]]
    fits = declared.rational and all(len(row) == declared.size + 1 for row in first)
    demand(fits and first, "no functions that vanish")
    demand(declared.exactly.echelon(first) == first, "functions that vanish are not reduced")
    facts, count = first, len(first)
    u = arb_mat([[int(i == j) for j in range(count)] for i in range(count)])
    for step, time in zip(declared.steps, orbit.dwell, strict=True):
        kept = declared.exactly.lasting(facts, step.field)
        rates = [_factors(product(row, step.field), kept) for row in kept]
        u = _times(orbit, [_factors(row, facts) for row in kept], u, count)
        if kept:
            u = (orbit.numbers(rates) * time).exp() * u
        end = declared.exactly.echelon([*kept, step.exit])
        facts = declared.exactly.echelon(
            declared.exactly.left_kernel([reduced(row, end) for row in step.reset])
        )
        behind = [_less_exit(orbit, product(row, step.reset), step.exit, kept) for row in facts]
        u = _times(orbit, [_factors(row, kept) for row in behind], u, count)
    lasts = not any(any(reduced(row, facts)) for row in first)
    demand(lasts, "functions that vanish depend on others")
    u = _times(orbit, [_factors(row, facts) for row in first], u, count)
    unit = arb_mat([[int(i == j) for j in range(count)] for i in range(count)])
    missed = (unit - u).det()
    demand(missed > 0 or missed < 0, "functions need not vanish")
    return first


def _factors(row: Any, facts: list[Any]) -> list[Any]:
    """Return the coefficients of a row as a combination of reduced rows."""
    return [row[pivot(fact)] for fact in facts]


def _less_exit(orbit: CheckedOrbit, row: Any, leaves: Any, kept: list[Any]) -> Any:
    """Return a row without its share of the exit row, which is zero where the phase ends."""
    rest, zero = reduced(row, kept), reduced(leaves, kept)
    place = pivot(zero)
    if place is None:
        return row
    orbit.declared.exactly.divisors.append(zero[place])
    share = rest[place] / zero[place]
    return tuple(x - share * y for x, y in zip(row, leaves, strict=True))


def _times(orbit: CheckedOrbit, factors: list[list[Any]], u: Any, count: int) -> Any:
    """Return combinations of the functions' values, as a matrix over their values at the start."""
    if not factors or not factors[0]:
        return arb_mat([[0] * count for _ in factors])
    return orbit.numbers(factors) * u
