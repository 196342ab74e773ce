"""Periodic orbits of any itinerary of a system, composed from its flows at run time.

No kernels are generated for the itinerary: the numbers of the system's configurations,
boundaries and transitions are enough. Coordinates are physical, positions before velocities.

Of a system whose configurations are made when they are visited, those of the itinerary are made.
Through coupled contacts the routes of the law between the phases of an itinerary are listed.
Which steps the law takes from one phase to the next depends on the state there. Before an orbit
is known the shortest route stands for them: all have the same reset. Behind it comes the route
that the law takes at the orbit, whose conditions admissibility and proofs ask for.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, NoConvergence, unknown_name
from nonsmooth.runtime.core.values import as_value
from nonsmooth.runtime.events.transition_choice import Decider
from nonsmooth.runtime.model.contacts.law import HOLDING, ContactEvent, Law
from nonsmooth.runtime.model.contacts.stages import Path, Stage
from nonsmooth.runtime.model.contacts.unfolding import Route, unfolded
from nonsmooth.runtime.model.engine_layout import numbers_of
from nonsmooth.runtime.model.flows import flow_states
from nonsmooth.runtime.model.kernels import OrbitKernels, SystemKernels, grown
from nonsmooth.runtime.model.naming import start_names
from nonsmooth.runtime.model.parameters import number_of, system_parameters
from nonsmooth.runtime.model.piecewise import PiecewiseLinear, piecewise
from nonsmooth.runtime.model.structure import (
    FORCING_PHASE,
    Structure,
    TransitionShape,
    structure_of,
)
from nonsmooth.runtime.orbits.orbit import PERIOD, Orbit
from nonsmooth.runtime.orbits.problem import OrbitProblem, labelled, orbit_of
from nonsmooth.runtime.shooting.closure_conditions import closing
from nonsmooth.runtime.shooting.newton import CONVERGED
from nonsmooth.runtime.shooting.shooting_map import (
    guesses,
    itinerary_shape,
)
from nonsmooth.runtime.shooting.symmetry import (
    part_of,
    symmetry_of,
    whole_itinerary,
    whole_orbit,
    whole_shape,
)
from nonsmooth.runtime.shooting.table_newton import digits_of, fitting_start, solve_shape, unsolved
from nonsmooth.runtime.shooting.translations import up_to_shift
from nonsmooth.runtime.simulation.recurrence import Recurrence

CONTINUATION_STEPS = 24  # from a reference orbit to other parameters

_Phases = Sequence[tuple[str, str | Sequence[str]]]
Guess = Sequence[Any] | np.ndarray | Mapping[str, Any] | None
Itinerary = _Phases | Recurrence
Symmetries = Mapping[str, str] | np.ndarray | Sequence[Sequence[int]] | None


def solve_itinerary(
    system: SystemKernels,
    parameters: Mapping[str, object],
    itinerary: Sequence[tuple[str, str]],
    dwell_times: Sequence[float] | np.ndarray,
    start: Sequence[float] | None = None,
    *,
    period: object = None,
    symmetry: Symmetries = None,
    known: tuple[np.ndarray, float] | None = None,
) -> Orbit:
    """Find the periodic orbit of an itinerary near a guess, in double precision.

    All physical parameters are given. There are guesses of the dwell times (p,) and of
    the state at the start (N,); without that the one is taken that fits the dwell times
    best. The period, if given, is what the dwell times have to sum up to; the symmetry is
    as for `nonsmooth.solve`. The result's `status` says whether it is an orbit: of numbers
    that were solved for before, of which the states (p, N) where phases begin and the residual
    are `known`, the digits alone are counted anew.

    `InputError` is raised for wrong names, values or numbers of guesses, an itinerary
    that the system does not allow, or what is no symmetry of the system at these
    parameters.
    """
    mirror, phases = None, itinerary
    if symmetry is not None:
        declared = piecewise(system, parameters)
        mirror = symmetry_of(declared, symmetry)
        phases = whole_itinerary(declared.structure, mirror, itinerary)
    kernels = with_routes(system, phases)
    point = piecewise(kernels, parameters)
    if mirror is None:
        cycle = itinerary_shape(point.structure, itinerary)
    else:
        cycle = whole_shape(point, mirror, itinerary)
    closed, part, directions = closing(point, cycle, mirror)
    wanted = None if period is None else as_value(period)
    length = np.nan if wanted is None else float(wanted)
    if wanted is not None and not 0 < length < np.inf:
        raise InputError(f"period = {wanted} is not positive and finite")
    if wanted is not None and mirror is not None:
        length = float(part_of(wanted, mirror.order))
    asked, size = (part, numbers_of(closed)[None]), len(part.structure.states)
    period_of_part = np.array([length])
    if known is None:
        dwell = guesses("the guess of the dwell times", dwell_times, len(part), positive=True)
        begin = None
        if start is not None:
            begin = guesses("the guess of the start", start, size).reshape(1, -1)
            begin = up_to_shift(begin, directions)
        found = solve_shape(*asked, dwell.reshape(1, -1), begin, period_of_part)
        found.starts[0, 0] = up_to_shift(found.starts[0, 0], directions)
    else:
        found = unsolved(np.asarray(dwell_times)[None], size, size)
        found.starts[0], found.residual[0], found.status[0] = *known, CONVERGED
    digits, status = digits_of(*asked, found, period_of_part, directions[None])
    times, states = whole_orbit(point, cycle, mirror, found.dwell[0], found.starts[0], np)
    kernels = with_routes_at(kernels, point, cycle.itinerary, times, states)
    return orbit_of(
        OrbitProblem(kernels, cycle.itinerary, mirror),
        point.parameters,
        wanted,
        times,
        states,
        float(found.residual[0]),
        int(digits[0]),
        int(found.iterations[0]),
        int(status[0]),
    )


def steps_between(begin: np.ndarray, end: np.ndarray) -> Iterator[np.ndarray]:
    """Yield points (p,) from begin to end: even in the logarithms of what is positive at both."""
    positive = (begin > 0) & (end > 0)
    ratio = np.where(positive, end, 1.0) / np.where(positive, begin, 1.0)
    for fraction in np.linspace(0, 1, CONTINUATION_STEPS + 1):
        yield np.where(positive, begin * ratio**fraction, begin + fraction * (end - begin))


def period_in(
    unknown: Iterable[str], given: Mapping[str, object] | None, name: str = "an itinerary"
) -> object:
    """Return the period that is given for what is composed, or None; `InputError` for an exchange.

    Nothing may be solved for in place of unknowns: `unknown` is empty, and `given` holds
    ``period`` at most. The message begins with the `name`.
    """
    exchanged = [*unknown, *(each for each in given or {} if each != PERIOD)]
    if exchanged:
        raise InputError(
            f"{name} is composed from its phases: {', '.join(exchanged)} cannot be"
            " exchanged, as in orbits whose equations are derived"
        )
    return (given or {}).get(PERIOD)


def guess_along(
    kernels: SystemKernels, itinerary: Itinerary, guess: Any
) -> tuple[Sequence[tuple[str, str]], Any, Any]:
    """Return the phases, guesses (..., p) of their dwell times, and (..., N) of the start or None.

    A guess is (..., p) or (..., p + N), or by name; a Recurrence in place of the
    itinerary brings its guess with it. `InputError` is raised if there is no guess, or
    one of the wrong length.
    """
    phases: Sequence[Any] = itinerary
    if isinstance(itinerary, Recurrence):
        phases = itinerary.itinerary
        if guess is None:
            guess = np.concatenate([itinerary.dwell_times, itinerary.start])
    if isinstance(phases, str) or not isinstance(phases, Sequence):
        raise InputError("an itinerary is a sequence of (configuration, boundary)")
    if not phases:
        raise InputError("an itinerary of no phase")
    if guess is None:
        raise InputError("an itinerary takes a guess: the dwell time of each phase")
    states = kernels.table["states"]
    count, size = len(phases), len(states)
    if isinstance(guess, Mapping):
        guess = _in_order(guess, count, states)
    try:
        values = np.asarray(guess, dtype=float)
    except (TypeError, ValueError):
        raise InputError("the guess holds something else than real numbers") from None
    width = np.atleast_1d(values).shape[-1]
    if width not in (count, count + size):
        raise InputError(
            f"the guess has {width} values: it takes {count}, a dwell time for each phase,"
            f" or {count + size}, these and the start: {', '.join(states)}"
        )
    if width == count:
        return phases, values, None
    return phases, values[..., :count], values[..., count:]


def _in_order(guess: Mapping[str, Any], count: int, states: Sequence[str]) -> list[Any]:
    """Return a guess by name, tau1 to taup and all states or none, as a list in order."""
    dwell = [f"tau{place + 1}" for place in range(count)]
    for name in guess:
        if name not in dwell and name not in states:
            raise unknown_name("variable", name, [*dwell, *states])
    if missing := [name for name in dwell if name not in guess]:
        raise InputError(f"the guess has no {', '.join(missing)}")
    start = [guess[name] for name in states if name in guess]
    if start and len(start) < len(states):
        raise InputError(f"the guess has some states only: it takes all, {', '.join(states)}")
    return [*(guess[name] for name in dwell), *start]


def named_guess(
    kernels: OrbitKernels,
    guess: Guess,
    names: Sequence[str],
    least: int,
    others: Mapping[str, str],
) -> dict[str, float]:
    """Return a guess by the names of what is solved for, above that of the reference.

    A sequence has values for all the names of the unknowns, or for the first `least` of them.
    By name `others` may be given too, which are mapped to what they stand for. `InputError` is
    raised for another number of values, and for other names.
    """
    reference = kernels.table["reference"]
    if guess is None or isinstance(guess, Mapping):
        given = guess or {}
    elif len(guess) in (len(names), least):
        given = dict(zip(names, guess, strict=False))
    else:
        raise InputError(
            f"the guess has {len(guess)} values, {kernels.name} has {len(names)} unknowns:"
            f" {', '.join(names)}"
        )
    allowed = {*names, *others}
    for name in given:
        if name not in allowed:
            raise unknown_name("variable", str(name), [*dict.fromkeys((*names, *others.values()))])
    known = {**(reference["guess"] if reference else {}), **given}
    return {others.get(n, n): float(number_of(n, x)) for n, x in known.items() if n in allowed}


def phases_and_dwell(
    kernels: OrbitKernels, named: Mapping[str, float]
) -> tuple[list[tuple[str, str]], list[float]]:
    """Return the declared phases, and a guess of each one's dwell time, all of which have to be."""
    table = kernels.table["phases"]
    missing = [name for _, _, name in table if name not in named]
    if missing:
        raise InputError(
            f"{kernels.name} declares no guess of {', '.join(missing)}: give one, as in"
            f" --guess {','.join(f'{name}=1' for name in missing)}; a motion that was simulated"
            " tells them (nonsmooth.itinerary_of)"
        )
    return [(c, boundary) for c, boundary, _ in table], [named[name] for _, _, name in table]


