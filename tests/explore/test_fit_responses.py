"""Parameters from steady responses, and accelerations and forces, against the truth behind them."""

import functools
from dataclasses import replace

import numpy as np
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.derive import RigidStop, SoftStop
from tests.differences import in_doubles
from tests.explore import test_fit
from tests.one_mass import one_mass

c, k, s, F, w, r = sp.symbols("c k s F w r")
FORCED = {"damping": c, "stiffness": k, "forces": {w: F}}
SYSTEM = one_mass("touching", SoftStop("x", at=1, stiffness=s, name="stop"), **FORCED)
WALL = RigidStop("x", at=0.2, restitution=r, name="wall")
IMPACTING = one_mass("struck-steadily", WALL, **FORCED)
TRUTH = {"c": 0.1, "k": 1.0, "s": 3.0, "F": 0.3}
GUESS = {"c": 0.11, "k": 1.03, "s": 2.8}
SWEEP = np.array([0.6, 0.8, 0.9, 1.0, 1.06, 1.12, 1.3, 1.6])
SOME = SWEEP[[3, 7, 1, 5]]  # in any order
FREE = ("c", "k", "s")
POINT = {"c": 0.05, "k": 2.5, "r": 0.7, "w": 2.1, "F": 1.0}


@functools.cache
def steady(w, **changed):
    """A period of the response that motions from rest settle on, by simulation alone."""
    turn = 2 * np.pi / w
    motion = ns.simulate(SYSTEM, TRUTH | {"w": w, **changed}, {"x": 0, "v": 0}, until=150 * turn)
    return motion, np.linspace(149 * turn, 150 * turn, 4001)


def amplitudes(ws=SWEEP):
    found = []
    for w_ in ws.tolist():
        motion, times = steady(w_)
        seen = ns.observe(motion, since=float(times[0]))
        found.append((seen.maxima["x"].value - seen.minima["x"].value) / 2)
    return np.array(found)


def fitted(data, *free, **options):
    known = {**TRUTH, **options.pop("parameters", GUESS)}
    return ns.fit(SYSTEM, data, parameters=known, free=free or FREE, **options)


refusal = functools.partial(test_fit.refusal, ask=fitted)


def check_errors(found, predicted, within, step=1e-6):
    """The covariance is that of the Jacobian by differences, in standard errors."""
    jacobian = in_doubles(predicted, found.estimates, step) / 1e-3
    expected = np.linalg.inv(jacobian.T @ jacobian)
    sizes = np.sqrt(np.diag(expected))
    off = (found.covariance - expected) / np.outer(sizes, sizes)
    np.testing.assert_allclose(off, 0, atol=within)


# --- the truth comes back


@pytest.mark.slow
def test_exact_amplitudes_give_exact_parameters(tmp_path):
    found = fitted({"w": SOME, "amplitude:x": amplitudes(SOME)}, sigma=1e-3)
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
    found.save(tmp_path / "fit.json")
    kept = ns.load(tmp_path / "fit.json")
    same = ({n: x for n, x in each.to_json().items() if n != "system"} for each in (kept, found))
    assert next(same) == next(same)
    starts = ([row.start for row in each.experiments[0].responses] for each in (kept, found))
    np.testing.assert_array_equal(*starts)


@pytest.mark.slow
def test_linear_responses_are_those_of_the_resonance_curve():
    """Without a contact: F / |k - w^2 + i c w|, and the phase of that."""
    ws = np.array([0.5, 1.6, 2.5])
    there = np.array([0, 1, 1, 1, 1, 0], bool)  # not all was measured everywhere

    def parts(point):
        gain = point[2] / (point[1] - ws**2 + 1j * point[0] * ws)
        return np.concatenate([abs(gain), np.angle(gain)])[there]

    every = np.full(6, np.nan)
    every[there] = parts(np.array([0.1, 1.0, 0.3]))
    data = {"w": ws, "harmonic:x": every[:3], "phase:x": every[3:]}
    near = {"F": 0.28, "c": 0.12, "k": 1.1}
    found = fitted(data, "c", "k", "F", parameters=near, sigma=1e-3)
    np.testing.assert_allclose(found.estimates, [0.1, 1, 0.3], rtol=0, atol=1e-9)
    check_errors(found, parts, 1e-7)


