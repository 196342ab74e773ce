"""The command that lists systems and orbits."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING, Annotated, Any

import typer

from nonsmooth.runtime.cli.command import command
from nonsmooth.runtime.cli.completion import complete_systems
from nonsmooth.runtime.cli.reply import Reply
from nonsmooth.runtime.core.errors import one_line

if TYPE_CHECKING:
    from nonsmooth.runtime.model.kernels import OrbitKernels, SystemKernels
    from nonsmooth.runtime.present.told import Listing, Told


@command("list", "list", "list my_oscillator.py", "list dry-friction --json")
def list_orbits(
    systems: Annotated[
        list[str] | None,
        typer.Argument(
            autocompletion=complete_systems,
            metavar="SYSTEM",
            help="Only these: built-in ones, FILE.py, FILE.json, or a folder of `generate`.",
            show_default=False,
        ),
    ] = None,
    *,
    reply: Reply,
) -> int:
    """List systems and orbits, their parameters and unknowns."""
    from nonsmooth.runtime.cli.display import show_told
    from nonsmooth.runtime.model.kernels import system_names

    found = [_system(name) for name in systems or system_names()]

    def show() -> None:
        for system in found:
            for told in _told(system, whole=bool(systems)):
                show_told(told)
                print()

    return reply.show(lambda: {"systems": found}, show)


# --- as JSON


def _system(name: str) -> dict[str, Any]:
    """A system and its orbits, or those of a file of results, as JSON."""
    from nonsmooth.runtime.model.kernels import is_saved, load_orbit, load_system, orbits_in
    from nonsmooth.runtime.model.naming import shown_name
    from nonsmooth.runtime.model.structure import structure_of
    from nonsmooth.runtime.present.files.named_entries import saved_listing

    saved = is_saved(name)
    orbits: Mapping[str, OrbitKernels | str]
    if saved:
        system, orbits = saved_listing(name)
    else:
        system, orbits = load_system(name), {each: load_orbit(each) for each in orbits_in(name)}
    structure, every = structure_of(system), system.table["configurations"]
    visited = [structure.configurations[c] for c in structure.visited]
    return {
        "name": shown_name(system.name) if saved else system.name,
        "description": system.table["description"],
        "states": list(system.table["states"]),
        "configurations": visited,
        "boundaries": {each: [dict(boundary) for boundary in every[each]] for each in visited},
        "transitions": _transitions(system),
        "parameters": [asdict(p) for p in system.parameters],
        "orbits": [
            {"name": each, "refused": entry} if isinstance(entry, str) else _orbit(entry)
            for each, entry in orbits.items()
        ],
    }


def _transitions(system: SystemKernels) -> list[dict[str, Any]]:
    """Transitions that may follow when boundaries are reached; the state decides which one does."""
    targets: dict[tuple[str, tuple[str, ...]], dict[str, None]] = {}
    for transition in system.table["transitions"]:
        reached = (transition["source"], tuple(transition["boundaries"]))
        targets.setdefault(reached, {})[transition["target"]] = None
    return [
        {"source": source, "boundaries": list(boundaries), "targets": list(found)}
        for (source, boundaries), found in targets.items()
    ]


def _orbit(kernels: OrbitKernels) -> dict[str, Any]:
    """An orbit as JSON; without derived equations all parameters are given."""
    from nonsmooth.runtime.model.completion import default_parameters
    from nonsmooth.runtime.orbits.table_solve import unknowns_of

    table, derived = kernels.table, kernels.derived
    if derived:
        defaults: Mapping[str, Any] = kernels.required | default_parameters(kernels)
        parameters = [*kernels.parameters, *kernels.open_parameters]
        used = {*kernels.parameter_names, *kernels.solved_for}
        combining = {n for name, terms in kernels.combined.items() if name in used for n in terms}
        combining = (combining | set(kernels.required)) - {p.name for p in parameters}
        parameters += [p for p in kernels.system.parameters if p.name in combining]
    else:
        parameters = list(kernels.system.parameters)
        defaults = (table["reference"] or {"parameters": {}})["parameters"]
    return {
        "name": kernels.address,
        "phases": [
            {"configuration": configuration, "boundary": boundary, "dwell_time": dwell_time}
            for configuration, boundary, dwell_time in table["phases"]
        ],
        "parameters": [asdict(p) | {"default": defaults.get(p.name)} for p in parameters],
        "unknowns": list(kernels.unknowns if derived else unknowns_of(kernels)),
        "derived": derived,
        **({} if derived else {"reason": table["reason"]}),
    }


# --- for people


def _told(system: Mapping[str, Any], *, whole: bool) -> Iterator[Told]:
    """A system, if it is `whole` with states, parameters and transitions, and each orbit."""
    from nonsmooth.runtime.present.told import Listing

    rows: list[tuple[str, Sequence[str] | Listing]] = []
    if whole:
        titles = ("configuration", "boundary", "acts when", "then")
        rows += [
            ("states", [" ".join(system["states"])]),
            ("parameters", _listed(system["parameters"], "parameter", "meaning")),
            ("transitions", Listing(titles, [*_followers(system)], keys=2)),
        ]
    yield f"{system['name']}: {system['description']}", rows
    for orbit in system["orbits"]:
        if "refused" in orbit:
            yield orbit["name"], [("refused", [one_line(orbit["refused"])])]
            continue
        phases = [(p["dwell_time"], p["configuration"], p["boundary"]) for p in orbit["phases"]]
        yield (
            orbit["name"],
            [
                ("phases", Listing(("phase", "configuration", "until"), phases)),
                ("unknowns", [" ".join(orbit["unknowns"])]),
                ("composed from tables", [] if orbit["derived"] else [orbit["reason"]]),
                ("parameters", _listed(orbit["parameters"], "parameter", "default", "meaning")),
            ],
        )


def _followers(system: Mapping[str, Any]) -> Iterator[tuple[str, str, str, str]]:
    """Rows of boundaries, alone and reached together, and of what follows."""
    following = {(t["source"], *t["boundaries"]): t["targets"] for t in system["transitions"]}
    for source, boundaries in system["boundaries"].items():
        for boundary in boundaries or [{"name": "", "acts_when": ""}]:
            targets = following.pop((source, boundary["name"]), [])
            then = " or ".join(targets) if targets or not boundary["name"] else "not declared"
            yield source, boundary["name"], boundary["acts_when"], then
    for (source, *together), targets in following.items():
        yield source, " and ".join(together), "together", " or ".join(targets)


def _listed(parameters: Sequence[Mapping[str, Any]], *titles: str) -> Listing:
    """A table of parameters with their domains, defaults where it has these, and meanings."""
    from nonsmooth.runtime.present.told import Listing

    return Listing(
        titles,
        [
            (
                _domain(each),
                *([each["default"] or ""] if "default" in titles else []),
                each["description"],
            )
            for each in parameters
        ],
        keys=2,
    )


def _domain(parameter: Mapping[str, Any]) -> str:
    text: str = parameter["name"]
    if parameter["lower"] is not None:
        text = f"{parameter['lower']} {'<=' if parameter['closed'] else '<'} {text}"
    if parameter["upper"] is None:
        return text
    return f"{text} {'<=' if parameter['upper_closed'] else '<'} {parameter['upper']}"
