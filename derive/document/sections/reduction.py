"""The sections of a document on the solution of an orbit's equations, in three ways."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import groupby

import sympy as sp

from nonsmooth.derive.document.blocks import Block, Line
from nonsmooth.derive.document.notation import Notation
from nonsmooth.derive.document.template import compose, sentence
from nonsmooth.derive.document.view import Cycle, View, is_unit
from nonsmooth.derive.equations.elimination import entry
from nonsmooth.derive.equations.explicit import LINEAR, RETURN
from nonsmooth.derive.equations.period_map import PeriodMap
from nonsmooth.derive.equations.program import Stage
from nonsmooth.derive.equations.reduction import Elimination
from nonsmooth.derive.symbols import Symbol, inside, meaning_of

PERIOD_MAP = "The map of a period"


def reduction_section(view: View) -> list[Block]:
    """Blocks on what is eliminated along the chain, by which rule, and what remains."""
    equations, notation = view.equations, view.notation
    reduction = equations.reduction
    if reduction.equations == equations.equations and not reduction.eliminations:
        return compose(view, "Nothing is eliminated: Newton's method works on the equations above.")
    phases = len(view.links)
    assigned = {s for stage in reduction.stages for s, _ in stage.assignments}
    return compose(
        view,
        r"""
        Whatever is linear or explicit is eliminated. The chain is followed from the phase with the
        smallest section, *@configuration* (phase @place), and each switching condition is used as
        far as it goes, which leaves #reduction.unknowns unknown(s)[reduction.unknowns: ,
        @reduction.unknowns].

        | Eliminated | <Rule> | @eliminated

        [returns: A switching condition with one frequency and no drift has the form $a \cos\theta +
        b \sin\theta + c = 0$. That it rises through zero fixes the cosine and the sine of the angle
        $\theta = \omega\tau$; with $\operatorname{arg}$ in $@turn$ the dwell time is that of the
        first return.]

        @beyond

        @parts

        @stages

        [reduction.equations: The reduced system has #reduction.equations equation(s): | Nothing
        remains to be solved: the orbit is explicit.]

        @rest

        @roots

        [others: The unknowns that do not appear among the stages are]
        $$
        @others
        $$
        """,
        reduction=reduction,
        configuration=view.itinerary.rotated(reduction.rotation).phases[0].configuration,
        place=reduction.rotation + 1,
        eliminated=[
            (", ".join(notation.math(e.unknown) for e in found), notation.prose(rule))
            for rule, found in groupby(reduction.eliminations, lambda e: e.rule)
        ],
        returns=any(e.rule == RETURN for e in reduction.eliminations),
        turn=r"[0, 2\pi)",
        beyond=[
            block
            for k in range(phases + 1, 2 * phases)
            if assigned & {Symbol("state", s, k) for s in notation.system.states}
            for block in compose(
                view,
                "Behind the last phase the count goes on: $@state^{(@k)}$ is the state behind phase"
                " @before of the next period.",
                k=k,
                before=k - phases,
            )
        ],
        parts=_parts(view),
        stages=_stages(view, groupby(reduction.stages, lambda stage: stage.title)),
        rest=view.numbered("The reduction", reduction.equations),
        roots=_both_roots(view),
        others={s: e for s, e in reduction.values.items() if s != e and s in equations.unknowns},
    )


def _both_roots(view: View) -> list[Block]:
    """Blocks with the roots of a quadratic reduced equation; none for another one."""
    reduction = view.equations.reduction
    if not reduction.roots:
        return []
    (unknown,), ((_, equation),) = reduction.unknowns, reduction.equations
    a, b, c = sp.Poly(sp.expand(equation), unknown).all_coeffs()
    poles = [d for d, _ in reduction.determinants]
    latex = view.notation.latex
    return compose(
        view,
        r"""
        It is quadratic, so that the orbit is explicit: there are two of them where the radicand is
        positive, which meet in a fold where it vanishes, and none where it is negative. Which of
        the two is a motion of the system, admissibility decides:
        $$
        @unknown &= \frac{@half \pm \sqrt{@radicand}}{@a}.
        $$
        """,
        unknown=view.notation.symbol(unknown),
        half=latex(sp.factor_terms(-b / 2)),
        radicand=latex(sp.collect(sp.expand((b / 2) ** 2 - a * c), poles, sp.factor)),
        a=latex(a),
    )


def _parts(view: View) -> list[Block]:
    """Blocks on the meaning of bars, indices and numbers in brackets in the stages."""
    notation, reduction = view.notation, view.equations.reduction
    symbol = notation.symbol
    assigned = [s for stage in reduction.stages for s, _ in stage.assignments]
    of_start = [s for s in assigned if meaning_of(s) == "part" and s.parts[1] != 1]
    columns: list[sp.Symbol] = []
    left: list[str] = []
    right: list[str] = []
    if any(meaning_of(inside(s, "times", "without")) == "right" for s in assigned):
        rule = reduction.eliminations[-1].rule
        columns = [e.unknown for e in reduction.eliminations if e.rule == rule]
        kept = [u for u in reduction.unknowns if u in view.equations.chain.start.coordinates]
        matrix, side = map(notation.letter_for, ("coefficient", "right"))
        left = [rf"{matrix}_{{i{j}}}\, {symbol(q)}" for j, q in enumerate(columns, start=1)]
        right = [f"{side}_{{i}}", *(f"{side}_{{i,{symbol(q)}}} {symbol(q)}" for q in kept)]
    return compose(
        view,
        r"""
        [bar: Given the dwell times, the states $@state^{(k)}$ are affine in the coordinates of the
        start. A bar marks their value where these coordinates are zero, and a coordinate as the
        last index, as in $@bar$, its coefficient.]

        [columns: The #columns linear equation(s) for @columns [many columns: are | is], in the
        order of the table,]
        $$
        [columns: @left &= @right]
        $$
        [columns: An entry that is a number, or one function or symbol, is not listed below, but
        stands where it is used. [steps: A number in square brackets counts the steps of
        elimination.]]
        """,
        bar=of_start[-1] if of_start else None,
        columns=columns,
        left=" + ".join(left),
        right=" + ".join(right),
        steps=any(meaning_of(s) == "without" for s in assigned),
    )


def _stages(view: View, titled: Iterable[tuple[str, Iterable[Stage]]]) -> list[Block]:
    """Blocks with the stages of a computation under their titles."""
    notation, equations = view.notation, view.equations
    chain = {a for s in equations.chain.stages for a in s.assignments}
    rules = {f"{e.unknown}: {e.rule}": e for e in equations.reduction.eliminations}
    blocks: list[Block] = []
    for title, stages in titled:
        every = [a for stage in stages for a in stage.assignments]
        assignments = {s: e for s, e in every if s not in notation.functions}
        if assignments:
            text = _introduced(notation, rules[title]) if title in rules else notation.prose(title)
            known = assignments.items() <= chain
            blocks += compose(
                view,
                """
                @text: [known: @symbols as in the chain of states.]
                $$
                @lines
                $$
                """,
                text=text[:1].upper() + text[1:],
                known=known,
                symbols=list(assignments),
                lines={} if known else assignments,
            )
    return blocks


def _introduced(notation: Notation, elimination: Elimination) -> str:
    """Text that introduces the assignment by which an unknown was eliminated."""
    return sentence(
        notation,
        """
        [linear: The switching condition is linear in $@elimination.unknown$ | [returns: Hence
        $@elimination.unknown$, the first return | The condition of @boundary is linear in
        $@elimination.unknown$]]
        """,
        elimination=elimination,
        linear=elimination.rule == LINEAR,
        returns=elimination.rule == RETURN,
        boundary=notation.prose(elimination.rule.removeprefix("linear in ")),
    )


def solution_section(view: View) -> list[Block]:
    """Blocks on the conditions halfway, solved for the start, and the remaining equations."""
    reduction = view.equations.reduction
    coordinates = view.equations.chain.start.coordinates
    alone = _alone(view)
    poles = [d for d, _ in reduction.determinants]
    cleared = len(reduction.equations) == 1 and {*poles} & reduction.equations[0][1].free_symbols
    return compose(
        view,
        """
        [alone: Given the dwell times, the equations are linear in @coordinates, and are solved for
        [many coordinates: them | it].]

        @alone

        @together

        [rest: There [many rest: remain | remains] #rest equation(s) for the dwell time[many rest:
        s] @reduction.unknowns[cleared: : @label times $@poles$, which has no pole where $@poles$
        vanishes. A zero at which $@poles$ vanishes too may belong to no orbit]:]

        @rest

        @explicit
        """,
        reduction=reduction,
        alone=alone,
        coordinates=coordinates,
        together=_together(view),
        cleared=cleared,
        label=view.labels_of(reduction.equations[0][0]) if cleared else "",
        poles=poles,
        rest=view.numbered("The reduction", reduction.equations),
        explicit=[] if reduction.equations else _explicit(view),
    )


def _stage(view: View, title: str) -> Stage | None:
    return next((s for s in view.equations.reduction.stages if s.title.startswith(title)), None)


def _lines(view: View, title: str) -> list[Line]:
    """Lines of the stage whose title begins so; none if there is none."""
    stage = _stage(view, title)
    return [view.notation.relation(s, e) for s, e in stage.assignments] if stage else []


def _alone(view: View) -> list[Block]:
    """Blocks on coordinates that a single equation gives, with a constant coefficient."""
    blocks: list[Block] = []
    for elimination in view.equations.reduction.eliminations:
        lines = _lines(view, f"{elimination.unknown}: ")
        if lines:
            blocks += compose(
                view,
                "Equation @where [blocks: then] gives\n$$\n@lines\n$$",
                where=view.labels_of(elimination.rule.removeprefix("linear in: ")),
                blocks=blocks,
                lines=lines,
            )
    return blocks


def _together(view: View) -> list[Block]:
    """Blocks on coordinates that several equations give together, by Cramer's rule."""
    notation, reduction = view.notation, view.equations.reduction
    if not reduction.determinants:
        return []
    right = _stage(view, "right-hand sides of the linear equations")
    together = [e for e in reduction.eliminations if _stage(view, f"{e.unknown}: ") is None]
    unknowns = [e.unknown for e in together]
    meanings = together[0].rule.removeprefix("linear in: ").split("; ")
    table = _lines(view, "coefficients of the linear equations")
    column = [
        notation.relation(s, notation.signed(notation.by_function(e)), shows=e)
        for s, e in (right.assignments if right else ())
    ]
    # an entry that is one function of time has no name
    named = len(table) == len(unknowns) ** 2 and len(column) == len(unknowns)
    titles = ("determinant of the linear", "numerators of", f"{', '.join(map(str, unknowns))} by")
    return compose(
        view,
        """
        [alone: Equation[many labels: s] @labels [many labels: are | is] then | Given the dwell
        time[many links: s], equation[many labels: s] @labels [many labels: are | is]] linear in
        @unknowns, [entries: with]
        $$
        @system
        $$
        [named: with]
        $$
        @table
        $$
        [named: and]
        $$
        @column
        $$
        [many labels: By Cramer's rule | Hence]
        $$
        @solved
        $$
        [equations.reduction.equations: Where $@determinant$ vanishes the start is not determined:
        there is no such orbit, or a whole family of them.]
        """,
        alone=len(unknowns) < view.equations.chain.start.dimension,
        labels=[label for m in meanings for label in view.labels_of(m)],
        unknowns=unknowns,
        entries=not named and (table or column),
        named=named,
        system=_system(notation, unknowns) if named else [],
        table=table if named else [*table, *column],
        column=column if named else [],
        solved=[line for title in titles for line in _lines(view, title)],
        determinant=reduction.determinants[0][0],
    )


