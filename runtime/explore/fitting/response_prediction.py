"""What steady responses say of the measurements at a point of the unknowns, with derivatives.

At each row's parameters there may be several responses: the one next to what was measured is
taken, in standard deviations, or in terms of the spread of a column where these are not known.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from nonsmooth.runtime.core.errors import InputError, NoConvergence, NonsmoothError
from nonsmooth.runtime.explore.fitting.measurements import Measured
from nonsmooth.runtime.explore.fitting.response_quantities import (
    ResponseQuantity,
    response_quantity,
)
from nonsmooth.runtime.explore.fitting.steady_orbits import (
    KnownResponses,
    Point,
    responses_at,
    survey,
    survey_of,
)
from nonsmooth.runtime.explore.fitting.unknowns import Unknowns
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.derivatives import OrbitDerivatives
from nonsmooth.runtime.orbits.orbit import Orbit

__all__ = ["SteadyPrediction", "look", "points_under", "predict_steady"]

_TURN = 2 * np.pi


@dataclass(frozen=True, eq=False)
class SteadyPrediction:
    """Steady responses at one point of the unknowns, and their predictions."""

    # one for each row, with derivatives by the free parameters
    orbits: tuple[OrbitDerivatives, ...]
    values: tuple[np.ndarray, ...]  # (m,) for each series
    jacobians: tuple[np.ndarray, ...]  # (m, q) for each series, by all unknowns


def points_under(
    experiment: Measured, unknowns: Unknowns, number: int, at: np.ndarray
) -> list[Point]:
    """All parameters of each row of an experiment (`number`, from 0) at unknowns `at` (q,)."""
    shared = unknowns.condition(at, number).parameters
    return [{**shared, **own} for own in experiment.points]


def look(
    kernels: SystemKernels,
    experiment: Measured,
    number: int,
    points: Sequence[Point],
    by: Sequence[str],
    known: KnownResponses,
) -> None:
    """Search for the responses of an experiment, and add them to those that are known.

    `number` is that of the experiment, from 0; `points` are all parameters of each row; `by`
    lists the free parameters.
    """
    # swept along the parameters, whatever the order of the rows
    order = sorted(range(len(points)), key=lambda row: [*experiment.points[row].values()])
    swept = [points[row] for row in order]
    if experiment.itinerary is None:
        found = survey(kernels, swept)
    else:
        found = survey_of(kernels, swept, experiment.itinerary)
    for row, orbits in zip(order, found, strict=True):
        seen = [each for orbit in orbits if (each := _differentiated(orbit, by)) is not None]
        known.keep(number, row, [*seen, *known.at(number, row)])


def _differentiated(orbit: Orbit, by: Sequence[str]) -> OrbitDerivatives | None:
    try:
        return orbit.derivatives(list(by))
    except NonsmoothError:  # a border collision
        return None


def predict_steady(
    kernels: SystemKernels,
    experiment: Measured,
    unknowns: Unknowns,
    number: int,
    point: np.ndarray,
    known: KnownResponses,
) -> SteadyPrediction:
    """The prediction for an experiment with steady responses, at a point (q,) of the unknowns.

    The responses are followed from those in `known`, which are updated. `number` is that of the
    experiment, from 0. Raises `NoConvergence` if there is no stable periodic response, or if it
    has no derivative.
    """
    points = points_under(experiment, unknowns, number, point)
    columns = unknowns.columns(number)
    if not known.known(number):
        look(kernels, experiment, number, points, list(columns), known)
    structure = structure_of(kernels)
    quantities = [response_quantity(each.expression, structure) for each in experiment.series]
    measured = np.full((len(points), len(quantities)), np.nan)
    scales = np.ones_like(measured)
    for place, series in enumerate(experiment.series):
        measured[series.places, place] = series.values
        usual = float(np.std(series.values)) or float(abs(series.values).max()) or 1.0
        scales[series.places, place] = np.where(np.isnan(series.sigma), usual, series.sigma)
    told = np.zeros_like(measured)
    rates = np.zeros((*measured.shape, len(columns)))
    chosen: list[OrbitDerivatives] = []
    for row, parameters in enumerate(points):
        found, lost = responses_at(
            kernels,
            parameters,
            list(columns),
            known.at(number, row),
            unstable=experiment.itinerary is not None,
        )
        best = np.inf
        for each in found:
            seen = _seen(each, quantities, measured[row])
            if seen is None:
                continue
            missed = float(np.nansum(((seen[0] - measured[row]) / scales[row]) ** 2))
            if missed < best:
                best, (told[row], rates[row]) = missed, seen
                chosen = [*chosen[:row], each]
        if len(chosen) <= row:
            raise NoConvergence(
                f"{experiment.name}: no {_sought(experiment)} response was found in row {row + 1}"
                f"{_place(experiment, row)}"
            )
        others = [each for each in found if each is not chosen[row]]
        known.keep(number, row, [chosen[row], *others, *lost])
    values: list[np.ndarray] = []
    jacobians: list[np.ndarray] = []
    for place, series in enumerate(experiment.series):
        jacobian = np.zeros((len(series.values), len(point)))
        jacobian[:, list(columns.values())] = rates[series.places, place]
        values.append(told[series.places, place])
        jacobians.append(jacobian)
    return SteadyPrediction(tuple(chosen), tuple(values), tuple(jacobians))


def _seen(
    orbit: OrbitDerivatives, quantities: Sequence[ResponseQuantity], measured: np.ndarray
) -> tuple[np.ndarray, np.ndarray] | None:
    """Predicted values and slopes of a row, for one response; None without a derivative.

    Angles are those next to the measured ones.
    """
    values = np.zeros(len(quantities))
    slopes = np.zeros((len(quantities), len(orbit.by)))
    for place, quantity in enumerate(quantities):
        if np.isnan(measured[place]):
            continue
        try:
            value, slope = quantity.of(orbit)
        except InputError:
            return None
        if quantity.periodic:
            value += _TURN * np.round((measured[place] - value) / _TURN)
        if not (np.isfinite(value) and np.isfinite(slope).all()):
            return None
        values[place], slopes[place] = value, slope
    return values, slopes


def _sought(experiment: Measured) -> str:
    return "stable periodic" if experiment.itinerary is None else "such periodic"


def _place(experiment: Measured, row: int) -> str:
    told = ", ".join(f"{name} = {value:.6g}" for name, value in experiment.points[row].items())
    return f" ({told})" if told else ""
