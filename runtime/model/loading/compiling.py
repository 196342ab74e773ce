"""Compiled kernels: made of emitted files, found in a folder, loaded."""

from __future__ import annotations

import importlib.util
import os
import shlex
import subprocess
import sys
import sysconfig
from collections.abc import Mapping, Sequence
from contextlib import suppress
from functools import cache
from importlib.machinery import EXTENSION_SUFFIXES
from pathlib import Path
from tempfile import TemporaryDirectory
from types import ModuleType

import numpy as np

from nonsmooth.runtime.core.errors import InputError, MissingExtra

# No contraction into fused multiply-adds: every build gives the same bits, at any level that CFLAGS
# name. No traps: loops that choose between two results use vectors.
_FLAGS = ["-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math"]
_FLAGS += ["-fopenmp-simd", "-DNONSMOOTH_OPENMP_SIMD"]  # no macro says that the first is given
_FLAGS += ["-fvisibility=hidden"]  # calls between the files of an extension are direct
_EVERY_PROCESSOR = "-DNONSMOOTH_EVERY_PROCESSOR"
_VECTORS = "avx2"  # wider ones are no faster where all of a file is compiled for them
_WINDOWS = """
import sys
from glob import glob
from setuptools import Extension, setup

kernels = Extension(
    "_kernels",
    sources=sorted(glob("*.c")),
    include_dirs=[sys.argv.pop(), "."],
    extra_compile_args=["/std:c11", "/O2", "/fp:precise"],
)
setup(name="kernels", ext_modules=[kernels], packages=[], py_modules=[])
"""


def compiler() -> list[str]:
    """The command of the C compiler, as words: CC of the environment, else that of this Python."""
    named = os.environ.get("CC") or sysconfig.get_config_var("CC") or "cc"
    return shlex.split(str(named))


@cache
def vectors() -> str:
    """The vectors for which kernels are compiled that serve this processor alone; "" for none."""
    with suppress(OSError), Path("/proc/cpuinfo").open(encoding="utf-8") as lines:
        flags = next((line.split() for line in lines if line.startswith("flags")), [])
        return _VECTORS if _VECTORS in flags else ""
    return ""


def compile_files(
    files: Mapping[str, str], folder: Path | None = None, *, here: bool = False
) -> dict[str, bytes]:
    """Compile C files and their headers: the name of the extension, mapped to its content.

    Files of other kinds are ignored. `folder` is where a temporary folder is made, the system's
    default if None. With `here` the extension serves processors with the `vectors` of this one
    alone, which takes a third of the time. Raises `InputError` if there is no C compiler or it
    fails, and `MissingExtra` on Windows without setuptools, which knows the compiler there.
    """
    with TemporaryDirectory(dir=folder) as place:
        work = Path(place)
        for name, text in files.items():
            if name.endswith((".c", ".h")):
                (work / name).write_bytes(text.encode())
        served = [_EVERY_PROCESSOR]
        if here:
            served = [f"-m{vectors()}"] if vectors() else []
        sources = sorted(name for name in files if name.endswith(".c"))
        for command in _commands(sources, served):
            failure = _failure(command, work)
            if failure is not None:
                raise InputError(
                    f"no compiled kernels: {failure}; without them the kernels run on NumPy"
                )
        built = extension_in(work)
        if built is None:
            raise InputError("no compiled kernels: the build gave no extension")
        return {built.name: built.read_bytes()}


def _commands(sources: Sequence[str], served: Sequence[str]) -> list[list[str]]:
    """The commands that compile and link, to be run in a folder with the sources."""
    if sys.platform == "win32":
        return [[sys.executable, "-c", _WINDOWS, "build_ext", "--inplace", np.get_include()]]
    own = shlex.split(str(sysconfig.get_config_var("CC") or "cc"))
    shared = shlex.split(str(sysconfig.get_config_var("LDSHARED") or ""))
    linking = shared[len(own) :] if own and shared[: len(own)] == own else ["-shared"]
    position = shlex.split(str(sysconfig.get_config_var("CCSHARED") or "-fPIC"))
    folders = [sysconfig.get_path("include"), sysconfig.get_path("platinclude"), np.get_include()]
    include = [f"-I{folder}" for folder in dict.fromkeys(folders)]
    chosen = shlex.split(os.environ.get("CFLAGS", ""))
    options = ["-O3", *served, *chosen, *_FLAGS, *position, *include]
    output = f"_kernels{sysconfig.get_config_var('EXT_SUFFIX')}"
    return [[*compiler(), *linking, *options, *sources, "-o", output, "-lm"]]


def _failure(command: Sequence[str], work: Path) -> str | None:
    """Why a command fails; None if it succeeds. Its other output goes with the folder."""
    environment = os.environ | {"TMPDIR": str(work)}
    try:
        done = subprocess.run(
            command, cwd=work, env=environment, capture_output=True, text=True, check=False
        )
    except OSError as problem:
        return f"{command[0]}: {(problem.strerror or str(problem)).lower()}"
    if done.returncode == 0:
        return None
    said = [line.strip() for line in done.stderr.splitlines() if line.strip()]
    if any("No module named 'setuptools'" in line for line in said):
        raise MissingExtra("setuptools is not installed: pip install setuptools")
    wrong = [line for line in said if "error" in line] or said
    return wrong[-1] if wrong else f"{command[0]} fails"


def extension_in(folder: Path) -> Path | None:
    """The compiled kernels in a folder, if there are any."""
    places = (folder / f"_kernels{suffix}" for suffix in EXTENSION_SUFFIXES)
    return next((path for path in places if path.is_file()), None)


def load_extension(library: Path) -> ModuleType | None:
    """The compiled kernels in a file; None where this Python cannot load them."""
    spec = importlib.util.spec_from_file_location("nonsmooth_compiled._kernels", library)
    if spec is None or spec.loader is None:
        return None
    try:
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
    except ImportError:
        return None
    return module
