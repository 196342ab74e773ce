"""The contact law of an oscillator whose contacts the mass matrix couples."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import product

import sympy as sp

from nonsmooth.derive.building.assembly import Assembly, Regimes
from nonsmooth.derive.building.parts import FrictionPart, Holder, StopPart
from nonsmooth.derive.building.resting import pins, unsettled
from nonsmooth.derive.declaration.transition import ContactLaw, LawContact

__all__ = ["contact_law"]


def contact_law(assembly: Assembly, products: Sequence[Regimes]) -> ContactLaw | None:
    """The contact law of the parts that may hold; None where each is decided by itself."""
    if not assembly.coupled:
        return None
    holders = list(assembly.holders)
    names = {regimes: assembly.name(regimes) for regimes in products}
    others = {regimes: "-".join(regimes[i] for i in assembly.switches) for regimes in products}
    exits = {others[regimes]: _exits(assembly, regimes) for regimes in products}
    own: dict[str, Mapping[sp.Symbol, sp.Expr]] = {"": {}}
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
