"""What is found is primitive, listed once, and closes; every start ends in a named outcome."""

from functools import cache

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp
from scipy.linalg import expm

import nonsmooth as ns
from nonsmooth import InputError, find_orbits
from nonsmooth.derive import Friction, Harmonic, Parameter, RigidStop, SoftStop, oscillator
from nonsmooth.runtime.explore.finding.outcomes import Outcome
from tests.explore.listed import check_listed
from tests.explore.test_escape import (
    EQUILIBRIUM,
    PERIODIC,
    UNINTERRUPTED,
    ends_of,
    shaken,
)
from tests.one_mass import one_mass
from tests.tables import slow

pytestmark = pytest.mark.compiled


def stopped():
    """A damped mass under harmonic forcing strikes a stop."""
    return shaken(1, ("stop",))


@cache
def between():
    """The same between two stops, at equal distances."""
    w, gap, r = sp.symbols("w gap r")
    return one_mass(
        "between-stops",
        RigidStop("x", at=gap, restitution=r, name="right"),
        RigidStop("x", at=-gap, restitution=r, side="lower", name="left"),
        damping="1/10",
        forces={w: 1},
    )


@cache
def rubbing(forcings=1):
    """A damped mass under one or two forces rubs on the ground."""
    mu, force = Parameter("mu", "friction"), Parameter("F", "amplitude", lower=-sp.oo)
    w = [Parameter(f"w{k}", "frequency") for k in range(1, forcings + 1)]
    return one_mass(
        "rubbing",
        Friction("x", mu.symbol, name="ground"),
        damping="1/5",
        forces={each.symbol: force.symbol for each in w},
        parameters=[mu, force, *w],
    )


@cache
def on_belt():
    """A mass on a moving belt, without forcing."""
    c, speed = (Parameter(name, "", lower=-sp.oo) for name in "cV")
    belt = Friction("x", sp.Symbol("mu"), velocity=speed.symbol, name="belt")
    return one_mass("on-belt", belt, damping=c.symbol, parameters=[c, speed])


def found_at(system, data, n=12, **options):
    return find_orbits(system, data, n, transitions=400, **options)


# --- the law of what is listed

CASES = [
    *((stopped, seed) for seed in range(3)),
    *((between, seed) for seed in range(2)),
    (rubbing, 0),
]


RANGES = {
    stopped: {"zeta": (0.02, 0.1), "w": (1.5, 3.0), "gap": (-0.1, 0.3), "r": (0.5, 0.9)},
    between: {"w": (0.8, 2.0), "gap": (0.4, 1.5), "r": (0.5, 0.9)},
    rubbing: {"mu": (0.1, 0.8), "F": (1, 3), "w1": (0.6, 1.6)},
}


def drawn(build, seed):
    rng = np.random.default_rng([seed, len(build.__name__)])
    data = {name: round(rng.uniform(*ends), 3) for name, ends in RANGES[build].items()}
    # a stop where the spring is not stretched makes a position that is zero by declaration
    return data | {"gap": 0} if (build, seed) == (stopped, 0) else data


@cache
def law(build, seed):
    data = drawn(build, seed)
    return data, found_at(build(), data)


@pytest.mark.parametrize(("build", "seed"), CASES)
def test_what_is_listed_is_there_once(build, seed):
    _, found = law(build, seed)
    check_listed(build(), found)
    for entry in found.orbits:
        (turns,), orbit = entry.forcing_periods, entry.orbit
        speed = float(orbit.parameters["w1" if build is rubbing else "w"])
        assert entry.period * speed / (2 * np.pi) == pytest.approx(turns, abs=1e-9)


@pytest.mark.parametrize("seed", range(3))
def test_multipliers_are_those_of_one_turn(seed):
    """By Liouville: damping shrinks areas by e^(-2 zeta T), each impact by r^2."""
    data, found = law(stopped, seed)
    for entry in found.orbits:
        impacts = len(entry.itinerary) * (not entry.orbit.tables.cycle.uninterrupted)
        area = np.exp(-2 * data["zeta"] * entry.period) * data["r"] ** (2 * impacts)
        largest = np.abs(entry.orbit.multipliers).max()
        assert np.prod(entry.orbit.multipliers) == pytest.approx(area, abs=1e-9 * max(1, largest))


