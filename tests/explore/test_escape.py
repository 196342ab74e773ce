"""Motions are called divergent where they are, and nowhere else."""

from functools import cache

import numpy as np
import pytest
import sympy as sp

from nonsmooth import find_orbits, simulate, sweep
from nonsmooth.derive import Friction, Harmonic, Parameter, RigidStop, oscillator
from nonsmooth.runtime.explore.finding.outcomes import Outcome
from tests.one_mass import one_mass

pytestmark = pytest.mark.compiled

PERIODIC, UNINTERRUPTED, EQUILIBRIUM = 0, 1, 2  # as files of sweeps have them

KINDS = [
    (1, ("stop",)),
    (1, ("friction",)),
    (1, ("stop", "friction")),
    (2, ("stop",)),
    (2, ("stop", "friction")),
]


@cache
def shaken(masses, contacts):
    """One mass, or two in a row, damped, shaken at the first; what touches acts on the last."""
    zeta, gap = (Parameter(name, "", lower=-sp.oo) for name in ("zeta", "gap"))
    w, mu, k = (Parameter(name, "") for name in ("w", "mu", "k"))
    r = Parameter("r", "", sp.Integer(0), sp.Integer(1), closed=True, upper_closed=True)
    names = [f"x{place}" for place in range(1, masses + 1)]
    elements, used = [], [zeta, w]
    if "stop" in contacts:
        elements.append(RigidStop(names[-1], at=gap.symbol, restitution=r.symbol, name="stop"))
        used += [gap, r]
    if "friction" in contacts:
        elements.append(Friction(names[-1], mu.symbol, name="ground"))
        used += [mu]
    coupling = sp.Matrix([[1, -1], [-1, 1]]) * k.symbol if masses == 2 else sp.zeros(1)
    return oscillator(
        "-".join(["shaken", str(masses), *contacts]),
        names,
        mass=sp.eye(masses),
        stiffness=sp.eye(masses) + coupling,
        damping=2 * zeta.symbol * sp.eye(masses),
        forcing=[Harmonic(w.symbol, cosine=[1, 0][:masses])],
        elements=elements,
        parameters=[*used, k][: len(used) + masses - 1],
    )


def ends_of(system, data, starts, transitions=200):
    """What motions settle on, as diagrams at the one value of a parameter tell it."""
    (name, value), *others = data.items()
    states, place = [str(state) for state in system.states], system.configurations[0].name
    given = {"state": states[0], "configuration": place, "transient": transitions, "samples": 1}
    ends = [
        sweep(system, dict(others), name, [value], dict(zip(states, start, strict=True)), **given)
        for start in starts
    ]
    return np.array([diagram.outcomes[0] for diagram in ends])


@pytest.mark.slow
@pytest.mark.parametrize(("masses", "contacts"), KINDS)
def test_what_is_damped_never_escapes(masses, contacts):
    """Its energy decays, but for what a bounded force of one frequency can give."""
    rng = np.random.default_rng([7, masses, len(contacts)])
    system, size = shaken(masses, contacts), 2 * masses
    for _ in range(2):
        drawn = {
            "zeta": 10 ** rng.uniform(-4, -0.5), "w": rng.uniform(0.3, 4), "r": rng.uniform(0, 1),
            "gap": rng.uniform(-0.3, 1), "mu": rng.uniform(0.01, 1), "k": rng.uniform(0.05, 3),
        }  # fmt: skip
        data = {each.name: drawn[each.name] for each in system.parameters}
        starts = rng.normal(size=(6, size + 2)) * 10 ** rng.uniform(-3, 4)
        starts[:, masses - 1] = drawn["gap"] - np.abs(starts[:, masses - 1])
        turned = rng.uniform(0, 6, 6)
        starts[:, size:] = np.stack([np.cos(turned), np.sin(turned)], axis=-1)
        assert Outcome.DIVERGENT not in ends_of(system, data, starts), data


