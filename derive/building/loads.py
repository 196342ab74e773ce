"""Contacts with friction that lose their normal load or their force, and regain it.

The relative velocity r and the load span a plane, of which each regime is a sector: lifted
below a load of zero; above it slip and overshoot on either side of stick, which is a ray; and
outside of them, towards large |r|, the sectors of exhausted friction. At their edges the force
is continuous, but at those of stick.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import product

from nonsmooth.derive.building.assembly import Assembly, Regimes
from nonsmooth.derive.building.parts import FrictionPart
from nonsmooth.derive.building.resting import changed
from nonsmooth.derive.declaration.transition import Condition

__all__ = ["landed", "loaded"]


def loaded(
    assembly: Assembly, source: Regimes, regimes: Regimes, reached: Mapping[int, frozenset[str]]
) -> tuple[Regimes, tuple[int, ...]]:
    """Regimes behind boundaries at which a friction force ends or returns, and what lands.

    `source` are the regimes before the event, in `regimes` those of switching parts are
    replaced already, and `reached` has the boundaries by the index of their part. Contacts
    that land are left lifted; `landed` gives them their regimes.
    """
    landing = []
    for i, part in enumerate(assembly.parts):
        if not isinstance(part, FrictionPart):
            continue
        names, before = reached.get(i, frozenset()), source[i]
        pressed = assembly.pressed(i, regimes)
        if before == "lifted":
            if pressed and (names or not assembly.pressed(i, source)):
                landing.append(i)
        elif not pressed or len(names) > 1 or f"{part.name}-lifts" in names:
            regimes = changed(regimes, i, "lifted")
        elif f"{part.name}-exhausts" in names:
            regimes = changed(regimes, i, f"exhausted-{before}")
        elif f"{part.name}-recovers" in names:
            regimes = changed(regimes, i, before.removeprefix("exhausted-"))
    return regimes, tuple(landing)


def landed(
    assembly: Assembly, regimes: Regimes, landing: Sequence[int]
) -> Iterator[tuple[tuple[Condition, ...], Regimes, tuple[int, ...]]]:
    """All ways in which contacts land: conditions, regimes, and the contacts that are at rest.

    The velocities decide. A contact at rest gets a sliding regime for the moment; its
    regime has still to be decided.
    """
    options = [_sides(assembly, regimes, landing, i) for i in landing]
    for chosen in product(*options):
        settled, conditions, rest = regimes, tuple[Condition, ...](), []
        for i, (regime, condition) in zip(landing, chosen, strict=True):
            conditions += condition
            settled = changed(settled, i, regime or "slip")
            rest += [] if regime else [i]
        yield conditions, settled, tuple(rest)


def _sides(
    assembly: Assembly, regimes: Regimes, landing: Sequence[int], index: int
) -> list[tuple[str | None, tuple[Condition, ...]]]:
    """Regimes in which one contact may land, with their conditions; None stands for rest."""
    part = assembly.friction(index)

    def beside(regime: str) -> Regimes | None:
        """A configuration that exists and in which the contact has that regime, else None."""
        every = [
            (regime,) if i == index else ("lifted", "slip", "overshoot") if i in landing else (r,)
            for i, r in enumerate(regimes)
        ]
        return next(filter(assembly.exists, product(*every)), None)

    possible = {r: found for r in ("stick", *part.regimes) if (found := beside(r))}
    along = assembly.name(next(iter(possible.values())))
    sides: list[tuple[str | None, tuple[Condition, ...]]] = [
        (regime, (Condition(function, along),))
        for regime, function in part.sliding(part.relative, part.load).items()
        if regime in possible
    ]
    if "stick" not in possible:
        return [*sides, (sides[-1][0], ())]
    at_rest = (Condition(sign * part.relative, along, holds=False) for sign in (-1, 1))
    return [*sides, (None, tuple(at_rest))]
