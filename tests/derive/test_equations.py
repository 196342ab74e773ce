"""Equations of periodic orbits: square, right from every start, with the right derivatives.

Every law is checked on the emitted kernels of orbits of the built-in systems, and of systems that
only this file declares; the Poincare map is computed a second time, by matrix exponentials and
root finding.
"""

import ctypes
import random
from dataclasses import dataclass
from functools import cache, cached_property

import numpy as np
import pytest
import sympy as sp

from nonsmooth.derive import (
    Boundary,
    Configuration,
    DerivationError,
    Itinerary,
    Parameter,
    SecondOrder,
    System,
    Transition,
    derive_equations,
    dry_friction,
)
from nonsmooth.derive.codegen.emit import emit_library
from nonsmooth.derive.codegen.kernels import orbit_kernels, spectrum_kernel
from nonsmooth.runtime.core.arithmetic import Mpmath
from tests.compiled_c import executed, library_of, needs_compiler, pointer
from tests.declared import elastic_stop, rigid_stop
from tests.tables import slow

LIB = Mpmath(60)
MP = LIB.mp
X, Y, V, W = sp.symbols("x y v w", real=True)


# --- systems that only the tests declare ------------------------------------------------


def regime(name, exit_by, function, stiffness, load=(), **held):
    """Unit masses on springs, left through one boundary; `x=1` holds x at the velocity 1."""
    mass = sp.eye(len(sp.Matrix(stiffness).col(0)))
    kept = {sp.Symbol(n, real=True): v for n, v in held.items()}
    boundary = Boundary(
        exit_by, function, "reached" if exit_by in ("caught", "wall") else "exceeded"
    )
    return Configuration(name, SecondOrder(mass, stiffness, load, held=kept), (boundary,))


def looped(
    declared,
    one,
    other,
    *resets,
):
    """Two regimes one after the other, with a reset behind each."""
    ends = [(c.name, c.boundaries[0].name) for c in (one, other)]
    transitions = tuple(
        Transition(name, {end}, target.name, (), reset)
        for (name, end), target, reset in zip(ends, (other, one), resets, strict=True)
    )
    states = (X, Y, V, W) if one.dynamics.mass.rows == 2 else (X, V)
    system = System("looped", "", states, tuple(declared), (one, other), transitions)
    phases = [(*end, dwell) for end, dwell in zip(ends, ("ta", "tb"), strict=True)]
    return Itinerary("loop", system, phases)


def parameters(names):
    """Positive parameters and their symbols; a restitution r is below one."""
    declared = [Parameter(n, n, upper=1 if n == "r" else sp.oo) for n in names.split()]
    return declared, [p.symbol for p in declared]


def belt():
    """One mass on a belt: sticks until its spring breaks it loose, slips until it is caught."""
    declared, (s, u, e) = parameters("speed slipping excess")
    stick = regime("stick", "breaks", X - u - e, [[1]], x=s)
    return looped(declared, stick, regime("slip", "caught", V - s, [[1]], (u,)), {}, {V: s})


def bounce():
    """A mass on a spring, pushed by a constant force where x < 0, against a wall at x = 1."""
    declared, (r, k, p) = parameters("r kick push")
    spring, pushed = (
        regime("spring", "leaves", -X, [[1]]),
        regime("pushed", "wall", X - 1, [[0]], (p,)),
    )
    return looped(declared, spring, pushed, {}, {V: -r * V - k})


def clock():
    """A spring that a clock (the second coordinate, thrown up each time) switches off."""
    declared, (r, k) = parameters("r kick")
    spring = regime("spring", "rings", -Y, [[1, 0], [0, 0]], (0, -2))
    pushed = regime("pushed", "wall", X - 1, [[0, 0], [0, 0]], (1, -2))
    return looped(declared, spring, pushed, {}, {V: -r * V - k, Y: 0, W: 1})


def pair():
    """The mass on the belt, coupled to a second one that swings freely; no map in one variable."""
    declared, (s, u, e, k) = parameters("speed slipping excess k")
    stiffness = [[1 + k, -k], [-k, 2 + k]]
    stick = regime("stick", "breaks", (1 + k) * X - k * Y - u - e, stiffness, x=s)
    slip = regime("slip", "caught", V - s, stiffness, (u, 0))
    return looped(declared, stick, slip, {}, {V: s})


