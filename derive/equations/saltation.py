"""Saltation matrices: how a perturbation passes a transition (Sec. 4).

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
from nonsmooth.derive.symbols import Symbol

__all__ = ["monodromy", "saltation_matrices", "saltation_matrix"]


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
