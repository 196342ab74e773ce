"""The sections of a document that declare a system: states, parameters, motions, transitions."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from nonsmooth.derive.declaration.algebra import cancel
from nonsmooth.derive.declaration.dynamics import Dynamics, SecondOrder
from nonsmooth.derive.declaration.parameter import Parameter
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.declaration.transition import Transition
from nonsmooth.derive.document.blocks import Block, Formula, Line, Paragraph
from nonsmooth.derive.document.notation import Notation, enumeration
from nonsmooth.derive.document.template import compose, sentence
from nonsmooth.derive.document.view import Cycle, Described, View
from nonsmooth.derive.symbols import Symbol

# of matrices, by the attribute of the motion that they are
_Letters = dict[tuple[str, sp.Matrix], str]


def system_section(shown: Described) -> list[Block]:
    """Blocks on the name, the states, the parameters and the presentation of a system.

    Substitutions of parameters whose values the orbit requires are left out.
    """
    notation, system, itinerary = shown.notation, shown.declared, shown.itinerary
    size = len(system.states) // 2
    positions, velocities = system.states[:size], system.states[size:]
    # a dwell time may be called as a word of a description is
    described = replace(notation, unknowns=())
    parameters = list(system.parameters)
    moved: list[Line] = []
    substituted: dict[sp.Symbol, sp.Expr] = {}
    presentation = itinerary.presentation if itinerary else None
    if presentation:
        parameters += presentation.parameters
        origins = zip(presentation.states, system.states, presentation.origin, strict=True)
        moved = [notation.relation(n, old - o, tidy=False) for n, old, o in origins if n != old]
        required = shown.equations.required if isinstance(shown, View) else {}
        replaced = presentation.substitution
        declared = (p.symbol for p in system.parameters if p.symbol in replaced)
        substituted = {s: replaced[s] for s in declared if s not in required}
    if itinerary and itinerary.period:
        parameters.append(itinerary.period)
    return compose(
        notation,
        r"""
        The system is *@name*: @description. [second_order: Its state consists of the
        position[many positions: s] @positions and the [many positions: velocities | velocity]
        $@velocities$, a prime being the derivative by time. | Its state is @states. @forcing]

        | Parameter | <Meaning> | Domain | @parameters

        [constraints: The parameters obey $@constraints \ge 0$.]

        [moved: The equations are written in the shifted coordinates]
        $$
        @moved
        $$
        [substituted: [moved: with | The equations are written with] the substitution]
        $$
        @substituted
        $$
        """,
        name=system.name,
        states=system.states,
        description=described.with_formulas(_one_paragraph(system.description)),
        positions=positions,
        velocities={
            v: f"{notation.symbol(x)}'" for v, x in zip(velocities, positions, strict=False)
        },
        forcing=_forcing(notation, system),
        parameters=[
            (
                notation.math(p.symbol),
                described.with_formulas(_one_paragraph(p.description)),
                f"${_domain(p, notation)}$",
            )
            for p in parameters
        ],
        constraints=[c for c in notation.system.constraints if not c.is_nonnegative],
        moved=moved,
        substituted=substituted,
    )


def _one_paragraph(text: str) -> str:
    """Text of a user without its own breaks of lines and paragraphs."""
    return " ".join(text.split())


def _forcing(notation: Notation, system: System) -> str:
    """Sentences on the two states of each harmonic forcing."""
    matrix, _ = system.configurations[0].dynamics.field(system.states)
    return " ".join(
        sentence(
            notation,
            "Of these @pair are the cosine and the sine of the phase of a forcing, which turns with"
            " the frequency $@frequency$.",
            pair=pair,
            frequency=notation.latex(matrix[tuple(map(system.states.index, reversed(pair)))]),
        )
        for pair in system.forcing
    )


def _domain(parameter: Parameter, notation: Notation) -> str:
    """LaTeX of the domain of a parameter."""
    name, lower, upper = map(notation.text, (parameter.symbol, parameter.lower, parameter.upper))
    above, below = (r"\ge", r"\le") if parameter.closed else (">", "<")
    end = r"\le" if parameter.upper_closed else "<"
    if parameter.lower == -sp.oo:
        return rf"{name} \in \mathbb{{R}}" if parameter.upper == sp.oo else f"{name} {end} {upper}"
    if parameter.upper == sp.oo:
        return f"{name} {above} {lower}"
    return f"{lower} {below} {name} {end} {upper}"


def model_section(shown: Described) -> list[Block]:
    """Blocks on what stands behind a system's equations, as it is declared."""
    blocks: list[Block] = []
    for text in map(_one_paragraph, shown.declared.model):
        alone = text.startswith("$") and "$" not in text[1:-1]
        # a line may break behind a wide space
        pieces = tuple(re.split(r"(?<=\\qquad)", text[1:-1]))
        blocks.append(Formula((Line("", "", pieces),)) if alone else Paragraph(text))
    cited = shown.notation.cited("model")
    return blocks + compose(shown, "[cited: This is the model@cited.]", cited=cited)


