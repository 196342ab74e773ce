"""Whether a saved census is of the system that it names."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from nonsmooth.runtime.certification.comparing import compare_certificate

__all__ = ["compare_census"]


def compare_census(content: Mapping[str, Any], folder: Path) -> str:
    """Compare the declarations of all orbits with that of the system.

    Raises
    ------
    Failure
        If they differ.
    """
    orbits = [orbit["certificate"] for orbit in content["orbits"]]
    notes = [compare_certificate(found, folder) for found in orbits if found is not None]
    told = [*filter(None, notes[:1]), "that there are no other orbits is not proved again"]
    return "; ".join(told)
