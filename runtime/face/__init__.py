"""Piecewise-linear oscillators with impacts and dry friction.

The public names, each imported when it is first used. Systems are declared with
`nonsmooth.derive`; see ``nonsmooth --help`` for the command line.
"""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from nonsmooth.runtime.batch import Orbits, solve_many
    from nonsmooth.runtime.certification.boxes.certify import certify_box
    from nonsmooth.runtime.certification.boxes.record import BoxCertificate
    from nonsmooth.runtime.certification.boxes.saved import load_box_certificate
    from nonsmooth.runtime.certification.certificate import Certificate
    from nonsmooth.runtime.certification.certify import certify
    from nonsmooth.runtime.certification.checking import Check, check_certificate
    from nonsmooth.runtime.certification.counting.census import Census
    from nonsmooth.runtime.certification.counting.count import certify_all
    from nonsmooth.runtime.certification.counting.saved import load_census
    from nonsmooth.runtime.certification.events.certify import certify_event
    from nonsmooth.runtime.certification.events.record import EventCertificate
    from nonsmooth.runtime.certification.events.saved import load_event_certificates
    from nonsmooth.runtime.certification.saved import load_certificate
    from nonsmooth.runtime.charting.chart import chart, load_chart
    from nonsmooth.runtime.composition.composed import ComposedOrbit, compose, compose_many
    from nonsmooth.runtime.composition.recurring import Recurrence, itinerary_of
    from nonsmooth.runtime.continuation.branch import continue_orbit
    from nonsmooth.runtime.continuation.event import Event
    from nonsmooth.runtime.continuation.locus import Locus
    from nonsmooth.runtime.continuation.plane import continue_event
    from nonsmooth.runtime.continuation.record import Branch
    from nonsmooth.runtime.continuation.saved import load_branch
    from nonsmooth.runtime.continuation.saved_locus import load_locus
    from nonsmooth.runtime.errors import (
        InputError,
        Interrupted,
        MissingExtra,
        NoConvergence,
        NonsmoothError,
    )
    from nonsmooth.runtime.finding.find import Found, find_orbits
    from nonsmooth.runtime.finding.saved import load_found
    from nonsmooth.runtime.finding.saved_sweep import load_sweep
    from nonsmooth.runtime.finding.sweep import Sweep, sweep
    from nonsmooth.runtime.motion import Motion
    from nonsmooth.runtime.observing.lyapunov import lyapunov
    from nonsmooth.runtime.observing.observables import observe
    from nonsmooth.runtime.orbit import Orbit
    from nonsmooth.runtime.refine import refine
    from nonsmooth.runtime.saved import load_orbit_file as load
    from nonsmooth.runtime.simulation.returns import PoincareMap, poincare_map
    from nonsmooth.runtime.simulation.saved import load_trajectory
    from nonsmooth.runtime.simulation.simulate import Trajectories, simulate, simulate_many
    from nonsmooth.runtime.simulation.trajectory import Trajectory
    from nonsmooth.runtime.solve import solve
    from nonsmooth.runtime.validation.proof import Proof
    from nonsmooth.runtime.validation.validate import validate

    __version__: str

__all__ = [
    "BoxCertificate",
    "Branch",
    "Census",
    "Certificate",
    "Check",
    "ComposedOrbit",
    "Event",
    "EventCertificate",
    "Found",
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
    "certify_box",
    "certify_event",
    "chart",
    "check_certificate",
    "compose",
    "compose_many",
    "continue_event",
    "continue_orbit",
    "find_orbits",
    "itinerary_of",
    "load",
    "load_box_certificate",
    "load_branch",
    "load_census",
    "load_certificate",
    "load_chart",
    "load_event_certificates",
    "load_found",
    "load_locus",
    "load_sweep",
    "load_trajectory",
    "lyapunov",
    "observe",
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
    "BoxCertificate": "certification.boxes.record",
    "Census": "certification.counting.census",
    "Check": "certification.checking",
    "Certificate": "certification.certificate",
    "Branch": "continuation.record",
    "ComposedOrbit": "composition.composed",
    "Event": "continuation.event",
    "EventCertificate": "certification.events.record",
    "Found": "finding.find",
    "InputError": "errors",
    "Interrupted": "errors",
    "Locus": "continuation.locus",
    "MissingExtra": "errors",
    "Motion": "motion",
    "NoConvergence": "errors",
    "NonsmoothError": "errors",
    "Orbit": "orbit",
    "Orbits": "batch",
    "PoincareMap": "simulation.returns",
    "Proof": "validation.proof",
    "Recurrence": "composition.recurring",
    "Sweep": "finding.sweep",
    "Trajectories": "simulation.simulate",
    "Trajectory": "simulation.trajectory",
    "certify": "certification.certify",
    "certify_box": "certification.boxes.certify",
    "certify_event": "certification.events.certify",
    "certify_all": "certification.counting.count",
    "check_certificate": "certification.checking",
    "chart": "charting.chart",
    "compose": "composition.composed",
    "compose_many": "composition.composed",
    "continue_event": "continuation.plane",
    "continue_orbit": "continuation.branch",
    "find_orbits": "finding.find",
    "itinerary_of": "composition.recurring",
    "load": "saved:load_orbit_file",
    "load_box_certificate": "certification.boxes.saved",
    "load_census": "certification.counting.saved",
    "load_certificate": "certification.saved",
    "load_chart": "charting.chart",
    "load_event_certificates": "certification.events.saved",
    "load_branch": "continuation.saved",
    "load_found": "finding.saved",
    "load_locus": "continuation.saved_locus",
    "load_sweep": "finding.saved_sweep",
    "load_trajectory": "simulation.saved",
    "lyapunov": "observing.lyapunov",
    "observe": "observing.observables",
    "poincare_map": "simulation.returns",
    "refine": "refine",
    "simulate": "simulation.simulate",
    "simulate_many": "simulation.simulate",
    "solve": "solve",
    "solve_many": "batch",
    "sweep": "finding.sweep",
    "validate": "validation.validate",
}


def __getattr__(name: str) -> object:
    """Import a public name when it is first asked for (PEP 562)."""
    if name == "__version__":
        from importlib.metadata import version

        value: object = version("nonsmooth")
    elif name in _HOMES:
        home, _, its_name = _HOMES[name].partition(":")
        value = getattr(import_module(f"nonsmooth.runtime.{home}"), its_name or name)
    else:
        raise AttributeError(f"module 'nonsmooth' has no attribute {name!r}")
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    """List the public names, imported or not."""
    return sorted(__all__)
