"""An orbit of a declared system: that there is one, its enclosures, its Poincare map.

Everything is for one parameter point, in balls, or for all parameters of a tile at once, in Taylor
models of them: numbers and matrices are arb and arb_mat, or TaylorModel.

Existence is one root of the equations in a box, by Krawczyk's theorem (1969). Functions of the
state may vanish along an orbit because it closes: phases and resets map their values u linearly
into each other, over one period u = Q u, and where 1 is no eigenvalue of Q they are zero.
"""

from collections.abc import Callable, Sequence
from functools import cached_property, partial
from typing import Any, NamedTuple

from flint import arb, arb_mat, ctx

from nonsmooth.runtime.checker.orbits.matrix_chains import along_chain, framed_phases
from nonsmooth.runtime.checker.orbits.short import Short, means
from nonsmooth.runtime.checker.stated.declared import StatedSystem
from nonsmooth.runtime.checker.stated.exact import (
    Failure,
    Numbers,
    ToNumber,
    column,
    demand,
    demand_sign,
    exact,
    product,
    reduced,
)
from nonsmooth.runtime.core.rational_functions import pivot
from nonsmooth.runtime.core.taylor_models import (
    TaylorModel,
    matrix,
    middle_of,
    range_of,
    space_of,
    unit_matrix,
)

Cut = Callable[[Any], Any]
_LOW = 2  # order of what need not be sharp
_TRIES = 4  # sizes of Krawczyk's box, where none is given
_STEPS, _SETTLED = 8, 0.45  # of Newton's method, at most; share of the bits of the last one
_FARTHEST = 1e6  # that a step may lead away


class PhaseNumbers(NamedTuple):
    """The cycle in numbers: field, exit row and reset of each phase, and the period."""

    fields: list[Any]  # each (N + 1, N + 1)
    rows: list[Any]  # each (1, N + 1), zero at the end of the phase
    resets: list[Any]  # each (N + 1, N + 1)
    period: Any  # None where neither given nor that of a forcing

    def each(self, change: Cut) -> "PhaseNumbers":
        """Return the same phases with `change` applied to each matrix and number."""
        fields, rows, resets = ([change(m) for m in part] for part in self[:3])
        period = None if self.period is None else change(self.period)
        return PhaseNumbers(fields, rows, resets, period)


class Passage(NamedTuple):
    """One passage of the cycle: residuals, their derivatives, and the states on the way."""

    values: Any  # residuals of the equations (n, 1)
    slopes: Any  # their derivatives (n, n) by the unknowns; None if not asked for
    starts: list[Any]  # states (N + 1, 1) where phases begin, last the one behind the cycle
    ends: list[Any]  # states (N + 1, 1) where phases end


