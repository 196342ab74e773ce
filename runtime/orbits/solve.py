"""One periodic orbit at one parameter point: of an itinerary that is named, or that is given."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, cast

import numpy as np

from nonsmooth.runtime.core.errors import InputError, NoConvergence, one_or_several, unknown_name
from nonsmooth.runtime.core.values import by_name
from nonsmooth.runtime.model.kernels import OrbitKernels, SystemKernels, kernels_of, load_orbit
from nonsmooth.runtime.model.loading.declared import DeclaredOrbit, DeclaredSystem
from nonsmooth.runtime.orbits.kernel_solve import solve_kernels
from nonsmooth.runtime.orbits.orbit import DOUBLE, Orbit
from nonsmooth.runtime.orbits.refine import check_digits, refine
from nonsmooth.runtime.orbits.table_solve import (
    Symmetries,
    period_in,
    solve_declared,
    solve_itinerary,
)
from nonsmooth.runtime.simulation.last_cycle import Recurrence

__all__ = ["Itinerary", "guess_along", "solve"]

Itinerary = Sequence[tuple[str, str]] | Recurrence


def solve(
    orbit: str | DeclaredOrbit | DeclaredSystem | OrbitKernels | SystemKernels,
    parameters: Mapping[str, object] | None = None,
    guess: Sequence[float] | Mapping[str, float] | Any = None,
    *,
    itinerary: Itinerary | None = None,
    symmetry: Symmetries = None,
    unknown: Iterable[str] = (),
    given: Mapping[str, object] | None = None,
    digits: int = DOUBLE,
    throw: bool = True,
) -> Orbit:
    """Find the periodic orbit of an itinerary.

    Without a guess it starts from the orbit's reference point; where that leads nowhere, or
    to a solution that is no motion of the real system, it follows the reference orbit to
    these parameters and then tries a grid of starts.

    Parameters
    ----------
    orbit : str or Itinerary, or a system beside an `itinerary`
        ``system/orbit``, or a user's ``FILE.py:ORBIT``. One whose equations have no closed
        form is composed numerically from its phases. Of a file of orbits ``FILE.json:N``, the
        N-th, counted from 1: its parameters are the defaults. With an `itinerary` the name of
        a system, or a System.
    parameters : mapping of str to number, text or Value, optional
        Those of the equations, or the physical ones in their place; absent ones take the
        reference point's values. With an `itinerary` all physical parameters. Nondimensional,
        or in the units of the declaration.
    guess : sequence or mapping of float, optional
        Start of the unknowns, all in their order or some by name. With an `itinerary` the dwell
        times, one for each phase, or these and the state at the start of the first phase;
        without that the state that fits the dwell times best is taken.
    itinerary : sequence of (configuration, boundary), or Recurrence, optional
        The phases of an orbit that has no name: cyclic, the last leads back to the first.
        Boundaries that are reached together are ``"a+b"`` or a sequence of names: the first
        one's switching condition is solved, and admissibility asks for the others'. The cycle
        of a motion, as `itinerary_of` gives it, brings its own guess.
    symmetry : mapping of state to text, or array (N, N), optional
        Of an `itinerary`: a signed permutation of the states that maps motions to motions, such
        as ``{"x": "-x", "v": "-v"}``. The itinerary is then that of the first part of the
        orbit, half of it where the symmetry is its own inverse: the symmetry maps the state
        behind its last transition to the start. The orbit that is returned is the whole one.
    unknown, given : names, and mapping of names to values
        Exchange: the parameters named in `unknown` are solved for, the unknowns named in
        `given` keep their values; as many of one as of the other. An orbit that is composed
        takes none of them, but its ``period`` may be given: it singles out one of a family of
        orbits, as there is where energy is kept.
    digits : int
        True decimal digits; above 15 as `refine` gives them.
    throw : bool
        Raise when there is no convergence; otherwise the orbit's `status` says it.

    Returns
    -------
    Orbit
        In double precision; the iteration ends when a full Newton step is below
        ``1e-9 max(1, |x|)``, which leaves an error of rounding.

    Raises
    ------
    InputError
        For wrong names or values, a guess of the wrong length, an exchange that the equations
        do not determine (its condition number is given), an itinerary that the system does not
        allow, or what is no symmetry of it at these parameters.
    NoConvergence
        If no orbit was found, and the message says what was tried, or if it cannot be refined.

    Examples
    --------
    >>> solve("dry-friction/global-stick").stability.verdict
    'stable'
    >>> data = dict(chi="0.5", eta=1, V=1, us1=1, us2=1, ur1="4.0195", ur2="1.4831")
    >>> phases = [
    ...     ("stick-stick", "first-breaks-forward"),
    ...     ("slip-stick", "second-breaks-forward"),
    ...     ("slip-slip", "first-reaches-belt"),
    ...     ("stick-slip", "second-reaches-belt"),
    ... ]
    >>> orbit = solve("dry-friction", data, [1, 2, 1.5, 3.3], itinerary=phases)
    >>> orbit.stability.verdict, orbit.admissibility.verdict
    ('stable', True)
    """
    check_digits(digits)
    named, swapped = cast("Any", orbit), one_or_several(unknown)
    values, fixed = by_name("parameters", parameters), by_name("given", given)
    if itinerary is not None:
        system, period = kernels_of(named), period_in(swapped, fixed)
        phases, dwell, start = guess_along(system, itinerary, guess)
        found = solve_itinerary(
            system, values, phases, dwell, start, period=period, symmetry=symmetry
        )
        if throw and not found.converged:
            raise NoConvergence(f"{found.name}: {found.message}")
    elif symmetry is not None:
        raise InputError("a symmetry closes an itinerary: give that, and the system")
    else:
        kernels = named if isinstance(named, OrbitKernels) else load_orbit(named)
        exchange: Any = {"unknown": swapped, "given": fixed, "throw": throw}
        if kernels.derived:
            label = orbit if isinstance(orbit, str) else ""
            found = solve_kernels(kernels, values, guess, label=label, **exchange)
        else:
            found = solve_declared(kernels, values, guess, **exchange)
    return refine(found, digits) if digits > DOUBLE and found.converged else found


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
