"""Every name that appears in emitted files."""

from __future__ import annotations

import keyword
import re
from collections.abc import Collection
from unicodedata import normalize

_C_KEYWORDS = """
alignas alignof asm auto bool break case char const constexpr continue default do double else enum
extern false float for goto if inline int long nullptr register restrict return short signed sizeof
static static_assert struct switch thread_local true typedef typeof typeof_unqual union unsigned
void volatile while
"""
# what kernels in Python or C call and name themselves, and macros
_OWN = """
abs lib outputs
cos exp fabs fixed i lane lanes log main pow sin sqrt tan
DECIMAL_DIG DOMAIN HUGE HUGE_VAL HUGE_VALF HUGE_VALL INFINITY NAN NULL OVERFLOW PLOSS SING TLOSS
UNDERFLOW i386 linux math_errhandling signgam unix
"""
_WORDS = frozenset({*keyword.kwlist, *_C_KEYWORDS.split(), *_OWN.split()})
# macros of the headers that C includes, and what C names by a number
_FAMILIES = re.compile(
    r"(DBL|FLT|FP|LDBL|M|MATH|NONSMOOTH|derivatives|nonsmooth|wave)_\w*(?<!_)"
    r"|(U?INT\w*|PTRDIFF|SIG_ATOMIC|SIZE|WCHAR|WINT)_(C|MAX|MIN)"
)


def free_name(name: str, taken: Collection[str]) -> str:
    """The name if it is free, else with as few underscores behind it as make it so.

    Not free are those that are taken, and those that emitted files use for something else.
    """
    name = normalize("NFKC", name)  # as Python reads it
    while name in taken or name in _WORDS or _FAMILIES.fullmatch(name):
        name += "_"
    return name


def identifier(name: str) -> str:
    """A declared name as an identifier, hyphens replaced by underscores."""
    return name.replace("-", "_")


def python_function(kernel: str, orbit: str | None) -> str:
    """Name of a kernel's function in a generated Python module.

    Kernels of an orbit have the orbit's name in it.
    """
    return identifier(kernel if orbit is None else f"{orbit}_{kernel}")


def c_function(system: str, kernel: str, orbit: str | None) -> str:
    """Name of a kernel's function in C; the system's name distinguishes several systems."""
    return f"{identifier(system)}_{python_function(kernel, orbit)}"


def module_file(system: str, suffix: str) -> str:
    """Name of a system's file with the given suffix."""
    return f"{identifier(system)}{suffix}"


def constant(system: str, name: str) -> str:
    """Name of a macro in a system's generated C header."""
    return f"{identifier(system)}_{name}".upper()
