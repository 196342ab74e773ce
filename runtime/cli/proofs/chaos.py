"""The command that proves chaos."""

from __future__ import annotations

from typing import Annotated

import typer

from nonsmooth.runtime.cli.application import (
    ANSWERED,
    NOT_MET,
    UNANSWERED,
    answering,
    app,
    assignments,
    check_drawing,
    split,
)
from nonsmooth.runtime.cli.keeping import Overwrite, check_new, kept_of, say, worked
from nonsmooth.runtime.cli.options import (
    AsJson,
    Physical,
    Plot,
    SaveResult,
    Start,
    SystemName,
    missing_start,
)
from nonsmooth.runtime.cli.proofs.certifying import Proven
from nonsmooth.runtime.cli.written import Written

__all__ = ["chaos"]


@app.command(
    epilog="Examples:\n\n"
    "nonsmooth chaos dry-friction chi=0.34 eta=2.88 V=1.23 us1=0.75 us2=1.19 ur1=2.04 ur2=1.83"
    " --from x1=1.93,x2=7.18,v1=1.18,v2=1.18 --exponents --save chaos.json --plot chaos.png\n\n"
    "nonsmooth chaos impact_oscillator.py r=0.65 sigma=0 w=2.8 --from x=-0.5,v=0.1"
    " --require proved"
)
@answering
def chaos(
    system: SystemName,
    parameters: Physical = None,
    start: Start = None,
    configuration: Annotated[
        str | None,
        typer.Option(
            "--in", metavar="NAME", help="The configuration it starts in; found if not given."
        ),
    ] = None,
    iterates: Annotated[
        int, typer.Option("--iterates", min=1, metavar="N", help="The largest power of the map.")
    ] = 8,
    attempts: Annotated[
        int,
        typer.Option("--attempts", min=1, metavar="N", help="How many candidates to try to prove."),
    ] = 12,
    parts: Annotated[
        int, typer.Option("--parts", metavar="N", help="Parts of one set, at most.")
    ] = 3000,
    exponents: Annotated[
        bool,
        typer.Option("--exponents", help="Bound Lyapunov exponents too, by a cone condition."),
    ] = False,
    require: Annotated[
        Proven | None, typer.Option("--require", help="Exit with 3 unless chaos is proved.")
    ] = None,
    save: SaveResult = None,
    plot: Plot = None,
    overwrite: Overwrite = False,
    as_json: AsJson = False,
) -> int:
    """Prove that motions are chaotic: sets that cover each other, and the entropy that follows.

    Looks along the motion from the start. The exit code is 1 if nothing is found and proved.
    `certify --check` proves what is saved again.
    """
    from nonsmooth.runtime.cli.display import counted
    from nonsmooth.runtime.cli.tables import show_result
    from nonsmooth.runtime.proof.chaos.certify_chaos import certify_chaos

    if not start:
        raise missing_start(system)
    check_drawing(plot)
    check_new(save, overwrite)
    values, state = assignments("parameter", parameters or []), assignments("state", split(start))
    with counted("enclosing images") as progress:
        found, stopped = worked(
            lambda: certify_chaos(
                system,
                values,
                state,
                configuration,
                iterates=iterates,
                attempts=attempts,
                parts=parts,
                exponents=exponents,
                progress=progress,
            )
        )
    written = Written()
    written.save(found.save, save)
    if plot is not None and found.proved:
        written.draw(found.plot, plot)
    code = written.show(found.to_json, lambda: show_result(found), as_json=as_json)
    if plot is not None and not found.proved:
        say("no picture: nothing is proved")
    if stopped:
        return kept_of("chaos is proved, no exponents", written.kept(save), resumes=False)
    if require is not None and not found.proved:
        say(f"required: proved; found: chaos {found.claim}")
        return NOT_MET
    return code or (ANSWERED if found.proved else UNANSWERED)
