"""A user's own declaration: loaded from a file, a folder, or Python, and cached."""

import functools
import gc
import linecache
import math
import os
import subprocess
import sys
import traceback
import weakref
from pathlib import Path
from tempfile import TemporaryDirectory
from types import FunctionType, ModuleType

import numpy as np
import pytest

import nonsmooth
from nonsmooth import InputError, simulate, solve
from nonsmooth.derive import DeclarationError, dry_friction
from nonsmooth.derive.codegen import python_file
from nonsmooth.derive.codegen.emit import emit_package, emit_system
from nonsmooth.runtime.model.kernels import load_orbit, load_system
from nonsmooth.runtime.model.loading import background, caching
from nonsmooth.runtime.model.loading import load as loading
from nonsmooth.runtime.model.loading.declared import declaration_in
from tests.declared import rigid_stop
from tests.user_systems import DAMPED, KICKED, declare


@pytest.fixture(autouse=True)
def cache(tmp_path, monkeypatch):
    """A cache folder of the test's own, and a process that knows nothing yet."""
    folder = tmp_path / "cache"
    monkeypatch.setenv("NONSMOOTH_CACHE", str(folder))
    forget(monkeypatch)
    return folder


def forget(monkeypatch):
    """As in a new process."""
    monkeypatch.setattr(loading, "_MODULES", caching.Modules(9))
    monkeypatch.setattr(loading, "_FILES", {})
    loading._file.cache_clear()


@pytest.fixture
def derivations(monkeypatch):
    """Names of the systems that are derived, one entry for each time."""
    names = []
    derive = python_file.emit_python

    def counted(system, orbits, source):
        names.append(system.name)
        return derive(system, orbits, source)

    monkeypatch.setattr(python_file, "emit_python", counted)
    return names


def read(path):
    return declaration_in(path)


def write_emitted(folder, path):
    """The folder that `nonsmooth generate` would write."""
    folder.mkdir()
    for name, text in emitted_of(path.read_text()).items():
        (folder / name).write_text(text, encoding="utf-8")
    return folder


@functools.cache
def emitted_of(text):
    """What is generated of a declaration, by the names of its files."""
    with TemporaryDirectory() as folder:
        path = declare(Path(folder), text)
        declared = read(path)
        emitted = emit_system(declared.system, declared.orbits, path.name)
        return emit_package([emitted], "nonsmooth generate")


# --- the same system, whatever it is loaded from -----------------------------------------


def test_an_orbit_of_a_folder_is_the_closed_form(tmp_path):
    path = declare(tmp_path)
    name = f"{write_emitted(tmp_path / 'kernels', path)}:loop"
    orbit = solve(name, {"k": 2, "r": "0.25"})
    assert orbit.name == name
    assert orbit.converged
    assert float(orbit.unknowns["v0"]) == pytest.approx(4 / 3, rel=1e-14)
    assert orbit.period == pytest.approx(math.pi / math.sqrt(2) + math.pi / 2, rel=1e-14)
    (multiplier,) = orbit.stability.multipliers
    assert multiplier.real == pytest.approx(0.25, rel=1e-13)
    assert load_orbit(name).derived
    assert load_orbit(f"{path}:loop").table == load_orbit(name).table


def test_a_motion_is_the_same_from_a_file_a_folder_and_a_system(tmp_path):
    path = declare(tmp_path)
    folder = write_emitted(tmp_path / "kernels", path)
    system = read(path).system
    parameters, start = {"k": 1, "r": "0.5"}, {"x": 0, "v": 2}
    motions = [
        simulate(source, parameters, start, "right", transitions=6)
        for source in (str(path), str(folder), system)
    ]
    for motion in motions:
        # closed form: half a turn on either side, v = 2 on the orbit
        halves = np.tile([math.pi, math.pi / 2], 3)
        np.testing.assert_allclose(motion.times, [0, *np.cumsum(halves)], rtol=1e-14)
        np.testing.assert_allclose(motion.states[::2, 1], 2, rtol=1e-14)
        np.testing.assert_array_equal(motion.times, motions[0].times)


