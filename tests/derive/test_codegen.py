"""Emitted files: reproducible, stamped, and each expression with the value it had."""

import json
import random
import re
from fractions import Fraction
from importlib import import_module

import flint
import numpy as np
import pytest
import sympy as sp

from nonsmooth import InputError
from nonsmooth.derive import DerivationError, Parameter, RigidStop
from nonsmooth.derive.codegen import regenerate
from nonsmooth.derive.codegen.body import Constant
from nonsmooth.derive.codegen.c import c_kernel
from nonsmooth.derive.codegen.emit import emit_library, emit_system
from nonsmooth.derive.equations.explicit import Angle
from nonsmooth.derive.equations.program import Array, Kernel, Stage, evaluate
from nonsmooth.runtime.core.arithmetic import FLOATS, Balls, Mpmath
from nonsmooth.runtime.model import kernels as door
from tests.compiled_c import COMPILER, executed, library_of, pointer
from tests.one_mass import one_mass
from tests.places import CHECKOUT

GENERATED = CHECKOUT / "generated"
RECORD = json.loads((GENERATED / "PROVENANCE.json").read_text(encoding="utf-8"))
F = Fraction

# --- the same bytes, always -------------------------------------------------------------


def test_nothing_else_is_generated():
    """That these are what the derivation gives, `scripts/regenerate.py --check` says."""
    known = {*RECORD["files"], "PROVENANCE.json", "__init__.py", "py.typed"}
    assert {p.name for p in GENERATED.iterdir() if p.is_file() and p.suffix != ".so"} == known


def test_only_files_that_differ_are_written_again(tmp_path, committed_derivation):
    """The committed files are what the derivation gives."""
    for name, text in committed_derivation.items():
        (tmp_path / name).write_bytes(text.encode())
    assert regenerate.outdated(tmp_path) == {}
    (tmp_path / "nonsmooth_sums.h").write_text("changed")
    (tmp_path / "rigid_stop.md").unlink()
    assert set(regenerate.outdated(tmp_path)) == {"nonsmooth_sums.h", "rigid_stop.md"}


def test_tables_are_read_as_they_were_told():
    words = 'what "pushes", \\n {back}: [x, "", \'\'\']; ' * 5
    stiffness = Parameter("k", words)
    own = {"parameters": [stiffness], "description": words}
    system = one_mass("told", stiffness=stiffness.symbol, **own)
    text, found = emit_library(system, [], "tests")["told.py"], {}
    exec(text, found)
    table = found["SYSTEM"]
    assert table["parameters"][0]["description"] == table["description"] == words
    tables = text[text.index("SYSTEM") : text.index("def ")]
    assert max(len(line) for line in tables.splitlines() if "pushes" not in line) <= 120


# --- the value of what is emitted -------------------------------------------------------

A, B, C = INPUTS = sp.symbols("a b c", positive=True)
D = sp.Symbol("d", real=True)
POINT = dict(zip((*INPUTS, D), map(F, ("0.7", "1.3", "0.4", "-3")), strict=True))


def kernel_of(*results, stages=(), name="probe"):
    arguments = Array.of("parameters", (A, B)), Array.of("reduced", (C, D))
    outputs = Array.of("first", results[:-1]), Array.of("second", sp.Matrix(results[-1:]))
    return Kernel(name, "A probe.", arguments, outputs, tuple(stages))


def program(seed):
    """A straight-line program over positive inputs, with shared and negated terms."""
    draw = random.Random(seed)
    known = [*INPUTS, sp.Integer(2)]
    stages = []

    def expression():
        terms = []
        for _ in range(draw.randint(1, 3)):
            factors = draw.choices(known, k=draw.randint(1, 3))
            term = draw.choice([1, 1, -1, sp.Rational(3, 7)]) * sp.Mul(*factors)
            terms.append(draw.choice([term, sp.cos(term), 1 / (1 + term**2)]))
        return sp.Add(*terms)

    for number in range(draw.randint(1, 4)):
        shared, assignments = expression(), []
        for place in range(draw.randint(1, 3)):
            symbol = sp.Symbol(f"s{number}_{place}", real=True)
            choices = [shared, -shared, shared + expression(), expression()]
            assignments.append((symbol, draw.choice(choices)))
            known.append(symbol)
        stages.append(Stage(f"stage {number}", tuple(assignments)))
    # C computes a kernel of this name for lanes, and once what does not depend on `reduced`
    name = "reduced" if seed % 2 else "probe"
    return kernel_of(*(expression() for _ in range(4)), stages=stages, name=name)


