"""Numbers of the configurations that an orbit visits, and of no others."""

import numpy as np
import pytest

from nonsmooth.runtime.model.kernels import load_system
from nonsmooth.runtime.model.modes.numeric_modes import grouped_modes, numeric_modes
from nonsmooth.runtime.model.piecewise import numbers_at, piecewise_at
from nonsmooth.runtime.shooting.shooting_map import finite_at, itinerary_shape, numbers_in
from tests.declared_documents import chain


@pytest.mark.slow
@pytest.mark.parametrize("visited", [(0,), (2, 0), (0, 1, 2, 3)])
def test_modes_of_visited_configurations_are_the_same_and_no_others_are_found(visited, monkeypatch):
    kernels = load_system(chain())
    points = np.array([[1.0, 20.0], [1.1, 25.0], [1.2, 31.0]])
    whole = numbers_at(kernels, points)
    known = {place: k for group in whole for k, place in enumerate(group.places.tolist())}
    groups = {place: group for group in whole for place in group.places.tolist()}
    calls = []
    for own in (numeric_modes, grouped_modes):
        place = f"nonsmooth.runtime.model.piecewise.{own.__name__}"
        monkeypatch.setattr(place, lambda *a, own=own: calls.append(1) or own(*a))
    for group in numbers_at(kernels, points, visited):
        found = numbers_in(group.structure, group.flat)
        for k, place in enumerate(group.places.tolist()):
            full = numbers_in(groups[place].structure, groups[place].flat)
            here = piecewise_at(kernels, points[place], visited)
            for c in range(4):
                if c in visited:
                    expected = full.flows[c][known[place]]
                    np.testing.assert_array_equal(found.flows[c][k], expected)
                    np.testing.assert_array_equal(here.flows[c], expected)
                else:
                    assert np.isnan([*found.flows[c][k].flat, *here.flows[c].flat]).all()
    assert len(calls) == (1 + len(points)) * len(visited)


@pytest.mark.slow
def test_what_a_cycle_needs_is_finite():
    kernels = load_system(chain())
    points = np.array([[1.0, 20.0], [np.inf, 20.0]])
    phases = [("free-free", "left-reaches-stop"), ("contact-free", "left-leaves-stop")]
    for visited, sound in (((0, 2), True), ((0,), False)):
        for group in numbers_at(kernels, points, visited):
            cycle = itinerary_shape(group.structure, phases)
            expected = [sound and place == 0 for place in group.places.tolist()]
            assert finite_at(cycle, group.flat).tolist() == expected
