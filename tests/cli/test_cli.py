"""The command line: answers, JSON, exit codes, and one clear line for wrong input."""

import json
import math
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from decimal import Decimal, localcontext
from functools import cache
from pathlib import Path

import pytest
from typer.main import get_command
from typer.testing import CliRunner

import nonsmooth
from nonsmooth.derive.codegen import regenerate as generation
from nonsmooth.runtime.cli.application import print_json
from nonsmooth.runtime.cli.program import app
from nonsmooth.runtime.model.kernels import load_orbit, orbit_names
from tests.cli.terminal import Ended, all_commands
from tests.places import CHECKOUT, GALLERY
from tests.user_systems import declare

ORBIT = "dry-friction/global-stick"
GRAZING = ("rigid-stop/one-impact", "m1=1", "m2=2", "k1=2", "k2=4", "T=pi")
PROGRAM = (sys.executable, "-m", "nonsmooth")
GROUP = get_command(app)
COMMANDS = all_commands()
EXAMPLES = [
    line
    for command in COMMANDS.values()
    for line in command.epilog.splitlines()
    if line.startswith("nonsmooth ")
]


def run(*arguments):
    """Run a command in this process."""
    result = CliRunner().invoke(app, list(arguments))
    if result.exception is not None and not isinstance(result.exception, SystemExit):
        raise result.exception
    return Ended(result.exit_code, result.stdout, result.stderr)


def run_process(*command, **environment):
    """Run a command as a process of its own, its output piped."""
    unwanted = ("COLUMNS", "FORCE_COLOR", "GITHUB_ACTIONS", "NO_COLOR", "PY_COLORS")
    inherited = {name: text for name, text in os.environ.items() if name not in unwanted}
    return subprocess.run(
        command,
        env=inherited | environment,
        capture_output=True,
        text=True,
        encoding="utf-8",
        check=False,
    )


def nonsmooth_process(*arguments, **environment):
    return run_process(*PROGRAM, *arguments, **environment)


def told(*arguments, code=0):
    """Give the one JSON document on stdout; nothing else may be there."""
    found, out, err = run(*arguments, "--json")
    assert found == code, err
    return json.loads(out, parse_constant=no_json)


def no_json(constant):
    """What is not known is null for every reader."""
    raise AssertionError(f"{constant} is no JSON")


def answered(*arguments):
    """Give what a command prints that ends well, with nothing on stderr."""
    code, out, err = run(*arguments)
    assert (code, err) == (0, "")
    return out


def refused(*arguments, code=2):
    """Give the one line on stderr; nothing is answered."""
    ended = run(*arguments)
    (line,) = ended.err.splitlines()
    assert ended == (code, "", f"{line}\n")
    assert line.startswith("nonsmooth: " + "error: " * (code == 2))
    assert len(line) < 1500
    return line


def refused_alike(*arguments, code=2):
    """Give that line, which is the same in JSON."""
    line = refused(*arguments, code=code)
    error = told(*arguments, code=code)["error"]
    assert line == "nonsmooth: " + "error: " * (code == 2) + error
    return line


def test_what_is_not_known_is_printed_as_null(capsys):
    print_json({"trace": "nan", "rates": [math.nan, math.inf, 0.5, {"name": "nan"}]})
    found = json.loads(capsys.readouterr().out, parse_constant=no_json)
    assert found == {"trace": None, "rates": [None, "inf", 0.5, {"name": None}]}


# --- help


def test_help_lists_each_command_once_below_what_it_is_for():
    listed = GROUP.list_commands(None)
    assert sorted(listed) == sorted(GROUP.commands)
    certify = GROUP.commands["certify"]
    assert sorted(certify.list_commands(None)) == sorted(certify.commands)
    purposes = [GROUP.commands[name].rich_help_panel for name in listed]
    assert all(purposes)
    text = run_process(sys.executable, "-m", "nonsmooth", "--help").stdout
    assert [line.split("\u2500")[1].strip() for line in text.splitlines() if line[:1] == "\u256d"][
        1:
    ] == [*dict.fromkeys(purposes)]


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_has_help_with_examples_and_json(name):
    out = answered(*name.split(), "--help")
    assert "--json" in out
    shown = [line for line in COMMANDS[name].epilog.splitlines() if line.startswith("nonsmooth ")]
    assert shown
    for example in shown:
        assert example.removeprefix("nonsmooth ").startswith(name.removesuffix(" orbit"))
        assert example in " ".join(out.split())