def _system(notation: Notation, unknowns: list[sp.Symbol]) -> Line:
    """Line with the linear equations in the letters of their coefficients."""
    size = len(unknowns)
    table = sp.Matrix(size, size, lambda i, j: entry(i, j, size))
    right = sp.Matrix([Symbol("right", i + 1) for i in range(size)])
    left, column = notation.latex(table), notation.latex(sp.Matrix(unknowns))
    thin = "\\," if size == 1 else ""
    return notation.relation(f"{left}{thin} {column}", notation.latex(right), ",")


def _explicit(view: View) -> list[Block]:
    """Blocks on a start for which nothing remains to be solved."""
    determinants = [d for d, _ in view.equations.reduction.determinants]
    return compose(
        view,
        """
        Nothing remains to be solved: the orbit is explicit. [inside: The phase begins on its own
        boundary, and leads inside only where $@inside < 0$: elsewhere this is no motion of the
        system.]

        [singular: The zeros of @determinants are the singular periods: at such a $@period.symbol$
        there is no orbit of this kind, or, where the numerators vanish with it, a family of them.]
        """,
        inside=_inward_rate(view),
        determinants=determinants,
        singular=determinants and view.itinerary.period,
        period=view.itinerary.period,
    )


def _inward_rate(view: View) -> sp.Symbol | None:
    """Rate of the boundary at the start of an orbit of one phase that begins on it; or None."""
    if len(view.links) > 1:
        return None
    (link,), start = view.links, view.equations.chain.start.state
    rate = sp.expand((link.normal * link.flow.velocity(start))[0])
    begins = sp.expand(link.value(start)) == 0
    return rate if begins and rate.is_Symbol else None


