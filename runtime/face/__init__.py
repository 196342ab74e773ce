"""Piecewise-linear oscillators with impacts and dry friction.

The public names, each imported when it is first used. Systems are declared with
`nonsmooth.derive`; see ``nonsmooth --help`` for the command line.
"""

from importlib import import_module
from typing import TYPE_CHECKING

from nonsmooth.runtime.core.registry import register

if TYPE_CHECKING:
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
    from nonsmooth.runtime.explore.continuation.continue_event import Locus, continue_event
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
    from nonsmooth.runtime.orbits.many import Orbits, solve_many
    from nonsmooth.runtime.orbits.motion import Motion
    from nonsmooth.runtime.orbits.orbit import Orbit
    from nonsmooth.runtime.orbits.orbit_function import orbit_function
    from nonsmooth.runtime.orbits.refine import refine
    from nonsmooth.runtime.orbits.solve import solve
    from nonsmooth.runtime.present.checking.check_file import Check, check_certificate
    from nonsmooth.runtime.present.files.loading import load
    from nonsmooth.runtime.proof.basin.basin_certificate import BasinCertificate
    from nonsmooth.runtime.proof.basin.certify_basin import certify_basin
    from nonsmooth.runtime.proof.boxes.box_certificate import BoxCertificate
    from nonsmooth.runtime.proof.boxes.certify_box import certify_box
    from nonsmooth.runtime.proof.branch.certified_branch import CertifiedBranch
    from nonsmooth.runtime.proof.branch.certify_branch import certify_branch
    from nonsmooth.runtime.proof.certificate import Certificate
    from nonsmooth.runtime.proof.certify_orbit import certify
    from nonsmooth.runtime.proof.chaos.certify_chaos import certify_chaos
    from nonsmooth.runtime.proof.chaos.chaos_certificate import ChaosCertificate
    from nonsmooth.runtime.proof.counting.census import Census
    from nonsmooth.runtime.proof.counting.certify_all import certify_all
    from nonsmooth.runtime.proof.doubling.certified_doubling import CertifiedDoubling
    from nonsmooth.runtime.proof.doubling.certify_doubling import certify_doubling
    from nonsmooth.runtime.proof.events.certify_event import certify_event
    from nonsmooth.runtime.proof.events.event_certificate import EventCertificate
    from nonsmooth.runtime.proof.graphs.certify_graph import certify_graph
    from nonsmooth.runtime.proof.graphs.graph_certificate import GraphCertificate
    from nonsmooth.runtime.proof.motion.motion_proof import Proof
    from nonsmooth.runtime.proof.motion.validate import validate
    from nonsmooth.runtime.simulation.engines import Trajectories
    from nonsmooth.runtime.simulation.last_cycle import Recurrence, itinerary_of
    from nonsmooth.runtime.simulation.lyapunov import lyapunov
    from nonsmooth.runtime.simulation.motion_function import motion_function
    from nonsmooth.runtime.simulation.observables import observe
    from nonsmooth.runtime.simulation.returns import PoincareMap, poincare_map
    from nonsmooth.runtime.simulation.simulate import simulate, simulate_many
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
    "certify_all",
    "certify_basin",
    "certify_box",
    "certify_branch",
    "certify_chaos",
    "certify_doubling",
    "certify_event",
    "certify_graph",
    "chart",
    "check_certificate",
    "continue_event",
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
    "simulate_many",
    "solve",
    "solve_many",
    "sweep",
    "validate",
]

_HOMES = {
    "BoxCertificate": "proof.boxes.box_certificate",
    "Census": "proof.counting.census",
    "Check": "present.checking.check_file",
    "Certificate": "proof.certificate",
    "CertifiedBranch": "proof.branch.certified_branch",
    "CertifiedDoubling": "proof.doubling.certified_doubling",
    "BasinCertificate": "proof.basin.basin_certificate",
    "ChaosCertificate": "proof.chaos.chaos_certificate",
    "DifferentiableFunction": "core.differentiable",
    "Branch": "explore.continuation.branch",
    "Design": "explore.design.optimum",
    "Event": "explore.continuation.event",
    "EventCertificate": "proof.events.event_certificate",
    "Experiment": "explore.fitting.measurements",
    "Fit": "explore.fitting.fit_record",
    "Found": "explore.finding.found",
    "GraphCertificate": "proof.graphs.graph_certificate",
    "InputError": "core.errors",
    "Interrupted": "core.errors",
    "Locus": "explore.continuation.continue_event",
    "MissingExtra": "core.errors",
    "Motion": "orbits.motion",
    "NoConvergence": "core.errors",
    "NonsmoothError": "core.errors",
    "Orbit": "orbits.orbit",
    "Orbits": "orbits.orbit_arrays",
    "PoincareMap": "simulation.returns",
    "Proof": "proof.motion.motion_proof",
    "Recurrence": "simulation.last_cycle",
    "Sweep": "explore.finding.sweep",
    "Trajectories": "simulation.engines",
    "Trajectory": "simulation.trajectory",
    "certify": "proof.certify_orbit",
    "certify_box": "proof.boxes.certify_box",
    "certify_branch": "proof.branch.certify_branch",
    "certify_basin": "proof.basin.certify_basin",
    "certify_chaos": "proof.chaos.certify_chaos",
    "certify_doubling": "proof.doubling.certify_doubling",
    "certify_event": "proof.events.certify_event",
    "certify_graph": "proof.graphs.certify_graph",
    "certify_all": "proof.counting.certify_all",
    "check_certificate": "present.checking.check_file",
    "chart": "explore.charting.chart",
    "continue_event": "explore.continuation.continue_event",
    "continue_orbit": "explore.continuation.continue_orbit",
    "design": "explore.design.design",
    "find_orbits": "explore.finding.find",
    "fit": "explore.fitting.fit",
    "itinerary_of": "simulation.last_cycle",
    "load": "present.files.loading",
    "lyapunov": "simulation.lyapunov",
    "motion_function": "simulation.motion_function",
    "observe": "simulation.observables",
    "orbit_function": "orbits.orbit_function",
    "poincare_map": "simulation.returns",
    "refine": "orbits.refine",
    "simulate": "simulation.simulate",
    "simulate_many": "simulation.simulate",
    "solve": "orbits.solve",
    "solve_many": "orbits.many",
    "sweep": "explore.finding.sweep",
    "validate": "proof.motion.validate",
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
        value = getattr(import_module(f"nonsmooth.runtime.{_HOMES[name]}"), name)
    else:
        raise AttributeError(f"module 'nonsmooth' has no attribute {name!r}")
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    """List the public names, imported or not."""
    return sorted(__all__)
