"""Emitted files: reproducible, stamped, and each expression with the value it had."""

from __future__ import annotations

import hashlib
import json
import os
import re
import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from importlib import import_module
from pathlib import Path
from typing import Any

import flint
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from nonsmooth import InputError
from nonsmooth.derive import DerivationError, Parameter, RigidStop, oscillator
from nonsmooth.derive.codegen import regenerate
from nonsmooth.derive.codegen.any_arithmetic import print_python, python_kernel
from nonsmooth.derive.codegen.body import Constant, body_of, needed, split
from nonsmooth.derive.codegen.c import print_c
from nonsmooth.derive.codegen.emit import COMMAND, emit_system
from nonsmooth.derive.codegen.python_file import emit_python, system_table
from nonsmooth.derive.codegen.simulation_form import SimulationForm
from nonsmooth.derive.equations.explicit import Angle
from nonsmooth.derive.equations.program import Argument, Kernel, Output, Stage, evaluate
from nonsmooth.derive.flows.modal import derive_flows
from nonsmooth.derive.systems import SYSTEMS
from nonsmooth.runtime.core.arithmetic import FLOATS, Balls, Mpmath
from nonsmooth.runtime.model import kernels as door
from tests.places import CHECKOUT

GENERATED = CHECKOUT / "generated"
RECORD = json.loads((GENERATED / "PROVENANCE.json").read_text(encoding="utf-8"))
PROPERTY = settings(max_examples=12)

same_sympy = pytest.mark.skipif(
    RECORD["sympy"] != sp.__version__,
    reason=f"generated/ is of SymPy {RECORD['sympy']}, this is {sp.__version__}",
)


def emit_in_a_process(folder: Path, seed: int, system: str | None = None) -> None:
    """Derive and emit in a process of its own, with its own order of hashes."""
    code = (
        "import sys; from pathlib import Path;"
        "from nonsmooth.derive.codegen.regenerate import outdated;"
        "folder = Path(sys.argv[1]);"
        "texts = outdated(folder, *sys.argv[2:]);"
        "[(folder / name).write_bytes(text.encode()) for name, text in texts.items()]"
    )
    subprocess.run(
        [sys.executable, "-c", code, str(folder), *([system] if system else [])],
        check=True,
        env=os.environ | {"PYTHONHASHSEED": str(seed)},
    )


# --- the same bytes, always -------------------------------------------------------------


