"""What the commands that follow branches, simulate and fit show to people."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from rich.table import Table
from rich.text import Text

from nonsmooth.runtime.cli.report_motions import largest_exponent
from nonsmooth.runtime.cli.tables import console_as_wide, listing, show_table
from nonsmooth.runtime.explore.finding.found import Found, FoundEquilibrium, FoundOrbit
from nonsmooth.runtime.explore.finding.outcomes import settled_texts
from nonsmooth.runtime.explore.finding.sweep import Sweep
from nonsmooth.runtime.explore.fitting.fit_record import Fit, FittedExperiment
from nonsmooth.runtime.explore.fitting.nearest_grazing import NearestGrazing
from nonsmooth.runtime.model.naming import itinerary_text, shown_name
from nonsmooth.runtime.model.structure import FORCING_PHASE
from nonsmooth.runtime.proof.motion.motion_proof import Proof
from nonsmooth.runtime.simulation.derivatives import MotionDerivatives
from nonsmooth.runtime.simulation.observables import Observables
from nonsmooth.runtime.simulation.trajectory import Trajectory

if TYPE_CHECKING:
    from nonsmooth.runtime.explore.continuation.branch import Branch
    from nonsmooth.runtime.explore.continuation.continue_event import Locus

__all__ = [
    "Others",
    "branch_json",
    "locus_json",
    "show_branch",
    "show_derivatives",
    "show_fit",
    "show_found",
    "show_locus",
    "show_motion",
    "show_observables",
    "show_proof",
    "show_sweep",
]

Others = dict[int, list[dict[str, Any]]]  # itineraries beyond events, by the events' numbers
_ROWS = 40  # of a long motion: the first and the last half of them
_DIGITS = 8
_EXTREMES = ("", "least", "at", "greatest", "at", "mean", "RMS")
_FORCES = ("force", "least", "greatest", "mean", "work", "dissipated")


def branch_json(branch: Branch, others: Others) -> dict[str, Any]:
    """A branch as JSON; `others` holds itineraries beyond events, by the events' indices."""
    return {
        "orbit": branch.name,
        "parameter": branch.parameter,
        "values": _finite(branch.parameter_values),
        "unknowns": {name: _finite(branch.quantity(name)) for name in branch.unknown_names},
        "period": _finite(branch.period),
        "trace": _finite(branch.trace),
        "stability": list(branch.stability),
        "admissible": branch.admissible.tolist(),
        "ends": list(branch.ends),
        "events": [
            {
                "kind": event.kind,
                "value": event.value,
                "phase": None if event.phase is None else event.phase + 1,
                "configuration": event.configuration,
                "boundary": event.boundary,
                "touching": event.touching,
                "time": event.time,
                "unknowns": dict(event.unknowns),
                **({"beyond": others[number]} if number in others else {}),
            }
            for number, event in enumerate(branch.events)
        ],
    }


def show_branch(branch: Branch, others: Others) -> None:
    """Show the events of a branch, the itineraries beyond them, and why the branch ends.

    `others` holds those itineraries by the indices of the events.
    """
    low, high = float(branch.parameter_values.min()), float(branch.parameter_values.max())
    allowed = int(branch.admissible.sum())
    print(
        f"{shown_name(branch.name)}: {len(branch)} points,"
        f" {branch.parameter} from {low:.10g} to {high:.10g},"
        f" {allowed} of them motions of the real system"
    )
    if branch.events:
        table = listing("event", branch.parameter, "where", "boundary")
        for event in branch.events:
            where = "" if event.phase is None else f"{event.configuration} ({event.phase + 1})"
            kind = event.kind + ", touched" * event.touching
            table.add_row(kind, f"{event.value:.12g}", where, event.boundary)
        show_table(table)
    for number, orbits in others.items():
        value = branch.events[number].value
        for orbit in orbits:
            names = " > ".join(f"{configuration}" for configuration, _ in orbit["itinerary"])
            print(f"beyond {branch.parameter} = {value:.6g}: {names} ({orbit['stability']})")
    for end, reason in zip(("begins", "ends"), branch.ends, strict=True):
        print(f"{end}: {reason}")
    for line in _ways_on(branch, others):
        print(line)


def _ways_on(branch: Branch, others: Others) -> Iterator[str]:
    """Give a line for each option that goes on from an event of the branch."""
    switches = [event.kind for event in branch.events if event.switches]
    if switches:
        yield f"--switch {_named(switches)} follows the other branch there"
    if not others and any(event.border_collision for event in branch.events):
        yield "--beyond finds the itineraries beyond border collisions"
    if followed := [event.kind for event in branch.events if event.kind != "admissibility"]:
        yield f"--follow {_named(followed)} with a second range NAME=A:B follows it in the plane"