class CheckedOrbit:
    """The equations of a declared orbit, and the orbit itself once it is located.

    `number` turns exact entries into balls, Taylor models or jets.
    """

    def __init__(
        self, declared: StatedSystem, number: ToNumber, short: Short | None = None
    ) -> None:
        self.declared, self.number, self.short = declared, number, short
        self.first = len(declared.free) + bool(declared.forcing)  # the dwell times begin there
        self.count = self.first + len(declared.steps)
        fields = [self.numbers(step.field) for step in declared.steps]
        rows = [self.numbers([step.exit]) for step in declared.steps]
        resets = [self.numbers(step.reset) for step in declared.steps]
        period = None if declared.period is None else number(declared.period)
        if declared.forcing:
            c, s = declared.forcing[0]
            period = 2 * arb.pi() * declared.closing["turns"] / fields[0][s, c]
        self.chain = PhaseNumbers(fields, rows, resets, period)
        poles = (range_of(number(entry)) for entry in declared.poles)
        demand(all(x.is_finite() for x in poles), "a number of the declaration has a pole")

    def numbers(self, rows: Any) -> Any:
        """Return a matrix of exact entries as a matrix of balls or Taylor models."""
        return matrix([list(map(self.number, row)) for row in rows])

    def passage(
        self, chain: PhaseNumbers, unknowns: Numbers, flows: list[Any], slopes: bool = True
    ) -> Passage:
        """Return one passage of the cycle: switching, closure and period equations, and its states.

        `unknowns` are the free states, the forcing's time and the dwell times, in the
        system's units; `flows` holds exp (B t) (N + 1, N + 1) of each phase. Derivatives are
        given if `slopes`.
        """
        free, size, here = self.declared.free, self.declared.size, self.first - 1
        first: list[Any] = [[0]] * size + [[1]]
        slope: list[list[Any]] = [[0] * self.count for _ in range(size + 1)]
        for place, k in enumerate(free):
            first[k], slope[k][place] = [unknowns[place]], 1
        for c, s in self.declared.forcing:  # cos(w t), sin(w t) at an unknown time t
            w = chain.fields[0][s, c]
            sine, cosine = (w * unknowns[here]).sin_cos()
            first[s], first[c] = [sine], [cosine]
            slope[s][here], slope[c][here] = w * cosine, -w * sine
        y, dy = matrix(first), matrix(slope)
        starts, ends, values, rows = [y], [], [], []
        begin, before = y, dy
        seen = None
        if self.short is None:  # from frames that turn with the states, where there are many
            seen = framed_phases(*chain[:3], flows)
            chain = PhaseNumbers(seen.fields, seen.rows, seen.resets, chain.period)
            flows = seen.flows
        for place, (b, n, r) in enumerate(zip(*chain[:3], strict=True)):
            own = arb_mat([[int(j == self.first + place) for j in range(self.count)]])
            divided = self.short is not None and self.short[::2] == (place, True)
            if divided:
                time, rate = unknowns[self.first + place], b * y
                mean, later = means(n, b, time)
                values.append((mean * rate)[0, 0])
                if slopes:
                    change = (later * (b * rate))[0, 0]
                    rows.append((mean * (b * dy) + own * change).entries())
            y = flows[place] * y
            ends.append(y)
            if not divided:
                values.append((n * y)[0, 0])
            if slopes:
                dy = flows[place] * dy + (b * y) * own
                if not divided:
                    rows.append((n * dy).entries())
                dy = r * dy
            y = r * y
            starts.append(y)
        if seen is not None:
            starts = [frame * y for frame, y in zip(seen.starts, starts, strict=True)]
            ends = [frame * y for frame, y in zip(seen.ends, ends, strict=True)]
        change, closure = y - begin, dy - before
        for k in free:
            if k != self.declared.dropped:
                values.append(change[k, 0])
                rows.append([closure[k, j] for j in range(self.count)] if slopes else [])
        if chain.period is not None:
            values.append(sum(unknowns[self.first :], -chain.period))
            rows.append([int(j >= self.first) for j in range(self.count)])
        demand(len(values) == self.count, "as many equations as unknowns are needed")
        return Passage(
            matrix([[v] for v in values]), matrix(rows) if slopes else None, starts, ends
        )

    def _flows(self, near: list[Any], away: Numbers) -> list[Any]:
        """Return flows for times near given ones, whose flows are `near`.

        They are those flows times flows over the short differences: wide factors have small
        exponents.
        """
        found = []
        for b, flow, time in zip(self.chain.fields, near, map(range_of, away), strict=True):
            found.append(flow if time.is_zero() else (range_of(b) * time).exp() * flow)
        return found

    def follow(self, guess: Numbers, cuts: Sequence[Cut]) -> tuple[list[Any], Any]:
        """Return polynomials near the orbit, as `followed` finds them."""

        def at(cut: Cut, unknowns: Numbers, slopes: bool) -> tuple[Any, Any]:
            chain = self.chain.each(cut)
            flows = _exponentials(chain, unknowns[self.first :])
            now = self.passage(chain, unknowns, flows, slopes)
            return now.values, now.slopes

        return followed(at, guess, cuts)

    def near(self, guess: Numbers) -> list[Any]:
        """Return unknowns near a root, by Newton's method; nothing is proved of them.

        `Failure` is raised where it finds none.
        """

        def at(point: Numbers) -> tuple[Any, Any]:
            flows = _exponentials(self.chain, point[self.first :])
            now = self.passage(self.chain, point, flows)
            return now.values, now.slopes

        return newton(at, guess)

    def locate(
        self, centre: Numbers, radii: Numbers | None = None, inverse: Any = None
    ) -> tuple[bool, bool]:
        """Return whether a box is proved to have exactly one root, and whether to have none.

        K = x - Y F(x) + (I - Y F'(X)) (X - x) contains all roots of X; if K is inside X there
        is exactly one (Krawczyk 1969). `centre` and `radii` are the middle of the box and its
        half sides, in the system's units; without radii a few are tried. `inverse` is about
        the inverse (n, n) of the slopes. With one root, the orbit is set to it.
        """
        times = [t.mid() for t in centre[self.first :]]
        near = _exponentials(self.chain, times)
        low, near_low = self.chain.each(lower), list(map(lower, near))
        unit = unit_matrix(self.count)

        def at(point: Numbers, slopes: bool = False) -> Passage:
            away = [x - t for x, t in zip(point[self.first :], times, strict=True)]
            return self.passage(self.chain, point, self._flows(near, away), slopes)

        def image(values: Any, point: Numbers, offsets: Numbers) -> list[Any]:
            box = [x + d for x, d in zip(point, offsets, strict=True)]
            away = [x - t for x, t in zip(box[self.first :], times, strict=True)]
            flows = self._flows(near_low, away)
            slopes = self.passage(low, list(map(lower, box)), flows).slopes
            inside = (unit - lower(inverse) * slopes) * column(offsets)
            return list((range_of(inside) - inverse * values).entries())

        now = at(centre, slopes=inverse is None)
        inverse = near_inverse(now.slopes) if inverse is None else inverse
        moved = (inverse * now.values).entries()
        for _ in range(1 if radii else _TRIES):
            tried = radii or [(2 * abs(d) + arb(2) ** -50).upper() for d in moved]
            moved = image(now.values, centre, [arb(0, r) for r in tried])
            if unique := all(abs(d) < r for d, r in zip(moved, tried, strict=True)):
                break
        empty = any(abs(d) > r for d, r in zip(moved, tried, strict=True))
        if unique:
            self.centre, self.radii = centre, tried
            root = [x + d for x, d in zip(centre, moved, strict=True)]
            if radii:  # from the middle of the image once more: that is sharper
                points = [x.mid() for x in root]
                offsets = [x - p for x, p in zip(root, points, strict=True)]
                moved = image(at(points).values, points, offsets)
                root = [p + d for p, d in zip(points, moved, strict=True)]
            self.root, self.dwell = root, root[self.first :]
            self.now = at(root)
            away = [x - t for x, t in zip(self.dwell, times, strict=True)]
            self.flows = self._flows(near, away)
        return unique, empty

    def along(self, unknowns: Numbers) -> list[Any]:
        """Set the orbit to these unknowns, root or not; return the residuals of its equations.

        Unknowns are free states, the forcing's time and dwell times, in the system's units.
        """
        self.dwell = list(unknowns[self.first :])
        self.flows = _exponentials(self.chain, self.dwell)
        self.now = self.passage(self.chain, unknowns, self.flows, slopes=False)
        return list(self.now.values.entries())

    def returns(self, energies: dict[str, Any]) -> None:
        """Demand that the energy gives back the coordinate whose closure was left out.

        `energies` are those of `StatedSystem.closes`; nothing is demanded if they are empty.
        """
        if not energies:
            return
        omega = range_of(self.numbers(self.declared.omega)).det()
        demand_sign(omega, "no symplectic form")
        first, *_, last = self.now.starts
        k = self.declared.dropped
        between = first.entries()
        between[k] = between[k] + (last[k, 0] - between[k]) * arb("0.5 +/- 0.5")
        row = energies[self.declared.steps[0].name][k]
        force = self.value(row, between)
        demand_sign(force, "the energy does not give the coordinate left out")

    def value(self, row: Any, state: Numbers) -> Any:
        """Return an exact affine function (N + 1) of a state (N + 1), whose last entry is 1."""
        terms = (self.number(x) * y for x, y in zip(row, state, strict=True) if x)
        return sum(terms, arb(0))

    @cached_property
    def section(self) -> Any:
        """The derivative (n, n) of the Poincare map on the smallest section that is known.

        It is the product of (I - f n / n f) and resets; for forced orbits of the saltations
        at fixed times. All other multipliers are zero, but for the multipliers 1 of
        translations.
        """
        return self.map_on(*self.declared.section)

    def map_on(self, begin: int, free: Sequence[int], basis: Any, slow: int | None = None) -> Any:
        """Return the derivative (n, n) of the Poincare map by coordinates where a phase begins.

        `free` are the n coordinates, `basis` has the exact changes (N + 1, n) of the state by
        them. If a phase is `slow`, the map is multiplied by the speed at its end, which may
        be zero.
        """
        count = len(self.chain.fields)
        places = [k % count for k in range(begin, begin + count)]
        steps = [partial(self._moved, k, slow=k == slow) for k in places]
        found = along_chain(steps, self.numbers(basis))
        return matrix([[found[i, j] for j in range(len(free))] for i in free])

    def speed(self, place: int) -> Any:
        """Return the rate at a phase's end of the boundary function that ends it.

        Phases are counted from 0.
        """
        rate = self.chain.fields[place] * self.now.ends[place]
        return (self.chain.rows[place] * rate)[0, 0]

    def _moved(self, place: int, found: Any, slow: bool = False) -> Any:
        """Return changes of the state moved from the start of a phase to that of the next.

        If `slow`, they are multiplied by the speed at the phase's end.
        """
        chain, now, count = self.chain, self.now, len(self.chain.fields)
        known = None if self.short is None else self.short.jumps[place]
        if known is not None and not slow:
            found = self.flows[place] * found
            ahead = self.numbers([[x] for x in known]) * (chain.rows[place] * found)
            return chain.resets[place] * found + ahead
        rate = chain.fields[place] * now.ends[place]
        jump = chain.resets[place] * rate
        if self.declared.forcing:
            behind = chain.fields[(place + 1) % count] * now.starts[place + 1]
            for along in self.declared.translations if place + 1 == count else ():
                gauge, column = pivot(along), [[x] for x in (*along, 0 * along[0])]
                share = behind[gauge, 0] / self.number(along[gauge])
                behind = behind - self.numbers(column) * share
            jump = jump - behind
        moved, n = self.flows[place] * found, chain.rows[place]
        if slow:
            return chain.resets[place] * moved * self.speed(place) - jump * (n * moved)
        return chain.resets[place] * moved - jump * ((n * moved) / (n * rate)[0, 0])

    def enclosures(self, section: Any = None) -> dict[str, Any]:
        """Return enclosures by name of the start, dwell times, period and trace.

        All but the trace are in the system's units. The trace is that of the given derivative
        of the Poincare map, or of the one on the smallest section, with the multipliers 1 of
        translations.
        """
        declared = self.declared
        found = dict(zip(declared.start, self.now.starts[0].entries()[:-1], strict=True))
        found |= dict(zip(declared.dwell, self.dwell, strict=True))
        period = self.chain.period
        found["period"] = sum(self.dwell, arb(0)) if period is None else period
        section = self.section if section is None else section
        found["trace"] = trace_of(section) + len(self.declared.translations)
        return found


