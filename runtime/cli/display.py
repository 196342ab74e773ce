"""What the command line shows to people: Rich tables on stdout, progress on stderr."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from decimal import Decimal
from typing import TYPE_CHECKING, Any

from rich.console import Console
from rich.table import Table
from rich.text import Text

from nonsmooth.runtime.cli.tables import STYLES, console_as_wide, listing, show_table
from nonsmooth.runtime.core.errors import one_line
from nonsmooth.runtime.core.values import decimal_string
from nonsmooth.runtime.model.naming import shown_name
from nonsmooth.runtime.orbits.orbit import PERIOD, Orbit

if TYPE_CHECKING:
    from nonsmooth.runtime.core.values import Value

__all__ = [
    "counted",
    "show_differences",
    "show_list",
    "show_report",
    "show_written",
    "steps",
]

_LONGEST_NUMBER = 64  # beside the labels
_GROUP, _GROUPS_IN_LINE = 10, 5
_RANKS = {1: "one", 2: "two", 3: "three"}
_LONG = 600.0  # seconds over which a rate of work is told: shares rise in jumps


def show_report(
    orbit: Orbit,
    found: Mapping[str, Any],
    assigned: Mapping[str, Value],
    *,
    absent: str,
) -> None:
    """Show an orbit: given parameters, unknowns, stability and admissibility.

    `found` is the orbit as JSON, `assigned` has the parameters as the user gave them, and
    `absent` says where the others come from, such as "default". Where something is proved of
    the trace the criterion of stability comes before the orbit.
    """
    console = console_as_wide()
    derived, rank = orbit.problem.derived, orbit.stability.rank
    trivial = any(m["trivial"] for m in found["multipliers"])
    rank_one = derived and rank == 1 and not trivial
    console.print(Text(f"{shown_name(found['orbit'])}, {found['digits']} digits", style="bold"))
    console.print(Text(" -> ".join([*_configurations(orbit), "..."])))
    parameters = _table()
    for name, text, source in _sources(orbit, found, assigned, absent):
        parameters.add_row(name, text, Text(source, style="dim"))
    unknowns = _table()
    shown = {**_unknowns(orbit, found), "period": found["period"], "residual": found["residual"]}
    shown |= {f"{name} moves by": text for name, text in found.get("shift", {}).items()}
    for label, text in shown.items():
        unknowns.add_row(label, _digits(text))
    excess = decimal_string(-orbit.stability.margin, found["digits"])
    zero = "0 exactly" if derived else "0 to these digits"
    zero = f"{zero}: the Poincare map has rank {_RANKS.get(rank, rank)}"
    criterion = _criterion(found, excess, (rank, zero), rank_one=rank_one)
    tables = [("Given", parameters), ("Orbit", unknowns)]
    tables.insert(
        0 if "proof" in found else 2, ("Trace criterion" if rank_one else "Stability", criterion)
    )
    for title, table in tables:
        console.print()
        console.print(Text(title, style="bold"))
        console.print(table)
    if "derivatives" in found:
        _print_derivatives(console, found["derivatives"])
    console.print()
    _print_admissibility(console, found)


def _print_derivatives(console: Console, found: Mapping[str, Mapping[str, str]]) -> None:
    """Show the derivatives, one row for each quantity and one column for each given number."""
    names = [*next(iter(found.values()))]
    table = listing("d", *(f"by {name}" for name in names))
    for quantity, rates in found.items():
        table.add_row(quantity, *(rates[name] for name in names))
    console.print()
    console.print(Text("Derivatives", style="bold"))
    show_table(table, console)


def show_list(systems: Iterable[Mapping[str, Any]], *, whole: bool) -> None:
    """Show systems, as `systems_json` gives them, and their orbits, parameters and unknowns.

    With `whole` the states, parameters, configurations and transitions of the system too.
    """
    console = console_as_wide()
    for system in systems:
        console.print(Text.assemble((system["name"], "bold"), f": {system['description']}"))
        if whole:
            _show_system(system, console)
        for orbit in system["orbits"]:
            console.print()
            console.print(Text(orbit["name"], style="bold"))
            if "refused" in orbit:
                console.print(Text(f"  refused: {one_line(orbit['refused'])}", style="red"))
                continue
            for phase in orbit["phases"]:
                place = f"{phase['configuration']} until {phase['boundary']}"
                console.print(Text(f"  {phase['dwell_time']:5} {place}"))
            console.print(Text(f"  unknowns: {' '.join(orbit['unknowns'])}"))
            if not orbit["derived"]:
                console.print(Text(f"  composed from tables: {orbit['reason']}"))
            table = listing("parameter", "default", "meaning")
            for parameter in orbit["parameters"]:
                default = parameter["default"] or ""
                table.add_row(_domain(parameter), default, Text(parameter["description"]))
            show_table(table, console, keys=2)


def _show_system(system: Mapping[str, Any], console: Console) -> None:
    console.print(Text(f"  states: {' '.join(system['states'])}"))
    parameters = listing("parameter", "meaning")
    for parameter in system["parameters"]:
        parameters.add_row(_domain(parameter), Text(parameter["description"]))
    following = {(t["source"], *t["boundaries"]): t["targets"] for t in system["transitions"]}
    transitions = listing("configuration", "boundary", "acts when", "then")
    for source, boundaries in system["boundaries"].items():
        for boundary in boundaries or [{"name": "", "acts_when": ""}]:
            targets = following.pop((source, boundary["name"]), [])
            then = " or ".join(targets) if targets or not boundary["name"] else "not declared"
            transitions.add_row(source, boundary["name"], boundary["acts_when"], then)
    for (source, *together), targets in following.items():
        transitions.add_row(source, " and ".join(together), "together", " or ".join(targets))
    for table in (parameters, transitions):
        console.print()
        show_table(table, console, keys=2)


def show_written(paths: Iterable[str], nothing: str) -> None:
    """Print the paths of the files that were written, one a line, or the text `nothing`."""
    for line in list(paths) or [nothing]:
        print(line)


def show_differences(differences: Iterable[str]) -> None:
    """Show differences of files; added and removed lines are coloured on a terminal.

    Each is a text of several lines, as `difflib` writes them.
    """
    console = Console(highlight=False, soft_wrap=True)
    for difference in differences:
        for line in difference.splitlines():
            style = {"+": "green", "-": "red", "@": "cyan"}.get(line[:1], "")
            console.print(Text(line, style=style))


@contextmanager
def steps(first: str = "") -> Iterator[Callable[[str], None]]:
    """Give a function that takes the name of each step as it begins, and shows it on stderr.

    Nothing is shown unless stderr is a terminal. The step `first` begins at once unless
    empty.
    """
    if not sys.stderr.isatty():
        yield lambda step: None
        return
    from rich.progress import Progress, SpinnerColumn, TextColumn, TimeElapsedColumn

    columns = (SpinnerColumn(finished_text=" "), TextColumn("{task.description}"))
    with Progress(*columns, TimeElapsedColumn(), console=Console(stderr=True)) as progress:

        def begin(step: str) -> None:
            finish()
            progress.add_task(step, total=1)

        def finish() -> None:
            for task in progress.task_ids:
                progress.update(task, completed=1)

        if first:
            begin(first)
        yield begin
        finish()


@contextmanager
def counted(what: str, total: int | None = None) -> Iterator[Callable[..., None]]:
    """Give a function that shows a progress bar on stderr; it takes a count and the total.

    Nothing is shown unless stderr is a terminal. The text `what` stands before the bar;
    `total` is None as long as it is unknown.
    """
    if not sys.stderr.isatty():
        yield lambda done, total=None: None
        return
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn
    from rich.progress import TimeRemainingColumn as Remaining

    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), Remaining())
    with Progress(*columns, console=Console(stderr=True)) as progress:
        task = progress.add_task(what, total=total)
        yield lambda done, total=None: progress.update(task, completed=done, total=total)


@contextmanager
def shared(what: str, counts: str = "tiles") -> Iterator[Callable[[float, int], None]]:
    """Give a function that shows progress on stderr; it takes a share in [0, 1] and a count.

    Nothing is shown unless stderr is a terminal. The text `what` stands before the bar, and
    `counts` says what is counted. The remaining time is estimated from the share and the
    time that it took.
    """
    if not sys.stderr.isatty():
        yield lambda share, count: None
        return
    from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn
    from rich.progress import TimeElapsedColumn as Elapsed
    from rich.progress import TimeRemainingColumn as Remaining

    tiles = TextColumn("{task.fields[count]} " + counts)
    left = (TextColumn("left"), Remaining())
    columns = (TextColumn("{task.description}"), BarColumn(), TaskProgressColumn(), tiles)
    shown = Progress(
        *columns, Elapsed(), *left, console=Console(stderr=True), speed_estimate_period=_LONG
    )
    with shown as progress:
        task = progress.add_task(what, total=None, count=0)  # until a share is known
        yield lambda share, count: progress.update(task, completed=share, total=1.0, count=count)


def _unknowns(orbit: Orbit, found: Mapping[str, Any]) -> dict[str, str]:
    """Text of each unknown of an orbit, and of the phase of each forcing at the start."""
    entries = dict(found["unknowns"])
    start = orbit.states[0]
    for number, (cosine, sine) in enumerate(orbit.problem.forcing, 1):
        context = orbit.arithmetic.mp
        phase = context.atan2(start[sine], start[cosine])
        label = "forcing phase" if number == 1 else f"forcing phase {number}"
        entries[label] = decimal_string(phase, found["digits"])
    return entries


def _configurations(orbit: Orbit) -> list[str]:
    """Name of the configuration of each phase."""
    return [configuration for configuration, _ in orbit.itinerary]


def _sources(
    orbit: Orbit, found: Mapping[str, Any], assigned: Mapping[str, Value], absent: str
) -> Iterator[tuple[str, str, str]]:
    """Give name and text of each given parameter, and where its value comes from."""
    for name, value in assigned.items():
        yield name, str(value), ""
    following = orbit.problem.followers(assigned)
    for name, value in {**orbit.given, **orbit.opened}.items():
        if name in assigned:
            continue
        if name in following:
            yield name, found["parameters"][name], "follows"
        elif name in orbit.problem.unknown_names:
            yield name, str(value), "in place of an unknown"
        else:
            yield name, str(value), "given" if name == PERIOD else absent


def _table() -> Table:
    table = Table(box=None, show_header=False, pad_edge=False, padding=(0, 2, 0, 0))
    table.add_column(no_wrap=True, min_width=12)
    table.add_column(overflow="fold")
    return table


def _criterion(
    found: Mapping[str, Any], excess: str, vanishing: tuple[int, str], *, rank_one: bool
) -> Table:
    """Give trace, multipliers and verdict; behind so many multipliers each is a given text."""
    table = _table()
    rank, zero = vanishing
    verdict = found["stability"]
    table.add_row("trace", _digits(found["trace"]))
    if rank_one:
        table.add_row("|trace| - 1", _digits(excess))
    for number, multiplier in enumerate(found["multipliers"], 1):
        label = f"multiplier {number}"
        if number > rank:
            table.add_row(label, zero)
        elif not rank_one:
            trivial = " (trivial)" if multiplier["trivial"] else ""
            table.add_row(label, _digits(multiplier["re"]) + trivial)
            if multiplier["im"].strip("-0."):
                table.add_row(" + i times", _digits(multiplier["im"]))
    if rank_one:
        reason = {
            "stable": "conditionally stable (|trace| < 1)",
            "unstable": "unstable (|trace| > 1)",
        }
    else:
        table.add_row("margin", _digits(found["margin"]))
        reason = {
            "stable": "conditionally stable (nontrivial multipliers inside the unit circle)",
            "neutral": "neutral (nontrivial multipliers on the unit circle)",
            "unstable": "unstable (a multiplier outside the unit circle)",
        }
    text = reason.get(verdict, f"{verdict}: the margin is zero to these digits, ask for more")
    table.add_row("verdict", Text(text, style=f"bold {STYLES.get(verdict, 'yellow')}"))
    if verdict == "stable":
        table.add_row("", "under perturbations that keep the order of the switches")
    if "proof" in found:
        _add_proof(table, found)
    if "one_sided" in found:
        table.add_row("", f"one-sided: a border collision, on the side {found['one_sided']}")
    return table


def _add_proof(table: Table, found: Mapping[str, Any]) -> None:
    """Add what is enclosed and proved of the trace, and how far two arithmetics differ."""
    proof = found["proof"]
    if "difference" in found:
        compared = " and ".join(found["compared"])
        table.add_row(
            "difference", f"{found['difference']} between balls and mpmath, of {compared}"
        )
    if proof["trace"] is None:
        table.add_row("enclosure", f"none: {proof['reason']}")
        return
    table.add_row("enclosure", _digits(format(Decimal(proof["trace"]["mid"]), "f")))
    table.add_row("      +/-", proof["trace"]["rad"])
    if proof["statement"] is not None:
        table.add_row(proof["verdict"], proof["statement"])
        table.add_row("", "for the one orbit in a box around it")
    if "reason" in proof:
        table.add_row("", proof["reason"])
    if proof["one_sided"]:
        table.add_row("", "on one side of a border collision")


def _print_admissibility(console: Console, found: Mapping[str, Any]) -> None:
    verdict = found["admissible"]
    if verdict is True:
        answer = Text("yes: no boundary is crossed inside a phase", style="green")
    elif verdict is False:
        answer = Text("no: boundaries are crossed inside phases", style="red")
    else:
        answer = Text(f"{verdict}, it takes", style="yellow")
    console.print(Text.assemble(("Admissible: ", "bold"), answer))
    for bound in found.get("requires", ()):
        console.print(Text(f"  {bound['parameter']} > {float(bound['greater_than']):.10g}"))
    for meeting in found.get("coincidences", ()):
        together = " and ".join(meeting["boundaries"])
        console.print(Text(f"  at t = {float(meeting['time']):.10g} {together} coincide"))
    if verdict is False:
        table = listing("phase", "configuration", "boundary", "time", "excess")
        for violation in found["violations"]:
            numbers = (f"{float(violation[name]):.6g}" for name in ("time", "excess"))
            names = (str(violation[n]) for n in ("phase", "configuration", "boundary"))
            table.add_row(*names, *numbers)
        show_table(table, console)


def _digits(number: str) -> str:
    """Text of a number, in several lines of groups of digits if it is too long for one."""
    if len(number) <= _LONGEST_NUMBER:
        return number
    mantissa, letter, exponent = number.partition("e")
    whole, _, fraction = mantissa.partition(".")
    groups = [fraction[i : i + _GROUP] for i in range(0, len(fraction), _GROUP)]
    lines = [
        " ".join(groups[i : i + _GROUPS_IN_LINE]) for i in range(0, len(groups), _GROUPS_IN_LINE)
    ]
    return "\n".join([f"{whole}.", *lines]) + letter + exponent


def _domain(parameter: Mapping[str, Any]) -> str:
    text: str = parameter["name"]
    if parameter["lower"] is not None:
        text = f"{parameter['lower']} {'<=' if parameter['closed'] else '<'} {text}"
    if parameter["upper"] is None:
        return text
    return f"{text} {'<=' if parameter['upper_closed'] else '<'} {parameter['upper']}"