def elimination_section(cycle: Cycle) -> list[Block]:
    """Blocks on the start as the solution of a linear system, given the dwell times."""
    harmonics, based = cycle.harmonics, not cycle.start.constant.is_zero_matrix
    return compose(
        cycle,
        r"""
        Given the dwell times, one passage is an affine map of the start, $@end = @passage
        @state^{(0)} + @remainder$, with
        $$
        @passage &= @product [resets: @reset_{@index} ]\Phi^{(@phase)},\qquad
        @remainder &= [many count: \sum_{k=1}^{@count}
            \left(\prod_{i=@count}^{k+1} [resets: @reset_{@inner} ]\Phi^{(i)}\right)
            [resets: \left(@added\right) | @added] | @added],
        $$
        [many count: the factors of later phases standing on the left. The | so that the] closure is
        linear in the start and determines it [directions: and $@shift$],
        $$
        \left(I - @embedding^{+} @passage @embedding\right) @letters.coordinates &= @embedding^{+}
            [enclosed: \left(@moved\right) | @moved].
        \tag{@label(The reduction 1)}
        $$
        What is left are the switching conditions (@label(The equations 2))[free: , as many as dwell
        times; | ;] Newton's method solves them from a guess, the start following the dwell times.

        [harmonics: The forcing is an exception: @oscillating oscillate by themselves, and nothing
        acts on them. They return after whole multiples of $@periods$ alone, which fixes the sum of
        the dwell times, and then from every start: in (@label(The reduction 1)) their rows vanish.
        Of their start $@kept$ [many harmonics: keep | keeps] the value that is given, the
        amplitude[many harmonics: s] of the forcing, and the phase[many harmonics: s] of it at the
        start [many harmonics: are unknowns | is an unknown] in place of the sum. The other rows of
        (@label(The reduction 1)) determine the other coordinates from these.]
        """,
        inner=cycle.index.replace("k", "i"),
        added=sentence(
            cycle,
            "[resets: @reset_{@index} ]@forcing^{(@phase)}[resets:  + @jump_{@index}]",
        ),
        moved=sentence(
            cycle,
            "[based: @passage @base + ]@remainder[directions:  - @letters.directions @shift]",
            based=based,
        ),
        enclosed=based or cycle.directions,
        free=cycle.itinerary.period is None,
        oscillating=[s for h in harmonics for s in (h.first, h.second)],
        periods=[2 * sp.pi / h.frequency for h in harmonics],
        kept=[h.invariant for h in harmonics],
    )