def lower(number: Any) -> Any:
    """Return an enclosure of a model or matrix in a lower order; balls stay as they are.

    What is beyond that order goes into the radius of the constant term.
    """
    if not isinstance(number, TaylorModel) or number.space.order <= _LOW:
        return number
    space, parts = space_of(number.space.variables, _LOW), number.parts
    count = len(space.exponents)
    rest = TaylorModel(number.space, (parts[0], *(None,) * (count - 1), *parts[count:]))
    return TaylorModel(space, (rest.range(), *parts[1:count]))


def flows_over(fields: Sequence[Any], times: Numbers) -> list[Any]:
    """Return flows for times that vary: from the middle of each on, by a small exponent."""
    found = []
    for b, time in zip(fields, times, strict=True):
        middle = middle_of(time)
        found.append((b * (time - middle)).exp() * (b * middle).exp())
    return found


def orbit_at(declared: StatedSystem, number: ToNumber, guess: Any) -> CheckedOrbit:
    """Return the orbit near a guess, at numbers that are balls; `Failure` if it is not proved."""
    orbit = CheckedOrbit(declared, number)
    unique, _ = orbit.locate(orbit.near(guess))
    demand(unique, "existence at a point is not proved: Krawczyk's test fails")
    return orbit


def _exponentials(chain: PhaseNumbers, times: Numbers) -> list[Any]:
    return [(b * t).exp() for b, t in zip(chain.fields, times, strict=True)]