SUMS = [sp.factor_terms(A / 4 + B / 4 + sign * C / 2) for sign in (-1, 1)]
POWERS = [B ** sp.Rational(p, 2) for p in (1, -1, 3, -3, 5, -2, -4, 6, -7)]
PROBES = {
    **{f"case{seed}": program(seed) for seed in range(10)},
    # a number in front of a sum is no product of its terms: SymPy's cse gives -a b c/32
    "sums": kernel_of(*SUMS, A / 4 + B / 4 - C / 2),
    "powers": kernel_of(*POWERS, *(3 * power / (1 + B) for power in POWERS)),
    # not every arithmetic has roots and angles of plain integers
    "numbers": kernel_of(sp.sqrt(3), sp.sqrt(2 + sp.sqrt(5)), sp.sqrt(D**2) / 3, Angle(0, D)),
}


@pytest.fixture(scope="module")
def compiled(tmp_path_factory):
    """The results of each probe in C, at the point; None without a compiler."""
    if COMPILER is None:
        return None
    source = tmp_path_factory.mktemp("probes") / "probes.c"
    includes = [f'#include "nonsmooth_{n}.h"' for n in ("compiler", "trigonometry")]
    definitions = [c_kernel(kernel, name, None) for name, kernel in PROBES.items()]
    source.write_text("\n".join(["#include <math.h>", *includes, *definitions]))
    library = library_of(source, "-O1", "-Wno-unused-function")

    def results(name):
        kernel, given = PROBES[name], np.array([float(v) for v in POINT.values()])
        found = np.zeros(sum(len(output.entries) for output in kernel.outputs))
        arrays = given[:2], given[2:], found[:-1], found[-1:]
        library[f"{name}_{kernel.name}"](*map(pointer, arrays))
        return found.tolist()

    return results


@pytest.mark.parametrize("name", PROBES)
def test_what_is_emitted_has_its_value_in_every_arithmetic(name, compiled):
    kernel, lib, balls = PROBES[name], Mpmath(45), Balls()
    exact = {s: sp.Rational(v.numerator, v.denominator) for s, v in POINT.items()}
    results = [e for output in kernel.outputs for e in output.entries]
    values = evaluate(kernel.stages, results, exact)
    expected = [sp.N(value.subs(Angle(0, -3), sp.pi), 40) for value in values]
    emitted = executed(kernel)

    def found(number, lib):
        point = [number(v) for v in POINT.values()]
        first, ((last,),) = emitted(point[:2], point[2:], lib=lib)
        return [*first, last]

    precise = found(lambda v: lib.mp.mpf(v.numerator) / v.denominator, lib)
    for one, wanted in zip(precise, expected, strict=True):
        assert abs(sp.Float(str(one), 40) - wanted) <= abs(wanted) * 1e-30 + 1e-30
    with balls.working(100):
        enclosed = found(lambda v: flint.arb(v.numerator) / v.denominator, balls)
    for numbers in (enclosed, found(float, FLOATS), *([compiled(name)] if compiled else [])):
        rounded = pytest.approx([*map(float, expected)], rel=1e-13, abs=1e-15)
        assert [*map(float, numbers)] == rounded


def test_numpy_is_given_no_function_of_nothing():
    """A generalized ufunc has no core dimension of size 0, such as that of no parameters."""
    for stiffness in (1, sp.Symbol("k")):
        stops = [RigidStop("x", at=1, restitution=1, name="wall")]
        system = one_mass("struck", *stops, stiffness=stiffness)
        emitted = emit_system(system, [], "tests")
        assert "void struck_fields" in emitted.files["struck.c"]
        assert any(each.function.name == "struck_flow_free" for each in emitted.wrapped)
        for each in emitted.wrapped:
            inputs, outputs = map(each.used, (each.function.inputs, each.function.outputs))
            assert inputs
            assert outputs
            assert all(a.size for a in (*inputs, *outputs))
            assert "(0" not in each.signature
            assert not each.signature.startswith("->")


# --- printing ---------------------------------------------------------------------------


