"""What is proved of an orbit's basin of attraction."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated, Any

import numpy as np

from nonsmooth.runtime.core.box_grid import BoxGrid
from nonsmooth.runtime.core.json_codec import IN_FILES, Exact, Several, Told
from nonsmooth.runtime.core.registry import registered
from nonsmooth.runtime.model.naming import shown_name
from nonsmooth.runtime.model.saved_system import KeptOrbitName
from nonsmooth.runtime.proof.certificate import Decided
from nonsmooth.runtime.proof.chaos.h_sets import HSet
from nonsmooth.runtime.proof.sets.graph_certificate import Flags, Numbers
from nonsmooth.runtime.proof.sets.sections import SectionRecord


@dataclass(frozen=True, kw_only=True)
class VerdictEntries:
    """Entries for what is known of tiles: 1 of those that were looked at, 2 of attracted ones."""

    verdicts: Numbers


def _verdicts(looked: Flags, attracted: Flags) -> VerdictEntries:
    return VerdictEntries(verdicts=looked.astype(int) + attracted)


def _flags(found: VerdictEntries) -> tuple[Flags, Flags]:
    return found.verdicts > 0, found.verdicts > 1


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class BasinCertificate(SectionRecord):
    """Starts from which every motion tends to one periodic orbit, the one through the core.

    P is the map from a section to itself. It contracts the core, so that there is one orbit
    through it which attracts all of it. Boxes of the section of the rank 1 are mapped into the
    core, those of the rank r into boxes of smaller ranks; from the tiles every motion comes to
    one of these boxes.

    Attributes
    ----------
    system, orbit : str
    parameters : dict of str to Value
        All of the system, exactly.
    claim : {"proved", "undecided"}
        Whether the orbit attracts all of a set around it.
    reason : str
        Why it is undecided.
    configuration : str
        In which states on the section are.
    phase : tuple of str
        Cosine and sine of the forcing on the section; empty without a forcing.
    source, boundary : str
        What the transition of the section leaves and by what; empty with a forcing.
    coordinates : tuple of str
        States that are the coordinates of the section.
    core : HSet or None
        What the map contracts.
    iterates : int
        The power of P that contracts it.
    itinerary : tuple of (configuration, boundary, configuration)
        The transitions on the way, the same for all of the core.
    contraction : str
        By which, at least: a fraction below 1.
    grid : BoxGrid
        Of the section.
    ranks : array of int
        Of each of its boxes: 0 in the core, -1 where nothing is proved.
    tiles : BoxGrid or None
        Of all states, where they are not those of the section: as `states` names them.
    states : tuple of str
    box : dict of str to (lower, upper)
        The box of starts that the tiles cover, which may reach beyond it.
    looked, attracted : array of bool
        Of each tile: whether it was looked at, and whether all motions from it are proved to
        tend to the orbit, those that start on no boundary.
    widest : float
        Sets that are wider were divided on the way.
    most : int
        Parts of one tile, at most.
    bits : int
        Precision of the proof of the core.
    declaration : dict
        The system, as functions of its parameters, as in the file.
    """

    system: str
    orbit: KeptOrbitName
    claim: Decided
    reason: str
    core: HSet | None
    iterates: int
    itinerary: tuple[tuple[str, str, str], ...]
    contraction: Exact
    grid: Annotated[BoxGrid | None, IN_FILES]
    ranks: Annotated[Numbers, IN_FILES] = field(repr=False)
    tiles: Annotated[BoxGrid | None, IN_FILES]
    states: Annotated[tuple[str, ...], IN_FILES]
    box: Annotated[Mapping[str, tuple[float, float]], IN_FILES]
    looked: Annotated[
        Flags, IN_FILES, Several(VerdictEntries, _verdicts, _flags, ("looked", "attracted"))
    ] = field(repr=False)
    attracted: Annotated[Flags, IN_FILES] = field(repr=False)
    widest: float
    most: int
    bits: int

    @property
    def proved(self) -> bool:
        """Whether the orbit is proved to attract all of a set around it."""
        return self.claim == "proved"

    @Told
    def claims(self) -> dict[str, str]:
        """Verdict on "basin"."""
        return {"basin": self.claim}

    @Told
    def share(self) -> float:
        """Which part of the box of starts is proved to be attracted, by its volume."""
        if self.tiles is None or self.attracted.all():
            return float(self.tiles is not None)
        tiles, weights = self.tiles, []
        for name, first, count, side in zip(
            self.states, tiles.first, tiles.counts, tiles.sides, strict=True
        ):
            lower, upper = self.box[name]
            edges = np.clip((np.arange(count + 1) + first) * side, lower, upper)
            weights.append(np.diff(edges) / (upper - lower))
        shares = self.attracted.reshape(tiles.counts)
        for own in reversed(weights):
            shares = shares @ own
        return float(shares)

    @property
    def section_share(self) -> float:
        """Which part of the boxes of the section is proved to be attracted."""
        return float((self.ranks >= 0).mean()) if self.ranks.size else 0.0

    @Told
    def statement(self) -> str:
        """What is proved, in words."""
        if not self.proved or self.grid is None:
            return f"nothing is proved of the basin: {self.reason}"
        where = (
            f"{int((self.ranks >= 0).sum())} of {self.ranks.size} boxes of the section"
            f" ({', '.join(self.coordinates)})"
        )
        told = f"every motion from {where} tends to {shown_name(self.orbit)}"
        if self.tiles is None:
            return told
        part = f"{int(self.attracted.sum())} of {self.attracted.size} tiles of the box of starts"
        return f"{told}; so does every motion from {part} that starts on no boundary"

    def to_json(self) -> dict[str, Any]:
        """Give what is proved as JSON, with bounds in place of boxes and tiles.

        Returns
        -------
        dict
            Ready for `json.dumps`.
        """
        return {
            **super().to_json(),
            "section": {
                "share": self.section_share,
                "bounds": _bounds(self.grid, self.ranks >= 0, self.coordinates),
            },
            "tiles": {
                "count": int(self.attracted.size),
                "looked": int(self.looked.sum()),
                "attracted": int(self.attracted.sum()),
                "sides": [] if self.tiles is None else self.tiles.sides.tolist(),
                "states": list(self.states),
                "box": {name: list(ends) for name, ends in self.box.items()},
                "bounds": _bounds(self.tiles, self.attracted, self.states),
            },
        }

    def plot(self, axes: Any = None) -> Any:
        """Draw what is proved.

        Parameters
        ----------
        axes : optional
            Two axes of matplotlib.

        Returns
        -------
        Figure
        """
        return registered("draw_basin")(self, axes)


def _bounds(grid: BoxGrid | None, chosen: Flags, names: tuple[str, ...]) -> dict[str, list[float]]:
    """Least and largest value of each coordinate over the chosen boxes, by name."""
    numbers = np.flatnonzero(chosen)
    if grid is None or not len(numbers):
        return {}
    low, high = grid.bounds(numbers)
    return {
        name: [float(a), float(b)]
        for name, a, b in zip(names, low.min(axis=0), high.max(axis=0), strict=True)
    }
