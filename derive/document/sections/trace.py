"""The sections of a document on energy, on the trace, on stability, and on the reference orbit."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from nonsmooth.derive.declaration.algebra import factor
from nonsmooth.derive.declaration.dynamics import SecondOrder
from nonsmooth.derive.declaration.fields import exact
from nonsmooth.derive.document.blocks import Block, Line
from nonsmooth.derive.document.printer import add_product
from nonsmooth.derive.document.symbols import grouped_by
from nonsmooth.derive.document.template import compose
from nonsmooth.derive.document.view import View
from nonsmooth.derive.equations.energy import on_boundary
from nonsmooth.derive.equations.program import Stage
from nonsmooth.derive.equations.reference import ReferenceOrbit
from nonsmooth.derive.equations.section import passages_of
from nonsmooth.derive.symbols import Symbol, parts_of_derivative

_DIGITS = 12
_LARGEST = 3  # map that is shown as a matrix
_ZERO = sp.Float("1e-20")
# more products of functions of time are not written out
_MOST_TERMS = 12
# a factor of more terms gets a letter
_LONG = 3


def energy_section(view: View) -> list[Block]:
    """Blocks on the energy of each configuration, its changes, and the multiplier 1."""
    notation = view.notation
    energies = {name: _energy(view, name) for name in notation.names}
    totals = {name: sp.Add(*terms) for name, terms in energies.items()}
    return compose(
        view,
        r"""
        No coordinate is held, nothing damps, and the matrices are symmetric: inside [many energies:
        each configuration the energy is constant. With its constant chosen for each configuration,
        | the configuration the energy is constant,]
        $$
        @lines
        $$
        @changes

        Energy is a first integral, on the orbit and on every motion near it: its gradient at
        $@state^{(0)}$ is a left eigenvector of $\mathcal{M}$ to the eigenvalue 1, orthogonal to the
        right eigenvector $f_{0}^{+}$. So 1 is an eigenvalue of $\mathcal{M}$ at least twice, and of
        $J$ at least once: the trivial multiplier of the family of orbits in which the energy
        varies.
        """,
        energies=energies,
        lines=[
            notation.relation(f"2 {_letter(name)}", notation.signed(terms), shows=totals[name])
            for name, terms in energies.items()
        ],
        changes=_changes(view, {name: total / 2 for name, total in totals.items()}),
    )


def _letter(name: str) -> str:
    return rf"E_{{\text{{{name}}}}}"


def _energy(view: View, name: str) -> list[sp.Expr]:
    """Terms of twice the energy as squares, up to a constant: masses, springs, grounds."""
    system = view.notation.system
    dynamics = system.configuration(name).dynamics
    assert isinstance(dynamics, SecondOrder)  # else no energy is kept
    size = dynamics.mass.rows
    x, v = system.states[:size], system.states[size:]
    stiffness, load = dynamics.stiffness, dynamics.load
    pairs = [(i, j) for i in range(size) for j in range(i, size)]
    terms = [dynamics.mass[i, j] * v[i] * v[j] * (1 if i == j else 2) for i, j in pairs]
    terms += [-stiffness[i, j] * (x[i] - x[j]) ** 2 for i, j in pairs if i != j]
    for i in range(size):
        ground = sp.factor(sum(stiffness[i, :]))
        if ground != 0:
            terms.append(ground * (x[i] - sp.cancel(load[i] / ground)) ** 2)
        else:
            terms.append(-2 * load[i] * x[i])
    return [t for t in terms if t != 0]


def _changes(view: View, energies: dict[str, sp.Expr]) -> list[Block]:
    """Blocks on the change of energy by each transition."""
    itinerary, system, _ = view.undecided
    notation, states = view.notation, system.states
    lines: list[Line] = []
    places: list[str] = []
    continuous: list[str] = []
    for passage in passages_of(itinerary):
        before, target = passage.configuration.name, passage.transition.target
        image = passage.behind(sp.Matrix(states))
        behind = energies[target].subs(dict(zip(states, image, strict=True)), simultaneous=True)
        change = sp.expand(behind - energies[before])
        change = min(sp.factor(change), sp.factor_terms(change), key=sp.count_ops)
        if change == 0:
            continuous.append(passage.boundary)
            continue
        ((fixed, value),) = on_boundary(passage).items()
        places.append(f"${notation.symbol(fixed)} = {notation.latex(value)}$")
        left = f"{_letter(target)}^{{+}} - {_letter(before)}"
        lines.append(notation.relation(left, notation.latex(change), ",", shows=change))
    return compose(
        view,
        """
        [lines: At the [many lines: transitions | transition] it changes by]
        $$
        @lines
        $$
        [lines: which is zero [equations.required: with $@equations.required$ | on the boundary
        @places].]

        [continuous: At *@continuous* it does not change.]
        """,
        lines=lines,
        places=list(dict.fromkeys(places)),
        continuous=continuous,
    )


def trace_section(view: View) -> list[Block]:
    """Blocks on the trace, in closed form where the rank is one, and on stability."""
    reduction, conservative = view.equations.reduction, view.equations.conservative
    size, several = (
        len(view.equations.chain.coordinates),
        reduction.rank > 1 and not reduction.image,
    )
    if conservative and reduction.rank:
        return _conservative(view)
    return compose(
        view,
        r"""
        @trace

        [single: The orbit is stable, for perturbations that keep its itinerary, if
        $|\operatorname{tr} J| < 1$@cited(trace). [sides: The itinerary is kept where $@sides > 0$
        on the perturbed motion; on the other side of the collision another map holds, and this
        trace says nothing about it.]]

        [point: The orbit passes through a section that is a point. No perturbation passes it: $J =
        0$, $\operatorname{tr} J = 0$, and the orbit is stable for perturbations that keep its
        itinerary.]

        [two: Two multipliers can differ from zero, and $|\operatorname{tr} J| < 1$ does not decide.
        Both lie inside the unit circle, and the orbit is stable for perturbations that keep its
        itinerary, exactly where]
        $$
        [two: |\operatorname{tr} J| < 1 + \det J,\qquad
            \det J < 1.]
        $$
        [more: $|\operatorname{tr} J| < 1$ does not decide: the orbit is stable, for perturbations
        that keep its itinerary, where all multipliers, the eigenvalues of $J$, lie inside the unit
        circle.]
        """,
        trace=_slope(view) if reduction.image else _sum(view) if reduction.rank else [],
        single=reduction.rank > 0 and not several,
        sides=[link.dwell for link in view.links if link.duration == 0],
        point=reduction.rank == 0,
        two=several and size == 2,
        more=several and size > 2,
    )


def _sum(view: View) -> list[Block]:
    """Blocks on the trace as a sum of diagonal entries, and the number of multipliers."""
    equations, phases = view.equations, view.itinerary.phases
    rank, size = equations.reduction.rank, len(equations.chain.coordinates)
    *terms, last = (f"{'+ ' if i > 1 else ''}J_{{{i}{i}}}" for i in range(1, size + 1))
    return compose(
        view,
        r"""
        $J$ is a [many size: matrix of #size rows, for the coordinates | number, for the coordinate]
        @map_coordinates. [less: The orbit passes through a section of dimension #rank, at the start
        of *@phase.configuration*, so that at most #rank multiplier(s) [many rank: differ | differs]
        from zero.] The trace of $J$ is computed by the local maps,
        $$
        \operatorname{tr} J &= @diagonal
        $$
        """,
        size=size,
        less=rank < size,
        rank=rank,
        phase=phases[equations.reduction.rotation % len(phases)],
        diagonal=(*terms, f"{last}."),
    )


def _conservative(view: View) -> list[Block]:
    """Blocks on the trivial multiplier, and on the pair that the monodromy's trace gives."""
    if not view.equations.reciprocal_pair:
        return compose(
            view,
            """
            @sum

            One multiplier is the trivial 1 of the energy. The orbit is stable where all others lie
            inside the unit circle, neutral where they lie on it, and unstable where one lies
            outside.
            """,
            sum=_sum(view),
        )
    return compose(
        view,
        r"""
        The flows keep volumes of the state space, and $\det S_{k} = 1$: hence $\det \mathcal{M} =
        1$. Two eigenvalues of $\mathcal{M}$ are 1, so that the other two are $\mu$ and $1/\mu$.
        They are the nontrivial multipliers, and follow from
        $$
        \mu + \frac{1}{\mu} &= \operatorname{tr} J - 1
            = \operatorname{tr} \mathcal{M} - 2,
        \mu &= \frac{s}{2} \pm \sqrt{\frac{s^{2}}{4} - 1},\qquad
            s = \operatorname{tr} \mathcal{M} - 2.
        $$
        [trace: Written out, with the switching conditions inserted,]
        $$
        @trace
        [trace: \tag{@label(The trace 1)}]
        $$
        Where $|\operatorname{tr} \mathcal{M} - 2| < 2$ the pair lies on the unit circle and the
        orbit is neutral. Where $|\operatorname{tr} \mathcal{M} - 2| > 2$ it is real, one of the two
        lies outside, and the orbit is unstable. It is the trace that decides: on the circle $|\mu|
        = 1$ leaves nothing to compare, and the double eigenvalue 1, which has one eigenvector only,
        costs the eigenvalues of $\mathcal{M}$ half their digits.
        """,
        trace=_monodromy_trace(view),
    )


def _monodromy_trace(view: View) -> list[Line]:
    """Lines for the trace of the monodromy matrix in functions of the dwell times.

    Long factors in it have lines of their own. There are none if it is too long.
    """
    notation, names = view.notation, dict[sp.Symbol, sp.Expr]()
    product = sp.eye(len(notation.system.states))
    for index, (link, matrix) in enumerate(zip(view.links, view.saltations, strict=True), 1):
        named = matrix.as_mutable()
        for i in range(matrix.rows):
            for j in range(matrix.cols):
                if not matrix[i, j].is_number:
                    latex = rf"\left(S_{{{index}}}\right)_{{{i + 1}{j + 1}}}"
                    symbol = Symbol("written", f"saltation_{index}_{i}{j}", latex)
                    named[i, j], names[symbol] = symbol, matrix[i, j]
        product = named * link.transfer * product
    total = sp.expand(product.trace())
    functions = [s for s in total.free_symbols if notation.is_function(s)]
    collected = grouped_by(total, [*functions, *names])
    if len(collected) > _MOST_TERMS:
        return []
    order = {s: i for i, s in enumerate((*notation.functions, *names))}
    flows = notation.flows.values()
    frequencies = {s for flow in flows for g in flow.basis for s in g.free_symbols}
    entries = {s for flow in flows for m in flow.matrices for s in m.free_symbols}
    projectors = {*notation.spectrum.symbols} & entries - frequencies
    # functions with one coefficient, but for frequencies, share it
    groups: dict[sp.Expr, sp.Expr] = {}
    for monomial in sorted(collected, key=lambda m: sorted(order[s] for s in m.free_symbols)):
        entry, function = monomial.as_independent(*functions, as_Add=False)
        inner, outer = factor(collected[monomial]).as_independent(*projectors, as_Add=False)
        add_product(groups, outer * entry, inner * function)
    long = [outer for outer in groups if len(sp.Add.make_args(outer)) > _LONG]
    letters = {k: Symbol("written", f"kappa{i}", rf"\kappa_{{{i}}}") for i, k in enumerate(long, 1)}
    terms = [
        sp.Mul(letters.get(outer, outer), sp.factor_terms(inner)) for outer, inner in groups.items()
    ]
    written = {letter: k for k, letter in letters.items()}
    total = sp.Add(*terms).xreplace(written).xreplace(names)
    return [
        notation.relation(r"\operatorname{tr} \mathcal{M}", notation.signed(terms), shows=total),
        *(notation.relation(letter, k) for letter, k in written.items()),
    ]


def _slope(view: View) -> list[Block]:
    """Blocks on the trace as the slope of the map in one variable."""
    reduction, symbol = view.equations.reduction, view.notation.symbol
    first, *others = reduction.unknowns
    x = symbol(first)
    stages, trace = view.equations.trace_program
    return compose(
        view,
        r"""
        The section at the start of the reduction has one coordinate, $q = @start$. The Poincaré map
        therefore has rank one: its only multiplier that can differ from zero is the slope of the
        map in one variable
        $$
        q &= @start
        Q &= @reduction.image
        $$
        Both are functions of $@x$, [others: since @others [many others: follow | follows] from
        @where, here $F = 0$. By implicit differentiation, with $y = @y$, | so that]
        $$
        \operatorname{tr} J &= \frac{\mathrm{d} Q}{\mathrm{d} q}
            = \frac{\partial_{@x} Q[others: @implicit]}{\partial_{@x} q}.
        $$
        In the symbols of the stages this reads
        $$
        \operatorname{tr} J &= @trace
        \tag{@label(The trace 1)}
        $$
        @derivatives
        """,
        implicit=rf" - \partial_{{y}} Q\, \left(\partial_{{y}} F\right)^{{-1}} \partial_{{{x}}} F",
        reduction=reduction,
        start=symbol(reduction.start),
        x=x,
        others=others,
        where=[f"({view.label(f'The reduction {i}')})" for i, _ in enumerate(others, start=1)],
        y=", ".join(map(symbol, others)),
        trace=trace,
        derivatives=_derivatives(view, stages),
    )


def _derivatives(view: View, stages: Sequence[Stage]) -> list[Block]:
    """Blocks with the derivatives along the stages, direction by direction."""
    notation, reduction = view.notation, view.equations.reduction
    directions = reduction.unknowns
    base = {s for stage in reduction.stages for s, _ in stage.assignments}
    named = {e: s for s, e in notation.functions.items()}
    inlined: dict[sp.Symbol, sp.Expr] = {}
    groups: dict[sp.Symbol | None, dict[sp.Symbol, sp.Expr]]
    groups = {d: {} for d in (*directions, None)}
    for stage in stages:
        for symbol, expression in stage.assignments:
            if symbol in base:
                continue
            inner, direction = parts_of_derivative(symbol)
            if inner in notation.functions:
                # the derivative of a cosine needs no symbol on paper
                inlined[symbol] = expression.xreplace(named)
                continue
            group = direction if direction in groups else None
            groups[group][symbol] = expression.xreplace(inlined)
    blocks: list[Block] = []
    for direction, assignments in groups.items():
        if assignments:
            blocks += compose(
                notation,
                """
                [by: The derivatives by $@by$ [fixed: at fixed @fixed] | Further], stage by stage:
                $$
                @lines
                $$
                """,
                by=direction,
                fixed=[d for d in directions if d != direction],
                lines=assignments,
            )
    return blocks


def reference_section(view: View, orbit: ReferenceOrbit) -> list[Block]:
    """Blocks on the reference's parameters, the unknowns, the period and the multipliers."""
    equations, notation, reference = view.equations, view.notation, view.itinerary.reference
    assert reference is not None  # the orbit is solved from it
    texts = {p: reference.parameters[str(p)] for p in equations.parameters}
    values = zip(equations.unknowns, orbit.unknowns, strict=True)
    size = orbit.map.rows
    rows = (" & ".join(map(_number, orbit.map.row(i))) for i in range(size))
    return compose(
        view,
        r"""
        With $@given$[cited: @cited,] the equations have the solution
        $$
        @unknowns
        $$
        It has
        $$
        \text{period} &= @period
        \operatorname{tr} J &= @trace
        [shown: J &= \left(\begin{matrix}@rows\end{matrix}\right)]
        $$
        [size: and the multiplier[many multipliers: s] $@multipliers$.]
        """,
        # decimals stay as they are declared
        given={p: x if x[-1].isdigit() else notation.latex(exact(x)) for p, x in texts.items()},
        cited=notation.cited("reference"),
        unknowns={notation.symbol(u): _number(value) for u, value in values},
        period=_number(orbit.period),
        trace=_number(orbit.map.trace()),
        shown=1 < size <= _LARGEST,
        rows=r"\\".join(rows),
        size=size,
        multipliers=list(map(_number, orbit.multipliers)),
    )


def _number(value: sp.Expr) -> str:
    """LaTeX of a number, rounded; what is zero up to its rounding is zero."""
    real, imaginary = (
        sp.latex(part.evalf(_DIGITS)) if abs(part) > _ZERO else "" for part in value.as_real_imag()
    )
    if not imaginary:
        return real or "0"
    sign = "-" if imaginary.startswith("-") else "+" if real else ""
    return rf"{real} {sign} {imaginary.lstrip('-')}\,\mathrm{{i}}".strip()
