"""The sections of a document on an itinerary's transitions, multipliers and admissibility."""

from __future__ import annotations

from nonsmooth.derive.declaration.itinerary import dwell_symbol
from nonsmooth.derive.declaration.transition import Condition
from nonsmooth.derive.document.blocks import Block, Table
from nonsmooth.derive.document.cycle import Cycle, Passing
from nonsmooth.derive.document.sections.derivatives import LOCAL_MAP, SALTATION
from nonsmooth.derive.document.sections.template import by_entries, compose, math, sentence
from nonsmooth.derive.document.wording import enumeration, number
from nonsmooth.derive.equations.energy import is_conservative


def passing_section(cycle: Cycle) -> list[Block]:
    """Blocks with the gradient, fields, reset and saltation matrix of each transition."""
    return compose(
        cycle,
        r"""
        Transition $j$ [distinct: ends phase $j$; it has | has] the gradient $@normal_{j}$ and the
        constant $@constant_{j}$ of its boundary, the vector field $@field_{j}$ of the configuration
        in front of it and $@field_{j}^{+}$ of that behind it[resets: , the matrix $@reset_{j}$ and
        the constant $@jump_{j}$ of its reset (the unit matrix and zero where they are not given)].
        All are written in the state in front of the transition. A perturbed motion reaches the
        boundary earlier or later; to first order its perturbation behind the transition is that in
        front of it times the saltation matrix
        $$
        @letters.saltation_{j} &= @matrix.
        \tag{@label}
        $$
        The boundary is crossed transversally, and the matrix is defined, only where the rate
        $@normal_{j} @field_{j}$ is positive.

        @transitions
        """,
        matrix=sentence(cycle, SALTATION, at="j"),
        label=cycle.label("The transitions"),
        transitions=[
            block
            for place, passing in enumerate(cycle.passings, start=1)
            for block in _passing(cycle, place, passing)
        ],
    )


def _passing(cycle: Cycle, place: int, passing: Passing) -> list[Block]:
    """Blocks on one transition."""
    naming, letters = cycle.naming, cycle.letters
    field = f"{letters.field}_{{{place}}}"
    matrices = {field: passing.before, f"{field}^{{+}}": passing.behind}
    if passing.resets:
        matrices[f"{letters.reset}_{{{place}}}"] = passing.reset
    if not passing.jump.is_zero_matrix:
        matrices[f"{letters.jump}_{{{place}}}"] = passing.jump
    return compose(
        cycle,
        r"""
        Transition @place, from *@passing.transition.source* by *@passing.boundary* to
        *@passing.transition.target* [distinct: | (behind phase[many phases: s] @phases)]:
        $$
        @normal_{@place} &= @passing.normal
        @constant_{@place} &= @passing.constant
        @matrices
        @normal_{@place} @field_{@place} &= @passing.rate
        @saltation
        $$
        """,
        place=place,
        passing=passing,
        phases=[str(k) for k in passing.phases],
        matrices=[line for name in matrices for line in by_entries(naming, name, matrices[name])],
        saltation=by_entries(naming, f"{letters.saltation}_{{{place}}}", passing.saltation),
    )


def stability_section(cycle: Cycle) -> list[Block]:
    """Blocks with the Poincaré map's Jacobian and the monodromy matrix as products."""
    trivial, moved = 2 * len(cycle.harmonics) - 1, cycle.directions.cols
    return compose(
        cycle,
        r"""
        On the section at the start, the dwell times follow a perturbation of the start: each phase
        carries it along and projects it along the vector field onto the boundary. [distinct: | At
        phase $k$ the field $@field_{@index}$ and the matrix $@letters.saltation_{@index}$ are those
        at $@state^{(k)}$.] The Jacobian of the Poincaré map is the product of these local maps, and
        over equal times the monodromy matrix is that of flows and saltation matrices,
        $$
        @jacobian &= @embedding^{+} [product: \left(@product @local\right) | @local] @embedding,
        \mathcal{M} &= @product @letters.saltation_{@index} \Phi^{(@phase)}.
        \tag{@label}
        $$
        $\mathcal{M}$ takes the vector field at the start, $@matrix @state^{(0)} + @offset$ of the
        first phase, to itself. Beside this multiplier 1, and zeros, it has the multipliers of
        $@jacobian$, and $\operatorname{tr} \mathcal{M} = 1 + \operatorname{tr} @jacobian$. The
        orbit is stable where every multiplier that is not trivial lies inside the unit circle.
        [forced: @trivial of those of $@jacobian$ [one: is | are] 1 and trivial: the forcing keeps
        the amplitude[one: | s and phases] of the start. | [conservative: One more is 1 and trivial,
        since the energy is kept along the orbit.]] [moved: @moved more [single: is | are] 1 and
        trivial, since nothing depends on a shift: $@jacobian @embedding^{+} @letters.directions =
        @embedding^{+} @letters.directions$.]
        """,
        local=sentence(cycle, LOCAL_MAP),
        label=cycle.label("Stability"),
        forced=trivial > 0,
        trivial=number(max(trivial, 0)).capitalize(),
        one=trivial == 1,
        conservative=is_conservative(cycle.itinerary),
        moved=number(moved).capitalize() if moved else "",
        single=moved == 1,
    )


