"""Files of results hold their system as data: nothing that they name is ever run."""

import json
from hashlib import sha256

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.runtime.core.result_files import checksum_of
from tests.cli.test_cli import run, told
from tests.counting import calls_of
from tests.present.test_saved import put, refusal, sealed
from tests.user_systems import declare

# a square root, a quotient, a fraction, restitution, an irrational end of a domain
SYSTEM = """
import sympy as sp
from nonsmooth.derive import Harmonic, Itinerary, Parameter, Reference, RigidStop, oscillator

w = Parameter("w", "frequency, rad/s", upper=2 * sp.pi)
k = Parameter("k", "stiffness, N/m")
gap = Parameter("gap", "place of the stop, m", lower=-sp.oo)
r = Parameter("r", "restitution, 1", lower=0, upper=1, closed=True, upper_closed=True)
system = oscillator(
    "struck", ["x"], mass=[[1]], stiffness=[[k.symbol]], damping=[[sp.sqrt(k.symbol) / 10]],
    forcing=[Harmonic(w.symbol, cosine=[1])], parameters=[w, k, gap, r],
    elements=[RigidStop("x", at=gap.symbol, restitution=r.symbol, name="stop")],
)
data = Reference({"w": "2", "k": "1", "gap": "0", "r": "0.8"}, {"T": "3.1"})
orbits = [Itinerary("one", system, [("free", "stop-reaches-stop", "T")], reference=data)]
"""
PLAIN = SYSTEM.replace("sp.sqrt(k.symbol) / 10", "k.symbol / 10")  # for proofs of boxes
DATA = {"w": "2", "k": "1", "gap": "0", "r": "0.8"}
TRAP = "from pathlib import Path\nPath(__file__).with_name('ran').touch()\n"


START = {"x": -1, "v": 0}


def solved(source, *arguments, **options):
    return ns.solve(f"{source}:one", *arguments, **options)


def motion(source):
    return ns.simulate(source, DATA, START, transitions=5)


def sweep(source):
    values = {n: v for n, v in DATA.items() if n != "w"}
    options = {"state": "x", "phase": 0, "transient": 20, "samples": 4}
    return ns.sweep(source, values, "w", [1.9, 2.0], START, **options)


def branch(source):
    return ns.continue_orbit(solved(source), "w", (1.98, 2.01))


def fit(source):
    times = np.linspace(0.1, motion(source).end, 20)
    data, start = {"t": times, "x": motion(source)(times)[:, 0]}, START | {"x": -1.01}
    return ns.fit(source, data, parameters=DATA, free=["x0"], start=start, sigma=1e-3)


def event(source):
    found = ns.continue_orbit(solved(source, {"gap": "-0.332"}), "gap", (-0.335, -0.33))
    return ns.certify.event(found, found.events[-1])


MAKE = {
    "orbit.json": solved,
    "sharp.json": lambda source: solved(source, digits=40),
    "found.json": lambda source: ns.find_orbits(source, DATA, 5, transitions=50, rng=1),
    "motion.npz": motion,
    "motion.csv": motion,
    "branch.json": branch,
    "sweep.json": sweep,
    "fit.json": fit,
}
PROVE = {  # of what takes no root
    "proof.json": lambda source: ns.certify(solved(source)),
    "map.json": lambda source: ns.certify.box(solved(source), {"r": ("0.799", "0.801")}, tiles=2),
    "events.json": event,
    "census.json": lambda source: ns.certify.all(f"{source}:one", DATA, {"T": ("3.1", "3.2")}),
}
COMMANDS = (
    "list orbit.json found.json",
    "plot orbit.json --kind time --out a.png",
    "plot found.json --kind time --out a.png",
    "plot motion.npz --kind time --out a.png",
    "plot motion.csv --kind time --out a.png",
    "plot branch.json --out a.png",
    "plot sweep.json --out a.png",
    "plot fit.json --out a.png",
    "plot map.json --out a.png",
    "solve orbit.json --digits 30",
    "solve found.json:1",
    "verify orbit.json --digits 20",
    "continue orbit.json w=1.99:2.01",
    "certify orbit.json",
    "certify check proof.json",
    "certify check map.json",
    "certify check events.json",
    "certify check census.json",
    "chart orbit.json w=1.99:2.01:3 --out c.zarr",
    "plot c.zarr --out a.png",
    "chart orbit.json w=1.99:2.01:3 --out c.zarr",
    "chart own.zarr",
    "chart found.zarr",
    "chart motions.zarr",
    "plot own.zarr --out a.png",
)


