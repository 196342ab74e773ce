"""The check of a certificate at one parameter point, in balls."""

from typing import Any

from flint import arb, ctx

from nonsmooth.runtime.certification.checker.constants import constant, independent
from nonsmooth.runtime.certification.checker.declared import Declared
from nonsmooth.runtime.certification.checker.exact import agreed_claims, check_sum, demand, exact
from nonsmooth.runtime.certification.checker.motion import admissibility
from nonsmooth.runtime.certification.checker.orbit import Orbit
from nonsmooth.runtime.certification.checker.stability import has_multipliers, stability
from nonsmooth.runtime.certification.quotients import symbols

__all__ = ["check"]

_GUARD = 96  # bits beyond those of the enclosures


def check(content: dict[str, Any]) -> None:
    """Prove every claim of a certificate; Failure says which one cannot be."""
    check_sum(content)
    exists, admissible, stable = agreed_claims(content["claims"])
    if exists == "undecided":
        return
    with ctx.workprec(content["bits"] + _GUARD):
        constants = list(map(constant, content["constants"]))
        declared = Declared(content, symbols([f"constant{k}" for k in range(len(constants))]))
        energies = declared.closes()
        independent(declared, constants)

        def number(entry: Any) -> Any:
            return entry(constants) if callable(entry) else arb(entry)

        orbit, box = Orbit(declared, number), content["box"]
        demand(len(box) == orbit.count, "the box is of another size")
        centre, radii = ([arb(exact(side[k])) for side in box] for k in ("mid", "rad"))
        unique, empty = orbit.locate(centre, radii)
        if exists == "refuted":
            # with a forcing one of the equations is a choice: how often that turns
            empty = empty and not declared.forcing
            demand(empty, "existence is not refuted: the box may contain a root")
            return
        demand(unique, "existence is not proved: Krawczyk's test fails")
        orbit.returns(energies)
        found = orbit.enclosures(content["start"], content["dwell_times"])
        for name, stated in content["enclosures"].items():
            miss = abs(found[name] - arb(exact(stated["mid"])))
            demand(miss < arb(exact(stated["rad"])), f"{name} is not in its enclosure")
        stated = [
            (declared.number(m["re"]), declared.number(m["im"])) for m in content["multipliers"]
        ]
        demand(has_multipliers(orbit.section, stated), "a stated multiplier is none")
        if stable != "undecided":
            verdict = stability(orbit, content["stability"])
            demand(verdict == stable, f"stability is {verdict}")
    if admissible != "undecided":
        with ctx.workprec(min(content["bits"], 128) + _GUARD):
            verdict = admissibility(orbit, content["margins"])
        demand(verdict == admissible, f"admissibility is {verdict}")
    with ctx.workprec(content["bits"] + _GUARD):
        independent(declared, constants)  # of all that it was divided by since
