"""The section of a document on energy, where it is a first integral along an orbit."""

from __future__ import annotations

import sympy as sp

from nonsmooth.derive.declaration.dynamics import SecondOrder
from nonsmooth.derive.document.blocks import Block, Formula, Line, Paragraph
from nonsmooth.derive.document.notation.wording import enumeration
from nonsmooth.derive.document.views.view import View

__all__ = ["energy_section"]


def energy_section(view: View) -> list[Block]:
    """Blocks on the energy of each configuration, its changes, and the multiplier 1."""
    energies = {name: _energy(view, name) for name in view.flows}
    naming = view.naming
    blocks: list[Block] = [
        Paragraph(
            "No coordinate is held, nothing damps, and the matrices are symmetric: inside each"
            " configuration the energy is constant. With its constant chosen for each"
            " configuration,"
            if len(energies) > 1
            else "No coordinate is held, nothing damps, and the matrices are symmetric: inside the"
            " configuration the energy is constant,"
        ),
        Formula(
            tuple(
                Line(
                    f"2 {_letter(name)}",
                    "=",
                    naming.notation.signed(terms),
                    None,
                    sp.Add(*terms),
                )
                for name, terms in energies.items()
            )
        ),
        *_changes(view, {name: sp.Add(*terms) / 2 for name, terms in energies.items()}),
    ]
    state = naming.state
    blocks.append(
        Paragraph(
            "Energy is a first integral, on the orbit and on every motion near it: its"
            rf" gradient at ${state}^{{(0)}}$ is a left eigenvector of $\mathcal{{M}}$ to the"
            " eigenvalue 1, orthogonal to the right eigenvector $f_{0}^{+}$. So 1 is an eigenvalue"
            r" of $\mathcal{M}$ at least twice, and of $J$ at least once: the trivial multiplier of"
            " the family of orbits in which the energy varies."
        )
    )
    return blocks


def _letter(name: str) -> str:
    return rf"E_{{\text{{{name}}}}}"


def _energy(view: View, name: str) -> list[sp.Expr]:
    """Terms of twice the energy as squares, up to a constant: masses, springs, grounds."""
    system = view.naming.system
    dynamics = system.configuration(name).dynamics
    if not isinstance(dynamics, SecondOrder):
        raise TypeError(f"{name} is no second-order motion")
    size = dynamics.mass.rows
    x, v = system.states[:size], system.states[size:]
    stiffness, load = dynamics.stiffness, dynamics.load
    terms = [
        dynamics.mass[i, j] * v[i] * v[j] * (1 if i == j else 2)
        for i in range(size)
        for j in range(i, size)
    ]
    terms += [
        -stiffness[i, j] * (x[i] - x[j]) ** 2 for i in range(size) for j in range(i + 1, size)
    ]
    for i in range(size):
        ground = sp.factor(sum(stiffness[i, :]))
        if ground != 0:
            terms.append(ground * (x[i] - sp.cancel(load[i] / ground)) ** 2)
        else:
            terms.append(-2 * load[i] * x[i])
    return [t for t in terms if t != 0]


def _changes(view: View, energies: dict[str, sp.Expr]) -> list[Block]:
    """Blocks on the change of energy by each transition."""
    itinerary, system, _ = view.undecided
    notation, states = view.naming.notation, system.states
    lines, continuous = [], []
    for index, phase in enumerate(itinerary.phases):
        transition = itinerary.transition_after(system, index)
        image = transition.reset_of(sp.Matrix(states), states)
        behind = energies[transition.target]
        behind = behind.subs(dict(zip(states, image, strict=True)), simultaneous=True)
        change = sp.expand(behind - energies[phase.configuration])
        change = min(sp.factor(change), sp.factor_terms(change), key=sp.count_ops)
        boundary = system.configuration(phase.configuration).boundary(phase.boundary).function
        fixed = next(s for s in states if sp.diff(boundary, s) != 0)
        where = f"${notation.symbol(fixed)} = {notation.latex(sp.solve(boundary, fixed)[0])}$"
        left = f"{_letter(transition.target)}^{{+}} - {_letter(phase.configuration)}"
        if change == 0:
            continuous.append(f"*{phase.boundary}*")
        else:
            lines.append((left, change, where))
    blocks: list[Block] = []
    if lines:
        blocks += [
            Paragraph(
                "At the transition it changes by"
                if len(lines) == 1
                else "At the transitions it changes by"
            ),
            Formula(
                tuple(
                    Line(left, "=", (notation.latex(change) + ",",), None, change)
                    for left, change, _ in lines
                )
            ),
            Paragraph(f"which is zero {_because(view, [w for _, _, w in lines])}."),
        ]
    if continuous:
        blocks.append(Paragraph(f"At {enumeration(continuous)} it does not change."))
    return blocks


def _because(view: View, boundaries: list[str]) -> str:
    """Text that says why the changes are zero.

    The reason is the values that the orbit requires, or else the boundary itself.
    """
    required = view.equations.required
    notation = view.naming.notation
    if required:
        return "with " + enumeration(
            [f"${notation.symbol(p)} = {notation.latex(v)}$" for p, v in required.items()]
        )
    return f"on the boundary {enumeration(list(dict.fromkeys(boundaries)))}"