def unknowns_of(kernels: OrbitKernels) -> tuple[str, ...]:
    """Return the names of a declared orbit's unknowns: dwell times, then the start."""
    dwell = _part_names(kernels)
    taken = {*dwell, *(p.name for p in kernels.system.parameters)}
    states = kernels.system.table["states"]
    return (*dwell, *start_names(states, taken, kernels.table.get("start")))


def _part_names(kernels: OrbitKernels) -> tuple[str, ...]:
    return tuple(name for _, _, name in kernels.table["phases"])


def whole_names(kernels: OrbitKernels, count: int) -> tuple[str, ...]:
    """Return the unknowns' names for an orbit of `count` phases over the whole period.

    Names of phases that are images by the symmetry bear the image's number.
    """
    part = _part_names(kernels)
    images = count // len(part)
    dwell = [n if k == 0 else f"{n}_{k + 1}" for k in range(images) for n in part]
    return (*dwell, *unknowns_of(kernels)[len(part) :])


def solve_declared(
    kernels: OrbitKernels,
    parameters: Mapping[str, object],
    guess: Guess = None,
    *,
    unknown: Iterable[str] = (),
    given: Mapping[str, object] | None = None,
    throw: bool = True,
) -> Orbit:
    """Compose an orbit that was declared by its phases, whose equations have no closed form.

    Absent parameters take the reference point's values; where the declaration names a
    period its name is among them. The guess has dwell times and coordinates of the start,
    all in their order or some by name: absent dwell times take the reference's guess,
    absent coordinates that or what fits best. Without a guess the reference orbit is
    followed to these parameters where it can be. Nothing may be solved for in place of
    unknowns: `unknown` has to be empty, and `given` may hold ``period`` only. With
    `throw`, `NoConvergence` is raised if no orbit is found; `InputError` is raised for
    wrong names or values, and for a dwell time that is neither given nor in a reference.
    """
    period = period_in(unknown, given, kernels.name)
    reference = kernels.table["reference"] or {"parameters": {}, "guess": {}}
    values: dict[str, Any] = {**reference["parameters"], **parameters}
    declared = kernels.table.get("period")
    if declared is not None:
        own = values.pop(declared["name"], None)
        period = own if period is None else period
    symmetry: Mapping[str, str] | None = kernels.table.get("symmetry") or None
    names, count = unknowns_of(kernels), len(kernels.table["phases"])
    # a start's coordinate may have its state's name
    synonyms = dict(zip(kernels.system.table["states"], names[count:], strict=True))
    named = named_guess(kernels, guess, names, count, synonyms)
    rest = [named.get(name) for name in names[: count - 1]]
    if period is not None and names[count - 1] not in named and None not in rest:
        # the last phase takes what the others leave
        named[names[count - 1]] = float(as_value(period)) - sum(x for x in rest if x is not None)
    phases, dwell = phases_and_dwell(kernels, named)
    known = [named.get(name) for name in names[count:]]
    orbit = None
    if guess is None and period is None and values != reference["parameters"]:
        defaults = dict(reference["parameters"])
        if defaults.keys() == values.keys():
            start = _start(kernels.system, defaults, phases, dwell, known, symmetry)
            orbit = _followed(kernels.system, defaults, values, (phases, dwell, start), symmetry)
    if orbit is None:
        start = _start(kernels.system, values, phases, dwell, known, symmetry)
        orbit = solve_itinerary(
            kernels.system, values, phases, dwell, start, period=period, symmetry=symmetry
        )
    names = whole_names(kernels, len(orbit.itinerary))
    orbit = labelled(orbit, kernels.name, names)
    if throw and not orbit.converged:
        raise NoConvergence(f"{kernels.name}: {orbit.message}")
    return orbit


