"""What a document says of an itinerary, held against an orbit that is found by itself."""

import re
from functools import cached_property

import numpy as np
import sympy as sp

from nonsmooth.derive.document.blocks import Formula, Paragraph
from tests.formulas.latex import read_latex
from tests.formulas.law import Broken, Motion, SystemLaw, relations_of
from tests.formulas.layout import plain
from tests.formulas.pages import inline
from tests.formulas.values import Reading, name_of

SECTIONS = (
    "The system", "Configurations", "Modal analysis", "The itinerary", "The equations",
    "The reduction", "The transitions", "Stability", "Admissibility",
)  # fmt: skip


class Orbit:
    """A periodic orbit that a solver found, with the states along it by exponentials."""

    def __init__(self, facts, solved):
        self.cycle = cycle = facts.document.shown
        self.facts, self.phases = facts, cycle.itinerary.phases
        self.passings = [cycle.passings[cycle.number(k) - 1] for k in range(1, cycle.count + 1)]
        self.resets = [(self.number(p.reset), self.number(p.jump)) for p in self.passings]
        self.directions = self.number(cycle.directions)
        self.times = [float(time) for time in solved.dwell_times]
        self.start = np.array(solved.states[0], dtype=float)[:, None]
        # in front of the transitions and behind them
        self.ends, self.behind = [], [self.start]
        for phase, time, (reset, jump) in zip(self.phases, self.times, self.resets, strict=True):
            phi, forcing = facts.flow(phase.configuration, time)
            self.ends.append(phi @ self.behind[-1] + forcing)
            self.behind.append(reset @ self.ends[-1] + jump)

    def number(self, matrix):
        return np.array(matrix.xreplace(self.facts.given), dtype=float)

    def shift(self, moved):
        """How far the orbit does not come back, along directions that nothing depends on."""
        return np.asarray(np.linalg.lstsq(self.directions, moved, rcond=None)[0])


