"""Which equations the orbits of an itinerary are counted by, and what their roots mean.

Where an orbit is derived and its equations come down to fewer unknowns than it has phases,
these are searched; everywhere else its dwell times are.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.rational_functions import RationalFunction
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.completion import Point
from nonsmooth.runtime.model.kernels import OrbitKernels, SystemKernels
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.orbits.orbit import DOUBLE, Orbit
from nonsmooth.runtime.orbits.problem import OrbitProblem, orbit_of
from nonsmooth.runtime.orbits.solve import solve_kernels
from nonsmooth.runtime.proof.counting.branch_and_prune import Problem, Root, inside, touching
from nonsmooth.runtime.proof.counting.dwell_box import Side
from nonsmooth.runtime.proof.counting.dwell_equations import (
    DwellProblem,
    Given,
    Setting,
    setting_of,
)
from nonsmooth.runtime.proof.counting.reduced_equations import ReducedProblem
from nonsmooth.runtime.proof.exact_closure import forcing_speeds
from nonsmooth.runtime.proof.exact_tables import Tables, exact_tables
from nonsmooth.runtime.proof.symplectic_form import symplectic_form
from nonsmooth.runtime.shooting.newton import CONVERGED
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape
from nonsmooth.runtime.shooting.translations import translations_of

if TYPE_CHECKING:
    from flint import arb

__all__ = ["DwellQuestion", "Question", "ReducedQuestion", "dwell_question"]

_MOST_TURNS = 1000
_WINDOW = -0.0618  # of a forcing's period: where its times begin, away from where it is even


class Question(Protocol):
    """Problems whose roots are the orbits that are counted."""

    @property
    def problems(self) -> Sequence[Problem]:
        """The problems; no orbit is a root of two of them."""
        ...

    @property
    def conditions(self) -> tuple[str, ...]:
        """The conditions on the orbits besides their dwell times, in words."""
        ...

    def dwell(self, problem: Any, root: Root) -> dict[str, arb]:
        """Enclosures of all dwell times of a root, by name."""
        ...

    def unknowns(self, problem: Any) -> tuple[str, ...]:
        """Names of a problem's unknowns, in its order."""
        ...

    @property
    def surplus(self) -> bool:
        """Whether there are more equations than unknowns; roots are proved of as many only."""
        ...

    def again(self, problem: Any, root: Root, other: Root) -> bool | None:
        """Whether two roots are one orbit, begun at two of its phases; None if undecided.

        Of a root and itself: whether the orbit repeats itself before its itinerary ends.
        """
        ...

    @property
    def follow(self) -> tuple[str, ...]:
        """Dwell times that follow from those that are searched; they may violate the bounds."""
        ...

    def small(self, problem: Any, root: Root) -> bool | None:
        """Whether the root's other unknowns are in their required ranges; None if undecided."""
        ...

    def orbit(self, problem: Any, root: Root) -> Orbit:
        """An approximation in floating point of the orbit that the root is."""
        ...


@dataclass(frozen=True, eq=False)
class ReducedQuestion:
    """Orbits counted by the reduced equations of a derived orbit."""

    kernels: OrbitKernels
    name: Any  # name or Itinerary by which it is solved
    point: Point
    problems: tuple[ReducedProblem, ...]
    surplus = False

    @property
    def conditions(self) -> tuple[str, ...]:
        """By which rules the dwell times follow that are eliminated, and what is left open."""
        rules = self.kernels.table["eliminated"]
        found = [f"{n} follows ({rules[n]})" for n in self.kernels.dwell_times if n in rules]
        names = [p.name for p in self.kernels.open_parameters if p.name not in self.point.opened]
        if names:
            found.append(f"{', '.join(names)} left open, large enough for each")
        return tuple(found)

    def unknowns(self, problem: ReducedProblem) -> tuple[str, ...]:
        """Names of the reduced unknowns."""
        return self.kernels.reduced

    def dwell(self, problem: ReducedProblem, root: Root) -> dict[str, arb]:
        """Enclosures of all dwell times of a root, by name."""
        return self.kernels.durations(problem.unknowns(root.sides))

    @property
    def follow(self) -> tuple[str, ...]:
        """Dwell times that are eliminated."""
        return tuple(n for n in self.kernels.dwell_times if n not in self.kernels.reduced)

    def again(self, problem: ReducedProblem, root: Root, other: Root) -> bool | None:
        """False: itineraries that repeat themselves are not counted by reduced equations."""
        return False

    def small(self, problem: ReducedProblem, root: Root) -> bool | None:
        """True: nothing is required of the coordinates."""
        return True

    def orbit(self, problem: ReducedProblem, root: Root) -> Orbit:
        """An approximation in floating point of the orbit that the root is."""
        guess = {name: float(x.mid()) for name, x in problem.unknowns(root.sides).items()}
        given = {**self.point.values, **self.point.opened}
        return solve_kernels(self.kernels, given, guess, throw=False)


