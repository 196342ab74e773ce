"""States inside a configuration from its closed-form flow, and times at which means need them."""

from __future__ import annotations

import numpy as np

from nonsmooth.runtime.model.factored_flows import FactoredFlows
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.model.time_functions import functions_at

__all__ = ["composite_rule", "flow_states", "functions_of", "parts_of"]


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
    extended = np.concatenate([starts, np.ones((*starts.shape[:-1], 1))], axis=-1)
    if isinstance(flows, FactoredFlows):
        return flows.states(functions, extended)
    if starts.ndim == 1:
        return np.asarray(functions @ (flows @ extended))
    return np.asarray(np.einsum("nf,fij,nj->ni", functions, flows, extended, optimize=True))


def parts_of(system: PiecewiseLinear, configuration: int, starts: np.ndarray) -> np.ndarray:
    """The vectors (n, functions, N) that multiply the functions of time, for starts (n, N).

    States are in the system's units.
    """
    flows = system.flows[configuration]
    extended = np.concatenate([starts, np.ones((len(starts), 1))], axis=1)
    if isinstance(flows, FactoredFlows):
        return flows.parts(extended)
    return np.asarray(np.einsum("fij,nj->nfi", flows, extended))


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
