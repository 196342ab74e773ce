"""Documents to be read: of the built-in systems and orbits, of the gallery, of random systems."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cache
from typing import Any

import pytest

from nonsmooth.derive import DerivationError, EquationSystem, Itinerary, System, derive_equations
from nonsmooth.derive.document.blocks import Document, Formula, Heading
from nonsmooth.derive.document.describe import describe_orbit, describe_system
from nonsmooth.derive.systems import SYSTEMS, declaration
from nonsmooth.runtime.model.loading.declared import declaration_in
from tests.declared_documents import chain, forced_stop, impacts, one_mass, rattle, switching
from tests.latex_reader import ORBITS, Written, written_of
from tests.places import GALLERY
from tests.shared import shared_value


@cache
def declarations() -> dict[str, System | Itinerary]:
    """Systems and itineraries by name."""
    found: dict[str, Any] = {}
    for name in SYSTEMS:
        found[name] = declaration(name).system
    for path in sorted(GALLERY.glob("*.py")):
        declared = declaration_in(path)
        found[path.stem] = declared.system
        found |= {f"{path.stem}/{orbit.name}": orbit for orbit in declared.orbits}
    for name in SYSTEMS:
        found |= {f"{name}/{orbit.name}": orbit for orbit in declaration(name).orbits}
    found |= {"forced": forced_stop(), "chain": chain(), "one-mass": one_mass("1/5")}
    found |= {"two-impacts": impacts(2), "rattle": rattle(), "switching": switching()}
    return found


@cache
def document_of(name: str) -> tuple[Document, EquationSystem | None]:
    """A document, and the equations that are derived for it."""
    if name in ORBITS:
        written = written_of(name)
        return written.document, written.equations
    declared = declarations()[name]
    if isinstance(declared, System):
        return shared_value(f"document of {name}", lambda: describe_system(declared)), None
    if "/" not in name:
        return shared_value(f"document of {name}", lambda: describe_orbit(declared)), None
    written = derived(name)
    return (written.document, written.equations) if written else (describe_orbit(declared), None)


def labels_by_section(document: Document) -> list[str]:
    """Numbers that the numbered formulas are to have: that of the section, and the place in it."""
    section, place, found = 0, 0, []
    for block in document.blocks:
        if isinstance(block, Heading) and block.level == 1:
            section, place = section + 1, 0
        elif isinstance(block, Formula) and block.label:
            place += 1
            found.append(f"{section}.{place}")
    return found


@cache
def derived(name: str) -> Written | None:
    """A declared itinerary whose equations have a closed form."""
    try:
        return Written(derive_equations(declarations()[name]))
    except DerivationError:
        return None


def names(kind: type[System] | type[Itinerary]) -> Iterator[str]:
    """Names of all declarations of a kind."""
    return (name for name, declared in declarations().items() if isinstance(declared, kind))


# systems and orbits whose documents take seconds each, of kinds that smaller ones show too
LARGE = {
    *("backlash_gear", "beam/one-contact", "brake_pad/lifting", "chain", "impact_damper"),
    *("jenkins/yielding-both-ways", "piecewise_stiffness", "three_masses", "two_belts"),
}


def marked(listed: Iterable[str], *long: str) -> list[Any]:
    """Mark as slow large documents, `long` ones and all orbits of a system but one."""
    cases: list[Any] = []
    seen: set[str] = set()
    for name in listed:
        system, _, orbit = name.partition("/")
        slow = {name, system} & {*LARGE, *long} or (orbit and system in seen)
        cases.append(pytest.param(name, marks=[pytest.mark.slow] if slow else []))
        seen |= {system} if orbit else set()
    return cases
