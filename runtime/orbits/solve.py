"""Periodic orbits at one parameter point or many, of an itinerary that is named or that is given.

One declared orbit is composed from its system's tables. At many points kernels of its own
equations take their place, where these can be compiled: from the same reference orbit they find
the same, under the same names.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache, cached_property
from typing import TYPE_CHECKING, Any, cast, overload

import numpy as np

from nonsmooth.runtime.core.errors import InputError, NoConvergence, one_or_several
from nonsmooth.runtime.core.values import axes, by_name, real_array
from nonsmooth.runtime.model.kernel_records import SavedTable
from nonsmooth.runtime.model.kernels import (
    OrbitKernels,
    SystemKernels,
    kernels_of,
    kernels_of_many,
    load_orbit,
)
from nonsmooth.runtime.model.loading.declared import DeclaredOrbit, DeclaredSystem
from nonsmooth.runtime.model.parameters import parameter_points
from nonsmooth.runtime.orbits.directions import derivatives_of_many
from nonsmooth.runtime.orbits.kernel_solve import CHUNK, KernelPoints, solve_kernels
from nonsmooth.runtime.orbits.orbit import DOUBLE, Orbit, Orbits, changed, reshaped
from nonsmooth.runtime.orbits.refine import check_digits, refine
from nonsmooth.runtime.orbits.table_many import Arrays, TablePoints, solve_itineraries
from nonsmooth.runtime.orbits.table_solve import (
    Guess,
    Itinerary,
    Symmetries,
    guess_along,
    period_in,
    solve_declared,
    solve_itinerary,
)
from nonsmooth.runtime.simulation.simulate import checked_count

if TYPE_CHECKING:
    from nonsmooth.runtime.core.values import Number, Numbers

__all__ = [
    "DeclaredPoints",
    "OrbitPoints",
    "Orbits",
    "declared_kernels",
    "points_of",
    "solve",
]

AnyOrbit = str | DeclaredOrbit | DeclaredSystem | OrbitKernels | SystemKernels

_SAME = 1e-7  # difference of one orbit by kernels and by tables, in units of max(1, |x|)


@dataclass(frozen=True, eq=False)
class DeclaredPoints(TablePoints):
    """A composed orbit at many points, where kernels of its own equations find it.

    Where they search for dwell times Newton's method may end at a root that is no motion, such as
    one without a phase; there the tables of its system look for another one.
    """

    derived: OrbitKernels  # of its own equations, with the composed orbit's reference

    @cached_property
    def alone(self) -> bool:
        """Whether the kernels alone decide: they search for nothing but the start of the orbit."""
        return not {*self.derived.reduced} & {*self.derived.timed}

    @property
    def chunk(self) -> int:
        """See `KernelPoints`."""
        return self._points.chunk if self.alone else super().chunk

    @property
    def start_names(self) -> tuple[str, ...]:
        """See `KernelPoints`: all unknowns where the tables have the last word."""
        return self._points.start_names if self.alone else self.unknowns

    @property
    def limits(self) -> tuple[str, ...]:
        """See `KernelPoints`."""
        return self._points.limits if self.alone else super().limits

    @property
    def usual(self) -> np.ndarray:
        """See `KernelPoints`."""
        return self._points.usual if self.alone else super().usual

    def solve(
        self,
        values: Arrays,
        start: np.ndarray | None = None,
        *,
        admissibility: bool = True,
        margins: bool = False,
        threads: int | None = 1,
        chunk: int = CHUNK,
    ) -> Orbits:
        """See `KernelPoints`."""
        options: Any = {"margins": margins, "threads": threads}
        near = start
        if start is not None and not self.alone:
            near = start[:, [self.unknowns.index(name) for name in self.derived.reduced]]
        judged = admissibility or not self.alone
        found = self.by_kernels(values, near, admissibility=judged, chunk=chunk, **options)
        if self.alone:
            return found
        shape, found = found.status.shape, reshaped(found, (-1,))
        rest = np.flatnonzero(~np.asarray(found.admissible))
        if len(rest):
            given = found.parameters.items()
            part = {name: np.broadcast_to(array, shape).ravel()[rest] for name, array in given}
            again = None if start is None else start[rest]
            others = super().solve(part, again, admissibility=admissibility, **options)

            def filled(array: np.ndarray, values: np.ndarray) -> np.ndarray:
                both = np.array(array)
                both[rest] = values
                return both

            found = changed(filled, found, others)
        found = reshaped(replace(found, limits=self.limits), shape)
        return found if admissibility else replace(found, limit=None, limits=(), bounds=None)

    @cached_property
    def _points(self) -> KernelPoints:
        """The same orbit in the names of the kernels."""
        unused = {p.name for p in self.derived.other_parameters}
        names = (name for name in self.derived.tables if name not in unused)
        return KernelPoints(self.derived, tuple(names))

    def by_kernels(self, values: Arrays, start: np.ndarray | None = None, **options: Any) -> Orbits:
        """Return what the kernels find, in the names of the composed orbit."""
        kernels, system = self._points.kernels, self.kernels.system
        unused = {p.name for p in kernels.other_parameters}
        taken = {n: x for n, x in values.items() if n in kernels.tables and n not in unused}
        if len(taken) < len(values):  # the others only have domains
            names = [p.name for p in system.parameters]
            points, shape = parameter_points(system, {name: values[name] for name in names})
            sound = np.isfinite(points).all(axis=1)
            first = kernels.parameter_names[0]
            place = names.index(first)
            taken[first] = np.where(sound, points[:, place], np.nan).reshape(shape)
        found = self._points.solve(taken, start, **options)
        shape, flat = found.status.shape, reshaped(found, (-1,))
        given = {n: np.broadcast_to(found.parameters[n], shape).ravel()
                 for n in kernels.parameter_names}  # fmt: skip
        unknowns, starts = self._composed(given, flat.unknowns)
        orbits = replace(
            flat,
            problem=self.reference.problem,
            parameters={
                name: real_array(f"parameter {name}", value) for name, value in values.items()
            },
            unknowns=unknowns,
            bounds=None if flat.bounds is None else {},
            starts=starts,
        )
        return reshaped(orbits, shape)

    def _composed(
        self, parameters: Arrays, unknowns: Arrays
    ) -> tuple[dict[str, np.ndarray], np.ndarray]:
        """Return the unknowns (n,) of composed orbits, and where their phases start (n, p, N).

        Parameters and unknowns (n,) are, beside others, those of the kernels' equations,
        NaN where there is no orbit.
        """
        kernels, names = self._points.kernels, self.unknowns
        solved = {name: unknowns[name] for name in kernels.unknowns}
        times = kernels.durations({**parameters, **solved})
        known, start = {**solved, **times}, names[len(times) :]
        if len(times) == 1 and known.keys() >= {*start}:
            starts = np.stack([known[name] for name in start], axis=-1)[:, None]
        else:
            x = np.stack([*solved.values()], axis=-1)
            points = np.stack([parameters[name] for name in kernels.parameter_names], axis=-1)
            spectrum, _ = kernels.spectrum(points)
            states = np.asarray(kernels.evaluate("states", at=(points, spectrum, x)))
            states[np.isnan(x).any(axis=-1)] = np.nan
            starts = states[:, : len(times)]
            known = {**dict(zip(start, starts[:, 0].T, strict=True)), **known}
        return {name: known[name] for name in names}, starts


def declared_kernels(orbit: OrbitKernels, key: str | None = None) -> DeclaredPoints | None:
    """Return the kernels that find a composed orbit at many points; None where tables have to.

    The first call waits until they are derived and compiled. None is returned where there
    is no compiler, where formulas are long, and where the kernels find another orbit at
    the reference point. `key` is that of `kernels_of_many`. `NoConvergence` is raised if
    there is no orbit at the reference point.
    """
    own = kernels_of_many(orbit, key)
    return None if own is None else _from_reference(orbit, own)


@cache
def _from_reference(orbit: OrbitKernels, own: OrbitKernels) -> DeclaredPoints | None:
    """Return kernels that begin where the composed orbit begins; None if they do not find it."""
    known = solve_declared(orbit, {})
    values = {name: float(known.unknowns[name]) for name in own.unknowns}
    guess = {name: repr(value) for name, value in values.items()}
    reference = {**own.table["reference"], "guess": guess}
    table = SavedTable(own.name, own.address, {**own.table, "reference": reference})
    kernels = replace(own, saved=table)
    found = solve_kernels(kernels, throw=False)
    same = all(
        abs(found.unknowns[name] - value) <= _SAME * max(1, abs(value))
        for name, value in values.items()
    )
    return DeclaredPoints(orbit, known, kernels) if same else None


OrbitPoints = KernelPoints | TablePoints


@cache
def points_of(kernels: OrbitKernels, given: tuple[str, ...]) -> OrbitPoints:
    """Return an orbit at many points, where what is fixed or swept has the names `given`.

    `InputError` is raised for an orbit that cannot be found at many points at once.
    """
    if kernels.derived:
        return KernelPoints(kernels, given)
    _check(kernels)
    try:
        return TablePoints(kernels, solve_declared(kernels, {}))
    except NoConvergence as problem:
        raise InputError(f"at its reference, where all points start: {problem}") from None


def _check(kernels: OrbitKernels) -> None:
    """Refuse a composed orbit that is not found at many points."""
    if kernels.table["reference"] is None:
        raise InputError(
            f"{kernels.name} declares no reference, from which many points could start: give its"
            " system, the itinerary and a guess"
        )
    if kernels.table.get("symmetry"):
        raise InputError(
            f"{kernels.name} is declared by a part and a symmetry, which one point at a time knows"
        )


@overload
def solve(  # type: ignore[overload-overlap]  # what has no array is one orbit
    orbit: AnyOrbit,
    parameters: Mapping[str, Number] | None = None,
    guess: Sequence[float] | Mapping[str, float] | np.ndarray | None = None,
    *,
    itinerary: Itinerary | None = None,
    symmetry: Symmetries = None,
    unknown: Iterable[str] = (),
    given: Mapping[str, Number] | None = None,
    digits: int = DOUBLE,
    throw: bool = True,
) -> Orbit: ...
@overload
def solve(
    orbit: AnyOrbit,
    parameters: Mapping[str, Number | Numbers],
    guess: Any = None,
    *,
    itinerary: Itinerary | None = None,
    given: Mapping[str, Number | Numbers] | None = None,
    multipliers: bool = False,
    admissibility: bool = True,
    derivatives: Sequence[str] | str = (),
    threads: int | None = None,
    chunk: int | None = None,
) -> Orbits: ...
@overload
def solve(
    orbit: AnyOrbit,
    parameters: Mapping[str, object] | None = None,
    guess: Any = None,
    *,
    itinerary: Itinerary | None = None,
    symmetry: Symmetries = None,
    unknown: Iterable[str] = (),
    given: Mapping[str, object] | None = None,
    digits: int = DOUBLE,
    throw: bool = True,
    multipliers: bool = False,
    admissibility: bool = True,
    derivatives: Sequence[str] | str = (),
    threads: int | None = None,
    chunk: int | None = None,
) -> Any: ...


def solve(
    orbit: AnyOrbit,
    parameters: Mapping[str, object] | None = None,
    guess: Guess = None,
    *,
    itinerary: Itinerary | None = None,
    symmetry: Symmetries = None,
    unknown: Iterable[str] = (),
    given: Mapping[str, object] | None = None,
    digits: int = DOUBLE,
    throw: bool = True,
    multipliers: bool = False,
    admissibility: bool = True,
    derivatives: Sequence[str] | str = (),
    threads: int | None = None,
    chunk: int | None = None,
) -> Orbit | Orbits:
    """Find the periodic orbit of an itinerary, at one parameter point or at many.

    Without a guess it starts from the orbit's reference point; where that leads nowhere, or
    to a solution that is no motion of the real system, it follows the reference orbit to
    these parameters and then tries a grid of starts.

    Arrays of parameters make many points. Each point of an orbit that has a name starts from a
    first-order prediction from the reference orbit; where that fails, from the reference orbit
    itself and from a few other starts. What is found at a point depends on nothing but its own
    parameters: not on other points, `threads` or `chunk`.

    Parameters
    ----------
    orbit : str or Itinerary, or a system beside an `itinerary`
        ``system/orbit``, or a user's ``FILE.py:ORBIT`` or ``FOLDER:ORBIT``. One whose
        equations have no closed form is composed numerically from its phases. Of a file of
        orbits ``FILE.json:N``, the N-th, counted from 1: its parameters are the defaults. With
        an `itinerary` the name of a system, or a System.
    parameters : mapping of str to number, text, Value or array, optional
        Those of the equations, or the physical ones in their place; absent ones take the
        reference point's values. With an `itinerary` all physical parameters. Nondimensional,
        or in the units of the declaration. Arrays broadcast against each other.
    guess : sequence or mapping of float, or array, optional
        Start of the unknowns, all in their order or some by name. With an `itinerary` the dwell
        times, one for each phase, or these and the state at the start of the first phase;
        without that the state that fits the dwell times best is taken. At many points these
        alone, for all points or, as the last axis of an array, for each; many for one point make
        many orbits.
    itinerary : sequence of (configuration, boundary), or Recurrence, optional
        The phases of an orbit that has no name: cyclic, the last leads back to the first.
        Boundaries that are reached together are ``"a+b"`` or a sequence of names: the first
        one's switching condition is solved, and admissibility asks for the others'. The cycle
        of a motion, as `itinerary_of` gives it, brings its own guess.
    symmetry : mapping of state to text, or array (N, N), optional
        Of an `itinerary`, at one point: a signed permutation of the states that maps motions to
        motions, such as ``{"x": "-x", "v": "-v"}``. The itinerary is then that of the first
        part of the orbit, half of it where the symmetry is its own inverse: the symmetry maps
        the state behind its last transition to the start. The orbit that is returned is the
        whole one.
    unknown, given : names, and mapping of names to values
        Exchange, at one point: the parameters named in `unknown` are solved for, the unknowns
        named in `given` keep their values; as many of one as of the other. An orbit that is
        composed takes none of them, but its ``period`` may be given, with an `itinerary` also
        at many points: it singles out one of a family of orbits, as there is where energy is
        kept.
    digits : int
        True decimal digits of one orbit; above 15 as `refine` gives them.
    throw : bool
        Raise when there is no convergence; otherwise the orbit's `status` says it, as it does
        of each of many points.
    multipliers : bool
        Of an `itinerary` at many points: also give multipliers, and the derivatives of what
        they make up.
    admissibility : bool
        At many points: also decide whether each orbit is a motion of the real system; where
        several are found, one that is comes first. About a millisecond a point for orbits
        without kernels.
    derivatives : sequence of str, or str
        At many points: parameters by which unknowns, period and trace are differentiated,
        exactly up to rounding: `Orbits.derivatives`. With `multipliers` also their product,
        ``determinant``, and ``spectral_radius``, as `Orbit.derivatives` names them.
    threads : int, optional
        At many points; as many as processors when omitted.
    chunk : int, optional
        Of many points, those that one thread takes at a time, of orbits with kernels.

    Returns
    -------
    Orbit or Orbits
        One orbit in double precision, where no parameter is an array and the guess is one: the
        iteration ends when a full Newton step is below ``1e-9 max(1, |x|)``, which leaves an
        error of rounding. Else the orbits of all points.

    Raises
    ------
    InputError
        For wrong names or values, a guess of the wrong length, an exchange that the equations
        do not determine (its condition number is given), an itinerary that the system does not
        allow, or what is no symmetry of it at these parameters; for arrays that do not
        broadcast, or what only one point has, or only many.
    NoConvergence
        If one orbit was not found, and the message says what was tried, or if it cannot be
        refined.

    Examples
    --------
    >>> import numpy as np
    >>> import nonsmooth as ns
    >>> ns.solve("dry-friction/global-stick").stability.verdict
    'stable'
    >>> data = dict(chi="0.5", eta=1, V=1, us1=1, us2=1, ur1="4.0195", ur2="1.4831")
    >>> phases = [
    ...     ("stick-stick", "first-breaks-forward"),
    ...     ("slip-stick", "second-breaks-forward"),
    ...     ("slip-slip", "first-reaches-belt"),
    ...     ("stick-slip", "second-reaches-belt"),
    ... ]
    >>> orbit = ns.solve("dry-friction", data, [1, 2, 1.5, 3.3], itinerary=phases)
    >>> orbit.stability.verdict, orbit.admissibility.verdict
    ('stable', True)
    >>> eta = np.linspace(0.95, 1.05, 5)
    >>> found = ns.solve("dry-friction/global-stick", {"eta": eta}, derivatives="V")
    >>> found.converged.all(), found.trace.shape, found.derivatives["period"]["V"].shape
    (np.True_, (5,), (5,))
    """
    check_digits(digits)
    values, fixed = by_name("parameters", parameters), by_name("given", given)
    several = axes(guess) > 1 or any(map(axes, [*values.values(), *fixed.values()]))
    of_one = {
        "symmetry": symmetry is not None,
        "unknown": bool(one_or_several(unknown)),
        "digits": digits != DOUBLE,
    }
    of_many = {
        "multipliers": multipliers is not False,
        "admissibility": admissibility is not True,
        "derivatives": bool(one_or_several(derivatives)),
        "threads": threads is not None,
        "chunk": chunk is not None,
    }
    if wrong := [name for name, is_asked in (of_one if several else of_many).items() if is_asked]:
        points = "one parameter point" if several else "many parameter points, as arrays give them,"
        raise InputError(f"{' and '.join(wrong)}: of {points} only")
    if several:
        options: Any = {"admissibility": admissibility, "threads": threads}
        many = _solve_many(orbit, values, guess, itinerary, fixed, multipliers, chunk, **options)
        by = one_or_several(derivatives)
        return replace(many, derivatives=derivatives_of_many(many, by, threads)) if by else many
    named, swapped = cast("Any", orbit), one_or_several(unknown)
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


def _solve_many(
    orbit: Any,
    values: dict[str, Any],
    guess: Any,
    itinerary: Itinerary | None,
    given: dict[str, Any],
    multipliers: bool,
    chunk: int | None,
    **options: Any,
) -> Orbits:
    """Return the orbits of an itinerary, or of a name, at many parameter points."""
    counts = {"chunk": CHUNK if chunk is None else chunk, "threads": options["threads"]}
    for name, count in counts.items():
        if count is not None:
            checked_count(name, count, 1)
    if itinerary is not None:
        system, period = kernels_of(orbit), period_in((), given)
        phases, dwell, start = guess_along(system, itinerary, guess)
        options |= {"multipliers": multipliers}
        return solve_itineraries(system, phases, values, dwell, start, period, **options)
    beside = {"guess": guess is not None, "given": bool(given), "multipliers": multipliers}
    if wrong := [name for name, is_given in beside.items() if is_given]:
        raise InputError(f"{' and '.join(wrong)}: of an itinerary only, beside its system")
    known = orbit if isinstance(orbit, OrbitKernels) else load_orbit(orbit)
    if known.derived:
        points: OrbitPoints = KernelPoints(known, worth=True)
    else:  # wrong names and shapes are refused before anything is compiled
        _check(known)
        values = {**known.table["reference"]["parameters"], **values}
        parameter_points(known.system, values)
        points = declared_kernels(known) or points_of(known, ())
    return points.solve(values, chunk=counts["chunk"], **options)
