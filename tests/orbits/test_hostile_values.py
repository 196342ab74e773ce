"""Hostile values end in an orbit with finite multipliers, a status, or an error of ours.

NumPy's warnings are errors here, as in all tests.
"""

from contextlib import suppress

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.runtime.model.kernels import backend
from tests.two_masses import PHASES, STICKING, SYSTEMS

COUNT = 25 if backend() == "c" else 8
K2 = 5e-20  # the other stiffness is 1
FACTORS = (1, 1.01, 0.5, 2, 0, -1, 1e-8, 1e8, 1e-20, 1e200, 1e-200, 5e-324)
NAMES = (
    "dry-friction/global-stick", "dry-friction/symmetric", "dry-friction/solution-ii",
    "elastic-stop/one-contact", "rigid-stop/one-impact",
)  # fmt: skip


def hostile(values, generator, most=2):
    """Up to so many values by name, each times a hostile factor."""
    count = generator.integers(1, most + 1)
    names = generator.choice([*values], count, replace=False).tolist()
    return {name: float(values[name]) * generator.choice(FACTORS).item() for name in names}


def by_kernels(name, generator):
    known = ns.solve(name)
    given = hostile(known.parameters, generator)
    guess = known.unknowns | hostile(known.unknowns, generator, len(known.unknowns))
    match generator.integers(3):  # without a guess an orbit would be searched for, which takes long
        case 0:
            return ns.solve(name, given, guess, throw=False)
        case 1:
            return ns.solve(name, {parameter: [x, 1.1 * x] for parameter, x in given.items()})
    fixed = hostile(known.unknowns, generator)
    swapped = [*known.parameters][: len(fixed)]
    return ns.solve(name, unknown=swapped, given=fixed, throw=False)


def by_tables(name, generator):
    known = ns.solve(name)
    system, itinerary, guess = name.partition("/")[0], known.itinerary, known.dwell_times
    values = SYSTEMS[system]
    if system == "dry-friction":
        values, itinerary, guess = STICKING, PHASES, [1.02, 2.0, 1.57, 3.28]
    values = {parameter: float(x) for parameter, x in values.items()}
    given = values | hostile(values, generator)
    if generator.integers(2):
        given = {parameter: [x, x, values[parameter]] for parameter, x in given.items()}
        return ns.solve(system, given, guess, itinerary=itinerary, multipliers=True)
    return ns.solve(system, given, guess, itinerary=itinerary, throw=False)


QUESTIONS = [*((by_kernels, name) for name in NAMES), *((by_tables, name) for name in NAMES[::3])]


@pytest.mark.parametrize(("asked", "name"), QUESTIONS)
def test_hostile_values_end_in_an_orbit_a_status_or_an_error_of_ours(asked, name):
    generator, ends = np.random.default_rng(11), set()
    for _ in range(COUNT if asked is by_kernels else 2 * COUNT):
        try:
            found = asked(name, generator)
        except ns.NonsmoothError:
            ends.add("error")
            continue
        ends.add("orbit" if np.any(found.converged) else "status")
        if np.ndim(found.status):
            assert np.isfinite(found.trace[found.converged]).all()
            continue
        assert found.states.shape == found.saltations.shape[:2]
        if found.converged:
            assert np.isfinite(found.multipliers).all()
            assert np.isfinite(found.poincare_jacobian).all()
            found.derivatives(one_sided=True)
        elif found.problem.derived:
            with pytest.raises(ns.InputError, match="there is no orbit"):
                found.to_json()
            verdict = False  # that of times that are negative is told
            with suppress(ns.InputError):
                verdict = found.admissibility.verdict
            assert verdict is False
    assert len(ends) > 1


def test_a_point_whose_map_is_infinite_is_judged_as_one_of_many():
    one, many = (ns.solve("rigid-stop/one-impact", {"k2": x}, throw=False) for x in (K2, [K2]))
    assert one.status == many.status[0] != 0
    with pytest.raises(ns.NoConvergence, match="beyond double precision"):
        ns.solve("rigid-stop/one-impact", {"k2": K2})
    assert not np.isfinite(one.poincare_jacobian).all()


def test_derivatives_that_doubles_do_not_hold_are_not_finite():
    far = ns.solve("dry-friction/global-stick", {"V": 1e-200, "e2": 0.24})
    assert not np.isfinite(far.derivatives("V").trace).any()
