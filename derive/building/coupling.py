"""The contact law of an oscillator whose contacts the mass matrix couples."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations, product

import sympy as sp

from nonsmooth.derive.building.assembly import Assembly, Regimes
from nonsmooth.derive.building.parts import Exit, FrictionPart, Part, StopPart, SwitchPart
from nonsmooth.derive.building.pins import pins
from nonsmooth.derive.building.resting import unsettled
from nonsmooth.derive.declaration.contact_law import ContactLaw, LawContact

__all__ = ["contact_law", "coupled"]


def coupled(assembly: Assembly) -> bool:
    """Whether a contact law decides on the parts that may hold.

    It does if the mass matrix couples friction contacts to each other or to stops. A
    contact whose direction is held by stops alone needs no law with the stops, as it takes
    whatever force there is. There is no law at all if the belt of such a contact may or may
    not have the velocity zero.
    """
    rubbing = [i for i in assembly.holders if isinstance(assembly.parts[i], FrictionPart)]
    stops = assembly.rows([i for i in assembly.holders if i not in rubbing])
    stopped = [i for i in rubbing if stops.col_join(assembly.rows([i])).rank() == stops.rank()]
    if any(assembly.frame.sign(assembly.friction(i).speed) is None for i in stopped):
        return False
    return any(
        assembly.coupling(i, j) != 0
        for i, j in combinations(assembly.holders, 2)
        if {i, j} <= {*rubbing} or {i, j} & ({*rubbing} - {*stopped})
    )


def contact_law(assembly: Assembly, products: Sequence[Regimes]) -> ContactLaw | None:
    """The contact law of the parts that may hold; None where each is decided by itself."""
    if not coupled(assembly):
        return None
    holders = assembly.holders
    others = [i for i in range(len(assembly.parts)) if i not in holders]

    def switched(regimes: Regimes) -> str:
        return "-".join(regimes[i] for i in others)

    names = {regimes: assembly.name(regimes) for regimes in products}
    exits = {switched(regimes): _exits(assembly, others, regimes) for regimes in products}
    own: dict[str, Mapping[sp.Symbol, sp.Expr]] = {"": {}}
    for found in exits.values():
        own |= {joined: reset for joined, (_, reset) in found.items()}
    places = {regimes: pins(assembly, assembly.active(regimes), regimes, impact=False)
              for regimes in products}  # fmt: skip
    arrivals, limits = _events(assembly)
    return ContactLaw(
        tuple(_contact(assembly.parts[i], assembly) for i in holders),
        sp.Matrix(len(holders), len(holders),
                  lambda a, b: assembly.coupling(holders[a], holders[b])),
        {name: tuple(regimes[i] for i in holders) for regimes, name in names.items()},
        {name: switched(regimes) for regimes, name in names.items()},
        {switched(regimes): assembly.unheld(regimes) for regimes in products},
        arrivals,
        limits,
        {before: {joined: after for joined, (after, _) in found.items()}
         for before, found in exits.items()},
        {name: tuple(holders.index(i) for i in unsettled(assembly, regimes))
         for regimes, name in names.items()},
        {"": own} | {name: {joined: dict(reset) | places[regimes] for joined, reset in own.items()}
                     for regimes, name in names.items()},
    )  # fmt: skip


def _contact(part: Part, assembly: Assembly) -> LawContact:
    if isinstance(part, StopPart):
        return LawContact(part.name, False, part.approach, part.gap)
    assert isinstance(part, FrictionPart)
    kinetic, slipping, overshooting = (
        sp.expand(force)
        for force in (part.kinetic * part.load, part.force("slip"), part.force("overshoot"))
    )
    return LawContact(
        part.name, True, part.relative, sp.S.Zero, sp.expand(part.limit), kinetic,
        slipping, overshooting,
    )  # fmt: skip


def _events(assembly: Assembly) -> tuple[dict[str, int], dict[str, int]]:
    """Index of a contact by each boundary at which it comes to rest, and by each of its limits."""
    arrivals: dict[str, int] = {}
    limits: dict[str, int] = {}
    for place, index in enumerate(assembly.holders):
        part = assembly.holder(index)
        for regime in part.outcomes:
            found = limits if regime == "stick" else arrivals
            found |= dict.fromkeys(part.names(regime), place)
        if isinstance(part, FrictionPart) and part.lifts:  # those that slide there are listed
            arrivals[f"{part.name}-lands"] = place
    return arrivals, limits


def _exits(
    assembly: Assembly, others: Sequence[int], regimes: Regimes
) -> dict[str, tuple[str, dict[sp.Symbol, sp.Expr]]]:
    """Regimes and reset of the other parts behind each set of their boundaries.

    The key is the set's names, sorted and joined by "+"; the value has the regimes, joined
    by hyphens, and the reset.
    """
    options: list[list[Exit | None]] = []
    for i in others:
        part = assembly.parts[i]
        assert isinstance(part, SwitchPart)
        options.append([None, *part.exits[regimes[i]]])
    found = {}
    for chosen in product(*options):
        taken = [exit_ for exit_ in chosen if exit_ is not None]
        after = [exit_.target if exit_ else regimes[i]
                 for i, exit_ in zip(others, chosen, strict=True)]  # fmt: skip
        reset = {s: e for exit_ in taken for s, e in exit_.reset.items()}
        if taken:
            joined = "+".join(sorted(exit_.boundary.name for exit_ in taken))
            found[joined] = ("-".join(after), reset)
    return found
