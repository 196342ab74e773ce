"""The periodic orbits that live in a system: attractors by simulation, others by Newton.

Random starts are followed until their transients are gone; the itineraries that recur are
solved as periodic orbits, and motions that reach no boundary any more are read off their
flows. Unstable orbits are not reached that way: cycles after which a motion nearly came back,
and short cycles of the transitions that were seen, are tried too.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import chain, islice, permutations, product
from typing import Any, Generic, TypeVar

import numpy as np

from nonsmooth.runtime.core.errors import InputError, Interrupted, one_line, unknown_name
from nonsmooth.runtime.core.registry import Kept, registered
from nonsmooth.runtime.core.values import Value, by_name, random_generator
from nonsmooth.runtime.core.workload import check_memory
from nonsmooth.runtime.explore.finding.outcomes import (
    Attractors,
    Outcome,
    attractors_of,
    numbers_of,
)
from nonsmooth.runtime.explore.finding.solved import (
    Equilibrium,
    add_orbit,
    canonical_itinerary,
    converging,
    image_of,
    in_a_family,
    primitive_orbit,
    same_orbit,
    same_state,
)
from nonsmooth.runtime.model.kernels import SystemKernels, grown, kernels_of
from nonsmooth.runtime.model.loading.declared import DeclaredSystem
from nonsmooth.runtime.model.piecewise import PiecewiseLinear, piecewise
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.shooting.symmetry import Symmetry, symmetry_of
from nonsmooth.runtime.shooting.translations import translations_of, up_to_shift
from nonsmooth.runtime.simulation.engines import Trajectories, entry_size
from nonsmooth.runtime.simulation.recurrence import (
    Candidate,
    Itinerary,
    candidate_at,
    near_returns,
    phase_name,
    recurrent_lengths,
    scales_of,
)
from nonsmooth.runtime.simulation.simulate import checked_count, simulate_many
from nonsmooth.runtime.simulation.starting import on_circles

Solved = TypeVar("Solved", Orbit, Equilibrium)
Phase = tuple[str, str]
_TOLERANCES = (1e-10, 1e-7, 1e-4, 1e-2)  # of a return: the tightest that finds one decides
_EXACT = 1e-7  # of a return: of a motion that has settled
_KEPT = 129  # entries: cycles of at most 64 phases
_NEAR, _LONGEST = 0.3, 12  # a near return, and the longest cycle that is tried for one
_MOST_COORDINATES = 3  # of which all permutations are tried; of more, one sign of all
_LONGEST_CYCLE = 6
_MOST = 200


@dataclass(frozen=True, eq=False)
class _Entry(Generic[Solved]):
    """What was found, or why a file's entry is none, with how many starts led to it."""

    solved: Solved | str
    starts: int
    share: float
    mirror: int | None = None

    def _known(self) -> Solved:
        """What was found; raises `InputError` with the reason if it is refused."""
        if isinstance(self.solved, str):
            raise InputError(self.solved)
        return self.solved


@dataclass(frozen=True, eq=False)
class FoundOrbit(_Entry[Orbit]):
    """A periodic orbit and how many of the starts led to it.

    Attributes
    ----------
    solved : Orbit or str
        Over its primitive period; of one phase that ends with ``forcing-phase`` where it
        reaches no boundary. Or why an entry of a file is no orbit of its system.
    starts : int
    share : float
        Of all starts; 0 for an orbit that no start led to.
    mirror : int or None
        Place of the orbit before it whose mirror image it is; its own where it is its own.
    """

    @property
    def orbit(self) -> Orbit:
        """The orbit.

        Raises
        ------
        InputError
            Where a file holds what is no orbit of its system; so does all that is told of it.
        """
        return self._known()

    @property
    def itinerary(self) -> tuple[tuple[str, str], ...]:
        """Phases: configuration, and boundary by which it is left."""
        return self.orbit.itinerary

    @property
    def period(self) -> float:
        """Sum of the dwell times."""
        return float(self.orbit.period)

    @property
    def forcing_periods(self) -> tuple[int, ...]:
        """How many periods of each forcing it lasts; none without a forcing."""
        turns = self.period * np.abs(self.orbit.tables.piecewise.forcing_speeds) / (2 * np.pi)
        return tuple(round(float(count)) for count in turns)

    @property
    def verdict(self) -> str:
        """Stable, unstable, neutral or undecided."""
        return str(self.orbit.stability.verdict)


