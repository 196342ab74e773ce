"""Flow of any linear motion, read off its resolvent.

With B = [[A, b], [0, 0]] the motion y' = A y + b is the first part of e^(Bt), whose Laplace
transform is the resolvent (s - B)^-1. B falls into blocks, each of which drives only those
behind it: a forcing drives a mass and is not driven, a held coordinate drives the free ones,
and the constant 1 drives them all. Block by block the resolvent is a sum of

    polynomial matrix in s  /  product of characteristic factors,

so that the flow is a sum of matrices times :class:`ExponentialDifference`, which have no
singularity where roots of the factors meet: at critical damping, in resonance, at a stiffness
of zero.

A block of second order, x'' + D x' + L x = ..., in which D and L commute, falls further into its
modes, where the eigenvalues of L are known to be distinct.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import count
from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from nonsmooth.derive.declaration.algebra import bordered, cancel, factor_terms
from nonsmooth.derive.declaration.parameter import Parameter, is_positive, sign_of
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.symbols import Symbol

# A block whose characteristic polynomial does not factor further is written out up to here. Beyond,
# doubles lose digits: of 100 periods of 3, 4 and 5 damped masses in a row the worst errors were
# 1.4, 6 and 70 times the unit of tests/derive/test_flow_accuracy.py, their conditions in it.
MOST_ROOTS = 6
_NEAR = sp.Rational(1, 10**4)


# rectangular blocks by their characteristic factors and the power of s; a factor is a monic
# polynomial by its coefficients, from the constant up, without the leading one
_Key = tuple[tuple[sp.Tuple, ...], int]
_Sum = dict[_Key, DomainMatrix]


class SpectralNames:
    """Spectral symbols in use, so that equal expressions of two configurations share one."""

    def __init__(self, states: tuple[sp.Symbol, ...], parameters: tuple[Parameter, ...]) -> None:
        self.parameters = parameters
        self.taken = {*map(str, states), *(p.name for p in parameters)}
        self.entries: dict[sp.Expr, sp.Symbol] = {}
        self.resolvents: dict[sp.ImmutableMatrix, _Sum] = {}  # of blocks of configurations

    def positive(self, expression: sp.Expr) -> bool:
        """Whether an expression is shown to be positive on the domains of the parameters."""
        return is_positive(expression, self.parameters)

    def symbol(self, stem: str, expression: sp.Expr) -> sp.Expr:
        """Symbol in place of an expression; the expression itself if it is a number or a symbol."""
        expression = sp.sympify(expression)
        if expression.is_number or expression.is_Symbol:
            return expression
        if expression not in self.entries:
            assumptions = {"positive": True} if expression.is_positive else {"real": True}
            symbols = (Symbol("spectrum", stem, i, **assumptions) for i in count(1))
            found = next(s for s in symbols if s.name not in self.taken)
            self.taken.add(found.name)
            self.entries[expression] = found
        return self.entries[expression]

    def coefficient(self, expression: sp.Expr) -> sp.Expr:
        """A coefficient of a characteristic factor, named if it is long or may be rewritten.

        Factors are identified by their coefficients, which must survive an expansion of the
        expressions that contain them: (1 + g)/g would become 1 + 1/g.
        """
        simple = expression.count_ops() <= 2 and sp.expand(expression) == expression
        return expression if simple else self.symbol("factor", expression)


def resolvent(
    matrix: sp.Matrix, offset: sp.Matrix, names: SpectralNames
) -> list[tuple[_Key, sp.Matrix]]:
    """The resolvent of ``y' = matrix y + offset`` as a sum of fractions.

    Each is a key, the characteristic factors below and the power of s above, with a matrix
    N x (N + 1), whose last column is the offset's. `names` are those of the system's spectrum so
    far, to which roots are added. DerivationError refuses a block with more than `MOST_ROOTS`
    roots and no modes.
    """
    size = matrix.rows
    augmented = bordered(matrix, offset, 0)
    # each drives only those behind it
    blocks = [sorted(block) for block in augmented.strongly_connected_components()]
    local = []
    for block in blocks:
        part = sp.ImmutableMatrix(augmented.extract(block, block))
        if part not in names.resolvents:
            names.resolvents[part] = _local(part, names)
        local.append(names.resolvents[part])
    found: dict[_Key, sp.Matrix] = {}
    for first, source in enumerate(blocks):
        reached: dict[int, _Sum] = {first: local[first]}
        for later in range(first + 1, len(blocks)):
            arriving: _Sum = {}
            for before, fractions in reached.items():
                link = augmented.extract(blocks[later], blocks[before])
                if not link.is_zero_matrix:
                    _add(arriving, _product({((), 0): _exact(link)}, fractions))
            if arriving:
                reached[later] = _product(local[later], arriving)
        for target, fractions in reached.items():
            for key, numerator in fractions.items():
                whole = found.setdefault(key, sp.zeros(size + 1, size + 1))
                entries = numerator.to_Matrix().applyfunc(_shown)
                for i, row in enumerate(blocks[target]):
                    for j, column in enumerate(source):
                        whole[row, column] = entries[i, j]
    order = {factors: place for place, (factors, _) in reversed([*enumerate(found)])}
    keys = sorted(found, key=lambda key: (order[key[0]], key[1]))
    return [(key, found[key][:size, :]) for key in keys]


def _exact(matrix: sp.Matrix) -> DomainMatrix:
    """A matrix over a field of rational functions, where equal terms cancel by themselves."""
    return DomainMatrix.from_Matrix(matrix.applyfunc(_hidden)).to_field().to_sparse()


class _Opaque(sp.Symbol):
    """A symbol for what is no rational function: an irrational number, a root of parameters."""

    value: sp.Expr

    def __new__(cls, value: sp.Expr) -> _Opaque:
        found: _Opaque = sp.Symbol.__new__(cls, f"opaque {value}")
        found.value = value
        return found


def _hidden(expression: sp.Expr) -> sp.Expr:
    """The expression with such symbols for what is no rational function."""
    return expression.replace(_is_opaque, _Opaque)


def _is_opaque(expression: sp.Expr) -> bool:
    if expression.is_Pow:
        return not expression.exp.is_Integer
    if expression.is_Add or expression.is_Mul or expression.is_Rational:
        return False
    return bool(expression.is_Function or expression.is_number)


def _shown(expression: sp.Expr) -> sp.Expr:
    """The expression with those symbols replaced by what they stand for."""
    found = expression
    while opaque := found.atoms(_Opaque):  # a root may stand for one of another
        found = found.xreplace({o: o.value for o in opaque})
    return factor_terms(found if found is expression else cancel(found))


def _add(total: _Sum, more: _Sum) -> None:
    for key, block in more.items():
        one, other = total.get(key, block * 0).unify(block)
        total[key] = one + other


def _product(left: _Sum, right: _Sum) -> _Sum:
    total: _Sum = {}
    for (first, i), a in left.items():
        for (second, j), b in right.items():
            factors = tuple(sorted((*first, *second), key=sp.default_sort_key))
            one, other = a.unify(b)
            _add(total, {(factors, i + j): one * other})
    return total


def _local(block: sp.ImmutableMatrix, names: SpectralNames) -> _Sum:
    """Resolvent of one block by itself."""
    modes = _modes(block, names) if block.rows > 2 else None
    if modes is not None:
        return modes
    size = block.rows
    if size > MOST_ROOTS:
        raise DerivationError(
            f"its characteristic polynomial has a part of {size} roots, which has neither"
            " modes nor a readable closed form"
        )
    # adj(s - K) = sum_k s^k N_k
    matrix = _exact(block)
    identity = DomainMatrix.eye(size, matrix.domain)
    coefficients = _characteristic(matrix)
    numerators = [identity]
    for coefficient in reversed(coefficients[1:]):
        numerators.insert(0, matrix * numerators[0] + identity.scalarmul(coefficient))
    factors = _factors([_shown(matrix.domain.to_sympy(c)) for c in coefficients])
    return {(factors, k): numerator for k, numerator in enumerate(numerators)}


def _characteristic(matrix: DomainMatrix) -> list[Any]:
    """Coefficients of the characteristic polynomial, from the constant up, without the leading.

    They are elements of the matrix's domain: of thirty masses a determinant of expressions has
    no end.
    """
    return list(reversed(matrix.charpoly()[1:]))


def _factors(coefficients: Sequence[sp.Expr]) -> tuple[sp.Tuple, ...]:
    """Irreducible factors of a monic polynomial; one of degree two stays whole, as a pair."""
    if len(coefficients) <= 2:
        return (sp.Tuple(*coefficients),)
    found = _irreducible(coefficients)
    factors = [sp.Tuple(*factor) for factor, times in found for _ in range(times)]
    return tuple(sorted(factors, key=sp.default_sort_key))


def _irreducible(coefficients: Sequence[sp.Expr]) -> list[tuple[list[sp.Expr], int]]:
    """Irreducible factors of a monic polynomial, each with its multiplicity.

    A polynomial is given by its coefficients from the constant up, without the leading one.
    """
    s = sp.Dummy("s")
    polynomial = s ** len(coefficients) + sum(_hidden(c) * s**k for k, c in enumerate(coefficients))
    factors = []
    for factor, multiplicity in sp.factor_list(polynomial, s)[1]:
        *rest, leading = reversed(sp.Poly(factor, s).all_coeffs())
        if rest:
            factors.append(([_tidy(_shown(c / leading)) for c in rest], multiplicity))
    return factors


def _modes(block: sp.Matrix, names: SpectralNames) -> _Sum | None:
    """Resolvent of x'' + D x' + L x = 0 mode by mode; None unless D and L commute."""
    size = block.rows // 2
    places = _positions(block)
    if places is None:
        return None
    positions, velocities = places
    stiffness = -block.extract(velocities, positions)
    damping = -block.extract(velocities, velocities)
    if not (stiffness * damping - damping * stiffness).applyfunc(_tidy).is_zero_matrix:
        return None
    projectors = _projectors(stiffness, names)
    if projectors is None:
        return None
    total: _Sum = {}
    for eigenvalue, projector in projectors:
        rate = _tidy((damping * projector).trace())
        zeroth, first = sp.zeros(2 * size, 2 * size), sp.zeros(2 * size, 2 * size)
        for i, (x, v) in enumerate(zip(positions, velocities, strict=True)):
            for j, (y, w) in enumerate(zip(positions, velocities, strict=True)):
                p = projector[i, j]
                zeroth[x, y], first[x, y] = rate * p, p
                zeroth[x, w], zeroth[v, y] = p, -eigenvalue * p
                first[v, w] = p
        factors = (sp.Tuple(eigenvalue, rate),)
        _add(total, {(factors, 0): _exact(zeroth), (factors, 1): _exact(first)})
    return total


