"""The section of a document on contacts, and what a configuration holds fixed."""

from __future__ import annotations

from collections.abc import Iterable

from nonsmooth.derive.document.blocks import Block, Paragraph, Table
from nonsmooth.derive.document.notation.wording import Naming, enumeration

__all__ = ["constraint_paragraphs", "contact_section"]


def contact_section(naming: Naming) -> list[Block]:
    """Blocks on the contacts: velocities and forces with which the surroundings act."""
    notation = naming.notation
    rows: list[tuple[str, ...]] = []
    for contact in naming.system.contacts:
        velocity = notation.latex(notation.tidy(contact.velocity))
        surface = notation.latex(notation.tidy(contact.surface))
        forces = list(contact.forces.items()) or [("", None)]
        for place, (configuration, force) in enumerate(forces):
            shown = "" if force is None else f"${notation.latex(notation.tidy(force))}$"
            first = (f"*{contact.name}*", f"${velocity}$", f"${surface}$")
            rows.append(
                (
                    *(first if place == 0 else ("", "", "")),
                    f"*{configuration}*" if configuration else "",
                    shown,
                )
            )
    header = ("Contact", "Velocity", "Surroundings", "Configuration", "Force")
    return [
        Paragraph(
            "The surroundings act on the oscillator at its contacts: a force in the direction of"
            " the velocity of the point there, zero in the configurations that are not named."
        ),
        Table(header, tuple(rows)),
    ]


def constraint_paragraphs(naming: Naming, names: Iterable[str]) -> list[Block]:
    """Paragraphs on what holds throughout a configuration beside its equations of motion."""
    notation = naming.notation
    found: list[str] = []
    for name in names:
        functions = naming.system.configuration(name).constraints
        if functions:
            texts = [f"${notation.latex(notation.tidy(f))} = 0$" for f in functions]
            found.append(f"{enumeration(texts)} in *{name}*")
    return [Paragraph(f"Throughout, {enumeration(found)}.")] if found else []
