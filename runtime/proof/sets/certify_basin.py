"""Certify part of a basin: starts from which every motion tends to one periodic orbit.

Around a periodic point the map of a section may contract a set. Where P^k maps C = {c + A x, |x_i|
<= 1} into its interior, and the row sums of |A^-1 DP^k A| are below 1 all over C, P^k has one fixed
point in C and all of C tends to it (S. Banach, 1922): the orbit through it attracts the motion from
every state of C. Sets are looked for in double precision; the checker proves which of them is
contracted.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import closing
from dataclasses import replace
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.checker.state_sets.basin import AttractedTiles, attracted_boxes, contraction
from nonsmooth.runtime.checker.stated.exact import Entries
from nonsmooth.runtime.core.box_grid import BoxGrid
from nonsmooth.runtime.core.errors import InputError, check_integer
from nonsmooth.runtime.core.float_sets import Floats
from nonsmooth.runtime.core.json_codec import stated
from nonsmooth.runtime.core.parallel import check_workers, in_processes
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.explore.finding.find import start_box
from nonsmooth.runtime.orbits.orbit import Orbit, check_converged
from nonsmooth.runtime.proof.asking import REFUSED, Progress, Steps, proved_by_steps
from nonsmooth.runtime.proof.chaos.h_sets import HSet, decimal_set, grid_in_cube
from nonsmooth.runtime.proof.sets.basin_certificate import BasinCertificate
from nonsmooth.runtime.proof.sets.graph_certificate import Flags, Numbers
from nonsmooth.runtime.proof.sets.section_choice import (
    FloatSection,
    MetSection,
    check_one_forcing,
    section_of,
)
from nonsmooth.runtime.proof.sets.sections import (
    Way,
    check_same_section,
    listed_declaration,
    named_way,
    refused_as_input,
    stated_section,
)
from nonsmooth.runtime.proof.statement import ExactSystem, exact_system

_LARGEST, _SMALLEST = 2, 24  # powers of 1/2: sizes of sets that are tried, of the scale
_POWERS = (1, 2, 4, 8)
_UP = 2**20
_NEAR = 1e-6  # of the scale: fixed points that are farther apart are those of two orbits
_SKEW = 1e6  # condition of a frame, at most
_STEPS = 4  # of Newton's method for the fixed point
_SAMPLES = 441  # of a set


class AttractingCore(NamedTuple):
    """A set that a power of the section's map is proved to contract."""

    h_set: HSet
    iterates: int  # the power of the map
    way: tuple[Way, ...]
    contraction: Fraction  # factor of the contraction, below 1


class Undecided(Exception):
    """No set is proved, for a reason."""


def attracting_core(
    floats: FloatSection,
    iterates: int,
    point: Floats,
    scale: float,
    judge: Callable[[AttractingCore], Any],
) -> AttractingCore:
    """The largest set tried around a periodic point that is proved to be contracted.

    `iterates` is the number of returns in one period of the orbit, `point` (d,) the approximate
    place where it meets the section. Sets much larger than `scale`, a length in the section's
    coordinates, are not tried. `judge` gives a ball above the factor by which a set is contracted,
    or raises `Failure`. `Undecided` with the reason if no set is proved.
    """
    trouble = Undecided("no set around the orbit was tried")
    for power in (iterates * n for n in _POWERS):
        try:
            centre, slope = _about(floats, power, point, scale)
        except Undecided as reason:
            trouble = reason
            continue
        if np.abs(centre - point).max() > _NEAR * scale:
            raise Undecided("another orbit is there, and not this one")
        frame = _frame(slope)
        turned = np.linalg.inv(frame) @ slope @ frame
        if np.abs(turned).sum(axis=1).max() >= 1:
            trouble = Undecided("the map does not contract about the orbit")
            continue
        way = tuple(floats.way(centre, power))
        for size in range(_LARGEST, _SMALLEST):
            h_set = decimal_set("core", centre.tolist(), frame * scale * 2.0**-size)
            if not _promising(floats, power, h_set):
                trouble = Undecided("a set around the orbit is not contracted")
                continue
            core = AttractingCore(h_set, power, way, Fraction(1))
            try:
                found = _above(judge(core))
            except REFUSED as reason:
                trouble = Undecided(str(reason))
                continue
            if found < 1:
                return core._replace(contraction=found)
    raise trouble


