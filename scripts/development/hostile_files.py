"""Files that hostile commands are given: whole ones, damaged and forged ones, declarations."""

from __future__ import annotations

import json
import os
import random
import stat
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

import nonsmooth as ns
from nonsmooth.runtime.core.result_files import checksum_of

ORBIT = "dry-friction/global-stick"
DATA = {"chi": "0.5", "eta": "1", "us1": "1", "us2": "1", "ur1": "4.0195", "ur2": "1.4831"}
REST = dict.fromkeys(("x1", "x2", "v1", "v2"), 0)
VALUES: tuple[Any, ...] = (
    None, True, -1, 0, 10**30, 1e308, -1e308, 5e-324, "", "nan", "1e400", "x" * 300, "a\nb",
    "1/0", "10**10**30", [], {}, [[[]]], {"a": {"b": []}}, "k**" + "9" * 30, "0" * 2000,
)  # fmt: skip

DECLARATION = '''\
"""A mass between two springs, kicked."""
import sympy as sp
from nonsmooth.derive import (
    Boundary, Configuration, Itinerary, Parameter, Reference, SecondOrder, System, Transition,
)
k = Parameter("k", "stiffness on the right")
r = Parameter("r", "what is left of the velocity", upper=1)
x, v = states = sp.symbols("x v", real=True)
right = Configuration("right", SecondOrder([[1]], [[k.symbol]]), (Boundary("falls", -x),))
left = Configuration("left", SecondOrder([[1]], [[4]]), (Boundary("rises", x),))
system = System(
    "kicked", "a kicked mass", states, (k, r), (right, left),
    (
        Transition("right", {"falls"}, "left"),
        Transition("left", {"rises"}, "right", (), {v: r.symbol * v + 1}),
    ),
)
phases = (("right", "falls", "ta"), ("left", "rises", "tb"))
reference = Reference({"k": "1", "r": "0.5"}, {"v0": "1.9", "ta": "3", "tb": "1.5"})
orbits = [Itinerary("loop", system, phases, reference=reference)]
'''
_ENDS = {
    "exit": "raise SystemExit",
    "exit_3": "import sys; sys.exit('no\\nway')",
    "base": "raise BaseException('base\\nline')",
    "generator": "raise GeneratorExit",
    "silent": "class E(Exception):\n    def __str__(self): raise ValueError('no')\nraise E",
    "mute": "class E(BaseException):\n    def __str__(self): return 3\nraise E",
    "group": "raise ExceptionGroup('many', [ValueError('a'), OSError('b')])",
    "zero": "1/0",
    "deep": "def f(): f()\nf()",
    "parentheses": "x = " + "(" * 300 + ")" * 300,
    "syntax": "system = (",
    "null": "system = '\x00'",
    "no_encoding": "# coding: klingon\nsystem = 1",
    "number": "system = 3",
    "module": "import os\nsystem = os",
    "mock": "from unittest.mock import MagicMock\nsystem = MagicMock()",
    "yes": "class Y:\n    def __getattr__(self, n): return self\n"
    "    def __call__(self, *a, **k): return self\nsystem = Y()",
    "false": "class Y:\n    name = 'y'\n    def fingerprint(self, orbits=()): return 3\n"
    "    def source(self, orbits=()): return 'raise SystemExit'\nsystem = Y()",
    "none": "system = None",
    "bad_import": "import no_such_module",
    "missing": "open('no_such_file.txt')",
    "warns": "import warnings; warnings.warn('old'); raise ValueError('v' * 5000)",
}
_CHANGES = {
    "prints": ('import sympy as sp\n', 'import sympy as sp\nprint("a\\nb" * 99)\n'),
    "long_name": ('"kicked"', '"k" * 300'),
    "line_name": ('"kicked"', '"kic\\nked"'),
    "path_name": ('"kicked"', '"../kicked"'),
    "empty_name": ('"kicked"', '""'),
    "orbit_name": ('"loop"', '"lo\\nop" * 90'),
    "orbits": ("orbits = [", "orbits = 3, ["),
    "foreign_orbits": ("orbits = [Itinerary", "orbits = [system, Itinerary"),
    "no_orbits": ("orbits = [", "others = ["),
    "infinite": ("[[4]]", "[[sp.oo]]"),
    "not_a_number": ("[[4]]", "[[sp.nan]]"),
    "huge": ("[[4]]", "[[10**400]]"),
    "large": ("[[4]]", "[[sp.Float('1e308')]]"),
    "power": ("[[4]]", "[[k.symbol ** (10**30)]]"),
    "text": ("[[4]]", "[['4']]"),
    "shape": ("[[4]]", "[[4, 5]]"),
    "reference": ('"ta": "3"', '"ta": "1e400"'),
}  # fmt: skip


def declaration_names() -> list[str]:
    """Names of the hostile declarations."""
    ends, changes = (f"bad_{name}.py" for name in _ENDS), (f"odd_{name}.py" for name in _CHANGES)
    return ["bad_bytes.py", "bad_empty.py", *ends, *changes]


