"""Beams of finite elements for tests."""

import numpy as np
from scipy.sparse import coo_array


def beam(elements, length=1.0, bending=1.0, mass_per_length=1.0):
    """Mass and stiffness (sparse) of a free Euler-Bernoulli beam, Hermite elements.

    Coordinates: displacement and slope of each node, from left to right.
    """
    h = length / elements
    stiffness = (
        bending
        / h**3
        * np.array(
            [
                [12, 6 * h, -12, 6 * h],
                [6 * h, 4 * h * h, -6 * h, 2 * h * h],
                [-12, -6 * h, 12, -6 * h],
                [6 * h, 2 * h * h, -6 * h, 4 * h * h],
            ]
        )
    )
    mass = (
        mass_per_length
        * h
        / 420
        * np.array(
            [
                [156, 22 * h, 54, -13 * h],
                [22 * h, 4 * h * h, 13 * h, -3 * h * h],
                [54, 13 * h, 156, -22 * h],
                [-13 * h, -3 * h * h, -22 * h, 4 * h * h],
            ]
        )
    )
    size = 2 * (elements + 1)
    places = 2 * np.arange(elements)[:, None] + np.arange(4)
    rows = np.repeat(places, 4, axis=1).ravel()
    columns = np.tile(places, (1, 4)).ravel()

    def assembled(local):
        values = np.tile(local.ravel(), elements)
        return coo_array((values, (rows, columns)), shape=(size, size)).tocsc()

    return assembled(mass), assembled(stiffness)


def cantilever(elements, **data):
    """The same, clamped on the left."""
    mass, stiffness = beam(elements, **data)
    return mass[2:, 2:], stiffness[2:, 2:]
