"""The pipeline of this package: from an itinerary to its equations, stage by stage."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from nonsmooth.derive.declaration.fields import made
from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.derive.equations.chain import Chain, follow
from nonsmooth.derive.equations.elimination import eliminate_coordinates, reduce_forced
from nonsmooth.derive.equations.energy import is_conservative, keeps_volume, without_redundant
from nonsmooth.derive.equations.equation_system import EquationSystem
from nonsmooth.derive.equations.forcing import PERIODS, forcing_of
from nonsmooth.derive.equations.program import Equation
from nonsmooth.derive.equations.reduction import Reduction, reduce_itinerary
from nonsmooth.derive.equations.reference import reference_values, with_guess
from nonsmooth.derive.equations.section import section_of, smallest_section, start_of
from nonsmooth.derive.equations.symmetry import half_phases, required_values, vanishing_coordinates
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.flows.modal import Flow, Spectrum, derive_flows

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
    itinerary = made(Itinerary, itinerary, "itinerary")
    required = required_values(itinerary, start_of(itinerary)) if itinerary.reversor else {}
    itinerary = itinerary.specialised(required)
    system = itinerary.presented_system
    spectrum, flows = derive_flows(system)
    section, start = section_of(itinerary), start_of(itinerary)
    vanishing = vanishing_coordinates(itinerary, start) if itinerary.reversor else ()
    start = start.without(vanishing)
    forcing = forcing_of(itinerary, section.places)
    chain = follow(itinerary, flows, section, start, forcing)
    _check_length(itinerary, chain)
    parameters = tuple(p.symbol for p in system.parameters)
    known = reference_values(itinerary.reference, spectrum, parameters)
    if not itinerary.reversor and itinerary.period is None:
        itinerary = with_guess(itinerary, chain, known)
        known = reference_values(itinerary.reference, spectrum, parameters)
    dwell_times = tuple(
        link.dwell
        for link in chain.links
        if link.duration == link.dwell and link.dwell not in parameters
    )
    swapped = tuple(s for s in parameters if str(s) in itinerary.solved_for)
    unknowns = start.coordinates + dwell_times + swapped
    conservative, rank = is_conservative(itinerary), smallest_section(itinerary)[1].dimension
    constants = {*parameters, *spectrum.symbols}
    stages, equations = chain.stages, _full_turn(chain)
    if itinerary.reversor:
        stages, equations = half_phases(itinerary, flows, start)
        reduction = eliminate_coordinates(
            stages, equations, start.coordinates, dwell_times, constants, known, rank
        )
    elif forcing is not None and not swapped:
        reduction = reduce_forced(chain, constants, known, rank)
    elif forcing is None and itinerary.period is None:
        reduction = reduce_itinerary(itinerary, flows, constants, swapped)
    else:
        if conservative:
            equations = without_redundant(itinerary, chain, equations, known)
        reduction = Reduction(rank, unknowns, equations, stages, {u: u for u in unknowns})
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
    boundaries = (b.function for link in chain.links for b in link.configuration.boundaries)
    limiting = set().union(*(function.free_symbols for function in boundaries))
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
        conservative,
        conservative and rank == len(chain.coordinates) == 3 and keeps_volume(itinerary),
        known,
    )


def _full_turn(chain: Chain) -> tuple[Equation, ...]:
    """One exit condition for each phase, and the closure of the start's coordinates.

    A forcing has, in place of closure, conditions on its amplitude and on the period.
    """
    equations = [(link.meaning, sp.expand(link.exit)) for link in chain.links]
    equations += [(f"{q} returns", chain.end[place] - q) for q, place in chain.closing]
    if chain.forcing is not None:
        equations += chain.forcing.conditions(chain.start.state)
        total = sp.Add(*(link.duration for link in chain.links))
        equations.append((PERIODS, total - chain.forcing.period))
    return tuple(equations)


def _check_length(itinerary: Itinerary, chain: Chain) -> None:
    """Refuse an orbit with formulas too long to be read, whose derivation takes minutes."""
    terms = (e for stage in chain.stages for _, e in stage.assignments)
    length = sum(int(sp.count_ops(e)) for e in terms)
    if length > MOST_OPERATIONS:
        raise DerivationError(
            f"itinerary {itinerary.name!r}: its formulas are too long ({length} operations along"
            f" its phases; {MOST_OPERATIONS} are written out)"
        )


def _check_solvable(
    itinerary: Itinerary,
    swapped: Sequence[sp.Symbol],
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
