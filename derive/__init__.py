"""Symbolic half: from a declared oscillator to its equations and kernels.

Read the pipeline in `nonsmooth.derive.equations.derive_equations`. The map of the house:

===============  ==============================================================
`parameter`      parameters with domains; what is positive on a whole domain
`dynamics`       the linear motion inside a configuration
`system`         Boundary, Configuration, Transition, Contact, System: what is declared
`itinerary`      Itinerary: the phases of an orbit, and how it is presented
`soundness`      what a declaration must not be: endings, dead transitions, wrong landings
`fingerprint`    a hash that equal declarations share
`unfolding`      the whole of an orbit that is declared by a part and a symmetry
`systems`        the systems of the source paper, declared
`entire`         entire functions that never divide by an eigenvalue
`modal`          flow of a configuration in closed form, and the spectrum
`declaration`    the whole system as rows, fields, resets and modes: what a simulation needs
`program`        stages of assignments and their derivatives
`chain`          section, phases, transitions; Jacobians and Poincare map on it
`explicit`       dwell times in closed form
`reduction`      elimination of what is linear or explicit; the map in one variable
`equations`      EquationSystem, the frozen record handed to every emitter
`appendix`       the source paper's own route to the global stick orbit
`kernels`        what is emitted for a system and an orbit
`document`       the derivation written down: LaTeX, Markdown, HTML, PDF
`building`       the usual oscillators in a few lines: stops, friction, sliders, forcing
`codegen`        the emitters: Python, C, ufuncs
===============  ==============================================================

The public names below are imported when they are first used.
"""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from nonsmooth.derive.building import (
        Friction,
        Harmonic,
        Regions,
        RigidStop,
        Slider,
        SoftStop,
        Terms,
        chain_matrices,
        oscillator,
    )
    from nonsmooth.derive.dynamics import FirstOrder, SecondOrder
    from nonsmooth.derive.equations import EquationSystem, derive_equations
    from nonsmooth.derive.errors import DeclarationError, DerivationError
    from nonsmooth.derive.itinerary import Itinerary, Phase, Presentation, Reference
    from nonsmooth.derive.parameter import Parameter
    from nonsmooth.derive.system import (
        Boundary,
        Condition,
        Configuration,
        Contact,
        System,
        Transition,
    )
    from nonsmooth.derive.systems import dry_friction

__all__ = [
    "Boundary",
    "Condition",
    "Configuration",
    "Contact",
    "DeclarationError",
    "DerivationError",
    "EquationSystem",
    "FirstOrder",
    "Friction",
    "Harmonic",
    "Itinerary",
    "Parameter",
    "Phase",
    "Presentation",
    "Reference",
    "Regions",
    "RigidStop",
    "SecondOrder",
    "Slider",
    "SoftStop",
    "System",
    "Terms",
    "Transition",
    "chain_matrices",
    "derive_equations",
    "dry_friction",
    "oscillator",
]

_HOMES = {
    "Friction": "building",
    "Harmonic": "building",
    "Regions": "building",
    "RigidStop": "building",
    "Slider": "building",
    "SoftStop": "building",
    "Terms": "building",
    "chain_matrices": "building",
    "oscillator": "building",
    "DeclarationError": "errors",
    "DerivationError": "errors",
    "EquationSystem": "equations",
    "derive_equations": "equations",
    "Itinerary": "itinerary",
    "Phase": "itinerary",
    "Presentation": "itinerary",
    "Reference": "itinerary",
    "Parameter": "parameter",
    "Boundary": "system",
    "Condition": "system",
    "Configuration": "system",
    "Contact": "system",
    "FirstOrder": "dynamics",
    "SecondOrder": "dynamics",
    "System": "system",
    "Transition": "system",
}


def __getattr__(name: str) -> object:
    """Import a public name when it is first asked for (PEP 562)."""
    if name == "dry_friction":
        return import_module("nonsmooth.derive.systems.dry_friction")
    if name in _HOMES:
        return getattr(import_module(f"nonsmooth.derive.{_HOMES[name]}"), name)
    raise AttributeError(f"module 'nonsmooth.derive' has no attribute {name!r}")


def __dir__() -> list[str]:
    """List the public names, imported or not."""
    return sorted(__all__)
