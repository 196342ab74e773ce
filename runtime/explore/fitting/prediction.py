"""What is predicted of measurements, with exact derivatives: of a motion, of steady responses.

The clock of the data shows `offset` when the motion starts. Outputs are taken at fixed times of
the clock. Events are matched by their order: the n-th recorded time of a boundary belongs to the
n-th time at which the motion reaches it, a blank standing for one that was not recorded. Where a
motion does not come that far, or has no derivative, as where it grazes a boundary, there is no
prediction: a search takes a shorter step.

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
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.complex_steps import imaginary_parts, stepped
from nonsmooth.runtime.core.errors import InputError, NoConvergence, NonsmoothError
from nonsmooth.runtime.explore.finding.find import find_orbits, start_box
from nonsmooth.runtime.explore.finding.solved import (
    add_orbit,
    canonical_itinerary,
    same_orbit,
    settled_orbit,
)
from nonsmooth.runtime.explore.fitting.measurements import Measured, MeasuredSeries, usual_size
from nonsmooth.runtime.explore.fitting.outputs import (
    Output,
    ResponseQuantity,
    output_of,
    response_quantity,
)
from nonsmooth.runtime.explore.fitting.unknowns import ExperimentValues
from nonsmooth.runtime.model.kernels import SystemKernels, grown, known_system
from nonsmooth.runtime.model.piecewise import PiecewiseLinear, piecewise
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.derivatives import OrbitDerivatives, followed
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.simulation.recurrence import Itinerary
from nonsmooth.runtime.simulation.simulate import simulate_one
from nonsmooth.runtime.simulation.starting import on_circles
from nonsmooth.runtime.simulation.trajectory import Trajectory

if TYPE_CHECKING:
    from nonsmooth.runtime.explore.fitting.fit import Fit

_LONGER = (1.0, 1.25, 2.0, 4.0)  # times as long as the record, while recorded events are missing
_PAST = 1e-9  # of its length, beyond the last time
_AT_ONCE = 1e-12  # of the motion: a sample that an event comes so near to is at the event
_JUMP = 1e-9  # of the values on both sides
_STARTS = 6  # at random, at each point
_SEARCHED = 60  # starts of a search for an orbit that is told
_SHORTEST = 0.25  # step of the way to other parameters: then a response is lost
_MOST = 6  # responses that are remembered at a point
_TURN = 2 * np.pi
_VALUES = 121  # of a curve, from the smallest to the largest that was measured at
_FAILURES = (NonsmoothError, ArithmeticError, np.linalg.LinAlgError)

Point = Mapping[str, Any]
"""All parameters of one steady state."""
KnownResponses = dict[int, list[OrbitDerivatives]]
"""By row, the latest first: responses from which others are followed."""


@dataclass(frozen=True, eq=False)
class Prediction:
    """What one experiment is predicted to measure at one point of the unknowns."""

    values: tuple[np.ndarray, ...]  # (m,) for each series, on the clock of the data
    jacobians: tuple[np.ndarray, ...]  # (m, q) for each series, by all unknowns
    motion: Trajectory | None = None  # None for steady responses
    # of steady responses, one for each row, with derivatives by the free parameters
    orbits: tuple[OrbitDerivatives, ...] = ()


def predict(kernels: SystemKernels, experiment: Measured, setting: ExperimentValues) -> Prediction:
    """The prediction for an experiment with a motion, with exact derivatives.

    Raises `NonsmoothError` if the motion does not exist, is too short, or has no derivative.
    """
    motion = _motion_under(kernels, experiment, setting)
    outputs = {
        series.name: output_of(series.expression, motion.structure)
        for series in experiment.series
        if series.kind == "output"
    }
    sampled = [series for series in experiment.series if series.name in outputs]
    clocks = np.unique(np.concatenate([np.empty(0), *(series.times for series in sampled)]))
    times = np.minimum(clocks - setting.offset, motion.end)
    by, free, clock = [*setting.columns], [*setting.columns.values()], setting.clock
    for series in sampled:
        own = times[np.searchsorted(clocks, series.times)]
        _check_jumps(experiment, series, outputs[series.name], motion, own)
    states = motion(times)
    derivatives = motion.derivatives(by, times=times) if by else None
    if derivatives is not None:
        stepped_states = stepped(states, np.moveaxis(derivatives.states, -1, 0), None)
    phases = np.searchsorted(motion.times, times, side="right") - 1
    fields = motion.system.fields[motion.run.configurations[phases]]
    rates = np.einsum("mij,mj->mi", fields[..., :-1], states) + fields[..., -1]
    extended = np.concatenate([states, np.ones((len(times), 1))], axis=1)
    values, jacobians = [], []
    for series in experiment.series:
        jacobian = np.zeros((len(series.values), len(setting.point)))
        if series.kind == "output":
            places = np.searchsorted(clocks, series.times)
            output = outputs[series.name]
            where = motion.run.configurations[phases[places]]
            rows = _rows(output, motion)[where]
            values.append(np.einsum("mn,mn->m", rows, extended[places]))
            if derivatives is not None:
                fields, moved, _ = derivatives.numbers[:3]
                own = output.in_configurations(motion.structure, fields, moved)[:, where]
                found = (own[..., :-1] * stepped_states[:, places]).sum(axis=-1) + own[..., -1]
                jacobian[:, free] = imaginary_parts(found, None).T
            if clock is not None:
                jacobian[:, clock] = -np.einsum("mn,mn->m", rows[:, :-1], rates[places])
        else:
            reached = times_of_events(motion, series.expression)[series.places]
            values.append(setting.offset + motion.times[reached])
            if derivatives is not None:
                jacobian[:, free] = derivatives.event_times[reached - 1]
            if clock is not None:
                jacobian[:, clock] = 1.0
        if not (np.isfinite(values[-1]).all() and np.isfinite(jacobian).all()):
            raise NoConvergence(f"{experiment.name}: the motion is not finite")
        jacobians.append(jacobian)
    return Prediction(tuple(values), tuple(jacobians), motion)


def _motion_under(
    kernels: SystemKernels, experiment: Measured, setting: ExperimentValues
) -> Trajectory:
    """The motion of an experiment, as far as it was recorded.

    Raises `NonsmoothError` if the motion does not exist, ends before the data, or reaches a
    boundary less often.
    """
    length = experiment.last - setting.offset
    if not length > 0:
        raise InputError(f"{experiment.name}: all data are before the motion starts")
    if experiment.first < setting.offset:
        raise InputError(
            f"{experiment.name}: data at {experiment.first:.12g} are before the motion starts,"
            f" at {setting.offset:.12g}"
        )
    wanted: MeasuredSeries | None = None
    events = [series for series in experiment.series if series.kind == "event"]
    for factor in _LONGER if events else _LONGER[:1]:
        until = length * (factor + _PAST)
        motion = simulate_one(kernels, setting.parameters, setting.start, until=until)
        needed = length if len(events) < len(experiment.series) else 0.0
        if motion.end < needed:
            raise NoConvergence(
                f"{experiment.name}: the motion ends at {motion.end:.6g}, before the data do:"
                f" {motion.message}"
            )
        reached = {each.name: len(times_of_events(motion, each.expression)) for each in events}
        wanted = next((e for e in events if reached[e.name] <= int(e.places[-1])), None)
        if wanted is None:
            return motion
    assert wanted is not None
    count, found = int(wanted.places[-1]) + 1, reached[wanted.name]
    raise NoConvergence(
        f"{experiment.name}: the motion comes to {wanted.expression} {found} times until"
        f" {motion.end:.6g}, where {count} are recorded"
    )


def times_of_events(motion: Trajectory, boundary: str) -> np.ndarray:
    """Places (n,) among a motion's times at which it reaches a boundary."""
    return np.array([i for i, names in enumerate(motion.boundaries) if boundary in names], int)


