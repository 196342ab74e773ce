"""The section of benchmark.py on branches."""

from __future__ import annotations

import statistics
from collections.abc import Iterator

from measuring import Row, timed

import nonsmooth
from nonsmooth.runtime.explore.continuation.continue_event import continue_event

STICK = "dry-friction/global-stick"
DATA = {"chi": "0.5", "eta": 1, "V": 1, "us1": 1, "us2": 1, "ur1": "4.0195", "ur2": "1.4831"}
PHASES = [
    ("stick-stick", "first-breaks-forward"),
    ("slip-stick", "second-breaks-forward"),
    ("slip-slip", "first-reaches-belt"),
    ("stick-slip", "second-reaches-belt"),
]


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
    event = found.events[-1]
    yield Row(
        "itineraries beyond a border collision",
        timed(lambda: found.next_itineraries(event), 1, runs),
    )
    flip = next(event for event in several.events if event.kind == "flip")
    yield Row(
        "a flip in two parameters",
        timed(lambda: continue_event(several, flip, "eta", (3.5, 4.5)), 1, runs),
    )


def main() -> None:
    """Print this section alone."""
    for row in branch(quick=False):
        limit = "" if row.must is None else f"  (at most {row.must} s)"
        print(f"{row.what}: {statistics.median(row.seconds):.3f} s{limit}")


if __name__ == "__main__":
    main()
