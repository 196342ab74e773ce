"""A mass on a spring and a damper, under forces in proportion to cosines, with what it touches."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from nonsmooth.derive import Harmonic, System, oscillator

__all__ = ["one_mass"]


def one_mass(
    name: str, *elements: Any, forces: Mapping[Any, Any] | None = None, mass: Any = 1,
    damping: Any = 0, stiffness: Any = 1, **options: Any,
) -> System:  # fmt: skip
    """The oscillator of the coordinate x; forces are amplitudes by their frequencies."""
    return oscillator(
        name, ["x"], [[mass]], [[stiffness]], [[damping]], elements=elements,
        forcing=[Harmonic(w, cosine=[force]) for w, force in (forces or {}).items()],
        **options,
    )  # fmt: skip
