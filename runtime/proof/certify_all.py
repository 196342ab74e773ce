"""Prove how many orbits an itinerary has in a box of dwell times: the checker does, box by box."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from nonsmooth.runtime.checker.counting.census import CensusVerdict, CountedBox, Counting, texts_of
from nonsmooth.runtime.checker.counting.contraction import Linear, Sides, share_of
from nonsmooth.runtime.checker.counting.covering import CUTS, CoveringBox, Root, Walk
from nonsmooth.runtime.checker.counting.dwell_equations import DwellEquations
from nonsmooth.runtime.checker.stated.exact import Entries, Failure, product, reduced
from nonsmooth.runtime.core.errors import InputError, check_integer, unknown_name
from nonsmooth.runtime.core.json_codec import stated
from nonsmooth.runtime.core.rational_functions import pivot
from nonsmooth.runtime.core.values import Value, as_value, by_name, flint_precision
from nonsmooth.runtime.core.workload import TooLarge
from nonsmooth.runtime.model.completion import complete, complete_system
from nonsmooth.runtime.model.kernels import OrbitKernels, SystemKernels, kernels_of, load_orbit
from nonsmooth.runtime.model.loading.declared import DeclaredOrbit, DeclaredSystem
from nonsmooth.runtime.model.naming import start_names
from nonsmooth.runtime.model.parameters import system_parameters
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.orbit import DOUBLE, Orbit
from nonsmooth.runtime.orbits.problem import OrbitProblem, orbit_of
from nonsmooth.runtime.orbits.solve import solve
from nonsmooth.runtime.orbits.table_solve import unknowns_of, with_routes
from nonsmooth.runtime.proof.asking import Begin, Steps, as_read, proved_by_steps
from nonsmooth.runtime.proof.census import Bounds, Census, Counted, Open
from nonsmooth.runtime.proof.certificate import GUARD, Certificate
from nonsmooth.runtime.proof.certify_orbit import FEWEST_BITS, MOST_BITS, certify
from nonsmooth.runtime.proof.orbit_to_prove import symplectic_form
from nonsmooth.runtime.proof.statement import exact_tables, system_declaration
from nonsmooth.runtime.shooting.newton import CONVERGED
from nonsmooth.runtime.shooting.shooting_map import itinerary_shape
from nonsmooth.runtime.shooting.translations import translations_of

SHORTEST = "1e-6"
_HUNDREDTHS = 100


@dataclass(frozen=True, eq=False)
class Asked:
    """An itinerary of a system at one parameter point, and the names for both."""

    problem: OrbitProblem
    values: Mapping[str, Value]  # all parameters of the system
    chosen: tuple[str, ...]  # those that the orbit leaves open
    period: Value | None  # the sum of the dwell times, where it is given
    largest: str  # largest size of a coordinate
    bits: int

    def entries(self) -> Entries:
        """What the file of a census states of the question, ready for JSON."""
        problem, timed = self.problem, self.period is not None
        cycle = itinerary_shape(structure_of(problem.system), problem.itinerary)
        tables = exact_tables(problem.system, self.values, self.bits + GUARD)
        label = problem.name
        if len(translations_of(piecewise(problem.system, self.values))):
            raise InputError(
                f"{label} does not depend on where it is: its orbits are periodic up to a shift,"
                " and not counted"
            )
        if cycle.structure.forcing:
            if timed:
                raise InputError("the period of a forced orbit is the forcing's, and not given")
            if not tables.exact:
                raise InputError(
                    "to count the orbits of a forced system its numbers have to be exact"
                )
        elif not timed and tables.exact and symplectic_form(tables, cycle) is not None:
            raise InputError(
                f"{label} keeps its energy: its orbits come in families, and only with a given"
                " period can they be counted"
            )
        return {
            "orbit": label,
            "system": problem.system.name,
            "parameters": {name: value.text for name, value in self.values.items()},
            "chosen": list(self.chosen),
            "itinerary": [list(phase) for phase in problem.itinerary],
            "given_period": "" if self.period is None else self.period.text,
            "largest": self.largest,
            "bits": self.bits,
            "declaration": as_read(
                system_declaration(
                    problem.system, cycle, tables, problem.start_names, problem.dwell_time_names,
                    timed=timed,
                )
            ),
        }  # fmt: skip


def asked_of(
    orbit: Any,
    parameters: Mapping[str, object],
    itinerary: Sequence[tuple[str, str]] | None,
    period: object,
    largest: float,
    bits: int,
) -> Asked:
    """Return what `certify_all` is asked, but for its box.

    `parameters` are physical ones, or those of the named orbit; without an itinerary that of the
    named orbit is taken. `InputError` is raised for names or values that do not fit, or orbits that
    are not counted.
    """
    size = f"{largest:g}"
    if itinerary is not None:
        kernels = with_routes(kernels_of(orbit), itinerary)
        values = system_parameters(kernels, parameters)
        problem = OrbitProblem(kernels, tuple((c, b) for c, b in itinerary))
        itinerary_shape(structure_of(kernels), problem.itinerary)
        return Asked(problem, values, (), _period(period), size, bits)
    named = load_orbit(orbit)
    if named.table.get("symmetry"):
        raise InputError(
            f"{named.name} is declared by a symmetry: give its whole itinerary instead"
        )
    phases = tuple(
        (configuration, boundary) for configuration, boundary, _ in named.table["phases"]
    )
    if named.derived:
        if period is not None:
            raise InputError(f"{named.name} takes its period, if any, among its parameters")
        return _derived(orbit, named, parameters, phases, size, bits)
    reference = named.table["reference"] or {"parameters": {}}
    given = {**reference["parameters"], **parameters}
    declared = named.table.get("period")
    if declared is not None:
        own = given.pop(declared["name"], None)
        period = own if period is None else period
    values = system_parameters(named.system, given)
    problem = OrbitProblem(named.system, phases, label=named.name, names=tuple(unknowns_of(named)))
    return Asked(problem, values, (), _period(period), size, bits)


def _derived(
    orbit: Any,
    kernels: OrbitKernels,
    parameters: Mapping[str, object],
    phases: tuple[tuple[str, str], ...],
    largest: str,
    bits: int,
) -> Asked:
    if kernels.table["vanishing"] or kernels.solved_for:
        raise InputError(
            f"{kernels.name} is a border collision, with {', '.join(kernels.solved_for)} among"
            " its unknowns: its orbits cannot be counted"
        )
    point = complete(kernels, parameters)
    given = {**point.values, **point.opened}
    if all(table.name in point.opened for table in kernels.open_parameters):
        found = complete_system(kernels, given)
    else:  # large enough for the orbit next to the reference, if there is one
        near = solve(orbit, parameters, throw=False)
        found = near.problem.physical(near) if near.converged else complete_system(kernels, given)
    values, dwell = found.values, kernels.dwell_times
    start = start_names(kernels.system.table["states"], {*dwell, *values})
    problem = OrbitProblem(kernels.system, phases, label=kernels.name, names=(*dwell, *start))
    period = point.values.get(kernels.period_name or "")
    return Asked(problem, values, found.chosen, period, largest, bits)


def _period(period: object) -> Value | None:
    if period is None:
        return None
    value = as_value(period)
    if not 0 < float(value) < math.inf:
        raise InputError(f"period = {value} is not positive and finite")
    return value


def box_of(counting: Counting, box: Mapping[str, Any]) -> list[str]:
    """Return the sides of a box as inequalities, one for each dwell time.

    `box` gives an upper bound, or both; the lower one is 1e-6 by default. Dwell times that follow
    only have to be positive, and one without bounds that ends where a periodic function of it is
    zero is at most its period. `InputError` is raised for unknown names, bounds that are missing or
    not in order.
    """
    names = counting.declared.dwell
    for name in box:
        if name not in names:
            raise unknown_name("dwell time", str(name), list(names))
    found, missing = [], []
    for place, name in enumerate(names):
        if name in box:
            found.append(_side(name, box[name]))
        elif name in counting.follow:
            found.append(f"0 < {name}")
        elif (period := _period_of(counting, place)) is not None:
            upper = math.floor(_HUNDREDTHS * period + 1) / _HUNDREDTHS
            found.append(f"{SHORTEST} <= {name} <= {upper}")
        else:
            missing.append(name)
    if missing:
        wanted = ", ".join(missing)
        raise InputError(f"the box has no bounds of {wanted}, as in {missing[0]}=0:10")
    return found


def _side(name: str, bounds: Any) -> str:
    if isinstance(bounds, Sequence) and not isinstance(bounds, str):
        if len(bounds) != 2:
            raise InputError(f"{name}: {len(bounds)} bounds are given, not two")
        first, last = bounds
    else:
        first, last = SHORTEST, bounds
    try:
        lower, upper = as_value(first), as_value(last)
    except InputError as problem:
        raise InputError(f"{name}: {problem}") from None
    if not 0 <= float(lower) < float(upper):
        raise InputError(f"{name}: {lower} and {upper} are not bounds of a dwell time, in order")
    return f"{lower} {'<' if lower.exact == 0 else '<='} {name} <= {upper}"


def _period_of(counting: Counting, phase: int) -> float | None:
    """Return the period of a phase's boundary function; None where it is not known to have one.

    If its first derivative g solves g'' = -w^2 g, the function is periodic: it is first zero within
    one period, if ever.
    """
    declared = counting.declared
    if not declared.rational:
        return None
    _, kept, _ = declared.known[phase]
    step, rates = declared.steps[phase], []
    row = step.exit
    for _ in range(3):
        row = reduced(product(row, step.field), kept)
        rates.append(row)
    first, _, third = rates
    place = pivot(first)
    if place is None:
        return None
    ratio = third[place] / first[place]
    if any(x != ratio * y for x, y in zip(third, first, strict=True)):
        return None
    square = -float(counting.number(ratio).mid())
    return 2 * math.pi / math.sqrt(square) if square > 0 else None


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
    begin: Begin = lambda step: None,
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
        By Ctrl-C; its `partial` is a Census of what is proved, with the rest undecided.

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
        count = _Count(asked, judge, sides, [*map(_TreeSearch, walks)])
        return proved_by_steps(count.steps(limit, begin), count.census, progress)


class _Count:
    """A census as far as it is proved: trees of boxes, and certificates of the orbits in them."""

    def __init__(
        self,
        asked: Asked,
        judge: CountedBox,
        sides: Sequence[str],
        searches: Sequence[_TreeSearch],
    ) -> None:
        self._asked, self._judge, self._sides, self._searches = asked, judge, sides, searches
        self._certified: list[tuple[Certificate | None, str]] = []  # of the orbits in turn

    def steps(self, limit: int, begin: Begin) -> Steps:
        """Search all boxes, `limit` at most, then certify each orbit that the trees have.

        The share that is searched is yielded; `begin` is told what begins. Boxes that still wait
        then are too many.
        """
        begin("searching")
        for place, search in enumerate(self._searches):
            left = limit - sum(other.looked for other in self._searches)
            for share in search.shares(left):
                yield ((place + share) / len(self._searches),)
        inside = self._found(_MANY).inside
        for number, (equations, root) in enumerate(inside, 1):
            begin(f"certifying orbit {number} of {len(inside)}")
            self._certified.append(self._certificate(equations, root))

    def census(self) -> Census:
        """Return what is proved; what was not looked at is left open."""
        with flint_precision(_WORK):
            found = self._found(_STOPPED)
            reasons = {id(each.walk.equations): each.reason for each in self._searches}
            left = [Open(_bounds(*each), reasons[id(each[0])]) for each in found.left]
            left += [Open(_bounds(own, root.sides), reason) for own, root, reason in found.edges]
            counted = []
            for number, (equations, root) in enumerate(found.inside):
                looked = number < len(self._certified)
                certificate, reason = self._certified[number] if looked else (None, _STOPPED)
                if certificate is None and equations.surplus:
                    left.append(Open(_bounds(equations, root.sides), reason))
                else:
                    counted.append(Counted(_bounds(equations, root.unique), certificate, reason))
            asked, counting = self._asked, self._judge.counting
            return Census(
                orbit=asked.problem.name,
                system=asked.problem.system.name,
                parameters=asked.values,
                itinerary=asked.problem.itinerary,
                chosen=asked.chosen,
                given_period=asked.period,
                largest=asked.largest,
                box=tuple(self._sides),
                conditions=tuple(counting.conditions),
                orbits=tuple(counted),
                undecided=tuple(left),
                bits=asked.bits,
                declaration=counting.asked["declaration"],
                trees=tuple(search.walk.tree for search in self._searches),
            )

    def _found(self, reason: str) -> CensusVerdict:
        """Return what the trees prove, where boxes that still wait are left open for a reason."""
        for search in self._searches:
            search.leave_rest(reason)
        return self._judge.judged([search.walk for search in self._searches])

    def _certificate(self, equations: DwellEquations, root: Root) -> tuple[Certificate | None, str]:
        """A certificate that the checker takes for a root's, or the reason why there is none."""
        try:
            certificate = certify(_orbit(self._asked, equations, root), self._asked.bits)
            if certificate.claims["existence"] != "proved":
                return None, certificate.reasons["existence"]
            self._judge.check_orbit(as_read(stated(certificate)), equations, root)
        except (InputError, Failure) as problem:
            return None, str(problem)
        return certificate, ""


class _TreeSearch:
    """The search for a tree of boxes: where to cut, and when a box is worth a closer look."""

    def __init__(self, walk: Walk) -> None:
        self.walk = walk
        self._sizes = [high - low for low, high in walk.equations.domain]
        self._patience = [0]  # of each box that waits: how often it is cut before it is contracted
        self._limit, self._done, self.looked = 0, 0.0, 0
        self.reason = _SINGULAR  # why boxes are left open

    def shares(self, limit: int) -> Iterator[float]:
        """Search on, and yield the share that is searched every so many boxes.

        At most `limit` boxes are looked at; the others are left open.
        """
        self._limit = limit
        while self.walk.waits:
            self.walk.follow(self._advice, _TOLD)
            yield self._done

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


def _bounds(equations: DwellEquations, sides: Sides) -> Bounds:
    return {name: (low, high) for name, (low, high) in texts_of(equations, sides).items()}
