"""Constants of a declaration are exact: as parameters of the same values, in every arithmetic."""

import random
import re

import mpmath
import numpy as np
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import Friction, Itinerary, Parameter, RigidStop, oscillator
from nonsmooth.derive.codegen.emit import emit_system
from nonsmooth.derive.declaration.real_numbers import number_text
from nonsmooth.runtime.core.values import parse
from nonsmooth.runtime.model.piecewise import piecewise
from tests.certified import believed, content_of
from tests.one_mass import one_mass

X = sp.Symbol("x")
POOL = [
    sp.pi, sp.sqrt(2), sp.E, sp.cbrt(2), sp.GoldenRatio, sp.cos(sp.pi / 7), sp.log(2), sp.sqrt(8),
    sp.CRootOf(X**5 - X - 1, 0), sp.sqrt(1 + sp.sqrt(2)), sp.tan(sp.pi / 9), sp.cos(2 * sp.pi / 7),
    sp.sqrt(2) + sp.sqrt(3), sp.atan(2),
]  # fmt: skip
BALANCE = {"k": 1.5, "d": 0.1, "w": 2.5, "f": 1.2, "gap": 0.1, "r": 0.7}


def drawn(rng):
    """Constants of a forced oscillator near a stop, each about as large as it should be."""
    found = {}
    for name, size in BALANCE.items():
        number = rng.choice(POOL)
        share = sp.Rational(round(100 * size * rng.uniform(0.8, 1.2) / float(number)), 100)
        found[name] = (share or sp.Rational(1, 100)) * number
    return found


def stopped(numbers, parameters=()):
    return one_mass(
        "stopped",
        RigidStop("x", numbers["gap"], numbers["r"], name="stop"),
        stiffness=numbers["k"],
        damping=numbers["d"],
        forces={numbers["w"]: numbers["f"]},
        parameters=parameters,
    )


def both(constants, left=()):
    """A system with constants, the same with parameters, and texts of their values."""
    lower = {"gap": -sp.oo}
    parameters = {name: Parameter(name, name, lower=lower.get(name, 0)) for name in constants}
    symbols = {name: parameter.symbol for name, parameter in parameters.items()}
    own = {name: symbols[name] if name in left else number for name, number in constants.items()}
    texts = {
        name: number_text(Parameter(name, name, number).lower) for name, number in constants.items()
    }
    declared = stopped(own, [parameters[name] for name in left])
    return declared, stopped(symbols, list(parameters.values())), texts


def decimal(text):
    return str(mpmath.nstr(parse(text).mpf(75), 70))


@pytest.mark.slow
@pytest.mark.parametrize("seed", [0, 1, 2])
def test_constants_are_parameters_of_their_values(seed, tmp_path):
    declared, over, texts = both(drawn(random.Random(seed)))
    decimals = {name: decimal(text) for name, text in texts.items()}
    one, two = piecewise(declared, {}), piecewise(over, texts)
    for mine, others in zip(one.numbers, two.numbers, strict=True):
        np.testing.assert_array_max_ulp(mine, others, 2)
    start = {"x": -0.5, "v": 0}
    motion = ns.simulate(declared, {}, start, transitions=600)
    known = ns.itinerary_of(motion)
    orbit, other = (
        ns.solve(system, values, itinerary=known)
        for system, values in ((declared, {}), (over, decimals))
    )
    for arithmetic in ("flint", "mpmath"):
        fine_one, fine_two = (ns.refine(x, 60, arithmetic=arithmetic) for x in (orbit, other))
        assert abs(fine_one.trace - fine_two.trace) < 1e-58
    saved = tmp_path / "orbit.json"
    fine_one.save(saved)
    assert abs(ns.load(saved).trace - fine_two.trace) < 1e-58
    exactly = ns.solve(over, texts, itinerary=known)
    proofs = [ns.certify(x) for x in (orbit, exactly)]
    assert proofs[0].claims == proofs[1].claims
    assert proofs[0].claims["existence"] == "proved"
    for proof in proofs:
        believed(content_of(proof))
    for name, ball in proofs[0].enclosures.items():
        assert ball.ball.overlaps(proofs[1].enclosures[name].ball)


def test_constants_beside_parameters_of_a_box():
    numbers = {
        "k": sp.Rational(7, 5), "d": 1 / (10 * sp.sqrt(3)), "w": sp.pi, "f": sp.cbrt(2),
        "gap": sp.cos(sp.pi / 7) - 1, "r": sp.GoldenRatio / 2,
    }  # fmt: skip
    declared, over, texts = both(numbers, ("k",))
    known = ns.itinerary_of(
        ns.simulate(declared, {"k": "1.4"}, {"x": -0.5, "v": 0}, transitions=400)
    )
    maps = []
    for number, (system, values) in enumerate(((declared, {"k": "1.4"}), (over, texts))):
        orbit = ns.solve(system, values, itinerary=known)
        maps.append(ns.certify.box(orbit, {"k": ("1.39", "1.41")}))
        content = content_of(maps[-1])
        assert ("constants" in content["declaration"]) == (number == 0)
        believed(content)
    assert maps[0].shares == maps[1].shares
    assert maps[0].shares["proved"] == 1


def test_what_roots_make_zero_is_zero():
    """A belt along an edge of sqrt(3)/2 and 1/2: behind a slip the mass moves with it, exactly."""
    edge = {"x": sp.sqrt(3) / 2, "y": sp.Rational(1, 2)}
    system = oscillator(
        "edge", ["x", "y"], sp.eye(2), sp.diag(2, 3), sp.diag(sp.sqrt(2) / 50, sp.E / 90),
        elements=[Friction(edge, sp.sqrt(2) / 2, 2, sp.pi / 4, name="belt")],
    )  # fmt: skip
    motion = ns.simulate(system, {}, {"x": 0, "y": 0, "v": 3, "v_y": -2}, until=400)
    proof = ns.certify(ns.solve(system, {}, itinerary=ns.itinerary_of(motion)))
    assert set(proof.claims.values()) == {"proved"}, proof.reasons
    believed(content_of(proof))


def test_kernels_and_documents_hold_the_numbers():
    friction = Friction("x", sp.sqrt(3) / 2, sp.sqrt(3), sp.GoldenRatio / 2, name="belt")
    belt = one_mass("belt", friction, mass=sp.sqrt(2), stiffness=sp.pi)
    phases = [("stick", "belt-breaks-forward", "ts"), ("slip", "belt-reaches-belt", "tau")]
    orbit = Itinerary("stick-slip", belt, phases)
    emitted = emit_system(belt, [orbit], "test")
    assert not emitted.underived
    printed = {float(x) for x in re.findall(r"-?\d+\.\d+(?:e-?\d+)?", emitted.files["belt.c"])}
    frequency = sp.sqrt(sp.pi / sp.sqrt(2))
    assert float(parse(number_text(frequency))) in printed
    document = emitted.files["belt.md"]
    for formula in (r"\sqrt{2} x'' + \pi x &= \frac{\sqrt{3}}{2}", r"$\pi x - \sqrt{3} < 0$"):
        assert formula in document
    guess = {"ts": 0.7, "tau": 3.6}
    found = ns.solve(orbit, {}, guess=guess)
    proof = ns.certify(found)
    assert set(proof.claims.values()) == {"proved"}
    assert {"pi", "sqrt(2)", "sqrt(3)"} <= {*proof.declaration["constants"]}
