"""The check of a census: of each orbit that is listed, and not that there are no others.

All orbits are of one itinerary, at one parameter point, in the box that is stated, proved one by
one, and no two are one. What the search alone tells is not proved again: that no orbit is left
out, orbits without a certificate, undecided boxes.
"""

import re
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import combinations
from typing import Any

from flint import arb, ctx

from nonsmooth.runtime.checker.exact import (
    Failure,
    ball,
    check_sum,
    demand,
    exact,
)
from nonsmooth.runtime.checker.parameters import number_in
from nonsmooth.runtime.checker.points import check_stated
from nonsmooth.runtime.checker.shape import CENSUS, check_bits, check_shape

__all__ = ["check_census", "check_listed"]

_SIDE = re.compile(r"(?P<low>.+?) (?P<strict><=?) (?P<name>\w+)(?: <= (?P<high>.+))?")
_GUARD = 96


def check_census(content: dict[str, Any]) -> None:
    """Prove each orbit's certificate again, and that no two orbits are one.

    `Failure` names a claim that is not proved; `Malformed` is raised if the file, read as JSON, has
    another shape.
    """
    check_shape(content, CENSUS)
    check_sum(content)
    check_bits(content)
    check_listed(content)
    for number, orbit in enumerate(content["orbits"], 1):
        if orbit["certificate"] is not None:
            with _of_orbit(number):
                check_stated(orbit["certificate"])


def check_listed(content: dict[str, Any]) -> None:
    """Prove that the certificates, if they hold, are of different orbits that the census counts.

    `content` holds the entries of a census, already in their shape.
    """
    bits, orbits = content["bits"], content["orbits"]
    demand(content["count"] == len(orbits), "the count is not that of the orbits")
    demand(content["decided"] == (not content["undecided"]), "undecided boxes of a decided census")
    for number, orbit in enumerate(orbits, 1):
        found = orbit["certificate"]
        demand(bool(orbit["reason"]) == (found is None), "a reason for another orbit")
        if found is not None:
            with _of_orbit(number):
                _check_place(content, orbit, found)
    certified = [orbit["certificate"] for orbit in orbits if orbit["certificate"] is not None]
    for name in ("parameters", "given_period", "declaration"):
        same = all(found[name] == certified[0][name] for found in certified)
        demand(same, f"the orbits have not one and the same {name}")
    verdicts = [found["claims"]["admissibility"] for found in certified]
    demand(content["admissible"] == verdicts.count("proved"), "another number is admissible")
    with ctx.workprec(bits + _GUARD):
        apart = all(_apart(*pair) for pair in combinations(certified, 2))
    demand(apart, "two orbits may be one")


@contextmanager
def _of_orbit(number: int) -> Iterator[None]:
    """Name the orbit in the message of a `Failure` raised within the context."""
    try:
        yield
    except Failure as problem:
        problem.args = (f"orbit {number}: {problem}",)
        raise


def _check_place(content: dict[str, Any], orbit: dict[str, Any], found: dict[str, Any]) -> None:
    """Demand that a certificate is of an orbit that the census counts, at its parameters."""
    demand(found["claims"]["existence"] == "proved", "it is not proved to exist")
    demand(found["declaration"], "it has no declaration")
    same = all(found[name] == content[name] for name in ("system", "orbit", "itinerary", "bits"))
    demand(same, "it is an orbit of something else")
    parameters = content["parameters"]
    for name in parameters.keys() & found["parameters"].keys():
        same = found["parameters"][name] == parameters[name]
        demand(same, f"{name} is not that of the census")
    with ctx.workprec(content["bits"] + _GUARD):
        for side in content["box"]:
            _check_side(side, found["enclosures"])
        for name, (least, most) in orbit["unique"].items():
            if name == "forcing time":  # it is none of the enclosures
                continue
            demand(name in found["enclosures"], f"there is no {name}")
            value = ball(found["enclosures"][name])
            inside = arb(exact(least)) <= value <= arb(exact(most))
            demand(inside, f"{name} is not where it was counted")


def _check_side(side: str, enclosures: dict[str, Any]) -> None:
    """Demand that a dwell time is inside the bounds that a text states as inequalities."""
    told = _SIDE.fullmatch(side)
    demand(told and told["name"] in enclosures, f"{side[:60]!r} bounds no dwell time")
    assert told is not None
    value, low = ball(enclosures[told["name"]]), arb(number_in(told["low"]))
    holds = value > low if told["strict"] == "<" else value >= low
    holds = holds and (told["high"] is None or value <= arb(number_in(told["high"])))
    demand(holds, f"it is not in the box: {side}")


def _apart(first: dict[str, Any], second: dict[str, Any]) -> bool:
    """Return whether two orbits surely differ, whichever phase each is said to begin with."""

    def differ(*names: tuple[str, str]) -> bool:
        one, other = first["enclosures"], second["enclosures"]
        return any(not ball(one[a]).overlaps(ball(other[b])) for a, b in names)

    declared = first["declaration"]
    dwell = [phase["dwell_time"] for phase in declared["phases"]]
    demand(dwell == [p["dwell_time"] for p in second["declaration"]["phases"]], "other unknowns")
    if differ(("period", "period")):
        return True
    itinerary, count = first["itinerary"], len(dwell)
    begins = [k for k in range(count) if itinerary[k:] + itinerary[:k] == itinerary]
    start = [(name, name) for name in declared["start"]]
    return all(
        differ(*zip(dwell, dwell[k:] + dwell[:k], strict=True), *(start if k == 0 else ()))
        for k in begins
    )
