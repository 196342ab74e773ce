"""Flows of those configurations that have a closed form in the parameters."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from nonsmooth.derive.declaration.configuration import Configuration
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.flows.modal import Flow, Spectrum, derive_flows

__all__ = ["closed_flows"]


def closed_flows(system: System, names: Iterable[str]) -> tuple[Spectrum, dict[str, Flow]]:
    """Spectrum and flows by name of those named configurations that have a closed form."""
    chosen = [system.configuration(name) for name in names]
    try:
        return derive_flows(_alone(system, chosen))
    except DerivationError:
        closed = [c for c in chosen if _is_closed(system, c)]
        return derive_flows(_alone(system, closed)) if closed else (Spectrum(), {})


def _is_closed(system: System, configuration: Configuration) -> bool:
    try:
        derive_flows(_alone(system, [configuration]))
    except DerivationError:
        return False
    return True


def _alone(system: System, configurations: Iterable[Configuration]) -> System:
    """A system of these configurations without boundaries, transitions and contacts."""
    motions = tuple(Configuration(c.name, c.dynamics, ()) for c in configurations)
    return replace(system, configurations=motions, transitions=(), contacts=())
