"""The packages, the compiled kernels and the engine; pyproject.toml declares everything else."""

import os
import sysconfig
from glob import glob

import numpy
from setuptools import Extension, find_packages, setup
from setuptools.command.build_ext import build_ext

# No contraction into fused multiply-adds: every build gives the same bits. No traps: loops that
# choose between two results use vectors.
FLAGS = ["-O3", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math"]
FLAGS += ["-fopenmp-simd", "-DNONSMOOTH_OPENMP_SIMD"]  # no macro says that the first is given
FLAGS += ["-DNONSMOOTH_EVERY_PROCESSOR"]
FLAGS += ["-fvisibility=hidden"]  # calls between the files of an extension are direct
FLAGS_OF_MSVC = ["/std:c11", "/O2", "/fp:precise"]  # C89 without the first: no `restrict`
# One build serves Python 3.11 and all later ones; those without a lock know no such interface.
LIMITED = not sysconfig.get_config_var("Py_GIL_DISABLED")
MACROS = [("Py_LIMITED_API", "0x030B0000")] if LIMITED else []


class BuildKernels(build_ext):
    """Build with the flags of the compiler, and forget what did not build."""

    def initialize_options(self) -> None:
        """Begin with the defaults, and with both extensions at a time."""
        super().initialize_options()
        self.parallel = True

    def build_extensions(self) -> None:
        """Build; without a working compiler there is no extension, and that is no error."""
        msvc = self.compiler.compiler_type == "msvc"
        for extension in self.extensions:
            extension.extra_compile_args = FLAGS_OF_MSVC if msvc else FLAGS
            extension.libraries = [] if msvc else ["m"]
        super().build_extensions()
        # An editable install would otherwise link to an extension that is missing or old.
        self.extensions = [
            extension
            for extension in self.extensions
            if os.path.exists(self.get_ext_fullpath(extension.name))
        ]


# Wheels for other machines are compiled or not made at all.
needed = os.environ.get("NONSMOOTH_NEEDS_EXTENSION", "0") not in ("", "0")
kernels = Extension(
    "nonsmooth.generated._kernels",
    sources=sorted(glob("generated/*.c")),
    depends=sorted(glob("generated/*.h")),
    include_dirs=[numpy.get_include(), "generated"],
    define_macros=MACROS,
    py_limited_api=LIMITED,
    optional=not needed,
)
engine = Extension(
    "nonsmooth.runtime._engine",
    sources=sorted(glob("runtime/engine/*.c")),
    depends=sorted([*glob("runtime/engine/*.h"), *glob("derive/codegen/support/*.h")]),
    include_dirs=["derive/codegen/support", "runtime/engine"],
    define_macros=MACROS,
    py_limited_api=LIMITED,
    optional=not needed,
)
# `runtime/face` is the package `nonsmooth` itself.
packages = ["nonsmooth"]
for folder in ("derive", "generated", "runtime"):
    inside = find_packages(folder, exclude=["face"])
    packages += [f"nonsmooth.{name}" for name in (folder, *(f"{folder}.{p}" for p in inside))]
without = os.environ.get("NONSMOOTH_WITHOUT_EXTENSION", "0") not in ("", "0")
setup(
    packages=packages,
    ext_modules=[] if without else [kernels, engine],
    cmdclass={"build_ext": BuildKernels},
    options={"bdist_wheel": {"py_limited_api": "cp311"}} if LIMITED and not without else {},
)
