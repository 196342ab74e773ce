"""Parameters from steady responses, and accelerations and forces, against the truth behind them."""

from __future__ import annotations

import functools
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.derive import Harmonic, Parameter, RigidStop, SoftStop, oscillator
from nonsmooth.runtime.explore.fitting.affine_outputs import output_of
from nonsmooth.runtime.explore.fitting.response_quantities import KINDS, response_quantity
from nonsmooth.runtime.explore.fitting.steady_orbits import settled_from
from nonsmooth.runtime.model.kernels import kernels_of
from nonsmooth.runtime.model.structure import structure_of

c, k, s, F, w, r = sp.symbols("c k s F w r")
SYSTEM = oscillator(
    "touching",
    ["x"],
    mass=[[1]],
    damping=[[c]],
    stiffness=[[k]],
    forcing=[Harmonic(w, cosine=[F])],
    elements=[SoftStop("x", at=1, stiffness=s, name="stop")],
    parameters=[
        Parameter("c", "damping"),
        Parameter("k", "stiffness"),
        Parameter("s", "stiffness of the stop"),
        Parameter("w", "frequency"),
        Parameter("F", "force"),
    ],
)
IMPACTING = oscillator(
    "struck-steadily",
    ["x"],
    mass=[[1]],
    damping=[[c]],
    stiffness=[[k]],
    forcing=[Harmonic(w, cosine=[F])],
    elements=[RigidStop("x", at=0.2, restitution=r, name="wall")],
    parameters=[
        Parameter("c", "damping"),
        Parameter("k", "stiffness"),
        Parameter("r", "restitution"),
        Parameter("w", "frequency"),
        Parameter("F", "force"),
    ],
)
TRUTH: dict[str, Any] = {"c": 0.1, "k": 1.0, "s": 3.0, "F": 0.3}
GUESS = {"c": 0.11, "k": 1.03, "s": 2.8}
SWEEP = np.array([0.6, 0.8, 0.9, 1.0, 1.06, 1.12, 1.3, 1.6])
SOME = SWEEP[1::2]
FREE = ("c", "k", "s")
POINT = {"c": 0.05, "k": 2.5, "r": 0.7, "w": 2.1, "F": 1.0}


@functools.cache
def steady(w: float, **changed: float) -> Any:
    """A period of the response that motions from rest settle on, by simulation alone."""
    turn = 2 * np.pi / w
    motion = ns.simulate(SYSTEM, TRUTH | {"w": w, **changed}, {"x": 0, "v": 0}, until=150 * turn)
    return motion, np.linspace(149 * turn, 150 * turn, 4001)


def amplitudes(ws: np.ndarray = SWEEP, **changed: float) -> np.ndarray:
    found = []
    for w_ in ws.tolist():
        motion, times = steady(w_, **changed)
        seen = ns.observe(motion, since=float(times[0]))
        found.append((seen.maxima["x"].value - seen.minima["x"].value) / 2)
    return np.array(found)


@functools.cache
def of_exact_amplitudes() -> Any:
    return fitted({"w": SOME, "amplitude:x": amplitudes(SOME)}, sigma=1e-3)


@functools.cache
def of_noisy_amplitudes() -> Any:
    noise = 2e-3 * np.random.default_rng(3).normal(size=len(SWEEP))
    return fitted({"w": SWEEP, "amplitude:x": amplitudes() + noise}, sigma=2e-3)


def fitted(data: Any, *free: str, **options: Any) -> Any:
    known = {**TRUTH, **options.pop("parameters", GUESS)}
    return ns.fit(SYSTEM, data, parameters=known, free=free or FREE, **options)


# --- the truth comes back


@pytest.mark.slow
def test_exact_amplitudes_give_exact_parameters() -> None:
    found = of_exact_amplitudes()
    np.testing.assert_allclose(found.estimates, [0.1, 1, 3], rtol=0, atol=1e-9)
    assert found.status == "converged"
    (only,) = found.experiments
    assert only.along == "w"
    kinds = {len(each.itinerary) for each in only.responses}
    assert kinds == {1, 2}  # some do not touch the stop
    assert all(each.stability == "stable" for each in only.responses)
    for row, response in enumerate(only.responses):
        orbit = found.response(row)
        assert orbit.converged
        assert float(orbit.period) == pytest.approx(response.period, rel=1e-12)
        assert orbit.given["w"] == response.parameters["w"]


