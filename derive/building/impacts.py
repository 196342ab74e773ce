"""Impacts on rigid stops by Newton's law, with any mass matrix.

Stops reached together act one after another, in every order where the mass matrix couples them and
no law is named: the orders have to agree. Or they act at once, by Moreau's law: impulses push, and
a stop that takes none is left faster than by its own restitution (Moreau 1988). Stops in lasting
contact that the mass matrix couples to the impact hold, unless their impulse would pull. Contacts
with friction take no impulse; those whose velocity jumps slip or overshoot behind it. What an
impact leaves undecided is a boundary at which the next configuration starts, and follows at once.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import chain, combinations, compress, permutations, product

import sympy as sp

from nonsmooth.derive.building.assembly import Assembly, Regimes, changed
from nonsmooth.derive.declaration.algebra import along, cancel
from nonsmooth.derive.declaration.transition import Condition

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
    velocities = sp.Matrix(assembly.frame.velocities)
    law = assembly.simultaneous_impacts if _interact(assembly, regimes, reached) else "sequence"
    ways: Iterable[tuple[int, Sequence[int], _Impact]]
    if law == "moreau":
        at_once = _at_once(assembly, regimes, reached, velocities)
        ways = ((0, struck, impact) for struck, impact in at_once)
    else:
        orders = [tuple(reached)] if law == "sequence" else list(permutations(reached))
        ways = (
            (number, struck, impact)
            for number, order in enumerate(orders, start=len(orders) > 1)
            for strikes in product((True, False), repeat=len(order))
            if (struck := tuple(compress(order, strikes)))
            for impact in _struck(assembly, regimes, struck, velocities)
        )
    for number, stops, impact in ways:  # friction is still as it was
        for settled in _settled(assembly, regimes, impact, stops, moved, landing):
            yield number, settled


def _closed(assembly: Assembly, regimes: Regimes, stops: Sequence[int]) -> list[int]:
    """The stops in contact that the mass matrix couples to some of the given ones."""
    return [
        i
        for i in assembly.stops
        if regimes[i] == "contact" and any(assembly.coupling(stop, i) != 0 for stop in stops)
    ]


def _interact(assembly: Assembly, regimes: Regimes, stops: Sequence[int]) -> bool:
    """Whether an impact on one of the stops may change the velocity at another one."""
    return any(
        assembly.coupling(i, j) != 0
        or {*_closed(assembly, regimes, [i])} & {*_closed(assembly, regimes, [j])}
        for i, j in combinations(stops, 2)
    )


def _subsets(items: Sequence[int]) -> Iterator[tuple[int, ...]]:
    """All subsets, the largest first."""
    for count in range(len(items), -1, -1):
        yield from combinations(items, count)


def _at_once(
    assembly: Assembly, regimes: Regimes, reached: Sequence[int], velocities: sp.Matrix
) -> Iterator[tuple[Sequence[int], _Impact]]:
    """Impacts by Moreau's law, one for every set of stops that take an impulse."""
    closed = _closed(assembly, regimes, reached)
    # what is in contact has no velocity
    wanted = dict.fromkeys([*reached, *closed], sp.S.Zero)
    for i in reached:
        part = assembly.stops[i]
        wanted[i] = (1 + part.restitution) * (part.direction * velocities)[0]
    for struck in _subsets([*wanted]):
        if not set(struck) & set(reached) or not assembly.independent(struck):
            continue
        spread, resisting = assembly.responses(struck)
        impulses = (resisting * sp.Matrix([wanted[i] for i in struck])).applyfunc(sp.expand)
        touching = _touching(assembly, regimes, next(i for i in struck if i in reached))
        conditions = [Condition(impulse, touching) for impulse in impulses]
        for i in wanted:
            if i not in struck:
                left = (assembly.stops[i].direction * spread * impulses)[0]
                conditions.append(Condition(sp.expand(wanted[i] - left), touching, holds=False))
        following = changed(regimes, {i: "free" for i in closed if i not in struck})
        yield struck, (tuple(conditions), following, (velocities - spread * impulses).expand())


