"""Transitions of the law written out: kernels in which they are listed, as any other.

A path of the law, unfolded, is a transition whose conditions are the signs of combinations of
declared rows. They join the rows of the system, in every arithmetic.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.model.contacts.law import ContactEvent, Law, law_of
from nonsmooth.runtime.model.contacts.stages import Combination, Path, Stage, requirements, signs
from nonsmooth.runtime.model.kernel_records import SystemKernels


class Route(NamedTuple):
    """A path of the law from a configuration through boundaries that are reached together."""

    source: str
    boundaries: tuple[str, ...]
    target: str
    path: Path


@dataclass(frozen=True)
class UnfoldedKernels(SystemKernels):
    """Kernels of a system in which routes of its contact law are listed as transitions."""

    routes: tuple[Route, ...] = ()

    @cached_property
    def _declared(self) -> SystemKernels:
        return SystemKernels(self.name, self.module, self.compiled)

    @cached_property
    def _law(self) -> Law:
        law = law_of(self.module.SYSTEM, tuple(self.module.SYSTEM["configurations"]))
        assert law is not None
        return law

    @cached_property
    def _steps(self) -> list[tuple[ContactEvent, Stage]]:
        """The event and the stage of every step, route by route."""
        return [(self._event(route), stage) for route in self.routes for stage in route.path]

    def _event(self, route: Route) -> ContactEvent:
        event = self._law.event(self._law.configurations.index(route.source), route.boundaries)
        assert event is not None
        return event

    @property
    def rows(self) -> int:
        """Number of rows: the declared ones, then those of the routes."""
        return self._declared.rows + sum(len(signs(self._law, *step)) for step in self._steps)

    @cached_property
    def table(self) -> dict[str, Any]:
        """The table of the system, with the routes among its transitions."""
        base: dict[str, Any] = self.module.SYSTEM
        law, listed, row = self._law, [], self._declared.rows
        for route in self.routes:
            event = self._event(route)
            wanted = [sign for stage in route.path for sign in signs(law, event, stage)]
            listed.append(
                {
                    "source": route.source,
                    "boundaries": sorted(route.boundaries),
                    "conditions": [(row + k, route.target, sign) for k, sign in enumerate(wanted)],
                    "reset": law.reset(event, law.configurations.index(route.target)),
                    "target": route.target,
                    "path": route.path,
                }
            )
            row += len(wanted)
        return base | {"transitions": [*base["transitions"], *listed]}

    def source(self, kernel: str) -> Callable[..., Any]:
        """A kernel over any arithmetic; `rows` gives the rows of the routes too."""
        found = self._declared.source(kernel)
        if kernel != "rows":
            return found

        def rows(parameters: Sequence[Any], *, lib: Any) -> list[Any]:
            one, declared = lib.rational(1, 1), found(parameters, lib=lib)
            combined = self._combined(lambda row: one * declared[row][-1])
            return [*declared, *(_row(each, declared) for each in combined)]

        return rows

    def evaluate(self, kernel: str, *arrays: Any, outputs: int | None = None) -> Any:
        """Values of a kernel in double precision; `rows` gives the rows of the routes too.

        The kernel's arguments broadcast over leading axes.
        """
        found = self._declared.evaluate(kernel, *arrays, outputs=outputs)
        if kernel != "rows":
            return found
        with np.errstate(invalid="ignore", divide="ignore"):  # points that are not numbers
            more = [
                sum(np.asarray(factor)[..., None] * found[..., row, :] for row, factor in e.items())
                for e in self._combined(lambda row: found[..., row, -1])
            ]
        return np.concatenate([found, np.stack(more, axis=-2)], axis=-2)

    def _combined(self, entry: Callable[[int], Any]) -> Iterator[Combination]:
        for event, stage in self._steps:
            for requirement in requirements(self._law, event, stage, entry):
                yield requirement.function


def _row(combination: Combination, declared: Sequence[Sequence[Any]]) -> list[Any]:
    parts = [[factor * x for x in declared[row]] for row, factor in combination.items()]
    return [sum(column[1:], column[0]) for column in zip(*parts, strict=True)]


def unfolded(kernels: SystemKernels, routes: Iterable[Route]) -> SystemKernels:
    """The same kernels with exactly these routes listed; each is listed once."""
    declared = kernels.name, kernels.module, kernels.compiled
    wanted = tuple(dict.fromkeys(routes))
    return UnfoldedKernels(*declared, wanted) if wanted else SystemKernels(*declared)