def admissibility_section(cycle: Cycle) -> list[Block]:
    """Blocks on admissibility: no boundary is crossed inside a phase.

    A table has the conditions under which each transition is the one that applies.
    """
    itinerary, single = cycle.itinerary, cycle.count == 1
    names = [p.dwell_time for p in itinerary.phases if p.dwell_time not in itinerary.vanishing]
    dwell = [cycle.naming.notation.symbol(dwell_symbol(name)) for name in names]
    positive = [f"{symbol} > 0" for symbol in dwell]
    rows = [
        row
        for place, passing in enumerate(cycle.passings, start=1)
        for row in _conditions(cycle, place, passing)
    ]
    return compose(
        cycle,
        r"""
        A solution is a motion of the system if its dwell times are positive, no boundary of a
        phase's configuration is crossed before the phase ends, and each boundary is crossed
        outwards: with the boundary functions $g$ of the configuration of phase $@phase$ and
        $@state(t)$ the motion in it,
        $$
        @positive,\qquad
            g\left(@state(t)\right) < 0 \text{ for } 0 < t < @time,\qquad
            @normal_{@index} @field_{@index} > 0,
        \tag{@label}
        $$
        [single: | $\tau^{(k)}$ being the dwell time of phase $k$.] Where a maximum of $g$ inside a
        phase is zero the orbit grazes, and its itinerary is about to change.

        [conditions: At a transition the first applies whose conditions hold: those of the
        transition itself have to hold, and those of each that is declared before it must not. Where
        a function vanishes, the first of its derivatives along the flow of the named configuration
        that does not vanish decides. | The transitions have no further conditions.]

        @conditions
        """,
        positive=r",\; ".join(
            positive if len(positive) <= 3 else [positive[0], r"\ldots", positive[-1]]
        ),
        time=dwell[0] if single else r"\tau^{(k)}",
        single=single,
        label=cycle.label("Admissibility"),
        conditions=Table(("Transition", "Required", "Along"), tuple(rows)) if rows else [],
    )


def _conditions(cycle: Cycle, place: int, passing: Passing) -> list[tuple[str, ...]]:
    """Rows of a table with the conditions that decide for a transition."""
    transition = passing.transition
    required = [_required(cycle, (c,), holds=True) for c in transition.conditions]
    event = transition.source, transition.boundaries
    same = [t for t in cycle.system.transitions if (t.source, t.boundaries) == event]
    # those that are declared before it
    for other in same[: same.index(transition)]:
        distinct = tuple(c for c in other.conditions if c not in transition.conditions)
        if distinct:
            required.append(_required(cycle, distinct, holds=False))
    return [
        ("" if row else f"${place}$", *texts) for row, texts in enumerate(dict.fromkeys(required))
    ]


def _required(cycle: Cycle, conditions: tuple[Condition, ...], *, holds: bool) -> tuple[str, str]:
    """Text of conditions that all have to hold, or of which one must not, and along what."""
    texts = [
        f"{'not ' if c.holds != holds else ''}{math(cycle.naming, c.function, ' > 0')}"
        for c in conditions
    ]
    along = enumeration(list(dict.fromkeys(f"*{c.along}*" for c in conditions)))
    return " or ".join(texts), along
