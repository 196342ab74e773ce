"""The section of a document on the law of contacts that the mass matrix couples."""

from __future__ import annotations

import sympy as sp

from nonsmooth.derive.declaration.transition import ContactLaw
from nonsmooth.derive.document.blocks import Block, Formula, Line, Paragraph, Table
from nonsmooth.derive.document.notation.wording import Naming

__all__ = ["law_section"]


def law_section(naming: Naming, law: ContactLaw) -> list[Block]:
    """Blocks on the contact law, which decides what follows at a contact's boundary."""
    notation = naming.notation

    def shown(function: sp.Expr) -> str:
        return f"${notation.latex(notation.tidy(function))}$"

    rubbing = [contact for contact in law.contacts if contact.friction]
    stops = [contact for contact in law.contacts if not contact.friction]
    blocks: list[Block] = [
        Paragraph(
            "The mass matrix couples these contacts: a force on one accelerates others. Where one"
            " reaches a boundary it is decided together with those at rest, by one law that asks"
            " neither for the order in which they are declared nor for their directions."
        ),
        Table(
            ("Contact", "Velocity $r$", "Static limit", "Kinetic limit"),
            tuple(
                (f"*{c.name}*", *map(shown, (c.relative, c.static, c.kinetic))) for c in rubbing
            ),
        ),
        Paragraph(
            "Let the limit $L_i$ be the kinetic one of those that have reached the limit of their"
            " force, the static one of the others at rest. Their accelerations are those that"
            " minimise"
        ),
        Formula(
            (
                Line(
                    r"\tfrac{1}{2} \left\| \ddot{x} - \ddot{x}_\mathrm{free} \right\|_M^2"
                    r" + \sum_i L_i \left| \dot{r}_i \right|",
                    r"\to",
                    (r"\min",),
                ),
            )
        ),
        Paragraph(
            r"with $\ddot{x}_\mathrm{free}$ the accelerations without their forces. All that slip"
            " in it get their kinetic limit, and so on until none is added; what slides with"
            r" $r \neq 0$ keeps its force. Where a force is at its limit, or $\dot{r}_i = 0$ for"
            " what slips, the first derivative that does not vanish decides. What that leaves"
            " open is ambiguous."
        ),
    ]  # fmt: skip
    if stops:
        names = " and ".join(f"*{contact.name}*" for contact in stops)
        blocks.append(
            Paragraph(rf"Of {names}: the minimum is one with $\dot{{r}} \leq 0$, where stops push.")
        )
    return blocks
