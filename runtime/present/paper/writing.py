"""All of the reproduction, into a folder."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from nonsmooth.runtime.core.errors import Interrupted, missing_extra
from nonsmooth.runtime.core.files import unwritable
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
    """Reproduce the source paper.

    Writes ``report.html`` (self-contained), ``report.md``, ``results.json`` and each figure
    as SVG and PNG. Running it again gives the same ``results.json``, byte by byte.

    Parameters
    ----------
    out : Path
        A folder; it is made if need be.
    formulas : callable
        Gives LaTeX and meaning of the formulas in a section of an orbit's document.
    begin : callable
        Told the name of each step when it begins.
    certified : bool
        Add what ball arithmetic proves of every orbit.

    Returns
    -------
    tuple of Path
        The files that were written.

    Raises
    ------
    MissingExtra
        If matplotlib, Jinja2 or latex2mathml is not installed.
    InputError
        If the folder cannot be written.
    Interrupted
        By Ctrl-C; its `partial` are the files that were written.
    """
    _check_extras()
    try:
        out.mkdir(parents=True, exist_ok=True)
        (out / "results.json").open("a").close()
    except OSError as problem:
        raise unwritable(out, problem) from None
    written: list[Path] = []
    try:
        _write_all(out, formulas, begin, written, certified=certified)
    except KeyboardInterrupt:
        raise Interrupted(tuple(path for path in written if path.exists())) from None
    return tuple(written)


def _write_all(
    out: Path,
    formulas: Formulas,
    begin: Callable[[str], None],
    written: list[Path],
    *,
    certified: bool,
) -> None:
    """Write every file, and list each when it is begun."""
    from nonsmooth.runtime.present.paper.figures import drawings
    from nonsmooth.runtime.present.paper.writers import to_html, to_json, to_markdown
    from nonsmooth.runtime.present.pictures.plot import save_figure

    orbits = paper_orbits(begin)
    drawn = drawings({name: orbits[name] for name in ORBITS})
    begin("claims, misprints and equations")
    pictures = {stem: drawing.picture for stem, drawing in drawn.items()}
    report = paper_report(orbits, pictures, formulas)
    if certified:
        report = with_certificates(report, orbits, begin)
    try:
        for stem, drawing in drawn.items():
            begin(f"figure {stem}")
            figure = drawing.draw()
            for ending in ("svg", "png"):
                written.append(out / f"{stem}.{ending}")
                save_figure(figure, written[-1])
        begin("report")
        vectors = {stem: (out / f"{stem}.svg").read_text(encoding="utf-8") for stem in drawn}
        for name, text in (
            ("results.json", to_json(report)),
            ("report.md", to_markdown(report)),
            ("report.html", to_html(report, vectors)),
        ):
            written.append(out / name)
            written[-1].write_text(text, encoding="utf-8", newline="\n")
    except OSError as problem:
        raise unwritable(out, problem) from None


def _check_extras() -> None:
    """Ask for what is missing before any work is done."""
    for extra, module in (("plot", "matplotlib"), ("html", "jinja2"), ("html", "latex2mathml")):
        try:
            __import__(module)
        except ImportError:
            raise missing_extra(extra, module) from None
