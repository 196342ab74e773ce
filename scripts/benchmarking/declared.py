"""The section of benchmark.py on systems that a user declares."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from benchmarking.batches import batches
from benchmarking.measuring import Row, interleaved, timed
from benchmarking.simulation import DATA, START

from nonsmooth.derive import Friction, RigidStop, System, chain_matrices, oscillator
from nonsmooth.derive.codegen.emit import emit_system
from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.runtime.model.kernels import SystemKernels, load_system
from nonsmooth.runtime.model.piecewise import PiecewiseLinear, piecewise
from nonsmooth.runtime.simulation.simulate import follow
from nonsmooth.runtime.simulation.starting import configuration_of


def chain() -> tuple[System, Itinerary]:
    """Three masses, the outer ones in front of stops, and a motion that strikes both."""
    mass, stiffness, _ = chain_matrices([1, 1, 1], [1, 1, 1, 1], fixed="both")
    system = oscillator(
        "chain",
        ["x1", "x2", "x3"],
        mass,
        stiffness,
        elements=[RigidStop("x1", 1, 1, name="left"), RigidStop("x3", 1, 1, name="right")],
    )
    phases = [
        ("free-free", "left-reaches-stop", "tau1"),
        ("free-free", "right-reaches-stop", "tau2"),
    ]
    return system, Itinerary("both", system, phases)


def belt(damping: float) -> SystemKernels:
    """The two masses on a belt, declared by a user, with or without damping."""
    values = {name: float(value) for name, value in DATA["A"].items()}
    chi, belt_speed = values["chi"], values["V"]
    return load_system(
        oscillator(
            "belt",
            ["x1", "x2"],
            np.diag([1.0, 1 / values["eta"]]).tolist(),
            [[1, -chi], [-chi, chi]],
            [[damping, 0], [0, damping]],
            elements=[
                Friction(f"x{i}", values[f"us{i}"], values[f"ur{i}"], belt_speed) for i in (1, 2)
            ],
        )
    )


def declared(quick: bool) -> Iterator[Row]:
    """Declaring, deriving and emitting; motions per transition, orbits per point."""

    def emitted() -> object:
        system, orbit = chain()
        return emit_system(system, [orbit], "benchmark")

    yield Row("three-mass chain with two stops: files", timed(emitted, 1, 3), 10.0)
    count = 20_000 if quick else 200_000
    systems = {
        "built in": piecewise("dry-friction", DATA["A"]),
        "declared": piecewise(belt(0), {}),
        "declared, damped": piecewise(belt(1e-3), {}),
    }
    works: dict[str, tuple[Callable[[], object], float]] = {}
    for label, system in systems.items():
        start = configuration_of(system, START)

        def work(system: PiecewiseLinear = system, start: int = start) -> Any:
            return follow(system, START, start, transitions=count)

        works[label] = work, float(len(work().times) - 1)
    found = interleaved(works, 5 if quick else 9)
    for label, seconds in found.items():
        own = label == "built in"
        limit = None if own else 2 * float(np.median(found["built in"]))
        yield Row(label, seconds, limit, None if own else "built in")
    yield from batches(quick)
