"""The command doctor: what this installation has, what it lacks, and what to do about it."""

from __future__ import annotations

import os
import platform
import re
import shutil
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from functools import partial
from importlib import import_module, metadata, resources, util
from types import ModuleType

from nonsmooth.runtime.cli.command import command
from nonsmooth.runtime.cli.reply import Reply

_NAME = "nonsmooth"
_EXTENSIONS = ("nonsmooth.generated._kernels", "nonsmooth.runtime._engine")
_LATEX = ("pdflatex", "lualatex", "tectonic")
_EXTRAS = {
    "plot": "pictures",
    "html": "equations and reports in HTML",
    "chart": "charts, also on a cluster",
    "speed": "faster long numbers",
    "jax": "derivatives in JAX",
    "torch": "derivatives in PyTorch",
}
_REQUIREMENT = re.compile(r"([\w.-]+)(?:\[[^]]*\])?\s*(?:>=\s*([\w.]+))?[^;]*(?:;(.*))?")
_DERIVATION = re.compile(r'^DERIVATION = "(\w+)"$', re.MULTILINE)
_EXTRA = re.compile(r"extra == ['\"](\w+)['\"]")


@dataclass(frozen=True)
class Diagnosis:
    """The state of one part of the installation."""

    name: str
    good: bool
    found: str  # what is installed or missing
    remedy: str | None = None  # what to do; None if nothing


def diagnoses() -> Iterator[Diagnosis]:
    """Look at versions, compiled code, threads, the cache, LaTeX and the extras."""
    yield Diagnosis(_NAME, True, metadata.version(_NAME))
    machine = f"{platform.python_implementation()} {platform.python_version()}"
    yield Diagnosis("Python", True, f"{machine}, {platform.platform()}")
    yield from _required()
    yield from (_extension(name) for name in _EXTENSIONS)
    yield _backend()
    yield _own_kernels()
    yield _cache()
    yield _threads()
    yield _latex()
    yield from map(_extra, _EXTRAS)


def _requirements(extra: str | None) -> Iterator[tuple[str, str]]:
    """Names of required packages and their lowest versions, of the package or of an extra."""
    for line in metadata.requires(_NAME) or ():
        found = _REQUIREMENT.fullmatch(line)
        wanted = found and _EXTRA.search(found[3] or "")
        if found and found[1] != _NAME and (wanted[1] if wanted else None) == extra:
            yield found[1], found[2] or "0"


def _numbers(version: str) -> list[int]:
    return [int(part) for part in re.findall(r"\d+", version)]


def _installed(name: str, lowest: str) -> tuple[str | None, bool]:
    """Version of a package, None if it is missing, and whether it is at least the lowest one."""
    try:
        version = metadata.version(name)
    except metadata.PackageNotFoundError:
        return None, False
    return version, _numbers(version) >= _numbers(lowest)


def _required() -> Iterator[Diagnosis]:
    for name, lowest in _requirements(None):
        version, good = _installed(name, lowest)
        remedy = None if good else f'pip install "{name}>={lowest}"'
        yield Diagnosis(name, good, version or "not installed", remedy)


def _extension(name: str) -> Diagnosis:
    """Diagnosis of one compiled module: whether it was built, and can be loaded."""
    label = {"_kernels": "compiled kernels", "_engine": "compiled engine"}[name.split(".")[-1]]
    again = f"install a C compiler, then: pip install --force-reinstall --no-deps {_NAME}"
    if util.find_spec(name) is None:
        return Diagnosis(label, False, "not built: everything runs on NumPy, slower", again)
    try:
        module = import_module(name)
    except ImportError as problem:
        return Diagnosis(label, False, f"built, but it does not load: {problem}", again)
    others = _of_another_derivation(module) if name == _EXTENSIONS[0] else []
    if others:
        told = f"of another derivation than generated/ for {', '.join(others)}"
        remedy = 'install the package again; in a checkout: pip install -e ".[all,test]"'
        return Diagnosis(label, False, told, remedy)
    return Diagnosis(label, True, str(module.__file__))