def test_irrational_numbers_have_an_order_that_no_hash_decides():
    numbers = [Constant(sp.sqrt(2) / 4 + sp.Rational(1, 2)), Constant(sp.sqrt(2)), Constant(sp.pi)]
    assert len({*map(sp.default_sort_key, numbers)}) == 3


@pytest.mark.parametrize(
    ("expression", "message"),
    [
        (A ** sp.Rational(1, 3), "no kernel for the power"),
        (sp.exp(A), "no kernel for the function exp"),
        (sp.tan(A), "no kernel for the function tan"),
        (A + sp.Symbol("y"), "y has no value"),
        (A * sp.I, "no kernel holds I"),
    ],
    ids=str,
)
def test_what_no_kernel_can_hold_is_refused_by_name(expression, message):
    with pytest.raises(DerivationError, match=message):
        executed(kernel_of(expression))


# --- files that are not what is derived


def test_formulas_that_differ_come_first_and_stamps_last(tmp_path):
    long = " + ".join(f"x{place}" for place in range(100))
    written = {
        "a.c": f"/* derivation {'0' * 16} */\n#define N 1\nb = {long} - y;\nc = 1;\n",
        "b.py": f'DERIVATION = "{"0" * 16}"\nb = {long} - y\nc = 1\n',
        "c.h": f"/* derivation {'0' * 16} */\nb();\n",
        "d.h": "b();\n",
        "e.md": "The end.\n",
        "f.py": "1\n",
    }
    derived = {name: text.replace("0" * 16, "f" * 16) for name, text in written.items()}
    derived["a.c"] = derived["a.c"].replace("- y", "+ y").replace("1;", "2;")
    derived["b.py"] = derived["b.py"].replace("- y", "+ y")
    derived["e.md"] += "More.\n"
    for name, text in written.items():
        (tmp_path / name).write_text(text)
    (tmp_path / "d.h").write_bytes(b"b();\r\n")
    (tmp_path / "f.py").unlink()
    missing, *changed, stamps, ends = regenerate.differences(tmp_path, derived)
    assert (missing, stamps) == ("f.py: missing", "c.h: its stamps alone")
    assert ends == "d.h: its ends of lines alone"
    assert [text.split()[1] for text in changed] == ["e.md", "b.py", "a.c"]
    assert changed[0].splitlines()[2:] == ["line 2:", "+More."]
    for text, line, end in ((changed[1], 2, ""), (changed[2], 3, ";")):
        place, found, wanted = text.splitlines()[2:]
        assert place == f"line {line}:"
        assert (found[:5], wanted[:5]) == ("-... ", "+... ")
        assert found.endswith(f"x99 - y{end}")
        assert wanted.endswith(f"x99 + y{end}")


def test_stamps_are_known_by_what_stands_before_them(tmp_path):
    for stamp, digits in (
        ('DERIVATION = "{}"', 16),
        ("derivation {}", 16),
        ('{{"derivation": "{}"}}', 16),
        ('"derivation_elastic_stop", "{}"', 16),
        ('"sha256": "{}"', 64),
    ):
        (tmp_path / "g.c").write_text(stamp.format("0" * digits))
        wanted = {"g.c": stamp.format("f" * digits)}
        assert regenerate.differences(tmp_path, wanted) == ("g.c: its stamps alone",)
    (tmp_path / "g.c").write_text("x = -0.3333333333333333;\n")  # sixteen digits, and no stamp
    (difference,) = regenerate.differences(tmp_path, {"g.c": "x = -0.3333333333333334;\n"})
    assert re.search(r"^\+x = -0\.3333333333333334;$", difference, re.MULTILINE)


@pytest.mark.compiled
def test_compiled_kernels_of_another_derivation_are_named(monkeypatch):
    pytest.importorskip("nonsmooth.generated._kernels", reason="no compiled kernels are built")
    monkeypatch.setenv("NONSMOOTH_BACKEND", "c")
    module = import_module("nonsmooth.generated.dry_friction")
    monkeypatch.setattr(module, "DERIVATION", "0123456789abcdef")
    door._system.cache_clear()
    try:
        with pytest.raises(InputError, match="compiled kernels of dry-friction are of another"):
            door.load_system("dry-friction")
        monkeypatch.setenv("NONSMOOTH_BACKEND", "numpy")
        assert door.load_system("dry-friction").compiled is None
    finally:
        door._system.cache_clear()
