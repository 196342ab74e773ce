"""Emitted files: reproducible, stamped, and equal to the derivation in every arithmetic."""

from __future__ import annotations

import hashlib
import json
import os
import random
import re
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any

import flint
import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from nonsmooth.derive.codegen import regenerate
from nonsmooth.derive.codegen.any_arithmetic import print_python, python_kernel
from nonsmooth.derive.codegen.body import Body, body_of, hoisted, needed, split
from nonsmooth.derive.codegen.c import c_kernel, print_c
from nonsmooth.derive.codegen.emit import COMMAND
from nonsmooth.derive.codegen.naming import python_function
from nonsmooth.derive.equations import EquationSystem, derive_equations
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.explicit import Angle
from nonsmooth.derive.kernels import orbit_kernels
from nonsmooth.derive.program import Argument, Kernel, Output, Stage, evaluate
from nonsmooth.derive.systems import SYSTEMS, dry_friction
from nonsmooth.runtime import kernels as door
from nonsmooth.runtime.arithmetic import FLOATS, Balls, Mpmath
from nonsmooth.runtime.errors import InputError

ROOT = Path(__file__).resolve().parents[1]
GENERATED = ROOT / "generated"
RECORD = json.loads((GENERATED / "PROVENANCE.json").read_text(encoding="utf-8"))
PROPERTY = settings(deadline=None, max_examples=30, derandomize=True)
ORBIT = dry_friction.global_stick

same_sympy = pytest.mark.skipif(
    RECORD["sympy"] != sp.__version__,
    reason=f"generated/ is of SymPy {RECORD['sympy']}, this is {sp.__version__}",
)
compiler = shutil.which("gcc") or shutil.which("cc")
needs_compiler = pytest.mark.skipif(compiler is None, reason="there is no C compiler")
FLAGS = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-fopenmp-simd", "-ffp-contract=off"]


