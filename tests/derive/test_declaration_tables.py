"""Rows, fields, resets and modes as the kernels give them, against the declarations."""

from functools import cache

import numpy as np
import pytest
import sympy as sp
from numpy.testing import assert_allclose, assert_array_equal

from nonsmooth.derive.systems import SYSTEMS, declaration
from nonsmooth.runtime.model.kernels import load_system
from nonsmooth.runtime.model.piecewise import numbers_at, piecewise_at

NAMES = list(SYSTEMS)


def points(name, count=4):
    """Random parameters inside their domains."""
    random = np.random.default_rng(sum(map(ord, name)))
    found = []
    for _ in range(count):
        values = {p.name: random.uniform(0.2, 0.9) for p in load_system(name).parameters}
        for mass in "12" if "ur1" in values else "":
            values[f"ur{mass}"] = values[f"us{mass}"] + random.uniform(0, 1)
        found.append(values)
    return found


def at(name, values):
    kernels = load_system(name)
    return piecewise_at(kernels, np.array([values[p.name] for p in kernels.parameters]))


def numbers(name, expressions, values):
    """Affine functions (gradient, constant) of the states, in floats."""
    return np.array([affine(name, sp.sympify(e), tuple(values.items())) for e in expressions])


@cache
def affine(name, expression, values):
    """The gradient and the constant of one function, which many transitions have."""
    system, known = declaration(name).system, dict(values)
    substitution = {p.symbol: known[p.name] for p in system.parameters}
    zero = dict.fromkeys(system.states, 0)
    return [
        *(float(sp.diff(expression, state).subs(substitution)) for state in system.states),
        float(expression.subs(zero).subs(substitution)),
    ]


def check_rows(name, found, declared, values):
    """Rows of a table, given with the functions that are declared, are these functions."""
    rows, functions = zip(*declared, strict=True)
    wanted = numbers(name, functions, values)
    assert_allclose(found.rows[list(rows)], wanted, rtol=1e-14, atol=1e-15)


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.usefixtures("backend")
def test_fields_boundaries_constraints_and_contacts_are_the_declared_ones(name):
    system, structure, declared = declaration(name).system, at(name, points(name)[0]).structure, []
    states, size, fields = system.states, len(system.states) // 2, []
    assert [*structure.configurations] == [c.name for c in system.configurations]
    for place, configuration in enumerate(system.configurations):
        held = configuration.dynamics.held
        functions = [states[size + states.index(x)] - velocity for x, velocity in held.items()]
        functions += configuration.constraints
        declared += zip(structure.constraints[place], functions, strict=True)
        assert structure.held[place] == tuple(map(states.index, held))
        matrix, offset = configuration.dynamics.field(states)
        fields.append(matrix * sp.Matrix(states) + offset)
        for shape, boundary in zip(
            structure.boundaries[place], configuration.boundaries, strict=True
        ):
            reached = boundary.acts_when == "reached"
            assert (shape.name, shape.reached) == (boundary.name, reached)
            declared.append((shape.row, boundary.function))
    for shape, contact in zip(structure.contacts, system.contacts, strict=True):
        assert shape.name == contact.name
        forces = {structure.configurations[c]: row for c, row in shape.forces.items()}
        assert forces.keys() == contact.forces.keys()
        declared += [(shape.velocity, contact.velocity), (shape.surface, contact.surface)]
        declared += [(row, contact.forces[where]) for where, row in forces.items()]
    for values in points(name):
        found = at(name, values)
        check_rows(name, found, declared, values)
        for field, rates in zip(found.fields, fields, strict=True):
            assert_allclose(field, numbers(name, rates, values), rtol=1e-14, atol=1e-15)


@pytest.mark.parametrize("name", NAMES)
def test_numbers_of_many_points_are_those_of_each(name):
    kernels = load_system(name)
    grid = np.array([[v[p.name] for p in kernels.parameters] for v in points(name, 5)])
    (many,) = numbers_at(kernels, grid)
    for row, point in zip(many.flat, grid, strict=True):
        one = piecewise_at(kernels, point)
        parts = (one.fields, one.rows, one.resets, *one.exponents, *one.flows)
        assert_array_equal(row, np.concatenate([p.ravel() for p in parts]))
