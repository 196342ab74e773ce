"""The command that fits parameters to measurements."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Annotated, Any

from nonsmooth.runtime.cli.command import command
from nonsmooth.runtime.cli.keeping import worked
from nonsmooth.runtime.cli.options import Save, Seed, Start, SystemName, Yes, option, parameters_as
from nonsmooth.runtime.cli.parsing import (
    Range,
    assignments,
    split,
    texts_by_name,
    values_and_ranges,
)
from nonsmooth.runtime.cli.reply import Reply
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.workload import SECONDS, check_hours

_DATA = re.compile(r"(?P<file>.+\.(?:csv|npz|nc|zarr))/?(?::(?P<known>.*))?", re.IGNORECASE)
_PRIOR = re.compile(r"(?P<mean>.+?)\s*(?:\+-|±)\s*(?P<deviation>.+)")


@command(
    "fit",
    "fit identification.py impacts.csv c=0.05 h=0.2 w=2.1 k=2.3:2.7 r=0.7:1"
    " v0=-0.3:0.3 --from x=-0.6 --starts 4 --plot fit.png --save fit.json",
    "fit identification.py impacts.csv:w=2.1 c=0.05 h=0.2 k=2:2.5:3 r=0.5:0.8:1"
    " --from x=-0.6,v=0.1 --sigma 0.002 --prior k=2.5+-0.1 --loss soft_l1",
    "fit identification.py sweep.csv c=0.05 h=0.2 k=2:3 r=0.6:1"
    " --responses A=amplitude:x --plot response.png",
    save=Save,
    plot=True,
    long=True,
)
def fit(
    system: SystemName,
    given: Annotated[
        list[str] | None,
        parameters_as(
            "DATA|NAME=VALUE|NAME=A:B",
            "Files of measurements, .csv, .npz, .nc or .zarr, each with what is known in it"
            " alone: slow.csv:V=1.2. Parameters with a value are known, those with a range are"
            " sought in it: r=0.5:1, or from a guess, r=0.5:0.8:1; an end may be blank. So are"
            " states at the start, x10=-1:1, and offset=-1:1, what the clock shows there.",
        ),
    ] = None,
    start: Start = None,
    outputs: Annotated[
        list[str] | None,
        option(
            "--outputs",
            "What columns measure: gap=x1-x2, a=acceleration:x1, f=force:wall. One with a"
            " state's name is that state.",
            "COLUMN=EXPRESSION,...",
        ),
    ] = None,
    responses: Annotated[
        list[str] | None,
        option(
            "--responses",
            "What columns measure of steady responses, each row at the parameters in its other"
            " columns: A=amplitude:x1. Kinds: maximum, minimum, peak, amplitude, mean, rms, and of"
            " the first harmonic harmonic and phase. A column with such a name needs no mention.",
            "COLUMN=KIND:OUTPUT,...",
        ),
    ] = None,
    events: Annotated[
        list[str] | None,
        option(
            "--events",
            "Columns with the times at which boundaries are reached: hits=wall-reaches-stop,"
            " or `wall` for a column of this name or a file that has one column. One with a"
            " boundary's name needs no mention.",
            "NAME,...",
        ),
    ] = None,
    sigma: Annotated[
        list[str] | None,
        option(
            "--sigma",
            "Standard deviations, or one for all columns; estimated if not given, here or as"
            " columns sigma_NAME.",
            "COLUMN=VALUE,...",
        ),
    ] = None,
    prior: Annotated[
        list[str] | None,
        option("--prior", "What is known before: k=10+-1.", "NAME=MEAN+-SIGMA,..."),
    ] = None,
    loss: Annotated[
        str,
        option("--loss", "linear; or soft_l1, huber or cauchy, which heed outliers less.", "NAME"),
    ] = "linear",
    starts: Annotated[
        int,
        option("--starts", "Searches: from the guess, and from random points.", "N", min=1),
    ] = 1,
    seed: Seed = 0,
    yes: Yes = False,
    *,
    reply: Reply,
) -> int:
    """Find parameters, starts and clocks from measured series, event times or responses."""
    from nonsmooth.runtime.cli.display import counted
    from nonsmooth.runtime.explore.fitting.fit import fit as find
    from nonsmooth.runtime.explore.fitting.measurements import Experiment
    from nonsmooth.runtime.present.pictures.fits import fit_figure

    files, texts = _sorted(given or [])
    if not files:
        raise InputError("data are missing: name a file that ends in .csv, .npz, .nc or .zarr")
    values, ranged = values_and_ranges(texts, "A:B", "A:GUESS:B", blank=True)
    free: dict[str, Range] = {
        name: (low, guess[0] if guess else None, high)
        for name, (low, *guess, high) in ranged.items()
    }
    known: dict[str, Any] = dict(values)
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
                outputs=texts_by_name("output", split(outputs)),
                events=_events(events),
                responses=texts_by_name("response", split(responses)),
                sigma=_sigma(sigma),
                loss=loss,
                starts=starts,
                rng=seed,
                progress=progress,
            )
        )
    return reply.give(
        found,
        stopped,
        figure=lambda: fit_figure(found),
        done="the best fit until then is found",
        enough=found.status == "converged",
    )


def _sorted(given: Sequence[str]) -> tuple[list[tuple[str, str]], list[str]]:
    """Files of data with the text of what is known in each, and the other texts."""
    files: list[tuple[str, str]] = []
    texts: list[str] = []
    for text in given:
        name, equals, _ = text.partition("=")
        if equals and name.strip().isidentifier():
            texts.append(text)
        elif found := _DATA.fullmatch(text):
            files.append((found["file"], found["known"] or ""))
        else:
            raise InputError(f"{text!r} is neither NAME=VALUE nor a .csv, .npz, .nc or .zarr file")
    return files, texts


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
        if name in names and guess is not None:
            known[name] = guess
        elif name in starts and guess is not None:
            state[starts[name]] = guess


def _events(options: Sequence[str] | None) -> dict[str, str]:
    """Name of the boundary by the column that holds its times; both agree where one is given."""
    return texts_by_name(
        "event", [text if "=" in text else f"{text}={text}" for text in split(options)]
    )


def _sigma(options: Sequence[str] | None) -> dict[str, float] | float | None:
    from nonsmooth.runtime.core.values import parse

    texts = split(options)
    if not texts:
        return None
    if len(texts) == 1 and "=" not in texts[0]:
        return float(parse(texts[0]))
    return {name: float(parse(value)) for name, value in texts_by_name("sigma", texts).items()}


def _priors(options: Sequence[str] | None) -> dict[str, tuple[Any, Any]]:
    from nonsmooth.runtime.core.values import parse

    found = {}
    for name, text in texts_by_name("prior", split(options)).items():
        parts = _PRIOR.fullmatch(text)
        if parts is None:
            raise InputError(f"the prior {name}={text} is not NAME=MEAN+-SIGMA")
        found[name] = parse(parts["mean"]), parse(parts["deviation"])
    return found