def test_a_built_in_system_is_the_same_when_it_is_handed_over():
    own, generated = load_system(rigid_stop.system), load_system("rigid-stop")
    assert own.table == generated.table
    assert generated.built_in
    assert not own.built_in
    point = [1.0, 2.0, 1.0, 5.0, 0.5]
    for kernel in ("fields", "rows", "resets"):
        np.testing.assert_array_equal(
            own.evaluate(kernel, point), generated.evaluate(kernel, point)
        )


def test_a_system_is_found_again_by_its_name_from_the_cache(tmp_path, monkeypatch, derivations):
    system = read(declare(tmp_path)).system
    name = load_system(system).name
    assert name == f"kicked@{system.fingerprint()}"
    forget(monkeypatch)
    assert load_system(name).table["name"] == "kicked"
    assert derivations == ["kicked"]
    forget(monkeypatch)
    monkeypatch.setenv("NONSMOOTH_CACHE", "")
    with pytest.raises(InputError, match=r"kicked@\w+ was declared in Python.*hand over"):
        load_system(name)


def test_a_file_that_is_gone_is_named(tmp_path):
    with pytest.raises(InputError, match="there is no file"):
        load_system(str(tmp_path / "gone" / "mine.py"))


def test_names_are_whole_paths(tmp_path, monkeypatch):
    path = declare(tmp_path)
    monkeypatch.chdir(tmp_path)
    orbit = load_orbit("mine.py:loop")
    monkeypatch.chdir("/")
    assert orbit.name == load_orbit(orbit.name).name == f"{path}:loop"
    assert load_system(path).name == str(path)


# --- systems without closed forms --------------------------------------------------------


def test_an_orbit_without_a_closed_form_is_kept_to_be_composed(tmp_path):
    path = declare(tmp_path, DAMPED)
    for name in (f"{path}:loop", f"{write_emitted(tmp_path / 'kernels', path)}:loop"):
        orbit = load_orbit(name)
        assert not orbit.derived
        assert orbit.table["phases"] == [["right", "falls", "ta"], ["left", "rises", "tb"]]
        assert orbit.table["reference"] == {
            "parameters": {"k": "1", "r": "0.25"},
            "guess": {"v0": "1.9", "ta": "3", "tb": "1.5"},
        }
        assert orbit.table["reason"]
    assert load_orbit("rigid-stop/one-impact").derived


# --- the cache ---------------------------------------------------------------------------


@pytest.mark.slow
def test_the_second_process_derives_nothing(tmp_path):
    path = declare(tmp_path)
    code = (
        "import sys; from nonsmooth.runtime.model.kernels import load_orbit;"
        "load_orbit(sys.argv[1]);"
        "print(sorted(n for n in sys.modules if n.startswith(('nonsmooth.derive', 'sympy'))))"
    )
    outputs = []
    for seed in ("1", "2"):
        done = subprocess.run(
            [sys.executable, "-c", code, f"{path}:loop"],
            env=os.environ | {"PYTHONHASHSEED": seed},
            capture_output=True, text=True, check=False,
        )  # fmt: skip
        outputs.append(done.stdout.strip() or done.stderr)
    assert "'nonsmooth.derive.codegen.python_file'" in outputs[0]
    assert outputs[1] == "[]"


def test_a_declaration_is_derived_once(tmp_path, monkeypatch, derivations, cache):
    path = declare(tmp_path)
    first = load_system(str(path)).module.DERIVATION
    forget(monkeypatch)
    assert first == load_system(str(path)).module.DERIVATION
    assert derivations == ["kicked"]
    assert load_orbit(f"{path}:loop") is load_orbit(f"{path}:loop")
    assert derivations == ["kicked"] * 2, "the system alone, then the orbit"
    kept = sorted(cache.iterdir(), key=lambda entry: entry.stat().st_size)
    assert len(kept) == 4, "what was derived of both, and of which text"
    # another text that declares the same
    declare(tmp_path, f"# a comment\n{KICKED}")
    load_system(str(path))
    load_orbit(f"{path}:loop")
    assert derivations == ["kicked"] * 2


