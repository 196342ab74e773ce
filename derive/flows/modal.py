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

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache

import sympy as sp

from nonsmooth.derive.declaration.algebra import cancel
from nonsmooth.derive.declaration.dynamics import Dynamics, SecondOrder
from nonsmooth.derive.declaration.parameter import Parameter
from nonsmooth.derive.declaration.system import TIME, System
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.flows.entire import ExponentialDifference
from nonsmooth.derive.flows.resolvent import SpectralNames, resolvent

__all__ = ["TIME", "Flow", "Mode", "Spectrum", "derive_flows"]

_Term = tuple[sp.Expr, sp.Matrix]  # function of time, and its matrix N x (N + 1), offset last


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

    def end(self, functions: Iterable[sp.Expr], state: sp.Matrix) -> sp.Matrix:
        """State (N x 1) at which a motion from another one ends, with `functions` of its time."""
        values = list(functions)
        return self.matrix(values) * state + self.offset(values)

    def velocity(self, state: sp.Matrix) -> sp.Matrix:
        """Vector field (N x 1) at a state: the derivative of the flow by time."""
        matrix, offset = self.field
        return matrix * state + offset

    @property
    def modes(self) -> tuple[Mode, ...] | None:
        """Modes; None if one of the functions is no power of time, cosine or sine."""
        powers = [f for f in self.basis if f.is_polynomial(TIME)]
        waves = [f for f in self.basis if isinstance(f, sp.cos | sp.sin)]
        if len(powers) + len(waves) < len(self.basis):
            return None
        degree = max((int(sp.degree(f, TIME)) for f in powers), default=-1)
        found = [Mode(sp.Integer(0), tuple(TIME**k for k in range(degree + 1)))] if powers else []
        for angle in dict.fromkeys(f.args[0] for f in waves):
            found.append(Mode(angle / TIME, (sp.cos(angle), sp.sin(angle))))
        return tuple(found)

    @property
    def frequencies(self) -> tuple[sp.Expr, ...] | None:
        """Frequencies of a sum of a line, sines and cosines; None for another flow."""
        modes = self.modes
        if modes is None or any(mode.length > 2 for mode in modes):
            return None
        return tuple(mode.frequency for mode in modes if mode.oscillates)

    def along(self, row: sp.Matrix, constant: sp.Expr, state: sp.Matrix) -> tuple[sp.Expr, ...]:
        """Coefficient of each basis function in ``row y(t) + constant``, y(0) being `state`."""
        coefficients = [
            (row * (matrix * state + offset))[0]
            for matrix, offset in zip(self.matrices, self.offsets, strict=True)
        ]
        coefficients[self.basis.index(sp.Integer(1))] += constant
        return tuple(coefficients)


@dataclass(frozen=True)
class Mode:
    """Functions of time that share one exponent: powers of time, or a cosine and a sine."""

    frequency: sp.Expr  # imaginary part of the exponent; zero if the mode does not oscillate
    terms: tuple[sp.Expr, ...]

    @property
    def oscillates(self) -> bool:
        """Whether the exponent has an imaginary part."""
        return bool(self.frequency != 0)

    @property
    def length(self) -> int:
        """Number of powers of time."""
        return len(self.terms) // (2 if self.oscillates else 1)


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
    names = SpectralNames(states, parameters)
    flows = {name: _flow(name, dynamics, states, names) for name, dynamics in motions}
    entries = tuple((symbol, expression) for expression, symbol in names.entries.items())
    used = frozenset().union(*(expression.free_symbols for expression in names.entries))
    return Spectrum(entries, tuple(p.symbol for p in parameters if p.symbol in used)), flows


def _flow(
    name: str, dynamics: Dynamics, states: tuple[sp.Symbol, ...], names: SpectralNames
) -> Flow:
    field = dynamics.field(states)
    terms = None
    if isinstance(dynamics, SecondOrder) and dynamics.damping.is_zero_matrix:
        held = sorted(dynamics.held_at(states))
        terms = _undamped_terms(field, held, names)
    if terms is None:
        try:
            terms = _general_terms(field, names)
        except DerivationError as problem:
            raise DerivationError(f"configuration {name!r}: {problem}") from None
    size = len(states)
    found: dict[sp.Expr, sp.Matrix] = {sp.Integer(1): sp.zeros(size, size + 1)}
    for value, matrix in terms:
        # a multiple of a power of time joins the others of that power
        scale, function = value.as_independent(TIME, as_Add=False)
        found[function] = found.get(function, sp.zeros(size, size + 1)) + scale * matrix
    kept = {f: sp.ImmutableMatrix(m) for f, m in found.items() if f == 1 or not m.is_zero_matrix}
    return Flow(
        name,
        tuple(kept),
        tuple(matrix[:, :size] for matrix in kept.values()),
        tuple(matrix[:, size] for matrix in kept.values()),
        field,
    )


