"""C programs: the headers' examples and the page's, compiled without one warning, and run."""

import re
import shutil
import subprocess
import sysconfig
from functools import cache
from importlib import import_module

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.derive import DerivationError
from nonsmooth.derive.codegen.c import c_kernel
from nonsmooth.derive.codegen.emit import emit_library
from nonsmooth.derive.systems import SYSTEMS
from tests.places import CHECKOUT
from tests.tables import slow
from tests.user_systems import DAMPED, KICKED

GENERATED = CHECKOUT / "generated"
PAGE = (CHECKOUT / "docs/how_to/c_kernels.md").read_text(encoding="utf-8")
STRICT = ["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-O2"]
VECTORS = ["-O3", "-fopenmp-simd", "-DNONSMOOTH_OPENMP_SIMD"]
COMPILERS = [name for name in ("gcc", "clang") if shutil.which(name)]

pytestmark = pytest.mark.skipif(not COMPILERS, reason="there is no C compiler")
others = [slow(name) for name in COMPILERS[1:]]
each_compiler = pytest.mark.parametrize("compiler", [*COMPILERS[:1], *others])


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("c")


def assert_silent(command, **options):
    """Run what may not say anything, nor fail."""
    done = subprocess.run(command, capture_output=True, text=True, check=False, **options)
    assert (done.returncode, done.stderr) == (0, "")


@cache
def compiled(compiler, source, folder, *flags):
    """The object of a source, compiled without one warning."""
    target = folder / f"{source.stem}-{compiler}{len(flags)}.o"
    command = [compiler, *STRICT, *flags, f"-I{GENERATED}", "-c", source, "-o", target]
    assert_silent(command)
    return target


def quick(stem):
    """GCC takes seconds to optimise what is long; of the shortest it warns as it optimises."""
    return () if stem == "rigid_stop" else ("-O0",)


def ran(compiler, text, other, folder, include=GENERATED):
    """What a program writes that is linked with another object."""
    source, program = folder / f"main-{compiler}.c", folder / f"main-{compiler}"
    source.write_text(f"{text}\n")
    assert_silent([compiler, *STRICT, f"-I{include}", source, other, "-o", program, "-lm"])
    return subprocess.run([program], capture_output=True, text=True, check=True).stdout


def example_of(header):
    """The program in the head comment of a header."""
    _, _, after = header.partition("\n * Example:\n *\n")
    return re.sub(r"^ \*(?: {5})?", "", after.partition("\n */\n")[0], flags=re.MULTILINE)


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("nm") is None, reason="there is no nm")
def test_public_c_symbols_have_the_name_of_their_system(folder):
    stem = "dry_friction"
    kernels = compiled(COMPILERS[0], GENERATED / f"{stem}.c", folder, *quick(stem))
    command = ["nm", "-g", "--defined-only", kernels]
    listing = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    # clones for several processors carry a suffix; a resolver has the name itself
    symbols = {line.split()[-1] for line in listing.splitlines() if line}
    assert {s for s in symbols if not s.startswith((f"{stem}_", "nonsmooth_"))} == set()
    header = (GENERATED / f"{stem}.h").read_text(encoding="utf-8")
    declared = set(re.findall(r"^void (\w+)\(", header, re.MULTILINE))
    assert declared == {s.partition(".")[0] for s in symbols}
    kernels_of = import_module(f"nonsmooth.generated.{stem}").KERNELS
    assert {f"{stem}_{kernel}" for kernel in kernels_of} <= declared


@pytest.mark.skipif(shutil.which("g++") is None, reason="there is no g++")
def test_the_headers_are_cplusplus_too_and_go_together():
    names = 2 * [f"{stem}.h" for stem in SYSTEMS.values()]
    text = "".join(f'#include "{name}"\n' for name in names) + "int main() { return 0; }\n"
    flags = [*STRICT[1:], "-std=c++11", "-fsyntax-only", f"-I{GENERATED}"]
    assert_silent(["g++", "-x", "c++", *flags, "-"], input=text)


