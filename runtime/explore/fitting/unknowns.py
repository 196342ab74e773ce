"""What is fitted: parameters of all experiments, and the start and clock of each."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.values import as_value
from nonsmooth.runtime.explore.fitting.measurements import Measured
from nonsmooth.runtime.model.kernels import ParameterTable, SystemKernels
from nonsmooth.runtime.model.naming import shown_name, start_names
from nonsmooth.runtime.model.structure import structure_of

OFFSET = "offset"
_VANISHING = 1e-6  # of the size of the guess
Bounds = Mapping[str, tuple[object, object]]


@dataclass(frozen=True)
class FreeNumber:
    """A number that is fitted."""

    # as reported: ``k``, ``x10`` or ``offset``, with ``@2`` behind it where each experiment has its
    # own
    name: str
    kind: Literal["parameter", "start", "offset"]
    target: str  # the parameter, or the state that starts with it
    experiment: int | None  # to which it belongs, None for all

    @property
    def base(self) -> str:
        """The name without its experiment, under which bounds and priors are given."""
        return self.name.partition("@")[0]


class ExperimentValues(NamedTuple):
    """What one experiment takes from the unknowns at one point of them."""

    point: np.ndarray  # (q,), the unknowns
    parameters: dict[str, Any]
    start: dict[str, Any]
    offset: float
    columns: dict[str, int]  # its free parameters and starts, with their places among the unknowns
    clock: int | None  # place of its offset, None where that is fixed


@dataclass(frozen=True, eq=False)
class Unknowns:
    """All numbers that are fitted, and those that are fixed."""

    entries: tuple[FreeNumber, ...]
    guess: np.ndarray  # (q,)
    lower: np.ndarray  # (q,)
    upper: np.ndarray  # (q,)
    priors: dict[int, tuple[float, float]]  # means and standard deviations, by numbers of unknowns
    # of each experiment what is not fitted: numbers by the kind of a free number, then by target
    fixed: tuple[Mapping[str, Mapping[str, Any]], ...]

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the unknowns."""
        return tuple(entry.name for entry in self.entries)

    def sizes(self, point: np.ndarray) -> np.ndarray:
        """A large change (q,) of each unknown at a point (q,): its own size, or that of its guess.

        The size is 1 where both are zero.
        """
        usual = np.where(self.guess != 0, abs(self.guess), 1.0)
        return np.where(abs(point) > _VANISHING * usual, abs(point), usual)

    def at(self, point: np.ndarray, experiment: int) -> ExperimentValues:
        """What an experiment, by its number from 0, takes from a point (q,) of the unknowns."""
        known = {kind: dict(numbers) for kind, numbers in self.fixed[experiment].items()}
        columns: dict[str, int] = {}
        clock = None
        for place, (entry, value) in enumerate(zip(self.entries, point.tolist(), strict=True)):
            if entry.experiment not in (None, experiment):
                continue
            known[entry.kind][entry.target] = value
            if entry.kind == "offset":
                clock = place
            else:
                columns[entry.base] = place
        offset = known["offset"][OFFSET]
        return ExperimentValues(point, known["parameter"], known["start"], offset, columns, clock)


