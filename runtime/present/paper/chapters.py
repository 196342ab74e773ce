"""The report: chapters in the order of the paper."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import asdict

from nonsmooth.runtime.model.naming import symbol
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.refine import refine
from nonsmooth.runtime.orbits.solve import solve
from nonsmooth.runtime.present.paper.appendix import appendix_tables
from nonsmooth.runtime.present.paper.claims import (
    admissible_periods,
    rigid_limit,
    saltation_matters,
    singular_periods,
    symmetric_portraits,
    trace_criterion,
)
from nonsmooth.runtime.present.paper.comparing import AGREES, DIGITS, compared
from nonsmooth.runtime.present.paper.misprints import misprints
from nonsmooth.runtime.present.paper.records import (
    Block,
    Chapter,
    Comparison,
    Comparisons,
    Equation,
    Finding,
    Report,
    ReportFigure,
    Table,
    Text,
)
from nonsmooth.runtime.present.report import orbit_json

__all__ = ["ORBITS", "paper_orbits", "paper_report"]

ORBITS = (
    "rigid-stop/one-impact",
    "elastic-stop/one-contact",
    "dry-friction/symmetric",
    "dry-friction/global-stick",
    "dry-friction/solution-ii",
)
EXCHANGED = "dry-friction/global-stick with given dwell times"
_FORCES = {"us1": "0.0127", "ur1": "0.0255", "us2": "0.5", "ur2": "1"}
_SYMMETRIC_DATA = {"chi": "0.4", "eta": "4", "V": "0.6773", **_FORCES}
_LABELS = {
    "tau": r"\tau",
    "tau1": r"\tau_1",
    "tau2": r"\tau_2",
    "ta": "t_a",
    "z10": "z_{10}",
    "z20": "z_{20}",
    "e1": "e_1",
    "e2": "e_2",
}

Formulas = Callable[[str, str], Sequence[tuple[str, str]]]


def paper_orbits(begin: Callable[[str], None]) -> dict[str, Orbit]:
    """The paper's orbits at its data, refined, by name; `begin` receives the name of each."""
    found = {}
    for name in ORBITS:
        begin(f"orbit {name}")
        data = _SYMMETRIC_DATA if name.endswith("/symmetric") else {}
        found[name] = refine(solve(name, data), DIGITS + 5)
    begin(f"orbit {EXCHANGED}")
    swapped = solve(ORBITS[3], unknown=["e1", "e2"], given={"ta": "1", "tau": "2"})
    return found | {EXCHANGED: refine(swapped, DIGITS + 5)}


