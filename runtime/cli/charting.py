"""The command that charts."""

from __future__ import annotations

import math
import shlex
from pathlib import Path
from typing import Annotated, Any

import typer

from nonsmooth.runtime.cli.application import (
    ANSWERED,
    answering,
    app,
    assignments,
    print_json,
    ranges,
    split,
)
from nonsmooth.runtime.cli.keeping import interrupted
from nonsmooth.runtime.cli.options import AsJson, Start, Yes, missing_start
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.workload import check_hours

__all__ = ["chart"]

TRANSITIONS = 2000
MOST_COUNTED = 20_000_000  # points that the summary reads again


@app.command(
    epilog="Examples:\n\n"
    "nonsmooth chart dry-friction/global-stick V=0.8:1.3:400 eta=0.8:1.3:400 --out F.zarr\n\n"
    "nonsmooth chart dry-friction/global-stick V=0.8:1.3:5000 chi=0.45 --chunk 1000"
    " --out line.zarr\n\n"
    "nonsmooth chart dry-friction --simulate V=0.2:1.2:20 eta=1:5:20 chi=0.4 us1=0.0127"
    " ur1=0.0255 us2=0.5 ur2=1 --from x1=0,x2=0,v1=0,v2=0 --out A.zarr\n\n"
    "nonsmooth chart found.json x=-3:0:40 v=-2:2:40 --out basins.zarr"
)
@answering
def chart(
    name: Annotated[
        str,
        typer.Argument(
            metavar="ORBIT",
            help="As for `solve`; with --simulate a SYSTEM, as for `simulate`. A file that"
            " `find --save` wrote: the basins of all that it holds, over states. A chart F.zarr"
            " that is begun goes on, from what it holds.",
        ),
    ],
    parameters: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="NAME=A:B:N|VALUE",
            help="Ranges become the dimensions; values are fixed; absent ones take defaults"
            " (docs/parameters.md).",
            show_default=False,
        ),
    ] = None,
    out: Annotated[
        Path | None,
        typer.Option("--out", metavar="F.zarr", help="Folder of the chart, begun or gone on with."),
    ] = None,
    scheduler: Annotated[
        str | None,
        typer.Option("--scheduler", metavar="ADDRESS", help="Of a Dask cluster: tcp://host:8786."),
    ] = None,
    chunk: Annotated[
        int | None,
        typer.Option("--chunk", metavar="N", help="About how many points at a time."),
    ] = None,
    threads: Annotated[
        int | None,
        typer.Option("--threads", metavar="N", help="As many as processors by default."),
    ] = None,
    simulate: Annotated[
        bool, typer.Option("--simulate", help="Where motions settle, by brute force.")
    ] = False,
    start: Start = None,
    transitions: Annotated[
        int | None,
        typer.Option(
            "--transitions",
            metavar="N",
            help=f"After which they are looked at; {TRANSITIONS} by default.",
        ),
    ] = None,
    yes: Yes = False,
    as_json: AsJson = False,
) -> int:
    """Chart the parameter plane: where an orbit is a motion, which limit fails first; or basins."""
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
    from nonsmooth.runtime.explore.charting.grid import linear_axis
    from nonsmooth.runtime.explore.charting.store import check_zarr

    check_zarr()
    begun = is_begun(name)
    if begun and (parameters or out or simulate or start):
        raise InputError(f"{name} is a chart that is begun: it holds all that it is of")
    if not begun and out is None:
        raise InputError("--out F.zarr is missing")
    out = out or Path(name)
    given: dict[str, Any] = {}
    for text in parameters or []:
        swept = ":" in text
        one = (
            ranges("parameter", [text], counts=True) if swept else assignments("parameter", [text])
        )
        for parameter, value in one.items():
            if parameter in given:
                raise InputError(f"parameter {parameter} is given twice")
            given[parameter] = linear_axis(parameter, *value) if isinstance(value, tuple) else value
    if threads is not None and scheduler is not None:
        raise InputError("--threads is for this machine: leave it out with --scheduler")
    if transitions is not None and not simulate:
        raise InputError("--transitions is for the motions of --simulate, which is missing")
    if simulate and not start:
        raise missing_start(name)
    begin = assignments("state", split(start)) if start else None
    with steps(f"preparing {name}"):  # kernels that are compiled first take seconds
        if begun:
            problem, axes = begun_problem(out)
        else:
            problem, axes = chart_problem(name, given, simulate, begin, transitions or TRANSITIONS)
    points = math.prod(axis.count for axis in axes)
    check_hours(f"{points} points", points * problem.seconds, yes=yes)
    done = 0, 0

    def count(computed: int, total: int) -> None:
        nonlocal done
        done = computed, total
        progress(computed, total)

    try:
        with counted(f"charting {name}") as progress:
            work = work_on(out, problem, axes, scheduler, chunk, threads, count)
    except KeyboardInterrupt:
        kept = f"{done[0]} of {done[1] or 'all'} chunks are kept in {out}"
        beside = [
            word
            for option, value in (("--scheduler", scheduler), ("--threads", threads))
            if value is not None
            for word in (option, str(value))
        ]
        beside += [flag for flag, said in (("--yes", yes), ("--json", as_json)) if said]
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
    if as_json:
        print_json(told)
    else:
        _show(told)
    return ANSWERED


def _show(told: dict[str, Any]) -> None:
    from nonsmooth.runtime.model.naming import shown_name

    size = " x ".join(f"{name} {count}" for name, count in told["dimensions"].items())
    print(f"{shown_name(told['name'])}: {size}")
    for kind, count in (told["points"] or {}).items():
        print(f"  {_KINDS.get(kind, kind):28} {count:>12,}")
    repaired = f", {told['damaged']} of them damaged before" if told["damaged"] else ""
    print(f"{told['computed']} of {told['chunks']} chunks computed{repaired}")
    print(f"{told['file']} written; nonsmooth plot {told['file']} draws it")


_KINDS = {
    "stable": "stable",
    "neutral": "neutral",
    "unstable": "unstable",
    "admissible": "admissible",
    "limit": "not admissible",
    "none": "none found",
    "missing": "not computed",
    "periodic": "periodic",
    "rest": "rest",
    "other": "not periodic",
}
