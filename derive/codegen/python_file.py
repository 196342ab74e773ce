"""The Python file of a system, without the imports that C and documents need: they take time."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from nonsmooth.derive.codegen.derived import Use, derive_system
from nonsmooth.derive.codegen.tables import system_tables
from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.derive.declaration.system import System

__all__ = ["GENERATE", "Stamp", "emit_python", "python_file", "text_hash"]

GENERATE = "nonsmooth generate FILE.py"  # what makes the files of a declaration


def emit_python(system: System, orbits: Sequence[Itinerary], source: str) -> str:
    """Python file of a system alone, for a first result at once.

    Orbits that can be composed at run time get no kernels if their formulas are long, or
    slow before they are compiled. `source` says in the stamp what declares the system.
    """
    derived = derive_system(system, orbits, use=Use.FIRST_ANSWER)
    tables = system_tables(derived)
    stamp = Stamp(source, text_hash(tables, *derived.functions), GENERATE)
    return python_file(stamp, system.name, tables, derived.functions)


@dataclass(frozen=True)
class Stamp:
    """The comment at the head of a generated file, which says how it was made."""

    source: str  # what declares the system
    derivation: str  # hash of what was derived
    command: str  # how to make the file again

    @property
    def lines(self) -> list[str]:
        """The lines of the comment, without its signs."""
        return [
            "Generated; do not edit.",
            f"Source: {self.source}",
            f"Again: {self.command}",
            f"SymPy {sp.__version__}, derivation {self.derivation}",
        ]

    def c(self) -> str:
        """The stamp as a comment of C."""
        return "/* " + "\n * ".join(self.lines) + " */"

    def python(self) -> str:
        """The stamp as a comment of Python."""
        return "\n".join(f"# {line}" for line in self.lines)


def text_hash(*parts: str) -> str:
    """Hash of the texts as 16 hexadecimal digits."""
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()[:16]


def python_file(stamp: Stamp, name: str, tables: str, functions: Sequence[str]) -> str:
    """Text of a system's Python file: tables, then kernels."""
    body = "\n\n\n".join(functions)
    return (
        f"{stamp.python()}\n"
        f'"""Kernels and tables of the system {name}, over any arithmetic ``lib``."""\n\n'
        f'import json\n\nDERIVATION = "{stamp.derivation}"\n\n{tables}\n\n{body}\n'
    )
