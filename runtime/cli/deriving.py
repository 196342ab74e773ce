"""The commands that derive: documents, and kernels of built-in and of users' declarations."""

from __future__ import annotations

import sys
from collections.abc import Callable
from enum import StrEnum
from functools import cache
from pathlib import Path
from typing import Annotated, Any

import typer

from nonsmooth.runtime.cli.command import command
from nonsmooth.runtime.cli.completion import complete_orbits
from nonsmooth.runtime.cli.keeping import say
from nonsmooth.runtime.cli.options import Check, option
from nonsmooth.runtime.cli.reply import Reply, show_comparison
from nonsmooth.runtime.core.errors import InputError, NoConvergence, missing_extra, unknown_name
from nonsmooth.runtime.core.files import unwritable, write_file

REMEDY = "python scripts/regenerate.py"


class Format(StrEnum):
    """The formats that `equations` writes."""

    LATEX = "latex"
    MARKDOWN = "markdown"
    HTML = "html"
    PDF = "pdf"


class DocumentPart(StrEnum):
    """The parts of a document that `equations` writes alone."""

    FLOWS = "flows"
    EQUATIONS = "equations"
    MAP = "map"
    TRACE = "trace"


@command(
    "equations",
    "equations dry-friction/global-stick --format markdown",
    "equations dry-friction --out dry-friction.tex",
    "equations dry-friction/global-stick --section trace --format markdown",
    "equations dry-friction/global-stick --format pdf",
)
def equations(
    name: Annotated[
        str,
        typer.Argument(
            autocompletion=complete_orbits,
            metavar="SYSTEM[/ORBIT]",
            help="A system or an orbit, or your own: FILE.py or FILE.py:ORBIT.",
        ),
    ],
    form: Annotated[Format, option("--format", "What to write.")] = Format.LATEX,
    section: Annotated[
        DocumentPart | None,
        option("--section", "Write this part alone; a system has its flows."),
    ] = None,
    out: Annotated[
        Path | None,
        option("--out", "Write this file; a PDF is SYSTEM-ORBIT.pdf by default.", "FILE"),
    ] = None,
    *,
    reply: Reply,
) -> int:
    """Derive a system or an orbit and write it down, from the declaration to the trace."""
    from nonsmooth.runtime.cli.display import steps
    from nonsmooth.runtime.core.files import check_target

    if out is None and form is Format.PDF:
        stem = Path(name).name if ".py" in name else name.replace("/", "-")
        out = Path(f"{stem.replace('.py', '').replace(':', '-')}.pdf")
    document = document_maker(name, section)
    if out is not None:
        check_target(out)
    with steps(f"deriving {name}") as begin:
        text = written(document(), form.value)
        if out is not None:
            begin(f"writing {out}")
            write_document(text, form.value, out)
    told = {"text": text} if out is None else {"file": str(out)}
    return reply.show(
        lambda: {"name": name, "format": form.value, **told},
        lambda: sys.stdout.write(text if out is None else f"{out} written\n"),
    )


@command(
    "generate",
    "generate my_oscillator.py --out my_kernels",
    "generate my_oscillator.py --out my_kernels --compile",
    "generate my_oscillator.py --out my_kernels --check",
    after="Then my_kernels is a SYSTEM, and my_kernels:ORBIT an orbit, for every command.",
)
def generate(
    file: Annotated[
        Path,
        typer.Argument(
            metavar="FILE.py",
            help="A file that defines `system`, a System, and `orbits`, a list of Itinerary.",
        ),
    ],
    out: Annotated[Path, option("--out", "Folder of the kernels, made if need be.", "DIR")],
    compiled: Annotated[
        bool, option("--compile", "Build the kernels in C too; it takes a compiler.")
    ] = False,
    check: Check = False,
    *,
    reply: Reply,
) -> int:
    """Derive your own system and its orbits and write their kernels: Python, C, LaTeX."""
    from nonsmooth.runtime.cli.display import show_written, steps
    from nonsmooth.runtime.model.loading.compiling import compile_files
    from nonsmooth.runtime.model.loading.folder import check_own_folder, write_folder

    if check and compiled:
        raise InputError("--check writes nothing: leave out --compile")
    check_own_folder(out)
    with steps(f"reading {file}") as begin:
        system, orbits, files = emitted(file, begin)
        told: dict[str, Any] = {
            "folder": str(out),
            "system": system,
            "orbits": [
                {"name": name, "derived": reason is None} | ({"reason": reason} if reason else {})
                for name, reason in orbits.items()
            ],
        }
        if check:
            from nonsmooth.derive.codegen.regenerate import differences

            found = differences(out, files)
            return show_comparison(reply, told, found, f"{file}: generate it again")
        library = None
        if compiled:
            begin("compiling")
            library = compile_files(files)
        paths = [str(path) for path in write_folder(out, files, library)]

    def show() -> None:
        for name, reason in orbits.items():
            if reason is not None:
                told = f"{name}: composed numerically when it is asked for: {reason}"
                print(told, file=sys.stderr)
        show_written([f"{path} written" for path in paths], f"{out}: nothing changed")

    return reply.show(lambda: {**told, "files": sorted(files), "written": paths}, show)