@dataclass(frozen=True, eq=False)
class DwellQuestion:
    """Orbits counted by the dwell times of a cycle."""

    label: str | None
    kernels: SystemKernels
    values: Mapping[str, Value]  # all parameters of the system
    cycle: ItineraryShape
    names: tuple[str, ...]  # of the dwell times
    start: tuple[str, ...]  # names of the states at the start
    setting: Setting
    period: Value | None
    largest: float  # largest size of a coordinate
    # one for each number of the forcing's turns, where there is a forcing
    problems: tuple[DwellProblem, ...]

    @property
    def conditions(self) -> tuple[str, ...]:
        """How large coordinates may be, and which period was given."""
        found = []
        if self.setting.places:
            states = self.cycle.structure.states
            sizes = ", ".join(f"|{states[k]}|" for k in self.setting.places)
            phase, _ = self.cycle.itinerary[self.setting.rotation]
            found.append(f"{sizes} <= {self.largest:g} at the start of {phase}")
        if self.period is not None:
            found.append(f"the period is {self.period}")
        if self.part < len(self.cycle):
            found.append("without those that repeat themselves earlier")
        return tuple(found)

    @property
    def part(self) -> int:
        """Number of phases after which the itinerary repeats itself: all of them, as a rule."""
        phases = self.cycle.itinerary
        sizes = range(1, len(phases) + 1)
        return next(k for k in sizes if phases == phases[k:] + phases[:k])

    def again(self, problem: DwellProblem, root: Root, other: Root) -> bool | None:
        """Whether a root is another one, or itself, begun some parts later; None if undecided."""
        undecided = False
        for phases in range(self.part, len(self.cycle), self.part):
            # only among roots that are not too large the other one is unique
            begun = (self.setting.rotation + phases) % len(self.cycle)
            state = problem.starts(root.sides, root.coordinates)[begun]
            small = all(abs(state[k]) <= self.largest for k in self.setting.places)
            for sides in problem.begun_later(root.sides, phases):
                if small and inside(sides, other.unique):
                    return True
                undecided = undecided or touching(sides, other.sides)
        return None if undecided else False

    def unknowns(self, problem: DwellProblem) -> tuple[str, ...]:
        """The forcing's time, and the dwell times from where the start is sought."""
        cut = self.setting.rotation
        forced = ("forcing time",) if self.cycle.structure.forcing else ()
        names = (*forced, *self.names[cut:], *self.names[:cut])
        return names[: len(problem.domain)]

    def dwell(self, problem: DwellProblem, root: Root) -> dict[str, arb]:
        """Enclosures of all dwell times of a root, by name, in the cycle's own order."""
        return dict(zip(self.names, problem.dwell(root.sides), strict=True))

    @property
    def surplus(self) -> bool:
        """Whether a period is given: the closure of one coordinate then follows from the energy."""
        return self.period is not None

    @property
    def follow(self) -> tuple[str, ...]:
        """No dwell time: all are searched."""
        return ()

    def small(self, problem: DwellProblem, root: Root) -> bool | None:
        """Whether no coordinate is too large and a forcing's time is in its period.

        None if undecided.
        """
        sizes = [abs(q) for q in root.coordinates]
        if any(size > self.largest for size in sizes):
            return False
        certain = all(size <= self.largest for size in sizes)
        if problem.unit is not None:
            (begin, _), *_ = problem.domain
            low, high = root.sides[0]
            if high < begin or low > begin + problem.unit:
                return False
            certain = certain and low >= begin and high < begin + problem.unit
        return True if certain else None

    def orbit(self, problem: DwellProblem, root: Root) -> Orbit:
        """An approximation in floating point of the orbit that the root is."""
        starts = problem.starts(root.sides, root.coordinates)
        named = OrbitProblem(
            self.kernels, self.cycle.itinerary, label=self.label, names=(*self.names, *self.start)
        )
        return orbit_of(
            named,
            self.values,
            self.period,
            np.array([float(t.mid()) for t in problem.dwell(root.sides)]),
            np.array([[float(x.mid()) for x in state] for state in starts]),
            0.0,
            DOUBLE,
            0,
            CONVERGED,
        )


