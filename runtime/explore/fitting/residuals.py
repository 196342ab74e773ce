"""Weighted residuals of all experiments and priors, and their exact Jacobian."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from nonsmooth.runtime.core.errors import NonsmoothError
from nonsmooth.runtime.explore.fitting.measurements import Measured, MeasuredSeries
from nonsmooth.runtime.explore.fitting.prediction import Prediction, predict
from nonsmooth.runtime.explore.fitting.response_prediction import (
    SteadyPrediction,
    look,
    points_under,
    predict_steady,
)
from nonsmooth.runtime.explore.fitting.steady_orbits import KnownResponses
from nonsmooth.runtime.explore.fitting.unknowns import Unknowns
from nonsmooth.runtime.model.kernels import SystemKernels

__all__ = ["FitProblem", "Residuals"]

AnyPrediction = Prediction | SteadyPrediction
Noise = Mapping[str, float]  # standard deviations of columns that have none of their own


@dataclass(frozen=True, eq=False)
class Residuals:
    """Residuals at one point: those of the data, then those of the priors."""

    values: np.ndarray  # (m + p,), predicted minus measured, in standard deviations
    jacobian: np.ndarray  # (m + p, q)
    predictions: tuple[AnyPrediction, ...]  # one for each experiment, empty where there is no value


@dataclass(frozen=True, eq=False)
class FitProblem:
    """A least-squares problem."""

    kernels: SystemKernels
    experiments: tuple[Measured, ...]
    unknowns: Unknowns
    # steady responses that are known so far, from which others are followed
    responses: KnownResponses = field(default_factory=KnownResponses)

    @property
    def series(self) -> tuple[tuple[int, MeasuredSeries], ...]:
        """All series, each with the number of its experiment."""
        return tuple((n, each) for n, e in enumerate(self.experiments) for each in e.series)

    @property
    def data(self) -> int:
        """Number of measured values."""
        return sum(len(series.values) for _, series in self.series)

    @property
    def passed(self) -> np.ndarray:
        """Fraction of its record that has passed at each datum, (m,); 0 for steady responses."""
        found = []
        for each in self.experiments:
            if each.steady:
                found += [np.zeros(len(series.values)) for series in each.series]
                continue
            length = (each.last - each.first) or 1.0
            found += [(series.times - each.first) / length for series in each.series]
        return np.concatenate(found)

    def beginning(self, part: float) -> FitProblem:
        """The same problem with only the first part of the record of each motion.

        `part` is a fraction of the time between the first and the last datum of an experiment.
        """
        experiments = []
        for each in self.experiments:
            if each.steady:
                experiments.append(each)
                continue
            last = each.first + part * (each.last - each.first)
            kept = (_until(series, last) for series in each.series)
            series = tuple(found for found in kept if len(found.values))
            experiments.append(replace(each, series=series))
        return replace(self, experiments=tuple(experiments))

    def sigma(self, series: MeasuredSeries, noise: Noise) -> np.ndarray:
        """Standard deviations (m,) of a series."""
        given = series.sigma
        return np.where(np.isnan(given), noise.get(series.name, np.nan), given)

    def look_again(self, point: np.ndarray) -> bool:
        """Search for steady responses other than the known ones; False if none are measured."""
        for number, each in enumerate(self.experiments):
            if each.steady:
                points = points_under(each, self.unknowns, number, point)
                by = list(self.unknowns.columns(number))
                look(self.kernels, each, number, points, by, self.responses)
        return any(each.steady for each in self.experiments)

    def predictions(self, point: np.ndarray) -> tuple[AnyPrediction, ...]:
        """The predictions of all experiments at a point (q,).

        Raises `NonsmoothError` if one of them does not exist.
        """
        return tuple(
            predict_steady(self.kernels, experiment, self.unknowns, number, point, self.responses)
            if experiment.steady
            else predict(self.kernels, experiment, self.unknowns, number, point)
            for number, experiment in enumerate(self.experiments)
        )

    def weighted(
        self, point: np.ndarray, predictions: Sequence[AnyPrediction], noise: Noise
    ) -> Residuals:
        """Residuals and Jacobian at a point (q,), from known predictions."""
        values, jacobians = [], []
        for experiment, found in zip(self.experiments, predictions, strict=True):
            for series, value, jacobian in zip(
                experiment.series, found.values, found.jacobians, strict=True
            ):
                sigma = self.sigma(series, noise)
                values.append((value - series.values) / sigma)
                jacobians.append(jacobian / sigma[:, None])
        for place, mean, deviation in self.unknowns.priors:
            values.append(np.array([(point[place] - mean) / deviation]))
            jacobians.append(np.eye(1, len(point), place) / deviation)
        return Residuals(np.concatenate(values), np.concatenate(jacobians), tuple(predictions))

    def residuals(self, point: np.ndarray, noise: Noise) -> Residuals:
        """Residuals and Jacobian at a point (q,); NaN without a motion or derivative."""
        try:
            return self.weighted(point, self.predictions(point), noise)
        except (NonsmoothError, ArithmeticError, np.linalg.LinAlgError):
            count = self.data + len(self.unknowns.priors)
            return Residuals(np.full(count, np.nan), np.full((count, len(point)), np.nan), ())


def _until(series: MeasuredSeries, last: float) -> MeasuredSeries:
    """The part of a series until a time on the clock of the data."""
    kept = series.times <= last
    columns = ("places", "times", "values", "sigma")
    return replace(series, **{name: getattr(series, name)[kept] for name in columns})
