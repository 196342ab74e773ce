"""The command that charts."""

from __future__ import annotations

import math
import shlex
from pathlib import Path
from typing import Annotated, Any

import typer

from nonsmooth.runtime.cli.command import command
from nonsmooth.runtime.cli.completion import complete_orbits
from nonsmooth.runtime.cli.keeping import interrupted
from nonsmooth.runtime.cli.options import Start, Workers, Yes, missing_start, option, parameters_as
from nonsmooth.runtime.cli.parsing import assignments, grid, split, values_and_ranges
from nonsmooth.runtime.cli.reply import Reply
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.workload import BYTES, check_hours, check_memory

TRANSITIONS = 2000
MOST_COUNTED = 20_000_000  # points that the summary reads again


@command(
    "chart",
    "chart dry-friction/global-stick V=0.8:1.3:400 eta=0.8:1.3:400 --out F.zarr",
    "chart dry-friction/global-stick V=0.8:1.3:5000 chi=0.45 --chunk 1000 --out line.zarr",
    "chart dry-friction V=0.2:1.2:20 eta=1:5:20 chi=0.4 us1=0.0127 ur1=0.0255 us2=0.5 ur2=1"
    " --from x1=0,x2=0,v1=0,v2=0 --out A.zarr",
    "chart found.json x=-3:0:40 v=-2:2:40 --out basins.zarr",
)
def chart(
    name: Annotated[
        str,
        typer.Argument(
            autocompletion=complete_orbits,
            metavar="ORBIT",
            help="As for `solve`. A SYSTEM with --from: where motions settle, by brute force."
            " A file that `find --save` wrote: the basins of all that it holds, over states."
            " A chart F.zarr that is begun goes on, from what it holds.",
        ),
    ],
    parameters: Annotated[
        list[str] | None,
        parameters_as(
            "NAME=A:B:N|VALUE",
            "Ranges become the dimensions; values are fixed; absent ones take defaults"
            " (docs/parameters.md).",
        ),
    ] = None,
    out: Annotated[
        Path | None,
        option("--out", "Folder of the chart, begun or gone on with.", "F.zarr"),
    ] = None,
    scheduler: Annotated[
        str | None,
        option("--scheduler", "Of a Dask cluster: tcp://host:8786.", "ADDRESS"),
    ] = None,
    chunk: Annotated[
        int | None,
        option("--chunk", "About how many points at a time.", "N"),
    ] = None,
    workers: Workers = None,
    start: Start = None,
    transitions: Annotated[
        int | None,
        option("--transitions", f"After which they are looked at; {TRANSITIONS} by default.", "N"),
    ] = None,
    yes: Yes = False,
    *,
    reply: Reply,
) -> int:
    """Chart the parameter plane: where an orbit is a motion, which limit fails first; or basins."""
    from numpy import linspace

    from nonsmooth.runtime.cli.display import counted, steps
    from nonsmooth.runtime.explore.charting.chart import (
        begun_problem,
        chart_problem,
        is_begun,
        load_chart,
        reading,
        work_on,
    )
    from nonsmooth.runtime.explore.charting.classes import counts_of
    from nonsmooth.runtime.explore.charting.problem import is_found
    from nonsmooth.runtime.explore.charting.store import check_zarr
    from nonsmooth.runtime.model.kernels import system_names

    check_zarr()
    begun = is_begun(name)
    if begun and (parameters or out or start):
        raise InputError(f"{name} is a chart that is begun: it holds all that it is of")
    if not begun and out is None:
        raise InputError("--out F.zarr is missing")
    out = out or Path(name)
    values, ranged = values_and_ranges(parameters, "A:B:N")
    given: dict[str, Any] = {**values}
    for n, (low, high, count) in grid(ranged).items():
        check_memory(f"{count} values of {n}", BYTES * count)
        given[n] = linspace(low, high, count)
    if workers is not None and scheduler is not None:
        raise InputError("--workers is for this machine: leave it out with --scheduler")
    simulate = bool(start) and not is_found(name)
    if transitions is not None and not simulate:
        raise InputError("--transitions is for the motions of a SYSTEM from --from")
    if not start and name in system_names():
        raise missing_start(name)
    begin = assignments("state", split(start)) if start else None
    with steps(f"preparing {name}"):  # kernels that are compiled first take seconds
        if begun:
            problem, axes = begun_problem(out)
        else:
            problem, axes = chart_problem(name, given, simulate, begin, transitions or TRANSITIONS)
    points = math.prod(map(len, axes.values()))
    check_hours(f"{points} points", points * problem.seconds, yes=yes)
    done = 0, 0

    def note(computed: int, total: int) -> None:
        nonlocal done
        done = computed, total
        progress(computed, total)

    try:
        with counted(f"charting {name}") as progress:
            work = work_on(out, problem, axes, scheduler, chunk, workers, note)
    except KeyboardInterrupt:
        kept = f"{done[0]} of {done[1] or 'all'} chunks are kept in {out}"
        beside = [
            word
            for option, value in (("--scheduler", scheduler), ("--workers", workers))
            if value is not None
            for word in (option, str(value))
        ]
        beside += [flag for flag, said in (("--yes", yes), ("--json", reply.as_json)) if said]
        goes_on = shlex.join(["nonsmooth", "chart", str(out), *beside])
        return interrupted(kept, f"go on with: {goes_on}")
    dataset = load_chart(out)
    countable = int(dataset.status.size) <= MOST_COUNTED
    with reading(out):
        classes = {k: n for k, n in counts_of(dataset).items() if n} if countable else None
    told = {
        "name": name,
        "file": str(out),
        "dimensions": {str(n): int(size) for n, size in dataset.sizes.items()},
        "variables": [str(n) for n in dataset.data_vars],
        "chunks": work.chunks,
        "computed": work.computed,
        "damaged": work.damaged,
        "leftovers": work.leftovers,
        "points": classes,
    }
    return reply.show(lambda: told, lambda: _show(told))


def _show(told: dict[str, Any]) -> None:
    from nonsmooth.runtime.model.naming import shown_name

    size = " x ".join(f"{name} {count}" for name, count in told["dimensions"].items())
    print(f"{shown_name(told['name'])}: {size}")
    for kind, count in (told["points"] or {}).items():
        print(f"  {_WORDS.get(kind, kind):28} {count:>12,}")
    repaired = f", {told['damaged']} of them damaged before" if told["damaged"] else ""
    print(f"{told['computed']} of {told['chunks']} chunks computed{repaired}")
    print(f"{told['file']} written; nonsmooth plot {told['file']} draws it")


_WORDS = {  # for points of charts that are not called by their kind
    "limit": "not admissible",
    "none": "none found",
    "missing": "not computed",
    "other": "not periodic",
}
