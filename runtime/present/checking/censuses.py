"""Whether a saved census is of the system and the orbit that it names."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from nonsmooth.runtime.checker import Failure
from nonsmooth.runtime.present.checking.certificates import (
    compare_certificate,
    given_values,
    named_in,
)
from nonsmooth.runtime.proof.orbit_cycle import NotCovered, physical_values

__all__ = ["compare_census"]


def compare_census(content: Mapping[str, Any], folder: Path) -> bool:
    """Compare all orbits, and the census' parameters, with the system and the orbit named.

    Returns
    -------
    bool
        Whether that could be done: the system is there.

    Raises
    ------
    Failure, InputError
        If they differ.
    """
    orbits = [orbit["certificate"] for orbit in content["orbits"]]
    certified = [found for found in orbits if found is not None]
    named = named_in(content, folder)
    if named is None:
        return False
    given = given_values(content["parameters"])
    for found in certified:
        compare_certificate(found, folder)
        own = given_values(found["parameters"])
        values = given
        if named.derived is not None:
            chosen = {name: own[name] for name in found["chosen"]}
            try:
                values = physical_values(named.derived, {**given, **chosen})
            except (NotCovered, KeyError) as problem:
                raise Failure(f"the parameters of the census: {problem}") from None
        if values != own:
            raise Failure("an orbit is not at the parameters of the census")
        period = None if named.derived is None else given.get(named.period)
        if period is not None and period.text != found["given_period"]:
            raise Failure("an orbit has not the period of the census")
    return True
