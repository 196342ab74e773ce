"""The files of generated/: Python, C, header and equations of each system, and their stamps."""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, partial
from importlib.resources import files
from itertools import chain

import sympy as sp

from nonsmooth.derive.codegen.admissibility import admissible_function, admissible_source
from nonsmooth.derive.codegen.c import c_kernel, in_lane
from nonsmooth.derive.codegen.derived import DerivedSystem, Progress, Use, derive_system, silent
from nonsmooth.derive.codegen.function import Function, function_of_kernel
from nonsmooth.derive.codegen.gufunc import Wrapped, extension_source, wrapped
from nonsmooth.derive.codegen.header import header_file
from nonsmooth.derive.codegen.naming import module_file
from nonsmooth.derive.codegen.python_file import (
    GENERATE,
    Stamp,
    python_file,
    system_tables,
)
from nonsmooth.derive.codegen.solver import (
    directions_function,
    directions_source,
    solve_function,
    solve_source,
)
from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.derive.declaration.system import System, text_hash
from nonsmooth.derive.document.describe import describe_orbit, describe_system
from nonsmooth.derive.document.hypertext import to_markdown
from nonsmooth.derive.equations.equation_system import EquationSystem
from nonsmooth.derive.errors import DerivationError

EXTENSION = "_kernels.c"
PROVENANCE = "PROVENANCE.json"
COMMAND = "python scripts/regenerate.py"


_INCLUDE = re.compile(r'^#include "(\w+\.h)"$', re.MULTILINE)
_COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
_NAME = re.compile(r"\bnonsmooth_\w+|\bNONSMOOTH_\w+")

# SymPy says NotImplementedError of what it cannot print in C
_NOT_IN_C = (DerivationError, NotImplementedError)


@dataclass(frozen=True)
class EmittedSystem:
    """The files of one system, and what the extension module needs to know of it."""

    name: str
    source: str  # module that declares the system
    derivation: str  # hash of all tables and kernels as emitted; equal ones give equal files
    files: dict[str, str]  # text by file name
    wrapped: tuple[Wrapped, ...]
    underived: dict[str, str]  # by orbit that is composed at run time: why it has no kernels


def emit_library(system: System, orbits: Sequence[Itinerary], source: str) -> dict[str, str]:
    """Sources, by file name, of an extension whose kernels solve orbits at many points.

    The same kernels in Python are among the files. Orbits that have none say so in the
    tables. `source` says in the stamp what declares the system.
    """
    derived = derive_system(system, orbits, use=Use.MANY_POINTS)
    return emit_package([_emitted(derived, source, GENERATE)], GENERATE)


def emit_system(
    system: System,
    orbits: Sequence[Itinerary],
    source: str,
    progress: Progress = silent,
    command: str = COMMAND,
) -> EmittedSystem:
    """Derive a system and its orbits; gives all its files.

    What C cannot hold, such as an orbit with too many reduced unknowns, is left to Python.
    `source` names the module that declares the system and `command` says how the files are
    made again, both for the stamps; `progress` gets the name of each step when it begins.
    """
    derived = derive_system(system, orbits, progress)
    progress(f"{system.name}: equations in LaTeX")
    orbits_told = (o if isinstance(o, EquationSystem) else o.itinerary for o in derived.orbits)
    documents = [describe_system(system), *map(describe_orbit, orbits_told)]
    progress(f"{system.name}: Python and C")
    return _emitted(derived, source, command, tuple(map(to_markdown, documents)))


def _emitted(
    derived: DerivedSystem, source: str, command: str, documents: Sequence[str] = ()
) -> EmittedSystem:
    """A system's files in Python and C, and one of its documents if there are some."""
    name, tables = derived.system.name, system_tables(derived)
    functions, missing = _c_functions(derived)
    definitions = functions.values() if documents else ()
    derivation = text_hash(tables, *derived.functions, *definitions)
    stamp = Stamp(source, derivation, command)
    emitted = {
        module_file(name, ".py"): python_file(stamp, name, tables, derived.functions),
        **_c_files(stamp, derived, functions, missing),
    }
    if documents:
        comment = "\n".join(["<!--", *stamp.lines, "-->"])
        emitted[module_file(name, ".md")] = "\n\n".join([comment, *documents]) + "\n"
    return EmittedSystem(
        name,
        source,
        derivation,
        emitted,
        tuple(chain.from_iterable(map(wrapped, functions))),
        {orbit.itinerary.name: orbit.reason for orbit in derived.underived},
    )