@dataclass(frozen=True, eq=False)
class FoundEquilibrium(_Entry[Equilibrium]):
    """An equilibrium and how many of the starts led to it.

    Attributes
    ----------
    solved : Equilibrium or str
        Or why an entry of a file is no equilibrium of its system.
    starts : int
    share : float
    mirror : int or None
        Place of the equilibrium before it whose mirror image it is, or its own.
    """

    @property
    def equilibrium(self) -> Equilibrium:
        """The equilibrium.

        Raises
        ------
        InputError
            Where a file holds what is no equilibrium of its system.
        """
        return self._known()


@dataclass(frozen=True, eq=False, repr=False)
class Found(Kept):
    """What was found to live in a system, with the largest basins first.

    Attributes
    ----------
    system : str
    parameters : dict of str to Value
    names : tuple of str
        Of the states.
    orbits : tuple of FoundOrbit
    equilibria : tuple of FoundEquilibrium
    starts : array (n, N)
    labels : array (n,) of int
        Where each start led: the place of an orbit, then of an equilibrium, or an `Outcome`.
    box : array (N, 2)
        From where the starts were drawn.
    transitions : int
        How many each start was followed.
    complete : bool
        Whether the search was not interrupted.
    """

    _kept_by = "save_found"

    system: str
    parameters: dict[str, Value]
    names: tuple[str, ...]
    orbits: tuple[FoundOrbit, ...]
    equilibria: tuple[FoundEquilibrium, ...]
    starts: np.ndarray
    labels: np.ndarray
    box: np.ndarray
    transitions: int
    complete: bool = True

    def plot(self, kind: str = "all", *, periods: int = 1) -> Any:
        """Draw the found orbits with the largest basins, a row for each.

        Parameters
        ----------
        kind : {"all", "time", "velocity", "phase"}
            Histories of positions or of velocities, portraits of all masses in one, or portraits
            beside positions.
        periods : int
            How many of them a history has.

        Returns
        -------
        matplotlib Figure

        Raises
        ------
        InputError
            For another kind, or if no orbit was found.
        """
        return registered("found_figure")(self, kind, periods=periods)

    def share(self, outcome: Outcome) -> float:
        """Give the share of the starts that end in one way.

        Parameters
        ----------
        outcome : Outcome
            One of `outcomes`.

        Returns
        -------
        float
            Between 0 and 1.

        Raises
        ------
        InputError
            For several outcomes.
        """
        if np.ndim(outcome):
            raise InputError(f"{one_line(repr(outcome), 60)} is no outcome of one start")
        return float(np.mean(self.labels == outcome)) if self.labels.size else 0.0

    @property
    def outcomes(self) -> dict[Outcome, float]:
        """Shares of the starts that lead to nothing that is listed, by how they end."""
        return {outcome: share for outcome in Outcome if (share := self.share(outcome))}

    @property
    def unclassified(self) -> float:
        """Share of the starts whose motion was not recognised."""
        return self.share(Outcome.UNCLASSIFIED)

    @property
    def resting(self) -> float:
        """Share of the starts that came to rest, at any of the places where that is possible."""
        return self.share(Outcome.RESTING)


def label_names(found: Found) -> dict[int, str]:
    """Texts of the labels for pictures: all orbits and equilibria, and the outcomes."""
    count = len(found.orbits)
    names = {
        i: f"orbit {i + 1}, period {entry.period:.6g}{_apart(i, found.orbits)}"
        for i, entry in enumerate(found.orbits)
    }
    for i, steady in enumerate(found.equilibria, count):
        names[i] = f"equilibrium {i + 1}, {steady.equilibrium.configuration}"
    return {**names, **{int(outcome): outcome.text for outcome in Outcome}}


def _apart(place: int, orbits: Sequence[FoundOrbit]) -> str:
    """Text that distinguishes an orbit from others of its period: mirror image, or start."""
    entry = orbits[place]
    alike = [o.orbit for o in orbits if f"{o.period:.6g}" == f"{entry.period:.6g}"]
    if len(alike) == 1:
        return ""
    if entry.mirror not in (None, place):
        return f", mirror image of {entry.mirror + 1}"
    starts = np.array([orbit.states[0].astype(float) for orbit in alike])
    state = int(np.ptp(starts, axis=0).argmax())
    name = entry.orbit.tables.cycle.structure.states[state]
    return f", from {name} = {float(entry.orbit.states[0, state]):.4g}"


