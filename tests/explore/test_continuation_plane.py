"""Events followed in the plane of two parameters, against closed forms and other solutions."""

from __future__ import annotations

import math

import numpy as np
import pytest

import nonsmooth
from tests.core.test_result_files import composed
from tests.explore.test_continuation_forced import branch, closed_forms, orbit


@pytest.mark.slow
def test_fold_and_flip_curves_in_closed_form() -> None:
    for place, kind in enumerate(("fold", "flip")):
        event = [e for e in branch().events if e.kind == kind][-1]
        locus = nonsmooth.continue_orbit(branch(), "w", (2.6, 3.0), event=event, step=0.1)
        assert locus.parameters == ("sigma", "w")
        assert locus.ends == ("end of the interval", "end of the interval")
        sigma, w = locus.values.T
        assert len(w) > 5
        np.testing.assert_allclose(sigma, closed_forms(w)[place], rtol=0, atol=1e-9)


def test_torus_curve_in_closed_form() -> None:
    damped = nonsmooth.continue_orbit(orbit(-0.5), "c", (-0.4, 0.4), step=0.05)
    (event,) = [e for e in damped.events if e.kind == "neimark-sacker"]
    locus = nonsmooth.continue_orbit(damped, "r", (0.75, 0.85), event=event, step=0.1)
    c, restitution = locus.values.T
    np.testing.assert_allclose(c, np.log(restitution) * 2.8 / math.pi, atol=1e-9)


@pytest.mark.slow
def test_grazing_and_flip_of_an_orbit_with_kernels() -> None:
    found = nonsmooth.continue_orbit(nonsmooth.solve("dry-friction/symmetric"), "V", (0.5, 1.3))
    for event in found.events:
        locus = nonsmooth.continue_orbit(found, "eta", (3.8, 4.2), event=event, step=0.1)
        for (speed, eta), unknowns in list(zip(locus.values, locus.unknowns, strict=True))[::4]:
            near = nonsmooth.solve(
                "dry-friction/symmetric", {"V": speed, "eta": eta}, unknowns.tolist()
            )
            again = nonsmooth.continue_orbit(near, "V", (speed - 0.01, speed + 0.01), step=0.2)
            same = [e.value for e in again.events if e.kind == event.kind]
            assert same == [pytest.approx(speed, abs=1e-9)]


def test_border_collision_is_solution_ii() -> None:
    found = nonsmooth.continue_orbit(nonsmooth.solve("dry-friction/global-stick"), "V", (0.8, 1.3))
    locus = nonsmooth.continue_orbit(found, "e1", (2.8, 3.2), event=found.events[-1], step=0.1)
    speed, e1 = locus.values.T
    for place in (0, len(e1) // 2, -1):
        # the orbit without the first phase, of which e1 is an unknown
        limit = nonsmooth.solve("dry-friction/solution-ii", {"V": speed[place]})
        assert limit.unknowns["e1"] == pytest.approx(e1[place], abs=1e-9)


def test_wrong_input() -> None:
    event = branch().events[0]
    with pytest.raises(nonsmooth.InputError, match="unknown second parameter 'sigma'"):
        nonsmooth.continue_orbit(branch(), "sigma", (-1, 1), event=event)
    with pytest.raises(nonsmooth.InputError, match="is not in 3 to 4"):
        nonsmooth.continue_orbit(branch(), "w", (3, 4), event=event)
    family = nonsmooth.continue_orbit(composed(), "period", (5.1, 6.5))
    with pytest.raises(nonsmooth.InputError, match="one of a family"):
        nonsmooth.continue_orbit(family, "k2", (4, 6), event=family.events[0])
