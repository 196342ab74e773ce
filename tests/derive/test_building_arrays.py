"""Oscillators of NumPy arrays and SciPy sparse matrices: exact, quick, and refused in one line."""

from fractions import Fraction
from itertools import product

import numpy as np
import pytest
import scipy.sparse
import sympy as sp

from nonsmooth.derive import (
    DeclarationError,
    Harmonic,
    RigidStop,
    SoftStop,
    oscillator,
)

NAMES = ["x1", "x2", "x3"]
MASS = np.array([[2.0, 0.1, 0.0], [0.1, 1.0, 0.0], [0.0, 0.0, 3.0]])
STIFFNESS = np.array([[2.0, -0.7, 0.0], [-0.7, 1.1, -0.3], [0.0, -0.3, 0.9]])


def fractions(matrix):
    return sp.Matrix(
        3, 3, lambda i, j: sp.Rational(*Fraction(float(matrix[i, j])).as_integer_ratio())
    )


@pytest.mark.parametrize(
    "kind", [np.asarray, scipy.sparse.csr_array, scipy.sparse.coo_matrix, scipy.sparse.csc_matrix]
)
def test_arrays_are_binary_fractions(kind):
    system = oscillator(
        "s", NAMES, kind(MASS), kind(STIFFNESS), kind(0.1 * STIFFNESS),
        elements=[RigidStop("x1", at=1, restitution=0.5)],
    )  # fmt: skip
    dynamics = system.configuration("free").dynamics
    assert dynamics.mass == fractions(MASS)
    assert dynamics.stiffness == fractions(STIFFNESS)
    assert dynamics.damping == fractions(0.1 * STIFFNESS)
    # a list is as it prints
    listed = oscillator("s", NAMES, MASS.tolist(), STIFFNESS.tolist())
    assert listed.configuration("free").dynamics.mass[0, 1] == sp.Rational(1, 10)


def test_sparse_entries_given_twice_are_added():
    places = ([0, 0, 1, 2], [0, 0, 1, 2])
    mass = scipy.sparse.coo_array(([1.0, 1.0, 2.0, 3.0], places), shape=(3, 3))
    system = oscillator("s", NAMES, mass, STIFFNESS)
    assert system.configuration("free").dynamics.mass == sp.diag(2, 2, 3)
    assert mass.nnz == 4  # the user's matrix is left alone


def test_directions_and_forces_may_be_vectors():
    def of(direction, force):
        return oscillator(
            "s", NAMES, MASS, STIFFNESS, load=force,
            forcing=[Harmonic(2, cosine=force)],
            elements=[
                RigidStop(direction, at=1, restitution=0.5, name="stop"),
                SoftStop(direction, at=2, stiffness=4, name="pad"),
            ],
        )  # fmt: skip

    by_names = of({"x1": 1, "x3": sp.Rational(1, 4)}, {"x2": sp.Rational(1, 2)})
    assert by_names.fingerprint() == of([1, 0, 0.25], [0, 0.5, 0]).fingerprint()
    arrays = of(np.array([1, 0, 0.25]), np.array([0, 0.5, 0]))
    assert by_names.fingerprint() == arrays.fingerprint()


def test_masses_are_taken_if_they_are_positive_definite_exactly():
    random = np.random.default_rng(5)
    for size, gap in product((1, 2, 5, 9), (1e-3, 1e-9, 1e-17, -1e-17, -1e-3, 0.0)):
        basis, _ = np.linalg.qr(random.standard_normal((size, size)))
        values = np.linspace(1, 2, size)
        values[0] = gap
        dense = basis @ np.diag(values) @ basis.T
        dense = (dense + dense.T) / 2
        exact = sp.Matrix(size, size, [sp.Rational(value) for value in dense.ravel().tolist()])
        definite = min(exact[:k, :k].det() for k in range(1, size + 1)) > 0
        names = [f"x{i}" for i in range(size)]
        if definite:
            (free,) = oscillator("s", names, dense, np.eye(size)).configurations
            matrix, _ = free.dynamics.field(sp.symbols(f"y:{2 * size}"))
            assert exact * matrix[size:, :size] == -sp.eye(size)
        else:
            with pytest.raises(DeclarationError, match="mass is not positive definite"):
                oscillator("s", names, dense, np.eye(size))
