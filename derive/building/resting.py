"""What contacts and stops do without an impact: they slide, hold, let go, lift and land.

At rest, parts that the mass matrix couples make a cluster and are decided together, as the small
complementarity problem that they are: the next regimes are the first, those with the most active
parts leading, whose forces keep their limits and whose motions go their way. Clusters follow one
another; parts that are still undecided hold meanwhile.

Of a contact with friction that loses its normal load or its force and regains it, the relative
velocity r and the load span a plane, of which each regime is a sector: lifted below a load of
zero; above it slip and overshoot on either side of stick, which is a ray; and outside of them,
towards large |r|, the sectors of exhausted friction. At their edges the force is continuous, but
at those of stick.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import product

import sympy as sp

from nonsmooth.derive.building.assembly import Assembly, Regimes, changed
from nonsmooth.derive.building.parts import FrictionPart, StopPart
from nonsmooth.derive.declaration.transition import Condition

# conditions, and the regimes that they lead to
Choice = tuple[tuple[Condition, ...], Regimes]


def unsettled(assembly: Assembly, regimes: Regimes) -> tuple[int, ...]:
    """Friction contacts whose sliding regime is nominal.

    Stops hold the direction of such a contact at a velocity that is zero relative to the
    belt, or may be zero.
    """
    found = []
    for i in assembly.frictions:
        if regimes[i] in ("slip", "overshoot"):
            drift = assembly.drift(i, regimes)
            if drift is not None and assembly.frame.sign(drift) in (0, None):
                found.append(i)
    return tuple(found)


def still(part: FrictionPart, along: str) -> tuple[Condition, ...]:
    """Conditions under which a contact has no relative velocity."""
    return tuple(Condition(sign * part.relative, along, holds=False) for sign in (-1, 1))


def at_rest(
    assembly: Assembly, regimes: Regimes, moved: Sequence[int], resting: Iterable[int]
) -> Iterator[Choice]:
    """All ways out of an event for the parts at rest, in the order in which they are tried.

    Each is a tuple of conditions and the regimes to which they lead. `regimes` are those
    before the event, except that switching parts have changed already; `moved` have reached
    a boundary, and `resting` are at rest although their regime is one of sliding.
    """
    clusters = _clusters(assembly, moved, {*assembly.active(regimes), *resting})
    return _decided(assembly, clusters, regimes, moved)


def _clusters(
    assembly: Assembly, moved: Sequence[int], others: Iterable[int]
) -> list[tuple[int, ...]]:
    """Moved parts with those coupled to them, directly or through others."""
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
        holding = changed(meanwhile, {i: assembly.holders[i].holding})
        meanwhile = holding if assembly.exists(holding) else meanwhile
    for conditions, chosen in _choices(assembly, cluster, meanwhile):
        following = changed(regimes, {i: chosen[i] for i in cluster})
        for more, final in _decided(assembly, rest, following, moved):
            yield conditions + more, final


def _choices(assembly: Assembly, cluster: tuple[int, ...], regimes: Regimes) -> Iterator[Choice]:
    """The regimes of a cluster, each with the conditions under which it takes them."""
    if len(cluster) > 1:
        options = [
            assembly.holders[i].outcomes if i in cluster else (regime,)
            for i, regime in enumerate(regimes)
        ]
        for candidate in sorted(assembly.possible(options), key=lambda c: -len(assembly.active(c))):
            yield tuple(c for i in cluster for c in _consistent(assembly, i, candidate)), candidate
        return
    (index,) = cluster
    part = assembly.holders[index]
    if regimes[index] == "contact":  # what would have to pull lets go
        yield (), changed(regimes, {index: "free"})
        return
    holding = changed(regimes, {index: part.holding})
    along, possible = assembly.name(holding), assembly.exists(holding)
    if isinstance(part, StopPart):
        if possible:
            yield (Condition(assembly.pressure(index, holding), along),), holding
        yield (), regimes
    elif possible:
        forward, backward = assembly.excesses(index, holding)
        if forward != backward:  # there is a force to be held
            yield (Condition(forward, along),), changed(regimes, {index: "slip"})
            yield (Condition(backward, along),), changed(regimes, {index: "overshoot"})
        yield (), holding


def _consistent(assembly: Assembly, index: int, regimes: Regimes) -> tuple[Condition, ...]:
    """Conditions under which one part of a cluster keeps its regime in a combination."""
    part, regime, along = assembly.holders[index], regimes[index], assembly.name(regimes)
    if regime == "contact":
        return (Condition(-assembly.pressure(index, regimes), along, holds=False),)
    if regime == "stick":
        excesses = assembly.excesses(index, regimes)
        return tuple(Condition(excess, along, holds=False) for excess in excesses)
    drift = assembly.drift(index, regimes)
    if isinstance(part, StopPart):
        return () if drift == 0 else (Condition(-part.gap, along),)
    if drift is not None:
        return ()  # held by a stop, it takes whatever force; its side does not matter
    return (Condition(part.slides(regime) * part.relative, along),)


def pins(
    assembly: Assembly, begun: Sequence[int], target: Regimes, *, impact: bool
) -> dict[sp.Symbol, sp.Expr]:
    """Reset of the velocities, and at stops the positions, of parts that begin to hold.

    A held coordinate is set to its value. Where a combination of coordinates is held, the
    state is projected orthogonally on all active directions together; at an impact it is
    left as it is.
    """
    frame, holders = assembly.frame, assembly.holders
    if (places := assembly.places(begun)) is not None:
        pinned: dict[sp.Symbol, sp.Expr] = {}
        for i, (place, weight) in places.items():
            part, position = holders[i], frame.positions[place]
            if isinstance(part, StopPart):
                pinned[position] = sp.cancel((weight * position - part.gap) / weight)
            pinned[frame.velocities[place]] = part.speed / weight
        return pinned
    if impact:
        return {}
    active = assembly.active(target)
    stops = {i: part.gap for i, part in assembly.stops.items() if i in active}
    drifts = [frame.velocity(holders[i].direction) - holders[i].speed for i in active]
    return _projected(frame.velocities, assembly.rows(active), drifts) | _projected(
        frame.positions, assembly.rows(stops), list(stops.values())
    )


def _projected(
    symbols: Sequence[sp.Symbol], rows: sp.Matrix, excess: Sequence[sp.Expr]
) -> dict[sp.Symbol, sp.Expr]:
    """Values of the symbols nearest to the present ones for which k excesses vanish.

    `rows` (k, n) are their gradients by the symbols.
    """
    if rows.rows == 0:
        return {}
    shift = rows.T * (rows * rows.T).inv() * sp.Matrix(excess)
    return {s: sp.expand(s - e) for s, e in zip(symbols, shift, strict=True) if e != 0}


def loaded(
    assembly: Assembly, source: Regimes, regimes: Regimes, reached: Mapping[int, frozenset[str]]
) -> tuple[Regimes, tuple[int, ...]]:
    """Regimes behind boundaries at which a friction force ends or returns, and what lands.

    `source` are the regimes before the event, in `regimes` those of switching parts are
    replaced already, and `reached` has the boundaries by the index of their part. Contacts
    that land are left lifted; `landed` gives them their regimes.
    """
    changes, landing = dict[int, str](), []
    for i, part in assembly.frictions.items():
        names, before = reached.get(i, frozenset()), source[i]
        pressed = assembly.pressed(i, regimes)
        if before == "lifted":
            if pressed and (names or not assembly.pressed(i, source)):
                landing.append(i)
        elif not pressed or len(names) > 1 or f"{part.name}-lifts" in names:
            changes[i] = "lifted"
        elif f"{part.name}-exhausts" in names:
            changes[i] = f"exhausted-{before}"
        elif f"{part.name}-recovers" in names:
            changes[i] = before.removeprefix("exhausted-")
    return changed(regimes, changes), tuple(landing)


def landed(
    assembly: Assembly, regimes: Regimes, landing: Sequence[int]
) -> Iterator[tuple[tuple[Condition, ...], Regimes, tuple[int, ...]]]:
    """All ways in which contacts land: conditions, regimes, and the contacts that are at rest.

    The velocities decide. A contact at rest gets a sliding regime for the moment; its
    regime has still to be decided.
    """
    for chosen in product(*(_sides(assembly, regimes, landing, i) for i in landing)):
        sides = dict(zip(landing, chosen, strict=True))
        yield (
            tuple(condition for _, conditions in chosen for condition in conditions),
            changed(regimes, {i: regime or "slip" for i, (regime, _) in sides.items()}),
            tuple(i for i, (regime, _) in sides.items() if regime is None),
        )


def _sides(
    assembly: Assembly, regimes: Regimes, landing: Sequence[int], index: int
) -> list[tuple[str | None, tuple[Condition, ...]]]:
    """Regimes in which one contact may land, with their conditions; None stands for rest."""
    part = assembly.frictions[index]
    options = [
        ("lifted", "slip", "overshoot") if i in landing else (r,) for i, r in enumerate(regimes)
    ]
    possible = {}  # a configuration for each regime that the contact may have
    for regime in ("stick", *part.regimes):
        beside = [*options[:index], (regime,), *options[index + 1 :]]
        if found := next(assembly.possible(beside), None):
            possible[regime] = found
    along = assembly.name(next(iter(possible.values())))
    sides: list[tuple[str | None, tuple[Condition, ...]]] = [
        (regime, (Condition(function, along),))
        for regime, function in part.sliding(part.relative, part.load).items()
        if regime in possible
    ]
    if "stick" not in possible:
        return [*sides, (sides[-1][0], ())]
    return [*sides, (None, still(part, along))]
