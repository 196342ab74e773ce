"""The files of generated/: Python, C, header and equations of each system, and their stamps."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from importlib.resources import files

import sympy as sp

from nonsmooth.derive.codegen.admissibility import admissible_prototype, admissible_source
from nonsmooth.derive.codegen.any_arithmetic import python_kernel
from nonsmooth.derive.codegen.c import c_kernel, c_prototype
from nonsmooth.derive.codegen.gufunc import (
    Wrapped,
    extension_source,
    wrapped_functions,
    wrapped_solvers,
)
from nonsmooth.derive.codegen.naming import constant, module_file
from nonsmooth.derive.codegen.solver import solve_prototype, solve_source
from nonsmooth.derive.codegen.tables import system_tables
from nonsmooth.derive.declaration import Declaration
from nonsmooth.derive.document.describe import describe_orbit, describe_system
from nonsmooth.derive.document.markdown import to_markdown
from nonsmooth.derive.equations import EquationSystem, derive_equations
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.itinerary import Itinerary
from nonsmooth.derive.kernels import flow_kernels, orbit_kernels, spectrum_kernel
from nonsmooth.derive.modal import derive_flows
from nonsmooth.derive.program import Kernel
from nonsmooth.derive.system import System

__all__ = ["EmittedSystem", "emit_package", "emit_system"]

SUPPORT = "support.h"
EXTENSION = "_kernels.c"
PROVENANCE = "PROVENANCE.json"
COMMAND = "python scripts/regenerate.py"


@dataclass(frozen=True)
class EmittedSystem:
    """The files of one system, and what the extension module needs to know of it.

    Attributes
    ----------
    name, source : str
        Name of the system and module that declares it.
    derivation : str
        Hash of all tables and kernels as emitted; equal derivations give equal files.
    files : dict of file name to text
    wrapped : tuple of Wrapped
    """

    name: str
    source: str
    derivation: str
    files: dict[str, str]
    wrapped: tuple[Wrapped, ...]


def emit_system(
    system: System,
    orbits: Sequence[Itinerary],
    source: str,
    progress: Callable[[str], None] = lambda step: None,
) -> EmittedSystem:
    """Derive a system and its orbits and emit its files.

    Parameters
    ----------
    system : System
    orbits : sequence of Itinerary
    source : str
        Name of the module that declares them, for the stamps.
    progress : callable
        Told the name of each step when it begins.
    """
    name = system.name
    progress(f"{name}: flows")
    spectrum, flows = derive_flows(system)
    kernels: list[tuple[Kernel, str | None]] = [(spectrum_kernel(spectrum), None)]
    kernels += [(k, None) for k in flow_kernels(system, spectrum, flows)]
    declaration = Declaration(system, spectrum, flows)
    kernels += [(k, None) for k in declaration.kernels()]
    derived: list[EquationSystem] = []
    for orbit in orbits:
        progress(f"{name}/{orbit.name}: equations")
        derived.append(derive_equations(orbit))
        if derived[-1].spectrum != spectrum:
            raise DerivationError(f"{name}/{orbit.name}: its presentation changes the spectrum")
        kernels += [(k, orbit.name) for k in orbit_kernels(derived[-1])]
    tables = system_tables(declaration, derived, kernels)
    progress(f"{name}: Python")
    functions = [python_kernel(kernel, orbit) for kernel, orbit in kernels]
    progress(f"{name}: C")
    definitions = [c_kernel(kernel, name, orbit) for kernel, orbit in kernels]
    for orbit_equations in derived:
        definitions += [solve_source(orbit_equations), admissible_source(orbit_equations)]
    derivation = _hash(tables, *functions, *definitions)
    stamp = _Stamp(source, derivation)
    emitted = {
        module_file(name, ".py"): _python_file(stamp, name, tables, functions),
        module_file(name, ".h"): _header_file(stamp, name, kernels, derived),
        module_file(name, ".c"): _c_file(stamp, name, definitions),
    }
    progress(f"{name}: equations in LaTeX")
    emitted[module_file(name, ".md")] = _markdown_file(stamp, system, derived)
    wrapped = wrapped_functions(name, kernels)
    for orbit_equations in derived:
        wrapped += wrapped_solvers(orbit_equations)
    return EmittedSystem(name, source, derivation, emitted, tuple(wrapped))


def emit_package(systems: Sequence[EmittedSystem]) -> dict[str, str]:
    """All files of generated/: of the systems, and those that they share.

    Shared are the extension module, the support header and PROVENANCE.json, which records
    what made each file.
    """
    support = files("nonsmooth.derive.codegen").joinpath(SUPPORT).read_text(encoding="utf-8")
    overall = _hash(support, *(s.derivation for s in systems))
    emitted: dict[str, str] = {}
    origins: dict[str, tuple[str, str]] = {}
    for system in systems:
        emitted |= system.files
        origins |= {file: (system.source, system.derivation) for file in system.files}
    package = "nonsmooth.derive.codegen"
    stamp = _Stamp(", ".join(s.source for s in systems), overall)
    emitted[EXTENSION] = extension_source(
        stamp.c(),
        [function for system in systems for function in system.wrapped],
        [(s.name, s.derivation) for s in systems],
    )
    origins[EXTENSION] = (stamp.source, overall)
    emitted[SUPPORT] = _Stamp(f"{package}/{SUPPORT}", _hash(support)).c() + "\n" + support
    origins[SUPPORT] = (package, _hash(support))
    record = {
        "command": COMMAND,
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


@dataclass(frozen=True)
class _Stamp:
    source: str
    derivation: str

    @property
    def lines(self) -> list[str]:
        return [
            "Generated; do not edit.",
            f"Source: {self.source}",
            f"Again: {COMMAND}",
            f"SymPy {sp.__version__}, derivation {self.derivation}",
        ]

    def c(self) -> str:
        return "/* " + "\n * ".join(self.lines) + " */"

    def python(self) -> str:
        return "\n".join(f"# {line}" for line in self.lines)


def _hash(*parts: str) -> str:
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()[:16]


def _python_file(stamp: _Stamp, name: str, tables: str, functions: Sequence[str]) -> str:
    body = "\n\n\n".join(functions)
    return (
        f"{stamp.python()}\n"
        f'"""Kernels and tables of the system {name}, over any arithmetic ``lib``."""\n\n'
        f'DERIVATION = "{stamp.derivation}"\n\n{tables}\n\n{body}\n'
    )


def _header_file(
    stamp: _Stamp,
    name: str,
    kernels: Sequence[tuple[Kernel, str | None]],
    orbits: Sequence[EquationSystem],
) -> str:
    guard = constant(name, "h")
    prototypes = [c_prototype(kernel, name, orbit) for kernel, orbit in kernels]
    for orbit in orbits:
        prototypes += [solve_prototype(orbit), admissible_prototype(orbit)]
    body = "\n".join(f"{p};" for p in prototypes)
    return (
        f"{stamp.c()}\n#ifndef {guard}\n#define {guard}\n\n"
        "#include <stddef.h>\n#include <stdint.h>\n\n"
        '#ifdef __cplusplus\nextern "C" {\n#endif\n\n'
        f"{body}\n\n#ifdef __cplusplus\n}}\n#endif\n\n#endif\n"
    )


def _c_file(stamp: _Stamp, name: str, definitions: Sequence[str]) -> str:
    body = "\n\n".join(definitions)
    return (
        f'{stamp.c()}\n#include "{module_file(name, ".h")}"\n\n'
        f'#include <math.h>\n\n#include "{SUPPORT}"\n\n{body}\n'
    )


def _markdown_file(stamp: _Stamp, system: System, orbits: Sequence[EquationSystem]) -> str:
    documents = [describe_system(system), *(describe_orbit(orbit) for orbit in orbits)]
    comment = "\n".join(["<!--", *stamp.lines, "-->"])
    return comment + "\n\n" + "\n\n".join(to_markdown(document) for document in documents) + "\n"
