"""Modes of many states and their factors, against exponentials and the matrices they stand for."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.linalg import expm

from nonsmooth.runtime.model.engine_layout import numbers_of
from nonsmooth.runtime.model.factored_flows import (
    FactoredFlows,
    arrays_of,
    cut_flows,
    flows_size,
    matrices_of,
)
from nonsmooth.runtime.model.flows import flow_states, parts_of
from nonsmooth.runtime.model.large_modes import LARGE
from nonsmooth.runtime.model.modes import NumericModes, numeric_modes
from nonsmooth.runtime.model.time_functions import functions_at
from nonsmooth.runtime.simulation.tangent import flow_matrix
from tests.large_systems import chain, masses_apart


def flow_of(modes: NumericModes, time: float) -> np.ndarray:
    functions = np.array(functions_at(modes.shapes, modes.exponents, time))
    if isinstance(modes.flows, FactoredFlows):
        return modes.flows.at(functions)
    return np.tensordot(functions, modes.flows, axes=1)


def exact(field: np.ndarray, time: float) -> np.ndarray:
    return expm(time * np.vstack([field, np.zeros(field.shape[1])]))[:-1]


def free_chain(count: int, load: float) -> np.ndarray:
    """Masses held by each other alone: they drift, and with a load they fall."""
    stiffness = 2 * np.eye(count) - np.eye(count, k=1) - np.eye(count, k=-1)
    stiffness[0, 0] = stiffness[-1, -1] = 1.0
    field = np.zeros((2 * count, 2 * count + 1))
    field[:count, count:-1] = np.eye(count)
    field[count:, :count] = -stiffness
    field[count:, -1] = load
    return field


FIELDS = {
    "chain": chain(12).fields[0],
    "sticking": chain(12, 5).fields[1],
    "long": chain(40, 15).fields[1],  # on both sides of the mass some frequencies are equal
    "drifting": free_chain(12, 0.0),
    "falling": free_chain(12, 0.5),
    "equal": masses_apart(12, np.ones(24)).fields[0],
}


@pytest.mark.parametrize("name", FIELDS)
def test_modes_of_many_states_are_the_exponential(name: str) -> None:
    field = FIELDS[name]
    modes = numeric_modes(field)
    assert isinstance(modes.flows, FactoredFlows)
    assert modes.exponents[0].tolist() == [0, 0]
    for time in (0.01, 1.0, 20.0):
        wanted = exact(field, time)
        allowed = 1e-12 * np.abs(wanted).max()
        np.testing.assert_allclose(flow_of(modes, time), wanted, rtol=0, atol=allowed)


def test_few_states_keep_their_matrices() -> None:
    count = (LARGE - 4) // 2
    for masses, factored in ((count, False), (count + 1, True)):
        flows = numeric_modes(chain(masses).fields[0]).flows
        assert isinstance(flows, FactoredFlows) == factored


def test_what_does_not_depend_on_a_state_is_zero_exactly() -> None:
    """The force goes on as if nothing happened, whatever the masses do."""
    for name in ("chain", "sticking", "long"):
        flow = flow_of(numeric_modes(FIELDS[name]), 3.0)
        assert not flow[-2:, :-3].any()
        np.testing.assert_allclose(flow[-2:, -3:-1] @ flow[-2:, -3:-1].T, np.eye(2), atol=1e-13)


def test_factors_are_the_matrices_they_stand_for() -> None:
    rng = np.random.default_rng(1)
    for field in (FIELDS["chain"], FIELDS["sticking"]):
        shapes, _, flows = numeric_modes(field)
        assert isinstance(flows, FactoredFlows)
        functions = sum(len(shape.places) for shape in shapes)
        extended, values = rng.normal(size=(3, 27)), rng.normal(size=(3, functions))
        whole = matrices_of(flows)
        assert whole.shape == (functions, 26, 27)
        parts = np.einsum("fij,nj->nfi", whole, extended)
        np.testing.assert_allclose(flows.parts(extended), parts, atol=1e-13)
        np.testing.assert_allclose(
            flows.at(values[0]), np.tensordot(values[0], whole, 1), atol=1e-13
        )
        moved = np.einsum("nf,nfi->ni", values, parts)
        np.testing.assert_allclose(flows.states(values, extended), moved, atol=1e-12)
        sizes = np.einsum("fij,nj->nfi", abs(whole), abs(extended))
        bounds = flows.sizes(abs(extended))
        assert (bounds >= sizes * (1 - 1e-13)).all()
        assert bounds.sum() < 2 * sizes.sum()
        row = rng.normal(size=26)
        found, reach = flows.rows(row)
        np.testing.assert_allclose(found, np.einsum("i,fij->fj", row, whole), atol=1e-13)
        assert (reach >= np.einsum("i,fij->fj", abs(row), abs(whole)) * (1 - 1e-13)).all()


def test_factors_of_many_points_are_those_of_each() -> None:
    fields = [FIELDS["chain"], FIELDS["chain"] * 1.5]
    modes = [numeric_modes(field) for field in fields]
    shapes = modes[0].shapes
    packed = [np.concatenate([a.ravel() for a in arrays_of(m.flows)]) for m in modes]
    assert {m.shapes for m in modes} == {shapes}
    assert flows_size(shapes, 26) == len(packed[0]) < 2 * 27 * 27
    both = cut_flows(shapes, 26, np.array(packed))
    assert isinstance(both, FactoredFlows)
    rng = np.random.default_rng(2)
    extended, values = rng.normal(size=(2, 27)), rng.normal(size=(2, 27))
    for k, one in enumerate(m.flows for m in modes):
        assert isinstance(one, FactoredFlows)
        np.testing.assert_allclose(both.parts(extended)[k], one.parts(extended[k]), atol=1e-14)
        np.testing.assert_allclose(both.at(values)[k], one.at(values[k]), atol=1e-13)
        np.testing.assert_allclose(both.all()[k], one.all(), atol=1e-15)
        np.testing.assert_allclose(both[k].all(), one.all(), atol=1e-15)


def test_states_and_tangents_of_factors() -> None:
    factored = chain(12, 5, factored=True)
    dense = chain(12, 5)
    states = np.random.default_rng(3).normal(size=(4, 26))
    times = np.array([0.1, 0.7, 2.0, 9.0])
    for c in range(3):
        for one, other in (
            (flow_states(factored, c, times, states), flow_states(dense, c, times, states)),
            (flow_states(factored, c, times, states[0]), flow_states(dense, c, times, states[0])),
            (parts_of(factored, c, states), parts_of(dense, c, states)),
            (flow_matrix(factored, c, 1.3), flow_matrix(dense, c, 1.3)),
        ):
            np.testing.assert_allclose(one, other, rtol=0, atol=1e-12)


def test_numbers_grow_with_the_square_of_the_states() -> None:
    count = 60
    system = chain(count, factored=True)
    modes = numeric_modes(system.fields[0])
    structure = replace(system.structure, modes=(modes.shapes,))
    system = replace(
        system, structure=structure, exponents=(modes.exponents,), flows=(modes.flows,)
    )
    # a field, two resets, and both sides of the eigenvectors
    assert numbers_of(system).size < 5.2 * (2 * count + 3) ** 2
