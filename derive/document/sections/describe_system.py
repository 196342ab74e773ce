"""The sections of a document that concern a system: declaration, configurations, flows."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from nonsmooth.derive.declaration.dynamics import SecondOrder
from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.derive.declaration.parameter import Parameter
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.document.blocks import Block, Formula, Line, Paragraph, Table
from nonsmooth.derive.document.notation.letters import is_response
from nonsmooth.derive.document.notation.printer import Notation
from nonsmooth.derive.document.notation.wording import Naming, enumeration, letters_of
from nonsmooth.derive.document.sections.describe_exponential import exponential_blocks
from nonsmooth.derive.document.sections.describe_flows import flow_blocks
from nonsmooth.derive.document.sections.describe_motion import MatrixLetters, matrices_of, motion_of
from nonsmooth.derive.document.sections.describe_responses import response_flows
from nonsmooth.derive.document.views.centres import Centres
from nonsmooth.derive.flows.modal import Flow, Spectrum

__all__ = [
    "Naming",
    "configuration_section",
    "enumeration",
    "flow_section",
    "modal_section",
    "model_section",
    "system_section",
]


def system_section(
    naming: Naming, itinerary: Itinerary | None, required: Iterable[sp.Symbol] = ()
) -> list[Block]:
    """Blocks on the name, the states, the parameters and the presentation of a system.

    `itinerary` is None for the document of a system. Substitutions of the parameters in
    `required`, whose values the orbit requires, are left out.
    """
    system = itinerary.system if itinerary else naming.system
    size = len(system.states) // 2
    # a dwell time may be called as a word of a description is
    described = replace(naming.notation, unknowns=())
    text = f"The system is *{system.name}*: {described.prose(system.description)}."
    if naming.second_order:
        plural = "" if size == 1 else "s"
        velocities = enumeration(
            [
                f"${naming.notation.symbol(v)} = {naming.notation.symbol(x)}'$"
                for x, v in zip(system.states[:size], system.states[size:], strict=True)
            ]
        )
        text += (
            f" Its state consists of the position{plural} {naming.list(system.states[:size])} and"
            f" the velocit{'y' if size == 1 else 'ies'} {velocities}, a prime being the derivative"
            " by time."
        )
    else:
        text += f" Its state is {naming.list(system.states)}.{_forcing(naming, system)}"
    parameters = list(system.parameters)
    blocks: list[Block] = [Paragraph(text)]
    presentation = itinerary.presentation if itinerary else None
    if presentation:
        parameters += presentation.parameters
    if itinerary and itinerary.period:
        parameters.append(itinerary.period)
    rows = tuple(
        (
            f"${naming.notation.symbol(p.symbol)}$",
            described.prose(p.description),
            f"${_domain(p, naming.notation)}$",
        )
        for p in parameters
    )
    if rows:
        blocks.append(Table(("Parameter", "Meaning", "Domain"), rows, wrapped=1))
    constraints = [c for c in naming.system.constraints if not c.is_nonnegative]
    if constraints:
        notation = naming.notation
        relations = [rf"${notation.latex(notation.tidy(c))} \ge 0$" for c in constraints]
        blocks.append(Paragraph(f"The parameters obey {enumeration(relations)}."))
    if presentation:
        moved = [
            naming.equal(new, old - origin, tidy=False)
            for new, old, origin in zip(
                presentation.states, system.states, presentation.origin, strict=True
            )
            if new != old
        ]
        if moved:
            blocks += [
                Paragraph("The equations are written in the shifted coordinates"),
                Formula(tuple(moved)),
            ]
        substituted = tuple(
            naming.equal(s, e) for s, e in presentation.substitution.items() if s not in required
        )
        if substituted:
            blocks += [
                Paragraph(
                    "with the substitution"
                    if moved
                    else "The equations are written with the substitution"
                ),
                Formula(substituted),
            ]
    return blocks


def model_section(naming: Naming, system: System) -> list[Block]:
    """Blocks on what stands behind a system's equations, as it is declared."""
    blocks: list[Block] = []
    for text in system.model:
        alone = text.startswith("$") and "$" not in text[1:-1]
        # a line may break behind a wide space
        pieces = tuple(re.split(r"(?<=\\qquad)", text[1:-1]))
        blocks.append(Formula((Line("", "", pieces),)) if alone else Paragraph(text))
    cited = naming.cited("model")
    return [*blocks, Paragraph(f"This is the model{cited}.")] if cited else blocks


