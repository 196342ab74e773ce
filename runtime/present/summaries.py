"""What a result is, in a few lines: for a console, and as a table for a notebook."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from itertools import islice
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.values import decimal_string
from nonsmooth.runtime.model.naming import itinerary_text, shown_name
from nonsmooth.runtime.present.notebook import table_html

if TYPE_CHECKING:
    from nonsmooth.runtime.core.differentiable import DifferentiableFunction
    from nonsmooth.runtime.explore.continuation.branch import Branch
    from nonsmooth.runtime.explore.continuation.continue_event import Locus
    from nonsmooth.runtime.explore.continuation.event import Event
    from nonsmooth.runtime.explore.design.optimum import Design
    from nonsmooth.runtime.explore.finding.found import Found
    from nonsmooth.runtime.explore.finding.sweep import Sweep
    from nonsmooth.runtime.explore.fitting.fit_record import Fit
    from nonsmooth.runtime.explore.fitting.measurements import Experiment
    from nonsmooth.runtime.orbits.motion import Motion
    from nonsmooth.runtime.orbits.orbit import Orbit
    from nonsmooth.runtime.orbits.orbit_arrays import Orbits
    from nonsmooth.runtime.present.checking.check_file import Check
    from nonsmooth.runtime.proof.basin.basin_certificate import BasinCertificate
    from nonsmooth.runtime.proof.boxes.box_certificate import BoxCertificate
    from nonsmooth.runtime.proof.branch.certified_branch import CertifiedBranch
    from nonsmooth.runtime.proof.certificate import Certificate
    from nonsmooth.runtime.proof.chaos.chaos_certificate import ChaosCertificate
    from nonsmooth.runtime.proof.counting.census import Census
    from nonsmooth.runtime.proof.doubling.certified_doubling import CertifiedDoubling
    from nonsmooth.runtime.proof.events.event_certificate import EventCertificate
    from nonsmooth.runtime.proof.graphs.graph_certificate import GraphCertificate
    from nonsmooth.runtime.proof.motion.motion_proof import Enclosure, Proof
    from nonsmooth.runtime.simulation.engines import Trajectories
    from nonsmooth.runtime.simulation.last_cycle import Recurrence
    from nonsmooth.runtime.simulation.returns import PoincareMap
    from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["summary_html", "summary_text"]

# the title, then what is told of it: a console has the first rows, in one line each
Summary = tuple[str, list[tuple[str, list[str]]]]

_ROWS, _WIDTH = 3, 96  # in a console
_MOST = 12  # entries of a row


def summary_text(result: Any) -> str:
    """Text of at most four lines that describes a result of a public kind."""
    title, rows = _summary(result)
    shown = list(islice(((name, lines) for name, lines in rows if lines), _ROWS))
    widest = max((len(name) for name, _ in shown), default=0)
    told = [f"  {name:{widest}}  {'; '.join(lines)}" for name, lines in shown]
    return "\n".join(_short(line) for line in (title, *told))


def summary_html(result: Any) -> str:
    """HTML of a table that describes a result of a public kind, for a notebook."""
    title, rows = _summary(result)
    return table_html(title, [(name, lines) for name, lines in rows if lines])


def _summary(result: Any) -> Summary:
    return _KINDS[type(result).__name__](result)


def _short(line: str) -> str:
    line = line.replace("\n", " ")
    return line if len(line) <= _WIDTH else line[: _WIDTH - 3].rstrip() + "..."


def _first(lines: Iterable[str]) -> list[str]:
    """The first entries, and the number of the remaining ones."""
    every = list(lines)
    left = len(every) - _MOST
    return every if left <= 0 else [*every[:_MOST], f"and {left} more"]


def _many(count: int, one: str) -> str:
    return f"{count} {one}{'s' * (count != 1)}"


def _range(values: Any) -> str:
    low, high = float(np.nanmin(values)), float(np.nanmax(values))
    return f"{low:.6g} ... {high:.6g}"


def _given(values: Mapping[str, Any]) -> list[str]:
    return [f"{name} = {value}" for name, value in values.items()]


def _counts(names: Iterable[str]) -> list[str]:
    return [f"{count} {name}" for name, count in Counter(names).most_common()]


def _stated(enclosures: Mapping[str, Enclosure]) -> list[str]:
    told = {name: ball.to_json() for name, ball in enclosures.items()}
    return [f"{n} = {float(t['mid']):.12g} +- {float(t['rad']):.2g}" for n, t in told.items()]


def _claims(claims: Mapping[str, str], reasons: Mapping[str, str]) -> list[str]:
    return [
        f"{name} {verdict}" + (f": {reasons[name]}" if reasons.get(name) else "")
        for name, verdict in claims.items()
    ]


def _orbit(orbit: Orbit) -> Summary:
    given = _given({**orbit.given, **orbit.opened})
    if not orbit.converged:
        return f"no orbit {shown_name(orbit.name)}", [("status", [orbit.message]), ("given", given)]
    digits = min(orbit.digits, 12)
    unknowns = [f"{n} = {decimal_string(x, digits)}" for n, x in orbit.unknowns.items()]
    period = f"{decimal_string(orbit.period, digits)}, {orbit.stability.verdict}"
    return f"orbit {shown_name(orbit.name)}, {_many(orbit.digits, 'digit')}", [
        ("period", [period]),
        ("unknowns", unknowns),
        ("given", given),
    ]


def _orbits(orbits: Orbits) -> Summary:
    status, admissible = orbits.status, orbits.admissible
    found = int(orbits.converged.sum())
    rows = [("found", [f"{found} of {status.size}"])]
    if admissible is not None:
        rows.append(("admissible", [f"{int(admissible.sum())} of {status.size}"]))
    if found:
        rows += [("period", [_range(orbits.period)]), ("trace", [_range(orbits.trace)])]
    rows.append(("unknowns", list(orbits.unknowns)))
    return (
        f"orbits {shown_name(orbits.name)} at {_many(status.size, 'point')}, shape {status.shape}",
        rows,
    )


def _motion(motion: Motion) -> Summary:
    phases = list(zip(motion.configurations, motion.breaks.tolist(), strict=False))
    return f"motion of the orbit {shown_name(motion.name)}, a function of time", [
        ("period", [f"{motion.period:.12g}"]),
        ("phases", _first(f"{name} from {time:.6g}" for name, time in phases)),
        ("states", list(motion.names)),
    ]


def _branch(branch: Branch) -> Summary:
    over = f"branch of {shown_name(branch.name)} over {branch.parameter}"
    admissible = f"{int(branch.admissible.sum())} admissible"
    return f"{over}, {_many(len(branch), 'orbit')}", [
        (branch.parameter, [f"{_range(branch.parameter_values)}, ends: {', '.join(branch.ends)}"]),
        ("orbits", [*_counts(branch.stability), admissible]),
        ("events", _first(event.text for event in branch.events) or ["none"]),
        ("period", [_range(branch.period)]),
    ]


def _event(event: Event) -> Summary:
    return f"{event.kind} at {event.parameter} = {event.value:.12g}", [
        ("event", [event.text]),
        ("unknowns", [f"{name} = {value:.8g}" for name, value in event.unknowns.items()]),
        ("phase", [] if event.phase is None else [f"{event.phase + 1}, {event.configuration}"]),
    ]


def _design(design: Design) -> Summary:
    names = (*design.parameters, *design.quantities)
    ended = [f"{name} = {design.after[name]:.12g}" for name in names]
    began = [f"{name} = {design.before[name]:.12g}" for name in names]
    active = [f"{limit.text} (multiplier {limit.multiplier:.6g})" for limit in design.active]
    of = shown_name(design.orbit.name)
    aim = f"{design.aim} {design.quantity}" if design.quantity else "wanted values"
    return f"design of {of}, {aim}: {design.message}", [
        ("ends", ended),
        ("active", active),
        ("begins", began),
        ("worst over", [f"{n} = {a!r} to {b!r}" for n, (a, b) in design.worst_over.items()]),
        ("worst at", [f"{value:.6g}" for value in design.worst_at]),
        ("corner", [design.corner] if design.corner else []),
        ("subject to", [condition.text for condition in design.conditions]),
        ("left", [f"{design.residual:.2g}"]),
        ("method", [design.method]),
        ("iterates", [str(len(design.history))]),
    ]


def _locus(locus: Locus) -> Summary:
    ranges = zip(locus.parameters, locus.values.T, strict=True)
    title = locus.title.replace(locus.name, shown_name(locus.name))
    return f"{title}, {_many(len(locus), 'point')}", [
        ("where", [f"{name} in {_range(values)}" for name, values in ranges]),
        ("ends", list(locus.ends)),
    ]


def _sweep(sweep: Sweep) -> Summary:
    from nonsmooth.runtime.explore.finding.outcomes import settled_texts

    texts = settled_texts()
    outcomes = _counts(texts[int(number)] for number in sweep.outcomes[: sweep.done])
    values = f"{_range(sweep.values)}, {sweep.done} of {_many(len(sweep.values), 'value')} done"
    return f"{sweep.state} of {shown_name(sweep.system)} {sweep.when}, over {sweep.parameter}", [
        (sweep.parameter, [values]),
        ("settled", outcomes),
        ("given", _given(sweep.parameters)),
    ]


def _found(found: Found) -> Summary:
    orbits = [
        "refused"
        if isinstance(o.solved, str)
        else f"period {o.period:.8g}, {o.verdict}, {100 * o.share:.3g} %"
        for o in found.orbits
    ]
    equilibria = [
        "refused"
        if isinstance(e.solved, str)
        else f"{e.solved.configuration}, {e.solved.verdict}, {100 * e.share:.3g} %"
        for e in found.equilibria
    ]
    others = [f"{outcome.text}, {100 * share:.3g} %" for outcome, share in found.outcomes.items()]
    return f"found in {shown_name(found.system)} from {_many(len(found.starts), 'start')}", [
        ("orbits", _first(orbits) or ["none"]),
        ("equilibria", _first(equilibria)),
        ("else", others),
        ("given", _given(found.parameters)),
    ]


def _experiment(experiment: Experiment) -> Summary:
    data, start = experiment.data, experiment.start
    columns = list(map(str, data)) if isinstance(data, Mapping) else [str(data)]
    return f"experiment {experiment.name}".rstrip(), [
        ("measured", _first(columns)),
        ("given", _given(experiment.parameters)),
        ("starts", [] if start is None else _given(start)),
        ("offset", [] if experiment.offset is None else [f"{experiment.offset:.8g}"]),
    ]


def _fit(fit: Fit) -> Summary:
    errors = fit.standard_errors.tolist()
    found = [
        f"{name} = {value:.8g}" + (f" +- {error:.2g}" if math.isfinite(error) else "")
        for name, value, error in zip(fit.names, fit.estimates.tolist(), errors, strict=True)
    ]
    left = f"chi2 {fit.chi2:.6g} with {_many(fit.degrees_of_freedom, 'degree')} of freedom"
    grazing = fit.grazing
    sequence = {None: [], True: ["that of the data"], False: ["not that of the data"]}
    return f"fit of {shown_name(fit.system)} to {_many(fit.data, 'number')}, {fit.status}", [
        ("found", found),
        ("left", [left, *(f"noise of {n} {x:.3g}" for n, x in fit.noise.items())]),
        ("not told", list(fit.unidentified)),
        ("no error", [f"{name}: {why}" for name, why in fit.untold.items()]),
        ("events", sequence[fit.same_sequence]),
        (
            "grazing",
            []
            if grazing is None
            else [f"{grazing.boundary} {grazing.standard_errors:.3g} standard errors away"],
        ),
        ("ended", [f"{fit.message}, {_many(fit.evaluations, 'evaluation')}"]),
    ]


def _trajectory(motion: Trajectory) -> Summary:
    state = zip(motion.names, motion.states[0], strict=True)
    return f"motion of {shown_name(motion.name)}, {_many(motion.transitions, 'transition')}", [
        ("ends", [f"t = {motion.end:.8g}: {motion.status.message}"]),
        ("starts", [f"{name} = {value:.6g}" for name, value in state]),
        ("phases", _counts(motion.configurations)),
        ("given", _given(motion.parameters)),
    ]


def _trajectories(motions: Trajectories) -> Summary:
    from nonsmooth.runtime.model.engine_run import Status

    shape, size = motions.status.shape, motions.status.size
    ends = (Status(s).message if s >= 0 else "not simulated" for s in motions.status.flat)
    rows = [("ends", _counts(ends))]
    if size:
        rows.append(("times", [_range(motions.times)]))
        rows.append(("transitions", [_range(motions.transitions)]))
    return f"{_many(size, 'motion')} of {shown_name(motions.structure.name)}, shape {shape}", rows


def _differentiable_function(function: DifferentiableFunction) -> Summary:
    inputs = zip(function.inputs, function.reference.tolist(), strict=True)
    return "function with exact derivatives", [
        ("of", [f"{name} = {value:.6g}" for name, value in inputs]),
        ("gives", list(function.outputs)),
    ]


def _recurrence(cycle: Recurrence) -> Summary:
    return f"cycle of {_many(len(cycle.itinerary), 'phase')}", [
        ("itinerary", [itinerary_text(cycle.itinerary)]),
        ("duration", [f"{float(np.sum(cycle.dwell_times)):.12g}"]),
        ("start", [", ".join(f"{value:.6g}" for value in cycle.start)]),
    ]


def _poincare_map(section: PoincareMap) -> Summary:
    structure = section.system.structure
    source, target = (structure.configurations[i] for i in (section.source, section.target))
    boundary = structure.boundaries[section.source][section.boundary].name
    return f"Poincare map of {shown_name(structure.name)}", [
        ("section", [f"{source} by {boundary} to {target}"]),
        ("states", list(structure.states)),
        ("given", _given(section.system.parameters)),
    ]


def _certificate(proof: Certificate) -> Summary:
    wanted = {n: proof.enclosures[n] for n in ("trace", "period") if n in proof.enclosures}
    rest = {name: ball for name, ball in proof.enclosures.items() if name not in wanted}
    return f"certificate of {shown_name(proof.orbit)}, {proof.stability}", [
        ("claims", _claims(proof.claims, proof.reasons)),
        ("enclosed", _stated(wanted)),
        ("given", _given(proof.parameters)),
        ("orbit", _stated(rest)),
        *(
            (f"by {name}", _stated({of: rates[name] for of, rates in proof.derivatives.items()}))
            for name in proof.directions
        ),
        *((f"by {name}", [reason]) for name, reason in proof.no_derivatives.items()),
    ]


def _box_certificate(proof: BoxCertificate) -> Summary:
    sides = [f"{n} in {float(a):.6g} ... {float(b):.6g}" for n, (a, b) in proof.box.items()]
    shares = [f"{100 * float(share):.4g} % {verdict}" for verdict, share in proof.shares.items()]
    return (
        f"certificate of {shown_name(proof.orbit)} over a box, {_many(len(proof.tiles), 'tile')}",
        [
            ("box", sides),
            ("claims", _claims(proof.claims, proof.reasons)),
            ("shares", shares),
            ("map", [proof.statement] if proof.statement else []),
            ("enclosed", _stated(proof.enclosures)),
            ("given", _given(proof.parameters)),
        ],
    )


def _certified_branch(proof: CertifiedBranch) -> Summary:
    low, high = (f"{float(end):.6g}" for end in proof.interval)
    parts = [f"{part.verdict} {part.begin:.6g} ... {part.end:.6g}" for part in proof.intervals]
    events = [f"{event.kind} {event.enclosures[proof.parameter]}" for event in proof.events]
    return (
        f"certified branch of {shown_name(proof.orbit)} over {proof.parameter} = {low} ... {high}",
        [
            ("claims", _claims(proof.claims, {})),
            ("intervals", parts),
            ("events", events),
            ("ends", list(dict.fromkeys(end for end in proof.ends if end))),
            ("given", _given(proof.parameters)),
        ],
    )


def _certified_doubling(proof: CertifiedDoubling) -> Summary:
    flip, doubled = proof.flip, proof.doubled
    value = "" if flip is None else f"{flip.enclosures[proof.parameter]} {proof.kind}".rstrip()
    return (
        f"certified doubling of {shown_name(proof.orbit)} along {proof.parameter}",
        [
            ("claims", _claims(proof.claims, {})),
            ("flip", [value] if value else []),
            ("doubled", [] if doubled is None else [f"{doubled.verdict} {doubled.side} the flip"]),
            ("end", [proof.end] if proof.end else []),
            ("given", _given(proof.parameters)),
        ],
    )


def _census(census: Census) -> Summary:
    number = f"{'exactly' if census.decided else 'at least'} {_many(census.count, 'orbit')}"
    return f"census of {shown_name(census.orbit)}: {number}", [
        ("box", [*census.box, *census.conditions]),
        ("admissible", [str(census.admissible)]),
        ("statement", [census.statement]),
    ]


def _event_certificate(proof: EventCertificate) -> Summary:
    verdict = f"{proof.claim}: {proof.reason}" if proof.reason else proof.claim
    value = {name: ball for name, ball in proof.enclosures.items() if name == proof.parameter}
    return f"certificate of a {proof.kind} of {shown_name(proof.orbit)}", [
        ("claim", [verdict]),
        ("enclosed", _stated({**value, **proof.enclosures})),
        ("event", [proof.text]),
        ("given", _given(proof.parameters)),
    ]


def _basin(found: BasinCertificate) -> Summary:
    verdict = f"{found.claim}: {found.reason}" if found.reason else found.claim
    rows = [("claim", [verdict])]
    if found.proved:
        good = int((found.ranks >= 0).sum())
        rows.append(("section", [f"{good} of {found.ranks.size} boxes", *found.coordinates]))
        if found.tiles is not None:
            tiles = f"{int(found.attracted.sum())} attracted of {int(found.looked.sum())} looked at"
            rows.append(("tiles", [tiles, f"of {found.looked.size}"]))
    rows.append(("given", _given(found.parameters)))
    return f"certificate of the basin of {shown_name(found.orbit)}", rows


def _chaos(found: ChaosCertificate) -> Summary:
    verdict = f"{found.claim}: {found.reason}" if found.reason else found.claim
    rows = [("claim", [verdict])]
    if found.proved:
        pairs = [f"{one} covers {other}" for one, other in found.coverings]
        power = f"by {found.iterates} iterates of the map"
        rows.append(("entropy", [f"at least {found.entropy}"]))
        if found.cones is not None:
            rows.append(("exponents", [f"at least {found.exponent}"]))
        rows.append(("sets", [_many(len(found.h_sets), "set"), power, *_first(pairs)]))
    rows += [("tried", _first(found.tried)), ("given", _given(found.parameters))]
    return f"certificate of chaos of {shown_name(found.system)}", rows


def _graph(found: GraphCertificate) -> Summary:
    told = [
        _many(sum(own.attracting for own in found.components), "attracting component"),
        f"{len(found.trapping)} of {len(found.graph.grid)} boxes in the largest trapping region",
    ]
    return f"graph of boxes of {shown_name(found.system)}", [
        ("proved", told),
        ("components", [f"{len(own.boxes)} boxes" for own in found.components[:_MOST]]),
        ("not known", [f"images of {len(found.unknown)} boxes"] if len(found.unknown) else []),
        ("given", _given(found.parameters)),
    ]


def _proof(proof: Proof) -> Summary:
    rows = [("times", _first(_stated({"t": t})[0] for t in proof.times))]
    if proof.reason:
        rows.insert(0, ("until", [proof.reason]))
    rows.append(("given", _given(proof.parameters)))
    return (
        f"proved motion of {shown_name(proof.system)}, {_many(proof.transitions, 'transition')}",
        rows,
    )


def _check(check: Check) -> Summary:
    title = "every claim is proved again" if check.difference is None else "the file is wrong"
    return title, [
        ("claims", _claims(check.claims, {})),
        ("difference", [check.difference] if check.difference else []),
        ("note", [check.note] if check.note else []),
    ]


_KINDS: Mapping[str, Callable[[Any], Summary]] = {
    "BoxCertificate": _box_certificate,
    "Branch": _branch,
    "Census": _census,
    "Certificate": _certificate,
    "CertifiedBranch": _certified_branch,
    "CertifiedDoubling": _certified_doubling,
    "Check": _check,
    "Design": _design,
    "BasinCertificate": _basin,
    "ChaosCertificate": _chaos,
    "DifferentiableFunction": _differentiable_function,
    "Event": _event,
    "EventCertificate": _event_certificate,
    "Experiment": _experiment,
    "Fit": _fit,
    "Found": _found,
    "GraphCertificate": _graph,
    "Locus": _locus,
    "Motion": _motion,
    "Orbit": _orbit,
    "Orbits": _orbits,
    "PoincareMap": _poincare_map,
    "Proof": _proof,
    "Recurrence": _recurrence,
    "Sweep": _sweep,
    "Trajectories": _trajectories,
    "Trajectory": _trajectory,
}
