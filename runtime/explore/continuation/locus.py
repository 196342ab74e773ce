"""A curve in the plane of two parameters along which an event happens."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import Table, one_of
from nonsmooth.runtime.core.registry import Kept, registered
from nonsmooth.runtime.explore.continuation.event_kinds import KINDS
from nonsmooth.runtime.explore.continuation.orbit_family import OrbitFamily
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.orbit_file import KeptOrbit

__all__ = ["Locus"]


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class Locus(Kept):
    """A curve in the plane of two parameters along which an event happens.

    Attributes
    ----------
    kind : str
        A key of `nonsmooth.runtime.explore.continuation.event.KINDS`.
    boundary : str
        Empty where the event is no matter of one.
    parameters : (str, str)
    values : array (k, 2)
        Of both parameters, in the order in which the points follow.
    unknown_names : tuple of str
    unknowns : array (k, n)
    ends : tuple of str
        Why it ends on either side.
    start : int
        Which of the points it was followed from.
    orbit : Orbit
        That the branch of the event was followed from.
    """

    kind: Annotated[str, one_of(tuple(KINDS))]
    boundary: str
    parameters: tuple[str, str]
    values: Table
    unknown_names: tuple[str, ...]
    unknowns: Table
    ends: tuple[str, str]
    start: int
    orbit: KeptOrbit

    def __len__(self) -> int:
        return len(self.values)

    @property
    def name(self) -> str:
        """Name of the orbit."""
        return self.orbit.name

    @property
    def title(self) -> str:
        """The event and the orbit in words."""
        kind = self.kind.replace("-", " ")
        return f"{kind}{' of ' * bool(self.boundary)}{self.boundary}: {self.name}"

    def orbit_at(self, place: int) -> Orbit:
        """Give the orbit at a point of the curve.

        Parameters
        ----------
        place : int
            Number of the point, counted from 0.

        Returns
        -------
        Orbit

        Raises
        ------
        InputError
            If the curve has no such point.
        """
        if not -len(self) <= place < len(self):
            raise InputError(f"the curve has {len(self)} points, no point {place}")
        first, second = self.values[place].tolist()
        family = OrbitFamily(self.orbit, self.parameters[0]).moved(self.parameters[1], second)
        return family.at(np.append(self.unknowns[place], first))

    def plot(self, axes: Any = None) -> Any:
        """Draw the curve in the plane of its parameters.

        Parameters
        ----------
        axes : matplotlib Axes, optional
            Where to draw; a figure of its own when omitted.

        Returns
        -------
        matplotlib Axes
            What was drawn on.
        """
        return registered("draw_locus")(self, axes)