def bilinear():
    """Two springs, one on each side; the mass loses speed and is kicked on the way down."""
    declared, (k, r, c) = parameters("k r kick")
    right, left = regime("right", "down", -X, [[1]]), regime("left", "up", X, [[k]])
    return looped(declared, right, left, {V: r * V - c}, {})


@dataclass(frozen=True)
class Example:
    """An itinerary, a parameter point and a guess of its orbit there."""

    itinerary: object
    point: dict
    guess: dict


def known(itinerary):
    """A declared itinerary at its own reference point."""
    point = {n: str(number(sp.sympify(t), {})) for n, t in itinerary.reference.parameters.items()}
    return Example(lambda: itinerary, point, dict(itinerary.reference.guess))


def number(expression, known):
    """An expression of the declaration as a number."""
    expression = sp.sympify(expression)
    symbols = sorted(expression.free_symbols, key=str)
    value = sp.lambdify(symbols, expression, {"pi": MP.pi, "mpf": MP.mpf, "sqrt": MP.sqrt})
    return MP.mpf(value(*(known[s] for s in symbols)))


def table(matrix, known):
    """A matrix of the declaration in numbers."""
    return MP.matrix([[number(e, known) for e in row] for row in sp.Matrix(matrix).tolist()])


EXAMPLES = {
    "dry-friction": known(dry_friction.global_stick),
    "symmetric": known(dry_friction.symmetric),
    "solution-ii": known(dry_friction.solution_ii),
    "one-impact": known(rigid_stop.one_impact),
    "one-contact": known(elastic_stop.one_contact),
    "belt": Example(
        belt,
        {"speed": "0.9", "slipping": "0.3", "excess": "0.4"},
        {"x0": "-0.1", "ta": "0.9", "tb": "5.4"},
    ),
    "bounce": Example(
        bounce, {"r": "0.6", "kick": "0.5", "push": "2"}, {"v0": "-2", "ta": "0.5", "tb": "2.4"}
    ),
    "clock": Example(clock, {"r": "0.6", "kick": "0.5"}, {"v0": "-2", "ta": "1", "tb": "4.6"}),
    "pair": Example(
        pair,
        {"speed": "0.9", "slipping": "0.3", "excess": "0.4", "k": "0.15"},
        {"x0": "-0.1", "y0": "0", "w0": "0", "ta": "0.9", "tb": "5.4"},
    ),
    "bilinear": Example(
        bilinear, {"k": "3", "r": "0.6", "kick": "0.5"}, {"v0": "1.2", "ta": "3", "tb": "1.8"}
    ),
}


# --- kernels, run in mpmath -------------------------------------------------------------


class Derived:
    """The emitted kernels of one orbit, at high precision."""

    def __init__(self, itinerary):
        self.orbit = derive_equations(itinerary)
        kernels = (spectrum_kernel(self.orbit.spectrum), *orbit_kernels(self.orbit))
        self._found = {o.name: (k, i) for k in kernels for i, o in enumerate(k.outputs)}
        self._functions = {}

    @property
    def names(self):
        return [str(p) for p in self.orbit.parameters]

    def run(self, name, values, unknowns=()):
        """One result at parameters, and at unknowns or the reduced ones."""
        kernel, place = self._found[name]
        if kernel.name not in self._functions:
            self._functions[kernel.name] = executed(kernel)
        point = {"parameters": values, "unknowns": unknowns, "reduced": unknowns}
        if kernel.name != "spectrum":
            own = [values[self.names.index(str(p))] for p in self.orbit.spectrum.parameters]
            point |= {"spectrum": self.run("spectrum", own)}
            point |= {"spectrum_derivatives": self.run("spectrum_derivatives", own)}
        given = [point[a.name] for a in kernel.arguments if a.since <= place]
        first = {"outputs": place + 1} if len(kernel.outputs) > 1 else {}
        found = self._functions[kernel.name](*given, lib=LIB, **first)
        return found[place] if place else found

    def solved(self, values, guess):
        """Newton's method at sixty digits."""
        unknowns = MP.matrix(list(guess))
        for _ in range(60):
            residual, jacobian = (
                MP.matrix(self.run(name, values, list(unknowns)))
                for name in ("residual", "jacobian")
            )
            step = MP.lu_solve(jacobian, residual)
            largest = max(abs(s) for s in step)
            unknowns -= step * min(MP.mpf(1), MP.mpf("0.5") / largest)
            if largest < MP.mpf(10) ** -50:
                return list(unknowns)
        raise AssertionError("Newton's method does not converge")