def _forcing(naming: Naming, system: System) -> str:
    """Text on the two states of each harmonic forcing."""
    matrix, _ = system.configurations[0].dynamics.field(system.states)
    found = ""
    for cosine, sine in system.forcing:
        frequency = matrix[system.states.index(sine), system.states.index(cosine)]
        found += (
            f" Of these {naming.list((cosine, sine))} are the cosine and the sine of the phase of"
            f" a forcing, which turns with the frequency ${naming.notation.latex(frequency)}$."
        )
    return found


def _domain(parameter: Parameter, notation: Notation) -> str:
    name = notation.symbol(parameter.symbol)
    above, below = (r"\ge", r"\le") if parameter.closed else (">", "<")
    end = r"\le" if parameter.upper_closed else "<"
    lower, upper = sp.sympify(parameter.lower), sp.sympify(parameter.upper)
    if lower.is_infinite and upper.is_infinite:
        return rf"{name} \in \mathbb{{R}}"
    if lower.is_infinite:
        return f"{name} {end} {notation.latex(upper)}"
    if upper.is_infinite:
        return f"{name} {above} {notation.latex(lower)}"
    return f"{notation.latex(lower)} {below} {name} {end} {notation.latex(upper)}"


def configuration_section(
    naming: Naming, names: Sequence[str], remarks: Mapping[str, str]
) -> list[Block]:
    """Blocks with the equations of motion of the named configurations, and their boundaries."""
    system, notation = naming.system, naming.notation
    chosen = [system.configuration(name) for name in names]
    blocks: list[Block] = []
    if not all(isinstance(c.dynamics, SecondOrder) for c in chosen):
        column = rf"\left({', '.join(map(notation.symbol, system.states))}\right)^{{\mathsf{{T}}}}"
        blocks.append(
            Paragraph(
                "Inside a configuration the motion is linear,"
                f" with the state ${naming.state} = {column}$."
            )
        )
    second = [c.dynamics for c in chosen if isinstance(c.dynamics, SecondOrder)]
    letters: MatrixLetters = {}
    if second:
        x = naming.letter
        damped = any(not sp.Matrix(d.damping).is_zero_matrix for d in second)
        held = any(d.held for d in second)
        # masses stay on the left where nothing is held and they are not all one
        heavy = not held and any(d.mass != sp.eye(d.mass.rows) for d in second)
        damping = f" + C {x}'" if damped else ""
        law = rf"$M {x}''{damping} + K {x} = \ell$"
        where = "every configuration" if len(second) == len(chosen) else "those of second order"
        text = f"In {where} the motion is linear, {law}"
        text += (
            ", and a coordinate that is held keeps its velocity: its row gives the reaction."
            if held
            else "."
        )
        single = all(d.mass.rows == 1 for d in second)
        if single:
            blocks.append(Paragraph(f"The motion is linear in {where}."))
        else:
            blocks.append(Paragraph(f"{text} The matrices are"))
            formula, letters = matrices_of(second, naming, damped)
            blocks.append(formula)
        if not (heavy or single):
            where = ", with the rows of the held coordinates set to zero," if held else ","
            text = f"Solved for the accelerations{where} the equations of motion are as follows."
            blocks.append(Paragraph(text))
            letters = {}
    for configuration in chosen:
        remark = remarks.get(configuration.name, "")
        remark += naming.cited(f"configuration {configuration.name}")
        blocks.append(Paragraph(f"*{configuration.name}*{remark}:"))
        blocks += motion_of(configuration, naming, letters)
    blocks.append(
        Paragraph(
            "A configuration is left where one of its boundary functions, negative inside,"
            " rises through zero."
            + (
                " One that acts when reached is left at a tangency too, one that acts when"
                " exceeded is not."
                if len({b.acts_when for c in chosen for b in c.boundaries}) > 1
                else ""
            )
        )
    )
    rows = [
        (
            f"*{configuration.name}*" if position == 0 else "",
            f"*{boundary.name}*",
            f"${notation.latex(notation.tidy(boundary.function))} < 0$",
            boundary.acts_when,
        )
        for configuration in chosen
        for position, boundary in enumerate(configuration.boundaries)
    ]
    blocks.append(Table(("Configuration", "Boundary", "Inside", "Acts when"), tuple(rows)))
    return blocks