@pytest.mark.slow
@pytest.mark.parametrize("zeta", ["1e-14", "0", "1e-6"])
def test_more_digits_confirm_a_verdict(zeta):
    data = {"zeta": zeta, "r": "1", "w": "2.6", "gap": "0.5"}
    found = find_orbits(stopped(), data, 10, transitions=200, rng=1)
    regular = [entry.orbit for entry in found.orbits if entry.verdict != "unstable"]
    assert len(regular) > 1  # how many depends on the last bits of motions that nothing damps
    verdicts = {orbit.stability.verdict for orbit in regular}
    assert verdicts <= {"neutral" if zeta == "0" else "stable", "undecided"}
    assert (verdicts == {"undecided"}) == (zeta == "1e-14")
    orbit = min(regular, key=lambda orbit: len(orbit.itinerary))
    truth = ns.refine(orbit, 40).stability
    assert truth.verdict == ("neutral" if zeta == "0" else "stable")
    assert abs(truth.margin - orbit.stability.margin) < 1e-12


def test_a_position_that_is_zero_by_declaration_is_no_return():
    data = {"zeta": "0.05", "w": "2.6", "gap": 0, "r": "0.8"}
    found = found_at(stopped(), data, 20)
    attracting = [entry for entry in found.orbits if entry.starts]
    assert sorted(entry.forcing_periods for entry in attracting) == [(1,), (3,)]
    assert sum(entry.share for entry in attracting) == 1
    for start in found.starts[:3]:
        motion = ns.simulate(stopped(), data, start, transitions=600)
        assert len(ns.itinerary_of(motion).itinerary) in (1, 3)


def test_a_velocity_that_is_zero_by_declaration_is_no_return():
    (entry,) = found_at(rubbing(), {"mu": "1/2", "w1": "1.1", "F": 2}, 8).orbits
    assert entry.period == pytest.approx(5.711986642890532, abs=1e-9)
    assert (entry.share, entry.forcing_periods, entry.mirror) == (1, (1,), 0)

    def half(start):
        """Half a period by DOP853: x' < 0 from rest, against friction 1/2."""
        x, t = start
        sol = solve_ivp(
            lambda t, y: [y[1], 2 * np.cos(1.1 * t) - y[1] / 5 - y[0] + 0.5],
            (t, t + 6), [x, -1e-14], method="DOP853", rtol=1e-12, atol=1e-13,
            events=lambda t, y: y[1] if t > start[1] + 1e-3 else -1.0,
        )  # fmt: skip
        return sol.y_events[0][0][0], sol.t_events[0][0]

    place = [boundary for _, boundary in entry.itinerary].index("ground-reaches-belt")
    now = entry.orbit
    fields, passed = now.tables.piecewise.fields, now.tables.cycle.configurations
    down = next(k for k in range(2) if fields[passed[k]][1, -1] > 0)
    x, _, c, s = now.states[down]
    assert place in (0, 1)
    end, when = half((x, np.arctan2(s, c) / 1.1))
    assert end == pytest.approx(-x, abs=1e-8)
    assert when - np.arctan2(s, c) / 1.1 == pytest.approx(np.pi / 1.1, abs=1e-8)


# --- motions that reach no boundary


def response(zeta, w):
    return 1 / (1 - w**2 + 2j * zeta * w)


def test_the_linear_response_is_an_orbit():
    data = {"zeta": "0.05", "w": "2.6", "gap": 3, "r": "0.8"}
    found = found_at(stopped(), data, 4)
    (entry,) = found.orbits
    assert (entry.share, entry.forcing_periods, entry.verdict) == (1, (1,), "stable")
    assert entry.itinerary == (("free", "forcing-phase"),)
    # x = Re g e^(i Omega t), x' = Re i Omega g e^(i Omega t)
    gain = response(0.05, 2.6)
    np.testing.assert_allclose(
        entry.orbit.states[0], [gain.real, -2.6 * gain.imag, 1, 0], atol=1e-13
    )
    wanted = np.linalg.eigvals(expm(np.array([[0, 1], [-1, -0.1]]) * 2 * np.pi / 2.6))
    np.testing.assert_allclose(
        np.sort_complex(entry.orbit.multipliers), np.sort_complex(wanted), atol=1e-12
    )
    times = np.linspace(0, entry.period, 7)
    angles = np.exp(2.6j * times)
    np.testing.assert_allclose(
        entry.orbit.trajectory()(times)[:, 0], (gain * angles).real, atol=1e-12
    )


