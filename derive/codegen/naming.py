"""Every name that appears in emitted files."""

from __future__ import annotations

import keyword

__all__ = [
    "C_TAKEN",
    "C_TAKEN_BEGINNINGS",
    "RESERVED",
    "c_function",
    "constant",
    "identifier",
    "module_file",
    "python_function",
]

_C_KEYWORDS = """
auto break case char const continue default do double else enum extern float for goto if
inline int long register restrict return short signed sizeof static struct switch typedef
union unsigned void volatile while
"""
# names that no symbol of a kernel can have, in Python or in C
RESERVED = frozenset({"lib", "outputs", *keyword.kwlist, *_C_KEYWORDS.split()})
# what kernels in C call and name themselves, and macros: there such a symbol gets a suffix
_C_OWN = """
cos exp fabs lane lanes log pow sin sqrt tan DOMAIN HUGE HUGE_VAL HUGE_VALF HUGE_VALL INFINITY NAN
OVERFLOW PLOSS SING TLOSS UNDERFLOW math_errhandling
"""
C_TAKEN = frozenset(_C_OWN.split())
C_TAKEN_BEGINNINGS = (
    *("DBL_", "FLT_", "FP_", "LDBL_", "MATH_", "M_", "NONSMOOTH_", "nonsmooth_"),
    *("derivatives_", "wave_"),
)


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
