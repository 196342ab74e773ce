"""The section of a document on flows: sums of functions of time, or exponentials by eigenvalues."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import sympy as sp

from nonsmooth.derive.declaration.algebra import cancel, factor
from nonsmooth.derive.declaration.dynamics import SecondOrder
from nonsmooth.derive.document.blocks import Block
from nonsmooth.derive.document.notation import Notation
from nonsmooth.derive.document.printer import with_signs
from nonsmooth.derive.document.sections.responses import response_flows
from nonsmooth.derive.document.template import compose
from nonsmooth.derive.document.view import Described
from nonsmooth.derive.flows.modal import Flow, Spectrum

_Terms = tuple[tuple[sp.Expr, sp.Matrix], ...]  # functions of time, times matrices


def flow_section(shown: Described) -> list[Block]:
    """Blocks on the flows of the configurations.

    Those that have no closed form are exponentials.
    """
    notation = shown.notation
    flows = notation.flows
    entries = _entries(notation.spectrum, flows.values())
    blocks = compose(
        notation,
        r"""
        [entries: [roots: All that needs a root of the parameters is the spectrum, evaluated once
        for each set of parameters[meaning: . It consists of @meaning]: | The factors below
        contain]]
        $$
        @entries
        $$
        """,
        entries=[notation.relation(s, e, tidy=_single(e)) for s, e in entries.items()],
        roots=any(
            not p.exp.is_integer and p.free_symbols
            for e in entries.values()
            for p in e.atoms(sp.Pow)
        ),
        meaning=_meaning(notation, entries),
    )
    if flows:
        blocks += response_flows(notation) if notation.in_responses else _closed(notation)
    return blocks if len(flows) == len(notation.names) else blocks + _exponentials(notation)


def _entries(spectrum: Spectrum, flows: Iterable[Flow]) -> dict[sp.Symbol, sp.Expr]:
    """Entries of the spectrum that the flows need, directly or through others, in order."""
    needed: set[sp.Symbol] = set()
    for flow in flows:
        for part in (*flow.basis, *flow.matrices, *flow.offsets):
            needed |= part.free_symbols
    kept = []
    for symbol, expression in reversed(spectrum.entries):
        if symbol in needed:
            needed |= expression.free_symbols
            kept.append((symbol, expression))
    return dict(kept[::-1])


def _meaning(notation: Notation, entries: Mapping[sp.Symbol, sp.Expr]) -> list[str]:
    """What the spectrum's symbols are: frequencies, differences of eigenvalues, projectors."""
    functions = (g for flow in notation.flows.values() for g in flow.basis)
    oscillating = {s for g in functions if g.has(sp.cos) for s in g.free_symbols}
    if not notation.second_order or not oscillating & set(entries):
        return []
    stems = {symbol.parts[0] for symbol in entries}
    mass, stiffness = map(notation.matrix_letter, "MK")
    found = {
        r"the frequencies $\omega$, whose squares are the eigenvalues of"
        rf" ${mass}^{{-1}} {stiffness}$ for the coordinates that are free": True,
        r"the differences $\Delta$ of two of these eigenvalues": "gap" in stems,
        "the entries $p$ of the projectors on the modes": "p" in stems,
    }
    return [text for text, occurs in found.items() if occurs]


def _single(expression: sp.Expr) -> bool:
    """Whether a sum has a denominator of at most one symbol, and may be put together."""
    return len(sp.fraction(sp.together(expression))[1].free_symbols) < 2


def _closed(notation: Notation) -> list[Block]:
    """Blocks on flows in closed form; those with equal matrices are shown once."""
    flows = notation.flows
    blocks = _centres(notation)
    blocks += compose(
        notation,
        r"""
        [second_order: The flows are written by blocks of positions and velocities, $\Phi^{11}$ and
        $\Phi^{12}$ for the positions, $\Phi^{21}$ and $\Phi^{22}$ for the velocities; $I$ is the
        unit matrix. [cosines: The matrices at the cosines are, up to their signs, the
        projectors on the modes.]]
        """,
        cosines=any(g.has(sp.cos) for flow in flows.values() for g in flow.basis),
    )
    names: dict[sp.Matrix, str] = {}
    for number, sharing in notation.sharing.items():
        if sharing[0] in flows:
            blocks += _flow(notation, flows[sharing[0]], number, names)
    return blocks