def _positions(block: sp.Matrix) -> tuple[list[int], list[int]] | None:
    """Positions of a block of second order, and the velocity of each; None for another block."""
    positions: list[int] = []
    velocities: list[int] = []
    for i in range(block.rows):
        entries = {j: e for j, e in enumerate(block.row(i)) if e != 0}
        if list(entries.values()) == [1]:
            positions.append(i)
            velocities += entries
    distinct = len({*positions, *velocities}) == block.rows == 2 * len(positions)
    return (positions, velocities) if distinct else None


def _projectors(matrix: sp.Matrix, names: SpectralNames) -> list[tuple[sp.Expr, sp.Matrix]] | None:
    """Eigenvalues and projectors of a matrix if its eigenvalues are shown real and distinct."""
    eigenvalues = _eigenvalues(matrix, names)
    if eigenvalues is None:
        return None
    found: list[tuple[sp.Expr, sp.Matrix]] = []
    rest = sp.eye(matrix.rows)
    for one in eigenvalues[:-1]:
        projector = sp.eye(matrix.rows)
        for other in eigenvalues:
            if other is not one:
                projector = projector * (matrix - other * sp.eye(matrix.rows)) / (one - other)
        projector = projector.applyfunc(lambda e: names.symbol("p", _plain(e)))
        found.append((one, projector))
        rest = rest - projector
    # they add up to one exactly: errors of projectors that nearly cancel do so too
    return [*found, (eigenvalues[-1], rest)]


