"""The sections of benchmark.py on certificates and counted orbits, at the paper's data."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from pathlib import Path

from benchmarking.measuring import Row, timed

from nonsmooth.runtime.explore.continuation.continue_orbit import continue_orbit
from nonsmooth.runtime.orbits.solve import solve
from nonsmooth.runtime.present.check_file import check_certificate
from nonsmooth.runtime.proof.boxes.box_certificate import BoxCertificate
from nonsmooth.runtime.proof.boxes.certify_box import certify_box
from nonsmooth.runtime.proof.branch.certify_event import certify_event
from nonsmooth.runtime.proof.certify_all import certify_all
from nonsmooth.runtime.proof.certify_orbit import certify

ORBIT = "dry-friction/global-stick"
BITS = 100
DIGITS = 1000


def certified(quick: bool) -> Iterator[Row]:
    """Whole certificates, and their check."""
    orbit = solve(ORBIT)
    assert orbit.admissibility.verdict
    runs = 7 if quick else 21

    many = round(DIGITS * 3.3219) + 8
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "certificate.json"
        certify(orbit, BITS).save(path)
        whole = f"whole certificate, {BITS} bits"
        yield Row(whole, timed(lambda: certify(orbit, BITS), runs=runs), 0.050)
        yield Row(
            "  its check, from the file",
            timed(lambda: check_certificate(path), runs=runs),
            against=whole,
        )
        certify(orbit, many).save(path)
        whole = f"whole certificate, {DIGITS} digits"
        yield Row(whole, timed(lambda: certify(orbit, many), runs=runs), 0.200)
        yield Row(
            "  the check of that",
            timed(lambda: check_certificate(path), runs=runs),
            against=whole,
        )


def boxed(quick: bool) -> Iterator[Row]:
    """Boxes of parameters around the paper's data, and an event to 30 and 300 digits."""
    orbit = solve(ORBIT)
    runs = 3 if quick else 7

    def around(low: str, high: str) -> BoxCertificate:
        found = certify_box(orbit, {"V": (low, high), "eta": (low, high)})
        assert found.proved
        return found

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "map.json"
        for size, ends, must in (("1 %", ("0.99", "1.01"), 2), ("10 %", ("0.9", "1.1"), 60)):
            whole = f"V and eta within {size}, proved whole"
            yield Row(whole, timed(lambda ends=ends: around(*ends), 1, runs), must)
            around(*ends).save(path)
            checked = timed(lambda: check_certificate(path), 1, runs)
            yield Row("  its check, from the file", checked, against=whole)
    branch = continue_orbit(solve("dry-friction/symmetric"), "V", (0.6, 1.3))
    (flip,) = [event for event in branch.events if event.kind == "flip"]
    for bits in (100, 1000):
        told = f"a flip enclosed, {bits} bits"
        yield Row(told, timed(lambda bits=bits: certify_event(branch, flip, bits), 1, runs))


def counted(quick: bool) -> Iterator[Row]:
    """All orbits of an itinerary in a box, each certified, nothing undecided."""
    runs = 3 if quick else 5

    def reduced() -> None:
        census = certify_all(ORBIT, box={"tau": (0, "12.6"), "tau1": (0, 20)})
        assert census.decided
        assert (census.count, census.admissible) == (6, 1)

    def dwell() -> None:
        box = {"tau": 6, "tau1": 6}
        assert certify_all("dry-friction/symmetric", {"us2": 1}, box).decided

    yield Row("global stick, tau to 12.6, tau1 to 20", timed(reduced, 1, runs), 5.0)
    yield Row("slip-slip, slip-stick, dwell times to 6", timed(dwell, 1, runs))
