"""The check of a certificate, from nothing but its file and python-flint: read it in one sitting.

A certificate holds a declaration: of each configuration the affine field y' = A y + b, the rows
n y + c of its boundaries (negative inside) and of what vanishes in it; of each transition its
conditions and its affine reset. It holds an itinerary, a box of unknowns, and what is claimed.
Here all of it is proved again, by another route than that of the program that wrote it, of
which nothing is imported: flows are arb_mat.exp, and arb's balls contain all rounding errors.
A text is an exact fraction, {mid, rad} any number of a ball. States carry a last entry 1, so
that every affine map is one matrix and every affine function one row.

    existence      one root of the equations in the box: Krawczyk's theorem
    admissibility  no boundary is crossed before the phase ends, and the transition is right
    stability      the multipliers inside the unit circle, or on it where energy is kept
"""

import hashlib
import json
import sys
from operator import mul
from typing import Any

from flint import acb, acb_poly, arb, arb_mat, ctx, fmpq, fmpq_mat

__all__ = ["Failure", "check"]

_DEEPEST = 60  # halvings of a window of time
_GUARD = 96  # bits beyond those of the enclosures


class Failure(Exception):
    """Something that is claimed could not be proved."""


def check(content: dict[str, Any]) -> None:
    """Prove every claim of a certificate; Failure says which one cannot be."""
    covered = {key: value for key, value in content.items() if key != "sha256"}
    digest = hashlib.sha256(json.dumps(covered, sort_keys=True).encode()).hexdigest()
    _demand(content["sha256"] == digest, "edited or damaged: the checksum differs")
    exists, admissible, stable = (
        content["claims"][name] for name in ("existence", "admissibility", "stability")
    )
    _demand({exists, admissible, stable} <= {"proved", "refuted", "undecided"}, "unknown claims")
    if exists != "proved":
        _demand(admissible == stable == "undecided", "a claim about no orbit")
    if exists == "undecided":
        return
    with ctx.workprec(content["bits"] + _GUARD):
        orbit = _Orbit(content)
        if exists == "refuted":
            # with a forcing one of the equations is a choice: how often that turns
            empty = orbit.empty and not orbit.forcing
            _demand(empty, "existence is not refuted: the box may contain a root")
            return
        _demand(orbit.unique, "existence is not proved: Krawczyk's test fails")
        orbit.closes()
        orbit.contains(content)
        if stable != "undecided":
            found = orbit.stability(content["stability"], content["multipliers"])
            _demand(found == stable, f"stability is {found}")
    if admissible != "undecided":
        with ctx.workprec(min(content["bits"], 128) + _GUARD):
            found = orbit.admissibility(content["margins"])
        _demand(found == admissible, f"admissibility is {found}")