def followed(
    equations: Callable[[Cut, Numbers, bool], tuple[Any, Any]],
    guess: Numbers,
    cuts: Sequence[Cut],
) -> tuple[list[Any], Any]:
    """Return polynomials near roots, and about the inverse (n, n) of the slopes there.

    Newton's method is taken from the guess, with numbers cut to rising orders by `cuts`; the last
    step takes the slopes of the one before. `equations` gives values (n, 1) and, if asked, slopes
    (n, n) in cut numbers. Nothing is proved of the result: Krawczyk's test judges it.
    """
    unknowns, inverse = list(guess), None
    for cut in cuts:
        last = cut is cuts[-1]
        unknowns = list(map(cut, unknowns))
        values, slopes = equations(cut, unknowns, not last)
        inverse = cut(inverse) if last else near_inverse(slopes)
        step = (inverse * values).entries()
        unknowns = [(x - d).mid() for x, d in zip(unknowns, step, strict=True)]
    return unknowns, inverse


def newton(equations: Callable[[Numbers], tuple[Any, Any]], guess: Numbers) -> list[Any]:
    """Return a point near a root, by Newton's method; nothing is proved of it.

    `equations` gives their values (n, 1) and derivatives (n, n) at a point. `Failure` is raised
    where these are singular, or the method leaves the guess.
    """
    point = [x.mid() for x in guess]
    small = arb(2) ** -int(_SETTLED * ctx.prec)
    for _ in range(_STEPS):
        values, slopes = equations(point)
        try:
            step = slopes.mid().solve(values.mid()).entries()
        except ZeroDivisionError:
            raise Failure("the equations are singular at a point of it") from None
        lengths = list(map(abs, step))
        demand(all(d < _FARTHEST for d in lengths), "Newton's method finds no orbit")
        point = [(x - d).mid() for x, d in zip(point, step, strict=True)]
        if all(d < small * (1 + abs(x)) for x, d in zip(point, lengths, strict=True)):
            break
    return point


