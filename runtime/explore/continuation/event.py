"""What happens at one point of a branch."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated

from nonsmooth.runtime.core.errors import InputError, one_line
from nonsmooth.runtime.core.json_codec import FromOne, one_of
from nonsmooth.runtime.core.registry import Shown
from nonsmooth.runtime.explore.continuation.event_kinds import KINDS

__all__ = ["Event", "checked_event"]


@dataclass(frozen=True, kw_only=True, repr=False)
class Event(Shown):
    """A point of a branch where something happens.

    Attributes
    ----------
    kind : str
        What happens: "fold", "flip", "neimark-sacker", "branch-point" or "symmetry-breaking",
        which multipliers show; "grazing", "tangent", "entry", "simultaneous", "condition",
        "vanishing-phase" or "admissibility", which boundaries show.
    parameter : str
    value : float
        Of the parameter.
    unknowns : dict of str to float
    phase : int or None
        Counted from 0, in files from 1, where it is a matter of one.
    configuration, boundary : str
        Of that phase; empty otherwise.
    time : float or None
        Since that phase began.
    place : float
        On the branch: between its points with the numbers before and behind it.
    text : str
        All of it in words.
    touching : bool
        Whether what happens is undone at once: a multiplier comes to the unit circle and turns
        back, a boundary is touched at this value alone.
    """

    kind: Annotated[str, one_of(tuple(KINDS))]
    parameter: str
    value: float
    unknowns: Mapping[str, float]
    phase: FromOne
    configuration: str
    boundary: str
    time: float | None
    place: float
    text: str
    touching: bool = False

    @property
    def border_collision(self) -> bool:
        """Whether the itinerary changes here."""
        return KINDS[self.kind].border_collision

    @property
    def switches(self) -> bool:
        """Whether another branch meets this one here: `Branch.switch` leads to it."""
        return KINDS[self.kind].switches and not self.touching


def checked_event(given: object) -> Event:
    """What is given, where it is an event; `InputError` otherwise."""
    if not isinstance(given, Event):
        raise InputError(f"{one_line(repr(given))} is no event: a branch has them as .events")
    return given
