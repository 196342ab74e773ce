"""The source paper reproduced: the report, its numbers and its figures, into a folder."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Mapping, Sequence
from decimal import ROUND_CEILING, Context, Decimal
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.errors import missing_extra
from nonsmooth.runtime.core.files import check_folder, write_files
from nonsmooth.runtime.core.values import decimal_string
from nonsmooth.runtime.explore.continuation.continue_orbit import continue_orbit
from nonsmooth.runtime.model.naming import symbol
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.solve import solve
from nonsmooth.runtime.present.paper import findings
from nonsmooth.runtime.present.paper.findings import DIGITS, PAPER, Answer
from nonsmooth.runtime.present.paper.pages import to_html, to_markdown
from nonsmooth.runtime.present.report import orbit_json
from nonsmooth.runtime.proof.branch.certify_event import certify_event
from nonsmooth.runtime.proof.certify_orbit import certify

if TYPE_CHECKING:
    from matplotlib.figure import Figure

AGREES = "agrees within the printed digits"
_ONE_DIGIT = Context(prec=1, rounding=ROUND_CEILING)  # the next larger number that has one
_BESIDE = 0.05  # of the parameter: from a border collision to an orbit that has all phases

Begin = Callable[[str], None]
Formulas = Callable[[str, str], Sequence[tuple[str, str]]]
Orbits = Mapping[str, Orbit]


def reproduce(
    out: Path, formulas: Formulas, begin: Begin = lambda step: None, *, certified: bool = False
) -> tuple[Path, ...]:
    """Reproduce the source paper in the folder `out`, which is made if need be.

    The files written are ``report.html`` (self-contained), ``report.md``, ``results.json``
    and each figure as SVG and PNG, all at once when the last is ready. Running it again
    gives the same ``results.json``, byte by byte. The callable `formulas` returns LaTeX and
    meaning of the formulas in a section of an orbit's document; `begin` receives the name
    of each step. `certified` adds what ball arithmetic proves of every orbit.
    `MissingExtra` is raised if an optional package is not installed, of those that draw or
    write HTML. `InputError` is raised if the folder cannot be written; then nothing in it
    has changed.
    """
    _check_extras()
    check_folder(out)
    files = _contents(formulas, begin, certified=certified)
    write_files(out, files)
    return tuple(out / name for name in files)


def paper_orbits(begin: Begin) -> dict[str, Orbit]:
    """The paper's orbits at its data, refined, by name; `begin` receives the name of each."""
    found = {}
    for name, given in {**PAPER["orbits"], **PAPER["variants"]}.items():
        begin(f"orbit {name}")
        found[name] = solve(**{"orbit": name, **given}, digits=DIGITS + 5)
    return found


def _contents(formulas: Formulas, begin: Begin, *, certified: bool) -> dict[str, bytes]:
    """Content of every file by name: pictures, then the numbers and the reports."""
    from nonsmooth.runtime.present.pictures.plot import figure_bytes

    orbits = paper_orbits(begin)
    figures = _figures()
    begin("claims, misprints and equations")
    told = {
        "numbers": {name: _compared(group, orbits) for name, group in PAPER["numbers"].items()},
        **{kind: _decided(kind, orbits) for kind in ("tables", "claims", "misprints")},
        **(_proofs(orbits, begin) if certified else {"certificates": {}, "collisions": {}}),
    }
    markdown = to_markdown(
        {
            **told,
            "agreements": _agreements(told["numbers"]),
            "described": lambda name: _described(orbits[name]),
            "digits": DIGITS,
            "figures": figures,
            "formulas": formulas,
            "symbol": symbol,
        }
    )
    files: dict[str, bytes] = {}
    for stem, figure in figures.items():
        begin(f"figure {stem}")
        drawn = _drawn(figure, orbits)
        for ending in (".svg", ".png"):
            files[stem + ending] = figure_bytes(drawn, ending)
    begin("report")
    results = {
        "orbits": {name: orbit_json(orbit, DIGITS) for name, orbit in orbits.items()},
        "comparisons": [row for group in told["numbers"].values() for row in group["rows"]],
        **{kind: list(told[kind].values()) for kind in ("claims", "misprints", "tables")},
        **({name: told[name] for name in ("certificates", "collisions")} if certified else {}),
    }
    files["results.json"] = (json.dumps(results, indent=2, allow_nan=False) + "\n").encode()
    files["report.md"] = markdown.encode()
    files["report.html"] = to_html(markdown, files).encode()
    return files


def _check_extras() -> None:
    """Raise an error for a missing package before any work is done."""
    extras = {"plot": ("matplotlib",), "html": ("jinja2", "latex2mathml", "mdit_py_plugins")}
    for extra, modules in extras.items():
        for module in modules:
            try:
                __import__(module)
            except ImportError:
                raise missing_extra(extra, module) from None


# --- figures


