"""Many parameter points at once, of an itinerary that is named or that is given.

One declared orbit is composed from its system's tables. At many points kernels of its own
equations take their place, where these can be compiled: from the same reference orbit they find
the same, under the same names.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache, cached_property
from numbers import Integral
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, NoConvergence, one_or_several
from nonsmooth.runtime.core.values import by_name
from nonsmooth.runtime.model.kernel_records import SavedTable
from nonsmooth.runtime.model.kernels import (
    OrbitKernels,
    SystemKernels,
    kernels_of,
    kernels_of_many,
    load_orbit,
)
from nonsmooth.runtime.model.loading.declared import DeclaredOrbit, DeclaredSystem
from nonsmooth.runtime.model.parameters import parameter_array, parameter_points
from nonsmooth.runtime.orbits.kernel_many import CHUNK, KernelPoints
from nonsmooth.runtime.orbits.many_derivatives import derivatives_of_many
from nonsmooth.runtime.orbits.orbit import Orbits, changed, reshaped
from nonsmooth.runtime.orbits.solve import Itinerary, guess_along, solve_kernels
from nonsmooth.runtime.orbits.table_many import Arrays, TablePoints, solve_itineraries
from nonsmooth.runtime.orbits.table_solve import period_in, solve_declared

__all__ = [
    "DeclaredPoints",
    "OrbitPoints",
    "Orbits",
    "declared_kernels",
    "points_of",
    "solve_many",
]

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
            parameters={name: parameter_array(name, value) for name, value in values.items()},
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
            with np.errstate(all="ignore"):  # of points without an orbit
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
    guess = {name: repr(float(known.unknowns[name])) for name in own.unknowns}
    reference = {**own.table["reference"], "guess": guess}
    table = SavedTable(own.name, own.address, {**own.table, "reference": reference})
    kernels = replace(own, saved=table)
    found = solve_kernels(kernels, throw=False)
    same = all(
        abs(found.unknowns[name] - value) <= _SAME * max(1, abs(value))
        for name, value in known.unknowns.items()
        if name in own.unknowns
    )
    return DeclaredPoints(orbit, known, kernels) if same else None


OrbitPoints = KernelPoints | TablePoints


@cache
def points_of(
    kernels: OrbitKernels, given: tuple[str, ...], own: DeclaredPoints | None = None
) -> OrbitPoints:
    """Return an orbit at many points, where what is fixed or swept has the names `given`.

    `own` are compiled kernels that stand in for the tables of a composed orbit.
    `InputError` is raised for an orbit that cannot be found at many points at once.
    """
    if kernels.derived:
        return KernelPoints(kernels, given)
    _check(kernels)
    if own is not None:
        return own
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
    chunk: int | None = None,
    derivatives: Sequence[str] | str = (),
) -> Orbits:
    """Find the orbit of an itinerary at many parameter points, as `solve` does of arrays.

    What is found at a point depends on nothing but its own parameters: not on `threads`,
    `chunk` or on other points.
    """
    values = by_name("parameters", parameters)
    options: Any = {"admissibility": admissibility, "threads": threads}
    chunk = CHUNK if chunk is None else chunk
    _check_positive("chunk", chunk)
    if threads is not None:
        _check_positive("threads", threads)
    system_or_orbit: Any = orbit
    if itinerary is not None:
        system, period = kernels_of(system_or_orbit), period_in((), by_name("given", given))
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
        points, values = _named_points(known, values)
        found = points.solve(values, chunk=chunk, **options)
    if not (by := one_or_several(derivatives)):
        return found
    return replace(found, derivatives=derivatives_of_many(found, by, threads))


def _named_points(
    known: OrbitKernels, values: dict[str, Any]
) -> tuple[OrbitPoints, dict[str, Any]]:
    """Return what solves for a named orbit at many points, and the values that it takes.

    Wrong names and shapes are refused before anything is compiled.
    """
    if known.derived:
        return KernelPoints(known, worth=True), values
    _check(known)
    values = {**known.table["reference"]["parameters"], **values}
    parameter_points(known.system, values)
    return points_of(known, (), declared_kernels(known)), values


def _check_positive(name: str, number: object) -> None:
    if isinstance(number, bool) or not isinstance(number, Integral) or int(number) < 1:
        raise InputError(f"{name} = {number} is not a positive integer")
