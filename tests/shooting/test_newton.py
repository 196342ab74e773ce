"""Laws of Newton's method, whatever it solves."""

import numpy as np
import pytest

from nonsmooth import NoConvergence
from nonsmooth.runtime.core.arithmetic import Mpmath
from nonsmooth.runtime.shooting.kernel_newton import solve_full, solve_reduced
from nonsmooth.runtime.shooting.newton import climb


class Line:
    """Kernels of an orbit whose one equation is slope (tau - root) = 0, its dwell time tau - ahead.

    `root` is their parameter.
    """

    solver = None
    unknowns = reduced = dwell_times = ("tau",)
    parameter_names = ("root",)
    frequency_places = ()

    def __init__(self, slope=1.0, ahead=0.0, size=1.0):
        self.slope, self.ahead, self.size = slope, ahead, size
        self.table = {"vanishing": [], "durations": [{"tau": 1}]}

    def spectrum(self, parameters):
        return parameters[..., :0], parameters[..., :0]

    def evaluate(self, *quantities, at):
        parameters, unknowns = at[0], at[2]
        slopes = np.full((*parameters.shape, 1), self.slope)
        residual = self.slope * (unknowns - parameters)
        known = {
            "residual": residual,
            "jacobian": slopes,
            "parameter_jacobian": -slopes,
            "reduced_residual": residual,
            "reduced_jacobian": slopes,
            "states": np.full(parameters.shape, self.size),
            "trace": 0 * parameters[..., 0],
            "poincare_jacobian": np.zeros((*parameters.shape, 1)),
        }
        values = [known[quantity] for quantity in quantities]
        return values[0] if len(values) == 1 else values

    def expand(self, parameters, spectrum, x):
        return x, np.ones((len(x), 1))

    def durations(self, values):
        return {"tau": values["tau"] - self.ahead}


def test_points_of_a_batch_end_as_each_alone():
    """After steps of their own number, converged or not."""
    kernels = Line()
    roots = np.array([[0.5], [40.0], [-20.0], [1e-3], [np.nan], [3.0], [-1e-6], [1e9]])
    many = solve_reduced(kernels, roots, np.ones((8, 1)))
    alone = [solve_reduced(kernels, root, np.array([1.0])) for root in roots]
    assert many.status.tolist() == [one.status for one in alone]
    assert many.iterations.tolist() == [one.iterations for one in alone]
    assert len(set(many.iterations.tolist())) > 4
    np.testing.assert_array_equal(many.unknowns, [one.unknowns for one in alone])


@pytest.mark.parametrize("root", [3.0, 1e-3, 1e-8, -1e-12, -4e-10, -1e-6, -0.5, -20.0])
def test_a_dwell_time_that_goes_below_zero_is_never_said_to_be_found(root):
    """Damping makes its steps small; only a whole small step is the last one."""
    kernels = Line()
    one = solve_full(kernels, np.array([1.0, root]), [0])
    found = [(one.status, one.x[0])]
    if abs(root) > 1e-9:  # the tolerance of reduced equations
        many = solve_reduced(kernels, np.array([root]), np.array([1.0]))
        found.append((many.status, many.unknowns[0]))
    for status, tau in found:
        assert (status == 0) == (root > 0)
        assert tau > 0
        assert root < 0 or tau == pytest.approx(root, rel=1e-6, abs=1e-16)


def test_a_phase_that_takes_no_time_or_less_is_no_orbit():
    ahead = np.array([0.25, 0.5, 0.75])  # of a dwell time that is computed
    for each, expected in zip(ahead, (0, 3, 3), strict=True):
        kernels = Line(ahead=each)
        found = solve_full(kernels, np.array([1.0, 0.5]), [0])
        assert found.status == expected
        assert solve_reduced(kernels, np.array([0.5]), np.array([1.0])).status == expected


@pytest.mark.parametrize("remaining", [1e-2, 1e-5, 1e-15, 1e-35, 1e-45])
def test_a_refinement_whose_last_step_still_corrects_has_left_the_orbit(remaining):
    """As near a singular solution, where steps become no smaller."""
    lib = Mpmath(60)

    passed = []

    def step(x, last):
        passed.append(last)
        return [lib.mp.mpf(remaining)], "last" if last else "before"

    start = np.array([lib.mp.mpf(1)], dtype=object)
    if remaining < 1e-30:  # 40 digits, less those that the linear algebra may lose
        assert climb(lib, start, step, 40, 15, "it")[1:] == ("last", len(passed))
        assert [*passed] == [False] * (len(passed) - 1) + [True]
    else:
        told = r"\d+" if remaining > 1e-3 else 40
        with pytest.raises(NoConvergence, match=f"it: Newton's method with {told} digits"):
            climb(lib, start, step, 40, 15, "it")
