"""`nonsmooth solve --derivatives`."""

import nonsmooth as ns
from tests.cli.test_cli import run, told

NAME = "dry-friction/global-stick"


def test_derivatives_are_told_with_all_digits() -> None:
    found = told("solve", NAME, "--derivatives", "eta,V", "--digits", "30")["derivatives"]
    precise = ns.refine(ns.solve(NAME), 35).derivatives(["eta", "V"])
    for quantity in ("tau", "period", "trace", "determinant", "spectral_radius"):
        for place, parameter in enumerate(("eta", "V")):
            mp = precise.orbit.arithmetic.mp
            rate = precise.quantity(quantity)[1][place]
            assert abs(mp.mpf(found[quantity][parameter]) - rate) < mp.mpf(10) ** -29
    code, out, _ = run("solve", NAME, "--derivatives", "V")
    assert code == 0
    assert "by V" in out
    assert "spectral_radius" in out


def test_what_was_not_given_is_told_in_one_line() -> None:
    code, _, err = run("solve", NAME, "--derivatives", "W")
    assert code == 2
    assert "unknown given parameter 'W'" in err
    assert err.count("\n") == 1
