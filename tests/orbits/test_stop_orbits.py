"""The oscillator in front of a stop (Sec. 2), by routes that share nothing with the kernels."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest
import sympy as sp
from numpy.testing import assert_allclose
from scipy.linalg import eigh, expm
from scipy.optimize import brentq

from nonsmooth import NoConvergence, solve
from nonsmooth.derive import Configuration, SecondOrder, System, derive_equations
from nonsmooth.runtime.model.kernels import load_orbit
from nonsmooth.runtime.orbits.orbit import Orbit
from tests.declared import elastic_stop, random_points, rigid_stop

RIGID, ELASTIC = "rigid-stop/one-impact", "elastic-stop/one-contact"
PAPER = {"m1": 1.0, "m2": 2.0, "k1": 1.0, "k2": 5.0}
RATIONAL = {"m1": 1, "m2": 2, "k1": 2, "k2": 4}  # frequencies 1 and 2
STIFFNESSES = np.geomspace(1e2, 1e8, 13)


def field(values: dict[str, float], stop: float = 0.0) -> np.ndarray:
    """Of (x, v, 1)' = A (x, v, 1): Eq. (1), and (4) with k1 + k2 in the corner."""
    k1, k2 = values["k1"], values["k2"]
    mass = np.array([values["m1"], values["m2"]])
    matrix = np.zeros((5, 5))
    matrix[:2, 2:4] = np.eye(2)
    matrix[2:4, :2] = -np.array([[k1 + stop, -k1], [-k1, k1 + k2]]) / mass[:, None]
    matrix[2, 4] = stop / mass[0]
    return matrix


def closure(values: dict[str, float], period: float, restitution: float = 1.0) -> Any:
    """Least squares for (y, u, w): one period of free motion, the impact, and back again.

    The closure of all four states is linear in them. Gives the solution, the largest
    residual, and the singular values.
    """
    impact = np.diag([1.0, 1.0, -restitution, 1.0])
    turn = impact @ expm(field(values) * period)[:4, :4] - np.eye(4)
    solution, *_ = np.linalg.lstsq(turn[:, 1:], -turn[:, 0], rcond=None)
    residual = turn[:, 1:] @ solution + turn[:, 0]
    return solution, abs(residual).max(), np.linalg.svd(turn[:, 1:], compute_uv=False)


# --- the rigid stop: explicit -----------------------------------------------------------


def test_the_conditions_of_symmetry_require_r_and_w() -> None:
    equations = derive_equations(rigid_stop.one_impact)
    assert equations.required == {rigid_stop.r: 1}
    assert [str(q) for q in equations.vanishing] == ["w"]
    assert [str(u) for u in equations.unknowns] == ["y", "u"]
    assert equations.reduction.unknowns == ()


def test_the_full_closure_has_the_same_orbit_and_no_other() -> None:
    """Four conditions on (y, u, w): they hold together, with w = 0, for r = 1 alone."""
    points = random_points(RIGID, 61, 30)
    many = solve(RIGID, points)
    for i in range(30):
        values = {n: float(a[i]) for n, a in points.items()}
        (y, u, w), residual, singular = closure(values, values["T"])
        error = 1e-13 * (1 + abs(y) + abs(u)) / singular[-1]
        assert residual < 1e-12 * (1 + abs(y) + abs(u))
        assert w == pytest.approx(0, abs=error)
        assert many.unknowns["y"][i] == pytest.approx(y, abs=error)
        assert many.unknowns["u"][i] == pytest.approx(u, abs=error)
        for restitution in (0.9, 0.5, 0.0):
            (y, u, w), residual, _ = closure(values, values["T"], restitution)
            assert residual > 1e-6


