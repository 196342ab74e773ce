"""The section of a document on what makes a solution of an itinerary's equations a motion."""

from __future__ import annotations

from nonsmooth.derive.declaration.itinerary import dwell_symbol
from nonsmooth.derive.declaration.transition import Condition, Transition
from nonsmooth.derive.document.blocks import Block, Formula, Line, Paragraph, Table
from nonsmooth.derive.document.notation.wording import enumeration
from nonsmooth.derive.document.views.cycle import Cycle, Passing

__all__ = ["admissibility_section"]


def admissibility_section(cycle: Cycle) -> list[Block]:
    """Blocks on admissibility: no boundary is crossed inside a phase.

    A table has the conditions under which each transition is the one that applies.
    """
    naming, letters = cycle.naming, cycle.letters
    notation, state, k = naming.notation, naming.state, cycle.index
    n, f = letters.normal, letters.field
    itinerary = cycle.itinerary
    names = [p.dwell_time for p in itinerary.phases if p.dwell_time not in itinerary.vanishing]
    positive = [f"{notation.symbol(dwell_symbol(name))} > 0" for name in names]
    single = cycle.count == 1
    time = notation.symbol(dwell_symbol(names[0])) if single else r"\tau^{(k)}"
    dwelling = "" if single else r"$\tau^{(k)}$ being the dwell time of phase $k$. "
    shown = (
        r",\; ".join(positive)
        if len(positive) <= 3
        else rf"{positive[0]},\; \ldots,\; {positive[-1]}"
    )
    blocks: list[Block] = [
        Paragraph(
            "A solution is a motion of the system if its dwell times are positive, no boundary of"
            " a phase's configuration is crossed before the phase ends, and each boundary is"
            f" crossed outwards: with the boundary functions $g$ of the configuration of phase"
            f" ${cycle.phase}$ and ${state}(t)$ the motion in it,"
        ),
        Formula(
            (
                Line(
                    "",
                    "",
                    (
                        rf"{shown},\qquad",
                        rf"g\left({state}(t)\right) < 0 \text{{ for }} 0 < t < {time},\qquad",
                        rf"{n}_{{{k}}} {f}_{{{k}}} > 0,",
                    ),
                ),
            ),
            label=cycle.label("Admissibility"),
        ),
        Paragraph(
            f"{dwelling}Where a maximum of $g$ inside a phase is zero the orbit grazes, and its"
            " itinerary is about to change."
        ),
    ]
    rows = [
        row
        for number, passing in enumerate(cycle.passings, start=1)
        for row in _conditions(cycle, number, passing)
    ]
    if rows:
        blocks += [
            Paragraph(
                "At a transition the first applies whose conditions hold: those of the transition"
                " itself have to hold, and those of each that is declared before it must not. Where"
                " a function vanishes, the first of its derivatives along the flow of the named"
                " configuration that does not vanish decides."
            ),
            Table(("Transition", "Required", "Along"), tuple(rows)),
        ]
    else:
        blocks.append(Paragraph("The transitions have no further conditions."))
    return blocks


def _conditions(cycle: Cycle, number: int, passing: Passing) -> list[tuple[str, ...]]:
    """Rows of a table with the conditions that decide for a transition."""
    system, transition = cycle.system, passing.transition
    required = [_required(cycle, (c,), holds=True) for c in transition.conditions]
    for other in _before(system.transitions, transition):
        distinct = tuple(c for c in other.conditions if c not in transition.conditions)
        if distinct:
            required.append(_required(cycle, distinct, holds=False))
    return [
        (f"${number}$" if place == 0 else "", *row)
        for place, row in enumerate(dict.fromkeys(required))
    ]


def _before(transitions: tuple[Transition, ...], transition: Transition) -> tuple[Transition, ...]:
    """Transitions for the same boundaries that are declared before the given one."""
    same = [
        t
        for t in transitions
        if (t.source, t.boundaries) == (transition.source, transition.boundaries)
    ]
    return tuple(same[: same.index(transition)])


def _required(cycle: Cycle, conditions: tuple[Condition, ...], *, holds: bool) -> tuple[str, str]:
    """Text of conditions that all have to hold, or of which one must not, and along what."""
    notation = cycle.naming.notation
    texts = []
    for condition in conditions:
        function = notation.latex(notation.tidy(condition.function))
        texts.append(f"{'not ' if condition.holds != holds else ''}${function} > 0$")
    along = enumeration(list(dict.fromkeys(f"*{c.along}*" for c in conditions)))
    return " or ".join(texts), along
