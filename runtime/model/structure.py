"""What a system is apart from its parameters: configurations, boundaries, transitions by index."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cache, cached_property, lru_cache

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.model.contacts.law import Law, law_of
from nonsmooth.runtime.model.contacts.stages import Path
from nonsmooth.runtime.model.kernels import SystemKernels, kernels_of
from nonsmooth.runtime.model.loading.declared import DeclaredSystem
from nonsmooth.runtime.model.loading.growing import NOT_VISITED

FORCING_PHASE = "forcing-phase"  # in an itinerary: the phase of the first forcing begins anew


@dataclass(frozen=True)
class ModeShape:
    """Functions of time with one exponent: t^k e^(st) cos(wt), and sines where it oscillates.

    `places` are the functions' places among those of the configuration: for each power k the
    cosine's, then the sine's if there is one. A `joined` mode continues the chain of the mode in
    front of it (`time_functions`) and has one power. A `paired` mode stands for its exponent and
    the conjugate one: its second function is the divided difference of both. A `factored` mode
    has factors in place of matrices (`factored_flows`).
    """

    length: int
    oscillates: bool
    places: tuple[int, ...]
    joined: bool = False
    paired: bool = False
    factored: bool = False


Modes = tuple[tuple[ModeShape, ...], ...]  # of each configuration


@dataclass(frozen=True)
class BoundaryShape:
    """A boundary of a configuration: its name, its row, and whether it acts as soon as reached."""

    name: str
    row: int
    reached: bool  # else it acts when exceeded


@dataclass(frozen=True)
class TransitionShape:
    """What follows when exactly these boundaries are reached at one instant."""

    boundaries: frozenset[int]  # indices among the boundaries of the source
    # (row, configuration, bool): the first nonzero derivative of the row along the configuration's
    # flow is positive, or not
    conditions: tuple[tuple[int, int, bool], ...]
    reset: int
    target: int
    order: int = 0  # of the orders in which stops reached together may act; 0 belongs to all
    # the steps of the contact law that lead to it; None if the system lists it
    path: Path | None = None


@dataclass(frozen=True)
class ContactShape:
    """A contact with the surroundings: the rows of its force and of two velocities."""

    name: str
    forces: Mapping[int, int]  # row by configuration
    velocity: int  # row of the velocity of the oscillator's point
    surface: int  # row of the velocity of the surroundings


@dataclass(frozen=True, eq=False)
class Structure:
    """What a system is apart from its parameters; configurations and states by index."""

    name: str
    states: tuple[str, ...]
    configurations: tuple[str, ...]
    # of each configuration; None before a parameter point determines them, for flows without a
    # closed form
    modes: Modes | None
    # for each configuration the positions that keep their velocity
    held: tuple[tuple[int, ...], ...]
    constraints: tuple[tuple[int, ...], ...]  # for each configuration the rows that vanish in it
    boundaries: tuple[tuple[BoundaryShape, ...], ...]  # for each configuration
    transitions: tuple[tuple[TransitionShape, ...], ...]  # for each configuration
    contacts: tuple[ContactShape, ...]
    rows: int  # number of rows
    resets: int  # number of resets
    # states c and s of each harmonic forcing: c^2 + s^2 = 1
    forcing: tuple[tuple[int, int], ...] = ()
    coordinates: tuple[tuple[int, int], ...] = ()  # positions with their velocities
    law: Law | None = None  # decides where no transition is listed
    # row that is zero where the phase of the first forcing begins anew
    forcing_row: int | None = None
    kernels: SystemKernels | None = None  # tables and kernels that it was made from

    def configuration(self, name: str) -> int:
        """Index of a configuration; raises `InputError` if there is none of that name."""
        if name not in self.configurations:
            raise unknown_name("configuration", str(name), self.configurations)
        return self.configurations.index(name)

    @cached_property
    def watched(self) -> tuple[int, ...]:
        """Rows of all boundaries and constraints."""
        rows = {boundary.row for boundaries in self.boundaries for boundary in boundaries}
        return tuple(sorted(rows.union(*self.constraints)))

    @cached_property
    def forced(self) -> tuple[int, ...]:
        """The states of all forcings."""
        return tuple(state for pair in self.forcing for state in pair)

    @cached_property
    def unvisited(self) -> frozenset[int]:
        """Configurations that others lead to and about which nothing more is known."""
        return frozenset(
            place
            for place, found in enumerate(self.boundaries)
            if found and found[0].name == NOT_VISITED
        )

    @cached_property
    def visited(self) -> tuple[int, ...]:
        """All other configurations; if the system is listed whole, all."""
        return tuple(c for c in range(len(self.configurations)) if c not in self.unvisited)

    def check_listed(self, what: str) -> None:
        """Raise `InputError` if configurations are made only when they are visited.

        It guards what compares the configurations of a whole system; `what` names that.
        """
        if self.unvisited:
            raise InputError(
                f"{what} needs all configurations of {self.name}, which has too many to list:"
                " simulate, find_orbits, solve and charts of an orbit make those that they visit"
            )

    def listed(self, source: int, boundaries: frozenset[int]) -> tuple[TransitionShape, ...]:
        """Transitions listed for exactly these boundaries of the configuration `source`."""
        return self._listed.get((source, boundaries), ())

    @cached_property
    def _listed(self) -> dict[tuple[int, frozenset[int]], tuple[TransitionShape, ...]]:
        found: dict[tuple[int, frozenset[int]], tuple[TransitionShape, ...]] = {}
        for source, transitions in enumerate(self.transitions):
            for transition in transitions:
                key = source, transition.boundaries
                found[key] = (*found.get(key, ()), transition)
        return found

    def transitions_to(
        self, source: int, boundaries: frozenset[int], target: int
    ) -> tuple[TransitionShape, ...]:
        """Transitions from `source` to `target` by these boundaries, listed or of the contact law.

        Those of the law come without conditions.
        """
        listed = tuple(t for t in self.listed(source, boundaries) if t.target == target)
        if self.law is None:
            return listed
        event = self.law.event(source, [self.boundaries[source][b].name for b in boundaries])
        if event is None or not self.law.leads(event, target):
            return listed
        return (*listed, TransitionShape(boundaries, (), self.law.reset(event, target), target))

    def exits(self, source: int) -> Iterator[tuple[int, int]]:
        """Yield each boundary of `source` with each target that it may lead to if reached alone."""
        for boundary in range(len(self.boundaries[source])):
            for target in range(len(self.configurations)):
                if self.transitions_to(source, frozenset({boundary}), target):
                    yield boundary, target

    def orders(self, source: int, boundaries: frozenset[int]) -> tuple[int, ...]:
        """Numbers of the orders in which boundaries reached together may act; (0,) for only one."""
        numbers = (t.order for t in self.listed(source, boundaries))
        return tuple(dict.fromkeys(filter(None, numbers))) or (0,)

    def boundary(self, configuration: int, name: str) -> int:
        """Index of a boundary of a configuration; raises `InputError` for an unknown name."""
        names = [b.name for b in self.boundaries[configuration]]
        if name not in names:
            where = self.configurations[configuration]
            raise unknown_name(f"boundary of {where}", name, names)
        return names.index(name)

    @cached_property
    def shapes(self) -> Modes:
        """The modes of each configuration.

        Raises `InputError` if they depend on the parameters and no point is chosen.
        """
        if self.modes is None:
            raise InputError(f"the modes of {self.name} depend on its parameters")
        return self.modes

    @cached_property
    def functions(self) -> tuple[int, ...]:
        """Number of functions of time of each configuration."""
        return tuple(sum(len(mode.places) for mode in modes) for modes in self.shapes)

    def with_modes(self, modes: Modes) -> Structure:
        """The same structure with the modes of a parameter point; equal modes share one record."""
        return _with_modes(self, modes)


@lru_cache(maxsize=1024)
def _with_modes(structure: Structure, modes: Modes) -> Structure:
    return replace(structure, modes=modes)


def structure_of(system: str | SystemKernels | DeclaredSystem) -> Structure:
    """Structure of a system; errors as for `load_system`.

    Examples
    --------
    >>> structure_of("dry-friction").states
    ('x1', 'x2', 'v1', 'v2')
    """
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
    places = {name: place for place, name in enumerate(configurations)}
    for entry in table["transitions"]:
        source = places[entry["source"]]
        names = [b.name for b in boundaries[source]]
        transitions[source].append(
            TransitionShape(
                frozenset(names.index(name) for name in entry["boundaries"]),
                tuple((row, places[along], holds) for row, along, holds in entry["conditions"]),
                entry["reset"],
                places[entry["target"]],
                entry.get("order", 0),
                entry.get("path"),
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
                {places[c]: row for c, row in found["forces"].items()},
                found["velocity"],
                found["surface"],
            )
            for name, found in table["contacts"].items()
        ),
        kernels.rows,
        kernels.resets,
        _pairs(states, table["forcing"]),
        _pairs(states, table["coordinates"]),
        law_of(table, configurations),
        table.get("forcing_row"),
        kernels,
    )


def _pairs(
    states: tuple[str, ...], named: Iterable[tuple[str, str]]
) -> tuple[tuple[int, int], ...]:
    return tuple((states.index(a), states.index(b)) for a, b in named)


def mode_shapes(
    modes: Iterable[
        tuple[int, bool] | tuple[int, bool, bool, bool] | tuple[int, bool, bool, bool, bool]
    ],
) -> tuple[ModeShape, ...]:
    """Shapes of a configuration's modes, with places of their functions of time counted from 0.

    Each mode is given by its length and then by whether it oscillates, and optionally by whether
    it is joined, paired and factored.
    """
    shapes, first = [], 0
    for length, oscillates, *chained in modes:
        count = length * (2 if oscillates else 1)
        places = tuple(range(first, first + count))
        shapes.append(ModeShape(length, oscillates, places, *chained))
        first += count
    return tuple(shapes)
