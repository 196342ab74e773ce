"""Steady periodic responses: what motions settle on, and what they say of the measurements.

A response is followed from where it was known last. Where it is a motion no more, because a
boundary collision or a fold was passed, a motion from it shows what takes its place. At first, and
when it is asked for again, the responses are looked for as in a test: swept up and down through
the points, and from a few starts at random. At each row's parameters there may be several
responses: the one next to what was measured is taken, in standard deviations, or in terms of the
spread of a column where these are not known.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, NoConvergence, NonsmoothError
from nonsmooth.runtime.explore.finding.find import find_orbits, start_box
from nonsmooth.runtime.explore.finding.primitive import add_orbit, settled_orbit
from nonsmooth.runtime.explore.fitting.measurements import Measured, usual_size
from nonsmooth.runtime.explore.fitting.outputs import ResponseQuantity, response_quantity
from nonsmooth.runtime.explore.fitting.prediction import Prediction
from nonsmooth.runtime.explore.fitting.unknowns import Unknowns
from nonsmooth.runtime.model.kernels import SystemKernels, grown, known_system
from nonsmooth.runtime.model.piecewise import PiecewiseLinear, piecewise
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.derivatives import OrbitDerivatives, followed
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.simulation.recurrence import Itinerary, canonical
from nonsmooth.runtime.simulation.starting import on_circles

if TYPE_CHECKING:
    from nonsmooth.runtime.explore.fitting.fit import Fit

_STARTS = 6  # at random, at each point
_SEARCHED = 60  # starts of a search for an orbit that is told
_SHORTEST = 0.25  # step of the way to other parameters: then a response is lost
_MOST = 6  # responses that are remembered at a point
_TURN = 2 * np.pi
_VALUES = 121  # of a curve, from the smallest to the largest that was measured at
_FAILURES = (NonsmoothError, ArithmeticError, np.linalg.LinAlgError)

Point = Mapping[str, Any]
"""All parameters of one steady state."""
KnownResponses = dict[tuple[int, int], list[OrbitDerivatives]]
"""By experiment and row, the latest first: responses from which others are followed."""


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
        found = _survey(kernels, swept)
    else:
        found = _survey_of(kernels, swept, experiment.itinerary)
    for row, orbits in zip(order, found, strict=True):
        seen = [each for orbit in orbits if (each := _differentiated(orbit, by)) is not None]
        _keep(known, number, row, [*seen, *known.get((number, row), [])])


def _keep(known: KnownResponses, number: int, row: int, orbits: Sequence[OrbitDerivatives]) -> None:
    known[number, row] = list(orbits[:_MOST])


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
) -> Prediction:
    """The prediction for an experiment with steady responses, at a point (q,) of the unknowns.

    The responses are followed from those in `known`, which are updated. `number` is that of the
    experiment, from 0. Raises `NoConvergence` if there is no stable periodic response, or if it
    has no derivative.
    """
    points = points_under(experiment, unknowns, number, point)
    columns = unknowns.columns(number)
    if not any(searched == number for searched, _ in known):
        look(kernels, experiment, number, points, list(columns), known)
    structure = structure_of(kernels)
    quantities = [response_quantity(each.expression, structure) for each in experiment.series]
    measured = np.full((len(points), len(quantities)), np.nan)
    scales = np.ones_like(measured)
    for place, series in enumerate(experiment.series):
        measured[series.places, place] = series.values
        usual = usual_size(series.values)
        scales[series.places, place] = np.where(np.isnan(series.sigma), usual, series.sigma)
    told = np.zeros_like(measured)
    rates = np.zeros((*measured.shape, len(columns)))
    chosen: list[OrbitDerivatives] = []
    for row, parameters in enumerate(points):
        found, lost = _responses_at(
            kernels,
            parameters,
            list(columns),
            known.get((number, row), []),
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
        _keep(known, number, row, [chosen[row], *others, *lost])
    values: list[np.ndarray] = []
    jacobians: list[np.ndarray] = []
    for place, series in enumerate(experiment.series):
        jacobian = np.zeros((len(series.values), len(point)))
        jacobian[:, list(columns.values())] = rates[series.places, place]
        values.append(told[series.places, place])
        jacobians.append(jacobian)
    return Prediction(tuple(values), tuple(jacobians), orbits=tuple(chosen))


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


def _responses_at(
    kernels: SystemKernels,
    parameters: Point,
    by: Sequence[str],
    known: Sequence[OrbitDerivatives],
    *,
    unstable: bool,
) -> tuple[list[OrbitDerivatives], list[OrbitDerivatives]]:
    """The responses at other parameters, each once, and the known ones that were lost on the way.

    Where the first known one is lost, a motion from it shows what takes its place. `by` lists
    the parameters of the derivatives; `known` are responses at parameters nearby, the chosen
    one first. With `unstable`, unstable responses count too, for a given itinerary.
    """
    found: list[OrbitDerivatives] = []
    lost: list[OrbitDerivatives] = []
    orbits: list[Orbit] = []

    def add(derivatives: OrbitDerivatives) -> None:
        count = len(orbits)
        add_orbit(orbits, derivatives.orbit)
        if len(orbits) > count:
            found.append(derivatives)

    for reference in known:
        try:
            there = _followed(reference, parameters, by)
            if _counts(there.orbit, unstable=unstable):
                add(there)
                continue
        except _FAILURES:
            pass
        lost.append(reference)
    for reference in lost[:1] if not unstable and lost and lost[0] is known[0] else []:
        for other in _settled_beside(kernels, reference.orbit, parameters):
            if (derivatives := _differentiated(other, by)) is not None:
                add(derivatives)
    return found, lost


def _settled_beside(kernels: SystemKernels, orbit: Orbit, parameters: Point) -> list[Orbit]:
    """What a motion from the start of an orbit settles on at other parameters, if anything."""
    start = orbit.states[0].astype(float).tolist()
    return _settled_from(kernels, parameters, start, orbit.itinerary[0][0])


def _settled_from(
    kernels: SystemKernels,
    parameters: Point,
    start: Sequence[float],
    configuration: str | None = None,
) -> list[Orbit]:
    """The stable response on which a motion from a state (N,) settles, in a list, if any."""
    try:
        orbit = settled_orbit(kernels, parameters, start, configuration)
    except _FAILURES:
        return []
    return [orbit] if orbit is not None and _counts(orbit, unstable=False) else []


def _survey(kernels: SystemKernels, points: Sequence[Point]) -> list[list[Orbit]]:
    """The stable responses at each of several points, which are in the order of a sweep."""
    found: list[list[Orbit]] = [[] for _ in points]
    for place, parameters in enumerate(points):
        for start in _starts(piecewise(grown(kernels), parameters)):
            for orbit in _settled_from(kernels, parameters, start):
                add_orbit(found[place], orbit)
    _sweep(found, points, lambda orbit, point: _settled_beside(kernels, orbit, point))
    return found


def _sweep(
    found: Sequence[list[Orbit]],
    points: Sequence[Point],
    moved: Callable[[Orbit, Point], list[Orbit]],
) -> None:
    """Add to each point what the orbits at its neighbours become there, upwards, then downwards."""
    up = [(place, place - 1) for place in range(1, len(points))]
    down = [(place, place + 1) for place in range(len(points) - 2, -1, -1)]
    for place, beside in up + down:
        for neighbour in found[beside]:
            for orbit in moved(neighbour, points[place]):
                add_orbit(found[place], orbit)


def _survey_of(
    kernels: SystemKernels, points: Sequence[Point], itinerary: Itinerary
) -> list[list[Orbit]]:
    """The responses of an itinerary at each of several points, unstable ones too.

    The points are in the order of a sweep. Responses are followed from point to point, from
    where one is stable or lies near a motion.
    """
    turn = canonical(itinerary)
    wanted = itinerary[turn:] + itinerary[:turn]

    def is_wanted(orbit: Orbit) -> bool:
        phases = orbit.itinerary
        first = canonical(phases)
        return phases[first:] + phases[:first] == wanted

    def moved(orbit: Orbit, point: Point) -> list[Orbit]:
        by = [next(iter(point))]
        try:
            there = _followed(orbit.derivatives(by), point, by).orbit
        except _FAILURES:
            return []
        return [there] if _counts(there, unstable=True) else []

    found = [[*filter(is_wanted, orbits)] for orbits in _survey(kernels, points)]
    if not any(found):
        for place, parameters in enumerate(points):
            orbits = (each.orbit for each in find_orbits(kernels, parameters, _SEARCHED).orbits)
            found[place] = [*filter(is_wanted, orbits)]
            if found[place]:
                break
    _sweep(found, points, moved)
    return found


def _starts(system: PiecewiseLinear) -> list[list[float]]:
    """The state of rest, and a few random states."""
    limits = start_box(system)
    generator = np.random.default_rng(0)
    drawn = generator.uniform(limits[:, 0], limits[:, 1], (_STARTS, len(limits)))
    states = np.concatenate([np.zeros((1, len(limits))), drawn])
    angles = np.concatenate([[0.0], generator.uniform(0, 2 * np.pi, _STARTS)])
    return [state.tolist() for state in on_circles(system, states, angles)]


def _followed(
    reference: OrbitDerivatives, parameters: Point, by: Sequence[str]
) -> OrbitDerivatives:
    """The same response at other parameters, differentiated."""
    given = reference.orbit.given
    target = {name: float(value) for name, value in parameters.items()}
    moved = [name for name, value in given.items() if float(value) != target[name]]
    changing = tuple(dict.fromkeys([*by, *moved]))
    if reference.by != changing:
        reference = reference.orbit.derivatives(changing)
    there = followed(reference, np.array([target[name] for name in changing]), _SHORTEST)
    return there if tuple(by) == changing else there.orbit.derivatives(list(by))


def _counts(orbit: Orbit, *, unstable: bool) -> bool:
    """Whether an orbit is a motion that a test can show, or any motion if `unstable`."""
    if not orbit.converged or not (orbit.dwell_times > 0).all():
        return False
    if orbit.admissibility.verdict is not True:
        return False
    return unstable or orbit.stability.verdict != "unstable"


def response_curves(fit: Fit, experiment: int = 0) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """Values (m,) of the parameter that was varied, and fitted responses (m,) of each column.

    They lie between the measured rows; the values are numbers of rows where no parameter was
    varied. Responses are NaN where that of the nearest row does not reach, and between
    responses of different phases. `experiment` counts from 0; an unknown one is refused.
    """
    found = fit.experiment(experiment)
    kernels = known_system(fit.system)
    structure = structure_of(kernels)
    quantities = {s.name: response_quantity(s.expression, structure) for s in found.series}
    rows = range(len(found.responses))
    table = {
        name: np.array([float(each.parameters[name]) for each in found.responses])
        for name in found.responses[0].parameters
    }
    measured = table.get(found.along, np.arange(float(len(rows))))
    order = np.argsort(measured, kind="stable")
    values = np.linspace(measured.min(), measured.max(), _VALUES) if found.along else measured
    nearest = abs(values[:, None] - measured).argmin(axis=1).tolist()
    between = {n: np.interp(values, measured[order], c[order]) for n, c in table.items()}
    by = [found.along or next(iter(table))]
    orbits = [fit.response(row, experiment).derivatives(by) for row in rows]
    curves = {name: np.full(len(values), np.nan) for name in quantities}
    own = [each.orbit.itinerary for each in orbits]
    for place, row in enumerate(nearest):
        if place and own[row] != own[nearest[place - 1]]:
            continue  # no line joins responses of different phases
        point = {name: float(column[place]) for name, column in between.items()}
        there, _ = _responses_at(kernels, point, by, [orbits[row]], unstable=True)
        for each in there:
            for name, quantity in quantities.items():
                with suppress(NonsmoothError):
                    curves[name][place] = quantity.of(each)[0]
    for series in found.series:
        if quantities[series.name].periodic:  # next to what was measured
            order = np.argsort(series.times, kind="stable")
            near = np.interp(values, series.times[order], series.values[order])
            curve = curves[series.name]
            curves[series.name] = curve + _TURN * np.round((near - curve) / _TURN)
    return values, curves
