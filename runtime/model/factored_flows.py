"""Flows of large configurations: factors in place of matrices where a mode is simple.

The matrix of a mode that belongs to one eigenvalue is of rank one, u v with a column u and a row
v; of a pair of complex ones, with right and left eigenvectors r and l,

    2 Re(e^(mu t) r l) = phi_c (u_0 v_0 + u_1 v_1) + phi_s (u_1 v_0 - u_0 v_1),
    u_0, u_1 = 2 Re r, -2 Im r,    v_0, v_1 = Re l, Im l.

N states have about N functions of time, so that factors are 2 N^2 numbers, and matrices N^3. They
are what `subspace_modes` gives.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.model.structure import ModeShape


class _FactorPlaces(NamedTuple):
    """Places of the functions of time whose matrices are stored, and of those with factors.

    For each factor, `even` is the place of its mode's cosine (or only function) and `odd` that
    of the sine. The sine goes with the factor `other` and with `sign`, 0 for a mode without one.
    """

    dense: np.ndarray  # functions whose matrices are stored
    even: np.ndarray
    odd: np.ndarray
    other: np.ndarray
    sign: np.ndarray
    starts: np.ndarray  # first factor of each mode
    turns: np.ndarray  # whether it has a sine


@cache
def _places(shapes: tuple[ModeShape, ...]) -> _FactorPlaces:
    factors: list[tuple[int, int, int, int]] = []
    starts: list[int] = []
    modes = [shape for shape in shapes if shape.factored]
    for shape in modes:
        first, last = shape.places[0], shape.places[-1]
        count = len(factors)
        starts.append(count)
        if shape.oscillates:
            factors += [(first, last, count + 1, -1), (first, last, count, 1)]
        else:
            factors.append((first, last, count, 0))
    even, odd, other, sign = np.array(factors, dtype=int).reshape(-1, 4).T
    return _FactorPlaces(
        np.array([p for s in shapes if not s.factored for p in s.places], dtype=int),
        even,
        odd,
        other,
        sign,
        np.array(starts, dtype=int),
        np.array([shape.oscillates for shape in modes], dtype=bool),
    )


@dataclass(frozen=True, eq=False)
class FactoredFlows:
    """Flows of a configuration of N states in which simple modes have factors for matrices."""

    shapes: tuple[ModeShape, ...]
    matrices: np.ndarray  # (..., d, N, N + 1), of functions of modes without factors
    left: np.ndarray  # (..., k, N), columns u of the other modes, mode by mode
    right: np.ndarray  # (..., k, N + 1), their rows v

    def __getitem__(self, point: int) -> FactoredFlows:
        """Flows of one of many points."""
        arrays = (self.matrices[point], self.left[point], self.right[point])
        return FactoredFlows(self.shapes, *arrays)

    def states(self, functions: np.ndarray, extended: np.ndarray) -> np.ndarray:
        """States (..., N) from values (..., functions) of the functions of time.

        `extended` (..., N + 1) are the states at the start, then 1.
        """
        at, projected = _places(self.shapes), _times(self.right, extended)
        turned = at.sign * functions[..., at.odd] * projected[..., at.other]
        factors = functions[..., at.even] * projected + turned
        moved = _times(self.matrices, extended[..., None, :])
        dense = (functions[..., at.dense, None] * moved).sum(axis=-2)
        return np.asarray((factors[..., None, :] @ self.left)[..., 0, :] + dense)

    def parts(self, extended: np.ndarray) -> np.ndarray:
        """The vectors (..., functions, N) that multiply the functions of time in the state.

        `extended` (..., N + 1) are the states at the start, then 1.
        """
        return self._parts(extended, _places(self.shapes).sign)

    def sizes(self, extended: np.ndarray) -> np.ndarray:
        """Bounds (..., functions, N) of the sums of absolute values behind `parts`.

        `extended` (..., N + 1) are the absolute values of the states at the start, then 1.
        """
        positive = FactoredFlows(self.shapes, *map(abs, (self.matrices, self.left, self.right)))
        return positive._parts(extended, abs(_places(self.shapes).sign))

    def all(self) -> np.ndarray:
        """The matrices (..., functions, N, N + 1) of all functions: N / 2 times as many numbers."""
        found = self._placed(
            np.moveaxis(self.matrices, -3, 0),
            np.moveaxis(self.left, -2, 0)[..., None],
            np.moveaxis(self.right, -2, 0)[..., None, :],
            _places(self.shapes).sign,
        )
        return np.moveaxis(found, 0, -3)

    def at(self, functions: np.ndarray) -> np.ndarray:
        """The flow (..., N, N + 1), matrix and then constant, at values of the functions of time.

        `functions` are these values (..., functions).
        """
        at = _places(self.shapes)
        even, odd = functions[..., at.even, None], functions[..., at.odd, None]
        turned = at.sign[:, None] * odd * self.right[..., at.other, :]
        dense = (functions[..., at.dense, None, None] * self.matrices).sum(axis=-3)
        return np.asarray(self.left.swapaxes(-1, -2) @ (even * self.right + turned) + dense)

    def terms(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """The flow of one point as a sum of T functions of time, each times a column and a row.

        These are the places (T,) of the functions, the columns (T, N) and the rows (T, N + 1).
        """
        at, (count, size) = _places(self.shapes), self.matrices.shape[:2]
        turning = at.sign != 0
        parts = (
            (at.even, self.left, self.right),
            (
                at.odd[turning],
                at.sign[turning, None] * self.left[turning],
                self.right[at.other[turning]],
            ),
            (
                np.repeat(at.dense, size),
                np.tile(np.eye(self.left.shape[1]), (count, 1)),
                self.matrices.reshape(-1, self.right.shape[1]),
            ),
        )
        places, columns, rows = (np.concatenate(each) for each in zip(*parts, strict=True))
        return places, columns, rows

    def _parts(self, extended: np.ndarray, sign: np.ndarray) -> np.ndarray:
        found = self._placed(
            np.moveaxis(_times(self.matrices, extended[..., None, :]), -2, 0),
            np.moveaxis(np.broadcast_to(self.left, (*extended.shape[:-1], *self.left.shape[-2:])),
                        -2, 0),
            np.moveaxis(_times(self.right, extended), -1, 0)[..., None],
            sign,
        )  # fmt: skip
        return np.moveaxis(found, 0, -2)

    def _placed(
        self, dense: np.ndarray, left: np.ndarray, right: np.ndarray, sign: np.ndarray
    ) -> np.ndarray:
        """Products of factors, summed into the places of the cosines and of the sines.

        The axis of the factors, and of the functions in the result, is the first.
        """
        at = _places(self.shapes)
        signs = sign.reshape(-1, *[1] * (dense.ndim - 1))
        sines = np.add.reduceat(left * signs * right[at.other], at.starts)
        found = np.zeros((len(dense) + len(at.turns) + int(at.turns.sum()), *sines.shape[1:]))
        found[at.dense] = dense
        found[at.even[at.starts]] = np.add.reduceat(left * right, at.starts)
        found[at.odd[at.starts][at.turns]] = sines[at.turns]
        return found


Flows = np.ndarray | FactoredFlows  # (..., functions, N, N + 1), or factors of it


def _times(rows: np.ndarray, extended: np.ndarray) -> np.ndarray:
    """Matrices (..., r, N + 1) times vectors (..., N + 1)."""
    return np.asarray((rows @ extended[..., None])[..., 0])


def factored_functions(shapes: Sequence[ModeShape]) -> int:
    """Number of functions of time whose matrices have factors."""
    return sum(len(shape.places) for shape in shapes if shape.factored)


def arrays_of(flows: Flows) -> tuple[np.ndarray, ...]:
    """The arrays that hold flows, in the order in which they are packed."""
    if isinstance(flows, FactoredFlows):
        return flows.matrices, flows.left, flows.right
    return (flows,)


def flows_size(shapes: Sequence[ModeShape], states: int) -> int:
    """Number of floats in the flows of a configuration with `states` states."""
    factored = factored_functions(shapes)
    dense = sum(len(shape.places) for shape in shapes) - factored
    return dense * states * (states + 1) + factored * (2 * states + 1)


def cut_flows(shapes: tuple[ModeShape, ...], states: int, flat: np.ndarray) -> Flows:
    """Flows of a configuration as views of packed numbers (..., size), size as in `flows_size`."""
    lead = flat.shape[:-1]
    factored = factored_functions(shapes)
    dense = sum(len(shape.places) for shape in shapes) - factored
    first = dense * states * (states + 1)
    matrices = flat[..., :first].reshape(*lead, dense, states, states + 1)
    if not factored:
        return matrices
    second = first + factored * states
    left = flat[..., first:second].reshape(*lead, factored, states)
    right = flat[..., second:].reshape(*lead, factored, states + 1)
    return FactoredFlows(shapes, matrices, left, right)


def matrices_of(flows: Flows) -> np.ndarray:
    """The matrices (..., functions, N, N + 1) of all functions, for few enough states."""
    return flows.all() if isinstance(flows, FactoredFlows) else flows
