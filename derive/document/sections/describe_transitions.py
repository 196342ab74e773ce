"""The section of a document on transitions."""

from __future__ import annotations

from nonsmooth.derive.declaration.transition import Transition
from nonsmooth.derive.document.blocks import Block, Heading, Paragraph, Table
from nonsmooth.derive.document.notation.wording import Naming, enumeration

__all__ = ["transition_section"]


def transition_section(naming: Naming) -> list[Block]:
    """Blocks on which configuration follows which set of boundaries, under which conditions."""
    notation, system = naming.notation, naming.system
    if all(not t.conditions and len(t.boundaries) == 1 for t in system.transitions):
        return _without_conditions(naming)
    conditions = list(dict.fromkeys(c for t in system.transitions for c in t.conditions))
    numbers = {c: f"$C_{{{i}}}$" for i, c in enumerate(conditions, start=1)}
    blocks: list[Block] = [
        Paragraph(
            "Boundaries that are reached at one instant are one transition. Of the"
            " configurations named for it the first whose conditions hold follows; a reset"
            " acts at the same instant and leaves the states that it does not name."
        )
    ]
    if conditions:
        blocks += [
            Heading("Conditions", 2),
            Paragraph(
                "Where the function vanishes, the first of its derivatives that does not decides,"
                " along the flow of the named configuration."
            ),
            Table(
                ("Condition", "Holds if", "Along"),
                tuple(
                    (
                        number,
                        f"{'' if c.holds else 'not '}"
                        f"${notation.latex(notation.tidy(c.function))} > 0$",
                        f"*{c.along}*",
                    )
                    for c, number in numbers.items()
                ),
            ),
        ]
    outcomes: dict[tuple[str, tuple[str, ...]], list[tuple[str, str, str]]] = {}
    for transition in system.transitions:
        event = transition.source, tuple(sorted(transition.boundaries))
        outcomes.setdefault(event, []).append(
            (
                f"*{transition.target}*",
                enumeration([numbers[c] for c in transition.conditions]) or "always",
                _reset(transition, naming),
            )
        )
    # many events share one list of outcomes
    rules = {tuple(found): "" for found in outcomes.values()}
    rules = {found: f"$T_{{{i}}}$" for i, found in enumerate(rules, start=1)}
    events: dict[tuple[str, str], list[str]] = {}
    for (source, reached), found in outcomes.items():
        together = " with ".join(f"*{b}*" for b in reached)
        events.setdefault((source, rules[tuple(found)]), []).append(together)
    return [
        *blocks,
        Heading("Rules", 2),
        Paragraph("Each rule is a list of configurations; the first that applies is taken."),
        Table(
            ("Rule", "To", "If", "Reset"),
            tuple(
                (rule if position == 0 else "", *outcome)
                for found, rule in rules.items()
                for position, outcome in enumerate(found)
            ),
        ),
        Heading("Events", 2),
        Table(
            ("From", "Boundaries", "Rule"),
            tuple(
                (f"*{source}*" if source != before else "", ", or ".join(found), rule)
                for before, ((source, rule), found) in zip(
                    (None, *(s for s, _ in events)), events.items(), strict=False
                )
            ),
            wrapped=1,
        ),
    ]


def _without_conditions(naming: Naming) -> list[Block]:
    """Table of transitions that single boundaries decide, one row for each."""
    resets = [_reset(t, naming) for t in naming.system.transitions]
    rows: list[tuple[str, ...]] = [
        (f"*{t.source}*", ", ".join(f"*{b}*" for b in t.boundaries), f"*{t.target}*", reset)
        for t, reset in zip(naming.system.transitions, resets, strict=True)
    ]
    header: tuple[str, ...] = ("From", "Boundary", "To", "Reset")
    if any(resets):
        text = (
            "What follows at each boundary. A reset acts at the same instant; the states that it"
            " does not name are continuous."
        )
    else:
        text = "What follows at each boundary; the state is continuous there."
        rows, header = [row[:3] for row in rows], header[:3]
    return [Paragraph(text), Table(header, tuple(rows))]


def _reset(transition: Transition, naming: Naming) -> str:
    rules = [
        f"${naming.notation.symbol(s)} := {naming.notation.latex(naming.notation.tidy(e))}$"
        for s, e in transition.reset.items()
    ]
    return ", ".join(rules)
