"""Derivatives of flows by the entries of their fields.

A change dG of the field y' = G (y, 1) moves the state after a time d by the integral of
Phi(d - s) dG (y(s), 1), where Phi is the linear part of the flow. With the functions of time
phi_f, the matrices B_f in Phi = sum phi_f B_f and the parts of the state in y = sum phi_g y_g
that is sum_f B_f dG sum_g Q_fg (y_g, ...), where Q_fg is the integral of phi_f(d - s) phi_g(s):
one small matrix for each phase has the derivatives by all parameters, and their adjoint.

Q is found by Gauss and Legendre's rule with twenty nodes on pieces of at most ten radians of
the fastest oscillation. A product of two functions turns by twice as much, and the rule's error
is below h^40 3e-60 = 3e-20 for half of that, h = 10.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from nonsmooth.runtime.model.factored_flows import FactoredFlows, matrices_of
from nonsmooth.runtime.model.flows import composite_rule, functions_of, parts_of
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.simulation.phase_functions import fastest

__all__ = ["PhaseFlows", "flow_matrices", "rule_on", "rule_pieces"]

_NODES = 20  # of an integral, in a piece
_ANGLE = 10.0  # radians in a piece
_FEW = 4
_CHUNK = 2_000_000  # numbers in memory at a time


class _DenseFlows:
    """Flows of one configuration over n durations from n starts, with their derivatives.

    They are computed from a matrix for each function of time.
    """

    def __init__(
        self,
        system: PiecewiseLinear,
        configuration: int,
        durations: np.ndarray,
        starts: np.ndarray,
    ) -> None:
        flows = matrices_of(system.flows[configuration])[:, :, :-1]
        # (n, N, N), derivatives of the end states by the start states
        self.matrices = flow_matrices(system, configuration, durations)
        # (functions, N, N) as one matrix (N, functions N) that adds up
        self._size = flows.shape[1]
        self._flows = flows.transpose(1, 0, 2).reshape(self._size, -1)
        products, integrals = _convolutions(system, configuration, durations)
        parts = products @ parts_of(system, configuration, starts)
        self._parts = np.concatenate([parts, integrals[..., None]], axis=-1)

    def changes(self, fields: np.ndarray) -> np.ndarray:
        """Derivatives (n, N, q) of the end states by q parameters.

        `fields` (q, N, N + 1) are the derivatives of the vector field by them.
        """
        count, functions, width = self._parts.shape
        flat = fields.transpose(2, 1, 0).reshape(width, -1)
        turned = self._parts.reshape(-1, width) @ flat
        return np.asarray(self._flows @ turned.reshape(count, functions * self._size, -1))

    def gradients(self, cotangents: np.ndarray) -> np.ndarray:
        """Derivative (N, N + 1) by the field of the end states weighted with `cotangents` (n, N).

        It is a sum over all durations.
        """
        count, functions, width = self._parts.shape
        pulled = (cotangents @ self._flows).reshape(count * functions, self._size)
        return np.asarray(pulled.T @ self._parts.reshape(-1, width))


class _FactoredFlows:
    """The same from about 2 N columns and rows, with no matrix for each function of time."""

    def __init__(
        self,
        system: PiecewiseLinear,
        configuration: int,
        durations: np.ndarray,
        starts: np.ndarray,
    ) -> None:
        flows = system.flows[configuration]
        assert isinstance(flows, FactoredFlows)
        self.matrices = flow_matrices(system, configuration, durations)
        places, self._columns, rows = flows.terms()
        self._rows = rows[:, :-1]
        weights = starts @ rows[:, :-1].T + rows[:, -1]
        products, integrals = _convolutions(system, configuration, durations)
        self._products = products[:, places][:, :, places] * weights[:, None]
        self._integrals = integrals[:, places]

    def changes(self, fields: np.ndarray) -> np.ndarray:
        """See `_DenseFlows`."""
        found = np.empty((*self.matrices.shape[:2], len(fields)))
        for place, field in enumerate(fields):
            turned = self._rows @ field[:, :-1] @ self._columns.T
            factors = np.einsum("nfg,fg->nf", self._products, turned)
            factors += self._integrals * (self._rows @ field[:, -1])
            found[..., place] = factors @ self._columns
        return found

    def gradients(self, cotangents: np.ndarray) -> np.ndarray:
        """See `_DenseFlows`."""
        factors = cotangents @ self._columns.T
        turned = np.einsum("nfg,nf->fg", self._products, factors)
        linear = self._rows.T @ turned @ self._columns
        constant = (factors * self._integrals).sum(axis=0) @ self._rows
        return np.concatenate([linear, constant[:, None]], axis=1)


def flow_matrices(system: PiecewiseLinear, configuration: int, durations: np.ndarray) -> np.ndarray:
    """Derivatives (n, N, N) of the states after durations (n,) by the states at the beginning."""
    functions, flows = functions_of(system, configuration, durations), system.flows[configuration]
    if isinstance(flows, FactoredFlows):
        return flows.at(functions)[..., :-1]
    return np.asarray(np.tensordot(functions, flows[:, :, :-1], axes=1))


_Flows = _DenseFlows | _FactoredFlows


class PhaseFlows:
    """Flows over n durations from n starts, with their derivatives.

    The phases have `configurations` (n,), `durations` (n,) and `starts` (n, N).
    """

    def __init__(
        self,
        system: PiecewiseLinear,
        configurations: np.ndarray,
        durations: np.ndarray,
        starts: np.ndarray,
    ) -> None:
        self._system, (count, size) = system, starts.shape
        # (n, N, N), derivatives of the end states by the starts
        self.matrices = np.empty((count, size, size))
        self._parts: list[tuple[int, np.ndarray, _Flows]] = []
        for configuration in np.unique(configurations).tolist():
            here = np.flatnonzero(configurations == configuration)
            factored = isinstance(system.flows[configuration], FactoredFlows)
            functions = system.structure.functions[configuration]
            step = max(1, _CHUNK // max(1, 4 * functions**2 if factored else functions * size))
            make: type[_Flows] = _FactoredFlows if factored else _DenseFlows
            for low in range(0, len(here), step):
                part = here[low : low + step]
                flows = make(system, configuration, durations[part], starts[part])
                self.matrices[part] = flows.matrices
                self._parts.append((configuration, part, flows))

    def changes(self, fields: np.ndarray) -> np.ndarray:
        """Derivatives (n, N, q) of the end states by q numbers, starts and durations kept.

        `fields` (q, configurations, N, N + 1) are those of the vector fields.
        """
        found = np.zeros((*self.matrices.shape[:2], len(fields)))
        every = np.arange(found.shape[1])
        for configuration, places, flows in self._parts:
            field = fields[:, configuration]
            moving = np.flatnonzero(field.any(axis=(1, 2)))
            if moving.size:
                found[np.ix_(places, every, moving)] = flows.changes(field[moving])
        return found

    def gradients(self, cotangents: np.ndarray) -> np.ndarray:
        """Derivative (configurations, N, N + 1) by the fields of end states times factors (n, N).

        It is a sum over all phases.
        """
        found = np.zeros_like(self._system.fields)
        for configuration, places, flows in self._parts:
            found[configuration] += flows.gradients(cotangents[places])
        return found


def rule_pieces(system: PiecewiseLinear, configuration: int, durations: np.ndarray) -> np.ndarray:
    """Numbers of pieces (n,) on which products of two states have exact integrals."""
    pieces = 1 + np.floor(fastest(system, configuration) * durations / _ANGLE).astype(int)
    many = pieces > _FEW  # as many as a power of two
    pieces[many] = 2 ** np.ceil(np.log2(pieces[many])).astype(int)
    return np.asarray(pieces)


@lru_cache(maxsize=64)
def rule_on(pieces: int) -> tuple[np.ndarray, np.ndarray]:
    """Nodes and weights of an integral over [0, 1] that is cut into equal pieces."""
    return composite_rule(_NODES, pieces)


def _convolutions(
    system: PiecewiseLinear, configuration: int, durations: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Integrals (n, F, F) of ``phi_f(d - s) phi_g(s)`` and (n, F) of ``phi_f`` over 0 < s < d."""
    count = system.structure.functions[configuration]
    products = np.empty((len(durations), count, count))
    integrals = np.empty((len(durations), count))
    pieces = rule_pieces(system, configuration, durations)
    for piece in np.unique(pieces).tolist():
        nodes, weights = rule_on(piece)
        here = np.flatnonzero(pieces == piece)
        step = max(1, _CHUNK // (len(nodes) * max(1, count)))
        for low in range(0, len(here), step):
            part = here[low : low + step]
            times = durations[part, None] * nodes
            functions = functions_of(system, configuration, times.ravel())
            functions = functions.reshape(*times.shape, count)
            weighted = functions * (durations[part, None] * weights)[..., None]
            # nodes lie symmetrically: the functions at d - s are those at s backwards
            products[part] = weighted[:, ::-1].swapaxes(1, 2) @ functions
            integrals[part] = weighted.sum(axis=1)
    return products, integrals
