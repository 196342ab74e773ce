"""Prove how many orbits an itinerary has in a box of dwell times."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.checker.census import check_listed
from nonsmooth.runtime.core.errors import InputError, Interrupted
from nonsmooth.runtime.core.values import by_name, flint_precision
from nonsmooth.runtime.core.workload import TooLarge
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.loading.declared import DeclaredOrbit, DeclaredSystem
from nonsmooth.runtime.proof.certificate import Certificate, file_json
from nonsmooth.runtime.proof.certify_orbit import FEWEST_BITS, MOST_BITS, certify
from nonsmooth.runtime.proof.counting.branch_and_prune import (
    Problem,
    Root,
    Searched,
    search,
    untouched,
)
from nonsmooth.runtime.proof.counting.census import Bounds, Census, Counted, Open
from nonsmooth.runtime.proof.counting.contraction import Sides
from nonsmooth.runtime.proof.counting.dwell_box import Side
from nonsmooth.runtime.proof.counting.problems import Question
from nonsmooth.runtime.proof.counting.question import Asked, asked_of
from nonsmooth.runtime.proof.refusals import as_read, refusal

if TYPE_CHECKING:
    from flint import arb

__all__ = ["certify_all"]

_WORK = 64  # bits of the search: doubles cut its boxes
_LIMIT = 500_000
_WIDEST = 100.0  # sides of a box that the search drops at once, at most
_STOPPED = "the search was interrupted"
_EDGE = "a solution may lie on the edge of what is asked for"
_TWICE = "the orbit may be one of those that are counted, begun later"
_OTHER = "its certificate is not of this orbit alone"


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
    orbit is certified. The dwell times are searched, of a derived orbit only those that its
    reduced equations leave: the others follow from them, a first return being the first one.

    Parameters
    ----------
    orbit : str, Itinerary, System or SystemKernels
        ``system/orbit`` or ``FILE.py:ORBIT``; with an itinerary, a system.
    parameters : mapping of str to number, text or Value, optional
        As for `solve`, or, with an itinerary, as for `compose`.
    box : mapping of str to (lower, upper) or upper
        Of each dwell time that is searched, nondimensional. Bounds belong to the box, except
        a lower bound 0. Without one it is 1e-6: at 0 the equations often have solutions that
        are no orbits, which balls cannot tell from very short phases.
    itinerary : sequence of (configuration, boundary), optional
        Its dwell times are tau1, tau2, .... Of one that repeats itself, as where a period
        doubles, an orbit counts once wherever it begins, and not if it repeats itself.
    period : number, text or Value, optional
        Of a conservative itinerary.
    largest : float
        Where dwell times are searched: only orbits whose free coordinates at the start of a
        phase, which the census names, are not larger.
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
    for name, number, least in (("limit", limit, 1), ("bits", bits, FEWEST_BITS)):
        if isinstance(number, bool) or not isinstance(number, int) or number < least:
            raise InputError(f"{name} = {number!r} is not an integer from {least} on")
    if bits > MOST_BITS:
        raise InputError(f"bits = {bits} is more than {MOST_BITS}")
    if not 0 < largest < math.inf:
        raise InputError(f"largest = {largest!r} is not positive and finite")
    values, bounds = by_name("parameters", parameters), by_name("box", box)
    with flint_precision(_WORK):
        asked = asked_of(orbit, values, bounds, itinerary, period, float(largest), _WORK)
        problems = asked.question.problems
        _check_size(problems, limit)
        searches, stopped = _searched(problems, limit, begin, progress)
        roots: list[tuple[Problem, Root]] = []
        left: list[Open] = []
        looked = 0
        for problem, found in zip(problems, searches, strict=True):
            looked += found.looked
            roots += [(problem, root) for root in found.roots]
            names = asked.question.unknowns(problem)
            reason = "too many boxes" if looked >= limit else "the equations are nearly singular"
            reason = _STOPPED if found.interrupted else reason
            left += [Open(_texts(names, sides), reason) for sides in found.undecided]
        census, halted = _judged(asked, roots, left, looked, bits, begin)
    if stopped or halted:
        raise Interrupted(census)
    return census


def _searched(
    problems: Sequence[Problem],
    limit: int,
    begin: Callable[[str], object],
    progress: Callable[[float], object],
) -> tuple[list[Searched], bool]:
    """A search of each problem, untouched from the interruption on, and whether there was one."""
    found: list[Searched] = []
    try:
        begin("searching")
        while len(found) < len(problems) and not (found and found[-1].interrupted):
            rest = max(1, limit - sum(each.looked for each in found))
            told = _share(progress, len(found), len(problems))
            found.append(search(problems[len(found)], rest, told))
    except KeyboardInterrupt:
        found.append(untouched(problems[len(found)]))
    stopped = found[-1].interrupted
    return [*found, *map(untouched, problems[len(found) :])], stopped


def _check_size(problems: Sequence[Problem], limit: int) -> None:
    """Refuse with `TooLarge` a box that the permitted number of small boxes cannot nearly cover.

    Solutions recur with each turn of the phases, so boxes are not larger than turns; those that
    were measured are a fifth of a radian.
    """
    sides = sorted(high - low for problem in problems for low, high in problem.domain)
    boxes = sum(
        math.prod(max(1.0, (high - low) / _WIDEST) for low, high in problem.domain)
        for problem in problems
    )
    if not boxes <= limit:
        raise TooLarge(
            f"a box of dwell times with sides up to {sides[-1]:.3g} takes more than {limit} boxes"
            " to search: give smaller bounds"
        )


def _judged(
    asked: Asked,
    roots: Sequence[tuple[Problem, Root]],
    left: Sequence[Open],
    looked: int,
    bits: int,
    begin: Callable[[str], object],
) -> tuple[Census, bool]:
    """The census of what is proved of each root, and whether Ctrl-C came: the rest is then open."""
    question = asked.question
    counted: list[Counted] = []
    halted = False
    try:
        inside, beyond, edges = _inside(asked, roots)
    except KeyboardInterrupt:
        halted, inside, beyond = True, [], 0
        edges = [Open(_texts(question.unknowns(p), root.sides), _STOPPED) for p, root in roots]
    undecided = [*left, *edges]
    for number, (problem, root, dwell) in enumerate(inside, 1):
        certificate, reason = None, _STOPPED
        if not halted:
            try:
                begin(f"certifying orbit {number} of {len(inside)}")
                certificate, reason = _certified(question, problem, root, bits)
                if certificate is not None:
                    unique = _texts(question.unknowns(problem), root.unique)
                    listed = [*counted, Counted(unique, certificate)]
                    reason = _OTHER
                    if _is_of(certificate, dwell, asked.sides):
                        reason = _refused(_census(asked, listed, undecided, beyond, looked, bits))
                    certificate = None if reason else certificate
            except KeyboardInterrupt:
                halted, certificate, reason = True, None, _STOPPED
        names = question.unknowns(problem)
        unique = _texts(names, root.unique)
        if certificate is None and question.surplus:
            undecided.append(Open(_texts(names, root.sides), reason))
        else:
            counted.append(Counted(unique, certificate, reason))
    return _census(asked, counted, undecided, beyond, looked, bits), halted


def _census(
    asked: Asked,
    counted: Sequence[Counted],
    undecided: Sequence[Open],
    beyond: int,
    looked: int,
    bits: int,
) -> Census:
    return Census(
        orbit=asked.label,
        system=asked.system,
        parameters=asked.parameters,
        itinerary=asked.itinerary,
        box=tuple(str(side) for side in asked.sides),
        conditions=asked.question.conditions,
        orbits=tuple(counted),
        beyond=beyond,
        undecided=tuple(undecided),
        looked=looked,
        bits=bits,
    )


def _refused(census: Census) -> str:
    """Why the checker refuses the count of a census whose single orbits it proves; "" if not."""
    told = as_read(census.to_json())
    for entry, orbit in zip(told["orbits"], census.orbits, strict=True):
        if orbit.certificate is not None:
            entry["certificate"] = as_read(file_json(orbit.certificate))
    return refusal(lambda: check_listed(told))


def _inside(
    asked: Asked, roots: Sequence[tuple[Problem, Root]]
) -> tuple[list[tuple[Problem, Root, dict[str, arb]]], int, list[Open]]:
    """Roots in the box, sorted, the number of those beyond it, and the undecided ones."""
    question = asked.question
    follow = question.follow
    inside: list[tuple[Problem, Root, dict[str, arb]]] = []
    edges: list[Open] = []
    beyond = 0
    for problem, root in roots:
        names = question.unknowns(problem)
        dwell = question.dwell(problem, root)
        asks = [question.small(problem, root)]
        asks += [side.holds(dwell[side.name]) for side in asked.sides if side.name not in follow]
        rest = [side.holds(dwell[side.name]) for side in asked.sides if side.name in follow]
        if False in asks:
            continue
        if False in rest:
            beyond += 1
        elif None in asks or None in rest:
            edges.append(Open(_texts(names, root.sides), _EDGE))
        elif (again := _again(question, problem, root, inside)) is None:
            edges.append(Open(_texts(names, root.sides), _TWICE))
        elif not again:
            inside.append((problem, root, dwell))
    first = asked.sides[0].name
    return sorted(inside, key=lambda each: float(each[2][first].mid())), beyond, edges


def _again(
    question: Question, problem: Problem, root: Root, inside: Sequence[tuple[Any, ...]]
) -> bool | None:
    """Whether an orbit is counted already, begun at another phase; None if that is undecided.

    The same is asked of an orbit that repeats itself before its itinerary ends.
    """
    others = [root, *(other for its, other, _ in inside if its is problem)]
    verdicts = [question.again(problem, root, other) for other in others]
    return True if True in verdicts else None if None in verdicts else False


def _certified(
    question: Question, problem: Problem, root: Root, bits: int
) -> tuple[Certificate | None, str]:
    try:
        certificate = certify(question.orbit(problem, root), bits)
    except InputError as reason:
        return None, str(reason)
    if certificate.claims["existence"] != "proved":
        return None, certificate.reasons["existence"]
    return certificate, ""


def _is_of(certificate: Certificate, dwell: Mapping[str, arb], sides: Sequence[Side]) -> bool:
    """Whether a certified orbit is in the box, and its dwell times may be those of a root.

    Certified orbits that are in the box are roots, and as many as there are of them that are
    apart from each other; no more is needed to count them.
    """
    found = {name: certificate.enclosures[name].ball for name in dwell}
    return all(found[n].overlaps(t) for n, t in dwell.items()) and all(
        side.holds(found[side.name]) for side in sides
    )


def _share(
    progress: Callable[[float], object], place: int, count: int
) -> Callable[[float], object]:
    """A function that reports the progress of all searches, given that of one."""
    return lambda share: progress((place + share) / count)


def _texts(names: Sequence[str], sides: Sides) -> Bounds:
    return {n: (repr(low), repr(high)) for n, (low, high) in zip(names, sides, strict=True)}