def test_grazing_ends_it():
    data = {"zeta": "0.05", "w": "2.6", "gap": "0.3", "r": "0.8"}
    orbit = ns.solve(stopped(), data, [2 * np.pi / 2.6], itinerary=[("free", "forcing-phase")])
    branch = ns.continue_orbit(orbit, "w", (2, 2.7))
    assert {event.kind for event in branch.events} == {"grazing"}
    for event in branch.events:
        assert abs(response(0.05, event.value)) == pytest.approx(0.3, abs=1e-11)
    assert len(branch.events) == 1
    between_them = np.abs(response(0.05, branch.parameter_values)) > 0.3
    np.testing.assert_array_equal(branch.admissible, ~between_them)
    (event,) = ns.continue_orbit(orbit, "gap", (0.1, 0.4)).events
    assert event.value == pytest.approx(abs(response(0.05, 2.6)), abs=1e-12)


@pytest.mark.slow
def test_several_forcings_and_their_common_period():
    data = {"mu": "1/100", "F": 1, "w1": "3/2", "w2": 1}
    steady = stopped()
    with pytest.raises(InputError, match="no forcing"):
        ns.solve(on_belt(), {"mu": 1, "c": 0, "V": 1}, [1], itinerary=[("slip", "forcing-phase")])
    phases = [("free", "forcing-phase"), ("free", "stop-reaches-stop")]
    with pytest.raises(InputError, match="unknown boundary"):
        ns.solve(steady, {"zeta": 0, "w": 2, "gap": 1, "r": 1}, [1, 1], itinerary=phases)
    found = found_at(rubbing(2), data, 3)
    assert {(3, 2)} == {entry.forcing_periods for entry in found.orbits if entry.starts}
    lost = found_at(rubbing(2), data | {"w2": "2**(1/2)"}, 3)
    assert lost.share(Outcome.INCOMMENSURATE) == 1


# --- what is not periodic


def test_an_equilibrium_has_eigenvalues():
    found = found_at(on_belt(), {"mu": "1/2", "c": "1/5", "V": 3})
    (entry,) = (e for e in found.equilibria if e.starts)
    known = entry.equilibrium
    assert (entry.share, known.configuration, known.verdict) == (1, "slip", "stable")
    np.testing.assert_allclose(known.state, [0.5, 0], atol=1e-14)  # x = mu
    roots = np.roots([1, 0.2, 1])
    np.testing.assert_allclose(np.sort_complex(known.eigenvalues), np.sort_complex(roots))
    assert not found.outcomes


@pytest.mark.slow
def test_steady_sliding_that_is_unstable_is_listed():
    found = found_at(on_belt(), {"mu": "1/2", "c": "-1/50", "V": 3})
    (entry,) = found.equilibria
    assert (entry.starts, entry.equilibrium.verdict) == (0, "unstable")
    # what the belt does not catch grows: friction does not grow with the speed
    assert 0 < found.share(Outcome.DIVERGENT) < 1
    assert found.orbits[0].share + found.share(Outcome.DIVERGENT) == 1


@pytest.mark.parametrize(
    ("system", "data", "outcome"),
    [
        (on_belt, {"mu": "1/2", "c": "1/5", "V": 0}, Outcome.RESTING),
        (stopped, {"zeta": "0.05", "w": "2.8", "gap": 0, "r": "0.8"}, Outcome.CHAOTIC),
    ],
)
def test_outcomes_have_names(system, data, outcome):
    box = dict.fromkeys(map(str, system().states[:2]), (-1, 1))
    assert found_at(system(), data, 4, box=box).share(outcome) == 1


