"""Boundary functions and transition conditions of a composed orbit, from its system's numbers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from nonsmooth.runtime.events.boundary_functions import PhaseWaves
from nonsmooth.runtime.events.leading_derivative import derivatives, leading
from nonsmooth.runtime.model.factored_flows import FactoredFlows
from nonsmooth.runtime.model.time_functions import functions_at
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape, Numbers
from nonsmooth.runtime.shooting.variational import Shooting

__all__ = ["ConditionRow", "Conditions", "conditions_of", "phase_waves"]

_ZERO = 1e-9  # relative size below which a derivative counts as zero


@dataclass(frozen=True)
class ConditionRow:
    """A condition of a transition: a derivative of a row along a configuration's flow."""

    place: int  # phase at whose end it is asked
    row: int  # number of the row
    along: int  # number of the configuration
    order: int  # of the derivative

    def value(self, numbers: Numbers, ends: np.ndarray) -> np.ndarray:
        """Return its values (k,) at k points, from their numbers and the states at the ends.

        `ends` (k, p, N) has the states at the ends of the phases.
        """
        end, field = ends[:, self.place], numbers.fields[:, self.along]
        *_, row = derivatives(numbers.rows[..., self.row, :], field, self.order + 1, _rate)
        return np.asarray((row[..., :-1] * end).sum(axis=-1) + row[..., -1])


@dataclass(frozen=True)
class Conditions:
    """The conditions that decide where the transitions of a cycle lead."""

    rows: tuple[ConditionRow, ...]
    # for each phase and each transition declared for its boundaries: places of conditions among
    # `rows`, None where all derivatives vanish, and whether they have to be positive
    choices: tuple[tuple[tuple[tuple[int | None, bool], ...], ...], ...]

    def taken(self, values: np.ndarray) -> np.ndarray:
        """Return which of its transitions each phase takes (k, p), from values (k, c); -1 for none.

        As `first_following`, over the many points of a branch at once.
        """
        found = np.full((len(values), len(self.choices)), -1)
        for place, transitions in enumerate(self.choices):
            for number, conditions in reversed(list(enumerate(transitions))):
                holds = np.full(len(values), True)
                for column, positive in conditions:
                    holds &= (False if column is None else values[:, column] > 0) == positive
                found[holds, place] = number
        return found


def conditions_of(cycle: ItineraryShape, numbers: Numbers, now: Shooting) -> Conditions:
    """Return the conditions of a cycle's transitions, by derivatives that decide at a point."""
    rows: dict[tuple[int, int, int], ConditionRow] = {}
    orders: dict[tuple[int, int, int], int | None] = {}
    choices = []
    for place, wanted in enumerate(cycle.transitions):
        declared = [
            transition.conditions
            for transition in cycle.structure.listed(cycle.configurations[place], wanted.boundaries)
        ]
        for row, along, _ in (condition for each in declared for condition in each):
            key = place, row, along
            if key not in orders:
                order = _deciding(numbers, now, *key, cycle.rows[place])
                orders[key] = order
                if order is not None:
                    rows[key] = ConditionRow(*key, order)
        places = list(rows)
        choices.append(
            tuple(
                tuple(
                    (
                        places.index((place, row, along)) if (place, row, along) in rows else None,
                        is_positive,
                    )
                    for row, along, is_positive in each
                )
                for each in declared
            )
        )
    return Conditions(tuple(rows.values()), tuple(choices))


def _deciding(
    numbers: Numbers, now: Shooting, place: int, row: int, along: int, own: int
) -> int | None:
    """Return the order of the first derivative that is not zero; None if all are."""
    end = now.ends[place]

    def differs(_: int, function: np.ndarray) -> bool:
        value = float(function[:-1] @ end + function[-1])
        size = float(abs(function[:-1]) @ abs(end) + abs(function[-1]))
        return abs(value) > _ZERO * size

    functions = derivatives(numbers.rows[row], numbers.fields[along], len(end) + 1, _rate)
    found = leading(functions, differs, int(row == own))
    return None if found is None else found.order


def _rate(row: Any, field: Any) -> Any:
    """Return the derivative of an affine function along an affine field."""
    return (row[..., None, :-1] @ field)[..., 0, :]


def phase_waves(
    cycle: ItineraryShape, numbers: Numbers, start: np.ndarray, dwell: np.ndarray, place: int
) -> PhaseWaves:
    """Return the boundary functions along one phase at k points, by its configuration's modes.

    `start` (k, N) has the states at the start of the phase, `dwell` (k, p) is in the unit
    of time, and `place` is the number of the phase.
    """
    configuration = cycle.configurations[place]
    shapes = cycle.structure.boundaries[configuration]
    modes = cycle.structure.shapes[configuration]
    exponents = numbers.exponents[configuration]
    flow, field = numbers.flows[configuration], numbers.fields[:, configuration]
    if isinstance(flow, FactoredFlows):
        moved = flow.parts(np.concatenate([start, np.ones((len(start), 1))], axis=1))
    else:
        moved = np.einsum("kfij,kj->kfi", flow[..., :-1], start) + flow[..., -1]
    rows = numbers.rows[:, [shape.row for shape in shapes]]
    coefficients = []
    for _ in range(3):
        values = np.einsum("kbi,kfi->kbf", rows[..., :-1], moved)
        values[..., 0] += rows[..., -1]  # the first function is 1
        coefficients.append(values)
        rows = rows[..., :-1] @ field

    def basis(points: np.ndarray, times: np.ndarray) -> np.ndarray:
        return np.stack(functions_at(modes, exponents[points], times), axis=-1)

    return PhaseWaves(
        place,
        tuple(shape.name for shape in shapes),
        cycle.boundaries[place],
        dwell[:, place],
        float(np.max(np.hypot(exponents[..., 0], exponents[..., 1]), initial=0.0)),
        basis,
        np.stack(coefficients),
    )
