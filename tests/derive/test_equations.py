"""Equations of periodic orbits: square, right from every start, with the right derivatives.

Every law is checked on orbits of the dry-friction system and of systems that only this file
declares; the Poincare map is computed a second time, by matrix exponentials and root finding.
"""

from __future__ import annotations

import ctypes
import random
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp

from nonsmooth.derive import (
    Boundary,
    Configuration,
    DerivationError,
    EquationSystem,
    Itinerary,
    Parameter,
    Phase,
    SecondOrder,
    System,
    Transition,
    derive_equations,
)
from nonsmooth.derive.codegen.any_arithmetic import python_kernel
from nonsmooth.derive.codegen.emit import emit_library
from nonsmooth.derive.codegen.kernels import spectrum_kernel
from nonsmooth.derive.codegen.naming import c_function
from nonsmooth.derive.equations.explicit import RETURN, Angle, explicit_time
from nonsmooth.derive.equations.linearisation import monodromy
from nonsmooth.derive.equations.program import Argument, Kernel, Output, Stage, prune
from nonsmooth.derive.flows.modal import TIME
from nonsmooth.derive.symbols import derivative
from nonsmooth.derive.systems import dry_friction, elastic_stop, rigid_stop
from nonsmooth.runtime.core.arithmetic import Mpmath
from tests.compiled_c import library_of, needs_compiler, pointer

LIB = Mpmath(60)
MP = LIB.mp
X, Y, V, W = sp.symbols("x y v w", real=True)


# --- systems that only the tests declare ------------------------------------------------


def parameters(*names: str, **upper: Any) -> list[Parameter]:
    return [Parameter(n, n, upper=upper.get(n, sp.oo)) for n in names]


def regime(
    name: str, exit_by: str, function: sp.Expr, stiffness: Any, load: Any = (), **held: Any
) -> Configuration:
    """Unit masses on springs, left through one boundary; `x=1` holds x at the velocity 1."""
    mass = sp.eye(len(sp.Matrix(stiffness).col(0)))
    kept = {sp.Symbol(n, real=True): v for n, v in held.items()}
    boundary = Boundary(
        exit_by, function, "reached" if exit_by in ("caught", "wall") else "exceeded"
    )
    return Configuration(name, SecondOrder(mass, stiffness, load, held=kept), (boundary,))


def belt() -> Itinerary:
    """One mass on a belt: sticks until its spring breaks it loose, slips until it is caught."""
    speed, slipping, excess = declared = parameters("speed", "slipping", "excess")
    s, u, e = (p.symbol for p in declared)
    system = System(
        "belt", "one mass on a belt", (X, V), (speed, slipping, excess),
        (
            regime("stick", "breaks", X - u - e, [[1]], x=s),
            regime("slip", "caught", V - s, [[1]], (u,)),
        ),
        (
            Transition("stick", {"breaks"}, "slip"),
            Transition("slip", {"caught"}, "stick", (), {V: s}),
        ),
    )  # fmt: skip
    return Itinerary(
        "loop", system, (Phase("stick", "breaks", "ts"), Phase("slip", "caught", "tf"))
    )


def bounce() -> Itinerary:
    """A mass on a spring, pushed by a constant force where x < 0, against a wall at x = 1."""
    restitution, kick, push = declared = parameters("r", "kick", "push", r=1)
    r, k, p = (d.symbol for d in declared)
    system = System(
        "bounce", "a wall that kicks", (X, V), (restitution, kick, push),
        (
            regime("spring", "leaves", -X, [[1]]),
            regime("pushed", "wall", X - 1, [[0]], (p,)),
        ),
        (
            Transition("spring", {"leaves"}, "pushed"),
            Transition("pushed", {"wall"}, "spring", (), {V: -r * V - k}),
        ),
    )  # fmt: skip
    return Itinerary(
        "loop", system, (Phase("spring", "leaves", "ta"), Phase("pushed", "wall", "tb"))
    )


