"""Declarations of users: what they have to offer, and the files that hold them."""

from __future__ import annotations

import ast
import builtins
import hashlib
import importlib.util
import os
import re
import sys
import traceback
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, redirect_stdout
from dataclasses import dataclass, fields
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from types import ModuleType
from typing import Any, Protocol, runtime_checkable

from nonsmooth.runtime.core.errors import InputError, one_line

_DERIVATION = ("nonsmooth.derive", "nonsmooth.derive.systems")
_SYMBOLIC = ("sympy", "math", "fractions", "itertools")
# what of the derivation reads other files, or imports what is named to it
_READING = frozenset([
    "read_matrices", "reduce_structure", "import_module", "ModuleType", "register", "registered",
    "*",
])  # fmt: skip
# a view of keys is a set of no order under an operator: it is only gone through, or listed
_VIEWS, _LISTING = {"keys", "items"}, {"list", "tuple", "dict", "sorted", "enumerate", "zip", "len"}
# what a file may take from these modules, or ask of what it has; all depends on arguments alone
_PLAIN = frozenset([
    "symbols", "Symbol", "Rational", "Integer", "Float", "Matrix", "eye", "zeros", "ones", "diag",
    "sqrt", "exp", "log", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh",
    "pi", "oo", "E", "Abs", "Fraction", "chain", "combinations", "product", "repeat", "pairwise",
    "append", "extend", "insert", "items", "keys", "values", "get", "T", "dot",
    "states", "parameters", "configurations", "transitions", "boundaries", "symbol", "mass",
    "stiffness", "damping", "orbits", "name",
    "system",
])  # fmt: skip
_BUILT_IN = frozenset([
    "range", "enumerate", "zip", "map", "filter", "len", "sum", "abs", "min", "max", "list",
    "tuple", "dict", "str", "float", "int", "bool", "sorted", "reversed", "round", "any", "all",
    "pow", "slice", "isinstance", "ValueError",
])  # fmt: skip
_HARMLESS = re.compile(r"[^(\['\"]*")  # a text that can do nothing, even if it is evaluated


@runtime_checkable
class DeclaredSystem(Protocol):
    """A system that can be derived: `nonsmooth.derive.System`."""

    @property
    def name(self) -> str:
        """Name of the system."""
        ...

    def fingerprint(self, orbits: Sequence[Any] = ()) -> str:
        """Hash of the declaration of the system and of some orbits of it."""
        ...

    def source(self, orbits: Sequence[Any] = ()) -> str:
        """Tables and kernels of the system and the orbits as Python text."""
        ...

    def library(self, orbits: Sequence[Any] = ()) -> dict[str, str]:
        """The files of kernels that solve orbits at many points, in C and in Python."""
        ...


@runtime_checkable
class DeclaredOrbit(Protocol):
    """An orbit of such a system: `nonsmooth.derive.Itinerary`."""

    @property
    def name(self) -> str:
        """Name of the orbit."""
        ...

    @property
    def system(self) -> Any:
        """The system that it is an orbit of."""
        ...

    @property
    def phases(self) -> Sequence[Any]:
        """Its phases."""
        ...


@dataclass(frozen=True)
class Declared:
    """The system and the orbits that a file declares."""

    system: DeclaredSystem
    orbits: tuple[DeclaredOrbit, ...]


def declaration_in(path: Path) -> Declared:
    """Execute a Python file and take its `system`, and its `orbits` if it defines any.

    While it runs, modules of its folder can be imported. Raises `InputError` if the file cannot
    be read, fails (the message gives the line) or declares no system.
    """
    try:
        return _declared(path, _executed(path))
    except (InputError, KeyboardInterrupt):
        raise
    except BaseException as problem:  # also of the types of what it declares
        raise _failure(path, problem) from problem


def hash_of_text(path: Path) -> str | None:
    """Hash of a file and of the code that it runs; None if more than these may decide what it does.

    They decide if the file imports SymPy and the derivation alone and uses known names of them.
    """
    try:
        content = path.read_bytes()
        nodes = list(ast.walk(ast.parse(content)))
    except (OSError, SyntaxError, ValueError, RecursionError, MemoryError):
        return None
    alone = {id(node.value) for node in nodes if isinstance(node, ast.Expr)}  # as docstrings are
    listed = {id(part.func) for part in _gone_through(nodes) if isinstance(part, ast.Call)}
    for node in nodes:
        if isinstance(node, ast.Attribute) and node.attr in _VIEWS and id(node) not in listed:
            return None
        if not (_depends_on_text(node) or (isinstance(node, ast.Constant) and id(node) in alone)):
            return None
    return hashlib.sha256(_code() + content).hexdigest()


def _gone_through(nodes: list[ast.AST]) -> Iterator[ast.expr]:
    """The parts of a file of which the entries are taken one after the other."""
    for node in nodes:
        match node:
            case ast.For(iter=entries) | ast.comprehension(iter=entries):
                yield entries
            case ast.Call(func=ast.Name(id=name), args=arguments) if name in _LISTING:
                yield from arguments


