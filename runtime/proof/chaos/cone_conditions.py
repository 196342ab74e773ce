"""Cone conditions along coverings: neighbours part, and there is one motion for each history.

In the coordinates x of an h-set N let Q(x) = a u^2 - sum of b_i s_i^2, u the unstable coordinate
and s the stable ones. Where N covers M, let S be a box in N that holds every x of N whose image
is in M, and V any matrix between the least and the largest entries of the derivative of P^k on
S, in the coordinates of N and M. The cone condition with the rate m is that

    V^T Q_M V - m Q_N is positive definite

(P. Zgliczynski, Covering relations, cone conditions and the stable manifold theorem, J.
Differential Equations 246, 2009; H. Kokubu, D. Wilczak and P. Zgliczynski, Rigorous verification
of cocoon bifurcations in the Michelson system, Nonlinearity 20, 2007). S is convex, so that the
mean of the derivative between two of its points is such a matrix.

With y = V_uu u + V_us s in place of u the form becomes

    a_M y^2 - sum of b_i (p_i y + W_i s)^2 - m (a_N (q y - r s)^2 - sum of b_j s_j^2),

q = 1/V_uu, r = V_us/V_uu, p = V_su/V_uu and W = V_ss - V_su V_us/V_uu, in which balls lose little.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import ceil, exp, inf, log, log2
from typing import TYPE_CHECKING, Any, NamedTuple

from nonsmooth.runtime.core.json_codec import Exact
from nonsmooth.runtime.events.leading_derivative import Undecided
from nonsmooth.runtime.proof.chaos.entropy import logarithm_below
from nonsmooth.runtime.proof.chaos.h_sets import Box, HSet, piece
from nonsmooth.runtime.proof.chaos.parts import coordinates, divisible, most_stretched, slices
from nonsmooth.runtime.proof.sets.affine_sets import AffineSet
from nonsmooth.runtime.proof.sets.images import SectionMap

if TYPE_CHECKING:
    from flint import arb_mat

__all__ = ["ConeCondition", "cone_condition", "positive"]

_SPREADS = (1e6, 1.0, 0.4, 0.2, 0.1, 0.05)  # of a derivative, by what it stretches
_SHARES = tuple(Fraction(4) ** k for k in range(-3, 4))  # of the stable coordinates in a form
_SEARCHED = 24  # powers of 2 of rates
_ROUNDS = 30  # of a bisection
_MOST_SLICES = 3  # powers of 2: of a part at once
_MARGIN = Fraction(999, 1000)
_DIGITS = 10**4


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


class _DividedPart(NamedTuple):
    """A part of an h-set and its image; None where the image is not known."""

    box: Box
    image: AffineSet | None
    meets: Mapping[int, bool]  # by target: its image may be in the target
    slopes: Mapping[int, arb_mat]  # by target: the derivative there


def cone_condition(
    mapped: SectionMap,
    sets: Sequence[HSet],
    edges: Sequence[tuple[int, int]],
    most: int,
    progress: Callable[[], object] = lambda: None,
) -> ConeCondition:
    """Prove a cone condition along coverings, at the working precision.

    `edges` tell which set covers which and are strongly connected. At most `most` images of one
    set are computed, and `progress` is called for each. `Undecided` with the reason if no
    condition is proved.
    """
    work = [
        _Derivatives(mapped, sets, k, [j for i, j in edges if i == k], most, progress)
        for k in range(len(sets))
    ]
    trouble = Undecided("no spread of derivatives was tried")
    for spread in _SPREADS:
        for own in work:
            own.refine(spread)
        try:
            return _condition(work, sets, mapped.iterates)
        except Undecided as reason:
            trouble = reason
    raise trouble


class _Derivatives:
    """The derivative of the map over one h-set, part by part."""

    def __init__(
        self,
        mapped: SectionMap,
        sets: Sequence[HSet],
        number: int,
        targets: Sequence[int],
        most: int,
        progress: Callable[[], object],
    ) -> None:
        self.mapped, self.sets, self.number, self.targets = mapped, sets, number, targets
        self.left, self.progress = most, progress
        self.parts = [self._part(((-1.0, 1.0),) * len(sets[number].centre))]

    def _part(self, box: Box) -> _DividedPart:
        from flint import arb_mat

        if not self.left:
            raise Undecided("there are too many parts", digits=False)
        self.left -= 1
        self.progress()
        start = piece(self.sets[self.number], self.mapped.section, box, sloped=True)
        try:
            states = self.mapped.image(start).states
        except Undecided:
            if not divisible(box):
                raise
            return _DividedPart(box, None, dict.fromkeys(self.targets, True), {})
        image = coordinates(states, self.mapped.section.free)
        meets, slopes = {}, {}
        for target in self.targets:
            seen = image.mapped(self.sets[target].inward)
            meets[target] = not any(x > 1 or x < -1 for x in seen.ranges)
            slopes[target] = arb_mat([*zip(*(t.ranges for t in seen.tangents), strict=True)])
        return _DividedPart(box, image, meets, slopes)

    def strip(self, target: int) -> Box:
        """The box around all parts whose image may be in a target."""
        met = [part.box for part in self.parts if part.meets[target]]
        if not met:
            raise Undecided("a covering has no state", digits=False)
        return tuple((min(a for a, _ in x), max(b for _, b in x)) for x in zip(*met, strict=True))

    def refine(self, spread: float) -> None:
        """Divide all parts in a strip over which the derivative varies by too much."""
        while True:
            strips = {target: self.strip(target) for target in self.targets}
            wide = {}
            for part in self.parts:
                met = [j for j, strip in strips.items() if _overlap(part.box, strip)]
                largest = max((_spread(part, j) for j in met), default=0.0)
                if largest > spread and divisible(part.box):
                    wide[part.box] = largest
            if not wide:
                return
            kept = [part for part in self.parts if part.box not in wide]
            for part in self.parts:
                if part.box in wide:
                    k = self._longest(part)
                    count = 2 ** min(_MOST_SLICES, ceil(log2(min(wide[part.box], 1e9) / spread)))
                    usable = count if part.image is not None else 2
                    kept += map(self._part, slices(part.box, k, usable))
            self.parts = kept

    def _longest(self, part: _DividedPart) -> int:
        """The coordinate that is longest before and behind the map together."""
        own = self.sets[self.number]
        if part.image is None:
            return most_stretched(own, part.box, None)
        columns = part.image.columns.tolist()
        sizes = [
            (b - a) / 2 * float(abs(side).sum()) + float(sum(abs(row[1 + k]) for row in columns))
            for k, ((a, b), side) in enumerate(zip(part.box, own.near[1].T, strict=True))
        ]
        return max(range(len(sizes)), key=sizes.__getitem__)

    def hull(self, target: int) -> arb_mat:
        """Balls (d, d) that hold the derivative at every state of the strip to a target."""
        from flint import arb_mat

        strip = self.strip(target)
        inside = [p for p in self.parts if _overlap(p.box, strip)]
        if not all(target in part.slopes for part in inside):
            raise Undecided("a derivative is not known", digits=False)
        found, *others = [part.slopes[target].tolist() for part in inside]
        for rows in others:
            found = [
                [x.union(y) for x, y in zip(own, new, strict=True)]
                for own, new in zip(found, rows, strict=True)
            ]
        return arb_mat(found)


def _overlap(box: Box, strip: Box) -> bool:
    return all(a < d and c < b for (a, b), (c, d) in zip(box, strip, strict=True))


def _spread(part: _DividedPart, target: int) -> float:
    """The radii of a derivative, relative to its stretching entry; inf where it is not known."""
    if target not in part.slopes:
        return inf
    matrix = part.slopes[target]
    size = abs(float(matrix[0, 0].mid()))
    return sum(float(x.rad()) for x in matrix.entries()) / size if size else inf


def _condition(work: Sequence[_Derivatives], sets: Sequence[HSet], iterates: int) -> ConeCondition:
    """The cone condition that follows from the derivatives as they are known."""
    hulls = {(own.number, j): own.hull(j) for own in work for j in own.targets}
    strips = tuple(
        (
            sets[i].name,
            sets[j].name,
            tuple((str(Fraction(a)), str(Fraction(b))) for a, b in work[i].strip(j)),
        )
        for i, j in hulls
    )
    stable = len(sets[0].centre) - 1
    best: tuple[Fraction, Fraction, list[tuple[Fraction, ...]]] | None = None
    for share in _SHARES if stable else _SHARES[:1]:
        found = _rates(hulls, len(sets), (Fraction(1), *[share] * stable))
        if found is not None and (best is None or found[0] > best[0]):
            best = found
    if best is None:
        raise Undecided("derivatives vary too much for one cone condition", digits=False)
    expansion, contraction, forms = best
    if expansion <= 1:
        raise Undecided("the sets are not stretched along every closed walk", digits=False)
    if contraction >= 1:
        raise Undecided("the stable sides do not shrink", digits=False)
    named = {own.name: tuple(map(str, form)) for own, form in zip(sets, forms, strict=True)}
    exponent = logarithm_below(expansion, 2 * iterates)
    return ConeCondition(named, strips, str(expansion), str(contraction), exponent)


def _rates(
    hulls: Mapping[tuple[int, int], arb_mat], count: int, form: tuple[Fraction, ...]
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
        return all(positive(m, forms[j], forms[i], rate) for (i, j), m in hulls.items())

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


def _interval(matrix: arb_mat, form: tuple[Fraction, ...]) -> tuple[float, float] | None:
    """Two rates between which the condition holds, by bisection from inside; None if unknown."""

    def holds(power: float) -> bool:
        return positive(matrix, form, form, Fraction(2.0**power))

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


def positive(
    matrix: arb_mat, behind: Sequence[Fraction], before: Sequence[Fraction], rate: Fraction
) -> bool:
    """Whether V^T Q_M V - m Q_N is proved to be positive definite for all V in balls.

    `matrix` (d, d) is V, from N to M; `behind` and `before` are a and the b of Q_M and of Q_N,
    of length d; `rate` is m.
    """
    from flint import arb, arb_mat

    first, *others = matrix.tolist()
    size = len(first)
    if first[0].contains(0):
        return False
    q, r = 1 / first[0], [x / first[0] for x in first[1:]]
    moved = [
        [row[0] * q, *(x - row[0] * y for x, y in zip(row[1:], r, strict=True))] for row in others
    ]
    kept: list[list[Any]] = [[q, *(-x for x in r)]]
    kept += [[arb(int(j == k)) for j in range(size)] for k in range(1, size)]
    a, *b = map(_ball, behind)
    c, *e = (_ball(rate * x) for x in before)
    weights = [-c, *e]

    def entry(i: int, j: int) -> Any:
        own = a if i == j == 0 else arb(0)
        own = own - sum((w * row[i] * row[j] for w, row in zip(b, moved, strict=True)), arb(0))
        return own + sum(
            (w * row[i] * row[j] for w, row in zip(weights, kept, strict=True)), arb(0)
        )

    whole = [[entry(i, j) for j in range(size)] for i in range(size)]
    return all(bool(arb_mat([row[:k] for row in whole[:k]]).det() > 0) for k in range(1, size + 1))


def _ball(x: Fraction) -> Any:
    from flint import arb, fmpq

    return arb(fmpq(x.numerator, x.denominator))