def clock() -> Itinerary:
    """A spring that a clock (the second coordinate, thrown up each time) switches off."""
    restitution, kick = declared = parameters("r", "kick", r=1)
    r, k = (d.symbol for d in declared)
    system = System(
        "clock", "a clock switches the spring", (X, Y, V, W), (restitution, kick),
        (
            regime("spring", "rings", -Y, [[1, 0], [0, 0]], (0, -2)),
            regime("pushed", "wall", X - 1, [[0, 0], [0, 0]], (1, -2)),
        ),
        (
            Transition("spring", {"rings"}, "pushed"),
            Transition("pushed", {"wall"}, "spring", (), {V: -r * V - k, Y: 0, W: 1}),
        ),
    )  # fmt: skip
    return Itinerary(
        "loop", system, (Phase("spring", "rings", "ta"), Phase("pushed", "wall", "tb"))
    )


def pair() -> Itinerary:
    """The mass on the belt, coupled to a second one that swings freely; no map in one variable."""
    speed, slipping, excess, coupling = declared = parameters("speed", "slipping", "excess", "k")
    s, u, e, k = (p.symbol for p in declared)
    stiffness = [[1 + k, -k], [-k, 2 + k]]
    spring = (1 + k) * X - k * Y
    system = System(
        "pair", "two masses, one on a belt", (X, Y, V, W), (speed, slipping, excess, coupling),
        (
            regime("stick", "breaks", spring - u - e, stiffness, x=s),
            regime("slip", "caught", V - s, stiffness, (u, 0)),
        ),
        (
            Transition("stick", {"breaks"}, "slip"),
            Transition("slip", {"caught"}, "stick", (), {V: s}),
        ),
    )  # fmt: skip
    return Itinerary(
        "loop", system, (Phase("stick", "breaks", "ts"), Phase("slip", "caught", "tf"))
    )


def bilinear() -> Itinerary:
    """Two springs, one on each side; the mass loses speed and is kicked on the way down."""
    left, restitution, kick = declared = parameters("k", "r", "kick", r=1)
    k, r, c = (d.symbol for d in declared)
    system = System(
        "bilinear", "two springs", (X, V), (left, restitution, kick),
        (
            regime("right", "down", -X, [[1]]),
            regime("left", "up", X, [[k]]),
        ),
        (
            Transition("right", {"down"}, "left", (), {V: r * V - c}),
            Transition("left", {"up"}, "right"),
        ),
    )  # fmt: skip
    return Itinerary("loop", system, (Phase("right", "down", "ta"), Phase("left", "up", "tb")))


def known(itinerary: Itinerary) -> Example:
    """A declared itinerary at its own reference point."""
    point = {n: str(number(sp.sympify(t), {})) for n, t in itinerary.reference.parameters.items()}
    return Example(lambda: itinerary, point, dict(itinerary.reference.guess))


@dataclass(frozen=True)
class Example:
    """An itinerary, a parameter point and a guess of its orbit there."""

    itinerary: Callable[[], Itinerary]
    point: dict[str, str]
    guess: dict[str, str]


def number(expression: sp.Expr, known: dict[sp.Symbol, Any]) -> Any:
    """An expression of the declaration as a number."""
    expression = sp.sympify(expression)
    symbols = sorted(expression.free_symbols, key=str)
    value = sp.lambdify(symbols, expression, {"pi": MP.pi, "mpf": MP.mpf, "sqrt": MP.sqrt})
    return MP.mpf(value(*(known[s] for s in symbols)))


EXAMPLES = {
    "dry-friction": known(dry_friction.global_stick),
    "symmetric": known(dry_friction.symmetric),
    "solution-ii": known(dry_friction.solution_ii),
    "one-impact": known(rigid_stop.one_impact),
    "one-contact": known(elastic_stop.one_contact),
    "belt": Example(
        belt,
        {"speed": "0.9", "slipping": "0.3", "excess": "0.4"},
        {"x0": "-0.1", "ts": "0.9", "tf": "5.4"},
    ),
    "bounce": Example(
        bounce, {"r": "0.6", "kick": "0.5", "push": "2"}, {"v0": "-2", "ta": "0.5", "tb": "2.4"}
    ),
    "clock": Example(clock, {"r": "0.6", "kick": "0.5"}, {"v0": "-2", "ta": "1", "tb": "4.6"}),
    "pair": Example(
        pair,
        {"speed": "0.9", "slipping": "0.3", "excess": "0.4", "k": "0.15"},
        {"x0": "-0.1", "y0": "0", "w0": "0", "ts": "0.9", "tf": "5.4"},
    ),
    "bilinear": Example(
        bilinear, {"k": "3", "r": "0.6", "kick": "0.5"}, {"v0": "1.2", "ta": "3", "tb": "1.8"}
    ),
}


