"""Many parameter points at once, of an itinerary that is named or that is given."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from numbers import Integral
from typing import Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.kernels import OrbitKernels, SystemKernels, kernels_of, load_orbit
from nonsmooth.runtime.model.loading.declared import DeclaredOrbit, DeclaredSystem
from nonsmooth.runtime.orbits.declared_many import solve_declared_many
from nonsmooth.runtime.orbits.kernel_many import CHUNK, solve_kernels_many
from nonsmooth.runtime.orbits.many_derivatives import derivatives_of_many
from nonsmooth.runtime.orbits.orbit_arrays import Orbits
from nonsmooth.runtime.orbits.solve import Itinerary, guess_along
from nonsmooth.runtime.orbits.table_many import solve_itineraries
from nonsmooth.runtime.orbits.table_solve import period_in

__all__ = ["Orbits", "solve_many"]


def solve_many(
    orbit: str | DeclaredOrbit | DeclaredSystem | OrbitKernels | SystemKernels,
    parameters: Mapping[str, Any] | None = None,
    guess: Any = None,
    *,
    itinerary: Itinerary | None = None,
    given: Mapping[str, Any] | None = None,
    multipliers: bool = False,
    admissibility: bool = True,
    threads: int | None = None,
    chunk: int = CHUNK,
    derivatives: Sequence[str] | str = (),
    **named: Any,
) -> Orbits:
    """Find the orbit of an itinerary at many parameter points.

    Each point of an orbit that has a name starts from a first-order prediction from the
    reference orbit; where that fails, from the reference orbit itself and from a few other
    starts. What is found at a point depends on nothing but its own parameters: not on
    `threads`, `chunk` or on other points.

    Parameters
    ----------
    orbit : str or Itinerary, or a system beside an `itinerary`
        ``system/orbit``, ``FILE.py:orbit`` or ``FOLDER:orbit``; with an `itinerary` the name
        of a system, or a System.
    parameters : mapping of str to array_like, optional
        Parameters of the equations, broadcast against each other; absent ones take the
        reference point's values. With an `itinerary` all physical parameters.
    guess : array (..., p) or (..., p + N), optional
        Of an `itinerary`: the dwell time of each phase, or these and the start, for all points
        or for each; they may be many for one point.
    itinerary : sequence of (configuration, boundary), or Recurrence, optional
        As for `solve`.
    given : mapping, optional
        The ``period`` (...) of an `itinerary`, as for `solve`.
    multipliers : bool
        Of an `itinerary`: also give multipliers, and the derivatives of what they make up.
    admissibility : bool
        Also decide whether each orbit is a motion of the real system; where several are
        found, one that is comes first. About a millisecond a point for orbits without kernels.
    threads : int, optional
        As many as processors when omitted.
    chunk : int
        Points that one thread takes at a time, of orbits with kernels.
    derivatives : sequence of str, or str
        Parameters by which unknowns, period and trace are differentiated, exactly up to
        rounding: `Orbits.derivatives`. With `multipliers` also their product, ``determinant``,
        and ``spectral_radius``, as `Orbit.derivatives` names them.
    **named : array_like
        More of the parameters, by keyword.

    Returns
    -------
    Orbits

    Raises
    ------
    InputError
        For an unknown parameter, arrays that do not broadcast, or no positive number of
        threads or points; with an `itinerary` as `solve`.

    Examples
    --------
    >>> import numpy as np
    >>> found = solve_many("dry-friction/global-stick", eta=np.linspace(0.95, 1.05, 5))
    >>> found.converged.all(), found.trace.shape
    (np.True_, (5,))
    >>> found = solve_many("dry-friction/global-stick", eta=[1, 1.01], derivatives=["eta", "V"])
    >>> found.derivatives["period"]["V"].shape
    (2,)
    """
    values = {**(parameters or {}), **named}
    options: Any = {"admissibility": admissibility, "threads": threads}
    _check_positive("chunk", chunk)
    if threads is not None:
        _check_positive("threads", threads)
    system_or_orbit: Any = orbit
    if itinerary is not None:
        system, period = kernels_of(system_or_orbit), period_in((), given)
        phases, dwell, start = guess_along(system, itinerary, guess)
        options |= {"multipliers": multipliers}
        found = solve_itineraries(system, phases, values, dwell, start, period, **options)
    else:
        beside = {
            "guess": guess is not None, "given": given is not None, "multipliers": multipliers
        }  # fmt: skip
        if any(beside.values()):
            wrong = " and ".join(name for name, is_given in beside.items() if is_given)
            raise InputError(f"{wrong}: of an itinerary only, beside its system")
        known = orbit if isinstance(orbit, OrbitKernels) else load_orbit(system_or_orbit)
        solved = solve_kernels_many if known.derived else solve_declared_many
        found = solved(known, values, chunk=chunk, **options)
    if not derivatives:
        return found
    return replace(found, derivatives=derivatives_of_many(found, derivatives, threads))


def _check_positive(name: str, number: object) -> None:
    if isinstance(number, bool) or not isinstance(number, Integral) or int(number) < 1:
        raise InputError(f"{name} = {number} is not a positive integer")
