"""Piecewise-linear oscillators with impacts and dry friction.

The public names, each imported when it is first used. Systems are declared with
`nonsmooth.derive`; see ``nonsmooth --help`` for the command line.
"""

from importlib import import_module
from typing import TYPE_CHECKING

from nonsmooth.runtime.core.registry import register

if TYPE_CHECKING:
    from nonsmooth._certify import certify
    from nonsmooth.runtime.core.differentiable import DifferentiableFunction
    from nonsmooth.runtime.core.errors import (
        InputError,
        Interrupted,
        MissingExtra,
        NoConvergence,
        NonsmoothError,
    )
    from nonsmooth.runtime.explore.charting.chart import chart
    from nonsmooth.runtime.explore.continuation.branch import Branch
    from nonsmooth.runtime.explore.continuation.continue_event import Locus
    from nonsmooth.runtime.explore.continuation.continue_orbit import continue_orbit
    from nonsmooth.runtime.explore.continuation.event import Event
    from nonsmooth.runtime.explore.design.design import design
    from nonsmooth.runtime.explore.design.optimum import Design
    from nonsmooth.runtime.explore.finding.find import find_orbits
    from nonsmooth.runtime.explore.finding.found import Found
    from nonsmooth.runtime.explore.finding.sweep import Sweep, sweep
    from nonsmooth.runtime.explore.fitting.fit import fit
    from nonsmooth.runtime.explore.fitting.fit_record import Fit
    from nonsmooth.runtime.explore.fitting.measurements import Experiment
    from nonsmooth.runtime.orbits.derivatives import orbit_function
    from nonsmooth.runtime.orbits.motion import Motion
    from nonsmooth.runtime.orbits.orbit import Orbit, Orbits
    from nonsmooth.runtime.orbits.refine import refine
    from nonsmooth.runtime.orbits.solve import solve
    from nonsmooth.runtime.present.checking.check_file import Check
    from nonsmooth.runtime.present.files.loading import load
    from nonsmooth.runtime.proof.basin.basin_certificate import BasinCertificate
    from nonsmooth.runtime.proof.boxes.box_certificate import BoxCertificate
    from nonsmooth.runtime.proof.branch.certified_branch import CertifiedBranch
    from nonsmooth.runtime.proof.certificate import Certificate
    from nonsmooth.runtime.proof.chaos.chaos_certificate import ChaosCertificate
    from nonsmooth.runtime.proof.counting.census import Census
    from nonsmooth.runtime.proof.doubling.certified_doubling import CertifiedDoubling
    from nonsmooth.runtime.proof.events.event_certificate import EventCertificate
    from nonsmooth.runtime.proof.graphs.graph_certificate import GraphCertificate
    from nonsmooth.runtime.proof.motion.motion_proof import Proof
    from nonsmooth.runtime.simulation.engines import Trajectories
    from nonsmooth.runtime.simulation.last_cycle import Recurrence, itinerary_of
    from nonsmooth.runtime.simulation.lyapunov import lyapunov
    from nonsmooth.runtime.simulation.motion_function import motion_function
    from nonsmooth.runtime.simulation.observables import observe
    from nonsmooth.runtime.simulation.returns import PoincareMap, poincare_map
    from nonsmooth.runtime.simulation.simulate import simulate
    from nonsmooth.runtime.simulation.trajectory import Trajectory

    __version__: str

__all__ = [
    "BasinCertificate",
    "BoxCertificate",
    "Branch",
    "Census",
    "Certificate",
    "CertifiedBranch",
    "CertifiedDoubling",
    "ChaosCertificate",
    "Check",
    "Design",
    "DifferentiableFunction",
    "Event",
    "EventCertificate",
    "Experiment",
    "Fit",
    "Found",
    "GraphCertificate",
    "InputError",
    "Interrupted",
    "Locus",
    "MissingExtra",
    "Motion",
    "NoConvergence",
    "NonsmoothError",
    "Orbit",
    "Orbits",
    "PoincareMap",
    "Proof",
    "Recurrence",
    "Sweep",
    "Trajectories",
    "Trajectory",
    "__version__",
    "certify",
    "chart",
    "continue_orbit",
    "design",
    "find_orbits",
    "fit",
    "itinerary_of",
    "load",
    "lyapunov",
    "motion_function",
    "observe",
    "orbit_function",
    "poincare_map",
    "refine",
    "simulate",
    "solve",
    "sweep",
]

