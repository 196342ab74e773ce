"""Declared orbits at many points: their own kernels beside tables and beside a peer."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass

import numpy as np
import sympy as sp
from benchmarking.measuring import Row, interleaved, timed

import nonsmooth as ns
from nonsmooth.derive import Harmonic, Parameter, Reference, RigidStop, oscillator
from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.derive.systems import rigid_stop
from nonsmooth.runtime.model.kernels import compiled_for, load_orbit
from nonsmooth.runtime.orbits.solve import declared_kernels

SOLVED, JUDGED, CHARTED = 0.5e-6, 2e-6, 3e-6  # what a point must take on one core


@dataclass(frozen=True)
class Peer:
    """Equations of an orbit for SymPy's lambdify, written by hand: x(parameters) with F = 0."""

    parameters: tuple[sp.Symbol, ...]
    unknowns: tuple[sp.Symbol, ...]
    residual: tuple[sp.Expr, ...]
    guess: tuple[float, ...]

    def newton(self, values: Mapping[str, np.ndarray]) -> Callable[[], np.ndarray]:
        """Vectorised Newton on SymPy's own NumPy code."""
        jacobian = list(sp.Matrix(self.residual).jacobian(self.unknowns))
        function = sp.lambdify(
            [*self.parameters, *self.unknowns], [*self.residual, *jacobian], "numpy", cse=True
        )
        points = [values[str(p)] for p in self.parameters]
        size, count = len(self.unknowns), points[0].size

        def work() -> np.ndarray:
            x = np.repeat(np.array(self.guess)[:, None], count, axis=1)
            for _ in range(20):
                found = np.array([np.broadcast_to(v, (count,)) for v in function(*points, *x)])
                matrices = found[size:].reshape(size, size, count).transpose(2, 0, 1)
                step = np.linalg.solve(matrices, found[:size].T[..., None])[..., 0].T
                x = x - step
                if np.abs(step).max() < 1e-9:
                    break
            return x

        return work


def forced_impact() -> tuple[Itinerary, Peer]:
    """A damped mass under harmonic forcing strikes a stop once in a period (the README's)."""
    zeta = Parameter("zeta", "damping ratio", lower=0, closed=True)
    omega = Parameter("Omega", "frequency of the forcing")
    gap = Parameter("gap", "place of the stop", lower=-sp.oo)
    r = Parameter("r", "restitution", lower=0, upper=1, closed=True, upper_closed=True)
    system = oscillator(
        "forced-impact",
        ["x"],
        mass=[[1]],
        stiffness=[[1]],
        damping=[[2 * zeta.symbol]],
        forcing=[Harmonic(omega.symbol, cosine=[1])],
        elements=[RigidStop("x", at=gap.symbol, restitution=r.symbol, name="stop")],
        parameters=[zeta, omega, gap, r],
    )
    data = Reference({"zeta": "0.05", "Omega": "2", "gap": "0", "r": "0.8"}, {"T": "3.1"})
    orbit = Itinerary("one-impact", system, [("free", "stop-reaches-stop", "T")], reference=data)
    t, speed, phase = sp.symbols("t V phi")
    z, w, g, e = zeta.symbol, omega.symbol, gap.symbol, r.symbol
    lag = (1 - w**2) ** 2 + (2 * z * w) ** 2
    steady = ((1 - w**2) * sp.cos(w * t + phase) + 2 * z * w * sp.sin(w * t + phase)) / lag
    # one mass: x = e^(-zeta t) (a cos nu t + b sin nu t) + steady, from the stop with -r V
    nu = sp.sqrt(1 - z**2)
    a = g - steady.subs(t, 0)
    b = (-e * speed - steady.diff(t).subs(t, 0) + z * a) / nu
    x = sp.exp(-z * t) * (a * sp.cos(nu * t) + b * sp.sin(nu * t)) + steady
    period = 2 * sp.pi / w
    residual = (x.subs(t, period) - g, x.diff(t).subs(t, period) - speed)
    return orbit, Peer((z, w, g, e), (speed, phase), residual, (3.9, -0.3))