def make_files(folder: Path) -> None:
    """Write one file of each kind, and hostile declarations, into a folder."""
    (folder / "mine.py").write_text(DECLARATION)
    for name, text in _ENDS.items():
        (folder / f"bad_{name}.py").write_bytes(text.encode())
    (folder / "bad_bytes.py").write_bytes(b"\xff\xfe\x00system = 1")
    (folder / "bad_empty.py").write_bytes(b"")
    for name, (old, new) in _CHANGES.items():
        (folder / f"odd_{name}.py").write_text(DECLARATION.replace(old, new, 1))
    orbit = ns.solve(ORBIT)
    orbit.save(folder / "orbit.json")
    ns.certify(orbit).save(folder / "certificate.json")
    box = {"V": ("0.99", "1.01"), "eta": ("0.99", "1.01")}
    ns.certify.box(orbit, box, tiles=3).save(folder / "map.json")
    ns.certify.all(ORBIT, box={"tau": 1, "tau1": 1}).save(folder / "census.json")
    branch = ns.continue_orbit(orbit, "V", (0.99, 1.01))
    branch.save(folder / "branch.json")
    motion = ns.simulate("dry-friction", {**DATA, "V": 1}, REST, transitions=20)
    motion.save(folder / "motion.npz")
    motion.save(folder / "motion.csv")
    states = motion.run.states.copy()
    for number, wrong in enumerate((1e308, np.nan, np.inf, 5e-324)):
        states[3, 1] = wrong
        with suppress(ns.InputError):
            run = replace(motion.run, states=states)
            replace(motion, run=run).save(folder / f"forged{number}.npz")
    found = ns.find_orbits("dry-friction", {**DATA, "V": 1}, 10, transitions=200)
    found.save(folder / "found.json")
    where = {"state": "x1", "configuration": "stick-stick", "transient": 20, "samples": 6}
    ns.sweep("dry-friction", DATA, "V", [0.9, 1.0], REST, **where).save(folder / "sweep.json")
    ns.chart(ORBIT, V=[0.9, 1.0], eta=[0.9, 1.0], store=folder / "chart.zarr")


def make_devices(folder: Path) -> None:
    """Put what is neither file nor folder into a folder: a FIFO, a full device, loops of links."""
    os.mkfifo(folder / "fifo")
    os.mkfifo(folder / "fifo.json")
    (folder / "loop.json").symlink_to(folder / "loop.json")
    (folder / "nowhere.json").symlink_to(folder / "no" / "such" / "place.json")
    with suppress(PermissionError):  # a device of its own: one in /dev might be replaced
        os.mknod(folder / "full.json", stat.S_IFCHR | 0o666, os.makedev(1, 7))
        os.mknod(folder / "zero.json", stat.S_IFCHR | 0o666, os.makedev(1, 5))
        os.mknod(folder / "full.png", stat.S_IFCHR | 0o666, os.makedev(1, 7))
    with (folder / "sparse.json").open("wb") as file:
        file.truncate(20_000_000_000)
    (folder / "folder.json").mkdir()
    (folder / "empty.json").write_bytes(b"")


def damage(path: Path, draw: random.Random) -> None:
    """Change a file, or a file of a folder, in a random way."""
    if path.is_dir():
        inside = sorted(each for each in path.rglob("*") if each.is_file())
        path = draw.choice(inside)
    content = path.read_bytes()
    path.unlink()  # it may be a link to the whole file
    if path.suffix == ".json" and path.name != "zarr.json" and draw.random() < 0.6:
        with suppress(ValueError):
            path.write_text(json.dumps(_forged(json.loads(content), draw)))
            return
    match draw.randrange(5):
        case 0:
            content = content[: draw.randrange(len(content) + 1)]
        case 1:
            place = draw.randrange(max(1, len(content)))
            content = content[:place] + draw.randbytes(draw.randrange(40)) + content[place:]
        case 2 if content:
            place = draw.randrange(len(content))
            flipped = content[place] ^ (1 << draw.randrange(8))
            content = content[:place] + bytes([flipped]) + content[place + 1 :]
        case 3:
            words = (b"1e308", b"nan", b"9" * 400, b"," * 10, b'"' + b"x" * 140_000 + b'"')
            lines = content.split(b",")
            lines[draw.randrange(len(lines))] = draw.choice(words)
            content = b",".join(lines)
        case _:
            content = b"\n".join(draw.sample(lines := content.split(b"\n"), len(lines)))
    path.write_bytes(content)


def _forged(content: Any, draw: random.Random) -> Any:
    """Content with another entry somewhere, and the checksum that belongs to it."""
    holder, key = None, None
    here = content
    while isinstance(here, dict | list) and here and (holder is None or draw.random() < 0.85):
        holder = here
        key = draw.choice(list(here)) if isinstance(here, dict) else draw.randrange(len(here))
        here = holder[key]
    if holder is None:
        return content
    if draw.random() < 0.15:
        del holder[key]
    else:
        holder[key] = draw.choice(VALUES)
    if isinstance(content, dict) and "sha256" in content and key != "sha256":
        content["sha256"] = checksum_of(content)
    return content