def test_energy_along_the_motion() -> None:
    """Kinetic and elastic, with the stop's spring: constant over the period and its impact."""
    for name, stop in ((RIGID, 0.0), (ELASTIC, 1.0)):
        orbit = solve(name)
        times = np.linspace(0, orbit.period, 400)
        x1, x2, v1, v2 = orbit.motion()(times).T
        values = orbit.values
        energy = (values["m1"] * v1**2 + values["m2"] * v2**2) / 2
        energy += (values["k1"] * (x1 - x2) ** 2 + values["k2"] * x2**2) / 2
        energy += stop * np.maximum(x1 - 1, 0) ** 2 / 2
        assert_allclose(energy, energy[0], rtol=1e-12)


# --- resonances -------------------------------------------------------------------------


def determinant(period: float, values: dict[str, float] = PAPER) -> float:
    """Of the velocities halfway through, by the start's y and u."""
    half = expm(field(values) * period / 2)[2:4, 1:3]
    return float(np.linalg.det(half))


def resonances(lower: float, upper: float) -> list[float]:
    """Periods at which the emitted determinant changes its sign, bisected to the last bit."""
    kernels = load_orbit(RIGID)

    def emitted(periods: np.ndarray) -> np.ndarray:
        points = np.stack([np.full(periods.shape, v) for v in PAPER.values()] + [periods], -1)
        spectrum, _ = kernels.spectrum(points)
        return np.asarray(kernels.expand(points, spectrum, None)[1][..., 0])

    grid = np.linspace(lower, upper, 2000)
    changes = np.flatnonzero(np.diff(np.sign(emitted(grid))))
    below, above = grid[changes], grid[changes + 1]
    for _ in range(60):
        middle = (below + above) / 2
        left = np.sign(emitted(middle)) == np.sign(emitted(below))
        below, above = np.where(left, middle, below), np.where(left, above, middle)
    return above.tolist()


@pytest.mark.parametrize("backend", ["c", "numpy"])
def test_at_a_resonance_it_says_so(backend: str, monkeypatch: pytest.MonkeyPatch) -> None:
    if backend == "c":
        pytest.importorskip("nonsmooth.generated._kernels")
    monkeypatch.setenv("NONSMOOTH_BACKEND", backend)
    found = resonances(0.5, 30)
    assert len(found) == 12
    for period in found:
        near = brentq(determinant, period - 1e-4, period + 1e-4, xtol=1e-14)
        assert period == pytest.approx(near, abs=1e-11)
        _, _, singular = closure(PAPER, period)
        assert singular[-1] < 1e-9
        with pytest.raises(NoConvergence, match=r"singular: .*resonance.*change a parameter"):
            solve(RIGID, {"T": period})
    many = solve(RIGID, {"T": found})
    assert many.status.tolist() == [5] * len(found)
    assert "resonance" in many.message(5)
    assert np.isnan(many.unknowns["y"]).all()
    assert not many.admissible.any()
    beside = solve(RIGID, {"T": [period * (1 + 1e-6) for period in found]})
    assert beside.converged.all()


