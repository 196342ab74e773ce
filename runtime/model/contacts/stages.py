"""One step of the choice between sticking and slipping, in any arithmetic.

A step takes what each contact at rest does: those that hold bear whatever force keeps them at
rest, the others that of their limit. It is right where no force is above its limit, no stop
pulls, and all that slips accelerates its way, or would do so if the stops that hold it let go:
signs of affine functions, which are combinations of the declared ones.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from nonsmooth.runtime.model.contacts.law import HOLDING, ContactEvent, Law, Regimes

Combination = dict[int, Any]  # coefficients of rows


class Stage(NamedTuple):
    """One step of the law's choice: the regimes, and the contacts with the kinetic limit."""

    reached: frozenset[int]
    regimes: Regimes


Path = tuple[Stage, ...]  # the steps of a choice; the last has the regimes behind the event


class SignRequirement(NamedTuple):
    """The required sign of a combination of rows (positive, or not), and the contact concerned."""

    function: Combination
    positive: bool
    contact: int


def signs(law: Law, event: ContactEvent, stage: Stage) -> list[bool]:
    """The required sign of each function in `requirements`: True if it has to be positive."""
    found: list[bool] = []
    for i in _judged(law, event, stage):
        kept = stage.regimes[i] in HOLDING
        found += [not kept] * (2 if kept and law.contacts[i].friction else 1)
    return found


def requirements(
    law: Law, event: ContactEvent, stage: Stage, entry: Callable[[int], Any]
) -> list[SignRequirement]:
    """The signs of functions that have to hold in a step of the law.

    `entry` gives the constant of a row, which is an entry of the coupling. Raises
    `ZeroDivisionError` where the directions of the contacts that hold depend on each other.
    """
    resting, regimes = event.resting, stage.regimes
    kept = [i for i in resting if regimes[i] in HOLDING]
    given = {
        j: _force(law, j, regimes[j], j not in resting or j in stage.reached)
        for j in range(len(regimes))
        if j not in kept
    }
    free = law.free[event.others]
    accelerations = {
        i: _sum([(1, {free[i]: 1}), *((_coupling(law, i, j, entry), f) for j, f in given.items())])
        for i in resting
    }
    reactions = _reactions(law, kept, accelerations, entry)
    rubbing = [i for i in kept if law.contacts[i].friction]
    idle = law.idling(event, regimes)
    released = _reactions(law, rubbing, accelerations, entry) if idle else {}
    found = []
    for i in _judged(law, event, stage):
        contact = law.contacts[i]
        if i in kept:
            reaction = reactions[i]
            found.append(SignRequirement(reaction, False, i))
            if contact.friction:
                limit = {contact.kinetic if i in stage.reached else contact.static: 1}
                forward = _sum([(1, reaction), (-1, limit)])
                backward = _sum([(-1, reaction), (-1, limit)])
                found[-1:] = [
                    SignRequirement(forward, False, i),
                    SignRequirement(backward, False, i),
                ]
        else:
            bearing = released if i in idle else reactions
            parts = ((_coupling(law, i, k, entry), force) for k, force in bearing.items())
            sign = 1 if regimes[i] == "overshoot" else -1
            moves = _sum([(1, accelerations[i]), *parts])
            found.append(SignRequirement(_sum([(sign, moves)]), True, i))
    return found


def _judged(law: Law, event: ContactEvent, stage: Stage) -> list[int]:
    """The contacts for which a step requires a sign."""
    untouched = law.untouched(event, stage.regimes)
    return [i for i in event.resting if i not in untouched]


def _coupling(law: Law, i: int, j: int, entry: Callable[[int], Any]) -> Any:
    return entry(law.coupling[i][j]) if law.couples[i][j] else 0


def _force(law: Law, index: int, regime: str, kinetic: bool) -> Combination:
    """The force of a contact that does not hold: kinetic friction, or the static limit."""
    contact = law.contacts[index]
    if regime == "slip":
        return {contact.slipping if kinetic else contact.static: 1}
    if regime == "overshoot":
        return {contact.overshooting: 1} if kinetic else {contact.static: -1}
    return {}


def _reactions(
    law: Law,
    kept: Sequence[int],
    accelerations: dict[int, Combination],
    entry: Callable[[int], Any],
) -> dict[int, Combination]:
    """The reactions with which the contacts that hold do not accelerate.

    They are solved for by elimination without exchanges of rows.
    """
    matrix = [[_coupling(law, i, j, entry) for j in kept] for i in kept]
    right = [_sum([(-1, accelerations[i])]) for i in kept]
    count = len(kept)
    for k in range(count):
        for i in range(k + 1, count):
            factor = matrix[i][k] / matrix[k][k]
            matrix[i] = [a - factor * b for a, b in zip(matrix[i], matrix[k], strict=True)]
            right[i] = _sum([(1, right[i]), (-factor, right[k])])
    for k in reversed(range(count)):
        known = ((-matrix[k][j], right[j]) for j in range(k + 1, count))
        right[k] = _sum([(1 / matrix[k][k], _sum([(1, right[k]), *known]))])
    return dict(zip(kept, right, strict=True))


def _sum(terms: Sequence[tuple[Any, Combination]]) -> Combination:
    total: Combination = {}
    for factor, combination in terms:
        for row, coefficient in combination.items():
            total[row] = total.get(row, 0) + factor * coefficient
    return total