@pytest.fixture(scope="module", autouse=True)
def uncompiled():
    """Kernels run on NumPy, whose compilation would take longer than all that is done here."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("CC", "none")
        yield


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Files of all kinds, whose declaration was replaced by one that leaves a trace."""
    folder = tmp_path_factory.mktemp("systems")
    source = folder / "own.py"
    for text, made in ((PLAIN, PROVE), (SYSTEM, MAKE)):
        source.write_text(text)
        for name, make in made.items():
            make(source).save(folder / name)
    frequency = [1.99, 2.0]
    ns.chart(f"{source}:one", w=frequency, store=folder / "own.zarr")
    ns.chart(f"{folder / 'orbit.json'}", w=frequency, store=folder / "found.zarr")
    rest = {name: value for name, value in DATA.items() if name != "w"}
    ns.chart(
        str(source), simulate=True, start=START, transitions=80, w=frequency, **rest,
        store=folder / "motions.zarr",
    )  # fmt: skip
    source.write_text(TRAP + SYSTEM)
    return folder


@pytest.fixture(autouse=True)
def nothing_runs(folder, monkeypatch):
    monkeypatch.chdir(folder)
    yield
    assert not (folder / "ran").exists()


def content(path):
    return json.loads(path.read_text())


@pytest.mark.parametrize("name", ["own", "found", "motions"])
def test_a_chart_goes_on_to_the_same_bits(name, folder):
    place = folder / f"{name}.zarr"
    before = {f: f.read_bytes() for f in place.rglob("*") if f.is_file()}
    (place / "period" / "c" / "0").unlink()
    ns.chart(str(place))
    assert {f: f.read_bytes() for f in place.rglob("*") if f.is_file()} == before


def test_what_a_file_lists_can_be_typed(folder):
    """An orbit with kernels of its own, and one that is composed."""
    source = declare(folder, name="kicked.py")
    ns.solve(f"{source}:loop").save(folder / "kicked.json")
    ns.solve("dry-friction/symmetric").save(folder / "built-in.json")
    source.unlink()
    for name in ("kicked.json", "built-in.json", "orbit.json", "found.json"):
        (system,) = told("list", name)["systems"]
        assert "@" not in system["name"]
        for orbit in system["orbits"]:
            assert run("solve", orbit["name"]).code == 0


def test_the_order_of_configurations_counts(folder):
    """Fields stand in their order, which a tool that sorts the entries changes."""
    source = declare(folder, name="kicked.py")
    options = {"state": "v", "configuration": "right", "transient": 20, "samples": 4}
    diagram = ns.sweep(source, {"r": "0.5"}, "k", [1.0, 1.1], {"x": 0, "v": 1}, **options)
    diagram.save(folder / "kicked.json")
    sorted_ones = json.dumps(content(folder / "kicked.json"), sort_keys=True)
    (folder / "sorted.json").write_text(sorted_ones)
    with pytest.raises(InputError, match="and the file holds"):
        ns.load(folder / "sorted.json")


@pytest.mark.parametrize("command", COMMANDS)
def test_no_command_runs_what_a_file_names(command):
    # what takes a root of its parameters is not proved to be stable
    code = 1 if command == "certify orbit.json" else 0
    assert run(*command.split()).code == code


@pytest.mark.parametrize("name", [name for name in (*MAKE, *PROVE) if name.endswith(".json")])
def test_a_forged_name_runs_nothing(name, folder):
    forged = folder / "forged.json"
    text = (folder / name).read_text()
    (system,) = {entry["system"] for entry in _with("system", json.loads(text))} or {"none"}
    for tables in (True, False):
        changed = json.loads(text.replace(system, str(folder / "own.py")))
        for entry in _with("tables", changed) if not tables else ():
            entry["tables"] = None
        for entry in _with("sha256", changed):
            entry["sha256"] = checksum_of(entry)
        forged.write_text(json.dumps(changed))
        refusal(forged)
        assert run("plot", "forged.json", "--out", "a.png").code == 2


def _with(name, entries):
    """The objects that have an entry, those inside others first."""
    parts = entries.values() if isinstance(entries, dict) else entries
    found = [e for part in parts if isinstance(part, dict | list) for e in _with(name, part)]
    return [*found, entries] if isinstance(entries, dict) and name in entries else found


def renamed(content, change):
    """A content with other data, whose name is made right again."""
    found = json.loads(json.dumps(content))
    change(found["tables"])
    data = json.dumps({n: entry for n, entry in found["tables"].items() if n != "derivation"})
    name = content["system"].partition("@")[0]
    fitting = f"{name}@{sha256(data.encode()).hexdigest()[:16]}"
    return json.loads(json.dumps(found).replace(content["system"], fitting))


