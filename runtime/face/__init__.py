"""Piecewise-linear oscillators with impacts and dry friction.

The public names, each imported when it is first used. Systems are declared with
`nonsmooth.derive`; see ``nonsmooth --help`` for the command line.
"""

from importlib import import_module
from types import FunctionType
from typing import TYPE_CHECKING

from nonsmooth.runtime.core.registry import register

if TYPE_CHECKING:
    from nonsmooth._certify import certify as certify
    from nonsmooth.runtime.core.differentiable import (
        DifferentiableFunction as DifferentiableFunction,
    )
    from nonsmooth.runtime.core.errors import InputError as InputError
    from nonsmooth.runtime.core.errors import Interrupted as Interrupted
    from nonsmooth.runtime.core.errors import MissingExtra as MissingExtra
    from nonsmooth.runtime.core.errors import NoConvergence as NoConvergence
    from nonsmooth.runtime.core.errors import NonsmoothError as NonsmoothError
    from nonsmooth.runtime.explore.charting.chart import chart as chart
    from nonsmooth.runtime.explore.continuation.continue_orbit import (
        continue_orbit as continue_orbit,
    )
    from nonsmooth.runtime.explore.design.design import design as design
    from nonsmooth.runtime.explore.finding.find import find_orbits as find_orbits
    from nonsmooth.runtime.explore.finding.sweep import sweep as sweep
    from nonsmooth.runtime.explore.fitting.fit import fit as fit
    from nonsmooth.runtime.explore.fitting.measurements import Experiment as Experiment
    from nonsmooth.runtime.orbits.derivatives import orbit_function as orbit_function
    from nonsmooth.runtime.orbits.refine import refine as refine
    from nonsmooth.runtime.orbits.solve import solve as solve
    from nonsmooth.runtime.present.files.loading import load as load
    from nonsmooth.runtime.simulation.lyapunov import lyapunov as lyapunov
    from nonsmooth.runtime.simulation.motion_function import motion_function as motion_function
    from nonsmooth.runtime.simulation.observables import observe as observe
    from nonsmooth.runtime.simulation.recurrence import itinerary_of as itinerary_of
    from nonsmooth.runtime.simulation.returns import poincare_map as poincare_map
    from nonsmooth.runtime.simulation.simulate import simulate as simulate

    __version__: str

_HOMES = {
    "DifferentiableFunction": "runtime.core.differentiable",
    "Experiment": "runtime.explore.fitting.measurements",
    "InputError": "runtime.core.errors",
    "Interrupted": "runtime.core.errors",
    "MissingExtra": "runtime.core.errors",
    "NoConvergence": "runtime.core.errors",
    "NonsmoothError": "runtime.core.errors",
    "certify": "_certify",
    "chart": "runtime.explore.charting.chart",
    "continue_orbit": "runtime.explore.continuation.continue_orbit",
    "design": "runtime.explore.design.design",
    "find_orbits": "runtime.explore.finding.find",
    "fit": "runtime.explore.fitting.fit",
    "itinerary_of": "runtime.simulation.recurrence",
    "load": "runtime.present.files.loading",
    "lyapunov": "runtime.simulation.lyapunov",
    "motion_function": "runtime.simulation.motion_function",
    "observe": "runtime.simulation.observables",
    "orbit_function": "runtime.orbits.derivatives",
    "poincare_map": "runtime.simulation.returns",
    "refine": "runtime.orbits.refine",
    "simulate": "runtime.simulation.simulate",
    "solve": "runtime.orbits.solve",
    "sweep": "runtime.explore.finding.sweep",
}
__all__ = [*_HOMES, "__version__"]

# where the records' `plot`, `save` and displays stand: above them, and imported when asked for
register(
    "nonsmooth.runtime",
    {
        "draw_basin": "present.pictures.sections",
        "draw_box": "present.pictures.proven_ranges",
        "draw_chaos": "present.pictures.sections",
        "draw_graph": "present.pictures.sections",
        "draw_branch": "present.pictures.branches",
        "draw_certified_branch": "present.pictures.proven_ranges",
        "draw_doubling": "present.pictures.proven_ranges",
        "draw_design": "present.pictures.designs",
        "draw_locus": "present.pictures.branches",
        "draw_sweep": "present.pictures.found",
        "fit_figure": "present.pictures.fits",
        "found_figure": "present.pictures.found",
        "found_held": "present.files.found",
        "held_found": "present.files.found",
        "itinerary_of": "simulation.recurrence",
        "motion_derivatives": "simulation.derivatives",
        "orbit_content": "orbits.orbit_file",
        "orbit_derivatives": "orbits.derivatives",
        "orbit_in": "orbits.orbit_file",
        "orbit_latex": "present.tell",
        "plot_fit": "present.pictures.fits",
        "plot_motion": "present.pictures.plot",
        "result_html": "present.tell",
        "result_json": "present.answers",
        "result_text": "present.tell",
        "save_found": "present.files.found",
        "save_orbit": "orbits.orbit_file",
        "save_result": "present.files.kept",
        "save_trajectory": "present.files.motions",
        "saved_kernels": "present.files.named_entries",
    },
)


def __getattr__(name: str) -> object:
    """Import a public name when it is first asked for (PEP 562)."""
    if name == "__version__":
        from importlib.metadata import version

        value: object = version("nonsmooth")
    elif name in _HOMES:
        value = getattr(import_module(f"nonsmooth.{_HOMES[name]}"), name)
        if isinstance(value, FunctionType):
            from nonsmooth.runtime.core.arguments import checked

            value = checked(value)
            value.__module__ = __name__  # by which pickle finds it
    else:
        raise AttributeError(f"module 'nonsmooth' has no attribute {name!r}")
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    """List the public names, imported or not."""
    return sorted(__all__)