def configuration_section(shown: Described) -> list[Block]:
    """Blocks with the equations of motion of the configurations, and their boundaries.

    Where flows are not written, also what else holds throughout a configuration.
    """
    notation = shown.notation
    told = isinstance(shown, Cycle) or (shown.itinerary is None and notation.open)
    phases = shown.itinerary.phases if isinstance(shown, View) else ()
    chosen = list(map(notation.system.configuration, notation.names))
    second = [c.dynamics for c in chosen if isinstance(c.dynamics, SecondOrder)]
    letters = _letters(notation, second)
    matrices = [notation.entries(letter, matrix) for (_, matrix), letter in letters.items()]
    if any(len(lines) > 1 for lines in matrices):
        letters, matrices = {}, []
    return compose(
        notation,
        r"""
        [first: Inside a configuration the motion is linear, with the state $@state =
        \left(@column\right)^{\mathsf{T}}$.]

        [second: In [first: those of second order | every configuration] the motion is
        linear[matrices: , $@mass @letter''[damped:  + @damping @letter'] + @stiffness @letter =
        \ell$[held: , and a coordinate that is held keeps its velocity: its row gives the reaction].
        The matrices are | .]]
        $$
        @matrices
        $$
        @motions

        A configuration is left where one of its boundary functions, negative inside, rises through
        zero. [mixed: One that acts when reached is left at a tangency too, one that acts when
        exceeded is not.]

        | Configuration | Boundary | Inside | Acts when | @boundaries

        [constraints: Throughout, @constraints.]
        """,
        first=len(second) < len(chosen),
        second=second,
        mass=notation.matrix_letter("M"),
        damping=notation.matrix_letter("C"),
        stiffness=notation.matrix_letter("K"),
        damped=any(not d.damping.is_zero_matrix for d in second),
        held=any(d.held for d in second),
        matrices=[line for lines in matrices for line in lines],
        motions=[
            block
            for configuration in chosen
            for block in compose(
                notation,
                "*@name*[phases:  (phase[many phases: s] @phases)]@cited(configuration @name):"
                "\n$$\n@lines\n$$",
                name=configuration.name,
                phases=[
                    str(number)
                    for number, phase in enumerate(phases, start=1)
                    if phase.configuration == configuration.name
                ],
                lines=_motion(configuration.dynamics, notation, letters),
            )
        ],
        mixed=len({b.acts_when for c in chosen for b in c.boundaries}) > 1,
        boundaries=[
            (
                "" if position else f"*{configuration.name}*",
                f"*{boundary.name}*",
                notation.math(boundary.function, " < 0"),
                boundary.acts_when,
            )
            for configuration in chosen
            for position, boundary in enumerate(configuration.boundaries)
        ],
        constraints=[
            sentence(notation, "$@c.constraints = 0$ in *@c.name*", c=c)
            for c in chosen
            if told and c.constraints
        ],
    )