@pytest.mark.slow
@each_compiler
@pytest.mark.parametrize("name", SYSTEMS)
def test_the_example_of_a_header_solves_an_orbit(compiler, name, folder):
    stem = SYSTEMS[name]
    program = example_of((GENERATED / f"{stem}.h").read_text(encoding="utf-8"))
    solver = re.findall(rf"\b{stem}_(\w+)_solve\(", program)[0].replace("_", "-")
    kernels = compiled(compiler, GENERATED / f"{stem}.c", folder, *quick(stem))
    written = ran(compiler, program, kernels, folder)
    first, *unknowns = written.splitlines()
    orbit = ns.solve(f"{name}/{solver}")
    assert first.startswith("status 0, trace ")
    assert float(first.split()[-1]) == pytest.approx(orbit.trace, rel=1e-9)
    assert [float(u) for u in unknowns] == pytest.approx([*orbit.unknowns.values()], rel=1e-9)


@pytest.mark.slow
@each_compiler
def test_loops_with_vectors_and_the_extension_give_no_warning(compiler, folder):
    compiled(compiler, GENERATED / "rigid_stop.c", folder, *VECTORS)
    python = [sysconfig.get_path("include"), np.get_include()]
    flags = [word for path in python for word in ("-isystem", path)]
    compiled(compiler, GENERATED / "_kernels.c", folder, "-O0", *flags)


@pytest.mark.slow
def test_every_loop_over_lanes_has_its_directive():
    """The preprocessor gives as many directives as the source asks for, and none unasked."""
    source = GENERATED / "dry_friction.c"
    texts, left = {source.name: source.read_text(encoding="utf-8")}, [source.name]
    while left:  # each header once, whoever includes it
        for name in re.findall(r'^#include "(nonsmooth_.*)"$', texts[left.pop()], re.MULTILINE):
            if name not in texts:
                texts[name] = (GENERATED / name).read_text(encoding="utf-8")
                left.append(name)
    asked = re.compile(r"^ +NONSMOOTH_SIMD(?:_SUM\(\w+\))?$", re.MULTILINE)
    wanted = sum(len(asked.findall(text)) for text in texts.values())
    assert wanted
    for flags, count in (((), 0), (VECTORS, wanted), (("-fopenmp",), wanted)):
        command = [COMPILERS[0], "-E", *flags, f"-I{GENERATED}", source]
        text = subprocess.run(command, capture_output=True, text=True, check=True).stdout
        assert text.count("#pragma omp") == text.count("#pragma omp simd") == count


CELLS = dict(re.findall(r"^%%writefile (\S+)\n(.*?)^```", PAGE, re.MULTILINE | re.DOTALL))


def test_the_page_builds_with_the_flags_of_the_package():
    setup = (CHECKOUT / "setup.py").read_text(encoding="utf-8")
    flags = {*re.findall(r'"(-[OfD][^"]*)"', setup)}
    flags -= {"-fvisibility=hidden", "-DNONSMOOTH_EVERY_PROCESSOR"}  # of what is passed on
    given = CELLS["CMakeLists.txt"].replace(")", " ").split()
    assert len(flags) > 5
    assert {flag.removeprefix("-D") for flag in flags} <= {*given}
    (plain,) = re.findall(r"^!cc (.*)$", PAGE, re.MULTILINE)
    assert "-fno-trapping-math" in plain.split()


