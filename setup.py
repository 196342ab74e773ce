"""The compiled kernels and engine; everything else is declared in pyproject.toml."""

import os
from glob import glob

import numpy
from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

# No contraction into fused multiply-adds: every build gives the same bits.
FLAGS = ["-O3", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math", "-fopenmp-simd"]
FLAGS += ["-fvisibility=hidden"]  # calls between the files of an extension are direct


class BuildKernels(build_ext):
    """Build with flags that only GCC and Clang know, and forget what did not build."""

    def build_extensions(self) -> None:
        """Build; without a working compiler there is no extension, and that is no error."""
        if self.compiler.compiler_type != "msvc":
            for extension in self.extensions:
                extension.extra_compile_args, extension.libraries = FLAGS, ["m"]
        super().build_extensions()
        # An editable install would otherwise link to an extension that is missing or old.
        self.extensions = [
            extension
            for extension in self.extensions
            if os.path.exists(self.get_ext_fullpath(extension.name))
        ]


kernels = Extension(
    "nonsmooth.generated._kernels",
    sources=sorted(glob("generated/*.c")),
    depends=sorted(glob("generated/*.h")),
    include_dirs=[numpy.get_include(), "generated"],
    optional=True,
)
engine = Extension(
    "nonsmooth.runtime._engine",
    sources=sorted(glob("runtime/engine/*.c")),
    depends=[*sorted(glob("runtime/engine/*.h")), "generated/support.h"],
    include_dirs=["generated", "runtime/engine"],
    optional=True,
)
without = os.environ.get("NONSMOOTH_WITHOUT_EXTENSION", "0") not in ("", "0")
setup(ext_modules=[] if without else [kernels, engine], cmdclass={"build_ext": BuildKernels})