def _struck(
    assembly: Assembly, regimes: Regimes, stops: Sequence[int], velocities: sp.Matrix
) -> Iterator[_Impact]:
    """Impacts on the stops one after another, in the given order."""
    if not stops:
        yield (), regimes, velocities
        return
    stop, *others = stops
    part = assembly.stops[stop]
    approach = along(part.direction, velocities)
    arrives = Condition(approach, _touching(assembly, regimes, stop))
    closed = _closed(assembly, regimes, [stop])
    for kept in _subsets(closed):
        if not assembly.independent((stop, *kept)):
            continue  # they leave the struck mass no way to move
        spread, resisting = assembly.responses((stop, *kept))
        impulses = ((1 + part.restitution) * resisting.col(0)).applyfunc(cancel)
        holds = []
        for push in impulses[1:]:
            sign = assembly.frame.sign(push)
            if sign in (0, -1):
                break
            if sign is None:
                holds.append(Condition(push * approach, arrives.along))
        else:
            following = changed(regimes, {i: "free" for i in closed if i not in kept})
            after, steps = sp.Matrix(velocities), -(spread * impulses).applyfunc(cancel)
            for (place, _), step in steps.todok().items():
                after[place] = sp.expand(after[place] + step * approach)
            for more, final, last in _struck(assembly, following, others, after):
                yield (arrives, *holds, *more), final, last
            if not holds:
                return


def _touching(assembly: Assembly, regimes: Regimes, stop: int) -> str:
    """Name of a configuration in which a stop is in contact.

    The other parts keep their regimes if such a configuration exists.
    """
    wanted = changed(regimes, {stop: "contact"})
    if not assembly.exists(wanted):
        others: dict[int, tuple[str, ...]] = dict.fromkeys(assembly.stops, ("free",))
        others |= {i: part.regimes for i, part in assembly.frictions.items()}
        others[stop] = ("contact",)
        wanted = next(assembly.possible(others.get(i, (r,)) for i, r in enumerate(regimes)))
    return assembly.name(wanted)


def _settled(
    assembly: Assembly,
    before: Regimes,
    impact: _Impact,
    struck: Sequence[int],
    moved: Sequence[int],
    landing: Sequence[int],
) -> Iterator[_Impact]:
    """An impact with every combination of regimes that friction may have behind it.

    The sign of each relative velocity and load that has jumped decides.
    """
    conditions, following, after = impact
    velocities, touching = assembly.frame.velocities, conditions[0].along
    behind = dict(zip(velocities, after, strict=True))
    jump = [sp.expand(new - old) for old, new in behind.items()]
    options: list[list[tuple[str, tuple[Condition, ...]]]] = []
    for i, part in assembly.frictions.items():
        step = sp.expand(along(part.direction, jump))
        load = sp.expand(part.load.xreplace(behind))
        loads = part.lifts and sp.expand(load - part.load) != 0
        lifted = following[i] == "lifted" and not (loads or i in landing)
        if lifted or (step == 0 and not loads and i not in landing):
            options.append([("stick" if i in moved else following[i], ())])
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
        options.append(ways)
    opened = {i: "free" for i in moved if i in assembly.stops and before[i] == "contact"}
    for chosen in product(*options):
        regimes_of = {i: way[0] for i, way in zip(assembly.frictions, chosen, strict=True)}
        regimes = changed(following, regimes_of | opened)
        if assembly.exists(regimes):
            more = chain.from_iterable(condition for _, condition in chosen)
            yield (*conditions, *more), regimes, after


def _sign_behind(assembly: Assembly, relative: sp.Expr, struck: Sequence[int]) -> int | None:
    """Sign of a velocity behind an impact on one stop; None if it is not known.

    It is known where the velocity depends on the approach to that stop alone.
    """
    if len(struck) > 1:
        return None
    part = assembly.stops[struck[0]]
    symbol = assembly.frame.velocities[min(place for _, place in part.direction.todok())]
    weight = part.approach.coeff(symbol)
    value = relative.subs(symbol, (_APPROACH - (part.approach - weight * symbol)) / weight)
    value = sp.expand(value)
    if value.free_symbols & set(assembly.frame.states):
        return None
    return assembly.frame.sign(value)