def _letters(notation: Notation, motions: Sequence[SecondOrder]) -> _Letters:
    """Letters of M, C and K, numbered where configurations differ in them; none of one mass."""
    found: _Letters = {}
    if all(motion.mass.rows == 1 for motion in motions):
        return found
    for letter, attribute in (("M", "mass"), ("C", "damping"), ("K", "stiffness")):
        matrices = dict.fromkeys(getattr(d, attribute) for d in motions)
        if letter != "C" or any(not m.is_zero_matrix for m in matrices):
            name = notation.matrix_letter(letter)
            for index, matrix in enumerate(matrices, start=1):
                found[attribute, matrix] = f"{name}_{{{index}}}" if len(matrices) > 1 else name
    return found


def _motion(dynamics: Dynamics, notation: Notation, letters: _Letters) -> list[Line]:
    """Lines with the equations of motion.

    They stand in the letters of the matrices, if there are any, unless a coordinate is held:
    then each has a line of its own. That of a single mass has its factors in place.
    """
    states, x = notation.system.states, notation.letter
    if letters and isinstance(dynamics, SecondOrder) and not dynamics.held:
        terms = {"''": "mass", "'": "damping", "": "stiffness"}
        left = " + ".join(
            f"{letters[attribute, matrix]} {x}{primes}"
            for primes, attribute in terms.items()
            for matrix in [getattr(dynamics, attribute)]
            if attribute != "damping" or not matrix.is_zero_matrix
        )
        load = dynamics.load.applyfunc(notation.tidy)
        return [notation.relation(left, "0" if load.is_zero_matrix else notation.latex(load))]
    if isinstance(dynamics, SecondOrder) and len(states) == 2 and not dynamics.held:
        own = notation.symbol(states[0])
        factors = [Symbol("written", f"x{primes}", own + primes) for primes in ("''", "'")]
        coefficients = (dynamics.mass, dynamics.damping, dynamics.stiffness)
        motion = zip(coefficients, (*factors, states[0]), strict=True)
        summands = [matrix[0] * factor for matrix, factor in motion if matrix[0] != 0]
        return [notation.relation(" ".join(notation.signed(summands)), dynamics.load[0])]
    matrix, offset = (part.applyfunc(cancel) for part in dynamics.field(states))
    rates = list(matrix * sp.Matrix(states) + offset)
    held, primes = {}, "'"
    if isinstance(dynamics, SecondOrder):
        rates, held, primes = rates[len(states) // 2 :], dynamics.held_at(states), "''"
    return [
        notation.relation(
            notation.symbol(states[i]) + ("'" if i in held else primes), held.get(i, rate)
        )
        for i, rate in enumerate(rates)
    ]


def transition_section(shown: Described) -> list[Block]:
    """Blocks on which configuration follows which set of boundaries, under which conditions."""
    notation, transitions = shown.notation, shown.notation.system.transitions
    if all(not t.conditions and len(t.boundaries) == 1 for t in transitions):
        return _without_conditions(notation)
    conditions = list(dict.fromkeys(c for t in transitions for c in t.conditions))
    numbers = {c: f"$C_{{{i}}}$" for i, c in enumerate(conditions, start=1)}
    outcomes: dict[tuple[str, tuple[str, ...]], list[tuple[str, str, str]]] = {}
    for transition in transitions:
        event = transition.source, tuple(sorted(transition.boundaries))
        needed = enumeration([numbers[c] for c in transition.conditions]) or "always"
        outcome = f"*{transition.target}*", needed, _reset(transition, notation)
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
        notation,
        """
        Boundaries that are reached at one instant are one transition. Of the configurations named
        for it the first whose conditions hold follows; a reset acts at the same instant and leaves
        the states that it does not name.

        [conditions: ## Conditions]

        [conditions: Where the function vanishes, the first of its derivatives that does not
        decides, along the flow of the named configuration.]

        | Condition | Holds if | Along | @conditions

        ## Rules

        Each rule is a list of configurations; the first that applies is taken.

        | Rule | To | If | Reset | @rules

        ## Events

        | From | <Boundaries> | Rule | @events
        """,
        conditions=[
            (
                number,
                f"{'' if c.holds else 'not '}{notation.math(c.function, ' > 0')}",
                f"*{c.along}*",
            )
            for c, number in numbers.items()
        ],
        rules=[
            (rule if position == 0 else "", *outcome)
            for found, rule in rules.items()
            for position, outcome in enumerate(found)
        ],
        events=[
            (f"*{source}*" if source != before else "", ", or ".join(found), rule)
            for before, ((source, rule), found) in zip(sources, events.items(), strict=False)
        ],
    )