class _Orbit:
    """The orbit of a certificate: its declaration, and Krawczyk's test on its box."""

    def __init__(self, content: dict[str, Any]) -> None:
        declared, self.closing = content["declaration"], content["closing"]
        self.size, self.forcing = len(declared["states"]), declared["forcing"]
        self.rational = '"mid"' not in json.dumps(declared)
        zero, one = (fmpq(0),) * self.size, fmpq(1)
        self.configurations = declared["configurations"]
        self.fields = {
            name: [*map(_row, entry["field"]), (*zero, fmpq(0))]
            for name, entry in self.configurations.items()
        }
        self.phases, self.transitions = declared["phases"], declared["transitions"]
        self.names = [phase["configuration"] for phase in self.phases]
        self.taken = [self.transitions[phase["transition"]] for phase in self.phases]
        self.resets = [[*map(_row, taken["reset"]), (*zero, one)] for taken in self.taken]
        self.field = [self.fields[name] for name in self.names]
        self.exits = []
        told = [[p["configuration"], "+".join(p["boundaries"])] for p in self.phases]
        _demand(content["itinerary"] == told, "the itinerary is not that of the declaration")
        targets = [*self.names[1:], self.names[0]]
        for phase, taken, target in zip(self.phases, self.taken, targets, strict=True):
            ways = (taken["source"], sorted(taken["boundaries"]), taken["target"])
            wanted = (phase["configuration"], sorted(phase["boundaries"]), target)
            _demand(ways == wanted, "a transition does not lead from phase to phase")
            entry = self.configurations[phase["configuration"]]
            self.exits.append(_row(entry["boundaries"][phase["boundaries"][0]]))
        self.B, self.R = [_balls(f) for f in self.field], [_balls(r) for r in self.resets]
        self.n = [_balls([row]) for row in self.exits]
        forced = {k for pair in self.forcing for k in pair}
        self.free = [k for k in range(self.size) if k not in forced]
        self.first = len(self.free) + bool(self.forcing)  # where the dwell times begin
        self._krawczyk(content["box"])

    def _krawczyk(self, box: list[Any]) -> None:
        """K = x - Y F(x) + (I - Y F'(X)) (X - x) contains all roots of X; inside X, just one."""
        _demand(len(box) == self.first + len(self.phases), "the box is of another size")
        centre, radii = ([arb(_exact(side[k])) for side in box] for k in ("mid", "rad"))
        self.middles = [t.mid() for t in centre[self.first :]]
        self.near = [(b * t).exp() for b, t in zip(self.B, self.middles, strict=True)]
        inverse = None
        unit = arb_mat([[int(i == j) for j in range(len(box))] for i in range(len(box))])
        moved = [arb(0, r) for r in radii]
        for again in (False, True):  # from the middle of the image once more: that is sharper
            value, slope = self._equations(centre)
            if not again:
                try:
                    inverse = slope.mid().inv().mid()  # any matrix serves: the test judges it
                except ZeroDivisionError:
                    raise Failure("the equations are singular in the middle of the box") from None
            _, slopes = self._equations([x + d for x, d in zip(centre, moved, strict=True)])
            column = arb_mat([[d] for d in moved])
            moved = ((unit - inverse * slopes) * column - inverse * value).entries()
            root = [x + d for x, d in zip(centre, moved, strict=True)]
            if not again:
                self.unique = all(abs(d) < r for d, r in zip(moved, radii, strict=True))
                self.empty = any(abs(d) > r for d, r in zip(moved, radii, strict=True))
            if not self.unique:
                return
            centre = [x.mid() for x in root]
            moved = [x - c for x, c in zip(root, centre, strict=True)]
        self.dwell = root[self.first :]
        self._equations(root)  # leaves the orbit's starts, ends and flows

    def _equations(self, u: list[Any]) -> tuple[Any, Any]:
        """Switching, closure and how the cycle closes, with derivatives by the unknowns."""
        count, size, here = len(u), self.size, self.first - 1
        y, dy = arb_mat(size + 1, 1), arb_mat(size + 1, count)
        y[size, 0] = 1
        for place, k in enumerate(self.free):
            y[k, 0], dy[k, place] = u[place], 1
        for c, s in self.forcing:  # cos(wt), sin(wt) at an unknown time t
            w = self.B[0][s, c]
            y[c, 0], y[s, 0] = (w * u[here]).cos(), (w * u[here]).sin()
            dy[c, here], dy[s, here] = -w * y[s, 0], w * y[c, 0]
        begin, slope, values, rows = y, dy, [], []
        self.starts, self.ends, self.flows = [y], [], []
        for place, b in enumerate(self.B):
            t = u[self.first + place]
            flow = (b * (t - self.middles[place])).exp() * self.near[place]
            y, dy = flow * y, flow * dy
            rate = b * y
            for i in range(size):
                dy[i, self.first + place] += rate[i, 0]
            values.append((self.n[place] * y)[0, 0])
            rows.append((self.n[place] * dy).entries())
            self.ends.append(y)
            self.flows.append(flow)
            y, dy = self.R[place] * y, self.R[place] * dy
            self.starts.append(y)
        for k in self.free:
            if k != self.closing["dropped"]:
                values.append(y[k, 0] - begin[k, 0])
                rows.append([dy[k, j] - slope[k, j] for j in range(count)])
        if self.closing["kind"] != "state":
            values.append(sum(u[self.first :], arb(0)) - self._period())
            rows.append([int(j >= self.first) for j in range(count)])
        _demand(len(values) == count, "as many equations as unknowns are needed")
        return arb_mat([[v] for v in values]), arb_mat(rows)

    def _period(self) -> Any:
        if self.closing["kind"] == "period":
            return arb(_number(self.closing["period"]))
        c, s = self.forcing[0]
        return 2 * arb.pi() * self.closing["turns"] / self.B[0][s, c]

    def closes(self) -> None:
        """What is no equation follows: forcings return, energy gives the coordinate left out."""
        kind, dropped, size = self.closing["kind"], self.closing["dropped"], self.size
        _demand(kind in ("state", "period", "forcing"), "it closes in an unknown way")
        _demand((kind == "forcing") == bool(self.forcing), "a forcing is left out")
        _demand(dropped in self.free if kind == "period" else dropped == -1, "an open coordinate")
        _demand(kind == "state" or self.rational, "the declaration is not exact")
        if kind == "forcing":
            (c0, s0), turns = self.forcing[0], self.closing["turns"]
            for c, s in self.forcing:
                w = self.field[0][s][c]
                _demand((w * turns / self.field[0][s0][c0]).q == 1, "a forcing does not return")
                for k, other, rate in ((c, s, -w), (s, c, w)):
                    turns_as = [rate if j == other else 0 for j in range(size + 1)]
                    keep = [int(j == k) for j in range(size + 1)]
                    _demand(all(list(b[k]) == turns_as for b in self.field), "an uneven forcing")
                    _demand(all(list(r[k]) == keep for r in self.resets), "a forcing is reset")
        if kind != "period":
            return
        # The field is f = Omega^-1 grad E with E = y'H y/2, so each phase keeps E and Omega. At a
        # boundary the reset keeps E, and Omega on its tangents: monodromy is symplectic.
        omega = fmpq_mat([[_exact(x) for x in row] for row in self.closing["form"]])
        _demand(omega.transpose() == -1 * omega and omega.det() != 0, "no symplectic form")
        energies = {}
        for name, field in zip(self.names, self.field, strict=True):
            upper = (omega * fmpq_mat([list(row) for row in field[:-1]])).tolist()
            below = [row[-1] for row in upper] + [_exact(self.closing["constants"][name])]
            energies[name] = fmpq_mat([*upper, below])
            symmetric = energies[name] == energies[name].transpose()
            _demand(symmetric, "a field is not the energy's")
        after = [*self.names[1:], self.names[0]]
        ways = zip(self.names, after, self.resets, self.exits, strict=True)
        for name, target, rows, exit_ in ways:
            reset = fmpq_mat([list(row) for row in rows])
            jump = reset.transpose() * energies[target] * reset - energies[name]
            linear = fmpq_mat([list(row[:-1]) for row in rows[:-1]])
            turn = linear.transpose() * omega * linear - omega
            for change, normal in ((jump, exit_), (turn, exit_[:-1])):
                on = fmpq_mat([list(c) for c in _left_kernel([[x] for x in normal])])
                kept = not any((on * change * on.transpose()).entries())
                _demand(kept, "a reset keeps neither energy nor form")
        state = self.starts[0] * 1
        state[dropped, 0] = state[dropped, 0].union(self.starts[-1][dropped, 0])
        force = (_balls(energies[self.names[0]].tolist()) * state)[dropped, 0]
        _demand(force > 0 or force < 0, "the energy does not give the coordinate left out")

    def _map(self) -> Any:
        """Product of (I - f n / n f) and resets; of forced ones the saltations at fixed times."""
        matrix = arb_mat([[int(i == j) for j in self.free] for i in self.free])
        for place, (flow, n, r) in enumerate(zip(self.flows, self.n, self.R, strict=True)):
            rate = self.B[place] * self.ends[place]
            jump = r * rate
            if self.forcing:
                jump -= self.B[(place + 1) % len(self.B)] * self.starts[place + 1]
            local = r * flow - jump * (n * flow) / (n * rate)[0, 0]
            matrix = arb_mat([[local[i, j] for j in self.free] for i in self.free]) * matrix
        return matrix

    def contains(self, content: dict[str, Any]) -> None:
        """Every enclosure that is stated contains what it is named after."""
        found = dict(zip(content["start"], self.starts[0].entries()[:-1], strict=True))
        found |= dict(zip(content["dwell_times"], self.dwell, strict=True))
        own = self.closing["kind"] == "state"
        found["period"] = sum(self.dwell, arb(0)) if own else self._period()
        found["trace"] = _trace(self._map())
        for name, stated in content["enclosures"].items():
            miss = abs(found[name] - arb(_exact(stated["mid"])))
            _demand(miss < arb(_exact(stated["rad"])), f"{name} is not in its enclosure")

    def stability(self, kind: str, multipliers: list[Any]) -> str:
        """Every stated multiplier is one, and all lie where it is claimed."""
        _demand(all(len(phase["boundaries"]) == 1 for phase in self.phases), "one-sided maps")
        _demand(kind in ("stable", "neutral"), "stability of an unknown kind")
        matrix = self._map()
        polynomial = acb_poly([acb(c) for c in matrix.charpoly().coeffs()])
        discs = [acb(arb(_number(m["re"])), arb(_number(m["im"]))) for m in multipliers]

        def one(disc: Any) -> bool:  # Newton's map leads into the disc: there is exactly one root
            step = polynomial(disc.mid()) / polynomial.derivative()(disc)
            return bool(disc.contains_interior(disc.mid() - step))

        _demand(all(map(one, discs)), "a stated multiplier is none")
        if kind == "neutral" and self.closing["kind"] == "period" and len(discs) == self.size - 2:
            # with m also 1/conj(m) is a multiplier: being the same one it has modulus 1
            wide = [m.union(1 / m.conjugate()) for m in discs]
            others = [[*wide[:i], acb(1)] for i in range(len(wide))]
            pairs = zip(wide, others, strict=True)
            if all(map(one, wide)) and not any(a.overlaps(b) for a, rest in pairs for b in rest):
                return "proved"
        power = matrix
        for _ in range(50):  # a norm below 1 bounds all, a large trace means that one is outside
            sums = [sum(map(abs, row), arb(0)) for row in power.tolist()]
            if kind == "stable" and all(x < 1 for x in sums):
                return "proved"
            if abs(_trace(power)) > power.nrows():
                return "refuted"
            power = power * power
        return "undecided"

    def admissibility(self, margins: list[Any]) -> str:
        """Whether the orbit is a motion of the system, for all times and at each transition."""
        _demand(self.rational, "the declaration is not exact")
        known: list[tuple[Any, Any, Any]] = []
        facts: list[Any] = []
        count = -1
        while len(facts) > count:  # what is exactly zero: from nothing, till nothing is added
            known, count = [], len(facts)
            for field, row, reset in zip(self.field, self.exits, self.resets, strict=True):
                kept = _lasting(facts, field)
                end = _echelon([*kept, row])
                known.append((facts, kept, end))
                facts = _echelon(_left_kernel([_reduced(r, end) for r in reset]))
        stated = {(m["phase"], m["boundary"], m["quantity"]): _exact(m["least"]) for m in margins}
        _demand(len(stated) == len(margins), "a margin is stated twice")
        _demand(all(m > 0 for m in stated.values()), "a margin is not positive")
        found = [sign for place in range(len(known)) for sign in self._phase(place, known, stated)]
        if 1 in found:
            return "refuted"
        _demand(not stated, "a margin is stated of nothing")
        return "proved" if {*found} == {-1} else "undecided"

    def _phase(self, place: int, known: list[Any], stated: dict[Any, Any]) -> list[int | None]:
        """Of all that has to hold in a phase -1 if it does, 1 if it does not, None if unknown.

        Margins that are kept are taken from `stated`.
        """
        begin, kept, end = known[place]
        entry, taken = self.configurations[self.names[place]], self.taken[place]
        field, first, last = self.field[place], self.starts[place], self.ends[place]

        def clear(name: str, quantity: str, size: Any) -> int | None:
            least = stated.pop((place, name, quantity), fmpq(0))
            return -1 if size > arb(least) else None

        zeros = [_value(_row(row), begin, first) for row in entry["held"]]
        found = [_sign(-self.dwell[place])]
        waves = []
        for name, row in ((name, _row(row)) for name, row in entry["boundaries"].items()):
            at_end = name in taken["boundaries"]
            if at_end:
                zeros.append(_value(row, end, last))
                speed = _value(_product(row, field), end, last)
                found += [_sign(-speed), clear(name, "speed", speed)]
            order, leading = _leading(row, field, begin, first, 0)
            if _sign(leading) == 0:
                continue  # it is zero all along
            found.append(_sign(leading))
            if order:
                found.append(clear(name, "departure", -leading))
            least = stated.pop((place, name, "distance"), fmpq(0))
            if least:  # of a function that is zero somewhere there is none
                found.append(None if order or at_end else -1)
            if order or any(_reduced(_product(row, field), kept)):
                waves.append(((*row[:-1], row[-1] + least), order, at_end, row))
            else:
                found.append(-1 if leading + least < 0 else None)
        found += [{0: -1, None: None}.get(_sign(x), 1) for x in zeros]
        found.append(self._follows(place, end))
        return found if 1 in found else [*found, self._below(place, waves)]

    def _follows(self, place: int, end: Any) -> int | None:
        """Whether the transition is the first of its boundaries whose conditions hold."""
        taken, last = self.taken[place], self.ends[place]
        entry = self.configurations[self.names[place]]["boundaries"]
        own = [_row(entry[name]) for name in taken["boundaries"]]
        for other in self.transitions:
            if other["source"] != taken["source"] or other["boundaries"] != taken["boundaries"]:
                continue
            holds: list[bool | None] = []
            for row, along, expected in other["conditions"]:
                low = int(_row(row) in own)
                sign = _sign(_leading(_row(row), self.fields[along], end, last, low)[1])
                holds.append(None if sign is None else (sign > 0) == expected)
            if False in holds:
                if other is taken:
                    return 1
            else:
                return None if None in holds else -1 if other is taken else 1
        return None

    def _below(self, place: int, waves: list[Any]) -> int | None:
        """-1 if the functions are negative inside the phase, 1 if one is positive there.

        In a window of times c - r ... c + r the motion stays in a box Z that contains
        Y(c) + [-r, r] B Z, by Picard and Lindelof. So g stays below g(c) + [-r, r] g'(c) +
        [0, r r / 2] n B B Z; where it vanishes at an end the sign of its first derivative that
        does not decides.
        """
        b, end = self.B[place], self.dwell[place].upper()
        rows = [_balls([wave[0]]) for wave in waves]
        halves: list[tuple[Any, Any]] = []
        middle = (b * (end / 2)).exp() * self.starts[place]
        windows = [(end / 2, end / 2, middle, 0, list(range(len(waves))), (True, True))]
        while windows:
            c, r, y, depth, left, (first, last) = windows.pop()
            around, rest = arb(0, r), []
            z = y + b * (y + b * y * (2 * around)) * (2 * around)
            image = y + b * z * around
            inside = all(p.contains(q) for p, q in zip(z.entries(), image.entries(), strict=True))
            for i in left:
                (_, order, at_end, plain), n = waves[i], rows[i]
                begins, ends = first and order > 0, last and at_end
                if begins and not ends:
                    for _ in range(order):
                        n = n * b
                    below = (n * z)[0, 0] < 0
                elif ends and not begins:
                    below = (n * b * z)[0, 0] > 0
                else:
                    slope = n * b
                    if (_balls([plain]) * y)[0, 0] > 0 and c < self.dwell[place]:
                        return 1
                    top = (n * y)[0, 0] + (slope * y)[0, 0] * around
                    below = top + (slope * b * z)[0, 0] * arb(0).union(r * r / 2) < 0
                if not (inside and below):
                    rest.append(i)
            if rest and depth == _DEEPEST:
                return None
            if rest:
                half = r / 2
                if depth == len(halves):
                    halves.append(((b * half).exp(), (b * -half).exp()))
                ahead, back = halves[depth]
                windows.append((c + half, half, ahead * y, depth + 1, rest, (False, last)))
                windows.append((c - half, half, back * y, depth + 1, rest, (first, False)))
        return -1


