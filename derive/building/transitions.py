"""What happens at every set of boundaries that parts can reach at one instant."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from itertools import product

import sympy as sp

from nonsmooth.derive.building.assembly import Assembly, Regimes
from nonsmooth.derive.building.coupling import coupled
from nonsmooth.derive.building.impacts import impacts
from nonsmooth.derive.building.loads import landed, loaded
from nonsmooth.derive.building.parts import FrictionPart, StopPart, SwitchPart, exit_of
from nonsmooth.derive.building.pins import pins
from nonsmooth.derive.building.resting import at_rest, changed, unsettled
from nonsmooth.derive.declaration.transition import Condition, Transition

__all__ = ["transitions_alone", "transitions_at", "transitions_from"]


def transitions_from(assembly: Assembly, regimes: Regimes) -> Iterator[Transition]:
    """The transitions for every set of boundaries that a configuration reaches at one instant."""
    events = [[None, *_reachable(assembly, i, regimes)] for i in range(len(assembly.parts))]
    for sets in product(*events):
        reached = {i: names for i, names in enumerate(sets) if names is not None}
        if reached and not _exclusive(assembly, regimes, reached):
            yield from _event(assembly, regimes, reached)


def transitions_alone(assembly: Assembly, regimes: Regimes) -> Iterator[Transition]:
    """The transitions for every set of boundaries that one part reaches alone."""
    for i in range(len(assembly.parts)):
        for names in _reachable(assembly, i, regimes):
            if not _exclusive(assembly, regimes, {i: names}):
                yield from _event(assembly, regimes, {i: names})


def transitions_at(
    assembly: Assembly, regimes: Regimes, boundaries: Collection[str]
) -> Iterator[Transition]:
    """The transitions for one set of boundaries that are reached at one instant."""
    reached: dict[int, frozenset[str]] = {}
    left = frozenset(boundaries)
    for i in range(len(assembly.parts)):
        for names in _reachable(assembly, i, regimes):
            if names <= left and len(names) > len(reached.get(i, ())):
                reached[i] = names
    if frozenset[str]().union(*reached.values()) == left and not _exclusive(
        assembly, regimes, reached
    ):
        yield from _event(assembly, regimes, reached)


def _reachable(assembly: Assembly, index: int, regimes: Regimes) -> list[frozenset[str]]:
    """Sets of boundaries that one part reaches at one instant.

    Each boundary is a set of its own; all those of a friction contact form one more if its
    load may vanish, where they meet.
    """
    part = assembly.parts[index]
    names = [b.name for b in assembly.boundaries(index, regimes)]
    found = [frozenset({name}) for name in names]
    if len(names) > 1 and isinstance(part, FrictionPart) and part.loses_load:
        found.append(frozenset(names))
    return found


def _exclusive(assembly: Assembly, regimes: Regimes, reached: Mapping[int, frozenset[str]]) -> bool:
    """Whether the boundaries cannot be reached together.

    That holds for two stops whose directions depend on each other, and for boundaries of a
    friction contact that meet without a load while the stop that bears it stays in contact.
    """
    for i, names in reached.items():
        if len(names) > 1:
            part = assembly.friction(i)
            if not part.lifts and part.bearer not in reached:
                return True
    stops = [i for i in reached if isinstance(assembly.parts[i], StopPart) and regimes[i] == "free"]
    return not assembly.independent(tuple(stops))


def _event(
    assembly: Assembly, source: Regimes, reached: Mapping[int, frozenset[str]]
) -> Iterator[Transition]:
    """The transitions for one set of boundaries: impacts first, then those of parts at rest."""
    regimes, own = source, dict[sp.Symbol, sp.Expr]()
    for i, boundaries in reached.items():
        part = assembly.parts[i]
        if isinstance(part, SwitchPart):
            exit_ = exit_of(part, source[i], *boundaries)
            regimes, own = changed(regimes, i, exit_.target), own | dict(exit_.reset)
    regimes, landing = loaded(assembly, source, regimes, reached)
    moved = [i for i in reached if i in assembly.holders and regimes[i] == source[i]]
    moved = [i for i in moved if i not in landing]
    stops = [i for i in moved if source[i] == "free"]
    leads, names = assembly.name(source), frozenset[str]().union(*reached.values())
    frame = assembly.frame
    known_velocities = [
        *assembly.active(source),
        *(i for i in moved if isinstance(assembly.parts[i], FrictionPart)),
    ]
    approaches = [assembly.approach(i, known_velocities) for i in stops]
    if -1 in approaches:  # a mass that is carried away does not arrive
        return
    for order, (conditions, target, after) in impacts(assembly, regimes, stops, moved, landing):
        reset = own | {s: e for s, e in zip(frame.velocities, after, strict=True) if s != e}
        begun = [i for i in moved if target[i] == "stick" != source[i]]
        reset |= pins(assembly, begun, target, impact=True)
        yield Transition(leads, names, assembly.name(target), conditions, reset, order)
    if 1 in approaches:
        return
    for sides, settled, rest in landed(assembly, regimes, landing):
        resting = [*moved, *rest]
        if resting and coupled(assembly):  # the law decides
            continue
        doubtful = [
            i
            for i in unsettled(assembly, source)
            if resting and i not in moved and settled[i] == source[i]
        ]
        unknown = [i for i in doubtful if frame.sign(assembly.drift(i, source)) is None]
        still = tuple(
            Condition(sign * assembly.friction(i).relative, leads, holds=False)
            for i in unknown
            for sign in (-1, 1)
        )
        for conditions, target in at_rest(assembly, settled, resting, doubtful):
            every = sides + still + conditions
            yield _resting(assembly, source, leads, names, target, every, own, resting)
        if unknown:
            known = [i for i in doubtful if i not in unknown]
            for conditions, target in at_rest(assembly, settled, resting, known):
                every = sides + conditions
                yield _resting(assembly, source, leads, names, target, every, own, resting)


def _resting(
    assembly: Assembly,
    source: Regimes,
    leads: str,
    names: frozenset[str],
    target: Regimes,
    conditions: tuple[Condition, ...],
    own: Mapping[sp.Symbol, sp.Expr],
    moved: Sequence[int],
) -> Transition:
    """A transition without impact, whose reset puts parts that begin to hold in their place."""
    begun = [i for i in assembly.active(target) if i in moved or source[i] != target[i]]
    reset = dict(own) | pins(assembly, begun, target, impact=False)
    return Transition(leads, names, assembly.name(target), conditions, reset)
