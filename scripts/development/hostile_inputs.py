"""Hostile commands, made from the options that the commands declare."""

from __future__ import annotations

import enum
import inspect
import random
import types
import typing
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from hostile_files import DATA, ORBIT, declaration_names

from nonsmooth.runtime.cli.program import app
from nonsmooth.runtime.cli.proofs.certifying import certifying

_LONG = "x" * 300
NAMES = (
    "", " ", _LONG, "x" * 20_000, "a\nb", "a\x1b[31mb\r", "..", "/", ".", "-", "--", "é", "名字",
    "\udc80", "%s%n", "{}", "$(touch gone)", "'", '"', "`", "a/b/c", "dry-friction/", "//", "a:b",
    "DRY-FRICTION/GLOBAL-STICK", "dry-friction/global-stick/", "mine.py:", "mine.py:no", "no.py",
    "found.json:0", "found.json:99999999999999999999", "found.json:-1", "found.json:1:1", "fifo",
    "orbit.json:1", "branch.json", "kernels", ".:loop", "chart.zarr", "x" * 250 + ".py",
    "/etc/passwd", "mine.py:lo\nop", "@0000000000000000", "a@0000000000000000", "\u202egnp", "\x00",
)  # fmt: skip
NUMBERS = (
    "", "nan", "inf", "-inf", "1e400", "1e-400", "1e308", "-1e308", "5e-324", "0", "-0", "-1",
    "1/0", "0/0", "sqrt(-1)", "log(0)", "10**10**10", "10**9999", "(" * 99 + "1" + ")" * 99,
    "1" + "+1" * 499, "__import__('os')", "1e99999999", "9" * 400, "9" * 5000, "0x10", "1_000",
    "１", "½", "1;2",
    "exp(10000)", "exp(exp(10))", "sin(1e300)", "1e-9", "1e9", "pi", "2**-1074", "2**(1/3)", "1\n2",
    "exp(-exp(20))", "1e300*1e300", "0.1e-9999", "eta", "V", "--", "1e", ".", "+", "0.5", "2",
)  # fmt: skip
COUNTS = (
    "-1", "0", "1", "2", "7", "99999999999999999999", "1e3", "1.5", "", "nan", "2147483648", "x",
    "9223372036854775807", "9223372036854775808", "-9223372036854775809", "9" * 5000, "٣",
    "1000000000000",
)  # fmt: skip
WRITTEN = (
    "", ".", "/proc", "..", "out", "out.xyz", "no/such/out", "out.json/", _LONG, "a\nb",
    "folder.json", "fifo.json", "full.json", "full.png", "loop.json", "nowhere.json", "out\udc80",
    "/proc/out", "/sys/out", "mine.py", "out.json", "out.png", "out.npz", "out.zarr", "-",
    "x" * 251, "~", "\x00",
)  # fmt: skip
READ = (
    "orbit.json", "certificate.json", "map.json", "census.json", "branch.json", "motion.npz",
    "motion.csv", "found.json", "sweep.json", "chart.zarr", "found.json:1", "forged0.npz",
    "forged1.npz", "forged2.npz", "forged3.npz", "fifo.json", "full.json", "loop.json", "no.json",
    "nowhere.json", "sparse.json", "folder.json", "empty.json", "mine.py", "/", ".", "zero.json",
    _LONG, "a\nb", "",
)  # fmt: skip
ENDINGS = ("", ".json", ".npz", ".csv", ".png", ".svg", ".pdf", ".zarr", ".py")
POINT = [f"{name}={value}" for name, value in DATA.items()]
FROM = ["--from", "x1=0,x2=0,v1=0,v2=0"]
BASES: Mapping[str, Sequence[Sequence[str]]] = {
    "list": [["mine.py"], ["dry-friction"]],
    "equations": [["rigid-stop", "--format", "markdown", "--out", "out.md"]],
    "solve": [[ORBIT, "eta=0.98"], ["mine.py:loop", "k=2"], [ORBIT, "--unknown", "e1,e2", "--given",
              "ta=1,tau=2", "--save", "out.json"], ["found.json:1", "V=1.01"]],
    "verify": [[ORBIT, "--digits", "20"], ["rigid-stop/one-impact", "T=2*pi"]],
    "plot": [["orbit.json"], ["branch.json"], ["map.json"], ["motion.npz"], ["motion.csv"],
             ["found.json:1"], ["chart.zarr"], ["sweep.json"], ["orbit.json", "--periods", "2"]],
    "reproduce": [["--out", "mine.py"]],
    "regenerate": [["no-system", "--out", "kernels"]],
    "generate": [["mine.py", "--out", "kernels"]],
    "certify orbit": [[ORBIT, "eta=0.98"]],
    "certify box": [[ORBIT, "V=0.99:1.01", "--tiles", "2"],
                    [ORBIT, "V=0.99:1.01", "eta=1:1.01", "--tiles", "2", "--resume", "map.json"]],
    "certify branch": [[ORBIT, "V=0.99:1.01", "--tiles", "1"]],
    "certify event": [[ORBIT, "V=0.99:1.01", "--save", "out.json"]],
    "certify all": [[ORBIT, "tau=0:1", "tau1=0:1"]],
    "certify check": [["certificate.json"], ["map.json"], ["census.json"]],
    "chart": [[ORBIT, "V=0.9:1.1:3", "eta=0.9:1.1:2", "--out", "out.zarr"],
              [ORBIT, "V=0.9:1.1:3", "--chunk", "1", "--workers", "1", "--out", "chart.zarr"],
              ["dry-friction", "V=0.9:1.1:3", *POINT, *FROM, "--transitions", "300",
               "--out", "out.zarr"]],
    "continue": [[ORBIT, "V=0.99:1.01", "--save", "out.json", "--points", "20"],
                 [ORBIT, "V=0.99:1.01", "--resume", "branch.json", "--points", "5"],
                 ["mine.py:loop", "r=0.4:0.6", "--points", "20", "--step", "0.05"]],
    "simulate": [["dry-friction", "V=1", *POINT, *FROM, "--transitions", "10", "--save", "out.csv"],
                 ["dry-friction", "V=1", *POINT, *FROM, "--until", "20", "--observe"],
                 ["mine.py", "k=1", "r=1/2", "--from", "x=0,v=1", "--transitions", "5", "--prove"]],
    "find": [["dry-friction", "V=1", *POINT, "--starts", "4", "--transitions", "300"],
             ["mine.py", "k=1", "r=1/2", "--starts", "4", "x=-1:1", "--save", "out.json"]],
    "sweep": [["dry-friction", "V=0.9:1.1:3", *POINT, *FROM, "--quantity", "x1",
               "--at", "stick-stick", "--transient", "20", "--samples", "6", "--save", "out.json"],
              ["dry-friction", "V=0.9:1:2", *POINT, *FROM, "--quantity", "x1",
               "--at", "stick-stick", "--transient", "20", "--samples", "6",
               "--resume", "sweep.json"]],
}  # fmt: skip
_RARE = {  # of the others 6
    **{"reproduce": 1, "regenerate": 1, "equations": 2, "list": 3},
    **dict.fromkeys((name for name in BASES if name.startswith("certify")), 2),
}


