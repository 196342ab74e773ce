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

from nonsmooth.derive.declaration.algebra import cancel
from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.declaration.transition import Condition, Transition
from nonsmooth.derive.equations.section import Section, section_of

__all__ = ["transition_unshown"]


def transition_unshown(itinerary: Itinerary, system: System) -> str | None:
    """The first boundary behind which an orbit's phases do not show where it leads, or None.

    `system` is the one in whose states and parameters the itinerary is written.
    """
    for place, phase in enumerate(itinerary.phases):
        taken = itinerary.transition_after(system, place)
        listed = [
            t
            for t in system.transitions
            if (t.source, t.boundaries) == (taken.source, taken.boundaries)
        ]
        # of none that is listed the contact law decides
        if len(listed) != 1 and not _shown(itinerary, system, place, taken, listed):
            return phase.boundary
    return None


def _shown(
    itinerary: Itinerary,
    system: System,
    place: int,
    taken: Transition,
    listed: Sequence[Transition],
) -> bool:
    """Whether the conditions of the taken transition hold, and those of earlier ones fail."""
    positive = list(_positive(itinerary, system, place, taken))
    section = section_of(itinerary.rotated(place + 1), system)

    def signs(condition: Condition) -> Iterator[bool]:
        """Verdicts on whether a condition is met, one for each function that decides it."""
        row = _row(system, condition.function)
        for known, along in positive:
            if along is not None and along != condition.along:
                continue
            for one, other in ((row, known), (_on(section, row), _on(section, known))):
                if _positive_factor(one, other, system):
                    yield condition.holds
                if _positive_factor(-one, other, system) or _opposed(one, other, system):
                    yield not condition.holds

    for transition in listed:
        if transition == taken:
            return all(any(signs(condition)) for condition in transition.conditions)
        met = [set(signs(condition)) for condition in transition.conditions]
        same = (transition.target, transition.reset) == (taken.target, taken.reset)
        if not same and {False} not in met:
            return False
    return False


def _positive(
    itinerary: Itinerary, system: System, place: int, taken: Transition
) -> Iterator[tuple[sp.Matrix, str | None]]:
    """Rows [n, c] of functions that are positive at a transition, in general.

    With a row comes a configuration if the function itself is zero there, and positive
    along that configuration's flow.
    """
    source = system.configuration(taken.source)
    boundary = source.boundary(itinerary.phases[place].boundary)
    row = _row(system, boundary.function)
    yield row, taken.source
    yield _rate(system, taken.source, row), None
    section = section_of(itinerary.rotated(place + 1), system)
    changed = [_row(system, s - e) for s, e in taken.reset.items()]
    if any(_on(section, row) != sp.zeros(1, section.dimension + 1) for row in changed):
        return  # the next phase does not begin at the state that decides
    for boundary in system.configuration(taken.target).boundaries:
        row = _row(system, boundary.function)
        begins = _on(section, row) == sp.zeros(1, section.dimension + 1)
        yield -(_rate(system, taken.target, row) if begins else row), None


def _row(system: System, function: sp.Expr) -> sp.Matrix:
    """An affine function n y + c of the state as a row [n, c]."""
    normal, constant = system.gradient(function)
    return sp.Matrix([[*normal, constant]])


def _rate(system: System, configuration: str, row: sp.Matrix) -> sp.Matrix:
    """Derivative, as a row, of an affine function along a configuration's flow."""
    field = system.configuration(configuration).dynamics.field(system.states)
    return row[:, :-1] * sp.Matrix.hstack(*field)


def _on(section: Section, row: sp.Matrix) -> sp.Matrix:
    """An affine function as a row in the coordinates of a section."""
    place = sp.Matrix.vstack(sp.Matrix(section.constant), sp.Matrix([[1]]))
    return sp.Matrix.hstack(row[:, :-1] * section.embedding, row * place).applyfunc(
        lambda e: cancel(sp.expand(e))
    )


def _positive_factor(one: sp.Matrix, other: sp.Matrix, system: System) -> bool:
    """Whether one function is shown to be a positive multiple of another."""
    ratio = next((cancel(a / b) for a, b in zip(one, other, strict=True) if b != 0), None)
    if ratio is None or not _not_negative(ratio, system):
        return False
    return all(cancel(sp.expand(a - ratio * b)) == 0 for a, b in zip(one, other, strict=True))


def _opposed(one: sp.Matrix, other: sp.Matrix, system: System) -> bool:
    """Whether one function is shown not to be positive where another is positive.

    Its sum with a positive multiple of the other one is then a constant and not positive.
    """
    pairs = list(zip(one, other, strict=True))
    ratio = next((cancel(-a / b) for a, b in pairs[:-1] if b != 0), None)
    if ratio is None or not _not_negative(ratio, system):
        return False
    *states, constant = (cancel(sp.expand(a + ratio * b)) for a, b in pairs)
    return not any(states) and (constant == 0 or _not_negative(cancel(-constant), system))


def _not_negative(expression: sp.Expr, system: System) -> bool:
    """Whether a rational function is shown not to be negative by the signs of all its terms."""
    allowed = {p.symbol for p in system.parameters if p.lower >= 0}
    terms = [t for part in sp.fraction(expression) for t in sp.expand(part).as_ordered_terms()]
    return expression != 0 and all(
        term.as_coeff_Mul()[0] > 0 and term.free_symbols <= allowed for term in terms
    )
