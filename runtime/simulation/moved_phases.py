"""The phases of a motion or an orbit as they move in q directions, and what is seen along them.

A change dG of the field y' = G (y, 1) moves the state after a time d by the integral of
Phi(d - s) dG (y(s), 1), where Phi is the linear part of the flow. With the functions of time
phi_f, the matrices B_f in Phi = sum phi_f B_f and the parts of the state in y = sum phi_g y_g
that is sum_f B_f dG sum_g Q_fg (y_g, ...), where Q_fg is the integral of phi_f(d - s) phi_g(s):
one small matrix for each phase has the derivatives by all parameters, and their adjoint.

Q is found by Gauss and Legendre's rule with twenty nodes on pieces of at most ten radians of
the fastest oscillation. A product of two functions turns by twice as much, and the rule's error
is below h^40 3e-60 = 3e-20 for half of that, h = 10.

Derivatives are tiny imaginary parts of states and numbers: what follows from these is written
once, for its value and for its derivatives. An extreme is found by the guaranteed search; its
derivative is that of the function at the place where it is attained (J. Danskin, 1967, the
envelope theorem).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.arithmetic import Mpmath
from nonsmooth.runtime.core.complex_steps import imaginary_parts, real_parts, stepped
from nonsmooth.runtime.model.factored_flows import FactoredFlows, matrices_of
from nonsmooth.runtime.model.flows import composite_rule, functions_of, parts_of
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.shooting.shooting_map import Numbers, flows_over
from nonsmooth.runtime.simulation.phase_functions import Phases, extremes, fastest, phase_states

_NODES = 20  # of an integral, in a piece
_ANGLE = 10.0  # radians in a piece
_FEW = 4
_CHUNK = 2_000_000  # numbers in memory at a time
_EDGE = 1e-9  # of a phase: an extreme nearer to its end is taken at the end
_NEWTON = 8  # steps from a place in doubles to any number of digits
_TIED = 1e-12  # relative difference of values that are equally large


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
        places, self._columns, rows = flows.terms()
        self._rows = rows[:, :-1]
        weights = starts @ rows[:, :-1].T + rows[:, -1]
        products, integrals = _convolutions(system, configuration, durations)
        self._products = products[:, places][:, :, places] * weights[:, None]
        self._integrals = integrals[:, places]

    def changes(self, fields: np.ndarray) -> np.ndarray:
        """See `_DenseFlows`."""
        found = np.empty((len(self._products), self._columns.shape[1], len(fields)))
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
                self.matrices[part] = flow_matrices(system, configuration, durations[part])
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


_rule = lru_cache(maxsize=64)(composite_rule)


def _ruled(
    system: PiecewiseLinear, configuration: int, durations: np.ndarray, size: int
) -> Iterator[tuple[np.ndarray, np.ndarray, np.ndarray]]:
    """Yield places among durations, with nodes and weights of their integrals over [0, 1].

    These are exact for products of two states. A node takes `size` numbers; not too many are in
    memory at a time.
    """
    pieces = 1 + np.floor(fastest(system, configuration) * durations / _ANGLE).astype(int)
    many = pieces > _FEW  # as many as a power of two
    pieces[many] = 2 ** np.ceil(np.log2(pieces[many])).astype(int)
    for piece in np.unique(pieces).tolist():
        nodes, weights = _rule(_NODES, piece)
        here = np.flatnonzero(pieces == piece)
        step = max(1, _CHUNK // (len(nodes) * max(1, size)))
        for low in range(0, len(here), step):
            yield here[low : low + step], nodes, weights


def _convolutions(
    system: PiecewiseLinear, configuration: int, durations: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Integrals (n, F, F) of ``phi_f(d - s) phi_g(s)`` and (n, F) of ``phi_f`` over 0 < s < d."""
    count = system.structure.functions[configuration]
    products = np.empty((len(durations), count, count))
    integrals = np.empty((len(durations), count))
    for part, nodes, weights in _ruled(system, configuration, durations, count):
        times = durations[part, None] * nodes
        functions = functions_of(system, configuration, times.ravel())
        functions = functions.reshape(*times.shape, count)
        weighted = functions * (durations[part, None] * weights)[..., None]
        # nodes lie symmetrically: the functions at d - s are those at s backwards
        products[part] = weighted[:, ::-1].swapaxes(1, 2) @ functions
        integrals[part] = weighted.sum(axis=1)
    return products, integrals


