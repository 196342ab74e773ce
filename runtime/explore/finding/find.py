"""The periodic orbits that live in a system: attractors by simulation, others by Newton.

Random starts are followed until their transients are gone; the itineraries that recur are
solved as periodic orbits, and motions that reach no boundary any more are read off their
flows. Unstable orbits are not reached that way: cycles after which a motion nearly came back,
and short cycles of the transitions that were seen, are tried too.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from nonsmooth.runtime.core.errors import InputError, Interrupted
from nonsmooth.runtime.core.workload import check_memory
from nonsmooth.runtime.explore.finding.found import Found, FoundEquilibrium, FoundOrbit
from nonsmooth.runtime.explore.finding.mirrors import mirror_places, mirrors
from nonsmooth.runtime.explore.finding.neighbours import short_cycles
from nonsmooth.runtime.explore.finding.outcomes import Attractors, Outcome, attractors_of
from nonsmooth.runtime.explore.finding.primitive import (
    add_orbit,
    converging,
    image_of,
    in_a_family,
    primitive_orbit,
    same_orbit,
)
from nonsmooth.runtime.explore.finding.start_box import start_box
from nonsmooth.runtime.model.kernels import SystemKernels, grown, kernels_of
from nonsmooth.runtime.model.loading.declared import DeclaredSystem
from nonsmooth.runtime.model.piecewise import PiecewiseLinear, piecewise
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.shooting.symmetry import Symmetry
from nonsmooth.runtime.shooting.translations import translations_of, up_to_shift
from nonsmooth.runtime.simulation.engines import entry_size
from nonsmooth.runtime.simulation.recurrence import (
    Candidate,
    candidate_at,
    near_returns,
    recurrent_lengths,
    scales_of,
)
from nonsmooth.runtime.simulation.simulate import Trajectories, checked_count, simulate_many
from nonsmooth.runtime.simulation.starting import on_circles

__all__ = ["find_orbits"]

_TOLERANCES = (1e-10, 1e-7, 1e-4, 1e-2)  # of a return: the tightest that finds one decides
_EXACT = 1e-7  # of a return: of a motion that has settled
_KEPT = 129  # entries: cycles of at most 64 phases
_NEAR, _LONGEST = 0.3, 12  # a near return, and the longest cycle that is tried for one


def find_orbits(
    system: str | SystemKernels | DeclaredSystem,
    parameters: Mapping[str, object],
    n: int = 400,
    *,
    transitions: int = 2000,
    box: Mapping[str, tuple[float, float]] | None = None,
    seed: int = 0,
    threads: int | None = None,
    progress: Callable[[str], None] = lambda step: None,
) -> Found:
    """Find periodic orbits, stable and unstable, with their basins.

    Parameters
    ----------
    system : str, System or SystemKernels
    parameters : mapping of str to str, number or Value
        All physical parameters.
    n : int
        Random starts.
    transitions : int
        After which transients count as gone.
    box : mapping of state to (lower, upper), optional
        Where the starts are drawn; states that are not named take what `start_box` gives.
    seed : int
        Equal seeds give equal starts.
    threads : int, optional
    progress : callable
        Told the name of each step when it begins.

    Returns
    -------
    Found
        The orbits, each with its itinerary, and the shares of the starts that end in them.

    Raises
    ------
    InputError
        For wrong names, values or counts.
    Interrupted
        By Ctrl-C, when the starts are followed; its `partial` is what was found until then.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> data = dict(chi="0.5", eta=1, V=1, us1=1, us2=1, ur1="4.0195", ur2="1.4831")
    >>> found = ns.find_orbits("dry-friction", data, n=20, transitions=200)
    >>> [found_orbit.orbit.stability.verdict for found_orbit in found.orbits]
    ['stable']
    """
    kernels = kernels_of(system)
    point = piecewise(kernels, parameters)
    count = checked_count("n", n, 1)
    length = checked_count("transitions", transitions, 2)
    limits = start_box(point, box)
    check_memory(f"{count} starts", count * _KEPT * entry_size(len(limits)))
    checked_count("seed", seed, 0)
    values = {name: float(value) for name, value in point.parameters.items()}

    directions = translations_of(point)

    def follow(starts: np.ndarray, number: int, keep: int) -> Trajectories:
        motions = simulate_many(
            kernels, values, starts, transitions=number, keep=keep, threads=threads
        )
        return replace(motions, last_states=up_to_shift(motions.last_states, directions))

    progress(f"following {count} starts")
    starts, motions = _legal_starts(follow, point, limits, count, seed, length)
    if motions.structure is not point.structure:
        kernels = grown(kernels)
        point = piecewise(kernels, parameters)
    attractors = attractors_of(kernels, point, ())
    labels = np.full(len(starts), int(Outcome.UNCLASSIFIED))
    orbits: list[Orbit] = []
    symmetries: Sequence[Symmetry] = ()

    def found(*, complete: bool) -> Found:
        return _found(
            point, attractors, orbits, symmetries, starts, labels, limits, length, complete=complete
        )

    try:
        scales = scales_of(point, motions)
        symmetries = mirrors(point)
        progress("solving the motions that recur")
        recurrent = _recurrent(motions, scales)
        attracting: list[Orbit] = []
        _solve(kernels, point, [c for c, _ in recurrent.values()], symmetries, attracting)
        attracting = [
            o
            for o in attracting
            if len(o.itinerary) <= _LONGEST or o.stability.verdict != "unstable"
        ]
        attractors = attractors_of(kernels, point, attracting)
        orbits = list(attractors.orbits)
        labels = attractors.labels(motions)
        for place, (candidate, miss) in recurrent.items():
            exact = labels[place] == Outcome.UNCLASSIFIED and miss <= _EXACT
            if exact and in_a_family(kernels, point, candidate):
                labels[place] = Outcome.FAMILY
        labels = attractors.measured(motions, labels, threads)

        progress("looking for unstable orbits")
        early = follow(starts[: min(count, 200)], _KEPT, _KEPT)
        tried = _tried(kernels, motions, scales, early, scales_of(point, early))
        _solve(kernels, point, tried, symmetries, orbits)
    except KeyboardInterrupt:
        raise Interrupted(found(complete=False)) from None
    return found(complete=True)


def _solve(
    kernels: SystemKernels,
    point: PiecewiseLinear,
    candidates: Iterable[Candidate],
    symmetries: Sequence[Symmetry],
    orbits: list[Orbit],
) -> None:
    """Add the orbits near candidates, and their images under the system's symmetries."""
    for candidate in converging(kernels, point, candidates):
        if any(same_orbit(known, candidate) for known in orbits):
            continue
        orbit = primitive_orbit(kernels, point, candidate)
        if orbit is None:
            continue
        add_orbit(orbits, orbit)
        for symmetry in symmetries:
            image = primitive_orbit(kernels, point, image_of(orbit, symmetry))
            if image is not None:
                add_orbit(orbits, image)


