"""What each kind of proof tells of itself, and what is told of one that was checked."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import fields, replace
from decimal import MAX_EMAX, MIN_EMIN, ROUND_DOWN, Context, Decimal
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.model.naming import shown_name
from nonsmooth.runtime.present.told import Listing, Rows, Told, first, given, many

if TYPE_CHECKING:
    from nonsmooth.runtime.present.check_file import Check
    from nonsmooth.runtime.proof.boxes.box_certificate import BoxCertificate
    from nonsmooth.runtime.proof.branch.certified_branch import (
        BranchEvent,
        CertifiedBranch,
        CertifiedDoubling,
        EventCertificate,
    )
    from nonsmooth.runtime.proof.census import Bounds, Census, Counted
    from nonsmooth.runtime.proof.certificate import Certificate, Enclosure, Proof
    from nonsmooth.runtime.proof.chaos.chaos_certificate import ChaosCertificate
    from nonsmooth.runtime.proof.sets.basin_certificate import BasinCertificate
    from nonsmooth.runtime.proof.sets.graph_certificate import Component, RegionCertificate

_SETS = 12  # components that are listed
_DOWN = Context(prec=3, rounding=ROUND_DOWN)  # no more is said than is proved
_WIDE = Context(prec=28, Emin=MIN_EMIN, Emax=MAX_EMAX)
_WHOLE = "the branch consists of exactly these intervals and events"
_PERIODS = 6  # numbers of iterates for which points that come back are counted
_UNPROVED = ("claim", "claims", "precision")  # rows that are not told of a file
_UNNAMED = "an orbit of the declaration in the file"


def _number(text: str) -> float | Decimal:
    """A number of a file as a double, or as a decimal where it is too large or small for one."""
    above, _, below = text.partition("/")
    number = _WIDE.divide(Decimal(above), Decimal(below or 1)).normalize(_WIDE)
    double = float(number)
    return double if math.isfinite(double) and bool(double) == bool(number) else number


def _stated(enclosures: Mapping[str, Enclosure]) -> list[str]:
    told = {name: ball.to_json() for name, ball in enclosures.items()}
    return [f"{n} = {_number(t['mid']):.12g} +- {_number(t['rad']):.2g}" for n, t in told.items()]


def _claims(claims: Mapping[str, str], reasons: Mapping[str, str]) -> list[str]:
    return [
        f"{name} {verdict}" + (f": {reasons[name]}" if reasons.get(name) else "")
        for name, verdict in claims.items()
    ]


def _claim(claim: str, reason: str) -> list[str]:
    return [f"{claim}: {reason}" if reason else claim]


def _of_orbit(proof: Any) -> Rows:
    """Rows with the itinerary of an orbit, its parameters, and which of them were chosen."""
    chosen = f"{', '.join(proof.chosen)} left open: chosen for this proof"
    way = " -> ".join([*(configuration for configuration, _ in proof.itinerary), "..."])
    return [
        ("given", given(proof.parameters)),
        ("chosen", [chosen] if proof.chosen else []),
        ("itinerary", [way] if proof.itinerary else []),
    ]


def _rounded(number: str) -> str:
    return f"{_number(number):.3g}"


def _certificate(proof: Certificate) -> Told:
    wanted = {n: proof.enclosures[n] for n in ("trace", "period") if n in proof.enclosures}
    period = {} if proof.given_period is None else {"period": proof.given_period}
    margins = [
        (
            f"{margin['phase']} {margin['configuration']}",
            margin["boundary"],
            f"{_rounded(margin['least'])} ({margin['quantity']})",
        )
        for margin in proof.margins
    ]
    title = f"certificate of {shown_name(proof.orbit)}, {proof.stability}"
    return title, [
        ("claims", _claims(proof.claims, proof.reasons)),
        ("enclosed", _stated(wanted)),
        *_of_orbit(replace(proof, parameters={**proof.parameters, **period})),
        ("orbit", Listing(("enclosure", "", "unique within"), _orbit(proof))),
        *_derivatives(proof),
        ("margins", Listing(("phase", "boundary", "respected by at least"), margins)),
        ("precision", [f"{proof.bits} bits"]),
    ]


def _orbit(proof: Certificate) -> list[tuple[str, str, str]]:
    """Rows of enclosures with the sides of the box of the unknowns, then of multipliers."""
    sides = {side.name: _rounded(side.rad) for side in proof.box}
    rows = [(name, str(ball), sides.get(name, "")) for name, ball in proof.enclosures.items()]
    for number, (re, im) in enumerate(proof.multipliers, 1):
        imaginary = "" if im.contains(0) else f" + {im} i"
        rows.append((f"multiplier {number}", f"{re}{imaginary}", ""))
    if proof.enclosures:
        others = proof.other_multipliers
        size = f"{_number(others):g}" if others else ""
        bound = f"at most {size} in absolute value" if size else "not enclosed"
        rows.append(("other multipliers", bound, ""))
    return rows


def _derivatives(proof: Certificate) -> Rows:
    """A row for each number by which derivatives were asked for, and what moves with it."""
    rows: list[tuple[str, Sequence[str] | Listing]] = []
    for name, direction in proof.directions.items():
        rates = [(of, str(found[name])) for of, found in proof.derivatives.items()]
        rows.append((f"by {name}", Listing(("derivative", f"by {name}"), rates)))
        if direction.keys() != {name}:
            moves = ", ".join(f"{other} by {rate}" for other, rate in direction.items())
            rows.append((f"with {name} by 1 moves", [moves]))
    told = [f"by {name}: {reason}" for name, reason in proof.no_derivatives.items()]
    return [*rows, ("no derivatives", told)]


def _box_certificate(proof: BoxCertificate) -> Told:
    sides = [f"{n} in {float(a):.6g} ... {float(b):.6g}" for n, (a, b) in proof.box.items()]
    shares = [
        f"{100 * float(share):.4g} % {verdict}, {many(proof.verdicts.count(verdict), 'tile')}"
        for verdict, share in proof.shares.items()
        if share
    ]
    bounds = [
        (name, f"{ball.lower:.8g}", f"{ball.upper:.8g}") for name, ball in proof.enclosures.items()
    ]
    curves = ("curve", "phase", "boundary", "tiles", "width", "from", "to")
    undecided = ("undecided", "of the box", "tiles", "events beside it")
    return (
        f"certificate of {shown_name(proof.orbit)} over a box, {many(len(proof.tiles), 'tile')}",
        [
            ("box", sides),
            ("claims", _claims(proof.claims, proof.reasons)),
            ("shares", shares),
            ("map", [proof.statement] if proof.statement else []),
            ("curves", Listing(curves, _curves(proof))),
            ("undecided", Listing(undecided, _open(proof))),
            ("enclosed", Listing(("enclosure", "from", "to"), bounds)),
            *_of_orbit(proof),
        ],
    )


def _curves(proof: BoxCertificate) -> list[list[str]]:
    rows = []
    for curve in proof.curves:
        ends = [
            ", ".join(f"{n} = {x:.6g}" for n, x in zip(proof.box, point, strict=True))
            for point in (curve.points[0], curve.points[-1])
        ]
        told = [f"{at} ({end})" for at, end in zip(ends, curve.ends, strict=False)]
        event = curve.event
        phase = "" if event.phase is None else str(event.phase + 1)
        size = [str(len(curve.tiles)), f"{curve.width:.1e}"]
        rows.append([event.kind, phase, event.boundary, *size, *(told or ["closed", ""])])
    return rows


def _open(proof: BoxCertificate) -> list[list[str]]:
    return [
        [
            ", ".join(
                f"{name} = {float(low):.6g} ... {float(high):.6g}"
                for name, (low, high) in box.where.items()
            ),
            f"{float(100 * box.share):.3g} %",
            str(box.tiles),
            "; ".join(box.events),
        ]
        for box in (proof.open if proof.statement else ())
    ]


def _place(event: BranchEvent | EventCertificate) -> str:
    """The phase and the boundary of an event."""
    where = event.configuration
    if event.phase is not None:
        where = f"phase {event.phase + 1} {where}"
    return f"{where}: {event.boundary}" if event.boundary else where


def _certified_branch(proof: CertifiedBranch) -> Told:
    low, high = (f"{float(end):.6g}" for end in proof.interval)
    over = f"{proof.parameter} = {low} ... {high}"
    ends = zip(("begins", "ends"), proof.ends, strict=True)
    return f"certified branch of {shown_name(proof.orbit)} over {over}", [
        ("claims", _claims(proof.claims, {})),
        ("intervals", Listing(("", proof.parameter, "", "tiles"), _intervals(proof))),
        ("complete", [_WHOLE] if proof.complete else []),
        *((word, [end or "not followed further"]) for word, end in ends),
        *_of_orbit(proof),
    ]


def _intervals(proof: CertifiedBranch) -> list[tuple[str, str, str, str]]:
    """Intervals and events in the order of the branch, and what is proved beyond events."""
    rows, events, before = [], iter(proof.events), "undecided"
    for part in proof.intervals:
        if "undecided" not in (before, part.verdict):
            event = next(events)
            value = event.enclosures[proof.parameter]
            rows.append((event.kind, str(value), _place(event), ""))
            for beyond in event.beyond:
                ends = f"{float(value):.10g} ... {beyond.reach:.10g}"
                way = " -> ".join(configuration for configuration, _ in beyond.itinerary)
                told = f"{beyond.scenario}: {way}"
                rows.append((f"beyond: {beyond.verdict}", ends, told, "1"))
        why = f"{part.width:.3g} wide: {part.reason}" if part.verdict == "undecided" else ""
        ends = f"{part.begin:.10g} ... {part.end:.10g}"
        rows.append((part.verdict, ends, why, str(part.tiles)))
        before = part.verdict
    return rows


def _certified_doubling(proof: CertifiedDoubling) -> Told:
    flip, doubled = proof.flip, proof.doubled
    value = "" if flip is None else f"{flip.enclosures[proof.parameter]} {proof.kind}".rstrip()
    rows: list[tuple[str, str]] = []
    near = []
    if doubled is not None:
        near = _claim(f"{doubled.verdict} {doubled.side} the flip", doubled.reason)
        parts = doubled.branch.intervals
        rows = [(part.verdict, f"{part.begin:.10g} ... {part.end:.10g}") for part in parts]
    return f"certified doubling of {shown_name(proof.orbit)} along {proof.parameter}", [
        ("claims", _claims(proof.claims, {})),
        ("flip", [value] if value else []),
        ("doubled", near),
        ("followed", Listing(("twice the period", proof.parameter), rows)),
        ("end", [proof.end] if proof.end else []),
        ("ended", [proof.ended]),
        ("given", given(proof.parameters)),
    ]


def _events(proofs: Sequence[EventCertificate]) -> Told:
    if not proofs:
        return "nothing happens: no events", []
    names = dict.fromkeys(shown_name(proof.orbit) for proof in proofs)
    rows = [
        (
            proof.kind,
            _place(proof),
            proof.claim,
            f"{proof.parameter} = {proof.value}" if proof.proved else proof.reason,
        )
        for proof in proofs
    ]
    return f"{many(len(proofs), 'event')} of {', '.join(names)}", [
        ("events", Listing(("event", "where", "", "parameter"), rows)),
        *_of_orbit(proofs[0]),
    ]


def _event_certificate(proof: EventCertificate) -> Told:
    value = {name: ball for name, ball in proof.enclosures.items() if name == proof.parameter}
    return f"certificate of a {proof.kind} of {shown_name(proof.orbit)}", [
        ("claim", _claim(proof.claim, proof.reason)),
        ("enclosed", _stated({**value, **proof.enclosures})),
        ("event", [proof.text]),
        *_of_orbit(proof),
    ]


def _census(census: Census) -> Told:
    number = f"{'exactly' if census.decided else 'at least'} {many(census.count, 'orbit')}"
    found = [orbit.certificate for orbit in census.orbits if orbit.certificate is not None]
    names = found[0].dwell_names if found else ()
    rows = [[str(number), *_counted(orbit, names)] for number, orbit in enumerate(census.orbits, 1)]
    undecided = [(_inequalities(box.bounds), box.reason) for box in census.undecided]
    return f"census of {shown_name(census.orbit)}: {number}", [
        ("box", [*census.box, *census.conditions]),
        ("admissible", [str(census.admissible)]),
        ("statement", [census.statement]),
        ("orbits", Listing(("orbit", *names, "admissible", "stability", ""), rows)),
        ("undecided", Listing(("undecided box", "why"), undecided)),
        ("looked at", [f"{census.looked} boxes"]),
    ]


def _counted(orbit: Counted, names: Sequence[str]) -> list[str]:
    """Dwell times, whether it is admissible, its stability, and why there is no certificate."""
    admissible = {True: "yes", False: "no", None: "undecided"}[orbit.admissible]
    proof = orbit.certificate
    if proof is None:
        why = f"{_inequalities(orbit.unique)}: no certificate: {orbit.reason}"
        return [*("" for _ in names), admissible, "undecided", why]
    words = {"proved": proof.stability, "refuted": "unstable"}
    times = [f"{float(proof.enclosures[name]):.9f}" for name in names]
    return [*times, admissible, words.get(proof.claims["stability"], "undecided"), ""]


def _inequalities(bounds: Bounds) -> str:
    return ", ".join(f"{low} <= {name} <= {high}" for name, (low, high) in bounds.items())


def _section(found: BasinCertificate | ChaosCertificate | RegionCertificate) -> str:
    """A phrase that says from which section to which the map P of a certificate goes."""
    if found.phase:
        cosine, sine = found.phase
        where = f"in {found.configuration} where the forcing has the phase ({cosine}, {sine})"
        return f"P goes over one period of the forcing, states {where}"
    where = f"behind {found.source} by {found.boundary} for {found.configuration}"
    return f"P goes from one passage of this transition to the next, states {where}"


def _power(found: BasinCertificate | ChaosCertificate) -> str:
    return "P" if found.iterates == 1 else f"P^{found.iterates}"


def _centre(found: BasinCertificate | ChaosCertificate, centre: Sequence[str]) -> str:
    return ", ".join(f"{n} = {x}" for n, x in zip(found.coordinates, centre, strict=True))


def _basin(found: BasinCertificate) -> Told:
    rows: list[tuple[str, Sequence[str] | Listing]] = []
    if found.proved and found.core is not None:
        good = int((found.ranks >= 0).sum())
        rows.append(("section", [f"{good} of {found.ranks.size} boxes", *found.coordinates]))
        if found.tiles is not None:
            tiles = f"{int(found.attracted.sum())} attracted of {int(found.looked.sum())} looked at"
            sides = ", ".join(f"{side:g}" for side in found.tiles.sides)
            share = f"{_DOWN.create_decimal(100 * found.share)} % of the box"
            rows.append(("tiles", [f"{tiles}, of {found.looked.size}", share, f"sides {sides}"]))
        about = _centre(found, found.core.centre)
        told = f"{_power(found)} contracts a set about {about}, by less than {found.contraction}"
        bounds = found.to_json()["section"]["bounds"]
        reached = [f"{name} from {a:.6g} to {b:.6g}" for name, (a, b) in bounds.items()]
        rows += [("map", [_section(found), told]), ("statement", [found.statement])]
        rows.append(("attracted on the section", reached))
    return f"certificate of the basin of {shown_name(found.orbit)}", [
        ("claim", _claim(found.claim, found.reason)),
        *rows,
        ("given", given(found.parameters)),
    ]


def _chaos(found: ChaosCertificate) -> Told:
    rows: list[tuple[str, Sequence[str] | Listing]] = []
    if found.proved:
        pairs = [f"{one} covers {other}" for one, other in found.coverings]
        power = f"by {found.iterates} iterates of the map"
        rows.append(("entropy", [f"at least {found.entropy}"]))
        if found.cones is not None:
            rows.append(("exponents", [f"at least {found.exponent}"]))
        rows.append(("sets", [many(len(found.h_sets), "set"), power, *first(pairs)]))
        rows.append(("map", [_section(found)]))
        targets = {
            own.name: ", ".join(to for one, to in found.coverings if one == own.name)
            for own in found.h_sets
        }
        sets = [(own.name, _centre(found, own.centre), targets[own.name]) for own in found.h_sets]
        rows.append(("coverings", Listing(("set", "about", f"covers by {_power(found)}"), sets)))
        steps = range(1, _PERIODS + 1)
        counts = ", ".join(str(found.periodic_points(count)) for count in steps)
        least = "at least" if found.cones is None else "exactly, of these histories"
        told = f"points that come back after 1 to {_PERIODS} times {_power(found)}, {least}"
        rows.append(("periodic", [f"{told}: {counts}"]))
        if found.cones is not None:
            rows.append(("histories", ["each is that of one motion, which is hyperbolic"]))
    return f"certificate of chaos of {shown_name(found.system)}", [
        ("claim", _claim(found.claim, found.reason)),
        *rows,
        ("tried", first(found.tried) if not found.proved else []),
        ("given", given(found.parameters)),
    ]


def _graph(found: RegionCertificate) -> Told:
    grid = found.graph.grid
    region = [f"{name} = {a:g}:{b:g}" for name, (a, b) in found.region.items()]
    divided = f", divided into {len(grid)}" if len(grid) > len(grid.grid) else ""
    told = [
        many(sum(own.attracting for own in found.components), "attracting component"),
        f"{len(found.trapping)} of {len(grid)} boxes in the largest trapping region",
    ]
    unknown = [f"images of {len(found.unknown)} boxes"] if len(found.unknown) else []
    outside = [f"images of {len(found.outside)} boxes"] if len(found.outside) else []
    listed = found.components[:_SETS]
    rows = [_component(found, number, own) for number, own in enumerate(listed)]
    rest = len(found.components) - _SETS
    return f"region of {shown_name(found.system)}", [
        ("proved", told),
        ("components", Listing(("component", "boxes", "within", "", "leads to"), rows)),
        ("smaller", [f"{rest} components"] if rest > 0 else []),
        ("not known", unknown),
        ("may leave the region", outside),
        ("region", [*region, f"{' x '.join(map(str, grid.grid.counts))} boxes{divided}"]),
        ("map", [_section(found)]),
        ("given", given(found.parameters)),
    ]


def _component(found: RegionCertificate, number: int, own: Component) -> list[str]:
    ends = zip(found.coordinates, own.low, own.high, strict=True)
    within = ", ".join(f"{name} = {a:g}:{b:g}" for name, a, b in ends)
    ahead = [str(j) for i, j in found.arrows if i == number]
    ahead += ["outside or not known"] if own.leaves else []
    kind = "attracting" if own.attracting else ""
    return [str(number), str(len(own.boxes)), within, kind, ", ".join(ahead)]


def _proof(proof: Proof) -> Told:
    rows = [("times", first(_stated({"t": t})[0] for t in proof.times))]
    if proof.reason:
        rows.insert(0, ("until", [proof.reason]))
    rows.append(("given", given(proof.parameters)))
    return (
        f"proved motion of {shown_name(proof.system)}, {many(proof.transitions, 'transition')}",
        rows,
    )


def _check(check: Check) -> Told:
    title = "every claim is proved again" if check.difference is None else "the file is wrong"
    rows: Iterable[tuple[str, Sequence[str] | Listing]] = ()
    if check.certificate is not None:
        about, own = _proved_again(check)
        rows = [("of", [about]), *(row for row in own if row[0] not in _UNPROVED)]
    return title, [
        ("claims", _claims(check.claims, {})),
        ("difference", [check.difference] if check.difference else []),
        ("note", [check.note] if check.note else []),
        *rows,
    ]


def _proved_again(check: Check) -> Told:
    """What is told of a file's proof, without names and values that nothing was compared with."""
    found: Any = check.certificate
    if isinstance(found, tuple):
        return _events(tuple(_bound(one, check) for one in found if one.proved))
    if "proved" not in check.claims.values() and "refuted" not in check.claims.values():
        return "nothing is claimed", []
    return PROOFS[type(found).__name__](_bound(found, check))


def _bound(found: Any, check: Check) -> Any:
    """A proof of a file with the names and values that its declaration fixes."""
    known = {own.name for own in fields(found)}
    changes: dict[str, Any] = {"chosen": ()} if "chosen" in known else {}
    if type(found).__name__ == "BasinCertificate":
        changes["orbit"] = "the orbit through the core"
    elif not check.compared and "orbit" in known:
        changes["orbit"] = _UNNAMED
    point = type(found).__name__ == "Certificate"
    if point:  # where it is unique, and what is far from a boundary, is shown of proofs alone
        changes |= {"box": (), "margins": ()}
    if point and not check.compared and not found.declaration.get("parameters"):
        changes["parameters"] = {}
    return replace(found, **changes)


PROOFS: dict[str, Callable[[Any], Told]] = {
    "BasinCertificate": _basin,
    "BoxCertificate": _box_certificate,
    "Census": _census,
    "Certificate": _certificate,
    "CertifiedBranch": _certified_branch,
    "CertifiedDoubling": _certified_doubling,
    "ChaosCertificate": _chaos,
    "Check": _check,
    "EventCertificate": _event_certificate,
    "RegionCertificate": _graph,
    "Proof": _proof,
    "tuple": _events,
}
