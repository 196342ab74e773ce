"""What a contact law says at an event, proved: double precision guesses its steps, balls judge.

Each step is right by the signs of exact combinations of declared rows. Those before the last
are decided by their own values, the last one by the first derivative behind the event that is
not zero. A step whose signs all hold is the only one.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.events.leading_derivative import Undecided
from nonsmooth.runtime.events.transition_choice import Decider
from nonsmooth.runtime.model.contacts.law import ContactEvent
from nonsmooth.runtime.model.contacts.stages import Combination, requirements
from nonsmooth.runtime.proof.motion.enclosures import EnclosedSystem
from nonsmooth.runtime.proof.motion.exact_rows import Invariants, Row

if TYPE_CHECKING:
    from flint import arb

__all__ = ["lawful"]

_ERROR = 2.0**-40  # of the guess


def lawful(
    system: EnclosedSystem,
    source: int,
    event: ContactEvent,
    invariants: Invariants,
    state: Sequence[arb],
) -> int | None:
    """Return the configuration behind an event of coupled contacts, or None if it is not proved.

    `source` is the configuration that ends. The state (N) is known by its enclosure and by
    invariants that hold exactly.
    """
    law, exact = system.structure.law, system.exact
    assert law is not None
    known = np.array([*(float(x.mid()) for x in state), 1.0])
    arrays = (_floats(exact.fields)[:, :-1], _floats(exact.rows), _floats(exact.resets)[:, :-1])
    decider = Decider(system.structure, *arrays)
    guess = decider.outcome(event, decider.located(source, known, _ERROR))
    if len(guess.targets) != 1:
        return None
    (target,), (path,) = guess.targets, guess.paths
    for stage in path:
        try:
            wanted = requirements(law, event, stage, lambda row: exact.rows[row][-1])
            for function, positive, _ in wanted:
                row = _row(function, exact.rows)
                found = system.leading(row, target, invariants, state)
                if (found is not None and found.sign > 0) != positive:
                    return None
                if stage is not path[-1] and (found is None or found.order):
                    return None
        except (Undecided, ZeroDivisionError):
            return None
    reset, size = law.reset(event, target), len(known)
    unit = [[int(i == j) for j in range(size)] for i in range(size)]
    return target if invariants.agree(exact.resets[reset], unit) else None


def _floats(numbers: Any) -> np.ndarray:
    exact = np.array(numbers, dtype=object)
    return np.array([int(x.p) / int(x.q) for x in exact.flat]).reshape(exact.shape)


def _row(function: Combination, rows: Sequence[Row]) -> Row:
    """Return the row of a combination of declared rows."""
    parts = [[factor * x for x in rows[k]] for k, factor in function.items()]
    if not parts:
        return tuple(0 * x for x in rows[0])
    return tuple(sum(column[1:], column[0]) for column in zip(*parts, strict=True))
