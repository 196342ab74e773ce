"""The section of benchmark.py on gradients of a motion with impacts, time and error."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from importlib.util import find_spec
from typing import Any

import mpmath
import numpy as np
import sympy as sp
from benchmarking.measuring import Row, interleaved, told

import nonsmooth as ns
from nonsmooth.derive import Harmonic, RigidStop, oscillator

NAMES = ("zeta", "gap", "r", "x0", "v0")
POINT = np.array([0.05, 0.3, 0.8, 0.0, 1.0])
OMEGA, END = 2, 20.0


def gradients(quick: bool) -> Iterator[Row]:
    """Gradient of a position behind impacts by five numbers: ours, differences, diffrax."""
    exact = reference(50)
    runs = 3 if quick else 7
    function = motion()
    ours = "ours"
    works: dict[str, Callable[[], np.ndarray]] = {
        ours: lambda: function.jacobian(POINT)[0],
        "solve_ivp with events, central differences": lambda: differences(1e-12),
        "solve_ivp with events, central differences, rtol 1e-8": lambda: differences(1e-8),
    }
    if find_spec("diffrax") is None:
        told("diffrax is not installed (pip install diffrax): left out")
    else:
        for tolerance in (1e-8, 1e-12):
            works[f"diffrax, reverse mode, rtol {tolerance:.0e}"] = diffrax_gradient(tolerance)
    seconds = interleaved({name: (work, 1.0) for name, work in works.items()}, runs)
    for name, work in works.items():
        off = float(np.abs(work() - exact).max() / np.abs(exact).max())
        against = None if name == ours else ours
        yield Row(name, seconds[name], against=against, found=f"gradient off by {off:.1e}")


def motion() -> ns.DifferentiableFunction:
    """The position at the end as our function of the five numbers."""
    zeta, gap, r = sp.symbols("zeta gap r")
    system = oscillator(
        "impacting",
        ["x"],
        mass=[[1]],
        stiffness=[[1]],
        damping=[[2 * zeta]],
        forcing=[Harmonic(OMEGA, cosine=[1])],
        elements=[RigidStop("x", at=gap, restitution=r, name="stop")],
    )
    data = dict(zip(NAMES[:3], POINT[:3].tolist(), strict=True))
    start = dict(zip(("x", "v"), POINT[3:].tolist(), strict=True))
    return ns.motion_function(system, data, start, by=NAMES, times=[END], outputs=["x"])


# In any number of digits ---------------------------------------------------------------------


def state_at_the_end(numbers: Any, end: float, mp: Any) -> tuple[Any, int]:
    """Position at the end and number of impacts, by the closed form of each flight in mpmath."""
    zeta, gap, r, x, v = numbers
    now, damped = mp.mpf(0), mp.sqrt(1 - zeta**2)
    size = 1 / mp.mpc(1 - OMEGA**2, 2 * zeta * OMEGA)

    def flight(begin: Any, x: Any, v: Any) -> Callable[[Any], tuple[Any, Any]]:
        forced = size * mp.expj(OMEGA * begin)
        a, b = x - forced.real, v - (1j * OMEGA * forced).real
        rate = mp.mpc(-zeta, damped)
        free = mp.mpc(a, -(b + zeta * a) / damped)

        def at(time: Any) -> tuple[Any, Any]:
            own, driven = free * mp.exp(rate * time), forced * mp.expj(OMEGA * time)
            return (own + driven).real, (rate * own + 1j * OMEGA * driven).real

        return at

    count, step = 0, mp.mpf("0.01")
    while True:
        motion = flight(now, x, v)
        time = step / 100
        while now + time < end and motion(time + step)[0] < gap:
            time += step
        if now + time >= end:
            return motion(end - now)[0], count
        bracket = time, time + step
        time = mp.findroot(lambda t, at=motion: at(t)[0] - gap, bracket, solver="anderson")
        x, v = gap, -r * motion(time)[1]
        now, count = now + time, count + 1
        if now >= end:
            raise ValueError("the end is an impact")


def reference(digits: int) -> np.ndarray:
    """Gradient by central differences in so many digits (5,)."""
    mp = mpmath.mp.clone()
    mp.dps = 2 * digits
    point, step, found = [mp.mpf(value) for value in POINT], mp.mpf(10) ** -(digits // 2), []
    for place in range(len(point)):
        both = []
        for sign in (1, -1):
            moved = list(point)
            moved[place] += sign * step
            both.append(state_at_the_end(moved, END, mp)[0])
        found.append(float((both[0] - both[1]) / (2 * step)))
    return np.array(found)


# Peers ---------------------------------------------------------------------------------------


def integrated(numbers: np.ndarray, tolerance: float) -> float:
    """Position at the end by DOP853, which is stopped at each impact."""
    from scipy.integrate import solve_ivp

    zeta, gap, r, x, v = numbers

    def rates(t: float, y: np.ndarray) -> list[float]:
        return [y[1], np.cos(OMEGA * t) - 2 * zeta * y[1] - y[0]]

    def reaches(t: float, y: np.ndarray) -> float:
        return float(y[0] - gap)

    reaches.terminal, reaches.direction = True, 1  # type: ignore[attr-defined]  # SciPy reads them
    now, state = 0.0, np.array([x, v])
    while True:
        done = solve_ivp(
            rates, (now, END), state, "DOP853", events=reaches, rtol=tolerance, atol=tolerance
        )
        if done.status == 0:
            return float(done.y[0, -1])
        now, state = float(done.t[-1]), np.array([gap, -r * done.y[1, -1]])


def differences(tolerance: float) -> np.ndarray:
    """Gradient by central differences over the integrator, with the step that suits it."""
    step = tolerance ** (1 / 3)
    moves = step * np.eye(len(POINT))
    ahead, behind = (
        [integrated(POINT + sign * move, tolerance) for move in moves] for sign in (1, -1)
    )
    return (np.array(ahead) - np.array(behind)) / (2 * step)


def diffrax_gradient(tolerance: float) -> Callable[[], np.ndarray]:
    """Gradient by diffrax, whose events end a solve: one solve for each flight, compiled.

    The number of impacts has to be known when it is compiled.
    """
    import diffrax
    import jax
    import optimistix

    jax.config.update("jax_enable_x64", True)
    _, impacts = state_at_the_end([mpmath.mpf(value) for value in POINT], END, mpmath.mp)
    step = diffrax.PIDController(rtol=tolerance, atol=tolerance)
    root = optimistix.Newton(tolerance, tolerance)

    def rates(t: Any, y: Any, data: Any) -> Any:
        return jax.numpy.stack([y[1], jax.numpy.cos(OMEGA * t) - 2 * data[0] * y[1] - y[0]])

    def reaches(t: Any, y: Any, args: Any, **_: Any) -> Any:
        return y[0] - args[1]

    def flight(now: Any, state: Any, data: Any, event: Any) -> Any:
        term, solver = diffrax.ODETerm(rates), diffrax.Dopri8()
        return diffrax.diffeqsolve(
            term, solver, now, END, 0.01, state, data,
            stepsize_controller=step, event=event, max_steps=4096,
        )  # fmt: skip

    def last(numbers: Any) -> Any:
        data, now, state = numbers[:3], jax.numpy.asarray(0.0), numbers[3:]
        event = diffrax.Event(reaches, root, direction=True)
        for _ in range(impacts):
            done = flight(now, state, data, event)
            now, before = done.ts[-1], done.ys[-1]
            state = jax.numpy.stack([data[1], -data[2] * before[1]])
        return flight(now, state, data, None).ys[-1, 0]

    compiled, point = jax.jit(jax.grad(last)), jax.numpy.array(POINT)
    return lambda: np.asarray(compiled(point))