# --- kernels, run in mpmath -------------------------------------------------------------


class Derived:
    """The emitted functions of one orbit, at high precision, by name."""

    def __init__(self, itinerary: Itinerary) -> None:
        self.orbit: EquationSystem = derive_equations(itinerary)
        o, namespace = self.orbit, {}
        exec(python_kernel(spectrum_kernel(o.spectrum), None), namespace)
        self._spectrum = namespace["spectrum"]
        derivatives = [derivative(s, p) for s in o.spectrum.symbols for p in o.spectrum.parameters]
        self._arguments = (
            Argument("parameters", (len(o.parameters),), o.parameters),
            Argument("spectrum", (len(o.spectrum.symbols),), o.spectrum.symbols),
            Argument("derivatives", (len(derivatives),), tuple(derivatives)),
        )
        self._functions: dict[str, Callable[..., Any]] = {}

    @property
    def names(self) -> list[str]:
        return [str(p) for p in self.orbit.parameters]

    def spectrum(self, values: Sequence[Any]) -> tuple[list[Any], list[Any]]:
        places = [self.names.index(str(p)) for p in self.orbit.spectrum.parameters]
        found, derivatives = self._spectrum([values[i] for i in places], lib=LIB)
        return found, [d for row in derivatives for d in row]

    def run(self, name: str, values: Sequence[Any], unknowns: Sequence[Any]) -> list[Any]:
        """One kernel at parameters and unknowns; matrices come row by row."""
        if name not in self._functions:
            symbols, stages, outputs = self._content(name)
            kernel = Kernel(
                name, "", (*self._arguments, Argument("unknowns", (len(symbols),), tuple(symbols))),
                (Output("found", (len(outputs),), tuple(outputs)),), prune(stages, outputs),
            )  # fmt: skip
            namespace: dict[str, Any] = {}
            exec(python_kernel(kernel, None), namespace)
            self._functions[name] = namespace[name]
        return [
            MP.mpf(e)
            for e in self._functions[name](values, *self.spectrum(values), unknowns, lib=LIB)
        ]

    def _content(self, name: str) -> tuple[Sequence[sp.Symbol], Sequence[Stage], list[sp.Expr]]:
        o = self.orbit
        chain, reduction = o.chain.stages, o.reduction
        if name == "residual":
            return o.unknowns, o.stages, o.residual
        if name == "states":
            rows = [o.chain.links[0].before, *(link.following for link in o.chain.links)]
            return o.unknowns, chain, [e for row in rows for e in row]
        if name in ("jacobian", "parameter_jacobian", "poincare_jacobian"):
            program = "map_program" if name == "poincare_jacobian" else f"{name}_program"
            stages, matrix = getattr(o, program)
            base = chain if name == "poincare_jacobian" else o.stages
            return o.unknowns, (*base, *stages), list(matrix)
        if name == "trace":
            return o.unknowns, o.trace_program.stages, [o.trace]
        if name == "trace_gradient":
            stages, entries = o.trace_gradient_program
            return o.unknowns, stages, [sp.sympify(e) for e in entries]
        if name == "monodromy":
            first = o.chain.links[0]
            stages, matrix = monodromy(o.chain)
            velocity = first.flow.velocity(first.before)
            return o.unknowns, (*chain, *stages), [*matrix, *velocity]
        if name == "reduced":
            return reduction.unknowns, reduction.stages, [e for _, e in reduction.equations]
        if name == "reduced_jacobian":
            stages, matrix = reduction.jacobian()
            return reduction.unknowns, (*reduction.stages, *stages), list(matrix)
        assert name == "expand"
        return reduction.unknowns, reduction.stages, [reduction.values[u] for u in o.unknowns]

    def matrix(self, name: str, values: Sequence[Any], unknowns: Sequence[Any]) -> Any:
        """A kernel's matrix; its number of columns is that of the section or the unknowns."""
        entries = self.run(name, values, unknowns)
        o = self.orbit
        columns = {
            "jacobian": len(o.unknowns),
            "parameter_jacobian": len(o.parameters),
            "poincare_jacobian": o.chain.section.dimension,
            "reduced_jacobian": len(o.reduction.unknowns),
        }[name]
        rows = len(entries) // columns if columns else 0
        return MP.matrix(rows, columns) if not rows else MP.matrix(
            [entries[i * columns : (i + 1) * columns] for i in range(rows)]
        )  # fmt: skip

    def solved(self, values: Sequence[Any], guess: Sequence[Any]) -> list[Any]:
        """Newton's method at sixty digits."""
        unknowns = MP.matrix(list(guess))
        for _ in range(60):
            residual = MP.matrix(self.run("residual", values, list(unknowns)))
            step = MP.lu_solve(self.matrix("jacobian", values, list(unknowns)), residual)
            largest = max(abs(s) for s in step)
            unknowns -= step * min(MP.mpf(1), MP.mpf("0.5") / largest)
            if largest < MP.mpf(10) ** -50:
                return list(unknowns)
        raise AssertionError("Newton's method does not converge")


