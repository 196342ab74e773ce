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
    """The parts of an oscillator on their frame; a regime of each part is a configuration.

    A part is active in a regime in which it holds its direction at a constant velocity: a
    contact that sticks and a stop in contact. The reactions of active parts follow from the
    constrained motion.
    """

    frame: Frame
    parts: tuple[Part, ...]
    smooth: sp.Matrix  # n x 1: generalized forces without the parts', affine in the state
    # (cosine, sine) states of each harmonic forcing
    phases: tuple[tuple[sp.Symbol, sp.Symbol], ...]
    rates: tuple[tuple[sp.Symbol, sp.Expr], ...]  # (state, its derivative by time) of these states
    # law of coupled stops that are reached at once: "sequence", "moreau" or None
    simultaneous_impacts: str | None = None

    def name(self, regimes: Regimes) -> str:
        """Name of a configuration: its regimes joined by hyphens, or `free` without elements."""
        return "-".join(regimes) or "free"

    def holder(self, index: int) -> Holder:
        """The part of that index, which must be friction or a rigid stop."""
        part = self.parts[index]
        if isinstance(part, SwitchPart):
            raise TypeError(f"{part.name} never holds")
        return part

    def friction(self, index: int) -> FrictionPart:
        """The part of that index, which must be a contact with friction."""
        part = self.parts[index]
        assert isinstance(part, FrictionPart)
        return part

    def stop(self, index: int) -> StopPart:
        """The part of that index, which must be a rigid stop."""
        part = self.parts[index]
        assert isinstance(part, StopPart)
        return part

    @property
    def holders(self) -> tuple[int, ...]:
        """Indices of friction contacts and rigid stops, the parts that may be active."""
        return tuple(i for i, p in enumerate(self.parts) if not isinstance(p, SwitchPart))

    def pressed(self, index: int, regimes: Regimes) -> bool:
        """Whether the soft stop that bears a friction contact's normal load is in contact.

        It is true of a contact whose load no stop bears.
        """
        bearer = self.friction(index).bearer
        return bearer is None or regimes[bearer] == "contact"

    def active(self, regimes: Regimes) -> tuple[int, ...]:
        """Indices of the parts that hold their direction."""
        return tuple(i for i in self.holders if regimes[i] == self.holder(i).holding)

    @remembered
    def coupling(self, first: int, second: int) -> sp.Expr:
        """Acceleration along the direction of one part by a unit force along that of another."""
        rows = self.holder(first).direction, self.holder(second).direction
        return sp.cancel((rows[0] * self.frame.inverse * rows[1].T)[0])

    def rows(self, indices: Sequence[int]) -> sp.Matrix:
        """Matrix (k, n) of the directions of k parts."""
        size = len(self.frame.positions)
        return sp.Matrix.vstack(sp.zeros(0, size), *(self.holder(i).direction for i in indices))

    @remembered
    def independent(self, indices: tuple[int, ...]) -> bool:
        """Whether the directions of these parts are linearly independent."""
        rows = self.rows(indices)
        columns = sorted({place for _, place in rows.todok()})
        return bool(rows.extract(list(range(rows.rows)), columns).rank() == len(indices))

    @remembered
    def _drift(self, index: int, active: tuple[int, ...]) -> sp.Expr | None:
        """Velocity along a direction, less that of its belt, which the active directions fix.

        None if the direction is independent of them.
        """
        if not active or self.independent((*active, index)):
            return None
        part, rows = self.holder(index), self.rows(active)
        weights = part.direction * rows.T * (rows * rows.T).inv()
        speeds = sp.Matrix([self.holder(i).speed for i in active])
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
        """Change of velocities (n x 1) by an impact, and the impulse of each kept stop.

        Both are for a unit velocity of approach. None if the kept stops leave the struck mass
        no way to move.
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
        """All combinations of regimes that are possible."""
        return tuple(r for r in product(*(p.regimes for p in self.parts)) if self.exists(r))

    def _switched(self, regimes: Regimes) -> sp.Matrix:
        """Generalized forces (n x 1), without those of friction contacts and rigid stops."""
        total = sp.Matrix(self.smooth)
        for part, regime in zip(self.parts, regimes, strict=True):
            if isinstance(part, SwitchPart) and regime in part.forces:
                total += part.forces[regime]
        return total

    def unheld(self, regimes: Regimes) -> tuple[sp.Expr, ...]:
        """Acceleration along each holder's direction, without the forces of all holders."""
        accelerations = self.rows(self.holders) * self.frame.inverse * self._switched(regimes)
        return tuple(self.frame.tidy(sp.expand(each)) for each in accelerations)

    def _forces(self, regimes: Regimes) -> sp.Matrix:
        """Generalized forces (n x 1), without the reactions of active parts."""
        total = self._switched(regimes)
        for part, regime in zip(self.parts, regimes, strict=True):
            if isinstance(part, FrictionPart) and (force := part.force(regime)) is not None:
                total += force * part.direction.T
        return total.expand()

    def _held(self, active: Sequence[int]) -> dict[int, tuple[int, sp.Expr]] | None:
        """Coordinate and weight of each active part, by its index.

        None if a part holds a combination of coordinates.
        """
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
        """Inverse of the mass matrix of the free coordinates, the others being held."""
        return inverse(self.frame.mass.extract(free, free))

    @remembered
    def _motion(self, regimes: Regimes) -> tuple[sp.Matrix, dict[int, sp.Expr]]:
        """Accelerations (n x 1), and the reaction of each active part along its direction."""
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
        """Force of an active part on the oscillator along the part's direction."""
        return self._motion(regimes)[1][index]

    def pressure(self, index: int, regimes: Regimes) -> sp.Expr:
        """Force with which a stop in contact pushes the oscillator back."""
        return -self.reaction(index, regimes)

    def excesses(self, index: int, regimes: Regimes) -> tuple[sp.Expr, sp.Expr]:
        """Excess of a sticking contact's force over its limit, forward and backward."""
        part, force = self.friction(index), self.reaction(index, regimes)
        return force - part.limit, -force - part.limit

    def dynamics(self, regimes: Regimes) -> Dynamics:
        """Motion in one configuration, of second order if that is possible.

        It is not if the system has states beside positions and velocities, or if a combination
        of coordinates is held.
        """
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
        """The configuration of a combination of regimes."""
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
        """Forces of the surroundings on the oscillator, one record a part with a direction."""
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