def test_the_command_line_stays_small_and_every_option_is_explained():
    """Options are as many as flags that mean different things, those of all commands included."""
    options = {
        (flag, option.help, option.metavar)
        for command in (GROUP, *COMMANDS.values())
        for option in command.params
        for flag in option.opts
        if flag.startswith("--")
    }
    assert len(GROUP.commands) <= 17
    assert len(options) <= 110
    assert all(told for _, told, _ in options)


@cache
def _found_in_page():
    """The own oscillator of the page of commands, and the orbits that are found in it."""
    page = (CHECKOUT / "docs/how_to/commands.md").read_text(encoding="utf-8")
    blocks = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    declared = next(block for block in blocks if "# my_oscillator.py" in block)
    with tempfile.TemporaryDirectory() as folder:
        file, kept = Path(folder) / "my_oscillator.py", Path(folder) / "found.json"
        file.write_text(declared)
        data = {"zeta": "0.05", "Omega": "2.6", "gap": 0, "r": "0.8"}
        nonsmooth.find_orbits(str(file), data, 20).save(kept)
        return {path.name: path.read_bytes() for path in (file, kept)}


def engine_needed(example):
    """Thousands of motions or orbits, which take minutes in Python."""
    slow = "nonsmooth chart", "nonsmooth find", "nonsmooth sweep"
    slow = *slow, "nonsmooth certify chaos", "nonsmooth certify region"
    return example.startswith(slow) or "found.json" in example


# less of the same: points of a range, starts, boxes, and of a range what is next to a flip
FEWER = {
    r"(certify doubling \S+) V=1:1.2": r"\1 V=1.07:1.09 --tiles 1",
    r"(certify box \S+) V=0.9:1.1 eta=0.9:1.1": r"\1 V=0.99:1.01 eta=0.99:1.01",
    r"(=[^ :]+:[^ :]+):\d\d+\b": r"\1:3",
    "--starts 800": "--starts 8",
    "--boxes 64 --levels 3": "--boxes 8 --levels 1",
}


def with_fewer(command):
    """A command that asks for less of the same."""
    for many, few in FEWER.items():
        command = re.sub(many, few, command)
    return command


# examples of these take many seconds in C too
LONG = "certify chaos", "certify basin", "certify region", "certify all", "found.json", "map.json"
LONG = *LONG, "--worst-over", "--responses", "--compile", "nonsmooth find", "--over energy"
LONG = *LONG, "A.zarr", "--format", "forcing-phase", "--subject", "--switch"


def marks_of(example):
    """What of an example takes minutes in Python, and what takes long in C too."""
    long = [pytest.mark.slow] if any(words in example for words in LONG) else []
    return [*long, pytest.mark.compiled] if engine_needed(example) else long


# what these prove is also checked, in test_certify_command.py
PROVING = tuple(f"nonsmooth certify {name} " for name in ("box", "branch", "doubling"))
OTHERS = [example for example in EXAMPLES if not example.startswith(PROVING)]