def _promising(floats: FloatSection, power: int, h_set: HSet) -> bool:
    """Whether samples of a set are mapped into it by derivatives with row sums below 1."""
    centre, sides = h_set.near
    size = len(centre)
    count = round(_SAMPLES ** (1 / size))
    points = centre + grid_in_cube(size, count, count) @ sides.T
    images, slopes = _images(floats, power, points, np.abs(sides).sum(axis=1))
    inward = np.linalg.inv(sides)
    seen = np.abs((images - centre) @ inward.T)
    sums = np.abs(inward @ slopes @ sides).sum(axis=2)
    return bool((seen < 1).all() and (sums < 1).all())  # not of what is not finite


def _images(
    floats: FloatSection, power: int, points: Floats, sizes: Floats
) -> tuple[Floats, Floats]:
    """Images (n, d) and derivatives (n, d, d) under a power of the map."""
    slopes = np.broadcast_to(np.eye(len(sizes)), (len(points), len(sizes), len(sizes)))
    for _ in range(power):
        mapped, own = floats.jacobians(points, sizes)
        points, slopes = mapped.points, own @ slopes
    return points, slopes


def _about(floats: FloatSection, power: int, point: Floats, scale: float) -> tuple[Floats, Floats]:
    """The fixed point (d,) and the derivative (d, d) there."""
    size = len(point)
    for _ in range(_STEPS):
        images, slopes = _images(floats, power, point[None], np.full(size, scale))
        if not (np.isfinite(images).all() and np.isfinite(slopes).all()):
            raise Undecided("states around the orbit do not go one way")
        point = point + np.linalg.solve(np.eye(size) - slopes[0], images[0] - point)
    return point, np.asarray(slopes[0])


def _frame(slope: Floats) -> Floats:
    """Eigenvectors as columns; of two that are conjugate the real and the imaginary part.

    So a rotation looks like one. Nearly dependent eigenvectors give the identity.
    """
    values, vectors = np.linalg.eig(slope)
    columns = []
    for value, vector in zip(values, vectors.T, strict=True):
        if value.imag >= 0:
            columns.append(vector.real)
        if value.imag > 0:
            columns.append(vector.imag)
    frame = np.array(columns).T
    return frame if np.linalg.cond(frame) < _SKEW else np.eye(len(slope))


def _above(ball: Any) -> Fraction:
    """A fraction that is larger than a ball."""
    top = float(ball.upper())
    return Fraction(int(np.ceil(top * _UP)) + 1, _UP) if np.isfinite(top) else Fraction(2)


_SEED = 20
_SAMPLED = 64  # of so many tiles one is looked at, wherever it is, before the best are
_BLOCK = 4  # tiles along each coordinate
_AT_ONCE = 4  # of so many tiles of a block one is taken at most, until the share is known anew
_OF_NEIGHBOURS = 4.0  # tiles: what the blocks around one count in its share


