"""The publication that an orbit is taken from: its letters, and the numbers of its equations."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import field

from nonsmooth.derive.declaration.fields import declared
from nonsmooth.derive.errors import DeclarationError

_PARTS = (
    "model",
    "start",
    "symmetry",
    "halfway",
    "closure",
    "map",
    "trace",
    "turn",
    "linear start",
    "compatibility",
    "reference",
)


@declared
class Source:
    """The publication that an orbit is taken from, as its document cites it.

    Parameters
    ----------
    name : str
        As it is cited.
    equations : mapping of str to str
        Where the source has what the document prints: the number of an equation in brackets, or
        a section. The keys are ``configuration NAME`` (equations of motion), ``flow NAME``,
        ``phase K`` (the state at the end of phase K, counted from 1), ``end K`` (the condition
        that ends it), ``reset K`` (the transition behind it), ``model`` (units and laws),
        ``start``, ``symmetry``, ``halfway``, ``closure``, ``map``, ``trace``, ``turn`` (periodicity
        by the map of a period), ``linear start`` and ``compatibility`` (what follows from it) and
        ``reference``.
    flows : mapping of configuration to str
        LaTeX of the source's letters for the flows.
    states : tuple of str
        LaTeX of its letters for the start and for the states behind the phases.
    section : str
        LaTeX of its letter for the section on which the orbit starts.
    misprints : mapping of str to str
        What is wrong where it has something of `equations`, as the end of a sentence: ``which
        prints ...``.

    Raises
    ------
    DeclarationError
        For a misprint at a place that no entry of `equations` names.

    Examples
    --------
    >>> from nonsmooth.derive import Source
    >>> Source("Pascal (2011)", {"closure": "(18)"}).cited("closure")
    ', = (18) of Pascal (2011)'
    """

    name: str
    equations: Mapping[str, str]
    flows: Mapping[str, str] = field(default_factory=dict)
    states: tuple[str, ...] = ()
    section: str = ""
    misprints: Mapping[str, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for place in self.misprints:
            if place not in self.equations.values():
                raise DeclarationError(
                    f"source {self.name!r}: a misprint at {place!r}, which no equation names"
                )

    def check(self, configurations: Iterable[str], phases: int) -> None:
        """Refuse keys and letters of what an itinerary does not have.

        Parameters
        ----------
        configurations : iterable of str
            Of its phases.
        phases : int
            How many it has.

        Raises
        ------
        DeclarationError
            That lists the known keys.
        """
        names = list(dict.fromkeys(configurations))
        known = [f"{kind} {name}" for kind in ("configuration", "flow") for name in names]
        known += [f"{kind} {k}" for kind in ("phase", "end", "reset") for k in range(1, phases + 1)]
        for kind, given, allowed in (
            ("place of", self.equations, [*known, *_PARTS]),
            ("letter for the flow of", self.flows, names),
        ):
            for key in given:
                if key not in allowed:
                    raise DeclarationError(
                        f"source {self.name!r}: {kind} {key!r}, which is unknown"
                        f" (known: {', '.join(allowed)})"
                    )
        if len(self.states) > phases + 1:
            raise DeclarationError(
                f"source {self.name!r}: letters for {len(self.states)} states, but the start and"
                f" {phases} phases have {phases + 1}"
            )

    def cited(self, *keys: str) -> str:
        """Cite the places of what the keys stand for, and say what is misprinted there.

        Parameters
        ----------
        *keys : str
            Of `equations`; those that it does not have are passed over.

        Returns
        -------
        str
            Behind a comma; empty if there is nothing to cite.
        """
        places = dict.fromkeys(self.equations[key] for key in keys if key in self.equations)
        if not places:
            return ""
        wrong = [self.misprints[place] for place in places if place in self.misprints]
        sign = "=" if next(iter(places)).startswith("(") else "as in"
        return ", ".join([f", {sign} {' and '.join(places)} of {self.name}", *wrong])