def find_orbits(
    system: str | SystemKernels | DeclaredSystem,
    parameters: Mapping[str, object],
    n: int = 400,
    *,
    transitions: int = 2000,
    box: Mapping[str, tuple[float, float]] | None = None,
    rng: int | np.random.SeedSequence | np.random.Generator | None = 0,
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
    rng : int, SeedSequence, Generator or None
        Of NumPy: equal seeds give equal starts, None others each time.
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
    random = random_generator(rng)
    values, directions = numbers_of([point]), translations_of(point)

    def follow(starts: np.ndarray, number: int, keep: int) -> Trajectories:
        motions = simulate_many(
            kernels, values, starts, transitions=number, keep=keep, threads=threads
        )
        return replace(motions, last_states=up_to_shift(motions.last_states, directions))

    progress(f"following {count} starts")
    starts, motions = _legal_starts(follow, point, limits, count, random, length)
    if motions.structure is not point.structure:
        kernels = grown(kernels)
        point = piecewise(kernels, parameters)
    attractors = attractors_of(point, ())
    labels = np.full(len(starts), int(Outcome.UNCLASSIFIED))
    orbits: list[Orbit] = []
    symmetries: Sequence[Symmetry] = ()

    def found(*, complete: bool) -> Found:
        entries, steady, told = _in_order(attractors, orbits, symmetries, labels)
        names, values = point.structure.states, point.parameters
        return Found(
            kernels.name, values, names, entries, steady, starts, told, limits, length, complete
        )

    try:
        symmetries = _mirrors(point)
        progress("solving the motions that recur")
        recurrent = _recurrent(motions, scales_of(point, motions))
        attracting: list[Orbit] = []
        _solve(point, [c for c, _ in recurrent.values()], symmetries, attracting)
        attracting = [
            o
            for o in attracting
            if len(o.itinerary) <= _LONGEST or o.stability.verdict != "unstable"
        ]
        attractors = attractors_of(point, attracting)
        orbits = list(attractors.orbits)
        labels = attractors.labels(motions)
        for place, (candidate, miss) in recurrent.items():
            exact = labels[place] == Outcome.UNCLASSIFIED and miss <= _EXACT
            if exact and in_a_family(point, candidate):
                labels[place] = Outcome.FAMILY
        labels = attractors.measured(motions, labels, threads)

        progress("looking for unstable orbits")
        early = follow(starts[: min(count, 200)], _KEPT, _KEPT)
        _solve(point, _tried(point, motions, early), symmetries, orbits)
    except KeyboardInterrupt:
        raise Interrupted(found(complete=False)) from None
    return found(complete=True)


def _solve(
    point: PiecewiseLinear,
    candidates: Iterable[Candidate],
    symmetries: Sequence[Symmetry],
    orbits: list[Orbit],
) -> None:
    """Add the orbits near candidates, and their images under the system's symmetries."""
    for candidate in converging(point, candidates):
        if any(same_orbit(known, candidate) for known in orbits):
            continue
        orbit = primitive_orbit(point, candidate)
        if orbit is None:
            continue
        add_orbit(orbits, orbit)
        for symmetry in symmetries:
            image = primitive_orbit(point, image_of(orbit, symmetry))
            if image is not None:
                add_orbit(orbits, image)


def _in_order(
    attractors: Attractors,
    orbits: Sequence[Orbit],
    symmetries: Sequence[Symmetry],
    labels: np.ndarray,
) -> tuple[tuple[FoundOrbit, ...], tuple[FoundEquilibrium, ...], np.ndarray]:
    """Orbits and equilibria by the number of starts, then by the period, and labels (n,) of these.

    Given labels count the orbits that attract, which come first, then the equilibria.
    """
    attracting, steady = len(attractors.orbits), attractors.equilibria
    unstable = len(orbits) - attracting  # no start leads to them, and no label is theirs
    counts = [int((labels == i).sum()) for i in range(attracting + len(steady))]
    counts[attracting:attracting] = [0] * unstable
    solved: list[Any] = [*orbits, *steady]
    order = sorted(range(len(orbits)), key=lambda i: (-counts[i], float(orbits[i].period)))
    order += sorted(range(len(orbits), len(solved)), key=lambda i: -counts[i])

    def is_image(one: Any, other: Any, symmetry: Symmetry) -> bool:
        if isinstance(one, Orbit):
            return same_orbit(one, image_of(other, symmetry))
        return same_state(one.state, symmetry.matrix @ other.state)

    def entries(kind: Any, places: list[int]) -> Any:
        found: list[Any] = []
        for i in places:
            # the first one whose mirror image it is, perhaps itself
            mirrors = (
                place
                for place, other in enumerate([*(each.solved for each in found), solved[i]])
                if any(is_image(solved[i], other, symmetry) for symmetry in symmetries)
            )
            found.append(kind(solved[i], counts[i], counts[i] / len(labels), next(mirrors, None)))
        return tuple(found)

    places = {old: new for new, old in enumerate(order)}
    told = [places.get(i + unstable * (i >= attracting), i) for i in labels.tolist()]
    return (
        entries(FoundOrbit, order[: len(orbits)]),
        entries(FoundEquilibrium, order[len(orbits) :]),
        np.array(told, dtype=int),
    )


def _legal_starts(
    follow: Callable[[np.ndarray, int, int], Trajectories],
    point: PiecewiseLinear,
    limits: np.ndarray,
    count: int,
    random: np.random.Generator,
    transitions: int,
) -> tuple[np.ndarray, Trajectories]:
    """Random starts that belong to a configuration, and their motions."""
    legal = np.empty((0, len(limits)))
    for _ in range(20):
        drawn = random.uniform(limits[:, 0], limits[:, 1], (count, len(limits)))
        if point.structure.forcing:
            drawn = on_circles(point, drawn, random.uniform(0, 2 * np.pi, count))
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
    point: PiecewiseLinear, motions: Trajectories, early: Trajectories
) -> Iterator[Candidate]:
    """Guesses of orbits on which no transient ends."""
    for each in (early, motions):
        yield from near_returns(each, scales_of(point, each), _LONGEST, _NEAR)
    yield from _short_cycles(point, early)