def _named(kinds: Sequence[str]) -> str:
    """The first of some events as an option takes it: its kind, and ``:1`` if there are more."""
    return kinds[0] + ":1" * (kinds.count(kinds[0]) > 1)


def locus_json(locus: Locus) -> dict[str, Any]:
    """A curve of events as JSON."""
    return {
        "orbit": locus.name,
        "kind": locus.kind,
        "boundary": locus.boundary,
        "parameters": list(locus.parameters),
        "values": locus.values.tolist(),
        "unknowns": {
            name: locus.unknowns[:, place].tolist()
            for place, name in enumerate(locus.unknown_names)
        },
        "ends": list(locus.ends),
    }


def show_locus(locus: Locus) -> None:
    """Show where a curve of events begins and ends in the plane of its parameters, and why."""
    print(f"{locus.title}: {len(locus)} points in the plane of {' and '.join(locus.parameters)}")
    table = listing("", *locus.parameters)
    places = {"begins": 0, "from": locus.start, "ends": len(locus) - 1}
    for word, place in places.items():
        table.add_row(word, *(f"{value:.12g}" for value in locus.values[place].tolist()))
    show_table(table)
    for end, reason in zip(("begins", "ends"), locus.ends, strict=True):
        print(f"{end}: {reason}")


def _finite(values: Any) -> list[float | None]:
    return [x if abs(x) < float("inf") else None for x in values.tolist()]


def show_fit(fit: Fit) -> None:
    """Show estimates with their uncertainties, the misfit, and the phases of fitted motions."""
    out = console_as_wide()
    count = f"{len(fit.experiments)} experiment{'s' * (len(fit.experiments) != 1)}"
    out.print(Text(f"{shown_name(fit.system)}, {fit.data} numbers of {count}", style="bold"))
    table = listing(
        "found", "estimate", "standard error", "95 % interval", right=("estimate", "standard error")
    )
    errors = fit.standard_errors.tolist()
    for place, name in enumerate(fit.names):
        ends = f"{fit.lower[place]:.8g} ... {fit.upper[place]:.8g}"
        error = f"{errors[place]:.2g}" if math.isfinite(errors[place]) else ""
        table.add_row(name, f"{fit.estimates[place]:.10g}", error, fit.untold.get(name, ends))
    show_table(table, out)
    out.print(f"chi2 {fit.chi2:.6g} with {fit.degrees_of_freedom} degrees of freedom")
    for name, size in fit.noise.items():
        out.print(f"noise of {name}: {size:.3g}, estimated")
    for text in fit.unidentified:
        out.print(Text(f"nothing measured tells {text}", style="red"))
    weak = [each for each in fit.identified if 1 <= each[1] < math.inf]
    for text, _ in weak:
        out.print(f"hardly told: {text}")
    for each in fit.experiments:
        if each.responses:
            out.print(_responses_text(each))
            continue
        phases = len(each.configurations)
        sequence = {
            None: "",
            True: ", events in the order of the data",
            False: ", events not in the order or number of the data",
        }
        out.print(
            f"{shown_name(each.name)}: {phases} phase{'s' * (phases != 1)}"
            f"{sequence[each.same_sequence]}{_grazing_text(each.grazing)}"
        )
    tried = "" if len(fit.costs) < 2 else f", best of {len(fit.costs)} searches"
    out.print(f"{fit.status}: {fit.message}; {fit.evaluations} evaluations{tried}")


def _responses_text(experiment: FittedExperiment) -> str:
    """One line with the number of steady responses of an experiment, with and without events."""
    counts = Counter(
        "without an event" if each.itinerary[0][1] == FORCING_PHASE else "with events"
        for each in experiment.responses
    )
    told = " and ".join(f"{count} {kind}" for kind, count in counts.items())
    count = len(experiment.responses)
    return (
        f"{shown_name(experiment.name)}: {count} steady response{'s' * (count != 1)}, {told}"
        f"{_grazing_text(experiment.grazing)}"
    )


def _grazing_text(grazing: NearestGrazing | None) -> str:
    if grazing is None:
        return ""
    distance = grazing.standard_errors
    far = "" if not math.isfinite(distance) else f", {distance:.3g} standard errors away"
    return (
        f"; nearest grazing: {grazing.boundary}, {grazing.kind} at {grazing.time:.6g},"
        f" by {grazing.margin:.3g}{far}"
    )


