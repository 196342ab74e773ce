"""Results as JSON and as text: numbers with the digits they have."""

from __future__ import annotations

from typing import Any

from nonsmooth.runtime.orbit import Orbit
from nonsmooth.runtime.values import decimal_string

__all__ = ["admissibility_json", "orbit_json"]


def orbit_json(orbit: Orbit, digits: int | None = None) -> dict[str, Any]:
    """An orbit with stability and admissibility; numbers as decimal strings.

    `unknowns` are what was solved for, `parameters` what was given, with three digits more
    than the error bound 10^-digits max(1, |x|) needs.

    Parameters
    ----------
    orbit : Orbit
    digits : int, optional
        Fewer digits than the orbit has.
    """
    shown = orbit.digits if digits is None else min(digits, orbit.digits)

    def text(number: Any) -> str:
        return decimal_string(number, shown)

    stability = orbit.stability
    return {
        "orbit": orbit.name,
        "parameters": {name: text(orbit.values[name]) for name in orbit.given}
        | {name: text(float(value)) for name, value in orbit.opened.items()},
        "unknowns": {name: text(value) for name, value in orbit.unknowns.items()},
        "period": text(orbit.period),
        "residual": short(orbit.residual),
        "digits": shown,
        "multipliers": [
            {"re": text(m.real), "im": text(m.imaginary), "trivial": m.trivial}
            for m in stability.multipliers
        ],
        "trace": text(stability.trace),
        "margin": text(stability.margin),
        "stability": stability.verdict,
        **admissibility_json(orbit),
    }


def admissibility_json(orbit: Orbit) -> dict[str, Any]:
    """Verdict, and what it rests on: violations, or bounds on the open parameters."""
    admissibility = orbit.admissibility
    found: dict[str, Any] = {"admissible": admissibility.verdict}
    if admissibility.verdict is False:
        found["violations"] = [
            {
                "phase": v.phase,
                "configuration": v.configuration,
                "boundary": v.boundary,
                "time": repr(v.time),
                "excess": repr(v.excess),
            }
            for v in admissibility.violations
        ]
    if admissibility.verdict == "conditional":
        found["requires"] = [
            {"parameter": r.parameter, "greater_than": repr(r.greater_than)}
            for r in admissibility.requires
        ]
    return found


def short(number: Any) -> str:
    """A small number to three digits; its size is what counts."""
    from mpmath import mp

    return str(mp.nstr(mp.mpf(number), 3))
