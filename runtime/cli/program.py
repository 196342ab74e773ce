"""The command line: orbits, their equations, pictures and kernels.

What is heavy is imported by the commands that need it; `motions` has the commands that
simulate.
"""

from __future__ import annotations

import gc
import os
import sys
import warnings
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Annotated, Any

import typer

from nonsmooth.runtime.cli import (  # noqa: F401 - their commands join the application
    charting,
    continuing,
    designing,
    doctor,
    fitting,
    generating,
    motions,
)
from nonsmooth.runtime.cli.application import (
    ANSWERED,
    NOT_MET,
    UNANSWERED,
    answering,
    app,
    assignments,
    print_json,
    split,
)
from nonsmooth.runtime.cli.keeping import say
from nonsmooth.runtime.cli.options import (
    AsJson,
    Assignments,
    Derivatives,
    Digits,
    DocumentPart,
    Format,
    Frequency,
    FrequencyIn,
    Given,
    Guess,
    Kind,
    OrbitName,
    Over,
    Quantity,
    RefiningArithmetic,
    Require,
    RequiredVerdict,
    Save,
    Unknown,
    known_orbits,
    known_systems,
)
from nonsmooth.runtime.cli.proofs import basin, certifying, chaos, graphs  # noqa: F401 - likewise
from nonsmooth.runtime.cli.written import Written, show_comparison
from nonsmooth.runtime.core.errors import InputError, unknown_name

__all__ = ["app", "main"]

REMEDY = "python scripts/regenerate.py"
_ALL = Kind("all")
_WORKING_DIGITS = 20  # at least: a verdict does not depend on how many digits are shown


def main(command: str | None = None) -> None:
    """Run the command line, or the one command of that name as a script."""
    if not sys.warnoptions:
        warnings.simplefilter("ignore")  # overflows and the like: answers say what they are
    os.environ["MPLBACKEND"] = "agg"  # pictures are files: what the user names is for windows
    # derivations make millions of small objects without cycles, and the same ones again
    os.environ.setdefault("SYMPY_CACHE_SIZE", "50000")
    gc.set_threshold(50_000, 20, 20)
    _open_streams()
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")
    group: Any = typer.main.get_command(app)
    if command is None:
        group(prog_name="nonsmooth")
    else:
        group.commands[command](prog_name=Path(sys.argv[0]).name)


def _open_streams() -> None:
    """Replace closed standard streams by the null device, which child processes inherit.

    Else the next file that is opened would get the number of such a stream.
    """
    for name, mode in (("stdin", "r"), ("stdout", "w"), ("stderr", "w")):
        if getattr(sys, name) is None:
            stream = open(os.devnull, mode, encoding="utf-8")  # noqa: SIM115 - as long as this runs
            os.set_inheritable(stream.fileno(), True)
            setattr(sys, name, stream)


@app.command(
    "list",
    epilog="Examples:\n\nnonsmooth list\n\nnonsmooth list my_oscillator.py\n\n"
    "nonsmooth list dry-friction --json",
)
@answering
def list_orbits(
    systems: Annotated[
        list[str] | None,
        typer.Argument(
            autocompletion=known_systems,
            metavar="SYSTEM",
            help="Only these: built-in ones, FILE.py, FILE.json, or a folder of `generate`.",
            show_default=False,
        ),
    ] = None,
    as_json: AsJson = False,
) -> int:
    """List systems and orbits, their parameters and unknowns."""
    from nonsmooth.runtime.present.report import systems_json

    found = systems_json(systems or ())
    if as_json:
        print_json(found)
    else:
        from nonsmooth.runtime.cli.display import show_list

        show_list(found["systems"], whole=bool(systems))
    return ANSWERED


