"""Impacts on rigid stops by Newton's law, with any mass matrix.

Stops reached together act one after another, in every order where the mass matrix couples them and
no law is named: the orders have to agree. Or they act at once, by Moreau's law: impulses push, and
a stop that takes none is left faster than by its own restitution (Moreau 1988). Stops in lasting
contact that the mass matrix couples to the impact hold, unless their impulse would pull. Contacts
with friction take no impulse; those whose velocity jumps slip or overshoot behind it. What an
impact leaves undecided is a boundary at which the next configuration starts, and follows at once.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain, combinations, permutations, product

import sympy as sp

from nonsmooth.derive.building.assembly import Assembly, Regimes
from nonsmooth.derive.building.frame import along
from nonsmooth.derive.building.parts import FrictionPart, StopPart
from nonsmooth.derive.building.resting import changed
from nonsmooth.derive.declaration.transition import Condition

__all__ = ["impacts"]

_APPROACH = sp.Dummy("approach", positive=True)
_Impact = tuple[tuple[Condition, ...], Regimes, sp.Matrix]


def impacts(
    assembly: Assembly,
    regimes: Regimes,
    reached: Sequence[int],
    moved: Sequence[int],
    landing: Sequence[int],
) -> Iterator[tuple[int, _Impact]]:
    """All impacts on the stops that are reached, in the order in which they are tried.

    Each has its conditions, the regimes and the velocities (n x 1) behind it, and before
    them the number of the order in which the stops act, 0 if there is only one order.
    `regimes` are those before the event, except that switching parts have changed already;
    `reached` are stops at which the mass may arrive, `moved` all parts that have reached a
    boundary, and `landing` friction contacts that regain their normal load.
    """
    velocities, law = sp.Matrix(assembly.frame.velocities), assembly.simultaneous_impacts
    orders = [tuple(reached)]
    if _interact(assembly, regimes, reached):
        if law == "moreau":
            for struck, (conditions, following, after) in _at_once(assembly, regimes, reached):
                for impact in _settled(
                    assembly, conditions, regimes, following, after, struck, moved, landing
                ):
                    yield 0, impact
            return
        if law is None:
            orders = list(permutations(reached))
    for number, order in enumerate(orders, start=len(orders) > 1):
        for strikes in product((True, False), repeat=len(order)):
            struck = [i for i, strike in zip(order, strikes, strict=True) if strike]
            if struck:
                for conditions, following, after in _struck(assembly, regimes, struck, velocities):
                    for impact in _settled(
                        assembly, conditions, regimes, following, after, struck, moved, landing
                    ):
                        yield number, impact


def _closed(assembly: Assembly, regimes: Regimes, stops: Sequence[int]) -> list[int]:
    """Indices of the stops in contact that the mass matrix couples to some of the given ones."""
    return [
        i
        for i in assembly.holders
        if regimes[i] == "contact" and any(assembly.coupling(stop, i) != 0 for stop in stops)
    ]


def _interact(assembly: Assembly, regimes: Regimes, stops: Sequence[int]) -> bool:
    """Whether an impact on one of the stops may change the velocity at another one."""
    return any(
        assembly.coupling(i, j) != 0
        or {*_closed(assembly, regimes, [i])} & {*_closed(assembly, regimes, [j])}
        for i, j in combinations(stops, 2)
    )


def _at_once(
    assembly: Assembly, regimes: Regimes, reached: Sequence[int]
) -> Iterator[tuple[list[int], _Impact]]:
    """Impacts by Moreau's law, one for every set of stops that take an impulse."""
    velocities, inverse = sp.Matrix(assembly.frame.velocities), assembly.frame.inverse
    closed = _closed(assembly, regimes, reached)
    stops = [*reached, *closed]
    # what is in contact has no velocity
    wanted = {
        i: sp.S.Zero
        if i in closed
        else (1 + assembly.stop(i).restitution) * (assembly.stop(i).direction * velocities)[0]
        for i in stops
    }
    for count in range(len(stops), 0, -1):
        for struck in map(list, combinations(stops, count)):
            rows = assembly.rows(struck)
            inner = (rows * inverse * rows.T).applyfunc(sp.cancel)
            if inner.det() == 0 or not set(struck) & set(reached):
                continue
            right = sp.Matrix([wanted[i] for i in struck])
            impulses = (inner.inv() * right).applyfunc(sp.expand)
            touching = _touching(assembly, regimes, next(i for i in struck if i in reached))
            conditions = [Condition(impulse, touching) for impulse in impulses]
            for i in stops:
                if i not in struck:
                    left = (assembly.stop(i).direction * inverse * rows.T * impulses)[0]
                    conditions.append(Condition(sp.expand(wanted[i] - left), touching, holds=False))
            following = regimes
            for i in closed:
                if i not in struck:
                    following = changed(following, i, "free")
            after = (velocities - inverse * rows.T * impulses).expand()
            yield struck, (tuple(conditions), following, after)