@pytest.mark.parametrize("example", [pytest.param(e, marks=marks_of(e)) for e in OTHERS])
@pytest.mark.usefixtures("empty_reproduction", "fewer_looks", "given_chaos")
def test_examples_work(
    example, tmp_path, monkeypatch,
    committed_derivation,
):  # fmt: skip
    monkeypatch.chdir(tmp_path)
    if example.startswith("nonsmooth plot"):
        pytest.importorskip("matplotlib")
        nonsmooth.solve(ORBIT).save("orbit.json")
        data = {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "r": 1}
        nonsmooth.simulate("rigid-stop", data, [0, 0, 1, 0], transitions=4).save("motion.npz")
        if "branch.json" in example:
            orbit = nonsmooth.solve("rigid-stop/one-impact")
            nonsmooth.continue_orbit(orbit, "k2", (4, 6)).save("branch.json")
        if "F.zarr" in example:
            nonsmooth.chart(ORBIT, V=[0.9, 1.0, 1.1], eta=[0.9, 1.0], store="F.zarr")
    if "pdf" in example:
        (tmp_path / "pdflatex").write_text("#!/bin/sh\n/bin/cp document.tex document.pdf\n")
        (tmp_path / "pdflatex").chmod(0o755)
        monkeypatch.setenv("PATH", str(tmp_path))
    if "found.json" in example and "--save found.json" not in example:
        for name, content in _found_in_page().items():
            (tmp_path / name).write_bytes(content)
    if "check certificate.json" in example:
        orbit = ORBIT
        if "my_oscillator.py" in example:
            declare(tmp_path, name="my_oscillator.py")
            orbit = "my_oscillator.py:loop"
        nonsmooth.certify(nonsmooth.solve(orbit)).save("certificate.json")
    gallery = CHECKOUT / "docs" / "gallery"
    shown = [name for name in re.findall(r"\w+\.(?:py|csv)", example) if (gallery / name).exists()]
    if shown:
        for name in shown:
            shutil.copy(gallery / name, tmp_path)
        monkeypatch.setenv("NONSMOOTH_CACHE", "")
    elif "my_oscillator.py" in example:
        if "--compile" in example and shutil.which("cc") is None:
            pytest.skip("no C compiler")
        monkeypatch.setenv("CFLAGS", "-O0")  # to optimise takes most of the time
        monkeypatch.setenv("NONSMOOTH_CACHE", "")
        declare(tmp_path, name="my_oscillator.py")
        if "--check" in example:
            run("generate", "my_oscillator.py", "--out", "my_kernels")
    elif "--check" in example:
        for file, text in committed_derivation.items():
            (tmp_path / file).write_text(text, encoding="utf-8")
        monkeypatch.setattr(generation, "find_generated", lambda writing=True: tmp_path)
    assert answered(*shlex.split(with_fewer(example))[1:])


# --- list, solve, verify


def test_list():
    systems = {system["name"]: system for system in told("list")["systems"]}
    assert list(systems) == ["rigid-stop", "elastic-stop", "dry-friction"]
    orbits = {orbit["name"]: orbit for s in systems.values() for orbit in s["orbits"]}
    assert tuple(orbits) == orbit_names()
    out = answered("list")
    for word in (*orbits, "0 < chi < 1", "0 <= e1", "3.0195", "stick-stick", "0 <= r <= 1", "k3"):
        assert word in out


@pytest.mark.parametrize("name", orbit_names())
def test_every_orbit_is_solved_verified_and_shown(name):
    found, verified = told("solve", name), told("verify", name, "--digits", "15")
    proof = verified.pop("proof")
    assert verified.pop("arithmetic") == "flint"
    assert found == verified
    middle, radius = (Decimal(proof["trace"][part]) for part in ("mid", "rad"))
    assert abs(Decimal(found["trace"]) - middle) <= radius + Decimal("1e-16")
    if found["stability"] in ("stable", "neutral"):
        assert proof["verdict"] == "proved"
    assert found["orbit"] == name
    assert list(found["unknowns"]) == list(load_orbit(name).unknowns)
    assert list(found["parameters"]) == [
        *load_orbit(name).parameter_names,
        *load_orbit(name).required,
    ]
    assert len(found["multipliers"]) == len(load_orbit(name).table["section"])
    assert found["stability"] in ("stable", "neutral", "unstable")
    for command in ("solve", "verify"):
        out = answered(command, name, "--digits", "15")
        assert max(map(len, out.splitlines())) <= 80
        for number in (found["trace"], found["period"], *found["unknowns"].values()):
            assert number in out.split()


def test_json_of_a_border_collision():
    found = told("solve", "dry-friction/solution-ii")
    assert found["one_sided"] == "ta > 0"
    (coincidence,) = found["coincidences"]
    assert coincidence["phase"] == 1
    assert coincidence["boundaries"] == ["second-reaches-belt", "first-breaks-forward"]
    assert float(coincidence["time"]) == pytest.approx(float(found["period"]))
    assert "one_sided" not in told("solve", ORBIT)
    assert "coincidences" not in told("solve", ORBIT)
    assert "ta > 0" in answered("solve", "dry-friction/solution-ii")


