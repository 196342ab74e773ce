"""Documents of built-in systems and orbits: the commands' way into the derivation."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

from nonsmooth.runtime.errors import InputError, NoConvergence, missing_extra, unknown_name
from nonsmooth.runtime.files import unwritable

__all__ = [
    "document_maker",
    "section_formulas",
    "write_document",
    "written",
]


def document_maker(name: str) -> Callable[[], Any]:
    """Check the name of a system or an orbit and give what makes its document.

    Raises
    ------
    InputError
        For an unknown system or orbit.
    """
    from nonsmooth.derive.systems import SYSTEMS, declaration

    system, slash, orbit = name.partition("/")
    if system not in SYSTEMS:
        raise unknown_name("system", system, SYSTEMS)
    declared = declaration(system)
    orbits = {o.name: o for o in declared.orbits}
    if slash and orbit not in orbits:
        raise unknown_name("orbit", name, [f"{system}/{known}" for known in orbits])

    def make() -> Any:
        from nonsmooth.derive.document.describe import describe_orbit, describe_system
        from nonsmooth.derive.equations import derive_equations

        if slash:
            return describe_orbit(derive_equations(orbits[orbit]))
        return describe_system(declared.system)

    return make


def section_formulas(name: str, section: str) -> tuple[tuple[str, str], ...]:
    """LaTeX and meaning of the formulas in one section of an orbit's document."""
    document = _document(name)
    from nonsmooth.derive.document.blocks import Formula

    found = (b for b in document.section(section) if isinstance(b, Formula))
    return tuple((formula.latex, formula.note or "") for formula in found)


@cache
def _document(name: str) -> Any:
    return document_maker(name)()


def written(document: Any, form: str) -> str:
    """Text of a document as "latex", "markdown" or "html"; for "pdf" its LaTeX.

    Raises
    ------
    MissingExtra
        For HTML where latex2mathml is not installed.
    """
    from nonsmooth.derive.document.hypertext import to_html
    from nonsmooth.derive.document.latex import to_latex
    from nonsmooth.derive.document.markdown import to_markdown

    if form == "markdown":
        return to_markdown(document)
    if form != "html":
        return to_latex(document)
    try:
        return to_html(document)
    except ImportError:
        raise missing_extra("html", "latex2mathml") from None


def write_document(text: str, form: str, out: Path) -> None:
    """Write what `written` gave; a PDF is compiled.

    Raises
    ------
    InputError
        If the file cannot be written, or no LaTeX is installed.
    NoConvergence
        If LaTeX fails.
    """
    from nonsmooth.derive.document.latex import LatexMissing, compile_pdf

    try:
        if form == "pdf":
            compile_pdf(text, out)
        else:
            out.write_text(text, encoding="utf-8", newline="\n")
    except LatexMissing as problem:
        raise InputError(str(problem)) from None
    except RuntimeError as problem:
        raise NoConvergence(str(problem)) from None
    except OSError as problem:
        raise unwritable(out, problem) from None