def _found(
    point: PiecewiseLinear,
    attractors: Attractors,
    orbits: Sequence[Orbit],
    symmetries: Sequence[Symmetry],
    starts: np.ndarray,
    labels: np.ndarray,
    limits: np.ndarray,
    transitions: int,
    *,
    complete: bool,
) -> Found:
    """The result of a search in order: by the number of starts, then by the period.

    Labels count the orbits that attract, which come first, then the equilibria.
    """
    attracting, steady = len(attractors.orbits), attractors.equilibria
    totals = [int((labels == i).sum()) for i in range(attracting + len(steady))]
    of_orbits = totals[:attracting] + [0] * (len(orbits) - attracting)
    of_steady = totals[attracting:]
    order = sorted(range(len(orbits)), key=lambda i: (-of_orbits[i], float(orbits[i].period)))
    steady_order = sorted(range(len(steady)), key=lambda i: -of_steady[i])
    places = {old: new for new, old in enumerate(order) if old < attracting}
    places |= {attracting + old: len(order) + new for new, old in enumerate(steady_order)}
    sorted_orbits = [orbits[i] for i in order]
    sorted_steady = [steady[i] for i in steady_order]
    return Found(
        attractors.kernels.name,
        point.parameters,
        point.structure.states,
        tuple(
            FoundOrbit(orbit, of_orbits[i], of_orbits[i] / len(starts), mirror)
            for i, orbit, mirror in zip(
                order, sorted_orbits, mirror_places(sorted_orbits, symmetries), strict=True
            )
        ),
        tuple(
            FoundEquilibrium(equilibrium, of_steady[i], of_steady[i] / len(starts), mirror)
            for i, equilibrium, mirror in zip(
                steady_order, sorted_steady, mirror_places(sorted_steady, symmetries), strict=True
            )
        ),
        starts,
        np.array([places.get(label, label) for label in labels.tolist()], dtype=int),
        limits,
        transitions,
        complete,
    )


def _legal_starts(
    follow: Callable[[np.ndarray, int, int], Trajectories],
    point: PiecewiseLinear,
    limits: np.ndarray,
    count: int,
    seed: int,
    transitions: int,
) -> tuple[np.ndarray, Trajectories]:
    """Random starts that belong to a configuration, and their motions."""
    rng = np.random.default_rng(seed)
    legal = np.empty((0, len(limits)))
    for _ in range(20):
        drawn = rng.uniform(limits[:, 0], limits[:, 1], (count, len(limits)))
        if point.structure.forcing:
            drawn = on_circles(point, drawn, rng.uniform(0, 2 * np.pi, count))
        legal = np.concatenate([legal, drawn[follow(drawn, 1, 0).status >= 0]])
        if len(legal) >= count:
            break
    if not len(legal):
        raise InputError("no start in the box belongs to a configuration: give another box")
    starts = legal[:count]
    return starts, follow(starts, transitions, _KEPT)


def _recurrent(motions: Trajectories, scales: np.ndarray) -> dict[int, tuple[Candidate, float]]:
    """The cycle that each motion repeats at its end, with the tolerance within which it does.

    Cycles that recur most exactly come first.
    """
    lengths = np.zeros(len(motions.times), dtype=int)
    within = np.full(len(lengths), np.inf)
    for tolerance in _TOLERANCES:
        found = np.where(lengths > 0, 0, recurrent_lengths(motions, scales, tolerance))
        lengths, within = lengths + found, np.where(found > 0, tolerance, within)
    last = motions.last_times.shape[1] - 1
    candidates = {}
    for motion in np.flatnonzero(lengths).tolist():
        cycle = candidate_at(motions, motion, last, int(lengths[motion]), scales[motion])
        if cycle is not None:
            candidates[motion] = cycle, float(within[motion])
    return dict(sorted(candidates.items(), key=lambda entry: entry[1][0].miss))


def _tried(
    kernels: SystemKernels,
    motions: Trajectories,
    scales: np.ndarray,
    early: Trajectories,
    early_scales: np.ndarray,
) -> Iterator[Candidate]:
    """Guesses of orbits on which no transient ends."""
    yield from near_returns(early, early_scales, _LONGEST, _NEAR)
    yield from near_returns(motions, scales, _LONGEST, _NEAR)
    yield from short_cycles(kernels, early)
