"""The check of a census: the orbits that were counted, not that there are no others."""

from itertools import combinations
from typing import Any

from nonsmooth.runtime.certification.checker.exact import Failure, check_sum, demand, exact
from nonsmooth.runtime.certification.checker.points import check

__all__ = ["check_census"]


def check_census(content: dict[str, Any]) -> None:
    """Prove the certificate of each orbit, and that no two are one; Failure says what cannot be."""
    check_sum(content)
    for number, orbit in enumerate(content["orbits"], 1):
        found = orbit["certificate"]
        if found is None:
            continue
        try:
            same = all(found[name] == content[name] for name in ("system", "itinerary"))
            demand(same, "it is an orbit of something else")
            for name, (least, most) in orbit["unique"].items():
                low, high = _ends(found["enclosures"][name])
                inside = exact(least) <= low and high <= exact(most)
                demand(inside, f"{name} is not where it was counted")
            check(found)
        except Failure as problem:
            raise Failure(f"orbit {number}: {problem}") from None
    certified = (orbit["certificate"] for orbit in content["orbits"])
    found = [certificate["enclosures"] for certificate in certified if certificate is not None]
    demand(all(_apart(*pair) for pair in combinations(found, 2)), "two orbits may be one")


def _ends(enclosure: dict[str, str]) -> tuple[Any, Any]:
    middle, radius = exact(enclosure["mid"]), exact(enclosure["rad"])
    return middle - radius, middle + radius


def _apart(first: dict[str, Any], second: dict[str, Any]) -> bool:
    """Whether some number of two orbits differs."""
    pairs = ((_ends(first[name]), _ends(second[name])) for name in first.keys() & second.keys())
    return any(high < its_low or its_high < low for (low, high), (its_low, its_high) in pairs)
