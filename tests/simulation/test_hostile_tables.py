"""Tables of numbers that no system has: an engine ends with a status, and soon."""

import math
import signal
from contextlib import contextmanager
from dataclasses import replace

import numpy as np
import pytest

from nonsmooth import InputError
from nonsmooth.runtime.model.engine_layout import numbers_of
from nonsmooth.runtime.model.engine_run import Status
from nonsmooth.runtime.model.kernels import compiled_engine
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.simulation.engines import run_motions
from nonsmooth.runtime.simulation.simulate import follow
from tests.engines import with_both
from tests.two_masses import SYSTEMS

HOSTILE = (math.inf, -math.inf, math.nan, 1e308, -1e308, 5e-324, -5e-324, 1e150, 1e-150, 1e30, 0.0)
LIMIT = 20.0  # seconds that a processor works on one motion


class Late(BaseException):
    """A motion that takes longer than LIMIT."""


@contextmanager
def limited():
    def late(*_):
        raise Late

    before = signal.signal(signal.SIGPROF, late)
    signal.setitimer(signal.ITIMER_PROF, LIMIT)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)


def tables(rng, system):
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


def of_numbers(system, numbers):
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


@pytest.mark.parametrize("name", SYSTEMS)
def test_every_table_has_an_answer_or_a_status(name, backend):
    system, rng = piecewise(name, SYSTEMS[name]), np.random.default_rng([*name.encode()])
    told = set()
    for _ in range(60 if backend == "c" else 20):
        numbers, state = tables(rng, system), rng.normal(size=4)
        if rng.random() < 0.3:
            state[rng.integers(4)] = rng.choice(HOSTILE)
        where = int(rng.integers(len(system.structure.configurations)))
        until = float(rng.choice([10.0, 1e-300, 1e4 if backend == "c" else 100.0]))
        with limited(), np.errstate(all="ignore"):
            if backend == "c":
                begin, ends = (np.zeros(1), state[None], np.array([where])), np.array([until])
                engine, structure = compiled_engine(), system.structure
                found = run_motions(engine, structure, numbers[None], *begin, ends, 5).status[0]
            else:
                found = follow(of_numbers(system, numbers), state, where, until, 5).status
        told.add(Status(int(found)).name)
    assert {"OVERFLOW", "UNTIL"} <= told


@pytest.mark.compiled
@pytest.mark.parametrize("name", ["rigid-stop", "elastic-stop"])
def test_both_engines_tell_the_same_of_hostile_parameters(name):
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