def test_parameters_are_exact():
    found = told("solve", ORBIT, "chi=1/3", "us2=0.8", "ur2=1.3", "--digits", "40")
    with localcontext(prec=60):
        assert abs(Decimal(found["parameters"]["chi"]) * 3 - 1) < Decimal("1e-40")
    assert {n: Decimal(found["parameters"][n]) for n in ("us2", "ur2", "e2")} == {
        "us2": Decimal("0.8"),
        "ur2": Decimal("1.3"),
        "e2": Decimal("0.5"),
    }


def test_a_guess_may_name_some_unknowns():
    plain = told("solve", ORBIT)
    assert told("solve", ORBIT, "--guess", "tau=2,tau1=1.5")["unknowns"] == plain["unknowns"]
    assert told("solve", ORBIT, "--guess", "tau=2", "--guess", "tau1=1.5") == told(
        "solve", ORBIT, "--guess", "tau = 2, tau1 = 3/2"
    )


def test_report_of_verify():
    out = answered("verify", ORBIT)
    found = told("verify", ORBIT)
    numbers = (found["trace"], f"-{found['margin']}", found["period"], *found["unknowns"].values())
    for number in numbers:
        assert number in out.split()
    assert "conditionally stable (|trace| < 1)" in out
    assert "0 exactly: the Poincare map has rank one" in out
    assert "us2 > 0.7228" in out
    assert out.index("Trace criterion") < out.index("Orbit")
    assert max(map(len, out.splitlines())) <= 80


def test_both_arithmetics_are_compared():
    asked = ("verify", ORBIT, "--arithmetic", "both", "--digits", "40")
    out, found = answered(*asked), told(*asked)
    assert 0 < Decimal(found["difference"]) < Decimal("1e-40")
    both = rf"difference +{found['difference']} between balls and mpmath, of unknowns and trace"
    assert re.search(both, out)
    assert found["compared"] == ["unknowns", "trace"]
    assert re.search(r"proved +\|trace\| < 1 *\n", out)
    assert "difference" not in told("verify", ORBIT, "--arithmetic", "mpmath")


def test_traces_without_a_finite_enclosure_are_not_compared_and_it_is_said():
    """At a grazing they have ten digits in common, where the unknowns have seventy."""
    found, by_mpmath = (
        told("verify", *GRAZING, "--arithmetic", arithmetic, code=1)
        for arithmetic in ("both", "mpmath")
    )
    assert found["compared"] == ["unknowns"]
    assert abs(Decimal(found["trace"]) - Decimal(by_mpmath["trace"])) > Decimal("1e-20")
    assert Decimal(found["difference"]) < Decimal("1e-50")
    out = run("verify", *GRAZING, "--arithmetic", "both")[1]
    assert re.search(r"between balls and mpmath, of unknowns *\n", out)


def test_what_is_proved_at_a_border_collision_is_about_one_side():
    name = "dry-friction/solution-ii"
    assert "on one side of a border collision" in run("verify", name)[1]
    assert "on one side" not in run("verify", ORBIT)[1]


def test_the_rank_of_an_orbit_by_tables_is_no_criterion():
    _, out, _ = run("solve", f"{GALLERY / 'impact_oscillator.py'}:one-period", "r=0")
    assert "Stability" in out
    assert "|trace| < 1" not in out
    assert re.search("multiplier 2 +0 to these digits: the Poincare map has rank one", out)


def test_orbits_by_tables_are_enclosed_and_refined_by_mpmath():
    name = f"{GALLERY / 'impact_damper.py'}:struck-twice"
    found = told("verify", name)
    assert found["arithmetic"] == "mpmath"
    middle, radius = (Decimal(found["proof"]["trace"][part]) for part in ("mid", "rad"))
    with localcontext(prec=70):
        assert abs(Decimal(found["trace"]) - middle) < radius + Decimal("1e-52")
    assert "has no kernels of its own" in refused("verify", name, "--arithmetic", "both")


def test_report_of_solve():
    out = answered("solve", ORBIT, "V=1", "us2=0.8", "ur2=1.2831", "us1=1/3")
    assert out.index("Orbit") < out.index("Trace criterion")
    assert "admissible: yes" in out
    rows = {line.split()[0]: line.split()[1:] for line in out.splitlines() if line.split()}
    assert rows["V"] == ["1"]
    assert rows["us1"] == ["1/3"]
    assert rows["e1"] == ["3.0195", "default"]
    assert rows["e2"] == [told("solve", ORBIT)["parameters"]["e2"], "follows"]


