"""How residuals count in a fit, and what it tells of its unknowns: covariance and intervals.

Losses of squared residuals are those of SciPy's `least_squares` (B. Triggs et al., Bundle
adjustment, 1999). The covariance is that of an M-estimate,
(sum psi^2 / (m - q)) / mean(psi')^2 (J^T J)^-1 with the loss's influence psi; for least squares it
is the variance of the residuals, or 1 where standard deviations were given, times (J^T J)^-1.
P. J. Huber, Robust Statistics (1981); G. A. F. Seber and C. J. Wild, Nonlinear Regression (1989).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from nonsmooth.runtime.core.errors import unknown_name

__all__ = ["LOSSES", "Statistics", "check_loss", "combination_text", "loss_of", "statistics"]

Loss = Callable[[np.ndarray], np.ndarray]
_NOTHING = 1e-9  # of the largest singular value: below it a combination is not identified
_TAKES_PART = 1e-4  # of a unit vector
_LEVEL = 0.95


def _linear(z: np.ndarray) -> np.ndarray:
    return np.array([z, np.ones_like(z), np.zeros_like(z)])


def _soft_l1(z: np.ndarray) -> np.ndarray:
    root = np.sqrt(1 + z)
    return np.array([2 * (root - 1), 1 / root, -0.5 / root**3])


def _huber(z: np.ndarray) -> np.ndarray:
    far = np.maximum(z, 1.0)
    inside, root = z <= 1, np.sqrt(far)
    return np.array(
        [
            np.where(inside, z, 2 * root - 1),
            np.where(inside, 1.0, 1 / root),
            np.where(inside, 0.0, -0.5 / far**1.5),
        ]
    )


def _cauchy(z: np.ndarray) -> np.ndarray:
    return np.array([np.log1p(z), 1 / (1 + z), -1 / (1 + z) ** 2])


LOSSES: Mapping[str, Loss] = {
    "linear": _linear,
    "soft_l1": _soft_l1,
    "huber": _huber,
    "cauchy": _cauchy,
}


def check_loss(name: str) -> None:
    """Refuse an unknown loss; the message lists the known ones."""
    if name not in LOSSES:
        raise unknown_name("loss", name, LOSSES)


def loss_of(name: str, count: int) -> Loss:
    """A loss for residuals of which the first `count` are data; those of priors stay squared.

    It maps squared residuals (m,) to the loss and its first two derivatives (3, m).
    """
    own = LOSSES[name]

    def loss(z: np.ndarray) -> np.ndarray:
        return np.concatenate([own(z[:count]), _linear(z[count:])], axis=1)

    return loss


@dataclass(frozen=True, eq=False)
class Statistics:
    """Uncertainties at a minimum with q unknowns, k of which are not at a bound."""

    # (q, q); variances are infinite for an unknown that the data do not determine, or without a
    # degree of freedom to estimate the noise, and NaN beside these; NaN for unknowns at a bound
    covariance: np.ndarray
    half_widths: np.ndarray  # (q,), of the 95 % intervals
    # (k,), of the Jacobian with each column times its unknown's size: by how many standard
    # deviations the data move where a combination of relative changes is 1
    singular_values: np.ndarray
    combinations: np.ndarray  # (k, q), unit vectors of relative changes, in rows
    unidentified: tuple[int, ...]  # rows of combinations that nothing determines


def statistics(
    scale: np.ndarray,
    residuals: np.ndarray,
    jacobian: np.ndarray,
    data: int,
    *,
    loss: str,
    given: bool,
    held: np.ndarray,
) -> Statistics:
    """Uncertainties from the residuals (m + p,) and the Jacobian (m + p, q) at a minimum.

    `scale` (q,) is a large change of each unknown; `data` is the number m of measured values,
    which come before those of priors. `given` says whether all standard deviations were given,
    and `held` (q,) marks unknowns at a bound.
    """
    from scipy.stats import norm, t

    size = len(scale)
    free = np.flatnonzero(~held)
    weighted = jacobian[:, free] * scale[free]
    _, values, rows = np.linalg.svd(weighted, full_matrices=True)
    sizes = np.zeros(len(free))
    sizes[: len(values)] = values
    lost = sizes <= _NOTHING * sizes.max(initial=0)
    inverse = np.where(lost, 0.0, 1 / np.where(lost, 1.0, sizes) ** 2)
    freedom = len(residuals) - len(free)
    factor = _factor(residuals, data, freedom, loss, given=given)
    covariance = np.full((size, size), np.nan)
    told = math.isfinite(factor)
    inner = (rows.T * inverse) @ rows * np.outer(scale[free], scale[free])
    inner *= factor if told else 1.0
    unknown = (abs(rows[lost]) > _TAKES_PART).any(axis=0) | (not told)
    inner[unknown, :] = inner[:, unknown] = np.nan
    inner[unknown, unknown] = np.inf
    covariance[np.ix_(free, free)] = inner
    exact = given and loss == "linear"
    if exact:
        quantile = float(norm.ppf((1 + _LEVEL) / 2))
    else:
        quantile = float(t.ppf((1 + _LEVEL) / 2, freedom)) if freedom > 0 else math.inf
    combinations = np.zeros((len(free), size))
    combinations[:, free] = rows
    return Statistics(
        covariance,
        quantile * np.sqrt(np.diag(covariance)),
        sizes,
        combinations,
        tuple(np.flatnonzero(lost).tolist()),
    )


def _factor(residuals: np.ndarray, data: int, freedom: int, loss: str, *, given: bool) -> float:
    """Variance of the residuals, as the loss weights them."""
    if given and loss == "linear":
        return 1.0
    if freedom <= 0:
        return math.inf
    own = residuals[:data]
    _, first, second = LOSSES[loss](own**2)
    influence, slope = first * own, float(np.mean(first + 2 * second * own**2))
    total = float((influence**2).sum() + (residuals[data:] ** 2).sum())
    return total / freedom / slope**2


def combination_text(names: Sequence[str], combination: np.ndarray) -> str:
    """A text for a combination (q,) of relative changes.

    Examples
    --------
    >>> combination_text(["k", "m", "r"], np.array([0.5, 0.5, 0.0]))
    'k and m changed together (k by +1 %, m by +1 %)'
    >>> combination_text(["k", "m"], np.array([0.0, -1.0]))
    'm'
    """
    size = float(abs(combination).max())
    parts = [
        (name, float(share) / size)
        for name, share in zip(names, combination, strict=True)
        if abs(share) > _TAKES_PART * size
    ]
    if len(parts) == 1:
        return parts[0][0]
    sign = math.copysign(1.0, parts[0][1])
    each = ", ".join(f"{name} by {sign * share:+.3g} %" for name, share in parts)
    *most, last = (name for name, _ in parts)
    return f"{', '.join(most)} and {last} changed together ({each})"
