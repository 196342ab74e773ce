"""Flows without a written closed form: exponentials by clusters of eigenvalues."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from nonsmooth.derive.declaration.configuration import Configuration
from nonsmooth.derive.declaration.dynamics import SecondOrder
from nonsmooth.derive.document.blocks import Block, Formula, Line, Paragraph
from nonsmooth.derive.document.notation.arrange import characteristic_pieces
from nonsmooth.derive.document.notation.letters import Letters
from nonsmooth.derive.document.notation.wording import Naming, enumeration

__all__ = ["exponential_blocks"]


def exponential_blocks(
    naming: Naming, letters: Letters, names: Sequence[str], known: int
) -> tuple[list[Block], dict[str, int]]:
    """Blocks on flows without a closed form, and the number of each configuration's flow.

    `known` is the number of flows that are written out already.
    """
    system = naming.system
    chosen = [system.configuration(name) for name in names]
    alike: dict[sp.Matrix, list[Configuration]] = {}
    for configuration in chosen:
        matrix, _ = configuration.dynamics.field(system.states)
        alike.setdefault(matrix, []).append(configuration)
    numbers: dict[str, int] = {}
    blocks = _exponential(naming, letters, chosen)
    for number, (matrix, sharing) in enumerate(alike.items(), start=known + 1):
        numbers |= {c.name: number for c in sharing}
        pieces = characteristic_pieces(naming.notation, matrix, letters.eigenvalue)
        flow = rf"$\Phi_{{{number}}}$, {naming.flow_of([c.name for c in sharing])}"
        unit = f"{letters.eigenvalue} I - {letters.matrix}"
        if pieces is None:
            blocks.append(
                Paragraph(
                    f"{flow}: the {matrix.rows} eigenvalues are found from the numbers of the"
                    f" matrix ${letters.matrix}$."
                )
            )
        else:
            blocks += [
                Paragraph(f"{flow}: the eigenvalues are the roots of"),
                Formula((Line(rf"\det\left({unit}\right)", "=", _ended(pieces)),)),
            ]
    return blocks, numbers


def _exponential(naming: Naming, letters: Letters, chosen: Sequence[Configuration]) -> list[Block]:
    """Blocks that say how a flow without a closed form is computed."""
    a, b, augmented = letters.matrix, letters.offset, letters.augmented
    centre, projector, state = letters.centre, letters.projector, naming.state
    listed = enumeration([f"*{c.name}*" for c in chosen])
    whole = len(chosen) == len(naming.system.configurations)
    text = (
        "The flow of no configuration is written out in the parameters: it comes"
        if whole and len(chosen) > 1
        else f"The flow of {listed} is not written out in the parameters: it comes"
    )
    text += (
        f" from numbers, once for each set of parameters. With the matrix ${a}$ and the column"
        f" ${b}$ of ${state}' = {a} {state} + {b}$"
    )
    second = [c.dynamics for c in chosen if isinstance(c.dynamics, SecondOrder)]
    if second:
        zeros = ", zeros for a held one," if any(d.held for d in second) else ","
        text += (
            ", which hold the equations of motion solved for the accelerations below the rows"
            f" of ${naming.letter}'${zeros}"
        )
    text += " it is read off the exponential of an augmented matrix,"
    block = rf"\left(\begin{{matrix}}\Phi(t) & {letters.forcing}(t)\\0 & 1\end{{matrix}}\right)"
    field = rf"\left(\begin{{matrix}}{a} & {b}\\0 & 0\end{{matrix}}\right)"
    return [
        Paragraph(text),
        Formula(
            (
                Line(
                    f"{state}(t)",
                    "=",
                    (
                        rf"\Phi(t)\,{state}(0) + {letters.forcing}(t),\qquad",
                        rf"{block} = \mathrm{{e}}^{{{augmented} t}},\qquad",
                        f"{augmented} = {field}.",
                    ),
                ),
            )
        ),
        Paragraph(
            "The exponential is a sum over clusters of eigenvalues. An eigenvalue that is well"
            " apart from the others is a cluster of its own; those that are equal, or too near"
            f" each other to be told apart, make one together. With the centre ${centre}_{{j}}$"
            f" of a cluster and the projector ${projector}_{{j}}$ on its invariant subspace,"
        ),
        Formula(
            (
                Line(
                    rf"\mathrm{{e}}^{{{augmented} t}}",
                    "=",
                    (
                        rf"\sum_{{j}} \mathrm{{e}}^{{{centre}_{{j}} t}} \sum_{{k \ge 0}}"
                        rf" \frac{{t^{{k}}}}{{k!}}"
                        rf" \left({augmented} - {centre}_{{j}} I\right)^{{k}}"
                        f" {projector}_{{j}}.",
                    ),
                ),
            )
        ),
        Paragraph(
            "Of a single eigenvalue the term $k = 0$ remains, of equal ones as many terms as there"
            " are; nearly equal ones are taken together, by divided differences of the exponential"
            " at these eigenvalues, in which no digits cancel. Two"
            " conjugate eigenvalues give a cosine and a sine, and the eigenvalue 0 of the last"
            f" column holds what ${b}$ does."
        ),
    ]


def _ended(pieces: tuple[str, ...]) -> tuple[str, ...]:
    return (*pieces[:-1], f"{pieces[-1]}.")
