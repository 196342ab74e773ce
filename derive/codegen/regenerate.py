"""Make the files of generated/ again, or check that they are what the derivation gives."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from itertools import zip_longest
from os.path import commonprefix
from pathlib import Path

import sympy as sp

from nonsmooth.derive.codegen.derived import Progress, silent
from nonsmooth.derive.codegen.emit import PROVENANCE, EmittedSystem, emit_package, emit_system
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.systems import SYSTEMS, declaration

# hashes of derivations and of files: they differ wherever anything does
_STAMP = re.compile(r"((?:derivation|sha256)\w*\W{1,4})(?:[0-9a-f]{64}|[0-9a-f]{16})\b", re.I)
# files by how easily a formula is read in them
_READABLE = (".md", ".py", ".h", ".c")
_SHOWN_CHARACTERS = 160


def find_generated(*, writing: bool = True) -> Path:
    """The folder `generated` beside this code.

    With `writing` it has to be that of a checkout, else DerivationError is raised; that of
    an installed package is only read.
    """
    # in an editable install this file is a link into the checkout
    root = Path(__file__).resolve().parents[2]
    if not writing or _is_checkout(root):
        return root / "generated"
    raise DerivationError("this is not a checkout of nonsmooth: say where to write with --out DIR")


def surrounding_checkout() -> Path | None:
    """The checkout in which the process stands; None outside of each."""
    place = Path.cwd()
    return next(filter(_is_checkout, (place, *place.parents)), None)


def _is_checkout(root: Path) -> bool:
    project = root / "pyproject.toml"
    return project.is_file() and 'name = "nonsmooth"' in project.read_text(encoding="utf-8")


def emit_systems(names: Sequence[str], progress: Progress = silent) -> list[EmittedSystem]:
    """The built-in systems of those names, derived and emitted.

    DerivationError refuses an orbit without a closed form, which each built-in orbit has.
    """
    emitted = []
    for name in names:
        module = declaration(name)
        emitted.append(emit_system(module.system, module.orbits, module.__name__, progress))
        for orbit, reason in emitted[-1].underived.items():
            raise DerivationError(f"{name}/{orbit}: {reason}")
    return emitted


def outdated(
    folder: Path | None = None,
    system: str | None = None,
    progress: Progress = silent,
) -> dict[str, str]:
    """Texts by file name of those files that are missing or differ from the derivation.

    The folder is `generated` of the checkout if none is given. With `system` another folder
    gets that system alone, while in the checkout its own files and the shared ones are
    compared. `progress` gets the name of each step when it begins.
    """
    target = find_generated() if folder is None else folder
    return {
        name: text
        for name, text in _wanted(folder, system, progress).items()
        if not (path := target / name).is_file() or path.read_bytes() != text.encode()
    }


def check(
    folder: Path | None = None,
    system: str | None = None,
    progress: Progress = silent,
) -> tuple[str, ...]:
    """Differences between the files and what the derivation gives now; nothing is written.

    DerivationError refuses files that another version of SymPy made, whose output may
    differ without a fault.
    """
    target = find_generated(writing=False) if folder is None else folder
    made_with = _sympy_of(target / PROVENANCE)
    if made_with != sp.__version__:
        raise DerivationError(
            f"{PROVENANCE} is of SymPy {made_with}, this is SymPy {sp.__version__}:"
            f' compare under the former (pip install "sympy=={made_with}")'
        )
    return differences(target, _wanted(folder, system, progress))


def differences(folder: Path, wanted: Mapping[str, str]) -> tuple[str, ...]:
    """Differences between the files of a folder and the wanted texts, one for each file.

    Missing files come first, then the first line that differs of each file, those with readable
    formulas before others, and last those in which stamps or ends of lines alone differ.
    """
    missing, changed, stamped = [], [], []
    for name, text in wanted.items():
        path = folder / name
        if not path.is_file():
            missing.append(f"{name}: missing")
            continue
        existing = path.read_bytes().decode("utf-8", "replace")  # with its ends of lines
        unstamped = [_STAMP.sub(r"\1-", each) for each in (existing, text)]
        lines, derived = map(str.splitlines, unstamped)
        if lines != derived:
            changed.append((_readability(path), _first_difference(name, lines, derived)))
        elif existing != text:
            ends = unstamped[0] != unstamped[1]
            stamps = existing.splitlines() != text.splitlines()
            told = " and ".join(["stamps"] * stamps + ["ends of lines"] * ends)
            stamped.append(f"{name}: its {told} alone")
    return (*missing, *(told for _, told in sorted(changed)), *stamped)


def _readability(path: Path) -> int:
    return _READABLE.index(path.suffix) if path.suffix in _READABLE else len(_READABLE)


def _first_difference(name: str, lines: list[str], derived: list[str]) -> str:
    """The first line of a file that differs from what is derived, cut where they differ."""
    pairs = enumerate(zip_longest(lines, derived), start=1)
    number, (found, wanted) = next((n, pair) for n, pair in pairs if pair[0] != pair[1])
    same = commonprefix([found or "", wanted or ""])  # noqa: RUF071 - of characters, no path
    begin = max(0, len(same) - _SHOWN_CHARACTERS // 2)
    told = [f"--- {name} (found)", f"+++ {name} (derived)", f"line {number}:"]
    for sign, line in (("-", found), ("+", wanted)):
        if line is not None:
            end = begin + _SHOWN_CHARACTERS
            cut = f"{'... ' * (begin > 0)}{line[begin:end]}{' ...' * (end < len(line))}"
            told.append(f"{sign}{cut}")
    return "\n".join(told)


def _wanted(folder: Path | None, system: str | None, progress: Progress) -> dict[str, str]:
    if system is not None and folder is not None:
        return emit_package(emit_systems([system], progress))
    emitted = emit_systems(list(SYSTEMS), progress)
    files = emit_package(emitted)
    others = [e for e in emitted if system is not None and e.name != system]
    skipped = {file for other in others for file in other.files}
    return {name: text for name, text in files.items() if name not in skipped}


def _sympy_of(provenance: Path) -> str:
    try:
        return str(json.loads(provenance.read_text(encoding="utf-8"))["sympy"])
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise DerivationError(
            f"{provenance} cannot be read: regenerate without --check writes it again"
        ) from error