@pytest.mark.parametrize("beyond", [0.9, 0.98, 1.02, 1.1])
def test_impacts_bound_what_grows_between_them(beyond):
    """A stop at rest is struck each half period, between which sizes grow by e^(-zeta pi/w1).

    With the restitution that makes a factor for each half period, of what is far out.
    """
    system, rng = shaken(1, ("stop",)), np.random.default_rng(3)
    for _ in range(4):
        zeta = -rng.uniform(0.03, 0.2)
        grown = np.exp(-zeta * np.pi / np.sqrt(1 - zeta**2))
        data = {"zeta": zeta, "gap": 0, "r": beyond / grown, "w": rng.uniform(0.3, 4)}
        outcomes = ends_of(system, data, [[-1e4, 0, 1, 0], [-1e6, 5, 0, 1]])
        assert (outcomes == Outcome.DIVERGENT).tolist() == [beyond > 1] * 2, data


@pytest.mark.parametrize("force", [0.9, 1.1])
def test_friction_bounds_a_resonance_as_den_hartog_says(force):
    """At resonance the force gives pi F A in a period; friction takes 4 mu A.

    J. P. Den Hartog, Forced vibrations with combined Coulomb and viscous friction, Trans. ASME 53
    (1931). What is left makes the size grow in proportion to time.
    """
    data = {"zeta": 0, "w": 1, "mu": np.pi / 4 / force}
    outcomes = ends_of(
        shaken(1, ("friction",)), data, [[0.5, 0, 1, 0], [0, -5, 0, 1], [0, 50, 0, 1]], 2000
    )
    assert (outcomes == Outcome.DIVERGENT).tolist() == [force > 1] * 3


@pytest.mark.slow
def test_a_start_that_leaves_an_unstable_orbit_does_not_escape():
    system = "docs/gallery/impact_oscillator.py"
    found = find_orbits(system, {"w": "2.5555555", "sigma": "1/5", "r": "4/5"}, 30)
    assert set(found.outcomes) == {Outcome.CHAOTIC}
    assert found.share(Outcome.CHAOTIC) > 0.8


def test_growth_next_to_rest_ends_where_boundaries_are():
    """Between two stops, from a rest from which sizes grow a thousandfold in 9,000 impacts."""
    system = one_mass(
        "bounded-growth",
        RigidStop("x", at=0, restitution=sp.Symbol("r"), name="near"),
        RigidStop("x", at=-1, restitution="1/2", side="lower", name="far"),
        damping="-1/50",
    )
    outcomes = ends_of(system, {"r": "0.9698"}, [[-1e-6, 0], [-1e-5, 0]])
    assert Outcome.DIVERGENT not in outcomes


def test_what_builds_up_to_a_response_does_not_escape():
    """Next to the resonance of a mass at a stop, at twice the frequency of the mass alone."""
    struck, data = shaken(1, ("stop",)), {"zeta": 1e-4, "gap": 0, "r": 1, "w": 2.0}
    outcomes = ends_of(struck, data, [[-0.5, 0, 1, 0], [-0.1, 0, 0, 1]], 70)
    assert Outcome.DIVERGENT not in outcomes
    assert ends_of(struck, data | {"zeta": 0.01}, [[-0.5, 0, 1, 0]], 2000).tolist() == [PERIODIC]
    # friction of a hundredth of the force hardly holds what damping ends at 5,000,000
    rubbing = {"zeta": 1e-7, "w": 1, "mu": 0.01}
    ended = ends_of(shaken(1, ("friction",)), rubbing, [[0.5, 0, 1, 0]])
    assert Outcome.DIVERGENT not in ended


def test_two_masses_that_escape_far_keep_their_forcing():
    """Modes are found in numbers; a forcing that rounding of large states moved is none."""
    system, data = shaken(2, ("stop",)), {"zeta": -0.03, "w": 1.3, "gap": 0.1, "r": 1, "k": 0.5}
    starts = np.array([[-1, -2, 0, 0, 1, 0], [1, -3, 1, 0, 0, 1.0]]) * [1e3, 1e3, 1, 1, 1, 1]
    far = simulate(system, data, starts, transitions=1500)
    assert np.abs(far.states[:, :4]).max(axis=1).min() > 1e9
    np.testing.assert_allclose(np.hypot(*far.states[:, 4:].T), 1, rtol=1e-9)
    assert (ends_of(system, data, starts, 1500) == Outcome.DIVERGENT).all()
