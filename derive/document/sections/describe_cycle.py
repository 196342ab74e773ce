"""The sections of a document on an itinerary: phases, equations, elimination of the start."""

from __future__ import annotations

import sympy as sp

from nonsmooth.derive.declaration.itinerary import dwell_symbol
from nonsmooth.derive.document.blocks import Block, Formula, Line, Paragraph
from nonsmooth.derive.document.notation.wording import count, enumeration, number
from nonsmooth.derive.document.sections.describe_itinerary import (
    boundary_at,
    phase_sentence,
    phase_table,
    source_letters,
    transposed,
)
from nonsmooth.derive.document.views.cycle import Cycle
from nonsmooth.derive.equations.energy import is_conservative

__all__ = ["elimination_section", "equation_section", "phase_section"]


def phase_section(cycle: Cycle) -> list[Block]:
    """Blocks on the phases, the start and the unknowns of an itinerary."""
    return [
        *_phases(cycle), *source_letters(cycle.naming, cycle.numbers), *_symmetry(cycle),
        *_start(cycle), *_translations(cycle), *_unknowns(cycle),
    ]  # fmt: skip


def _phases(cycle: Cycle) -> list[Block]:
    notation, phases = cycle.naming.notation, cycle.itinerary.phases
    if cycle.distinct:
        last, entries = "Where", [boundary_at(cycle.naming, phase) for phase in phases]
    else:
        last = "Transition"
        entries = [f"${cycle.number(index)}$" for index in range(1, len(phases) + 1)]
    text = phase_sentence(len(phases))
    if not cycle.distinct:
        many = len(cycle.passings)
        text += (
            f" Behind them there are {count(many, 'different transition')};"
            if many > 1
            else " Behind all of them is the same transition;"
        )
        text += " $j(k)$ is the number of the one behind phase $k$."
    blocks: list[Block] = [
        Paragraph(text),
        phase_table(cycle.naming, cycle.numbers, phases, last, entries),
    ]
    period = cycle.itinerary.period
    if period is not None:
        blocks.append(
            Paragraph(
                f"The period ${notation.symbol(period.symbol)}$ is given; the last dwell time is"
                " what the others leave of it."
            )
        )
    vanishing = cycle.itinerary.vanishing
    if vanishing:
        zero = enumeration([f"${notation.symbol(dwell_symbol(v))} = 0$" for v in vanishing])
        verb = "has" if len(vanishing) == 1 else "have"
        blocks.append(
            Paragraph(
                f"Here {zero}: boundaries are reached at one instant, a border collision, for"
                f" which {_parameters(cycle)} {verb} to be found."
            )
        )
    return blocks


def _symmetry(cycle: Cycle) -> list[Block]:
    """Paragraph on the reversor that maps the orbit to itself; nothing without one."""
    notation = cycle.naming.notation
    rules = [
        rf"${notation.symbol(s)} \mapsto {notation.latex(e)}$"
        for s, e in cycle.itinerary.reversor.items()
    ]
    if not rules:
        return []
    return [
        Paragraph(
            f"The orbit is sought among those that the reversor {enumeration(rules)} maps to"
            " themselves, each phase being its own time reversal."
        )
    ]


def _parameters(cycle: Cycle) -> str:
    symbols = [p.symbol for p in cycle.system.parameters]
    return cycle.naming.list([s for s in symbols if str(s) in cycle.itinerary.solved_for])


def _start(cycle: Cycle) -> list[Block]:
    """Blocks on the set on which the start lies."""
    naming, start, letters = cycle.naming, cycle.start, cycle.letters
    state = naming.state
    column = rf"\left({', '.join(map(naming.notation.symbol, naming.system.states))}\right)"
    e, q, base = letters.embedding, letters.coordinates, letters.base
    shift = "" if start.constant.is_zero_matrix else f" + {base}"
    written = f"{transposed(naming, start.state)}"
    line = Line(f"{state}^{{(0)}}", "=", (f"{e} {q}{shift}", f"= {written}"), None, start.state)
    names = transposed(naming, sp.Matrix(start.coordinates))
    text = (
        f"${state}^{{(k)}}$ is the state ${column}^{{\\mathsf{{T}}}}$ at the end of phase $k$"
        + (f", in front of the transition, ${state}^{{(k)+}}$ behind it," if cycle.resets else "")
        + f" and ${state}^{{(0)}}$ the start."
        " What the end of the last phase enforces, carried through its transition, leaves the"
        f" start {count(start.dimension, 'coordinate')},"
    )
    if not start.dimension:
        text = text.removesuffix(f" {count(0, 'coordinate')},") + " no freedom,"
        return [Paragraph(text), Formula((Line(f"{state}^{{(0)}}", "=", (f"{written}.",)),))]
    return [
        Paragraph(text),
        Formula((line, Line(q, "=", (f"{names}.",)))),
    ]