def _nodes(
    system: PiecewiseLinear, phases: Phases, size: int
) -> Iterator[tuple[int, np.ndarray, np.ndarray, np.ndarray]]:
    """Yield each configuration, phases of nodes (n,), shares of their durations, and weights.

    A node takes `size` numbers.
    """
    for configuration in np.unique(phases.configurations).tolist():
        there = np.flatnonzero(phases.configurations == configuration)
        for part, nodes, weights in _ruled(system, configuration, phases.durations[there], size):
            count = len(part)
            places = np.repeat(there[part], len(nodes))
            yield configuration, places, np.tile(nodes, count), np.tile(weights, count)


def moments(system: PiecewiseLinear, phases: Phases, rows: np.ndarray) -> np.ndarray:
    """Integrals (K, K + 1) of all products of K affine functions; the last column has their own.

    `rows` (configurations, K, N + 1) are the functions ``n y + c``: n, then c.
    """
    total = np.zeros((rows.shape[1], rows.shape[1] + 1))
    for configuration in np.unique(phases.configurations).tolist():
        there = np.flatnonzero(phases.configurations == configuration)
        row, durations = rows[configuration], phases.durations[there]
        for part, nodes, weights in _ruled(system, configuration, durations, max(rows.shape[1:])):
            times = durations[part, None] * nodes
            functions = functions_of(system, configuration, times.ravel())
            factors = parts_of(system, configuration, phases.starts[there[part]]) @ row[:, :-1].T
            values = functions.reshape(*times.shape, -1) @ factors + row[:, -1]
            values = values.reshape(times.size, -1)
            weighted = values * (durations[part, None] * weights).reshape(-1, 1)
            total[:, :-1] += weighted.T @ values
            total[:, -1] += weighted.sum(axis=0)
    return total


class Differentiated(NamedTuple):
    """A number, its derivatives (q,), and the time at which it is attained."""

    value: Any
    rates: np.ndarray
    time: Any


