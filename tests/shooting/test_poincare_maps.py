"""Sec. 4 for every orbit: saltation matrices, monodromy and Poincare map by a second route.

The second route composes matrix exponentials, root finding and resets from the declaration.
"""

from functools import cache

import mpmath
import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.optimize import linear_sum_assignment

from nonsmooth import refine, solve
from tests.declared import RANGES, Declared, random_points, single

every_orbit = pytest.mark.parametrize("name", RANGES)


@cache
def orbits(name):
    """The orbit at its reference point, and admissible ones nearby."""
    points, found = random_points(name, 51, 40), [solve(name)]
    many = solve(name, points)
    for i in np.flatnonzero(many.admissible)[:4]:
        found.append(single(many, i))
    assert len(found) == 5
    return tuple(found)


def multipliers(orbit):
    return np.array([complex(m.real, m.imaginary) for m in orbit.stability.multipliers])


def without_one(eigenvalues):
    """All but the eigenvalue nearest to 1, which belongs to the motion itself."""
    return np.delete(eigenvalues, np.argmin(abs(eigenvalues - 1)))


def distance(first, second):
    """Largest difference of two sets of numbers, paired as well as can be."""
    differences = abs(np.asarray(first)[:, None] - np.asarray(second)[None])
    return differences[linear_sum_assignment(differences)].max()


@every_orbit
def test_the_orbit_closes_under_exponentials_and_resets(name):
    for orbit in orbits(name):
        declared = Declared(orbit)
        scale = max(1.0, abs(declared.start).max())
        assert declared.missed < 1e-11 * scale
        following = np.roll(orbit.states, -1, axis=0)
        for index, (piece, _, end) in enumerate(declared.steps):
            behind = piece.jump @ end
            assert_allclose(following[index], behind[:-1, 0], atol=1e-11 * scale)


@every_orbit
def test_saltation_matrices_are_those_of_the_declaration(name):
    for orbit in orbits(name):
        expected = Declared(orbit).saltations()
        assert orbit.saltations.shape == (len(orbit.dwell_times), 4, 4)
        for found, matrix in zip(orbit.saltations, expected, strict=True):
            assert_allclose(found, matrix, rtol=1e-9, atol=1e-9)


@every_orbit
def test_the_monodromy_matrix_is_the_product(name):
    for orbit in orbits(name):
        declared = Declared(orbit)
        expected = declared.monodromy()
        scale = abs(expected).max()
        assert_allclose(orbit.monodromy, expected, atol=1e-10 * scale)
        field = (declared.pieces[0].field @ declared.start)[:-1]
        assert_allclose(orbit.monodromy @ field, field, atol=1e-9 * scale)


@every_orbit
def test_multipliers_are_its_other_eigenvalues(name):
    for orbit in orbits(name):
        found = without_one(np.linalg.eigvals(Declared(orbit).monodromy()))
        expected = np.zeros(len(found), dtype=complex)
        expected[: len(multipliers(orbit))] = multipliers(orbit)
        # of the defective double one of a conservative orbit half the digits are lost
        assert distance(found, expected) < 1e-5
        if "stop" not in name:
            assert distance(found, expected) < 1e-8 * abs(found).max()
        assert orbit.trace == pytest.approx(np.trace(orbit.monodromy) - 1, abs=1e-9)


@every_orbit
def test_the_section_jacobian_is_that_of_the_simulated_map(name):
    """Fourth-order differences of the map, each phase left where its boundary is."""
    for orbit in orbits(name)[:3]:
        declared = Declared(orbit)
        directions, places = declared.embedding()
        jacobian = orbit.evaluate("poincare_jacobian")
        scale = max(1.0, abs(jacobian).max())
        step = 2e-4
        for column in range(directions.shape[1]):
            direction = np.append(directions[:, column], 0)[:, None]

            def image(k, declared=declared, shift=step * direction):
                return declared.image(declared.start + k * shift)[0]

            slopes = (8 * (image(1) - image(-1)) - (image(2) - image(-2))) / (12 * step)
            assert_allclose(jacobian[:, column], slopes[places, 0], atol=1e-6 * scale)
            # the end of the turn lies in the section again
            assert_allclose(slopes[:-1, 0], directions @ slopes[places, 0], atol=1e-6 * scale)


@every_orbit
def test_matrices_of_many_digits(name):
    orbit = refine(solve(name), 50)
    with mpmath.workdps(80):
        declared = Declared(orbit, precise=True)
        bound = mpmath.mpf(10) ** -47
        for found, expected in zip(orbit.saltations, declared.saltations(), strict=True):
            difference = mpmath.matrix([[mpmath.mpf(e) for e in row] for row in found]) - expected
            assert mpmath.norm(difference, mpmath.inf) < bound
        matrix = mpmath.matrix([[mpmath.mpf(e) for e in row] for row in orbit.monodromy])
        assert mpmath.norm(matrix - declared.monodromy(), mpmath.inf) < bound
        field = (declared.pieces[0].field @ declared.start)[:4]
        assert mpmath.norm(matrix @ field - field, mpmath.inf) < bound
    double = solve(name)
    assert_allclose(np.array(orbit.monodromy, dtype=float), double.monodromy, atol=1e-9)
