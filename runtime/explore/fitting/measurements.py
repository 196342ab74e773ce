"""What was measured: tables, and the series of outputs and of event times in each experiment.

A table holds either one motion, outputs over time and times of events, or steady responses: each of
its rows is then a test of its own, at the parameters that the row tells. It is columns of numbers
by name, from a file, a mapping or a dataset.
"""

from __future__ import annotations

import csv
import io
import os
import warnings
import zipfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Literal, NamedTuple

import numpy as np

from nonsmooth.runtime.core.arguments import checked
from nonsmooth.runtime.core.errors import InputError, missing_extra, unknown_name
from nonsmooth.runtime.core.files import read_file
from nonsmooth.runtime.core.json_codec import AnyRow, Integers, Row
from nonsmooth.runtime.core.registry import Shown
from nonsmooth.runtime.core.result_files import DAMAGED, array_in, naming
from nonsmooth.runtime.explore.fitting.outputs import KINDS, output_of, response_quantity
from nonsmooth.runtime.model.structure import Structure

_SIGMA = "sigma_"
_CONSTANT = 1e-12
_ENDINGS = (".csv", ".npz", ".nc", ".zarr")
TIMES = ("t", "time")  # names of the column of times
_MOST = 500_000_000  # bytes
_SMALL, _LOOSEST = 1 << 24, 20  # bytes that an archive may unpack to, and times its own
Table = dict[str, np.ndarray]


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

    def at(self, kept: np.ndarray) -> MeasuredSeries:
        """The part of the series where a mask (m,) is set."""
        columns = ("places", "times", "values", "sigma")
        return replace(self, **{name: getattr(self, name)[kept] for name in columns})


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

    def passed(self, series: MeasuredSeries) -> np.ndarray:
        """Part of its record that has passed at each datum (m,) of a series; 0 without a motion."""
        if self.steady:
            return np.zeros(len(series.values))
        return (series.times - self.first) / ((self.last - self.first) or 1.0)


class _Columns(NamedTuple):
    """The columns of a table, and the standard deviations of their values."""

    values: dict[str, np.ndarray]
    deviations: dict[str, np.ndarray]  # of columns that have them in the table
    sigma: Mapping[str, float] | float | None  # of others

    def series(
        self,
        column: str,
        kind: Literal["output", "event", "response"],
        expression: str,
        times: np.ndarray | None = None,
        row: np.ndarray | None = None,
    ) -> MeasuredSeries:
        """One column without its missing values; `times` (n,) are the values where omitted."""
        values = self.values[column]
        if np.isinf(values).any():
            raise InputError(f"column {column!r} is not finite")
        there = np.flatnonzero(~np.isnan(values))
        return MeasuredSeries(
            name=column,
            kind=kind,
            expression=expression,
            row=np.empty(0) if row is None else row,
            places=there,
            times=(values if times is None else times)[there],
            values=values[there],
            sigma=self._sigma(column)[there],
        )

    def _sigma(self, column: str) -> np.ndarray:
        """Standard deviations (n,) of a column, NaN where none is given."""
        values = self.values[column]
        if column in self.deviations:
            found = np.array(self.deviations[column], dtype=float)
            if len(found) != len(values):
                raise InputError(f"{_SIGMA}{column} is not as long as {column}")
            found = np.where(np.isnan(values), 1.0, found)
        else:
            given = self.sigma.get(column) if isinstance(self.sigma, Mapping) else self.sigma
            if given is None:
                return np.full(len(values), np.nan)
            found = np.full(len(values), float(given))
        if not (np.isfinite(found) & (found > 0)).all():
            raise InputError(f"the sigma of {column} is not positive and finite everywhere")
        return found


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
    data = experiment.data
    told = os.fspath(data) if isinstance(data, str | os.PathLike) else name
    with naming(told):
        table = read_table(data)
        steady = {
            column: responses.get(column, column)
            for column in table
            if column in responses or column.partition(":")[0].strip() in KINDS
        }
        named = {**responses, **steady} if steady else outputs
        deviations = {
            column.removeprefix(_SIGMA): table.pop(column)
            for column in [*table]
            if column.startswith(_SIGMA) and column not in named
        }
        columns = _Columns(table, deviations, sigma)
        if steady:
            series, points = _steady(columns, structure, parameters, named)
            known: dict[str, Any] = {}
        elif experiment.itinerary is not None:
            raise InputError("an itinerary belongs to steady responses, and none are measured")
        else:
            series, known = _motion(columns, structure, parameters, outputs, events)
            points = ()
        for column in deviations:
            if column not in table:
                raise unknown_name("column", column, table)
        given = (*known, *(points[0] if points else ()))
        both = [one for one in given if one in experiment.parameters]
        if both:
            raise InputError(f"parameter {both[0]} is a column and given")
        series = [each for each in series if len(each.values)]
        if not series:
            what = "responses" if steady else "outputs or of event times"
            raise InputError(f"nothing is measured: no column of {what} has a number")
    itinerary = experiment.itinerary
    return Measured(
        name=name,
        parameters={**known, **experiment.parameters},
        start=experiment.start,
        offset=experiment.offset,
        series=tuple(series),
        points=points,
        itinerary=None if itinerary is None else tuple((c, b) for c, b in itinerary),
    )


