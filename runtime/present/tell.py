"""What each kind of result tells of itself: the same in a console, a notebook and a command."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.values import decimal_string
from nonsmooth.runtime.model.naming import itinerary_text, shown_name, symbol
from nonsmooth.runtime.present.tell_proofs import PROOFS
from nonsmooth.runtime.present.told import (
    Listing,
    Told,
    counts,
    first,
    given,
    html,
    many,
    span,
    text,
)

if TYPE_CHECKING:
    from nonsmooth.runtime.core.differentiable import DifferentiableFunction
    from nonsmooth.runtime.explore.continuation.branch import Branch, Locus
    from nonsmooth.runtime.explore.continuation.event import Event
    from nonsmooth.runtime.explore.design.optimum import Design
    from nonsmooth.runtime.explore.finding.find import Found, FoundEquilibrium, FoundOrbit
    from nonsmooth.runtime.explore.finding.sweep import Sweep
    from nonsmooth.runtime.explore.fitting.fit import Fit, FittedExperiment
    from nonsmooth.runtime.explore.fitting.measurements import Experiment
    from nonsmooth.runtime.explore.fitting.statistics import NearestGrazing
    from nonsmooth.runtime.orbits.motion import Motion
    from nonsmooth.runtime.orbits.orbit import Orbit, Orbits
    from nonsmooth.runtime.simulation.derivatives import MotionDerivatives
    from nonsmooth.runtime.simulation.engines import Trajectories
    from nonsmooth.runtime.simulation.observables import Observables
    from nonsmooth.runtime.simulation.recurrence import Recurrence
    from nonsmooth.runtime.simulation.returns import PoincareMap
    from nonsmooth.runtime.simulation.trajectory import Trajectory

_MOST_DIGITS = 50  # of a number in a formula
_TRANSITIONS = 40  # of a long motion: the first and the last half of them
_EXTREMES = ("", "least", "at", "greatest", "at", "mean", "RMS")
_FORCES = ("force", "least", "greatest", "mean", "work", "dissipated")


def tell(result: Any) -> Told:
    """What a result is: a title, and rows of lines or tables by their names."""
    return KINDS[type(result).__name__](result)


def result_text(result: Any) -> str:
    """Text of at most four lines that describes a result of a public kind."""
    return text(tell(result))


def result_html(result: Any) -> str:
    """HTML of a table that describes a result of a public kind, for a notebook."""
    return html(tell(result))


def orbit_latex(orbit: Orbit) -> str:
    """LaTeX of the unknowns of an orbit, converged or not, as aligned displayed equations."""
    if not orbit.converged:
        return rf"$$\text{{{orbit.name}: {orbit.message}}}$$"
    rows = []
    for name, value in orbit.unknowns.items():
        text = decimal_string(value, min(orbit.digits, _MOST_DIGITS))
        mantissa, _, exponent = text.partition("e")
        power = rf" \cdot 10^{{{int(exponent)}}}" if exponent else ""
        rows.append(f"{symbol(name)} &= {mantissa}{power}")
    body = " \\\\\n".join(rows)
    return f"$$\\begin{{aligned}}\n{body}\n\\end{{aligned}}$$"


def _complex(number: complex) -> str:
    return _pair(f"{number.real:.6g}", f"{number.imag:.6g}")


def _pair(real: str, imaginary: str) -> str:
    if not float(imaginary):
        return real
    return f"{real} {'-' if imaginary.startswith('-') else '+'} {imaginary.lstrip('-')}i"


def _pairs(numbers: Sequence[complex]) -> str:
    """Complex numbers in one text, conjugate pairs with a sign of plus or minus."""
    told = []
    for number in numbers:
        paired = number.imag != 0 and number.conjugate() in numbers
        if number.imag > 0 or not paired:
            told.append(_complex(number).replace(" + ", " ± " if paired else " + "))
    return ", ".join(told)


def _number(value: float) -> str:
    return f"{value:.8g}"


def _orbit(orbit: Orbit) -> Told:
    known = given({**orbit.given, **orbit.opened})
    if not orbit.converged:
        return f"no orbit {shown_name(orbit.name)}", [("status", [orbit.message]), ("given", known)]
    title = f"orbit {shown_name(orbit.name)}, {many(orbit.digits, 'digit')}"
    return title, _orbit_rows(orbit, known)


def _orbit_rows(orbit: Orbit, known: list[str]) -> Iterator[tuple[str, Sequence[str] | Listing]]:
    """Rows for a converged orbit; whether it is admissible is found out only for the last."""
    from nonsmooth.runtime.present.report import admissibility_json, admissibility_rows

    digits = min(orbit.digits, 15)
    yield "period", [f"{decimal_string(orbit.period, digits)}, {orbit.stability.verdict}"]
    yield "unknowns", [f"{n} = {decimal_string(x, digits)}" for n, x in orbit.unknowns.items()]
    yield "given", known
    yield (
        "multipliers",
        [
            _pair(decimal_string(m.real, digits), decimal_string(m.imaginary, digits))
            + " (trivial)" * m.trivial
            for m in orbit.stability.multipliers
        ],
    )
    yield from admissibility_rows(admissibility_json(orbit))


def _orbits(orbits: Orbits) -> Told:
    status, admissible = orbits.status, orbits.admissible
    found = int(orbits.converged.sum())
    rows = [("found", [f"{found} of {status.size}"])]
    if admissible is not None:
        rows.append(("admissible", [f"{int(admissible.sum())} of {status.size}"]))
    if found:
        rows += [("period", [span(orbits.period)]), ("trace", [span(orbits.trace)])]
    rows.append(("unknowns", list(orbits.unknowns)))
    return (
        f"orbits {shown_name(orbits.name)} at {many(status.size, 'point')}, shape {status.shape}",
        rows,
    )


def _motion(motion: Motion) -> Told:
    phases = list(zip(motion.configurations, motion.breaks.tolist(), strict=False))
    return f"motion of the orbit {shown_name(motion.name)}, a function of time", [
        ("period", [f"{motion.period:.12g}"]),
        ("phases", first(f"{name} from {time:.6g}" for name, time in phases)),
        ("states", list(motion.names)),
    ]


def _branch(branch: Branch) -> Told:
    events = [
        (
            event.kind + ", touched" * event.touching,
            f"{event.value:.12g}",
            "" if event.phase is None else f"{event.configuration} ({event.phase + 1})",
            event.boundary,
        )
        for event in branch.events
    ]
    over = f"branch of {shown_name(branch.name)} over {branch.parameter}"
    begins, ends = branch.ends
    return f"{over}, {many(len(branch), 'orbit')}", [
        (branch.parameter, [span(branch.parameter_values)]),
        ("orbits", [*counts(branch.stability), f"{int(branch.admissible.sum())} admissible"]),
        ("events", Listing(("event", branch.parameter, "where", "boundary"), events)),
        ("period", [span(branch.period)]),
        ("begins", [begins]),
        ("ends", [ends]),
    ]


def _event(event: Event) -> Told:
    return f"{event.kind} at {event.parameter} = {event.value:.12g}", [
        ("event", [event.text]),
        ("unknowns", [f"{name} = {value:.8g}" for name, value in event.unknowns.items()]),
        ("phase", [] if event.phase is None else [f"{event.phase + 1}, {event.configuration}"]),
    ]


def _design(design: Design) -> Told:
    values = [
        (name, f"{design.before[name]:.12g}", f"{design.after[name]:.12g}")
        for name in (*design.parameters, *design.quantities)
    ]
    of, aim = shown_name(design.orbit.name), f"{design.aim} {design.quantity}"
    worth = bool(design.quantity)
    return f"design of {of}, {aim if worth else 'wanted values'}: {design.message}", [
        ("values", Listing(("", "begins", "ends"), values)),
        (
            "active",
            [
                f"{limit.text}, multiplier {limit.multiplier:.6g}" if worth else limit.text
                for limit in design.active
            ],
        ),
        ("worst over", [f"{n} = {a!r} to {b!r}" for n, (a, b) in design.worst_over.items()]),
        (
            "worst at",
            [f"{n} = {', '.join(f'{x:.6g}' for x in design.worst_at)}" for n in design.worst_over],
        ),
        ("corner", [design.corner] if design.corner else []),
        ("subject to", [condition.text for condition in design.conditions]),
        ("method", [design.method, many(len(design.history), "iterate")]),
        ("left", [f"{design.residual:.2g}"]),
    ]


def _locus(locus: Locus) -> Told:
    title = locus.title.replace(locus.name, shown_name(locus.name))
    places = {"begins": 0, "from": locus.start, "ends": len(locus) - 1}
    points = [
        (word, *(f"{value:.12g}" for value in locus.values[place].tolist()))
        for word, place in places.items()
    ]
    begins, ends = locus.ends
    return f"{title}, {many(len(locus), 'point')}", [
        ("points", Listing(("", *locus.parameters), points)),
        ("begins", [begins]),
        ("ends", [ends]),
    ]


def _sweep(sweep: Sweep) -> Told:
    from nonsmooth.runtime.explore.finding.outcomes import settled_texts

    texts = settled_texts()
    outcomes = counts(texts[int(number)] for number in sweep.outcomes[: sweep.done])
    values = f"{span(sweep.values)}, {sweep.done} of {many(len(sweep.values), 'value')} done"
    points = many(int(np.isfinite(sweep.samples).sum()), "point")
    return f"{sweep.state} of {shown_name(sweep.system)} {sweep.when}, over {sweep.parameter}", [
        (sweep.parameter, [values, points]),
        ("settled", outcomes),
        ("given", given(sweep.parameters)),
    ]


def _found(found: Found) -> Told:
    kinds = [many(len(found.orbits), "periodic orbit")]
    if found.equilibria:
        count = len(found.equilibria)
        kinds.append(f"{count} equilibri{'um' if count == 1 else 'a'}")
    title = f"{' and '.join(kinds)} from {many(len(found.starts), 'start')}"
    others = [f"{100 * share:.4g} %: {outcome.text}" for outcome, share in found.outcomes.items()]
    return f"{shown_name(found.system)}, {title}", [
        ("orbits", _found_orbits(found) or ["none"]),
        ("equilibria", _found_equilibria(found)),
        ("other starts", others),
        ("given", given(found.parameters)),
    ]


def _found_orbits(found: Found) -> Listing:
    known = [entry for entry in found.orbits if not isinstance(entry.solved, str)]
    forced = any(entry.forcing_periods for entry in known)

    def told(entry: Any) -> tuple[list[str], str]:
        periods = [", ".join(map(str, entry.forcing_periods))] * forced
        multipliers = _pairs(entry.orbit.multipliers.tolist())
        numbers = [_number(entry.period), *periods, entry.verdict, multipliers]
        return numbers, itinerary_text(entry.itinerary)

    titles = ["period", *["in forcing periods"] * forced, "stability", "multipliers"]
    return _attractors(found.orbits, 0, [*titles, "itinerary"], told)


def _found_equilibria(found: Found) -> Listing:
    def told(entry: Any) -> tuple[list[str], str]:
        known = entry.equilibrium
        state = zip(known.names, known.state.tolist(), strict=True)
        place = ", ".join(f"{name} = {_number(value)}" for name, value in state)
        return [place, known.verdict, _pairs(known.eigenvalues.tolist())], known.configuration

    titles = ["equilibrium", "stability", "eigenvalues", "configuration"]
    return _attractors(found.equilibria, len(found.orbits), titles, told)


def _attractors(
    entries: Sequence[FoundOrbit | FoundEquilibrium],
    before: int,
    titles: list[str],
    told: Callable[[Any], tuple[list[str], str]],
) -> Listing:
    """A row for each entry: number, what `told` says, starts, mirror image, and where it goes."""
    mirrored = any(entry.mirror is not None for entry in entries)
    rows = []
    for place, entry in enumerate(entries):
        if isinstance(entry.solved, str):
            numbers, where = ["refused"] + [""] * (len(titles) - 2), entry.solved
        else:
            numbers, where = told(entry)
        mirror = "its own" if entry.mirror == place else f"of {before + (entry.mirror or 0) + 1}"
        rows.append(
            [
                str(before + place + 1),
                *numbers,
                f"{100 * entry.share:.4g} %" if entry.starts else "-",
                *["" if entry.mirror is None else mirror] * mirrored,
                where,
            ]
        )
    *middle, last = titles
    right = ("", "period", "in forcing periods", "starts")
    return Listing(("", *middle, "starts", *["mirror image"] * mirrored, last), rows, right)


def _experiment(experiment: Experiment) -> Told:
    data, start = experiment.data, experiment.start
    columns = list(map(str, data)) if isinstance(data, Mapping) else [str(data)]
    return f"experiment {experiment.name}".rstrip(), [
        ("measured", first(columns)),
        ("given", given(experiment.parameters)),
        ("starts", [] if start is None else given(start)),
        ("offset", [] if experiment.offset is None else [f"{experiment.offset:.8g}"]),
    ]


def _fit(fit: Fit) -> Told:
    errors, untold = fit.standard_errors.tolist(), fit.untold
    found = [
        (
            name,
            f"{fit.estimates[place]:.10g}",
            f"{errors[place]:.2g}" if math.isfinite(errors[place]) else "",
            untold.get(name, f"{fit.lower[place]:.8g} ... {fit.upper[place]:.8g}"),
        )
        for place, name in enumerate(fit.names)
    ]
    left = f"chi2 {fit.chi2:.6g} with {many(fit.degrees_of_freedom, 'degree')} of freedom"
    tried = [f"best of {len(fit.costs)} searches"] if len(fit.costs) > 1 else []
    titles = ("found", "estimate", "standard error", "95 % interval")
    return f"fit of {shown_name(fit.system)} to {many(fit.data, 'number')}, {fit.status}", [
        ("found", Listing(titles, found, titles[1:3])),
        ("left", [left, *(f"noise of {n} {x:.3g}, estimated" for n, x in fit.noise.items())]),
        ("not told", list(fit.unidentified)),
        ("hardly told", [name for name, error in fit.identified if 1 <= error < math.inf]),
        *((shown_name(each.name), _fitted(each)) for each in fit.experiments),
        ("ended", [fit.message, many(fit.evaluations, "evaluation"), *tried]),
    ]


def _fitted(experiment: FittedExperiment) -> list[str]:
    """Phases of a fitted motion, or how many steady responses there are, and what nearly grazes."""
    told = [many(len(experiment.configurations), "phase")]
    if experiment.same_sequence is not None:
        order = "in the order" if experiment.same_sequence else "not in the order or number"
        told.append(f"events {order} of the data")
    if experiment.responses:
        kinds = Counter(
            "without an event" if each.itinerary[0][1] == "forcing-phase" else "with events"
            for each in experiment.responses
        )
        steady = many(len(experiment.responses), "steady response")
        told = [steady, *(f"{count} {kind}" for kind, count in kinds.items())]
    return [*told, *_grazing(experiment.grazing)]


def _grazing(grazing: NearestGrazing | None) -> list[str]:
    if grazing is None:
        return []
    distance = grazing.standard_errors
    far = "" if not math.isfinite(distance) else f", {distance:.3g} standard errors away"
    return [
        f"nearest grazing: {grazing.boundary}, {grazing.kind} at {grazing.time:.6g},"
        f" by {grazing.margin:.3g}{far}"
    ]


def _trajectory(motion: Trajectory) -> Told:
    touched = [
        f"{motion.structure.boundaries[g.configuration][g.boundary].name} at {_number(g.time)},"
        f" depth {g.depth:.1e}"
        for g in motion.grazings
    ]
    return f"motion of {shown_name(motion.name)}, {many(motion.transitions, 'transition')}", [
        ("ends", [f"t = {motion.end:.8g}: {motion.message}"]),
        ("phases", counts(motion.configurations)),
        ("given", given(motion.parameters)),
        ("transitions", _transitions(motion)),
        ("touched without crossing", touched),
    ]


def _transitions(motion: Trajectory) -> Listing:
    """Time, boundaries, configuration and state of each transition; of many the first and last."""
    forcing, forced = motion.structure.forcing, motion.structure.forced
    kept = [place for place in range(len(motion.names)) if place not in forced]
    numbers = [*(motion.names[place] for place in kept), *["forcing phase"] * bool(forcing)]

    def row(place: int) -> list[str]:
        state = motion.states[place]
        angles = [float(np.arctan2(state[s], state[c]) % (2 * np.pi)) for c, s in forcing[:1]]
        reached = " + ".join(motion.boundaries[place])
        told = [_number(motion.times[place]), reached, motion.configurations[place]]
        return [*told, *map(_number, [*state[kept], *angles])]

    count, half = len(motion.times), _TRANSITIONS // 2
    rows = [row(place) for place in range(count) if place < half or place >= count - half]
    if (hidden := count - _TRANSITIONS) > 0:
        rows.insert(half, ["...", f"{hidden} more"] + [""] * (1 + len(numbers)))
    return Listing(("time", "reached", "then", *numbers), rows, ("time", *numbers))


def _motion_derivatives(found: MotionDerivatives) -> Told:
    motion = found.trajectory
    names = ("time", *(f"{name} behind it" for name in motion.names))
    times = np.concatenate([np.zeros((1, len(found.by))), found.event_times])[-1]
    rows = [
        [name, *map(_number, (time, *states))]
        for name, time, states in zip(found.by, times, found.behind[-1].T, strict=True)
    ]
    of = "the last transition" if motion.transitions else "the start"
    return f"derivatives of {of}", [("by", Listing(("by", *names), rows, names))]


def _observables(found: Observables) -> Told:
    from nonsmooth.runtime.present.answers import largest_exponent

    forced = {found.trajectory.names[place] for place in found.trajectory.structure.forced}
    states = [
        [name, *map(_number, (low.value, low.time, high.value, high.time, mean, rms))]
        for (name, low), high, mean, rms in zip(
            found.minima.items(),
            found.maxima.values(),
            found.means.values(),
            found.rms.values(),
            strict=True,
        )
        if name not in forced
    ]
    forces = [
        [name, *map(_number, (c.minimum.value, c.maximum.value, c.mean, c.work, c.dissipated))]
        for name, c in found.contacts.items()
    ]
    shares = [f"{name} {100 * share:.4g} %" for name, share in found.fractions.items() if share]
    exponent = largest_exponent(found)
    if isinstance(exponent, str):
        growth = "no Lyapunov exponent", [exponent]
    else:
        told = f"{exponent.value:.6g}, error {exponent.error:.1g}"
        growth = "largest Lyapunov exponent", [told]
    return f"from {_number(found.since)} on", [
        ("states", Listing(_EXTREMES, states, _EXTREMES[1:])),
        ("forces", Listing(_FORCES, forces, _FORCES[1:])),
        ("time", shares),
        ("sticks", [f"{name} {100 * share:.4g} %" for name, share in found.sticking.items()]),
        growth,
    ]


def _trajectories(motions: Trajectories) -> Told:
    from nonsmooth.runtime.model.engine_run import Status

    shape, size = motions.status.shape, motions.status.size
    ends = (Status(s).message if s >= 0 else "not simulated" for s in motions.status.flat)
    rows = [("ends", counts(ends))]
    if size:
        rows.append(("times", [span(motions.times)]))
        rows.append(("transitions", [span(motions.transitions)]))
    return f"{many(size, 'motion')} of {shown_name(motions.structure.name)}, shape {shape}", rows


def _differentiable_function(function: DifferentiableFunction) -> Told:
    inputs = zip(function.inputs, function.reference.tolist(), strict=True)
    return "function with exact derivatives", [
        ("of", [f"{name} = {value:.6g}" for name, value in inputs]),
        ("gives", list(function.outputs)),
    ]


def _recurrence(cycle: Recurrence) -> Told:
    return f"cycle of {many(len(cycle.itinerary), 'phase')}", [
        ("itinerary", [itinerary_text(cycle.itinerary)]),
        ("duration", [f"{float(np.sum(cycle.dwell_times)):.12g}"]),
        ("start", [", ".join(f"{value:.6g}" for value in cycle.start)]),
    ]


def _poincare_map(section: PoincareMap) -> Told:
    structure = section.system.structure
    source, target = (structure.configurations[i] for i in (section.source, section.target))
    boundary = structure.boundaries[section.source][section.boundary].name
    return f"Poincare map of {shown_name(structure.name)}", [
        ("section", [f"{source} by {boundary} to {target}"]),
        ("states", list(structure.states)),
        ("given", given(section.system.parameters)),
    ]


KINDS: dict[str, Callable[[Any], Told]] = {
    **PROOFS,
    "Branch": _branch,
    "Design": _design,
    "DifferentiableFunction": _differentiable_function,
    "Event": _event,
    "Experiment": _experiment,
    "Fit": _fit,
    "Found": _found,
    "Locus": _locus,
    "Motion": _motion,
    "MotionDerivatives": _motion_derivatives,
    "Observables": _observables,
    "Orbit": _orbit,
    "Orbits": _orbits,
    "PoincareMap": _poincare_map,
    "Recurrence": _recurrence,
    "Sweep": _sweep,
    "Trajectories": _trajectories,
    "Trajectory": _trajectory,
}