@app.command(
    epilog="Examples:\n\n"
    "nonsmooth equations dry-friction/global-stick --format markdown\n\n"
    "nonsmooth equations dry-friction --out dry-friction.tex\n\n"
    "nonsmooth equations dry-friction/global-stick --section trace --format markdown\n\n"
    "nonsmooth equations dry-friction/global-stick --format pdf"
)
@answering
def equations(
    name: Annotated[
        str,
        typer.Argument(
            autocompletion=known_orbits,
            metavar="SYSTEM[/ORBIT]",
            help="A system or an orbit, or your own: FILE.py or FILE.py:ORBIT.",
        ),
    ],
    form: Annotated[Format, typer.Option("--format", help="What to write.")] = Format.LATEX,
    section: Annotated[
        DocumentPart | None, typer.Option(help="Write this part alone; a system has its flows.")
    ] = None,
    out: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Write this file; a PDF is SYSTEM-ORBIT.pdf by default."),
    ] = None,
    as_json: AsJson = False,
) -> int:
    """Derive a system or an orbit and write it down, from the declaration to the trace."""
    from nonsmooth.runtime.cli import deriving
    from nonsmooth.runtime.cli.display import steps
    from nonsmooth.runtime.core.files import check_target

    if out is None and form is Format.PDF:
        stem = Path(name).name if ".py" in name else name.replace("/", "-")
        out = Path(f"{stem.replace('.py', '').replace(':', '-')}.pdf")
    document = deriving.document_maker(name, section)
    if out is not None:
        check_target(out)
    with steps(f"deriving {name}") as begin:
        text = deriving.written(document(), form.value)
        if out is not None:
            begin(f"writing {out}")
            deriving.write_document(text, form.value, out)
    told = {"text": text} if out is None else {"file": str(out)}
    if as_json:
        print_json({"name": name, "format": form.value, **told})
    elif out is None:
        sys.stdout.write(text)
    else:
        print(f"{out} written")
    return ANSWERED


@app.command(
    epilog="Examples:\n\n"
    "nonsmooth solve dry-friction/global-stick eta=0.98 V=1.01\n\n"
    "nonsmooth solve dry-friction/global-stick us2=0.8 us1=1 --require admissible\n\n"
    "nonsmooth solve dry-friction/global-stick --unknown e1,e2 --given ta=1,tau=2\n\n"
    "nonsmooth solve dry-friction/global-stick --save orbit.json\n\n"
    "nonsmooth solve dry-friction/global-stick --derivatives eta,V\n\n"
    "nonsmooth solve found.json:1 Omega=2.5 --digits 30"
)
@answering
def solve(
    orbit: OrbitName,
    parameters: Assignments = None,
    unknown: Unknown = None,
    given: Given = None,
    guess: Guess = None,
    digits: Digits = 15,
    derivatives: Derivatives = None,
    require: Require = None,
    save: Save = None,
    as_json: AsJson = False,
) -> int:
    """Find a periodic orbit: unknowns, multipliers, stability, admissibility."""
    problem = (orbit, parameters, unknown, given, guess, digits, derivatives)
    return _report(*problem, require=require, save=save, as_json=as_json)


@app.command(
    epilog="Examples:\n\n"
    "nonsmooth verify dry-friction/global-stick --digits 50\n\n"
    "nonsmooth verify dry-friction/global-stick --digits 50 --arithmetic both\n\n"
    "nonsmooth verify dry-friction/global-stick eta=0.98 --require stable --json"
)
@answering
def verify(
    orbit: OrbitName,
    parameters: Assignments = None,
    unknown: Unknown = None,
    given: Given = None,
    guess: Guess = None,
    digits: Digits = 50,
    arithmetic: Annotated[
        RefiningArithmetic,
        typer.Option(
            "--arithmetic",
            help="What refines the orbit: balls, whose digits are proved; mpmath, whose digits are"
            " compared with twice as many; or both, which have to agree, and how far they differ:"
            " in the unknowns, and in the trace where it is enclosed.",
        ),
    ] = RefiningArithmetic.FLINT,
    require: Require = None,
    save: Save = None,
    as_json: AsJson = False,
) -> int:
    """Decide stability by the trace, to any number of digits, and enclose the trace.

    The enclosure holds the trace of the one orbit in a box around the numbers shown; the
    criterion, if the trace has one, is proved if it holds for all of the enclosure. Orbits
    composed from tables are certified instead.
    """
    problem = (orbit, parameters, unknown, given, guess, digits, None)
    return _report(*problem, require=require, save=save, as_json=as_json, verified_by=arithmetic)


