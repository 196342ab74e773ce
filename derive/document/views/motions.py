"""Motions in closed form, as one writes them: by displacements, by modes, steady parts."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import sympy as sp

from nonsmooth.derive.declaration.configuration import Configuration
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.document.notation.letters import Factors
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.flows.entire import ExponentialDifference
from nonsmooth.derive.flows.modal import TIME, Flow, Spectrum, derive_flows

__all__ = [
    "Displacements",
    "Modes",
    "Steady",
    "closed_flows",
    "modes_of",
    "positions_of",
    "steady_of",
]

_CONSTANT = sp.Tuple(sp.Integer(0))
# by matrix: function of time beside it, at each of some places
_Sum = dict[sp.Matrix, dict[int, sp.Expr]]


def closed_flows(system: System, names: Iterable[str]) -> tuple[Spectrum, dict[str, Flow]]:
    """Spectrum and flows by name of those named configurations that have a closed form."""
    motions = [Configuration(n, system.configuration(n).dynamics, ()) for n in names]
    whole = _flows(system, motions)
    if whole is not None:
        return whole
    closed = [motion for motion in motions if _flows(system, [motion])]
    return (closed and _flows(system, closed)) or (Spectrum(), {})


def _flows(
    system: System, motions: Iterable[Configuration]
) -> tuple[Spectrum, dict[str, Flow]] | None:
    """Spectrum and flows of a system of some motions alone; None if one has no closed form."""
    alone = replace(system, configurations=tuple(motions), transitions=(), contacts=())
    try:
        return derive_flows(alone)
    except DerivationError:
        return None


@dataclass(frozen=True)
class Displacements:
    """Symbols g = h' + 2 delta h of damped oscillations: responses to a displacement of 1."""

    symbols: Mapping[sp.Tuple, sp.Symbol]  # by characteristic factor
    # expression of each spectral symbol that factors may contain
    spectrum: Mapping[sp.Symbol, sp.Expr]

    def insert(self, expression: sp.Expr) -> sp.Expr:
        """The expanded expression with these symbols inserted, if that makes it shorter."""
        values = {
            ExponentialDifference(1, TIME, f): g
            - f[1].xreplace(self.spectrum) * ExponentialDifference(0, TIME, f)
            for f, g in self.symbols.items()
        }
        expression = sp.expand(expression)
        inserted = sp.expand(expression.xreplace(values))
        shorter = len(sp.Add.make_args(inserted)) < len(sp.Add.make_args(expression))
        return inserted if shorter else expression

    def functions(self, expression: sp.Expr) -> dict[sp.Expr, sp.Expr]:
        """Coefficient of each function of time in an expanded expression."""
        found: dict[sp.Expr, sp.Expr] = {}
        for term in sp.Add.make_args(expression):
            if term == 0:
                continue
            moving = {*self.symbols.values(), TIME}
            parts = [f for f in sp.Mul.make_args(term) if f.free_symbols & moving]
            function = sp.Mul(*parts)
            found[function] = found.get(function, sp.Integer(0)) + term / function
        return {f: sp.factor_terms(c) for f, c in found.items() if c != 0}


def positions_of(flow: Flow) -> dict[int, int]:
    """Index of the velocity by the index of its position: x' is the state v alone."""
    matrix, offset = flow.field
    found = {}
    for i in range(matrix.rows):
        entries = [j for j in range(matrix.rows) if matrix[i, j] != 0]
        if len(entries) == 1 and entries[0] > i and matrix[i, entries[0]] == 1 and offset[i] == 0:
            found[i] = entries[0]
    return found


@dataclass(frozen=True)
class Modes:
    """Positions as a sum of matrices and columns times functions of time."""

    positions: tuple[int, ...]  # indices of the positions
    # by matrix: functions of time beside the positions at the start, and beside velocities
    matrices: Mapping[sp.Matrix, tuple[sp.Expr, sp.Expr]]
    # by column and index of another state at the start, -1 for none: function of time
    columns: Mapping[sp.Matrix, Mapping[int, sp.Expr]]


def modes_of(flow: Flow, displacements: Displacements) -> Modes | None:
    """Modal form of a motion that is a sum over projectors; None if that is no shorter."""
    pairs = positions_of(flow)
    places = tuple(pairs)
    if len(places) < 2:
        return None
    matrix, offset = flow.matrix(), flow.offset()
    matrices: _Sum = {}
    for side, others in enumerate((places, tuple(pairs.values()))):
        _collect(matrices, side, matrix.extract(list(places), list(others)), displacements)
    projectors = all(_is_projector(m.xreplace(displacements.spectrum)) for m in matrices)
    if len(matrices) > len(places) or not projectors or all(m.is_diagonal() for m in matrices):
        return None
    columns: _Sum = {}
    for start in (*(i for i in range(matrix.rows) if i not in {*pairs, *pairs.values()}), -1):
        whole = sp.Matrix(offset if start < 0 else matrix[:, start])
        _collect(columns, start, whole.extract(list(places), [0]), displacements)
    zero = sp.Integer(0)
    return Modes(
        places, {m: (s.get(0, zero), s.get(1, zero)) for m, s in matrices.items()}, columns
    )