def _rows(output: Output, motion: Trajectory) -> np.ndarray:
    """An output in each configuration, (configurations, N + 1)."""
    system = motion.system
    return output.in_configurations(motion.structure, system.fields, system.rows)


def _check_jumps(
    experiment: Measured,
    series: MeasuredSeries,
    output: Output,
    motion: Trajectory,
    times: np.ndarray,
) -> None:
    """Refuse a sample at exactly the time of an event at which the output jumps."""
    rows, run = _rows(output, motion), motion.run
    near = _AT_ONCE * motion.end
    firsts = np.searchsorted(motion.times[1:], times - near) + 1
    for entry, time, clock in zip(
        firsts.tolist(), (times + near).tolist(), series.times.tolist(), strict=True
    ):
        if entry >= len(motion.times) or motion.times[entry] > time:
            continue
        sides = [
            rows[int(run.configurations[place])] @ np.append(state, 1.0)
            for place, state in ((entry - 1, run.before[entry]), (entry, run.states[entry]))
        ]
        if abs(sides[1] - sides[0]) > _JUMP * max(map(abs, sides)):
            raise NoConvergence(
                f"{experiment.name}: {series.name} jumps at {clock:.12g}, at"
                f" {' and '.join(motion.boundaries[entry])}: leave out what was measured there"
            )


