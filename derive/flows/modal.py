"""Flows of configurations in closed form, by modal analysis.

With the free coordinates f and the held ones h, an undamped configuration reads

    x_f'' + L x_f = q - P x_h,   x_h = x_h(0) + v_h t,
    L = M_ff^-1 K_ff,  P = M_ff^-1 K_fh,  q = M_ff^-1 load_f,

and its flow is a sum of functions of time times constant matrices,

    y(t) = sum_b phi_b(t) (B_b y(0) + beta_b).

Where L has provably positive, distinct eigenvalues on the whole parameter domain the
functions are 1, t, cos(omega t) and sin(omega t), with frequencies that are radicals of the
parameters. Elsewhere, and where there is damping, :mod:`nonsmooth.derive.flows.resolvent` gives
the flow.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache
from itertools import count
from typing import Any

import sympy as sp

from nonsmooth.derive.declaration.algebra import cancel
from nonsmooth.derive.declaration.dynamics import Dynamics, SecondOrder
from nonsmooth.derive.declaration.parameter import Parameter, is_positive
from nonsmooth.derive.declaration.system import TIME, System
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.flows.entire import ExponentialDifference
from nonsmooth.derive.flows.resolvent import resolvent
from nonsmooth.derive.symbols import Symbol

__all__ = ["TIME", "Flow", "Spectrum", "derive_flows"]

# function of time, row block, column block (or "1" for the offset), matrix
_Term = tuple[sp.Expr, str, str, sp.Matrix]


@dataclass(frozen=True)
class Spectrum:
    """Frequencies and projector coefficients: all that needs a root of the parameters."""

    # in order of evaluation; an expression may use the symbols before it
    entries: tuple[tuple[sp.Symbol, sp.Expr], ...] = ()
    # those on which the entries depend, in the order in which they are declared
    parameters: tuple[sp.Symbol, ...] = ()

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """All spectral symbols in order."""
        return tuple(s for s, _ in self.entries)


@dataclass(frozen=True)
class Flow:
    """Closed-form solution y(t) = sum_b phi_b(t) (B_b y(0) + beta_b) inside one configuration."""

    configuration: str
    basis: tuple[sp.Expr, ...]  # functions phi_b of `TIME`
    matrices: tuple[sp.Matrix, ...]  # B_b, N x N, constant in time
    offsets: tuple[sp.Matrix, ...]  # beta_b, N x 1, constant in time
    field: tuple[sp.Matrix, sp.Matrix]  # (A, b) of the vector field y' = A y + b

    def matrix(self, functions: Iterable[sp.Expr] | None = None) -> sp.Matrix:
        """Matrix Phi(t) (N x N), with `functions` in place of the basis functions if given."""
        return self._sum(self.matrices, functions)

    def offset(self, functions: Iterable[sp.Expr] | None = None) -> sp.Matrix:
        """Part (N x 1) of the solution that does not depend on the start."""
        return self._sum(self.offsets, functions)

    def _sum(self, terms: tuple[sp.Matrix, ...], functions: Iterable[sp.Expr] | None) -> sp.Matrix:
        total = sp.zeros(*terms[0].shape)
        for function, term in zip(functions or self.basis, terms, strict=True):
            total += function * term
        return total

    def velocity(self, state: sp.Matrix) -> sp.Matrix:
        """Vector field (N x 1) at a state: the derivative of the flow by time."""
        matrix, offset = self.field
        return matrix * state + offset

    def along(self, row: sp.Matrix, constant: sp.Expr, state: sp.Matrix) -> tuple[sp.Expr, ...]:
        """Coefficient of each basis function in ``row y(t) + constant``, y(0) being `state`."""
        coefficients = [
            (row * (matrix * state + offset))[0]
            for matrix, offset in zip(self.matrices, self.offsets, strict=True)
        ]
        coefficients[self.basis.index(sp.Integer(1))] += constant
        return tuple(coefficients)


class _Names:
    """Spectral symbols in use, so that equal expressions of two configurations share one."""

    def __init__(self, taken: Iterable[str]) -> None:
        self.taken = set(taken)  # names of the states and parameters
        self.entries: dict[sp.Expr, sp.Symbol] = {}
        self.resolvents: dict[sp.ImmutableMatrix, Any] = {}  # of blocks of configurations

    def symbol(self, stem: str, expression: sp.Expr) -> sp.Expr:
        """Symbol in place of an expression; the expression itself if it is a number or a symbol."""
        expression = sp.sympify(expression)
        if expression.is_number or expression.is_Symbol:
            return expression
        if expression not in self.entries:
            assumptions = {"positive": True} if expression.is_positive else {"real": True}
            self.entries[expression] = self._fresh(stem, assumptions)
        return self.entries[expression]

    def coefficient(self, expression: sp.Expr) -> sp.Expr:
        """A coefficient of a characteristic factor, named if it is long or may be rewritten.

        Factors are identified by their coefficients, which must survive an expansion of the
        expressions that contain them: (1 + g)/g would become 1 + 1/g.
        """
        simple = expression.count_ops() <= 2 and sp.expand(expression) == expression
        return expression if simple else self.symbol("factor", expression)

    def _fresh(self, stem: str, assumptions: dict[str, bool]) -> Symbol:
        """A symbol whose name, the stem and a number, is not in use yet."""
        symbols = (Symbol("spectrum", stem, i, **assumptions) for i in count(1))
        found = next(s for s in symbols if s.name not in self.taken)
        self.taken.add(found.name)
        return found


def derive_flows(system: System) -> tuple[Spectrum, dict[str, Flow]]:
    """Spectrum of all configurations of a system, and the flow of each by its name.

    DerivationError refuses a configuration with a block of too many roots and no modes.
    """
    motions = tuple((c.name, c.dynamics) for c in system.configurations)
    spectrum, flows = _derived(system.states, system.parameters, motions)
    return spectrum, dict(flows)


@lru_cache(maxsize=64)  # orbits of one system share its flows, and its document shows them
def _derived(
    states: tuple[sp.Symbol, ...],
    parameters: tuple[Parameter, ...],
    motions: tuple[tuple[str, Dynamics], ...],
) -> tuple[Spectrum, dict[str, Flow]]:
    names = _Names([*map(str, states), *(p.name for p in parameters)])
    flows = {name: _flow(name, dynamics, states, parameters, names) for name, dynamics in motions}
    entries = tuple((symbol, expression) for expression, symbol in names.entries.items())
    used = frozenset().union(*(expression.free_symbols for expression in names.entries))
    return Spectrum(entries, tuple(p.symbol for p in parameters if p.symbol in used)), flows


def _flow(
    name: str,
    dynamics: Dynamics,
    states: tuple[sp.Symbol, ...],
    parameters: tuple[Parameter, ...],
    names: _Names,
) -> Flow:
    field = dynamics.field(states)
    if not isinstance(dynamics, SecondOrder) or not dynamics.damping.is_zero_matrix:
        return _general_flow(name, field, parameters, names)
    size = dynamics.mass.rows
    held = sorted(dynamics.held_at(states))
    free = [i for i in range(size) if i not in held]
    inverse = dynamics.mass.extract(free, free).inv()
    stiffness = (inverse * dynamics.stiffness.extract(free, free)).applyfunc(cancel)
    coupling = (inverse * dynamics.stiffness.extract(free, held)).applyfunc(cancel)
    load = (inverse * dynamics.load.extract(free, [0])).applyfunc(cancel)
    terms = _held_terms(len(held))
    if free:
        modes = _positive_modes(stiffness, parameters, names)
        if modes is None:
            return _general_flow(name, field, parameters, names)
        terms += _oscillating_terms(stiffness, coupling, load, modes)
    matrices, offsets = _assemble(terms, size, free, held)
    return Flow(
        name,
        tuple(matrices),
        tuple(sp.ImmutableMatrix(m) for m in matrices.values()),
        tuple(sp.ImmutableMatrix(o) for o in offsets.values()),
        field,
    )


def _general_flow(
    name: str,
    field: tuple[sp.Matrix, sp.Matrix],
    parameters: tuple[Parameter, ...],
    names: _Names,
) -> Flow:
    """Flow of any linear motion, from the resolvent of its field."""
    matrix, offset = field
    try:
        fractions = resolvent(matrix, offset, parameters, names.symbol, names.resolvents)
    except DerivationError as problem:
        raise DerivationError(f"configuration {name!r}: {problem}") from None
    size = matrix.rows
    one = sp.Integer(1)
    found: dict[sp.Expr, sp.Matrix] = {one: sp.zeros(size, size + 1)}
    for fraction in fractions:
        factors = tuple(f.func(*map(names.coefficient, f)) for f in fraction.factors)
        for k, numerator in enumerate(fraction.powers):
            if numerator.is_zero_matrix:
                continue
            value = _function_of_time(k, factors, parameters, names)
            # a multiple of a power of time joins the others of that power
            scale, function = value.as_independent(TIME, as_Add=False)
            found[function] = found.get(function, sp.zeros(size, size + 1)) + scale * numerator
    return Flow(
        name,
        tuple(found),
        tuple(sp.ImmutableMatrix(m[:, :size]) for m in found.values()),
        tuple(sp.ImmutableMatrix(m[:, size]) for m in found.values()),
        field,
    )


def _function_of_time(
    k: int, factors: tuple[sp.Tuple, ...], parameters: tuple[Parameter, ...], names: _Names
) -> sp.Expr:
    """Function of time whose Laplace transform is s^k over the product of the factors.

    It is trigonometric where the only roots are shown to be imaginary.
    """
    if len(factors) == 1 and len(factors[0]) == 2:
        square, damping = factors[0]
        if damping == 0 and is_positive(square, parameters):
            omega = names.symbol("omega", sp.sqrt(square))
            return sp.cos(omega * TIME) if k else sp.sin(omega * TIME) / omega
    return ExponentialDifference(k, TIME, *factors)


def _held_terms(size: int) -> list[_Term]:
    """Terms of the flow of held coordinates, which move with the velocity that the state has."""
    one, identity = sp.Integer(1), sp.eye(size)
    return [
        (one, "xh", "xh", identity),
        (TIME, "xh", "vh", identity),
        (one, "vh", "vh", identity),
    ]


def _positive_modes(
    stiffness: sp.Matrix, parameters: tuple[Parameter, ...], names: _Names
) -> list[tuple[sp.Expr, sp.Matrix]] | None:
    """Frequencies and projectors of L if its eigenvalues are provably positive and distinct."""
    size = stiffness.rows
    if size == 1:
        if not is_positive(stiffness[0], parameters):
            return None
        return [(names.symbol("omega", sp.sqrt(stiffness[0])), sp.eye(1))]
    if size > 2:
        return None
    a, b, c, d = stiffness
    trace, determinant = a + d, sp.factor(a * d - b * c)
    discriminant = (a - d) ** 2 + 4 * b * c
    if not all(is_positive(e, parameters) for e in (trace, determinant, discriminant)):
        return None
    separation = discriminant / trace**2
    if separation.is_number and separation < sp.Rational(1, 10**4):
        return None  # known to nearly coalesce: the projectors would cancel
    gap = names.symbol("gap", sp.sqrt(discriminant))
    faster = names.symbol("omega", sp.sqrt((trace + gap) / 2))
    # the smaller root by the product of both: a difference would cancel
    slower = names.symbol("omega", sp.sqrt(determinant) / faster)
    p = names.symbol("p", (1 + (a - d) / gap) / 2)
    q, r = names.symbol("p", b / gap), names.symbol("p", c / gap)
    projector = sp.Matrix([[p, q], [r, 1 - p]])
    return [(faster, projector), (slower, sp.eye(2) - projector)]


def _oscillating_terms(
    stiffness: sp.Matrix,
    coupling: sp.Matrix,
    load: sp.Matrix,
    modes: list[tuple[sp.Expr, sp.Matrix]],
) -> list[_Term]:
    """Terms of the flow of free coordinates where L is nonsingular.

    w = x_f + G x_h - s with G = L^-1 P and s = L^-1 q obeys w'' + L w = 0.
    """
    quasi_static = (stiffness.LUsolve(coupling)).applyfunc(cancel)
    centre = (stiffness.LUsolve(load)).applyfunc(cancel)
    one = sp.Integer(1)
    terms: list[_Term] = [
        (one, "xf", "xh", -quasi_static),
        (one, "xf", "1", centre),
        (one, "vf", "vh", -quasi_static),
        (TIME, "xf", "vh", -quasi_static),
    ]
    for omega, projector in modes:
        cosine, sine = sp.cos(omega * TIME), sp.sin(omega * TIME)
        for row, column, function, matrix in (
            ("xf", "x", cosine, projector),
            ("xf", "v", sine, projector / omega),
            ("vf", "x", sine, -omega * projector),
            ("vf", "v", cosine, projector),
        ):
            terms.append((function, row, f"{column}f", matrix))
            terms.append((function, row, f"{column}h", matrix * quasi_static))
            if column == "x":
                terms.append((function, row, "1", -matrix * centre))
    return terms


def _assemble(
    terms: list[_Term], size: int, free: list[int], held: list[int]
) -> tuple[dict[sp.Expr, sp.Matrix], dict[sp.Expr, sp.Matrix]]:
    """Matrices and offsets of the whole state by function of time, from their blocks."""
    places = {
        "xf": free,
        "xh": held,
        "vf": [size + i for i in free],
        "vh": [size + i for i in held],
    }
    matrices: dict[sp.Expr, sp.Matrix] = {}
    offsets: dict[sp.Expr, sp.Matrix] = {}
    for function, row, column, block in terms:
        # a multiple of a power of time joins the others of that power
        scale, function = function.as_independent(TIME, as_Add=False)
        matrix = matrices.setdefault(function, sp.zeros(2 * size, 2 * size))
        offset = offsets.setdefault(function, sp.zeros(2 * size, 1))
        for i, target in enumerate(places[row]):
            for j in range(block.cols):
                if column == "1":
                    offset[target, 0] += scale * block[i, j]
                else:
                    matrix[target, places[column][j]] += scale * block[i, j]
    kept = [
        f
        for f in matrices
        if f == 1 or not (matrices[f].is_zero_matrix and offsets[f].is_zero_matrix)
    ]
    return {f: matrices[f] for f in kept}, {f: offsets[f] for f in kept}
