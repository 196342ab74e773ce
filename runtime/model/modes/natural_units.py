"""Natural units of motions y' = A y + b: powers of two in which their numbers are near 1.

The unit of time is that of the fastest rate, or of the time in which a load crosses the gap in
front of a boundary where that is shorter. A position and its velocity have one unit of
length; states that depend on each other are balanced; what constants or a forcing of amplitude 1
drive has the unit of its response, and a state that drives others the largest unit that makes
them respond by no more than theirs. So the modes of a motion, and all comparisons on the way to
them, are the same in whatever units of length, time and mass a system is declared, but for a
factor below two; a change of units by powers of two changes no bit of them.

Which states depend on which, and the balancing of matrices alone, stand here too.
"""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.model.factored_flows import FactoredFlows, Flows, arrays_of
from nonsmooth.runtime.model.structure import ModeShape
from nonsmooth.runtime.model.time_functions import function_orders

_SWEEPS = 40  # of balancing
_LARGEST = 2.0**500  # a unit beyond it, or below its inverse, is none


def balanced(matrices: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Balance matrices (n, m, m): the scaled matrices and the units (n, m) of their coordinates.

    The units are powers of two, ``scaled = matrices * units[:, None] / units[:, :, None]``, and
    make rows and columns similar in size (Parlett and Reinsch, 1969), for all matrices at once.
    """
    scaled, units = matrices.copy(), np.ones(matrices.shape[:2])
    for _ in range(_SWEEPS):
        sizes = np.abs(scaled)
        if (_factors(sizes.max(axis=1), sizes.max(axis=2)) == 1).all():
            break
        for i in range(matrices.shape[-1]):
            column, row = np.abs(scaled[:, :, i]).max(axis=1), np.abs(scaled[:, i]).max(axis=1)
            factor = _factors(column, row)
            if (factor != 1).any():
                units[:, i] *= factor
                scaled[:, i] /= factor[:, None]
                scaled[:, :, i] *= factor[:, None]
    return scaled, units


def _factors(columns: np.ndarray, rows: np.ndarray) -> np.ndarray:
    """Powers of two by which a unit grows, from the largest entries of its columns and rows."""
    told = (columns > 0) & (rows > 0) & np.isfinite(columns) & np.isfinite(rows)
    # a factor f turns them into f column and row / f: of like size for f^2 = row / column
    exponents = np.frexp(np.where(told, rows / np.where(told, columns, 1.0), 1.0))[1]
    factors = np.where(told, np.ldexp(1.0, exponents // 2), 1.0)
    better = factors * columns + rows / factors < 0.95 * (columns + rows)
    return np.asarray(np.where(better, factors, 1.0))


def dependence(matrices: np.ndarray) -> np.ndarray:
    """A bool (n, m, m) for each entry: whether polynomials of the matrix may be nonzero there.

    Where it is False, one state does not depend on the other (a forcing on the structure, for
    example), and the entry is exactly zero, not only up to rounding.
    """
    patterns = matrices != 0
    if (patterns == patterns[:1]).all():
        return np.broadcast_to(_closure(patterns[0].tobytes(), len(patterns[0])), patterns.shape)
    return np.stack([_closure(pattern.tobytes(), len(pattern)) for pattern in patterns])


@lru_cache(maxsize=4096)
def _closure(content: bytes, size: int) -> np.ndarray:
    pattern = np.frombuffer(content, dtype=bool).reshape(size, size)
    reached = (pattern | np.eye(size, dtype=bool)).astype(np.float32)  # for the products' sake
    for _ in range(size.bit_length()):
        reached = (reached @ reached > 0).astype(np.float32)
    return np.asarray(reached > 0)


class NaturalUnits(NamedTuple):
    """Units of time (n,) and of the states and the constant 1 (n, N + 1), of n motions."""

    time: np.ndarray
    states: np.ndarray

    def at(self, places: np.ndarray) -> NaturalUnits:
        """The units of the motions at some places (k,)."""
        return NaturalUnits(self.time[places], self.states[places])

    def fields(self, fields: np.ndarray) -> np.ndarray:
        """Fields (n, N, N + 1) in these units."""
        rows, columns = self.states[:, :-1, None], self.states[:, None]
        return np.asarray(fields * columns / rows * self.time[:, None, None])

    def exponents(self, exponents: np.ndarray) -> np.ndarray:
        """Exponents (n, modes, 2) in natural units, converted to the units of the fields."""
        return np.asarray(exponents / self.time[:, None, None])

    def flows(
        self, shapes: tuple[ModeShape, ...], arrays: tuple[np.ndarray, ...]
    ) -> tuple[np.ndarray, ...]:
        """Flows in natural units, converted to the units of the fields.

        They are matrices (n, d, N, N + 1) and, for factored modes, columns (n, k, N) and rows
        (n, k, N + 1) as well.
        """
        rows, columns = self.states[:, None, :-1], self.states[:, None]
        factored = [shape.factored for shape in shapes for _ in shape.places]
        powers = np.array(function_orders(shapes))[~np.array(factored)]
        times = (1 / self.time[:, None]) ** powers
        matrices, *factors = arrays
        found = matrices * times[:, :, None, None] * (rows[..., None] / columns[:, :, None])
        if not factors:
            return (found,)
        left, right = factors
        return found, left * rows, right / columns

    def flows_of_one(self, shapes: tuple[ModeShape, ...], flows: Flows) -> Flows:
        """Flows of a single motion in natural units, converted to the units of its field."""
        found = self.flows(shapes, tuple(part[None] for part in arrays_of(flows)))
        matrices, *factors = (part[0] for part in found)
        return FactoredFlows(shapes, matrices, *factors) if factors else matrices


class _Blocks(NamedTuple):
    """Groups of states and blocks of groups, as the zeros of a field define them.

    A group is a coordinate with its derivatives. A block's groups depend on each other.
    """

    orders: np.ndarray  # (N + 1,) times that each state was differentiated
    order: np.ndarray  # states, sorted by groups
    starts: np.ndarray  # (groups,) first of each in this order
    group_of: np.ndarray  # (N + 1,)
    together: np.ndarray  # (groups, groups) of bool
    block_of: np.ndarray  # (groups,)
    drives: np.ndarray  # (blocks, blocks) of bool: row by column; blocks stand behind what drives
    fixed: tuple[int, ...]  # blocks of size 1: the constant, and forcings


def natural_units(fields: np.ndarray, rates: np.ndarray) -> NaturalUnits:
    """Natural units of n motions y' = A y + b, each by itself; `fields` are (n, N, N + 1).

    `rates` (n,) are those of loads that cross gaps, from `fall_rates`; 0 for no such load.
    """
    count, _, columns = fields.shape
    whole = np.concatenate([fields, np.zeros((count, 1, columns))], axis=1)
    time, states = np.ones(count), np.ones((count, columns))
    kinds = _kinds(whole)
    alike = (kinds == kinds[:1]).all()
    for kind in kinds[:1] if alike else np.unique(kinds, axis=0):
        places = np.flatnonzero((kinds == kind).all(axis=1))
        with np.errstate(all="ignore"):
            blocks = _blocks(kind.tobytes(), columns)
            time[places], states[places] = _units(whole[places], rates[places], blocks)
    return NaturalUnits(time, states)


def fall_rates(fields: np.ndarray, rows: np.ndarray) -> np.ndarray:
    """Inverses (n,) of the times in which loads cross the gaps in front of boundaries.

    A gap is a boundary's function at the state 0; a load crosses it with the second or third
    power of the time. `fields` are (n, N, N + 1), the boundaries' rows (n, r, N + 1). The rates
    are powers of two, and 0 without a load or a gap.
    """
    sizes, gaps = np.abs(rows[..., :-1]), np.abs(rows[..., -1])
    matrices, moved = np.abs(fields[..., :-1]), np.abs(fields[..., -1])
    rates = np.zeros(len(fields))
    for power in (2, 3):
        with np.errstate(all="ignore"):
            moved = (matrices @ moved[..., None])[..., 0]
            crossed = (sizes @ moved[..., None])[..., 0] / np.where(gaps > 0, gaps, np.inf)
            largest = crossed.max(axis=-1, initial=0.0) ** (1 / power)
            rates = np.maximum(rates, _power_of_two(largest))
    return np.asarray(np.where(np.isfinite(rates), rates, 0.0))


def _kinds(whole: np.ndarray) -> np.ndarray:
    """Kinds (n, m m) of the entries of matrices (n, m, m).

    They are 0 for zeros, 2 for a one alone in its row, 3 for the entries a and -a of a pair of
    states that turn into each other, and 1 for all others.
    """
    kinds = (whole != 0).astype(np.int8)
    alone = (kinds.sum(axis=-1) == 1)[:, :, None]
    kinds[alone & (whole == 1)] = 2
    turned = np.swapaxes(whole, -1, -2)
    pairs = alone & np.swapaxes(alone, -1, -2) & (whole == -turned) & (whole != 0)
    kinds[pairs] = 3
    return np.asarray(kinds.reshape(len(whole), -1))


@lru_cache(maxsize=1024)
def _blocks(content: bytes, size: int) -> _Blocks:
    kinds = np.frombuffer(content, dtype=np.int8).reshape(size, size)
    group_of, orders = np.arange(size), np.zeros(size, dtype=int)
    for state, derivative in np.argwhere(kinds == 2).tolist():
        if group_of[state] != group_of[derivative]:
            moved = group_of == group_of[state]
            orders[moved] += orders[derivative] - 1 - orders[state]
            group_of[moved] = group_of[derivative]
    names, group_of = np.unique(group_of, return_inverse=True)
    count = len(names)
    pattern = np.zeros((count, count), dtype=bool)
    for row, column in np.argwhere(kinds).tolist():
        pattern[group_of[row], group_of[column]] = True
    depends = dependence(pattern[None].astype(float))[0]
    together = depends & depends.T
    leaders = together.argmax(axis=1)  # the first group of each block
    # whatever drives a block depends on fewer
    blocks = sorted(set(leaders.tolist()), key=lambda leader: (depends[leader].sum(), leader))
    block_of = np.array([blocks.index(leader) for leader in leaders.tolist()])
    drives = np.zeros((len(blocks), len(blocks)), dtype=bool)
    for row, column in np.argwhere(pattern).tolist():
        drives[block_of[row], block_of[column]] |= block_of[row] != block_of[column]
    turning = np.flatnonzero((kinds == 3).any(axis=1))
    fixed = {int(block_of[group_of[state]]) for state in (*turning.tolist(), size - 1)}
    order = np.argsort(group_of, kind="stable")
    starts = np.searchsorted(group_of[order], np.arange(count))
    return _Blocks(
        orders, order, starts, group_of, together, block_of, drives, tuple(sorted(fixed))
    )


def _units(whole: np.ndarray, rates: np.ndarray, blocks: _Blocks) -> tuple[np.ndarray, np.ndarray]:
    """Units of time and of the states of matrices (n, m, m) that have the same zeros."""
    depends = dependence(whole[:1])[0]
    rate = np.maximum(_rates(np.abs(np.where(depends & depends.T, whole, 0.0))), rates)
    rate = np.where(rate > 0, rate, 1.0)
    states = rate[:, None] ** blocks.orders
    sizes = np.abs(whole) * states[:, None, :] / states[:, :, None]
    sizes = sizes[:, blocks.order][:, :, blocks.order]
    groups = np.maximum.reduceat(
        np.maximum.reduceat(sizes, blocks.starts, axis=1), blocks.starts, axis=2
    )
    _, units = balanced(np.where(blocks.together, groups, 0.0))
    couplings = groups * units[:, None, :] / units[:, :, None] / rate[:, None, None]
    found = units * _block_units(couplings, blocks)[:, blocks.block_of]
    states = states * found[:, blocks.group_of]
    states = states / states[:, -1:]
    told = np.isfinite(rate) & (states < _LARGEST).all(axis=1) & (states > 1 / _LARGEST).all(axis=1)
    told &= (rate < _LARGEST) & (rate > 1 / _LARGEST)
    return np.where(told, 1 / rate, 1.0), np.where(told[:, None], states, 1.0)


def _rates(sizes: np.ndarray) -> np.ndarray:
    """Powers of two near the fastest rates of matrices (n, m, m) >= 0; 0 if there is no cycle.

    A product of entries around a cycle of states has no unit but that of time.
    """
    rates = np.full(len(sizes), -np.inf)  # their logarithms
    exponents, steps = np.zeros(len(sizes)), 1
    power = sizes
    for _ in range(sizes.shape[-1].bit_length() + 1):
        largest = power.max(axis=(-2, -1))
        shift = np.frexp(np.where(largest > 0, largest, 1.0))[1]
        power, exponents = power * np.ldexp(1.0, -shift)[:, None, None], exponents + shift
        around = np.diagonal(power, axis1=-2, axis2=-1).max(axis=-1)
        rates = np.maximum(rates, (np.log2(around) + exponents) / steps)
        power, exponents, steps = power @ power, 2 * exponents, 2 * steps
    return np.asarray(np.exp2(np.floor(rates)))


def _block_units(couplings: np.ndarray, blocks: _Blocks) -> np.ndarray:
    """Units (n, blocks) with which each block's response is at most its own unit."""
    count = len(blocks.drives)
    units = np.ones((len(couplings), count))
    known = np.zeros(count, dtype=bool)
    known[list(blocks.fixed)] = True

    def coupling(driven: int, driver: int) -> np.ndarray:
        rows, columns = blocks.block_of == driven, blocks.block_of == driver
        return np.asarray(couplings[:, rows][:, :, columns].max(axis=(-2, -1)))

    while True:
        for block in range(count):
            drivers = np.flatnonzero(blocks.drives[block] & known).tolist()
            if not known[block] and drivers:
                responses = [coupling(block, driver) * units[:, driver] for driver in drivers]
                units[:, block] = _power_of_two(np.maximum.reduce(responses))
                known[block] = True
        for block in reversed(range(count)):
            driven = np.flatnonzero(blocks.drives[:, block] & known).tolist()
            if not known[block] and driven:
                allowed = [units[:, other] / coupling(other, block) for other in driven]
                units[:, block] = _power_of_two(np.minimum.reduce(allowed))
                known[block] = True
                break
        else:
            if known.all():
                return units
            known[int(np.argmin(known))] = True


def _power_of_two(numbers: np.ndarray) -> np.ndarray:
    """The largest powers of two that do not exceed numbers, which are positive or 0."""
    return np.asarray(np.where(numbers > 0, np.ldexp(1.0, np.frexp(numbers)[1] - 1), 0.0))