_Guess = tuple[list[tuple[str, str]], list[float], list[float] | None]


def _followed(
    system: SystemKernels,
    defaults: Mapping[str, object],
    values: Mapping[str, Any],
    guess: _Guess,
    symmetry: Mapping[str, str] | None,
) -> Orbit | None:
    """Return the reference orbit carried to the parameters; None if it gets lost."""
    phases, dwell, start = guess
    end = {name: float(value) for name, value in system_parameters(system, values).items()}
    begin = np.array([float(as_value(defaults[name])) for name in end])
    orbit = None
    for step, here in enumerate(steps_between(begin, np.array([*end.values()]))):
        last = step == CONTINUATION_STEPS
        point = values if last else dict(zip(end, here.tolist(), strict=True))
        orbit = solve_itinerary(system, point, phases, dwell, start, symmetry=symmetry)
        if not orbit.converged:
            return None
        dwell = orbit.dwell_times.tolist()[: len(phases)]
        start = orbit.states[0].tolist()
    return orbit


def _start(
    system: SystemKernels,
    values: Mapping[str, object],
    phases: Sequence[tuple[str, str]],
    dwell: Sequence[float],
    known: Sequence[float | None],
    symmetry: Mapping[str, str] | None,
) -> list[float] | None:
    """Return a guess of the start (N): unknown entries are those that fit the dwell times best."""
    given = [value for value in known if value is not None]
    if len(given) == len(known):
        return given
    if not given or symmetry:
        return None
    start = fitted_start(piecewise(system, values), phases, dwell)
    return [fitted if value is None else value for fitted, value in zip(start, known, strict=True)]


