"""What derive_equations gives to people who use SymPy: short, expanded, and as LaTeX."""

import mpmath
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import DerivationError
from nonsmooth.derive.systems import SYSTEMS, declaration
from tests.latex_reader import written_of
from tests.tables import slow

ORBITS = {f"{name}/{orbit.name}": orbit for name in SYSTEMS for orbit in declaration(name).orbits}


def equations_of(name):
    return written_of(name).equations


@pytest.mark.parametrize(
    "name", ["rigid-stop/one-impact", "dry-friction/global-stick", slow("dry-friction/symmetric")]
)
def test_expanded_expressions_have_the_values_of_the_kernels(name):
    equations, orbit = equations_of(name), ns.refine(ns.solve(name), 40)
    symbols = (*equations.parameters, *equations.unknowns)
    for quantity, expected in (
        ("trace", [[orbit.trace]]),
        ("jacobian", orbit.evaluate("jacobian")),
        ("map", orbit.evaluate("poincare_jacobian")),
        ("residual", [[0] for _ in equations.unknowns]),
    ):
        found = sp.Matrix([equations.expand(quantity)])
        assert found.free_symbols <= set(symbols)
        with mpmath.workdps(50):
            numbers = [mpmath.mpf(orbit.values[str(s)]) for s in symbols]
            values = sp.lambdify(symbols, found, "mpmath", cse=True)(*numbers).tolist()
        for row, wanted in zip(values, expected, strict=True):
            for value, number in zip(row, wanted, strict=True):
                assert abs(value - number) < 1e-38


def test_stages_are_inserted_one_by_one():
    equations = equations_of("dry-friction/global-stick")
    assert repr(equations) == (
        "EquationSystem dry-friction/global-stick: 6 equations in z10, z20, ta, tau, tau1, tau2"
    )
    titles = [stage.title for stage in equations.stages_of("residual")]
    assert titles[0] == "spectrum"
    assert len(set(titles)) == len(titles)
    whole = equations.expand("residual")
    assert equations.expand("residual", *titles) == whole
    part = equations.expand("residual", *titles[1:])
    assert part.free_symbols & set(equations.spectrum.symbols)
    assert not whole.free_symbols & set(equations.spectrum.symbols)
    assert sp.Matrix(equations.residual) != equations.expand("residual", titles[-1]) != part
    with pytest.raises(DerivationError, match="there is no stage 'sepctrum'"):
        equations.expand("trace", "sepctrum")
    with pytest.raises(DerivationError, match="unknown quantity 'Jacobian'"):
        equations.expand("Jacobian")


@pytest.mark.parametrize("name", ORBITS)
def test_latex_has_the_names_of_the_document(name):
    equations, naming = equations_of(name), written_of(name).notation
    for expression in (equations.trace, equations.residual[0], equations.unknowns[0]):
        assert equations.latex(expression) == naming.latex(expression)
        assert "_on_" not in equations.latex(expression)
        assert ",on," not in equations.latex(expression)
