"""The Appendix's route gives the same orbit, and shows two misprints by computation."""

import mpmath
import pytest

import nonsmooth as ns
from nonsmooth.derive import DerivationError, derive_equations
from nonsmooth.derive.codegen.any_arithmetic import python_kernel
from nonsmooth.derive.systems import dry_friction
from nonsmooth.runtime.core.arithmetic import Mpmath
from nonsmooth.runtime.model.kernels import load_orbit
from tests.derive.appendix import MISPRINTS, appendix_kernel

DIGITS = 50
NAME = "dry-friction/global-stick"


@pytest.fixture(scope="module")
def equations():
    return derive_equations(dry_friction.global_stick)


def compiled(equations, printed=()):
    namespace: dict = {}
    exec(python_kernel(appendix_kernel(equations, printed), None), namespace)
    return namespace["appendix"]


def solve_appendix(function, orbit, lib):
    """Newton by mpmath on the Appendix's four equations; dwell times and z0."""
    kernels = load_orbit(NAME)
    parameters = [lib.number(orbit.given[name]) for name in kernels.parameter_names]
    spectrum, _ = kernels.spectrum(parameters, lib)
    start = [
        lib.mp.mpf(orbit.unknowns[name]) * (1 + lib.mp.mpf("1e-3")) for name in kernels.dwell_times
    ]
    root = lib.mp.findroot(
        lambda *times: function(parameters, spectrum, times, lib=lib)[0],
        start,
        tol=lib.mp.mpf(10) ** -90,
    )
    return list(root), function(parameters, spectrum, list(root), lib=lib)[1]


@pytest.mark.parametrize("parameters", [{}, {"V": "0.9", "eta": "1.05", "chi": "0.48"}])
def test_both_routes_agree_to_forty_digits(equations, parameters):
    orbit = ns.refine(ns.solve(NAME, parameters), DIGITS)
    lib = Mpmath(DIGITS + 10)
    times, start = solve_appendix(compiled(equations), orbit, lib)
    expected = [*orbit.dwell_times, orbit.unknowns["z10"], orbit.unknowns["z20"]]
    for ours, theirs in zip([*times, *start], expected, strict=True):
        assert abs(ours - theirs) < lib.mp.mpf(10) ** -40


@pytest.mark.parametrize("misprint", MISPRINTS)
def test_the_printed_formulas_miss_the_orbit(equations, misprint):
    orbit = ns.refine(ns.solve(NAME, {"V": "0.9"}), DIGITS)
    kernels, lib = load_orbit(NAME), Mpmath(DIGITS)
    parameters = [lib.number(orbit.given[name]) for name in kernels.parameter_names]
    spectrum, _ = kernels.spectrum(parameters, lib)
    times = orbit.dwell_times.tolist()
    right, _ = compiled(equations)(parameters, spectrum, times, lib=lib)
    wrong, _ = compiled(equations, [misprint])(parameters, spectrum, times, lib=lib)
    assert max(map(abs, right)) < lib.mp.mpf(10) ** -45
    assert max(map(abs, wrong)) > 1e-2


def test_the_printed_stick_block_agrees_at_unit_velocity_only(equations):
    orbit = ns.refine(ns.solve(NAME), DIGITS)
    kernels, lib = load_orbit(NAME), Mpmath(DIGITS)
    parameters = [lib.number(orbit.given[name]) for name in kernels.parameter_names]
    assert orbit.values["V"] == 1
    spectrum, _ = kernels.spectrum(parameters, lib)
    residual, _ = compiled(equations, ["stick-block"])(
        parameters, spectrum, orbit.dwell_times.tolist(), lib=lib
    )
    assert max(map(abs, residual)) < lib.mp.mpf(10) ** -45


def test_other_starts_are_refused():
    rotated = derive_equations(dry_friction.global_stick.rotated(2))
    with pytest.raises(DerivationError, match="held alike"):
        appendix_kernel(rotated)
    assert mpmath.mp.dps < DIGITS  # nothing here touches the shared context