def fitted_start(
    point: PiecewiseLinear, itinerary: Sequence[tuple[str, str]], dwell: Sequence[float]
) -> list[float]:
    """Return the start (N) of an itinerary that fits given dwell times best."""
    cycle, flat = itinerary_shape(point.structure, itinerary), numbers_of(point)[None]
    with np.errstate(all="ignore"):
        found: list[float] = fitting_start(cycle, flat, np.array([dwell]))[0].tolist()
    return found


def with_routes(kernels: SystemKernels, itinerary: _Phases) -> SystemKernels:
    """Return kernels in which every transition of an itinerary is listed, also those of the law.

    They are the same kernels where nothing is missing.
    """
    structure = structure_of(kernels)
    if structure.unvisited:
        return _visited(kernels, structure, itinerary)
    law = structure.law
    if law is None or not any(_unlisted(structure, itinerary)):
        return kernels
    return _listed(kernels, itinerary, lambda place, event, target: _shortest(law, event, target))


def _visited(kernels: SystemKernels, structure: Structure, itinerary: _Phases) -> SystemKernels:
    """Return kernels with the configurations of an itinerary, as far as it is one."""
    known = {structure.configurations[c] for c in structure.visited}
    wanted = [
        (source, names)
        for source, names, _ in _steps(itinerary)
        if source not in known or (len(names) > 1 and not _listed_at(structure, source, names)[1])
    ]
    return grown(kernels, wanted) if wanted else kernels


