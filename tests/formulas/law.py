"""What a document says of a system, held against the declaration."""

import re
from copy import copy
from dataclasses import dataclass, replace
from functools import cached_property, partial

import numpy as np
import sympy as sp
from scipy.linalg import expm
from scipy.optimize import brentq

from nonsmooth.derive import SecondOrder, System
from nonsmooth.derive.document.blocks import Document, Formula, Heading, Paragraph, Table
from tests.formulas.latex import read_latex
from tests.formulas.layout import Accent, Atom, Unreadable, core_of, plain
from tests.formulas.pages import inline
from tests.formulas.responses import response_functions
from tests.formulas.values import UNIT, Reading, Unit, divided, name_of, split, without_spaces

_RELATIONS = "=<>≤≥∈≠"
_INDEX_TEXTS = {"k=0"}


class Broken(AssertionError):
    """A formula that does not say what the declaration says."""


class Motion(np.ndarray):
    """A state that is also a function of time."""

    flow = None

    @classmethod
    def of(cls, state, flow):
        found = np.array(state, dtype=float).reshape(-1, 1).view(cls)
        found.flow = flow
        return found

    def __call__(self, time):
        return self.flow(time)


def drawn(system, seed):
    """Parameters inside their domains, and any state."""
    draw = np.random.default_rng(seed)
    while True:
        found = {}
        for parameter in system.parameters:
            low, high = (float(sp.N(e)) for e in (parameter.lower, parameter.upper))
            low = -1.7 if low == -np.inf else low
            high = low + 1.7 if high == np.inf else high
            found[parameter.symbol] = float(low + (high - low) * draw.uniform(0.07, 0.93))
        if all(float(c.xreplace(found)) >= 0 for c in system.constraints):
            break
    found |= {s: float(draw.uniform(0.3, 1.6) * draw.choice([-1, 1])) for s in system.states}
    return found


def array(matrix, numbers):
    return np.array(sp.Matrix(matrix).xreplace(dict(numbers)).tolist(), dtype=float)