@app.command(
    epilog="Examples:\n\n"
    "nonsmooth plot orbit.json\n\n"
    "nonsmooth plot orbit.json --kind phase --out phase.svg\n\n"
    "nonsmooth plot motion.npz --kind strip\n\n"
    "nonsmooth plot found.json:2\n\n"
    "nonsmooth plot F.zarr --out F.png\n\n"
    "nonsmooth plot branch.json --quantity amplitude_x1,period\n\n"
    "nonsmooth plot orbit.json --kind time --periods 2 --out time.pdf"
)
@answering
def plot(
    file: Annotated[
        Path,
        typer.Argument(
            metavar="FILE",
            help="An orbit of `solve --save`, a motion of `simulate --save`, the orbits of"
            " `find --save` or one of them, FILE.json:N, a branch or a curve of events of"
            " `continue --save`, a sweep, a fit or a design of `--save`, a proven map of"
            " `certify --save`, or a chart of `chart --out`.",
        ),
    ],
    kind: Annotated[Kind, typer.Option("--kind", help="What to draw.")] = _ALL,
    periods: Annotated[
        int,
        typer.Option("--periods", metavar="N", help="How many of an orbit to draw against time."),
    ] = 1,
    quantity: Quantity = None,
    frequency: FrequencyIn = None,
    over: Over = None,
    out: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="A PNG, SVG or PDF; FILE.png by default."),
    ] = None,
    as_json: AsJson = False,
) -> int:
    """Draw saved orbits, motions or charts: histories, phase portraits, maps, multipliers."""
    from nonsmooth.runtime.core.files import check_target
    from nonsmooth.runtime.present.pictures.plot import save_figure
    from nonsmooth.runtime.present.pictures.saved_files import figure_of

    if not file.name:
        raise InputError(f"{file} is no saved file")
    own = file.with_name(f"{Path(file.name.replace('.json:', '-')).stem}.png")
    target = own if out is None else out
    if os.path.realpath(target) == os.path.realpath(file):
        raise InputError(f"cannot write {target}: it is the saved file")
    check_target(target)
    of_branch = {
        "quantity": tuple(split(quantity)),
        "over": over,
        "frequency": (frequency or Frequency.ANGULAR).value,
    }
    given = quantity or frequency or over
    drawn, figure = figure_of(file, kind.value, periods, of_branch if given else None)
    save_figure(figure, target)
    if as_json:
        print_json({**drawn, "kind": kind.value, "file": str(target)})
    else:
        print(f"{target} written")
    return ANSWERED


@app.command(
    epilog="Examples:\n\nnonsmooth reproduce --out paper\n\n"
    "nonsmooth reproduce --out paper --certify --json"
)
@answering
def reproduce(
    out: Annotated[
        Path, typer.Option(metavar="DIR", help="Folder of the report, made if need be.")
    ],
    certified: Annotated[
        bool, typer.Option("--certify", help="Add what ball arithmetic proves of every orbit.")
    ] = False,
    as_json: AsJson = False,
) -> int:
    """Write every number and figure of the source paper beside ours: a report in HTML."""
    from nonsmooth.runtime.cli.deriving import section_formulas
    from nonsmooth.runtime.cli.display import steps
    from nonsmooth.runtime.present.paper.writing import reproduce as write

    with steps() as begin:
        paths = write(out, section_formulas, begin, certified=certified)
    files = [str(path) for path in paths]
    if as_json:
        print_json({"folder": str(out), "files": files})
    else:
        for path in files:
            if not path.endswith((".svg", ".png")):
                print(f"{path} written")
    return ANSWERED


@app.command(
    epilog="Examples:\n\n"
    "nonsmooth regenerate --check\n\n"
    "nonsmooth regenerate dry-friction --out kernels"
)
@answering
def regenerate(
    system: Annotated[
        str | None, typer.Argument(metavar="SYSTEM", help="Only this one.", show_default=False)
    ] = None,
    check: Annotated[
        bool, typer.Option("--check", help="Write nothing; exit with 1 if a file differs.")
    ] = False,
    out: Annotated[
        Path | None,
        typer.Option(metavar="DIR", help="Folder of the files; that of the checkout by default."),
    ] = None,
    as_json: AsJson = False,
) -> int:
    """Make the kernels again from the derivation, or check that they are up to date."""
    from nonsmooth.derive.codegen import regenerate as generation
    from nonsmooth.derive.systems import SYSTEMS
    from nonsmooth.runtime.cli.display import show_written, steps
    from nonsmooth.runtime.core.files import check_folder, write_files

    if system is not None and system not in SYSTEMS:
        raise unknown_name("system", system, SYSTEMS)
    folder = generation.find_generated(writing=not check) if out is None else out
    told: dict[str, Any] = {"folder": str(folder), "system": system}
    checkout = generation.surrounding_checkout()
    if out is None and checkout is not None and checkout.resolve() != folder.resolve().parent:
        say(
            f"this is about {folder}, of the nonsmooth that runs, not about {checkout}:"
            f" install that one to derive with it"
        )
    if check:
        with steps() as begin:
            differences = generation.check(out, system, begin)
        return show_comparison(told, differences, f"the derivation: {REMEDY}", as_json=as_json)
    check_folder(folder)
    with steps() as begin:
        texts = generation.outdated(out, system, begin)
    if texts:
        write_files(folder, {name: text.encode() for name, text in texts.items()})
    changed = [str(folder / name) for name in texts]
    if as_json:
        print_json({**told, "changed": changed})
    else:
        show_written(changed, f"{folder}: nothing changed")
    return ANSWERED


