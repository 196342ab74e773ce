"""The command that makes kernels of a user's own declaration."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated, Any

import typer

from nonsmooth.runtime.cli.application import (
    ANSWERED,
    answering,
    app,
    print_json,
)
from nonsmooth.runtime.cli.options import AsJson
from nonsmooth.runtime.cli.written import show_comparison
from nonsmooth.runtime.core.errors import InputError

__all__ = ["generate"]


@app.command(
    epilog="Examples:\n\n"
    "nonsmooth generate my_oscillator.py --out my_kernels\n\n"
    "nonsmooth generate my_oscillator.py --out my_kernels --compile\n\n"
    "nonsmooth generate my_oscillator.py --out my_kernels --check\n\n"
    "Then my_kernels is a SYSTEM, and my_kernels:ORBIT an orbit, for every command."
)
@answering
def generate(
    file: Annotated[
        Path,
        typer.Argument(
            metavar="FILE.py",
            help="A file that defines `system`, a System, and `orbits`, a list of Itinerary.",
        ),
    ],
    out: Annotated[
        Path, typer.Option("--out", metavar="DIR", help="Folder of the kernels, made if need be.")
    ],
    compiled: Annotated[
        bool, typer.Option("--compile", help="Build the kernels in C too; it takes a compiler.")
    ] = False,
    check: Annotated[
        bool, typer.Option("--check", help="Write nothing; exit with 1 if a file differs.")
    ] = False,
    as_json: AsJson = False,
) -> int:
    """Derive your own system and its orbits and write their kernels: Python, C, LaTeX."""
    from nonsmooth.runtime.cli.deriving import emit_file, file_differences
    from nonsmooth.runtime.cli.display import show_written, steps
    from nonsmooth.runtime.model.loading.compiling import compile_files
    from nonsmooth.runtime.model.loading.folder import check_own_folder, write_folder

    if check and compiled:
        raise InputError("--check writes nothing: leave out --compile")
    check_own_folder(out)
    with steps(f"reading {file}") as begin:
        emission = emit_file(file, begin)
        told: dict[str, Any] = {
            "folder": str(out),
            "system": emission.system,
            "orbits": [
                {"name": name, "derived": reason is None} | ({"reason": reason} if reason else {})
                for name, reason in emission.orbits.items()
            ],
        }
        if check:
            found = file_differences(out, emission)
        else:
            library = None
            if compiled:
                begin("compiling")
                library = compile_files(emission.files)
            written = [str(path) for path in write_folder(out, emission.files, library)]
    if check:
        return show_comparison(told, found, f"{file}: generate it again", as_json=as_json)
    if as_json:
        print_json({**told, "files": sorted(emission.files), "written": written})
        return ANSWERED
    for name, reason in emission.orbits.items():
        if reason is not None:
            print(f"{name}: composed numerically when it is asked for: {reason}", file=sys.stderr)
    show_written([f"{path} written" for path in written], f"{out}: nothing changed")
    return ANSWERED