class Solved:
    """An example derived from one of its phases on, with its orbit."""

    def __init__(self, name, rotation=0):
        example = EXAMPLES[name]
        self.derived = Derived(example.itinerary().rotated(rotation))
        self.orbit = orbit = self.derived.orbit
        self.itinerary = orbit.itinerary  # with the values that the orbit requires
        self.values = [MP.mpf(example.point[n]) for n in self.derived.names]
        symbols = [str(u) for u in orbit.unknowns]
        if rotation == 0:
            guess = [MP.mpf(example.guess[n]) for n in symbols]
        else:
            base, start = solved(name), orbit.chain.start
            known = {str(s): v for s, v in base.known.items()} | base.dwell_times
            known |= {
                str(q): base.states[rotation][i]
                for q, i in zip(start.coordinates, start.places, strict=True)
            }
            # moved away, so that the solution is found and not copied
            source = random.Random(rotation)
            guess = [known[n] + MP.mpf(source.uniform(-1, 1)) / 1000 for n in symbols]
        self.unknowns = self.derived.solved(self.values, guess)

    def at(self, name):
        """A result of the kernels at the orbit."""
        return self.derived.run(name, self.values, self.unknowns)

    @cached_property
    def known(self):
        """Numbers of all parameters, those that are solved for too, and of the unknowns."""
        orbit = self.orbit
        found = dict(zip(orbit.parameters, self.values, strict=True))
        found |= dict(zip(orbit.unknowns, self.unknowns, strict=True))
        # what the equations leave open shows in no field, normal or reset of these phases
        return {p.symbol: MP.mpf(0) for p in orbit.system.parameters} | found

    @cached_property
    def dwell_times(self):
        links = self.orbit.chain.links
        return {str(link.dwell): number(link.duration, self.known) for link in links}

    @cached_property
    def states(self):
        """State at the start and behind every transition."""
        return self.at("states")

    @property
    def reduced(self):
        """Unknowns of the reduced equations."""
        known = {str(s): v for s, v in self.known.items()} | self.dwell_times
        for index, state in enumerate(self.states):
            for symbol, value in zip(self.orbit.system.states, state, strict=True):
                known.setdefault(f"{symbol}_{index}", value)
        return [known[str(u)] for u in self.orbit.reduction.unknowns]

    @cached_property
    def poincare(self):
        return MP.matrix(self.at("poincare_jacobian") or 0)

    def multipliers(self):
        size = self.poincare.rows
        found = MP.eig(self.poincare, left=False, right=False) if size > 1 else list(self.poincare)
        large = [m for m in found if abs(m) > MP.mpf(10) ** -20]
        # a complex pair has one real part, but for rounding
        return sorted(large, key=lambda m: (MP.nint(MP.re(m) * 10**20), MP.im(m)))


@cache
def solved(name, rotation=0):
    return Solved(name, rotation)


# two masses take long: the starts from which they are derived by other code
STARTS = {"symmetric": [0], "one-contact": [0], "dry-friction": [0, 2], "solution-ii": [0, 2]}
every_start = pytest.mark.parametrize(
    ("name", "rotation"),
    [
        slow(name, k, when=name in (*STARTS, "pair"))
        for name, example in EXAMPLES.items()
        for k in STARTS.get(name, range(len(example.itinerary().phases)))
    ],
)


def close(found, expected, digits):
    pairs = (
        [*zip(found, expected, strict=True)] if hasattr(found, "__len__") else [(found, expected)]
    )
    return all(abs(a - b) <= MP.mpf(10) ** -digits * max(1, abs(b)) for a, b in pairs)