class Solved:
    """An example derived from one of its phases on, with its orbit."""

    def __init__(self, name: str, rotation: int = 0) -> None:
        example = EXAMPLES[name]
        self.derived = Derived(example.itinerary().rotated(rotation))
        orbit = self.derived.orbit
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

    @property
    def section(self) -> Any:
        return self.derived.orbit.chain.section

    @cached_property
    def known(self) -> dict[sp.Symbol, Any]:
        """Numbers of all parameters, those that are solved for too, and of the unknowns."""
        orbit = self.derived.orbit
        found = dict(zip(orbit.parameters, self.values, strict=True))
        found |= dict(zip(orbit.unknowns, self.unknowns, strict=True))
        # what the equations leave open shows in no field, normal or reset of these phases
        return {p.symbol: MP.mpf(0) for p in orbit.system.parameters} | found

    @cached_property
    def dwell_times(self) -> dict[str, Any]:
        links = self.derived.orbit.chain.links
        return {str(link.dwell): number(link.duration, self.known) for link in links}

    @cached_property
    def states(self) -> list[list[Any]]:
        """State at the start and behind every transition."""
        entries = self.derived.run("states", self.values, self.unknowns)
        size = len(self.derived.orbit.system.states)
        return [entries[i : i + size] for i in range(0, len(entries), size)]

    @property
    def reduced(self) -> list[Any]:
        """Unknowns of the reduced equations."""
        orbit = self.derived.orbit
        known = {str(s): v for s, v in self.known.items()} | self.dwell_times
        for index, state in enumerate(self.states):
            for symbol, value in zip(orbit.system.states, state, strict=True):
                known.setdefault(f"{symbol}_{index}", value)
        return [known[str(u)] for u in orbit.reduction.unknowns]

    @cached_property
    def poincare(self) -> Any:
        return self.derived.matrix("poincare_jacobian", self.values, self.unknowns)

    def multipliers(self) -> list[Any]:
        if not self.poincare.rows:
            return []
        found = (
            [self.poincare[0]]
            if self.poincare.rows == 1
            else MP.eig(self.poincare, left=False, right=False)
        )
        large = [m for m in found if abs(m) > MP.mpf(10) ** -20]
        # a complex pair has one real part, but for rounding
        return sorted(large, key=lambda m: (MP.nint(MP.re(m) * 10**20), MP.im(m)))


@cache
def solved(name: str, rotation: int = 0) -> Solved:
    return Solved(name, rotation)


def rotations(name: str) -> range:
    return range(len(EXAMPLES[name].itinerary().phases))


# two masses take long: of these orbits few are not slow, and only from their own start
LARGE = ("dry-friction", "symmetric", "solution-ii", "one-contact", "pair")
# of the declared orbits one rotation is enough for derivatives
DECLARED = ("symmetric", "solution-ii", "one-impact", "one-contact")