def show_motion(motion: Trajectory) -> None:
    """Show the transitions of a motion; of a long one the first and the last."""
    out = console_as_wide()
    out.print(
        Text(f"{shown_name(motion.name)}, {_count(motion.transitions, 'transition')}", style="bold")
    )
    shown = [place for place in range(len(motion.names)) if place not in _forced(motion)]
    names = [motion.names[place] for place in shown]
    phases = ["forcing phase"] if motion.structure.forcing else []
    table = listing("time", "reached", "then", *names, *phases, right=("time", *names, *phases))
    count = len(motion.times)
    hidden = count - _ROWS
    for i in range(count):
        if hidden > 0 and _ROWS // 2 <= i < count - _ROWS // 2:
            if i == _ROWS // 2:
                table.add_row("...", Text(f"{hidden} more", style="dim"), "")
            continue
        table.add_row(
            _number(motion.times[i]),
            " + ".join(motion.boundaries[i]),
            motion.configurations[i],
            *map(_number, motion.states[i][shown]),
            *(_number(angle) for angle in _angles(motion, i)[: len(phases)]),
        )
    show_table(table, out)
    out.print(f"ended at {_number(motion.end)}: {motion.message}")
    for g in motion.grazings:
        shape = motion.structure.boundaries[g.configuration][g.boundary]
        out.print(
            f"touched without crossing: {shape.name} at {_number(g.time)}, depth {g.depth:.1e}"
        )


def show_derivatives(found: MotionDerivatives) -> None:
    """Show the derivatives of the last transition's time and of the state behind it."""
    out = console_as_wide()
    motion = found.trajectory
    names = ["time", *(f"{name} behind it" for name in motion.names)]
    table = listing("by", *names, right=tuple(names))
    times = np.concatenate([np.zeros((1, len(found.by))), found.event_times])[-1]
    for name, time, states in zip(found.by, times, found.behind[-1].T, strict=True):
        table.add_row(name, *map(_number, (time, *states)))
    out.print(f"derivatives of {'the last transition' if motion.transitions else 'the start'}:")
    show_table(table, out)


def show_found(found: Found) -> None:
    """Show periodic orbits and equilibria, with stability and basin, and other outcomes."""
    out = console_as_wide()
    kinds = [_count(len(found.orbits), "periodic orbit")]
    if found.equilibria:
        count = len(found.equilibria)
        kinds.append(f"{count} equilibri{'um' if count == 1 else 'a'}")
    title = f"{' and '.join(kinds)} from {_count(len(found.starts), 'start')}"
    out.print(Text(f"{shown_name(found.system)}, {title}", style="bold"))
    if found.orbits:
        show_table(_orbits(found), out)
    if found.equilibria:
        show_table(_equilibria(found), out)
    for outcome, share in found.outcomes.items():
        out.print(f"{100 * share:.4g} % of the starts: {outcome.text}")
    if found.unclassified:
        out.print("(slow ones may need more --transitions)")


def _orbits(found: Found) -> Table:
    forced = any(orbit.forcing_periods for orbit in found.orbits)
    mirrored = any(orbit.mirror is not None for orbit in found.orbits)
    titles = ["", "period", *["in forcing periods"] * forced, "stability", "multipliers", "starts"]
    titles += [*["mirror image"] * mirrored, "itinerary"]
    table = listing(*titles, right=("", "period", "in forcing periods", "starts"))
    for place, orbit in enumerate(found.orbits):
        table.add_row(
            str(place + 1),
            _number(orbit.period),
            *[", ".join(map(str, orbit.forcing_periods))] * forced,
            _stability(orbit.verdict),
            _pairs(orbit.orbit.multipliers.tolist()),
            _basin(orbit),
            *[_mirror(orbit.mirror, place, 0)] * mirrored,
            itinerary_text(orbit.itinerary),
        )
    return table


def _equilibria(found: Found) -> Table:
    mirrored = any(entry.mirror is not None for entry in found.equilibria)
    titles = ["", "equilibrium", "stability", "eigenvalues", "starts"]
    titles += [*["mirror image"] * mirrored, "configuration"]
    table = listing(*titles, right=("", "starts"))
    before = len(found.orbits)
    for place, entry in enumerate(found.equilibria):
        known = entry.equilibrium
        state = zip(known.names, known.state.tolist(), strict=True)
        table.add_row(
            str(before + place + 1),
            ", ".join(f"{name} = {_number(value)}" for name, value in state),
            _stability(known.verdict),
            _pairs(known.eigenvalues.tolist()),
            _basin(entry),
            *[_mirror(entry.mirror, place, before)] * mirrored,
            known.configuration,
        )
    return table


def _stability(verdict: str) -> Text:
    return Text(verdict, style={"stable": "green", "unstable": "red"}.get(verdict, ""))


