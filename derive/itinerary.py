"""Itineraries: the cyclic sequence of phases of a periodic orbit, and how it is presented."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cache
from keyword import iskeyword

import sympy as sp

from nonsmooth.derive.dynamics import FirstOrder, SecondOrder
from nonsmooth.derive.errors import DeclarationError
from nonsmooth.derive.parameter import Parameter, exact
from nonsmooth.derive.system import Boundary, Condition, Configuration, System, Transition

__all__ = ["Itinerary", "Phase", "Presentation", "Reference"]


@dataclass(frozen=True)
class Phase:
    """One phase: a configuration, the boundary by which it is left, its dwell time's name."""

    configuration: str
    boundary: str
    dwell_time: str


@dataclass(frozen=True)
class Presentation:
    """Coordinates and parameters in which an orbit's equations are written.

    Parameters
    ----------
    states : tuple of symbols
        Names of the shifted states, in the order of the system's.
    origin : tuple of expressions
        Physical state at which all of them vanish: physical = shifted + origin.
    parameters : tuple of Parameter
        New parameters that the substitution brings in.
    substitution : mapping of symbol to expression
        System parameters in terms of the new ones, e.g. u_r = u_s + e.
    """

    states: tuple[sp.Symbol, ...]
    origin: tuple[sp.Expr, ...]
    parameters: tuple[Parameter, ...] = ()
    substitution: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)

    def __post_init__(self) -> None:
        object.__setattr__(self, "states", tuple(self.states))
        object.__setattr__(self, "origin", tuple(map(exact, self.origin)))
        substitution = {s: exact(e) for s, e in self.substitution.items()}
        object.__setattr__(self, "substitution", sp.Dict(substitution))
        if len(self.origin) != len(self.states):
            raise DeclarationError(
                f"presentation has {len(self.states)} states but {len(self.origin)} origins"
            )

    def present(self, system: System) -> System:
        """The system written in these coordinates and parameters."""
        if len(self.states) != len(system.states):
            raise DeclarationError(
                f"presentation has {len(self.states)} states, system has {len(system.states)}"
            )
        values = dict(self.substitution.items())
        origin = sp.Matrix(self.origin).subs(values)
        names = dict(zip(system.states, self.states, strict=True))
        shifts = {s: names[s] + o for s, o in zip(system.states, origin, strict=True)}

        @cache
        def affine(expression: sp.Expr) -> sp.Expr:
            moved = sp.expand(expression.subs(values).subs(shifts, simultaneous=True))
            linear = sum(sp.diff(moved, s) * s for s in self.states)
            return linear + sp.cancel(sp.expand(moved - linear))

        def dynamics(old: SecondOrder | FirstOrder) -> SecondOrder | FirstOrder:
            if isinstance(old, SecondOrder):
                if any(origin[old.mass.rows :, :]):
                    raise DeclarationError(
                        "presentation shifts a velocity, which a second-order motion cannot carry"
                    )
                return old.substituted(values | names).shifted(origin[: old.mass.rows, :])
            matrix, offset = old.matrix.subs(values), old.offset.subs(values)
            return FirstOrder(matrix, (offset + matrix * origin).applyfunc(sp.cancel))

        replaced = set(values)
        kept = tuple(p for p in system.parameters if p.symbol not in replaced)
        return replace(
            system,
            states=self.states,
            parameters=kept + self.parameters,
            configurations=tuple(
                Configuration(
                    c.name,
                    dynamics(c.dynamics),
                    tuple(Boundary(b.name, affine(b.function), b.acts_when) for b in c.boundaries),
                )
                for c in system.configurations
            ),
            transitions=tuple(
                Transition(
                    t.source,
                    t.boundaries,
                    t.target,
                    tuple(Condition(affine(c.function), c.along, c.holds) for c in t.conditions),
                    {
                        names[s]: affine(e) - o
                        for (s, e), o in (
                            (item, origin[system.states.index(item[0])]) for item in t.reset.items()
                        )
                    },
                )
                for t in system.transitions
            ),
            constraints=tuple(sp.expand(c.subs(values)) for c in system.constraints),
        )


@dataclass(frozen=True)
class Reference:
    """A known point of an orbit: decimal parameters and a guess of a few digits."""

    parameters: Mapping[str, str]
    guess: Mapping[str, str]

    def __post_init__(self) -> None:
        object.__setattr__(self, "parameters", dict(self.parameters))
        object.__setattr__(self, "guess", dict(self.guess))


@dataclass(frozen=True)
class Itinerary:
    """The cyclic sequence of phases of a periodic orbit of one system.

    Parameters
    ----------
    name : str
        Name of the orbit; with the system's it reads ``system/orbit``.
    system : System
    phases : sequence of Phase or of (configuration, boundary, dwell time) triples
        The orbit starts where the first phase starts.
    presentation : Presentation, optional
        Coordinates and parameters for the equations; the system's own when omitted.
    reference : Reference, optional
        Default parameters and a guess to start from.

    Raises
    ------
    DeclarationError
        For an unknown configuration, a boundary that its configuration does not have,
        a phase after which no transition leads to the next, or a repeated dwell time.
    """

    name: str
    system: System
    phases: tuple[Phase, ...]
    presentation: Presentation | None = None
    reference: Reference | None = None

    def __post_init__(self) -> None:
        phases = tuple(p if isinstance(p, Phase) else Phase(*p) for p in self.phases)
        object.__setattr__(self, "phases", phases)
        if not phases:
            raise DeclarationError(f"itinerary {self.name!r} has no phases")
        dwell_times = [p.dwell_time for p in phases]
        for dwell_time in dwell_times:
            if dwell_times.count(dwell_time) > 1:
                raise DeclarationError(
                    f"itinerary {self.name!r}: dwell time {dwell_time!r} is named twice"
                )
        taken = {*map(str, self.system.states), *(p.name for p in self.system.parameters)}
        if self.presentation is not None:
            taken |= {*map(str, self.presentation.states)}
            taken |= {p.name for p in self.presentation.parameters}
        for dwell_time in dwell_times:
            where = f"itinerary {self.name!r}: dwell time {dwell_time!r}"
            if not dwell_time.isidentifier() or iskeyword(dwell_time):
                raise DeclarationError(f"{where} is not an identifier")
            if dwell_time in taken:
                raise DeclarationError(f"{where} has the name of a state or parameter")
        for phase, following in zip(phases, phases[1:] + phases[:1], strict=True):
            self.system.configuration(phase.configuration).boundary(phase.boundary)
            self.system.configuration(following.configuration)
            self.system.transition(phase.configuration, phase.boundary, following.configuration)

    def rotated(self, by: int) -> Itinerary:
        """The same cycle started `by` phases later."""
        by %= len(self.phases)
        return replace(self, phases=self.phases[by:] + self.phases[:by])

    @property
    def presented_system(self) -> System:
        """The system in the coordinates and parameters of the presentation."""
        return self.presentation.present(self.system) if self.presentation else self.system

    def transition_after(self, system: System, index: int) -> Transition:
        """The transition of `system` that ends phase `index`."""
        phase, following = self.phases[index], self.phases[(index + 1) % len(self.phases)]
        return system.transition(phase.configuration, phase.boundary, following.configuration)
