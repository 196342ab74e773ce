"""Prove how many orbits an itinerary has in a box of dwell times: the checker does, box by box."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from nonsmooth.runtime.checker.counting.census import CensusVerdict, CountedBox, Counting, texts_of
from nonsmooth.runtime.checker.counting.contraction import Linear, Sides, share_of
from nonsmooth.runtime.checker.counting.covering import CUTS, CoveringBox, Root, Walk
from nonsmooth.runtime.checker.counting.dwell_equations import DwellEquations
from nonsmooth.runtime.checker.stated.exact import Failure
from nonsmooth.runtime.core.errors import InputError, Interrupted, check_integer
from nonsmooth.runtime.core.json_codec import stated
from nonsmooth.runtime.core.values import by_name, flint_precision
from nonsmooth.runtime.core.workload import TooLarge
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.loading.declared import DeclaredOrbit, DeclaredSystem
from nonsmooth.runtime.orbits.orbit import DOUBLE, Orbit
from nonsmooth.runtime.orbits.problem import orbit_of
from nonsmooth.runtime.proof.certificate import Certificate
from nonsmooth.runtime.proof.certify_orbit import FEWEST_BITS, MOST_BITS, certify
from nonsmooth.runtime.proof.counting.census import Bounds, Census, Counted, Open
from nonsmooth.runtime.proof.counting.question import Asked, asked_of, box_of
from nonsmooth.runtime.proof.refusals import as_read
from nonsmooth.runtime.shooting.newton import CONVERGED

__all__ = ["certify_all"]

_WORK = 64  # bits of the search: doubles cut its boxes
_LIMIT = 500_000
_WIDEST = 100.0  # sides of a box that the search drops at once, at most
_SMALLEST = 1e-9  # of the searched box: sides that are not cut any more
_SHRUNK = 0.75  # of its size: a box that was made so small is not cut, but looked at again
_FAR = 3.0  # of a box's radius: an image so large does not help before the box is cut twice
_UNKNOWN = 1e12  # a radius that is not bounded
_TOLD = 64  # boxes between two reports
_STOPPED = "the search was interrupted"
_MANY = "too many boxes"
_SINGULAR = "the equations are nearly singular"


def certify_all(
    orbit: str | DeclaredOrbit | DeclaredSystem | SystemKernels,
    parameters: Mapping[str, object] | None = None,
    box: Mapping[str, Any] | None = None,
    *,
    itinerary: Sequence[tuple[str, str]] | None = None,
    period: object = None,
    largest: float = 100.0,
    bits: int = 128,
    limit: int = _LIMIT,
    begin: Callable[[str], object] = lambda step: None,
    progress: Callable[[float], object] = lambda share: None,
) -> Census:
    """Prove how many orbits an itinerary has whose dwell times lie in a box.

    Branch and prune in ball arithmetic: a box is dropped when its equations are proved to have
    no root there, and cut until each root has a box in which it is the only one. Then each
    orbit is certified. The checker proves each step, and again from the file.

    Parameters
    ----------
    orbit : str, Itinerary, System or SystemKernels
        ``system/orbit`` or ``FILE.py:ORBIT``; with an itinerary, a system.
    parameters : mapping of str to number, text or Value, optional
        As for `solve`, or, with an itinerary, as for `compose`.
    box : mapping of str to (lower, upper) or upper
        Of each dwell time, nondimensional. Bounds belong to the box, except a lower bound 0.
        Without one it is 1e-6: at 0 the equations often have solutions that are no orbits, which
        balls cannot tell from very short phases. Where a phase moves evenly its dwell time
        follows, and needs no bounds; where it ends at a periodic function, it has the period's.
    itinerary : sequence of (configuration, boundary), optional
        Its dwell times are tau1, tau2, .... Of one that repeats itself, as where a period
        doubles, an orbit counts once wherever it begins, and not if it repeats itself.
    period : number, text or Value, optional
        Of a conservative itinerary.
    largest : float
        Only orbits count whose free coordinates at the start of a phase, which the census
        names, are not larger.
    bits : int
        Of the certificates.
    limit : int
        The most boxes that are looked at; what is left then is undecided.
    begin, progress : functions, optional
        Are told which step begins, and the share of the box that is searched.

    Returns
    -------
    Census

    Raises
    ------
    InputError
        For wrong names, values or bounds, a conservative itinerary without its period, a border
        collision, or an orbit that is declared by a symmetry.
    Interrupted
        By Ctrl-C in the search; its `partial` is a Census with the rest of the box undecided.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> census = ns.certify.all("dry-friction/global-stick", box={"tau": 3, "tau1": 3})
    >>> census.decided, census.count, census.admissible
    (True, 1, 1)
    """
    check_integer("limit", limit, 1)
    check_integer("bits", bits, FEWEST_BITS, MOST_BITS)
    if not 0 < largest < math.inf:
        raise InputError(f"largest = {largest!r} is not positive and finite")
    values, bounds = by_name("parameters", parameters), by_name("box", box)
    asked = asked_of(orbit, values, itinerary, period, float(largest), bits)
    with flint_precision(_WORK):
        entries = asked.entries()
        try:
            counting = Counting(entries)
            sides = box_of(counting, bounds)
            judge = counting.within(sides)
        except Failure as problem:
            raise InputError(f"the orbits cannot be counted: {problem}") from None
        _check_size(judge.equations, limit)
        walks = [Walk(equations) for equations in judge.equations]
        searches = [
            _TreeSearch(walk, _share(progress, k, len(walks))) for k, walk in enumerate(walks)
        ]
        stopped = False
        try:
            begin("searching")
            for search in searches:
                search.go(limit - sum(other.looked for other in searches))
        except KeyboardInterrupt:
            stopped = True
        for search in searches:
            search.leave_rest(_STOPPED if stopped else _MANY)
        try:
            found = judge.judged(walks)
        except KeyboardInterrupt:
            stopped, found = True, judge.judged(walks)
        reasons = {id(search.walk.equations): search.reason for search in searches}
        left = [Open(_bounds(*each), reasons[id(each[0])]) for each in found.left]
        left += [Open(_bounds(own, root.sides), reason) for own, root, reason in found.edges]
        counted, more, halted = _certified(asked, judge, found, begin, stopped=stopped)
    census = Census(
        orbit=asked.problem.name,
        system=asked.problem.system.name,
        parameters=asked.values,
        itinerary=asked.problem.itinerary,
        chosen=asked.chosen,
        given_period=asked.period,
        largest=asked.largest,
        box=tuple(sides),
        conditions=tuple(counting.conditions),
        orbits=tuple(counted),
        undecided=(*left, *more),
        bits=bits,
        declaration=entries["declaration"],
        trees=tuple(walk.tree for walk in walks),
    )
    if stopped or halted:
        raise Interrupted(census)
    return census


class _TreeSearch:
    """The search for a tree of boxes: where to cut, and when a box is worth a closer look."""

    def __init__(self, walk: Walk, progress: Callable[[float], object]) -> None:
        self.walk, self._progress = walk, progress
        self._sizes = [high - low for low, high in walk.equations.domain]
        self._patience = [0]  # of each box that waits: how often it is cut before it is contracted
        self._limit, self._done, self.looked = 0, 0.0, 0
        self.reason = _SINGULAR  # why boxes are left open

    def go(self, limit: int) -> None:
        """Search on, and look at `limit` boxes at most; the others are left open."""
        self._limit = limit
        self.walk.follow(self._advice)

    def leave_rest(self, reason: str) -> None:
        """Leave all boxes open that still wait, for a reason."""
        if self.walk.waits:
            self.reason = reason
            self.walk.follow(lambda part: "?")

    def _advice(self, part: CoveringBox) -> str:
        if self.looked >= self._limit:
            self.reason = _MANY
            return "?"
        letter, patience = self._letter(part, self._patience.pop())
        self._patience += [patience] * {"=": 1, "-": 0, "*": 0, "?": 0}.get(letter, 2)
        self._done += 0.0 if letter in CUTS else self._part_of(part.sides)
        self._done -= self._part_of(part.kept) if letter == "=" else 0.0
        self.looked += 1
        if self.looked % _TOLD == 0:
            self._progress(self._done)
        return letter

    def _letter(self, part: CoveringBox, patience: int) -> tuple[str, int]:
        """The letter for a box, and the patience with those in it."""
        if part.excluded:
            return "-", 0
        if patience == 0 and part.empty:
            return "-", 0
        image = None if patience else part.image
        if image is not None:
            if part.root is not None:
                return "*", 0
            if share_of(part.kept, part.sides) < _SHRUNK:
                return "=", 0
        if patience == 0:
            patience = 1 if image is not None and image.ratio < _FAR else 1 + len(part.sides)
        scores = _smears(part.linear, part.sides)
        for place in sorted(range(len(scores)), key=lambda k: -scores[k]):
            low, high = part.sides[place]
            middle = low + (high - low) / 2
            if high - low > _SMALLEST * self._sizes[place] and low < middle < high:
                return CUTS[place], patience - 1
        return "?", 0

    def _part_of(self, sides: Sides) -> float:
        pairs = zip(sides, self._sizes, strict=True)
        return math.prod((high - low) / size for (low, high), size in pairs)


def _smears(linear: Linear | None, sides: Sides) -> list[float]:
    """A guess of how much each unknown's side spreads the equations: cut at the largest."""
    found = []
    assert linear is not None
    for slope, (low, high) in zip(linear.slopes, sides, strict=True):
        sizes = [max(float(x.abs_upper()) for x in row) for row in slope.tolist()]
        score = sum(w * size for w, size in zip(linear.weights, sizes, strict=True)) * (high - low)
        # where the derivative is not bounded, nothing but the size of the side is known
        found.append(score if math.isfinite(score) else _UNKNOWN * (high - low))
    return found


