"""The Appendix's route by the map of a turn: the same orbit, and a misprint shown."""

import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import DerivationError, derive_equations, dry_friction
from nonsmooth.derive.codegen.kernels import period_map_kernel
from nonsmooth.derive.equations.program import evaluate
from tests.compiled_c import executed
from tests.latex_reader import written_of
from tests.tables import slow

NAME = "dry-friction/global-stick"
DATA = [{}, {"V": "0.9", "eta": "1.05", "chi": "0.48"}]


def refined(name=NAME, parameters=None):
    return ns.refine(ns.solve(name, parameters or {}), 50)


def equations_of(name=NAME):
    return written_of(name).equations


@pytest.mark.parametrize("parameters", DATA)
@pytest.mark.parametrize("name", [NAME, "dry-friction/solution-ii"])
def test_both_routes_give_one_orbit_to_50_digits(name, parameters):
    orbit = refined(name, parameters)
    turn, start, residual = orbit.evaluate("period_map", "linear_start", "compatibility")
    assert len(residual) == len(orbit.unknowns) - len(start)
    assert max(map(abs, residual)) < 1e-50
    state = list(orbit.states[0])
    assert all(abs(a - b) < 1e-50 for a, b in zip(start, state[:2], strict=True))
    for row, expected in zip(turn, state, strict=True):
        assert abs(sum(a * b for a, b in zip(row, [*state, 1], strict=True)) - expected) < 1e-50


def solved(orbit, equations, kernel, guess):
    """Dwell times and start by Newton's method on the conditions in the dwell times alone."""
    lib, size = orbit.arithmetic, len(equations.unknowns) - len(guess)
    parameters = [orbit.values[str(s)] for s in equations.parameters]
    spectrum, _ = orbit.kernels.spectrum(parameters, lib)

    def values(*times):
        # what stands in the place of the start is not read
        return kernel(parameters, spectrum, [*[lib.mp.nan] * size, *times], lib=lib)

    times = list(lib.mp.findroot(lambda *t: values(*t)[2], guess, tol=1e-100))
    return times, values(*times)[1]


@pytest.mark.parametrize("by", [1, *(slow(k) for k in (0, 2, 3))])
def test_other_starts_have_maps_of_their_own(by):
    """Behind phase 1 the section ties the positions; behind phase 2 a velocity is sought."""
    orbit = refined()
    equations = derive_equations(dry_friction.global_stick.rotated(by))
    turn = equations.period_map
    rows, order = turn.blocks, [*turn.sought, *turn.known]
    blocks = sp.Matrix.vstack(rows[0].row_join(rows[1]), rows[2].row_join(rows[3]))
    assert blocks == turn.matrix.extract(order, order)
    expected = [orbit.values[str(t)] for t in turn.unknowns]
    expected += [orbit.states[by][place] for place in turn.sought]
    guess = [orbit.arithmetic.mp.mpf("1.001") * t for t in expected[: len(turn.unknowns)]]
    times, start = solved(orbit, equations, executed(period_map_kernel(equations)), guess)
    assert all(abs(a - b) < 1e-50 for a, b in zip([*times, *start], expected, strict=True))


@pytest.mark.parametrize(("velocity", "least", "most"), [("0.9", 1e-2, 10), ("1", 0, 1e-48)])
def test_the_printed_stick_block_is_right_at_unit_velocity_alone(velocity, least, most):
    """Eq. (10) has V t in place of t in the flow of the first phase, where alone t_a occurs."""
    orbit, equations = refined(NAME, {"V": velocity}), equations_of()
    symbols = (*equations.parameters, *equations.unknowns)
    values = orbit.values | {"ta": orbit.values["V"] * orbit.values["ta"]}
    known = {s: sp.Float(str(values[str(s)]), 55) for s in symbols}
    stages = (*equations.stages_of("residual")[:1], *equations.period_map.map_stages)
    turn = sp.Matrix(4, 4, evaluate(stages, equations.period_map.matrix, known, digits=55))
    start = sp.Matrix([sp.Float(str(x), 55) for x in orbit.states[0]])
    assert least <= max(map(abs, turn * start - start)) < most


def test_half_phases_are_no_turn():
    with pytest.raises(DerivationError, match="not those of a free turn"):
        _ = equations_of("rigid-stop/one-impact").period_map