def _demand(condition: object, otherwise: str) -> None:
    if not condition:
        raise Failure(otherwise)


def _exact(text: str) -> Any:
    """A fraction, or a decimal with an exponent, without rounding."""
    digits, _, exponent = text.partition("e")
    whole, _, decimals = digits.partition(".")
    numerator, _, denominator = (whole + decimals).partition("/")
    power = fmpq(10) ** (int(exponent or 0) - len(decimals))
    return fmpq(int(numerator), int(denominator or 1)) * power


def _number(entry: Any) -> Any:
    """A fraction exactly, or a ball."""
    if isinstance(entry, str):
        return _exact(entry)
    return arb(_exact(entry["mid"])) + arb(0, arb(_exact(entry["rad"])))


def _row(entries: list[Any]) -> tuple[Any, ...]:
    return tuple(map(_number, entries))


def _balls(rows: Any) -> Any:
    return arb_mat([[arb(entry) for entry in row] for row in rows])


def _trace(matrix: Any) -> Any:
    return sum((matrix[k, k] for k in range(matrix.nrows())), arb(0))


def _sign(x: Any) -> int | None:
    """1, -1, 0 where a number is exactly so, None where a ball does not tell."""
    return 1 if x > 0 else -1 if x < 0 else 0 if x == 0 else None


