"""The judge of an orbit at one parameter point, in balls: what is proved of it, and its file.

Derivatives by parameters are those of jets of order 1. The orbit is a regular root: by the implicit
function theorem it moves with J x' = -F_p. What the declaration says is read once more, as
functions of the parameters that move: what makes the cycle close has to hold for all of them.
"""

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property, partial
from typing import Any

from flint import acb, acb_poly, arb, ctx, fmpq

from nonsmooth.runtime.checker.orbits.motion import Margin, admissibility
from nonsmooth.runtime.checker.orbits.orbit import CheckedOrbit
from nonsmooth.runtime.checker.orbits.stability import (
    CORNER,
    TANGENTIAL,
    characteristic,
    judged_stability,
    multipliers,
    others_below,
)
from nonsmooth.runtime.checker.stated.exact import (
    Entries,
    Failure,
    Numbers,
    Verdict,
    agreed_claims,
    column,
    demand,
    exact,
    inside,
    stated_box,
)
from nonsmooth.runtime.checker.stated.parameters import (
    independent,
    number_at,
    number_in,
    stated_system,
)
from nonsmooth.runtime.checker.stated.shape import check_bits, check_file, check_sharp
from nonsmooth.runtime.core.jets import jet, part_of


def rates_along(
    content: Entries,
    parameters: Mapping[str, str],
    name: str,
    orbit: CheckedOrbit,
    multipliers: Numbers,
) -> dict[str, Any]:
    """Return the derivatives of all that is enclosed by a number that was given for an orbit.

    `content` states the system and how its parameters move with the number called `name`;
    `parameters` holds the values of all of them, the period among them where it is given. The orbit
    is located. `Failure` is raised if the derivatives are not known.
    """
    rates = {moved: exact(text) for moved, text in content["directions"][name].items()}
    demand(rates and all(rates.values()), f"{name} moves nothing")
    demand(name not in parameters or rates.get(name) == 1, f"{name} moves something else")
    demand(rates.keys() <= parameters.keys(), "what moves is no parameter")
    still = {other: text for other, text in parameters.items() if other not in rates}
    declared, known = stated_system(content, still, [*rates])
    exactly = declared.bound and declared.rational
    demand(exactly, "the declaration takes a root or a sine of its parameters")
    declared.closes()
    point = [arb(number_in(parameters[moved])) for moved in rates]
    numbers = [jet(x, arb(rate)) for x, rate in zip(point, rates.values(), strict=True)]
    found = _rates(CheckedOrbit(declared, number_at([*numbers, *known])), orbit, multipliers)
    independent(declared, known, [(middle, middle) for middle in map(_fraction, point)])
    demand(all(rate.is_finite() for rate in found.values()), "a derivative is not enclosed")
    return found


def sharper(orbit: CheckedOrbit) -> CheckedOrbit:
    """Return the orbit located in a smaller box around its enclosure, where that succeeds."""
    found = CheckedOrbit(orbit.declared, orbit.number)
    widest = max((x.rad() for x in orbit.root), key=float)
    radii = [2 * x.rad() + widest / 2**16 for x in orbit.root]  # no side is empty
    unique, _ = found.locate([x.mid() for x in orbit.root], radii)
    return found if unique else orbit