def _general_terms(field: tuple[sp.Matrix, sp.Matrix], names: SpectralNames) -> list[_Term]:
    """Terms of the flow of any linear motion, from the resolvent of its field."""
    terms = []
    for (given, k), numerator in resolvent(*field, names):
        if not numerator.is_zero_matrix:
            factors = tuple(f.func(*map(names.coefficient, f)) for f in given)
            terms.append((_function_of_time(k, factors, names), numerator))
    return terms


def _function_of_time(k: int, factors: tuple[sp.Tuple, ...], names: SpectralNames) -> sp.Expr:
    """Function of time whose Laplace transform is s^k over the product of the factors.

    It is trigonometric where the only roots are shown to be imaginary.
    """
    if len(factors) == 1 and len(factors[0]) == 2:
        square, damping = factors[0]
        if damping == 0 and names.positive(square):
            omega = names.symbol("omega", sp.sqrt(square))
            return sp.cos(omega * TIME) if k else sp.sin(omega * TIME) / omega
    return ExponentialDifference(k, TIME, *factors)


def _undamped_terms(
    field: tuple[sp.Matrix, sp.Matrix], held: Sequence[int], names: SpectralNames
) -> list[_Term] | None:
    """Terms of the flow of free and held coordinates where L is nonsingular; None elsewhere.

    w = x_f + G x_h - s with G = L^-1 P and s = L^-1 q obeys w'' + L w = 0, and what is held moves
    with the velocity that the state has.
    """
    matrix, offset = field
    size = matrix.rows // 2
    free = [i for i in range(size) if i not in held]
    rows = [size + i for i in free]
    one, zero, nothing = sp.eye(size), sp.zeros(size, size), sp.zeros(size, 1)
    stiffness, coupling, load = (
        part.applyfunc(cancel)
        for part in (
            -matrix.extract(rows, free),
            -matrix.extract(rows, held),
            offset.extract(rows, [0]),
        )
    )
    modes = _positive_modes(stiffness, names)
    if modes is None:
        return None
    quasi_static = stiffness.LUsolve(coupling).applyfunc(cancel)
    rest = stiffness.LUsolve(load).applyfunc(cancel)
    place = one[:, free]
    moved, centre = one[:, held] - place * quasi_static, place * rest
    deviation = one[free, :] + quasi_static * one[held, :]
    carried = moved * one[held, :]
    terms: list[_Term] = [
        (sp.Integer(1), _rows((carried, zero, centre), (zero, carried, nothing))),
        (TIME, _rows((zero, carried, nothing), (zero, zero, nothing))),
    ]
    for omega, projector in modes:
        near, slowly, quickly = (
            (place * (m * deviation), place * (-m * rest))
            for m in (projector, projector / omega, -omega * projector)
        )
        cosine, sine = sp.cos(omega * TIME), sp.sin(omega * TIME)
        terms += [
            (cosine, _rows((near[0], zero, near[1]), (zero, near[0], nothing))),
            (sine, _rows((zero, slowly[0], nothing), (quickly[0], zero, quickly[1]))),
        ]
    return terms


def _positive_modes(
    stiffness: sp.Matrix, names: SpectralNames
) -> list[tuple[sp.Expr, sp.Matrix]] | None:
    """Frequencies and projectors of L if its eigenvalues are provably positive and distinct."""
    size = stiffness.rows
    if size == 0:
        return []
    if size == 1:
        if not names.positive(stiffness[0]):
            return None
        return [(names.symbol("omega", sp.sqrt(stiffness[0])), sp.eye(1))]
    if size > 2:
        return None
    a, b, c, d = stiffness
    trace, determinant = a + d, sp.factor(a * d - b * c)
    discriminant = (a - d) ** 2 + 4 * b * c
    if not all(map(names.positive, (trace, determinant, discriminant))):
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


def _rows(positions: Sequence[sp.Matrix], velocities: Sequence[sp.Matrix]) -> sp.Matrix:
    """A matrix N x (N + 1) from blocks by positions, by velocities and of the offset."""
    return sp.Matrix.vstack(sp.Matrix.hstack(*positions), sp.Matrix.hstack(*velocities))
