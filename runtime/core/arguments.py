"""What public functions take, checked by their annotations before anything is computed.

`checked` reads the annotations when a function is called for the first time. Arguments whose types
were right together before cost a look into a set; others are judged by what the annotation says.
"""

from __future__ import annotations

import builtins
import collections.abc
import inspect
import operator
import os
import types
import typing
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from decimal import Decimal
from functools import wraps
from numbers import Real
from typing import Any, NamedTuple, TypeVar

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import Value, parse

_Checked = TypeVar("_Checked", bound=Callable[..., Any])
_Class = TypeVar("_Class", bound=type)

_SHOWN = 60  # characters of a wrong value
_ANYTHING = (Any, object, inspect.Parameter.empty)
_WORDS = {  # of classes whose values users pass on
    "Branch": "a branch, as continue_orbit returns",
    "DeclaredOrbit": "a declaration",
    "DeclaredSystem": "a declaration",
    "Event": "an event of a branch",
    "Generator": "a generator of random numbers",
    "Experiment": "an experiment",
    "Orbit": "an orbit, as solve returns",
    "OrbitKernels": "kernels",
    "ndarray": "an array",
    "Path": "a path",
    "PathLike": "a path",
    "Recurrence": "a recurrence, as itinerary_of returns",
    "SeedSequence": "a seed sequence",
    "SystemKernels": "kernels",
    "Trajectory": "a motion, as simulate returns",
}


class _Taken(NamedTuple):
    """One kind of value that an argument takes."""

    words: str  # what a message calls it; empty for None
    fits: Callable[[Any], bool]
    by_type: bool  # whether all values of a type fit if one does; arrays are judged singly
    name: str = ""  # of an attribute by which records hold such a value


class _Unimported(type):
    """A class that an annotation names and that is imported for type checkers alone."""

    def __getattr__(cls, name: str) -> _Unimported:
        if name.startswith("__"):
            raise AttributeError(name)
        return _Unimported(name, (), {})

    def __getitem__(cls, _: object) -> _Unimported:
        return cls


class _Names(dict[str, Any]):
    """Names of a module, with stand-ins for those that are imported for type checkers alone."""

    def __missing__(self, name: str) -> Any:
        for module in (builtins, collections.abc):
            if hasattr(module, name):
                return getattr(module, name)
        return os if name == "os" else _Unimported(name, (), {})


def checked(function: _Checked) -> _Checked:
    """Make a function, or a class, refuse arguments that its annotations do not allow.

    An `InputError` names the argument, what was given, and what it takes. What takes numbers
    of Python alone gets these, whatever kind of number was given, and values that can be gone
    through once alone come as a tuple.
    """
    if isinstance(function, type):
        function.__init__ = checked(function.__init__)  # type: ignore[misc]  # the __init__ of a class is replaced
        return function
    known: _Arguments | None = None
    sure = set[tuple[object, ...]]()  # names and types of arguments of which all values fit

    @wraps(function)
    def call(*given: Any, **named: Any) -> Any:
        nonlocal known
        kinds = (*map(type, given), *named, *map(type, named.values()))
        if kinds in sure:
            return function(*given, **named)
        if known is None:
            known = _arguments(function)
        arguments, places, rest = known
        for place, (argument, value) in enumerate(zip(places, given, strict=False)):
            if type(value) not in argument.types:
                plain = argument.plain(value)
                if plain is not value:
                    given = (*given[:place], plain, *given[place + 1 :])
        if rest is not None:
            for value in given[len(places) :]:
                rest.plain(value)
        for name, value in named.items():
            if name in arguments and type(value) not in arguments[name].types:
                named[name] = arguments[name].plain(value)
        if known.sure_of(given, named):
            sure.add(kinds)
        return function(*given, **named)

    return call  # type: ignore[return-value]  # it takes and returns what `function` does


def checked_methods(cls: _Class) -> _Class:
    """Make the public methods of a class check what they take."""
    for name, method in list(vars(cls).items()):
        if inspect.isfunction(method) and not name.startswith("_"):
            told = {k: v for k, v in method.__annotations__.items() if k != "return"}
            if not {*told.values()} <= {"Any", "object"}:
                setattr(cls, name, checked(method))
    return cls


