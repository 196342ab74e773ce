"""The Appendix's route by the map of a turn: the same orbit, and two misprints shown."""

from __future__ import annotations

from typing import Any

import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import DerivationError, EquationSystem, derive_equations
from nonsmooth.derive.codegen.kernels import period_map_kernel
from nonsmooth.derive.equations.program import evaluate
from nonsmooth.derive.systems import dry_friction
from tests.compiled_c import executed
from tests.latex_reader import REVERSIBLE, written_of

NAME = "dry-friction/global-stick"
DATA = [{}, {"V": "0.9", "eta": "1.05", "chi": "0.48"}]


def refined(name: str = NAME, parameters: dict[str, str] | None = None) -> Any:
    return ns.refine(ns.solve(name, parameters or {}), 50)


@pytest.mark.parametrize("parameters", DATA)
@pytest.mark.parametrize("name", [NAME, "dry-friction/solution-ii"])
def test_both_routes_give_one_orbit_to_50_digits(name: str, parameters: dict[str, str]) -> None:
    orbit = refined(name, parameters)
    turn, start, residual = orbit.evaluate("period_map", "linear_start", "compatibility")
    assert len(residual) == len(orbit.unknowns) - len(start)
    assert max(map(abs, residual)) < 1e-50
    state = list(orbit.states[0])
    assert all(abs(a - b) < 1e-50 for a, b in zip(start, state[:2], strict=True))
    for row, expected in zip(turn, state, strict=True):
        assert abs(sum(a * b for a, b in zip(row, [*state, 1], strict=True)) - expected) < 1e-50


@pytest.mark.parametrize("by", range(4))
def test_compatibility_alone_leads_to_the_orbit_from_every_start(by: int) -> None:
    """Behind phase 1 the section ties the positions; behind phase 2 a velocity is sought."""
    orbit, equations = refined(), derive_equations(dry_friction.global_stick.rotated(by))
    kernel, lib, turn = (
        executed(period_map_kernel(equations)),
        orbit.arithmetic,
        equations.period_map,
    )
    parameters = [orbit.values[str(s)] for s in equations.parameters]
    spectrum, _ = orbit.kernels.spectrum(parameters, lib)

    def values(*times: Any) -> Any:
        # what stands in the place of the start is not read
        return kernel(parameters, spectrum, [*[lib.mp.nan] * len(turn.sought), *times], lib=lib)

    expected = [orbit.values[str(t)] for t in turn.unknowns]
    guess = [lib.mp.mpf("1.001") * t for t in expected]
    times = list(lib.mp.findroot(lambda *t: values(*t)[2], guess, tol=1e-100))
    expected += [orbit.states[by][place] for place in turn.sought]
    found = [*times, *values(*times)[1]]
    assert all(abs(a - b) < 1e-50 for a, b in zip(found, expected, strict=True))


def numbers_of(
    orbit: Any, equations: EquationSystem, matrix: sp.Matrix, **changed: Any
) -> sp.Matrix:
    """A matrix over the entries of the map, at an orbit some of whose values are changed."""
    symbols, values = (*equations.parameters, *equations.unknowns), orbit.values | changed
    known = {s: sp.Float(str(values[str(s)]), 55) for s in symbols}
    stages = (*equations.stages_of("residual")[:1], *equations.period_map.map_stages)
    return sp.Matrix(*matrix.shape, evaluate(stages, matrix, known, digits=55))


def test_rows_of_the_compatibility_matrix_sum_to_zero_with_the_right_block_alone() -> None:
    """In (A.1), compatibility as a matrix times z0', the lower left block is printed as N2."""
    orbit, equations = refined(NAME, {"V": "0.9"}), written_of(NAME).equations
    first, second, third, fourth = equations.period_map.blocks
    one = sp.eye(2)
    following = (first - one).inv("ADJ") * second - third.inv("ADJ") * (fourth - one)
    printed = following.xreplace(dict(zip(third, second, strict=True)))
    right, wrong = (
        numbers_of(orbit, equations, matrix) * sp.ones(2, 1) for matrix in (following, printed)
    )
    assert max(map(abs, right)) < 1e-48
    assert max(map(abs, wrong)) > 1e-2


@pytest.mark.parametrize(("velocity", "least", "most"), [("0.9", 1e-2, 10), ("1", 0, 1e-48)])
def test_the_printed_stick_block_is_right_at_unit_velocity_alone(
    velocity: str, least: float, most: float
) -> None:
    """Eq. (10) has V t in place of t in the flow of the first phase, where alone t_a occurs."""
    orbit, equations = refined(NAME, {"V": velocity}), written_of(NAME).equations
    printed = orbit.values["V"] * orbit.values["ta"]
    turn = numbers_of(orbit, equations, equations.period_map.matrix, ta=printed)
    start = sp.Matrix([sp.Float(str(x), 55) for x in orbit.states[0]])
    assert least <= max(map(abs, turn * start - start)) < most


@pytest.mark.parametrize("name", REVERSIBLE)
def test_half_phases_are_no_turn(name: str) -> None:
    with pytest.raises(DerivationError, match="not those of a free turn"):
        _ = written_of(name).equations.period_map
