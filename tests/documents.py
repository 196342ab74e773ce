"""Documents to be read: of the built-in systems and orbits, of the gallery, of random systems."""

from functools import cache

import sympy as sp

from nonsmooth.derive import DerivationError, System, derive_equations
from nonsmooth.derive.document.describe import describe_orbit, describe_system
from nonsmooth.derive.systems import SYSTEMS, declaration
from nonsmooth.runtime.model.loading.declared import declaration_in
from tests.declared_documents import (
    chain,
    drop,
    forced_stop,
    impacts,
    masses,
    one_mass,
    pair,
    rattle,
    switching,
)
from tests.latex_reader import ORBITS, Written, written_of
from tests.places import GALLERY
from tests.shared import shared_value
from tests.tables import slow


@cache
def declarations():
    """Systems and itineraries by name."""
    zeta, omega = sp.symbols("zeta omega", positive=True)
    found = {}
    for name in SYSTEMS:
        found[name] = declaration(name).system
    for path in sorted(GALLERY.glob("*.py")):
        declared = declaration_in(path)
        found[path.stem] = declared.system
        found |= {f"{path.stem}/{orbit.name}": orbit for orbit in declared.orbits}
    for name in SYSTEMS:
        found |= {f"{name}/{orbit.name}": orbit for orbit in declaration(name).orbits}
    found |= {"forced": forced_stop(), "chain": chain(), "one-mass": one_mass("1/5")}
    found |= {
        "any-mass": one_mass(zeta * omega, omega**2),
        "masses": masses(2),
        "more-masses": masses(3),
    }
    found |= {"two-impacts": impacts(2), "rattle": rattle(), "many-turns": switching(7)}
    return found | {"ball/drop": drop(), "pair": pair(), "undamped-rattle": rattle(0)}


@cache
def document_of(name):
    """A document; those of the gallery have equations where there is a closed form."""
    declared = declarations()[name]
    if isinstance(declared, System):
        return shared_value(f"document of {name}", lambda: describe_system(declared))
    if "/" not in name:
        return shared_value(f"document of {name}", lambda: describe_orbit(declared))
    written = written_of(name) if name in ORBITS else derived(name)
    if written:
        return written.document
    return shared_value(f"document of {name}", lambda: describe_orbit(declared))


@cache
def derived(name):
    """A declared itinerary whose equations have a closed form."""

    def make():
        try:
            return Written(derive_equations(declarations()[name]))
        except DerivationError:
            return None

    return shared_value(f"derived {name}", make)


def names(kind):
    """Names of all declarations of a kind."""
    return (name for name, declared in declarations().items() if isinstance(declared, kind))


# systems and orbits whose documents take seconds each, of kinds that smaller ones show too
LARGE = "backlash_gear", "chain", "jenkins/yielding-both-ways", "three_masses", "undamped-rattle"
# further ones, in which no line of the derivation and of the document is of their own
REPEATING = {
    *("beam/one-contact", "brake_pad/lifting", "brake_pad/pressed", "impact_damper", "rattle"),
    *("impact_oscillator/three-periods", "piecewise_stiffness", "two_belts", "two_stops/broken"),
    *(f"piecewise_stiffness/{orbit}" for orbit in ("one-contact", "doubled", "subharmonic")),
}


def distinct(listed, *more):
    """Names without those of documents that repeat what others say, and `more` of them."""
    return [name for name in listed if name not in {*REPEATING, *more}]


def marked(listed, *long):
    """Mark as slow large documents, `long` ones and all orbits of a system but one."""
    cases = []
    seen = set()
    for name in listed:
        system, _, orbit = name.partition("/")
        dear = {name, system} & {*LARGE, *REPEATING, *long} or (orbit and system in seen)
        cases.append(slow(name, when=bool(dear)))
        seen |= {system} if orbit else set()
    return cases
