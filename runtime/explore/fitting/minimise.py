"""The search: SciPy's `least_squares` from one start or many, and the noise that was not given.

What it makes small are weighted residuals of all experiments and priors, with exact Jacobians.

Trust regions reject a trial point whose residuals are not finite and take a quarter of the step:
so motions that do not exist, are too short or graze a boundary end no search. The noise of columns
without standard deviations is estimated from their residuals, in turn with the parameters.

The longer a record, the more minima its sum of squares has. So each start is searched from twice:
directly, and by way of longer and longer beginnings of the records. Where steady responses are
measured, others than those that were followed are looked for at the end, and the search goes on.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, NoConvergence, NonsmoothError
from nonsmooth.runtime.explore.fitting.measurements import Measured, MeasuredSeries, usual_size
from nonsmooth.runtime.explore.fitting.prediction import (
    KnownResponses,
    Prediction,
    look,
    predict,
    predict_steady,
)
from nonsmooth.runtime.explore.fitting.statistics import loss_of
from nonsmooth.runtime.explore.fitting.unknowns import Unknowns
from nonsmooth.runtime.model.kernels import SystemKernels

_TOLERANCE = 1e-12
_MOST = 200  # evaluations of one search
_GROWTH = 1.4  # from one beginning of the records to the next
_ROUGHLY = 1e-4  # tolerance of searches over beginnings
_ROUNDS = 20  # of estimating the noise
_SETTLED = 1e-6  # relative change of the noise
_LEAST = 1e-12  # noise, as a part of the spread of the data
_LOOKS = 5  # for other steady responses
_SAME = 1e-6  # standard deviations: residuals of the responses that were known
_KEPT = 2  # trial points that are remembered: a derivative is asked for behind a value
_DRAWS = 100  # of a start at which there is a motion
_MEDIAN = 1.4826  # standard deviation of a normal variable over its median absolute value
_MESSAGES = {
    0: f"no minimum after {_MOST} evaluations",
    1: "the gradient vanishes",
    2: "the sum of squares does not change any more",
    3: "the unknowns do not change any more",
    4: "neither the sum of squares nor the unknowns change any more",
}


@dataclass(frozen=True, eq=False)
class Residuals:
    """Residuals at one point: those of the data, then those of the priors."""

    values: np.ndarray  # (m + p,), predicted minus measured, in standard deviations
    jacobian: np.ndarray  # (m + p, q)
    predictions: tuple[Prediction, ...]  # one for each experiment, empty where there is no value


@dataclass(frozen=True, eq=False)
class FitProblem:
    """A least-squares problem."""

    kernels: SystemKernels
    experiments: tuple[Measured, ...]
    unknowns: Unknowns
    loss: str
    # standard deviations of columns that have none of their own
    noise: Mapping[str, float] = field(default_factory=dict)
    # steady responses of each experiment that are known so far, from which others are followed
    responses: dict[int, KnownResponses] = field(default_factory=lambda: defaultdict(dict))

    @property
    def series(self) -> tuple[MeasuredSeries, ...]:
        """All series, experiment by experiment."""
        return tuple(series for each in self.experiments for series in each.series)

    @property
    def data(self) -> int:
        """Number of measured values."""
        return sum(len(series.values) for series in self.series)

    @property
    def passed(self) -> np.ndarray:
        """Fraction of its record that has passed at each datum, (m,); 0 for steady responses."""
        found = (each.passed(series) for each in self.experiments for series in each.series)
        return np.concatenate([*found])

    def beginning(self, part: float) -> FitProblem:
        """The same problem with only the first part of the record of each motion.

        `part` is a fraction of the time between the first and the last datum of an experiment.
        """
        experiments = []
        for each in self.experiments:
            kept = ((series, each.passed(series) <= part) for series in each.series)
            series = tuple(one.at(inside) for one, inside in kept if inside.any())
            experiments.append(replace(each, series=series))
        return replace(self, experiments=tuple(experiments))

    def sigma(self, series: MeasuredSeries) -> np.ndarray:
        """Standard deviations (m,) of a series."""
        given = series.sigma
        return np.where(np.isnan(given), self.noise.get(series.name, np.nan), given)

    def look_again(self, point: np.ndarray) -> bool:
        """Search for steady responses other than the known ones; False if none are measured."""
        for number, each in enumerate(self.experiments):
            if each.steady:
                look(self.kernels, each, self.unknowns.at(point, number), self.responses[number])
        return any(each.steady for each in self.experiments)

    def predictions(self, point: np.ndarray) -> tuple[Prediction, ...]:
        """The predictions of all experiments at a point (q,).

        Raises `NonsmoothError` if one of them does not exist.
        """
        settings = [self.unknowns.at(point, number) for number in range(len(self.experiments))]
        return tuple(
            predict_steady(self.kernels, experiment, settings[number], self.responses[number])
            if experiment.steady
            else predict(self.kernels, experiment, settings[number])
            for number, experiment in enumerate(self.experiments)
        )

    def residuals(self, point: np.ndarray) -> Residuals:
        """Residuals and Jacobian at a point (q,); NaN without a motion or derivative."""
        priors = self.unknowns.priors
        try:
            predictions = self.predictions(point)
        except (NonsmoothError, ArithmeticError, np.linalg.LinAlgError):
            count = self.data + len(priors)
            return Residuals(np.full(count, np.nan), np.full((count, len(point)), np.nan), ())
        values, jacobians = [], []
        for experiment, found in zip(self.experiments, predictions, strict=True):
            for series, value, jacobian in zip(
                experiment.series, found.values, found.jacobians, strict=True
            ):
                sigma = self.sigma(series)
                values.append((value - series.values) / sigma)
                jacobians.append(jacobian / sigma[:, None])
        for place, (mean, deviation) in priors.items():
            values.append(np.array([(point[place] - mean) / deviation]))
            jacobians.append(np.eye(1, len(point), place) / deviation)
        return Residuals(np.concatenate(values), np.concatenate(jacobians), predictions)


@dataclass(frozen=True, eq=False)
class Minimum:
    """The end of a search."""

    problem: FitProblem  # with the noise that was estimated
    point: np.ndarray  # (q,)
    residuals: Residuals  # at the point
    interrupted: bool  # whether Ctrl-C ended it
    converged: bool
    message: str
    evaluations: int  # in all searches, including those over beginnings of the records
    starts: np.ndarray  # (n, q), where searches began
    costs: np.ndarray  # (n,), half the loss where each ended, NaN without a motion


def minimise(
    problem: FitProblem,
    starts: int,
    random: np.random.Generator,
    progress: Callable[[int, int], None],
) -> Minimum:
    """The minimum of the loss over searches from several starts.

    The first start is the guess; the others are drawn between the bounds, or from the priors.
    `progress` gets the number of searches that are done and of all. Raises `InputError` if
    there is no motion to begin with. Ctrl-C ends it with the best minimum until then; without one
    it is raised again.
    """
    problem = replace(problem, noise=_spreads(problem))
    points = _starts(problem, starts, random)
    best: Any = None
    costs = np.full(len(points), np.nan)
    evaluations = 0
    stopped = False
    try:
        for place, point in enumerate(points):
            approached, spent = _approached(problem, point)
            evaluations += spent
            same = np.array_equal(point, approached)  # there was no beginning to go by
            for begun in (point,) if same else (point, approached):
                if not np.isfinite(problem.residuals(begun).values).all():
                    continue
                found = _searched(problem, begun)
                evaluations += found.nfev
                costs[place] = np.fmin(costs[place], found.cost)
                if best is None or found.cost < best.cost:
                    best = found
            progress(place + 1, len(points))
    except KeyboardInterrupt:
        if best is None:
            raise
        stopped = True
    for _ in range(_ROUNDS if problem.noise else 0):
        known, noise = problem.noise, _noise(problem, problem.residuals(best.x))
        problem = replace(problem, noise=noise)
        best = _search(problem, best.x)
        evaluations += best.nfev
        if all(abs(noise[name] - known[name]) <= _SETTLED * known[name] for name in noise):
            break
    return Minimum(
        problem=problem,
        point=best.x,
        residuals=problem.residuals(best.x),
        interrupted=stopped,
        converged=best.status > 0,
        message=_MESSAGES[best.status],
        evaluations=evaluations,
        starts=points,
        costs=costs,
    )


def _searched(problem: FitProblem, point: np.ndarray) -> Any:
    """The result of a search that is repeated as long as it finds other steady responses."""
    found, spent = _search(problem, point), 0
    for _ in range(_LOOKS):
        if not problem.look_again(found.x):
            break
        seen = problem.residuals(found.x).values
        spent += 1
        if np.allclose(seen, found.fun, rtol=_SAME, atol=_SAME):
            break
        spent += found.nfev
        found = _search(problem, found.x)
    found.nfev += spent
    return found


def _search(problem: FitProblem, point: np.ndarray, tolerance: float = _TOLERANCE) -> Any:
    from scipy.optimize import least_squares

    @lru_cache(maxsize=_KEPT)
    def at(x: bytes) -> Residuals:
        return problem.residuals(np.frombuffer(x))

    unknowns = problem.unknowns
    return least_squares(
        lambda x: at(x.tobytes()).values,
        point,
        jac=lambda x: at(x.tobytes()).jacobian,
        bounds=(unknowns.lower, unknowns.upper),
        method="trf",
        x_scale="jac",
        loss=loss_of(problem.loss, problem.data),
        ftol=tolerance,
        xtol=tolerance,
        gtol=tolerance,
        max_nfev=_MOST,
    )


def _approached(problem: FitProblem, point: np.ndarray) -> tuple[np.ndarray, int]:
    """The end of searches over ever longer beginnings of the records, and their evaluations."""
    passed = np.sort(problem.passed)
    enough = passed[min(len(point), len(passed)) - 1 :]
    part = float(enough[enough > 0].min(initial=1.0))
    evaluations = 0
    while part < 1:
        shorter = problem.beginning(part)
        if np.isfinite(shorter.residuals(point).values).all():
            found = _search(shorter, point, _ROUGHLY)
            point, evaluations = found.x, evaluations + found.nfev
        part *= _GROWTH
    return point, evaluations


def _starts(problem: FitProblem, count: int, random: np.random.Generator) -> np.ndarray:
    """The guess, and points with motions that are drawn from the bounds or priors."""
    unknowns = problem.unknowns
    inside = _inside(unknowns.guess, unknowns.lower, unknowns.upper)
    points = []
    try:
        problem.predictions(inside)
        points.append(inside)
    except (InputError, NoConvergence) as problem_there:
        if count == 1:
            raise InputError(f"there is no fit from the guess: {problem_there}") from None
    for _ in range(count - 1):
        for _ in range(_DRAWS):
            point = unknowns.guess.copy()
            for place, name in enumerate(unknowns.names):
                low, high = unknowns.lower[place], unknowns.upper[place]
                if place in unknowns.priors:
                    point[place] = random.normal(*unknowns.priors[place])
                elif np.isfinite([low, high]).all():
                    point[place] = random.uniform(low, high)
                else:
                    raise InputError(f"several starts need both bounds, or a prior, of {name}")
            point = _inside(point, unknowns.lower, unknowns.upper)
            if np.isfinite(problem.residuals(point).values).all():
                points.append(point)
                break
    if not points:
        raise InputError(f"at none of {1 + _DRAWS * (count - 1)} starts is there such a motion")
    return np.array(points)


def _inside(point: np.ndarray, lower: np.ndarray, upper: np.ndarray) -> np.ndarray:
    """The nearest point that is not on a bound."""
    width = np.where(np.isfinite(upper - lower), upper - lower, 1.0)
    return np.asarray(np.clip(point, lower + 1e-6 * width, upper - 1e-6 * width))


def _spreads(problem: FitProblem) -> dict[str, float]:
    """A first estimate of the noise of columns without standard deviations."""
    columns: dict[str, list[np.ndarray]] = {}
    for series in problem.series:
        if np.isnan(series.sigma).all():
            columns.setdefault(series.name, []).append(series.values)
    return {name: usual_size(np.concatenate(values)) for name, values in columns.items()}


def _noise(problem: FitProblem, residuals: Residuals) -> dict[str, float]:
    """Noise of each column without its own, from its residuals; robust where the loss is."""
    names = np.repeat([s.name for s in problem.series], [len(s.values) for s in problem.series])
    values = residuals.values[: problem.data]
    leverage = _leverage(residuals.jacobian)[: problem.data]
    spreads, found = _spreads(problem), {}
    for name, known in problem.noise.items():
        here = names == name
        if problem.loss == "linear":
            freedom = max(float((1 - leverage[here]).sum()), 1e-3)
            size = float(np.sqrt((values[here] ** 2).sum() / freedom))
        else:
            size = _MEDIAN * float(np.median(abs(values[here])))
        found[name] = max(size * known, _LEAST * spreads[name])
    return found


def _leverage(jacobian: np.ndarray) -> np.ndarray:
    """Leverage (m + p,) of each residual: its share in its own prediction."""
    scale = np.linalg.norm(jacobian, axis=0)
    basis, sizes, _ = np.linalg.svd(jacobian / np.where(scale > 0, scale, 1.0), full_matrices=False)
    return np.asarray((basis[:, sizes > 1e-12 * sizes.max(initial=0)] ** 2).sum(axis=1))