@pytest.mark.slow
def test_linear_responses_are_those_of_the_resonance_curve() -> None:
    """Without a contact: F / |k - w^2 + i c w|, and the phase of that."""
    ws = np.array([0.3, 0.5, 1.6, 2.0, 2.5])
    gain = 0.3 / (1.0 - ws**2 + 0.1j * ws)
    data = {"w": ws, "harmonic:x": abs(gain), "phase:x": np.angle(gain)}
    found = ns.fit(
        SYSTEM, data, parameters={"s": 3, "F": 0.28, "c": 0.12, "k": 1.1}, free=["c", "k", "F"],
        sigma=1e-3,
    )  # fmt: skip
    np.testing.assert_allclose(found.estimates, [0.1, 1, 0.3], rtol=0, atol=1e-9)
    jacobian = []
    for row, w_ in enumerate(ws):
        g = gain[row] / 0.3
        by = [-1j * w_ * g**2 * 0.3, -(g**2) * 0.3, g]
        jacobian.append([(np.conj(gain[row]) * d).real / abs(gain[row]) for d in by])
        jacobian.append([(d / gain[row]).imag for d in by])
    expected = np.linalg.inv(np.array(jacobian).T @ np.array(jacobian)) * 1e-6
    np.testing.assert_allclose(found.covariance, expected, rtol=1e-7)


@pytest.mark.slow
def test_other_quantities_and_rows_in_any_order() -> None:
    """Peaks and averages of accelerations and forces, against long simulations."""
    texts = ("rms:acceleration:x", "maximum:force:stop", "mean:2*x + 1", "harmonic:x", "phase:v")
    shuffled = SWEEP[[3, 2, 4]]
    data: dict[str, Any] = {"w": shuffled}
    for text in texts:
        data[text] = [_measured(text, w_) for w_ in shuffled.tolist()]
    found = fitted(data, sigma={text: 1e-3 for text in texts})
    np.testing.assert_allclose(found.estimates, [0.1, 1, 3], rtol=0, atol=2e-6)
    again = fitted({n: np.sort(v) if n == "w" else np.array(v)[np.argsort(shuffled)]
                    for n, v in data.items()}, sigma={text: 1e-3 for text in texts},
                   parameters=dict(zip(FREE, found.estimates.tolist(), strict=True)))  # fmt: skip
    np.testing.assert_allclose(again.estimates, found.estimates, rtol=1e-10)


def _measured(text: str, w_: float) -> float:
    """From states sampled along the last period of a simulation."""
    motion, times = steady(w_)
    x, v, cosine, sine = motion(times).T
    force = np.where(x > 1, -3.0 * (x - 1), 0.0)
    acceleration = 0.3 * cosine - 0.1 * v - x + force
    if text == "rms:acceleration:x":
        return float(np.sqrt(np.trapezoid(acceleration**2, times) / np.ptp(times)))
    if text == "maximum:force:stop":
        return float(force.max())
    if text == "mean:2*x + 1":
        return float(np.trapezoid(2 * x + 1, times) / np.ptp(times))
    of = x if text == "harmonic:x" else v
    wave = 2 * np.trapezoid(of * (cosine - 1j * sine), times) / np.ptp(times)
    return float(abs(wave) if text == "harmonic:x" else np.angle(wave))


# --- derivatives

MOVED = ("c", "k", "s", "F", "w")


@functools.cache
def settled(name: str = "w", by: float = 0.0) -> Any:
    """Derivatives of the response where one parameter is moved."""
    point = TRUTH | {"w": 1.0}
    (orbit,) = settled_from(kernels_of(SYSTEM), point | {name: point[name] + by}, [0, 0, 1, 0])
    return orbit.derivatives(list(MOVED))


@pytest.mark.parametrize("kind", list(KINDS))
@pytest.mark.parametrize("output", ["v - 2*x", "acceleration:x + force:stop-x"])
def test_derivatives_are_those_of_differences(kind: str, output: str) -> None:
    quantity = response_quantity(f"{kind}:{output}", structure_of(kernels_of(SYSTEM)))
    _, rates = quantity.of(settled())
    for place, name in enumerate(MOVED):
        ends = [quantity.of(settled(name, sign * 1e-5))[0] for sign in (-1, 1)]
        slope = (ends[1] - ends[0]) / 2e-5
        assert rates[place] == pytest.approx(slope, rel=1e-6, abs=1e-7)


