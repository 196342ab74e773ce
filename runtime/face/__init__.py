"""Piecewise-linear oscillators with impacts and dry friction.

The public names, each imported when it is first used. Systems are declared with
`nonsmooth.derive`; see ``nonsmooth --help`` for the command line.
"""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from nonsmooth.runtime.batch import Orbits, solve_many
    from nonsmooth.runtime.errors import InputError, MissingExtra, NoConvergence, NonsmoothError
    from nonsmooth.runtime.motion import Motion
    from nonsmooth.runtime.orbit import Orbit
    from nonsmooth.runtime.refine import refine
    from nonsmooth.runtime.saved import load_orbit_file as load
    from nonsmooth.runtime.saved_trajectory import load_trajectory
    from nonsmooth.runtime.simulate import Trajectories, simulate, simulate_many
    from nonsmooth.runtime.solve import solve
    from nonsmooth.runtime.trajectory import Trajectory

    __version__: str

__all__ = [
    "InputError",
    "MissingExtra",
    "Motion",
    "NoConvergence",
    "NonsmoothError",
    "Orbit",
    "Orbits",
    "Trajectories",
    "Trajectory",
    "__version__",
    "load",
    "load_trajectory",
    "refine",
    "simulate",
    "simulate_many",
    "solve",
    "solve_many",
]

_HOMES = {
    "InputError": "errors",
    "MissingExtra": "errors",
    "Motion": "motion",
    "NoConvergence": "errors",
    "NonsmoothError": "errors",
    "Orbit": "orbit",
    "Orbits": "batch",
    "Trajectories": "simulate",
    "Trajectory": "trajectory",
    "load": "saved:load_orbit_file",
    "load_trajectory": "saved_trajectory",
    "refine": "refine",
    "simulate": "simulate",
    "simulate_many": "simulate",
    "solve": "solve",
    "solve_many": "batch",
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