@pytest.mark.parametrize("damage", ["cut", "changed", "binary", "empty", "folder", "pipe"])
def test_a_damaged_cache_is_derived_anew(
    tmp_path,
    monkeypatch,
    derivations,
    cache,
    damage,
):
    path = declare(tmp_path)
    expected = load_system(str(path)).table
    entry = max(cache.iterdir(), key=lambda entry: entry.stat().st_size)
    content = entry.read_bytes()
    if damage in ("folder", "pipe"):
        entry.unlink()
        (Path.mkdir if damage == "folder" else os.mkfifo)(entry)
    else:
        damaged = {
            "cut": content[: len(content) // 2],
            "changed": content.replace(b"kicked", b"licked"),
            "binary": b"\xff\xfe" + content,
            "empty": b"",
        }
        entry.write_bytes(damaged[damage])
    forget(monkeypatch)
    assert load_system(str(path)).table == expected
    assert derivations == ["kicked"] * 2
    if damage not in ("folder", "pipe"):
        assert entry.read_bytes() == content


def test_without_a_cache_all_works(tmp_path, monkeypatch, cache):
    path = declare(tmp_path)
    monkeypatch.setenv("NONSMOOTH_CACHE", "")
    assert caching.cache_folder() is None
    assert load_system(str(path)).table["name"] == "kicked"
    assert not cache.exists()
    forget(monkeypatch)
    monkeypatch.setenv("NONSMOOTH_CACHE", str(path / "below a file"))
    assert load_system(str(path)).table["name"] == "kicked"


def test_the_cache_is_where_the_user_keeps_caches(monkeypatch):
    monkeypatch.delenv("NONSMOOTH_CACHE")
    monkeypatch.setenv("XDG_CACHE_HOME", "/somewhere")
    assert caching.cache_folder() == Path("/somewhere/nonsmooth")
    monkeypatch.delenv("XDG_CACHE_HOME")
    monkeypatch.setenv("HOME", "/home/someone")
    assert caching.cache_folder() == Path("/home/someone/.cache/nonsmooth")


def test_an_edited_file_is_read_again(tmp_path, derivations):
    path = declare(tmp_path)
    assert load_system(str(path)).parameters[1].upper == "1"
    declare(tmp_path, KICKED.replace("upper=1)", "upper=2)"))
    assert load_system(str(path)).parameters[1].upper == "2"
    assert derivations == ["kicked"] * 2


@pytest.mark.parametrize(
    ("more", "times"),
    [
        ("", 1), ("import math\nfrom nonsmooth.derive.systems import rigid_stop\n", 1),
        ("import os\n", 2), ("import nonsmooth.runtime\n", 2),
        ('"""What print(x) gives."""\nz = [2 * sp.sqrt(k) for k in range(3)]\n', 1),
        ("sp.randprime\n", 2), ("print(x)\n", 2), ("__file__\n", 2), ("a = open\n", 2),
        ("from nonsmooth.derive import read_matrices as a\n", 2),
        ("from nonsmooth.derive.building.matrices import os\n", 2),
        ("sp.utilities.misc.os.environ\n", 2), ("'{0.utilities.misc.os}'.format(sp)\n", 2),
        ("match sp.pi:\n    case object(args=a):\n        pass\n", 2),
        ("a = sp.lambdify([], 'open')\n", 2), ("a = sp.Symbol('(2)')\n", 2),
        ("a = hash('a')\n", 2), ("len = 1\nopen = 2\n", 2),
        ("a = {'b'}\n", 1), ("a = {'b', 'c'}\n", 2), ("a = {b for b in 'bc'}\n", 2),
        ("a = [*system.configurations[0].boundaries[0].function.free_symbols]\n", 2),
        ("from nonsmooth.derive import reduce_structure as a\n", 2),
        ("a = [*({*'bc'})]\n", 2), ("a = [*({'b'} | {'c'})]\n", 2),
        ("a = [*({'b': 1}.keys() - {})]\n", 2), ("a = {'b': 1}.items()\na |= {'c'}\n", 2),
        ("a = [*map(str, {'b': 1}.keys())]\n", 2),
        ("for a, b in {'b': 1}.items():\n    pass\na = dict(sorted({'b': 1}.items()))\n", 1),
        ("def a(n):\n    try:\n        return a(n + 1)\n    except:\n        return n\n", 2),
        ("from nonsmooth.derive.systems import import_module as a\na('os').name\n", 2),
    ],
)  # fmt: skip
def test_a_file_whose_text_says_all_is_not_executed_again(tmp_path, monkeypatch, more, times):
    path, executed = declare(tmp_path, KICKED + more), []
    monkeypatch.setattr(
        loading, "declaration_in", lambda file: executed.append(file) or declaration_in(file)
    )
    first = load_system(str(path)).table
    forget(monkeypatch)
    assert load_system(str(path)).table == first
    assert len(executed) == times
    forget(monkeypatch)
    assert load_orbit(f"{path}:loop").derived, "the orbit is another question to the same text"
    monkeypatch.setattr(
        "nonsmooth.runtime.model.loading.declared._code", lambda: b"that of another release"
    )
    forget(monkeypatch)
    before = len(executed)
    load_system(str(path))
    assert len(executed) == before + 1


def test_kernels_are_compiled_of_the_declaration_that_was_loaded(tmp_path, monkeypatch):
    path, begun = declare(tmp_path), []
    monkeypatch.setattr(background, "_begin", lambda _, declared: begun.append(declared))
    declared = read(path)
    for text in (KICKED, KICKED.replace("[[4]]", "[[9]]")):
        load_orbit(f"{path}:loop")
        forget(monkeypatch)
        library = loading.library_of(load_orbit(f"{path}:loop").system.module)
        assert library is not None
        declare(tmp_path, text)
        library.wanted(math.inf)
    assert begun == [(declared.system, tuple(declared.orbits)), None], (
        "of a file that declares something else by now nothing is compiled"
    )


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ('"loop"', '"ring"'), ("[[4]]", "[[4.5]]"), ("upper=1", "upper=1, closed=True"),
        ("{v: r.symbol * v + 1}", "{v: r.symbol * v + 2}"), ('"rises", x', '"rises", x, "reached"'),
        ('"0.5"', '"0.6"'), ("stiffness on", "spring on"), ("real=True", "real=True, finite=True"),
    ],
)  # fmt: skip
def test_every_change_of_a_declaration_changes_its_fingerprint(tmp_path, old, new):
    assert old in KICKED
    one, other = read(declare(tmp_path)), read(declare(tmp_path, KICKED.replace(old, new), "b.py"))
    assert one.system.fingerprint(one.orbits) != other.system.fingerprint(other.orbits)