EMPTY = {n: [] for n in ("takes", "inputs", "outputs", "names", "since", "terms", "gives")}
WRONG = {
    "table/boundary_rows/free/0": (-1, 10**6),
    "table/forcing_row": (99,),
    "table/transitions/0/reset": (-1, 99),
    "table/transitions/0/source": ("nowhere",),
    "table/transitions/0/target": ("nowhere",),
    "table/transitions/0/boundaries": (["nowhere"],),
    "table/transitions/0/order": (-1, 10**9),
    "table/configurations/free": ([], 7, [{"name": "x", "acts_when": "never"}]),
    "table/states": ([], ["x", "x", "c1", "s1"], ["x", "v", "c1", "s1", "y"]),
    "table/parameters/0/lower": ("10**10**10", "__import__('os')", "nan"),
    "table/parameters/0/name": ("k", "sqrt"),
    "table/constraints": ([{"text": "", "terms": {"k**999999999": 1}}],),
    "table/held": ({},),
    "table/forcing": ([["x", "nowhere"]],),
    "table/name": ("", "../own.py", "a\nb"),
    "table/modes": ({}, {"free": [{"length": 10**9, "oscillates": True}]}),
    "functions/__name__": (EMPTY,),
    "functions/SYSTEM": (EMPTY,),
    "functions": ({},),
    "functions/rows/gives/0": ("0, 0, 0, 0, exec(w)", "0", "10**10**10, 0, 0, 0, 0"),
    "functions/rows/outputs/0": ([1, 5], [10**9, 5], [0, 5]),
    "functions/fields/inputs/0": ([3],),
    "functions/fields/since": ([1], []),
    "functions/fields/names": ([],),
    "orbits/one": ({"phases": [["nowhere", "b", "T"]]}, {}),
}


@pytest.mark.parametrize("where", WRONG)
def test_data_that_are_not_in_order_are_refused_at_small_cost(where, folder):
    sound, wrong = content(folder / "orbit.json"), folder / "wrong.json"
    assert renamed(sound, lambda tables: None)["system"] == sound["system"]
    most = 2 * calls_of(lambda: ns.load(folder / "orbit.json"))
    for entry in WRONG[where]:
        sealed(wrong, renamed(sound, put(where, entry)))
        assert calls_of(lambda: refusal(wrong)) < most


@pytest.fixture(scope="module")
def kicked(tmp_path_factory):
    """The file of an orbit with kernels of its own."""
    folder = tmp_path_factory.mktemp("kicked")
    ns.solve(f"{declare(folder)}:loop").save(folder / "kicked.json")
    return content(folder / "kicked.json")


def exchanged(function):
    function["names"][:2] = function["names"][1::-1]


def longer(function):
    """One more number of the last argument, which nothing needs."""
    function["inputs"][-1] = [len(function["takes"][-1].split()) + 1]
    function["takes"][-1] += " more"


def higher(function):
    """One more entry of the last result."""
    shape = function["outputs"][-1]
    function["gives"].append(", ".join("0" * shape[-1]) if len(shape) == 2 else "0")
    if len(shape) == 2:
        shape[0] += 1
    else:
        function["outputs"][-1] = [shape[0] + 1] if shape else [2]
        function["gives"][-2:] = [", ".join(function["gives"][-2:])]


def sooner(function):
    function["since"] = [0] * len(function["since"])


@pytest.mark.parametrize("change", [exchanged, longer, higher, sooner])
def test_functions_of_an_orbit_have_the_names_and_shapes_of_its_table(change, kicked, folder):
    wrong, seen = folder / "wrong.json", 0
    functions = kicked["tables"]["functions"]
    assert {"loop_equations", "loop_trace", "loop_passage", "loop_reduced"} <= functions.keys()
    for name in functions.keys() - {"fields", "rows", "resets"}:
        changed = json.loads(json.dumps(functions[name]))
        change(changed)
        if changed == functions[name]:
            continue
        sealed(wrong, renamed(kicked, put(f"functions/{name}", changed)))
        assert f"what '{name}' takes or gives is not of" in refusal(wrong)
        seen += 1
    assert seen > 1


@pytest.mark.parametrize("name", ["loop_equations", "loop_reduced", "spectrum"])
def test_a_function_that_an_orbit_needs_is_missed(name, kicked, folder):
    less = renamed(kicked, lambda tables: tables["functions"].pop(name))
    told = refusal(sealed(folder / "wrong.json", less))
    assert f"'{name}' is missing among the functions" in told


def test_a_system_comes_back_to_the_last_bit(folder):
    source = folder / "again.py"
    source.write_text(SYSTEM)
    solved(source).save(folder / "again.json")
    given = solved(source).problem.system
    back = ns.load(folder / "again.json").problem.system
    drawn = np.random.default_rng(1).uniform(0.1, 1, (20, 4))
    for kernel in ("fields", "rows", "resets"):
        assert (back.evaluate(kernel, drawn) == given.evaluate(kernel, drawn)).all()
    assert [p.ends for p in back.parameters] == [p.ends for p in given.parameters]


