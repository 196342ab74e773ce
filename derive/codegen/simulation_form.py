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

from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from itertools import count
from typing import Any

import sympy as sp

from nonsmooth.derive.declaration.algebra import affine_terms, along
from nonsmooth.derive.declaration.dynamics import Dynamics
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.declaration.transition import ContactLaw
from nonsmooth.derive.equations.program import Array, Kernel
from nonsmooth.derive.flows.modal import Flow, Mode, Spectrum
from nonsmooth.derive.symbols import Values

# entries that are not zero by their places in a matrix with the offsets in its last column
_Entries = dict[tuple[int, int], sp.Expr]
_TITLES = {
    "fields": "Vector fields of the configurations, one below the other, offsets last.",
    "rows": "Affine functions of the state: gradients, constants last.",
    "resets": "Affine resets of the state, one below the other, offsets last.",
}


@dataclass(frozen=True)
class SimulationForm:
    """A system, its spectrum and its flows in the form of rows and tables.

    Without flows, where no closed form is known, the runtime computes the modes from the
    fields. The functions in `beside` get rows although nothing else contains them, and the
    motions in `along` fields behind those of the configurations.
    """

    system: System
    spectrum: Spectrum = field(default_factory=Spectrum)
    flows: Mapping[str, Flow] | None = None
    beside: tuple[sp.Expr, ...] = ()
    along: tuple[Dynamics, ...] = ()

    @property
    def rows(self) -> tuple[sp.Expr, ...]:
        """Every affine function of the state that the declaration contains, once each."""
        return tuple(self._indexed[1])

    @property
    def resets(self) -> tuple[sp.Matrix, ...]:
        """Every reset as a column of expressions of the state, once each, the identity first."""
        return tuple(self._indexed[2])

    def table(self) -> dict[str, Any]:
        """All that does not depend on parameters, by names and by indices of rows and resets."""
        return self._indexed[0]

    def row(self, function: sp.Expr) -> int:
        """Index of a function among the rows."""
        return self._indexed[1][sp.expand(function)]

    @cached_property
    def _indexed(self) -> tuple[dict[str, Any], dict[sp.Expr, int], dict[sp.Matrix, int]]:
        """The table, and the indices of rows and resets, in the order in which it names them."""
        system, states = self.system, self.system.states
        rows: dict[sp.Expr, int] = defaultdict(count().__next__)
        resets: dict[sp.Matrix, int] = defaultdict(count().__next__)

        def row(function: sp.Expr) -> int:
            return rows[sp.expand(function)]

        def reset(rules: Values) -> int:
            return resets[sp.ImmutableMatrix([sp.expand(rules.get(s, s)) for s in states])]

        reset({})
        boundaries = {
            c.name: [row(b.function) for b in c.boundaries] for c in system.configurations
        }
        transitions = [
            {
                "source": t.source,
                "boundaries": sorted(t.boundaries),
                "conditions": [[row(c.function), c.along, c.holds] for c in t.conditions],
                "reset": reset(t.reset),
                "target": t.target,
                **({"order": t.order} if t.order else {}),
            }
            for t in system.transitions
        ]
        constraints = {c.name: list(map(row, c.vanishing(states))) for c in system.configurations}
        contacts = {
            contact.name: {
                "forces": {
                    c.name: row(contact.forces[c.name])
                    for c in system.configurations
                    if c.name in contact.forces
                },
                "velocity": row(contact.velocity),
                "surface": row(contact.surface),
            }
            for contact in system.contacts
        }
        law = {} if system.law is None else {"law": _law(system.law, row, reset)}
        # zero where its phase begins anew
        forced = {"forcing_row": row(system.forcing[0][1])} if system.forcing else {}
        for function in self.beside:
            row(function)
        table = {
            "modes": None
            if self.modes is None
            else {
                name: [{"length": m.length, "oscillates": m.oscillates} for m in found]
                for name, found in self.modes.items()
            },
            "forcing": [[str(c), str(s)] for c, s in system.forcing],
            **forced,
            "coordinates": [[str(x), str(v)] for x, v in self._coordinates()],
            "held": {
                c.name: [str(states[i]) for i in c.held(states)] for c in system.configurations
            },
            "constraint_rows": constraints,
            "boundary_rows": boundaries,
            "transitions": transitions,
            "contacts": contacts,
            **law,
        }
        return table, dict(rows), dict(resets)

    @cached_property
    def modes(self) -> dict[str, tuple[Mode, ...]] | None:
        """Modes by configuration; None if one of them has no closed form of that kind."""
        if self.flows is None:
            return None
        found = {name: flow.modes for name, flow in self.flows.items()}
        known = {name: modes for name, modes in found.items() if modes is not None}
        return known if len(known) == len(found) else None

    @property
    def matrices(self) -> dict[str, tuple[int, _Entries]]:
        """Number of rows and entries of the matrices of fields, rows and resets."""
        size, fields = len(self.system.states), dict[tuple[int, int], sp.Expr]()
        motions = (*(c.dynamics for c in self.system.configurations), *self.along)
        for place, dynamics in enumerate(motions):
            matrix, offset = dynamics.field(self.system.states)
            first = place * size
            fields |= {(first + i, j): entry for (i, j), entry in matrix.todok().items()}
            fields |= {(first + i, size): entry for (i, _), entry in offset.todok().items()}
        return {
            "fields": (len(motions) * size, fields),
            "rows": (len(self.rows), self._affine(self.rows)),
            "resets": (
                len(self.resets) * size,
                self._affine(entry for column in self.resets for entry in column),
            ),
        }

    def _affine(self, functions: Iterable[sp.Expr]) -> _Entries:
        """Entries of the matrix of affine functions, one row each."""
        columns = {s: j for j, s in enumerate(self.system.states)}
        found: _Entries = {}
        for place, function in enumerate(functions):
            slopes, constant = affine_terms(function, columns.keys())
            found |= {(place, columns[s]): slope for s, slope in slopes.items() if slope != 0}
            if constant != 0:
                found[place, len(columns)] = constant
        return found

    def kernels(self) -> tuple[Kernel, ...]:
        """Kernels of rows, fields, resets and, where they have a closed form, modes."""
        system = self.system
        parameters = Array.of("parameters", (p.symbol for p in system.parameters))
        matrices, width = self.matrices, len(system.states) + 1
        kernels = []
        for name, title in _TITLES.items():
            rows, entries = matrices[name]
            matrix = sp.Matrix.from_dok(rows, width, entries)
            kernels.append(Kernel.of(name, title, [parameters], {name: matrix}))
        if self.modes is not None:
            every = [(name, mode) for name, modes in self.modes.items() for mode in modes]
            exponents = (sp.Matrix([[0, mode.frequency]]) for _, mode in every)
            coefficients = (
                self._coefficient(name, term) for name, mode in every for term in mode.terms
            )
            kernels.append(
                Kernel.of(
                    "modes",
                    "Exponents of the modes; coefficients of their functions, offsets last.",
                    [parameters, Array.of("spectrum", self.spectrum.symbols)],
                    {
                        "exponents": sp.Matrix.vstack(*exponents),
                        "coefficients": sp.Matrix.vstack(*coefficients),
                    },
                )
            )
        return tuple(kernels)

    def _coordinates(self) -> list[tuple[sp.Symbol, sp.Symbol]]:
        """Pairs of a position and its velocity: x' = v, in some configurations perhaps x' = 0."""
        states = self.system.states
        forced = {state for pair in self.system.forcing for state in pair}
        velocities = [_rates(c.dynamics, states) for c in self.system.configurations]
        found = []
        for place, state in enumerate(states):
            rates = {velocity[place] for velocity in velocities}
            moving = rates - {sp.Integer(0)}
            if len(moving) == 1 and moving <= set(states) - forced and state not in forced:
                found.append((state, *moving))
        return found

    def _coefficient(self, configuration: str, term: sp.Expr) -> sp.Matrix:
        assert self.flows is not None
        flow = self.flows[configuration]
        if term not in flow.basis:
            return sp.zeros(len(self.system.states), len(self.system.states) + 1)
        place = flow.basis.index(term)
        return sp.Matrix(flow.matrices[place]).row_join(sp.Matrix(flow.offsets[place]))


def _rates(dynamics: Dynamics, states: tuple[sp.Symbol, ...]) -> list[sp.Expr]:
    """Derivative of each state by time in a motion."""
    matrix, offset = dynamics.field(states)
    return [along(matrix.row(i), states) + rest for i, rest in enumerate(offset)]


def _law(
    law: ContactLaw,
    row: Callable[[sp.Expr], int],
    reset: Callable[[Values], int],
) -> dict[str, Any]:
    """The table of a contact law; functions and resets are given by their indices."""
    coupling = law.coupling.tolist()
    return vars(law) | {
        "contacts": [
            {name: row(v) if isinstance(v, sp.Expr) else v for name, v in vars(contact).items()}
            for contact in law.contacts
        ],
        "coupling": [list(map(row, entries)) for entries in coupling],
        "couples": [[bool(entry != 0) for entry in entries] for entries in coupling],
        "free": {others: list(map(row, found)) for others, found in law.free.items()},
        "resets": {
            target: {own: reset(rules) for own, rules in found.items()}
            for target, found in law.resets.items()
        },
    }