def test_report_of_violations():
    out = answered("solve", ORBIT, "us2=0.7")
    assert "admissible: no" in out
    (first, *_) = told("solve", ORBIT, "us2=0.7")["violations"]
    assert (first["phase"], first["boundary"]) == (1, "second-breaks-backward")
    assert re.search(r"1 +stick-stick +second-breaks-backward +0 +0\.0456", out)


def test_long_numbers_are_grouped():
    out = answered("verify", ORBIT, "--digits", "120")
    assert max(map(len, out.splitlines())) <= 80
    trace = told("verify", ORBIT, "--digits", "120")["trace"]
    assert trace in re.sub(r"\s", "", out)


@pytest.mark.slow
def test_piped_output_has_no_colours_and_whole_numbers():
    """Whatever the width and the encoding are said to be."""
    narrow = {"COLUMNS": "40", "PYTHONIOENCODING": "ascii"}
    done = nonsmooth_process("verify", ORBIT, "--digits", "50", **narrow)
    assert (done.returncode, done.stderr) == (0, "")
    assert "\x1b" not in done.stdout
    assert told("verify", ORBIT)["trace"] in done.stdout.split()


# --- save, plot


@pytest.mark.parametrize("command", ["solve", "verify"])
def test_save(command, tmp_path):
    target = tmp_path / "orbit.json"
    arguments = (command, ORBIT, "eta=0.98", "us2=0.8", "--digits", "30")
    plain, found = told(*arguments), told(*arguments, "--save", str(target))
    assert found == plain | {"file": str(target)}
    orbit = nonsmooth.load(target)
    assert orbit.digits == 30
    assert orbit.to_json()["unknowns"] == plain["unknowns"]
    assert orbit.opened["us2"].text == "0.8"
    assert answered(*arguments, "--save", str(target)).endswith(f"\n{target} written\n")


def test_an_orbit_that_misses_a_requirement_is_saved(tmp_path):
    target = tmp_path / "orbit.json"
    code, _, _ = run("solve", ORBIT, "us2=0.7", "--require", "admissible", "--save", str(target))
    assert code == 3
    assert nonsmooth.load(target).admissibility.verdict is False


@pytest.fixture
def saved(tmp_path):
    """A saved orbit, for pictures."""
    pytest.importorskip("matplotlib")
    path = tmp_path / "orbit.json"
    nonsmooth.solve(ORBIT).save(path)
    return path


@pytest.mark.slow
def test_plot_names_its_file(saved):
    target = saved.with_suffix(".png")
    assert run("plot", str(saved)) == (0, f"{target} written\n", "")
    assert target.read_bytes().startswith(b"\x89PNG")


def test_plot_of_wrong_files_is_2(saved, tmp_path):
    picture = tmp_path / "orbit.png"
    picture.write_bytes(saved.read_bytes())
    for arguments, part in (
        ((tmp_path / "none.json",), "there is no file"),
        ((picture,), f"cannot write {picture}: it is the saved file"),
        ((saved, "--out", saved), f"cannot write {saved}: it is the saved file"),
        (
            (saved, "--out", saved / "a.png"),
            f"{saved} is not a folder",
        ),
        ((saved, "--periods", "0"), "periods = 0 is not an integer from 1"),
    ):
        assert part in refused("plot", *map(str, arguments))
    assert nonsmooth.load(saved) == nonsmooth.load(picture)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["orbit.json", "orbit.png"]


# --- exit codes


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (["--require", "stable"], 0),
        (["--require", "stable", "--require", "admissible"], 3),
        (["us1=1", "us2=0.8", "--require", "admissible", "--require", "stable"], 0),
        (["us2=0.7", "--require", "admissible"], 3),
        (["chi=0.999999", "--require", "stable"], 3),
    ],
)
@pytest.mark.parametrize("command", ["solve", "verify"])
def test_requirements(command, arguments, code):
    found, _, err = run(command, ORBIT, *arguments)
    assert found == code
    assert err.startswith("nonsmooth: required: ") if code else not err
    assert told(command, ORBIT, *arguments, code=code)["orbit"] == ORBIT


