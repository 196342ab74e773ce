"""What a declaration is given: made what the annotations of its fields say, or refused in a line.

Numbers and expressions become exact expressions of SymPy, sequences tuples, and mappings
dictionaries; a record of another kind, and a value where several have to stand, are refused.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Set
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

import sympy as sp

from nonsmooth.derive.declaration.real_numbers import settled
from nonsmooth.derive.errors import DeclarationError

__all__ = ["declared", "exact", "made", "set_fields", "shown"]

_Class = TypeVar("_Class", bound=type)

_NUMBER = r"(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
_FORMULA = re.compile(rf"(?:\s|{_NUMBER}|[^\W\d]\w*|\*\*|[-+*/(),^])*")
_FUNCTIONS = {
    *("sqrt", "exp", "log", "sin", "cos", "tan", "cot", "asin", "acos", "atan", "sinh", "cosh"),
    *("tanh", "Rational", "root", "cbrt"),
}
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
        for name, annotation in _annotations(cls).items():
            where = f"{name} of {cls.__name__}{called}"
            set_fields(self, **{name: made(annotation, getattr(self, name), where)})
        if check is not None:
            check(self)

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
        if isinstance(given, Set) and kind is not frozenset:
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
    if isinstance(expression, str) and not _is_formula(expression):
        raise DeclarationError(f"{shown(expression)} is not the text of a formula")
    try:
        found = sp.sympify(expression)
    except (sp.SympifyError, TypeError, AttributeError):
        found = None
    if not isinstance(found, sp.Expr) or found.is_Matrix:
        raise DeclarationError(f"{shown(expression)} is neither a number nor an expression")
    floats = found.atoms(sp.Float)
    return settled(found.xreplace({f: sp.Rational(repr(float(f))) for f in floats}))


def _is_formula(text: str) -> bool:
    """Whether a text has numbers, names, operators and known functions alone: it is evaluated."""
    called = re.findall(r"([^\W\d]\w*)\s*\(", text)
    return bool(_FORMULA.fullmatch(text)) and set(called) <= _FUNCTIONS


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
