"""The pipeline of this package: from an itinerary to its equations, stage by stage."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.equations.chain import Chain, follow
from nonsmooth.derive.equations.elimination import eliminate_coordinates, reference_values
from nonsmooth.derive.equations.energy import energy_of, is_conservative
from nonsmooth.derive.equations.equation_system import EquationSystem
from nonsmooth.derive.equations.forced import reduce_forced
from nonsmooth.derive.equations.forcing import PERIODS, Forcing, forcing_of
from nonsmooth.derive.equations.guess import with_guess
from nonsmooth.derive.equations.reduction import reduce_itinerary, unreduced
from nonsmooth.derive.equations.section import Section, section_of, smallest_section, start_of
from nonsmooth.derive.equations.symmetry import half_phases, required_values, vanishing_coordinates
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.flows.modal import Flow, Spectrum, derive_flows

__all__ = ["MOST_OPERATIONS", "derive_equations"]

MOST_OPERATIONS = 1000  # of the states along an orbit: beyond, its derivatives fill a book


def derive_equations(itinerary: Itinerary) -> EquationSystem:
    """Derive everything about one orbit; the pipeline of this package, stage by stage.

    * the **presented system**: the declaration in the itinerary's coordinates;
    * its **flows**: closed form inside each configuration, over one common spectrum;
    * the **section** that the end of the last phase enforces, and the **start** on it;
    * the **chain** of states: start, phases, transitions;
    * the **equations**: one exit condition a phase, and the closure of the start; for a
      reversible orbit, conditions halfway through the phases; for a forced one, its
      amplitude and the number of its periods;
    * the **reduction**: whatever is linear or explicit, eliminated.

    Jacobians, Poincare map, trace and boundary functions are derived from these when an
    emitter asks for them. Flows are those of modal analysis; the equations of the built-in orbits
    are those of Pascal (2011); a perturbation passes a transition by the saltation matrix of
    Aizerman and Gantmakher (1958).

    Parameters
    ----------
    itinerary : Itinerary
        With its system; its parameters are nondimensional, or in consistent units.

    Returns
    -------
    EquationSystem
        Unknowns, parameters, equations, and what is derived from them on demand.

    Raises
    ------
    DerivationError
        If a configuration has no closed form, the formulas are too long, the start satisfies
        no state, the reference does not tell how many periods of its forcing a forced orbit
        takes, or the itinerary gives more or fewer equations than unknowns.

    Examples
    --------
    >>> from nonsmooth.derive import derive_equations
    >>> from nonsmooth.derive.systems import rigid_stop
    >>> (itinerary,) = rigid_stop.orbits
    >>> derive_equations(itinerary).unknowns
    (y, u)
    """
    required = _required(itinerary)
    itinerary = itinerary.specialised(required)
    system = itinerary.presented_system
    spectrum, flows = derive_flows(system)
    section = section_of(itinerary, system)
    start = start_of(itinerary, system, section)
    vanishing = vanishing_coordinates(itinerary, system, start) if itinerary.reversor else ()
    start = start.without(vanishing)
    forcing = _forcing(itinerary, system, section)
    chain = follow(itinerary, system, flows, section, start, forcing)
    _check_length(itinerary, chain)
    parameters = tuple(p.symbol for p in system.parameters)
    known = reference_values(itinerary.reference, spectrum, parameters)
    if not itinerary.reversor and itinerary.period is None:
        itinerary = with_guess(itinerary, system, chain, known)
    dwell_times = tuple(
        link.dwell
        for link in chain.links
        if link.duration == link.dwell and link.dwell not in parameters
    )
    swapped = tuple(s for s in parameters if str(s) in itinerary.solved_for)
    if itinerary.reversor:
        halves = half_phases(itinerary, system, flows, start)
        stages, equations = halves.stages, halves.equations
        reduction = eliminate_coordinates(
            stages,
            equations,
            start.coordinates,
            dwell_times,
            {*parameters, *spectrum.symbols},
            known,
            smallest_section(itinerary, system)[1].dimension,
        )
    else:
        stages, equations = chain.stages, _full_turn(itinerary, chain)
        if forcing is not None and not itinerary.solved_for:
            reduction = reduce_forced(itinerary, system, chain, known, spectrum)
        elif itinerary.period is None and forcing is None:
            reduction = reduce_itinerary(itinerary, system, flows, spectrum)
        else:
            equations = _without_one(itinerary, system, chain, equations, known)
            dimension = smallest_section(itinerary, system)[1].dimension
            left = start.coordinates + dwell_times + swapped
            reduction = unreduced(left, equations, stages, dimension)
    unknowns = start.coordinates + dwell_times + swapped
    if len(equations) != len(unknowns):
        raise DerivationError(
            f"itinerary {itinerary.name!r}: {len(equations)} equations for {len(unknowns)} unknowns"
        )
    _check_solvable(itinerary, swapped, spectrum, flows)
    used = set().union(
        *(e.free_symbols for _, e in equations),
        *(e.free_symbols for stage in (*stages, *chain.stages) for _, e in stage.assignments),
        spectrum.parameters,
    )
    limiting = set().union(
        *(
            boundary.function.free_symbols
            for phase in itinerary.phases
            for boundary in system.configuration(phase.configuration).boundaries
        )
    )
    free = [s for s in parameters if s not in swapped]
    return EquationSystem(
        itinerary,
        system,
        spectrum,
        flows,
        chain,
        unknowns,
        stages,
        equations,
        tuple(s for s in free if s in used),
        tuple(s for s in free if s in limiting - used),
        reduction,
        required,
        vanishing,
        is_conservative(itinerary, system),
    )


def _required(itinerary: Itinerary) -> dict[sp.Symbol, sp.Expr]:
    """Values by parameter without which a reversible orbit does not exist."""
    if not itinerary.reversor:
        return {}
    system = itinerary.presented_system
    start = start_of(itinerary, system, section_of(itinerary, system))
    return required_values(itinerary, system, start)


def _full_turn(itinerary: Itinerary, chain: Chain) -> tuple[tuple[str, sp.Expr], ...]:
    """One exit condition for each phase, and the closure of the start's coordinates.

    A forcing has, in place of closure, conditions on its amplitude and on the period.
    """
    equations = [
        (f"{phase.boundary} ends {phase.configuration}", sp.expand(link.exit))
        for phase, link in zip(itinerary.phases, chain.links, strict=True)
    ]
    forced = chain.forcing.states if chain.forcing else ()
    for coordinate, place in zip(chain.start.coordinates, chain.start.places, strict=True):
        if place not in forced:
            equations.append((f"{coordinate} returns", chain.end[place] - coordinate))
    if chain.forcing is not None:
        equations += chain.forcing.conditions(chain.start.state)
        total = sp.Add(*(link.duration for link in chain.links))
        equations.append((PERIODS, total - chain.forcing.period))
    return tuple(equations)


def _forcing(itinerary: Itinerary, system: System, section: Section) -> Forcing | None:
    """The forcing of an orbit, if any; refused if the section fixes one of its states."""
    forcing = forcing_of(itinerary, system)
    if forcing is not None and not {*forcing.states} <= {*section.places}:
        raise DerivationError(f"itinerary {itinerary.name!r}: its section ties the forcing")
    return forcing


def _check_length(itinerary: Itinerary, chain: Chain) -> None:
    """Refuse an orbit with formulas too long to be read, whose derivation takes minutes."""
    terms = (e for stage in chain.stages for _, e in stage.assignments)
    length = sum(int(sp.count_ops(e)) for e in terms)
    if length > MOST_OPERATIONS:
        raise DerivationError(
            f"itinerary {itinerary.name!r}: its formulas are too long ({length} operations along"
            f" its phases; {MOST_OPERATIONS} are written out)"
        )


def _without_one(
    itinerary: Itinerary,
    system: System,
    chain: Chain,
    equations: tuple[tuple[str, sp.Expr], ...],
    known: Mapping[sp.Symbol, sp.Expr],
) -> tuple[tuple[str, sp.Expr], ...]:
    """The equations without the closure that the first integral E makes redundant.

    It is the closure of the coordinate q with the largest |dE/dq| at the known point: the
    others would leave q undetermined to first order.
    """
    first = system.configuration(itinerary.phases[0].configuration)
    energy = energy_of(first.dynamics, system.states)
    if energy is None or not is_conservative(itinerary, system):
        return equations
    at_start = energy.subs(dict(zip(system.states, chain.start.state, strict=True)))
    slopes = [abs(sp.diff(at_start, q).subs(known)) for q in chain.start.coordinates]
    if not all(slope.is_number for slope in slopes):
        raise DerivationError(
            f"itinerary {itinerary.name!r}: a conservative orbit of given period needs a"
            " reference with values of all its parameters and unknowns"
        )
    steepest = max(range(len(slopes)), key=lambda k: slopes[k])
    dropped = len(chain.links) + steepest
    return equations[:dropped] + equations[dropped + 1 :]


def _check_solvable(
    itinerary: Itinerary,
    swapped: tuple[sp.Symbol, ...],
    spectrum: Spectrum,
    flows: Mapping[str, Flow],
) -> None:
    """Refuse to solve for a parameter on which the flows depend."""
    moving = set(spectrum.parameters).union(
        *(m.free_symbols for f in flows.values() for m in (*f.matrices, *f.offsets, *f.field))
    )
    for symbol in swapped:
        if symbol in moving:
            raise DerivationError(
                f"itinerary {itinerary.name!r}: {symbol} changes the flows, so it cannot be"
                " solved for in place of a dwell time"
            )