def wave(along, values, state):
    """The first harmonic of values along a period with the forcing's cosine and sine."""
    cosine, sine = state[:, 2:].T
    found = np.trapezoid(values * (cosine - 1j * sine), along)
    return complex(2 * found / np.ptp(along))


# by kind: the number that is measured, of values along a period (times, values, states)
KINDS = {
    "maximum": lambda t, y, _: y.max(),
    "minimum": lambda t, y, _: y.min(),
    "peak": lambda t, y, _: abs(y).max(),
    "amplitude": lambda t, y, _: np.ptp(y) / 2,
    "mean": lambda t, y, _: np.trapezoid(y, t) / np.ptp(t),
    "rms": lambda t, y, _: np.sqrt(np.trapezoid(y**2, t) / np.ptp(t)),
    "harmonic": lambda t, y, state: abs(wave(t, y, state)),
    "phase": lambda t, y, state: np.angle(wave(t, y, state)),
}
OUTPUTS = {
    "v - 2*x": lambda x, v, acceleration, force: v - 2 * x,
    "acceleration:x + force:stop-x": lambda x, v, acceleration, force: acceleration + force - x,
    "2*acceleration:v": lambda x, v, acceleration, force: 2 * acceleration,  # of its coordinate
}


def measured(text, w, **changed):
    """What is measured of a response, from states along the last period of a simulation."""
    kind, _, output = text.partition(":")
    point = TRUTH | changed
    motion, times = steady(w, **changed)
    states = motion(times)
    x, v, cosine, _ = states.T
    force = np.where(x > 1, -point["s"] * (x - 1), 0.0)
    acceleration = point["F"] * cosine - point["c"] * v - point["k"] * x + force
    values = OUTPUTS[output](x, v, acceleration, force)
    return float(KINDS[kind](times, values, states))


@pytest.mark.slow
@pytest.mark.parametrize("output", OUTPUTS)
def test_quantities_and_their_derivatives_are_those_of_simulations(output):
    """The truth comes back whatever is measured, with the errors that differences tell."""
    texts = [f"{kind}:{output}" for kind in KINDS]
    data = {"w": [1.0], **{text: [measured(text, 1.0)] for text in texts}}
    found = fitted(data, sigma=1e-3)
    np.testing.assert_allclose(found.estimates, [0.1, 1, 3], rtol=0, atol=1e-5)

    def predicted(point):
        moved = dict(zip(FREE, (float(x) for x in point), strict=True))
        return np.array([measured(text, 1.0, **moved) for text in texts])

    found = replace(found, estimates=np.array([TRUTH[name] for name in FREE]))
    check_errors(found, predicted, 2e-3, 1e-3)


def test_rms_and_mean_through_impacts_are_those_of_the_motion():
    motion = ns.simulate(IMPACTING, POINT, {"x": 0, "v": 0}, transitions=400)
    orbit = ns.solve(IMPACTING, POINT, itinerary=ns.itinerary_of(motion))
    assert orbit.itinerary == (("free", "wall-reaches-stop"),)
    seen = ns.observe(orbit.trajectory())
    data = {"w": [POINT["w"]]}
    for state in "xv":
        data |= {f"mean:{state}": [seen.means[state]], f"rms:{state}": [seen.rms[state]]}
    known = POINT | {"k": 2.51, "r": 0.69}
    found = ns.fit(IMPACTING, data, parameters=known, free=["k", "r"], sigma=1e-3)
    np.testing.assert_allclose(found.estimates, [2.5, 0.7], rtol=1e-9)


# --- what a fit tells


