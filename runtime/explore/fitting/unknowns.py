"""What is fitted: parameters of all experiments, and the start and clock of each."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

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

    def concerns(self, experiment: int) -> bool:
        """Whether an experiment depends on it."""
        return self.experiment in (None, experiment)


@dataclass(frozen=True)
class MotionSettings:
    """Parameters, start and clock of one experiment at one point of the unknowns."""

    parameters: dict[str, object]
    start: dict[str, object]
    offset: float

    def by_kind(self) -> dict[str, dict[str, Any]]:
        """Copies of the numbers by the kind of a free number, then by its target."""
        own = {OFFSET: self.offset}
        return {"parameter": {**self.parameters}, "start": {**self.start}, "offset": own}


@dataclass(frozen=True, eq=False)
class Unknowns:
    """All numbers that are fitted, and those that are fixed."""

    entries: tuple[FreeNumber, ...]
    guess: np.ndarray  # (q,)
    lower: np.ndarray  # (q,)
    upper: np.ndarray  # (q,)
    # number of an unknown, its mean and its standard deviation
    priors: tuple[tuple[int, float, float], ...]
    fixed: tuple[MotionSettings, ...]  # of each experiment, without what is fitted

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the unknowns."""
        return tuple(entry.name for entry in self.entries)

    def columns(self, experiment: int) -> dict[str, int]:
        """Free parameters and starts of an experiment, with their places among the unknowns."""
        return {
            entry.base: column
            for column, entry in enumerate(self.entries)
            if entry.concerns(experiment) and entry.kind != "offset"
        }

    def clock(self, experiment: int) -> int | None:
        """Place of an experiment's offset among the unknowns; None where it is fixed."""
        for column, entry in enumerate(self.entries):
            if entry.concerns(experiment) and entry.kind == "offset":
                return column
        return None

    def sizes(self, point: np.ndarray) -> np.ndarray:
        """A large change (q,) of each unknown at a point (q,): its own size, or that of its guess.

        The size is 1 where both are zero.
        """
        usual = np.where(self.guess != 0, abs(self.guess), 1.0)
        return np.where(abs(point) > _VANISHING * usual, abs(point), usual)

    def condition(self, point: np.ndarray, experiment: int) -> MotionSettings:
        """Parameters, start and clock of an experiment at a point (q,) of the unknowns."""
        known = self.fixed[experiment].by_kind()
        for entry, value in zip(self.entries, point.tolist(), strict=True):
            if entry.concerns(experiment):
                known[entry.kind][entry.target] = value
        return MotionSettings(known["parameter"], known["start"], known["offset"][OFFSET])


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
        fixed.append(
            MotionSettings(
                {name: as_value(own[name]) for name in tables if name in own},
                dict(begin),
                float(as_value(each.offset if each.offset is not None else offset)),
            )
        )
    ends = [_bounds(entry, bounds, tables, experiments) for entry in entries]
    beliefs = tuple(
        (place, *_prior(entry.base, priors[entry.base]))
        for place, entry in enumerate(entries)
        if entry.base in priors
    )
    guesses = [
        _guess(entry, fixed, *ends[place], {p: m for p, m, _ in beliefs}.get(place))
        for place, entry in enumerate(entries)
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


def _prior(name: str, given: tuple[object, object]) -> tuple[float, float]:
    mean, deviation = float(as_value(given[0])), float(as_value(given[1]))
    if not deviation > 0:
        raise InputError(f"the prior of {name} has no positive standard deviation")
    return mean, deviation


def _guess(
    entry: FreeNumber,
    fixed: Sequence[MotionSettings],
    lower: float,
    upper: float,
    mean: float | None,
) -> float:
    """Start of the search for a free number: given value, prior, or middle of the bounds."""
    given = fixed[entry.experiment or 0].by_kind()[entry.kind].get(entry.target, mean)
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
