"""`fit`: parameters, starts and clocks from what was measured of motions, with uncertainties."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from operator import attrgetter
from typing import Any, Literal

import numpy as np

from nonsmooth.runtime.core.errors import InputError, Interrupted, unknown_name
from nonsmooth.runtime.core.json_codec import AnyRow, AnyTable, Digits, Row, Table, Told
from nonsmooth.runtime.core.registry import Kept, registered
from nonsmooth.runtime.core.values import Value, as_value, random_generator
from nonsmooth.runtime.explore.fitting.measurements import (
    Experiment,
    Measured,
    MeasuredSeries,
    boundary_named,
    measured,
)
from nonsmooth.runtime.explore.fitting.minimise import FitProblem, Minimum, minimise
from nonsmooth.runtime.explore.fitting.prediction import points_under, times_of_events
from nonsmooth.runtime.explore.fitting.statistics import (
    NearestGrazing,
    check_loss,
    combination_text,
    nearest,
    nearest_grazing,
    statistics,
)
from nonsmooth.runtime.explore.fitting.unknowns import Bounds, unknowns_of
from nonsmooth.runtime.model.kernels import SystemKernels, kernels_of, known_system
from nonsmooth.runtime.model.loading.declared import DeclaredSystem
from nonsmooth.runtime.model.saved_system import KeptSystemName
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.table_solve import solve_itinerary
from nonsmooth.runtime.simulation.simulate import checked_count, simulate_one
from nonsmooth.runtime.simulation.trajectory import Trajectory

_AT_BOUND = 1e-6  # of the width between the bounds
_PAST = 1e-9  # of the length of a record: a motion ends behind its last event
_NOTHING = 1e-13  # of a residual's change, for a change of the unknown by its own size


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


def fit(
    system: str | SystemKernels | DeclaredSystem,
    data: Any,
    *,
    free: Sequence[str] = (),
    parameters: Mapping[str, object] | None = None,
    bounds: Bounds | None = None,
    priors: Mapping[str, tuple[object, object]] | None = None,
    start: Mapping[str, object] | None = None,
    offset: float = 0.0,
    outputs: Mapping[str, str] | None = None,
    events: Sequence[str] | Mapping[str, str] = (),
    responses: Mapping[str, str] | None = None,
    sigma: Mapping[str, float] | float | None = None,
    loss: str = "linear",
    starts: int = 1,
    rng: int | np.random.SeedSequence | np.random.Generator | None = 0,
    progress: Callable[[int, int], None] = lambda done, total: None,
) -> Fit:
    """Find parameters from measured series, event times and steady responses, by least squares.

    The derivatives are exact, through all events. A trial point without a motion as long as the
    record or without a steady response, or at which it grazes a boundary, is answered by a
    shorter step.

    Parameters
    ----------
    system : str, System or SystemKernels
    data : path, mapping of str to array, xarray.Dataset, Experiment, or a list of these
        One table for each experiment (`Experiment` says which columns). Missing values are NaN,
        or blank in a CSV file.
    free : sequence of str
        What is sought: parameters, states at the start (``x10`` of ``x1``), ``offset``; those that
        have bounds when omitted. Starts and offsets are sought for each experiment.
    parameters : mapping of str to number
        All other parameters, and guesses of free ones.
    bounds : mapping of str to (lower, upper), optional
        None or infinity for no bound. A free one without a guess starts in their middle.
    priors : mapping of str to (mean, standard deviation), optional
        What is known of free ones before, as further residuals.
    start : mapping of state to number
        Where motions start; guesses of free ones.
    offset : float
        What the clock of the data shows when the motion starts, in the system's unit of time.
    outputs : mapping of str to str, optional
        From columns to affine expressions of the states, of accelerations as ``acceleration:x``
        and of forces of contacts as ``force:wall``; a column with the name of a state is it.
    events : sequence of str, or mapping of str to str, optional
        Columns that hold times of events, and the boundaries that are reached then. A column with
        the name of a boundary needs no mention. The n-th entry belongs to the n-th time at which
        the motion reaches it; NaN stands for one that was not recorded.
    responses : mapping of str to str, optional
        From columns to what was measured of steady responses, each row at parameters that it
        tells in other columns, such as the frequency of the forcing: ``amplitude:x`` (half of
        the way from the smallest to the largest value), ``maximum:``, ``minimum:``, ``peak:``
        (of the absolute value), ``mean:``, ``rms:``, and of the first harmonic ``harmonic:`` (its
        amplitude) and ``phase:`` (in radians against the cosine of the first forcing, negative
        where it lags); behind the colon an expression as for `outputs`. A column of such a name
        needs no mention.
    sigma : mapping of str to float, or float, optional
        Standard deviations of columns that have no ``sigma_NAME`` beside them. Estimated from the
        residuals of each column where they are not given.
    loss : {"linear", "soft_l1", "huber", "cauchy"}
        The latter three heed outliers less.
    starts : int
        Searches: from the guess, and from points drawn between the bounds or from the priors.
    rng : int, SeedSequence, Generator or None
        Of NumPy, for these points: equal seeds give equal ones, None others each time.
    progress : callable, optional
        Told how many searches are done, and of how many.

    Returns
    -------
    Fit

    Raises
    ------
    InputError
        For wrong names or numbers, too few data, a free parameter on which nothing measured
        depends, or no motion at the guess. One line, which names the file and the column.
    Interrupted
        By Ctrl-C, once a search is done; its `partial` is the best Fit until then.

    Examples
    --------
    >>> import numpy as np
    >>> import nonsmooth as ns
    >>> known = {"m1": 1, "m2": 2, "k1": 1, "k2": 5}
    >>> motion = ns.simulate("rigid-stop", known | {"r": "0.8"}, [0, 0, 1.5, 0], until=12)
    >>> times = np.linspace(0.1, 12, 60)
    >>> start = {"x1": 0, "x2": 0, "v1": 1.5, "v2": 0}
    >>> found = ns.fit(
    ...     "rigid-stop", {"t": times, "x1": motion(times)[:, 0]},
    ...     parameters=known, bounds={"r": (0.5, 1)}, start=start,
    ... )
    >>> round(found["r"], 9)
    0.8
    """
    kernels = kernels_of(system)
    structure = structure_of(kernels)
    check_loss(loss)
    count = checked_count("starts", starts, 1)
    wanted = outputs or {}
    where = events if isinstance(events, Mapping) else {name: name for name in events}
    reached = {column: boundary_named(structure, name) for column, name in where.items()}
    tables = [
        each if isinstance(each, Experiment) else Experiment(data=each) for each in _each(data)
    ]
    if not tables:
        raise InputError("there are no data")
    names = [table.name for table in kernels.parameters]
    steady = responses or {}
    experiments = tuple(
        measured(
            each,
            each.name or f"experiment {number}",
            structure,
            names,
            wanted,
            reached,
            steady,
            sigma,
        )
        for number, each in enumerate(tables, 1)
    )
    for column in steady:
        if not any(column == series.name for each in experiments for series in each.series):
            raise unknown_name("column", column, [s.name for e in experiments for s in e.series])
    limits = bounds or {}
    unknowns = unknowns_of(
        kernels,
        experiments,
        parameters=parameters or {},
        free=list(free) or list(limits),
        bounds=limits,
        priors=priors or {},
        start=start or {},
        offset=offset,
    )
    problem = FitProblem(kernels, experiments, unknowns, loss)
    _check_count(problem)
    minimum = minimise(problem, count, random_generator(rng), progress)
    found = _fit(minimum)
    if minimum.interrupted:
        raise Interrupted(found)
    return found


def _each(data: Any) -> list[Any]:
    """A list of the experiments."""
    if isinstance(data, Mapping | str | os.PathLike | Experiment) or hasattr(data, "data_vars"):
        return [data]
    try:
        return list(data)
    except TypeError:
        raise InputError(f"data are no table: {type(data).__name__}") from None


def _check_count(problem: FitProblem) -> None:
    count = problem.data + len(problem.unknowns.priors)
    needed = len(problem.unknowns.names)
    estimated = any(np.isnan(series.sigma).any() for series in problem.series)
    if count < needed + estimated:
        what = "one more, as the noise is estimated too" if estimated else "so many"
        raise InputError(
            f"{problem.data} measured numbers are too few for {needed} free ones"
            f" ({', '.join(problem.unknowns.names)}): {needed + estimated} are needed, {what}"
        )


def _fit(found: Minimum) -> Fit:
    """The result of a fit, from a minimum."""
    problem = found.problem
    unknowns, point, residuals = problem.unknowns, found.point, found.residuals
    names, sizes = unknowns.names, unknowns.sizes(point)
    moved = abs(residuals.jacobian[: problem.data] * sizes).max(axis=0)
    for name, value, change in zip(names, point, moved, strict=True):
        if change <= _NOTHING:
            raise InputError(
                f"nothing that was measured depends on {name} (at {name} = {value:.6g}):"
                " leave it out of what is free"
            )
    width = unknowns.upper - unknowns.lower
    near = _AT_BOUND * np.where(np.isinf(width), np.maximum(abs(point), 1), width)
    held = (point - unknowns.lower <= near) | (unknowns.upper - point <= near)
    told = statistics(
        sizes,
        residuals.values,
        residuals.jacobian,
        problem.data,
        loss=problem.loss,
        given=not problem.noise,
        held=held,
    )
    return Fit(
        system=problem.kernels.name,
        names=names,
        estimates=point,
        lower=point - told.half_widths,
        upper=point + told.half_widths,
        covariance=told.covariance,
        bounds=np.stack([unknowns.lower, unknowns.upper], axis=1),
        at_bound=tuple(name for name, on in zip(names, held, strict=True) if on),
        priors={names[place]: prior for place, prior in unknowns.priors.items()},
        chi2=float((residuals.values**2).sum()),
        data=problem.data,
        degrees_of_freedom=len(residuals.values) - len(names),
        noise=problem.noise,
        loss=problem.loss,
        singular_values=told.singular_values,
        combinations=told.combinations,
        unidentified=tuple(
            combination_text(names, told.combinations[place]) for place in told.unidentified
        ),
        experiments=tuple(
            _experiment(number, found, told.covariance)
            for number in range(len(problem.experiments))
        ),
        status="converged" if found.converged else "not converged",
        message=found.message,
        evaluations=found.evaluations,
        starts=found.starts,
        costs=found.costs,
    )


def _experiment(number: int, found: Minimum, covariance: np.ndarray) -> FittedExperiment:
    problem, prediction = found.problem, found.residuals.predictions[number]
    experiment = problem.experiments[number]
    setting = problem.unknowns.at(found.point, number)
    columns = [*setting.columns.values()]
    series = tuple(
        FittedSeries(**{**vars(each), "sigma": problem.sigma(each)}, fitted=values)
        for each, values in zip(experiment.series, prediction.values, strict=True)
    )
    parameters = {name: as_value(value) for name, value in setting.parameters.items()}
    if experiment.steady:
        responses = tuple(
            FittedResponse(
                parameters={name: as_value(value) for name, value in point.items()},
                itinerary=each.orbit.itinerary,
                dwell_times=each.orbit.dwell_times.astype(float),
                start=each.orbit.states[0].astype(float),
                stability=each.orbit.stability.verdict,
                grazing=nearest_grazing(
                    each.orbit.trajectory(),
                    partial(attrgetter("along.moved"), each),
                    columns,
                    covariance,
                ),
            )
            for point, each in zip(
                points_under(experiment, setting), prediction.orbits, strict=True
            )
        )
        return FittedExperiment(
            name=experiment.name,
            parameters=parameters,
            start=np.empty(0),
            offset=0.0,
            until=0.0,
            series=series,
            configurations=(),
            boundaries=(),
            same_sequence=None,
            grazing=nearest(each.grazing for each in responses),
            responses=responses,
            along=_along(experiment),
        )
    assert prediction.motion is not None
    # no farther than the record: what the motion does later concerns no datum
    last = [float(values.max()) - setting.offset for values in prediction.values]
    length = max([experiment.last - setting.offset, *last]) * (1 + _PAST)
    motion = simulate_one(problem.kernels, setting.parameters, setting.start, until=length)
    return FittedExperiment(
        name=experiment.name,
        parameters=parameters,
        start=motion.states[0],
        offset=setting.offset,
        until=motion.end,
        series=series,
        configurations=motion.configurations,
        boundaries=tuple("+".join(names) for names in motion.boundaries[1:]),
        same_sequence=_same_sequence(experiment, prediction.motion, setting.offset),
        grazing=nearest_grazing(
            motion,
            lambda: motion.derivatives([*setting.columns]).moved_phases(),
            columns,
            covariance,
        ),
    )


def _along(experiment: Measured) -> str:
    """The first parameter that was varied from row to row."""
    first = experiment.points[0]
    varied = (name for name in first if any(p[name] != first[name] for p in experiment.points))
    return next(varied, "")


def _same_sequence(experiment: Measured, motion: Trajectory, offset: float) -> bool | None:
    """Whether the motion reaches the recorded boundaries as often and in the order of the data.

    Only events up to the last recorded one count; those of which no time was recorded are where
    the motion has them. It is None if no events were recorded.
    """
    events = [each for each in experiment.series if each.kind == "event"]
    if not events:
        return None
    recorded: list[tuple[float, str]] = []
    predicted: list[tuple[float, str]] = []
    counts = []
    for each in events:
        reached = offset + motion.times[times_of_events(motion, each.expression)]
        times = reached[: each.places[-1] + 1].copy()
        predicted += [(time, each.expression) for time in times.tolist()]
        times[each.places] = each.values
        recorded += [(time, each.expression) for time in times.tolist()]
        counts.append((reached, len(times)))
    if [name for _, name in sorted(recorded)] != [name for _, name in sorted(predicted)]:
        return False
    last, _ = max(predicted)
    return all(np.count_nonzero(reached <= last) == count for reached, count in counts)