def test_equal_declarations_have_one_fingerprint(tmp_path):
    one, other = read(declare(tmp_path)), read(declare(tmp_path, name="b.py"))
    assert one.system.fingerprint(one.orbits) == other.system.fingerprint(other.orbits)
    assert one.system.fingerprint() != one.system.fingerprint(one.orbits)
    assert dry_friction.system.fingerprint() != rigid_stop.system.fingerprint()
    with pytest.raises(DeclarationError, match=r"holds 'loop'|holds <object"):
        rigid_stop.system.fingerprint([object()])


# --- what goes wrong ---------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("x = 1\nsystem = (\n", r"mine\.py, line 2: SyntaxError: '\(' was never closed"),
        ("x = 1\ny = x / 0\n", r"mine\.py, line 2: ZeroDivisionError: division by zero"),
        ("import nowhere_to_be_found\n", "line 1: ModuleNotFoundError: No module named"),
        ("open('/no/such/file')\n", "line 1: FileNotFoundError: .*'/no/such/file'"),
        ("raise SystemExit(3)\n", "line 1: SystemExit: 3"),
        ("raise ValueError('two\\nlines')\n", "line 1: ValueError: two lines"),
        (  # Python reads such sums from 3.13 on
            "x = " + "+".join("1" * 9000) + "\n",
            r"mine\.py(: (RecursionError|MemoryError)| declares no system)",
        ),
        ("x = 1\n", r"declares no system: call one `system`"),
        ("system = {}\n", "`system` is of type dict, not a System"),
        (
            "from nonsmooth.derive import System as system\n",
            "`system` is of type type, not a System",
        ),
        (KICKED + "orbits = 'loop'\n", "`orbits` is of type str, not a list of Itinerary"),
        (KICKED + "orbits = ['loop']\n", "`orbits` holds one of type str, not an Itinerary"),
        (KICKED + "orbits = orbits * 2\n", "orbit 'loop' is declared twice"),
        (
            KICKED + "from dataclasses import replace\nsystem = replace(system, name='other')\n",
            "orbit 'loop' is one of another system",
        ),
        (
            KICKED.replace('SecondOrder([[1]], [[4]])', 'SecondOrder([[-1]], [[4]])'),
            r"mine\.py, line 2\d: configuration 'left': mass is not positive definite",
        ),
    ],
)  # fmt: skip
def test_a_wrong_file_is_told_in_one_line(tmp_path, text, message):
    path = declare(tmp_path, text)
    with pytest.raises(InputError, match=message) as caught:
        load_system(str(path))
    assert "\n" not in str(caught.value)
    assert str(path) in str(caught.value)


