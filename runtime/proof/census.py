"""How many orbits an itinerary has in a box: the record of what was proved."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated

from nonsmooth.runtime.core.json_codec import IN_FILES, BlankValue, Exact, Follows
from nonsmooth.runtime.core.registry import Certified
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.naming import shown_name
from nonsmooth.runtime.model.saved_system import KeptOrbitName
from nonsmooth.runtime.proof.certificate import Certificate, Declaration

Bounds = Mapping[str, tuple[Exact, Exact]]  # of each unknown that was searched: decimal texts


@dataclass(frozen=True, eq=False)
class Counted:
    """One orbit.

    Attributes
    ----------
    unique : dict of str to (lower, upper)
        Of the unknowns that were searched: no other orbit is in between.
    certificate : Certificate or None
        None where none could be made, though the orbit is proved to exist.
    reason : str
        Why there is none.
    """

    unique: Bounds
    certificate: Certificate | None
    reason: str

    @property
    def admissible(self) -> bool | None:
        """Whether it is a motion of the real system; None if that is undecided."""
        if self.certificate is None:
            return None
        verdict = self.certificate.claims["admissibility"]
        return {"proved": True, "refuted": False}.get(verdict)


@dataclass(frozen=True, eq=False)
class Open:
    """A box of which it is not known how many orbits it holds, and why."""

    bounds: Bounds
    reason: str


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class Census(Certified):
    """All orbits of an itinerary in a box.

    An orbit here is a solution of the itinerary's switching and closure equations with dwell
    times in the box; whether it is a motion of the real system is its `admissible`.

    Attributes
    ----------
    orbit, system : str
    parameters : dict of str to Value
        All physical parameters of the system, exactly.
    itinerary : tuple of (configuration, boundary)
    box : tuple of str
        Bounds of the dwell times, as inequalities.
    chosen : tuple of str
        Parameters that the orbit leaves open: the census is for these values.
    given_period : Value or None
        What the dwell times sum up to, where it was given.
    largest : str
        The largest size of a coordinate.
    conditions : tuple of str
        What else the orbits were asked for.
    orbits : tuple of Counted
        Each proved to exist, and to be another one than the others; by their dwell times.
    undecided : tuple of Open
        Boxes of which nothing is known.
    bits : int
        Of the certificates.
    declaration : dict
        The system, as functions of its parameters, as in the file.
    trees : tuple of str
        How the searched boxes are cut, and what is proved of each part: one tree for each number of
        the forcing's turns.
    """

    orbit: KeptOrbitName
    system: str
    parameters: Mapping[str, Value]
    itinerary: tuple[tuple[str, str], ...]
    chosen: tuple[str, ...]
    given_period: BlankValue
    largest: Exact
    box: tuple[str, ...]
    conditions: tuple[str, ...]
    orbits: tuple[Counted, ...]
    undecided: tuple[Open, ...]
    bits: int
    declaration: Declaration = field(repr=False)
    trees: Annotated[tuple[str, ...], IN_FILES] = field(repr=False)

    @Follows
    def looked(self) -> int:
        """How many boxes the trees have, but for those left open."""
        return sum(len(tree) - tree.count("?") for tree in self.trees)

    @Follows
    def count(self) -> int:
        """How many orbits were proved; there are no others if the census is decided."""
        return len(self.orbits)

    @Follows
    def admissible(self) -> int:
        """How many of them were proved to be motions of the real system."""
        return sum(1 for orbit in self.orbits if orbit.admissible)

    @Follows
    def decided(self) -> bool:
        """Whether no box is undecided: the count is exact."""
        return not self.undecided

    @property
    def claims(self) -> dict[str, str]:
        """Of the census as a whole: whether the count is exact."""
        return {"orbits": "proved" if self.decided else "undecided"}

    @Follows
    def statement(self) -> str:
        """What is proved, as a sentence."""
        data = ", ".join(f"{name} = {value}" for name, value in self.parameters.items())
        number = f"exactly {self.count}" if self.decided else f"at least {self.count}"
        many = "orbit" if self.count == 1 else "orbits"
        refuted = sum(1 for orbit in self.orbits if orbit.admissible is False)
        parts = [f"{self.admissible} admissible", f"{refuted} not admissible"]
        if left := self.count - self.admissible - refuted:
            parts.append(f"{left} undecided")
        asked = ", ".join((*self.box, *self.conditions))
        text = (
            f"{shown_name(self.orbit)} at {data} has {number} {many} with {asked}:"
            f" {', '.join(parts)}"
        )
        if not self.decided:
            boxes = "box is" if len(self.undecided) == 1 else "boxes are"
            text += f"; {len(self.undecided)} {boxes} undecided"
        return text
