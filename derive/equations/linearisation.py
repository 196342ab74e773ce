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
from nonsmooth.derive.equations.program import Program, Stages, assign, assign_matrix, filled
from nonsmooth.derive.symbols import Symbol, derivative


def sensitivities(chain: Chain, unknowns: Sequence[sp.Symbol]) -> tuple[Stages, list[sp.Matrix]]:
    """Stages and derivatives (N x n) of the states at all ends of phases and behind the last.

    Columns follow `unknowns` (coordinates of the start, then dwell times). By the chain
    rule S' = Phi S + f e^T, with f the vector field at the end and e the derivatives of the
    phase's dwell time.
    """
    embedding = chain.start.embedding
    others = sp.zeros(embedding.rows, len(unknowns) - embedding.cols)
    matrix = sp.Matrix.hstack(embedding, others)
    stages, ends = [], []
    for index, link in enumerate(chain.links, start=1):
        moved = sp.Matrix(link.transfer * matrix)
        for column, unknown in enumerate(unknowns):
            moved[:, column] += sp.diff(link.duration, unknown) * link.velocity
        names = [derivative(Symbol("state", s, index), u) for s in link.states for u in unknowns]
        step, end = assign_matrix(f"derivatives of the state after {link.dwell}", names, moved)
        ends.append(end)
        matrix = link.reset * end
        stages.append(step)
    return tuple(stages), [*ends, matrix]


def poincare_jacobian(chain: Chain) -> Program:
    """Stages and Jacobian (d x d) of the Poincare map, a product of local maps (Sec. 4).

    Each phase carries a perturbation by Phi and projects it along the vector field onto its
    exit boundary, (I - f n/(n f)) Phi; the transition's reset follows.
    """
    matrix, stages, columns = chain.directions, [], chain.coordinates
    for index, link in enumerate(chain.links, start=1):
        behind = [Symbol("state", s, index) for s in link.states]
        names = [derivative(Symbol("carried", s), q) for s in behind for q in columns]
        step, carried = assign_matrix(f"Phi along {link.dwell}", names, link.transfer * matrix)
        velocity = link.velocity
        rate, (speed,) = assign(
            f"rate of the exit boundary after {link.dwell}",
            [Symbol("rate", index)],
            [(link.normal * velocity)[0]],
        )
        delay, delays = assign_matrix(
            f"derivatives of the time to the boundary after {link.dwell}",
            [derivative(Symbol("delay", link.dwell), q) for q in columns],
            -(link.normal * carried) / speed,
        )
        names = [derivative(Symbol("on boundary", s), q) for s in behind for q in columns]
        landing, matrix = assign_matrix(
            f"perturbation on the boundary after {link.dwell}",
            names,
            link.reset * (carried + velocity * delays),
        )
        stages += [step, rate, delay, landing]
    return Program(tuple(stages), chain.returning(matrix))


def saltation_matrix(
    reset: sp.Matrix, normal: sp.Matrix, before: sp.Matrix, behind: sp.Matrix
) -> sp.Matrix:
    """Saltation matrix (N x N) of one transition.

    It is R + (behind - R before) normal/(normal before), with the linear part R (N x N) of
    the reset, the gradient (1 x N) of the boundary and the vector fields (N x 1) in front
    of the transition and behind it.
    """
    return reset + (behind - reset * before) * normal / (normal * before)[0]


def saltation_matrices(chain: Chain) -> tuple[Stages, list[sp.Matrix]]:
    """Stages and saltation matrix (N x N) of each transition along an orbit."""
    stages, matrices = [], []
    for index, link in enumerate(chain.links, start=1):
        following = chain.links[index % len(chain.links)].flow
        sides = ("field before", "field behind")
        names = [Symbol(side, s, index) for side in sides for s in link.states]
        fields = sp.Matrix.vstack(link.velocity, following.velocity(link.following))
        step, fields = assign_matrix(f"vector fields at transition {index}", names, fields)
        size = len(link.states)
        stages.append(step)
        matrices.append(
            saltation_matrix(link.reset, link.normal, fields[:size, :], fields[size:, :])
        )
    return filled(stages), matrices


def monodromy(chain: Chain) -> Program:
    """Stages and monodromy matrix (N x N): the product of S Phi over all phases."""
    size = len(chain.links[0].states)
    found, matrices = saltation_matrices(chain)
    stages, product = list(found), sp.eye(size)
    places = [(i, j) for i in range(size) for j in range(size)]
    for index, (link, saltation) in enumerate(zip(chain.links, matrices, strict=True), start=1):
        for title, factor in (("Phi", link.transfer), ("saltation", saltation)):
            names = [Symbol("product", title.lower(), index, i, j) for i, j in places]
            step, product = assign_matrix(f"{title} of phase {index}", names, factor * product)
            stages.append(step)
    return Program(tuple(stages), product)
