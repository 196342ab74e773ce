"""The sections of a document on the reduction of an orbit's equations, and on their solution."""

from __future__ import annotations

from itertools import groupby

import sympy as sp

from nonsmooth.derive.document.blocks import Block, Formula, Line, Table
from nonsmooth.derive.document.cycle import Cycle
from nonsmooth.derive.document.sections.equations import cycle_end
from nonsmooth.derive.document.sections.template import compose, sentence
from nonsmooth.derive.document.view import View
from nonsmooth.derive.document.wording import Naming, count, enumeration
from nonsmooth.derive.equations.elimination import entry
from nonsmooth.derive.equations.explicit import LINEAR, RETURN
from nonsmooth.derive.equations.program import Stage
from nonsmooth.derive.equations.reduction import Elimination
from nonsmooth.derive.symbols import Symbol, inside, meaning_of


def reduction_section(view: View) -> list[Block]:
    """Blocks on what is eliminated along the chain, by which rule, and what remains."""
    equations, naming = view.equations, view.naming
    reduction = equations.reduction
    if reduction.equations == equations.equations and not reduction.eliminations:
        return compose(view, "Nothing is eliminated: Newton's method works on the equations above.")
    rows = [
        (", ".join(f"${naming.notation.symbol(e.unknown)}$" for e in found), naming.prose(rule))
        for rule, found in groupby(reduction.eliminations, lambda e: e.rule)
    ]
    others = [(s, e) for s, e in reduction.values.items() if s != e and s in equations.unknowns]
    phases = len(view.links)
    assigned = {s for stage in reduction.stages for s, _ in stage.assignments}
    return compose(
        view,
        r"""
        Whatever is linear or explicit is eliminated. The chain is followed from the phase with the
        smallest section, *@phase.configuration* (phase @place), and each switching condition is
        used as far as it goes, which leaves @left[reduction.unknowns: , @reduction.unknowns].

        @table

        [returns: A switching condition with one frequency and no drift has the form $a \cos\theta +
        b \sin\theta + c = 0$. That it rises through zero fixes the cosine and the sine of the angle
        $\theta = \omega\tau$; with $\operatorname{arg}$ in $@turn$ the dwell time is that of the
        first return.]

        @beyond

        @parts

        @stages

        [remaining: The reduced system has @remaining: | Nothing remains to be solved: the orbit is
        explicit.]

        @rest

        @roots

        [others: The unknowns that do not appear among the stages are]
        $$
        @others
        $$
        """,
        reduction=reduction,
        phase=view.itinerary.rotated(reduction.rotation).phases[0],
        place=reduction.rotation + 1,
        left=count(len(reduction.unknowns), "unknown"),
        table=Table(("Eliminated", "Rule"), tuple(rows), wrapped=1) if rows else [],
        returns=any(e.rule == RETURN for e in reduction.eliminations),
        turn=r"[0, 2\pi)",
        beyond=[
            block
            for k in range(phases + 1, 2 * phases)
            if assigned & {Symbol("state", s, k) for s in naming.system.states}
            for block in compose(
                view,
                "Behind the last phase the count goes on: $@state^{(@k)}$ is the state behind phase"
                " @before of the next period.",
                k=k,
                before=k - phases,
            )
        ],
        parts=_parts(view),
        stages=_stages(view),
        remaining=count(len(reduction.equations), "equation") if reduction.equations else "",
        rest=_rest(view),
        roots=_both_roots(view),
        others=[naming.equal(s, e) for s, e in others],
    )


def _rest(view: View) -> list[Formula]:
    """The equations of the reduced system as numbered formulas."""
    return view.numbered("The reduction", view.equations.reduction.equations)


def _both_roots(view: View) -> list[Block]:
    """Blocks with the roots of a quadratic reduced equation; none for another one."""
    reduction = view.equations.reduction
    if not reduction.roots:
        return []
    (unknown,), ((_, equation),) = reduction.unknowns, reduction.equations
    a, b, c = sp.Poly(sp.expand(equation), unknown).all_coeffs()
    poles = [d for d, _ in reduction.determinants]
    latex = view.naming.notation.latex
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
        unknown=view.naming.notation.symbol(unknown),
        half=latex(sp.factor_terms(-b / 2)),
        radicand=latex(sp.collect(sp.expand((b / 2) ** 2 - a * c), poles, sp.factor)),
        a=latex(a),
    )


