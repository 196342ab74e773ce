"""The parts of a chart for people: stable, unstable, what fails, none found; attractors; basins."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.explore.charting.problem import MISSING
from nonsmooth.runtime.explore.charting.store import ATTRIBUTE
from nonsmooth.runtime.explore.finding.outcomes import (
    EQUILIBRIUM,
    PERIODIC,
    UNINTERRUPTED,
    Outcome,
    settled_texts,
)
from nonsmooth.runtime.model.naming import shown_name
from nonsmooth.runtime.orbits.admissible import NEITHER
from nonsmooth.runtime.shooting.newton import CONVERGED

if TYPE_CHECKING:
    from xarray import Dataset

_SEVERAL = 5  # limits, or numbers of transitions, that are told apart: the most frequent ones
_BLOCK = 1 << 20  # points that are counted at a time


@dataclass(frozen=True, eq=False)
class Part:
    """The points of a chart that share one kind of result."""

    # "stable", "neutral", "unstable", "admissible" (unknown stability), "limit", "none", "missing",
    # "periodic", "rest" or "other"
    kind: str
    name: str  # text for people
    where: np.ndarray  # mask in the shape of the chart


def parts_of(chart: Dataset) -> list[Part]:
    """Parts of a chart, of which each point is in one; the last one is not computed yet."""
    kind = _identity(chart).get("kind")
    cut = {"attractors": _motions, "basins": _basins}.get(str(kind), _orbits)
    found = list(cut(chart))
    missing = np.asarray(chart.status.values == MISSING)
    return [*found, Part("missing", "not computed yet", missing)]


def counts_of(chart: Dataset) -> dict[str, int]:
    """Number of points of each kind of part (for basins: of each name), in bounded memory."""
    counts: dict[str, int] = {}
    by_name = _identity(chart).get("kind") == "basins"
    steps = [max(1, n) for n in chart.sizes.values()]
    while np.prod(steps, dtype=float) > _BLOCK:
        steps[int(np.argmax(steps))] = -(-max(steps) // 2)
    ranges = [range(0, n, s) for n, s in zip(chart.sizes.values(), steps, strict=True)]
    for begin in product(*ranges):
        here = {name: slice(b, b + s) for name, b, s in zip(chart.sizes, begin, steps, strict=True)}
        for part in parts_of(chart.isel(here)):
            key = part.name if by_name else part.kind
            counts[key] = counts.get(key, 0) + int(part.where.sum())
    return counts


def title_of(chart: Dataset) -> str:
    """Name of the orbit or the system of a chart, for people."""
    identity = _identity(chart)
    return shown_name(str(identity.get("orbit") or identity.get("system")))


def _identity(chart: Dataset) -> dict[str, Any]:
    found = chart.attrs.get(ATTRIBUTE)
    if not isinstance(found, dict) or "status" not in chart:
        raise InputError("this is no chart of this package")
    return found


def _orbits(chart: Dataset) -> Iterator[Part]:
    status, margin = chart.status.values, chart.margin.values
    there, limit = status == CONVERGED, chart.limit.values
    motion = there & (limit == NEITHER)
    with np.errstate(invalid="ignore"):
        yield Part("stable", "stable", motion & (margin > 0))
        yield Part("neutral", "neutral", motion & (margin == 0))
        yield Part("unstable", "unstable", motion & (margin < 0))
    yield Part("admissible", "admissible", motion & np.isnan(margin))
    lost = there & ~motion
    names = _meanings(chart.limit.attrs)
    several = _most_frequent(limit[lost])
    for number in several:
        text = names.get(str(number), str(number))
        told = f"not admissible: {text}" if number >= 0 else "not admissible"
        yield Part("limit", told, lost & (limit == number))
    yield Part("limit", "not admissible: others", lost & ~np.isin(limit, several))
    yield Part("none", "none found", ~there & (status != MISSING))


def _motions(chart: Dataset) -> Iterator[Part]:
    outcomes, lengths = chart.outcome.values, chart.transitions.values
    periodic = outcomes == PERIODIC
    several = _most_frequent(lengths[periodic])
    for number in sorted(several):
        yield Part("periodic", f"{number} transitions in a period", periodic & (lengths == number))
    yield Part("periodic", "others that are periodic", periodic & ~np.isin(lengths, several))
    rest = (EQUILIBRIUM, int(Outcome.RESTING))
    for number, text in settled_texts().items():
        if number == PERIODIC:
            continue
        kind = "none" if number == Outcome.ILLEGAL else "rest" if number in rest else "other"
        kind = "periodic" if number == UNINTERRUPTED else kind
        yield Part(kind, text, outcomes == number)


def _basins(chart: Dataset) -> Iterator[Part]:
    attractors, names = chart.attractor.values, _meanings(chart.attractor.attrs)
    for number, text in sorted((int(n), text) for n, text in names.items()):
        kind = "none" if number == Outcome.ILLEGAL else "other"
        if number == Outcome.RESTING or text.startswith("equilibrium"):
            kind = "rest"
        elif number > 0:
            kind = "periodic"
        yield Part(kind, text, attractors == number)


def _most_frequent(numbers: np.ndarray) -> list[int]:
    values, counts = np.unique(numbers, return_counts=True)
    order = np.argsort(-counts, kind="stable")[:_SEVERAL]
    return [int(value) for value in values[order]]


def _meanings(attributes: Any) -> dict[str, str]:
    found = attributes.get("meanings", {})
    return dict(json.loads(found) if isinstance(found, str) else found)
