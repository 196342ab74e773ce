"""The sections of a document that declare a system: states, parameters, transitions, contacts."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace

import sympy as sp

from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.derive.declaration.parameter import Parameter
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.declaration.transition import ContactLaw, Transition
from nonsmooth.derive.document.blocks import Block, Formula, Line, Paragraph, Table
from nonsmooth.derive.document.printer import Notation
from nonsmooth.derive.document.sections.template import compose, math, sentence
from nonsmooth.derive.document.wording import Naming, enumeration


def system_section(
    naming: Naming, itinerary: Itinerary | None, required: Iterable[sp.Symbol] = ()
) -> list[Block]:
    """Blocks on the name, the states, the parameters and the presentation of a system.

    `itinerary` is None for the document of a system. Substitutions of the parameters in
    `required`, whose values the orbit requires, are left out.
    """
    system = itinerary.system if itinerary else naming.system
    size = len(system.states) // 2
    positions, velocities = system.states[:size], system.states[size:]
    # a dwell time may be called as a word of a description is
    described = replace(naming.notation, unknowns=())
    parameters = list(system.parameters)
    moved: list[Line] = []
    substituted: list[Line] = []
    presentation = itinerary.presentation if itinerary else None
    if presentation:
        parameters += presentation.parameters
        origins = zip(presentation.states, system.states, presentation.origin, strict=True)
        moved = [naming.equal(new, old - o, tidy=False) for new, old, o in origins if new != old]
        substitution = presentation.substitution.items()
        substituted = [naming.equal(s, e) for s, e in substitution if s not in required]
    if itinerary and itinerary.period:
        parameters.append(itinerary.period)
    rows = tuple(
        (
            math(naming, p.symbol),
            described.prose(_one_paragraph(p.description)),
            f"${_domain(p, naming.notation)}$",
        )
        for p in parameters
    )
    return compose(
        naming,
        r"""
        The system is *@system.name*: @description. [second_order: Its state consists of the
        position[many positions: s] @positions and the [many positions: velocities | velocity]
        @velocities, a prime being the derivative by time. | Its state is @system.states. @forcing]

        @table

        [constraints: The parameters obey @constraints.]

        [moved: The equations are written in the shifted coordinates]
        $$
        @moved
        $$
        [substituted: [moved: with | The equations are written with] the substitution]
        $$
        @substituted
        $$
        """,
        system=system,
        description=described.prose(_one_paragraph(system.description)),
        positions=positions,
        velocities=[
            f"${naming.notation.symbol(v)} = {naming.notation.symbol(x)}'$"
            for x, v in zip(positions, velocities, strict=True)
        ]
        if naming.second_order
        else [],
        forcing=_forcing(naming, system),
        table=Table(("Parameter", "Meaning", "Domain"), rows, wrapped=1) if rows else [],
        constraints=[
            math(naming, c, r" \ge 0") for c in naming.system.constraints if not c.is_nonnegative
        ],
        moved=moved,
        substituted=substituted,
    )


def _one_paragraph(text: str) -> str:
    """Text of a user without its own breaks of lines and paragraphs."""
    return " ".join(text.split())


def _forcing(naming: Naming, system: System) -> str:
    """Sentences on the two states of each harmonic forcing."""
    matrix, _ = system.configurations[0].dynamics.field(system.states)
    return " ".join(
        sentence(
            naming,
            "Of these @pair are the cosine and the sine of the phase of a forcing, which turns with"
            " the frequency $@frequency$.",
            pair=(cosine, sine),
            frequency=naming.notation.latex(
                matrix[system.states.index(sine), system.states.index(cosine)]
            ),
        )
        for cosine, sine in system.forcing
    )


def _domain(parameter: Parameter, notation: Notation) -> str:
    """LaTeX of the domain of a parameter."""
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


def model_section(naming: Naming, system: System) -> list[Block]:
    """Blocks on what stands behind a system's equations, as it is declared."""
    blocks: list[Block] = []
    for text in map(_one_paragraph, system.model):
        alone = text.startswith("$") and "$" not in text[1:-1]
        # a line may break behind a wide space
        pieces = tuple(re.split(r"(?<=\\qquad)", text[1:-1]))
        blocks.append(Formula((Line("", "", pieces),)) if alone else Paragraph(text))
    cited = naming.cited("model")
    return blocks + compose(naming, "[cited: This is the model@cited.]", cited=cited)


