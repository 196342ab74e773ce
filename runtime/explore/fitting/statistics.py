"""How far a fit can be trusted: covariance and intervals of its unknowns, and how near it grazes.

Losses of squared residuals are those of SciPy's `least_squares` (B. Triggs et al., Bundle
adjustment, 1999). The covariance is that of an M-estimate,
(sum psi^2 / (m - q)) / mean(psi')^2 (J^T J)^-1 with the loss's influence psi; for least squares it
is the variance of the residuals, or 1 where standard deviations were given, times (J^T J)^-1.
P. J. Huber, Robust Statistics (1981); G. A. F. Seber and C. J. Wild, Nonlinear Regression (1989).

Two things lead to a grazing, beyond which derivatives do not hold: a boundary function whose
maximum inside a phase is nearly zero, and a boundary that is reached so slowly that the function
would turn soon behind it. The margin is how far the maximum, found or continued, is from zero, in
the unit of the boundary function; to first order it moves with the unknowns as the function at a
fixed time does. No maximum is missed.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from nonsmooth.runtime.core.complex_steps import imaginary_parts
from nonsmooth.runtime.core.errors import NonsmoothError, unknown_name
from nonsmooth.runtime.core.json_codec import AnyDigits, Digits
from nonsmooth.runtime.simulation.moved_phases import MovedPhases
from nonsmooth.runtime.simulation.phase_functions import boundary_rows, local_maxima, phases_of
from nonsmooth.runtime.simulation.trajectory import Trajectory

Loss = Callable[[np.ndarray], np.ndarray]
_NOTHING = 1e-9  # of the largest singular value: below it a combination is not identified
_TAKES_PART = 1e-4  # of a unit vector
_LEVEL = 0.95
_KEPT = 50  # approaches whose derivatives are asked for


def _huber(z: np.ndarray) -> np.ndarray:
    far = np.maximum(z, 1.0)
    outside = np.array([2 * np.sqrt(far) - 1, far**-0.5, -0.5 * far**-1.5])
    return np.where(z <= 1, LOSSES["linear"](z), outside)


LOSSES: Mapping[str, Loss] = {
    "linear": lambda z: np.array([z, np.ones_like(z), np.zeros_like(z)]),
    "soft_l1": lambda z: np.array(
        [2 * (np.sqrt(1 + z) - 1), (1 + z) ** -0.5, -0.5 * (1 + z) ** -1.5]
    ),
    "huber": _huber,
    "cauchy": lambda z: np.array([np.log1p(z), 1 / (1 + z), -1 / (1 + z) ** 2]),
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
        return np.concatenate([own(z[:count]), LOSSES["linear"](z[count:])], axis=1)

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


@dataclass(frozen=True, kw_only=True)
class NearestGrazing:
    """The place at which a fitted motion comes closest to grazing a boundary."""

    kind: Literal["missed", "slowly reached"]
    boundary: str
    configuration: str
    time: Digits  # of the motion, in the system's unit
    margin: Digits  # of the boundary function
    # the margin in its own standard errors, to first order: so far the unknowns may move; infinite
    # where none moves it, NaN where the uncertainty is not known
    standard_errors: AnyDigits


@dataclass(frozen=True)
class _Approach:
    """A place where a boundary function nearly has the maximum zero."""

    kind: Literal["missed", "slowly reached"]
    phase: int
    boundary: int
    since: float  # time since the phase's beginning
    margin: float


def nearest(found: Iterable[NearestGrazing | None]) -> NearestGrazing | None:
    """The grazing that is the fewest standard errors away."""

    def far(each: NearestGrazing) -> tuple[float, float]:
        distance = each.standard_errors
        return (np.inf if np.isnan(distance) else distance, each.margin)

    return min((each for each in found if each is not None), key=far, default=None)


def nearest_grazing(
    motion: Trajectory,
    moved: Callable[[], MovedPhases],
    columns: Sequence[int],
    covariance: np.ndarray,
) -> NearestGrazing | None:
    """The place where a motion is the fewest standard errors from grazing, or None.

    It is None if no boundary function has a maximum in a phase. `moved` gives the phases as they
    move with the unknowns in `columns`, of which `covariance` (q, q) is; without derivatives the
    distance is NaN.
    """
    structure = motion.structure
    found = sorted(_approaches(motion), key=lambda each: each.margin)[:_KEPT]
    if not found:
        return None
    gradients = np.zeros((len(found), len(covariance)))
    try:
        if columns:
            gradients[:, list(columns)] = _gradients(moved(), found)
    except NonsmoothError:
        gradients[:] = np.nan

    def told(each: _Approach, gradient: np.ndarray) -> NearestGrazing:
        configuration = int(motion.run.configurations[each.phase])
        return NearestGrazing(
            kind=each.kind,
            boundary=structure.boundaries[configuration][each.boundary].name,
            configuration=structure.configurations[configuration],
            time=float(motion.times[each.phase]) + each.since,
            margin=each.margin,
            standard_errors=_distance(each.margin, gradient, covariance),
        )

    return nearest(map(told, found, gradients))


def _gradients(moved: MovedPhases, found: Sequence[_Approach]) -> np.ndarray:
    """Derivatives (n, q) of the margins."""
    places = np.array([each.phase for each in found])
    since = np.array([each.since for each in found])
    shapes = moved.system.structure.boundaries
    rows = [shapes[moved.phases.configurations[a.phase]][a.boundary].row for a in found]
    missed = np.array([each.kind == "missed" for each in found])
    gradients = np.empty((len(found), len(moved.numbers.rows)))
    normals = moved.numbers.rows[:, np.array(rows)[missed]]
    inside = moved.differentiated(normals, places[missed], since[missed])
    for place in range(len(found)):
        if missed[place]:
            gradients[place] = -next(inside).rates
        else:
            gradients[place] = imaginary_parts(
                _height(*moved.arrival(places[place], rows[place])), None
            )
    return gradients


def _height(speed: Any, bend: Any) -> Any:
    """What a boundary function that is reached would rise to behind it, with such derivatives."""
    return speed**2 / (-2 * bend)


def _distance(margin: float, gradient: np.ndarray, covariance: np.ndarray) -> float:
    moved = np.flatnonzero(gradient)
    variance = float(gradient[moved] @ covariance[np.ix_(moved, moved)] @ gradient[moved])
    if not variance >= 0:  # NaN: an unknown that nothing tells, or at its bound
        return float("nan")
    return margin / float(np.sqrt(variance)) if variance > 0 else float("inf")


def _approaches(motion: Trajectory) -> Iterator[_Approach]:
    """Maxima of boundary functions inside phases, and slow arrivals at their ends."""
    system, structure = motion.system, motion.structure
    if not any(structure.boundaries) or not motion.end > 0:
        return
    for phase, reached in enumerate(motion.boundaries[1:]):
        configuration = int(motion.run.configurations[phase])
        field = system.fields[configuration]
        rate = field @ np.append(motion.before[phase + 1], 1.0)
        for place, shape in enumerate(structure.boundaries[configuration]):
            if shape.name in reached:
                normal = system.rows[shape.row, :-1]
                speed, bend = float(normal @ rate), float(normal @ field[:, :-1] @ rate)
                if speed > 0 > bend:
                    since = float(motion.times[phase + 1] - motion.times[phase])
                    yield _Approach("slowly reached", phase, place, since, _height(speed, bend))
    for found in local_maxima(system, phases_of(motion), boundary_rows(system)):
        if found.value < 0:
            yield _Approach("missed", found.phase, found.function, found.since, -found.value)