def _centres(notation: Notation) -> list[Block]:
    """Blocks that show how each configuration maps a state: about a centre, or with an offset."""
    flows = notation.flows
    centres = {name: centre_of(flows[name]) for name in notation.names if name in flows}
    centred = {name: c for name, c in centres.items() if c is not None and not c.is_zero_matrix}
    drifting = [name for name, centre in centres.items() if centre is None]
    blocks = compose(
        notation,
        r"""
        [centred: Inside a configuration with the centre $d$, $@state(t) = d + \Phi(t)\,(@state(0) -
        d)$; the centres that differ from the origin are]

        [still: In these coordinates [many centres: every one of the configurations has its centre
        at the origin | the centre is at the origin], so that $@state(t) = \Phi(t)\,@state(0)$.]
        $$
        @lines
        $$
        """,
        centred=centred,
        still=not centred and not drifting,
        centres=centres,
        lines={rf"d_{{\text{{{name}}}}}": centre for name, centre in centred.items()},
    )
    for name in drifting:
        pieces = [rf"\Phi_{{{notation.flow_number(name)}}}(t)\,{notation.state}(0)"]
        for function, offset in zip(flows[name].basis, flows[name].offsets, strict=True):
            if not offset.is_zero_matrix:
                scalar = "" if function == 1 else rf"{notation.latex(function)}\,"
                pieces.append(f"+ {scalar}{notation.latex(offset.applyfunc(notation.tidy))}")
        blocks += compose(
            notation,
            "*@name* has no centre; there\n$$\n@state(t) &= @pieces\n$$",
            name=name,
            pieces=tuple(pieces),
        )
    return blocks


