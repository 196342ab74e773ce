"""Relations between parameters: checked wherever values are taken."""

from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from typer.testing import CliRunner

import nonsmooth as ns
from nonsmooth import InputError, solve
from nonsmooth.derive import Friction, RigidStop, Slider, SoftStop
from nonsmooth.runtime.cli.program import app
from nonsmooth.runtime.model.kernels import load_system
from nonsmooth.runtime.model.piecewise import piecewise
from tests.one_mass import one_mass

BELT = """
import sympy as sp
from nonsmooth.derive import Friction, Itinerary, Reference, oscillator

u, s, V = sp.symbols("u s V")
system = oscillator(
    "belt", ["x"], [[1]], [[1]], elements=[Friction("x", u, s, velocity=V, name="belt")]
)
orbits = [
    Itinerary(
        "stick-slip",
        system,
        (("stick", "belt-breaks-forward", "ts"), ("slip", "belt-reaches-belt", "tau")),
        reference=Reference(
            {"u": "1", "s": "1.3", "V": "0.5"}, {"ts": "1.2", "tau": "5.2", "x0": "0.7"}
        ),
    )
]
"""


def test_constraints_hold_where_their_expressions_are_not_negative():
    a, b, n = sp.symbols("a b n")
    rubbing = Friction("x", 1, a / 2, normal=n - b**2 / 3 - a * b / (1 + n) - 1)
    system = one_mass("loaded", rubbing)
    kernels, symbols = load_system(system), {p.name: p.symbol for p in system.parameters}
    assert len(system.constraints) == 2
    rng, kept = np.random.default_rng(5), 0
    for _ in range(100):
        numbers = [Fraction(int(k), 6) for k in rng.integers(1, 30, 3)]
        values = dict(zip(("a", "b", "n"), numbers, strict=True))
        point = {symbols[k]: sp.Rational(v.numerator, v.denominator) for k, v in values.items()}
        holds = all(c.subs(point) >= 0 for c in system.constraints)
        kept += holds
        if holds:
            piecewise(kernels, values)
        else:
            with pytest.raises(InputError, match="does not hold"):
                piecewise(kernels, values)
    assert 10 < kept < 90


a, b = sp.symbols("a b")
NEEDED = {
    "friction": (Friction("x", a, b), (b - a,)),
    "load": (Friction("x", a, normal=a - b), (a - b,)),
    "slope": (Friction("x", a, falling=a - b), (a - b,)),
    "rising": (Friction("x", a, falling=-b), ()),
    "restitution": (RigidStop("x", 1, a - b), (a - b, 1 - a + b)),
    "plain restitution": (RigidStop("x", 1, a), ()),
    "slider": (Slider("x", a, a - b), (a - b,)),
    "soft stop": (SoftStop("x", 1, a, damping=a - b), (a - b,)),
}


@pytest.mark.parametrize("name", NEEDED)
def test_elements_need_what_their_laws_need(name):
    element, needed = NEEDED[name]
    system = one_mass("needing", element)
    own = {p.name: p.symbol for p in system.parameters}
    given = {symbol: own[str(symbol)] for symbol in (a, b) if str(symbol) in own}
    assert {sp.expand(c) for c in system.constraints} == {
        sp.expand(expression.subs(given)) for expression in needed
    }


def test_orbits_with_kernels_keep_them_too(tmp_path, monkeypatch):
    monkeypatch.setenv("NONSMOOTH_CACHE", str(tmp_path / "cache"))
    monkeypatch.chdir(tmp_path)
    Path("belt.py").write_text(BELT)
    answer = CliRunner().invoke(app, ["generate", "belt.py", "--out", "kernels"])
    assert answer.exit_code == 0
    kernels = "kernels:stick-slip"
    orbit = solve(kernels)
    assert float(orbit.unknowns["ts"]) == pytest.approx(1.2)
    assert ns.refine(orbit, 30).stability.margin == 1  # a map of rank zero
    with pytest.raises(InputError, match=r"s = 0\.9, u = 1: s - u >= 0 does not hold"):
        solve(kernels, {"s": "0.9"})
    found = ns.solve(kernels, {"s": np.array([0.9, 1.3])})
    assert found.status.tolist() == [2, 0]
