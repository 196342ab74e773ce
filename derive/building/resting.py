"""What contacts and stops do that are at rest: they slide, hold, or let go.

Parts that the mass matrix couples make a cluster and are decided together, as the small
complementarity problem that they are: the next regimes are the first, those with the most
active parts leading, whose forces keep their limits and whose motions go their way. Clusters
follow one another; parts that are still undecided hold meanwhile.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import product

from nonsmooth.derive.building.assembly import Assembly, Regimes
from nonsmooth.derive.building.parts import FrictionPart, StopPart
from nonsmooth.derive.declaration.transition import Condition

__all__ = ["Choice", "at_rest", "changed", "unsettled"]

# conditions, and the regimes that they lead to
Choice = tuple[tuple[Condition, ...], Regimes]


def changed(regimes: Regimes, index: int, regime: str) -> Regimes:
    """The regimes with one of them replaced."""
    return (*regimes[:index], regime, *regimes[index + 1 :])


def unsettled(assembly: Assembly, regimes: Regimes) -> tuple[int, ...]:
    """Indices of friction contacts whose sliding regime is nominal.

    Stops hold the direction of such a contact at a velocity that is zero relative to the
    belt, or may be zero.
    """
    found = []
    for i in assembly.holders:
        if isinstance(assembly.parts[i], FrictionPart) and regimes[i] in ("slip", "overshoot"):
            drift = assembly.drift(i, regimes)
            if drift is not None and assembly.frame.sign(drift) in (0, None):
                found.append(i)
    return tuple(found)


def at_rest(
    assembly: Assembly, regimes: Regimes, moved: Iterable[int], resting: Iterable[int]
) -> tuple[Choice, ...]:
    """All ways out of an event for the parts at rest, in the order in which they are tried.

    Each is a tuple of conditions and the regimes to which they lead. `regimes` are those
    before the event, except that switching parts have changed already; `moved` have reached
    a boundary, and `resting` are at rest although their regime is one of sliding.
    """
    moved = tuple(moved)
    clusters = _clusters(assembly, moved, {*assembly.active(regimes), *resting})
    return tuple(_decided(assembly, clusters, regimes, moved))


def _clusters(
    assembly: Assembly, moved: Sequence[int], others: Iterable[int]
) -> list[tuple[int, ...]]:
    """Clusters of indices: moved parts with those coupled to them, directly or through others."""
    left, clusters = sorted({*moved, *others}), []
    while left:
        cluster = [left.pop(0)]
        for member in cluster:
            near = [i for i in left if assembly.coupling(member, i) != 0]
            cluster += near
            left = [i for i in left if i not in near]
        if any(i in moved for i in cluster):
            clusters.append(tuple(sorted(cluster)))
    return clusters


def _decided(
    assembly: Assembly, clusters: Sequence[tuple[int, ...]], regimes: Regimes, moved: Sequence[int]
) -> Iterator[Choice]:
    if not clusters:
        yield (), regimes
        return
    (cluster, *rest), meanwhile = clusters, regimes
    for i in (i for later in rest for i in later if i in moved):
        holding = changed(meanwhile, i, assembly.holder(i).holding)
        meanwhile = holding if assembly.exists(holding) else meanwhile
    for conditions, chosen in _choices(assembly, cluster, meanwhile):
        following = regimes
        for i in range(len(regimes)):
            if i in cluster:
                following = changed(following, i, chosen[i])
        for more, final in _decided(assembly, rest, following, moved):
            yield conditions + more, final


def _choices(assembly: Assembly, cluster: tuple[int, ...], regimes: Regimes) -> Iterator[Choice]:
    if len(cluster) > 1:
        yield from _complementary(assembly, cluster, regimes)
        return
    (index,) = cluster
    part = assembly.holder(index)
    if regimes[index] == "contact":  # what would have to pull lets go
        yield (), changed(regimes, index, "free")
        return
    holding = changed(regimes, index, part.holding)
    along, possible = assembly.name(holding), assembly.exists(holding)
    if isinstance(part, StopPart):
        if possible:
            yield (Condition(assembly.pressure(index, holding), along),), holding
        yield (), regimes
    elif possible:
        forward, backward = assembly.excesses(index, holding)
        if forward != backward:  # there is a force to be held
            yield (Condition(forward, along),), changed(regimes, index, "slip")
            yield (Condition(backward, along),), changed(regimes, index, "overshoot")
        yield (), holding


def _complementary(
    assembly: Assembly, cluster: tuple[int, ...], regimes: Regimes
) -> Iterator[Choice]:
    """Every possible combination of regimes of a cluster, with the conditions for its motion.

    Combinations with more active parts come first.
    """
    combinations = []
    for regimes_of in product(*(assembly.holder(i).outcomes for i in cluster)):
        candidate = regimes
        for i, regime in zip(cluster, regimes_of, strict=True):
            candidate = changed(candidate, i, regime)
        if assembly.exists(candidate):
            combinations.append(candidate)
    for candidate in sorted(combinations, key=lambda c: -len(assembly.active(c))):
        along = assembly.name(candidate)
        conditions = [c for i in cluster for c in _consistent(assembly, i, candidate, along)]
        yield tuple(conditions), candidate


def _consistent(
    assembly: Assembly, index: int, regimes: Regimes, along: str
) -> tuple[Condition, ...]:
    """Conditions under which one part of a cluster keeps its regime in a combination."""
    part, regime = assembly.holder(index), regimes[index]
    if isinstance(part, StopPart):
        if regime == "contact":
            return (Condition(-assembly.pressure(index, regimes), along, holds=False),)
        if assembly.drift(index, regimes) == 0:
            return ()
        return (Condition(-part.gap, along),)
    if regime == "stick":
        excesses = assembly.excesses(index, regimes)
        return tuple(Condition(excess, along, holds=False) for excess in excesses)
    if assembly.drift(index, regimes) is not None:
        return ()  # held by a stop, it takes whatever force; its side does not matter
    return (Condition(-part.relative if regime == "slip" else part.relative, along),)
