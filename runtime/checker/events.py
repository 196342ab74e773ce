"""The check of events: bifurcations and limits of admissibility that are next to a computed one.

Unknowns z are those of the orbit, the parameter, and for a grazing its time. In a box z = m + r e
with e in [-1, 1], and in models of the first order the orbit's equations and the event's are
H = c + L e, with balls c and L. For any Y a root is a fixed point of e -> e - Y H, whose values
lie in K = (I - Y L) [-1, 1] - Y c. Where that is inside [-1, 1] there is a fixed point, by
Brouwer's theorem (1911); the norm of I - Y L is then below 1, so Y is not singular and it is a
root. All roots in the box are in K.
"""

from collections.abc import Callable, Sequence
from functools import reduce
from typing import Any

from flint import arb, arb_mat, ctx

from nonsmooth.runtime.checker.declared import StatedSystem
from nonsmooth.runtime.checker.exact import (
    Failure,
    check_sum,
    demand,
    exact,
    inside,
)
from nonsmooth.runtime.checker.orbit import CheckedOrbit
from nonsmooth.runtime.checker.parameters import number_at, values_of
from nonsmooth.runtime.checker.shape import EVENTS, check_bits, check_shape, check_sharp
from nonsmooth.runtime.checker.stability import (
    characteristic,
    paired,
    products_less_one,
)
from nonsmooth.runtime.core.taylor_models import middle_of, space_of

__all__ = ["check_events"]

_GUARD = 96  # bits beyond those of the enclosures
_MULTIPLIERS = {"flip": -1, "fold": 1, "neimark-sacker": 0}
_INSTANTS = {**dict.fromkeys([*_MULTIPLIERS, "vanishing-phase"], ""),
             "condition": "end", "grazing": "inside"}  # fmt: skip


def check_events(content: dict[str, Any]) -> None:
    """Prove every event of a file again; `Failure` names an event that is not proved.

    `Malformed` is raised if the file, read as JSON, has another shape.
    """
    check_shape(content, EVENTS)
    check_sum(content)
    for number, event in enumerate(content["events"], 1):
        try:
            with ctx.workprec(check_bits(event) + _GUARD):
                _check(event)
        except Failure as failure:
            raise Failure(f"event {number}, {event['kind']}: {failure}") from None


def _check(event: dict[str, Any]) -> None:
    if event["claim"] == "undecided":
        told = [event[name] for name in ("enclosures", "box", "declaration", "closing")]
        demand(event["reason"] and not any(told), "numbers of no event")
        return
    demand(not event["reason"], "a reason why it is undecided")
    check_sharp(event["box"], event["bits"])
    told = event["declaration"].get("constants", [])
    values, numbers, constants = values_of(event["parameters"], [event["parameter"]], told)
    declared = StatedSystem(event, values, numbers)
    demand(declared.bound and declared.rational, "the declaration is not exact")
    energies = declared.closes()
    box, place = event["box"], len(declared.unknowns)  # of the parameter
    names = [side["name"] for side in box]
    time = ["time"] if event["kind"] == "grazing" else []
    wanted = [*declared.unknowns, event["parameter"], *time]
    demand(names == wanted, "the box is not that of the unknowns")
    demand(event["enclosures"].keys() == {*names}, "not every unknown has its enclosure")
    middles, radii = ([arb(exact(side[k])) for side in box] for k in ("mid", "rad"))
    demand(all(r > 0 for r in radii), "the box is empty")

    def misses(middles: Sequence[Any], radii: Sequence[Any]) -> list[Any]:
        space = space_of(len(box), 1)
        sides = zip(middles, radii, strict=True)
        unknowns = [space.variable(k, m, r) for k, (m, r) in enumerate(sides)]
        orbit = CheckedOrbit(declared, number_at([unknowns[place], *constants]))
        demand(orbit.count == place, "the box is of another size")
        values = orbit.along(unknowns[:place])
        orbit.returns(energies)
        return [*values, *_event(orbit, event, unknowns[place + 1 :])]

    root = _roots(misses, middles, radii)
    stated = [event["enclosures"][name] for name in names]
    if not all(map(inside, root, stated)):  # in the smaller box all is sharper
        root = _roots(misses, [x.mid() for x in root], [x.rad() for x in root], again=True)
    for name, value, its in zip(names, root, stated, strict=True):
        demand(inside(value, its), f"{name} is not in its enclosure")
    point = [middles[place] + arb(0, radii[place]), *constants]
    for divisor in declared.exactly.divisors:
        value = divisor(point) if callable(divisor) else divisor
        demand(value > 0 or value < 0, "what is zero there cannot be told")