@pytest.mark.slow
def test_experiments_in_any_order_and_motions_beside_responses():
    motion = ns.simulate(SYSTEM, TRUTH | {"w": 1.0}, {"x": 0, "v": 0}, until=20)
    times = np.linspace(0.1, 20, 50)
    series = ns.Experiment(
        data={"t": times, "x": motion(times)[:, 0]}, parameters={"w": 1}, start={"x": 0, "v": 0}
    )
    rows = ns.Experiment(data={"w": SOME[:1], "amplitude:x": amplitudes(SOME[:1])})
    both = [fitted([series, rows], sigma=1e-3),
            fitted([rows, series], sigma=1e-3, parameters={})]  # fmt: skip
    for found in both:
        np.testing.assert_allclose(found.estimates, [0.1, 1, 3], rtol=0, atol=1e-9)
    np.testing.assert_allclose(both[0].covariance, both[1].covariance, rtol=1e-6)
    with pytest.raises(InputError, match="holds steady responses"):
        both[0].motion(1)
    assert both[0].motion(0).end > 19


@pytest.mark.slow
def test_grazing_of_a_response_is_that_of_its_height():
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
def test_coexisting_responses_are_told_apart_by_what_was_measured():
    """Above the resonance of the bent curve a response with and one without contact live."""
    found = {}
    for place in (0.0, 2.0):
        turn = 2 * np.pi / 1.2
        motion = ns.simulate(SYSTEM, TRUTH | {"w": 1.2}, {"x": place, "v": 0}, until=200 * turn)
        seen = ns.observe(motion, since=199 * turn)
        top = seen.maxima["x"].value
        found[1 + (top > 1)] = (top - seen.minima["x"].value) / 2
    assert set(found) == {1, 2}
    assert found[2] > 2 * found[1]
    for phases, value in found.items():
        data = {"w": [1.0, 1.2], "amplitude:x": [amplitudes(SOME[:1])[0], value]}
        # bounds that keep it from a k at which there is one response alone
        near = {"parameters": {"k": 1.002}, "bounds": {"k": (0.98, 1.02)}}
        fit = fitted(data, "k", sigma=1e-3, **near)
        assert fit["k"] == pytest.approx(1, abs=1e-9)
        assert len(fit.experiments[0].responses[1].itinerary) == phases
    free, contact = ("free", "stop-reaches-stop"), ("contact", "stop-leaves-stop")
    told = ns.Experiment(data={"w": [1.2], "amplitude:x": [found[1]]}, itinerary=[free, contact])
    with_contact = fitted(told, "F", sigma=1e-3, parameters={})
    assert len(with_contact.experiments[0].responses[0].itinerary) == 2


# --- pictures


@pytest.mark.slow
def test_a_fit_of_responses_is_drawn():
    pytest.importorskip("matplotlib")
    noise = 2e-3 * np.random.default_rng(3).normal(size=len(SWEEP))
    found = fitted({"w": SWEEP, "amplitude:x": amplitudes() + noise}, sigma=2e-3)
    curve, points = found.plot()[0].lines[:2]
    assert len(points.get_xdata()) == len(SWEEP)
    at = np.interp(points.get_xdata(), curve.get_xdata(), curve.get_ydata())
    assert np.isnan(curve.get_ydata()).any()  # where contacts begin and end
    smooth = abs(SWEEP - 1.12) > 0.1
    at[np.isnan(at)] = found.experiments[0].series[0].fitted[np.isnan(at)]
    assert np.isfinite(curve.get_ydata()).mean() > 0.9
    np.testing.assert_allclose(at[smooth], found.experiments[0].series[0].fitted[smooth], rtol=0.02)


# --- accelerations and forces over time