def _rates(moving: CheckedOrbit, orbit: CheckedOrbit, multipliers: Numbers) -> dict[str, Any]:
    """Return the derivatives of all quantities of the orbit along one direction.

    A real multiplier has no imaginary part that could move.
    """
    slopes = orbit.passage(orbit.chain, orbit.root, orbit.flows).slopes
    missed = moving.along(orbit.root)
    try:
        rates = slopes.solve(column(-part_of(value, 1) for value in missed)).entries()
    except ZeroDivisionError:
        raise Failure("the equations may be singular at the orbit") from None
    moving.along([jet(x, rate) for x, rate in zip(orbit.root, rates, strict=True)])
    # of the whole map: multipliers beside those on a section are zero at all parameters
    free, size = moving.declared.free, moving.declared.size
    basis = [[fmpq(int(i == k)) for k in free] for i in range(size + 1)]
    section = moving.map_on(0, free, basis)
    found = {name: part_of(x, 1) for name, x in moving.enclosures(section).items()}
    coefficients = characteristic(section)[::-1]
    polynomial = acb_poly([acb(part_of(c, 0)) for c in coefficients])
    change = acb_poly([acb(part_of(c, 1)) for c in coefficients])
    slope = polynomial.derivative()
    for number, disc in enumerate(multipliers, 1):
        root = disc.mid() - polynomial(disc.mid()) / slope(disc)  # it is in the disc, and sharper
        rate = -change(root) / slope(root)
        found[f"multiplier {number} re"] = rate.real
        if not disc.imag.is_zero():
            found[f"multiplier {number} im"] = rate.imag
    return found


def _fraction(ball: Any) -> Any:
    """Return the middle of a ball as an exact fraction."""
    mantissa, exponent = ball.mid().man_exp()
    return fmpq(mantissa) * fmpq(2) ** int(exponent)


_GUARD = 96  # bits beyond those of the enclosures
_ENOUGH = 128  # bits that do for admissibility
_SINGULAR = (
    "Krawczyk's test fails: the equations are singular here, or nearly so, or more bits are needed"
)


