"""Names in a declaration: each can be written in a file, and is given once."""

from collections.abc import Sequence
from keyword import iskeyword

from nonsmooth.derive.errors import DeclarationError

__all__ = ["check_name", "check_unique"]


def check_name(name: str, what: str) -> None:
    """Refuse a name that cannot be that of a file and a function.

    A name has letters, digits, hyphens and underscores, and begins with a letter;
    DeclarationError refuses another one.
    """
    plain = isinstance(name, str) and name.replace("-", "_")
    if not plain or not plain.isidentifier() or iskeyword(plain) or plain.startswith("_"):
        raise DeclarationError(
            f"{what} {name!r} is no name: letters, digits and hyphens, a letter first"
        )


def check_unique(names: Sequence[str], what: str) -> None:
    """Refuse, by DeclarationError, a name that occurs twice."""
    for name in names:
        if names.count(name) > 1:
            raise DeclarationError(f"{what} {name!r} is declared twice")