def _figures() -> dict[str, dict[str, Any]]:
    """The paper's figures by their stems, and after them the pictures of each orbit."""
    of_orbits = {
        f"{orbit.replace('/', '-')}-{kind}": {
            "caption": caption.replace("[[orbit]]", orbit),
            "orbit": orbit,
            "view": {"kind": kind},
        }
        for orbit in PAPER["orbits"]
        for kind, caption in PAPER["pictures"].items()
    }
    return {**PAPER["figures"], **of_orbits}


def _drawn(figure: Mapping[str, Any], orbits: Orbits) -> Figure:
    """A figure of `_figures`, drawn."""
    from nonsmooth.runtime.present.paper.schematics import schematic
    from nonsmooth.runtime.present.pictures.plot import motion_figure

    if "shapes" in figure:
        return schematic(figure["height"], figure["shapes"])
    return motion_figure(orbits[figure["orbit"]], **figure["view"])


# --- numbers and findings


def _compared(group: Mapping[str, Any], orbits: Orbits) -> dict[str, Any]:
    """A group of printed numbers, each beside ours."""
    rows = []
    for name, printed in group["printed"].items():
        ours = decimal_string(orbits[group["orbit"]].unknowns[name], DIGITS)
        difference = Decimal(ours) - Decimal(printed)
        rows.append(
            {
                "quantity": symbol(name),
                "where": group["where"],
                "printed": printed,
                "ours": ours,
                "difference": f"{difference:.2e}",
                "verdict": _agreement(printed, difference, abs(difference / Decimal(ours))),
            }
        )
    return {"caption": group["caption"], "rows": rows}


def _agreement(printed: str, difference: Decimal, relative: Decimal) -> str:
    """How well a printed number agrees; what has no decimals is meant exactly."""
    places = len(printed.partition(".")[2])
    if places and abs(difference) <= Decimal(1).scaleb(-places) / 2:
        return AGREES
    return f"agrees within {_ONE_DIGIT.create_decimal(100 * relative):f} %"


def _decided(kind: str, orbits: Orbits) -> dict[str, Any]:
    """Tables, claims or misprints by their names, with what is computed of each."""
    return {
        name: _filled(said, getattr(findings, name)(orbits)) for name, said in PAPER[kind].items()
    }


def _filled(said: Any, answer: Answer) -> Any:
    """What paper.toml says, with the answer's verdict, rows and values in their places."""
    if isinstance(said, str):
        line = " ".join(said.split())
        return re.sub(
            r"\[\[(\w+):?(.*?)\]\]", lambda found: format(answer.values[found[1]], found[2]), line
        )
    if "header" not in said:
        return {name: _filled(x, answer) for name, x in said.items()} | {"verdict": answer.verdict}
    told = [
        [form.format(x) for form, x in zip(said["cells"], row, strict=True)] for row in answer.rows
    ]
    labels = said.get("labels", [[]] * len(told))
    labelled = zip(labels, told, strict=True)
    rows = [([label] if isinstance(label, str) else label) + row for label, row in labelled]
    return {"caption": _filled(said["caption"], answer), "header": said["header"], "rows": rows}


def _agreements(numbers: Mapping[str, Any]) -> list[bool]:
    """Of each printed number whether it agrees in all rows: some are computed twice."""
    verdicts: dict[tuple[str, str], set[str]] = {}
    for group in numbers.values():
        for row in group["rows"]:
            verdicts.setdefault((row["where"], row["quantity"]), set()).add(row["verdict"])
    return [found == {AGREES} for found in verdicts.values()]


def _described(orbit: Orbit) -> tuple[dict[str, str], dict[str, Any]]:
    """Numbers of an orbit by name, those that were given first, and all of it as JSON."""
    told = orbit_json(orbit, DIGITS)
    given = {name: value.text for name, value in {**orbit.given, **orbit.opened}.items()}
    return {**given, **orbit.kernels.required, **told["unknowns"]}, told


# --- proofs


def _proofs(orbits: Orbits, begin: Begin) -> dict[str, Any]:
    """What ball arithmetic proves of each orbit, and of the border collision at solution II."""
    certificates = {}
    for name, orbit in orbits.items():
        begin(f"proof of {name}")
        proved = certify(orbit, begin=begin)
        trace = proved.enclosures.get("trace")
        certificates[name] = {
            "claims": dict(proved.claims),
            "reasons": dict(proved.reasons),
            "trace": f"{trace.mid} +/- {trace.rad}" if trace else "",
        }
    *_, host, limit = PAPER["orbits"]
    given = {name: str(value) for name, value in orbits[limit].given.items()}
    value = float(orbits[limit].unknowns["e1"])
    beside = solve(host, {**given, "e1": value + _BESIDE})
    branch = continue_orbit(beside, "e1", (value - _BESIDE, value + 2 * _BESIDE))
    (event,) = [event for event in branch.events if event.kind == "vanishing-phase"]
    return {
        "certificates": certificates,
        "collisions": {limit: certify_event(branch, event).to_json()},
    }
