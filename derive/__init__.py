"""Symbolic half: from a declared oscillator to its equations and kernels.

Read the pipeline in `nonsmooth.derive.equations.derivation.derive_equations`. The rooms, each of
which uses those below it:

=============  ================================================================================
`building`     the usual oscillators in a few lines: stops, friction, sliders, forcing
`codegen`      the emitters: kernels and tables as Python, C, ufuncs; the files of generated/
`document`     the derivation written down: LaTeX, Markdown, HTML, PDF
`equations`    from an itinerary to its equations, Jacobians, Poincare map, trace, reduction
`flows`        motion inside a configuration in closed form: modal analysis, entire functions
`systems`      the systems of the source paper, declared
`declaration`  parameters, configurations, transitions, systems, itineraries: what is declared
=============  ================================================================================

`errors` and `registry` stand below all. The public names are imported when they are first used.
"""

from importlib import import_module
from typing import TYPE_CHECKING

from nonsmooth.derive.registry import register, registered

if TYPE_CHECKING:
    from nonsmooth.derive.building.elements import (
        Friction,
        Harmonic,
        Regions,
        RigidStop,
        Slider,
        SoftStop,
        Terms,
    )
    from nonsmooth.derive.building.matrices import chain_matrices, read_matrices
    from nonsmooth.derive.building.oscillator import oscillator
    from nonsmooth.derive.building.reduction import ReducedStructure, reduce_structure
    from nonsmooth.derive.declaration.configuration import Boundary, Configuration, Contact
    from nonsmooth.derive.declaration.dynamics import FirstOrder, SecondOrder
    from nonsmooth.derive.declaration.itinerary import Itinerary, Phase, Reference
    from nonsmooth.derive.declaration.parameter import Parameter
    from nonsmooth.derive.declaration.presentation import Presentation
    from nonsmooth.derive.declaration.source import Source
    from nonsmooth.derive.declaration.system import System
    from nonsmooth.derive.declaration.transition import Condition, Transition
    from nonsmooth.derive.equations.derivation import derive_equations
    from nonsmooth.derive.equations.equation_system import EquationSystem
    from nonsmooth.derive.errors import DeclarationError, DerivationError
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
    "ReducedStructure",
    "Reference",
    "Regions",
    "RigidStop",
    "SecondOrder",
    "Slider",
    "SoftStop",
    "Source",
    "System",
    "Terms",
    "Transition",
    "chain_matrices",
    "derive_equations",
    "dry_friction",
    "oscillator",
    "read_matrices",
    "reduce_structure",
]

_HOMES = {
    "building.elements": (
        "Friction",
        "Harmonic",
        "Regions",
        "RigidStop",
        "Slider",
        "SoftStop",
        "Terms",
    ),
    "building.matrices": ("chain_matrices", "read_matrices"),
    "building.oscillator": ("oscillator",),
    "building.reduction": ("ReducedStructure", "reduce_structure"),
    "declaration.configuration": (
        "Boundary",
        "Configuration",
        "Contact",
    ),
    "declaration.dynamics": (
        "FirstOrder",
        "SecondOrder",
    ),
    "declaration.itinerary": (
        "Itinerary",
        "Phase",
        "Reference",
    ),
    "declaration.parameter": ("Parameter",),
    "declaration.presentation": ("Presentation",),
    "declaration.source": ("Source",),
    "declaration.system": ("System",),
    "declaration.transition": (
        "Condition",
        "Transition",
    ),
    "equations.derivation": ("derive_equations",),
    "equations.equation_system": ("EquationSystem",),
    "errors": (
        "DeclarationError",
        "DerivationError",
    ),
    # what systems and equations ask for, though it stands above them
    "codegen.emit": ("emit_library",),
    "codegen.python_file": ("emit_python",),
    "document.describe": ("equation_latex", "equation_lines", "expression_latex"),
    "document.hypertext": ("equation_html",),
}
register({name: f"nonsmooth.derive.{home}" for home, names in _HOMES.items() for name in names})


def __getattr__(name: str) -> object:
    """Import a public name when it is first asked for (PEP 562)."""
    if name == "dry_friction":
        return import_module("nonsmooth.derive.systems.dry_friction")
    if name in __all__:
        return registered(name)
    raise AttributeError(f"module 'nonsmooth.derive' has no attribute {name!r}")


def __dir__() -> list[str]:
    """List the public names, imported or not."""
    return sorted(__all__)