def _motion(
    columns: _Columns,
    structure: Structure,
    parameters: Sequence[str],
    outputs: Mapping[str, str],
    events: Mapping[str, str],
) -> tuple[list[MeasuredSeries], dict[str, object]]:
    """Outputs and times of events of one motion, and parameters that the table knows."""
    table = columns.values
    clock = next((column for column in TIMES if column in table), None)
    times = table.pop(clock) if clock else None
    boundaries = {shape.name for shapes in structure.boundaries for shape in shapes}
    if not table and times is not None and len(events) == 1:  # nothing but times of one event
        table[next(iter(events))], times = times, None
    known: dict[str, object] = {}
    series: list[MeasuredSeries] = []
    for column, values in table.items():
        if column in events or (column in boundaries and column not in outputs):
            found = columns.series(column, "event", events.get(column, column))
            if not (np.diff(found.times) > 0).all():
                raise InputError(f"the times of {column} do not increase")
            series.append(found)
        elif column in outputs or column in structure.states:
            expression = outputs.get(column, column)
            _check_times(column, times, len(values))
            row = output_of(expression, structure).row
            series.append(columns.series(column, "output", expression, times, row))
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
    return series, known


def _steady(
    columns: _Columns,
    structure: Structure,
    parameters: Sequence[str],
    responses: Mapping[str, str],
) -> tuple[list[MeasuredSeries], tuple[dict[str, float], ...]]:
    """Steady responses, and the parameters that the table knows of each row."""
    table = columns.values
    for column in responses:
        if column not in table:
            raise unknown_name("column", column, table)
    known = {column: values for column, values in table.items() if column in parameters}
    for column in table:
        if column not in responses and column not in known:
            raise InputError(
                f"column {column!r} is no parameter: beside steady responses a table holds the"
                f" parameters at which they were measured ({', '.join(parameters)}), and no"
                " outputs or events of a motion"
            )
    counts = {column: len(values) for column, values in table.items()}
    if len(set(counts.values())) > 1:
        raise InputError(f"columns differ in length: {counts}")
    for column, values in known.items():
        if not np.isfinite(values).all():
            raise InputError(f"parameter {column} is missing or not finite in a row")
    rows = np.arange(float(next(iter(counts.values()))))
    along = next((v for v in known.values() if len(v) and np.ptp(v) > 0), rows)
    series = []
    for column, text in responses.items():
        response_quantity(text, structure)
        series.append(columns.series(column, "response", text, along))
    points = [dict(zip(known, row, strict=True)) for row in np.array([*known.values()]).T.tolist()]
    return series, tuple(points or [{} for _ in rows])


def _check_times(column: str, times: np.ndarray | None, count: int) -> None:
    """Refuse a column of outputs without as many increasing times as values."""
    if times is None:
        raise InputError(f"column {column!r} needs times: a column t or time")
    if count != len(times):
        raise InputError(f"column {column!r} has {count} values for {len(times)} times")
    if not np.isfinite(times).all():
        raise InputError("a time is missing or not finite")
    if not (np.diff(times) > 0).all():
        place = int(np.flatnonzero(np.diff(times) <= 0)[0]) + 1
        before, after = times[place - 1], times[place]
        raise InputError(f"the times do not increase: {after:.12g} follows {before:.12g}")


def _constant(column: str, values: np.ndarray) -> float:
    found = values[~np.isnan(values)]
    if not len(found) or np.ptp(found) > _CONSTANT * abs(found).max():
        raise InputError(f"column {column!r} is a parameter, and not constant")
    return float(found[0])


def usual_size(values: np.ndarray) -> float:
    """Spread of measured values (m,), or where they are all equal their size; never zero."""
    return float(np.std(values)) or float(abs(values).max()) or 1.0


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


def read_table(data: Any) -> Table:
    """The columns (n,) of a table of measurements, by name; missing values are NaN.

    `data` are columns by name, an xarray Dataset, or a path to .csv (with a header), .npz, .nc
    or .zarr. Columns of a dataset are its variables along ``t`` or ``time``, or along its only
    dimension. Columns may have different lengths. Raises `InputError` if a file cannot be read
    or a column is no row of real numbers, and `MissingExtra` for .nc and .zarr without xarray.
    """
    if isinstance(data, str | os.PathLike):
        return _from_file(Path(data))
    if isinstance(data, Mapping) and not hasattr(data, "data_vars"):
        return {str(name): _column(str(name), values) for name, values in data.items()}
    if hasattr(data, "data_vars"):
        return _from_dataset(data)
    raise InputError(f"data are a file, columns by name or a dataset, not {type(data).__name__}")


