"""What a shell completes: orbits, systems, parameters and saved files."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path

import typer

from nonsmooth.runtime.core.errors import NonsmoothError

_SAVED = (".json", ".npz", ".csv", ".zarr")  # endings of what commands save


def _beginning(names: Iterable[str], incomplete: str) -> list[str]:
    return [name for name in names if name.startswith(incomplete)]


def complete_systems(incomplete: str) -> list[str]:
    """Names of built-in systems, and files that may declare one."""
    from nonsmooth.runtime.model.kernels import system_names

    return _beginning((*system_names(), *_files(incomplete, (".py",))), incomplete)


def complete_orbits(incomplete: str) -> list[str]:
    """Names of built-in orbits, files that may hold some, and the orbits of a file with a colon.

    To know the orbits of ``FILE.py`` the file is run, as the command itself runs it.
    """
    from nonsmooth.runtime.model.kernels import orbit_names

    file, colon, _ = incomplete.rpartition(":")
    if colon and Path(file).exists():
        return _beginning(_answered(lambda: _orbits_of(file)), incomplete)
    files = _files(incomplete, (".py", ".json"))
    return _beginning((*orbit_names(), *files), incomplete)


def complete_files(incomplete: str) -> list[str]:
    """Files that commands save, and folders on the way to them."""
    return _beginning(_files(incomplete, _SAVED), incomplete)


def complete_assignments(context: typer.Context, incomplete: str) -> list[str]:
    """``NAME=`` of each parameter of the orbit or system that is named before.

    Bash breaks words at colons: behind ``FILE.py :`` these are the orbits of the file.
    """
    words = (context.params.get(name) for name in ("orbit", "system", "name"))
    named = next(filter(None, words), None)
    if named is None:
        return []
    given = list(context.params.get("parameters") or ())
    if incomplete == ":" or given[-1:] == [":"]:
        names = _answered(lambda: _orbits_of(named))
        return _beginning((name.rpartition(":")[2] for name in names), incomplete.strip(":"))
    known = {text.partition("=")[0] for text in given}
    names = _answered(lambda: _parameters_of(named))
    return _beginning((f"{name}=" for name in names if name not in known), incomplete)


def _parameters_of(name: str) -> list[str]:
    """Names of the parameters of an orbit, then those of its system in place of which they are."""
    from nonsmooth.runtime.model.kernels import is_saved, load_orbit, load_system, system_names

    if name in system_names() or not (is_saved(name) or "/" in name or ":" in name):
        return [parameter.name for parameter in load_system(name).parameters]
    orbit = load_orbit(name)
    own = orbit.parameters if "parameters" in orbit.table else ()
    return list(dict.fromkeys(each.name for each in (*own, *orbit.system.parameters)))


def _orbits_of(file: str) -> list[str]:
    """Names ``FILE:ORBIT`` of the orbits that a declaration or a saved file has."""
    from nonsmooth.runtime.model.kernels import is_saved, orbits_in

    if not is_saved(file):
        return list(orbits_in(file))
    from nonsmooth.runtime.present.files.named_entries import saved_listing

    return list(saved_listing(file)[1])


def _answered(names: Callable[[], list[str]]) -> list[str]:
    """The names, or none where a file is in no order: the command itself says so."""
    try:
        return names()
    except (NonsmoothError, OSError):
        return []


def _files(incomplete: str, endings: tuple[str, ...]) -> Iterator[str]:
    """Paths that begin with a text: files with one of the endings, and folders."""
    folder, _ = os.path.split(incomplete)
    try:
        entries = sorted(os.scandir(folder or "."), key=lambda entry: entry.name)
    except OSError:
        return
    for entry in entries:
        path = os.path.join(folder, entry.name)
        if entry.name.endswith(endings):
            yield path
        elif entry.is_dir() and not entry.name.startswith("."):
            yield f"{path}{os.sep}"
