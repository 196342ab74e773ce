"""The support headers of the generated C, as they are in the folder `support`."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache
from importlib.resources import files

__all__ = ["included", "including"]

_INCLUDE = re.compile(r'^#include "(\w+\.h)"$', re.MULTILINE)
_COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
_NAME = re.compile(r"\bnonsmooth_\w+|\bNONSMOOTH_\w+")


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