def dwell_question(
    label: str | None,
    kernels: SystemKernels,
    values: Mapping[str, Value],
    cycle: ItineraryShape,
    sides: Sequence[Side],
    start: tuple[str, ...],
    period: Value | None,
    largest: float,
    bits: int,
) -> DwellQuestion:
    """The question about any cycle, with a problem for each possible number of the forcing's turns.

    `sides` are those of the box of dwell times. `values` has all physical parameters, `start`
    names the states at the start. The period is the sum of the dwell times, if given, and
    `largest` the largest size of a coordinate, both in the system's units. `bits` is the working
    precision. There is no problem where no orbit is possible. `InputError` for a conservative
    cycle without a period, or a forcing that is not certain to turn evenly.
    """
    tables = exact_tables(kernels, tuple(values.values()), bits)
    if len(translations_of(piecewise(kernels, values))):
        raise InputError(
            f"{label or kernels.name} does not depend on where it is: its orbits are periodic up to"
            " a shift, and not counted"
        )
    setting = setting_of(tables, cycle)
    bounds = [side.floats for side in sides]
    turned = bounds[setting.rotation :] + bounds[: setting.rotation]
    problems: tuple[DwellProblem, ...] = ()
    if not setting.possible:
        pass
    elif cycle.structure.forcing:
        if period is not None:
            raise InputError("the period of a forced orbit is the forcing's, and not given")
        problems = _forced(tables, cycle, setting, turned, largest)
    elif period is not None:
        given = Given(period=period.ball(bits))
        problems = (DwellProblem(tables, cycle, setting, given, turned[:-1], largest, turned[-1]),)
    else:
        if tables.exact and symplectic_form(tables, cycle) is not None:
            raise InputError(
                f"{label or kernels.name} keeps its energy: its orbits come in families, and"
                " only with a given period can they be counted"
            )
        problems = (DwellProblem(tables, cycle, setting, Given(), turned, largest),)
    names = tuple(side.name for side in sides)
    return DwellQuestion(
        label, kernels, values, cycle, names, start, setting, period, largest, problems
    )


def _fraction(ratio: Any) -> Any:
    found = ratio.rational if isinstance(ratio, RationalFunction) else ratio
    if found is None:
        raise InputError("the orbits cannot be counted: the forcings have no common period")
    return found


def _forced(
    tables: Tables,
    cycle: ItineraryShape,
    setting: Setting,
    turned: Sequence[tuple[float, float]],
    largest: float,
) -> tuple[DwellProblem, ...]:
    """A problem for each whole number of the forcings' common period that fits into the box."""
    from flint import arb

    if not tables.exact:
        raise InputError("to count the orbits of a forced system its numbers have to be exact")
    speeds = forcing_speeds(tables, cycle)
    if isinstance(speeds, str):
        raise InputError(f"the orbits cannot be counted: {speeds}")
    if not all(speed != 0 for speed in speeds):
        raise InputError("the orbits cannot be counted: a forcing does not turn")
    # the smallest number of turns of the first forcing after which all have turned wholly
    ratios = [_fraction(speed / speeds[0]) for speed in speeds]
    common = math.lcm(*(int(ratio.q) for ratio in ratios))
    numbers = tuple(map(tables.number_at(), speeds))
    unit = 2 * arb.pi() * common / abs(numbers[0])
    first = float(unit.mid())
    window = (_WINDOW * first, (1 + _WINDOW) * first * (1 + 1e-12))
    least, most = (sum(bound[k] for bound in turned) for k in (0, 1))
    found = []
    for number in range(1, _MOST_TURNS + 1):
        period = unit * number
        if period > most * (1 + 1e-12):
            break
        if period < least * (1 - 1e-12):
            continue
        given = Given(cycle.structure.forcing, numbers, period, unit)
        domain = [window, *turned[:-1]]
        found.append(DwellProblem(tables, cycle, setting, given, domain, largest, turned[-1]))
    else:
        raise InputError(f"the box holds more than {_MOST_TURNS} periods of the forcing")
    return tuple(found)