def modal_section(
    naming: Naming,
    spectrum: Spectrum,
    flows: Mapping[str, Flow],
    names: Sequence[str],
    centres: Centres | None = None,
) -> tuple[list[Block], dict[str, int]]:
    """Blocks on the spectrum and the flows in closed form, and each flow's number by name.

    Centres that have letters are shown with them.
    """
    used = [flows[name] for name in names]
    blocks: list[Block] = []
    entries = _entries(spectrum, used)
    if entries:
        blocks += [
            Paragraph(
                "All that needs a root of the parameters is the spectrum, evaluated once for"
                f" each set of parameters{_meaning(naming, used, dict(entries))}:"
                if any(_has_root(e) for _, e in entries)
                else "The factors below contain"
            ),
            Formula(tuple(naming.equal(s, e, tidy=_single(e)) for s, e in entries)),
        ]
    if any(map(is_response, used)):
        more, numbers = response_flows(naming, used, dict(spectrum.entries))
    else:
        more, numbers = flow_blocks(naming, used, centres)
    return blocks + more, numbers


def flow_section(
    naming: Naming,
    spectrum: Spectrum,
    flows: Mapping[str, Flow],
    names: Sequence[str],
    centres: Centres,
) -> tuple[list[Block], dict[str, int]]:
    """Blocks on the flows of the named configurations, and the number of each flow by name.

    Those that are not among the `flows` have no closed form and are exponentials.
    """
    closed = [name for name in names if name in flows]
    blocks: list[Block] = []
    numbers: dict[str, int] = {}
    if closed:
        # letters for the coordinates of one centre; of many the columns are shown
        shown = centres if len(centres.columns) == 1 else None
        blocks, numbers = modal_section(naming, spectrum, flows, closed, shown)
    others = [name for name in names if name not in flows]
    if others:
        symbols = (*naming.system.states, *naming.notation.constants)
        known = max(numbers.values(), default=0)
        more, further = exponential_blocks(naming, letters_of(naming, symbols), others, known)
        blocks += more
        numbers |= further
    return blocks, numbers


def _meaning(naming: Naming, flows: Sequence[Flow], entries: Mapping[sp.Symbol, sp.Expr]) -> str:
    """Text on the spectrum's symbols: frequencies, differences of eigenvalues, projectors."""
    oscillating = {s for f in flows for g in f.basis if g.has(sp.cos) for s in g.free_symbols}
    if not naming.second_order or not oscillating & set(entries):
        return ""
    found = [
        r"the frequencies $\omega$, whose squares are the eigenvalues of $M^{-1} K$ for the"
        " coordinates that are free"
    ]
    stems = {symbol.parts[0] for symbol in entries}
    if "gap" in stems:
        found.append(r"the differences $\Delta$ of two of these eigenvalues")
    if "p" in stems:
        found.append("the entries $p$ of the projectors on the modes")
    return f". It consists of {enumeration(found)}"


def _has_root(expression: sp.Expr) -> bool:
    """Whether parameters occur below a root."""
    powers = expression.atoms(sp.Pow)
    return any(not p.exp.is_integer and p.free_symbols for p in powers)


def _single(expression: sp.Expr) -> bool:
    """Whether an expression has a denominator of at most one symbol, and may be put together."""
    return len(sp.fraction(sp.together(expression))[1].free_symbols) < 2


def _entries(spectrum: Spectrum, flows: Sequence[Flow]) -> list[tuple[sp.Symbol, sp.Expr]]:
    """Entries of the spectrum that the flows need, directly or through others, in order."""
    needed: set[sp.Symbol] = set()
    for flow in flows:
        for part in (*flow.basis, *flow.matrices, *flow.offsets):
            needed |= part.free_symbols
    kept = []
    for symbol, expression in reversed(spectrum.entries):
        if symbol in needed:
            needed |= expression.free_symbols
            kept.append((symbol, expression))
    return kept[::-1]
