"""Itineraries: the cyclic sequence of phases of a periodic orbit."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from decimal import Decimal
from functools import cached_property
from keyword import iskeyword
from numbers import Real
from typing import Any

import sympy as sp

from nonsmooth.derive.declaration.fields import declared, made, set_fields, shown
from nonsmooth.derive.declaration.parameter import Parameter
from nonsmooth.derive.declaration.presentation import Presentation
from nonsmooth.derive.declaration.soundness import check_name
from nonsmooth.derive.declaration.source import Source
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.declaration.transition import Transition
from nonsmooth.derive.errors import DeclarationError
from nonsmooth.derive.symbols import Values


@declared
class Phase:
    """One phase of an itinerary.

    Parameters
    ----------
    configuration : str
        Configuration of the phase.
    boundary : str
        The boundary by which it is left.
    dwell_time : str
        Name of the phase's duration.
    """

    configuration: str
    boundary: str
    dwell_time: str


@dataclass(frozen=True)
class Reference:
    """A known point of an orbit.

    Parameters
    ----------
    parameters : mapping of str to str or number
        Values as texts, nondimensional or in the units of the system; a float stands for its
        shortest decimal. They are kept as texts.
    guess : mapping of str to str or number
        A few digits of each unknown.
    """

    parameters: Mapping[str, str]
    guess: Mapping[str, str]

    def __post_init__(self) -> None:
        for name in ("parameters", "guess"):
            given = made(Mapping[str, Any], getattr(self, name), f"{name} of Reference")
            for key, value in given.items():
                if not _is_text_or_number(value):
                    raise DeclarationError(
                        f"{key} of Reference: {shown(value)} is no number or text"
                    )
            set_fields(self, **{name: {key: str(value) for key, value in given.items()}})


@declared
class Itinerary:
    """The cyclic sequence of phases of a periodic orbit of one system.

    Parameters
    ----------
    name : str
        Name of the orbit; with the system's it reads ``system/orbit``.
    system : System
    phases : sequence of Phase or of (configuration, boundary, dwell time) triples
        The orbit starts where the first phase starts.
    presentation : Presentation, optional
        Coordinates and parameters for the equations; the system's own when omitted.
    reference : Reference, optional
        Default parameters and a guess to start from.
    start : mapping of state name to unknown name, optional
        Names of states at the start that are unknowns. By default those that the end of the
        last phase leaves free, ``x1`` as ``x10``; naming more adds their conditions to the
        equations.
    reversor : mapping of presented state to expression, optional
        A symmetry R under which every phase is its own time reversal: R y(-t) is a motion
        when y(t) is. The orbit is then sought among those that R maps to themselves, by
        conditions halfway through each phase. States that are not named stay.
    period : Parameter, optional
        The period is given: the last phase's dwell time is what the others leave of it.
    symmetry : mapping of state to state or its negative, optional
        A signed permutation of the states that maps motions to motions, such as x to -x and v
        to -v. The phases are then only a part of the orbit, half of it where the symmetry is
        its own inverse: it maps the state behind the last of them to the start.
    vanishing : tuple of str
        Dwell times that are zero (border collision); as many `solved_for`.
    solved_for : tuple of str
        Parameters that are unknowns in place of the vanishing dwell times.
    source : Source, optional
        The publication that the orbit is taken from, which its document cites.

    Raises
    ------
    DeclarationError
        For an unknown configuration, a boundary that its configuration does not have,
        a phase after which no transition leads to the next, a name that is unknown or
        used twice, or a source with what the itinerary does not have.

    Examples
    --------
    >>> from nonsmooth.derive import Harmonic, Itinerary, RigidStop, oscillator
    >>> stop = RigidStop("x", at=0, restitution="0.8", name="stop")
    >>> system = oscillator(
    ...     "struck", ["x"], [[1]], [[1]], forcing=[Harmonic(2, cosine=[1])], elements=[stop]
    ... )
    >>> orbit = Itinerary("one-impact", system, [("free", "stop-reaches-stop", "T")])
    >>> orbit.transition_after(system, 0).target
    'free'
    """

    name: str
    system: System
    phases: tuple[Phase, ...]
    presentation: Presentation | None = None
    reference: Reference | None = None
    start: Mapping[str, str] = field(default_factory=dict)
    reversor: Values = field(default_factory=dict)
    period: Parameter | None = None
    vanishing: tuple[str, ...] = ()
    solved_for: tuple[str, ...] = ()
    symmetry: Values = field(default_factory=dict)
    source: Source | None = None

    def __post_init__(self) -> None:
        phases = self.phases
        check_name(self.name, "itinerary")
        if not phases:
            raise DeclarationError(f"itinerary {self.name!r} has no phases")
        self._check_names()
        if self.source is not None:
            self.source.check([p.configuration for p in phases], len(phases))
        for phase, following in zip(phases, phases[1:] + phases[:1], strict=True):
            self.system.configuration(phase.configuration).boundary(phase.boundary)
            self.system.configuration(following.configuration)
            if phase is phases[-1] and self.symmetry:
                continue  # it leads to the image of the first
            self.system.transition(phase.configuration, phase.boundary, following.configuration)

    @classmethod
    def from_trajectory(
        cls,
        trajectory: Any,
        system: System,
        name: str = "orbit",
        since: float = 0.0,
        period: float | None = None,
    ) -> Itinerary:
        """Read the cycle that a simulated motion repeats at its end, with a guess of its orbit.

        Parameters
        ----------
        trajectory : Trajectory
            What `nonsmooth.simulate` gives for the system; the itinerary's reference has its
            parameters.
        system : System
        name : str
            Name of the orbit.
        since, period : float
            As for `nonsmooth.itinerary_of`.

        Returns
        -------
        Itinerary
            Named `name`; its reference holds the dwell times and the start of the cycle.

        Raises
        ------
        InputError
            If the motion does not come back.
        DeclarationError
            If it passes boundaries together, or is one of another system.
        """
        cycle = trajectory.recurrence(since, period)
        names = [f"tau{k}" for k in range(1, len(cycle.itinerary) + 1)]
        taken = {*map(str, system.states), *(p.name for p in system.parameters)}
        if taken & set(names):
            names = [f"dwell_{n}" for n in names]
        start = dict(zip(map(str, system.states), cycle.start.tolist(), strict=True))
        guess = dict(zip(names, cycle.dwell_times.tolist(), strict=True)) | start
        return cls(
            name,
            system,
            tuple(Phase(c, b, n) for (c, b), n in zip(cycle.itinerary, names, strict=True)),
            reference=Reference(
                {n: value.text for n, value in trajectory.parameters.items()},
                {n: repr(x) for n, x in guess.items()},
            ),
        )

    def _check_names(self) -> None:
        where = f"itinerary {self.name!r}"
        parameters, states = set(), [*map(str, self.system.states)]
        parameters |= {p.name for p in self.system.parameters}
        if self.presentation is not None:
            states = [*map(str, self.presentation.states)]
            parameters |= {p.name for p in self.presentation.parameters}
        taken = {*map(str, self.system.states), *states, *parameters}
        dwell_times = [p.dwell_time for p in self.phases]
        named = [("dwell time", name) for name in dwell_times]
        named += [("unknown", name) for name in self.start.values()]
        if self.period is not None and dwell_times != [self.period.name]:
            named.append(("period", self.period.name))
        for place, (kind, name) in enumerate(named):
            if (kind, name) in named[:place]:
                raise DeclarationError(f"{where}: {kind} {name!r} is named twice")
            if not name.isidentifier() or iskeyword(name):
                raise DeclarationError(f"{where}: {kind} {name!r} is not an identifier")
            if name in taken or name in [n for _, n in named[:place]]:
                raise DeclarationError(f"{where}: {kind} {name!r} has the name of something else")
        for kind, names, known in (
            ("start of", self.start, states),
            ("reversor of", map(str, self.reversor), states),
            ("symmetry of", map(str, self.symmetry), [*map(str, self.system.states)]),
            ("vanishing dwell time", self.vanishing, dwell_times),
            ("parameter to solve for", self.solved_for, parameters),
        ):
            given = list(names)
            for place, name in enumerate(given):
                if name not in known:
                    raise DeclarationError(f"{where}: {kind} {name!r}, which is not declared")
                if name in given[:place]:
                    raise DeclarationError(f"{where}: {kind} {name!r} is named twice")
        presented = (self.presentation or self.system).states
        for rules, symbols in ((self.reversor, presented), (self.symmetry, self.system.states)):
            for symbol in rules:
                if symbol not in symbols:
                    raise DeclarationError(
                        f"{where}: symbol {symbol} has other assumptions than the declared"
                    )
        for state, image in self.symmetry.items():
            if image not in self.system.states and -image not in self.system.states:
                raise DeclarationError(
                    f"{where}: symmetry maps {state} to {image}, which is no state, nor minus one"
                )
        if self.symmetry and (self.reversor or self.vanishing or self.presentation):
            raise DeclarationError(
                f"{where}: a symmetry goes with the system's own coordinates, and neither with a"
                " reversor nor with vanishing dwell times"
            )
        if len(self.vanishing) != len(self.solved_for):
            raise DeclarationError(
                f"{where}: {len(self.vanishing)} vanishing dwell times,"
                f" but {len(self.solved_for)} parameters to solve for"
            )

    def rotated(self, by: int) -> Itinerary:
        """Start the same cycle some phases later; its start has names of its own, and no source.

        Parameters
        ----------
        by : int
            How many phases later.

        Returns
        -------
        Itinerary
        """
        by %= len(self.phases)
        if not by:
            return self
        phases = self.phases[by:] + self.phases[:by]
        return replace(self, phases=phases, start={}, source=None)

    def specialised(self, values: Values) -> Itinerary:
        """Write the same itinerary with parameters replaced by values.

        Parameters
        ----------
        values : mapping of symbol to expression
            What is put in place of each symbol.

        Returns
        -------
        Itinerary
        """
        if not values:
            return self
        states = self.system.states
        shown = self.presentation or Presentation(states, (0,) * len(states))
        substitution = {**dict(shown.substitution.items()), **values}
        return replace(self, presentation=replace(shown, substitution=substitution))

    @cached_property
    def presented_system(self) -> System:
        """The system in the coordinates and parameters of the presentation, and the period."""
        system = self.presentation.present(self.system) if self.presentation else self.system
        if self.period is None:
            return system
        return replace(system, parameters=(*system.parameters, self.period))

    def transition_after(self, system: System, index: int) -> Transition:
        """Find the transition that ends a phase.

        Parameters
        ----------
        system : System
            Whose transition it is.
        index : int
            Number of the phase, counted from 0.

        Returns
        -------
        Transition
        """
        phase, following = self.phases[index], self.phases[(index + 1) % len(self.phases)]
        return system.transition(phase.configuration, phase.boundary, following.configuration)

    def duration(self, index: int) -> sp.Expr:
        """Give the dwell time of a phase: its symbol, zero, or what the others leave of the period.

        Parameters
        ----------
        index : int
            Number of the phase, counted from 0.

        Returns
        -------
        expression
        """
        symbols = [dwell_symbol(p.dwell_time) for p in self.phases]
        if self.phases[index].dwell_time in self.vanishing:
            return sp.Integer(0)
        if self.period is not None and index == len(symbols) - 1:
            others = (self.duration(k) for k in range(index))
            return self.period.symbol - sp.Add(*others)
        return symbols[index]


def _is_text_or_number(value: Any) -> bool:
    """Whether a value is a text, or a real number of Python, NumPy, SymPy or mpmath."""
    if isinstance(value, str | Real | Decimal):
        return not isinstance(value, bool)
    return isinstance(value, sp.Expr) and bool(value.is_extended_real and value.is_number)


def dwell_symbol(name: str) -> sp.Symbol:
    """The symbol of a dwell time."""
    return sp.Symbol(name, positive=True)