def has_slopes(found, function, at):
    """Whether a matrix has the central differences of a function, whose error is some 1e-30."""
    h = MP.mpf(10) ** -15
    rates = []
    for place, x in enumerate(at):
        above, below = (function([*at[:place], x + s, *at[place + 1 :]]) for s in (h, -h))
        rates.append([(a - b) / (2 * h) for a, b in zip(above, below, strict=True)])
    columns = zip(*found, strict=True)
    return all(close(a, b, 25) for a, b in zip(columns, rates, strict=True))


# --- every start of the cycle -----------------------------------------------------------


@every_start
def test_every_start_gives_the_same_orbit_and_multipliers(name, rotation):
    base, turned = solved(name), solved(name, rotation)
    assert len(turned.orbit.equations) == len(turned.orbit.unknowns)
    for dwell_time, value in base.dwell_times.items():
        assert close(turned.dwell_times[dwell_time], value, 45)
        assert value > 0 or dwell_time in turned.itinerary.vanishing
    count = len(base.dwell_times)
    for index in range(count):
        assert close(turned.states[index], base.states[(index + rotation) % count], 45)
    # and it closes, also in the coordinates that no equation closes
    assert close(turned.states[-1], turned.states[0], 45)
    assert close(turned.multipliers(), base.multipliers(), 30)
    poincare = turned.poincare
    assert close(turned.at("trace"), sum((poincare[i, i] for i in range(poincare.rows)), 0), 40)


@pytest.mark.parametrize("name", ["bounce", "clock", "bilinear"])
def test_the_monodromy_matrix_keeps_the_field_and_has_all_multipliers(name):
    example = solved(name)
    states = example.orbit.system.states
    matrix, offset = example.orbit.chain.links[0].configuration.dynamics.field(states)
    field = table(matrix, example.known) * MP.matrix(example.states[0]) + table(
        offset, example.known
    )
    monodromy = MP.matrix(example.at("monodromy"))
    assert MP.norm(monodromy * field - field, MP.inf) < MP.mpf(10) ** -45
    for multiplier in (*example.multipliers(), 1):
        assert abs(MP.det(monodromy - multiplier * MP.eye(len(states)))) < MP.mpf(10) ** -25


# --- the solver in C --------------------------------------------------------------------


@pytest.mark.slow
@needs_compiler
def test_c_tells_of_a_dwell_time_that_is_negative(tmp_path):
    """Though it is no unknown: the period's rest."""
    example = solved("one-contact")
    for file, text in emit_library(elastic_stop.system, elastic_stop.orbits, "tests").items():
        (tmp_path / file).write_text(text, encoding="utf-8")
    library = library_of(tmp_path / "elastic_stop.c", include=tmp_path)
    values = dict(m1=1, m2=2, k1=1, k2=5, k3=1, T=6)
    point, guess = np.array([float(values[n]) for n in example.derived.names]), np.array([24.4])
    unknowns, trace, largest = np.zeros(len(example.unknowns)), np.zeros(1), np.zeros(1)
    steps, status = np.zeros((2, 1), np.int32)
    arrays = (point, guess, unknowns, trace, largest, steps, status)
    library.elastic_stop_one_contact_solve(ctypes.c_ssize_t(1), *map(pointer, arrays))
    assert status == 3
    assert unknowns[-1] > 6


# --- derivatives ------------------------------------------------------------------------


def check_jacobians(run, values, at):
    assert has_slopes(run("jacobian", values, at), lambda u: run("residual", values, u), at)
    moved = run("parameter_jacobian", values, at)
    assert has_slopes(moved, lambda p: run("residual", p, at), values)


@every_start
def test_derivatives_against_differences(name, rotation):
    """Total ones by the parameters, and those of the spectrum, on which they rest."""
    example = solved(name, rotation)
    run, values, source = example.derived.run, example.values, random.Random(rotation)
    at = [u * (1 + MP.mpf(source.uniform(-0.05, 0.05))) for u in example.unknowns]
    check_jacobians(run, values, at)
    gradient = run("trace_gradient", values, at)
    assert has_slopes([gradient[: len(at)]], lambda u: [run("trace", values, u)], at)
    assert has_slopes([gradient[len(at) :]], lambda p: [run("trace", p, at)], values)
    own = [example.known[p] for p in example.orbit.spectrum.parameters]
    assert has_slopes(run("spectrum_derivatives", own), lambda p: run("spectrum", p), own)