def _roots(
    misses: Callable[..., list[Any]], middles: list[Any], radii: list[Any], again: bool = False
) -> list[Any]:
    """Return balls around all roots of a box, which is proved to contain one.

    With `again`, existence was proved before and is not demanded.
    """
    values = misses(middles, radii)
    demand(len(values) == len(middles), "as many equations as unknowns are needed")
    slopes = arb_mat([[part or 0 for part in value.parts[1:]] for value in values])
    try:
        y = slopes.mid().inv().mid()
    except ZeroDivisionError:
        raise Failure("the equations are singular in the middle of the box") from None
    size = len(values)
    unit = arb_mat([[int(i == j) for j in range(size)] for i in range(size)])
    within = (unit - y * slopes) * arb_mat([[arb(0, 1)]] * size)
    found = (within - y * arb_mat([[value.parts[0]] for value in values])).entries()
    if not again:
        demand(all(abs(e) < 1 for e in found), "there may be no such event in the box")
    return [m + r * e for m, r, e in zip(middles, radii, found, strict=True)]


def _event(orbit: CheckedOrbit, event: dict[str, Any], more: Sequence[Any]) -> list[Any]:
    """Return the residuals of an event's equations at an orbit."""
    kind, place, declared = event["kind"], event["phase"], orbit.declared
    demand(event["instant"] == _INSTANTS.get(kind, event["instant"]), "another instant")
    if kind in _MULTIPLIERS:
        demand((place, event["configuration"], event["boundary"]) == (None, "", ""), "a phase")
        return [_multiplier(orbit, kind)]
    demand(type(place) is int and 1 <= place <= len(declared.steps), "there is no such phase")
    place -= 1
    demand([event["configuration"]] == [declared.steps[place].name], "another configuration")
    phase, end = declared.phases([])[place], orbit.now.ends[place].entries()
    if kind in ("vanishing-phase", "condition"):
        demand(event["boundary"] == event["itinerary"][place][1], "the phase ends otherwise")
        if kind == "vanishing-phase":
            return [orbit.dwell[place]]
        ways = [way for ways in phase.orders for way in ways]
        rows = [row for way in ways for row, _ in way.conditions if row is not None]
        demand(rows, "the transition has no condition")
        found = [orbit.value(row, end) for row in rows]
        return [min(found, key=lambda value: abs(float(middle_of(value))))]
    watched = next((w for w in phase.watched if w.name == event["boundary"]), None)
    if watched is None:
        raise Failure("there is no such boundary")
    begin, b = orbit.now.starts[place], orbit.chain.fields[place]
    if kind == "grazing":
        (time,) = more
        n, y = orbit.numbers([watched.row]), (b * time).exp() * begin
        demand(time > 0 and orbit.dwell[place] - time > 0, "it is not inside the phase")
        demand((n * (b * (b * y)))[0, 0] < 0, "the boundary is not touched from inside")
        return [(n * y)[0, 0], (n * (b * y))[0, 0]]
    means = {
        ("simultaneous", "end"): (not watched.ends_it, watched.end, end),
        ("tangent", "end"): (watched.ends_it, watched.speed, end),
        ("tangent", "start"): (watched.order > 0, watched.begins, begin.entries()),
        ("entry", "start"): (watched.order == 0, watched.begins, begin.entries()),
    }
    fits, row, state = means.get((kind, event["instant"]), (False, None, end))
    demand(fits and row is not None and any(row), "this is no such event")
    return [orbit.value(row, state)]


def _multiplier(orbit: CheckedOrbit, kind: str) -> Any:
    """Return a number that is zero where a multiplier is -1 or 1, or a pair has the product 1."""
    demand(orbit.declared.alone, "one-sided maps")
    demand(kind == "flip" or not orbit.declared.omega, "1 is always a multiplier")
    polynomial = characteristic(orbit.section)
    if kind == "neimark-sacker":
        demand(len(polynomial) > 2, "there is no pair of multipliers")
        demand(paired(polynomial), "the pair may be real")
        return products_less_one(polynomial)
    return reduce(lambda total, c: total * _MULTIPLIERS[kind] + c, polynomial)