def _parts(view: View) -> list[Block]:
    """Blocks on the meaning of bars, indices and numbers in brackets in the stages."""
    naming, reduction = view.naming, view.equations.reduction
    symbol = naming.notation.symbol
    assigned = [s for stage in reduction.stages for s, _ in stage.assignments]
    parts = [s for s in assigned if meaning_of(s) == "part"]
    of_start = next((s for s in reversed(parts) if s.parts[1] != 1), None)
    columns: list[sp.Symbol] = []
    left: list[str] = []
    right: list[str] = []
    if any(meaning_of(inside(s, "times", "without")) == "right" for s in assigned):
        rule = reduction.eliminations[-1].rule
        columns = [e.unknown for e in reduction.eliminations if e.rule == rule]
        kept = [u for u in reduction.unknowns if u in view.equations.chain.start.coordinates]
        matrix, side = map(naming.notation.letter, ("coefficient", "right"))
        left = [rf"{matrix}_{{i{j}}}\, {symbol(q)}" for j, q in enumerate(columns, start=1)]
        right = [f"{side}_{{i}}", *(f"{side}_{{i,{symbol(q)}}} {symbol(q)}" for q in kept)]
    return compose(
        view,
        r"""
        [bar: Given the dwell times, the states $@state^{(k)}$ are affine in the coordinates of the
        start. A bar marks their value where these coordinates are zero, and a coordinate as the
        last index, as in $@bar$, its coefficient.]

        [columns: The @many for @columns [many columns: are | is], in the order of the table,]
        $$
        [columns: @left &= @right]
        $$
        [columns: An entry that is a number, or one function or symbol, is not listed below, but
        stands where it is used. [steps: A number in square brackets counts the steps of
        elimination.]]
        """,
        bar=symbol(of_start) if of_start else "",
        columns=columns,
        many=count(len(columns), "linear equation"),
        left=" + ".join(left),
        right=" + ".join(right),
        steps=any(meaning_of(s) == "without" for s in assigned),
    )


def _stages(view: View) -> list[Block]:
    """Blocks with the stages of the reduction, each under its title."""
    naming, reduction = view.naming, view.equations.reduction
    chain = {a for s in view.equations.chain.stages for a in s.assignments}
    titles: list[tuple[str, list[tuple[sp.Symbol, sp.Expr]]]] = []
    for stage in reduction.stages:
        kept = [a for a in stage.assignments if a[0] not in naming.notation.functions]
        if titles and titles[-1][0] == stage.title:
            titles[-1][1].extend(kept)
        elif kept:
            titles.append((stage.title, kept))
    rules = {f"{e.unknown}: {e.rule}": e for e in reduction.eliminations}
    blocks: list[Block] = []
    for title, assignments in titles:
        known = all(a in chain for a in assignments)
        text = _introduced(naming, rules[title]) if title in rules else naming.prose(title)
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
            symbols=[s for s, _ in assignments],
            lines=[] if known else [naming.equal(s, e) for s, e in assignments],
        )
    return blocks


def _introduced(naming: Naming, elimination: Elimination) -> str:
    """Text that introduces the assignment by which an unknown was eliminated."""
    return sentence(
        naming,
        """
        [linear: The switching condition is linear in $@elimination.unknown$ | [returns: Hence
        $@elimination.unknown$, the first return | The condition of @boundary is linear in
        $@elimination.unknown$]]
        """,
        elimination=elimination,
        linear=elimination.rule == LINEAR,
        returns=elimination.rule == RETURN,
        boundary=naming.prose(elimination.rule.removeprefix("linear in ")),
    )


def solution_section(view: View) -> list[Block]:
    """Blocks on the conditions halfway, solved for the start, and the remaining equations."""
    naming, reduction = view.naming, view.equations.reduction
    coordinates = view.equations.chain.start.coordinates
    alone = _alone(view)
    one = len(reduction.equations) == 1
    poles = {d for d, _ in reduction.determinants}
    cleared = one and poles & reduction.equations[0][1].free_symbols
    return compose(
        view,
        """
        [alone: Given the dwell times, the equations are linear in @coordinates, and are solved for
        [many coordinates: them | it].]

        @alone

        @together

        [rest: There [one: remains | remain] @remaining for the dwell time[one: | s]
        @reduction.unknowns[cleared: : @label times $@pole$, which has no pole where $@pole$
        vanishes. A zero at which $@pole$ vanishes too may belong to no orbit]:]

        @rest

        @explicit
        """,
        reduction=reduction,
        alone=alone,
        coordinates=coordinates,
        together=_together(view),
        one=one,
        remaining=count(len(reduction.equations), "equation"),
        cleared=cleared,
        label=view.labels_of(reduction.equations[0][0]) if cleared else "",
        pole=naming.notation.symbol(next(iter(poles))) if poles else "",
        rest=_rest(view),
        explicit=[] if reduction.equations else _explicit(view),
    )


def _stage(view: View, title: str) -> Stage | None:
    return next((s for s in view.equations.reduction.stages if s.title.startswith(title)), None)