def test_rms_and_mean_through_impacts_are_those_of_the_motion() -> None:
    kernels = kernels_of(IMPACTING)
    (orbit,) = settled_from(kernels, POINT, [0, 0, 1, 0])
    assert orbit.itinerary == (("free", "wall-reaches-stop"),)
    seen = ns.observe(orbit.trajectory())
    derivatives = orbit.derivatives(["k", "r"])
    structure = structure_of(kernels)
    for kind, expected in (("mean", seen.means), ("rms", seen.rms)):
        for state in ("x", "v"):
            value, _ = response_quantity(f"{kind}:{state}", structure).of(derivatives)
            assert value == pytest.approx(expected[state], rel=1e-12, abs=1e-12)


# --- what a fit tells


@pytest.mark.slow
def test_errors_are_those_of_the_noise() -> None:
    """To first order: by differences of amplitudes of motions that are simulated."""
    found, step, columns = of_noisy_amplitudes(), 1e-4, []
    estimates = dict(zip(FREE, found.estimates.tolist(), strict=True))
    for name in FREE:
        ends = [amplitudes(**estimates | {name: estimates[name] + by}) for by in (-step, step)]
        columns.append((ends[1] - ends[0]) / (2 * step) / 2e-3)
    jacobian = np.array(columns).T
    expected = np.linalg.inv(jacobian.T @ jacobian)
    np.testing.assert_allclose(found.covariance, expected, rtol=1e-4)
    # residuals at a minimum are those that no change of the parameters makes smaller
    slopes = found.residuals @ jacobian
    assert (abs(slopes) < 1e-4 * np.linalg.norm(jacobian, axis=0)).all()
    assert 1 < np.linalg.norm(found.residuals) < 4


@pytest.mark.slow
def test_the_unit_of_an_output_does_not_matter() -> None:
    metres = of_noisy_amplitudes()
    (measured,) = metres.experiments[0].series
    data = {"w": SWEEP, "A": 1000 * measured.values}
    millimetres = fitted(data, responses={"A": "amplitude:1000*x"}, sigma=2.0)
    np.testing.assert_allclose(millimetres.estimates, metres.estimates, rtol=1e-8)
    np.testing.assert_allclose(millimetres.covariance, metres.covariance, rtol=1e-5)


@pytest.mark.slow
def test_experiments_in_any_order_and_motions_beside_responses() -> None:
    motion = ns.simulate(SYSTEM, TRUTH | {"w": 1.0}, {"x": 0, "v": 0}, until=20)
    times = np.linspace(0.1, 20, 50)
    series = ns.Experiment(
        data={"t": times, "x": motion(times)[:, 0]}, parameters={"w": 1}, start={"x": 0, "v": 0}
    )
    some = slice(2, 5, 2)
    rows = ns.Experiment(data={"w": SWEEP[some], "amplitude:x": amplitudes(SWEEP[some])})
    both = [fitted([series, rows], sigma=1e-3),
            fitted([rows, series], sigma=1e-3, parameters={})]  # fmt: skip
    for found in both:
        np.testing.assert_allclose(found.estimates, [0.1, 1, 3], rtol=0, atol=1e-9)
    np.testing.assert_allclose(both[0].covariance, both[1].covariance, rtol=1e-6)
    with pytest.raises(InputError, match="holds steady responses"):
        both[0].motion(1)
    assert both[0].motion(0).end > 19


@pytest.mark.slow
def test_grazing_of_a_response_is_that_of_its_height() -> None:
    """Without a contact the largest x is the amplitude, which stays below the stop at 1."""
    ws = np.array([1.7, 2.0, 2.4])
    data = {"w": ws, "amplitude:x": 0.3 / abs(1 - ws**2 + 0.1j * ws)}
    found = fitted(data, "k", sigma=1e-3, parameters={"k": 1.01})
    top = data["amplitude:x"][0]
    near = found.grazing
    assert near.kind == "missed"
    assert near.margin == pytest.approx(1 - top, rel=1e-8)
    gain = 1 / (1 - 1.7**2 + 0.17j)
    slope = 0.3 * (np.conj(gain) * -(gain**2)).real / abs(gain)
    expected = (1 - top) / abs(slope * found.standard_errors[0])
    assert near.standard_errors == pytest.approx(expected, rel=1e-6)