def _check_size(equations: Sequence[DwellEquations], limit: int) -> None:
    """Refuse with `TooLarge` a box that the permitted number of small boxes cannot nearly cover.

    Solutions recur with each turn of the phases, so boxes are not larger than turns; those that
    were measured are a fifth of a radian.
    """
    sides = sorted(high - low for own in equations for low, high in own.domain)
    boxes = sum(
        math.prod(max(1.0, (high - low) / _WIDEST) for low, high in own.domain) for own in equations
    )
    if not boxes <= limit:
        raise TooLarge(
            f"a box of dwell times with sides up to {sides[-1]:.3g} takes more than {limit} boxes"
            " to search: give smaller bounds"
        )


def _certified(
    asked: Asked,
    judge: CountedBox,
    found: CensusVerdict,
    begin: Callable[[str], object],
    *,
    stopped: bool,
) -> tuple[list[Counted], list[Open], bool]:
    """The orbits with their certificates, those left open without one, and whether Ctrl-C came."""
    counted, left = [], []
    for number, (equations, root) in enumerate(found.inside, 1):
        certificate, reason = None, _STOPPED
        if not stopped:
            try:
                begin(f"certifying orbit {number} of {len(found.inside)}")
                certificate = certify(_orbit(asked, equations, root), asked.bits)
                certificate, reason = _accepted(certificate, judge, equations, root)
            except InputError as problem:
                certificate, reason = None, str(problem)
            except KeyboardInterrupt:
                stopped, certificate, reason = True, None, _STOPPED
        if certificate is None and equations.surplus:
            left.append(Open(_bounds(equations, root.sides), reason))
        else:
            counted.append(Counted(_bounds(equations, root.unique), certificate, reason))
    return counted, left, stopped