@command("regenerate", "regenerate --check", "regenerate dry-friction --out kernels")
def regenerate(
    system: Annotated[
        str | None, typer.Argument(metavar="SYSTEM", help="Only this one.", show_default=False)
    ] = None,
    check: Check = False,
    out: Annotated[
        Path | None,
        option("--out", "Folder of the files; that of the checkout by default.", "DIR"),
    ] = None,
    *,
    reply: Reply,
) -> int:
    """Make the kernels again from the derivation, or check that they are up to date."""
    from nonsmooth.derive.codegen import regenerate as generation
    from nonsmooth.derive.systems import SYSTEMS
    from nonsmooth.runtime.cli.display import show_written, steps
    from nonsmooth.runtime.core.files import check_folder, write_files

    if system is not None and system not in SYSTEMS:
        raise unknown_name("system", system, SYSTEMS)
    folder = generation.find_generated(writing=not check) if out is None else out
    told: dict[str, Any] = {"folder": str(folder), "system": system}
    checkout = generation.surrounding_checkout()
    if out is None and checkout is not None and checkout.resolve() != folder.resolve().parent:
        say(
            f"this is about {folder}, of the nonsmooth that runs, not about {checkout}:"
            f" install that one to derive with it"
        )
    if check:
        with steps() as begin:
            differences = generation.check(out, system, begin)
        return show_comparison(reply, told, differences, f"the derivation: {REMEDY}")
    check_folder(folder)
    with steps() as begin:
        texts = generation.outdated(out, system, begin)
    if texts:
        write_files(folder, {name: text.encode() for name, text in texts.items()})
    changed = [str(folder / name) for name in texts]
    return reply.show(
        lambda: {**told, "changed": changed},
        lambda: show_written(changed, f"{folder}: nothing changed"),
    )


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
    from nonsmooth.runtime.model.loading.declared import declaration_in
    from nonsmooth.runtime.model.loading.load import located

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


def emitted(
    path: Path, progress: Callable[[str], None]
) -> tuple[str, dict[str, str | None], dict[str, str]]:
    """What a Python file declares: the system's name, its orbits, and all generated files.

    By the name of each orbit there is None, or why it has no kernels; by that of each file its
    text. `progress` gets the name of each step when it begins. InputError refuses a file that
    cannot be read, fails, or declares no system; DeclarationError and DerivationError say
    that a declaration is inconsistent or cannot be derived.
    """
    from nonsmooth.runtime.model.loading.declared import declaration_in
    from nonsmooth.runtime.model.loading.folder import COMMAND

    if not path.is_file():
        raise InputError(
            f"there is no file {path}: kernels are generated of all that FILE.py declares"
        )
    declared: Any = declaration_in(path)
    from nonsmooth.derive.codegen.emit import emit_package, emit_system

    command = f"{COMMAND} {path.name} --out DIR"
    found = emit_system(declared.system, declared.orbits, path.name, progress, command)
    orbits = {orbit.name: found.underived.get(orbit.name) for orbit in declared.orbits}
    return found.name, orbits, emit_package([found], command)


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
