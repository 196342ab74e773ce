"""What is found, followed and proved is the same in all units of length, time and mass."""

from fractions import Fraction
from functools import cache

import numpy as np
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import (
    Boundary,
    Condition,
    Configuration,
    FirstOrder,
    Friction,
    Harmonic,
    Parameter,
    SoftStop,
    System,
    Transition,
    oscillator,
)
from tests.one_mass import one_mass
from tests.scaled_systems import DAMPING, FORCE, LENGTH, MASS, RATE, STIFFNESS

UNITS = [
    (Fraction(1, 10**6), 1200, 7),
    (2**20, Fraction(1, 64), Fraction(1, 2)),
]
OF_UNITS = (
    Parameter("length", "unit of length"),
    Parameter("rate", "inverse of the unit of time"),
    Parameter("mass_unit", "unit of mass"),
)


@cache
def rubbing():
    """Two masses, one of them on a belt, under a force of the frequency w."""
    w = Parameter("w", "frequency of the force in the unit of it")
    hold = Parameter("hold", "static friction in the unit of it")
    return oscillator(
        "rubbing", ["x1", "x2"],
        mass=[[MASS, 0], [0, 2 * MASS]],
        stiffness=[[3 * STIFFNESS, -STIFFNESS], [-STIFFNESS, 2 * STIFFNESS]],
        damping=[[DAMPING / 5, 0], [0, DAMPING / 10]],
        forcing=[Harmonic(w.symbol * RATE, cosine=[2 * FORCE, 0])],
        elements=[Friction("x1", kinetic=FORCE / 2, static=FORCE * hold.symbol, name="belt")],
        parameters=(*OF_UNITS, w, hold),
    )  # fmt: skip


@cache
def converter():
    """A buck converter that compares its voltage with a sawtooth; its clock is a time."""
    i, v, clock = sp.symbols("i v clock", real=True)
    w = Parameter("w", "input voltage in the unit of it")
    rows = [[0, -RATE / 50, 0], [RATE * 400 / 47, -RATE * 200 / 517, 0], [0, 0, 0]]
    gain, wanted = sp.Rational(42, 5), sp.Rational(113, 10) * LENGTH
    lowest, highest = sp.Rational(19, 5) * LENGTH, sp.Rational(41, 5) * LENGTH
    ramp = lowest + (highest - lowest) * clock * RATE
    above, at_reset = gain * (v - wanted) - ramp, gain * (v - wanted) - lowest
    ends = Boundary("clock", clock - 1 / RATE)
    on = FirstOrder(rows, [RATE * w.symbol * LENGTH / 50, 0, 1])
    again = {clock: 0}
    return System(
        "converter", "a buck converter", (i, v, clock), (*OF_UNITS, w),
        (
            Configuration("on", on, (Boundary("control", above), ends)),
            Configuration("off", FirstOrder(rows, [0, 0, 1]), (Boundary("control", -above), ends)),
        ),
        (
            Transition("on", {"control"}, "off"),
            Transition("off", {"control"}, "on"),
            Transition("on", {"clock"}, "off", reset=again,
                       conditions=(Condition(at_reset, along="off"),)),
            Transition("on", {"clock"}, "on", reset=again),
            Transition("off", {"clock"}, "off", reset=again,
                       conditions=(Condition(at_reset, along="off"),)),
            Transition("off", {"clock"}, "on", reset=again),
        ),
    )  # fmt: skip


def units(length, rate, mass=1, **values):
    """Parameters of a system with these units of length, inverse time and mass."""
    return {"length": length, "rate": rate, "mass_unit": mass, **values}


SYSTEMS = {
    "rubbing": (rubbing, {"w": "1.2", "hold": "3/4"}, ("1.1", "1.3")),
    "converter": (converter, {"w": "22"}, ("21", "27")),
}