def _depends_on_text(node: ast.AST) -> bool:
    """Whether a part of a file is known to give the same in every run."""
    match node:
        case ast.Import(names=names):
            return {alias.name for alias in names} <= {*_SYMBOLIC}
        case ast.ImportFrom(module=module, names=names, level=0):
            taken = {alias.name for alias in names}
            if module in _DERIVATION:
                return not taken & _READING
            return module in _SYMBOLIC and taken <= _PLAIN
        case ast.Attribute(attr=name):
            return name in _PLAIN
        case ast.Name(id=name):
            return name in _BUILT_IN or not (hasattr(builtins, name) or name.startswith("__"))
        case ast.Constant(value=str(text)):
            return bool(_HARMLESS.fullmatch(text))
        case ast.Set(elts=entries):  # of more the order differs from run to run
            return len(entries) == 1 and not isinstance(entries[0], ast.Starred)
        case ast.BitOr() | ast.BitAnd() | ast.BitXor():  # of sets
            return False
        case ast.Try() | ast.TryStar():  # which may catch what the depth of the stack decides
            return False
        case ast.ImportFrom() | ast.Match() | ast.SetComp():
            return False
    return True


@cache
def _code() -> bytes:
    """Hash of the code that derives, and of SymPy's version."""
    digest = hashlib.sha256()
    derive, sympy = (
        Path(str(spec.origin)).parent
        for spec in map(find_spec, ("nonsmooth.derive", "sympy"))
        if spec is not None
    )
    for path in (*sorted(derive.rglob("*.py")), sympy / "release.py"):
        digest.update(path.name.encode() + path.read_bytes())
    return digest.digest()


def _declared(path: Path, module: ModuleType) -> Declared:
    """The `system` and the `orbits` of a module; refused if they are of other types."""
    if not hasattr(module, "system"):
        raise InputError(f"{path} declares no system: call one `system`, such as system = System()")
    system, orbits = module.system, getattr(module, "orbits", ())
    if not _derivable("System", system):
        raise InputError(f"{path}: `system` is of type {type(system).__name__}, not a System")
    if not isinstance(orbits, tuple | list):
        kind = type(orbits).__name__
        raise InputError(f"{path}: `orbits` is of type {kind}, not a list of Itinerary")
    for orbit in orbits:
        if not _derivable("Itinerary", orbit):
            kind = type(orbit).__name__
            raise InputError(f"{path}: `orbits` holds one of type {kind}, not an Itinerary")
    for made in (system, *orbits):
        known = {*dir(type(made)), *vars(made)}  # nothing is asked for, which might take long
        if not all(field.name in known for field in fields(made)):
            kind = type(made).__name__
            raise InputError(f"{path}: one of type {kind} is not made by calling its class")
    for orbit in orbits:
        if [other.name for other in orbits].count(orbit.name) > 1:
            raise InputError(f"{path}: orbit {orbit.name!r} is declared twice")
        if orbit.system is not system and orbit.system != system:
            raise InputError(f"{path}: orbit {orbit.name!r} is one of another system")
    return Declared(system, tuple(orbits))


def _derivable(kind: str, found: object) -> bool:
    """Whether an object is an instance of the derivation's class of this kind."""
    return any(
        each.__name__ == kind and each.__module__.startswith("nonsmooth.derive.")
        for each in type(found).__mro__
    )


def _executed(path: Path) -> ModuleType:
    """The module of a file, read anew even if it was imported; its output goes to stderr."""
    name = f"nonsmooth_file_{hashlib.sha256(os.fsencode(path)).hexdigest()[:16]}"
    spec = importlib.util.spec_from_file_location(name, path)
    if spec is None:
        raise InputError(f"{path} is no Python file")
    module = importlib.util.module_from_spec(spec)
    try:
        code = compile(path.read_bytes(), str(path), "exec")
        with _importing_from(path.parent, module), redirect_stdout(sys.stderr):
            exec(code, module.__dict__)
    except OSError as problem:
        if problem.filename is not None and Path(problem.filename) == path:
            reason = problem.strerror or str(problem)
            raise InputError(f"{path} cannot be read: {reason.lower()}") from None
        raise _failure(path, problem) from problem
    return module


@contextmanager
def _importing_from(folder: Path, module: ModuleType) -> Iterator[None]:
    """In the block, let a module import from its folder; forget those imports afterwards."""
    before, place = set(sys.modules), str(folder)
    sys.modules[module.__name__] = module
    sys.path.insert(0, place)
    try:
        yield
    finally:
        sys.path.remove(place)
        # another folder may have modules of the same names, and these may be edited
        # and the package itself, whose checkout may lie in the folder, is there once
        for name in set(sys.modules) - before - {module.__name__}:
            if name.partition(".")[0] == __name__.partition(".")[0]:
                continue
            file = getattr(sys.modules[name], "__file__", None)
            if file is not None and _beside(Path(file), folder):
                del sys.modules[name]


def _beside(file: Path, folder: Path) -> bool:
    """Whether a module's file belongs to a folder itself, not to an environment inside it."""
    return folder in file.parents and "site-packages" not in file.relative_to(folder).parts


def _failure(path: Path, problem: BaseException) -> InputError:
    """An error of one line: the file, the line of it that failed, and why."""
    if isinstance(problem, SyntaxError) and problem.filename is not None:
        place = f"{problem.filename}, line {problem.lineno}"
        return InputError(f"{place}: {type(problem).__name__}: {problem.msg}")
    frames = traceback.extract_tb(problem.__traceback__)
    lines = [frame.lineno for frame in frames if frame.filename == str(path)]
    place = f"{path}, line {lines[-1]}" if lines else str(path)
    try:
        reason = one_line(str(problem))
    except BaseException:  # of the file's own exception
        reason = "an exception that cannot be shown"
    if not type(problem).__module__.startswith("nonsmooth."):
        reason = f"{type(problem).__name__}: {reason}".removesuffix(": ")
    return InputError(f"{place}: {reason}")