class JudgedOrbit:
    """What is proved of the orbit that a proposal tells of, at one parameter point.

    A proposal has the entries of a certificate's file that state the system, the way in which the
    cycle closes, the values of the parameters, the box of unknowns, the bits and, where derivatives
    are asked for, how parameters move. Nothing of it is taken on trust, and nothing else is read.
    Boxes may be tried one after another, by `locate`. What follows for an orbit that is proved to
    exist is computed where it is asked for.
    """

    def __init__(self, proposal: Entries) -> None:
        self.proposal, self.bits = proposal, proposal["bits"]
        self.period = {"period": proposal["given_period"]} if proposal["given_period"] else {}
        self.parameters = {**proposal["parameters"], **self.period}
        self.kind = "stable"  # what is claimed of the multipliers, else "neutral"
        self.enclosures: dict[str, Any] = {}
        self.existence = self._stated = self._judged(self._set_up)
        if "box" in proposal:
            self.locate(proposal["box"])

    def locate(self, box: Sequence[dict[str, str]]) -> Verdict:
        """Judge whether a box of unknowns holds one orbit; it becomes the proposal's box."""
        self.proposal = {**self.proposal, "box": box}
        if not self._stated.reason:
            self.existence = self._judged(self._located)
        return self.existence

    def equations(self) -> CheckedOrbit:
        """Return the orbit's equations at the working precision, with no unknowns set."""
        return CheckedOrbit(self.declared, number_at(self.constants))

    def _judged(self, step: Callable[[], Verdict]) -> Verdict:
        """Return the verdict of a step; it is undecided where something cannot be shown."""
        try:
            with ctx.workprec(self.bits + _GUARD):
                return step()
        except Failure as failure:
            return Verdict("undecided", str(failure))
        except (ArithmeticError, ValueError) as problem:
            return Verdict("undecided", f"its numbers cannot be enclosed: {problem}")

    def _set_up(self) -> Verdict:
        """Read what is declared, and prove what makes the cycle close in what is no equation."""
        proposal, own = self.proposal, self.proposal["parameters"]
        demand(not self.period.keys() & own.keys(), "two periods are given")
        self.declared, self.constants = stated_system(proposal, self.parameters)
        declared = self.declared
        timed = proposal["closing"]["kind"] == "period"
        demand(bool(self.period) == timed, "no period is given")
        demand(not timed or proposal["closing"]["period"] in self.period, "another period is given")
        self.kind = declared.stability
        self.energies = declared.closes()
        independent(declared, self.constants)
        self.orbit = self.equations()
        return Verdict("undecided")

    def _located(self) -> Verdict:
        """Prove that the box holds one orbit, and enclose it, its period and its trace."""
        orbit, declared = self.orbit, self.declared
        unique, empty = orbit.locate(*stated_box(self.proposal["box"], declared.unknowns))
        if empty and not declared.forcing:
            return Verdict("refuted", "no orbit is near the given numbers")
        # with a forcing one of the equations is a choice: how often that turns
        demand(unique, _SINGULAR)
        orbit.returns(self.energies)
        found = orbit.enclosures()
        independent(declared, self.constants)  # of all that it was divided by since
        self.enclosures = {name: x for name, x in found.items() if x.is_finite()}
        lost = found.keys() - self.enclosures.keys() - {"trace"}
        demand(not lost, "the orbit is not enclosed")
        return Verdict("proved")

    @cached_property
    def stability(self) -> Verdict:
        """The verdict on the multipliers: all inside the unit circle, or on it, by `kind`."""
        return self._judged(lambda: judged_stability(self.orbit))

    @property
    def _smooth(self) -> bool:
        """Whether the Poincare map has a derivative that is enclosed."""
        return "trace" in self.enclosures and self.declared.alone

    @cached_property
    def multipliers(self) -> tuple[Any, ...]:
        """Nontrivial multipliers that are clearly simple, the largest first; often not all."""
        if not self._smooth:
            return ()
        with ctx.workprec(self.bits + _GUARD):
            return tuple(multipliers(self.orbit))

    @cached_property
    def others_below(self) -> Any:
        """A bound of all other nontrivial multipliers; None where nothing is known of them."""
        if not self._smooth:
            return None
        with ctx.workprec(self.bits + _GUARD):
            return others_below(self.orbit, self.multipliers)

    @cached_property
    def admissibility(self) -> Verdict:
        """The verdict on the orbit being a motion of the system, with its margins."""
        return self._judged(self._admissible)

    def _admissible(self) -> Verdict:
        with ctx.workprec(min(self.bits, _ENOUGH) + _GUARD):
            found = admissibility(self.orbit, margins=True)
        independent(self.declared, self.constants)  # of all that it was divided by since
        return found

    @cached_property
    def derivatives(self) -> dict[str, Verdict]:
        """By each number that moves parameters the verdict on derivatives by it, with these."""
        names = self.proposal.get("directions", {})
        return {name: self._judged(partial(self._moved, name)) for name in names}

    def _moved(self, name: str) -> Verdict:
        """Enclose the derivatives of all that is enclosed by one number."""
        demand("trace" in self.enclosures, f"{TANGENTIAL}: there no derivative is claimed")
        demand(self.declared.alone, CORNER)
        told = self.proposal, self.parameters, name
        return Verdict("proved", found=rates_along(*told, self._sharper, self.multipliers))

    @cached_property
    def _sharper(self) -> CheckedOrbit:
        return sharper(self.orbit)


def check(content: Entries) -> None:
    """Judge the orbit of a certificate's file again; demand that all that it states is found.

    `Failure` names a claim that is not proved; `Malformed` is raised if the file, read as JSON, has
    another shape.
    """
    check_file(content, "nonsmooth certificate")
    check_stated(content)