class _Argument:
    """An argument, with what it takes; None if it takes anything."""

    def __init__(self, name: str, taken: tuple[_Taken, ...] | None) -> None:
        self.name, self.taken = name, taken
        self.types: set[type] = set()  # of which all values fit, as they are
        kinds = [kind for kind in taken or () if kind.words]
        self._several = any(kind.words.startswith("several") for kind in kinds)
        self._plainly = _PLAINLY.get(kinds[0].words) if len(kinds) == 1 else None

    def plain(self, value: Any) -> Any:
        """The value as the function takes it; one that is of no kind that is taken is refused."""
        if self.taken is None:
            self.types.add(type(value))
            return value
        if self._several and isinstance(value, Iterator):
            value = tuple(value)
        for kind in self.taken:
            if kind.fits(value):
                if kind.words and self._plainly and type(value) not in (int, float, str):
                    return self._plainly(value)
                if kind.by_type and not hasattr(value, "ndim"):
                    self.types.add(type(value))
                return value
        words = _words(self.taken)
        parts = (f"{kind.name}{s}" for kind in self.taken for s in ("", "s") if kind.name)
        part = next((f"; it has .{part}" for part in parts if hasattr(value, part)), "")
        raise InputError(f"{self.name} takes {words}, not {_shown(value)}{part}")


class _Arguments(NamedTuple):
    """The arguments of a function."""

    named: dict[str, _Argument]
    places: list[_Argument]  # those that may be given by their places
    rest: _Argument | None  # what takes all further places, if anything does

    def sure_of(self, given: Sequence[object], named: Mapping[str, object]) -> bool:
        """Whether all values of the types of these fit, as they are."""
        others = [self.rest] * (len(given) - len(self.places)) if self.rest else []
        pairs: list[tuple[_Argument | None, object]] = [
            *zip([*self.places, *others], given, strict=False),
            *((self.named.get(name), value) for name, value in named.items()),
        ]
        return all(
            argument is not None and type(value) in argument.types for argument, value in pairs
        )


def _arguments(function: Callable[..., Any]) -> _Arguments:
    """The arguments of a function, as its annotations describe them."""
    names = _Names(function.__globals__)
    found, places, rest = dict[str, _Argument](), list[_Argument](), None
    for name, parameter in inspect.signature(function).parameters.items():
        found[name] = _Argument(name, _taken(parameter.annotation, names))
        if parameter.kind in (parameter.POSITIONAL_ONLY, parameter.POSITIONAL_OR_KEYWORD):
            places.append(found[name])
        elif parameter.kind is parameter.VAR_POSITIONAL:
            rest = found[name]
    return _Arguments(found, places, rest)


def _taken(annotation: Any, names: _Names) -> tuple[_Taken, ...] | None:
    """What an annotation allows; None for anything."""
    if isinstance(annotation, str):
        annotation = eval(annotation, {}, names)
    if annotation in _ANYTHING:
        return None
    origin, inner = typing.get_origin(annotation), typing.get_args(annotation)
    if origin in (typing.Union, types.UnionType):
        parts = [_taken(part, names) for part in inner]
        found = tuple(kind for part in parts if part for kind in part)
        return None if None in parts else found
    if origin is typing.Annotated:
        return _taken(inner[0], names)
    if origin is typing.Literal:
        words = " or ".join(map(repr, inner))
        return (_Taken(words, lambda value: isinstance(value, str) and value in inner, False),)
    if not isinstance(origin, type) or not issubclass(origin, Iterable):
        return (_kind(origin or annotation, []),)
    values = inner[1:] if issubclass(origin, Mapping) else inner
    several = Sequence if origin is tuple and Ellipsis in values else origin
    parts = [_taken(part, names) for part in values if part is not Ellipsis]
    return (_kind(several, [part and tuple(map(_inside, part)) for part in parts]),)


def _inside(kind: _Taken) -> _Taken:
    """A kind of value inside of others, where a number may be written as a text."""
    return _Taken(kind.words, _is_written, False) if kind is _PLAIN[float] else kind


def _kind(cls: Any, inner: list[tuple[_Taken, ...] | None]) -> _Taken:
    """One kind of value: all of a class, or containers of values that are checked as well."""
    if cls in (None, types.NoneType):
        return _Taken("", lambda value: value is None, True)
    if cls in _PLAIN:
        return _PLAIN[cls]
    each = inner[0] if inner else None
    if cls is Callable:
        return _Taken("a function", callable, False)
    if isinstance(cls, type) and issubclass(cls, Mapping):
        return _Taken(
            f"{_plural(each)} by names",
            lambda value: _is_by_name(value) and _all_fit(each, value.values()),
            False,
        )
    if cls is tuple and inner:
        return _Taken(
            f"{_COUNTS.get(len(inner), len(inner))} {_plural(each)}",
            lambda value: (
                _listed(value)
                and len(value) == len(inner)
                and all(_all_fit(kinds, [part]) for kinds, part in zip(inner, value, strict=True))
            ),
            False,
        )
    if isinstance(cls, type) and issubclass(cls, Iterable) and cls.__module__ in _CONTAINERS:
        return _Taken(
            f"several {_plural(each)}",
            lambda value: _is_several(value, cls, each),
            False,
        )
    return _of_class(cls)


