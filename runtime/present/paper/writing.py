"""All of the reproduction, into a folder."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from nonsmooth.runtime.core.errors import missing_extra
from nonsmooth.runtime.core.files import check_folder, write_files
from nonsmooth.runtime.present.paper.chapters import ORBITS, Formulas, paper_orbits, paper_report
from nonsmooth.runtime.present.paper.proofs import with_certificates

__all__ = ["reproduce"]


def reproduce(
    out: Path,
    formulas: Formulas,
    begin: Callable[[str], None] = lambda step: None,
    *,
    certified: bool = False,
) -> tuple[Path, ...]:
    """Reproduce the source paper in the folder `out`, which is made if need be.

    The files written are ``report.html`` (self-contained), ``report.md``, ``results.json``
    and each figure as SVG and PNG, all at once when the last is ready. Running it again
    gives the same ``results.json``, byte by byte. The callable `formulas` returns LaTeX and
    meaning of the formulas in a section of an orbit's document; `begin` receives the name
    of each step. `certified` adds what ball arithmetic proves of every orbit.
    `MissingExtra` is raised if matplotlib, Jinja2 or latex2mathml is not installed.
    `InputError` is raised if the folder cannot be written; then nothing in it has changed.
    """
    _check_extras()
    check_folder(out)
    files = _contents(formulas, begin, certified=certified)
    write_files(out, files)
    return tuple(out / name for name in files)


def _contents(
    formulas: Formulas, begin: Callable[[str], None], *, certified: bool
) -> dict[str, bytes]:
    """Content of every file by name: pictures, then the numbers and the reports."""
    from nonsmooth.runtime.present.paper.figures import drawings
    from nonsmooth.runtime.present.paper.writers import to_html, to_json, to_markdown
    from nonsmooth.runtime.present.pictures.plot import figure_bytes

    orbits = paper_orbits(begin)
    drawn = drawings({name: orbits[name] for name in ORBITS})
    begin("claims, misprints and equations")
    pictures = {stem: drawing.picture for stem, drawing in drawn.items()}
    report = paper_report(orbits, pictures, formulas)
    if certified:
        report = with_certificates(report, orbits, begin)
    files: dict[str, bytes] = {}
    for stem, drawing in drawn.items():
        begin(f"figure {stem}")
        figure = drawing.draw()
        for ending in (".svg", ".png"):
            files[f"{stem}{ending}"] = figure_bytes(figure, ending)
    begin("report")
    vectors = {stem: files[f"{stem}.svg"].decode() for stem in drawn}
    files["results.json"] = to_json(report).encode()
    files["report.md"] = to_markdown(report).encode()
    files["report.html"] = to_html(report, vectors).encode()
    return files


def _check_extras() -> None:
    """Raise an error for a missing package before any work is done."""
    for extra, module in (("plot", "matplotlib"), ("html", "jinja2"), ("html", "latex2mathml")):
        try:
            __import__(module)
        except ImportError:
            raise missing_extra(extra, module) from None