def _translations(cycle: Cycle) -> list[Block]:
    """Blocks on the directions along which the orbit need not return."""
    naming, letters, directions = cycle.naming, cycle.letters, cycle.directions
    if not directions.cols:
        return []
    along, shift, state = letters.directions, letters.shift, naming.state
    one = directions.cols == 1
    written = transposed(naming, directions) if one else naming.notation.latex(directions)
    return [
        Paragraph(
            f"Nothing depends on where along ${along} = {written}$ the motion takes place: with a"
            f" motion ${state}(t)$ every ${state}(t) + {along} {shift}$ is one. The orbit returns"
            f" up to such a shift ${shift}$, and"
            f" {count(directions.cols, 'coordinate')} of the start, changed by it, may be chosen."
        )
    ]


def _unknowns(cycle: Cycle) -> list[Block]:
    naming, itinerary = cycle.naming, cycle.itinerary
    free = [p.dwell_time for p in itinerary.phases if p.dwell_time not in itinerary.vanishing]
    if itinerary.period is not None:
        free = free[:-1]
    dwell = [dwell_symbol(name) for name in free]
    total = len(dwell) + cycle.start.dimension + len(itinerary.solved_for)
    times = f"{number(len(dwell))} dwell time{'' if len(dwell) == 1 else 's'}"
    left = cycle.start.dimension - cycle.directions.cols
    coordinates = f"{count(left, 'coordinate')} of the start"
    parts = [part for part, some in ((times, dwell), (coordinates, left)) if some]
    parts += [f"the shift ${cycle.letters.shift}$"] if cycle.directions.cols else []
    plural = "" if len(itinerary.solved_for) == 1 else "s"
    parts += [f"the parameter{plural} {_parameters(cycle)}"] if itinerary.solved_for else []
    given = [p.symbol for p in naming.system.parameters if p.name not in itinerary.solved_for]
    names = naming.list(given)
    text = f"The unknowns are {enumeration(parts)}, {number(total)} in all."
    return [Paragraph(text + (f" Given are the parameters {names}." if names else ""))]


def equation_section(cycle: Cycle) -> list[Block]:
    """Blocks on the chain of states, the switching conditions and the closure."""
    naming, letters = cycle.naming, cycle.letters
    state, k, p, phase = naming.state, cycle.index, cycle.count, cycle.phase
    n, c, h = letters.normal, letters.constant, letters.forcing
    plus = "+" if cycle.resets else ""
    before = f"{state}^{{({'k-1' if p > 1 else 0}){plus if p > 1 else ''}}}"
    end, behind = f"{state}^{{({phase})}}", f"{state}^{{({phase}){plus}}}"
    flow = rf"\Phi^{{({phase})}} {before} + {h}^{{({phase})}}"
    text = (
        rf"Let $\Phi^{{({phase})}}$ be the flow of phase ${phase}$ over its dwell time and"
        rf" ${h}^{{({phase})}}$ the part of it that does not depend on the state, zero in a"
        " configuration that rests at the origin."
    )
    follow = f"From the start, the state{'s follow' if p > 1 else ' follows'}{_all_phases(p)}"
    if cycle.resets:
        reset = rf"{letters.reset}_{{{k}}} {end} + {letters.jump}_{{{k}}}"
        pieces = [rf"{flow},\qquad", f"{behind} = {reset}."]
        if p > 1:
            pieces[1:] = [rf"{behind} = {reset},\qquad", f"{state}^{{(0)+}} = {state}^{{(0)}}."]
        line = Line(end, "=", tuple(pieces))
        text += (
            rf" The transition behind it takes ${state}$ to ${letters.reset}_{{{k}}} {state} +"
            rf" {letters.jump}_{{{k}}}$. {follow},"
        )
    else:
        line = Line(end, "=", (f"{flow}.",))
        text += f" The state is continuous at every transition. {follow},"
    ends = f"{state}^{{({p}){'+' if cycle.resets else ''}}}"
    unknown = cycle.start.dimension
    inverse = f"{letters.embedding}^{{+}}"
    switching = Line("", "", (rf"{n}_{{{k}}} {end} + {c}_{{{k}}} = 0",))
    blocks: list[Block] = [
        Paragraph(text),
        Formula((line,), label=cycle.label("The equations")),
        Paragraph(
            f"Each phase ends on its boundary, the function of which is ${n}_{{{k}}} {state} +"
            f" {c}_{{{k}}}$:"
        ),
        Formula(
            (switching,), label=cycle.label("The equations", 1), note=_all_phases(p).strip() or None
        ),
    ]
    if not unknown:
        blocks.append(Paragraph("The end of the last phase closes the orbit of itself."))
        return blocks
    returned = rf"\left({ends} - {_shift(cycle)}\right)" if cycle.directions.cols else ends
    closure = Line("", "", (rf"{inverse} {returned} - {letters.coordinates} = 0",))
    total = count(p + unknown, "equation")
    return [
        *blocks,
        Paragraph(
            f"and the orbit closes{' up to the shift' if cycle.directions.cols else ''}. With"
            f" ${inverse}$, which takes the coordinates"
            f" ${letters.coordinates}$ of a state on the section,"
        ),
        Formula((closure,), label=cycle.label("The equations", 2)),
        Paragraph(
            f"These are {total}. The other coordinates return with these, by what the last phase"
            " enforces."
            + (
                " The energy is kept along the orbit, so that one of the equations follows from"
                " the others: the orbit is one of a family, and its period may be given."
                if is_conservative(cycle.itinerary)
                else ""
            )
        ),
    ]


