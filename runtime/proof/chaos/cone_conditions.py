"""Cone conditions along coverings: which strips, cones and rates may be proved.

In the coordinates x of an h-set N let Q(x) = a u^2 - sum of b_i s_i^2, u the unstable coordinate
and s the stable ones. Where N covers M, let S be a box in N that holds every x of N whose image
is in M, and V any matrix between the least and the largest entries of the derivative of P^k on
S, in the coordinates of N and M. The cone condition with the rate m is that

    V^T Q_M V - m Q_N is positive definite

(P. Zgliczynski, Covering relations, cone conditions and the stable manifold theorem, J.
Differential Equations 246, 2009; H. Kokubu, D. Wilczak and P. Zgliczynski, Rigorous verification
of cocoon bifurcations in the Michelson system, Nonlinearity 20, 2007). S is convex, so that the
mean of the derivative between two of its points is such a matrix. Strips are looked for among
samples in double precision; the checker encloses the derivatives over them, from which cones and
rates are found that it proves.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import exp, inf, log
from typing import TYPE_CHECKING

import numpy as np

from nonsmooth.runtime.checker.state_sets.chaos import (
    SPREADS,
    Derivatives,
    SetMap,
    StretchedSets,
    check_rates,
    positive,
)
from nonsmooth.runtime.checker.stated.exact import Failure, exact
from nonsmooth.runtime.core.json_codec import Exact
from nonsmooth.runtime.proof.chaos.h_sets import HSet, grid_in_cube, logarithm_below
from nonsmooth.runtime.proof.sets.section_choice import FloatSection

if TYPE_CHECKING:
    from nonsmooth.runtime.checker.state_sets.chaos import Matrix

_SHARES = tuple(Fraction(4) ** k for k in range(-3, 4))  # of the stable coordinates in a form
_SEARCHED = 24  # powers of 2 of rates
_ROUNDS = 30  # of a bisection
_MARGIN = Fraction(999, 1000)
_DIGITS = 10**4
_LINE, _ACROSS = 4001, 9  # samples of a set
_SPARE = 0.02  # of a strip's length, at each of its ends
_STEPS = 2**10  # of half a set, in which strips are stated


@dataclass(frozen=True)
class ConeCondition:
    """Quadratic forms of h-sets, and how derivatives change them.

    The form of a set is Q = a u^2 - sum of b_i s_i^2. For each covering of one set by another
    there is a strip: the box in the first one, in its coordinates, that holds every state whose
    image is in the second.
    """

    # of each h-set a and the b of the stable coordinates: positive fractions
    forms: Mapping[str, tuple[Exact, ...]]
    # covering set, covered set, and lower and upper end of each coordinate
    strips: tuple[tuple[str, str, tuple[tuple[Exact, Exact], ...]], ...]
    expansion: Exact  # m > 1: where Q is not negative, it grows by more than m under P^k
    # l < 1: where Q is negative behind P^k, its size becomes less than l of what it was; "0" where
    # no coordinate is stable
    contraction: Exact
    # lower bound, for one iterate of P, of the largest Lyapunov exponent of every motion through
    # the graph: log(m) / (2 k), rounded down
    exponent: Exact


Strip = tuple[tuple[Fraction, Fraction], ...]
Edge = tuple[str, str]


def cone_condition(
    sets: StretchedSets, h_sets: Sequence[HSet], edges: Sequence[Edge], floats: FloatSection
) -> ConeCondition:
    """Find a cone condition along coverings, which the checker proves.

    `edges` tell which set covers which, by name, and are strongly connected. `Failure` with the
    reason if no condition is proved.
    """
    strips = _strips(h_sets, edges, floats, sets.map.iterates)
    work = {
        own.name: Derivatives(
            own.name,
            SetMap(sets, own.name),
            {
                j: tuple((exact(str(a)), exact(str(b))) for a, b in strips[i, j])
                for i, j in edges
                if i == own.name
            },
        )
        for own in h_sets
    }
    trouble = Failure("no spread of derivatives was tried")
    for spread in SPREADS:
        hulls = {
            (name, other): hull
            for name, own in work.items()
            for other, hull in own.hulls(spread).items()
        }
        try:
            found = _condition(hulls, strips, sets.map.iterates)
        except Failure as reason:
            trouble = reason
            continue
        check_rates(vars(found), len(h_sets[0].centre), sets.map.iterates)
        return found
    raise trouble


def _strips(
    h_sets: Sequence[HSet], edges: Sequence[Edge], floats: FloatSection, iterates: int
) -> dict[Edge, Strip]:
    """For each covering a box around the samples of the first set that come to the second."""
    near = {own.name: own.near for own in h_sets}
    size = len(h_sets[0].centre)
    samples = grid_in_cube(size, _LINE, _ACROSS)
    images = {}
    for name in {name for name, _ in edges}:
        centre, sides = near[name]
        points = centre + samples @ sides.T
        for _ in range(iterates):
            points = floats.map(points).points
        images[name] = points
    found = {}
    for name, other in edges:
        centre, sides = near[other]
        seen = np.linalg.solve(sides, (images[name] - centre).T).T
        with np.errstate(invalid="ignore"):
            own = samples[(np.abs(seen) <= 1).all(axis=1)]
        if not len(own):
            raise Failure("a covering has no state")
        low, high = own.min(axis=0), own.max(axis=0)
        spare = _SPARE * (high - low) + 4 / (_LINE - 1)
        spare[1:] += 2 / (_ACROSS - 1)
        ends = zip(np.floor((low - spare) * _STEPS), np.ceil((high + spare) * _STEPS), strict=True)
        found[name, other] = tuple(
            (Fraction(max(int(a), -_STEPS), _STEPS), Fraction(min(int(b), _STEPS), _STEPS))
            for a, b in ends
        )
    return found


def _condition(
    hulls: Mapping[Edge, Matrix], strips: Mapping[Edge, Strip], iterates: int
) -> ConeCondition:
    """The cone condition that follows from derivatives over the strips."""
    names = list(dict.fromkeys(name for name, _ in hulls))
    number = {name: place for place, name in enumerate(names)}
    between = {(number[i], number[j]): hull for (i, j), hull in hulls.items()}
    stable = len(next(iter(hulls.values()))) - 1
    best: tuple[Fraction, Fraction, list[tuple[Fraction, ...]]] | None = None
    for share in _SHARES if stable else _SHARES[:1]:
        found = _rates(between, len(names), (Fraction(1), *[share] * stable))
        if found is not None and (best is None or found[0] > best[0]):
            best = found
    if best is None:
        raise Failure("derivatives vary too much for one cone condition")
    expansion, contraction, forms = best
    if expansion <= 1:
        raise Failure("the sets are not stretched along every closed walk")
    if contraction >= 1:
        raise Failure("the stable sides do not shrink")
    named = {name: tuple(map(str, form)) for name, form in zip(names, forms, strict=True)}
    told = tuple((*edge, tuple((str(a), str(b)) for a, b in strips[edge])) for edge in hulls)
    exponent = logarithm_below(expansion, 2 * iterates)
    return ConeCondition(named, told, str(expansion), str(contraction), exponent)


def _rates(
    hulls: Mapping[tuple[int, int], Matrix], count: int, form: tuple[Fraction, ...]
) -> tuple[Fraction, Fraction, list[tuple[Fraction, ...]]] | None:
    """Expansion, contraction and scaled forms, for one shape of the cones; None if there is none.

    How far an edge stretches is computed first; then sets are scaled so that the edges of the
    walk that stretches least do so evenly.
    """
    between = {edge: _interval(matrix, form) for edge, matrix in hulls.items()}
    if any(found is None for found in between.values()):
        return None
    upper = {edge: found[1] for edge, found in between.items() if found}
    mean, heights = _scales(count, {edge: log(x) for edge, x in upper.items()})
    forms = [tuple(_rounded(exp(height)) * x for x in form) for height in heights]

    def holds(rate: Fraction) -> bool:
        return all(_holds(m, forms[j], forms[i], rate) for (i, j), m in hulls.items())

    expansion = _rounded(exp(mean)) * _MARGIN
    if not holds(expansion):
        return None
    if len(form) == 1:
        return expansion, Fraction(0), forms
    contraction = (
        _rounded(
            max(
                found[0] * float(forms[j][0] / forms[i][0])
                for (i, j), found in between.items()
                if found
            )
        )
        / _MARGIN
    )
    return (expansion, contraction, forms) if holds(contraction) else None


def _interval(matrix: Matrix, form: tuple[Fraction, ...]) -> tuple[float, float] | None:
    """Two rates between which the condition holds, by bisection from inside; None if unknown."""

    def holds(power: float) -> bool:
        return _holds(matrix, form, form, Fraction(2.0**power))

    powers = [k for k in range(-_SEARCHED, _SEARCHED + 1) if holds(k)]
    if not powers:
        return None
    ends = []
    for inside, outside in ((powers[0], powers[0] - 1), (powers[-1], powers[-1] + 1)):
        good, bad = float(inside), float(outside)
        for _ in range(_ROUNDS):
            middle = (good + bad) / 2
            good, bad = (middle, bad) if holds(middle) else (good, middle)
        ends.append(2.0**good)
    return ends[0], ends[1]


def _scales(count: int, logs: Mapping[tuple[int, int], float]) -> tuple[float, list[float]]:
    """The least mean of logarithms on a closed walk, and heights that make all edges reach it.

    R. M. Karp (1978) for the mean; the heights by R. Bellman (1958).
    """
    least = [[0.0] * count]
    for _ in range(count):
        before = least[-1]
        least.append([
            min((before[i] + x for (i, other), x in logs.items() if other == j), default=inf)
            for j in range(count)
        ])  # fmt: skip
    last = least[-1]
    means = [
        max((last[j] - least[k][j]) / (count - k) for k in range(count))
        for j in range(count)
        if last[j] < inf
    ]
    mean = min(means)
    heights = [0.0] * count
    for _ in range(count):
        for (i, j), x in logs.items():
            heights[i] = min(heights[i], heights[j] + x - mean)
    return mean, heights


def _rounded(x: float) -> Fraction:
    """A fraction with few digits next to a positive number."""
    scale = Fraction(10) ** round(log(x) / log(10))
    return Fraction(round(Fraction(x) / scale * _DIGITS), _DIGITS) * scale


def _holds(
    matrix: Matrix, behind: Sequence[Fraction], before: Sequence[Fraction], rate: Fraction
) -> bool:
    own, other = ([exact(str(x)) for x in form] for form in (behind, before))
    return positive(matrix, own, other, exact(str(rate)))
