"""What the commands that certify show to people: orbits, boxes, regions, branches, basins."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from decimal import ROUND_DOWN, Context
from typing import TYPE_CHECKING

from rich.console import Console
from rich.table import Table
from rich.text import Text

from nonsmooth.runtime.cli.tables import STYLES, console_as_wide, listing, show_table
from nonsmooth.runtime.model.naming import shown_name
from nonsmooth.runtime.proof.basin.basin_certificate import BasinCertificate
from nonsmooth.runtime.proof.boxes.box_certificate import BoxCertificate
from nonsmooth.runtime.proof.branch.certified_branch import FINISHED, UNDECIDED, CertifiedBranch
from nonsmooth.runtime.proof.certificate import Certificate
from nonsmooth.runtime.proof.chaos.chaos_certificate import ChaosCertificate
from nonsmooth.runtime.proof.counting.census import Bounds, Census
from nonsmooth.runtime.proof.doubling.certified_doubling import CertifiedDoubling
from nonsmooth.runtime.proof.events.event_certificate import EventCertificate

if TYPE_CHECKING:
    from rich.console import Console

    from nonsmooth.runtime.core.values import Value
    from nonsmooth.runtime.proof.boxes.box_certificate import BoxCertificate
    from nonsmooth.runtime.proof.chaos.chaos_certificate import ChaosCertificate
    from nonsmooth.runtime.proof.graphs.graph_certificate import GraphCertificate

__all__ = [
    "UNIFORM",
    "basin_lines",
    "branch_table",
    "chaos_lines",
    "doubling_table",
    "enclosure_table",
    "section_words",
    "share_table",
    "show_basin",
    "show_box",
    "show_boxes",
    "show_branch",
    "show_census",
    "show_certificate",
    "show_chaos",
    "show_derivatives",
    "show_doubling",
    "show_events",
    "show_graph",
    "show_regions",
]

_VERDICTS = {True: ("yes", "green"), False: ("no", "red"), None: ("undecided", "yellow")}
_MOST_REGIONS = 12  # rows of a table
_MOST_SETS = 12  # components that are listed
_ENDS = {
    "unfinished": "the work was stopped, and --resume goes on with it",
    "no flip": "the branch has no flip that is proved",
    "not covered": "such orbits are not covered",
    "not proved": "a step is not proved",
}
UNIFORM = {
    "existence": "one orbit next to the one that was followed",
    "admissibility": "a motion of the real system",
}
_DOWN = Context(prec=3, rounding=ROUND_DOWN)  # no more is said than is proved


def show_census(census: Census) -> None:
    """Show what a census proves, its orbits, and the boxes that are undecided."""
    out = console_as_wide()
    out.print(Text(f"{shown_name(census.orbit)}, {census.looked} boxes", style="bold"))
    out.print(Text(" -> ".join([*(c for c, _ in census.itinerary), "..."])))
    found = [orbit.certificate for orbit in census.orbits if orbit.certificate is not None]
    names = found[0].dwell_names if found else ()
    table = listing("orbit", *names, "admissible", "stability")
    for number, orbit in enumerate(census.orbits, 1):
        word, style = _VERDICTS[orbit.admissible]
        times = ["" for _ in names]
        stability = "undecided"
        if orbit.certificate is not None:
            times = [f"{float(orbit.certificate.enclosures[n]):.9f}" for n in names]
            words = {"proved": orbit.certificate.stability, "refuted": "unstable"}
            stability = words.get(orbit.certificate.claims["stability"], stability)
        table.add_row(str(number), *times, Text(word, style=style), stability)
    if census.orbits:
        show_table(table, out)
    for number, orbit in enumerate(census.orbits, 1):
        if orbit.certificate is None:
            out.print(f"orbit {number}, {_text(orbit.unique)}: no certificate: {orbit.reason}")
    if census.undecided:
        table = listing("undecided box", "why")
        for entry in census.undecided:
            table.add_row(_text(entry.bounds), entry.reason)
        show_table(table, out)
    style = "green" if census.decided else "yellow"
    out.print(Text(census.statement, style=style))


def _text(bounds: Bounds) -> str:
    return ", ".join(f"{low} <= {name} <= {high}" for name, (low, high) in bounds.items())


def show_regions(out: Console, found: BoxCertificate) -> None:
    """Show the regions, the curves and the undecided parts of a box of two parameters.

    Nothing is shown of a box of another number of parameters.
    """
    if not found.statement:
        return
    out.print(Text(found.statement))
    if found.curves:
        table = listing("curve", "phase", "boundary", "tiles", "width", "from", "to")
        for curve in found.curves[:_MOST_REGIONS]:
            event = curve.event
            ends = [_place(found, point) for point in (curve.points[0], curve.points[-1])]
            told = [f"{at} ({end})" for at, end in zip(ends, curve.ends, strict=False)]
            table.add_row(
                event.kind,
                "" if event.phase is None else str(event.phase + 1),
                event.boundary,
                str(len(curve.tiles)),
                f"{curve.width:.1e}",
                *(told or ["closed", ""]),
            )
        show_table(table, out)
    if found.open:
        table = listing("undecided", "of the box", "tiles", "events beside it")
        for box in found.open[:_MOST_REGIONS]:
            where = ", ".join(
                f"{name} = {float(low):.6g} ... {float(high):.6g}"
                for name, (low, high) in box.where.items()
            )
            share = f"{float(100 * box.share):.3g} %"
            table.add_row(where, share, str(box.tiles), "; ".join(box.events))
        show_table(table, out)
    hidden = max(len(found.curves), len(found.open)) - _MOST_REGIONS
    if hidden > 0:
        out.print(Text(f"and {hidden} more, which --json lists", style="dim"))


def _place(found: BoxCertificate, point: tuple[float, float]) -> str:
    return ", ".join(f"{n} = {x:.6g}" for n, x in zip(found.box, point, strict=True))


def show_graph(found: GraphCertificate) -> None:
    """Show the region of a graph of boxes, its largest trapping region and its components."""
    out = console_as_wide()
    out.print(Text(f"{shown_name(found.system)}, {found.bits} bits", style="bold"))
    show_boxes(out, found)


def show_boxes(out: Console, found: GraphCertificate) -> None:
    """Show the part of `show_graph` that follows the name of the system."""
    grid = found.graph.grid
    region = ", ".join(f"{name} = {a:g}:{b:g}" for name, (a, b) in found.region.items())
    out.print(f"the map P {section_words(found)}")
    divided = f", divided into {len(grid)}" if len(grid) > len(grid.grid) else ""
    out.print(f"region {region} in {' x '.join(map(str, grid.grid.counts))} boxes{divided}")
    out.print(f"largest trapping region: {len(found.trapping)} boxes")
    table = listing("component", "boxes", "within", "", "leads to")
    for number, own in enumerate(found.components[:_MOST_SETS]):
        ends = zip(found.coordinates, own.low, own.high, strict=True)
        within = ", ".join(f"{name} = {a:g}:{b:g}" for name, a, b in ends)
        kind = Text("attracting", style="green") if own.attracting else Text("")
        ahead = [str(j) for i, j in found.arrows if i == number]
        ahead += ["outside or not known"] if own.leaves else []
        table.add_row(str(number), str(len(own.boxes)), within, kind, ", ".join(ahead))
    show_table(table, out)
    if (rest := len(found.components) - _MOST_SETS) > 0:
        out.print(f"and {rest} smaller components")
    out.print(f"boxes whose image is not known: {len(found.unknown)}")
    out.print(f"boxes whose image may leave the region: {len(found.outside)}")


def section_words(found: ChaosCertificate | GraphCertificate) -> str:
    """A phrase that says from which section to which the map of a certificate goes."""
    if found.phase:
        cosine, sine = found.phase
        where = f"in {found.configuration} where the forcing has the phase ({cosine}, {sine})"
        return f"over one period of the forcing, states {where}"
    where = f"behind {found.source} by {found.boundary} for {found.configuration}"
    return f"from one passage of this transition to the next, states {where}"


def _show_claims(certificate: Certificate) -> None:
    out = console_as_wide()
    out.print(Text(f"{shown_name(certificate.orbit)}, {certificate.bits} bits", style="bold"))
    out.print(Text(" -> ".join([*(c for c, _ in certificate.itinerary), "..."])))
    table = listing("claim", "", "")
    meaning = {
        "existence": "one orbit, and no other, in the box",
        "admissibility": "a motion of the real system",
        "stability": certificate.stability,
    }
    for name, verdict in certificate.claims.items():
        told = Text("not " * (verdict == "refuted") + meaning[name])
        if name in certificate.reasons:
            told.append(f": {certificate.reasons[name]}", style="dim")
        table.add_row(name, Text(verdict, style=STYLES[verdict]), told)
    show_table(table, out)


def show_certificate(certificate: Certificate) -> None:
    """Show claims, parameters, enclosures with their box, derivatives and margins."""
    _show_claims(certificate)
    out = console_as_wide()
    values = {**certificate.parameters}
    if certificate.given_period is not None:
        values["period"] = certificate.given_period
    _show_point(values, certificate.chosen, out)
    for name, reason in certificate.no_derivatives.items():
        out.print(Text(f"no derivatives by {name}: {reason}", style="dim"))
    if not certificate.enclosures:
        return
    table = listing("enclosure", "", "unique within")
    sides = {side.name: side.rad for side in certificate.box}
    for name, enclosure in certificate.enclosures.items():
        table.add_row(name, str(enclosure), _rounded(sides[name]) if name in sides else "")
    for number, (re, im) in enumerate(certificate.multipliers, 1):
        imaginary = "" if im.contains(0) else f" + {im} i"
        table.add_row(f"multiplier {number}", f"{re}{imaginary}", "")
    others = certificate.other_multipliers
    bound = f"at most {float(others):g} in absolute value" if others else "not enclosed"
    table.add_row("other multipliers", bound, "")
    show_table(table, out)
    show_derivatives(out, certificate)
    if certificate.margins:
        table = listing("phase", "boundary", "respected by at least")
        for margin in certificate.margins:
            place = f"{margin['phase']} {margin['configuration']}"
            size = f"{_rounded(margin['least'])} ({margin['quantity']})"
            table.add_row(place, margin["boundary"], size)
        show_table(table, out)


def show_derivatives(out: Console, certificate: Certificate) -> None:
    """Show the enclosed derivatives.

    Where a name stands for a direction of several parameters, what moves along it is shown.
    """
    if not certificate.derivatives:
        return
    table = listing("derivative", "by", "")
    for quantity, rates in certificate.derivatives.items():
        for name, enclosure in rates.items():
            table.add_row(quantity, name, str(enclosure))
    show_table(table, out)
    for name, direction in certificate.directions.items():
        if direction.keys() != {name}:
            moves = ", ".join(f"{other} by {rate}" for other, rate in direction.items())
            out.print(Text(f"with {name} by 1 moves {moves}", style="dim"))


def show_box(found: BoxCertificate) -> None:
    """Show what is proved for a box of parameters, and for which share of it."""
    out = console_as_wide()
    ends = ", ".join(f"{name} = {low} ... {high}" for name, (low, high) in _decimal(found))
    out.print(Text(f"{shown_name(found.orbit)} for all {ends}", style="bold"))
    out.print(Text(" -> ".join([*(c for c, _ in found.itinerary), "..."])))
    table = listing("claim", "", "")
    reasons = found.reasons
    for name, verdict in found.claims.items():
        told = Text(found.stability if name == "stability" else UNIFORM[name])
        if name in reasons:
            told.append(f"; {verdict} {reasons[name]}", style="dim")
        table.add_row(name, Text(verdict, style=STYLES[verdict]), told)
    show_table(table, out)
    show_table(share_table(found), out)
    show_regions(out, found)
    _show_point(found.parameters, found.chosen, out)
    if found.enclosures:
        show_table(enclosure_table(found), out)


def _show_point(values: Mapping[str, Value], chosen: Sequence[str], out: Console) -> None:
    """Show the fixed parameters of a proof, and which of them were chosen for it."""
    if values:
        out.print(Text("at " + ", ".join(f"{name} = {value}" for name, value in values.items())))
    if chosen:
        out.print(Text(f"{', '.join(chosen)} left open: chosen for this proof", style="dim"))


def share_table(found: BoxCertificate) -> Table:
    """Share of the box and number of tiles, one row for each verdict that occurs."""
    table = listing("of the box", "", "tiles")
    for verdict, share in found.shares.items():
        tiles = found.verdicts.count(verdict)
        name = f"{found.stability}, proved" if verdict == "proved" else verdict
        name = "divided by a curve" if verdict == "divided" else name
        if tiles:
            table.add_row(name, f"{float(100 * share):.4g} %", str(tiles))
    return table


def enclosure_table(found: BoxCertificate) -> Table:
    """Bounds over all of the box, one row for each enclosed number."""
    table = listing("enclosure", "from", "to")
    for name, enclosure in found.enclosures.items():
        table.add_row(name, f"{enclosure.lower:.8g}", f"{enclosure.upper:.8g}")
    return table


def show_events(told: str, found: Sequence[EventCertificate]) -> None:
    """Show where events are proved to be, below a title that says what they are events of."""
    out = console_as_wide()
    out.print(Text(told, style="bold"))
    table = listing("event", "where", "", "parameter")
    for certificate in found:
        where = ""
        if certificate.phase is not None:
            where = f"phase {certificate.phase + 1} {certificate.configuration}:"
            where += f" {certificate.boundary}"
        value = certificate.reason
        if certificate.proved:
            value = f"{certificate.parameter} = {certificate.value}"
        claim = Text(certificate.claim, style=STYLES[certificate.claim])
        table.add_row(certificate.kind, where, claim, value)
    if found:
        show_table(table, out)
    else:
        out.print(Text("nothing happens: no events"))


def show_branch(found: CertifiedBranch) -> None:
    """Show the intervals of a proved branch and the events between them."""
    out = console_as_wide()
    low, high = map(float, found.interval)
    over = f"{found.parameter} = {low:.6g} ... {high:.6g}"
    out.print(Text(f"{shown_name(found.orbit)}, {over}", style="bold"))
    out.print(Text(" -> ".join([*(c for c, _ in found.itinerary), "..."])))
    if found.intervals:
        show_table(branch_table(found), out)
    for name, value in (("beginning", found.ends[0]), ("end", found.ends[1])):
        if value != FINISHED:
            out.print(Text(f"{name}: {value or 'not followed further'}", style="dim"))
    _show_point(found.parameters, found.chosen, out)
    if found.complete:
        out.print(Text("the branch consists of exactly these intervals and events", style="green"))


def branch_table(found: CertifiedBranch) -> Table:
    """Intervals and events in the order of the branch, and what is proved beyond events."""
    table = listing("", found.parameter, "", "tiles")
    events = iter(found.events)
    before = UNDECIDED
    for part in found.intervals:
        if UNDECIDED not in (before, part.verdict):
            event = next(events)
            where = event.configuration
            if event.phase is not None:
                where = f"phase {event.phase + 1} {where}: {event.boundary}"
            value = str(event.enclosures[found.parameter])
            table.add_row(Text(event.kind, style="bold"), value, where, "")
            for beyond in event.beyond:
                ends = f"{float(event.enclosures[found.parameter]):.10g} ... {beyond.reach:.10g}"
                way = " -> ".join(configuration for configuration, _ in beyond.itinerary)
                table.add_row(f"beyond: {beyond.verdict}", ends, f"{beyond.scenario}: {way}", "1")
        told = f"{part.begin:.10g} ... {part.end:.10g}"
        why = part.reason
        if part.verdict == UNDECIDED:
            why = f"{part.width:.3g} wide: {why}"
        style = "yellow" if part.verdict == UNDECIDED else ""
        table.add_row(Text(part.verdict, style=style), told, why, str(part.tiles))
        before = part.verdict
    return table


def show_doubling(found: CertifiedDoubling) -> None:
    """Show the flip, and what is proved of the orbits of twice the period beside it."""
    out = console_as_wide()
    out.print(Text(f"{shown_name(found.orbit)}, along {found.parameter}", style="bold"))
    show_table(doubling_table(found), out)
    values = found.parameters
    out.print(Text("at " + ", ".join(f"{name} = {value}" for name, value in values.items())))
    if found.ended != "complete":
        told = f"ended because {_ENDS[found.ended]}"
        out.print(Text(f"{told}: {found.end}" if found.end else told, style="yellow"))


def doubling_table(found: CertifiedDoubling) -> Table:
    """A row for the flip, one for the doubled orbits, and one for each part of their branch."""
    table = listing("", found.parameter, "", "phases")
    doubled, flip = found.doubled, found.flip
    if doubled is None or flip is None:
        return table
    phases = len(found.branch.itinerary)
    value = str(flip.enclosures[found.parameter])
    table.add_row(Text("flip", style="bold"), value, found.kind, str(phases))
    low, high = map(float, doubled.branch.interval)
    near = f"{doubled.side} the flip: {doubled.verdict}"
    told = f"{near}: {doubled.reason}" if doubled.reason else near
    table.add_row("doubled orbits", f"{low:.10g} ... {high:.10g}", told, str(2 * phases))
    for part in doubled.branch.intervals:
        table.add_row("", f"{part.begin:.10g} ... {part.end:.10g}", part.verdict, "")
    return table


def show_chaos(found: ChaosCertificate) -> None:
    """Show what is proved of chaos, or, if nothing is, what was tried."""
    out = console_as_wide()
    out.print(Text(f"{shown_name(found.system)}, {found.bits} bits", style="bold"))
    table = listing("claim", "", "")
    table.add_row("chaos", Text(found.claim, style=STYLES[found.claim]), found.reason)
    show_table(table, out)
    if not found.proved:
        for line in found.tried:
            out.print(f"tried: {line}")
        return
    for line in chaos_lines(found):
        out.print(line)


def chaos_lines(found: ChaosCertificate) -> list[str]:
    """What a proved certificate of chaos says, in lines of text."""
    lines = [
        f"the map P {section_words(found)}",
        f"topological entropy of P at least {found.entropy}",
    ]
    power = "P" if found.iterates == 1 else f"P^{found.iterates}"
    for h_set in found.h_sets:
        targets = [other for one, other in found.coverings if one == h_set.name]
        centre = ", ".join(
            f"{name} = {x}" for name, x in zip(found.coordinates, h_set.centre, strict=True)
        )
        lines.append(f"{h_set.name} about {centre} covers {', '.join(targets)} by {power}")
    counts = ", ".join(str(found.periodic_points(steps)) for steps in range(1, 7))
    least = "at least" if found.cones is None else "exactly, of these histories"
    lines.append(f"points that come back after 1 to 6 times {power}, {least}: {counts}")
    if found.cones is not None:
        lines.append(f"largest Lyapunov exponents of these motions at least {found.exponent} by P")
        lines.append("each history through the graph is that of one motion, which is hyperbolic")
    return lines


def _decimal(found: BoxCertificate) -> list[tuple[str, tuple[float, float]]]:
    return [(name, (float(low), float(high))) for name, (low, high) in found.box.items()]


def _rounded(text: str) -> str:
    return f"{float(text):.3g}"


def show_basin(found: BasinCertificate) -> None:
    """Show what is proved of a basin."""
    out = console_as_wide()
    out.print(Text(f"{shown_name(found.orbit)}, {found.bits} bits", style="bold"))
    table = listing("claim", "", "")
    table.add_row("basin", Text(found.claim, style=STYLES[found.claim]), found.reason)
    show_table(table, out)
    for line in basin_lines(found):
        out.print(line)


def basin_lines(found: BasinCertificate) -> list[str]:
    """What is proved of a basin, in lines of text; none if nothing is."""
    if not found.proved or found.core is None or found.grid is None:
        return []
    if found.phase:
        cosine, sine = found.phase
        where = f"in {found.configuration} where the forcing has the phase ({cosine}, {sine})"
    else:
        where = f"behind {found.source} by {found.boundary} for {found.configuration}"
    centre = ", ".join(
        f"{name} = {x}" for name, x in zip(found.coordinates, found.core.centre, strict=True)
    )
    power = "P" if found.iterates == 1 else f"P^{found.iterates}"
    lines = [
        f"the map P takes states {where}, to where they come back to it",
        f"{power} contracts a set about {centre}, by less than {found.contraction}",
        f"{found.statement}",
    ]
    known = found.to_json()
    lines += [
        f"the section: {name} from {low:.6g} to {high:.6g}"
        for name, (low, high) in known["section"]["bounds"].items()
    ]
    if found.tiles is not None:
        looked = int(found.looked.sum())
        good = int(found.attracted.sum())
        sides = ", ".join(f"{side:g}" for side in found.tiles.sides)
        lines.append(
            f"tiles of the sides {sides}: {good} of {looked} that were looked at are attracted,"
            f" {_DOWN.create_decimal(100 * found.share)} % of the box"
        )
    return lines