# --- the Poincare map, a second time ----------------------------------------------------


def affine(functions, states, last=1):
    """Matrix of affine functions of the state and 1, below which stands that of 1."""
    column = sp.Matrix(functions)
    rows = column.jacobian(states).row_join(column.subs(dict.fromkeys(states, 0)))
    return rows.col_join(sp.Matrix([[0] * len(states) + [last]]))


class Independent:
    """Flow by matrix exponentials, exits by Newton's method on time, resets as declared."""

    def __init__(self, example):
        system, phases = example.orbit.system, example.itinerary.phases
        states = system.states
        self.pieces = []
        for phase, following in zip(phases, [*phases[1:], phases[0]], strict=True):
            configuration = system.configuration(phase.configuration)
            matrix, offset = configuration.dynamics.field(states)
            field = affine(matrix * sp.Matrix(states) + offset, states, last=0)
            boundary = affine([configuration.boundary(phase.boundary).function], states)[0, :]
            names = phase.configuration, phase.boundary, following.configuration
            reset = dict(system.transition(*names).reset)
            jump = affine([sp.sympify(reset.get(s, s)) for s in states], states)
            numbers = (table(part, example.known) for part in (field, boundary, jump))
            self.pieces.append((*numbers, example.dwell_times[phase.dwell_time]))

    def image(self, state):
        """State after one turn; each exit is the one nearest to the orbit's own."""
        y = MP.matrix([*state, 1])
        for field, normal, jump, time in self.pieces:
            end = MP.expm(field * time) * y
            for _ in range(8):
                step = -(normal * end)[0] / (normal * (field * end))[0]
                # an exponential of a small matrix is a short series
                term = end
                for order in range(1, 12):
                    term = field * term * step / order
                    end += term
                if abs(step) < MP.mpf(10) ** -53:
                    break
            assert abs(step) < MP.mpf(10) ** -40
            y = jump * end
        return list(y)[: len(state)]


@every_start
def test_orbit_and_poincare_jacobian_against_an_independent_map(name, rotation):
    example = solved(name, rotation)
    second, section = Independent(example), example.orbit.chain.section
    start = example.states[0]
    assert close(second.image(start), start, 40)
    if not section.dimension:
        return
    embedding = table(section.embedding, example.known)

    def image(moved):
        found = second.image(list(MP.matrix(start) + embedding * MP.matrix(moved)))
        return [found[place] for place in section.places]

    assert has_slopes(example.poincare.tolist(), image, [MP.mpf(0)] * section.dimension)


# --- the reduction ----------------------------------------------------------------------


@every_start
def test_the_reduced_equations_have_the_same_orbit(name, rotation):
    example = solved(name, rotation)
    run, values, reduction = example.derived.run, example.values, example.orbit.reduction
    assert len(reduction.equations) == len(reduction.unknowns)
    point = example.reduced
    assert close(run("unknowns", values, point), example.unknowns, 45)
    if point:
        assert close(run("reduced_residual", values, point), [0] * len(point), 45)
        source = random.Random(rotation)
        at = [p * (1 + MP.mpf(source.uniform(-0.02, 0.02))) for p in point]
        jacobian = run("reduced_jacobian", values, at)
        assert has_slopes(jacobian, lambda u: run("reduced_residual", values, u), at)


# --- refusals ---------------------------------------------------------------------------


@pytest.mark.parametrize("reset", [{}, {X: 2 * X}], ids=["no reset", "a reset"])
def test_a_start_that_no_state_satisfies_is_refused(reset):
    slip, stick = regime("slip", "far", X - 1, [[1]]), regime("stick", "fast", V - 2, [[1]], x=1)
    with pytest.raises(DerivationError, match="'loop': its start satisfies no state"):
        derive_equations(looped([], slip, stick, {}, reset))
