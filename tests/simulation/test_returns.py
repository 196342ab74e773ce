"""The Poincaré map by simulation, against the multipliers that are derived."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from nonsmooth import InputError, NoConvergence, poincare_map, solve
from tests.engines import with_both
from tests.handmade import DATA, MIRROR, two_stops
from tests.two_masses import CHAIN, RUBBING, STICKING

ORBITS = {
    "dry-friction/global-stick": (
        STICKING,
        [
            ("stick-stick", "first-breaks-forward"),
            ("slip-stick", "second-breaks-forward"),
            ("slip-slip", "first-reaches-belt"),
            ("stick-slip", "second-reaches-belt"),
        ],
    ),
    "dry-friction/symmetric": (
        RUBBING,
        [("slip-slip", "second-reaches-belt"), ("slip-stick", "second-breaks-forward")],
    ),
    "rigid-stop/one-impact": (CHAIN | {"r": 1}, [("free", "first-reaches-stop")]),
    "elastic-stop/one-contact": (
        CHAIN | {"k3": 1},
        [("contact", "first-leaves-stop"), ("free", "first-reaches-stop")],
    ),
}


def origin(parameters):
    """What the presentation of the friction orbits subtracts: the slip-slip centre."""
    chi, us1, us2 = (float(parameters[name]) for name in ("chi", "us1", "us2"))
    return np.array([(us1 + us2) / (1 - chi), (chi * us1 + us2) / (chi * (1 - chi)), 0, 0])


def nonzero(values):
    """Eigenvalues that are not zero, sorted."""
    found = np.asarray(values, dtype=complex)
    return np.sort_complex(found[np.abs(found) > 1e-5])


def section(itinerary, phase=0):
    """The transition that leads into a phase."""
    return (*itinerary[phase - 1], itinerary[phase][0])


@pytest.mark.parametrize("name", ORBITS)
def test_multipliers_of_the_built_in_orbits(name):
    data, itinerary = ORBITS[name]
    system = name.partition("/")[0]
    orbit = solve(name)
    states = [np.asarray(state, dtype=float) for state in orbit.states]
    if system == "dry-friction":
        states = [state + origin(data) for state in states]
    wanted = [complex(m.real, m.imaginary) for m in orbit.stability.multipliers]
    for phase in range(len(itinerary)):
        mapped = poincare_map(system, data, section(itinerary, phase))
        found = mapped.next_return(states[phase])
        assert_allclose(found.state, states[phase], rtol=0, atol=1e-11)
        assert found.time == pytest.approx(sum(orbit.dwell_times), abs=1e-11)
        turned = [c for c, _ in itinerary[phase:] + itinerary[:phase]]
        assert found.configurations == tuple(turned)
        values = np.linalg.eigvals(mapped.jacobian(states[phase]))
        assert_allclose(nonzero(values), nonzero(wanted), rtol=0, atol=2e-7)


@pytest.mark.parametrize("step", [1e-3, 1e-4])
def test_differences_are_of_the_second_order(step):
    data, itinerary = ORBITS["dry-friction/symmetric"]
    state = solve("dry-friction/symmetric").states[0] + origin(data)
    mapped = poincare_map("dry-friction", data, section(itinerary))
    exact = mapped.jacobian(state, 3e-6)
    errors = [np.abs(mapped.jacobian(state, s) - exact).max() for s in (step, step / 2)]
    assert 3.5 < errors[0] / errors[1] < 4.5


def test_an_impact_that_loses_energy_shrinks_volumes_by_its_square():
    # det of the section map of an impact oscillator: r^2, up to the velocities at both ends
    data = CHAIN | {"r": "0.8"}
    mapped = poincare_map("rigid-stop", data, ("free", "first-reaches-stop", "free"))
    state = np.array([1.0, 0.3, -1.2, 0.4])
    after = mapped(state)
    determinant = abs(np.linalg.det(mapped.jacobian(state)))
    assert determinant == pytest.approx(0.8**2 * abs(state[2] / after[2]), rel=1e-6)


@pytest.mark.compiled
def test_both_engines_map_alike():
    data, itinerary = ORBITS["elastic-stop/one-contact"]
    state = solve("elastic-stop/one-contact").states[0] + np.array([0, 0.01, -0.02, 0.03])
    mapped = poincare_map("elastic-stop", data, section(itinerary))
    assert_allclose(*with_both(mapped, state), rtol=0, atol=1e-12)
    assert_allclose(*with_both(mapped.jacobian, state), rtol=0, atol=1e-7)


def test_a_motion_that_does_not_come_back():
    mapped = poincare_map("rigid-stop", CHAIN | {"r": 0}, ("free", "first-reaches-stop", "free"))
    with pytest.raises(NoConvergence, match="does not come back"):
        mapped([0.5, 0.0, 0.0, 0.0])


def test_the_names_are_those_of_the_system():
    mapped = poincare_map("rigid-stop", CHAIN | {"r": 1}, ("free", "first-reaches-stop", "contact"))
    assert mapped.system.structure.configurations[mapped.target] == "contact"
    # where it rests on the stop only the second mass moves
    assert_allclose(mapped.basis.T @ mapped.basis, np.eye(2), atol=1e-14)
    assert not np.abs(mapped.basis[[0, 2]]).max() > 1e-15


@pytest.mark.parametrize(
    ("section", "match"),
    [
        (("slip-slip", "first-reaches-belt"), "section takes"),
        (("slip", "first-reaches-belt", "stick-slip"), "unknown configuration 'slip'"),
        (("slip-slip", "first-breaks-forward", "stick-slip"), "unknown boundary"),
        (("slip-slip", "first-reaches-belt", "slip-stick"), "no transition leads from slip-slip"),
    ],
)
def test_bad_sections(section, match):
    with pytest.raises(InputError, match=match):
        poincare_map("dry-friction", STICKING, section)


@pytest.mark.parametrize(
    "state", [[0, 0, 0], [0, 0, 0, np.nan], np.zeros((2, 4)), "abcd", None, 1j]
)
def test_bad_states(state):
    mapped = poincare_map(
        "dry-friction", STICKING, ("slip-slip", "first-reaches-belt", "stick-slip")
    )
    with pytest.raises(InputError, match=r"finite numbers|state: .*(real number|is not a number)"):
        mapped(state)


def test_a_return_is_by_its_own_boundary():
    """Two stops lead from the free motion to itself: the other one's impact is on the way."""
    orbit = solve(two_stops(), DATA, [1.85], itinerary=[("free", "reaches-right")], symmetry=MIRROR)
    impact = poincare_map(two_stops(), DATA, ("free", "reaches-right", "free"))
    found = impact.next_return(orbit.states[1])
    assert found.time == pytest.approx(orbit.period, rel=1e-9)
    assert_allclose(found.state, orbit.states[1], atol=1e-9)
