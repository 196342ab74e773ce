"""A branch tells of its points what the orbits there tell, by kernels and by tables."""

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.runtime.orbits.equations import equations_of
from tests.handmade import DATA, MIRROR, two_stops
from tests.places import GALLERY

# an orbit with what is given, and what a branch follows on both sides of it
STICK, SYMMETRIC = "dry-friction/global-stick", "dry-friction/symmetric"
NAMES = {
    STICK: ({"us1": 1, "us2": 1}, "V"),
    SYMMETRIC: ({}, "V"),
    "rigid-stop/one-impact": ({}, "k2"),
    "elastic-stop/one-contact": ({}, "k3"),
}
DECLARED = {
    "half": ({}, "F"),  # which a symmetry closes
    f"{GALLERY}/backlash_gear.py:rattle": ({}, "k"),
}


def records(name):
    """An orbit by its kernels, if it has some, and by the tables of its system."""
    if name == "half":
        right = [("free", "reaches-right")]
        return [ns.solve(two_stops(), DATA, [1.85], itinerary=right, symmetry=MIRROR)]
    orbit = ns.solve(name, (NAMES | DECLARED)[name][0])
    return [orbit, orbit.problem.by_tables(orbit)] if name in NAMES else [orbit]


def branch_of(orbit, parameter, width=0.01):
    value = float(orbit.given[parameter])
    return ns.continue_orbit(orbit, parameter, (value * (1 - width), value * (1 + width)), points=4)


@pytest.mark.parametrize("name", [*NAMES, *DECLARED])
def test_a_branch_tells_of_each_point_what_its_orbit_tells(name):
    parameter = (NAMES | DECLARED)[name][1]
    for orbit in records(name):
        branch = branch_of(orbit, parameter)
        for place, value in enumerate(branch.parameter_values.tolist()):
            found = branch.orbit_at(place)
            assert found.converged
            assert float(found.given[parameter]) == value
            assert branch.period[place] == pytest.approx(found.period, rel=1e-9)
            assert branch.trace[place] == pytest.approx(found.trace, rel=1e-9, abs=1e-9)
            assert branch.admissible[place] == (found.admissibility.verdict is not False)
            sizes = np.sort(abs(branch.multipliers[place]))
            others = [abs(complex(m.real, m.imaginary)) for m in found.stability.multipliers
                      if not m.trivial]  # fmt: skip
            assert sizes == pytest.approx(np.sort(others)[-len(sizes) :], abs=1e-6)


def test_a_branch_is_admissible_where_given_forces_hold_its_orbits():
    """The sliding force of the first mass, which is given, is enough on one side alone."""
    fast = {"chi": 0.63, "eta": 0.66, "V": 3.45, "e1": 3.16, "e2": 0.82}
    bounds = ns.solve(STICK, {name: [value] for name, value in fast.items()}).bounds
    held = {"us1": bounds["us1"].item(), "us2": bounds["us2"].item() + 1}
    branch = branch_of(ns.solve(STICK, fast | held | {"us1": held["us1"] + 1e-6}), "V")
    told = [branch.orbit_at(k).admissibility.verdict for k in range(len(branch))]
    assert branch.admissible.tolist() == told
    assert {*told} == {True, False}


@pytest.mark.parametrize("name", [*NAMES, f"{GALLERY}/backlash_gear.py:rattle"])
def test_linearised_equations_tell_how_an_orbit_moves(name):
    """By the implicit function theorem; sixty digits hold an orbit's derivatives elsewhere."""
    for orbit in records(name):
        by = (NAMES | DECLARED)[name][1]
        equations = equations_of(orbit, by)
        missed, jacobian = equations.equations(equations.first)
        assert missed == pytest.approx(0, abs=1e-9)
        moved, *_ = np.linalg.lstsq(jacobian[:, :-1], -jacobian[:, -1], rcond=None)
        rates = orbit.derivatives(by).unknowns
        wanted = np.array([rates[unknown][0] for unknown in equations.unknowns])
        assert moved == pytest.approx(wanted, rel=1e-8, abs=1e-8)


def test_a_point_of_a_family_whose_phases_do_not_last_is_no_motion():
    for orbit in records(STICK):
        equations = equations_of(orbit)
        short = [-1.0 if name in equations.dwell_names else 1.0 for name in equations.unknowns]
        points = np.stack([equations.first, equations.first * short])
        assert equations.admissible(points).tolist() == [True, False]