def paper_report(
    orbits: Mapping[str, Orbit], pictures: Mapping[str, ReportFigure], formulas: Formulas
) -> Report:
    """The whole report on the paper: chapters, findings, and the numbers of its JSON.

    The orbits are those of `paper_orbits`, and the pictures are named by their stems. The
    callable `formulas` returns LaTeX and meaning of the formulas in a section of an orbit's
    document.
    """
    rigid, elastic, symmetric, stick, limit, swapped = (orbits[n] for n in (*ORBITS, EXCHANGED))
    numbers = _numbers(symmetric, stick, swapped)
    wrong = misprints(rigid, elastic, symmetric, stick)
    claims = (rigid_limit(rigid), symmetric_portraits(symmetric), trace_criterion(stick))
    periods = (singular_periods(rigid), admissible_periods(rigid))
    route = appendix_tables(stick)
    chapters = (
        Chapter(
            "rigid-stop",
            "Rigid impact (Secs. 2.1, 2.3)",
            (
                pictures["figure-01"],
                Text(
                    "One impact per period, with the second mass at rest at the impact, $w = 0$."
                    " That follows from the closure of a reversible orbit, and so does $r = 1$:"
                    " without forcing no such orbit exists for another coefficient of restitution."
                    " Halfway through the period both velocities vanish; these two conditions are"
                    " linear in $y$ and $u$, so that the orbit is explicit."
                ),
                *_equations(formulas, rigid, "Modal analysis"),
                *_equations(formulas, rigid, "The equations"),
                *_equations(formulas, rigid, "The reduction"),
                *_orbit_blocks(rigid, pictures),
                pictures["figure-02"],
                pictures["figure-03"],
                *periods,
            ),
        ),
        Chapter(
            "elastic-stop",
            "Soft impact (Secs. 2.2, 2.4)",
            (
                Text(
                    "A phase of contact, $\\tau$, and a free one, $T - \\tau$. Halfway through each"
                    " both velocities vanish: four conditions for $y$, $u$, $w$ and $\\tau$, which"
                    " are linear in the first three."
                ),
                *_equations(formulas, elastic, "Modal analysis"),
                *_equations(formulas, elastic, "The equations"),
                *_orbit_blocks(elastic, pictures),
                pictures["figure-04"],
                pictures["figure-05"],
                claims[0],
            ),
        ),
        Chapter(
            "symmetric",
            "Symmetrical periodic solution (Sec. 3.2)",
            (
                pictures["figure-06"],
                Text(
                    "Slip-slip, then slip-stick, for each of which both positions pass their"
                    " centres halfway: $z_1 = z_2 = 0$. These conditions are nonsingular, where the"
                    " rule as printed contains each of them twice."
                ),
                *_equations(formulas, symmetric, "Modal analysis"),
                *_equations(formulas, symmetric, "The equations"),
                Comparisons("The paper's numbers and ours", numbers[0]),
                *_orbit_blocks(symmetric, pictures),
                pictures["figure-07"],
                pictures["figure-08"],
                claims[1],
            ),
        ),
        Chapter(
            "global-stick",
            "Periodic solution including a global sticking phase (Sec. 3.3, Appendix)",
            (
                *_equations(formulas, stick, "The equations"),
                Comparisons("Given $e_1$ and $e_2$: the dwell times and the start", numbers[1]),
                Comparisons("Given $t_a$ and $\\tau$: the friction excesses", numbers[2]),
                *_orbit_blocks(stick, pictures),
                Text(
                    "The Appendix takes the equations in another order: given the dwell times, the"
                    " first line of (A.1) gives the start (A.3), and the second one two conditions"
                    " on the dwell times, in the matrix $\\tilde M$ (A.2), beside (12) and (14)."
                ),
                *route,
                pictures["figure-09"],
                pictures["figure-10"],
                claims[2],
            ),
        ),
        Chapter(
            "solution-ii",
            "Solution II (the case $t_a = 0$)",
            (
                Text(
                    "The limit of the orbits with a global sticking phase at $t_a = 0$ is a border"
                    " collision: the second mass reaches the belt's velocity at the instant at"
                    " which the first breaks away. One parameter, here $e_1$, is determined with"
                    " the orbit; derivatives of the Poincaré map are those on the side $t_a > 0$."
                ),
                *_orbit_blocks(limit, pictures),
            ),
        ),
        Chapter(
            "poincare-map",
            "Stability and the Poincaré map (Secs. 4, 5)",
            (
                pictures["figure-11"],
                Text(
                    "Each local map carries a perturbation by the flow and projects it onto the"
                    " boundary at which the phase ends. Its counterpart for the whole phase space"
                    " is the saltation matrix of a transition with reset $R$, gradient $n$ and"
                    " vector fields $f^{-}$ in front and $f^{+}$ behind:"
                ),
                Equation(r"S = R + \frac{(f^{+} - R f^{-})\, n}{n f^{-}}"),
                saltation_matters(tuple(orbits[name] for name in ORBITS)),
            ),
        ),
        Chapter(
            "misprints",
            "Misprints",
            (
                Text("What is printed, what it has to be, and the computation that shows it."),
                *wrong,
            ),
        ),
    )
    compared_numbers = [number for group in numbers for number in group]
    return Report(
        "Two models of nonsmooth dynamical systems, reproduced",
        _summary(compared_numbers, claims, wrong),
        chapters,
        {
            "orbits": {name: orbit_json(orbit, DIGITS) for name, orbit in orbits.items()},
            "comparisons": [asdict(number) for number in compared_numbers],
            "claims": [asdict(claim) for claim in claims],
            "misprints": [asdict(finding) for finding in wrong],
            "tables": [asdict(table) for table in (*periods, *route)],
        },
    )