def points_under(experiment: Measured, setting: ExperimentValues) -> list[Point]:
    """All parameters of each row of an experiment."""
    return [{**setting.parameters, **own} for own in experiment.points]


def look(
    kernels: SystemKernels, experiment: Measured, setting: ExperimentValues, known: KnownResponses
) -> None:
    """Search for the responses of an experiment, and add them to those that are known."""
    points, by = points_under(experiment, setting), [*setting.columns]
    # swept along the parameters, whatever the order of the rows
    order = sorted(range(len(points)), key=lambda row: [*experiment.points[row].values()])
    swept = [points[row] for row in order]
    found: list[list[Orbit]] = [[] for _ in swept]
    for here, parameters in zip(found, swept, strict=True):
        for start in _starts(piecewise(grown(kernels), parameters)):
            for orbit in _settled(kernels, parameters, start):
                add_orbit(here, orbit)
    _sweep(found, swept, lambda orbit, point: _settled(kernels, point, *_beginning(orbit)))
    if experiment.itinerary is not None:
        found = _of_itinerary(kernels, swept, found, canonical_itinerary(experiment.itinerary))
    for row, orbits in zip(order, found, strict=True):
        seen = [each for orbit in orbits if (each := _differentiated(orbit, by)) is not None]
        known[row] = [*seen, *known.get(row, [])][:_MOST]


def _differentiated(orbit: Orbit, by: Sequence[str]) -> OrbitDerivatives | None:
    try:
        return orbit.derivatives(list(by))
    except NonsmoothError:  # a border collision
        return None


def predict_steady(
    kernels: SystemKernels, experiment: Measured, setting: ExperimentValues, known: KnownResponses
) -> Prediction:
    """The prediction for an experiment with steady responses.

    They are followed from those in `known`, which are updated. Raises `NoConvergence` if there is
    no stable periodic response, or if it has no derivative.
    """
    points, columns = points_under(experiment, setting), setting.columns
    if not known:
        look(kernels, experiment, setting, known)
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
            known.get(row, []),
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
            sought = "stable" if experiment.itinerary is None else "such"
            own = ", ".join(f"{n} = {value:.6g}" for n, value in experiment.points[row].items())
            where = f" ({own})" if own else ""
            raise NoConvergence(
                f"{experiment.name}: no {sought} periodic response was found in row"
                f" {row + 1}{where}"
            )
        others = [each for each in found if each is not chosen[row]]
        known[row] = [chosen[row], *others, *lost][:_MOST]
    values: list[np.ndarray] = []
    jacobians: list[np.ndarray] = []
    for place, series in enumerate(experiment.series):
        jacobian = np.zeros((len(series.values), len(setting.point)))
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

    def add(derivatives: OrbitDerivatives) -> None:
        if not any(same_orbit(each.orbit, derivatives.orbit) for each in found):
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
        for other in _settled(kernels, parameters, *_beginning(reference.orbit)):
            if (derivatives := _differentiated(other, by)) is not None:
                add(derivatives)
    return found, lost


def _beginning(orbit: Orbit) -> tuple[list[float], str]:
    """The start of an orbit, and its configuration there."""
    return orbit.states[0].astype(float).tolist(), orbit.itinerary[0][0]


def _settled(
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


def _of_itinerary(
    kernels: SystemKernels,
    points: Sequence[Point],
    stable: Sequence[list[Orbit]],
    wanted: Itinerary,
) -> list[list[Orbit]]:
    """The responses of an itinerary at each of several points, unstable ones too.

    The points are in the order of a sweep. Responses are followed from point to point, from
    where one is `stable` or lies near a motion.
    """

    def is_wanted(orbit: Orbit) -> bool:
        return canonical_itinerary(orbit.itinerary) == wanted

    def moved(orbit: Orbit, point: Point) -> list[Orbit]:
        by = [next(iter(point))]
        try:
            there = _followed(orbit.derivatives(by), point, by).orbit
        except _FAILURES:
            return []
        return [there] if _counts(there, unstable=True) else []

    found = [[*filter(is_wanted, orbits)] for orbits in stable]
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
    return (
        orbit.converged
        and bool((orbit.dwell_times > 0).all())
        and orbit.admissibility.verdict is True
        and (unstable or orbit.stability.verdict != "unstable")
    )


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
