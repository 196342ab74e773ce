"""Forced orbits: their period, their reduction and what is refused, against another route."""

import mpmath
import pytest
import sympy as sp

from nonsmooth.derive import (
    DerivationError,
    Itinerary,
    Reference,
    RigidStop,
    derive_equations,
)
from nonsmooth.derive.equations.program import evaluate
from tests.derive.test_equations import MP, Derived, check_jacobians
from tests.one_mass import one_mass

zeta, Omega, gap, r = sp.symbols("zeta Omega gap r")
DATA = {"zeta": "0.05", "Omega": "2", "gap": "0", "r": "0.8"}


def struck(reference, forces=None):
    """One damped mass that strikes a stop once."""
    stop = RigidStop("x", at=gap, restitution=r, name="stop")
    system = one_mass("struck", stop, forces=forces or {Omega: 1}, damping=2 * zeta)
    phases = [("free", "stop-reaches-stop", "T")]
    return Itinerary("one-impact", system, phases, reference=reference)


@pytest.fixture(scope="module")
def one_impact():
    return Derived(struck(Reference(DATA, {"T": "3.1"})))


def roots_of(equations, texts):
    """Both starts, by the root that the reduction tells, in 30 digits."""
    values = {s: sp.Rational(texts[str(s)]) for s in equations.parameters}
    for symbol, expression in equations.spectrum.entries:
        values[symbol] = expression.xreplace(values).evalf(30)
    return evaluate(equations.reduction.stages, equations.reduction.roots, values, digits=30)


def numbers(derived, texts):
    return [MP.mpf(texts[name]) for name in derived.names]


@pytest.mark.parametrize(("zeta", "frequency"), [("0", "1"), ("1", "2"), ("0.05", "2")])
def test_derivatives_where_eigenvalues_meet(one_impact, zeta, frequency):
    """In resonance without damping, and at critical damping, of whatever is no orbit."""
    run, values = one_impact.run, numbers(one_impact, DATA | {"zeta": zeta, "Omega": frequency})
    at = [MP.mpf(k + 2) / 3 for k in range(len(one_impact.orbit.unknowns))]
    check_jacobians(run, values, at)


@pytest.mark.parametrize(
    "texts", [DATA, {"zeta": "0.3", "Omega": "1.7", "gap": "-0.2", "r": "0.6"}]
)
def test_the_quadratic_is_that_of_the_impulse_response(one_impact, texts):
    with mpmath.workdps(30):
        z, w, g, e = (mpmath.mpf(texts[n]) for n in DATA)
        period, nu = 2 * mpmath.pi / w, mpmath.sqrt(1 - z**2)
        h = mpmath.exp(-z * period) * mpmath.sin(nu * period) / nu
        slope = mpmath.exp(-z * period) * mpmath.cos(nu * period) - z * h
        decay = mpmath.exp(-2 * z * period)
        delta = 1 - 2 * slope - 2 * z * h + decay
        kappa = slope * (1 - e) + 2 * z * h - 1 + e * decay
        size = (1 - w**2) ** 2 + 4 * z**2 * w**2
        quadratic = [
            ((1 + e) * h) ** 2 + (kappa / w) ** 2,
            2 * g * delta * (1 + e) * h,
            (g * delta) ** 2 - delta**2 / size,
        ]
        for root in roots_of(one_impact.orbit, texts):
            speed = mpmath.mpf(-root) / e
            assert abs(mpmath.polyval(quadratic, speed)) < 1e-20
            values = numbers(one_impact, texts)
            unknowns = one_impact.run("unknowns", values, [MP.mpf(root)])
            assert max(map(abs, one_impact.run("residual", values, unknowns))) < 1e-26


def test_two_harmonics_share_one_phase():
    texts = {**DATA, "gap": "0.1"}
    forces = {Omega: 1, 2 * Omega: "1/3"}
    derived = Derived(struck(Reference(texts, {"T": "3.1"}), forces))
    equations = derived.orbit
    assert equations.chain.forcing.multiples == (1, 2)
    assert [*map(str, equations.chain.coordinates)] == ["v0", "phase"]
    guess = equations.itinerary.reference.guess
    names = [*map(str, equations.unknowns)]
    found = derived.solved(numbers(derived, texts), [guess[name] for name in names])
    at = dict(zip(names, found, strict=True))
    first = complex(at["c10"], at["s10"])
    assert complex(at["c20"], at["s20"]) == pytest.approx(first**2, abs=1e-14)


def test_what_has_no_period_of_its_own_is_refused():
    with pytest.raises(DerivationError, match="no reference tells how many periods"):
        derive_equations(struck(None))
    forces = {Omega: 1, sp.Symbol("w"): 1}
    with pytest.raises(DerivationError, match="no common period"):
        derive_equations(struck(Reference({**DATA, "w": "3"}, {"T": "3.1"}), forces))


def test_the_number_of_periods_is_that_of_the_reference():
    equations = derive_equations(struck(Reference({**DATA, "Omega": "4.4"}, {"T": "2.856"})))
    assert equations.chain.forcing.turns == 2