def next_tiles(tiles: BoxGrid, looked: Flags, attracted: Flags, count: int) -> Numbers:
    """Numbers of at most `count` tiles to look at next.

    First they are a random sample, then tiles where most have been attracted so far. Of blocks of
    tiles the share that is attracted is estimated from those of the block and of the blocks
    around it. The order decides how soon much is proved, and nothing else. `looked` and
    `attracted` have a bool for each tile.
    """
    from scipy.ndimage import uniform_filter

    left = np.flatnonzero(~looked)
    random = np.random.default_rng([_SEED, len(left)])
    sampled = len(tiles) // _SAMPLED - int(looked.sum())
    if sampled > 0:
        return random.permutation(left)[: min(count, sampled)]
    blocks = tuple(-(-n // _BLOCK) for n in tiles.counts)
    places = np.stack(np.unravel_index(np.arange(len(tiles)), tiles.counts)) // _BLOCK
    block = np.ravel_multi_index(tuple(places), blocks)
    size = int(np.prod(blocks))
    seen, good = (
        np.bincount(block, weights=flags, minlength=size).reshape(blocks)
        for flags in (looked, attracted)
    )
    wide_seen, wide_good = (uniform_filter(x, 3, mode="constant") for x in (seen, good))
    around = wide_good / np.maximum(wide_seen, 1e-9)
    share = ((good + _OF_NEIGHBOURS * around) / (seen + _OF_NEIGHBOURS)).reshape(-1)
    own = block[left]
    order = np.lexsort((random.random(len(left)), own, -share[own]))
    ranked = own[order]
    begins = np.flatnonzero(np.r_[True, ranked[1:] != ranked[:-1]])
    place = np.arange(len(ranked)) - np.repeat(begins, np.diff(np.r_[begins, len(ranked)]))
    taken = order[place < max(1, _BLOCK ** len(blocks) // _AT_ONCE)]
    chosen: Numbers = left[taken[:count]]
    return chosen


_BATCH = 8192  # tiles, or boxes of the section, at once
_ALONG, _OF_LENGTH = 8192, 128  # boxes along a section, and in the core
_AROUND, _OF_AREA = 256, 8  # the same along each of two coordinates
_STRETCHED = 64  # sides of boxes of the section: wider images are divided
_TILES = 128  # along the longest side of the box of starts
_MOST_TILES = 50_000_000
_NONE_ATTRACTED = "no box of the section within the box of starts is attracted by the orbit's core"


def certify_basin(
    orbit: Orbit,
    *,
    box: Mapping[str, tuple[float, float]] | None = None,
    side: float | None = None,
    tiles: int = 20_000,
    widest: float | None = None,
    most: int = 60,
    bits: int = 96,
    workers: int = 1,
    resume: BasinCertificate | None = None,
    progress: Progress = lambda share, tiles: None,
    keep: Callable[[BasinCertificate], object] | None = None,
) -> BasinCertificate:
    """Prove that an orbit attracts every motion from a set of starts.

    Around the orbit a set is proved to be contracted by a power of the map of a section. Then
    boxes of the section are followed, and those whose images lie in what is proved already are
    proved too, as long as there are any. Without a forcing, tiles of a box of starts are
    followed to the section as well: a few of them anywhere, then those near tiles that are
    attracted. With a forcing the section holds all
    states at one of its phases, and there are no further tiles.

    Parameters
    ----------
    orbit : Orbit
        Stable, and strictly admissible.
    box : mapping of state to (lower, upper), optional
        The box of starts; states that are not named take the bounds that `find_orbits` uses. With
        a forcing it bounds the boxes of the section.
    side : float, optional
        Tiles are no longer than this: a power of 2 at most so large is taken. By default a 128th
        of the longest side of the box. Boxes of the section have sides that suit the core.
    tiles : int
        At most so many are looked at, those of `resume` among them.
    widest : float, optional
        Sets that become wider are divided on the way; twice the side by default.
    most : int
        Parts of one tile, at most.
    bits : int
        Working precision of the proof around the orbit, 64 to 4096.
    workers : int
        Processes that follow tiles.
    resume : BasinCertificate, optional
        What was proved before of the same question.
    progress : callable
        Told which share is done, and how many tiles are attracted.
    keep : function of a BasinCertificate, optional
        Is given the state every ten seconds, of large basins less often.

    Returns
    -------
    BasinCertificate
        Proved, or undecided with the reason.

    Raises
    ------
    InputError
        For wrong names or numbers, an orbit that has not converged, parameters that are not
        rational or that its orbit leaves open, several forcings, or a state that belongs to
        another question.
    Interrupted
        By Ctrl-C; its `partial` is what is proved until then.
    NoConvergence
        If a process of `workers` ends, for want of memory perhaps.

    References
    ----------
    S. M. Rump, Verification methods, Acta Numerica 19 (2010) 287-449; A. Girard, Reachability of
    uncertain linear systems using zonotopes, HSCC 2005; S. Banach, Fund. Math. 3 (1922) 133-181.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> data = dict(chi="0.5", eta=1, V=1, us1=1, us2=1, ur1="4.0195", ur2="1.4831")
    >>> found = ns.certify.basin(ns.solve("dry-friction/global-stick", data), tiles=64)
    >>> found.proved, found.coordinates, found.attracted.any()
    (True, ('x2',), np.True_)
    """
    for name, number, least, largest in (
        ("tiles", tiles, 0, _MOST_TILES),
        ("most", most, 1, 100_000),
        ("bits", bits, 64, 4096),
    ):
        check_integer(name, number, least, largest)
    for name, length in (("side", side), ("widest", widest)):
        if length is not None and not (np.isfinite(length) and length > 0):
            raise InputError(f"{name} = {length!r} is not a positive number")
    check_workers(workers)
    check_converged(orbit, "certified")
    point = orbit.problem.physical(orbit)
    if point.chosen:
        raise InputError(
            f"{orbit.name} leaves {', '.join(point.chosen)} open, on which its basin depends: give"
            " the parameters of the system"
        )
    exact = exact_system(orbit.system, point.values)
    check_one_forcing(exact, "a basin")
    motion = orbit.trajectory()
    limits, whole = start_box(motion.system, box), start_box(motion.system)
    question = _BasinQuestion(orbit, exact, limits, whole, side, widest, most, bits, progress)
    with flint_precision(bits):
        met = section_of(exact, motion, float(orbit.period))
        if resume is not None:
            question.check_same(resume, met)
            return question.tiled(resume, tiles, workers, keep)
        if orbit.admissibility.verdict is False:
            return question.undecided(met, "the orbit is no motion of the system")
        if orbit.stability.verdict != "stable":
            return question.undecided(met, f"the orbit is {orbit.stability.verdict}")
        scale = float(np.abs(whole[list(met.section.free)]).max())
        try:
            core = question.core(met, scale)
        except Undecided as reason:
            return question.undecided(met, str(reason))
    return question.tiled(question.on_section(met, core), tiles, workers, keep)


class _BasinQuestion:
    """One orbit, one box of starts, and how they are followed."""

    def __init__(
        self,
        orbit: Orbit,
        system: ExactSystem,
        limits: Floats,
        whole: Floats,
        side: float | None,
        widest: float | None,
        most: int,
        bits: int,
        progress: Progress,
    ) -> None:
        self.orbit, self.limits, self.whole = orbit, limits, whole
        self.most, self.bits = most, bits
        self.progress, self.system = progress, system
        low, high = limits.T / _TILES
        self.side = float((high - low).max() if side is None else side)
        self.tiles: BoxGrid | None = None
        if not self.system.structure.forcing:
            sides = np.full(len(limits), self.side)
            self.tiles = BoxGrid.around(limits[:, 0], limits[:, 1], sides, _MOST_TILES)
        self.wide_given = widest is not None
        self.widest = 2 * self.side if widest is None else widest

    @property
    def _box(self) -> dict[str, tuple[float, float]]:
        """The bounds of each state in the box of starts; empty where there are no tiles."""
        if self.tiles is None:
            return {}
        ends = zip(self.system.structure.states, self.limits.tolist(), strict=True)
        return {name: (low, high) for name, (low, high) in ends}

    def _section_grid(self, met: MetSection, core: AttractingCore) -> BoxGrid:
        """Boxes of the section, small against the core so that those next to it lead into it."""
        free = list(met.section.free)
        low, high = (self.whole if met.section.phase is None else self.limits)[free].T
        centre, sides = core.h_set.near
        reach = np.abs(sides).sum(axis=1)
        count, share = (_ALONG, _OF_LENGTH) if len(free) == 1 else (_AROUND, _OF_AREA)
        side = reach / share
        far = side * count ** (2 / len(free)) / 2 if len(free) > 1 else side * count / 2
        return BoxGrid.around(np.maximum(low, centre - far), np.minimum(high, centre + far), side)

    def core(self, met: MetSection, scale: float) -> AttractingCore:
        """A set around the orbit's point that is contracted; `Undecided` if none is proved."""
        kernels = self.orbit.system
        floats = FloatSection(kernels, self.system, met.section)
        empty = self.undecided(met, "")
        empty = replace(empty, declaration=listed_declaration(kernels, self.system))

        def judge(core: AttractingCore) -> Any:
            return contraction(stated(self._with_core(empty, core)))

        return attracting_core(floats, met.iterates, met.point, scale, judge)

    def _with_core(self, known: BasinCertificate, core: AttractingCore) -> BasinCertificate:
        """The certificate with a core."""
        return replace(
            known,
            core=core.h_set,
            iterates=core.iterates,
            itinerary=named_way(self.system, core.way),
            contraction=str(core.contraction),
        )

    def on_section(self, met: MetSection, core: AttractingCore) -> BasinCertificate:
        """The certificate of what is proved on the section; no tile is looked at yet."""
        grid = self._section_grid(met, core)
        if met.section.phase is not None and not self.wide_given:
            self.widest = _STRETCHED * float(grid.sides.max())
        tiles = self.tiles
        size = 0 if tiles is None else len(tiles)
        found = replace(
            self._with_core(self.undecided(met, ""), core),
            claim="proved",
            grid=grid,
            tiles=tiles,
            states=tuple(self._box),
            box=self._box,
            looked=np.zeros(size, dtype=bool),
            attracted=np.zeros(size, dtype=bool),
            declaration=listed_declaration(self.orbit.system, self.system),
        )
        with flint_precision(self.bits), refused_as_input():
            told = stated(found)
            ranks = attracted_boxes(told, grid, lambda: self.progress(0.0, 0))
        if tiles is None and ranks.max(initial=-1) < 0:
            return self.undecided(met, _NONE_ATTRACTED)
        return replace(found, ranks=ranks)

    def tiled(
        self,
        known: BasinCertificate,
        most: int,
        workers: int,
        keep: Callable[[BasinCertificate], object] | None,
    ) -> BasinCertificate:
        """The certificate with at most so many tiles looked at, those that are known among them."""
        tiles = known.tiles
        if tiles is None:
            return known
        looked, attracted = known.looked.copy(), known.attracted.copy()
        under_way = looked.copy()
        goal = max(0, min(most, looked.size) - int(looked.sum()))
        size = max(1, min(_BATCH, -(-goal // workers)))

        def batches() -> Iterator[Numbers]:
            left = goal
            while left:
                numbers = next_tiles(tiles, under_way, attracted, min(size, left))
                under_way[numbers] = True
                left -= len(numbers)
                yield numbers

        def state() -> BasinCertificate:
            return replace(known, looked=looked.copy(), attracted=attracted.copy())

        def steps() -> Steps:
            done, told = 0, (_begin_tiles, stated(known), batches(), workers)
            with closing(in_processes(*told)) as found:
                for numbers, good in found:
                    looked[numbers], attracted[numbers] = True, good
                    done += len(numbers)
                    yield done / goal, int(attracted.sum())

        with refused_as_input():
            return proved_by_steps(steps(), state, self.progress, keep)

    def undecided(self, met: MetSection, reason: str) -> BasinCertificate:
        """The certificate that nothing is proved, for a reason."""
        none = np.zeros(0, dtype=bool)
        return BasinCertificate(
            **stated_section(self.system, met.section),
            orbit=self.orbit.name,
            claim="undecided",
            reason=reason,
            core=None,
            iterates=0,
            itinerary=(),
            contraction="1",
            grid=None,
            ranks=np.zeros(0, dtype=int),
            tiles=None,
            states=(),
            box={},
            looked=none,
            attracted=none,
            widest=self.widest,
            most=self.most,
            bits=self.bits,
            declaration={},
        )

    def check_same(self, known: BasinCertificate, met: MetSection) -> None:
        """Refuse a state of another question."""
        wanted = self.undecided(met, "")
        told: dict[str, tuple[object, object]] = {}
        if known.tiles is not None:
            told = {"box": (self._box, known.box), "tiles": (self.tiles, known.tiles)}
        if not known.phase:
            told["widest"] = self.widest, known.widest
        # a file calls the system by its data, and holds it
        own, other = (each.orbit.removeprefix(each.system) for each in (wanted, known))
        check_same_section(self.orbit.system, wanted, known, "basin", orbit=(own, other), **told)


def _begin_tiles(question: Entries) -> Callable[[Numbers], Flags]:
    """A function that tells which tiles are attracted."""
    tiles = AttractedTiles(question)

    def attracted(numbers: Numbers) -> Flags:
        with flint_precision(question["bits"]):
            found: Flags = tiles.each(numbers)
        return found

    return attracted