def unknowns_of(
    kernels: SystemKernels,
    experiments: Sequence[Measured],
    *,
    parameters: Mapping[str, object],
    free: Sequence[str],
    bounds: Bounds,
    priors: Mapping[str, tuple[object, object]],
    start: Mapping[str, object],
    offset: float,
) -> Unknowns:
    """The unknowns of a fit, with their guesses, bounds and priors, and what is fixed.

    `parameters` are known ones and guesses of free ones; `free` names parameters, states at the
    start (x10 of x1) and ``offset``. Bounds are (lower, upper), priors (mean, standard
    deviation). Refused are unknown names, a parameter that is both free and known, and bounds
    in the wrong order.
    """
    structure = structure_of(kernels)
    tables = {table.name: table for table in kernels.parameters}
    starts = dict(zip(start_names(structure.states, [*tables]), structure.states, strict=True))
    forced = {structure.states[place] for place in structure.forced}
    for name in parameters:
        if name not in tables:
            raise unknown_name("parameter", name, tables)
    if not free:
        raise InputError("nothing is free: name the parameters that are to be found")
    for name in [*free, *bounds, *priors]:
        if name not in tables and name not in starts and name != OFFSET:
            raise unknown_name("free parameter", name, [*tables, *starts, OFFSET])
        if name not in free:
            raise InputError(f"{name} has bounds or a prior, and is not free")
        if list(free).count(name) > 1:
            raise InputError(f"{name} is free twice")
        if starts.get(name) in forced and name not in tables:
            raise InputError(f"{name} belongs to the forcing: free the offset of the clock instead")
    entries: list[FreeNumber] = []
    for name in free:
        if name in tables:
            for each in experiments:
                if name in each.known:
                    raise InputError(f"parameter {name} is free, and known in {each.name}")
            entries.append(FreeNumber(name, "parameter", name, None))
            continue
        kind: Literal["start", "offset"] = "offset" if name == OFFSET else "start"
        moving = [place for place, each in enumerate(experiments) if not each.steady]
        if not moving:
            raise InputError(f"{name} belongs to a motion, and steady responses alone are measured")
        for place in moving:
            label = name if len(experiments) == 1 else f"{name}@{place + 1}"
            entries.append(FreeNumber(label, kind, starts.get(name, OFFSET), place))
    missing = [
        name
        for name in tables
        if name not in free
        and name not in parameters
        and any(name not in each.known for each in experiments)
    ]
    if missing:
        raise InputError(f"{shown_name(kernels.name)} needs a value for: {', '.join(missing)}")
    fixed = []
    for each in experiments:
        own = {**parameters, **each.parameters}
        for name in each.parameters:
            if name not in tables:
                raise unknown_name("parameter", name, tables)
        begin = each.start if each.start is not None else start
        clock = each.offset if each.offset is not None else offset
        numbers = {name: as_value(own[name]) for name in tables if name in own}
        own_offset = {OFFSET: float(as_value(clock))}
        fixed.append({"parameter": numbers, "start": begin, "offset": own_offset})
    ends = [_bounds(entry, bounds, tables, experiments) for entry in entries]
    known = {
        name: (float(as_value(mean)), float(as_value(deviation)))
        for name, (mean, deviation) in priors.items()
    }
    for name, (_, deviation) in known.items():
        if not deviation > 0:
            raise InputError(f"the prior of {name} has no positive standard deviation")
    beliefs = {n: known[entry.base] for n, entry in enumerate(entries) if entry.base in known}
    guesses = [
        _guess(entry, fixed, *sides, known.get(entry.base, (None,))[0])
        for entry, sides in zip(entries, ends, strict=True)
    ]
    lower, upper = (np.array(side, dtype=float) for side in zip(*ends, strict=True))
    return Unknowns(tuple(entries), np.array(guesses), lower, upper, beliefs, tuple(fixed))


def _bounds(
    entry: FreeNumber,
    bounds: Bounds,
    tables: Mapping[str, ParameterTable],
    experiments: Sequence[Measured],
) -> tuple[float, float]:
    lower, upper, base = -math.inf, math.inf, entry.base
    if base in bounds:
        low, high = bounds[base]
        lower, upper = _end(low, lower), _end(high, upper)
        if not lower < upper:
            raise InputError(
                f"the bounds of {base}, {lower:.12g} and {upper:.12g}, are not in order"
            )
    domain = tables[entry.target].ends if entry.kind == "parameter" else (-math.inf, math.inf)
    if entry.kind == "offset":
        assert entry.experiment is not None
        domain = (-math.inf, experiments[entry.experiment].first)
    lower, upper = max(lower, domain[0]), min(upper, domain[1])
    if not lower < upper:
        raise InputError(f"no {base} lies in its bounds and its domain")
    return lower, upper


def _end(given: object, infinite: float) -> float:
    """A bound, which is infinite where it is None or infinity."""
    if given is None or (isinstance(given, float) and math.isinf(given)):
        return infinite
    return float(as_value(given))


def _guess(
    entry: FreeNumber,
    fixed: Sequence[Mapping[str, Mapping[str, Any]]],
    lower: float,
    upper: float,
    mean: float | None,
) -> float:
    """Start of the search for a free number: given value, prior, or middle of the bounds."""
    given = fixed[entry.experiment or 0][entry.kind].get(entry.target, mean)
    if given is not None:
        value = float(as_value(given))
        if entry.kind == "offset":
            return min(max(value, lower), upper)
        if not lower <= value <= upper:
            raise InputError(
                f"{entry.name} = {value:.12g} is not between {lower:.12g} and {upper:.12g}"
            )
        return value
    if math.isfinite(lower) and math.isfinite(upper):
        return (lower + upper) / 2
    raise InputError(f"{entry.name} needs a guess, or bounds on both sides")