def _struck(
    assembly: Assembly, regimes: Regimes, stops: Sequence[int], velocities: sp.Matrix
) -> Iterator[_Impact]:
    """Impacts on the stops one after another, in the given order."""
    if not stops:
        yield (), regimes, velocities
        return
    stop, *others = stops
    part = assembly.stop(stop)
    approach = along(part.direction, velocities)
    arrives = Condition(approach, _touching(assembly, regimes, stop))
    closed = _closed(assembly, regimes, [stop])
    for kept in chain.from_iterable(combinations(closed, k) for k in range(len(closed), -1, -1)):
        found = assembly.impulse(stop, kept)
        if found is None:
            continue
        change, pushes = found
        signs = [assembly.frame.sign(push) for push in pushes]
        if any(sign in (0, -1) for sign in signs):
            continue
        holds = [
            Condition(push * approach, arrives.along)
            for push, sign in zip(pushes, signs, strict=True)
            if sign is None
        ]
        following = regimes
        for i in closed:
            if i not in kept:
                following = changed(following, i, "free")
        after = sp.Matrix(velocities)
        for (place, _), step in change.todok().items():
            after[place] = sp.expand(after[place] + step * approach)
        for more, final, last in _struck(assembly, following, others, after):
            yield (arrives, *holds, *more), final, last
        if not holds:
            return


def _touching(assembly: Assembly, regimes: Regimes, stop: int) -> str:
    """Name of a configuration in which a stop is in contact.

    The other parts keep their regimes if such a configuration exists.
    """
    wanted = changed(regimes, stop, "contact")
    if assembly.exists(wanted):
        return assembly.name(wanted)
    others = [
        ("contact" if i == stop else "free",)
        if isinstance(part, StopPart)
        else part.regimes
        if isinstance(part, FrictionPart)
        else (regimes[i],)
        for i, part in enumerate(assembly.parts)
    ]
    return assembly.name(next(c for c in product(*others) if assembly.exists(c)))


def _settled(
    assembly: Assembly,
    conditions: tuple[Condition, ...],
    before: Regimes,
    following: Regimes,
    after: sp.Matrix,
    struck: Sequence[int],
    moved: Sequence[int],
    landing: Sequence[int],
) -> Iterator[_Impact]:
    """An impact with every combination of regimes that friction may have behind it.

    The sign of each relative velocity and load that has jumped decides.
    """
    velocities = assembly.frame.velocities
    jump = [
        sp.S.Zero if new == old else sp.expand(new - old)
        for new, old in zip(after, velocities, strict=True)
    ]
    behind = dict(zip(velocities, after, strict=True))
    touching = conditions[0].along
    members = [i for i in assembly.holders if isinstance(assembly.parts[i], FrictionPart)]
    options: list[tuple[tuple[str, tuple[Condition, ...]], ...]] = []
    for i in members:
        part = assembly.friction(i)
        step = sp.expand(along(part.direction, jump))
        load = sp.expand(part.load.xreplace(behind))
        loads = part.lifts and sp.expand(load - part.load) != 0
        lifted = following[i] == "lifted" and not (loads or i in landing)
        if lifted or (step == 0 and not loads and i not in landing):
            options.append((("stick" if i in moved else following[i], ()),))
            continue
        # a direction at rest moves on with the jump alone
        relative = sp.expand(step if before[i] == "stick" or i in moved else part.relative + step)
        regimes_behind = {"lifted": -load} if loads else {}
        regimes_behind |= part.sliding(relative, load) if relative != 0 else {}
        ways: list[tuple[str, tuple[Condition, ...]]] = []
        for regime, function in regimes_behind.items():
            sign = _sign_behind(assembly, function, struck)
            if sign == 1:
                ways.append((regime, ()))
                break
            if sign != -1:
                ways.append((regime, (Condition(function, touching),)))
        else:
            ways.append(("stick", ()))
        options.append(tuple(ways))
    for chosen in product(*options):
        regimes, more = following, conditions
        for i, (regime, condition) in zip(members, chosen, strict=True):
            regimes, more = changed(regimes, i, regime), more + condition
        for i in moved:
            if before[i] == "contact" and isinstance(assembly.parts[i], StopPart):
                regimes = changed(regimes, i, "free")
        if not assembly.exists(regimes):
            continue
        yield more, regimes, after


def _sign_behind(assembly: Assembly, relative: sp.Expr, struck: Sequence[int]) -> int | None:
    """Sign of a velocity behind an impact on one stop; None if it is not known.

    It is known where the velocity depends on the approach to that stop alone.
    """
    if len(struck) > 1:
        return None
    part = assembly.stop(struck[0])
    first = next(j for j, weight in enumerate(part.direction) if weight != 0)
    symbol = assembly.frame.velocities[first]
    others = part.approach.coeff(symbol)
    value = sp.expand(
        relative.subs(symbol, (_APPROACH - (part.approach - others * symbol)) / others)
    )
    if value.free_symbols & set(assembly.frame.states):
        return None
    return assembly.frame.sign(value)