def test_neutral_is_not_stable():
    name = "rigid-stop/one-impact"
    assert run("solve", name, "--require", "admissible")[0] == 0
    code, _, err = run("solve", name, "--require", "stable")
    assert (code, err) == (3, "nonsmooth: required: stable; found: neutral\n")


def test_undecided_is_1():
    assert told("verify", *GRAZING, code=1)["stability"] == "undecided"
    code, out, _ = run("verify", *GRAZING, "--require", "stable")
    assert code == 1
    assert "undecided: the margin is zero to these digits" in out


@pytest.mark.parametrize("command", ["solve", "verify"])
@pytest.mark.parametrize(
    ("arguments", "part"),
    [
        ("rigid-stop/one-impact r=0.9", "exists only for r = 1: with r = 0.9 no orbit"),
        ("rigid-stop/one-impact k1=2 k2=4 T=2*pi", "singular: at these parameters (a resonance)"),
        ("elastic-stop/one-contact T=1e-6", "no orbit was found at these parameters"),
        (f"{ORBIT} eta=1e300", "tried: "),
    ],
)
def test_parameters_without_an_orbit_are_1(command, arguments, part):
    assert part in refused_alike(command, *arguments.split(), code=1)


# --- wrong input


def test_unknown_backend_is_2(monkeypatch):
    monkeypatch.setenv("NONSMOOTH_BACKEND", "fortran")
    told = "nonsmooth: error: NONSMOOTH_BACKEND is 'fortran', neither 'c' nor 'numpy'"
    assert refused("solve", ORBIT) == told


# --- equations


@pytest.mark.parametrize(
    ("form", "start"), [("latex", "\\documentclass"), ("markdown", "# "), ("html", "<!DOCTYPE")]
)
def test_equations_print_or_write(form, start, tmp_path):
    if form == "html":
        pytest.importorskip("latex2mathml")
    options = ("rigid-stop", "--format", form)
    printed = told("equations", *options)
    assert list(printed) == ["name", "format", "text"]
    assert (printed["name"], printed["format"]) == ("rigid-stop", form)
    assert printed["text"].startswith(start)
    target = tmp_path / "equations"
    again = told("equations", *options, "--out", str(target))
    assert again == {"name": "rigid-stop", "format": form, "file": str(target)}
    assert target.read_text(encoding="utf-8") == printed["text"]


@pytest.mark.slow
def test_equations_print_one_section():
    text = told("equations", "rigid-stop/one-impact", "--section", "map", "--format", "markdown")
    headings = re.findall(r"^## (.*)", text["text"], re.MULTILINE)
    (heading,) = headings
    assert re.fullmatch(r"\d+\. Derivatives and the Poincaré map", heading)
    latex = answered("equations", "rigid-stop/one-impact", "--section", "trace")
    assert latex.count(r"\section{") == 1
    # LaTeX counts on from there
    assert re.search(
        r"\\setcounter\{section\}\{\d+\}\s+\\needroom.*\s\\section\{The trace\}", latex
    )


def test_equations_of_a_system_have_one_section():
    text = answered("equations", "rigid-stop", "--section", "flows", "--format", "markdown")
    assert re.findall(r"^## \d+\. (.*)", text, re.MULTILINE) == ["Modal analysis"]
    error = refused("equations", "rigid-stop", "--section", "trace")
    assert "rigid-stop is a system: its orbits have a part 'trace' (one-impact" in error