@pytest.mark.slow
def test_accelerometers_and_load_cells_tell_the_parameters():
    """With the errors that differences tell, of a clock and a start beside them."""
    times, free = np.linspace(0.1, 19.9, 60), ("c", "k", "s", "w", "x0", "offset")

    def predicted(point):
        """A scaled acceleration, and the stop's force."""
        *values, place, offset = (float(x) for x in point)
        known = TRUTH | dict(zip(free, values, strict=False))
        motion = ns.simulate(SYSTEM, known, {"x": place, "v": 0}, until=21)
        x, v, cosine, _ = motion(times - offset).T
        force = np.where(x > 1, -known["s"] * (x - 1), 0.0)
        assert (force < 0).sum() > 5
        acceleration = known["F"] * cosine - known["c"] * v - known["k"] * x + force
        return np.concatenate([acceleration / 9.81 - 1, force])

    truth = np.array([0.1, 1, 3, 1, 0.01, 0.002])
    scaled, force = np.split(predicted(truth), 2)
    found = fitted(
        {"t": times, "g": scaled, "f": force}, *free, parameters=GUESS | {"w": 1}, offset=0.0,
        start={"x": 0, "v": 0}, outputs={"g": "acceleration:x/9.81 - 1", "f": "force:stop"},
        sigma=1e-3,
    )  # fmt: skip
    np.testing.assert_allclose(found.estimates, truth, rtol=0, atol=1e-9)
    check_errors(found, predicted, 1e-4)


def test_a_sample_at_an_impact_is_refused_with_words():
    motion = ns.simulate(IMPACTING, POINT, {"x": -0.6, "v": 0}, until=8)
    at = float(motion.times[1])
    data = {"t": np.sort(np.r_[np.linspace(0.1, 7.9, 20), at]), "a": np.zeros(21)}
    with pytest.raises(InputError, match=r"a jumps at .* at wall-reaches-stop: leave out"):
        ns.fit(
            IMPACTING, data, parameters=POINT, free=["c"], start={"x": -0.6, "v": 0},
            outputs={"a": "acceleration:x"},
        )  # fmt: skip


# --- bad input


MEASURED = {"w": [1.0], "amplitude:x": [1.0]}


@pytest.mark.parametrize(
    ("columns", "free", "told"),
    [
        ({"amplitude:z": [1]}, (), "unknown name 'z'"),
        ({"peak:force:door": [1]}, (), "unknown contact 'door'"),
        ({"t": [1]}, (), "column 't' is no parameter"),
        ({"w": [1.0, 2]}, (), "columns differ in length"),
        ({"w": [np.nan]}, (), "parameter w is missing or not finite"),
        ({"amplitude:x": [np.nan]}, (), "nothing is measured"),
        ({}, (), "1 measured numbers are too few for 3 free"),
        ({}, ("w",), "w is free, and known in experiment 1"),
        ({}, ("x0",), "x0 belongs to a motion"),
        ({"w": [1.6, 2, 3], "amplitude:x": [0.1, 0.2, 0.3]}, ("s",), "depends on s"),
        ({"w": [1, -1], "amplitude:x": [1, 1]}, ("k",), "w = -1"),
    ],
)
def test_bad_input_is_one_line(columns, free, told):
    assert told in refusal(MEASURED | columns, *free)


@pytest.mark.parametrize(
    ("data", "responses", "told"),
    [
        ({"w": [1.0], "size:x": [1]}, None, "unknown column 'size:x'"),
        ({"w": [1.0], "A": [1]}, {"A": "size:x"}, "unknown kind of response"),
        ({"w": [1.0], "A": [1]}, {"A": "x"}, "'x' is not KIND:OUTPUT"),
        (MEASURED, {"B": "rms:x"}, "'B'"),
        ({"amplitude:x": [1.0, 2, 3, 4]}, None, "touching needs a value for: w"),
    ],
)
def test_wrong_responses(data, responses, told):
    assert told in refusal(data, responses=responses)


def test_no_harmonic_without_a_forcing():
    data = {"k1": [1.0, 2.0], "phase:x1": [0.1, 0.2]}
    with pytest.raises(InputError, match="belongs to a forcing, which rigid-stop has not"):
        ns.fit("rigid-stop", data, parameters={"m1": 1, "m2": 2, "k2": 5, "r": 0.8}, free=["m1"])