def test_names_that_stand_for_nothing(tmp_path):
    path = declare(tmp_path)
    for name, message in (
        ("nothing", "unknown system 'nothing'"),
        (str(tmp_path / "no.py"), "there is no file"),
        (str(tmp_path), "no folder of `nonsmooth generate`"),
    ):
        with pytest.raises(InputError, match=message):
            load_system(name)
    for name, message in (
        (f"{path}:lop", r"unknown orbit .*did you mean .*mine\.py:loop"),
        (str(path), r"is a system, not an orbit; its orbits: .*mine\.py:loop"),
        ("rigid-stop:one-impact", "unknown orbit"),
        ("rigid-stop", "unknown orbit"),
        (f"{tmp_path / 'no.py'}:loop", "there is no file"),
    ):
        with pytest.raises(InputError, match=message):
            load_orbit(name)
    for wrong in (3, None, KICKED.encode()):
        with pytest.raises(InputError, match=r"is no system|unknown system"):
            load_system(wrong)  # type: ignore[arg-type]  # that is what is refused
        with pytest.raises(InputError, match=r"is no orbit|unknown orbit"):
            load_orbit(wrong)  # type: ignore[arg-type]  # that is what is refused


@pytest.mark.parametrize(
    "damage", ["cut", "missing", "pipe", "record cut", "record foreign", "record pipe"]
)
def test_a_damaged_folder_is_refused(tmp_path, damage):
    folder = write_emitted(tmp_path / "kernels", declare(tmp_path))
    load_system(str(folder))
    emitted, record = folder / "kicked.py", folder / "PROVENANCE.json"
    if damage == "cut":
        emitted.write_text(emitted.read_text()[:-20])
    elif damage in ("missing", "pipe", "record pipe"):
        lost = record if damage == "record pipe" else emitted
        lost.unlink()
        if damage != "missing":
            os.mkfifo(lost)
    elif damage == "record cut":
        record.write_text(record.read_text()[:-20])
    else:
        record.write_text('{"systems": "kicked"}')
    message = {
        "cut": r"kicked\.py is not the file that PROVENANCE\.json records: run `nonsmooth gen",
        "missing": r"kicked\.py cannot be read: no such file or directory: run `nonsmooth gen",
        "pipe": r"kicked\.py cannot be read: it is a device or a pipe, not a file: run `nons",
    }.get(damage, "its PROVENANCE.json is missing, cut or foreign")
    with pytest.raises(InputError, match=message):
        load_system(str(folder))


# --- files and their neighbours ----------------------------------------------------------


