"""The sections of a document on energy, on the trace, on stability, and on the reference orbit."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from nonsmooth.derive.declaration.dynamics import SecondOrder
from nonsmooth.derive.declaration.fields import exact
from nonsmooth.derive.document.blocks import Block, Line
from nonsmooth.derive.document.sections.template import compose, zeros
from nonsmooth.derive.document.view import View, monodromy_trace
from nonsmooth.derive.document.wording import Naming, count, number
from nonsmooth.derive.equations.energy import on_boundary
from nonsmooth.derive.equations.program import Stage
from nonsmooth.derive.equations.reference import ReferenceOrbit
from nonsmooth.derive.equations.section import passages_of
from nonsmooth.derive.symbols import parts_of_derivative

_DIGITS = 12
_LARGEST = 3  # map that is shown as a matrix
_ZERO = sp.Float("1e-20")


def energy_section(view: View) -> list[Block]:
    """Blocks on the energy of each configuration, its changes, and the multiplier 1."""
    energies = {name: _energy(view, name) for name in view.flows}
    halves = {name: sp.Add(*terms) / 2 for name, terms in energies.items()}
    return compose(
        view,
        r"""
        No coordinate is held, nothing damps, and the matrices are symmetric: inside [many energies:
        each configuration the energy is constant. With its constant chosen for each configuration,
        | the configuration the energy is constant,]
        $$
        @energies
        $$
        @changes

        Energy is a first integral, on the orbit and on every motion near it: its gradient at
        $@state^{(0)}$ is a left eigenvector of $\mathcal{M}$ to the eigenvalue 1, orthogonal to the
        right eigenvector $f_{0}^{+}$. So 1 is an eigenvalue of $\mathcal{M}$ at least twice, and of
        $J$ at least once: the trivial multiplier of the family of orbits in which the energy
        varies.
        """,
        energies=[
            Line(
                f"2 {_letter(name)}",
                "=",
                view.naming.notation.signed(terms),
                None,
                sp.Add(*terms),
            )
            for name, terms in energies.items()
        ],
        changes=_changes(view, halves),
    )


def _letter(name: str) -> str:
    return rf"E_{{\text{{{name}}}}}"


def _energy(view: View, name: str) -> list[sp.Expr]:
    """Terms of twice the energy as squares, up to a constant: masses, springs, grounds."""
    system = view.naming.system
    dynamics = system.configuration(name).dynamics
    if not isinstance(dynamics, SecondOrder):
        raise TypeError(f"{name} is no second-order motion")
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
    notation, states, required = view.naming.notation, system.states, view.equations.required
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
            continuous.append(f"*{passage.boundary}*")
            continue
        ((fixed, value),) = on_boundary(passage).items()
        places.append(f"${notation.symbol(fixed)} = {notation.latex(value)}$")
        left = f"{_letter(target)}^{{+}} - {_letter(before)}"
        lines.append(Line(left, "=", (f"{notation.latex(change)},",), None, change))
    return compose(
        view,
        """
        [lines: At the [many lines: transitions | transition] it changes by]
        $$
        @lines
        $$
        [lines: which is zero [required: with @required | on the boundary @places].]

        [continuous: At @continuous it does not change.]
        """,
        lines=lines,
        required=[f"${notation.symbol(p)} = {notation.latex(v)}$" for p, v in required.items()],
        places=list(dict.fromkeys(places)),
        continuous=continuous,
    )


def trace_section(view: View) -> list[Block]:
    """Blocks on the trace, in closed form where the rank is one, and on stability."""
    reduction, conservative = view.equations.reduction, view.equations.conservative
    at_once = [link.dwell for link in view.links if link.duration == 0]
    several = reduction.rank > 1 and reduction.image is None
    if conservative and reduction.rank:
        return _conservative(view)
    return compose(
        view,
        r"""
        @trace

        [single: The orbit is stable, for perturbations that keep its itinerary, if
        $|\operatorname{tr} J| < 1$@cited. [sides: The itinerary is kept where @sides on the
        perturbed motion; on the other side of the collision another map holds, and this trace says
        nothing about it.]]

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
        cited=view.naming.cited("trace"),
        sides=zeros(view.naming, at_once, " > 0"),
        point=reduction.rank == 0,
        two=several and len(view.equations.chain.coordinates) == 2,
        more=several and len(view.equations.chain.coordinates) > 2,
    )