@pytest.mark.slow
def test_a_long_transient_is_no_chaos():
    data = {"m1": 1, "m2": 2, "k1": 1, "k2": 5}
    # it strikes the stop nearly a thousand times more, gently, and then never again
    start = [1.0, 0.22202226193837551, -0.0003265565473231795, 9.956807746317763e-05]
    begin = dict(zip(("x1", "x2", "v1", "v2"), start, strict=True))
    diagram = ns.sweep("rigid-stop", data, "r", [0.5], begin, state="x1", configuration="free",
                       transient=19, samples=1)  # fmt: skip
    assert diagram.outcomes.tolist() == [Outcome.FAMILY]


# --- mirror images


def free_on_the_ground():
    """A mass that no spring holds, shaken; sticks between its ways."""
    ground = Friction("x", kinetic="1/2", name="ground")
    return one_mass("free-on-the-ground", ground, stiffness=0, forces={"1/2": 2})


def twins():
    """Two equal masses that are shaken alike and reach equal stops together."""
    half, tenth = sp.Rational(1, 2), sp.Rational(1, 10)
    return oscillator(
        "twins",
        ["x", "y"],
        mass=[[1, 0], [0, 1]],
        stiffness=[[tenth, 0], [0, tenth]],
        damping=[[2, -1], [-1, 2]],
        forcing=[Harmonic(sp.Rational(6, 5), cosine=[1, 1])],
        elements=[SoftStop(name, at=half, stiffness=5, name=f"stop-{name}") for name in "xy"],
    )


def between_soft_stops():
    """Equal stops at equal distances."""
    return one_mass(
        "between-soft-stops",
        SoftStop("x", at="1/2", stiffness=8, name="right"),
        SoftStop("x", at="-1/2", stiffness=8, side="lower", name="left"),
        damping="1/10",
        forces={"7/10": 1},
    )


def apart(orbit, image, other):
    """How far the image of an orbit is from another, each as a closed curve up to translations."""
    curves = []
    for each, matrix in ((orbit, image), (other, np.eye(len(image)))):
        times = np.linspace(0, float(each.period), 2000, endpoint=False)
        states = np.asarray(each.trajectory(1)(times)) @ matrix.T
        free = np.abs(each.tables.translations).any(axis=0)
        curves.append(states - states.mean(axis=0) * free)
    spectra = [np.fft.fft(curve, axis=0) for curve in curves]
    turn = int(np.fft.ifft((spectra[0] * spectra[1].conj()).sum(axis=1)).real.argmax())
    return np.abs(curves[0] - np.roll(curves[1], turn, axis=0)).max()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("declared", "own"),
    [
        (free_on_the_ground, -np.eye(4)),
        (twins, np.eye(6)[[1, 0, 3, 2, 4, 5]]),
        (between_soft_stops, -np.eye(4)),
    ],
)
def test_an_orbit_that_is_its_own_mirror_image_has_no_other(declared, own):
    found = found_at(declared(), {}, 2)
    orbits = [entry.orbit for entry in found.orbits]
    assert orbits
    for place, entry in enumerate(found.orbits):
        none = np.eye(len(own))
        before = [
            other for other in range(place + 1) if apart(orbits[place], own, orbits[other]) < 0.05
        ]
        assert entry.mirror == (before[0] if before else None)
        assert all(apart(orbits[place], none, orbits[other]) > 0.05 for other in range(place))


def test_mirror_images_are_marked():
    found = found_at(between(), {"w": "1.5", "gap": "0.5", "r": "0.8"}, 20)
    swapped = {"left-reaches-stop": "right-reaches-stop", "right-reaches-stop": "left-reaches-stop"}
    pairs = [(k, e) for k, e in enumerate(found.orbits) if e.mirror not in (None, k)]
    assert pairs
    for place, entry in pairs:
        other = found.orbits[entry.mirror]
        assert entry.mirror < place
        assert entry.period == pytest.approx(other.period, rel=1e-12)
        images = sorted(swapped[boundary] for _, boundary in entry.itinerary)
        assert images == sorted(boundary for _, boundary in other.itinerary)


