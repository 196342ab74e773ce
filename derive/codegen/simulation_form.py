"""A system as a simulation needs it: affine rows, vector fields, flows, resets, transitions.

What depends on the parameters is emitted as kernels, over any arithmetic:

* `rows`: every affine function n y + c that the declaration names, once each,
* `fields`: y' = A y + b of each configuration,
* `resets`: every affine reset, once each; the first leaves the state as it is,
* `modes`: the flow of each configuration, y(t) = sum_b phi_b(t) (B_b y(0) + beta_b).

What does not is a table of integers and names that refers to them by index.

The functions phi_b come mode by mode: a mode with the exponent s + i w and `length` l gives
t^k e^(st) cos(wt), and t^k e^(st) sin(wt) where it oscillates, for k = 0, ..., l - 1.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import chain
from typing import Any

import sympy as sp

from nonsmooth.derive.declaration.configuration import Configuration
from nonsmooth.derive.declaration.dynamics import SecondOrder
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.declaration.transition import ContactLaw
from nonsmooth.derive.equations.program import Argument, Kernel, Output
from nonsmooth.derive.flows.modal import Flow, Mode, Spectrum

__all__ = [
    "SimulationForm",
]


@dataclass(frozen=True)
class SimulationForm:
    """A system, its spectrum and its flows in the form of rows and tables.

    Without flows, where no closed form is known, the runtime computes the modes from the
    fields. The functions in `beside` get rows although nothing else contains them.
    """

    system: System
    spectrum: Spectrum = field(default_factory=Spectrum)
    flows: Mapping[str, Flow] | None = None
    beside: tuple[sp.Expr, ...] = ()

    @cached_property
    def rows(self) -> tuple[sp.Expr, ...]:
        """Every affine function of the state that the declaration contains, once each."""
        system = self.system
        named: list[sp.Expr] = [
            boundary.function for c in system.configurations for boundary in c.boundaries
        ]
        named += [c.function for t in system.transitions for c in t.conditions]
        for configuration in system.configurations:
            named += self._constraints(configuration)
        for contact in system.contacts:
            named += [*contact.forces.values(), contact.velocity, contact.surface]
        if system.law is not None:
            named += [f for contact in system.law.contacts for f in contact.functions]
            named += [*system.law.coupling, *chain.from_iterable(system.law.free.values())]
        named += [sine for _, sine in system.forcing[:1]]  # zero where its phase begins anew
        named += self.beside
        return tuple(dict.fromkeys(map(sp.expand, named)))

    @cached_property
    def resets(self) -> tuple[sp.Matrix, ...]:
        """Every reset as a column of expressions of the state, once each, the identity first."""
        system, states = self.system, sp.Matrix(self.system.states)
        columns = [sp.ImmutableMatrix(states)]
        columns += [self._reset(t.reset) for t in system.transitions]
        if system.law is not None:
            columns += [
                self._reset(r) for found in system.law.resets.values() for r in found.values()
            ]
        return tuple(dict.fromkeys(columns))

    @cached_property
    def modes(self) -> dict[str, tuple[Mode, ...]] | None:
        """Modes by configuration; None if one of them has no closed form of that kind."""
        if self.flows is None:
            return None
        found = {name: flow.modes for name, flow in self.flows.items()}
        known = {name: modes for name, modes in found.items() if modes is not None}
        return known if len(known) == len(found) else None

    def kernels(self) -> tuple[Kernel, ...]:
        """Kernels of rows, fields, resets and, where they have a closed form, modes."""
        system = self.system
        parameters = Argument.vector("parameters", (p.symbol for p in system.parameters))
        fields = [c.dynamics.field(system.states) for c in system.configurations]
        tables = (
            (
                "fields",
                "Vector fields of the configurations, one below the other, offsets last.",
                (matrix.row_join(b) for matrix, b in fields),
            ),
            (
                "rows",
                "Affine functions of the state: gradients, constants last.",
                (self._affine([row]) for row in self.rows),
            ),
            (
                "resets",
                "Affine resets of the state, one below the other, offsets last.",
                map(self._affine, self.resets),
            ),
        )
        kernels = [
            Kernel(name, title, (parameters,), (_stacked(name, matrices),), ())
            for name, title, matrices in tables
        ]
        if self.modes is not None:
            every = [(name, mode) for name, modes in self.modes.items() for mode in modes]
            exponents = (sp.Matrix([[0, mode.frequency]]) for _, mode in every)
            matrices = (
                self._coefficient(name, term) for name, mode in every for term in mode.terms
            )
            kernels.append(
                Kernel(
                    "modes",
                    "Exponents of the modes; coefficients of their functions, offsets last.",
                    (parameters, Argument.vector("spectrum", self.spectrum.symbols)),
                    (_stacked("exponents", exponents), _stacked("coefficients", matrices)),
                    (),
                )
            )
        return tuple(kernels)

    def table(self) -> dict[str, Any]:
        """All that does not depend on parameters, by names and by indices of rows and resets."""
        system = self.system
        modes = self.modes
        configurations = [c.name for c in system.configurations]
        return {
            "modes": None
            if modes is None
            else {
                name: [{"length": m.length, "oscillates": m.oscillates} for m in found]
                for name, found in modes.items()
            },
            "forcing": [[str(c), str(s)] for c, s in system.forcing],
            **({"forcing_row": self.row(system.forcing[0][1])} if system.forcing else {}),
            "coordinates": [[str(x), str(v)] for x, v in self._coordinates()],
            "held": {c.name: self._held(c.dynamics) for c in system.configurations},
            "constraint_rows": {
                c.name: [self.row(function) for function in self._constraints(c)]
                for c in system.configurations
            },
            "boundary_rows": {
                c.name: [self.row(b.function) for b in c.boundaries] for c in system.configurations
            },
            "transitions": [
                {
                    "source": t.source,
                    "boundaries": sorted(t.boundaries),
                    "conditions": [[self.row(c.function), c.along, c.holds] for c in t.conditions],
                    "reset": self.resets.index(self._reset(t.reset)),
                    "target": t.target,
                    **({"order": t.order} if t.order else {}),
                }
                for t in system.transitions
            ],
            "contacts": {
                contact.name: {
                    "forces": {
                        name: self.row(contact.forces[name])
                        for name in configurations
                        if name in contact.forces
                    },
                    "velocity": self.row(contact.velocity),
                    "surface": self.row(contact.surface),
                }
                for contact in system.contacts
            },
            **({} if system.law is None else {"law": self._law(system.law)}),
        }

    def _coordinates(self) -> list[tuple[sp.Symbol, sp.Symbol]]:
        """Pairs of a position and its velocity: x' = v, in some configurations perhaps x' = 0."""
        states = self.system.states
        forced = {state for pair in self.system.forcing for state in pair}
        velocities = [_rates(*c.dynamics.field(states), states) for c in self.system.configurations]
        found = []
        for place, state in enumerate(states):
            rates = {velocity[place] for velocity in velocities}
            moving = rates - {sp.Integer(0)}
            if len(moving) == 1 and moving <= set(states) - forced and state not in forced:
                found.append((state, *moving))
        return found

    def _law(self, law: ContactLaw) -> dict[str, Any]:
        """The table of a contact law; functions and resets are given by their indices."""
        columns = ("relative", "gap", "static", "kinetic", "slipping", "overshooting")
        return {
            "contacts": [
                {"name": contact.name, "friction": contact.friction}
                | dict(zip(columns, map(self.row, contact.functions), strict=True))
                for contact in law.contacts
            ],
            "coupling": [[self.row(entry) for entry in row] for row in law.coupling.tolist()],
            "couples": [[bool(entry != 0) for entry in row] for row in law.coupling.tolist()],
            "regimes": dict(law.regimes),
            "others": dict(law.others),
            "free": {others: list(map(self.row, found)) for others, found in law.free.items()},
            "arrivals": law.arrivals,
            "limits": law.limits,
            "switches": {others: dict(found) for others, found in law.switches.items()},
            "idle": dict(law.idle),
            "resets": {
                target: {own: self.resets.index(self._reset(r)) for own, r in found.items()}
                for target, found in law.resets.items()
            },
        }

    def _reset(self, reset: Mapping[sp.Symbol, sp.Expr]) -> sp.Matrix:
        return sp.ImmutableMatrix([sp.expand(reset.get(s, s)) for s in self.system.states])

    def row(self, function: sp.Expr) -> int:
        """Index of a function among the rows."""
        return self._places[sp.expand(function)]

    @cached_property
    def _places(self) -> dict[sp.Expr, int]:
        return {function: place for place, function in enumerate(self.rows)}

    def _held(self, dynamics: Any) -> list[str]:
        if not isinstance(dynamics, SecondOrder):
            return []
        return [str(self.system.states[i]) for i in sorted(dynamics.held_at(self.system.states))]

    def _constraints(self, configuration: Configuration) -> list[sp.Expr]:
        """Functions that vanish in a configuration; differences of held velocities come first."""
        dynamics, states = configuration.dynamics, self.system.states
        found: list[sp.Expr] = []
        if isinstance(dynamics, SecondOrder):
            size = dynamics.mass.rows
            held = dynamics.held_at(states)
            found += [states[size + i] - held[i] for i in sorted(held)]
        return [*found, *configuration.constraints]

    def _affine(self, functions: Iterable[sp.Expr]) -> sp.Matrix:
        joined = []
        for function in functions:
            gradient, constant = self.system.gradient(function)
            joined.append(gradient.row_join(sp.Matrix([[constant]])))
        return sp.Matrix.vstack(*joined)

    def _coefficient(self, configuration: str, term: sp.Expr) -> sp.Matrix:
        assert self.flows is not None
        flow = self.flows[configuration]
        if term not in flow.basis:
            return sp.zeros(len(self.system.states), len(self.system.states) + 1)
        place = flow.basis.index(term)
        return sp.Matrix(flow.matrices[place]).row_join(sp.Matrix(flow.offsets[place]))


def _rates(matrix: sp.Matrix, offset: sp.Matrix, states: Sequence[sp.Symbol]) -> list[sp.Expr]:
    """Derivative of each state by time in the vector field ``matrix y + offset``."""
    terms: list[list[sp.Expr]] = [[entry] for entry in offset]
    for (i, j), entry in matrix.todok().items():
        terms[i].append(entry * states[j])
    return [sp.Add(*each) for each in terms]


def _stacked(name: str, matrices: Iterable[sp.Matrix]) -> Output:
    return Output.of(name, sp.Matrix.vstack(*matrices))