def period_map_section(view: View) -> list[Block]:
    """Blocks on N in blocks, the start that it gives, and the equations that it leaves."""
    notation, turn = view.notation, view.equations.period_map
    sought, known = ([turn.start[i] for i in p] for p in (turn.sought, turn.known))
    # positions and velocities where masses stick
    letter = notation.letter if notation.second_order else notation.state.lower()
    assigned = [a for stage in turn.start_stages for a in stage.assignments]
    numerators = {s: e for s, e in assigned if meaning_of(s) == "numerator"}
    # what the section knows does not depend on what is sought, and no offset occurs
    symbols = set().union(*(entry.free_symbols for entry in known))
    linear = turn.offset.is_zero_matrix is True
    separate = linear and not set(sought) & symbols
    labels = [f"({view.label(f'The equations {k + 1}')})" for k in range(view.count)]
    left = [label for k, label in enumerate(labels) if k not in turn.contained]
    square = turn.compatibility and separate and len(known) == len(sought)
    return compose(
        view,
        r"""
        The equations can be taken in another order, that of the Appendix of Pascal (2011). Given
        the dwell times a whole turn is [linear: a linear | an affine] map of the start. Of its
        entries $@letter_{0}$ is sought, and $@letter_{0}'$ is what the section knows:
        $$
        @groups
        $$
        The map has four blocks. [dropped: A reset that only states that its boundary is reached is
        left out.]
        $$
        @state^{(@count)} &= \tilde N @state^{(0)}[linear: |  + c],
        \tilde N &= @product
            = \left(\begin{matrix}@rows\end{matrix}\right)
        $$
        Periodicity reads@cited(turn):
        $$
        (\tilde N_{1} - I) @letter_{0} + \tilde N_{2} @letter_{0}'[linear: |  + c_{1}] = 0,
        \tilde N_{3} @letter_{0} + (\tilde N_{4} - I) @letter_{0}'[linear: |  + c_{2}] = 0.
        $$
        Its entries are the derivatives of the state behind the last phase by the start, at given
        dwell times. Each phase carries them as it carries the state; one that is a number, a dwell
        time or the same as another has no line of its own.

        @stages

        So the blocks are
        $$
        @blocks
        $$
        The first condition is linear in @sought and gives the start[separate: @cited(linear
        start)]:
        $$
        [separate: @letter_{0} &= -(\tilde N_{1} - I)^{-1} \tilde N_{2} @letter_{0}',]
        $$
        [separate: which is, entry by entry,]
        $$
        @start
        $$
        [compatibility: With this start the second becomes the compatibility condition[many
        compatibility: s] on the dwell times. It contains equation[many contained: s] @contained,
        from which the section knows $@letter_{0}'$:]

        @compatibility

        [square: Where $\tilde N_{3}$ is nonsingular these read@cited(compatibility):]
        $$
        [square: \tilde M @letter_{0}' &= 0,
        \tilde M &= (\tilde N_{1} - I)^{-1} \tilde N_{2} - \tilde N_{3}^{-1} (\tilde N_{4} - I).]
        $$
        [equal: Since the entries of $@letter_{0}'$ are equal, the rows of $\tilde M$ then sum to
        zero.]

        [left: With @left, for the same start, there | There] are #together equation(s) for
        @unknowns.
        """,
        linear=linear,
        rows=r"\tilde N_{1} & \tilde N_{2}\\\tilde N_{3} & \tilde N_{4}",
        letter=letter,
        groups={
            f"{letter}_{{0}}": _shown(sp.Matrix(sought)),
            f"{letter}_{{0}}'": _shown(sp.Matrix(known)),
        },
        dropped=any(
            k not in turn.resets and not is_unit(link) for k, link in enumerate(view.links)
        ),
        product=_product(view, turn),
        stages=_stages(view, ((stage.title, (stage,)) for stage in turn.map_stages)),
        blocks=_blocks(view, turn),
        sought=sought,
        separate=separate,
        start={s: e.xreplace(numerators) for s, e in assigned if s not in numerators},
        compatibility=view.numbered(PERIOD_MAP, turn.compatibility),
        contained=[labels[k] for k in turn.contained],
        square=square,
        equal=square and len(set(known)) == 1,
        left=left,
        together=len(turn.compatibility) + len(left),
        unknowns=turn.unknowns,
    )