@dataclass(frozen=True)
class Option:
    """An option of a command as it is declared: its flag, and what kind of value it takes."""

    flag: str
    kind: str  # flag, count, number, choice, read, written, range, assignment, name


@dataclass(frozen=True)
class Case:
    """A command with its arguments, and the files that are damaged before."""

    arguments: tuple[str, ...]
    damaged: tuple[str, ...]
    seed: int


def options_of() -> dict[str, list[Option]]:
    """Options of each command, from the declarations that Typer is given."""
    found: dict[str, list[Option]] = {}
    named = [(f"{command.name}", command) for command in app.registered_commands]
    named += [(f"certify {command.name}", command) for command in certifying.registered_commands]
    for name, command in named:
        assert command.callback is not None
        found[name] = []
        for parameter in inspect.signature(command.callback).parameters.values():
            if not typing.get_args(parameter.annotation):
                continue  # the context of a command
            made, info = typing.get_args(parameter.annotation)
            flags = [
                flag for flag in (getattr(info, "param_decls", None) or ()) if flag.startswith("--")
            ]
            if "Argument" in type(info).__name__:
                continue
            flag = flags[0] if flags else f"--{parameter.name.replace('_', '-')}"
            found[name].append(Option(flag, _kind(flag, made, info.metavar or "")))
    return found


