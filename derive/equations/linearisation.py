"""How perturbations of the start pass along a chain: by phases and by transitions (Sec. 4).

A perturbed motion reaches the boundary earlier or later. To first order in the time that it
is off, its perturbation behind the transition is S times the one in front of it,

    S = R + (f+ - R f-) n / (n f-),

with the reset's matrix R, the gradient n of the boundary, and the vector fields f- in front
and f+ behind. The monodromy matrix is the product of S Phi over all phases. It maps f at
the start to itself, and its other eigenvalues are the multipliers of the Poincare map.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from nonsmooth.derive.equations.chain import Chain
from nonsmooth.derive.equations.program import Stage, assign
from nonsmooth.derive.symbols import Symbol, derivative

__all__ = [
    "monodromy",
    "poincare_jacobian",
    "saltation_matrices",
    "saltation_matrix",
    "sensitivities",
]


def sensitivities(
    chain: Chain, states: Sequence[sp.Symbol], unknowns: Sequence[sp.Symbol]
) -> tuple[tuple[Stage, ...], list[sp.Matrix]]:
    """Stages and derivatives (N x n) of the states at all ends of phases and behind the last.

    Columns follow `unknowns` (coordinates of the start, then dwell times). By the chain
    rule S' = Phi S + f e^T, with f the vector field at the end and e the derivatives of the
    phase's dwell time.
    """
    columns = len(unknowns)
    matrix = sp.Matrix.hstack(
        chain.start.embedding, sp.zeros(len(states), columns - chain.start.dimension)
    )
    stages, ends = [], []
    for index, link in enumerate(chain.links):
        moved = sp.Matrix(link.transfer * matrix)
        for column, unknown in enumerate(unknowns):
            moved[:, column] += sp.diff(link.duration, unknown) * link.velocity
        behind = [Symbol("state", s, index + 1) for s in states]
        names = [derivative(s, u) for s in behind for u in unknowns]
        step, values = assign(f"derivatives of the state after {link.dwell}", names, moved)
        ends.append(sp.Matrix(len(states), columns, values))
        matrix = link.reset * ends[-1]
        stages.append(step)
    return tuple(stages), [*ends, matrix]


def poincare_jacobian(
    chain: Chain, states: Sequence[sp.Symbol]
) -> tuple[tuple[Stage, ...], sp.Matrix]:
    """Stages and Jacobian (d x d) of the Poincare map, a product of local maps (Sec. 4).

    Each phase carries a perturbation by Phi and projects it along the vector field onto its
    exit boundary, (I - f n/(n f)) Phi; the transition's reset follows.
    """
    matrix, stages, columns = chain.directions, [], chain.coordinates
    for index, link in enumerate(chain.links):
        behind = [Symbol("state", s, index + 1) for s in states]
        names = [derivative(Symbol("carried", s), q) for s in behind for q in columns]
        step, values = assign(f"Phi along {link.dwell}", names, link.transfer * matrix)
        carried = sp.Matrix(len(states), len(columns), values)
        velocity = link.velocity
        rate, (speed,) = assign(
            f"rate of the exit boundary after {link.dwell}",
            [Symbol("rate", index + 1)],
            [(link.normal * velocity)[0]],
        )
        delays = [-(link.normal * carried[:, j])[0] / speed for j in range(len(columns))]
        delay, values = assign(
            f"derivatives of the time to the boundary after {link.dwell}",
            [derivative(Symbol("delay", link.dwell), q) for q in columns],
            delays,
        )
        projected = carried + velocity * sp.Matrix(1, len(columns), values)
        names = [derivative(Symbol("on boundary", s), q) for s in behind for q in columns]
        landing, values = assign(
            f"perturbation on the boundary after {link.dwell}", names, link.reset * projected
        )
        matrix = sp.Matrix(len(states), len(columns), values)
        stages += [step, rate, delay, landing]
    return tuple(stages), chain.returning(matrix)


def saltation_matrix(
    reset: sp.Matrix, normal: sp.Matrix, before: sp.Matrix, behind: sp.Matrix
) -> sp.Matrix:
    """Saltation matrix (N x N) of one transition.

    It is R + (behind - R before) normal/(normal before), with the linear part R (N x N) of
    the reset, the gradient (1 x N) of the boundary and the vector fields (N x 1) in front
    of the transition and behind it.
    """
    return reset + (behind - reset * before) * normal / (normal * before)[0]


def saltation_matrices(
    chain: Chain, states: Sequence[sp.Symbol]
) -> tuple[tuple[Stage, ...], list[sp.Matrix]]:
    """Stages and saltation matrix (N x N) of each transition along an orbit."""
    stages, matrices = [], []
    fields = [link.flow for link in chain.links]
    for index, link in enumerate(chain.links):
        following = fields[(index + 1) % len(fields)]
        sides = ("field before", "field behind")
        names = [Symbol(side, s, index + 1) for side in sides for s in states]
        velocities = [*link.velocity, *following.velocity(link.following)]
        step, values = assign(f"vector fields at transition {index + 1}", names, velocities)
        before, behind = (sp.Matrix(v) for v in (values[: len(states)], values[len(states) :]))
        stages.append(step)
        matrices.append(saltation_matrix(link.reset, link.normal, before, behind))
    return tuple(s for s in stages if s.assignments), matrices


def monodromy(chain: Chain, states: Sequence[sp.Symbol]) -> tuple[tuple[Stage, ...], sp.Matrix]:
    """Stages and monodromy matrix (N x N): the product of S Phi over all phases."""
    size = len(states)
    found, matrices = saltation_matrices(chain, states)
    stages, product = list(found), sp.eye(size)
    for index, (link, saltation) in enumerate(zip(chain.links, matrices, strict=True), start=1):
        for title, factor in (("Phi", link.transfer), ("saltation", saltation)):
            places = [(i, j) for i in range(size) for j in range(size)]
            names = [Symbol("product", title.lower(), index, i, j) for i, j in places]
            step, values = assign(f"{title} of phase {index}", names, factor * product)
            stages.append(step)
            product = sp.Matrix(size, size, values)
    return tuple(stages), product
