"""Central differences, against which derivatives are held."""

from dataclasses import replace
from fractions import Fraction

import numpy as np

import nonsmooth as ns
from nonsmooth.runtime.core.values import as_value


def in_digits(orbit, parameter, quantities, digits=60):
    """Rates of the quantities of an orbit of many digits by one of its given parameters."""
    sides = []
    for step in (Fraction(1, 10**18), -Fraction(1, 10**18)):
        value = as_value(orbit.given[parameter].exact + step)
        moved = replace(orbit, given={**orbit.given, parameter: value})
        sides.append(quantities(ns.refine(moved, digits)))
    return [(above - below) * 10**18 / 2 for above, below in zip(*sides, strict=True)]


def in_doubles(function, point, step=1e-6):
    """The matrix of a function of a point, a column for each of its entries."""
    steps = step * np.eye(len(point))
    columns = [(function(point + h) - function(point - h)) / (2 * step) for h in steps]
    return np.stack(columns, axis=-1)