def _kind(flag: str, made: Any, metavar: str) -> str:
    types_of = typing.get_args(made) if isinstance(made, types.UnionType) else (made,)
    for each in types_of:
        if each is bool:
            return "flag"
        if each is int:
            return "count"
        if each is float:
            return "number"
        if each is Path:
            return "read" if flag == "--resume" else "written"
        if isinstance(each, type) and issubclass(each, enum.Enum):
            return "choice"
    if ":" in metavar and "=" in metavar:
        return "range"
    if "=" in metavar:
        return "assignment"
    return "number" if metavar in ("TIME", "ANGLE", "VALUE") else "name"


def cases(count: int, seed: int) -> list[Case]:
    """So many hostile commands; equal seeds give equal ones."""
    options = options_of()
    weighted = [name for name in BASES for _ in range(_RARE.get(name, 6))]
    return [_case(options, weighted, random.Random(f"{seed}:{k}"), k) for k in range(count)]


def _case(
    options: Mapping[str, list[Option]], weighted: Sequence[str], draw: random.Random, number: int
) -> Case:
    command = draw.choice(weighted)
    words = list(draw.choice(BASES[command]))
    damaged: list[str] = []
    kinds = {option.flag: option.kind for option in options[command]}
    for _ in range(draw.choice((1, 1, 1, 2, 3))):
        chance = draw.random()
        if chance < 0.2 and command not in ("reproduce", "regenerate"):
            files = [word for word in words if (word.split(":")[0]) in READ]
            if files:
                damaged.append(draw.choice(files).split(":")[0])
                continue
        if chance < 0.7 and words:
            _replace(words, kinds, draw)
        elif chance < 0.9:
            option = draw.choice(options[command])
            if option.flag not in ("--debug", "--yes"):
                words.append(option.flag)
                if option.kind != "flag":
                    words.append(_value(option.kind, draw))
        elif words:
            place = draw.randrange(len(words))
            words[place : place + 1] = [words[place]] * draw.choice((0, 2))
    if draw.random() < 0.2:
        words.append("--json")
    return Case((*command.split(), *words), tuple(damaged), number)


def _replace(words: list[str], kinds: Mapping[str, str], draw: random.Random) -> None:
    """Put something hostile in the place of one word."""
    place = draw.randrange(len(words))
    word = words[place]
    if word in kinds:
        return
    before = words[place - 1] if place else ""
    if before in kinds and kinds[before] != "flag":
        kind = kinds[before]
    elif "=" in word:
        kind = "range" if ":" in word else "assignment"
    else:
        kind = "read" if word.split(":")[0] in READ and draw.random() < 0.7 else "subject"
    if "=" in word and draw.random() < 0.7:  # only its name, or only its value
        name, _, value = word.partition("=")
        if draw.random() < 0.2:
            words[place] = f"{draw.choice(NAMES)}={value}"
        else:
            words[place] = f"{name}={_right(kind, draw)}"
    else:
        words[place] = _value(kind, draw)


def _right(kind: str, draw: random.Random) -> str:
    if kind == "assignment":
        return draw.choice(NUMBERS)
    parts = [
        draw.choice(NUMBERS) if draw.random() < 0.4 else draw.choice(("0.9", "1.1")) for _ in "ab"
    ]
    if draw.random() < 0.6:
        parts.append(draw.choice(COUNTS))
    return ":".join(parts)


def _value(kind: str, draw: random.Random) -> str:
    match kind:
        case "count":
            return draw.choice(COUNTS)
        case "number":
            return draw.choice(NUMBERS)
        case "range" | "assignment":
            parts = [
                f"{draw.choice((*NAMES, 'V', 'x1'))}={_right(kind, draw)}"
                for _ in range(draw.choice((1, 1, 2)))
            ]
            return ",".join(parts)
        case "read":
            return draw.choice(READ)
        case "written":
            name = draw.choice(WRITTEN)
            return name + draw.choice(ENDINGS) if draw.random() < 0.4 else name
        case "subject":
            if draw.random() < 0.5:
                return draw.choice(declaration_names()) + draw.choice(("", ":loop"))
            return draw.choice(NAMES)
        case _:
            return draw.choice(NAMES)
