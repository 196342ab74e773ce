"""What a declaration is given: made what the annotations of its fields say, or refused in a line.

Numbers and expressions become exact expressions of SymPy, sequences tuples, and mappings
dictionaries; a record of another kind, and a value where several have to stand, are refused.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, MappingView, Set
from dataclasses import dataclass, field, is_dataclass
from functools import lru_cache
from reprlib import repr
from types import NoneType, UnionType
from typing import (
    Any,
    Literal,
    TypeVar,
    Union,
    cast,
    dataclass_transform,
    get_args,
    get_origin,
    get_type_hints,
)

import numpy as np
import sympy as sp
from sympy.matrices.expressions.matexpr import MatrixExpr

from nonsmooth.derive.declaration.formulas import formula
from nonsmooth.derive.declaration.real_numbers import settled
from nonsmooth.derive.errors import DeclarationError

_Class = TypeVar("_Class", bound=type)

_WORDS = {bool: "True or False", int: "an integer", sp.Symbol: "a symbol", str: "a text"}


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def declared(cls: _Class) -> _Class:
    """A frozen dataclass whose fields are made what their annotations say.

    That is done before its own ``__post_init__`` sees them. A field that is a record may be given
    as the tuple of its entries.
    """
    check = vars(cls).get("__post_init__")

    def finish(self: Any) -> None:
        called = f" {self.name!r}" if isinstance(getattr(self, "name", None), str) else ""
        try:
            for name, annotation in _annotations(cls).items():
                where = f"{name} of {cls.__name__}{called}"
                set_fields(self, **{name: made(annotation, getattr(self, name), where)})
            if check is not None:
                check(self)
        except RecursionError:
            told = f"what {cls.__name__}{called} is given is nested too deeply"
            raise DeclarationError(told) from None

    cls.__post_init__ = finish  # type: ignore[attr-defined]  # which dataclasses look for
    return cast(_Class, dataclass(frozen=True)(cls))


def set_fields(record: object, **values: Any) -> None:
    """Replace fields of a frozen record while it is made."""
    for name, value in values.items():
        object.__setattr__(record, name, value)


def made(annotation: Any, given: Any, where: str) -> Any:
    """What is given as an annotation describes it.

    DeclarationError says `where` something else was given. Alternatives of
    other kinds than records are told apart by what takes them, and are left as they are, as are
    matrices and what may be anything.
    """
    try:
        given = _without_axes(given)
    except DeclarationError as problem:
        raise DeclarationError(f"{where}: {problem}") from None
    if type(given) is annotation:
        return given
    kind, inner = _parts(annotation)
    if kind in (Union, UnionType):
        others = [each for each in inner if each is not NoneType]
        if given is None and len(others) < len(inner):
            return None
        if len(others) == 1:
            return made(others[0], given, where)
        if all(map(is_dataclass, others)) and not isinstance(given, tuple(others)):
            words = " or ".join(each.__name__ for each in others)
            raise DeclarationError(f"{where} is {shown(given)}, not {words}")
        return given
    if kind is sp.Expr:
        try:
            return exact(given)
        except DeclarationError as problem:
            raise DeclarationError(f"{where}: {problem}") from None
    if kind is Literal:
        if not isinstance(given, str) or given not in inner:
            words = " or ".join(map(repr, inner))
            raise DeclarationError(f"{where} is {shown(given)}, not {words}")
        return given
    if not isinstance(kind, type) or kind is Any or issubclass(kind, sp.MatrixBase):
        return given
    if issubclass(kind, Mapping):
        if not hasattr(given, "items"):
            raise DeclarationError(f"{where} is {shown(given)}, not values by names")
        name, value = inner
        found = {made(name, key, where): made(value, each, where) for key, each in given.items()}
        return sp.Dict(found) if name is sp.Symbol else found  # which has a hash
    if issubclass(kind, Iterable) and inner:
        several = isinstance(given, Iterable | sp.MatrixBase)
        if not several or isinstance(given, str | bytes | Mapping):
            raise DeclarationError(f"{where} is {shown(given)}, not several values")
        if isinstance(given, Set) and not (kind is frozenset or isinstance(given, MappingView)):
            raise DeclarationError(f"{where} is {shown(given)}, which has no order")
        listed = tuple(given)
        if kind is not tuple or inner[-1] is Ellipsis:
            entries = [made(inner[0], each, where) for each in listed]
            return frozenset(entries) if kind is frozenset else tuple(entries)
        if len(listed) != len(inner):
            raise DeclarationError(f"{where} is {shown(given)}, not {len(inner)} values")
        return tuple(made(*pair, where) for pair in zip(inner, listed, strict=True))
    if is_dataclass(kind) and isinstance(given, tuple | list):
        try:
            return kind(*given)
        except TypeError:
            raise DeclarationError(
                f"{where}: {shown(given)} is not ({', '.join(_annotations(kind))})"
            ) from None
    if not isinstance(given, kind):
        words = _WORDS.get(kind, f"of the kind {kind.__name__}")
        raise DeclarationError(f"{where} is {shown(given)}, not {words}")
    return given


def exact(expression: Any) -> Any:
    """A SymPy expression in which each float is the shortest decimal that it prints as.

    Its irrational numbers are as `settled` gives them. DeclarationError refuses what is no
    number and no expression.
    """
    try:
        found = _expression(_without_axes(expression))
        return settled(found.xreplace({f: _decimal(f) for f in found.atoms(sp.Float)}))
    except RecursionError:
        raise DeclarationError(f"{shown(expression)} is nested too deeply") from None


def _expression(given: Any) -> sp.Expr:
    """What is given as SymPy has it; a text is read, not executed."""
    if isinstance(given, str):
        try:
            return formula(given)
        except DeclarationError as problem:
            raise DeclarationError(
                f"{shown(given)} is not the text of a formula: {problem}"
            ) from None
    try:
        found = sp.sympify(given, strict=True)
    except (sp.SympifyError, TypeError, AttributeError, OverflowError):
        found = None
    if not isinstance(found, sp.Expr) or found.is_Matrix:
        raise DeclarationError(f"{shown(given)} is neither a number nor an expression")
    return found


def _decimal(number: sp.Float) -> sp.Rational:
    """The shortest decimal that a number prints as; refused if no double comes near it."""
    try:
        double = float(number)
    except OverflowError:
        double = math.inf
    if not math.isfinite(double) or (double == 0 and not number.is_zero):
        raise DeclarationError(f"{shown(number)} is beyond the range of doubles")
    return sp.Rational(repr(double))


def rows_of(given: Any, what: str) -> sp.Matrix:
    """A matrix of exact entries: of SymPy, an array, or rows of numbers, expressions and texts.

    DeclarationError refuses anything else, and an array of which a mask leaves out values.
    """
    try:
        if np.ma.is_masked(given):
            raise DeclarationError(f"{shown(given)} has masked values")
        if isinstance(given, MatrixExpr):
            if given.has(sp.MatrixSymbol):
                raise DeclarationError(f"{shown(given)} has no entries")
            given = given.as_explicit()
        if not isinstance(given, sp.MatrixBase):
            given = given.toarray() if hasattr(given, "toarray") else given
            given = np.asarray(given).tolist() if hasattr(given, "__array__") else given
            rows = [
                (row,) if _is_matrix(row) else made(tuple[Any, ...], row, what)
                for row in made(tuple[Any, ...], given, what)
            ]
            given = sp.Matrix([[_block(entry, what) for entry in row] for row in rows])
        if all(entry.is_Rational for entry in given.todok().values()):
            return given
        return given.applyfunc(exact)
    except DeclarationError as problem:
        told = str(problem)
        raise DeclarationError(told if told.startswith(what) else f"{what}: {told}") from None
    except (TypeError, ValueError, AttributeError, RecursionError):
        raise DeclarationError(f"{what} is no matrix: {shown(given)}") from None


def _block(entry: Any, what: str) -> Any:
    """An entry of a matrix, which may be a matrix itself."""
    return rows_of(entry, what) if _is_matrix(entry) else exact(entry)


def _is_matrix(given: Any) -> bool:
    """Whether something is a matrix of SymPy, whose entries may be formulas."""
    return isinstance(given, sp.MatrixBase | MatrixExpr)


def _without_axes(given: Any) -> Any:
    """A number or text of NumPy, also one in an array without axes, as Python has it."""
    if not isinstance(given, np.generic | np.ndarray) or given.shape != ():
        return given
    if np.ma.is_masked(given):
        raise DeclarationError("a masked value is no number")
    return given.item()


def shown(value: Any) -> str:
    """A wrong value on one line, shortened."""
    return " ".join(repr(value).split())


@lru_cache(maxsize=256)
def _parts(annotation: Any) -> tuple[Any, tuple[Any, ...]]:
    """The kind that an annotation names, and the annotations of what is inside."""
    return get_origin(annotation) or annotation, get_args(annotation)


@lru_cache(maxsize=64)
def _annotations(cls: type) -> dict[str, Any]:
    """Annotations of the fields of a class, evaluated."""
    return get_type_hints(cls)