@pytest.mark.slow
@same_sympy
def test_committed_files_are_what_the_derivation_gives(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    emit_in_a_process(tmp_path, 4242)
    texts = {p.name: p.read_text(encoding="utf-8") for p in tmp_path.iterdir()}
    monkeypatch.setattr(regenerate, "_wanted", lambda *_: texts)
    differences = regenerate.check(GENERATED)
    assert not differences, f"run `{COMMAND}`:\n" + "\n\n".join(differences)
    for name, text in texts.items():
        assert (GENERATED / name).read_bytes() == text.encode()
    known = {*texts, "__init__.py", "py.typed"}
    strange = {p.name for p in GENERATED.iterdir() if p.is_file() and p.suffix != ".so"} - known
    assert not strange, "nothing else is generated"


@pytest.mark.slow
def test_another_process_with_another_hash_seed_emits_the_same_bytes(tmp_path: Path) -> None:
    here = regenerate.outdated(tmp_path / "absent", "rigid-stop")
    emit_in_a_process(tmp_path, 7, "rigid-stop")
    assert {path.name for path in tmp_path.iterdir()} == set(here)
    for name, text in here.items():
        assert (tmp_path / name).read_bytes() == text.encode(), name


@pytest.fixture
def committed(tmp_path: Path, committed_derivation: dict[str, str]) -> Path:
    """A folder of the committed files, which are what the derivation gives."""
    folder = tmp_path / "generated"
    folder.mkdir()
    for name, text in committed_derivation.items():
        (folder / name).write_bytes(text.encode())
    return folder


def test_only_files_that_differ_are_written_again(committed: Path) -> None:
    assert regenerate.outdated(committed) == {}
    (committed / "nonsmooth_sums.h").write_text("changed")
    (committed / "rigid_stop.md").unlink()
    assert set(regenerate.outdated(committed)) == {"nonsmooth_sums.h", "rigid_stop.md"}


def test_provenance_records_every_file() -> None:
    assert RECORD["systems"] == list(SYSTEMS)
    assert RECORD["command"] == COMMAND
    names = {p.name for p in GENERATED.iterdir() if p.suffix in (".py", ".c", ".h", ".md")}
    assert set(RECORD["files"]) == names - {"__init__.py"}
    for name, entry in RECORD["files"].items():
        assert hashlib.sha256((GENERATED / name).read_bytes()).hexdigest() == entry["sha256"]
        stamp = (GENERATED / name).read_text(encoding="utf-8")[:400]
        assert "Generated; do not edit." in stamp
        assert f"Source: {entry['source']}" in stamp
        assert f"Again: {COMMAND}" in stamp
        assert f"SymPy {RECORD['sympy']}, derivation {entry['derivation']}" in stamp
        assert not re.search(r"\b20\d\d-|\b\d\d:\d\d\b", stamp), "no dates"


@pytest.mark.parametrize("stem", SYSTEMS.values())
def test_derivations_agree_in_python_and_c(stem: str) -> None:
    source = (GENERATED / f"{stem}.py").read_text(encoding="utf-8")
    (derivation,) = re.findall(r'^DERIVATION = "(\w+)"$', source, re.MULTILINE)
    extension = (GENERATED / "_kernels.c").read_text(encoding="utf-8")
    assert f'"derivation_{stem}", "{derivation}"' in extension
    for suffix in (".py", ".c", ".h", ".md"):
        assert RECORD["files"][f"{stem}{suffix}"]["derivation"] == derivation


def test_tables_are_read_as_they_were_told() -> None:
    words = 'what "pushes", \\n {back}: [x, "", \'\'\']; ' * 5
    stiffness = Parameter("k", words)
    system = oscillator(
        "told", ["x"], [[1]], [[stiffness.symbol]], parameters=[stiffness], description=words
    )
    text, found = emit_python(system, [], "tests"), dict[str, Any]()
    exec(text, found)
    assert found["SYSTEM"]["parameters"][0]["description"] == words
    assert found["SYSTEM"] == system_table(SimulationForm(system, *derive_flows(system)))
    tables = text[text.index("SYSTEM") : text.index("def ")]
    assert max(len(line) for line in tables.splitlines() if "pushes" not in line) <= 120


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


@pytest.mark.slow
@PROPERTY
@given(programs())
def test_eliminating_common_terms_keeps_every_value(kernel: Kernel) -> None:
    outputs = [e for output in kernel.outputs for e in output.expressions]
    expected = [sp.N(e, 40) for e in evaluate(kernel.stages, outputs, POINT)]
    body = body_of(kernel)
    results = [e for output in body.outputs for e in output.expressions]
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


@pytest.mark.slow
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
    given = (Argument("inputs", (3,), INPUTS),)
    body = body_of(Kernel("k", "", given, (Output("o", (), (names[0] * names[1],)),), (stage,)))
    assert [line.title for line in body.lines] == ["both", None, None]
    assert body.operations == 5


def test_numpy_is_given_no_function_of_nothing() -> None:
    """A generalized ufunc has no core dimension of size 0, such as that of no parameters."""
    for stiffness in (1, sp.Symbol("k")):
        stops = [RigidStop("x", at=1, restitution=1, name="wall")]
        system = oscillator("struck", ["x"], [[1]], [[stiffness]], elements=stops)
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


def test_irrational_numbers_have_an_order_that_no_hash_decides() -> None:
    numbers = [Constant(sp.sqrt(2) / 4 + sp.Rational(1, 2)), Constant(sp.sqrt(2)), Constant(sp.pi)]
    assert len({*map(sp.default_sort_key, numbers)}) == 3


def computed(expression: sp.Expr, values: dict[str, Any], lib: Any) -> Any:
    return eval(print_python(expression), {"lib": lib} | values)


@pytest.mark.parametrize("power", ["1/2", "-1/2", "3/2", "-3/2", "5/2", "-1", "-2", "3", "-7/2"])
@pytest.mark.parametrize("alone", [True, False])
def test_whole_and_half_powers_in_every_arithmetic(power: str, alone: bool) -> None:
    x = sp.Symbol("x", positive=True)
    expression = x ** sp.Rational(power)
    expression = expression if alone else 3 * expression / (1 + x)
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


@pytest.mark.parametrize(
    ("expression", "message"),
    [(POSITIVE + sp.Symbol("y"), "y has no value"), (POSITIVE * sp.I, "no kernel holds I")],
)
def test_what_has_no_value_is_refused(expression: sp.Expr, message: str) -> None:
    with pytest.raises(DerivationError, match=message):
        python_kernel(probe(expression, POSITIVE), None)


# --- files that are cut, edited or foreign ----------------------------------------------


@pytest.fixture
def copied(committed: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A copy of the generated files that both the check and the door to the kernels read."""
    monkeypatch.setattr(door, "files", lambda _: committed)
    caches = (door._provenance, door._system, door._orbit)
    for cached in caches:
        cached.cache_clear()
    yield committed
    for cached in caches:
        cached.cache_clear()


def edit_record(folder: Path, **changes: Any) -> None:
    path = folder / "PROVENANCE.json"
    path.write_text(json.dumps(json.loads(path.read_text()) | changes), encoding="utf-8")


@same_sympy
def test_an_untouched_copy_is_fine(copied: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NONSMOOTH_BACKEND", "numpy")
    assert not regenerate.check(copied)
    for name in door.orbit_names():
        assert door.load_orbit(name).name == name


@same_sympy
@pytest.mark.parametrize(
    "name", ["rigid_stop.py", "dry_friction.c", "nonsmooth_sums.h", "_kernels.c"]
)
def test_the_check_shows_what_differs(copied: Path, name: str) -> None:
    path = copied / name
    path.write_text(path.read_text().replace("Generated", "Written", 1), encoding="utf-8")
    (difference,) = regenerate.check(copied)
    assert f"{name} (found)" in difference
    assert re.search(r"^-.*Written; do not edit", difference, re.MULTILINE)
    assert re.search(r"^\+.*Generated; do not edit", difference, re.MULTILINE)
    path.unlink()
    assert regenerate.check(copied) == (f"{name}: missing",)


def test_formulas_that_differ_come_first_and_stamps_last(tmp_path: Path) -> None:
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
    derived["d.h"] = derived["d.h"].replace("\n", "\r\n")
    derived["e.md"] += "More.\n"
    for name, text in written.items():
        (tmp_path / name).write_text(text)
    (tmp_path / "f.py").unlink()
    missing, *changed, stamps, ends = regenerate.differences(tmp_path, derived)
    assert (missing, stamps) == ("f.py: missing", "c.h: its stamps alone")
    assert ends == "d.h: its ends of lines alone"
    assert [text.split()[1] for text in changed] == ["e.md", "b.py", "a.c"]
    assert changed[0].splitlines()[2:] == ["line 2:", "+More."]
    for text, line, end in ((changed[1], 2, ""), (changed[2], 3, ";")):
        place, found, wanted = (t for t in text.splitlines()[2:] if t[1:3] != "c ")
        assert place == f"line {line}:"
        assert (found[:5], wanted[:5]) == ("-... ", "+... ")
        assert found.endswith(f"x99 - y{end}")
        assert wanted.endswith(f"x99 + y{end}")
    assert [text.count("\n") for text in changed] == [3, 4, 6]


def test_stamps_are_known_by_what_stands_before_them(tmp_path: Path) -> None:
    for stamp in (
        'DERIVATION = "{}"',
        "derivation {}",
        '{{"derivation": "{}"}}',
        '"derivation_elastic_stop", "{}"',
    ):
        (tmp_path / "g.c").write_text(stamp.format("0" * 16))
        wanted = {"g.c": stamp.format("f" * 16)}
        assert regenerate.differences(tmp_path, wanted) == ("g.c: its stamps alone",)
    (tmp_path / "g.json").write_text(f'"sha256": "{"0" * 64}"')
    wanted = {"g.json": f'"sha256": "{"f" * 64}"'}
    assert regenerate.differences(tmp_path, wanted) == ("g.json: its stamps alone",)


def test_decimals_of_sixteen_digits_are_no_stamps(tmp_path: Path) -> None:
    (tmp_path / "support.h").write_text("x = -0.3333333333333333;\n")
    (difference,) = regenerate.differences(tmp_path, {"support.h": "x = -0.3333333333333334;\n"})
    assert re.search(r"^\+x = -0\.3333333333333334;$", difference, re.MULTILINE)


def test_another_installation_than_that_of_the_place_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    inside = tmp_path / "runtime"
    inside.mkdir()
    monkeypatch.chdir(inside)
    assert regenerate.surrounding_checkout() is None
    (tmp_path / "pyproject.toml").write_text('[project]\nname = "nonsmooth"\n')
    assert regenerate.surrounding_checkout() == tmp_path
    monkeypatch.chdir(GENERATED)
    checkout = regenerate.surrounding_checkout()
    assert checkout / "generated" == regenerate.find_generated()


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


def test_outside_a_checkout_the_folder_must_be_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(regenerate, "__file__", str(tmp_path / "a" / "b" / "c" / "regenerate.py"))
    with pytest.raises(DerivationError, match=r"not a checkout of nonsmooth.*--out DIR"):
        regenerate.find_generated()


def test_a_number_in_front_of_a_sum_is_no_product_of_its_terms() -> None:
    """SymPy's cse gives -a b c/32 for the last of these."""
    a, b, c = sp.symbols("a b c", real=True)
    total, other = a / 4 + b / 4 - c / 2, a / 4 + b / 4 + c / 2
    results = (sp.factor_terms(total), sp.factor_terms(other), total)
    output = Output("found", (3,), results)
    kernel = Kernel("probe", "", (Argument("given", (3,), (a, b, c)),), (output,), ())
    namespace: dict[str, Any] = {}
    exec(python_kernel(kernel, None), namespace)
    assert namespace["probe"]([1.0, 2.0, 8.0], lib=FLOATS) == [-3.25, 4.75, -3.25]
