"""The C is C99 that other compilers than GCC take: MSVC knows no extensions of GNU."""

import re
import shutil
import subprocess
import sysconfig

import numpy as np
import pytest

from tests.places import CHECKOUT

SOURCES = sorted(
    path.relative_to(CHECKOUT)
    for folder in ("runtime/engine", "generated", "tests/c")
    for path in (CHECKOUT / folder).glob("*.c")
)
HEADERS = sorted(
    path.relative_to(CHECKOUT)
    for folder in ("runtime/engine", "generated", "derive/codegen/support")
    for path in (CHECKOUT / folder).glob("*.h")
)
FLAGS = ["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wvla", "-Werror"]
FLAGS += ["-fopenmp-simd", "-DNONSMOOTH_OPENMP_SIMD"]
# the ways of a compiler that is not GNU's; how the C library then writes infinity is its own
FOREIGN = ["-fgnuc-version=0", "-Wno-literal-range"]
EXTENSIONS = re.compile(r"__attribute__|__builtin_|__extension__|__typeof__|__restrict|\bM_PI\b")


def compilers():
    """Clang, also as if it were not GNU's; GCC where there is none."""
    if clang := shutil.which("clang"):
        return [[clang], [clang, *FOREIGN]]
    if gcc := shutil.which("gcc"):
        print("there is no clang: the C is checked with gcc")
        return [[gcc]]
    return []


def unguarded(text):
    """Lines with extensions of GNU that stand outside of what is compiled by GNU's alone."""
    guards = []
    found = []
    for line in text.splitlines():
        directive = line.lstrip()
        if re.match(r"#\s*if", directive):
            guards.append("defined(__GNUC__)" in directive)
        elif re.match(r"#\s*el", directive):
            guards[-1] = False
        elif re.match(r"#\s*endif", directive):
            guards.pop()
        elif EXTENSIONS.search(line) and not any(guards):
            found.append(line)
    return found


@pytest.mark.parametrize("path", [*SOURCES, *HEADERS], ids=str)
def test_extensions_stand_in_guards(path):
    assert unguarded((CHECKOUT / path).read_text(encoding="utf-8")) == []


@pytest.mark.slow
@pytest.mark.skipif(not compilers(), reason="there is no C compiler")
@pytest.mark.parametrize("path", SOURCES, ids=str)
def test_compilers_have_nothing_to_say(path):
    include = ["-I", "runtime/engine", "-I", "generated", "-I", "derive/codegen/support"]
    for folder in (sysconfig.get_path("include"), np.get_include()):
        include += ["-isystem", folder]
    for compiler in compilers():
        command = [*compiler, *FLAGS, "-fsyntax-only", *include, str(path)]
        done = subprocess.run(command, cwd=CHECKOUT, capture_output=True, text=True, check=False)
        assert done.returncode == 0, f"{' '.join(command)}\n{done.stderr}"