def test_a_change_of_the_declaration_is_told_where_it_is_named(folder):
    source = folder / "changed.py"
    source.write_text(SYSTEM)
    known, diagram = branch(source), sweep(source)
    known.save("changed-branch.json")
    diagram.save("changed-sweep.json")
    source.write_text(PLAIN)
    ns.certify(solved(source)).save("changed-proof.json")
    same = "certify check changed-proof.json changed.py:one"
    assert run(*same.split()).code == 0
    source.write_text(PLAIN.replace("/ 10", "/ 11"))
    resumed = (
        "sweep changed.py w=1.9:2.0:2 k=1 gap=0 r=0.8 --quantity x --at forcing-phase=0"
        " --from x=-1,v=0 --transient 20 --samples 4 --resume changed-sweep.json"
    )
    followed = "continue changed.py:one w=1.98:2.01 --resume changed-branch.json"
    for command in (same, followed, resumed):
        code, _, err = run(*command.split())
        assert code in (1, 2), command
        assert "changed" in err.replace("changed-", "").replace("changed.py", ""), command
    assert ns.load("changed-branch.json").orbit.converged


def test_an_orbit_with_kernels_of_its_own_comes_back_with_them(folder):
    declare(folder, name="kicked.py")
    assert run("generate", "kicked.py", "--out", "kicked").code == 0
    given = ns.solve("kicked:loop", digits=30)
    assert given.problem.kernels is not None
    given.save("kernels.json")
    (folder / "kicked").rename(folder / "elsewhere")
    found = ns.load("kernels.json")
    assert found.unknowns == given.unknowns
    assert found.to_json()["unknowns"] == given.to_json()["unknowns"]
    assert found.stability.verdict == given.stability.verdict
    assert found.motion()(0.5).tolist() == given.motion()(0.5).tolist()
    assert ns.refine(found, 50).digits == 50
    assert ns.certify(found).proved
    followed = ns.continue_orbit(ns.solve("kernels.json"), "r", (0.4, 0.6))
    assert followed.ends == ("end of the interval",) * 2
    forged = {**content(folder / "kernels.json"), "orbit": "other"}
    assert "unknown orbit" in refusal(sealed(folder / "forged.json", forged))


def test_what_is_saved_is_the_system_that_was_computed_with(folder):
    source = folder / "lost.py"
    source.write_text(PLAIN)
    orbit, proof = solved(source), ns.certify(solved(source))
    moved, diagram = motion(source), sweep(source)
    source.write_text(TRAP + PLAIN.replace("/ 10", "/ 11"))
    for result in (orbit, proof, diagram):
        result.save("lost.json")
    assert ns.load("lost.json").values.tolist() == diagram.values.tolist()
    proof.save("lost.json")
    assert ns.certify.check("lost.json").difference is None
    moved.save("lost.npz")
    assert ns.load("lost.npz").times.tolist() == moved.times.tolist()
    source.unlink()
    proof.save("gone.json")
    assert (folder / "gone.json").read_bytes() == (folder / "lost.json").read_bytes()


def _first_exponents(entry):
    """Exponents of the first term of the first polynomial in a declaration."""
    if isinstance(entry, dict) and "above" in entry:
        return entry["above"][0][1]
    parts = entry.values() if isinstance(entry, dict) else entry
    for part in parts if isinstance(parts, list) or isinstance(entry, dict) else ():
        if isinstance(part, dict | list) and (exponents := _first_exponents(part)):
            return exponents
    return []


def _huge_declaration(content):
    found = json.loads(json.dumps(content))
    _first_exponents(found["declaration"])[0] = 10**30
    return found


HUGE = (
    _huge_declaration,
    lambda content: renamed(content, put("functions/rows/terms/0", f"_1 = k**{10**30}")),
    lambda content: renamed(content, put("functions/rows/terms/0", f"_1 = 10**{10**30}")),
    lambda content: renamed(content, put("table/parameters/0/upper", "2**" + "9" * 30)),
)


@pytest.mark.parametrize("change", HUGE)
@pytest.mark.parametrize("command", ["plot huge.json", "certify check huge.json"])
def test_huge_exponents_in_a_map_are_refused(command, change, folder):
    sealed(folder / "huge.json", change(content(folder / "map.json")))
    code, out, err = run(*command.split())  # without a bound it would never end
    assert code == (1 if "check" in command else 2)
    assert (err or out).count("\n") == 1
    assert "internal error" not in err


def test_no_map_is_replaced_by_that_of_another_orbit(folder):
    """Not by one of which nothing can be proved either: this one takes a root."""
    before = (folder / "map.json").read_bytes()
    command = "certify box orbit.json r=0.799:0.801 --resume map.json"
    code, _, err = run(*command.split())
    assert code == 2
    assert "the state to resume has another" in err
    assert (folder / "map.json").read_bytes() == before