def _product(view: View, turn: PeriodMap) -> str:
    """LaTeX of the product of flows and resets, the first phase on the right."""
    notation, factors = view.notation, []
    for k, link in enumerate(view.links):
        if link.duration != 0:
            number, dwell = (
                notation.flow_number(link.flow.configuration),
                notation.symbol(link.dwell),
            )
            factors.append(rf"\Phi_{{{number}}}({dwell})")
        if k in turn.resets:
            factors.append(f"R_{{{k + 1}}}")
    return r" \, ".join(reversed(factors))


def _blocks(view: View, turn: PeriodMap) -> list[Line]:
    """Lines with the blocks of N and of its offset."""
    named = {rf"\tilde N_{{{i}}}": block for i, block in enumerate(turn.blocks, start=1)}
    if not turn.offset.is_zero_matrix:
        named |= {
            f"c_{{{i}}}": turn.offset.extract(list(places), [0])
            for i, places in enumerate((turn.sought, turn.known), start=1)
        }
    latex = view.notation.latex
    return [view.notation.relation(n, latex(m), shows=_shown(m)) for n, m in named.items()]


def _shown(block: sp.Matrix) -> sp.Basic:
    """A matrix as a line shows it: a single entry is written alone."""
    return block[0] if len(block) == 1 else block