def _sum(view: View) -> list[Block]:
    """Blocks on the trace as a sum of diagonal entries, and the number of multipliers."""
    equations, phases = view.equations, view.itinerary.phases
    rank, size = equations.reduction.rank, len(equations.chain.coordinates)
    *terms, last = (f"{'+ ' if i > 1 else ''}J_{{{i}{i}}}" for i in range(1, size + 1))
    return compose(
        view,
        r"""
        $J$ is a [several: matrix of @size rows, for the coordinates | number, for the coordinate]
        @map_coordinates. [less: The orbit passes through a section of dimension @rank, at the start
        of *@phase.configuration*, so that at most @multipliers [one: differs | differ] from zero.]
        The trace of $J$ is computed by the local maps,
        $$
        \operatorname{tr} J &= @diagonal
        $$
        """,
        several=size > 1,
        size=number(size),
        less=rank < size,
        rank=number(rank),
        phase=phases[equations.reduction.rotation % len(phases)],
        multipliers=count(rank, "multiplier"),
        one=rank == 1,
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
    notation, found = view.naming.notation, monodromy_trace(view)
    trace: list[Line] = []
    if found:
        total = sp.Add(*found.terms).xreplace(found.factors).xreplace(found.names)
        pieces = notation.signed(found.terms)
        trace = [Line(r"\operatorname{tr} \mathcal{M}", "=", pieces, None, total)]
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
        @factors
        [trace: \tag{@label}]
        $$
        Where $|\operatorname{tr} \mathcal{M} - 2| < 2$ the pair lies on the unit circle and the
        orbit is neutral. Where $|\operatorname{tr} \mathcal{M} - 2| > 2$ it is real, one of the two
        lies outside, and the orbit is unstable. It is the trace that decides: on the circle $|\mu|
        = 1$ leaves nothing to compare, and the double eigenvalue 1, which has one eigenvector only,
        costs the eigenvalues of $\mathcal{M}$ half their digits.
        """,
        trace=trace,
        factors=[view.naming.equal(s, e) for s, e in found.factors.items()] if found else [],
        label=view.label("The trace"),
    )


def _slope(view: View) -> list[Block]:
    """Blocks on the trace as the slope of the map in one variable."""
    reduction = view.equations.reduction
    symbol = view.naming.notation.symbol
    first, *others = reduction.unknowns
    x = symbol(first)
    stages, trace = view.equations.trace_program
    base = {s for stage in reduction.stages for s, _ in stage.assignments}
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
        \tag{@label}
        $$
        @derivatives
        """,
        implicit=rf" - \partial_{{y}} Q\, \left(\partial_{{y}} F\right)^{{-1}} \partial_{{{x}}} F",
        reduction=reduction,
        start=symbol(reduction.start),
        x=x,
        others=others,
        where=[f"({view.label('The reduction', i)})" for i in range(len(others))],
        y=", ".join(map(symbol, others)),
        trace=trace,
        label=view.label("The trace"),
        derivatives=_derivatives(view.naming, stages, base, reduction.unknowns),
    )


def _derivatives(
    naming: Naming, stages: Sequence[Stage], base: set[sp.Symbol], directions: Sequence[sp.Symbol]
) -> list[Block]:
    """Blocks with the derivatives along the stages, direction by direction."""
    named = {e: s for s, e in naming.notation.functions.items()}
    inlined: dict[sp.Symbol, sp.Expr] = {}
    groups: dict[sp.Symbol | None, list[tuple[sp.Symbol, sp.Expr]]]
    groups = {d: [] for d in (*directions, None)}
    for stage in stages:
        for symbol, expression in stage.assignments:
            if symbol in base:
                continue
            inner, direction = parts_of_derivative(symbol)
            if inner in naming.notation.functions:
                # the derivative of a cosine needs no symbol on paper
                inlined[symbol] = expression.xreplace(named)
                continue
            group = direction if direction in groups else None
            groups[group].append((symbol, expression.xreplace(inlined)))
    blocks: list[Block] = []
    for direction, assignments in groups.items():
        if assignments:
            blocks += compose(
                naming,
                """
                [by: The derivatives by $@by$ [fixed: at fixed @fixed] | Further], stage by stage:
                $$
                @lines
                $$
                """,
                by=naming.notation.symbol(direction) if direction else "",
                fixed=[d for d in directions if d != direction],
                lines=[naming.equal(s, e) for s, e in assignments],
            )
    return blocks


def reference_section(view: View, orbit: ReferenceOrbit) -> list[Block]:
    """Blocks on the reference's parameters, the unknowns, the period and the multipliers."""
    equations, notation = view.equations, view.naming.notation
    reference = view.itinerary.reference
    assert reference is not None  # the orbit is solved from it
    texts = {p: reference.parameters[str(p)] for p in equations.parameters}
    unknowns = [
        Line(notation.symbol(u), "=", (_number(value),))
        for u, value in zip(equations.unknowns, orbit.unknowns, strict=True)
    ]
    size = orbit.map.rows
    rows = (" & ".join(map(_number, orbit.map.row(i))) for i in range(size))
    return compose(
        view,
        r"""
        With @given[cited: @cited,] the equations have the solution
        $$
        @unknowns
        $$
        It has
        $$
        \text{period} &= @period
        \operatorname{tr} J &= @trace
        [shown: J &= \left(\begin{matrix}@rows\end{matrix}\right)]
        $$
        [size: and the multiplier[many multipliers: s] @multipliers.]
        """,
        # decimals stay as they are declared
        given=[
            f"${notation.symbol(p)} = {x if x[-1].isdigit() else notation.latex(exact(x))}$"
            for p, x in texts.items()
        ],
        cited=view.naming.cited("reference"),
        unknowns=unknowns,
        period=_number(orbit.period),
        trace=_number(orbit.map.trace()),
        shown=1 < size <= _LARGEST,
        rows=r"\\".join(rows),
        size=size,
        multipliers=[f"${_number(m)}$" for m in orbit.multipliers],
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
