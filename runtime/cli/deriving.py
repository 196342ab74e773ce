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


def document_maker(name: str, part: str | None = None) -> Callable[[], Any]:
    """A function that derives and gives the document of a system or an orbit, or a part of it.

    The name is ``SYSTEM`` or ``SYSTEM/ORBIT`` of a built-in system, ``FILE.py`` or
    ``FILE.py:ORBIT``; InputError refuses at once an unknown one, a file that fails, and a
    part that a system does not have.
    """
    system, orbits, label = _declaration(name)
    if label is not None and label not in orbits:
        known = [name.removesuffix(label) + orbit for orbit in orbits]
        raise unknown_name("orbit", name, known)
    if label is None and part not in (None, "flows"):
        raise InputError(
            f"{name} is a system: its orbits have a part '{part}' ({', '.join(orbits)})"
        )

    def make() -> Any:
        whole = _whole(system, None if label is None else orbits[label])
        return whole if part is None else whole.part(part)

    return make


def _whole(system: Any, orbit: Any) -> Any:
    """The document of a system, or that of an orbit of it."""
    from nonsmooth.derive.document.describe import describe_orbit, describe_system
    from nonsmooth.derive.equations.derivation import derive_equations
    from nonsmooth.derive.errors import DerivationError

    if orbit is None:
        return describe_system(system)
    try:
        return describe_orbit(derive_equations(orbit))
    except DerivationError:  # no closed form: the switching conditions over exponentials
        return describe_orbit(orbit)


def _declaration(name: str) -> tuple[Any, dict[str, Any], str | None]:
    """The system, its orbits by name, and the name of the orbit that is meant, if any."""
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
    """File and orbit of ``FILE.py:ORBIT``; a file alone may have a colon behind its drive."""
    if name.endswith(".py"):
        return name, None
    place, colon, label = name.rpartition(":")
    return (place, label) if colon else (name, None)


@dataclass(frozen=True)
class Emission:
    """The generated files of a declaration, and which of its orbits have kernels."""

    system: str
    orbits: dict[str, str | None]  # by orbit: None, or why it has no kernels
    files: dict[str, str]  # text by file name


def emit_file(path: Path, progress: Callable[[str], None] = lambda step: None) -> Emission:
    """The generated files of what a Python file declares.

    `progress` gets the name of each step when it begins. InputError refuses a file that
    cannot be read, fails, or declares no system; DeclarationError and DerivationError say
    that a declaration is inconsistent or cannot be derived.
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
    """Differences between a folder's files and those of an emission; empty if there are none."""
    from nonsmooth.derive.codegen.regenerate import differences

    return differences(folder, emission.files)


def section_formulas(name: str, section: str) -> tuple[tuple[str, str], ...]:
    """LaTeX and meaning of each formula in one section of an orbit's document.

    The name is ``SYSTEM/ORBIT`` or ``FILE.py:ORBIT``, the section is given by its title.
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

    MissingExtra says that latex2mathml is not installed, which HTML needs.
    """
    from nonsmooth.derive.document.hypertext import to_html, to_markdown
    from nonsmooth.derive.document.latex import to_latex

    if form == "markdown":
        return to_markdown(document)
    if form != "html":
        return to_latex(document)
    try:
        return to_html(document)
    except ImportError:
        raise missing_extra("html", "latex2mathml") from None


def write_document(text: str, form: str, out: Path) -> None:
    """Write the text of a document to a file; for the form "pdf" its LaTeX is compiled.

    InputError says that the file cannot be written or no LaTeX is installed, NoConvergence
    that LaTeX fails.
    """
    from nonsmooth.derive.document.latex import LatexMissing, compile_pdf

    try:
        content = compile_pdf(text) if form == "pdf" else text.encode()
    except LatexMissing as problem:
        raise InputError(str(problem)) from None
    except RuntimeError as problem:
        raise NoConvergence(str(problem)) from None
    except OSError as problem:  # of the folder where LaTeX works
        raise unwritable(out, problem) from None
    write_file(out, content)
