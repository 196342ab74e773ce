"""A conservative orbit of given period, without its symmetry: one closure is redundant."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp

from nonsmooth import solve
from nonsmooth.derive import DerivationError, EquationSystem, Itinerary, Reference, derive_equations
from nonsmooth.derive.equations.program import evaluate
from nonsmooth.derive.systems import rigid_stop
from nonsmooth.runtime.model.loading.declared import declaration_in
from tests.places import GALLERY

DATA = {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "T": 2 * sp.pi}
GUESS = {"y": "0.162", "u": "-0.372", "w": "0"}


def itinerary(guess: dict[str, str]) -> Itinerary:
    """The rigid orbit without its reversor, r = 1."""
    reference = Reference(rigid_stop.one_impact.reference.parameters, guess)
    plain = replace(rigid_stop.one_impact, reversor={}, reference=reference)
    return plain.specialised({rigid_stop.r: sp.Integer(1)})


def at_the_orbit(equations: EquationSystem) -> tuple[np.ndarray, np.ndarray]:
    """Residual and Jacobian at the orbit that the half-period conditions give."""
    found = solve("rigid-stop/one-impact").unknowns
    known = {p: sp.sympify(DATA[str(p)]) for p in equations.parameters}
    for symbol, expression in equations.spectrum.entries:
        known[symbol] = sp.N(expression.xreplace(known), 30)
    known |= {u: sp.Float(found.get(str(u), 0.0)) for u in equations.unknowns}
    stages, jacobian = equations.jacobian_program
    numbers = evaluate((*equations.stages, *stages), [*equations.residual, *jacobian], known)
    size = len(equations.unknowns)
    values = np.array([float(sp.N(n, 20)) for n in numbers])
    return values[:size], values[size:].reshape(size, size)


def test_the_closure_along_the_steepest_energy_is_dropped() -> None:
    equations = derive_equations(itinerary(GUESS))
    assert [meaning for meaning, _ in equations.equations] == [
        *("first-reaches-stop ends free", "y returns", "w returns")
    ]
    residual, jacobian = at_the_orbit(equations)
    assert np.abs(residual).max() < 1e-14
    assert np.linalg.cond(jacobian) < 10


def test_another_choice_is_singular() -> None:
    equations = derive_equations(itinerary(GUESS))
    # dE/dw vanishes at the orbit: without its closure nothing determines w
    chain, (q, place) = equations.chain, (equations.unknowns[1], 2)
    closures = (equations.equations[1], ("u returns", chain.end[place] - q))
    _, jacobian = at_the_orbit(replace(equations, equations=(equations.equations[0], *closures)))
    assert np.linalg.cond(jacobian) > 1e8


def test_without_a_reference_or_for_a_lossy_impact_it_is_refused() -> None:
    with pytest.raises(DerivationError, match="needs a reference with values of all"):
        derive_equations(itinerary({"y": "0.162"}))
    lossy = replace(rigid_stop.one_impact, reversor={})
    with pytest.raises(DerivationError, match="4 equations for 3 unknowns"):
        derive_equations(lossy)


def test_a_section_keeps_the_constraints_of_the_last_phase() -> None:
    """A pad that is dragged along starts with the belt's velocity: one state less is unknown."""
    itinerary = declaration_in(GALLERY / "brake_pad.py").orbits[-1]
    section = derive_equations(itinerary).chain.section
    (constraint,) = itinerary.system.configuration("stick").constraints
    row, constant = itinerary.system.gradient(constraint)
    assert (row * section.embedding).is_zero_matrix
    assert sp.simplify((row * section.constant)[0] + constant) == 0
    # what is left of x, y, their velocities and the phase: y breaks the pad loose at one x
    assert [str(itinerary.system.states[p]) for p in section.places] == ["y", "v_y", "c1", "s1"]
