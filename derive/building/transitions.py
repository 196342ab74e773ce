"""What happens at every set of boundaries that parts can reach at one instant.

Of contacts that the mass matrix couples one law decides, as data for the runtime.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from itertools import product

import sympy as sp

from nonsmooth.derive.building.assembly import Assembly, Regimes, changed
from nonsmooth.derive.building.impacts import impacts
from nonsmooth.derive.building.parts import FrictionPart, Holder, StopPart
from nonsmooth.derive.building.resting import at_rest, landed, loaded, pins, still, unsettled
from nonsmooth.derive.declaration.transition import ContactLaw, LawContact, Transition
from nonsmooth.derive.symbols import Values


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


def contact_law(assembly: Assembly, products: Sequence[Regimes]) -> ContactLaw | None:
    """The contact law of the parts that may hold; None where each is decided by itself."""
    if not assembly.coupled:
        return None
    holders = list(assembly.holders)
    names = {regimes: assembly.name(regimes) for regimes in products}
    others = {regimes: "-".join(regimes[i] for i in assembly.switches) for regimes in products}
    exits = {others[regimes]: _exits(assembly, regimes) for regimes in products}
    own: dict[str, Values] = {"": {}}
    for found in exits.values():
        own |= {joined: reset for joined, (_, reset) in found.items()}
    places = {regimes: pins(assembly, assembly.active(regimes), regimes, impact=False)
              for regimes in products}  # fmt: skip
    arrivals, limits = _events(assembly)
    return ContactLaw(
        tuple(map(_contact, assembly.holders.values())),
        sp.Matrix(len(holders), len(holders),
                  lambda a, b: assembly.coupling(holders[a], holders[b])),
        {name: tuple(regimes[i] for i in holders) for regimes, name in names.items()},
        {name: others[regimes] for regimes, name in names.items()},
        {others[regimes]: assembly.unheld(regimes) for regimes in products},
        arrivals,
        limits,
        {before: {joined: after for joined, (after, _) in found.items()}
         for before, found in exits.items()},
        {name: tuple(map(holders.index, unsettled(assembly, regimes)))
         for regimes, name in names.items()},
        {"": own} | {name: {joined: dict(reset) | places[regimes] for joined, reset in own.items()}
                     for regimes, name in names.items()},
    )  # fmt: skip


def _contact(part: Holder) -> LawContact:
    if isinstance(part, StopPart):
        return LawContact(part.name, False, part.approach, part.gap)
    forces = (part.limit, part.kinetic * part.load, part.push("slip"), part.push("overshoot"))
    return LawContact(part.name, True, part.relative, sp.S.Zero, *map(sp.expand, forces))


def _events(assembly: Assembly) -> tuple[dict[str, int], dict[str, int]]:
    """Index of a contact by each boundary at which it comes to rest, and by each of its limits."""
    arrivals: dict[str, int] = {}
    limits: dict[str, int] = {}
    for place, part in enumerate(assembly.holders.values()):
        for regime in part.outcomes:
            found = limits if regime == "stick" else arrivals
            found |= dict.fromkeys(part.names(regime), place)
        if isinstance(part, FrictionPart) and part.lifts:  # those that slide there are listed
            arrivals[f"{part.name}-lands"] = place
    return arrivals, limits


def _exits(assembly: Assembly, regimes: Regimes) -> dict[str, tuple[str, dict[sp.Symbol, sp.Expr]]]:
    """Regimes and reset of the switching parts behind each set of their boundaries.

    The key is the set's names, sorted and joined by "+"; the value has the regimes, joined
    by hyphens, and the reset.
    """
    switches = assembly.switches
    options = ([None, *part.exits[regimes[i]]] for i, part in switches.items())
    found = {}
    for chosen in product(*options):
        taken = [exit_ for exit_ in chosen if exit_ is not None]
        if taken:
            after = (exit_.target if exit_ else regimes[i]
                     for i, exit_ in zip(switches, chosen, strict=True))  # fmt: skip
            joined = "+".join(sorted(exit_.boundary.name for exit_ in taken))
            reset = {s: e for exit_ in taken for s, e in exit_.reset.items()}
            found[joined] = ("-".join(after), reset)
    return found
