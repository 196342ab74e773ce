"""The exceptions of the package, under one root.

Bad input is a `ValueError` too and a missing optional package an `ImportError` too, so
callers may catch either the usual exception or `NonsmoothError`. Every message is one line.
"""

from collections.abc import Iterable
from difflib import get_close_matches
from typing import Any

LONGEST_LINE = 1000  # characters of a message
_LONGEST_NAME = 80
_LONGEST_LIST = 160


class NonsmoothError(Exception):
    """Root of every exception that this package raises on purpose."""


class InputError(NonsmoothError, ValueError):
    """The input is wrong; the message names what and why."""


class NoConvergence(NonsmoothError):
    """An iteration ended without an answer; the message says what was tried."""


class MissingExtra(NonsmoothError, ImportError):
    """An optional package is needed; the message gives the command that installs it."""


class Interrupted(KeyboardInterrupt):
    """A long work was interrupted; `partial` is what it had found until then.

    Whoever does not ask for it sees the usual KeyboardInterrupt.
    """

    def __init__(self, partial: object) -> None:
        super().__init__("interrupted")
        self.partial = partial


def unknown_name(kind: str, name: object, known: Iterable[str]) -> InputError:
    """An `InputError` that a name is unknown, with the nearest one and all that exist.

    `kind` says what is named, such as ``"parameter"`` or ``"orbit"``; `known` is listed in
    its order. The caller raises the error.

    Examples
    --------
    >>> unknown_name("parameter", "etta", ["chi", "eta", "V"])
    InputError("unknown parameter 'etta'; did you mean 'eta'? known: chi, eta, V")
    """
    names = list(known)
    if not isinstance(name, str):
        return InputError(f"{kind}: {one_line(repr(name))} is no name; known: {_listed(names)}")
    if len(name) > _LONGEST_NAME:
        name = f"{name[:_LONGEST_NAME]}..."
    lowered = {other.lower(): other for other in reversed(names)}
    nearest = get_close_matches(name.lower(), lowered, n=1, cutoff=0.4)
    hint = f" did you mean {lowered[nearest[0]]!r}?" if nearest else ""
    listing = f" known: {_listed(names)}" if names else ""
    separator = ";" if hint or listing else ""
    return InputError(f"unknown {kind} {name!r}{separator}{hint}{listing}")


def _listed(names: list[str]) -> str:
    """Names in their order; of many the first."""
    told = ", ".join(names)
    if len(told) <= _LONGEST_LIST:
        return told
    return f"{told[: told.rindex(', ', 0, _LONGEST_LIST)]}, ... ({len(names)} in all)"


def one_or_several(given: Any) -> tuple[Any, ...]:
    """What is given, one thing or several; a text is one, as is all that holds nothing.

    Examples
    --------
    >>> one_or_several("eta"), one_or_several(["chi", "V"]), one_or_several(3)
    (('eta',), ('chi', 'V'), (3,))
    """
    try:
        return (given,) if isinstance(given, str) else tuple(given)
    except TypeError:
        return (given,)


def chosen_names(kind: str, chosen: Any, known: Iterable[str]) -> tuple[str, ...]:
    """Names that are asked for, one or several, each of which has to be known.

    `kind` says what is named, such as ``"given parameter"``. An `InputError` refuses no name at
    all, what is no text, and an unknown one.

    Examples
    --------
    >>> chosen_names("parameter", "eta", ["chi", "eta", "V"])
    ('eta',)
    """
    names, every = one_or_several(chosen), tuple(known)
    if not names:
        raise InputError(f"no {kind} is named; known: {_listed([*every])}")
    for name in names:
        if name not in every:
            raise unknown_name(kind, name, every)
    return names


def check_integer(name: str, number: int, least: int, most: int | None = None) -> None:
    """Refuse an integer that is not from `least` to `most`, or from `least` on."""
    if number < least or (most is not None and number > most):
        known = f"from {least}" if most is None else f"from {least} to {most}"
        raise InputError(f"{name} = {number!r} is not an integer {known}")


def one_line(text: str, most: int = LONGEST_LINE) -> str:
    r"""Text in one line of printable characters, cut to about `most` of them.

    Line breaks between words become spaces, other control characters their escapes. Of a
    longer text the middle is left out.

    Examples
    --------
    >>> one_line("no file a\x07b\n")
    'no file a\\x07b'
    """
    joined = " ".join(part for part in text.splitlines() if part.strip()).strip()
    if len(joined) > most:
        joined = f"{joined[: most // 2]} ... {joined[-(most // 2) :]}"
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in joined)


def missing_extra(extra: str, package: str) -> MissingExtra:
    """A `MissingExtra` that says how to install an optional package.

    `extra` is the extra of this distribution that brings the package: ``"plot"`` brings
    ``"matplotlib"``. The caller raises the error.

    Examples
    --------
    >>> print(missing_extra("plot", "matplotlib"))
    matplotlib is not installed: pip install "nonsmooth[plot]"
    """
    message = f'{package} is not installed: pip install "nonsmooth[{extra}]"'
    return MissingExtra(message, name=package)
