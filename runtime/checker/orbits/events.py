"""The judge of events: bifurcations and limits of admissibility that are next to a computed one.

Unknowns z are those of the orbit, the parameter, and for a grazing its time. In a box z = m + r e
with e in [-1, 1], and in models of the first order the orbit's equations and the event's are
H = c + L e, with balls c and L. For any Y a root is a fixed point of e -> e - Y H, whose values
lie in K = (I - Y L) [-1, 1] - Y c. Where that is inside [-1, 1] there is a fixed point, by
Brouwer's theorem (1911); the norm of I - Y L is then below 1, so Y is not singular and it is a
root. All roots in the box are in K.
"""

from collections.abc import Sequence
from typing import Any

from flint import arb, arb_mat, ctx

from nonsmooth.runtime.checker.orbits.motion import Border
from nonsmooth.runtime.checker.orbits.orbit import CheckedOrbit, krawczyk_step, near_inverse, newton
from nonsmooth.runtime.checker.orbits.stability import (
    MULTIPLIERS,
    characteristic,
    paired,
    passing,
)
from nonsmooth.runtime.checker.stated.exact import (
    Entries,
    Numbers,
    column,
    demand,
    demand_sign,
    inside,
    naming,
    stated_box,
)
from nonsmooth.runtime.checker.stated.parameters import number_at, stated_system
from nonsmooth.runtime.checker.stated.shape import check_bits, check_file, check_sharp
from nonsmooth.runtime.core.taylor_models import middle_of, space_of

_SMALL = 2.0**-10  # unknowns that are smaller have a unit of their own
_GUARD = 96  # bits beyond those of the enclosures
_INSTANTS = {**dict.fromkeys([*MULTIPLIERS, "vanishing-phase"], ""),
             "condition": "end", "grazing": "inside"}  # fmt: skip


