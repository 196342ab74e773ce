"""What was measured: experiments, and the series of outputs and of event times in each.

A table holds either one motion, outputs over time and times of events, or steady responses: each of
its rows is then a test of its own, at the parameters that the row tells.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np

from nonsmooth.runtime.core.arguments import checked
from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.json_codec import AnyRow, Integers, Row
from nonsmooth.runtime.core.registry import Shown
from nonsmooth.runtime.explore.fitting.affine_outputs import output_of
from nonsmooth.runtime.explore.fitting.response_quantities import KINDS, response_quantity
from nonsmooth.runtime.explore.fitting.tables import TIMES, read_table
from nonsmooth.runtime.model.structure import Structure

__all__ = ["Experiment", "Measured", "MeasuredSeries", "boundary_named", "measured"]

_SIGMA = "sigma_"
_CONSTANT = 1e-12


@checked
@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class Experiment(Shown):
    """A record of one motion, or of steady responses, with what is known of it alone.

    Attributes
    ----------
    data : path, mapping of str to array, or xarray.Dataset
        Columns: ``t`` or ``time``, outputs, times of events by the name of a boundary, their
        standard deviations as ``sigma_NAME``, and known parameters, which are constant. Of steady
        responses, such as ``amplitude:x``, parameters may differ from row to row.
    parameters : mapping of str to number
        Known in this experiment, beside those that all share.
    start : mapping of state to number, optional
        Where the motion starts; that of all experiments when omitted.
    offset : float, optional
        What the clock of the data shows when the motion starts, in the system's unit of time.
    name : str
        For messages and pictures; its number when omitted.
    itinerary : sequence of (configuration, boundary), optional
        Of steady responses: they are those of this cycle of phases, stable or not. When omitted
        the stable one next to what was measured is taken, whichever phases it has.

    Examples
    --------
    >>> Experiment(data={"t": [0.1, 0.2], "x": [0.99, 0.98]}, parameters={"k": 1}).name
    ''
    """

    data: str | os.PathLike[str] | Mapping[str, Any]
    parameters: Mapping[str, object] = field(default_factory=dict)
    start: Mapping[str, object] | None = None
    offset: float | None = None
    name: str = ""
    itinerary: Sequence[tuple[str, str]] | None = None


@dataclass(frozen=True, eq=False, kw_only=True)
class MeasuredSeries:
    """One column of measurements, without missing values."""

    name: str  # of the column
    kind: Literal["output", "event", "response"]
    # an output as an expression of the states, the name of a boundary, or a response such as
    # ``amplitude:x``
    expression: str
    # (N + k + 1,), coefficients of an output's states and of its k accelerations and forces, then
    # its constant; empty for events and responses
    row: Row
    # (m,), rows of the table; for events the number of earlier ones at this boundary
    places: Integers
    times: Row  # (m,), on the clock of the data; for responses the parameter that was varied
    values: Row  # (m,), measured values; for events their times
    sigma: AnyRow  # (m,), standard deviations that were given, else NaN


@dataclass(frozen=True, eq=False, kw_only=True)
class Measured:
    """An experiment as it was read."""

    name: str
    parameters: dict[str, object]  # known in it alone
    start: Mapping[str, object] | None
    offset: float | None
    series: tuple[MeasuredSeries, ...]
    # for steady responses, parameters of each row alone; empty for a motion
    points: tuple[dict[str, float], ...] = ()
    itinerary: tuple[tuple[str, str], ...] | None = None  # of the responses, if it was given

    @property
    def steady(self) -> bool:
        """Whether it holds steady responses instead of a motion."""
        return bool(self.points)

    @property
    def known(self) -> tuple[str, ...]:
        """Names of the parameters that the table or the experiment gives."""
        return (*self.parameters, *(self.points[0] if self.points else ()))

    @property
    def last(self) -> float:
        """The last time on the clock of the data."""
        return max(float(series.times[-1]) for series in self.series)

    @property
    def first(self) -> float:
        """The first time on the clock of the data."""
        return min(float(series.times[0]) for series in self.series)


def measured(
    experiment: Experiment,
    name: str,
    structure: Structure,
    parameters: Sequence[str],
    outputs: Mapping[str, str],
    events: Mapping[str, str],
    responses: Mapping[str, str],
    sigma: Mapping[str, float] | float | None,
) -> Measured:
    """An experiment as it was read from its table, checked.

    `name` is its name in messages and `parameters` lists those of the system. `outputs` maps
    columns to expressions of the states, `events` columns of times to boundaries, and
    `responses` columns to quantities of a steady response; a column named like a state, a
    boundary or a quantity such as ``amplitude:x`` needs no entry. `sigma` has standard
    deviations of columns without ``sigma_NAME``. Raises `InputError` with one line that names
    the experiment and the column.
    """
    try:
        table = read_table(experiment.data)
        of_rows = {
            column: responses.get(column, column)
            for column in table
            if column in responses or column.partition(":")[0].strip() in KINDS
        }
        if of_rows:
            return _steady(
                experiment, name, structure, parameters, table, {**responses, **of_rows}, sigma
            )
        if experiment.itinerary is not None:
            raise InputError("an itinerary belongs to steady responses, and none are measured")
        return _motion(experiment, name, structure, parameters, table, outputs, events, sigma)
    except InputError as problem:
        if isinstance(experiment.data, str) or hasattr(experiment.data, "__fspath__"):
            told = str(experiment.data)
            if str(problem).startswith(told):
                raise
            name = told
        raise InputError(f"{name}: {problem}") from None


def _motion(
    experiment: Experiment,
    name: str,
    structure: Structure,
    parameters: Sequence[str],
    table: dict[str, np.ndarray],
    outputs: Mapping[str, str],
    events: Mapping[str, str],
    sigma: Mapping[str, float] | float | None,
) -> Measured:
    """An experiment with one motion: outputs and times of events."""
    clock = next((column for column in TIMES if column in table), None)
    times = table.pop(clock) if clock else None
    boundaries = {shape.name for shapes in structure.boundaries for shape in shapes}
    if not table and times is not None and len(events) == 1:  # nothing but times of one event
        table, times = {next(iter(events)): times}, None
    deviations = _taken_deviations(table, outputs)
    known: dict[str, object] = {}
    series: list[MeasuredSeries] = []
    for column, values in table.items():
        if column in events or (column in boundaries and column not in outputs):
            own = _deviations(column, values, deviations, sigma)
            boundary = events.get(column, column)
            series.append(_events(column, boundary, values, own))
        elif column in outputs or column in structure.states:
            own = _deviations(column, values, deviations, sigma)
            expression = outputs.get(column, column)
            series.append(_output(column, expression, structure, times, values, own))
        elif column in parameters:
            known[column] = _constant(column, values)
        else:
            raise InputError(
                f"{unknown_name('column', column, [*structure.states, *boundaries])};"
                " an output of another name needs its expression"
            )
    for column in [*outputs, *events]:
        if column not in table and events.get(column) not in table:
            raise unknown_name("column", column, table)
    for column in deviations:
        if column not in table:
            raise unknown_name("column", column, table)
    _check_once(known, experiment)
    series = [each for each in series if len(each.values)]
    if not series:
        raise InputError("nothing is measured: no column of outputs or of event times has a number")
    return Measured(
        name=name,
        parameters={**known, **experiment.parameters},
        start=experiment.start,
        offset=experiment.offset,
        series=tuple(series),
    )


def _steady(
    experiment: Experiment,
    name: str,
    structure: Structure,
    parameters: Sequence[str],
    table: dict[str, np.ndarray],
    responses: Mapping[str, str],
    sigma: Mapping[str, float] | float | None,
) -> Measured:
    """An experiment with steady responses, each row at parameters of its own."""
    deviations = _taken_deviations(table, responses)
    for column in [*responses, *deviations]:
        if column not in table:
            raise unknown_name("column", column, table)
    for column in table:
        if column not in responses and column not in parameters:
            raise InputError(
                f"column {column!r} is no parameter: beside steady responses a table holds the"
                f" parameters at which they were measured ({', '.join(parameters)}), and no"
                " outputs or events of a motion"
            )
    counts = {column: len(values) for column, values in table.items()}
    if len(set(counts.values())) > 1:
        raise InputError(f"columns differ in length: {counts}")
    known = [column for column in table if column in parameters]
    for column in known:
        if not np.isfinite(table[column]).all():
            raise InputError(f"parameter {column} is missing or not finite in a row")
    _check_once(known, experiment)
    rows = np.array([table[column] for column in known]).T
    varied = next((c for c in known if np.ptp(table[c]) > 0), None)
    along = np.arange(float(next(iter(counts.values())))) if varied is None else table[varied]
    series = []
    for column, text in responses.items():
        values, own = table[column], _deviations(column, table[column], deviations, sigma)
        if np.isinf(values).any():
            raise InputError(f"column {column!r} is not finite")
        response_quantity(text, structure)
        there = np.flatnonzero(~np.isnan(values))
        if len(there):
            series.append(
                MeasuredSeries(
                    name=column,
                    kind="response",
                    expression=text,
                    row=np.empty(0),
                    places=there,
                    times=along[there],
                    values=values[there],
                    sigma=own[there],
                )
            )
    if not series:
        raise InputError("nothing is measured: no column of responses has a number")
    itinerary = experiment.itinerary
    return Measured(
        name=name,
        parameters=dict(experiment.parameters),
        start=experiment.start,
        offset=experiment.offset,
        series=tuple(series),
        points=tuple(dict(zip(known, row, strict=True)) for row in rows.tolist())
        or ({},) * len(along),
        itinerary=None if itinerary is None else tuple((c, b) for c, b in itinerary),
    )


def _taken_deviations(
    table: dict[str, np.ndarray], named: Mapping[str, str]
) -> dict[str, np.ndarray]:
    """Columns of standard deviations, which are removed from a table."""
    return {
        column.removeprefix(_SIGMA): table.pop(column)
        for column in [*table]
        if column.startswith(_SIGMA) and column not in named
    }


def _check_once(known: Iterable[str], experiment: Experiment) -> None:
    both = [one for one in known if one in experiment.parameters]
    if both:
        raise InputError(f"parameter {both[0]} is a column and given")


def _deviations(
    column: str,
    values: np.ndarray,
    deviations: Mapping[str, np.ndarray],
    sigma: Mapping[str, float] | float | None,
) -> np.ndarray:
    """Standard deviations of a column; NaN where none is given."""
    if column in deviations:
        found = np.array(deviations[column], dtype=float)
        if len(found) != len(values):
            raise InputError(f"{_SIGMA}{column} is not as long as {column}")
        found = np.where(np.isnan(values), 1.0, found)
    else:
        given = sigma.get(column) if isinstance(sigma, Mapping) else sigma
        if given is None:
            return np.full(len(values), np.nan)
        found = np.full(len(values), float(given))
    if not (np.isfinite(found) & (found > 0)).all():
        raise InputError(f"the sigma of {column} is not positive and finite everywhere")
    return found


def _output(
    column: str,
    expression: str,
    structure: Structure,
    times: np.ndarray | None,
    values: np.ndarray,
    sigma: np.ndarray,
) -> MeasuredSeries:
    if times is None:
        raise InputError(f"column {column!r} needs times: a column t or time")
    if len(values) != len(times):
        raise InputError(f"column {column!r} has {len(values)} values for {len(times)} times")
    if not np.isfinite(times).all():
        raise InputError("a time is missing or not finite")
    if not (np.diff(times) > 0).all():
        place = int(np.flatnonzero(np.diff(times) <= 0)[0]) + 1
        before, after = times[place - 1], times[place]
        raise InputError(f"the times do not increase: {after:.12g} follows {before:.12g}")
    if np.isinf(values).any():
        raise InputError(f"column {column!r} is not finite")
    there = np.flatnonzero(~np.isnan(values))
    return MeasuredSeries(
        name=column,
        kind="output",
        expression=expression,
        row=output_of(expression, structure).row,
        places=there,
        times=times[there],
        values=values[there],
        sigma=sigma[there],
    )


def _events(column: str, boundary: str, values: np.ndarray, sigma: np.ndarray) -> MeasuredSeries:
    """Times of events; a blank stands for an event whose time was not recorded."""
    there = np.flatnonzero(~np.isnan(values))
    times = values[there]
    if np.isinf(times).any():
        raise InputError(f"column {column!r} is not finite")
    if not (np.diff(times) > 0).all():
        raise InputError(f"the times of {column} do not increase")
    return MeasuredSeries(
        name=column,
        kind="event",
        expression=boundary,
        row=np.empty(0),
        places=there,
        times=times,
        values=times,
        sigma=sigma[there],
    )


def _constant(column: str, values: np.ndarray) -> float:
    found = values[~np.isnan(values)]
    if not len(found) or np.ptp(found) > _CONSTANT * abs(found).max():
        raise InputError(f"column {column!r} is a parameter, and not constant")
    return float(found[0])


def boundary_named(structure: Structure, name: str) -> str:
    """The boundary of a name, or the one by which an element of this name is reached.

    The name of an element is such as ``wall`` for ``wall-reaches-stop``. Refused is a name that
    fits none, or more than one.
    """
    known = list(dict.fromkeys(s.name for shapes in structure.boundaries for s in shapes))
    if name in known:
        return name
    found = [each for each in known if each.startswith(f"{name}-")]
    arrivals = [each for each in found if each.startswith(f"{name}-reaches")]
    if len(arrivals) == 1:
        return arrivals[0]
    if len(found) == 1:
        return found[0]
    if found:
        raise InputError(f"event {name!r} may be {' or '.join(found)}")
    raise unknown_name("event", name, known)
