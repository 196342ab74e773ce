"""What happens at every set of boundaries that parts can reach at one instant."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import product

import sympy as sp

from nonsmooth.derive.building.assembly import Assembly, Regimes
from nonsmooth.derive.building.impacts import impacts
from nonsmooth.derive.building.loads import landed, loaded
from nonsmooth.derive.building.parts import Exit, FrictionPart, StopPart, SwitchPart
from nonsmooth.derive.building.resting import at_rest, changed, unsettled
from nonsmooth.derive.system import Condition, Transition

__all__ = ["transitions_from"]


def transitions_from(assembly: Assembly, regimes: Regimes) -> Iterator[Transition]:
    """Every set of boundaries that one configuration can reach at one instant."""
    events = [[None, *_reachable(assembly, i, regimes)] for i in range(len(assembly.parts))]
    for sets in product(*events):
        reached = {i: names for i, names in enumerate(sets) if names is not None}
        if reached and not _exclusive(assembly, regimes, reached):
            yield from _event(assembly, regimes, reached)


def _reachable(assembly: Assembly, index: int, regimes: Regimes) -> list[frozenset[str]]:
    """Boundaries of one part: one at a time; those of friction meet where its load vanishes."""
    part = assembly.parts[index]
    names = [b.name for b in assembly.boundaries(index, regimes)]
    found = [frozenset({name}) for name in names]
    if len(names) > 1 and isinstance(part, FrictionPart) and part.loses_load:
        found.append(frozenset(names))
    return found


def _exclusive(assembly: Assembly, regimes: Regimes, reached: Mapping[int, frozenset[str]]) -> bool:
    """Whether two stops are among them that a mass cannot reach together.

    Or boundaries that meet without a load, where what bears it does not let go.
    """
    for i, names in reached.items():
        if len(names) > 1:
            part = assembly.friction(i)
            if not part.lifts and part.bearer not in reached:
                return True
    stops = [i for i in reached if isinstance(assembly.parts[i], StopPart) and regimes[i] == "free"]
    return bool(assembly.rows(stops).rank() < len(stops))


def _event(
    assembly: Assembly, source: Regimes, reached: Mapping[int, frozenset[str]]
) -> Iterator[Transition]:
    """Transitions for one set of boundaries: impacts first, then what is at rest."""
    regimes, own = source, dict[sp.Symbol, sp.Expr]()
    for i, boundaries in reached.items():
        part = assembly.parts[i]
        if isinstance(part, SwitchPart):
            exit_ = _exit(part, source[i], *boundaries)
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
    for conditions, target, after in impacts(assembly, regimes, stops, moved, landing):
        reset = own | {s: e for s, e in zip(frame.velocities, after, strict=True) if s != e}
        begun = [i for i in moved if target[i] == "stick" != source[i]]
        reset |= _pins(assembly, begun, target, impact=True)
        yield Transition(leads, names, assembly.name(target), conditions, reset)
    if 1 in approaches:
        return
    for sides, settled, rest in landed(assembly, regimes, landing):
        resting = [*moved, *rest]
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
    """A transition without impact; what begins to hold is put exactly in its place."""
    begun = [i for i in assembly.active(target) if i in moved or source[i] != target[i]]
    reset = dict(own) | _pins(assembly, begun, target, impact=False)
    return Transition(leads, names, assembly.name(target), conditions, reset)


def _pins(
    assembly: Assembly, begun: Sequence[int], target: Regimes, *, impact: bool
) -> dict[sp.Symbol, sp.Expr]:
    """Velocities, and the places of stops, of parts that begin to hold.

    A held coordinate is set; otherwise all active directions are projected upon together.
    """
    frame = assembly.frame
    rows = assembly.rows(begun)
    if all(sum(weight != 0 for weight in rows.row(k)) == 1 for k in range(rows.rows)):
        found: dict[sp.Symbol, sp.Expr] = {}
        for i in begun:
            part = assembly.holder(i)
            place = next(k for k, weight in enumerate(part.direction) if weight != 0)
            weight, position = part.direction[place], frame.positions[place]
            if isinstance(part, StopPart):
                found[position] = sp.cancel((weight * position - part.gap) / weight)
            found[frame.velocities[place]] = part.speed / weight
        return found
    if impact:
        return {}
    active = assembly.active(target)
    stops = [i for i in active if isinstance(assembly.parts[i], StopPart)]
    gaps = sp.Matrix([assembly.stop(i).gap for i in stops])
    drifts = sp.Matrix(
        [frame.velocity(assembly.holder(i).direction) - assembly.holder(i).speed for i in active]
    )
    return _projected(frame.velocities, assembly.rows(active), drifts) | _projected(
        frame.positions, assembly.rows(stops), gaps
    )


def _projected(
    symbols: Sequence[sp.Symbol], rows: sp.Matrix, excess: sp.Matrix
) -> dict[sp.Symbol, sp.Expr]:
    """The nearest values for which the excess vanishes."""
    if rows.rows == 0:
        return {}
    shift = rows.T * (rows * rows.T).inv() * excess
    return {s: sp.expand(s - e) for s, e in zip(symbols, shift, strict=True) if e != 0}


def _exit(part: SwitchPart, regime: str, boundary: str) -> Exit:
    return next(e for e in part.exits[regime] if e.boundary.name == boundary)
