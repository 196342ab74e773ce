"""A composed orbit as JSON: the entries of the others, and its phases."""

from __future__ import annotations

from typing import Any

from nonsmooth.runtime.core.values import decimal_string
from nonsmooth.runtime.orbits.composed_orbit import ComposedOrbit
from nonsmooth.runtime.shooting.section_map import ComposedStability

__all__ = ["composed_json"]


def composed_json(orbit: ComposedOrbit, digits: int | None = None) -> dict[str, Any]:
    """An orbit with stability and admissibility; numbers as decimal strings.

    Parameters
    ----------
    orbit : ComposedOrbit
    digits : int, optional
        Fewer digits than the orbit has.

    Raises
    ------
    InputError
        If there is no orbit.
    """
    from nonsmooth.runtime.present.report import admissibility_json, short

    shown = orbit.digits if digits is None else min(digits, orbit.digits)

    def text(number: Any) -> str:
        return decimal_string(number, shown)

    def multipliers(stability: ComposedStability) -> list[dict[str, Any]]:
        return [
            {"re": text(m.real), "im": text(m.imaginary), "trivial": m.trivial}
            for m in stability.multipliers
        ]

    stability = orbit.stability
    shift = {name: text(by) for name, by in orbit.shift.items() if orbit.translates(name)}
    times = zip(orbit.itinerary, orbit.dwell_time_names, strict=True)
    return {
        "orbit": orbit.name,
        "parameters": {
            name: text(orbit.arithmetic.number(value) if orbit.precise else float(value))
            for name, value in orbit.given.items()
        },
        "unknowns": {name: text(value) for name, value in orbit.unknowns.items()},
        "period": text(orbit.period),
        **({"shift": shift} if shift else {}),
        "residual": short(orbit.residual),
        "digits": shown,
        "multipliers": multipliers(stability),
        "trace": text(stability.trace),
        "margin": text(stability.margin),
        "stability": stability.verdict,
        **admissibility_json(orbit),
        **(
            {"part_multipliers": multipliers(orbit.part_stability)}
            if orbit.symmetry is not None
            else {}
        ),
        "phases": [
            {"configuration": configuration, "boundary": boundary, "dwell_time": name}
            for (configuration, boundary), name in times
        ],
    }