def _basin(entry: FoundOrbit | FoundEquilibrium) -> str:
    return f"{100 * entry.share:.4g} %" if entry.starts else "-"


def _mirror(mirror: int | None, place: int, before: int) -> str:
    """Which entry an entry is the mirror image of; empty for none.

    `before` is the number of rows in the tables before.
    """
    if mirror is None:
        return ""
    return "its own" if mirror == place else f"of {before + mirror + 1}"


def _pairs(numbers: list[complex]) -> str:
    """Complex numbers in one text, conjugate pairs with a sign of plus or minus."""
    told = []
    for number in numbers:
        if number.imag < 0 and number.conjugate() in numbers:
            continue
        paired = number.imag > 0 and number.conjugate() in numbers
        told.append(_complex(number).replace(" + ", " ± ") if paired else _complex(number))
    return ", ".join(told)


def show_observables(found: Observables) -> None:
    """Show extremes and averages, shares of time, contact forces and the Lyapunov exponent."""
    out = console_as_wide()
    out.print()
    out.print(Text(f"From {_number(found.since)} on", style="bold"))
    states = listing(*_EXTREMES, right=_EXTREMES[1:])
    for name, low in found.minima.items():
        if name in _forced_names(found.trajectory):
            continue
        high = found.maxima[name]
        numbers = (low.value, low.time, high.value, high.time, found.means[name], found.rms[name])
        states.add_row(name, *map(_number, numbers))
    show_table(states, out)
    if found.contacts:
        contacts = listing(*_FORCES, right=_FORCES[1:])
        for name, contact in found.contacts.items():
            ends = contact.minimum.value, contact.maximum.value
            rest = contact.mean, contact.work, contact.dissipated
            contacts.add_row(name, *map(_number, (*ends, *rest)))
        show_table(contacts, out)
    shares = {name: share for name, share in found.fractions.items() if share}
    told = ", ".join(f"{name} {100 * share:.4g} %" for name, share in shares.items())
    out.print(f"time: {told}")
    for name, share in found.sticking.items():
        out.print(f"{name} sticks {100 * share:.4g} % of the time")
    exponent = largest_exponent(found)
    if isinstance(exponent, str):
        out.print(f"no Lyapunov exponent: {exponent}")
    else:
        out.print(f"largest Lyapunov exponent: {exponent.value:.6g}, error {exponent.error:.1g}")


def show_proof(proof: Proof) -> None:
    """Show how many transitions of a motion are proved, and why the proof goes no further."""
    out = console_as_wide()
    out.print()
    proved = f"proved: {_count(proof.transitions, 'transition')}, in balls of {proof.bits} bits"
    out.print(Text(proved, style="green" if proof.decided else ""))
    if proof.reason is not None:
        where = "" if proof.instant is None else f" at {proof.instant.mid}"
        out.print(f"then{where}: {proof.reason}")


def _forced(motion: Trajectory) -> set[int]:
    """Indices of the states that are the cosine or the sine of a forcing."""
    return {place for pair in motion.structure.forcing for place in pair}


def _forced_names(motion: Trajectory) -> set[str]:
    return {motion.names[place] for place in _forced(motion)}


def _angles(motion: Trajectory, row: int) -> list[float]:
    """Phase of each forcing behind a transition, in radians from 0 to 2 pi."""
    states = motion.states[row]
    return [
        float(np.arctan2(states[sine], states[cosine]) % (2 * np.pi))
        for cosine, sine in motion.structure.forcing
    ]


def show_sweep(diagram: Sweep) -> None:
    """Show how many points a bifurcation diagram has, and what the motions settle on."""
    points = int(np.isfinite(diagram.samples).sum())
    low, high = diagram.values[[0, diagram.done - 1]] if diagram.done else (np.nan, np.nan)
    print(
        f"{shown_name(diagram.system)}: {points} points of {diagram.state} {diagram.when},"
        f" {diagram.parameter} from {_number(low)} to {_number(high)}"
    )
    numbers, counts = np.unique(diagram.outcomes[: diagram.done], return_counts=True)
    texts = settled_texts()
    for number, count in zip(numbers[::-1].tolist(), counts[::-1].tolist(), strict=True):
        print(f"{texts[number]}: {_count(count, 'value')} of {diagram.parameter}")


def _complex(number: complex) -> str:
    if number.imag == 0:
        return f"{number.real:.6g}"
    return f"{number.real:.6g} {'-' if number.imag < 0 else '+'} {abs(number.imag):.6g}i"


def _number(value: float) -> str:
    return f"{value:.{_DIGITS}g}"


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}{'' if number == 1 else 's'}"