def _numbers(
    symmetric: Orbit, stick: Orbit, swapped: Orbit
) -> tuple[tuple[Comparison, ...], tuple[Comparison, ...], tuple[Comparison, ...]]:
    """Comparisons with the digits of Sec. 3.2, and with both readings of those of Sec. 3.3."""
    times = {"tau1": "1.568", "tau2": "3.28"}
    start = {"z10": "1.1838", "z20": "-2.6715"}
    return (
        compared(symmetric, "Sec. 3.2", {"tau": "2.65", "tau1": "2.2407"}, _LABELS),
        compared(stick, "Sec. 3.3", {"ta": "1", "tau": "2", **times, **start}, _LABELS),
        compared(swapped, "Sec. 3.3", {"e1": "3.0195", "e2": "0.4831", **times, **start}, _LABELS),
    )


def _summary(
    numbers: Iterable[Comparison], claims: Iterable[Finding], wrong: Sequence[Finding]
) -> tuple[str, ...]:
    verdicts: dict[tuple[str, str], list[str]] = {}
    for number in numbers:  # some stand in two rows, computed from different data
        verdicts.setdefault((number.where, number.quantity), []).append(number.verdict)
    within = sum({*found} == {AGREES} for found in verdicts.values())
    kept = sum(claim.verdict == "holds" for claim in claims)
    shown = sum(finding.verdict == "misprint" for finding in wrong)
    return (
        "Every orbit, number, figure and claim of M. Pascal, *Two models of nonsmooth dynamical"
        " systems*, Int. J. Bifurcation and Chaos (2011), computed again.",
        f"Of {len(verdicts)} printed numbers {within} agree within the printed digits in every row,"
        f" the others to the percentage that is given. {kept} claims hold. {shown} misprints are"
        " shown by computation. Numbers of orbits are given to 30 digits, proved by interval"
        " Newton.",
    )


def _equations(formulas: Formulas, orbit: Orbit, section: str) -> tuple[Equation, ...]:
    return tuple(Equation(latex, note) for latex, note in formulas(orbit.name, section))


def _orbit_blocks(orbit: Orbit, pictures: Mapping[str, ReportFigure]) -> tuple[Block, ...]:
    """Blocks for one orbit: its numbers, the strip of its configurations, its multipliers."""
    told = orbit_json(orbit, DIGITS)
    given = {name: value.text for name, value in {**orbit.given, **orbit.opened}.items()}
    known = {**given, **orbit.kernels.required, **told["unknowns"]}
    rows = [(f"${symbol(name)}$", text) for name, text in known.items()]
    rows += [("period", told["period"]), ("trace", told["trace"])]
    for number, m in enumerate(told["multipliers"], 1):
        imaginary = f" + i times {m['im']}" if m["im"].strip("-0.") else ""
        rows.append((rf"$\mu_{number}$", m["re"] + imaginary + " (trivial)" * m["trivial"]))
    side = f", one-sided: {told['one_sided']}" if "one_sided" in told else ""
    rows.append(("stability", told["stability"] + side))
    answer = {True: "yes", False: "no"}.get(told["admissible"], "conditional: it takes")
    bounds = [
        f"${symbol(b['parameter'])} > {float(b['greater_than']):.6g}$"
        for b in told.get("requires", ())
    ]
    rows.append(("admissible", " ".join([answer, ", ".join(bounds)]).strip()))
    stem = orbit.name.replace("/", "-")
    return (
        Table(f"The orbit *{orbit.name}* at the paper's data", ("Quantity", "Value"), tuple(rows)),
        pictures[f"{stem}-strip"],
        pictures[f"{stem}-multipliers"],
    )
