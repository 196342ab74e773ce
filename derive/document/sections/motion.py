"""The section of a document on configurations: their equations of motion and their boundaries."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from nonsmooth.derive.declaration.algebra import cancel
from nonsmooth.derive.declaration.dynamics import Dynamics, SecondOrder
from nonsmooth.derive.document.blocks import Block, Line, Table
from nonsmooth.derive.document.sections.template import (
    by_entries,
    compose,
    math,
    relation,
    zeros,
)
from nonsmooth.derive.document.wording import Naming
from nonsmooth.derive.symbols import Symbol

# of matrices, by the attribute of the motion that they are
_Letters = dict[tuple[str, sp.Matrix], str]


def configuration_section(
    naming: Naming,
    names: Sequence[str],
    remarks: Mapping[str, str] | None = None,
    *,
    constrained: bool = False,
) -> list[Block]:
    """Blocks with the equations of motion of the named configurations, and their boundaries.

    With `constrained`, also what else holds throughout a configuration. `remarks` stand behind
    the names of configurations.
    """
    chosen = [naming.system.configuration(name) for name in names]
    second = [c.dynamics for c in chosen if isinstance(c.dynamics, SecondOrder)]
    damped = any(not d.damping.is_zero_matrix for d in second)
    held = any(d.held for d in second)
    plain = {letter: naming.notation.matrix(letter) for letter in "MCK"}
    letters = _letters(second, plain) if any(d.mass.rows > 1 for d in second) else {}
    matrices = [by_entries(naming, letter, matrix) for (_, matrix), letter in letters.items()]
    if any(len(lines) > 1 for lines in matrices):
        letters, matrices = {}, []
    return compose(
        naming,
        r"""
        [first: Inside a configuration the motion is linear, with the state $@state =
        \left(@column\right)^{\mathsf{T}}$.]

        [second: In @where the motion is linear[matrices: , $@mass @letter''[damped:  + @damping
        @letter'] + @stiffness @letter = \ell$[held: , and a coordinate that is held keeps its
        velocity: its row gives the reaction]. The matrices are | .]]
        $$
        @matrices
        $$
        @motions

        A configuration is left where one of its boundary functions, negative inside, rises through
        zero. [mixed: One that acts when reached is left at a tangency too, one that acts when
        exceeded is not.]

        @boundaries

        [constraints: Throughout, @constraints.]
        """,
        first=len(second) < len(chosen),
        second=second,
        column=", ".join(map(naming.notation.symbol, naming.system.states)),
        where="every configuration" if len(second) == len(chosen) else "those of second order",
        mass=plain["M"],
        damping=plain["C"],
        stiffness=plain["K"],
        damped=damped,
        held=held,
        matrices=[line for lines in matrices for line in lines],
        motions=[
            block
            for configuration in chosen
            for block in compose(
                naming,
                "*@name*@remark@cited:\n$$\n@lines\n$$",
                name=configuration.name,
                remark=(remarks or {}).get(configuration.name, ""),
                cited=naming.cited(f"configuration {configuration.name}"),
                lines=_motion(configuration.dynamics, naming, letters),
            )
        ],
        mixed=len({b.acts_when for c in chosen for b in c.boundaries}) > 1,
        boundaries=Table(
            ("Configuration", "Boundary", "Inside", "Acts when"),
            tuple(
                (
                    "" if position else f"*{configuration.name}*",
                    f"*{boundary.name}*",
                    math(naming, boundary.function, " < 0"),
                    boundary.acts_when,
                )
                for configuration in chosen
                for position, boundary in enumerate(configuration.boundaries)
            ),
        ),
        constraints=[
            f"{zeros(naming, c.constraints)} in *{c.name}*"
            for c in chosen
            if constrained and c.constraints
        ],
    )


def _letters(motions: Sequence[SecondOrder], plain: Mapping[str, str]) -> _Letters:
    """Letters of M, C and K, numbered where configurations differ in them."""
    found: _Letters = {}
    for letter, attribute in (("M", "mass"), ("C", "damping"), ("K", "stiffness")):
        matrices = dict.fromkeys(getattr(d, attribute) for d in motions)
        if letter != "C" or any(not m.is_zero_matrix for m in matrices):
            for index, matrix in enumerate(matrices, start=1):
                name = f"{plain[letter]}_{{{index}}}" if len(matrices) > 1 else plain[letter]
                found[attribute, matrix] = name
    return found


def _motion(dynamics: Dynamics, naming: Naming, letters: _Letters) -> list[Line]:
    """Lines with the equations of motion.

    They stand in the letters of the matrices, if there are any, unless a coordinate is held:
    then each has a line of its own. That of a single mass has its factors in place.
    """
    notation, states, x = naming.notation, naming.system.states, naming.letter
    if letters and isinstance(dynamics, SecondOrder) and not dynamics.held:
        terms = {"''": "mass", "'": "damping", "": "stiffness"}
        left = " + ".join(
            f"{letters[attribute, matrix]} {x}{primes}"
            for primes, attribute in terms.items()
            if attribute != "damping" or not dynamics.damping.is_zero_matrix
            for matrix in [getattr(dynamics, attribute)]
        )
        load = dynamics.load.applyfunc(notation.tidy)
        return [Line(left, "=", ("0" if load.is_zero_matrix else notation.latex(load),))]
    if isinstance(dynamics, SecondOrder) and len(states) == 2 and not dynamics.held:
        own = notation.symbol(states[0])
        factors = [Symbol("written", f"x{primes}", own + primes) for primes in ("''", "'")]
        coefficients = (dynamics.mass, dynamics.damping, dynamics.stiffness)
        motion = zip(coefficients, (*factors, states[0]), strict=True)
        summands = [matrix[0] * factor for matrix, factor in motion if matrix[0] != 0]
        return [relation(naming, " ".join(notation.signed(summands)), dynamics.load[0])]
    matrix, offset = (part.applyfunc(cancel) for part in dynamics.field(states))
    rates = list(matrix * sp.Matrix(states) + offset)
    held, primes = {}, "'"
    if isinstance(dynamics, SecondOrder):
        rates, held, primes = rates[len(states) // 2 :], dynamics.held_at(states), "''"
    return [
        relation(
            naming, notation.symbol(states[i]) + ("'" if i in held else primes), held.get(i, e)
        )
        for i, e in enumerate(rates)
    ]
