"""What a system is apart from its parameters: configurations, boundaries, transitions by index."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cache, cached_property, lru_cache

from nonsmooth.runtime.errors import InputError, unknown_name
from nonsmooth.runtime.kernels import SystemKernels, kernels_of
from nonsmooth.runtime.loading.declared import DeclaredSystem

__all__ = [
    "FORCING_PHASE",
    "BoundaryShape",
    "ContactShape",
    "ModeShape",
    "Modes",
    "Structure",
    "TransitionShape",
    "mode_shapes",
    "structure_of",
]

FORCING_PHASE = "forcing-phase"  # in an itinerary: the phase of the first forcing begins anew


@dataclass(frozen=True)
class ModeShape:
    """Functions of time with one exponent: t^k e^(st) cos(wt), and sines where it oscillates.

    `places` are the functions' places among those of the configuration: for each power k the
    cosine's, then the sine's if there is one.
    """

    length: int
    oscillates: bool
    places: tuple[int, ...]


Modes = tuple[tuple[ModeShape, ...], ...]  # of each configuration


@dataclass(frozen=True)
class BoundaryShape:
    """A boundary of a configuration: its name, its row, and whether reaching it is enough."""

    name: str
    row: int
    reached: bool


@dataclass(frozen=True)
class TransitionShape:
    """What follows when exactly these boundaries are reached at one instant.

    Attributes
    ----------
    boundaries : frozenset of int
        Indices among the boundaries of the source.
    conditions : tuple of (row, configuration, bool)
        The first nonzero derivative of the row along the configuration's flow is positive,
        or not.
    reset, target : int
    """

    boundaries: frozenset[int]
    conditions: tuple[tuple[int, int, bool], ...]
    reset: int
    target: int


@dataclass(frozen=True)
class ContactShape:
    """Where the surroundings act: rows of force by configuration, of velocity, of the surface."""

    name: str
    forces: Mapping[int, int]
    velocity: int
    surface: int


@dataclass(frozen=True, eq=False)
class Structure:
    """What a system is apart from its parameters; configurations and states by index.

    Attributes
    ----------
    name : str
    states, configurations : tuple of str
    modes : for each configuration its modes
        None before the numbers of a parameter point tell them, where flows have no closed form.
    held : for each configuration the positions that keep their velocity
    constraints : for each configuration the rows that vanish in it
    boundaries, transitions : for each configuration
    contacts : tuple of ContactShape
    rows, resets : int
        How many there are.
    forcing : tuple of (int, int)
        States c and s of a harmonic forcing: c^2 + s^2 = 1.
    coordinates : tuple of (int, int)
        Positions and their velocities.
    forcing_row : int or None
        Row that is zero where the phase of the first forcing begins anew.
    """

    name: str
    states: tuple[str, ...]
    configurations: tuple[str, ...]
    modes: Modes | None
    held: tuple[tuple[int, ...], ...]
    constraints: tuple[tuple[int, ...], ...]
    boundaries: tuple[tuple[BoundaryShape, ...], ...]
    transitions: tuple[tuple[TransitionShape, ...], ...]
    contacts: tuple[ContactShape, ...]
    rows: int
    resets: int
    forcing: tuple[tuple[int, int], ...] = ()
    coordinates: tuple[tuple[int, int], ...] = ()
    forcing_row: int | None = None

    def configuration(self, name: str) -> int:
        """Index of a configuration; InputError if there is none of that name."""
        if name not in self.configurations:
            raise unknown_name("configuration", str(name), self.configurations)
        return self.configurations.index(name)

    def boundary(self, configuration: int, name: str) -> int:
        """Index of a boundary of a configuration; InputError if it has none of that name."""
        names = [b.name for b in self.boundaries[configuration]]
        if name not in names:
            where = self.configurations[configuration]
            raise unknown_name(f"boundary of {where}", name, names)
        return names.index(name)

    @cached_property
    def shapes(self) -> Modes:
        """The modes, where they are known."""
        if self.modes is None:
            raise InputError(f"the modes of {self.name} depend on its parameters")
        return self.modes

    @cached_property
    def functions(self) -> tuple[int, ...]:
        """Number of functions of time of each configuration."""
        return tuple(sum(len(mode.places) for mode in modes) for modes in self.shapes)

    def with_modes(self, modes: Modes) -> Structure:
        """The same with the modes of a parameter point; one record for equal modes."""
        return _with_modes(self, modes)


@lru_cache(maxsize=1024)
def _with_modes(structure: Structure, modes: Modes) -> Structure:
    return replace(structure, modes=modes)


def structure_of(system: str | SystemKernels | DeclaredSystem) -> Structure:
    """Structure of a system; InputError for an unknown name."""
    kernels = kernels_of(system)
    return _structure(kernels)


@cache
def _structure(kernels: SystemKernels) -> Structure:
    table = kernels.table
    configurations = tuple(table["configurations"])
    states = tuple(table["states"])
    modes = None
    if table["modes"] is not None:
        modes = tuple(
            mode_shapes((entry["length"], entry["oscillates"]) for entry in table["modes"][name])
            for name in configurations
        )
    boundaries = tuple(
        tuple(
            BoundaryShape(b["name"], row, b["acts_when"] == "reached")
            for b, row in zip(found, table["boundary_rows"][name], strict=True)
        )
        for name, found in table["configurations"].items()
    )
    transitions: list[list[TransitionShape]] = [[] for _ in configurations]
    for entry in table["transitions"]:
        source = configurations.index(entry["source"])
        names = [b.name for b in boundaries[source]]
        transitions[source].append(
            TransitionShape(
                frozenset(names.index(name) for name in entry["boundaries"]),
                tuple(
                    (row, configurations.index(along), holds)
                    for row, along, holds in entry["conditions"]
                ),
                entry["reset"],
                configurations.index(entry["target"]),
            )
        )
    return Structure(
        kernels.name,
        states,
        configurations,
        modes,
        tuple(tuple(states.index(x) for x in table["held"][name]) for name in configurations),
        tuple(tuple(table["constraint_rows"][name]) for name in configurations),
        boundaries,
        tuple(map(tuple, transitions)),
        tuple(
            ContactShape(
                name,
                {configurations.index(c): row for c, row in found["forces"].items()},
                found["velocity"],
                found["surface"],
            )
            for name, found in table["contacts"].items()
        ),
        kernels.module.KERNELS["rows"][1][0][0],
        kernels.module.KERNELS["resets"][1][0][0] // len(states),
        tuple((states.index(c), states.index(s)) for c, s in table["forcing"]),
        tuple((states.index(x), states.index(v)) for x, v in table["coordinates"]),
        table.get("forcing_row"),
    )


def mode_shapes(modes: Iterable[tuple[int, bool]]) -> tuple[ModeShape, ...]:
    """Modes of a configuration from their lengths and whether they oscillate."""
    shapes, first = [], 0
    for length, oscillates in modes:
        count = length * (2 if oscillates else 1)
        shapes.append(ModeShape(length, oscillates, tuple(range(first, first + count))))
        first += count
    return tuple(shapes)
