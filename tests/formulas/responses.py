"""Characteristic factors and impulse responses at numbers, by the exponential of a companion."""

from functools import partial
from itertools import combinations

import numpy as np
import sympy as sp
from scipy.linalg import expm


def response_functions(known, numbers):
    """Factors as polynomials and responses as functions of time, by their LaTeX."""
    found = {}
    for factor in (sp.Tuple(0), *known.factors):
        coefficients = [
            1.0,
            *(float(sp.sympify(c).xreplace(dict(numbers))) for c in reversed(factor)),
        ]
        found[rf"{known.polynomial}_{{{known.number(factor)}}}"] = np.poly1d(coefficients)
    products = {p for q in known.products for n in range(1, len(q) + 1) for p in combinations(q, n)}
    for product in products:
        polynomial = np.poly1d([1.0])
        for factor in product:
            polynomial *= found[rf"{known.polynomial}_{{{known.number(factor)}}}"]
        companion = np.diag(np.ones(polynomial.order - 1), 1)
        companion[-1] = -polynomial.coeffs[:0:-1]
        for order in range(polynomial.order):
            name = known.latex(order, product, "").partition(r"\left(")[0]
            found[name] = partial(_response, companion, order)
    return found


def _response(companion, order, time):
    return float(expm(companion * time)[order, -1])