class JudgedEvent:
    """The event that a proposal tells of: its equations, and what is proved of their roots.

    A proposal has the entries of a file that state the system, the way in which the cycle closes,
    the values of the parameters, the bits, and the event by its kind and place. Nothing of it is
    taken on trust, and nothing else is read.
    """

    def __init__(self, proposal: Entries) -> None:
        self.proposal, self.bits = proposal, proposal["bits"]
        with ctx.workprec(self.bits + _GUARD):
            by = proposal["parameter"]
            found = stated_system(proposal, proposal["parameters"], [by])
            self.declared, self.constants = found
            declared = self.declared
            demand(declared.bound and declared.rational, "the declaration is not exact")
            self.energies = declared.closes()
        self.place = len(declared.unknowns)  # of the parameter among the unknowns
        time = ["time"] if proposal["kind"] == "grazing" else []
        self.names = [*declared.unknowns, by, *time]

    def near(self, guess: Numbers) -> list[Any]:
        """Return unknowns near an event, by Newton's method; nothing is proved of them.

        `Failure` is raised where it finds none.
        """

        def at(point: Numbers) -> tuple[Any, Any]:
            unit = arb(2) ** -(ctx.prec // 2)
            radii = [unit * (abs(x).mid() if abs(x) > _SMALL else 1) for x in point]
            _, found, _ = self._along(point, radii)
            slopes = [[(part or 0) / r for part, r in zip(value.parts[1:], radii, strict=True)]
                      for value in found]  # fmt: skip
            return column(value.parts[0] for value in found), arb_mat(slopes)

        return newton(at, guess)

    def located(self, box: Sequence[dict[str, str]]) -> dict[str, Any]:
        """Return enclosures by name of all roots in a box, which is proved to have one.

        Where a parameter is an unknown too, and has its name, one ball encloses both.
        """
        with ctx.workprec(self.bits + _GUARD):
            middles, radii = stated_box(box, self.names)
            demand(all(r > 0 for r in radii), "the box is empty")
            orbit, values, which = self._along(middles, radii)
            found = _image(values)
            demand(all(abs(e) < 1 for e in found), "there may be no such event in the box")
            orbit.returns(self.energies)
            point = [middles[self.place] + arb(0, radii[self.place]), *self.constants]
            for divisor in self.declared.exactly.divisors:
                value = divisor(point) if callable(divisor) else divisor
                demand_sign(value, "what is zero there cannot be told")
            # all roots are in a smaller box, where all is sharper
            roots = [m + r * e for m, r, e in zip(middles, radii, found, strict=True)]
            unit, middles = arb(2) ** -ctx.prec, [x.mid() for x in roots]
            radii = [(x.rad() + r * unit).upper() for x, r in zip(roots, radii, strict=True)]
            found = _image(self._along(middles, radii, which)[1])
            enclosures: dict[str, Any] = {}
            for name, m, r, e in zip(self.names, middles, radii, found, strict=True):
                root = m + r * e
                enclosures[name] = root.union(enclosures.get(name, root))
        return enclosures

    def _along(
        self, middles: Numbers, radii: Numbers, which: int | None = None
    ) -> tuple[CheckedOrbit, list[Any], int | None]:
        """Return the orbit along a box of unknowns, and the left-hand sides of all equations.

        Of a transition's conditions the one with the number `which` is taken, which is returned;
        by default it is the one that is nearest to zero.
        """
        space = space_of(len(self.names), 1)
        sides = zip(middles, radii, strict=True)
        unknowns = [space.variable(k, m, r) for k, (m, r) in enumerate(sides)]
        orbit = CheckedOrbit(self.declared, number_at([unknowns[self.place], *self.constants]))
        values = orbit.along(unknowns[: self.place])
        found = _event(orbit, self.proposal, unknowns[self.place + 1 :])
        if self.proposal["kind"] == "condition":
            sizes = [abs(float(middle_of(value))) for value in found]
            which = sizes.index(min(sizes)) if which is None else which
            found = [found[which]]
        return orbit, [*values, *found], which


def check_events(content: Entries) -> None:
    """Judge every event of a file again; `Failure` names an event that is not proved.

    `Malformed` is raised if the file, read as JSON, has another shape.
    """
    check_file(content, "nonsmooth event certificate")
    demand(content["events"], "the file tells of no event")
    for number, event in enumerate(content["events"], 1):
        with naming(f"event {number}, {event['kind']}"), ctx.workprec(check_bits(event) + _GUARD):
            _check(event)


def _check(event: Entries) -> None:
    if event["claim"] == "undecided":
        told = [event[name] for name in ("enclosures", "box", "declaration", "closing")]
        demand(event["reason"] and not any(told), "numbers of no event")
        return
    demand(not event["reason"], "a reason why it is undecided")
    check_sharp(event["box"], event["bits"])
    found, stated = JudgedEvent(event).located(event["box"]), event["enclosures"]
    demand(stated.keys() == found.keys(), "not every unknown has its enclosure")
    for name, value in found.items():
        demand(inside(value, stated[name]), f"{name} is not in its enclosure")


def _image(values: Numbers) -> list[Any]:
    """Return K, which contains the places in [-1, 1] of all roots of models in a box."""
    size = len(values)
    fits = all(len(value.parts) == size + 1 for value in values)
    demand(fits, "as many equations as unknowns are needed")
    slopes = arb_mat([[part or 0 for part in value.parts[1:]] for value in values])
    y = near_inverse(slopes)
    missed = column(value.parts[0] for value in values)
    return krawczyk_step(missed, y, slopes, [arb(0, 1)] * size)


def _event(orbit: CheckedOrbit, event: Entries, more: Numbers) -> list[Any]:
    """Return the residuals of an event's equations at an orbit: those of all its conditions."""
    kind, place, declared = event["kind"], event["phase"], orbit.declared
    demand(event["instant"] == _INSTANTS.get(kind, event["instant"]), "another instant")
    if kind in MULTIPLIERS:
        demand((place, event["configuration"], event["boundary"]) == (None, "", ""), "a phase")
        return [_multiplier(orbit, kind)]
    demand(type(place) is int and 1 <= place <= len(declared.steps), "there is no such phase")
    place -= 1
    demand([event["configuration"]] == [declared.steps[place].name], "another configuration")
    border = Border(kind, place, event["boundary"], event["instant"])
    if kind == "condition":
        demand(event["boundary"] == event["itinerary"][place][1], "the phase ends otherwise")
        phase, end = declared.phases([])[place], orbit.now.ends[place].entries()
        ways = [way for ways in phase.orders for way in ways]
        alone = phase.lawful or sum(way.alike for way in ways) == 1
        demand(alone, "another transition leads where the itinerary's does")
        rows = [row for way in ways for row, _ in way.conditions if row is not None]
        demand(rows, "the transition has no condition")
        return [orbit.value(row, end) for row in rows]
    if kind == "grazing":
        (time,) = more
        b, n = orbit.chain.fields[place], orbit.numbers([border.watched(orbit).row])
        rate = b * ((b * time).exp() * orbit.now.starts[place])
        demand(time > 0 and orbit.dwell[place] - time > 0, "it is not inside the phase")
        demand((n * (b * rate))[0, 0] < 0, "the boundary is not touched from inside")
        return [border.number(orbit, time), (n * rate)[0, 0]]
    return [border.number(orbit)]


def _multiplier(orbit: CheckedOrbit, kind: str) -> Any:
    """Return a number that is zero where a multiplier is -1 or 1, or a pair has the product 1."""
    demand(orbit.declared.alone, "one-sided maps")
    demand(kind == "flip" or not orbit.declared.omega, "1 is always a multiplier")
    polynomial = characteristic(orbit.section)
    few = len(polynomial) < (3 if kind == "neimark-sacker" else 2)
    demand(not few, "too few multipliers differ from zero: the branch meets a border there")
    if kind == "neimark-sacker":
        demand(paired(polynomial), "the pair may be real")
    return passing(polynomial, kind)