def _eigenvalues(matrix: sp.Matrix, names: SpectralNames) -> list[sp.Expr] | None:
    """Real, distinct eigenvalues in radicals; None where they are not shown to be."""
    exact = _exact(matrix)
    coefficients = [_shown(exact.domain.to_sympy(c)) for c in _characteristic(exact)]
    found: list[sp.Expr] = []
    for factor, multiplicity in _irreducible(coefficients):
        if multiplicity > 1 or len(factor) > 2:
            return None
        roots = _roots(factor, names)
        if roots is None or not all(_apart(a, b, names) for a in roots for b in found):
            return None
        found += roots
    return found


def _roots(coefficients: Sequence[sp.Expr], names: SpectralNames) -> list[sp.Expr] | None:
    """Real, distinct roots of a monic polynomial of degree one or two; None if not shown."""
    if len(coefficients) == 1:
        return [-coefficients[0]]
    product, negative_sum = coefficients
    discriminant = _tidy(negative_sum**2 - 4 * product)
    if not names.positive(discriminant):
        return None
    if discriminant.is_number and discriminant < negative_sum**2 * _NEAR:
        return None  # known to nearly coalesce: the projectors would cancel
    gap = names.symbol("gap", _plain(sp.sqrt(discriminant)))
    larger = names.symbol("lambda", _plain((gap - negative_sum) / 2))
    # the smaller one by the product of both: a difference would cancel
    stable = names.positive(product) and names.positive(-negative_sum)
    smaller = product / larger if stable else (-negative_sum - gap) / 2
    return [larger, names.symbol("lambda", _plain(smaller))]


def _apart(one: sp.Expr, other: sp.Expr, names: SpectralNames) -> bool:
    """Whether the roots of two factors are shown to be distinct, numbers by a margin."""
    difference = one - other
    if difference.is_number:
        return bool(difference**2 > _NEAR * (one**2 + other**2))
    return sign_of(difference, names.parameters) in (1, -1)


def _tidy(expression: sp.Expr) -> sp.Expr:
    """A rational function in its shortest usual form."""
    return factor_terms(cancel(expression))


def _plain(expression: sp.Expr) -> sp.Expr:
    return sp.radsimp(sp.expand(expression)) if expression.is_number else expression