@pytest.mark.parametrize("backend", ["c", "numpy"])
@pytest.mark.parametrize("turns", ["2", "4", "6", "10", "100"])
def test_rational_frequencies_in_resonance(
    turns: str, backend: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With frequencies 1 and 2 both masses are back after 2 pi: y is free, or nothing fits."""
    if backend == "c":
        pytest.importorskip("nonsmooth.generated._kernels")
    monkeypatch.setenv("NONSMOOTH_BACKEND", backend)
    stiffness = np.array([[2.0, -2], [-2, 6]])
    assert_allclose(eigh(stiffness, np.diag([1.0, 2]), eigvals_only=True), [1, 4])
    with pytest.raises(NoConvergence, match="singular"):
        solve(RIGID, {**RATIONAL, "T": f"{turns}*pi"})
    many = solve(RIGID, {**RATIONAL, "T": [float(turns) * np.pi, float(turns) * np.pi + 0.1]})
    assert many.status.tolist() == [5, 0]


@pytest.mark.parametrize("turns", [1, 3, 5])
def test_a_grazing_orbit_is_undecided(turns: int) -> None:
    """After an odd number of half turns only u = 0 fits: the stop is touched, not struck."""
    orbit = solve(RIGID, {**RATIONAL, "T": f"{turns}*pi"})
    assert orbit.unknowns["u"] == pytest.approx(0, abs=1e-13)
    assert orbit.stability.verdict == "undecided"
    moved = solve(RIGID, {**RATIONAL, "T": f"{turns}*pi + 1e-3"})
    assert moved.stability.verdict != "undecided"


def test_grazing_found_by_exchange_is_undecided() -> None:
    orbit = solve(RIGID, unknown=["T"], given={"u": 0})
    assert orbit.values["T"] == pytest.approx(7.136044414108058, rel=1e-12)
    assert orbit.stability.verdict == "undecided"


# --- what is no motion ------------------------------------------------------------------


def test_both_ways_to_fail_and_both_verdicts_occur() -> None:
    many = solve(RIGID, {"T": np.linspace(3.0, 15.0, 2000)})
    outward = many.unknowns["u"] < 0
    assert (outward & ~many.admissible).any(), "a second impact"
    assert (~outward & ~many.admissible).any(), "a penetration"
    assert (outward & many.admissible).any()
    assert not (~outward & many.admissible).any()


# --- the elastic stop -------------------------------------------------------------------


@cache
def softened() -> list[Orbit]:
    """One-contact orbits for ever stiffer stops, each started from the one before."""
    found: list[Orbit] = []
    guess = None
    for k3 in STIFFNESSES:
        found.append(solve(ELASTIC, {"k3": k3}, guess))
        # the time in contact goes with the period of the stiff spring
        guess = found[-1].unknowns | {"tau": found[-1].unknowns["tau"] / np.sqrt(10) ** 0.5}
    return found


def contact_roots(values: dict[str, float], corner: float, stop: float) -> list[np.ndarray]:
    """All (y, u, w, tau) of the half-phase conditions, by exponentials and sign changes.

    Given tau, four conditions are linear in (y, u, w): solvable where the determinant of the
    four by four matrix of coefficients and right-hand side vanishes.
    """
    period = values["T"]
    free, contact = field(values), field(values, stop)
    contact[3, 1] = -corner / values["m2"]

    def conditions(tau: float) -> np.ndarray:
        inside = expm(contact * tau / 2)[2:4]
        outside = expm(free * (period - tau) / 2)[2:4]
        rows = [[r[1], r[2], r[3], r[0] + r[4]] for r in inside]
        return np.array(rows + [[r[1], -r[2], -r[3], r[0] + r[4]] for r in outside])

    grid = np.linspace(1e-3, period - 1e-3, 3000)
    signs = np.sign([np.linalg.det(conditions(tau)) for tau in grid])
    found = []
    for i in np.flatnonzero(np.diff(signs)):
        tau = brentq(lambda t: np.linalg.det(conditions(t)), grid[i], grid[i + 1], xtol=1e-14)
        matrix = conditions(tau)
        solution, *_ = np.linalg.lstsq(matrix[:, :3], -matrix[:, 3], rcond=None)
        found.append(np.array([*solution, tau]))
    return found


def is_contact_orbit(values: dict[str, float], corner: float, stop: float, root: Any) -> bool:
    """Whether x1 is beyond the stop all through contact and before it all through the rest."""
    y, u, w, tau = root
    contact = field(values, stop)
    contact[3, 1] = -corner / values["m2"]
    start = np.array([1, y, u, w, 1])
    behind = expm(contact * tau) @ start
    inside = [(expm(contact * t) @ start)[0] for t in np.linspace(0, tau, 300)[1:-1]]
    times = np.linspace(0, values["T"] - tau, 300)[1:-1]
    outside = [(expm(field(values) * t) @ behind)[0] for t in times]
    return bool(min(inside) > 1 and max(outside) < 1)


DATA = PAPER | {"k3": 1.0, "T": 2 * np.pi}


def rate(errors: list[float]) -> float:
    """Slope of the errors over the stiffness, in logarithms, where it is large."""
    count = len(STIFFNESSES) // 2
    return float(np.polyfit(np.log(STIFFNESSES[count:]), np.log(errors[count:]), 1)[0])


def test_the_elastic_orbit_tends_to_the_rigid_one() -> None:
    """O(k3^-1/2) at fixed T; one starts before the contact, the other behind the impact."""
    rigid, orbits = solve(RIGID), softened()
    assert all(o.admissibility.verdict is True for o in orbits)
    errors = {
        "y": [abs(o.unknowns["y"] - rigid.unknowns["y"]) for o in orbits],
        "u": [abs(o.unknowns["u"] + rigid.unknowns["u"]) for o in orbits],
        "w": [abs(o.unknowns["w"]) for o in orbits],
        "tau": [o.unknowns["tau"] for o in orbits],
        "trace": [abs(o.trace - rigid.trace) for o in orbits],
    }
    for name, found in errors.items():
        assert rate(found) == pytest.approx(-0.5, abs=0.02), name
        assert found[-1] < 1e-3
    half_swings = [o.unknowns["tau"] * np.sqrt(o.values["k3"]) / np.pi for o in orbits]
    assert half_swings[-1] == pytest.approx(1, abs=1e-3)
    for soft, hard in zip(
        orbits[-1].stability.multipliers, rigid.stability.multipliers, strict=True
    ):
        assert soft.real == pytest.approx(hard.real, abs=1e-5)
        assert soft.imaginary == pytest.approx(hard.imaginary, abs=1e-5)
        assert soft.trivial == hard.trivial


def test_a_stiff_stop_is_found_without_a_guess() -> None:
    for orbit in softened()[::3]:
        alone = solve(ELASTIC, {"k3": orbit.values["k3"]})
        assert_allclose(list(alone.unknowns.values()), list(orbit.unknowns.values()), atol=1e-9)
    many = solve(ELASTIC, {"k3": STIFFNESSES})
    assert many.admissible.all()
    assert_allclose(many.unknowns["u"], [o.unknowns["u"] for o in softened()], atol=1e-8)


# --- Eq. (4) as it is printed -----------------------------------------------------------


def printed_system() -> System:
    """The elastic stop with k1 + k3 in the corner of K1, as the paper prints it."""
    k1, k3 = sp.Symbol("k1", positive=True), elastic_stop.k3
    stiffness = sp.Matrix([[k1 + k3, -k1], [-k1, k1 + k3]])
    contact = elastic_stop.contact
    wrong = Configuration(
        "contact", SecondOrder(elastic_stop.MASS, stiffness, load=(k3, 0)), contact.boundaries
    )
    return replace(elastic_stop.system, name="printed", configurations=(wrong, elastic_stop.free))


@pytest.mark.parametrize("printed", [False, True])
def test_the_printed_stiffness_matrix_has_no_contact_orbit(printed: bool) -> None:
    system = printed_system() if printed else "elastic-stop"
    corner = DATA["k1"] + DATA["k3"] if printed else DATA["k1"] + DATA["k2"]
    phases = [("contact", "first-leaves-stop"), ("free", "first-reaches-stop")]
    period = DATA["T"]
    data = {name: value for name, value in DATA.items() if name != "T"}
    verdicts = []
    for y, u, w, tau in contact_roots(DATA, corner, DATA["k3"]):
        guess = [tau, period - tau, 1, y, u, w]
        orbit = solve(system, data, guess, itinerary=phases, given={"period": period})
        assert_allclose([*orbit.dwell_times, *orbit.states[0]], guess, atol=1e-9)
        verdicts.append(orbit.admissibility.verdict)
        sampled = is_contact_orbit(DATA, corner, DATA["k3"], (y, u, w, tau))
        assert verdicts[-1] is sampled
        if sampled:
            assert_allclose([*solve(ELASTIC, DATA).unknowns.values()], [y, u, w, tau], atol=1e-9)
    assert verdicts == ([False, False] if printed else [True])