@pytest.mark.slow
def test_coexisting_responses_are_told_apart_by_what_was_measured() -> None:
    """Above the resonance of the bent curve a response with and one without contact live."""
    kernels = kernels_of(SYSTEM)
    found: dict[int, float] = {}
    point = TRUTH | {"w": 1.2}
    for start in ([0, 0, 1, 0], [2.0, 0, 1, 0]):
        for orbit in settled_from(kernels, point, start):
            value, _ = response_quantity("amplitude:x", structure_of(kernels)).of(
                orbit.derivatives(["c"])
            )
            found[len(orbit.itinerary)] = value
    assert set(found) == {1, 2}
    assert found[2] > 2 * found[1]
    for phases, value in found.items():
        data = {"w": [0.9, 1.2], "amplitude:x": [amplitudes(SWEEP[2:3])[0], value]}
        # bounds that keep it from a k at which there is one response alone
        near = {"parameters": {"k": 1.005}, "bounds": {"k": (0.98, 1.02)}}
        fit = fitted(data, "k", sigma=1e-3, **near)
        assert fit["k"] == pytest.approx(1, abs=1e-9)
        assert len(fit.experiments[0].responses[1].itinerary) == phases
    free, contact = ("free", "stop-reaches-stop"), ("contact", "stop-leaves-stop")
    told = ns.Experiment(data={"w": [1.2], "amplitude:x": [found[1]]}, itinerary=[free, contact])
    with_contact = fitted(told, "F", sigma=1e-3, parameters={})
    assert len(with_contact.experiments[0].responses[0].itinerary) == 2


# --- files and pictures


def test_a_fit_of_responses_is_kept(tmp_path: Path) -> None:
    found = of_exact_amplitudes()
    found.save(tmp_path / "fit.json")
    kept = ns.load(tmp_path / "fit.json")
    same = ({n: x for n, x in each.to_json().items() if n != "system"} for each in (kept, found))
    assert next(same) == next(same)
    np.testing.assert_array_equal(
        kept.experiments[0].responses[3].start, found.experiments[0].responses[3].start
    )


@pytest.mark.slow
def test_a_fit_of_responses_is_drawn() -> None:
    pytest.importorskip("matplotlib")
    found = of_noisy_amplitudes()
    curve, points = found.plot()[0].lines[:2]
    assert len(points.get_xdata()) == len(SWEEP)
    at = np.interp(points.get_xdata(), curve.get_xdata(), curve.get_ydata())
    assert np.isnan(curve.get_ydata()).any()  # where contacts begin and end
    smooth = abs(SWEEP - 1.12) > 0.1
    at[np.isnan(at)] = found.experiments[0].series[0].fitted[np.isnan(at)]
    assert np.isfinite(curve.get_ydata()).mean() > 0.9
    np.testing.assert_allclose(at[smooth], found.experiments[0].series[0].fitted[smooth], rtol=0.02)


# --- accelerations and forces over time


def accelerations() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    motion = ns.simulate(SYSTEM, TRUTH | {"w": 1.0}, {"x": 0, "v": 0}, until=30)
    times = np.linspace(0.1, 29.9, 90)
    x, v, cosine, _ = motion(times).T
    force = np.where(x > 1, -3.0 * (x - 1), 0.0)
    assert (force < 0).sum() > 5
    return times, 0.3 * cosine - 0.1 * v - x + force, force


@pytest.mark.slow
def test_accelerometers_and_load_cells_tell_the_parameters() -> None:
    times, acceleration, force = accelerations()
    known = {"parameters": GUESS | {"w": 1}, "start": {"x": 0, "v": 0}, "sigma": 1e-3}
    found = fitted({"t": times, "a": acceleration}, outputs={"a": "acceleration:x"}, **known)
    np.testing.assert_allclose(found.estimates, [0.1, 1, 3], rtol=0, atol=1e-9)
    scaled = fitted(
        {"t": times, "g": acceleration / 9.81 - 1, "f": force},
        outputs={"g": "acceleration:x/9.81 - 1", "f": "force:stop"}, **known,
    )  # fmt: skip
    np.testing.assert_allclose(scaled.estimates, [0.1, 1, 3], rtol=0, atol=1e-9)


