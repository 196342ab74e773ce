"""The compiled crossing search alone, on random sums that are hard on it, checked one by one."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable

import numpy as np
from stressing import EPS, Ball, Shape, Sums, first_excess, undecided

from nonsmooth.runtime.model.engine_run import Status
from nonsmooth.runtime.model.kernels import compiled_engine
from nonsmooth.runtime.model.structure import (
    BoundaryShape,
    ModeShape,
    Structure,
    TransitionShape,
)
from nonsmooth.runtime.simulation.engines import run_motions

_STATES = 8  # a search judges the start by as many derivatives
_ALLOWED = 64 * EPS
PROVED = 0.002  # share that is proved in balls as a whole


def structure_of(shape: Shape, reached: bool) -> Structure:
    """A structure of one configuration with one boundary, which leads back to itself."""
    modes, first = [], 0
    for length, oscillates in shape:
        count = length * (1 + oscillates)
        modes.append(ModeShape(length, oscillates, tuple(range(first, first + count))))
        first += count
    return Structure(
        "sum",
        tuple(f"y{i}" for i in range(_STATES)),
        ("all",),
        (tuple(modes),),
        ((),),
        ((),),
        ((BoundaryShape("zero", 0, reached),),),
        ((TransitionShape(frozenset({0}), (), 0, 0),),),
        (),
        1,
        1,
    )


def search(sums: Sums, until: np.ndarray, reached: bool) -> tuple[np.ndarray, np.ndarray]:
    """Time at which each sum is first zero (or `until`), and whether it was found."""
    count, functions = sums.values.shape
    n, modes = _STATES, sums.exponents.shape[1]
    row = np.eye(1, n + 1)
    identity = np.eye(n, n + 1)
    flows = np.zeros((count, functions, n, n + 1))
    flows[:, :, 0, n] = sums.values
    fixed = np.concatenate([np.zeros(n * (n + 1)), row.ravel(), identity.ravel()])
    numbers = np.concatenate(
        [
            np.broadcast_to(fixed, (count, fixed.size)),
            sums.exponents.reshape(count, 2 * modes),
            flows.reshape(count, -1),
        ],
        axis=1,
    )
    engine = compiled_engine()
    if engine is None:
        raise RuntimeError("the compiled engine is not there")
    ends = run_motions(
        engine,
        structure_of(sums.shape, reached),
        numbers,
        np.arange(count),
        np.zeros((count, n)),
        np.zeros(count, dtype=int),
        until,
        1,
        2,
    )
    found = ends.transitions == 1
    if not np.isin(ends.status, (Status.TRANSITIONS, Status.UNTIL)).all():
        raise RuntimeError(f"status {np.unique(ends.status)}")
    return np.where(found, ends.last_times[:, 1], until), found


def _modes(
    rng: np.random.Generator, count: int, shape: Shape, rates: tuple[float, float] = (0.0, 0.0)
) -> np.ndarray:
    exponents = np.zeros((count, len(shape), 2))
    for m, (_, oscillates) in enumerate(shape):
        if m == 0:
            continue
        if oscillates:
            exponents[:, m, 1] = rng.uniform(0.3, 3, count)
        exponents[:, m, 0] = rng.uniform(*rates, count)
        if not oscillates and rates == (0.0, 0.0):
            exponents[:, m, 0] = -rng.uniform(0.1, 1, count)
    return exponents


def _shape(rng: np.random.Generator, longest: int = 1, damped: bool = False) -> Shape:
    first = (int(rng.integers(1, longest + 1)), False)
    rest = [
        (int(rng.integers(1, longest + 1)), bool(rng.random() < (0.7 if damped else 1)))
        for _ in range(rng.integers(1, 4))
    ]
    return (first, *rest)


def _below(rng: np.random.Generator, sums: Sums) -> Sums:
    """The sums shifted to start below zero, by a random part of all amplitudes, or hardly."""
    values = sums.values.copy()
    sizes = np.abs(values).sum(axis=1)
    start = sums.at(np.zeros(len(values)))
    depth = np.where(
        rng.random(len(values)) < 0.2,
        10.0 ** rng.uniform(-14, -2, len(values)),
        rng.uniform(0, 1, len(values)),
    )
    values[:, 0] -= start + depth * sizes
    return Sums(sums.shape, sums.exponents, values)


def _radians(rng: np.random.Generator, sums: Sums, most: float = 40.0) -> np.ndarray:
    fastest = sums.fastest
    return rng.uniform(0.3, most, len(fastest)) / np.where(fastest > 0, fastest, 1.0)


def _random(
    rng: np.random.Generator,
    count: int,
    shape: Shape,
    rates: tuple[float, float] = (0.0, 0.0),
) -> Sums:
    functions = sum(length * (1 + oscillates) for length, oscillates in shape)
    values = rng.normal(size=(count, functions)) * 10.0 ** rng.uniform(-2, 0, (count, functions))
    return Sums(shape, _modes(rng, count, shape, rates), values)


def _generic(rng: np.random.Generator, count: int) -> Sums:
    return _below(rng, _random(rng, count, _shape(rng)))


def _damped(rng: np.random.Generator, count: int) -> Sums:
    return _below(rng, _random(rng, count, _shape(rng, damped=True), (-0.5, -0.001)))


def _growing(rng: np.random.Generator, count: int) -> Sums:
    return _below(rng, _random(rng, count, _shape(rng, damped=True), (-0.05, 0.1)))


def _powers(rng: np.random.Generator, count: int) -> Sums:
    shape = (*_shape(rng, longest=4), (int(rng.integers(2, 5)), True))
    sums = _random(rng, count, shape, (-0.5, 0.02) if rng.random() < 0.5 else (0.0, 0.0))
    return _below(rng, sums)


def _polynomial(rng: np.random.Generator, count: int) -> Sums:
    """Random polynomials that are negative at time zero, some of them with a double root."""
    degree = int(rng.integers(1, 6))
    roots = rng.uniform(0.1, 10, (count, degree)) * rng.choice(
        [-1, 1], (count, degree), p=[0.3, 0.7]
    )
    if degree > 1:
        twice = rng.random(count) < 0.4
        roots[twice, 1] = roots[twice, 0]
    values = np.ones((count, 1))
    for root in roots.T:
        longer = np.zeros((count, values.shape[1] + 1))
        longer[:, 1:] += values
        longer[:, :-1] -= root[:, None] * values
        values = longer
    values *= -np.sign(values[:, :1])
    return Sums(((degree + 1, False),), np.zeros((count, 1, 2)), values)


def _tangent(rng: np.random.Generator, count: int) -> Sums:
    """Sums -(a + b cos(wt + p) + c cos(vt + q))^2 + depth, which have nearly double zeros."""
    a = rng.uniform(-1, 1, count)
    b, c = rng.normal(size=(2, count))
    if rng.random() < 0.5:
        c = np.zeros(count)
    w, v = np.sort(rng.uniform(0.3, 2, (2, count)), axis=0)
    p, q = rng.uniform(0, 2 * math.pi, (2, count))
    terms = [
        (w, p, 2 * a * b),
        (v, q, 2 * a * c),
        (2 * w, 2 * p, b * b / 2),
        (2 * v, 2 * q, c * c / 2),
        (v + w, p + q, b * c),
        (v - w, q - p, b * c),
    ]
    exponents = np.zeros((count, 7, 2))
    depth = rng.choice([-1, 0, 1], count) * 10.0 ** rng.uniform(-17, -6, count)
    values = np.zeros((count, 13))
    values[:, 0] = -(a * a + b * b / 2 + c * c / 2) + depth
    for m, (frequency, phase, size) in enumerate(terms, start=1):
        exponents[:, m, 1] = frequency
        values[:, 2 * m - 1] = -size * np.cos(phase)
        values[:, 2 * m] = size * np.sin(phase)
    return Sums(((1, False), *[(1, True)] * 6), exponents, values)


def _from_zero(order: int) -> Callable[[np.random.Generator, int], Sums]:
    def family(rng: np.random.Generator, count: int) -> Sums:
        """Sums that leave zero with a derivative of some order, the lower ones zero to rounding."""
        choice = rng.random()
        shape = ((int(rng.integers(1, 3)), False), (1, True), (1, True))
        if choice < 0.3:
            shape = ((1, False), (2, True), (1, False))
        alone = choice > 0.85  # what is fast in the configuration is not in the sum
        if alone:
            shape = ((2, False), (1, True), (1, True))
        sums = _random(rng, count, shape, (-0.5, 0.05) if 0.6 < choice < 0.85 else (0.0, 0.0))
        if choice > 0.75:
            sums.exponents[:, 2, 1] *= 10.0 ** rng.uniform(-6, 0, count)
        if alone:
            sums.values[:, 2:4] = 0.0
        derivatives, unit = [], np.eye(sums.values.shape[1])
        for f in range(len(unit)):
            one = Sums(shape, sums.exponents, np.broadcast_to(unit[f], sums.values.shape).copy())
            column = []
            for _ in range(order + 1):
                column.append(one.at(np.zeros(count)))
                one = one.derivative()
            derivatives.append(column)
        matrix = np.moveaxis(np.array(derivatives), (0, 1, 2), (2, 1, 0))
        if alone:
            matrix[:, :, 2:4] = 0.0
        values = sums.values
        inverse = np.linalg.pinv(matrix[:, :order])
        for _ in range(3):
            rest = np.einsum("nkf,nf->nk", matrix[:, :order], values)
            values = values - np.einsum("nfk,nk->nf", inverse, rest)
        values[np.abs(values) < 1e-20 * np.abs(values).max(axis=1, keepdims=True)] = 0.0
        leading = np.einsum("nf,nf->n", matrix[:, order], values)
        return Sums(shape, sums.exponents, values * -np.sign(leading)[:, None])

    return family


def _spread(rng: np.random.Generator, count: int) -> Sums:
    """Sums with frequencies up to a million times slower than the fastest."""
    sums = _random(rng, count, ((1, False), (1, True), (1, True), (1, True)))
    sums.exponents[:, 2, 1] *= 10.0 ** rng.uniform(-6, 0, count)
    sums.exponents[:, 3, 1] *= 10.0 ** rng.uniform(-3, 0, count)
    sums.values[:, 1:3] *= 10.0 ** rng.uniform(-6, 0, count)[:, None]
    return _below(rng, sums)


def _clustered(rng: np.random.Generator, count: int) -> Sums:
    """Sums of exponents that nearly agree, with amplitudes that nearly cancel."""
    oscillates = bool(rng.random() < 0.7)
    sums = _random(
        rng, count, ((1, False), (1, oscillates), (1, oscillates), (1, True)), (-0.3, 0.0)
    )
    if oscillates and rng.random() < 0.5:
        sums.exponents[:, :, 0] = 0.0
    near = 1 + 10.0 ** rng.uniform(-15, -1, count)
    sums.exponents[:, 2] = sums.exponents[:, 1] * near[:, None]
    size = 10.0 ** rng.uniform(0, 6, count)[:, None]
    width = 1 + oscillates
    extra = rng.normal(size=(count, width)) * size
    sums.values[:, 1 : 1 + width] += extra
    sums.values[:, 1 + width : 1 + 2 * width] -= extra
    return _below(rng, sums)


FAMILIES: dict[str, Callable[[np.random.Generator, int], Sums]] = {
    "generic": _generic,
    "damped": _damped,
    "growing": _growing,
    "powers": _powers,
    "polynomial": _polynomial,
    "tangent": _tangent,
    "start of order 1": _from_zero(1),
    "start of order 2": _from_zero(2),
    "start of order 3": _from_zero(3),
    "spread": _spread,
    "clustered": _clustered,
}


def random_sums(rng: np.random.Generator, family: str, count: int) -> tuple[Sums, np.ndarray]:
    """Random sums of a family, and the times until which they are searched."""
    sums = FAMILIES[family](rng, count)
    return sums, _radians(rng, sums, 300.0 if family == "spread" else 40.0)


def verdicts(
    rng: np.random.Generator, sums: Sums, until: np.ndarray, reached: bool
) -> tuple[Counter[str], list[str]]:
    """Counts of verdicts on the search of each sum, and details of wrong ones."""
    times, found = search(sums, until, reached)
    size = np.abs(sums.values).sum(axis=1)
    zero = np.zeros(len(times))
    error = _ALLOWED * (size + sums.bound(times, times))
    counts: Counter[str] = Counter(found=int(found.sum()), none=int((~found).sum()))
    told = []

    def tell(what: str, i: int, more: str = "") -> None:
        counts[what] += 1
        told.append(
            f"{what}: {sums.shape} {sums.exponents[i].tolist()} {sums.values[i].tolist()}"
            f" until {until[i]!r} reached={reached} gave {times[i]!r} {more}"
        )

    beyond = sums.at(zero) > _ALLOWED * size  # already at the start: crossed at once
    for i in np.flatnonzero(beyond):
        counts["starts beyond"] += 1
        if not found[i] or times[i] != 0:
            tell("wrong: not at once", int(i))
    keep = ~beyond
    sums, until, times, found = sums.take(keep), until[keep], times[keep], found[keep]
    size, zero, error = size[keep], zero[keep], error[keep]
    if not len(times):
        return counts, told
    samples = max(60, math.ceil(4 * float((sums.fastest * times).max())))
    cells = undecided(sums, times, error, min(samples, 600))
    missed: set[int] = set()
    for index, low, high in cells:
        i = int(index)
        if i in missed:
            continue
        ball = Ball(sums.shape, sums.exponents[i], sums.values[i])
        try:
            where = first_excess(ball, float(low), float(high), float(error[i]))
        except RuntimeError:
            counts["undecidable"] += 1
            continue
        if where is not None:
            missed.add(i)
            tell("wrong: missed", i, f"exceeds {error[i]:.1e} at {where!r}")
    counts["cells settled in balls"] = len(cells)
    for i in np.flatnonzero(rng.random(len(times)) < PROVED):
        counts["proved in balls as a whole"] += 1
        ball = Ball(sums.shape, sums.exponents[i], sums.values[i])
        if first_excess(ball, 0.0, float(times[i]), float(error[i])) is not None:
            tell("wrong: missed", int(i), "in balls")
    slope = sums.derivative()
    values, rates = sums.at(times), slope.at(times)
    rounding = error + (8 + sums.fastest * times) * EPS * size + 8 * EPS * times * np.abs(rates)
    for i in np.flatnonzero(found & ~(np.abs(values) <= rounding)):
        tell("wrong: no zero", int(i), f"g = {values[i]:.1e}, allowed {rounding[i]:.1e}")
    unit = 1 / np.where(sums.fastest > 0, sums.fastest, 1.0)
    ahead = times[:, None] + unit[:, None] * 10.0 ** np.linspace(-9, -0.5, 35)
    highest = sums.at(ahead).max(axis=1)
    behind = sums.at(times[:, None] * np.linspace(0, 1, 60)).min(axis=1)
    at_start = np.abs(sums.at(zero)) <= _ALLOWED * size
    if not reached:
        for i in np.flatnonzero(found & (highest <= 0)):
            tell("wrong: not exceeded", int(i))
    early = found & at_start & (rates < 0) & (behind >= -error)
    for i in np.flatnonzero(early):
        tell("wrong: left and not reached", int(i))
    return counts, told


def search_chunk(
    rng: np.random.Generator, family: str, count: int, reached: bool
) -> tuple[Counter[str], list[str]]:
    """Verdicts on random sums of one family, a few shapes among them."""
    total: Counter[str] = Counter()
    told: list[str] = []
    for part in np.array_split(np.arange(count), max(1, count // 250)):
        sums, until = random_sums(rng, family, len(part))
        counts, lines = verdicts(rng, sums, until, reached)
        total += Counter({f"{what} ({family})": n for what, n in counts.items()})
        told += lines
    return total, told