def _accepted(
    certificate: Certificate, judge: CountedBox, equations: DwellEquations, root: Root
) -> tuple[Certificate | None, str]:
    """A certificate, if the checker takes it for a root's, or the reason why there is none."""
    if certificate.claims["existence"] != "proved":
        return None, certificate.reasons["existence"]
    try:
        judge.check_orbit(as_read(stated(certificate)), equations, root)
    except Failure as problem:
        return None, str(problem)
    return certificate, ""


def _orbit(asked: Asked, equations: DwellEquations, root: Root) -> Orbit:
    """An approximation in floating point of the orbit that a root is."""
    dwell = equations.dwell(root.sides, root.coordinates)
    starts = equations.starts(root.sides, root.coordinates)
    states = [[float(x.mid()) for x in starts[k].entries()[:-1]] for k in sorted(starts)]
    times = np.array([float(dwell[name].mid()) for name in asked.problem.dwell_time_names])
    return orbit_of(
        asked.problem,
        asked.values,
        asked.period,
        times,
        np.array(states),
        0.0,
        DOUBLE,
        0,
        CONVERGED,
    )


def _share(
    progress: Callable[[float], object], place: int, count: int
) -> Callable[[float], object]:
    """A function that reports the progress of all searches, given that of one."""
    return lambda share: progress((place + share) / count)


def _bounds(equations: DwellEquations, sides: Sides) -> Bounds:
    return {name: (low, high) for name, (low, high) in texts_of(equations, sides).items()}
