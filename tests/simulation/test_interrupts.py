"""Work in C ends at once when a signal wants it to, in this thread and in others."""

import gc
import signal
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from itertools import pairwise
from threading import Event

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.runtime.core.parallel import check_called_off, thread_pool
from nonsmooth.runtime.explore.charting.workers import run_threads
from nonsmooth.runtime.model.kernels import load_orbit
from tests.two_masses import CHAIN, RUBBING

pytestmark = [
    pytest.mark.compiled,
    pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="no timer that sends signals"),
]
GRAZING = dict(m1=1, m2=1, k1=2, k2=3, k3=1)
STARTS = np.random.default_rng(0).normal(size=(40_000, 4))
CONTACTS = [("free", "first-reaches-stop"), ("contact", "first-leaves-stop")]
MANY = 250_000
RINGS = 0.01  # seconds from one to the next
WAITING = ("threading.py", "_base.py")  # where who waits for threads may wait again and again


class Rung(BaseException):
    """As KeyboardInterrupt, which would end the tests too if it came late."""


def admissible(count):
    """Orbits that stick for so long that each takes milliseconds."""
    kernels = load_orbit("dry-friction/symmetric")
    names = kernels.parameter_names
    point = dict(chi=0.5, eta=1.0, V=1e-4, e2=1.0)
    parameters = np.array([point[name] for name in names])
    unknowns = np.full((count, len(kernels.unknowns)), 2e4)
    return kernels.admissible(np.broadcast_to(parameters, (count, len(names))), unknowns)


def chart_threads():
    def work(number):
        ns.simulate("dry-friction", RUBBING, STARTS, until=1e9, transitions=10**9, threads=1)

    run_threads(work, range(4), 2, lambda done: None)


CASES = {
    "a motion": lambda: ns.simulate(
        "dry-friction", RUBBING, [0.1, 0.2, 0.3, -0.1], until=1e9, transitions=10**8
    ),
    "a motion without events": lambda: ns.simulate(
        "elastic-stop", GRAZING, [-1, "-0.5", 0, 0], until=1e9
    ),
    "many motions": lambda: ns.simulate(
        "dry-friction", RUBBING, STARTS, until=1e9, transitions=10**9, threads=2
    ),
    "orbits in one call": lambda: ns.solve(
        "dry-friction/global-stick", {"eta": np.linspace(0.9, 1.1, MANY)}, threads=1, chunk=MANY
    ),
    "orbits in threads": lambda: ns.solve(
        "dry-friction/global-stick", {"eta": np.linspace(0.9, 1.1, 4 * MANY)}, threads=2
    ),
    "long orbits": lambda: admissible(20_000),
    "orbits of an itinerary": lambda: ns.solve(
        "elastic-stop", {**CHAIN, "k3": np.linspace(5, 40, MANY // 2)}, [1.0, 1.0],
        itinerary=CONTACTS, admissibility=False, threads=2,
    ),
    "chunks of a chart": chart_threads,
}  # fmt: skip


@pytest.mark.parametrize("name", CASES)
def test_a_signal_ends_it(name):
    """Signals are heard several times in the middle of a call, and then one ends it."""
    heard = []

    def ring(_, frame):
        while frame and frame.f_code.co_filename.endswith(WAITING):
            frame = frame.f_back
        heard.append((frame, frame.f_lasti if frame else 0))
        if sum(place == after for place, after in pairwise(heard)) == 3:
            signal.setitimer(signal.ITIMER_REAL, 0)
            raise Rung

    ns.solve("dry-friction/global-stick")  # what is loaded once
    before = signal.signal(signal.SIGALRM, ring)
    gc.disable()  # what rings in a callback of the collector, as hypothesis has one, is lost
    try:
        signal.setitimer(signal.ITIMER_REAL, RINGS, RINGS)
        with pytest.raises(Rung):
            CASES[name]()
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
        heard.clear()
        gc.enable()


def wait_until_called_off():
    pause = Event()
    while True:
        check_called_off()
        pause.wait(0.01)


@pytest.mark.parametrize("name", ["a motion", "orbits in one call", "long orbits"])
def test_it_ends_in_a_thread_that_is_called_off(name):
    begun = Event()

    def work():
        begun.set()
        with pytest.raises(KeyboardInterrupt):
            wait_until_called_off()
        CASES[name]()

    with suppress(ValueError), thread_pool(1) as pool:
        working = pool.submit(work)
        begun.wait()
        raise ValueError("so")
    assert isinstance(working.exception(), KeyboardInterrupt)


def test_a_failure_calls_off_the_pool_and_those_inside_it():
    begun, ended = Event(), Event()

    def inner():
        begun.set()
        with pytest.raises(KeyboardInterrupt):
            wait_until_called_off()
        ended.set()

    def outer():
        with thread_pool(1) as pool:
            pool.submit(inner).result()

    def fail():
        with thread_pool(1) as pool:
            pool.submit(outer)
            begun.wait()
            raise ValueError("so")

    with pytest.raises(ValueError, match="so"):
        fail()
    assert ended.is_set()
    check_called_off()
    with ThreadPoolExecutor(1) as pool:  # and none of another pool
        pool.submit(check_called_off).result()