def started(*quick: str, other: tuple[str, ...] = ()) -> list[Any]:
    """Give each example with each start, of `other` ones with the first alone."""
    return [
        pytest.param(name, k, marks=[pytest.mark.slow] if name in LARGE and slow else [])
        for name in EXAMPLES
        for k in rotations(name)[: 1 if name in other else None]
        for slow in [k > 0 or name not in quick]
    ]


EVERY = started("dry-friction", "one-contact", "pair")
MOST = started("dry-friction", "pair", other=DECLARED)


def close(found: Any, expected: Any, digits: int) -> bool:
    return bool(abs(found - expected) <= MP.mpf(10) ** -digits * max(1, abs(expected)))


def slope(function: Callable[[Any], Sequence[Any]], at: Any) -> list[Any]:
    """Central differences; the error is some 1e-30."""
    h = MP.mpf(10) ** -15
    pairs = zip(function(at + h), function(at - h), strict=True)
    return [(above - below) / (2 * h) for above, below in pairs]


# --- every start of the cycle -----------------------------------------------------------


@pytest.mark.parametrize(("name", "rotation"), EVERY)
def test_every_rotation_is_square_and_gives_the_same_orbit(name: str, rotation: int) -> None:
    base, turned = solved(name), solved(name, rotation)
    orbit = turned.derived.orbit
    assert len(orbit.equations) == len(orbit.unknowns)
    for dwell_time, value in base.dwell_times.items():
        assert close(turned.dwell_times[dwell_time], value, 45)
        assert value > 0 or dwell_time in turned.itinerary.vanishing
    count = len(base.dwell_times)
    for index in range(count):
        state = base.states[(index + rotation) % count]
        assert all(close(a, b, 45) for a, b in zip(turned.states[index], state, strict=True))
    # and it closes, also in the coordinates that no equation closes
    assert all(close(a, b, 45) for a, b in zip(turned.states[-1], turned.states[0], strict=True))


@pytest.mark.parametrize(("name", "rotation"), EVERY)
def test_every_rotation_has_the_same_nonzero_multipliers(name: str, rotation: int) -> None:
    base, turned = solved(name).multipliers(), solved(name, rotation).multipliers()
    assert len(base) == len(turned)
    assert all(close(a, b, 30) for a, b in zip(turned, base, strict=True))


@pytest.mark.parametrize(("name", "rotation"), EVERY)
def test_the_trace_is_that_of_the_general_jacobian(name: str, rotation: int) -> None:
    turned = solved(name, rotation)
    (trace,) = turned.derived.run("trace", turned.values, turned.unknowns)
    general = sum((turned.poincare[i, i] for i in range(turned.poincare.rows)), MP.mpf(0))
    assert close(trace, general, 40)


@pytest.mark.parametrize("name", ["bounce", "clock", "bilinear"])
def test_the_monodromy_matrix_keeps_the_field_and_has_all_multipliers(name: str) -> None:
    example = solved(name)
    size = len(example.derived.orbit.system.states)
    entries = example.derived.run("monodromy", example.values, example.unknowns)
    rows = [entries[i : i + size] for i in range(0, size * size, size)]
    field, matrix = MP.matrix(entries[size * size :]), MP.matrix(rows)
    assert MP.norm(matrix * field - field, MP.inf) < MP.mpf(10) ** -45
    for multiplier in (*example.multipliers(), 1):
        singular = matrix - multiplier * MP.eye(size)
        assert abs(MP.det(singular)) < MP.mpf(10) ** -25


def test_the_coupled_pair_has_two_multipliers_and_no_map_in_one_variable() -> None:
    assert solved("pair").derived.orbit.reduction.start is None
    assert len(solved("pair").multipliers()) == 2


# --- analytic cases ---------------------------------------------------------------------