def _report(
    name: str,
    parameters: list[str] | None,
    unknown: list[str] | None,
    given: list[str] | None,
    guess: list[str] | None,
    digits: int,
    derivatives: list[str] | None,
    *,
    require: list[RequiredVerdict] | None,
    save: Path | None,
    as_json: bool,
    verified_by: RefiningArithmetic | None = None,
) -> int:
    """Solve for an orbit, refine, save and show it; gives the exit code.

    One that is verified is refined by that arithmetic, and its trace is enclosed and shown first.
    """
    from nonsmooth.runtime.core.files import check_target
    from nonsmooth.runtime.core.values import decimal_string
    from nonsmooth.runtime.model.kernels import is_saved
    from nonsmooth.runtime.orbits.refine import MOST_DIGITS, refine, refine_both
    from nonsmooth.runtime.orbits.solve import solve as find_orbit
    from nonsmooth.runtime.present.report import (
        derivatives_json,
        orbit_json,
        short,
        trace_proof_json,
    )

    if not 1 <= digits <= MOST_DIGITS:
        raise InputError(f"digits = {digits} is not an integer from 1 to {MOST_DIGITS}")
    if save is not None:
        check_target(save)
    assigned = assignments("parameter", parameters or [])
    found = find_orbit(
        name,
        assigned,
        {n: float(v) for n, v in assignments("unknown", split(guess)).items()} or None,
        unknown=split(unknown),
        given=assignments("unknown", split(given)),
    )
    working = max(digits, _WORKING_DIGITS)
    by_kernels = found.problem.derived
    arithmetic = (verified_by or RefiningArithmetic.FLINT).value
    if verified_by is RefiningArithmetic.BOTH:
        refined = refine_both(found, working)
        orbit = refined.by_balls
    else:
        refined, orbit = None, refine(found, working, arithmetic=arithmetic)
    told = orbit_json(orbit, digits)
    if verified_by is not None:
        told["arithmetic"] = arithmetic if by_kernels else RefiningArithmetic.MPMATH.value
        if refined is not None:
            told["difference"], told["compared"] = short(refined.difference), refined.compared
        told["proof"] = trace_proof_json(orbit)
    for parameter, value in assigned.items():  # also those that others stand for
        told["parameters"][parameter] = decimal_string(value.mpf(digits + 5), digits)
    if derivatives:
        told["derivatives"] = derivatives_json(orbit, split(derivatives), digits)
    written = Written()
    written.save(orbit.save, save)

    def show() -> None:
        from nonsmooth.runtime.cli.display import show_report

        absent = f"from {name}" if is_saved(name) else "default"
        show_report(orbit, told, assigned, absent=absent)

    code = written.show_one(lambda: told, show, save, as_json=as_json)
    return code or _judged(told, require or [])


def _judged(told: Mapping[str, Any], require: Iterable[RequiredVerdict]) -> int:
    """Exit code of an orbit; requirements that are not met are named on stderr."""
    verdicts = {"stable": told["stability"], "admissible": told["admissible"]}
    met = {"stable": "stable", "admissible": True}
    names = list(dict.fromkeys(wanted.value for wanted in require))
    missed = [n for n in names if verdicts[n] not in (met[n], "undecided")]
    for name in missed:
        answer = "no" if verdicts[name] is False else verdicts[name]
        say(f"required: {name}; found: {answer}")
    if missed:
        return NOT_MET
    return UNANSWERED if "undecided" in verdicts.values() else ANSWERED
