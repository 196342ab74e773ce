"""Look for chaos at random parameters of two masses on a belt: exponents of many motions.

    python scripts/development/search_chaos.py [POINTS]

Prints the points whose largest exponent lies above 0.01 and above three standard errors, those of
the largest first: `nonsmooth certify chaos` takes them. docs/how_to/chaos.md tells what was found.
"""

import argparse
from time import perf_counter

import numpy as np

import nonsmooth as ns
from nonsmooth.runtime.explore.finding.outcomes import stretching
from nonsmooth.runtime.model.kernels import kernels_of

SYSTEM, STATES = "dry-friction", ("x1", "x2", "v1", "v2")
POINTS, CHUNK, SEED = 6000, 200, 1
TRANSITIONS, KEPT = 1500, 64
LEAST, ERRORS = 0.01, 3.0


def drawn(count: int) -> tuple[dict[str, np.ndarray], np.ndarray]:
    """Random parameters by name, and starts."""
    random = np.random.default_rng(SEED)
    us1, us2 = random.uniform(0.2, 2, count), random.uniform(0.2, 2, count)
    points = {
        "chi": random.uniform(0.2, 0.95, count),
        "eta": random.uniform(0.2, 3, count),
        "V": random.uniform(0.05, 1.5, count),
        "us1": us1,
        "us2": us2,
        "ur1": us1 + random.uniform(0.05, 4, count),
        "ur2": us2 + random.uniform(0.05, 4, count),
    }
    places = [random.uniform(-2, 4, count) for _ in range(2)]
    speeds = [points["V"] - random.uniform(0.1, 1, count) for _ in range(2)]
    return points, np.column_stack([*places, *speeds])


def main(count: int) -> None:
    """Follow motions at so many points, and print the chaotic ones."""
    kernels, began = kernels_of(SYSTEM), perf_counter()
    points, starts = drawn(count)
    found = []
    for begin in range(0, count, CHUNK):
        here = {name: values[begin : begin + CHUNK] for name, values in points.items()}
        motions = ns.simulate(
            kernels, here, starts[begin : begin + CHUNK], transitions=TRANSITIONS, keep=KEPT
        )
        scales = np.maximum(np.nanmax(np.abs(motions.last_states), axis=1), 1e-3)
        measured = stretching(kernels, here, motions, scales)
        large = measured.exponents > np.maximum(ERRORS * measured.errors, LEAST)
        for k in np.flatnonzero(large):
            values = {name: float(each[k]) for name, each in here.items()}
            found.append((float(measured.exponents[k]), values, motions.last_states[k, -1]))
    for exponent, values, state in sorted(found, key=lambda entry: -entry[0]):
        told = " ".join(f"{name}={value:.4f}" for name, value in values.items())
        begin = ",".join(
            f"{n}={x:.4f}" for n, x in zip(("x1", "x2", "v1", "v2"), state, strict=True)
        )
        print(f"{exponent:.4f}  {told} --from {begin}")
    print(f"{len(found)} of {count} points in {perf_counter() - began:.0f} s")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("points", nargs="?", type=int, default=POINTS, help="how many are tried")
    main(parser.parse_args().points)
