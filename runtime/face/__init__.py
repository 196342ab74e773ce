"""Piecewise-linear oscillators with impacts and dry friction.

The public names, each imported when it is first used. Systems are declared with
`nonsmooth.derive`; see ``nonsmooth --help`` for the command line.
"""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from nonsmooth.runtime.batch import Orbits, solve_many
    from nonsmooth.runtime.composed import ComposedOrbit, compose, compose_many
    from nonsmooth.runtime.errors import InputError, MissingExtra, NoConvergence, NonsmoothError
    from nonsmooth.runtime.find import Found, find_orbits
    from nonsmooth.runtime.lyapunov import lyapunov
    from nonsmooth.runtime.motion import Motion
    from nonsmooth.runtime.observables import observe
    from nonsmooth.runtime.orbit import Orbit
    from nonsmooth.runtime.proof import Proof
    from nonsmooth.runtime.refine import refine
    from nonsmooth.runtime.report_found import load_found
    from nonsmooth.runtime.returns import PoincareMap, poincare_map
    from nonsmooth.runtime.saved import load_orbit_file as load
    from nonsmooth.runtime.saved_trajectory import load_trajectory
    from nonsmooth.runtime.simulate import Trajectories, simulate, simulate_many
    from nonsmooth.runtime.solve import solve
    from nonsmooth.runtime.trajectory import Trajectory
    from nonsmooth.runtime.validated import validate

    __version__: str

__all__ = [
    "ComposedOrbit",
    "Found",
    "InputError",
    "MissingExtra",
    "Motion",
    "NoConvergence",
    "NonsmoothError",
    "Orbit",
    "Orbits",
    "PoincareMap",
    "Proof",
    "Trajectories",
    "Trajectory",
    "__version__",
    "compose",
    "compose_many",
    "find_orbits",
    "load",
    "load_found",
    "load_trajectory",
    "lyapunov",
    "observe",
    "poincare_map",
    "refine",
    "simulate",
    "simulate_many",
    "solve",
    "solve_many",
    "validate",
]

_HOMES = {
    "ComposedOrbit": "composed",
    "Found": "find",
    "InputError": "errors",
    "MissingExtra": "errors",
    "Motion": "motion",
    "NoConvergence": "errors",
    "NonsmoothError": "errors",
    "Orbit": "orbit",
    "Orbits": "batch",
    "PoincareMap": "returns",
    "Proof": "proof",
    "Trajectories": "simulate",
    "Trajectory": "trajectory",
    "compose": "composed",
    "compose_many": "composed",
    "find_orbits": "find",
    "load": "saved:load_orbit_file",
    "load_found": "report_found",
    "load_trajectory": "saved_trajectory",
    "lyapunov": "lyapunov",
    "observe": "observables",
    "poincare_map": "returns",
    "refine": "refine",
    "simulate": "simulate",
    "simulate_many": "simulate",
    "solve": "solve",
    "solve_many": "batch",
    "validate": "validated",
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
