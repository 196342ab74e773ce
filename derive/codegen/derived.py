"""What is derived of a system and its orbits before anything is written down."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from enum import Enum
from typing import NamedTuple

from nonsmooth.derive.codegen.any_arithmetic import python_kernel
from nonsmooth.derive.codegen.kernels import (
    flow_kernels,
    orbit_kernels,
    period_map_kernel,
    spectrum_kernel,
)
from nonsmooth.derive.codegen.simulation_form import SimulationForm
from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.derive.declaration.soundness import check_unique
from nonsmooth.derive.declaration.symmetry import moves_freely
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.equations.derivation import derive_equations
from nonsmooth.derive.equations.equation_system import EquationSystem
from nonsmooth.derive.equations.program import Kernel
from nonsmooth.derive.equations.shown_conditions import transition_unshown
from nonsmooth.derive.errors import DeclarationError, DerivationError
from nonsmooth.derive.flows.modal import derive_flows

# beyond, an orbit's formulas are no longer worth their length: it is composed at run time
MOST_PHASES = 6
# states of all phases together, beyond which deriving and compiling takes longer than an answer
# should: 12 states take 2 to 9 seconds, 24 take 15
MOST_STATES = 12

Progress = Callable[[str], None]  # gets the name of each step when it begins


def silent(step: str) -> None:
    """Progress of which nobody is told."""


class Use(Enum):
    """The purpose of kernels, which decides which orbits get them."""

    ANYTHING = "whatever has closed forms, however long they are"
    MANY_POINTS = "orbits of moderate length, to be compiled and solved at many points"
    FIRST_ANSWER = "of these the undamped and unforced, whose kernels NumPy evaluates at once"


@dataclass(frozen=True)
class Underived:
    """An orbit without kernels, and the reason."""

    itinerary: Itinerary
    reason: str
    many: bool = False  # whether kernels for many points may be derived of it


class DerivedKernel(NamedTuple):
    """A kernel, the name of its orbit, None for the system's, and its source in Python."""

    kernel: Kernel
    orbit: str | None
    python: str


@dataclass(frozen=True)
class DerivedSystem:
    """A system, its orbits and the kernels of both."""

    form: SimulationForm
    orbits: tuple[EquationSystem | Underived, ...]  # in the order in which they were declared
    kernels: tuple[DerivedKernel, ...]

    @property
    def system(self) -> System:
        """The declared system."""
        return self.form.system

    @property
    def functions(self) -> list[str]:
        """Python sources of the kernels."""
        return [kernel.python for kernel in self.kernels]

    @property
    def derived(self) -> tuple[EquationSystem, ...]:
        """Orbits whose equations are derived."""
        return tuple(orbit for orbit in self.orbits if isinstance(orbit, EquationSystem))

    @property
    def underived(self) -> tuple[Underived, ...]:
        """Orbits that are left to be composed at run time."""
        return tuple(orbit for orbit in self.orbits if isinstance(orbit, Underived))


def derive_system(
    system: System,
    orbits: Sequence[Itinerary],
    progress: Progress = silent,
    *,
    use: Use = Use.ANYTHING,
) -> DerivedSystem:
    """Kernels of a system and of its orbits, each as far as it has a closed form.

    Orbits that get no kernels for the given use are left to be composed at run time.
    `progress` gets the name of each step when it begins. DeclarationError refuses orbits of
    another system and two of one name, DerivationError an orbit that neither has a closed
    form nor can be composed without one.
    """
    _check_orbits(system, orbits)
    name = system.name
    progress(f"{name}: flows")
    open_form, kernels = None, list[DerivedKernel]()
    try:
        spectrum, flows = derive_flows(system)
    except DerivationError as problem:
        form, open_form = SimulationForm(system), " ".join(str(problem).split())
    else:
        form = SimulationForm(system, spectrum, flows)
        kernels += _printed(
            (spectrum_kernel(spectrum), *flow_kernels(system, spectrum, flows)), None
        )
    kernels += _printed(form.kernels(), None)
    found: list[EquationSystem | Underived] = []
    for orbit in orbits:
        reason, many = open_form or _obstacle(orbit), False
        if reason is None and use is not Use.ANYTHING:
            reason = _too_long(orbit)
        if reason is None and use is Use.FIRST_ANSWER:
            reason = _damped_or_forced(form, orbit)
            many = reason is not None and _composable(orbit)
        if reason is not None:
            if orbit.vanishing:
                raise DerivationError(reason)
            found.append(Underived(orbit, reason, many))
            continue
        progress(f"{name}/{orbit.name}: equations")
        try:
            equations = _equations(form, orbit)
            turn = period_map_kernel(equations) if use is Use.ANYTHING else None
            every = (*orbit_kernels(equations), *([turn] if turn else []))
            kernels += _printed(every, orbit.name)
        except DeclarationError:
            raise
        # SymPy says NotImplementedError where it cannot solve or print
        except (ValueError, NotImplementedError) as problem:
            if orbit.vanishing:
                raise
            found.append(Underived(orbit, " ".join(str(problem).split())))
            continue
        found.append(equations)
    return DerivedSystem(form, tuple(found), tuple(kernels))


