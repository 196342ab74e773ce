"""Names of a composed orbit's unknowns, and names as people see them."""

from __future__ import annotations

import os
from collections.abc import Container, Mapping, Sequence

__all__ = ["cycle_label", "dwell_names", "shown_name", "start_names"]


def cycle_label(system: str, count: int) -> str:
    """What an orbit of so many phases is called that no declaration names."""
    return f"{system}, {count} phase{'' if count == 1 else 's'}"


def dwell_names(count: int, taken: Container[str]) -> tuple[str, ...]:
    """Names of dwell times that were not declared: tau1, tau2, ... where these are free."""
    stem = "tau"
    while any(f"{stem}{i}" in taken for i in range(1, count + 1)):
        stem = f"dwell_{stem}"
    return tuple(f"{stem}{i}" for i in range(1, count + 1))


def start_names(
    states: Sequence[str], taken: Container[str], declared: Mapping[str, str] | None = None
) -> tuple[str, ...]:
    """Names of the states at the start: those declared, or x10 for x1 where that is free."""
    known = declared or {}
    return tuple(
        known.get(name, name if f"{name}0" in taken or f"{name}0" in states else f"{name}0")
        for name in states
    )


def shown_name(name: str) -> str:
    """System, or system/orbit, of a name that may be that of a file or of an orbit in one.

    Examples
    --------
    >>> shown_name("/home/me/gear.py:rattle"), shown_name("dry-friction/symmetric")
    ('gear/rattle', 'dry-friction/symmetric')
    """
    if not (os.path.isabs(name) or ":" in name or name.endswith(".py")):
        return name
    system, _, orbit = os.path.basename(name).partition(":")
    return "/".join(filter(None, (system.removesuffix(".py"), orbit)))
