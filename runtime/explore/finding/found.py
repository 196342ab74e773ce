"""What was found to live in a system: orbits, equilibria, and the starts that led to them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, TypeVar

import numpy as np

from nonsmooth.runtime.core.errors import InputError, one_line
from nonsmooth.runtime.core.registry import Kept, registered
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.explore.finding.outcomes import Outcome
from nonsmooth.runtime.explore.finding.steady import Equilibrium
from nonsmooth.runtime.orbits.orbit import Orbit

__all__ = ["Found", "FoundEquilibrium", "FoundOrbit", "label_names"]

Solved = TypeVar("Solved", Orbit, Equilibrium)


@dataclass(frozen=True, eq=False)
class FoundOrbit:
    """A periodic orbit and how many of the starts led to it.

    Attributes
    ----------
    solved : Orbit or str
        Over its primitive period; of one phase that ends with ``forcing-phase`` where it
        reaches no boundary. Or why an entry of a file is no orbit of its system.
    starts : int
    share : float
        Of all starts; 0 for an orbit that no start led to.
    mirror : int or None
        Place of the orbit before it whose mirror image it is; its own where it is its own.
    """

    solved: Orbit | str
    starts: int
    share: float
    mirror: int | None = None

    @property
    def orbit(self) -> Orbit:
        """The orbit.

        Raises
        ------
        InputError
            Where a file holds what is no orbit of its system; so does all that is told of it.
        """
        return _known(self.solved)

    @property
    def itinerary(self) -> tuple[tuple[str, str], ...]:
        """Phases: configuration, and boundary by which it is left."""
        return self.orbit.itinerary

    @property
    def period(self) -> float:
        """Sum of the dwell times."""
        return float(self.orbit.period)

    @property
    def forcing_periods(self) -> tuple[int, ...]:
        """How many periods of each forcing it lasts; none without a forcing."""
        turns = self.period * np.abs(self.orbit.tables.piecewise.forcing_speeds) / (2 * np.pi)
        return tuple(round(float(count)) for count in turns)

    @property
    def verdict(self) -> str:
        """Stable, unstable, neutral or undecided."""
        return str(self.orbit.stability.verdict)


@dataclass(frozen=True, eq=False)
class FoundEquilibrium:
    """An equilibrium and how many of the starts led to it.

    Attributes
    ----------
    solved : Equilibrium or str
        Or why an entry of a file is no equilibrium of its system.
    starts : int
    share : float
    mirror : int or None
        Place of the equilibrium before it whose mirror image it is, or its own.
    """

    solved: Equilibrium | str
    starts: int
    share: float
    mirror: int | None = None

    @property
    def equilibrium(self) -> Equilibrium:
        """The equilibrium.

        Raises
        ------
        InputError
            Where a file holds what is no equilibrium of its system.
        """
        return _known(self.solved)


@dataclass(frozen=True, eq=False, repr=False)
class Found(Kept):
    """What was found to live in a system, with the largest basins first.

    Attributes
    ----------
    system : str
    parameters : dict of str to Value
    names : tuple of str
        Of the states.
    orbits : tuple of FoundOrbit
    equilibria : tuple of FoundEquilibrium
    starts : array (n, N)
    labels : array (n,) of int
        Where each start led: the place of an orbit, then of an equilibrium, or an `Outcome`.
    box : array (N, 2)
        From where the starts were drawn.
    transitions : int
        How many each start was followed.
    complete : bool
        Whether the search was not interrupted.
    """

    _kept_by = "save_found"

    system: str
    parameters: dict[str, Value]
    names: tuple[str, ...]
    orbits: tuple[FoundOrbit, ...]
    equilibria: tuple[FoundEquilibrium, ...]
    starts: np.ndarray
    labels: np.ndarray
    box: np.ndarray
    transitions: int
    complete: bool = True

    def plot(self, kind: str = "all", *, periods: int = 1) -> Any:
        """Draw the found orbits with the largest basins, a row for each.

        Parameters
        ----------
        kind : {"all", "time", "velocity", "phase"}
            Histories of positions or of velocities, portraits of all masses in one, or portraits
            beside positions.
        periods : int
            How many of them a history has.

        Returns
        -------
        matplotlib Figure

        Raises
        ------
        InputError
            For another kind, or if no orbit was found.
        """
        return registered("found_figure")(self, kind, periods=periods)

    def share(self, outcome: Outcome) -> float:
        """Give the share of the starts that end in one way.

        Parameters
        ----------
        outcome : Outcome
            One of `outcomes`.

        Returns
        -------
        float
            Between 0 and 1.

        Raises
        ------
        InputError
            For several outcomes.
        """
        if np.ndim(outcome):
            raise InputError(f"{one_line(repr(outcome), 60)} is no outcome of one start")
        return float(np.mean(self.labels == outcome)) if self.labels.size else 0.0

    @property
    def outcomes(self) -> dict[Outcome, float]:
        """Shares of the starts that lead to nothing that is listed, by how they end."""
        shares = {outcome: self.share(outcome) for outcome in Outcome}
        return {outcome: share for outcome, share in shares.items() if share}

    @property
    def unclassified(self) -> float:
        """Share of the starts whose motion was not recognised."""
        return self.share(Outcome.UNCLASSIFIED)

    @property
    def resting(self) -> float:
        """Share of the starts that came to rest, at any of the places where that is possible."""
        return self.share(Outcome.RESTING)


def _known(solved: Solved | str) -> Solved:
    """The content of an entry; raises `InputError` with the reason if it is refused."""
    if isinstance(solved, str):
        raise InputError(solved)
    return solved


def label_names(found: Found) -> dict[int, str]:
    """Texts of the labels for pictures: orbits and equilibria that attract, and the outcomes."""
    attracting = {i: entry for i, entry in enumerate(found.orbits) if entry.starts}
    names = {
        i: f"orbit {i + 1}, period {entry.period:.6g}{_apart(i, attracting)}"
        for i, entry in attracting.items()
    }
    count = len(found.orbits)
    for i, entry in enumerate(found.equilibria):
        if entry.starts:
            names[count + i] = f"equilibrium {count + i + 1}, {entry.equilibrium.configuration}"
    return {**names, **{int(outcome): outcome.text for outcome in Outcome}}


def _apart(place: int, attracting: Mapping[int, FoundOrbit]) -> str:
    """Text that distinguishes an orbit from others of its period: mirror image, or start."""
    entry = attracting[place]
    alike = [o.orbit for o in attracting.values() if f"{o.period:.6g}" == f"{entry.period:.6g}"]
    if len(alike) == 1:
        return ""
    if entry.mirror not in (None, place):
        return f", mirror image of {entry.mirror + 1}"
    starts = np.array([orbit.states[0].astype(float) for orbit in alike])
    state = int(np.ptp(starts, axis=0).argmax())
    name = entry.orbit.tables.cycle.structure.states[state]
    return f", from {name} = {float(entry.orbit.states[0, state]):.4g}"
