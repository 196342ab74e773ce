"""The command that fits parameters to measurements."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Annotated, Any

import typer

from nonsmooth.runtime.cli.application import (
    ANSWERED,
    UNANSWERED,
    answering,
    app,
    assignments,
    check_drawing,
    split,
)
from nonsmooth.runtime.cli.keeping import Overwrite, check_new, kept_of, worked
from nonsmooth.runtime.cli.options import AsJson, Plot, SaveResult, Start, SystemName, Yes
from nonsmooth.runtime.cli.written import Written
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.workload import SECONDS, check_hours

__all__ = ["fit"]

_DATA = re.compile(r"(?P<file>.+\.(?:csv|npz|nc|zarr))/?(?::(?P<known>.*))?", re.IGNORECASE)
_PRIOR = re.compile(r"(?P<mean>.+?)\s*(?:\+-|±)\s*(?P<deviation>.+)")


@app.command(
    epilog="Examples:\n\n"
    "nonsmooth fit identification.py impacts.csv c=0.05 h=0.2 w=2.1 k=2.3:2.7 r=0.7:1"
    " v0=-0.3:0.3 --from x=-0.6 --starts 4 --plot fit.png --save fit.json\n\n"
    "nonsmooth fit identification.py impacts.csv:w=2.1 c=0.05 h=0.2 k=2:2.5:3 r=0.5:0.8:1"
    " --from x=-0.6,v=0.1 --sigma 0.002 --prior k=2.5+-0.1 --loss soft_l1\n\n"
    "nonsmooth fit identification.py sweep.csv c=0.05 h=0.2 k=2:3 r=0.6:1"
    " --responses A=amplitude:x --plot response.png"
)
@answering
def fit(
    system: SystemName,
    given: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="DATA|NAME=VALUE|NAME=A:B",
            help="Files of measurements, .csv, .npz, .nc or .zarr, each with what is known in it"
            " alone: slow.csv:V=1.2. Parameters with a value are known, those with a range are"
            " sought in it: r=0.5:1, or from a guess, r=0.5:0.8:1; an end may be blank. So are"
            " states at the start, x10=-1:1, and offset=-1:1, what the clock shows there.",
            show_default=False,
        ),
    ] = None,
    start: Start = None,
    outputs: Annotated[
        list[str] | None,
        typer.Option(
            "--outputs",
            metavar="COLUMN=EXPRESSION,...",
            help="What columns measure: gap=x1-x2, a=acceleration:x1, f=force:wall. One with a"
            " state's name is that state.",
        ),
    ] = None,
    responses: Annotated[
        list[str] | None,
        typer.Option(
            "--responses",
            metavar="COLUMN=KIND:OUTPUT,...",
            help="What columns measure of steady responses, each row at the parameters in its other"
            " columns: A=amplitude:x1. Kinds: maximum, minimum, peak, amplitude, mean, rms, and of"
            " the first harmonic harmonic and phase. A column with such a name needs no mention.",
        ),
    ] = None,
    events: Annotated[
        list[str] | None,
        typer.Option(
            "--events",
            metavar="NAME,...",
            help="Columns with the times at which boundaries are reached: hits=wall-reaches-stop,"
            " or `wall` for a column of this name or a file that has one column. One with a"
            " boundary's name needs no mention.",
        ),
    ] = None,
    sigma: Annotated[
        list[str] | None,
        typer.Option(
            "--sigma",
            metavar="COLUMN=VALUE,...",
            help="Standard deviations, or one for all columns; estimated if not given, here or as"
            " columns sigma_NAME.",
        ),
    ] = None,
    prior: Annotated[
        list[str] | None,
        typer.Option(
            "--prior", metavar="NAME=MEAN+-SIGMA,...", help="What is known before: k=10+-1."
        ),
    ] = None,
    loss: Annotated[
        str,
        typer.Option(
            "--loss",
            metavar="NAME",
            help="linear; or soft_l1, huber or cauchy, which heed outliers less.",
        ),
    ] = "linear",
    starts: Annotated[
        int,
        typer.Option(
            "--starts", min=1, metavar="N", help="Searches: from the guess, and from random points."
        ),
    ] = 1,
    seed: Annotated[int, typer.Option("--seed", metavar="N", help="Of the random points.")] = 0,
    plot: Plot = None,
    save: SaveResult = None,
    overwrite: Overwrite = False,
    yes: Yes = False,
    as_json: AsJson = False,
) -> int:
    """Find parameters, starts and clocks from measured series, event times or responses."""
    from nonsmooth.runtime.cli.display import counted
    from nonsmooth.runtime.cli.tables import show_result
    from nonsmooth.runtime.explore.fitting.fit import fit as find
    from nonsmooth.runtime.explore.fitting.measurements import Experiment

    check_drawing(plot)
    check_new(save, overwrite)
    files, fixed, ranged = _sorted(given or [])
    if not files:
        raise InputError("data are missing: name a file that ends in .csv, .npz, .nc or .zarr")
    free = _free(ranged)
    known: dict[str, Any] = dict(assignments("parameter", fixed))
    offset = known.pop("offset", 0.0)
    state: dict[str, Any] = dict(assignments("state", split(start)))
    _take_guesses(system, free, known, state)
    if free.get("offset", (None, None, None))[1] is not None:
        offset = free["offset"][1]
    data = [
        Experiment(data=path, parameters=assignments("parameter", split([own])), name=path)
        for path, own in files
    ]
    check_hours(f"{starts} starts", starts * SECONDS["fit"], yes=yes)
    with counted("fitting", starts) as progress:
        found, stopped = worked(
            lambda: find(
                system,
                data,
                parameters=known,
                free=list(free),
                bounds={name: (low, high) for name, (low, _, high) in free.items()},
                priors=_priors(prior),
                start=state,
                offset=offset,
                outputs=_texts("output", outputs),
                events=_events(events),
                responses=_texts("response", responses),
                sigma=_sigma(sigma),
                loss=loss,
                starts=starts,
                rng=seed,
                progress=progress,
            )
        )
    written = Written()
    written.save(found.save, save)
    if plot is not None:
        from nonsmooth.runtime.present.pictures.fits import fit_figure

        written.draw(lambda: fit_figure(found), plot)
    code = written.show(found.to_json, lambda: show_result(found), as_json=as_json)
    if stopped:
        return kept_of("the best fit until then is found", written.kept(save), resumes=False)
    return code or (ANSWERED if found.status == "converged" else UNANSWERED)


def _sorted(given: Sequence[str]) -> tuple[list[tuple[str, str]], list[str], list[str]]:
    """Files of data with the text of what is known in each, fixed parameters, and ranges."""
    files: list[tuple[str, str]] = []
    fixed: list[str] = []
    ranged: list[str] = []
    for text in given:
        name, equals, value = text.partition("=")
        if equals and name.strip().isidentifier():
            (ranged if ":" in value else fixed).append(text)
        elif found := _DATA.fullmatch(text):
            files.append((found["file"], found["known"] or ""))
        else:
            raise InputError(f"{text!r} is neither NAME=VALUE nor a .csv, .npz, .nc or .zarr file")
    return files, fixed, ranged


Range = tuple[Any, Any, Any]  # lower end, guess, upper end; None for none


def _free(texts: Sequence[str]) -> dict[str, Range]:
    """Range (lower, guess, upper) by name, from ``name=lower:upper`` or with a guess between.

    An end may be blank: it is None, as a missing guess is.
    """
    from nonsmooth.runtime.core.values import parse

    found: dict[str, Range] = {}
    for text in texts:
        name, _, value = text.partition("=")
        name, parts = name.strip(), [part.strip() for part in value.split(":")]
        if name in found:
            raise InputError(f"parameter {name} is given twice")
        if len(parts) not in (2, 3):
            raise InputError(f"{text!r} is not NAME=A:B or NAME=A:GUESS:B")
        low, high = (parse(part) if part else None for part in (parts[0], parts[-1]))
        guess = parse(parts[1]) if len(parts) == 3 and parts[1] else None
        found[name] = low, guess, high
    return found


def _take_guesses(
    system: str, free: dict[str, Range], known: dict[str, Any], state: dict[str, Any]
) -> None:
    """Enter guesses of parameters into `known` and those of starting states into `state`.

    A start that has only a range gets none.
    """
    from nonsmooth.runtime.model.kernels import kernels_of
    from nonsmooth.runtime.model.naming import start_names
    from nonsmooth.runtime.model.structure import structure_of

    kernels = kernels_of(system)
    names = [table.name for table in kernels.parameters]
    states = structure_of(kernels).states
    starts = dict(zip(start_names(states, names), states, strict=True))
    for name, (_, guess, _) in free.items():
        if name in known:
            raise InputError(f"parameter {name} is given twice")
        if name in names and guess is not None:
            known[name] = guess
        elif name in starts and guess is not None:
            state[starts[name]] = guess


def _texts(what: str, options: Sequence[str] | None) -> dict[str, str]:
    """Texts by name, parsed from options ``NAME=TEXT``; `what` names the option in messages."""
    found: dict[str, str] = {}
    for text in split(options):
        name, equals, value = (part.strip() for part in text.partition("="))
        if not (name and equals and value):
            raise InputError(f"{text!r} is not NAME={what.upper()}")
        if name in found:
            raise InputError(f"{what} {name} is given twice")
        found[name] = value
    return found


def _events(options: Sequence[str] | None) -> dict[str, str]:
    """Name of the boundary by the column that holds its times; both agree where one is given."""
    return _texts("event", [text if "=" in text else f"{text}={text}" for text in split(options)])


def _sigma(options: Sequence[str] | None) -> dict[str, float] | float | None:
    from nonsmooth.runtime.core.values import parse

    texts = split(options)
    if not texts:
        return None
    if len(texts) == 1 and "=" not in texts[0]:
        return float(parse(texts[0]))
    return {name: float(parse(value)) for name, value in _texts("sigma", texts).items()}


def _priors(options: Sequence[str] | None) -> dict[str, tuple[Any, Any]]:
    from nonsmooth.runtime.core.values import parse

    found = {}
    for name, text in _texts("prior", options).items():
        parts = _PRIOR.fullmatch(text)
        if parts is None:
            raise InputError(f"the prior {name}={text} is not NAME=MEAN+-SIGMA")
        found[name] = parse(parts["mean"]), parse(parts["deviation"])
    return found
