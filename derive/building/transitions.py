"""What happens at every set of boundaries that parts can reach at one instant."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from itertools import product

from nonsmooth.derive.building.assembly import Assembly, Regimes, changed
from nonsmooth.derive.building.impacts import impacts
from nonsmooth.derive.building.resting import at_rest, landed, loaded, pins, still, unsettled
from nonsmooth.derive.declaration.transition import Transition

__all__ = ["transitions_alone", "transitions_at", "transitions_from"]


def transitions_from(assembly: Assembly, regimes: Regimes) -> Iterator[Transition]:
    """The transitions for every set of boundaries that a configuration reaches at one instant."""
    events = [[None, *_reachable(assembly, i, regimes)] for i in range(len(assembly.parts))]
    for sets in product(*events):
        reached = {i: names for i, names in enumerate(sets) if names is not None}
        yield from _event(assembly, regimes, reached)


def transitions_alone(assembly: Assembly, regimes: Regimes) -> Iterator[Transition]:
    """The transitions for every set of boundaries that one part reaches alone."""
    for i in range(len(assembly.parts)):
        for names in _reachable(assembly, i, regimes):
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
    if frozenset[str]().union(*reached.values()) == left:
        yield from _event(assembly, regimes, reached)


def _reachable(assembly: Assembly, index: int, regimes: Regimes) -> list[frozenset[str]]:
    """Sets of boundaries that one part reaches at one instant.

    Each boundary is a set of its own; all those of a friction contact form one more if its
    load may vanish, where they meet.
    """
    names = [b.name for b in assembly.boundaries(index, regimes)]
    found = [frozenset({name}) for name in names]
    if len(names) > 1 and index in assembly.frictions and assembly.frictions[index].loses_load:
        found.append(frozenset(names))
    return found


def _exclusive(assembly: Assembly, regimes: Regimes, reached: Mapping[int, frozenset[str]]) -> bool:
    """Whether the boundaries cannot be reached together.

    That holds for two stops whose directions depend on each other, and for boundaries of a
    friction contact that meet without a load while the stop that bears it stays in contact.
    """
    for i, names in reached.items():
        if len(names) > 1:
            part = assembly.frictions[i]
            if not part.lifts and part.bearer not in reached:
                return True
    stops = (i for i in reached if i in assembly.stops and regimes[i] == "free")
    return not assembly.independent(tuple(stops))


def _event(
    assembly: Assembly, source: Regimes, reached: Mapping[int, frozenset[str]]
) -> Iterator[Transition]:
    """The transitions for one set of boundaries: impacts first, then those of parts at rest."""
    if not reached or _exclusive(assembly, source, reached):
        return
    taken = {
        i: exit_
        for i, names in reached.items()
        if i in assembly.switches
        for exit_ in assembly.switches[i].exits[source[i]]
        if exit_.boundary.name in names
    }
    own = {state: image for exit_ in taken.values() for state, image in exit_.reset.items()}
    regimes = changed(source, {i: exit_.target for i, exit_ in taken.items()})
    regimes, landing = loaded(assembly, source, regimes, reached)
    moved = [
        i for i in reached if i in assembly.holders and regimes[i] == source[i] and i not in landing
    ]
    stops = [i for i in moved if source[i] == "free"]
    leads, names = assembly.name(source), frozenset[str]().union(*reached.values())
    frame = assembly.frame
    known_velocities = [*assembly.active(source), *(i for i in moved if i in assembly.frictions)]
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
        if resting and assembly.coupled:  # the law decides
            continue
        doubtful, unknown = [], []
        for i in unsettled(assembly, source) if resting else ():
            if i not in moved and settled[i] == source[i]:
                doubtful.append(i)
                if frame.sign(assembly.drift(i, source)) is None:
                    unknown.append(i)
        ways = [(doubtful, [c for i in unknown for c in still(assembly.frictions[i], leads)])]
        if unknown:
            ways.append(([i for i in doubtful if i not in unknown], []))
        for nominal, held in ways:
            for conditions, target in at_rest(assembly, settled, resting, nominal):
                active = assembly.active(target)
                begun = [i for i in active if i in resting or source[i] != target[i]]
                reset = own | pins(assembly, begun, target, impact=False)
                every = (*sides, *held, *conditions)
                yield Transition(leads, names, assembly.name(target), every, reset)
