"""The phases of a motion or an orbit as they move in q directions, and what is seen along them.

Derivatives are tiny imaginary parts of states and numbers: what follows from these is written
once, for its value and for its derivatives. An extreme is found by the guaranteed search; its
derivative is that of the function at the place where it is attained (J. Danskin, 1967, the
envelope theorem).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.arithmetic import Mpmath
from nonsmooth.runtime.core.complex_steps import imaginary_parts, real_parts, stepped
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.shooting.shooting_map import Numbers, flows_over
from nonsmooth.runtime.simulation.flow_derivatives import (
    PhaseFlows,
    rule_on,
    rule_pieces,
)
from nonsmooth.runtime.simulation.phase_functions import Phases, extremes, phase_states

__all__ = ["Differentiated", "MovedPhases"]

_EDGE = 1e-9  # of a phase: an extreme nearer to its end is taken at the end
_TIED = 1e-12  # relative difference of values that are equally large
_CHUNK = 4_000_000  # numbers in memory at a time


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
        if self.lib is not None:
            return self._at_many_digits(places, since, rates)
        return stepped(*self._flown(places, since, rates), None)

    def _flown(
        self, places: np.ndarray, since: np.ndarray, rates: Any = 0
    ) -> tuple[np.ndarray, np.ndarray]:
        """States (m, N) and derivatives (q, m, N), in double precision; see `at`."""
        configurations = self.phases.configurations[places]
        states = self._plain_states(places, since)
        flows = PhaseFlows(self.system, configurations, since, self.phases.starts[places])
        changes = flows.matrices @ self.changes[places] + flows.changes(self._field_rates)
        slopes = np.moveaxis(changes, -1, 0)
        if np.ndim(rates):
            fields = self.system.fields[configurations]
            velocities = np.einsum("mij,mj->mi", fields[..., :-1], states) + fields[..., -1]
            slopes = slopes + velocities * rates[..., None]
        return states, slopes

    def _at_many_digits(self, places: np.ndarray, since: np.ndarray, rates: Any) -> np.ndarray:
        found = []
        every = np.broadcast_to(rates, (self.changes.shape[-1], len(places)))
        for place, time, rate in zip(places.tolist(), since, every.T, strict=True):
            start = stepped(self.phases.starts[place], self.changes[place].T, self.lib)
            field = self.numbers.fields[:, self.phases.configurations[place]]
            flow = flows_over(field, stepped(time, rate, self.lib), self.lib)
            found.append((flow[..., :-1] @ start[..., None])[..., 0] + flow[..., -1])
        return np.array(found).reshape(len(found), *self.changes.shape[:0:-1]).swapaxes(0, 1)

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

        `rows` (q, m, N + 1) have steps. Times `since` the phases' beginnings (m,) are
        approximate, and polished where the extreme is inside.
        """
        durations = self.searched.durations[places]
        first, last = since <= _EDGE * durations, since >= (1 - _EDGE) * durations
        times = self._polished(rows, places, np.asarray(since, dtype=float), ~first & ~last)
        times = np.where(first, 0 * times, np.where(last, self.phases.durations[places], times))
        begins, ends = self.rates[:, :, places]
        rates = np.where(first, begins, np.where(last, ends, 0 * begins))
        states = self.at(places, times, rates)
        values = (rows[..., :-1] * states).sum(axis=-1) + rows[..., -1]
        slopes = imaginary_parts(values, self.lib)
        for value, slope, time in zip(
            real_parts(values)[0], slopes.T, self.phases.begins[places] + times, strict=True
        ):
            yield Differentiated(value, slope, time)

    def _polished(
        self, rows: np.ndarray, places: np.ndarray, since: np.ndarray, inside: np.ndarray
    ) -> np.ndarray:
        """Zeros (m,) of the functions' slopes near times, by Newton's method where `inside`."""
        fields = real_parts(self.numbers.fields[0])[self.phases.configurations[places]]
        slopes = (real_parts(rows[0])[:, None, :-1] @ fields)[:, 0]
        bends = (slopes[:, None, :-1] @ fields)[:, 0]
        times = since if self.lib is None else np.frompyfunc(self.lib.mp.mpf, 1, 1)(since)
        most = 0.1 * self.searched.durations[places]
        for _ in range(3 if self.lib is None else 8):
            kept = np.flatnonzero(inside)
            if not kept.size:
                break
            states = self._plain_states(places[kept], times[kept])
            slope, bend = (
                (part[kept, :-1] * states).sum(axis=-1) + part[kept, -1] for part in (slopes, bends)
            )
            moving = bend != 0
            steps = np.where(moving, slope, 0) / np.where(moving, bend, 1)
            # where it is flat, or an end, the place that the search has found stays
            moving &= abs(steps.astype(float)) <= most[kept]
            times = times.copy()
            times[kept[moving]] -= steps[moving]
            inside[kept[~moving]] = False
        return np.asarray(times)

    def _plain_states(self, places: np.ndarray, since: np.ndarray) -> np.ndarray:
        """States (m, N), without derivatives in double precision."""
        if self.lib is not None:
            return real_parts(self.at(places, since)[0])
        phases = self.phases
        return phase_states(
            self.system, phases.configurations[places], since, phases.starts[places]
        )

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
        for configuration, places, shares, weights in self._nodes(q * max(count, width)):
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

    def _nodes(self, size: int) -> Iterator[tuple[int, np.ndarray, np.ndarray, np.ndarray]]:
        """Yield each configuration, phases of nodes (n,), shares of their durations, and weights.

        A node takes `size` numbers; not too many are in memory at a time.
        """
        most = max(1, _CHUNK // max(1, size))
        for configuration in np.unique(self.phases.configurations).tolist():
            there = np.flatnonzero(self.phases.configurations == configuration)
            durations = self.phases.durations[there]
            pieces = rule_pieces(self.system, configuration, durations)
            for piece in np.unique(pieces).tolist():
                nodes, weights = rule_on(piece)
                own = there[pieces == piece]
                step = max(1, most // len(nodes))
                for low in range(0, len(own), step):
                    part = own[low : low + step]
                    yield (
                        configuration,
                        np.repeat(part, len(nodes)),
                        np.tile(nodes, len(part)),
                        np.tile(weights, len(part)),
                    )
