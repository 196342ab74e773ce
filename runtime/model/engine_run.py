"""What an engine gives: the transitions of one motion, and why it ended.

The two engines, compiled (`engine/`) and in Python (`stepping`), follow one set of rules and
give this one record, and share the limits of `engine/engine_limits.h`.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from enum import IntEnum
from pathlib import Path
from typing import NamedTuple

import numpy as np

# what they are is told there, beside each
_LIMITS = dict(
    re.findall(
        r"(?m)^#define (\w+) ([\d.e]+)",
        Path(__file__).parents[1].joinpath("engine", "engine_limits.h").read_text(encoding="utf-8"),
    )
)
LARGEST_STATE, LONGEST_WAIT, LONGEST_QUIET, FARTHEST_END, GROWTH = (
    float(_LIMITS[name])
    for name in ("LARGEST_STATE", "LONGEST_WAIT", "LONGEST_QUIET", "FARTHEST_END", "GROWTH")
)
MOST_AT_ONCE, MOST_POLES, ORDERS = (
    int(_LIMITS[name]) for name in ("MOST_AT_ONCE", "MOST_POLES", "ORDERS")
)


class Status(IntEnum):
    """Why a simulation ended."""

    TRANSITIONS = 0  # as many as were asked for
    UNTIL = 1  # the time that was asked for
    QUIET = 2  # no boundary can be reached any more, or none was for very long
    UNDECLARED = 3  # the system declares no transition for the boundaries that were reached
    IMMEDIATE = 4  # one transition after the other without any time between them
    OVERFLOW = 5  # a state that is not below LARGEST_STATE, or numbers in which no step gets on
    AMBIGUOUS = 6  # the laws of contact leave open what follows

    @property
    def message(self) -> str:
        """What happened, and what to do next."""
        return _MESSAGES[self]


_MESSAGES = {
    Status.TRANSITIONS: "as many transitions as were asked for",
    Status.UNTIL: "the time that was asked for is reached",
    Status.QUIET: "no boundary is reached any more",
    Status.UNDECLARED: "the system declares no transition for what happens here",
    Status.IMMEDIATE: "transitions follow each other without any time between them",
    Status.OVERFLOW: "numbers are larger, or times shorter, than the engine computes with",
    Status.AMBIGUOUS: "the laws of contact leave open what follows here",
}


class Grazing(NamedTuple):
    """A boundary touched within rounding and not crossed.

    Attributes
    ----------
    time : float
    configuration, boundary : int
    depth : float
        The boundary function at its maximum; its sign is not certain.
    """

    time: float
    configuration: int
    boundary: int
    depth: float


@dataclass(frozen=True, eq=False)
class Run:
    """One motion: an entry for the start and one for the state behind each transition.

    Sets of boundaries are masks, see `boundary_sets`.
    """

    times: np.ndarray  # (n,)
    configurations: np.ndarray  # (n,) of int32
    before: np.ndarray  # (n, N), state in front of the transition; at the start the state itself
    states: np.ndarray  # (n, N), state behind the transition
    # (n,), mask of the boundaries of the configuration before that were reached together; 0 at the
    # start; int32, or Python's integers where there may be more than 31 boundaries
    sets: np.ndarray
    # the compiled engine reports the first 256 of one stay in a configuration
    grazings: tuple[Grazing, ...]
    status: Status
    end: float  # time at which the simulation ended: that of the last transition, or `until`
    # configurations that may follow, where the contact law leaves it open
    options: tuple[int, ...] = ()
    open_at: int = 0  # mask of the boundaries that are reached together there
    missing: int = 0  # mask of boundaries reached together for which no transition is declared