def _flow(notation: Notation, flow: Flow, number: int, names: dict[sp.Matrix, str]) -> list[Block]:
    """Blocks on one flow; the constant matrices in it get names, which others may share."""
    in_blocks = notation.second_order
    size = flow.matrices[0].rows
    half = size // 2 if in_blocks else size
    known = dict.fromkeys(names)
    whole = flow.matrix()
    # equal blocks make one line
    heads: dict[_Terms, list[str]] = {}
    shown: dict[_Terms, sp.Matrix] = {}
    for i in range(size // half):
        for j in range(size // half):
            place = (slice(i * half, (i + 1) * half), slice(j * half, (j + 1) * half))
            matrices = [sp.ImmutableMatrix(matrix[place]) for matrix in flow.matrices]
            terms = _collected(dict(zip(flow.basis, matrices, strict=True)), known)
            head = rf"\Phi_{{{number}}}" + (f"^{{{i + 1}{j + 1}}}" if in_blocks else "") + "(t)"
            heads.setdefault(terms, []).append(head)
            shown.setdefault(terms, whole[place])
    new: dict[str, sp.Matrix] = {}
    for matrix in dict.fromkeys(m for found in heads for _, m in found):
        if matrix not in names and matrix.rows > 1 and matrix != sp.eye(matrix.rows):
            names[matrix] = f"P_{{{len(names) + 1}}}"
            new[names[matrix]] = matrix
    return compose(
        notation,
        "@listed:\n\n$$\n@new\n$$\n$$\n@lines\n$$",
        listed=notation.flow_of(number),
        new=new,
        lines=[
            notation.relation(
                " = ".join(equal), _pieces(notation, terms, names), shows=shown[terms]
            )
            for terms, equal in heads.items()
        ],
    )


def _collected(terms: Mapping[sp.Expr, sp.Matrix], known: dict[sp.Matrix, None]) -> _Terms:
    """Terms of a sum with common factors taken out of the matrices, and equal ones joined.

    A matrix takes the sign with which it is known already.
    """
    found: dict[sp.Matrix, sp.Expr] = {}
    for function, matrix in terms.items():
        if matrix.is_zero_matrix:
            continue
        factor, rest = _common_factor(matrix)
        if -rest in known:
            factor, rest = -factor, -rest
        known[rest] = None
        found[rest] = found.get(rest, sp.Integer(0)) + factor * function
    return tuple((scalar, matrix) for matrix, scalar in found.items())


def _common_factor(matrix: sp.Matrix) -> tuple[sp.Expr, sp.Matrix]:
    """Factor that all entries share, and the matrix without it, its first number positive."""
    first, *others = (sp.Mul.make_args(e) for e in matrix if e != 0)
    common = [f for f in first if not f.is_Add]
    for factors in others:
        common = [f for f in common if f in factors and f != -1]
    factor = sp.Mul(*common)
    rest = sp.ImmutableMatrix(matrix / factor).applyfunc(sp.expand)
    entries = [e for e in rest if e != 0]
    negative = (entries[0].is_number and entries[0] < 0) or all(
        not e.is_Add and e.could_extract_minus_sign() for e in entries
    )
    return (-factor, -rest) if negative else (factor, rest)


def _pieces(notation: Notation, terms: _Terms, names: dict[sp.Matrix, str]) -> tuple[str, ...]:
    """LaTeX of a sum of functions of time times matrices."""
    found: list[tuple[int, str]] = []
    for scalar, matrix in terms:
        if matrix.rows == 1:
            found.append(notation.term(scalar * matrix[0]))
            continue
        sign, factor = notation.factor(scalar)
        text = names.get(matrix, "I")
        found.append((sign, text if factor == "1" else rf"{factor}\,{text}"))
    return with_signs(found) or ("0",)


def _exponentials(notation: Notation) -> list[Block]:
    """Blocks that say how flows without a closed form are computed."""
    system = notation.system
    names = [name for name in notation.names if name not in notation.flows]
    dynamics = [system.configuration(name).dynamics for name in names]
    second = [motion for motion in dynamics if isinstance(motion, SecondOrder)]
    return compose(
        notation,
        r"""
        The flow of [none: no configuration is written | *@names* is not written] out in the
        parameters: it comes from numbers, once for each set of parameters. With the matrix
        $@matrix$ and the column $@offset$ of $@state' = @matrix @state + @offset$[second: , which
        hold the equations of motion solved for the accelerations below the rows of $@letter'$[held:
        , zeros for a held one],] it is read off the exponential of an augmented matrix,
        $$
        @state(t) &= \Phi(t)\,@state(0) + @forcing(t),\qquad
            \left(\begin{matrix}\Phi(t) & @forcing(t)\\0 & 1\end{matrix}\right)
            = \mathrm{e}^{@augmented t},\qquad
            @augmented = \left(\begin{matrix}@matrix & @offset\\0 & 0\end{matrix}\right).
        $$
        The exponential is a sum over clusters of eigenvalues. An eigenvalue that is well apart from
        the others is a cluster of its own; those that are equal, or too near each other to be told
        apart, make one together. With the centre $@centre_{j}$ of a cluster and the projector
        $@projector_{j}$ on its invariant subspace,
        $$
        \mathrm{e}^{@augmented t} &= \sum_{j} \mathrm{e}^{@centre_{j} t}
            \sum_{k \ge 0} \frac{t^{k}}{k!} \left(@augmented - @centre_{j} I\right)^{k}
            @projector_{j}.
        $$
        Of a single eigenvalue the term $k = 0$ remains, of equal ones as many terms as there are;
        nearly equal ones are taken together, by divided differences of the exponential at these
        eigenvalues, in which no digits cancel. Two conjugate eigenvalues give a cosine and a sine,
        and the eigenvalue 0 of the last column holds what $@offset$ does.

        @numbered
        """,
        none=len(names) == len(system.configurations) > 1,
        names=names,
        second=second,
        held=any(d.held for d in second),
        numbered=[
            block
            for number, sharing in notation.sharing.items()
            if sharing[0] in names
            for block in compose(
                notation,
                "@flow: the @size eigenvalues are found from the numbers of the matrix $@matrix$.",
                flow=notation.flow_of(number),
                size=len(system.states),
            )
        ],
    )


def centre_of(flow: Flow) -> sp.Matrix | None:
    """Point c with y(t) - c = Phi(t) (y(0) - c), as N x 1; None if there is none.

    Components that are free are zero.
    """
    matrix, offset = flow.field
    size = matrix.rows
    # states that drift come last, so that they are the free ones
    drifting = (matrix * matrix).applyfunc(cancel)
    order = sorted(range(size), key=lambda i: (not any(drifting[i, :]), i))
    unknowns = sp.symbols(f"centre0:{size}")
    solutions = sp.linsolve((matrix[:, order], -offset), *unknowns)
    if not solutions:
        return None
    (solution,) = solutions
    values = sp.Matrix(solution).subs(dict.fromkeys(unknowns, 0)).applyfunc(factor)
    return sp.Matrix([values[order.index(i)] for i in range(size)])