def test_the_first_return_is_the_first_rise_through_zero() -> None:
    """Of a cos(w t) + b sin(w t) + c, from a start at zero or below, against 60 digits."""
    rate, dwell, *parts = sp.symbols("w tau a b c", real=True)
    cosine, sine = sp.cos(rate * TIME), sp.sin(rate * TIME)
    source = random.Random(5)
    for case in range(12):
        a, b = (source.choice((-1, 1)) * MP.mpf(source.uniform(0.2, 2)) for _ in range(2))
        c = 0 if case % 3 == 0 else MP.sqrt(a**2 + b**2) * MP.mpf(source.uniform(-0.9, 0.9))
        level = parts[2] if c else sp.Integer(0)
        found = explicit_time(
            {cosine: parts[0], sine: parts[1], sp.Integer(1): level}, dwell, parts
        )
        assert found.rule == RETURN
        known = {rate: MP.mpf(source.uniform(0.5, 2))} | dict(zip(parts, (a, b, c), strict=True))
        for stage in found.stages:
            known |= {symbol: number(value, known) for symbol, value in stage.assignments}
        (angle,) = found.time.atoms(Angle)
        turned = MP.atan2(*(number(x, known) for x in angle.args)) % (2 * MP.pi)
        time = number(
            found.time.subs(angle, sp.Symbol("turned")), known | {sp.Symbol("turned"): turned}
        )
        w = known[rate]
        assert 0 < w * time < 2 * MP.pi
        assert close(number(found.functions[cosine], known), MP.cos(w * time), 50)
        assert close(number(found.functions[sine], known), MP.sin(w * time), 50)
        assert close(a * MP.cos(w * time) + b * MP.sin(w * time) + c, 0, 50)
        assert b * MP.cos(w * time) > a * MP.sin(w * time)


def in_c(equations: EquationSystem, folder: Path) -> Callable[..., tuple[int, list[float]]]:
    """The emitted solver, compiled: status and unknowns from parameters and a guess."""
    itinerary = equations.itinerary
    for name, text in emit_library(itinerary.system, [itinerary], "tests").items():
        (folder / name).write_text(text, encoding="utf-8")
    stem = itinerary.system.name.replace("-", "_")
    library = library_of(folder / f"{stem}.c", include=folder)
    solver = library[c_function(stem, "solve", itinerary.name)]

    def solve(values: Sequence[Any], guess: Sequence[Any]) -> tuple[int, list[float]]:
        given = [np.array(values, dtype=float)] + [np.array(guess, dtype=float)] * (len(guess) > 0)
        unknowns = np.zeros(len(equations.unknowns))
        told = [np.zeros(1), np.zeros(1), np.zeros(1, np.int32), np.zeros(1, np.int32)]
        solver(ctypes.c_ssize_t(1), *map(pointer, (*given, unknowns, *told)))
        return int(told[-1][0]), unknowns.tolist()

    return solve


@needs_compiler
@pytest.mark.parametrize(
    "name", ["pair", "bilinear", "belt", pytest.param("one-contact", marks=pytest.mark.slow)]
)
def test_the_solver_in_c_finds_the_orbit(name: str, tmp_path: Path) -> None:
    example = solved(name)
    equations = example.derived.orbit
    solve = in_c(equations, tmp_path)
    guess = [u * MP.mpf("1.1") for u in example.reduced]
    status, unknowns = solve(example.values, guess)
    assert status == 0
    assert unknowns == pytest.approx([float(u) for u in example.unknowns], rel=1e-12, abs=1e-13)


@needs_compiler
def test_the_solver_in_c_tells_of_a_dwell_time_that_is_negative(tmp_path: Path) -> None:
    """Of one that is no unknown: what is left of the period."""
    equations = solved("one-contact").derived.orbit
    solve = in_c(equations, tmp_path)
    values = dict(m1=1, m2=2, k1=1, k2=5, k3=1, T=6)
    point = [values[str(p)] for p in equations.parameters]
    for guess, expected in ((2.0, 0), (24.4, 3)):
        status, unknowns = solve(point, [guess])
        assert status == expected
        assert (0 < unknowns[-1] < 6) == (status == 0)


# --- derivatives ------------------------------------------------------------------------


def off_the_orbit(example: Solved, seed: int) -> list[Any]:
    source = random.Random(seed)
    return [u * (1 + MP.mpf(source.uniform(-0.05, 0.05))) for u in example.unknowns]


