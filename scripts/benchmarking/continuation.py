"""The section of benchmark.py on branches."""

from __future__ import annotations

import statistics
from collections.abc import Iterator

import sympy as sp
from benchmarking.measuring import Row, timed

import nonsmooth
from nonsmooth.derive import Harmonic, RigidStop, System, chain_matrices, oscillator
from nonsmooth.runtime.model.kernels import load_system

STICK = "dry-friction/global-stick"
DATA = {"chi": "0.5", "eta": 1, "V": 1, "us1": 1, "us2": 1, "ur1": "4.0195", "ur2": "1.4831"}
PHASES = [
    ("stick-stick", "first-breaks-forward"),
    ("slip-stick", "second-breaks-forward"),
    ("slip-slip", "first-reaches-belt"),
    ("stick-slip", "second-reaches-belt"),
]


def forced_chain(count: int) -> System:
    """Masses between two walls, the first one forced, the last in front of a rigid stop."""
    mass, stiffness, _ = chain_matrices([1] * count, [1] * (count + 1), fixed="both")
    damping = (sp.Matrix(stiffness) + sp.eye(count)) / 50
    return oscillator(
        f"chain-{count}",
        [f"x{k}" for k in range(1, count + 1)],
        mass,
        stiffness,
        damping.tolist(),
        forcing=[Harmonic(sp.Symbol("Omega"), cosine=[1] + [0] * (count - 1))],
        elements=[RigidStop(f"x{count}", at="1/2", restitution="4/5", name="stop")],
    )


def chains(quick: bool) -> Iterator[Row]:
    """Branches of chains over the frequency of their forcing, with all events."""
    for count, must in ((1, 0.2), (3, 1.0), (7, 3.0)):
        kernels = load_system(forced_chain(count))
        found = nonsmooth.find_orbits(kernels, {"Omega": "0.7"}, 40, transitions=400, rng=1)
        orbit = found.orbits[0].orbit
        branch = nonsmooth.continue_orbit(orbit, "Omega", (0.65, 0.75))
        yield Row(
            f"{count} forced masses with a stop: {len(branch)} points, {len(branch.events)} events",
            timed(
                lambda orbit=orbit: nonsmooth.continue_orbit(orbit, "Omega", (0.65, 0.75)),
                1,
                2 if quick else 5,
            ),
            must,
        )


def branch(quick: bool) -> Iterator[Row]:
    """Branches with all detections, and the itineraries beyond a border collision."""
    runs = 3 if quick else 9
    orbit = nonsmooth.solve(STICK)
    found = nonsmooth.continue_orbit(orbit, "V", (0.8, 1.3), step=0.007)
    yield Row(
        f"global-stick: a branch of {len(found)} points",
        timed(lambda: nonsmooth.continue_orbit(orbit, "V", (0.8, 1.3), step=0.007), 1, runs),
        0.5,
    )
    symmetric = nonsmooth.solve("dry-friction/symmetric")
    several = nonsmooth.continue_orbit(symmetric, "V", (0.3, 1.3))
    yield Row(
        f"symmetric: {len(several)} points and {len(several.events)} events",
        timed(lambda: nonsmooth.continue_orbit(symmetric, "V", (0.3, 1.3)), 1, runs),
    )
    composed = nonsmooth.solve("dry-friction", DATA, [1, 2, 1.5, 3.3], itinerary=PHASES)
    same = nonsmooth.continue_orbit(composed, "V", (0.8, 1.3))
    yield Row(
        f"global-stick composed: {len(same)} points",
        timed(lambda: nonsmooth.continue_orbit(composed, "V", (0.8, 1.3)), 1, runs),
    )
    yield from chains(quick)
    event = found.events[-1]
    yield Row(
        "itineraries beyond a border collision",
        timed(lambda: found.next_itineraries(event), 1, runs),
    )
    flip = next(event for event in several.events if event.kind == "flip")
    yield Row(
        "a flip in two parameters",
        timed(lambda: nonsmooth.continue_orbit(several, "eta", (3.5, 4.5), event=flip), 1, runs),
    )


def main() -> None:
    """Print this section alone."""
    for row in branch(quick=False):
        limit = "" if row.must is None else f"  (at most {row.must} s)"
        print(f"{row.what}: {statistics.median(row.seconds):.3f} s{limit}")


if __name__ == "__main__":
    main()
