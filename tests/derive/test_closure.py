"""A conservative orbit of given period, without its symmetry: one closure is redundant."""

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp

from nonsmooth import solve
from nonsmooth.derive import DerivationError, Reference, derive_equations
from nonsmooth.runtime.model.loading.declared import declaration_in
from tests.declared import rigid_stop
from tests.derive.test_equations import MP, Derived
from tests.places import GALLERY

DATA = {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "T": 2 * MP.pi}
GUESS = {"y": "0.162", "u": "-0.372", "w": "0"}


def itinerary(guess):
    """The rigid orbit without its reversor, r = 1."""
    reference = Reference(rigid_stop.one_impact.reference.parameters, guess)
    plain = replace(rigid_stop.one_impact, reversor={}, reference=reference)
    return plain.specialised({rigid_stop.r: sp.Integer(1)})


def test_the_closure_along_the_steepest_energy_is_dropped():
    """At the orbit that the half-period conditions give; dE/dw vanishes there."""
    derived = Derived(itinerary(GUESS))
    assert [meaning for meaning, _ in derived.orbit.equations] == [
        *("first-reaches-stop ends free", "y returns", "w returns")
    ]
    found = {"w": 0.0, **solve("rigid-stop/one-impact").unknowns}
    at = [MP.mpf(found[str(u)]) for u in derived.orbit.unknowns]
    residual, jacobian = (
        np.array(derived.run(name, [MP.mpf(DATA[n]) for n in derived.names], at), dtype=float)
        for name in ("residual", "jacobian")
    )
    assert np.abs(residual).max() < 1e-14
    assert np.linalg.cond(jacobian) < 10


def test_without_a_whole_reference_it_is_refused():
    with pytest.raises(DerivationError, match="needs a reference with values of all"):
        derive_equations(itinerary({"y": "0.162"}))


def test_a_section_keeps_the_constraints_of_the_last_phase():
    """A pad that is dragged along starts with the belt's velocity: one state less is unknown."""
    itinerary = declaration_in(GALLERY / "brake_pad.py").orbits[-1]
    section = derive_equations(itinerary).chain.section
    (constraint,) = itinerary.system.configuration("stick").constraints
    row, constant = itinerary.system.gradient(constraint)
    assert (row * section.embedding).is_zero_matrix
    assert sp.simplify((row * section.constant)[0] + constant) == 0
    # what is left of x, y, their velocities and the phase: y breaks the pad loose at one x
    assert [str(itinerary.system.states[p]) for p in section.places] == ["y", "v_y", "c1", "s1"]