class CycleLaw(SystemLaw):
    """Every formula is a name, or true on an orbit."""

    def __init__(self, facts, orbit):
        super().__init__(facts)
        self.cycle, self.orbit = orbit.cycle, orbit
        self.transition = None

    def whole(self):
        """Check all sections."""
        return self.check(SECTIONS)

    @property
    def parameters(self):
        itinerary = self.cycle.itinerary
        return (*super().parameters, *filter(None, (itinerary.period,)))

    def enter(self, block):
        super().enter(block)
        if not isinstance(block, Formula):
            text = block.text if isinstance(block, Paragraph) else ""
            found = re.match(r"Transition (\d+), from", text)
            self.transition = int(found[1]) if found else None

    @property
    def names(self):
        if self.where in ("The system", "Configurations", "Modal analysis"):
            return super().names
        if self.transition is None:
            return {**super().names, **self.along}
        # all is written in the state in front of the transition
        notation = self.facts.notation
        (first, *_) = self.cycle.passings[self.transition - 1].phases
        state = self.orbit.ends[first - 1][:, 0]
        symbols = map(notation.symbol, self.facts.system.states)
        return {**super().names, **self.along} | {
            name_of(s): v for s, v in zip(symbols, state, strict=True)
        }

    @cached_property
    def along(self):
        """What the letters of the document stand for on the orbit."""
        cycle, orbit, facts = self.cycle, self.orbit, self.facts
        notation, count = facts.notation, self.cycle.count
        letters = notation.letters
        state = notation.state
        found = {}

        def say(name, value):
            found[name_of(name)] = value

        for k in range(count + 1):
            say(f"{state}^{{({k})}}", orbit.ends[k - 1] if k else orbit.start)
            say(f"{state}^{{({k})+}}", orbit.behind[k])
        section = cycle.start
        embedding, base = orbit.number(section.embedding), orbit.number(section.constant)
        inverse = np.eye(len(orbit.start))[list(section.places)]
        say(letters.embedding, embedding)
        say(f"{letters.embedding}^{{+}}", inverse)
        say(letters.base, base)
        say(letters.coordinates, inverse @ orbit.start)
        for symbol, place in zip(section.coordinates, section.places, strict=True):
            say(notation.symbol(symbol), float(orbit.start[place, 0]))
        size = len(orbit.start)
        passage, remainder = np.eye(size), np.zeros((size, 1))
        local = monodromy = np.eye(size)
        for k, phase in enumerate(orbit.phases):
            time, passing = orbit.times[k], orbit.passings[k]
            j, (reset, jump) = cycle.number(k + 1), orbit.resets[k]
            phi, forcing = facts.flow(phase.configuration, time)
            say(rf"\Phi^{{({k + 1})}}", phi)
            say(f"{letters.forcing}^{{({k + 1})}}", forcing)
            say(rf"\tau^{{({k + 1})}}", time)
            say(notation.symbol(sp.Symbol(phase.dwell_time, positive=True)), time)
            passage, remainder = reset @ phi @ passage, reset @ (phi @ remainder + forcing) + jump
            normal = orbit.number(passing.normal)
            a, b = facts.fields[phase.configuration]
            before = a @ orbit.ends[k] + b
            a, b = facts.fields[passing.transition.target]
            after = a @ orbit.behind[k + 1] + b
            rate = (normal @ before)[0, 0]
            saltation = reset + (after - reset @ before) @ normal / rate
            local = reset @ (np.eye(size) - before @ normal / rate) @ phi @ local
            monodromy = saltation @ phi @ monodromy
            # one transition is behind several phases, each with a state of its own in front of it
            first = [str(j)] if k + 1 == passing.phases[0] else []
            for place in (f"j({k + 1})", *first):
                for letter, value in (
                    (letters.reset, reset), (letters.jump, jump), (letters.normal, normal),
                    (letters.constant, float(passing.constant.xreplace(facts.given))),
                    (letters.field, before), (letters.saltation, saltation),
                ):  # fmt: skip
                    say(f"{letter}_{{{place}}}", value)
                say(f"{letters.field}_{{{place}}}^{{+}}", after)
        say(letters.directions, orbit.directions)
        say(letters.shift, orbit.shift(orbit.behind[-1] - orbit.start))
        say(letters.passage, passage)
        say(letters.remainder, remainder)
        say(letters.jacobian, inverse @ local @ embedding)
        say(r"\mathcal{M}", monodromy)
        a, b = facts.fields[orbit.phases[0].configuration]
        say(letters.matrix, a)
        say(letters.offset, b)
        if cycle.itinerary.period is not None:
            say(notation.symbol(cycle.itinerary.period.symbol), float(sum(orbit.times)))
        return found

    def statement(self, row, condition):
        """For every phase, or transition, if its number is open."""
        text = plain(row)
        cycle = self.cycle
        if text == "…" or re.match(r"k=1,|j\(k\)$", text):
            return
        outside = self.where not in ("The system", "Configurations", "Modal analysis")
        if not outside or not re.search(r"[({]k|\{j\}|\{j\(k\)|\bg\(|Y\(t\)|X\(t\)", text):
            super().statement(row, condition)
            return
        known, count = self.indices, self.count
        if re.search(r"_\{j\}", text):
            for j in range(1, len(cycle.passings) + 1):
                self.indices = {"j": j}
                super().statement(row, condition)
        else:
            for k in range(1, cycle.count + 1):
                self.indices, self.phase = {"k": k}, k
                super().statement(row, condition)
        self.indices, self.count, self.phase = known, count + 1, 0

    def is_open(self, row):
        # an orbit need not be admissible
        return super().is_open(row) or "g(" in plain(row)

    phase = 0

    def with_functions(self, names, row):
        names = super().with_functions(names, row)
        if not self.phase or "g(" not in plain(row):
            return names
        # boundary functions on the way through a phase
        phase, before = self.orbit.phases[self.phase - 1], self.orbit.behind[self.phase - 1]
        system, facts = self.facts.system, self.facts

        def highest(state):
            found = []
            for boundary in system.configuration(phase.configuration).boundaries:
                normal, constant = system.gradient(boundary.function)
                value = (self.orbit.number(normal) @ state)[0, 0]
                found.append(value + float(constant.xreplace(facts.given)))
            return float(max(found))

        def moved(time):
            phi, forcing = facts.flow(phase.configuration, time)
            return phi @ before + forcing

        time = 0.5 * self.orbit.times[self.phase - 1]
        return names | {
            "g": highest, "t": time, name_of(facts.notation.state): Motion.of(before, moved)
        }  # fmt: skip

    # -- tables

    def table(self, table):
        if table.header[:5] == ("Phase", "Configuration", "Dwell time", "Flow", "Left by"):
            self.phases(table)
        elif table.header == ("Transition", "Required", "Along"):
            self.required(table)
        else:
            super().table(table)

    def phases(self, table):
        names = super().names | self.along
        for k, (row, phase) in enumerate(zip(table.rows, self.orbit.phases, strict=True), start=1):
            number, configuration, dwell, flow, boundary, last = row
            if (number, configuration, boundary) != (
                str(k), f"*{phase.configuration}*", f"*{phase.boundary}*"
            ):  # fmt: skip
                raise Broken(f"phase {k}")
            reading = Reading(names)
            time = self.orbit.times[k - 1]
            if not np.isclose(reading.latex(dwell[1:-1]), time):
                raise Broken(dwell)
            phi = self.facts.flow(phase.configuration, time)[0]
            if not np.allclose(reading.latex(flow[1:-1]), phi, atol=1e-9):
                raise Broken(flow)
            if table.header[-1] == "Where":
                declared = self.facts.system.configuration(phase.configuration)
                self.same(
                    [self.left(last[1:-1], "=")], [declared.boundary(phase.boundary).function]
                )
            elif last != f"${self.cycle.number(k)}$":
                raise Broken(last)
            self.count += 1

    def required(self, table):
        number = 0
        for place, text, _ in table.rows:
            number = int(place.strip("$")) if place else number
            self.transition = number
            values = []
            for negated, formula in re.findall(r"(not )?\$([^$]+)\$", text):
                ((left, right), _) = relations_of(read_latex(formula))
                value = Reading(self.names)(left) - Reading(self.names)(right)
                values.append(-value if negated else value)
            # where a function vanishes, its derivatives decide
            if max(values) < -1e-9:
                raise Broken(f"transition {number}: {text}")
            self.count += len(inline(text))
        self.transition = None