def _collect(found: _Sum, place: int, block: sp.Matrix, displacements: Displacements) -> None:
    """Add a block, as constant matrices times functions of time, to those found at other places."""
    parts: dict[sp.Expr, sp.Matrix] = {}
    for index, entry in enumerate(block):
        for function, coefficient in displacements.functions(displacements.insert(entry)).items():
            parts.setdefault(function, sp.zeros(*block.shape))[index] = coefficient
    for function, part in parts.items():
        known, ratio = _multiple(sp.ImmutableMatrix(part), list(found))
        beside = found.setdefault(known, {})
        beside[place] = beside.get(place, sp.Integer(0)) + ratio * function


def _is_projector(matrix: sp.Matrix) -> bool:
    return bool((matrix * matrix - matrix).applyfunc(sp.expand).is_zero_matrix)


def _multiple(matrix: sp.Matrix, known: Sequence[sp.Matrix]) -> tuple[sp.Matrix, sp.Expr]:
    """A known matrix of which the given one is a multiple, and the ratio.

    If there is none, the matrix itself and 1.
    """
    for other in known:
        place = next(i for i, e in enumerate(other) if e != 0)
        ratio = sp.cancel(matrix[place] / other[place])
        if all(sp.expand(a - ratio * b) == 0 for a, b in zip(matrix, other, strict=True)):
            return other, ratio
    return matrix, sp.Integer(1)


@dataclass(frozen=True)
class Steady:
    """Steady responses of the coordinates to one harmonic forcing."""

    frequency: sp.Expr
    # by coordinate's index: (factors, cosine, sine), coefficients of the factors' response
    terms: Mapping[int, tuple[tuple[Factors, sp.Expr, sp.Expr], ...]]

    @cached_property
    def factors(self) -> tuple[sp.Tuple, ...]:
        """All characteristic factors in the responses."""
        products = (product for found in self.terms.values() for product, _, _ in found)
        return tuple(dict.fromkeys(factor for product in products for factor in product))

    def transfer(self, factor: sp.Tuple) -> tuple[sp.Expr, sp.Expr]:
        """Real and imaginary part of a factor at i times the frequency."""
        w = self.frequency
        coefficients = (*factor, sp.Integer(1))
        powers = [c * (-1) ** (k // 2) * w**k for k, c in enumerate(coefficients)]
        return sp.Add(*powers[::2]), sp.Add(*powers[1::2])


def steady_of(flow: Flow, cosine: int, sine: int) -> Steady | None:
    """Steady responses of all coordinates; None if one has none of this simple form."""
    matrix, frequency = flow.matrix(), flow.field[0][sine, cosine]
    forcing = sp.Tuple(frequency**2, sp.Integer(0))
    found = {}
    for place in positions_of(flow):
        by_cosine = _answers(matrix[place, cosine], forcing)
        by_sine = _answers(matrix[place, sine], forcing)
        if by_cosine is None or by_sine is None:
            return None
        terms = []
        for product in dict.fromkeys((*by_cosine, *by_sine)):
            (plain, rate), (other, turned) = (
                found_by.get(product, (sp.Integer(0), sp.Integer(0)))
                for found_by in (by_cosine, by_sine)
            )
            # the cosine's h' and -w h, the sine's h' and w h
            if sp.expand(other + frequency * rate) != 0 or sp.expand(plain - frequency * turned):
                return None
            terms.append((product, rate, turned))
        if terms:
            found[place] = tuple(terms)
    return Steady(frequency, found) if found else None


def _answers(
    expression: sp.Expr, forcing: sp.Tuple
) -> dict[Factors, tuple[sp.Expr, sp.Expr]] | None:
    """Coefficients of h and h' by product of factors; the forcing's factor is left out.

    None if a term has another form.
    """
    found: dict[Factors, tuple[sp.Expr, sp.Expr]] = {}
    for term in sp.Add.make_args(sp.expand(expression)):
        if term == 0:
            continue
        functions = [f for f in sp.Mul.make_args(term) if TIME in f.free_symbols]
        if len(functions) != 1 or not isinstance(functions[0], ExponentialDifference):
            return None
        order, _, *factors = functions[0].args
        if factors.count(forcing) != 1 or order > 1 or _CONSTANT in factors:
            return None
        product = tuple(f for f in factors if f != forcing)
        coefficients = list(found.get(product, (sp.Integer(0), sp.Integer(0))))
        coefficients[int(order)] += term / functions[0]
        found[product] = (coefficients[0], coefficients[1])
    return found