@cache
def answers(name, length, rate, mass):
    """Orbits that are found, events along the branch of the first, and what is proved of it."""
    declare, values, (low, high) = SYSTEMS[name]
    given = units(length, rate, mass, **values)
    found = ns.find_orbits(declare(), given, 4, transitions=150, rng=3)
    # those to which motions come: which unstable ones are met on the way is a matter of rounding
    listed = [each.orbit for each in found.orbits if each.starts]
    first = listed[0]
    branch = ns.continue_orbit(first, "w", (low, high), step=0.05)
    proof = ns.certify(first)
    return listed, branch, proof


@pytest.mark.slow
@pytest.mark.parametrize(("name", "units"), [*zip(SYSTEMS, UNITS, strict=True)])
def test_orbits_branches_and_proofs_do_not_depend_on_units(name, units):
    wanted, wanted_branch, wanted_proof = answers(name, 1, 1, 1)
    listed, branch, proof = answers(name, *units)
    assert [orbit.itinerary for orbit in listed] == [orbit.itinerary for orbit in wanted]
    for one, other in zip(listed, wanted, strict=True):
        assert float(one.period) * float(units[1]) == pytest.approx(float(other.period), rel=1e-9)
        np.testing.assert_allclose(one.multipliers, other.multipliers, rtol=0, atol=1e-7)
    assert [event.kind for event in branch.events] == [event.kind for event in wanted_branch.events]
    for one, other in zip(branch.events, wanted_branch.events, strict=True):
        assert one.value == pytest.approx(other.value, rel=1e-8)
    assert branch.ends == wanted_branch.ends
    assert proof.claims == wanted_proof.claims
    assert set(proof.claims.values()) == {"proved"}
    if name == "rubbing":  # the event is followed in two parameters
        curves = [
            ns.continue_orbit(of, "hold", (0.7, 0.8), event=of.events[0], points=1).values
            for of in (branch, wanted_branch)
        ]
        assert len(curves[1]) == 3
        np.testing.assert_allclose(*curves, rtol=1e-8)


SMALL = (Fraction(1, 10**9), 10**5, 7)  # nanometres


def stops(at, stiffness):
    """Equal ones on both sides."""
    return [
        SoftStop({"x": sign}, at=at, stiffness=stiffness, name=name)
        for name, sign in (("right", 1), ("left", -1))
    ]


@cache
def bistable():
    """A mass that is pushed away from the middle, to one of two stops."""
    return one_mass(
        "bistable", *stops(LENGTH, 4 * STIFFNESS),
        mass=MASS, stiffness=-STIFFNESS, damping=DAMPING / 5, parameters=OF_UNITS,
    )  # fmt: skip


@cache
def stopped():
    """A mass between two stops, that a load may push to one of them."""
    w, load = Parameter("w", "frequency of the force"), Parameter("load", "load", lower=-sp.oo)
    return one_mass(
        "stopped", *stops(LENGTH / 2, 9 * STIFFNESS),
        mass=MASS, stiffness=STIFFNESS, damping=DAMPING / 10, load=[load.symbol],
        forces={w.symbol * RATE: FORCE},
        parameters=(*OF_UNITS, w, load),
    )  # fmt: skip


@cache
def motions_between_stops(length, rate, mass):
    given = units(length, rate, mass, w="1.9", load=0)
    return ns.find_orbits(stopped(), given, 3, transitions=200, rng=1)


def between_stops(length, rate, mass):
    """The orbit that is its own mirror image."""
    return motions_between_stops(length, rate, mass).orbits[0].orbit


# --- what is read off the motion, without its units


def of_equilibria(length, rate, mass):
    found = ns.find_orbits(bistable(), units(length, rate, mass), 8, transitions=100, rng=2)
    places = [each.equilibrium.state[0] / float(length) for each in found.equilibria]
    assert sorted(places) == pytest.approx([-4 / 3, 0, 4 / 3])
    images = [-1 if each.mirror is None else each.mirror for each in found.equilibria]
    return np.r_[places, [each.starts for each in found.equilibria], images]


