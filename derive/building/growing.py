"""Oscillators whose configurations are made when they are first visited.

Contacts multiply their configurations: four have up to 81, ten friction contacts 59,049, and every
set of them that may be reached together adds transitions. An oscillator with too many to list is
a `GrowingSystem`. It hands out *pieces*: a configuration with its boundaries and what follows each
of them, or what follows several that are reached at one instant. Of others a piece has the field
where a condition asks for it, and else the name. The runtime puts pieces together as motions and
itineraries ask for them.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from functools import cached_property
from math import prod
from typing import Any

import sympy as sp

from nonsmooth.derive.building.assembly import Assembly, Regimes
from nonsmooth.derive.building.parts import FrictionPart, Part
from nonsmooth.derive.building.transitions import (
    contact_law,
    transitions_alone,
    transitions_at,
    transitions_from,
)
from nonsmooth.derive.declaration.configuration import Configuration, Contact
from nonsmooth.derive.declaration.fields import set_fields
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.declaration.transition import Transition
from nonsmooth.derive.errors import DeclarationError

_LARGEST = 10_000  # coordinates times sets of boundaries, of what is listed at once
_MOST = 4096  # configurations that are listed when they are asked for
# what a growing system has of its own; the rest is made when it is asked for
_GIVEN = ("name", "description", "states", "parameters", "constraints", "forcing", "law", "model")
_MOST_TOGETHER = 7  # parts with friction at rest whose boundaries are reached at one instant


def is_large(assembly: Assembly) -> bool:
    """Whether an oscillator has so many configurations that each is made at its first visit.

    Sets of boundaries are counted without regard to which regimes go together. Contacts
    that the mass matrix couples are excluded: one law decides on them, which knows all
    configurations.
    """
    sets = prod(sum(1 + _exits(part, regime) for regime in part.regimes) for part in assembly.parts)
    return sets * len(assembly.frame.positions) > _LARGEST and not assembly.coupled


def _exits(part: Part, regime: str) -> int:
    losses = part.losses(regime) if isinstance(part, FrictionPart) else ()
    return len(part.names(regime)) + len(losses)


def listed(
    name: str,
    description: str,
    assembly: Assembly,
    constraints: Sequence[sp.Expr],
    products: Sequence[Regimes],
    transitions: Iterable[Transition],
    kind: type[System] = System,
) -> System:
    """The system of some combinations of regimes, with given transitions."""
    return kind(
        name=name,
        description=description,
        states=assembly.frame.states,
        parameters=assembly.frame.parameters,
        configurations=tuple(map(assembly.configuration, products)),
        transitions=tuple(transitions),
        constraints=tuple(constraints),
        contacts=assembly.contacts(products),
        forcing=assembly.phases,
        law=contact_law(assembly, products),
    )


def whole(
    name: str, description: str, assembly: Assembly, constraints: Sequence[sp.Expr]
) -> System:
    """The system of all combinations of regimes that exist."""
    products = assembly.products
    every = (found for regimes in products for found in transitions_from(assembly, regimes))
    return listed(name, description, assembly, constraints, products, every)


class GrowingSystem(System):
    """An oscillator whose configurations are made when they are first visited.

    It is a `System`, whose configurations are the combinations of regimes of the parts in
    `assembly`. What asks for all configurations or transitions gets them if there are at
    most 4096, and is refused otherwise.
    """

    assembly: Assembly

    def __init__(
        self, name: str, description: str, assembly: Assembly, constraints: Sequence[sp.Expr]
    ) -> None:
        checked = listed(name, description, assembly, constraints, (), ())
        set_fields(self, assembly=assembly, **{each: getattr(checked, each) for each in _GIVEN})

    def __eq__(self, other: object) -> bool:
        """Whether the declarations are equal."""
        if not isinstance(other, GrowingSystem):
            return NotImplemented
        return self is other or self.fingerprint() == other.fingerprint()

    def __hash__(self) -> int:
        """Hash of the names: those of equal declarations are equal."""
        return hash((self.name, self.states))

    def __repr__(self) -> str:
        """Name of the system, and an upper bound of the number of its configurations."""
        return f"<System {self.name!r} of up to {self._count:,} configurations>"

    @property
    def identity(self) -> tuple[str, str, Assembly, tuple[sp.Expr, ...]]:
        """The declarations that distinguish the system from every other."""
        return self.name, self.description, self.assembly, self.constraints

    @property
    def configurations(self) -> tuple[Configuration, ...]:
        """All configurations."""
        return self._whole.configurations

    @property
    def transitions(self) -> tuple[Transition, ...]:
        """All transitions."""
        return self._whole.transitions

    @property
    def contacts(self) -> tuple[Contact, ...]:
        """Forces of the surroundings, in all configurations."""
        return self._whole.contacts

    @property
    def _count(self) -> int:
        return prod(len(part.regimes) for part in self.assembly.parts)

    @property
    def _whole(self) -> System:
        if self._count > _MOST:
            raise DeclarationError(
                f"system {self.name!r} has up to {self._count:,} configurations, too many to list"
                f" (at most {_MOST:,}): simulate, solve and find_orbits make those that they visit"
            )
        return self._listed

    @cached_property
    def _listed(self) -> System:
        return whole(*self.identity)

    def configuration(self, name: str) -> Configuration:
        """The configuration of that name, made now; DeclarationError refuses an unknown one."""
        return self.assembly.configuration(self._regimes(name))

    def _transitions_at(self, source: str, boundaries: frozenset[str]) -> Iterable[Transition]:
        """The transitions out of a configuration by these boundaries, made now."""
        return transitions_at(self.assembly, self._regimes(source), boundaries)

    @cached_property
    def regimes(self) -> tuple[tuple[str, tuple[str, ...]], ...]:
        """Name and regimes of each part."""
        return tuple((part.name, part.regimes) for part in self.assembly.parts)

    def has(self, name: str) -> bool:
        """Whether the system has a configuration of that name."""
        return any(self._readings(name))

    def piece(self, name: str, boundaries: Collection[str] = ()) -> str:
        """Source of a Python module for one configuration and what follows its boundaries.

        `boundaries` are reached at one instant; if there are none, each set follows that a part
        reaches alone. The module has tables and kernels of the configuration, and what has to
        be known of those that it leads to. DeclarationError refuses an unknown configuration,
        and too many friction contacts that are reached together.
        """
        from nonsmooth.derive.codegen.piece import emit_piece

        assembly, regimes = self.assembly, self._regimes(name)
        if boundaries:
            self._check_together(regimes, boundaries)
            found = tuple(transitions_at(assembly, regimes, boundaries))
        else:
            found = tuple(transitions_alone(assembly, regimes))
        along = dict.fromkeys(c.along for t in found for c in t.conditions if c.along != name)
        fields = {each: assembly.dynamics(self._regimes(each)) for each in along}
        led = dict.fromkeys(t.target for t in found if t.target not in {name, *along})
        system = listed(*self.identity, [regimes], found, _Piece)
        conditions = [
            {regime: part.conditions(regime) for regime in part.regimes} for part in assembly.parts
        ]
        return emit_piece(system, fields, list(led), conditions)

    def composed(self, orbit: Any) -> dict[str, Any]:
        """The table of an itinerary that is composed at run time.

        DeclarationError refuses one with vanishing phases, a presentation or parameters to
        solve for.
        """
        from nonsmooth.derive.codegen.derived import Underived
        from nonsmooth.derive.codegen.python_file import composed_table

        reason = "its system's configurations are made when they are first visited"
        if orbit.vanishing or orbit.presentation or orbit.solved_for:
            raise DeclarationError(f"itinerary {orbit.name!r} cannot be composed: {reason}")
        return composed_table(Underived(orbit, reason))

    def _check_together(self, regimes: Regimes, boundaries: Collection[str]) -> None:
        rubbing = [
            i
            for i in self.assembly.frictions
            if any(b.name in boundaries for b in self.assembly.boundaries(i, regimes))
        ]
        if len(rubbing) > _MOST_TOGETHER:
            raise DeclarationError(
                f"{len(rubbing)} contacts with friction reach boundaries at one instant, of"
                f" {_MOST_TOGETHER} at most: start the motion off its symmetry"
            )

    def _regimes(self, name: str) -> Regimes:
        for regimes in self._readings(name):
            return regimes
        raise DeclarationError(
            f"system {self.name!r} has no configuration {name!r} (their names are the regimes of"
            f" its elements, as {self.assembly.name(tuple(r[0] for _, r in self.regimes))!r})"
        )

    def _readings(self, name: str) -> Iterator[Regimes]:
        """The existing combinations of regimes that bear a name.

        There may be several, as regimes may contain hyphens.
        """
        readings: list[tuple[Regimes, str]] = [((), f"{name}-")]
        for part in self.assembly.parts:
            readings = [
                ((*read, regime), rest.removeprefix(f"{regime}-"))
                for read, rest in readings
                for regime in part.regimes
                if rest.startswith(f"{regime}-")
            ]
        return filter(self.assembly.exists, (read for read, rest in readings if not rest))


class _Piece(System):
    """A system of one configuration, and of the transitions at its boundaries."""

    def __post_init__(self) -> None:
        """Check nothing, since the elements were checked when the system was declared."""
