"""C that tests emit or write, compiled into a library and called."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.places import CHECKOUT

__all__ = ["COMPILER", "SUPPORT", "library_of", "needs_compiler", "pointer"]

COMPILER = shutil.which("gcc") or shutil.which("cc")
SUPPORT = CHECKOUT / "derive" / "codegen" / "support"
needs_compiler = pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")
STRICT = ("-std=c99", "-Wall", "-Wextra", "-Werror", "-ffp-contract=off")


def library_of(source: Path, *flags: str, include: Path = SUPPORT) -> ctypes.CDLL:
    """The functions of a source, compiled without one warning."""
    library = source.with_suffix(".so")
    options = [*STRICT, *flags, "-shared", "-fPIC", f"-I{include}"]
    subprocess.run([COMPILER, *options, source, "-o", library, "-lm"], check=True)
    return ctypes.CDLL(str(library))


def pointer(array: np.ndarray[Any, Any]) -> ctypes.c_void_p:
    """Where the numbers of an array lie."""
    return ctypes.c_void_p(array.ctypes.data)
