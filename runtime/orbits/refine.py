"""An orbit to any number of digits: Newton's method with growing precision.

The full equations of kernels are iterated in any arithmetic. With balls (python-flint) the
last step is Krawczyk's: the box it verifies contains exactly one solution, so the digits
are proved; with mpmath the result is compared with one at twice the precision. The trace over
that box is an enclosure. Orbits by the tables of their system are refined with mpmath.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.arithmetic import Balls, Mpmath, exact_ball, middle
from nonsmooth.runtime.core.errors import InputError, NoConvergence, check_integer
from nonsmooth.runtime.model.piecewise import piecewise_in
from nonsmooth.runtime.orbits.orbit import GUARD, Orbit, check_converged, kernel_arguments
from nonsmooth.runtime.shooting.closure_conditions import closing, closure_equations
from nonsmooth.runtime.shooting.newton import MARGIN, climb, lost, precisions
from nonsmooth.runtime.shooting.shooting_map import Shooting, numbers_in, shoot
from nonsmooth.runtime.shooting.symmetry import part_of, symmetry_of, whole_orbit
from nonsmooth.runtime.shooting.table_newton import sizes
from nonsmooth.runtime.shooting.translations import up_to_shift

ARITHMETICS = ("flint", "mpmath", "both")
MOST_DIGITS = 100_000
_START_DIGITS, _START_DIGITS_OF_TABLES = 15, 14


def refine(orbit: Orbit, digits: int, *, arithmetic: str = "flint") -> Orbit:
    """Refine an orbit to true decimal digits.

    Parameters
    ----------
    orbit : Orbit
        A converged orbit; its parameters are taken exactly as they were given.
    digits : int
        The error of each unknown x will be at most ``10^-digits max(1, |x|)``.
    arithmetic : {"flint", "mpmath", "both"}
        Balls, whose digits are proved; mpmath (on gmpy2 where that is installed), whose digits
        are checked against twice the precision; or both, each to so many digits by its own
        route, which have to agree: the numbers are those of the balls. Where no finite
        enclosure of the trace is found, as at a grazing, the unknowns alone are compared. An
        orbit without kernels of its own takes mpmath, and cannot take both.

    Returns
    -------
    Orbit
        With mpmath numbers; its `residual` is the largest left-hand side of the equations.

    Raises
    ------
    InputError
        For digits outside 1 ... 100000, an orbit that has not converged, a symmetry that
        holds in double precision only, or both arithmetics for an orbit without kernels.
    NoConvergence
        If Newton's method leaves the orbit, as it does where the equations are singular, or
        if the two arithmetics differ by more than 10^-digits, in an unknown or in the trace
        where that is enclosed.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> orbit = ns.refine(ns.solve("dry-friction/global-stick"), 40)
    >>> orbit.residual < 1e-39
    True
    """
    if arithmetic == "both":
        return refine_both(orbit, digits).by_balls
    check_digits(digits)
    check_converged(orbit, "refined")
    if arithmetic not in ARITHMETICS:
        raise InputError(f"arithmetic is {arithmetic!r}, none of {', '.join(ARITHMETICS)}")
    return orbit.problem.refined(orbit, digits, arithmetic)


class Refined(NamedTuple):
    """An orbit refined by both arithmetics, and how far they differ."""

    by_balls: Orbit
    by_mpmath: Orbit
    # of an unknown, or of mpmath's trace from the enclosure by balls, over max(1, |x|)
    difference: Any
    compared: tuple[str, ...]  # "unknowns", and "trace" if there is a finite enclosure


def refine_both(orbit: Orbit, digits: int) -> Refined:
    """Refine an orbit by balls and by mpmath, each by its own route, and compare the two.

    The trace of mpmath's orbit, by mpmath, has to lie in the enclosure by balls. Where that is not
    finite the traces are not compared: they may have few digits in common, or none. Errors are
    raised as by `refine`.
    """
    check_digits(digits)
    check_converged(orbit, "refined")
    if orbit.problem.kernels is None:
        raise InputError(f"{orbit.name} has no kernels of its own: mpmath alone refines it")
    by_balls, by_mpmath = (orbit.problem.refined(orbit, digits, a) for a in ARITHMETICS[:2])
    mp, ball = by_balls.arithmetic.mp, enclosed_trace(by_balls)
    unknowns = ((x, by_mpmath.unknowns[name]) for name, x in by_balls.unknowns.items())
    differences = [abs(x - y) / max(1, abs(x)) for x, y in unknowns]
    enclosed = ball is not None and ball.is_finite()
    if enclosed:
        trace = by_mpmath.trace
        outside = abs(trace - middle(mp, ball)) - middle(mp, ball.rad())
        differences.append(max(outside, mp.zero) / max(1, abs(trace)))
    difference = max(differences)
    if not difference <= mp.mpf(10) ** -digits:
        raise NoConvergence(
            f"{orbit.name}: flint and mpmath differ by {float(difference):.1e} at {digits} digits"
        )
    compared = ("unknowns", "trace") if enclosed else ("unknowns",)
    return Refined(by_balls, by_mpmath, difference, compared)


def enclosed_trace(orbit: Orbit) -> Any:
    """Ball around the trace of the orbit with kernels that a box around a refined one holds.

    The box holds exactly one solution of the orbit's equations; None if that is not shown.
    """
    lib = Balls()
    x = [exact_ball(value) for value in orbit.unknowns.values()]
    with lib.working(_bits(orbit.digits + GUARD + 2 * MARGIN)):
        radii, _ = _krawczyk(orbit, x, lib)
        if radii is None:
            return None
        box = [v + r * lib.flint.arb(0, 1) for v, r in zip(x, radii, strict=True)]
        at = _arguments(orbit, box, lib)
        return lib.flint.arb(orbit.kernels.evaluate("trace", at=at, lib=lib))


def check_digits(digits: int) -> None:
    """Refuse a number of digits that is no integer, or out of range."""
    check_integer("digits", digits, 1, MOST_DIGITS)


def refine_kernels(orbit: Orbit, digits: int, arithmetic: str) -> Orbit:
    """Refine an orbit by the kernels of its own equations to so many true digits, as `refine` does.

    The arithmetic is ``flint`` for balls, else mpmath. `NoConvergence` is raised if
    Newton's method leaves the orbit.
    """
    route = _with_balls if arithmetic == "flint" else _with_mpmath
    unknowns, residual, iterations = route(orbit, digits + GUARD)
    named = dict(zip(orbit.unknowns, unknowns, strict=True))
    return replace(orbit, unknowns=named, residual=residual, digits=digits, iterations=iterations)


def _arguments(orbit: Orbit, x: Sequence[Any] | np.ndarray, lib: Any) -> Any:
    """Return what the kernels of an orbit take, in any arithmetic, where its unknowns are x."""
    values = {name: lib.number(value) for name, value in orbit.given.items()}
    values |= dict(zip(orbit.unknowns, x, strict=True))
    return kernel_arguments(orbit.kernels, values, lib)


def _equations(
    orbit: Orbit, x: Sequence[Any] | np.ndarray, lib: Any
) -> tuple[list[Any], list[list[Any]]]:
    """Return the residual and its Jacobian by what was solved for, at x, in any arithmetic."""
    kernels, at = orbit.kernels, _arguments(orbit, x, lib)
    if tuple(orbit.unknowns) == kernels.unknowns:
        residual, by_unknowns = kernels.evaluate("residual", "jacobian", at=at, lib=lib)
        return residual, by_unknowns
    residual, by_unknowns, by_parameters = kernels.evaluate(
        "residual", "jacobian", "parameter_jacobian", at=at, lib=lib
    )
    order = [*kernels.unknowns, *kernels.parameter_names]
    places = [order.index(name) for name in orbit.unknowns]
    rows = zip(by_unknowns, by_parameters, strict=True)
    return residual, [[([*a, *b])[i] for i in places] for a, b in rows]


def _with_mpmath(orbit: Orbit, digits: int) -> tuple[Any, Any, int]:
    lib = Mpmath(_START_DIGITS)

    def step_at(x: np.ndarray, _: bool) -> tuple[list[Any], list[Any]]:
        residual, jacobian = _equations(orbit, x, lib)
        return [-s for s in lib.solve(jacobian, residual)], residual

    start = np.array([lib.mp.mpf(value) for value in orbit.unknowns.values()], dtype=object)
    x, residual, count = climb(lib, start, step_at, digits, _START_DIGITS, orbit.name)
    mp = Mpmath(digits + MARGIN).mp  # a context rounds to its own precision when it computes
    return [mp.mpf(v) for v in x], mp.mpf(max(abs(r) for r in residual)), count


def _with_balls(orbit: Orbit, digits: int) -> tuple[list[Any], Any, int]:
    lib = Balls()
    x = [exact_ball(value) for value in orbit.unknowns.values()]
    steps = precisions(digits, _START_DIGITS)
    for precision in steps:
        with lib.working(_bits(precision + MARGIN)):
            residual, jacobian = _equations(orbit, x, lib)
            try:
                step = lib.solve(jacobian, residual)
            except ZeroDivisionError:
                raise lost(orbit.name, precision) from None
            x = [(v - s).mid() for v, s in zip(x, step, strict=True)]
    with lib.working(_bits(digits + 2 * MARGIN)):
        radii, residual = _krawczyk(orbit, x, lib)
        bound = lib.rational(1, 10 ** (digits - MARGIN))
        if radii is None or not all(r < bound for r in radii):
            raise lost(orbit.name, digits)
        mp = Mpmath(digits + MARGIN).mp
        largest = max(middle(mp, abs(r).upper()) for r in residual)
        return [middle(mp, v) for v in x], largest, len(steps) + 1


def _krawczyk(orbit: Orbit, x: list[Any], lib: Balls) -> tuple[list[Any] | None, list[Any]]:
    """Return radii of a box around x that provably holds one solution, and the residual at x.

    The radii are None if that is not shown.
    K(X) = x - Y F(x) + (I - Y F'(X)) (X - x) is inside the interior of X, with Y near
    F'(x)^-1 (Krawczyk's test).
    """
    matrix, ball = lib.flint.arb_mat, lib.flint.arb
    residual, jacobian = _equations(orbit, x, lib)
    try:
        inverse = matrix(jacobian).mid().inv().mid()
    except ZeroDivisionError:
        return None, residual
    offset = (inverse * matrix([[r] for r in residual])).entries()
    tiny = ball(2) ** (-lib.flint.ctx.prec)
    radii = [
        2 * abs(o).upper() + tiny * (1 + abs(v)).upper() for o, v in zip(offset, x, strict=True)
    ]
    box = [v + r * ball(0, 1) for v, r in zip(x, radii, strict=True)]
    _, spread = _equations(orbit, box, lib)
    unit = matrix([[int(i == j) for j in range(len(x))] for i in range(len(x))])
    contraction = unit - inverse * matrix(spread)
    growth = [
        sum((abs(contraction[i, j]).upper() * radii[j] for j in range(len(x))), ball(0))
        for i in range(len(x))
    ]
    inside = all(abs(o) + g < r for o, g, r in zip(offset, growth, radii, strict=True))
    return (radii if inside else None), residual


def _bits(digits: int) -> int:
    return math.ceil(digits * math.log2(10)) + 8


def refine_tables(orbit: Orbit, digits: int) -> Orbit:
    """Refine an orbit by the tables of its system to so many true digits, with mpmath.

    The last step, at twice the digits, has to correct nothing that counts. `InputError` is
    raised if a symmetry holds in double precision only, `NoConvergence` if Newton's method
    leaves the orbit, as it does where the equations are singular.
    """
    lib, wanted = Mpmath(_START_DIGITS_OF_TABLES), digits + GUARD
    system, parameters, symmetry = orbit.system, orbit.parameters, orbit.symmetry
    cycle, period = orbit.tables.cycle, orbit.given_period
    order = 1 if symmetry is None else symmetry.order
    if period is not None and symmetry is not None:
        period = part_of(period, order)
    size = len(orbit.states[0])

    def step_at(x: np.ndarray, last: bool) -> tuple[Any, tuple[np.ndarray, Shooting]]:
        state, times = x[:size], x[size:]
        point = piecewise_in(system, parameters, lib)
        if symmetry is not None and last:
            symmetry_of(point, symmetry.matrix, lib.mp.mpf(10) ** -wanted)
        point, part, directions = closing(point, cycle.at(point.structure), symmetry)
        numbers = numbers_in(point)
        now = shoot(part, numbers, times, state, lib.mp)
        size_of = sizes(now, times)
        total = None if period is None else lib.number(period)
        matrix, right = closure_equations(part, numbers, now, times, size_of, total, lib=lib)
        # more equations than unknowns are solved in the sense of least squares
        step = np.array(lib.solve(matrix.tolist(), right.tolist()), dtype=object) * size_of
        change = now.rates[:, :-1] @ step + now.rates[:, -1]
        return [*step, *change], (directions, now)

    dwell = orbit.dwell_times[: len(cycle) // order]
    known = np.array([lib.mp.mpf(float(v)) for v in (*orbit.states[0], *dwell)], dtype=object)
    name = cycle.structure.name
    x, (directions, now), count = climb(lib, known, step_at, wanted, _START_DIGITS_OF_TABLES, name)
    last = Mpmath(wanted)  # a context rounds to its own precision when it computes
    left = [*now.residual, *(now.starts[-1] - now.starts[0])]
    rounded = np.vectorize(last.mp.mpf, otypes=[object])
    states = rounded(now.starts[:-1])
    states[0] = up_to_shift(states[0], directions)
    with last.working(wanted):
        point = piecewise_in(system, parameters, last)
        whole, part = cycle.at(point.structure), (rounded(x[size:]), states)
        dwell, states = whole_orbit(point, whole, symmetry, *part, last.mp)
    unknowns = [*dwell.tolist(), *states[0].tolist()]
    return replace(
        orbit,
        unknowns=dict(zip(orbit.unknowns, unknowns, strict=True)),
        residual=last.mp.mpf(max(map(abs, left))),
        digits=digits,
        iterations=orbit.iterations + count,
        starts=states,
    )