def _without_conditions(notation: Notation) -> list[Block]:
    """Table of transitions that single boundaries decide, one row for each."""
    transitions = notation.system.transitions
    rows = [
        (f"*{t.source}*", *(f"*{b}*" for b in t.boundaries), f"*{t.target}*", _reset(t, notation))
        for t in transitions
    ]
    resets = any(t.reset for t in transitions)
    return compose(
        notation,
        """
        What follows at each boundary[resets: . A reset acts at the same instant; the states that it
        does not name are continuous | ; the state is continuous there].

        | From | Boundary | To |[resets:  Reset |] @rows
        """,
        resets=resets,
        rows=rows if resets else [row[:-1] for row in rows],
    )


def _reset(transition: Transition, notation: Notation) -> str:
    """Formulas for what a transition sets the states to."""
    reset = transition.reset
    rules = ((s, reset[s]) for s in notation.system.states if s in reset)  # Dict's order may change
    return ", ".join(f"${notation.symbol(s)} := {notation.text(e)}$" for s, e in rules)


def law_section(shown: Described) -> list[Block]:
    """Blocks on the contact law, which decides what follows at a contact's boundary."""
    law, math = shown.declared.law, shown.notation.math
    contacts = law.contacts if law else ()
    return compose(
        shown,
        r"""
        The mass matrix couples these contacts: a force on one accelerates others. Where one reaches
        a boundary it is decided together with those at rest, by one law that asks neither for the
        order in which they are declared nor for their directions.

        | Contact | Velocity $r$ | Static limit | Kinetic limit | @limits

        Let the limit $L_i$ be the kinetic one of those that have reached the limit of their force,
        the static one of the others at rest. Their accelerations are those that minimise
        $$
        @distance + \sum_i L_i \left| \dot{r}_i \right| &\to \min
        $$
        with $\ddot{x}_\mathrm{free}$ the accelerations without their forces. All that slip in it
        get their kinetic limit, and so on until none is added; what slides with $r \neq 0$ keeps
        its force. Where a force is at its limit, or $\dot{r}_i = 0$ for what slips, the first
        derivative that does not vanish decides. What that leaves open is ambiguous.

        [stops: Of *@stops*: the minimum is one with $\dot{r} \leq 0$, where stops push.]
        """,
        distance=r"\tfrac{1}{2} \left\| \ddot{x} - \ddot{x}_\mathrm{free} \right\|_M^2",
        limits=[
            (f"*{c.name}*", *map(math, (c.relative, c.static, c.kinetic)))
            for c in contacts
            if c.friction
        ],
        stops=[contact.name for contact in contacts if not contact.friction],
    )


def contact_section(shown: Described) -> list[Block]:
    """Blocks on the contacts: velocities and forces with which the surroundings act."""
    math = shown.notation.math
    rows: list[tuple[str, ...]] = []
    for contact in shown.declared.contacts:
        first = (f"*{contact.name}*", math(contact.velocity), math(contact.surface))
        forces = [(f"*{name}*", math(force)) for name, force in contact.forces.items()]
        for place, force in enumerate(forces or [("", "")]):
            rows.append((*(("", "", "") if place else first), *force))
    return compose(
        shown,
        """
        The surroundings act on the oscillator at its contacts: a force in the direction of the
        velocity of the point there, zero in the configurations that are not named.

        | Contact | Velocity | Surroundings | Configuration | Force | @rows
        """,
        rows=rows,
    )
