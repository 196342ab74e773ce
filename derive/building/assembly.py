"""The parts put together: motion, reactions and boundaries of each product of regimes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

import sympy as sp

from nonsmooth.derive.building.frame import Frame, along
from nonsmooth.derive.building.parts import FrictionPart, Part, StopPart, SwitchPart
from nonsmooth.derive.building.remembering import remembered
from nonsmooth.derive.declaration.algebra import inverse
from nonsmooth.derive.declaration.configuration import Boundary, Configuration, Contact
from nonsmooth.derive.declaration.dynamics import Dynamics, FirstOrder, SecondOrder

__all__ = ["Assembly", "Holder", "Regimes"]

Regimes = tuple[str, ...]
Holder = FrictionPart | StopPart


@dataclass(frozen=True, eq=False)
class Assembly:
    """Parts on a frame; a configuration is a tuple of their regimes.

    The parts that hold a direction at a constant velocity, contacts that stick and stops in
    contact, are the active ones; their reactions follow from the constrained motion.

    Attributes
    ----------
    frame : Frame
    parts : tuple of parts
    smooth : n x 1 matrix
        Generalized forces without the parts', affine in the state.
    phases : tuple of (cosine, sine)
        States of the forcing.
    rates : tuple of (state, rate)
        How they move.
    simultaneous_impacts : "sequence", "moreau" or None
        How stops act that are reached at one instant and coupled by the mass matrix.
    """

    frame: Frame
    parts: tuple[Part, ...]
    smooth: sp.Matrix
    phases: tuple[tuple[sp.Symbol, sp.Symbol], ...]
    rates: tuple[tuple[sp.Symbol, sp.Expr], ...]
    simultaneous_impacts: str | None = None

    def name(self, regimes: Regimes) -> str:
        """Name of a configuration; that of a system without elements is `free`."""
        return "-".join(regimes) or "free"

    def holder(self, index: int) -> Holder:
        """The part of that index, which may be active."""
        part = self.parts[index]
        if isinstance(part, SwitchPart):
            raise TypeError(f"{part.name} never holds")
        return part

    def friction(self, index: int) -> FrictionPart:
        """The part of that index, a contact with friction."""
        part = self.parts[index]
        assert isinstance(part, FrictionPart)
        return part

    def stop(self, index: int) -> StopPart:
        """The part of that index, a rigid stop."""
        part = self.parts[index]
        assert isinstance(part, StopPart)
        return part

    @property
    def holders(self) -> tuple[int, ...]:
        """Parts that may be active."""
        return tuple(i for i, p in enumerate(self.parts) if not isinstance(p, SwitchPart))

    def pressed(self, index: int, regimes: Regimes) -> bool:
        """Whether what bears the normal load of a contact with friction touches."""
        bearer = self.friction(index).bearer
        return bearer is None or regimes[bearer] == "contact"

    def active(self, regimes: Regimes) -> tuple[int, ...]:
        """Parts that hold their direction."""
        return tuple(i for i in self.holders if regimes[i] == self.holder(i).holding)

    @remembered
    def coupling(self, first: int, second: int) -> sp.Expr:
        """How much a unit force along one direction accelerates the other."""
        rows = self.holder(first).direction, self.holder(second).direction
        return sp.cancel((rows[0] * self.frame.inverse * rows[1].T)[0])

    def rows(self, indices: Sequence[int]) -> sp.Matrix:
        """Directions of parts, one below the other."""
        size = len(self.frame.positions)
        return sp.Matrix.vstack(sp.zeros(0, size), *(self.holder(i).direction for i in indices))

    @remembered
    def independent(self, indices: tuple[int, ...]) -> bool:
        """Whether no direction of these parts follows from the others."""
        rows = self.rows(indices)
        columns = sorted({place for _, place in rows.todok()})
        return bool(rows.extract(list(range(rows.rows)), columns).rank() == len(indices))

    @remembered
    def _drift(self, index: int, active: tuple[int, ...]) -> sp.Expr | None:
        """Constant velocity of a direction that the active ones fix; relative to a belt."""
        if not active or self.independent((*active, index)):
            return None
        part, rows = self.holder(index), self.rows(active)
        weights = part.direction * rows.T * (rows * rows.T).inv()
        speeds = sp.Matrix([self.holder(i).speed for i in active])
        return sp.cancel((weights * speeds)[0] - part.speed)

    def drift(self, index: int, regimes: Regimes) -> sp.Expr | None:
        """Velocity of an inactive part's direction where the active ones fix it, else None."""
        return self._drift(index, self.active(regimes))

    def approach(self, index: int, others: Sequence[int]) -> int | None:
        """Sign of a stop's velocity of approach, others having theirs; None if open."""
        indices = tuple(i for i in others if i != index)
        while not self.independent(indices):
            indices = indices[:-1]
        drift = self._drift(index, indices)
        return None if drift is None else self.frame.sign(drift)

    @remembered
    def exists(self, regimes: Regimes) -> bool:
        """Whether regimes go together.

        The active directions are independent, none slips against its velocity, and a contact
        that a soft stop presses is lifted where the stop does not touch.
        """
        if not self.independent(self.active(regimes)):
            return False
        for i, (part, regime) in enumerate(zip(self.parts, regimes, strict=True)):
            if not isinstance(part, FrictionPart):
                continue
            if self.pressed(i, regimes):
                if regime == "lifted" and not part.lifts:
                    return False
            elif regime != "lifted":
                return False
            side = part.slides(regime)
            drift = self.drift(i, regimes) if side else None
            if drift is not None and self.frame.sign(drift) == -side:
                return False
        return True

    @remembered
    def impulse(
        self, stop: int, kept: tuple[int, ...]
    ) -> tuple[sp.Matrix, tuple[sp.Expr, ...]] | None:
        """Change of velocities, and impulses of kept contacts, by an impact.

        Both for a unit velocity of approach; None if the kept contacts leave it no way.
        """
        part, every = self.stop(stop), self.frame.inverse
        spread, answers = every * part.direction.T, sp.zeros(0, 1)
        if kept:
            rows = self.rows(kept)
            inner = (rows * every * rows.T).applyfunc(sp.cancel)
            answers = -(inner.inv() * rows * spread).applyfunc(sp.cancel)
            spread = spread + every * rows.T * answers
        effective = sp.cancel((part.direction * spread)[0])
        if effective == 0:
            return None
        impulse = (1 + part.restitution) / effective
        change = (-impulse * spread).applyfunc(sp.cancel)
        return sp.ImmutableMatrix(change), tuple(sp.cancel(a * impulse) for a in answers)

    @property
    def products(self) -> tuple[Regimes, ...]:
        """All products of regimes that go together."""
        return tuple(r for r in product(*(p.regimes for p in self.parts)) if self.exists(r))

    def _switched(self, regimes: Regimes) -> sp.Matrix:
        """Generalized forces but those of contacts and stops."""
        total = sp.Matrix(self.smooth)
        for part, regime in zip(self.parts, regimes, strict=True):
            if isinstance(part, SwitchPart) and regime in part.forces:
                total += part.forces[regime]
        return total

    def unheld(self, regimes: Regimes) -> tuple[sp.Expr, ...]:
        """Accelerations along the holders' directions, less those of the holders' forces."""
        accelerations = self.rows(self.holders) * self.frame.inverse * self._switched(regimes)
        return tuple(self.frame.tidy(sp.expand(each)) for each in accelerations)

    def _forces(self, regimes: Regimes) -> sp.Matrix:
        """Generalized forces but the reactions."""
        total = self._switched(regimes)
        for part, regime in zip(self.parts, regimes, strict=True):
            if isinstance(part, FrictionPart) and (force := part.force(regime)) is not None:
                total += force * part.direction.T
        return total.expand()

    def _held(self, active: Sequence[int]) -> dict[int, tuple[int, sp.Expr]] | None:
        """Coordinate and weight of each active part; None where one holds no coordinate."""
        found = {}
        for i in active:
            weights = self.holder(i).direction.todok()
            if len(weights) != 1:
                return None
            (((_, place), weight),) = weights.items()
            found[i] = (place, weight)
        return found

    @remembered
    def _spread(self, free: tuple[int, ...]) -> sp.Matrix:
        """Inverse of the mass of some coordinates, the others held."""
        return inverse(self.frame.mass.extract(free, free))

    @remembered
    def _motion(self, regimes: Regimes) -> tuple[sp.Matrix, dict[int, sp.Expr]]:
        """Accelerations, and the active parts' reactions along their directions."""
        frame, active, forces = self.frame, self.active(regimes), self._forces(regimes)
        held = self._held(active)
        if held is None:
            rows = self.rows(active)
            spread = frame.inverse * rows.T
            inner = (rows * spread).applyfunc(sp.cancel)
            reaction = -(inner.inv().applyfunc(sp.cancel) * (spread.T * forces))
            acceleration = frame.inverse * (forces + rows.T * reaction)
            reactions = dict(zip(active, reaction, strict=True))
        else:
            fixed = [place for place, _ in held.values()]
            free = [j for j in range(len(frame.positions)) if j not in fixed]
            acceleration = sp.zeros(len(frame.positions), 1)
            if free:
                spread = self._spread(tuple(free)) if fixed else frame.inverse
                for j, value in zip(free, spread * forces.extract(free, [0]), strict=True):
                    acceleration[j] = value
            reactions = {
                i: (along(frame.mass.row(place), acceleration) - forces[place]) / weight
                for i, (place, weight) in held.items()
            }
        acceleration = acceleration.applyfunc(lambda f: frame.tidy(sp.expand(f)))
        return (
            sp.ImmutableMatrix(acceleration),
            {i: frame.tidy(sp.expand(f)) for i, f in reactions.items()},
        )

    def reaction(self, index: int, regimes: Regimes) -> sp.Expr:
        """Force of an active part on the oscillator along its direction."""
        return self._motion(regimes)[1][index]

    def pressure(self, index: int, regimes: Regimes) -> sp.Expr:
        """What a stop in contact pushes with."""
        return -self.reaction(index, regimes)

    def excesses(self, index: int, regimes: Regimes) -> tuple[sp.Expr, sp.Expr]:
        """By how much what holds a contact that sticks exceeds its limit, forward and backward."""
        part, force = self.friction(index), self.reaction(index, regimes)
        return force - part.limit, -force - part.limit

    def dynamics(self, regimes: Regimes) -> Dynamics:
        """Second order where nothing but positions and velocities moves freely or is held."""
        frame, active = self.frame, self.active(regimes)
        held = self._held(active)
        size = len(frame.positions)
        if held is not None and not frame.others:
            forces = self._forces(regimes)
            zero = dict.fromkeys(frame.states, sp.S.Zero)
            return SecondOrder(
                frame.mass,
                -frame.matrix_of(forces, frame.positions),
                tuple(forces.xreplace(zero)),
                -frame.matrix_of(forces, frame.velocities),
                {
                    frame.positions[place]: self.holder(i).speed / weight
                    for i, (place, weight) in held.items()
                },
            )
        own = dict(self.rates)
        for part, regime in zip(self.parts, regimes, strict=True):
            if isinstance(part, SwitchPart) and regime in part.rates:
                state, rate = part.rates[regime]
                own[state] = rate
        rates = [*frame.velocities, *self._motion(regimes)[0]]
        rates += [own.get(state, sp.S.Zero) for state in frame.others]
        assert len(rates) == 2 * size + len(frame.others)
        offset = tuple(frame.terms(rate)[1] for rate in rates)
        return FirstOrder(frame.matrix_of(rates, frame.states), offset)

    def configuration(self, regimes: Regimes) -> Configuration:
        """The configuration of a product of regimes."""
        dynamics = self.dynamics(regimes)
        constraints: list[sp.Expr] = []
        for i in self.active(regimes):
            holder = self.holder(i)
            if isinstance(holder, StopPart):
                constraints.append(holder.gap)
            if isinstance(dynamics, FirstOrder):
                constraints.append(self.frame.velocity(holder.direction) - holder.speed)
        for part, regime in zip(self.parts, regimes, strict=True):
            if isinstance(part, SwitchPart) and regime in part.constraints:
                constraints.append(part.constraints[regime])
        boundaries = tuple(b for i in range(len(self.parts)) for b in self.boundaries(i, regimes))
        return Configuration(self.name(regimes), dynamics, boundaries, tuple(constraints))

    def boundaries(self, index: int, regimes: Regimes) -> tuple[Boundary, ...]:
        """Where a part leaves its regime; none where its velocity cannot change."""
        part, regime = self.parts[index], regimes[index]
        if isinstance(part, SwitchPart):
            return tuple(exit_.boundary for exit_ in part.exits[regime])
        names = part.names(regime)
        if regime == "stick":
            return tuple(map(Boundary, names, self.excesses(index, regimes)))
        if regime == "contact":
            return (Boundary(names[0], -self.pressure(index, regimes)),)
        drift = self.drift(index, regimes)
        if isinstance(part, StopPart):
            fixed = drift is not None and self.frame.sign(drift) in (0, -1)
            return () if fixed else (Boundary(names[0], part.gap),)
        if not self.pressed(index, regimes):
            return ()
        losses = part.losses(regime)
        if regime not in part.outcomes or (
            drift is not None and self.frame.sign(drift) is not None
        ):
            return losses
        sign = -part.slides(regime)
        return (Boundary(names[0], sign * part.relative, acts_when="reached"), *losses)

    def contacts(self, products: Sequence[Regimes]) -> tuple[Contact, ...]:
        """The forces of the surroundings on the oscillator."""
        found = []
        for index, part in enumerate(self.parts):
            if part.direction is None:
                continue
            forces: dict[str, sp.Expr] = {}
            sign, kind, surface = 1, "friction", sp.S.Zero
            for regimes in products:
                regime, name = regimes[index], self.name(regimes)
                if isinstance(part, SwitchPart):
                    if regime in part.pushes:
                        forces[name] = part.pushes[regime]
                elif regime == part.holding:
                    forces[name] = self.reaction(index, regimes)
                elif isinstance(part, FrictionPart) and (force := part.force(regime)) is not None:
                    forces[name] = force
            if isinstance(part, SwitchPart):
                kind = part.kind
            elif isinstance(part, StopPart):
                sign, kind = part.sign, "stop"
                forces = {name: sign * force for name, force in forces.items()}
            else:
                surface = part.speed
            velocity = self.frame.velocity(sign * part.direction)
            found.append(Contact(f"{part.name}-{kind}", velocity, forces, surface))
        return tuple(found)