def _shift(cycle: Cycle) -> str:
    """LaTeX of the shift of the state along the directions that nothing depends on."""
    return f"{cycle.letters.directions} {cycle.letters.shift}"


def _all_phases(phases: int) -> str:
    if phases == 1:
        return ""
    return " for $k = 1, 2$" if phases == 2 else rf" for $k = 1, \ldots, {phases}$"


def elimination_section(cycle: Cycle) -> list[Block]:
    """Blocks on the start as the solution of a linear system, given the dwell times."""
    naming, letters, p = cycle.naming, cycle.letters, cycle.count
    n, m, r = letters.passage, letters.remainder, letters.reset
    e, q, inverse = letters.embedding, letters.coordinates, f"{letters.embedding}^{{+}}"
    state, k, phase = naming.state, cycle.index, cycle.phase
    jump = rf"{r}_{{{k}}} " if cycle.resets else ""
    inner = rf"{r}_{{{k.replace('k', 'i')}}} " if cycle.resets else ""
    ends = f"{state}^{{({p}){'+' if cycle.resets else ''}}}"
    added = rf"{jump}{letters.forcing}^{{({phase})}}"
    if cycle.resets:
        added += f" + {letters.jump}_{{{k}}}"
    product = rf"{cycle.product}{jump}\Phi^{{({phase})}}"
    later = added
    if p > 1:
        added = rf"\left({added}\right)" if cycle.resets else added
        factors = rf"\left(\prod_{{i={p}}}^{{k+1}} {inner}\Phi^{{(i)}}\right)"
        later = rf"\sum_{{k=1}}^{{{p}}} {factors} {added}"
    base = "" if cycle.start.constant.is_zero_matrix else f"{n} {letters.base} + "
    moved = f" - {_shift(cycle)}" if cycle.directions.cols else ""
    right = rf"\left({base}{m}{moved}\right)" if base or moved else m
    determined = f"it and ${letters.shift}$" if moved else "it"
    blocks: list[Block] = [
        Paragraph(
            "Given the dwell times, one passage is an affine map of the start,"
            f" ${ends} = {n} {state}^{{(0)}} + {m}$, with"
        ),
        Formula(
            (
                Line(n, "=", (rf"{product},\qquad",)),
                Line(m, "=", (f"{later},",)),
            )
        ),
        Paragraph(
            ("the factors of later phases standing on the left. " if p > 1 else "so that ")
            + ("The" if p > 1 else "the")
            + f" closure is linear in the start and determines {determined},"
        ),
        Formula(
            (Line(rf"\left(I - {inverse} {n} {e}\right) {q}", "=", (f"{inverse} {right}.",)),),
            label=cycle.label("The reduction"),
        ),
        Paragraph(
            f"What is left are the switching conditions ({cycle.label('The equations', 1)})"
            + (", as many as dwell times;" if cycle.itinerary.period is None else ";")
            + " Newton's method solves them from a guess, the start following the dwell times."
        ),
    ]
    return blocks + _forcing(cycle)


def _forcing(cycle: Cycle) -> list[Block]:
    """Blocks on the states of a forcing, which return by themselves."""
    notation = cycle.naming.notation
    if not cycle.harmonics:
        return []
    names = cycle.naming.list(s for h in cycle.harmonics for s in (h.first, h.second))
    kept = enumeration([f"${notation.latex(h.invariant)}$" for h in cycle.harmonics])
    periods = enumeration([f"${notation.latex(2 * sp.pi / h.frequency)}$" for h in cycle.harmonics])
    one, label = len(cycle.harmonics) == 1, cycle.label("The reduction")
    return [
        Paragraph(
            f"The forcing is an exception: {names} oscillate by themselves, and nothing acts on"
            f" them. They return after whole multiples of {periods} alone, which fixes the sum of"
            f" the dwell times, and then from every start: in ({label}) their rows vanish. Of their"
            f" start {kept} keep{'s' if one else ''} the value that is given,"
            f" the amplitude{'' if one else 's'} of the forcing, and the"
            f" phase{'' if one else 's'} of it at the start"
            f" {'is an unknown' if one else 'are unknowns'} in place of the sum. The other rows of"
            f" ({label}) determine the other coordinates from these."
        )
    ]
