"""Tables of numbers that no system has: an engine ends with a status, and soon."""

from __future__ import annotations

import math
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from nonsmooth import InputError
from nonsmooth.runtime.model.engine_layout import numbers_of
from nonsmooth.runtime.model.engine_run import Status
from nonsmooth.runtime.model.kernels import compiled_engine
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.simulation.engines import run_motions
from nonsmooth.runtime.simulation.simulate import follow
from tests.engines import with_both, with_engine
from tests.places import CHECKOUT
from tests.two_masses import SYSTEMS

HOSTILE = (math.inf, -math.inf, math.nan, 1e308, -1e308, 5e-324, -5e-324, 1e150, 1e-150, 1e30, 0.0)
LIMIT = 20.0  # seconds that a processor works on one motion


class Late(BaseException):
    """A motion that takes longer than LIMIT."""


@contextmanager
def limited() -> Iterator[None]:
    def late(*_: object) -> None:
        raise Late

    before = signal.signal(signal.SIGPROF, late)
    signal.setitimer(signal.ITIMER_PROF, LIMIT)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)


def tables(rng: np.random.Generator, system: Any) -> np.ndarray:
    """Numbers of a system with a few that are hostile, anywhere or among the exponents."""
    numbers = numbers_of(system).copy()
    before = system.fields.size + system.rows.size + system.resets.size
    exponents = sum(part.size for part in system.exponents)
    count = rng.integers(1, 4)
    places = (
        before + rng.integers(0, exponents, count)
        if rng.random() < 0.3
        else rng.integers(0, numbers.size, count)
    )
    numbers[places] = rng.choice(HOSTILE, count)
    return numbers


def of_numbers(system: Any, numbers: np.ndarray) -> Any:
    shaped, place = [], 0
    for part in (*system.numbers, *system.exponents, *system.flows):
        shaped.append(numbers[place : place + part.size].reshape(part.shape))
        place += part.size
    count = 3 + len(system.exponents)
    return replace(
        system,
        **dict(zip(("fields", "rows", "resets"), shaped, strict=False)),
        exponents=tuple(shaped[3:count]),
        flows=tuple(shaped[count:]),
    )


@pytest.mark.compiled
@pytest.mark.parametrize("name", SYSTEMS)
def test_every_table_has_an_answer_or_a_status(name: str) -> None:
    system, rng = piecewise(name, SYSTEMS[name]), np.random.default_rng([*name.encode()])
    engine, told = compiled_engine(), set()
    for _ in range(60):
        numbers, state = tables(rng, system), rng.normal(size=(1, 4))
        if rng.random() < 0.3:
            state[0, rng.integers(4)] = rng.choice(HOSTILE)
        where = rng.integers(len(system.structure.configurations), size=1)
        until = rng.choice([10.0, 1e-300, 1e4], 1)
        with limited():
            found = run_motions(
                engine, system.structure, numbers[None], np.zeros(1), state, where, until, 5
            )
        told.add(Status(int(found.status[0])))
    assert {Status.OVERFLOW, Status.UNTIL} <= told


@pytest.mark.parametrize("name", SYSTEMS)
def test_the_engine_in_python_ends_too(name: str) -> None:
    system, rng = piecewise(name, SYSTEMS[name]), np.random.default_rng([*name.encode()])
    for _ in range(20):
        changed = of_numbers(system, tables(rng, system))
        until = float(rng.choice([10.0, 1e-300, 100.0]))
        with limited(), np.errstate(all="ignore"):
            found = with_engine("numpy", follow, changed, rng.normal(size=4), 0, until, 5)
        assert found.status in Status


@pytest.mark.compiled
@pytest.mark.parametrize("name", ["rigid-stop", "elastic-stop"])
def test_both_engines_tell_the_same_of_hostile_parameters(name: str) -> None:
    """Parameters over 40 decades: tables that a system may have."""
    rng, names = np.random.default_rng([*name.encode(), 1]), [n for n in SYSTEMS[name] if n != "r"]
    compared = 0
    for _ in range(40):
        data = {n: float(10.0 ** rng.uniform(-1, 1)) for n in names}
        data[str(rng.choice(names))] = float(10.0 ** rng.uniform(-20, 20))
        data |= {"r": 0.6} if "r" in SYSTEMS[name] else {}
        try:
            system = piecewise(name, data)
        except InputError:
            continue
        if not np.isfinite(numbers_of(system)).all():
            continue
        state = rng.normal(size=4) * [0.5, 0.5, 1, 1]
        fastest = max(float(np.hypot(*part.T).max()) for part in system.exponents)
        until = float(30 / fastest)
        with limited(), np.errstate(all="ignore"):
            found, known = with_both(follow, system, state, 0, until, 3)
        assert found.status == known.status, data
        assert len(found.times) == len(known.times), data
        compared += 1
    assert compared > 20


@pytest.mark.slow
def test_the_oscillator_of_the_commands_page_ends_at_numbers_beyond_doubles(tmp_path: Path) -> None:
    text = (CHECKOUT / "docs/how_to/commands.md").read_text(encoding="utf-8")
    begin = text.index("# my_oscillator.py")
    (tmp_path / "my_oscillator.py").write_text(text[begin : text.index("```", begin)])
    words = "zeta=0.05 Omega=1e300 gap=1e-9 r=0.5 --from x=-1e-9,v=-1e9 --transitions 20"
    code = "from nonsmooth.runtime.cli.program import main; main()"
    command = [sys.executable, "-c", code, "simulate", "my_oscillator.py", *words.split()]
    told = subprocess.run(command, capture_output=True, text=True, timeout=600, cwd=tmp_path,
                          env=dict(os.environ), check=False)  # fmt: skip
    assert "numbers are larger, or times shorter" in told.stdout, told.stderr
    assert told.returncode == 1
    (line,) = told.stderr.splitlines()
    assert line.startswith("nonsmooth: the motion ends at ")
