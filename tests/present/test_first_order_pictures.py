"""Pictures of systems of the first order, whose states are no positions and velocities."""

from functools import cache

import pytest
import sympy as sp
from numpy.testing import assert_allclose

import nonsmooth as ns
from nonsmooth.derive import Boundary, Configuration, FirstOrder, System, Transition
from nonsmooth.runtime.simulation.trajectory import Trajectory

pytest.importorskip("matplotlib")

from matplotlib.figure import Figure


@cache
def thermostat(lags: int) -> Trajectory:
    """A relay that switches by the last of some lags in a row."""
    states = sp.symbols(f"a:{lags}", real=True)
    matrix = sp.Matrix(lags, lags, lambda i, j: {0: -1, 1: 1}.get(i - j, 0))

    def regime(name: str, way: int) -> Configuration:
        reached = Boundary(f"{name}-ends", way * states[-1] - sp.Rational(1, 10))
        return Configuration(name, FirstOrder(matrix, [way, *[0] * (lags - 1)]), (reached,))

    system = System(
        "thermostat", "a relay", states, (), (regime("on", 1), regime("off", -1)),
        (Transition("on", {"on-ends"}, "off"), Transition("off", {"off-ends"}, "on")),
    )  # fmt: skip
    start = {str(state): 0 for state in states}
    return ns.simulate(system, {}, start, "on", until=12)


@pytest.mark.parametrize("lags", [1, 2, 3])
def test_a_history_shows_every_state(lags: int) -> None:
    motion = thermostat(lags)
    axes = motion.plot("time", axes=Figure().add_subplot())
    curves = [line for line in axes.lines if len(line.get_xdata()) > 100]
    assert [line.get_label() for line in curves] == [f"$a_{{{k}}}$" for k in range(lags)]
    for place, line in enumerate(curves):
        assert_allclose(line.get_ydata()[::50], motion(line.get_xdata()[::50])[:, place], atol=1e-9)
    assert axes.get_ylabel().startswith("state" if lags == 1 else "states")


def test_a_portrait_names_the_states_that_it_shows() -> None:
    first, second = thermostat(3).plot("phase", axes=Figure().subplots(2))
    assert [first.get_xlabel(), first.get_ylabel()] == ["state $a_{0}$", "state $a_{1}$"]
    assert [second.get_xlabel(), second.get_ylabel()] == ["state $a_{1}$", "state $a_{2}$"]


def test_all_shows_each_state_once_in_two_histories() -> None:
    upper, lower, *_ = thermostat(2).plot("all", axes=Figure().subplots(4))
    assert upper.get_ylabel() == "state $a_{0}$"
    assert lower.get_ylabel() == "state $a_{1}$"
