"""Whether the phases of an orbit show where its transitions lead.

A transition is taken where its conditions hold, the first of several for a boundary. Along an
orbit they need no test of their own where they follow from its phases: the boundary that ends a
phase is reached from below, and no boundary of the next phase is passed at its start. So a mass
that slips on after a reversal has overcome the kinetic friction; that it has overcome the static
one, if that is larger, nothing shows.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from nonsmooth.derive.declaration.algebra import bordered, cancel
from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.declaration.transition import Condition, Transition
from nonsmooth.derive.equations.section import (
    Passage,
    enforced_at,
    is_zero,
    multiple_of,
    passages_of,
    row_of,
    simplified,
)


def transition_unshown(itinerary: Itinerary) -> str | None:
    """The first boundary behind which an orbit's phases do not show where it leads, or None."""
    for passage in passages_of(itinerary):
        taken = passage.transition
        listed = [
            t
            for t in itinerary.presented_system.transitions
            if (t.source, t.boundaries) == (taken.source, taken.boundaries)
        ]
        if not _shown(itinerary.presented_system, passage, listed):
            return passage.boundary
    return None


def _shown(system: System, passage: Passage, listed: Sequence[Transition]) -> bool:
    """Whether the conditions of the taken transition hold, and those of earlier ones fail."""
    taken = passage.transition
    # the states that decide, in front of the reset: combinations of the columns
    deciding = sp.Matrix.hstack(*enforced_at(passage, system).nullspace(simplify=cancel))
    positive = list(_positive(system, passage, deciding))

    def signs(condition: Condition) -> Iterator[bool]:
        """Verdicts on whether a condition is met, one for each function that decides it."""
        row = row_of(condition.function, system)
        for known, along in positive:
            if along is not None and along != condition.along:
                continue
            landed = simplified(row * deciding), simplified(known * deciding)
            for one, other in ((row, known), landed):
                if _positive_factor(one, other, system):
                    yield condition.holds
                if _positive_factor(-one, other, system) or _opposed(one, other, system):
                    yield not condition.holds

    for transition in listed:
        if transition == taken:
            return all(any(signs(condition)) for condition in transition.conditions)
        met = [set(signs(condition)) for condition in transition.conditions]
        if {False} not in met:
            return False
    return False  # of none that is listed the contact law decides


def _positive(
    system: System, passage: Passage, deciding: sp.Matrix
) -> Iterator[tuple[sp.Matrix, str | None]]:
    """Rows [n, c] of functions that are positive at a transition, in general.

    With a row comes a configuration if the function itself is zero there, and positive
    along that configuration's flow.
    """
    yield passage.row, passage.configuration.name
    yield passage.row * passage.field, None
    if not is_zero((passage.landing - sp.eye(passage.landing.rows)) * deciding):
        return  # the next phase does not begin at the state that decides
    target = system.configuration(passage.transition.target)
    field = bordered(*target.dynamics.field(system.states), 0)
    for boundary in target.boundaries:
        row = row_of(boundary.function, system)
        yield -(row * field if is_zero(row * deciding) else row), None


def _positive_factor(one: sp.Matrix, other: sp.Matrix, system: System) -> bool:
    """Whether one function is shown to be a positive multiple of another."""
    ratio = multiple_of(one, other)
    return ratio is not None and _not_negative(ratio, system)


def _opposed(one: sp.Matrix, other: sp.Matrix, system: System) -> bool:
    """Whether one function is shown not to be positive where another is positive.

    Its sum with a positive multiple of the other one is then a constant and not positive.
    """
    pairs = list(zip(one, other, strict=True))[:-1]
    ratio = next((cancel(-a / b) for a, b in pairs if b != 0), None)
    if ratio is None or not _not_negative(ratio, system):
        return False
    *states, constant = simplified(one + ratio * other)
    return not any(states) and (constant == 0 or _not_negative(cancel(-constant), system))


def _not_negative(expression: sp.Expr, system: System) -> bool:
    """Whether a rational function is shown not to be negative by the signs of all its terms."""
    allowed = {p.symbol for p in system.parameters if p.lower >= 0}
    terms = [t for part in sp.fraction(expression) for t in sp.expand(part).as_ordered_terms()]
    return all(term.as_coeff_Mul()[0] > 0 and term.free_symbols <= allowed for term in terms)