def _c_functions(derived: DerivedSystem) -> tuple[dict[Function, str], dict[Function, str]]:
    """Definitions of all functions in C, and of those that it cannot hold the reason."""
    system = derived.system.name
    wanted: list[tuple[Function, Callable[[], str]]] = [
        (function_of_kernel(kernel, system, orbit), partial(c_kernel, kernel, system, orbit))
        for kernel, orbit, _ in derived.kernels
    ]
    wanted += [
        (describe(orbit), partial(define, orbit))
        for orbit in derived.derived
        for describe, define in (
            (solve_function, solve_source),
            (admissible_function, admissible_source),
            (directions_function, directions_source),
        )
    ]
    defined: dict[Function, str] = {}
    missing: dict[Function, str] = {}
    for function, define in wanted:
        try:
            definition = define()
            for absent, reason in missing.items():
                if re.search(rf"\b{in_lane(absent.name)}\(", definition):
                    raise DerivationError(reason)
        except _NOT_IN_C as problem:
            missing[function] = " ".join(str(problem).split())
        else:
            defined[function] = definition
    return defined, missing


def emit_package(systems: Sequence[EmittedSystem], command: str = COMMAND) -> dict[str, str]:
    """Texts by file name of a whole folder: the files of the systems, and those they share.

    Shared are the extension module, the headers and PROVENANCE.json, which records that
    `command` makes the files.
    """
    emitted: dict[str, str] = {}
    origins: dict[str, tuple[str, str]] = {}
    for system in systems:
        emitted |= system.files
        origins |= {file: (system.source, system.derivation) for file in system.files}
    extension = extension_source(
        [ufunc for system in systems for ufunc in system.wrapped],
        [(s.name, s.derivation) for s in systems],
    )
    headers = included([*emitted.values(), extension])
    overall = text_hash(*headers.values(), *(s.derivation for s in systems))
    stamp = Stamp(", ".join(s.source for s in systems), overall, command)
    emitted[EXTENSION] = stamp.c() + "\n" + extension
    origins[EXTENSION] = (stamp.source, overall)
    for name, text in headers.items():
        shared = Stamp(f"nonsmooth.derive.codegen/support/{name}", text_hash(text), command)
        emitted[name] = shared.c() + "\n" + text
        origins[name] = (shared.source, shared.derivation)
    record = {
        "command": command,
        "sympy": sp.__version__,
        "systems": [s.name for s in systems],
        "files": {
            file: {
                "source": origins[file][0],
                "derivation": origins[file][1],
                "sha256": hashlib.sha256(emitted[file].encode()).hexdigest(),
            }
            for file in sorted(emitted)
        },
    }
    emitted[PROVENANCE] = json.dumps(record, indent=2) + "\n"
    return emitted


def _c_files(
    stamp: Stamp,
    derived: DerivedSystem,
    functions: Mapping[Function, str],
    missing: Mapping[Function, str],
) -> dict[str, str]:
    """Header and source of a system in C, by file name."""
    header, source = (module_file(derived.system.name, suffix) for suffix in (".h", ".c"))
    body = "\n\n".join(functions.values())
    support = "\n".join(f'#include "{name}"' for name in including(body))
    head = [f'{stamp.c()}\n#include "{header}"', "#include <math.h>", *filter(None, [support])]
    return {
        header: header_file(stamp, derived, functions, missing),
        source: "\n\n".join([*head, f"{body}\n"]),
    }


@cache
def _texts() -> dict[str, str]:
    """Texts of all support headers by name."""
    folder = files("nonsmooth.derive.codegen").joinpath("support")
    found = {path.name: path.read_text(encoding="utf-8") for path in folder.iterdir()}
    return dict(sorted(found.items()))


def included(sources: Iterable[str]) -> dict[str, str]:
    """Texts, by name, of the support headers that sources include, directly or through others."""
    texts, waiting = _texts(), list(sources)
    names: set[str] = set()
    while waiting:
        more = {*_INCLUDE.findall(waiting.pop())} & texts.keys() - names
        names |= more
        waiting += [texts[name] for name in more]
    return {name: text for name, text in texts.items() if name in names}


def including(body: str) -> list[str]:
    """Names of the support headers whose own names occur in C definitions."""
    used = {*_NAME.findall(body)}
    return [name for name, text in _texts().items() if used & _own_names(text)]


@cache
def _own_names(text: str) -> frozenset[str]:
    """Names in the code of a support header that none of those it includes has."""
    code, *others = (_COMMENT.sub("", each) for each in (text, *included([text]).values()))
    return frozenset(_NAME.findall(code)).difference(*map(_NAME.findall, others))