# by the words for a kind: what makes the plain value of any that fits
_PLAINLY: dict[str, Callable[[Any], Any]] = {
    "a number": float,
    "an integer": operator.index,
    "a text": os.fspath,
}
_COUNTS = {2: "two", 3: "three"}
_PLURALS = {"a text": "texts", "a number": "numbers", "an integer": "integers"}
_TEXT = frozenset({str})
_CONTAINERS = ("builtins", "collections.abc")


def _listed(value: Any) -> bool:
    """Tell whether a value is a sequence of others: no text, and no values by names.

    A series or a frame of pandas has names, which its order would not heed.
    """
    if isinstance(value, str | bytes | Mapping) or hasattr(value, "items"):
        return False
    return isinstance(value, Sequence) or (hasattr(value, "__array__") and bool(value.ndim))


def _is_by_name(value: Any) -> bool:
    """Tell whether a value holds others by names."""
    if type(value) is not dict and not isinstance(value, Mapping):
        return False
    kinds = {*map(type, value)}
    return kinds <= _TEXT or all(issubclass(kind, str) for kind in kinds)


def _is_several(value: Any, cls: type, each: tuple[_Taken, ...] | None) -> bool:
    """Tell whether a value holds several others; a text does where texts are asked for."""
    if isinstance(value, str):
        return each is not None and _all_fit(each, [value])
    if _listed(value):
        return _all_fit(each, value)
    return not issubclass(cls, Sequence) and isinstance(value, Iterable)


def _all_fit(kinds: tuple[_Taken, ...] | None, values: Iterable[Any]) -> bool:
    return kinds is None or all(any(kind.fits(value) for kind in kinds) for value in values)


def _words(kinds: Iterable[_Taken]) -> str:
    """Words for values of one of several kinds."""
    words = list(dict.fromkeys(kind.words for kind in kinds if kind.words))
    return " or ".join(filter(None, (", ".join(words[:-1]), words[-1])))


def _plural(kinds: tuple[_Taken, ...] | None) -> str:
    """Words for several values, each of one of the kinds."""
    if kinds is None:
        return "values"
    words = [_PLURALS.get(kind.words, kind.words) for kind in kinds if kind.words]
    return " or ".join(each.replace("two ", "pairs of ") for each in words)


def _shown(value: Any) -> str:
    """A wrong value in a message: as it is written, or its type where that is long."""
    text = repr(value)
    if len(text) <= _SHOWN and text.isprintable():
        return text
    return _with_article(type(value).__name__)


def _with_article(name: str) -> str:
    return f"{'an' if name[0] in 'AEIOUaeiou' else 'a'} {name}"


def _of_class(cls: Any) -> _Taken:
    """Values of a class; one that is not imported here is known by its name."""
    name = cls.__name__
    words = _WORDS.get(name, _with_article(name))
    if isinstance(cls, _Unimported):
        return _Taken(
            words,
            lambda value: any(base.__name__ == name for base in type(value).__mro__),
            True,
            name.lower(),
        )

    def fits(value: Any) -> bool:
        try:
            return isinstance(value, cls) and not isinstance(value, str)
        except TypeError:  # a protocol that tells nothing at run time
            return True

    return _Taken(words, fits, True, name.lower())


def _is_integer(value: Any) -> bool:
    if isinstance(value, bool):
        return False
    try:
        operator.index(value)
    except TypeError:
        return False
    return True


def _is_number(value: Any) -> bool:
    """Tell whether a value is a real number: no truth value, and an array of no axes is one."""
    if isinstance(value, bool) or type(value).__name__ in ("bool", "bool_"):
        return False
    if getattr(value, "ndim", None) == 0 and hasattr(value, "dtype"):
        return value.dtype.kind in "iuf"
    return isinstance(value, Real | Decimal | Value)


def _is_written(value: Any) -> bool:
    """Tell whether a value is a real number or the text of one."""
    try:
        return _is_number(value) or bool(isinstance(value, str) and parse(value))
    except InputError:
        return False


def _is_truth(value: Any) -> bool:
    return isinstance(value, bool) or type(value).__name__ in ("bool", "bool_")


_PLAIN: dict[Any, _Taken] = {
    # systems and orbits are named by paths too
    str: _Taken("a text", lambda value: isinstance(value, str | os.PathLike), True),
    bool: _Taken("True or False", _is_truth, True),
    int: _Taken("an integer", _is_integer, True),
    float: _Taken("a number", _is_number, True),
    os.PathLike: _Taken("a path", lambda value: hasattr(value, "__fspath__"), True),
}