def _mirrors(system: PiecewiseLinear) -> list[Symmetry]:
    """Symmetries that map positions to positions and velocities likewise, without the identity.

    A forcing stays, or is turned by half a period.
    """
    found = []
    for matrix in _candidates(system):
        # a symmetry takes some vector field to each of the others: that is soon told
        if not _follows(system, matrix):
            continue
        try:
            found.append(symmetry_of(system, matrix))
        except InputError:
            continue
    return found


def _candidates(system: PiecewiseLinear) -> Iterator[np.ndarray]:
    structure = system.structure
    size, coordinates = len(structure.states), structure.coordinates
    paired = {state for pair in (*coordinates, *structure.forcing) for state in pair}
    others = [state for state in range(size) if state not in paired]
    count = len(coordinates)
    if count <= _MOST_COORDINATES:
        orders, signs = list(permutations(range(count))), list(product((1, -1), repeat=count))
    else:
        orders, signs = [tuple(range(count))], [(1,) * count, (-1,) * count]
    forcings, rests = product((1, -1), repeat=len(structure.forcing)), (1, -1)[: 1 + bool(others)]
    for order, sign, forcing, rest in product(orders, signs, forcings, rests):
        matrix = np.zeros((size, size), dtype=int)
        for image, source, s in zip(coordinates, order, sign, strict=True):
            matrix[list(image), list(coordinates[source])] = s
        for pair, s in zip(structure.forcing, forcing, strict=True):
            matrix[pair, pair] = s
        matrix[others, others] = rest
        if (matrix != np.eye(size, dtype=int)).any():
            yield matrix


def _follows(system: PiecewiseLinear, matrix: np.ndarray) -> bool:
    """Whether the image of the first vector field is one of the system's."""
    field = system.fields[0]
    image = np.concatenate([matrix @ field[:, :-1] @ matrix.T, matrix @ field[:, -1:]], axis=1)
    size = np.abs(system.fields).max()
    return bool((np.abs(system.fields - image).max(axis=(1, 2)) <= 1e-9 * size).any())


def _short_cycles(point: PiecewiseLinear, motions: Trajectories) -> Iterator[Candidate]:
    """Guesses from cycles of phases that follow each other, and from the system's known orbits.

    Dwell times are medians of those that were seen; the start is the mean of the states at
    which the first phase was entered. Shorter cycles come first.
    """
    follows: dict[Phase, set[Phase]] = defaultdict(set)
    durations, starts = defaultdict(list), defaultdict(list)
    for motion in range(len(motions.times)):
        entered = motions.last_configurations[motion, :-1].tolist()
        left = motions.last_sets[motion, 1:].tolist()
        names = [phase_name(motions.structure, *each) for each in zip(entered, left, strict=True)]
        waits, previous = np.diff(motions.last_times[motion]).tolist(), None
        for place, name in enumerate(names):
            if name is not None:
                durations[name].append(waits[place])
                starts[name].append(motions.last_states[motion, place])
                if previous is not None:
                    follows[previous].add(name)
            previous = name
    tried: set[Itinerary] = set()

    def guess(itinerary: Itinerary) -> Candidate | None:
        itinerary = canonical_itinerary(itinerary)
        if itinerary in tried or not all(phase in durations for phase in itinerary):
            return None
        tried.add(itinerary)
        dwell = np.array([np.median(durations[phase]) for phase in itinerary])
        return Candidate(itinerary, dwell, np.mean(starts[itinerary[0]], axis=0), np.inf)

    declared = (table["phases"] for table in point.kernels.module.ORBITS.values())
    known = (tuple((configuration, name) for configuration, name, _ in each) for each in declared)
    yield from filter(None, map(guess, chain(known, islice(_cycles(follows), _MOST))))