def _listed_at(
    structure: Structure, source: str, names: tuple[str, ...]
) -> tuple[int, Sequence[TransitionShape]]:
    """Return the number of a configuration, and what is listed for boundaries reached in it."""
    here = structure.configuration(source)
    reached = frozenset(structure.boundary(here, name) for name in names)
    return here, structure.listed(here, reached)


def with_routes_at(
    kernels: SystemKernels,
    point: PiecewiseLinear,
    itinerary: _Phases,
    dwell_times: np.ndarray,
    starts: np.ndarray,
) -> SystemKernels:
    """Return kernels with the routes that the law takes at the ends of an orbit's phases.

    `starts` (p, N) are the states where the phases begin. The kernels are the same where
    the system has no law of contact.
    """
    structure = point.structure
    if structure.law is None:
        return kernels
    law = structure.law
    decider = Decider(structure, point.fields, point.rows, point.resets)

    def taken(place: int, event: ContactEvent, target: int) -> Path:
        source = structure.configuration(itinerary[place][0])
        times = np.asarray(dwell_times[place : place + 1], dtype=float)
        end = flow_states(point, source, times, np.asarray(starts[place], dtype=float))[0]
        error = 64 * np.finfo(float).eps * float(times[0])
        found = decider.outcome(event, decider.located(source, np.append(end, 1.0), error))
        paths = dict(zip(found.targets, found.paths, strict=True))
        alone = len(found.targets) == 1 and target in paths
        return paths[target] if alone else _shortest(law, event, target)

    return _listed(kernels, itinerary, taken)


def _shortest(law: Law, event: ContactEvent, target: int) -> Path:
    """Return the path on which all that slips behind the event slips from its first step on."""
    regimes = law.regimes[target]
    slipping = {i for i in event.resting
                if law.contacts[i].friction and regimes[i] not in HOLDING}  # fmt: skip
    first = Stage(event.reached, regimes)
    return (first,) if slipping <= event.reached else (
        first, Stage(event.reached | slipping, regimes)
    )  # fmt: skip


def _unlisted(
    structure: Structure, itinerary: _Phases
) -> Iterator[tuple[int, int, tuple[str, ...], int]]:
    """Yield place, source, boundaries and target of each transition that is not listed."""
    for place, (source, names, target) in enumerate(_steps(itinerary)):
        here, listed = _listed_at(structure, source, names)
        there = structure.configuration(target)
        if all(t.target != there for t in listed):
            yield place, here, names, there


def _steps(itinerary: _Phases) -> list[tuple[str, tuple[str, ...], str]]:
    """Return source, boundaries and target of each transition that reaches a boundary."""
    if [boundary for _, boundary in itinerary] == [FORCING_PHASE]:
        return []
    names = [tuple(b.split("+")) if isinstance(b, str) else tuple(b) for _, b in itinerary]
    sources = [str(c) for c, _ in itinerary]
    return list(zip(sources, names, [*sources[1:], *sources[:1]], strict=True))


def _listed(
    kernels: SystemKernels, itinerary: _Phases, path: Callable[[int, ContactEvent, int], Path]
) -> SystemKernels:
    """Return kernels with routes for unlisted transitions that the law allows."""
    structure = structure_of(unfolded(kernels, ()))
    law, routes = structure.law, []
    assert law is not None
    for place, here, names, there in _unlisted(structure, itinerary):
        event = law.event(here, names)
        if event is not None and law.leads(event, there):
            source, target = structure.configurations[here], structure.configurations[there]
            routes.append(Route(source, names, target, path(place, event, there)))
    return unfolded(kernels, routes)