@dataclass(frozen=True, eq=False)
class MovedPhases:
    """P phases that move in q directions."""

    system: PiecewiseLinear  # in double precision
    numbers: Numbers  # (q, ...) of the system, with steps
    phases: Phases
    changes: np.ndarray  # (P, N, q), of the states at the phases' beginnings, at fixed times
    rates: np.ndarray  # (2, q, P), of the times at which the phases begin and end
    lib: Mpmath | None = None  # the arithmetic of what is not searched for; None for doubles

    @cached_property
    def searched(self) -> Phases:
        """The phases in double precision."""
        own = self.phases
        begins, durations, starts, ends = (
            part.astype(float) for part in (own.begins, own.durations, own.starts, own.ends)
        )
        return Phases(begins, durations, own.configurations, starts, ends)

    @cached_property
    def _field_rates(self) -> np.ndarray:
        return imaginary_parts(self.numbers.fields, self.lib)

    def at(self, places: np.ndarray, since: np.ndarray, rates: Any = 0) -> np.ndarray:
        """States (q, m, N), with steps, at times since the beginnings of phases at places (m,).

        The times of the motion move with `rates` (q, m), or stay.
        """
        if self.lib is None:
            return stepped(*self._flown(places, since, rates), None)
        fields = self.numbers.fields[:, self.phases.configurations[places]]
        times = np.broadcast_to(stepped(since, rates, self.lib), fields.shape[:2])
        flows = flows_over(fields, times, self.lib)
        starts = stepped(
            self.phases.starts[places], np.moveaxis(self.changes[places], 2, 0), self.lib
        )
        return np.asarray((flows[..., :-1] @ starts[..., None])[..., 0] + flows[..., -1])

    def _flown(
        self, places: np.ndarray, since: np.ndarray, rates: Any = 0
    ) -> tuple[np.ndarray, np.ndarray]:
        """States (m, N) and derivatives (q, m, N), in double precision; see `at`."""
        configurations = self.phases.configurations[places]
        starts = self.phases.starts[places]
        states = phase_states(self.system, configurations, since, starts)
        flows = PhaseFlows(self.system, configurations, since, starts)
        changes = flows.matrices @ self.changes[places] + flows.changes(self._field_rates)
        slopes = np.moveaxis(changes, -1, 0)
        if np.ndim(rates):
            fields = self.system.fields[configurations]
            velocities = np.einsum("mij,mj->mi", fields[..., :-1], states) + fields[..., -1]
            slopes = slopes + velocities * rates[..., None]
        return states, slopes

    def arrival(self, phase: int, row: int) -> tuple[np.ndarray, np.ndarray]:
        """Rate (q,) and its rate (q,), with steps, of a row of the tables at the end of a phase."""
        field = self.numbers.fields[:, self.phases.configurations[phase]]
        end = np.array([phase]), self.phases.durations[[phase]], self.rates[1][:, [phase]]
        state = self.at(*end)[:, 0, :, None]
        velocity = (field[..., :-1] @ state)[..., 0] + field[..., -1]
        normal = self.numbers.rows[:, row, :-1]
        turned = (field[..., :-1] @ velocity[..., None])[..., 0]
        return (normal * velocity).sum(axis=-1), (normal * turned).sum(axis=-1)

    def differentiated(
        self, rows: np.ndarray, places: np.ndarray, since: np.ndarray
    ) -> Iterator[Differentiated]:
        """Yield affine functions at extremes of theirs in phases at places (m,), or at an end.

        `rows` (q, m, N + 1) have steps. Times `since` the phases' beginnings (m,) are doubles.
        """
        durations = self.searched.durations[places]
        first, last = since <= _EDGE * durations, since >= (1 - _EDGE) * durations
        times = np.where(last, self.phases.durations[places], since)
        inside = np.flatnonzero(~first & ~last)
        if self.lib is not None and inside.size:
            times[inside] = self._polished(rows[:, inside], places[inside], since[inside])
        times = np.where(first, 0 * times, times)
        begins, ends = self.rates[:, :, places]
        rates = np.where(first, begins, np.where(last, ends, 0 * begins))
        states = self.at(places, times, rates)
        values = (rows[..., :-1] * states).sum(axis=-1) + rows[..., -1]
        slopes = imaginary_parts(values, self.lib)
        for value, slope, time in zip(
            real_parts(values)[0], slopes.T, self.phases.begins[places] + times, strict=True
        ):
            yield Differentiated(value, slope, time)

    def _polished(self, rows: np.ndarray, places: np.ndarray, since: np.ndarray) -> np.ndarray:
        """Zeros (m,) of the functions' slopes near times, to many digits by Newton's method."""
        assert self.lib is not None
        fields = real_parts(self.numbers.fields[0])[self.phases.configurations[places]]
        slopes = (real_parts(rows[0])[:, None, :-1] @ fields)[:, 0]
        bends = (slopes[:, None, :-1] @ fields)[:, 0]
        times = np.frompyfunc(self.lib.mp.mpf, 1, 1)(since)
        for _ in range(_NEWTON):
            states = real_parts(self.at(places, times)[0])
            slope, bend = (
                (part[:, :-1] * states).sum(axis=-1) + part[:, -1] for part in (slopes, bends)
            )
            moving = bend != 0
            steps = np.where(moving, slope, 0) / np.where(moving, bend, 1)
            # where it is flat, or an end, the place that the search has found stays
            moving &= abs(steps.astype(float)) <= 0.1 * self.searched.durations[places]
            times = times - np.where(moving, steps, 0)
        return np.asarray(times)

    def extremes(
        self, rows: np.ndarray, side: str | None = None
    ) -> tuple[list[Differentiated], list[Differentiated]]:
        """Minima and maxima (K,) of affine functions (q, configurations, K, N + 1), with steps.

        Of values that are equally large at one time, a `side` takes the one that becomes the
        extreme on it.
        """
        phases = self.searched
        minima, maxima = extremes(self.system, phases, real_parts(rows[0]).astype(float))
        wanted = [*minima, *maxima]
        ends = phases.begins + phases.durations
        slack = 64 * np.spacing(ends[-1])
        times = np.array([found.time for found in wanted])[:, None]
        owners, places = np.nonzero((phases.begins - slack <= times) & (times <= ends + slack))
        since = np.clip(times[owners, 0] - phases.begins[places], 0, phases.durations[places])
        own = rows[:, phases.configurations[places], owners % rows.shape[2]]
        candidates = list(self.differentiated(own, places, since))
        reach = np.maximum(abs(phases.starts), abs(phases.ends))[places]
        row = abs(real_parts(own[0]).astype(float))
        sizes = (row[:, :-1] * reach).sum(axis=1) + row[:, -1]
        chosen = []
        for owner, (value, _) in enumerate(wanted):
            there = [candidates[k] for k in np.flatnonzero(owners == owner)]
            missed = [abs(float(each.value) - value) for each in there]
            best = there[int(np.argmin(missed))]
            if side is not None:
                upper = (owner >= len(minima)) == (side == "+")
                within = min(missed) + _TIED * sizes[owners == owner].max()
                tied = [each.rates for each, m in zip(there, missed, strict=True) if m <= within]
                best = best._replace(rates=(np.max if upper else np.min)(tied, axis=0))
            chosen.append(best)
        return chosen[: len(minima)], chosen[len(minima) :]

    @property
    def spent(self) -> np.ndarray:
        """Times (q, configurations), with steps, in each configuration; in double precision."""
        waits = stepped(self.phases.durations, self.rates[1] - self.rates[0], None)
        every = np.arange(len(self.system.structure.configurations))
        return np.asarray(waits @ (self.phases.configurations[:, None] == every))

    def moments(self, rows: np.ndarray) -> np.ndarray:
        """Integrals (q, K, K + 1), with steps, of all products of K affine functions.

        The last column has those of the functions themselves. `rows` (q, configurations, K, N + 1)
        have steps. The nodes of the rule move with the phases, so that derivatives are exact. They
        are in double precision.
        """
        q, _, count, width = rows.shape
        total = np.zeros((q, count, count + 1), dtype=complex)
        for configuration, places, shares, weights in _nodes(
            self.system, self.phases, q * max(count, width)
        ):
            begins, ends = self.rates[:, :, places]
            durations = self.phases.durations[places]
            times = begins + (ends - begins) * shares
            states, changes = self._flown(places, durations * shares, times)
            row = real_parts(rows[0, configuration])
            moved = np.swapaxes(imaginary_parts(rows[:, configuration], None), 1, 2)
            values = states @ row[:, :-1].T + row[:, -1]
            slopes = changes @ row[:, :-1].T + states @ moved[:, :-1] + moved[:, -1:]
            weighted = values * (durations * weights)[:, None]
            spread = values * ((ends - begins) * weights)[..., None]
            half = np.swapaxes(slopes, 1, 2) @ weighted
            products = half + np.swapaxes(half, 1, 2) + np.swapaxes(spread, 1, 2) @ values
            total[..., :-1] += stepped(weighted.T @ values, products, None)
            alone = slopes * (durations * weights)[:, None] + spread
            total[..., -1] += stepped(weighted.sum(axis=0), alone.sum(axis=1), None)
        return total