def _cycles(follows: Mapping[Phase, set[Phase]]) -> Iterator[Itinerary]:
    """Cycles without a repeated phase, the shorter ones first."""
    for length in range(2, _LONGEST_CYCLE + 1):
        for first in sorted(follows):
            paths: list[Itinerary] = [(first,)]
            for _ in range(length - 1):
                paths = [
                    (*path, phase)
                    for path in paths
                    for phase in sorted(follows.get(path[-1], ()))
                    if phase > first and phase not in path
                ]
            yield from (path for path in paths if first in follows.get(path[-1], ()))


def start_box(
    system: PiecewiseLinear, given: Mapping[str, tuple[float, float]] | None = None
) -> np.ndarray:
    """Bounds (N, 2) between which starts are drawn, the same in all units.

    For each state they are twice the largest size at which a boundary or a constraint lies, on
    both sides. For a state without one, they are twice the size at which the equations of
    motion balance it with the others, the loads and the forcings, at the rate of the system.
    `given` replaces the bounds of some states; unknown names and empty intervals are refused.
    """
    structure = system.structure
    rows = system.rows[list(structure.watched)]
    with np.errstate(divide="ignore", invalid="ignore"):
        sizes = np.abs(rows[:, -1:] / rows[:, :-1])
    sizes[~np.isfinite(sizes)] = 0.0
    largest = sizes.max(axis=0, initial=0.0)
    forced = list(structure.forced)
    largest[forced] = 1.0
    largest = _balanced(np.abs(system.fields), largest)
    limits = np.stack([-2 * largest, 2 * largest], axis=1)
    limits[forced] = -1.0, 1.0  # of starts on a circle
    for name, bounds in by_name("box", given).items():
        if name not in structure.states:
            raise unknown_name("state", str(name), structure.states)
        try:
            low, high = map(float, bounds)
        except (TypeError, ValueError):
            raise InputError(f"box of {name}: {bounds!r} is no pair of numbers") from None
        if not (np.isfinite([low, high]).all() and low < high):
            raise InputError(f"box of {name}: {low!r} to {high!r} is no interval")
        limits[structure.states.index(name)] = low, high
    return limits


def _balanced(fields: np.ndarray, known: np.ndarray) -> np.ndarray:
    """Sizes (N,) of states: the known ones, and sizes that balance these for states of size 0.

    In a time 1 / rate a state moves by no less than its own size under those that are known,
    and moves those by no less than theirs. Fields (configurations, N, N + 1) are absolute.
    """
    couplings = fields.max(axis=0)
    sizes = np.append(known, 1.0)  # the last one is the constant's
    rate = _rate(fields, sizes)
    coupled = couplings[:, :-1] > 0
    while rate > 0:
        moving = np.zeros(coupled.shape)
        with np.errstate(over="ignore", invalid="ignore"):
            moved = couplings @ sizes / rate
            np.divide(rate * sizes[:-1, None], couplings[:, :-1], out=moving, where=coupled)
            found = np.maximum(moved, moving.max(axis=0))
        found[(sizes[:-1] > 0) | ~np.isfinite(found)] = 0.0
        if not found.any():
            break
        sizes[:-1] += found
    return np.where(sizes[:-1] > 0, sizes[:-1], 1.0)


def _rate(fields: np.ndarray, sizes: np.ndarray) -> float:
    """The geometric mean over the configurations of the rate of the fastest motion in each.

    That is an eigenvalue, or the fall under a load through the size of a state.
    """
    rates = []
    for field in fields:
        with np.errstate(over="ignore", invalid="ignore"):
            fall = field[:, :-1] @ field[:, -1] / np.where(sizes[:-1] > 0, sizes[:-1], np.inf)
        around = np.abs(np.linalg.eigvals(field[:, :-1])).max()
        rates.append(max(float(around), float(fall.max()) ** 0.5))
    moving = [rate for rate in rates if 0 < rate < np.inf]
    return float(np.exp(np.mean(np.log(moving)))) if moving else 0.0