def krawczyk_step(values: Any, inverse: Any, slopes: Any, offsets: Numbers) -> list[Any]:
    """Return K - x (n) for K = x - Y F(x) + (I - Y F'(X)) (X - x), which holds all roots of X.

    `values` (n, 1) are F(x), `inverse` is Y, any matrix near the inverse of the `slopes` F'(X), and
    `offsets` are X - x. If K is inside X there is exactly one root (Krawczyk 1969).
    """
    inside = (unit_matrix(len(offsets)) - inverse * slopes) * column(offsets)
    return list((inside - inverse * values).entries())


def krawczyk(
    equations: Callable[[Numbers], tuple[Any, Any]],
    centre: Numbers,
    radii: Numbers,
) -> tuple[list[Any] | None, bool]:
    """Return Krawczyk's image of a box, which holds all of its roots, and if it is inside the box.

    If it is inside, there is exactly one root. `equations` gives their values (n, 1) and
    derivatives (n, n) at the middle and over the box. The image is None where these are singular.
    """
    values, slopes = equations(centre)
    try:
        inverse = slopes.mid().inv().mid()
    except ZeroDivisionError:
        return None, False
    offsets = [arb(0, r) for r in radii]
    _, over = equations([x + d for x, d in zip(centre, offsets, strict=True)])
    moved = krawczyk_step(values, inverse, over, offsets)
    inside = all(abs(d) < r for d, r in zip(moved, radii, strict=True))
    return [x + d for x, d in zip(centre, moved, strict=True)], inside


