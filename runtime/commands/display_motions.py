"""What the commands that simulate show to people."""

from __future__ import annotations

import numpy as np
from rich import box
from rich.table import Table
from rich.text import Text

from nonsmooth.runtime.commands.display import wide_console
from nonsmooth.runtime.commands.report_motions import largest_exponent
from nonsmooth.runtime.finding.find import Found
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
    """Show periodic orbits, with period, itinerary, stability and basin."""
    out = wide_console(_WIDTH)
    count = len(found.starts)
    title = f"{found.system}, {_count(len(found.orbits), 'periodic orbit')} from {count} starts"
    out.print(Text(title, style="bold"))
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False, padding=(0, 2, 0, 0))
    for name in ("", "period", "stability", "multipliers", "starts", "itinerary"):
        right = name in ("", "period", "starts")
        table.add_column(name, justify="right" if right else "left", no_wrap=right)
    for i, orbit in enumerate(found.orbits, 1):
        multipliers = ", ".join(_complex(m) for m in orbit.orbit.multipliers)
        style = {"stable": "green", "unstable": "red"}.get(orbit.verdict, "")
        phases = " -> ".join(configuration for configuration, _ in orbit.itinerary)
        basin = f"{100 * orbit.share:.4g} %" if orbit.starts else "-"
        table.add_row(
            str(i),
            _number(orbit.period),
            Text(orbit.verdict, style=style),
            multipliers,
            basin,
            phases,
        )
    out.print(table)
    for share, what in ((found.resting, "came to rest"), (found.unclassified, "not classified")):
        if share:
            out.print(f"{100 * share:.4g} % of the starts {what}")
    if found.unclassified:
        out.print("(slow ones may need more --transitions; motions that keep energy never settle)")


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
    if isinstance(exponent, str):
        out.print(f"no Lyapunov exponent: {exponent}")
    else:
        out.print(f"largest Lyapunov exponent: {exponent.value:.6g}, error {exponent.error:.1g}")


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
    """Say how many points a bifurcation diagram has."""
    points = int(np.isfinite(diagram.samples).sum())
    low, high = diagram.values[[0, diagram.done - 1]] if diagram.done else (np.nan, np.nan)
    print(
        f"{diagram.system}: {points} points of {diagram.state} {diagram.when},"
        f" {diagram.parameter} from {_number(low)} to {_number(high)}"
    )


def _complex(number: complex) -> str:
    if number.imag == 0:
        return f"{number.real:.6g}"
    return f"{number.real:.6g} {'-' if number.imag < 0 else '+'} {abs(number.imag):.6g}i"


def _number(value: float) -> str:
    return f"{value:.{_DIGITS}g}"


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}{'' if number == 1 else 's'}"
