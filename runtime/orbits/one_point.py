"""One periodic orbit at one parameter point: of an itinerary that is named, or that is given.

A named one has kernels of its own equations, or is composed from its phases, as a given one is.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import product
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, NoConvergence, unknown_name
from nonsmooth.runtime.core.values import Value, parse
from nonsmooth.runtime.model.completion import Point, complete, complete_system
from nonsmooth.runtime.model.kernels import OrbitKernels, SystemKernels
from nonsmooth.runtime.model.parameters import in_domain
from nonsmooth.runtime.orbits.admissible import NEITHER, kernel_limits
from nonsmooth.runtime.orbits.kernel_problem import kernel_problem
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.table_solve import (
    CONTINUATION_STEPS,
    named_guess,
    phases_and_dwell,
    solve_itinerary,
    steps_between,
    value_of,
)
from nonsmooth.runtime.shooting.kernel_newton import Full, judged_at, solve_full, solve_reduced
from nonsmooth.runtime.shooting.newton import CONVERGED, OUTSIDE, sure_digits
from nonsmooth.runtime.simulation.recurrence import Recurrence

STARTS_PER_UNKNOWN, STARTS_OF_ONE = 40, 400
SHORTEST_DWELL, LONGEST_DWELL = 1e-6, 12.6  # up to two periods of the unit frequency

Itinerary = Sequence[tuple[str, str | Sequence[str]]] | Recurrence


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
        width = np.atleast_1d(np.asarray(guess, dtype=float)).shape[-1]
    except (TypeError, ValueError):
        raise InputError("the guess holds something else than real numbers") from None
    if width not in (count, count + size):
        raise InputError(
            f"the guess has {width} values: it takes {count}, a dwell time for each phase,"
            f" or {count + size}, these and the start: {', '.join(states)}"
        )
    if width == count:
        return phases, guess, None
    if np.ndim(guess) == 1:
        return phases, list(guess[:count]), list(guess[count:])
    return phases, np.asarray(guess)[..., :count], np.asarray(guess)[..., count:]


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


def solve_kernels(
    kernels: OrbitKernels,
    parameters: Mapping[str, object] | None = None,
    guess: Sequence[Any] | np.ndarray | Mapping[str, Any] | None = None,
    *,
    unknown: Iterable[str] = (),
    given: Mapping[str, object] | None = None,
    throw: bool = True,
    label: str = "",
) -> Orbit:
    """Find a periodic orbit by the kernels of its own equations, as `solve` does.

    Absent parameters take the reference point's values; without a guess, unknowns are
    searched for. `unknown` names parameters that are solved for, `given` has the unknowns
    that are given in their place. With `throw`, `NoConvergence` is raised if no orbit is
    found; `InputError` is raised for wrong names or values, or an exchange that does not
    fit. Messages call the orbit by `label`, if that is not empty.
    """
    swapped, fixed = tuple(unknown), dict(given or {})
    if swapped or fixed:
        _check_exchange(kernels, swapped, fixed)
    point = complete(kernels, parameters or {}, without=swapped)
    start = _start(kernels, point, guess, swapped)
    values = {name: value_of(name, value) for name, value in fixed.items()}
    found, tried = (
        _exchanged(
            kernels,
            point,
            swapped,
            values,
            start,
        )
        if swapped
        else _ordinary(kernels, point, start, searching=guess is None)
    )
    if throw and not found.converged:
        searched = guess is None and not swapped and kernels.reduced
        reason = "no orbit was found at these parameters" if searched else found.message
        raise NoConvergence(f"{label or kernels.name}: {reason} (tried: {', '.join(tried)})")
    return found


def search(kernels: OrbitKernels, parameters: np.ndarray) -> np.ndarray:
    """Return all orbits (k, n) that Newton's method reaches from a grid, admissible ones first.

    They are distinct and have positive dwell times. `parameters` is (p,).
    """
    starts = np.array(list(product(_grid(kernels), repeat=len(kernels.reduced))))
    solved = solve_reduced(kernels, parameters, starts)
    found = _distinct(solved.unknowns[solved.status == CONVERGED])
    limit, _ = kernel_limits(
        kernels, np.broadcast_to(parameters, (len(found), len(parameters))), found
    )
    return found[np.argsort(limit != NEITHER, kind="stable")]


def _distinct(roots: np.ndarray) -> np.ndarray:
    """Return the first root of each cluster, in the order of the roots."""
    first = []
    while len(roots):
        first.append(roots[0].copy())  # a view would keep all of `roots`
        apart = np.abs(roots - roots[0]) > 1e-7 * (1 + np.abs(roots[0]))
        roots = roots[apart.any(axis=-1)]
    return np.array(first).reshape(-1, roots.shape[-1])


def _grid(kernels: OrbitKernels) -> np.ndarray:
    """Return starts of the reduced unknowns: even, or geometric where there is only one."""
    if len(kernels.reduced) == 1:
        return np.geomspace(SHORTEST_DWELL, LONGEST_DWELL, STARTS_OF_ONE)
    return np.linspace(0, LONGEST_DWELL, STARTS_PER_UNKNOWN + 1)[1:]


def _ordinary(
    kernels: OrbitKernels, point: Point, start: dict[str, float], *, searching: bool
) -> tuple[Orbit, list[str]]:
    """Solve the reduced equations for all unknowns, and tell from where that was tried.

    Where it is searched for, a motion of the real system comes before what converges first.
    """
    parameters = np.array([float(v) for v in point.values.values()])
    guess = np.array([start[name] for name in kernels.reduced])
    first, tried = None, []
    for words, begin in _starts(kernels, parameters, guess, searching):
        tried.append(words)
        if begin is None:
            continue
        found = _orbit(kernels, point, parameters, solve_reduced(kernels, parameters, begin))
        if not searching or not kernels.reduced or _good(found, parameters):
            return found, tried
        if first is None or not first.converged:
            first = found
    assert first is not None
    return first, tried


def _starts(
    kernels: OrbitKernels, parameters: np.ndarray, guess: np.ndarray, searching: bool
) -> Iterator[tuple[str, np.ndarray | None]]:
    """Yield starts (m,) of the reduced unknowns, and where they come from; None for none."""
    if not kernels.reduced:
        yield "the explicit solution", guess
    yield "the reference point's guess" if searching else "the guess", guess
    places = [kernels.unknowns.index(name) for name in kernels.reduced]
    defaults = kernels.table["reference"]["parameters"]
    begin = np.array([float(parse(defaults[name])) for name in kernels.parameter_names])
    for here in steps_between(begin, parameters):
        guess = solve_reduced(kernels, here, guess).unknowns[places]
    yield f"continuation in {CONTINUATION_STEPS} steps", guess
    candidates = search(kernels, parameters)
    nearest = candidates[0][places] if len(candidates) else None
    yield f"{len(_grid(kernels)) ** len(places)} starts", nearest


def _good(orbit: Orbit, parameters: np.ndarray) -> bool:
    """Return whether an orbit has converged and may be a motion of the real system."""
    if not orbit.converged:
        return False
    kernels, unknowns = orbit.kernels, np.array([*orbit.unknowns.values()])
    limit, bounds = kernel_limits(kernels, parameters[None], unknowns[None])
    if not orbit.opened or limit[0] != NEITHER:
        return bool(limit[0] == NEITHER)
    least = zip(kernels.open_parameters, bounds[0], strict=True)
    return all(float(orbit.opened[p.name]) > bound for p, bound in least if p.name in orbit.opened)


def _orbit(kernels: OrbitKernels, point: Point, parameters: np.ndarray, solved: Any) -> Orbit:
    """Return the record of a reduced solution, with the residual of the full equations."""
    unknowns = dict(zip(kernels.unknowns, solved.unknowns.tolist(), strict=True))
    status = int(solved.status)
    residual, digits = float(solved.residual), 0
    if not all(in_domain(kernels.tables[name], unknowns[name]) for name in kernels.solved_for):
        status = OUTSIDE
    if status == CONVERGED:
        x = np.concatenate([solved.unknowns, parameters])
        residual, error, status = judged_at(kernels, x, slice(len(kernels.unknowns)))
        digits = sure_digits(error)
    return Orbit(
        kernel_problem(kernels),
        point.values,
        unknowns,
        point.opened,
        residual,
        digits,
        int(solved.iterations),
        status,
    )


def _exchanged(
    kernels: OrbitKernels,
    point: Point,
    swapped: tuple[str, ...],
    fixed: dict[str, Value],
    start: dict[str, float],
) -> tuple[Orbit, list[str]]:
    """Solve the full equations with parameters in place of unknowns.

    It starts from the guess; if that fails, the given values are approached in steps from
    an orbit at the default values of what is now unknown.
    """
    defaults = kernels.table["reference"]["parameters"] if kernels.table["reference"] else {}
    values = {name: float(parse(text)) for name, text in defaults.items()}
    values |= {name: float(v) for name, v in point.values.items()} | start
    target = {name: float(v) for name, v in fixed.items()}
    solved_for = [n for n in kernels.unknowns if n not in fixed] + list(swapped)
    tried = ["the guess"]
    try:
        found = solve_full(kernels, values | target, solved_for)
        refusal = None
    except InputError as error:
        found, refusal = None, error
    if found is None or found.status != CONVERGED:
        tried.append(f"{CONTINUATION_STEPS} steps to the given values")
        found = _approached(kernels, values, target, solved_for) or found
    if found is None:
        assert refusal is not None
        raise refusal
    tables = {p.name: p for p in kernels.parameters}
    if found.status == CONVERGED and not all(
        in_domain(tables[name], found.values[name]) for name in swapped
    ):
        found = found._replace(status=OUTSIDE)
    unknowns = {name: found.values[name] for name in solved_for}
    orbit = Orbit(
        kernel_problem(kernels),
        {**point.values, **fixed},
        unknowns,
        point.opened,
        found.residual,
        sure_digits(found.error),
        found.iterations,
        found.status,
    )
    return orbit, tried


def _approached(
    kernels: OrbitKernels,
    values: dict[str, float],
    target: dict[str, float],
    solved_for: Sequence[str],
) -> Full | None:
    base = solve_full(kernels, values, list(kernels.unknowns))
    if base.status != CONVERGED:
        return None
    found = base
    for fraction in np.linspace(0, 1, CONTINUATION_STEPS + 1)[1:]:
        here = {n: base.values[n] + fraction * (t - base.values[n]) for n, t in target.items()}
        try:
            found = solve_full(kernels, found.values | here, solved_for)
        except InputError:
            return None
    return found


def _start(
    kernels: OrbitKernels,
    point: Point,
    guess: Sequence[Any] | np.ndarray | Mapping[str, Any] | None,
    swapped: Sequence[str],
) -> dict[str, float]:
    """Return a start for every unknown, and for exchanged parameters if they are given."""
    unknowns, reference = kernels.unknowns, kernels.table["reference"]
    others = dict(zip(swapped, swapped, strict=True))
    named = named_guess(kernels, guess, unknowns, len(unknowns), others)
    if reference is None and not named and unknowns:
        raise InputError(f"{kernels.name} declares no reference point: give a guess")
    if all(name in named for name in kernels.unknowns):
        return named
    values = complete(kernels, {}) if reference else point
    return _fitted(kernels, {**values.values, **values.opened}, named) | named


def _fitted(
    kernels: OrbitKernels, values: Mapping[str, Value], named: Mapping[str, float]
) -> dict[str, float]:
    """Return the start's coordinates that fit dwell times, from the composed orbit."""
    system, (phases, dwell) = kernels.system, phases_and_dwell(kernels, named)
    whole = complete_system(kernels, values).values
    orbit = solve_itinerary(system, whole, phases, dwell)
    states = zip(system.table["states"], orbit.states[0].tolist(), strict=True)
    return {f"{state}0": value for state, value in states}


def _check_exchange(
    kernels: OrbitKernels, swapped: tuple[str, ...], fixed: Mapping[str, object]
) -> None:
    for name in swapped:
        if name not in kernels.parameter_names:
            raise unknown_name("parameter to solve for", name, kernels.parameter_names)
    for name in fixed:
        if name not in kernels.unknowns:
            raise unknown_name("variable", name, kernels.unknowns)
    if len(set(swapped)) != len(swapped):
        raise InputError(f"a parameter is named twice among the unknown: {', '.join(swapped)}")
    if len(swapped) != len(fixed):
        raise InputError(
            f"to be solved for: {', '.join(swapped) or 'no parameter'}; given in place:"
            f" {', '.join(fixed) or 'no unknown'}: as many of one as of the other are needed"
        )