@pytest.mark.parametrize(("name", "rotation"), MOST)
def test_jacobian_against_differences(name: str, rotation: int) -> None:
    example = solved(name, rotation)
    at = off_the_orbit(example, rotation)
    found = example.derived.matrix("jacobian", example.values, at)
    for j in range(len(at)):

        def along(x: Any, j: int = j) -> list[Any]:
            return example.derived.run("residual", example.values, [*at[:j], x, *at[j + 1 :]])

        expected = slope(along, at[j])
        assert all(close(found[i, j], e, 25) for i, e in enumerate(expected))


@pytest.mark.parametrize(("name", "rotation"), MOST)
def test_total_parameter_derivatives_against_differences(name: str, rotation: int) -> None:
    example = solved(name, rotation)
    derived, values = example.derived, example.values
    at = off_the_orbit(example, rotation + 7)
    found = derived.matrix("parameter_jacobian", values, at)
    gradient = derived.run("trace_gradient", values, at)
    _, spectral = derived.spectrum(values)
    count = len(derived.orbit.spectrum.parameters)
    for j, name_of in enumerate(derived.names):

        def moved(x: Any, j: int = j) -> list[Any]:
            return [*values[:j], x, *values[j + 1 :]]

        expected = slope(lambda x: derived.run("residual", moved(x), at), values[j])
        assert all(close(found[i, j], e, 25) for i, e in enumerate(expected))
        (expected_trace,) = slope(lambda x: derived.run("trace", moved(x), at), values[j])
        assert close(gradient[len(at) + j], expected_trace, 25)
        # the spectrum's own derivatives, which the total ones rest on
        expected = slope(lambda x: derived.spectrum(moved(x))[0], values[j])
        known = [str(p) for p in derived.orbit.spectrum.parameters]
        column = (
            spectral[known.index(name_of) :: count] if name_of in known else [0] * len(expected)
        )
        assert all(close(MP.mpf(a), b, 25) for a, b in zip(column, expected, strict=True))
    for j in range(len(at)):

        def along(x: Any, j: int = j) -> list[Any]:
            return derived.run("trace", values, [*at[:j], x, *at[j + 1 :]])

        (expected_trace,) = slope(along, at[j])
        assert close(gradient[j], expected_trace, 25)


# --- the Poincare map, a second time ----------------------------------------------------


class Independent:
    """Flow by matrix exponentials, exits by Newton's method on time, resets as declared."""

    def __init__(self, example: Solved) -> None:
        self.example = example
        orbit = example.derived.orbit
        system, phases, known = orbit.system, example.itinerary.phases, example.known
        zero = dict.fromkeys(system.states, 0)
        self.size = len(system.states)
        self.pieces = []
        for index, phase in enumerate(phases):
            configuration = system.configuration(phase.configuration)
            matrix, offset = configuration.dynamics.field(system.states)
            augmented = MP.zeros(self.size + 1)
            for i in range(self.size):
                augmented[i, self.size] = number(offset[i], known)
                for j in range(self.size):
                    augmented[i, j] = number(matrix[i, j], known)
            function = configuration.boundary(phase.boundary).function
            normal = [number(sp.diff(function, s), known) for s in system.states]
            normal.append(number(function.subs(zero), known))
            following = phases[(index + 1) % len(phases)].configuration
            reset = dict(system.transition(phase.configuration, phase.boundary, following).reset)
            jump = MP.eye(self.size + 1)
            for i, state in enumerate(system.states):
                rule = sp.sympify(reset.get(state, state))
                jump[i, self.size] = number(rule.subs(zero), known)
                for j, other in enumerate(system.states):
                    jump[i, j] = number(sp.diff(rule, other), known)
            self.pieces.append((augmented, MP.matrix([normal]), jump, phase.dwell_time))

    def image(self, state: Sequence[Any]) -> list[Any]:
        """State after one turn; each exit is the one nearest to the orbit's own."""
        y = MP.matrix([*state, 1])
        for augmented, normal, jump, dwell_time in self.pieces:
            time = self.example.dwell_times[dwell_time]
            end = MP.expm(augmented * time) * y
            for _ in range(8):
                step = -(normal * end)[0] / (normal * (augmented * end))[0]
                # an exponential of a small matrix is a short series
                end, term, order = end, end, 1
                while order < 12:
                    term = augmented * term * step / order
                    end, order = end + term, order + 1
                if abs(step) < MP.mpf(10) ** -53:
                    break
            assert abs(step) < MP.mpf(10) ** -40
            y = jump * end
        return list(y)[: self.size]


