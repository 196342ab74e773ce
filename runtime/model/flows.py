"""Flows inside a configuration: states from its functions of time, and exponentials of fields.

Functions of time give every state in double precision. The exponential serves orbits that are
refined to many digits where no flow has a closed form.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from nonsmooth.runtime.core.arithmetic import exact_ball, middle
from nonsmooth.runtime.core.errors import NoConvergence
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.model.factored_flows import FactoredFlows
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.model.time_functions import functions_at

_GUARD = 32  # bits


def extended(states: np.ndarray) -> np.ndarray:
    """States (..., N) with a 1 appended: (..., N + 1)."""
    return np.concatenate([states, np.ones((*states.shape[:-1], 1))], axis=-1)


def functions_of(system: PiecewiseLinear, configuration: int, times: np.ndarray) -> np.ndarray:
    """Values (n, functions) of a configuration's functions of time at times (n,).

    Times are in the system's unit.
    """
    shapes = system.structure.shapes[configuration]
    return np.stack(functions_at(shapes, system.exponents[configuration], times), axis=-1)


def flow_states(
    system: PiecewiseLinear, configuration: int, times: np.ndarray, starts: np.ndarray
) -> np.ndarray:
    """States (n, N) after times (n,) in one configuration, from starts (n, N) or (N,).

    Times and states are in the system's units.
    """
    functions = functions_of(system, configuration, times)
    flows = system.flows[configuration]
    whole = extended(starts)
    if isinstance(flows, FactoredFlows):
        return flows.states(functions, whole)
    if starts.ndim == 1:
        return np.asarray(functions @ (flows @ whole))
    return np.asarray(np.einsum("nf,fij,nj->ni", functions, flows, whole, optimize=True))


def parts_of(system: PiecewiseLinear, configuration: int, starts: np.ndarray) -> np.ndarray:
    """The vectors (n, functions, N) that multiply the functions of time, for starts (n, N).

    States are in the system's units.
    """
    flows, whole = system.flows[configuration], extended(starts)
    if isinstance(flows, FactoredFlows):
        return flows.parts(whole)
    return np.asarray(np.einsum("fij,nj->nfi", flows, whole))


def composite_rule(count: int, pieces: int) -> tuple[np.ndarray, np.ndarray]:
    """Nodes and weights (count * pieces,) of an integral over [0, 1].

    A piece has `count` nodes, which integrate polynomials of degree 2 count - 1 exactly.
    Nodes are ascending, and symmetric to 1/2.

    Examples
    --------
    >>> nodes, weights = composite_rule(2, 3)
    >>> round(float(weights @ nodes**3), 15)
    0.25
    """
    nodes, weights = np.polynomial.legendre.leggauss(count)
    begins = np.arange(pieces)[:, None]
    return ((begins + (nodes + 1) / 2) / pieces).ravel(), np.tile(weights / (2 * pieces), pieces)


def exponential(field: np.ndarray, time: Any, mp: Any) -> np.ndarray:
    """Flow (N, N + 1) of y' = A y + b over a time: its matrix, then its constant.

    It is the exponential of the time times the field (N, N + 1), A and then b, computed in ball
    arithmetic and good to the precision of `mp`; entries are mpmath numbers, integers or complex
    ones, whose errors are relative to the largest entry. Raises `NoConvergence` if no precision is
    enough, as where the motion overflows.
    """
    from flint import acb, acb_mat, arb, arb_mat

    size = len(field)
    entries = [mp.convert(x) for x in field.ravel().tolist()]
    turning = any(isinstance(x, mp.mpc) for x in (*entries, time))
    matrix = acb_mat if turning else arb_mat

    def ball(number: Any) -> Any:
        whole = mp.convert(number)
        return acb(*map(exact_ball, (whole.real, whole.imag))) if turning else exact_ball(whole)

    def number(entry: Any) -> Any:
        if turning:
            return mp.mpc(middle(mp, entry.real), middle(mp, entry.imag))
        return middle(mp, entry)

    def sure(entry: Any, least: Any) -> bool:
        if turning:
            return bool(entry.real.rad() < least and entry.imag.rad() < least)
        return entry.rel_accuracy_bits() >= mp.prec or bool(entry.rad() < least)

    balls, span, bits = list(map(ball, entries)), ball(time), mp.prec + _GUARD
    for _ in range(12):
        with flint_precision(bits):
            scaled = [x * span for x in balls]
            whole = matrix(size + 1, size + 1, [*scaled, *[0] * (size + 1)])
            found = whole.exp().entries()[: size * (size + 1)]
            largest = max((abs(entry).upper() for entry in found), default=arb(1))
            least = largest * arb((1, -mp.prec))
            done = all(sure(entry, least) for entry in found)
        if done:
            return np.array([number(x) for x in found], dtype=object).reshape(size, size + 1)
        bits *= 2
    raise NoConvergence(f"the flow over the time {mp.nstr(time.real, 6)} cannot be computed")