def check_stated(content: Entries) -> None:
    """Judge an orbit again of which a file, in its shape, states a certificate."""
    bits = check_bits(content)
    exists, admissible, stable = agreed_claims(content["claims"], content["reasons"])
    if exists != "proved":
        told = [content[name] for name in ("enclosures", "multipliers", "margins")]
        told += [content.get(n) for n in ("derivatives", "directions", "other_multipliers")]
        demand(not any(told), "numbers of no orbit")
    if exists == "undecided":
        told = [content[name] for name in ("box", "declaration", "closing", "given_period")]
        demand(not any(told) and content["stability"] == "stable", "numbers of no claim")
        return
    if exists == "proved":
        check_sharp(content["box"], bits)
    found = JudgedOrbit(content)
    _agree("existence", exists, found.existence)
    demand(content["stability"] == found.kind, "stability of another kind")
    if exists == "refuted":
        return
    with ctx.workprec(bits + _GUARD):
        without = {"trace"} if stable == "undecided" else set()
        stated, known = content["enclosures"].keys(), found.enclosures.keys()
        demand(known - without <= stated <= known, "the enclosures are not those of the unknowns")
        for name, enclosure in content["enclosures"].items():
            demand(inside(found.enclosures[name], enclosure), f"{name} is not in its enclosure")
        places = _check_multipliers(content, found)
        if stable != "undecided":
            _agree("stability", stable, found.stability)
        _check_derivatives(content, found, places)
        demand(admissible == "proved" or not content["margins"], "margins of no motion")
        if admissible != "undecided":
            _agree("admissibility", admissible, found.admissibility)
            _check_margins(content["margins"], found.admissibility.found)


def _agree(name: str, stated: str, found: Verdict) -> None:
    """Demand that a claim has the verdict that is stated."""
    demand(stated == found.claim, f"{name} is {found.claim}: {found.reason}")


def _check_multipliers(content: Entries, found: JudgedOrbit) -> list[int]:
    """Demand one of the multipliers in each stated disc, no two in one, and a bound of all others.

    The places of those in the discs are returned.
    """
    places: list[int] = []
    if not content["multipliers"] and not content["other_multipliers"]:
        return places
    for disc in content["multipliers"]:
        fits = [k for k, m in enumerate(found.multipliers)
                if inside(m.real, disc["re"]) and inside(m.imag, disc["im"])]  # fmt: skip
        demand(len(fits) == 1 and fits[0] not in places, "a stated multiplier is none")
        places += fits
    if content["other_multipliers"]:
        most = arb(exact(content["other_multipliers"]))
        others = [abs(m) for k, m in enumerate(found.multipliers) if k not in places]
        small = found.others_below is not None and found.others_below <= most
        small = small and all(size <= most for size in others)
        demand(small, "there is a multiplier that is not stated")
    return places


def _check_derivatives(content: Entries, found: JudgedOrbit, places: Sequence[int]) -> None:
    """Demand the derivatives of all that is enclosed, and of multipliers, in their enclosures."""
    stated, along = content.get("derivatives", {}), content.get("directions", {})
    demand(bool(stated) == bool(along), "derivatives by nothing")
    if not stated:
        return
    own = {f"multiplier {number} {part}": f"multiplier {place + 1} {part}"
           for number, place in enumerate(places, 1) for part in ("re", "im")}  # fmt: skip
    whole = content["enclosures"].keys()
    demand(whole <= stated.keys() <= whole | own.keys(), "derivatives of other quantities")
    same = all(rates.keys() == along.keys() for rates in stated.values())
    demand(same, "derivatives by other parameters")
    for name in along:
        claim, reason, rates = found.derivatives[name]
        demand(claim == "proved", f"there is no derivative by {name}: {reason}")
        for quantity, by in stated.items():
            rate = rates.get(own.get(quantity, quantity))
            proved = rate is not None and inside(rate, by[name])
            demand(proved, f"the derivative of {quantity} by {name} is not in its enclosure")


def _check_margins(stated: Sequence[Entries], margins: Sequence[Margin]) -> None:
    """Demand that each stated margin is positive and no larger than the one that is found."""
    known = {tuple(margin[:4]): margin.least for margin in margins}
    told = {(m["phase"] - 1, m["configuration"], m["boundary"], m["quantity"]): exact(m["least"])
            for m in stated}  # fmt: skip
    demand(len(told) == len(stated), "a margin is stated twice")
    demand(all(least > 0 for least in told.values()), "a margin is not positive")
    demand(told.keys() <= known.keys(), "a margin is stated of nothing")
    kept = all(arb(least) <= known[key] for key, least in told.items())
    demand(kept, "a margin is larger than what is proved")
