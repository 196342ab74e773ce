"""`Fit`: estimates with their uncertainties, and how well the motion says what was measured."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import AnyRow, AnyTable, Digits, Row, Table, Told
from nonsmooth.runtime.core.registry import Kept, registered
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.explore.fitting.measurements import MeasuredSeries
from nonsmooth.runtime.explore.fitting.nearest_grazing import NearestGrazing, nearest
from nonsmooth.runtime.explore.fitting.statistics import combination_text
from nonsmooth.runtime.model.kernels import known_system
from nonsmooth.runtime.model.saved_system import KeptSystemName
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.table_solve import solve_itinerary
from nonsmooth.runtime.simulation.simulate import simulate_one
from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["Fit", "FittedExperiment", "FittedResponse", "FittedSeries"]


@dataclass(frozen=True, eq=False, kw_only=True)
class FittedSeries(MeasuredSeries):
    """One column of measurements with the fitted values."""

    fitted: Row  # (m,)
    sigma: Row  # (m,), standard deviations used as weights, given or estimated

    @Told
    def residuals(self) -> AnyRow:
        """Measured minus fitted (m,), in standard deviations."""
        return np.asarray((self.values - self.fitted) / self.sigma)


@dataclass(frozen=True, eq=False, kw_only=True)
class FittedResponse:
    """The steady response that belongs to a row of measurements."""

    parameters: Mapping[str, Value]  # all of them
    # configurations and the boundaries that end them, or ``forcing-phase`` without one
    itinerary: tuple[tuple[str, str], ...]
    dwell_times: Row  # (p,)
    start: Row  # (N,), state at the start of the first phase
    stability: str
    grazing: NearestGrazing | None  # where it comes closest to grazing a boundary

    @property
    def period(self) -> float:
        """Sum of the dwell times."""
        return float(self.dwell_times.sum())


@dataclass(frozen=True, eq=False, kw_only=True)
class FittedExperiment:
    """One experiment at the fit."""

    name: str
    # all of them, fitted or known; of steady responses those that all rows share
    parameters: Mapping[str, Value]
    # (N,), state at the start of the motion; like all that belongs to a motion, empty for steady
    # responses
    start: Row
    offset: Digits  # reading of the clock of the data at the start
    until: Digits  # end of the motion, on its own clock
    series: tuple[FittedSeries, ...]
    configurations: tuple[str, ...]  # those that the fitted motion passes
    boundaries: tuple[str, ...]  # those that end them; several reached together are joined by ``+``
    # whether the motion reaches the recorded boundaries as often and in the order of the data; None
    # if no events were recorded
    same_sequence: bool | None
    grazing: NearestGrazing | None  # where the motion comes closest to grazing a boundary
    responses: tuple[FittedResponse, ...] = ()  # of each row, for steady responses
    along: str = ""  # first parameter that varies from row to row, empty if none does


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class Fit(Kept):
    """Parameters that were identified from measurements; q of them are free.

    Attributes
    ----------
    system : str
    names : tuple of str
        Of the free numbers.
    estimates : array (q,)
    lower, upper : array (q,)
        Ends of the 95 % intervals: by Student's t with the degrees of freedom, or by the normal
        law where all standard deviations were given and the loss is linear. Infinite where the
        data do not tell, or leave no degree of freedom to tell the noise; NaN at a bound, see
        `untold`.
    covariance : array (q, q)
        To first order, at the estimates.
    bounds : array (q, 2)
    at_bound : tuple of str
        Those that the data push against a bound.
    priors : dict of str to (float, float)
        Means and standard deviations.
    chi2 : float
        Sum of the squared residuals in standard deviations, those of priors too.
    data : int
        How many numbers were measured.
    degrees_of_freedom : int
        Data and priors, less the free numbers.
    noise : dict of str to float
        Estimated standard deviations of columns that were given none.
    loss : str
    singular_values : array (k,)
        Of the Jacobian of the residuals by relative changes of the unknowns that are not at a
        bound: by how many standard deviations the data move for each of the combinations.
    combinations : array (k, q)
        Of relative changes, in rows, as unit vectors.
    unidentified : tuple of str
        Combinations that nothing measured tells, in words.
    experiments : tuple of FittedExperiment
    status : {"converged", "not converged"}
    message : str
        Why the search ended.
    evaluations : int
    starts : array (n, q)
        Where the searches began.
    costs : array (n,)
        Half the loss at which each ended; NaN where it was not begun.
    """

    system: KeptSystemName
    names: tuple[str, ...]
    estimates: Row
    lower: AnyRow
    upper: AnyRow
    covariance: AnyTable
    bounds: AnyTable
    at_bound: tuple[str, ...]
    priors: Mapping[str, tuple[Digits, Digits]]
    chi2: Digits
    data: int
    degrees_of_freedom: int
    noise: Mapping[str, Digits]
    loss: str
    singular_values: Row
    combinations: Table
    unidentified: tuple[str, ...]
    experiments: tuple[FittedExperiment, ...]
    status: Literal["converged", "not converged"]
    message: str
    evaluations: int
    starts: Table
    costs: AnyRow

    def __getitem__(self, name: str) -> float:
        """The estimate of a free number."""
        if name not in self.names:
            raise KeyError(name)
        return float(self.estimates[self.names.index(name)])

    @Told
    def standard_errors(self) -> AnyRow:
        """Standard errors of the estimates, (q,)."""
        return np.sqrt(np.diag(self.covariance))

    @property
    def untold(self) -> dict[str, str]:
        """Why free numbers have no standard error, by their names."""
        why = "not told by the data"
        if not self.unidentified:
            why = "no degree of freedom tells its error"
        lost = {
            name: why
            for name, error in zip(self.names, self.standard_errors.tolist(), strict=True)
            if not math.isfinite(error)
        }
        return lost | {name: "at its bound" for name in self.at_bound}

    @Told
    def correlation(self) -> AnyTable:
        """Correlations of the estimates, (q, q)."""
        errors = self.standard_errors
        with np.errstate(invalid="ignore"):
            return np.asarray(self.covariance / np.outer(errors, errors))

    @Told
    def residuals(self) -> AnyRow:
        """Measured minus fitted, in standard deviations, of all series in order, (m,)."""
        parts = [series.residuals for each in self.experiments for series in each.series]
        return np.concatenate(parts)

    @Told
    def same_sequence(self) -> bool | None:
        """Whether all recorded events follow each other as in the data; None without any."""
        found = [each.same_sequence for each in self.experiments]
        known = [each for each in found if each is not None]
        return all(known) if known else None

    @property
    def grazing(self) -> NearestGrazing | None:
        """The nearest grazing of all experiments, in standard errors."""
        return nearest(each.grazing for each in self.experiments)

    @property
    def identified(self) -> tuple[tuple[str, float], ...]:
        """Combinations and their relative standard errors before scaling, best known first."""
        return tuple(
            (combination_text(self.names, row), 1 / float(size) if size else float("inf"))
            for row, size in zip(self.combinations, self.singular_values, strict=True)
        )

    def experiment(self, number: int) -> FittedExperiment:
        """Give an experiment.

        Parameters
        ----------
        number : int
            From 0.

        Returns
        -------
        FittedExperiment

        Raises
        ------
        InputError
            If there is no such experiment.
        """
        count = len(self.experiments)
        if not -count <= number < count:
            raise InputError(f"there are {count} experiments, from 0")
        return self.experiments[number]

    def motion(self, experiment: int = 0) -> Trajectory:
        """Follow the fitted motion of an experiment.

        Parameters
        ----------
        experiment : int
            Its number, from 0.

        Returns
        -------
        Trajectory
            On its own clock: time zero is `offset` on that of the data.

        Raises
        ------
        InputError
            If there is no such experiment, or it holds steady responses.
        """
        found = self.experiment(experiment)
        if found.responses:
            raise InputError(f"{found.name} holds steady responses: ask for a `response`")
        return simulate_one(
            known_system(self.system), found.parameters, found.start.tolist(), until=found.until
        )

    def response(self, row: int, experiment: int = 0) -> Orbit:
        """Give the steady response that belongs to a row of measurements.

        Parameters
        ----------
        row : int
            Its number, from 0.
        experiment : int
            Its number, from 0.

        Returns
        -------
        Orbit

        Raises
        ------
        InputError
            If there is no such row or experiment.
        """
        found = self.experiment(experiment)
        count = len(found.responses)
        if not -count <= row < count:
            raise InputError(f"{found.name} has {count} steady responses, from 0")
        response = found.responses[row]
        return solve_itinerary(
            known_system(self.system),
            response.parameters,
            response.itinerary,
            response.dwell_times.tolist(),
            response.start.tolist(),
        )

    def plot(self, axes: Any = None, *, experiment: int = 0) -> Any:
        """Draw what was measured over the fitted motion or responses, and the residuals below.

        Parameters
        ----------
        axes : sequence of two matplotlib Axes, optional
            Where to draw; a figure of its own when omitted.
        experiment : int
            Its number, from 0.

        Returns
        -------
        array of matplotlib Axes
            What was drawn on.
        """
        return registered("plot_fit")(self, axes, experiment)