@pytest.fixture
def importing(tmp_path):
    """Two folders whose declarations import a module of one name, which differ."""
    found = []
    for number in (1, 2):
        folder = tmp_path / str(number)
        folder.mkdir()
        (folder / "my_numbers.py").write_text(f"UPPER = {number}\n")
        text = KICKED.replace("import sympy", "import my_numbers\nimport sympy")
        found.append(declare(folder, text.replace("upper=1", "upper=my_numbers.UPPER")))
    yield found
    assert "my_numbers" not in sys.modules


def test_a_file_may_import_its_neighbours(importing):
    before = list(sys.path)
    assert [load_system(str(path)).parameters[1].upper for path in importing] == ["1", "2"]
    assert sys.path == before


def test_the_package_may_lie_below_the_folder_of_a_file(tmp_path):
    """It is imported once, though what a file imports from its folder is forgotten."""
    (tmp_path / "lib").mkdir()
    (tmp_path / "lib" / "nonsmooth").symlink_to(Path(nonsmooth.__file__).parent)
    code = (
        "import sys; from pathlib import Path\n"
        "from nonsmooth.runtime.model.loading.declared import declaration_in\n"
        "system = declaration_in(Path(sys.argv[1])).system\n"
        "from nonsmooth.derive import System\n"
        "assert type(system) is System"
    )
    environment = os.environ | {"PYTHONPATH": str(tmp_path / "lib")}
    command = [sys.executable, "-c", code, str(declare(tmp_path))]
    subprocess.run(command, env=environment, check=True, timeout=60)


def test_a_traceback_through_emitted_code_shows_its_lines(tmp_path):
    kernels = load_system(str(declare(tmp_path)))
    try:
        kernels.source("fields")(None, lib=None)
    except TypeError as problem:
        shown = "".join(traceback.format_tb(problem.__traceback__))
    assert "in fields" in shown
    assert "= parameters" in shown


# --- whose cache it is -------------------------------------------------------------------


@pytest.mark.skipif(not hasattr(os, "getuid"), reason="access is not told by modes")
@pytest.mark.parametrize("place", ["cache", ".", "cache/text"])
def test_what_others_can_write_is_not_executed(place, tmp_path, monkeypatch, capfd):
    folder = tmp_path / "home" / "cache"
    monkeypatch.setenv("NONSMOOTH_CACHE", str(folder))
    assert caching.cached("text", lambda: "ours") == "ours"
    assert folder.stat().st_mode & 0o777 == 0o700
    assert caching.cached("text", lambda: "again") == "ours"
    shared = {"cache": folder, ".": folder.parent, "cache/text": folder / "text.py"}[place]
    shared.chmod(0o722)
    assert [caching.cached("text", lambda: "again") for _ in range(2)] == ["again"] * 2
    told = capfd.readouterr().err
    if place == "cache/text":
        assert not told  # it is written again, for the user alone
        return
    assert told.count("\n") == 1
    assert f"others can write to {shared}" in told
    shared.chmod(0o700)
    assert caching.cached("text", lambda: "again") == "ours"


@pytest.mark.skipif(getattr(os, "getuid", lambda: 1)() != 0, reason="only root gives files away")
def test_a_cache_of_another_user_is_not_executed(tmp_path, monkeypatch, capfd):
    folder = tmp_path / "other"
    monkeypatch.setenv("NONSMOOTH_CACHE", str(folder))
    assert caching.cached("text", lambda: "ours") == "ours"
    os.chown(folder, 12345, -1)
    assert caching.cached("text", lambda: "again") == "again"
    assert "belongs to another user" in capfd.readouterr().err


def test_a_folder_in_one_that_all_may_use_is_the_users_own(tmp_path, monkeypatch):
    tmp_path.chmod(0o1777)  # as /tmp is
    monkeypatch.setenv("NONSMOOTH_CACHE", str(tmp_path / "mine"))
    assert caching.cached("text", lambda: "ours") == "ours"
    assert caching.cached("text", lambda: "again") == "ours"