def transition_section(naming: Naming) -> list[Block]:
    """Blocks on which configuration follows which set of boundaries, under which conditions."""
    transitions = naming.system.transitions
    if all(not t.conditions and len(t.boundaries) == 1 for t in transitions):
        return _without_conditions(naming)
    conditions = list(dict.fromkeys(c for t in transitions for c in t.conditions))
    numbers = {c: f"$C_{{{i}}}$" for i, c in enumerate(conditions, start=1)}
    outcomes: dict[tuple[str, tuple[str, ...]], list[tuple[str, str, str]]] = {}
    for transition in transitions:
        event = transition.source, tuple(sorted(transition.boundaries))
        needed = enumeration([numbers[c] for c in transition.conditions]) or "always"
        outcome = f"*{transition.target}*", needed, _reset(transition, naming)
        outcomes.setdefault(event, []).append(outcome)
    # many events share one list of outcomes
    shared = dict.fromkeys(map(tuple, outcomes.values()))
    rules = {found: f"$T_{{{i}}}$" for i, found in enumerate(shared, start=1)}
    events: dict[tuple[str, str], list[str]] = {}
    for (source, reached), found in outcomes.items():
        together = " with ".join(f"*{b}*" for b in reached)
        events.setdefault((source, rules[tuple(found)]), []).append(together)
    sources = (None, *(source for source, _ in events))
    return compose(
        naming,
        """
        Boundaries that are reached at one instant are one transition. Of the configurations named
        for it the first whose conditions hold follows; a reset acts at the same instant and leaves
        the states that it does not name.

        [conditions: ## Conditions]

        [conditions: Where the function vanishes, the first of its derivatives that does not
        decides, along the flow of the named configuration.]

        @conditions

        ## Rules

        Each rule is a list of configurations; the first that applies is taken.

        @rules

        ## Events

        @events
        """,
        conditions=[
            Table(
                ("Condition", "Holds if", "Along"),
                tuple(
                    (
                        number,
                        f"{'' if c.holds else 'not '}{math(naming, c.function, ' > 0')}",
                        f"*{c.along}*",
                    )
                    for c, number in numbers.items()
                ),
            )
        ]
        if numbers
        else [],
        rules=Table(
            ("Rule", "To", "If", "Reset"),
            tuple(
                (rule if position == 0 else "", *outcome)
                for found, rule in rules.items()
                for position, outcome in enumerate(found)
            ),
        ),
        events=Table(
            ("From", "Boundaries", "Rule"),
            tuple(
                (f"*{source}*" if source != before else "", ", or ".join(found), rule)
                for before, ((source, rule), found) in zip(sources, events.items(), strict=False)
            ),
            wrapped=1,
        ),
    )


def _without_conditions(naming: Naming) -> list[Block]:
    """Table of transitions that single boundaries decide, one row for each."""
    transitions = naming.system.transitions
    resets = any(t.reset for t in transitions)
    rows = [
        (f"*{t.source}*", *(f"*{b}*" for b in t.boundaries), f"*{t.target}*", _reset(t, naming))
        for t in transitions
    ]
    width = 4 if resets else 3
    return compose(
        naming,
        """
        What follows at each boundary[resets: . A reset acts at the same instant; the states that it
        does not name are continuous | ; the state is continuous there].

        @table
        """,
        resets=resets,
        table=Table(
            ("From", "Boundary", "To", "Reset")[:width], tuple(row[:width] for row in rows)
        ),
    )


def _reset(transition: Transition, naming: Naming) -> str:
    """Formulas for what a transition sets the states to."""
    symbol = naming.notation.symbol
    return ", ".join(f"${symbol(s)} := {math(naming, e)[1:]}" for s, e in transition.reset.items())


def law_section(naming: Naming, law: ContactLaw) -> list[Block]:
    """Blocks on the contact law, which decides what follows at a contact's boundary."""
    return compose(
        naming,
        r"""
        The mass matrix couples these contacts: a force on one accelerates others. Where one reaches
        a boundary it is decided together with those at rest, by one law that asks neither for the
        order in which they are declared nor for their directions.

        @limits

        Let the limit $L_i$ be the kinetic one of those that have reached the limit of their force,
        the static one of the others at rest. Their accelerations are those that minimise
        $$
        @distance + \sum_i L_i \left| \dot{r}_i \right| &\to \min
        $$
        with $\ddot{x}_\mathrm{free}$ the accelerations without their forces. All that slip in it
        get their kinetic limit, and so on until none is added; what slides with $r \neq 0$ keeps
        its force. Where a force is at its limit, or $\dot{r}_i = 0$ for what slips, the first
        derivative that does not vanish decides. What that leaves open is ambiguous.

        [stops: Of @stops: the minimum is one with $\dot{r} \leq 0$, where stops push.]
        """,
        distance=r"\tfrac{1}{2} \left\| \ddot{x} - \ddot{x}_\mathrm{free} \right\|_M^2",
        limits=Table(
            ("Contact", "Velocity $r$", "Static limit", "Kinetic limit"),
            tuple(
                (f"*{c.name}*", *(math(naming, e) for e in (c.relative, c.static, c.kinetic)))
                for c in law.contacts
                if c.friction
            ),
        ),
        stops=" and ".join(f"*{contact.name}*" for contact in law.contacts if not contact.friction),
    )


def contact_section(naming: Naming) -> list[Block]:
    """Blocks on the contacts: velocities and forces with which the surroundings act."""
    rows: list[tuple[str, ...]] = []
    for contact in naming.system.contacts:
        first = (
            f"*{contact.name}*",
            math(naming, contact.velocity),
            math(naming, contact.surface),
        )
        forces = [(f"*{name}*", math(naming, force)) for name, force in contact.forces.items()]
        for place, force in enumerate(forces or [("", "")]):
            rows.append((*(("", "", "") if place else first), *force))
    header = ("Contact", "Velocity", "Surroundings", "Configuration", "Force")
    return compose(
        naming,
        """
        The surroundings act on the oscillator at its contacts: a force in the direction of the
        velocity of the point there, zero in the configurations that are not named.

        @table
        """,
        table=Table(header, tuple(rows)),
    )
