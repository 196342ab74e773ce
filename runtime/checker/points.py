"""The check of a certificate at one parameter point, in balls."""

from typing import Any

from flint import arb, ctx

from nonsmooth.runtime.checker.declared import StatedSystem
from nonsmooth.runtime.checker.derivatives import check_derivatives
from nonsmooth.runtime.checker.exact import (
    agreed_claims,
    ball,
    check_sum,
    demand,
    exact,
    inside,
)
from nonsmooth.runtime.checker.motion import admissibility
from nonsmooth.runtime.checker.orbit import CheckedOrbit
from nonsmooth.runtime.checker.parameters import independent, number_at, values_of
from nonsmooth.runtime.checker.shape import CERTIFICATE, check_bits, check_shape, check_sharp
from nonsmooth.runtime.checker.stability import check_multipliers, stability

__all__ = ["check"]

_GUARD = 96  # bits beyond those of the enclosures
_ENOUGH = 128  # bits that do for admissibility


def check(content: dict[str, Any]) -> None:
    """Prove every claim of a certificate again; `Failure` names a claim that is not proved.

    `Malformed` is raised if the file, read as JSON, has another shape.
    """
    check_shape(content, CERTIFICATE)
    check_sum(content)
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
    with ctx.workprec(bits + _GUARD):
        period = {"period": content["given_period"]} if content["given_period"] else {}
        demand(not period.keys() & content["parameters"].keys(), "two periods are given")
        told = content["declaration"].get("constants", [])
        values, stated, constants = values_of({**content["parameters"], **period}, (), told)
        declared = StatedSystem(content, values, stated)
        demand(bool(period) == (content["closing"]["kind"] == "period"), "no period is given")
        demand(content["stability"] == declared.stability, "stability of another kind")
        energies = declared.closes()
        independent(declared, constants)
        orbit, box = CheckedOrbit(declared, number_at(constants)), content["box"]
        named = [side["name"] for side in box] == declared.unknowns
        demand(named, "the box is not that of the unknowns")
        centre, radii = ([arb(exact(side[k])) for side in box] for k in ("mid", "rad"))
        unique, empty = orbit.locate(centre, radii)
        if exists == "refuted":
            # with a forcing one of the equations is a choice: how often that turns
            empty = empty and not declared.forcing
            demand(empty, "existence is not refuted: the box may contain a root")
            return
        demand(unique, "existence is not proved: Krawczyk's test fails")
        orbit.returns(energies)
        found = orbit.enclosures()
        without = {"trace"} if stable == "undecided" else set()
        all_told = found.keys() - without <= content["enclosures"].keys() <= found.keys()
        demand(all_told, "the enclosures are not those of the unknowns")
        for name, enclosure in content["enclosures"].items():
            demand(inside(found[name], enclosure), f"{name} is not in its enclosure")
        multipliers = [(ball(m["re"]), ball(m["im"])) for m in content["multipliers"]]
        check_multipliers(orbit, multipliers, content["other_multipliers"])
        if stable != "undecided":
            verdict = stability(orbit)
            demand(verdict == stable, f"stability is {verdict}")
        check_derivatives(content, {**content["parameters"], **period}, orbit)
    demand(admissible == "proved" or not content["margins"], "margins of no motion")
    if admissible != "undecided":
        with ctx.workprec(min(bits, _ENOUGH) + _GUARD):
            verdict = admissibility(orbit, content["margins"])
        demand(verdict == admissible, f"admissibility is {verdict}")
    with ctx.workprec(bits + _GUARD):
        independent(declared, constants)  # of all that it was divided by since
