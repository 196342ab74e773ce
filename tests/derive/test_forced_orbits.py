"""Forced orbits: their period, their reduction and what is refused, against another route."""

from __future__ import annotations

import mpmath
import pytest
import sympy as sp

from nonsmooth.derive import (
    DerivationError,
    Harmonic,
    Itinerary,
    Reference,
    RigidStop,
    derive_equations,
    oscillator,
)
from nonsmooth.derive.codegen.any_arithmetic import python_kernel
from nonsmooth.derive.codegen.kernels import orbit_kernels, spectrum_kernel
from nonsmooth.derive.codegen.naming import python_function
from nonsmooth.derive.equations.program import evaluate
from nonsmooth.runtime.core.arithmetic import Mpmath

zeta, Omega, gap, r = sp.symbols("zeta Omega gap r")
DATA = {"zeta": "0.05", "Omega": "2", "gap": "0", "r": "0.8"}


def struck(reference, forcing=None):
    """One damped mass that strikes a stop once."""
    system = oscillator(
        "struck",
        ["x"],
        mass=[[1]],
        stiffness=[[1]],
        damping=[[2 * zeta]],
        forcing=forcing or [Harmonic(Omega, cosine=[1])],
        elements=[RigidStop("x", at=gap, restitution=r, name="stop")],
    )
    phases = [("free", "stop-reaches-stop", "T")]
    return Itinerary("one-impact", system, phases, reference=reference)


@pytest.fixture(scope="module")
def one_impact():
    return derive_equations(struck(Reference(DATA, {"T": "3.1"})))


def numbers(equations, texts, **unknowns):
    """Values of parameters, spectrum and unknowns, exact parameters and 30 digits else."""
    values = {s: sp.Rational(texts[str(s)]) for s in equations.parameters}
    for symbol, expression in equations.spectrum.entries:
        values[symbol] = expression.xreplace(values).evalf(30)
    return values | {u: unknowns[str(u)] for u in equations.unknowns if str(u) in unknowns}


def test_the_velocity_of_one_impact_is_the_root_of_a_quadratic(one_impact):
    reduction = one_impact.reduction
    assert [str(u) for u in reduction.unknowns] == ["v0"]
    assert [str(e.unknown) for e in reduction.eliminations] == ["T", "c10", "s10"]
    values = numbers(one_impact, DATA)
    roots = evaluate(reduction.stages, reduction.roots, values, digits=30)
    speeds = [float(-root / sp.Rational(DATA["r"])) for root in roots]
    assert max(speeds) == pytest.approx(3.9016492908886392, rel=1e-14)
    (start,) = [root for root, speed in zip(roots, speeds, strict=True) if speed > 0]
    known = values | {reduction.unknowns[0]: start}
    full = evaluate(reduction.stages, one_impact.unknowns, known, digits=30)
    at = values | dict(zip(one_impact.unknowns, full, strict=True))
    assert max(map(abs, evaluate(one_impact.stages, one_impact.residual, at, 30))) < 1e-26
    stages, trace = one_impact.trace_program
    assert float(evaluate(stages, [trace], at, 30)[0]) == pytest.approx(1.36747825761582, rel=1e-14)


@pytest.mark.parametrize(
    "texts", [DATA, {"zeta": "0.3", "Omega": "1.7", "gap": "-0.2", "r": "0.6"}]
)
def test_the_quadratic_is_that_of_the_impulse_response(one_impact, texts):
    values = numbers(one_impact, texts)
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
        for root in evaluate(one_impact.reduction.stages, one_impact.reduction.roots, values, 30):
            speed = mpmath.mpf(-root) / e
            assert abs(mpmath.polyval(quadratic, speed)) < 1e-20


def newton(equations, functions, texts):
    """Reduced unknowns by the printed kernels in 30 digits, and all unknowns."""
    lib, orbit = Mpmath(30), equations.itinerary
    reduced = functions[python_function("reduced", orbit.name)]
    point = [lib.mp.mpf(texts[str(p)]) for p in equations.parameters]
    data = [lib.mp.mpf(texts[str(p)]) for p in equations.spectrum.parameters]
    spectrum, _ = functions[python_function("spectrum", None)](data, lib=lib)
    guess = equations.itinerary.reference.guess
    x = lib.mp.matrix([guess[str(u)] for u in equations.reduction.unknowns])
    for _ in range(12):
        *_, residual, jacobian = reduced(point, spectrum, list(x), lib=lib)
        x -= lib.mp.lu_solve(lib.mp.matrix(jacobian), lib.mp.matrix(residual))
    unknowns, *_ = reduced(point, spectrum, list(x), lib=lib)
    return lib, (point, spectrum, list(unknowns))


def test_two_harmonics_share_one_phase():
    texts = {**DATA, "gap": "0.1"}
    forcing = [Harmonic(Omega, cosine=[1]), Harmonic(2 * Omega, cosine=["1/3"])]
    orbit = struck(Reference(texts, {"T": "3.1"}), forcing)
    equations = derive_equations(orbit)
    assert equations.chain.forcing.multiples == (1, 2)
    assert [*map(str, equations.chain.coordinates)] == ["v0", "phase"]
    functions: dict[str, object] = {}
    exec(python_kernel(spectrum_kernel(equations.spectrum), None), functions)
    for kernel in orbit_kernels(equations):
        exec(python_kernel(kernel, orbit.name), functions)
    lib, point = newton(equations, functions, texts)
    equations_of = functions[python_function("equations", orbit.name)]
    residual = equations_of(*point, lib=lib, outputs=1)
    assert max(map(abs, residual)) < 1e-24
    at = dict(zip(map(str, equations.unknowns), point[-1], strict=True))
    first = complex(at["c10"], at["s10"])
    assert complex(at["c20"], at["s20"]) == pytest.approx(first**2, abs=1e-14)


def test_what_has_no_period_of_its_own_is_refused():
    with pytest.raises(DerivationError, match="no reference tells how many periods"):
        derive_equations(struck(None))
    forcing = [Harmonic(Omega, cosine=[1]), Harmonic(sp.Symbol("w"), cosine=[1])]
    with pytest.raises(DerivationError, match="no common period"):
        derive_equations(struck(Reference({**DATA, "w": "3"}, {"T": "3.1"}), forcing))


def test_the_number_of_periods_is_that_of_the_reference():
    equations = derive_equations(struck(Reference({**DATA, "Omega": "4.4"}, {"T": "2.856"})))
    assert equations.chain.forcing.turns == 2
