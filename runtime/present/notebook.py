"""How an orbit shows itself in a notebook: a table, and formulas."""

from __future__ import annotations

from collections.abc import Iterable
from html import escape
from typing import TYPE_CHECKING

from nonsmooth.runtime.core.values import decimal_string
from nonsmooth.runtime.model.naming import itinerary_text, shown_name, symbol
from nonsmooth.runtime.present.report import orbit_json

if TYPE_CHECKING:
    from nonsmooth.runtime.explore.finding.found import Found
    from nonsmooth.runtime.orbits.orbit import Orbit

__all__ = ["found_html", "orbit_html", "orbit_latex", "table_html"]

_MOST_DIGITS = 50  # of a number in a formula


def _complex(real: str, imaginary: str) -> str:
    if not float(imaginary):
        return real
    return f"{real} {'-' if imaginary.startswith('-') else '+'} {imaginary.lstrip('-')} i"


def orbit_html(orbit: Orbit) -> str:
    """HTML of a compact table of an orbit, converged or not, for a notebook."""
    given = [f"{name} = {value}" for name, value in {**orbit.given, **orbit.opened}.items()]
    if not orbit.converged:
        return table_html(shown_name(orbit.name), [("given", given), ("status", [orbit.message])])
    found = orbit_json(orbit, min(orbit.digits, 15))
    unknowns = [f"{name} = {text}" for name, text in found["unknowns"].items()]
    multipliers = [
        _complex(m["re"], m["im"]) + " (trivial)" * m["trivial"] for m in found["multipliers"]
    ]
    admissible = [{True: "yes", False: "no"}.get(found["admissible"], "conditional, it takes")]
    admissible += [
        f"{bound['parameter']} > {float(bound['greater_than']):.10g}"
        for bound in found.get("requires", ())
    ]
    admissible += [
        f"{v['boundary']} is crossed in phase {v['phase']}, {v['configuration']},"
        f" at t = {float(v['time']):.6g} by {float(v['excess']):.6g}"
        for v in found.get("violations", ())
    ]
    return table_html(
        f"{shown_name(orbit.name)}, {orbit.digits} digits",
        [
            ("given", given),
            ("unknowns", unknowns),
            ("period", [found["period"]]),
            ("multipliers", multipliers),
            ("stability", [found["stability"]]),
            ("admissible", admissible),
        ],
    )


def orbit_latex(orbit: Orbit) -> str:
    """LaTeX of the unknowns of an orbit, converged or not, as aligned displayed equations."""
    if not orbit.converged:
        return rf"$$\text{{{orbit.name}: {orbit.message}}}$$"
    rows = []
    for name, value in orbit.unknowns.items():
        text = decimal_string(value, min(orbit.digits, _MOST_DIGITS))
        mantissa, _, exponent = text.partition("e")
        power = rf" \cdot 10^{{{int(exponent)}}}" if exponent else ""
        rows.append(f"{symbol(name)} &= {mantissa}{power}")
    body = " \\\\\n".join(rows)
    return f"$$\\begin{{aligned}}\n{body}\n\\end{{aligned}}$$"


def table_html(caption: str, rows: Iterable[tuple[str, Iterable[str]]]) -> str:
    """HTML of a table with a caption, whose rows are a name and the lines beside it."""
    left = 'style="text-align: left"'
    body = "".join(
        f"<tr><th {left}>{escape(name)}</th><td {left}>{'<br>'.join(map(escape, lines))}</td></tr>"
        for name, lines in rows
    )
    return f"<table><caption>{escape(caption)}</caption>{body}</table>"


def found_html(found: Found) -> str:
    """HTML of a table of found attractors, with a row for each and for all other outcomes."""
    rows = [
        (
            f"{place}",
            [orbit.solved]
            if isinstance(orbit.solved, str)
            else [f"period {orbit.period:.8g}, {orbit.verdict}", itinerary_text(orbit.itinerary)],
            orbit.share,
        )
        for place, orbit in enumerate(found.orbits, 1)
    ]
    rows += [
        (
            f"{place}",
            [entry.solved]
            if isinstance(entry.solved, str)
            else [f"equilibrium, {entry.solved.verdict}", entry.solved.configuration],
            entry.share,
        )
        for place, entry in enumerate(found.equilibria, len(found.orbits) + 1)
    ]
    rows += [("", [outcome.text], share) for outcome, share in found.outcomes.items()]
    return table_html(
        f"{found.system}, {len(found.starts)} starts",
        [(name, [*lines, f"{100 * share:.4g} % of the starts"]) for name, lines, share in rows],
    )