@dataclass(frozen=True)
class Facts:
    """A system as a document writes it, at numbers of its parameters and its state."""

    system: System
    document: Document
    given: dict

    @property
    def notation(self):
        """How symbols are written, which is all that the document of a system shows."""
        return self.document.shown.notation

    @cached_property
    def letters(self):
        return self.notation.letters

    @cached_property
    def numbers(self):
        """All that follows from the parameters."""
        found, constants = dict(self.given), {*self.notation.constants}
        for line in (line for formula in self.document.formulas for line in formula.lines):
            if line.subject in constants - found.keys():
                found[line.subject] = float(line.shows.xreplace(found))
        return found

    @property
    def state(self):
        return np.array([self.given[s] for s in self.system.states])

    @cached_property
    def fields(self):
        """Matrix and offset of every configuration."""
        found = {c.name: c.dynamics.field(self.system.states) for c in self.system.configurations}
        return {
            name: (array(matrix, self.given), array(offset, self.given))
            for name, (matrix, offset) in found.items()
        }

    def flow(self, name, time):
        """Phi and what does not depend on the state."""
        a, b = self.fields[name]
        found = expm(np.block([[a, b], [np.zeros((1, len(a) + 1))]]) * time)
        return found[:-1, :-1], found[:-1, -1:]

    def value(self, expression):
        return float(sp.sympify(expression).xreplace(self.given))

    def held_state(self, name):
        """The state, with the velocities that a configuration holds."""
        state, dynamics = self.state, self.system.configuration(name).dynamics
        if isinstance(dynamics, SecondOrder):
            for place, velocity in dynamics.held_at(self.system.states).items():
                state[dynamics.mass.rows + place] = self.value(velocity)
        return state

    @cached_property
    def inside(self):
        """Names inside the configurations that were asked for."""
        return {}

    def names(self, configuration):
        """Names of a document, inside a configuration."""
        if configuration not in self.inside:
            self.inside[configuration] = self.made(configuration)
        return self.inside[configuration]

    def made(self, configuration, time=0.83):
        """Those names, with what they stand for."""
        notation, system = self.notation, self.system
        found = {name_of(r"\mathrm{e}"): np.e, "π": np.pi, "t": time}
        for symbol, value in self.numbers.items():
            found[name_of(notation.symbol(symbol))] = value
        letters, size = self.letters, len(system.states)
        state = self.held_state(configuration)
        found |= {name_of(notation.symbol(s)): v for s, v in zip(system.states, state, strict=True)}
        a, b = self.fields[configuration]
        rates = a @ state + b[:, 0]
        dynamics = system.configuration(configuration).dynamics
        for i, symbol in enumerate(system.states):
            found[name_of(f"{notation.symbol(symbol)}'")] = rates[i]
            if isinstance(dynamics, SecondOrder) and i < size // 2:
                found[name_of(f"{notation.symbol(symbol)}''")] = rates[size // 2 + i]
        letter = self.notation.letter
        if isinstance(dynamics, SecondOrder) and size > 2:
            if name_of(letter) in found:
                raise Broken(f"{letter} is a coordinate, and all of them")
            found[name_of(letter)] = state[: size // 2, None]
            found[name_of(f"{letter}'")] = rates[: size // 2, None]
            found[name_of(f"{letter}''")] = rates[size // 2 :, None]
        if isinstance(dynamics, SecondOrder):
            found |= self.matrices(dynamics)
        start = state + 0.37 * np.cos(np.arange(size))
        for i in [j for j in range(size) if a[j].any() == 0 and b[j, 0] == 0]:
            start[i] = state[i]
        for pair in system.forcing:
            c, s = (system.states.index(symbol) for symbol in pair)
            start[[c, s]] /= np.hypot(start[c], start[s])

        def moved(t):
            phi, forcing = self.flow(configuration, t)
            return phi @ start[:, None] + forcing

        found[name_of(self.notation.state)] = Motion.of(state, moved)
        found[name_of(f"{self.notation.state}'")] = rates[:, None]
        for i, symbol in enumerate(system.states):
            name = name_of(notation.symbol(symbol))
            found[f"{name}()"] = lambda t, i=i: moved(t)[i, 0]
            found[f"{name}^{{′}}()"] = lambda t, i=i: (a @ moved(t) + b)[i, 0]
        found |= self.steady(moved, a)
        augmented = np.block([[a, b], [np.zeros((1, size + 1))]])
        found |= {
            name_of(letters.matrix): a, name_of(letters.offset): b,
            name_of(letters.augmented): augmented, name_of(letters.eigenvalue): 0.4321,
            name_of("I"): UNIT,
            "Φ": lambda t: self.flow(configuration, t)[0],
            name_of(letters.forcing): lambda t: self.flow(configuration, t)[1],
        }  # fmt: skip
        return found | self.responses

    def steady(self, moved, a):
        """Phase of the only forcing, and the harmonic response of every state to it."""
        found = {name_of(r"\mathrm{i}"): 1j}
        if len(self.system.forcing) != 1:
            return found
        c, s = (self.system.states.index(symbol) for symbol in self.system.forcing[0])
        others = [i for i in range(len(a)) if i not in (c, s)]
        frequency = a[s, c]
        right = a[others, c] - 1j * a[others, s]
        inner = 1j * frequency * np.eye(len(others)) - a[np.ix_(others, others)]

        def phase(t):
            return float(np.arctan2(moved(t)[s, 0], moved(t)[c, 0]))

        found[f"{name_of(self.letters.phase)}()"] = phase

        def response(t, which):
            # in resonance there is none, and nothing says what it is
            value = np.linalg.solve(inner, right)[which]
            return float((value * np.exp(1j * phase(t))).real)

        for which, place in enumerate(others):
            text = self.notation.symbol(self.system.states[place])
            name = f"{text[:-1]},p}}" if "_{" in text else f"{text}_{{p}}"
            found[f"{name_of(name)}()"] = partial(response, which=which)
        return found

    @cached_property
    def responses(self):
        """Characteristic factors and impulse responses, by the numbers of the document."""
        known = self.notation.responses
        functions = response_functions(known, self.numbers)
        found = {name_of(latex): function for latex, function in functions.items()}
        letters = self.letters
        # of any factor, and of any two
        found[name_of(rf"{letters.amplitude}_{{j}}")] = 1.0
        found[name_of(rf"{letters.lag}_{{j}}")] = 1.0
        for letter, factor in zip("jk", (sp.Tuple(0), *known.factors), strict=False):
            name = name_of(rf"{known.polynomial}_{{{letter}}}")
            found[name] = found[name_of(rf"{known.polynomial}_{{{known.number(factor)}}}")]
        for label in ("j", "k", "jk"):
            found[name_of(rf"{known.letter}_{{{label}}}")] = lambda t: t
        return found

    def is_response(self, left):
        """Whether a relation says what an impulse response is."""
        return plain(left).startswith(f"{name_of(self.notation.responses.letter)}_")

    def one_cluster(self, configuration):
        """All eigenvalues as one cluster: what is said of clusters holds for it too."""
        a, _ = self.fields[configuration]
        return {
            f"{name_of(self.letters.centre)}_{{1}}": float(np.trace(a)) / (len(a) + 1),
            f"{name_of(self.letters.projector)}_{{1}}": np.eye(len(a) + 1),
        }

    def matrices(self, dynamics):
        """M, C and K: of the system, and of one configuration."""
        chosen = [c.dynamics for c in self.system.configurations]
        second = [d for d in chosen if isinstance(d, SecondOrder)]
        found = {"ℓ": array(dynamics.load, self.given)}
        for letter, attribute in (("M", "mass"), ("C", "damping"), ("K", "stiffness")):
            found[letter] = array(getattr(dynamics, attribute), self.given)
            different = dict.fromkeys(getattr(d, attribute) for d in second)
            for place, matrix in enumerate(different, start=1):
                found[f"{letter}_{{{place}}}"] = array(matrix, self.given)
        return found


class SystemLaw:
    """Go through a document: every formula is a name, true, or what was declared."""

    def __init__(self, facts):
        self.document, self.facts = facts.document, facts
        self.count = 0
        self.defined = {}
        self.used = set()
        self.inside = facts.system.configurations[0].name
        self.where = ""
        self.indices = {}

    def check(self, sections):
        """Check these sections, and say how many formulas were held against something."""
        for title in sections:
            self.where = title
            blocks = self.document.section(title)
            for block in blocks:
                self.enter(block)
                if isinstance(block, Paragraph):
                    self.paragraph(block.text)
                elif isinstance(block, Formula):
                    for line in block.lines:
                        self.statements(line.latex)
                elif isinstance(block, Table):
                    self.table(block)
            unused = set(self.defined) - self.used
            if unused:
                raise Broken(f"{self.document.title}: named and not used: {unused}")
        return self.count

    # -- where a formula stands

    def enter(self, block):
        if isinstance(block, Heading) or not isinstance(block, Paragraph):
            return
        known = {c.name for c in self.facts.system.configurations}
        found = re.match(
            r"(?:\$\\Phi_\{\d+\}\$, of )?\*([^*]+)\*(?:,| \(phase|:| has no|$)", block.text
        )
        chosen = [found[1]] if found else re.findall(r"flow of \*([^*]+)\*", block.text)
        if "flow of no configuration" in block.text:
            chosen = [self.facts.system.configurations[0].name]
        if chosen and chosen[0] in known:
            self.inside = chosen[0]

    @property
    def names(self):
        return {**self.facts.names(self.inside), **self.flows, **self.defined}

    @cached_property
    def flows(self):
        """Flows by the numbers that the document gives them, in blocks and whole."""
        found = {}
        half = len(self.facts.system.states) // 2
        for block in self.document.blocks:
            text = block.text if isinstance(block, Paragraph) else ""
            match = re.match(r"\$\\Phi_\{(\d+)\}\$, of (.*?):", text)
            if not match:
                continue
            sharing = re.findall(r"\*([^*]+)\*", match[2])
            matrices = [self.facts.flow(name, 0.7)[0] for name in sharing]
            if not all(np.allclose(m, matrices[0], rtol=1e-12) for m in matrices):
                raise Broken(f"{sharing} do not share a flow")

            def phi(t, name=sharing[0]):
                return self.facts.flow(name, t)[0]

            found[f"Φ_{{{match[1]}}}"] = phi
            for i in range(2):
                for j in range(2):
                    rows, columns = (slice(k * half, (k + 1) * half) for k in (i, j))

                    # defaults bind what the loop changes; they need no types of their own
                    def block_of(t, phi=phi, place=(rows, columns)):
                        return phi(t)[place]

                    found[f"Φ_{{{match[1]}}}^{{{i + 1}{j + 1}}}"] = block_of
        return found

    # -- what is said

    def paragraph(self, text):
        if text.startswith("Throughout, "):
            return self.constraints(text)
        if text.startswith("The parameters obey"):
            wanted = [c for c in self.facts.system.constraints if not c.is_nonnegative]
            shown = [self.left(f, "≥") for f in inline(text)]
            return self.same(shown, wanted)
        for formula, following in re.findall(r"\$([^$]+)\$([^$]*)", text):
            place = re.match(r" in \*([^*]+)\*", following)
            before, self.inside = self.inside, place[1] if place else self.inside
            if place and formula.startswith("d ="):
                self.centre(Reading(self.names)(split(read_latex(formula), "=")[1]))
            elif formula == self.about_centre:
                continue  # of each configuration with a centre, below
            else:
                self.statements(formula)
            self.inside = before
        return None

    @property
    def about_centre(self):
        state = self.facts.notation.state
        return rf"{state}(t) = d + \Phi(t)\,({state}(0) - d)"

    def centre(self, value):
        """The motion keeps its form about the centre."""
        self.defined["d"] = value
        self.statements(self.about_centre)
        self.used |= {"d", f"d_{{{self.inside}}}"}

    def constraints(self, text):
        for part in re.split(r"(?<=\*),? and |(?<=\*), ", text.removeprefix("Throughout, ")):
            (name,) = re.findall(r"in \*([^*]+)\*", part)
            shown = [self.left(f, "=") for f in inline(part)]
            self.same(shown, self.facts.system.configuration(name).constraints)

    def left(self, formula, sign):
        left, right = split(read_latex(formula), sign)
        if plain(right) != "0":
            raise Broken(formula)
        return left

    def same(self, shown, declared):
        """Expressions as they are written, and as they are declared."""
        reading = Reading(self.plain_names)
        found = [reading(row) for row in shown]
        wanted = [self.facts.value(e) for e in declared]
        if len(found) != len(wanted) or not np.allclose(found, wanted, rtol=1e-10, atol=1e-12):
            raise Broken(f"{list(map(plain, shown))} of {list(declared)}")
        self.count += len(shown)

    @property
    def plain_names(self):
        notation = self.facts.notation
        return {name_of(notation.symbol(s)): v for s, v in self.facts.given.items()} | {
            "π": np.pi,
            name_of(r"\mathrm{e}"): np.e,
        }

    def statements(self, latex):
        """Whatever a formula says, part by part."""
        whole, condition = _condition(read_latex(latex))
        for row in parts_of(whole):
            if is_name(row) or plain(row) in _INDEX_TEXTS:
                continue
            try:
                self.statement(row, condition)
            except (Unreadable, Broken, KeyError, IndexError, ValueError, TypeError) as problem:
                raise Broken(
                    f"{self.document.title}, {self.where}, {self.inside}: {latex}: {problem}"
                ) from problem

    def statement(self, row, condition):
        sides, signs = relations_of(row)
        names = self.with_functions(self.names, row)
        if "∑" in plain(row):
            names |= self.facts.one_cluster(self.inside)
        reading = Reading(names, self.indices, {"j": (1,)})
        if not signs:
            reading(row)
            return
        self.used |= {plain((i,)) for i in _all_items(row)} & set(self.defined)
        if signs and self.facts.is_response(sides[0]) and not self.holds(condition):
            elsewhere = self.where_equal(condition)
            if elsewhere is not None:
                elsewhere.statement(row, ())
            return
        values = []
        unknown = []
        for side in sides:
            short = len(side) == 1 and reading.name(side[0], above=False) in names
            if is_name(side) and not short and reading.name(side[0]) not in names:
                unknown.append(side)
            else:
                values.append(reading(side))
        if set(signs) == {"="}:
            for value in values[1:]:
                if not _close(value, values[0]):
                    raise Broken(f"{values[0]} is not {value}")
            for side in unknown:
                self.defined[reading.name(side[0])] = values[0]
                place = re.fullmatch(r"d_\{(.*)\}", plain(side))
                if place and place[1] in {c.name for c in self.facts.system.configurations}:
                    before, self.inside = self.inside, place[1]
                    self.centre(values[0])
                    self.inside = before
        elif unknown:
            raise Broken(f"unknown: {list(map(plain, unknown))}")
        elif not self.is_open(row) and not all(map(_holds, signs, values, values[1:])):
            raise Broken(f"false at {values}")
        self.count += 1

    def where_equal(self, condition):
        """The same law where a condition of equality holds: one parameter is solved for."""
        sides, signs = relations_of(condition)
        if signs != ["="]:
            return None

        def at(symbol, value):
            given = {**self.facts.given, symbol: value}
            law = copy(self)
            law.facts = replace(self.facts, given=given)
            return law

        def gap(value, symbol):
            one, other = map(Reading(at(symbol, value).names), sides)
            return float(one - other)

        for symbol in (p.symbol for p in self.parameters):
            values = np.linspace(0.05, 4.0, 12)
            gaps = [gap(v, symbol) for v in values]
            for k in range(len(values) - 1):
                if gaps[k] * gaps[k + 1] < 0:
                    return at(symbol, brentq(gap, values[k], values[k + 1], (symbol,), xtol=1e-14))
        return None

    def holds(self, condition):
        """Whether a case of an impulse response is the one at hand."""
        sides, signs = relations_of(condition)
        if len(signs) != 1:
            return True
        one, other = map(Reading(self.names), sides)
        return {"<": one < other, "=": one == other, ">": one > other, "≠": one != other}[signs[0]]

    def is_open(self, row):
        """Whether a relation holds for some values and not for others."""
        return "∈" in plain(row)

    def with_functions(self, names, row):
        """Coordinates as functions, where one is meant."""
        for name in list(names):
            # a coordinate is a function where it stands in front of one time
            if name.endswith("()") and re.search(rf"{re.escape(name[:-2])}\([t0]\)", plain(row)):
                names[name[:-2]] = names[name]
        return names

    # -- tables

    def table(self, table):
        kinds = {
            ("Parameter", "Meaning", "Domain"): self.domains,
            ("Configuration", "Boundary", "Inside", "Acts when"): self.boundaries,
            ("Condition", "Holds if", "Along"): self.conditions,
            ("Rule", "To", "If", "Reset"): self.rules,
            ("From", "Boundaries", "Rule"): self.events,
            ("From", "Boundary", "To"): self.transitions,
            ("From", "Boundary", "To", "Reset"): self.transitions,
            ("Contact", "Velocity", "Surroundings", "Configuration", "Force"): self.contacts,
        }
        kinds[table.header](table)

    def domains(self, table):
        notation = self.facts.notation
        known = {f"${notation.symbol(p.symbol)}$": p for p in self.parameters}
        for name, _, domain in table.rows:
            parameter = known.pop(name)
            sides, signs = relations_of(read_latex(domain[1:-1]))
            low, high = (float(sp.N(e)) for e in (parameter.lower, parameter.upper))
            for value in (low - 1, low, low + 1e-6, 0.5, high - 1e-6, high, high + 1):
                if not np.isfinite(value):
                    continue
                inside = (value > low or (parameter.closed and value == low)) and (
                    value < high or (parameter.upper_closed and value == high)
                )
                reading = Reading({plain(read_latex(name[1:-1])): value, "ℝ": 0.0, "π": np.pi})
                values = [reading(side) for side in sides]
                related = zip(signs, values, values[1:], strict=False)
                holds = all(sign == "∈" or _holds(sign, a, b) for sign, a, b in related)
                if holds != inside:
                    raise Broken(f"{domain} at {value}")
            self.count += 1
        if known:
            raise Broken(f"not in the table: {list(known)}")

    @property
    def parameters(self):
        return self.facts.system.parameters

    def boundaries(self, table):
        inside = ""
        shown = set()
        for configuration, boundary, formula, acts in table.rows:
            inside = configuration.strip("*") or inside
            declared = self.facts.system.configuration(inside).boundary(boundary.strip("*"))
            left, right = split(read_latex(formula[1:-1]), "<")
            if plain(right) != "0" or acts != declared.acts_when:
                raise Broken(formula)
            self.same([left], [declared.function])
            shown.add((inside, declared.name))
        for name in {name for name, _ in shown}:
            boundaries = self.facts.system.configuration(name).boundaries
            if {b for n, b in shown if n == name} != {b.name for b in boundaries}:
                raise Broken(f"boundaries of {name}")

    def conditions(self, table):
        self.numbered = {}
        for number, text, along in table.rows:
            negated, formula = text.startswith("not "), text.removeprefix("not ")
            value = Reading(self.plain_names)(split(read_latex(formula[1:-1]), ">")[0])
            self.numbered[number] = (value, not negated, along.strip("*"))
            self.count += 1

    def rules(self, table):
        self.outcomes = {}
        rule = ""
        for name, target, conditions, reset in table.rows:
            rule = name or rule
            numbers = re.findall(r"\$C_\{\d+\}\$", conditions)
            self.outcomes.setdefault(rule, []).append((target, numbers, reset))

    def events(self, table):
        source, shown = "", []
        for name, boundaries, rule in table.rows:
            source = name.strip("*") or source
            for together in boundaries.split(", or "):
                shown += [(source, together, *outcome) for outcome in self.outcomes[rule]]
        self.leading(shown)

    def transitions(self, table):
        self.leading((s.strip("*"), b, t, [], *(reset or [""])) for s, b, t, *reset in table.rows)

    def leading(self, shown):
        """From where to where it goes behind which boundaries, in the order that is declared."""
        left = list(self.facts.system.transitions)
        for source, boundaries, target, numbers, reset in shown:
            reached = frozenset(re.findall(r"\*([^*]+)\*", boundaries))
            begun = [t for t in left if (t.source, t.boundaries) == (source, reached)]
            if not begun or f"*{begun[0].target}*" != target:
                raise Broken(f"{source}, {boundaries}, {target}")
            left.remove(begun[0])
            for number, condition in zip(numbers, begun[0].conditions, strict=True):
                value, *others = self.numbered[number]
                declared = self.facts.value(condition.function)
                if not _close(value, declared) or others != [condition.holds, condition.along]:
                    raise Broken(f"{source}, {boundaries}: {number}")
            self.reset(begun[0], reset)
        if left:
            raise Broken(f"transitions that are not shown: {left}")

    def reset(self, transition, text):
        notation = self.facts.notation
        wanted = {name_of(notation.symbol(s)): e for s, e in transition.reset.items()}
        for formula in inline(text):
            left, right = split(read_latex(formula), "=")
            if plain(left[-1:]) != ":":
                raise Broken(formula)
            self.same([right], [wanted.pop(plain(left[:-1]))])
        if wanted:
            raise Broken(f"resets that are not shown: {wanted}")

    def contacts(self, table):
        declared = {c.name: c for c in self.facts.system.contacts}
        name, shown = "", set()
        for contact, velocity, surface, configuration, force in table.rows:
            if contact:
                name = contact.strip("*")
                formulas = [read_latex(f[1:-1]) for f in (velocity, surface)]
                self.same(formulas, [declared[name].velocity, declared[name].surface])
            if force:
                wanted = declared[name].forces[configuration.strip("*")]
                self.same([read_latex(force[1:-1])], [wanted])
                shown.add((name, configuration.strip("*")))
        if shown != {(c.name, f) for c in declared.values() for f in c.forces}:
            raise Broken("forces that are not shown")


def parts_of(row):
    """What a formula says, relation by relation."""
    items = list(row)
    while items and items[-1] in (Atom(".", "sign"), Atom(",", "sign")):
        items.pop()
    found = []
    begun = []
    pieces = split(tuple(items), ",")
    for piece in pieces:
        spaced = bool(piece) and isinstance(piece[0], Atom) and piece[0].kind == "space"
        if begun and spaced:
            found.append(tuple(begun))
            begun = []
        begun += ([Atom(",", "sign")] if begun else []) + list(piece)
    return [without_spaces(part) for part in (*found, tuple(begun)) if without_spaces(part)]


def relations_of(row):
    """Sides and signs of a chain of relations."""
    sides, signs = divided(row, _RELATIONS)
    return [without_spaces(side) for side in sides], signs


def is_name(row):
    """Whether a formula is one name, which says nothing that could be false."""
    core = core_of(row[0]) if len(row) == 1 else None
    return isinstance(core, Accent) or getattr(core, "kind", "") in ("letter", "upright")


def _condition(row):
    for place, item in enumerate(row):
        if isinstance(item, Atom) and item.kind == "text":
            return without_spaces(row[:place]), without_spaces(_condition(row[place + 1 :])[0])
    return row, ()


def _all_items(row):
    for item in row:
        yield item
        for value in vars(item).values():
            yield from _deep(value)


def _deep(value):
    if isinstance(value, tuple):
        for part in value:
            yield from _deep(part)
    elif not isinstance(value, str):
        yield from _all_items((value,))


def _close(a, b):
    for one, other in ((a, b), (b, a)):
        if isinstance(one, Unit):
            return _close(one.of(len(np.atleast_2d(other))), other)
    a, b = np.asarray(a), np.asarray(b)
    if a.size == 1 and b.size > 1:
        a, b = b, a
    if a.size > 1 and b.size == 1:
        return bool(b.ravel()[0] == 0 and np.allclose(a, 0, atol=1e-9))
    if a.size == 1:
        a, b = a.ravel(), b.ravel()
    return a.shape == b.shape and np.allclose(a, b, rtol=1e-9, atol=1e-9)


def _holds(sign, a, b):
    return bool({"=": a == b, "<": a < b, ">": a > b, "≤": a <= b, "≥": a >= b}[sign])