def test_memory_does_not_grow_with_what_was_loaded():
    """Of all systems but the last four a packed text is kept, which is shorter than the text."""
    text = "VALUE = {0}\n" + "".join(f"def f{i}(x):\n    return x * {i}\n" for i in range(30))
    known, lines, modules = caching.Modules(4), len(linecache.cache), []
    for number in range(32):
        known.add(str(number), text.replace("{0}", str(number)), f"<m{number}>")
        modules.append(weakref.ref(known[str(number)]))
        assert number == known[str(number)].VALUE
    gc.collect()
    assert [number for number, module in enumerate(modules) if module()] == [28, 29, 30, 31]
    assert len(linecache.cache) <= lines + 4
    assert _bytes_of_texts(known) < 32 * len(text) // 2
    assert [known[str(i)].VALUE for i in range(32)] == list(range(32))


def _bytes_of_texts(known):
    """Bytes of all texts that are reached from the known modules, but through these themselves."""
    seen = {}
    pending = [vars(known)]
    while pending:
        found = pending.pop()
        if id(found) not in seen and not isinstance(found, (ModuleType, FunctionType, type)):
            seen[id(found)] = found
            pending += gc.get_referents(found)
    return sum(sys.getsizeof(text) for text in seen.values() if isinstance(text, str | bytes))


def test_what_is_packed_solves_and_tells_its_lines(tmp_path, monkeypatch):
    monkeypatch.setattr(loading, "_MODULES", caching.Modules(1))
    one, other = (read(declare(tmp_path, text, f"{k}.py")).system
                  for k, text in (("one", KICKED), ("other", DAMPED)))  # fmt: skip
    name = load_system(one).name
    assert load_system(other).name != name
    again = load_system(name)
    assert again.name == name
    assert linecache.getlines(f"<{name}>")


def test_the_cache_is_bounded(tmp_path, monkeypatch):
    """What was not used for longest goes; what is not the cache's stays."""
    monkeypatch.setenv("NONSMOOTH_CACHE", str(tmp_path))
    monkeypatch.setattr(caching, "MOST_BYTES", 3000)
    foreign = tmp_path / "foreign.py"
    foreign.write_text(5000 * "#")
    keys = [f"{place:064x}" for place in range(5)]
    for place, key in enumerate(keys[:3]):
        caching.cached(key, lambda: 700 * "#")
        os.utime(tmp_path / f"{key}.py", (place, place))
    keys[3] += "-avx2"
    caching.store_library(keys[3], "_kernels.abi3.so", 100 * b"-")
    assert caching.stored(keys[0]) is not None  # is used: the next is the oldest
    caching.cached(keys[4], lambda: 1000 * "#")
    kept = [key for key in keys if caching.stored(key) or caching.stored_library(key)]
    assert kept == [keys[0], *keys[2:]]
    assert foreign.is_file()


def test_what_killed_processes_left_counts_and_goes(tmp_path, monkeypatch):
    monkeypatch.setenv("NONSMOOTH_CACHE", str(tmp_path))
    monkeypatch.setattr(caching, "MOST_BYTES", 10_000)
    file, folder = tmp_path / ".12ab.partial", tmp_path / "12ab-7.partial"
    file.write_text(9000 * "#")
    folder.mkdir(mode=0o700)
    (folder / "kernels.c").write_text(900 * "#")
    caching.cached(f"{1:064x}", lambda: 700 * "#")
    assert caching.stored(f"{1:064x}") is None  # there is no room for it
    for left in (file, folder):
        os.utime(left, (0, 0))
    caching.cached(f"{2:064x}", lambda: 700 * "#")
    assert [path.name for path in tmp_path.iterdir()] == [f"{2:064x}.py"]


def test_two_processes_remove_the_same(tmp_path, monkeypatch):
    monkeypatch.setenv("NONSMOOTH_CACHE", str(tmp_path))
    keys = [f"{place:064x}" for place in range(2)]
    caching.cached(keys[0], lambda: "first")
    monkeypatch.setattr(caching, "MOST_BYTES", 100)
    unlink = Path.unlink

    def twice(path, missing_ok=False):
        unlink(path, missing_ok)
        unlink(path, missing_ok)

    monkeypatch.setattr(Path, "unlink", twice)
    assert caching.cached(keys[1], lambda: "second") == "second"
    assert [*map(caching.stored, keys)] == [None, "second"]