@pytest.mark.slow
def test_the_program_of_the_page_has_the_numbers_of_the_orbit(tmp_path):
    tool = "cmake" if shutil.which("cmake") else "cc"  # the site runs the page's cells, with cc
    (tmp_path / "main.c").write_text(CELLS["main.c"])
    (tmp_path / "CMakeLists.txt").write_text(CELLS["CMakeLists.txt"].replace("-O3", "-O0"))
    kernels = tmp_path / "kernels"
    kernels.mkdir()
    for file in [*GENERATED.glob("dry_friction.[ch]"), *GENERATED.glob("nonsmooth_*.h")]:
        shutil.copy(file, kernels)
    (command,) = re.findall(rf"^!?({tool} .*orbit)$", PAGE, re.MULTILINE)
    done = subprocess.run(
        command, shell=True, cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    *equations, told, multipliers, admissible = done.stdout.splitlines()[-9:]
    orbit = ns.solve("dry-friction/global-stick")
    found = re.findall(r"unknown (\S+), equation (\S+)", "\n".join(equations))
    unknowns, residual = np.array(found, dtype=float).T
    assert unknowns == pytest.approx([*orbit.unknowns.values()], rel=1e-9)
    assert max(abs(residual)) < 1e-12
    trace = float(told.split()[1])
    assert trace == pytest.approx(orbit.trace, rel=1e-9)
    assert [float(w) for w in multipliers.split()[1:]] == pytest.approx([trace, 0], abs=1e-9)
    assert admissible == "admissible 1"


# names that differ by case alone, or are those of the header itself
AWKWARD = {
    '"kicked",': '"awkward",', '"k", "': '"h", "drag */ and /* more', '"r", "': '"H", "',
    '{"k": "1", "r": "0.5"}': '{"h": "1", "H": "0.5"}', '"ta"': '"V0"',
}  # fmt: skip


def library(names, text=KICKED):
    declared = {}
    for old, new in names.items():
        text = text.replace(old, new)
    exec(text, declared)
    return emit_library(declared["system"], declared["orbits"], "test")


def test_what_calls_an_absent_kernel_is_absent_for_the_same_reason(
    monkeypatch,
):
    def define(kernel, system, orbit):
        if kernel.name == "trace":
            raise DerivationError("it is too long")
        return c_kernel(kernel, system, orbit)

    monkeypatch.setattr("nonsmooth.derive.codegen.emit.c_kernel", define)
    header = library({})["kicked.h"]
    absent = dict(re.findall(r"There is no (\w+): ([^.]*)\.", header))
    assert absent == dict.fromkeys(
        [f"kicked_loop_{each}" for each in ("trace", "solve", "directions")], "it is too long"
    )


@each_compiler
def test_names_and_texts_that_would_break_a_header_do_not(compiler, tmp_path):
    files = library(AWKWARD)
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    header = files["awkward.h"]
    constants = re.findall(r"^    (AWKWARD_\w+) = ", header, re.MULTILINE)
    assert len(constants) == len({*constants}) > 10
    assert header.count("NONSMOOTH_SYSTEM_AWKWARD_H") == 2
    source = compiled(compiler, tmp_path / "awkward.c", tmp_path)
    status, *unknowns = ran(compiler, example_of(header), source, tmp_path, tmp_path).splitlines()
    assert status.startswith("status 0")
    assert [float(u) for u in unknowns] == pytest.approx([2, np.pi, np.pi / 2], rel=1e-12)


@each_compiler
def test_a_system_may_have_the_name_of_a_support_header(compiler, tmp_path):
    for name, text in library({'"kicked",': '"sums",'}).items():
        (tmp_path / name).write_text(text)
    compiled(compiler, tmp_path / "sums.c", tmp_path)


def test_only_the_support_that_is_used_is_written():
    """An undamped orbit is solved and searched in sines, damped flows alone are exponentials."""
    solved = (
        *("admissible", "admissible_sums", "compiler", "elimination", "lanes", "newton", "search"),
        *("sums", "trigonometry"),
    )
    flows = ("compiler", "exponentials", "trigonometry")
    for text, names in ((KICKED, solved), (DAMPED, flows)):
        written = {name for name in library({}, text) if name.startswith("nonsmooth_")}
        assert written == {f"nonsmooth_{name}.h" for name in names}
