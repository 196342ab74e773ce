"""Quasi-polynomials of tests, from their exponents or from their waves."""

from nonsmooth.runtime.events.quasi_polynomials import QuasiPolynomial, plain_functions


def plain_sum(exponents, polynomials):
    """Add up the real parts of ``P_m(t) e^(lambda_m t)``, behind a constant 0 if there is none."""
    if not (len(exponents) and exponents[0] == 0):
        exponents, polynomials = (0j, *exponents), ((0j,), *polynomials)
    factors = tuple(complex(factor) for each in polynomials for factor in each)
    functions = plain_functions(list(map(complex, exponents)), list(map(len, polynomials)))
    return QuasiPolynomial(functions, factors, tuple(map(abs, factors)))


def trigonometric(
    constant,
    slope,
    cosines,
    sines,
    frequencies,
):
    """Add up a line and waves."""
    waves = [(complex(c, -s),) for c, s in zip(cosines, sines, strict=True)]
    return plain_sum([0j, *(1j * w for w in frequencies)], [(constant, slope), *waves])
