"""The commands' way into the derivation: documents, and kernels of users' declarations."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from nonsmooth.runtime.core.errors import InputError, NoConvergence, missing_extra, unknown_name
from nonsmooth.runtime.core.files import unwritable, write_file
from nonsmooth.runtime.model.loading.declared import declaration_in
from nonsmooth.runtime.model.loading.folder import COMMAND
from nonsmooth.runtime.model.loading.load import located

__all__ = [
    "Emission",
    "document_maker",
    "emit_file",
    "file_differences",
    "section_formulas",
    "write_document",
    "written",
]


def document_maker(name: str) -> Callable[[], Any]:
    """Check the name of a system or an orbit and give what makes its document.

    Parameters
    ----------
    name : str
        ``SYSTEM`` or ``SYSTEM/ORBIT`` of a built-in system, ``FILE.py`` or ``FILE.py:ORBIT``.

    Returns
    -------
    callable
        Gives the document; it derives when it is called.

    Raises
    ------
    InputError
        For an unknown system or orbit, or a file that fails.
    """
    system, orbits, label = _declaration(name)
    if label is not None and label not in orbits:
        known = [name.removesuffix(label) + orbit for orbit in orbits]
        raise unknown_name("orbit", name, known)

    def make() -> Any:
        from nonsmooth.derive.document.describe import describe_orbit, describe_system
        from nonsmooth.derive.equations.derivation import derive_equations
        from nonsmooth.derive.errors import DerivationError

        if label is None:
            return describe_system(system)
        try:
            return describe_orbit(derive_equations(orbits[label]))
        except DerivationError:  # no closed form: the switching conditions over exponentials
            return describe_orbit(orbits[label])

    return make


def _declaration(name: str) -> tuple[Any, dict[str, Any], str | None]:
    """System, orbits by name, and the name of an orbit if one is meant."""
    from nonsmooth.derive.systems import SYSTEMS, declaration

    system, slash, orbit = name.partition("/")
    if system in SYSTEMS:
        found = declaration(system)
        return found.system, {o.name: o for o in found.orbits}, orbit if slash else None
    place, label = _file_and_orbit(name)
    path = located(place)
    if path is None and place.endswith(".json"):
        raise InputError(
            f"{name} has no declaration to derive: `nonsmooth find FILE.py ... --write FILE.py`"
            " appends orbits to that of their system, then FILE.py:found-1 is the first"
        )
    if path is None:
        raise unknown_name("system", system, SYSTEMS)
    if path.is_dir():
        raise InputError(f"{name}: a folder keeps its equations in a .md file; derive FILE.py")
    declared = declaration_in(path)
    return declared.system, {o.name: o for o in declared.orbits}, label


def _file_and_orbit(name: str) -> tuple[str, str | None]:
    """Cut ``FILE.py:ORBIT``; a path of a drive has a colon too."""
    if name.endswith(".py"):
        return name, None
    place, colon, label = name.rpartition(":")
    return (place, label) if colon else (name, None)


@dataclass(frozen=True)
class Emission:
    """What a declaration gives.

    Attributes
    ----------
    system : str
    orbits : dict of orbit to reason
        Why an orbit has no kernels; None where it has.
    files : dict of file name to text
    """

    system: str
    orbits: dict[str, str | None]
    files: dict[str, str]


def emit_file(path: Path, progress: Callable[[str], None] = lambda step: None) -> Emission:
    """Derive what a file declares and emit all its files.

    Parameters
    ----------
    path : Path
    progress : callable
        Told the name of each step when it begins.

    Returns
    -------
    Emission
        Files by name, and why orbits are not derived.

    Raises
    ------
    InputError
        If the file cannot be read, fails, or declares no system.
    DeclarationError, DerivationError
        If the declaration is inconsistent, or cannot be derived.
    """
    if not path.is_file():
        raise InputError(f"there is no file {path}")
    declared = declaration_in(path)
    from nonsmooth.derive.codegen.emit import emit_package, emit_system

    system: Any = declared.system
    orbits: Any = declared.orbits
    command = f"{COMMAND} {path.name} --out DIR"
    emitted = emit_system(system, orbits, path.name, progress, command)
    return Emission(
        emitted.name,
        {orbit.name: emitted.underived.get(orbit.name) for orbit in orbits},
        emit_package([emitted], command),
    )


def file_differences(folder: Path, emission: Emission) -> tuple[str, ...]:
    """Differences between a folder's files and those of an emission.

    Parameters
    ----------
    folder : Path
        Where the files are.
    emission : Emission
        As `emit_file` gives it.

    Returns
    -------
    tuple of str
        Empty if all files are the same.
    """
    from nonsmooth.derive.codegen.regenerate import differences

    return differences(folder, emission.files)


def section_formulas(name: str, section: str) -> tuple[tuple[str, str], ...]:
    """LaTeX and meaning of the formulas in one section of an orbit's document.

    Parameters
    ----------
    name : str
        ``SYSTEM/ORBIT`` or ``FILE.py:ORBIT``.
    section : str
        Title of the section.

    Returns
    -------
    tuple of (str, str)
        LaTeX and meaning of each formula.
    """
    document = _document(name)
    from nonsmooth.derive.document.blocks import Formula

    found = (b for b in document.section(section) if isinstance(b, Formula))
    return tuple((formula.latex, formula.note or "") for formula in found)


@cache
def _document(name: str) -> Any:
    return document_maker(name)()


def written(document: Any, form: str) -> str:
    """Text of a document as "latex", "markdown" or "html"; for "pdf" its LaTeX.

    Parameters
    ----------
    document : Document
        As `document_maker` makes it.
    form : {"latex", "markdown", "html", "pdf"}
        The form of the file.

    Returns
    -------
    str
        The text.

    Raises
    ------
    MissingExtra
        For HTML where latex2mathml is not installed.
    """
    from nonsmooth.derive.document.writers.hypertext import to_html
    from nonsmooth.derive.document.writers.latex import to_latex
    from nonsmooth.derive.document.writers.markdown import to_markdown

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

    Parameters
    ----------
    text : str
        As `written` gives it.
    form : {"latex", "markdown", "html", "pdf"}
        The form of the file.
    out : Path
        The file.

    Raises
    ------
    InputError
        If the file cannot be written, or no LaTeX is installed.
    NoConvergence
        If LaTeX fails.
    """
    from nonsmooth.derive.document.writers.latex import LatexMissing, compile_pdf

    try:
        content = compile_pdf(text) if form == "pdf" else text.encode()
    except LatexMissing as problem:
        raise InputError(str(problem)) from None
    except RuntimeError as problem:
        raise NoConvergence(str(problem)) from None
    except OSError as problem:  # of the folder where LaTeX works
        raise unwritable(out, problem) from None
    write_file(out, content)
