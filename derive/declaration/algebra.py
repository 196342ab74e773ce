"""Normal forms of rational expressions and other results, each found once."""

from __future__ import annotations

from collections.abc import Callable, Sequence, Set
from functools import lru_cache, wraps
from typing import Any, TypeVar, cast

import numpy as np
import sympy as sp

_Method = TypeVar("_Method", bound=Callable[..., Any])


def remembered(method: _Method) -> _Method:
    """The method with its results stored in the object, one for each tuple of arguments.

    Unlike `functools.cache` it does not keep its objects alive.
    """
    place = f"_remembered_{method.__name__}"

    @wraps(method)
    def call(owner: Any, *args: Any) -> Any:
        known = owner.__dict__.setdefault(place, {})
        if args not in known:
            known[args] = method(owner, *args)
        return known[args]

    return cast(_Method, call)


@lru_cache(maxsize=1 << 14)  # matrices repeat their entries
def cancel(expression: sp.Expr) -> sp.Expr:
    """Ratio of two expanded polynomials without a common factor, as SymPy gives it."""
    return expression if expression.is_Atom else sp.cancel(expression)


@lru_cache(maxsize=1 << 14)
def factor(expression: sp.Expr) -> sp.Expr:
    """Product of irreducible factors, as SymPy gives it."""
    return expression if expression.is_Atom else sp.factor(expression)


@lru_cache(maxsize=1 << 14)
def factor_terms(expression: sp.Expr) -> sp.Expr:
    """Sum of terms before which stands what they have in common, as SymPy gives it."""
    return expression if expression.is_Atom else sp.factor_terms(expression)


def affine_terms(
    function: sp.Expr, states: Set[sp.Symbol]
) -> tuple[dict[sp.Symbol, sp.Expr], sp.Expr]:
    """Coefficients of the states that occur in an affine function, and its constant.

    The coefficients are read off term by term, so the cost grows with the number of terms,
    not of states. If the function is not affine a coefficient depends on a state.
    """
    found: dict[sp.Symbol, list[sp.Expr]] = {}
    rest = []
    for term in sp.Add.make_args(function):
        here = term.free_symbols & states
        if not here:
            rest.append(term)
        elif term.is_Symbol:
            found.setdefault(term, []).append(sp.S.One)
        elif len(here) == 1 and term.is_Mul and term.args.count(symbol := here.pop()) == 1:
            others = [factor for factor in term.args if factor != symbol]
            found.setdefault(symbol, []).append(term.func(*others))
        else:
            here = term.free_symbols & states
            for symbol in sorted(here, key=str):
                found.setdefault(symbol, []).append(sp.diff(term, symbol))
            rest.append(term.xreplace(dict.fromkeys(here, sp.S.Zero)))
    return {s: sp.Add(*parts) for s, parts in found.items()}, sp.Add(*rest)


def along(row: sp.Matrix, values: Sequence[sp.Expr]) -> sp.Expr:
    """Sum of the values, weighted by the entries of a row."""
    return sp.Add(*(weight * values[j] for (_, j), weight in row.todok().items()))


def is_affine(function: sp.Expr, states: Set[sp.Symbol]) -> bool:
    """Whether a function is affine in the states."""
    slopes, _ = affine_terms(function, states)
    return not any(slope.free_symbols & states for slope in slopes.values())


def bordered(matrix: sp.Matrix, offset: sp.Matrix, last: int = 1) -> sp.Matrix:
    """The matrix [[matrix, offset], [0, last]] of an affine map, or with 0 of a field."""
    below = sp.Matrix([[0] * matrix.cols + [last]])
    return sp.Matrix.vstack(sp.Matrix.hstack(matrix, offset), below)


def frozen(matrix: sp.Matrix) -> sp.ImmutableMatrix:
    """The matrix itself if it is immutable, else an immutable copy."""
    return matrix if isinstance(matrix, sp.ImmutableMatrix) else matrix.as_immutable()


def inverse(matrix: sp.Matrix) -> sp.Matrix:
    """Inverse of a square matrix with its entries cancelled; exact for rational numbers."""
    if not _is_rational(matrix):
        return matrix.as_mutable().inv().applyfunc(cancel)
    if matrix.is_diagonal():
        entries = {place: 1 / entry for place, entry in matrix.todok().items()}
        return sp.Matrix.from_dok(*matrix.shape, entries)
    return matrix.to_DM().to_field().inv().to_Matrix()


@lru_cache(maxsize=64)
def is_surely_positive_definite(matrix: sp.ImmutableMatrix) -> bool:
    """Whether a matrix of rational numbers is shown to be positive definite by doubles.

    The proof is that Cholesky's factorisation succeeds for the matrix less a bound of all
    rounding errors (Rump 2006). False means "not shown": the matrix may be nearly singular,
    or contain symbols.
    """
    if not _is_rational(matrix) or matrix != matrix.T:
        return False
    try:
        numbers = np.array(matrix.tolist(), dtype=float)
    except OverflowError:
        return False
    size = len(numbers)
    largest, trace = abs(numbers).max(), abs(numbers.diagonal()).sum()
    rounding = 4 * (size + 2) * np.finfo(float).eps * (trace + size * largest)
    if not (np.isfinite(rounding) and rounding > 1e-280):  # nothing overflows or underflows
        return False
    try:
        np.linalg.cholesky(numbers - rounding * np.eye(size))
    except np.linalg.LinAlgError:
        return False
    return True


def symbols_of(matrix: sp.Matrix) -> set[sp.Symbol]:
    """Symbols that occur in a matrix."""
    return set().union(*(entry.free_symbols for entry in matrix.todok().values()))


def _is_rational(matrix: sp.Matrix) -> bool:
    return all(entry.is_Rational for entry in matrix.todok().values())