@pytest.mark.parametrize(
    ("latex", "code", "said"),
    [
        ("/bin/cp document.tex document.pdf", 0, "rigid-stop.pdf written\n"),
        ("echo '! Undefined control sequence.'; exit 1", 1, "nonsmooth: pdflatex failed: ! Undef"),
        (None, 2, "install texlive"),
    ],
)
def test_a_pdf_is_what_latex_makes(latex, code, said, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("PATH", str(tmp_path))
    if latex is not None:
        Path("pdflatex").write_text(f"#!/bin/sh\n{latex}\n")
        Path("pdflatex").chmod(0o755)
    ended = run("equations", "rigid-stop", "--format", "pdf")
    assert ended.code == code
    assert said in ended.out + ended.err
    assert ended.err.count("\n") == bool(code)
    assert Path("rigid-stop.pdf").exists() == (code == 0)


def test_html_without_its_extra_names_it(monkeypatch):
    monkeypatch.setitem(sys.modules, "latex2mathml", None)
    monkeypatch.setitem(sys.modules, "latex2mathml.converter", None)
    error = refused("equations", "rigid-stop", "--format", "html")
    told = 'nonsmooth: error: latex2mathml is not installed: pip install "nonsmooth[html]"'
    assert error == told


# --- regenerate


@pytest.mark.usefixtures("committed_derivation")
def test_regenerate_and_check(tmp_path):
    folder = tmp_path / "new" / "kernels"
    first = told("regenerate", "--out", str(folder))
    assert first["folder"] == str(folder)
    assert first["system"] is None
    assert {Path(path).name for path in first["changed"]} == {p.name for p in folder.iterdir()}
    assert told("regenerate", "--out", str(folder))["changed"] == []
    assert answered("regenerate", "--out", str(folder)) == f"{folder}: nothing changed\n"
    assert told("regenerate", "--check", "--out", str(folder))["same"] is True
    assert answered("regenerate", "--check", "--out", str(folder)) == f"{folder}: up to date\n"

    (folder / "dry_friction.h").unlink()
    with (folder / "dry_friction.md").open("a", encoding="utf-8") as file:
        file.write("an edit [by hand]\n")
    code, out, err = run("regenerate", "--check", "--out", str(folder))
    assert code == 1
    assert "dry_friction.h: missing" in out
    assert "-an edit [by hand]" in out
    assert "python scripts/regenerate.py" in err
    found = told("regenerate", "dry-friction", "--check", "--out", str(folder), code=1)
    assert found["same"] is False
    assert len(found["differences"]) == 2


@pytest.mark.usefixtures("committed_derivation")
def test_regenerate_says_when_it_is_about_another_checkout(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert run("regenerate", "--check")[2] == ""
    (tmp_path / "pyproject.toml").write_text('[project]\nname = "nonsmooth"\n')
    code, _, err = run("regenerate", "--check")
    assert code == 0
    assert f"not about {tmp_path}" in err
    assert err.count("\n") == 1
    assert run("regenerate", "--out", "kernels")[2] == ""


@pytest.mark.slow
def test_regenerate_derives_one_system(tmp_path):
    folder = tmp_path / "kernels"
    found = told("regenerate", "rigid-stop", "--out", str(folder))
    names = {Path(path).name for path in found["changed"]}
    assert names == {path.name for path in folder.iterdir()}
    assert {f"rigid_stop.{ending}" for ending in ("py", "c", "h", "md")} <= names
    assert not any(name.startswith(("elastic", "dry")) for name in names)


def test_check_of_what_another_sympy_wrote_or_nobody_is_2(tmp_path):
    for told in ("PROVENANCE.json cannot be read", "SymPy 1.0"):
        assert told in refused("regenerate", "--check", "--out", str(tmp_path))
        (tmp_path / "PROVENANCE.json").write_text('{"sympy": "1.0"}')


def test_regenerate_outside_a_checkout_is_2(tmp_path, monkeypatch):
    monkeypatch.setattr(generation, "__file__", str(tmp_path / "a" / "b" / "c.py"))
    for options, reason in (([], "--out DIR"), (["--check"], "PROVENANCE.json cannot be read")):
        code, out, err = run("regenerate", *options)
        assert (code, out) == (2, "")
        assert reason in err


# --- scripts


@pytest.mark.parametrize(
    ("script", "command"),
    [("regenerate", "regenerate"), ("latex", "equations"), ("verify_trace", "verify")],
)
def test_scripts_are_the_commands(script, command):
    path = str(CHECKOUT / "scripts" / f"{script}.py")
    done = run_process(sys.executable, path, "--help")
    assert (done.returncode, done.stderr) == (0, "")
    assert f"{script}.py [OPTIONS]" in done.stdout
    assert done.stdout.partition("\n \n")[2] == run(command, "--help")[1].partition("\n \n")[2]
