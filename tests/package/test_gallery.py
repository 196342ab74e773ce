"""The gallery: every file through the public face, against closed forms and other routes."""

import math
import shlex
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from numpy.testing import assert_allclose

import nonsmooth as ns
from tests.cli.test_cli import EXAMPLES, run
from tests.places import CHECKOUT, GALLERY
from tests.tables import slow

FORCED = {"x": "-x", "v": "-v", "c1": "-c1", "s1": "-s1"}  # half a period of the forcing later
ORBITS = [
    "beam:one-contact",
    "brake_pad:lifting",
    "brake_pad:pressed",
    "den_hartog:without-rest",
    "impact_oscillator:one-period",
    "impact_oscillator:two-periods",
    "impact_oscillator:three-periods",
    "jenkins:yielding-both-ways",
    "mass_on_belt:stick-slip",
    "piecewise_stiffness:one-contact",
    "piecewise_stiffness:doubled",
    "piecewise_stiffness:subharmonic",
    "switched_damping:limit-cycle",
    "three_masses:two-each",
    "two_belts:both-stick",
    "two_belts:second-sticks",
    "two_stops:symmetric",
    "two_stops:broken",
]


@pytest.fixture(autouse=True, scope="module")
def cache(tmp_path_factory):
    """What is derived is kept for this file's tests alone, and not compiled, which takes longer."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("NONSMOOTH_CACHE", str(tmp_path_factory.mktemp("cache")))
        patch.setenv("CC", "none")
        yield


def page(name):
    return str(GALLERY / f"{name}.py")


def solved(name, orbit, *arguments, **options):
    return ns.solve(f"{page(name)}:{orbit}", *arguments, **options)


def eigenvalues(trace, determinant):
    """Of a 2 x 2 matrix, in the order of their real and imaginary parts."""
    return sorted(np.roots([1, -trace, determinant]), key=lambda m: (m.real, m.imag))


def multipliers(orbit):
    return sorted(orbit.multipliers.tolist(), key=lambda m: (m.real, m.imag))


# --- all ----------------------------------------------------------------------------------


def test_the_number_of_oscillators_is_that_of_the_gallery():
    rows = (GALLERY / "README.md").read_text(encoding="utf-8").count("| [![")
    told = ["fifteen", "sixteen", "seventeen", "eighteen", "nineteen", "twenty"][rows - 15]
    for page in (CHECKOUT / "README.md", CHECKOUT / "docs" / "tutorial.md"):
        assert f"{told} oscillators" in page.read_text(encoding="utf-8"), page


def test_the_index_names_every_file():
    index = (GALLERY / "README.md").read_text(encoding="utf-8")
    files = sorted(GALLERY.glob("*.py"))
    assert len(files) >= 10
    for file in files:
        assert f"[{file.name}]({file.name})" in index
        assert f"docs/gallery/{file.name}" in index


def asked_elsewhere(command):
    """Whether it solves an orbit that is solved below, or is an example of the help."""
    asked = command.replace("docs/gallery/", "")
    orbit = asked.removeprefix("nonsmooth solve ").replace(".py", "")
    return orbit in ORBITS or asked in EXAMPLES


def commands():
    text = (GALLERY / "README.md").read_text(encoding="utf-8")
    lines = [line for line in text.splitlines() if line.startswith("nonsmooth ")]
    return [line for line in lines if not asked_elsewhere(line)]


DEAR = {  # whose commands are given for other systems too
    *("nonsmooth solve docs/gallery/backlash_gear.py", "nonsmooth continue docs/gallery/brake_pad"),
    *("nonsmooth certify docs/gallery/brake_pad", "nonsmooth certify docs/gallery/backlash"),
    "nonsmooth fit ",
}
COMMANDS = [slow(line, when=line.startswith(tuple(DEAR))) for line in commands()]


@pytest.mark.parametrize("command", COMMANDS)
def test_the_commands_of_the_index_run(command, monkeypatch):
    monkeypatch.chdir(GALLERY.parents[1])
    code, out, err = run(*shlex.split(command, comments=True)[1:])
    assert code == 0, err
    assert len(out) > 100


@pytest.mark.slow
def test_the_python_of_the_index_runs(monkeypatch, capsys):
    monkeypatch.chdir(GALLERY.parents[1])
    text = (GALLERY / "README.md").read_text(encoding="utf-8")
    exec(text.partition("```python\n")[2].partition("```")[0], {})
    amplitude, period = capsys.readouterr().out.split()
    assert amplitude.startswith("1." + 28 * "3")
    assert float(period) == pytest.approx(2 * math.pi / 0.9, rel=1e-13)


LONG = "two_belts:second-sticks"


@pytest.mark.parametrize("name", [slow(each, when=each == LONG) for each in ORBITS])
def test_declared_orbits_are_motions(name):
    file, orbit = name.split(":")
    found = solved(file, orbit)
    assert found.converged
    assert found.digits >= 10
    assert found.stability.verdict == "stable"
    assert found.admissibility.verdict is True
    motion = ns.simulate(
        page(file), {**found.given, **found.opened}, found.trajectory()(0.5 * found.dwell_times[0]),
        found.itinerary[0][0], transitions=len(found.itinerary),
    )  # fmt: skip
    assert [b for entry in motion.boundaries[1:] for b in entry] == [b for _, b in found.itinerary]
    assert_allclose(
        motion.states[-1], found.states[0], rtol=0, atol=1e-11 * np.abs(found.states).max()
    )


# --- the impact oscillator ----------------------------------------------------------------


def one_impact(n, w, r, sigma, lib=math):
    """Impact velocity and trace of the orbits that strike once in n periods of the forcing."""
    period, g = 2 * lib.pi * n / w, 1 / (1 - w * w)
    C = 1 / lib.tan(period / 2)
    a, b = ((1 + r) * C / 2) ** 2 + ((1 - r) / (2 * w)) ** 2, (1 + r) * sigma * C
    root = b * b - 4 * a * (sigma**2 - g * g)
    found = []
    for sign in (1, -1) if root > 0 else ():
        U = (-b + sign * lib.sqrt(root)) / (2 * a)
        if U > 0:
            force = (sigma + (1 + r) * C * U / 2) / g - sigma
            found.append((U, -2 * r * lib.cos(period) + (1 + r) * lib.sin(period) * force / U))
    return found


def impact_start(n, w, r, sigma, U):
    """Dwell time and state behind the impact."""
    g, C = 1 / (1 - w * w), 1 / math.tan(math.pi * n / w)
    phase = ((sigma + (1 + r) * C * U / 2) / g, -(1 - r) * U / (2 * g * w))
    start = zip(("x0", "v0", "c10", "s10"), (sigma, -r * U, *phase), strict=True)
    return {"T": 2 * math.pi * n / w, **dict(start)}


NAMES = {1: ("one-period", 2.4), 2: ("two-periods", 4.4), 3: ("three-periods", 6.4)}


@pytest.mark.parametrize("n", NAMES)
@pytest.mark.parametrize("place", [0.0, 0.3, -2.0])
def test_orbits_of_one_impact_have_closed_forms(n, place):
    (name, w), r = NAMES[n], 0.8
    sigma = place / (w * w - 1)
    found = one_impact(n, w, r, sigma)
    assert found
    for U, trace in found:
        guess = impact_start(n, w, r, sigma, U)
        near = {key: value + 1e-4 for key, value in guess.items()}
        orbit = solved("impact_oscillator", name, {"sigma": repr(sigma)}, near)
        assert orbit.period == pytest.approx(2 * math.pi * n / w, rel=1e-13)
        for key, value in orbit.unknowns.items():
            assert value == pytest.approx(guess[key], abs=1e-11)
        assert_allclose(
            multipliers(orbit), eigenvalues(trace, r * r), rtol=0, atol=1e-9 * (1 + abs(trace))
        )
    (top, _) = found[0]
    followed = solved("impact_oscillator", name, {"sigma": repr(sigma)})
    assert followed.unknowns["v0"] == pytest.approx(-r * top, abs=1e-12)


# --- belts --------------------------------------------------------------------------------


@pytest.mark.parametrize(("e", "V"), [("0.3", "0.5"), ("2", "0.1"), ("0.05", "3")])
def test_stick_slip_on_a_belt_to_forty_digits(e, V):
    orbit = ns.refine(solved("mass_on_belt", "stick-slip", {"e": e, "V": V}), 40)
    with mpmath.workdps(60):
        excess, speed = mpmath.mpf(e), mpmath.mpf(V)
        period = 2 * mpmath.pi - 2 * mpmath.atan(excess / speed) + 2 * excess / speed
        assert abs(orbit.period - period) < mpmath.mpf(10) ** -38
        assert abs(orbit.unknowns["ts"] - 2 * excess / speed) < mpmath.mpf(10) ** -38
    assert orbit.admissibility.verdict is True
    assert abs(complex(orbit.multipliers[0])) < 1e-30


# --- two stops ----------------------------------------------------------------------------


def symmetric(w, r, d, n=1):
    """Impact velocity of the symmetric orbit, and the trace of its half map."""
    half, g = math.pi * n / w, 1 / (1 - w * w)
    C = math.tan(half / 2)
    a, b = ((1 + r) * C / 2) ** 2 + ((1 - r) / (2 * w)) ** 2, -(1 + r) * d * C
    U = (-b + math.sqrt(b * b - 4 * a * (d * d - g * g))) / (2 * a)
    force = ((1 + r) * C * U / 2 - d) / g + d
    return U, 2 * r * math.cos(half) + (1 + r) * math.sin(half) * force / U


def half_orbit(d, w=1.5):
    data = {"d": repr(d), "r": "0.8", "w": repr(w)}
    phases = [("free-free", "right-reaches-stop")]
    return ns.solve(page("two_stops"), data, [math.pi / w], itinerary=phases, symmetry=FORCED)


@pytest.mark.parametrize("d", [0.45, 0.54, 0.6])
def test_the_symmetric_orbit_from_its_half(d):
    orbit, (U, trace) = half_orbit(d), symmetric(1.5, 0.8, d)
    assert orbit.states[0, 1] == pytest.approx(0.8 * U, rel=1e-12)
    assert orbit.period == pytest.approx(4 * math.pi / 3, rel=1e-13)
    squares = sorted((m * m for m in eigenvalues(trace, 0.64)), key=lambda m: (m.real, m.imag))
    assert_allclose(multipliers(orbit), squares, rtol=0, atol=1e-11)
    assert orbit.admissibility.verdict is True
    whole = ns.solve(
        page("two_stops"),
        orbit.given,
        [*orbit.dwell_times, *orbit.states[0]],
        itinerary=orbit.itinerary,
    )
    assert_allclose(whole.states, orbit.states, rtol=0, atol=1e-11)


# --- friction under forcing ---------------------------------------------------------------


def den_hartog(S, W, digits=15):
    w = float(Fraction(W))
    R = 1 / (1 - w * w)
    guess = [abs(R), 0, math.copysign(1, R), 0]
    return ns.solve(
        page("den_hartog"),
        {"S": S, "W": W},
        [*[math.pi / w], *guess],
        itinerary=[("slip", "ground-reaches-belt")],
        symmetry=FORCED,
        digits=digits,
    )


@pytest.mark.parametrize(("S", "W"), [("0.2", "0.6"), ("0.1", "0.7"), ("0.3", "1.4"), ("0.2", "2")])
def test_den_hartogs_amplitude(S, W):
    R, U = 1 / (1 - float(W) ** 2), math.tan(math.pi / (2 * float(W))) / float(W)
    orbit = den_hartog(S, W)
    assert orbit.states[0, 0] == pytest.approx(math.sqrt(R**2 - (float(S) * U) ** 2), rel=1e-12)
    assert orbit.admissibility.verdict is True
    # at a turning point the acceleration jumps; nothing else changes areas
    x, _, c, _ = orbit.states[0]
    jump = (c - x + float(S)) / (c - x - float(S))
    assert np.prod(orbit.multipliers) == pytest.approx(jump**2, rel=1e-11)


def test_den_hartogs_oscillator_at_half_its_frequency():
    orbit = den_hartog("0.2", "1/2", digits=30)
    with mpmath.workdps(50):
        assert abs(orbit.states[0, 0] - mpmath.mpf(4) / 3) < mpmath.mpf(10) ** -30
        least, largest = sorted(m.real for m in orbit.multipliers)
        assert abs(least - mpmath.mpf(1) / 16) < mpmath.mpf(10) ** -28
        assert abs(largest - 1) < mpmath.mpf(10) ** -28
    assert orbit.admissibility.verdict is True
    # the multiplier 1: shifted, it comes back as well
    shifted = [4 / 3 + 0.05, 0, 1, 0]
    motion = ns.simulate(page("den_hartog"), {"S": "0.2", "W": "1/2"}, shifted, transitions=2)
    assert_allclose(motion.times[1:], [2 * math.pi, 4 * math.pi], rtol=1e-12)
    assert_allclose(motion.states[2], shifted, rtol=0, atol=1e-12)


def test_a_jenkins_element_takes_the_area_of_its_loop():
    orbit = solved("jenkins", "yielding-both-ways")
    slide, turn = orbit.dwell_times[:2]
    half = ns.solve(
        page("jenkins"),
        orbit.given,
        [*[slide, turn], *orbit.states[0]],
        itinerary=orbit.itinerary[:2],
        symmetry={**FORCED, "s_joint": "-s_joint"},
    )
    assert_allclose(half.states, orbit.states, rtol=0, atol=1e-11)
    amplitude = -orbit.states[0, 0]
    # work of the forcing: F x' cos(w t), of the damper: 2 zeta x'^2
    work = 0.0
    motion, begin = orbit.trajectory(), 0.0
    nodes, weights = np.polynomial.legendre.leggauss(40)
    for dwell in orbit.dwell_times:
        times = begin + dwell * (nodes + 1) / 2
        states = motion(np.minimum(times, motion.end))
        power = 0.6 * states[:, 2] * states[:, 1] - 0.1 * states[:, 1] ** 2
        work += dwell / 2 * float(weights @ power)
        begin += dwell
    assert work == pytest.approx(4 * 0.2 * (amplitude - 0.2 / 3), rel=1e-11)


# --- the brake pad ------------------------------------------------------------------------


@pytest.mark.slow
def test_no_claim_holds_where_the_load_of_a_pad_is_negative():
    lifting, pressed = (solved("brake_pad", name) for name in ("lifting", "pressed"))
    height = 4 / math.hypot(4 - 1.3**2, 1.3 / 5)
    assert lifting.dwell_times[0] == pytest.approx(2 / 1.3 * math.acos(0.5 / height), abs=1e-14)
    assert lifting.states[0, 1] == pytest.approx(0.5, abs=1e-14)  # it lifts where 2 y is the load
    for orbit in (lifting, pressed):
        assert ns.certify(orbit).claims["admissibility"] == "proved"
    beyond = solved("brake_pad", "pressed", {"A": "4"})
    assert beyond.converged
    assert beyond.admissibility.verdict is False
    assert ns.certify(beyond).claims["admissibility"] == "refuted"
    branch = ns.continue_orbit(pressed, "A", (1.1, 1.3))
    (graze,) = (event for event in branch.events if event.kind == "grazing")
    assert graze.boundary == "pad-lifts"
    assert float(graze.value) == pytest.approx(2 / height, abs=1e-10)


@pytest.mark.slow  # its kernels are compiled first, but not optimised
def test_those_of_many_hold_where_the_load_of_a_pad_is_positive(monkeypatch):
    monkeypatch.delenv("CC")
    monkeypatch.setenv("CFLAGS", "-O0")
    many = ns.solve(f"{page('brake_pad')}:pressed", {"A": np.array([1.15, 1.17, 4.0])})
    assert many.admissible.tolist() == [True, False, False]
