"""What a design tells of its trials: values, gradients, iterates, and how it ended."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from nonsmooth.runtime.explore.design.aim import Aim, Trial
from nonsmooth.runtime.explore.design.limits import Optimality
from nonsmooth.runtime.explore.design.optimising import INTERRUPTED, Ended

__all__ = ["MET", "gradient_of", "iterates_of", "message_of", "values_of"]

MET = 1e-8  # of a condition


def values_of(
    names: Sequence[str], aim: Aim, point: Trial, asked: Iterable[str]
) -> dict[str, float]:
    """Values of the parameters `names` and the quantities `asked` at a trial.

    Along a branch each quantity has its worst value.
    """
    given = point.members[0].orbit.given
    found = {name: float(given[name]) for name in names}
    wanted = {c.quantity: float(c.value) for c in aim.conditions}
    for name in asked:
        values = [each.quantities.quantity(name, wanted.get(name)) for each in point.members]
        found[name] = max(values) if _upwards(aim, name) else min(values)
    return found


def _upwards(aim: Aim, name: str) -> bool:
    """Whether a larger value of a quantity is a worse one."""
    if name == aim.quantity:
        return aim.sign > 0
    return any(c.relation == "<=" for c in aim.conditions if c.quantity == name)


def gradient_of(
    names: Sequence[str], aim: Aim, point: Trial, measured: Iterable[str]
) -> dict[str, dict[str, float]]:
    """Derivatives of each quantity by each parameter, at the orbit where the quantity is worst."""
    found = {}
    for name in measured:
        order = 1.0 if _upwards(aim, name) else -1.0
        values = [order * each.quantities.values[name] for each in point.members]
        worst = point.members[int(np.argmax(values))]
        slopes = worst.quantities.slopes[name][: len(names)].tolist()
        found[name] = dict(zip(names, slopes, strict=True))
    return found


def iterates_of(
    names: Sequence[str], aim: Aim, history: Iterable[Trial], asked: Iterable[str]
) -> np.ndarray:
    """Parameters and quantities (k, q + m) of the iterates."""
    quantities = tuple(asked)
    rows = [values_of(names, aim, point, quantities) for point in history]
    return np.array([[row[name] for name in (*names, *quantities)] for row in rows])


def message_of(aim: Aim, ended: Ended, left: Optimality, *, converged: bool) -> str:
    """A text that says how a design ended."""
    if ended.reason == INTERRUPTED:
        return INTERRUPTED
    acting = ", ".join(limit.text for limit in left.active)
    if converged:
        if not aim.quantity:
            return "the wanted values are met"
        parts = [f"an optimum within {acting}" if acting else "an optimum"]
        return "; ".join([*parts, *([left.corner] if left.corner else [])])
    missed = [
        c
        for c in aim.conditions
        if any(
            np.abs(np.minimum(aim.condition_rows(member, c).values, 0.0)).max() > MET
            for member in ended.point.members
        )
        or (c.relation == "=" and aim.missed(ended.point) > MET)
    ]
    told = f"{', '.join(c.text for c in missed)} not reached" if missed else "no optimum"
    why = ended.reason or (f"within {acting}" if acting else "the optimiser found no better one")
    return f"{told}: {why}"
