"""Modes of many configurations at once, where every eigenvalue is simple and well conditioned.

LAPACK finds the eigenvalues of a whole stack of matrices. Each decomposition is then held
against its matrix: where the projectors do not sum up to the unit, or miss their eigenvalues by
more than rounding, the configuration is left to `numeric_modes`, which clusters eigenvalues and
works in more digits. Every operation acts on one matrix or one entry alone, so
that no digit depends on which other matrices are in the stack.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.model.factored_flows import Flows
from nonsmooth.runtime.model.modes.natural_units import dependence
from nonsmooth.runtime.model.structure import ModeShape, mode_shapes

_EPSILON = float(np.finfo(float).eps)
_APART = 1e-9  # of the largest modulus: eigenvalues that are nearer are not simple
_LARGE = 30.0  # norm of a projector: as much, squared, may be lost of the digits
# of as many states as there are, times the rounding of one number:
_UNIT = 8 * _EPSILON  # what the projectors' sum may miss
_MISSED = 16 * _EPSILON  # what they may miss their eigenvalues by, of the largest modulus
_NORM = 2.0  # and norm of a projector
_MODERATE = 1e3  # term of a state beside which it loses no digits that count while it is small


class NumericModes(NamedTuple):
    """Modes of one configuration."""

    shapes: tuple[ModeShape, ...]  # first that of the exponent 0, which has the constants
    exponents: np.ndarray  # (modes, 2), real and imaginary parts
    # (functions, N, N + 1) or FactoredFlows, ``y(t) = sum_f phi_f(t) (B_f y(0) + beta_f)``: B_f,
    # then beta_f
    flows: Flows


class ModeGroup(NamedTuple):
    """Modes of those configurations of a stack that have modes of the same shapes."""

    places: np.ndarray  # (k,) of int, indices in the stack
    shapes: tuple[ModeShape, ...]  # first that of the exponent 0, which has the constants
    exponents: np.ndarray  # (k, modes, 2), real and imaginary parts
    # arrays of the flows: matrices (k, functions, N, N + 1), or matrices and factors
    flows: tuple[np.ndarray, ...]


def simple_modes(fields: np.ndarray) -> list[ModeGroup]:
    """Modes of motions y' = A y + b with simple eigenvalues that double precision determines well.

    `fields` (n, N, N + 1) are A, then b, and finite. Other motions are left out.
    """
    count, size, columns = fields.shape
    whole = np.concatenate([fields, np.zeros((count, 1, columns))], axis=1)
    with np.errstate(all="ignore"):
        values, right = np.linalg.eig(whole)
        scale = np.abs(values).max(axis=-1)
        apart = np.flatnonzero(_smallest_distances(values) > _APART * scale)
        values, right = values[apart].astype(complex), right[apart].astype(complex)
        scale = scale[apart]
        try:
            left = np.linalg.inv(right)
        except np.linalg.LinAlgError:  # one is singular: all go the other way
            return []
        values = snapped(values, 8 * columns * _EPSILON * scale[:, None])
        sound = _sound(whole[apart], values, right, left, scale)
    result = []
    order = np.lexsort((values.real, values.imag, values != 0), axis=-1)
    reals = (values.imag == 0).sum(axis=-1)
    for count in np.unique(reals[sound]).tolist():
        group = np.flatnonzero(sound & (reals == count))
        kept = order[group]
        kept = kept[np.take_along_axis(values[group], kept, axis=-1).imag >= 0]
        kept = kept.reshape(len(group), -1)
        poles = np.take_along_axis(values[group], kept, axis=-1)
        columns_of = np.take_along_axis(right[group], kept[:, None, :], axis=-1)
        rows_of = np.take_along_axis(left[group], kept[:, :, None], axis=-2)
        terms = _terms(count, np.swapaxes(columns_of, -1, -2), rows_of)
        terms = terms[:, :, :size]
        places = apart[group]
        small = is_moderate(terms, fields[places])
        places, terms, poles = places[small], terms[small], poles[small]
        if not len(places):
            continue
        terms[~np.broadcast_to(dependence(whole[places])[:, None, :size], terms.shape)] = 0.0
        shapes = mode_shapes(((1, False),) * count + ((1, True),) * (poles.shape[1] - count))
        exponents = np.stack([poles.real, poles.imag], axis=-1)
        result.append(ModeGroup(places, shapes, exponents, (terms,)))
    return result


def snapped(values: np.ndarray, tiny: float | np.ndarray) -> np.ndarray:
    """Eigenvalues with a real or imaginary part set to zero if it is at most `tiny`: rounding."""
    real = np.where(np.abs(values.real) <= tiny, 0.0, values.real)
    return np.asarray(real + 1j * np.where(np.abs(values.imag) <= tiny, 0.0, values.imag))


def is_moderate(flows: np.ndarray, fields: np.ndarray) -> np.ndarray:
    """Bools (...): whether no significant digits are lost while a motion is small.

    Motions that are slow in the unit of time are sums of terms that cancel. `flows` are
    (..., functions, N, N + 1), and `fields` (..., N, N + 1).
    """
    rates = np.maximum(np.abs(fields).max(axis=-1, initial=1.0), 1.0)
    return np.asarray(
        (np.abs(flows) <= _MODERATE * rates[..., None, :, None]).all(axis=(-3, -2, -1))
    )


def _terms(count: int, right: np.ndarray, left: np.ndarray) -> np.ndarray:
    """Matrices (k, functions, n, n) of eigenvectors (k, modes, n), of which `count` are real."""
    real = right[:, :count, :, None].real * left[:, :count, None, :].real
    u, v = right[:, count:, :, None], left[:, count:, None, :]
    even = 2 * (u.real * v.real - u.imag * v.imag)
    odd = -2 * (u.real * v.imag + u.imag * v.real)
    pairs = np.stack([even, odd], axis=2)
    return np.concatenate([real, pairs.reshape(len(u), -1, *real.shape[2:])], axis=1)


def _sound(
    matrix: np.ndarray, values: np.ndarray, right: np.ndarray, left: np.ndarray, scale: np.ndarray
) -> np.ndarray:
    """Whether projectors are small, add up to the identity and belong to their eigenvalues."""
    norms = np.linalg.norm(left, axis=-1) * np.linalg.norm(right, axis=-2)
    missed = np.abs(matrix @ right - right * values[:, None, :]) @ np.abs(left)
    unit = np.abs(right @ left - np.eye(matrix.shape[-1]))
    size = matrix.shape[-1]
    return np.asarray(
        (norms.max(axis=-1) <= max(_LARGE, _NORM * size))
        & (unit.max(axis=(-2, -1)) <= _UNIT * size)
        & (missed.max(axis=(-2, -1)) <= _MISSED * size * scale)
    )


def _smallest_distances(values: np.ndarray) -> np.ndarray:
    """Smallest distances (n,) between two of the eigenvalues (n, N); inf for a single one."""
    gaps = np.abs(values[:, :, None] - values[:, None, :])
    gaps[:, range(values.shape[1]), range(values.shape[1])] = np.inf
    return np.asarray(gaps.min(axis=(-2, -1)))