def of_starts_and_ends(length, rate, mass):
    """Boundaries lie in one state alone, so that the other's size is by the motion."""
    found = motions_between_stops(length, rate, mass)
    starts = found.starts / np.array([float(length), float(length * rate), 1, 1])
    return np.r_[starts.ravel(), found.labels, [orbit.starts for orbit in found.orbits]]


def of_design(length, rate, mass):
    design = ns.design(
        between_stops(length, rate, mass),
        minimise="maximum:v", over={"w": (1.85, 1.95)},
        subject_to=[f"period<={3.35 / float(rate)!r}"],
    )  # fmt: skip
    (limit,) = design.active
    assert (design.status, limit.text.partition("=")[0]) == (0, "period<")
    fastest = float(length * rate)
    gained = limit.multiplier / fastest / float(rate)
    return [design.after["w"], design.after["maximum:v"] / fastest, gained]


def of_section_map(length, rate, mass):
    orbit = between_stops(length, rate, mass)
    (source, boundary), (target, _) = orbit.itinerary[-1], orbit.itinerary[0]
    mapped = ns.poincare_map(stopped(), orbit.given, (source, boundary, target))
    np.testing.assert_allclose(mapped.basis.T @ mapped.basis, np.eye(3), atol=1e-14)
    return np.sort_complex(np.linalg.eigvals(mapped.jacobian(orbit.states[0])))


def of_region(length, rate, mass):
    """The states at the forcing's phase of a periodic motion are one point."""
    given, start = units(length, rate, w="1.9", load=0), {"x": float(length) / 4, "v": 0}
    graph = ns.certify.region(stopped(), given, start, boxes=1, parts=1).graph
    bounds = graph.grid.bounds(np.arange(len(graph.grid)))
    return np.array(bounds)[:, 0] / np.array([float(length), float(length * rate)])


def of_orbit_by_kernels(length, rate, mass):
    """Its derivatives, relative to times, velocities and stiffnesses, and its energies."""
    known, unit = ns.solve("elastic-stop/one-contact"), float(rate)
    powers = {"k1": 2, "k2": 2, "k3": 2, "T": -1, "tau": -1, "u": 1, "w": 1}
    given, guess = (
        {key: float(value) * unit ** powers.get(key, 0) for key, value in part.items()}
        for part in (known.given, known.unknowns)
    )
    orbit, period = ns.solve("elastic-stop/one-contact", given, guess), 2 * np.pi / unit
    found = orbit.derivatives()
    by = np.array([float(orbit.given[key]) for key in found.by])
    relative = [found.unknowns[key] * by / orbit.unknowns[key] for key in orbit.unknowns]
    branch = ns.continue_orbit(orbit, "T", (period, 1.01 * period), step=0.5)
    return np.concatenate([*relative, branch.quantity("energy")[[0, -1]] / unit**2])


READ = [
    (of_orbit_by_kernels, 1e-8),
    *((of_equilibria, 1e-12), (of_starts_and_ends, 1e-12)),
    *((of_design, 1e-6), (of_section_map, 1e-6)),
]


@pytest.mark.parametrize(
    ("read", "within", "of"),
    [
        *((*each, of) for each in READ for of in (SMALL, *UNITS)),
        (of_region, 1e-6, UNITS[1]),  # whose boxes have powers of two as their sides
    ],
)
def test_what_is_found_is_the_same_in_all_units(read, within, of):
    np.testing.assert_allclose(read(*of), read(1, 1, 1), rtol=within, atol=within)


@pytest.mark.parametrize("units", [(1, 1, 1), SMALL, UNITS[1]], ids=str)
def test_a_peak_on_both_sides_has_no_derivative_by_what_breaks_the_tie(units):
    """A load moves the peak at the one stop away from zero, at the other towards it."""
    orbit = between_stops(*units)
    value, by_frequency = orbit.derivatives("w").quantity("peak:x")
    assert float(value) > float(units[0]) / 2
    assert np.isfinite(by_frequency).all()
    with pytest.raises(ns.InputError, match="change differently"):
        orbit.derivatives("load").quantity("peak:x")