def _alone(view: View) -> list[Block]:
    """Blocks on coordinates that a single equation gives, with a constant coefficient."""
    blocks: list[Block] = []
    for elimination in view.equations.reduction.eliminations:
        symbol = elimination.unknown
        stage = _stage(view, f"{symbol}: ")
        if stage is not None:
            ((_, expression),) = stage.assignments
            blocks += compose(
                view,
                "Equation @where [blocks: then] gives\n$$\n@line\n$$",
                where=view.labels_of(elimination.rule.removeprefix("linear in: ")),
                blocks=blocks,
                line=view.naming.equal(symbol, expression),
            )
    return blocks


def _together(view: View) -> list[Block]:
    """Blocks on coordinates that several equations give together, by Cramer's rule."""
    naming, reduction = view.naming, view.equations.reduction
    if not reduction.determinants:
        return []
    coefficients = _stage(view, "coefficients of the linear equations")
    right = _stage(view, "right-hand sides of the linear equations")
    ((determinant, _),) = reduction.determinants
    together = [e for e in reduction.eliminations if _stage(view, f"{e.unknown}: ") is None]
    unknowns = [e.unknown for e in together]
    meanings = together[0].rule.removeprefix("linear in: ").split("; ")
    labels = [label for m in meanings for label in view.labels_of(m)]
    table = [naming.equal(s, e) for s, e in (coefficients.assignments if coefficients else ())]
    column = [naming.sum(s, e) for s, e in (right.assignments if right else ())]
    # an entry that is one function of time has no name
    named = len(table) == len(unknowns) ** 2 and len(column) == len(unknowns)
    titles = ("determinant of the linear", "numerators of", f"{', '.join(map(str, unknowns))} by")
    solved = [s for title in titles if (s := _stage(view, title)) is not None]
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
        labels=labels,
        unknowns=unknowns,
        entries=not named and (table or column),
        named=named,
        system=_system(naming, unknowns) if named else [],
        table=table if named else [*table, *column],
        column=column if named else [],
        solved=[naming.equal(s, e) for stage in solved for s, e in stage.assignments],
        determinant=determinant,
    )


def _system(naming: Naming, unknowns: list[sp.Symbol]) -> Line:
    """Line with the linear equations in the letters of their coefficients."""
    notation, size = naming.notation, len(unknowns)
    if size == 1:
        left = f"{notation.symbol(entry(0, 0, 1))}\\, {notation.symbol(unknowns[0])}"
        return Line(left, "=", (f"{notation.symbol(Symbol('right', 1))},",))
    table = sp.Matrix(size, size, lambda i, j: entry(i, j, size))
    right = sp.Matrix([Symbol("right", i + 1) for i in range(size)])
    left = f"{notation.latex(table)} {notation.latex(sp.Matrix(unknowns))}"
    return Line(left, "=", (f"{notation.latex(right)},",))


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
    notation, harmonics = cycle.naming.notation, cycle.harmonics
    several, based = cycle.count > 1, not cycle.start.constant.is_zero_matrix
    return compose(
        cycle,
        r"""
        Given the dwell times, one passage is an affine map of the start, $@ends = @passage
        @state^{(0)} + @remainder$, with
        $$
        @passage &= @product [resets: @reset_{@index} ]\Phi^{(@phase)},\qquad
        @remainder &= [several: \sum_{k=1}^{@count}
            \left(\prod_{i=@count}^{k+1} [resets: @reset_{@inner} ]\Phi^{(i)}\right)
            [resets: \left(@added\right) | @added] | @added],
        $$
        [several: the factors of later phases standing on the left. The | so that the] closure is
        linear in the start and determines it [directions: and $@shift$],
        $$
        \left(I - @embedding^{+} @passage @embedding\right) @letters.coordinates &= @embedding^{+}
            [enclosed: \left(@moved\right) | @moved].
        \tag{@label}
        $$
        What is left are the switching conditions (@conditions)[free: , as many as dwell times;
        | ;] Newton's method solves them from a guess, the start following the dwell times.

        [harmonics: The forcing is an exception: @oscillating oscillate by themselves, and nothing
        acts on them. They return after whole multiples of @periods alone, which fixes the sum of
        the dwell times, and then from every start: in (@label) their rows vanish. Of their start
        @kept [many harmonics: keep | keeps] the value that is given, the amplitude[many harmonics:
        s] of the forcing, and the phase[many harmonics: s] of it at the start [many harmonics: are
        unknowns | is an unknown] in place of the sum. The other rows of (@label) determine the
        other coordinates from these.]
        """,
        ends=cycle_end(cycle),
        several=several,
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
        label=cycle.label("The reduction"),
        conditions=cycle.label("The equations", 1),
        free=cycle.itinerary.period is None,
        oscillating=[s for h in harmonics for s in (h.first, h.second)],
        periods=enumeration([f"${notation.latex(2 * sp.pi / h.frequency)}$" for h in harmonics]),
        kept=enumeration([f"${notation.latex(h.invariant)}$" for h in harmonics]),
    )