def _column(name: str, values: Any) -> np.ndarray:
    try:
        found = np.atleast_1d(np.asarray(values, dtype=float))
    except (TypeError, ValueError):
        raise InputError(f"column {name!r} is no row of real numbers") from None
    if found.ndim != 1:
        raise InputError(f"column {name!r} has the shape {found.shape}, where a row is expected")
    return found


def _from_file(path: Path) -> Table:
    ending = path.suffix.lower()
    if ending == ".csv":
        return _from_csv(read_file(path, _MOST, "table of measurements"))
    if ending == ".npz":
        content = read_file(path, _MOST, "table of measurements")
        return {name: _column(name, values) for name, values in _arrays(content)}
    if ending not in _ENDINGS:
        raise InputError(f"does not end in {', '.join(_ENDINGS[:-1])} or {_ENDINGS[-1]}")
    try:
        import xarray
    except ImportError:
        raise missing_extra("chart", "xarray") from None
    if not path.exists():
        raise InputError("no such file")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of metadata that are in several places, or not
            opened = xarray.open_zarr(path) if ending == ".zarr" else xarray.open_dataset(path)
            with opened as dataset:
                stored = sum(f.stat().st_size for f in [path, *path.rglob("*")] if f.is_file())
                if dataset.nbytes > _SMALL + _LOOSEST * stored:
                    raise InputError(
                        f"it takes {dataset.nbytes / 1e6:.3g} MB, packed into {stored / 1e6:.3g}:"
                        " so much is not unpacked"
                    )
                return _from_dataset(dataset.load())
    except InputError:
        raise
    except Exception as problem:  # backends raise what they like
        raise InputError(f"not a dataset: {problem}") from None


def _arrays(content: bytes) -> Iterator[tuple[str, np.ndarray]]:
    """Arrays of an archive by name, which together may take only a few times its size."""
    left: float = _SMALL + _LOOSEST * len(content)
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as file:
            for name in file.namelist():
                array = array_in(file, name.removesuffix(".npy"), lambda *_: True, left)
                left -= array.nbytes
                yield name.removesuffix(".npy"), array
    except InputError:
        raise
    except Exception:  # what a damaged archive raises is not one kind
        raise InputError(DAMAGED) from None


def _from_dataset(dataset: Any) -> Table:
    along = next((name for name in TIMES if name in dataset.dims), None)
    if along is None and len(dataset.dims) == 1:  # steady responses over a parameter
        (along,) = map(str, dataset.dims)
    if along is None:
        raise InputError("the dataset has no dimension t or time, nor one dimension alone")
    told = along in TIMES or along in dataset.coords
    found = {along: _column(along, dataset[along].values)} if told else {}
    for name, variable in dataset.data_vars.items():
        if variable.dims not in ((along,), ()):
            raise InputError(f"{name!r} of the dataset is not a series over {along}")
        found[str(name)] = _column(str(name), variable.values)
    return found


def _from_csv(content: bytes) -> Table:
    try:
        lines = content.decode("utf-8-sig").splitlines()
    except UnicodeDecodeError:
        raise InputError("no text in UTF-8") from None
    kept = [(n, line) for n, line in enumerate(lines, 1) if line.strip() and line[0] != "#"]
    if len(kept) < 2:
        raise InputError("a header and at least one row are expected")
    header = kept[0][1]
    separator = next((each for each in ",;\t" if each in header), ",")
    try:
        rows = list(csv.reader((line for _, line in kept), delimiter=separator))
    except csv.Error as problem:
        raise InputError(f"no table: {problem}") from None
    names = [name.strip() for name in rows[0]]
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice is not None or "" in names:
        raise InputError(f"column {twice!r} is there twice" if twice else "a column has no name")
    numbers = np.full((len(rows) - 1, len(names)), np.nan)
    for place, row in enumerate(rows[1:]):
        line = kept[place + 1][0]
        if len(row) != len(names):
            raise InputError(f"line {line} has {len(row)} entries, not {len(names)}")
        for column, entry in enumerate(row):
            if entry.strip():
                try:
                    numbers[place, column] = float(entry)
                except ValueError:
                    told = f"line {line}, column {names[column]!r}: {entry.strip()[:40]!r}"
                    raise InputError(f"{told} is not a number") from None
    return dict(zip(names, numbers.T, strict=True))