_SINGULAR = "the equations are singular in the middle of the box"


def near_inverse(slopes: Any, otherwise: str = _SINGULAR) -> Any:
    """Return about the inverse of a matrix: any is sound, as a test judges it."""
    try:
        return slopes.mid().inv().mid()
    except ZeroDivisionError:
        raise Failure(otherwise) from None


def trace_of(square: Any) -> Any:
    """Return the sum of the diagonal of a square matrix."""
    return sum((square[k, k] for k in range(square.nrows())), arb(0))


def vanishing(orbit: CheckedOrbit) -> list[Any]:
    """Return the rows that the file states to be zero where the orbit begins, and prove them.

    The rows are exact, (N + 1); there are none if the file states none. `Failure` is
    raised if they need not vanish.
    """
    declared = orbit.declared
    if "vanishing" not in declared.closing:
        return []
    first = [tuple(map(exact, row)) for row in declared.closing["vanishing"]]
    fits = declared.rational and all(len(row) == declared.size + 1 for row in first)
    demand(fits and first, "no functions that vanish")
    demand(declared.exactly.echelon(first) == first, "functions that vanish are not reduced")
    facts, count = first, len(first)
    u = unit_matrix(count)
    for step, time in zip(declared.steps, orbit.dwell, strict=True):
        kept = declared.exactly.lasting(facts, step.field)
        rates = [_factors(product(row, step.field), kept) for row in kept]
        u = _times(orbit, [_factors(row, facts) for row in kept], u, count)
        if kept:
            u = (orbit.numbers(rates) * time).exp() * u
        end = declared.exactly.echelon([*kept, step.exit])
        facts = declared.exactly.behind(end, step.reset)
        behind = [_less_exit(orbit, product(row, step.reset), step.exit, kept) for row in facts]
        u = _times(orbit, [_factors(row, kept) for row in behind], u, count)
    lasts = not any(any(reduced(row, facts)) for row in first)
    demand(lasts, "functions that vanish depend on others")
    u = _times(orbit, [_factors(row, facts) for row in first], u, count)
    demand_sign((unit_matrix(count) - u).det(), "functions need not vanish")
    return first


def _factors(row: Any, facts: list[Any]) -> list[Any]:
    """Return the coefficients of a row as a combination of reduced rows."""
    return [row[pivot(fact)] for fact in facts]


def _less_exit(orbit: CheckedOrbit, row: Any, leaves: Any, kept: list[Any]) -> Any:
    """Return a row without its share of the exit row, which is zero where the phase ends."""
    rest, zero = reduced(row, kept), reduced(leaves, kept)
    place = pivot(zero)
    if place is None:
        return row
    orbit.declared.exactly.divisors.append(zero[place])
    share = rest[place] / zero[place]
    return tuple(x - share * y for x, y in zip(row, leaves, strict=True))


def _times(orbit: CheckedOrbit, factors: list[list[Any]], u: Any, count: int) -> Any:
    """Return combinations of the functions' values, as a matrix over their values at the start."""
    if not factors or not factors[0]:
        return arb_mat([[0] * count for _ in factors])
    return orbit.numbers(factors) * u