@pytest.mark.slow
def test_derivatives_of_accelerations_are_those_of_differences() -> None:
    times, acceleration, _ = accelerations()
    known = {"start": {"x": 0.01, "v": 0}, "sigma": 1e-3, "offset": 0.002}
    free = ("c", "k", "s", "w", "x0", "offset")
    noise = 1e-3 * np.random.default_rng(1).normal(size=len(times))
    data = {"t": times, "a": acceleration + noise}
    found = fitted(data, *free, parameters={"w": 1}, outputs={"a": "acceleration:x"},
                   **known)  # fmt: skip
    columns = []
    for name in free:
        ends = []
        for sign in (-1, 1):
            point = dict(zip(free, found.estimates.tolist(), strict=True))
            point[name] += sign * 1e-6
            start, offset = {"x": point.pop("x0"), "v": 0}, point.pop("offset")
            motion = ns.simulate(SYSTEM, TRUTH | point, start, until=31)
            x, v, cosine, _ = motion(times - offset).T
            force = np.where(x > 1, -point["s"] * (x - 1), 0.0)
            ends.append(0.3 * cosine - point["c"] * v - point["k"] * x + force)
        columns.append((ends[1] - ends[0]) / 2e-6 / 1e-3)
    jacobian = np.array(columns).T
    np.testing.assert_allclose(found.covariance, np.linalg.inv(jacobian.T @ jacobian), rtol=1e-4)


def test_a_sample_at_an_impact_is_refused_with_words() -> None:
    point = {"c": 0.05, "k": 2.5, "r": 0.7, "w": 2.1, "F": 1.0}
    motion = ns.simulate(IMPACTING, point, {"x": -0.6, "v": 0}, until=8)
    at = float(motion.times[1])
    data = {"t": np.sort(np.r_[np.linspace(0.1, 7.9, 20), at]), "a": np.zeros(21)}
    with pytest.raises(InputError, match=r"a jumps at .* at wall-reaches-stop: leave out"):
        ns.fit(
            IMPACTING, data, parameters=point, free=["c"], start={"x": -0.6, "v": 0},
            outputs={"a": "acceleration:x"},
        )  # fmt: skip


# --- bad input


@pytest.mark.parametrize(
    ("data", "free", "options", "told"),
    [
        ({"w": [1.0], "size:x": [1]}, (), {}, "unknown column 'size:x'"),
        ({"w": [1.0], "A": [1]}, (), {"responses": {"A": "size:x"}}, "unknown kind of response"),
        ({"w": [1.0], "A": [1]}, (), {"responses": {"A": "x"}}, "'x' is not KIND:OUTPUT"),
        ({"w": [1.0], "amplitude:z": [1]}, (), {}, "unknown name 'z'"),
        ({"w": [1.0], "peak:force:door": [1]}, (), {}, "unknown contact 'door'"),
        ({"w": [1.0], "amplitude:x": [1]}, (), {"responses": {"B": "rms:x"}}, "'B'"),
        ({"w": [1.0], "t": [1], "amplitude:x": [1]}, (), {}, "column 't' is no parameter"),
        ({"w": [1.0, 2], "amplitude:x": [1]}, (), {}, "columns differ in length"),
        ({"w": [np.nan], "amplitude:x": [1]}, (), {}, "parameter w is missing or not finite"),
        ({"w": [1.0], "amplitude:x": [np.nan]}, (), {}, "nothing is measured"),
        ({"w": [1.0], "amplitude:x": [1]}, (), {}, "1 measured numbers are too few for 3 free"),
        ({"amplitude:x": [1.0, 2, 3, 4]}, (), {}, "touching needs a value for: w"),
        ({"w": SWEEP, "amplitude:x": SWEEP}, ("w",), {}, "w is free, and known in experiment 1"),
        ({"w": SWEEP, "amplitude:x": SWEEP}, ("x0",), {}, "x0 belongs to a motion"),
        ({"w": [1.6, 2, 3], "amplitude:x": [0.1, 0.2, 0.3]}, ("s",), {}, "depends on s"),
        ({"w": [1, -1], "amplitude:x": [1, 1]}, ("k",), {}, "w = -1"),
    ],
)  # fmt: skip
def test_bad_input_is_one_line(data: Any, free: Any, options: Any, told: str) -> None:
    with pytest.raises(InputError) as refused:
        fitted(data, *free, **options)
    (line,) = str(refused.value).splitlines()
    assert told in line


def test_no_harmonic_without_a_forcing() -> None:
    structure = structure_of(kernels_of("rigid-stop"))
    with pytest.raises(InputError, match="belongs to a forcing, which rigid-stop has not"):
        response_quantity("phase:x1", structure)
    assert output_of("acceleration:v1 - acceleration:x1", structure).terms[0].name == "v1"