def struck() -> Itinerary:
    """The paper's one-impact orbit, handed over as a user's own declaration."""
    return rigid_stop.one_impact


def batches(quick: bool) -> Iterator[Row]:
    """A declared orbit is as fast as the same one that is built in, and against its peers."""
    count = 10_000 if quick else 100_000
    with tempfile.TemporaryDirectory() as folder:
        before = os.environ.get("NONSMOOTH_CACHE")
        os.environ["NONSMOOTH_CACHE"] = folder
        try:
            yield from _same(count)
            yield from _forced(count)
        finally:
            if before is None:
                del os.environ["NONSMOOTH_CACHE"]
            else:
                os.environ["NONSMOOTH_CACHE"] = before


def _same(count: int) -> Iterator[Row]:
    """Rows for one orbit, declared by a user and built in."""
    built_in = load_orbit("rigid-stop/one-impact")
    declared = compiled_for(load_orbit(struck()), float("inf"), at_once=True)
    values = {"k1": np.linspace(1.9, 2.1, count)}
    for admissibility in (False, True):
        label = "with admissibility" if admissibility else "without"
        works = {
            f"{name}, {label}": (
                lambda o=orbit, a=admissibility: ns.solve(o, values, threads=1, admissibility=a),
                float(count),
            )
            for name, orbit in (("one impact, built in", built_in), ("declared", declared))
        }
        first, second = (Row(name, found) for name, found in interleaved(works, 7).items())
        yield first
        yield Row(second.what, second.seconds, 1.1 * first.median, first.what)


def _forced(count: int) -> Iterator[Row]:
    """Rows for the README's oscillator, whose equations no built-in orbit has."""
    orbit, peer = forced_impact()
    kernels = load_orbit(orbit)
    compiled = declared_kernels(kernels) is not None
    way = "kernels" if compiled else "composed from tables"
    values = {"Omega": np.linspace(1.9, 2.1, count), "gap": np.zeros(count)}
    ours = f"forced impact, {way}"
    for admissibility, must in ((False, SOLVED), (True, JUDGED)):
        few = values if compiled else {n: v[:: count // 100] for n, v in values.items()}

        def work(
            few: Mapping[str, np.ndarray] = few, admissibility: bool = admissibility
        ) -> object:
            return ns.solve(kernels, few, threads=1, admissibility=admissibility)

        label = f"{ours}, with admissibility" if admissibility else ours
        yield Row(label, timed(work, len(few["gap"])), must)
    side = 300 if compiled else 10
    axes = {"Omega": np.linspace(1.9, 2.1, side), "r": np.linspace(0.7, 0.9, side)}
    chart = timed(lambda: ns.chart(kernels.name, threads=1, **axes), side**2, 3)
    yield Row(f"forced impact, chart, {way}", chart, CHARTED)
    # the same from the system's tables
    system, phases = load_orbit(orbit).system, [("free", "stop-reaches-stop")]
    known = ns.solve(system, peer_point(values, 0), [np.pi, 0, -3.1, 0.3, -0.9], itinerary=phases)
    near = [*known.dwell_times, *known.states[0]]
    few = {n: v[:: count // 100] for n, v in peer_values(values).items()}

    for told in ("", ", with admissibility"):

        def composed(admissibility: bool = bool(told)) -> object:
            return ns.solve(
                system, few, near, itinerary=phases, threads=1, admissibility=admissibility
            )

        seconds = timed(composed, len(few["gap"]))
        yield Row(f"forced impact, tables{told}", seconds, against=f"{ours}{told}")
    lambdified = peer.newton(peer_values(values))
    yield Row("forced impact, lambdify(cse), NumPy Newton", timed(lambdified, count, 3),
              against=ours)  # fmt: skip


def peer_values(values: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
    """All parameters of the forced oscillator at the points."""
    count = len(values["gap"])
    return {"zeta": np.full(count, 0.05), "r": np.full(count, 0.8), **values}


def peer_point(values: Mapping[str, np.ndarray], place: int) -> dict[str, float]:
    """All parameters of the forced oscillator at one point."""
    return {name: float(row[place]) for name, row in peer_values(values).items()}
