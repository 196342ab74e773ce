"""What the commands that simulate show to people."""

from __future__ import annotations

import numpy as np
from rich import box
from rich.table import Table
from rich.text import Text

from nonsmooth.runtime.commands.display import wide_console
from nonsmooth.runtime.commands.report_motions import largest_exponent
from nonsmooth.runtime.composition.naming import itinerary_text
from nonsmooth.runtime.finding.find import Found, FoundEquilibrium, FoundOrbit
from nonsmooth.runtime.finding.settled import settled_texts
from nonsmooth.runtime.finding.sweep import Sweep
from nonsmooth.runtime.observing.observables import Observables
from nonsmooth.runtime.simulation.trajectory import Trajectory
from nonsmooth.runtime.validation.proof import Proof

__all__ = ["show_found", "show_motion", "show_observables", "show_proof", "show_sweep"]

_ROWS = 40  # of a long motion: the first and the last half of them
_DIGITS = 8
_WIDTH = 118


def show_motion(motion: Trajectory) -> None:
    """Show the transitions of a motion; of a long one the first and the last."""
    out = wide_console(_WIDTH)
    out.print(Text(f"{motion.name}, {_count(motion.transitions, 'transition')}", style="bold"))
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False, padding=(0, 2, 0, 0))
    table.add_column("time", justify="right", no_wrap=True)
    table.add_column("reached", min_width=22)
    table.add_column("then", no_wrap=True)
    for name in motion.names:
        table.add_column(name, justify="right", no_wrap=True)
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
            *map(_number, motion.states[i]),
        )
    out.print(table)
    out.print(f"ended at {_number(motion.end)}: {motion.message}")
    for g in motion.grazings:
        shape = motion.structure.boundaries[g.configuration][g.boundary]
        out.print(
            f"touched without crossing: {shape.name} at {_number(g.time)}, depth {g.depth:.1e}"
        )


def show_found(found: Found) -> None:
    """Show periodic orbits and equilibria, with stability and basin, and how else motions end."""
    out = wide_console(_WIDTH)
    kinds = [_count(len(found.orbits), "periodic orbit")]
    if found.equilibria:
        count = len(found.equilibria)
        kinds.append(f"{count} equilibri{'um' if count == 1 else 'a'}")
    title = f"{found.system}, {' and '.join(kinds)} from {_count(len(found.starts), 'start')}"
    out.print(Text(title, style="bold"))
    if found.orbits:
        out.print(_orbits(found))
    if found.equilibria:
        out.print(_equilibria(found))
    for outcome, share in found.outcomes.items():
        out.print(f"{100 * share:.4g} % of the starts: {outcome.text}")
    if found.unclassified:
        out.print("(slow ones may need more --transitions)")


def _orbits(found: Found) -> Table:
    forced = any(orbit.forcing_periods for orbit in found.orbits)
    mirrored = any(orbit.mirror is not None for orbit in found.orbits)
    table = _entries("period", *["in forcing periods"] * forced, "stability", "multipliers")
    table.add_column("starts", justify="right", no_wrap=True)
    if mirrored:
        table.add_column("mirror image")
    table.add_column("itinerary")
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
    table = _entries("equilibrium", "stability", "eigenvalues")
    table.add_column("starts", justify="right", no_wrap=True)
    if mirrored:
        table.add_column("mirror image")
    table.add_column("configuration")
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


def _entries(*names: str) -> Table:
    """A numbered table whose first column of that name is of numbers."""
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False, padding=(0, 2, 0, 0))
    table.add_column("", justify="right", no_wrap=True)
    for name in names:
        right = name in ("period", "in forcing periods")
        table.add_column(name, justify="right" if right else "left", no_wrap=name == "period")
    return table


def _stability(verdict: str) -> Text:
    return Text(verdict, style={"stable": "green", "unstable": "red"}.get(verdict, ""))


def _basin(entry: FoundOrbit | FoundEquilibrium) -> str:
    return f"{100 * entry.share:.4g} %" if entry.starts else "-"


def _mirror(mirror: int | None, place: int, before: int) -> str:
    """Of which entry one is the mirror image."""
    if mirror is None:
        return ""
    return "its own" if mirror == place else f"of {before + mirror + 1}"


def _pairs(numbers: list[complex]) -> str:
    """Complex numbers, of which conjugate ones are told together."""
    told = []
    for number in numbers:
        if number.imag < 0 and number.conjugate() in numbers:
            continue
        paired = number.imag > 0 and number.conjugate() in numbers
        told.append(_complex(number).replace(" + ", " ± ") if paired else _complex(number))
    return ", ".join(told)


def show_observables(found: Observables) -> None:
    """Show peaks and averages, shares of time, and what passes through the contacts."""
    out = wide_console(_WIDTH)
    out.print()
    out.print(Text(f"From {_number(found.since)} on", style="bold"))
    states = _listing("", "least", "at", "greatest", "at", "mean", "RMS")
    for name, low in found.minima.items():
        high = found.maxima[name]
        numbers = (low.value, low.time, high.value, high.time, found.means[name], found.rms[name])
        states.add_row(name, *map(_number, numbers))
    out.print(states)
    if found.contacts:
        contacts = _listing("force", "least", "greatest", "mean", "work", "dissipated")
        for name, contact in found.contacts.items():
            ends = contact.minimum.value, contact.maximum.value
            rest = contact.mean, contact.work, contact.dissipated
            contacts.add_row(name, *map(_number, (*ends, *rest)))
        out.print(contacts)
    shares = {name: share for name, share in found.fractions.items() if share}
    told = ", ".join(f"{name} {100 * share:.4g} %" for name, share in shares.items())
    out.print(f"time: {told}")
    for name, share in found.sticking.items():
        out.print(f"{name} sticks {100 * share:.4g} % of the time")
    exponent = largest_exponent(found)
    if exponent is not None:
        out.print(f"largest Lyapunov exponent: {float(exponent):.6g}")


def show_proof(proof: Proof) -> None:
    """Say how much of a motion's sequence is proved."""
    out = wide_console(_WIDTH)
    out.print()
    proved = f"proved: {_count(proof.transitions, 'transition')}, in balls of {proof.bits} bits"
    out.print(Text(proved, style="green" if proof.decided else ""))
    if proof.reason is not None:
        where = "" if proof.instant is None else f" at {proof.instant.mid}"
        out.print(f"then{where}: {proof.reason}")


def _listing(*names: str) -> Table:
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False, padding=(0, 2, 0, 0))
    for i, name in enumerate(names):
        table.add_column(name, justify="right" if i else "left", no_wrap=True)
    return table


def show_sweep(diagram: Sweep) -> None:
    """Say how many points a bifurcation diagram has, and what the motions settle on."""
    points = int(np.isfinite(diagram.samples).sum())
    low, high = diagram.values[[0, -1]]
    print(
        f"{diagram.system}: {points} points of {diagram.state} at each entry of"
        f" {diagram.configuration}, {diagram.parameter} from {_number(low)} to {_number(high)}"
    )
    numbers, counts = np.unique(diagram.outcomes, return_counts=True)
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
