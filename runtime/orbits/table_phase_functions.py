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
    """A condition of a transition: a derivative of a row along a configuration's flow.

    Attributes
    ----------
    place : int
        The phase whose end it is about.
    row, along, order : int
        Of the row, the configuration and the derivative.
    """

    place: int
    row: int
    along: int
    order: int

    def value(self, numbers: Numbers, ends: np.ndarray) -> np.ndarray:
        """Its values at k points.

        Parameters
        ----------
        numbers : Numbers
            Of k points.
        ends : array (k, p, N)
            States at the ends of the phases.

        Returns
        -------
        array (k,)
        """
        end, field = ends[:, self.place], numbers.fields[:, self.along]
        *_, row = derivatives(numbers.rows[..., self.row, :], field, self.order + 1, _rate)
        return np.asarray((row[..., :-1] * end).sum(axis=-1) + row[..., -1])


@dataclass(frozen=True)
class Conditions:
    """What decides where the transitions of a cycle lead.

    Attributes
    ----------
    rows : tuple of ConditionRow
    choices : for each phase, for each transition that is declared for its boundaries
        pairs of the place of a condition among `rows`, None where all derivatives vanish,
        and whether it has to be positive.
    """

    rows: tuple[ConditionRow, ...]
    choices: tuple[tuple[tuple[tuple[int | None, bool], ...], ...], ...]

    def taken(self, values: np.ndarray) -> np.ndarray:
        """Which of its transitions each phase takes, from values (k, c): (k, p), -1 for none.

        As `first_following`, over the many points of a branch at once.

        Parameters
        ----------
        values : array (k, c)
            Of the conditions.

        Returns
        -------
        array (k, p) of int
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
    """Conditions of a cycle's transitions, by the derivatives that decide at this point.

    Parameters
    ----------
    cycle : ItineraryShape
    numbers : Numbers
        Of one point.
    now : Shooting
        The cycle at this point.
    """
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
    """Order of the first derivative that is not zero."""
    end = now.ends[place]

    def differs(_: int, function: np.ndarray) -> bool:
        value = float(function[:-1] @ end + function[-1])
        size = float(abs(function[:-1]) @ abs(end) + abs(function[-1]))
        return abs(value) > _ZERO * size

    functions = derivatives(numbers.rows[row], numbers.fields[along], len(end) + 1, _rate)
    found = leading(functions, differs, int(row == own))
    return None if found is None else found.order


def _rate(row: Any, field: Any) -> Any:
    """Derivative of an affine function along an affine field."""
    return (row[..., None, :-1] @ field)[..., 0, :]


def phase_waves(
    cycle: ItineraryShape, numbers: Numbers, start: np.ndarray, dwell: np.ndarray, place: int
) -> PhaseWaves:
    """Boundary functions along one phase at k points, by the modes of its configuration.

    Parameters
    ----------
    cycle : ItineraryShape
    numbers : Numbers
        Of k points.
    start : array (k, N)
        States at the start of the phase.
    dwell : array (k, p)
        In the unit of time.
    place : int
        Index of the phase.
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
