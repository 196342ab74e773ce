"""Compiled kernels in a folder of `nonsmooth generate`."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from nonsmooth.runtime.core.errors import InputError, MissingExtra
from nonsmooth.runtime.core.files import write_file
from nonsmooth.runtime.model.loading.load import extension_in

__all__ = ["compile_folder"]

# No contraction into fused multiply-adds: every build gives the same bits.
_BUILD = """
import sys
from glob import glob
from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

FLAGS = ["-O3", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math", "-fopenmp-simd"]

class Build(build_ext):
    def build_extensions(self):
        if self.compiler.compiler_type != "msvc":
            for extension in self.extensions:
                extension.extra_compile_args, extension.libraries = FLAGS, ["m"]
        super().build_extensions()

include = sys.argv.pop()
kernels = Extension("_kernels", sources=sorted(glob("*.c")), include_dirs=[include, "."])
setup(name="kernels", ext_modules=[kernels], cmdclass={"build_ext": Build},
      packages=[], py_modules=[])
"""


def compile_folder(folder: Path) -> Path:
    """Build the extension of a folder's C files there; nothing else of the build stays.

    Raises
    ------
    InputError
        If there is no C compiler, or it fails.
    MissingExtra
        If setuptools is not installed, which knows the compiler.
    """
    with TemporaryDirectory() as place:
        work = Path(place)
        for path in sorted([*folder.glob("*.c"), *folder.glob("*.h")]):
            shutil.copyfile(path, work / path.name)
        command = [sys.executable, "-c", _BUILD, "build_ext", "--inplace", np.get_include()]
        done = subprocess.run(command, cwd=work, capture_output=True, text=True, check=False)
        built = extension_in(work)
        if done.returncode != 0 or built is None:
            said = [line.strip() for line in done.stderr.splitlines() if line.strip()]
            if any("No module named 'setuptools'" in line for line in said):
                raise MissingExtra("setuptools is not installed: pip install setuptools")
            reason = said[-1] if said else "the build gave no extension"
            raise InputError(
                f"{folder}: no compiled kernels: {reason};"
                " without --compile the kernels run on NumPy"
            )
        target = folder / built.name
        write_file(target, built.read_bytes())
        return target
