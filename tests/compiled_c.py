"""C that tests emit or write, compiled into a library, and Python that is emitted: to be called."""

import ctypes
import shutil
import subprocess

import pytest

from nonsmooth.derive.codegen.any_arithmetic import python_kernel
from tests.places import CHECKOUT

COMPILER = shutil.which("gcc") or shutil.which("cc")
SUPPORT = CHECKOUT / "derive" / "codegen" / "support"
needs_compiler = pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")
STRICT = ("-std=c99", "-Wall", "-Wextra", "-Werror", "-ffp-contract=off")


def executed(kernel):
    """The function that the emitted source of a kernel defines."""
    namespace = {}
    exec(python_kernel(kernel, None), namespace)
    return namespace[kernel.name.replace("-", "_")]


def library_of(source, *flags, include=SUPPORT):
    """The functions of a source, compiled without one warning."""
    library = source.with_suffix(".so")
    options = [*STRICT, *flags, "-shared", "-fPIC", f"-I{include}"]
    subprocess.run([COMPILER, *options, source, "-o", library, "-lm"], check=True)
    return ctypes.CDLL(str(library))


def pointer(array):
    """Where the numbers of an array lie."""
    return ctypes.c_void_p(array.ctypes.data)
