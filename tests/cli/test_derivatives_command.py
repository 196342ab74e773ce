"""`nonsmooth solve --derivatives`."""

import json

import pytest

import nonsmooth as ns
from nonsmooth.runtime.cli.program import app


def told(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str, str]:
    with pytest.raises(SystemExit) as ended:
        app(list(arguments), prog_name="nonsmooth")
    out, err = capsys.readouterr()
    return int(ended.value.code or 0), out, err


def test_derivatives_are_told_with_all_digits(capsys: pytest.CaptureFixture[str]) -> None:
    name = "dry-friction/global-stick"
    code, out, _ = told(capsys, "solve", name, "--derivatives", "eta,V", "--digits", "30", "--json")
    assert code == 0
    found = json.loads(out)["derivatives"]
    precise = ns.refine(ns.solve(name), 35).derivatives(["eta", "V"])
    for quantity in ("tau", "period", "trace", "determinant", "spectral_radius"):
        for place, parameter in enumerate(("eta", "V")):
            mp = precise.orbit.arithmetic.mp
            rate = precise.quantity(quantity)[1][place]
            assert abs(mp.mpf(found[quantity][parameter]) - rate) < mp.mpf(10) ** -29
    code, out, _ = told(capsys, "solve", name, "--derivatives", "V")
    assert code == 0
    assert "by V" in out
    assert "spectral_radius" in out


def test_what_was_not_given_is_told_in_one_line(capsys: pytest.CaptureFixture[str]) -> None:
    code, _, err = told(capsys, "solve", "dry-friction/global-stick", "--derivatives", "W")
    assert code == 2
    assert "unknown given parameter 'W'" in err
    assert err.count("\n") == 1