_HOMES = {
    "BoxCertificate": "runtime.proof.boxes.box_certificate",
    "Census": "runtime.proof.counting.census",
    "Check": "runtime.present.checking.check_file",
    "Certificate": "runtime.proof.certificate",
    "CertifiedBranch": "runtime.proof.branch.certified_branch",
    "CertifiedDoubling": "runtime.proof.doubling.certified_doubling",
    "BasinCertificate": "runtime.proof.basin.basin_certificate",
    "ChaosCertificate": "runtime.proof.chaos.chaos_certificate",
    "DifferentiableFunction": "runtime.core.differentiable",
    "Branch": "runtime.explore.continuation.branch",
    "Design": "runtime.explore.design.optimum",
    "Event": "runtime.explore.continuation.event",
    "EventCertificate": "runtime.proof.events.event_certificate",
    "Experiment": "runtime.explore.fitting.measurements",
    "Fit": "runtime.explore.fitting.fit_record",
    "Found": "runtime.explore.finding.found",
    "GraphCertificate": "runtime.proof.graphs.graph_certificate",
    "InputError": "runtime.core.errors",
    "Interrupted": "runtime.core.errors",
    "Locus": "runtime.explore.continuation.continue_event",
    "MissingExtra": "runtime.core.errors",
    "Motion": "runtime.orbits.motion",
    "NoConvergence": "runtime.core.errors",
    "NonsmoothError": "runtime.core.errors",
    "Orbit": "runtime.orbits.orbit",
    "Orbits": "runtime.orbits.orbit",
    "PoincareMap": "runtime.simulation.returns",
    "Proof": "runtime.proof.motion.motion_proof",
    "Recurrence": "runtime.simulation.last_cycle",
    "Sweep": "runtime.explore.finding.sweep",
    "Trajectories": "runtime.simulation.engines",
    "Trajectory": "runtime.simulation.trajectory",
    "certify": "_certify",
    "chart": "runtime.explore.charting.chart",
    "continue_orbit": "runtime.explore.continuation.continue_orbit",
    "design": "runtime.explore.design.design",
    "find_orbits": "runtime.explore.finding.find",
    "fit": "runtime.explore.fitting.fit",
    "itinerary_of": "runtime.simulation.last_cycle",
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

# where the records' `plot`, `save` and displays stand: above them, and imported when asked for
register(
    "nonsmooth.runtime",
    {
        "design_json": "present.answers",
        "draw_basin": "present.pictures.certified_basins",
        "draw_box": "present.pictures.proven_maps",
        "draw_chaos": "present.pictures.horseshoes",
        "draw_graph": "present.pictures.box_graphs",
        "draw_branch": "present.pictures.branches",
        "draw_certified_branch": "present.pictures.certified_branches",
        "draw_doubling": "present.pictures.certified_branches",
        "draw_design": "present.pictures.designs",
        "draw_locus": "present.pictures.branches",
        "draw_sweep": "present.pictures.maps",
        "fit_figure": "present.pictures.fits",
        "fit_json": "present.answers",
        "found_held": "present.files.found",
        "held_found": "present.files.found",
        "itinerary_of": "simulation.last_cycle",
        "motion_derivatives": "simulation.derivatives",
        "orbit_derivatives": "orbits.derivatives",
        "orbit_json": "present.report",
        "orbit_latex": "present.tell",
        "plot_fit": "present.pictures.fits",
        "plot_orbit": "present.pictures.plot",
        "plot_trajectory": "present.pictures.plot",
        "result_html": "present.tell",
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
    else:
        raise AttributeError(f"module 'nonsmooth' has no attribute {name!r}")
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    """List the public names, imported or not."""
    return sorted(__all__)