def test_places_of_mirror_images_count_the_orbits_first():
    """Between soft stops with an equilibrium each, and walls that keep what grows."""
    soft, walls = (
        [build({"x": sign}, place, strength, name=f"{name}-{place}")
         for sign, name in ((1, "right"), (-1, "left"))]
        for build, place, strength in ((SoftStop, 1, 4), (RigidStop, 2, "1/2"))
    )  # fmt: skip
    system = one_mass("two-wells", *soft, *walls, damping="-1/5", stiffness=-1)
    told = find_orbits(system, {}, 4, transitions=60, rng=1).to_json()
    entries = [*told["orbits"], *told["equilibria"]]
    assert told["orbits"]
    (image,) = (entry for entry in told["equilibria"] if entry["mirror_of"])
    other = entries[image["mirror_of"] - 1]["state"]
    assert float(image["state"]["x"]) == -float(other["x"]) != 0


def test_no_orbit_has_an_image_without_a_symmetry():
    alone = law(stopped, 1)[1]
    assert {entry.mirror for entry in (*alone.orbits, *alone.equilibria)} == {None}


def test_impacts_that_follow_each_other_ever_faster_come_back_with_the_forcing():
    """A hundred impacts in a period, until the mass rests at the stop: no cycle is short."""
    data = {"zeta": "0.1392", "w": "0.4243", "gap": "-0.0716", "r": "0.7297"}
    period = 2 * np.pi / 0.4243
    found = find_orbits(stopped(), data, 6, transitions=600)
    assert set(ends_of(stopped(), data, found.starts, 600).tolist()) == {PERIODIC}
    for start in found.starts[:2]:
        motion = ns.simulate(stopped(), data, start, until=8 * period)
        begin, end = motion(5.3 * period), motion(6.3 * period)
        np.testing.assert_allclose(begin, end, atol=1e-7)
    assert set(found.outcomes) <= {Outcome.UNCLASSIFIED}  # no orbit, but no chaos either


@pytest.mark.parametrize(
    ("build", "data"),
    [
        *(
            slow(*case)
            for case in (
                (stopped, {"zeta": 0.05, "w": 2.8, "gap": 0, "r": 0.8}),
                (stopped, {"zeta": -0.05, "w": 2.6, "gap": 0.4, "r": 0.95}),
                (between, {"w": 1.4, "gap": 0.6, "r": 0.7}),
                (rubbing, {"mu": 0.4, "F": 1.5, "w1": 0.9}),
                (on_belt, {"mu": 0.5, "c": -0.02, "V": 3}),
            )
        ),
        (stopped, {"zeta": 0.05, "w": 2.6, "gap": 3, "r": 0.8}),
        (on_belt, {"mu": 0.5, "c": 0.2, "V": 0}),
    ],
)
def test_one_motion_is_told_as_many_are(build, data):
    """Charts and sweeps name what a search names, with the orbits that it solves."""
    found = find_orbits(build(), data, 4, transitions=400)
    ends = ends_of(build(), data, found.starts, 400).tolist()
    for label, outcome in zip(found.labels.tolist(), ends, strict=True):
        if label >= len(found.orbits):
            assert outcome == EQUILIBRIUM
        elif label >= 0:
            alone = found.orbits[label].orbit.tables.cycle.uninterrupted
            assert outcome == (UNINTERRUPTED if alone else PERIODIC)
        else:
            assert outcome == label


def test_what_moves_beside_a_mass_that_sticks_anywhere_is_one_of_a_family():
    w, mu = Parameter("w", "frequency"), Parameter("mu", "friction")
    system = oscillator(
        "beside",
        ["x", "y"],
        mass=sp.eye(2),
        stiffness=[[3, -2], [-2, 3]],
        damping=sp.eye(2) / 10,
        forcing=[Harmonic(w.symbol, cosine=[1, 0])],
        elements=[Friction("y", mu.symbol, name="ground")],
        parameters=[w, mu],
    )
    data = {"w": "0.6", "mu": 2}
    found = find_orbits(system, data, 10, transitions=200)
    assert found.share(Outcome.FAMILY) == 1
    times = 100 + 2 * np.pi / 0.6 * np.arange(2)
    ends = np.array([ns.simulate(system, data, s, until=150)(times) for s in found.starts])
    np.testing.assert_allclose(ends[:, 1, :4], ends[:, 0, :4], atol=0.02)  # e^(-t/20)
    np.testing.assert_allclose(ends[:, :, 3], 0, atol=1e-14)
    assert np.ptp(ends[:, 0, 1]) > 0.1