def _of_another_derivation(compiled: ModuleType) -> list[str]:
    """Systems of which the compiled kernels are not those of the Python files beside them."""
    folder = resources.files("nonsmooth.generated")
    texts = ((file.name.removesuffix(".py"), file) for file in folder.iterdir())
    return sorted(
        stem.replace("_", "-")
        for stem, file in texts
        if file.name == f"{stem}.py"
        and (stamp := _DERIVATION.search(file.read_text(encoding="utf-8")))
        and stamp[1] != getattr(compiled, f"derivation_{stem}", None)
    )


def _backend() -> Diagnosis:
    chosen = os.environ.get("NONSMOOTH_BACKEND", "")
    built = all(util.find_spec(name) for name in _EXTENSIONS)
    if chosen == "numpy":
        told = "NumPy, because NONSMOOTH_BACKEND is numpy"
        return Diagnosis("what computes", not built, told, "unset NONSMOOTH_BACKEND")
    if chosen not in ("", "c"):
        told = f"NONSMOOTH_BACKEND is {chosen!r}, neither 'c' nor 'numpy'"
        return Diagnosis("what computes", False, told, "unset NONSMOOTH_BACKEND")
    return Diagnosis("what computes", built, "compiled C" if built else "NumPy")


def _own_kernels() -> Diagnosis:
    from nonsmooth.runtime.model.loading.background import lacking
    from nonsmooth.runtime.model.loading.compiling import compiler

    reason = lacking()
    if reason is None:
        command = shutil.which(compiler()[0])
        return Diagnosis("kernels of your own systems", True, f"compiled by {command}")
    remedy = (
        "install a C compiler and Python's headers (gcc and python3-dev on Debian and Ubuntu)"
        if os.name == "posix"
        else f"{_NAME} generate FILE.py --out DIR --compile"
    )
    return Diagnosis("kernels of your own systems", False, f"run on NumPy: {reason}", remedy)


def _cache() -> Diagnosis:
    from nonsmooth.runtime.model.loading.caching import cache_folder

    folder = cache_folder()
    if folder is not None:
        return Diagnosis("cache of derivations", True, str(folder))
    remedy = "set NONSMOOTH_CACHE to a folder that only you can write to"
    return Diagnosis("cache of derivations", False, "none: systems are derived each time", remedy)


def _threads() -> Diagnosis:
    names = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")
    set_to = [f"{name}={os.environ[name]}" for name in names if name in os.environ]
    return Diagnosis("threads", True, ", ".join([str(os.cpu_count() or 1), *set_to]))


def _latex() -> Diagnosis:
    found = next(filter(None, map(shutil.which, _LATEX)), None)
    if found:
        return Diagnosis("LaTeX", True, found)
    remedy = "install texlive-latex-recommended (Debian, Ubuntu), MacTeX (macOS) or MiKTeX"
    return Diagnosis("LaTeX", False, "none: equations cannot be written as PDF", remedy)


def _extra(extra: str) -> Diagnosis:
    packages = dict(_requirements(extra))
    states = {name: _installed(name, lowest) for name, lowest in packages.items()}
    lacking = [name for name, (_, good) in states.items() if not good]
    label = f"extra {extra}: {_EXTRAS[extra]}"
    if lacking:
        told = f"not there or too old: {', '.join(lacking)}"
        return Diagnosis(label, False, told, f'pip install "{_NAME}[{extra}]"')
    return Diagnosis(label, True, ", ".join(f"{name} {v}" for name, (v, _) in states.items()))


@command("doctor", "doctor", "doctor --json")
def doctor(*, reply: Reply) -> int:
    """Say what this installation has and lacks, and what to do about it."""
    found = list(diagnoses())
    told = {"version": metadata.version(_NAME), "diagnoses": [asdict(each) for each in found]}
    return reply.show(lambda: told, lambda: _show(found))


def _show(found: list[Diagnosis]) -> None:
    from rich.text import Text

    from nonsmooth.runtime.cli.display import console_as_wide

    out = partial(console_as_wide().print, soft_wrap=True)
    widest = max(len(diagnosis.name) for diagnosis in found)
    for diagnosis in found:
        sign = Text("ok  ", "green") if diagnosis.good else Text("-   ", "yellow")
        out(Text.assemble(sign, f"{diagnosis.name:{widest}}  {diagnosis.found}"))
        if diagnosis.remedy and not diagnosis.good:
            out(Text(f"{'':{widest + 6}}do: {diagnosis.remedy}"))
