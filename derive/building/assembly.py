"""The parts put together: motion, reactions and boundaries of each product of regimes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations, product
from typing import TypeVar

import sympy as sp

from nonsmooth.derive.building.frame import Frame
from nonsmooth.derive.building.parts import FrictionPart, Holder, Part, StopPart, SwitchPart
from nonsmooth.derive.declaration.algebra import along, cancel, inverse, remembered
from nonsmooth.derive.declaration.configuration import Boundary, Configuration, Contact
from nonsmooth.derive.declaration.dynamics import Dynamics, FirstOrder, SecondOrder

Regimes = tuple[str, ...]
_Kind = TypeVar("_Kind", SwitchPart, FrictionPart, StopPart)


def changed(regimes: Regimes, changes: Mapping[int, str]) -> Regimes:
    """The regimes with some of them replaced, by the indices of their parts."""
    return tuple(changes.get(i, regime) for i, regime in enumerate(regimes))


@dataclass(frozen=True, eq=False)
class Assembly:
    """The parts of an oscillator on their frame; a regime of each part is a configuration.

    A part is active in a regime in which it holds its direction at a constant velocity: a
    contact that sticks and a stop in contact. The reactions of active parts follow from the
    constrained motion. Parts are known by their indices.
    """

    frame: Frame
    parts: tuple[Part, ...]
    smooth: sp.Matrix  # n x 1: generalized forces without the parts', affine in the state
    # (cosine, sine) states of each harmonic forcing
    phases: tuple[tuple[sp.Symbol, sp.Symbol], ...]
    rates: tuple[tuple[sp.Symbol, sp.Expr], ...]  # (state, its derivative by time) of these states
    # law of coupled stops that are reached at once: "sequence", "moreau" or None
    simultaneous_impacts: str | None = None

    @cached_property
    def switches(self) -> dict[int, SwitchPart]:
        """The parts whose regimes follow each other independently of the others."""
        return self._of(SwitchPart)

    @cached_property
    def frictions(self) -> dict[int, FrictionPart]:
        """The contacts with friction."""
        return self._of(FrictionPart)

    @cached_property
    def stops(self) -> dict[int, StopPart]:
        """The rigid stops."""
        return self._of(StopPart)

    def _of(self, kind: type[_Kind]) -> dict[int, _Kind]:
        return {i: part for i, part in enumerate(self.parts) if isinstance(part, kind)}

    @cached_property
    def holders(self) -> dict[int, Holder]:
        """Friction contacts and rigid stops, the parts that may be active, in their order."""
        holders: dict[int, Holder] = {**self.frictions, **self.stops}
        return dict(sorted(holders.items()))

    def name(self, regimes: Regimes) -> str:
        """Name of a configuration: its regimes joined by hyphens, or `free` without elements."""
        return "-".join(regimes) or "free"

    def pressed(self, index: int, regimes: Regimes) -> bool:
        """Whether the soft stop that bears a friction contact's normal load is in contact.

        It is true of a contact whose load no stop bears.
        """
        bearer = self.frictions[index].bearer
        return bearer is None or regimes[bearer] == "contact"

    def active(self, regimes: Regimes) -> tuple[int, ...]:
        """The parts that hold their direction."""
        return tuple(i for i, part in self.holders.items() if regimes[i] == part.holding)

    @remembered
    def coupling(self, first: int, second: int) -> sp.Expr:
        """Acceleration along the direction of one part by a unit force along that of another."""
        rows = self.holders[first].direction, self.holders[second].direction
        return sp.cancel((rows[0] * self.frame.inverse * rows[1].T)[0])

    @cached_property
    def coupled(self) -> bool:
        """Whether a contact law decides on the parts that may hold.

        It does if the mass matrix couples friction contacts to each other or to stops. A
        contact whose direction is held by stops alone needs no law with the stops, as it takes
        whatever force there is. There is no law at all if the belt of such a contact may or may
        not have the velocity zero.
        """
        stops = self.rows(self.stops)
        free = {i for i in self.frictions if stops.col_join(self.rows([i])).rank() > stops.rank()}
        stopped = self.frictions.keys() - free
        if any(self.frame.sign(self.frictions[i].speed) is None for i in stopped):
            return False
        return any(
            self.coupling(i, j) != 0
            for i, j in combinations(self.holders, 2)
            if {i, j} <= self.frictions.keys() or {i, j} & free
        )

    def rows(self, indices: Iterable[int]) -> sp.Matrix:
        """Matrix (k, n) of the directions of k parts."""
        size = len(self.frame.positions)
        return sp.Matrix.vstack(sp.zeros(0, size), *(self.holders[i].direction for i in indices))

    @remembered
    def independent(self, indices: tuple[int, ...]) -> bool:
        """Whether the directions of these parts are linearly independent."""
        rows = self.rows(indices)
        columns = sorted({place for _, place in rows.todok()})
        return bool(rows.extract(list(range(rows.rows)), columns).rank() == len(indices))

    @remembered
    def responses(self, indices: tuple[int, ...]) -> tuple[sp.Matrix, sp.Matrix]:
        """Answers to k parts whose directions are independent.

        The accelerations (n x k) by unit forces along their directions, and the forces (k x k)
        that give their directions unit accelerations.
        """
        rows = self.rows(indices)
        spread = self.frame.inverse * rows.T
        inner = (rows * spread).applyfunc(cancel)
        return sp.ImmutableMatrix(spread), inner.inv().applyfunc(cancel)

    @remembered
    def _drift(self, index: int, active: tuple[int, ...]) -> sp.Expr | None:
        """Velocity along a direction, less that of its belt, which the active directions fix.

        None if the direction is independent of them.
        """
        if not active or self.independent((*active, index)):
            return None
        part, rows = self.holders[index], self.rows(active)
        weights = part.direction * rows.T * (rows * rows.T).inv()
        speeds = sp.Matrix([self.holders[i].speed for i in active])
        return sp.cancel((weights * speeds)[0] - part.speed)

    def drift(self, index: int, regimes: Regimes) -> sp.Expr | None:
        """Relative velocity of an inactive part if the active ones fix it, else None."""
        return self._drift(index, self.active(regimes))

    def approach(self, index: int, others: Sequence[int]) -> int | None:
        """Sign of a stop's velocity of approach if other parts' directions fix it, else None.

        The others are taken to move with their velocities of holding. None also means that the
        sign is not shown.
        """
        indices = tuple(i for i in others if i != index)
        while not self.independent(indices):
            indices = indices[:-1]
        drift = self._drift(index, indices)
        return None if drift is None else self.frame.sign(drift)

    @remembered
    def exists(self, regimes: Regimes) -> bool:
        """Whether a combination of regimes is possible.

        The active directions have to be independent, no contact may slip against a velocity
        that is fixed, and a contact that a soft stop presses is lifted where the stop does not
        touch. Where it is pressed it is lifted only if its load may vanish.
        """
        if not self.independent(self.active(regimes)):
            return False
        for i, part in self.frictions.items():
            lifted, side = regimes[i] == "lifted", part.slides(regimes[i])
            if lifted and self.pressed(i, regimes) and not part.lifts:
                return False
            if not lifted and not self.pressed(i, regimes):
                return False
            drift = self.drift(i, regimes) if side else None
            if drift is not None and self.frame.sign(drift) == -side:
                return False
        return True

    def possible(self, options: Iterable[Iterable[str]]) -> Iterator[Regimes]:
        """The combinations that exist with one of the given regimes of each part."""
        return filter(self.exists, product(*options))

    @property
    def products(self) -> tuple[Regimes, ...]:
        """All combinations of regimes that are possible."""
        return tuple(self.possible(part.regimes for part in self.parts))

    def _switched(self, regimes: Regimes) -> sp.Matrix:
        """Generalized forces (n x 1), without those of friction contacts and rigid stops."""
        total = sp.Matrix(self.smooth)
        for i, part in self.switches.items():
            if regimes[i] in part.forces:
                total += part.forces[regimes[i]]
        return total

    def unheld(self, regimes: Regimes) -> tuple[sp.Expr, ...]:
        """Acceleration along each holder's direction, without the forces of all holders."""
        accelerations = self.rows(self.holders) * self.frame.inverse * self._switched(regimes)
        return tuple(map(self.frame.tidy, accelerations))

    def _forces(self, regimes: Regimes) -> sp.Matrix:
        """Generalized forces (n x 1), without the reactions of active parts."""
        total = self._switched(regimes)
        for i, part in self.frictions.items():
            if (force := part.push(regimes[i])) is not None:
                total += force * part.direction.T
        return total.expand()

    def places(self, indices: Iterable[int]) -> dict[int, tuple[int, sp.Expr]] | None:
        """Coordinate and weight of the direction of each part, by its index.

        None if a direction is a combination of coordinates.
        """
        found = {}
        for i in indices:
            weights = self.holders[i].direction.todok()
            if len(weights) != 1:
                return None
            (((_, place), weight),) = weights.items()
            found[i] = (place, weight)
        return found

    @remembered
    def _motion(self, regimes: Regimes) -> tuple[sp.Matrix, dict[int, sp.Expr]]:
        """Accelerations (n x 1), and the reaction of each active part along its direction."""
        frame, active, forces = self.frame, self.active(regimes), self._forces(regimes)
        held = self.places(active)
        if held is None:
            spread, resisting = self.responses(active)
            reaction = -(resisting * (spread.T * forces))
            acceleration = frame.inverse * forces + spread * reaction
            reactions = dict(zip(active, reaction, strict=True))
        else:  # rows and columns of held coordinates are left out
            fixed = [place for place, _ in held.values()]
            free = tuple(j for j in range(len(frame.positions)) if j not in fixed)
            spread = self._spread(free) if fixed else frame.inverse
            acceleration = sp.zeros(len(frame.positions), 1)
            for j, value in zip(free, spread * forces.extract(free, [0]), strict=True):
                acceleration[j] = value
            reactions = {
                i: (along(frame.mass.row(place), acceleration) - forces[place]) / weight
                for i, (place, weight) in held.items()
            }
        return (
            sp.ImmutableMatrix(acceleration.applyfunc(frame.tidy)),
            {i: frame.tidy(f) for i, f in reactions.items()},
        )

    @remembered
    def _spread(self, free: tuple[int, ...]) -> sp.Matrix:
        """Inverse of the mass matrix of the free coordinates, the others being held."""
        return inverse(self.frame.mass.extract(free, free))

    def reaction(self, index: int, regimes: Regimes) -> sp.Expr:
        """Force of an active part on the oscillator along the part's direction."""
        return self._motion(regimes)[1][index]

    def pressure(self, index: int, regimes: Regimes) -> sp.Expr:
        """Force with which a stop in contact pushes the oscillator back."""
        return -self.reaction(index, regimes)

    def excesses(self, index: int, regimes: Regimes) -> tuple[sp.Expr, sp.Expr]:
        """Excess of a sticking contact's force over its limit, forward and backward."""
        limit, force = self.frictions[index].limit, self.reaction(index, regimes)
        return force - limit, -force - limit

    def dynamics(self, regimes: Regimes) -> Dynamics:
        """Motion in one configuration, of second order if that is possible.

        It is not if the system has states beside positions and velocities, or if a combination
        of coordinates is held.
        """
        frame = self.frame
        held = self.places(self.active(regimes))
        if held is not None and not frame.others:
            forces = self._forces(regimes)
            zero = dict.fromkeys(frame.states, sp.S.Zero)
            return SecondOrder(
                frame.mass,
                -frame.matrix_of(forces, frame.positions),
                tuple(forces.xreplace(zero)),
                -frame.matrix_of(forces, frame.velocities),
                {
                    frame.positions[place]: self.holders[i].speed / weight
                    for i, (place, weight) in held.items()
                },
            )
        own = dict(self.rates)
        own |= [part.rates[regimes[i]] for i, part in self.switches.items()
                if regimes[i] in part.rates]  # fmt: skip
        rates = [*frame.velocities, *self._motion(regimes)[0]]
        rates += [own.get(state, sp.S.Zero) for state in frame.others]
        offset = tuple(frame.terms(rate)[1] for rate in rates)
        return FirstOrder(frame.matrix_of(rates, frame.states), offset)

    def configuration(self, regimes: Regimes) -> Configuration:
        """The configuration of a combination of regimes."""
        dynamics = self.dynamics(regimes)
        constraints: list[sp.Expr] = []
        for i in self.active(regimes):
            holder = self.holders[i]
            if isinstance(holder, StopPart):
                constraints.append(holder.gap)
            if isinstance(dynamics, FirstOrder):
                constraints.append(self.frame.velocity(holder.direction) - holder.speed)
        for i, part in self.switches.items():
            if regimes[i] in part.constraints:
                constraints.append(part.constraints[regimes[i]])
        boundaries = tuple(b for i in range(len(self.parts)) for b in self.boundaries(i, regimes))
        return Configuration(self.name(regimes), dynamics, boundaries, tuple(constraints))

    def boundaries(self, index: int, regimes: Regimes) -> tuple[Boundary, ...]:
        """Boundaries at which a part leaves its regime.

        There are none where a stop's velocity is fixed at rest or away from it, or where
        nothing presses a friction contact.
        """
        part, regime = self.parts[index], regimes[index]
        if isinstance(part, SwitchPart):
            return tuple(exit_.boundary for exit_ in part.exits[regime])
        names = part.names(regime)
        if regime == "stick":
            return tuple(map(Boundary, names, self.excesses(index, regimes)))
        if regime == "contact":
            return (Boundary(names[0], -self.pressure(index, regimes)),)
        drift = self.drift(index, regimes)
        sign = None if drift is None else self.frame.sign(drift)
        if isinstance(part, StopPart):
            return () if sign in (0, -1) else (Boundary(names[0], part.gap),)
        if not self.pressed(index, regimes):
            return ()
        losses = part.losses(regime)
        if regime not in part.outcomes or sign is not None:
            return losses
        relative = -part.slides(regime) * part.relative
        return (Boundary(names[0], relative, acts_when="reached"), *losses)

    def contacts(self, products: Sequence[Regimes]) -> tuple[Contact, ...]:
        """Forces of the surroundings on the oscillator, one record a part with a direction."""
        found = []
        for i, part in enumerate(self.parts):
            if part.direction is None:
                continue
            forces = {self.name(regimes): self._push(i, regimes) for regimes in products}
            found.append(
                Contact(
                    f"{part.name}-{part.kind}",
                    self.frame.velocity(part.sign * part.direction),
                    {name: force for name, force in forces.items() if force is not None},
                    part.speed,
                )
            )
        return tuple(found)

    def _push(self, index: int, regimes: Regimes) -> sp.Expr | None:
        """Force of a part on the oscillator along its declared direction; None without one."""
        part = self.parts[index]
        if index in self.active(regimes):
            return part.sign * self.reaction(index, regimes)
        return part.push(regimes[index])