def _printed(kernels: Iterable[Kernel], orbit: str | None) -> list[DerivedKernel]:
    return [DerivedKernel(kernel, orbit, python_kernel(kernel, orbit)) for kernel in kernels]


def _too_long(orbit: Itinerary) -> str | None:
    """The reason why an orbit without kernels gives an answer sooner: long formulas, or None."""
    states = len(orbit.phases) * len(orbit.system.states)
    if states <= MOST_STATES or not _composable(orbit):
        return None
    long = f"its formulas are long ({len(orbit.phases)} phases, {states} states)"
    return f"{long}: `nonsmooth generate` derives them"


def _damped_or_forced(form: SimulationForm, orbit: Itinerary) -> str | None:
    """The reason why an orbit is better composed for a first answer, or None.

    Kernels of damped or forced motions are slow before they are compiled.
    """
    flows = {} if form.flows is None or orbit.vanishing else form.flows
    for name in dict.fromkeys(phase.configuration for phase in orbit.phases):
        if name in flows and flows[name].frequencies is None:
            return f"{name!r} is damped or forced: compiled kernels of its own solve many points"
    return None


def _composable(orbit: Itinerary) -> bool:
    """Whether the phases alone identify the orbit in the system's own coordinates."""
    special = orbit.presentation or orbit.vanishing or orbit.solved_for or orbit.period
    return not special


def _obstacle(orbit: Itinerary) -> str | None:
    """The reason why an orbit's equations are not derived, as its declaration shows, or None."""
    if orbit.symmetry:
        return "it is known by a part and a symmetry"
    if moves_freely(orbit.system):
        return "it is periodic up to a shift: its system does not depend on where"
    if len(orbit.phases) > MOST_PHASES:
        return f"it has more than {MOST_PHASES} phases"
    if boundary := transition_unshown(orbit):
        return f"behind {boundary!r} conditions decide where it leads, which its phases do not show"
    return None


def _equations(form: SimulationForm, orbit: Itinerary) -> EquationSystem:
    """The equations of an orbit; DerivationError says why they are no good for kernels."""
    equations = derive_equations(orbit)
    if equations.conservative and orbit.period is None:
        raise DerivationError("it is one of a family: energy is kept, and no period is declared")
    if equations.spectrum != form.spectrum:
        name = f"{form.system.name}/{orbit.name}"
        raise DerivationError(f"{name}: its presentation changes the spectrum")
    _check_reference(equations)
    if not set(reduced_names(equations)) <= set(map(str, equations.unknowns)):
        raise DerivationError("its reduced unknowns are coordinates of another section")
    return equations


def reduced_names(equations: EquationSystem) -> list[str]:
    """Names of the reduced unknowns; a coordinate of the start has the start's name."""
    reduction = equations.reduction
    own = [u for u in reduction.unknowns if u not in equations.unknowns]
    started = reduction.start is not None and reduction.rotation == 0
    coordinates = equations.chain.section.coordinates if started else ()
    names = dict(zip(own, coordinates, strict=False))
    return [str(names.get(u, u)) for u in reduction.unknowns]


def _check_reference(equations: EquationSystem) -> None:
    """Refuse a reference with unknown parameters, or without a guess of some unknown.

    Coordinates of the start may be missing, as they follow from the dwell times.
    """
    itinerary = equations.itinerary
    if itinerary.reference is None:
        return
    guess = itinerary.reference.guess
    declared = (*itinerary.system.parameters, *equations.system.parameters)
    unknowns = [str(u) for u in equations.unknowns]
    told = set() if itinerary.presentation else set(map(str, equations.chain.section.coordinates))
    missing = [name for name in unknowns if name not in guess and name not in told]
    strange = [n for n in itinerary.reference.parameters if n not in {p.name for p in declared}]
    if missing:
        raise DeclarationError(
            f"itinerary {itinerary.name!r}: the reference guesses no {missing[0]}"
            f" (the unknowns are: {', '.join(unknowns)})"
        )
    if strange:
        raise DeclarationError(
            f"itinerary {itinerary.name!r}: the reference has {strange[0]}, which is no parameter"
        )


def _check_orbits(system: System, orbits: Sequence[Itinerary]) -> None:
    for orbit in orbits:
        if orbit.system is not system and orbit.system != system:
            raise DeclarationError(
                f"orbit {orbit.name!r} is one of another system than {system.name!r}"
            )
    check_unique([orbit.name for orbit in orbits], "orbit")