@pytest.fixture(scope="module")
def emitted(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """All files, made again in an empty folder."""
    folder = tmp_path_factory.mktemp("emitted")
    regenerate.regenerate(folder)
    return folder


# --- the same bytes, always -------------------------------------------------------------


@same_sympy
def test_committed_files_are_what_the_derivation_gives(
    emitted: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    texts = {p.name: p.read_text(encoding="utf-8") for p in emitted.iterdir()}
    monkeypatch.setattr(regenerate, "_wanted", lambda *_: texts)
    found = regenerate.check(GENERATED)
    assert found.same, f"run `{COMMAND}`:\n" + "\n\n".join(found.differences)
    for name, text in texts.items():
        assert (GENERATED / name).read_bytes() == text.encode()
    known = {*texts, "__init__.py", "py.typed"}
    strange = {p.name for p in GENERATED.iterdir() if p.is_file() and p.suffix != ".so"} - known
    assert not strange, "nothing else is generated"


def test_another_process_with_another_hash_seed_emits_the_same_bytes(
    emitted: Path, tmp_path: Path
) -> None:
    code = (
        "import sys; from pathlib import Path;"
        "from nonsmooth.derive.codegen.regenerate import regenerate; regenerate(Path(sys.argv[1]))"
    )
    subprocess.run(
        [sys.executable, "-c", code, str(tmp_path)],
        check=True,
        env=os.environ | {"PYTHONHASHSEED": "4242"},
    )
    names = {p.name for p in emitted.iterdir()}
    assert names == {p.name for p in tmp_path.iterdir()}
    for name in names:
        assert (tmp_path / name).read_bytes() == (emitted / name).read_bytes(), name


def test_a_second_run_writes_nothing(emitted: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    texts = {p.name: p.read_text(encoding="utf-8") for p in emitted.iterdir()}
    monkeypatch.setattr(regenerate, "_wanted", lambda *_: texts)
    before = {p: p.stat().st_mtime_ns for p in emitted.iterdir()}
    assert regenerate.regenerate(emitted) == []
    assert before == {p: p.stat().st_mtime_ns for p in emitted.iterdir()}


def test_provenance_records_every_file(emitted: Path) -> None:
    record = json.loads((emitted / "PROVENANCE.json").read_text(encoding="utf-8"))
    assert record["systems"] == list(SYSTEMS)
    assert record["sympy"] == sp.__version__
    assert record["command"] == COMMAND
    assert set(record["files"]) == {p.name for p in emitted.iterdir()} - {"PROVENANCE.json"}
    for name, entry in record["files"].items():
        assert hashlib.sha256((emitted / name).read_bytes()).hexdigest() == entry["sha256"]
        stamp = (emitted / name).read_text(encoding="utf-8")[:400]
        assert "Generated; do not edit." in stamp
        assert f"Source: {entry['source']}" in stamp
        assert f"Again: {COMMAND}" in stamp
        assert f"SymPy {sp.__version__}, derivation {entry['derivation']}" in stamp
        assert not re.search(r"\b20\d\d-|\b\d\d:\d\d\b", stamp), "no dates"


def test_derivations_agree_in_python_and_c(emitted: Path) -> None:
    source = (emitted / "dry_friction.py").read_text(encoding="utf-8")
    (derivation,) = re.findall(r'^DERIVATION = "(\w+)"$', source, re.MULTILINE)
    extension = (emitted / "_kernels.c").read_text(encoding="utf-8")
    assert f'"derivation_dry_friction", "{derivation}"' in extension
    record = json.loads((emitted / "PROVENANCE.json").read_text(encoding="utf-8"))
    for suffix in (".py", ".c", ".h", ".md"):
        assert record["files"][f"dry_friction{suffix}"]["derivation"] == derivation


# --- common subexpressions --------------------------------------------------------------

INPUTS = sp.symbols("a b c", positive=True)


@st.composite
def programs(draw: st.DrawFn) -> Kernel:
    """Straight-line programs over positive inputs, with shared and negated terms."""
    known: list[sp.Expr] = [*INPUTS, sp.Integer(2)]
    stages = []

    def expression() -> sp.Expr:
        terms = []
        for _ in range(draw(st.integers(1, 3))):
            factors = draw(st.lists(st.sampled_from(known), min_size=1, max_size=3))
            sign = draw(st.sampled_from([1, 1, -1, sp.Rational(3, 7)]))
            term = sign * sp.Mul(*factors)
            terms.append(draw(st.sampled_from([term, sp.cos(term), 1 / (1 + term**2)])))
        return sp.Add(*terms)

    for number in range(draw(st.integers(1, 4))):
        shared = expression()
        assignments = []
        for place in range(draw(st.integers(1, 3))):
            symbol = sp.Symbol(f"s{number}_{place}", real=True)
            choice = draw(st.sampled_from([shared, -shared, shared + expression(), expression()]))
            assignments.append((symbol, choice))
            known.append(symbol)
        stages.append(Stage(f"stage {number}", tuple(assignments)))
    outputs = tuple(expression() for _ in range(4))
    return Kernel(
        "probe", "A probe.", (Argument("inputs", (3,), INPUTS),),
        (Output("first", (2,), outputs[:2]), Output("second", (2, 1), outputs[2:])), tuple(stages),
    )  # fmt: skip


POINT = {s: sp.Rational(n, 10) for s, n in zip(INPUTS, (7, 13, 4), strict=True)}


def values_of(lines: Any, outputs: Sequence[sp.Expr]) -> list[Any]:
    known = dict(POINT)
    for line in lines:
        assert line.expression.free_symbols <= set(known), "used before it is assigned"
        known[line.symbol] = sp.N(line.expression.xreplace(known), 40)
    return [sp.N(e.xreplace(known), 40) for e in outputs]


def agree(found: Sequence[Any], expected: Sequence[Any]) -> bool:
    return all(abs(a - b) <= abs(b) * 1e-30 + 1e-30 for a, b in zip(found, expected, strict=True))


@PROPERTY
@given(programs())
def test_eliminating_common_terms_keeps_every_value(kernel: Kernel) -> None:
    outputs = [e for output in kernel.outputs for e in output.expressions]
    expected = [sp.N(e, 40) for e in evaluate(kernel.stages, outputs, POINT)]
    body = body_of(kernel)
    results = [e for output in body.outputs for e in output]
    assert agree(values_of(body.lines, results), expected)
    assert len({line.symbol for line in body.lines}) == len(body.lines)
    # only what the outputs need
    kept = needed(body.lines, results)
    assert agree(values_of(kept, results), expected)
    wanted = set().union(
        *(e.free_symbols for e in results), *(k.expression.free_symbols for k in kept)
    )
    assert {line.symbol for line in kept} <= wanted
    # what depends on the first input alone comes first
    fixed, moving = split(body, {INPUTS[0]})
    assert agree(values_of((*fixed, *moving), results), expected)
    assert sorted(map(str, (*fixed, *moving))) == sorted(map(str, body.lines))
    known = {INPUTS[0], *(line.symbol for line in fixed)}
    assert all(line.expression.free_symbols <= known for line in fixed)
    assert not any(line.expression.free_symbols <= known for line in moving)
    raised = hoisted(body, {INPUTS[0]})
    results = [e for output in raised.outputs for e in output]
    fixed, moving = split(raised, {INPUTS[0]})
    assert agree(values_of((*fixed, *moving), results), expected)


@PROPERTY
@given(programs())
def test_the_emitted_source_keeps_every_value(kernel: Kernel) -> None:
    outputs = [e for output in kernel.outputs for e in output.expressions]
    expected = [sp.N(e, 40) for e in evaluate(kernel.stages, outputs, POINT)]
    namespace: dict[str, Any] = {}
    exec(python_kernel(kernel, None), namespace)
    lib = Mpmath(45)
    point = [lib.mp.mpf(v.p) / v.q for v in POINT.values()]
    first, second = namespace["probe"](point, lib=lib)
    found = [sp.Float(str(e), 40) for e in (*first, *(row[0] for row in second))]
    assert agree(found, expected)


def test_titles_and_operation_counts_are_those_of_the_body() -> None:
    a, b, _ = INPUTS
    shared = a * b + 1
    names = sp.symbols("u v", real=True)
    stage = Stage("both", ((names[0], sp.cos(shared)), (names[1], sp.sin(shared))))
    body = body_of(Kernel("k", "", (), (Output("o", (), (names[0] * names[1],)),), (stage,)))
    assert [line.title for line in body.lines] == ["both", None, None]
    assert body.operations == 5


# --- printing ---------------------------------------------------------------------------


def computed(expression: sp.Expr, values: dict[str, Any], lib: Any) -> Any:
    return eval(print_python(expression), {"lib": lib} | values)


@pytest.mark.parametrize("power", ["1/2", "-1/2", "3/2", "-3/2", "5/2", "-1", "-2", "3", "-7/2"])
def test_whole_and_half_powers_in_every_arithmetic(power: str, tmp_path: Path) -> None:
    x = sp.Symbol("x", positive=True)
    expression = 3 * x ** sp.Rational(power) / (1 + x)
    expected = float(expression.subs(x, sp.Rational(17, 10)))
    assert computed(expression, {"x": 1.7}, FLOATS) == pytest.approx(expected, rel=1e-15)
    lib, balls = Mpmath(30), Balls()
    assert computed(expression, {"x": lib.mp.mpf("1.7")}, lib) == pytest.approx(expected, rel=1e-15)
    with balls.working(100):
        ball = computed(expression, {"x": flint.arb(17) / 10}, balls)
    assert float(ball) == pytest.approx(expected, rel=1e-15)
    source = print_c(expression)
    python = source.replace("sqrt(", "lib.sqrt(")
    assert eval(python, {"lib": FLOATS, "x": 1.7}) == pytest.approx(expected, rel=1e-15)


def test_numbers_without_a_symbol_have_roots_and_angles_in_every_arithmetic() -> None:
    x = sp.Symbol("x", real=True)
    expression = sp.sqrt(3) + sp.sqrt(2 + sp.sqrt(5)) + Angle(0, x) + sp.sqrt(x**2) / 3
    expected = float(sp.sqrt(3) + sp.sqrt(2 + sp.sqrt(5)) + sp.pi + 1)
    lib, balls = Mpmath(30), Balls()
    assert float(computed(expression, {"x": -3.0}, FLOATS)) == pytest.approx(expected, rel=1e-15)
    assert float(computed(expression, {"x": lib.mp.mpf(-3)}, lib)) == pytest.approx(expected)
    with balls.working(100):
        assert float(computed(expression, {"x": flint.arb(-3)}, balls)) == pytest.approx(expected)
    assert "fabs(x)" in print_c(expression)


@pytest.mark.parametrize(
    "expression",
    [
        sp.Symbol("x", positive=True) ** sp.Rational(1, 3),
        sp.exp(sp.Symbol("x")),
        sp.tan(sp.Symbol("x")),
    ],
    ids=str,
)
def test_what_has_no_kernel_is_refused_by_name(expression: sp.Expr) -> None:
    name = "power" if expression.is_Pow else type(expression).__name__
    with pytest.raises(ValueError, match=name):
        print_python(expression)


def probe(expression: sp.Expr, *symbols: sp.Symbol, argument: str = "inputs") -> Kernel:
    arguments = (Argument(argument, (len(symbols),), symbols),)
    return Kernel("probe", "", arguments, (Output("result", (), (expression,)),), ())


POSITIVE, REAL = sp.Symbol("x", positive=True), sp.Symbol("x", real=True)
TAKEN = {
    "an array": probe(sp.Symbol("inputs") + 1, sp.Symbol("inputs")),
    "two symbols": probe(POSITIVE + REAL, POSITIVE, REAL),
    "a word of C": probe(sp.Symbol("double") + 1, sp.Symbol("double")),
    "a word of Python": probe(sp.Symbol("lambda") + 1, sp.Symbol("lambda")),
    "the arithmetic": probe(sp.Symbol("lib") + 1, sp.Symbol("lib")),
}


@pytest.mark.parametrize("kernel", TAKEN.values(), ids=TAKEN)
def test_a_name_that_is_taken_is_refused(kernel: Kernel) -> None:
    name = str(kernel.arguments[0].symbols[0])
    for emit in (lambda: python_kernel(kernel, None), lambda: c_kernel(kernel, "s", None)):
        with pytest.raises(DerivationError, match=f"the name '{name}' is taken"):
            emit()


@pytest.mark.parametrize(
    ("expression", "message"),
    [(POSITIVE + sp.Symbol("y"), "y has no value"), (POSITIVE * sp.pi, "no kernel holds pi")],
)
def test_what_has_no_value_is_refused(expression: sp.Expr, message: str) -> None:
    with pytest.raises(DerivationError, match=message):
        python_kernel(probe(expression, POSITIVE), None)


def test_names_of_common_terms_avoid_those_of_the_kernel() -> None:
    t0, t1, h0 = symbols = sp.symbols("t0 t1 h0", positive=True)
    expression = sp.cos(t0 * t1) + sp.sin(t0 * t1) * h0 + t0 * t1
    kernel = probe(expression, *symbols)
    namespace: dict[str, Any] = {}
    exec(python_kernel(kernel, None), namespace)
    expected = float(expression.subs({t0: 0.5, t1: 0.25, h0: 2}))
    assert namespace["probe"]([0.5, 0.25, 2.0], lib=FLOATS) == pytest.approx(expected)
    raised = hoisted(Body(body_of(kernel).lines, body_of(kernel).outputs), {t0, t1})
    assert h0 not in {line.symbol for line in raised.lines}


# --- every kernel in every arithmetic ---------------------------------------------------

MODULE: ModuleType = import_module("nonsmooth.generated.dry_friction")
KERNELS = dict(MODULE.KERNELS)
DATA = {"chi": "0.5", "eta": "1", "V": "1", "e1": "3.0195", "e2": "0.4831"}
PRINTED = dict(ORBIT.reference.guess)


def is_flow(kernel: str) -> bool:
    """Of a configuration, in physical coordinates or in those of the orbit."""
    return kernel.startswith(("flow_", "global_stick_flow_"))


def point(kernel: str, seed: int) -> list[list[Fraction]]:
    """Arguments of a kernel at a random parameter point, each a flat list of decimals."""
    source = random.Random(f"{kernel}{seed}")

    def near(value: str) -> Fraction:
        return Fraction(value) * Fraction(source.randint(950, 1050), 1000)

    orbit = {n: near(v) for n, v in {**DATA, **PRINTED}.items()}
    physical = [
        orbit["chi"],
        orbit["eta"],
        orbit["V"],
        *(near(v) for v in ("0.4", "3.4", "0.3", "0.8")),
    ]
    if kernel == "spectrum":
        return [physical[:2]]
    parameters = [orbit[n] for n in DATA]
    if is_flow(kernel):
        state = [Fraction(source.randint(-30, 30), 10) for _ in range(4)]
        given_parameters = physical if kernel.startswith("flow_") else parameters
        return [given_parameters, [], [Fraction(source.randint(1, 60), 10)], state]
    names = ["tau", "tau1"] if kernel.endswith(("reduced", "expand")) else list(PRINTED)
    unknowns = [orbit[n] for n in names]
    moved = [[]] if len(KERNELS[kernel][0]) == 4 else []
    return [parameters, [], *moved, unknowns]


def run(
    kernel: str, arguments: list[list[Fraction]], number: Callable[[Fraction], Any], lib: Any
) -> list[Any]:
    """All results of an emitted kernel in one arithmetic, flat; the spectrum is its own."""
    given_shapes, shapes = KERNELS[kernel]
    numbers = [[number(v) for v in a] for a in arguments]
    if kernel != "spectrum":
        spectrum, derivatives = MODULE.spectrum(numbers[0][:2], lib=lib)
        numbers[1] = spectrum
        if len(given_shapes) == 4 and not is_flow(kernel):
            numbers[2] = derivatives
    passed = [n if shape else n[0] for n, shape in zip(numbers, given_shapes, strict=True)]
    found = getattr(MODULE, kernel)(*passed, lib=lib)
    flat = []
    for value, shape in zip(found if len(shapes) > 1 else (found,), shapes, strict=True):
        rows = [value] if not shape else value
        flat += [e for row in rows for e in row] if len(shape) == 2 else list(rows)
    return flat


@pytest.mark.parametrize("kernel", KERNELS)
def test_floats_mpmath_and_balls_agree(kernel: str) -> None:
    lib, precise, balls = Mpmath(50), Mpmath(80), Balls()
    for seed in range(2):
        arguments = point(kernel, seed)
        exact = run(
            kernel, arguments, lambda v: precise.mp.mpf(v.numerator) / v.denominator, precise
        )
        middle = run(kernel, arguments, lambda v: lib.mp.mpf(v.numerator) / v.denominator, lib)
        double = run(kernel, arguments, float, FLOATS)
        scale = max(1, *(abs(e) for e in exact))
        for a, b, c in zip(exact, middle, double, strict=True):
            assert abs(a - b) <= scale * precise.mp.mpf(10) ** -45
            assert abs(a - float(c)) <= float(scale) * 1e-12
        with balls.working(200):
            enclosed = run(
                kernel, arguments, lambda v: flint.arb(v.numerator) / v.denominator, balls
            )
            for a, ball in zip(exact, enclosed, strict=True):
                ball = flint.arb(ball)
                assert ball.overlaps(flint.arb(precise.mp.nstr(precise.mp.mpf(a), 78), "1e-70"))
                assert ball.rad() < 1e-40


@pytest.fixture(scope="module")
def equations() -> EquationSystem:
    return derive_equations(ORBIT)


def test_kernels_are_the_stages_written_out(equations: EquationSystem) -> None:
    """Each orbit kernel against its stages, evaluated one by one without any elimination."""
    lib = Mpmath(50)
    names = {"sin": lib.sin, "cos": lib.cos, "sqrt": lib.sqrt, "Angle": lib.angle}
    for kernel in orbit_kernels(equations):
        name = python_function(kernel.name, ORBIT.name)
        arguments = point(name, 5)
        numbers = [[lib.mp.mpf(v.numerator) / v.denominator for v in a] for a in arguments]
        spectrum, derivatives = MODULE.spectrum(numbers[0][:2], lib=lib)
        numbers[1] = spectrum
        if len(numbers) == 4 and not is_flow(name):
            numbers[2] = [d for row in derivatives for d in row]
        known: dict[sp.Symbol, Any] = {}
        for argument, values in zip(kernel.arguments, numbers, strict=True):
            known |= dict(zip(argument.symbols, values, strict=True))

        def value(expression: sp.Expr, known: dict[sp.Symbol, Any] = known) -> Any:
            symbols = sorted(expression.free_symbols, key=str)
            function = sp.lambdify(symbols, expression, [names, lib.mp])
            return function(*(known[s] for s in symbols))

        for stage in kernel.stages:
            for symbol, expression in stage.assignments:
                known[symbol] = value(expression)
        expected = [value(sp.sympify(e)) for o in kernel.outputs for e in o.expressions]
        found = run(name, arguments, lambda v: lib.mp.mpf(v.numerator) / v.denominator, lib)
        for a, b in zip(found, expected, strict=True):
            assert abs(a - b) <= lib.mp.mpf(10) ** -44 * max(1, abs(b)), kernel.name


# --- C ----------------------------------------------------------------------------------


def extension() -> ModuleType:
    return pytest.importorskip(
        "nonsmooth.generated._kernels", reason="the compiled kernels are not built"
    )


def arrays_for(kernel: str, count: int) -> list[np.ndarray]:
    """Arguments of a kernel for several points, stacked along the first axis."""
    stacked = []
    for seed in range(count):
        arguments = [[float(v) for v in a] for a in point(kernel, seed)]
        if kernel != "spectrum":
            spectrum, derivatives = MODULE.spectrum(arguments[0][:2], lib=FLOATS)
            arguments[1] = [float(s) for s in spectrum]
            if len(arguments) == 4 and not is_flow(kernel):
                arguments[2] = np.array(derivatives, dtype=float)
        shapes = KERNELS[kernel][0]
        stacked.append([np.reshape(a, shape) for a, shape in zip(arguments, shapes, strict=True)])
    return [np.stack(column) for column in zip(*stacked, strict=True)]


def both(kernel: str, arrays: Sequence[np.ndarray]) -> tuple[list[np.ndarray], list[np.ndarray]]:
    inputs, outputs = KERNELS[kernel]
    plain = door._vectorised(getattr(MODULE, kernel), inputs, outputs)(*arrays)
    built = getattr(extension(), f"dry_friction_{kernel}")(*arrays)
    return [list(r) if isinstance(r, tuple) else [np.asarray(r)] for r in (plain, built)]


def close_in_ulps(plain: np.ndarray, built: np.ndarray) -> None:
    """Equal within 300 ulps of the largest entry: sine and cosine differ in the last bit."""
    assert plain.shape == built.shape
    scale = max(1.0, float(np.max(np.abs(plain), initial=0.0)))
    assert float(np.max(np.abs(plain - built), initial=0.0)) <= 300 * np.finfo(float).eps * scale


@pytest.mark.compiled
@pytest.mark.parametrize("kernel", KERNELS)
def test_compiled_kernels_are_the_numpy_ones(kernel: str) -> None:
    arrays = arrays_for(kernel, 7)
    for plain, built in zip(*both(kernel, arrays), strict=True):
        close_in_ulps(plain, built)


@pytest.mark.compiled
@pytest.mark.parametrize("kernel", KERNELS)
def test_compiled_kernels_broadcast_over_any_strides(kernel: str) -> None:
    function = getattr(extension(), f"dry_friction_{kernel}")
    arrays = arrays_for(kernel, 6)
    plain = function(*arrays)

    def outputs(found: Any) -> list[np.ndarray]:
        return list(found) if isinstance(found, tuple) else [np.asarray(found)]

    # every second of a longer array, backwards in memory, in Fortran order, and read-only
    strided, reversed_, fortran = [], [], []
    for array in arrays:
        wide = np.full((2 * len(array), *array.shape[1:]), np.nan)
        wide[::2] = array
        strided.append(wide[::2])
        reversed_.append(np.ascontiguousarray(array[::-1])[::-1])
        copy = np.asfortranarray(array)
        copy.setflags(write=False)
        fortran.append(copy)
    for other in (strided, reversed_, fortran):
        for a, b in zip(outputs(plain), outputs(function(*other)), strict=True):
            np.testing.assert_array_equal(a, b)
    # a 3 x 2 grid, with the first argument the same along one axis
    grid = [a.reshape(3, 2, *a.shape[1:]) for a in arrays]
    if len(grid) > 1:
        grid[-1] = grid[-1][:, :1]
    wanted = np.broadcast_shapes(
        *(a.shape[: a.ndim - len(s)] for a, s in zip(grid, KERNELS[kernel][0], strict=True))
    )
    full = [
        np.broadcast_to(a, (*wanted, *s)).reshape(-1, *s)
        for a, s in zip(grid, KERNELS[kernel][0], strict=True)
    ]
    for a, b in zip(outputs(function(*grid)), outputs(function(*full)), strict=True):
        np.testing.assert_array_equal(a.reshape(b.shape), b)
    # no points at all
    for array, shape in zip(
        outputs(function(*(a[:0] for a in arrays))), KERNELS[kernel][1], strict=True
    ):
        assert array.shape == (0, *shape)


@pytest.mark.compiled
def test_the_extension_is_of_this_derivation_and_holds_every_kernel() -> None:
    built = extension()
    assert built.derivation_dry_friction == MODULE.DERIVATION
    assert {f"dry_friction_{k}" for k in KERNELS} <= set(dir(built))


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The emitted C, compiled as strict C99 without one warning."""
    target = tmp_path_factory.mktemp("c") / "dry_friction.o"
    command = [compiler, *FLAGS, "-O1", "-c", str(GENERATED / "dry_friction.c"), "-o", str(target)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return target


@needs_compiler
def test_a_c_program_gives_the_residual_and_the_trace(library: Path, tmp_path: Path) -> None:
    program = tmp_path / "residual_and_trace"
    source = ROOT / "tests" / "c" / "residual_and_trace.c"
    subprocess.run(
        [compiler, *FLAGS, f"-I{GENERATED}", str(source), str(library), "-o", str(program), "-lm"],
        check=True,
    )
    words = [*DATA.values(), *(PRINTED[n] for n in PRINTED)]
    done = subprocess.run([str(program), *words], capture_output=True, text=True, check=True)
    *residual, trace = map(float, done.stdout.split())
    lib = Mpmath(40)
    exact = [[Fraction(v) for v in DATA.values()], [], [Fraction(v) for v in PRINTED.values()]]
    for kernel, found in (("global_stick_residual", residual), ("global_stick_trace", [trace])):
        for number, arithmetic in (
            (float, FLOATS),
            (lambda v: lib.mp.mpf(v.numerator) / v.denominator, lib),
        ):
            expected = run(kernel, exact, number, arithmetic)
            assert [float(e) for e in expected] == pytest.approx(found, rel=1e-14, abs=1e-14)
    # the printed digits meet the switching conditions to 1e-4 and miss the closure by 2e-2
    assert max(map(abs, residual[:3])) < 2e-4
    assert 0.01 < max(map(abs, residual[4:])) < 0.04
    wrong = subprocess.run([str(program), "1"], capture_output=True, text=True, check=False)
    assert wrong.returncode == 2
    assert "usage" in wrong.stderr


@needs_compiler
@pytest.mark.skipif(shutil.which("nm") is None, reason="there is no nm")
def test_public_c_symbols_have_the_name_of_their_system(library: Path) -> None:
    listing = subprocess.run(
        ["nm", "-g", "--defined-only", str(library)], capture_output=True, text=True, check=True
    ).stdout
    # clones for several processors carry a suffix; a resolver has the name itself
    symbols = {line.split()[-1] for line in listing.splitlines() if line}
    assert {s for s in symbols if not s.startswith(("dry_friction_", "nonsmooth_"))} == set()
    header = (GENERATED / "dry_friction.h").read_text(encoding="utf-8")
    declared = set(re.findall(r"^void (\w+)\(", header, re.MULTILINE))
    assert declared == {s.partition(".")[0] for s in symbols}
    assert {f"dry_friction_{k}" for k in KERNELS} <= declared


@pytest.mark.skipif(shutil.which("g++") is None, reason="there is no g++")
def test_the_header_is_cplusplus_too() -> None:
    text = '#include "dry_friction.h"\n#include "dry_friction.h"\nint main() { return 0; }\n'
    done = subprocess.run(
        ["g++", "-x", "c++", "-std=c++11", "-Wall", "-Wextra", "-Werror", "-pedantic",
         "-fsyntax-only", f"-I{GENERATED}", "-"],
        input=text, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr


# --- files that are cut, edited or foreign ----------------------------------------------


@pytest.fixture
def copied(emitted: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A copy of the emitted files that both the check and the door to the kernels read."""
    folder = tmp_path / "generated"
    shutil.copytree(emitted, folder)
    texts = {p.name: p.read_text(encoding="utf-8") for p in emitted.iterdir()}
    monkeypatch.setattr(regenerate, "_wanted", lambda *_: texts)
    monkeypatch.setattr(door, "files", lambda _: folder)
    caches = (door._provenance, door._system, door._orbit)
    for cached in caches:
        cached.cache_clear()
    yield folder
    for cached in caches:
        cached.cache_clear()


def edit_record(folder: Path, **changes: Any) -> None:
    path = folder / "PROVENANCE.json"
    path.write_text(json.dumps(json.loads(path.read_text()) | changes), encoding="utf-8")


def test_an_untouched_copy_is_fine(copied: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NONSMOOTH_BACKEND", "numpy")
    assert regenerate.check(copied).same
    if (copied / "dry_friction.py").read_bytes() == (GENERATED / "dry_friction.py").read_bytes():
        assert door.load_orbit("dry-friction/global-stick").name == "dry-friction/global-stick"


@pytest.mark.parametrize("name", ["dry_friction.py", "dry_friction.c", "support.h", "_kernels.c"])
def test_the_check_shows_what_differs(copied: Path, name: str) -> None:
    path = copied / name
    path.write_text(path.read_text().replace("Generated", "Written", 1), encoding="utf-8")
    (difference,) = regenerate.check(copied).differences
    assert f"{name} (found)" in difference
    assert re.search(r"^-.*Written; do not edit", difference, re.MULTILINE)
    assert re.search(r"^\+.*Generated; do not edit", difference, re.MULTILINE)
    path.unlink()
    assert regenerate.check(copied).differences == (f"{name}: missing",)


def test_the_check_refuses_another_sympy(copied: Path) -> None:
    edit_record(copied, sympy="1.5.0")
    with pytest.raises(DerivationError, match=r'of SymPy 1\.5\.0.*pip install "sympy==1\.5\.0"'):
        regenerate.check(copied)


CUT = {
    "cut": lambda text: text[: len(text) // 2],
    "empty": lambda text: "",
    "a list": lambda text: "[]",
    "of something else": lambda text: '{"name": "other"}',
}


@pytest.mark.parametrize("damage", CUT.values(), ids=CUT)
def test_a_damaged_record_is_named(copied: Path, damage: Callable[[str], str]) -> None:
    path = copied / "PROVENANCE.json"
    path.write_text(damage(path.read_text()), encoding="utf-8")
    with pytest.raises(DerivationError, match=r"PROVENANCE\.json cannot be read: regenerate"):
        regenerate.check(copied)
    with pytest.raises(InputError, match=r"PROVENANCE\.json is missing, cut or foreign: run"):
        door.load_system("dry-friction")


def test_a_missing_record_is_named(copied: Path) -> None:
    (copied / "PROVENANCE.json").unlink()
    with pytest.raises(DerivationError, match="cannot be read"):
        regenerate.check(copied)
    with pytest.raises(InputError, match="missing, cut or foreign"):
        door.system_names()


def test_a_cut_kernel_file_is_named(copied: Path) -> None:
    path = copied / "dry_friction.py"
    path.write_bytes(path.read_bytes()[:-100])
    with pytest.raises(
        InputError, match=r"dry_friction\.py is not the file that PROVENANCE"
    ) as caught:
        door.load_orbit("dry-friction/global-stick")
    assert "nonsmooth regenerate" in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.compiled
def test_compiled_kernels_of_another_derivation_are_named(monkeypatch: pytest.MonkeyPatch) -> None:
    extension()
    monkeypatch.setenv("NONSMOOTH_BACKEND", "c")
    monkeypatch.setattr(MODULE, "DERIVATION", "0123456789abcdef")
    door._system.cache_clear()
    try:
        with pytest.raises(InputError, match="compiled kernels of dry-friction are of another"):
            door.load_system("dry-friction")
        monkeypatch.setenv("NONSMOOTH_BACKEND", "numpy")
        assert door.load_system("dry-friction").compiled is None
    finally:
        door._system.cache_clear()


def test_outside_a_checkout_the_folder_must_be_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(regenerate, "__file__", str(tmp_path / "a" / "b" / "c" / "regenerate.py"))
    with pytest.raises(DerivationError, match=r"not a checkout of nonsmooth.*--out DIR"):
        regenerate.find_generated()