@pytest.mark.parametrize(("name", "rotation"), MOST)
def test_orbit_and_poincare_jacobian_against_an_independent_map(name: str, rotation: int) -> None:
    example = solved(name, rotation)
    second, section = Independent(example), example.section
    start = example.states[0]
    image = second.image(start)
    assert all(close(a, b, 40) for a, b in zip(image, start, strict=True))
    for j in range(section.dimension):
        direction = [number(e, example.known) for e in section.embedding[:, j]]

        def along(x: Any, direction: list[Any] = direction) -> list[Any]:
            moved = second.image([s + x * d for s, d in zip(start, direction, strict=True)])
            return [moved[i] for i in section.places]

        expected = slope(along, MP.mpf(0))
        assert all(close(example.poincare[i, j], e, 25) for i, e in enumerate(expected))


# --- the reduction ----------------------------------------------------------------------


@pytest.mark.parametrize(("name", "rotation"), EVERY)
def test_the_reduced_equations_have_the_same_orbit(name: str, rotation: int) -> None:
    example = solved(name, rotation)
    derived, reduction = example.derived, example.derived.orbit.reduction
    assert len(reduction.equations) == len(reduction.unknowns)
    point = example.reduced
    assert all(abs(e) < MP.mpf(10) ** -45 for e in derived.run("reduced", example.values, point))
    unknowns = derived.run("expand", example.values, point)
    assert all(close(a, b, 45) for a, b in zip(unknowns, example.unknowns, strict=True))
    if point:
        source = random.Random(rotation)
        at = [p * (1 + MP.mpf(source.uniform(-0.02, 0.02))) for p in point]
        found = derived.matrix("reduced_jacobian", example.values, at)
        for j in range(len(at)):

            def along(x: Any, j: int = j) -> list[Any]:
                return derived.run("reduced", example.values, [*at[:j], x, *at[j + 1 :]])

            expected = slope(along, at[j])
            assert all(close(found[i, j], e, 25) for i, e in enumerate(expected))


def test_a_coordinate_hidden_in_an_explicit_time_is_no_longer_linear() -> None:
    # the dwell time on the spring depends on the speed of departure, so the wall's condition
    # is not linear in that speed: both stay unknown
    reduction = solved("bounce").derived.orbit.reduction
    assert len(reduction.unknowns) == 2
    assigned = set(reduction.unknowns)
    assigned |= {p.symbol for p in solved("bounce").derived.orbit.system.parameters}
    for stage in reduction.stages:
        for symbol, expression in stage.assignments:
            assert expression.free_symbols <= assigned
            assigned.add(symbol)


def test_global_stick_comes_down_to_two_unknowns() -> None:
    reduction = solved("dry-friction").derived.orbit.reduction
    assert [str(u) for u in reduction.unknowns] == ["tau", "tau1"]
    rules = {str(e.unknown): e.rule for e in reduction.eliminations}
    assert rules == {
        "z2_1": "linear in second-breaks-forward",
        "tau2": "first return",
        "ta": "linear in time",
    }


# --- refusals ---------------------------------------------------------------------------


@pytest.mark.parametrize("reset", [{}, {X: 2 * X}], ids=["no reset", "a reset"])
def test_a_start_that_no_state_satisfies_is_refused(reset: dict[sp.Symbol, sp.Expr]) -> None:
    stuck = SecondOrder([[1]], [[1]], held={X: 1})
    system = System(
        "odd", "", (X, V), (),
        (
            Configuration("stick", stuck, (Boundary("fast", V - 2),)),
            Configuration("slip", SecondOrder([[1]], [[1]]), (Boundary("far", X - 1),)),
        ),
        (Transition("stick", {"fast"}, "slip", (), reset), Transition("slip", {"far"}, "stick")),
    )  # fmt: skip
    loop = Itinerary("loop", system, (Phase("slip", "far", "ta"), Phase("stick", "fast", "tb")))
    with pytest.raises(DerivationError, match="'loop': its start satisfies no state"):
        derive_equations(loop)