def _product(row: Any, rows: Any) -> tuple[Any, ...]:
    """A row times a matrix: with a field, the row of the derivative."""
    return tuple(sum(map(mul, row, column), fmpq(0)) for column in zip(*rows, strict=True))


def _echelon(rows: Any) -> list[Any]:
    """Independent rows of a span, reduced. Facts are such rows: functions that are zero."""
    matrix, rank = fmpq_mat([list(row) for row in rows]).rref() if rows else (fmpq_mat(0, 0), 0)
    return [tuple(row) for row in matrix.tolist()[:rank]]


def _reduced(row: Any, facts: Any) -> Any:
    """The same function of a state for which the facts hold."""
    for fact in facts:
        pivot = row[next(j for j, x in enumerate(fact) if x)]
        row = tuple(x - pivot * y for x, y in zip(row, fact, strict=True))
    return row


def _left_kernel(matrix: Any) -> list[Any]:
    """Rows c with c M = 0."""
    size, width = len(matrix), len(matrix[0])
    joined = [[*row, *(int(i == j) for j in range(size))] for i, row in enumerate(matrix)]
    return [row[width:] for row in _echelon(joined) if not any(row[:width])]


def _lasting(facts: Any, field: Any) -> Any:
    """The facts that stay true along a field: the largest part that it maps into itself."""
    while facts:
        rates = [_reduced(_product(row, field), facts) for row in facts]
        kept = [_product(c, facts) for c in _left_kernel(rates)]
        if len(kept) == len(facts):
            break
        facts = _echelon(kept)
    return facts


def _value(row: Any, facts: Any, state: Any) -> Any:
    """An affine function of a state: exactly if the facts tell, else a ball."""
    row = _reduced(row, facts)
    return (_balls([row]) * state)[0, 0] if any(row[:-1]) else row[-1]


def _leading(row: Any, field: Any, facts: Any, state: Any, order: int) -> tuple[int, Any]:
    """Order and value of the first derivative that is not exactly zero; 0 if there is none."""
    for k in range(len(row) + 1):
        value = _value(row, facts, state)
        if k >= order and _sign(value) != 0:
            return k, value
        row = _product(row, field)
    return 0, fmpq(0)


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as file:
        check(json.load(file))
    print("every claim is proved")
