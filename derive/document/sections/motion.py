"""The section of a document on configurations: their equations of motion and their boundaries."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from nonsmooth.derive.declaration.algebra import cancel
from nonsmooth.derive.declaration.configuration import Configuration
from nonsmooth.derive.declaration.dynamics import FirstOrder, SecondOrder
from nonsmooth.derive.document.blocks import Block, Formula, Line, Table
from nonsmooth.derive.document.layout import LINE_WIDTH, width
from nonsmooth.derive.document.notation.wording import Naming
from nonsmooth.derive.document.sections.template import (
    beside,
    compose,
    math,
    relation,
    with_signs,
    zeros,
)

__all__ = ["configuration_section"]

# of matrices, by the attribute of the motion that they are
_Letters = dict[tuple[str, sp.Matrix], str]

# em that relations side by side leave between them
_BETWEEN = 2.0


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
    damped = any(not sp.Matrix(d.damping).is_zero_matrix for d in second)
    held = any(d.held for d in second)
    single = all(d.mass.rows == 1 for d in second)
    # masses stay on the left where nothing is held and they are not all one
    heavy = not held and any(d.mass != sp.eye(d.mass.rows) for d in second)
    matrices, letters = ([], {}) if single else _matrices(second, naming, damped)
    motions: list[Block] = []
    for configuration in chosen:
        name = configuration.name
        motions += compose(
            naming,
            "*@name*@remark@cited:\n\n@motion",
            name=name,
            remark=(remarks or {}).get(name, ""),
            cited=naming.cited(f"configuration {name}"),
            motion=_motion(configuration, naming, letters if heavy else {}),
        )
    return compose(
        naming,
        r"""
        [first: Inside a configuration the motion is linear, with the state $@state =
        \left(@column\right)^{\mathsf{T}}$.]

        [single: The motion is linear in @where.]

        [matrices: In @where the motion is linear, $M @letter''[damped:  + C @letter'] + K @letter =
        \ell$[held: , and a coordinate that is held keeps its velocity: its row gives the
        reaction]. The matrices are]
        $$
        @matrices
        $$
        [solved: Solved for the accelerations[held: , with the rows of the held coordinates set to
        zero], the equations of motion are as follows.]

        @motions

        A configuration is left where one of its boundary functions, negative inside, rises through
        zero. [mixed: One that acts when reached is left at a tangency too, one that acts when
        exceeded is not.]

        @boundaries

        [constraints: Throughout, @constraints.]
        """,
        first=len(second) < len(chosen),
        column=", ".join(map(naming.notation.symbol, naming.system.states)),
        where="every configuration" if len(second) == len(chosen) else "those of second order",
        single=second and single,
        damped=damped,
        held=held,
        matrices=matrices,
        solved=not (heavy or single),
        motions=motions,
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


def _matrices(
    motions: Sequence[SecondOrder], naming: Naming, damped: bool
) -> tuple[list[Line], _Letters]:
    """M, C and K, and their letters, numbered where configurations differ in them."""
    shown: _Letters = {}
    pieces: list[str] = []
    attributes = {"M": "mass", "C": "damping", "K": "stiffness"}
    for letter, attribute in attributes.items():
        if letter == "C" and not damped:
            continue
        different = list(dict.fromkeys(getattr(d, attribute) for d in motions))
        for index, matrix in enumerate(different, start=1):
            name = letter if len(different) == 1 else f"{letter}_{{{index}}}"
            shown[attribute, matrix] = name
            pieces += _written(naming, name, matrix)
    *others, last = beside(pieces)
    return [Line("", "", (*others, f"{last}."))], shown


def _written(naming: Naming, name: str, matrix: sp.Matrix) -> list[str]:
    """LaTeX of a matrix, or of its nonzero entries if it is too wide for a line."""
    text = f"{name} = {naming.notation.latex(matrix)}"
    if width(text) <= LINE_WIDTH:
        return [text]
    size = matrix.rows
    comma = "," if size > 9 else ""
    return [
        rf"{name}^{{{i + 1}{comma}{j + 1}}} = {naming.notation.latex(matrix[i, j])}"
        for i in range(size)
        for j in range(size)
        if matrix[i, j] != 0
    ]


def _motion(configuration: Configuration, naming: Naming, letters: _Letters) -> list[Block]:
    """Blocks with the equations of motion, in the letters of the matrices if given."""
    notation, dynamics, states = naming.notation, configuration.dynamics, naming.system.states
    matrix, offset = (part.applyfunc(cancel) for part in dynamics.field(states))
    if isinstance(dynamics, FirstOrder):
        return _first_order(naming, matrix, offset)
    x, size = naming.letter, dynamics.mass.rows
    if size == 1 and not dynamics.held:
        return [_single(naming, dynamics)]
    if letters:
        factors = [
            letters["mass", dynamics.mass],
            letters.get(("damping", dynamics.damping)),
            letters["stiffness", dynamics.stiffness],
        ]
        load, held = dynamics.load, []
        vanishing = (False, dynamics.damping.is_zero_matrix, False)
    else:
        parts = (-matrix[size:, size:], -matrix[size:, :size])
        factors = ["", *map(notation.latex, parts)]
        load, held = offset[size:, :], sorted(dynamics.held_at(states).items())
        vanishing = (False, *(part.is_zero_matrix for part in parts))
    left = " + ".join(
        f"{factor} {x}{primes}".strip()
        for factor, primes, zero in zip(factors, ("''", "'", ""), vanishing, strict=True)
        if not zero
    )
    if not letters and (size == 1 or width(left) + width(_load(naming, load, held)) > LINE_WIDTH):
        return [_accelerations(naming, dynamics, matrix, offset)]
    return [Formula((Line(left, "=", (_load(naming, load, held),)),))]


def _load(naming: Naming, load: sp.Matrix, held: Sequence[tuple[int, sp.Expr]]) -> str:
    """LaTeX of the load on the coordinates, and of the velocities of the held ones."""
    notation = naming.notation
    right = "0" if load.is_zero_matrix else notation.latex(load.applyfunc(notation.tidy))
    velocities = [
        rf"{notation.symbol(naming.system.states[i])}' = {notation.latex(v)}" for i, v in held
    ]
    return r",\quad ".join([right, *velocities])


def _single(naming: Naming, dynamics: SecondOrder) -> Formula:
    """Equation of motion of a single coordinate, with mass, damping and stiffness."""
    x = naming.notation.symbol(naming.system.states[0])
    parts = {"''": dynamics.mass, "'": dynamics.damping, "": dynamics.stiffness}
    terms = [
        (sign, f"{'' if text == '1' else f'{text} '}{x}{primes}")
        for primes, matrix in parts.items()
        if matrix[0] != 0
        for sign, text in [naming.notation.factor(matrix[0])]
    ]
    return Formula((relation(naming, " ".join(with_signs(terms)), dynamics.load[0]),))


def _accelerations(
    naming: Naming, dynamics: SecondOrder, matrix: sp.Matrix, offset: sp.Matrix
) -> Formula:
    """Formula of the accelerations, one line for each coordinate."""
    states, size = naming.system.states, dynamics.mass.rows
    held = dynamics.held_at(states)
    rows = matrix * sp.Matrix(states) + offset
    return Formula(
        tuple(
            relation(
                naming,
                naming.notation.symbol(states[i]) + ("'" if i in held else "''"),
                held.get(i, rows[size + i]),
            )
            for i in range(size)
        )
    )


def _first_order(naming: Naming, matrix: sp.Matrix, offset: sp.Matrix) -> list[Block]:
    """Blocks with the equations state by state, then in matrices if those are narrow."""
    pieces = [f"{naming.notation.latex(matrix)} {naming.state}"]
    if not offset.is_zero_matrix:
        pieces.append(f"+ {naming.notation.latex(offset)}")
    narrow = matrix.rows > 1 and sum(map(width, (naming.state, *pieces))) <= LINE_WIDTH - 4
    return compose(
        naming,
        """
        $$
        @rates
        $$
        [narrow: or, in matrices,]
        $$
        @matrices
        $$
        """,
        rates=_rates(naming, matrix, offset),
        narrow=narrow,
        matrices=[relation(naming, f"{naming.state}'", tuple(pieces))] if narrow else [],
    )


def _rates(naming: Naming, matrix: sp.Matrix, offset: sp.Matrix) -> list[Line]:
    """Lines of the states' derivatives by time, short ones side by side."""
    lines: list[Line] = []
    used = 0.0
    rates = matrix * sp.Matrix(naming.system.states) + offset
    for symbol, right in zip(naming.system.states, rates, strict=True):
        line = relation(naming, f"{naming.notation.symbol(symbol)}'", right)
        needed = width(line.latex)
        if lines and used + needed + _BETWEEN <= LINE_WIDTH:
            before = lines.pop()
            parts = (*(before.parts or (before,)), line)
            pieces = (*before.pieces[:-1], rf"{before.pieces[-1]},\qquad", line.latex)
            lines.append(Line(before.left, "=", pieces, parts=parts))
            used += needed + _BETWEEN
        else:
            lines.append(line)
            used = needed
    return lines
